//! Inertia of nodal vectors against loops over elements and over particles of fixtures and rigid parts, the matrix of the iteration against its
//! parts, and the same bits on any number of threads.

use super::differences::dense;
use super::inertia::{Inertia, rigid};
use super::model::Hand;
use super::net::Net;
use super::random::Random;
use super::scenery::{along_slope, body, everything, free};
use super::sections::everything_with_sections;
use crate::emitted::{FixtureSpec, LoadKind, Motions, RigidSpec};
use crate::modal::action::FrameAction;
use crate::model::{Formulation, Joints, Scene};
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::Transport;
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::space::{Vector, inverse_tangent_map, three};
use crate::system::{State, System, Tangent};

fn shaken(scene: &mut MeshScene, seed: u64) -> State {
    let mut state = scene.rest(0.3);
    Random(seed).shake(scene, &mut state, 0.2);
    state
}

/// Adds the inertia of one local mass matrix on the components of an element, and on its frame.
fn add_local(scene: &mut MeshScene, index: usize, element: usize, mass: &[f64], gravity: [f64; 3]) {
    let body = &scene.bodies[index];
    let counts: Vec<f64> = body
        .spec
        .nodal
        .iter()
        .map(|vector| f64::from(u8::from(vector.is_position())))
        .collect();
    let dimension = body.spec.dimension();
    let inertia = Inertia {
        mass,
        counts: &counts,
        dimension,
    };
    let action = scene.buffers.frames[body.frame].action(body.spec.axes, gravity.into());
    let components = body.connectivity.element(element).to_vec();
    let [q, v, a] = [&scene.buffers.q, &scene.buffers.v, &scene.buffers.a].map(|full| {
        components
            .iter()
            .map(|&component| full[component])
            .collect::<Vec<f64>>()
    });
    let mut force = vec![0.0; components.len()];
    inertia.force(&action, &q, &v, &a, &mut force);
    let (axes, free) = (body.spec.axes, scene.frames.free_of[body.frame]);
    for (&component, value) in components.iter().zip(force) {
        scene.buffers.force[component] += value;
    }
    if let Some(free) = free {
        let mut rows = [0.0; 6];
        let rows = &mut rows[..if dimension == 2 { 3 } else { 6 }];
        inertia.carried(&action, &q, &v, &a, rows);
        scene.add_to_frame(free, axes, rows);
    }
}

/// Particles of a fixture: mass, and place X, Y, Z along slope and section axes.
const PARTICLES: [(f64, Vector); 3] = [
    (0.3, Vector::new(0.2, -0.1, 0.3)),
    (0.5, Vector::new(-0.1, 0.25, 0.1)),
    (0.2, Vector::new(0.3, 0.1, -0.2)),
];

/// What a fixture knows of them (THEORY 5.4); `count` of the places are there.
fn constants(count: usize) -> [f64; 10] {
    PARTICLES.iter().fold([0.0; 10], |sum, (mass, place)| {
        let mut place = *place;
        place.as_mut_slice()[count..].fill(0.0);
        let [x, y, z]: [f64; 3] = place.into();
        let own = [1.0, x, y, z, x * x, y * y, z * z, x * y, x * z, y * z];
        std::array::from_fn(|i| sum[i] + mass * own[i])
    })
}

/// Masses of the particles of a fixture, and weights of an element's vectors in their places.
fn particles(point: &MeshPoint) -> Vec<(f64, Vec<f64>)> {
    let along = [PlaceVector::Slope, PlaceVector::SectionY, PlaceVector::SectionZ];
    let weights = |place: &Vector| {
        let mut weights = point.weights(PlaceVector::Position).to_vec();
        for (&of, distance) in along.iter().zip(place) {
            let part = weights.iter_mut().zip(point.weights(of));
            part.for_each(|(sum, weight)| *sum += distance * weight);
        }
        weights
    };
    PARTICLES.iter().map(|(mass, place)| (*mass, weights(place))).collect()
}

/// The inertia forces of all elements, fixtures and rigid parts, one after the other.
fn by_loops(scene: &mut MeshScene, gravity: [f64; 3]) -> Vec<f64> {
    scene.buffers.force.fill(0.0);
    for index in 0..scene.bodies.len() {
        let mass = scene.bodies[index].mass.clone();
        for element in 0..scene.bodies[index].spec.count {
            add_local(scene, index, element, &mass, gravity);
        }
    }
    for index in 0..scene.fixtures.len() {
        let point = &scene.fixtures[index].point;
        let (body, element) = (point.body, point.element);
        for (mass, weights) in particles(point) {
            let products = weights.iter().flat_map(|a| weights.iter().map(move |b| mass * a * b));
            let products: Vec<f64> = products.collect();
            add_local(scene, body, element, &products, gravity);
        }
    }
    for free in 0..scene.frames.free.len() {
        let spec = scene.frames.free[free].spec.clone();
        let action = scene.buffers.frames[spec.frame].action(&[0, 1, 2], gravity.into());
        let mut rows = [0.0; 6];
        rigid(&spec.rigid, &action, &mut rows);
        scene.add_to_frame(free, &[0, 1, 2], &rows);
    }
    scene.buffers.force.clone()
}

