//! Kinks that a step has passed, at its end or inside of it, and those whose other side its matrix is of.

use super::Driver;
use crate::integrate::switches::first_that;
use crate::system::{Branch, System};

/// Most times that a step is shortened because its matrix is of another side of a kink.
pub(super) const ACROSS: u32 = 8;

impl Driver {
    /// Branches of the step just taken, each with its time, s: where it began, where forces were evaluated inside, and at its end.
    pub(super) fn branches_of_step(
        &mut self,
        system: &mut dyn System,
        (from, begin): (f64, &[Branch]),
    ) -> Vec<(f64, Vec<Branch>)> {
        let mut state = self.state().clone();
        let end = state.t;
        let mut course = vec![(from, begin.to_vec())];
        for part in self.scheme.inside() {
            let t = from + part * (end - from);
            self.scheme.interpolate(t, &mut state);
            course.push((t, system.branches(&state)));
        }
        course.push((end, system.branches(self.state())));
        course
    }

    /// Ends the present segment where the step just taken first passed a kink of a law, at its end or inside, where it may have been and come back;
    /// false if it passed none, or if something rattles.
    pub(super) fn ends_at_passed_kink(&mut self, system: &mut dyn System, course: &[(f64, Vec<Branch>)]) -> bool {
        let mut state = self.state().clone();
        let (from, end) = (course[0].0, state.t);
        let mut is_any = false;
        for places in course.windows(2) {
            let [(low, last), (to, now)] = places else { continue };
            let is_passed = |now: &Branch, before: &Branch| match *low == from {
                true => now.is_kink_passed_from(before),
                false => now.is_kink_passed_since(before),
            };
            let passed: Vec<usize> = (0..last.len())
                .filter(|&law| is_passed(&now[law], &last[law]) && !self.awaits(law, &last[law]))
                .collect();
            if let Some(&law) = passed.first()
                && self.segments.rattles(self.statistics.steps)
            {
                self.statistics.note_rattling(from, &system.describe_branch(law));
                return false;
            }
            let mut first: Option<(f64, usize)> = None;
            let mut met: Vec<(f64, usize)> = Vec::new();
            for law in passed {
                is_any = true;
                let scheme = &self.scheme;
                let kink = first_that(*low, *to, |t| {
                    scheme.interpolate(t, &mut state);
                    is_passed(&system.branches(&state)[law], &last[law])
                });
                // At the end of a step the formulas of the method are better than what lies between.
                let counts = kink < end && !self.segments.is_near(from, kink);
                met.push((kink, law));
                if counts && first.is_none_or(|(earlier, _)| kink < earlier) {
                    first = Some((kink, law));
                }
            }
            if let Some((kink, law)) = first {
                let is_new = self.segments.meet(kink);
                let together = met.iter().filter(|other| self.segments.is_near(other.0, kink));
                self.met = together
                    .filter_map(|&(_, law)| Some((law, last[law].side()?)))
                    .collect();
                self.at_corner |= is_new && system.is_branch_of_constraint(law);
                return is_new;
            }
        }
        // A step that was cut at one has not passed it, but says nothing of quiet either.
        if !is_any && !self.segments.is_at_kink(end) {
            self.segments.pass_none();
        }
        false
    }

    /// Whether a kink of a law, seen from this side of it, is the one at which the segment began. Between its ends a method knows velocities less well than at
    /// them: a step that is cut at a kink may end a little before it, and the next one is not cut there again.
    fn awaits(&self, law: usize, before: &Branch) -> bool {
        let side = before.side();
        side.is_some() && self.awaited.iter().any(|&(own, from)| own == law && Some(from) == side)
    }

    /// Takes in an accepted step: what is passed, or goes away from its kink, is not awaited any more.
    pub(super) fn forget_passed(&mut self, course: &[(f64, Vec<Branch>)]) {
        if let [(_, begin), .., (_, now)] = course {
            self.awaited
                .retain(|&(law, side)| now[law].side() == Some(side) && now[law].is_nearer_than(&begin[law]));
        }
    }

    /// Whether the matrix of the step just taken is of another side of a kink than a state of it: beside what is stiff on one side alone a force that is not
    /// there looks balanced, and its momentum remains.
    pub(super) fn is_on_other_side(&self, system: &mut dyn System, course: &[(f64, Vec<Branch>)]) -> bool {
        let Some(of_matrix) = self.scheme.linearized().map(|state| system.branches(state)) else {
            return false;
        };
        let differs = |(_, now): &(f64, Vec<Branch>)| {
            let mut pairs = now.iter().zip(&of_matrix).enumerate();
            pairs.any(|(law, (now, other))| now.is_across_from(other) && !self.awaits(law, now))
        };
        // At a kink round-off says on which side.
        let counts = |(t, _): &&(f64, Vec<Branch>)| !self.segments.is_at_kink(*t);
        course[1..].iter().filter(counts).any(differs)
    }
}
