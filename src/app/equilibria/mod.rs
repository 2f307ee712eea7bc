//! Relative and static equilibria, followed along a parameter.

pub(super) mod balanced;
pub(super) mod buckling;
pub(super) mod continuation;
pub(super) mod directions;
pub(super) mod finer;
pub(super) mod located;
pub(super) mod nearer;
pub(super) mod steady;
pub(super) mod way;
