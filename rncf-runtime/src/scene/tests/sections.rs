//! Bodies with sections, by hand: interpolants of THEORY 5.2, simple strains between all vectors.

use super::law::Law;
use super::model::{EVERY, Hand, PAIRS, Quadratic, hermite, table};
use super::scenery::{DEAD, body, everything, free, hold, joint};
use crate::emitted::{
    Bodies, BodySpec, ConstraintSpec, FixtureSpec, ForceSpec, FrameTie, Interpolant, JointKind, Line, LoadKind,
    LoadSpec, MarkerSpec, Motions, NodalSpec, ObservedSpec, Place, SectionQuantity, Twist, When,
};
use crate::model::{Formulation, Joints, Scene};
use crate::scene::MeshScene;
use crate::scene::numbering::layout::{Layout, VectorKind};
use crate::scene::pieces::marker::Marker;
use crate::scene::read::section::Reader;
use crate::space::{Vector, three};
use crate::system::{ConstraintLevel, System};

/// Second moment of mass of the sections over their mass, m^2.
const GYRATION: f64 = 0.02;

const fn vector(meaning: &'static str, of: Interpolant, order: usize, xi: f64) -> NodalSpec {
    NodalSpec { meaning, of, order, xi }
}

/// The ten vectors of an element in space.
const SPACE: [NodalSpec; 10] = [
    vector("position", Interpolant::Position, 0, 0.0),
    vector("slope", Interpolant::Position, 1, 0.0),
    vector("section y axis", Interpolant::SectionY, 0, 0.0),
    vector("section z axis", Interpolant::SectionZ, 0, 0.0),
    vector("section y axis", Interpolant::SectionY, 0, 0.5),
    vector("section z axis", Interpolant::SectionZ, 0, 0.5),
    vector("position", Interpolant::Position, 0, 1.0),
    vector("slope", Interpolant::Position, 1, 1.0),
    vector("section y axis", Interpolant::SectionY, 0, 1.0),
    vector("section z axis", Interpolant::SectionZ, 0, 1.0),
];

/// The seven vectors of an element in a plane.
const PLANE: [NodalSpec; 7] = [SPACE[0], SPACE[1], SPACE[2], SPACE[4], SPACE[6], SPACE[7], SPACE[8]];

/// Weights of an element of length l.
pub fn shapes(nodal: &[NodalSpec], l: f64, of: Interpolant, order: usize, xi: f64, weights: &mut [f64]) {
    let along = hermite(l, order, xi);
    for (weight, vector) in weights.iter_mut().zip(nodal).filter(|(_, vector)| vector.of == of) {
        *weight = match (of, order) {
            (Interpolant::Position, _) => along[if vector.xi > 0.5 { 2 } else { 0 } + vector.order],
            (_, 0) => match vector.xi {
                0.0 => 1.0 - 3.0 * xi + 2.0 * xi * xi,
                0.5 => 4.0 * xi * (1.0 - xi),
                _ => xi * (2.0 * xi - 1.0),
            },
            (_, 1) => match vector.xi {
                0.0 => (4.0 * xi - 3.0) / l,
                0.5 => (4.0 - 8.0 * xi) / l,
                _ => (4.0 * xi - 1.0) / l,
            },
            _ => 0.0,
        };
    }
}

/// Mass matrix of an element of the mass `mass`, by four Gauss points, the parts of the vectors apart.
pub fn masses(hand: &Hand, body: usize, mass: f64) -> Vec<f64> {
    const POINTS: [(f64, f64); 4] = [
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ];
    let nodal = hand.bodies[body].nodal;
    let n = nodal.len();
    let mut result = vec![0.0; n * n];
    let kinds = [
        (Interpolant::Position, 1.0),
        (Interpolant::SectionY, GYRATION),
        (Interpolant::SectionZ, 0.5 * GYRATION),
    ];
    for (of, factor) in kinds {
        for (xi, weight) in POINTS {
            let mut s = vec![0.0; n];
            shapes(nodal, hand.lengths[body], of, 0, xi, &mut s);
            for (place, sum) in result.iter_mut().enumerate() {
                *sum += mass * factor * weight * s[place / n] * s[place % n];
            }
        }
    }
    result
}

