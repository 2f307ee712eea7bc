//! The scenes of the paper and of the benchmarks, one file each.

mod andrews_squeezer;
mod bricard;
mod flyball_governor;
mod four_bar;
mod free_flight;
mod heavy_top;
mod slider_crank;
mod spin_up;
mod spin_up_spatial;

pub use andrews_squeezer::{AndrewsSqueezer, andrews_squeezer_equations};
pub use bricard::{Bricard, bricard_equations};
pub use flyball_governor::{FlyballGovernor, flyball_governor_equations};
pub use four_bar::{FourBar, four_bar_equations};
pub use free_flight::{FreeFlight, free_flight_equations};
pub use heavy_top::{HeavyTop, heavy_top_equations};
pub use slider_crank::{SliderCrank, slider_crank_equations};
pub use spin_up::{SpinUp, spin_up_equations};
pub use spin_up_spatial::{SpinUpSpatial, spin_up_spatial_equations};
