use super::action::FrameAction;
use super::arm::{Arm, COUNT};
use super::body::{ModalBody, Nodal};
use super::scene::{ModalScene, build_as};
use super::tests::cable::cantilever;
use super::tests::{close, numbers};
use crate::emitted::Fidelity;
use crate::linalg::{Cholesky, Pattern};
use crate::model::{Formulation, Joints, Scene, Uniform};
use crate::scene::MeshScene;
use crate::space::Vector;
use crate::system::{ConstraintLevel, State, System, Tangent};

fn dense(pattern: &Pattern, values: &[f64]) -> Vec<f64> {
    let mut matrix = vec![0.0; pattern.rows() * pattern.columns()];
    for column in 0..pattern.columns() {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            matrix[pattern.indices()[place] * pattern.columns() + column] = values[place];
        }
    }
    matrix
}

/// A moving state of a scene: displaced, turned, with rates, accelerations and multipliers.
fn moving(scene: &dyn Scene, part: f64) -> State {
    let mut state = scene.rest(0.2);
    let random = |seed: u64| numbers(state.x.len(), seed);
    let (x, v, a) = (random(3), random(4), random(5));
    for (index, size) in scene.sizes().iter().enumerate() {
        state.x[index] += part * size * x[index];
        state.v[index] += size * v[index];
        state.a[index] += 3.0 * size * a[index];
    }
    state.rebase(scene.turns());
    state.lambda = numbers(state.lambda.len(), 6);
    state
}

fn expanded(scene: &ModalScene, state: &State) -> State {
    let mut full = state.clone();
    let reduction = scene.reduction();
    reduction.expand(&state.x, true, &mut full.x);
    reduction.expand(&state.v, false, &mut full.v);
    reduction.expand(&state.a, false, &mut full.a);
    full
}

/// Every free and prescribed, planar and spatial arm with the given modes.
fn each(fidelity: Fidelity, mut call: impl FnMut(Arm, ModalScene, MeshScene)) {
    for (dimension, free) in [(2, false), (3, false), (2, true), (3, true)] {
        let arm = Arm::new(dimension, fidelity, free);
        let modal = ModalScene::new(arm.scene()).unwrap();
        let full = Arm::new(dimension, Fidelity::Full, free).scene();
        call(arm, modal, full);
    }
}

#[test]
fn the_scene_is_the_projection_of_that_with_nodal_vectors() {
    for fidelity in [Fidelity::Modal(4), Fidelity::Modal(10), Fidelity::Rigid] {
        each(fidelity, |_, mut modal, mut full| {
            let state = moving(&modal, 0.2);
            let big = expanded(&modal, &state);
            let (n, count) = (modal.unknowns(), full.unknowns());
            let (mut force, mut expected, mut nodal) = (vec![0.0; n], vec![0.0; n], vec![0.0; count]);
            modal.residual(&state, &mut force);
            full.residual(&big, &mut nodal);
            modal.reduction().project(&nodal, &mut expected);
            close(&force, &expected, 1e-10);

            let mut tangent = Tangent::default();
            modal.tangent(&state, &mut tangent);
            let mut whole = Tangent::default();
            full.tangent(&big, &mut whole);
            let mut mass = vec![0.0; modal.pattern().entries()];
            modal.mass(&state, &mut mass);
            close(&mass, &tangent.mass, 1e-14);
            for (found, of) in [
                (&tangent.mass, &whole.mass),
                (&tangent.stiffness, &whole.stiffness),
                (&tangent.damping, &whole.damping),
            ] {
                let mut expected = vec![0.0; found.len()];
                let reduction = modal.reduction();
                reduction.reduce_square(full.pattern(), of, modal.pattern(), &mut expected);
                close(found, &expected, 1e-9);
            }
            let at = Uniform::steady(0.1).scaled(0.7);
            let (mut state, mut big) = (state, big);
            modal.uniform_state(&at, &mut state);
            full.uniform_state(&at, &mut big);
            modal.uniform_residual(&at, &state, &mut force);
            full.uniform_residual(&at, &big, &mut nodal);
            modal.reduction().project(&nodal, &mut expected);
            close(&force, &expected, 1e-10);
            modal.small_motions(&at, &state, &mut tangent);
            full.small_motions(&at, &big, &mut whole);
            for (found, of) in [
                (&tangent.mass, &whole.mass),
                (&tangent.stiffness, &whole.stiffness),
                (&tangent.damping, &whole.damping),
            ] {
                let mut expected = vec![0.0; found.len()];
                let reduction = modal.reduction();
                reduction.reduce_square(full.pattern(), of, modal.pattern(), &mut expected);
                close(found, &expected, 1e-9);
            }
            let mut rows = [[0.0], [0.0]];
            modal.constraint(ConstraintLevel::Position, &state, &mut rows[0]);
            full.constraint(ConstraintLevel::Position, &big, &mut rows[1]);
            assert!((rows[0][0] - rows[1][0]).abs() < 1e-14);
        });
    }
}

