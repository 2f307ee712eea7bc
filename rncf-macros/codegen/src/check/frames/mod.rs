//! Frames, rigid bodies, places on them, and vectors that move with them.

pub mod fixture;
pub mod frame;
pub mod free;
pub mod marker;
pub mod place;
pub mod plane;
pub mod rigid;
