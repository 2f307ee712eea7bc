//! The time axis of a run: smooth segments between kinks, and steps that fit into them.

use super::compensated;
use crate::archive::{Archive, Keep};

/// Round-off of times within which two kinks are one, however long the run is: what acts between them may be as strong as it likes.
const SAME: f64 = 64.0 * f64::EPSILON;
/// Smallest step that makes sense, as a part of what lies between times that are one.
const SMALLEST: f64 = 0.25;
/// What a gap of numbers that nearly cancel may leave at zero, as a part of the span.
const AT_ZERO: f64 = 1e-11;
/// Kinks of laws that steps end at in any case; beyond, one in so many steps.
const FIRST_KINKS: u64 = 64;
const STEPS_A_KINK: u64 = 4;
/// An adaptive last step may be this much longer than proposed.
const STRETCH: f64 = 1.1;
/// A fixed step may differ by this part to end where it should: round-off of the summed time.
const ROUNDED: f64 = 1e-9;

/// Segments from the start to the end time, each smooth.
#[derive(Clone, Debug)]
pub(super) struct Segments {
    start: f64,
    span: f64,
    /// First and last kink of every group of kinks, ascending, none before the start.
    kinks: Vec<(f64, f64)>,
    /// Kinks that are passed.
    passed: usize,
    /// Kinks of laws that were found in steps.
    met: u64,
    /// The last of them, s.
    latest: f64,
    /// Steps of late that passed none, less the kinks that were found meanwhile.
    quiet: u64,
    end: f64,
}

impl Keep for Segments {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            start,
            span,
            kinks,
            passed,
            met,
            latest,
            quiet,
            end,
        } = self;
        start.keep(archive);
        span.keep(archive);
        kinks.keep(archive);
        passed.keep(archive);
        met.keep(archive);
        latest.keep(archive);
        quiet.keep(archive);
        end.keep(archive);
        if *passed > kinks.len() {
            archive.misfit();
        }
    }
}

impl Segments {
    /// Segments between `start` and `end`. A kink at the start lies before the first segment, one
    /// at the end behind the last.
    pub(super) fn new(start: f64, end: f64, kinks: &[f64]) -> Self {
        let mut segments = Self {
            start,
            span: end - start,
            kinks: Vec::new(),
            passed: 0,
            met: 0,
            latest: f64::NAN,
            quiet: 0,
            end,
        };
        let mut times: Vec<f64> = kinks
            .iter()
            .copied()
            .filter(|kink| (start - segments.near(start)..=end + segments.near(end)).contains(kink))
            .collect();
        times.sort_by(f64::total_cmp);
        for kink in times {
            let near = segments.near(kink);
            if kink <= segments.start + near {
                segments.start = segments.start.max(kink.next_up());
            } else if kink >= end - near {
                segments.end = segments.end.min(kink.next_down());
            } else {
                match segments.kinks.last_mut() {
                    Some((_, last)) if kink <= *last + near => *last = kink,
                    _ => segments.kinks.push((kink, kink)),
                }
            }
        }
        segments
    }

    /// Times as near to `t` as this are one with it, s.
    pub(super) fn near(&self, t: f64) -> f64 {
        (SAME * t.abs()).max(f64::EPSILON * self.span)
    }

    /// The longest for which a gap is zero by round-off alone, s.
    pub(super) fn at_zero(&self) -> f64 {
        AT_ZERO * self.span
    }

    /// Ends the present segment at a kink (s) found within it, which is over at `last`; false if one is known there, or the end.
    pub(super) fn insert(&mut self, kink: f64, last: f64) -> bool {
        let near = self.near(kink);
        let is_end = kink >= self.end - near;
        let is_known = self.kinks.get(self.passed).is_some_and(|next| kink >= next.0 - near);
        if is_end || is_known {
            return false;
        }
        self.kinks.insert(self.passed, (kink, last));
        true
    }

    /// [`Segments::insert`] of a kink of a law, of which a shorter step knows better where it is: one that was found before and lies just behind would
    /// cut a tiny step.
    pub(super) fn meet(&mut self, kink: f64) -> bool {
        let is_new = self.insert(kink, kink);
        if is_new {
            let behind = self.passed + 1;
            if self.kinks.get(behind).is_some_and(|old| old.0 == self.latest) {
                self.kinks.remove(behind);
            }
            self.latest = kink;
        }
        self.met += u64::from(is_new);
        self.quiet = self.quiet.saturating_sub(1);
        is_new
    }

