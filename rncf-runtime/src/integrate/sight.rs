//! Whether a step sees what motions and loads do over time (`course`): a pulse that is over between two evaluations, whatever function it is made
//! of, leaves no trace in an estimate of the error. Its bounds over the step tell of it.

use crate::course::{Courses, Interval};

/// A course may leave what it takes on at the ends of the step, and of a step before that was not much shorter, by so many times the width of that: then
/// the error is estimated from values that are not small beside what is between them.
const BEYOND: f64 = 4.0;
/// Within each of so many pieces of a step it may leave what it takes on at their ends by this part of what it takes on at all ends: a step that begins
/// in one pulse must not reach over another.
const PIECES: usize = 4;
const BESIDE: f64 = 0.25;
/// Both as a part of all that it takes on in the run: what is smaller is none of its pulses.
const LEAST: f64 = 1e-3;
/// A step tells of the next one if that is at most so many times as long.
const ALIKE: f64 = 2.0;
/// Halvings of a step after which a pulse is located well enough, and after which bounds are those of one number.
const LOCATED: u32 = 6;
const DEEPEST: u32 = 40;
/// Evaluations of bounds for one step, and halvings of a step for bounds that stay too wide.
const EVALUATIONS: u32 = 2000;
const VAGUE: u32 = 6;
/// Parts of the run in which its courses are bounded.
const PARTS: u32 = 256;

/// Bounds of all courses over the run, and memory.
pub(super) struct Sight {
    courses: Vec<Courses>,
    /// Widths of what each function takes on in the run.
    widths: Vec<f64>,
    /// What functions may take on in a step, in one order.
    allowed: Vec<Interval>,
    all: Vec<Interval>,
    evaluations: u32,
}

/// What a step would jump over.
struct Hidden {
    /// From when on, s.
    from: f64,
    /// What it belongs to.
    of: &'static str,
    /// Whether that is only not excluded.
    vague: bool,
}

impl Sight {
    /// Of a run between two times, s.
    pub(super) fn new(mut courses: Vec<Courses>, start: f64, end: f64) -> Self {
        courses.retain(|one| !one.functions.is_empty());
        let mut sight = Self {
            courses,
            widths: Vec::new(),
            allowed: Vec::new(),
            all: Vec::new(),
            evaluations: 0,
        };
        let mut taken: Vec<Option<Interval>> = Vec::new();
        if !sight.courses.is_empty() {
            let part = (end - start) / f64::from(PARTS);
            for number in 0..PARTS {
                let from = start + part * f64::from(number);
                let functions = sight.bounds(Interval::new(from, from + part));
                taken.resize(functions.len(), None);
                for (taken, bounds) in taken.iter_mut().zip(functions) {
                    if bounds.width().is_finite() {
                        *taken = Some(taken.map_or(bounds, |known| known.hull(bounds)));
                    }
                }
            }
        }
        sight.widths = taken.iter().map(|taken| taken.map_or(0.0, Interval::width)).collect();
        sight
    }

    /// The longest step from `t` (s) up to `h` whose ends, with that of the step before, show all that happens in it; and what a longer one jumps over.
    pub(super) fn longest(&mut self, before: f64, t: f64, h: f64, least: f64) -> (f64, Option<&'static str>) {
        let (mut longest, mut of, mut vague) = (h, None, 0);
        while let Some(hidden) = self.hidden(before, t, t + longest) {
            vague += u32::from(hidden.vague);
            let until = hidden.from - t;
            let shorter = if until > 0.25 * longest { until } else { 0.5 * longest };
            if vague > VAGUE || shorter < least {
                break;
            }
            of = Some(hidden.of);
            longest = shorter;
        }
        (longest, of)
    }

    fn hidden(&mut self, before: f64, from: f64, to: f64) -> Option<Hidden> {
        if self.courses.is_empty() {
            return None;
        }
        self.evaluations = 0;
        let h = to - from;
        let times: Vec<f64> = (0..PIECES)
            .map(|piece| from + h * piece as f64 / PIECES as f64)
            .chain([to])
            .collect();
        let values: Vec<Vec<Interval>> = times.iter().map(|&t| self.bounds(Interval::point(t))).collect();
        let mut ends = hulls(&values[0], &values[PIECES]);
        if h <= ALIKE * (from - before) {
            ends = hulls(&ends, &self.bounds(Interval::point(before)));
        }
        let all = values[1..].iter().fold(ends.clone(), |all, values| hulls(&all, values));
        let margins = |shown: &[Interval], part: f64, widths: &[f64]| -> Vec<f64> {
            shown
                .iter()
                .zip(widths)
                .map(|(shown, width)| part * shown.width() + LEAST * width)
                .collect()
        };
        let beyond = margins(&ends, BEYOND, &self.widths);
        let beside = margins(&all, BESIDE, &self.widths);
        self.allow(ends, &beyond);
        let first = self.leaves(Interval::new(from, to), 0);
        let mut pieces = times.windows(2).zip(values.windows(2));
        let second = pieces.find_map(|(times, values)| {
            self.allow(hulls(&values[0], &values[1]), &beside);
            self.leaves(Interval::new(times[0], times[1]), 0)
        });
        [first, second]
            .into_iter()
            .flatten()
            .min_by(|a, b| a.from.total_cmp(&b.from))
    }

