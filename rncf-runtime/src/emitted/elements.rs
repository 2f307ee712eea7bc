//! Bodies bodies as emitted: their elements.

use super::body_spec::{BodySpec, Interpolant, MAX_SIZE};
use super::lanes::LANES;
use super::markers::FixtureSpec;
use super::repeated::{ShareSpec, StartSpec};
use super::section_spec::SectionSpec;
use super::table::Table;
use crate::error::ModelError;

/// Bodies bodies: their specifications and the kernels of their elements.
pub trait Bodies {
    /// Bodies.
    fn bodies(&self) -> Vec<BodySpec>;
    /// Prepares what depends on the stress-free shape: arclengths (m) of the nodes, and nodal vectors of every element of
    /// a body, in local order, one element after the other.
    ///
    /// # Errors
    /// A material or section that makes no physical sense, by name.
    fn prepare(&mut self, body: usize, nodes: &[f64], shape: &[f64]) -> Result<(), ModelError>;
    /// Initial position (m) and velocity relative to the frame (m/s) of a body at the arclength `x`
    /// (m) of its axis, each with its derivative by `x`, frame axes; `None`: undeformed, at rest in
    /// the frame.
    fn initial(&self, body: usize, x: f64) -> [Option<[[f64; 3]; 2]>; 2];
    /// Ends of bodies that are one node.
    fn shares(&self) -> Vec<ShareSpec>;
    /// Frames whose bodies start in relative equilibrium.
    fn starts(&self) -> Vec<StartSpec>;
    /// Adds the elastic forces of one element.
    fn elastic_force(&self, body: usize, element: usize, q: &[f64], v: &[f64], force: &mut [f64]);
    /// Adds their derivatives with respect to q and q', rows first.
    fn elastic_tangent(
        &self,
        body: usize,
        element: usize,
        q: &[f64],
        v: &[f64],
        stiffness: &mut [f64],
        damping: &mut [f64],
    );
    /// Adds the elastic forces of four elements of one kind of body, one in each lane: (body, element) for
    /// each, components of the nodal vectors.
    fn elastic_force4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[[f64; LANES]],
        v: &[[f64; LANES]],
        force: &mut [[f64; LANES]],
    );
    /// Adds their derivatives with respect to q and q' (n x n, rows first); `damping` is not touched where nothing
    /// damps.
    fn elastic_tangent4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[[f64; LANES]],
        v: &[[f64; LANES]],
        stiffness: &mut [[f64; LANES]],
        damping: &mut [[f64; LANES]],
    );
    /// Whether the elements of a body differ, in length or properties.
    fn varies(&self, body: usize) -> bool;
    /// Tables that a body reads along its axis.
    fn tables(&self, body: usize) -> Vec<&'static Table>;
    /// Those properties of a body's section and material that vary along its axis, by their words in the language, at an arclength, m, of its length,
    /// m, in SI; nothing of others.
    fn properties(&self, body: usize, x: f64, length: f64) -> Vec<(&'static str, f64)>;
    /// Mass matrix of the vectors of an element (scalars, rows first).
    fn mass(&self, body: usize, element: usize, mass: &mut [f64]);
    /// Strain energy of one element, J.
    fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64;
    /// Weights of an element's nodal vectors in the `order`-th derivative d/dx of an interpolant at `xi` in [0, 1]:
    /// 0, 1 of the position, 0 of the section's axes, and those of [`Bodies::fields`].
    #[allow(clippy::too_many_arguments)]
    fn shapes(&self, body: usize, element: usize, of: Interpolant, order: usize, xi: f64, weights: &mut [f64]);
    /// What stresses of a body follow from at the arclength `x` of an axis with a length, m.
    fn section(&self, body: usize, x: f64, length: f64) -> SectionSpec;
    /// Number of fields that the strain energy of a body depends on, and for each the interpolant and order
    /// of derivative.
    fn fields(&self, body: usize) -> &'static [(Interpolant, usize)];
    /// Forces on the fields of a body at a point of an element, dU/d(field) per unit length, body axes: N on
    /// order 1 of the position, N m on the others; from the fields' values in the stress-free shape, at
    /// present, and their rates, one vector of the body's dimension after the other, at an arclength of an axis with a length (m).
    fn field_forces(
        &self,
        body: usize,
        at: [f64; 2],
        stress_free: &[f64],
        fields: &[f64],
        rates: &[f64],
        forces: &mut [f64],
    );
    /// Fixtures of flexible bodies.
    fn fixtures(&self) -> Vec<FixtureSpec>;
}

/// Strain energies that change with time.
pub trait TimedEnergies {
    /// Brings them to a time (s); what is asked of elements after that is asked for at this time.
    fn set_time(&mut self, t: f64);
    /// A body that has one, by name.
    fn timed_energy(&self) -> Option<&'static str>;
}

/// Of a model whose strain energies do not change with time.
pub trait WithoutTimedEnergies {}

impl<T: WithoutTimedEnergies> TimedEnergies for T {
    fn set_time(&mut self, _t: f64) {}
    fn timed_energy(&self) -> Option<&'static str> {
        None
    }
}

/// Of a model without meshed bodies.
pub trait WithoutBodies {}

