//! Beams in all descriptions: whole, in modes, for small deformations, rigid, and in mean axes; frequencies against
//! those of Timoshenko's beam.

use rncf::equilibrium::{Uniform, static_load};
use rncf::modes::{Wanted, modes};
use rncf::prelude::*;
use rncf_reference::timoshenko::Beam;
use rncf_test_models::{Flying, Ladder};

use crate::running::{WAYS, build};

const LENGTH: f64 = 1.0;
const DENSITY: f64 = 2700.0;
const YOUNG: f64 = 70e9;
const POISSON: f64 = 0.33;
const SIZE: [f64; 2] = [0.04, 0.02];

/// The bar, bending over the size `high`.
fn beam(high: f64) -> Beam {
    let area = SIZE[0] * SIZE[1];
    let second = area * high * high / 12.0;
    Beam {
        length: LENGTH,
        mass: DENSITY * area,
        rotary: DENSITY * second,
        bending: YOUNG * second,
        shear: 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON)) * area,
    }
}

fn expected(is_free: bool, count: usize) -> Vec<f64> {
    let mut all = SIZE.map(|high| beam(high).frequencies(is_free, count)).concat();
    all.sort_by(f64::total_cmp);
    all.truncate(count);
    all
}

fn frequencies(scene: &mut dyn Scene, count: usize) -> Vec<f64> {
    let at = Uniform::at_rest(0.0);
    let state = scene.uniform_guess(&at);
    let found = modes(scene, &at, &state, Wanted { count }).unwrap();
    found.iter().map(|mode| mode.im).collect()
}

fn worst(found: &[f64], expected: &[f64]) -> f64 {
    found
        .iter()
        .zip(expected)
        .map(|(a, b)| (a / b - 1.0).abs())
        .fold(0.0, f64::max)
}

/// The hinged rigid beam is the lowest; its inertia has the part of the sections.
#[test]
fn frequencies_of_clamped_beams() {
    let exact = expected(false, 4);
    let inertia = DENSITY * SIZE[0] * SIZE[1] * (1.0 / 3.0 + SIZE[0] * SIZE[0] / 12.0);
    let swing = (200.0 / inertia).sqrt();
    for way in [WAYS[0], WAYS[1]] {
        let found = frequencies(build(&Ladder::default(), way).as_mut(), 13);
        println!("{way:?}: {found:.3?}; Timoshenko {exact:.3?}, pendulum {swing:.6}");
        assert!((found[0] / swing - 1.0).abs() < 1e-9);
        // All three share each frequency.
        for (index, frequency) in found[1..].iter().enumerate() {
            let ratio = frequency / exact[index / 3];
            assert!(
                (ratio - 1.0).abs() < 2e-4,
                "{frequency} instead of {}",
                exact[index / 3]
            );
        }
    }
}

/// A small load deflects all descriptions alike, and as the closed form.
#[test]
fn deflection_in_all_descriptions() {
    let press = 2.0;
    let area = SIZE[0] * SIZE[1];
    let shear = 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON)) * area;
    let closed: [f64; 2] = [(SIZE[0], press), (SIZE[1], press / 2.0)]
        .map(|(high, force)| force / (3.0 * YOUNG * area * high * high / 12.0) + force / shear);
    let model = Ladder {
        press,
        modes: 20,
        ..Ladder::default()
    };
    let mut scene = build(&model, WAYS[0]);
    let found = static_load(scene.as_mut(), 0.0).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&Uniform::at_rest(0.0), found.state().unwrap(), &mut row);
    let errors: Vec<f64> = row.chunks(3).map(|tip| worst(&tip[1..], &closed)).collect();
    println!("whole, modal(20), small(20): {errors:?}");
    assert!(errors[0] < 1e-6 && errors[1] < 1e-3 && errors[2] < 1e-3);
}

/// In mean axes a beam vibrates with the frequencies of a free one.
#[test]
fn frequencies_of_a_free_beam() {
    let exact = expected(true, 4);
    let found = frequencies(build(&Flying::default(), WAYS[0]).as_mut(), 16);
    println!("Timoshenko {exact:.3?}, found {found:.3?}");
    let elastic: Vec<f64> = found.into_iter().filter(|&f| f > 10.0).take(3).collect();
    assert!(worst(&elastic, &exact) < 1e-3);
}
