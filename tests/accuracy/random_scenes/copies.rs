//! Copies of a scene: turned, mirrored, cut, renamed, in other units.

use super::random::Random;
use super::tree::*;
use super::write::{Copy, Quantity};

/// The copy of a scene that its seed asks for.
pub fn copy_of(tree: &Tree) -> Copy {
    let mut random = Random::new(tree.seed, 7);
    let (matrix, parity) = if tree.plane {
        // Turned in the plane, mirrored, and in another plane.
        let turn = rotation([0.0, 0.0, 1.0], random.between(-3.0, 3.0));
        let parity = random.one(&[-1.0, 1.0]);
        let mirror = [[parity, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let cycle = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mut matrix = product(&turn, &mirror);
        for _ in 0..random.below(3) {
            matrix = product(&cycle, &matrix);
        }
        (matrix, parity)
    } else {
        let turn = rotation(random.direction(false), random.between(0.5, 3.0));
        let parity = random.one(&[-1.0, 1.0]);
        let mirror = [[parity, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        (product(&turn, &mirror), parity)
    };
    Copy {
        matrix,
        parity,
        cut: random.chance(0.6),
        renamed: random.chance(0.6),
    }
}

/// Sign of odd numbers in the copy.
pub fn odd(tree: &Tree, copy: &Copy) -> f64 {
    if !tree.plane {
        return copy.parity;
    }
    let normal = turned(&copy.matrix, [0.0, 0.0, 1.0]);
    normal.iter().sum::<f64>().signum() * copy.parity
}

/// The lengths, masses and times of a scene in other units: `length`, `mass`, `time` are the new ones over the old.
pub fn in_units(tree: &Tree, length: f64, mass: f64, time: f64) -> Tree {
    let mut tree = tree.clone();
    let (force, rate) = (mass * length / time / time, 1.0 / time);
    let long = |v: Vector| scaled(v, length);
    let put = |place: &mut Place| match place {
        Place::Ground(p) | Place::Frame(_, p) => *p = long(*p),
        Place::Body(..) => {}
    };
    tree.t_end *= time;
    for frame in &mut tree.frames {
        frame.pose.origin = long(frame.pose.origin);
        frame.velocity = scaled(frame.velocity, length / time);
        frame.spin = scaled(frame.spin, rate);
        match &mut frame.kind {
            Kind::Rotating { rate: own, .. } => *own *= rate,
            Kind::Moving { way, rate: own } => {
                *way = long(*way);
                *own *= rate;
            }
            Kind::Free => {}
            Kind::Rigid {
                mass: own,
                center,
                inertia,
            } => {
                *own *= mass;
                *center = long(*center);
                *inertia = inertia.map(|row| row.map(|x| x * mass * length * length));
            }
        }
    }
    for body in &mut tree.bodies {
        body.from = long(body.from);
        body.length *= length;
        body.radius *= length;
        body.side = body.side.map(|side| side * length);
        body.density *= mass / length.powi(3);
        body.young *= force / length / length;
        body.damping *= time;
        body.moving = body.moving.map(|(v, w)| (scaled(v, length / time), scaled(w, rate)));
    }
    for joint in &mut tree.joints {
        put(&mut joint.a);
        put(&mut joint.b);
        if let Some([_, own]) = &mut joint.drive {
            *own *= rate;
        }
        if let Some([k, c]) = &mut joint.coil {
            *k *= force * length;
            *c *= force * length * time;
        }
    }
    for spring in &mut tree.springs {
        match spring {
            Spring::Linear {
                a,
                b,
                stiffness,
                damping,
                length: own,
            } => {
                put(a);
                put(b);
                *stiffness *= force / length;
                *damping *= force / length * time;
                *own *= length;
            }
            Spring::Law {
                a,
                b,
                cubic,
                length: own,
            } => {
                put(a);
                put(b);
                *cubic *= force / length.powi(3);
                *own *= length;
            }
            Spring::Bushing {
                a,
                b,
                stiffness,
                damping,
            } => {
                put(a);
                put(b);
                *stiffness *= force / length;
                *damping *= force / length * time;
            }
        }
    }
    for load in &mut tree.loads {
        match load {
            Load::Force {
                at,
                force: own,
                rate: turn,
                ..
            } => {
                put(at);
                *own = scaled(*own, force);
                *turn *= rate;
            }
            Load::Moment { at, moment, rate: turn } => {
                put(at);
                *moment = scaled(*moment, force * length);
                *turn *= rate;
            }
            Load::Follower { at, force: own } => {
                put(at);
                *own *= force;
            }
            Load::Density { force: own, .. } => *own = scaled(*own, force / length),
        }
    }
    tree.gravity = tree.gravity.map(|g| scaled(g, length / time / time));
    tree
}

/// Factor of a quantity in other units.
pub fn factor(quantity: Quantity, length: f64, mass: f64, time: f64) -> f64 {
    match quantity {
        Quantity::Position => length,
        Quantity::Velocity => length / time,
        Quantity::Acceleration => length / time / time,
        Quantity::Spin => 1.0 / time,
        Quantity::Angle => 1.0,
        Quantity::Force => mass * length / time / time,
        Quantity::Moment => mass * length * length / time / time,
        Quantity::Momentum => mass * length / time,
        Quantity::AngularMomentum => mass * length * length / time,
    }
}
