//! Vectors in expressions: components with one dimension, in the axes of one frame.

use super::quantity::{Nature, Typed, Vector, Wanted, bare_literal, hertz, is_bare_zero};
use super::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Check, fold, say};
use crate::joints::algebra;
use crate::model::{self, Binary, FrameId};
use crate::parse::tree::{Call, Expr, ExprKind, UnitText};
use crate::suggest;
use crate::units::Dimension;

/// A vector and what it is.
#[derive(Clone, Debug)]
pub struct Vectorial {
    /// Components in SI.
    pub values: [model::Expr; 3],
    /// Those that are not zero in every motion.
    pub axes: Vec<usize>,
    /// Their dimension.
    pub dimension: Dimension,
    /// How it was written.
    pub nature: Nature,
    /// The axes of its components; `None`: of any frame.
    pub frame: Option<FrameId>,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// A number.
    Scalar(Typed),
    /// A vector.
    Vector(Vectorial),
}

impl Vectorial {
    fn describe(&self) -> String {
        self.dimension.describe(self.nature.angle)
    }

    /// One component.
    pub fn component(&self, axis: usize) -> Typed {
        Typed {
            value: self.values[axis].clone(),
            dimension: self.dimension,
            nature: self.nature,
        }
    }

    /// Names of its axes in a sentence.
    pub fn axis_list(&self) -> String {
        let axes: Vec<&str> = self.axes.iter().map(|axis| AXES[*axis]).collect();
        suggest::list(&axes)
    }

    fn map(self, of: impl Fn(model::Expr) -> model::Expr) -> Self {
        Self {
            values: self.values.map(of),
            ..self
        }
    }
}

/// Functions of vectors, and their number of arguments.
const FUNCTIONS: &[(&str, usize)] = &[("dot", 2), ("cross", 2), ("norm", 1)];

/// Whether a name is that of a function of vectors.
pub fn is_function(name: &str) -> bool {
    FUNCTIONS.iter().any(|(word, _)| *word == name)
}

impl<'a> Check<'a> {
    /// Resolves an expression that may be a vector; `None` where something in it has been reported.
    pub(in crate::check) fn value(&mut self, expr: &'a Expr, scope: Scope) -> Option<Quantity> {
        if scope < Scope::Constraint && !expr.has_vector() {
            return self.expr(expr, scope).map(Quantity::Scalar);
        }
        self.nested(expr, |check| match &expr.kind {
            ExprKind::Vector { .. } if check.split_vector(expr) => None,
            ExprKind::Vector { components, unit } => check
                .literal(expr, components, unit.as_ref(), scope)
                .map(Quantity::Vector),
            ExprKind::Negate(inner) => match check.value(inner, scope)? {
                Quantity::Scalar(typed) => Some(Quantity::Scalar(Typed {
                    value: model::Expr::Negate(Box::new(typed.value)),
                    ..typed
                })),
                Quantity::Vector(vector) => Some(Quantity::Vector(vector.map(algebra::negate))),
            },
            ExprKind::Binary(operator, left, right) => check.operation(*operator, left, right, scope),
            ExprKind::Call(call) if is_function(&call.name.text) => check.vector_function(call, scope),
            ExprKind::Member { .. } => match check.column(expr, scope) {
                Some(column) => column.map(Quantity::Scalar),
                None => check.observe(expr, scope),
            },
            ExprKind::Name(name) if check.particle.contains_key(name.text.as_str()) => {
                Some(Quantity::Vector(check.particle[name.text.as_str()].clone()))
            }
            ExprKind::Name(name) if check.is_frame(&name.text) => check.observe(expr, scope),
            _ => check.expr(expr, scope).map(Quantity::Scalar),
        })
    }

    /// A quantity where a number is needed.
    pub(in crate::check) fn scalar(&mut self, expr: &Expr, quantity: Quantity) -> Option<Typed> {
        match quantity {
            Quantity::Scalar(typed) => Some(typed),
            Quantity::Vector(vector) => {
                let message = match expr.kind {
                    ExprKind::Vector { .. } => say::VECTOR_IN_EXPRESSION.into(),
                    _ => say::vector_as_number(&vector.axis_list()),
                };
                self.errors.at(expr.area, message);
                None
            }
        }
    }

    /// A vector where one is needed.
    pub(in crate::check) fn vectorial(&mut self, expr: &'a Expr, scope: Scope, what: &str) -> Option<Vectorial> {
        match self.value(expr, scope)? {
            Quantity::Vector(vector) => Some(vector),
            Quantity::Scalar(_) => {
                self.errors.at(expr.area, say::number_as_vector(what));
                None
            }
        }
    }

