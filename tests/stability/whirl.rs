//! T5 of THEORY 10: a balanced shaft above its critical speed, bent by its own internal damping; what is physical in
//! it and what an integrator adds.

use rncf::modes::Mode;
use rncf::{Method, Model, Options, Scene, State, StepSize};
use rncf_models::Motor;

use crate::agrees;
use crate::scenes::{equilibrium, outputs, referenced, run};

/// rad/s of one revolution a minute.
const RPM: f64 = std::f64::consts::PI / 30.0;

rncf::model! {
    /// The balanced motor with a damper between disc and ground.
    pub model Damped {
        param speed = 20000 rpm;
        param damping = 1 us;
        /// Of the damper.
        param outside = 0 N*s/m;

        const length = 1.02 m;
        const disc_mass = 7800 [kg/m^3] * pi * 0.0001 [m^3];
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; damping = damping; }
        section round = circle(radius = 50 mm);
        frame rotor = rotating(axis = x, angle = speed * t);
        body shaft in rotor {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh 4 * beam(round, steel);
        }
        joint drive_end = clamp(shaft.start, rotor);
        joint far_end = pin(shaft.end, rotor);
        fixture disc on shaft.at(length / 2) {
            mass = disc_mass;
            inertia = [disc_mass * 0.005 [m^2], disc_mass * 0.0025083333 [m^2], disc_mass * 0.0025083333 [m^2]];
        }
        spring damper = bushing(shaft.at(length / 2), inertial.at([length / 2, 0, 0]),
            stiffness = [0, 0, 0] N/m, damping = [0 [N s/m], outside, outside]);
        output v_mid = shaft.at(length / 2).y;
        output w_mid = shaft.at(length / 2).z;
        run { t_end = 1 s; every = 1 ms; }
    }
}

fn motor(rpm: f64, damping: f64, eccentricity: f64) -> Motor {
    Motor {
        speed: rpm * RPM,
        T_s: 0.1,
        damping,
        eccentricity,
        ..Motor::default()
    }
}

/// Largest rate of growth (1/s) of the lowest modes about the equilibrium.
fn growth(model: &impl Model) -> f64 {
    let (_, modes) = equilibrium(referenced(model).as_mut(), 1.0, 4);
    modes.iter().map(|mode| mode.re).fold(f64::NEG_INFINITY, f64::max)
}

/// Distance of the shaft's middle from the axis, m.
fn radius(scene: &mut dyn Scene, state: &State) -> f64 {
    let row = outputs(scene, state);
    row[0].hypot(row[1])
}

/// A motion in one mode alone that begins `size` (m) off the axis.
fn in_mode(scene: &mut dyn Scene, straight: &State, mode: &Mode, size: f64) -> State {
    let moved = |factor: f64| {
        let mut state = straight.clone();
        for ((x, v), [re, im]) in state.x.iter_mut().zip(&mut state.v).zip(&mode.shape) {
            *x += factor * re;
            *v += factor * (mode.re * re - mode.im * im);
        }
        state
    };
    let unit = radius(scene, &moved(1e-6));
    moved(1e-6 * size / unit)
}

/// Rate of growth over half a second of a whirl of 10 um, as an integrator sees it.
fn seen(model: &Motor, rho_inf: f64, h: f64) -> f64 {
    let mut scene = referenced(model);
    let (straight, modes) = equilibrium(scene.as_mut(), 1.0, 4);
    let start = in_mode(scene.as_mut(), &straight, &modes[0], 1e-5);
    let (before, duration) = (radius(scene.as_mut(), &start), 0.5);
    let options = Options {
        rtol: 1e-12,
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let end = start.t + duration;
    let method = Method::GeneralizedAlpha { rho_inf };
    let (state, _) = run(scene.as_mut(), start, end, method, options).unwrap();
    (radius(scene.as_mut(), &state) / before).ln() / duration
}

#[test]
fn internal_damping_destabilises_the_balanced_shaft_alone() {
    for (rpm, printed) in [
        (15000.0, -0.2155),
        (17500.0, 0.0187),
        (20000.0, 0.2530),
        (25000.0, 0.7216),
    ] {
        let [none, balanced] = [0.0, 1e-6].map(|damping| growth(&motor(rpm, damping, 0.0)));
        println!("{rpm} rpm: {none:.1e} without damping, {balanced:.4} 1/s");
        assert!(none.abs() < 1e-9);
        agrees(balanced, printed, 0.01);
    }
    for (rpm, printed) in [
        (7500.0, -0.918),
        (10000.0, -0.685),
        (12500.0, -0.455),
        (15000.0, -0.254),
        (17500.0, -0.216),
        (20000.0, -0.288),
    ] {
        let bent = growth(&motor(rpm, 1e-6, 0.05));
        println!("unbalanced, {rpm} rpm: {bent:.4} 1/s");
        agrees(bent, printed, 0.01);
    }
}

#[test]
fn damping_outside_holds_what_damping_inside_bends() {
    let at = |damping: f64, outside: f64| {
        growth(&Damped {
            damping,
            outside,
            ..Damped::default()
        })
    };
    let found = [at(1e-6, 0.0), at(1e-6, 100.0), at(1e-5, 0.0), at(1e-5, 100.0)];
    println!("20000 rpm, 1 us and 10 us, each without and with 100 N s/m: {found:.3?} 1/s");
    assert!((found[0] - growth(&motor(20000.0, 1e-6, 0.0))).abs() < 1e-3);
    assert!(found[2] > 0.0);
    agrees(found[1], -1.306, 0.01);
    agrees(found[3], 0.971, 0.01);
}

/// The same growth with half the step and with hardly any numerical damping: physical. Long steps with strong numerical
/// damping make the unstable shaft stable: that is where the comparison fails.
#[test]
fn numerical_damping_hides_the_instability() {
    let (unstable, free) = (motor(20000.0, 1e-6, 0.0), motor(20000.0, 0.0, 0.0));
    let linear = growth(&unstable);
    for (rho_inf, h, physical) in [
        (0.95, 1e-3, true),
        (0.95, 5e-4, true),
        (0.6, 2.5e-4, true),
        (0.6, 4e-3, false),
    ] {
        let [grown, neutral] = [&unstable, &free].map(|model| seen(model, rho_inf, h));
        println!("rho {rho_inf}, h {h}: {grown:.4} 1/s, without damping {neutral:.4} 1/s; linear {linear:.4} 1/s");
        if physical {
            assert!((grown - linear).abs() < 0.02 * linear && neutral.abs() < 0.02 * linear);
        } else {
            agrees(grown, -0.681, 0.02);
            agrees(neutral, -0.867, 0.02);
        }
    }
}

#[test]
fn the_shaft_ends_bent_and_still() {
    let model = motor(25000.0, 1e-5, 0.0);
    let mut scene = referenced(&model);
    let (straight, modes) = equilibrium(scene.as_mut(), 1.0, 4);
    let start = in_mode(scene.as_mut(), &straight, &modes[0], 1e-4);
    let options = Options {
        rtol: 1e-6,
        ..Options::default()
    };
    let (state, found) = run(scene.as_mut(), start, 4.0, Method::Radau, options).unwrap();
    let (bent, row) = (radius(scene.as_mut(), &state), outputs(scene.as_mut(), &state));
    let speed = state.v.iter().fold(0.0f64, |most, v| most.max(v.abs()));
    println!(
        "bent by {bent:.5} m, {row:.3?}; still moves by {speed:.1e} m/s; {} steps",
        found.steps
    );
    agrees(bent, 0.072, 0.02);
    assert!(speed < 1e-2);
}
