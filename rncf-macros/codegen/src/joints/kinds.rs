//! The kinds of joints, and what each of them fixes.

use super::algebra::{self, call, cross, divide, dot, multiply, norm, number, subtract};
use super::builder::Builder;
use crate::model::{Expr, Function, INERTIAL, Marker};

/// Whether a kind has an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// It has none.
    None,
    /// It has one, in a plane it is the normal and not written.
    InSpace,
    /// It always has one.
    Always,
}

/// A kind of joint.
#[derive(Debug)]
pub struct Kind {
    /// Word in the language.
    pub name: &'static str,
    /// How it is written.
    pub usage: &'static str,
    /// Whether it has an axis, fixed in the first party.
    pub axis: Axis,
    /// Whether it has a second axis, fixed in the second party.
    pub has_cross: bool,
    /// Whether both parties need an orientation; else their points do.
    pub orients: bool,
    /// Its coordinates in space, and in a plane.
    pub coordinates: [&'static [&'static str]; 2],
    /// Whether it carries a moment in space, and in a plane.
    pub has_moment: [bool; 2],
    /// Rows in space.
    pub spatial: fn(&mut Builder, &Arguments),
    /// Rows in a plane; `None`: it makes no sense there, with the advice what does.
    pub planar: Result<fn(&mut Builder, &Arguments), &'static str>,
}

/// What is given behind the parties.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    /// The axis, first party's axes, unit vector.
    pub axis: [f64; 3],
    /// The second axis, first party's axes at t = 0, unit vector.
    pub cross: [f64; 3],
    /// Length, m; `None`: the distance at t = 0.
    pub length: Option<Expr>,
}

/// All kinds between any two parties. Those of flexible ends alone ([`clamp`], [`hold`]) stand apart.
pub const KINDS: &[Kind] = &[
    Kind {
        name: "weld",
        usage: "weld(arm.at([1, 0, 0] m), hub)",
        axis: Axis::None,
        has_cross: false,
        orients: true,
        coordinates: [&[], &[]],
        has_moment: [true, true],
        spatial: weld,
        planar: Ok(weld_in_plane),
    },
    Kind {
        name: "spherical",
        usage: "spherical(arm.at([1, 0, 0] m), beam.end)",
        axis: Axis::None,
        has_cross: false,
        orients: false,
        coordinates: [&[], &[]],
        has_moment: [false, false],
        spatial: spherical,
        planar: Ok(spherical),
    },
    Kind {
        name: "universal",
        usage: "universal(arm.at([1, 0, 0] m), shaft, axis = y, cross = z)",
        axis: Axis::Always,
        has_cross: true,
        orients: true,
        coordinates: [&[], &[]],
        has_moment: [true, true],
        spatial: universal,
        planar: Err("use `revolute` or `weld`"),
    },
    Kind {
        name: "revolute",
        usage: "revolute(arm.at([1, 0, 0] m), hub, axis = z)",
        axis: Axis::InSpace,
        has_cross: false,
        orients: true,
        coordinates: [&["angle"], &["angle"]],
        has_moment: [true, false],
        spatial: revolute,
        planar: Ok(spherical),
    },
    Kind {
        name: "cylindrical",
        usage: "cylindrical(arm.at([1, 0, 0] m), hub, axis = z)",
        axis: Axis::Always,
        has_cross: false,
        orients: true,
        coordinates: [&["angle", "slide"], &[]],
        has_moment: [true, true],
        spatial: cylindrical,
        planar: Err("use `revolute` or `prismatic`"),
    },
    Kind {
        name: "prismatic",
        usage: "prismatic(slider, hub, axis = x)",
        axis: Axis::Always,
        has_cross: false,
        orients: true,
        coordinates: [&["slide"], &["slide"]],
        has_moment: [true, true],
        spatial: prismatic,
        planar: Ok(prismatic_in_plane),
    },
    Kind {
        name: "planar",
        usage: "planar(puck, table, axis = z)",
        axis: Axis::Always,
        has_cross: false,
        orients: true,
        coordinates: [&[], &[]],
        has_moment: [true, true],
        spatial: planar,
        planar: Err("everything is in the plane already: leave it out"),
    },
    Kind {
        name: "distance",
        usage: "distance(arm.at([1, 0, 0] m), beam.end, length = 2 m)",
        axis: Axis::None,
        has_cross: false,
        orients: false,
        coordinates: [&[], &[]],
        has_moment: [false, false],
        spatial: distance,
        planar: Ok(distance),
    },
];

fn weld(joint: &mut Builder, _: &Arguments) {
    let points = joint.points();
    joint.s(points);
    for axis in 0..3 {
        let next = joint.direction(0, unit((axis + 1) % 3));
        let (own, other) = (joint.direction(0, unit(axis)), joint.matching(1, next));
        joint.d1(own, other);
    }
}

