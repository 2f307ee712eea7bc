//! What is declared at places of bodies, with the points that were found for them.

use crate::scene::bodies::place::MeshPoint;

/// Declarations, and for each its point on a body where it has one.
pub(crate) struct Placed<S> {
    pub specs: Vec<S>,
    pub points: Vec<Option<MeshPoint>>,
}

impl<S> From<Vec<S>> for Placed<S> {
    /// Nothing has a point yet.
    fn from(specs: Vec<S>) -> Self {
        Self {
            points: Vec::new(),
            specs,
        }
    }
}
