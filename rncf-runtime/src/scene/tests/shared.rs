//! Nodes that bodies share.

use super::model::Hand;
use super::random::Random;
use super::scenery::{along_slope, body, free, hold, joint};
use crate::emitted::{BodySpec, FixtureSpec, JointKind, JointSpec, Line, Motions, Place, RigidSpec, ShareSpec};
use crate::model::{Formulation, Joints, Scene, Uniform};
use crate::modes::{Wanted, modes};
use crate::scene::MeshScene;
use crate::scene::numbering::layout::{Layout, VectorKind};
use crate::space::{Vector, from_rows};
use crate::system::{State, System, Tangent};

const SPACE: &[usize] = &[0, 1, 2];

fn share(name: &'static str, first: (usize, bool), second: (usize, bool), smooth: bool) -> ShareSpec {
    ShareSpec {
        name,
        ends: [first, second],
        smooth,
    }
}

fn between(name: &'static str, frame: usize, from: [f64; 3], to: [f64; 3], count: usize) -> BodySpec {
    BodySpec {
        line: Line::Straight { from, to },
        count,
        ..body(name, frame, SPACE, to.into())
    }
}

/// A free frame with inertia that carries the bodies.
fn carried(bodies: Vec<BodySpec>, joints: Vec<JointSpec>, shares: Vec<ShareSpec>) -> Hand {
    let mut hub = free(1, 0, Motions::Spatial);
    hub.spin = Vector::new(0.1, 0.2, 0.7);
    hub.rigid = RigidSpec {
        mass: 2.0,
        moment: Vector::zeros(),
        inertia: from_rows(&[[0.5, 0.0, 0.0], [0.0, 0.6, 0.0], [0.0, 0.0, 0.8]]),
    };
    Hand {
        frames: vec!["inertial", "hub"],
        bodies,
        joints,
        shares,
        free: vec![hub],
        ..Hand::default()
    }
}

/// Residual, and product of all tangents with a vector, at a displaced state.
fn response(scene: &mut MeshScene) -> Vec<f64> {
    let mut random = Random(3);
    let mut state = scene.rest(0.0);
    let mut other = vec![0.0; state.x.len()];
    for values in [&mut state.x, &mut state.v, &mut state.a, &mut other] {
        values.iter_mut().for_each(|value| *value += 0.05 * random.number());
    }
    let count = state.x.len();
    let mut out = vec![0.0; count];
    scene.residual(&state, &mut out);
    let mut tangent = Tangent::default();
    scene.tangent(&state, &mut tangent);
    for values in [&tangent.mass, &tangent.stiffness, &tangent.damping] {
        let mut product = vec![0.0; count];
        scene.pattern().multiply_add(1.0, values, &other, &mut product);
        out.extend(product);
    }
    out
}

#[track_caller]
fn assert_alike(found: &[f64], wanted: &[f64]) {
    assert_eq!(found.len(), wanted.len());
    let size = wanted.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    for (place, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        assert!(
            (found - wanted).abs() <= 1e-12 * size,
            "{place}: {found} instead of {wanted}"
        );
    }
}

