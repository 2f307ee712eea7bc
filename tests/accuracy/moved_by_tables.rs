//! Frames, drives and constraints that follow tables, against the same splines and equations of motion in scipy 1.17 (`CubicSpline`, `DOP853` at 1e-12).

use rncf::app::{RunSettings, run};
use rncf::{Formulation, Method, Options};

rncf::model! {
    /// A pendulum on a shaken ground, an arm whose angle was measured, and a tappet on a cam.
    pub model Measured {
        param shaken: table = file("accuracy/data/shaken.csv", at = time, interpolation = spline);
        table shaker { at = time; time = [0, 0.1, 0.25, 0.3, 0.5, 0.7, 0.85, 1, 1.2, 1.5, 2] s;
            turn = [0, 1, 3, 4, 2, -1, -2, -4, -3, 0, 1] deg; interpolation = spline; }
        table cam { at = turn; turn = [-1, 0, 1, 2, 3, 4, 5] rad; lift = [0, 10, 14, 9, 3, 6, 20] mm; interpolation = spline; }
        motion shake(t) = 10 * shaken.x(t);
        frame ground = moving(origin = [shake(t), 0 m, 0 m]);
        rigid bob in ground { plane xy; mass = 2 kg; inertia = 0.03 kg*m^2; center = [0, -0.4, 0] m; }
        joint hinge = revolute(bob, ground);
        load weight = gravity([0, -9.81, 0] m/s^2);
        rigid arm { plane xy; mass = 1 kg; inertia = 0.02 kg*m^2; speed = 0.21535515923221518 rad/s; }
        joint axle = pin(arm, inertial);
        joint motor = drive(arm.angle, shaker.turn(t));
        rigid disc { plane xy; mass = 1 kg; inertia = 0.02 kg*m^2; origin = [6, 0, 0] m; speed = 2 rad/s; }
        joint bearing = pin(disc.at([0, 0, 0] m), inertial);
        rigid tappet { plane xy; mass = 0.5 kg; origin = [7, 0.01, 0] m; velocity = [0, 0.015886904761904762, 0] m/s; }
        constraint guide = tappet.x - 7 m;
        constraint contact = tappet.y - cam.lift(disc.angle);
        output swing = bob.angle;
        output moved = ground.x;
        output speed = ground.velocity.x;
        output torque = motor.moment;
        output turn = disc.angle;
        output lift = tappet.y;
        output read = 10 * shaken.x(t) + cam.lift(disc.angle);
        run { t_end = 2 s; every = 0.01 s; }
    }
}

/// Rows of the history, and what scipy has there, with the largest change of each.
const ROWS: [usize; 3] = [45, 113, 176];
#[rustfmt::skip]
const SCIPY: [([f64; 3], f64); 6] = [
    ([0.10537638017886403, -0.18710729997935208, 0.1627082002993162], 0.48),
    ([-0.025091275665349157, 0.02969559658046155, 0.00043465878751742615], 0.121),
    ([-0.30649654632497303, -0.13654362678148024, 0.009922576978047505], 0.991),
    ([-0.024193727862587337, 0.02230469512272342, -0.010230155984011136], 0.201),
    ([0.7512992460379943, 1.8282487344084777, 3.384025530936212], 4.01),
    ([0.01387446705655941, 0.010241526554713413, 0.0028453636463675997], 0.0113),
];

#[test]
fn what_moves_follows_the_splines_of_tables() {
    let radau = |rtol| (Method::Radau, rtol, 5.0 * rtol);
    let cases = [
        radau(1e-4),
        radau(1e-6),
        radau(1e-8),
        (Method::Hht { alpha: -0.05 }, 1e-7, 2e-4),
    ];
    for (method, rtol, bound) in cases {
        for formulation in [Formulation::Rncf, Formulation::Ancf] {
            let settings = RunSettings {
                method,
                formulation,
                options: Options {
                    rtol,
                    ..Options::default()
                },
                ..RunSettings::default()
            };
            let result = run(&Measured::default(), &settings).unwrap();
            for (column, (wanted, size)) in SCIPY.into_iter().enumerate() {
                let found = ROWS.map(|row| result.history.column(column).nth(row).unwrap());
                let off = found
                    .iter()
                    .zip(wanted)
                    .map(|(found, wanted)| (found - wanted).abs() / size);
                let off = off.fold(0.0, f64::max);
                println!(
                    "{method:?} {rtol} {formulation:?} {}: {off:.1e}, {} steps",
                    result.history.columns[column].name, result.statistics.steps
                );
                assert!(
                    off < bound,
                    "{method:?} {rtol} {formulation:?} {column}: {found:?}, off by {off:.1e}"
                );
            }
            let [moved, lift, read] = [1, 5, 6].map(|column| result.history.column(column).nth(ROWS[0]).unwrap());
            assert!((moved + lift - read).abs() < bound, "{read}");
        }
    }
}

