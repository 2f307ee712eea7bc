//! The longest of the recent steps: an error of velocity lasts through steps as long as that, also where an impact makes them short for a while.

use crate::archive::{Archive, Keep};

/// Steps that vary by less than this do so in smooth motions.
const SMOOTH: f64 = 4.0;
/// The longest step is remembered over some hundred steps.
const FORGETTING: f64 = 0.99;

/// What is remembered of the steps so far.
#[derive(Default)]
pub(super) struct Recent {
    /// s
    longest: f64,
}

impl Recent {
    /// Takes in an accepted step, s.
    pub(super) fn meet(&mut self, h: f64) {
        self.longest = h.max(FORGETTING * self.longest);
    }

    /// How long an error of velocity in a step (s) lasts, s.
    pub(super) fn lasting(&self, h: f64) -> f64 {
        h.max(self.longest / SMOOTH)
    }
}

impl Keep for Recent {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.longest.keep(archive);
    }
}
