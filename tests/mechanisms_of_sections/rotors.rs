//! Rotors on elastic bearings against closed forms of a stiff shaft (Jeffcott).

// Models from one template do not use all of its params.
#![allow(deprecated)]

use rncf::app::{EquilibriumSettings, modes};
use rncf::equilibrium::Uniform;
use rncf::modes::Motion;
use rncf::steady;

use crate::running::{WAYS, apart, build, rows, run};

/// A stiff shaft with an unbalanced disc in its middle, on a bushing at either end.
macro_rules! rotor {
    ($name:ident, { $($frame:tt)* }, { $($start:tt)* }, { $($ties:tt)* }) => {
        rncf::model! {
            pub model $name {
                param speed = 100 rad/s;
                /// Of one bearing.
                param stiffness_y = 200 kN/m;
                param stiffness_z = 200 kN/m;
                param damping = 0 N*s/m;
                /// Start beside the axis, and velocity along z relative to the frame.
                param beside = 0 m;
                param across = 0 m/s;
                material stiff { density = 7800 kg/m^3; young = 2.1e6 GPa; poisson = 0.3; }
                section round = circle(radius = 20 mm);
                $($frame)*
                body shaft in spin {
                    spatial;
                    line from [0, 0, 0] m to [0.6, 0, 0] m;
                    mesh 2 * beam(round, stiff);
                    $($start)*
                }
                $($ties)*
                fixture disc on shaft.at(0.3 m) { mass = 10 kg; center = [0, 1, 0] mm; inertia = [0.1, 0.05, 0.05] kg*m^2; }
                spring left = bushing(shaft.start, inertial.at([0, 0, 0] m), stiffness = [0, stiffness_y, stiffness_z], damping = [0, damping, damping]);
                spring right = bushing(shaft.end, inertial.at([0.6, 0, 0] m), stiffness = [0, stiffness_y, stiffness_z], damping = [0, damping, damping]);
                output middle = shaft.at(0.3 m).in(inertial);
                output turning_with = shaft.at(0.3 m).in(spin);
                output end = shaft.end.in(inertial);
                output ey = shaft.at(0.3 m).in(inertial).ey;
            }
        }
    };
}

rotor!(
    Rotor,
    { frame spin = rotating(axis = x, angle = speed * t); },
    {
        initial position [x, beside, 0];
        initial velocity [0, 0, across];
    },
    {
        joint axial = hold(shaft.start.x);
        joint motor = hold(shaft.start.ey.z);
    }
);

rotor!(
    Spinning,
    { frame spin = free(origin = [0, beside, 0], velocity = [0, 0, speed * beside], angular_velocity = [speed, 0, 0]); },
    { mean_axes; },
    {}
);

/// 10 kg and the shaft.
fn mass() -> f64 {
    10.0 + 7800.0 * std::f64::consts::PI * 4e-4 * 0.6
}

const UNBALANCE: f64 = 10.0 * 1e-3;

/// Deflection towards the unbalance and across it, both bearings alike: `(k - m w^2 + i c w) u = U w^2`.
fn jeffcott(speed: f64, stiffness: f64, damping: f64) -> [f64; 2] {
    let (re, im) = (2.0 * stiffness - mass() * speed * speed, 2.0 * damping * speed);
    let size = UNBALANCE * speed * speed / (re * re + im * im);
    [size * re, -size * im]
}

#[test]
fn unbalance_response_of_isotropic_bearings() {
    for damping in [0.0, 500.0] {
        for speed in [50.0, 150.0, 180.0, 200.0, 300.0, 600.0] {
            let model = Rotor {
                speed,
                damping,
                ..Rotor::default()
            };
            let expected = jeffcott(speed, 2e5, damping);
            let size = expected[0].hypot(expected[1]);
            for (formulation, joints) in [WAYS[0], WAYS[1]] {
                let mut scene = build(&model, (formulation, joints));
                let found = steady(scene.as_mut(), 0.0).unwrap();
                let mut row = vec![0.0; scene.output_columns()];
                scene.uniform_outputs(&Uniform::steady(0.0), found.state().unwrap(), &mut row);
                let error = (row[4] - expected[0]).hypot(row[5] - expected[1]) / size;
                println!(
                    "{speed} rad/s, {damping} N s/m: {:.6e} {:.6e}, off by {error:.1e}",
                    row[4], row[5]
                );
                assert!(error < 1e-4, "{error}");
            }
        }
    }
}

