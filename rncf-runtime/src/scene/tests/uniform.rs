//! Uniform motions: derivatives in co-rotating axes against differences, equilibria of free frames in
//! closed form, and what is refused by name.

use super::law::Law;
use super::model::{Hand, Quadratic};
use super::random::{Random, moved};
use super::scenery::{everything, free};
use crate::emitted::{ConstraintSpec, ForceSpec, FreeSpec, LoadKind, LoadSpec, MarkerSpec, Motions, RigidSpec, When};
use crate::equilibrium::{continue_from, follow};
use crate::linalg::Pattern;
use crate::model::{Formulation, Kind, Scene, Spin, Uniform};
use crate::scene::MeshScene;
use crate::space::{Matrix, Vector, from_rows, matrix, three};
use crate::system::{State, System, Tangent};

const STEP: f64 = 1e-5;
const G: f64 = 9.81;

fn dense(pattern: &Pattern, values: &[f64]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; pattern.columns()]; pattern.rows()];
    for column in 0..pattern.columns() {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            matrix[pattern.indices()[place]][column] = values[place];
        }
    }
    matrix
}

/// `M a + f + C_x^T lambda` with the velocities and accelerations of the uniform motion, to which rates are
/// added: v + y', a + g y'.
fn balance(scene: &mut MeshScene, at: &Uniform, state: &State, rates: [&[f64]; 2]) -> Vec<f64> {
    let mut state = state.clone();
    scene.uniform_state(at, &mut state);
    for i in 0..state.x.len() {
        state.v[i] += rates[0][i];
        state.a[i] += rates[1][i];
    }
    let mut out = vec![0.0; scene.unknowns()];
    scene.uniform_residual(at, &state, &mut out);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(&state, &mut jacobian);
    scene
        .constraint_pattern()
        .multiply_add(1.0, &jacobian, &state.lambda, &mut out);
    out
}

fn compare(what: &str, matrix: &[Vec<f64>], column: usize, [high, low]: [Vec<f64>; 2], scene: &MeshScene) {
    let size = matrix
        .iter()
        .flatten()
        .fold(1.0, |size: f64, value| size.max(value.abs()));
    for row in 0..high.len() {
        let expected = (high[row] - low[row]) / (2.0 * STEP);
        assert!(
            (matrix[row][column] - expected).abs() < 1e-6 * size,
            "{what}: {} instead of {expected}; {} by {}",
            matrix[row][column],
            scene.describe_unknown(row),
            scene.describe_unknown(column)
        );
    }
}

/// Every entry of stiffness and damping: velocities follow the positions, `dr'' = y'' + 2 W x y' + ..`.
#[test]
fn small_motions_are_derivatives_in_corotating_axes() {
    for (seed, kind, part) in [(1, Kind::Steady, 0.7), (2, Kind::Steady, 1.0), (3, Kind::Static, 0.6)] {
        let mut hand = everything();
        hand.moving = false;
        let mut scene = hand.scene(Formulation::Rncf);
        let turning = Vector::new(0.4, -1.1, 0.8);
        let spin = Some(Spin {
            velocity: turning,
            point: Vector::new(0.1, 0.3, -0.2),
        });
        let at = Uniform {
            scale: part,
            kind,
            spin,
            ..Uniform::steady(0.0)
        };
        let mut state = scene.rest(0.0);
        Random(seed).shake(&scene, &mut state, 0.2);
        scene.uniform_state(&at, &mut state);
        let mut tangent = Tangent::default();
        scene.small_motions(&at, &state, &mut tangent);
        let [stiffness, damping] = [&tangent.stiffness, &tangent.damping].map(|values| dense(scene.pattern(), values));
        let n = scene.unknowns();
        let zeros = vec![0.0; n];
        let rotation = at.speed() * turning;
        for i in 0..n {
            let sides = [STEP, -STEP].map(|step| {
                let moved = moved(&scene, &state, i, step);
                balance(&mut scene, &at, &moved, [&zeros, &zeros])
            });
            compare("stiffness", &stiffness, i, sides, &scene);
            let coriolis = coriolis(&scene, &state, rotation, i);
            let sides = [STEP, -STEP].map(|step| {
                let mut rate = zeros.clone();
                rate[i] = step;
                let acceleration: Vec<f64> = coriolis.iter().map(|a| step * a).collect();
                balance(&mut scene, &at, &state, [&rate, &acceleration])
            });
            compare("damping", &damping, i, sides, &scene);
        }
    }
}

