//! Velocities that prescribed frames take at once: what they carry keeps its own in space, but for what holds it; and motions that go over smoothly.

use rncf::app::{Judging, RunSettings, run};
use rncf::prelude::*;

use crate::runs::adaptive;

rncf::model! {
    /// A cantilever whose base moves with 1 m/s at once.
    pub model Jolted {
        param v = 1 m/s;
        param t0 = 1 ms;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; }
        section strip = rectangle(y = 10 mm, z = 20 mm);
        motion way(t) = if t < t0 { 0 m } else { v * (t - t0) };
        frame base = moving(origin = [0 m, way(t), 0 m]);
        body arm in base { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 16 * cable(strip, alloy); }
        joint root = clamp(arm.start, base);
        output tip = arm.end.y;
        run { t_end = 31 ms; every = 1 ms; }
    }
}

/// Roots of `cos x cosh x = -1`, and where the tip goes per speed of the base: twice the participation of the mode.
fn tip(t: f64) -> f64 {
    let (length, young, height, density) = (0.5f64, 70e9f64, 0.01f64, 2700.0f64);
    let speed = (young * height * height / 12.0 / density).sqrt() / (length * length);
    (1..=12)
        .map(|k| {
            let mut x = (f64::from(k) - 0.5) * std::f64::consts::PI;
            for _ in 0..50 {
                // 1 / cosh keeps the numbers small.
                x -= (x.cos() + 1.0 / x.cosh()) / (-x.sin() - x.tanh() / x.cosh());
            }
            let sigma = (x.sinh() - x.sin()) / (x.cosh() + x.cos());
            let participation = 2.0 * sigma / x;
            let at_the_tip = if k % 2 == 1 { 2.0 } else { -2.0 };
            let omega = x * x * speed;
            -participation * at_the_tip * (omega * t).sin() / omega
        })
        .sum()
}

/// The sum of twelve modes at rest in space, seen from the base, without rotary inertia.
#[test]
fn a_cantilever_whose_base_is_jolted_swings() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let settings = RunSettings {
            formulation,
            options: Options {
                rtol: 1e-7,
                ..Options::default()
            },
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = run(&Jolted::default(), &settings).unwrap();
        let rows = found.history.keys.iter().zip(found.history.column(0)).skip(1);
        let (mut off, mut size) = (0.0f64, 0.0f64);
        for (t, y) in rows {
            let exact = tip(t - 1e-3);
            (off, size) = (off.max((y - exact).abs()), size.max(exact.abs()));
        }
        println!("{formulation:?}: {off:.2e} of {size:.2e} m");
        assert!(
            size > 5e-3 && off < 5e-3 * size,
            "{formulation:?}: {off:.2e} of {size:.2e} m"
        );
    }
}

rncf::model! {
    /// Bars on a sledge that moves with 1 m/s at once: pinned, flexible and rigid, and clamped, in modes.
    pub model Sledge {
        param v = 1 m/s;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; }
        section strip = rectangle(y = 10 mm, z = 20 mm);
        motion way(t) = if t < 1 ms { 0 m } else { v * (t - 1 [ms]) };
        frame sledge = moving(origin = [0 m, way(t), 0 m]);
        body whole in sledge { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 4 * cable(strip, alloy); }
        joint first = pin(whole.start, sledge);
        body modes in sledge { planar xy; line from [0, 1, 0] m to [0.5, 1, 0] m; mesh 4 * cable(strip, alloy); modal(6); }
        joint second = clamp(modes.start, sledge);
        rigid stiff in sledge { plane xy; mass = 0.27 kg; inertia = 0.01 kg*m^2; origin = [0, 2, 0] m; center = [0.25, 0, 0] m; }
        joint third = revolute(sledge.at([0, 2, 0] m), stiff);
        output of_whole = whole.angular_momentum(about = whole.start);
        output of_stiff = stiff.angular_momentum(about = stiff.at([0, 0, 0] m));
        output tip = modes.end.y - 1 m;
        run { t_end = 4 ms; every = 1 ms; }
    }
}

