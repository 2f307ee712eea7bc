//! The heavy top: the numbers of THEORY 9.7, the start's multiplier, energy, and equations of motion by differences.

use rncf_reference::heavy_top::{GRAVITY, HeavyTop, MASS, START};
use rncf_reference::integrate::{Method, agreed};

fn far(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn published_numbers() {
    let run = agreed(&HeavyTop, Method::DoPri8, 1e-13, &START, &[0.0, 0.5, 1.0], 1e-8).unwrap();
    println!("heavy top: tolerances agree to {:.1e}", run.difference);
    let expected = [
        (
            [0.0, 1.0, 0.0],
            [0.0, 319.52598817, 317.26246154],
            [0.0, 150.0, -4.61538],
        ),
        (
            [-0.70246829706, -0.02116518470, -0.71140025765],
            [-523.281244, -404.206178, -357.336176],
            [-0.4710531017, 150.0, 5.9010830483],
        ),
        (
            [0.17334396410, 0.64008859207, -0.74849079113],
            [517.600739, 396.843101, -404.574925],
            [-0.8220781017, 150.0, -5.9232913481],
        ),
    ];
    for (y, (center, multiplier, spin)) in run.states.iter().zip(expected) {
        let found = HeavyTop::instant(y);
        let errors = [
            far(found.center, center),
            far(found.multiplier, multiplier),
            far([y[0], y[1], y[2]], spin),
        ];
        println!("heavy top: errors {errors:?}");
        assert!(errors[0] < 2e-11 && errors[1] < 1e-6 && errors[2] < 2e-10, "{errors:?}");
        assert!((HeavyTop::energy(y) / HeavyTop::energy(&START) - 1.0).abs() < 1e-12);
    }
}

/// `m r'' + lambda = m g` with r'' from differences of the velocity.
#[test]
fn multiplier_solves_the_equations_of_motion() {
    let h = 1e-5;
    let times = [0.0, 0.3 - h, 0.3, 0.3 + h];
    let run = agreed(&HeavyTop, Method::DoPri8, 1e-13, &START, &times, 1e-8).unwrap();
    let [before, now, after] = [1, 2, 3].map(|k| HeavyTop::instant(&run.states[k]));
    for k in 0..3 {
        let acceleration = (after.velocity[k] - before.velocity[k]) / (2.0 * h);
        let left = MASS * (acceleration - GRAVITY[k]) + now.multiplier[k];
        assert!(left.abs() < 2e-4, "component {k}: {left:e} N");
    }
}
