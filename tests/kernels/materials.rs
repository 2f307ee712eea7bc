//! Materials that are given by their energy per volume: compiled kernels against sums written out, against
//! differences, and against the beam by its moduli.

use rncf_tests::section_beam::particle;

use crate::jacobians::Random;

rncf::model! {
    /// Every way to integrate: twisted and damped, straight, in the plane, a rectangle.
    pub model Materials {
        param lambda = 4 kPa;
        param mu = 10.5 kPa;
        const cubic = 3 kPa;
        material soft {
            density = 7.8 kg/m^3;
            damping = 20 ms;
            energy = lambda / 2 * (E.xx + E.yy + E.zz)^2
                + mu * (E.xx^2 + E.yy^2 + E.zz^2 + 2 * (E.xy^2 + E.xz^2 + E.yz^2))
                + cubic * E.xx^3;
        }
        material linear {
            density = 7.8 kg/m^3;
            energy = lambda / 2 * (E.xx + E.yy + E.zz)^2
                + mu * (E.xx^2 + E.yy^2 + E.zz^2 + 2 * (E.xy^2 + E.xz^2 + E.yz^2));
        }
        section round = circle(radius = 20 mm);
        section block = rectangle(y = 40 mm, z = 20 mm);
        body twisted in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            twist 30 deg;
            mesh 2 * beam(round, soft);
        }
        body straight in inertial { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(round, linear); }
        body strip in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(block, linear); }
        joint one = clamp(twisted.start, inertial);
        joint two = clamp(straight.start, inertial);
        joint three = clamp(strip.start, inertial);
        output tip = straight.end;
        output tip_of_twisted = twisted.end;
        output tip_of_strip = strip.end;
    }
}

use materials_equations as kernels;

const LENGTH: f64 = 0.7;
const DAMPING: f64 = 0.02;
const LAMBDA: f64 = 4e3;
const MU: f64 = 10.5e3;
const CUBIC: f64 = 3e3;

/// A straight element along x.
fn straight(dimension: usize) -> Vec<f64> {
    let (e, y, z, far) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [LENGTH, 0.0, 0.0]);
    let vectors = if dimension == 3 {
        vec![[0.0; 3], e, y, z, y, z, far, e, y, z]
    } else {
        vec![[0.0; 3], e, y, y, far, e, y]
    };
    vectors.iter().flat_map(|vector| vector[..dimension].to_vec()).collect()
}

fn bent(dimension: usize, by: f64, random: &mut Random) -> Vec<f64> {
    straight(dimension).iter().map(|x| x + by * random.next()).collect()
}

/// G at a particle: the particle's position by differences of its shape functions in x, its directors.
fn gradient(dimension: usize, q: &[f64], xi: f64, y: f64, z: f64) -> [[f64; 3]; 3] {
    let at = |row: usize, xi: f64| -> [f64; 3] {
        let weights = particle(dimension, xi, LENGTH)[row];
        std::array::from_fn(|c| {
            let terms = (0..q.len() / dimension).map(|a| weights[a] * q[a * dimension + c]);
            if c < dimension { terms.sum() } else { 0.0 }
        })
    };
    // Shape functions are cubic: a fourth-order difference is exact.
    let step = 1e-2;
    let slope = |row: usize, c: usize| {
        let near = at(row, xi + step)[c] - at(row, xi - step)[c];
        let far = at(row, xi + 2.0 * step)[c] - at(row, xi - 2.0 * step)[c];
        (8.0 * near - far) / (12.0 * step * LENGTH)
    };
    let third = if dimension == 2 { [0.0, 0.0, 1.0] } else { at(2, xi) };
    [
        std::array::from_fn(|c| {
            let turned = if dimension == 3 { z * slope(2, c) } else { 0.0 };
            slope(0, c) + y * slope(1, c) + turned
        }),
        at(1, xi),
        third,
    ]
}

/// `1/2 (G^T G - G0^T G0)`.
fn strain(g: &[[f64; 3]; 3], before: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (dot(&g[i], &g[j]) - dot(&before[i], &before[j]))))
}

