//! The kernels of an element variant.

use super::choose::{ElasticKernels, elastic_kernels};
use super::field_forces::field_forces_kernel;
use super::inertia::mass_kernel;
use super::kernel::Kernel;
use super::loads;
use super::variant::Variant;
use crate::elements::{Interpolant, Library};

/// An element variant with its kernels.
pub struct VariantKernels {
    /// The variant.
    pub variant: Variant,
    /// Name in generated code.
    pub name: String,
    /// Elastic kernels.
    pub elastic: ElasticKernels,
    /// Mass matrix of the nodal vectors.
    pub mass: Kernel,
    /// Weights of the nodal vectors in each interpolant and its derivatives.
    pub shapes: Vec<(Interpolant, Vec<Kernel>)>,
    /// Forces on the fields at a point.
    pub field_forces: Kernel,
}

/// Derives them.
pub fn variant_kernels(variant: Variant, library: &Library) -> VariantKernels {
    let elastic = elastic_kernels(&variant, library);
    let name = variant.name(library);
    VariantKernels {
        mass: mass_kernel(&variant, library),
        shapes: loads::shape_kernels(&variant, library),
        field_forces: field_forces_kernel(&variant, library),
        elastic,
        name,
        variant,
    }
}
