//! Modes about an equilibrium, and over a parameter or the spin.

pub(super) mod campbell;
mod finer;
pub(super) mod modes;
pub(super) mod tracker;
