//! States: what controllers, filters and lags remember, against closed forms.

use rncf::app::{EquilibriumSettings, Range, RunResult, RunSettings, campbell, modes, run, static_equilibria};
use rncf::linalg::c64;
use rncf::prelude::*;

rncf::model! {
    /// An arm that a PID controller holds against its weight.
    pub model Held {
        param kp = 60 N*m/rad;
        param ki = 80 N*m/s;
        param kd = 8 N*m*s;
        param wanted = 40 deg;
        rigid arm { plane xy; mass = 2 kg; inertia = 0.1 kg*m^2; center = [0.5, 0, 0] m; origin = [0, 0, 0] m; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), arm.at([0, 0, 0] m));
        load weight = gravity([0, -9.81, 0] m/s^2);
        state error = integral(wanted - hinge.angle, start = 0 [rad*s]);
        load motor = moment(arm, [0, 0, kp * (wanted - hinge.angle) + ki * error - kd * hinge.rate]);
        output angle = hinge.angle;
        output windup = error;
    }
}

rncf::model! {
    /// A wheel with friction behind a motor whose moment lags; how far it has turned, what the motor has done, and what is lost.
    pub model Lagging {
        param lag = 0.1 s;
        param most = 3 N*m;
        param friction = 0.05 N*m*s/rad;
        rigid wheel { plane xy; mass = 2 kg; inertia = 0.1 kg*m^2; origin = [0, 0, 0] m; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), wheel.at([0, 0, 0] m));
        spring bearing = torsional(hinge, stiffness = 0 [N*m/rad], damping = friction);
        state pull = integral((most - pull) / lag, start = 0 N*m);
        state turned = integral(hinge.rate, start = 1 rad);
        state work = integral(pull * hinge.rate, start = 0 J);
        state loss = integral(bearing.moment * hinge.rate, start = 0 J);
        load motor = moment(wheel, [0, 0, pull]);
        output angle = hinge.angle;
        output speed = hinge.rate;
        output moment = pull;
        output way = turned;
        output done = work;
        output lost = loss;
        run { t_end = 5 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A bob on a spring, and how far it has been to the right, summed over time.
    pub model Summed {
        param k = 50 N/m;
        rigid bob { plane xy; mass = 2 kg; inertia = 1 kg*m^2; origin = [1, 0, 0] m; }
        joint slide = prismatic(inertial, bob, axis = x);
        spring coil = linear(inertial.at([-1, 0, 0] m), bob, stiffness = k, length = 1 m);
        state right = integral(max(bob.x, 0 m), start = 0 [m*s]);
        output x = bob.x;
        output sum = right;
    }
}

fn tight() -> RunSettings {
    RunSettings {
        options: Options {
            rtol: 1e-8,
            ..Options::default()
        },
        ..RunSettings::default()
    }
}

/// A column of a run by the name of its output.
fn column(result: &RunResult, name: &str) -> Vec<f64> {
    let index = result.history.find(name).unwrap();
    result.history.column(index).collect()
}

rncf::model! {
    /// A bob that hangs on a spring, and the impulse of that.
    pub model Hung {
        rigid bob { plane xy; mass = 2 kg; inertia = 1 kg*m^2; origin = [0, -1, 0] m; }
        joint slide = prismatic(inertial.at([0, -1, 0] m), bob, axis = y);
        spring coil = linear(inertial.at([0, 0, 0] m), bob, stiffness = 500 N/m, length = 1 m);
        load weight = gravity([0, -9.81, 0] m/s^2);
        state impulse = integral(coil.force, start = 0 [N*s]);
        output y = bob.y;
        output sum = impulse;
    }
}

const INERTIA: f64 = 0.1 + 2.0 * 0.5 * 0.5;

/// What the weight takes of the stiffness about the hinge, at the wanted angle, N m/rad.
fn softened(model: &Held) -> f64 {
    2.0 * 9.81 * 0.5 * model.wanted.sin()
}

/// At rest the integral alone carries the weight, and the angle is the wanted one.
#[test]
fn a_controller_rests_where_its_integral_carries_the_weight() {
    let model = Held::default();
    let result = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
    let last = &result.history.values[result.history.values.len() - 2..];
    let integral = 2.0 * 9.81 * 0.5 * model.wanted.cos() / model.ki;
    assert!((last[0] / model.wanted - 1.0).abs() < 1e-9, "{last:?}");
    assert!((last[1] / integral - 1.0).abs() < 1e-9, "{last:?} is not {integral}");
    assert!(result.critical.is_empty(), "{:?}", result.critical);
    assert_eq!(result.warnings, [""; 0]);
}

/// `I s^3 + kd s^2 + (kp - softened) s + ki = 0`.
#[test]
fn a_controlled_arm_has_the_roots_of_its_polynomial() {
    let model = Held::default();
    let found = modes(&model, &EquilibriumSettings::default()).unwrap();
    assert_eq!(found.modes.len(), 2);
    let stiffness = model.kp - softened(&model);
    for mode in &found.modes {
        let s = c64::new(mode.re, mode.im);
        let terms = [
            INERTIA * s * s * s,
            model.kd * s * s,
            stiffness * s,
            c64::new(model.ki, 0.0),
        ];
        let size: f64 = terms.iter().map(|term| term.norm()).sum();
        assert!(terms.iter().sum::<c64>().norm() < 1e-10 * size, "{s}");
    }
}

/// Routh: it begins to swing where `ki I = kd (kp - softened)`.
#[test]
fn too_much_integral_swings() {
    let model = Held {
        kd: 1.0,
        ..Held::default()
    };
    let limit = model.kd * (model.kp - softened(&model)) / INERTIA;
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 1,
            from: 40.0,
            to: 160.0,
        }),
        ..EquilibriumSettings::default()
    };
    let found = campbell(&model, &settings).unwrap();
    let [onset] = &found.onsets[..] else {
        panic!("{} onsets", found.onsets.len());
    };
    assert!((onset.key / limit - 1.0).abs() < 1e-6, "{} is not {limit}", onset.key);
}

