//! Rigid mechanisms against published and independently computed numbers (THEORY 9.7).

use rncf::{Formulation, Joints, Method, Model, Options, Scene, State};
use rncf_models::{AndrewsSqueezer, Bricard, FlyballGovernor, FourBar};

use crate::runs::{adaptive, fixed, states_at};

fn stabilised(options: Options) -> Options {
    Options {
        stabilised: true,
        ..options
    }
}

fn scene(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// Outputs at `times`, one row a time.
fn rows(model: &impl Model, method: Method, options: Options, times: &[f64]) -> Vec<Vec<f64>> {
    let mut scene = scene(model);
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, method, options, times);
    let mut row = |state: &State| {
        let mut row = vec![0.0; scene.output_columns()];
        scene.outputs(state, &mut row);
        row
    };
    states.iter().map(&mut row).collect()
}

#[track_caller]
fn agree(what: &str, ours: &[f64], reference: &[f64], tolerance: f64) {
    for (index, (a, b)) in ours.iter().zip(reference).enumerate() {
        assert!(
            (a - b).abs() <= tolerance,
            "{what}: output {index} is {a} instead of {b}, {:e} away",
            (a - b).abs()
        );
    }
    assert_eq!(ours.len(), reference.len(), "{what}");
}

/// Published at 0.03 s (IVP test set).
const SQUEEZER: [f64; 7] = [
    15.81077119629904,
    -15.75637105984298,
    0.04082224013073101,
    -0.5347301163226948,
    0.5244099658805304,
    0.5347301163226948,
    1.048080741042263,
];

#[test]
fn andrews_squeezer_to_eight_digits() {
    for options in [adaptive(1e-10), stabilised(adaptive(1e-10))] {
        let rows = rows(&AndrewsSqueezer::default(), Method::Radau, options, &[0.03]);
        for (ours, published) in rows[0].iter().zip(SQUEEZER) {
            assert!((ours / published - 1.0).abs() < 1e-8, "{ours} instead of {published}");
        }
    }
}

#[test]
fn andrews_squeezer_starts_with_the_published_accelerations() {
    let model = AndrewsSqueezer::default();
    let mut scene = scene(&model);
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, Method::Radau, fixed(1e-6), &[0.0, 1e-6]);
    let accelerations: Vec<f64> = (0..scene.unknowns())
        .filter(|&index| scene.describe_unknown(index).contains("rotation"))
        .map(|index| states[0].a[index])
        .collect();
    // Body 1 turns by beta, body 2 by beta + Theta.
    agree("beta''", &accelerations[..1], &[14222.4439199541], 1e-6);
    agree(
        "beta'' + Theta''",
        &accelerations[1..2],
        &[14222.4439199541 - 10666.8329399656],
        1e-6,
    );
    agree("others", &accelerations[2..], &[0.0; 5], 1e-6);
}

#[test]
fn four_bar_stays_on_its_branch() {
    let times = [1.0, 2.0, 5.0];
    let expected = [
        [-0.1950203019, -0.9807992057],
        [0.0578157958, 0.9983272679],
        [-0.8113104610, -0.5846155454],
    ];
    let rows = rows(&FourBar::default(), Method::Radau, adaptive(1e-8), &times);
    for (row, expected) in rows.iter().zip(expected) {
        agree("B0", row, &expected, 1e-5);
    }
}

#[test]
fn bricard() {
    let times = [0.5, 1.0, 2.0];
    let expected = [
        [0.96828, -1.22463, 0.75015],
        [0.51050, -1.64917, 0.14012],
        [-0.96934, -1.22125, 0.75428],
    ];
    for method in [Method::Radau, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
        let options = if method == Method::Radau {
            adaptive(1e-8)
        } else {
            fixed(1e-3)
        };
        let rows = rows(&Bricard::default(), method, options, &times);
        for (row, expected) in rows.iter().zip(expected) {
            agree("P3", row, &expected, if method == Method::Radau { 6e-6 } else { 2e-4 });
        }
    }
}

#[test]
fn flyball_governor() {
    let expected = [
        [0.5269333016, 0.4970948185, 1.0089854758],
        [0.6065952598, 0.4298990897, 1.1102833655],
    ];
    let rows = rows(&FlyballGovernor::default(), Method::Radau, adaptive(1e-8), &[1.0, 5.0]);
    for (row, expected) in rows.iter().zip(expected) {
        // Angle and slide come to the digits of the reference; a velocity is measured by the step, `h v`.
        agree("governor", &row[..2], &expected[..2], 1e-9);
        agree("governor", &row[2..], &expected[2..], 1e-6);
    }
}
