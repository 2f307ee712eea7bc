//! Everything that `model!` does, as a plain library:
//!
//! | phase | input | output |
//! |---|---|---|
//! | [`parse`] | tokens | syntax tree with spans |
//! | [`unfold`] | syntax tree | syntax tree without parts, and without loops whose number is known |
//! | [`check`] | syntax tree | [`model::Model`]: names resolved, SI, counted |
//! | [`tensors`] | element declaration | exact constant tensors |
//! | [`symbolic`] | energies, constraints, motions | expression graph and its derivatives |
//! | [`lower`] | expression graph | kernels, with the cheapest form chosen by count |
//! | [`emit`] | model and kernels | Rust |

#[macro_use]
mod messages;

pub mod check;
mod editor;
pub mod elements;
pub mod emit;
pub mod errors;
pub mod expand;
pub mod generate;
pub mod import;
pub mod joints;
mod library;
pub mod lower;
pub mod model;
pub mod parse;
pub mod stub;
mod suggest;
pub mod symbolic;
pub mod tensors;
pub mod unfold;
pub mod units;
pub mod vocabulary;
