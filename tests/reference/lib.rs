//! References written by hand from THEORY.md alone, as oracles of the tests: nothing here knows the generator.
//!
//! - [`quadrature`], [`element`], [`tensor`], [`inertia`]: the Hermite centre-line element (THEORY 5.1, 2) as general
//!   code with run-time loops; also the yardstick of the benches.
//! - [`spin_up`], [`beam`], [`rotating_beam`], [`inertial_beam`]: the spin-up beam (THEORY 9.1) in the rotating and in
//!   the inertial frame, as first-order systems.
//! - [`free_cable`]: the cable of THEORY 9.6 in free flight, and what it keeps.
//! - [`swing`]: another motion of the same beam, for scenes that are nobody's example.
//! - [`pendulum`]: the planar pendulum (THEORY 10, T1) with its exact multiplier.
//! - [`heavy_top`], [`governor`]: mechanisms of BENCHMARKS 3 and 6 in coordinates without constraints.
//! - [`system`], [`integrate`]: what a first-order system offers, and its integration by russell_ode.
//! - [`table`]: the published numbers and recorded histories.
//!
//! SI units throughout. Errors are plain sentences that name the argument.

pub mod beam;
pub mod dense;
pub mod element;
pub mod free_cable;
pub mod governor;
pub mod heavy_top;
pub mod inertia;
pub mod inertial_beam;
pub mod integrate;
pub mod pendulum;
pub mod quadrature;
pub mod rotating_beam;
pub mod spin_up;
pub mod swing;
pub mod system;
pub mod table;
pub mod tensor;

/// Result of this crate: the error is one sentence that names what is wrong and what to do.
pub type Result<T> = std::result::Result<T, String>;
