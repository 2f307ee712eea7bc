//! Sections and materials, and what of them varies along an axis.

pub mod along;
pub mod law;
pub mod material;
pub mod section;
pub mod sound_law;
pub mod undamped;
