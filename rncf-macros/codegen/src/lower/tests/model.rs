//! A model with one of everything that moves freely, built by hand on top of a declaration.

use proc_macro2::TokenStream;

use crate::elements::Library;
use crate::errors::Errors;
use crate::model::*;
use crate::{check, parse};

/// A declaration with prescribed frames only.
const BASE: &str = "pub model Moving {
    /// Mass of the hub
    param mass = 2 kg;
    param gap = 0.5 m;
    material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
    motion z(t) = if t < 2 s { 0.3 [rad/s] * t } else { 0.6 rad };
    frame rotor = rotating(axis = y, angle = z(t));
    frame hub = moving(origin = [1 m, gap, 0 m]);
    frame sled = rotating(axis = [0, 0, -1], angle = 20 deg);
    body beam in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(wire, steel); }
    body strip in sled { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(wire, steel); }
    body rope in inertial { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(wire, steel); }
    joint root = clamp(beam.start, hub);
    joint anchor = pin(rope.start, inertial);
    joint foot = clamp(strip.start, sled);
    output tip = beam.end;
}";

pub fn number(value: f64) -> Expr {
    Expr::Number(value)
}

pub fn numbers(values: [f64; 3]) -> [Expr; 3] {
    values.map(number)
}

pub fn binary(operator: Binary, a: Expr, b: Expr) -> Expr {
    Expr::Binary(operator, Box::new(a), Box::new(b))
}

pub fn plus(a: Expr, b: Expr) -> Expr {
    binary(Binary::Add, a, b)
}

pub fn minus(a: Expr, b: Expr) -> Expr {
    binary(Binary::Subtract, a, b)
}

pub fn times(a: Expr, b: Expr) -> Expr {
    binary(Binary::Multiply, a, b)
}

pub fn over(a: Expr, b: Expr) -> Expr {
    binary(Binary::Divide, a, b)
}

/// A component of a marker's value or rate.
pub fn marker(marker: usize, derivative: usize, component: usize) -> Expr {
    Expr::Observed(Observable::Marker {
        marker: MarkerId(marker),
        derivative,
        component,
    })
}

fn dot(a: [Expr; 3], b: [Expr; 3]) -> Expr {
    let [x, y, z] = [0, 1, 2].map(|i| times(a[i].clone(), b[i].clone()));
    plus(plus(x, y), z)
}

fn vector(which: usize, derivative: usize) -> [Expr; 3] {
    [0, 1, 2].map(|component| marker(which, derivative, component))
}

fn difference(a: [Expr; 3], b: [Expr; 3]) -> [Expr; 3] {
    [0, 1, 2].map(|i| minus(a[i].clone(), b[i].clone()))
}

fn free(motions: Motions, is_body: bool) -> Free {
    Free {
        motions,
        velocity: numbers([0.1, 0.2, 0.3]),
        spin: numbers([0.0, 0.0, 2.0]),
        parts: Vec::new(),
        is_body,
        size: None,
    }
}

fn constraint(name: &str, kind: &str, markers: &[usize], rows: Vec<(&str, Expr)>) -> Constraint {
    Constraint {
        name: name.to_string(),
        doc: String::new(),
        kind: kind.to_string(),
        markers: markers.iter().copied().map(MarkerId).collect(),
        first_party: 1,
        rows: rows.into_iter().map(|(what, row)| (what.to_string(), row)).collect(),
        absolute: None,
    }
}

fn spherical(name: &str, a: usize, b: usize) -> Constraint {
    let [x, y, z] = difference(vector(a, 0), vector(b, 0));
    let rows = vec![("position x", x), ("position y", y), ("position z", z)];
    constraint(name, "spherical", &[a, b], rows)
}

/// The declaration as it stands.
pub fn base() -> Model {
    let mut errors = Errors::new();
    let tree = parse::parse(BASE.parse::<TokenStream>().unwrap(), &mut errors).unwrap();
    let model = check::check(&tree, &Library::standard(), &mut errors);
    let mistakes = errors.finish();
    assert!(mistakes.is_empty(), "{mistakes:?}");
    model.unwrap()
}