    /// Two operands, each a number or a vector.
    pub(in crate::check) fn operation(
        &mut self,
        operator: Binary,
        left: &'a Expr,
        right: &'a Expr,
        scope: Scope,
    ) -> Option<Quantity> {
        if let Some((area, message)) = self.split_unit(operator, left, right) {
            self.errors.at(area, message);
            return None;
        }
        let (a, b) = (self.value(left, scope), self.value(right, scope));
        let is_sum = matches!(operator, Binary::Add | Binary::Subtract);
        match (a?, b?) {
            (Quantity::Scalar(a), Quantity::Scalar(b)) => {
                self.combine(operator, (left, a), (right, b)).map(Quantity::Scalar)
            }
            (Quantity::Vector(a), Quantity::Vector(b)) if is_sum => {
                self.sum(operator, (left, a), (right, b)).map(Quantity::Vector)
            }
            (Quantity::Vector(a), Quantity::Scalar(b)) if !is_sum => {
                self.scaled(operator, (left, a), (right, b)).map(Quantity::Vector)
            }
            (Quantity::Scalar(a), Quantity::Vector(b)) if operator == Binary::Multiply => {
                self.scaled(operator, (right, b), (left, a)).map(Quantity::Vector)
            }
            (Quantity::Vector(_), Quantity::Vector(_)) if operator == Binary::Multiply => {
                self.errors.at(left.area.to(right.area), say::PRODUCT_OF_VECTORS);
                None
            }
            (_, Quantity::Vector(_)) if operator == Binary::Divide => {
                self.errors.at(right.area, say::DIVISION_BY_VECTOR);
                None
            }
            (Quantity::Vector(vector), _) => self.scalar(left, Quantity::Vector(vector)).map(Quantity::Scalar),
            (_, vector) => self.scalar(right, vector).map(Quantity::Scalar),
        }
    }

    fn sum(
        &mut self,
        operator: Binary,
        (left, a): (&Expr, Vectorial),
        (right, b): (&Expr, Vectorial),
    ) -> Option<Vectorial> {
        if a.dimension != b.dimension {
            self.errors.at(right.area, say::unlike(&b.describe(), &a.describe()));
            return None;
        }
        self.same_turns((left, a.nature), (right, b.nature))?;
        let frame = self.same_axes(&a, &b, left, right)?;
        let nature = a.nature.plus(b.nature);
        let of = if operator == Binary::Add {
            algebra::add
        } else {
            algebra::subtract
        };
        let values = algebra::both(&a.values, &b.values, of);
        Some(Vectorial {
            axes: moving(&values, a.axes, &b.axes),
            values,
            dimension: a.dimension,
            nature,
            frame,
        })
    }

    fn scaled(
        &mut self,
        operator: Binary,
        (vector_expr, vector): (&Expr, Vectorial),
        (scalar_expr, scalar): (&Expr, Typed),
    ) -> Option<Vectorial> {
        let measure = vector.component(0);
        let whole = self.combine(operator, (vector_expr, measure), (scalar_expr, scalar.clone()))?;
        let vector = vector.map(|component| {
            if operator == Binary::Multiply {
                algebra::multiply(scalar.value.clone(), component)
            } else {
                algebra::divide(component, scalar.value.clone())
            }
        });
        Some(Vectorial {
            dimension: whole.dimension,
            nature: whole.nature,
            ..vector
        })
    }

    /// The axes of two vectors that are combined; different ones are refused.
    fn same_axes(&mut self, a: &Vectorial, b: &Vectorial, left: &Expr, right: &Expr) -> Option<Option<FrameId>> {
        match (a.frame, b.frame) {
            (Some(first), Some(second)) if first != second => {
                let [first, second] = [first, second].map(|frame| self.model.frames[frame.0].name.clone());
                self.errors
                    .at(left.area.to(right.area), say::different_axes(&first, &second));
                None
            }
            (first, second) => Some(first.or(second)),
        }
    }

    /// `[a, b, c] unit`
    fn literal(
        &mut self,
        expr: &'a Expr,
        components: &'a [Expr],
        unit: Option<&'a UnitText>,
        scope: Scope,
    ) -> Option<Vectorial> {
        let typed: Vec<Option<Typed>> = match unit {
            Some(unit) => {
                let unit = (self.unit(unit)?, hertz(unit));
                let parts = components.iter().map(|part| self.with_unit(part, unit, scope));
                parts.collect()
            }
            None => components.iter().map(|part| self.expr(part, scope)).collect(),
        };
        let typed = typed.into_iter().collect::<Option<Vec<_>>>()?;
        let first = typed
            .iter()
            .zip(components)
            .find(|(_, part)| !is_bare_zero(part))
            .map_or(&typed[0], |(typed, _)| typed)
            .clone();
        for (part, typed) in components.iter().zip(&typed) {
            if typed.dimension != first.dimension && !is_bare_zero(part) {
                self.errors
                    .at(part.area, say::unlike(&typed.describe(), &first.describe()));
                return None;
            }
        }
        let nature = typed.iter().fold(first.nature, |all, typed| all.plus(typed.nature));
        let values: Vec<model::Expr> = typed.into_iter().map(|typed| typed.value).collect();
        let Ok(values) = values.try_into() else {
            self.errors.at(expr.area, say::THREE_COMPONENTS);
            return None;
        };
        Some(Vectorial {
            values,
            axes: vec![0, 1, 2],
            dimension: first.dimension,
            nature,
            frame: None,
        })
    }

