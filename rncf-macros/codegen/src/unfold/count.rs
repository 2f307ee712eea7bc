//! Whole numbers that are known at build time: of repetitions, and of one of them.

use super::messages as say;
use super::{Count, Place, Unfold};
use crate::model::Binary;
use crate::parse::tree::{Expr, ExprKind, ItemKind, Keyword, Name};

/// Constants that are defined by each other, and operations in each other.
const DEEPEST: usize = 300;

/// Most repetitions of one loop.
const MOST: f64 = 10_000.0;

impl<'t> Unfold<'t, '_> {
    /// The number of repetitions of a loop.
    pub(super) fn count(&mut self, at: &Place, expr: &'t Expr) -> Count {
        let Some(value) = self.value(at, expr, 0) else {
            return Count::Kept;
        };
        let is_literal = matches!(expr.kind, ExprKind::Number { .. });
        // Between n things there are n - 1 of something, which may be none.
        let least = if is_literal { 1.0 } else { 0.0 };
        if value.trunc() != value || value < least {
            return Count::Wrong;
        }
        if value > MOST {
            self.errors.at(expr.area, say::too_many(&MOST.to_string()));
            return Count::Known(1);
        }
        Count::Known(value as i64)
    }

    /// Value of an expression of plain numbers, indices and constants; none where it is of something else.
    pub(super) fn value(&mut self, at: &Place, expr: &'t Expr, depth: usize) -> Option<f64> {
        if depth > DEEPEST {
            return None;
        }
        match &expr.kind {
            ExprKind::Number { text, unit: None } => text.replace('_', "").parse().ok(),
            ExprKind::Name(name) => self.value_of(at, name, depth),
            ExprKind::Negate(inner) => Some(-self.value(at, inner, depth + 1)?),
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.value(at, left, depth + 1)?, self.value(at, right, depth + 1)?);
                Some(match operator {
                    Binary::Add => left + right,
                    Binary::Subtract => left - right,
                    Binary::Multiply => left * right,
                    Binary::Divide => left / right,
                })
            }
            ExprKind::Remainder(left, right) => {
                let (left, right) = (self.value(at, left, depth + 1)?, self.value(at, right, depth + 1)?);
                Some(left.rem_euclid(right))
            }
            ExprKind::Power(base, exponent) => {
                let (base, exponent) = (self.value(at, base, depth + 1)?, self.value(at, exponent, depth + 1)?);
                Some(base.powf(exponent))
            }
            _ => None,
        }
        .filter(|value| value.is_finite())
    }

    fn value_of(&mut self, at: &Place, name: &Name, depth: usize) -> Option<f64> {
        let text = name.text.as_str();
        if let Some(turn) = at.turns.iter().rev().find(|turn| turn.name == text) {
            return turn.number.map(|number| number as f64);
        }
        if let Some(told) = self.scopes[at.scope].told.get(text).cloned() {
            let written = format!("{}{text}", self.scopes[at.scope].prefix);
            self.counted.insert(written);
            return self.value(&told.at, told.value, depth + 1);
        }
        let scope = self.scope_of(at, text)?;
        let declared = self.scopes[scope].names[text].clone();
        let ItemKind::Const(value) = &declared.item.kind else {
            return None;
        };
        if declared.item.keyword != Keyword::Const || !declared.loops.is_empty() {
            return None;
        }
        let written = format!("{}{text}", self.scopes[scope].prefix);
        self.counted.insert(written);
        let key = (scope, declared.item.name.text.as_str());
        if let Some(known) = self.constants.get(&key) {
            return *known;
        }
        // A constant that is defined by itself has no value.
        self.constants.insert(key, None);
        let turns = Vec::new();
        let value = self.value(&Place { scope, turns }, value, depth + 1);
        self.constants.insert(key, value);
        value
    }
}
