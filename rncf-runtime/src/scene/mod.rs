//! One model at run time: from emitted parts to a [`crate::System`].
//!
//! The generator emits a [`Parts`](crate::emitted::Parts): kernels, frames, conditions and outputs of one model. Everything
//! here is the same for all models: numbering, assembly, elimination, initial states.

pub(crate) mod bodies;
pub(crate) mod build;
pub(crate) mod evaluate;
pub(crate) mod frames;
pub(crate) mod initial;
pub(crate) mod jumps;
pub(crate) mod levers;
pub(crate) mod meeting;
pub(crate) mod mesh_scene;
pub(crate) mod numbering;
pub(crate) mod pieces;
pub(crate) mod read;
pub(crate) mod sizes;
pub(crate) mod sound;
pub(crate) mod states;
pub(crate) mod system;
pub(crate) mod terms;
#[cfg(test)]
pub(crate) mod tests;
pub(crate) mod turning;
pub(crate) mod view;

pub use mesh_scene::MeshScene;
