//! What the equations of a scene are made of: the forces and constraints that
//! `kinds.rs` lists, and what they need.

pub(crate) mod conditions;
pub(crate) mod conserving;
pub(crate) mod constraint;
pub(crate) mod dead_loads;
pub(crate) mod density;
pub(crate) mod density_lanes;
pub(crate) mod density_sums;
pub(crate) mod distributed;
pub(crate) mod elastic;
pub(crate) mod fields;
pub(crate) mod fixtures;
pub(crate) mod force;
pub(crate) mod inertia;
pub(crate) mod inertia_tangent;
pub(crate) mod kinds;
pub(crate) mod linked;
pub(crate) mod moments;
pub(crate) mod rigid_sections;
pub(crate) mod ties;
