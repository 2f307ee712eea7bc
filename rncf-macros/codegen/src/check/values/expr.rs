//! Expressions: names, dimensions, functions.

use super::quantity::{self, Nature, Typed, bare_literal, behind_number, hertz};
use super::scope::Scope;
use super::vector::{Quantity, is_function};
use crate::check::{Check, fold, say};
use crate::model::{self, Binary, Function, ParamId};
use crate::parse::ascii;
use crate::parse::tree::{Call, Expr, ExprKind, If, Keyword, Name};
use crate::suggest;
use crate::units::{self, Compound, Dimension, Fraction};

/// Functions of the language.
#[rustfmt::skip]
const FUNCTIONS: &[(&str, Function, usize)] = &[
    ("sin", Function::Sin, 1), ("cos", Function::Cos, 1), ("tan", Function::Tan, 1),
    ("asin", Function::Asin, 1), ("acos", Function::Acos, 1), ("atan", Function::Atan, 1),
    ("sinh", Function::Sinh, 1), ("cosh", Function::Cosh, 1), ("tanh", Function::Tanh, 1),
    ("exp", Function::Exp, 1), ("ln", Function::Ln, 1), ("sqrt", Function::Sqrt, 1),
    ("abs", Function::Abs, 1), ("min", Function::Min, 2), ("max", Function::Max, 2), ("atan2", Function::Atan2, 2),
];

/// The function with this name and its number of arguments.
pub fn function(name: &str) -> Option<(Function, usize)> {
    FUNCTIONS
        .iter()
        .find(|(word, ..)| *word == name)
        .map(|(_, function, arity)| (*function, *arity))
}

/// What can be asked of a thing, where a number is needed.
fn example(keyword: Keyword) -> Option<&'static str> {
    match keyword {
        Keyword::Body => Some("end.x"),
        Keyword::Joint => Some("force.x"),
        Keyword::Constraint => Some("multiplier"),
        Keyword::Rigid | Keyword::Frame => Some("x"),
        _ => None,
    }
}

/// Most expressions inside each other, those of the names that they use included: recursion stays
/// far from the stack's end.
const DEEPEST: usize = 400;

/// What the argument of a motion must be.
const TIME: quantity::Wanted = quantity::Wanted {
    what: "the argument of a motion",
    dimension: [0, 0, 1, 0, 0, 0],
    unit: "s",
};

