//! What sections carry, against closed forms and equilibrium of cut parts.

mod balance;
mod beside;
mod broken;
mod cut;
mod envelopes;
mod models;
mod rotation;
mod statics;
