//! Modal and rigid bodies on free frames: against the whole bodies and closed forms, and what stays.

use rncf::linalg::Pattern;
use rncf::nalgebra::Vector3;
use rncf::{Method, Model, Scene, State};

use super::models::{
    FlyingArm, FlyingArmModal, FlyingArmRigid, HubArm, HubArmModal, OneRigid, RigidPendulum, TwoArms, TwoArmsBothModal,
    TwoArmsModal, TwoArmsRigid,
};
use crate::runs::{WAYS, adaptive, apart, far, fixed, grid, history, orders, short, states_at};

/// Rows of the outputs by Radau at a tolerance.
fn run(model: &impl Model, rtol: f64, times: &[f64]) -> Vec<Vec<f64>> {
    history(model, WAYS[0], Method::Radau, adaptive(rtol), times).0
}

#[test]
fn all_modes_on_a_driven_hub_are_the_whole_arm() {
    let times = grid(0.1, 2.0);
    let whole = run(
        &HubArm {
            torque: 3.0,
            ..HubArm::default()
        },
        1e-10,
        &times,
    );
    let modal = HubArmModal {
        torque: 3.0,
        modes: 13,
        ..HubArmModal::default()
    };
    let error = apart(&run(&modal, 1e-10, &times), &whole);
    println!("driven hub, all modes: {error:.1e}");
    assert!(error < 1e-6, "{error}");
}

/// `M v` in the rows of the frame, which come last: momentum in inertial axes, angular momentum about the frame's origin
/// in its own axes.
fn momenta(scene: &mut dyn Scene, state: &State) -> [f64; 6] {
    let mut mass = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut mass);
    let pattern: &Pattern = scene.pattern();
    let first = pattern.rows() - 6;
    let mut sums = [0.0; 6];
    for column in 0..pattern.columns() {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            if let Some(row) = pattern.indices()[place].checked_sub(first) {
                sums[row] += mass[place] * state.v[column];
            }
        }
    }
    sums
}

/// Momentum, angular momentum about the inertial origin and energy of a scene whose one free frame is a spatial hub.
fn conserved(scene: &mut dyn Scene, state: &State) -> [f64; 7] {
    let [px, py, pz, lx, ly, lz] = momenta(scene, state);
    let n = state.x.len();
    let inertial = state.orientation(0, n - 3) * Vector3::new(lx, ly, lz);
    let r = &state.x[n - 6..n - 3];
    let energy = scene.energy(state).expect("nothing acts on it");
    [
        px,
        py,
        pz,
        inertial[0] + r[1] * pz - r[2] * py,
        inertial[1] + r[2] * px - r[0] * pz,
        inertial[2] + r[0] * py - r[1] * px,
        energy,
    ]
}

/// Largest changes of momentum, angular momentum and energy.
fn drifts(model: &impl Model, h: f64) -> [f64; 3] {
    let mut scene = model.build(WAYS[0].0, WAYS[0].1).unwrap();
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, Method::Radau, fixed(h), &grid(0.2, 1.0));
    let rows: Vec<[f64; 7]> = states.iter().map(|state| conserved(scene.as_mut(), state)).collect();
    [0..3, 3..6, 6..7].map(|part| {
        rows.iter()
            .map(|row| far(&row[part.clone()], &rows[0][part.clone()]))
            .fold(0.0, f64::max)
    })
}

/// What the iteration to 1e-12 of the places leaves in 1 s of momenta, some kg m/s: 1e-12 m / h in every step.
const NEWTON: f64 = 5e-9;

fn conserves(name: &str, model: &impl Model) {
    let steps = [0.02, 0.01, 0.005];
    let table = steps.map(|h| drifts(model, h));
    for (what, of) in ["momentum", "angular momentum", "energy"].iter().enumerate() {
        let column = table.map(|row| row[what]);
        let order = orders(&column);
        println!("{name}, {of}: {} orders {order:.2?}", short(&column));
        assert!(column[2] < NEWTON || order[1] > 2.7, "{name}, {of}: {column:?}");
    }
}

#[test]
fn a_flying_arm_keeps_energy_and_momenta() {
    conserves("whole arm", &FlyingArm::default());
    for modes in [4, 13, 19] {
        conserves(
            &format!("{modes} modes"),
            &FlyingArmModal {
                modes,
                ..FlyingArmModal::default()
            },
        );
    }
    conserves("rigid arm", &FlyingArmRigid::default());
}