/// Strains between all vectors: the stretch, products of neighbours, squares of directions.
pub fn strains(nodal: &[NodalSpec], l: f64) -> Vec<(f64, Vec<Vec<f64>>, f64)> {
    let n = nodal.len();
    let sign = |i: usize| match (nodal[i].is_position(), nodal[i].xi > 0.5) {
        (false, _) => 0.0,
        (true, true) => 1.0,
        (true, false) => -1.0,
    };
    let is_direction = |i: usize| !nodal[i].is_position();
    let next = |i: usize, j: usize| i.abs_diff(j) <= 2 && i != j && is_direction(i) && is_direction(j);
    vec![
        (3.0, table(n, &|i, j| sign(i) * sign(j)), l * l),
        (0.4, table(n, &|i, j| if next(i, j) { 0.3 } else { 0.0 }), 0.2),
        (
            1.5,
            table(n, &|i, j| if i == j && is_direction(i) { 1.0 } else { 0.0 }),
            2.0,
        ),
    ]
}

/// Forces on r_y and r_z of a moment M: with n = r_y x r_z, `-(M.c) n/D + (M.n) c/2D` and
/// `(M.b) n/D - (M.n) b/2D`.
pub fn moment(axes: &[f64; 6], moment: Vector) -> [f64; 6] {
    let [b, c] = [three(axes, 0), three(axes, 3)];
    let n = b.cross(&c);
    let d = n.dot(&n);
    let twist = 0.5 * moment.dot(&n) / d;
    let first = -moment.dot(&c) / d * n + twist * c;
    let second = moment.dot(&b) / d * n - twist * b;
    std::array::from_fn(|i| if i < 3 { first[i] } else { second[i - 3] })
}

/// A body of two elements with sections.
fn beam(name: &'static str, frame: usize, axes: &'static [usize], to: Vector) -> BodySpec {
    let line = body(name, frame, axes, to);
    if axes.len() == 2 {
        BodySpec {
            nodal: &PLANE,
            connectivity: &[0, 1, 2, 3, 4, 5, 6],
            vectors_per_node: 3,
            stride: 4,
            ..line
        }
    } else {
        BodySpec {
            nodal: &SPACE,
            connectivity: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
            vectors_per_node: 4,
            stride: 6,
            section_y: Some([0.1, 0.2, 1.0]),
            twist: Twist::even(0.4),
            ..line
        }
    }
}

fn hold_section(of: Interpolant, axis: usize) -> JointKind {
    JointKind::Hold { of, order: 0, axis }
}

/// Everything, and bodies with sections in free and prescribed frames with what acts on sections.
pub fn everything_with_sections() -> Hand {
    let mut hand = everything();
    hand.bodies.extend([
        beam("shaft", 3, &[0, 1, 2], Vector::new(0.2, -0.6, 0.5)),
        beam("strip", 6, &[0, 1], Vector::new(-0.5, 0.3, 0.0)),
        beam("stalk", 2, &[0, 1, 2], Vector::new(0.3, 0.1, 0.7)),
    ]);
    let [shaft, strip, stalk] = [3, 4, 5];
    hand.joints.extend([
        joint("collar", JointKind::Clamp, shaft, false, 3),
        joint("vice", JointKind::ClampFull, strip, false, 6),
        joint("guide", hold_section(Interpolant::SectionY, 0), strip, true, 6),
        joint("foot", JointKind::Pin, stalk, false, 0),
        joint("key", hold_section(Interpolant::SectionZ, 1), stalk, true, 2),
        joint("ring", hold(1, 2), stalk, true, 2),
    ]);
    let mut load = |name, body, at, frame, value: Vector| {
        let kind = LoadKind::Moment { body, at };
        hand.loads.push((LoadSpec { name, kind, frame }, value));
    };
    load("torque", shaft, DEAD, 0, Vector::new(0.3, -0.5, 0.8));
    load("bend", strip, Place::End, 0, Vector::new(0.3, -0.5, 0.8));
    load("turn", stalk, DEAD, 1, Vector::new(0.7, 0.2, -0.4));
    load("screw", stalk, Place::End, 4, Vector::new(-0.2, 0.6, 0.5));
    let fixture = |name, body, at| FixtureSpec {
        name,
        body,
        at,
        constants: [0.4, 0.1, -0.05, 0.07, 0.05, 0.04, 0.03, 0.01, -0.02, 0.015],
        elastic: true,
    };
    hand.fixtures.extend([
        fixture("disc", shaft, Place::End),
        fixture("plate", strip, DEAD),
        fixture("wheel", stalk, DEAD),
    ]);
    let first = hand.markers.len();
    let section = |body, at, axis| MarkerSpec::BodySection { body, at, axis };
    hand.markers.extend([
        section(shaft, DEAD, 1),
        section(stalk, Place::End, 2),
        section(strip, Place::End, 1),
        MarkerSpec::InSection {
            body: shaft,
            at: DEAD,
            marker: 1,
        },
        MarkerSpec::SectionTurn { body: shaft, at: DEAD },
    ]);
    assert_eq!(first, 15);
    let key = ConstraintSpec {
        name: "spline",
        kind: "constraint",
        rows: &["square", "flush"],
        markers: &[15, 16, 17, 18],
        coupled: &EVERY[..PAIRS[4]],
        of_differences: false,
        first_party: 1,
        branches: 0,
        when: When::Always,
    };
    let product = |products| Quadratic {
        products,
        sine: 0.1,
        ..Quadratic::default()
    };
    let rows = vec![
        product(vec![(0, 1, 0.7), (0, 3, 0.4)]),
        product(vec![(1, 2, 1.0), (2, 2, 0.3)]),
    ];
    hand.constraints.push((key, rows));
    let wind = ForceSpec {
        name: "wind",
        markers: &[17, 16],
        conservative: false,
        of_differences: false,
        branches: 0,
    };
    hand.forces.push((wind, Law::Along(0.8)));
    let turning = |name, markers| ForceSpec {
        name,
        markers,
        conservative: false,
        of_differences: false,
        branches: 0,
    };
    hand.forces.push((turning("spanner", &[19, 18]), Law::Along(0.6)));
    hand.forces.push((turning("brake", &[19]), Law::Drag(0.3)));
    hand
}

