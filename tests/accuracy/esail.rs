//! The E-sail against the recorded reference of THEORY 9.5: 10 km, 4 elements, steps of 1 s.

use rncf::nalgebra::Vector3;
use rncf::system::ConstraintLevel;
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State};
use rncf_models::{Esail, EsailSlack};

use crate::runs::{fixed, states_at};

const METHOD: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };
const DISTANCE: f64 = 1.5e11;

fn coarse() -> Esail {
    Esail {
        elements: 4,
        ..Esail::default()
    }
}

fn scene(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// What the reference records of a state.
struct Record {
    /// Distance from the Sun of the core and of the centre of mass, less that of the core at the start, m.
    radial: f64,
    radial_centre: f64,
    /// Tips, m.
    z: [f64; 2],
    /// Means over first and last elements of main tethers, least and greatest in the ring, N: EA times strain times
    /// stretch in the middle of an element.
    root: f64,
    tip: f64,
    ring: [f64; 2],
    /// Spin, rad/s.
    spin: f64,
}

/// Nodal vectors of an element: position and slope at both ends.
fn tension(q: &[f64], length: f64) -> f64 {
    let slope = |i: usize| 1.5 * (q[6 + i] - q[i]) / length - 0.25 * (q[3 + i] + q[9 + i]);
    let stretch = Vector3::new(slope(0), slope(1), slope(2)).norm();
    320.0 * (stretch * stretch - 1.0) / 2.0 * stretch
}

/// Its mass times its centre, with 1.23428..e-5 kg/m.
fn moment(q: &[f64], length: f64) -> Vector3<f64> {
    let mass = 2700.0 * 4.571428571428571e-9 * length;
    Vector3::from_fn(|i, _| mass * ((q[i] + q[6 + i]) / 2.0 + length / 12.0 * (q[3 + i] - q[9 + i])))
}

fn record(model: &Esail, scene: &mut dyn Scene, state: &State) -> Record {
    let frame = scene.frame_state(state);
    let (count, tethers) = (model.elements, model.tethers);
    let length = model.length / count as f64;
    let arc = std::f64::consts::TAU * model.length / tethers as f64;
    let main = |a: usize, element: usize| &frame.q[6 * (a * (count + 1) + element)..];
    let ring = |a: usize| &frame.q[6 * (tethers * (count + 1) + 2 * a)..];
    let bounds = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        })
    };
    let mean = |element: usize| (0..tethers).map(|a| tension(main(a, element), length)).sum::<f64>() / tethers as f64;
    let mut centre = Vector3::zeros();
    for a in 0..tethers {
        for element in 0..count {
            centre += moment(main(a, element), length);
        }
        centre += moment(ring(a), arc);
        let tip = &main(a, count)[..3];
        centre += model.remote_mass * Vector3::from_column_slice(tip);
    }
    // All of it, THEORY 9.5.
    let centre = centre / 148.118381729;
    let pose = &frame.poses[0];
    Record {
        radial: pose.position.norm() - DISTANCE,
        radial_centre: (pose.position + pose.rotation * centre).norm() - DISTANCE,
        z: bounds(&mut (0..tethers).map(|a| main(a, count)[2])),
        root: mean(0),
        tip: mean(count - 1),
        ring: bounds(&mut (0..tethers).map(|a| tension(ring(a), arc))),
        spin: pose.spin[2],
    }
}

/// Both numbers agree within a part `tolerance` of the second.
#[track_caller]
fn assert_near(ours: f64, reference: f64, tolerance: f64) {
    assert!(
        (ours - reference).abs() <= tolerance * reference.abs(),
        "{ours} is not {reference}: {:e}",
        ours / reference - 1.0
    );
}

#[test]
fn the_sail_has_the_unknowns_of_the_paper() {
    let full = scene(&Esail::default());
    assert_eq!((full.unknowns(), full.constraints()), (10_006, 2));
    let coarse = scene(&coarse());
    assert_eq!((coarse.unknowns(), coarse.constraints()), (2_806, 2));
}

