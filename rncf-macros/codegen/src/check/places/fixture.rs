//! Fixtures: rigid parts glued to frames or to places of flexible bodies (THEORY 5.4).

use super::place::Place;
use crate::check::frames::plane::normal;
use crate::check::frames::rigid::zeros;
use crate::check::values::quantity::{self, Wanted};
use crate::check::values::scope::Scope;
use crate::check::{Check, fold, say};
use crate::joints::algebra;
use crate::model::{Expr as Value, Fixture, FrameId, FrameTie, Motions, RepeatId, RigidPart};
use crate::parse::tree::{Expr, ExprKind, Fields, Item, ItemKind, Keyword, Name};
use crate::suggest;

const PLACE: Wanted = Wanted {
    what: "the place of a fixture",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const OFFSET: Wanted = Wanted {
    what: "the offset",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const GYRATION: Wanted = Wanted {
    what: "the radius of gyration",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};

const CENTER: Wanted = Wanted {
    what: "the centre of mass",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};

impl<'a> Check<'a> {
    pub(in crate::check) fn fixtures(&mut self) {
        for item in self.items(Keyword::Fixture) {
            let ItemKind::Fixture { place, fields } = &item.kind else {
                continue;
            };
            match root(place) {
                Some(name) if self.is_frame(&name.text) && item.repeat.is_some() => {
                    self.errors.at(place.area, say::FIXTURE_NOT_REPEATED);
                }
                Some(name) if self.is_frame(&name.text) => self.on_frame(item, place, fields),
                Some(name) if !self.names.contains_key(name.text.as_str()) => self.unknown_carrier(name),
                _ => self.in_loop(item, |check| check.on_body(item, place, fields)),
            }
        }
    }

    fn unknown_carrier(&mut self, name: &Name) {
        if self.is_news(&name.text) {
            let known = self.known(&[Keyword::Frame, Keyword::Rigid, Keyword::Body]);
            let message = suggest::unknown("frame or body", &name.text, known);
            self.errors.at(name.span, message);
        }
    }

    /// A rigid part of a free frame.
    fn on_frame(&mut self, item: &'a Item, place: &'a Expr, fields: &'a Fields) {
        let given = self.fields(fields, "a `fixture` on a frame", &["mass", "inertia"]);
        let mass = self.mass(item, fields, &given, "mass = 2 kg;");
        let Some((frame, center)) = self.place_on_frame(place) else {
            return;
        };
        let declared = &self.model.frames[frame.0];
        let (name, is_body) = (
            declared.name.clone(),
            declared.free.as_ref().is_some_and(|free| free.is_body),
        );
        let Some(motions) = declared.free.as_ref().map(|free| free.motions) else {
            self.errors.at(place.area, say::fixture_on_prescribed(&name));
            return;
        };
        let normal = match motions {
            Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
            _ => None,
        };
        let inertia = match given.get("inertia") {
            Some((_, inertia)) => self.inertia(item, inertia, normal, false),
            None => Some(zeros()),
        };
        if let Some(center) = &center {
            if let Some(normal) = normal
                && !self.is_flat(center, normal, PLACE.what)
            {
                return;
            }
            if matches!(motions, Motions::Shifting | Motions::ShiftingPlanar { .. })
                && center.constant() != Some([0.0; 3])
            {
                self.errors.at(center.area, say::point_mass(&name, "at(..)"));
                return;
            }
        }
        if let (Motions::Shifting | Motions::ShiftingPlanar { .. }, Some((area, _))) = (motions, given.get("inertia")) {
            self.errors.at(*area, say::point_mass(&name, "inertia"));
            return;
        }
        let follows = |body: &&crate::model::Body| body.frame == frame && body.tie != FrameTie::Joints;
        if let Some(body) = self.model.bodies.iter().find(follows).filter(|_| !is_body) {
            let message = say::fixture_on_tied(&name, body.tie.describe(), &body.name);
            self.errors.at(place.area, message);
            return;
        }
        let (Some(mass), Some(inertia)) = (mass, inertia) else {
            return;
        };
        let part = RigidPart {
            name: item.name.text.clone(),
            mass,
            center: center.map_or_else(zeros, |center| center.values),
            inertia,
        };
        if let Some(free) = &mut self.model.frames[frame.0].free {
            free.parts.push(part);
        }
    }

    /// `arm` or `arm.at([x, y, z] m)`; without a point the origin.
    fn place_on_frame(&mut self, place: &'a Expr) -> Option<(FrameId, Option<quantity::Vector>)> {
        match &place.kind {
            ExprKind::Name(name) => Some((self.frame(name)?, None)),
            ExprKind::Member { base, field, arguments } => {
                let ExprKind::Name(name) = &base.kind else {
                    self.errors.at(place.area, say::FIXTURE_PLACE);
                    return None;
                };
                let frame = self.frame(name)?;
                if field.text != "at" {
                    let message = suggest::unknown("place on a frame for a fixture", &field.text, ["at"]);
                    self.errors.at(field.span, message);
                    return None;
                }
                match arguments.as_deref() {
                    Some([point]) if point.name.is_none() => {
                        let point = self.vector(&point.value, Scope::Parameter, PLACE)?;
                        Some((frame, Some(point)))
                    }
                    _ => {
                        self.errors.at(place.area, say::usage("at", "arm.at([1, 0, 0] m)"));
                        None
                    }
                }
            }
            _ => {
                self.errors.at(place.area, say::FIXTURE_PLACE);
                None
            }
        }
    }

    /// A fixture at a place of a flexible body.
    fn on_body(&mut self, item: &'a Item, place: &'a Expr, fields: &'a Fields) {
        let Some(at) = self.place_on_body(place) else {
            // What does not hang on the place is checked all the same.
            let all = ["mass", "offset", "gyration", "center", "inertia", "section"];
            self.fields(fields, "a `fixture` on a flexible body", &all);
            return;
        };
        let part = if at.has_section {
            self.on_section(item, &at, fields)
        } else {
            self.on_line(item, fields).map(|constants| (constants, false))
        };
        let is_finite = |check: &mut Self, value: &Value| check.is_finite(value, item.name.span.into()).is_some();
        let part = part.filter(|(constants, _)| constants.iter().all(|value| is_finite(self, value)));
        if let Some((constants, elastic)) = part {
            self.model.fixtures.push(Fixture {
                repeat: item.repeat.map(RepeatId),
                name: item.name.text.clone(),
                doc: item.doc.clone(),
                body: at.body.id,
                at: at.at,
                constants,
                elastic,
            });
        }
    }

    fn place_on_body(&mut self, place: &'a Expr) -> Option<Place> {
        if root(place).is_none() {
            self.errors.at(place.area, say::FIXTURE_PLACE);
            return None;
        }
        let place = self.place(place)?;
        // Of a body with mistakes nothing is known about its sections.
        self.body_of(place.body.id)?;
        Some(place)
    }

    /// On a centre line: mass and moments along the slope.
    fn on_line(&mut self, item: &'a Item, fields: &'a Fields) -> Option<[Value; 10]> {
        let given = self.fields(fields, "a `fixture` on a centre line", &["mass", "offset", "gyration"]);
        let mass = self.mass(item, fields, &given, "mass = 2 kg;");
        let mut length = |word: &str, wanted: Wanted| match given.get(word) {
            Some((_, expr)) => self.quantity(expr, Scope::Parameter, wanted),
            None => Some(Value::Number(0.0)),
        };
        let (offset, gyration) = (length("offset", OFFSET), length("gyration", GYRATION));
        if let (Some(value), Some((_, expr))) = (&gyration, given.get("gyration"))
            && self.default(value) < 0.0
        {
            self.errors.at(expr.area, say::not_negative(GYRATION.what));
            return None;
        }
        let (mass, offset, gyration) = (mass?, offset?, gyration?);
        let second = sum(square(&offset), square(&gyration));
        let mut constants = zeros();
        constants[0] = mass.clone();
        constants[1] = product(mass.clone(), offset);
        constants[4] = product(mass, second);
        Some(constants)
    }

    /// On a section: mass, centre of mass and inertia about it in the section's axes. With the inertia J
    /// the second moments of the mass are `tr J / 2 - J + m c c^T`. Then whether the section goes on to strain.
    fn on_section(&mut self, item: &'a Item, place: &Place, fields: &'a Fields) -> Option<([Value; 10], bool)> {
        let known = ["mass", "center", "inertia", "section"];
        let given = self.fields(fields, "a `fixture` on a section", &known);
        let elastic = match given.get("section") {
            Some((_, word)) => self.section_word(word),
            None => Some(false),
        };
        let mass = self.mass(item, fields, &given, "mass = 2 kg;");
        // x along the body, y in the plane, z along its normal.
        let normal = place.body.space.and_then(normal).map(|_| 2);
        let center = match given.get("center") {
            Some((_, expr)) => self.vector(expr, Scope::Parameter, CENTER).map(Some),
            None => Some(None),
        };
        let inertia = match given.get("inertia") {
            Some((_, inertia)) => self.inertia(item, inertia, normal, false),
            None => Some(zeros()),
        };
        if let (Some(Some(center)), Some(normal)) = (&center, normal)
            && fold::constant(&center.values[normal]) != Some(0.0)
        {
            self.errors.at(center.areas[normal], say::PLANAR_CENTER);
            return None;
        }
        let (mass, center, inertia, elastic) = (mass?, center?, inertia?, elastic?);
        let center = center.map_or_else(zeros, |center| center.values);
        let mut constants = zeros();
        constants[0] = mass.clone();
        let first = center.clone().map(|component| product(mass.clone(), component));
        let second = second_moments(&inertia, normal.is_some());
        for (at, component) in first.iter().enumerate() {
            constants[1 + at] = component.clone();
        }
        for (at, [i, j]) in ENTRIES.into_iter().enumerate() {
            let offset = product(first[i].clone(), center[j].clone());
            constants[4 + at] = sum(second[at].clone(), offset);
        }
        Some((constants, elastic))
    }

    /// What becomes of the section: whether it is elastic.
    fn section_word(&mut self, expr: &Expr) -> Option<bool> {
        match &expr.kind {
            ExprKind::Name(name) if name.text == "elastic" => Some(true),
            _ => {
                self.errors.at(expr.area, say::SECTION_OF_FIXTURE);
                None
            }
        }
    }
}

/// Rows and columns of xx, yy, zz, xy, xz, yz.
const ENTRIES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

/// `tr J / 2 - J`. In a plane only the sum of the first two is known, which is all that a rigid motion
/// needs: each has half of it.
fn second_moments(inertia: &[Value; 6], is_planar: bool) -> [Value; 6] {
    let [xx, yy, zz, xy, xz, yz] = inertia.clone();
    let half = |value: Value| product(Value::Number(0.5), value);
    if is_planar {
        let mut moments = zeros();
        (moments[0], moments[1]) = (half(zz.clone()), half(zz));
        return moments;
    }
    let rest = |a: &Value, b: &Value, c: &Value| half(sum(sum(a.clone(), b.clone()), negative(c.clone())));
    [
        rest(&yy, &zz, &xx),
        rest(&xx, &zz, &yy),
        rest(&xx, &yy, &zz),
        negative(xy),
        negative(xz),
        negative(yz),
    ]
}

/// The name that a place begins with.
fn root(place: &Expr) -> Option<&Name> {
    match &place.kind {
        ExprKind::Name(name) | ExprKind::Indexed { base: name, .. } => Some(name),
        ExprKind::Member { base, .. } => root(base),
        _ => None,
    }
}

fn product(a: Value, b: Value) -> Value {
    folded(algebra::multiply(a, b))
}

fn sum(a: Value, b: Value) -> Value {
    folded(algebra::add(a, b))
}

fn negative(a: Value) -> Value {
    folded(algebra::negate(a))
}

fn square(a: &Value) -> Value {
    product(a.clone(), a.clone())
}

fn folded(value: Value) -> Value {
    fold::constant(&value).map_or(value, Value::Number)
}
