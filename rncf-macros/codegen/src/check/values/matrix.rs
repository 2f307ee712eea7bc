//! Matrices of three rows: `[a, b, c] unit` is a diagonal, `[[a, b, c], [d, e, f], [g, h, i]] unit` all of them.

use super::quantity::Wanted;
use super::scope::Scope;
use crate::check::{Check, fold, say};
use crate::model::Expr as Value;
use crate::parse::tree::{Expr, ExprKind};

/// Rows.
pub type Matrix = [[Value; 3]; 3];

/// Whether the entries on both sides of the diagonal are written the same.
pub fn is_symmetric(matrix: &Matrix) -> bool {
    [[0, 1], [0, 2], [1, 2]]
        .iter()
        .all(|[i, j]| matrix[*i][*j] == matrix[*j][*i])
}

impl<'a> Check<'a> {
    /// A matrix of params. The entries of a diagonal are not negative; those of rows may be anything.
    pub(in crate::check) fn matrix(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Matrix> {
        match &expr.kind {
            ExprKind::Vector { components, .. } if components.iter().any(is_row) => self.rows(expr, wanted),
            _ => self.diagonal(expr, wanted),
        }
    }

    fn diagonal(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Matrix> {
        let vector = self.vector(expr, Scope::Parameter, wanted)?;
        for (value, area) in vector.values.iter().zip(vector.areas) {
            if fold::constant(value).is_some_and(|value| value < 0.0) {
                self.errors.at(area, say::not_negative(wanted.what));
                return None;
            }
        }
        let zero = [const { Value::Number(0.0) }; 3];
        let mut rows = [zero.clone(), zero.clone(), zero];
        for (at, value) in vector.values.into_iter().enumerate() {
            rows[at][at] = value;
        }
        Some(rows)
    }

    fn rows(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Matrix> {
        let ExprKind::Vector { components, unit } = &expr.kind else {
            return None;
        };
        let of_all = self.unit_behind(unit.as_ref(), wanted)?;
        let mut rows = Vec::new();
        for row in components {
            let parts = match (&row.kind, of_all) {
                (ExprKind::Vector { components, unit: None }, Some(_)) => {
                    self.in_unit(components, of_all, Scope::Parameter, wanted)?
                }
                (ExprKind::Vector { .. }, None) => self.components(row, Scope::Parameter, wanted)?.0,
                _ => Vec::new(),
            };
            rows.push(self.three(parts, row, wanted)?);
        }
        self.three(rows, expr, wanted)
    }

    fn three<T>(&mut self, parts: Vec<T>, expr: &Expr, wanted: Wanted) -> Option<[T; 3]> {
        let three = parts.try_into().ok();
        if three.is_none() {
            self.errors.at(expr.area, say::matrix_rows(wanted.what, wanted.unit));
        }
        three
    }
}

fn is_row(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Vector { .. })
}
