//! What results are off by: finer meshes, other steps, doubts and cautions.

pub(super) mod accumulated;
pub(super) mod agreement;
pub(super) mod cautions;
pub(super) mod coarse;
pub(super) mod compared;
pub(super) mod doubts;
pub(super) mod finer;
pub(super) mod finer_model;
pub(super) mod finer_modes;
pub(super) mod marks;
pub(super) mod meshes;
mod on_steps;
mod rest;
pub(super) mod unfollowed;
