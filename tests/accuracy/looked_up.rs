//! Tables that forces, moments and laws of springs look up, against closed forms.

use rncf::app::{Judging, RunSettings, run};
use rncf::{Method, Options};

rncf::model! {
    /// A wheel with play between two stops, one that a measured torque drives, and a stone that passes a cam.
    pub model LookedUp {
        table play { at = angle; angle = [-2, -0.1, 0.1, 2] rad; moment = [-190, 0, 0, 190] N*m; interpolation = linear; }
        table measured { at = time; time = [0, 1, 1.01, 1.02, 3] s; torque = [0, 0, 50, 0, 0] N*m; interpolation = linear; }
        table cam { at = s; s = [-60, -10.01, -10, -9.99, 20] m; push = [0, 0, 1000, 0, 0] N; interpolation = linear; }
        param wind: table = file("accuracy/data/gust.csv", at = time);
        rigid loose { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; speed = 5 rad/s; }
        joint axle = revolute(inertial.at([0, 0, 0] m), loose);
        spring stops = torsional_law(axle, moment = play.moment(angle));
        rigid driven { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0, 5, 0] m; }
        load motor = moment(driven, [0, 0, measured.torque(t)]);
        rigid stone { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [-50, 0, 0] m; velocity = [30, 0, 0] m/s; }
        load follower = force(stone, [0, cam.push(stone.x), 0]);
        rigid leaf { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0, 8, 0] m; }
        load gust = force(leaf, [wind.push(t), 0, 0]);
        output turn = loose.angle;
        output speed = loose.speed;
        output driven_speed = driven.speed;
        output stone_y = stone.y;
        output leaf_x = leaf.x;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

/// The loose wheel is free for 0.2 rad and swings at its stops with the frequency `sqrt(100 / 0.1)`; the others get the areas of triangles.
#[test]
fn tables_are_looked_up_by_what_moves_and_by_time() {
    for (method, rtol, bound) in [(Method::Radau, 1e-6, 1e-5), (Method::Hht { alpha: -0.05 }, 1e-7, 2e-3)] {
        let (free, swing) = (0.2 / 5.0, std::f64::consts::PI / 1000_f64.sqrt());
        let settings = RunSettings {
            method,
            options: Options {
                rtol,
                ..Options::default()
            },
            t_end: Some(10.0 * (free + swing)),
            every: Some(free + swing),
            ..RunSettings::default()
        };
        let result = run(&LookedUp::default(), &settings).unwrap();
        let end = result.settings.t_end.unwrap();
        let exact = [
            0.0,
            5.0,
            5.0,
            1000.0 * 0.01 / 30.0 * (end - 40.0 / 30.0),
            2.0 * 0.1 * (end - 0.5),
        ];
        for (column, exact) in exact.into_iter().enumerate() {
            let found = result.history.column(column).last().unwrap();
            println!(
                "{method:?} {}: {found} for {exact}",
                result.history.columns[column].name
            );
            assert!(
                (found - exact).abs() < bound * 5.0,
                "{method:?} {column}: {found} for {exact}"
            );
        }
    }
}

/// Beyond its rows a table has no value, and the run ends there with the name of what looks it up.
#[test]
fn beyond_its_rows_a_table_has_no_value() {
    let beyond = RunSettings {
        t_end: Some(2.5),
        ..RunSettings::default()
    };
    let error = run(&LookedUp::default(), &beyond).unwrap_err().to_string();
    assert!(error.contains("the force of `follower` is not finite"), "{error}");
    let beyond = RunSettings {
        t_end: Some(1.9),
        ..RunSettings::default()
    };
    run(&LookedUp::default(), &beyond).unwrap();
}

mod limited {
    rncf::model! {
        /// A stone that a measured push speeds up: with a limit, behind a switch, beside a root; one at a time leaves its rows at 1 m.
        pub model Limited {
            param by_limit = 1; param by_switch = 0; param by_root = 0;
            table push { at = place; place = [-1, 1] m; f = [1, 1] N; interpolation = monotone; }
            table gate { at = time; time = [0, 1.4] s; f = [1, 1] N; interpolation = linear; }
            rigid stone { plane xy; mass = 1 kg; }
            load limit = force(stone, [min(push.f(by_limit * stone.x), 5 N), 0, 0]);
            load switch = force(stone, [if gate.f(by_switch * t) > 0.5 N { 1e-3 N } else { 2 N }, 0, 0]);
            load root = force(stone, [max(1e-3 [N] * sqrt(1 - by_root * stone.x / 1 [m]), 0 N), 0, 0]);
            output x = stone.x;
            run { t_end = 3 s; every = 0.1 s; }
        }
    }
}
use limited::Limited;

