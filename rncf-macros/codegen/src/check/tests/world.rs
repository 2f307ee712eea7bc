//! A system that moves as a test says: markers, rows and forces evaluated on it.

use super::model;
use crate::model::{Binary, BodyId, Constraint, Expr, FrameId, Location, Marker, MarkerId, Model, Observable};

pub type Vec3 = [f64; 3];
pub type Mat3 = [Vec3; 3];

/// The model of a scene with more items.
pub fn with(scene: &str, items: &str) -> Model {
    model(&format!("model M {{ {scene} {items} }}"))
}

pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] + b[i])
}
pub fn scale(s: f64, a: Vec3) -> Vec3 {
    a.map(|x| s * x)
}
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}
pub fn unit(a: Vec3) -> Vec3 {
    scale(1.0 / dot(a, a).sqrt(), a)
}
pub fn times(m: Mat3, v: Vec3) -> Vec3 {
    m.map(|row| dot(row, v))
}
pub fn transposed(m: Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}
pub fn product(a: Mat3, b: Mat3) -> Mat3 {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}
/// Rotation by the angle |w| about w (Rodrigues).
pub fn rotation(w: Vec3) -> Mat3 {
    let angle = dot(w, w).sqrt();
    let n = if angle > 0.0 { scale(1.0 / angle, w) } else { [0.0; 3] };
    let (s, c) = angle.sin_cos();
    std::array::from_fn(|i| {
        let e: Vec3 = std::array::from_fn(|j| f64::from(i == j));
        add(
            add(scale(c, e), scale(-s, cross(n, e))),
            scale((1.0 - c) * dot(n, e), n),
        )
    })
}

/// Position of the origin and axes of a frame.
#[derive(Clone, Copy)]
pub struct Pose {
    pub r: Vec3,
    pub a: Mat3,
}

/// Position, slope and section's axes of a place (by the body's name) at a time.
pub type Sections<'m> = &'m dyn Fn(&str, &Location, f64) -> [Vec3; 4];

/// A motion of all frames (by name); the beam's end is a point and a slope, unless all places have sections.
pub struct World<'m> {
    pub model: &'m Model,
    pub pose: &'m dyn Fn(&str, f64) -> Pose,
    pub sections: Option<Sections<'m>>,
    pub end: &'m dyn Fn(f64) -> [Vec3; 2],
    pub t: f64,
}

pub const STEP: f64 = 1e-5;

