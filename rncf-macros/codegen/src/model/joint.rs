//! Joints whose conditions are linear in the nodal vectors of one body.

use super::expression::{Expr, Location};
use super::ids::{BodyId, FrameId, RepeatId};

/// A joint between a body's end and a prescribed frame or the body's own frame: its conditions are
/// linear in the nodal vectors.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
    /// What it fixes.
    pub kind: JointKind,
    /// Body.
    pub body: BodyId,
    /// The body's end ([`Location::Start`] or [`Location::End`]).
    pub at: Location,
    /// Frame that it is fixed to.
    pub frame: FrameId,
    /// Fixed point, m, joint frame's axes; `None`: where the undeformed body is at t = 0.
    pub point: Option<[Expr; 3]>,
}

/// What a joint fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Position, and direction of the slope, or of the section's axes where the body has them; norms
    /// stay free.
    Clamp,
    /// Position and the whole slope, or the section's axes with their norms.
    ClampFull,
    /// Position.
    Pin,
    /// One component of the position, slope, or section's axes in the body's own frame, at its
    /// undeformed value.
    Hold {
        /// What is held.
        of: Held,
        /// Frame axis 0, 1, 2.
        axis: usize,
    },
}

/// A nodal vector that a joint holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Held {
    /// Position.
    Position,
    /// Slope.
    Slope,
    /// Section's y axis.
    SectionY,
    /// Section's z axis.
    SectionZ,
}

impl Held {
    /// Order of the derivative of what it interpolates: 1 of a slope.
    pub fn order(self) -> usize {
        usize::from(self == Held::Slope)
    }
}
