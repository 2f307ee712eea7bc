//! Joints of planar bodies whose parent is turned when it starts: nothing depends on where the angles are counted from.

use rncf::{AnyModel, Formulation, Start, app};

rncf::model! {
    /// An arm on a hub that is turned at the start, hinged with a spring, in a plane and in space; and two bodies of different parents.
    pub model Turned {
        param w = 10 rad/s;
        param off = 0.4 rad;
        frame hub = rotating(axis = z, angle = w * t + off, origin = [1, 2, 0] m);
        rigid arm in hub { plane xy; mass = 1 kg; inertia = 0.05 kg*m^2; center = [0.4, 0, 0] m; origin = [0.1, 0, 0] m; angle = 0.1 rad; }
        joint lag = revolute(hub.at([0.1, 0, 0] m), arm.at([0, 0, 0] m));
        spring coil = torsional(lag, stiffness = 5 N*m/rad);
        rigid other in hub { mass = 1 kg; inertia = [0.05, 0.05, 0.05] kg*m^2; center = [0.4, 0, 0] m; origin = [0.1, 0, 0] m; axis = z; angle = 0.1 rad; }
        joint beside = revolute(hub.at([0.1, 0, 0] m), other.at([0, 0, 0] m), axis = z);
        spring same = torsional(beside, stiffness = 5 N*m/rad);
        frame table = rotating(axis = [0, 0, -1], angle = 2 * off);
        rigid a in table { plane xy; mass = 1 kg; inertia = 0.05 kg*m^2; angle = 2 * off + 0.2 rad; }
        rigid b { plane xy; mass = 1 kg; inertia = 0.05 kg*m^2; }
        joint pivot = revolute(inertial, a);
        joint elbow = revolute(a, b);
        spring back = torsional(elbow, stiffness = 5 N*m/rad);
        output angle = lag.angle;
        output beside_angle = beside.angle;
        output turned: rad = atan2(arm.ex.in(hub).y, arm.ex.in(hub).x);
        output pivot_angle = pivot.angle;
        output elbow_angle = elbow.angle;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// Angles left out how the parent of a planar body was turned at the start, and with them torsional springs, drives and laws.
#[test]
fn angles_of_joints_count_how_a_parent_starts() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let of = |off: f64| {
            let settings = app::RunSettings {
                formulation,
                start: Some(Start::Rest),
                ..app::RunSettings::default()
            };
            let model = Turned {
                off,
                ..Turned::default()
            };
            app::run(&model, &settings).unwrap_or_else(|error| panic!("{}: {error}", model.name()))
        };
        let (straight, turned) = (of(0.0), of(0.4));
        for result in [&straight, &turned] {
            let columns: Vec<Vec<f64>> = (0..5).map(|column| result.history.column(column).collect()).collect();
            for (column, start) in [(0, 0.1), (1, 0.0), (2, 0.1), (3, 0.2), (4, -0.2)] {
                assert!(
                    (columns[column][0] - start).abs() < 1e-12,
                    "{column}: {}",
                    columns[column][0]
                );
            }
            for row in 0..columns[0].len() {
                assert!((columns[0][row] - columns[2][row]).abs() < 1e-9);
                // About the pivot only a and b turn: b back and forth with 1.5 times the stiffness, or twice, over the inertia.
                let t = 0.1 * row as f64;
                let elbow = -0.2 * ((5.0 * 2.0 / 0.05_f64).sqrt() * t).cos();
                assert!((columns[4][row] - elbow).abs() < 1e-5, "{} {elbow}", columns[4][row]);
            }
        }
        for column in 0..5 {
            for (a, b) in straight.history.column(column).zip(turned.history.column(column)) {
                assert!((a - b).abs() < 1e-6, "column {column}: {a} {b}");
            }
        }
    }
}
