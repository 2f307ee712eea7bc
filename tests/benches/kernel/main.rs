//! Generated code against plain generic implementations of the same element, side by side in one run on one thread:
//! residual and Jacobian of an element in a rotating frame. Elastic kernels are emitted, inertia is the runtime's; what
//! both cost together is measured in a whole [`scene`], with the assembly that the generic side does without.
//! Centre-line elements here, beams with a section in [`beam`].
//!
//! `cargo bench -p rncf-tests --bench kernel`

mod beam;
mod lanes;
mod scene;

use std::hint::black_box;
use std::time::Instant;

use rncf_models::{spin_up_equations as planar, spin_up_spatial_equations as spatial};
use rncf_reference::element::{Data, ElasticForce, GaussElement, Weights};
use rncf_reference::inertia::{Frame, Inertia, State, residual_and_jacobian};
use rncf_reference::tensor::TensorElement;

/// Evaluations of one timing, and timings of which the fastest counts: short ones, some of which nothing disturbs.
const REPETITIONS: usize = 500;
const ROUNDS: usize = 100;

/// Repetitions of a whole table, of which the fastest count: both sides then meet the same disturbances.
const TABLES: usize = 5;

fn main() {
    if let Err(error) = rayon::ThreadPoolBuilder::new().num_threads(1).build_global() {
        eprintln!("threads: {error}");
    }
    println!("| element | code | ns | generic / generated |");
    println!("|---|---|---|---|");
    for dimension in [2, 3] {
        let (word, elastic) = if dimension == 2 {
            ("planar", elastic_planar())
        } else {
            ("spatial", elastic_spatial())
        };
        println!("| {word} | generated, elastic alone | {elastic:.0} | |");
        let generated = scene::centre_line(dimension);
        println!("| {word} | generated, in a scene | {generated:.0} | |");
        for (name, generic) in generic(dimension) {
            println!("| {word} | {name} | {generic:.0} | {:.1} |", generic / generated);
        }
    }
    println!("\n| spatial tether, elastic | one by one, ns | four lanes, ns | ratio |");
    println!("|---|---|---|---|");
    for (name, [one, four]) in lanes::rows() {
        println!("| {name} | {one:.1} | {four:.1} | {:.1} |", one / four);
    }
    println!("\n| beam with a section | generated, ns | plain loops, ns | ratio |");
    println!("|---|---|---|---|");
    let mut fastest = beam::rows();
    for _ in 1..TABLES {
        for ((_, times), (_, more)) in fastest.iter_mut().zip(beam::rows()) {
            *times = [times[0].min(more[0]), times[1].min(more[1])];
        }
    }
    for (name, [generated, generic]) in fastest {
        println!(
            "| {name} | {generated:.0} | {generic:.0} | {:.1} |",
            generic / generated
        );
    }
}

/// Nanoseconds of one call.
fn time(mut call: impl FnMut()) -> f64 {
    let round = |call: &mut dyn FnMut()| {
        let clock = Instant::now();
        for _ in 0..REPETITIONS {
            call();
        }
        clock.elapsed().as_secs_f64()
    };
    let best = (0..ROUNDS).map(|_| round(&mut call)).fold(f64::INFINITY, f64::min);
    1e9 * best / REPETITIONS as f64
}

/// A bent and stretched element of the spin-up beam.
fn shape(dimension: usize) -> [Vec<f64>; 3] {
    let q: Vec<f64> = if dimension == 2 {
        vec![0.1, 0.0, 1.001, 0.02, 1.42, 0.06, 0.998, 0.05]
    } else {
        vec![0.1, 0.0, 0.01, 1.001, 0.02, 0.01, 1.42, 0.06, 0.02, 0.998, 0.05, 0.015]
    };
    let v = q.iter().map(|x| 0.1 * x).collect();
    let a = q.iter().map(|x| -0.3 * x).collect();
    [q, v, a]
}

