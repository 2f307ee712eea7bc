//! From relative vectors back to nodal ones.

use super::builder::Builder;
use crate::lower::invariants::Blocks;
use crate::lower::quadratic::{base_vector, is_position};
use crate::symbolic::Id;

impl Builder<'_> {
    /// For every nodal vector the relative vectors that it moves and the factor.
    fn nodal_map(&mut self) -> Vec<Vec<(usize, Id)>> {
        let base = base_vector(&self.nodal);
        let relative: Vec<usize> = (0..self.nodal.len()).filter(|&index| index != base).collect();
        let mut map = vec![Vec::new(); self.nodal.len()];
        let minus = self.graph.negate(self.inverse_length);
        for (place, &index) in relative.iter().enumerate() {
            if is_position(self.nodal[index]) {
                map[index].push((place, self.inverse_length));
                map[base].push((place, minus));
            } else {
                map[index].push((place, self.graph.one()));
            }
        }
        map
    }

    pub(super) fn nodal_force(&mut self) -> Vec<(String, Id)> {
        let dimension = self.variant.dimension;
        let map = self.nodal_map();
        let mut outputs = Vec::new();
        for (index, parts) in map.iter().enumerate() {
            for c in 0..dimension {
                let terms: Vec<Id> = parts
                    .iter()
                    .map(|&(place, factor)| self.graph.multiply(factor, self.force[place][c]))
                    .collect();
                let sum = self.graph.sum(&terms);
                outputs.push((format!("force[{}]", index * dimension + c), sum));
            }
        }
        outputs
    }

    pub(super) fn nodal_blocks(&mut self, blocks: &Blocks, name: &str) -> Vec<(String, Id)> {
        let dimension = self.variant.dimension;
        let map = self.nodal_map();
        let size = map.len() * dimension;
        let mut outputs = Vec::new();
        for (i, left) in map.iter().enumerate() {
            for r in 0..dimension {
                for (j, right) in map.iter().enumerate() {
                    for c in 0..dimension {
                        let mut sum = self.graph.zero();
                        for &(p, a) in left {
                            for &(q, b) in right {
                                let factor = self.graph.multiply(a, b);
                                let term = self.graph.multiply(factor, blocks[p][q][r][c]);
                                sum = self.graph.add(sum, term);
                            }
                        }
                        let place = (i * dimension + r) * size + j * dimension + c;
                        outputs.push((format!("{name}[{place}]"), sum));
                    }
                }
            }
        }
        outputs
    }
}
