//! The matrix of an equilibrium in units in which it can be factored, and its negative directions.

use super::negative::Negative;
use super::newton::Newton;
use crate::linalg::{negative_eigenvalues, power_of_two};
use crate::model::{Kind, Uniform};

/// Most rows of a matrix whose eigenvalues are counted.
const LARGEST_COUNTED: usize = 400;
/// Part of the largest stiffness, times the sizes, that is the least unit of a row.
const LEAST_STIFF: f64 = 1e-12;
/// Skew part of an equilibrated matrix that counts as round-off.
const SKEW: f64 = 1e-9;

impl Newton {
    /// Factors the matrix. Beside conditions between lengths the stiffness of a small machine in SI is nothing: where it is below 1 J, over the sizes of the
    /// unknowns, rows and columns have powers of two as units, in which it is of order 1, as the conditions are.
    ///
    /// # Errors
    /// The row at which it is singular.
    pub(super) fn factor(&mut self) -> Result<(), usize> {
        let energy = self.stiffest(|_| true);
        self.scales.clear();
        if energy <= 0.0 || energy >= 1.0 {
            return self.lu.factor(&self.values);
        }
        let root = power_of_two(energy.sqrt());
        let places: Vec<_> = self.lu.pattern().places().collect();
        self.scales.extend(
            self.inverse_sizes
                .iter()
                .map(|inverse| 1.0 / (root * power_of_two(*inverse))),
        );
        let conditions = self.largest_of_conditions(&places, &self.scales);
        self.scales
            .extend(conditions.iter().map(|largest| 1.0 / power_of_two(*largest)));
        let scaled: Vec<f64> = places
            .iter()
            .zip(&self.values)
            .map(|(&(row, column), value)| value * self.scales[row] * self.scales[column])
            .collect();
        self.lu.factor(&scaled)
    }

    /// Solves with the matrix that was factored last.
    pub(super) fn solve_with(&mut self, right: &mut [f64]) {
        right
            .iter_mut()
            .zip(&self.scales)
            .for_each(|(value, scale)| *value *= scale);
        self.lu.solve(right);
        right
            .iter_mut()
            .zip(&self.scales)
            .for_each(|(value, scale)| *value *= scale);
    }

    /// The increments that the right side in their place asks for.
    pub(super) fn solve_increments(&mut self) {
        let mut increments = std::mem::take(&mut self.increments);
        self.solve_with(&mut increments);
        self.increments = increments;
    }

    /// Largest entries of the conditions, with these units of the unknowns.
    fn largest_of_conditions(&self, places: &[(usize, usize)], units: &[f64]) -> Vec<f64> {
        let unknowns = self.inverse_sizes.len();
        let mut largest = vec![0.0_f64; self.lu.pattern().columns() - unknowns];
        for (&(row, column), value) in places.iter().zip(&self.values) {
            if row >= unknowns && column < unknowns {
                let largest = &mut largest[row - unknowns];
                *largest = largest.max((value * units[column]).abs());
            }
        }
        largest
    }

    /// Largest energy of a stiffness over the sizes of its unknowns, J, in some rows, as those of a phase condition:
    /// forces that are in balance by themselves leave round-off of this.
    pub(super) fn stiffest(&self, is_one: impl Fn(usize) -> bool) -> f64 {
        self.largest_energy(&self.tangent.stiffness, is_one)
    }

    /// The same of the mass, of all rows: twice the kinetic energy of a size in a second, J.
    pub(super) fn heaviest(&self) -> f64 {
        self.largest_energy(&self.tangent.mass, |_| true)
    }

    fn largest_energy(&self, values: &[f64], is_one: impl Fn(usize) -> bool) -> f64 {
        let mut largest: f64 = 0.0;
        for (&(row, column), value) in self.columns.iter().zip(values) {
            if is_one(row) && !self.is_state[row] && !self.is_state[column] {
                let sizes = self.inverse_sizes[row] * self.inverse_sizes[column];
                largest = largest.max((value / sizes).abs());
            }
        }
        largest
    }

    /// What is known of the negative directions where the iteration ended; of a relative equilibrium the determinant alone tells them.
    pub fn count(&self, at: &Uniform) -> Negative {
        let pattern = self.lu.pattern();
        let size = pattern.columns();
        let bordering = size - self.inverse_sizes.len();
        if at.kind == Kind::Static
            && let Some(whole) = self.symmetric().filter(|_| size <= LARGEST_COUNTED)
            && let Ok(negative) = negative_eigenvalues(size, &whole)
        {
            // Every bordering row has one negative eigenvalue of its own.
            return Negative::Counted(negative.saturating_sub(bordering));
        }
        let is_odd = self.lu.is_determinant_negative() == bordering.is_multiple_of(2);
        if is_odd { Negative::Odd } else { Negative::Even }
    }

    /// The whole matrix, equilibrated by a congruence; `None` where it is not symmetric. Rows of unknowns have their stiffness as unit, and those of
    /// conditions what follows from that: beside entries of length 1 the stiffness of a small machine in SI is nothing.
    fn symmetric(&self) -> Option<Vec<f64>> {
        let pattern = self.lu.pattern();
        let (size, unknowns) = (pattern.columns(), self.inverse_sizes.len());
        let places: Vec<_> = pattern.places().collect();
        let energy = self.stiffest(|_| true);
        let least = |inverse: &f64| LEAST_STIFF * energy.max(f64::MIN_POSITIVE) * inverse * inverse;
        let mut largest: Vec<f64> = self.inverse_sizes.iter().map(least).collect();
        for (&(row, column), value) in places.iter().zip(&self.values) {
            if row < unknowns && column < unknowns {
                largest[row] = largest[row].max(value.abs());
            }
        }
        let mut factors: Vec<f64> = largest.iter().map(|largest| 1.0 / largest.sqrt()).collect();
        let of_conditions = self.largest_of_conditions(&places, &factors);
        factors.extend(of_conditions.iter().map(|largest| 1.0 / largest));
        let mut whole = vec![0.0; size * size];
        for (&(row, column), value) in places.iter().zip(&self.values) {
            whole[row * size + column] = value * factors[row] * factors[column];
        }
        let skew = |&(row, column): &(usize, usize)| (whole[row * size + column] - whole[column * size + row]).abs();
        places.iter().all(|place| skew(place) <= SKEW).then_some(whole)
    }
}
