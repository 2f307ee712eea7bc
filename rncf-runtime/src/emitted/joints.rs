//! Joints between ends of bodies and frames.

use super::body_spec::Interpolant;

/// What a joint fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Position, and direction of the slope, or of the section's axes where the body has them.
    Clamp,
    /// Position and slope, or the section's axes with their norms.
    ClampFull,
    /// Position.
    Pin,
    /// One component of a nodal vector in the body's own frame, at its undeformed value.
    Hold {
        /// What the vector interpolates.
        of: Interpolant,
        /// 0 value, 1 slope.
        order: usize,
        /// Frame axis 0, 1, 2.
        axis: usize,
    },
}

/// A joint between a body's end and a frame.
#[derive(Clone, Debug)]
pub struct JointSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// What it fixes.
    pub kind: JointKind,
    /// Body.
    pub body: usize,
    /// Whether it is at the body's end instead of its start.
    pub at_end: bool,
    /// Frame that it is fixed to.
    pub frame: usize,
    /// Fixed point in the joint's frame, m; `None`: where the undeformed body is at t = 0.
    pub point: Option<[f64; 3]>,
}

/// Constants of a joint, in its frame's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointData {
    /// Fixed point, m.
    pub point: [f64; 3],
    /// Direction of the slope, unit vector; with a section that of its y axis.
    pub tangent: [f64; 3],
    /// Unit vectors normal to it; planar bodies use the first, which lies in the plane.
    pub normals: [[f64; 3]; 2],
    /// Direction of the section's z axis in space; else zeros.
    pub second: [f64; 3],
}

/// What an eliminated condition prescribes, in the body's axes: value, rate, acceleration and jerk.
/// Only constraints on markers need the jerk, on their jerk level.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Prescribed {
    /// Position, m, m/s, m/s^2, m/s^3.
    pub position: [[f64; 3]; 4],
    /// Slope; with a section its y axis.
    pub slope: [[f64; 3]; 4],
    /// The section's z axis in space.
    pub second: [[f64; 3]; 4],
}
