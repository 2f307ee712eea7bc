//! Whether a step sees what motions and loads do over time (`course`): a pulse that is over between two evaluations, whatever function it is made
//! of, leaves no trace in an estimate of the error. Its bounds over the step tell of it.

use crate::course::{Close, Courses, Interval, Path};

/// A course may leave what it takes on at the ends of the step, and of a step before that was not much shorter, by so many times the width of that: then
/// the error is estimated from values that are not small beside what is between them.
const BEYOND: f64 = 4.0;
/// Within each of so many pieces of a step it may leave what it takes on at their ends by this part of what it takes on at all ends: a step that begins
/// in one pulse must not reach over another.
const PIECES: usize = 4;
const BESIDE: f64 = 0.25;
/// Of what a position changes by in all pieces, more than one of them alone may have.
const ALONE: f64 = 0.9;
/// The first two as a part of all that it takes on in the run: what is smaller is none of its pulses.
const LEAST: f64 = 1e-3;
/// A step tells of the next one if that is at most so many times as long.
const ALIKE: f64 = 2.0;
/// Halvings of a step after which a pulse is located well enough, and after which bounds are those of one number.
const LOCATED: u32 = 6;
const DEEPEST: u32 = 40;
/// Evaluations of bounds for one step, and halvings for bounds that stay too wide: of a step, and of all steps for one function, at which nobody looks after that.
const EVALUATIONS: u32 = 2000;
const VAGUE: u32 = 6;
const GIVEN_UP: u32 = 100;
/// Parts of the run in which its courses are bounded, and how many of them are halved where their bounds are more than so many times as wide as what their
/// ends show: products of what grows and what falls have bounds of wide parts that are a thousand times too large.
const PARTS: u32 = 256;
const HALVED: u32 = 512;
const SHARP: f64 = 4.0;

/// Bounds of all courses over the run, and memory.
pub(super) struct Sight {
    courses: Vec<Courses>,
    /// Those that read vectors, by number, and the markers that they read.
    reading: Vec<usize>,
    readers: Vec<Vec<usize>>,
    /// How often these were followed, and when the run ends, s.
    followed: u64,
    end: f64,
    /// Those that change over a step by what counts, and their functions, by number.
    lively: Vec<usize>,
    functions: Vec<usize>,
    /// Widths of what each function takes on in the run, infinite where that is not known, and how often steps were halved as its bounds stayed too wide.
    widths: Vec<f64>,
    vague: Vec<u32>,
    /// What lively functions may take on in a step, in their order.
    allowed: Vec<Interval>,
    /// Values at the end of the step before, and at the ends of the pieces of a step.
    before: Vec<Interval>,
    shown: [Vec<Interval>; PIECES + 1],
    /// Bounds of all operations.
    all: Vec<Interval>,
    close: Close,
    evaluations: u32,
}

/// A step that shows what happens in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen {
    /// Its length, s.
    pub(super) step: f64,
    /// What a longer one would jump over.
    pub(super) beyond: Option<&'static str>,
    /// What may be over within this one: no shorter one is taken for it.
    pub(super) unseen: Option<&'static str>,
}

/// What a step would jump over.
struct Hidden {
    /// From when on, s.
    from: f64,
    /// The function that does it: its number, and what it belongs to.
    function: (usize, &'static str),
    /// Whether that is only not excluded.
    vague: bool,
}

impl Sight {
    /// Of a run between two times, s.
    pub(super) fn new(mut courses: Vec<Courses>, start: f64, end: f64) -> Self {
        courses.retain(|one| !one.functions.is_empty());
        let mut sight = Self {
            courses,
            reading: Vec::new(),
            readers: Vec::new(),
            followed: 0,
            end,
            lively: Vec::new(),
            functions: Vec::new(),
            widths: Vec::new(),
            vague: Vec::new(),
            allowed: Vec::new(),
            before: Vec::new(),
            shown: Default::default(),
            all: Vec::new(),
            close: Close::default(),
            evaluations: 0,
        };
        for (number, courses) in sight.courses.iter().enumerate() {
            if courses.reads_vectors() {
                sight.reading.push(number);
                sight.readers.push(courses.markers.clone());
                sight
                    .widths
                    .extend(anywhere(courses, Interval::new(start, end), &mut sight.all));
            } else {
                sight.widths.extend(taken(courses, start, end, &mut sight.all));
            }
        }
        sight.vague = vec![0; sight.widths.len()];
        sight
    }

