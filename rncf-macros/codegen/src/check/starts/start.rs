//! The system at t = 0 with the defaults of the parameters: poses, places, markers.

use crate::check::bodies::curve::Curve;
use crate::check::values::arithmetic::{Matrix, Vector, add, cross, dot, norm, scale, subtract, unit};
use crate::model::fold::{self, of_repetition};
use crate::model::{BodyId, Expr, FrameId, INERTIAL, Line, Location, Marker, MarkerId, Model, Space};
use crate::symbolic::{along_axis, path_of};

/// Sine of the angle below which two directions count as parallel.
const PARALLEL: f64 = 1e-6;

/// One plus the cosine of directions that count as opposite.
const OPPOSITE: f64 = 1e-12;

/// Where a frame is: rotation to inertial axes, and origin in them.
#[derive(Clone, Copy)]
pub struct Pose {
    pub turn: Matrix,
    pub origin: Vector,
}

impl Pose {
    /// A vector of the frame in inertial axes.
    pub fn direction(&self, along: Vector) -> Vector {
        self.turn.map(|row| dot(row, along))
    }

    /// A point of the frame in the inertial frame.
    pub fn point(&self, at: Vector) -> Vector {
        add(self.origin, self.direction(at))
    }
}

/// Unit vector of the part of a direction across a unit vector; `None` where there is none.
fn across(direction: Vector, along: Vector) -> Option<Vector> {
    let part = subtract(direction, scale(dot(direction, along), along));
    let is_across = norm(direction).is_finite() && norm(part) > PARALLEL * norm(direction);
    is_across.then(|| unit(part)).flatten()
}

/// A vector turned by the smallest rotation that takes a unit vector to another one; opposite ones turn
/// about `about`.
fn turned(vector: Vector, from: Vector, to: Vector, about: Vector) -> Vector {
    let (axis, cosine) = (cross(from, to), dot(from, to));
    if 1.0 + cosine < OPPOSITE {
        return subtract(scale(2.0 * dot(about, vector), about), vector);
    }
    let first = cross(axis, vector);
    add(add(vector, first), scale(1.0 / (1.0 + cosine), cross(axis, first)))
}

/// Two unit vectors that make a right-handed triad with a unit vector.
pub fn normals(along: Vector) -> [Vector; 2] {
    let least = (0..3)
        .min_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs()))
        .unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let first = unit(subtract(axis, scale(dot(axis, along), along))).unwrap_or(axis);
    [first, cross(along, first)]
}

fn rotation(axis: Vector, angle: f64) -> Matrix {
    let (sine, cosine) = angle.sin_cos();
    let column = |k: usize| {
        let mut e = [0.0; 3];
        e[k] = 1.0;
        let along = scale((1.0 - cosine) * dot(axis, e), axis);
        add(add(scale(cosine, e), along), scale(sine, cross(axis, e)))
    };
    let columns = [column(0), column(1), column(2)];
    std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]))
}

/// Values at t = 0, of repeated items in one repetition.
pub struct Start<'m> {
    pub model: &'m Model,
    index: f64,
}

impl<'m> Start<'m> {
    /// In the first repetition.
    pub fn new(model: &'m Model) -> Self {
        Self { model, index: 0.0 }
    }

    /// In the repetition that a place is on.
    fn on(&self, at: &Location) -> Self {
        Self {
            model: self.model,
            index: at.instance().map_or(self.index, |instance| self.value(instance)),
        }
    }

    /// Value of an expression that observes nothing.
    pub fn value(&self, expr: &Expr) -> f64 {
        of_repetition(self.model, expr, 0.0, self.index).unwrap_or(f64::NAN)
    }

    pub fn vector(&self, exprs: &[Expr; 3]) -> Vector {
        exprs.each_ref().map(|expr| self.value(expr))
    }

