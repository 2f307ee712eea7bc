//! Frames and rigid bodies.

pub mod frame;
pub mod free;
pub mod plane;
pub mod rigid;
