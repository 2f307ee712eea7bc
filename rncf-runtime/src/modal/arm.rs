//! A model for tests of modal scenes.

use super::tests::cable::{Cable, element_mass};
use crate::ModelError;
use crate::emitted::*;
use crate::model::{Formulation, Joints};
use crate::scene::MeshScene;
use crate::scene::bodies::described::Elements;
use crate::scene::tests::scenery::{NODAL, along_slope};
use crate::space::{Vector, exp, matrix, rows, three};
use crate::system::ConstraintLevel;

/// A heavy cable arm clamped in frame 1, which is free or turns uniformly; a unit at its tip, a spring
/// from its middle to the ground, a moment on its tip, and the tip at a constant distance from the ground.
#[derive(Clone)]
pub struct Arm {
    pub cable: Cable,
    pub fidelity: Fidelity,
    pub free: bool,
    pub spin: f64,
    pub linked: bool,
}

/// Number of elements.
pub const COUNT: usize = 3;
/// Constants of the unit at the tip.
const TIP: [f64; 3] = [0.5, 0.02, 0.01];
/// Mass of the hub, kg.
const HUB: f64 = 3.0;

impl Arm {
    pub fn new(dimension: usize, fidelity: Fidelity, free: bool) -> Self {
        let cable = Cable {
            dimension,
            length: 1.0 / COUNT as f64,
            axial: 1e3,
            bending: 1.0,
            damping: 1e-3,
        };
        let (spin, linked) = (2.0, true);
        Self {
            cable,
            fidelity,
            free,
            spin,
            linked,
        }
    }

    fn d(&self) -> usize {
        self.cable.dimension
    }

    pub fn scene(&self) -> MeshScene {
        MeshScene::new(Box::new(self.clone()), Formulation::Rncf, Joints::Eliminated, &[]).unwrap()
    }
}

impl Parts for Arm {
    fn observed(&self) -> Vec<ObservedSpec> {
        let reaction = |moment, component| ObservedSpec::Reaction {
            joint: 0,
            moment,
            component,
        };
        let tip = |component| ObservedSpec::Point {
            body: 0,
            at: Place::End,
            what: PointQuantity::Position,
            component,
        };
        vec![
            tip(0),
            tip(1),
            reaction(false, 0),
            reaction(false, 1),
            reaction(true, 2),
        ]
    }
    fn output_columns(&self) -> usize {
        5
    }
    fn frame_count(&self) -> usize {
        2
    }
    fn frame_name(&self, frame: usize) -> &'static str {
        ["ground", "hub"][frame]
    }
    fn conservative(&self) -> bool {
        false
    }
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    fn gaps(&self, _t: f64, _out: &mut Vec<[f64; 2]>) {}

    fn courses(&self) -> Vec<Courses> {
        Vec::new()
    }
    fn frames(&self, t: f64, motions: &mut [FrameMotion]) {
        motions[0] = FrameMotion::INERTIAL;
        motions[1] = FrameMotion {
            rotation: matrix(&exp(Vector::new(0.0, 0.0, self.spin * t))),
            spin: Vector::new(0.0, 0.0, self.spin),
            ..FrameMotion::INERTIAL
        };
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
        let motions = if self.d() == 2 {
            Motions::Planar { normal: 2 }
        } else {
            Motions::Spatial
        };
        let free = FreeSpec {
            size: 1.0,
            frame: 1,
            parent: 0,
            is_body: false,
            motions,
            position: Vector::zeros(),
            axis: Vector::z(),
            angle: 0.3,
            velocity: Vector::zeros(),
            spin: Vector::new(0.0, 0.0, self.spin),
            rigid: RigidSpec {
                mass: HUB,
                moment: Vector::zeros(),
                inertia: Matrix::from_fn(|i, j| if i == j { 0.02 * HUB } else { 0.0 }),
            },
        };
        if self.free { vec![free] } else { Vec::new() }
    }
    fn markers(&self) -> Vec<MarkerSpec> {
        let on_body = |at| MarkerSpec::BodyPoint { body: 0, at };
        let ground = MarkerSpec::Point {
            frame: 0,
            at: [0.1, 0.4, 0.0],
        };
        vec![on_body(Place::At(0.55)), on_body(Place::End), ground]
    }
}

