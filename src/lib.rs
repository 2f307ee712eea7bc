//! Facade
pub use rncf_macros::model;
pub use rncf_runtime::*;
