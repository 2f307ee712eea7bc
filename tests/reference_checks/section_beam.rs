//! The ten-vector element: derivatives, objectivity, zero modes, mass, and the planar version inside the spatial one.

use crate::differences::{Random, jacobian, largest, relative};
use rncf_reference::element::{Data, Weights};
use rncf_reference::inertia::{Frame, Inertia, State};
use rncf_reference::section_beam::{Element, Properties, Section, residual_and_jacobian};
use rncf_reference::section_chain::{Chain, Shape, Supports, straight};
use rncf_reference::section_inertia::MovingElement;
use rncf_reference::section_modes::dense;
use rncf_reference::symmetric::eigenvalues;

/// A section in which every stiffness counts.
const SECTION: Section = Section {
    young: 3.0,
    poisson: 0.25,
    density: 1.3,
    area: 0.9,
    i_zz: 0.5,
    i_yy: 0.3,
    torsion: 0.6,
    shear_factor: 0.8,
};

/// Damped properties with and without Poisson coupling.
fn soft(dimension: usize) -> [Properties; 2] {
    let damped = |properties| Properties {
        damping: 0.2,
        ..properties
    };
    [
        damped(Properties::structural(dimension, 0.8, &SECTION)),
        damped(Properties::coupled(dimension, 0.8, &SECTION)),
    ]
}

/// An arc in the x-y plane whose section turns about the tangent.
fn curved(curvature: f64, twist: f64) -> impl Fn(f64) -> Shape {
    move |x| {
        let ((s, c), (st, ct)) = ((curvature * x).sin_cos(), (twist * x).sin_cos());
        let (y, z) = ([-s, c, 0.0], [0.0, 0.0, 1.0]);
        let mix = |u: [f64; 3], a: f64, v: [f64; 3], b: f64| std::array::from_fn(|k| a * u[k] + b * v[k]);
        let at = [s / curvature, (1.0 - c) / curvature, 0.0];
        [at, [c, s, 0.0], mix(y, ct, z, st), mix(z, ct, y, -st)]
    }
}

/// Coordinates of one element along a shape.
fn along(properties: Properties, shape: impl Fn(f64) -> Shape) -> Vec<f64> {
    Chain::along(properties, 1, shape).unwrap().stress_free().to_vec()
}

/// An element with curvature (in space also twist) and a state off its reference.
fn shaken(properties: Properties, random: &mut Random) -> (Element, Vec<f64>, Vec<f64>) {
    let twist = if properties.dimension == 3 { 0.7 } else { 0.0 };
    let q0 = along(properties, curved(0.9, twist));
    let element = Element::stress_free_at(properties, &q0).unwrap();
    let q = q0.iter().map(|x| x + 0.3 * random.next()).collect();
    let v = random.list(q0.len(), 1.0);
    (element, q, v)
}

fn force(element: &Element, q: &[f64], v: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; q.len()];
    element.add_force(q, v, &mut force);
    force
}

/// The product of a matrix with every vector of a list of coordinates.
fn turned(matrix: &[[f64; 3]; 3], q: &[f64], n: usize) -> Vec<f64> {
    let entry = |at: usize| (0..n).map(|j| matrix[at % n][j] * q[at / n * n + j]).sum();
    (0..q.len()).map(entry).collect()
}

/// A rotation about z, in space followed by one about x.
fn rotation(n: usize) -> [[f64; 3]; 3] {
    let ((s, c), (sx, cx)) = (1.1_f64.sin_cos(), if n == 3 { 0.6_f64.sin_cos() } else { (0.0, 1.0) });
    [[c, -s, 0.0], [cx * s, cx * c, -sx], [sx * s, sx * c, cx]]
}

#[test]
fn force_is_the_gradient_of_the_energy() {
    let mut random = Random(5);
    for dimension in [2, 3] {
        for properties in soft(dimension) {
            let (element, q, v) = shaken(properties, &mut random);
            let gradient: Vec<f64> = jacobian(|q| vec![element.energy(q)], &q, 1e-2).concat();
            let error = relative(&force(&element, &q, &vec![0.0; v.len()]), &gradient);
            println!("dimension {dimension}: force against the energy {error:.1e}");
            assert!(error < 1e-10);
        }
    }
}

