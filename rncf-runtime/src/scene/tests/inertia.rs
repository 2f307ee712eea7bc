//! Inertia by hand: sums over nodal vectors with a mass matrix, THEORY 2.

use crate::emitted::RigidSpec;
use crate::modal::action::FrameAction;
use crate::space::Vector;

/// Vectors with masses: `mass` between vectors, `counts[a]` one for positions and zero for slopes.
pub struct Inertia<'a> {
    pub mass: &'a [f64],
    pub counts: &'a [f64],
    pub dimension: usize,
}

/// e, w, w' in space: planar ones turn about the third axis.
fn spatial(dimension: usize, frame: &FrameAction) -> [Vector; 3] {
    if dimension == 2 {
        let about = |w: Vector| Vector::new(0.0, 0.0, w[0]);
        let e = frame.acceleration;
        return [Vector::new(e[0], e[1], 0.0), about(frame.spin), about(frame.spin_rate)];
    }
    [frame.acceleration, frame.spin, frame.spin_rate]
}

impl Inertia<'_> {
    fn vector(&self, q: &[f64], a: usize) -> Vector {
        let mut vector = [0.0; 3];
        vector[..self.dimension].copy_from_slice(&q[a * self.dimension..(a + 1) * self.dimension]);
        vector.into()
    }

    fn number(&self) -> usize {
        self.counts.len()
    }

    fn m(&self, a: usize, b: usize) -> f64 {
        self.mass[a * self.number() + b]
    }

    /// d^a
    fn first(&self, a: usize) -> f64 {
        (0..self.number()).map(|b| self.m(a, b) * self.counts[b]).sum()
    }

    /// M^ab u_b
    fn product(&self, q: &[f64], a: usize) -> Vector {
        (0..self.number()).fold(Vector::zeros(), |sum, b| sum + self.m(a, b) * self.vector(q, b))
    }

    /// Inertia parts of R_a, in space.
    fn rows(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64]) -> Vec<Vector> {
        let [e, w, rate] = spatial(self.dimension, frame);
        let row = |of: usize| {
            let (mq, mv, ma) = (self.product(q, of), self.product(v, of), self.product(a, of));
            let turning = 2.0 * w.cross(&mv) + (rate.cross(&mq) + w.cross(&w.cross(&mq)));
            self.first(of) * e + (ma + turning)
        };
        (0..self.number()).map(row).collect()
    }

    /// Adds the inertia forces on the vectors.
    pub fn force(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64], out: &mut [f64]) {
        for (of, row) in self.rows(frame, q, v, a).into_iter().enumerate() {
            for c in 0..self.dimension {
                out[of * self.dimension + c] += row[c];
            }
        }
    }

    /// Adds force and moment on the frame.
    pub fn carried(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64], out: &mut [f64]) {
        let [mut force, mut moment] = [Vector::zeros(); 2];
        for (of, row) in self.rows(frame, q, v, a).into_iter().enumerate() {
            force += self.counts[of] * row;
            moment += self.vector(q, of).cross(&row);
        }
        for (place, row) in self.kept().into_iter().enumerate() {
            out[place] += if row < 3 { force[row] } else { moment[row - 3] };
        }
    }

    /// Rows of (force, moment) that there are.
    fn kept(&self) -> Vec<usize> {
        if self.dimension == 2 {
            vec![0, 1, 5]
        } else {
            (0..6).collect()
        }
    }
}

/// Adds force and moment of a rigid body, THEORY 3.1.
pub fn rigid(spec: &RigidSpec, frame: &FrameAction, out: &mut [f64]) {
    let (e, w, rate) = (frame.acceleration, frame.spin, frame.spin_rate);
    let force = spec.mass * e + (rate.cross(&spec.moment) + w.cross(&w.cross(&spec.moment)));
    let moment = spec.moment.cross(&e) + (spec.inertia * rate + w.cross(&(spec.inertia * w)));
    for i in 0..3 {
        out[i] += force[i];
        out[3 + i] += moment[i];
    }
}
