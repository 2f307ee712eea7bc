//! Accelerations, reactions and states of whole scenes.

use super::law::Law;
use super::model::{EVERY, Hand, Quadratic};
use super::random::Random;
use super::scenery::{along_slope, body, everything, free, hold, joint, stone};
use crate::emitted::{
    ConstraintSpec, FixtureSpec, ForceSpec, FrameTie, JointKind, Line, LoadKind, LoadSpec, MarkerSpec, Motions,
    ObservedSpec, Place, RigidSpec, When,
};
use crate::linalg::{Lu, Pattern};
use crate::model::{Formulation, Scene};
use crate::scene::MeshScene;
use crate::space::{Vector, from_rows, product, three};
use crate::system::{ConstraintLevel, State, System};

const G: f64 = 9.81;

/// Accelerations and multipliers at a state, from the whole bordered matrix.
fn solve(scene: &mut MeshScene, state: &mut State) {
    let (n, m) = (scene.unknowns(), scene.constraints());
    state.a.fill(0.0);
    let mut right = vec![0.0; n + m];
    let (forces, rows) = right.split_at_mut(n);
    scene.residual(state, forces);
    scene.constraint(ConstraintLevel::Acceleration, state, rows);
    let mut mass = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut mass);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    let whole = Pattern::new(n + m, n + m, (0..(n + m).pow(2)).map(|i| (i % (n + m), i / (n + m))));
    let mut values = vec![0.0; (n + m).pow(2)];
    let pattern = scene.pattern();
    for column in 0..n {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            values[column * (n + m) + pattern.indices()[place]] = mass[place];
        }
    }
    let pattern = scene.constraint_pattern();
    for column in 0..m {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            let row = pattern.indices()[place];
            values[(n + column) * (n + m) + row] = jacobian[place];
            values[row * (n + m) + n + column] = jacobian[place];
        }
    }
    let mut lu = Lu::new(&whole);
    lu.factor(&values).expect("the bordered matrix is regular");
    right.iter_mut().for_each(|value| *value = -*value);
    lu.solve(&mut right);
    state.a.copy_from_slice(&right[..n]);
    state.lambda.copy_from_slice(&right[n..]);
}

fn outputs(scene: &mut MeshScene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut out);
    out
}

fn gravity() -> (LoadSpec, Vector) {
    let spec = LoadSpec {
        name: "gravity",
        kind: LoadKind::Gravity,
        frame: 0,
    };
    (spec, Vector::new(0.0, 0.0, -G))
}

fn watch(marker: usize, derivative: usize) -> [ObservedSpec; 3] {
    [0, 1, 2].map(|component| ObservedSpec::Marker {
        marker,
        derivative,
        component,
    })
}

