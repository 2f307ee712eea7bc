//! A mast that grows thinner: deflection and mass by quadrature, frequencies by Rayleigh and Ritz.

use std::f64::consts::PI;

use rncf::app::charts::Line;
use rncf::app::{EquilibriumSettings, Figure, modes, static_equilibria};
use rncf_guide::blades::Mast;
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::filed::Example as Filed;

use crate::{at_rest, chart, column, integral, over, says, shows};

const YOUNG: f64 = 70e9;

/// Outer radius at a place, m.
fn radius(x: f64) -> f64 {
    if x < 5.0 {
        0.06 - 0.002 * x
    } else {
        0.05 - 0.004 * (x - 5.0)
    }
}

fn second_moment(x: f64) -> f64 {
    PI / 4.0 * (radius(x).powi(4) - (radius(x) - 0.003).powi(4))
}

fn area(x: f64) -> f64 {
    PI * (radius(x).powi(2) - (radius(x) - 0.003).powi(2))
}

/// Simpson's rule on both sides of the kink.
fn along(of: impl Fn(f64) -> f64) -> f64 {
    integral(0.0, 5.0, &of) + integral(5.0, 10.0, &of)
}

#[test]
fn the_mast_bends_and_swings_as_quadrature_says() {
    let mast = Mast::default();
    let found = static_equilibria(&mast, &EquilibriumSettings::default()).unwrap();
    let last = |name: &str| *column(&found.history, name).last().unwrap();
    // Castigliano: bending alone, and small.
    let compliance = along(|x| (10.0 - x).powi(2) / (YOUNG * second_moment(x)));
    let mass = along(|x| 2700.0 * area(x));
    assert!(
        (last("top") / (100.0 * compliance) - 1.0).abs() < 5e-3,
        "{} m, {} m",
        last("top"),
        100.0 * compliance
    );
    assert!(
        (last("mass") / mass - 1.0).abs() < 1e-4,
        "{} kg, {mass} kg",
        last("mass")
    );
    says("blades", &format!("bends the top by {:.4} m", last("top")));
    says(
        "blades",
        &format!("a quadrature of F (L - x)^2/(E I) gives {:.4} m", 100.0 * compliance),
    );
    says("blades", &format!("weighs {:.2} kg", mass));
    let still = Mast {
        wind: 0.0,
        ..Mast::default()
    };
    let seen = modes(&still, &EquilibriumSettings::default()).unwrap();
    let lowest = seen.modes[0].im / (2.0 * PI);
    let bound = ritz();
    assert!(lowest < bound && lowest > 0.997 * bound, "{lowest} Hz, {bound} Hz");
    says("blades", &format!("{lowest:.4} Hz"));
    says("blades", &format!("{bound:.4} Hz"));
    let far = static_equilibria(&mast, &over(&mast, "wind", 0.0, 1000.0, 40)).unwrap();
    let mut figure = Figure::default();
    let top = Line::new(far.history.keys.iter().copied().zip(column(&far.history, "top")), 0);
    let small = Line::new([(0.0, 0.0), (1000.0, 1000.0 * compliance)], 5).dashed();
    figure.add(
        "Displacement of the top, and that of small bending",
        &["mast"],
        chart("wind [N]", "top [m]", vec![top, small]),
    );
    let shots = at_rest(&mast);
    let drawing = Drawing {
        magnified: 5.0,
        arrow: 1.0,
        ..Drawing::new(
            &shots,
            View {
                right: [0.0, 0.0, 1.0],
                up: [-1.0, 0.0, 0.0],
            },
            vec![shots.count() - 1],
            "The mast, lying: without wind (grey), and bent 5 times as far",
        )
    };
    shows(
        "blades",
        Some(&drawing),
        &figure,
        "A mast under the wind, and the displacement of its top over the force",
    );
}

/// The file is the table of the page, and another one takes its place.
#[test]
fn the_rows_may_stand_in_a_file() {
    let told = |name: &str, text: &str| {
        let path = std::env::temp_dir().join(format!("rncf-guide-{}-{name}.csv", std::process::id()));
        std::fs::write(&path, text).unwrap();
        path
    };
    let top = |mast: &Filed| {
        let found = static_equilibria(mast, &EquilibriumSettings::default()).unwrap();
        *column(&found.history, "top").last().unwrap()
    };
    let mut mast = Filed::default();
    let found = static_equilibria(&Mast::default(), &EquilibriumSettings::default()).unwrap();
    assert_eq!(Some(&top(&mast)), column(&found.history, "top").last());
    let slender = told("slender", "x [m], radius [mm]\n0, 50\n5, 40\n10, 20\n");
    mast.rows = mast.rows.read(&slender).unwrap();
    std::fs::remove_file(&slender).unwrap();
    says("blades", &format!("bends the top by {:.4} m. `table", top(&mast)));
}

/// The lowest frequency of bending without shear in the shapes x^2 to x^6: an upper bound, Hz.
fn ritz() -> f64 {
    const N: usize = 5;
    let shape = |i: usize, x: f64| (x / 10.0).powi(i as i32 + 2);
    let bent = |i: usize, x: f64| {
        let p = i as f64 + 2.0;
        p * (p - 1.0) * (x / 10.0).powi(i as i32) / 100.0
    };
    let matrix = |of: &dyn Fn(usize, usize, f64) -> f64| -> Vec<Vec<f64>> {
        (0..N)
            .map(|i| (0..N).map(|j| along(|x| of(i, j, x))).collect())
            .collect()
    };
    let stiffness = matrix(&|i, j, x| YOUNG * second_moment(x) * bent(i, x) * bent(j, x));
    let mass = matrix(&|i, j, x| 2700.0 * area(x) * shape(i, x) * shape(j, x));
    // Inverse iteration.
    let mut mode = vec![1.0; N];
    let mut square = 0.0;
    for _ in 0..60 {
        let load: Vec<f64> = mass
            .iter()
            .map(|row| row.iter().zip(&mode).map(|(m, x)| m * x).sum())
            .collect();
        let next = solve(stiffness.clone(), load.clone());
        let up: f64 = load.iter().zip(&next).map(|(a, b)| a * b).sum();
        let kinetic: f64 = (0..N)
            .map(|i| next[i] * mass[i].iter().zip(&next).map(|(m, x)| m * x).sum::<f64>())
            .sum();
        square = up / kinetic;
        let largest = next.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        mode = next.iter().map(|x| x / largest).collect();
    }
    square.sqrt() / (2.0 * PI)
}

/// Elimination with the largest pivot.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n)
            .max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))
            .unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let rest: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - rest) / a[k][k];
    }
    b
}
