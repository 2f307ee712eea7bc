//! Sparse systems: the path with Arnoldi's iteration.

use super::super::spectrum::lowest;
use super::*;

/// Independent chains, one beside the other.
fn chains(count: usize, masses: usize, tied: bool) -> Pencil {
    let (mut mass, mut stiffness) = (Entries::new(), Entries::new());
    for first in 0..count {
        let [m, k] = chain(masses, tied, count, first);
        mass.extend(m);
        stiffness.extend(k);
    }
    sparse(count * masses, [&mass, &vec![], &stiffness], &[])
}

#[test]
fn a_long_chain_has_the_frequencies_of_theory() {
    let exact: Vec<f64> = of_chain(400).take(12).collect();
    assert_close(&frequencies(&chains(1, 400, true), 12), &exact, 1e-11);
}

#[test]
fn equal_chains_have_every_frequency_as_often() {
    let exact: Vec<f64> = of_chain(100).flat_map(|frequency| [frequency; 5]).take(20).collect();
    assert_close(&frequencies(&chains(5, 100, true), 20), &exact, 1e-12);
}

#[test]
fn free_chains_have_one_mode_of_frequency_zero_each() {
    // Free ends: 2 sin(k pi / 2n).
    let found = frequencies(&chains(3, 90, false), 9);
    assert_eq!(found[..3], [0.0; 3]);
    let exact = |k: f64| 2.0 * (k * std::f64::consts::PI / 180.0).sin();
    assert_close(
        &found[3..],
        &[exact(1.0), exact(1.0), exact(1.0), exact(2.0), exact(2.0), exact(2.0)],
        1e-12,
    );
}

#[test]
fn a_string_held_by_constraints_has_the_frequencies_of_theory() {
    // The end masses and one in the middle held by multipliers: two chains of 74 masses.
    let n = 151;
    let [mass, stiffness] = chain(n, false, 1, 0);
    let rows: Vec<Entries> = [0, 75, 150].map(|unknown| vec![(0, unknown, 4.0)]).to_vec();
    let string = sparse(n, [&mass, &vec![], &stiffness], &rows);
    let exact: Vec<f64> = of_chain(74).flat_map(|frequency| [frequency; 2]).take(10).collect();
    assert_close(&frequencies(&string, 10), &exact, 1e-12);
    for pair in lowest(&string, 10).unwrap() {
        assert!([0, 75, 150].iter().all(|&unknown| pair.x[unknown].norm() < 1e-13));
    }
}

#[test]
fn a_damped_spinning_string_has_complex_frequencies() {
    // Two transverse chains that turn, with internal damping c K: z = x + i y, w the chain's frequencies:
    // s^2 + (c w^2 + 2 i W) s + w^2 - W^2 = 0. With W = 0.05 forward whirl of the lowest ones is unstable.
    let (n, spin, part) = (200, 0.05, 0.4);
    let (mut mass, mut damping, mut stiffness) = (Entries::new(), Entries::new(), Entries::new());
    for first in 0..2 {
        let [m, k] = chain(n, true, 2, first);
        damping.extend(k.iter().map(|&(i, j, value)| (i, j, part * value)));
        stiffness.extend(k);
        mass.extend(m);
    }
    for i in 0..n {
        damping.extend([(2 * i, 2 * i + 1, -2.0 * spin), (2 * i + 1, 2 * i, 2.0 * spin)]);
        stiffness.extend([(2 * i, 2 * i, -spin * spin), (2 * i + 1, 2 * i + 1, -spin * spin)]);
    }
    let found = values(&sparse(2 * n, [&mass, &damping, &stiffness], &[]), 8);
    let mut exact = Vec::new();
    for frequency in of_chain(n).take(20) {
        let (re, im) = (part * frequency * frequency, 2.0 * spin);
        let [re2, im2] = [
            re * re - im * im - 4.0 * (frequency * frequency - spin * spin),
            2.0 * re * im,
        ];
        let size = re2.hypot(im2);
        // The real part of the root is small: without cancellation, from the imaginary one.
        let imaginary = (0.5 * (size - re2)).sqrt();
        let real = 0.5 * im2 / imaginary;
        exact.extend([1.0, -1.0].map(|sign| [0.5 * (-re + sign * real), (0.5 * (-im + sign * imaginary)).abs()]));
    }
    exact.sort_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
    exact.truncate(8);
    exact.sort_by(|a, b| a[1].total_cmp(&b[1]));
    assert_eq!(found.len(), 8);
    for (found, exact) in found.iter().zip(&exact) {
        let distance = (found[0] - exact[0]).hypot(found[1] - exact[1]);
        assert!(
            distance < 1e-12 * exact[1].hypot(exact[0]).max(1e-2),
            "{found:?} {exact:?}"
        );
    }
    assert!(found.iter().any(|[re, _]| *re > 1e-5) && found.iter().any(|[re, _]| *re < -1e-5));
}

