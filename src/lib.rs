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
//!
//! [`equilibrium`] and [`modes`] ask a scene without integrating it. The same ball hangs at rest by `m g / k` below the
//! coil's length, and swings there along the coil with 2 rad/s, and as a pendulum with `sqrt(g / l)`:
//!
//! ```
//! use rncf::equilibrium::{Uniform, static_load};
//! use rncf::modes::{Wanted, modes};
//! use rncf::prelude::*;
//!
//! rncf::model! {
//!     pub model Hanging {
//!         rigid bob { mass = 10 kg; origin = [0, 0, -1] m; }
//!         spring coil = linear(bob, inertial, stiffness = 40 N/m, length = 1 m);
//!         load weight = gravity([0, 0, -9.81] m/s^2);
//!         output z = bob.z;
//!         run { t_end = 1 s; every = 0.1 s; }
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let mut scene = Hanging::default().scene::<Rncf>()?;
//! let found = static_load(scene.as_mut(), 0.0)?;
//! let state = found.state().unwrap();
//! let mut row = vec![0.0; scene.output_columns()];
//! scene.outputs(state, &mut row);
//! let length = 1.0 + 10.0 * 9.81 / 40.0;
//! assert!((row[0] + length).abs() < 1e-9);
//!
//! let found = modes(scene.as_mut(), &Uniform::at_rest(0.0), state, Wanted { count: 6 })?;
//! for frequency in [2.0, f64::sqrt(9.81 / length)] {
//!     assert!(found.iter().any(|mode| (mode.im - frequency).abs() < 1e-6));
//! }
//! # Ok(())
//! # }
//! ```

/// # Examples
/// What stands in a library is that of every model which takes it in, here one with two pendulums:
///
/// ```standalone_crate
/// use rncf::prelude::*;
///
/// mod parts {
///     rncf::library! {
///         /// What our machines are made of.
///         pub library parts {
///             component Pendulum(length: m) {
///                 rigid bob { mass = 2 kg; origin = [0 m, 0 m, -length]; }
///                 joint rod = distance(bob, inertial, length = length);
///                 output height = bob.z;
///             }
///         }
///     }
/// }
///
/// rncf::model! {
///     use crate::parts::parts;
///     pub model Clock {
///         part left = Pendulum(length = 1 m);
///         part right = Pendulum(length = 2 m);
///         load weight = gravity([0, 0, -10] m/s^2);
///         run { t_end = 1 s; every = 0.5 s; }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut scene = Clock::default().scene::<Rncf>()?;
/// let mut row = vec![0.0; scene.output_columns()];
/// let start = scene.rest(0.0);
/// scene.outputs(&start, &mut row);
/// assert_eq!(row, [-1.0, -2.0]);
/// # Ok(())
/// # }
/// ```
pub use rncf_macros::library;
/// # Examples
/// Params are fields in SI units; the model's own documentation is that of the struct:
///
/// ```
/// rncf::model! {
///     /// A ball that is thrown.
///     pub model Throw {
///         /// Its speed upwards.
///         param speed = 36 km/h;
///         rigid ball { mass = 1 kg; velocity = [0, 0, speed] m/s; }
///         load weight = gravity([0, 0, -10] m/s^2);
///         output height = ball.z;
///         run { t_end = 1 s; every = 0.5 s; }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use rncf::prelude::*;
/// assert_eq!(Throw::default().speed, 10.0);
/// let mut scene = Throw { speed: 20.0 }.scene::<Rncf>()?;
/// let start = scene.rest(0.0);
/// let mut integrator = Integrator::new(scene.as_mut(), start, 1.0, Method::Radau, Options::default())?;
/// while integrator.step()? != Stop::End {}
/// let mut height = [0.0];
/// let state = integrator.state().clone();
/// integrator.system().outputs(&state, &mut height);
/// assert!((height[0] - 15.0).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// A wrong model does not compile, and the message points at the word:
///
/// ```compile_fail
/// rncf::model! {
///     pub model Wrong {
///         rigid ball { mass = 1 m; }
///         output height = ball.z;
///         run { t_end = 1 s; }
///     }
/// }
/// ```
pub use rncf_macros::model;
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
