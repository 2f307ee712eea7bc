//! References written by hand from THEORY.md alone, as oracles of the tests: nothing here knows the generator but
//! [`shared`], a library that models of tests take in.
//!
//! - [`quadrature`], [`element`], [`tensor`], [`inertia`]: the Hermite centre-line element (THEORY 5.1, 2) as general
//!   code with run-time loops; also the yardstick of the benches.
//! - [`spin_up`], [`beam`], [`rotating_beam`], [`inertial_beam`]: the spin-up beam (THEORY 9.1) in the rotating and in
//!   the inertial frame, as first-order systems.
//! - [`free_cable`]: the cable of THEORY 9.6 in free flight, and what it keeps.
//! - [`swing`]: another motion of the same beam, for scenes that are nobody's example.
//! - [`pendulum`]: the planar pendulum (THEORY 10, T1) with its exact multiplier.
//! - [`heavy_top`], [`governor`]: mechanisms of THEORY 9.7 in coordinates without constraints.
//! - [`section_beam`], [`section_inertia`]: the ten-vector element (THEORY 5.2), also a yardstick of the benches.
//! - [`section_chain`], [`section_statics`], [`section_modes`]: chains of it in static and relative equilibrium, and
//!   small motions about it.
//! - [`rod`]: the geometrically exact rod of THEORY 9.7.
//! - [`timoshenko`]: natural frequencies of the uniform beam with shear and rotary inertia.
//! - [`galerkin_rotor`]: the rotating cantilever on a hub (THEORY 8.2).
//! - [`dense`], [`banded`], [`symmetric`]: the linear algebra of all that.
//! - [`system`], [`integrate`]: what a first-order system offers, and its integration by russell_ode.
//! - [`tangents`]: the derivatives of a whole scene against differences.
//! - [`fit`]: one oscillation in a history, by least squares.
//! - [`table`]: the published numbers and recorded histories.
//!
//! SI units throughout. Errors are plain sentences that name the argument.

pub mod banded;
pub mod beam;
pub mod dense;
pub mod element;
pub mod fit;
pub mod free_cable;
pub mod galerkin_rotor;
pub mod governor;
pub mod heavy_top;
pub mod inertia;
pub mod inertial_beam;
pub mod integrate;
pub mod motor;
pub mod pendulum;
pub mod quadrature;
pub mod rod;
pub mod rotating_beam;
pub mod section_beam;
pub mod section_chain;
pub mod section_inertia;
pub mod section_modes;
pub mod section_statics;
pub mod shared;
pub mod spin_up;
pub mod swing;
pub mod symmetric;
pub mod system;
pub mod table;
pub mod tangents;
pub mod tensor;
pub mod timoshenko;

/// Result of this crate: the error is one sentence that names what is wrong and what to do.
pub type Result<T> = std::result::Result<T, String>;
