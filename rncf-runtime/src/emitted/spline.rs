//! Cubic splines through points in space.

use crate::space::Vector;

/// A cubic spline through points, with the sum of the chords as parameter. At an end with a direction its slope is that unit
/// vector; at one without, its second derivative vanishes.
pub(super) struct Spline {
    /// Parameters of the points, m.
    knots: Vec<f64>,
    points: Vec<Vector>,
    /// Second derivatives at the points, 1/m.
    bends: Vec<Vector>,
}

impl Spline {
    /// Through points (m), with unit vectors along the ends that have a direction.
    ///
    /// # Errors
    ///
    /// Fewer than two points, two neighbours at one place, or no finite ones: a sentence without its subject.
    pub(super) fn through(points: &[[f64; 3]], directions: [Option<Vector>; 2]) -> Result<Self, String> {
        if points.len() < 2 {
            return Err("needs at least two points".to_string());
        }
        let points: Vec<Vector> = points.iter().copied().map(Vector::from).collect();
        let mut knots = vec![0.0];
        for (at, pair) in points.windows(2).enumerate() {
            let chord = (pair[1] - pair[0]).norm();
            if !(chord > 0.0 && chord.is_finite()) {
                let (first, place) = (at + 1, pair[1].as_slice());
                return Err(format!(
                    "has its points {first} and {} at one place, or not at finite ones: {place:?} m",
                    first + 1
                ));
            }
            knots.push(knots[at] + chord);
        }
        let last = points.len() - 1;
        for (direction, [at, next]) in directions.iter().zip([[0, 1], [last - 1, last]]) {
            let chord = points[next] - points[at];
            if direction.is_some_and(|direction| direction.dot(&chord) <= 0.0) {
                return Err(format!(
                    "leads away from its point {} at point {}, in the direction that is given there",
                    if at == 0 { 2 } else { last },
                    if at == 0 { 1 } else { last + 1 }
                ));
            }
        }
        Ok(Self {
            bends: bends(&knots, &points, directions),
            points,
            knots,
        })
    }

    /// Parameters of the points, m.
    pub(super) fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Position (m) and its derivative by the parameter.
    pub(super) fn at(&self, at: f64) -> [Vector; 2] {
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
        [
            combine([left, right, cubic(left), cubic(right)]),
            combine([-1.0 / width, 1.0 / width, -slope(left), slope(right)]),
        ]
    }
}

/// Second derivatives of the spline: Thomas's elimination of a tridiagonal system.
fn bends(knots: &[f64], points: &[Vector], [first, last]: [Option<Vector>; 2]) -> Vec<Vector> {
    let count = points.len();
    let mut bends = vec![Vector::zeros(); count];
    let mut factors = vec![0.0; count];
    let chord = |at: usize| 1.0 / (knots[at + 1] - knots[at]) * (points[at + 1] - points[at]);
    let end = count - 1;
    if let Some(slope) = first {
        factors[0] = 0.5;
        bends[0] = 3.0 / (knots[1] - knots[0]) * (chord(0) - slope);
    }
    for at in 1..end {
        let (before, after) = (knots[at] - knots[at - 1], knots[at + 1] - knots[at]);
        let pivot = 2.0 * (before + after) - before * factors[at - 1];
        factors[at] = after / pivot;
        let right = 6.0 * (chord(at) - chord(at - 1));
        bends[at] = 1.0 / pivot * (right - before * bends[at - 1]);
    }
    if let Some(slope) = last {
        let before = knots[end] - knots[end - 1];
        let pivot = before * (2.0 - factors[end - 1]);
        bends[end] = 1.0 / pivot * (6.0 * (slope - chord(end - 1)) - before * bends[end - 1]);
    }
    for at in (0..end).rev() {
        let next = bends[at + 1];
        bends[at] -= factors[at] * next;
    }
    bends
}
