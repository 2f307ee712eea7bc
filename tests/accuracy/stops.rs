//! Stops and saturations: laws with `max` and `min` of numbers, in a plane and in space.

use rncf::{Method, Options, Start, app};

rncf::model! {
    /// One arm in a plane and one in space, whose springs begin to act beyond angles on either side, with a force that saturates.
    pub model Stops {
        rigid plane_arm { plane xy; mass = 2 kg; inertia = 0.3 kg*m^2; center = [0.5, 0, 0] m; speed = 3 rad/s; }
        joint plane_hinge = revolute(inertial.at([0, 0, 0] m), plane_arm.at([0, 0, 0] m));
        spring plane_stop = torsional_law(plane_hinge, moment = 300 [N*m] * (max(angle - 0.2 rad, 0) + min(0.3 rad + angle, 0)));
        load plane_push = force(plane_arm.at([1, 0, 0] m), [0, -8 [N/m] * max(-0.1 m, min(0.15 m, plane_arm.at([1, 0, 0] m).y)), 0]);
        rigid arm { mass = 2 kg; inertia = [0.3, 0.3, 0.3] kg*m^2; center = [0.5, 0, 0] m; angular_velocity = [0, 0, 3] rad/s; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), arm.at([0, 0, 0] m), axis = z);
        spring stop = torsional_law(hinge, moment = 300 [N*m] * (max(angle - 0.2 rad, 0) + min(0.3 rad + angle, 0)));
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
            start: Some(Start::Rest),
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

rncf::model! {
    /// Doors in a plane and in space, each with a hinge whose moment a table has, that open past a right angle to a stop.
    pub model Doors {
        table tape { at = a; a = [-200, -90, 0, 60, 200] deg; m = [-3, -2, 0, 2, 3] N*m; interpolation = monotone; }
        rigid plane_door { plane xy; mass = 12 kg; inertia = 1 kg*m^2; speed = 1 rad/s; }
        joint plane_hinge = revolute(inertial, plane_door);
        spring plane_tape = torsional_law(plane_hinge, moment = 0.05 * tape.m(angle) + 0.5 [kN*m] * max(angle - 150 deg, 0 rad));
        rigid door { mass = 12 kg; inertia = [1, 1, 1] kg*m^2; angular_velocity = [0, 0, 1] rad/s; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), door, axis = z);
        spring tapes = torsional_law(hinge, moment = 0.05 * tape.m(angle) + 0.5 [kN*m] * max(angle - 150 deg, 0 rad));
        output plane_angle = plane_hinge.angle;
        output angle = hinge.angle;
        run { t_end = 6 s; every = 0.1 s; }
    }
}

/// Past a right angle the bounds of an angle in space were a whole turn: a law was halved until steps failed, and told to come and go.
#[test]
fn laws_of_angles_in_space_go_on_past_a_right_angle() {
    let result = app::run(&Doors::default(), &app::RunSettings::default()).unwrap();
    let most = result.history.column(0).fold(0.0, f64::max);
    assert!(
        (2.6..2.7).contains(&most),
        "it comes to the stop at 150 deg: {most} rad"
    );
    for (a, b) in result.history.column(0).zip(result.history.column(1)) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    assert!(result.statistics.steps < 150, "{} steps", result.statistics.steps);
}

rncf::model! {
    /// A ball above Hertz's contact, and two that rest while a wind begins: one of a load, one on a spring without length.
    pub model Roots {
        rigid ball { plane xy; mass = 1 kg; origin = [0, 0.1, 0] m; }
        constraint guide = ball.x;
        load floor = force(ball, [0, 1 [MN] * (max(-ball.y, 0 m) / 1 m)^(3/2), 0]);
        load weight = force(ball, [0, -9.81, 0] N);
        motion gust(t) = if t < 1 s { 0 [m/s] } else { 5 [m/s] };
        rigid leaf { mass = 1 kg; }
        load drag = force(leaf, 0.5 [kg/m] * norm([gust(t), 0, 0] - leaf.velocity) * ([gust(t), 0, 0] - leaf.velocity));
        load fall = force(leaf, [0, 0, -9.81] N);
        rigid bob { plane xy; mass = 1 kg; velocity = [2, 0, 0] m/s; }
        spring cord = linear(inertial.at([0, 0, 0] m), bob, stiffness = 4 N/m, length = 0 m);
        output y = ball.y;
        output rate = ball.velocity.y;
        output drift = leaf.x;
        output drop = leaf.z;
        output swing = bob.x;
        run { t_end = 4 s; every = 0.05 s; }
    }
}

/// Forces with roots of what is zero have derivatives where something else vanishes as well: they were refused as not finite.
/// Reference: `DOP853` of scipy at 1e-12, steps of at most 0.1 ms.
#[test]
fn roots_of_zero_in_products_that_vanish() {
    let result = app::run(&Roots::default(), &app::RunSettings::default()).unwrap();
    let last = |index: usize| result.history.column(index).last().unwrap();
    let at = |index: usize, row: usize| result.history.column(index).nth(row).unwrap();
    let near = |found: f64, want: f64, tolerance: f64| assert!((found - want).abs() < tolerance, "{found} {want}");
    near(at(0, 20), 0.04385619, 1e-5);
    near(at(1, 20), -1.04954348, 2e-4);
    near(last(2), DRIFT, 1e-5);
    near(last(3), DROP, 1e-5);
    near(last(4), 8.0_f64.sin(), 1e-5);
}

/// Of the leaf at 4 s, m.
const DRIFT: f64 = 12.97309052;
const DROP: f64 = -16.08831523;

rncf::model! {
    /// A shoe on a slide of a rotor that speeds up: it leaves its stop, and hits another one.
    pub model Shoe {
        param stop = 5 MN/m;
        frame rotor = rotating(axis = z, angle = 200 [rad/s^2] * t^2 / 2);
        rigid shoe in rotor { plane xy; mass = 0.3 kg; inertia = 1e-4 kg*m^2; origin = [0.07, 0, 0] m; }
        joint guide = prismatic(rotor.at([0.07, 0, 0] m), shoe, axis = x);
        spring coil = coordinate(guide.slide, stiffness = 8 [kN/m], value = -1 mm);
        spring inner = coordinate_law(guide.slide, force = -stop * max(-value, 0 m) + 20 [N*s/m] * rate);
        spring outer = coordinate_law(guide.slide, force = stop * max(value - 4 mm, 0 m));
        output slide = guide.slide;
        run { t_end = 0.3 s; every = 5 ms; start = moving; }
    }
}

/// On the way to a stop steps become tiny, and behind it round-off of the slide's constraint was all that the error test saw of them: it failed
/// "even with h = 3e-15 s", at one tolerance and not at the next ones. Methods of three orders agree.
#[test]
fn what_hits_a_stop_goes_on_at_the_finest_tolerances() {
    let run = |method, rtol| {
        let settings = app::RunSettings {
            method,
            options: Options {
                rtol,
                ..Options::default()
            },
            ..app::RunSettings::default()
        };
        let result = app::run(&Shoe::default(), &settings).unwrap();
        result.history.column(0).collect::<Vec<f64>>()
    };
    let exact = run(Method::Radau, 1e-10);
    for (method, rtol) in [
        (Method::Radau9, 1e-10),
        (Method::Radau9, 1e-8),
        (Method::Radau13, 1e-10),
        (Method::Radau13, 1e-8),
    ] {
        let found = run(method, rtol);
        let apart = found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-8, "{method:?} at {rtol:e}: {apart:.1e} m");
    }
}
