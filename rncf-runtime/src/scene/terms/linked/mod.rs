//! What acts between frames and bodies: constraints and forces on markers (THEORY 2.2, 6).

mod constraints;
mod forces;
mod jets;
mod noise;
mod reach;
mod resolve;
mod triad;
mod undefined;

pub(crate) use forces::MarkedLoad;
pub(crate) use jets::Marker;
pub(crate) use resolve::markers;

use crate::emitted::ConstraintSpec;

/// A constraint that is there in the chosen formulation.
pub(crate) struct Linked {
    /// Index among the declared constraints.
    pub index: usize,
    /// As declared.
    pub spec: ConstraintSpec,
    /// The free frame near which differences of its points are taken; `None`: the origin of space.
    pub anchor: Option<usize>,
}