/// The scene of one body in the inertial frame, with its joints.
fn alone(body: BodySpec, kinds: &[JointKind], joints: Joints) -> Result<MeshScene, crate::ModelError> {
    let hand = Hand {
        frames: vec!["inertial"],
        joints: kinds.iter().map(|&kind| joint("end", kind, 0, true, 0)).collect(),
        bodies: vec![body],
        markers: vec![
            MarkerSpec::BodySection {
                body: 0,
                at: DEAD,
                axis: 2,
            },
            MarkerSpec::Direction {
                frame: 0,
                along: [0.3, -2.0, 0.7],
            },
            MarkerSpec::InSection {
                body: 0,
                at: Place::End,
                marker: 1,
            },
        ],
        ..Hand::default()
    };
    MeshScene::new(Box::new(hand), Formulation::Rncf, joints, &[])
}

#[test]
fn joints_hold_the_axes_of_sections() {
    let space = || beam("shaft", 0, &[0, 1, 2], Vector::new(0.2, -0.6, 0.5));
    let plane = || beam("strip", 0, &[0, 1], Vector::new(0.2, -0.6, 0.0));
    let cases: [(BodySpec, JointKind, usize, usize, &str); 5] = [
        (space(), JointKind::Clamp, 6, 6, "twist of the section"),
        (space(), JointKind::ClampFull, 9, 9, "section z axis"),
        (plane(), JointKind::Clamp, 3, 3, "direction of the section y axis"),
        (plane(), JointKind::ClampFull, 4, 4, "section y axis"),
        (space(), JointKind::Pin, 3, 3, "position"),
    ];
    for (body, kind, eliminated, rows, last) in cases {
        let all = body.vectors() * body.dimension();
        let reduced = alone(body.clone(), &[kind], Joints::Eliminated).unwrap();
        assert_eq!(
            (reduced.unknowns(), reduced.constraints()),
            (all - eliminated, 0),
            "{kind:?}"
        );
        let mut kept = alone(body, &[kind], Joints::Multipliers).unwrap();
        assert_eq!((kept.unknowns(), kept.constraints()), (all, rows), "{kind:?}");
        assert_eq!(kept.describe_constraint(rows - 1), format!("joint `end`, {last}"));
        // The undeformed body is where the joint holds it.
        let mut values = vec![1.0; rows];
        let rest = kept.rest(0.0);
        kept.constraint(ConstraintLevel::Position, &rest, &mut values);
        assert!(values.iter().all(|value| value.abs() < 1e-15), "{kind:?} {values:?}");
    }
}

