//! The freely tumbling cable of THEORY 9.6: against the same cable written by hand in the inertial frame, and what nothing
//! can change.

use rncf::nalgebra::Vector3;
use rncf::{Formulation, Joints, Method, Model, Options, Scene, State};
use rncf_models::FreeFlight;
use rncf_reference::free_cable::{FreeCable, Kept};
use rncf_reference::integrate::{Method as Explicit, agreed};

use crate::runs::{adaptive, apart, far, fixed, grid, orders, short, states_at};

const WAYS: [Formulation; 2] = [Formulation::Rncf, Formulation::Ancf];
/// Pose and velocity at t = 0, as the model declares them.
const ORIGIN: [f64; 3] = [0.3, -0.2, 0.5];
const AXIS: [f64; 3] = [1.0, 2.0, -1.0];
const ANGLE: f64 = 40.0 * std::f64::consts::PI / 180.0;
const VELOCITY: [f64; 3] = [-3.0, 1.0, 2.0];

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// A vector turned by the initial rotation (Rodrigues).
fn turned(v: [f64; 3]) -> [f64; 3] {
    let size = AXIS.iter().map(|x| x * x).sum::<f64>().sqrt();
    let n = AXIS.map(|x| x / size);
    let (sin, cos) = ANGLE.sin_cos();
    let (side, along) = (cross(n, v), (0..3).map(|k| n[k] * v[k]).sum::<f64>());
    std::array::from_fn(|k| cos * v[k] + sin * side[k] + (1.0 - cos) * along * n[k])
}

/// The start in inertial nodal vectors: an arc that moves as a rigid body.
pub fn start(model: &FreeFlight) -> Vec<f64> {
    let spin = [model.roll, model.pitch, model.yaw];
    let (mut q, mut qd) = (Vec::new(), Vec::new());
    for node in 0..=model.elements {
        let angle = 2.0 * node as f64 / model.elements as f64 / model.radius;
        let (sin, cos) = angle.sin_cos();
        let place = [model.radius * sin, model.radius * (1.0 - cos), 0.0];
        let slope = [cos, sin, 0.0];
        q.extend(add(ORIGIN, turned(place)));
        q.extend(turned(slope));
        qd.extend(add(VELOCITY, turned(cross(spin, place))));
        qd.extend(turned(cross(spin, slope)));
    }
    q.extend(qd);
    q
}

/// Energy, momentum and angular momentum, from nodal vectors in the frame and the frame's pose.
pub fn kept(scene: &mut dyn Scene, state: &State, cable: &FreeCable) -> Kept {
    let seen = scene.frame_state(state);
    let pose = seen.poses[0];
    let turn = |v: [f64; 3]| -> [f64; 3] { (pose.rotation * Vector3::from(v)).into() };
    let (mut q, mut qd) = (Vec::new(), Vec::new());
    for (vector, (at, rate)) in seen.q.chunks_exact(3).zip(seen.v.chunks_exact(3)).enumerate() {
        let at: [f64; 3] = at.try_into().unwrap();
        let rate = turn(add(rate.try_into().unwrap(), cross(pose.spin.into(), at)));
        let is_position = vector % 2 == 0;
        q.extend(if is_position {
            add(pose.position.into(), turn(at))
        } else {
            turn(at)
        });
        qd.extend(if is_position {
            add(pose.velocity.into(), rate)
        } else {
            rate
        });
    }
    cable.kept(&q, &qd)
}

/// End of the cable at the times, and the largest relative changes of energy, momentum, angular momentum.
pub fn flight(formulation: Formulation, method: Method, options: Options, times: &[f64]) -> (Vec<Vec<f64>>, [f64; 3]) {
    let model = FreeFlight::default();
    let cable = FreeCable::new(model.elements, model.tip_mass).unwrap();
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let first = kept(scene.as_mut(), &rest, &cable);
    let (states, statistics) = states_at(scene.as_mut(), rest, method, options, times);
    let mut row = vec![0.0; scene.output_columns()];
    let (mut ends, mut drift) = (Vec::new(), [0.0f64; 3]);
    for state in &states {
        scene.outputs(state, &mut row);
        ends.push(row[3..6].to_vec());
        let now = kept(scene.as_mut(), state, &cable);
        let size = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        drift[0] = drift[0].max((now.energy - first.energy).abs() / first.energy);
        drift[1] = drift[1].max(far(&now.momentum, &first.momentum) / size(first.momentum));
        drift[2] = drift[2].max(far(&now.spin, &first.spin) / size(first.spin));
        // Nothing pulls at a frame without mass: the moment about the chord is free of force. In absolute coordinates
        // the frame is no unknown.
        assert_eq!(state.lambda.len(), usize::from(formulation == Formulation::Rncf));
        if state.t > 0.0 {
            let pull = state.lambda.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            assert!(pull < 1e-6, "a tie of the frame pulls with {pull:e} at {} s", state.t);
        }
    }
    println!(
        "{formulation:?}, {method:?}: {} steps, drift {}",
        statistics.steps,
        short(&drift)
    );
    (ends, drift)
}

#[test]
fn the_start_is_the_arc_in_both_formulations() {
    let model = FreeFlight::default();
    let cable = FreeCable::new(model.elements, model.tip_mass).unwrap();
    let y = start(&model);
    let expected = cable.kept(&y[..y.len() / 2], &y[y.len() / 2..]);
    for formulation in WAYS {
        let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
        let rest = scene.rest(0.0);
        let found = kept(scene.as_mut(), &rest, &cable);
        assert!((found.energy - expected.energy).abs() < 1e-12 * expected.energy);
        assert!(far(&found.momentum, &expected.momentum) < 1e-12);
        assert!(far(&found.spin, &expected.spin) < 1e-12);
        let mut row = vec![0.0; scene.output_columns()];
        scene.outputs(&rest, &mut row);
        assert!(far(&row[3..6], &y[6 * model.elements..][..3]) < 1e-14);
    }
}

