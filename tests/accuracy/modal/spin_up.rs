//! The spin-up of THEORY 9.1 with the beam in modes, against the whole beam.

use rncf::{Method, Model};
use rncf_models::SpinUp;

use super::models::{SpinUpModal, SpinUpSmall};
use crate::runs::{WAYS, adaptive, apart, grid, history, short, states_at};

/// Freedoms of the beam in 6 elements.
const ALL: usize = 25;

#[test]
fn all_modes_are_the_whole_beam() {
    let times = grid(0.25, 18.0);
    let (whole, _) = history(&SpinUp::default(), WAYS[0], Method::Radau, adaptive(1e-9), &times);
    let all = SpinUpModal {
        modes: ALL,
        ..SpinUpModal::default()
    };
    let (all, _) = history(&all, WAYS[0], Method::Radau, adaptive(1e-9), &times);
    let error = apart(&all, &whole);
    println!("spin-up, all {ALL} modes: {error:.1e} m");
    assert!(error < 1e-7);
}

/// So slow that the deflection stays below the radius of gyration of the section, 1.06 cm: straight modes cannot follow more.
const SLOW: f64 = 1500.0;

#[test]
fn stretching_modes_bring_a_slow_spin_up_to_the_whole_beam() {
    let times = grid(25.0, 1550.0);
    let whole = SpinUp {
        T_s: SLOW,
        ..SpinUp::default()
    };
    let (whole, _) = history(&whole, WAYS[0], Method::Radau, adaptive(1e-9), &times);
    let most = whole.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
    // Those without stretch buckle, as they lose their stiffness to the spin; the others converge.
    let errors = [4, 10, 14, 18, ALL].map(|modes| {
        let model = SpinUpModal {
            modes,
            T_s: SLOW,
            ..SpinUpModal::default()
        };
        apart(
            &history(&model, WAYS[0], Method::Radau, adaptive(1e-9), &times).0,
            &whole,
        )
    });
    println!(
        "slow spin-up to {most:.2e} m, 4, 10, 14, 18, {ALL} modes: {} m",
        short(&errors)
    );
    assert!(errors[0] > most && errors[1] < 0.05 * most, "{errors:?}");
    assert!(
        errors.windows(2).all(|pair| pair[1] < pair[0]) && errors[4] < 1e-7,
        "{errors:?}"
    );
}

/// Greatest deflection, that of the last 2.5 s, and the first warning of every kind with its time.
fn watched(model: &impl Model) -> ([f64; 2], Vec<(f64, String)>) {
    let mut scene = model.build(WAYS[0].0, WAYS[0].1).unwrap();
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, Method::Radau, adaptive(1e-6), &grid(0.25, 18.0));
    let mut row = [0.0; 2];
    let mut deflections = Vec::new();
    let mut warned: Vec<(f64, String)> = Vec::new();
    let kind = |text: &str| text.contains("of that at rest") || text.contains("stiffness at rest");
    for state in &states {
        scene.outputs(state, &mut row);
        deflections.push(row[1].abs());
        for text in scene.warnings(state).into_iter().map(|warning| warning.text) {
            if warned.iter().all(|(_, other)| kind(other) != kind(&text)) {
                warned.push((state.t, text));
            }
        }
    }
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    (
        [most(&deflections), most(&deflections[deflections.len() - 10..])],
        warned,
    )
}

#[test]
fn a_rotor_whose_modes_are_wrong_is_reported() {
    let (whole, silent) = watched(&SpinUp::default());
    let (modal, of_modes) = watched(&SpinUpModal {
        modes: 3,
        ..SpinUpModal::default()
    });
    let (small, of_small) = watched(&SpinUpSmall {
        modes: 3,
        ..SpinUpSmall::default()
    });
    for (name, found, warned) in [
        ("whole", whole, &silent),
        ("modal(3)", modal, &of_modes),
        ("small(3)", small, &of_small),
    ] {
        println!(
            "{name}: v up to {:.3} m, after the run-up {:.4} m; {warned:?}",
            found[0], found[1]
        );
    }
    // A speed of 4 rad/s is eta = 4.83. The modes first resist the deflection, since they stretch where the beam bends;
    // in the end they lose their stiffness and stay bent.
    assert!(silent.is_empty());
    assert!(modal[0] < 0.2 * whole[0] && modal[1] > 2.0 * whole[1]);
    assert_eq!(of_modes.len(), 2);
    assert!(
        of_modes[0].0 < 7.5 && of_modes[0].1.contains("too large for its 3 modes"),
        "{of_modes:?}"
    );
    assert!(
        of_modes[1].1.contains("body `beam`") && of_modes[1].1.contains("modes keep only"),
        "{of_modes:?}"
    );
    // Small deformations know no centrifugal stiffness.
    assert!(small[0] > 1.05 * whole[0]);
    assert_eq!(of_small.len(), 1);
    assert!(
        of_small[0].0 < 9.0 && of_small[0].1.contains("small(3) leaves out centrifugal effects"),
        "{of_small:?}"
    );
}
