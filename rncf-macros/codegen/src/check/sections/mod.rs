//! Sections and materials.

pub mod known;
pub mod law;
pub mod material;
pub mod section;
pub mod undamped;
