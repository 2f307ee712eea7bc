//! Space curves through points: cubic splines with continuous curvature, by arclength.

use super::gauss::FIVE;
use crate::space::Vector;

/// Pieces of one span of the spline in the table of its arclength.
const PIECES: usize = 16;
/// A natural cubic spline through points, with the sum of the chords as parameter; its second derivative vanishes at both
/// ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    /// Parameters of the points, m.
    knots: Vec<f64>,
    points: Vec<Vector>,
    /// Second derivatives at the points, 1/m.
    bends: Vec<Vector>,
    /// Arclength (m) at parameters that divide every span evenly.
    lengths: Vec<f64>,
    /// Why there is no such curve.
    mistake: Option<String>,
}

impl Spline {
    /// Through points (m), at least two, no two neighbours at one place: [`Spline::mistake`] tells where they are not.
    pub fn through(points: &[[f64; 3]]) -> Self {
        let points: Vec<Vector> = points.iter().copied().map(Vector::from).collect();
        let mut knots = vec![0.0];
        let mut mistake = (points.len() < 2).then(|| "needs at least two points".to_string());
        for (at, pair) in points.windows(2).enumerate() {
            let chord = (pair[1] - pair[0]).norm();
            if !(chord > 0.0 && chord.is_finite()) {
                let (next, place) = (at + 1, pair[1].as_slice());
                let text = format!("has its points {at} and {next} at one place, or not at finite ones: {place:?} m");
                mistake = mistake.or(Some(text));
            }
            knots.push(knots[at] + chord);
        }
        if mistake.is_some() {
            knots = vec![0.0, 1.0];
        }
        let points = if mistake.is_some() {
            vec![Vector::zeros(), Vector::x()]
        } else {
            points
        };
        let mut spline = Self {
            bends: bends(&knots, &points),
            lengths: vec![0.0],
            points,
            knots,
            mistake,
        };
        for place in 0..PIECES * (spline.points.len() - 1) {
            let (span, from) = (place / PIECES, (place % PIECES) as f64);
            let width = (spline.knots[span + 1] - spline.knots[span]) / PIECES as f64;
            let start = spline.knots[span] + from * width;
            let length = spline.length_between(start, start + width);
            spline.lengths.push(spline.lengths[place] + length);
        }
        spline
    }

    /// Why there is no curve through the points, a sentence without its subject.
    pub fn mistake(&self) -> Option<&str> {
        self.mistake.as_deref()
    }

    /// Arclength, m.
    pub fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Position (m) and unit tangent at the fraction `u` in [0, 1] of the arclength.
    pub fn at(&self, u: f64) -> (Vector, Vector) {
        let (place, slope, _) = self.evaluate(self.parameter(u));
        (place, 1.0 / slope.norm() * slope)
    }

    /// The parameter where the arclength is a fraction of the whole: Newton's iteration in the piece of the table.
    fn parameter(&self, u: f64) -> f64 {
        let wanted = u.clamp(0.0, 1.0) * self.length();
        let place = self
            .lengths
            .partition_point(|&length| length <= wanted)
            .clamp(1, self.lengths.len() - 1)
            - 1;
        let (span, from) = (place / PIECES, (place % PIECES) as f64);
        let width = (self.knots[span + 1] - self.knots[span]) / PIECES as f64;
        let start = self.knots[span] + from * width;
        let share = (wanted - self.lengths[place]) / (self.lengths[place + 1] - self.lengths[place]);
        let mut at = start + share * width;
        for _ in 0..8 {
            let missing = wanted - self.lengths[place] - self.length_between(start, at);
            let change = missing / self.evaluate(at).1.norm();
            at = (at + change).clamp(start, start + width);
            if change.abs() <= 1e-15 * self.length() {
                break;
            }
        }
        at
    }

    fn length_between(&self, from: f64, to: f64) -> f64 {
        let speed = |(place, weight): (f64, f64)| weight * self.evaluate(from + place * (to - from)).1.norm();
        (to - from) * FIVE.map(speed).iter().sum::<f64>()
    }

