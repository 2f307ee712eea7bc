//! Bodies described by their lowest natural modes: the floating frame of reference, THEORY 3.2.
//! Nodal vectors are `q = q0 + phi_i p_i`; inertia comes from constants, Eqs. (15)-(20).

pub(crate) mod action;
#[cfg(test)]
mod arm;
mod body;
mod carried;
mod elastic;
mod elsewhere;
mod expansion;
mod export;
mod hanging;
mod held;
mod imported;
mod invariants;
mod linear;
mod locking;
mod reduction;
mod scene;
#[cfg(test)]
mod scene_tests;
mod softening;
mod sources;
#[cfg(test)]
mod tests;
mod view;

pub use scene::build_as;

/// Momentum and kinetic energy about an origin at rest.
#[cfg(test)]
pub(crate) fn kinetic_of(
    inertia: &crate::import::Inertia,
    spin: crate::space::Vector,
    p: &[f64],
    v: &[f64],
) -> (crate::space::Vector, f64) {
    let sums = inertia.carried(spin, p, v);
    (sums.momentum, sums.kinetic)
}
