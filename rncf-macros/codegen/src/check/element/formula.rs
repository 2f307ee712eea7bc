//! Formulas of an element: strains and energies of inner products of its fields.

use super::{Draft, say};
use crate::check::Check;
use crate::check::values::quantity::Typed;
use crate::check::values::scope::Scope;
use crate::elements::{Coefficient, Definition, Interpolant, Nature, When, WrittenTerm, word};
use crate::model::{Binary, ElementQuantity, Expr as Value, Function, fold};
use crate::parse::tree::{self, Call, ElementKind, ElementStatement, Expr, ExprKind, Name};
use crate::suggest;
use crate::units::{Dimension, Fraction};

/// A field that formulas may name.
#[derive(Clone, Debug)]
pub struct FieldOfElement {
    /// Its name.
    pub name: String,
    /// Dimension of its components.
    pub dimension: Dimension,
}

/// Products of fields.
const PRODUCTS: [(&str, usize); 3] = [("dot", 2), ("cross", 2), ("norm", 1)];

/// What names of coefficients that params and the time give begin with.
pub(super) const GIVEN: &str = "given_";

/// Energy per length, N.
const ENERGY: Dimension = Dimension([
    Fraction { over: 1, under: 1 },
    Fraction { over: 1, under: 1 },
    Fraction { over: -2, under: 1 },
    Fraction { over: 0, under: 1 },
    Fraction { over: 0, under: 1 },
]);

impl<'a> Check<'a> {
    /// Definitions and terms of the energy.
    pub(super) fn formulas(&mut self, statements: &'a [ElementStatement], draft: &mut Draft<'a>) {
        self.element_fields = draft
            .fields
            .iter()
            .map(|(name, field)| {
                let exponent = i8::from(field.of == Interpolant::Position) - field.order as i8;
                FieldOfElement {
                    name: name.text.clone(),
                    dimension: Dimension::of([exponent, 0, 0, 0, 0, 0]),
                }
            })
            .collect();
        self.lost_fields = draft.lost_fields.iter().map(ToString::to_string).collect();
        for (_, one, dimension) in draft
            .coefficients
            .iter()
            .filter(|(_, one, _)| !one.name.starts_with(GIVEN))
        {
            let mut value = Value::Element(ElementQuantity::Coefficient(one.name));
            if let Some(factor) = draft.timed.get(one.name) {
                value = Value::Binary(Binary::Multiply, Box::new(value), Box::new(factor.clone()));
            }
            self.locals.insert(one.name, Typed::new(value, *dimension));
        }
        let in_plane = |at: usize| {
            let is_there = |at: usize| draft.fields[at].1.of != Interpolant::SectionZ;
            is_there(at).then(|| (0..at).filter(|&before| is_there(before)).count())
        };
        draft.written.in_plane = (0..draft.fields.len()).map(in_plane).collect();
        for statement in statements {
            match &statement.kind {
                ElementKind::Definition {
                    is_strain,
                    name,
                    when,
                    value,
                } => self.definition(*is_strain, name, when, value, draft),
                ElementKind::Energy {
                    name,
                    when,
                    value,
                    stress,
                    points,
                    nature,
                } => {
                    let points = points.as_ref().map(|points| self.sampling(points, &draft.vectors));
                    let term = self.term(name, when, value, stress.as_ref(), draft);
                    draft.is_formula_lost |= term.is_none();
                    if let (Some(mut term), Some(points)) = (term, points.map_or(Some(None), |points| points.map(Some)))
                    {
                        term.points = points;
                        term.nature = self.nature(nature.as_deref());
                        draft.written.terms.push(term);
                        draft.terms.push(name);
                        draft
                            .active
                            .push(nature.as_deref().filter(|word| word.text == "active"));
                    }
                }
                _ => {}
            }
        }
    }

