//! Materials that are given by their energy per volume: compiled kernels against sums written out, against
//! differences, and against the beam by its moduli.

use rncf_reference::section_beam::particle;

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

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// What a particle is strained by: `1/2 g.g`, `g.b`, `g.c` of its fibre g, and `b.b`, `b.c`, `c.c`, less their values in
/// the stress-free shape; the shear of the axis times a factor.
fn given(dimension: usize, [q, before]: [&[f64]; 2], [xi, y, z]: [f64; 3], shear: f64) -> [f64; 6] {
    let of = |q: &[f64]| {
        let ([g, b, c], [a, ..]) = (gradient(dimension, q, xi, y, z), gradient(dimension, q, xi, 0.0, 0.0));
        let more = shear - 1.0;
        [
            0.5 * dot(&g, &g),
            dot(&g, &b) + more * dot(&a, &b),
            dot(&g, &c) + more * dot(&a, &c),
            dot(&b, &b),
            dot(&b, &c),
            dot(&c, &c),
        ]
    };
    let (now, then) = (of(q), of(before));
    std::array::from_fn(|k| now[k] - then[k])
}

/// The energy where the section is deformed by `[[p, q], [q, r]]` in its plane.
fn density(&[e, gy, gz, yy, yz, zz]: &[f64; 6], &[p, q, r]: &[f64; 3], cubic: f64) -> f64 {
    let (yy, zz) = (1.0 + yy, 1.0 + zz);
    let e_yy = 0.5 * (p * p * yy + 2.0 * p * q * yz + q * q * zz - 1.0);
    let e_zz = 0.5 * (q * q * yy + 2.0 * q * r * yz + r * r * zz - 1.0);
    let e_yz = 0.5 * (p * q * yy + (p * r + q * q) * yz + q * r * zz);
    let (e_xy, e_xz) = (0.5 * (p * gy + q * gz), 0.5 * (q * gy + r * gz));
    let trace = e + e_yy + e_zz;
    let square = e * e + e_yy * e_yy + e_zz * e_zz + 2.0 * (e_xy * e_xy + e_xz * e_xz + e_yz * e_yz);
    0.5 * LAMBDA * trace * trace + MU * square + cubic * e.powi(3)
}

/// Its least over what is free, by a descent along one coordinate after the other.
fn least(given: &[f64; 6], free: &[usize], cubic: f64) -> f64 {
    let mut at = [1.0, 0.0, 1.0];
    for _ in 0..400 {
        let mut moved = 0.0_f64;
        for &k in free {
            // A polynomial of degree four: differences of these steps give its derivatives to round-off.
            let step = 1e-3;
            let [far, near, here, next, ahead] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|by| {
                let mut at = at;
                at[k] += by * step;
                density(given, &at, cubic)
            });
            let slope = (8.0 * (next - near) - (ahead - far)) / (12.0 * step);
            let bend = (16.0 * (next + near) - (ahead + far) - 30.0 * here) / (12.0 * step * step);
            at[k] -= slope / bend;
            moved = moved.max((slope / bend).abs());
        }
        if moved < 1e-11 {
            break;
        }
    }
    density(given, &at, cubic)
}

/// Sum over three points of the axis, and there over the particles of the section with free sides and over the particle
/// on the axis, whose sides are as the section's axes say, less the same with free sides.
fn sum(dimension: usize, particles: &[[f64; 3]], mut of: impl FnMut([f64; 3], &[usize]) -> f64) -> f64 {
    let root = 0.5 * 0.6_f64.sqrt();
    let axis = [(0.5 - root, 5.0), (0.5, 8.0), (0.5 + root, 5.0)];
    let held: &[usize] = if dimension == 3 { &[] } else { &[1, 2] };
    let area: f64 = particles.iter().map(|particle| particle[2]).sum();
    let mut total = 0.0;
    for (xi, weight) in axis {
        let mut section = area * (of([xi, 0.0, 0.0], held) - of([xi, 0.0, 0.0], &[0, 1, 2]));
        for &[y, z, area] in particles {
            section += area * of([xi, y, z], &[0, 1, 2]);
        }
        total += LENGTH * weight / 18.0 * section;
    }
    total
}

fn energy(dimension: usize, states: [&[f64]; 2], section: (&[[f64; 3]], f64), cubic: f64) -> f64 {
    let (particles, shear) = section;
    sum(dimension, particles, |place, free| {
        least(&given(dimension, states, place, shear), free, cubic)
    })
}