/// What a unit rate of one unknown adds to the accelerations: `2 W x y'` of positions, `w x y'` of orientations.
fn coriolis(scene: &MeshScene, state: &State, rotation: Vector, unknown: usize) -> Vec<f64> {
    let mut result = vec![0.0; state.x.len()];
    let border = scene.layout.unknowns() - scene.layout.border();
    for frame in &scene.frames.free {
        let own = border + frame.first..border + frame.first + frame.count();
        if !own.contains(&unknown) {
            continue;
        }
        let matrix = match frame.turn {
            Some(turn) => matrix(&state.turns[turn]),
            None => scene.buffers.frames[frame.spec.frame].rotation,
        };
        let within = matrix.tr_mul(&rotation);
        let mine = &frame.directions[unknown - own.start];
        let shift = (2.0 * rotation).cross(&mine.shift);
        let turn = within.cross(&mine.turn);
        for (place, direction) in frame.directions.iter().enumerate() {
            result[own.start + place] = direction.shift.dot(&shift) + direction.turn.dot(&turn);
        }
    }
    result
}

fn unit(axis: usize) -> Vector {
    Vector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 })
}

/// A ball joint of two point markers.
fn ball(name: &'static str, markers: &'static [usize]) -> (ConstraintSpec, Vec<Quadratic>) {
    let spec = ConstraintSpec {
        name,
        kind: "spherical",
        rows: &["position x", "position y", "position z"],
        markers,
        coupled: &[],
        of_differences: false,
        first_party: 1,
        branches: 0,
        when: When::Always,
    };
    let row = |axis| Quadratic {
        linear: vec![(0, unit(axis)), (1, -unit(axis))],
        ..Quadratic::default()
    };
    (spec, (0..3).map(row).collect())
}

const LENGTH: f64 = 0.8;

/// A rigid bar (slender, its own axis with a small inertia) on a ball joint at the origin, hanging at
/// the angle phi to the vertical; it spins about the vertical.
fn conical(phi: f64, spin: f64, along: f64) -> Hand {
    let mut bar: FreeSpec = free(1, 0, Motions::Spatial);
    bar.is_body = true;
    (bar.axis, bar.angle) = (unit(1), -phi);
    bar.spin = Vector::new(spin * phi.sin(), 0.0, spin * phi.cos());
    bar.rigid = RigidSpec {
        mass: 2.0,
        moment: Vector::new(0.0, 0.0, -2.0 * LENGTH),
        inertia: from_rows(&[[1.5, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, along]]),
    };
    Hand {
        frames: vec!["inertial", "bar"],
        free: vec![bar],
        loads: vec![(
            LoadSpec {
                name: "weight",
                kind: LoadKind::Gravity,
                frame: 0,
            },
            Vector::new(0.0, 0.0, -G),
        )],
        markers: vec![
            MarkerSpec::Point { frame: 1, at: [0.0; 3] },
            MarkerSpec::Point { frame: 0, at: [0.0; 3] },
        ],
        constraints: vec![ball("hook", &[0, 1])],
        ..Hand::default()
    }
}

/// Angle of the bar to the vertical.
fn tilt(state: &State) -> f64 {
    matrix(&state.turns[0])[(2, 2)].acos()
}