/// Two bodies of one and two elements in a row, all vectors of the middle in common, are one of three: the numbers of
/// the unknowns are the same, so that residuals and tangents can be compared one by one.
#[test]
fn bodies_in_a_row_are_one_longer_body() {
    let clamp = |body| joint("root", JointKind::Clamp, body, false, 1);
    let tip = |body| FixtureSpec {
        name: "tip",
        body,
        at: Place::End,
        constants: along_slope(0.4, 0.1, 0.05),
        elastic: false,
    };
    let mut long = carried(
        vec![between("long", 1, [0.0; 3], [0.9, 0.6, 0.3], 3)],
        vec![clamp(0)],
        Vec::new(),
    );
    long.fixtures = vec![tip(0)];
    let row = |order: [usize; 2]| {
        let bodies = [
            between("first", 1, [0.0; 3], [0.3, 0.2, 0.1], 1),
            between("second", 1, [0.3, 0.2, 0.1], [0.9, 0.6, 0.3], 2),
        ];
        let ends = if order == [0, 1] {
            [(0, true), (1, false)]
        } else {
            [(1, false), (0, true)]
        };
        let mut row = carried(
            bodies.to_vec(),
            vec![clamp(0)],
            vec![share("knot", ends[0], ends[1], true)],
        );
        row.fixtures = vec![tip(1)];
        row
    };
    let wanted = response(&mut long.clone().scene(Formulation::Rncf));
    for order in [[0, 1], [1, 0]] {
        let mut scene = row(order).scene(Formulation::Rncf);
        assert_alike(&response(&mut scene), &wanted);
    }
    let mut scene = row([0, 1]).scene(Formulation::Rncf);
    let found = (0..scene.unknowns()).map(|unknown| scene.describe_unknown(unknown));
    let found: Vec<String> = found.collect();
    // The common node is that of the first body, and named once.
    assert_eq!(found[1], "body `first`, node 1, position x");
    assert_eq!(found[7], "body `second`, node 1, position x");
    let frequencies = |scene: &mut MeshScene| {
        let at = Uniform::steady(0.0);
        let mut state = scene.uniform_guess(&at);
        state.v.fill(0.0);
        let found = modes(scene, &at, &state, Wanted { count: 8 }).unwrap();
        found.iter().map(|mode| mode.im).collect::<Vec<f64>>()
    };
    let still = |mut hand: Hand| {
        hand.free[0].spin = Vector::zeros();
        hand.scene(Formulation::Rncf)
    };
    let wanted = frequencies(&mut still(long));
    for (found, wanted) in frequencies(&mut still(row([0, 1]))).iter().zip(&wanted) {
        assert!(
            (found - wanted).abs() < 1e-10 * wanted.max(1.0) || wanted.abs() < 1e-5,
            "{found} {wanted}"
        );
    }
    // Frame states have the common node twice, with one value, and lead back to the state.
    let mut random = Random(5);
    let mut state = scene.rest(0.0);
    for values in [&mut state.x, &mut state.v] {
        values.iter_mut().for_each(|value| *value += 0.01 * random.number());
    }
    let frame = scene.frame_state(&state);
    assert_eq!(frame.q[6..12], frame.q[12..18]);
    assert_eq!(frame.v[6..12], frame.v[12..18]);
    let back = scene.state_of_frame(&frame);
    let vectors = scene.unknowns() - scene.border();
    assert_alike(&back.x[..vectors], &state.x[..vectors]);
    assert_alike(&back.v[..vectors], &state.v[..vectors]);
}

/// A square of four bodies whose corners are common positions, each also the end of a body that is clamped in the
/// middle.
fn net() -> Hand {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    let mut hand = carried(Vec::new(), Vec::new(), Vec::new());
    for (a, &corner) in corners.iter().enumerate() {
        let mut main = between("main", 1, [0.0; 3], corner, 2);
        main.instance = Some(a);
        hand.bodies.push(main);
        hand.joints.push(joint("hub", JointKind::Clamp, a, false, 1));
        hand.fixtures.push(FixtureSpec {
            name: "remote",
            body: a,
            at: Place::End,
            constants: along_slope(0.2, 0.0, 0.01),
            elastic: false,
        });
    }
    for (a, &corner) in corners.iter().enumerate() {
        let mut side = between("side", 1, corner, corners[(a + 1) % 4], 1);
        (side.kind, side.instance) = (1, Some(a));
        hand.bodies.push(side);
        hand.shares.push(share("tip", (4 + a, false), (a, true), false));
    }
    for a in 0..4 {
        hand.shares
            .push(share("knot", (4 + a, true), ((a + 1) % 4, true), false));
    }
    hand
}

#[test]
fn a_net_has_one_position_for_each_knot() {
    let mut scene = net().scene(Formulation::Rncf);
    // A clamped cable of two elements has 1 + 6 + 6 unknowns, a side its two slopes, the frame six.
    assert_eq!(scene.unknowns(), 4 * 13 + 4 * 6 + 6);
    assert!(scene.unknowns() == scene.sizes().len());
    let mut random = Random(9);
    let mut state = scene.rest(0.0);
    state.x.iter_mut().for_each(|x| *x += 0.01 * random.number());
    let frame = scene.frame_state(&state);
    // Positions of ends: mains have 3 nodes of 6 components, sides 2.
    let end_of_main = |a: usize| &frame.q[18 * a + 12..][..3];
    let side = |a: usize, at_end: bool| &frame.q[72 + 12 * a + if at_end { 6 } else { 0 }..][..3];
    for a in 0..4 {
        assert_eq!(end_of_main(a), side(a, false));
        assert_eq!(end_of_main((a + 1) % 4), side(a, true));
    }
    // Work of the forces along any motion is the change of the strain energy.
    assert_eq!(scene.describe_unknown(1), "body `main[0]`, node 1, position x");
    assert_tangent(&mut scene, &state);
}

