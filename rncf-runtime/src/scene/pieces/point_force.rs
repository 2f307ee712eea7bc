//! Forces inside elements.

use crate::space::Vector;

/// A generalised force on a vector at a place inside an element.
#[derive(Clone, Debug)]
pub(crate) struct PointForce {
    pub element: usize,
    /// Place on the element, between 0 and 1.
    pub xi: f64,
    /// Whether it acts on the position; else on a direction, and makes a moment.
    pub on_position: bool,
    /// Weights of the element's nodal vectors in the vector that it acts on.
    pub weights: Vec<f64>,
    /// N on a position, N m on a direction; axes of the frame that the body's vectors live in.
    pub force: Vector,
}
