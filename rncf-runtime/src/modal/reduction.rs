//! The map from the unknowns of a scene with modal bodies to those of the same scene with all nodal
//! vectors, `X = X0 + T x`: the freedoms of a modal body follow from its modes, all others stay.

use super::body::ModalBody;
use crate::linalg::Pattern;

/// Freedoms of a modal body.
#[derive(Clone, Debug)]
pub struct Block {
    /// First of its unknowns in the scene with all nodal vectors.
    pub first: usize,
    /// Weights of its k modes in each of its freedoms.
    pub modes: Vec<f64>,
    /// `M^ab phi_ib` in each: the coordinates of given freedoms.
    pub momenta: Vec<f64>,
    /// Undeformed values.
    pub shape: Vec<f64>,
    /// Number of modes.
    pub count: usize,
    /// First of its modal coordinates.
    pub coordinate: usize,
}

impl Block {
    /// The block of a body whose first unknown is `first`.
    pub fn new(body: &ModalBody, first: usize) -> Self {
        let (nodal, k) = (&body.nodal, body.modes());
        let reduced = |full: &[f64], width: usize| {
            let mut rows = vec![0.0; nodal.freedoms * width];
            for (entries, values) in nodal.map.iter().zip(full.chunks_exact(width.max(1))) {
                for (unknown, factor) in entries {
                    let row = &mut rows[unknown * width..(unknown + 1) * width];
                    row.iter_mut()
                        .zip(values)
                        .for_each(|(sum, value)| *sum += factor * value);
                }
            }
            rows
        };
        Self {
            first,
            modes: reduced(&body.modes, k),
            momenta: reduced(&body.momenta, k),
            shape: reduced(&nodal.shape, 1),
            count: k,
            coordinate: 0,
        }
    }

    fn row(&self, freedom: usize) -> &[f64] {
        &self.modes[freedom * self.count..(freedom + 1) * self.count]
    }
}

/// What an unknown of the scene with all nodal vectors is.
#[derive(Clone, Copy, Debug)]
enum Origin {
    /// An unknown here too.
    Same(usize),
    /// A freedom of a block.
    Modal { block: usize, freedom: usize },
}

/// The map, and the patterns that follow from it.
#[derive(Clone, Debug)]
pub struct Reduction {
    origins: Vec<Origin>,
    blocks: Vec<Block>,
    unknowns: usize,
}

impl Reduction {
    /// Numbers the unknowns: `blocks` ascend, `unknowns` are those with all nodal vectors.
    pub fn new(mut blocks: Vec<Block>, unknowns: usize) -> Self {
        let mut origins = Vec::with_capacity(unknowns);
        let mut count = 0;
        for (index, block) in blocks.iter_mut().enumerate() {
            while origins.len() < block.first {
                origins.push(Origin::Same(count));
                count += 1;
            }
            block.coordinate = count;
            count += block.count;
            let freedoms = 0..block.shape.len();
            origins.extend(freedoms.map(|freedom| Origin::Modal { block: index, freedom }));
        }
        while origins.len() < unknowns {
            origins.push(Origin::Same(count));
            count += 1;
        }
        Self {
            origins,
            blocks,
            unknowns: count,
        }
    }

    /// Number of unknowns x.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// The blocks with their places.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The unknown here of one of X that is no freedom of a modal body.
    pub fn same(&self, unknown: usize) -> Option<usize> {
        match self.origins[unknown] {
            Origin::Same(place) => Some(place),
            Origin::Modal { .. } => None,
        }
    }

    /// First unknown and weights of one of X.
    fn weights(&self, unknown: usize) -> (usize, &[f64]) {
        match self.origins[unknown] {
            Origin::Same(place) => (place, &[1.0]),
            Origin::Modal { block, freedom } => (self.blocks[block].coordinate, self.blocks[block].row(freedom)),
        }
    }

