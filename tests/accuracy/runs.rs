//! What every comparison needs: runs with their states at given times, tip histories, orders.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, Statistics, StepSize, Stop};

/// All four ways to write a model.
pub const WAYS: [(Formulation, Joints); 4] = [
    (Formulation::Rncf, Joints::Eliminated),
    (Formulation::Rncf, Joints::Multipliers),
    (Formulation::Ancf, Joints::Eliminated),
    (Formulation::Ancf, Joints::Multipliers),
];

/// Options with a fixed step, s; Newton's iteration goes on to round-off.
pub fn fixed(h: f64) -> Options {
    Options {
        rtol: 1e-12,
        step: StepSize::Fixed(h),
        ..Options::default()
    }
}

/// Options with adaptive steps.
pub fn adaptive(rtol: f64) -> Options {
    Options {
        rtol,
        ..Options::default()
    }
}

/// States at `times` (ascending, the last one is the end) from `start`; where a step ends there, its end, between
/// steps the dense output.
pub fn states_at(
    scene: &mut dyn Scene,
    start: State,
    method: Method,
    options: Options,
    times: &[f64],
) -> (Vec<State>, Statistics) {
    let end = *times.last().expect("a time to stop at");
    let mut states = Vec::with_capacity(times.len());
    let mut integrator = Integrator::new(scene, start, end, method, options).unwrap();
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-10 * end.abs();
    while states.len() < times.len() {
        let t = integrator.state().t;
        while let Some(&next) = times.get(states.len())
            && (next <= t || near(next, t))
        {
            let mut state = integrator.state().clone();
            if !near(next, t) {
                integrator.interpolate(next, &mut state);
            }
            states.push(state);
        }
        if integrator.step().unwrap() == Stop::End && near(t, end) {
            break;
        }
    }
    assert_eq!(states.len(), times.len());
    (states, integrator.statistics().clone())
}

/// Times `0, every, ..` up to `end`.
pub fn grid(every: f64, end: f64) -> Vec<f64> {
    let count = (end / every).round() as usize;
    (0..=count).map(|k| end * k as f64 / count as f64).collect()
}

/// Outputs of a model on an even grid from rest at t = 0, one row a time.
pub fn history(
    model: &impl Model,
    (formulation, joints): (Formulation, Joints),
    method: Method,
    options: Options,
    times: &[f64],
) -> (Vec<Vec<f64>>, Statistics) {
    let mut scene = model.build(formulation, joints).unwrap();
    let start = scene.rest(0.0);
    let (states, statistics) = states_at(scene.as_mut(), start, method, options, times);
    let mut row = vec![0.0; scene.output_columns()];
    let rows = states
        .iter()
        .map(|state| {
            scene.outputs(state, &mut row);
            row.clone()
        })
        .collect();
    (rows, statistics)
}

/// Largest absolute difference of two lists of equal length.
pub fn far(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Largest difference of two histories.
pub fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| far(a, b)).fold(0.0, f64::max)
}

/// Orders observed between successive halvings of the step.
pub fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

/// Numbers in two digits.
pub fn short(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    texts.join(" ")
}
