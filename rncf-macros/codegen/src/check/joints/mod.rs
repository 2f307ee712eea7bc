//! Joints and constraints, corners and shared nodes.

pub mod constraint;
pub mod corner;
pub mod eliminated;
pub mod joint;
pub mod known;
pub mod loose;
pub mod share;
