//! Inertia by hand: sums over nodal vectors with a mass matrix, THEORY 2 and 2.1.

use super::super::frame::FrameAction;
use super::super::free::RigidSpec;
use super::super::parts::CarriedTangent;
use crate::vector::{Matrix, Vector, add, apply, cross, dot, identity, multiply, scale, skew, subtract};

/// Vectors with masses: `mass` between vectors, `counts[a]` one for positions and zero for slopes.
pub struct Inertia<'a> {
    pub mass: &'a [f64],
    pub counts: &'a [f64],
    pub dimension: usize,
}

/// e, w, w' in space: planar ones turn about the third axis.
fn spatial(dimension: usize, frame: &FrameAction) -> [Vector; 3] {
    if dimension == 2 {
        let about = |w: Vector| [0.0, 0.0, w[0]];
        let [x, y, _] = frame.acceleration;
        return [[x, y, 0.0], about(frame.spin), about(frame.spin_rate)];
    }
    [frame.acceleration, frame.spin, frame.spin_rate]
}

fn sum(matrices: &[Matrix]) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrices.iter().map(|matrix| matrix[i][j]).sum()))
}

fn times(factor: f64, matrix: Matrix) -> Matrix {
    matrix.map(|row| scale(factor, row))
}

/// `d/dw (w x (w x u))`
fn centrifugal(w: Vector, u: Vector) -> Matrix {
    let inner = dot(w, u);
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { inner } else { 0.0 } + w[i] * u[j] - 2.0 * u[i] * w[j]))
}

