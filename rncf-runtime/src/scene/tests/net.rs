//! Many cables in one free frame, and how long a residual and a matrix of theirs take.

use super::model::hermite;
use super::random::Random;
use super::scenery::{body, free, joint, stone};
use crate::emitted::{
    Bodies, BodySpec, FixtureSpec, FrameMotion, FreeSpec, Interpolant, JointConditions, JointData, JointKind,
    JointSpec, LANES, LoadSpec, Loads, MarkerSpec, Motions, ObservedSpec, Parts, Prescribed, SectionShape, SectionSpec,
    ShareSpec, SlopeMoments, StartSpec, Table, WithoutConservingForces, WithoutDensities, WithoutGravityFields,
    WithoutMarkerConstraints, WithoutMarkerForces, WithoutSectionMoments,
};
use crate::error::ModelError;
use crate::model::{Formulation, Joints, Scene};
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::Transport;
use crate::scene::pieces::batches::Blocks;
use crate::scene::pieces::combination::Combination;
use crate::space::Vector;
use crate::system::{ConstraintLevel, System};

/// Line density, kg/m.
const DENSITY: f64 = 0.3;
/// Axial stiffness, N.
const STIFFNESS: f64 = 20.0;
/// Gauss points on [0, 1], and weights.
const POINTS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// Spokes of several elements clamped in a free frame, and as many loose ones of one element.
pub struct Net {
    bodies: Vec<BodySpec>,
    joints: Vec<JointSpec>,
    lengths: Vec<f64>,
    /// Whether the cables resist.
    pub elastic: bool,
}

type Lanes = [f64; LANES];

fn each(f: impl Fn(usize) -> f64) -> Lanes {
    std::array::from_fn(f)
}

impl Net {
    pub fn new(spokes: usize, elements: usize) -> Self {
        let mut bodies = Vec::new();
        for (kind, count) in [(0, elements), (1, 1)] {
            for instance in 0..spokes {
                let angle = std::f64::consts::TAU * instance as f64 / spokes as f64;
                let to = [10.0 * angle.cos(), 10.0 * angle.sin(), 0.0];
                bodies.push(BodySpec {
                    kind,
                    instance: Some(instance),
                    count,
                    ..body("spoke", 1, &[0, 1, 2], to.into())
                });
            }
        }
        let clamped = |spoke: usize| joint("hub", JointKind::ClampFull, spoke, false, 1);
        Self {
            joints: (0..spokes).map(clamped).collect(),
            lengths: vec![0.0; bodies.len()],
            bodies,
            elastic: true,
        }
    }

    pub fn scene(self) -> MeshScene {
        MeshScene::new(Box::new(self), Formulation::Rncf, Joints::Eliminated, &[]).expect("the net makes sense")
    }

    /// Slopes and their weights at the points: `f(weights, slope, strain, weight)` of U = EA/8 (s.s - 1)^2.
    fn points(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[Lanes],
        mut f: impl FnMut(&[Lanes; 4], &[Lanes; 3], Lanes, Lanes),
    ) {
        let lengths = elements.map(|(body, _)| self.lengths[body]);
        for (xi, weight) in POINTS {
            let lanes = lengths.map(|length| hermite(length, 1, xi));
            let shapes: [Lanes; 4] = std::array::from_fn(|a| each(|lane| lanes[lane][a]));
            let slope: [Lanes; 3] = std::array::from_fn(|i| {
                let mut sum = [0.0; LANES];
                for (a, shape) in shapes.iter().enumerate() {
                    sum = each(|lane| sum[lane] + shape[lane] * q[3 * a + i][lane]);
                }
                sum
            });
            let strain = each(|lane| slope.iter().map(|s| s[lane] * s[lane]).sum::<f64>() - 1.0);
            f(
                &shapes,
                &slope,
                strain,
                each(|lane| 0.5 * weight * STIFFNESS * lengths[lane]),
            );
        }
    }
}

impl Parts for Net {
    fn observed(&self) -> Vec<ObservedSpec> {
        Vec::new()
    }
    fn output_columns(&self) -> usize {
        0
    }
    fn frame_count(&self) -> usize {
        2
    }
    fn frame_name(&self, _frame: usize) -> &'static str {
        "sail"
    }
    fn conservative(&self) -> bool {
        true
    }
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    fn gaps(&self, _t: f64, _out: &mut Vec<[f64; 2]>) {}

    fn courses(&self) -> Vec<crate::course::Courses> {
        Vec::new()
    }
    fn frames(&self, _t: f64, motions: &mut [FrameMotion]) {
        motions.fill(FrameMotion::INERTIAL);
    }
    fn conserving_obstacle(&self) -> Option<&'static str> {
        Some("its equations have no such forces")
    }
    fn outputs(&self, _t: f64, _observed: &[f64], _out: &mut [f64]) {}
    fn check(&self) -> Result<(), ModelError> {
        Ok(())
    }
    fn free(&self) -> Vec<FreeSpec> {
        vec![FreeSpec {
            size: 1.0,
            rigid: stone(),
            spin: Vector::new(0.1, 0.2, 0.9),
            ..free(1, 0, Motions::Spatial)
        }]
    }
    fn markers(&self) -> Vec<MarkerSpec> {
        Vec::new()
    }
}

