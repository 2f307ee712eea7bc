//! Sums that keep what rounding takes from them: positions, velocities and time are accumulated over
//! many small steps as `high + low`. Round-off of a run is then that of the last bit of its steps'
//! increments, not of the sum at every step.

use crate::archive::{Archive, Keep};

/// Low parts of positions, velocities and time of a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Low {
    /// Time, s.
    pub(super) t: f64,
    /// Unknowns; zero for orientations, whose charts begin anew with every step.
    pub(super) x: Vec<f64>,
    /// Velocities.
    pub(super) v: Vec<f64>,
}

impl Keep for Low {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { t, x, v } = self;
        t.keep(archive);
        archive.fixed(x);
        archive.fixed(v);
    }
}

impl Low {
    /// Zeros for `n` unknowns.
    pub(super) fn zeros(n: usize) -> Self {
        Self {
            t: 0.0,
            x: vec![0.0; n],
            v: vec![0.0; n],
        }
    }

    /// What was summed up is exact: a start.
    pub(super) fn clear(&mut self) {
        self.t = 0.0;
        self.x.fill(0.0);
        self.v.fill(0.0);
    }

    /// The charts of the orientations with the given first unknowns begin anew.
    pub(super) fn rebase(&mut self, turns: &[usize]) {
        for &turn in turns {
            self.x[turn..turn + 3].fill(0.0);
        }
    }
}

/// `high + low + change` as its nearest number and the rest of it; exact but for the last bit of `low + change`.
pub(super) fn sum(high: f64, low: f64, change: f64) -> (f64, f64) {
    let change = low + change;
    let total = high + change;
    let taken = total - high;
    (total, (high - (total - taken)) + (change - taken))
}

/// Adds `change` to `high + low`.
pub(super) fn add(high: &mut f64, low: &mut f64, change: f64) {
    (*high, *low) = sum(*high, *low, change);
}

/// Adds a multiple of some changes, entry by entry.
pub(super) fn add_multiple(high: &mut [f64], low: &mut [f64], factor: f64, changes: &[f64]) {
    for ((high, low), &change) in high.iter_mut().zip(low).zip(changes) {
        add(high, low, factor * change);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost_from_a_sum_of_many_small_parts() {
        let (mut high, mut low, mut plain) = (1e6, 0.0, 1e6);
        for _ in 0..1_000_000 {
            add(&mut high, &mut low, 0.1);
            plain += 0.1;
        }
        assert_eq!(high, 1.1e6);
        // A tenth is a little more than 1/10: 5.6e-18, a million times.
        assert!((low - 5.55e-12).abs() < 1e-13, "{low:e}");
        assert!((plain - 1.1e6_f64).abs() > 1e-7, "{plain}");
        // Also where the change is the larger part.
        assert_eq!(sum(1.0, 0.0, 1e17), (1e17, 1.0));
    }
}
