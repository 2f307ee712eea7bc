//! Free frames: reference frames and rigid bodies whose pose is unknown (THEORY 2, 3.1).

use crate::space::{Matrix, Vector};

/// Which motions of a free frame are unknown. Unknowns stand in this order: displacements of the origin
/// from its start in inertial axes (m), then the orientation. A start that is far away, like one
/// astronomical unit, moves on with its velocity (THEORY 7.3): the unknowns are of the size of what
/// happens, and so is their round-off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motions {
    /// Along and about all axes: three positions, one orientation of three unknowns.
    Spatial,
    /// In the plane normal to inertial axis `normal` (0, 1, 2): the two positions of the plane in
    /// right-handed order (1 2, 2 0, 0 1), one angle about the normal (rad).
    Planar {
        /// Axis normal to the plane, inertial and of the frame.
        normal: usize,
    },
    /// About the origin, which is that of the parent: one orientation of three unknowns.
    Turning,
    /// About an axis through the origin, which is that of the parent: one angle (rad).
    Hinged {
        /// Unit vector, axes of the parent and of the frame alike.
        axis: Vector,
    },
    /// Along all axes, without turning (a point mass): three positions.
    Shifting,
    /// Along the axes of a plane, without turning: two positions.
    ShiftingPlanar {
        /// Axis normal to the plane.
        normal: usize,
    },
    /// None, of a frame behind all others: the unknown is a state, a number z that moves nothing and has no inertia. A force `g - z'` on its
    /// [`MarkerSpec::Angle`](super::MarkerSpec::Angle) is its equation `z' = g`.
    State,
}

/// What a frame carries of its own: ten numbers of a rigid body about the frame's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RigidSpec {
    /// m, kg.
    pub mass: f64,
    /// First moment m r_c, kg m, frame axes.
    pub moment: Vector,
    /// Inertia J about the origin, kg m^2, frame axes.
    pub inertia: Matrix,
}

/// A free frame. `position` to `spin` are those at t = 0, relative to the parent.
#[derive(Clone, Debug)]
pub struct FreeSpec {
    /// Index of the frame.
    pub frame: usize,
    /// Prescribed frame (0: inertial) that the start refers to. It carries the origin of
    /// [`Motions::Turning`] and [`Motions::Hinged`] frames all the time, and does not turn then.
    pub parent: usize,
    /// Whether it was declared as a rigid body, for messages.
    pub is_body: bool,
    /// Unknown motions.
    pub motions: Motions,
    /// Origin, m, parent axes.
    pub position: Vector,
    /// Unit vector of the rotation from the parent, parent axes.
    pub axis: Vector,
    /// Its angle, rad. Planar and hinged frames turn about their own axis and count from it. Of a state its value.
    pub angle: f64,
    /// Velocity of the origin relative to the parent, m/s, parent axes.
    pub velocity: Vector,
    /// Angular velocity relative to the parent, rad/s, frame axes.
    pub spin: Vector,
    /// Rigid parts, zero without.
    pub rigid: RigidSpec,
    /// What counts as much of a state, in its unit.
    pub size: f64,
}
