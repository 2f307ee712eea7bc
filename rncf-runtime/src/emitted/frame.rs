//! Frames: what they do at one time.

use crate::space::{Matrix, Vector};

/// Motion of a frame at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMotion {
    /// Origin, m, inertial axes.
    pub position: Vector,
    /// Velocity of the origin, m/s, inertial axes.
    pub velocity: Vector,
    /// Acceleration of the origin, m/s^2, inertial axes.
    pub acceleration: Vector,
    /// Rotation matrix A: its columns are the frame's axes in the inertial frame.
    pub rotation: Matrix,
    /// Angular velocity, rad/s, frame axes.
    pub spin: Vector,
    /// Its time derivative, rad/s^2, frame axes.
    pub spin_rate: Vector,
    /// Third time derivative of the origin's position, m/s^3, inertial axes. Constraints on markers in
    /// a prescribed frame need it on their jerk level.
    pub jerk: Vector,
    /// Second time derivative of the angular velocity, rad/s^3, frame axes; needed as `jerk`.
    pub spin_jerk: Vector,
    /// Gravity of the fields on what the frame carries, m/s^2, inertial axes; the runtime sets it.
    pub field: Vector,
}

const ZERO: Vector = Vector::new(0.0, 0.0, 0.0);

impl FrameMotion {
    /// The inertial frame.
    pub const INERTIAL: FrameMotion = FrameMotion {
        position: ZERO,
        velocity: ZERO,
        acceleration: ZERO,
        rotation: Matrix::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        spin: ZERO,
        spin_rate: ZERO,
        jerk: ZERO,
        spin_jerk: ZERO,
        field: ZERO,
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
        let mut values = vectors.iter().flatten().chain(&self.rotation);
        values.all(|value| value.is_finite())
    }

    /// A direction in frame axes, given in inertial axes: `A^T d`.
    pub fn direction_to_frame(&self, d: Vector) -> Vector {
        self.rotation.tr_mul(&d)
    }

    /// A direction in inertial axes, given in frame axes: `A d`.
    pub fn direction_to_inertial(&self, d: Vector) -> Vector {
        self.rotation * d
    }

    /// A point in the frame, given in the inertial frame: `A^T (x - r)`.
    pub fn point_to_frame(&self, x: Vector) -> Vector {
        self.direction_to_frame(x - self.position)
    }

    /// A point in the inertial frame, given in the frame: `r + A p`.
    pub fn point_to_inertial(&self, p: Vector) -> Vector {
        self.position + self.direction_to_inertial(p)
    }

    /// Rate of a direction that changes in inertial axes, seen in the frame: `A^T d' - w x A^T d`.
    pub fn rate_to_frame(&self, d: Vector, rate: Vector) -> Vector {
        self.direction_to_frame(rate) - self.spin.cross(&self.direction_to_frame(d))
    }

    /// Rate in inertial axes of a direction that changes in the frame: `A (d' + w x d)`.
    pub fn rate_to_inertial(&self, d: Vector, rate: Vector) -> Vector {
        self.direction_to_inertial(rate + self.spin.cross(&d))
    }

    /// Acceleration of the origin minus gravity (m/s^2, inertial axes) and fields, frame axes: e of THEORY 2.
    pub fn felt(&self, gravity: Vector) -> Vector {
        self.direction_to_frame(self.acceleration - (gravity + self.field))
    }

    /// The frame in steady rotation: `scale` times its spin, which does not change; the origin's
    /// acceleration scales with the square, as in a uniform rotation.
    pub fn steady(&self, scale: f64) -> FrameMotion {
        FrameMotion {
            velocity: scale * self.velocity,
            acceleration: scale * scale * self.acceleration,
            spin: scale * self.spin,
            spin_rate: ZERO,
            jerk: scale * scale * scale * self.jerk,
            spin_jerk: ZERO,
            ..*self
        }
    }
}
