//! What is narrow in places, angles and speeds, and neither a force on a place nor a load of time: curves that something is held to, gravity of a place, fields of
//! frames, loads per length over the place of a frame, laws of speeds, light in one direction. Against closed forms.

use std::f64::consts::PI;

use rncf::app::{RunSettings, run};
use rncf::{Method, Options};

const GRAVITY: f64 = 9.81;

rncf::model! {
    /// A bead on a wire with a step, and two shafts of which one indexes the other.
    pub model Curves {
        param w = 1 mm;
        param wide = 0.05;
        rigid bead { plane xy; mass = 0.4 kg; origin = [-5, -0.05, 0] m; velocity = [3, 0, 0] m/s; }
        constraint wire = bead.y - 50 mm * tanh(bead.x / w);
        load weight = force(bead, [0, -3.924, 0] N);
        rigid driving { plane xy; mass = 2 kg; inertia = 0.05 kg*m^2; speed = 12 rad/s; }
        rigid indexed { plane xy; mass = 1 kg; inertia = 0.004 kg*m^2; origin = [0.3, 0, 0] m; }
        joint first = revolute(inertial.at([0, 0, 0] m), driving);
        joint second = revolute(inertial.at([0.3, 0, 0] m), indexed);
        constraint index = indexed.angle - 0.25 * pi * (1 + tanh((driving.angle - 30 rad) / (1 rad * wide)));
        output speed = bead.velocity.x;
        output turn = driving.speed;
        output place = indexed.angle;
        run { t_end = 3.5 s; every = 0.05 s; }
    }
}

/// The bead loses `2 g` times its height; the driven shaft keeps its energy, and turns as fast behind the step as before.
#[test]
fn what_follows_a_curve_follows_its_steps() {
    let speed = (9.0 - 2.0 * GRAVITY * 0.1_f64).sqrt();
    let hht = Method::Hht { alpha: -0.05 };
    for (method, rtol, bound) in [
        (Method::Radau, 1e-4, 1e-4),
        (Method::Radau, 1e-6, 2e-7),
        (Method::Radau9, 1e-6, 1e-5),
        (hht, 1e-7, 1e-2),
    ] {
        for w in [1e-3, 1e-2] {
            let model = Curves { w, wide: 50.0 * w };
            let settings = RunSettings {
                method,
                options: Options {
                    rtol,
                    ..Options::default()
                },
                ..RunSettings::default()
            };
            let result = run(&model, &settings).unwrap();
            let found = [0, 1, 2].map(|column| result.history.column(column).last().unwrap());
            println!(
                "{method:?} {rtol} {w}: {found:?} for {speed}, {} steps",
                result.statistics.steps
            );
            for (found, exact) in found.into_iter().zip([speed, 12.0, 0.5 * PI]) {
                assert!(
                    (found - exact).abs() < bound * exact,
                    "{method:?} {rtol} {w}: {found} for {exact}"
                );
            }
        }
    }
}

rncf::model! {
    /// A stone in a gust of gravity, a satellite in a field and in light, a bar in a sheet of gas, a rotor and a slider that are braked at one speed.
    pub model Narrow {
        param wx = 20 mm;
        rigid stone { mass = 2 kg; origin = [0, 0, -10] m; velocity = [0, 0, 3] m/s; }
        load gust = gravity([300 [m/s^2] * exp(-((position.z - 1 m) / wx)^2), 0, 0]);
        frame sat = free(velocity = [3, 0, 0] m/s, origin = [-10, 0, 0] m);
        fixture core on sat { mass = 20 kg; inertia = [2, 3, 4] kg*m^2; }
        load field = gravity([0, 0, 300 [m/s^2] * exp(-(sat.x / wx)^2)], on = sat);
        rigid vane { mass = 50 kg; inertia = [3, 4, 5] kg*m^2; origin = [-10, 2, 0] m; angular_velocity = [0, 0, 2] rad/s; }
        load light = moment(vane, [0, 0, 5 [N*m] * exp(-(1 - vane.ex.y) / 2e-4)]);
        material stiff { density = 1500 kg/m^3; young = 2e12 Pa; damping = 1 ms; }
        section round = circle(radius = 20 mm);
        frame f = free(plane = xy, velocity = [3, 0, 0] m/s, origin = [-10, 4, 0] m);
        fixture heavy on f { mass = 3 kg; inertia = 1e6 kg*m^2; }
        body bar in f { planar xy; line from [0, 0, 0] m to [0, 1, 0] m; mesh 2 * cable(round, stiff); }
        joint root = clamp(bar.start, f);
        load gas = density(bar, [-200 [N/m] * exp(-(f.x / wx)^2), 0 [N/m], 0]);
        rigid rotor { plane xy; mass = 2 kg; inertia = 0.1 kg*m^2; origin = [-10, 6, 0] m; }
        load motor = moment(rotor, [0, 0, 1] N*m);
        load brake = moment(rotor, [0, 0, -6 [N*m] * exp(-((rotor.speed - 50 [rad/s]) / 0.02 [rad/s])^2)]);
        rigid slider { plane xy; mass = 2 kg; origin = [-10, 8, 0] m; }
        load push = force(slider, [2, 0, 0] N);
        spring grip = law(slider, inertial.at([-30, 8, 0] m), force = 10 [N] * exp(-((rate - 0.7 [m/s]) / 0.5 [mm/s])^2));
        output gusted = stone.velocity.x;
        output fielded = sat.velocity.z;
        output lit = vane.angular_velocity.z;
        output slowed = f.velocity.x;
        output braked = rotor.speed;
        output gripped = slider.velocity.x;
        run { t_end = 9 s; every = 0.1 s; }
    }
}

#[test]
fn what_passes_something_narrow_feels_it() {
    let impulse = 300.0 * PI.sqrt() * 0.02 / 3.0;
    let density = 1500.0 * PI * 0.02_f64.powi(2);
    let exact = [
        impulse,
        impulse,
        // Four passes within 9 s, each with the work `T sqrt(2 pi w) (1 + w / 8)`.
        (4.0 + 2.0 * 3.0 * (2.0 * PI * 2e-4_f64).sqrt() * (1.0 + 2.5e-5)).sqrt(),
        (9.0 - 2.0 * 200.0 * PI.sqrt() * 0.02 / (3.0 + density)).sqrt(),
        50.0 - 0.02 * 6.0_f64.ln().sqrt(),
        0.7 - 5e-4 * 5.0_f64.ln().sqrt(),
    ];
    let result = run(&Narrow::default(), &RunSettings::default()).unwrap();
    println!("{} steps", result.statistics.steps);
    for (column, exact) in exact.into_iter().enumerate() {
        let found = result.history.column(column).last().unwrap();
        let name = &result.history.columns[column].name;
        println!("{name}: {found} for {exact}");
        assert!(
            (found - exact).abs() < 3e-4 * exact.abs(),
            "{name}: {found} for {exact}"
        );
    }
}
