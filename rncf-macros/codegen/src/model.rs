//! The checked model: names resolved, numbers in SI, typed indices. Nothing of syn below this line;
//! everything here has passed every check, so that the stages after it do not fail.

mod along;
mod expression;
pub mod fold;
mod moving;
mod repeated;

pub use along::{Between, Column, Law, NodeAt, Piece, Stations, Table};
pub use expression::{
    About, BalanceQuantity, Binary, Comparison, ElementQuantity, Expr, Function, Location, Observable, Owner,
    PointQuantity, Reduction, SectionQuantity,
};
pub use moving::{Constraint, Fixture, Force, Free, Marker, Motions, RigidPart};
pub use repeated::{Caution, Density, Distributed, ParticleVector, Repeat, Share, Start};

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
index!(/** Index into [`Model::repeats`]. */ RepeatId);
index!(/** Index into [`Model::tables`]. */ TableId);
index!(/** Index into the element library's elements. */ ElementId);

/// The inertial frame, always first.
pub const INERTIAL: FrameId = FrameId(0);

/// A name as it stands in identifiers of generated code: `blade[1].rod` as `blade_1_rod`.
pub fn identifier(name: &str) -> String {
    name.replace("].", "_")
        .replace(['[', '.'], "_")
        .replace("]_", "_")
        .replace(']', "")
}

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
    /// Forces on markers: springs, user-written laws, loads on what moves freely.
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
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
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
    /// Stiffness and mass, where the section says them by itself.
    pub law: Option<Law>,
    /// Where its nodes are; `None`: elements of equal length.
    pub stations: Option<Stations>,
    /// Where it lies along an axis with corners; `None`: it is the whole axis.
    pub piece: Option<Piece>,
    /// Integration rule of the strain energy.
    pub quadrature: Quadrature,
    /// How the elastic kernels are emitted.
    pub evaluation: Evaluation,
    /// How finely its deformation is described.
    pub fidelity: Fidelity,
    /// Strain energy density of the material (J/m^3) as a function of [`Expr::Strain`]; `None`: linear
    /// elastic by Young's modulus.
    pub strain_energy: Option<Expr>,
    /// Shape of the section.
    pub shape: SectionShape,
    /// Direction of the section's y axis at the start, frame axes, made normal to the tangent at run time;
    /// `None`: z x tangent, or y where the axis starts along z.
    pub section_y: Option<[Expr; 3]>,
    /// Stress-free twist of the section about the tangent, rad: at the end of one that grows evenly, or at the arclength.
    pub twist: Expr,
    /// What its free frame follows beside joints.
    pub tie: FrameTie,
    /// Where and how fast it starts.
    pub initial: Initial,
}

impl Body {
    /// Its name in identifiers of generated code.
    pub fn identifier(&self) -> String {
        identifier(&self.name)
    }
}

/// What of a body its free frame follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameTie {
    /// Joints alone.
    Joints,
    /// Its mean axes.
    MeanAxes,
    /// The line from its start to its end, and about it the mean.
    Chord,
}

impl FrameTie {
    /// The word of the declaration.
    pub fn word(self) -> &'static str {
        match self {
            Self::Joints => "joint",
            Self::MeanAxes => "mean_axes",
            Self::Chord => "chord",
        }
    }

    /// The name of what is followed.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Joints => "joints",
            Self::MeanAxes => "mean axes",
            Self::Chord => "chord",
        }
    }
}

/// Shape of a section, for stresses and for energies that are integrated over it.
#[derive(Clone, Debug, PartialEq)]
pub enum SectionShape {
    /// Known by its properties alone: distances of the outermost fibres along y and z (m), where given.
    General {
        /// Along y and z.
        extent: [Option<Expr>; 2],
    },
    /// A full circle.
    Circle {
        /// Radius, m.
        radius: Expr,
    },
    /// A circular tube.
    Tube {
        /// Outer radius, m.
        radius: Expr,
        /// Thickness of the wall, m.
        thickness: Expr,
    },
    /// A rectangle.
    Rectangle {
        /// Sizes along the section's y and z axes, m.
        sizes: [Expr; 2],
    },
}