fn density(e: &[[f64; 3]; 3], cubic: f64) -> f64 {
    let trace = e[0][0] + e[1][1] + e[2][2];
    let square: f64 = e.iter().flatten().map(|x| x * x).sum();
    0.5 * LAMBDA * trace * trace + MU * square + cubic * e[0][0].powi(3)
}

/// Sum over three points of the axis and the particles of the section.
fn sum(particles: &[[f64; 3]], mut of: impl FnMut(f64, f64, f64) -> f64) -> f64 {
    let root = 0.5 * 0.6_f64.sqrt();
    let axis = [(0.5 - root, 5.0), (0.5, 8.0), (0.5 + root, 5.0)];
    let mut total = 0.0;
    for (xi, weight) in axis {
        for &[y, z, area] in particles {
            total += LENGTH * weight / 18.0 * area * of(xi, y, z);
        }
    }
    total
}

fn energy(dimension: usize, q: &[f64], before: &[f64], particles: &[[f64; 3]], cubic: f64) -> f64 {
    sum(particles, |xi, y, z| {
        let [g, g0] = [q, before].map(|q| gradient(dimension, q, xi, y, z));
        density(&strain(&g, &g0), cubic)
    })
}

/// Central differences of fourth order, one column for each coordinate.
fn differences(q: &[f64], mut of: impl FnMut(&[f64]) -> Vec<f64>) -> Vec<Vec<f64>> {
    let step = 2e-3;
    let column = |j: usize| {
        let mut at = |by: f64| {
            let mut q = q.to_vec();
            q[j] += by;
            of(&q)
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|by| at(by * step));
        (0..a.len())
            .map(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * step))
            .collect()
    };
    (0..q.len()).map(column).collect()
}

#[track_caller]
fn assert_columns(what: &str, found: &[f64], columns: &[Vec<f64>], limit: f64) {
    let scale = columns.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    assert!(scale > 0.0, "{what}: the reference is zero");
    for (j, column) in columns.iter().enumerate() {
        for (i, wanted) in column.iter().enumerate() {
            let value = found[i * columns.len() + j];
            assert!(
                (value - wanted).abs() <= limit * scale,
                "{what} {i} {j}: {value} instead of {wanted}"
            );
        }
    }
}

/// Twisted, damped, with a stiffness that changes with the strain.
#[test]
fn a_damped_nonlinear_material() {
    let row = kernels::BeamSpatialOfSoftRoundCurvedDamped {
        length: LENGTH,
        damping: DAMPING,
        section: rncf::mesh::round_particles(0.3, 0.3),
        material: kernels::BeamSpatialOfSoftRoundCurvedDampedMaterial { lambda: LAMBDA, mu: MU },
        ..Default::default()
    };
    let mut random = Random(3);
    let shape: [f64; 30] = bent(3, 0.1, &mut random).try_into().unwrap();
    let q: [f64; 30] = bent(3, 0.15, &mut random).try_into().unwrap();
    let v: [f64; 30] = std::array::from_fn(|_| random.next());
    let mut reference = [0.0; 45];
    kernels::beam_spatial_of_soft_round_curved_damped_reference(&row, &shape, &mut reference);
    let force = |q: &[f64], v: &[f64]| {
        let (q, v) = (rncf::mesh::array(q), rncf::mesh::array(v));
        let mut force = [0.0; 30];
        kernels::beam_spatial_of_soft_round_curved_damped_elastic_force(&row, &reference, q, v, &mut force);
        force.to_vec()
    };
    let mut stored = 0.0;
    kernels::beam_spatial_of_soft_round_curved_damped_strain_energy(&row, &reference, &q, &mut stored);
    let particles = &row.section[..];
    let wanted = energy(3, &q, &shape, particles, CUBIC);
    assert!((stored / wanted - 1.0).abs() < 1e-11, "{stored} instead of {wanted}");
    let potential = differences(&q, |q| vec![energy(3, q, &shape, particles, CUBIC)]);
    assert_columns("force", &force(&q, &[0.0; 30]), &potential, 1e-8);
    // Power of the damping: s E' : D : E'.
    let power = sum(particles, |xi, y, z| {
        let [g, g0] = [&q, &shape].map(|q| gradient(3, q, xi, y, z));
        let e = strain(&g, &g0);
        let step = 1e-3;
        let ahead: Vec<f64> = q.iter().zip(&v).map(|(q, v)| q + step * v).collect();
        let behind: Vec<f64> = q.iter().zip(&v).map(|(q, v)| q - step * v).collect();
        let [ahead, behind] = [ahead, behind].map(|q| strain(&gradient(3, &q, xi, y, z), &g0));
        // The strain is quadratic in q: a central difference is its rate.
        let rate: [[f64; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| (ahead[i][j] - behind[i][j]) / (2.0 * step)));
        2.0 * DAMPING * (density(&rate, 0.0) + 3.0 * CUBIC * e[0][0] * rate[0][0] * rate[0][0])
    });
    let (damped, free) = (force(&q, &v), force(&q, &[0.0; 30]));
    let found: f64 = (0..30).map(|i| v[i] * (damped[i] - free[i])).sum();
    assert!((found / power - 1.0).abs() < 1e-9, "{found} instead of {power}");
    let (mut k, mut c) = ([0.0; 900], [0.0; 900]);
    kernels::beam_spatial_of_soft_round_curved_damped_elastic_tangent(&row, &reference, &q, &v, &mut k, &mut c);
    assert_columns("stiffness", &k, &differences(&q, |q| force(q, &v)), 1e-8);
    assert_columns("damping", &c, &differences(&v, |v| force(&q, v)), 1e-10);
}

