//! The checked-in expansion of the models, to be read: it depends on the runtime alone.

#[rustfmt::skip]
pub mod andrews_squeezer;
#[rustfmt::skip]
pub mod bricard;
#[rustfmt::skip]
pub mod flyball_governor;
#[rustfmt::skip]
pub mod four_bar;
#[rustfmt::skip]
pub mod free_flight;
#[rustfmt::skip]
pub mod heavy_top;
#[rustfmt::skip]
pub mod slider_crank;
#[rustfmt::skip]
pub mod spin_up;
#[rustfmt::skip]
pub mod spin_up_spatial;
