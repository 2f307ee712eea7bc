//! Rotations as unit quaternions, and the exponential map with its tangents (THEORY 7.2). Right
//! increments in body axes throughout: `exp(theta + d) ~ exp(theta) exp(T(theta) d)`.

use crate::archive::{Archive, Keep};
use crate::vector::{Matrix, Vector, cross, norm};

/// Angles (rad) below this use series.
const SMALL: f64 = 1e-2;

/// A rotation of space; `matrix` has the axes of the turned frame as columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Scalar part, then vector part; of norm one.
    quaternion: [f64; 4],
}

impl Keep for Rotation {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.quaternion.keep(archive);
    }
}

impl Default for Rotation {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Rotation {
    /// No rotation.
    pub const IDENTITY: Self = Self {
        quaternion: [1.0, 0.0, 0.0, 0.0],
    };

    /// `exp(theta)`: the rotation about `theta` by its norm, rad.
    pub fn exp(theta: Vector) -> Self {
        let angle = norm(theta);
        let half = angle / 2.0;
        let factor = if angle < SMALL {
            let s = half * half;
            0.5 * (1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0)))
        } else {
            half.sin() / angle
        };
        let [x, y, z] = theta.map(|component| factor * component);
        Self {
            quaternion: [half.cos(), x, y, z],
        }
    }

    /// The rotation nearest to a matrix, rows first, which is a rotation up to round-off.
    pub fn from_matrix(a: &Matrix) -> Self {
        // The largest of the four components is found from the diagonal without cancellation.
        let trace = a[0][0] + a[1][1] + a[2][2];
        let candidates = [trace, a[0][0], a[1][1], a[2][2]];
        let largest = (0..4)
            .max_by(|&i, &j| candidates[i].total_cmp(&candidates[j]))
            .unwrap_or(0);
        let mut q = [0.0; 4];
        if largest == 0 {
            q[0] = 1.0 + trace;
            q[1] = a[2][1] - a[1][2];
            q[2] = a[0][2] - a[2][0];
            q[3] = a[1][0] - a[0][1];
        } else {
            let (i, j, k) = (largest - 1, largest % 3, (largest + 1) % 3);
            q[0] = a[k][j] - a[j][k];
            q[1 + i] = 1.0 + 2.0 * a[i][i] - trace;
            q[1 + j] = a[j][i] + a[i][j];
            q[1 + k] = a[k][i] + a[i][k];
        }
        Self { quaternion: q }.normalised()
    }

    /// Rotation matrix A, rows first.
    pub fn matrix(&self) -> Matrix {
        let [w, x, y, z] = self.quaternion;
        [
            [
                1.0 - 2.0 * (y * y + z * z),
                2.0 * (x * y - w * z),
                2.0 * (x * z + w * y),
            ],
            [
                2.0 * (x * y + w * z),
                1.0 - 2.0 * (x * x + z * z),
                2.0 * (y * z - w * x),
            ],
            [
                2.0 * (x * z - w * y),
                2.0 * (y * z + w * x),
                1.0 - 2.0 * (x * x + y * y),
            ],
        ]
    }

    /// `A exp(theta)`, of norm one to round-off.
    pub fn turned(&self, theta: Vector) -> Self {
        self.times(&Self::exp(theta))
    }

    /// The product `A B`, of norm one to round-off.
    pub fn times(&self, other: &Self) -> Self {
        let ([a, au @ ..], [b, bu @ ..]) = (self.quaternion, other.quaternion);
        let c = cross(au, bu);
        let vector: Vector = std::array::from_fn(|i| a * bu[i] + b * au[i] + c[i]);
        let scalar = a * b - au[0] * bu[0] - au[1] * bu[1] - au[2] * bu[2];
        Self {
            quaternion: [scalar, vector[0], vector[1], vector[2]],
        }
        .normalised()
    }

    /// The inverse rotation, `A^T`.
    pub fn inverse(&self) -> Self {
        let [w, x, y, z] = self.quaternion;
        Self {
            quaternion: [w, -x, -y, -z],
        }
    }

    /// The rotation vector theta with `exp(theta) = A` and norm up to pi, rad.
    pub fn log(&self) -> Vector {
        let [w, u @ ..] = self.quaternion;
        let sine = norm(u);
        if sine == 0.0 {
            return [0.0; 3];
        }
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        let angle = 2.0 * sine.atan2(sign * w);
        u.map(|component| sign * component * angle / sine)
    }

    fn normalised(self) -> Self {
        let size = self.quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self {
            quaternion: self.quaternion.map(|x| x / size),
        }
    }
}

