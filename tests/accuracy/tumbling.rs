//! What is free and spins about its intermediate axis tumbles: the modes about its relative equilibrium say so.

use rncf::app::{Judging, RunSettings, run};
use rncf::emitted::Fidelity;
use rncf::equilibrium::{Uniform, steady};
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Joints, Method, Model, Statistics};

use crate::runs::{adaptive, apart, far, grid, history, states_at};

rncf::model! {
    /// A free rigid hub with four flexible booms, or without.
    pub model Satellite {
        param spin_x = 0 rad/s;
        param spin_y = 0 rad/s;
        param spin_z = 0 rad/s;
        param elements: count = 4;
        /// Of the hub, whose booms are as dense.
        param density = 2700 kg/m^3;

        material metal { density = density; young = 70 GPa; }
        section pipe = tube(radius = 20 mm, thickness = 1 mm);
        rigid hub { mass = 100 kg; inertia = [30, 40, 60] kg*m^2; angular_velocity = [spin_x, spin_y, spin_z]; }
        body east in hub { spatial; line from [0.5, 0, 0] m to [3.5, 0, 0] m; mesh elements * cable(pipe, metal); }
        body west in hub { spatial; line from [-0.5, 0, 0] m to [-3.5, 0, 0] m; mesh elements * cable(pipe, metal); }
        body north in hub { spatial; line from [0, 0.5, 0] m to [0, 2, 0] m; mesh elements * cable(pipe, metal); }
        body south in hub { spatial; line from [0, -0.5, 0] m to [0, -2, 0] m; mesh elements * cable(pipe, metal); }
        joint east_root = clamp(east.start, hub);
        joint west_root = clamp(west.start, hub);
        joint north_root = clamp(north.start, hub);
        joint south_root = clamp(south.start, hub);
        output spin = hub.angular_velocity;
        output place = hub.position;
        output tip_of_east = east.end.in(inertial);
        output tip_of_south = south.end.in(inertial);
        output momentum = total.momentum;
        output angular_momentum = total.angular_momentum;
    }
}

/// Moments of inertia of the undeformed satellite, kg m^2.
fn inertia(density: f64) -> [f64; 3] {
    let line_mass = density * std::f64::consts::PI * (0.02f64.powi(2) - 0.019f64.powi(2));
    let pair = |from: f64, to: f64| 2.0 * line_mass * (to.powi(3) - from.powi(3)) / 3.0;
    let (x, y) = (pair(0.5, 3.5), pair(0.5, 2.0));
    [30.0 + y, 40.0 + x, 60.0 + x + y]
}

/// Growth (1/s) and frequency (rad/s) of the modes.
fn found(model: &Satellite, count: usize) -> Vec<[f64; 2]> {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let state = steady(scene.as_mut(), 0.0).unwrap().state().unwrap().clone();
    let modes = modes(scene.as_mut(), &Uniform::steady(0.0), &state, Wanted { count }).unwrap();
    modes.iter().map(|mode| [mode.re, mode.im]).collect()
}

#[test]
fn a_satellite_tumbles_about_its_intermediate_axis_as_a_rigid_body_does() {
    // So slow that the booms stay straight to 1e-5. Small enough for full matrices, and large.
    let spin = 0.05;
    for (elements, density) in [(1, 2700.0), (4, 2700.0), (12, 2700.0), (4, 1e-6)] {
        let slow = Satellite {
            elements,
            density,
            ..Satellite::default()
        };
        let [a, b, c] = inertia(density);
        let model = Satellite {
            spin_y: spin,
            ..slow.clone()
        };
        let rates = found(&model, 8);
        let growth = rates.iter().map(|rate| rate[0]).fold(0.0, f64::max);
        let exact = spin * ((b - a) * (c - b) / (a * c)).sqrt();
        println!("{elements} elements, {density} kg/m^3: {growth} instead of {exact} 1/s");
        assert!((growth / exact - 1.0).abs() < 1e-4, "{rates:?}");
        // About the axis of the least inertia it nutates.
        let rates = found(&Satellite { spin_x: spin, ..slow }, 8);
        let exact = spin * ((b - a) * (c - a) / (b * c)).sqrt();
        assert!(rates.iter().all(|rate| rate[0] < 1e-9 * spin), "{rates:?}");
        assert!(
            rates.iter().any(|rate| (rate[1] / exact - 1.0).abs() < 1e-4),
            "{exact}: {rates:?}"
        );
    }
}

#[test]
fn without_modes_nothing_is_said_of_the_stability() {
    // At rest all six motions drift.
    let rates = found(&Satellite::default(), 6);
    assert_eq!(rates, [[0.0; 2]; 6]);
}

