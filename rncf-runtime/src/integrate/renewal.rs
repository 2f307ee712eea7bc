//! Renewal: from time to time an integration forgets all that it could find again, and goes on from what it must know.
//!
//! Matrices, factorizations and what was seen of them are kept from step to step, and the last bits of a result depend on when
//! they were made. They are not worth storing. A renewal writes what must be known to bytes, makes the method anew and reads
//! the bytes, just as a run does that is taken up later from them: so both go on with the same bits, whatever the method
//! remembers. When a renewal is due is counted, not timed.

use super::statistics::Statistics;

/// When the next renewal is due, and what the last one knew.
pub(super) struct Renewal {
    /// Evaluations of the residual from one to the next.
    after: u64,
    /// Evaluations at the last one.
    pub(super) last: u64,
    /// What was known at the last one; empty before the first.
    pub(super) known: Vec<u8>,
}

impl Renewal {
    /// A renewal after every so many evaluations of the residual.
    pub(super) fn new(after: u64) -> Self {
        Self {
            after,
            last: 0,
            known: Vec::new(),
        }
    }

    /// What was known at the last one; `None` before the first.
    pub(super) fn known(&self) -> Option<&[u8]> {
        (!self.known.is_empty()).then_some(&self.known)
    }

    /// Whether the time has come; to be asked after a step.
    pub(super) fn is_due(&self, statistics: &Statistics) -> bool {
        statistics.residual_evaluations - self.last >= self.after
    }
}
