//! Starts with the velocities that joints and drives ask for.

use rncf::app::{Judging, RunSettings, run};
use rncf::{AnyModel, Formulation, Options, Start};

rncf::model! {
    /// A slider-crank whose motor turns steadily from the beginning.
    pub model Press {
        param phi = 40 deg;
        const r = 0.1 m;
        const l = 0.3 m;
        const w = 20 rad/s;
        let psi = -asin(r * sin(phi) / l);
        rigid crank { plane xy; mass = 1 kg; inertia = 5 g*m^2; angle = phi; }
        rigid rod { plane xy; mass = 2 kg; inertia = 0.02 kg*m^2; center = [l / 2, 0, 0]; origin = [r * cos(phi), r * sin(phi), 0]; angle = psi; }
        rigid slider { plane xy; mass = 3 kg; inertia = 1 g*m^2; origin = [r * cos(phi) + l * cos(psi), 0, 0]; }
        joint bearing = revolute(inertial, crank);
        joint motor = drive(bearing.angle, phi + w * t);
        joint pin = revolute(crank.at([r, 0, 0]), rod.at([0, 0, 0] m));
        joint wrist = revolute(rod.at([l, 0, 0]), slider.at([0, 0, 0] m));
        joint guide = prismatic(inertial, slider, axis = x);
        output speed = slider.velocity.x;
        output swing = rod.angular_velocity.z;
        output torque = motor.moment.z;
        run { t_end = 0.1 s; every = 0.01 s; start = moving; }
    }
}

/// The speeds of a slider-crank by its closed form, and no energy beside that of these: the run is that of a start with all speeds by hand.
#[test]
fn a_mechanism_starts_with_the_speeds_of_its_motor() {
    let options = Options {
        rtol: 1e-9,
        ..Options::default()
    };
    let settings = RunSettings {
        options,
        ..RunSettings::default()
    };
    for phi in [0.3, 0.7, 2.0, 4.5_f64] {
        let found = run(&Press { phi }, &settings).unwrap();
        let (r, l, w) = (0.1, 0.3, 20.0);
        for (row, t) in found.history.keys.iter().enumerate() {
            let at = phi + w * t;
            let (sin, cos) = (-r * at.sin() / l, (1.0 - (r * at.sin() / l).powi(2)).sqrt());
            let swing = -r * w * at.cos() / (l * cos);
            let speed = -r * w * at.sin() - l * sin * swing;
            let values = &found.history.values[3 * row..][..3];
            let near = if row == 0 { 1e-9 } else { 1e-6 };
            assert!(
                (values[0] - speed).abs() < near * r * w,
                "{phi}, {t}: {} for {speed}",
                values[0]
            );
            assert!(
                (values[1] - swing).abs() < near * w,
                "{phi}, {t}: {} for {swing}",
                values[1]
            );
        }
        assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    }
}

/// Without it the start is refused, and the message says what helps.
#[test]
fn a_start_at_rest_says_how_to_move() {
    let settings = RunSettings {
        start: Some(Start::Rest),
        ..RunSettings::default()
    };
    let refused = run(&Press::default(), &settings).unwrap_err().to_string();
    assert!(refused.contains("`start = moving` in `run`"), "{refused}");
}

rncf::model! {
    /// A bar that floats in the axes of its mean, or of the ground, with one end on a trolley that moves across it from the beginning.
    pub model Dragged {
        const u = 2 m/s;
        section s { EA = 1e6 N; EI = 100 N*m^2; mass = 3 kg/m; }
        frame cart = moving(origin = [0 m, u * t, 0 m]);
        frame float = free(plane = xy);
        body loose in float { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(s); mean_axes; }
        body bound in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(s); }
        joint hook = pin(loose.start, cart);
        joint other = pin(bound.start, cart);
        output loose_end = loose.end.in(inertial).velocity.y;
        output bound_end = bound.end.velocity.y;
        output loose_middle = loose.at(0.5 m).in(inertial).velocity.y;
        output bound_middle = bound.at(0.5 m).velocity.y;
        run { t_end = 1 us; every = 1 us; start = moving; }
    }
}

/// A bar that is struck at one end with a speed u starts as a rigid one: by momentum and its moment u/4 in the middle, and -u/2 at the other end. In the
/// axes of the ground its nodes have to find that among all ways of bending.
#[test]
fn a_struck_bar_starts_as_a_rigid_one() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let settings = RunSettings {
            formulation,
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = run(&Dragged {}, &settings).unwrap();
        let first = &found.history.values[..4];
        for (value, right) in first.iter().zip([-1.0, -1.0, 0.5, 0.5]) {
            assert!((value - right).abs() < 1e-5, "{formulation:?}: {first:?}");
        }
    }
}

