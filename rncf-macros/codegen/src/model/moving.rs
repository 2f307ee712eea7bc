//! What moves freely, and what acts on it: free frames with their rigid parts, markers, and constraints
//! and forces as expressions of markers.

use super::expression::{Expr, Location};
use super::ids::{BodyId, FrameId, MarkerId, RepeatId};

/// A frame whose pose is unknown (THEORY 2, 3.1).
#[derive(Clone, Debug)]
pub struct Free {
    /// Which motions are unknown.
    pub motions: Motions,
    /// Velocity of the origin relative to the parent at t = 0, m/s, parent axes.
    pub velocity: [Expr; 3],
    /// Angular velocity relative to the parent at t = 0, rad/s, frame axes.
    pub spin: [Expr; 3],
    /// Rigid parts that it carries.
    pub parts: Vec<RigidPart>,
    /// Whether it was declared as a rigid body.
    pub is_body: bool,
    /// What counts as much, of a state; in its unit.
    pub size: Option<Expr>,
}

/// Which motions of a free frame are unknown. See `rncf::emitted::Motions`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motions {
    /// Along and about all axes.
    Spatial,
    /// In the plane normal to an axis.
    Planar {
        /// 0, 1, 2: inertial axis, and axis of the frame.
        normal: usize,
    },
    /// About the origin, which is that of the parent.
    Turning,
    /// About an axis through the origin, which is that of the parent.
    Hinged {
        /// Unit vector, axes of the parent and of the frame alike.
        axis: [f64; 3],
    },
    /// Along all axes, without turning: a point mass.
    Shifting,
    /// Along the axes of a plane, without turning.
    ShiftingPlanar {
        /// 0, 1, 2: inertial axis normal to the plane.
        normal: usize,
    },
    /// None: its unknown is a state, a number that stands where others have their angle.
    State,
}

/// A rigid part in a free frame: ten numbers.
#[derive(Clone, Debug)]
pub struct RigidPart {
    /// Name in the declaration.
    pub name: String,
    /// Mass, kg.
    pub mass: Expr,
    /// Centre of mass, m, frame axes.
    pub center: [Expr; 3],
    /// Inertia about the centre of mass, kg m^2, frame axes: xx, yy, zz, xy, xz, yz (matrix entries).
    pub inertia: [Expr; 6],
}

/// A vector in inertial axes that moves with the system. See `rncf::emitted::MarkerSpec`.
#[derive(Clone, Debug, PartialEq)]
pub enum Marker {
    /// A point fixed in a frame, m, frame axes.
    Point {
        /// Frame, prescribed or free.
        frame: FrameId,
        /// Where.
        at: [Expr; 3],
    },
    /// A direction fixed in a frame, frame axes.
    Direction {
        /// Frame.
        frame: FrameId,
        /// Direction.
        along: [Expr; 3],
    },
    /// A place on a flexible body.
    BodyPoint {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
    },
    /// A place beside the axis of a flexible body, fixed in a section.
    SectionPoint {
        /// Body.
        body: BodyId,
        /// Where on the axis.
        at: Location,
        /// y and z, m, along the section's axes.
        beside: [Expr; 2],
    },
    /// The slope of a flexible body, not normalised.
    BodySlope {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
    },
    /// The y (1) or z (2) axis of a body's section, not normalised: `A y_a(x) q_a`.
    BodySection {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// 1 or 2.
        axis: usize,
    },
    /// A unit vector that turns with a section, equal to another direction at t = 0. The section's rotation is the polar
    /// one of its axes r_y and r_z (in a plane that of r_y): both have the same part in it, the slope none.
    InSection {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// The other marker.
        marker: MarkerId,
    },
    /// The turning of a section, as that of a frame.
    SectionTurn {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
    },
    /// The turning of a frame: no value, its rate is the angular velocity (rad/s, inertial axes).
    Turn {
        /// Frame.
        frame: FrameId,
    },
    /// The angle of a planar or hinged frame (rad), or a state, and two zeros.
    Angle {
        /// Frame.
        frame: FrameId,
    },
    /// Fixed in a frame, equal to another marker at t = 0.
    Matching {
        /// Frame.
        frame: FrameId,
        /// The other marker.
        marker: MarkerId,
    },
    /// A unit vector fixed in a frame, normal to another direction at t = 0.
    Normal {
        /// Frame.
        frame: FrameId,
        /// The other marker.
        marker: MarkerId,
        /// 0 or 1: (direction, first, second) is a right-handed triad.
        which: usize,
    },
}

