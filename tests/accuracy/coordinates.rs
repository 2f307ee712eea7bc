//! Springs along coordinates of one's own, against closed forms.

use rncf::app::{EquilibriumSettings, RunSettings, modes, run, static_equilibria};
use rncf::{Method, Options};

mod train {
    rncf::model! {
        /// Three discs that turn about one axis; the shafts between them are springs.
        pub model Train {
            for i in 0..3 {
                frame turned[i] = hinged(axis = [0, 0.6, 0.8], speed = 3 [rad/s] * (1 - i) * (2 - i) / 2);
                fixture disc[i] on turned[i] { mass = 1 kg; inertia = [2, 2, 2] kg*m^2; }
            }
            for i in 0..2 {
                spring shaft[i] = coordinate(turned[i + 1].angle - turned[i].angle, stiffness = 600 N*m/rad);
            }
            output last = turned[2].angle;
            output torque = shaft[0].moment;
            output energy = total.kinetic_energy + sum(i in 0..2, shaft[i].energy);
            run { t_end = 2 s; every = 0.02 s; }
        }
    }
}

mod sundry {
    rncf::model! {
        /// Two gears with elastic teeth, a slide on a driven spring, one with a damper, one that meets a stop; two beams whose ends push
        /// each other.
        pub model Sundry {
            rigid pinion { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; origin = [1, 0, 0] m; }
            rigid wheel { mass = 1 kg; inertia = [3, 3, 4] kg*m^2; origin = [0, 3, 0] m; }
            joint fast = revolute(inertial.at([1, 0, 0] m), pinion, axis = z);
            joint slow = revolute(inertial.at([0, 3, 0] m), wheel, axis = [0, 0, 2]);
            spring teeth = coordinate(2 * fast.angle + slow.angle, stiffness = 50 N*m/rad, value = 5 deg);
            for i in 0..3 {
                rigid slider[i] {
                    plane xy; mass = 2 kg; inertia = 1 kg*m^2; origin = [0, i * 1 m, 0 m];
                    velocity = [i * 1 [m/s], 0, 0];
                }
                joint guide[i] = prismatic(inertial.at([0 m, i * 1 m, 0 m]), slider[i], axis = x);
            }
            spring driven = coordinate(guide[0].slide - 10 mm * sin(7 [rad/s] * t), stiffness = 200 N/m);
            spring damped = coordinate(guide[1].slide, stiffness = 200 N/m, damping = 4 N*s/m);
            spring stop = coordinate_law(guide[2].slide, force = 800 [N/m] * max(value - 1 m, 0 m));
            output fast_angle = fast.angle;
            output driven_x = guide[0].slide;
            output damped_x = guide[1].slide;
            output stopped_x = guide[2].slide;
            output stopped_rate = stop.rate;
            run { t_end = 2 s; every = 0.02 s; }
        }
    }
}

