//! What the generator emits for one model, as the runtime sees it.

use super::distributed::DistributedSpec;
use super::frame::FrameMotion;
use super::free::FreeSpec;
use super::lanes::LANES;
use super::markers::{ConstraintSpec, FixtureSpec, ForceSpec, MarkerSpec};
use super::repeated::{DensitySpec, ShareSpec, StartSpec};
use super::section_spec::SectionSpec;
use super::table::Table;
use crate::error::ModelError;
use crate::system::ConstraintLevel;
use crate::vector::Vector;

use super::body_spec::{BodySpec, Interpolant, MAX_SIZE};
use super::joints::{JointData, JointSpec, Prescribed};
use super::loads::LoadSpec;
use super::observed::ObservedSpec;

/// One model, as emitted: specifications and kernels. Indices follow the order of the declaration;
/// frame 0 is the inertial one. `absolute` means that the body's vectors are in the inertial frame.
/// Methods with a body here are emitted only for models that have what they are about.
pub trait Parts: Send + Sync + 'static {
    /// Bodies.
    fn bodies(&self) -> Vec<BodySpec> {
        Vec::new()
    }
    /// Joints.
    fn joints(&self) -> Vec<JointSpec> {
        Vec::new()
    }
    /// Loads.
    fn loads(&self) -> Vec<LoadSpec> {
        Vec::new()
    }
    /// What outputs read, in the order of [`Parts::outputs`]'s argument.
    fn observed(&self) -> Vec<ObservedSpec>;
    /// Number of output columns.
    fn output_columns(&self) -> usize;
    /// Number of frames, the inertial one included.
    fn frame_count(&self) -> usize;
    /// Name of a frame.
    fn frame_name(&self, frame: usize) -> &'static str;
    /// Whether energy is conserved: nothing moves or acts in a prescribed way, nothing damps.
    fn conservative(&self) -> bool;
    /// Times at which a derivative of a motion or load may jump, s.
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    /// Appends the gaps (left less right side) of conditions in motions and loads that time decides in another way than
    /// by [`Parts::kinks`], at time `t`, s, and their time derivatives.
    fn gaps(&self, _t: f64, _out: &mut Vec<[f64; 2]>) {}

    /// Prepares what depends on the stress-free shape: arclengths (m) of the nodes, and nodal vectors of every element of
    /// a body, in local order, one element after the other.
    ///
    /// # Errors
    /// A material or section that makes no physical sense, by name.
    fn prepare(&mut self, _body: usize, _nodes: &[f64], _shape: &[f64]) -> Result<(), ModelError> {
        Ok(())
    }

    /// Motion of every prescribed frame at `t`, jerks included where there are constraints on
    /// markers or mean axes; entries of free frames are not read.
    fn frames(&self, t: f64, motions: &mut [FrameMotion]);
    /// Initial position (m) and velocity relative to the frame (m/s) of a body at the arclength `x`
    /// (m) of its axis, each with its derivative by `x`, frame axes; `None`: undeformed, at rest in
    /// the frame.
    fn initial(&self, _body: usize, _x: f64) -> [Option<[Vector; 2]>; 2] {
        [None, None]
    }
    /// Ends of bodies that are one node.
    fn shares(&self) -> Vec<ShareSpec> {
        Vec::new()
    }
    /// Frames whose bodies start in relative equilibrium.
    fn starts(&self) -> Vec<StartSpec> {
        Vec::new()
    }
    /// Loads per length.
    fn densities(&self) -> Vec<DensitySpec> {
        Vec::new()
    }
    /// Values that a density depends on along the whole body, from its markers' values and velocities
    /// (inertial axes); `out` has [`DensitySpec::values`] entries.
    fn density_values(&self, _density: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    /// Their derivatives with respect to the markers' values: values x 3 k, rows first.
    fn density_values_gradient(
        &self,
        _density: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        _gradient: &mut [f64],
    ) {
    }
    /// Adds the generalised forces of a density on the nodal vectors of four elements of its kind of body, one in
    /// each lane; values lane by lane.
    fn density_force4(
        &self,
        _density: usize,
        _elements: &[(usize, usize); LANES],
        _values: &[[f64; LANES]],
        _q: &[[f64; LANES]],
        _force: &mut [[f64; LANES]],
    ) {
    }
    /// Adds their derivatives with respect to q (n x n, rows first) and with respect to the values (n x values).
    #[allow(clippy::too_many_arguments)]
    fn density_tangent4(
        &self,
        _density: usize,
        _elements: &[(usize, usize); LANES],
        _values: &[[f64; LANES]],
        _q: &[[f64; LANES]],
        _by_q: &mut [[f64; LANES]],
        _by_values: &mut [[f64; LANES]],
    ) {
    }
    /// Loads per length that are functions of vectors of a particle.
    fn distributed(&self) -> Vec<DistributedSpec> {
        Vec::new()
    }
    /// Force per length of such a load on the vectors of a particle, 3 k numbers, inertial axes, at an arclength of an axis with a
    /// length (m), from their values and velocities.
    fn distributed_force(
        &self,
        _load: usize,
        _t: f64,
        _at: [f64; 2],
        _z: &[Vector],
        _velocity: &[Vector],
        _out: &mut [f64],
    ) {
    }
    /// Its derivatives with respect to both: 3 k x 3 k each, rows first.
    #[allow(clippy::too_many_arguments)]
    fn distributed_tangent(
        &self,
        _load: usize,
        _t: f64,
        _at: [f64; 2],
        _z: &[Vector],
        _velocity: &[Vector],
        _by_value: &mut [f64],
        _by_velocity: &mut [f64],
    ) {
    }
    /// Gravity of a load at a place, m/s^2, inertial axes.
    fn around(&self, _load: usize, _t: f64, _place: Vector) -> Vector {
        [0.0; 3]
    }
    /// Its derivatives by the place, rows first.
    fn around_gradient(&self, _load: usize, _t: f64, _place: Vector, _gradient: &mut [f64; 9]) {}
    /// Gravity of a field load at its markers' values (inertial axes), m/s^2.
    fn field(&self, _load: usize, _t: f64, _z: &[Vector]) -> Vector {
        [0.0; 3]
    }
    /// Its derivatives with respect to the markers: 3 x 3 k, rows first.
    fn field_gradient(&self, _load: usize, _t: f64, _z: &[Vector], _gradient: &mut [f64]) {}

    /// Adds the elastic forces of one element.
    fn elastic_force(&self, _body: usize, _element: usize, _q: &[f64], _v: &[f64], _force: &mut [f64]) {}
    /// Adds their derivatives with respect to q and q', rows first.
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
    /// Adds the elastic forces of four elements of one kind of body, one in each lane: (body, element) for
    /// each, components of the nodal vectors.
    fn elastic_force4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[[f64; LANES]],
        v: &[[f64; LANES]],
        force: &mut [[f64; LANES]],
    ) {
        elastic_force_one_by_one(self, elements, q, v, force);
    }
    /// Adds their derivatives with respect to q and q' (n x n, rows first); `damping` is not touched where nothing
    /// damps.
    fn elastic_tangent4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[[f64; LANES]],
        v: &[[f64; LANES]],
        stiffness: &mut [[f64; LANES]],
        damping: &mut [[f64; LANES]],
    ) {
        elastic_tangent_one_by_one(self, elements, q, v, stiffness, damping);
    }

    /// Why there are no forces between two states that conserve energy: a sentence without its end; `None` where
    /// [`Parts::conserving_force`] does.
    fn conserving_obstacle(&self) -> Option<&'static str> {
        Some("its equations have no such forces")
    }
    /// Adds the elastic force of one element between two states, from its components in both: work U(end) - U(start), no
    /// moment about the mean positions.
    fn conserving_force(&self, _body: usize, _element: usize, _start: &[f64], _end: &[f64], _force: &mut [f64]) {}
    /// Adds its derivative with respect to the mean of both at a fixed start, rows first.
    fn conserving_tangent(&self, _body: usize, _element: usize, _start: &[f64], _end: &[f64], _stiffness: &mut [f64]) {}

    /// Whether a load's components depend on time.
    fn load_varies(&self, _load: usize) -> bool {
        false
    }
    /// Components of a load at `t`, in its frame's axes.
    fn load(&self, _load: usize, _t: f64) -> [f64; 3] {
        [0.0; 3]
    }

    /// Whether the elements of a body differ, in length or properties.
    fn varies(&self, _body: usize) -> bool {
        false
    }
    /// Tables that a body reads along its axis.
    fn tables(&self, _body: usize) -> Vec<&'static Table> {
        Vec::new()
    }
    /// Mass matrix of the vectors of an element (scalars, rows first).
    fn mass(&self, _body: usize, _element: usize, _mass: &mut [f64]) {}
    /// Strain energy of one element, J.
    fn energy(&self, _body: usize, _element: usize, _q: &[f64]) -> f64 {
        0.0
    }
    /// Weights of an element's nodal vectors in the `order`-th derivative d/dx of an interpolant at `xi` in [0, 1]:
    /// 0, 1 of the position, 0 of the section's axes, and those of [`Parts::fields`].
    #[allow(clippy::too_many_arguments)]
    fn shapes(&self, _body: usize, _element: usize, _of: Interpolant, _order: usize, _xi: f64, _weights: &mut [f64]) {}
    /// What stresses of a body follow from at the arclength `x` of an axis with a length, m.
    fn section(&self, _body: usize, _x: f64, _length: f64) -> SectionSpec {
        SectionSpec::NONE
    }
    /// Number of fields that the strain energy of a body depends on, and for each the interpolant and order
    /// of derivative.
    fn fields(&self, _body: usize) -> &'static [(Interpolant, usize)] {
        &[]
    }
    /// Forces on the fields of a body at a point of an element, dU/d(field) per unit length, body axes: N on
    /// order 1 of the position, N m on the others; from the fields' values in the stress-free shape, at
    /// present, and their rates, one vector of the body's dimension after the other, at an arclength of an axis with a length (m).
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
    /// Adds the generalised force of a moment (N m, body axes; planar: first component) on a slope.
    fn moment(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _force: &mut [f64]) {}
    /// Adds its derivative with respect to the slope, rows first.
    fn moment_tangent(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _tangent: &mut [f64]) {}
    /// Adds the generalised force of a moment (N m, body axes) on the axes r_y, r_z of a section in space
    /// (six numbers each): exact virtual work, `r_y x Q_y + r_z x Q_z = M`.
    fn section_moment(&self, _axes: &[f64; 6], _moment: [f64; 3], _force: &mut [f64; 6]) {}
    /// Adds its derivative with respect to the axes, rows first.
    fn section_moment_tangent(&self, _axes: &[f64; 6], _moment: [f64; 3], _tangent: &mut [f64; 36]) {}

    /// Conditions of a joint on the position and slope of its node: position rows, then direction or
    /// slope rows. `q`, `v`, `a` hold the position, then the slope; with a section its axes instead, unless
    /// the joint holds the slope. `rows` come as zeros; what is zero is not written.
    #[allow(clippy::too_many_arguments)]
    fn condition(
        &self,
        _joint: usize,
        _absolute: bool,
        _level: ConstraintLevel,
        _t: f64,
        _data: &JointData,
        _q: &[f64],
        _v: &[f64],
        _a: &[f64],
        _rows: &mut [f64],
    ) {
    }
    /// Derivatives of the conditions with respect to position and slope, rows first, into zeros.
    fn condition_jacobian(&self, _joint: usize, _absolute: bool, _t: f64, _data: &JointData, _jacobian: &mut [f64]) {}
    /// What the joint prescribes where its conditions are eliminated, into zeros.
    fn prescribed(&self, _joint: usize, _absolute: bool, _t: f64, _data: &JointData, _prescribed: &mut Prescribed) {}

    /// Values of the output columns from what they observe.
    fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]);

    /// Checks mass and inertia of rigid parts that depend on parameters.
    ///
    /// # Errors
    /// A mass or inertia that no body has, by name.
    fn check(&self) -> Result<(), ModelError> {
        Ok(())
    }
    /// Free frames, ascending.
    fn free(&self) -> Vec<FreeSpec> {
        Vec::new()
    }
    /// Markers.
    fn markers(&self) -> Vec<MarkerSpec> {
        Vec::new()
    }
    /// Constraints with multipliers.
    fn constraints(&self) -> Vec<ConstraintSpec> {
        Vec::new()
    }
    /// Forces on markers.
    fn forces(&self) -> Vec<ForceSpec> {
        Vec::new()
    }
    /// Fixtures of flexible bodies.
    fn fixtures(&self) -> Vec<FixtureSpec> {
        Vec::new()
    }

    /// Values of a constraint's rows, or of their total time derivatives (velocity, acceleration,
    /// jerk), from its markers' values and derivatives of that order and below.
    fn marker_constraint(
        &self,
        _constraint: usize,
        _level: ConstraintLevel,
        _t: f64,
        _z: &[[Vector; 4]],
        _rows: &mut [f64],
    ) {
    }
    /// dC/dz: rows x 3 k for k markers, rows first.
    fn marker_constraint_gradient(&self, _constraint: usize, _t: f64, _z: &[Vector], _gradient: &mut [f64]) {}
    /// d(dC/dt)/dz at constant z': rows x 3 k.
    fn marker_constraint_rate_gradient(
        &self,
        _constraint: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        gradient: &mut [f64],
    ) {
        gradient.fill(0.0);
    }
    /// sum_i lambda_i d^2 C_i/dz dz: 3 k x 3 k.
    fn marker_constraint_hessian(
        &self,
        _constraint: usize,
        _t: f64,
        _z: &[Vector],
        _lambda: &[f64],
        hessian: &mut [f64],
    ) {
        hessian.fill(0.0);
    }

    /// Whether a force on markers was declared as a load, which equilibria apply in parts.
    fn is_load(&self, _force: usize) -> bool {
        false
    }
    /// Forces on the markers of a force: 3 k numbers, inertial axes; positive ones act along z.
    fn marker_force(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    /// Their derivatives with respect to z and z': 3 k x 3 k each.
    fn marker_force_tangent(
        &self,
        _force: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        by_value.fill(0.0);
        by_velocity.fill(0.0);
    }
    /// For each angle that a force reads by its sine and cosine: both, by how much the force jumps where the angle goes from pi to -pi, and its
    /// size there.
    fn marker_force_branches(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    /// The same of a constraint.
    fn marker_constraint_branches(&self, _constraint: usize, _t: f64, _z: &[Vector], _out: &mut [f64]) {}
    /// Potential of a conservative force, J.
    fn marker_energy(&self, _force: usize, _t: f64, _z: &[Vector]) -> f64 {
        0.0
    }
}

/// One lane of an element's components.
fn lane_of(all: &[[f64; LANES]], lane: usize) -> [f64; MAX_SIZE] {
    let mut own = [0.0; MAX_SIZE];
    for (value, lanes) in own.iter_mut().zip(all) {
        *value = lanes[lane];
    }
    own
}

/// [`Parts::elastic_force4`] by [`Parts::elastic_force`].
pub fn elastic_force_one_by_one<P: Parts + ?Sized>(
    parts: &P,
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

/// [`Parts::elastic_tangent4`] by [`Parts::elastic_tangent`].
pub fn elastic_tangent_one_by_one<P: Parts + ?Sized>(
    parts: &P,
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
