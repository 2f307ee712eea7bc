//! Operations, and functions that are made of them.

use super::interval::Interval;
use super::path::Path;

/// What is looked up: columns at places among rows.
pub trait Lookup: Send + Sync {
    /// Bounds of a column (`order` 0) or its derivative (1) over places; of those beyond the rows nothing.
    fn bounds(&self, column: usize, order: usize, places: Interval) -> Interval;
    /// Bounds of the derivative of that over places; every number where it may jump.
    fn slopes(&self, column: usize, order: usize, places: Interval) -> Interval;
}

/// One operation; operands are indices of operations before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// Time, s.
    Time,
    /// Arclength of an axis, m.
    Place,
    /// Which of the vectors that are read, and its component in space: m of places.
    Vector(usize, usize),
    /// The same of its rate.
    Rate(usize, usize),
    /// What does not change: index into the numbers of a course.
    Number(usize),
    /// Sum.
    Add(usize, usize),
    /// Difference.
    Subtract(usize, usize),
    /// Product.
    Multiply(usize, usize),
    /// Quotient.
    Divide(usize, usize),
    /// Negation.
    Negate(usize),
    /// Integer power.
    Power(usize, u32),
    /// Sine.
    Sin(usize),
    /// Cosine.
    Cos(usize),
    /// Tangent.
    Tan(usize),
    /// Inverse sine.
    Asin(usize),
    /// Inverse cosine.
    Acos(usize),
    /// Inverse tangent.
    Atan(usize),
    /// Hyperbolic sine.
    Sinh(usize),
    /// Hyperbolic cosine.
    Cosh(usize),
    /// Hyperbolic tangent.
    Tanh(usize),
    /// Exponential.
    Exp(usize),
    /// Natural logarithm.
    Ln(usize),
    /// Square root.
    Sqrt(usize),
    /// Absolute value.
    Abs(usize),
    /// Lesser one.
    Min(usize, usize),
    /// Larger one.
    Max(usize, usize),
    /// Angle of the point with ordinate and abscissa.
    Atan2(usize, usize),
    /// Remainder that is not negative.
    Remainder(usize, usize),
    /// If the first is less than the second, or equal, the third, else the fourth. Where bounds leave that open, both.
    Select([usize; 4]),
    /// Column of a table (index into those of a course), order of its derivative, place.
    Lookup(usize, usize, usize, usize),
}

/// Functions of time, or of it and the place along an axis, that share operations.
#[derive(Default)]
pub struct Courses {
    /// Operations, operands first.
    pub operations: &'static [Operation],
    /// What does not change.
    pub numbers: Vec<f64>,
    /// What is looked up.
    pub tables: Vec<&'static dyn Lookup>,
    /// What each function belongs to, in the user's words, and the operation with its value.
    pub functions: &'static [(&'static str, usize)],
    /// Arclength that they are looked at, m; of no account where they do not change along an axis.
    pub place: f64,
    /// Whether they are positions that something is held at: forces follow from their second derivatives.
    pub are_positions: bool,
    /// Numbers of the markers in their scene whose vectors they read.
    pub markers: Vec<usize>,
    /// How these vectors go on; of one without, anyhow.
    pub paths: Vec<Path>,
}

impl Courses {
    /// Whether anything in them depends on where what they act on is.
    pub fn reads_vectors(&self) -> bool {
        let reads = |one: &Operation| matches!(one, Operation::Vector(..) | Operation::Rate(..));
        self.operations.iter().any(reads)
    }

    /// Bounds of every operation over a span of time, s, written to `all`.
    pub fn bounds(&self, span: Interval, all: &mut Vec<Interval>) {
        self.bounds_along(span, Interval::point(self.place), all);
    }

    /// The same over a part of an axis, m, too.
    pub fn bounds_along(&self, span: Interval, places: Interval, all: &mut Vec<Interval>) {
        all.clear();
        for &operation in self.operations {
            let bounds = self.of(operation, [span, places], all);
            all.push(bounds);
        }
    }