/// Constraints C(z, t) = 0 of one joint or one declaration, as expressions of markers and time.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Kind for messages, e.g. `revolute`, `constraint`.
    pub kind: String,
    /// Markers, in the order of the emitted function's arguments.
    pub markers: Vec<MarkerId>,
    /// The first so many markers belong to the first party.
    pub first_party: usize,
    /// What each row fixes, e.g. `position x`, and its expression.
    pub rows: Vec<(String, Expr)>,
    /// `Some(body)`: only where that body's nodal vectors are in the inertial frame; it stands there
    /// for a joint that is eliminated in the body's own free frame.
    pub absolute: Option<BodyId>,
}

/// A force on markers, as expressions of markers, their velocities and time.
#[derive(Clone, Debug)]
pub struct Force {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Markers that it depends on or acts on, in the order of the emitted function's arguments.
    pub markers: Vec<MarkerId>,
    /// Force on each marker in inertial axes, in the same order: N on points, N m on turns and
    /// angles (first component), generalised on slopes; zeros where it only depends on it.
    pub components: Vec<[Expr; 3]>,
    /// Potential, J, where it has one and nothing damps.
    pub energy: Option<Expr>,
    /// What it was declared as.
    pub kind: ForceKind,
}

/// What a force on markers was declared as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceKind {
    /// A spring.
    Spring,
    /// A load, which equilibria apply in parts.
    Load,
    /// The rate of a state, less its derivative.
    State,
}

impl Force {
    /// What messages call it.
    pub fn in_words(&self) -> String {
        let kind = match self.kind {
            ForceKind::Spring => "spring",
            ForceKind::Load => "load",
            ForceKind::State => "state",
        };
        format!("{kind} `{}`", self.name)
    }
}

/// A rigid fixture at a place of a flexible body (THEORY 5.4).
#[derive(Clone, Debug)]
pub struct Fixture {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
    /// Body.
    pub body: BodyId,
    /// Where.
    pub at: Location,
    /// Mass (kg); first moments (kg m) along the slope and the section's y and z axes; second moments
    /// (kg m^2) xx, yy, zz, xy, xz, yz of those coordinates. Without a section only x has entries.
    pub constants: [Expr; 10],
    /// Whether a section that carries it goes on to strain; else it is rigid.
    pub elastic: bool,
}

impl Marker {
    /// A place on the axis of a body, or beside it.
    pub fn on_section(body: BodyId, at: Location, beside: Option<[Expr; 2]>) -> Self {
        match beside {
            None => Marker::BodyPoint { body, at },
            Some(beside) => Marker::SectionPoint { body, at, beside },
        }
    }

    /// The body and the place on it; none of what is fixed in a frame.
    pub fn on_body(&self) -> Option<(BodyId, &Location)> {
        match self {
            Marker::BodyPoint { body, at }
            | Marker::SectionPoint { body, at, .. }
            | Marker::BodySlope { body, at }
            | Marker::BodySection { body, at, .. }
            | Marker::InSection { body, at, .. }
            | Marker::SectionTurn { body, at } => Some((*body, at)),
            Marker::Point { .. }
            | Marker::Direction { .. }
            | Marker::Turn { .. }
            | Marker::Angle { .. }
            | Marker::Matching { .. }
            | Marker::Normal { .. } => None,
        }
    }

    /// The frame that it is fixed in; markers on bodies are in the bodies' frames.
    pub fn frame(&self) -> Option<FrameId> {
        match self {
            Marker::Point { frame, .. }
            | Marker::Direction { frame, .. }
            | Marker::Turn { frame }
            | Marker::Angle { frame }
            | Marker::Matching { frame, .. }
            | Marker::Normal { frame, .. } => Some(*frame),
            Marker::BodyPoint { .. }
            | Marker::SectionPoint { .. }
            | Marker::BodySlope { .. }
            | Marker::BodySection { .. }
            | Marker::InSection { .. }
            | Marker::SectionTurn { .. } => None,
        }
    }
}
