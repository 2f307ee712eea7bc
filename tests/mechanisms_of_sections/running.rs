//! Runs on grids of times, and what a run keeps.

use rncf::equilibrium::{Uniform, static_load};
use rncf::nalgebra::Vector3;
use rncf::prelude::*;
use rncf::system::{ConstraintLevel, State};

use rncf::model::Pose;

/// All four ways to write a model.
pub const WAYS: [(Formulation, Joints); 4] = [
    (Formulation::Rncf, Joints::Eliminated),
    (Formulation::Rncf, Joints::Multipliers),
    (Formulation::Ancf, Joints::Eliminated),
    (Formulation::Ancf, Joints::Multipliers),
];

/// States at `count` even steps from the start to `end`, the start included.
pub fn run(scene: &mut dyn Scene, end: f64, count: usize, rtol: f64) -> Vec<State> {
    let options = Options {
        rtol,
        ..Options::default()
    };
    let start = scene.rest(0.0);
    let times: Vec<f64> = (0..=count).map(|k| end * k as f64 / count as f64).collect();
    let mut states = Vec::new();
    let mut integrator = Integrator::new(scene, start, end, Method::Radau, options).unwrap();
    loop {
        let t = integrator.state().t;
        while let Some(&next) = times.get(states.len())
            && next <= t + 1e-10 * end
        {
            let mut state = integrator.state().clone();
            if next < t - 1e-10 * end {
                integrator.interpolate(next, &mut state);
            }
            states.push(state);
        }
        if states.len() == times.len() {
            return states;
        }
        integrator.step().unwrap();
    }
}

/// Outputs at the states, a row each.
pub fn rows(scene: &mut dyn Scene, states: &[State]) -> Vec<Vec<f64>> {
    let mut row = vec![0.0; scene.output_columns()];
    let read = |state| {
        scene.outputs(state, &mut row);
        row.clone()
    };
    states.iter().map(read).collect()
}

/// Largest difference of the columns `from..to`.
pub fn apart(a: &[Vec<f64>], b: &[Vec<f64>], columns: std::ops::Range<usize>) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a
        .iter()
        .zip(b)
        .flat_map(|(a, b)| columns.clone().map(|k| (a[k] - b[k]).abs()));
    pairs.fold(0.0, f64::max)
}

/// Largest violation of the constraints.
pub fn violation(scene: &mut dyn Scene, state: &State) -> f64 {
    let mut values = vec![0.0; scene.constraints()];
    scene.constraint(ConstraintLevel::Position, state, &mut values);
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Momentum and angular momentum about the inertial origin: products of `M v` with the velocities of rigid motions.
pub fn momenta(scene: &mut dyn Scene, state: &State) -> [f64; 6] {
    let pattern = scene.pattern().clone();
    let mut mass = vec![0.0; pattern.entries()];
    scene.mass(state, &mut mass);
    let mut impulse = vec![0.0; scene.unknowns()];
    pattern.multiply_add(1.0, &mass, &state.v, &mut impulse);
    let seen = scene.frame_state(state);
    std::array::from_fn(|k| {
        let unit = Vector3::ith(k % 3, 1.0);
        let mut rigid = seen.clone();
        rigid.v.fill(0.0);
        for pose in &mut rigid.poses {
            let at = pose.position;
            *pose = Pose {
                velocity: if k < 3 { unit } else { unit.cross(&at) },
                spin: if k < 3 {
                    Vector3::zeros()
                } else {
                    pose.rotation.inverse() * unit
                },
                ..*pose
            };
        }
        let direction = scene.state_of_frame(&rigid).v;
        direction.iter().zip(&impulse).map(|(a, b)| a * b).sum()
    })
}

pub fn build(model: &impl Model, way: (Formulation, Joints)) -> Box<dyn Scene> {
    model.build(way.0, way.1).unwrap()
}

/// Outputs at rest under the loads.
pub fn loaded(model: &impl Model) -> Vec<f64> {
    at_rest(model, WAYS[0])
}

/// Outputs at rest under the loads of a model that is written in the given way.
pub fn at_rest(model: &impl Model, way: (Formulation, Joints)) -> Vec<f64> {
    let mut scene = build(model, way);
    let found = static_load(scene.as_mut(), 0.0).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&Uniform::at_rest(0.0), found.state().unwrap(), &mut row);
    row
}
