//! Frames: what they do at one time.

use crate::vector::{add, cross, subtract};

/// Motion of a frame at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMotion {
    /// Origin, m, inertial axes.
    pub position: [f64; 3],
    /// Velocity of the origin, m/s, inertial axes.
    pub velocity: [f64; 3],
    /// Acceleration of the origin, m/s^2, inertial axes.
    pub acceleration: [f64; 3],
    /// Rotation matrix A, rows first; its columns are the frame's axes in the inertial frame.
    pub rotation: [[f64; 3]; 3],
    /// Angular velocity, rad/s, frame axes.
    pub spin: [f64; 3],
    /// Its time derivative, rad/s^2, frame axes.
    pub spin_rate: [f64; 3],
    /// Third time derivative of the origin's position, m/s^3, inertial axes. Constraints on markers in
    /// a prescribed frame need it on their jerk level.
    pub jerk: [f64; 3],
    /// Second time derivative of the angular velocity, rad/s^3, frame axes; needed as `jerk`.
    pub spin_jerk: [f64; 3],
    /// Gravity of the fields on what the frame carries, m/s^2, inertial axes; the runtime sets it.
    pub field: [f64; 3],
}

impl FrameMotion {
    /// The inertial frame.
    pub const INERTIAL: FrameMotion = FrameMotion {
        position: [0.0; 3],
        velocity: [0.0; 3],
        acceleration: [0.0; 3],
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        spin: [0.0; 3],
        spin_rate: [0.0; 3],
        jerk: [0.0; 3],
        spin_jerk: [0.0; 3],
        field: [0.0; 3],
    };

    /// Whether pose, velocities and accelerations are numbers.
    pub(crate) fn is_finite(&self) -> bool {
        let vectors = [
            self.position,
            self.velocity,
            self.acceleration,
            self.spin,
            self.spin_rate,
        ];
        let values = vectors.iter().chain(&self.rotation).flatten();
        values.copied().all(f64::is_finite)
    }

    /// A direction in frame axes, given in inertial axes: `A^T d`.
    pub fn direction_to_frame(&self, d: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.rotation[0][i] * d[0] + self.rotation[1][i] * d[1] + self.rotation[2][i] * d[2])
    }

    /// A direction in inertial axes, given in frame axes: `A d`.
    pub fn direction_to_inertial(&self, d: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.rotation[i][0] * d[0] + self.rotation[i][1] * d[1] + self.rotation[i][2] * d[2])
    }

    /// A point in the frame, given in the inertial frame: `A^T (x - r)`.
    pub fn point_to_frame(&self, x: [f64; 3]) -> [f64; 3] {
        self.direction_to_frame(subtract(x, self.position))
    }

    /// A point in the inertial frame, given in the frame: `r + A p`.
    pub fn point_to_inertial(&self, p: [f64; 3]) -> [f64; 3] {
        add(self.position, self.direction_to_inertial(p))
    }

    /// Rate of a direction that changes in inertial axes, seen in the frame: `A^T d' - w x A^T d`.
    pub fn rate_to_frame(&self, d: [f64; 3], rate: [f64; 3]) -> [f64; 3] {
        subtract(
            self.direction_to_frame(rate),
            cross(self.spin, self.direction_to_frame(d)),
        )
    }

    /// Rate in inertial axes of a direction that changes in the frame: `A (d' + w x d)`.
    pub fn rate_to_inertial(&self, d: [f64; 3], rate: [f64; 3]) -> [f64; 3] {
        self.direction_to_inertial(add(rate, cross(self.spin, d)))
    }

    /// Acceleration of the origin minus gravity (m/s^2, inertial axes) and fields, frame axes: e of THEORY 2.
    pub fn felt(&self, gravity: [f64; 3]) -> [f64; 3] {
        self.direction_to_frame(subtract(self.acceleration, add(gravity, self.field)))
    }

    /// The frame in steady rotation: `scale` times its spin, which does not change; the origin's
    /// acceleration scales with the square, as in a uniform rotation.
    pub fn steady(&self, scale: f64) -> FrameMotion {
        FrameMotion {
            velocity: self.velocity.map(|v| scale * v),
            acceleration: self.acceleration.map(|a| scale * scale * a),
            spin: self.spin.map(|w| scale * w),
            spin_rate: [0.0; 3],
            jerk: self.jerk.map(|j| scale * scale * scale * j),
            spin_jerk: [0.0; 3],
            ..*self
        }
    }
}
