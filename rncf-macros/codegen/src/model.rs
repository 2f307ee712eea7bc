//! The checked model: names resolved, numbers in SI, typed indices. Nothing of syn below this line;
//! everything here has passed every check, so that the stages after it do not fail.

use std::collections::BTreeMap;

macro_rules! index {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub usize);
    };
}

index!(/** Index into [`Model::params`]. */ ParamId);
index!(/** Index into [`Model::motions`]. */ MotionId);
index!(/** Index into [`Model::frames`]; 0 is the inertial frame. */ FrameId);
index!(/** Index into [`Model::bodies`]. */ BodyId);
index!(/** Index into [`Model::joints`]. */ JointId);
index!(/** Index into [`Model::markers`]. */ MarkerId);
index!(/** Index into [`Model::constraints`]. */ ConstraintId);
index!(/** Index into the element library's elements. */ ElementId);

/// The inertial frame, always first.
pub const INERTIAL: FrameId = FrameId(0);

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
    /// Bodies in the order of the declaration.
    pub bodies: Vec<Body>,
    /// Joints in the order of the declaration.
    pub joints: Vec<Joint>,
    /// Vectors that constraints, forces and outputs are functions of; equal ones are one.
    pub markers: Vec<Marker>,
    /// Constraints with multipliers: joints between moving parts, and declared ones.
    pub constraints: Vec<Constraint>,
    /// Forces on markers: springs, user-written laws, loads on what moves freely.
    pub forces: Vec<Force>,
    /// Fixtures of flexible bodies.
    pub fixtures: Vec<Fixture>,
    /// Loads in the order of the declaration: gravity, and dead loads in prescribed frames.
    pub loads: Vec<Load>,
    /// Outputs in the order of the declaration.
    pub outputs: Vec<Output>,
    /// Defaults of a run.
    pub run: Run,
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

/// A resolved expression in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// A number in SI; `pi` is one too, constants of the declaration are folded into these.
    Number(f64),
    /// A run-time parameter (a count is converted to a number).
    Param(ParamId),
    /// Time, s.
    Time,
    /// Arclength of a body's stress-free axis from its start, m; in its initial shape only.
    Arclength,
    /// A motion at another time.
    Motion(MotionId, Box<Expr>),
    /// Negation.
    Negate(Box<Expr>),
    /// A sum, difference, product or quotient.
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// `base ^ exponent`.
    Power(Box<Expr>, Box<Expr>),
    /// A function of one argument (two for `atan2`, `min`, `max`).
    Call(Function, Vec<Expr>),
    /// `if left < right { then } else { otherwise }`.
    If(Comparison, Box<Expr>, Box<Expr>, Box<Expr>, Box<Expr>),
    /// Something of the simulated system; in outputs, constraints and forces.
    Observed(Observable),
}

/// Two-operand arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

/// Comparison in `if`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

/// The usual functions; `Abs`, `Min`, `Max` and `Atan2` in outputs only (they have kinks).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Min,
    Max,
    Atan2,
}