#[test]
fn tangents_of_the_scene_are_derivatives() {
    for fidelity in [Fidelity::Modal(3), Fidelity::Small(3)] {
        each(fidelity, |_, mut modal, _| {
            let state = moving(&modal, 0.1);
            let n = modal.unknowns();
            let mut tangent = Tangent::default();
            modal.tangent(&state, &mut tangent);
            let mut jacobian = vec![0.0; modal.constraint_pattern().entries()];
            let mut residual = |state: &State| {
                let mut out = vec![0.0; n];
                modal.residual(state, &mut out);
                modal.constraint_jacobian(state, &mut jacobian);
                let lambda = &state.lambda;
                modal
                    .constraint_pattern()
                    .multiply_add(1.0, &jacobian, lambda, &mut out);
                out
            };
            let step = 1e-5;
            let mut found = [(); 3].map(|()| vec![0.0; n * n]);
            for unknown in 0..n {
                for (which, matrix) in found.iter_mut().enumerate() {
                    let mut at = |sign: f64| {
                        let mut moved = state.clone();
                        let values = [&mut moved.a, &mut moved.x, &mut moved.v];
                        values.into_iter().nth(which).unwrap()[unknown] += sign * step;
                        residual(&moved)
                    };
                    let (up, down) = (at(1.0), at(-1.0));
                    for row in 0..n {
                        matrix[row * n + unknown] = (up[row] - down[row]) / (2.0 * step);
                    }
                }
            }
            for (found, exact) in found.iter().zip([&tangent.mass, &tangent.stiffness, &tangent.damping]) {
                close(found, &dense(modal.pattern(), exact), 2e-7);
            }
        });
    }
}

/// Accelerations that balance the residual, without constraints.
fn released(scene: &mut dyn Scene, state: &mut State) {
    state.a.fill(0.0);
    let mut force = vec![0.0; state.x.len()];
    scene.residual(state, &mut force);
    let mut mass = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut mass);
    let matrix = dense(scene.pattern(), &mass);
    Cholesky::new(force.len(), &matrix).unwrap().solve(&mut force);
    state.a = force.iter().map(|f| -f).collect();
}

#[test]
fn all_modes_move_and_react_as_the_whole_body() {
    for (dimension, free) in [(2, false), (3, false), (2, true), (3, true)] {
        let freedoms = 2 * COUNT * dimension + 1;
        let mut arm = Arm::new(dimension, Fidelity::Modal(freedoms), free);
        arm.linked = false;
        let mut modal = ModalScene::new(arm.scene()).unwrap();
        arm.fidelity = Fidelity::Full;
        let mut full = arm.scene();
        let mut state = moving(&modal, 0.05);
        let mut big = expanded(&modal, &state);
        released(&mut modal, &mut state);
        released(&mut full, &mut big);
        close(&expanded(&modal, &state).a, &big.a, 1e-8);
        let [mut found, mut expected] = [[0.0; 5], [0.0; 5]];
        modal.outputs(&state, &mut found);
        full.outputs(&big, &mut expected);
        close(&found, &expected, 1e-8);
        // And back again.
        let frame = modal.frame_state(&state);
        let back = modal.state_of_frame(&frame);
        close(&back.x, &state.x, 1e-12);
        close(&back.v, &state.v, 1e-12);
    }
}

