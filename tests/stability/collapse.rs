//! T4 of THEORY 10: absolute coordinates follow every turn, so that their steps shrink with the spin; in a frame that
//! turns with the body only the deformation is left to follow.

use rncf::{Formulation, Joints, Method, Model, Options};
use rncf_models::SpinUp;

use crate::scenes::run;

/// Half of the run-up.
const END: f64 = 7.5;

/// Accepted steps and evaluations of the residual.
fn counts(formulation: Formulation, omega_s: f64) -> [u64; 2] {
    let model = SpinUp {
        omega_s,
        ..SpinUp::default()
    };
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let options = Options {
        rtol: 1e-7,
        ..Options::default()
    };
    let start = scene.rest(0.0);
    let (_, found) = run(scene.as_mut(), start, END, Method::Hht { alpha: -0.3 }, options).unwrap();
    [found.steps, found.residual_evaluations]
}

#[test]
fn steps_shrink_with_the_spin_in_absolute_coordinates_alone() {
    let [rncf, ancf] = [Formulation::Rncf, Formulation::Ancf].map(|formulation| {
        let found = [4.0, 40.0].map(|omega_s| counts(formulation, omega_s));
        println!("{formulation:?}: steps and residuals at 4 and 40 rad/s {found:?}");
        found
    });
    for count in [0, 1] {
        let ratio = |slow: [u64; 2], fast: [u64; 2]| fast[count] as f64 / slow[count] as f64;
        let (ours, theirs) = (ratio(rncf[0], rncf[1]), ratio(ancf[0], ancf[1]));
        let [gain, gain_fast] = [0, 1].map(|spin: usize| ratio(rncf[spin], ancf[spin]));
        println!("grows {ours:.2} and {theirs:.2} times; absolute over referenced {gain:.1}, {gain_fast:.1}");
        assert!(theirs > 5.0, "absolute coordinates: {theirs}");
        assert!(ours < 0.5 * theirs && gain_fast > 1.5 * gain);
    }
}
