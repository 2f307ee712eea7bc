//! From energies and motions to kernels: everything that is derived is derived here, and the
//! cheapest form is chosen by counted operations.

pub mod branches;
pub mod choose;
pub mod conserving;
pub mod constraints;
pub mod courses;
pub mod density;
mod differences;
pub mod distributed;
pub mod elastic;
pub mod equations;
pub mod field_forces;
pub mod forces;
pub mod form;
pub mod free;
pub mod inertia;
pub mod initial;
pub mod invariants;
pub mod joints;
pub mod kernel;
pub mod loads;
pub mod markers;
pub mod material;
pub mod motions;
pub mod peaks;
pub mod quadratic;
mod signature;
pub mod variant;
pub mod variant_kernels;

#[cfg(test)]
mod tests;

pub use choose::{ElasticKernels, elastic_kernels};
pub use equations::{Equations, lower};
pub use kernel::{Kernel, PointLoop};
pub use signature::camel_case;
pub use variant::{Connectivity, Variant};
pub use variant_kernels::VariantKernels;
