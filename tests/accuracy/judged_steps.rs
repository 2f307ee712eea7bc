//! What judged runs tell of errors that ten times the tolerance does not show: it has nearly the same steps, or loses what the run has.

use rncf::app::{Judging, RunSettings, run};
use rncf::prelude::*;
use rncf_reference::dense::Matrix;
use rncf_reference::integrate::{Method as Explicit, agreed};
use rncf_reference::system::System;

rncf::model! {
    /// A passenger on a train that covers 6 km, and swings by a millimetre.
    pub model Passenger {
        param ahead = 20 m;
        rigid seat { plane xy; mass = 50 kg; origin = [ahead, 0, 0]; velocity = [100, 0.01, 0] m/s; }
        load suspension = force(seat, [0 N, -5000 [N/m] * seat.y, 0]);
        output y = seat.y;
        output x = seat.x;
        run { t_end = 60 s; every = 0.1 s; }
    }
}

fn judged(rtol: f64, judged: Judging) -> RunSettings {
    RunSettings {
        options: Options {
            rtol,
            ..Options::default()
        },
        judged,
        ..RunSettings::default()
    }
}

/// The swings are below the tolerance of the place, and above the noise of a tenth of it. The place is `sin(10 t) / 1000`.
#[test]
fn what_ten_times_the_tolerance_loses_is_told() {
    for (ahead, rtol) in [(20.0, 1e-6), (50.0, 1e-6), (1000.0, 1e-8)] {
        let model = Passenger { ahead };
        let found = run(&model, &judged(rtol, Judging::Affordable)).unwrap();
        let times = found.history.keys.iter();
        let error = times
            .zip(found.history.column(0))
            .map(|(t, y)| (y - 1e-3 * (10.0 * t).sin()).abs());
        let error = error.fold(0.0, f64::max) / 1e-3;
        let note = found.warnings.iter().find(|note| note.contains("`y` by"));
        println!("{ahead} {rtol}: {error} {:?} {:?}", found.warnings, found.agreement);
        let note = note.unwrap_or_else(|| panic!("{ahead} {rtol}: off by {error}, {:?}", found.warnings));
        let told = super::judged_forces::told(note, "y").unwrap_or(0.5);
        assert!(
            (0.3..3.0).contains(&(told / error)),
            "{ahead} {rtol}: off by {error}, told {told}"
        );
    }
    // It is lost where it is far below the tolerance.
    let model = Passenger { ahead: 1e5 };
    let found = run(&model, &judged(1e-6, Judging::Affordable)).unwrap();
    assert!(
        found.warnings.iter().any(|note| note.contains("`y` by")),
        "{:?}",
        found.warnings
    );
}

rncf::model! {
    /// A gyroscope that falls in gimbals, past the place where they lock.
    pub model Gimbals {
        rigid outer { mass = 0.2 kg; inertia = [2, 2, 2] g*m^2; }
        rigid inner { mass = 0.1 kg; inertia = [1, 1, 1] g*m^2; }
        rigid rotor { mass = 0.5 kg; inertia = [0.4, 0.4, 0.7] g*m^2; angular_velocity = [0, 0, 150] rad/s; }
        rigid bob { mass = 0.05 kg; origin = [0, 0, 0.1] m; }
        joint about_y = revolute(inertial.at([0, 0, 0] m), outer.at([0, 0, 0] m), axis = y);
        joint about_x = revolute(outer.at([0, 0, 0] m), inner.at([0, 0, 0] m), axis = x);
        joint shaft = revolute(inner.at([0, 0, 0] m), rotor.at([0, 0, 0] m), axis = z);
        joint held = pin(inner.at([0, 0, 0.1] m), bob);
        load weight = gravity([9.81, 0, 0] m/s^2);
        output outwards = about_y.angle;
        output inwards = about_x.angle;
        run { t_end = 6 s; every = 0.05 s; }
    }
}

