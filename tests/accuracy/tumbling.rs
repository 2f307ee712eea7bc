//! What is free and spins about its intermediate axis tumbles: the modes about its relative equilibrium say so.

use rncf::equilibrium::{Uniform, steady};
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Joints, Model};

rncf::model! {
    /// A free rigid hub with four flexible booms, or without.
    pub model Satellite {
        param spin_x = 0 rad/s;
        param spin_y = 0 rad/s;
        param spin_z = 0 rad/s;
        param elements: count = 4;
        /// Of the hub, whose booms are as dense.
        param density = 2700 kg/m^3;

        material metal { density = density; young = 70 GPa; }
        section pipe = tube(radius = 20 mm, thickness = 1 mm);
        rigid hub { mass = 100 kg; inertia = [30, 40, 60] kg*m^2; angular_velocity = [spin_x, spin_y, spin_z]; }
        body east in hub { spatial; line from [0.5, 0, 0] m to [3.5, 0, 0] m; mesh elements * cable(pipe, metal); }
        body west in hub { spatial; line from [-0.5, 0, 0] m to [-3.5, 0, 0] m; mesh elements * cable(pipe, metal); }
        body north in hub { spatial; line from [0, 0.5, 0] m to [0, 2, 0] m; mesh elements * cable(pipe, metal); }
        body south in hub { spatial; line from [0, -0.5, 0] m to [0, -2, 0] m; mesh elements * cable(pipe, metal); }
        joint east_root = clamp(east.start, hub);
        joint west_root = clamp(west.start, hub);
        joint north_root = clamp(north.start, hub);
        joint south_root = clamp(south.start, hub);
        output spin = hub.angular_velocity;
    }
}

/// Moments of inertia of the undeformed satellite, kg m^2.
fn inertia(density: f64) -> [f64; 3] {
    let line_mass = density * std::f64::consts::PI * (0.02f64.powi(2) - 0.019f64.powi(2));
    let pair = |from: f64, to: f64| 2.0 * line_mass * (to.powi(3) - from.powi(3)) / 3.0;
    let (x, y) = (pair(0.5, 3.5), pair(0.5, 2.0));
    [30.0 + y, 40.0 + x, 60.0 + x + y]
}

/// Growth (1/s) and frequency (rad/s) of the modes.
fn found(model: &Satellite, count: usize) -> Vec<[f64; 2]> {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let state = steady(scene.as_mut(), 0.0).unwrap().state().unwrap().clone();
    let modes = modes(scene.as_mut(), &Uniform::steady(0.0), &state, Wanted { count }).unwrap();
    modes.iter().map(|mode| [mode.re, mode.im]).collect()
}

#[test]
fn a_satellite_tumbles_about_its_intermediate_axis_as_a_rigid_body_does() {
    // So slow that the booms stay straight to 1e-5. Small enough for full matrices, and large.
    let spin = 0.05;
    for (elements, density) in [(1, 2700.0), (4, 2700.0), (12, 2700.0), (4, 1e-6)] {
        let slow = Satellite {
            elements,
            density,
            ..Satellite::default()
        };
        let [a, b, c] = inertia(density);
        let model = Satellite {
            spin_y: spin,
            ..slow.clone()
        };
        let rates = found(&model, 8);
        let growth = rates.iter().map(|rate| rate[0]).fold(0.0, f64::max);
        let exact = spin * ((b - a) * (c - b) / (a * c)).sqrt();
        println!("{elements} elements, {density} kg/m^3: {growth} instead of {exact} 1/s");
        assert!((growth / exact - 1.0).abs() < 1e-4, "{rates:?}");
        // About the axis of the least inertia it nutates.
        let rates = found(&Satellite { spin_x: spin, ..slow }, 8);
        let exact = spin * ((b - a) * (c - a) / (b * c)).sqrt();
        assert!(rates.iter().all(|rate| rate[0] < 1e-9 * spin), "{rates:?}");
        assert!(
            rates.iter().any(|rate| (rate[1] / exact - 1.0).abs() < 1e-4),
            "{exact}: {rates:?}"
        );
    }
}

#[test]
fn without_modes_nothing_is_said_of_the_stability() {
    // At rest all six motions drift.
    let rates = found(&Satellite::default(), 6);
    assert_eq!(rates, [[0.0; 2]; 6]);
}