rncf::model! {
    /// A stone and a plate that are thrown, both away from the origins of their frames.
    pub model Thrown {
        rigid stone {
            mass = 2 kg;
            center = [0.3, -0.2, 0.5] m;
            inertia = [0.02, 0.05, 0.055] kg*m^2;
            velocity = [3, 0, 1] m/s;
            angular_velocity = [30, 4, -2] rad/s;
        }
        rigid plate { plane xy; mass = 1 kg; center = [0.4, 0.1, 0] m; inertia = 0.02 kg*m^2; velocity = [1, 2, 0] m/s; speed = 25 rad/s; }
        load weight = gravity([0, -9.81, 0] m/s^2);
        output stone_at = stone.center;
        output plate_at = plate.center;
        output spin = stone.angular_momentum(about = stone.center);
    }
}

#[test]
fn methods_of_second_order_keep_the_momentum_of_what_turns_beside_its_origin() {
    let end = 1.0;
    let weight = [0.0, -9.81, 0.0];
    // v + w x c of the stone and of the plate, and the places of their centres at the start.
    let starts = [
        (
            [0.3, -0.2, 0.5],
            [
                3.0 + 4.0 * 0.5 - 2.0 * 0.2,
                -2.0 * 0.3 - 30.0 * 0.5,
                1.0 - 30.0 * 0.2 - 4.0 * 0.3,
            ],
        ),
        ([0.4, 0.1, 0.0], [1.0 - 25.0 * 0.1, 2.0 + 25.0 * 0.4, 0.0]),
    ];
    // J w in the axes of the start.
    let momentum = [0.02 * 30.0, 0.05 * 4.0, 0.055 * -2.0];
    for (method, rtol) in [
        (Method::Hht { alpha: -0.05 }, 1e-4),
        (Method::Hht { alpha: -0.05 }, 1e-6),
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, 1e-6),
    ] {
        let mut scene = Thrown::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let start = scene.rest(0.0);
        let (states, statistics) = states_at(scene.as_mut(), start, method, adaptive(rtol), &[end]);
        let mut row = vec![0.0; scene.output_columns()];
        scene.outputs(&states[0], &mut row);
        for (which, (place, velocity)) in starts.iter().enumerate() {
            for axis in 0..if which == 0 { 3 } else { 2 } {
                let exact = place[axis] + velocity[axis] * end + 0.5 * weight[axis] * end * end;
                let off = (row[3 * which + axis] - exact).abs();
                println!(
                    "{method:?} {rtol}, {} steps: centre {which} off by {off:.1e} m",
                    statistics.steps
                );
                assert!(off < 0.1 * rtol, "{off}");
            }
        }
        let off = (0..3)
            .map(|axis| (row[row.len() - 3 + axis] - momentum[axis]).abs())
            .fold(0.0, f64::max);
        println!("angular momentum off by {off:.1e} of {momentum:?} kg m^2/s");
        assert!(off < 0.1 * rtol, "{off}");
    }
}

/// Half of the satellite, m.
const SIZE: f64 = 3.5;

/// Places, and largest drifts of momentum and angular momentum as parts of what the latter is at the start (over the size), of the tumbling satellite.
fn flown(way: Formulation, method: Method, rtol: f64, times: &[f64]) -> (Vec<Vec<f64>>, [f64; 2], Statistics) {
    let model = Satellite {
        spin_x: 0.3,
        spin_y: 1.0,
        ..Satellite::default()
    };
    let (rows, statistics) = history(&model, (way, Joints::Eliminated), method, adaptive(rtol), times);
    let given = rows[0][15..18].iter().map(|part| part * part).sum::<f64>().sqrt();
    let drift = |columns: std::ops::Range<usize>, scale: f64| {
        rows.iter()
            .map(|row| far(&row[columns.clone()], &rows[0][columns.clone()]) / scale)
            .fold(0.0, f64::max)
    };
    let drifts = [drift(12..15, given / SIZE), drift(15..18, given)];
    (rows.iter().map(|row| row[3..12].to_vec()).collect(), drifts, statistics)
}

/// Rows of a table: error of places over the size, drifts of momentum and angular momentum, steps.
fn compared(methods: &[(Method, &[f64])], end: f64, finest: f64) -> Vec<(Formulation, Method, f64, [f64; 3])> {
    let times = grid(0.1, end);
    let (exact, _, _) = flown(Formulation::Ancf, Method::Radau, finest, &times);
    let mut found = Vec::new();
    for (method, tolerances) in methods {
        for &rtol in *tolerances {
            for way in [Formulation::Rncf, Formulation::Ancf] {
                let (places, [momentum, spin], statistics) = flown(way, *method, rtol, &times);
                let error = apart(&places, &exact) / SIZE;
                println!(
                    "{way:?} {method:?} {rtol:e}: {error:.1e} of the size, momentum {momentum:.1e}, angular momentum {spin:.1e}, {} steps",
                    statistics.steps
                );
                found.push((way, *method, rtol, [error, momentum, spin]));
            }
        }
    }
    found
}