/// Ten times the tolerance takes twice as many steps as the run, and is off by as much.
#[test]
fn where_steps_do_not_follow_the_tolerance_smaller_ones_tell() {
    let exact = run(&Gimbals::default(), &judged(1e-10, Judging::No)).unwrap();
    let found = run(&Gimbals::default(), &judged(1e-6, Judging::Affordable)).unwrap();
    let looser = run(&Gimbals::default(), &judged(1e-5, Judging::No)).unwrap();
    println!("{} {} steps", found.statistics.steps, looser.statistics.steps);
    for column in 0..2 {
        let off = found
            .history
            .column(column)
            .zip(exact.history.column(column))
            .map(|(a, b)| (a - b).abs());
        let first = exact.history.column(column).next().unwrap();
        let [change, value] = exact.history.column(column).fold([0.0_f64; 2], |[change, value], one| {
            [change.max((one - first).abs()), value.max(one.abs())]
        });
        let error = off.fold(0.0, f64::max) / change.min(value);
        let told = found.off_by.iter().find(|off| off.0 == column).map_or(0.0, |off| off.1);
        println!("{column}: off by {error:.1e}, told {told:.1e}, {:?}", found.agreement);
        assert!(
            (0.3..3.0).contains(&(told / error)),
            "{column}: off by {error:.1e}, told {told:.1e}"
        );
    }
}

rncf::model! {
    /// A body that swings slowly by 10 m, and shivers by 10 um beside it.
    pub model Shiver {
        rigid body { plane xy; mass = 1 kg; origin = [10, 0, 0] m; velocity = [0, 1, 0] mm/s; }
        load springs = force(body, [-10 [mN/m] * body.x, -10 [kN/m] * body.y, 0 N]);
        output speed = body.velocity.x + body.velocity.y;
        run { t_end = 100 s; every = 0.1 s; }
    }
}

/// The shiver is as small as the tolerance of places, and a thousandth of the speeds: with ten times the tolerance, and with a tenth, it is lost as well.
/// The speeds are `-sin(t / 10)` m/s and `cos(100 t)` mm/s.
#[test]
fn small_vibrations_that_the_steps_lose_are_in_the_line_of_agreement() {
    for rtol in [1e-6, 1e-7] {
        let found = run(&Shiver {}, &judged(rtol, Judging::Affordable)).unwrap();
        let speeds = found.history.keys.iter().zip(found.history.column(0));
        let error = speeds
            .map(|(t, v)| (v + (0.1 * t).sin() - 1e-3 * (100.0 * t).cos()).abs())
            .fold(0.0, f64::max);
        let told = found.off_by.first().map_or(0.0, |off| off.1);
        println!(
            "{rtol}: {error:.1e} {told:.1e} {:?} {:?}",
            found.agreement, found.warnings
        );
        assert!(error > 3e-4, "followed: {error:.1e}");
        assert!(
            (0.5..5.0).contains(&(told / error)),
            "off by {error:.1e}, told {told:.1e}"
        );
    }
}

rncf::model! {
    /// A fast top whose centre goes round by two decimetres and nods by 0.4 mm.
    pub model FastTop {
        rigid top {
            mass = 1 kg;
            inertia = [1e-3, 1e-3, 1.5e-3] kg*m^2;
            center = [0, 0, 0.1] m;
            axis = x;
            angle = 40 deg;
            angular_velocity = [0, 0, 1000] rad/s;
        }
        joint pivot = spherical(top.at([0, 0, 0] m), inertial.at([0, 0, 0] m));
        load weight = gravity([0, 0, -9.81] m/s^2);
        output centre = top.center;
        run { t_end = 10 s; every = 0.01 s; }
    }
}

/// Height of the centre by the polar angle alone: the moments about both axes of symmetry are kept.
fn height_of_the_centre(times: &[f64]) -> Vec<f64> {
    let [weight, lever, across, along] = [9.81, 0.1, 1e-3 + 0.01, 1.5e-3];
    let begin = 40f64.to_radians();
    let [about, up] = [along * 1000.0, along * 1000.0 * begin.cos()];
    let rate = |angle: f64| {
        let turn = (up - about * angle.cos()) / angle.sin();
        let precession = turn / (across * angle.sin());
        (precession * precession * across * angle.sin() * angle.cos() - precession * about * angle.sin()
            + weight * lever * angle.sin())
            / across
    };
    let (mut t, mut angle, mut speed) = (0.0, begin, 0.0);
    let step = 1e-4;
    let mut heights = Vec::new();
    for &until in times {
        while t < until - 0.5 * step {
            let [a, b] = [speed, rate(angle)];
            let [c, d] = [speed + 0.5 * step * b, rate(angle + 0.5 * step * a)];
            let [e, f] = [speed + 0.5 * step * d, rate(angle + 0.5 * step * c)];
            let [g, h] = [speed + step * f, rate(angle + step * e)];
            angle += step / 6.0 * (a + 2.0 * c + 2.0 * e + g);
            speed += step / 6.0 * (b + 2.0 * d + 2.0 * f + h);
            t += step;
        }
        heights.push(lever * angle.cos());
    }
    heights
}

