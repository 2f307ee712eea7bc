//! What outputs read.

use super::body_spec::Place;
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

/// Whose mass, momentum or energy it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Owner {
    /// All that moves: bodies and rigid bodies, with what is fixed to them.
    All,
    /// A meshed body with its fixtures.
    Body(usize),
    /// The rigid parts of a free frame.
    Frame(usize),
}

/// The point that an angular momentum is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The inertial origin.
    Origin,
    /// A point marker.
    Marker(usize),
    /// A centre of mass.
    CenterOf(Owner),
}

/// A sum over what moves; vectors have inertial axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BalanceQuantity {
    /// kg.
    Mass,
    /// kg m/s.
    Momentum,
    /// kg m^2/s, with velocities in the inertial frame.
    AngularMomentum(About),
    /// m.
    CenterOfMass,
    /// J.
    KineticEnergy,
    /// Of the elements, J.
    StrainEnergy,
    /// Potential of uniform gravity, zero in the inertial origin, J.
    GravityEnergy,
}

impl BalanceQuantity {
    /// In a sentence.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Mass => "mass",
            Self::Momentum => "momentum",
            Self::AngularMomentum(_) => "angular momentum",
            Self::CenterOfMass => "centre of mass",
            Self::KineticEnergy => "kinetic energy",
            Self::StrainEnergy => "strain energy",
            Self::GravityEnergy => "energy in gravity",
        }
    }
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
    /// Component of a sum over what moves.
    Balance {
        /// Whose.
        of: Owner,
        /// What.
        what: BalanceQuantity,
        /// 0, 1, 2; 0 of a scalar.
        component: usize,
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
