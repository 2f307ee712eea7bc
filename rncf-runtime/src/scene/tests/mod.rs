//! Scenes with free frames against differences and balances, with kernels written by hand.

mod acceleration;
mod acting;
mod density;
mod differences;
mod inertia;
mod law;
mod levels;
mod model;
mod modes;
mod net;
mod nodal;
mod random;
mod refusals;
pub(crate) mod scenery;
mod sections;
mod shared;
mod uniform;