    /// Markers of the scene whose vectors are to be followed before each step.
    pub(super) fn readers(&self) -> &[Vec<usize>] {
        &self.readers
    }

    /// Whether something is held at positions that may change in a small part of a step.
    pub(super) fn has_positions(&self) -> bool {
        self.reading.iter().any(|&number| self.courses[number].are_positions)
    }

    /// Takes the ways of the vectors that each of them reads, from the present time (s) on. What functions take on that have no bounds wherever these are is
    /// that on their ways, looked at now and then.
    pub(super) fn follow(&mut self, t: f64, paths: Vec<Vec<Path>>) {
        for (&number, paths) in self.reading.iter().zip(paths) {
            let before = std::mem::take(&mut self.courses[number].paths);
            let after = |(at, path): (usize, Path)| match before.get(at) {
                Some(before) => path.after(before),
                None => path,
            };
            self.courses[number].paths = paths.into_iter().enumerate().map(after).collect();
        }
        self.followed += 1;
        if !self.followed.is_power_of_two() {
            return;
        }
        let mut first = 0;
        for courses in &self.courses {
            let widths = &mut self.widths[first..first + courses.functions.len()];
            first += widths.len();
            if widths.iter().all(|width| width.is_finite()) {
                continue;
            }
            let unknown = widths.iter_mut().zip(taken(courses, t, self.end, &mut self.all));
            unknown
                .filter(|(width, on_way)| width.is_infinite() && *on_way > 0.0)
                .for_each(|(width, on_way)| *width = on_way);
        }
    }

    /// The longest step from `t` (s) up to `h` whose ends, with that of the step before, show all that happens in it.
    pub(super) fn longest(&mut self, before: f64, t: f64, h: f64, least: f64) -> Seen {
        let mut seen = Seen {
            step: h,
            beyond: None,
            unseen: None,
        };
        let mut vague = 0;
        while let Some(hidden) = self.hidden(before, t, t + seen.step) {
            let (number, of) = hidden.function;
            vague += u32::from(hidden.vague);
            self.vague[number] += u32::from(hidden.vague);
            let until = hidden.from - t;
            let shorter = if until > 0.25 * seen.step {
                until
            } else {
                0.5 * seen.step
            };
            if self.vague[number] == GIVEN_UP {
                seen.unseen = Some(of);
                continue;
            }
            if vague > VAGUE || shorter < least {
                seen.unseen = Some(of);
                break;
            }
            seen.beyond = Some(of);
            seen.step = shorter;
        }
        seen
    }

    fn hidden(&mut self, before: f64, from: f64, to: f64) -> Option<Hidden> {
        self.find_lively(Interval::new(from, to));
        if self.lively.is_empty() {
            return None;
        }
        self.evaluations = 0;
        let h = to - from;
        let time = |end: usize| {
            if end < PIECES {
                from + h * end as f64 / PIECES as f64
            } else {
                to
            }
        };
        let lively = || self.lively.iter().map(|&index| &self.courses[index]);
        for (end, shown) in self.shown.iter_mut().enumerate() {
            bounds(lively(), Interval::point(time(end)), &mut self.all, shown);
        }
        let tells = h <= ALIKE * (from - before);
        if tells {
            bounds(lively(), Interval::point(before), &mut self.all, &mut self.before);
        }
        self.allowed.clear();
        for (at, &number) in self.functions.iter().enumerate() {
            let mut ends = self.shown[0][at].hull(self.shown[PIECES][at]);
            if tells {
                ends = ends.hull(self.before[at]);
            }
            self.allowed
                .push(ends.wider(BEYOND * ends.width() + LEAST * self.widths[number]));
        }
        let alone = self.alone(time);
        let first = self.leaves(Interval::new(from, to), 0);
        let second = (0..PIECES).find_map(|piece| {
            self.allowed.clear();
            for (at, &number) in self.functions.iter().enumerate() {
                let shown = |end: usize| self.shown[end][at];
                let mut all = (1..=PIECES).fold(shown(0), |all, end| all.hull(shown(end)));
                if tells {
                    all = all.hull(self.before[at]);
                }
                let ends = shown(piece).hull(shown(piece + 1));
                self.allowed
                    .push(ends.wider(BESIDE * all.width() + LEAST * self.widths[number]));
            }
            self.leaves(Interval::new(time(piece), time(piece + 1)), 0)
        });
        [alone, first, second]
            .into_iter()
            .flatten()
            .min_by(|a, b| a.from.total_cmp(&b.from))
    }