    fn definition(
        &mut self,
        is_strain: bool,
        name: &'a Name,
        when: &'a tree::When,
        value: &'a Expr,
        draft: &mut Draft<'a>,
    ) {
        let when = self.when(when, draft);
        let typed = self.expr(value, Scope::Prescribed);
        let text = name.text.as_str();
        let (Some(when), Some(typed)) = (when, typed) else {
            // What it is used for is not to blame.
            self.unknown.insert(text.to_string());
            draft.is_formula_lost = true;
            return;
        };
        let number = draft.names.iter().position(|(other, _)| *other == text);
        let number = match number {
            Some(number) if draft.names[number].1 != typed.dimension => {
                let message = say::unlike_definition(text, &typed.describe(), &draft.names[number].1.describe(false));
                self.errors.at(value.area, message);
                return;
            }
            Some(number) => {
                let mut before = draft.written.definitions.iter().filter(|one| one.name == number);
                if before.any(|one| one.when.overlaps(&when)) {
                    self.errors.at(name.span, say::defined_already(text));
                    return;
                }
                number
            }
            None => {
                draft.names.push((text, typed.dimension));
                draft.definitions.push(name);
                draft.names.len() - 1
            }
        };
        let area = value.area;
        let value = self.without_params(typed.value, draft);
        if is_strain && draft.is_timed(&value) {
            self.errors.at(area, say::timed_strain(text));
        }
        if is_strain && !draft.written.is_linear_in_strains(&value) {
            self.errors.at(area, say::STRAIN_OF_STRAINS);
            draft.is_formula_lost = true;
        }
        draft.written.definitions.push(Definition {
            name: number,
            is_strain,
            when,
            value,
        });
        let named = Value::Element(ElementQuantity::Named(number));
        self.locals.insert(word(text), Typed::new(named, typed.dimension));
    }

    fn term(
        &mut self,
        name: &'a Name,
        when: &'a tree::When,
        value: &'a Expr,
        stress: Option<&'a Expr>,
        draft: &mut Draft<'a>,
    ) -> Option<WrittenTerm> {
        let when = self.when(when, draft);
        let energy = self.expr(value, Scope::Prescribed);
        let stress = stress.map(|stress| (stress, self.expr(stress, Scope::Prescribed)));
        let (when, energy) = (when?, energy?);
        if energy.dimension != ENERGY {
            self.errors.at(value.area, say::energy_unit(&energy.describe()));
            return None;
        }
        let energy = self.without_params(energy.value, draft);
        let (coefficient, density) = taken(&energy).unwrap_or(("", energy));
        let stress = match stress {
            None => None,
            Some((area, typed)) => {
                let typed = typed?;
                let stress = self.without_params(typed.value, draft);
                match taken_of(&stress, coefficient) {
                    Some(rest) => Some(rest),
                    None => {
                        self.errors.at(area.area, say::stress_factor(coefficient));
                        return None;
                    }
                }
            }
        };
        Some(WrittenTerm {
            name: word(&name.text.replace('_', " ")),
            when,
            coefficient,
            density,
            stress,
            points: None,
            nature: Nature::Damped,
        })
    }

    /// What damps a part of the energy, by the word behind it.
    fn nature(&mut self, word: Option<&Name>) -> Nature {
        let nature = match word.map(|word| word.text.as_str()) {
            Some("undamped") => Nature::Undamped,
            Some("viscous") => Nature::Viscous,
            _ => Nature::Damped,
        };
        if let Some(word) = word.filter(|_| nature != Nature::Damped && !self.is_trusted) {
            self.errors.at(word.span, say::damping_of_parts(&word.text));
        }
        nature
    }

    fn when(&mut self, when: &'a tree::When, draft: &Draft) -> Option<When> {
        let mut found = When {
            dimension: when
                .space
                .as_ref()
                .map(|space| if space.text == "plane" { 2 } else { 3 }),
            options: Vec::new(),
        };
        let mut is_whole = true;
        for (option, value) in &when.options {
            let Some(at) = draft.options.iter().position(|one| one.name == option.text) else {
                let known = draft.options.iter().map(|one| one.name);
                self.errors
                    .at(option.span, suggest::unknown("option", &option.text, known));
                is_whole = false;
                continue;
            };
            let values = &draft.options[at].values;
            match values.iter().position(|one| *one == value.text) {
                Some(chosen) => found.options.push((at, chosen)),
                None => {
                    let kind = format!("value of `{}`", option.text);
                    self.errors
                        .at(value.span, suggest::unknown(&kind, &value.text, values.iter().copied()));
                    is_whole = false;
                }
            }
        }
        is_whole.then_some(found)
    }