fn weld_in_plane(joint: &mut Builder, _: &Arguments) {
    let points = joint.points();
    joint.s(points);
    let own = joint.direction(0, unit(joint.axes()[0]));
    let other = joint.matching(1, own);
    joint.parallel(own, other);
}

fn spherical(joint: &mut Builder, _: &Arguments) {
    let points = joint.points();
    joint.s(points);
}

fn universal(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.points();
    joint.s(points);
    let axis = joint.direction(0, arguments.axis);
    // Fixed in the second party; the first one's direction only says where it starts.
    let start = joint.direction(0, arguments.cross);
    let cross = joint.matching(1, start);
    joint.d1(axis, cross);
}

fn revolute(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.points();
    joint.s(points);
    about(joint, arguments);
}

/// The axis of the first party is that of the second.
fn about(joint: &mut Builder, arguments: &Arguments) {
    let axis = joint.direction(0, arguments.axis);
    for which in 0..2 {
        let normal = joint.normal_to(1, axis, which);
        joint.d1(axis, normal);
    }
}

/// The points stay on a line along the axis.
fn along(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.points();
    let axis = joint.direction(0, arguments.axis);
    for which in 0..2 {
        let normal = joint.normal_to(1, axis, which);
        joint.d2(normal, points);
    }
}

fn cylindrical(joint: &mut Builder, arguments: &Arguments) {
    about(joint, arguments);
    along(joint, arguments);
}

fn prismatic(joint: &mut Builder, arguments: &Arguments) {
    about(joint, arguments);
    let axis = joint.direction(0, arguments.axis);
    let (first, second) = (joint.normal_to(0, axis, 0), joint.normal_to(1, axis, 1));
    joint.d1(first, second);
    along(joint, arguments);
}

fn prismatic_in_plane(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.points();
    let axis = joint.direction(0, arguments.axis);
    let other = joint.matching(1, axis);
    joint.parallel(axis, other);
    let normal = joint.normal.unwrap_or(2);
    let offset = cross(&joint.value(axis), &joint.between(points));
    joint.numbered("offset", offset[normal].clone());
}

fn planar(joint: &mut Builder, arguments: &Arguments) {
    about(joint, arguments);
    let points = joint.points();
    let axis = joint.direction(0, arguments.axis);
    joint.d2(axis, points);
}

/// `(|d|^2 - L^2) / (2 L)`: a length, and smooth where the points meet.
fn distance(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.origins();
    let apart = joint.between(points);
    let length = arguments.length.clone().unwrap_or_else(|| {
        // Where both points are at t = 0, at rest.
        let start = points.map(|marker| {
            let frame = INERTIAL;
            joint.marker(1, Marker::Matching { frame, marker })
        });
        norm(&joint.between(start))
    });
    let squares = subtract(dot(&apart, &apart), multiply(length.clone(), length.clone()));
    joint.row("length", divide(squares, multiply(number(2.0), length)));
}

/// A flexible end in a frame: its point, and the direction of its slope (`is_full`: its norm, too).
pub fn clamp(joint: &mut Builder, is_full: bool) {
    let points = joint.points();
    joint.s(points);
    for party in 0..2 {
        let Some(slope) = joint.slope(party) else { continue };
        let other = 1 - party;
        if is_full {
            let start = joint.matching(other, slope);
            let apart = algebra::both(&joint.value(slope), &joint.value(start), subtract);
            joint.vector("slope", &apart);
        } else if joint.normal.is_some() {
            let start = joint.matching(other, slope);
            joint.parallel(start, slope);
        } else {
            for which in 0..2 {
                let normal = joint.normal_to(other, slope, which);
                joint.d1(slope, normal);
            }
        }
    }
}

/// One coordinate of a flexible end (first party) stays where it starts in the second party's frame.
pub fn hold(joint: &mut Builder, order: usize, axis: usize) {
    let moving = if order == 0 {
        joint.points()[0]
    } else {
        joint.slope(0).unwrap_or(crate::model::MarkerId(0))
    };
    let (start, along) = (joint.matching(1, moving), joint.direction(1, unit(axis)));
    let apart = algebra::both(&joint.value(moving), &joint.value(start), subtract);
    let what = if order == 0 { "position" } else { "slope" };
    let row = dot(&joint.value(along), &apart);
    joint.row(format!("{what} {}", ["x", "y", "z"][axis]), row);
}

/// A unit vector along an axis.
pub fn unit(axis: usize) -> [f64; 3] {
    let mut unit = [0.0; 3];
    unit[axis] = 1.0;
    unit
}

/// `sin(a - f)` from the sine and cosine of a.
pub fn behind(sine: Expr, cosine: Expr, f: &Expr) -> Expr {
    subtract(
        multiply(sine, call(Function::Cos, f.clone())),
        multiply(cosine, call(Function::Sin, f.clone())),
    )
}