#[test]
fn a_tumbling_satellite_is_where_it_is_in_both_formulations() {
    let hht = Method::Hht { alpha: -0.05 };
    for (_, method, rtol, [error, momentum, spin]) in
        compared(&[(Method::Radau, &[1e-4, 1e-6]), (hht, &[1e-4])], 2.0, 1e-7)
    {
        // Errors of methods of second order follow the tolerance of a step to the power 2/3.
        let limit = if method == hht {
            3.0 * rtol.powf(2.0 / 3.0)
        } else {
            10.0 * rtol
        };
        assert!(
            error < limit && momentum < limit && spin < limit,
            "{error:e} {momentum:e} {spin:e}"
        );
    }
}

/// All methods and tolerances, for reading.
#[test]
#[ignore = "a study of minutes"]
fn table_of_the_satellite() {
    let all: &[f64] = &[1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
    let [hht, alpha] = [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }];
    let found = compared(&[(Method::Radau, all), (hht, all), (alpha, all)], 5.0, 1e-10);
    assert!(
        found
            .iter()
            .all(|(_, _, _, numbers)| numbers.iter().all(|number| number.is_finite()))
    );
}

rncf::model! {
    /// A rod on its chord, spun up beside its axis by a moment on its end.
    pub model Spun {
        param moment = 6e-3 N*m;
        /// Of the rod from the moment.
        param slant = 45 deg;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 4 mm);
        frame f = free();
        body rod in f { spatial; line from [0, 0, 0] m to [0.5 m * cos(slant), 0.5 m * sin(slant), 0 m]; mesh 3 * beam(round, steel); chord; }
        load push = moment(rod.end, [if t < 0.25 s { moment } else { 0 [N*m] }, 0, 0]);
        output momentum = total.momentum;
        output tip = rod.end.in(inertial);
        output spin = f.angular_velocity;
        run { t_end = 0.5 s; every = 0.01 s; }
    }
}

rncf::model! {
    /// A hub with a boom that bends where the hub is spun up.
    pub model Hub {
        material metal { density = 2700 kg/m^3; young = 70 GPa; }
        section pipe = tube(radius = 10 mm, thickness = 1 mm);
        rigid hub { mass = 1 kg; inertia = [0.02, 0.03, 0.04] kg*m^2; angular_velocity = [1, 0, 20] rad/s; velocity = [0, -20, 0] m/s; }
        body boom in hub { spatial; line from [0.1, 0, 0] m to [2, 0, 0] m; mesh 3 * cable(pipe, metal); }
        joint root = clamp(boom.start, hub);
        load motor = moment(hub, [0, 0, 10] N*m);
        output momentum = total.momentum;
    }
}

/// Largest change of the momentum (kg m/s) in a run of 0.5 s.
fn leaked(scene: &mut dyn rncf::Scene, method: Method, rtol: f64) -> (f64, Statistics) {
    let start = scene.rest(0.0);
    let (states, statistics) = states_at(scene, start, method, adaptive(rtol), &grid(0.05, 0.5));
    let rows: Vec<Vec<f64>> = states
        .iter()
        .map(|state| {
            let mut row = vec![0.0; scene.output_columns()];
            scene.outputs(state, &mut row);
            row
        })
        .collect();
    let leak = rows.iter().map(|row| far(&row[..3], &rows[0][..3])).fold(0.0, f64::max);
    (leak, statistics)
}

#[test]
fn methods_of_second_order_keep_the_momentum_of_what_deforms_in_a_turning_frame() {
    let modes = [("boom".to_string(), Fidelity::Modal(4))];
    for method in [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
        let mut rod = Spun::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let (leak, statistics) = leaked(rod.as_mut(), method, 1e-5);
        println!("{method:?}: rod, {leak:.1e} kg m/s in {} steps", statistics.steps);
        assert!(leak < 2e-5, "{leak:e}");
        for fidelity in [&modes[..0], &modes] {
            let mut hub = Hub::default()
                .build_as(Formulation::Rncf, Joints::Eliminated, fidelity)
                .unwrap();
            let (leak, statistics) = leaked(hub.as_mut(), method, 1e-5);
            println!(
                "{method:?}: hub, {fidelity:?}, {leak:.1e} kg m/s in {} steps",
                statistics.steps
            );
            assert!(leak < 1e-4, "{leak:e}");
        }
    }
}

/// The rod tumbles at 60 rad/s and spins about itself at 3000 rad/s: other steps take too long to compare with to the end, which is told.
#[test]
fn what_other_steps_are_not_compared_with_is_told() {
    let model = Spun {
        moment: 1.0,
        slant: 89f64.to_radians(),
    };
    let settings = RunSettings {
        method: Method::Hht { alpha: -0.05 },
        options: adaptive(1e-5),
        judged: Judging::Affordable,
        t_end: Some(0.3),
        ..RunSettings::default()
    };
    let warnings = run(&model, &settings).unwrap().warnings;
    println!("{warnings:#?}");
    let is_told = |text: &String| text.contains("nothing is known of their errors");
    assert!(warnings.iter().any(is_told));
}