fn check_forces(mut hand: Hand, formulation: Formulation, seed: u64) {
    for fixture in &mut hand.fixtures {
        let body = &hand.bodies[fixture.body];
        // Of the slope, and of the axes where there are any.
        let axes = if body.has_section() { body.dimension() } else { 1 };
        fixture.constants = constants(axes);
    }
    let mut scene = hand.scene(formulation);
    let state = shaken(&mut scene, seed);
    scene.load_state(&state);
    let gravity = [0.3, -0.8, 2.1];
    let expected = by_loops(&mut scene, gravity);
    scene.buffers.force.fill(0.0);
    scene.add_inertia_forces(gravity.into());
    let size = expected.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    assert!(size > 1.0);
    for (component, (found, expected)) in scene.buffers.force.iter().zip(&expected).enumerate() {
        assert!(
            (found - expected).abs() < 1e-13 * size,
            "component {component}: {found} instead of {expected}"
        );
    }
}

#[test]
fn inertia_forces_are_those_of_elements_fixtures_and_rigid_parts() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        check_forces(everything(), formulation, 31);
        check_forces(everything_with_sections(), formulation, 32);
    }
}

/// Rigid parts weigh and turn as the particles that they are made of.
#[test]
fn rigid_parts_are_sums_over_particles() {
    let mut random = Random(8);
    let mut vector = || -> Vector { Vector::from_fn(|_, _| random.number()) };
    let action = FrameAction {
        acceleration: vector(),
        spin: vector(),
        spin_rate: vector(),
    };
    let mut rigid = RigidSpec::default();
    let mut expected = [0.0; 6];
    for (mass, p) in [1.0, 2.0, 0.5, 0.7].map(|mass| (mass, vector())) {
        let particle = Inertia {
            mass: &[mass],
            counts: &[1.0],
            dimension: 3,
        };
        particle.carried(&action, p.as_slice(), &[0.0; 3], &[0.0; 3], &mut expected);
        rigid.mass += mass;
        rigid.moment += mass * p;
        for i in 0..3 {
            for j in 0..3 {
                let square = if i == j { p.dot(&p) } else { 0.0 };
                rigid.inertia[(i, j)] += mass * (square - p[i] * p[j]);
            }
        }
    }
    let transport = Transport {
        e: action.acceleration,
        spin: action.spin,
        spin_rate: action.spin_rate,
    };
    let found = transport.of_rigid(&rigid).map(<[f64; 3]>::from).concat();
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} instead of {expected}");
    }
}

fn check_matrix(hand: Hand, formulation: Formulation, seed: u64, factors: [f64; 3]) {
    let mut scene = hand.scene(formulation);
    let mut state = shaken(&mut scene, seed);
    // Away from the beginning of the charts.
    let mut random = Random(seed + 1);
    for &turn in scene.turns() {
        state.x[turn..turn + 3].fill_with(|| 0.4 * random.number());
    }
    let mut tangent = Tangent::default();
    scene.tangent(&state, &mut tangent);
    let mut values = vec![f64::NAN; scene.pattern().entries()];
    scene.iteration_matrix(&state, factors, &mut values);
    let found = dense(scene.pattern(), &values);
    let [mass, damping, stiffness] =
        [&tangent.mass, &tangent.damping, &tangent.stiffness].map(|values| dense(scene.pattern(), values));
    let size = found
        .iter()
        .flatten()
        .fold(0.0, |size: f64, value| size.max(value.abs()));
    let n = scene.unknowns();
    for i in 0..n {
        for j in 0..n {
            let moving = |j: usize| factors[0] * mass[i][j] + factors[1] * damping[i][j];
            let turn = scene.turns().iter().find(|&&first| (first..first + 3).contains(&j));
            let rates = turn.map_or(moving(j), |&first| {
                let map = inverse_tangent_map(Vector::new(state.x[first], state.x[first + 1], state.x[first + 2]));
                (0..3).map(|l| moving(first + l) * map[(l, j - first)]).sum()
            });
            let expected = rates + factors[2] * stiffness[i][j];
            assert!(
                (found[i][j] - expected).abs() < 1e-13 * size,
                "({i}, {j}): {} instead of {expected}; {} by {}",
                found[i][j],
                scene.describe_unknown(i),
                scene.describe_unknown(j),
            );
        }
    }
}

