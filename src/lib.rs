//! Referenced nodal coordinate formulation: flexible multibody models declared in Rust with
//! `model!`, derived, checked and specialised at build time, and integrated by a small runtime.
//!
//! * `model!` declares a model and generates a struct with its parameters as fields ([`Model`]).
//! * [`Model::build`] makes a scene ([`Scene`]), which is a [`System`].
//! * [`Integrator`] advances any system in time.
//! * Places, rotations and small matrices are those of [`nalgebra`]; [`space`] has what it lacks.
//! * `app` (feature `app`) is the command line: one line in an example's `main`.

pub use rncf_macros::{library, model};
pub use rncf_runtime::*;

#[cfg(feature = "app")]
pub mod app;

/// What a program that builds and integrates models usually names.
pub mod prelude {
    pub use rncf_runtime::{
        Ancf, Formulation, Integrator, Joints, Method, Model, Options, Rncf, Scene, Start, State, StepSize, Stop,
        System,
    };
}
