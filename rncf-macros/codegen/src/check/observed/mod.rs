//! What outputs, laws and drives read of the system.

pub mod balance;
pub mod caution;
pub mod drive;
pub mod members;
pub mod observe;
pub mod output;
pub mod section_forces;
pub mod shown;
