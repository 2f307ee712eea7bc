//! The high-speed motor in time: it spins up to its relative equilibrium, in either formulation alike.

use rncf::equilibrium::{Uniform, steady};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Stop};
use rncf_models::Motor;

use crate::motor::RPM;
use crate::scenes::{outputs, referenced};

/// Times and mid-shaft deflections of a run, and its number of steps.
fn run(model: &Motor, formulation: Formulation, method: Method, rtol: f64, end: f64) -> (Vec<[f64; 3]>, usize) {
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let options = Options {
        rtol,
        max_step: 0.01,
        ..Options::default()
    };
    let mut states = Vec::new();
    let mut integrator = Integrator::new(scene.as_mut(), start, end, method, options).unwrap();
    loop {
        let stop = integrator.step().unwrap();
        states.push(integrator.state().clone());
        if stop == Stop::End {
            break;
        }
    }
    drop(integrator);
    let mut row = vec![0.0; scene.output_columns()];
    let mut found = Vec::new();
    for state in &states {
        scene.outputs(state, &mut row);
        found.push([state.t, row[0], row[1]]);
    }
    (found, states.len())
}

#[test]
fn spins_up_to_its_relative_equilibrium() {
    let model = Motor::default();
    let mut scene = referenced(&model);
    let found = steady(scene.as_mut(), 1.2).unwrap();
    let v = outputs(scene.as_mut(), &Uniform::steady(1.2), found.state().unwrap())[0];
    let (rows, steps) = run(&model, Formulation::Rncf, Method::Hht { alpha: -0.05 }, 1e-7, 1.2);
    let late = rows.iter().filter(|row| row[0] > 1.1);
    let apart = late.map(|row| (row[1] - v).abs().max(row[2].abs())).fold(0.0, f64::max);
    println!(
        "10000 rpm: {steps} steps, at most {:.1e} of {v:.6e} m from the equilibrium at the end",
        apart / v
    );
    assert!(apart < 1e-3 * v && rows[rows.len() - 1][0] == 1.2);
}

#[test]
fn formulations_agree() {
    let model = Motor {
        speed: 8000.0 * RPM,
        T_s: 0.02,
        elements: 2,
        damping: 1e-6,
        ..Motor::default()
    };
    let [rncf, ancf] =
        [Formulation::Rncf, Formulation::Ancf].map(|formulation| run(&model, formulation, Method::Radau, 1e-7, 0.025));
    let [a, b] = [&rncf, &ancf].map(|(rows, _)| rows[rows.len() - 1]);
    println!("after 0.025 s: {a:?} in {} steps, {b:?} in {} steps", rncf.1, ancf.1);
    assert!((a[1] - b[1]).abs() < 1e-4 * a[1].abs() && (a[2] - b[2]).abs() < 1e-4 * a[1].abs());
}
