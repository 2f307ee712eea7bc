//! Generated models, integrated, against references that were written by hand from THEORY.

mod dense;
mod determinism;
mod free_flight;
mod gravity;
mod models;
mod orders;
mod pendulum;
mod reference;
mod runs;
mod spin_up;
mod steady;
