//! The checked-in expansion of the models, to be read: it depends on the runtime alone.

#[rustfmt::skip]
pub mod spin_up;
#[rustfmt::skip]
pub mod spin_up_spatial;