#[test]
fn tangents_against_differences() {
    let mut random = Random(6);
    for dimension in [2, 3] {
        for properties in soft(dimension) {
            let (element, q, v) = shaken(properties, &mut random);
            let size = q.len();
            let (mut f, mut k, mut c) = (vec![0.0; size], vec![1.0; size * size], vec![1.0; size * size]);
            residual_and_jacobian(&q, &v, &element, &mut f, &mut k, &mut c);
            let transposed =
                |m: &[f64]| -> Vec<f64> { (0..m.len()).map(|at| m[size * (at % size) + at / size]).collect() };
            let by_q = jacobian(|q| force(&element, q, &v), &q, 1e-2).concat();
            let by_v = jacobian(|v| force(&element, &q, v), &v, 1e-2).concat();
            let errors = [
                relative(&f, &force(&element, &q, &v)),
                relative(&transposed(&k), &by_q),
                relative(&transposed(&c), &by_v),
            ];
            println!("dimension {dimension}: force, K, C {errors:?}");
            assert!(errors.iter().all(|&error| error < 1e-10));
            assert!(relative(&transposed(&c), &c) < 1e-14, "the damping matrix is symmetric");
        }
    }
}

#[test]
fn rigid_motions_change_nothing() {
    let mut random = Random(7);
    for n in [2, 3] {
        for properties in soft(n) {
            let (element, q, v) = shaken(properties, &mut random);
            let matrix = rotation(n);
            let (mut q_turned, v_turned) = (turned(&matrix, &q, n), turned(&matrix, &v, n));
            let positions = if n == 2 { [0, 4] } else { [0, 6] };
            for position in positions {
                (0..n).for_each(|k| q_turned[n * position + k] += 2.0);
            }
            let (f, expected) = (force(&element, &q_turned, &v_turned), force(&element, &q, &v));
            assert!(relative(&f, &turned(&matrix, &expected, n)) < 1e-12);
            assert!((element.energy(&q_turned) / element.energy(&q) - 1.0).abs() < 1e-12);
            // Neither a resultant nor a moment: sum of q_a x F_a.
            let sum: Vec<f64> = (0..n).map(|k| positions.iter().map(|p| f[n * p + k]).sum()).collect();
            let moment = |i: usize, j: usize| -> f64 {
                (0..f.len() / n)
                    .map(|a| q_turned[n * a + i] * f[n * a + j] - q_turned[n * a + j] * f[n * a + i])
                    .sum()
            };
            let moments: Vec<f64> = if n == 2 {
                vec![moment(0, 1)]
            } else {
                vec![moment(0, 1), moment(1, 2), moment(2, 0)]
            };
            assert!(largest(sum) < 1e-12 * largest(f.clone()) && largest(moments) < 1e-11 * largest(f));
            // Velocities of a rigid rotation strain nothing: the damping force vanishes.
            let spin = |q: &[f64]| -> Vec<f64> {
                let mut v = vec![0.0; q.len()];
                (0..q.len() / n).for_each(|a| (v[n * a], v[n * a + 1]) = (-q[n * a + 1], q[n * a]));
                v
            };
            let rest = vec![0.0; q.len()];
            assert!(relative(&force(&element, &q, &spin(&q)), &force(&element, &q, &rest)) < 1e-12);
        }
    }
}

#[test]
fn a_stress_free_shape_is_so_wherever_it_stands() {
    for n in [2, 3] {
        let twist = if n == 3 { 0.7 } else { 0.0 };
        for properties in soft(n) {
            let q0 = along(properties, curved(0.9, twist));
            let (bent, rest) = (Element::stress_free_at(properties, &q0).unwrap(), vec![0.0; q0.len()]);
            let turned = turned(&rotation(n), &q0, n);
            assert!(largest(force(&bent, &turned, &rest)) < 1e-14);
            // The straight element is not free of stress there, and is where it is straight.
            let plain = Element::straight(properties).unwrap();
            assert!(largest(force(&plain, &turned, &rest)) > 0.1);
            assert!(largest(force(&plain, &along(properties, straight), &rest)) < 1e-14);
        }
    }
}

