//! What a scene is made of, one thing each: data that know nothing of the scene.

pub(crate) mod batches;
pub(crate) mod border;
pub(crate) mod buffers;
pub(crate) mod combination;
pub(crate) mod combined;
pub(crate) mod density;
pub(crate) mod displacement;
pub(crate) mod fixture;
pub(crate) mod links;
pub(crate) mod marker;
pub(crate) mod placed;
pub(crate) mod point_force;
pub(crate) mod push;
pub(crate) mod reach;
pub(crate) mod rigid_section;
pub(crate) mod rows;
pub(crate) mod tabulated;
