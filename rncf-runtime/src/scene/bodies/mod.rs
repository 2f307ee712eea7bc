//! Bodies: how they are described, their numbering, places on them, their masses and undeformed sections.

pub(crate) mod described;
pub(crate) mod fidelity;
pub(crate) mod mesh_body;
pub(crate) mod nodal_mass;
pub(crate) mod place;
pub(crate) mod section;
pub(crate) mod undeformed;