/// In the plane nothing strains along the normal.
#[test]
fn a_rectangle_in_the_plane() {
    let row = kernels::BeamPlanarOfLinearRectangle {
        length: LENGTH,
        section: rncf::mesh::rectangle_particles([0.4, 0.2]),
        material: kernels::BeamPlanarOfLinearRectangleMaterial { lambda: LAMBDA, mu: MU },
        ..Default::default()
    };
    let mut random = Random(4);
    let q: [f64; 14] = bent(2, 0.15, &mut random).try_into().unwrap();
    let force = |q: &[f64]| {
        let mut force = [0.0; 14];
        kernels::beam_planar_of_linear_rectangle_elastic_force(&row, rncf::mesh::array(q), &mut force);
        force.to_vec()
    };
    let before = straight(2);
    let particles = &row.section[..];
    assert_columns(
        "force",
        &force(&q),
        &differences(&q, |q| vec![energy(2, q, &before, particles, 0.0)]),
        1e-8,
    );
    let mut k = [0.0; 196];
    kernels::beam_planar_of_linear_rectangle_elastic_tangent(&row, &q, &mut k);
    assert_columns("stiffness", &k, &differences(&q, force), 1e-8);
}

/// Stiffness of the straight element of a linear material without lateral contraction, by its energy and by
/// its moduli: the same but for a section that shears in its plane ever more along the axis, which counts
/// (radius / length)^2 as much as the shear itself.
#[test]
fn without_lateral_contraction_it_is_the_beam_by_its_moduli() {
    use rncf_tests::section_beam::{Element, Properties, Section, residual_and_jacobian};
    let q: [f64; 30] = straight(3).try_into().unwrap();
    for (radius, limit) in [(0.3, 0.1), (0.03, 1e-3), (0.0003, 1e-7)] {
        let row = kernels::BeamSpatialOfLinearRound {
            length: LENGTH,
            section: rncf::mesh::round_particles(radius, radius),
            material: kernels::BeamSpatialOfLinearRoundMaterial { lambda: 0.0, mu: MU },
            ..Default::default()
        };
        let mut k = [0.0; 900];
        kernels::beam_spatial_of_linear_round_elastic_tangent(&row, &q, &mut k);
        let section = Section {
            shear_factor: 1.0,
            ..Section::circle(radius, 2.0 * MU, 0.0, 1.0)
        };
        let element = Element::straight(Properties {
            gradient_points: 3,
            ..Properties::structural(3, LENGTH, &section)
        });
        let (mut force, mut wanted, mut c) = ([0.0; 30], [0.0; 900], [0.0; 900]);
        residual_and_jacobian(&q, &[0.0; 30], &element.unwrap(), &mut force, &mut wanted, &mut c);
        let scale = wanted.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let error = k.iter().zip(&wanted).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(error <= limit * scale, "radius {radius}: {:e}", error / scale);
        // Bending and torsion, r_y and r_z turning with the axis: exactly the same.
        for turn in 0..3 {
            let mode = turned(turn);
            let product = |k: &[f64]| -> f64 {
                let line = |i: usize| (0..30).map(|j| k[30 * i + j] * mode[j]).sum::<f64>();
                (0..30).map(|i| mode[i] * line(i)).sum()
            };
            let (found, wanted) = (product(&k), product(&wanted));
            assert!((found / wanted - 1.0).abs() < 1e-8, "{turn}: {found} {wanted}");
        }
    }
}

