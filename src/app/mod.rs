//! The command line of a model: one line in an example's `main`.
//!
//! ```text
//! cargo run --release --example spin_up -- [run|steady|modes|campbell|static|chart|advise|sweep|optimise|explain] [name=value ...] [flags]
//! ```
//!
//! [`main`] reads the line, does what it says, shows progress, and writes tables (CSV), the summary (JSON)
//! and the report (HTML). [`run`], [`steady`], [`modes`], [`campbell`], [`static_equilibria`] and [`advise()`] do the
//! same work in memory and print nothing.
//!
//! A ball of 2 kg hangs on a spring of 50 N/m that is 1 m long. It rests 2 * 9.81 / 50 m below that, and moves up and down with
//! 5 rad/s:
//!
//! ```
//! use rncf::app::{EquilibriumSettings, RunSettings, modes, run, static_equilibria};
//!
//! rncf::model! {
//!     pub model Hanging {
//!         rigid ball { mass = 2 kg; origin = [0, 0, -1] m; }
//!         spring coil = linear(ball, inertial, stiffness = 50 N/m, length = 1 m);
//!         load weight = gravity([0, 0, -9.81] m/s^2);
//!         output z = ball.z;
//!         run { t_end = 1 s; every = 0.1 s; }
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let model = Hanging::default();
//! let rest = 1.0 + 2.0 * 9.81 / 50.0;
//!
//! let found = static_equilibria(&model, &EquilibriumSettings::default())?;
//! assert!((found.history.values.last().unwrap() + rest).abs() < 1e-9);
//!
//! let found = modes(&model, &EquilibriumSettings::default())?;
//! assert!(found.modes.iter().any(|mode| (mode.im - 5.0).abs() < 1e-6));
//!
//! let found = run(&model, &RunSettings::default())?;
//! assert_eq!(found.history.rows(), 11);
//! assert!((found.history.values[10] + rest - (rest - 1.0) * f64::cos(5.0)).abs() < 1e-5);
//! # Ok(())
//! # }
//! ```

mod commands;
mod entry;
mod equilibria;
mod judged;
mod line;
mod machine;
mod modal;
mod page;
mod pictures;
#[cfg(feature = "python")]
pub mod python;
mod results;
mod runs;
mod writing;

#[cfg(test)]
mod testing;

pub use commands::advise::{Advised, AdvisedRung, Wanted, advise};
pub use entry::{Entry, Line, enter, main, main_among, main_as};
pub use equilibria::continuation::EquilibriumProgress;
pub use equilibria::steady::{equilibria, static_equilibria, steady};
pub use judged::finer::Judging;
pub use line::command::Command;
pub use machine::clock::Seconds;
pub use modal::campbell::{campbell, campbell_watched};
pub use modal::modes::modes;
pub use page::charts;
pub use page::figure::Figure;
pub use page::map::{Axis, Cells, Map};
pub use pictures::{Pictures, Scale, Shapes};
pub use results::campbell::{Campbell, Crossing, Onset};
pub use results::envelopes::{BodyEnvelope, Envelopes, Peak};
pub use results::equilibria::{Equilibria, EquilibriumSettings, Range};
pub use results::error::RunError;
pub use results::history::{Column, Extreme, History};
pub use results::incomplete::Incomplete;
pub use results::modes::{Inertial, Modes, SeenMode};
pub use results::run::{Progress, RunResult, RunSettings, StepTaken};
pub use runs::run::{run, run_watched};
