//! What the comparisons share: scenes, runs to an end, outputs.

use rncf::equilibrium::Uniform;
use rncf::modes::{Mode, Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, Statistics, Stop, steady};

/// The scene in referenced coordinates.
pub fn referenced(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// State and counts at the end (s) of a run, or why it ended before.
pub fn run(
    scene: &mut dyn Scene,
    start: State,
    end: f64,
    method: Method,
    options: Options,
) -> Result<(State, Statistics), String> {
    let mut integrator = Integrator::new(scene, start, end, method, options).map_err(|error| error.to_string())?;
    while integrator.step().map_err(|error| error.to_string())? != Stop::End
        || integrator.state().t < end * (1.0 - 1e-12)
    {}
    Ok((integrator.state().clone(), integrator.statistics().clone()))
}

/// Outputs at a state.
pub fn outputs(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut row);
    row
}

/// The relative equilibrium at a time (s) and the lowest modes about it, ascending frequencies.
pub fn equilibrium(scene: &mut dyn Scene, t: f64, count: usize) -> (State, Vec<Mode>) {
    let state = steady(scene, t).unwrap().state().unwrap().clone();
    let found = modes(scene, &Uniform::steady(t), &state, Wanted { count }).unwrap();
    (state, found)
}
