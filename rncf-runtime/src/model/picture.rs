//! Pictures of a scene: the lines of its bodies in their frames, and where the frames are.

use crate::archive::{Archive, Keep};
use crate::rotation::Rotation;
use crate::vector::Vector;

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
}

impl Keep for Configuration {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { points, poses } = self;
        points.keep(archive);
        poses.keep(archive);
    }
}
