//! What a run is asked for, and what becomes of it.

use super::envelopes::Envelopes;
use super::history::History;
use super::incomplete::Incomplete;
use crate::app::judged::finer::Judging;
use crate::app::judged::marks::Marks;
use crate::app::machine::clock::Seconds;
use crate::app::pictures::Pictures;
use crate::model::{DescribedBody, Fidelity, MassProperties};
use crate::{Caution, Formulation, Joints, Method, Options, Start, State, Statistics};

/// What to run and how.
#[derive(Clone, Debug, PartialEq)]
pub struct RunSettings {
    /// Coordinates of the bodies.
    pub formulation: Formulation,
    /// What becomes of linear joints.
    pub joints: Joints,
    /// Bodies that are described otherwise than they are declared, by their names.
    pub fidelity: Vec<(String, Fidelity)>,
    /// How the bodies start; `None`: as the model says.
    pub start: Option<Start>,
    /// Integration method.
    pub method: Method,
    /// Tolerance and step size.
    pub options: Options,
    /// End time, s; `None`: the model's own.
    pub t_end: Option<f64>,
    /// Time between two rows of the history, s; `None`: the model's own.
    pub every: Option<f64>,
    /// Whether pictures of the bodies are taken.
    pub pictures: bool,
    /// How far the run is repeated with other steps and on finer meshes, to tell what its outputs are off by. Without that a moment or some
    /// tell of their meshes.
    pub judged: Judging,
}

impl Default for RunSettings {
    /// RNCF, eliminated joints, Radau with rtol 1e-6, the model's start and times, not judged.
    fn default() -> Self {
        Self {
            formulation: Formulation::Rncf,
            joints: Joints::Eliminated,
            fidelity: Vec::new(),
            start: None,
            method: Method::Radau,
            options: Options::default(),
            t_end: None,
            every: None,
            pictures: false,
            judged: Judging::No,
        }
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Time reached, s.
    pub t: f64,
    /// End time, s.
    pub t_end: f64,
    /// Last step, s.
    pub h: f64,
}

/// An accepted step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepTaken {
    /// Where it ends, s.
    pub t: f64,
    /// Its size, s.
    pub h: f64,
}

/// What became of a run, complete or not.
#[derive(Clone, Debug)]
pub struct RunResult {
    /// The settings, with both times filled in.
    pub settings: RunSettings,
    /// Outputs at whole multiples of `every`, by the method's dense output. On the command line, where the table is on disk,
    /// what pictures of it need.
    pub history: History,
    /// Largest section forces and stresses of the bodies, over the rows of the history.
    pub envelopes: Envelopes,
    /// Where the bodies are in some rows of the history, where that was asked for.
    pub pictures: Option<Pictures>,
    /// All accepted steps; on the command line what pictures of them need.
    pub steps: Vec<StepTaken>,
    /// Counts of the integration.
    pub statistics: Statistics,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Largest deviation of the total energy from its initial value, relative to the largest kinetic energy; `None` where
    /// the model does not conserve it.
    pub energy_error: Option<f64>,
    /// The meshed bodies, and how they are described.
    pub bodies: Vec<DescribedBody>,
    /// Masses of the bodies at the start, and of all.
    pub masses: Vec<MassProperties>,
    /// What the model says a reader must know.
    pub cautions: Vec<Caution>,
    /// The same in sentences, what the start corrected of the declared positions and velocities, and what the
    /// scene warns of, each with the numbers of the row where it is worst.
    pub warnings: Vec<String>,
    /// Some rows, for a look at what the errors of steps add up to.
    pub(in crate::app) marks: Marks,
    /// Until when the outputs were compared with those of finer meshes, s; `None` where they were not.
    pub judged_until: Option<f64>,
    /// Outputs, by their index in `outputs()`, with how far they were found to be off until then, for the mesh or for steps: as part of the largest change or
    /// value, whichever is less, and not of less than a thousandth of what the output is made of. The largest first.
    pub off_by: Vec<(usize, f64)>,
    /// The same in a sentence, where all of the run was compared and nothing is worth a warning.
    pub agreement: Option<String>,
    /// What the meshes tell of themselves at single moments of the run.
    pub(in crate::app) coarse: Option<String>,
    /// Last good state.
    pub state: State,
    /// Time that the run took.
    pub seconds: Seconds,
    /// Why the run stopped before its end; `None` where it is complete.
    pub incomplete: Option<Incomplete>,
}

/// Times of the rows of a run, s, by their numbers: at whole multiples of a time, and at the end.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct RowTimes {
    /// End of the run and time between rows, s.
    pub t_end: f64,
    pub every: f64,
    /// Number of rows.
    pub count: u64,
}

impl RowTimes {
    /// Of completed settings.
    pub fn of(settings: &RunSettings) -> Self {
        let (t_end, every) = times(settings);
        // 0.3 / 0.1 is less than 3.
        let intervals = t_end / every;
        let whole = (intervals * (1.0 + 1e-12)).floor();
        let is_beyond = intervals > whole * (1.0 + 1e-12);
        Self {
            t_end,
            every,
            count: whole as u64 + 1 + u64::from(is_beyond),
        }
    }

    /// Time of a row, s.
    pub fn at(&self, row: u64) -> f64 {
        let time = row as f64 * self.every;
        if time > self.t_end * (1.0 + 1e-9) {
            self.t_end
        } else {
            time
        }
    }
}

/// End time and time between rows of completed settings.
pub(in crate::app) fn times(settings: &RunSettings) -> (f64, f64) {
    (settings.t_end.unwrap_or(0.0), settings.every.unwrap_or(f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_row_is_at_the_end() {
        let at = |t_end, every| {
            let rows = RowTimes::of(&RunSettings {
                t_end: Some(t_end),
                every: Some(every),
                ..RunSettings::default()
            });
            (rows.count, rows.at(rows.count - 1))
        };
        assert_eq!(at(1.0, 0.3), (5, 1.0));
        assert_eq!(at(1.0, 0.25), (5, 1.0));
        assert_eq!(at(0.3, 0.1), (4, 3.0 * 0.1));
        assert_eq!(at(1.0, 0.999_999), (3, 1.0));
    }
}