impl<T: WithoutBodies> Bodies for T {
    fn bodies(&self) -> Vec<BodySpec> {
        Vec::new()
    }
    fn prepare(&mut self, _body: usize, _nodes: &[f64], _shape: &[f64]) -> Result<(), ModelError> {
        Ok(())
    }
    fn initial(&self, _body: usize, _x: f64) -> [Option<[[f64; 3]; 2]>; 2] {
        [None, None]
    }
    fn shares(&self) -> Vec<ShareSpec> {
        Vec::new()
    }
    fn starts(&self) -> Vec<StartSpec> {
        Vec::new()
    }
    fn elastic_force(&self, _body: usize, _element: usize, _q: &[f64], _v: &[f64], _force: &mut [f64]) {}
    fn elastic_tangent(
        &self,
        _body: usize,
        _element: usize,
        _q: &[f64],
        _v: &[f64],
        _stiffness: &mut [f64],
        _damping: &mut [f64],
    ) {
    }
    fn elastic_force4(
        &self,
        _elements: &[(usize, usize); LANES],
        _q: &[[f64; LANES]],
        _v: &[[f64; LANES]],
        _force: &mut [[f64; LANES]],
    ) {
    }
    fn elastic_tangent4(
        &self,
        _elements: &[(usize, usize); LANES],
        _q: &[[f64; LANES]],
        _v: &[[f64; LANES]],
        _stiffness: &mut [[f64; LANES]],
        _damping: &mut [[f64; LANES]],
    ) {
    }
    fn varies(&self, _body: usize) -> bool {
        false
    }
    fn properties(&self, _body: usize, _x: f64, _length: f64) -> Vec<(&'static str, f64)> {
        Vec::new()
    }
    fn tables(&self, _body: usize) -> Vec<&'static Table> {
        Vec::new()
    }
    fn mass(&self, _body: usize, _element: usize, _mass: &mut [f64]) {}
    fn energy(&self, _body: usize, _element: usize, _q: &[f64]) -> f64 {
        0.0
    }
    fn shapes(&self, _body: usize, _element: usize, _of: Interpolant, _order: usize, _xi: f64, _weights: &mut [f64]) {}
    fn section(&self, _body: usize, _x: f64, _length: f64) -> SectionSpec {
        SectionSpec::NONE
    }
    fn fields(&self, _body: usize) -> &'static [(Interpolant, usize)] {
        &[]
    }
    fn field_forces(
        &self,
        _body: usize,
        _at: [f64; 2],
        _stress_free: &[f64],
        _fields: &[f64],
        _rates: &[f64],
        _forces: &mut [f64],
    ) {
    }
    fn fixtures(&self) -> Vec<FixtureSpec> {
        Vec::new()
    }
}

/// Elastic forces of elements between two states, which conserve energy.
pub trait ConservingForces {
    /// Adds the elastic force of one element between two states, from its components in both: work U(end) - U(start), no
    /// moment about the mean positions.
    fn conserving_force(&self, body: usize, element: usize, start: &[f64], end: &[f64], force: &mut [f64]);
    /// Adds its derivative with respect to the mean of both at a fixed start, rows first.
    fn conserving_tangent(&self, body: usize, element: usize, start: &[f64], end: &[f64], stiffness: &mut [f64]);
}

/// Of a model without forces between two states that conserve energy.
pub trait WithoutConservingForces {}

impl<T: WithoutConservingForces> ConservingForces for T {
    fn conserving_force(&self, _body: usize, _element: usize, _start: &[f64], _end: &[f64], _force: &mut [f64]) {}
    fn conserving_tangent(&self, _body: usize, _element: usize, _start: &[f64], _end: &[f64], _stiffness: &mut [f64]) {}
}

/// One lane of an element's components.
fn lane_of(all: &[[f64; LANES]], lane: usize) -> [f64; MAX_SIZE] {
    let mut own = [0.0; MAX_SIZE];
    for (value, lanes) in own.iter_mut().zip(all) {
        *value = lanes[lane];
    }
    own
}

/// [`Bodies::elastic_force4`] by [`Bodies::elastic_force`].
pub fn elastic_force_one_by_one(
    parts: &dyn Bodies,
    elements: &[(usize, usize)],
    q: &[[f64; LANES]],
    v: &[[f64; LANES]],
    force: &mut [[f64; LANES]],
) {
    let size = q.len();
    let mut own = [0.0; MAX_SIZE];
    for (lane, &(body, element)) in elements.iter().enumerate() {
        let [q, v] = [q, v].map(|all| lane_of(all, lane));
        own[..size].fill(0.0);
        parts.elastic_force(body, element, &q[..size], &v[..size], &mut own[..size]);
        for (sum, value) in force.iter_mut().zip(&own) {
            sum[lane] += value;
        }
    }
}

/// [`Bodies::elastic_tangent4`] by [`Bodies::elastic_tangent`].
pub fn elastic_tangent_one_by_one(
    parts: &dyn Bodies,
    elements: &[(usize, usize)],
    q: &[[f64; LANES]],
    v: &[[f64; LANES]],
    stiffness: &mut [[f64; LANES]],
    damping: &mut [[f64; LANES]],
) {
    let size = q.len();
    let mut own = [0.0; 2 * MAX_SIZE * MAX_SIZE];
    for (lane, &(body, element)) in elements.iter().enumerate() {
        let [q, v] = [q, v].map(|all| lane_of(all, lane));
        own[..2 * size * size].fill(0.0);
        let (k, c) = own[..2 * size * size].split_at_mut(size * size);
        parts.elastic_tangent(body, element, &q[..size], &v[..size], k, c);
        for (sums, values) in [(&mut *stiffness, k), (&mut *damping, c)] {
            for (sum, value) in sums.iter_mut().zip(values) {
                sum[lane] += *value;
            }
        }
    }
}
