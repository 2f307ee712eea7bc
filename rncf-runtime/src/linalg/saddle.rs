//! Saddle-point systems `[[K, C^T], [C, 0]]`: LU of K, dense Schur complement of C.

use super::banded::Banded;
use super::lu::Lu;
use super::pattern::Pattern;
use super::scalar::Scalar;

/// Pivots of the scaled Schur complement up to here are round-off.
const SMALLEST_PIVOT: f64 = 64.0 * f64::EPSILON;

/// The matrix has no unique solution; the unknown or constraint at which it was noticed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// Around this unknown.
    Unknown(usize),
    /// Around this constraint: redundant, or not fixing anything.
    Constraint(usize),
    /// Somewhere.
    Somewhere,
}

/// Factorization of `[[K, C^T], [C, 0]]` with K sparse on a fixed pattern and nonsingular by
/// itself, in the field `T` (`f64` or `c64`); the patterns are analysed once.
#[derive(Debug)]
pub struct Saddle<T> {
    block: Lu<T>,
    constraints: Pattern,
    /// `C^T` of the last factorization.
    values: Vec<f64>,
    /// `K^-1 C^T`, column after column.
    responses: Vec<T>,
    /// Factors of the scaled `C K^-1 C^T`.
    schur: Banded<T>,
    /// Its scale: row and column i are divided by `scale[i]`.
    scale: Vec<f64>,
}

impl<T: Scalar> Saddle<T> {
    /// Analyses the pattern of K (n x n) and that of `C^T` (n x m).
    ///
    /// # Panics
    /// If the shapes do not fit: a defect of the caller.
    pub fn new(block: &Pattern, constraint_transposed: &Pattern) -> Self {
        assert_eq!(block.rows(), constraint_transposed.rows(), "K and C^T have equal rows");
        let (n, m) = (block.rows(), constraint_transposed.columns());
        Self {
            block: Lu::new(block),
            constraints: constraint_transposed.clone(),
            values: vec![0.0; constraint_transposed.entries()],
            responses: vec![T::default(); n * m],
            schur: Banded::new(m, m.saturating_sub(1)),
            scale: vec![1.0; m],
        }
    }

    /// Factors the values of K and `C^T` on their patterns.
    ///
    /// # Errors
    /// The unknown around which K is singular, or the constraint that is redundant or empty.
    pub fn factor(&mut self, block: &[T], constraint_transposed: &[f64]) -> Result<(), Singular> {
        self.block.factor(block).map_err(Singular::Unknown)?;
        self.values.copy_from_slice(constraint_transposed);
        let (n, m) = (self.constraints.rows(), self.constraints.columns());
        let starts = self.constraints.starts();
        for j in 0..m {
            let response = &mut self.responses[j * n..(j + 1) * n];
            response.fill(T::default());
            let mut scale = 0.0;
            for entry in starts[j]..starts[j + 1] {
                response[self.constraints.indices()[entry]] = T::real(self.values[entry]);
            }
            self.block.solve(response);
            for entry in starts[j]..starts[j + 1] {
                scale += self.values[entry].abs() * response[self.constraints.indices()[entry]].size();
            }
            self.scale[j] = scale.sqrt();
            if !(scale > 0.0 && scale.is_finite()) {
                return Err(Singular::Constraint(j));
            }
        }
        self.schur.values().fill(T::default());
        for j in 0..m {
            for i in 0..m {
                let response = &self.responses[j * n..(j + 1) * n];
                let value = row_times(&self.constraints, &self.values, i, response);
                let place = self.schur.place(i, j);
                self.schur.values()[place] = value.times(1.0 / (self.scale[i] * self.scale[j]));
            }
        }
        self.schur.factor(SMALLEST_PIVOT).map_err(Singular::Constraint)
    }

    /// Solves in place: on entry the right sides of the dynamic and of the constraint rows, on
    /// return the unknowns and the multipliers.
    pub fn solve(&mut self, dynamics: &mut [T], constraints: &mut [T]) {
        let (n, m) = (self.constraints.rows(), self.constraints.columns());
        self.block.solve(dynamics);
        for i in 0..m {
            let free = row_times(&self.constraints, &self.values, i, dynamics);
            constraints[i] = (free - constraints[i]).times(1.0 / self.scale[i]);
        }
        self.schur.solve(constraints);
        for j in 0..m {
            constraints[j] = constraints[j].times(1.0 / self.scale[j]);
            for (value, &response) in dynamics.iter_mut().zip(&self.responses[j * n..(j + 1) * n]) {
                *value -= response * constraints[j];
            }
        }
    }
}

/// Row i of C times x.
fn row_times<T: Scalar>(pattern: &Pattern, values: &[f64], i: usize, x: &[T]) -> T {
    let mut sum = T::default();
    for entry in pattern.starts()[i]..pattern.starts()[i + 1] {
        sum += x[pattern.indices()[entry]].times(values[entry]);
    }
    sum
}

#[cfg(test)]
#[path = "saddle_tests.rs"]
mod tests;
