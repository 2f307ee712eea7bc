//! What Newton's iteration of the alpha family has seen of its kept matrix.

/// Most steps in a row that may take one iteration and thus show no contraction.
const BLIND: u32 = 4;
/// Smallest contraction that is expected of a step before it is seen.
const LEAST: f64 = 1e-3;

/// Contraction seen with one factorization. As the solution moves away from where the matrix was
/// made the contraction gets worse: what is expected grows by twice what was seen to come.
pub(super) struct Experience {
    /// Seen last; 1 before anything is seen.
    last: f64,
    /// Change per step between the last two sightings.
    drift: f64,
    /// Steps since then.
    unseen: u32,
}

impl Default for Experience {
    fn default() -> Self {
        Self {
            last: 1.0,
            drift: 1.0,
            unseen: 0,
        }
    }
}

impl Experience {
    /// Contraction to expect in the next step; 1 or more: none.
    pub(super) fn expected(&self) -> f64 {
        if self.unseen >= BLIND {
            return 1.0;
        }
        (self.last + 2.0 * self.drift * f64::from(self.unseen + 1)).max(LEAST)
    }

    /// Notes the contraction that a step has shown, if it took more than one iteration.
    pub(super) fn note(&mut self, seen: Option<f64>) {
        match seen {
            Some(contraction) => {
                self.drift = (contraction - self.last).abs() / f64::from(self.unseen + 1);
                self.last = contraction;
                self.unseen = 0;
            }
            None => self.unseen += 1,
        }
    }
}
