//! What large scenes need: repeated items, shared nodes, loads per length, starts in equilibrium, cautions.

use super::expression::{Comparison, Expr, Location};
use super::ids::{BodyId, FrameId, MarkerId, RepeatId};

/// `for index in 0..count { .. }`
#[derive(Clone, Debug)]
pub struct Repeat {
    /// Name of the index.
    pub index: String,
    /// How often, a count.
    pub count: Expr,
}

/// Two ends of bodies in one frame that are one node: assembly, no equation.
#[derive(Clone, Debug)]
pub struct Share {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
    /// The two ends.
    pub ends: [(BodyId, Location); 2],
    /// Whether all nodal vectors are one (slopes, and axes of the section), else the position alone.
    pub smooth: bool,
}

/// A load per length of a body's stress-free axis: virtual work `int f . dp dx`.
#[derive(Clone, Debug)]
pub struct Density {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Body; all its repetitions, the expressions may contain [`Expr::Index`].
    pub body: BodyId,
    /// Markers that it depends on, in the order of the emitted function's arguments; their velocities, too.
    pub markers: Vec<MarkerId>,
    /// Force per length, N/m, axes of the body's frame, as a function of [`Expr::Local`], markers, time and index.
    pub components: [Expr; 3],
}

/// A load per length that is a function of the particle: place, velocity, slope and axes of the section. It is integrated at
/// points of every element.
#[derive(Clone, Debug)]
pub struct Distributed {
    /// Name.
    pub name: String,
    /// Documentation comment.
    pub doc: String,
    /// Body; all its repetitions, the expressions may contain [`Expr::Index`].
    pub body: BodyId,
    /// Number of points of an element.
    pub points: usize,
    /// Forces per length on vectors of the particle, inertial axes: N/m on the position, N on directions; as functions of the
    /// markers of [`ParticleVector`], arclength, time and index.
    pub forces: Vec<(ParticleVector, [Expr; 3])>,
}

/// A vector of a particle of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ParticleVector {
    /// Its place, m.
    Position,
    /// Slope dp/dx.
    Slope,
    /// The section's y axis, not normalised.
    SectionY,
    /// The section's z axis.
    SectionZ,
}

impl ParticleVector {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Position, Self::Slope, Self::SectionY, Self::SectionZ];

    /// What stands for it in expressions: no marker of a model.
    pub fn marker(self) -> MarkerId {
        MarkerId(usize::MAX - self as usize)
    }

    /// The vector that a marker stands for.
    pub fn of(marker: MarkerId) -> Option<Self> {
        Self::ALL.into_iter().find(|vector| vector.marker() == marker)
    }
}

/// The bodies of a frame start in relative equilibrium: at rest in the frame, which turns uniformly, without
/// loads.
#[derive(Clone, Debug)]
pub struct Start {
    /// Name.
    pub name: String,
    /// Frame.
    pub frame: FrameId,
    /// Angular velocity of the uniform rotation, rad/s, frame axes; `None`: that of the frame at t = 0.
    pub spin: Option<[Expr; 3]>,
}

/// A sentence that stands with the results where its condition holds.
#[derive(Clone, Debug)]
pub struct Caution {
    /// Name.
    pub name: String,
    /// The sentence.
    pub text: String,
    /// Outputs (indices into the model's) that it is about; none: the whole run.
    pub outputs: Vec<usize>,
    /// When it holds: functions of params and of [`Expr::EndTime`].
    pub condition: (Comparison, Expr, Expr),
}
