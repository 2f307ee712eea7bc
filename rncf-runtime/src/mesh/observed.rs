//! What outputs read.

use super::parts::Place;
use super::section_spec::SectionQuantity;

/// What is observed at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointQuantity {
    /// Position, m.
    Position,
    /// Velocity relative to the body's frame, m/s.
    Velocity,
    /// Slope dp/dx.
    Slope,
    /// Derivative of the position along the section's y axis.
    SectionY,
    /// Derivative of the position along the section's z axis.
    SectionZ,
}

/// Something that outputs read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObservedSpec {
    /// Component of a point, in the body's declared frame.
    Point {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
        /// What.
        what: PointQuantity,
        /// Frame axis 0, 1, 2.
        component: usize,
    },
    /// Component of a marker or of its time derivatives, inertial axes.
    Marker {
        /// Marker.
        marker: usize,
        /// 0 value, 1 velocity, 2 acceleration.
        derivative: usize,
        /// 0, 1, 2.
        component: usize,
    },
    /// Component of what a constraint exerts on its first party, inertial axes; the moment is about
    /// the first point among its markers.
    ConstraintReaction {
        /// Constraint.
        constraint: usize,
        /// Moment instead of force.
        moment: bool,
        /// 0, 1, 2.
        component: usize,
    },
    /// Multiplier of one row of a constraint.
    Multiplier {
        /// Constraint.
        constraint: usize,
        /// Row.
        row: usize,
    },
    /// What a body carries at a place: what the part beyond it exerts on the part before it.
    Section {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
        /// What.
        what: SectionQuantity,
    },
    /// Component of what a joint exerts on its body, in the joint's frame, about its point.
    Reaction {
        /// Joint.
        joint: usize,
        /// Moment instead of force.
        moment: bool,
        /// Frame axis 0, 1, 2.
        component: usize,
    },
}
