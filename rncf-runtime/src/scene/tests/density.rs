//! Loads per length and gravity fields against differences, sums written out and closed forms.

use super::differences::check;
use super::model::{Hand, hermite};
use super::random::Random;
use super::scenery::{body, everything, free};
use crate::emitted::{DensitySpec, LANES, LoadKind, LoadSpec, MarkerSpec};
use crate::model::{Formulation, Joints, Scene};
use crate::scene::MeshScene;
use crate::space::{Matrix, Vector, three};
use crate::system::{State, System};

/// Points and weights that integrate polynomials of degree 11 on [0, 1].
const RULE: [(f64, f64); 6] = [
    (0.033_765_242_898_423_975, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_4, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// `c = 0.4 + 0.2 z_0 . z_1 + sin t`, and `b = z_1` with the components in the body's order.
pub fn values(t: f64, z: &[Vector]) -> [f64; 4] {
    let [x, y, w]: [f64; 3] = z[1].into();
    [0.4 + 0.2 * z[0].dot(&z[1]) + t.sin(), x, y, w]
}

pub fn gradient(z: &[Vector], gradient: &mut [f64]) {
    let width = 3 * z.len();
    for i in 0..3 {
        gradient[i] = 0.2 * z[1][i];
        gradient[3 + i] = 0.2 * z[0][i];
        gradient[(1 + i) * width + 3 + i] = 1.0;
    }
}

/// `f = c [(s.s) b - s (s.b)] + (s.s) p / 5`.
fn density(s: Vector, p: Vector, values: [f64; 4]) -> Vector {
    let [c, x, y, z] = values;
    let b = Vector::new(x, y, z);
    c * (s.dot(&s) * b - s.dot(&b) * s) + 0.2 * s.dot(&s) * p
}

/// Directional derivative of [`density`].
fn change(at: [Vector; 2], values: [f64; 4], by: [Vector; 2], by_values: [f64; 4]) -> Vector {
    let ([s, p], [ds, dp]) = (at, by);
    let ([c, x, y, z], [dc, dx, dy, dz]) = (values, by_values);
    let (b, db) = (Vector::new(x, y, z), Vector::new(dx, dy, dz));
    let thrust = |s: Vector, r: Vector, b: Vector| s.dot(&r) * b - s.dot(&b) * r;
    let turned = thrust(s, ds, b) + (s.dot(&ds) * b - ds.dot(&b) * s);
    let mut sum = dc * thrust(s, s, b) + c * (turned + thrust(s, s, db));
    sum += 0.4 * s.dot(&ds) * p;
    sum + 0.2 * s.dot(&s) * dp
}

fn fixed<const N: usize>(values: &[[f64; LANES]], lane: usize) -> [f64; N] {
    std::array::from_fn(|i| values.get(i).map_or(0.0, |lanes| lanes[lane]))
}

/// The interpolated vector.
fn at(weights: [f64; 4], q: &[f64], d: usize) -> Vector {
    Vector::from_fn(|c, _| {
        let sum = (0..4).map(|a| weights[a] * q[a * d + c]).sum();
        if c < d { sum } else { 0.0 }
    })
}

pub fn force(lengths: [f64; LANES], values: &[[f64; LANES]], q: &[[f64; LANES]], force: &mut [[f64; LANES]]) {
    let d = q.len() / 4;
    for (lane, l) in lengths.into_iter().enumerate() {
        let q: [f64; 12] = fixed(q, lane);
        for (xi, weight) in RULE {
            let shapes = hermite(l, 0, xi);
            let f = density(at(hermite(l, 1, xi), &q, d), at(shapes, &q, d), fixed(values, lane));
            for (i, force) in force.iter_mut().enumerate() {
                force[lane] += l * weight * shapes[i / d] * f[i % d];
            }
        }
    }
}

pub fn tangent(
    lengths: [f64; LANES],
    values: &[[f64; LANES]],
    q: &[[f64; LANES]],
    by_q: &mut [[f64; LANES]],
    by_values: &mut [[f64; LANES]],
) {
    let (n, d) = (q.len(), q.len() / 4);
    for (lane, l) in lengths.into_iter().enumerate() {
        let q: [f64; 12] = fixed(q, lane);
        let values: [f64; 4] = fixed(values, lane);
        for (xi, weight) in RULE {
            let (shapes, slopes) = (hermite(l, 0, xi), hermite(l, 1, xi));
            let place = [at(slopes, &q, d), at(shapes, &q, d)];
            let add = |to: &mut [[f64; LANES]], width: usize, column: usize, change: Vector| {
                for row in 0..n {
                    to[row * width + column][lane] += l * weight * shapes[row / d] * change[row % d];
                }
            };
            for column in 0..n {
                let unit = |weights: [f64; 4]| -> Vector {
                    Vector::from_fn(|c, _| if c == column % d { weights[column / d] } else { 0.0 })
                };
                let by = [unit(slopes), unit(shapes)];
                add(by_q, n, column, change(place, values, by, [0.0; 4]));
            }
            for column in 0..4 {
                let mut by = [0.0; 4];
                by[column] = 1.0;
                add(by_values, 4, column, change(place, values, [Vector::zeros(); 2], by));
            }
        }
    }
}

/// `-c_0 d / |d|^3` with `d = z_0 - z_1`.
pub fn field(constants: Vector, z: &[Vector]) -> Vector {
    let d = z[0] - z[1];
    -constants[0] / d.norm().powi(3) * d
}

pub fn field_gradient(constants: Vector, z: &[Vector], gradient: &mut [f64]) {
    let d = z[0] - z[1];
    let (r, width) = (d.norm(), 3 * z.len());
    for i in 0..3 {
        for j in 0..3 {
            let unit = if i == j { 1.0 } else { 0.0 };
            let value = -constants[0] * (unit / r.powi(3) - 3.0 * d[i] * d[j] / r.powi(5));
            gradient[i * width + j] += value;
            gradient[i * width + 3 + j] -= value;
        }
    }
}

fn spec(name: &'static str, kind: usize, body: usize, markers: &'static [usize]) -> DensitySpec {
    DensitySpec {
        name,
        kind,
        body,
        markers,
        values: 4,
    }
}

fn pulled(name: &'static str, frame: usize, markers: &'static [usize]) -> (LoadSpec, Vector) {
    let kind = LoadKind::Field { markers };
    (LoadSpec { name, kind, frame }, Vector::new(1.7, 0.0, 0.0))
}

/// Everything with densities that depend on their own frame, on other free and prescribed frames and on places of
/// bodies, and with fields.
fn loaded() -> Hand {
    let mut hand = everything();
    hand.densities = vec![
        spec("wind", 0, 0, &[0, 1]),
        spec("draught", 1, 1, &[4, 3]),
        spec("stream", 0, 2, &[10, 14]),
        spec("wake", 2, 2, &[2, 1]),
    ];
    // Frame 6 carries a body alone, frame 3 and 4 a rigid part each, the first one also a body.
    hand.markers.push(MarkerSpec::Point {
        frame: 6,
        at: [0.3, -0.1, 0.0],
    });
    hand.markers.push(MarkerSpec::Direction {
        frame: 4,
        along: [0.0, 1.3, 0.4],
    });
    hand.loads.push(pulled("star", 3, &[0, 10]));
    hand.loads.push(pulled("planet", 6, &[15, 10]));
    hand.loads.push(pulled("moon", 4, &[16, 10]));
    hand
}

#[test]
fn derivatives_of_densities_and_fields() {
    check(loaded(), Formulation::Rncf, 11);
    check(loaded(), Formulation::Rncf, 12);
}

/// In absolute coordinates the components of a density are along the axes of a prescribed frame, which turns.
#[test]
fn densities_in_prescribed_frames_are_the_same_in_absolute_coordinates() {
    let hand = || {
        let mut hand = everything();
        hand.densities = vec![spec("stream", 0, 2, &[10, 14]), spec("wake", 1, 2, &[2, 1])];
        hand
    };
    check(hand(), Formulation::Ancf, 13);
    let loads = |density: bool, formulation: Formulation| {
        let mut hand = hand();
        if !density {
            hand.densities.clear();
        }
        // Only the blade: its vectors are the same in both formulations but for the axes.
        let mut scene = MeshScene::new(Box::new(hand), formulation, Joints::Eliminated, &[]).unwrap();
        let state = scene.rest(0.3);
        scene.load_state(&state);
        scene.full_force(0.3, 1.0);
        let body = &scene.bodies[2];
        let turn = scene.buffers.frames[2].rotation;
        let force = body
            .connectivity
            .components
            .iter()
            .map(|&place| scene.buffers.force[place]);
        let force: Vec<f64> = force.collect();
        let axes = |vector: &[f64]| -> [f64; 3] {
            let vector = three(vector, 0);
            if formulation == Formulation::Rncf {
                (turn * vector).into()
            } else {
                vector.into()
            }
        };
        force.chunks_exact(3).flat_map(axes).collect::<Vec<f64>>()
    };
    let of = |formulation: Formulation| -> Vec<f64> {
        let (with, without) = (loads(true, formulation), loads(false, formulation));
        with.iter().zip(without).map(|(a, b)| a - b).collect()
    };
    let (referenced, absolute) = (of(Formulation::Rncf), of(Formulation::Ancf));
    let size = referenced.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    assert!(size > 0.01, "{size}");
    for (a, b) in referenced.iter().zip(absolute) {
        assert!((a - b).abs() < 1e-12 * size, "{a} {b}");
    }
}

/// The work of the generalised forces in any motion is that of the load on all particles:
/// `v_x . Q_x = int f . (A^T dP/dt) dx`.
#[test]
fn power_of_a_density_is_that_on_its_particles() {
    let residual = |hand: Hand, state: Option<&State>, seed: u64| {
        let mut scene = hand.scene(Formulation::Rncf);
        let mut own = scene.rest(0.3);
        Random(seed).shake(&scene, &mut own, 0.2);
        let state = state.unwrap_or(&own).clone();
        let mut out = vec![0.0; scene.unknowns()];
        scene.residual(&state, &mut out);
        (scene, state, out)
    };
    let with = {
        let mut hand = everything();
        hand.densities = vec![spec("wind", 0, 0, &[0, 1])];
        hand
    };
    let (mut scene, state, loaded) = residual(with, None, 21);
    let (_, _, bare) = residual(everything(), Some(&state), 21);
    let generalised = loaded.iter().zip(&bare).zip(&state.v);
    let power: f64 = generalised.map(|((with, without), v)| -(with - without) * v).sum();
    // What is prescribed does work, too: the clamped start stays at rest in its frame, so that none is missing.
    scene.load_state(&state);
    let z: Vec<Vector> = [0, 1].iter().map(|&m| scene.jet(&scene.links.markers[m])[0]).collect();
    let values = values(0.3, &z);
    let frame = scene.buffers.frames[3];
    let velocity = frame.direction_to_frame(frame.velocity);
    let mut expected = 0.0;
    for element in 0..2 {
        let components = scene.bodies[0].connectivity.element(element);
        let [q, v] = [&scene.buffers.q, &scene.buffers.v]
            .map(|full| -> Vec<f64> { components.iter().map(|&place| full[place]).collect() });
        let l = Vector::new(0.9, 0.3, 0.0).norm() / 2.0;
        for (xi, weight) in RULE {
            let shapes = hermite(l, 0, xi);
            let (p, rate) = (at(shapes, &q, 3), at(shapes, &v, 3));
            let f = density(at(hermite(l, 1, xi), &q, 3), p, values);
            let moves = velocity + rate + frame.spin.cross(&p);
            expected += l * weight * f.dot(&moves);
        }
    }
    assert!(
        (power - expected).abs() < 1e-12 * expected.abs().max(1.0),
        "{power} {expected}"
    );
    assert!(expected.abs() > 0.01);
}

/// On a rigid body that shifts only, the field is the whole load: `m (r'' + mu r / |r|^3)`.
#[test]
fn a_field_is_the_closed_form() {
    let mut hand = everything();
    hand.bodies.clear();
    hand.joints.clear();
    hand.constraints.clear();
    hand.forces.clear();
    hand.fixtures.clear();
    let mut stone = free(1, 0, crate::emitted::Motions::Spatial);
    stone.rigid.mass = 2.5;
    let start = Vector::new(1.2, -0.5, 0.8);
    stone.position = start;
    let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    stone.rigid.inertia = Matrix::from_fn(unit);
    hand.frames = vec!["inertial", "stone"];
    hand.moving = false;
    hand.free = vec![stone];
    hand.markers = [1, 0].map(|frame| MarkerSpec::Point { frame, at: [0.0; 3] }).to_vec();
    hand.loads = vec![pulled("star", 1, &[0, 1])];
    check(hand.clone(), Formulation::Rncf, 31);
    let mut scene = hand.scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    state.a[..3].copy_from_slice(&[0.3, 0.1, -0.2]);
    let mut out = vec![0.0; 6];
    scene.residual(&state, &mut out);
    // Unknowns are displacements from the start.
    let r = start + three(&state.x, 0);
    for i in 0..3 {
        let expected = 2.5 * (state.a[i] + 1.7 * r[i] / r.norm().powi(3));
        assert!((out[i] - expected).abs() < 1e-14, "{} {expected}", out[i]);
        assert!(out[3 + i].abs() < 1e-14);
    }
}

#[test]
fn refusals_name_the_load() {
    let refused = |hand: Hand, formulation| {
        MeshScene::new(Box::new(hand), formulation, Joints::Eliminated, &[])
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    };
    let mut hand = everything();
    hand.densities = vec![spec("wind", 0, 0, &[0, 1])];
    let text = refused(hand.clone(), Formulation::Ancf);
    assert!(text.contains("`wind`") && text.contains("`ship`"), "{text}");
    hand.bodies[0].fidelity = crate::emitted::Fidelity::Rigid;
    let text = refused(hand, Formulation::Rncf);
    assert!(text.contains("`wind`") && text.contains("`mast`"), "{text}");
    let mut hand = everything();
    hand.loads.push(pulled("star", 3, &[0, 10]));
    let text = refused(hand, Formulation::Ancf);
    assert!(text.contains("`star`") && text.contains("`ship`"), "{text}");
    let mut hand = everything();
    hand.densities = vec![spec("wind", 0, usize::MAX, &[0, 1])];
    assert!(refused(hand, Formulation::Rncf).contains("`wind`"));
}

/// Lanes that are filled up, and many batches: three bodies of one kind with five elements each.
#[test]
fn batches_reach_over_bodies() {
    let scene = |bodies: &[usize]| {
        let mut hand = everything();
        hand.bodies = (0..3)
            .map(|_| body("mast", 3, &[0, 1, 2], Vector::new(0.9, 0.3, 0.0)))
            .collect();
        hand.bodies.iter_mut().for_each(|body| body.count = 5);
        hand.joints = (0..3)
            .map(|index| super::scenery::joint("step", crate::emitted::JointKind::Clamp, index, false, 3))
            .collect();
        hand.constraints.clear();
        hand.forces.clear();
        hand.fixtures.clear();
        hand.loads.clear();
        hand.markers.truncate(2);
        hand.densities = bodies.iter().map(|&body| spec("wind", 0, body, &[0, 1])).collect();
        hand.scene(Formulation::Rncf)
    };
    let residual = |scene: &mut MeshScene| {
        let mut state = scene.rest(0.3);
        Random(41).shake(scene, &mut state, 0.2);
        let mut out = vec![0.0; scene.unknowns()];
        scene.residual(&state, &mut out);
        out
    };
    let bare = residual(&mut scene(&[]));
    let all = residual(&mut scene(&[0, 1, 2]));
    let mut sum = bare.clone();
    for body in 0..3 {
        let one = residual(&mut scene(&[body]));
        sum.iter_mut()
            .zip(one.iter().zip(&bare))
            .for_each(|(sum, (one, bare))| *sum += one - bare);
    }
    let load = all.iter().zip(&bare).map(|(all, bare)| (all - bare).abs());
    assert!(load.fold(0.0, f64::max) > 0.01);
    for (all, sum) in all.iter().zip(&sum) {
        assert!((all - sum).abs() < 1e-12 * (1.0 + all.abs()), "{all} {sum}");
    }
}
