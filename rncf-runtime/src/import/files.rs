//! What files say of a body: the text that the macro reads them with.

#[path = "../../../rncf-macros/codegen/src/import/mod.rs"]
mod formats;

pub use formats::*;
