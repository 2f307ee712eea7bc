//! A scene by hand with frames of every kind, bodies in them, and everything that acts.

use super::law::Law;
use super::model::{EVERY, Hand, PAIRS, Quadratic};
use crate::emitted::{
    BodySpec, ConstraintSpec, Fidelity, FixtureSpec, ForceSpec, FrameTie, FreeSpec, Interpolant, JointKind, JointSpec,
    Line, LoadKind, LoadSpec, MarkerSpec, Motions, NodalSpec, Place, RigidSpec, Twist, When,
};
use crate::space::{Vector, from_rows};

/// Nodal vectors of a centre line with slopes at both ends.
pub const NODAL: [NodalSpec; 4] = {
    const fn vector(meaning: &'static str, order: usize, xi: f64) -> NodalSpec {
        NodalSpec {
            meaning,
            of: Interpolant::Position,
            order,
            xi,
        }
    }
    [
        vector("position", 0, 0.0),
        vector("slope", 1, 0.0),
        vector("position", 0, 1.0),
        vector("slope", 1, 1.0),
    ]
};

/// Holds one component of a position (0) or slope (1).
pub fn hold(order: usize, axis: usize) -> JointKind {
    JointKind::Hold {
        of: Interpolant::Position,
        order,
        axis,
    }
}

/// Constants of a fixture with its mass along the slope.
pub fn along_slope(mass: f64, first: f64, second: f64) -> [f64; 10] {
    [mass, first, 0.0, 0.0, second, 0.0, 0.0, 0.0, 0.0, 0.0]
}

/// A body of two elements along a line of its frame.
pub fn body(name: &'static str, frame: usize, axes: &'static [usize], to: Vector) -> BodySpec {
    BodySpec {
        name,
        kind: 0,
        instance: None,
        frame,
        axes,
        line: Line::Straight {
            from: [0.0; 3],
            to: to.into(),
        },
        count: 2,
        nodal: &NODAL,
        connectivity: &[0, 1, 2, 3],
        vectors_per_node: 2,
        stride: 2,
        section_y: None,
        twist: Twist::even(0.0),
        stations: Vec::new(),
        fidelity: Fidelity::Full,
        damps: false,
        tie: FrameTie::Joints,
        normals: Vec::new(),
    }
}

/// A joint of a body's end with a frame, where the undeformed body is.
pub fn joint(name: &'static str, kind: JointKind, body: usize, at_end: bool, frame: usize) -> JointSpec {
    JointSpec {
        name,
        kind,
        body,
        at_end,
        frame,
        point: None,
    }
}

/// A free frame at its parent, at rest, without inertia.
pub fn free(frame: usize, parent: usize, motions: Motions) -> FreeSpec {
    FreeSpec {
        size: 1.0,
        frame,
        parent,
        is_body: false,
        motions,
        position: Vector::zeros(),
        axis: Vector::z(),
        angle: 0.0,
        velocity: Vector::zeros(),
        spin: Vector::zeros(),
        rigid: RigidSpec::default(),
    }
}

/// A rigid body with its mass centre off the origin.
pub fn stone() -> RigidSpec {
    RigidSpec {
        mass: 1.3,
        moment: Vector::new(0.2, -0.1, 0.3),
        inertia: from_rows(&[[0.9, 0.05, -0.1], [0.05, 1.1, 0.07], [-0.1, 0.07, 0.8]]),
    }
}

pub const DEAD: Place = Place::At(0.37);