/// Stiffness and mass against central differences of the residual.
#[track_caller]
fn assert_tangent(scene: &mut MeshScene, at: &State) {
    let mut tangent = Tangent::default();
    scene.tangent(at, &mut tangent);
    let count = scene.unknowns();
    let mut random = Random(17);
    let direction: Vec<f64> = (0..count).map(|_| random.number()).collect();
    let step = 1e-6;
    for (place, values) in [(0, &tangent.stiffness), (1, &tangent.damping), (2, &tangent.mass)] {
        let at = |sign: f64| {
            let mut moved = at.clone();
            let of = match place {
                0 => &mut moved.x,
                1 => &mut moved.v,
                _ => &mut moved.a,
            };
            // Orientations are at the end: those of the frame are kept, the tangent of others suffices.
            for (value, direction) in of.iter_mut().zip(&direction[..count - 6]) {
                *value += sign * step * direction;
            }
            moved
        };
        let mut residual = |state: &State| {
            let mut out = vec![0.0; count];
            scene.residual(state, &mut out);
            out
        };
        let (high, low) = (residual(&at(1.0)), residual(&at(-1.0)));
        let mut wanted = direction.clone();
        wanted[count - 6..].fill(0.0);
        let mut product = vec![0.0; count];
        scene.pattern().multiply_add(1.0, values, &wanted, &mut product);
        let size = product.iter().fold(1.0, |size: f64, value| size.max(value.abs()));
        for row in 0..count {
            let difference = (high[row] - low[row]) / (2.0 * step);
            assert!((product[row] - difference).abs() < 1e-7 * size, "{place} {row}");
        }
    }
}

/// Bodies in a ring, each end one with the start of the next: no end is left, and the ring keeps its momentum.
#[test]
fn a_ring_closes() {
    let count = 6;
    let corner = |a: usize| {
        let angle = std::f64::consts::TAU * a as f64 / count as f64;
        [angle.cos(), angle.sin(), 0.0]
    };
    let mut hand = Hand {
        frames: vec!["inertial"],
        ..Hand::default()
    };
    for a in 0..count {
        let mut side = between("side", 0, corner(a), corner(a + 1), 1);
        side.instance = Some(a);
        hand.bodies.push(side);
        hand.shares
            .push(share("ring", (a, true), ((a + 1) % count, false), false));
    }
    let mut scene = hand.clone().scene(Formulation::Rncf);
    assert_eq!(scene.unknowns(), count * (3 + 6));
    let mut state = scene.rest(0.0);
    let mut random = Random(21);
    state.x.iter_mut().for_each(|x| *x += 0.05 * random.number());
    let mut force = vec![0.0; scene.unknowns()];
    scene.residual(&state, &mut force);
    // Elastic forces on positions add up to nothing, though they do not vanish.
    let mut sum = [0.0; 3];
    let mut size = 0.0_f64;
    for unknown in 0..scene.unknowns() {
        let name = scene.describe_unknown(unknown);
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            if name.ends_with(&format!("position {letter}")) {
                sum[axis] += force[unknown];
                size = size.max(force[unknown].abs());
            }
        }
    }
    assert!(size > 1e-3);
    assert!(sum.iter().all(|value| value.abs() < 1e-12 * size.max(1.0)), "{sum:?}");
    // Sides meet at 60 degrees: their slopes cannot be one.
    hand.shares[3].smooth = true;
    let message = refused(hand);
    assert!(
        message.contains("`ring[3]`") && message.contains("slope") && message.contains("60.0 degrees"),
        "{message}"
    );
}

fn refused(hand: Hand) -> String {
    let result = MeshScene::new(Box::new(hand), Formulation::Rncf, Joints::Eliminated, &[]);
    result.err().expect("the scene makes no sense").message
}