impl Bodies for Net {
    fn bodies(&self) -> Vec<BodySpec> {
        self.bodies.clone()
    }
    fn prepare(&mut self, body: usize, nodes: &[f64], _shape: &[f64]) -> Result<(), ModelError> {
        self.lengths[body] = nodes[1] - nodes[0];
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
        Vec::new()
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
        let l = self.lengths[body];
        let rows = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        for (mass, entry) in mass.iter_mut().zip(rows.as_flattened()) {
            *mass = DENSITY * l / 420.0 * entry;
        }
    }
    fn elastic_force(&self, _body: usize, _element: usize, _q: &[f64], _v: &[f64], _force: &mut [f64]) {
        unreachable!("there are four elements at least");
    }
    fn elastic_tangent(
        &self,
        _body: usize,
        _element: usize,
        _q: &[f64],
        _v: &[f64],
        _stiffness: &mut [f64],
        _damping: &mut [f64],
    ) {
        unreachable!("there are four elements at least");
    }
    fn elastic_force4(&self, elements: &[(usize, usize); LANES], q: &[Lanes], _v: &[Lanes], force: &mut [Lanes]) {
        if !self.elastic {
            return;
        }
        self.points(elements, q, |shapes, slope, strain, weight| {
            for (place, force) in force.iter_mut().enumerate() {
                let (shape, slope) = (&shapes[place / 3], &slope[place % 3]);
                *force = each(|lane| force[lane] + weight[lane] * strain[lane] * slope[lane] * shape[lane]);
            }
        });
    }
    fn elastic_tangent4(
        &self,
        elements: &[(usize, usize); LANES],
        q: &[Lanes],
        _v: &[Lanes],
        stiffness: &mut [Lanes],
        _damping: &mut [Lanes],
    ) {
        if !self.elastic {
            return;
        }
        self.points(elements, q, |shapes, slope, strain, weight| {
            for (place, entry) in stiffness.iter_mut().enumerate() {
                let (row, column) = (place / 12, place % 12);
                let (i, j) = (row % 3, column % 3);
                let unit = if i == j { 1.0 } else { 0.0 };
                let (one, other) = (&shapes[row / 3], &shapes[column / 3]);
                *entry = each(|lane| {
                    let block = unit * strain[lane] + 2.0 * slope[i][lane] * slope[j][lane];
                    entry[lane] + weight[lane] * one[lane] * other[lane] * block
                });
            }
        });
    }
    fn energy(&self, _body: usize, _element: usize, _q: &[f64]) -> f64 {
        0.0
    }
    fn shapes(&self, body: usize, _element: usize, _of: Interpolant, order: usize, xi: f64, weights: &mut [f64]) {
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
        &[(Interpolant::Position, 1)]
    }
    fn field_forces(
        &self,
        _body: usize,
        _at: [f64; 2],
        _free: &[f64],
        _fields: &[f64],
        _rates: &[f64],
        forces: &mut [f64],
    ) {
        forces.fill(0.0);
    }
}

impl WithoutConservingForces for Net {}
impl crate::emitted::WithoutTimedEnergies for Net {}
impl crate::emitted::WithoutDistributedLoads for Net {}
impl crate::emitted::WithoutPlacedGravity for Net {}

impl JointConditions for Net {
    fn joints(&self) -> Vec<JointSpec> {
        self.joints.clone()
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
        prescribed.slope[0] = data.tangent;
    }
}

impl Loads for Net {
    fn loads(&self) -> Vec<LoadSpec> {
        Vec::new()
    }
    fn load_varies(&self, _load: usize) -> bool {
        false
    }
    fn load(&self, _load: usize, _t: f64) -> [f64; 3] {
        [0.0; 3]
    }
}

impl SlopeMoments for Net {
    fn moment(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _force: &mut [f64]) {}
    fn moment_tangent(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _tangent: &mut [f64]) {}
}

impl WithoutSectionMoments for Net {}

impl WithoutMarkerConstraints for Net {}

impl WithoutMarkerForces for Net {}

impl WithoutDensities for Net {}

impl WithoutGravityFields for Net {}

/// Microseconds of a call, the least of many.
fn microseconds(mut call: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..400 {
        let start = std::time::Instant::now();
        call();
        least = least.min(start.elapsed().as_secs_f64());
    }
    1e6 * least
}

#[test]
#[ignore = "a measurement"]
fn time_of_many_cables() {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads start");
        pool.install(|| {
            for elastic in [false, true] {
                let mut scene = Net {
                    elastic,
                    ..Net::new(100, 16)
                }
                .scene();
                let mut state = scene.rest(0.0);
                Random(1).shake(&scene, &mut state, 0.01);
                let mut force = vec![0.0; scene.unknowns()];
                let residual = microseconds(|| scene.residual(&state, &mut force));
                let mut values = vec![0.0; scene.pattern().entries()];
                let matrix = microseconds(|| scene.iteration_matrix(&state, [0.9, 1e-2, 1e-4], &mut values));
                let load = microseconds(|| scene.load_state(&state));
                let inertia = microseconds(|| scene.add_inertia_forces(Vector::zeros()));
                let borders = microseconds(|| {
                    scene.add_inertia_borders(Vector::zeros(), &Combination::only(0), &mut values);
                });
                let blocks = |_: &Transport| Blocks::default();
                let elements = microseconds(|| scene.each_element_tangent(blocks, |_, _, _, _, _| {}));
                println!(
                    "{threads} threads, elastic {elastic}: {} unknowns, {} entries; residual {residual:.0} us (state {load:.0}, inertia {inertia:.0}), matrix {matrix:.0} us (borders {borders:.0}, elements {elements:.0})",
                    scene.unknowns(),
                    values.len(),
                );
            }
        });
    }
}