/// The pull of a pin goes through it: a bar turns by -3/2 v/L, so that it has no angular momentum about the pin, and not that of `swept`, of a bar
/// that goes along. The clamped one is that of the other scene, with six modes.
#[test]
fn a_pinned_bar_keeps_its_angular_momentum_about_the_pin() {
    let found = run(&Sledge::default(), &RunSettings::default()).unwrap();
    let swept = 2700.0 * 0.01 * 0.02 * 0.5 * 1.0 * 0.25;
    for column in 0..2 {
        let most = found
            .history
            .column(column)
            .fold(0.0f64, |most, value| most.max(value.abs()));
        println!("{column}: {most:.2e} of {swept:.2e} kg m^2/s");
        assert!(most < 1e-3 * swept, "{column}: {most:.2e} of {swept:.2e} kg m^2/s");
    }
    for (t, y) in found.history.keys.iter().zip(found.history.column(2)).skip(2) {
        let exact = tip(t - 1e-3);
        println!("{t} s: {y:.4e} for {exact:.4e} m");
        assert!((y / exact - 1.0).abs() < 0.05, "{t} s: {y:.4e} for {exact:.4e} m");
    }
}

rncf::model! {
    /// A slider-crank whose rod is damped. The crank is run up in half a second, and turns on evenly: nothing jumps up to the third derivative.
    pub model RunUp {
        param speed = 60 rpm;
        param until = 0.5 s;
        param c = 1 ms;
        material plastic { density = 1200 kg/m^3; young = 2 GPa; damping = c; }
        section strip { area = 1 cm^2; second_moment = 0.08 cm^4; }
        motion turned(t) = if t <= until {
            speed / until * (t^2 / 2 + (until / (2 * pi))^2 * (cos(2 * pi * t / until) - 1))
        } else {
            speed * (t - until / 2)
        };
        frame crank = rotating(axis = z, angle = turned(t));
        frame beside = free(plane = xy, origin = [0.2, 0, 0] m);
        body rod in beside { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * cable(strip, plastic); chord; }
        joint crankpin = revolute(crank.at([0.2, 0, 0] m), rod.start);
        rigid slider { plane xy; mass = 0.1 kg; inertia = 0.001 kg*m^2; origin = [0.7, 0, 0] m; }
        joint guide = prismatic(inertial, slider, axis = x);
        joint wrist = revolute(slider, rod.end);
        output place = slider.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// What the method leaves of the rates of joints is no impact on the rod, whose damping would answer it with accelerations of 1e5 m/s^2. The rod is
/// stiff: its slider is where that of a rigid one is.
#[test]
fn a_smooth_run_up_ends_without_an_impact_on_what_is_damped() {
    for (rtol, c) in [(1e-3, 1e-3), (1e-5, 1e-3), (1e-6, 50e-3)] {
        let settings = RunSettings {
            options: adaptive(rtol),
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = run(&RunUp { c, ..RunUp::default() }, &settings).unwrap();
        let (speed, until, turn) = (std::f64::consts::TAU, 0.5, std::f64::consts::TAU);
        let rows = found.history.keys.iter().zip(found.history.column(0));
        let off = rows.map(|(&t, place)| {
            let angle = match t <= until {
                true => speed / until * (t * t / 2.0 + (until / turn).powi(2) * ((turn * t / until).cos() - 1.0)),
                false => speed * (t - until / 2.0),
            };
            let exact = 0.2 * angle.cos() + (0.25 - (0.2 * angle.sin()).powi(2)).sqrt();
            (place - exact).abs()
        });
        let off = off.fold(0.0, f64::max);
        println!("rtol {rtol:e}, c = {c} s: {off:.2e} m");
        assert!(off < 1e-4, "rtol {rtol:e}, c = {c} s: {off:.2e} m");
    }
}
