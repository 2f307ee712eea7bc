//! Joints and constraints, and whether they determine what moves freely.

pub mod constraint;
pub mod distant;
pub mod drive;
pub mod eliminated;
pub mod joint;
pub mod loose;
pub mod ties;
