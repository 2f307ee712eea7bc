//! Saddle-point systems `[[K, B], [C, 0]]` with a border: LU of the leading block of K, dense Schur
//! complement of its border and of the multipliers.

use super::dense::Dense;
use super::lu::Lu;
use super::pattern::Pattern;
use super::scalar::Scalar;

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

/// Factorization of `[[K, B], [C, 0]]` in the field `T` (`f64` or `c64`); the patterns are analysed
/// once.
///
/// K is sparse on a fixed pattern. Its leading part is regular by itself, its border (the last
/// unknowns, free frames and rigid bodies) may be full and need not make K regular: then the
/// constraints must. B (forces of the multipliers) and `C^T` (derivatives of the constraints) are
/// real and have one pattern; they are equal where unknowns are varied as they are forced.
///
/// ```text
/// S = [[K_bb, B_b], [C_b, 0]] - [K_bi; C_i] K_ii^-1 [K_ib, B_i],  i: leading unknowns, b: border
/// ```
#[derive(Debug)]
pub struct Saddle<T> {
    /// Number of leading unknowns.
    inner: usize,
    border: usize,
    leading: Lu<T>,
    /// Entries of K in the leading block, and memory for their values.
    leading_entries: Vec<usize>,
    leading_values: Vec<T>,
    /// Entries of K with row and column in the border, of B and `C^T` with border row and constraint;
    /// counted in the Schur complement.
    corner: Vec<(usize, usize, usize)>,
    corner_constraints: Vec<(usize, usize, usize)>,
    /// Columns of `[K_ib, B_i]` and rows of `[K_bi; C_i]`, which follow.
    sides: Vec<Side<T>>,
    schur: Dense<T>,
    /// Right sides and solution of the Schur complement.
    work: Vec<T>,
}

/// One border unknown or multiplier seen from the leading unknowns.
#[derive(Debug)]
struct Side<T> {
    /// Leading unknowns and entries (of K, or of B) of its column.
    column: Vec<(usize, usize)>,
    /// Leading unknowns and entries (of K, or of `C^T`) of its row.
    row: Vec<(usize, usize)>,
    /// Values of the row.
    values: Vec<T>,
    /// `K_ii^-1` times its column; empty if that has no entries.
    response: Vec<T>,
}

impl<T: Scalar> Saddle<T> {
    /// Analyses the pattern of K (n x n), whose last `border` unknowns form the border, and that of
    /// B and `C^T` (n x m).
    ///
    /// # Panics
    /// If the shapes do not fit: a defect of the caller.
    pub fn new(block: &Pattern, border: usize, constraint_transposed: &Pattern) -> Self {
        assert_eq!(block.rows(), constraint_transposed.rows(), "K and C^T have equal rows");
        assert!(border <= block.rows(), "the border is a part of K");
        let (n, m) = (block.rows(), constraint_transposed.columns());
        let inner = n - border;
        let mut sides: Vec<Side<T>> = (0..border + m).map(|_| Side::default()).collect();
        let (mut leading_entries, mut leading) = (Vec::new(), Vec::new());
        let (mut corner, mut corner_constraints) = (Vec::new(), Vec::new());
        for (entry, row, column) in entries(block) {
            match (row < inner, column < inner) {
                (true, true) => {
                    leading_entries.push(entry);
                    leading.push((row, column));
                }
                (true, false) => sides[column - inner].column.push((row, entry)),
                (false, true) => sides[row - inner].row.push((column, entry)),
                (false, false) => corner.push((entry, row - inner, column - inner)),
            }
        }
        for (entry, row, column) in entries(constraint_transposed) {
            if row < inner {
                sides[border + column].column.push((row, entry));
                sides[border + column].row.push((row, entry));
            } else {
                corner_constraints.push((entry, row - inner, border + column));
            }
        }
        for side in &mut sides {
            side.values = vec![T::default(); side.row.len()];
            side.response = vec![T::default(); if side.column.is_empty() { 0 } else { inner }];
        }
        Self {
            inner,
            border,
            leading: Lu::new(&Pattern::new(inner, inner, leading)),
            leading_values: vec![T::default(); leading_entries.len()],
            leading_entries,
            corner,
            corner_constraints,
            sides,
            schur: Dense::new(border + m),
            work: vec![T::default(); border + m],
        }
    }