    /// A position that changes in one piece of a step alone: values within its ends are no trace of that, and what it does to velocities may be over.
    fn alone(&self, time: impl Fn(usize) -> f64) -> Option<Hidden> {
        let mut functions = self.functions.iter().enumerate();
        for &index in &self.lively {
            let courses = &self.courses[index];
            for &(of, _) in courses.functions {
                let (at, &number) = functions.next()?;
                if !courses.are_positions || self.vague[number] >= GIVEN_UP {
                    continue;
                }
                let middle = |end: usize| 0.5 * (self.shown[end][at].low + self.shown[end][at].high);
                let changes: [f64; PIECES] = std::array::from_fn(|piece| (middle(piece + 1) - middle(piece)).abs());
                let all: f64 = changes.iter().sum();
                let is_alone = |&piece: &usize| changes[piece] > ALONE * all;
                if all > LEAST * self.widths[number]
                    && let Some(piece) = (0..PIECES).find(is_alone)
                {
                    return Some(Hidden {
                        from: time(piece),
                        function: (number, of),
                        vague: false,
                    });
                }
            }
        }
        None
    }

    /// Finds courses that change over a span by what counts: the others don't leave what the ends of its pieces show.
    fn find_lively(&mut self, span: Interval) {
        self.lively.clear();
        self.functions.clear();
        let mut first = 0;
        for (index, courses) in self.courses.iter().enumerate() {
            courses.bounds(span, &mut self.all);
            let numbers = first..first + courses.functions.len();
            first = numbers.end;
            let mut functions = courses.functions.iter().zip(&self.widths[numbers.clone()]);
            if functions.any(|(&(_, at), width)| self.all[at].width() > LEAST * width) {
                self.lively.push(index);
                self.functions.extend(numbers);
            }
        }
    }

