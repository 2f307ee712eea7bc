//! Inertia in the moving frame: against the inertial acceleration of particles, and tangents against differences.

use crate::differences::{Random, jacobian, relative};
use crate::element::{bent, data};
use rncf_reference::element::{ElasticForce, GaussElement, Weights, shape};
use rncf_reference::inertia::{Frame, Inertia, State, residual, residual_and_jacobian};
use rncf_reference::quadrature::gauss_legendre;

/// A frame that moves every way that the dimension allows.
fn frame(dimension: usize, random: &mut Random) -> Frame {
    let mut list = || [random.next(), random.next(), random.next()];
    let mut frame = Frame {
        spin: list(),
        spin_rate: list(),
        origin_acceleration: list(),
    };
    if dimension == 2 {
        (frame.spin[0], frame.spin[1], frame.spin_rate[0], frame.spin_rate[1]) = (0.0, 0.0, 0.0, 0.0);
    }
    frame
}

/// `u x v`.
fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

#[test]
fn is_the_mass_times_the_acceleration_of_every_particle() {
    let mut random = Random(21);
    for dimension in [2, 3] {
        let data = data(dimension, 0);
        let frame = frame(dimension, &mut random);
        let size = 4 * dimension;
        let (q, qd, qdd) = (random.list(size, 1.0), random.list(size, 1.0), random.list(size, 1.0));
        let mut found = vec![0.0; size];
        Inertia::new(&data).unwrap().add_residual(
            State {
                q: &q,
                qd: &qd,
                qdd: &qdd,
            },
            &frame,
            &mut found,
        );
        // Virtual work of - rho A r'' along the axis, particle by particle.
        let mut exact = vec![0.0; size];
        for point in gauss_legendre(9).unwrap() {
            let s = shape(point.xi, data.length);
            let at = |q: &[f64]| -> [f64; 3] {
                std::array::from_fn(|k| {
                    if k < dimension {
                        (0..4).map(|i| s[i] * q[dimension * i + k]).sum()
                    } else {
                        0.0
                    }
                })
            };
            let (p, v, a) = (at(&q), at(&qd), at(&qdd));
            let (coriolis, euler) = (cross(frame.spin, v), cross(frame.spin_rate, p));
            let centrifugal = cross(frame.spin, cross(frame.spin, p));
            for i in 0..4 {
                for k in 0..dimension {
                    exact[dimension * i + k] += point.weight
                        * data.length
                        * data.mass_per_length
                        * s[i]
                        * (frame.origin_acceleration[k] + a[k] + 2.0 * coriolis[k] + euler[k] + centrifugal[k]);
                }
            }
        }
        assert!(relative(&found, &exact) < 1e-14);
    }
}

#[test]
fn jacobian_of_the_whole_residual() {
    let mut random = Random(22);
    for dimension in [2, 3] {
        for exponent in [0, 2] {
            let data = data(dimension, exponent);
            let (elastic, inertia) = (GaussElement::straight(data).unwrap(), Inertia::new(&data).unwrap());
            let (size, frame) = (elastic.coordinates(), frame(dimension, &mut random));
            let (q, qd, qdd) = (
                bent(dimension, &mut random),
                random.list(size, 1.0),
                random.list(size, 1.0),
            );
            let weights = Weights {
                acceleration: 1.7,
                velocity: 0.6,
                position: 0.9,
            };
            // The weights make one direction: q'' + 1.7 e, q' + 0.6 e, q + 0.9 e.
            let shifted = |e: &[f64]| {
                let shift =
                    |x: &[f64], weight: f64| -> Vec<f64> { x.iter().zip(e).map(|(x, e)| x + weight * e).collect() };
                let (q, qd, qdd) = (shift(&q, 0.9), shift(&qd, 0.6), shift(&qdd, 1.7));
                let mut out = vec![0.0; size];
                residual(
                    &elastic,
                    &inertia,
                    State {
                        q: &q,
                        qd: &qd,
                        qdd: &qdd,
                    },
                    &frame,
                    &mut out,
                );
                out
            };
            let columns = jacobian(shifted, &vec![0.0; size], 3e-3).concat();
            let (mut out, mut tangent) = (vec![0.0; size], vec![0.0; size * size]);
            let state = State {
                q: &q,
                qd: &qd,
                qdd: &qdd,
            };
            residual_and_jacobian(&elastic, &inertia, state, &frame, weights, &mut out, &mut tangent);
            let transposed: Vec<f64> = (0..size * size)
                .map(|at| tangent[(at % size) * size + at / size])
                .collect();
            let error = relative(&transposed, &columns);
            println!("dimension {dimension}, p = {exponent}: whole Jacobian {error:.1e}");
            assert!(error < 1e-9, "{dimension} {exponent}: {error}");
            assert!(relative(&out, &shifted(&vec![0.0; size])) < 1e-15);
        }
    }
}