/// What stands for a sign: conditions must not depend on the state.
const SIGN: &str = "tanh(x / small)`, or of the time `if t < 1 s { -1 } else { 1 }";
/// Names that functions have elsewhere.
const OTHER_NAMES: [(&str, &str); 10] = [
    ("log", "ln"),
    ("log10", "ln(x) / ln(10)"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("fabs", "abs"),
    ("pow", "x^n"),
    ("sign", SIGN),
    ("sgn", SIGN),
];

/// What is said of a name, and where it is written like a unit how that is told from it.
fn or_unit(message: String, name: &str) -> String {
    match units::find(name) {
        Some(_) => say::or_unit(&message, name),
        None => message,
    }
}

impl<'a> Check<'a> {
    /// Resolves an expression; `None` where something in it has been reported.
    pub(in crate::check) fn expr(&mut self, expr: &'a Expr, scope: Scope) -> Option<Typed> {
        self.nested(expr, |check| check.node(expr, scope))
    }

    /// Resolves what stands inside of something else; too deep is refused.
    pub(in crate::check) fn nested<T>(
        &mut self,
        expr: &Expr,
        resolve: impl FnOnce(&mut Self) -> Option<T>,
    ) -> Option<T> {
        if self.depth > DEEPEST {
            self.errors.at(expr.area, say::TOO_DEEP);
            return None;
        }
        self.depth += 1;
        let result = resolve(self);
        self.depth -= 1;
        result
    }

    fn node(&mut self, expr: &'a Expr, scope: Scope) -> Option<Typed> {
        match &expr.kind {
            ExprKind::Number { text, unit } => {
                let compound = unit.as_ref().map_or(Some(Compound::ONE), |unit| self.unit(unit))?;
                let value = self.number(text, compound, expr.area)?;
                let nature = Nature {
                    hertz: unit.as_ref().map_or(0, hertz),
                    ..Nature::of_unit(compound.dimension[5])
                };
                let dimension = Dimension::of(compound.dimension);
                Some(Typed {
                    value: model::Expr::Number(value),
                    dimension,
                    nature,
                })
            }
            ExprKind::Name(name) => self.name(name, scope),
            ExprKind::Member { .. } => match self
                .of_element(expr)
                .or_else(|| self.strain(expr))
                .or_else(|| self.column(expr, scope))
            {
                Some(found) => found,
                None => self.member(expr, scope),
            },
            ExprKind::Call(call) => self.call(call, scope),
            ExprKind::Negate(inner) => {
                let inner = self.expr(inner, scope)?;
                Some(Typed {
                    value: model::Expr::Negate(Box::new(inner.value)),
                    ..inner
                })
            }
            ExprKind::Binary(operator, left, right) => {
                let quantity = self.operation(*operator, left, right, scope)?;
                self.scalar(expr, quantity)
            }
            ExprKind::Power(base, exponent) => self.power(base, exponent, scope),
            ExprKind::Reduced(reduced) => self.reduced(expr, reduced, scope),
            ExprKind::Remainder(..) => {
                self.errors.at(expr.area, say::REMAINDER_OUTSIDE);
                None
            }
            ExprKind::Indexed { base, index } => {
                self.lone_indexed(base, index);
                None
            }
            ExprKind::Index(number) => Some(Typed::new(model::Expr::Number(*number as f64), Dimension::NONE)),
            // What is left of these has been reported.
            ExprKind::Numbered { .. } | ExprKind::Applied { .. } => None,
            ExprKind::If(inner) => self.conditional(inner, scope),
            ExprKind::Vector { .. } => {
                self.errors.at(expr.area, say::VECTOR_IN_EXPRESSION);
                None
            }
        }
    }

    fn name(&mut self, name: &'a Name, scope: Scope) -> Option<Typed> {
        let text = name.text.as_str();
        if let Some(local) = self.locals.get(text) {
            return Some(local.clone());
        }
        if self.is_field_as_number(name) {
            return None;
        }
        if let Some(vector) = self.particle.get(text) {
            let message = say::vector_as_number(&vector.axis_list());
            self.errors.at(name.span, message);
            return None;
        }
        if let Some(index) = self.index(name, scope) {
            return index;
        }
        if text == "pi" {
            let nature = Nature {
                angle: true,
                pi: 1,
                ..Nature::default()
            };
            let value = model::Expr::Number(std::f64::consts::PI);
            return Some(Typed {
                value,
                dimension: Dimension::NONE,
                nature,
            });
        }
        if text == "t" {
            if scope >= Scope::Prescribed {
                return Some(Typed::new(model::Expr::Time, Dimension::of([0, 0, 1, 0, 0, 0])));
            }
            self.errors.at(name.span, say::NO_TIME);
            return None;
        }
        let Some(item) = self.names.get(text).copied() else {
            if !self.has_lost_index() && self.is_news(text) {
                let message = self.unknown_value(text);
                self.errors.at(name.span, message);
            }
            return None;
        };
        match item.keyword {
            Keyword::Const => self.constant(item, name),
            Keyword::Let => self.derived(item, name, scope),
            Keyword::Param if scope == Scope::Constant => {
                self.errors.at(name.span, or_unit(say::param_in_constant(text), text));
                None
            }
            Keyword::Param => self.values.get(text).cloned().flatten(),
            Keyword::State => self.state_value(name, scope),
            Keyword::Motion => {
                self.errors.at(name.span, or_unit(say::motion_without_time(text), text));
                None
            }
            _ if Self::is_broken(item) => None,
            keyword if scope >= Scope::Constraint && example(keyword).is_some() => {
                let message = say::whole_thing(text, &say::a(keyword.noun()), example(keyword).unwrap_or_default());
                self.errors.at(name.span, or_unit(message, text));
                None
            }
            keyword => {
                let message = say::not_a_value(text, &say::a(keyword.word()));
                self.errors.at(name.span, or_unit(message, text));
                None
            }
        }
    }

    fn unknown_value(&self, text: &str) -> String {
        if let Some(plain) = ascii::suggestion(text) {
            return say::not_ascii(text, &plain);
        }
        if let Some(message) = self.index_elsewhere(text) {
            return message;
        }
        if text == "E" && self.locals.contains_key("E.xx") {
            return say::WHOLE_STRAIN.into();
        }
        if function(text).is_some() {
            return say::function_without_argument(text);
        }
        if text == "x" {
            return say::ARCLENGTH_ELSEWHERE.into();
        }
        if units::find(text).is_some() {
            return say::stray_unit(text);
        }
        if self.items(Keyword::Output).iter().any(|item| item.name.text == *text) {
            return say::output_read(text);
        }
        let mut known = self.known(&[Keyword::Param, Keyword::Const, Keyword::Let, Keyword::Motion]);
        known.extend(["pi", "t"]);
        // What has a meaning here alone: the length of a spring, the arclength.
        let mut own: Vec<&str> = self.locals.keys().copied().collect();
        own.retain(|name| !name.contains('.') && !known.contains(name));
        own.sort_unstable();
        known.extend(own);
        suggest::unknown("name", text, known)
    }

    /// A reference to a parameter.
    pub(in crate::check) fn reference(id: ParamId, dimension: [i8; 6], nature: Nature) -> Typed {
        let Nature { angle, turns, .. } = Nature::of_unit(dimension[5]);
        let nature = Nature { angle, turns, ..nature };
        Typed {
            value: model::Expr::Param(id),
            dimension: Dimension::of(dimension),
            nature,
        }
    }

    fn call(&mut self, call: &'a Call, scope: Scope) -> Option<Typed> {
        let name = call.name.text.as_str();
        if let Some(named) = call.arguments.iter().find_map(|argument| argument.name.as_ref()) {
            self.errors.at(named.span, say::named_argument(name));
            return None;
        }
        if let Some(product) = self.field_product(call) {
            return product;
        }
        if scope >= Scope::Constraint && is_function(name) {
            let quantity = self.vector_function(call, scope)?;
            return match quantity {
                Quantity::Scalar(typed) => Some(typed),
                Quantity::Vector(vector) => {
                    self.errors.at(call.area, say::vector_as_number(&vector.axis_list()));
                    None
                }
            };
        }
        if let Some((function, arity)) = function(name) {
            return self.function(call, function, arity, scope);
        }
        let Some(item) = self.names.get(name).copied() else {
            if matches!(name, "sum" | "mean") {
                self.errors.at(call.area, say::reduction_without_loop(name));
            } else if self.is_news(name) {
                let known = FUNCTIONS
                    .iter()
                    .map(|(word, ..)| *word)
                    .chain(self.known(&[Keyword::Motion]));
                let message = match OTHER_NAMES.iter().find(|(other, _)| *other == name) {
                    Some((other, own)) => say::function_near(other, own),
                    None => suggest::unknown("function", name, known.collect::<Vec<_>>()),
                };
                self.errors.at(call.name.span, message);
            }
            return None;
        };
        if item.keyword != Keyword::Motion {
            self.errors
                .at(call.name.span, say::not_a_function(name, &say::a(item.keyword.word())));
            return None;
        }
        let [argument] = call.arguments.as_slice() else {
            self.errors
                .at(call.area, say::arity(name, "1", &call.arguments.len().to_string()));
            return None;
        };
        let at = self.expr(&argument.value, scope);
        let (id, motion) = self.motion(item, call.name.span.into())?;
        let at = at?;
        let is_time = self.is_wanted(&argument.value, &at, TIME);
        is_time.then(|| Typed {
            value: model::Expr::Motion(id, Box::new(at.value)),
            ..motion
        })
    }

    fn function(&mut self, call: &'a Call, function: Function, arity: usize, scope: Scope) -> Option<Typed> {
        let name = call.name.text.as_str();
        let has_kink = matches!(
            function,
            Function::Abs | Function::Min | Function::Max | Function::Atan2
        );
        if has_kink && (Scope::Parameter..=Scope::Constraint).contains(&scope) {
            self.errors.at(call.name.span, say::kink(name));
            return None;
        }
        if call.arguments.len() != arity {
            self.errors.at(
                call.area,
                say::arity(name, &arity.to_string(), &call.arguments.len().to_string()),
            );
            return None;
        }
        let arguments: Vec<_> = call
            .arguments
            .iter()
            .map(|argument| self.expr(&argument.value, scope))
            .collect();
        let arguments: Vec<Typed> = arguments.into_iter().collect::<Option<_>>()?;
        let first = &arguments[0];
        if let Some(second) = arguments.get(1)
            && first.dimension != second.dimension
        {
            let message = say::unlike(&second.describe(), &first.describe());
            self.errors.at(call.arguments[1].value.area, message);
            return None;
        }
        if let Some(second) = arguments.get(1) {
            self.same_turns(
                (&call.arguments[0].value, first.nature),
                (&call.arguments[1].value, second.nature),
            )?;
        }
        // When something prescribed switches is known ahead; when the state does, the error of the step tells.
        if has_kink && scope == Scope::Force && !arguments.iter().any(|argument| fold::has_state(&argument.value)) {
            self.errors.at(call.name.span, say::kink(name));
            return None;
        }
        let half = Fraction { over: 1, under: 2 };
        let angle = Nature::angular();
        let (dimension, nature) = match function {
            Function::Abs | Function::Min | Function::Max => (
                first.dimension,
                arguments
                    .iter()
                    .fold(first.nature, |all, argument| all.plus(argument.nature)),
            ),
            Function::Atan2 => (Dimension::NONE, angle),
            Function::Sqrt => (self.raised(first.dimension, half, call.area)?, Nature::default()),
            _ => {
                let argument = &call.arguments[0].value;
                let is_trigonometric = matches!(function, Function::Sin | Function::Cos | Function::Tan);
                if !first.dimension.is_none() {
                    let message = match is_trigonometric && first.is_time() {
                        true => say::function_of_time(name),
                        false => say::function_of(name, &first.describe()),
                    };
                    self.errors.at(argument.area, message);
                    return None;
                }
                if is_trigonometric && first.nature.counts_cycles() {
                    self.errors.at(argument.area, say::HERTZ);
                    return None;
                }
                let is_inverse = matches!(function, Function::Asin | Function::Acos | Function::Atan);
                (Dimension::NONE, if is_inverse { angle } else { Nature::default() })
            }
        };
        let values = arguments.into_iter().map(|argument| argument.value).collect();
        let value = model::Expr::Call(function, values);
        self.is_finite(&value, call.area)?;
        Some(Typed {
            value,
            dimension,
            nature,
        })
    }

    /// Two numbers.
    pub(in crate::check) fn combine(
        &mut self,
        operator: Binary,
        (left, a): (&Expr, Typed),
        (right, b): (&Expr, Typed),
    ) -> Option<Typed> {
        // Also where params cancel: whatever they are.
        let vanishes = |value| (0..fold::SAMPLES).all(|sample| fold::sampled(value, sample) == Some(0.0));
        if operator == Binary::Divide && vanishes(&b.value) {
            self.errors.at(right.area, say::DIVISION_BY_ZERO);
            return None;
        }
        let dimension = match operator {
            Binary::Multiply => a.dimension.multiply(b.dimension),
            Binary::Divide => a.dimension.divide(b.dimension),
            Binary::Add | Binary::Subtract if a.dimension == b.dimension => Some(a.dimension),
            Binary::Add | Binary::Subtract => {
                self.unlike_terms(left, &a, right, &b);
                return None;
            }
        };
        let Some(dimension) = dimension else {
            self.errors.at(left.area.to(right.area), say::EXPONENT_RANGE);
            return None;
        };
        let nature = match operator {
            Binary::Add | Binary::Subtract => {
                self.same_turns((left, a.nature), (right, b.nature))?;
                a.nature.plus(b.nature)
            }
            Binary::Multiply => a.nature.times(b.nature),
            Binary::Divide => a.nature.over(b.nature),
        };
        let value = model::Expr::Binary(operator, Box::new(a.value), Box::new(b.value));
        self.is_finite(&value, left.area.to(right.area))?;
        Some(Typed {
            value,
            dimension,
            nature,
        })
    }

    /// Refuses a sum or comparison of cycles with angles, at the one that counts cycles, and of an angle with a plain number, at the number.
    pub(in crate::check) fn same_turns(
        &mut self,
        (left, a): (&Expr, Nature),
        (right, b): (&Expr, Nature),
    ) -> Option<()> {
        if !a.clashes(b) {
            self.no_number_beside((left, a), right)?;
            return self.no_number_beside((right, b), left);
        }
        let cycles = if a.counts_cycles() { left } else { right };
        self.errors.at(cycles.area, say::HERTZ);
        None
    }

    /// Refuses a constant beyond the range of numbers.
    pub(in crate::check) fn is_finite(&mut self, value: &model::Expr, area: crate::errors::Area) -> Option<()> {
        if fold::constant(value).is_some_and(|value| !value.is_finite()) {
            self.errors.at(area, say::NOT_FINITE);
            return None;
        }
        Some(())
    }

    /// Reports two terms of different dimensions, at the one that lacks a unit, else at the second.
    pub(in crate::check) fn unlike_terms(&mut self, left: &Expr, a: &Typed, right: &Expr, b: &Typed) {
        let (wrong, own, other) = if bare_literal(left).is_some() {
            (left, a, b)
        } else {
            (right, b, a)
        };
        let message = match bare_literal(wrong) {
            Some(text) => say::unlike_literal(
                &text,
                &other.describe(),
                &behind_number(&other.dimension.symbol(other.nature.angle)),
            ),
            None => say::unlike(&own.describe(), &other.describe()),
        };
        self.errors.at(wrong.area, message);
    }

    fn raised(&mut self, dimension: Dimension, exponent: Fraction, area: crate::errors::Area) -> Option<Dimension> {
        let raised = dimension.power(exponent);
        if raised.is_none() {
            self.errors.at(area, say::EXPONENT_RANGE);
        }
        raised
    }

    fn power(&mut self, base: &'a Expr, exponent: &'a Expr, scope: Scope) -> Option<Typed> {
        let (a, b) = (self.expr(base, scope), self.expr(exponent, scope));
        let (a, b) = (a?, b?);
        if !b.dimension.is_none() {
            self.errors.at(exponent.area, say::exponent_dimension(&b.describe()));
            return None;
        }
        let dimension = if a.dimension.is_none() {
            a.dimension
        } else {
            let Some(fraction) = fold::constant(&b.value).and_then(Fraction::of) else {
                self.errors.at(exponent.area, say::exponent_constant(&a.describe()));
                return None;
            };
            self.raised(a.dimension, fraction, base.area.to(exponent.area))?
        };
        let value = model::Expr::Power(Box::new(a.value), Box::new(b.value));
        self.is_finite(&value, base.area.to(exponent.area))?;
        Some(Typed {
            value,
            dimension,
            nature: a.nature,
        })
    }

    fn conditional(&mut self, inner: &'a If, scope: Scope) -> Option<Typed> {
        let [left, right, then, otherwise] =
            [&inner.left, &inner.right, &inner.then, &inner.otherwise].map(|expr| self.expr(expr, scope));
        let condition = match (left, right) {
            (Some(left), Some(right)) => self.condition(inner, left, right, scope),
            _ => None,
        };
        let (then, otherwise) = (then?, otherwise?);
        if then.dimension != otherwise.dimension {
            let message = say::unlike_cases(&otherwise.describe(), &then.describe());
            self.errors.at(inner.otherwise.area, message);
            return None;
        }
        self.same_turns((&inner.then, then.nature), (&inner.otherwise, otherwise.nature))?;
        let (left, right) = condition?;
        let nature = then.nature.plus(otherwise.nature);
        let [left, right, a, b] = [left.value, right.value, then.value, otherwise.value].map(Box::new);
        Some(Typed {
            value: model::Expr::If(inner.comparison, left, right, a, b),
            dimension: then.dimension,
            nature,
        })
    }

    /// Both sides alike; nothing but time decides, so that the switch can be found and be a step boundary.
    fn condition(&mut self, inner: &If, left: Typed, right: Typed, scope: Scope) -> Option<(Typed, Typed)> {
        if left.dimension != right.dimension {
            self.unlike_terms(&inner.left, &left, &inner.right, &right);
            return None;
        }
        self.same_turns((&inner.left, left.nature), (&inner.right, right.nature))?;
        if fold::has_arclength(&left.value) || fold::has_arclength(&right.value) {
            let area = inner.left.area.to(inner.right.area);
            self.errors.at(area, say::CONDITION_ALONG);
            return None;
        }
        if fold::has_strain(&left.value) || fold::has_strain(&right.value) {
            let area = inner.left.area.to(inner.right.area);
            self.errors.at(area, say::CONDITION_OF_STRAIN);
            return None;
        }
        if fold::has_element(&left.value) || fold::has_element(&right.value) {
            let area = inner.left.area.to(inner.right.area);
            self.errors.at(area, say::CONDITION_OF_ELEMENT);
            return None;
        }
        let of_state = fold::has_state(&left.value) || fold::has_state(&right.value);
        if (Scope::Prescribed..=Scope::Force).contains(&scope) && of_state {
            self.errors.at(inner.left.area.to(inner.right.area), say::CONDITION);
            return None;
        }
        Some((left, right))
    }
}
