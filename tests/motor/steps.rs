//! Table 2 of the paper in little: what the referenced coordinates save.

use super::RPM;
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Stop};
use rncf_models::Motor;

/// Steps of adaptive HHT with the settings of the table.
fn steps(rpm: f64, formulation: Formulation, end: f64) -> u64 {
    let model = Motor {
        speed: rpm * RPM,
        ..Motor::default()
    };
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let options = Options {
        rtol: 1e-7,
        max_step: 0.01,
        ..Options::default()
    };
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), start, end, Method::Hht { alpha: -0.3 }, options).unwrap();
    while integrator.step().unwrap() != Stop::End || integrator.state().t < end * (1.0 - 1e-12) {}
    integrator.statistics().steps
}

/// Published: 127 to 3246 steps of RNCF at 7500 to 20000 rpm, 84377 to 253934 of ANCF.
#[test]
fn referenced_coordinates_take_a_hundredth_of_the_steps() {
    for (rpm, published) in [(7500.0, 127), (20000.0, 3246)] {
        let rncf = steps(rpm, Formulation::Rncf, 1.2);
        let ancf = steps(rpm, Formulation::Ancf, 1.2);
        println!("{rpm} rpm: RNCF {rncf}, published {published}; ANCF {ancf}");
        assert!((120..=published).contains(&rncf), "{rpm} rpm: {rncf}");
        assert!(ancf > 100 * rncf, "{rpm} rpm: {ancf} against {rncf}");
    }
}