impl Function {
    /// Value of a function of one argument; `None` for one of two.
    pub fn of(self, x: f64) -> Option<f64> {
        Some(match self {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Atan => x.atan(),
            Function::Sinh => x.sinh(),
            Function::Cosh => x.cosh(),
            Function::Tanh => x.tanh(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sqrt => x.sqrt(),
            Function::Abs => x.abs(),
            Function::Min | Function::Max | Function::Atan2 => return None,
        })
    }

    /// Value of a function of two arguments; `None` for one of one.
    pub fn of_two(self, x: f64, y: f64) -> Option<f64> {
        Some(match self {
            Function::Min => x.min(y),
            Function::Max => x.max(y),
            Function::Atan2 => x.atan2(y),
            _ => return None,
        })
    }
}

/// A component of something observed.
#[derive(Clone, Debug, PartialEq)]
pub enum Observable {
    /// Component of a marker or of its time derivatives, inertial axes. Constraints use derivative 0
    /// only, forces 0 and 1.
    Marker {
        /// Which marker.
        marker: MarkerId,
        /// 0 value, 1 velocity, 2 acceleration.
        derivative: usize,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Component of what a constraint exerts on its first party, inertial axes; in outputs. The
    /// moment is about the first point among its markers.
    ConstraintReaction {
        /// Which constraint.
        constraint: ConstraintId,
        /// Moment (N m) instead of force (N).
        moment: bool,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Multiplier of one row of a constraint; in outputs.
    Multiplier {
        /// Which constraint.
        constraint: ConstraintId,
        /// Row.
        row: usize,
    },
    /// Component of a body's point: position, velocity (relative to the body's frame) or slope
    /// dp/dx, in the axes of the body's declared frame.
    Point {
        /// Which body.
        body: BodyId,
        /// Where on it.
        at: Location,
        /// What of it.
        what: PointQuantity,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Component of what a joint exerts on its body, in the axes of the joint's frame; the moment
    /// is about the joint's point.
    Reaction {
        /// Which joint.
        joint: JointId,
        /// Moment (N m) instead of force (N).
        moment: bool,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
}

/// What is observed at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PointQuantity {
    /// Position, m.
    Position,
    /// Velocity, m/s.
    Velocity,
    /// Slope dp/dx, 1.
    Slope,
}

/// A place on a body.
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// First node.
    Start,
    /// Last node.
    End,
    /// Arclength of the stress-free axis from the start, m.
    At(Box<Expr>),
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
}

/// Which motions of a free frame are unknown. See `rncf::mesh::Motions`.
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

/// A vector in inertial axes that moves with the system. See `rncf::mesh::MarkerSpec`.
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
    /// The slope of a flexible body, not normalised.
    BodySlope {
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
    /// The angle of a planar or hinged frame and two zeros, rad.
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
}

/// A rigid fixture at a place of a flexible body (THEORY 5.4).
#[derive(Clone, Debug)]
pub struct Fixture {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Body.
    pub body: BodyId,
    /// Where.
    pub at: Location,
    /// Mass (kg), first moment along the slope (kg m), second moment along it (kg m^2).
    pub constants: [Expr; 3],
}

/// A prescribed rotation about a fixed axis.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Axis, parent axes; a unit vector where constant, else normalised at run time.
    pub axis: [f64; 3],
    /// Angle, rad.
    pub angle: Expr,
}

/// In how many directions a body moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Space {
    /// In the plane of two frame axes; `normal` is 0, 1, 2 for yz, zx, xy.
    Planar {
        /// Axis normal to the plane.
        normal: usize,
    },
    /// In space.
    Spatial,
}

impl Space {
    /// Components of a vector of the body.
    pub fn dimension(self) -> usize {
        match self {
            Space::Planar { .. } => 2,
            Space::Spatial => 3,
        }
    }

    /// Frame axes of the components, in order: the plane's right-handed pair, or x, y, z.
    pub fn axes(self) -> &'static [usize] {
        match self {
            Space::Planar { normal: 0 } => &[1, 2],
            Space::Planar { normal: 1 } => &[2, 0],
            Space::Planar { .. } => &[0, 1],
            Space::Spatial => &[0, 1, 2],
        }
    }
}

/// A flexible body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// The declared frame: its reference coordinate system in RNCF.
    pub frame: FrameId,
    /// Planar or spatial.
    pub space: Space,
    /// Stress-free axis, in the declared frame.
    pub line: Line,
    /// Number of elements.
    pub count: Expr,
    /// Element of the library.
    pub element: ElementId,
    /// Chosen value of each option of the element, in the order of its declaration.
    pub options: Vec<usize>,
    /// Name of the material, for documentation.
    pub material_name: String,
    /// Name of the section, for documentation.
    pub section_name: String,
    /// Properties of material and section by their vocabulary names, SI.
    pub properties: BTreeMap<&'static str, Expr>,
    /// Integration rule of the strain energy.
    pub quadrature: Quadrature,
    /// How the elastic kernels are emitted.
    pub evaluation: Evaluation,
    /// How finely its deformation is described.
    pub fidelity: Fidelity,
    /// Whether its free frame follows the mean axes instead of joints.
    pub mean_axes: bool,
    /// Where and how fast it starts.
    pub initial: Initial,
}