/// Small displacements where the section turns by x about its axis 0, 1 or 2 and follows the axis.
fn turned(axis: usize) -> [f64; 30] {
    let mut mode = [0.0; 30];
    let mut set = |vector: usize, c: usize, value: f64| mode[3 * vector + c] = value;
    let (half, l) = (0.5 * LENGTH, LENGTH);
    match axis {
        0 => {
            for (y, z, x) in [(4, 5, half), (8, 9, l)] {
                set(y, 2, x);
                set(z, 1, -x);
            }
        }
        1 => {
            set(6, 2, -0.5 * l * l);
            set(7, 2, -l);
            set(5, 0, half);
            set(9, 0, l);
        }
        _ => {
            set(6, 1, 0.5 * l * l);
            set(7, 1, l);
            set(4, 0, -half);
            set(8, 0, -l);
        }
    }
    mode
}

/// Six rigid motions and nothing else leave one element free, three points of the axis being enough.
#[test]
fn no_motion_but_the_rigid_ones_is_free() {
    let row = kernels::BeamSpatialOfLinearRound {
        length: LENGTH,
        section: rncf::mesh::round_particles(0.3, 0.3),
        material: kernels::BeamSpatialOfLinearRoundMaterial { lambda: LAMBDA, mu: MU },
        ..Default::default()
    };
    let mut k = [0.0; 900];
    kernels::beam_spatial_of_linear_round_elastic_tangent(&row, rncf::mesh::array(&straight(3)), &mut k);
    assert_eq!(30 - rank(k.to_vec(), 30), 6);
}

/// Rank by elimination with full pivoting.
pub fn rank(mut a: Vec<f64>, n: usize) -> usize {
    let scale = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for step in 0..n {
        let places = (step..n).flat_map(|i| (step..n).map(move |j| (i, j)));
        let (i, j) = places
            .max_by(|x, y| a[x.0 * n + x.1].abs().total_cmp(&a[y.0 * n + y.1].abs()))
            .unwrap();
        if a[i * n + j].abs() < 1e-10 * scale {
            return step;
        }
        (0..n).for_each(|c| a.swap(i * n + c, step * n + c));
        (0..n).for_each(|r| a.swap(r * n + j, r * n + step));
        for r in step + 1..n {
            let factor = a[r * n + step] / a[step * n + step];
            (step..n).for_each(|c| a[r * n + c] -= factor * a[step * n + c]);
        }
    }
    n
}

/// Forces on the fields at a point are those that the element's force is made of.
#[test]
fn forces_on_the_fields() {
    let row = kernels::BeamSpatialOfLinearRound {
        length: LENGTH,
        section: rncf::mesh::round_particles(0.3, 0.3),
        material: kernels::BeamSpatialOfLinearRoundMaterial { lambda: 0.0, mu: MU },
        ..Default::default()
    };
    let free = [
        1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    ];
    // Pure bending about z with curvature 1e-6, and stretched by 1e-6.
    let mut fields = free;
    fields[0] += 1e-6;
    fields[9] -= 1e-6;
    let mut forces = [0.0; 15];
    kernels::beam_spatial_of_linear_round_field_forces(&row, &free, &fields, &mut forces);
    let area = std::f64::consts::PI * 0.09;
    let (stretch, bend) = (2.0 * MU * area * 1e-6, 2.0 * MU * area * 0.0225 * 1e-6);
    assert!((forces[0] / stretch - 1.0).abs() < 1e-5, "{} {stretch}", forces[0]);
    assert!((forces[9] / -bend - 1.0).abs() < 1e-5, "{} {bend}", forces[9]);
}
