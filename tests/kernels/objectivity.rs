//! Rigid motions make no force.

use crate::models::{curved_damped_equations as polynomial, curved_exact_equations as exact};

/// An initially curved planar element, rotated rigidly by any angle. Its frame's origin may be 1 AU
/// away: nodal vectors are relative to it, so that distance enters nowhere (Eq. 1).
#[test]
fn a_rotated_curved_element_feels_no_force() {
    let row = polynomial::CablePlanarCurvedDamped {
        length: 0.47,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
        damping: 2e-3,
    };
    let line = rncf::emitted::Line::Arc {
        from: [0.3, -0.2, 0.0],
        direction: [1.0, 0.4, 0.0],
        normal: [0.0, 0.0, 1.0],
        radius: 0.5,
        angle: 0.94,
    };
    let (start, end) = (line.at(0.0), line.at(1.0));
    let shape = [
        start.0[0], start.0[1], start.1[0], start.1[1], end.0[0], end.0[1], end.1[0], end.1[1],
    ];
    let mut reference = [0.0; 9];
    polynomial::cable_planar_curved_damped_reference(&row, &shape, &mut reference);
    let exact_row = exact::CablePlanarExactCurvedDamped {
        length: row.length,
        EA: row.EA,
        EI: row.EI,
        rhoA: row.rhoA,
        damping: row.damping,
    };
    let mut exact_reference = [0.0; 10];
    exact::cable_planar_exact_curved_damped_reference(&exact_row, &shape, &mut exact_reference);
    for degrees in (0..=360).step_by(15) {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let turn = |pair: &[f64]| [cosine * pair[0] - sine * pair[1], sine * pair[0] + cosine * pair[1]];
        let q: Vec<f64> = shape.chunks(2).flat_map(turn).collect();
        let q: [f64; 8] = q.try_into().unwrap();
        // A rigid rotation at 10 rad/s strains nothing and damps nothing.
        let v: [f64; 8] = std::array::from_fn(|i| if i % 2 == 0 { -10.0 * q[i + 1] } else { 10.0 * q[i - 1] });
        let mut forces = [[0.0; 8]; 2];
        polynomial::cable_planar_curved_damped_elastic_force(&row, &reference, &q, &v, &mut forces[0]);
        exact::cable_planar_exact_curved_damped_elastic_force(&exact_row, &exact_reference, &q, &v, &mut forces[1]);
        for force in forces.iter().flatten() {
            assert!(force.abs() <= 1e-12 * row.EA, "{degrees} deg: {force} N");
        }
    }
    // A stretched element does feel one: the test can fail.
    let stretched: [f64; 8] = shape.map(|x| 1.01 * x);
    let mut force = [0.0; 8];
    polynomial::cable_planar_curved_damped_elastic_force(&row, &reference, &stretched, &[0.0; 8], &mut force);
    assert!(force.iter().any(|f| f.abs() > 1e-3 * row.EA));
}