    /// Lets params, and what they and the time give, be coefficients of the element, so that formulas are of coefficients and
    /// inner products alone.
    fn without_params(&mut self, value: Value, draft: &mut Draft<'a>) -> Value {
        if is_given(&value) {
            return given(&value, draft);
        }
        let mut walk = |inner: Box<Value>| Box::new(self.without_params(*inner, draft));
        match value {
            Value::Negate(a) => Value::Negate(walk(a)),
            Value::Binary(operator, a, b) => Value::Binary(operator, walk(a), walk(b)),
            Value::Power(a, b) => Value::Power(walk(a), walk(b)),
            Value::Call(function, arguments) => {
                let arguments = arguments.into_iter().map(|one| *walk(Box::new(one))).collect();
                Value::Call(function, arguments)
            }
            // What decides is given; both cases have a value.
            Value::If(comparison, left, right, then, otherwise) => {
                let [zero, one] = [0.0, 1.0].map(|value| Box::new(Value::Number(value)));
                let [then, otherwise] = [then, otherwise].map(walk);
                let [on, off] = [[&one, &zero], [&zero, &one]].map(|[then, otherwise]| {
                    let (left, right) = (left.clone(), right.clone());
                    Box::new(given(
                        &Value::If(comparison, left, right, then.clone(), otherwise.clone()),
                        draft,
                    ))
                });
                let part = |factor, of| Box::new(Value::Binary(Binary::Multiply, factor, of));
                Value::Binary(Binary::Add, part(on, then), part(off, otherwise))
            }
            Value::Param(id) => {
                let param = &self.model.params[id.0];
                let name = word(&format!("param_{}", param.name));
                if !draft.coefficients.iter().any(|(_, one, _)| one.name == name) {
                    let one = Coefficient {
                        name,
                        unit: word(&param.unit),
                        factors: Vec::new(),
                        scale: Some(Value::Param(id)),
                    };
                    draft.coefficients.push((draft.place, one, Dimension::NONE));
                }
                Value::Element(ElementQuantity::Coefficient(name))
            }
            other => other,
        }
    }

    /// Whether a name is a field of the element that is being checked.
    pub(super) fn is_field(&self, text: &str) -> bool {
        self.element_fields.iter().any(|field| field.name == text)
    }

    /// `dot(a, b)`, `cross(a, b)` and `norm(a)` of fields of the element that is being checked; `None` elsewhere.
    pub(in crate::check) fn field_product(&mut self, call: &'a Call) -> Option<Option<Typed>> {
        if self.element_fields.is_empty() && self.lost_fields.is_empty() {
            return None;
        }
        let name = call.name.text.as_str();
        let &(_, arity) = PRODUCTS.iter().find(|(word, _)| *word == name)?;
        if call.arguments.len() != arity {
            let message = crate::check::say::arity(name, &arity.to_string(), &call.arguments.len().to_string());
            self.errors.at(call.area, message);
            return Some(None);
        }
        let places: Vec<Option<usize>> = call
            .arguments
            .iter()
            .map(|argument| self.field_place(&argument.value))
            .collect();
        let places: Option<Vec<usize>> = places.into_iter().collect();
        Some(places.and_then(|places| {
            let (i, j) = (places[0], places[places.len() - 1]);
            let dimension = self.element_fields[i].dimension;
            let product = dimension.multiply(self.element_fields[j].dimension)?;
            Some(match name {
                "cross" => Typed::new(Value::Element(ElementQuantity::Cross(i, j)), product),
                "norm" => {
                    let square = Value::Element(ElementQuantity::Dot(i, i));
                    Typed::new(Value::Call(Function::Sqrt, vec![square]), dimension)
                }
                _ => Typed::new(Value::Element(ElementQuantity::Dot(i, j)), product),
            })
        }))
    }

    fn field_place(&mut self, expr: &Expr) -> Option<usize> {
        let ExprKind::Name(name) = &expr.kind else {
            self.errors.at(expr.area, say::PRODUCT_OF);
            return None;
        };
        let found = self.element_fields.iter().position(|field| field.name == name.text);
        if found.is_none() && !self.lost_fields.contains(&name.text) {
            let known: Vec<String> = self.element_fields.iter().map(|field| field.name.clone()).collect();
            let message = suggest::unknown("field of the element", &name.text, known.iter().map(String::as_str));
            self.errors.at(name.span, message);
        }
        found
    }

    /// A member that has a meaning inside of an element alone; `None` elsewhere.
    pub(in crate::check) fn of_element(&mut self, expr: &Expr) -> Option<Option<Typed>> {
        self.property(expr).or_else(|| self.field_component(expr))
    }