/// A limit or a switch does not stand in for what has no value: the run ends where the rows do, with what looked there.
#[test]
fn no_limit_or_switch_takes_the_place_of_what_has_no_value() {
    let none = Limited {
        by_limit: 0.0,
        ..Limited::default()
    };
    run(&none, &RunSettings::default()).unwrap();
    let [by_switch, by_root] = [[1.0, 0.0], [0.0, 1.0]].map(|[by_switch, by_root]| Limited {
        by_switch,
        by_root,
        ..none.clone()
    });
    let at_a_meter = (2.0_f64 / 1.002).sqrt();
    for (model, load, end) in [
        (Limited::default(), "limit", at_a_meter),
        (by_switch, "switch", 1.4),
        (by_root, "root", at_a_meter),
    ] {
        let error = run(&model, &RunSettings::default()).unwrap_err().to_string();
        assert!(
            error.contains(&format!("the force of `{load}` is not finite")),
            "{error}"
        );
        let t: f64 = error
            .split("t = ")
            .nth(1)
            .and_then(|rest| rest.split(' ').next())
            .unwrap()
            .parse()
            .unwrap();
        assert!((t - end).abs() < 2e-3, "{error}");
    }
}

/// A sampled signal is followed row by row: between its rows it is a line, which no step of Radau misses.
#[test]
fn sampled_signals_are_followed_row_by_row() {
    let file = std::env::temp_dir().join(format!("rncf-sampled-{}.csv", std::process::id()));
    let (mut rows, mut state) = (Vec::new(), 12345_u32);
    for row in 0..=600 {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        rows.push([f64::from(row) * 2e-3, f64::from(state >> 8) / f64::from(1 << 24) - 0.4]);
    }
    let text: String = rows.iter().map(|[t, push]| format!("{t},{push}\n")).collect();
    std::fs::write(&file, format!("time [s],push [N]\n{text}")).unwrap();
    let mut model = LookedUp::default();
    model.wind = model.wind.read(&file).unwrap();
    let settings = RunSettings {
        t_end: Some(1.2),
        ..RunSettings::default()
    };
    let result = run(&model, &settings).unwrap();
    std::fs::remove_file(&file).unwrap();
    let (mut way, mut speed) = (0.0, 0.0);
    for pair in rows.windows(2) {
        let ([from, left], [to, right]) = (pair[0], pair[1]);
        let h = to - from;
        way += h * speed + h * h * (left / 3.0 + right / 6.0);
        speed += 0.5 * h * (left + right);
    }
    let found = result.history.column(4).last().unwrap();
    println!("{found} for {way}, {} steps", result.statistics.steps);
    assert!((found - way).abs() < 1e-7 * way.abs(), "{found} for {way}");
}

rncf::model! {
    /// A stone on a stiff spring, and one far away under a force with a kink every 10 ms: beside its place the other is hardly to be seen.
    pub model Jagged {
        table signal {
            at = time;
            time = [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170, 180, 190, 200, 300] ms;
            push = [0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 0] N;
            interpolation = linear;
        }
        rigid _far { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [500, 0, 0] m; }
        load on_far = force(_far, [0, signal.push(t), 0]);
        rigid near { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [1, 0, 0] m; }
        spring stiff = linear(near, inertial.at([1, 1, 0] m), stiffness = 90 kN/m, length = 0.999 m);
        output place = near.y;
        run { t_end = 0.2 s; every = 2 ms; }
    }
}

/// Steps that end at kinks are as long with any tolerance. A comparison with other tolerances tells nothing of them until it is so small that steps are shorter; and a run
/// that ends at a kink is compared to its end.
#[test]
fn errors_of_steps_that_end_at_kinks_are_told() {
    let exact = 1e-3 * (1.0 - (300.0_f64 * 0.2).cos());
    for rtol in [1e-3, 1e-4, 1e-6, 1e-8] {
        let settings = RunSettings {
            judged: Judging::Affordable,
            options: Options {
                rtol,
                ..Options::default()
            },
            ..RunSettings::default()
        };
        let result = run(&Jagged::default(), &settings).unwrap();
        let found = result.history.column(0).last().unwrap();
        let told = result.off_by.iter().map(|&(_, part)| part).fold(0.0, f64::max);
        let error = (found - exact).abs() / 2e-3;
        println!("{rtol}: off by {error:.1e}, told {told:.1e}, {:?}", result.judged_until);
        assert!(told > error / 3.0, "{rtol}: {error}, told {told}");
    }
}
