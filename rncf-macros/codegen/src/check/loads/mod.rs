//! Loads, springs and states.

pub mod bushing;
pub mod coordinate;
pub mod density;
pub mod distributed;
pub mod load;
pub mod marker_forces;
pub mod spring;
pub mod state;
pub mod weight;
