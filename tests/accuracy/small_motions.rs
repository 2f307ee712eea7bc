//! What judged runs tell of motions that are small beside their coordinates, against closed forms.

use rncf::app::{Judging, RunResult, RunSettings, run};
use rncf::prelude::*;

rncf::model! {
    /// A mass on springs in a hall that stands far from the origin.
    pub model Hall {
        param far = 5e6 m;
        param v = 10 mm/s;
        frame hall = moving(origin = [far, 0 m, 0 m]);
        rigid bob in hall { mass = 1 kg; velocity = [v, v, 0]; }
        spring k = bushing(bob, hall, stiffness = [1, 1, 1] kN/m);
        output x: um = bob.in(hall).x;
        output y: um = bob.in(hall).y;
        run { t_end = 1 s; every = 5 ms; }
    }
}

rncf::model! {
    /// Two modules in low orbit with a spring between them.
    pub model Docked {
        const mu = 3.986004418e14 m^3/s^2;
        param k = 4 kN/m;
        const r0 = 7e6 m;
        rigid station { mass = 1000 kg; origin = [r0, 0, 0]; velocity = [0, 7546.05329, 0] m/s; }
        rigid probe { mass = 1000 kg; origin = [r0, 0, 2.0005 m]; velocity = [0, 7546.05329, 0] m/s; }
        spring s = linear(station, probe, stiffness = k, length = 2 m);
        load earth = gravity(-mu * position / norm(position)^3);
        output dz: mm = probe.z - station.z - 2 m;
        output f: mN = s.force;
        run { t_end = 200 s; every = 1 s; }
    }
}

fn judged(model: &impl Model, rtol: f64) -> RunResult {
    let mut settings = RunSettings {
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    settings.options.rtol = rtol;
    run(model, &settings).unwrap()
}

/// How far the first output is from its closed form, as a part of its largest value, and whether a note tells of it.
fn off(found: &RunResult, name: &str, exact: impl Fn(f64) -> f64) -> (f64, bool) {
    let values = || found.history.keys.iter().zip(found.history.column(0));
    let largest = values().map(|(_, value)| value.abs()).fold(0.0, f64::max);
    let away = values().map(|(&t, value)| (value - exact(t)).abs()).fold(0.0, f64::max);
    let is_told = found.warnings.iter().any(|note| note.contains(&format!("`{name}` by")));
    (away / largest, is_told)
}

/// Of 0.3 mm at 5000 km, 30 nm at 100 km and 0.1 nm at 1 m the steps keep little: told as 7e-9, 4e-11 and 1e-8 of the largest change.
#[test]
fn a_motion_below_the_tolerance_of_its_place_is_told_as_lost() {
    for (far, v) in [(5e6, 0.01), (1e5, 1e-6), (1.0, 3e-9)] {
        let found = judged(&Hall { far, v }, 1e-6);
        let w = 1000.0_f64.sqrt();
        let (off, is_told) = off(&found, "x", |t| 1e6 * v * (w * t).sin() / w);
        assert!(
            off > 0.1 && is_told,
            "{far} {v}: {off}, {:?} {:?}",
            found.warnings,
            found.agreement
        );
    }
}

/// The spring vibrates by half a millimetre at 7000 km: 7 % off at the end, told as 4e-8.
#[test]
fn a_spring_between_two_in_orbit_is_told_as_off() {
    // z'' = -(2 k / m) z - mu / r^3 (2 m + z).
    let (k, tide) = (4000.0, 3.986_004_418e14 / 7e6_f64.powi(3));
    let square = 2.0 * k / 1000.0 + tide;
    let rest = -2.0 * tide / square;
    let exact = |t: f64| 1e3 * (rest + (5e-4 - rest) * (square.sqrt() * t).cos());
    let coarse = judged(&Docked { k }, 1e-6);
    let (part, is_told) = off(&coarse, "dz", exact);
    assert!(
        part > 0.03 && is_told,
        "{part}, {:?} {:?}",
        coarse.warnings,
        coarse.agreement
    );
    let fine = judged(&Docked { k }, 1e-10);
    let (part, is_told) = off(&fine, "dz", exact);
    assert!(
        part < 1e-3 && !is_told,
        "{part}, {:?} {:?}",
        fine.warnings,
        fine.agreement
    );
}
