//! Nodal vectors and their shape functions: exact polynomials that take the values of their nodes and reproduce rigid motion.

use super::{Draft, say};
use crate::check::Check;
use crate::elements::{Interpolant, NodalVector, word};
use crate::model::Binary;
use crate::parse::tree::{ElementKind, ElementStatement, Expr, ExprKind, Name};
use crate::tensors::{Polynomial, Rational};

/// Highest degree of a shape function: beyond it exact tensors have no room.
const HIGHEST: usize = 7;

impl<'a> Check<'a> {
    pub(super) fn nodal_vector(
        &mut self,
        name: &'a Name,
        of: &'a Name,
        place: &'a Expr,
        shape: &'a Expr,
        coordinate: &'a Name,
    ) -> Option<NodalVector> {
        let derivative = self.known_derivative(of);
        let place_value = self.polynomial(place, None);
        let shape = self.polynomial(shape, Some(coordinate));
        let (interpolant, order) = derivative?;
        let meaning = match (interpolant, order) {
            (Interpolant::Position, 0) => "position",
            (Interpolant::Position, 1) => "slope",
            (Interpolant::SectionY, 0) => "section y axis",
            (Interpolant::SectionZ, 0) => "section z axis",
            _ => {
                self.errors.at(of.span, say::no_vector(&of.text));
                return None;
            }
        };
        let at = place_value?.coefficients().first().copied().unwrap_or(Rational::ZERO);
        if at < Rational::ZERO || at > Rational::ONE {
            self.errors.at(place.area, say::PLACE);
            return None;
        }
        Some(NodalVector {
            name: word(&name.text),
            meaning,
            place: at,
            of: interpolant,
            order,
            shape: shape?,
        })
    }

