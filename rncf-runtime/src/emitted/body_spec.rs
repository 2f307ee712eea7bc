//! A meshed body: its axis, its nodes, the vectors of its elements.

use std::fmt;

use super::line::{Line, Twist};
use super::stations::go_on;

/// Degrees of freedom of the largest element; the generator refuses larger ones. Arrays of 36 cost up to 7 % more instructions a run (`bench/instructions.sh`).
pub(crate) const MAX_SIZE: usize = 32;
/// Distance from a node at which an element has its own properties, as a part of the element.
const BESIDE: f64 = 1e-9;

/// A meshed body.
#[derive(Clone, Debug)]
pub struct BodySpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Index of its declaration: bodies of one kind share kernels.
    pub kind: usize,
    /// Number of the repetition where the declaration stands in a loop.
    pub instance: Option<usize>,
    /// Index of its declared frame.
    pub frame: usize,
    /// Frame axes of the components of its vectors: two for planar bodies, else three.
    pub axes: &'static [usize],
    /// Stress-free axis in the declared frame.
    pub line: Line,
    /// Number of elements.
    pub count: usize,
    /// Fractions of the axis in [0, 1] at the nodes, ascending, both ends included; empty: all elements are equally long.
    pub stations: Vec<f64>,
    /// An element's nodal vectors by local number.
    pub nodal: &'static [NodalSpec],
    /// Place of each local vector relative to the first vector of the element's first node.
    pub connectivity: &'static [usize],
    /// Number of vectors of a node.
    pub vectors_per_node: usize,
    /// Number of vectors from one node to the next: those inside an element follow its first node's.
    pub stride: usize,
    /// Direction of the section's y axis at the start, frame axes, not yet normal to the tangent; `None`:
    /// z x tangent, or y where the axis starts along z.
    pub section_y: Option<[f64; 3]>,
    /// Stress-free twist of the section about the tangent.
    pub twist: Twist,
    /// How finely its deformation is described.
    pub fidelity: Fidelity,
    /// Whether rates of strain count: something damps.
    pub damps: bool,
    /// What its free frame follows beside joints.
    pub tie: FrameTie,
    /// Where normals of sections are vectors of their own: element and place on it in [0, 1]. The scene fills them in, for
    /// rigid fixtures; such vectors follow those of the nodes.
    pub normals: Vec<(usize, f64)>,
}

/// What of a body its free frame follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameTie {
    /// Joints alone.
    #[default]
    Joints,
    /// Its mean axes (THEORY 6, Buckens).
    MeanAxes,
    /// The line from its start to its end, and about it the mean.
    Chord,
}

impl FrameTie {
    /// The name of what is followed.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Joints => "joints",
            Self::MeanAxes => "mean axes",
            Self::Chord => "chord",
        }
    }

    /// The word of the declaration.
    pub fn word(self) -> &'static str {
        match self {
            Self::Joints => "joint",
            Self::MeanAxes => "mean_axes",
            Self::Chord => "chord",
        }
    }
}

/// What a nodal vector interpolates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolant {
    /// Position r of the axis.
    Position,
    /// Derivative of the position along the section's y axis, r_y; in a plane the only one.
    SectionY,
    /// Derivative of the position along the section's z axis, r_z; not in a plane.
    SectionZ,
}

/// A nodal vector of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalSpec {
    /// Its name in messages, e.g. `position`.
    pub meaning: &'static str,
    /// What it interpolates.
    pub of: Interpolant,
    /// Its order: 0 value, 1 slope d/dx.
    pub order: usize,
    /// Where on the element it is, xi: 0 at its first node, 1 at its last, between them inside.
    pub xi: f64,
}

impl NodalSpec {
    /// Whether it is a position, which moves with an origin; all others are directions.
    pub fn is_position(&self) -> bool {
        self.of == Interpolant::Position && self.order == 0
    }
}

/// How finely the deformation of a body is described (THEORY 3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Fidelity {
    /// All nodal vectors.
    #[default]
    Full,
    /// Modal coordinates of this number of lowest modes in the body's frame, Eqs. (15)-(17).
    Modal(usize),
    /// The same for small deformations, with constant mass matrix, Eqs. (18)-(20).
    Small(usize),
    /// No deformation.
    Rigid,
    /// No deformation, and all mass at the centre of mass: no rotary inertia. Joints keep their places.
    Point,
}

impl BodySpec {
    /// Name for messages: `main`, or `main[3]` of a repeated body.
    pub fn label(&self) -> String {
        match self.instance {
            Some(instance) => format!("{}[{instance}]", self.name),
            None => self.name.to_string(),
        }
    }

    /// Components of a nodal vector.
    pub fn dimension(&self) -> usize {
        self.axes.len()
    }

    /// Degrees of freedom of one element.
    pub fn element_size(&self) -> usize {
        self.nodal.len() * self.dimension()
    }

    /// Node (of vectors inside an element its first) and local number of a nodal vector, counted in the
    /// body. The normal of a section stands beside the section's y axis of its element.
    pub fn locate(&self, vector: usize) -> (usize, usize) {
        if let Some(normal) = vector.checked_sub(self.meshed_vectors()) {
            let element = self.normals.get(normal).map_or(0, |&(element, _)| element);
            let is_axis = |vector: &NodalSpec| vector.of == Interpolant::SectionY;
            return (element, self.nodal.iter().position(is_axis).unwrap_or(0));
        }
        let place = vector % self.stride;
        let local = self.connectivity.iter().position(|&other| other == place).unwrap_or(0);
        (vector / self.stride, local)
    }

    /// Length of an element, m.
    pub fn element_length(&self, element: usize) -> f64 {
        match self.stations.get(element..element + 2) {
            Some([start, end]) => self.line.length() * (end - start),
            _ => self.line.length() / self.count as f64,
        }
    }

