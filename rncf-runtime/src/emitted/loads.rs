//! Loads.

use super::body_spec::Place;

/// Kind of a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadKind {
    /// Uniform gravity on all bodies.
    Gravity,
    /// Gravity on all mass that changes from place to place.
    Around,
    /// Uniform gravity on what the load's frame, a free one, carries, as a function of markers.
    Field {
        /// Markers fixed in that frame or in prescribed ones.
        markers: &'static [usize],
    },
    /// Force at a point.
    Force {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
    /// Moment at a point.
    Moment {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
}

/// A load.
#[derive(Clone, Debug)]
pub struct LoadSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// What it is.
    pub kind: LoadKind,
    /// Frame whose axes its components refer to.
    pub frame: usize,
}
