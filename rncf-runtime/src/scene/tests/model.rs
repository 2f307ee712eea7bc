//! Parts by hand: elements with simple strains, and constraints and forces that are polynomials.

use super::law::Law;
use super::sections;
use crate::emitted::{
    Bodies, BodySpec, ConstraintSpec, DensitySpec, FixtureSpec, ForceSpec, FrameMotion, FreeSpec, Interpolant,
    JointConditions, JointData, JointKind, JointSpec, LANES, LoadSpec, MarkerSpec, ObservedSpec, Parts, Prescribed,
    SectionShape, SectionSpec, ShareSpec, StartSpec, Table, WithoutConservingForces, elastic_force_one_by_one,
    elastic_tangent_one_by_one,
};
use crate::error::ModelError;
use crate::model::{Formulation, Joints};
use crate::scene::MeshScene;
use crate::space::{Vector, exp, matrix};
use crate::system::ConstraintLevel;

/// Every pair of up to six markers, those of fewer markers first, and how many pairs so many markers have.
pub const EVERY: &[[usize; 2]] = &[
    [0, 1],
    [0, 2],
    [1, 2],
    [0, 3],
    [1, 3],
    [2, 3],
    [0, 4],
    [1, 4],
    [2, 4],
    [3, 4],
    [0, 5],
    [1, 5],
    [2, 5],
    [3, 5],
    [4, 5],
];
pub const PAIRS: [usize; 7] = [0, 0, 1, 3, 6, 10, 15];

/// A row `sum z_m . B z_n + sum b . z_m + c + s sin(2 t)` of a constraint.
#[derive(Clone, Debug, Default)]
pub struct Quadratic {
    pub products: Vec<(usize, usize, f64)>,
    pub linear: Vec<(usize, Vector)>,
    pub constant: f64,
    pub sine: f64,
}

/// Everything declared.
#[derive(Clone, Debug, Default)]
pub struct Hand {
    pub frames: Vec<&'static str>,
    /// Whether frame 1 shifts and frame 2 turns.
    pub moving: bool,
    pub bodies: Vec<BodySpec>,
    pub joints: Vec<JointSpec>,
    pub loads: Vec<(LoadSpec, Vector)>,
    pub free: Vec<FreeSpec>,
    pub markers: Vec<MarkerSpec>,
    pub constraints: Vec<(ConstraintSpec, Vec<Quadratic>)>,
    pub forces: Vec<(ForceSpec, Law)>,
    pub fixtures: Vec<FixtureSpec>,
    pub densities: Vec<DensitySpec>,
    pub shares: Vec<ShareSpec>,
    pub observed: Vec<ObservedSpec>,
    pub conservative: bool,
    pub lengths: Vec<f64>,
}

/// Line density, kg/m, of all bodies.
const DENSITY: f64 = 0.7;

impl Hand {
    /// The scene; absolute coordinates have no held components here.
    pub fn scene(mut self, formulation: Formulation) -> MeshScene {
        if formulation == Formulation::Ancf {
            let free: Vec<usize> = self.free.iter().map(|spec| spec.frame).collect();
            let stays = |joint: &JointSpec| joint.kind == JointKind::Pin || free.contains(&joint.frame);
            self.joints.retain(stays);
        }
        MeshScene::new(Box::new(self), formulation, Joints::Eliminated, &[]).expect("the scene makes sense")
    }

    /// Mass matrix of an element: Hermite's, with a section as integrals of all interpolants.
    fn masses(&self, body: usize) -> Vec<f64> {
        if self.bodies[body].has_section() {
            return sections::masses(self, body, DENSITY * self.lengths[body]);
        }
        let l = self.lengths[body];
        let rows = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        rows.concat().iter().map(|entry| DENSITY * l / 420.0 * entry).collect()
    }