fn elastic_planar() -> f64 {
    let row = planar::CablePlanar {
        length: 4.0 / 3.0,
        EA: 5.03e6,
        EI: 566.0,
        rhoA: 0.2,
    };
    let [q, ..] = shape(2).map(|values| <[f64; 8]>::try_from(values).unwrap());
    let (mut force, mut stiffness) = ([0.0; 8], [0.0; 64]);
    time(|| {
        force.fill(0.0);
        stiffness.fill(0.0);
        let (row, q) = (black_box(&row), black_box(&q));
        planar::cable_planar_elastic_force(row, q, &mut force);
        planar::cable_planar_elastic_tangent(row, q, &mut stiffness);
        black_box((&force, &stiffness));
    })
}

fn elastic_spatial() -> f64 {
    let row = spatial::CableSpatial {
        length: 4.0 / 3.0,
        EA: 5.03e6,
        EI: 566.0,
        rhoA: 0.2,
    };
    let [q, ..] = shape(3).map(|values| <[f64; 12]>::try_from(values).unwrap());
    let (mut force, mut stiffness) = ([0.0; 12], [0.0; 144]);
    time(|| {
        force.fill(0.0);
        stiffness.fill(0.0);
        let (row, q) = (black_box(&row), black_box(&q));
        spatial::cable_spatial_elastic_force(row, q, &mut force);
        spatial::cable_spatial_elastic_tangent(row, q, &mut stiffness);
        black_box((&force, &stiffness));
    })
}

fn generic(dimension: usize) -> Vec<(&'static str, f64)> {
    let data = Data {
        dimension,
        length: 4.0 / 3.0,
        mass_per_length: 0.2,
        axial_stiffness: 5.03e6,
        bending_stiffness: 566.0,
        exponent: 0,
        damping: 0.0,
        points: 5,
    };
    let gauss = GaussElement::straight(data).unwrap();
    let tensor = TensorElement::straight(data).unwrap();
    vec![
        ("plain loops over Eq. (7), any number of vectors", plain(&tensor, &data)),
        ("loops of fixed size, packed constant tensor", run(&tensor, &data)),
        ("loops of fixed size, 5 Gauss points", run(&gauss, &data)),
    ]
}

/// Eq. (7) and (13) as they stand: tensors of run-time size, loops over all four indices.
struct Plain {
    vectors: usize,
    dimension: usize,
    /// `k[a][b][m][n]` of the axial and of the bending energy.
    axial: Vec<f64>,
    bending: Vec<f64>,
    reference: Vec<f64>,
    mass: Vec<f64>,
}

impl Plain {
    fn dot(&self, a: &[f64], b: &[f64]) -> f64 {
        (0..self.dimension).map(|c| a[c] * b[c]).sum()
    }

