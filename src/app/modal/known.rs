//! In how many directions the stiffness is negative at the steps of a way, and where that changes between two of them.

use crate::app::equilibria::continuation::{Found, Line};
use crate::app::equilibria::directions::{self, Measured};
use crate::equilibrium::{Continued, Uniform};
use crate::modes::Critical;
use crate::{Scene, SolveError, State};

/// What is known of the directions in which a stiffness is negative.
#[derive(Default)]
pub(super) struct Known {
    /// Those at the last step where they are known, and that step.
    measured: Option<(Measured, Found)>,
    /// Whether they are not known at the last step alone.
    is_skipped: bool,
}

/// How they are measured at an equilibrium, with the values of the stiffness or without.
pub(super) type Measuring = fn(&mut dyn Scene, &Uniform, &State, bool) -> Result<Measured, SolveError>;

/// Those of the whole stiffness, which are asked where forces that come from no energy act.
pub(super) fn whole(scene: &mut dyn Scene, at: &Uniform, state: &State, _: bool) -> Result<Measured, SolveError> {
    directions::whole(scene, at, state, true)
}

impl Known {
    /// The critical values in the last step, to whose end `measured` belongs, if they are asked for.
    pub fn locate(
        &mut self,
        line: &mut Line<'_>,
        measured: Option<Measured>,
        measuring: Measuring,
        is_asked: bool,
    ) -> Vec<Critical> {
        let last = line.last_two().1.clone();
        let Some(measured) = measured else {
            // A step may lie just where a stiffness vanishes: the next one tells what it becomes.
            if std::mem::replace(&mut self.is_skipped, true) {
                self.measured = None;
            }
            return Vec::new();
        };
        self.is_skipped = false;
        let Some((before, first)) = self.measured.replace((measured.clone(), last.clone())) else {
            return Vec::new();
        };
        if before.negative == measured.negative || !is_asked {
            return Vec::new();
        }
        let mut measure = |scene: &mut dyn Scene, at: &Uniform, step: &Continued, with_values| {
            measuring(scene, at, &step.state, with_values).ok()
        };
        line.critical([&first, &last], [before, measured], &mut measure)
    }
}
