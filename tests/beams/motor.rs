//! The high-speed motor in steady rotation: relative equilibria, frequencies, damping and critical speed against
//! THEORY 9.3 and the hand-written chain.

use std::f64::consts::PI;

use rncf::equilibrium::{Uniform, continue_from, follow};
use rncf::modes::{Wanted, critical, modes, stability_margin, unstable_directions};
use rncf::{Scene, State};
use rncf_models::Motor;
use rncf_reference::motor::{equilibria as equilibria_by_hand, motor as by_hand};
use rncf_reference::section_chain::Slot;
use rncf_reference::section_modes::Damping;

use crate::scenes::{outputs, referenced};

pub const RPM: f64 = PI / 30.0;

/// When the motor has reached its speed, s.
const LATE: f64 = 1.1;

/// The scene at a speed in rpm.
fn motor(elements: usize, rpm: f64, damping: f64) -> Box<dyn Scene> {
    referenced(&Motor {
        speed: rpm * RPM,
        elements,
        damping,
        ..Motor::default()
    })
}

/// Scenes and relative equilibria at ascending speeds, each continued from the one before.
fn equilibria(elements: usize, speeds: &[f64], damping: f64) -> Vec<(Box<dyn Scene>, State)> {
    let at = Uniform::steady(LATE);
    let mut found: Vec<(Box<dyn Scene>, State)> = Vec::new();
    for &rpm in speeds {
        let mut scene = motor(elements, rpm, damping);
        let state = match found.last() {
            Some((_, before)) if rpm < 17000.0 => continue_from(scene.as_mut(), &at, before).unwrap().state,
            _ => {
                let path = follow(scene.as_mut(), &at, 0.125, |_, _| ()).unwrap();
                path.state().unwrap().clone()
            }
        };
        found.push((scene, state));
    }
    found
}

#[test]
fn relative_equilibria() {
    // THEORY 9.3, made with 3 gradient points: mid-shaft v in mm for 4, 8, 16 elements.
    const TABLE: [(f64, [f64; 3]); 4] = [
        (7500.0, [0.91332, 0.91440, 0.91495]),
        (10000.0, [1.96891, 1.97115, 1.97222]),
        (15000.0, [10.6882, 10.7091, 10.7138]),
        (20000.0, [46.0136, 46.0640, 46.0751]),
    ];
    let speeds = TABLE.map(|row| row.0);
    for (column, elements) in [4, 8, 16].into_iter().enumerate() {
        let hand = equilibria_by_hand(elements, &speeds, 2);
        let found = equilibria(elements, &speeds, 0.0);
        for (((mut scene, state), (problem, q)), (rpm, row)) in found.into_iter().zip(hand).zip(TABLE) {
            let outputs = outputs(scene.as_mut(), &Uniform::steady(LATE), &state);
            let middle = problem
                .chain
                .read(&q, problem.chain.vector(elements / 2, Slot::Position));
            let (v, by_hand) = (1e3 * outputs[0], 1e3 * middle[1]);
            println!(
                "{rpm} rpm, {elements} elements: v {v:.6} mm, from the chain {:.1e}, from the table {:.1e}; w {:.1e} mm; stress {:.1} MPa",
                v - by_hand,
                v / row[column] - 1.0,
                1e3 * outputs[1],
                1e-6 * outputs[3]
            );
            assert!((v - by_hand).abs() < 1e-7 * v && (v / row[column] - 1.0).abs() < 1e-3);
            assert!(outputs[1].abs() < 1e-12);
        }
    }
}

