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

mod accumulated;
mod advise;
mod agreement;
mod arguments;
#[cfg(test)]
mod arguments_tests;
mod balanced;
mod buckling;
mod campbell;
mod card;
mod cautions;
mod chart;
pub mod charts;
mod checkpoint;
mod clock;
mod coarse;
mod command;
mod compare;
mod continuation;
mod course;
mod csv;
mod date;
mod diagrams;
mod doubts;
mod envelopes;
mod execute;
mod explain;
mod export;
mod figure;
mod files;
mod finer;
mod finer_equilibria;
mod finer_model;
mod finer_modes;
mod flags;
mod help;
mod history;
mod journal;
mod line;
mod located;
mod map;
mod marks;
mod mass_table;
mod modes;
#[cfg(test)]
mod page_tests;
mod parallel;
mod parameters;
mod pictures;
mod plan;
mod progress;
#[cfg(feature = "python")]
pub mod python;
mod recorder;
mod report;
#[cfg(test)]
mod resume_tests;
mod run;
mod run_error;
mod scenario;
mod section_table;
mod sketch;
mod steady;
mod summary;
#[cfg(test)]
mod table_file_tests;
#[cfg(test)]
mod testing;
mod tracker;
mod unfollowed;
mod way;

pub use advise::{Advised, AdvisedRung, Wanted, advise};
pub use campbell::{Campbell, Crossing, campbell, campbell_watched};
pub use clock::Seconds;
pub use command::Command;
pub use continuation::EquilibriumProgress;
pub use envelopes::{BodyEnvelope, Envelopes, Peak};
pub use figure::Figure;
pub use finer::Judging;
pub use history::{Column, Extreme, History};
pub use line::{Entry, Line, enter, main, main_among, main_as};
pub use map::{Axis, Cells, Map};
pub use modes::{Inertial, Modes, SeenMode, modes};
pub use pictures::{Pictures, Scale, Shapes};
pub use run::{Progress, RunResult, RunSettings, StepTaken, run, run_watched};
pub use run_error::{Incomplete, RunError};
pub use steady::{Equilibria, equilibria, static_equilibria, steady};
pub use way::{EquilibriumSettings, Range};
