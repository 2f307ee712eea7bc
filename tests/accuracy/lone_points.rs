//! Scenes in which nothing has a length: the loads of a single point, or its distance from the origin, are all that sizes it.

use rncf::app::{EquilibriumSettings, Range, RunSettings, run, static_equilibria};

mod gap {
    rncf::model! {
        /// A plate of an electrostatic actuator, two micrometres from its electrode.
        pub model Gap {
            param voltage = 5; param stiffness = 1 N/m; param gap = 2 um; param area = 1e-8 m^2;
            const eps = 8.8541878128e-12 kg*m/s^2;
            rigid plate { plane xy; mass = 1e-9 kg; }
            constraint guide = plate.y;
            load field = force(plate, [eps / 2 * area * voltage^2 / (gap - plate.x)^2, 0, 0]);
            load coil = force(plate, [-stiffness * plate.x, 0, 0]);
            output x = plate.x;
            run { t_end = 1 ms; every = 2 us; }
        }
    }
}
use gap::Gap;

fn pull_in(model: &Gap) -> f64 {
    let eps = 8.854_187_812_8e-12;
    (8.0 * model.stiffness * model.gap.powi(3) / (27.0 * eps * model.area)).sqrt()
}

/// The plate is pulled in at `sqrt(8 k g^3 / (27 eps A))`, a third of the gap away; what increments of nanometres made of the way beyond was no equilibrium.
#[test]
fn a_plate_is_pulled_in_whatever_its_size() {
    for size in [1e-2, 1.0, 1e3, 1e6] {
        let area = Gap::default().area * f64::powi(size, 3);
        let model = Gap {
            gap: 2e-6 * size,
            area,
            ..Gap::default()
        };
        let most = pull_in(&model);
        let until = |share: f64| EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to: share * most,
            }),
            ..EquilibriumSettings::default()
        };
        let error = static_equilibria(&model, &until(1.01)).unwrap_err().to_string();
        let beyond: f64 = error
            .split("beyond voltage = ")
            .nth(1)
            .unwrap()
            .split(':')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        assert!((beyond / most - 1.0).abs() < 2e-5, "{size}: {error} for {most}");
        let near = static_equilibria(&model, &until(0.9)).unwrap();
        assert!(near.critical.is_empty() && near.warnings.is_empty(), "{size}: {near:?}");
        let alone = Gap {
            voltage: 0.9 * most,
            ..model.clone()
        };
        let alone = static_equilibria(&alone, &EquilibriumSettings::default()).unwrap();
        assert!(
            alone.critical.is_empty() && alone.warnings.is_empty(),
            "{size}: {alone:?}"
        );
        // u (1 - u)^2 = 0.9^2 4/27 with u = x / g
        let [way, alone] = [near, alone].map(|found| found.history.column(0).last().unwrap() / model.gap);
        let off = |u: f64| (u * (1.0 - u).powi(2) - 0.81 * 4.0 / 27.0).abs();
        assert!(off(way) < 1e-9 && off(alone) < 1e-9, "{size}: {way}, {alone}");
    }
}

mod stone {
    rncf::model! {
        /// A stone on springs, which starts next to the origin.
        pub model Stone {
            param beside = 0 m;
            rigid stone { plane xy; mass = 1 kg; origin = [beside, 0 m, 0 m]; }
            load pull = force(stone, [1 [N] - 100 [N/m] * stone.x - 1e3 [N/m^3] * stone.x^3, 0, 0]);
            load coil = force(stone, [0, -100 [N/m] * stone.y, 0]);
            output x = stone.x;
            run { t_end = 5 s; every = 0.05 s; }
        }
    }
}
use stone::Stone;

/// A start that is a round-off beside the origin is no length: it cost 1.3 million steps, and `static` refused.
#[test]
fn a_start_next_to_the_origin_says_nothing_of_lengths() {
    for beside in [0.0, 1e-3, 1e-6, 1e-9, 1e-12, 0.1 + 0.2 - 0.3, 1e-30] {
        let model = Stone { beside };
        let found = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
        let x = found.history.column(0).last().unwrap();
        assert!((100.0 * x + 1e3 * x.powi(3) - 1.0).abs() < 1e-12, "{beside} m: {x}");
        let ran = run(&model, &RunSettings::default()).unwrap();
        assert!(
            ran.statistics.steps < 1000,
            "{beside} m: {} steps",
            ran.statistics.steps
        );
        // The energy of what was at rest, 1 [N] x - 50 x^2 - 250 x^4, is that of its speed: x turns at the next root of it.
        let most = ran.history.column(0).fold(0.0, f64::max);
        assert!(beside > 1e-5 || (most - 0.02).abs() < 1e-4, "{beside} m: {most} m");
    }
}

mod opposed {
    rncf::model! {
        /// Two discs on axles, whose moments depend on each other's speed.
        pub model Opposed {
            param moment = 1 N*m; param drag = 1 N*m*s;
            rigid a { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            rigid b { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            joint axle = revolute(inertial, a);
            joint other = revolute(inertial, b);
            load first = moment(a, [0, 0, moment - drag * b.speed]);
            load second = moment(b, [0, 0, 2 * moment - drag * a.speed]);
            output w = a.speed;
            run { t_end = 1 s; }
        }
    }
}

/// It was a panic.
#[test]
fn what_runs_away_is_not_balanced() {
    let error = static_equilibria(&opposed::Opposed::default(), &EquilibriumSettings::default());
    let error = error.unwrap_err().to_string();
    assert!(
        error.contains("not balanced") && error.contains("rigid body `"),
        "{error}"
    );
}
