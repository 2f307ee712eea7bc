//! Uniform motions: a rotation of the whole system about an axis fixed in space, or rest
//! (THEORY 8.1).

use crate::space::Vector;

/// What the system does in an equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Kind {
    /// It turns uniformly: prescribed frames with their spin at the time, which does not change, what
    /// moves freely with [`Uniform::spin`].
    #[default]
    Steady,
    /// It stands still: prescribed frames stay where they are at the time.
    Static,
}

/// A uniform rotation about an axis fixed in space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spin {
    /// Angular velocity W, rad/s, inertial axes.
    pub velocity: Vector,
    /// A point c of the axis, m, inertial axes.
    pub point: Vector,
}

/// A uniform rotation of the whole system about an axis fixed in space, or rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Uniform {
    /// Time whose motions, loads and constraints are taken, s.
    pub t: f64,
    /// Part of the load, 0 to 1. Spins are multiplied by it and loads by its square
    /// ([`Kind::Steady`]: as centrifugal forces are), or loads by itself ([`Kind::Static`]).
    pub scale: f64,
    /// Part of the spins at which the equilibrium is asked for, 0 to 1: loads are not scaled by it.
    pub spinning: f64,
    /// Rotation or rest.
    pub kind: Kind,
    /// Rotation of what moves freely, at scale 1; `None`: that of the prescribed frames which turn,
    /// else that of the declared start of the free frames.
    pub spin: Option<Spin>,
}

impl Uniform {
    /// The whole rotation with the motions of time `t` (s).
    pub fn steady(t: f64) -> Self {
        Self {
            t,
            scale: 1.0,
            spinning: 1.0,
            ..Self::default()
        }
    }

    /// Rest under the loads of time `t` (s).
    pub fn at_rest(t: f64) -> Self {
        Self {
            kind: Kind::Static,
            ..Self::steady(t)
        }
    }

    /// The same with all of its spins and loads.
    pub fn whole(&self) -> Self {
        Self {
            scale: 1.0,
            spinning: 1.0,
            ..*self
        }
    }

    /// The same at another part of the load.
    pub fn scaled(&self, scale: f64) -> Self {
        Self { scale, ..*self }
    }

    /// Factor of all velocities.
    pub fn speed(&self) -> f64 {
        match self.kind {
            Kind::Steady => self.scale * self.spinning,
            Kind::Static => 0.0,
        }
    }

    /// Factor of all loads.
    pub fn load(&self) -> f64 {
        match self.kind {
            Kind::Steady => self.scale * self.scale,
            Kind::Static => self.scale,
        }
    }
}