    /// A polynomial of the coordinate with exact coefficients; without a coordinate a number.
    fn polynomial(&mut self, expr: &'a Expr, coordinate: Option<&'a Name>) -> Option<Polynomial> {
        let found = match &expr.kind {
            ExprKind::Number { text, unit: None } => decimal(text).map(|value| Polynomial::new(vec![value])),
            ExprKind::Name(name) => match coordinate {
                Some(coordinate) if coordinate.text == name.text => Some(Polynomial::whole(&[0, 1])),
                Some(coordinate) => {
                    self.errors
                        .at(name.span, say::not_the_coordinate(&name.text, &coordinate.text));
                    return None;
                }
                None => None,
            },
            ExprKind::Negate(inner) => Some(self.polynomial(inner, coordinate)?.times(Rational::whole(-1))),
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.polynomial(left, coordinate), self.polynomial(right, coordinate));
                let (left, right) = (left?, right?);
                match operator {
                    Binary::Add => Some(left.plus(&right)),
                    Binary::Subtract => Some(left.plus(&right.times(Rational::whole(-1)))),
                    Binary::Multiply => (left.degree() + right.degree() <= HIGHEST).then(|| left.product(&right)),
                    Binary::Divide => match right.coefficients() {
                        [divisor] => Some(left.times(Rational::ONE.divide(*divisor))),
                        _ => None,
                    },
                }
            }
            ExprKind::Power(base, exponent) => {
                let base = self.polynomial(base, coordinate)?;
                let exponent = match &exponent.kind {
                    ExprKind::Number { text, unit: None } => text.parse::<usize>().ok(),
                    _ => None,
                };
                exponent
                    .filter(|exponent| exponent * base.degree().max(1) <= HIGHEST)
                    .map(|exponent| (0..exponent).fold(Polynomial::whole(&[1]), |power, _| power.product(&base)))
            }
            _ => None,
        };
        let found = found.filter(|polynomial| polynomial.coefficients().iter().all(|value| value.is_small()));
        if found.is_none() {
            let message = match coordinate {
                Some(coordinate) => say::not_a_polynomial(&coordinate.text, HIGHEST),
                None => say::PLACE.to_string(),
            };
            self.errors.at(expr.area, message);
        }
        found
    }

    /// Shape functions take the values of their nodes, and reproduce rigid motion and uniform strain; nodes are alike at
    /// both ends.
    pub(super) fn shapes(&mut self, draft: &Draft<'a>) {
        let before = self.errors.len();
        for (name, vector) in &draft.vectors {
            let others = draft.vectors.iter().filter(|(_, other)| other.of == vector.of);
            for (other_name, other) in others {
                // The function of `vector` has the value of the node of `other`.
                let value = exactly(&vector.shape.derivative(other.order), other.place);
                let wanted = if std::ptr::eq(*name, *other_name) {
                    Rational::ONE
                } else {
                    Rational::ZERO
                };
                if value != wanted {
                    let what = if other.order == 0 { "value" } else { "slope" };
                    let numbers = [value, other.place, wanted].map(written);
                    let message = say::not_interpolating(&name.text, what, &numbers, &other_name.text);
                    self.errors.at(name.span, message);
                    break;
                }
            }
        }
        self.ends(draft);
        if self.errors.len() != before {
            return;
        }
        for of in [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ] {
            let list: Vec<_> = draft.vectors.iter().filter(|(_, vector)| vector.of == of).collect();
            let Some((first, _)) = list.first() else {
                continue;
            };
            let mut unity = Polynomial::zero();
            let mut linear = Polynomial::zero();
            for (_, vector) in &list {
                if vector.order == 0 {
                    unity = unity.plus(&vector.shape);
                    linear = linear.plus(&vector.shape.times(vector.place));
                } else {
                    linear = linear.plus(&vector.shape);
                }
            }
            if unity != Polynomial::whole(&[1]) {
                self.errors
                    .at(first.span, say::no_partition(first.text.as_str(), &text_of(&unity)));
            } else if of == Interpolant::Position && linear != Polynomial::whole(&[0, 1]) {
                self.errors.at(first.span, say::not_linear(&text_of(&linear)));
            }
        }
    }

    /// Fields and inertia are of what nodal vectors interpolate; anything else would be zero everywhere.
    pub(super) fn interpolated(&mut self, statements: &'a [ElementStatement], draft: &Draft<'a>) {
        for statement in statements {
            let (ElementKind::Field { of, .. } | ElementKind::Inertia { of, .. }) = &statement.kind else {
                continue;
            };
            let Some((interpolant, order)) = super::derivative(&of.text) else {
                continue;
            };
            let vectors = draft.vectors.iter().filter(|(_, vector)| vector.of == interpolant);
            let message = match vectors.map(|(_, vector)| vector.shape.degree()).max() {
                None => say::not_interpolated(&of.text, &of.text[..of.text.len() - order]),
                Some(degree) if degree < order => say::always_zero(&of.text, &degree.to_string()),
                Some(_) => continue,
            };
            self.errors.at(of.span, message);
        }
    }

    /// The node at 1 is the node at 0 of the next element.
    fn ends(&mut self, draft: &Draft<'a>) {
        let at = |place: Rational| -> Vec<_> {
            let list = draft.vectors.iter().filter(|(_, vector)| vector.place == place);
            list.collect()
        };
        let (start, end) = (at(Rational::ZERO), at(Rational::ONE));
        let kinds = |list: &[&(&Name, NodalVector)]| -> Vec<_> {
            list.iter().map(|(_, vector)| (vector.of, vector.order)).collect()
        };
        let differing = start
            .iter()
            .zip(&end)
            .find(|(a, b)| (a.1.of, a.1.order) != (b.1.of, b.1.order));
        if kinds(&start) != kinds(&end) {
            let longer = if start.len() > end.len() { &start } else { &end };
            let name = match differing {
                Some((_, wrong)) => wrong.0,
                None => longer[start.len().min(end.len())].0,
            };
            self.errors.at(name.span, say::ends_differ(&name.text));
        } else if kinds(&start).first() != Some(&(Interpolant::Position, 0)) {
            let name = draft.vectors[0].0;
            self.errors.at(name.span, say::NO_POSITION);
        }
    }
}

/// The exact value of a decimal number.
fn decimal(text: &str) -> Option<Rational> {
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    if part.len() > 9 || whole.len() > 9 {
        return None;
    }
    let digits = format!("{whole}{part}").parse::<i128>().ok()?;
    Some(Rational::new(digits, 10_i128.pow(u32::try_from(part.len()).ok()?)))
}

/// The value at a place, exactly.
fn exactly(polynomial: &Polynomial, at: Rational) -> Rational {
    let coefficients = polynomial.coefficients().iter().rev();
    coefficients.fold(Rational::ZERO, |sum, &value| sum * at + value)
}

/// A fraction as it is written.
fn written(value: Rational) -> String {
    let (over, under) = value.parts();
    match under {
        1 => over.to_string(),
        under => format!("{over}/{under}"),
    }
}

/// A polynomial as it is written, with the coordinate `xi`.
fn text_of(polynomial: &Polynomial) -> String {
    let terms = polynomial
        .coefficients()
        .iter()
        .enumerate()
        .filter(|(_, value)| !value.is_zero());
    let terms: Vec<String> = terms
        .map(|(power, value)| match power {
            0 => written(*value),
            1 => format!("{}*xi", written(*value)),
            power => format!("{}*xi^{power}", written(*value)),
        })
        .collect();
    if terms.is_empty() {
        "0".into()
    } else {
        terms.join(" + ").replace("+ -", "- ")
    }
}
