//! Joints between the ends of bodies and frames.

use super::expr::Scope;
use super::plane::normal;
use super::quantity::Wanted;
use super::{Check, Shape, body, fold, say};
use crate::errors::Area;
use crate::model::{BodyId, Joint, JointId, JointKind, Location};
use crate::parse::tree::{Call, Expr, ExprKind, Item, ItemKind, Keyword};
use crate::suggest;

/// What other items need to know of a joint; `None`: reported.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    pub id: JointId,
    pub kind: Option<JointKind>,
    pub body: Option<body::Known>,
}

const POINT: Wanted = Wanted {
    what: "the point of a joint",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const PLACE: Wanted = Wanted {
    what: "the place on a body",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};

/// A place on a body, as written.
pub struct Place {
    pub body: body::Known,
    pub at: Location,
}

impl<'a> Check<'a> {
    pub(super) fn joints(&mut self) {
        let mut ends: Vec<(BodyId, Location, usize)> = Vec::new();
        let mut tied: Vec<BodyId> = Vec::new();
        let mut complete = self.tree.complete;
        for (at, item) in self.items(Keyword::Joint).into_iter().enumerate() {
            let mut known = Known {
                id: JointId(at),
                kind: None,
                body: None,
            };
            if let ItemKind::Joint(call) = &item.kind {
                self.joint(item, call, &mut known, &mut ends);
            }
            match known.body {
                Some(body) => tied.push(body.id),
                None => complete = false,
            }
            self.joints.insert(item.name.text.as_str(), known);
        }
        if complete {
            self.floating(&tied);
        }
    }

    fn floating(&mut self, tied: &[BodyId]) {
        for (at, item) in self.items(Keyword::Body).into_iter().enumerate() {
            if !tied.contains(&BodyId(at)) {
                let ItemKind::Body { frame, .. } = &item.kind else {
                    continue;
                };
                // A free frame needs ties of its own.
                let carrier = self.bodies.get(item.name.text.as_str()).and_then(|body| body.frame);
                if carrier.is_none_or(|frame| self.model.frames[frame.0].free.is_some()) {
                    continue;
                }
                let frame = frame.as_ref().map_or("inertial", |frame| frame.text.as_str());
                self.errors.at(item.name.span, say::floating(&item.name.text, frame));
            }
        }
    }

    fn joint(&mut self, item: &Item, call: &'a Call, known: &mut Known, ends: &mut Vec<(BodyId, Location, usize)>) {
        let (kind, usage) = match call.name.text.as_str() {
            "clamp" => (JointKind::Clamp, "clamp(beam.start, hub)"),
            "clamp_full" => (JointKind::ClampFull, "clamp_full(beam.start, hub)"),
            "pin" => (JointKind::Pin, "pin(beam.end, inertial, at = [8, 0, 0] m)"),
            other => {
                let message = suggest::unknown("joint", other, ["clamp", "clamp_full", "pin"]);
                self.errors.at(call.name.span, message);
                return;
            }
        };
        known.kind = Some(kind);
        let shape = Shape {
            positional: 2,
            named: &["at"],
            required: &[],
            usage,
        };
        let Some(arguments) = self.arguments(call, &shape) else {
            return;
        };
        let place = self.place(arguments.positional[0]);
        let frame = self.frame_argument(arguments.positional[1]);
        let point = arguments
            .named
            .get("at")
            .map(|point| self.vector(point, Scope::Parameter, POINT));
        let Some(Place { body, at }) = place else {
            return;
        };
        known.body = Some(body);
        if let Location::At(_) = at {
            self.errors.at(arguments.positional[0].area, say::JOINT_INSIDE);
            return;
        }
        let line = Area::from(item.name.span).line();
        if let Some((.., first)) = ends.iter().find(|(other, end, _)| *other == body.id && *end == at) {
            self.errors
                .at(arguments.positional[0].area, say::end_twice(&first.to_string()));
        } else {
            ends.push((body.id, at.clone(), line));
        }
        if let (Some(frame), Some(normal)) = (frame, body.space.and_then(normal)) {
            self.keeps_plane(frame, normal, arguments.positional[1].area);
        }
        if let (Some(Some(point)), Some(space)) = (&point, body.space) {
            self.in_plane(point, space, "the point of the joint", true);
        }
        let point = match point {
            Some(None) => return,
            Some(Some(point)) => Some(point.values),
            None => None,
        };
        if let Some(frame) = frame {
            let (name, doc) = (item.name.text.clone(), item.doc.clone());
            self.model.joints.push(Joint {
                name,
                doc,
                kind,
                body: body.id,
                at,
                frame,
                point,
            });
        }
    }

    /// `beam.start`, `beam.end` or `beam.at(4 m)`.
    pub(super) fn place(&mut self, expr: &'a Expr) -> Option<Place> {
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            self.errors.at(expr.area, say::PLACE_EXPECTED);
            return None;
        };
        let ExprKind::Name(name) = &base.kind else {
            self.errors.at(expr.area, say::PLACE_EXPECTED);
            return None;
        };
        let item = self.item(name, Keyword::Body)?;
        let body = *self.bodies.get(item.name.text.as_str())?;
        let at = match (field.text.as_str(), arguments) {
            ("start", None) => Location::Start,
            ("end", None) => Location::End,
            ("at", Some(arguments)) => match arguments.as_slice() {
                [argument] if argument.name.is_none() => {
                    let at = self.quantity(&argument.value, Scope::Parameter, PLACE)?;
                    self.on_axis(&argument.value, fold::constant(&at), body.length);
                    Location::At(Box::new(at))
                }
                _ => {
                    self.errors.at(expr.area, say::usage("at", "beam.at(4 m)"));
                    return None;
                }
            },
            ("at", None) => {
                self.errors.at(field.span, say::usage("at", "beam.at(4 m)"));
                return None;
            }
            ("start" | "end", Some(_)) => {
                self.errors.at(expr.area, say::no_arguments(&field.text));
                return None;
            }
            (other, _) => {
                self.errors.at(
                    field.span,
                    suggest::unknown("place on a body", other, ["start", "end", "at"]),
                );
                return None;
            }
        };
        Some(Place { body, at })
    }

    fn on_axis(&mut self, expr: &Expr, at: Option<f64>, length: Option<f64>) {
        if let Some(at) = at
            && (at < 0.0 || length.is_some_and(|length| at > length * (1.0 + 1e-12)))
        {
            let length = length.map_or("its length".into(), |length| format!("{length} m"));
            self.errors.at(expr.area, say::beyond(&length));
        }
    }
}
