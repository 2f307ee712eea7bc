//! Contacts that are shorter than a step: what was passed is seen inside of a step, too.

use rncf::app::{Judging, RunSettings, run};
use rncf::{Method, Options};

mod ball {
    rncf::model! {
        /// A ball flies against a stiff wall, by a load, the law of a spring and a table.
        pub model Walls {
            param k = 1e9 N/m; param v = 0.3 m/s;
            table wall { at = d; d = [-10, 0, 1] m; f = [0, 0, 1] m; interpolation = linear; }
            rigid a { mass = 1 kg; velocity = [v, 0, 0]; }
            load stop = force(a, [-k * max(a.x - 0.1 [m], 0 m), 0, 0]);
            rigid b { mass = 1 kg; velocity = [v, 0, 0]; origin = [0, 1, 0] m; }
            spring bumper = law(b, inertial.at([10, 1, 0] m), force = -k * max(9.9 [m] - length, 0 m));
            rigid c { mass = 1 kg; velocity = [v, 0, 0]; origin = [0, 2, 0] m; }
            load looked = force(c, [-k * wall.f(c.x - 0.1 [m]), 0, 0]);
            output va = a.velocity.x;
            output vb = b.velocity.x;
            output vc = c.velocity.x;
            run { t_end = 0.6 s; every = 10 ms; }
        }
    }
}
use ball::Walls;

mod bar {
    rncf::model! {
        /// A rigid bar falls flat on a bed that only pushes, and a stone on a field that does.
        pub model Bed {
            param v = 1.3 m/s; param k = 1e9 N/m^2; param elements: count = 4;
            section strip { EA = 42 MN; EI = 350 N*m^2; mass = 1.57 kg/m; }
            rigid core { plane xy; mass = 1 g; inertia = 1e-4 kg*m^2; origin = [0, 0.1, 0] m; velocity = [0 [m/s], -v, 0 [m/s]]; }
            body bar in core { planar xy; line from [-0.5, 0, 0] m to [0.5, 0, 0] m; mesh elements * cable(strip, axial = engineering, bending = exact); rigid; }
            joint held = clamp(bar.start, core);
            load bed = distributed(bar, [0, k * max(-position.y, 0 m), 0]);
            output vy = total.momentum.y / total.mass;
            run { t_end = 0.5 s; every = 10 ms; }
        }
    }
}
use bar::Bed;

mod field {
    rncf::model! {
        /// A stone falls into a field that pushes below the ground alone.
        pub model Field {
            param v = 0.37 m/s; param k = 1e10 1/s^2;
            rigid stone { plane xy; mass = 1 kg; origin = [0, 0.1, 0] m; velocity = [0 [m/s], -v, 0 [m/s]]; }
            load ground = gravity([0, k * max(-position.y, 0 m), 0]);
            output vy = stone.velocity.y;
            run { t_end = 0.4 s; every = 10 ms; }
        }
    }
}
use field::Field;

mod row {
    rncf::model! {
        /// Balls in a row that touch each other to round-off, and one that strikes them.
        pub model Row {
            param radius = 5 mm;
            param stiff = 1e6 N/m;
            const n = 6;
            for i in 0..n {
                rigid ball[i] {
                    plane xy;
                    mass = (1 + 0.3*i) * 4 g;
                    origin = [2 * i * radius, 0 m, 0];
                    velocity = [if i < 0.5 { 2 [m/s] } else { 0 [m/s] }, 0 [m/s], 0];
                }
            }
            for i in 0..n - 1 {
                spring touch[i] = law(ball[i], ball[i + 1], force = -stiff * max(2 * radius - length, 0 m)^1.5 / sqrt(radius) * (1 - 0.05 [s/m] * rate));
            }
            for i in 0..n { output v[i] = ball[i].velocity.x; }
            run { t_end = 0.6 ms; every = 2 us; }
        }
    }
}
use row::Row;

fn settings(t_end: f64, method: Method, rtol: f64) -> RunSettings {
    RunSettings {
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        t_end: Some(t_end),
        judged: Judging::No,
        ..RunSettings::default()
    }
}