/// The place is right to a thousandth, and its height, which changes by so much less, is not.
#[test]
fn small_components_of_vectors_are_judged_by_their_own_change() {
    let found = run(&FastTop::default(), &judged(1e-6, Judging::Affordable)).unwrap();
    let right = height_of_the_centre(&found.history.keys);
    let own: Vec<f64> = found.history.column(2).collect();
    let change = right.iter().map(|z| (z - right[0]).abs()).fold(0.0, f64::max);
    let error = own.iter().zip(&right).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / change;
    println!("{change} m, off by {error}: {:?} {:?}", found.warnings, found.agreement);
    let note = found.warnings.iter().find(|note| note.contains("`centre.z` by"));
    let note = note.unwrap_or_else(|| panic!("off by {error}: {:?} {:?}", found.warnings, found.agreement));
    let told = super::judged_forces::told(note, "centre.z").unwrap_or(0.5);
    assert!(
        error > 0.01 && (0.3..3.0).contains(&(told / error)),
        "off by {error}, told {told}"
    );
}

rncf::model! {
    /// A compressor's shaft with three discs on oil films, seen in a frame that flies with it.
    pub model FreeShaft {
        param speed = 250 rad/s;
        param eccentricity = 100 um;
        material steel { density = 7850 kg/m^3; young = 205 GPa; poisson = 0.29; }
        section round = circle(radius = 50 mm);
        frame rotor = free(angular_velocity = [speed, 0 [rad/s], 0 [rad/s]]);
        body shaft in rotor { spatial; line from [0, 0, 0] m to [1.8, 0, 0] m; section_y [0, 1, 0]; mesh 20 * beam(round, steel); mean_axes; }
        for i in 0..3 {
            fixture disc[i] on shaft.at(0.54 m + i * 0.36 [m]) {
                mass = 40 kg + i * 5 [kg]; center = [0 m, eccentricity * (1 - i), eccentricity * i / 2]; inertia = [0.6, 0.32, 0.32] kg*m^2;
            }
        }
        spring thrust = bushing(shaft.at(0.18 m), inertial.at([0.18, 0, 0] m), stiffness = [10, 0, 0] MN/m);
        for k in 0..2 {
            spring film[k] = bushing(shaft.at(0.18 m + k * 1.44 [m]), inertial.at([0.18 m + k * 1.44 [m], 0 m, 0 m]),
                stiffness = [[0, 0, 0], [0, 26.65, 5.05], [0, -5.05, 26.65]] MN/m, damping = [0, 67.5, 67.5] kN*s/m);
        }
        spring seal = bushing(shaft.at(0.9 m), inertial.at([0.9, 0, 0] m), stiffness = [[0, 0, 0], [0, 1, 3], [0, -3, 1]] MN/m,
            damping = [0, 3, 3] kN*s/m);
        output middle: um = shaft.at(0.9 m).y;
        output moment = shaft.at(0.72 m).moment_z;
        run { t_end = 0.05 s; every = 0.2 ms; }
    }
}

rncf::model! {
    /// A blade that turns evenly.
    pub model EvenBlade {
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section strip = rectangle(y = 60 mm, z = 8 mm);
        frame hub = rotating(axis = z, angle = 4 [rad/s] * t);
        body blade in hub { spatial; line from [0.3, 0, 0] m to [3, 0, 0.3] m; mesh 8 * beam(strip, alloy); }
        joint root = clamp(blade.start, hub);
        output moment = blade.at(0.7 m).moment_y;
        run { t_end = 0.1 s; every = 1 ms; }
    }
}

/// The second run on a finer mesh loses its way by its own steps, which is no error of the mesh.
#[test]
fn steps_of_the_comparison_are_not_told_as_a_coarse_mesh() {
    let found = run(&FreeShaft::default(), &judged(1e-6, Judging::Affordable)).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    assert!(found.agreement.is_some());
}

