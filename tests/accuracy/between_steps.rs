//! Forces of joints in rows between the ends of steps that are turns long, against closed forms.

use rncf::prelude::*;
use rncf::{Formulation, Joints};

use super::runs::{adaptive, grid, history};

const RNCF: (Formulation, Joints) = (Formulation::Rncf, Joints::Eliminated);

rncf::model! {
    /// An arm that a drive turns evenly under its weight: its angle is a polynomial, which no step is too long for.
    pub model Crank {
        const w = 3 rad/s;
        rigid arm { plane xy; mass = 5 kg; inertia = 0.5 kg*m^2; center = [0.4, 0, 0] m; speed = w; }
        joint shoulder = revolute(inertial, arm.at([0, 0, 0] m));
        joint motor = drive(shoulder.angle, w * t);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output torque = motor.moment.z;
        output force = shoulder.force;
        run { t_end = 10 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A rotor that spins freely about a point beside its centre.
    pub model Unbalanced {
        const w = 30 rad/s;
        rigid rotor { mass = 5 kg; inertia = [0.5, 0.5, 0.5] kg*m^2; center = [1, 0, 0] mm; angular_velocity = [0, 0, w]; }
        joint bearing = revolute(inertial, rotor.at([0, 0, 0] m), axis = z);
        output force = bearing.force;
        output moment = bearing.moment;
    }
}

/// Torque and force that hold the arm at a time.
fn of_the_arm(t: f64) -> [f64; 3] {
    let (sin, cos) = (3.0 * t).sin_cos();
    let (m, r) = (5.0, 0.4);
    [m * 9.81 * r * cos, -m * r * 9.0 * cos, m * 9.81 - m * r * 9.0 * sin]
}

fn off(row: &[f64], right: &[f64]) -> f64 {
    // What the joint exerts on its first party is the reverse of what it exerts on the arm.
    row.iter()
        .zip(right)
        .map(|(own, right)| (own + right).abs())
        .fold(0.0, f64::max)
}

/// The polynomial through the multipliers of the stages was off by 36 N m of 19.6 at any tolerance, and other steps were the same.
#[test]
fn forces_of_what_turns_evenly_are_right_between_its_steps() {
    let times = grid(0.01, 10.0);
    let ways = [
        (Method::Radau, 1e-4, 0.02),
        (Method::Radau, 1e-6, 2e-3),
        (Method::Radau, 1e-9, 1e-4),
        (Method::Radau13, 1e-6, 2e-3),
        (Method::Radau13, 1e-12, 1e-5),
    ];
    for (method, rtol, bound) in ways {
        let (rows, statistics) = history(&Crank {}, RNCF, method, adaptive(rtol), &times);
        assert!(statistics.steps < 40, "{method:?} {rtol}: {}", statistics.steps);
        let rows = times.iter().zip(&rows);
        let most = rows.map(|(t, row)| off(row, &of_the_arm(*t))).fold(0.0, f64::max);
        assert!(most < bound, "{method:?} {rtol}: {most}");
    }
}

/// 1.1 to 10 N of 4.5 N in a plane, 4.2 to 5.8 N in space.
#[test]
fn what_is_beside_its_axis_pulls_evenly() {
    for rtol in [1e-4, 1e-6, 1e-9] {
        let (rows, _) = history(&Unbalanced {}, RNCF, Method::Radau, adaptive(rtol), &grid(0.005, 2.0));
        for row in rows {
            let pull = row[..3].iter().map(|force| force * force).sum::<f64>().sqrt();
            assert!(
                (pull - 4.5).abs() < 0.3 * rtol.sqrt() && row[3].hypot(row[4]) < 1e-6,
                "{rtol}: {row:?}"
            );
        }
    }
}

rncf::model! {
    /// An arm that a program lifts by a radian and lowers again, from rest to rest.
    pub model Robot {
        table program { at = time; time = [0, 1, 2] s; angle = [0, 1, 0] rad; interpolation = clamped; }
        rigid arm { plane xy; mass = 5 kg; inertia = 0.5 kg*m^2; center = [0.4, 0, 0] m; }
        joint shoulder = revolute(inertial, arm.at([0, 0, 0] m));
        joint motor = drive(shoulder.angle, program.angle(t));
        load weight = gravity([0, -9.81, 0] m/s^2);
        output torque = motor.moment.z;
        output angle = arm.angle;
    }
}

/// Two pieces `3 s^2 - 2 s^3`, whose slopes are zero in all rows for symmetry, and rest behind them.
#[test]
fn a_program_from_rest_to_rest_needs_no_rows_beside_it() {
    let times = grid(0.01, 3.0);
    let (rows, statistics) = history(&Robot {}, RNCF, Method::Radau, adaptive(1e-8), &times);
    assert!(statistics.steps < 60, "{}", statistics.steps);
    for (t, row) in times.iter().zip(rows) {
        let way = |s: f64| s * s * (3.0 - 2.0 * s);
        let (angle, acceleration) = match *t {
            t if t < 1.0 => (way(t), 6.0 - 12.0 * t),
            t if t < 2.0 => (1.0 - way(t - 1.0), 12.0 * (t - 1.0) - 6.0),
            _ => (0.0, 0.0),
        };
        let torque = (0.5 + 5.0 * 0.16) * acceleration + 5.0 * 9.81 * 0.4 * angle.cos();
        assert!((row[1] - angle).abs() < 1e-7, "{t}: {row:?}");
        // A row at a kink has the acceleration of the step before it.
        let is_at_kink = [0.0, 1.0, 2.0].iter().any(|kink| (t - kink).abs() < 1e-9);
        assert!(is_at_kink || (row[0] + torque).abs() < 1e-2, "{t}: {row:?} {torque}");
    }
}
