//! What every comparison needs: a model's scene, its outputs, its equilibria.

use rncf::equilibrium::{Kind, Uniform, follow};
use rncf::{Formulation, Joints, Model, Scene, State};

/// The scene in referenced coordinates with eliminated joints.
pub fn referenced(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// Outputs of an equilibrium.
pub fn outputs(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(at, state, &mut row);
    row
}

/// The equilibrium of a model in steps of at most `largest` of the load or spin, and its outputs.
pub fn equilibrium(model: &impl Model, kind: Kind, largest: f64) -> (Box<dyn Scene>, State, Vec<f64>) {
    let mut scene = referenced(model);
    let at = Uniform {
        kind,
        ..Uniform::steady(0.0)
    };
    let found = follow(scene.as_mut(), &at, largest, |_, _| ()).unwrap();
    println!("{} steps, {} iterations", found.path.len(), found.iterations());
    let state = found.state().unwrap().clone();
    let row = outputs(scene.as_mut(), &at, &state);
    (scene, state, row)
}

/// Outputs of the static equilibrium under the whole load.
pub fn at_rest(model: &impl Model, largest: f64) -> Vec<f64> {
    equilibrium(model, Kind::Static, largest).2
}

/// Distance of two points.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// Numbers in two digits.
pub fn short(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    texts.join(" ")
}