#[test]
fn damping_takes_energy() {
    let mut random = Random(8);
    for n in [2, 3] {
        for properties in soft(n) {
            let (element, q, v) = shaken(properties, &mut random);
            let (moving, still) = (force(&element, &q, &v), force(&element, &q, &vec![0.0; v.len()]));
            let power: f64 = v
                .iter()
                .zip(moving.iter().zip(still))
                .map(|(v, (m, s))| v * (m - s))
                .sum();
            assert!(power > 0.0);
        }
    }
}

/// Zero modes of a free straight chain.
fn zero_modes(dimension: usize, elements: usize, points: (usize, usize)) -> usize {
    let section = Section::circle(0.05, 1.0, 0.3, 1.0);
    let properties = Properties {
        axis_points: points.0,
        gradient_points: points.1,
        ..Properties::structural(dimension, elements as f64, &section)
    };
    let chain = Chain::along(properties, elements, straight).unwrap();
    let forces = chain.forces(chain.stress_free(), &Supports::new(&chain, &[]));
    let values = eigenvalues(&dense(&forces.tangent));
    let top = values[values.len() - 1];
    values.iter().filter(|value| value.abs() < 1e-12 * top).count()
}

#[test]
fn zero_modes_of_free_chains() {
    for elements in [1, 4] {
        for points in [(3, 2), (3, 3)] {
            assert_eq!(zero_modes(2, elements, points), 3);
            assert_eq!(zero_modes(3, elements, points), 6);
        }
        // THEORY T8, but for one shape, a shear of the section, that the gradient of this shear takes: two axis points let
        // three shapes pass, one gradient point three or more.
        assert_eq!(zero_modes(3, elements, (2, 2)), 9);
        assert!(zero_modes(3, elements, (3, 1)) >= 9);
    }
}

#[test]
fn mass_of_a_straight_element() {
    let properties = Properties::structural(3, 0.8, &SECTION);
    let (q, [line, about_z, about_y]) = (along(properties, straight), properties.mass);
    let m = Element::straight(properties).unwrap().second_moments().unwrap();
    let product = |i: usize, j: usize| -> f64 {
        let pair = |a: usize, b: usize| m[a][b] * q[3 * a + i] * q[3 * b + j];
        (0..10).map(|a| (0..10).map(|b| pair(a, b)).sum::<f64>()).sum()
    };
    assert!((m[0][0] + 2.0 * m[0][6] + m[6][6] - line * 0.8).abs() < 1e-14);
    let expected = [line * 0.8_f64.powi(3) / 3.0, about_z * 0.8, about_y * 0.8];
    for k in 0..3 {
        assert!((product(k, k) - expected[k]).abs() < 1e-14);
    }
    assert!(product(0, 1).abs() + product(1, 2).abs() < 1e-15);
}

#[test]
fn the_planar_element_is_the_spatial_one_in_its_plane() {
    let mut random = Random(9);
    let (flat, q, v) = shaken(soft(2)[0], &mut random);
    let q0 = along(soft(3)[0], curved(0.9, 0.0));
    let full = Element::stress_free_at(soft(3)[0], &q0).unwrap();
    // Places of the planar vectors among the spatial ones; r_z stays the normal.
    const PLACES: [usize; 7] = [0, 1, 2, 4, 6, 7, 8];
    let (mut q_full, mut v_full) = (q0, vec![0.0; 30]);
    for (from, to) in PLACES.into_iter().enumerate() {
        for k in 0..2 {
            q_full[3 * to + k] = q[2 * from + k];
            v_full[3 * to + k] = v[2 * from + k];
        }
    }
    let (planar, spatial) = (force(&flat, &q, &v), force(&full, &q_full, &v_full));
    let inside: Vec<f64> = (0..14).map(|at| spatial[3 * PLACES[at / 2] + at % 2]).collect();
    assert!(relative(&inside, &planar) < 1e-13);
    assert!((full.energy(&q_full) / flat.energy(&q) - 1.0).abs() < 1e-13);
}

