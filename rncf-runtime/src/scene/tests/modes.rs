//! Modes of scenes: free bodies in closed form, and the circulation of nodes.

use super::model::Hand;
use super::scenery::{body, free, joint};
use crate::emitted::{FreeSpec, JointKind, Motions, RigidSpec};
use crate::model::{Formulation, Scene, Spin, Uniform};
use crate::modes::{Wanted, Whirl, modes, stability_margin, unstable_directions};
use crate::space::{Vector, from_rows, matrix};
use crate::system::System;

/// A free body that spins about its axis of symmetry: A = 2, C = 3 kg m^2, W = 3 rad/s.
#[test]
fn a_free_body_drifts_tilts_and_precesses() {
    let mut disc: FreeSpec = free(1, 0, Motions::Spatial);
    disc.is_body = true;
    disc.spin = Vector::new(0.0, 0.0, 3.0);
    disc.rigid = RigidSpec {
        mass: 5.0,
        moment: Vector::zeros(),
        inertia: from_rows(&[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]),
    };
    let hand = Hand {
        frames: vec!["inertial", "disc"],
        free: vec![disc],
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let at = Uniform::steady(0.0);
    let mut state = scene.uniform_guess(&at);
    scene.uniform_state(&at, &mut state);
    let found = modes(&mut scene, &at, &state, Wanted { count: 20 }).unwrap();
    // Along the axis and about it; precession (C - A) / A W; the tilt, and where it is across the axis.
    let exact = [0.0, 0.0, 1.5, 3.0, 3.0, 3.0];
    assert_eq!(found.len(), exact.len(), "{found:?}");
    for (mode, exact) in found.iter().zip(exact) {
        assert!((mode.im - exact).abs() < 1e-9 && mode.re.abs() < 1e-9, "{mode:?}");
    }
    assert!(stability_margin(&found).unwrap().abs() < 1e-9);
    let mut whirl = |index: usize| {
        let circulation = scene.circulation(&at, &state, &found[index].shape);
        let whirl = Whirl::of(found[index].im, circulation);
        (whirl, whirl.inertial(found[index].im, 3.0))
    };
    // In space the disc wobbles with C / A W.
    let (sense, inertial) = whirl(2);
    assert!(sense == Whirl::Forward && (inertial.unwrap() - 4.5).abs() < 1e-9);
    for index in [3, 4, 5] {
        let (sense, inertial) = whirl(index);
        assert!(sense == Whirl::Backward && inertial.unwrap().abs() < 1e-9);
    }
    assert_eq!(whirl(0).0, Whirl::None);
    // K = -m W^2 across the axis, and (A - C) W^2 of the tilts (with the sign of the disc).
    assert_eq!(unstable_directions(&mut scene, &at, &state), Ok(2));
}

/// Nodes of a body in a turned free frame that go round on circles in space.
#[test]
fn circles_of_nodes_are_seen_in_turned_frames() {
    let mut carrier: FreeSpec = free(1, 0, Motions::Spatial);
    (carrier.axis, carrier.angle) = (Vector::new(0.6, 0.0, 0.8), 1.1);
    carrier.rigid.mass = 1.0;
    carrier.rigid.inertia = from_rows(&[[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let hand = Hand {
        frames: vec!["inertial", "carrier"],
        bodies: vec![body("mast", 1, &[0, 1, 2], Vector::new(0.9, 0.3, 0.0))],
        joints: vec![joint("step", JointKind::Clamp, 0, false, 1)],
        free: vec![carrier],
        lengths: vec![0.45],
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let spin = |axis: [f64; 3]| Uniform {
        spin: Some(Spin {
            velocity: axis.into(),
            point: Vector::zeros(),
        }),
        ..Uniform::steady(0.0)
    };
    let state = scene.rest(0.0);
    let rotation = matrix(&state.turns[0]);
    let shape = |scene: &crate::scene::MeshScene, second: f64| -> Vec<[f64; 2]> {
        // (1, second i, 0) in space, in the nodes' positions.
        let [real, imaginary] = [Vector::x(), Vector::new(0.0, second, 0.0)].map(|direction| {
            let within = rotation.tr_mul(&direction);
            let mut full = vec![0.0; scene.layout.components()];
            for vector in [2, 4] {
                full[scene.layout.offset(vector)..][..3].copy_from_slice(within.as_slice());
            }
            let mut x = vec![0.0; scene.unknowns()];
            scene.layout.project(&full, &mut x);
            x
        });
        real.into_iter().zip(imaginary).map(|(re, im)| [re, im]).collect()
    };
    let [forward, backward, straight] = [-1.0, 1.0, 0.0].map(|second| shape(&scene, second));
    let mut circulation = |axis, shape: &[[f64; 2]]| scene.circulation(&spin(axis), &state, shape);
    let z = [0.0, 0.0, 2.0];
    assert!((circulation(z, &forward).unwrap() - 1.0).abs() < 1e-14);
    assert!((circulation(z, &backward).unwrap() + 1.0).abs() < 1e-14);
    assert!((circulation([0.0, 0.0, -2.0], &forward).unwrap() + 1.0).abs() < 1e-14);
    assert!(circulation(z, &straight).unwrap().abs() < 1e-14);
    assert!(circulation([1.0, 0.0, 0.0], &forward).unwrap().abs() < 1e-14);
    assert_eq!(circulation([1.0, 0.0, 0.0], &straight), None);
    assert_eq!(circulation([0.0; 3], &forward), None);
}