/// With free frames `hub` (two rigid parts, a body) and `sled` (planar), a turning frame, markers,
/// constraints, forces and fixtures.
pub fn moving() -> Model {
    let mut model = base();
    model.frames[2].free = Some(free(Motions::Spatial, true));
    model.frames[3].free = Some(free(Motions::Planar { normal: 2 }, false));
    let part = |name: &str, mass: Expr, center: [f64; 3], inertia: [f64; 6]| RigidPart {
        name: name.to_string(),
        mass,
        center: numbers(center),
        inertia: inertia.map(number),
    };
    if let Some(hub) = &mut model.frames[2].free {
        let mass = Expr::Param(ParamId(0));
        hub.parts
            .push(part("core", mass, [0.1, 0.2, 0.3], [1.0, 2.0, 3.0, 0.1, 0.2, 0.3]));
        hub.parts.push(part("ball", number(3.0), [-0.5, 0.0, 0.4], [0.0; 6]));
    }
    model.bodies[0].fidelity = Fidelity::Small(number(3.0));
    model.bodies[1].tie = FrameTie::MeanAxes;
    model.markers = vec![
        Marker::Point {
            frame: FrameId(2),
            at: [Expr::Param(ParamId(1)), number(0.0), number(1.0)],
        },
        Marker::Matching {
            frame: FrameId(3),
            marker: MarkerId(0),
        },
        Marker::BodyPoint {
            body: BodyId(0),
            at: Location::End,
        },
        Marker::BodyPoint {
            body: BodyId(2),
            at: Location::At(Box::new(Expr::Param(ParamId(1)))),
        },
        Marker::BodySlope {
            body: BodyId(0),
            at: Location::End,
        },
        Marker::Direction {
            frame: FrameId(3),
            along: numbers([0.0, 1.0, 0.0]),
        },
        Marker::Angle { frame: FrameId(3) },
        Marker::Turn { frame: FrameId(2) },
        Marker::Normal {
            frame: FrameId(2),
            marker: MarkerId(5),
            which: 1,
        },
    ];
    let angle = Expr::Motion(MotionId(0), Box::new(Expr::Time));
    let square = dot(vector(4, 0), vector(4, 0));
    let cosine = over(
        dot(vector(4, 0), vector(5, 0)),
        Expr::Call(Function::Sqrt, vec![square]),
    );
    let driven = minus(marker(6, 0, 0), Expr::Call(Function::Sin, vec![angle]));
    model.constraints = vec![
        spherical("pin", 0, 1),
        constraint(
            "hinge",
            "constraint",
            &[4, 5, 6],
            vec![("direction", cosine), ("angle", driven)],
        ),
        spherical("link", 2, 3),
    ];
    model.constraints[2].absolute = Some(BodyId(0));
    let [x, y, z] = difference(vector(3, 0), vector(2, 0));
    let gap = [x, y, z];
    let length = Expr::Call(Function::Sqrt, vec![dot(gap.clone(), gap.clone())]);
    let rate = over(dot(gap.clone(), difference(vector(3, 1), vector(2, 1))), length.clone());
    let pull = over(
        plus(
            times(number(40.0), minus(length.clone(), number(0.5))),
            times(number(0.3), rate),
        ),
        length,
    );
    let on = gap.map(|component| times(pull.clone(), component));
    let force = |name: &str, markers: &[usize], components: Vec<[Expr; 3]>, energy| Force {
        name: name.to_string(),
        doc: String::new(),
        markers: markers.iter().copied().map(MarkerId).collect(),
        components,
        energy,
        kind: ForceKind::Spring,
    };
    let turn = marker(6, 0, 0);
    let back = Expr::Negate(Box::new(times(number(5.0), turn.clone())));
    let potential = times(number(2.5), times(turn.clone(), turn));
    model.forces = vec![
        force(
            "strut",
            &[2, 3],
            vec![on.clone(), on.map(|component| Expr::Negate(Box::new(component)))],
            None,
        ),
        force("coil", &[6], vec![[back, number(0.0), number(0.0)]], Some(potential)),
        force("thrust", &[7], vec![numbers([0.0, 0.0, 4.0])], None),
    ];
    for body in 0..2 {
        model.fixtures.push(Fixture {
            repeat: None,
            name: format!("ball{body}"),
            doc: String::new(),
            body: BodyId(body),
            at: Location::End,
            constants: {
                let mut constants = std::array::from_fn(|_| number(0.0));
                constants[0] = Expr::Param(ParamId(0));
                constants[1] = number(0.1);
                constants[4] = number(0.02);
                constants
            },
            elastic: false,
        });
    }
    let observed = [
        Observable::Marker {
            marker: MarkerId(0),
            derivative: 2,
            component: 1,
        },
        Observable::ConstraintReaction {
            constraint: ConstraintId(0),
            moment: true,
            component: 2,
        },
        Observable::Multiplier {
            constraint: ConstraintId(1),
            row: 1,
        },
    ];
    let components = observed.into_iter().enumerate();
    model.outputs.push(Output {
        name: "seen".to_string(),
        doc: String::new(),
        unit: "1".to_string(),
        time_exponent: 0.0,
        components: components
            .map(|(i, seen)| (format!("_{i}"), Expr::Observed(seen)))
            .collect(),
    });
    model
}