    pub(super) fn of(&self, operation: Operation, [span, places]: [Interval; 2], at: &[Interval]) -> Interval {
        match operation {
            Operation::Time => span,
            Operation::Place => places,
            Operation::Vector(vector, component) => self
                .paths
                .get(vector)
                .map_or(Interval::ALL, |path| path.bounds(component, span)),
            Operation::Rate(vector, component) => self
                .paths
                .get(vector)
                .map_or(Interval::ALL, |path| path.rates(component, span)),
            Operation::Number(index) => Interval::point(self.numbers[index]),
            Operation::Add(a, b) => at[a].add(at[b]),
            Operation::Subtract(a, b) => at[a].subtract(at[b]),
            Operation::Multiply(a, b) if a == b => at[a].power(2),
            Operation::Multiply(a, b) => at[a].multiply(at[b]),
            Operation::Divide(a, b) => at[a].divide(at[b]),
            Operation::Negate(a) => at[a].negate(),
            Operation::Power(a, n) => at[a].power(n),
            Operation::Sin(a) => at[a].sin(),
            Operation::Cos(a) => at[a].cos(),
            Operation::Tan(a) => at[a].tan(),
            Operation::Asin(a) => at[a].rising_within(-1.0, 1.0, f64::asin),
            Operation::Acos(a) => at[a].negate().rising_within(-1.0, 1.0, |x| (-x).acos()),
            Operation::Atan(a) => at[a].rising(f64::atan),
            Operation::Sinh(a) => at[a].rising(f64::sinh),
            Operation::Cosh(a) => at[a].cosh(),
            Operation::Tanh(a) => at[a].rising(f64::tanh),
            Operation::Exp(a) => at[a].rising(f64::exp),
            Operation::Ln(a) => at[a].rising_within(0.0, f64::INFINITY, f64::ln),
            Operation::Sqrt(a) => at[a].rising_within(0.0, f64::INFINITY, f64::sqrt),
            Operation::Abs(a) => at[a].abs(),
            Operation::Min(a, b) => at[a].min(at[b]),
            Operation::Max(a, b) => at[a].max(at[b]),
            Operation::Atan2(a, b) => at[a].atan2(at[b]),
            Operation::Remainder(a, b) => at[a].remainder(at[b]),
            Operation::Select([left, right, then, otherwise]) => {
                if at[left].high < at[right].low {
                    at[then]
                } else if at[left].low > at[right].high {
                    at[otherwise]
                } else {
                    at[then].hull(at[otherwise])
                }
            }
            Operation::Lookup(table, column, order, place) => self.tables[table].bounds(column, order, at[place]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bounds over spans contain every value at times within, and come close to them on short spans.
    #[test]
    fn bounds_contain_what_functions_take_on() {
        use Operation::*;
        type Case = (&'static [Operation], fn(f64) -> f64);
        let cases: [Case; 16] = [
            (&[Time, Sin(0), Power(1, 100)], |t| t.sin().powi(100)),
            (&[Time, Multiply(0, 0), Number(0), Add(1, 2), Divide(2, 3)], |t| {
                3.0 / (t * t + 3.0)
            }),
            (&[Time, Cos(0), Abs(1), Sqrt(2)], |t| t.cos().abs().sqrt()),
            (&[Time, Number(0), Min(0, 1), Negate(2), Exp(3)], |t| {
                (-t.min(3.0)).exp()
            }),
            (&[Time, Number(0), Max(0, 1), Ln(2)], |t| t.max(3.0).ln()),
            (&[Time, Number(0), Subtract(0, 1), Tanh(2), Asin(3)], |t| {
                (t - 3.0).tanh().asin()
            }),
            (&[Time, Sin(0), Acos(1)], |t| t.sin().acos()),
            (&[Time, Atan(0), Sinh(1), Cosh(2)], |t| t.atan().sinh().cosh()),
            (&[Time, Number(0), Remainder(0, 1)], |t| t.rem_euclid(3.0)),
            (&[Time, Number(0), Atan2(0, 1)], |t| t.atan2(3.0)),
            (&[Time, Sin(0), Number(0), Atan2(1, 0)], |t| t.sin().atan2(t)),
            (&[Time, Number(0), Cos(0), Atan2(1, 2)], |t| 3.0f64.atan2(t.cos())),
            (&[Time, Cos(0), Number(0), Negate(2), Atan2(3, 1)], |t| {
                (-3.0f64).atan2(t.cos())
            }),
            (&[Time, Tan(0)], f64::tan),
            (&[Time, Number(0), Sin(0), Select([0, 1, 0, 2])], |t| {
                if t <= 3.0 { t } else { t.sin() }
            }),
            (&[Time, Power(0, 3), Sin(1), Number(0), Multiply(2, 3)], |t| {
                3.0 * t.powi(3).sin()
            }),
        ];
        for (operations, function) in cases {
            let courses = Courses {
                operations,
                numbers: vec![3.0],
                tables: Vec::new(),
                functions: &[],
                place: 0.0,
                paths: Vec::new(),
                ..Courses::default()
            };
            let mut all = Vec::new();
            for (from, width) in [(-4.0, 9.0), (0.3, 1.1), (2.5, 1.0), (-1.7, 0.2), (1.0, 1e-6)] {
                courses.bounds(Interval::new(from, from + width), &mut all);
                let bounds = all[all.len() - 1];
                let mut taken = Interval::new(f64::INFINITY, f64::NEG_INFINITY);
                for part in 0..=1000 {
                    let value = function(from + width * f64::from(part) / 1000.0);
                    taken = taken.hull(Interval::point(value));
                }
                let round_off = 1e-12 * (1.0 + taken.high.abs().max(taken.low.abs()).min(1e12));
                let wider = bounds.wider(round_off);
                assert!(
                    wider.contains(taken),
                    "{operations:?} {from} {width}: {bounds:?} for {taken:?}"
                );
                if width < 1e-3 {
                    assert!(
                        bounds.width() < 6.0 * taken.width() + round_off,
                        "{operations:?}: {bounds:?} for {taken:?}"
                    );
                }
            }
        }
    }
}
