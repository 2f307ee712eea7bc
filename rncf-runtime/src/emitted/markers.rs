//! What constraints, forces and outputs are functions of: vectors in inertial axes (THEORY 6).

use super::body_spec::Place;

/// A vector in inertial axes that moves with the system. Constraints C(z, t) and forces f(z, z', t)
/// are emitted as functions of these vectors; how a vector depends on frames and nodal vectors is
/// known here once for all: `P = r + A p`, `dP = dr - A [p] dpi + A s_a dq_a`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MarkerSpec {
    /// A point fixed in a frame, m, frame axes: `r + A p`.
    Point {
        /// Frame, prescribed or free.
        frame: usize,
        /// p.
        at: [f64; 3],
    },
    /// A direction fixed in a frame: `A d`.
    Direction {
        /// Frame.
        frame: usize,
        /// d, frame axes.
        along: [f64; 3],
    },
    /// A place on a flexible body: `r + A s_a(x) q_a`.
    BodyPoint {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
    /// A place beside the axis of a flexible body, fixed in a section: `r + A (s_a + y y_a + z z_a) q_a`.
    SectionPoint {
        /// Body.
        body: usize,
        /// Where on the axis.
        at: Place,
        /// y and z, m, along the section's axes.
        beside: [f64; 2],
    },
    /// The slope of a flexible body, not normalised: `A s_a'(x) q_a`.
    BodySlope {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
    /// The y (1) or z (2) axis of a body's section, not normalised: `A y_a(x) q_a`.
    BodySection {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
        /// 1 or 2.
        axis: usize,
    },
    /// A unit vector that turns with a section, equal to another direction marker at t = 0. The section's rotation is
    /// the polar one of its axes r_y and r_z (in a plane that of r_y): both have the same part in it, the slope none.
    InSection {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
        /// Index of the other marker.
        marker: usize,
    },
    /// The turning of a section, as that of a frame.
    SectionTurn {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
    /// The turning of a frame: its value is zero, its rate the angular velocity in inertial axes
    /// (rad/s); the force on it is a moment (N m).
    Turn {
        /// Frame.
        frame: usize,
    },
    /// The angle of a planar or hinged frame and two zeros, rad; the force on it is a moment.
    Angle {
        /// Frame.
        frame: usize,
    },
    /// Fixed in a frame, equal to another marker at t = 0 (a point of a point, a direction of a
    /// direction, normalised).
    Matching {
        /// Frame.
        frame: usize,
        /// Index of the other marker.
        marker: usize,
    },
    /// A unit vector fixed in a frame, normal to another direction marker at t = 0.
    Normal {
        /// Frame.
        frame: usize,
        /// Index of the other marker.
        marker: usize,
        /// 0 or 1: the two and the direction are a right-handed triad (direction, first, second).
        which: usize,
    },
}

/// In which formulation something is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// In all.
    Always,
    /// Where the body's nodal vectors are in the inertial frame: stands for a condition that is
    /// eliminated in the body's own free frame.
    Absolute(
        /// Body.
        usize,
    ),
}

/// Constraints C(z, t) = 0 of one joint or one declaration.
#[derive(Clone, Debug)]
pub struct ConstraintSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Kind for messages, e.g. `revolute`, `constraint`.
    pub kind: &'static str,
    /// What each row fixes, e.g. `position x`, `direction 1`; its length is the number of rows.
    pub rows: &'static [&'static str],
    /// Markers z, in the order of the emitted function's arguments.
    pub markers: &'static [usize],
    /// Places in this list of markers that are multiplied in a row: without such pairs it is linear in its markers.
    pub coupled: &'static [[usize; 2]],
    /// Whether it depends on differences of places alone, besides directions and angles: it stays the same where all places are shifted.
    pub of_differences: bool,
    /// The first so many markers belong to the first party: reactions act on it.
    pub first_party: usize,
    /// Number of angles in it ([`super::MarkerConstraints::marker_constraint_branches`]).
    pub branches: usize,
    /// Where it is there.
    pub when: When,
}

/// A force f(z, z', t) on markers: spring, damper, load or user-written law.
#[derive(Clone, Debug)]
pub struct ForceSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Markers z that it depends on and acts on.
    pub markers: &'static [usize],
    /// Whether it has a potential ([`super::MarkerForces::marker_energy`]).
    pub conservative: bool,
    /// Whether it depends on differences of places (and of their velocities) alone, besides directions and angles: it stays the same where all places are shifted.
    pub of_differences: bool,
    /// Number of angles and kinks in it ([`super::MarkerForces::marker_force_branches`]).
    pub branches: usize,
}

/// A rigid fixture at a place of a flexible body (THEORY 5.4). Its inertia is constant; a section below it becomes rigid, with
/// constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixtureSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Body.
    pub body: usize,
    /// Where.
    pub at: Place,
    /// Mass (kg); first moments (kg m) along the slope and the section's y and z axes; second moments
    /// (kg m^2) xx, yy, zz, xy, xz, yz of those coordinates. Without a section only x has entries.
    pub constants: [f64; 10],
    /// Whether a section that carries it goes on to strain; else it is rigid.
    pub elastic: bool,
}
