//! Geometrically exact rod with shear (Reissner, Simo) under a dead load at its tip, by shooting.
//!
//! ```text
//! r' = A (e_1 + C_n A^T n),    A' = A [k_0 + C_m A^T m],    n = P,    m' = - r' x n,    m(L) = M
//! ```
//!
//! Compliances may be zero: rigid in shear, inextensible.

use crate::Result;
use crate::dense::Matrix;

type Vector = [f64; 3];

/// A rod that begins in the origin along +x with axes x, y, z.
#[derive(Clone, Copy, Debug)]
pub struct Rod {
    /// Length of the stress-free axis, m.
    pub length: f64,
    /// `(1/EA, 1/(k_s G A), 1/(k_s G A))`, 1/N.
    pub force_compliance: Vector,
    /// `(1/GJ, 1/EI_yy, 1/EI_zz)` about the rod's x, y, z, 1/(N m^2).
    pub moment_compliance: Vector,
    /// Curvature of the stress-free axis, rod axes, 1/m.
    pub curvature: Vector,
    /// Steps of the integration (Runge-Kutta, order 4).
    pub steps: usize,
}

/// Where a rod's tip is.
#[derive(Clone, Copy, Debug)]
pub struct Tip {
    /// Position, m.
    pub position: Vector,
    /// Axes of the section, columns x, y, z.
    pub axes: [Vector; 3],
}

/// r, quaternion (scalar first), m.
type State = [f64; 10];

impl Rod {
    /// The tip under the dead force `force` (N) and moment `moment` (N m), inertial axes, in `loads` equal steps.
    ///
    /// # Errors
    /// If Newton's method fails; the message names the load step.
    pub fn tip(&self, force: Vector, moment: Vector, loads: usize) -> Result<Tip> {
        let mut root = [0.0; 3];
        let mut end = self.shoot(root, [0.0; 3]);
        for step in 1..=loads {
            let scale = step as f64 / loads as f64;
            let (force, moment) = (force.map(|x| scale * x), moment.map(|x| scale * x));
            end = self
                .newton(&mut root, force, moment)
                .map_err(|error| format!("load step {step} of {loads}: {error}"))?;
        }
        Ok(Tip {
            position: [end[0], end[1], end[2]],
            axes: rotation([end[3], end[4], end[5], end[6]]),
        })
    }

    /// The root's moment for which the tip's is as given.
    fn newton(&self, root: &mut Vector, force: Vector, moment: Vector) -> Result<State> {
        let size = |v: Vector| v.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
        let unit = self.length * size(force) + size(moment) + f64::MIN_POSITIVE;
        let error = |end: &State| [end[7] - moment[0], end[8] - moment[1], end[9] - moment[2]];
        for _ in 0..50 {
            let end = self.shoot(*root, force);
            let miss = error(&end);
            let mut jacobian = Matrix::zero(3);
            let h = 1e-5 * unit;
            for j in 0..3 {
                let shifted = |by: f64| {
                    let mut root = *root;
                    root[j] += by;
                    error(&self.shoot(root, force))
                };
                let (up, down) = (shifted(h), shifted(-h));
                (0..3).for_each(|i| jacobian.set(i, j, 0.5 * (up[i] - down[i]) / h));
            }
            let step = jacobian.solve(&miss)?;
            (0..3).for_each(|k| root[k] -= step[k]);
            if step.iter().all(|x| x.abs() <= 1e-13 * unit) || size(miss) <= 1e-13 * unit {
                return Ok(self.shoot(*root, force));
            }
        }
        Err("shooting does not converge: take more load steps".into())
    }

    /// The state at the tip from the root's moment.
    fn shoot(&self, root: Vector, force: Vector) -> State {
        let h = self.length / self.steps as f64;
        let mut y = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, root[0], root[1], root[2]];
        let shifted = |y: &State, k: &State, by: f64| std::array::from_fn(|i| y[i] + by * k[i]);
        for _ in 0..self.steps {
            let k1 = self.slope(&y, force);
            let k2 = self.slope(&shifted(&y, &k1, 0.5 * h), force);
            let k3 = self.slope(&shifted(&y, &k2, 0.5 * h), force);
            let k4 = self.slope(&shifted(&y, &k3, h), force);
            for i in 0..y.len() {
                y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
        }
        y
    }

    /// Derivatives along the rod.
    fn slope(&self, y: &State, force: Vector) -> State {
        let p = [y[3], y[4], y[5], y[6]];
        let axes = rotation(p);
        let local = |v: Vector| axes.map(|axis| dot(axis, v));
        let (n, m) = (local(force), local([y[7], y[8], y[9]]));
        let mut tangent = [0.0; 3];
        for k in 0..3 {
            let stretch = f64::from(u8::from(k == 0)) + self.force_compliance[k] * n[k];
            (0..3).for_each(|i| tangent[i] += stretch * axes[k][i]);
        }
        let turn: Vector = std::array::from_fn(|k| self.curvature[k] + self.moment_compliance[k] * m[k]);
        // p' = 1/2 p (0, turn): the curvature is given in the rod's own axes.
        let moment = cross(force, tangent);
        [
            tangent[0],
            tangent[1],
            tangent[2],
            -0.5 * (p[1] * turn[0] + p[2] * turn[1] + p[3] * turn[2]),
            0.5 * (p[0] * turn[0] + p[2] * turn[2] - p[3] * turn[1]),
            0.5 * (p[0] * turn[1] + p[3] * turn[0] - p[1] * turn[2]),
            0.5 * (p[0] * turn[2] + p[1] * turn[1] - p[2] * turn[0]),
            moment[0],
            moment[1],
            moment[2],
        ]
    }
}

fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

fn cross(u: Vector, v: Vector) -> Vector {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

/// Columns of the rotation of a quaternion, whatever its norm.
fn rotation(p: [f64; 4]) -> [Vector; 3] {
    let s = 2.0 / (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
    let [w, x, y, z] = p;
    [
        [1.0 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)],
        [s * (x * y - w * z), 1.0 - s * (x * x + z * z), s * (y * z + w * x)],
        [s * (x * z + w * y), s * (y * z - w * x), 1.0 - s * (x * x + y * y)],
    ]
}