    /// Conditions of a joint on its node, in the plane of the first two axes or in space.
    fn conditions(&self, joint: usize, data: &JointData, q: &[f64]) -> Vec<f64> {
        let spec = &self.bodies[self.joints[joint].body];
        let d = spec.dimension();
        let [point, tangent, second] = [data.point, data.tangent, data.second].map(Vector::from);
        let targets = [point, tangent, second];
        let count = if spec.has_section() { d } else { 2 };
        let vector = |place: usize| -> Vector { Vector::from_fn(|i, _| if i < d { q[place * d + i] } else { 0.0 }) };
        let whole = |place: usize| -> Vec<f64> { (vector(place) - targets[place]).as_slice()[..d].to_vec() };
        let across = |_: usize| -> Vec<f64> {
            let normals = &data.normals[..d - 1];
            normals
                .iter()
                .map(|&normal| Vector::from(normal).dot(&vector(1)))
                .collect()
        };
        let directions = |rows: &dyn Fn(usize) -> Vec<f64>| [whole(0), (1..count).flat_map(rows).collect()].concat();
        match self.joints[joint].kind {
            JointKind::ClampFull => directions(&whole),
            JointKind::Clamp if count > 2 => {
                let normal = tangent.cross(&second);
                let twist = 0.5 * (second.dot(&vector(1)) - tangent.dot(&vector(2)));
                [whole(0), vec![normal.dot(&vector(1)), normal.dot(&vector(2)), twist]].concat()
            }
            JointKind::Clamp => directions(&across),
            _ => whole(0),
        }
    }

    /// Stiffnesses and forms of the strains: `I = sum S_ab q_a . q_b - I0`, strain energy k I^2 / 2.
    fn strains(&self, body: usize) -> Vec<(f64, Vec<Vec<f64>>, f64)> {
        let l = self.lengths[body];
        if self.bodies[body].has_section() {
            return sections::strains(self.bodies[body].nodal, l);
        }
        let stretch = |a: usize, b: usize| -> Vec<Vec<f64>> {
            let sign = |i: usize| {
                if i == a {
                    -1.0
                } else if i == b {
                    1.0
                } else {
                    0.0
                }
            };
            table(4, &|i, j| sign(i) * sign(j))
        };
        let bend = |i: usize, j: usize| if (i, j) == (1, 3) || (i, j) == (3, 1) { 0.5 } else { 0.0 };
        let norm = |i: usize, j: usize| if i == j && i % 2 == 1 { 1.0 } else { 0.0 };
        let of = |f: &dyn Fn(usize, usize) -> f64| table(4, f);
        vec![
            (3.0, stretch(0, 2), l * l),
            (2.0, of(&bend), 1.0),
            (1.5, of(&norm), 2.0),
        ]
    }

    /// Strain and its derivatives with respect to all components.
    fn strain(&self, q: &[f64], form: &[Vec<f64>], zero: f64) -> (f64, Vec<f64>) {
        let d = q.len() / form.len();
        let gradient: Vec<f64> = (0..q.len())
            .map(|i| (0..form.len()).map(|b| 2.0 * form[i / d][b] * q[b * d + i % d]).sum())
            .collect();
        let value: f64 = gradient.iter().zip(q).map(|(g, q)| 0.5 * g * q).sum();
        (value - zero, gradient)
    }
}

/// Hermite's shape functions of an element of length l and their derivatives d/dx.
pub fn hermite(l: f64, order: usize, xi: f64) -> [f64; 4] {
    let (x2, x3) = (xi * xi, xi * xi * xi);
    let rows = [
        [
            1.0 - 3.0 * x2 + 2.0 * x3,
            l * (xi - 2.0 * x2 + x3),
            3.0 * x2 - 2.0 * x3,
            l * (x3 - x2),
        ],
        [
            6.0 * (x2 - xi) / l,
            1.0 - 4.0 * xi + 3.0 * x2,
            6.0 * (xi - x2) / l,
            3.0 * x2 - 2.0 * xi,
        ],
        [
            (12.0 * xi - 6.0) / (l * l),
            (6.0 * xi - 4.0) / l,
            (6.0 - 12.0 * xi) / (l * l),
            (6.0 * xi - 2.0) / l,
        ],
    ];
    rows[order]
}

/// Entries of a square matrix.
pub fn table(size: usize, entry: &dyn Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
}

/// Derivatives of `sin(2 t)`.
pub fn sine(t: f64, order: usize) -> f64 {
    let (s, c) = (2.0 * t).sin_cos();
    [s, 2.0 * c, -4.0 * s, -8.0 * c][order]
}