    fn allow(&mut self, shown: Vec<Interval>, margins: &[f64]) {
        self.allowed = shown;
        for (allowed, margin) in self.allowed.iter_mut().zip(margins) {
            *allowed = Interval::new(allowed.low - margin, allowed.high + margin);
        }
    }

    /// Where in a span a function first leaves what is allowed.
    fn leaves(&mut self, span: Interval, depth: u32) -> Option<Hidden> {
        let of = self.outside(span)?;
        let hidden = |vague| {
            Some(Hidden {
                from: span.low,
                of,
                vague,
            })
        };
        let middle = span.low + 0.5 * span.width();
        if depth >= DEEPEST || middle <= span.low || middle >= span.high {
            return None;
        }
        if self.evaluations > EVALUATIONS {
            return hidden(true);
        }
        if depth >= LOCATED && self.outside(Interval::point(middle)).is_some() {
            return hidden(false);
        }
        self.leaves(Interval::new(span.low, middle), depth + 1)
            .or_else(|| self.leaves(Interval::new(middle, span.high), depth + 1))
    }

    /// What a function belongs to whose bounds over a span are not within what is allowed.
    fn outside(&mut self, span: Interval) -> Option<&'static str> {
        self.evaluations += 1;
        let mut number = 0;
        for courses in &self.courses {
            courses.bounds(span, &mut self.all);
            for &(of, at) in courses.functions {
                if !self.allowed[number].contains(self.all[at]) {
                    return Some(of);
                }
                number += 1;
            }
        }
        None
    }

    /// Bounds of every function over a span.
    fn bounds(&mut self, span: Interval) -> Vec<Interval> {
        let mut bounds = Vec::with_capacity(self.widths.len());
        for courses in &self.courses {
            courses.bounds(span, &mut self.all);
            bounds.extend(courses.functions.iter().map(|&(_, at)| self.all[at]));
        }
        bounds
    }
}

fn hulls(these: &[Interval], others: &[Interval]) -> Vec<Interval> {
    these.iter().zip(others).map(|(a, b)| a.hull(*b)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::Operation::{Add, Divide, Multiply, Number, Power, Sin, Subtract, Time};

    /// Walks over 100 s with steps that grow to what is asked for, and returns where they end.
    fn steps(operations: &'static [crate::course::Operation], numbers: &[f64]) -> Vec<f64> {
        let functions: &[(&str, usize)] = Box::leak(vec![("load", operations.len() - 1)].into_boxed_slice());
        let courses = Courses {
            operations,
            numbers: numbers.to_vec(),
            tables: Vec::new(),
            functions,
        };
        let mut sight = Sight::new(vec![courses], 0.0, 100.0);
        let (mut times, mut wanted) = (vec![0.0], 1e-3);
        while times[times.len() - 1] < 100.0 {
            let t = times[times.len() - 1];
            let before = times[times.len().saturating_sub(2)];
            let (h, _) = sight.longest(before, t, wanted, 1e-10);
            times.push(t + h);
            wanted = 5.0 * h;
        }
        times
    }

    #[test]
    fn a_pulse_of_a_rational_function_is_met_and_nothing_else_shortens_steps() {
        // 1/(1 + ((t - 50)/1e-4)^2)
        let pulse = &[
            Time,
            Number(0),
            Subtract(0, 1),
            Number(1),
            Divide(2, 3),
            Multiply(4, 4),
            Number(2),
            Add(5, 6),
            Divide(6, 7),
        ];
        let times = steps(pulse, &[50.0, 1e-4, 1.0]);
        let within = times.iter().filter(|t| (**t - 50.0).abs() < 3e-4).count();
        assert!(within >= 2, "{within} of {}", times.len());
        assert!(times.len() < 60, "{}", times.len());
        let smooth = steps(pulse, &[50.0, 30.0, 1.0]);
        assert!(smooth.len() < 15, "{}", smooth.len());
    }

    #[test]
    fn every_pulse_of_a_high_power_of_a_sine_is_met() {
        let times = steps(&[Time, Sin(0), Power(1, 2000)], &[]);
        for number in 0..31 {
            let peak = std::f64::consts::PI * (0.5 + f64::from(number));
            assert!(times.iter().any(|t| (t - peak).abs() < 0.08), "{peak}: {times:?}");
        }
    }
}