/// One step went into the wall and out again: 0.0687 m/s came back of 0.3, "differ by at most 1e-5".
#[test]
fn no_step_goes_through_a_wall_and_back() {
    for k in [1e7, 1e9, 1e11] {
        for t_end in [0.55, 0.59, 0.6, 0.61, 0.73, 1.0, 1.9, 3.0] {
            for method in [Method::Radau, Method::Radau9] {
                let model = Walls { k, ..Walls::default() };
                let found = run(&model, &settings(t_end, method, 1e-6)).unwrap();
                let row = found.history.values.rchunks(3).next().unwrap();
                for v in row {
                    assert!((v + 0.3).abs() < 1e-4, "{k} N/m, {t_end} s, {method:?}: {row:?}");
                }
            }
        }
    }
}

/// What acts along a body, and gravity of the place, had no kinks: 472 kJ came of 0.785 J.
#[test]
fn what_falls_flat_leaves_with_its_speed() {
    for (k, v, t_end) in [
        (1e12, 1.0, 0.4),
        (1e9, 1.3, 1.5),
        (1e10, 1.2, 1.3),
        (1e7, 0.362, 0.941),
        (1e12, 0.25, 0.65),
    ] {
        let model = Bed { k, v, ..Bed::default() };
        let found = run(&model, &settings(t_end, Method::Radau, 1e-6)).unwrap();
        let left = found.history.values.last().unwrap();
        assert!((left / v - 1.0).abs() < 1e-4, "{k} N/m^2, {v} m/s: {left}");
        assert!(found.statistics.restarts >= 2, "{:?}", found.statistics);
    }
    for (k, v) in [(1e10, 0.37), (1e12, 0.37), (1e11, 1.1)] {
        let found = run(&Field { k, v }, &settings(0.4, Method::Radau, 1e-6)).unwrap();
        let left = found.history.values.last().unwrap();
        assert!((left / v - 1.0).abs() < 1e-4, "{k} 1/s^2, {v} m/s: {left}");
    }
}

/// A wave runs through what touches to round-off: the kinks that lie before each other are left to the control of the error
/// after some dozens, also where every second step ends at one.
#[test]
fn what_touches_to_round_off_takes_few_steps() {
    for rtol in [1e-5, 1e-6, 1e-7] {
        let found = run(&Row::default(), &settings(0.6e-3, Method::Radau, rtol)).unwrap();
        assert!(found.statistics.steps < 200, "{rtol}: {}", found.statistics.steps);
        let masses: Vec<f64> = (0..6).map(|i| (1.0 + 0.3 * f64::from(i)) * 4e-3).collect();
        let last: Vec<f64> = (0..6).map(|i| found.history.column(i).last().unwrap()).collect();
        let momentum: f64 = masses.iter().zip(&last).map(|(m, v)| m * v).sum();
        assert!((momentum / 8e-3 - 1.0).abs() < 1e-9, "{rtol}: {momentum}");
        // By scipy's DOP853 with a tolerance of 1e-12.
        let expected = [-0.3118207, -0.1786758, 0.5454506, 0.8047548, 0.06447533, 0.0001993774];
        for (v, expected) in last.iter().zip(expected) {
            assert!((v - expected).abs() < 3e-3, "{rtol}: {last:?}");
        }
    }
}

mod links {
    rncf::model! {
        /// Two links, the second with a damper that acts in one direction, beyond 1 rad/s.
        pub model Links {
            rigid a { plane xy; mass = 1 kg; inertia = 0.01 kg*m^2; center = [0.2, 0, 0] m; speed = 8 rad/s; }
            rigid b {
                plane xy; mass = 1 kg; inertia = 0.01 kg*m^2; origin = [0.4, 0, 0] m; center = [0.2, 0, 0] m;
                speed = 8 rad/s; velocity = [0, 3.2, 0] m/s;
            }
            joint shoulder = revolute(inertial.at([0, 0, 0] m), a);
            joint elbow = revolute(a.at([0.4, 0, 0] m), b);
            load weight = gravity([0, -9.81, 0] m/s^2);
            spring damper = torsional_law(elbow, moment = 0.2 [N*m*s] * max(rate - 1 [rad/s], 0 [rad/s]));
            output angle = a.angle; output speed = a.speed;
            run { t_end = 4 s; every = 0.1 s; }
        }
    }
}

