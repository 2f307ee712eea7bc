//! How a strain energy is integrated, what a kernel computes, and what the form by fields consists of.

use super::kernel::Kernel;
use super::quadratic::{base_vector, is_position};
use super::variant::Variant;
use crate::elements::{Element, Interpolant, NodalVector};
use crate::model::Quadrature;
use crate::tensors::Sampling;

/// How the strain energy is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Constant tensor, unrolled.
    Tensor,
    /// Integration points, unrolled.
    Points,
    /// Integration points in a loop.
    Loop,
    /// Integration points in a loop of the runtime, unrolled at one point as functions of the fields.
    Fields,
}

/// What a kernel computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Generalised elastic and damping force.
    Force,
    /// Its derivatives with respect to positions and velocities.
    Tangent,
    /// Strain energy.
    Energy,
    /// Values in the stress-free shape that the other kernels subtract.
    Reference,
}

/// The rule of terms that say none, exact or not.
pub fn points(element: &Element, quadrature: Quadrature) -> Sampling {
    Sampling::Gauss(match quadrature {
        Quadrature::Exact => element.default_points,
        Quadrature::Gauss(points) => points,
    })
}

/// The rules that the terms of the energy ask for, each once, in the order of the terms.
pub fn rules(variant: &Variant, element: &Element) -> Vec<Sampling> {
    let default = points(element, variant.quadrature);
    if variant.material.is_some() {
        // Gradients and strains of the axis are in one energy, so that two points are not enough.
        return vec![default];
    }
    let (_, terms) = element.terms_in(variant.dimension, &variant.options);
    let mut rules = Vec::new();
    for term in terms {
        let points = term.points.unwrap_or(default);
        if !rules.contains(&points) {
            rules.push(points);
        }
    }
    rules
}

/// Nodal vectors by what they interpolate.
#[derive(Clone, Debug)]
pub struct Groups {
    /// Interpolants, one a group.
    pub of: Vec<Interpolant>,
    /// Nodal vectors of each group, the base left out.
    pub nodal: Vec<Vec<usize>>,
    /// The vector that positions are relative to.
    pub base: usize,
    /// Whether a nodal vector is a position.
    pub positions: Vec<bool>,
}

impl Groups {
    pub(super) fn of(vectors: &[&NodalVector]) -> Self {
        let base = base_vector(vectors);
        let mut groups = Self {
            of: Vec::new(),
            nodal: Vec::new(),
            base,
            positions: vectors.iter().map(|vector| is_position(vector)).collect(),
        };
        for (index, vector) in vectors.iter().enumerate() {
            if index == base {
                continue;
            }
            let group = groups.of.iter().position(|&of| of == vector.of).unwrap_or_else(|| {
                groups.of.push(vector.of);
                groups.nodal.push(Vec::new());
                groups.of.len() - 1
            });
            groups.nodal[group].push(index);
        }
        groups
    }

    /// Relative vectors of a group, the shorter ones filled up.
    pub fn size(&self) -> usize {
        self.nodal.iter().map(Vec::len).max().unwrap_or(0)
    }

    pub(super) fn group(&self, of: Interpolant) -> usize {
        self.of.iter().position(|&group| group == of).unwrap_or(0)
    }
}

/// Blocks of a tangent on fields that a kernel writes, in the order of its output.
#[derive(Clone, Debug)]
pub struct FieldBlocks {
    /// Fields of each block, as indices into [`FieldRule::fields`].
    pub pairs: Vec<(usize, usize)>,
    /// Blocks `from..to` of each tile (pair of groups): `(tile, from, to)`.
    pub tiles: Vec<(usize, usize, usize)>,
}

/// The terms of an energy that are integrated by one rule.
#[derive(Clone, Debug)]
pub struct FieldRule {
    /// Its points.
    pub points: Sampling,
    /// Fields that the terms depend on, as indices into the element's fields.
    pub fields: Vec<usize>,
    /// Group of each field.
    pub groups: Vec<usize>,
    /// Weights, and `[point][field][vector of its group]` derivatives of the shape functions.
    pub weights: Vec<f64>,
    /// See [`FieldRule::weights`].
    pub shapes: Vec<Vec<Vec<f64>>>,
    /// Kernels at a point: force, tangent, energy.
    pub kernels: [Kernel; 3],
    /// Derivatives of the energy of a material that is given by it: response, and rate of the stiffness where damped.
    pub particles: Vec<Kernel>,
    /// Blocks of the stiffness.
    pub stiffness: FieldBlocks,
    /// Blocks of the damping matrix, where damped.
    pub damping: Option<FieldBlocks>,
    /// Values in the stress-free shape at a point.
    pub references: usize,
}

/// Everything that the form by fields consists of.
#[derive(Clone, Debug)]
pub struct FieldKernels {
    /// Nodal vectors by what they interpolate.
    pub groups: Groups,
    /// One entry for each rule.
    pub rules: Vec<FieldRule>,
    /// Particles of a section, of a material given by its energy, those on the axis included; otherwise 0.
    pub particles: usize,
}
