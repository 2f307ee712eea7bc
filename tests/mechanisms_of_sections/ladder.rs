//! Beams in all descriptions: whole, in modes, for small deformations, rigid, and in mean axes; frequencies against
//! those of Timoshenko's beam.

use rncf::equilibrium::{Uniform, static_load};
use rncf::modes::{Wanted, modes};
use rncf::prelude::*;

use crate::running::{WAYS, build};

const LENGTH: f64 = 1.0;
const DENSITY: f64 = 2700.0;
const YOUNG: f64 = 70e9;
const POISSON: f64 = 0.33;
const SIZE: [f64; 2] = [0.04, 0.02];

rncf::model! {
    /// The same cantilever whole and in modes, and a rigid one on a hinge with a spring.
    pub model Ladder {
        param elements: count = 8;
        param modes: count = 6;
        param press = 0 N;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section strip = rectangle(y = 40 mm, z = 20 mm);
        frame place = moving(origin = [0, 0, 1] m);
        frame hinge = hinged(axis = z, angle = 20 deg);
        body whole in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); }
        body in_modes in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); modal(modes); }
        body little in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); small(modes); }
        body stiff in hinge { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); rigid; }
        joint root_1 = clamp(whole.start, place);
        joint root_2 = clamp(in_modes.start, place);
        joint root_3 = clamp(little.start, place);
        spring coil = torsional(hinge, stiffness = 200 N*m/rad, angle = 20 deg);
        load push_1 = force(whole.end, [0, press, press / 2]);
        load push_2 = force(in_modes.end, [0, press, press / 2]);
        load push_3 = force(little.end, [0, press, press / 2]);
        output tip_1 = whole.end;
        output tip_2 = in_modes.end;
        output tip_3 = little.end;
        output tip_4 = stiff.end;
    }
}

rncf::model! {
    /// The beam in mean axes.
    pub model Flying {
        param elements: count = 8;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section strip = rectangle(y = 40 mm, z = 20 mm);
        frame place = free(velocity = [1, 0, 0] m/s);
        body bar in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); mean_axes; }
        output tip = bar.end;
    }
}

/// Frequencies of a Timoshenko beam with the size `high` in the plane of bending: sign changes of the determinant of the
/// conditions at the ends.
fn timoshenko(high: f64, is_free: bool, count: usize) -> Vec<f64> {
    let area = SIZE[0] * SIZE[1];
    let second = area * high * high / 12.0;
    let bending = YOUNG * second;
    let shear = 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON)) * area;
    let (mass, rotary) = (DENSITY * area, DENSITY * second);
    // Deflection, turning, moment, shear force along the beam, by the series of exp(A).
    let transfer = |w: f64| -> [[f64; 4]; 4] {
        let a = [
            [0.0, 1.0, 0.0, 1.0 / shear],
            [0.0, 0.0, 1.0 / bending, 0.0],
            [0.0, -rotary * w * w, 0.0, -1.0],
            [-mass * w * w, 0.0, 0.0, 0.0],
        ];
        let product = |x: &[[f64; 4]; 4], y: &[[f64; 4]; 4]| -> [[f64; 4]; 4] {
            std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| x[i][k] * y[k][j]).sum()))
        };
        let identity: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
        let (mut sum, mut term) = (identity, identity);
        for k in 1..120 {
            term = product(&term, &a).map(|row| row.map(|x| x * LENGTH / f64::from(k)));
            for i in 0..4 {
                for j in 0..4 {
                    sum[i][j] += term[i][j];
                }
            }
        }
        sum
    };
    let condition = |w: f64| {
        let t = transfer(w);
        // What is zero at the end, and what is free at the start.
        let from = if is_free { [0, 1] } else { [2, 3] };
        t[2][from[0]] * t[3][from[1]] - t[2][from[1]] * t[3][from[0]]
    };
    let mut found = Vec::new();
    let (step, mut low) = (2.0, 5.0);
    while found.len() < count {
        let (mut a, mut b) = (low, low + step);
        if condition(a) * condition(b) < 0.0 {
            for _ in 0..100 {
                let middle = 0.5 * (a + b);
                if condition(a) * condition(middle) <= 0.0 {
                    b = middle
                } else {
                    a = middle
                }
            }
            found.push(0.5 * (a + b));
        }
        low += step;
    }
    found
}

fn expected(is_free: bool, count: usize) -> Vec<f64> {
    let mut all = [timoshenko(SIZE[0], is_free, count), timoshenko(SIZE[1], is_free, count)].concat();
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
