//! Gravity, and dead loads in prescribed frames.

use super::expression::{Expr, Location};
use super::ids::{BodyId, FrameId, MarkerId};

/// A load.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// What it is.
    pub kind: LoadKind,
}

/// Kinds of loads.
#[derive(Clone, Debug)]
pub enum LoadKind {
    /// Uniform gravity on all bodies, m/s^2, inertial axes.
    Gravity([Expr; 3]),
    /// Gravity on all mass, m/s^2, inertial axes, as a function of the particle's position.
    Around([Expr; 3]),
    /// Uniform gravity on what a free frame carries, m/s^2, inertial axes, as a function of markers fixed in
    /// that frame or in prescribed ones.
    Field {
        /// The frame.
        frame: FrameId,
        /// Markers, in the order of the emitted function's arguments.
        markers: Vec<MarkerId>,
        /// Components, m/s^2.
        components: [Expr; 3],
    },
    /// Dead force (N) at a point of a body, axes of a frame, function of t.
    Force {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// Components, N.
        components: [Expr; 3],
        /// In the axes of this frame.
        frame: FrameId,
    },
    /// Dead moment (N m) at a point of a body, axes of a frame, function of t.
    Moment {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// Components, N m.
        components: [Expr; 3],
        /// In the axes of this frame.
        frame: FrameId,
    },
}

impl LoadKind {
    /// Components of the load, in the axes of its frame.
    pub fn components(&self) -> &[Expr; 3] {
        let (Self::Gravity(components)
        | Self::Around(components)
        | Self::Field { components, .. }
        | Self::Force { components, .. }
        | Self::Moment { components, .. }) = self;
        components
    }
}
