//! A compound unit without brackets in an expression: `2 * 3 m/s` is read as `2 * 3 m` divided by something that is called `s`.

use crate::check::{Check, say};
use crate::errors::Area;
use crate::model::Binary;
use crate::parse::tree::{Expr, ExprKind, Keyword};
use crate::units;

/// What has been read of such a unit: its number, and the text of both.
struct Split {
    number: Area,
    text: String,
    unit: String,
}

impl Check<'_> {
    /// Where a product or quotient is one of a number's unit and names that are units and no values: its place, and
    /// what is said of it.
    pub(in crate::check) fn split_unit(&self, operator: Binary, left: &Expr, right: &Expr) -> Option<(Area, String)> {
        let split = self.joined(operator, left, right)?;
        let message = say::split_unit(&split.text, &split.unit);
        Some((split.number.to(right.area), message))
    }

    /// Reports several components of a vector that have such units, once.
    pub(in crate::check) fn split_vector(&mut self, expr: &Expr) -> bool {
        let ExprKind::Vector { components, unit: None } = &expr.kind else {
            return false;
        };
        let units: Vec<String> = components.iter().filter_map(|part| self.unit_of_split(part)).collect();
        let is_told = units.len() > 1 && units.iter().all(|unit| *unit == units[0]);
        if is_told {
            self.errors.at(expr.area, say::split_units(&units[0]));
        }
        is_told
    }

    fn unit_of_split(&self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Negate(inner) => self.unit_of_split(inner),
            ExprKind::Binary(operator, left, right) => Some(self.joined(*operator, left, right)?.unit),
            _ => None,
        }
    }

    fn joined(&self, operator: Binary, left: &Expr, right: &Expr) -> Option<Split> {
        let sign = match operator {
            Binary::Multiply => '*',
            Binary::Divide => '/',
            Binary::Add | Binary::Subtract => return None,
        };
        let factor = self.factor(operator, right)?;
        let mut split = match &left.kind {
            ExprKind::Binary(operator, left, right) => match self.joined(*operator, left, right) {
                None if matches!(operator, Binary::Multiply | Binary::Divide) => number(right),
                split => split,
            },
            _ => number(left),
        }?;
        split.unit.push(sign);
        split.unit.push_str(&factor);
        Some(split)
    }

    /// The text of a name that can only be meant as a unit, with its exponent.
    fn factor(&self, operator: Binary, expr: &Expr) -> Option<String> {
        if let ExprKind::Power(base, exponent) = &expr.kind {
            let base = self.factor(operator, base)?;
            return match &exponent.kind {
                ExprKind::Number { text, unit: None } => Some(format!("{base}^{text}")),
                _ => None,
            };
        }
        let ExprKind::Name(name) = &expr.kind else {
            return None;
        };
        let text = name.text.as_str();
        let is_local =
            self.locals.contains_key(text) || self.particle.contains_key(text) || self.is_perhaps_index(text);
        if text == "t" || is_local || units::find(text).is_none() {
            return None;
        }
        let is_value = match self.names.get(text).map(|item| item.keyword) {
            None => false,
            Some(Keyword::Param | Keyword::Const | Keyword::Let | Keyword::Motion) => true,
            // What has a place is a vector, by which nothing is divided.
            Some(Keyword::Frame | Keyword::Rigid) => operator == Binary::Multiply,
            Some(_) => false,
        };
        (!is_value).then(|| text.to_string())
    }
}

/// A number with one symbol, which may have a sign.
fn number(expr: &Expr) -> Option<Split> {
    match &expr.kind {
        ExprKind::Negate(inner) => number(inner),
        ExprKind::Number { text, unit: Some(unit) } if !unit.is_delimited => Some(Split {
            number: expr.area,
            text: text.clone(),
            unit: unit.text.clone(),
        }),
        _ => None,
    }
}