#[test]
fn few_modes_and_rigid_arms_hang_on_their_joint_with_all_their_weight() {
    for fidelity in [Fidelity::Modal(2), Fidelity::Small(2), Fidelity::Rigid, Fidelity::Point] {
        let mut arm = Arm::new(2, fidelity, false);
        (arm.spin, arm.linked) = (0.0, false);
        let mut scene = build_as(arm, Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
        let state = scene.rest(0.0);
        let mut out = [0.0; 5];
        scene.outputs(&state, &mut out);
        // Force and moment on the arm at its root: 1 kg, 1 m, and the moment of 0.5 N m on the tip.
        close(&out, &[1.2, 0.0, -0.3, 9.81, 0.5 * 9.81 - 0.5], 1e-9);
    }
}

#[test]
fn a_fast_rotor_is_warned_of_once_for_each_body() {
    let warnings = |fidelity, spin| {
        let mut arm = Arm::new(2, fidelity, false);
        (arm.spin, arm.linked, arm.cable.axial) = (spin, false, 1e5);
        let mut scene = build_as(arm, Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
        let state = scene.rest(0.0);
        // Its section is not slender.
        let mut warnings = scene.warnings(&state);
        warnings.retain(|warning| !warning.text.contains("shear and rotary inertia"));
        warnings
    };
    for fidelity in [Fidelity::Modal(2), Fidelity::Small(2)] {
        let found = warnings(fidelity, 3.5);
        assert_eq!(found.len(), 1);
        assert!(
            found[0].text.starts_with("body `arm`: at a spin of 3.5000 rad/s"),
            "{found:?}"
        );
        assert!(warnings(fidelity, 1.0).is_empty());
    }
    assert!(warnings(Fidelity::Full, 3.5).is_empty() && warnings(Fidelity::Modal(13), 3.5).is_empty());
    assert!(warnings(Fidelity::Rigid, 3.5).is_empty());
}

#[test]
fn unknowns_and_mistakes_are_named() {
    let scene = ModalScene::new(Arm::new(2, Fidelity::Modal(2), true).scene()).unwrap();
    assert_eq!(scene.describe_unknown(1), "body `arm`, mode 2");
    assert!(
        scene.describe_unknown(2).contains("hub"),
        "{}",
        scene.describe_unknown(2)
    );
    let arm = Arm::new(2, Fidelity::Modal(40), true);
    let error = build_as(arm, Formulation::Rncf, Joints::Eliminated, &[]).err().unwrap();
    assert!(error.message.contains("body `arm`") && error.message.contains("13 freedoms"));
    let mut arm = Arm::new(2, Fidelity::Modal(2), false);
    arm.linked = false;
    let error = build_as(arm, Formulation::Ancf, Joints::Eliminated, &[]).err().unwrap();
    assert!(error.message.contains("frame `hub`"), "{error}");
}

#[test]
fn the_reaction_of_a_turning_point_is_that_of_a_mass_at_the_middle() {
    let mut arm = Arm::new(2, Fidelity::Point, false);
    (arm.spin, arm.linked) = (2.0, false);
    let mut scene = build_as(arm, Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
    let state = scene.rest(0.0);
    let mut out = [0.0; 5];
    scene.outputs(&state, &mut out);
    // 1 kg at 0.2 m + 0.5 m from the axis.
    close(&out[2..], &[-0.3 - 0.7 * 4.0, 9.81, 0.5 * 9.81 - 0.5], 1e-9);
}

#[test]
fn a_point_has_the_mass_of_its_body_at_its_centre_and_no_inertia_about_it() {
    let (nodal, cable) = cantilever(3, 3, 1e3, 0.0, 0.0);
    let carried = |nodal: &Nodal, fidelity, spin_rate| {
        let body = ModalBody::new(nodal.clone(), fidelity, &cable).unwrap();
        let action = FrameAction {
            acceleration: Vector::new(0.5, -2.0, 0.0),
            spin: Vector::new(0.0, 0.0, 2.0),
            spin_rate,
        };
        let mut carried = [0.0; 6];
        body.carried(&action, [&[], &[], &[]], &mut carried);
        carried
    };
    // 1 kg at x = 1/2: its acceleration is (0.5 - 4/2, -2 + 3/2, 0), the moment x times the second component.
    let point = carried(&nodal, Fidelity::Point, Vector::new(7.0, 0.0, 3.0));
    close(&point, &[-1.5, -0.5, 0.0, 0.0, 0.0, -0.25], 1e-14);
    let rigid = carried(&nodal, Fidelity::Rigid, Vector::new(7.0, 0.0, 3.0));
    close(&rigid[..3], &point[..3], 1e-14);
    close(&rigid[3..], &[0.0, 0.0, -0.25 + 3.0 / 12.0], 1e-14);
    // About the frame's origin nothing is left, not even round-off.
    let mut centred = nodal;
    for node in 0..4 {
        centred.shape[6 * node] -= 0.5;
    }
    let point = carried(&centred, Fidelity::Point, Vector::new(7.0, 4.0, 3.0));
    assert_eq!(point[3..], [0.0; 3]);
}
