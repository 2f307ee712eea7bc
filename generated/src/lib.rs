//! The checked-in expansion of the models, to be read: it depends on the runtime alone.

#[rustfmt::skip]
pub mod andrews_squeezer;
#[rustfmt::skip]
pub mod bend_45;
#[rustfmt::skip]
pub mod bricard;
#[rustfmt::skip]
pub mod curved_downwind;
#[rustfmt::skip]
pub mod curved_out_of_plane;
#[rustfmt::skip]
pub mod curved_upwind;
#[rustfmt::skip]
pub mod elastica;
#[rustfmt::skip]
pub mod esail;
#[rustfmt::skip]
pub mod esail_slack;
#[rustfmt::skip]
pub mod esail_tilted;
#[rustfmt::skip]
pub mod flyball_governor;
#[rustfmt::skip]
pub mod four_bar;
#[rustfmt::skip]
pub mod free_flight;
#[rustfmt::skip]
pub mod heavy_top;
#[rustfmt::skip]
pub mod iea15mw_blade;
#[rustfmt::skip]
pub mod lateral_buckling;
#[rustfmt::skip]
pub mod motor;
#[rustfmt::skip]
pub mod nrel5mw_blade;
#[rustfmt::skip]
pub mod pinned_pipe;
#[rustfmt::skip]
pub mod princeton_beam;
#[rustfmt::skip]
pub mod right_angle_frame;
#[rustfmt::skip]
pub mod roll_up;
#[rustfmt::skip]
pub mod rotating_cantilever;
#[rustfmt::skip]
pub mod slider_crank;
#[rustfmt::skip]
pub mod spin_up;
#[rustfmt::skip]
pub mod spin_up_spatial;
