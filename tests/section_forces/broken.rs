//! Scenes of the paper that break their material.

use rncf::equilibrium::{Uniform, steady};
use rncf::{Model, Rncf, Scene};
use rncf_models::{Motor, SpinUp, SpinUpSpatial};

use crate::rotation::{bar, rotating};

#[test]
fn the_spin_up_at_100_rad_s_has_885_mpa_at_its_root() {
    let (density, young, length, area, spin) = (2766.67, 68.95e9, 8.0, 0.7299e-4, 100.0);
    let flat = SpinUp {
        omega_s: spin,
        ..SpinUp::default()
    };
    let space = SpinUpSpatial {
        omega_s: spin,
        ..SpinUpSpatial::default()
    };
    let exact = bar(young, density, length, spin, 1)[0];
    // The stretched beam has its mass further out than the undeformed one of the estimate.
    let estimate = 0.5 * density * spin * spin * length * length;
    assert!((estimate - 885.3e6).abs() < 0.1e6 && exact > estimate && exact < 1.015 * estimate);
    for mut scene in [flat.scene::<Rncf>().unwrap(), space.scene::<Rncf>().unwrap()] {
        let states = rotating(scene.as_mut(), 16.0);
        let root = states[0].forces[0] / area;
        println!(
            "root: {:.3} MPa, exact {:.3}, estimate {:.3}",
            root / 1e6,
            exact / 1e6,
            estimate / 1e6
        );
        assert!((root / exact - 1.0).abs() < 1e-4, "{root} {exact}");
        // The section says no extents.
        assert!(states.iter().all(|state| state.stress.is_none()));
        assert!(!scene.section_bodies()[0].knows_stress);
    }
}

/// 4.6 GPa is the bending stress `E r0 v pi^2/L^2` of half a sine wave with the deflection v of the middle;
/// in the clamp the shaft is bent more than twice as much, and stretched besides.
#[test]
fn the_motor_at_20000_rpm_breaks_in_its_clamp() {
    for (elements, wanted) in [(4, 11.467e9), (8, 11.474e9)] {
        let model = Motor {
            speed: 20000.0 * std::f64::consts::PI / 30.0,
            elements,
            ..Motor::default()
        };
        let mut scene = model.scene::<Rncf>().unwrap();
        let states = rotating(scene.as_mut(), 1.1);
        let middle = scene_middle(scene.as_mut());
        let estimate = 210e9 * 0.05 * middle * (std::f64::consts::PI / 1.02).powi(2);
        assert!((estimate - 4.6e9).abs() < 0.1e9, "{estimate}");
        let largest = states
            .iter()
            .max_by(|a, b| a.stress.unwrap().total_cmp(&b.stress.unwrap()))
            .unwrap();
        println!("{elements} elements: {largest:?}");
        let [area, second_moment] = [7.853_98e-3, 4.908_74e-6];
        let by_hand = largest.forces[0] / area + largest.bending_moment() * 0.05 / second_moment;
        assert!((largest.stress.unwrap() / by_hand - 1.0).abs() < 1e-5, "{largest:?}");
        assert!(
            largest.x == 0.0 && (largest.stress.unwrap() - wanted).abs() < 0.01e9,
            "{largest:?}"
        );
    }
}

/// Deflection of the motor's middle at 20,000 rpm, m.
fn scene_middle(scene: &mut dyn Scene) -> f64 {
    let found = steady(scene, 1.1).unwrap();
    let mut outputs = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&Uniform::steady(1.1), found.state().unwrap(), &mut outputs);
    outputs[0]
}

/// Time that the section states of a scene take beside its residual and its outputs.
#[test]
#[ignore = "measures"]
fn cost() {
    use std::time::Instant;
    for elements in [4, 16] {
        let motor = Motor {
            elements,
            ..Motor::default()
        };
        let spin_up = SpinUp {
            elements,
            ..SpinUp::default()
        };
        for mut scene in [motor.scene::<Rncf>().unwrap(), spin_up.scene::<Rncf>().unwrap()] {
            let state = scene.rest(0.3);
            let mut states = Vec::new();
            let mut residual = vec![0.0; scene.unknowns()];
            let mut timed = |call: &mut dyn FnMut(&mut dyn Scene)| {
                let start = Instant::now();
                for _ in 0..2000 {
                    call(scene.as_mut());
                }
                start.elapsed().as_secs_f64() / 2000.0 * 1e6
            };
            let sections = timed(&mut |scene| scene.section_states(&state, &mut states));
            let force = timed(&mut |scene| scene.residual(&state, &mut residual));
            println!("{elements} elements: section states {sections:.1} us, residual {force:.1} us");
        }
    }
}
