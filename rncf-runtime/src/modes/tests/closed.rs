//! Rotors, pendulums and bodies of few unknowns.

use super::super::pair::Failure;
use super::super::spectrum::lowest;
use super::super::{Critical, critical, dense};
use super::*;

/// A disc of 2 kg on a massless shaft, co-rotating axes: stiffness along both axes, internal damping.
fn jeffcott(spin: f64, stiffness: [f64; 2], damping: f64) -> Pencil {
    let mass = 2.0;
    let [kx, ky] = stiffness.map(|k| k - mass * spin * spin);
    let coriolis = 2.0 * mass * spin;
    sparse(
        2,
        [
            &full([[mass, 0.0], [0.0, mass]]),
            &full([[damping, -coriolis], [coriolis, damping]]),
            &full([[kx, 0.0], [0.0, ky]]),
        ],
        &[],
    )
}

#[test]
fn a_round_shaft_has_its_frequency_shifted_by_the_spin() {
    // w0 = 5 rad/s
    for spin in [0.0, 1.0, 4.9, 7.0, 100.0] {
        let mut exact = [(5.0f64 - spin).abs(), 5.0 + spin];
        exact.sort_by(f64::total_cmp);
        assert_close(&frequencies(&jeffcott(spin, [50.0; 2], 0.0), 9), &exact, 1e-13);
    }
}

#[test]
fn internal_damping_makes_the_forward_whirl_unstable_above_the_critical_speed() {
    for (spin, is_stable) in [(0.0, true), (4.8, true), (5.2, false), (12.0, false)] {
        let damping = 0.4;
        let found = values(&jeffcott(spin, [50.0; 2], damping), 9);
        // z = x + i y: s^2 + (c / m + 2 i W) s + w0^2 - W^2 = 0; -+ sqrt by hand, and its conjugates.
        let [re, im] = [damping / 2.0, 2.0 * spin];
        let [re2, im2] = [re * re - im * im - 4.0 * (25.0 - spin * spin), 2.0 * re * im];
        let size = re2.hypot(im2);
        let root = [(0.5 * (size + re2)).sqrt(), (0.5 * (size - re2)).sqrt()];
        let mut exact = [1.0, -1.0].map(|sign| [0.5 * (-re + sign * root[0]), (0.5 * (-im + sign * root[1])).abs()]);
        exact.sort_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
        for (found, exact) in found.iter().zip(exact) {
            assert_close(found, &exact, 1e-12);
        }
        assert_eq!(found.iter().all(|[re, _]| *re < 0.0), is_stable, "{spin}");
    }
}

#[test]
fn a_flat_shaft_diverges_between_its_critical_speeds() {
    // wx = 4, wy = 6 rad/s: s^4 + (wx^2 + wy^2 + 2 W^2) s^2 + (wx^2 - W^2)(wy^2 - W^2) = 0
    for spin in [1.0, 5.0, 9.0f64] {
        let square = spin * spin;
        let (sum, product) = (0.5 * (52.0 + 2.0 * square), (16.0 - square) * (36.0 - square));
        let root = (sum * sum - product).sqrt();
        let found = values(&jeffcott(spin, [32.0, 72.0], 0.0), 9);
        if product < 0.0 {
            let growth = (root - sum).sqrt();
            assert_eq!(found.len(), 3);
            assert_close(&found[0], &[growth, 0.0], 1e-12);
            assert_close(&found[2], &[-growth, 0.0], 1e-12);
        } else {
            assert_close(
                &[found[0][1], found[1][1]],
                &[(sum - root).sqrt(), (sum + root).sqrt()],
                1e-12,
            );
        }
    }
}

#[test]
fn critical_speeds_are_bisected() {
    let negatives =
        |stiffness: [f64; 2]| move |spin: f64| Ok(dense::negative_stiffness(&jeffcott(spin, stiffness, 0.1)).unwrap());
    let round = critical(0.0, 40.0, 1e-9, negatives([50.0; 2])).unwrap();
    let [Critical { value, change: 2, .. }] = round[..] else {
        panic!("{round:?}");
    };
    assert!((value - 5.0).abs() < 1e-9);
    let flat = critical(0.0, 40.0, 1e-9, negatives([32.0, 72.0])).unwrap();
    assert!(flat.iter().all(|critical| critical.change == 1));
    assert_close(&[flat[0].value, flat[1].value], &[4.0, 6.0], 1e-9);
    assert_eq!(critical(40.0, 7.0, 1e-9, negatives([50.0; 2])), Ok(vec![]));
    assert_eq!(critical(9.0, 1.0, 1e-3, negatives([50.0; 2])).unwrap()[0].change, -2);
}

