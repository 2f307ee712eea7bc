//! Machines of the field against their closed forms: mechanisms, columns under following forces, ropes, a truss that snaps, impacts.

use rncf::app::{EquilibriumSettings, Range, RunError, RunSettings, campbell, modes, run, static_equilibria, steady};
use rncf::prelude::*;
use rncf_test_models::{Level, Struck};

use super::closed_forms::{assert_near, exponents, last};

rncf::model! {
    /// A satellite that gives its spin to a mass on a cord that unwinds (yo-yo).
    pub model YoYo {
        const w0 = 10 rad/s;
        const radius = 0.5 m;
        /// Inertia of hub and bob over that of the bob on the rim.
        const ratio = 17;
        const start = 0.1 m;
        const spin = w0 * (ratio * radius^2 - start^2) / (ratio * radius^2 + start^2);
        const turned = start / radius * 1 rad;
        const fast = spin + w0;
        rigid hub { plane xy; mass = 50 kg; inertia = 8 kg*m^2; speed = spin; }
        rigid reel { plane xy; mass = 1 g; inertia = 1e-9 kg*m^2; speed = fast; angle = turned; }
        rigid bob {
            plane xy;
            mass = 2 kg;
            origin = [radius * cos(turned) + start * sin(turned), radius * sin(turned) - start * cos(turned), 0];
            velocity = [
                -fast * (radius * sin(turned) - start * cos(turned)) + radius * w0 * sin(turned),
                fast * (radius * cos(turned) + start * sin(turned)) - radius * w0 * cos(turned),
                0
            ];
        }
        joint axle = revolute(inertial, hub);
        joint of_reel = revolute(inertial, reel);
        constraint tangent = bob.in(reel).x - radius;
        constraint cord = bob.in(reel).y + radius * (reel.angle - hub.angle);
        output spin_of_hub = hub.speed;
        output unwound = -bob.in(reel).y;
        run { t_end = 0.4 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A shaft that drives another one over a universal joint.
    pub model Cardan {
        const beta = 30 deg;
        const w = 10 rad/s;
        const inertia = 0.1 kg*m^2;
        rigid driving { mass = 1 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; angular_velocity = [w, 0, 0]; }
        rigid driven { mass = 1 kg; inertia = [inertia, inertia, inertia]; axis = z; angle = beta; angular_velocity = [w / cos(beta), 0, 0]; }
        joint bearing = revolute(inertial.at([0, 0, 0] m), driving, axis = x);
        joint motor = drive(bearing.angle, w * t);
        joint spider = universal(driving, driven.at([0, 0, 0] m), axis = y, cross = z);
        constraint level = driven.ex.z;
        constraint held = driven.ex.y - sin(beta);
        output speed = driven.angular_velocity.x;
        output torque = motor.moment.x;
        run { t_end = 2 s; every = 0.05 s; }
    }
}

rncf::model! {
    /// Two links on coil springs, 2 kg and 1 kg at their ends, under a force along the second one (Ziegler).
    pub model Ziegler {
        param load = 200 N;
        param damper = 0 N*m*s;
        const stiff = 100 N*m/rad;
        rigid lower { plane xy; mass = 1 g; inertia = 2 kg*m^2; }
        rigid upper { plane xy; mass = 1 kg; inertia = 1e-9 kg*m^2; origin = [1, 0, 0] m; center = [1, 0, 0] m; }
        joint foot = revolute(inertial, lower);
        joint knee = revolute(lower.at([1, 0, 0] m), upper);
        spring at_foot = torsional(foot, stiffness = stiff, damping = damper);
        spring at_knee = torsional(knee, stiffness = stiff, damping = damper);
        load jet = force(upper.at([1, 0, 0] m), [-load, 0 N, 0 N], in = upper);
        output lean = lower.angle;
    }
}

rncf::model! {
    /// A rope that hangs on one end.
    pub model Hanging {
        param n: count = 4;
        material thread { density = 8000 kg/m^3; young = 1 GPa; }
        section wire = circle(radius = 0.01 mm);
        body rope { spatial; line from [0, 0, 0] m to [0, 0, -2] m; mesh n * cable(wire, thread); }
        joint top = pin(rope.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output x = rope.end.x;
    }
}

rncf::model! {
    /// A rope that is slack at the start, with a weight.
    pub model Slack {
        param n: count = 20;
        material rubber { density = 8000 kg/m^3; young = 1 GPa; }
        section wire { area = pi * (1 mm)^2; second_moment = 1e-17 m^4; }
        body rope {
            planar xy;
            line from [0, 0, 0] m to [10, 0, 0] m;
            mesh n * cable(wire, rubber, axial = engineering, bending = exact);
            initial position [0.9 * x, -1.2 m * sin(pi * x / 10 [m]), 0 m];
        }
        joint left = pin(rope.start, inertial);
        joint right = pin(rope.end, inertial, at = [9, 0, 0] m);
        fixture weight on rope.at(3 m) { mass = 0.1 kg; }
        load weights = gravity([0, -9.81, 0] m/s^2);
        output pull = right.force;
    }
}

rncf::model! {
    /// Two flat bars that snap through (von Mises).
    pub model Truss {
        param load = 0.1 N;
        const height = 0.02 m;
        material soft { density = 1000 kg/m^3; young = 1 GPa; }
        section bar { area = 78.5 mm^2; second_moment = 1e-8 m^4; }
        body left { planar xy; line from [-1, 0, 0] m to [0 m, height, 0 m]; mesh 2 * cable(bar, soft, axial = engineering, bending = exact); }
        body right { planar xy; line from [0 m, height, 0 m] to [1, 0, 0] m; mesh 2 * cable(bar, soft, axial = engineering, bending = exact); }
        joint foot = pin(left.start, inertial);
        joint other = pin(right.end, inertial);
        joint top = share(left.end, right.start);
        load push = force(left.end, [0, -load, 0]);
        output y = left.end.y;
    }
}

/// The cord unwinds with the first spin, and the hub has lost all of its own when it is long enough.
#[test]
fn a_satellite_gives_its_spin_to_a_cord() {
    let row = last(&YoYo::default(), 1e-8).unwrap();
    let (long, rim) = (0.1 + 0.5 * 10.0 * 0.4, 17.0 * 0.25);
    assert_near(row[1], long, 1e-8);
    assert_near(row[0], 10.0 * (rim - long * long) / (rim + long * long), 1e-5);
}

/// tan(out) = tan(in) / cos(beta), and the power that goes in comes out.
#[test]
fn a_universal_joint_turns_unevenly() {
    let mut settings = RunSettings::default();
    settings.options.rtol = 1e-8;
    let history = run(&Cardan::default(), &settings).unwrap().history;
    let (w, cosine) = (10.0, (std::f64::consts::PI / 6.0).cos());
    for ((&t, speed), torque) in history.keys.iter().zip(history.column(0)).zip(history.column(1)) {
        let (sin, cos) = (w * t).sin_cos();
        let below = cosine * cosine * cos * cos + sin * sin;
        let wanted = w * cosine / below;
        let rate = -2.0 * w * wanted * sin * cos * (1.0 - cosine * cosine) / below;
        assert!((speed - wanted).abs() < 1e-4, "{t}: {speed} {wanted}");
        assert!(
            (torque.abs() - (0.1 * rate * wanted / w).abs()).abs() < 5e-3,
            "{t}: {torque}"
        );
    }
}

/// Flutter at (7/2 - sqrt 2) k / l, and with small equal dampers already at 41/28 k / l.
#[test]
fn a_column_under_a_following_force_flutters_and_damping_makes_it_worse() {
    let growth = |load: f64, damper: f64| {
        let found = exponents(&Ziegler { load, damper }, 2);
        found
            .iter()
            .map(|exponent| exponent.0)
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let flutter = 100.0 * (3.5 - 2_f64.sqrt());
    assert!(growth(flutter - 0.01, 0.0) < 1e-9 && growth(flutter + 0.01, 0.0) > 0.01);
    let damped = 100.0 * 41.0 / 28.0;
    assert!(growth(damped - 0.05, 0.01) < 0.0 && growth(damped + 0.05, 0.01) > 0.0);
}

/// Damping that is light makes it flutter there, too, however slowly it then grows: the diagram tells the load to what it says, at dampers of 1e-2 to 1e-6 of the
/// critical ones.
#[test]
fn lightly_damped_flutter_begins_where_its_damping_says() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 300.0,
        }),
        ..EquilibriumSettings::default()
    };
    for damper in [0.1, 1e-2, 1e-3, 1e-4, 2e-5] {
        let found = campbell(&Ziegler { load: 0.0, damper }, &settings).unwrap();
        let first = found
            .onsets
            .first()
            .unwrap_or_else(|| panic!("{damper}: nothing grows"));
        // In k/l, with masses 2 m and m: 41/28 + c^2 / (2 k m l^2).
        let exact = 100.0 * 41.0 / 28.0 + 0.5 * damper * damper;
        assert!(
            (first.key / exact - 1.0).abs() < 1e-6 && first.within < 1e-5 * exact,
            "{damper}: {first:?}"
        );
    }
}

