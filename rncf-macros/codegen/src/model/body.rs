//! Flexible bodies: axis, section, how finely they are described, how they are integrated.

use std::collections::BTreeMap;

use super::along::{Law, Piece, Stations};
use super::expression::Expr;
use super::ids::{ElementId, FrameId, RepeatId, TableId, identifier};

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
    /// Whether its section says stiffness and mass by itself, so that it names no material.
    pub fn has_own_stiffness(&self) -> bool {
        self.material_name.is_empty() && !matches!(self.line, Line::Imported(_))
    }

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
    /// Hash of what is in them.
    pub hash: u64,
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