/// m g l sin(angle) / J
#[test]
fn a_hinged_body_is_a_physical_pendulum() {
    let mut door = free(1, 0, Motions::Hinged { axis: Vector::x() });
    door.angle = 8.0;
    door.is_body = true;
    door.rigid = RigidSpec {
        mass: 2.0,
        moment: Vector::new(0.0, 0.0, -1.0),
        inertia: from_rows(&[[0.7, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 0.1]]),
    };
    let hand = Hand {
        frames: vec!["inertial", "door"],
        loads: vec![gravity()],
        free: vec![door],
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    assert_eq!(state.x, [8.0]);
    solve(&mut scene, &mut state);
    let expected = -G * 8f64.sin() / 0.7;
    assert!((state.a[0] - expected).abs() < 1e-12, "{} {expected}", state.a[0]);
    assert_eq!(scene.describe_unknown(0), "rigid body `door`, rotation about x");
}

/// Steady precession of a top about the vertical with its spin, tilted by a right angle:
/// `C w precession = m g l` where the axis is horizontal.
#[test]
fn a_heavy_top_precesses() {
    let (spin, across, along, lever, mass) = (120.0, 0.4, 0.3, 0.2, 2.0);
    let precession = mass * G * lever / (along * spin);
    let mut top = free(1, 0, Motions::Turning);
    top.axis = Vector::y();
    top.angle = std::f64::consts::FRAC_PI_2;
    // The body's z is the inertial x, its x the inertial -z.
    top.spin = Vector::new(-precession, 0.0, spin);
    top.rigid = RigidSpec {
        mass,
        moment: Vector::new(0.0, 0.0, mass * lever),
        inertia: from_rows(&[[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, along]]),
    };
    let hand = Hand {
        frames: vec!["inertial", "top"],
        loads: vec![gravity()],
        free: vec![top],
        markers: vec![MarkerSpec::Point {
            frame: 1,
            at: [0.0, 0.0, lever],
        }],
        observed: watch(0, 2).to_vec(),
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    solve(&mut scene, &mut state);
    let acceleration = outputs(&mut scene, &state);
    // The centre goes around the vertical and feels nothing else.
    let expected = [-precession * precession * lever, 0.0, 0.0];
    for i in 0..3 {
        assert!(
            (acceleration[i] - expected[i]).abs() < 1e-10,
            "{acceleration:?} {expected:?}"
        );
    }
}

/// A mast on a ship without mass of its own, with a fixture, a rope and a push; the ship's frame
/// follows a clamp and a held component, or mean axes.
fn flyer(mean_axes: bool) -> Hand {
    let mut mast = body("mast", 1, &[0, 1, 2], Vector::new(0.9, 0.0, 0.0));
    // A curved one: mean axes and ties hold its turning about all axes.
    mast.line = Line::Arc {
        from: [0.0; 3],
        direction: [1.0, 0.0, 0.0],
        normal: [0.0, 0.0, 1.0],
        radius: 0.8,
        angle: 1.4,
    };
    mast.tie = if mean_axes {
        FrameTie::MeanAxes
    } else {
        FrameTie::Joints
    };
    let mut ship = free(1, 0, Motions::Spatial);
    (ship.position, ship.axis, ship.angle) = (Vector::new(0.2, 0.1, 1.0), Vector::new(0.6, 0.0, 0.8), 0.7);
    (ship.velocity, ship.spin) = (Vector::new(0.3, 0.2, 0.1), Vector::new(0.5, -0.4, 0.3));
    let ties = ConstraintSpec {
        name: "step",
        kind: "clamp",
        rows: &[
            "position x",
            "position y",
            "position z",
            "direction 1",
            "direction 2",
            "held",
        ],
        markers: &[0, 1, 2, 3, 4, 5],
        coupled: EVERY,
        of_differences: false,
        first_party: 2,
        branches: 0,
        when: When::Absolute(0),
    };
    let unit = |axis: usize| Vector::ith(axis, 1.0);
    let linear = |axis| Quadratic {
        linear: vec![(0, unit(axis)), (3, -unit(axis))],
        ..Quadratic::default()
    };
    let product = |products| Quadratic {
        products,
        ..Quadratic::default()
    };
    let rows = vec![
        linear(0),
        linear(1),
        linear(2),
        product(vec![(1, 4, 1.0)]),
        product(vec![(1, 5, 1.0)]),
        product(vec![(2, 5, 1.0), (3, 5, -1.0)]),
    ];
    Hand {
        frames: vec!["inertial", "ship"],
        joints: if mean_axes {
            Vec::new()
        } else {
            vec![
                joint("step", JointKind::Clamp, 0, false, 1),
                joint("stay", hold(0, 2), 0, true, 1),
            ]
        },
        bodies: vec![mast],
        loads: vec![
            gravity(),
            (
                LoadSpec {
                    name: "push",
                    kind: LoadKind::Force {
                        body: 0,
                        at: Place::At(0.3),
                    },
                    frame: 0,
                },
                Vector::new(1.0, 2.0, -0.5),
            ),
            (
                LoadSpec {
                    name: "twist",
                    kind: LoadKind::Moment {
                        body: 0,
                        at: Place::End,
                    },
                    frame: 0,
                },
                Vector::new(0.4, -0.3, 0.6),
            ),
        ],
        free: vec![ship],
        markers: vec![
            MarkerSpec::BodyPoint {
                body: 0,
                at: Place::Start,
            },
            MarkerSpec::BodySlope {
                body: 0,
                at: Place::Start,
            },
            MarkerSpec::BodyPoint {
                body: 0,
                at: Place::End,
            },
            MarkerSpec::Point { frame: 1, at: [0.0; 3] },
            MarkerSpec::Direction {
                frame: 1,
                along: [0.0, 1.0, 0.0],
            },
            MarkerSpec::Direction {
                frame: 1,
                along: [0.0, 0.0, 1.0],
            },
            MarkerSpec::Point { frame: 0, at: [0.0; 3] },
            MarkerSpec::BodyPoint {
                body: 0,
                at: Place::At(0.2),
            },
        ],
        constraints: if mean_axes { Vec::new() } else { vec![(ties, rows)] },
        forces: vec![(
            ForceSpec {
                name: "rope",
                markers: &[6, 7],
                conservative: false,
                of_differences: false,
                branches: 0,
            },
            Law::Spring(3.0, 0.6, 0.4),
        )],
        fixtures: vec![FixtureSpec {
            name: "ball",
            body: 0,
            at: Place::End,
            constants: along_slope(0.4, 0.1, 0.05),
            elastic: false,
        }],
        observed: [watch(0, 2), watch(2, 2), watch(7, 2)].concat(),
        ..Hand::default()
    }
}

/// Accelerations of a flyer's places in a formulation, from a state of its frame with moving nodes.
fn accelerations(hand: Hand, formulation: Formulation, frame: &crate::model::FrameState) -> (Vec<f64>, State) {
    let mut scene = hand.scene(formulation);
    let mut state = scene.state_of_frame(frame);
    solve(&mut scene, &mut state);
    (outputs(&mut scene, &state), state)
}

#[test]
fn frames_and_formulations_do_not_matter() {
    let mut scene = flyer(false).scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    let mut random = Random(17);
    for i in 0..state.x.len() - 6 {
        state.x[i] += 0.1 * random.number();
        state.v[i] += random.number();
    }
    let frame = scene.frame_state(&state);
    let (referenced, _) = accelerations(flyer(false), Formulation::Rncf, &frame);
    let (absolute, _) = accelerations(flyer(false), Formulation::Ancf, &frame);
    let (averaged, with) = accelerations(flyer(true), Formulation::Rncf, &frame);
    let (free, _) = accelerations(flyer(true), Formulation::Ancf, &frame);
    let size = referenced.iter().fold(0.0, |size: f64, a| size.max(a.abs()));
    assert!(size > 1.0);
    for (i, expected) in referenced.iter().enumerate() {
        for value in [absolute[i], averaged[i], free[i]] {
            assert!(
                (value - expected).abs() < 1e-9 * size,
                "{i}: {value} instead of {expected}"
            );
        }
    }
    // Conditions that only choose the frame exert nothing.
    assert_eq!(with.lambda.len(), 6);
    assert!(
        with.lambda.iter().all(|lambda| lambda.abs() < 1e-9 * size),
        "{:?}",
        with.lambda
    );
}

/// A planar flyer: in the plane the ties are a pinned start and a held end.
fn planar_flyer() -> Hand {
    let mut hand = flyer(false);
    hand.bodies[0].axes = &[0, 1];
    hand.loads[0].1 = Vector::new(0.0, -G, 0.0);
    let frame = &mut hand.free[0];
    frame.motions = Motions::Planar { normal: 2 };
    (frame.velocity, frame.spin) = (Vector::new(0.3, 0.2, 0.0), Vector::new(0.0, 0.0, 1.7));
    hand.joints[0].kind = JointKind::Pin;
    hand.joints[1].kind = hold(0, 1);
    let (spec, rows) = &mut hand.constraints[0];
    spec.rows = &["position x", "position y", "held"];
    let held = Quadratic {
        products: vec![(2, 4, 1.0), (3, 4, -1.0)],
        // Where the arc ends.
        constant: -0.8 * (1.0 - 1.4f64.cos()),
        ..Quadratic::default()
    };
    *rows = vec![rows[0].clone(), rows[1].clone(), held];
    hand
}

#[test]
fn planar_frames_and_formulations_do_not_matter() {
    let mut scene = planar_flyer().scene(Formulation::Rncf);
    assert_eq!((scene.border(), scene.turns().len()), (3, 0));
    let mut state = scene.rest(0.0);
    let mut random = Random(19);
    for i in 0..state.x.len() - 3 {
        state.x[i] += 0.1 * random.number();
        state.v[i] += random.number();
    }
    let frame = scene.frame_state(&state);
    let (referenced, _) = accelerations(planar_flyer(), Formulation::Rncf, &frame);
    let (absolute, there) = accelerations(planar_flyer(), Formulation::Ancf, &frame);
    let size = referenced.iter().fold(0.0, |size: f64, a| size.max(a.abs()));
    // Nothing reads the frame: in absolute coordinates neither it nor its ties are there.
    assert!(size > 1.0 && there.lambda.is_empty() && there.x.len() == state.x.len());
    for (value, expected) in absolute.iter().zip(&referenced) {
        assert!((value - expected).abs() < 1e-9 * size, "{value} instead of {expected}");
    }
}

/// What a joint to the body's own free frame exerts is the same number in both formulations, and
/// nothing where the frame has no mass.
#[test]
fn reactions_do_not_depend_on_the_formulation() {
    let reactions = |rigid: RigidSpec, formulation| {
        let mut hand = flyer(false);
        hand.free[0].rigid = rigid;
        let component = |moment, component| ObservedSpec::Reaction {
            joint: 0,
            moment,
            component,
        };
        hand.observed = [false, true]
            .into_iter()
            .flat_map(|moment| [0, 1, 2].map(|i| component(moment, i)))
            .collect();
        let mut scene = hand.scene(formulation);
        let mut state = scene.rest(0.0);
        solve(&mut scene, &mut state);
        outputs(&mut scene, &state)
    };
    let [referenced, absolute] = [Formulation::Rncf, Formulation::Ancf].map(|f| reactions(stone(), f));
    assert!(three(&referenced, 0).norm() > 0.1, "{referenced:?}");
    assert!(three(&referenced, 3).norm() > 0.1, "{referenced:?}");
    for (a, b) in referenced.iter().zip(&absolute) {
        assert!((a - b).abs() < 1e-9, "{referenced:?} {absolute:?}");
    }
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let none = reactions(RigidSpec::default(), formulation);
        assert!(none.iter().all(|value| value.abs() < 1e-10), "{none:?}");
    }
}

#[test]
fn states_pass_between_the_formulations() {
    let mut referenced = everything().scene(Formulation::Rncf);
    let mut absolute = everything().scene(Formulation::Ancf);
    let mut state = referenced.rest(0.0);
    Random(23).shake(&referenced, &mut state, 0.1);
    let frame = referenced.frame_state(&state);
    let there = absolute.state_of_frame(&frame);
    let back = referenced.state_of_frame(&absolute.frame_state(&there));
    for i in 0..state.x.len() {
        assert!(
            (back.x[i] - state.x[i]).abs() < 1e-12,
            "{}",
            referenced.describe_unknown(i)
        );
        assert!(
            (back.v[i] - state.v[i]).abs() < 1e-12,
            "{}",
            referenced.describe_unknown(i)
        );
    }
    for (turn, expected) in back.turns.iter().zip(&state.turns) {
        assert!(product(&turn.inverse(), expected).scaled_axis().norm() < 1e-12);
    }
}

/// A body on a ball joint: the joint carries what the weight and the acceleration leave.
#[test]
fn a_joint_carries_the_weight_and_its_moment_vanishes_at_its_point() {
    let mut body = free(1, 0, Motions::Spatial);
    body.rigid = stone();
    (body.position, body.spin) = (Vector::new(0.3, 0.2, 0.1), Vector::new(1.0, -2.0, 0.5));
    let at = Vector::new(0.1, -0.2, 0.4);
    body.velocity = -body.spin.cross(&at);
    let spec = stone();
    let centre = 1.0 / spec.mass * spec.moment;
    let unit = |axis: usize| Vector::ith(axis, 1.0);
    let row = |axis| Quadratic {
        linear: vec![(0, unit(axis)), (1, -unit(axis))],
        ..Quadratic::default()
    };
    let ball = ConstraintSpec {
        name: "ball",
        kind: "spherical",
        rows: &["position x", "position y", "position z"],
        markers: &[0, 1],
        coupled: &[],
        of_differences: false,
        first_party: 1,
        branches: 0,
        when: When::Always,
    };
    let reaction = |moment: bool, component| ObservedSpec::ConstraintReaction {
        constraint: 0,
        moment,
        component,
    };
    let hand = Hand {
        frames: vec!["inertial", "stone"],
        loads: vec![gravity()],
        free: vec![body],
        markers: vec![
            MarkerSpec::Point {
                frame: 1,
                at: at.into(),
            },
            MarkerSpec::Matching { frame: 0, marker: 0 },
            MarkerSpec::Point {
                frame: 1,
                at: centre.into(),
            },
        ],
        constraints: vec![(ball, vec![row(0), row(1), row(2)])],
        observed: [
            watch(2, 2),
            [0, 1, 2].map(|i| reaction(false, i)),
            [0, 1, 2].map(|i| reaction(true, i)),
        ]
        .concat(),
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    let mut rows = Vector::repeat(1.0);
    scene.constraint(ConstraintLevel::Position, &state, rows.as_mut_slice());
    assert!(rows.norm() < 1e-15);
    solve(&mut scene, &mut state);
    let out = outputs(&mut scene, &state);
    for i in 0..3 {
        let expected = spec.mass * (out[i] + if i == 2 { G } else { 0.0 });
        assert!((out[3 + i] - expected).abs() < 1e-11, "{out:?}");
        assert_eq!(out[6 + i], 0.0);
    }
    assert_eq!(scene.describe_constraint(1), "joint `ball` (spherical), position y");
    assert_eq!(scene.describe_unknown(4), "frame `stone`, rotation about y");
}

/// Normals make a right-handed triad with their direction; in a plane the first lies in it.
#[test]
fn normals_are_a_triad() {
    let scene = everything().scene(Formulation::Rncf);
    let [along, second] = [3, 9].map(|marker| scene.jet(&scene.links.markers[marker])[0]);
    let first = crate::space::perpendicular(1.0 / along.norm() * along);
    let expected = (1.0 / along.norm() * along).cross(&first);
    assert!((second - expected).norm() < 1e-15);
    let mut hand = everything();
    hand.markers[9] = MarkerSpec::Normal {
        frame: 6,
        marker: 15,
        which: 0,
    };
    hand.markers.push(MarkerSpec::Direction {
        frame: 6,
        along: [1.0, 0.0, 0.0],
    });
    let scene = hand.scene(Formulation::Rncf);
    let [along, first] = [15, 9].map(|marker| scene.jet(&scene.links.markers[marker])[0]);
    assert!((first - Vector::new(-along[1], along[0], 0.0)).norm() < 1e-15);
}