/// A top that hangs and goes round without own spin: `(A - C) w^2 cos(phi) = m g l`. Neutral are the turning about
/// the vertical and that about its own axis.
#[test]
fn conical_pendulum_in_space() {
    let spin: f64 = 5.0;
    let exact = (2.0 * G * LENGTH / ((1.5 - 0.2) * spin * spin)).acos();
    let mut scene = conical(exact + 0.1, spin, 0.2).scene(Formulation::Rncf);
    let at = Uniform::steady(0.0);
    let guess = scene.uniform_guess(&at);
    assert_eq!(scene.neutral_motions(&at, &guess).len(), 2);
    let found = follow(&mut scene, &at, 1.0, |_, _| ()).unwrap();
    let state = found.state().unwrap();
    assert!((tilt(state) - exact).abs() < 1e-13, "{} {exact}", tilt(state));
    // The hook carries weight and centrifugal force.
    let radius = LENGTH * exact.sin();
    let force = [-2.0 * spin * spin * radius, 0.0, 2.0 * G];
    let size = (force[0].powi(2) + force[2].powi(2)).sqrt();
    let lambda = &state.lambda;
    let hook = lambda.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(
        (hook - size).abs() < 1e-10 && (lambda[2].abs() - 2.0 * G).abs() < 1e-10,
        "{lambda:?}"
    );
    // Velocities and accelerations are those of the motion: it goes on.
    let mut residual = vec![0.0; scene.unknowns()];
    scene.residual(state, &mut residual);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    let pattern = scene.constraint_pattern();
    pattern.multiply_add(1.0, &jacobian, &state.lambda, &mut residual);
    assert!(residual.iter().all(|r| r.abs() < 1e-11), "{residual:?}");
}

/// Without own inertia about its axis and unequal across it, the bar turns its flat side.
#[test]
fn free_body_turns_about_a_principal_axis() {
    let mut body: FreeSpec = free(1, 0, Motions::Spatial);
    body.spin = Vector::new(0.05, -0.1, 4.0);
    // The mass centre lies off the origin; about it the principal moments are 1, 2, 2.6.
    let (mass, center) = (3.0, Vector::new(0.2, -0.1, 0.4));
    let square: f64 = center.iter().map(|c: &f64| c * c).sum();
    let principal = [1.0, 2.0, 2.6];
    body.rigid = RigidSpec {
        mass,
        moment: mass * center,
        inertia: Matrix::from_fn(|i, j| {
            let own = if i == j { principal[i] + mass * square } else { 0.0 };
            own - mass * center[i] * center[j]
        }),
    };
    let hand = Hand {
        frames: vec!["inertial", "stone"],
        free: vec![body],
        ..Hand::default()
    };
    let mut scene = hand.scene(Formulation::Rncf);
    let at = Uniform {
        spin: Some(Spin {
            velocity: Vector::new(0.05, -0.1, 4.0),
            point: Vector::zeros(),
        }),
        ..Uniform::steady(0.0)
    };
    let found = follow(&mut scene, &at, 1.0, |_, _| ()).unwrap();
    let state = found.state().unwrap();
    // Axis z of the body is along the rotation, the mass centre on it.
    let axis = 1.0 / 4.001_562_194_719_709_6 * Vector::new(0.05, -0.1, 4.0);
    let a = matrix(&state.turns[0]);
    let z = a.column(2);
    let middle = three(&state.x, 0) + a * center;
    let away = axis.cross(&middle).norm();
    assert!(axis.cross(&z).norm() < 1e-13 && away < 1e-13);
    // Of another rotation is the same body not in equilibrium near this place about a middle axis only: a free
    // body that stands still is neutral in everything.
    let still = Uniform::at_rest(0.0);
    let neutral = scene.neutral_motions(&still, state).len();
    assert_eq!(neutral, 6);
    let found = continue_from(&mut scene, &still, state).unwrap();
    assert!(found.state.v.iter().all(|&v| v == 0.0));
}

fn refusal(hand: Hand, at: &Uniform) -> String {
    let mut scene = hand.scene(Formulation::Rncf);
    let guess = scene.uniform_guess(at);
    scene.uniform_obstacle(at, &guess).unwrap_or_default()
}