/// A moment that stands still is off by a part of its value, and not by all of the 1e-13 by which it changes.
#[test]
fn what_stands_still_is_judged_by_its_value() {
    let settings = RunSettings {
        start: Some(Start::Steady),
        ..judged(1e-6, Judging::Affordable)
    };
    let found = run(&EvenBlade {}, &settings).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let steady = rncf::app::steady(
        &EvenBlade {},
        &rncf::app::EquilibriumSettings {
            judged: Judging::Affordable,
            ..rncf::app::EquilibriumSettings::default()
        },
    )
    .unwrap();
    let (own, other) = (found.off_by[0].1, steady.off_by[0].1);
    println!("{own:.1e} {other:.1e}");
    assert!(
        own > 1e-5 && (0.5..2.0).contains(&(own / other)),
        "{own:.1e} {other:.1e}"
    );
}

rncf::model! {
    /// A slow mass on a spring, and what a sensor makes of it.
    pub model Modulated {
        rigid mass { plane xy; mass = 1 kg; origin = [0.1, 0, 0] m; }
        spring coil = linear(mass, inertial.at([-1, 0, 0] m), stiffness = 1 N/m, length = 1 m);
        output carrier = sin(2 * pi * 300 [Hz] * t);
        output modulated = mass.x * sin(2 * pi * 300 [Hz] * t);
        run { t_end = 20 s; every = 7 ms; }
    }
}