impl Bodies for Arm {
    fn bodies(&self) -> Vec<BodySpec> {
        let axes: &'static [usize] = if self.d() == 2 { &[0, 1] } else { &[0, 1, 2] };
        vec![BodySpec {
            name: "arm",
            kind: 0,
            instance: None,
            frame: 1,
            axes,
            line: Line::Straight {
                from: [0.2, 0.0, 0.0],
                to: [1.2, 0.0, 0.0],
            },
            count: COUNT,
            nodal: &NODAL,
            connectivity: &[0, 1, 2, 3],
            vectors_per_node: 2,
            stride: 2,
            section_y: None,
            twist: Twist::even(0.0),
            stations: Vec::new(),
            fidelity: self.fidelity,
            damps: true,
            tie: FrameTie::Joints,
            normals: Vec::new(),
        }]
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
    fn fixtures(&self) -> Vec<FixtureSpec> {
        let unit = FixtureSpec {
            name: "unit",
            body: 0,
            at: Place::End,
            constants: along_slope(TIP[0], TIP[1], TIP[2]),
            elastic: false,
        };
        if self.linked { vec![unit] } else { Vec::new() }
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
    fn mass(&self, _body: usize, _element: usize, mass: &mut [f64]) {
        mass.copy_from_slice(&element_mass(self.cable.length).concat());
    }
    fn elastic_force(&self, _body: usize, element: usize, q: &[f64], v: &[f64], force: &mut [f64]) {
        self.cable.force(element, q, v, force);
    }
    fn elastic_tangent(
        &self,
        _body: usize,
        element: usize,
        q: &[f64],
        v: &[f64],
        stiffness: &mut [f64],
        damping: &mut [f64],
    ) {
        self.cable.tangent(element, q, v, stiffness, damping);
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
    fn energy(&self, _body: usize, _element: usize, _q: &[f64]) -> f64 {
        0.0
    }
    fn shapes(&self, _body: usize, _element: usize, _of: Interpolant, order: usize, xi: f64, weights: &mut [f64]) {
        let l = self.cable.length;
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
        weights.copy_from_slice(&rows[order]);
    }
    fn section(&self, _body: usize, _x: f64, _length: f64) -> SectionSpec {
        SectionSpec {
            shape: SectionShape::Circle { radius: 0.05 },
            area: 8e-3,
            second_moments: [5e-6, 5e-6],
            torsion_constant: 1e-5,
            young_over_shear: 0.0,
            softness_of_curves: 0.0,
            yield_stress: None,
            material: "steel",
        }
    }
    fn fields(&self, _body: usize) -> &'static [(Interpolant, usize)] {
        &[(Interpolant::Position, 1), (Interpolant::Position, 2)]
    }
    /// Of the strain energies EA (r_x . r_x - 1)^2 / 8 and EI r_xx . r_xx / 2 per unit length.
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
        let strain = 0.5 * (slope.iter().map(|a| a * a).sum::<f64>() - 1.0);
        let stretch = slope.iter().map(|a| self.cable.axial * strain * a);
        let all = stretch.chain(bend.iter().map(|b| self.cable.bending * b));
        forces.iter_mut().zip(all).for_each(|(force, value)| *force = value);
    }
}

impl WithoutConservingForces for Arm {}
impl WithoutTimedEnergies for Arm {}
impl WithoutDistributedLoads for Arm {}
impl WithoutPlacedGravity for Arm {}

impl JointConditions for Arm {
    fn joints(&self) -> Vec<JointSpec> {
        vec![JointSpec {
            name: "root",
            kind: JointKind::Clamp,
            body: 0,
            at_end: false,
            frame: 1,
            point: None,
        }]
    }
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
    fn condition_jacobian(&self, _joint: usize, _absolute: bool, _t: f64, _data: &JointData, _jacobian: &mut [f64]) {}
    fn prescribed(&self, _joint: usize, _absolute: bool, _t: f64, data: &JointData, prescribed: &mut Prescribed) {
        prescribed.position[0] = data.point;
    }
}

impl Loads for Arm {
    fn loads(&self) -> Vec<LoadSpec> {
        let load = |name, kind| LoadSpec { name, kind, frame: 0 };
        let moment = LoadKind::Moment {
            body: 0,
            at: Place::End,
        };
        vec![load("weight", LoadKind::Gravity), load("twist", moment)]
    }
    fn load_varies(&self, _load: usize) -> bool {
        false
    }
    fn load(&self, load: usize, _t: f64) -> [f64; 3] {
        let plane = if self.d() == 2 { 0.0 } else { 1.0 };
        [[0.3, -9.81, 0.7 * plane], [0.2 * plane, 0.1 * plane, 0.5]][load]
    }
}

impl SlopeMoments for Arm {
    fn moment(&self, dimension: usize, slope: &[f64], moment: [f64; 3], force: &mut [f64]) {
        // m x s / |s|^2, here at |s| = 1.
        if dimension == 2 {
            force[0] -= moment[0] * slope[1];
            force[1] += moment[0] * slope[0];
        } else {
            let cross = Vector::from(moment).cross(&three(slope, 0));
            force.iter_mut().zip(&cross).for_each(|(sum, value)| *sum += value);
        }
    }
    fn moment_tangent(&self, dimension: usize, _slope: &[f64], moment: [f64; 3], tangent: &mut [f64]) {
        if dimension == 2 {
            tangent[1] -= moment[0];
            tangent[2] += moment[0];
        } else {
            let skew = rows(&Vector::from(moment).cross_matrix());
            tangent
                .iter_mut()
                .zip(skew.concat())
                .for_each(|(sum, value)| *sum += value);
        }
    }
}

impl WithoutSectionMoments for Arm {}

impl MarkerConstraints for Arm {
    fn constraints(&self) -> Vec<ConstraintSpec> {
        let rod = ConstraintSpec {
            name: "rod",
            kind: "constraint",
            rows: &["distance"],
            markers: &[1, 2],
            coupled: &[[0, 1]],
            of_differences: true,
            first_party: 1,
            branches: 0,
            when: When::Always,
        };
        if self.linked { vec![rod] } else { Vec::new() }
    }
    fn marker_constraint(
        &self,
        _constraint: usize,
        _level: ConstraintLevel,
        _t: f64,
        z: &[[Vector; 4]],
        rows: &mut [f64],
    ) {
        let gap = z[0][0] - z[1][0];
        rows[0] = 0.5 * gap.dot(&gap) - 0.4;
    }
    fn marker_constraint_gradient(&self, _constraint: usize, _t: f64, z: &[Vector], gradient: &mut [f64]) {
        let gap = z[0] - z[1];
        gradient.copy_from_slice([gap, -gap].map(<[f64; 3]>::from).as_flattened());
    }
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
    fn marker_constraint_hessian(
        &self,
        _constraint: usize,
        _t: f64,
        _z: &[Vector],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        (0..36).for_each(|entry| hessian[entry] = lambda[0] * spring_entry(entry));
    }
    fn marker_constraint_branches(&self, _constraint: usize, _t: f64, _z: &[Vector], _out: &mut [f64]) {}
}

impl MarkerForces for Arm {
    fn forces(&self) -> Vec<ForceSpec> {
        let spring = ForceSpec {
            name: "spring",
            markers: &[0, 2],
            conservative: false,
            of_differences: true,
            branches: 0,
        };
        if self.linked { vec![spring] } else { Vec::new() }
    }
    fn is_load(&self, _force: usize) -> bool {
        false
    }
    fn marker_force(&self, _force: usize, _t: f64, z: &[Vector], _velocity: &[Vector], out: &mut [f64]) {
        let gap = z[1] - z[0];
        out.copy_from_slice([40.0 * gap, -40.0 * gap].map(<[f64; 3]>::from).as_flattened());
    }
    fn marker_force_tangent(
        &self,
        _force: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        by_value: &mut [f64],
        _by_velocity: &mut [f64],
    ) {
        (0..36).for_each(|entry| by_value[entry] = -40.0 * spring_entry(entry));
    }
    fn marker_energy(&self, _force: usize, _t: f64, _z: &[Vector]) -> f64 {
        0.0
    }
    fn marker_force_branches(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    fn force_course(&self, _force: usize) -> Option<Courses> {
        None
    }
}

impl WithoutDensities for Arm {}

impl WithoutGravityFields for Arm {}

/// Entry of `[[1, -1], [-1, 1]]` of two points.
fn spring_entry(entry: usize) -> f64 {
    match (entry / 6, entry % 6) {
        (i, j) if i == j => 1.0,
        (i, j) if i % 3 == j % 3 => -1.0,
        _ => 0.0,
    }
}