    /// Position, and first and second derivative by the parameter.
    fn evaluate(&self, at: f64) -> (Vector, Vector, Vector) {
        let span = self
            .knots
            .partition_point(|&knot| knot <= at)
            .clamp(1, self.knots.len() - 1)
            - 1;
        let width = self.knots[span + 1] - self.knots[span];
        let right = (at - self.knots[span]) / width;
        let left = 1.0 - right;
        let [p, q] = [self.points[span], self.points[span + 1]];
        let [a, b] = [self.bends[span], self.bends[span + 1]];
        let square = width * width / 6.0;
        let combine = |of: [f64; 4]| {
            let ends = of[0] * p + of[1] * q;
            ends + (of[2] * a + of[3] * b)
        };
        let cubic = |t: f64| square * (t * t * t - t);
        let slope = |t: f64| width / 6.0 * (3.0 * t * t - 1.0);
        (
            combine([left, right, cubic(left), cubic(right)]),
            combine([-1.0 / width, 1.0 / width, -slope(left), slope(right)]),
            combine([0.0, 0.0, left, right]),
        )
    }
}

/// Second derivatives of the natural spline: Thomas's elimination of a tridiagonal system.
fn bends(knots: &[f64], points: &[Vector]) -> Vec<Vector> {
    let count = points.len();
    let mut bends = vec![Vector::zeros(); count];
    let mut factors = vec![0.0; count];
    let chord = |at: usize| 1.0 / (knots[at + 1] - knots[at]) * (points[at + 1] - points[at]);
    for at in 1..count.saturating_sub(1) {
        let (before, after) = (knots[at] - knots[at - 1], knots[at + 1] - knots[at]);
        let pivot = 2.0 * (before + after) - before * factors[at - 1];
        factors[at] = after / pivot;
        let right = 6.0 * (chord(at) - chord(at - 1));
        bends[at] = 1.0 / pivot * (right - before * bends[at - 1]);
    }
    for at in (1..count.saturating_sub(1)).rev() {
        let next = bends[at + 1];
        bends[at] -= factors[at] * next;
    }
    bends
}

#[cfg(test)]
mod tests {
    use crate::emitted::curve::*;

    #[test]
    fn a_spline_through_points_of_a_circle_has_its_length_and_tangent() {
        let count = 40;
        let point = |at: usize| {
            let angle = at as f64 / count as f64;
            [10.0 * angle.sin(), 10.0 * (1.0 - angle.cos()), 0.0]
        };
        let points: Vec<[f64; 3]> = (0..=count).map(point).collect();
        let spline = Spline::through(&points);
        assert!((spline.length() - 10.0).abs() < 1e-5, "{}", spline.length());
        let (place, tangent) = spline.at(0.5);
        let wanted = Vector::new(10.0 * 0.5_f64.sin(), 10.0 * (1.0 - 0.5_f64.cos()), 0.0);
        assert!((place - wanted).norm() < 1e-5, "{place:?}");
        assert!((tangent[0] - 0.5_f64.cos()).abs() < 1e-5, "{tangent:?}");
        let (_, slope, bend) = spline.evaluate(spline.parameter(0.5));
        let curvature = slope.cross(&bend).norm() / slope.norm().powi(3);
        assert!((curvature - 0.1).abs() < 1e-5);
    }

    #[test]
    fn a_spline_through_points_of_a_line_is_the_line() {
        let points = [[0.0; 3], [1.0, 2.0, 0.0], [3.0, 6.0, 0.0], [3.5, 7.0, 0.0]];
        let spline = Spline::through(&points);
        let end = Vector::from(points[3]);
        let whole = end.norm();
        assert!((spline.length() - whole).abs() < 1e-14 * whole);
        for u in [0.0, 0.1, 0.37, 0.999, 1.0] {
            let (place, tangent) = spline.at(u);
            assert!((place - u * end).norm() < 1e-14 * whole);
            assert!((tangent - 1.0 / whole * end).norm() < 1e-14);
        }
    }

    #[test]
    fn points_at_one_place_are_refused_by_their_number() {
        let refused = Spline::through(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
        assert!(refused.mistake().is_some_and(|text| text.contains("points 1 and 2")));
    }
}
