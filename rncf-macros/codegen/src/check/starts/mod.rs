//! Where and how the system starts.

pub mod spinning;
pub mod start;
