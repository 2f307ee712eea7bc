//! Stops and saturations: laws with `max` and `min` of numbers, in a plane and in space.

use rncf::{Start, app};

rncf::model! {
    /// One arm in a plane and one in space, whose springs begin to act beyond angles on either side, with a force that saturates.
    pub model Stops {
        rigid plane_arm { plane xy; mass = 2 kg; inertia = 0.3 kg*m^2; center = [0.5, 0, 0] m; speed = 3 rad/s; }
        joint plane_hinge = revolute(inertial.at([0, 0, 0] m), plane_arm.at([0, 0, 0] m));
        spring plane_stop = torsional_law(plane_hinge, moment = 300 [N*m] * (max(angle - 0.2, 0) + min(0.3 + angle, 0)));
        load plane_push = force(plane_arm.at([1, 0, 0] m), [0, -8 [N/m] * max(-0.1 m, min(0.15 m, plane_arm.at([1, 0, 0] m).y)), 0]);
        rigid arm { mass = 2 kg; inertia = [0.3, 0.3, 0.3] kg*m^2; center = [0.5, 0, 0] m; angular_velocity = [0, 0, 3] rad/s; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), arm.at([0, 0, 0] m), axis = z);
        spring stop = torsional_law(hinge, moment = 300 [N*m] * (max(angle - 0.2, 0) + min(0.3 + angle, 0)));
        load push = force(arm.at([1, 0, 0] m), [0, -8 [N/m] * max(-0.1 m, min(0.15 m, arm.at([1, 0, 0] m).y)), 0]);
        output plane_angle = plane_hinge.angle;
        output angle = hinge.angle;
        output held: mm = max(-50 mm, arm.at([1, 0, 0] m).y);
        output seen: rad = atan2(-2 m, arm.at([1, 0, 0] m).y);
        run { t_end = 2 s; every = 10 ms; }
    }
}

/// A negative number before `.max(..)` was no text that the compiler reads, and a law of an angle in space ends at minus half a turn.
#[test]
fn stops_in_space_are_those_in_a_plane() {
    let result = app::run(
        &Stops::default(),
        &app::RunSettings {
            start: Start::Rest,
            ..app::RunSettings::default()
        },
    )
    .unwrap();
    let column = |index: usize| result.history.column(index).collect::<Vec<f64>>();
    let [plane, space, held, seen] = [0, 1, 2, 3].map(column);
    let (least, most) = plane
        .iter()
        .fold((0.0_f64, 0.0_f64), |(low, high), &a| (low.min(a), high.max(a)));
    // The energy of the stop: 150 (a - 0.2)^2 is less than (0.3 + 2 * 0.25) 3^2 / 2.
    assert!(most > 0.28 && most < 0.36 && least < -0.35, "{least} {most}");
    for (row, (a, b)) in plane.iter().zip(&space).enumerate() {
        assert!((a - b).abs() < 1e-5, "{row}: {a} {b}");
        assert!(
            (1e-3 * held[row] - b.sin().max(-0.05)).abs() < 1e-9
                && (seen[row] - (-2.0_f64).atan2(b.sin())).abs() < 1e-9
        );
    }
}
