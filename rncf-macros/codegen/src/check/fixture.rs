//! Fixtures: rigid parts glued to frames or to places of flexible bodies (THEORY 5.4).

use super::expr::Scope;
use super::quantity::Wanted;
use super::rigid::zeros;
use super::{Check, fold, say};
use crate::model::{Binary, Expr as Value, Fixture, FrameId, Motions, RigidPart};
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

impl<'a> Check<'a> {
    pub(super) fn fixtures(&mut self) {
        for item in self.items(Keyword::Fixture) {
            let ItemKind::Fixture { place, fields } = &item.kind else {
                continue;
            };
            match root(place) {
                Some(name) if self.is_frame(&name.text) => self.on_frame(item, place, fields),
                Some(name) if !self.names.contains_key(name.text.as_str()) => self.unknown_carrier(name),
                _ => self.on_body(item, place, fields),
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
            Some((_, inertia)) => self.inertia(inertia, normal, false),
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
        let follows = |body: &&crate::model::Body| body.frame == frame && body.mean_axes;
        if let Some(body) = self.model.bodies.iter().find(follows).filter(|_| !is_body) {
            let message = say::fixture_on_mean_axes(&name, &body.name);
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
    fn place_on_frame(&mut self, place: &'a Expr) -> Option<(FrameId, Option<super::quantity::Vector>)> {
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

    /// A fixture at a place of a flexible body: mass and moments along the slope.
    fn on_body(&mut self, item: &'a Item, place: &'a Expr, fields: &'a Fields) {
        let given = self.fields(
            fields,
            "a `fixture` on a flexible body",
            &["mass", "offset", "gyration"],
        );
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
            return;
        }
        if root(place).is_none() {
            self.errors.at(place.area, say::FIXTURE_PLACE);
            return;
        }
        if let (Some(place), Some(mass), Some(offset), Some(gyration)) = (self.place(place), mass, offset, gyration) {
            let second = sum(square(&offset), square(&gyration));
            self.model.fixtures.push(Fixture {
                name: item.name.text.clone(),
                doc: item.doc.clone(),
                body: place.body.id,
                at: place.at,
                constants: {
                    let mut constants = std::array::from_fn(|_| Value::Number(0.0));
                    constants[0] = mass.clone();
                    constants[1] = product(mass.clone(), offset);
                    constants[4] = product(mass, second);
                    constants
                },
            });
        }
    }
}

/// The name that a place begins with.
fn root(place: &Expr) -> Option<&Name> {
    match &place.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Member { base, .. } => root(base),
        _ => None,
    }
}

fn product(a: Value, b: Value) -> Value {
    folded(Value::Binary(Binary::Multiply, Box::new(a), Box::new(b)))
}

fn sum(a: Value, b: Value) -> Value {
    folded(Value::Binary(Binary::Add, Box::new(a), Box::new(b)))
}

fn square(a: &Value) -> Value {
    product(a.clone(), a.clone())
}

fn folded(value: Value) -> Value {
    fold::constant(&value).map_or(value, Value::Number)
}
