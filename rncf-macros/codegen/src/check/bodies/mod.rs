//! Bodies: their axes, meshes, and how finely they deform.

pub mod body;
pub mod corner;
pub mod curve;
pub mod fidelity;
pub mod import;
pub mod initial;
pub mod line;
pub mod mesh;
pub mod nodes;
pub mod share;
