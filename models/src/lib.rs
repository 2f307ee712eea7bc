//! The scenes of the paper and of the benchmarks, one file each.

mod spin_up;

pub use spin_up::SpinUp;
