//! Switches of motions and loads at times that are not known beforehand: roots of gaps of t (THEORY 7), found
//! ahead of every step.
//!
//! A step is looked through at even intervals. Where a gap changes its sign, or comes back from a turn that crosses
//! zero, the first number behind the switch is found by bisection. A gap that depends on the state has no root that could
//! be known before the step: such kinks are looked for in the step that passed them (`driver.rs`).

/// Intervals in which a step is looked through.
const INTERVALS: u32 = 32;
/// Most switches that are one: of round-off there are some.
const MOST: usize = 64;

/// Gaps of a system and memory for them.
#[derive(Debug, Default)]
pub(super) struct Switches {
    /// Gaps at both ends of an interval, in one order.
    from: Vec<[f64; 2]>,
    to: Vec<[f64; 2]>,
    probe: Vec<[f64; 2]>,
}

/// The sign of a gap, with zero for itself; what is no number has none.
fn sign(gap: f64) -> i8 {
    i8::from(gap > 0.0) - i8::from(gap < 0.0)
}

impl Switches {
    /// The first time behind `from` and not behind `to` at which a gap has another sign than just before, s.
    /// `gaps` appends gaps and their derivatives at a time.
    pub(super) fn next(&mut self, from: f64, to: f64, mut gaps: impl FnMut(f64, &mut Vec<[f64; 2]>)) -> Option<f64> {
        self.from.clear();
        gaps(from, &mut self.from);
        if self.from.is_empty() {
            return None;
        }
        let mut last = from;
        for part in 1..=INTERVALS {
            let t = if part == INTERVALS {
                to
            } else {
                from + (to - from) * f64::from(part) / f64::from(INTERVALS)
            };
            self.to.clear();
            gaps(t, &mut self.to);
            let mut first: Option<f64> = None;
            for index in 0..self.from.len().min(self.to.len()) {
                let (before, after) = (self.from[index], self.to[index]);
                let probe = &mut self.probe;
                let mut at = |t: f64| {
                    probe.clear();
                    gaps(t, probe);
                    probe[index]
                };
                let found = switch((last, before), (t, after), &mut at);
                first = match (first, found) {
                    (Some(a), Some(b)) => Some(a.min(b)),
                    (a, b) => a.or(b),
                };
            }
            if first.is_some() {
                return first;
            }
            std::mem::swap(&mut self.from, &mut self.to);
            last = t;
        }
        None
    }

    /// The last switch that is one with that at `kink`: within `near` (s) of it, where round-off may switch again and again, or behind a zero of up to
    /// `at_zero` (s): a gap of numbers that nearly cancel is zero in many neighbouring times, and what it decides changes at the end of these, or at the
    /// begin.
    pub(super) fn last(
        &mut self,
        kink: f64,
        near: f64,
        at_zero: f64,
        gaps: &mut dyn FnMut(f64, &mut Vec<[f64; 2]>),
    ) -> f64 {
        let mut last = kink;
        for _ in 0..MOST {
            match self.next(last, kink + near, &mut *gaps) {
                Some(next) => last = next,
                None => break,
            }
        }
        let behind = last + at_zero;
        self.from.clear();
        gaps(last, &mut self.from);
        self.to.clear();
        gaps(behind, &mut self.to);
        let mut end = last;
        for index in 0..self.from.len().min(self.to.len()) {
            if self.from[index][0] == 0.0 && self.to[index][0] != 0.0 {
                let probe = &mut self.probe;
                let leaves = first_that(last, behind, |t| {
                    probe.clear();
                    gaps(t, probe);
                    probe[index][0] != 0.0
                });
                end = end.max(leaves);
            }
        }
        end
    }

    /// Whether a gap is zero at `t`, s: what is left and right of it differs.
    pub(super) fn is_at(&mut self, t: f64, mut gaps: impl FnMut(f64, &mut Vec<[f64; 2]>)) -> bool {
        self.from.clear();
        gaps(t, &mut self.from);
        self.from.iter().any(|gap| gap[0] == 0.0)
    }
}

