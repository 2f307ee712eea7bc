//! Runs of an undamped beam: its energy stays.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Stop};
use rncf_models::PrincetonBeam;

/// Largest change of the energy in an adaptive run, the largest deflection, the number of steps.
fn drift(formulation: Formulation, rtol: f64, end: f64) -> (f64, f64, usize) {
    let model = PrincetonBeam {
        elements: 2,
        ..PrincetonBeam::default()
    };
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let before = scene.energy(&start).expect("a conserved energy");
    let options = Options {
        rtol,
        ..Options::default()
    };
    let mut states = Vec::new();
    let mut integrator = Integrator::new(scene.as_mut(), start, end, Method::Radau, options).unwrap();
    loop {
        let stop = integrator.step().unwrap();
        states.push(integrator.state().clone());
        if stop == Stop::End {
            break;
        }
    }
    drop(integrator);
    let mut row = vec![0.0_f64; scene.output_columns()];
    let (mut most, mut deflected) = (0.0_f64, 0.0_f64);
    for state in &states {
        most = most.max((scene.energy(state).unwrap() - before).abs());
        scene.outputs(state, &mut row);
        deflected = deflected.max(row[2].abs());
    }
    (most, deflected, states.len())
}

#[test]
fn an_undamped_beam_keeps_its_energy() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let drifts = [1e-5, 1e-7].map(|rtol| drift(formulation, rtol, 0.06));
        println!(
            "{}: drift of the energy (J), deflection (m), steps {drifts:?}",
            formulation.name()
        );
        // The work of the load goes to and fro.
        let work = 8.896 * drifts[1].1;
        assert!(drifts[1].1 > 0.1 && drifts[1].0 < 1e-3 * work && drifts[1].0 < drifts[0].0);
    }
}