/// Frames of every kind, bodies in them, and everything that acts.
pub fn everything() -> Hand {
    let load = |name, kind, frame| LoadSpec { name, kind, frame };
    let with = |mut spec: FreeSpec, rigid: RigidSpec| {
        spec.rigid = rigid;
        spec
    };
    let mut spatial = with(free(3, 2, Motions::Spatial), stone());
    (spatial.position, spatial.axis, spatial.angle) = (Vector::new(0.2, 0.1, -0.3), Vector::new(0.6, 0.0, 0.8), 0.4);
    (spatial.velocity, spatial.spin) = (Vector::new(0.3, 0.2, 0.1), Vector::new(0.5, -0.4, 0.3));
    let mut planar = free(6, 0, Motions::Planar { normal: 2 });
    (planar.position, planar.angle, planar.spin) = (Vector::new(0.0, 0.4, 0.1), 7.0, Vector::new(0.0, 0.0, 0.6));
    let rigid = |name, markers: &'static [usize], law| {
        let spec = ForceSpec {
            name,
            markers,
            conservative: false,
            of_differences: false,
            branches: 0,
        };
        (spec, law)
    };
    Hand {
        frames: vec![
            "inertial", "shifting", "turning", "ship", "top", "door", "sledge", "stone", "puck",
        ],
        moving: true,
        bodies: vec![
            body("mast", 3, &[0, 1, 2], Vector::new(0.9, 0.3, 0.0)),
            body("whip", 6, &[0, 1], Vector::new(0.4, 0.5, 0.0)),
            body("blade", 2, &[0, 1, 2], Vector::new(0.0, 0.8, 0.2)),
        ],
        joints: vec![
            joint("step", JointKind::Clamp, 0, false, 3),
            joint("grip", JointKind::Pin, 1, false, 6),
            joint("rest", hold(0, 1), 1, true, 6),
            joint("root", JointKind::Pin, 2, false, 0),
            joint("tip", hold(1, 2), 2, true, 2),
        ],
        loads: vec![
            (load("gravity", LoadKind::Gravity, 2), Vector::new(0.5, -1.0, -3.0)),
            (
                load("push", LoadKind::Force { body: 0, at: DEAD }, 2),
                Vector::new(0.5, 1.5, -0.7),
            ),
            (
                load(
                    "twist",
                    LoadKind::Moment {
                        body: 0,
                        at: Place::End,
                    },
                    0,
                ),
                Vector::new(0.6, 0.4, -0.9),
            ),
            (
                load("lean", LoadKind::Moment { body: 1, at: DEAD }, 0),
                Vector::new(0.1, 0.2, 1.1),
            ),
            (
                load("blow", LoadKind::Force { body: 2, at: DEAD }, 3),
                Vector::new(1.0, -0.3, 0.4),
            ),
            (
                load(
                    "wring",
                    LoadKind::Moment {
                        body: 2,
                        at: Place::End,
                    },
                    4,
                ),
                Vector::new(0.3, 0.8, -0.6),
            ),
        ],
        free: vec![
            spatial,
            with(free(4, 1, Motions::Turning), stone()),
            with(
                free(
                    5,
                    1,
                    Motions::Hinged {
                        axis: Vector::new(0.6, 0.8, 0.0),
                    },
                ),
                stone(),
            ),
            planar,
            with(free(7, 0, Motions::Shifting), stone()),
            with(free(8, 0, Motions::ShiftingPlanar { normal: 1 }), stone()),
        ],
        markers: vec![
            MarkerSpec::Point {
                frame: 3,
                at: [0.1, 0.2, 0.3],
            },
            MarkerSpec::Direction {
                frame: 4,
                along: [0.6, 0.0, 0.8],
            },
            MarkerSpec::BodyPoint { body: 0, at: DEAD },
            MarkerSpec::BodySlope {
                body: 0,
                at: Place::End,
            },
            MarkerSpec::BodyPoint { body: 1, at: DEAD },
            MarkerSpec::BodyPoint {
                body: 2,
                at: Place::Start,
            },
            MarkerSpec::Turn { frame: 4 },
            MarkerSpec::Angle { frame: 5 },
            MarkerSpec::Matching { frame: 5, marker: 2 },
            MarkerSpec::Normal {
                frame: 7,
                marker: 3,
                which: 1,
            },
            MarkerSpec::Point {
                frame: 2,
                at: [0.3, -0.2, 0.1],
            },
            MarkerSpec::BodySlope { body: 2, at: DEAD },
            MarkerSpec::Point {
                frame: 8,
                at: [0.0, 0.1, 0.0],
            },
            MarkerSpec::Turn { frame: 2 },
            MarkerSpec::Direction {
                frame: 2,
                along: [0.0, 0.6, 0.8],
            },
        ],
        constraints: constraints(),
        forces: vec![
            rigid("rope", &[2, 4], Law::Spring(1.2, 0.5, 0.7)),
            rigid("band", &[10, 0], Law::Spring(0.8, 0.3, 0.4)),
            rigid("jet", &[5, 1], Law::Along(1.7)),
            rigid("rudder", &[3, 11], Law::Along(0.9)),
            rigid("brake", &[6], Law::Drag(0.6)),
            rigid("friction", &[7], Law::Drag(1.4)),
            rigid("air", &[12], Law::Drag(0.5)),
            rigid("wake", &[11], Law::Drag(0.5)),
        ],
        fixtures: vec![
            FixtureSpec {
                name: "ball",
                body: 0,
                at: Place::End,
                constants: along_slope(0.4, 0.1, 0.05),
                elastic: false,
            },
            FixtureSpec {
                name: "disc",
                body: 1,
                at: DEAD,
                constants: along_slope(0.3, -0.1, 0.06),
                elastic: false,
            },
            FixtureSpec {
                name: "lamp",
                body: 2,
                at: Place::End,
                constants: along_slope(0.2, 0.05, 0.04),
                elastic: false,
            },
        ],
        ..Hand::default()
    }
}

fn constraints() -> Vec<(ConstraintSpec, Vec<Quadratic>)> {
    let spec = |name, markers: &'static [usize], rows: &'static [&'static str]| ConstraintSpec {
        name,
        kind: "constraint",
        rows,
        markers,
        coupled: &EVERY[..PAIRS[markers.len()]],
        of_differences: false,
        first_party: 1,
        branches: 0,
        when: When::Always,
    };
    let unit = |axis: usize| Vector::ith(axis, 1.0);
    let point = |axis: usize| Quadratic {
        linear: vec![(0, unit(axis)), (1, -unit(axis))],
        sine: 0.2,
        ..Quadratic::default()
    };
    let product = |products| Quadratic {
        products,
        sine: 0.3,
        ..Quadratic::default()
    };
    vec![
        (
            spec("ball joint", &[2, 8], &["position x", "position y", "position z"]),
            vec![point(0), point(1), point(2)],
        ),
        (
            spec("square", &[1, 3], &["direction 1"]),
            vec![product(vec![(0, 1, 1.0)])],
        ),
        (
            spec("rod", &[4, 5], &["distance"]),
            vec![product(vec![(0, 0, 1.0), (0, 1, -2.0), (1, 1, 1.0)])],
        ),
        (
            spec("drive", &[7], &["angle"]),
            vec![Quadratic {
                linear: vec![(0, unit(0))],
                sine: 1.0,
                ..Quadratic::default()
            }],
        ),
        (
            spec("slot", &[0, 10, 9, 14], &["in the slot", "on the guide"]),
            vec![
                product(vec![(2, 0, 1.0), (2, 1, -1.0)]),
                product(vec![(3, 0, 1.0), (3, 1, -1.0)]),
            ],
        ),
        (
            spec("wheel", &[11, 14, 12], &["across"]),
            vec![product(vec![(0, 1, 0.5), (0, 2, 0.7), (2, 2, 0.2)])],
        ),
    ]
}
