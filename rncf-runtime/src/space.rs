//! Vectors, matrices and rotations of space are nalgebra's. Here is what it lacks: the exponential map at all angles with its
//! tangents (THEORY 7.2), products of rotations that stay of norm one, and some sums of products.
//!
//! Right increments in body axes throughout: `exp(theta + d) ~ exp(theta) exp(T(theta) d)`.

use crate::archive::{Archive, Keep};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// Three components.
pub type Vector = Vector3<f64>;
/// Three by three. nalgebra stores columns: entries are `a[(row, column)]`, and [`from_rows`] takes rows.
pub type Matrix = Matrix3<f64>;
/// A rotation of space; [`matrix`] has the axes of the turned frame as columns.
pub type Rotation = UnitQuaternion<f64>;

/// Angles (rad) below this use series.
const SMALL: f64 = 1e-2;

impl Keep for Vector {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.iter_mut().for_each(|component| component.keep(archive));
    }
}

/// Scalar part, then vector part.
impl Keep for Rotation {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let [x, y, z, w]: [f64; 4] = self.coords.into();
        let mut kept = [w, x, y, z];
        kept.keep(archive);
        let [w, x, y, z] = kept;
        *self = Self::new_unchecked(Quaternion::new(w, x, y, z));
    }
}

/// The matrix with these rows.
pub const fn from_rows([a, b, c]: &[[f64; 3]; 3]) -> Matrix {
    Matrix::new(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2])
}

/// The rows of a matrix.
pub fn rows(a: &Matrix) -> [[f64; 3]; 3] {
    a.transpose().into()
}

/// Three components from `first` on.
pub fn three(values: &[f64], first: usize) -> Vector {
    Vector::new(values[first], values[first + 1], values[first + 2])
}

/// `exp(theta)`: the rotation about `theta` by its norm, rad. nalgebra's is the identity below 4e-16 rad.
pub fn exp(theta: Vector) -> Rotation {
    let angle = theta.norm();
    let half = angle / 2.0;
    let factor = if angle < SMALL {
        let s = half * half;
        0.5 * (1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0)))
    } else {
        half.sin() / angle
    };
    Rotation::new_unchecked(Quaternion::from_parts(half.cos(), factor * theta))
}

/// The rotation of a matrix that is one up to round-off.
pub fn from_matrix(a: &Matrix) -> Rotation {
    let rotation = Rotation::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*a));
    Rotation::new_normalize(rotation.into_inner())
}

/// Rotation matrix A. Its diagonal is 1 less squares, so that small rotations have less round-off than nalgebra's.
pub fn matrix(rotation: &Rotation) -> Matrix {
    let Quaternion { coords } = **rotation;
    let [x, y, z, w]: [f64; 4] = coords.into();
    Matrix::new(
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - w * z),
        2.0 * (x * z + w * y),
        2.0 * (x * y + w * z),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - w * x),
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        1.0 - 2.0 * (x * x + y * y),
    )
}

/// `A exp(theta)`, of norm one to round-off.
pub fn turned(rotation: &Rotation, theta: Vector) -> Rotation {
    product(rotation, &exp(theta))
}

/// The product `A B`, of norm one to round-off however many follow each other: nalgebra's loses it.
pub fn product(a: &Rotation, b: &Rotation) -> Rotation {
    Rotation::new_normalize(a.into_inner() * b.into_inner())
}

/// `T(theta) = 1 - (1 - cos t)/t^2 [theta] + (t - sin t)/t^3 [theta]^2`, t = |theta|: body increments
/// of `exp(theta)`, dpi = T dtheta; angular velocity in body axes, w = T dtheta/dt.
pub fn tangent_map(theta: Vector) -> Matrix {
    let t = theta.norm();
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
    let t = theta.norm();
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
    let skew = theta.cross_matrix();
    let square = theta.norm_squared();
    Matrix::from_fn(|i, j| {
        let unit = if i == j { 1.0 - second * square } else { 0.0 };
        unit + first * skew[(i, j)] + second * theta[i] * theta[j]
    })
}

/// `sum_a u_a x v_a`
pub(crate) fn crossed(u: &[Vector], v: &[Vector]) -> Vector {
    u.iter().zip(v).fold(Vector::zeros(), |sum, (u, v)| sum + u.cross(v))
}

/// `sum_a [u_a]^T [v_a]`, `[u]^T [v] = (u . v) 1 - v u^T`
pub(crate) fn second_moment(u: &[Vector], v: &[Vector]) -> Matrix {
    let mut sum = Matrix::zeros();
    for (u, v) in u.iter().zip(v) {
        let trace = u.dot(v);
        for i in 0..3 {
            sum[(i, i)] += trace;
            for j in 0..3 {
                sum[(i, j)] -= v[i] * u[j];
            }
        }
    }
    sum
}

