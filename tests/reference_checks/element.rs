//! The Gauss-point element: forces and tangents against differences, objectivity, closed forms of THEORY 5.1.

use crate::differences::{Random, jacobian, largest, relative};
use rncf_reference::element::{Data, ElasticForce, GaussElement, Weights, shape, shape_x, shape_xx};
use rncf_reference::quadrature::gauss_legendre;

/// An element with numbers of one magnitude, so that no term hides behind another.
pub fn data(dimension: usize, exponent: u32) -> Data {
    Data {
        dimension,
        length: 1.3,
        mass_per_length: 0.7,
        axial_stiffness: 4.0,
        bending_stiffness: 3.0,
        exponent,
        damping: 0.4,
        points: 6,
    }
}

/// A strongly bent and stretched state.
pub fn bent(dimension: usize, random: &mut Random) -> Vec<f64> {
    let mut q = random.list(4 * dimension, 0.3);
    q[dimension] += 1.0;
    q[2 * dimension] += 1.3;
    q[3 * dimension] += 1.0;
    q
}

/// Force at a state.
pub fn force(element: &impl ElasticForce, q: &[f64], qd: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; q.len()];
    element.add_force(q, qd, &mut force);
    force
}

/// Largest relative errors of force and tangents against differences of energy and force.
pub fn errors(element: &impl ElasticForce, q: &[f64], qd: &[f64]) -> [f64; 4] {
    let size = q.len();
    let at_rest = force(element, q, &vec![0.0; size]);
    let slope: Vec<f64> = jacobian(|q| vec![element.energy(q)], q, 3e-3).concat();
    let mut errors = [relative(&at_rest, &slope), 0.0, 0.0, 0.0];
    let stiffness = jacobian(|q| force(element, q, qd), q, 3e-3).concat();
    let damping = jacobian(|qd| force(element, q, qd), qd, 3e-3).concat();
    for (k, (weights, columns)) in [(Weights::POSITION, stiffness), (Weights::VELOCITY, damping)]
        .into_iter()
        .enumerate()
    {
        let (mut with, mut tangent) = (vec![0.0; size], vec![0.0; size * size]);
        element.add_force_and_tangent(q, qd, weights, &mut with, &mut tangent);
        errors[3] = relative(&with, &force(element, q, qd)).max(errors[3]);
        let transposed: Vec<f64> = (0..size * size)
            .map(|at| tangent[(at % size) * size + at / size])
            .collect();
        errors[1 + k] = relative(&transposed, &columns);
    }
    errors
}

#[test]
fn force_and_tangents_are_the_derivatives() {
    let mut random = Random(1);
    for dimension in [2, 3] {
        for exponent in [0, 1, 2, 3] {
            let element = GaussElement::straight(data(dimension, exponent)).unwrap();
            let (q, qd) = (bent(dimension, &mut random), random.list(4 * dimension, 1.0));
            let found = errors(&element, &q, &qd);
            println!(
                "dimension {dimension}, p = {exponent}: force {:.1e}, K {:.1e}, C {:.1e}",
                found[0], found[1], found[2]
            );
            assert!(
                found[0] < 1e-9 && found[1] < 1e-9 && found[2] < 1e-9,
                "{dimension} {exponent} {found:?}"
            );
            assert!(found[3] < 1e-15);
        }
    }
}

#[test]
fn curved_element_too() {
    let mut random = Random(2);
    for exponent in [0, 2] {
        let reference = bent(2, &mut random);
        let element = GaussElement::curved(data(2, exponent), &reference).unwrap();
        let found = errors(&element, &bent(2, &mut random), &random.list(8, 1.0));
        assert!(found.iter().all(|error| *error < 1e-9), "p = {exponent}: {found:?}");
    }
}

#[test]
fn rigid_rotation_of_a_curved_element_gives_no_force() {
    let mut random = Random(3);
    let mut worst = 0.0;
    for exponent in [0, 2] {
        let data = Data {
            axial_stiffness: 5e6,
            bending_stiffness: 500.0,
            ..data(2, exponent)
        };
        let reference = bent(2, &mut random);
        let element = GaussElement::curved(data, &reference).unwrap();
        for step in 0..24 {
            let (sin, cos) = (f64::from(step) * 0.3).sin_cos();
            let turned =
                |q: &[f64], shift: [f64; 2]| [cos * q[0] - sin * q[1] + shift[0], sin * q[0] + cos * q[1] + shift[1]];
            let q: Vec<f64> = (0..4)
                .flat_map(|i| {
                    turned(
                        &reference[2 * i..][..2],
                        if i % 2 == 0 { [3.0, -2.0] } else { [0.0, 0.0] },
                    )
                })
                .collect();
            // A rotation rate as well: damping must not act on it either.
            let qd: Vec<f64> = (0..4).flat_map(|i| [-7.0 * q[2 * i + 1], 7.0 * q[2 * i]]).collect();
            let residue = largest(force(&element, &q, &qd)) / data.axial_stiffness;
            worst = f64::max(worst, residue);
        }
    }
    println!("rigidly turned curved element: force / EA = {worst:.1e}");
    assert!(worst < 1e-13, "{worst}");
}

#[test]
fn a_straight_element_resists_what_a_curved_one_does_not() {
    let reference = bent(2, &mut Random(3));
    let element = GaussElement::straight(data(2, 0)).unwrap();
    assert!(largest(force(&element, &reference, &[0.0; 8])) > 0.1);
}

