//! Runs of an undamped beam: its energy stays.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, StepSize, Stop};
use rncf_models::PrincetonBeam;

/// Largest change of the energy in a run with a fixed step, and the largest deflection.
fn drift(formulation: Formulation, method: Method, h: f64, end: f64) -> (f64, f64) {
    let model = PrincetonBeam {
        elements: 4,
        ..PrincetonBeam::default()
    };
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let before = scene.energy(&start).expect("a conserved energy");
    let options = Options {
        rtol: 1e-10,
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let mut states = Vec::new();
    let mut integrator = Integrator::new(scene.as_mut(), start, end, method, options).unwrap();
    while integrator.step().unwrap() != Stop::End {
        states.push(integrator.state().clone());
    }
    drop(integrator);
    let mut row = vec![0.0; scene.output_columns()];
    let (mut most, mut deflected): (f64, f64) = (0.0, 0.0);
    for state in &states {
        most = most.max((scene.energy(state).unwrap() - before).abs());
        scene.outputs(state, &mut row);
        deflected = deflected.max(row[2].abs());
    }
    (most, deflected)
}

#[test]
fn an_undamped_beam_keeps_its_energy() {
    // The load falls by 0.1 m: some 0.5 J go to and fro.
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let drifts = [2e-3, 1e-3, 5e-4].map(|h| drift(formulation, Method::Radau, h, 0.06));
        println!("{}: drift of the energy (J) and deflection (m) {drifts:?}", formulation.name());
        assert!(drifts[2].0 < 1e-3 * 8.896 * drifts[2].1 && drifts[2].0 < 0.5 * drifts[0].0);
    }
}
