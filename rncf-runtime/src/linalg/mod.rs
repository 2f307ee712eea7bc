//! Sparse linear algebra: a fixed pattern, and saddle-point systems on it.

mod pattern;
mod saddle;

pub use pattern::Pattern;
pub use saddle::{Saddle, Singular};
