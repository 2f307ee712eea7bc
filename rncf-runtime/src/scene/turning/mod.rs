//! Uniform motions, small motions about them, and starts in relative equilibrium.

pub(crate) mod circulation;
mod narrow;
pub(crate) mod neutral;
mod sections;
pub(crate) mod settle;
pub(crate) mod starts;
pub(crate) mod steady;
pub(crate) mod symmetry;
pub(crate) mod uniform;
pub(crate) mod whirl;
pub(crate) mod wholes;