    /// `X = T x`, and `+ X0` for positions.
    pub fn expand(&self, x: &[f64], is_position: bool, full: &mut Vec<f64>) {
        full.clear();
        full.extend(self.origins.iter().map(|&origin| match origin {
            Origin::Same(place) => x[place],
            Origin::Modal { block, freedom } => {
                let block = &self.blocks[block];
                let start = if is_position { block.shape[freedom] } else { 0.0 };
                let coordinates = &x[block.coordinate..];
                block
                    .row(freedom)
                    .iter()
                    .zip(coordinates)
                    .fold(start, |sum, (a, b)| sum + a * b)
            }
        }));
    }

    /// The unknowns that describe X best, in the norm of the mass matrix of each modal body.
    pub fn restrict(&self, full: &[f64], is_position: bool) -> Vec<f64> {
        let mut x = vec![0.0; self.unknowns];
        for (&origin, &value) in self.origins.iter().zip(full) {
            match origin {
                Origin::Same(place) => x[place] = value,
                Origin::Modal { block, freedom } => {
                    let block = &self.blocks[block];
                    let moved = if is_position {
                        value - block.shape[freedom]
                    } else {
                        value
                    };
                    let momenta = &block.momenta[freedom * block.count..];
                    for (sum, momentum) in x[block.coordinate..][..block.count].iter_mut().zip(momenta) {
                        *sum += momentum * moved;
                    }
                }
            }
        }
        x
    }

    /// `out = T^T F`
    pub fn project(&self, force: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for (unknown, value) in force.iter().enumerate() {
            let (first, weights) = self.weights(unknown);
            for (sum, weight) in out[first..].iter_mut().zip(weights) {
                *sum += weight * value;
            }
        }
    }

    /// Pattern of `T^T A T`, with all of the modal coordinates of one body.
    pub fn square(&self, pattern: &Pattern) -> Pattern {
        // Freedoms of a block all stand for its first one.
        let group = |unknown: usize| match self.origins[unknown] {
            Origin::Same(_) => unknown,
            Origin::Modal { block, .. } => self.blocks[block].first,
        };
        let groups = Pattern::new(
            pattern.rows(),
            pattern.columns(),
            pattern.places().map(|(row, column)| (group(row), group(column))),
        );
        let places = |unknown: usize| {
            let (first, weights) = self.weights(unknown);
            first..first + weights.len()
        };
        let pairs = groups.places().flat_map(|(row, column)| {
            let columns = places(column);
            places(row).flat_map(move |row| columns.clone().map(move |column| (row, column)))
        });
        let diagonal = (0..self.unknowns).map(|unknown| (unknown, unknown));
        Pattern::new(self.unknowns, self.unknowns, pairs.chain(diagonal))
    }

    /// Pattern of `T^T A` for columns that stay.
    pub fn rows(&self, pattern: &Pattern) -> Pattern {
        let places = |(row, column): (usize, usize)| {
            let (first, weights) = self.weights(row);
            (first..first + weights.len()).map(move |row| (row, column))
        };
        Pattern::new(self.unknowns, pattern.columns(), pattern.places().flat_map(places))
    }

    /// Values of `T^T A T`: `from` and `to` are the patterns of A and of the result.
    pub fn reduce_square(&self, from: &Pattern, values: &[f64], to: &Pattern, out: &mut [f64]) {
        out.fill(0.0);
        for ((row, column), &value) in from.places().zip(values) {
            if value == 0.0 {
                continue;
            }
            let ((i, rows), (j, columns)) = (self.weights(row), self.weights(column));
            for (place, weight) in columns.iter().enumerate() {
                // Rows of one body stand together in a column.
                if let Some(start) = to.find(i, j + place) {
                    for (entry, other) in out[start..].iter_mut().zip(rows) {
                        *entry += other * weight * value;
                    }
                }
            }
        }
    }

    /// Values of `T^T A` for columns that stay.
    pub fn reduce_rows(&self, from: &Pattern, values: &[f64], to: &Pattern, out: &mut [f64]) {
        out.fill(0.0);
        for ((row, column), &value) in from.places().zip(values) {
            let (first, weights) = self.weights(row);
            if let Some(start) = to.find(first, column) {
                for (entry, weight) in out[start..].iter_mut().zip(weights) {
                    *entry += weight * value;
                }
            }
        }
    }
}