/// The first number in an interval at which a gap has another sign than at its start.
fn switch(from: (f64, [f64; 2]), to: (f64, [f64; 2]), at: &mut impl FnMut(f64) -> [f64; 2]) -> Option<f64> {
    let old = sign(from.1[0]);
    if from.1[0].is_nan() || to.1[0].is_nan() {
        return None;
    }
    if sign(to.1[0]) != old {
        return Some(first_that(from.0, to.0, |t| sign(at(t)[0]) != old));
    }
    // Both ends on one side: it may have been on the other one about its turn.
    let towards = from.1[1] * f64::from(old) < 0.0 && to.1[1] * f64::from(old) > 0.0;
    if !towards {
        return None;
    }
    let turn = first_that(from.0, to.0, |t| {
        let [gap, slope] = at(t);
        slope * f64::from(old) >= 0.0 || sign(gap) != old
    });
    (sign(at(turn)[0]) != old).then(|| first_that(from.0, turn, |t| sign(at(t)[0]) != old))
}

/// The least number in `(low, high]` that is found to have what `high` has and `low` has not, by bisection down to neighbours.
pub(super) fn first_that(mut low: f64, mut high: f64, mut has: impl FnMut(f64) -> bool) -> f64 {
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return high;
        }
        if has(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(from: f64, to: f64, step: f64, gap: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
        let (mut switches, mut found, mut t) = (Switches::default(), Vec::new(), from);
        while t < to {
            match switches.next(t, (t + step).min(to), |t, out| out.push(gap(t))) {
                Some(root) => {
                    found.push(root);
                    t = root.next_up();
                }
                None => t += step,
            }
        }
        found
    }

    #[test]
    fn a_periodic_gap_switches_without_end() {
        let found = all(0.1, 100.0, 1.7, |t| [(3.0 * t).sin(), 3.0 * (3.0 * t).cos()]);
        assert_eq!(found.len(), 95);
        for (k, root) in found.iter().enumerate() {
            let exact = (k + 1) as f64 * std::f64::consts::PI / 3.0;
            assert!((root - exact).abs() <= 4.0 * f64::EPSILON * exact, "{root} {exact}");
        }
    }

    #[test]
    fn a_short_excursion_between_two_looks_is_found() {
        // Below zero for 2e-3 about t = 0.7, looked at every 1/32.
        let found = all(0.0, 1.0, 1.0, |t| [(t - 0.7).powi(2) - 1e-6, 2.0 * (t - 0.7)]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(
            (found[0] - 0.699).abs() < 1e-12 && (found[1] - 0.701).abs() < 1e-12,
            "{found:?}"
        );
    }

    #[test]
    fn a_gap_that_is_zero_for_a_while_switches_at_both_ends_of_that() {
        // Zero by round-off within 1e-12 about t = 0.25.
        let gap = |t: f64| (1.0 + (t - 0.25) * 1e-4) - 1.0;
        let mut gaps = |t: f64, out: &mut Vec<[f64; 2]>| out.push([gap(t), 1e-4]);
        let mut switches = Switches::default();
        let first = switches.next(0.0, 1.0, &mut gaps).unwrap();
        let last = switches.last(first, 0.0, 1e-10, &mut gaps);
        assert!(gap(first.next_down()) < 0.0 && gap(first.next_up()) == 0.0, "{first}");
        assert!(gap(last.next_up()) > 0.0 && last - first < 3e-12, "{first} {last}");
        assert_eq!(switches.last(0.5, 0.1, 0.1, &mut gaps), 0.5);
    }

    #[test]
    fn jumps_and_touches_are_switches_and_what_is_no_number_is_none() {
        let jump = all(0.0, 1.0, 0.3, |t| [if t < 0.5 { -1.0 } else { 2.0 }, 0.0]);
        assert_eq!(jump, [0.5]);
        assert!(all(0.0, 1.0, 0.3, |t| [(t - 2.0).ln(), 0.0]).is_empty());
        let (mut switches, at) = (Switches::default(), |t: f64, out: &mut Vec<[f64; 2]>| {
            out.push([t - 0.25, 1.0])
        });
        assert!(switches.is_at(0.25, at) && !switches.is_at(0.5, at));
    }
}
