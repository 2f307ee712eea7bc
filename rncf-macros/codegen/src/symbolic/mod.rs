//! Hash-consed expression graph: equal expressions are one node, and simplification happens in the
//! constructors, so that an unsimplified or duplicate node cannot exist.
//!
//! Invariants: children have smaller numbers than their parents (numbers are a topological order);
//! numbers are finite f64 compared by bits; nothing is merged within a tolerance.

mod array;
mod cost;
mod differentiate;
mod evaluate;
mod graph;
mod guards;
mod invariants;
pub mod linear;
mod time;

pub use cost::Cost;
pub use evaluate::Scalar;
pub use graph::{Array, Column, Graph, Id, Node};
pub use invariants::{Invariant, Product, invariants};
pub use time::{Time, along_axis, derived, path_of, unit};