    /// Arclength (m) of a place `xi` in [0, 1] of an element.
    pub fn arclength(&self, element: usize, xi: f64) -> f64 {
        self.arclength_of(self.line.length(), element, xi)
    }

    /// The same where the length of the line (m) is at hand.
    pub(crate) fn arclength_of(&self, length: f64, element: usize, xi: f64) -> f64 {
        match self.stations.get(element..element + 2) {
            Some([start, end]) => length * (start + xi * (end - start)),
            _ => length * (element as f64 + xi) / self.count as f64,
        }
    }

    /// The same where the element has its own properties: at a node at which they step they may be those of the next one.
    pub(crate) fn arclength_inside(&self, length: f64, element: usize, xi: f64) -> f64 {
        self.arclength_of(length, element, xi.clamp(BESIDE, 1.0 - BESIDE))
    }

    /// The element and the place in it, in [0, 1], at a fraction of the axis. What is a node but for the rounding of its place
    /// is one: it begins the element beyond it.
    pub fn find(&self, fraction: f64) -> (usize, f64) {
        let (place, round_off) = match self.stations[..] {
            [] => (fraction * self.count as f64, 4.0 * f64::EPSILON * self.count as f64),
            ref stations => {
                let beyond = stations.partition_point(|&station| station <= fraction);
                let element = beyond.saturating_sub(1).min(self.count - 1);
                let length = stations[element + 1] - stations[element];
                (
                    element as f64 + (fraction - stations[element]) / length,
                    4.0 * f64::EPSILON / length,
                )
            }
        };
        let nearest = place.round();
        let place = if (place - nearest).abs() <= round_off {
            nearest
        } else {
            place
        };
        let element = (place as usize).min(self.count - 1);
        (element, place - element as f64)
    }

    /// Makes this number of elements of each one where the body has a mesh and deforms, unknown with all their nodal vectors, or where its elements
    /// integrate what is `loaded` on it, and says whether it did. Nodes stay nodes.
    pub(crate) fn refine(&mut self, times: usize, is_loaded: bool) -> bool {
        if matches!(self.line, Line::Nodes(_)) {
            return false;
        }
        if !matches!(self.fidelity, Fidelity::Rigid | Fidelity::Point) {
            self.fidelity = Fidelity::Full;
        } else if !is_loaded {
            return false;
        }
        if let [first, ends @ ..] = &self.stations[..] {
            let mut finer = vec![*first];
            for &end in ends {
                go_on(&mut finer, end, times);
            }
            self.stations = finer;
        }
        self.count *= times;
        true
    }

    /// Nodal vectors of the body.
    pub fn vectors(&self) -> usize {
        self.meshed_vectors() + self.normals.len()
    }

    /// Nodal vectors of its elements, before the normals of sections.
    pub fn meshed_vectors(&self) -> usize {
        self.count * self.stride + self.vectors_per_node
    }

    /// Whether its nodes carry the section's axes.
    pub fn has_section(&self) -> bool {
        self.nodal.iter().any(|vector| vector.of != Interpolant::Position)
    }

    /// Number of interpolants: the axis alone, and the section's axes.
    pub fn interpolants(&self) -> usize {
        [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ]
            .into_iter()
            .filter(|&of| self.interpolates(of))
            .count()
    }

    /// Whether its elements interpolate this.
    pub fn interpolates(&self, of: Interpolant) -> bool {
        self.nodal.iter().any(|vector| vector.of == of)
    }

    /// Place of the vector of an end node that is this derivative of an interpolant, counted in the body;
    /// `None` where its nodes do not carry it.
    pub fn end_vector(&self, at_end: bool, of: Interpolant, order: usize) -> Option<usize> {
        let node = if at_end { self.count * self.stride } else { 0 };
        let is_it = |vector: &NodalSpec| vector.of == of && vector.order == order && vector.xi == 0.0;
        let local = self.nodal.iter().position(is_it)?;
        Some(node + self.connectivity[local])
    }
}

impl fmt::Display for Fidelity {
    /// As it is declared: `modal(3)`, `rigid`; `full` for all nodal vectors, for which the language has no word.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fidelity::Full => f.write_str("full"),
            Fidelity::Modal(count) => write!(f, "modal({count})"),
            Fidelity::Small(count) => write!(f, "small({count})"),
            Fidelity::Rigid => f.write_str("rigid"),
            Fidelity::Point => f.write_str("point"),
        }
    }
}

impl Fidelity {
    /// The description of a word, as [`Fidelity`] is displayed.
    ///
    /// # Errors
    /// The words that there are.
    pub fn named(word: &str) -> Result<Fidelity, String> {
        let count = |name: &str| {
            let inside = word.strip_prefix(name)?.strip_prefix('(')?.strip_suffix(')')?;
            inside.trim().parse::<usize>().ok().filter(|&count| count > 0)
        };
        match word {
            "full" => Ok(Fidelity::Full),
            "rigid" => Ok(Fidelity::Rigid),
            "point" => Ok(Fidelity::Point),
            _ => count("modal")
                .map(Fidelity::Modal)
                .or_else(|| count("small").map(Fidelity::Small))
                .ok_or_else(|| {
                    format!(
                        "`{word}` describes no body: write point, rigid, modal(4), small(4) with a number of modes, or full"
                    )
                }),
        }
    }

    /// Whether the body has freedoms of its own.
    pub fn deforms(self) -> bool {
        !matches!(self, Fidelity::Rigid | Fidelity::Point)
    }
}

/// A place on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// First node.
    Start,
    /// Last node.
    End,
    /// Arclength of the stress-free axis, m.
    At(f64),
    /// Part of its length.
    Part(f64),
}
