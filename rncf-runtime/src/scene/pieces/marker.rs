//! Markers, and what refers to them.

use crate::emitted::ConstraintSpec;
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::space::Vector;

/// A marker with what it needs at run time.
#[derive(Clone, Debug)]
pub(crate) enum Marker {
    /// Fixed in a frame: a point, else a direction.
    Fixed { frame: usize, at: Vector, is_point: bool },
    /// A vector at a place on a body.
    Body { point: MeshPoint, of: PlaceVector },
    /// What is fixed in a section, with its components in the triad of the section: a point, from the axis on, else a direction.
    Section {
        point: MeshPoint,
        along: Vector,
        is_point: bool,
    },
    /// The turning of a frame.
    Turn { frame: usize },
    /// The turning of a section.
    SectionTurn { point: MeshPoint },
    /// The angle of a free frame (index among the free ones).
    Angle { free: usize },
}

impl Marker {
    /// Whether it is a point rather than a direction, turning or angle.
    pub fn is_point(&self) -> bool {
        matches!(
            self,
            Self::Fixed { is_point: true, .. }
                | Self::Section { is_point: true, .. }
                | Self::Body {
                    of: PlaceVector::Position,
                    ..
                }
        )
    }
}

/// A constraint that is there in the chosen formulation.
pub(crate) struct Linked {
    /// Index among the declared constraints.
    pub index: usize,
    /// As declared.
    pub spec: ConstraintSpec,
    /// The free frame near which differences of its points are taken; `None`: the origin of space.
    pub anchor: Option<usize>,
}

/// A declared load on a body whose frame is free, or along the axes of a free frame.
pub(crate) struct MarkedLoad {
    /// Load.
    pub load: usize,
    /// What it acts on at its place: the point, or the slope or section's axes for a moment.
    pub markers: Vec<Marker>,
}