#[test]
fn the_whole_element_in_a_moving_frame() {
    let mut random = Random(10);
    let frame = |n: usize| Frame {
        spin: if n == 3 { [0.4, -0.7, 1.1] } else { [0.0, 0.0, 1.1] },
        spin_rate: if n == 3 { [0.2, 0.5, -0.3] } else { [0.0, 0.0, -0.3] },
        origin_acceleration: [0.6, -0.2, if n == 3 { 0.9 } else { 0.0 }],
    };
    for n in [2, 3] {
        let (element, q, qd) = shaken(soft(n)[1], &mut random);
        let (size, qdd) = (q.len(), random.list(q.len(), 1.0));
        let moving = MovingElement::new(element.clone()).unwrap();
        let weights = [Weights::POSITION, Weights::VELOCITY, Weights::ACCELERATION];
        let evaluate = |state: State, weights| {
            let (mut r, mut j) = (vec![0.0; size], vec![0.0; size * size]);
            moving
                .clone()
                .residual_and_jacobian(state, &frame(n), weights, &mut r, &mut j);
            (r, j)
        };
        for (which, weights) in weights.into_iter().enumerate() {
            let states = [&q, &qd, &qdd];
            let exact = evaluate(
                State {
                    q: &q,
                    qd: &qd,
                    qdd: &qdd,
                },
                weights,
            )
            .1;
            let columns = jacobian(
                |x| {
                    let mut states = states.map(|s| s.as_slice());
                    states[which] = x;
                    let [q, qd, qdd] = states;
                    evaluate(State { q, qd, qdd }, weights).0
                },
                states[which],
                1e-2,
            );
            let rows: Vec<f64> = (0..size * size).map(|at| columns[at % size][at / size]).collect();
            assert!(relative(&exact, &rows) < 1e-10);
        }
        // The axis alone is the Hermite element: the same inertia forces on its four vectors.
        let data = Data {
            dimension: n,
            length: 0.8,
            mass_per_length: SECTION.density * SECTION.area,
            axial_stiffness: 1.0,
            bending_stiffness: 0.0,
            exponent: 0,
            damping: 0.0,
            points: 3,
        };
        let places = if n == 2 { [0, 1, 4, 5] } else { [0, 1, 6, 7] };
        let pick = |x: &[f64]| -> Vec<f64> { (0..4 * n).map(|at| x[n * places[at / n] + at % n]).collect() };
        let (q4, qd4, qdd4) = (pick(&q), pick(&qd), pick(&qdd));
        let state = State {
            q: &q4,
            qd: &qd4,
            qdd: &qdd4,
        };
        let mut expected = vec![0.0; 4 * n];
        Inertia::new(&data)
            .unwrap()
            .add_residual(state, &frame(n), &mut expected);
        let (all, _) = evaluate(
            State {
                q: &q,
                qd: &qd,
                qdd: &qdd,
            },
            Weights::POSITION,
        );
        let elastic = force(&element, &q, &qd);
        let inertial: Vec<f64> = all.iter().zip(elastic).map(|(a, e)| a - e).collect();
        assert!(relative(&pick(&inertial), &expected) < 1e-12);
        let first = pick_first(moving.first_moments(), places);
        assert!(relative(&first, &data.first_moments().unwrap()) < 1e-14);
    }
}

fn pick_first(moments: &[f64], places: [usize; 4]) -> Vec<f64> {
    places.iter().map(|&place| moments[place]).collect()
}

#[test]
fn wrong_properties_are_named() {
    let good = soft(3)[0];
    let error = |properties| Element::straight(properties).unwrap_err();
    assert!(error(Properties { dimension: 4, ..good }).contains("dimension"));
    assert!(error(Properties { length: 0.0, ..good }).contains("length"));
    assert!(
        error(Properties {
            mass: [f64::NAN; 3],
            ..good
        })
        .contains("mass")
    );
    assert!(
        error(Properties {
            axis: [[0.0; 6]; 6],
            ..good
        })
        .contains("axis stiffness")
    );
    assert!(error(Properties { damping: -1.0, ..good }).contains("damping"));
    assert!(error(Properties { axis_points: 0, ..good }).contains("one point"));
    assert!(Chain::along(good, 0, straight).unwrap_err().contains("elements"));
}
