//! What the equations of a scene are made of: inertia, elasticity, fixtures, loads, fields, constraints and forces on markers.

pub(crate) mod conserving;
pub(crate) mod density;
pub(crate) mod density_lanes;
pub(crate) mod density_sums;
pub(crate) mod distributed;
pub(crate) mod fields;
pub(crate) mod fixtures;
pub(crate) mod inertia;
pub(crate) mod inertia_tangent;
pub(crate) mod linked;
pub(crate) mod moments;
pub(crate) mod rigid_sections;
pub(crate) mod ties;
