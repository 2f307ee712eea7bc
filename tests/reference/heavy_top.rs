//! Heavy top (THEORY 9.7) as a body that turns about a fixed point: no constraint, no multiplier among its states.
//!
//! States: angular velocity in body axes (3, rad/s), then the quaternion of the orientation (4, scalar first). With the
//! inertia `J_o = J + m (X.X 1 - X X^T)` about the fixed point
//!
//! ```text
//! J_o W' + W x J_o W = X x A^T m g,        p' = 1/2 p (0, W)
//! ```
//!
//! The multiplier of `C = r - A X = 0` follows from `m r'' + lambda = m g`.

use crate::dense::Matrix;
use crate::system::System;

/// Mass, kg.
pub const MASS: f64 = 15.0;
/// Inertia about the centre of mass, body axes, kg m^2.
pub const INERTIA: [f64; 3] = [0.234375, 0.46875, 0.234375];
/// From the fixed point to the centre of mass, body axes, m.
pub const ARM: [f64; 3] = [0.0, 1.0, 0.0];
/// Gravity, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
/// States at t = 0.
pub const START: [f64; 7] = [0.0, 150.0, -4.61538, 1.0, 0.0, 0.0, 0.0];

/// The top of THEORY 9.7.
#[derive(Clone, Copy, Debug, Default)]
pub struct HeavyTop;

/// What is compared at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Instant {
    /// Centre of mass, inertial, m.
    pub center: [f64; 3],
    /// Its velocity, inertial, m/s.
    pub velocity: [f64; 3],
    /// Multiplier, inertial, N.
    pub multiplier: [f64; 3],
}

impl HeavyTop {
    /// Angular acceleration, body axes, rad/s^2. The arm is a principal axis, so that `J_o` is diagonal.
    fn angular_acceleration(y: &[f64]) -> [f64; 3] {
        let spin = [y[0], y[1], y[2]];
        let arm = dot(ARM, ARM);
        let inertia: [f64; 3] = std::array::from_fn(|k| INERTIA[k] + MASS * (arm - ARM[k] * ARM[k]));
        let momentum: [f64; 3] = std::array::from_fn(|k| inertia[k] * spin[k]);
        let a = orientation(y);
        let weight: [f64; 3] = std::array::from_fn(|k| MASS * (0..3).map(|i| a[i][k] * GRAVITY[i]).sum::<f64>());
        let (torque, gyroscopic) = (cross(ARM, weight), cross(spin, momentum));
        std::array::from_fn(|k| (torque[k] - gyroscopic[k]) / inertia[k])
    }

    /// Centre of mass and multiplier at the states `y`.
    pub fn instant(y: &[f64]) -> Instant {
        let spin = [y[0], y[1], y[2]];
        let a = orientation(y);
        let inertial = |body: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| dot(a[i], body)) };
        let (tangential, towards) = (cross(Self::angular_acceleration(y), ARM), cross(spin, cross(spin, ARM)));
        let acceleration = inertial(std::array::from_fn(|k| tangential[k] + towards[k]));
        Instant {
            center: inertial(ARM),
            velocity: inertial(cross(spin, ARM)),
            multiplier: std::array::from_fn(|k| MASS * (GRAVITY[k] - acceleration[k])),
        }
    }

    /// Total energy, J; potential zero at the fixed point's height.
    pub fn energy(y: &[f64]) -> f64 {
        let Instant { center, velocity, .. } = Self::instant(y);
        let turning: f64 = (0..3).map(|k| INERTIA[k] * y[k] * y[k]).sum();
        0.5 * (MASS * dot(velocity, velocity) + turning) - MASS * dot(GRAVITY, center)
    }
}

impl System for HeavyTop {
    fn size(&self) -> usize {
        7
    }

    fn rate(&self, _t: f64, y: &[f64], rate: &mut [f64]) {
        rate[..3].copy_from_slice(&Self::angular_acceleration(y));
        let (spin, scalar, vector) = ([y[0], y[1], y[2]], y[3], [y[4], y[5], y[6]]);
        let turned = cross(vector, spin);
        rate[3] = -0.5 * dot(vector, spin);
        for k in 0..3 {
            rate[4 + k] = 0.5 * (scalar * spin[k] + turned[k]);
        }
    }

    /// By central differences: explicit methods do not ask for it.
    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix) {
        let (mut ahead, mut behind) = ([0.0; 7], [0.0; 7]);
        for j in 0..7 {
            let h = 1e-6 * y[j].abs().max(1.0);
            let mut moved = y.to_vec();
            moved[j] = y[j] + h;
            self.rate(t, &moved, &mut ahead);
            moved[j] = y[j] - h;
            self.rate(t, &moved, &mut behind);
            for i in 0..7 {
                jacobian.set(i, j, (ahead[i] - behind[i]) / (2.0 * h));
            }
        }
    }
}

/// Rotation matrix of the states' quaternion, whatever its norm; rows first.
fn orientation(y: &[f64]) -> [[f64; 3]; 3] {
    let [s, x, y, z] = [y[3], y[4], y[5], y[6]];
    let scale = 2.0 / (s * s + x * x + y * y + z * z);
    [
        [
            1.0 - scale * (y * y + z * z),
            scale * (x * y - s * z),
            scale * (x * z + s * y),
        ],
        [
            scale * (x * y + s * z),
            1.0 - scale * (x * x + z * z),
            scale * (y * z - s * x),
        ],
        [
            scale * (x * z - s * y),
            scale * (y * z + s * x),
            1.0 - scale * (x * x + y * y),
        ],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