    /// Where in a span a function first leaves what is allowed.
    fn leaves(&mut self, span: Interval, depth: u32) -> Option<Hidden> {
        let function = self.outside(span)?;
        let hidden = |vague| {
            Some(Hidden {
                from: span.low,
                function,
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

    /// A function whose bounds over a span are not within what is allowed: its number, and what it belongs to.
    fn outside(&mut self, span: Interval) -> Option<(usize, &'static str)> {
        self.evaluations += 1;
        let mut functions = self.functions.iter().zip(&self.allowed);
        for &index in &self.lively {
            let courses = &self.courses[index];
            courses.bounds(span, &mut self.all);
            let mut is_close = false;
            for (&(of, at), (&number, allowed)) in courses.functions.iter().zip(&mut functions) {
                if self.vague[number] >= GIVEN_UP || allowed.contains(self.all[at]) {
                    continue;
                }
                if !is_close {
                    courses.close_bounds(span, &mut self.close);
                    is_close = true;
                }
                if !allowed.contains(self.close.bounds(at)) {
                    return Some((number, of));
                }
            }
        }
        None
    }
}

/// Bounds of every function over a span, and in `all` those of operations.
fn bounds<'c>(
    courses: impl Iterator<Item = &'c Courses>,
    span: Interval,
    all: &mut Vec<Interval>,
    functions: &mut Vec<Interval>,
) {
    functions.clear();
    for courses in courses {
        courses.bounds(span, all);
        functions.extend(courses.functions.iter().map(|&(_, at)| all[at]));
    }
}

/// Bounds of functions in a part of the run.
struct Part {
    span: Interval,
    bounds: Vec<Interval>,
}

impl Part {
    fn new(courses: &Courses, span: Interval, all: &mut Vec<Interval>) -> Self {
        let mut functions = Vec::new();
        bounds(std::iter::once(courses), span, all, &mut functions);
        Self {
            span,
            bounds: functions,
        }
    }

    /// Width of a function in it; zero where it has no bounds.
    fn width(&self, function: usize) -> f64 {
        let width = self.bounds[function].width();
        if width.is_finite() { width } else { 0.0 }
    }
}

/// Widths of what functions take on over a span of time (s) wherever particles are; of those without bounds, which nothing can be told of, infinite.
fn anywhere(courses: &Courses, span: Interval, all: &mut Vec<Interval>) -> Vec<f64> {
    courses.bounds(span, all);
    let widths = courses.functions.iter().map(|&(_, at)| all[at].width());
    widths
        .map(|width| if width.is_nan() { f64::INFINITY } else { width })
        .collect()
}

/// Widths of what functions take on between two times, s.
fn taken(courses: &Courses, start: f64, end: f64, all: &mut Vec<Interval>) -> Vec<f64> {
    let at = |number: u32| start + (end - start) * f64::from(number) / f64::from(PARTS);
    let spans = (0..PARTS).map(|number| Interval::new(at(number), at(number + 1)));
    let mut parts: Vec<Part> = spans.map(|span| Part::new(courses, span, all)).collect();
    let mut shown = Part::new(courses, Interval::point(start), all).bounds;
    let show = |t: f64, shown: &mut [Interval], all: &mut Vec<Interval>| {
        let there = Part::new(courses, Interval::point(t), all);
        for (shown, there) in shown.iter_mut().zip(there.bounds) {
            if there.width().is_finite() {
                *shown = shown.hull(there);
            }
        }
    };
    (1..=PARTS).for_each(|number| show(at(number), &mut shown, all));
    let mut halvings = 0;
    for function in 0..shown.len() {
        loop {
            let widths = parts.iter().map(|part| part.width(function)).enumerate();
            let widest = widths.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
            let span = parts[widest.0].span;
            let middle = 0.5 * (span.low + span.high);
            let is_sharp = widest.1 <= SHARP * shown[function].width() || middle <= span.low || middle >= span.high;
            if is_sharp || halvings == HALVED {
                break;
            }
            halvings += 1;
            show(middle, &mut shown, all);
            parts[widest.0] = Part::new(courses, Interval::new(span.low, middle), all);
            parts.push(Part::new(courses, Interval::new(middle, span.high), all));
        }
    }
    let hull = |function: usize| {
        let bounded = parts.iter().filter(|part| part.bounds[function].width().is_finite());
        bounded.map(|part| part.bounds[function]).reduce(Interval::hull)
    };
    (0..shown.len())
        .map(|function| hull(function).map_or(0.0, Interval::width))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::Operation::{Add, Divide, Multiply, Number, Power, Sin, Subtract, Time};

    fn sight(operations: &'static [crate::course::Operation], numbers: &[f64]) -> Sight {
        let functions: &[(&str, usize)] = Box::leak(vec![("load", operations.len() - 1)].into_boxed_slice());
        let courses = Courses {
            operations,
            numbers: numbers.to_vec(),
            tables: Vec::new(),
            functions,
            ..Courses::default()
        };
        Sight::new(vec![courses], 0.0, 100.0)
    }

    /// Walks over 100 s with steps that grow to what is asked for, and returns where they end.
    fn steps(operations: &'static [crate::course::Operation], numbers: &[f64]) -> Vec<f64> {
        let mut sight = sight(operations, numbers);
        let (mut times, mut wanted) = (vec![0.0], 1e-3);
        while times[times.len() - 1] < 100.0 {
            let t = times[times.len() - 1];
            let before = times[times.len().saturating_sub(2)];
            let h = sight.longest(before, t, wanted, 1e-10).step;
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

    /// The difference of two equal sines is zero, and nothing that can be bounded; nothing is told of one sine of which half a wave lies in a step.
    #[test]
    fn bounds_that_stay_wide_are_told() {
        let same = &[Time, Number(0), Multiply(0, 1), Sin(2), Sin(2), Subtract(3, 4)];
        let seen = sight(same, &[1e7]).longest(0.0, 0.0, 0.1, 1e-12);
        assert!(seen.unseen == Some("load") && seen.step > 1e-4, "{seen:?}");
        let seen = sight(&[Time, Sin(0)], &[]).longest(0.0, 0.0, 1.5, 1e-12);
        assert_eq!(seen.unseen, None, "{seen:?}");
    }
}