    /// A component of a field, which is not objective; `None` where it is none.
    fn field_component(&mut self, expr: &Expr) -> Option<Option<Typed>> {
        let ExprKind::Member { base, field, .. } = &expr.kind else {
            return None;
        };
        let ExprKind::Name(name) = &base.kind else {
            return None;
        };
        if !self.is_field(&name.text) {
            return None;
        }
        self.errors.at(expr.area, say::component(&name.text, &field.text));
        Some(None)
    }

    /// A field where a number is expected; says whether it was one.
    pub(in crate::check) fn is_field_as_number(&mut self, name: &Name) -> bool {
        let is_field = self.is_field(&name.text);
        if is_field {
            self.errors.at(name.span, say::field_as_number(&name.text));
        }
        is_field
    }
}

/// Whether a value is of params, motions and the time alone, and no plain arithmetic of params.
fn is_given(value: &Value) -> bool {
    let is_more = |part: &Value| {
        matches!(
            part,
            Value::Time | Value::Motion(..) | Value::If(..) | Value::Lookup { .. }
        )
    };
    value.contains(&is_more) && !fold::has_element(value)
}

/// The coefficient that stands for such a value.
pub(super) fn given(value: &Value, draft: &mut Draft) -> Value {
    let known = draft.coefficients.iter().find(|(_, one, _)| {
        let is_alone = one.factors.is_empty() && one.name.starts_with(GIVEN);
        is_alone && one.scale.as_ref() == Some(value)
    });
    let name = match known {
        Some((_, one, _)) => one.name,
        None => {
            let number = draft
                .coefficients
                .iter()
                .filter(|(_, one, _)| one.name.starts_with(GIVEN));
            let name = word(&format!("{GIVEN}{}", number.count() + 1));
            let one = Coefficient {
                name,
                unit: "SI",
                factors: Vec::new(),
                scale: Some(value.clone()),
            };
            draft.coefficients.push((draft.place, one, Dimension::NONE));
            name
        }
    };
    Value::Element(ElementQuantity::Coefficient(name))
}

impl Draft<'_> {
    /// Whether a value of coefficients, inner products and names changes with time at a fixed shape.
    fn is_timed(&self, value: &Value) -> bool {
        let is_coefficient = |name: &str| {
            let one = self.coefficients.iter().find(|(_, one, _)| one.name == name);
            one.is_some_and(|(_, one, _)| one.is_timed())
        };
        value.contains(&|part| match part {
            Value::Element(ElementQuantity::Coefficient(name)) => is_coefficient(name),
            Value::Element(ElementQuantity::Named(name)) => {
                let own = self.written.definitions.iter().filter(|one| one.name == *name);
                own.into_iter().any(|one| self.is_timed(&one.value))
            }
            _ => false,
        })
    }
}

/// The first coefficient that is a factor, and what is left without it.
fn taken(value: &Value) -> Option<(&'static str, Value)> {
    let name = first_factor(value)?;
    Some((name, taken_of(value, name)?))
}

fn first_factor(value: &Value) -> Option<&'static str> {
    match value {
        Value::Element(ElementQuantity::Coefficient(name)) => Some(name),
        Value::Negate(a) | Value::Binary(Binary::Divide, a, _) => first_factor(a),
        Value::Binary(Binary::Multiply, a, b) => first_factor(a).or_else(|| first_factor(b)),
        _ => None,
    }
}

/// What is left of a product without one of its factors; `None` where it has none of this name.
fn taken_of(value: &Value, name: &str) -> Option<Value> {
    if name.is_empty() {
        return Some(value.clone());
    }
    match value {
        Value::Element(ElementQuantity::Coefficient(own)) if *own == name => Some(Value::Number(1.0)),
        Value::Negate(a) => Some(Value::Negate(Box::new(taken_of(a, name)?))),
        Value::Binary(Binary::Divide, a, b) => {
            let rest = taken_of(a, name)?;
            Some(Value::Binary(Binary::Divide, Box::new(rest), b.clone()))
        }
        Value::Binary(Binary::Multiply, a, b) => {
            let (left, right) = match (taken_of(a, name), taken_of(b, name)) {
                (Some(left), _) => (left, (**b).clone()),
                (None, Some(right)) => ((**a).clone(), right),
                (None, None) => return None,
            };
            Some(Value::Binary(Binary::Multiply, Box::new(left), Box::new(right)))
        }
        _ => None,
    }
}