/// A first-order lag in front of a first-order wheel, and the balance of work.
#[test]
fn a_lag_is_a_lag() {
    let model = Lagging::default();
    let settings = tight();
    let result = run(&model, &settings).unwrap();
    let [angle, speed, moment, way, done, lost] =
        ["angle", "speed", "moment", "way", "done", "lost"].map(|name| column(&result, name));
    let (slow, fast) = (0.1 / model.friction, model.lag);
    for (row, t) in result.history.keys.iter().enumerate() {
        let exact = model.most * (1.0 - (-t / fast).exp());
        assert!(
            (moment[row] - exact).abs() < 1e-7 * model.most,
            "at {t} s: {} is not {exact}",
            moment[row]
        );
        let lagged = (slow * (-t / slow).exp() - fast * (-t / fast).exp()) / (slow - fast);
        let exact = model.most / model.friction * (1.0 - lagged);
        assert!(
            (speed[row] - exact).abs() < 1e-6 * 60.0,
            "at {t} s: {} is not {exact}",
            speed[row]
        );
        assert!((way[row] - angle[row] - 1.0).abs() < 1e-6 * 60.0, "at {t} s");
        let kept = done[row] - lost[row] - 0.05 * speed[row] * speed[row];
        assert!(kept.abs() < 1e-6 * 60.0, "at {t} s: {kept} J");
    }
}

/// Steps end at the kinks of a rate: five half waves of a cosine.
#[test]
fn an_integral_of_what_has_kinks_is_exact() {
    let model = Summed::default();
    let w = (model.k / 2.0).sqrt();
    let period = 2.0 * std::f64::consts::PI / w;
    let settings = RunSettings {
        t_end: Some(5.0 * period),
        every: Some(period),
        ..tight()
    };
    let result = run(&model, &settings).unwrap();
    let sum = column(&result, "sum");
    let exact = 5.0 * 2.0 / w;
    assert!(
        (sum.last().unwrap() / exact - 1.0).abs() < 1e-7,
        "{sum:?} is not {exact}"
    );
}

/// Methods of second order say that they have no place for it.
#[test]
fn methods_of_second_order_refuse_states() {
    let settings = RunSettings {
        method: Method::Hht { alpha: -0.05 },
        ..RunSettings::default()
    };
    let message = run(&Held::default(), &settings).unwrap_err().to_string();
    assert!(
        message.contains("state `error` has one of first order: take `radau`"),
        "{message}"
    );
}

/// A state has no place: frames and signs of a picture are those of what moves.
#[test]
fn pictures_know_nothing_of_states() {
    let scene = Summed::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    assert_eq!(scene.frame_names(), ["inertial", "bob"]);
    let signs = scene.signs();
    let names: Vec<&str> = signs.iter().map(|sign| sign.name.as_str()).collect();
    assert!(names.contains(&"coil") && !names.contains(&"right"), "{names:?}");
}

/// The impulse of what carries a weight grows for ever, and nothing minds.
#[test]
fn a_state_that_keeps_books_may_go_on() {
    let found = static_equilibria(&Hung::default(), &EquilibriumSettings::default()).unwrap();
    let y = found.history.column(0).last().unwrap();
    assert!((y + 1.0 + 2.0 * 9.81 / 500.0).abs() < 1e-9, "{y}");
    assert!(
        found
            .warnings
            .iter()
            .any(|told| told.contains("nothing holds state `impulse`"))
    );
}