    /// Residual with `R_a = M_ab (q'' + 2 w x q' + w' x q + w x (w x q))_b + T_ab q_b` and dR/dq.
    fn evaluate(&self, q: &[f64], v: &[f64], a: &[f64], frame: &Frame, residual: &mut [f64], jacobian: &mut [f64]) {
        let (n, dim) = (self.vectors, self.dimension);
        let size = n * dim;
        residual.fill(0.0);
        jacobian.fill(0.0);
        let at =
            |x: &[f64], b: usize| -> [f64; 3] { std::array::from_fn(|c| if c < dim { x[b * dim + c] } else { 0.0 }) };
        let cross = |u: [f64; 3], w: [f64; 3]| {
            [
                u[1] * w[2] - u[2] * w[1],
                u[2] * w[0] - u[0] * w[2],
                u[0] * w[1] - u[1] * w[0],
            ]
        };
        for b in 0..n {
            let (qb, vb, ab) = (at(q, b), at(v, b), at(a, b));
            let (coriolis, euler) = (cross(frame.spin, vb), cross(frame.spin_rate, qb));
            let centrifugal = cross(frame.spin, cross(frame.spin, qb));
            for i in 0..n {
                let mass = self.mass[i * n + b];
                for c in 0..dim {
                    residual[i * dim + c] += mass * (ab[c] + 2.0 * coriolis[c] + euler[c] + centrifugal[c]);
                }
                for column in 0..dim {
                    let mut unit = [0.0; 3];
                    unit[column] = 1.0;
                    let (euler, centrifugal) =
                        (cross(frame.spin_rate, unit), cross(frame.spin, cross(frame.spin, unit)));
                    for c in 0..dim {
                        jacobian[(i * dim + c) * size + b * dim + column] += mass * (euler[c] + centrifugal[c]);
                    }
                }
            }
        }
        for i in 0..n {
            for j in 0..n {
                let mut tension = 0.0;
                for m in 0..n {
                    for k in 0..n {
                        let place = ((i * n + j) * n + m) * n + k;
                        let product = 0.5 * self.dot(&q[m * dim..], &q[k * dim..]);
                        tension +=
                            self.axial[place] * (product - self.reference[m * n + k]) + self.bending[place] * product;
                    }
                }
                for c in 0..dim {
                    residual[i * dim + c] += tension * q[j * dim + c];
                    jacobian[(i * dim + c) * size + j * dim + c] += tension;
                }
                for m in 0..n {
                    for k in 0..n {
                        let place = ((i * n + j) * n + m) * n + k;
                        let entry = self.axial[place] + self.bending[place];
                        for r in 0..dim {
                            for c in 0..dim {
                                jacobian[(i * dim + r) * size + k * dim + c] += entry * q[j * dim + r] * q[m * dim + c];
                            }
                        }
                    }
                }
            }
        }
    }
}

fn plain(tensor: &TensorElement, data: &Data) -> f64 {
    let n = black_box(4);
    let mut plain = Plain {
        vectors: n,
        dimension: black_box(data.dimension),
        axial: Vec::new(),
        bending: Vec::new(),
        reference: Vec::new(),
        mass: data.second_moments().unwrap().concat(),
    };
    for i in 0..n {
        for j in 0..n {
            for m in 0..n {
                for k in 0..n {
                    plain.axial.push(tensor.kappa(i, j, m, k));
                    plain.bending.push(tensor.upsilon(i, j, m, k));
                }
            }
        }
    }
    let straight = shape(data.dimension)[0].clone();
    for m in 0..n {
        for k in 0..n {
            let product = 0.5 * plain.dot(&straight[m * data.dimension..], &straight[k * data.dimension..]);
            plain.reference.push(product);
        }
    }
    let [q, v, a] = shape(data.dimension);
    let frame = Frame {
        spin: [0.0, 0.0, 4.0],
        spin_rate: [0.0, 0.0, 0.5],
        origin_acceleration: [0.1, 0.2, 0.3],
    };
    let (mut residual, mut jacobian) = (vec![0.0; q.len()], vec![0.0; q.len() * q.len()]);
    time(|| {
        plain.evaluate(
            black_box(&q),
            black_box(&v),
            black_box(&a),
            black_box(&frame),
            &mut residual,
            &mut jacobian,
        );
        black_box((&residual, &jacobian));
    })
}

fn run<E: ElasticForce>(element: &E, data: &Data) -> f64 {
    let inertia = Inertia::new(data).unwrap();
    let [q, qd, qdd] = shape(data.dimension);
    let frame = Frame {
        spin: [0.0, 0.0, 4.0],
        spin_rate: [0.0, 0.0, 0.5],
        origin_acceleration: [0.1, 0.2, 0.3],
    };
    let size = q.len();
    let (mut residual, mut jacobian) = (vec![0.0; size], vec![0.0; size * size]);
    let weights = Weights::POSITION;
    time(|| {
        let state = State {
            q: black_box(&q),
            qd: black_box(&qd),
            qdd: black_box(&qdd),
        };
        residual_and_jacobian(
            element,
            &inertia,
            state,
            black_box(&frame),
            weights,
            &mut residual,
            &mut jacobian,
        );
        black_box((&residual, &jacobian));
    })
}
