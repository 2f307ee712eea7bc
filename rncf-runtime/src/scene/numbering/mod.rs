//! Which components are unknowns, where their entries stand, and which vectors are one.

pub(crate) mod assembly;
pub(crate) mod conditions;
pub(crate) mod layout;
pub(crate) mod shared;
pub(crate) mod turned;
pub(crate) mod units;