#[test]
fn negative_directions_respect_constraints() {
    // diag(-1, 2, -3) along x + y = 0 and along z.
    let k = full([[-1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, -3.0]]);
    let one = full([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    let count = |rows: &[Entries]| dense::negative_stiffness(&sparse(3, [&one, &vec![], &k], rows)).unwrap();
    assert_eq!(count(&[]), 2);
    assert_eq!(count(&[row([1.0, 1.0, 0.0])]), 1);
    assert_eq!(count(&[row([0.0, 0.0, 7.0])]), 1);
    assert_eq!(count(&[row([1.0, 1.0, 0.0]), row([0.0, 0.0, 7.0])]), 0);
}

#[test]
fn a_conical_pendulum_nods_and_drifts() {
    // l = 1 m, tilt from the vertical by cos = g / (l w^2): nu = w sqrt(1 + 3 cos^2); the azimuth is free.
    let (mass, spin, cosine) = (1.7, 4.0, 0.6);
    let tension = mass * spin * spin;
    let gyroscopic = 2.0 * mass * spin;
    let pendulum = sparse(
        3,
        [
            &full([[mass, 0.0, 0.0], [0.0, mass, 0.0], [0.0, 0.0, mass]]),
            &full([[0.0, -gyroscopic, 0.0], [gyroscopic, 0.0, 0.0], [0.0; 3]]),
            &full([[0.0; 3], [0.0; 3], [0.0, 0.0, tension]]),
        ],
        &[row([0.8, 0.0, -cosine])],
    );
    let exact = spin * (1.0f64 + 3.0 * cosine * cosine).sqrt();
    assert_close(&frequencies(&pendulum, 9), &[0.0, exact], 1e-12);
}

#[test]
fn a_tethered_mass_swings_in_the_centrifugal_field() {
    // Hub radius 0.5 m, tether 2 m: in plane W sqrt(R / l), out of plane W sqrt((R + l) / l).
    let (mass, spin, hub, length): (f64, f64, f64, f64) = (3.0, 2.0, 0.5, 2.0);
    let multiplier = mass * spin * spin * (hub + length) / length;
    let inplane = multiplier - mass * spin * spin;
    let gyroscopic = 2.0 * mass * spin;
    let tether = sparse(
        3,
        [
            &full([[mass, 0.0, 0.0], [0.0, mass, 0.0], [0.0, 0.0, mass]]),
            &full([[0.0, -gyroscopic, 0.0], [gyroscopic, 0.0, 0.0], [0.0; 3]]),
            &full([[inplane, 0.0, 0.0], [0.0, inplane, 0.0], [0.0, 0.0, multiplier]]),
        ],
        &[row([length, 0.0, 0.0])],
    );
    assert_close(&frequencies(&tether, 9), &[1.0, 2.0 * 1.25f64.sqrt()], 1e-13);
}

#[test]
fn a_symmetric_free_body_precesses() {
    // J = diag(A, A, C), spin W about z, right increments in body axes (THEORY 2.1):
    // J (y'' + [w] y') + ([w] J - [J w]) (y' + [w] y) = 0; nu = |C - A| / A W, the tilt in space W.
    let (a, c, spin) = (2.0, 3.5, 3.0);
    let tilt = spin * (a - c);
    // ([w] J - [J w]) = (A - C) W [[0, -1], [1, 0]] (with W A - W C), J [w] = A W [[0, -1], [1, 0]].
    let gyroscopic = tilt + a * spin;
    let body = sparse(
        3,
        [
            &full([[a, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, c]]),
            &full([[0.0, -gyroscopic, 0.0], [gyroscopic, 0.0, 0.0], [0.0; 3]]),
            &full([[-tilt * spin, 0.0, 0.0], [0.0, -tilt * spin, 0.0], [0.0; 3]]),
        ],
        &[],
    );
    assert_close(&frequencies(&body, 9), &[0.0, (c - a) / a * spin, spin], 1e-12);
}

#[test]
fn an_overdamped_mass_creeps() {
    // s^2 + 5 s + 4 = 0, and a mass with damping alone: 0 and -3.
    let damped = sparse(
        2,
        [
            &full([[1.0, 0.0], [0.0, 1.0]]),
            &full([[5.0, 0.0], [0.0, 3.0]]),
            &full([[4.0, 0.0], [0.0, 0.0]]),
        ],
        &[],
    );
    let found = values(&damped, 9);
    assert!(found.iter().all(|[_, im]| *im == 0.0));
    let rates: Vec<f64> = found.iter().map(|[re, _]| *re).collect();
    assert_close(&rates, &[0.0, -1.0, -3.0, -4.0], 1e-13);
    assert_eq!(rates[0], 0.0);
}

#[test]
fn equal_frequencies_have_as_many_modes() {
    let k = full([[9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 9.0]]);
    let one = full([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_close(&frequencies(&sparse(3, [&one, &vec![], &k], &[]), 9), &[3.0; 3], 1e-14);
}

#[test]
fn a_massless_direction_has_no_mode() {
    // A spring in series with a massless joint: k / 2.
    let k = full([[1.0, -1.0], [-1.0, 2.0]]);
    let pencil = sparse(2, [&full([[1.0, 0.0], [0.0, 0.0]]), &vec![], &k], &[]);
    assert_close(&frequencies(&pencil, 9), &[0.5f64.sqrt()], 1e-13);
}

#[test]
fn what_is_singular_is_named() {
    let one = full([[1.0, 0.0], [0.0, 1.0]]);
    // The second unknown has neither mass nor stiffness.
    let untied = sparse(
        2,
        [
            &full([[1.0, 0.0], [0.0, 0.0]]),
            &vec![],
            &full([[1.0, 0.0], [0.0, 0.0]]),
        ],
        &[],
    );
    assert!(matches!(lowest(&untied, 1), Err(Failure::Singular(_))));
    let twice = sparse(2, [&one, &vec![], &one], &[row([1.0, 0.0]), row([2.0, 0.0])]);
    assert_eq!(lowest(&twice, 1).err(), Some(Failure::Singular(Some(3))));
    let wrong = sparse(1, [&full([[f64::NAN]]), &vec![], &full([[1.0]])], &[]);
    assert_eq!(lowest(&wrong, 1).err(), Some(Failure::NotFinite));
    let held = sparse(2, [&one, &vec![], &one], &[row([1.0, 0.0]), row([0.0, 2.0])]);
    assert!(lowest(&held, 3).unwrap().is_empty());
}