/// `sqrt(a^2 + b^2)` without overflow: where one of them is zero, as in a plane, at the price of a comparison.
pub(crate) fn magnitude(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        b.abs()
    } else if b == 0.0 {
        a.abs()
    } else {
        a.hypot(b)
    }
}

/// A unit vector normal to the unit vector `t`.
pub fn perpendicular(t: Vector) -> Vector {
    let normal = t.cross(&Vector::ith(t.iamin(), 1.0));
    1.0 / normal.norm() * normal
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(a: &Matrix, b: &Matrix) -> f64 {
        (a - b).amax()
    }

    /// As in checkpoints of earlier versions.
    #[test]
    fn a_rotation_is_kept_with_its_scalar_part_first() {
        let mut rotation = exp(Vector::new(0.3, -1.2, 0.4));
        let mut bytes = Vec::new();
        rotation.keep(&mut Archive::writing(&mut bytes));
        assert_eq!(bytes[..8], rotation.w.to_le_bytes());
        let mut back = Rotation::identity();
        back.keep(&mut Archive::reading(&bytes));
        assert_eq!(back.coords, rotation.coords);
    }

    #[test]
    fn matrices_are_rotations_and_come_back() {
        for theta in [
            Vector::new(0.3, -1.2, 0.4),
            Vector::new(1e-3, 2e-3, -1e-3),
            Vector::new(3.0, 0.1, -0.2),
            Vector::zeros(),
            Vector::new(0.0, 0.0, 3.1),
        ] {
            let rotation = exp(theta);
            let a = matrix(&rotation);
            assert!(difference(&(a.transpose() * a), &Matrix::identity()) < 1e-15);
            assert!(difference(&matrix(&from_matrix(&a)), &a) < 1e-15);
            assert!((rotation.scaled_axis() - theta).amax() < 1e-14);
            assert!(difference(&matrix(&product(&rotation, &rotation.inverse())), &Matrix::identity()) < 1e-15);
            assert!((rotation * theta - a * theta).amax() < 1e-14, "nalgebra turns alike");
        }
        let about_z = matrix(&exp(Vector::new(0.0, 0.0, 0.5)));
        assert!(
            (about_z[(1, 0)] - 0.5_f64.sin()).abs() < 1e-16,
            "a positive angle turns x to y"
        );
    }

    #[test]
    fn rows_come_back_as_rows() {
        let given = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]];
        let a = from_rows(&given);
        assert_eq!((a[(0, 1)], a * Vector::x()), (2.0, Vector::new(1.0, 4.0, 7.0)));
        assert_eq!(rows(&a), given);
    }

    /// What stands here in place of nalgebra's own: where that is as good, this test says so by failing.
    #[test]
    fn small_rotations_keep_their_digits() {
        let tiny = Vector::new(1e-17, 0.0, 0.0);
        assert_eq!(exp(tiny).scaled_axis(), tiny);
        assert_eq!(Rotation::from_scaled_axis(tiny).scaled_axis(), Vector::zeros());
        let [mut ours, mut theirs] = [0.0_f64; 2];
        for step in 0..1000 {
            let rotation = exp(1e-4 * Vector::new(step as f64, 300.0 - step as f64, 0.3 * step as f64));
            let off = |a: Matrix| difference(&(a.transpose() * a), &Matrix::identity());
            ours = ours.max(off(matrix(&rotation)));
            theirs = theirs.max(off(rotation.to_rotation_matrix().into_inner()));
        }
        assert!(ours < 3e-16 && theirs > 1.5 * ours, "{ours:.1e} {theirs:.1e}");
    }

    #[test]
    fn many_products_stay_rotations() {
        let turn = exp(Vector::new(0.013, -0.004, 0.009));
        let many = |of: &dyn Fn(&Rotation) -> Rotation| (0..100_000).fold(Rotation::identity(), |sum, _| of(&sum));
        let (ours, theirs) = (many(&|sum| product(sum, &turn)), many(&|sum| sum * turn));
        assert!((ours.norm() - 1.0).abs() < 3e-16);
        assert!((theirs.norm() - 1.0).abs() > 1e-14, "nalgebra leaves the norm alone");
    }

    #[test]
    fn tangent_maps_are_derivatives_of_the_exponential() {
        // At the border of the series both forms must serve.
        for size in [1e-3, 0.009_999, 0.010_001, 1.3] {
            let theta = size * Vector::new(0.48, -0.6, 0.64);
            let map = tangent_map(theta);
            assert!(difference(&(map * inverse_tangent_map(theta)), &Matrix::identity()) < 1e-14);
            for axis in 0..3 {
                let step = 1e-5;
                let at = |h: f64| product(&exp(theta).inverse(), &exp(theta + Vector::ith(axis, h))).scaled_axis();
                let by_difference = (at(step) - at(-step)) / (2.0 * step);
                assert!((by_difference - map.column(axis)).amax() < 1e-9);
            }
        }
    }
}