/// Cowper's factor of a circle, the root of it.
fn shear_of_a_circle() -> f64 {
    let nu = LAMBDA / (2.0 * (LAMBDA + MU));
    (6.0 * (1.0 + nu) / (7.0 + 6.0 * nu)).sqrt()
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
    let material = kernels::BeamSpatialOfSoftRoundCurvedDampedMaterial { lambda: LAMBDA, mu: MU };
    let row = kernels::BeamSpatialOfSoftRoundCurvedDamped {
        length: LENGTH,
        damping: DAMPING,
        section: rncf::emitted::Section::round(0.3, 0.3, &material),
        material,
        ..Default::default()
    };
    let mut random = Random(3);
    let shape: [f64; 30] = bent(3, 0.1, &mut random).try_into().unwrap();
    let q: [f64; 30] = bent(3, 0.1, &mut random).try_into().unwrap();
    let v: [f64; 30] = std::array::from_fn(|_| random.next());
    let mut reference = [0.0; 45];
    kernels::beam_spatial_of_soft_round_curved_damped_reference(&row, &shape, &mut reference);
    let force = |q: &[f64], v: &[f64]| {
        let (q, v) = (rncf::emitted::array(q), rncf::emitted::array(v));
        let mut force = [0.0; 30];
        kernels::beam_spatial_of_soft_round_curved_damped_elastic_force(&row, &reference, q, v, &mut force);
        force.to_vec()
    };
    let stored = |q: &[f64]| {
        let mut stored = 0.0;
        kernels::beam_spatial_of_soft_round_curved_damped_strain_energy(
            &row,
            &reference,
            rncf::emitted::array(q),
            &mut stored,
        );
        stored
    };
    let section = (&row.section.particles[..], shear_of_a_circle());
    let (found, wanted) = (stored(&q), energy(3, [&q, &shape], section, CUBIC));
    assert!((found / wanted - 1.0).abs() < 1e-10, "{found} instead of {wanted}");
    let potential = differences(&q, |q| vec![stored(q)]);
    assert_columns("force", &force(&q, &[0.0; 30]), &potential, 1e-8);
    // Power of the damping: s times the second derivative of the energy along the rate of the strain.
    let step = 1e-3;
    let moved = |by: f64| -> Vec<f64> { q.iter().zip(&v).map(|(q, v)| q + by * v).collect() };
    let (ahead, behind) = (moved(step), moved(-step));
    let power = sum(3, section.0, |place, free| {
        let at = |q: &[f64]| given(3, [q, &shape], place, section.1);
        // What is given is quadratic in q: a central difference is its rate.
        let (now, ahead, behind) = (at(&q), at(&ahead), at(&behind));
        let along = |by: f64| {
            let given = std::array::from_fn(|k| now[k] + by * (ahead[k] - behind[k]) / (2.0 * step));
            least(&given, free, CUBIC)
        };
        let h = 1e-2;
        let near = along(h) + along(-h) - 2.0 * along(0.0);
        let far = along(2.0 * h) + along(-2.0 * h) - 2.0 * along(0.0);
        DAMPING * (16.0 * near - far) / (12.0 * h * h)
    });
    let (damped, free) = (force(&q, &v), force(&q, &[0.0; 30]));
    let found: f64 = (0..30).map(|i| v[i] * (damped[i] - free[i])).sum();
    assert!((found / power - 1.0).abs() < 1e-6, "{found} instead of {power}");
    let (mut k, mut c) = ([0.0; 900], [0.0; 900]);
    kernels::beam_spatial_of_soft_round_curved_damped_elastic_tangent(&row, &reference, &q, &v, &mut k, &mut c);
    assert_columns("stiffness", &k, &differences(&q, |q| force(q, &v)), 1e-7);
    assert_columns("damping", &c, &differences(&v, |v| force(&q, v)), 1e-9);
}

/// In the plane the strain along the normal is free.
#[test]
fn a_rectangle_in_the_plane() {
    let material = kernels::BeamPlanarOfLinearRectangleMaterial { lambda: LAMBDA, mu: MU };
    let row = kernels::BeamPlanarOfLinearRectangle {
        length: LENGTH,
        // The torsion constant has no meaning here.
        section: rncf::emitted::Section::rectangle([0.4, 0.2], 1.0),
        material,
        ..Default::default()
    };
    let mut random = Random(4);
    let q: [f64; 14] = bent(2, 0.1, &mut random).try_into().unwrap();
    let force = |q: &[f64]| {
        let mut force = [0.0; 14];
        kernels::beam_planar_of_linear_rectangle_elastic_force(&row, rncf::emitted::array(q), &mut force);
        force.to_vec()
    };
    let before = straight(2);
    let section = (&row.section.particles[..], (5.0_f64 / 6.0).sqrt());
    assert_columns(
        "force",
        &force(&q),
        &differences(&q, |q| vec![energy(2, [q, &before], section, 0.0)]),
        1e-7,
    );
    let mut k = [0.0; 196];
    kernels::beam_planar_of_linear_rectangle_elastic_tangent(&row, &q, &mut k);
    assert_columns("stiffness", &k, &differences(&q, force), 1e-7);
}

/// Stiffness of the straight element of a linear material without lateral contraction, by its energy and by
/// its moduli: the same but for a section that shears in its plane ever more along the axis, which counts
/// (radius / length)^2 as much as the shear itself.
#[test]
fn without_lateral_contraction_it_is_the_beam_by_its_moduli() {
    use rncf_reference::section_beam::{Element, Properties, Section, residual_and_jacobian};
    let q: [f64; 30] = straight(3).try_into().unwrap();
    for (radius, limit) in [(0.3, 0.1), (0.03, 1e-3), (0.0003, 1e-7)] {
        let material = kernels::BeamSpatialOfLinearRoundMaterial { lambda: 0.0, mu: MU };
        let row = kernels::BeamSpatialOfLinearRound {
            length: LENGTH,
            section: rncf::emitted::Section::round(radius, radius, &material),
            material,
            ..Default::default()
        };
        let mut k = [0.0; 900];
        kernels::beam_spatial_of_linear_round_elastic_tangent(&row, &q, &mut k);
        let section = Section::circle(radius, 2.0 * MU, 0.0, 1.0);
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
    let material = kernels::BeamSpatialOfLinearRoundMaterial { lambda: LAMBDA, mu: MU };
    let row = kernels::BeamSpatialOfLinearRound {
        length: LENGTH,
        section: rncf::emitted::Section::round(0.3, 0.3, &material),
        material,
        ..Default::default()
    };
    let mut k = [0.0; 900];
    kernels::beam_spatial_of_linear_round_elastic_tangent(&row, rncf::emitted::array(&straight(3)), &mut k);
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
    let material = kernels::BeamSpatialOfLinearRoundMaterial { lambda: 0.0, mu: MU };
    let row = kernels::BeamSpatialOfLinearRound {
        length: LENGTH,
        section: rncf::emitted::Section::round(0.3, 0.3, &material),
        material,
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
