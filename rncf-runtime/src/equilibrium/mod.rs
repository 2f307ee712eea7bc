//! Equilibria in uniform rotation or at rest (THEORY 8.1): `M a + f + C_x^T lambda = 0, C(x) = 0` with
//! the velocities and accelerations of the uniform motion, by continuation from the start or from a
//! guess.

mod assembled;
mod closed;
mod continuation;
mod critical;
mod distance;
mod matrix;
mod negative;
mod newton;
mod spun_up;
mod taken_along;
mod untied;

pub use crate::model::{Kind, Spin, Uniform};
pub use assembled::assembled;
pub use closed::closed;
pub use continuation::{
    CUTS, Continued, Equilibrium, continue_from, continue_holding, follow, glance, goes_back, is_nearer, sagged,
    settle, static_load, steady, unloaded,
};
pub use critical::{Critical, critical_factor};
pub use distance::distance;
pub use negative::Negative;
pub use taken_along::taken_along;
pub use untied::{untied, untied_directions};

#[cfg(test)]
mod tests;