/// A clamped section keeps three unknowns: two norms and its shear, which both axes share.
#[test]
fn a_clamped_section_strains_and_shears_in_its_plane() {
    let (y, z): (Vector, Vector) = (Vector::new(0.48, 0.6, 0.64), Vector::new(-0.64, 0.0, 0.48));
    let z = 1.0 / z.norm() * z;
    let shear = 0;
    let kinds = vec![
        VectorKind::InPlane { axes: [y, z], shear },
        VectorKind::Free,
        VectorKind::InPlane { axes: [z, y], shear },
    ];
    let layout = Layout::new(&[3; 3], kinds, vec![0, 1, 2], 0);
    assert_eq!(layout.unknowns(), 6);
    assert_eq!(layout.origins(), [(0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 0)]);
    let x = [1.1, 0.2, -3.0, 4.0, 5.0, 0.9];
    let mut full = [7.0; 9];
    layout.expand(&x, &mut full);
    let axis = |norm: f64, along: Vector, across: Vector| norm * along + 0.2 * across;
    for (found, wanted) in [(&full[..3], axis(1.1, y, z)), (&full[6..], axis(0.9, z, y))] {
        assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-15));
    }
    let (mut back, mut forces) = ([0.0; 6], [0.0; 6]);
    layout.unknowns_of(&full, &mut back);
    assert!(back.iter().zip(x).all(|(a, b)| (a - b).abs() < 1e-15), "{back:?}");
    // E^T is the transposed of E.
    let force: [f64; 9] = std::array::from_fn(|i| (i as f64 + 1.0).sin());
    layout.project(&force, &mut forces);
    let works = [
        forces.iter().zip(x).map(|(f, x)| f * x).sum::<f64>(),
        force.iter().zip(full).map(|(f, q)| f * q).sum::<f64>(),
    ];
    assert!((works[0] - works[1]).abs() < 1e-14, "{works:?}");
}

#[test]
fn markers_of_sections_are_their_axes() {
    let body = beam("shaft", 0, &[0, 1, 2], Vector::new(0.2, -0.6, 0.5));
    let scene = alone(body.clone(), &[JointKind::Clamp], Joints::Eliminated).unwrap();
    let length = body.line.length();
    // Between nodes quadratic polynomials through the exact directions at 0, 1/2, 1 of an element.
    let xi = 2.0 * 0.37 / length;
    let at = |u: f64| body.section(u)[1];
    let mut wanted = (1.0 - 3.0 * xi + 2.0 * xi * xi) * at(0.0);
    wanted += 4.0 * xi * (1.0 - xi) * at(0.25);
    wanted += xi * (2.0 * xi - 1.0) * at(0.5);
    let found = scene.jet(&scene.links.markers[0])[0];
    assert!((found - wanted).norm() < 1e-15, "{found:?} {wanted:?}");
    // A direction that turns with a section is where it starts.
    let found = scene.jet(&scene.links.markers[2])[0];
    let direction = Vector::new(0.3, -2.0, 0.7);
    let wanted = 1.0 / direction.norm() * direction;
    assert!((found - wanted).norm() < 1e-14, "{found:?} {wanted:?}");
    assert!(!scene.marker_components(&scene.links.markers[2]).is_empty());
}

#[test]
fn a_planar_section_has_components_in_its_plane_and_along_the_normal() {
    let body = beam("strip", 0, &[0, 1], Vector::new(0.3, 0.4, 0.0));
    let scene = alone(body, &[JointKind::Clamp], Joints::Eliminated).unwrap();
    let Marker::Section { along: found, .. } = scene.links.markers[2] else {
        panic!("a direction in a section");
    };
    let direction = Vector::new(0.3, -2.0, 0.7);
    // Along (0.6, 0.8), across (-0.8, 0.6).
    let parts = Vector::new(0.6 * 0.3 - 0.8 * 2.0, -0.8 * 0.3 - 0.6 * 2.0, 0.7);
    assert!((found - 1.0 / direction.norm() * parts).norm() < 1e-15, "{found:?}");
}

fn near(found: [Vector; 2], wanted: [Vector; 2]) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).norm() < 1e-15, "{found:?} instead of {wanted:?}");
    }
}