    /// Factors `[[K, C^T], [C, 0]]`: as [`Saddle::factor`] with B = `C^T`.
    ///
    /// # Errors
    /// As of [`Saddle::factor`].
    pub fn factor_symmetric(&mut self, block: &[T], constraint_transposed: &[f64]) -> Result<(), Singular> {
        self.factor(block, constraint_transposed, constraint_transposed)
    }

    /// Factors `[[K, B], [C, 0]]` by the values of K, B and `C^T` on their patterns.
    ///
    /// # Errors
    /// The unknown around which K is singular (and not fixed by constraints), or the constraint that
    /// is redundant or empty: the last one of those that are found to depend on each other.
    pub fn factor(&mut self, block: &[T], forces: &[f64], constraint_transposed: &[f64]) -> Result<(), Singular> {
        for (value, &entry) in self.leading_values.iter_mut().zip(&self.leading_entries) {
            *value = block[entry];
        }
        self.leading.factor(&self.leading_values).map_err(Singular::Unknown)?;
        for (index, side) in self.sides.iter_mut().enumerate() {
            let of_k = index < self.border;
            for (value, &(_, entry)) in side.values.iter_mut().zip(&side.row) {
                *value = if of_k {
                    block[entry]
                } else {
                    T::real(constraint_transposed[entry])
                };
            }
            if !side.column.is_empty() {
                side.response.fill(T::default());
                for &(row, entry) in &side.column {
                    side.response[row] = if of_k { block[entry] } else { T::real(forces[entry]) };
                }
                self.leading.solve(&mut side.response);
            }
        }
        self.fill_schur(block, forces, constraint_transposed);
        self.schur.factor().map_err(|index| {
            if index < self.border {
                Singular::Unknown(self.inner + index)
            } else {
                Singular::Constraint(index - self.border)
            }
        })
    }

    fn fill_schur(&mut self, block: &[T], forces: &[f64], constraint_transposed: &[f64]) {
        self.schur.clear();
        for &(entry, row, column) in &self.corner {
            self.schur.add(row, column, block[entry], block[entry].size());
        }
        for &(entry, row, column) in &self.corner_constraints {
            let (force, derivative) = (forces[entry], constraint_transposed[entry]);
            self.schur.add(row, column, T::real(force), force.abs());
            self.schur.add(column, row, T::real(derivative), derivative.abs());
        }
        for (j, of) in self
            .sides
            .iter()
            .enumerate()
            .filter(|(_, side)| !side.column.is_empty())
        {
            for (i, side) in self.sides.iter().enumerate() {
                let (mut sum, mut terms) = (T::default(), 0.0);
                for (&(column, _), &value) in side.row.iter().zip(&side.values) {
                    let term = value * of.response[column];
                    sum += term;
                    terms += term.size();
                }
                self.schur.add(i, j, -sum, terms);
            }
        }
    }

    /// Solves in place: on entry the right sides of the dynamic and of the constraint rows, on
    /// return the unknowns and the multipliers.
    pub fn solve(&mut self, dynamics: &mut [T], constraints: &mut [T]) {
        let (leading, border) = dynamics.split_at_mut(self.inner);
        self.leading.solve(leading);
        self.work[..self.border].copy_from_slice(border);
        self.work[self.border..].copy_from_slice(constraints);
        for (right, side) in self.work.iter_mut().zip(&self.sides) {
            for (&(column, _), &value) in side.row.iter().zip(&side.values) {
                *right -= value * leading[column];
            }
        }
        self.schur.solve(&mut self.work);
        border.copy_from_slice(&self.work[..self.border]);
        constraints.copy_from_slice(&self.work[self.border..]);
        for (&known, side) in self.work.iter().zip(&self.sides) {
            for (value, &response) in leading.iter_mut().zip(&side.response) {
                *value -= response * known;
            }
        }
    }
}

impl<T> Default for Side<T> {
    fn default() -> Self {
        Self {
            column: Vec::new(),
            row: Vec::new(),
            values: Vec::new(),
            response: Vec::new(),
        }
    }
}

/// Entries of a pattern with their rows and columns.
fn entries(pattern: &Pattern) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..pattern.columns()).flat_map(move |column| {
        (pattern.starts()[column]..pattern.starts()[column + 1])
            .map(move |entry| (entry, pattern.indices()[entry], column))
    })
}

#[cfg(test)]
#[path = "saddle_tests.rs"]
mod tests;
