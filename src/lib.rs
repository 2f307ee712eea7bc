//! Referenced nodal coordinate formulation: flexible multibody models declared in Rust with
//! `model!`, derived, checked and specialised at build time, and integrated by a small runtime.
//!
//! * `model!` declares a model and generates a struct with its parameters as fields ([`Model`]).
//! * [`Model::build`] makes a scene ([`Scene`]), which is a [`System`].
//! * [`Integrator`] advances any system in time.
//! * Places, rotations and small matrices are those of [`nalgebra`]; [`space`] has what it lacks.
//! * `app` (feature `app`) is the command line: one line in an example's `main`.
//!
//! A mass of 10 kg on a spring of 40 N/m, 1 m long and stretched by half of that, swings with 2 rad/s:
//!
//! ```
//! use rncf::prelude::*;
//!
//! rncf::model! {
//!     pub model Swing {
//!         param stiffness = 40 N/m;
//!         rigid bob { mass = 10 kg; origin = [1.5, 0, 0] m; }
//!         spring coil = linear(bob, inertial, stiffness = stiffness, length = 1 m);
//!         output x = bob.x;
//!         run { t_end = 1 s; every = 0.1 s; }
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let swing = Swing { stiffness: 40.0, ..Swing::default() };
//! let mut scene = swing.scene::<Rncf>()?;
//! let start = scene.rest(0.0);
//! let mut row = vec![0.0; scene.output_columns()];
//! let mut integrator = Integrator::new(scene.as_mut(), start, 1.0, Method::Radau, Options::default())?;
//! while integrator.step()? != Stop::End {}
//! let state = integrator.state().clone();
//! integrator.system().outputs(&state, &mut row);
//! assert!((row[0] - (1.0 + 0.5 * f64::cos(2.0))).abs() < 1e-5);
//! # Ok(())
//! # }
//! ```

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