/// Without loads it swings freely: no stiffness leads from rest to the equilibrium, whatever the mesh.
#[test]
fn a_rope_that_hangs_swings_as_bessel_says() {
    // Zeros of J0; few elements of Hermite's shape are stiffer, the boundary layer at the pin a little.
    let swing = |zero: f64| 0.5 * zero * (9.81_f64 / 2.0).sqrt();
    for (n, tolerance) in [(1, 1e-2), (2, 3e-3), (4, 2e-3), (20, 2e-3)] {
        let found = exponents(&Hanging { n }, 2);
        assert_near(found[0].1, swing(2.404825557695773), tolerance);
    }
    let found = exponents(&Hanging { n: 20 }, 4);
    assert_near(found[2].1, swing(5.520078110286311), 1e-2);
    assert!(steady(&Hanging { n: 3 }, &EquilibriumSettings::default()).is_ok());
    assert!(static_equilibria(&Hanging { n: 3 }, &EquilibriumSettings::default()).is_ok());
}

/// Whether the stiffness of the start is found singular is round-off and changes from mesh to mesh.
#[test]
fn a_level_cord_that_hangs_on_one_end_settles_whatever_the_mesh() {
    // Axial force EA e s of Green's strain e = (s^2 - 1)/2 carries what hangs below, with the stretch s.
    let stretch = |below: f64| {
        let pulled = 1150.0 * 9.81 * below / 2e6;
        (0..50).fold(1.0_f64, |s, _| {
            s - (0.5 * (s * s - 1.0) * s - pulled) / (1.5 * s * s - 0.5)
        })
    };
    let (parts, wide) = (100, 3.0 / 100.0);
    let length: f64 = (0..parts)
        .map(|part| {
            let at = |share: f64| stretch(wide * (f64::from(part) + share));
            wide / 6.0 * (at(0.0) + 4.0 * at(0.5) + at(1.0))
        })
        .sum();
    for n in [4, 15, 16, 17, 18, 19, 20, 24, 33] {
        let found = static_equilibria(&Level { n }, &EquilibriumSettings::default())
            .unwrap_or_else(|error| panic!("{n} elements: {error}"));
        let tip = [0, 1].map(|column| found.history.column(column).last().unwrap());
        assert!(tip[0].abs() < 1e-9, "{n} elements: {tip:?}");
        assert_near(-tip[1], length, 1e-6);
    }
}