rncf::model! {
    /// A four-bar linkage with a flexible coupler, driven steadily from the beginning.
    pub model FourBar {
        const w = 30 rad/s;
        section s = rectangle(y = 5 mm, z = 20 mm);
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        frame span = free(plane = xy, origin = [0, 0.1, 0] m, angle = 30 deg);
        body coupler in span { planar xy; line from [0, 0, 0] m to [0.4, 0, 0] m; mesh 4 * cable(s, steel); chord; }
        rigid crank { plane xy; mass = 1 kg; inertia = 5 g*m^2; angle = 90 deg; origin = [0, 0, 0] m; }
        rigid rocker { plane xy; mass = 1 kg; inertia = 0.01 kg*m^2; origin = [0.4 * cos(30 deg), 0, 0] m; angle = 90 deg; }
        joint bearing = revolute(inertial, crank);
        joint motor = drive(bearing.angle, 90 deg + w * t);
        joint a = pin(coupler.start, crank, at = [0.1, 0, 0] m);
        joint b = pin(coupler.end, rocker, at = [0.3, 0, 0] m);
        joint ground = revolute(inertial.at([0.4 * cos(30 deg), 0, 0] m), rocker.at([0, 0, 0] m));
        output swing = rocker.angular_velocity.z;
        output span_rate = span.angular_velocity.z;
        output bent = coupler.at(0.2 m).velocity.y;
        run { t_end = 1 ms; every = 0.1 ms; start = moving; }
    }
}

/// The instantaneous centres of a linkage tell the speeds: the coupler's ends go with crank and rocker, both upright, along x with w r. A flexible coupler neither
/// stretches nor bends for that.
#[test]
fn a_flexible_linkage_starts_as_a_rigid_one() {
    let found = run(&FourBar {}, &RunSettings::default()).unwrap();
    let first = &found.history.values[..3];
    assert!(
        (first[0] - 10.0).abs() < 1e-6 && first[1].abs() < 1e-6 && first[2].abs() < 1e-6,
        "{first:?}"
    );
    assert!((&FourBar {} as &dyn AnyModel).run().start == Start::Moving);
}

rncf::model! {
    /// A rod upright on a hinge of a vertical shaft that turns, and a disc that is declared to start at rest on it.
    pub model Upright {
        param speed = 8 rad/s;
        frame shaft = rotating(axis = z, angle = speed * t);
        rigid rod { mass = 1 kg; inertia = [0.1, 0.1, 1e-3] kg*m^2; center = [0, 0, -0.5] m; angular_velocity = [0, 0, 1] * speed; }
        joint hinge = revolute(shaft.at([0, 0, 0] m), rod.at([0, 0, 0] m), axis = y);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output angle = hinge.angle;
        run { t_end = 1 s; every = 0.1 s; start = steady; }
    }
}

/// Above the square root of `m g c / (I + m c^2 - I_z)` it goes out: a run that starts upright stays there, and says so; below nothing is said.
#[test]
fn an_unstable_start_is_told() {
    for (speed, is_told) in [(8.0, true), (3.0, false)] {
        let settings = RunSettings {
            judged: Judging::Affordable,
            ..RunSettings::default()
        };
        let found = run(&Upright { speed }, &settings).unwrap();
        let told = found
            .warnings
            .iter()
            .any(|told| told.contains("in which the run starts is unstable"));
        assert!(
            told == is_told && found.history.column(0).all(|angle| angle.abs() < 1e-9),
            "{:?}",
            found.warnings
        );
    }
}

rncf::model! {
    /// A satellite at rest with a wheel that turns.
    pub model Wheel {
        rigid sat { mass = 50 kg; inertia = [5, 6, 7] kg*m^2; }
        rigid wheel { mass = 2 kg; inertia = [0.02, 0.01, 0.01] kg*m^2; angular_velocity = [50, 0, 0] rad/s; }
        joint shaft = revolute(sat.at([0, 0, 0] m), wheel.at([0, 0, 0] m), axis = x);
        output own = sat.angular_velocity.x;
        run { t_end = 10 ms; every = 1 ms; }
    }
}

/// All of it turns in relative equilibrium, which is another start than the one that is declared.
#[test]
fn what_a_steady_start_takes_along_is_told() {
    let started = |start| {
        let settings = RunSettings {
            start: Some(start),
            ..RunSettings::default()
        };
        let found = run(&Wheel {}, &settings).unwrap();
        let told = found
            .warnings
            .iter()
            .any(|told| told.contains("`sat` does not start in the rotation of 50 rad/s"));
        (found.history.values[0], told)
    };
    assert_eq!(started(Start::Rest), (0.0, false));
    let (own, told) = started(Start::Steady);
    assert!((own - 50.0).abs() < 1e-9 && told, "{own}");
}