impl World<'_> {
    /// Position, slope and axes of a place.
    pub fn place(&self, body: BodyId, at: &Location, t: f64) -> [Vec3; 4] {
        let name = &self.model.bodies[body.0].name;
        match self.sections {
            Some(sections) => sections(name, at, t),
            None => {
                let [r, slope] = (self.end)(t);
                [r, slope, [0.0; 3], [0.0; 3]]
            }
        }
    }

    fn at(&self, frame: FrameId, t: f64) -> Pose {
        let name = self.model.frames[frame.0].name.as_str();
        if name == "inertial" {
            return Pose {
                r: [0.0; 3],
                a: rotation([0.0; 3]),
            };
        }
        (self.pose)(name, t)
    }

    pub fn marker(&self, marker: MarkerId, t: f64) -> Vec3 {
        let fixed = |v: &[Expr; 3]| v.each_ref().map(|x| self.value(x));
        let is_point = |id: MarkerId| {
            matches!(
                self.model.markers[id.0],
                Marker::Point { .. } | Marker::BodyPoint { .. } | Marker::SectionPoint { .. }
            )
        };
        match &self.model.markers[marker.0] {
            Marker::Point { frame, at } => {
                let pose = self.at(*frame, t);
                add(pose.r, times(pose.a, fixed(at)))
            }
            Marker::Direction { frame, along } => times(self.at(*frame, t).a, fixed(along)),
            Marker::BodyPoint { body, at } => self.place(*body, at, t)[0],
            Marker::SectionPoint { body, at, beside } => {
                let [r, _, y, z] = self.place(*body, at, t);
                let [by_y, by_z] = beside.each_ref().map(|by| self.value(by));
                add(r, add(scale(by_y, y), scale(by_z, z)))
            }
            Marker::BodySlope { body, at } => self.place(*body, at, t)[1],
            Marker::BodySection { body, at, axis } => self.place(*body, at, t)[1 + axis],
            Marker::InSection { body, at, marker } => {
                let other = unit(self.marker(*marker, 0.0));
                let start = self.triad(*body, at, 0.0);
                times(self.triad(*body, at, t), times(transposed(start), other))
            }
            Marker::Matching { frame, marker } => {
                let (start, now) = (self.at(*frame, 0.0), self.at(*frame, t));
                let value = self.marker(*marker, 0.0);
                if is_point(*marker) {
                    let p = times(transposed(start.a), add(value, scale(-1.0, start.r)));
                    add(now.r, times(now.a, p))
                } else {
                    times(now.a, times(transposed(start.a), unit(value)))
                }
            }
            Marker::Normal { frame, marker, which } => {
                let d = unit(self.marker(*marker, 0.0));
                let least = (0..3).min_by(|i, j| d[*i].abs().total_cmp(&d[*j].abs())).unwrap();
                let e: Vec3 = std::array::from_fn(|i| f64::from(i == least));
                let first = unit(cross(d, e));
                let normal = if *which == 0 { first } else { cross(d, first) };
                let (start, now) = (self.at(*frame, 0.0), self.at(*frame, t));
                times(now.a, times(transposed(start.a), normal))
            }
            Marker::Angle { frame } => {
                let a = self.at(*frame, t).a;
                [a[1][0].atan2(a[0][0]), 0.0, 0.0]
            }
            Marker::Turn { .. } | Marker::SectionTurn { .. } => [0.0; 3],
        }
    }

    /// The polar rotation of a section's axes; columns are the normal, y and z.
    fn triad(&self, body: BodyId, at: &Location, t: f64) -> Mat3 {
        let [_, _, y, z] = self.place(body, at, t);
        let n = unit(cross(y, z));
        let y = unit(add(y, cross(z, n)));
        transposed([n, y, cross(n, y)])
    }

    pub fn rate(&self, marker: MarkerId) -> Vec3 {
        let rotation = |t: f64| match &self.model.markers[marker.0] {
            Marker::Turn { frame } => Some(self.at(*frame, t).a),
            Marker::SectionTurn { body, at } => Some(self.triad(*body, at, t)),
            _ => None,
        };
        if let (Some(later), Some(before)) = (rotation(self.t + STEP), rotation(self.t - STEP)) {
            let w = product(later, transposed(before));
            return scale(0.25 / STEP, [w[2][1] - w[1][2], w[0][2] - w[2][0], w[1][0] - w[0][1]]);
        }
        let (later, before) = (self.marker(marker, self.t + STEP), self.marker(marker, self.t - STEP));
        scale(0.5 / STEP, add(later, scale(-1.0, before)))
    }

    pub fn value(&self, expr: &Expr) -> f64 {
        match expr {
            Expr::Number(value) => *value,
            Expr::Param(id) => self.model.params[id.0].default,
            Expr::Time => self.t,
            Expr::Motion(id, _) => self.value(&self.model.motions[id.0].value),
            Expr::Negate(inner) => -self.value(inner),
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                match operator {
                    Binary::Add => a + b,
                    Binary::Subtract => a - b,
                    Binary::Multiply => a * b,
                    Binary::Divide => a / b,
                }
            }
            Expr::Power(a, b) => self.value(a).powf(self.value(b)),
            Expr::Call(function, arguments) => match arguments.as_slice() {
                [x] => function.of(self.value(x)).unwrap(),
                [x, y] => function.of_two(self.value(x), self.value(y)).unwrap(),
                _ => panic!("one or two"),
            },
            Expr::Observed(Observable::Marker {
                marker,
                derivative,
                component,
            }) => match derivative {
                0 => self.marker(*marker, self.t)[*component],
                1 => self.rate(*marker)[*component],
                _ => panic!("no accelerations"),
            },
            other => panic!("{other:?}"),
        }
    }

    pub fn rows(&self, constraint: &Constraint) -> Vec<f64> {
        constraint.rows.iter().map(|(_, row)| self.value(row)).collect()
    }
}

/// The first body wanders and turns in space.
pub fn first_body(t: f64) -> Pose {
    Pose {
        r: [1.0 + t, t * t - 0.5, 0.3 * t.sin()],
        a: product(rotation([0.3, -0.2, 0.5]), rotation([0.4 * t, 0.7 * t, -0.2 * t])),
    }
}

pub const POINT: Vec3 = [0.5, 0.25, -0.125];

/// The second one moves by `shift` and `turn` (axes of the first one) about the joint's point.
pub fn second_body(t: f64, shift: Vec3, turn: Vec3) -> Pose {
    let first = first_body(t);
    let a = product(product(first.a, rotation(turn)), rotation([0.7, 0.1, -0.4]));
    let joint = add(first.r, times(first.a, add(POINT, shift)));
    let own = [0.2, -0.3, 0.1];
    Pose {
        r: add(joint, scale(-1.0, times(a, own))),
        a,
    }
}

pub fn still(_: f64) -> [Vec3; 2] {
    [[2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
}

/// A bent and stretched end.
pub fn bent(t: f64) -> [Vec3; 2] {
    [[2.0 - t, t, 0.3 * t], scale(1.0 + t, unit([1.0, t, -0.5 * t]))]
}

pub fn axis_of(motion: usize, amount: f64) -> (Vec3, Vec3) {
    let mut all = [0.0; 6];
    all[motion] = amount;
    ([all[0], all[1], all[2]], [all[3], all[4], all[5]])
}
