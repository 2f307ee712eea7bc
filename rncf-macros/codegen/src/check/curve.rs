//! Natural cubic splines through points, as the run time has them: what the check of starts needs to know of a curve.

use super::start::{Vector, add, norm, scale, subtract};

/// Parts of a span in the sum of its arclength.
const PARTS: usize = 64;

/// A natural cubic spline with the sum of the chords as parameter.
pub struct Spline {
    knots: Vec<f64>,
    points: Vec<Vector>,
    /// Second derivatives at the points.
    bends: Vec<Vector>,
}

impl Spline {
    /// Through points, no two neighbours at one place.
    pub fn through(points: &[Vector]) -> Self {
        let mut knots = vec![0.0];
        for pair in points.windows(2) {
            knots.push(knots[knots.len() - 1] + norm(subtract(pair[1], pair[0])));
        }
        let count = points.len();
        let chord = |at: usize| scale(1.0 / (knots[at + 1] - knots[at]), subtract(points[at + 1], points[at]));
        let (mut bends, mut factors) = (vec![[0.0; 3]; count], vec![0.0; count]);
        for at in 1..count - 1 {
            let (before, after) = (knots[at] - knots[at - 1], knots[at + 1] - knots[at]);
            let pivot = 2.0 * (before + after) - before * factors[at - 1];
            factors[at] = after / pivot;
            let right = scale(6.0, subtract(chord(at), chord(at - 1)));
            bends[at] = scale(1.0 / pivot, subtract(right, scale(before, bends[at - 1])));
        }
        for at in (1..count - 1).rev() {
            bends[at] = subtract(bends[at], scale(factors[at], bends[at + 1]));
        }
        Self {
            points: points.to_vec(),
            knots,
            bends,
        }
    }

    /// Arclength.
    pub fn length(&self) -> f64 {
        self.steps().map(|(_, length)| length).sum()
    }

    /// Place and unit tangent at an arclength.
    pub fn at(&self, x: f64) -> (Vector, Vector) {
        let mut rest = x;
        let mut found = 0.0;
        for (start, length) in self.steps() {
            let width = self.width(start);
            if rest <= length {
                found = start + width * rest / length;
                break;
            }
            rest -= length;
            found = start + width;
        }
        let (place, slope) = self.evaluate(found);
        (place, scale(1.0 / norm(slope), slope))
    }

    /// Starts of the parts of all spans, and their lengths by Simpson's rule.
    fn steps(&self) -> impl Iterator<Item = (f64, f64)> {
        let spans = self.knots.windows(2).flat_map(|knots| {
            let width = (knots[1] - knots[0]) / PARTS as f64;
            (0..PARTS).map(move |part| (knots[0] + part as f64 * width, width))
        });
        spans.map(|(start, width)| {
            let speed = |share: f64| norm(self.evaluate(start + share * width).1);
            (start, width / 6.0 * (speed(0.0) + 4.0 * speed(0.5) + speed(1.0)))
        })
    }

    fn width(&self, at: f64) -> f64 {
        let span = self.span(at);
        (self.knots[span + 1] - self.knots[span]) / PARTS as f64
    }

    fn span(&self, at: f64) -> usize {
        let beyond = self.knots.partition_point(|&knot| knot <= at);
        beyond.clamp(1, self.knots.len() - 1) - 1
    }

    fn evaluate(&self, at: f64) -> (Vector, Vector) {
        let span = self.span(at);
        let width = self.knots[span + 1] - self.knots[span];
        let right = (at - self.knots[span]) / width;
        let left = 1.0 - right;
        let cubic = |t: f64| width * width / 6.0 * (t * t * t - t);
        let slope = |t: f64| width / 6.0 * (3.0 * t * t - 1.0);
        let combine = |of: [f64; 4]| {
            let ends = add(scale(of[0], self.points[span]), scale(of[1], self.points[span + 1]));
            add(
                ends,
                add(scale(of[2], self.bends[span]), scale(of[3], self.bends[span + 1])),
            )
        };
        (
            combine([left, right, cubic(left), cubic(right)]),
            combine([-1.0 / width, 1.0 / width, -slope(left), slope(right)]),
        )
    }
}
