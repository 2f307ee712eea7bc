//! A hanging cable that falls and swings under gravity, against its chain written by hand.

use rncf::{Method, Model};
use rncf_reference::beam::{Beam, Chain, Root};
use rncf_reference::dense::{Cholesky, Matrix};
use rncf_reference::element::Data;
use rncf_reference::inertia::{Frame, State as Coordinates};
use rncf_reference::integrate::{Method as Explicit, agreed};
use rncf_reference::system::System;

use crate::models::Conservative;
use crate::runs::{WAYS, far, fixed, grid, orders, short, states_at};

/// Number of elements.
const ELEMENTS: usize = 2;

/// The chain pinned at the origin: states are all coordinates but the root's position, then their rates.
struct Hanging {
    chain: Chain,
    factor: Cholesky,
    gravity: f64,
}

impl Hanging {
    fn new(gravity: f64) -> Self {
        let beam = Beam {
            elements: ELEMENTS,
            length: 1.5,
            hub_radius: 0.0,
            root: Root::Pinned,
            element: Data {
                dimension: 2,
                length: 1.5,
                mass_per_length: 0.2,
                axial_stiffness: 200.0,
                bending_stiffness: 0.01,
                exponent: 0,
                damping: 0.0,
                points: 5,
            },
        };
        let chain = Chain::new(beam).unwrap();
        let (full, size) = (chain.mass(), chain.coordinates() - 2);
        let mut mass = Matrix::zero(size);
        for i in 0..size {
            for j in 0..size {
                mass.set(i, j, full.get(i + 2, j + 2));
            }
        }
        let factor = Cholesky::new(&mass).unwrap();
        Self { chain, factor, gravity }
    }
}

impl System for Hanging {
    fn size(&self) -> usize {
        2 * (self.chain.coordinates() - 2)
    }

    fn rate(&self, _t: f64, y: &[f64], rate: &mut [f64]) {
        let (x, v) = y.split_at(y.len() / 2);
        let all = |free: &[f64]| [&[0.0, 0.0], free].concat();
        let (q, qd, qdd) = (all(x), all(v), vec![0.0; x.len() + 2]);
        let mut residual = vec![0.0; q.len()];
        // Gravity acts as the ground's acceleration upwards does.
        let frame = Frame {
            origin_acceleration: [0.0, self.gravity, 0.0],
            ..Frame::default()
        };
        let state = Coordinates {
            q: &q,
            qd: &qd,
            qdd: &qdd,
        };
        self.chain.residual(state, &frame, &mut residual);
        let (velocity, acceleration) = rate.split_at_mut(v.len());
        velocity.copy_from_slice(v);
        for (a, force) in acceleration.iter_mut().zip(&residual[2..]) {
            *a = -force;
        }
        self.factor.solve(acceleration);
    }

    fn load_jacobian(&self, _t: f64, _y: &[f64], _jacobian: &mut Matrix) {
        unreachable!("the explicit method asks for none")
    }
}

/// All coordinates and rates at the given times, from the straight cable at rest.
fn exact(gravity: f64, times: &[f64]) -> Vec<[Vec<f64>; 2]> {
    let system = Hanging::new(gravity);
    let mut start = system.chain.straight()[2..].to_vec();
    start.resize(system.size(), 0.0);
    let run = agreed(&system, Explicit::DoPri8, 1e-13, &start, times, 1e-9).unwrap();
    let parts = run.states.iter().map(|y| {
        let (x, v) = y.split_at(y.len() / 2);
        [x, v].map(|free| [&[0.0, 0.0], free].concat())
    });
    parts.collect()
}

/// Largest errors of coordinates and rates for each step, s.
fn errors(exact: &[[Vec<f64>; 2]], times: &[f64], way: usize, method: Method, steps: [f64; 3]) -> [[f64; 3]; 2] {
    let model = Conservative { elements: ELEMENTS };
    let mut errors = [[0.0; 3]; 2];
    for (place, h) in steps.into_iter().enumerate() {
        let mut scene = model.build(WAYS[way].0, WAYS[way].1).unwrap();
        let start = scene.rest(0.0);
        let (states, _) = states_at(scene.as_mut(), start, method, fixed(h), times);
        for (state, [q, v]) in states.iter().zip(exact) {
            let found = scene.frame_state(state);
            errors[0][place] = f64::max(errors[0][place], far(&found.q, q));
            errors[1][place] = f64::max(errors[1][place], far(&found.v, v));
        }
    }
    errors
}

#[test]
fn falling_cable_converges_to_the_reference() {
    let times = grid(0.1, 0.8);
    let (right, wrong) = (exact(9.81, &times), exact(9.81 * 1.01, &times));
    for way in 0..WAYS.len() {
        for (method, steps, order) in [
            (Method::Radau, [0.005, 0.0025, 0.00125], 5.0),
            (Method::Hht { alpha: -0.05 }, [0.001, 0.0005, 0.00025], 2.0),
            (Method::GeneralizedAlpha { rho_inf: 0.8 }, [0.001, 0.0005, 0.00025], 2.0),
        ] {
            let found = errors(&right, &times, way, method, steps);
            let observed = found.map(|column| orders(&column)[1]);
            println!(
                "{:?} {method:?}: positions {}, velocities {}, orders {observed:.2?}",
                WAYS[way],
                short(&found[0]),
                short(&found[1])
            );
            assert!(observed.iter().all(|seen| *seen > order - 0.2), "{method:?}: {found:?}");
            let missed = errors(&wrong, &times, way, method, steps).map(|column| orders(&column)[1]);
            assert!(
                missed.iter().all(|seen| *seen < order - 0.2),
                "{method:?}: 1 % more gravity passes, {missed:?}"
            );
        }
    }
}