impl Default for SectionShape {
    fn default() -> Self {
        Self::General { extent: [None, None] }
    }
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
    /// No deformation, all mass at the centre of mass.
    Point,
}

impl Fidelity {
    /// Whether a body can change its shape.
    pub fn deforms(&self) -> bool {
        !matches!(self, Self::Rigid | Self::Point)
    }
}

/// The stress-free axis of a body.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // there are few lines, and none is moved often
pub enum Line {
    /// A straight line.
    Straight {
        /// Start, m, frame axes.
        from: [Expr; 3],
        /// End, m, frame axes.
        to: [Expr; 3],
    },
    /// A circular arc.
    Arc {
        /// Start, m, frame axes.
        from: [Expr; 3],
        /// Tangent at the start, frame axes; normalised at run time.
        direction: [Expr; 3],
        /// Normal of its plane, frame axes; made normal to the tangent and normalised at run time.
        normal: [Expr; 3],
        /// Radius, m, positive.
        radius: Expr,
        /// Subtended angle, rad; positive turns counter-clockwise about the normal.
        angle: Expr,
    },
    /// The interfaces of a body from elsewhere.
    Imported(Imported),
    /// A smooth curve through the points of a table.
    Curve {
        /// The table.
        table: TableId,
        /// Its columns with the coordinates, m, frame axes.
        columns: [usize; 3],
        /// Unit vectors along its ends where they are given, frame axes.
        directions: [Option<[f64; 3]>; 2],
    },
    /// A smooth curve along a function.
    Path {
        /// Position, m, frame axes, as a function of a parameter, which stands as [`Expr::Arclength`].
        position: [Expr; 3],
        /// The parameter at the start and at the end.
        range: [Expr; 2],
    },
}

/// A body from files of a finite-element program.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Paths of the files, relative to the crate's manifest.
    pub files: Vec<String>,
    /// Their units of length, mass and time in SI.
    pub units: [f64; 3],
    /// Names of the interfaces, and the numbers of their nodes.
    pub interfaces: Vec<(String, Vec<u64>)>,
    /// Where the interfaces are, m, body axes.
    pub places: Vec<[f64; 3]>,
    /// Whether all motions of the interfaces are kept beside the modes.
    pub keeps_interfaces: bool,
    /// Part of critical damping in every mode, and damping proportional to stiffness, s.
    pub damping: [Expr; 2],
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
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
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
    /// Position, and direction of the slope, or of the section's axes where the body has them; norms
    /// stay free.
    Clamp,
    /// Position and the whole slope, or the section's axes with their norms.
    ClampFull,
    /// Position.
    Pin,
    /// One component of the position, slope, or section's axes in the body's own frame, at its
    /// undeformed value.
    Hold {
        /// What is held.
        of: Held,
        /// Frame axis 0, 1, 2.
        axis: usize,
    },
}

/// A nodal vector that a joint holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Held {
    /// Position.
    Position,
    /// Slope.
    Slope,
    /// Section's y axis.
    SectionY,
    /// Section's z axis.
    SectionZ,
}

impl Held {
    /// Order of the derivative of what it interpolates: 1 of a slope.
    pub fn order(self) -> usize {
        usize::from(self == Held::Slope)
    }
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
    /// Gravity on all mass, m/s^2, inertial axes, as a function of the particle's position.
    Around([Expr; 3]),
    /// Uniform gravity on what a free frame carries, m/s^2, inertial axes, as a function of markers fixed in
    /// that frame or in prescribed ones.
    Field {
        /// The frame.
        frame: FrameId,
        /// Markers, in the order of the emitted function's arguments.
        markers: Vec<MarkerId>,
        /// Components, m/s^2.
        components: [Expr; 3],
    },
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
        let (Self::Gravity(components)
        | Self::Around(components)
        | Self::Field { components, .. }
        | Self::Force { components, .. }
        | Self::Moment { components, .. }) = self;
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
}

impl Default for Run {
    fn default() -> Self {
        Self {
            t_end: Expr::Number(1.0),
            every: Expr::Number(0.01),
        }
    }
}
