//! What acts on markers: declared forces, and points of loads per length and of masses under gravity.

use crate::emitted::ForceSpec;

/// A force on markers.
pub(crate) struct Push {
    /// Name in the declaration.
    pub name: &'static str,
    /// Markers that it depends on and acts on.
    pub markers: Vec<usize>,
    /// Whether it has a potential.
    pub conservative: bool,
    /// Whether it depends on differences of places alone.
    pub of_differences: bool,
    /// Number of angles and kinks in it.
    pub branches: usize,
    pub law: Law,
    /// Body and element that it is spread over; else it acts at one place.
    pub element: Option<(usize, usize)>,
}

/// What a force is a function of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Law {
    /// As the declared force with this index.
    Force(usize),
    /// A load per length at an arclength of an axis with a length (m), times a length (m).
    Distributed { load: usize, at: [f64; 2], weight: f64 },
    /// Gravity at the place of a mass, kg.
    Gravity { load: usize, mass: f64 },
}

impl Law {
    /// Whether it is at another place of the same load along a body, or of the same gravity.
    pub fn is_of_same_load(self, other: Self) -> bool {
        match (self, other) {
            (Self::Distributed { load, .. }, Self::Distributed { load: other, .. }) => load == other,
            (Self::Gravity { load, .. }, Self::Gravity { load: other, .. }) => load == other,
            _ => false,
        }
    }
}

impl From<(usize, ForceSpec)> for Push {
    fn from((index, spec): (usize, ForceSpec)) -> Self {
        Self {
            name: spec.name,
            markers: spec.markers.to_vec(),
            conservative: spec.conservative,
            of_differences: spec.of_differences,
            branches: spec.branches,
            law: Law::Force(index),
            element: None,
        }
    }
}

/// The points of one element that loads are spread over: consecutive forces on markers.
#[derive(Clone, Debug)]
pub(crate) struct Spread {
    pub body: usize,
    pub element: usize,
    pub forces: std::ops::Range<usize>,
}