    /// Whether the kink at the end of the present segment is the last one that was found in a step.
    pub(super) fn ends_at_met(&self) -> bool {
        self.kinks.get(self.passed).is_some_and(|kink| kink.0 == self.latest)
    }

    /// Notes a step that passes no kink of a law.
    pub(super) fn pass_none(&mut self) {
        self.quiet = (self.quiet + 1).min(FIRST_KINKS);
    }

    /// Whether something rattles: there is a kink of a law every few of so many steps, and of late, too. What bounces at first, and then rests, is to
    /// leave at a kink again.
    pub(super) fn rattles(&self, steps: u64) -> bool {
        self.met > FIRST_KINKS && self.met * STEPS_A_KINK > steps && self.quiet == 0
    }

    /// Whether two times (s) count as one kink.
    pub(super) fn is_near(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.near(a.abs().max(b.abs()))
    }

    /// From the start to the end time, s.
    pub(super) fn span(&self) -> f64 {
        self.span
    }

    /// The last time before every known kink and the first one behind it, s.
    pub(super) fn around_kinks(&self) -> impl Iterator<Item = (f64, f64)> {
        self.kinks
            .iter()
            .map(|&(first, last)| (first.next_down(), last.next_up()))
    }

    /// Whether the present segment begins behind a time, s.
    pub(super) fn begins_behind(&self, t: f64) -> bool {
        let last = self.passed.checked_sub(1).and_then(|last| self.kinks.get(last));
        last.is_some_and(|kink| t <= kink.1)
    }

    /// Where the first segment begins, s.
    pub(super) fn start(&self) -> f64 {
        self.start
    }

    /// End of the present segment, s: the last number before its kink, or the end time.
    fn target(&self) -> f64 {
        self.kinks.get(self.passed).map_or(self.end, |kink| kink.0.next_down())
    }

    /// Length of what is left of the present segment at `t`, s.
    pub(super) fn left(&self, t: f64) -> f64 {
        self.target() - t
    }

    /// End time, s.
    pub(super) fn end(&self) -> f64 {
        self.end
    }

    /// Smallest step at `t` that makes sense, s.
    pub(super) fn smallest_step(&self, t: f64) -> f64 {
        SMALLEST * self.near(t)
    }

    /// Whether the end time is reached at `t`.
    pub(super) fn is_at_end(&self, t: f64) -> bool {
        self.passed == self.kinks.len() && self.reached(t)
    }

    /// Whether the kink at the end of the present segment is reached at `t`.
    pub(super) fn is_at_kink(&self, t: f64) -> bool {
        self.passed < self.kinks.len() && self.reached(t)
    }

    fn reached(&self, t: f64) -> bool {
        self.left(t) <= 4.0 * f64::EPSILON * t.abs()
    }

    /// Beginning of the segment behind the present kink, s.
    pub(super) fn behind_kink(&self) -> f64 {
        self.kinks.get(self.passed).map_or(self.end, |kink| kink.1.next_up())
    }

    /// Enters the segment behind the present kink.
    pub(super) fn pass_kink(&mut self) {
        self.passed += 1;
    }

    /// Takes [`Segments::pass_kink`] back.
    pub(super) fn return_to_kink(&mut self) {
        self.passed -= 1;
    }

    /// A step from `t` (with what rounding took from it) that is about `wanted` (s) and leaves no tiny
    /// rest: the last one is stretched, up to `ceiling`, or the last two share what is left. Never
    /// beyond the segment.
    pub(super) fn fit(&self, (t, rest): (f64, f64), wanted: f64, fixed: bool, ceiling: f64) -> f64 {
        let left = self.left(t) - rest;
        let stretch = if fixed { 1.0 + ROUNDED } else { STRETCH };
        let longest = (stretch * wanted).min((1.0 + ROUNDED) * ceiling);
        if left <= longest {
            self.exactly((t, rest), left)
        } else if left < (2.0 - ROUNDED) * wanted {
            0.5 * left
        } else {
            wanted
        }
    }

    /// The step near `h` that ends at the end of the segment also in rounded arithmetic.
    fn exactly(&self, (t, rest): (f64, f64), h: f64) -> f64 {
        let target = self.target();
        let end = |h: f64| compensated::sum(t, rest, h).0;
        let mut h = h;
        while end(h) > target {
            h = h.next_down();
        }
        if end(h) < target && end(h.next_up()) <= target {
            h = h.next_up();
        }
        h
    }
}