/// Elastic catenary, integrated from one end by Simpson's rule.
#[test]
fn a_slack_rope_settles_to_a_catenary() {
    let found = static_equilibria(&Slack::default(), &EquilibriumSettings::default()).unwrap();
    let pull = [0, 1].map(|column| found.history.column(column).last().unwrap());
    let (stiff, weight, lump) = (
        1e9 * std::f64::consts::PI * 1e-6,
        8000.0 * 9.81 * std::f64::consts::PI * 1e-6,
        0.981,
    );
    let slope = |s: f64, beyond: bool| {
        let vertical = pull[1] - weight * (10.0 - s) - if beyond { 0.0 } else { lump };
        let tension = pull[0].hypot(vertical);
        [pull[0], vertical].map(|part| part / tension * (1.0 + tension / stiff))
    };
    let mut end = [0.0; 2];
    for (from, to, beyond) in [(0.0, 3.0, false), (3.0, 10.0, true)] {
        let (parts, wide) = (2000, (to - from) / 2000.0);
        for part in 0..parts {
            let at = |share: f64| slope(from + wide * (f64::from(part) + share), beyond);
            for i in 0..2 {
                end[i] += wide / 6.0 * (at(0.0)[i] + 4.0 * at(0.5)[i] + at(1.0)[i]);
            }
        }
    }
    assert!((end[0] - 9.0).abs() < 0.03 && end[1].abs() < 0.03, "{end:?}");
}

