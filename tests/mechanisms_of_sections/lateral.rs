//! Materials that are given by their energy: lateral strains and warping are free, so that a linear one is the linear
//! beam whatever its Poisson's ratio, and rubber meets its closed forms.

use rncf_test_models::Lateral;
use std::f64::consts::PI;

use crate::running::loaded;

const LENGTH: f64 = 0.5;
const YOUNG: f64 = 1e9;
const RADIUS: f64 = 0.01;
const MU: f64 = 1e6;

/// Deflections, elongations and twists over those of Timoshenko's beam.
#[test]
fn a_linear_energy_is_the_linear_beam_at_every_poisson_ratio() {
    let (b, h): (f64, f64) = (0.02, 0.01);
    // Saint-Venant's series for sides in the ratio 2.
    let series: f64 = (0..40)
        .map(|k| f64::from(2 * k + 1))
        .map(|n| (n * PI).tanh() / n.powi(5))
        .sum();
    let flat_torsion = b * h.powi(3) * (1.0 / 3.0 - 32.0 / PI.powi(5) * series);
    for nu in [0.0, 0.3, 0.45, 0.49] {
        // Tension stiffens in bending, and a twist turns what is bent: one load after the other.
        let (push, turn, pull) = (1e-4, 1e-5, 0.03);
        let loads = [(push, 0.0, 0.0), (0.0, turn, 0.0), (0.0, 0.0, pull)];
        let [row, twisted, pulled] = loads.map(|(push, turn, pull)| {
            loaded(&Lateral {
                nu,
                push,
                turn,
                pull,
                ..Lateral::default()
            })
        });
        let shear = YOUNG / (2.0 * (1.0 + nu));
        let deflection =
            |area: f64, i: f64, k: f64| push * LENGTH.powi(3) / (3.0 * YOUNG * i) + push * LENGTH / (k * shear * area);
        let round = PI * RADIUS * RADIUS;
        let round_i = round * RADIUS * RADIUS / 4.0;
        let cowper = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
        let elongation = |area: f64| pull * LENGTH / (YOUNG * area);
        let (flat_z, flat_y) = (h * b.powi(3) / 12.0, b * h.powi(3) / 12.0);
        let k = 5.0 / 6.0;
        let checks = [
            ("rod along y", row[1], deflection(round, round_i, cowper)),
            ("rod along z", row[2], deflection(round, round_i, cowper)),
            ("rod, axial", pulled[0] - LENGTH, elongation(round)),
            ("bar along y", row[4], deflection(b * h, flat_z, k)),
            ("bar along z", row[5], deflection(b * h, flat_y, k)),
            ("bar, axial", pulled[3] - LENGTH, elongation(b * h)),
            ("leaf along y", row[7], deflection(b * h, flat_z, k)),
            ("leaf, axial", pulled[6] - LENGTH, elongation(b * h)),
            ("rod, twist", twisted[10], turn * LENGTH / (shear * 2.0 * round_i)),
            ("bar, twist", twisted[13], turn * LENGTH / (shear * flat_torsion)),
        ];
        for (what, found, wanted) in checks {
            println!("nu = {nu}: {what} {:.9}", found / wanted);
            assert!(
                (found / wanted - 1.0).abs() < 1e-6,
                "{nu} {what}: {found} instead of {wanted}"
            );
        }
    }
}

/// Root of an ascending function.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Uniaxial nominal stress of the compressible neo-Hookean law at a stretch, and the stretch across.
fn uniaxial(lambda: f64, along: f64) -> [f64; 2] {
    let across = root(0.3, 1.7, |b: f64| MU * (b * b - 1.0) + lambda * (along * b * b).ln());
    let stress = (MU * (along * along - 1.0) + lambda * (along * across * across).ln()) / along;
    [stress, across]
}

/// Torsion of a round bar with a free end, uniformly contracted: `T = mu I_p b^2 t`, `N = 0`, no force across.
/// [twist per length, stretch along]
fn twisted(lambda: f64, torque: f64) -> [f64; 2] {
    let area = PI * RADIUS * RADIUS;
    let polar = area * RADIUS * RADIUS / 2.0;
    let twist = |across: f64| torque / (MU * polar * across * across);
    // N = 0 and what is left across, by stretch along at a stretch across.
    let along = |b: f64| root(0.3, 3.0, |a: f64| MU * (a * a - 1.0) + lambda * (a * b * b).ln());
    let b = root(0.5, 1.2, |b: f64| {
        let shear = MU * b * b * twist(b).powi(2) * polar / area;
        2.0 * (MU * (b * b - 1.0) + lambda * (along(b) * b * b).ln()) + shear
    });
    [twist(b), along(b)]
}

/// Curvature under a moment with fibres under uniaxial stress, whose axis is not under tension.
fn bent(lambda: f64, moment: f64) -> f64 {
    // Midpoints in the angle a with Y = r sin a: of a smooth periodic function, so that a few suffice.
    let of = |curvature: f64, middle: f64| {
        let n = 16;
        let mut sums = [0.0; 2];
        for k in 0..n {
            let a = PI * ((f64::from(k) + 0.5) / f64::from(n) - 0.5);
            let y = RADIUS * a.sin();
            let width = 2.0 * (RADIUS * a.cos()).powi(2) * PI / f64::from(n);
            let [stress, _] = uniaxial(lambda, middle + curvature * y);
            sums[0] += width * stress;
            sums[1] += width * stress * y;
        }
        sums
    };
    let middle = |curvature: f64| root(0.9, 1.2, |middle| of(curvature, middle)[0]);
    root(0.0, 30.0, |curvature| of(curvature, middle(curvature))[1] - moment)
}

/// Rubber of several compressibilities: shear strains up to 0.3 in torsion, up to 0.1 in bending.
#[test]
fn rubber_in_torsion_and_bending() {
    let area = PI * RADIUS * RADIUS;
    for lambda in [1e6, 2e6, 20e6] {
        let young = MU * (3.0 * lambda + 2.0 * MU) / (lambda + MU);
        for shear in [0.01, 0.1, 0.3] {
            let turn_rubber = MU * area * RADIUS / 2.0 * shear;
            let row = loaded(&Lateral {
                turn_rubber,
                lambda,
                ..Lateral::default()
            });
            let [twist, along] = twisted(lambda, turn_rubber);
            let mut turned = row[19].atan2(row[18]);
            if turned < 0.0 {
                turned += 2.0 * PI;
            }
            println!(
                "torsion {lambda:e} {shear}: {} {}",
                turned / (0.04 * twist),
                row[14] / (0.04 * along) - 1.0
            );
            // Section axes are quadratic along an element, which turns by 0.3 rad at last.
            assert!((turned / (0.04 * twist) - 1.0).abs() < 1e-6 + 0.01 * shear.powi(4));
            assert!((row[14] / (0.04 * along) - 1.0).abs() < 1e-6);
        }
        for strain in [0.002, 0.02, 0.1] {
            let bend_rubber = young * area * RADIUS / 4.0 * strain;
            let row = loaded(&Lateral {
                bend_rubber,
                lambda,
                ..Lateral::default()
            });
            let angle = (-row[17]).atan2(row[18]);
            let wanted = 0.04 * bent(lambda, bend_rubber);
            println!("bending {lambda:e} {strain}: {:e}", angle / wanted - 1.0);
            // The pressure of the curvature on the section, which a rod of loose fibres does not know, adds about (r / R)^2.
            assert!((angle / wanted - 1.0).abs() < 1e-6 + 2.0 * strain * strain);
        }
    }
}