mod beams {
    rncf::model! {
        /// Two clamped beams whose ends push each other; the first is loaded.
        pub model Beams {
            material steel { density = 7850 kg/m^3; young = 200 GPa; }
            section thin { area = 100 mm^2; second_moment = 1000 mm^4; }
            for i in 0..2 {
                body arm[i] { planar xy; line from [0 m, i * 1 m, 0 m] to [2 m, i * 1 m, 0 m]; mesh 2 * cable(thin, steel); }
                joint root[i] = clamp(arm[i].start, inertial);
            }
            spring between = coordinate(arm[0].end.y + arm[1].end.y - 1 m, stiffness = 150 N/m);
            load pull = force(arm[0].end, [0, 0.01, 0] N);
            output first = arm[0].end.y;
            output second = arm[1].end.y - 1 m;
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
}

fn settings(method: Method, rtol: f64) -> RunSettings {
    RunSettings {
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        ..RunSettings::default()
    }
}

/// The modes of three equal discs have the forms (1, 1, 1), (1, 0, -1), (1, -2, 1) and the squares 0, 1 and 3 of `k / J`.
#[test]
fn a_train_of_discs_turns_and_vibrates() {
    let model = train::Train::default();
    let found = modes(&model, &EquilibriumSettings::default()).unwrap();
    let frequencies: Vec<f64> = found.modes.iter().map(|mode| mode.im).collect();
    let [one, three] = [300_f64.sqrt(), 900_f64.sqrt()];
    assert!(frequencies[0] == 0.0, "{frequencies:?}");
    for (found, exact) in frequencies[1..].iter().zip([one, three]) {
        assert!((found - exact).abs() < 1e-9 * exact, "{found} for {exact}");
    }
    for (method, rtol, bound) in [(Method::Radau, 1e-7, 1e-5), (Method::Hht { alpha: -0.05 }, 1e-7, 5e-3)] {
        let result = run(&model, &settings(method, rtol)).unwrap();
        let history = &result.history;
        for (row, &t) in history.keys.iter().enumerate() {
            let (slow, quick) = ((one * t).sin() / one, (three * t).sin() / three);
            let exact = [t - 1.5 * slow + 0.5 * quick, -600.0 * (1.5 * slow + 1.5 * quick), 9.0];
            for ((name, exact), size) in ["last", "torque", "energy"].iter().zip(exact).zip([2.0, 60.0, 9.0]) {
                let found = history.column(history.find(name).unwrap()).nth(row).unwrap();
                assert!(
                    (found - exact).abs() < bound * size,
                    "{method:?} {name} at {t}: {found} for {exact}"
                );
            }
        }
    }
}

/// Of `2 a + b` the inertia is `1 / (4 / 1 + 1 / 4)`; a driven spring leads to two sines, a damper to one that dies away, and a stop turns back what
/// has spent half a period in it.
#[test]
fn gears_drives_dampers_and_stops_follow_their_closed_forms() {
    let result = run(&sundry::Sundry::default(), &settings(Method::Radau, 1e-8)).unwrap();
    let history = &result.history;
    let rate = (50.0 * 4.25_f64).sqrt();
    let (own, damping) = (10.0_f64, 1.0_f64);
    let (decayed, part) = ((own * own - damping * damping).sqrt(), 0.7);
    let stop = 20.0_f64;
    for (row, &t) in history.keys.iter().enumerate() {
        let pushed = 5_f64.to_radians() * (1.0 - (rate * t).cos());
        let inside = t - 0.5;
        let [stopped, stopped_rate] = match inside {
            ..0.0 => [2.0 * t, 2.0],
            _ if stop * inside < std::f64::consts::PI => {
                [1.0 + 2.0 / stop * (stop * inside).sin(), 2.0 * (stop * inside).cos()]
            }
            _ => [1.0 - 2.0 * (inside - std::f64::consts::PI / stop), -2.0],
        };
        let exact = [
            pushed * 2.0 / 4.25,
            0.01 / (1.0 - part * part) * ((part * own * t).sin() - part * (own * t).sin()),
            (-damping * t).exp() * (decayed * t).sin() / decayed,
            stopped,
            stopped_rate,
        ];
        for (column, exact) in exact.into_iter().enumerate() {
            let found = history.column(column).nth(row).unwrap();
            let name = &history.columns[column].name;
            assert!((found - exact).abs() < 2e-6, "{name} at {t}: {found} for {exact}");
        }
    }
}

/// By the flexibility `L^3 / 3EI` of both ends.
#[test]
fn the_ends_of_two_beams_push_each_other() {
    let found = static_equilibria(&beams::Beams::default(), &EquilibriumSettings::default()).unwrap();
    let (own, between) = (3.0 * 200.0 / 8.0, 150.0_f64);
    let first: f64 = 0.01 / (own + between * own / (own + between));
    for (name, exact) in [("first", first), ("second", -between / (own + between) * first)] {
        let found = found.history.column(found.history.find(name).unwrap()).last().unwrap();
        assert!(
            (found - exact).abs() < 1e-5 * exact.abs(),
            "{name}: {found} for {exact}"
        );
    }
}