#[test]
fn frequencies_and_decay() {
    // THEORY 9.3: lowest frequency, rad/s; largest real part with damped strain measures, 1/s.
    const TABLE: [(f64, f64, f64); 6] = [
        (10000.0, 761.0, -0.684),
        (12500.0, 506.0, -0.455),
        (15000.0, 282.0, -0.254),
        (16000.0, 230.0, -0.210),
        (17500.0, 214.0, -0.216),
        (20000.0, 235.0, -0.288),
    ];
    let speeds = TABLE.map(|row| row.0);
    let at = Uniform::steady(LATE);
    let wanted = Wanted { count: 6 };
    let [free, damped] = [0.0, 1e-6].map(|damping| equilibria(4, &speeds, damping));
    let hand = equilibria_by_hand(4, &speeds, 2);
    for ((((mut free, at_free), (mut damped, at_damped)), (problem, q)), (rpm, frequency, decay)) in
        free.into_iter().zip(damped).zip(hand).zip(TABLE)
    {
        let undamped = modes(free.as_mut(), &at, &at_free, wanted).unwrap();
        let damped = modes(damped.as_mut(), &at, &at_damped, wanted).unwrap();
        let (lowest, margin) = (undamped[0].im, stability_margin(&damped).unwrap());
        let expected = problem
            .eigenvalue_near(&q, Damping::Measures, [0.0, frequency])
            .unwrap();
        println!("{rpm} rpm: {lowest:.5} rad/s, max Re {margin:.6} 1/s; by hand {expected:.6?}");
        assert!((lowest - frequency).abs() < 0.51 && (margin - decay).abs() < 6e-4);
        assert!((damped[0].im - expected[1]).abs() < 1e-6 * expected[1] && (margin - expected[0]).abs() < 1e-5);
        // Without damping the spectrum is neutral.
        assert!(undamped.iter().all(|mode| mode.re.abs() < 1e-7 * mode.im));
    }
}

#[test]
fn balanced_shaft_has_a_critical_speed() {
    for (elements, expected) in [(4, 17246.0), (8, 17238.0)] {
        let by_hand = by_hand(elements, 0.0, 1.0, 2).critical_speeds().unwrap()[0] / RPM;
        // Of the undeformed shaft, as THEORY has it, and of the turning one: the stretched section under the disc
        // holds it upright, as a gyroscope does.
        let [still, turning] = [false, true].map(|turns| {
            let negatives = |rpm: f64| {
                let at = Uniform::steady(LATE);
                let mut scene = referenced(&Motor {
                    speed: rpm * RPM,
                    elements,
                    eccentricity: 0.0,
                    ..Motor::default()
                });
                let state = if turns {
                    let path = follow(scene.as_mut(), &at, 1.0, |_, _| ())?;
                    path.state().unwrap().clone()
                } else {
                    let mut state = scene.rest(LATE);
                    scene.uniform_state(&at, &mut state);
                    state
                };
                unstable_directions(scene.as_mut(), &at, &state)
            };
            let found = critical(15000.0, 20000.0, 0.05, negatives).unwrap();
            assert!(found.len() == 1 && found[0].change == 2, "{found:?}");
            found[0].value
        });
        println!("critical speed, {elements} elements: {still:.1} rpm, turning {turning:.1} rpm, by hand {by_hand:.1}");
        assert!((still - expected).abs() < 2.0 && (still - by_hand).abs() < 2.0);
        assert!(turning > still && turning < 1.005 * still);
    }
}

#[test]
fn internal_damping_destabilises_the_balanced_shaft_above_its_critical_speed() {
    for (rpm, is_unstable) in [(15000.0, false), (17500.0, true), (20000.0, true)] {
        let at = Uniform::steady(LATE);
        let mut scene = referenced(&Motor {
            speed: rpm * RPM,
            damping: 1e-6,
            eccentricity: 0.0,
            ..Motor::default()
        });
        let path = follow(scene.as_mut(), &at, 1.0, |_, _| ()).unwrap();
        let state = path.state().unwrap().clone();
        let found = modes(scene.as_mut(), &at, &state, Wanted { count: 6 }).unwrap();
        let margin = stability_margin(&found).unwrap();
        let hand = by_hand(4, 0.0, rpm, 2);
        let mut q = hand.chain.stress_free().to_vec();
        hand.newton(1.0, &mut q).unwrap();
        let expected = hand.eigenvalue_near(&q, Damping::Measures, [0.0, found[0].im]).unwrap();
        println!("balanced, {rpm} rpm: max Re {margin:.6} 1/s, by hand {expected:?}");
        assert_eq!(margin > 0.0, is_unstable);
        assert!((margin - expected[0]).abs() < 1e-5);
    }
}
