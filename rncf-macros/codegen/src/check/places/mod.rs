//! Places on bodies and frames, and vectors that move with them.

pub mod fixture;
pub mod marker;
pub mod place;