impl Parts for Hand {
    fn observed(&self) -> Vec<ObservedSpec> {
        self.observed.clone()
    }
    fn output_columns(&self) -> usize {
        self.observed.len()
    }
    fn frame_count(&self) -> usize {
        self.frames.len()
    }
    fn frame_name(&self, frame: usize) -> &'static str {
        self.frames[frame]
    }
    fn conservative(&self) -> bool {
        self.conservative
    }
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    fn gaps(&self, _t: f64, _out: &mut Vec<[f64; 2]>) {}

    fn courses(&self) -> Vec<crate::course::Courses> {
        Vec::new()
    }
    /// Frame 1 shifts along a curve; frame 2 turns about a fixed axis and shifts.
    fn frames(&self, t: f64, motions: &mut [FrameMotion]) {
        motions.fill(FrameMotion::INERTIAL);
        if self.moving {
            let along = Vector::new(0.3, -0.2, 0.5);
            for motion in &mut motions[1..3] {
                motion.position = along.map(|a| a * sine(t, 0));
                motion.velocity = along.map(|a| a * sine(t, 1));
                motion.acceleration = along.map(|a| a * sine(t, 2));
                motion.jerk = along.map(|a| a * sine(t, 3));
            }
            let axis = Vector::new(0.0, 0.6, 0.8);
            let turning = &mut motions[2];
            turning.rotation = matrix(&exp(sine(t, 0) * axis));
            turning.spin = sine(t, 1) * axis;
            turning.spin_rate = sine(t, 2) * axis;
            turning.spin_jerk = sine(t, 3) * axis;
        }
    }
    fn conserving_obstacle(&self) -> Option<&'static str> {
        Some("its equations have no such forces")
    }
    fn outputs(&self, _t: f64, observed: &[f64], out: &mut [f64]) {
        out.copy_from_slice(observed);
    }
    fn check(&self) -> Result<(), ModelError> {
        Ok(())
    }
    fn free(&self) -> Vec<FreeSpec> {
        self.free.clone()
    }
    fn markers(&self) -> Vec<MarkerSpec> {
        self.markers.clone()
    }
}

impl Bodies for Hand {
    fn bodies(&self) -> Vec<BodySpec> {
        self.bodies.clone()
    }
    fn prepare(&mut self, body: usize, nodes: &[f64], _shape: &[f64]) -> Result<(), ModelError> {
        self.lengths.resize(self.bodies.len(), 0.0);
        self.lengths[body] = nodes[1] - nodes[0];
        Ok(())
    }
    fn initial(&self, _body: usize, _x: f64) -> [Option<[[f64; 3]; 2]>; 2] {
        [None, None]
    }
    fn shares(&self) -> Vec<ShareSpec> {
        self.shares.clone()
    }
    fn starts(&self) -> Vec<StartSpec> {
        Vec::new()
    }
    fn fixtures(&self) -> Vec<FixtureSpec> {
        self.fixtures.clone()
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
    fn mass(&self, body: usize, _element: usize, mass: &mut [f64]) {
        mass.copy_from_slice(&self.masses(body));
    }
    fn elastic_force(&self, body: usize, _element: usize, q: &[f64], _v: &[f64], force: &mut [f64]) {
        for (k, form, zero) in self.strains(body) {
            let (strain, gradient) = self.strain(q, &form, zero);
            for (force, gradient) in force.iter_mut().zip(gradient) {
                *force += k * strain * gradient;
            }
        }
    }
    fn elastic_tangent(
        &self,
        body: usize,
        _element: usize,
        q: &[f64],
        _v: &[f64],
        stiffness: &mut [f64],
        _damping: &mut [f64],
    ) {
        let (size, d) = (q.len(), self.bodies[body].dimension());
        for (k, form, zero) in self.strains(body) {
            let (strain, gradient) = self.strain(q, &form, zero);
            for i in 0..size {
                for j in 0..size {
                    let second = if i % d == j % d { 2.0 * form[i / d][j / d] } else { 0.0 };
                    stiffness[i * size + j] += k * (gradient[i] * gradient[j] + strain * second);
                }
            }
        }
    }
    fn elastic_force4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[[f64; LANES]],
        v: &[[f64; LANES]],
        force: &mut [[f64; LANES]],
    ) {
        elastic_force_one_by_one(self, elements, q, v, force);
    }
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
    fn energy(&self, body: usize, _element: usize, q: &[f64]) -> f64 {
        let strains = self.strains(body).into_iter();
        strains
            .map(|(k, form, zero)| 0.5 * k * self.strain(q, &form, zero).0.powi(2))
            .sum()
    }
    fn shapes(&self, body: usize, _element: usize, of: Interpolant, order: usize, xi: f64, weights: &mut [f64]) {
        if self.bodies[body].has_section() {
            return sections::shapes(self.bodies[body].nodal, self.lengths[body], of, order, xi, weights);
        }
        weights.copy_from_slice(&hermite(self.lengths[body], order, xi));
    }
    fn section(&self, _body: usize, _x: f64, _length: f64) -> SectionSpec {
        SectionSpec {
            shape: SectionShape::Circle { radius: 0.1 },
            area: 0.03,
            second_moments: [7e-5, 7e-5],
            torsion_constant: 1.4e-4,
            young_over_shear: 2.6,
            softness_of_curves: 0.0,
            yield_stress: None,
            material: "rubber",
        }
    }
    fn fields(&self, _body: usize) -> &'static [(Interpolant, usize)] {
        &[(Interpolant::Position, 1), (Interpolant::Position, 2)]
    }
    fn field_forces(
        &self,
        _body: usize,
        _at: [f64; 2],
        _free: &[f64],
        fields: &[f64],
        _rates: &[f64],
        forces: &mut [f64],
    ) {
        let (slope, bend) = fields.split_at(fields.len() / 2);
        let strain = slope.iter().map(|a| a * a).sum::<f64>() - 1.0;
        let all = slope
            .iter()
            .map(|a| 6.0 * strain * a)
            .chain(bend.iter().map(|b| 2.0 * b));
        forces.iter_mut().zip(all).for_each(|(force, value)| *force = value);
    }
}