#[test]
fn both_formulations_fly_as_the_inertial_equations_do() {
    let model = FreeFlight::default();
    let times = grid(0.1, 2.0);
    let cable = FreeCable::new(model.elements, model.tip_mass).unwrap();
    let reference = agreed(&cable, Explicit::DoPri8, 1e-13, &start(&model), &times, 2e-9).unwrap();
    let tip = 6 * model.elements;
    let expected: Vec<Vec<f64>> = reference.states.iter().map(|y| y[tip..tip + 3].to_vec()).collect();
    println!(
        "reference: {} steps, known to {:e}",
        reference.steps, reference.difference
    );
    const BOUND: f64 = 1e-8;
    let ends: [Vec<Vec<f64>>; 2] = std::array::from_fn(|way| {
        let formulation = WAYS[way];
        let (ends, drift) = flight(formulation, Method::Radau, adaptive(1e-10), &times);
        let error = apart(&ends, &expected);
        println!("{formulation:?}: end off by {error:e} m");
        assert!(error < BOUND, "{formulation:?} is off by {error:e} m");
        assert!(
            drift.iter().all(|drift| *drift < 1e-8),
            "{formulation:?} drifts by {}",
            short(&drift)
        );
        ends
    });
    assert!(apart(&ends[0], &ends[1]) < BOUND);
}

#[test]
fn energy_and_momenta_stay_to_the_order_of_the_integrator() {
    let times = [0.0, 0.25];
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.9 };
    for (method, steps, order) in [
        (Method::Radau, [0.004, 0.002, 0.001], 5.0),
        (alpha, [0.001, 0.0005, 0.00025], 2.0),
    ] {
        for formulation in WAYS {
            let drifts = steps.map(|h| flight(formulation, method, fixed(h), &times).1);
            for (kind, name) in ["energy", "momentum", "angular momentum"].into_iter().enumerate() {
                let errors = drifts.map(|drift| drift[kind]);
                let found = orders(&errors);
                println!(
                    "{formulation:?}, {method:?}, {name}: {} orders {found:.2?}",
                    short(&errors)
                );
                // What is kept exactly has no order.
                let is_exact = errors.iter().all(|error| *error < 1e-12);
                let last = found[found.len() - 1];
                assert!(
                    is_exact || last > order - 0.4,
                    "{formulation:?}, {method:?}, {name}: {found:.2?}"
                );
            }
        }
    }
}

rncf::model! {
    /// A bent beam in a turning frame whose start may contradict what holds it.
    model Bent {
        /// Curvature.
        param bend = 0.2 [1/m];
        /// Shift along the axis.
        param gap = 0 m;
        /// Slope across the axis at the start.
        param tilt = 0;
        /// Velocity across the axis at the start.
        param kick = 0 m/s;
        material rubber { density = 1000 kg/m^3; young = 0.2 MPa; }
        section strip { area = 2 cm^2; second_moment = 50 cm^4; }
        frame hub = rotating(axis = x, angle = 2 [rad/s] * t + 30 deg);
        body beam in hub {
            planar yz;
            line from [0, 1, 0] m to [0, 3, 0] m;
            mesh 2 * cable(strip, rubber);
            initial position [0, 1 m + gap + x, tilt * x + bend * x^2];
            initial velocity [0, 0, kick + x * (3 [1/s])* x / (2 m)];
        }
        joint root = clamp(beam.start, hub);
        output tip = beam.end;
        output rate = beam.end.velocity;
        output slope = beam.end.slope;
        output seen = beam.end.in(inertial).velocity;
    }
}

#[test]
fn a_planar_body_starts_as_declared_in_both_formulations() {
    let model = Bent::default();
    let (sin, cos) = (30.0f64.to_radians()).sin_cos();
    for formulation in WAYS {
        let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
        let rest = scene.rest(0.0);
        let mut row = vec![0.0; scene.output_columns()];
        scene.outputs(&rest, &mut row);
        // y = 1 + x, z = x^2 / 5 and z' = 3 x^2 / 2 at x = 2.
        let expected = [3.0, 0.8, 0.0, 6.0, 1.0, 0.8];
        assert!(far(&row[..6], &expected) < 1e-14, "{formulation:?}: {row:?}");
        let rate = [-2.0 * 0.8, 6.0 + 2.0 * 3.0];
        let seen = [cos * rate[0] - sin * rate[1], sin * rate[0] + cos * rate[1]];
        assert!(far(&row[6..], &seen) < 1e-13, "{formulation:?}: {row:?}");
    }
}

#[test]
fn a_shape_that_a_joint_contradicts_is_refused() {
    let whole = Bent::default();
    for (model, what) in [
        (
            Bent {
                gap: 1e-6,
                ..whole.clone()
            },
            "it starts 1.000e-6 m away from the joint's point",
        ),
        (
            Bent {
                tilt: 1e-6,
                ..whole.clone()
            },
            "its slope starts at 1.000e-6 rad to the joint's direction",
        ),
        (
            Bent {
                kick: 1e-3,
                ..whole.clone()
            },
            "what it holds starts with the rate 1.000e-3",
        ),
        (
            Bent {
                bend: 1e308,
                ..whole.clone()
            },
            "the initial shape of body `beam` is not finite",
        ),
    ] {
        for formulation in WAYS {
            let Err(error) = model.build(formulation, Joints::Eliminated) else {
                panic!("{what}: accepted");
            };
            let text = error.to_string();
            assert!(text.contains(what) && text.contains("body `beam`"), "{text}");
        }
    }
}