#[test]
fn ends_that_cannot_be_one_are_refused_by_name() {
    let with = |change: &dyn Fn(&mut Hand)| {
        let mut hand = net();
        change(&mut hand);
        refused(hand)
    };
    let has = |message: String, words: &[&str]| {
        for word in words {
            assert!(message.contains(word), "{word} is not in: {message}");
        }
    };
    has(
        with(&|hand| hand.shares[2].ends[1] = hand.shares[2].ends[0]),
        &["`tip[2]`", "two different ends"],
    );
    has(
        with(&|hand| hand.bodies[5].frame = 0),
        &[
            "`tip[1]`",
            "the start of `side[1]`",
            "the end of `main[1]`",
            "`inertial`",
            "`hub`",
        ],
    );
    has(
        with(&|hand| hand.shares[1].ends[1].1 = false),
        &["`tip[1]`", "joint `hub[1]` holds"],
    );
    has(
        with(&|hand| hand.joints[3].at_end = true),
        &["`tip[3]`", "joint `hub[3]` holds", "leave one of the two out"],
    );
    has(
        with(&|hand| {
            hand.bodies[6].line = Line::Straight {
                from: [-1.1, 0.0, 0.0],
                to: [0.0, -1.0, 0.0],
            }
        }),
        &["`tip[2]`", "1.000e-1 m apart"],
    );
    has(with(&|hand| hand.bodies[1].count = 0), &["`main[1]`", "no elements"]);
    has(
        with(&|hand| hand.bodies[7].fidelity = crate::emitted::Fidelity::Rigid),
        &["`tip[3]`", "`side[3]`", "`modal`"],
    );
    has(
        with(&|hand| hand.joints[2].body = crate::emitted::instance(4, 4, 4.0)),
        &["joint `hub`", "`side`", "from 0 to 3"],
    );
    has(
        with(&|hand| hand.shares[2].ends[1].0 = crate::emitted::instance(0, 4, -1.0)),
        &["joint `tip`", "`main`", "from 0 to 3"],
    );
    has(
        with(&|hand| hand.fixtures[2].body = usize::MAX),
        &["fixture `remote`", "`main`", "from 0 to 3"],
    );
    let result = MeshScene::new(Box::new(net()), Formulation::Ancf, Joints::Eliminated, &[]);
    has(
        result.err().unwrap().message,
        &["joint `hub`", "repeated body `main`", "`hub`", "referenced formulation"],
    );
    // A slope may be held beside a common position.
    let mut hand = net();
    hand.joints.push(joint("rest", hold(1, 2), 4, false, 1));
    assert_eq!(
        hand.scene(Formulation::Rncf).unknowns(),
        net().scene(Formulation::Rncf).unknowns() - 1
    );
}

#[test]
fn vectors_that_are_one_have_the_leaders_value_and_the_sum_of_forces() {
    let kinds = vec![
        VectorKind::Prescribed,
        VectorKind::Free,
        VectorKind::Free,
        VectorKind::Free,
    ];
    let layout = Layout::new(&[2; 4], kinds, vec![0, 3, 2, 3], 1);
    assert_eq!((layout.unknowns(), layout.border()), (5, 1));
    assert_eq!(layout.origins(), [(1, 0), (1, 1), (2, 0), (2, 1)]);
    let full = [9.0, 9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let mut x = [7.0; 5];
    layout.unknowns_of(&full, &mut x);
    assert_eq!(x, [5.0, 6.0, 3.0, 4.0, 0.0]);
    let full = [&full[..], &[0.0]].concat();
    let mut spread = full.clone();
    layout.expand(&x, &mut spread);
    assert_eq!(spread, [9.0, 9.0, 5.0, 6.0, 3.0, 4.0, 5.0, 6.0, 0.0]);
    layout.project(&full, &mut x);
    assert_eq!(x, [6.0, 8.0, 3.0, 4.0, 0.0]);
}

/// Bodies in a ring: each is numbered and named as in a small scene.
#[test]
fn many_bodies_are_numbered_and_named() {
    let count = 400;
    let corner = |a: usize| {
        let angle = std::f64::consts::TAU * a as f64 / count as f64;
        [angle.cos(), angle.sin(), 0.0]
    };
    let mut hand = carried(Vec::new(), Vec::new(), Vec::new());
    for a in 0..count {
        let mut main = between("main", 1, [0.0; 3], corner(a), 4);
        main.instance = Some(a);
        hand.bodies.push(main);
        hand.joints.push(joint("hub", JointKind::Clamp, a, false, 1));
    }
    for a in 0..count {
        let mut side = between("side", 1, corner(a), corner(a + 1), 1);
        (side.kind, side.instance) = (1, Some(a));
        hand.bodies.push(side);
        hand.shares.push(share("tip", (count + a, false), (a, true), false));
    }
    for a in 0..count {
        let next = (a + 1) % count;
        hand.shares.push(share("knot", (count + a, true), (next, true), false));
        hand.shares
            .push(share("ring", (count + a, true), (count + next, false), true));
    }
    let scene = hand.scene(Formulation::Rncf);
    assert_eq!(scene.unknowns(), count * (1 + 4 * 6) + count * 3 + 6);
    let names: Vec<String> = (0..scene.unknowns())
        .map(|unknown| scene.describe_unknown(unknown))
        .collect();
    assert!(names[1].contains("main[0]"));
}
