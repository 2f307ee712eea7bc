//! Bodies: their axes, meshes, how finely they deform, and what of them varies along the axis.

pub mod along;
pub mod body;
pub mod curve;
pub mod fidelity;
pub mod import;
pub mod initial;
pub mod line;
pub mod mesh;
mod mesh_of_law;
pub mod sound_law;
