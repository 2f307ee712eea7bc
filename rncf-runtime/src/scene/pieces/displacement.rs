//! Displacements of frames, under which a scene may be symmetric.

use crate::emitted::FrameMotion;
use crate::space::{Rotation, Vector, exp, from_matrix, matrix, product};

/// A rigid displacement of some frames: `x -> c + R (x - c) + d`.
#[derive(Clone, Debug)]
pub(crate) struct Displacement {
    /// For every frame whether it is moved.
    pub moved: Vec<bool>,
    /// Rotation vector of R, rad, inertial axes.
    pub turn: Vector,
    /// c, m.
    pub point: Vector,
    /// d, m.
    pub shift: Vector,
    /// Whether it is the own turning of one symmetric rigid body about an axis of its own: forces on points
    /// of the axis do not turn then, and moments about it are told from the body.
    pub is_own: bool,
    /// Time that passes meanwhile, s: `Some` looks at what depends on time only, or, where it is zero, at
    /// all else only.
    pub later: Option<f64>,
}

impl Displacement {
    pub fn rotation(&self) -> Rotation {
        exp(self.turn)
    }

    pub fn displaced(&self, frame: &FrameMotion, turns: bool) -> FrameMotion {
        let by = matrix(&self.rotation());
        let turned = |vector: Vector| by * vector;
        let moved = self.point + turned(frame.position - self.point);
        let rotation = from_matrix(&frame.rotation);
        FrameMotion {
            position: moved + self.shift,
            velocity: turned(frame.velocity),
            acceleration: turned(frame.acceleration),
            rotation: if turns {
                matrix(&product(&self.rotation(), &rotation))
            } else {
                frame.rotation
            },
            ..*frame
        }
    }
}