impl Inertia<'_> {
    fn vector(&self, q: &[f64], a: usize) -> Vector {
        let mut vector = [0.0; 3];
        vector[..self.dimension].copy_from_slice(&q[a * self.dimension..(a + 1) * self.dimension]);
        vector
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
        (0..self.number()).fold([0.0; 3], |sum, b| add(sum, scale(self.m(a, b), self.vector(q, b))))
    }

    /// Inertia parts of R_a, in space.
    fn rows(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64]) -> Vec<Vector> {
        let [e, w, rate] = spatial(self.dimension, frame);
        let row = |of: usize| {
            let (mq, mv, ma) = (self.product(q, of), self.product(v, of), self.product(a, of));
            let turning = add(scale(2.0, cross(w, mv)), add(cross(rate, mq), cross(w, cross(w, mq))));
            add(scale(self.first(of), e), add(ma, turning))
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

    /// Adds their derivatives with respect to q and q'.
    pub fn tangent(&self, frame: &FrameAction, stiffness: &mut [f64], damping: &mut [f64]) {
        let [_, w, rate] = spatial(self.dimension, frame);
        let (turning, spin) = (sum(&[skew(rate), multiply(&skew(w), &skew(w))]), skew(w));
        let (d, size) = (self.dimension, self.dimension * self.number());
        for a in 0..self.number() {
            for b in 0..self.number() {
                for i in 0..d {
                    for j in 0..d {
                        let place = (a * d + i) * size + b * d + j;
                        stiffness[place] += self.m(a, b) * turning[i][j];
                        damping[place] += 2.0 * self.m(a, b) * spin[i][j];
                    }
                }
            }
        }
    }

    /// Adds force and moment on the frame.
    pub fn carried(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64], out: &mut [f64]) {
        let [mut force, mut moment] = [[0.0; 3]; 2];
        for (of, row) in self.rows(frame, q, v, a).into_iter().enumerate() {
            force = add(force, scale(self.counts[of], row));
            moment = add(moment, cross(self.vector(q, of), row));
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

    /// Derivatives of force and moment, THEORY 2.1.
    pub fn carried_tangent(&self, frame: &FrameAction, q: &[f64], v: &[f64], a: &[f64], out: &mut CarriedTangent) {
        let [e, w, rate] = spatial(self.dimension, frame);
        let n = self.number();
        let spin = skew(w);
        let turning = sum(&[skew(rate), multiply(&spin, &spin)]);
        let rows = self.rows(frame, q, v, a);
        let ([mut moment, mut moment_rate], mut total) = ([[0.0; 3]; 2], 0.0);
        let [mut inertia, mut coriolis] = [[[0.0; 3]; 3]; 2];
        for b in 0..n {
            moment = add(moment, scale(self.first(b), self.vector(q, b)));
            moment_rate = add(moment_rate, scale(self.first(b), self.vector(v, b)));
            total += self.counts[b] * self.first(b);
            let at = skew(self.vector(q, b));
            inertia = sum(&[inertia, times(-1.0, multiply(&at, &skew(self.product(q, b))))]);
            coriolis = sum(&[coriolis, times(-2.0, multiply(&at, &skew(self.product(v, b))))]);
        }
        let spinning = sum(&[
            coriolis,
            multiply(&spin, &inertia),
            times(-1.0, skew(apply(&inertia, w))),
        ]);
        let mut mass = vec![
            [times(total, identity()), skew(moment)],
            [times(-1.0, skew(moment)), inertia],
        ];
        let mut damping = vec![[sum(&[times(-2.0, skew(moment_rate)), centrifugal(w, moment)]), spinning]];
        let mut stiffness = Vec::new();
        let mut by_spin = Vec::new();
        for b in 0..n {
            let d = self.first(b);
            let at = skew(self.product(q, b));
            mass.push([times(d, identity()), at]);
            damping.push([times(2.0 * d, spin), times(2.0, multiply(&at, &spin))]);
            // g_b without the acceleration of the origin
            let g = subtract(rows[b], scale(d, e));
            stiffness.push([
                times(d, turning),
                sum(&[times(-d, skew(e)), times(-1.0, skew(g)), multiply(&at, &turning)]),
            ]);
            by_spin.push(sum(&[
                times(-2.0, skew(self.product(v, b))),
                centrifugal(w, self.product(q, b)),
            ]));
        }
        out.mass = self.flatten(&mass, 2);
        out.damping = self.flatten(&damping, 1);
        out.stiffness = self.flatten(&stiffness, 0);
        let turns = if self.dimension == 2 { vec![2] } else { vec![0, 1, 2] };
        out.spin.clear();
        for block in &by_spin {
            for row in block.iter().take(self.dimension) {
                out.spin.extend(turns.iter().map(|&turn| row[turn]));
            }
        }
    }

    /// Rows first, of columns with a block of force and one of moment each; the first `before`
    /// columns belong to e, w' or to w.
    fn flatten(&self, columns: &[[Matrix; 2]], before: usize) -> Vec<f64> {
        let mut out = Vec::new();
        for row in self.kept() {
            for (place, blocks) in columns.iter().enumerate() {
                let is_turn = place + 1 == before;
                let kept: Vec<usize> = match (self.dimension, is_turn) {
                    (3, _) => vec![0, 1, 2],
                    (_, true) => vec![2],
                    (_, false) => vec![0, 1],
                };
                out.extend(kept.into_iter().map(|j| blocks[row / 3][row % 3][j]));
            }
        }
        out
    }
}

/// Adds force and moment of a rigid body, THEORY 3.1.
pub fn rigid(spec: &RigidSpec, frame: &FrameAction, out: &mut [f64]) {
    let (e, w, rate) = (frame.acceleration, frame.spin, frame.spin_rate);
    let force = add(
        scale(spec.mass, e),
        add(cross(rate, spec.moment), cross(w, cross(w, spec.moment))),
    );
    let moment = add(
        cross(spec.moment, e),
        add(apply(&spec.inertia, rate), cross(w, apply(&spec.inertia, w))),
    );
    for i in 0..3 {
        out[i] += force[i];
        out[3 + i] += moment[i];
    }
}

/// Its derivatives.
pub fn rigid_tangent(spec: &RigidSpec, frame: &FrameAction, out: &mut CarriedTangent) {
    let w = frame.spin;
    let whole = Inertia {
        mass: &[],
        counts: &[],
        dimension: 3,
    };
    out.mass = whole.flatten(
        &[
            [times(spec.mass, identity()), skew(spec.moment)],
            [times(-1.0, skew(spec.moment)), spec.inertia],
        ],
        2,
    );
    let spinning = sum(&[
        multiply(&skew(w), &spec.inertia),
        times(-1.0, skew(apply(&spec.inertia, w))),
    ]);
    out.damping = whole.flatten(&[[centrifugal(w, spec.moment), spinning]], 1);
    out.spin.clear();
    out.stiffness.clear();
}
