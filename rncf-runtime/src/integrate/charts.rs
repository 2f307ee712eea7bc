//! Charts of the free orientations within a step (THEORY 7.2): theta since the start of the step,
//! body increments dpi = T(theta) dtheta, and what follows from `theta' = T^-1(theta) w`.

use crate::linalg::Pattern;
use crate::space::{inverse_tangent_map, tangent_map, three};
use crate::system::State;

/// Largest rotation within one step, rad; the chart ends at twice that.
const LARGEST: f64 = std::f64::consts::PI;

/// The orientations of a system and their columns in its matrices.
pub(super) struct Charts {
    turns: Vec<usize>,
    /// Entries of the three columns of an orientation, row by row; `None` where not stored.
    rows: Vec<Vec<[Option<usize>; 3]>>,
}

impl Charts {
    /// Charts of the orientations with the given first unknowns, in matrices on `pattern`.
    pub(super) fn new(turns: &[usize], pattern: &Pattern) -> Self {
        let rows = turns.iter().map(|&turn| rows(turn, pattern)).collect();
        Self {
            turns: turns.to_vec(),
            rows,
        }
    }

    /// First unknown of every orientation.
    pub(super) fn turns(&self) -> &[usize] {
        &self.turns
    }

    /// Multiplies the columns of orientations in the matrix `values` by `T^-1`: a derivative with
    /// respect to theta becomes one with respect to right increments.
    pub(super) fn columns_to_increments(&self, state: &State, values: &mut [f64]) {
        for (&turn, rows) in self.turns.iter().zip(&self.rows) {
            let map = inverse_tangent_map(three(&state.x, turn));
            for places in rows {
                let old = places.map(|place| place.map_or(0.0, |place| values[place]));
                for (j, place) in places.iter().enumerate() {
                    if let Some(place) = *place {
                        values[place] = old[0] * map[(0, j)] + old[1] * map[(1, j)] + old[2] * map[(2, j)];
                    }
                }
            }
        }
    }

    /// Turns right increments, or angular velocities, in `y` into changes of theta: `T^-1 y`.
    pub(super) fn to_chart(&self, state: &State, y: &mut [f64]) {
        for &turn in &self.turns {
            let change = inverse_tangent_map(three(&state.x, turn)) * three(y, turn);
            y[turn..turn + 3].copy_from_slice(change.as_slice());
        }
    }

    /// Turns changes of theta in `y` into right increments: `T y`.
    pub(super) fn to_increments(&self, state: &State, y: &mut [f64]) {
        for &turn in &self.turns {
            let change = tangent_map(three(&state.x, turn)) * three(y, turn);
            y[turn..turn + 3].copy_from_slice(change.as_slice());
        }
    }

    /// `out = factor (w x w')` for orientations, 0 for numbers. theta''' = w'' + (w x w') / 2 at
    /// theta = 0: what the update of theta by `w` and `w'` alone misses.
    pub(super) fn curvature(&self, factor: f64, state: &State, out: &mut [f64]) {
        out.fill(0.0);
        for &turn in &self.turns {
            let bracket = three(&state.v, turn).cross(&three(&state.a, turn));
            out[turn..turn + 3].copy_from_slice((factor * bracket).as_slice());
        }
    }

    /// First unknown of an orientation that turned too far for its chart, if any.
    pub(super) fn overturned(&self, state: &State) -> Option<usize> {
        let far = |turn: &usize| three(&state.x, *turn).norm() > LARGEST;
        self.turns.iter().copied().find(far)
    }
}

/// The places of one orientation's columns in every row that has any.
fn rows(turn: usize, pattern: &Pattern) -> Vec<[Option<usize>; 3]> {
    let (start, end) = (pattern.starts()[turn], pattern.starts()[turn + 3]);
    let mut rows = pattern.indices()[start..end].to_vec();
    rows.sort_unstable();
    rows.dedup();
    rows.iter()
        .map(|&row| std::array::from_fn(|j| pattern.find(row, turn + j)))
        .collect()
}
