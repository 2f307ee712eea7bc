//! Where and how the system starts, and what can be said of it there: whether joints fit and what holds what.

pub mod distant;
pub mod nodes;
pub mod spinning;
pub mod start;
pub mod ties;