#[test]
fn all_modes_of_a_flying_arm_are_the_whole_one() {
    let times = grid(0.1, 1.0);
    let whole = run(&FlyingArm::default(), 1e-9, &times);
    let modal = FlyingArmModal {
        modes: 19,
        ..FlyingArmModal::default()
    };
    let error = apart(&run(&modal, 1e-9, &times), &whole);
    println!("flying arm, all modes: {error:.1e}");
    assert!(error < 1e-6, "{error}");
}

#[test]
fn a_rigid_arm_is_a_rigid_body_with_its_ten_numbers() {
    let times = grid(0.1, 3.0);
    let [arm, body] = [
        run(&FlyingArmRigid::default(), 1e-10, &times),
        run(&OneRigid::default(), 1e-10, &times),
    ];
    let error = apart(&arm, &body);
    println!("rigid arm against a rigid body: {error:.1e}");
    assert!(error < 1e-9);
}

#[test]
fn a_rigid_rod_on_a_hinge_keeps_the_energy_of_its_closed_form() {
    let times = grid(0.05, 3.0);
    let rows = run(&RigidPendulum::default(), 1e-10, &times);
    // omega^2 = omega_0^2 - 3 g / L (sin phi - sin phi_0)
    let [length, gravity] = [1.5, 9.81];
    let start = 20f64.to_radians();
    let mut swings = 0;
    for row in &rows {
        let expected = 1.0 - 3.0 * gravity / length * (row[0].sin() - start.sin());
        assert!((row[1] * row[1] - expected).abs() < 1e-7, "{row:?}");
        assert!(far(&row[2..], &[length * row[0].cos(), length * row[0].sin()]) < 1e-12);
        swings += usize::from(row[1] > 0.0);
    }
    assert!(swings > 5 && swings < rows.len() - 5);
    // And its time: from quadrature of 1/omega over the first fall, phi_0 to -pi/2.
    let ode = |steps: u32| {
        let (mut y, h) = ([start, 1.0], 3.0 / f64::from(steps));
        let rate = |y: [f64; 2]| [y[1], -1.5 * gravity / length * y[0].cos()];
        let at = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        for _ in 0..steps {
            let k1 = rate(y);
            let k2 = rate(at(y, k1, h / 2.0));
            let k3 = rate(at(y, k2, h / 2.0));
            let k4 = rate(at(y, k3, h));
            for i in 0..2 {
                y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
        y
    };
    let error = far(&rows[rows.len() - 1][..2], &ode(6000));
    println!("rigid rod on a hinge: {error:.1e}");
    assert!(error < 1e-7);
}

#[test]
fn joined_arms_in_modes_are_the_whole_ones() {
    let times = grid(0.1, 1.0);
    let whole = run(&TwoArms::default(), 1e-9, &times);
    let all = 9;
    let first = run(
        &TwoArmsModal {
            modes: all,
            ..TwoArmsModal::default()
        },
        1e-9,
        &times,
    );
    let both = run(
        &TwoArmsBothModal {
            modes: all,
            ..TwoArmsBothModal::default()
        },
        1e-9,
        &times,
    );
    let columns = |rows: &[Vec<f64>], range: std::ops::Range<usize>| -> Vec<Vec<f64>> {
        rows.iter().map(|row| row[range.clone()].to_vec()).collect()
    };
    let places = [&first, &both].map(|rows| apart(&columns(rows, 0..4), &columns(&whole, 0..4)));
    let pulls = [&first, &both].map(|rows| apart(&columns(rows, 4..6), &columns(&whole, 4..6)));
    println!("joined arms: places {}, forces {}", short(&places), short(&pulls));
    assert!(places.iter().all(|&error| error < 1e-6), "{places:?}");
    assert!(pulls.iter().all(|&error| error < 1e-3), "{pulls:?}");
}

#[test]
fn joined_arms_keep_their_energy() {
    fn drift(model: &impl Model) -> f64 {
        let mut scene = model.build(WAYS[0].0, WAYS[0].1).unwrap();
        let start = scene.rest(0.0);
        let (states, _) = states_at(scene.as_mut(), start, Method::Radau, adaptive(1e-9), &grid(0.2, 1.0));
        let energies: Vec<f64> = states
            .iter()
            .map(|state| scene.energy(state).expect("conserved"))
            .collect();
        energies
            .iter()
            .map(|energy| (energy - energies[0]).abs())
            .fold(0.0, f64::max)
    }
    let found = [
        drift(&TwoArms::default()),
        drift(&TwoArmsModal::default()),
        drift(&TwoArmsBothModal::default()),
        drift(&TwoArmsRigid::default()),
    ];
    println!("joined arms, energy: {}", short(&found));
    assert!(found.iter().all(|&drift| drift < 1e-6), "{found:?}");
}
