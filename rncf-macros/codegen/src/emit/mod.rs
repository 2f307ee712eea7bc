//! From a model and its kernels to Rust.

pub mod expression;
pub mod kernel;
pub mod number;