#[test]
fn planar_motion_of_a_spatial_element_is_planar() {
    let mut random = Random(4);
    for exponent in [0, 2] {
        let (planar, spatial) = (data(2, exponent), data(3, exponent));
        // Damping of the curvature exists in the plane alone.
        let (planar, spatial) = (
            Data { damping: 0.0, ..planar },
            Data {
                damping: 0.0,
                ..spatial
            },
        );
        let q2 = bent(2, &mut random);
        let q3: Vec<f64> = (0..4).flat_map(|i| [q2[2 * i], q2[2 * i + 1], 0.0]).collect();
        let f2 = force(&GaussElement::straight(planar).unwrap(), &q2, &[0.0; 8]);
        let f3 = force(&GaussElement::straight(spatial).unwrap(), &q3, &[0.0; 12]);
        let embedded: Vec<f64> = (0..4).flat_map(|i| [f2[2 * i], f2[2 * i + 1], 0.0]).collect();
        assert!(relative(&f3, &embedded) < 1e-14);
    }
}

#[test]
fn five_points_integrate_the_polynomial_energy_exactly() {
    for dimension in [2, 3] {
        let q = bent(dimension, &mut Random(5));
        let energy = |points| {
            GaussElement::straight(Data {
                points,
                ..data(dimension, 0)
            })
            .unwrap()
            .energy(&q)
        };
        let exact = energy(12);
        assert!((energy(5) / exact - 1.0).abs() < 1e-14);
        assert!((energy(4) / exact - 1.0).abs() > 1e-8);
    }
}

#[test]
fn forces_are_balanced() {
    // THEORY 4.1: no resultant force, no resultant moment, for any state.
    let q = bent(3, &mut Random(6));
    let element = GaussElement::straight(data(3, 2)).unwrap();
    let f = force(&element, &q, &Random(7).list(12, 1.0));
    let scale = largest(f.iter().copied());
    for k in 0..3 {
        assert!((f[k] + f[6 + k]).abs() < 1e-14 * scale);
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        let moment: f64 = (0..4)
            .map(|i| q[3 * i + a] * f[3 * i + b] - q[3 * i + b] * f[3 * i + a])
            .sum();
        assert!(moment.abs() < 1e-14 * scale);
    }
}

#[test]
fn mass_moments_match_the_closed_forms() {
    let data = data(2, 0);
    let (l, mass) = (data.length, data.length * data.mass_per_length);
    let d = [0.5, l / 12.0, 0.5, -l / 12.0].map(|entry| mass * entry);
    assert!(relative(&data.first_moments().unwrap(), &d) < 1e-15);
    let m = [
        [13.0 / 35.0, 11.0 * l / 210.0, 9.0 / 70.0, -13.0 * l / 420.0],
        [11.0 * l / 210.0, l * l / 105.0, 13.0 * l / 420.0, -l * l / 140.0],
        [9.0 / 70.0, 13.0 * l / 420.0, 13.0 / 35.0, -11.0 * l / 210.0],
        [-13.0 * l / 420.0, -l * l / 140.0, -11.0 * l / 210.0, l * l / 105.0],
    ];
    let m = m.map(|row| row.map(|entry| mass * entry));
    assert!(relative(&data.second_moments().unwrap().concat(), &m.concat()) < 2e-15);
}

#[test]
fn zeta_matches_the_closed_form() {
    let l = 1.7;
    let mut zeta = [[0.0; 4]; 4];
    for point in gauss_legendre(3).unwrap() {
        let s = shape_x(point.xi, l);
        for i in 0..4 {
            for j in 0..4 {
                zeta[i][j] += point.weight * l * s[i] * s[j];
            }
        }
    }
    let exact = [
        [6.0 / (5.0 * l), 0.1, -6.0 / (5.0 * l), 0.1],
        [0.1, 2.0 * l / 15.0, -0.1, -l / 30.0],
        [-6.0 / (5.0 * l), -0.1, 6.0 / (5.0 * l), -0.1],
        [0.1, -l / 30.0, -0.1, 2.0 * l / 15.0],
    ];
    assert!(relative(&zeta.concat(), &exact.concat()) < 1e-15);
}

#[test]
fn shape_derivatives_are_derivatives() {
    let l = 2.3;
    for xi in [0.0, 0.2, 0.7, 1.0] {
        let by_x = jacobian(|x| shape(x[0] / l, l).to_vec(), &[xi * l], 1e-2).concat();
        let twice = jacobian(|x| shape_x(x[0] / l, l).to_vec(), &[xi * l], 1e-2).concat();
        assert!(relative(&shape_x(xi, l), &by_x) < 1e-12 && relative(&shape_xx(xi, l), &twice) < 1e-12);
    }
}

#[test]
fn wrong_data_are_named() {
    let wrong = |data: Data| GaussElement::straight(data).unwrap_err();
    assert!(
        wrong(Data {
            dimension: 4,
            ..data(2, 0)
        })
        .contains("dimension")
    );
    assert!(
        wrong(Data {
            length: 0.0,
            ..data(2, 0)
        })
        .contains("length")
    );
    assert!(
        wrong(Data {
            damping: f64::NAN,
            ..data(2, 0)
        })
        .contains("damping")
    );
    assert!(
        wrong(Data {
            points: 0,
            ..data(2, 0)
        })
        .contains("count")
    );
    assert!(
        GaussElement::curved(data(3, 0), &[0.0; 12])
            .unwrap_err()
            .contains("planar")
    );
    assert!(GaussElement::curved(data(2, 0), &[0.0; 7]).unwrap_err().contains("7"));
}