#[test]
fn sections_turn_with_the_axis() {
    let straight = |to: Vector, section_y, twist| BodySpec {
        section_y,
        twist: Twist::even(twist),
        ..beam("shaft", 0, &[0, 1, 2], to)
    };
    let [x, y, z]: [Vector; 3] = [Vector::x(), Vector::y(), Vector::z()];
    let minus = |u: Vector| -u;
    near(straight(Vector::new(2.0, 0.0, 0.0), None, 0.0).section(0.3), [y, z]);
    near(
        straight(Vector::new(0.0, 3.0, 0.0), None, 0.0).section(1.0),
        [minus(x), z],
    );
    near(
        straight(Vector::new(0.0, 0.0, 0.5), None, 0.0).section(0.5),
        [y, minus(x)],
    );
    // Not normal to the axis as declared; a quarter turn of twist from start to end.
    let twisted = straight(
        Vector::new(2.0, 0.0, 0.0),
        Some([5.0, 0.0, 0.1]),
        std::f64::consts::FRAC_PI_2,
    );
    near(twisted.section(0.0), [z, minus(y)]);
    near(twisted.section(1.0), [minus(y), minus(z)]);
    let half = 0.5f64.sqrt();
    near(
        twisted.section(0.5),
        [Vector::new(0.0, -half, half), Vector::new(0.0, -half, -half)],
    );
    // A quarter circle from x to z turns about -y, which the declared normal leans away from.
    let arc = |section_y, twist| BodySpec {
        line: Line::Arc {
            from: [0.0; 3],
            direction: [3.0, 0.0, 0.0],
            normal: [0.4, -2.0, 0.0],
            radius: 2.0,
            angle: std::f64::consts::FRAC_PI_2,
        },
        ..straight(x, section_y, twist)
    };
    let (point, tangent) = arc(None, 0.0).line.at(1.0);
    near([point, tangent], [Vector::new(2.0, 0.0, 2.0), z]);
    near(arc(None, 0.0).section(1.0), [y, minus(x)]);
    near(arc(Some(z.into()), 0.0).section(1.0), [minus(x), minus(y)]);
    near(arc(None, std::f64::consts::PI).section(1.0), [minus(y), x]);
    // In the plane xy counter-clockwise from the tangent.
    near(
        beam("strip", 0, &[0, 1], Vector::new(0.0, 2.0, 0.0)).section(0.2),
        [minus(x), z],
    );
}

#[test]
fn directions_that_leave_a_section_open_are_refused() {
    let to = [0.0, 0.6, 0.8];
    let with = |section_y| BodySpec {
        section_y: Some(section_y),
        ..beam("shaft", 0, &[0, 1, 2], to.into())
    };
    let bad = [with(to), with([0.0; 3]), with([f64::NAN, 1.0, 0.0])];
    for body in bad {
        let message = alone(body, &[JointKind::Clamp], Joints::Eliminated)
            .err()
            .unwrap()
            .to_string();
        assert!(
            message.contains("`shaft`") && message.contains("`section_y`"),
            "{message}"
        );
    }
    let arc = BodySpec {
        line: Line::Arc {
            from: [0.0; 3],
            direction: to,
            normal: to.map(|component| -2.0 * component),
            radius: 1.0,
            angle: 1.0,
        },
        ..with([1.0, 0.0, 0.0])
    };
    let message = alone(arc, &[], Joints::Eliminated).err().unwrap().to_string();
    assert!(message.contains("`shaft`") && message.contains("normal"), "{message}");
}

#[test]
fn mean_axes_tie_the_turning_of_a_straight_body_with_a_section() {
    let rod = BodySpec {
        tie: FrameTie::MeanAxes,
        section_y: None,
        twist: Twist::even(0.0),
        ..beam("rod", 1, &[0, 1, 2], Vector::new(2.0, 0.0, 0.0))
    };
    let hand = Hand {
        frames: vec!["inertial", "float"],
        free: vec![free(1, 0, Motions::Spatial)],
        bodies: vec![rod.clone()],
        ..Hand::default()
    };
    let mut scene = MeshScene::new(Box::new(hand), Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
    assert_eq!(scene.constraints(), 6);
    let mut state = scene.rest(0.0);
    for within in 0..rod.vectors() {
        let (node, local) = rod.locate(within);
        let spun = Vector::x().cross(&rod.undeformed_vector(node, local));
        let offset = scene.layout.offset(within);
        state.v[offset..offset + 3].copy_from_slice(spun.as_slice());
    }
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(&state, &mut jacobian);
    let mut rates = vec![0.0; 6];
    let pattern = scene.constraint_pattern();
    pattern.transpose_multiply_add(1.0, &jacobian, &state.v, &mut rates);
    // The radius of gyration about the axis, and no other turning or shift.
    let wanted = [0.0, 0.0, 0.0, (1.5 * GYRATION).sqrt(), 0.0, 0.0];
    for (found, wanted) in rates.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-12, "{rates:?}");
    }
}

