//! Loads per length that are functions of vectors of a particle.

use super::table::Table;

/// A load per length on one body, as a function of vectors of its particles.
#[derive(Clone, Debug)]
pub struct DistributedSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Body.
    pub body: usize,
    /// Number of points of an element.
    pub points: usize,
    /// Vectors of a particle that it depends on and acts on: 0 place, 1 slope, 2 and 3 the section's axes, ascending.
    pub vectors: &'static [usize],
    /// Tables that it reads along the axis.
    pub tables: Vec<&'static Table>,
}
