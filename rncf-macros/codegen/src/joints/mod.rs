//! The joint library (THEORY 6): every kind lists its rows as expressions of markers.
//!
//! Primitives: **S** `P_i - P_j = 0`, **d1** `D_i . D_j = 0`, **d2** `D_i . (P_j - P_i) = 0`. The
//! first party carries the joint's axes (directions fixed in it), the second one the directions
//! that are normal or equal to them at t = 0. A party is a frame, a section of a flexible body, or a
//! place on a centre line, which has a tangent and no directions.

pub mod algebra;
mod builder;
mod coordinate;
mod kinds;
mod tilt;

pub use algebra::unit;
pub use builder::{Builder, Party, Rows};
pub use coordinate::{Angle, Slide, Turned};
pub use kinds::{Arguments, Axis, KINDS, Kind, clamp, corner, hold, hold_twist};
pub use tilt::Tilt;