/// What an output has of the time alone no step loses.
#[test]
fn what_outputs_have_of_the_time_is_no_vibration() {
    let found = run(&Modulated {}, &judged(1e-6, Judging::Affordable)).unwrap();
    let right = found
        .history
        .keys
        .iter()
        .map(|t| (2.0 * std::f64::consts::PI * 300.0 * t).sin());
    let off = found
        .history
        .column(0)
        .zip(right)
        .map(|(own, right)| (own - right).abs());
    assert!(off.fold(0.0, f64::max) < 1e-9);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

rncf::model! {
    /// A motor that drives a fan over a coupling, which swings as the motor starts and is damped; the steps grow as it comes to rest.
    pub model StartUp {
        table m { at = speed; speed = [-10, 0, 100, 140, 157] rad/s; torque = [55, 50, 70, 110, 0] N*m; interpolation = monotone; }
        rigid rotor { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; }
        rigid fan { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
        joint b1 = revolute(inertial.at([0, 0, 0] m), rotor);
        joint b2 = revolute(rotor, fan);
        spring c = torsional_law(b2, moment = 600 [N*m/rad] * angle + 2e5 [N*m/rad^3] * angle^3 + 1 [N*m*s/rad] * rate);
        load el = moment(rotor, [0, 0, m.torque(rotor.speed)]);
        load air = moment(fan, [0, 0, -2e-3 [N*m*s^2/rad^2] * fan.speed * abs(fan.speed)]);
        output w: rpm = rotor.speed;
        output cr = c.rate;
        run { t_end = 5 s; every = 20 ms; }
    }
}

/// What swings while steps are short, and has died away where they are long, is not lost.
#[test]
fn a_vibration_that_dies_away_before_steps_grow_is_not_lost() {
    let [found, fine] = [1e-6, 1e-10].map(|rtol| run(&StartUp {}, &judged(rtol, Judging::Affordable)).unwrap());
    let largest = fine.history.column(1).map(f64::abs).fold(0.0, f64::max);
    let apart = found.history.column(1).zip(fine.history.column(1));
    let apart = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-3 * largest, "{apart} of {largest}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

rncf::model! {
    /// A geared pair of shafts under constant moments: steps of half a second are exact.
    pub model Geared {
        frame s1 = hinged(axis = x);
        frame s2 = hinged(axis = z);
        fixture w1 on s1 { mass = 1 kg; inertia = [0.02, 0.02, 0.02] kg*m^2; }
        fixture w2 on s2 { mass = 1 kg; inertia = [0.3, 0.3, 0.3] kg*m^2; }
        constraint teeth = s1.angle - 2.5 * s2.angle;
        load m1 = moment(s1, [3 [N*m], 0, 0]);
        load m2 = moment(s2, [0, 0, -2 [N*m]]);
        output a1: rev = s1.angle;
        run { t_end = 5 s; every = 10 ms; }
    }
}

#[test]
fn a_parabola_in_long_steps_is_no_vibration() {
    let found = run(&Geared {}, &judged(1e-6, Judging::Affordable)).unwrap();
    // The moment and inertia that act on the first shaft.
    let acceleration = (3.0 - 2.0 / 2.5) / (0.02 + 0.3 / 2.5_f64.powi(2));
    let wanted = acceleration * 12.5 / (2.0 * std::f64::consts::PI);
    let last = found.history.column(0).last().unwrap();
    assert!((last / wanted - 1.0).abs() < 1e-9, "{last} {wanted}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    assert!(found.off_by.iter().all(|(_, part)| *part < 1e-6), "{:?}", found.off_by);
}

rncf::model! {
    /// A body that turns about its middle axis, and over and over.
    pub model Over {
        rigid top { mass = 1 kg; inertia = [1, 2, 3] kg*m^2; velocity = [1, 0, 0] m/s; angular_velocity = [1e-3, 6, 1e-3] rad/s; }
        output spin = top.angular_velocity;
        output energy = total.kinetic_energy;
        run { t_end = 20 s; every = 0.05 s; }
    }
}

/// Euler's equations of the body: its angular velocity, body axes, rad/s.
struct Euler;

impl System for Euler {
    fn size(&self) -> usize {
        3
    }

    fn rate(&self, _t: f64, w: &[f64], rate: &mut [f64]) {
        rate.copy_from_slice(&[-w[1] * w[2], w[2] * w[0], -w[0] * w[1] / 3.0]);
    }

    fn load_jacobian(&self, _t: f64, _w: &[f64], _jacobian: &mut Matrix) {
        unreachable!("an explicit method asks for none")
    }
}

/// Largest distance from them, as part of the range of 12 rad/s.
fn off_from_euler(found: &rncf::app::RunResult) -> f64 {
    let right = agreed(
        &Euler,
        Explicit::DoPri8,
        1e-14,
        &[1e-3, 6.0, 1e-3],
        &found.history.keys,
        3e-6,
    )
    .unwrap();
    println!("Euler's equations: tolerances agree to {:.1e} rad/s", right.difference);
    let off = (0..3).flat_map(|axis| {
        let pairs = found.history.column(axis).zip(&right.states);
        pairs.map(move |(own, right)| (own - right[axis]).abs() / 12.0)
    });
    off.fold(0.0, f64::max)
}

/// Small tolerances hold, and what is told of them is at least the error; what is kept is no other motion.
#[test]
fn small_tolerances_are_told_as_they_are() {
    for (rtol, least) in [(1e-11, 1e-5), (1e-12, 1e-6)] {
        let found = run(&Over {}, &judged(rtol, Judging::Affordable)).unwrap();
        let error = off_from_euler(&found);
        let told = found.off_by.iter().find(|off| off.0 == 0).map_or(0.0, |off| off.1);
        println!(
            "{rtol}: off by {error:.1e}, told {told:.1e}, {:?} {:?}",
            found.warnings, found.agreement
        );
        assert!(error < least, "{rtol}: off by {error:.1e}");
        assert!(
            error < told && told < 1e-3,
            "{rtol}: off by {error:.1e}, told {told:.1e}"
        );
        assert!(found.warnings.is_empty(), "{rtol}: {:?}", found.warnings);
    }
}

rncf::model! {
    /// Two rods that swing about as they please. Energy begins at zero, and stays there.
    pub model TwoRods {
        rigid upper { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0.5, 0, 0] m; }
        rigid lower { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [1.5, 0, 0] m; }
        joint shoulder = revolute(inertial.at([0, 0, 0] m), upper.at([-0.5, 0, 0] m));
        joint elbow = revolute(upper.at([0.5, 0, 0] m), lower.at([-0.5, 0, 0] m));
        load weight = gravity([0, -9.81, 0] m/s^2);
        output energy = total.kinetic_energy + total.gravity_energy;
        run { t_end = 5 s; every = 10 ms; }
    }
}

/// An error of the energy within the tolerance is in the line of agreement, in its unit, and no warning at any tolerance.
#[test]
fn energy_that_is_kept_to_the_tolerance_is_not_warned_of() {
    for rtol in [1e-7, 1e-9, 1e-12] {
        let found = run(&TwoRods {}, &judged(rtol, Judging::Affordable)).unwrap();
        let error = found.history.column(0).map(f64::abs).fold(0.0, f64::max);
        println!(
            "{rtol}: off by {error:.1e} J, {:?} {:?}",
            found.warnings, found.agreement
        );
        assert!(error < 100.0 * rtol * 10.0, "{rtol}: off by {error:.1e} J");
        assert!(found.warnings.is_empty(), "{rtol}: {:?}", found.warnings);
        let line = found.agreement.unwrap();
        let told = line
            .split("`energy` by ")
            .nth(1)
            .and_then(|rest| rest.split(' ').next()?.parse::<f64>().ok());
        let told = told.unwrap_or_else(|| panic!("{rtol}: {line}"));
        assert!(
            (0.3..3.0).contains(&(told / error)),
            "{rtol}: off by {error:.1e}, told {told:.1e}"
        );
    }
}

mod opposed {
    rncf::model! {
        /// Two discs on one axle, which a spring turns against each other: their momenta have no sum.
        pub model Opposed {
            param stiffness = 0.5 N*m;
            rigid a { plane xy; mass = 2 kg; inertia = 50 kg*m^2; }
            rigid b { plane xy; mass = 5 kg; inertia = 2 kg*m^2; center = [0.5, 0, 0] m; angle = 90 deg; }
            joint axle = revolute(a.at([0, 0, 0] m), b.at([0, 0, 0] m));
            spring coil = torsional_law(axle, moment = stiffness * angle);
            output angle = axle.angle;
            output momentum = total.angular_momentum;
            run { t_end = 30 s; every = 0.02 s; }
        }
    }
}

/// What remains of the sum is an error of the tolerance, and was "another motion, by more than 50 %" at each.
#[test]
fn a_momentum_of_zero_is_no_other_motion() {
    for rtol in [1e-6, 1e-8] {
        let found = run(&opposed::Opposed::default(), &judged(rtol, Judging::Affordable)).unwrap();
        assert!(found.warnings.is_empty(), "{rtol}: {:?}", found.warnings);
    }
}

mod shaken {
    rncf::model! {
        /// A column that a pulsating force shakes along its axis, and that bends by 26 um.
        pub model Shaken {
            param speed = 100 rad/s;
            section bar { EA = 4.2 MN; EI = 100 N*m^2; mass = 1.5 kg/m; }
            body c { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 12 * cable(bar, axial = engineering, bending = exact);
                initial velocity [0 [m/s], 1e-3 [m/s] * sin(pi * x / 1 [m]), 0 [m/s]]; }
            joint foot = pin(c.start, inertial);
            joint top = hold(c.end.y);
            load push = force(c.end, [-300 [N] - 400 [N] * cos(speed * t), 0, 0]);
            load air = distributed(c, -1 [N*s/m^2] * velocity);
            output y = c.at(0.5 m).y;
            run { t_end = 1 s; every = 2 ms; }
        }
    }
}

/// A tolerance of 1e-4 knows nothing of the bending, and the mesh was blamed for "more than 50 %".
#[test]
fn a_mesh_is_not_blamed_for_what_larger_steps_lose() {
    let found = run(&shaken::Shaken::default(), &judged(1e-6, Judging::Affordable)).unwrap();
    let blamed = found.warnings.iter().find(|note| note.contains("too coarse"));
    assert!(blamed.is_none(), "{blamed:?}");
}

rncf::model! {
    /// A body that slides, and does not turn but by round-off.
    pub model Slide {
        rigid sledge {
            mass = 1 kg;
            inertia = [0.12, 0.14, 0.17, 0.01, -0.02, 0.007] kg*m^2;
            center = [-0.2, 0.35, 0.18] m;
            origin = [1.1, 2.2, 0.2] m;
            axis = [0, 0.6, -0.9];
            angle = 0.47 rad;
        }
        joint rail = prismatic(inertial, sledge.at([0.19, -0.6, -0.75] m), axis = [-0.32, -0.19, -0.05]);
        load weight = gravity([3, -5.7, 4] m/s^2);
        output turning = sledge.angular_velocity;
        output place = sledge.position;
        run { t_end = 1 s; every = 20 ms; }
    }
}

/// Constraints keep a rate at zero with the round-off of what moves: runs do not differ in it.
#[test]
fn what_is_kept_at_rest_is_not_told_as_another_motion() {
    for rtol in [1e-4, 1e-6, 1e-8] {
        let found = run(&Slide {}, &judged(rtol, Judging::Affordable)).unwrap();
        assert!(found.warnings.is_empty(), "{rtol}: {:?}", found.warnings);
        let turning = (0..3).flat_map(|axis| found.history.column(axis));
        assert!(turning.map(f64::abs).fold(0.0, f64::max) < 1e-12);
    }
}
