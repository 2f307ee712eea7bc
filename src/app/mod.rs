//! The command line of a model: one line in an example's `main`.
//!
//! ```text
//! cargo run --release --example spin_up -- [run|steady|modes|campbell|static|chart|advise|sweep|explain] [name=value ...] [flags]
//! ```
//!
//! [`main`] reads the line, does what it says, shows progress, and writes tables (CSV), the summary (JSON)
//! and the report (HTML). [`run`], [`steady`], [`modes`], [`campbell`], [`static_equilibria`] and [`advise()`] do the
//! same work in memory and print nothing.

mod accumulated;
mod advise;
mod arguments;
#[cfg(test)]
mod arguments_tests;
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
mod flags;
mod hash;
mod help;
mod history;
mod journal;
mod line;
mod located;
mod map;
mod marks;
mod mass_table;
mod modes;
mod nearest;
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
mod testing;
mod tracker;
mod unfollowed;
mod units;

pub use advise::{Advised, AdvisedRung, Wanted, advise};
pub use campbell::{Campbell, Crossing, campbell, campbell_watched};
pub use clock::Seconds;
pub use command::Command;
pub use continuation::{EquilibriumProgress, EquilibriumSettings, Range};
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
