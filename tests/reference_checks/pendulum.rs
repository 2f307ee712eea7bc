//! The pendulum: its multiplier solves the equations of motion, energy is kept, both methods agree.

use rncf_reference::integrate::{Method, agreed};
use rncf_reference::pendulum::Pendulum;
use rncf_reference::system::System;

#[test]
fn multiplier_solves_the_equations_of_motion() {
    let (mass, length, gravity) = (1.3, 0.8, 9.81);
    let pendulum = Pendulum::new(mass, length, gravity).unwrap();
    for y in [[0.0, -3.0], [1.0, 2.0], [-2.0, 0.5]] {
        let motion = pendulum.cartesian(&y);
        let [x, z] = motion.position;
        for (lambda, gradient) in [
            (pendulum.multiplier(&y), [x, z]),
            (pendulum.multiplier_of_square(&y), [2.0 * x, 2.0 * z]),
            (pendulum.multiplier_of_distance(&y), [x / length, z / length]),
        ] {
            let [ax, az] = motion.acceleration;
            assert!((mass * ax + gradient[0] * lambda).abs() < 1e-13);
            assert!((mass * az + mass * gravity + gradient[1] * lambda).abs() < 1e-13);
        }
        // Hidden constraints.
        assert!((x * x + z * z - length * length).abs() < 1e-15);
        assert!((x * motion.velocity[0] + z * motion.velocity[1]).abs() < 1e-15);
    }
}

#[test]
fn energy_and_methods() {
    let pendulum = Pendulum::published();
    let start = pendulum.horizontal_start(-3.0);
    let times: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
    let explicit = agreed(&pendulum, Method::DoPri8, 1e-13, &start, &times, 1e-10).unwrap();
    let implicit = agreed(&pendulum, Method::Radau5, 1e-14, &start, &times, 1e-8).unwrap();
    println!(
        "pendulum: DoPri8 tolerances agree to {:.1e}, Radau5 to {:.1e}",
        explicit.difference, implicit.difference
    );
    for (a, b) in explicit.states.iter().zip(&implicit.states) {
        assert!((a[0] - b[0]).abs() < 1e-8 && (a[1] - b[1]).abs() < 1e-8);
        assert!((pendulum.energy(a) - 4.5).abs() < 1e-11);
    }
}

#[test]
fn bad_input_is_named() {
    let pendulum = Pendulum::published();
    assert!(Pendulum::new(0.0, 1.0, 9.81).unwrap_err().contains("mass"));
    let run = |start: &[f64], times: &[f64], tolerance, allowed| {
        agreed(&pendulum, Method::DoPri8, tolerance, start, times, allowed).unwrap_err()
    };
    assert!(run(&[0.0], &[0.0, 1.0], 1e-9, 1.0).contains("start"));
    assert!(run(&[0.0, 0.0], &[0.0, 0.0], 1e-9, 1.0).contains("times"));
    assert!(run(&[0.0, 0.0], &[0.0, 1.0], 0.0, 1.0).contains("tolerance"));
    assert!(run(&[0.0, 0.0], &[0.0, 1.0], 1e-5, 1e-12).contains("differ"));
    assert_eq!(pendulum.size(), 2);
}
