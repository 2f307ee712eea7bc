//! Bounds of the second order. Interval arithmetic forgets that two operands move together: of `(r . v) / |r|`, the rate of a length, it knows as little as that
//! each of them changes, and its bounds are as wide as the span is long. The mean value theorem gives others: the value in the middle, and the bounds of the
//! slope times the way from there. They are as wide as the square of the span. What both contain is passed on.

use super::interval::Interval;
use super::operations::{Courses, Operation};

/// Bounds of all operations over a span of time, of their slopes, and their values in the middle of the span.
#[derive(Default)]
pub struct Close {
    all: Vec<Interval>,
    slopes: Vec<Interval>,
    middles: Vec<Interval>,
}

impl Close {
    /// Bounds of an operation.
    pub fn bounds(&self, operation: usize) -> Interval {
        self.all[operation]
    }
}

impl Courses {
    /// Close bounds of every operation over a span of time, s.
    pub fn close_bounds(&self, span: Interval, close: &mut Close) {
        let Close { all, slopes, middles } = close;
        [&mut *all, &mut *slopes, &mut *middles]
            .into_iter()
            .for_each(Vec::clear);
        let place = Interval::point(self.place);
        let middle = Interval::point(span.low + 0.5 * span.width());
        let away = span.subtract(middle);
        for &operation in self.operations {
            let value = self.of(operation, [span, place], all);
            let there = self.of(operation, [middle, place], middles);
            let slope = self.slope(operation, value, span, (all, slopes));
            let mean = there.add(slope.multiply(away));
            all.push(value.both(mean));
            slopes.push(slope);
            middles.push(there);
        }
    }

    /// Bounds of the derivative of an operation by time, from those of its value, and of the values and slopes of its operands.
    fn slope(
        &self,
        operation: Operation,
        value: Interval,
        span: Interval,
        (at, slope): (&[Interval], &[Interval]),
    ) -> Interval {
        let one = Interval::point(1.0);
        let path = |vector: usize| self.paths.get(vector);
        // Of what stands still nothing else matters, whatever it is of.
        let chain = |a: usize, outer: &dyn Fn(Interval) -> Interval| {
            if slope[a] == Interval::point(0.0) {
                return slope[a];
            }
            outer(at[a]).multiply(slope[a])
        };
        match operation {
            Operation::Time => one,
            Operation::Place | Operation::Number(_) => Interval::point(0.0),
            Operation::Vector(vector, component) => {
                path(vector).map_or(Interval::ALL, |path| path.rates(component, span))
            }
            Operation::Rate(vector, component) => {
                path(vector).map_or(Interval::ALL, |path| path.accelerations(component, span))
            }
            Operation::Add(a, b) => slope[a].add(slope[b]),
            Operation::Subtract(a, b) => slope[a].subtract(slope[b]),
            Operation::Multiply(a, b) if a == b => chain(a, &|a| Interval::point(2.0).multiply(a)),
            Operation::Multiply(a, b) => slope[a].multiply(at[b]).add(at[a].multiply(slope[b])),
            Operation::Divide(a, b) => slope[a].subtract(value.multiply(slope[b])).divide(at[b]),
            Operation::Negate(a) => slope[a].negate(),
            Operation::Power(a, n) => chain(a, &|a| {
                Interval::point(f64::from(n)).multiply(a.power(n.saturating_sub(1)))
            }),
            Operation::Sin(a) => chain(a, &Interval::cos),
            Operation::Cos(a) => chain(a, &|a| a.sin().negate()),
            Operation::Tan(a) => chain(a, &|_| one.add(value.power(2))),
            Operation::Asin(a) => chain(a, &|a| one.divide(root(one.subtract(a.power(2))))),
            Operation::Acos(a) => chain(a, &|a| one.divide(root(one.subtract(a.power(2)))).negate()),
            Operation::Atan(a) => chain(a, &|a| one.divide(one.add(a.power(2)))),
            Operation::Sinh(a) => chain(a, &Interval::cosh),
            Operation::Cosh(a) => chain(a, &|a| a.rising(f64::sinh)),
            Operation::Tanh(a) => chain(a, &|_| one.subtract(value.power(2))),
            Operation::Exp(a) => chain(a, &|_| value),
            Operation::Ln(a) => chain(a, &|a| one.divide(a)),
            Operation::Sqrt(a) => chain(a, &|_| Interval::point(0.5).divide(value)),
            Operation::Abs(a) if at[a].low >= 0.0 => slope[a],
            Operation::Abs(a) if at[a].high <= 0.0 => slope[a].negate(),
            Operation::Abs(a) => slope[a].hull(slope[a].negate()),
            Operation::Min(a, b) | Operation::Max(a, b) => slope[a].hull(slope[b]),
            Operation::Atan2(a, b) if at[b].low > 0.0 => {
                let turn = slope[a].multiply(at[b]).subtract(at[a].multiply(slope[b]));
                turn.divide(at[a].power(2).add(at[b].power(2)))
            }
            Operation::Select([left, right, then, _]) if at[left].high < at[right].low => slope[then],
            Operation::Select([left, right, _, otherwise]) if at[left].low > at[right].high => slope[otherwise],
            Operation::Lookup(table, column, order, place) => {
                if slope[place] == Interval::point(0.0) {
                    return slope[place];
                }
                self.tables[table]
                    .slopes(column, order, at[place])
                    .multiply(slope[place])
            }
            // They may jump.
            Operation::Atan2(..) | Operation::Remainder(..) | Operation::Select(_) => Interval::ALL,
        }
    }
}

/// The square root of what is not negative.
fn root(of: Interval) -> Interval {
    of.rising_within(0.0, f64::INFINITY, f64::sqrt)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::path::Path;

    /// The rate of the distance from the origin of what goes round it is zero: natural bounds know nothing of that, close ones are as wide as the square of the span.
    #[test]
    fn what_moves_together_has_close_bounds() {
        use Operation::{Add, Divide, Multiply, Rate, Sqrt, Vector};
        let courses = Courses {
            operations: &[
                Vector(0, 0),
                Vector(0, 1),
                Rate(0, 0),
                Rate(0, 1),
                Multiply(0, 2),
                Multiply(1, 3),
                Add(4, 5),
                Multiply(0, 0),
                Multiply(1, 1),
                Add(7, 8),
                Sqrt(9),
                Divide(6, 10),
            ],
            paths: vec![Path {
                from: 0.0,
                middle: [0.0; 3],
                velocity: [0.0; 3],
                acceleration: [0.0; 3],
                arm: [0.4, 0.0, 0.0],
                quarter: [0.0, 0.4, 0.0],
                spin: 9.0,
                spin_rate: 0.0,
            }],
            ..Courses::default()
        };
        let (mut all, mut close) = (Vec::new(), Close::default());
        let mut before = f64::INFINITY;
        for h in [0.02, 0.002, 0.0002] {
            let span = Interval::new(0.1, 0.1 + h);
            courses.bounds(span, &mut all);
            courses.close_bounds(span, &mut close);
            let bounds = close.bounds(11);
            assert!(bounds.low <= 1e-12 && bounds.high >= -1e-12, "{bounds:?}");
            assert!(
                bounds.width() < 0.3 * all[11].width() && bounds.width() < 0.02 * before,
                "{h}: {bounds:?}"
            );
            before = bounds.width();
        }
    }
}
