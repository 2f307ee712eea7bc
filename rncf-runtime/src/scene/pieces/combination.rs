//! Combinations of mass, damping and stiffness.

use crate::scene::bodies::nodal_mass::Transport;
use crate::space::{Matrix, inverse_tangent_map, three};
use crate::system::State;

/// What of `factors[0] M + factors[1] C + factors[2] K` is wanted.
#[derive(Clone, Debug)]
pub(crate) struct Combination {
    /// Factors of mass, damping and stiffness.
    pub factors: [f64; 3],
    /// For every orientation what multiplies its columns of M and C from the right; empty: nothing.
    pub maps: Vec<Matrix>,
}

impl Combination {
    /// One of the three matrices alone.
    pub fn only(place: usize) -> Self {
        let mut factors = [0.0; 3];
        factors[place] = 1.0;
        Self {
            factors,
            maps: Vec::new(),
        }
    }

    /// With the columns of M and C for changes of theta made those for right increments: T(theta)^-1.
    pub fn of_increments(factors: [f64; 3], turns: &[usize], state: &State) -> Self {
        let theta = |&turn: &usize| three(&state.x, turn);
        Self {
            factors,
            maps: turns.iter().map(|turn| inverse_tangent_map(theta(turn))).collect(),
        }
    }

    /// Derivative of inertia forces of vectors by vectors, `M^ab` times this, its mass part left out.
    pub fn block(&self, transport: &Transport) -> Matrix {
        let [_, g, k] = self.factors;
        let (coriolis, turning) = (transport.coriolis(), transport.turning());
        Matrix::from_fn(|i, j| g * coriolis[(i, j)] + k * turning[(i, j)])
    }
}
