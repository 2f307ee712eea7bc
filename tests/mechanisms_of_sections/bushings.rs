//! Bushings with cross terms, angles and coupling: films, pedestals and foundations in closed form, shafts in shafts.

use rncf::AnyModel;
use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// A disc on a film whose coefficients are a table over the speed, on a pedestal that has a mass.
    pub model Film {
        param speed = 150 rad/s;
        table film {
            at = speed; speed = [0, 100, 200, 400] rad/s;
            k = [1, 2, 5, 9] kN/m; c = [10, 20, 15, 5] N*s/m; cross = [0, 100, 400, 1500] N/m;
        }
        rigid disc { mass = 2 kg; inertia = [0.02, 0.02, 0.03] kg*m^2; }
        rigid foot { mass = 5 kg; }
        spring oil = bushing(disc, foot, stiffness = [[film.k(speed), film.cross(speed), 0], [-film.cross(speed), film.k(speed), 0], [0, 0, film.k(speed)]],
            damping = [film.c(speed), film.c(speed), 0]);
        spring ground = bushing(foot, inertial, stiffness = [30, 30, 30] kN/m);
        output x = disc.x;
        output foot = foot.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A rigid tower whose foundation resists shifts and turns at once, as soil does at the mudline.
    pub model Tower {
        rigid tower { mass = 600 [t]; inertia = [3e8, 3e8, 1e6] kg*m^2; center = [0, 0, 40] m; }
        spring soil = bushing(tower, inertial, stiffness = [2.57, 2.57, 10] GN/m, rotational_stiffness = [263, 263, 100] GN*m/rad,
            coupling = [[0, -22.5, 0], [22.5, 0, 0], [0, 0, 0]] GN/rad);
        output top = tower.at([0, 0, 80] m).x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A shaft in a hollow one: the bearing between them turns with a section.
    pub model Spools {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 10 mm);
        section pipe = tube(radius = 30 mm, thickness = 5 mm);
        body low { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 6 * beam(round, steel); }
        body high { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 6 * beam(pipe, steel); }
        joint inner = clamp(low.start, inertial);
        joint outer = clamp(high.start, inertial);
        spring bearing = bushing(low.end, high.end, stiffness = [0, 100, 200] kN/m, rotational_stiffness = [0, 1, 2] kN*m/rad);
        output y = low.end.y;
        output other = high.end.y;
        run { t_end = 0.1 s; every = 1 ms; }
    }
}

/// Rates of growth and frequencies of modes that swing, sorted by frequency.
fn swinging(model: &dyn AnyModel, count: usize) -> Vec<[f64; 2]> {
    let settings = EquilibriumSettings {
        count,
        ..EquilibriumSettings::default()
    };
    let found = modes(model, &settings).unwrap().modes;
    found
        .iter()
        .filter(|mode| mode.im > 0.0)
        .map(|mode| [mode.re, mode.im])
        .collect()
}

fn near(found: f64, want: f64, size: f64, tolerance: f64) {
    assert!((found - want).abs() <= tolerance * size, "{found} for {want}");
}

/// Eigenvalues of the 4 by 4 matrices (numpy): k = 3500 N/m, 250 N/m across, c = 17.5 N s/m at 150 rad/s.
#[test]
fn a_film_between_a_disc_and_a_pedestal() {
    let found = swinging(&Film::default(), 12);
    let want = [
        [-1.9885575, 38.85158601],
        [0.0, 38.90754],
        [-4.31824677, 39.05126648],
        [-3.47934205, 82.8346171],
        [-2.46385367, 83.03429757],
        [0.0, 83.28387],
    ];
    assert_eq!(found.len(), want.len());
    for ([re, im], [growth, frequency]) in found.iter().zip(want) {
        near(*re, growth, frequency, 1e-7);
        near(*im, frequency, frequency, 1e-7);
    }
}

/// `[m, m c; m c, I + m c^2]` and `[k, -K; -K, R]` in closed form.
#[test]
fn a_tower_on_soil() {
    let found = swinging(&Tower::default(), 6);
    let (m, c, inertia): (f64, f64, f64) = (6e5, 40.0, 3e8);
    let (k, coupling, turning) = (2.57e9, -22.5e9, 263e9);
    // det(K - w^2 M) = 0
    let a = m * inertia;
    let b = -(m * turning + k * (inertia + m * c * c) - 2.0 * coupling * m * c);
    let root = f64::sqrt(b * b - 4.0 * a * (k * turning - coupling * coupling));
    let [low, high] = [-1.0, 1.0_f64].map(|sign| ((-b + sign * root) / (2.0 * a)).sqrt());
    for (at, want) in [(0, low), (1, low), (3, high), (4, high)] {
        near(found[at][1], want, want, 1e-9);
        near(found[at][0], 0.0, want, 1e-9);
    }
    near(found[2][1], (10e9_f64 / m).sqrt(), 129.0, 1e-9);
    near(found[5][1], (100e9_f64 / 1e6).sqrt(), 316.0, 1e-9);
}

/// Timoshenko beams of 40 elements (numpy), one plane at a time.
#[test]
fn a_shaft_in_a_hollow_one() {
    let found = swinging(&Spools::default(), 6);
    let want = [260.11587, 275.00316, 421.09768, 441.21320, 766.20883, 892.10185];
    for ([re, im], want) in found.iter().zip(want) {
        near(*im, want, want, 1e-3);
        near(*re, 0.0, want, 1e-9);
    }
}