/// Forward and backward circle together: the response along y and z, each with its own stiffness.
#[test]
fn unbalance_response_of_anisotropic_bearings() {
    let speed = 100.0;
    let [along, other] = [2e5, 4e5].map(|stiffness| jeffcott(speed, stiffness, 0.0)[0]);
    let model = Rotor {
        speed,
        stiffness_z: 4e5,
        beside: along,
        across: speed * (other - along),
        ..Rotor::default()
    };
    let refused = steady(build(&model, WAYS[0]).as_mut(), 0.0).unwrap_err().to_string();
    println!("{refused}");
    assert!(refused.contains("`left`"), "{refused}");
    for way in WAYS {
        let mut scene = build(&model, way);
        let states = run(scene.as_mut(), 0.2, 40, 1e-8);
        let mut worst: f64 = 0.0;
        for (row, state) in rows(scene.as_mut(), &states).iter().zip(&states) {
            let (sin, cos) = (speed * state.t).sin_cos();
            worst = worst.max((row[1] - along * cos).hypot(row[2] - other * sin));
        }
        println!("{way:?}: {along:.3e}, {other:.3e} m, off by {worst:.1e} m");
        assert!(worst < 2e-4 * along.abs());
    }
}

/// Without a motor: the frame follows the shaft, which goes on whirling.
#[test]
fn shaft_that_spins_freely() {
    for speed in [100.0, 400.0] {
        let whirl = jeffcott(speed, 2e5, 0.0)[0];
        let model = Spinning {
            speed,
            beside: whirl,
            ..Spinning::default()
        };
        let mut first: Option<Vec<Vec<f64>>> = None;
        for way in WAYS {
            let mut scene = build(&model, way);
            let states = run(scene.as_mut(), 0.1, 20, 1e-8);
            let rows = rows(scene.as_mut(), &states);
            let mut worst: f64 = 0.0;
            for (row, state) in rows.iter().zip(&states) {
                let (sin, cos) = (speed * state.t).sin_cos();
                worst = worst.max((row[1] - whirl * cos).hypot(row[2] - whirl * sin));
            }
            let first = first.get_or_insert_with(|| rows.clone());
            // What is seen from the frame is left out: in absolute coordinates it stays at its start.
            let other = apart(first, &rows, 0..3).max(apart(first, &rows, 6..12));
            println!("{speed} rad/s, {way:?}: {whirl:.3e} m, off by {worst:.1e} m, {other:.1e}");
            assert!(worst < 1e-3 * whirl.abs());
            assert!(other < 1e-5);
        }
    }
}

rncf::model! {
    /// A block that swings about `x` and one about `z`, each on its spring.
    model Swings {
        rigid roll { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        rigid yaw { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        joint about_x = revolute(inertial, roll, axis = x);
        joint about_z = revolute(inertial, yaw, axis = z);
        spring first = torsional(about_x, stiffness = 1 N*m/rad);
        spring second = torsional(about_z, stiffness = 4 N*m/rad);
        output turned = about_x.angle;
        output other = about_z.angle;
    }
}

#[test]
fn what_is_rigid_moves_as_that_at_rest_whatever_its_axis() {
    let found = modes(&Swings {}, &EquilibriumSettings::default()).unwrap();
    let frequencies: Vec<f64> = found.modes.iter().map(|mode| mode.im).collect();
    assert!((frequencies[0] - 1.0).abs() < 1e-9 && (frequencies[1] - 2.0).abs() < 1e-9);
    for composition in &found.compositions {
        assert_eq!(composition.motions, [(Motion::Translation, 1.0)]);
    }
}
