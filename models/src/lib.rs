//! The scenes of the paper and of the benchmarks, one file each.

mod spin_up;
mod spin_up_spatial;

pub use spin_up::{SpinUp, spin_up_equations};
pub use spin_up_spatial::{SpinUpSpatial, spin_up_spatial_equations};