/// A file that a run reads has the spline that the macro has of the same rows; one with a step has none.
#[test]
fn files_have_the_splines_of_the_macro() {
    let mut model = Measured::default();
    let settings = RunSettings::default();
    let known = run(&model, &settings).unwrap();
    let file = std::env::temp_dir().join(format!("rncf-shaken-{}.csv", std::process::id()));
    let rows = include_str!("data/shaken.csv");
    std::fs::write(&file, rows).unwrap();
    model.shaken = model.shaken.read(&file).unwrap();
    assert_ne!(model, Measured::default());
    let read = run(&model, &settings).unwrap();
    for column in 0..SCIPY.len() {
        assert!(known.history.column(column).eq(read.history.column(column)));
    }
    std::fs::write(&file, rows.replace("0.25,", "0.1,")).unwrap();
    let told = model.shaken.read(&file).unwrap_err().to_string();
    std::fs::remove_file(&file).unwrap();
    assert!(
        told.contains("line 4: it is at the place of the one before it"),
        "{told}"
    );
}

/// Beyond the rows nothing says where a frame is.
#[test]
fn a_frame_has_no_motion_beyond_its_rows() {
    let settings = RunSettings {
        t_end: Some(2.5),
        ..RunSettings::default()
    };
    let told = run(&Measured::default(), &settings).unwrap_err().to_string();
    assert!(
        told.contains("frame `ground`") && told.contains("the rows of its tables"),
        "{told}"
    );
}

rncf::model! {
    /// A cam that spins freely and lifts a tappet in every turn.
    pub model Cam {
        table profile { at = turn; turn = [-30, 0, 20, 60, 90, 150, 240, 330] deg; lift = [0, 2, 9, 12, 8, 3, 1, 0] mm; interpolation = periodic; }
        rigid disc { plane xy; mass = 1 kg; inertia = 2 g*m^2; speed = 40 rad/s; }
        joint bearing = pin(disc, inertial);
        rigid tappet { plane xy; mass = 0.5 kg; origin = [0, 0.1, 0] m; velocity = [0, 0.610293162869469, 0] m/s; }
        constraint guide = tappet.x;
        constraint contact = tappet.y - 98 mm - profile.lift(disc.angle);
        output energy = total.kinetic_energy;
        output lift = tappet.y;
        output read = 98 mm + profile.lift(disc.angle);
        output turn = disc.angle;
        output speed = disc.speed;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

/// Rows repeat turn by turn; nothing takes energy from the cam, and it is as fast in every turn at the same angle.
#[test]
fn a_cam_lifts_in_every_turn() {
    let result = run(&Cam::default(), &RunSettings::default()).unwrap();
    let column = |column: usize| result.history.column(column).collect::<Vec<f64>>();
    let [energy, lift, read, turn] = [0, 1, 2, 3].map(column);
    println!(
        "{} steps, {} turns",
        result.statistics.steps,
        turn[turn.len() - 1] / std::f64::consts::TAU
    );
    assert!(turn[turn.len() - 1] > 10.0 * std::f64::consts::TAU);
    for row in 0..energy.len() {
        assert!(
            (energy[row] - energy[0]).abs() < 1e-4 * energy[0],
            "{} J for {}",
            energy[row],
            energy[0]
        );
        assert!((lift[row] - read[row]).abs() < 1e-6, "{} for {}", lift[row], read[row]);
    }
    let [least, most] = [f64::min, f64::max].map(|pick| lift.iter().copied().reduce(pick).unwrap());
    // By scipy the profile goes from -0.1987 to 12.7167 mm.
    assert!(
        least > 0.0978012 && least < 0.09785 && most > 0.1106 && most < 0.1107168,
        "{least} {most}"
    );
}
