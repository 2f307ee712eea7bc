//! Modes about an equilibrium, and over a parameter or the spin.

pub(super) mod campbell;
mod finer;
mod kinks;
mod known;
mod looked;
pub(super) mod modes;
mod onsets;
pub(super) mod tracker;