/// Stiffness of a slope: with it frequencies of 10 to 1e3 rad/s lie beside those of 1e6.
const SOFT: f64 = (1u64 << 20) as f64;

/// Masses u with slopes d between them that must follow the differences of u: stiffness K >> k.
fn sheared(n: usize, shear: f64) -> Pencil {
    let (mut mass, mut stiffness) = (Entries::new(), Entries::new());
    // Slope i lies between masses i - 1 and i: unknowns d0 u0 d1 u1 ... dn.
    for i in 0..=n {
        let slope = 2 * i;
        mass.push((slope, slope, 1.0));
        stiffness.push((slope, slope, SOFT));
        let mut terms = vec![(slope, 1.0)];
        if i > 0 {
            terms.push((slope - 1, 1.0));
        }
        if i < n {
            mass.push((slope + 1, slope + 1, 1.0));
            terms.push((slope + 1, -1.0));
        }
        for &(a, p) in &terms {
            stiffness.extend(terms.iter().map(|&(b, q)| (a, b, shear * p * q)));
        }
    }
    sparse(2 * n + 1, [&mass, &vec![], &stiffness], &[])
}

#[test]
fn low_frequencies_are_exact_beside_sections_that_are_stiff() {
    for n in [20, 150] {
        // Sections near 2^20 = 1e6 rad/s.
        let shear = 2.0f64.powi(40);
        let frequency = |k: usize| {
            let square = (2.0 * (k as f64 * std::f64::consts::PI / (2 * (n + 1)) as f64).sin()).powi(2);
            // l^2 - (K + k + K q) l + K k q = 0
            let half = 0.5 * (shear + SOFT + shear * square);
            let product = shear * SOFT * square;
            (product / (half + (half * half - product).sqrt())).sqrt()
        };
        // A constant slope moves no mass: sqrt(K + k), far above.
        let exact: Vec<f64> = (1..=8).map(frequency).collect();
        assert_close(&frequencies(&sheared(n, shear), 8), &exact, 1e-11);
    }
}

#[test]
fn a_free_body_is_still_beside_sections_that_are_stiff() {
    // The same without walls: masses at the ends, one rigid motion.
    let (n, shear) = (80, 2.0f64.powi(40));
    let (mut mass, mut stiffness) = (Entries::new(), Entries::new());
    for i in 0..n {
        let (left, slope, right) = (2 * i, 2 * i + 1, 2 * i + 2);
        mass.extend([(left, left, 1.0), (slope, slope, 1.0)]);
        stiffness.push((slope, slope, SOFT));
        let terms = [(left, 1.0), (slope, 1.0), (right, -1.0)];
        for &(a, p) in &terms {
            stiffness.extend(terms.iter().map(|&(b, q)| (a, b, shear * p * q)));
        }
    }
    mass.push((2 * n, 2 * n, 1.0));
    let found = values(&sparse(2 * n + 1, [&mass, &vec![], &stiffness], &[]), 3);
    assert_eq!(found[0], [0.0, 0.0]);
    assert!(found[1..].iter().all(|[re, im]| re.abs() < 1e-9 * im));
}

#[test]
fn results_repeat_to_the_last_digit() {
    let pencil = chains(3, 60, true);
    let run = || {
        values(&pencil, 7)
            .into_iter()
            .flatten()
            .map(f64::to_bits)
            .collect::<Vec<u64>>()
    };
    assert_eq!(run(), run());
}

#[test]
fn round_off_in_a_row_tells_no_frequency() {
    // A mass without stiffness, but for what has cancelled in its row: a shift as low sees nothing else.
    for exponent in [-42, -30, -18] {
        let n = 200;
        let [mut mass, mut stiffness] = chain(n, true, 1, 0);
        mass.push((n, n, 1.0));
        stiffness.push((n, n, 10f64.powi(exponent)));
        let found = frequencies(&sparse(n + 1, [&mass, &vec![], &stiffness], &[]), 9);
        let exact: Vec<f64> = of_chain(n).take(8).collect();
        assert!(found[0] < 1e-8, "{found:?}");
        assert_close(&found[1..], &exact, 1e-11);
    }
}
