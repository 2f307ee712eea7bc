//! Bodies: how they are described, and their undeformed sections.

pub(crate) mod fidelity;
pub(crate) mod undeformed;
