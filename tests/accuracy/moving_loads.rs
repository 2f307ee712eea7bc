//! Loads per length that pass over a body, or that it passes, against the sum of its modes and integrals, and those that are too narrow for the points of its elements.

use std::f64::consts::PI;

use rncf::AnyModel;
use rncf::app::{EquilibriumSettings, Judging, RunSettings, run, static_equilibria};

rncf::model! {
    /// A girder on two supports, and a load of 10 kN that runs over it.
    pub model Girder {
        param speed = 30 m/s;
        param width = 0.5 m;
        param start = -6 m;
        param elements: count = 32;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = rectangle(y = 0.2 m, z = 0.3 m);
        body deck { planar xy; line from [0, 0, 0] m to [20, 0, 0] m; mesh elements * beam(bar, steel); }
        joint left = pin(deck.start, inertial);
        joint right = hold(deck.end.y);
        load vehicle = distributed(deck, [0, -10 [kN] / (width * sqrt(pi / 1 rad)) * exp(-((x - start - speed * t) / width)^2), 0]);
        output middle = deck.at(10 m).y;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

/// Deflection of the middle, m: every mode of a slender beam is pushed as long as the load is on it, and swings on. A load that is as wide as a wave of
/// a mode pushes it less.
fn deflection(girder: &Girder, t: f64) -> f64 {
    let (length, mass) = (20.0, 7850.0 * 0.2 * 0.3 * 20.0);
    let stiffness = 210e9 * 0.3 * 0.2_f64.powi(3) / 12.0;
    let mode = |number: i32| {
        let wave = f64::from(number) * PI / length;
        // Shear and the inertia of sections make it slower: Timoshenko's beam, to the first order.
        let slower = 1.0 + (wave * 0.2).powi(2) / 12.0 * (1.0 + 2.6 * 1.2);
        let own = wave.powi(2) * (stiffness * length / mass / slower).sqrt();
        let driven = wave * girder.speed;
        let push = -2.0 * 10e3 / mass * (-0.25 * (wave * girder.width).powi(2)).exp() / (own.powi(2) - driven.powi(2));
        let on = |t: f64| push * ((driven * t).sin() - driven / own * (own * t).sin());
        let rate = |t: f64| push * driven * ((driven * t).cos() - (own * t).cos());
        let (since, over) = (t + girder.start / girder.speed, length / girder.speed);
        let amplitude = if since <= 0.0 {
            0.0
        } else if since <= over {
            on(since)
        } else {
            let free = own * (since - over);
            on(over) * free.cos() + rate(over) / own * free.sin()
        };
        amplitude * (0.5 * wave * length).sin()
    };
    (1..40).map(mode).sum()
}

/// From walking pace of a train to a load that is over the girder within 7 ms, and comes when everything has been at rest for long.
#[test]
fn a_load_that_runs_over_a_beam_is_met() {
    for (speed, start) in [(30.0, -6.0), (3000.0, -1500.0)] {
        let girder = Girder {
            speed,
            start,
            ..Girder::default()
        };
        let result = run(&girder, &RunSettings::default()).unwrap();
        let found = result.history.column(0);
        let exact: Vec<f64> = result.history.keys.iter().map(|&t| deflection(&girder, t)).collect();
        let size = exact.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        let error = exact
            .iter()
            .zip(found)
            .fold(0.0, |error: f64, (a, b)| error.max((a - b).abs()));
        println!(
            "{speed} m/s: {size:.3e} m, off by {:.1e}, {} steps",
            error / size,
            result.statistics.steps
        );
        assert!(error < 4e-3 * size, "{speed} m/s: {error} of {size}");
        assert!(
            !result.warnings.iter().any(|told| told.contains("narrower")),
            "{:?}",
            result.warnings
        );
    }
}

/// Narrow loads between points have no effect, and with twice as many elements neither.
#[test]
fn what_no_point_sees_is_told() {
    let told = |warnings: &[String]| {
        warnings
            .iter()
            .any(|told| told.starts_with("load `vehicle` is narrower"))
    };
    for (width, start, is_missed) in [(5e-3, 10.8, true), (0.05, 0.175, true), (0.5, 10.7, false)] {
        let girder = Girder {
            width,
            start,
            speed: 0.0,
            ..Girder::default()
        };
        let result = static_equilibria(&girder, &EquilibriumSettings::default()).unwrap();
        assert_eq!(told(&result.warnings), is_missed, "{width} m: {:?}", result.warnings);
    }
    let narrow = Girder {
        width: 5e-3,
        elements: 8,
        ..Girder::default()
    };
    let result = run(&narrow, &RunSettings::default()).unwrap();
    assert!(told(&result.warnings), "{:?}", result.warnings);
    // Every point feels it pass: what is left is the distance of points.
    let least = result.history.column(0).fold(0.0, f64::min);
    let exact = result
        .history
        .keys
        .iter()
        .map(|&t| deflection(&narrow, t))
        .fold(0.0, f64::min);
    assert!((least - exact).abs() < 0.2 * exact.abs(), "{least} for {exact}");
}

rncf::model! {
    /// A bar that spins freely in the plane xy and is blown at along z, twice in a turn, where it passes the x axis.
    pub model Whisk {
        param width = 50 mm;
        param spin = 20 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section rod = rectangle(y = 5 cm, z = 5 cm);
        frame hub = free(angular_velocity = [0, 0, spin]);
        body bar in hub { spatial; line from [0, -3, 0] m to [0, 3, 0] m; mesh 12 * beam(rod, steel); rigid; }
        joint held = clamp(bar.start, hub);
        load jet = distributed(bar, [0, 0, 10 [kN/m] * (x / 6 m - 0.5)^2 * exp(-(dot(position, [0, 1, 0]) / width)^2)]);
        output middle = bar.at(3 m).in(inertial).z;
        run { t_end = 2 s; every = 0.02 s; }
    }
}

/// Where the middle is at 2 s, m: what blows at a particle depends on its turn alone, and by symmetry nothing tilts the bar.
fn blown(whisk: &Whisk) -> f64 {
    let (mass, t_end, times, places) = (7850.0 * 0.05 * 0.05 * 6.0, 2.0, 200_000, 40);
    let mut way = 0.0;
    for time in 0..times {
        let t = t_end * (f64::from(time) + 0.5) / f64::from(times);
        let y = (whisk.spin * t).cos();
        let force: f64 = (0..places)
            .map(|place| {
                let arm = 3.0 * (f64::from(place) + 0.5) / f64::from(places);
                2.0 * 10e3 * (arm / 6.0).powi(2) * (-(arm * y / whisk.width).powi(2)).exp() * 3.0 / f64::from(places)
            })
            .sum();
        way += force / mass * (t_end - t) * t_end / f64::from(times);
    }
    way
}

/// Asserts where a run ends, for a jet of a width, m.
fn ends_at(model: &dyn AnyModel, width: f64, exact: f64) {
    let result = run(model, &RunSettings::default()).unwrap();
    let found = result.history.column(0).last().unwrap();
    println!("{width} m: {found} m for {exact} m, {} steps", result.statistics.steps);
    assert!((found - exact).abs() < 2e-3 * exact, "{width} m: {found} for {exact}");
}

/// Steps that do not follow a turn meet what is narrow in space.
#[test]
fn a_bar_that_spins_through_a_jet_feels_it_in_every_turn() {
    for width in [0.05, 0.5] {
        let whisk = Whisk {
            width,
            ..Whisk::default()
        };
        ends_at(&whisk, width, blown(&whisk));
    }
}

rncf::model! {
    /// A bar that spins freely, and is blown at along z at both ends where they pass the x axis.
    pub model Ends {
        param width = 50 mm;
        param spin = 20 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section rod = rectangle(y = 5 cm, z = 5 cm);
        frame hub = free(angular_velocity = [0, 0, spin]);
        body bar in hub { spatial; line from [0, -3, 0] m to [0, 3, 0] m; mesh 12 * beam(rod, steel); rigid; }
        joint held = clamp(bar.start, hub);
        load left = force(bar.start, [0, 0, 10 [kN] * exp(-(bar.start.in(inertial).y / width)^2)]);
        load right = force(bar.end, [0, 0, 10 [kN] * exp(-(bar.end.in(inertial).y / width)^2)]);
        output middle = bar.at(3 m).in(inertial).z;
        run { t_end = 2 s; every = 0.02 s; }
    }
}

/// Where the middle is at 2 s, m: see [`blown`].
fn blown_at_ends(ends: &Ends) -> f64 {
    let (mass, t_end, times) = (7850.0 * 0.05 * 0.05 * 6.0, 2.0, 400_000);
    let dt = t_end / f64::from(times);
    let push = |t: f64| 2.0 * 10e3 * (-(3.0 * (ends.spin * t).cos() / ends.width).powi(2)).exp() / mass;
    (0..times)
        .map(|time| (f64::from(time) + 0.5) * dt)
        .map(|t| push(t) * (t_end - t) * dt)
        .sum()
}

rncf::model! {
    /// Three stones fly past a magnet, through a sheet of force and through a gate, and a wheel is pushed where its arm points along x.
    pub model Passing {
        param width = 200 mm;
        rigid magnetic { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [-50, 0, 0] m; velocity = [100, 0, 0] m/s; }
        rigid pushed { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [-50, 10, 0] m; velocity = [100, 0, 0] m/s; }
        rigid gated { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [-50, 20, 0] m; velocity = [100, 0, 0] m/s; }
        rigid wheel { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [0, 30, 0] m; speed = 200 rad/s; }
        spring magnet = law(magnetic, inertial.at([0, -0.01, 0] m), force = 10 [kN] * (length / width) * exp(-(length / width)^2));
        load sheet = force(pushed, [0, 10 [kN] * max(1 - abs(pushed.x) / width, 0), 0]);
        load gate = force(gated, [0, 5 [kN] * (tanh((gated.x + width) / 1 mm) - tanh((gated.x - width) / 1 mm)), 0]);
        load push = force(wheel, [0, 1 [kN] * exp(-((1 - wheel.ex.x) / 0.001)^2), 0]);
        output magnetic_y = magnetic.y;
        output pushed_y = pushed.y;
        output gated_y = gated.y;
        output wheel_y = wheel.y;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

/// What is narrow in places, lengths and directions is met by what flies or turns, however long its steps would be.
#[test]
fn forces_that_are_narrow_in_space_are_met() {
    for width in [0.05, 0.5] {
        let ends = Ends {
            width,
            ..Ends::default()
        };
        ends_at(&ends, width, blown_at_ends(&ends));
    }
}

/// Where each of them is at 1 s along y, m: from impulses, the wheel's by quadrature, the magnet's by Dormand and Prince's method of order 8 at 1e-12.
#[test]
fn what_flies_or_turns_past_a_force_feels_it() {
    let settings = RunSettings {
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    let result = run(&Passing::default(), &settings).unwrap();
    let end = result.history.keys.len() - 1;
    let exact = [-0.729447237, 10.0 + 10.0, 20.0 + 20.0, 36.452850786];
    for ((index, exact), bound) in exact.iter().enumerate().zip([5e-5, 5e-5, 5e-5, 2e-3]) {
        let found = result.history.column(index).nth(end).unwrap();
        println!("{}: {found} m for {exact} m", result.history.columns[index].name);
        assert!((found - exact).abs() < bound * exact.abs(), "{found} for {exact}");
    }
    // The wheel is pushed for 0.2 ms at a time, and steps of all tolerances are shortened to meet that.
    let told = result.off_by.iter().map(|&(_, part)| part).fold(0.0, f64::max);
    assert!((3e-3..3e-2).contains(&told), "{told}");
}

rncf::model! {
    /// Stones and bars that come from far, each through a narrow jet.
    pub model FromFar {
        const n = 3;
        param width = 50 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section rod = rectangle(y = 5 cm, z = 5 cm);
        for i in 0..n {
            rigid stone[i] { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [-50 m, 10 m * i, 0 m]; velocity = [100, 0, 0] m/s; }
            load jet[i] = force(stone[i], [0, 10 [kN] * exp(-((stone[i].x - i * 5 m) / ((1 + i) * width))^2), 0]);
            output stone_y[i] = stone[i].y;
            frame hub[i] = free(origin = [-50 m, 100 m + 10 m * i, 0 m], velocity = [100, 0, 0] m/s);
            body bar[i] in hub[i] { spatial; line from [0, 0, 0] m to [0, 0, 2] m; mesh 2 * beam(rod, steel); rigid; }
            joint held[i] = clamp(bar[i].start, hub[i]);
            load push[i] = force(bar[i].at(1 m), [0, 10 [kN] * exp(-((bar[i].at(1 m).in(inertial).x - i * 5 m) / ((1 + i) * width))^2), 0]);
            output bar_y[i] = bar[i].at(1 m).in(inertial).y;
        }
        run { t_end = 1 s; every = 0.01 s; }
    }
}

/// A force that is zero at nearly all places is still none of differences of places, which would be evaluated near where things start.
#[test]
fn narrow_forces_stand_where_they_are_written() {
    let far = FromFar::default();
    let result = run(&far, &RunSettings::default()).unwrap();
    let end = result.history.keys.len() - 1;
    for i in 0..3 {
        let number = i as f64;
        let impulse = 10e3 * (1.0 + number) * far.width * PI.sqrt() / 100.0;
        let since = 0.5 - 0.05 * number;
        for (column, start, mass) in [(2 * i, 0.0, 1.0), (2 * i + 1, 100.0, 7850.0 * 0.05 * 0.05 * 2.0)] {
            let way = result.history.column(column).nth(end).unwrap() - start - 10.0 * number;
            let exact = impulse / mass * since;
            assert!(
                (way - exact).abs() < 1e-3 * exact,
                "{}: {way} for {exact}",
                result.history.columns[column].name
            );
        }
    }
}
