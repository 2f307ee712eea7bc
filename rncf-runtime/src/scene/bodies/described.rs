//! Bodies that are described by modes, as the scene with all nodal vectors sees them.

use crate::emitted::Parts;
use crate::space::{Matrix, Vector};

/// Elastic and damping forces of the elements of one body, without inertia.
pub trait Elements: Sync {
    /// Adds the force of one element with nodal vectors `q` and rates `v`.
    fn force(&self, element: usize, q: &[f64], v: &[f64], force: &mut [f64]);
    /// Adds its derivatives with respect to q and q', rows first.
    fn tangent(&self, element: usize, q: &[f64], v: &[f64], stiffness: &mut [f64], damping: &mut [f64]);
}

/// Elements of a body as emitted.
pub struct Kernels<'a> {
    /// Emitted parts.
    pub parts: &'a dyn Parts,
    /// Body.
    pub body: usize,
}

impl Elements for Kernels<'_> {
    fn force(&self, element: usize, q: &[f64], v: &[f64], force: &mut [f64]) {
        self.parts.elastic_force(self.body, element, q, v, force);
    }

    fn tangent(&self, element: usize, q: &[f64], v: &[f64], stiffness: &mut [f64], damping: &mut [f64]) {
        self.parts.elastic_tangent(self.body, element, q, v, stiffness, damping);
    }
}

/// Sums over the mass of a body, relative to the origin of its frame, frame axes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Inertial {
    /// kg
    pub mass: f64,
    /// First moment, kg m.
    pub moment: Vector,
    /// Moments of inertia about the origin, kg m^2.
    pub inertia: Matrix,
    /// As seen from an origin at rest, kg m/s.
    pub momentum: Vector,
    /// About the origin, kg m^2/s.
    pub spin: Vector,
    /// J, with the origin at rest.
    pub kinetic: f64,
}

/// A body that modes describe, or that is rigid: what the scene reads of it.
pub trait Described: Send + Sync {
    /// Whether its elastic forces are linear, those of the undeformed mesh, or there are none.
    fn is_linear(&self) -> bool;
    /// Its undeformed nodal vectors.
    fn shape(&self) -> &[f64];
    /// Whether its joints alone let it move in its frame, so that nothing says where its loads are carried to.
    fn is_loose(&self) -> bool;
    /// Sums over the mass of a body that has none in its nodal vectors, from these and their rates in its frame, which has a
    /// spin (rad/s, frame axes).
    fn inertial(&self, spin: Vector, at: [&[f64]; 2]) -> Option<Inertial>;
    /// Strain energy of a body that has no elements, J.
    fn strain_energy(&self, q: &[f64]) -> Option<f64>;
    /// Adds the linear elastic and damping forces of all elements on nodal vectors.
    fn add_linear_forces(&self, elements: &dyn Elements, at: [&[f64]; 2], force: &mut [f64]);
    /// Linear elastic and damping forces of one element on its nodal vectors; `q` and `v` are those of the body.
    fn linear_force(&self, elements: &dyn Elements, element: usize, at: [&[f64]; 2]) -> Vec<f64>;
    /// Lets the elements carry to the joints what the generalised forces on all nodal vectors, at the places `q`, leave
    /// unbalanced: afterwards only eliminated freedoms carry a force, that of their joints. Returns what is added to
    /// the forces of every element, one after the other.
    fn held(&self, elements: &dyn Elements, q: &[f64], force: &mut [f64]) -> Vec<f64>;
}
