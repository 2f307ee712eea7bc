//! The compiled heavy top against THEORY 9.7: centre of mass and multipliers at each method's order.

use rncf::nalgebra::{Matrix3, Vector3};
use rncf::{Formulation, Joints, Method, Model, Options};
use rncf_models::{HeavyTop, SpinUp};

use crate::runs::{adaptive, far, fixed, orders, short, states_at};

/// Centre of mass (m) and multiplier (N) at 0.5 and 1.0 s; what the pivot exerts on the top is its negative.
const EXPECTED: [([f64; 3], [f64; 3]); 2] = [
    (
        [-0.70246829706, -0.02116518470, -0.71140025765],
        [-523.281244, -404.206178, -357.336176],
    ),
    (
        [0.17334396410, 0.64008859207, -0.74849079113],
        [517.600739, 396.843101, -404.574925],
    ),
];
/// Body angular velocity (rad/s) at the same times.
const SPIN: [[f64; 3]; 2] = [
    [-0.4710531017, 150.0, 5.9010830483],
    [-0.8220781017, 150.0, -5.9232913481],
];

/// Largest errors of centre of mass, angular velocity and multipliers.
pub fn errors(method: Method, options: Options) -> [f64; 3] {
    let mut scene = HeavyTop::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, method, options, &[0.5, 1.0]);
    let mut errors = [0.0; 3];
    let mut row = vec![0.0; scene.output_columns()];
    for ((state, (center, multiplier)), spin) in states.iter().zip(EXPECTED).zip(SPIN) {
        scene.outputs(state, &mut row);
        let force = multiplier.map(|lambda| -lambda);
        let found = [
            far(&row[..3], &center),
            far(&state.v[3..], &spin),
            far(&row[3..], &force),
        ];
        for (error, found) in errors.iter_mut().zip(found) {
            *error = f64::max(*error, found);
        }
    }
    errors
}

/// Checks the order between halvings of the step, within a tenth or two.
fn check(method: Method, stabilised: bool, h: f64, expected: [f64; 3]) {
    let all: Vec<[f64; 3]> = (0..3)
        .map(|halving| {
            let options = Options {
                stabilised,
                ..fixed(h / f64::from(1 << halving))
            };
            errors(method, options)
        })
        .collect();
    for (what, expected) in expected.into_iter().enumerate() {
        let errors: Vec<f64> = all.iter().map(|errors| errors[what]).collect();
        let observed = orders(&errors);
        let name = ["centre of mass", "angular velocity", "multipliers"][what];
        println!(
            "{method:?} stabilised {stabilised}, {name}: {} orders {observed:.2?}",
            short(&errors)
        );
        let last = observed[1];
        assert!(
            last > expected - 0.25 && last < expected + 1.0,
            "{method:?}, stabilised {stabilised}, {name}: errors {}, orders {observed:.2?}",
            short(&errors)
        );
    }
}

/// What is declared comes back; of a body of elements the closed form of a straight tube.
#[test]
fn masses_and_inertias_are_told() {
    let mut top = HeavyTop::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    let start = top.rest(0.0);
    let [ref told] = top.masses(&start)[..] else {
        panic!("one body")
    };
    assert_eq!(
        (told.name.as_str(), told.mass, told.centre),
        ("top", 15.0, Vector3::y())
    );
    let expected = Matrix3::from_diagonal(&Vector3::new(0.234375, 0.46875, 0.234375));
    assert!((told.inertia - expected).amax() < 1e-15, "{told:?}");
    let (mass, length) = (2766.67 * 0.7299e-4 * 8.0, 8.0_f64);
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let mut tube = SpinUp::default().build(formulation, Joints::Eliminated).unwrap();
        let start = tube.rest(3.0);
        let [ref told] = tube.masses(&start)[..] else {
            panic!("one body")
        };
        assert!(
            (told.mass - mass).abs() < 1e-14 && (told.inertia[(2, 2)] - mass * length.powi(2) / 12.0).abs() < 1e-13
        );
        let along = told.inertia[(0, 0)] + told.inertia[(1, 1)];
        assert!((along - told.inertia[(2, 2)]).abs() < 1e-13, "{told:?}");
    }
}

#[test]
fn alpha_methods_are_of_order_two_in_everything() {
    for method in [
        Method::Hht { alpha: -0.05 },
        Method::Hht { alpha: -0.3 },
        Method::GeneralizedAlpha { rho_inf: 0.8 },
    ] {
        check(method, false, 1e-3, [2.0; 3]);
    }
    check(Method::GeneralizedAlpha { rho_inf: 0.8 }, true, 1e-3, [2.0; 3]);
}

#[test]
fn radau_has_orders_5_3_2_and_stabilised_5_5_3() {
    check(Method::Radau, false, 5e-3, [5.0, 3.0, 2.0]);
    check(Method::Radau, true, 5e-3, [5.0, 5.0, 3.0]);
}

#[test]
fn errors_follow_the_tolerance() {
    for (rtol, most) in [(1e-5, 1e-3), (1e-7, 1e-5), (1e-9, 1e-7)] {
        let [center, ..] = errors(Method::Radau, adaptive(rtol));
        assert!(center < most, "{center:e} at rtol {rtol:e}");
    }
}