    pub fn pose(&self, frame: FrameId) -> Pose {
        if frame == INERTIAL {
            return Pose {
                turn: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                origin: [0.0; 3],
            };
        }
        let declared = &self.model.frames[frame.0];
        let parent = self.pose(declared.parent);
        let origin = parent.point(self.vector(&declared.origin));
        let Some(own) = &declared.rotation else {
            return Pose {
                turn: parent.turn,
                origin,
            };
        };
        let own = rotation(unit(own.axis).unwrap_or([0.0; 3]), self.value(&own.angle));
        let columns: [Vector; 3] = std::array::from_fn(|j| parent.direction([own[0][j], own[1][j], own[2][j]]));
        Pose {
            turn: std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])),
            origin,
        }
    }

    /// Place and unit tangent of the undeformed body in its frame.
    pub fn place(&self, body: BodyId, at: &Location) -> (Vector, Vector) {
        if let Location::Of { place, .. } = at {
            return self.on(at).place(body, place);
        }
        let x = self.arclength(body, at);
        match &self.model.bodies[body.0].line {
            Line::Straight { from, to } => {
                let (from, to) = (self.vector(from), self.vector(to));
                let way = subtract(to, from);
                let tangent = unit(way).unwrap_or([0.0; 3]);
                (add(from, scale(x, tangent)), tangent)
            }
            Line::Arc {
                from,
                direction,
                normal,
                radius,
                angle,
            } => {
                let (direction, normal) = self.plane_of_arc(direction, normal);
                let (radius, angle) = (self.value(radius), self.value(angle));
                let normal = scale(angle.signum(), normal);
                let inwards = cross(normal, direction);
                let (sine, cosine) = (x / radius).sin_cos();
                let way = add(scale(radius * sine, direction), scale(radius * (1.0 - cosine), inwards));
                (
                    add(self.vector(from), way),
                    add(scale(cosine, direction), scale(sine, inwards)),
                )
            }
            line @ (Line::Curve { .. } | Line::Path { .. }) => {
                self.curve(line).map_or(([0.0; 3], [0.0; 3]), |curve| curve.at(x))
            }
            Line::Imported(imported) => (imported.places[x as usize], [1.0, 0.0, 0.0]),
        }
    }

    /// Place and slope of the body in its frame at t = 0; the slope of an initial shape is no unit
    /// vector.
    pub fn initial_place(&self, body: BodyId, at: &Location) -> (Vector, Vector) {
        if let Location::Of { place, .. } = at {
            return self.on(at).initial_place(body, place);
        }
        let Some(position) = &self.model.bodies[body.0].initial.position else {
            return self.place(body, at);
        };
        let [place, slope] = along_axis(self.model, position, self.arclength(body, at), self.index);
        (place, slope)
    }

    /// Unit tangent at the start of an arc, and the unit normal of its plane.
    fn plane_of_arc(&self, direction: &[Expr; 3], normal: &[Expr; 3]) -> (Vector, Vector) {
        let direction = unit(self.vector(direction)).unwrap_or([0.0; 3]);
        let normal = across(self.vector(normal), direction).unwrap_or([0.0; 3]);
        (direction, normal)
    }

    /// Unit vectors along the y and z axes of a section of the undeformed body in its frame. On an arc they
    /// turn with the tangent about the normal, and everywhere about the tangent by the twist.
    fn section(&self, id: BodyId, at: &Location) -> [Vector; 2] {
        let (_, tangent) = self.place(id, at);
        let body = &self.model.bodies[id.0];
        if let Space::Planar { normal } = body.space {
            let mut axis = [0.0; 3];
            axis[normal] = 1.0;
            return [cross(axis, tangent), axis];
        }
        let (_, start) = self.place(id, &Location::Start);
        let wanted = match &body.section_y {
            Some(declared) => self.vector(declared),
            None => {
                let side = cross([0.0, 0.0, 1.0], start);
                if norm(side) > PARALLEL { side } else { [0.0, 1.0, 0.0] }
            }
        };
        // On a curve every section is oriented by itself.
        let start = if matches!(body.line, Line::Curve { .. } | Line::Path { .. }) {
            tangent
        } else {
            start
        };
        let first = across(wanted, start).unwrap_or_else(|| normals(start)[0]);
        let part = self.arclength(id, at) / self.length(id);
        let turned = match &body.line {
            Line::Straight { .. } | Line::Curve { .. } | Line::Path { .. } | Line::Imported(_) => first,
            Line::Arc {
                direction,
                normal,
                angle,
                ..
            } => {
                let (_, normal) = self.plane_of_arc(direction, normal);
                rotation(normal, part * self.value(angle)).map(|row| dot(row, first))
            }
        };
        let side = cross(tangent, turned);
        let twist = if fold::has_arclength(&body.twist) {
            let (from, whole) = match &body.piece {
                Some(piece) => (self.value(&piece.from), self.value(&piece.whole)),
                None => (0.0, self.length(id)),
            };
            fold::along(self.model, &body.twist, from + self.arclength(id, at), whole)
        } else {
            part * self.value(&body.twist)
        };
        let (sine, cosine) = twist.sin_cos();
        let y = add(scale(cosine, turned), scale(sine, side));
        [y, cross(tangent, y)]
    }

    /// The same at t = 0: with an initial shape they turn with the tangent by the smallest rotation.
    pub fn initial_section(&self, body: BodyId, at: &Location) -> [Vector; 2] {
        if let Location::Of { place, .. } = at {
            return self.on(at).initial_section(body, place);
        }
        let axes = self.section(body, at);
        let (_, tangent) = self.place(body, at);
        let (_, slope) = self.initial_place(body, at);
        match unit(slope) {
            Some(slope) => axes.map(|axis| turned(axis, tangent, slope, axes[0])),
            None => axes,
        }
    }

    /// Arclength of a place, m.
    fn arclength(&self, body: BodyId, at: &Location) -> f64 {
        match at {
            Location::Start => 0.0,
            Location::End => self.length(body),
            Location::At(x) => self.value(x),
            Location::Part(part) => self.value(part) * self.length(body),
            Location::Of { place, .. } => self.arclength(body, place),
        }
    }

    /// The curve that a line is; of a straight line and an arc closed forms are known.
    fn curve(&self, line: &Line) -> Option<Curve<'_>> {
        match line {
            Line::Curve {
                table,
                columns,
                directions,
            } => Some(Curve::through(
                &self.model.tables[table.0].points(*columns),
                *directions,
            )),
            Line::Path { position, range } => {
                let range = range.each_ref().map(|end| self.value(end));
                Some(Curve::along(range, path_of(self.model, position, self.index)))
            }
            Line::Straight { .. } | Line::Arc { .. } | Line::Imported(_) => None,
        }
    }

    /// Length of a body's axis.
    pub fn length(&self, body: BodyId) -> f64 {
        match &self.model.bodies[body.0].line {
            Line::Straight { from, to } => norm(subtract(self.vector(to), self.vector(from))),
            Line::Arc { radius, angle, .. } => (self.value(radius) * self.value(angle)).abs(),
            line @ (Line::Curve { .. } | Line::Path { .. }) => self.curve(line).map_or(0.0, |curve| curve.length()),
            // Places on it are numbers of its interfaces.
            Line::Imported(imported) => (imported.places.len() - 1) as f64,
        }
    }

    /// A marker in inertial axes.
    pub fn marker(&self, marker: MarkerId) -> Vector {
        match &self.model.markers[marker.0] {
            Marker::Point { frame, at } => self.pose(*frame).point(self.vector(at)),
            Marker::Direction { frame, along } => self.pose(*frame).direction(self.vector(along)),
            Marker::BodyPoint { body, at } => {
                let (place, _) = self.initial_place(*body, at);
                self.pose(self.model.bodies[body.0].frame).point(place)
            }
            Marker::SectionPoint { body, at, beside } => {
                let (place, _) = self.initial_place(*body, at);
                let axes = self.initial_section(*body, at);
                let apart = beside.iter().zip(axes);
                let place = apart.fold(place, |sum, (by, axis)| add(sum, scale(self.value(by), axis)));
                self.pose(self.model.bodies[body.0].frame).point(place)
            }
            Marker::BodySlope { body, at } => {
                let (_, tangent) = self.initial_place(*body, at);
                self.pose(self.model.bodies[body.0].frame).direction(tangent)
            }
            Marker::BodySection { body, at, axis } => {
                let axes = self.initial_section(*body, at);
                self.pose(self.model.bodies[body.0].frame)
                    .direction(axes[usize::from(*axis == 2)])
            }
            Marker::InSection { marker, .. } => {
                let value = self.marker(*marker);
                unit(value).unwrap_or(value)
            }
            Marker::Turn { .. } | Marker::SectionTurn { .. } => [0.0; 3],
            Marker::Angle { frame } => {
                let rotation = self.model.frames[frame.0].rotation.as_ref();
                [rotation.map_or(0.0, |rotation| self.value(&rotation.angle)), 0.0, 0.0]
            }
            Marker::Matching { marker: other, .. } => {
                let value = self.marker(*other);
                if self.model.is_point(*other) {
                    value
                } else {
                    unit(value).unwrap_or(value)
                }
            }
            Marker::Normal { marker, which, .. } => {
                let along = unit(self.marker(*marker)).unwrap_or([0.0; 3]);
                normals(along)[(*which).min(1)]
            }
        }
    }
}