#[test]
fn the_matrix_of_the_iteration_combines_mass_damping_and_stiffness() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        check_matrix(everything(), formulation, 41, [0.9, 0.03, 0.2]);
        check_matrix(everything_with_sections(), formulation, 43, [0.9, 0.03, 1e-4]);
        // Without stiffness, and without anything but it.
        check_matrix(everything(), formulation, 45, [1.0, 0.5, 0.0]);
        check_matrix(everything(), formulation, 46, [0.0, 0.0, 1.0]);
    }
}

/// A planar body in a frame that shifts in space weighs along the normal of its plane, too.
#[test]
fn planar_bodies_have_mass_normal_to_their_plane() {
    let mut hand = Hand {
        frames: vec!["inertial", "sledge"],
        bodies: vec![body("whip", 1, &[0, 1], Vector::new(0.6, 0.8, 0.0))],
        free: vec![free(1, 0, Motions::Shifting)],
        fixtures: vec![FixtureSpec {
            name: "ball",
            body: 0,
            at: super::scenery::DEAD,
            constants: along_slope(0.4, 0.0, 0.0),
            elastic: false,
        }],
        ..Hand::default()
    };
    let gravity = crate::emitted::LoadSpec {
        name: "gravity",
        kind: LoadKind::Gravity,
        frame: 0,
    };
    hand.loads.push((gravity, Vector::new(0.1, 0.2, -3.0)));
    let mut scene = hand.scene(Formulation::Rncf);
    let mut state = scene.rest(0.0);
    let normal = scene.unknowns() - 1;
    state.a[normal] = 0.5;
    let mut out = vec![0.0; scene.unknowns()];
    scene.residual(&state, &mut out);
    // 0.7 kg/m along 1 m, and the ball.
    assert!((out[normal] - 1.1 * 3.5).abs() < 1e-13, "{}", out[normal]);
    let mut mass = vec![0.0; scene.pattern().entries()];
    scene.mass(&state, &mut mass);
    let entry = scene.pattern().find(normal, normal).expect("the diagonal is there");
    assert!((mass[entry] - 1.1).abs() < 1e-14);
}

/// Force and moment on the frame do not change by elastic forces, which have none (THEORY 2).
#[test]
fn elastic_forces_do_not_move_the_frame() {
    let mut scene = Net::new(4, 5).scene();
    let state = shaken(&mut scene, 5);
    scene.load_state(&state);
    scene.full_force(0.0, 1.0);
    let force = |scene: &MeshScene, first: usize, vector: usize| three(&scene.buffers.force, first + 3 * vector);
    let motion = &scene.buffers.frames[1];
    let mut sums = Transport::new(motion, &[0, 1, 2], Vector::zeros()).of_rigid(&scene.frames.free[0].spec.rigid);
    for body in &scene.bodies {
        let first = scene.layout.offset(body.first_vector);
        for vector in 0..body.spec.vectors() {
            let (own, q) = (force(&scene, first, vector), first + 3 * vector);
            let q = three(&scene.buffers.q, q);
            if vector % 2 == 0 {
                sums[0] += own;
            }
            sums[1] += q.cross(&own);
        }
    }
    let first = scene.layout.vector_components();
    for (place, direction) in scene.frames.free[0].directions.iter().enumerate() {
        let expected = direction.shift.dot(&motion.direction_to_inertial(sums[0])) + direction.turn.dot(&sums[1]);
        let found = scene.buffers.force[first + place];
        assert!(
            (found - expected).abs() < 1e-10,
            "{place}: {found} instead of {expected}"
        );
    }
}

#[test]
fn bits_do_not_depend_on_the_number_of_threads() {
    // So many that they are shared out; the last units of four have lanes to spare.
    let net = || Net::new(75, 13);
    let mut runs = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads start");
        pool.install(|| {
            let mut scene =
                MeshScene::new(Box::new(net()), Formulation::Rncf, Joints::Eliminated, &[]).expect("it is right");
            let state = shaken(&mut scene, 9);
            let mut force = vec![0.0; scene.unknowns()];
            scene.residual(&state, &mut force);
            let mut matrix = vec![0.0; scene.pattern().entries()];
            scene.iteration_matrix(&state, [0.8, 0.01, 1e-3], &mut matrix);
            let mut tangent = Tangent::default();
            scene.tangent(&state, &mut tangent);
            [force, matrix, tangent.stiffness, tangent.damping]
                .map(|values| values.into_iter().map(f64::to_bits).collect::<Vec<u64>>())
        })
    });
    let first = runs[0].clone();
    assert!(runs[1..].iter_mut().all(|run| *run == first));
}
