//! Methods that fail, as short as they are in textbooks. They see the same systems as the runtime's.

pub mod euler_angles;
pub mod index_1;
pub mod index_3;
