//! Smooth curves as the run time has them: what the check of starts needs to know of them.

use crate::check::values::arithmetic::{Vector, add, norm, scale, subtract};

/// Parts of a span in the sum of its arclength.
const PARTS: usize = 64;

/// Parts of a function in that sum.
const OF_FUNCTION: usize = 1024;

/// A smooth curve by its arclength.
pub struct Curve<'a> {
    /// Place and slope at a parameter.
    path: Box<dyn Fn(f64) -> (Vector, Vector) + 'a>,
    /// Where the parts begin that its length is the sum of, and where the last one ends.
    starts: Vec<f64>,
}

impl<'a> Curve<'a> {
    /// Along a function of a parameter that goes from one number to another.
    pub fn along([from, to]: [f64; 2], path: impl Fn(f64) -> [Vector; 2] + 'a) -> Self {
        let range = to - from;
        let path = move |part: f64| {
            let [place, slope] = path(from + part * range);
            (place, scale(range, slope))
        };
        Self {
            path: Box::new(path),
            starts: (0..=OF_FUNCTION).map(|at| at as f64 / OF_FUNCTION as f64).collect(),
        }
    }

    /// The cubic spline through points, no two neighbours at one place, with these directions at its ends or none.
    pub fn through(points: &[Vector], directions: [Option<Vector>; 2]) -> Self {
        let spline = Spline::through(points, directions);
        let starts = spline.knots.windows(2).flat_map(|knots| {
            let (start, width) = (knots[0], (knots[1] - knots[0]) / PARTS as f64);
            (0..PARTS).map(move |part| start + part as f64 * width)
        });
        Self {
            starts: starts.chain(spline.knots.last().copied()).collect(),
            path: Box::new(move |at| spline.evaluate(at)),
        }
    }

    /// Arclength.
    pub fn length(&self) -> f64 {
        self.lengths().sum()
    }

    /// Place and unit tangent at an arclength.
    pub fn at(&self, x: f64) -> (Vector, Vector) {
        let mut rest = x;
        let mut found = self.starts[self.starts.len() - 1];
        for (ends, length) in self.starts.windows(2).zip(self.lengths()) {
            if rest <= length {
                found = ends[0] + (ends[1] - ends[0]) * rest / length;
                break;
            }
            rest -= length;
        }
        let (place, slope) = (self.path)(found);
        (place, scale(1.0 / norm(slope), slope))
    }

    /// Lengths of the parts by Simpson's rule.
    fn lengths(&self) -> impl Iterator<Item = f64> {
        self.starts.windows(2).map(|ends| {
            let width = ends[1] - ends[0];
            let speed = |share: f64| norm((self.path)(ends[0] + share * width).1);
            width / 6.0 * (speed(0.0) + 4.0 * speed(0.5) + speed(1.0))
        })
    }
}

/// A cubic spline with the sum of the chords as parameter; natural at ends without a direction.
struct Spline {
    knots: Vec<f64>,
    points: Vec<Vector>,
    /// Second derivatives at the points.
    bends: Vec<Vector>,
}

impl Spline {
    fn through(points: &[Vector], [first, last]: [Option<Vector>; 2]) -> Self {
        let mut knots = vec![0.0];
        for pair in points.windows(2) {
            knots.push(knots[knots.len() - 1] + norm(subtract(pair[1], pair[0])));
        }
        let count = points.len();
        let chord = |at: usize| scale(1.0 / (knots[at + 1] - knots[at]), subtract(points[at + 1], points[at]));
        let (mut bends, mut factors) = (vec![[0.0; 3]; count], vec![0.0; count]);
        if let Some(slope) = first {
            let after = knots[1] - knots[0];
            factors[0] = 0.5;
            bends[0] = scale(3.0 / after, subtract(chord(0), slope));
        }
        for at in 1..count - 1 {
            let (before, after) = (knots[at] - knots[at - 1], knots[at + 1] - knots[at]);
            let pivot = 2.0 * (before + after) - before * factors[at - 1];
            factors[at] = after / pivot;
            let right = scale(6.0, subtract(chord(at), chord(at - 1)));
            bends[at] = scale(1.0 / pivot, subtract(right, scale(before, bends[at - 1])));
        }
        if let Some(slope) = last {
            let (end, before) = (count - 1, knots[count - 1] - knots[count - 2]);
            let pivot = before * (2.0 - factors[end - 1]);
            let right = scale(6.0, subtract(slope, chord(end - 1)));
            bends[end] = scale(1.0 / pivot, subtract(right, scale(before, bends[end - 1])));
        }
        for at in (0..count - 1).rev() {
            bends[at] = subtract(bends[at], scale(factors[at], bends[at + 1]));
        }
        Self {
            points: points.to_vec(),
            knots,
            bends,
        }
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