/// Six elements are read four at a time where no force acts within one of these, and one after the other.
#[test]
fn sections_read_side_by_side_have_the_same_bits() {
    for (axes, to) in [
        (&[0, 1][..], Vector::new(2.0, 0.5, 0.0)),
        (&[0, 1, 2], Vector::new(0.2, -0.6, 0.5)),
    ] {
        let line = body("rope", 0, axes, to);
        let section = beam("shaft", 0, axes, to);
        for body in [line, section] {
            let hand = Hand {
                frames: vec!["inertial"],
                bodies: vec![BodySpec { count: 6, ..body }],
                loads: vec![(
                    LoadSpec {
                        name: "push",
                        frame: 0,
                        kind: LoadKind::Force {
                            body: 0,
                            at: Place::At(0.3),
                        },
                    },
                    Vector::new(1.0, 2.0, 0.0),
                )],
                ..Hand::default()
            };
            let mut scene = MeshScene::new(Box::new(hand), Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
            let mut state = scene.rest(0.0);
            for (values, size) in [(&mut state.x, 0.02), (&mut state.v, 0.5), (&mut state.a, 3.0)] {
                for (place, value) in values.iter_mut().enumerate() {
                    *value += size * (1.7 * place as f64 + size).sin();
                }
            }
            let mut found = Vec::new();
            scene.section_states(&state, &mut found);
            let (mut one_by_one, mut reaches) = (Vec::new(), scene.taken_reaches());
            let mut reader = Reader::new(&scene, 0, &mut reaches[0]);
            for element in 0..6 {
                reader.element(element, &[0.0, 0.25, 0.5, 0.75, 1.0], &mut one_by_one);
            }
            assert!(found.iter().any(|state| state.forces[0].abs() > 1e-3));
            assert_eq!(found, one_by_one);
        }
    }
}

#[test]
fn a_centre_line_carries_what_its_nodes_exert() {
    let what = |what, at| ObservedSpec::Section { body: 0, at, what };
    let hand = Hand {
        frames: vec!["inertial"],
        bodies: vec![body("rope", 0, &[0, 1], Vector::new(2.0, 0.0, 0.0))],
        observed: vec![
            what(SectionQuantity::AxialForce, Place::At(0.5)),
            what(SectionQuantity::Moment, Place::At(0.5)),
            what(SectionQuantity::Stress, Place::At(0.5)),
            what(SectionQuantity::Moment, Place::Start),
            what(SectionQuantity::AxialForce, Place::Start),
        ],
        ..Hand::default()
    };
    let mut scene = MeshScene::new(Box::new(hand.clone()), Formulation::Rncf, Joints::Eliminated, &[]).unwrap();
    // r = (x, c x^2/2), which the shape functions contain: r_x = (1, c x).
    let c: f64 = -0.4;
    let mut state = scene.rest(0.0);
    for node in 0..3 {
        let x = node as f64;
        state.x[4 * node..4 * node + 4].copy_from_slice(&[x, 0.5 * c * x * x, 1.0, c * x]);
    }
    let mut found = vec![0.0; 5];
    scene.outputs(&state, &mut found);
    // Nothing accelerates or acts within the first element: what its first node exerts on it, and the lever of it.
    let mut force = [0.0; 8];
    let mut hand = hand;
    hand.prepare(0, &[0.0, 1.0], &[]).unwrap();
    hand.elastic_force(0, 0, &state.x[..8], &[0.0; 8], &mut force);
    let slope = 1.0f64.hypot(0.5 * c);
    let axial = -(force[0] + force[1] * 0.5 * c) / slope;
    let start = -force[3];
    let moment = start + (0.5 * force[1] - 0.125 * c * force[0]);
    let stress = axial / 0.03 + moment.abs() * 0.1 / 7e-5;
    for (found, wanted) in found.iter().zip([axial, moment, stress, start, -force[0]]) {
        assert!(
            (found - wanted).abs() < 1e-12 * wanted.abs().max(1.0),
            "{found} instead of {wanted}"
        );
    }
}
