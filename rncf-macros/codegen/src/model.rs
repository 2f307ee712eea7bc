//! The checked model: names resolved, numbers in SI, typed indices. Nothing of syn below this line;
//! everything here has passed every check, so that the stages after it do not fail.

mod along;
mod body;
mod expression;
pub mod fold;
mod ids;
mod joint;
mod load;
mod moving;
mod repeated;

pub use along::{Between, Column, Law, NodeAt, Piece, Stations, Table};
pub use body::{Body, Evaluation, Fidelity, FrameTie, Imported, Initial, Line, Quadrature, SectionShape, Space};
pub use expression::{
    About, BalanceQuantity, Binary, Comparison, ElementQuantity, Expr, Function, Location, Observable, Owner,
    PointQuantity, Reduction, SectionQuantity,
};
pub use ids::{
    BodyId, ConstraintId, ElementId, FrameId, INERTIAL, JointId, MarkerId, MotionId, ParamId, RepeatId, TableId,
    identifier,
};
pub use joint::{Held, Joint, JointKind};
pub use load::{Load, LoadKind};
pub use moving::{Constraint, Fixture, Force, ForceKind, Free, Marker, Motions, RigidPart};
pub use repeated::{Caution, Density, Distributed, ParticleVector, Repeat, Share, Start};

/// A whole model.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Rust identifier of the generated struct.
    pub name: String,
    /// Visibility as written: `pub`, `pub(crate)` or empty.
    pub visibility: String,
    /// Documentation comment, lines joined by newlines.
    pub doc: String,
    /// The declaration as the compiler saw it (without documentation comments is fine).
    pub source: String,
    /// Run-time parameters in the order of the declaration.
    pub params: Vec<Param>,
    /// Motions: named functions of t.
    pub motions: Vec<Motion>,
    /// Frames; the first is the inertial one, named `inertial`.
    pub frames: Vec<Frame>,
    /// Tables in the order of the declaration.
    pub tables: Vec<Table>,
    /// Loops of the declaration: how often items are repeated.
    pub repeats: Vec<Repeat>,
    /// Bodies in the order of the declaration; a repeated one stands once.
    pub bodies: Vec<Body>,
    /// Joints in the order of the declaration.
    pub joints: Vec<Joint>,
    /// Vectors that constraints, forces and outputs are functions of; equal ones are one.
    pub markers: Vec<Marker>,
    /// Constraints with multipliers: joints between moving parts, and declared ones.
    pub constraints: Vec<Constraint>,
    /// Forces on markers: springs, user-written laws, loads on what moves freely, rates of states.
    pub forces: Vec<Force>,
    /// Ends of bodies that are one node.
    pub shares: Vec<Share>,
    /// Frames whose bodies start in relative equilibrium.
    pub starts: Vec<Start>,
    /// Fixtures of flexible bodies.
    pub fixtures: Vec<Fixture>,
    /// Loads per length of a body.
    pub densities: Vec<Density>,
    /// Loads per length that are functions of the particle.
    pub distributed: Vec<Distributed>,
    /// Loads in the order of the declaration: gravity, and dead loads in prescribed frames.
    pub loads: Vec<Load>,
    /// Outputs in the order of the declaration.
    pub outputs: Vec<Output>,
    /// What a reader of the results must know.
    pub cautions: Vec<Caution>,
    /// Defaults of a run.
    pub run: Run,
}

impl Model {
    /// Whether a marker is a point, not a direction.
    pub fn is_point(&self, marker: MarkerId) -> bool {
        match &self.markers[marker.0] {
            Marker::Point { .. } | Marker::BodyPoint { .. } | Marker::SectionPoint { .. } => true,
            Marker::Matching { marker, .. } => self.is_point(*marker),
            _ => false,
        }
    }
}

/// A run-time parameter: a field of the generated struct.
#[derive(Clone, Debug)]
pub struct Param {
    /// Rust identifier.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Unit symbol as written, `1` without one.
    pub unit: String,
    /// One unit in SI.
    pub unit_si: f64,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// Default, SI.
    pub default: f64,
    /// Whether it counts things (a `usize` field).
    pub is_count: bool,
    /// Whether it names the file of the table with its name (a `TableFile` field).
    pub is_table: bool,
}

/// `motion theta(t) = ...`
#[derive(Clone, Debug)]
pub struct Motion {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// SI unit of the value for documentation, e.g. `rad`.
    pub unit: String,
    /// Value in SI as a function of [`Expr::Time`].
    pub value: Expr,
}

/// A frame of reference.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name; `inertial` for the first.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// The frame it moves in.
    pub parent: FrameId,
    /// Position of its origin in the parent, m, parent axes; of a free frame at t = 0.
    pub origin: [Expr; 3],
    /// Rotation about an axis fixed in both frames; of a free frame at t = 0.
    pub rotation: Option<Rotation>,
    /// Whether it moves freely; else in the prescribed way.
    pub free: Option<Free>,
}

/// A prescribed rotation about a fixed axis.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Axis, parent axes; a unit vector where constant, else normalised at run time.
    pub axis: [f64; 3],
    /// Angle, rad.
    pub angle: Expr,
}

/// An output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Unit symbol, `1` where dimensionless.
    pub unit: String,
    /// Exponent of time in its dimension.
    pub time_exponent: f64,
    /// One component for a scalar, else the components of a vector with their suffixes.
    pub components: Vec<(String, Expr)>,
}

/// Defaults of a run.
#[derive(Clone, Debug)]
pub struct Run {
    /// End time, s.
    pub t_end: Expr,
    /// Time between rows, s.
    pub every: Expr,
    /// How the bodies start.
    pub start: Begin,
}

/// How the bodies start in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// Undeformed and at rest in their frames.
    Rest,
    /// Undeformed, with the velocities that joints and drives ask for.
    Moving,
    /// In relative equilibrium with the spin.
    Steady,
}

impl Default for Run {
    fn default() -> Self {
        Self {
            t_end: Expr::Number(1.0),
            every: Expr::Number(0.01),
            start: Begin::Rest,
        }
    }
}
