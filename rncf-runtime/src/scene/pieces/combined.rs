//! Sums of contributions to a combination of the matrices of a scene.

use std::sync::Arc;

use super::combination::Combination;
use crate::scene::numbering::turned::TurnedColumns;
use crate::system::Sums;

/// Adds contributions to a combination of the matrices of a scene.
pub(crate) struct Combined<'a> {
    pub combination: &'a Combination,
    /// Columns of orientations on the pattern.
    pub turned: Arc<[TurnedColumns]>,
    pub values: &'a mut [f64],
}

impl Combined<'_> {
    /// Adds to an entry of M or C: that of an orientation's column goes to all three columns.
    fn add_mapped(&mut self, entry: usize, value: f64) {
        for (turned, map) in self.turned.iter().zip(&self.combination.maps) {
            let starts = turned.starts;
            if (starts[0]..starts[3]).contains(&entry) {
                let from = (1..3).filter(|&column| entry >= starts[column]).count();
                for (place, factor) in turned.places[entry - starts[0]].into_iter().zip(&map.row(from)) {
                    if let Some(place) = place {
                        self.values[place] += factor * value;
                    }
                }
                return;
            }
        }
        self.values[entry] += value;
    }
}

impl Sums for Combined<'_> {
    fn mass(&mut self, entry: usize, value: f64) {
        self.add_mapped(entry, self.combination.factors[0] * value);
    }

    fn damping(&mut self, entry: usize, value: f64) {
        self.add_mapped(entry, self.combination.factors[1] * value);
    }

    fn stiffness(&mut self, entry: usize, value: f64) {
        self.values[entry] += self.combination.factors[2] * value;
    }

    fn all_stiffness(&mut self) -> (&mut [f64], f64) {
        (self.values, self.combination.factors[2])
    }

    fn all_damping(&mut self) -> (&mut [f64], f64) {
        (self.values, self.combination.factors[1])
    }
}
