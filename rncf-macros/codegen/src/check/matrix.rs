//! Matrices of three rows: `[a, b, c] unit` is a diagonal, `[[a, b, c], [d, e, f], [g, h, i]] unit` all of them.

use super::expr::Scope;
use super::quantity::Wanted;
use super::{Check, fold, say};
use crate::model::Expr as Value;
use crate::parse::tree::{Expr, ExprKind};
use crate::units::Dimension;

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
    pub(super) fn matrix(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Matrix> {
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
        let of_all = match unit {
            None => None,
            Some(unit) => {
                let compound = self.unit(unit)?;
                let (asked, found) = (Dimension::of(wanted.dimension), Dimension::of(compound.dimension));
                if asked != found {
                    let [kind, found] = [(asked, wanted.dimension[5]), (found, compound.dimension[5])]
                        .map(|(dimension, angle)| dimension.describe(angle != 0));
                    self.errors
                        .at(unit.area, say::wrong_dimension(wanted.what, &kind, &found));
                    return None;
                }
                Some(compound)
            }
        };
        let mut rows = Vec::new();
        for row in components {
            let parts = match (&row.kind, of_all) {
                (ExprKind::Vector { components, unit: None }, Some(compound)) => components
                    .iter()
                    .map(|part| self.scaled_literal(part, compound))
                    .collect::<Option<Vec<_>>>()?,
                (ExprKind::Vector { .. }, None) => self.components(row, Scope::Parameter, wanted)?.0,
                _ => {
                    self.errors.at(row.area, say::matrix_rows(wanted.what, wanted.unit));
                    return None;
                }
            };
            let Ok(parts) = <[Value; 3]>::try_from(parts) else {
                self.errors.at(row.area, say::matrix_rows(wanted.what, wanted.unit));
                return None;
            };
            rows.push(parts);
        }
        let rows = rows.try_into().ok();
        if rows.is_none() {
            self.errors.at(expr.area, say::matrix_rows(wanted.what, wanted.unit));
        }
        rows
    }
}

fn is_row(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Vector { .. })
}