/// P = 2 EA (1 - l / l0) y / l. A load far beyond the limit leads to no equilibrium next to those before, whatever the steps.
#[test]
fn a_flat_truss_is_not_led_over_its_limit() {
    let truss = |load: f64| Truss { load };
    let (stiff, long) = (1e9 * 78.5e-6, 0.02_f64.hypot(1.0));
    let force = |y: f64| 2.0 * stiff * (1.0 - y.hypot(1.0) / long) * y / y.hypot(1.0);
    let found = static_equilibria(&truss(0.2), &EquilibriumSettings::default()).unwrap();
    let y = found.history.column(0).last().unwrap();
    assert_near(force(y), 0.2, 1e-6);
    let limit = (1..2000).map(|part| force(1e-5 * f64::from(part))).fold(0.0, f64::max);
    for load in [0.25, 1.0, 4.0, 30.0, 128.0, 400.0] {
        let ended = static_equilibria(&truss(load), &EquilibriumSettings::default());
        let Err(RunError::Equilibria(ended)) = ended else {
            panic!("{load} N: {:?}", ended.map(|found| found.history.column(0).last()))
        };
        let reached = load * ended.history.keys.last().unwrap();
        assert!(reached < limit, "{load}: {reached}");
        assert!(modes(&truss(load), &EquilibriumSettings::default()).is_err(), "{load}");
    }
}

/// It leaves the wall after 2 L / c with all its momentum, whatever the stiffness of the wall. Generalized-alpha does not
/// damp what rattles, and says that it does.
#[test]
fn a_bar_bounces_back_with_its_momentum() {
    let part = |stiff: f64, rtol: f64, method: Method| {
        let mut settings = RunSettings {
            method,
            ..RunSettings::default()
        };
        settings.options.rtol = rtol;
        let result = run(&Struck { stiff }, &settings).unwrap();
        let momentum: Vec<f64> = result.history.column(0).collect();
        let told = result.statistics.jumps.join(" ");
        (momentum.last().unwrap() / momentum[0], told.contains("`wall` rattles"))
    };
    for stiff in [1e9, 1e10, 1e11, 1e12, 1.02e12, 1.05e12, 2e12] {
        for (rtol, bound) in [(1e-4, 0.04), (1e-5, 0.03), (1e-6, 0.01)] {
            let (part, is_told) = part(stiff, rtol, Method::Radau);
            assert!((part + 1.0).abs() < bound, "{stiff} {rtol}: {part}");
            assert!((part + 1.0).abs() < 0.05 || is_told, "{stiff} {rtol}: {part}");
            assert!(!is_told || stiff > 1e9 || rtol < 1e-4, "{stiff} {rtol}");
        }
    }
    let (part, is_told) = part(1e12, 1e-6, Method::GeneralizedAlpha { rho_inf: 0.8 });
    assert!((part + 1.0).abs() < 0.05 || is_told, "{part}");
}

rncf::model! {
    /// Two equal double pendulums: one with a joint between its rods, one with the same as a constraint.
    pub model Twice {
        rigid upper { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0, 0, 0] m; center = [0.5, 0, 0] m; }
        rigid lower { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [1, 0, 0] m; center = [0.5, 0, 0] m; }
        rigid upper2 { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0, 0, 0] m; center = [0.5, 0, 0] m; }
        rigid lower2 { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [1, 0, 0] m; center = [0.5, 0, 0] m; }
        joint foot = revolute(inertial, upper);
        joint foot2 = revolute(inertial, upper2);
        joint knee = revolute(upper.at([1, 0, 0] m), lower.at([0, 0, 0] m));
        constraint knee2 = [upper2.at([1, 0, 0] m).x - lower2.x, upper2.at([1, 0, 0] m).y - lower2.y, 0 m];
        load weight = gravity([0, -9.81, 0] m/s^2);
        output first = lower.angle;
        output second = lower2.angle;
        output held = knee.force.x;
        output tied = knee2.multiplier;
        run { t_end = 0.5 s; every = 0.1 s; }
    }
}

/// A component of a constraint that is written as zero asks for nothing.
#[test]
fn a_loop_in_a_plane_closes_as_a_vector_with_a_zero() {
    let found = run(&Twice {}, &RunSettings::default()).unwrap().history;
    assert_eq!(found.columns.len(), 5, "{:?}", found.columns);
    for row in found.values.chunks(5) {
        assert!((row[0] - row[1]).abs() < 1e-6, "{row:?}");
        assert!((row[2].abs() - row[3].abs()).abs() < 1e-3, "{row:?}");
    }
}
