//! Bushings with matrices and angles: evaluated between moving bodies and sections.

use super::moving_sections::{Motion, NONE, PLANAR, SCENE, near};
use super::section_forces::{power, resultant};
use super::world::{STEP, Vec3, with};

/// Places whose axes turn: B a rigid body, or a section.
const PAIRS: [(&str, &str); 4] = [
    ("shaft.end", "b"),
    ("a", "b.at([1, 2, 3] m)"),
    ("a.at([1, 0, 2] m)", "rod.at(1 m)"),
    ("rod.end", "shaft.at(0.7 m)"),
];

const FULL: &str = "stiffness = [[3, 1, -2], [1, 4, 0.5], [-2, 0.5, 5]] N/m,
    rotational_stiffness = [[3, 0.5, 1], [0.5, 2, -1], [1, -1, 4]] N*m/rad,
    coupling = [[0.3, -2, 1], [0.5, 0, 3], [1, 2, 0.1]] N/rad";

/// Bodies and sections without strain.
fn in_space<'m>(shift: &'m dyn Fn(f64) -> Vec3, turn: &'m dyn Fn(f64) -> Vec3) -> Motion<'m> {
    Motion {
        shift,
        turn,
        small: NONE,
        is_planar: false,
        strain: 0.0,
    }
}

/// Symmetric matrices and any coupling have a potential; nothing acts on both together.
#[test]
fn matrices_have_a_potential() {
    let shift = |t: f64| [0.3 * t, 0.1 - t, 0.2 * t];
    let turn = |t: f64| [0.5 * t, -0.3 * t * t, 0.2 * t];
    let flat = |t: f64| [0.3 * t, 0.1 - t, 0.0];
    let about = |t: f64| [0.0, 0.0, 0.7 * t];
    for (scene, pairs, is_planar) in [
        (SCENE, &PAIRS[..], false),
        (PLANAR, &[("a", "b"), ("shaft.end", "rod.at(1 m)")][..], true),
    ] {
        for (a, b) in pairs {
            let model = with(scene, &format!("spring s = bushing({a}, {b}, {FULL});"));
            let motion = match is_planar {
                true => Motion {
                    is_planar,
                    ..in_space(&flat, &about)
                },
                false => in_space(&shift, &turn),
            };
            let potential =
                |t: f64| motion.world(&model, t, |world| world.value(model.forces[0].energy.as_ref().unwrap()));
            motion.world(&model, 0.9, |world| {
                let rate = (potential(world.t + STEP) - potential(world.t - STEP)) / (2.0 * STEP);
                assert!(rate.abs() > 0.1);
                near(&[power(&model.forces[0], world)], &[-rate], 1e-5, b);
                let (sum, moment) = resultant(&model.forces[0], world);
                near(&sum, &[0.0; 3], 1e-9, b);
                near(&moment, &[0.0; 3], 1e-9, b);
            });
        }
    }
}

/// A turn about one axis is the angle about it, beyond a right angle, too; its damper takes the square of its rate.
#[test]
fn a_turn_about_one_axis_is_its_angle() {
    let shift = |_: f64| [0.0; 3];
    for axis in 0..3 {
        let turn = |t: f64| std::array::from_fn(|at| if at == axis { -2.0 * t * t } else { 0.0 });
        let motion = in_space(&shift, &turn);
        // `a` is first, so that axes of the turn are those of B.
        let model = with(
            SCENE,
            "spring s = bushing(rod.end, a, rotational_stiffness = [2, 3, 4] N*m/rad);
             spring d = bushing(rod.end, a, rotational_damping = [5, 6, 7] N*m*s/rad);",
        );
        let stiffness = 2.0 + axis as f64;
        motion.world(&model, 1.1, |world| {
            let energy = world.value(model.forces[0].energy.as_ref().unwrap());
            near(&[energy], &[0.5 * stiffness * 2.42 * 2.42], 1e-9, "energy");
            let lost = (stiffness + 3.0) * 4.4 * 4.4;
            near(&[power(&model.forces[1], world)], &[-lost], 1e-5, "lost");
            assert!(model.forces[1].energy.is_none());
        });
    }
}

/// Small angles about several axes are the components of the rotation vector in the axes of B.
#[test]
fn small_angles_are_those_of_the_rotation_vector() {
    let small = [2e-4, -3e-4, 5e-4];
    let (shift, turn) = (|_: f64| [0.0; 3], |t: f64| small.map(|part| part * t));
    let motion = in_space(&shift, &turn);
    let model = with(
        SCENE,
        "spring s = bushing(rod.end, a, rotational_stiffness = [[1, 2, 3], [2, 5, 6], [3, 6, 9]] MN*m/rad);",
    );
    motion.world(&model, 1.0, |world| {
        let [x, y, z] = small.map(|part| part * 1e3);
        let want = 0.5 * (x * x + 5.0 * y * y + 9.0 * z * z) + 2.0 * x * y + 3.0 * x * z + 6.0 * y * z;
        let energy = world.value(model.forces[0].energy.as_ref().unwrap());
        near(&[energy], &[want], 1e-3 * want, "energy");
    });
}

/// Cross terms of opposite signs are no potential; the forces are those of the matrix.
#[test]
fn cross_terms_without_potential() {
    let shift = |t: f64| [0.0, 0.2 * t, -0.3 * t];
    let turn = |_: f64| [0.0; 3];
    let motion = in_space(&shift, &turn);
    let model = with(
        SCENE,
        "spring s = bushing(rod.at(1 m), a.at([0.5, 0.25, -0.125] m),
            stiffness = [[0, 0, 0], [0, 10, 4], [0, -4, 10]] N/m, damping = [[0, 0, 0], [0, 1, 0.5], [0, -0.5, 1]] N*s/m);",
    );
    motion.world(&model, 2.0, |world| {
        assert!(model.forces[0].energy.is_none());
        let (d, v) = ([0.4, -0.6], [0.2, -0.3]);
        let force = [
            10.0 * d[0] + 4.0 * d[1] + v[0] + 0.5 * v[1],
            -4.0 * d[0] + 10.0 * d[1] - 0.5 * v[0] + v[1],
        ];
        let want = -(force[0] * v[0] + force[1] * v[1]);
        near(&[power(&model.forces[0], world)], &[want], 1e-6, "power");
    });
}
