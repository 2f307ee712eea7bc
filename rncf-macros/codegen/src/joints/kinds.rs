//! The kinds of joints, and what each of them fixes.

use super::algebra::{self, call, cross, divide, dot, multiply, norm, number, subtract, unit};
use super::builder::{Builder, Party};
use crate::model::{Expr, Function, Held, INERTIAL, Marker, MarkerId};

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
    orient(joint);
}

/// Neither party turns in the other one.
fn orient(joint: &mut Builder) {
    for axis in 0..3 {
        let next = joint.direction(0, unit((axis + 1) % 3));
        let own = joint.direction(0, unit(axis));
        let (own, other) = (joint.fixed(0, own), joint.fixed(1, next));
        joint.d1(own, other);
    }
}

fn weld_in_plane(joint: &mut Builder, _: &Arguments) {
    let points = joint.points();
    joint.s(points);
    let start = joint.direction(0, unit(joint.axes()[0]));
    let (own, other) = (joint.fixed(0, start), joint.fixed(1, start));
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
    let (axis, cross) = (joint.fixed(0, axis), joint.fixed(1, start));
    joint.d1(axis, cross);
}

fn revolute(joint: &mut Builder, arguments: &Arguments) {
    let points = joint.points();
    joint.s(points);
    about(joint, arguments);
}

/// The axis of the first party is that of the second.
fn about(joint: &mut Builder, arguments: &Arguments) {
    let start = joint.direction(0, arguments.axis);
    let axis = joint.fixed(0, start);
    for which in 0..2 {
        let normal = joint.normal_to(1, start, which);
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
    let start = joint.direction(0, arguments.axis);
    let (axis, other) = (joint.fixed(0, start), joint.fixed(1, start));
    joint.parallel(axis, other);
    let normal = joint.normal.unwrap_or(2);
    let offset = cross(&joint.value(axis), &joint.between(points));
    joint.numbered("offset", offset[normal].clone());
}

fn planar(joint: &mut Builder, arguments: &Arguments) {
    about(joint, arguments);
    let points = joint.points();
    let start = joint.direction(0, arguments.axis);
    let axis = joint.fixed(0, start);
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

/// A flexible end on a frame or section: its point, and the directions of its slope or section's axes
/// (`is_full`: their norms, too).
pub fn clamp(joint: &mut Builder, is_full: bool) {
    let points = joint.points();
    joint.s(points);
    if !is_full && joint.normal.is_none() && joint.is_section_on_frame() {
        return orient(joint);
    }
    for party in 0..2 {
        for (what, direction) in clamped(joint, party) {
            let other = 1 - party;
            if is_full {
                let start = joint.fixed(other, direction);
                let apart = algebra::both(&joint.value(direction), &joint.value(start), subtract);
                joint.vector(what, &apart);
            } else if joint.normal.is_some() {
                let start = joint.fixed(other, direction);
                joint.parallel(start, direction);
            } else {
                for which in 0..2 {
                    let normal = joint.normal_to(other, direction, which);
                    joint.d1(direction, normal);
                }
            }
        }
    }
}

/// Two centre lines in a plane keep the angle between them: with slopes a and b, and where they start, A and B,
/// `(A . B) (a x b) - (A x B) (a . b) = 0`, which is the sine of the change of the angle times the lengths of the slopes.
pub fn corner(joint: &mut Builder) {
    let points = joint.points();
    joint.s(points);
    let (Some(first), Some(second), Some(normal)) = (joint.slope(0), joint.slope(1), joint.normal) else {
        return;
    };
    let starts = [joint.matching(0, first), joint.matching(1, second)];
    let products = |[a, b]: [MarkerId; 2]| {
        let (a, b) = (joint.value(a), joint.value(b));
        (dot(&a, &b), cross(&a, &b)[normal].clone())
    };
    let ((cosine, sine), (along, across)) = (products(starts), products([first, second]));
    joint.row("angle", subtract(multiply(cosine, across), multiply(sine, along)));
}

/// What a clamp fixes of a party in the other one: the axes of a section in a frame, the slope of a
/// centre line in a frame or section.
fn clamped(joint: &mut Builder, party: usize) -> Vec<(&'static str, MarkerId)> {
    let is_on_frame = matches!(joint.parties[1 - party], Party::Frame { .. });
    match joint.section(party) {
        Some((y, z)) if is_on_frame => [("ey", y)].into_iter().chain(z.map(|z| ("ez", z))).collect(),
        Some(_) => Vec::new(),
        None => joint.slope(party).map(|slope| ("slope", slope)).into_iter().collect(),
    }
}

/// One coordinate of a flexible place (first party) stays where it starts in the second party's frame: in space that of
/// an axis that turns with the section, not of r_y or r_z alone, which would shear the section in its plane.
pub fn hold(joint: &mut Builder, of: Held, axis: usize) {
    let section = |joint: &mut Builder, z: bool| {
        let (y, other) = joint.section(0)?;
        let axis = if z { other? } else { y };
        Some(if joint.normal.is_none() {
            joint.fixed(0, axis)
        } else {
            axis
        })
    };
    let (what, moving) = match of {
        Held::Position => ("position", Some(joint.points()[0])),
        Held::Slope => ("slope", joint.slope(0)),
        Held::SectionY => ("ey", section(joint, false)),
        Held::SectionZ => ("ez", section(joint, true)),
    };
    let Some(moving) = moving else { return };
    let along = joint.direction(1, unit(axis));
    let (start, along) = (joint.matching(1, moving), joint.fixed(1, along));
    let apart = algebra::both(&joint.value(moving), &joint.value(start), subtract);
    let row = dot(&joint.value(along), &apart);
    joint.row(format!("{what} {}", ["x", "y", "z"][axis]), row);
}

/// The section of the first party does not twist in the second party's frame: with the axes D that turn with it and where
/// they start, E, `(D_y . E_z - D_z . E_y) / 2 = 0`.
pub fn hold_twist(joint: &mut Builder) {
    let Some((y, Some(z))) = joint.section(0) else { return };
    let [own_y, own_z] = [y, z].map(|axis| joint.fixed(0, axis));
    let [start_y, start_z] = [y, z].map(|axis| joint.matching(1, axis));
    let turned = |own: MarkerId, start: MarkerId| dot(&joint.value(own), &joint.value(start));
    let row = subtract(turned(own_y, start_z), turned(own_z, start_y));
    joint.row("twist", multiply(number(0.5), row));
}

/// `sin(a - f)` from the sine and cosine of a.
pub fn behind(sine: Expr, cosine: Expr, f: &Expr) -> Expr {
    subtract(
        multiply(sine, call(Function::Cos, f.clone())),
        multiply(cosine, call(Function::Sin, f.clone())),
    )
}
