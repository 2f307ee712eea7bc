//! Bodies from finite-element programs: what files say, in SI; reduced to modes; with their inertia.

mod body;
mod craig_bampton;
mod files;
mod freedoms;
mod inertia;
mod lacking;
mod lowest;
mod reduce;
#[cfg(test)]
mod tests;
mod writer;

pub use body::{Imported, ImportedSpec};
pub use files::{hash, rows, spline};
pub use inertia::Inertia;
pub use reduce::Wanted;
pub use writer::{Named, archive};