/// Start of a body at t = 0 as functions of [`Expr::Arclength`], frame axes; its slopes are their
/// derivatives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Initial {
    /// Position, m; `None`: undeformed.
    pub position: Option<[Expr; 3]>,
    /// Velocity relative to the frame, as seen in it, m/s; `None`: at rest in it.
    pub velocity: Option<[Expr; 3]>,
}

/// How finely the deformation of a body is described (THEORY 3).
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Fidelity {
    /// All nodal vectors.
    #[default]
    Full,
    /// This number (a count) of lowest modes in the body's frame, Eqs. (15)-(17).
    Modal(Expr),
    /// The same for small deformations, Eqs. (18)-(20).
    Small(Expr),
    /// No deformation.
    Rigid,
}

/// The stress-free axis of a body.
#[derive(Clone, Debug)]
pub enum Line {
    /// A straight line.
    Straight {
        /// Start, m, frame axes.
        from: [Expr; 3],
        /// End, m, frame axes.
        to: [Expr; 3],
    },
    /// A circular arc in the plane of a planar body.
    Arc {
        /// Start, m, frame axes.
        from: [Expr; 3],
        /// Tangent at the start, frame axes; normalised at run time.
        direction: [Expr; 3],
        /// Radius, m, positive.
        radius: Expr,
        /// Subtended angle, rad; positive turns counter-clockwise about the plane's normal.
        angle: Expr,
    },
}

/// Integration rule of the strain energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quadrature {
    /// Exact where the energy is polynomial, else the element's default number of points.
    Exact,
    /// Gauss rule with this many points.
    Gauss(usize),
}

/// How the elastic kernels are emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Evaluation {
    /// The form with the least counted cost.
    Automatic,
    /// Constant tensor.
    Tensor,
    /// Gauss points, unrolled.
    Points,
    /// Gauss points, in a loop.
    Loop,
}

/// A joint between a body's end and a prescribed frame or the body's own frame: its conditions are
/// linear in the nodal vectors.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// What it fixes.
    pub kind: JointKind,
    /// Body.
    pub body: BodyId,
    /// The body's end ([`Location::Start`] or [`Location::End`]).
    pub at: Location,
    /// Frame that it is fixed to.
    pub frame: FrameId,
    /// Fixed point, m, joint frame's axes; `None`: where the undeformed body is at t = 0.
    pub point: Option<[Expr; 3]>,
}

/// What a joint fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Position, and direction of the slope; its norm stays free.
    Clamp,
    /// Position and the whole slope.
    ClampFull,
    /// Position.
    Pin,
    /// One component of the position (order 0) or slope (order 1) in the body's own frame, at its
    /// undeformed value.
    Hold {
        /// 0 position, 1 slope.
        order: usize,
        /// Frame axis 0, 1, 2.
        axis: usize,
    },
}

/// A load.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// What it is.
    pub kind: LoadKind,
}

/// Kinds of loads.
#[derive(Clone, Debug)]
pub enum LoadKind {
    /// Uniform gravity on all bodies, m/s^2, inertial axes.
    Gravity([Expr; 3]),
    /// Dead force (N) at a point of a body, axes of a frame, function of t.
    Force {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// Components, N.
        components: [Expr; 3],
        /// In the axes of this frame.
        frame: FrameId,
    },
    /// Dead moment (N m) at a point of a body, axes of a frame, function of t.
    Moment {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// Components, N m.
        components: [Expr; 3],
        /// In the axes of this frame.
        frame: FrameId,
    },
}

impl LoadKind {
    /// Components of the load, in the axes of its frame.
    pub fn components(&self) -> &[Expr; 3] {
        let (Self::Gravity(components) | Self::Force { components, .. } | Self::Moment { components, .. }) = self;
        components
    }
}

/// An output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// SI unit symbol, `1` where dimensionless.
    pub unit: String,
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
}

impl Default for Run {
    fn default() -> Self {
        Self {
            t_end: Expr::Number(1.0),
            every: Expr::Number(0.01),
        }
    }
}
