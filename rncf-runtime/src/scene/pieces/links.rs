//! What acts between places: markers, with the constraints, forces and loads that refer to them.

use super::marker::{Linked, MarkedLoad, Marker};
use super::push::{Push, Spread};

/// Markers and what refers to them.
#[derive(Default)]
pub(crate) struct Links {
    pub markers: Vec<Marker>,
    pub constraints: Vec<Linked>,
    /// Forces on markers: declared ones, then those at points of loads per length and of masses.
    pub forces: Vec<Push>,
    /// Those that are spread over elements, by body and element.
    pub spread: Vec<Spread>,
    /// For every force the free frame near which differences of its points are taken.
    pub anchors: Vec<Option<usize>>,
    /// Declared loads on bodies whose frames are free, or along the axes of free frames.
    pub marked_loads: Vec<MarkedLoad>,
}
