//! The ladder of fidelity: bodies in modes, in modes for small deformations, and rigid, against the whole bodies, THEORY
//! 8.2's table, and closed forms.

mod flight;
mod frequencies;
mod imported;
mod models;
mod spin_up;
mod timing;
