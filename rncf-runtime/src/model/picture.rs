//! Pictures of a scene: the lines of its bodies in their frames, and where the frames are.

use crate::archive::{Archive, Keep};
use crate::space::{Rotation, Vector};

/// A line of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name of the body, `main[3]` of a repeated one, or of the rigid body or free frame.
    pub name: String,
    /// Frame whose axes its points refer to; index into [`Configuration::poses`].
    pub frame: usize,
    /// Number of its points.
    pub points: usize,
    /// Whether it is a flexible body; else the places that are fixed to a frame, each reached from its origin.
    pub is_flexible: bool,
}

/// Where everything is at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Configuration {
    /// Points of all curves, one curve after the other, m, axes of their frames.
    pub points: Vec<Vector>,
    /// Origin (m, inertial axes) and orientation of every frame; the first is the inertial one.
    pub poses: Vec<(Vector, Rotation)>,
    /// What acts at every sign of a load per length, force, moment or uniform gravity, in their order: N/m, N, N m or m/s^2,
    /// inertial axes.
    pub acting: Vec<Vector>,
}

/// What a sign stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignKind {
    /// A joint or constraint.
    Joint,
    /// Gravity that is not uniform: it has no arrow.
    Spread,
    /// A load per length in the middle of an element, N/m.
    Line,
    /// A force at a place, N.
    Force,
    /// A moment at a place or on a frame, N m.
    Moment,
    /// Uniform gravity, m/s^2.
    Gravity,
}

impl SignKind {
    /// One word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Joint => "joint",
            Self::Spread => "spread",
            Self::Line => "line",
            Self::Force => "force",
            Self::Moment => "moment",
            Self::Gravity => "gravity",
        }
    }
}

/// Where a sign is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SignPlace {
    /// Fixed in a frame.
    Frame {
        /// Index into [`Configuration::poses`].
        frame: usize,
        /// m, frame axes.
        at: Vector,
    },
    /// On a curve.
    Curve {
        /// Index of the curve.
        curve: usize,
        /// Number of its point; between two of them a fraction.
        point: f64,
    },
}

/// A joint, or what acts at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Sign {
    /// Name in the declaration.
    pub name: String,
    /// What it is.
    pub kind: SignKind,
    /// Where it is; `None`: everywhere.
    pub place: Option<SignPlace>,
}

impl Keep for Configuration {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { points, poses, acting } = self;
        points.keep(archive);
        poses.keep(archive);
        acting.keep(archive);
    }
}