/// `T(theta) = 1 - (1 - cos t)/t^2 [theta] + (t - sin t)/t^3 [theta]^2`, t = |theta|: body increments
/// of `exp(theta)`, dpi = T dtheta; angular velocity in body axes, w = T dtheta/dt.
pub fn tangent_map(theta: Vector) -> Matrix {
    let t = norm(theta);
    let s = t * t;
    let (first, second) = if t < SMALL {
        (
            0.5 * (1.0 - s / 12.0 * (1.0 - s / 30.0)),
            (1.0 - s / 20.0 * (1.0 - s / 42.0)) / 6.0,
        )
    } else {
        ((1.0 - t.cos()) / s, (t - t.sin()) / (s * t))
    };
    polynomial(theta, -first, second)
}

/// `T(theta)^-1 = 1 + [theta]/2 + (1 - (t/2) cot(t/2))/t^2 [theta]^2`, for |theta| < 2 pi.
pub fn inverse_tangent_map(theta: Vector) -> Matrix {
    let t = norm(theta);
    let s = t * t;
    let second = if t < SMALL {
        (1.0 + s / 60.0 * (1.0 + s / 42.0)) / 12.0
    } else {
        (1.0 - 0.5 * t / (0.5 * t).tan()) / s
    };
    polynomial(theta, 0.5, second)
}

/// `1 + first [theta] + second [theta]^2`
fn polynomial(theta: Vector, first: f64, second: f64) -> Matrix {
    let [x, y, z] = theta;
    let skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let square = x * x + y * y + z * z;
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let unit = if i == j { 1.0 - second * square } else { 0.0 };
            unit + first * skew[i][j] + second * theta[i] * theta[j]
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::{apply, identity, multiply, transpose};

    fn difference(a: &Matrix, b: &Matrix) -> f64 {
        (0..9)
            .map(|i| (a[i / 3][i % 3] - b[i / 3][i % 3]).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn matrices_are_rotations_and_come_back() {
        for theta in [
            [0.3, -1.2, 0.4],
            [1e-3, 2e-3, -1e-3],
            [3.0, 0.1, -0.2],
            [0.0; 3],
            [0.0, 0.0, 3.1],
        ] {
            let rotation = Rotation::exp(theta);
            let a = rotation.matrix();
            assert!(difference(&multiply(&transpose(&a), &a), &identity()) < 1e-15);
            assert!(difference(&Rotation::from_matrix(&a).matrix(), &a) < 1e-15);
            let back = rotation.log();
            assert!((0..3).all(|i| (back[i] - theta[i]).abs() < 1e-14));
            assert!(difference(&rotation.times(&rotation.inverse()).matrix(), &identity()) < 1e-15);
        }
        let about_z = Rotation::exp([0.0, 0.0, 0.5]).matrix();
        assert!(
            (about_z[1][0] - 0.5_f64.sin()).abs() < 1e-16,
            "a positive angle turns x to y"
        );
    }

    #[test]
    fn tangent_maps_are_derivatives_of_the_exponential() {
        // At the border of the series both forms must serve.
        for size in [1e-3, 0.009_999, 0.010_001, 1.3] {
            let theta = [0.48 * size, -0.6 * size, 0.64 * size];
            let map = tangent_map(theta);
            assert!(difference(&multiply(&map, &inverse_tangent_map(theta)), &identity()) < 1e-14);
            for axis in 0..3 {
                let step = 1e-5;
                let at = |h: f64| {
                    let mut moved = theta;
                    moved[axis] += h;
                    Rotation::exp(theta).inverse().times(&Rotation::exp(moved)).log()
                };
                let (up, down) = (at(step), at(-step));
                let mut unit = [0.0; 3];
                unit[axis] = 1.0;
                let column = apply(&map, unit);
                for i in 0..3 {
                    assert!(((up[i] - down[i]) / (2.0 * step) - column[i]).abs() < 1e-9);
                }
            }
        }
    }
}