    /// `dot`, `cross` or `norm`.
    pub(in crate::check) fn vector_function(&mut self, call: &'a Call, scope: Scope) -> Option<Quantity> {
        let name = call.name.text.as_str();
        if let Some(named) = call.arguments.iter().find_map(|argument| argument.name.as_ref()) {
            self.errors.at(named.span, say::named_argument(name));
            return None;
        }
        let arity = FUNCTIONS
            .iter()
            .find(|(word, _)| *word == name)
            .map(|(_, arity)| *arity)?;
        if call.arguments.len() != arity {
            let message = say::arity(name, &arity.to_string(), &call.arguments.len().to_string());
            self.errors.at(call.area, message);
            return None;
        }
        let arguments: Vec<Option<Vectorial>> = call
            .arguments
            .iter()
            .map(|argument| self.vectorial(&argument.value, scope, name))
            .collect();
        let arguments = arguments.into_iter().collect::<Option<Vec<_>>>()?;
        let a = &arguments[0];
        let Some(b) = arguments.get(1) else {
            return Some(Quantity::Scalar(Typed {
                value: algebra::norm(&a.values),
                dimension: a.dimension,
                nature: a.nature,
            }));
        };
        let frame = self.same_axes(a, b, &call.arguments[0].value, &call.arguments[1].value)?;
        let Some(dimension) = a.dimension.multiply(b.dimension) else {
            self.errors.at(call.area, say::EXPONENT_RANGE);
            return None;
        };
        let nature = a.nature.times(b.nature);
        if name == "dot" {
            return Some(Quantity::Scalar(Typed {
                value: algebra::dot(&a.values, &b.values),
                dimension,
                nature,
            }));
        }
        let values = algebra::cross(&a.values, &b.values);
        Some(Quantity::Vector(Vectorial {
            axes: moving(&values, vec![0, 1, 2], &[]),
            values,
            dimension,
            nature,
            frame,
        }))
    }

    /// A vector of params and time: written out, or made of such ones.
    pub(in crate::check) fn vector_of_time(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Vector> {
        if matches!(expr.kind, ExprKind::Vector { .. }) {
            return self.vector(expr, Scope::Prescribed, wanted);
        }
        if self.observes(expr) {
            self.errors.at(expr.area, say::vector_wanted(wanted.what, wanted.unit));
            return None;
        }
        let vector = self.wanted_vector(expr, Scope::Force, wanted)?;
        Some(Vector {
            values: vector.values,
            areas: [expr.area; 3],
            area: expr.area,
        })
    }

    /// A vector of the dimension that is wanted, as an expression gives it.
    pub(in crate::check) fn wanted_vector(
        &mut self,
        expr: &'a Expr,
        scope: Scope,
        wanted: Wanted,
    ) -> Option<Vectorial> {
        let Quantity::Vector(vector) = self.value(expr, scope)? else {
            self.errors.at(expr.area, say::vector_wanted(wanted.what, wanted.unit));
            return None;
        };
        self.is_wanted_vector(expr, &vector, wanted).then_some(vector)
    }

    /// A vector of angular velocities: hertz is refused.
    pub(in crate::check) fn rates(&mut self, expr: &'a Expr, scope: Scope, wanted: Wanted) -> Option<Vector> {
        let vector = self.vector(expr, scope, wanted)?;
        let ExprKind::Vector { components, unit } = &expr.kind else {
            let counts = |found: Quantity| matches!(found, Quantity::Vector(found) if found.nature.counts_cycles());
            let is_hertz = self.value(expr, scope).is_some_and(counts);
            return self.is_told_in_angles(expr.area, is_hertz).then_some(vector);
        };
        let mut is_rate = unit
            .as_ref()
            .is_none_or(|unit| self.is_told_in_angles(unit.area, hertz(unit) > 0));
        for component in components {
            is_rate &= self.is_no_frequency(component, scope);
        }
        is_rate.then_some(vector)
    }

    /// The text of a literal without unit stands for a vector's unit, too.
    fn is_wanted_vector(&mut self, expr: &Expr, vector: &Vectorial, wanted: Wanted) -> bool {
        let dimension = Dimension::of(wanted.dimension);
        let is_wanted = vector.dimension == dimension;
        if !is_wanted {
            let kind = dimension.describe(wanted.dimension[5] != 0);
            let message = match bare_literal(expr) {
                Some(text) => say::no_unit(wanted.what, &kind, &text, wanted.unit),
                None => say::wrong_dimension(wanted.what, &kind, &vector.describe()),
            };
            self.errors.at(expr.area, message);
        }
        is_wanted
    }
}

/// The axes of either operand along which the result is not known to be zero; all where it is zero.
fn moving(values: &[model::Expr; 3], a: Vec<usize>, b: &[usize]) -> Vec<usize> {
    let mut axes = a;
    axes.extend(b);
    axes.sort_unstable();
    axes.dedup();
    // In a plane the order is its right-handed one.
    let moving: Vec<usize> = axes
        .iter()
        .copied()
        .filter(|axis| fold::constant(&values[*axis]) != Some(0.0))
        .collect();
    match moving[..] {
        [] => axes,
        [0, 2] => vec![2, 0],
        _ => moving,
    }
}
