//! What is read off a state: outputs, pictures, what sections carry, and where a description does not hold.

pub(crate) mod balance;
pub(crate) mod between_points;
pub(crate) mod bodies;
pub(crate) mod compression;
pub(crate) mod configuration;
mod exerted;
pub(crate) mod fibres;
pub(crate) mod followed;
pub(crate) mod masses;
pub(crate) mod mesh_error;
pub(crate) mod operands;
pub(crate) mod outputs;
pub(crate) mod overstretch;
pub(crate) mod per_length;
pub(crate) mod point_forces;
pub(crate) mod sampled;
pub(crate) mod sampling;
pub(crate) mod section;
mod section_lanes;
pub(crate) mod signs;
pub(crate) mod strained;
pub(crate) mod stress;
mod stretch;
pub(crate) mod thick;
pub(crate) mod within_elements;