/// A rotor with a point beside the axis and one on it, to which one thing is added at a time.
fn rotor() -> Hand {
    let mut hand = conical(0.0, 3.0, 0.2);
    hand.constraints.clear();
    hand.markers = vec![
        MarkerSpec::Point {
            frame: 1,
            at: [0.0, 0.0, -0.3],
        },
        MarkerSpec::Point {
            frame: 0,
            at: [0.0, 0.0, -0.3],
        },
        MarkerSpec::Point {
            frame: 0,
            at: [1.0, 0.0, 0.0],
        },
        MarkerSpec::Point {
            frame: 1,
            at: [0.2, 0.0, 0.0],
        },
        MarkerSpec::Point {
            frame: 0,
            at: [0.0, 0.0, 1.0],
        },
    ];
    hand
}

#[test]
fn what_is_not_invariant_is_refused_by_name() {
    let at = Uniform::steady(0.0);
    let spring = |markers: &'static [usize]| {
        let spec = ForceSpec {
            name: "stay",
            markers,
            conservative: true,
            of_differences: false,
            branches: 0,
        };
        (spec, Law::Spring(40.0, 0.4, 0.0))
    };
    let with_force = |markers: &'static [usize]| {
        let mut hand = rotor();
        hand.forces = vec![spring(markers)];
        refusal(hand, &at)
    };
    // Along the axis, and from a place on the axis to one beside it: alike in all directions.
    assert_eq!(with_force(&[0, 4]), "");
    assert_eq!(with_force(&[3, 4]), "");
    // From a place beside the axis: not.
    assert!(with_force(&[0, 2]).contains("force `stay` does not stay the same"));
    let mut hand = rotor();
    hand.constraints = vec![ball("bearing", &[0, 1])];
    assert_eq!(refusal(hand, &at), "");
    let mut hand = rotor();
    hand.constraints = vec![ball("bearing", &[3, 1])];
    assert!(refusal(hand, &at).contains("joint `bearing` (spherical)"));
    // A slot across the axis holds a point on it in one direction only.
    let mut hand = rotor();
    hand.constraints = vec![ball("slot", &[0, 1])];
    hand.constraints[0].1.truncate(1);
    hand.constraints[0].0.rows = &["position x"];
    assert!(refusal(hand, &at).contains("joint `slot`"));
    let mut hand = rotor();
    hand.loads[0].1 = Vector::new(0.1, 0.0, -G);
    assert!(refusal(hand, &at).contains("load `weight` keeps its direction while `bar` turns"));
    let mut hand = rotor();
    hand.loads[0].1 = Vector::new(0.1, 0.0, -G);
    assert_eq!(refusal(hand, &Uniform::at_rest(0.0)), "");
    let mut hand = rotor();
    hand.free[0].motions = Motions::Hinged { axis: unit(0) };
    hand.free[0].spin = Vector::zeros();
    let forced = Uniform {
        spin: Some(Spin {
            velocity: Vector::new(0.0, 0.0, 2.0),
            point: Vector::zeros(),
        }),
        ..at
    };
    assert!(refusal(hand, &forced).contains("frame `bar` cannot turn"));
    let mut hand = rotor();
    hand.frames.push("other");
    let mut other: FreeSpec = free(2, 0, Motions::Spatial);
    other.spin = Vector::y();
    hand.free.push(other);
    assert!(refusal(hand, &at).contains("frame `other` does not turn with the others"));
}

/// What nothing balances is told: a drag against standing air has no equilibrium.
#[test]
fn an_unbalanced_moment_along_a_neutral_motion_is_told() {
    let mut hand = conical(0.0, 3.0, 0.2);
    hand.markers.push(MarkerSpec::Turn { frame: 1 });
    let spec = ForceSpec {
        name: "air",
        markers: &[2],
        conservative: false,
        of_differences: false,
        branches: 0,
    };
    hand.forces = vec![(spec, Law::Drag(0.3))];
    let mut scene = hand.scene(Formulation::Rncf);
    let error = follow(&mut scene, &Uniform::steady(0.0), 1.0, |_, _| ()).unwrap_err();
    assert!(error.to_string().contains("is not balanced"), "{error}");
}