#[test]
fn the_start_is_the_spinning_equilibrium_with_consistent_multipliers() {
    let model = coarse();
    let mut scene = scene(&model);
    let start = scene.rest(0.0);
    let found = record(&model, scene.as_mut(), &start);
    assert_near(found.root, 0.372821026326, 1e-8);
    assert_near(found.tip, 0.337532029753, 1e-8);
    assert_near(found.ring[0], 0.358041087038, 1e-8);
    assert_near(found.ring[1], 0.35804108704, 1e-8);
    assert!(found.z == [0.0, 0.0] && found.radial.abs() < 4e-5 && found.radial_centre.abs() < 1e-4);
    // T13: accelerations and multipliers with the thrust that begins at once.
    let state = Integrator::new(scene.as_mut(), start, 1.0, METHOD, fixed(1.0))
        .unwrap()
        .state()
        .clone();
    assert_near(state.lambda[0], 1.78246674303e-4, 1e-4);
    assert!(state.lambda[1].abs() < 1e-9);
    let mut residual = vec![0.0; scene.unknowns()];
    scene.residual(&state, &mut residual);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(&state, &mut jacobian);
    scene
        .constraint_pattern()
        .multiply_add(1.0, &jacobian, &state.lambda, &mut residual);
    let worst = residual.iter().fold(0.0f64, |worst, r| worst.max(r.abs()));
    assert!(worst < 1e-10, "{worst:e} N");
    for (level, rates) in [
        (ConstraintLevel::Position, None),
        (ConstraintLevel::Velocity, Some(&state.v)),
        (ConstraintLevel::Acceleration, Some(&state.a)),
    ] {
        let mut c = vec![0.0; 2];
        scene.constraint(level, &state, &mut c);
        if let Some(rates) = rates {
            scene
                .constraint_pattern()
                .transpose_multiply_add(1.0, &jacobian, rates, &mut c);
        }
        assert!(c.iter().all(|c| c.abs() < 1e-14), "{level:?}: {c:?}");
    }
}

#[test]
fn two_hundred_seconds_are_those_of_the_reference() {
    let model = coarse();
    let mut scene = scene(&model);
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, METHOD, fixed(1.0), &[20.0, 200.0]);
    let [early, late] = [0, 1].map(|i| record(&model, scene.as_mut(), &states[i]));
    // The reference adds up positions at 1.5e11 m, whose last bit is 3e-5 m.
    assert_near(early.radial, 0.309540276263, 3e-4);
    assert_near(early.radial_centre, 1.26667671626, 1e-4);
    assert_near(early.z[0], 0.121617163475, 1e-7);
    assert_near(early.z[1], 0.13546630584, 1e-7);
    assert_near(states[0].lambda[0], 0.0045636474609, 2e-6);
    assert_near(late.radial, 108.057538755, 1e-6);
    assert_near(late.radial_centre, 126.659812828, 1e-6);
    assert_near(late.z[0], 50.1419917149, 1e-8);
    assert_near(late.z[1], 51.1149120832, 1e-8);
    assert_near(late.root, 0.374967850899, 1e-8);
    assert_near(late.tip, 0.338411006355, 1e-8);
    assert_near(late.ring[0], 0.352145338056, 1e-7);
    assert_near(late.ring[1], 0.352154953948, 1e-7);
    assert_near(late.spin, 0.00872669254565, 1e-10);
    assert_near(states[1].lambda[0], 0.222441537192, 1e-6);
    assert_near(states[1].lambda[1], -0.168458871091, 2e-6);
}

/// T6: least and greatest tension of the ring and the spread of the tips over rows from 60 s to 110 s.
fn slow(model: &impl Model, rtol: f64) -> [f64; 3] {
    let mut scene = scene(model);
    let start = scene.rest(0.0);
    let times: Vec<f64> = (0..51).map(|i| 60.0 + f64::from(i)).collect();
    let options = Options {
        rtol,
        ..Options::default()
    };
    let (states, _) = states_at(scene.as_mut(), start, Method::Radau, options, &times);
    let mut row = vec![0.0; scene.output_columns()];
    let mut result = [f64::INFINITY, f64::NEG_INFINITY, 0.0];
    for state in &states {
        scene.outputs(state, &mut row);
        result = [
            result[0].min(row[5]),
            result[1].max(row[6]),
            f64::max(result[2], row[2] - row[1]),
        ];
    }
    result
}

#[test]
fn at_low_spin_the_ring_buckles_unless_it_may_go_slack() {
    let (spin, elements, asymmetry) = (0.25f64.to_radians(), 4, 1e-6);
    let taut = Esail {
        spin,
        elements,
        asymmetry,
        ..Esail::default()
    };
    let [low, high, spread] = slow(&taut, 1e-4);
    assert!(low < -0.1 && high > 0.05, "ring between {low} N and {high} N");
    assert!(spread > 0.5, "tips within {spread} m");
    let slack = EsailSlack {
        spin,
        elements,
        asymmetry,
        ..EsailSlack::default()
    };
    let [low, high, spread] = slow(&slack, 1e-6);
    assert!(low > -1e-4 && high < 1e-4, "slack ring between {low} N and {high} N");
    assert!(spread < 0.3, "tips within {spread} m");
}