impl WithoutConservingForces for Hand {}
impl crate::emitted::WithoutTimedEnergies for Hand {}
impl crate::emitted::WithoutDistributedLoads for Hand {}
impl crate::emitted::WithoutPlacedGravity for Hand {}

impl JointConditions for Hand {
    fn joints(&self) -> Vec<JointSpec> {
        self.joints.clone()
    }
    fn condition(
        &self,
        joint: usize,
        _absolute: bool,
        level: ConstraintLevel,
        _t: f64,
        data: &JointData,
        q: &[f64],
        _v: &[f64],
        _a: &[f64],
        rows: &mut [f64],
    ) {
        // Those of joints to the own frame do not depend on time.
        if level == ConstraintLevel::Position {
            rows.copy_from_slice(&self.conditions(joint, data, q));
        }
    }
    fn condition_jacobian(&self, joint: usize, _absolute: bool, _t: f64, data: &JointData, jacobian: &mut [f64]) {
        let dimension = self.bodies[self.joints[joint].body].dimension();
        let width = jacobian.len() / self.conditions(joint, data, &[0.0; 9]).len();
        assert_eq!(width % dimension, 0);
        for column in 0..width {
            let at = |value: f64| {
                self.conditions(
                    joint,
                    data,
                    &std::array::from_fn::<f64, 9, _>(|i| if i == column { value } else { 0.0 }),
                )
            };
            for (row, (high, low)) in at(1.0).iter().zip(at(0.0)).enumerate() {
                jacobian[row * width + column] = high - low;
            }
        }
    }
    /// Points of spatial bodies, perhaps of the inertial frame in frame 2: there they move.
    fn prescribed(&self, joint: usize, absolute: bool, t: f64, data: &JointData, prescribed: &mut Prescribed) {
        let joint = &self.joints[joint];
        prescribed.position[0] = data.point;
        prescribed.slope[0] = data.tangent;
        prescribed.second[0] = data.second;
        let own = self.bodies[joint.body].frame;
        if joint.frame == 0 && own == 2 && !absolute {
            let mut motions = vec![FrameMotion::INERTIAL; self.frames.len()];
            self.frames(t, &mut motions);
            let hub = &motions[2];
            // p = A^T (x - r): p' = -A^T r' - w x p, and so on.
            let back = |u: Vector| -hub.rotation.tr_mul(&u);
            let w = [hub.spin, hub.spin_rate, hub.spin_jerk];
            let p = hub.point_to_frame(data.point.into());
            let u = |r: Vector| back(r);
            let p1 = u(hub.velocity) - w[0].cross(&p);
            let turned = |r: Vector, next: Vector| u(next) - w[0].cross(&u(r));
            let p2 = turned(hub.velocity, hub.acceleration) - (w[1].cross(&p) + w[0].cross(&p1));
            // Second derivative of A^T r' with its sign.
            let second = u(hub.jerk) - 2.0 * w[0].cross(&u(hub.acceleration))
                + (w[0].cross(&w[0].cross(&u(hub.velocity))) - w[1].cross(&u(hub.velocity)));
            let swing = w[2].cross(&p) + (2.0 * w[1].cross(&p1) + w[0].cross(&p2));
            prescribed.position = [p.into(), p1.into(), p2.into(), (second - swing).into()];
        }
        if self.bodies[joint.body].dimension() == 2 {
            assert_eq!(self.bodies[joint.body].axes, [0, 1]);
        }
    }
}