/// Kinks of rates, beside joints: Lagrange's equations in the two angles, integrated by scipy (DOP853, 1e-11), are at 28.05164616 rad and 8.66372909 rad/s.
#[test]
fn a_damper_of_one_direction_acts_between_links() {
    for (method, rtol, bound) in [
        (Method::Radau, 1e-6, 1e-4),
        (Method::Radau, 1e-8, 1e-5),
        (Method::Radau9, 1e-8, 1e-5),
    ] {
        let settings = RunSettings {
            method,
            options: Options {
                rtol,
                ..Options::default()
            },
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = run(&links::Links {}, &settings).unwrap();
        let last = [0, 1].map(|column| found.history.column(column).last().unwrap());
        let off = (last[0] - 28.051_646_16).abs().max((last[1] - 8.663_729_09).abs());
        assert!(off < bound, "{method:?} {rtol}: {last:?}");
        assert!(found.statistics.steps < 2000, "{}", found.statistics.steps);
    }
}

mod detent {
    rncf::model! {
        /// A spring with a preload of 1 N that changes its sign within 2 um.
        pub model Detent {
            const width = 1 um;
            rigid bob { plane xy; mass = 1 kg; origin = [1, 0, 0] m; }
            spring s = coordinate_law(bob.x, force = 10 [N/m] * value + 1 [N] * min(max(value / width, -1), 1));
            output x = bob.x;
            run { t_end = 100 s; every = 0.1 s; }
        }
    }
}

/// Two cosines a quarter of a period: about -0.1 m, and a stiff one within the width.
#[test]
fn a_force_between_two_kinks_does_its_work() {
    let (slow, fast, width) = (10.0_f64.sqrt(), (10.0_f64 + 1e6).sqrt(), 1e-6_f64);
    let outside = ((width + 0.1) / 1.1).acos() / slow;
    let speed = 1.1 * slow * (slow * outside).sin();
    let quarter = outside + (width * fast / speed).atan() / fast;
    let exact = |t: f64| {
        let phase = t % (4.0 * quarter);
        let back = (2.0 * quarter - phase).abs();
        let from_end = if back > quarter { 2.0 * quarter - back } else { back };
        let sign = if back > quarter { 1.0 } else { -1.0 };
        let x = match from_end {
            r if r <= outside => 1.1 * (slow * r).cos() - 0.1,
            r => width * (fast * (r - outside)).cos() - speed / fast * (fast * (r - outside)).sin(),
        };
        sign * x
    };
    for (method, rtol, bound) in [
        (Method::Radau, 1e-6, 2e-5),
        (Method::Radau, 1e-7, 2e-6),
        (Method::Radau13, 1e-6, 2e-5),
    ] {
        let settings = RunSettings {
            method,
            options: Options {
                rtol,
                ..Options::default()
            },
            ..RunSettings::default()
        };
        let found = run(&detent::Detent {}, &settings).unwrap();
        let off = found.history.keys.iter().zip(found.history.column(0));
        let off = off.map(|(&t, x)| (x - exact(t)).abs()).fold(0.0, f64::max);
        assert!(off < bound, "{method:?} {rtol}: {off}");
    }
}

mod switch {
    rncf::model! {
        /// A force of 1 N that changes its sign within 2 nm, for a thousand seconds.
        pub model Switch {
            rigid bob { plane xy; mass = 1 kg; origin = [1, 0, 0] m; }
            spring s = coordinate_law(bob.x, force = 1 [N] * min(max(value / 1 [nm], -1), 1));
            output x = bob.x;
            run { t_end = 1000 s; every = 1 s; }
        }
    }
}

/// Parabolas: the nanometres change the period by their square. However long a run is, what is passed at its own speed is met.
#[test]
fn kinks_a_nanosecond_apart_are_met_in_a_long_run() {
    let quarter = 2.0_f64.sqrt();
    let exact = |t: f64| {
        let phase = t % (4.0 * quarter);
        let back = (2.0 * quarter - phase).abs();
        match back > quarter {
            true => 1.0 - 0.5 * (2.0 * quarter - back).powi(2),
            false => 0.5 * back * back - 1.0,
        }
    };
    for (rtol, bound) in [(1e-6, 1e-4), (1e-8, 1e-7)] {
        let found = run(&switch::Switch::default(), &settings(1000.0, Method::Radau, rtol)).unwrap();
        let rows = found.history.keys.iter().zip(found.history.column(0));
        let off = rows.map(|(t, x)| (x - exact(*t)).abs()).fold(0.0, f64::max);
        println!("{rtol:e}: {off:.1e}");
        assert!(off < bound, "{rtol:e}: {off:e}");
    }
}
