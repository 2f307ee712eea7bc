//! Motions and frames. Both are added to the model after everything that they refer to.

use crate::check::values::quantity::{Typed, Wanted};
use crate::check::values::scope::Scope;
use crate::check::{Check, Shape, fold, inertial, say};
use crate::errors::Area;
use crate::model::{Expr as Value, Frame, FrameId, INERTIAL, Motion, MotionId, Rotation};
use crate::parse::tree::{Call, Expr, ExprKind, Item, ItemKind, Keyword, Name};
use crate::suggest;

const ROTATING: Shape = Shape {
    positional: 0,
    named: &["axis", "angle", "origin"],
    required: &["axis", "angle"],
    usage: "rotating(axis = z, angle = theta(t))",
};
const MOVING: Shape = Shape {
    positional: 0,
    named: &["origin"],
    required: &["origin"],
    usage: "moving(origin = [x(t), 0 m, 0 m])",
};
const ORIGIN: Wanted = Wanted {
    what: "the origin of a frame",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const AXIS: Wanted = Wanted {
    what: "an axis",
    dimension: [0; 6],
    unit: "1",
};

impl<'a> Check<'a> {
    pub(in crate::check) fn motions(&mut self) {
        for item in self.items(Keyword::Motion) {
            self.motion(item, item.name.span.into());
        }
    }

    /// A motion and what it is, resolved at its first use.
    pub(in crate::check) fn motion(&mut self, item: &'a Item, used: Area) -> Option<(MotionId, Typed)> {
        let name = item.name.text.as_str();
        if let Some(known) = self.motions.get(name) {
            return known.clone();
        }
        let ItemKind::Motion(value) = &item.kind else {
            return None;
        };
        if !self.enter(name, used) {
            return None;
        }
        let typed = self.with_lookups(|check| check.expr(value, Scope::Prescribed));
        self.leave();
        let known = typed.map(|typed| {
            let id = MotionId(self.model.motions.len());
            self.model.motions.push(Motion {
                name: name.into(),
                doc: item.doc.clone(),
                unit: typed.dimension.symbol(typed.nature.angle),
                value: typed.value.clone(),
            });
            (id, typed)
        });
        self.motions.insert(name, known.clone());
        known
    }

    pub(in crate::check) fn frames(&mut self) {
        for item in self.items(Keyword::Frame) {
            self.frame_item(item, item.name.span.into());
        }
        for item in self.items(Keyword::Rigid) {
            self.rigid_item(item, item.name.span.into());
        }
    }

    /// Whether a name is that of a frame or a rigid body, `inertial` included.
    pub(in crate::check) fn is_frame(&self, name: &str) -> bool {
        let is_declared = |item: &&Item| matches!(item.keyword, Keyword::Frame | Keyword::Rigid);
        name == "inertial" || self.names.get(name).is_some_and(is_declared)
    }

    /// The frame or rigid body with this name.
    pub(in crate::check) fn frame(&mut self, name: &Name) -> Option<FrameId> {
        if name.text == "inertial" {
            return Some(INERTIAL);
        }
        if !self.names.contains_key(name.text.as_str()) {
            if self.is_news(&name.text) {
                let known = self
                    .known(&[Keyword::Frame, Keyword::Rigid])
                    .into_iter()
                    .chain(["inertial"])
                    .collect::<Vec<_>>();
                self.errors.at(name.span, suggest::unknown("frame", &name.text, known));
            }
            return None;
        }
        if let Some(item) = self.names.get(name.text.as_str()).copied()
            && item.keyword == Keyword::Rigid
        {
            return self.rigid_item(item, name.span.into());
        }
        let item = self.item(name, Keyword::Frame)?;
        self.frame_item(item, name.span.into())
    }

    /// The frame that an argument names.
    pub(in crate::check) fn frame_argument(&mut self, expr: &'a Expr) -> Option<FrameId> {
        match &expr.kind {
            ExprKind::Name(name) => self.frame(name),
            _ => {
                self.errors.at(expr.area, say::FRAME_EXPECTED);
                None
            }
        }
    }

    fn frame_item(&mut self, item: &'a Item, used: Area) -> Option<FrameId> {
        let name = item.name.text.as_str();
        if let Some(known) = self.frames.get(name) {
            return *known;
        }
        let ItemKind::Frame { parent, call } = &item.kind else {
            return None;
        };
        if !self.enter(name, used) {
            return None;
        }
        let carrier = parent.as_ref().map_or(Some(INERTIAL), |parent| self.frame(parent));
        let frame = self.frame_in(name, parent.as_ref(), carrier, call);
        self.leave();
        let id = frame.map(|frame| {
            let id = FrameId(self.model.frames.len());
            let (name, doc) = (name.to_string(), item.doc.clone());
            self.model.frames.push(Frame { name, doc, ..frame });
            id
        });
        self.frames.insert(name, id);
        id
    }

    /// A frame in its parent, without name and documentation.
    fn frame_in(&mut self, name: &str, word: Option<&Name>, parent: Option<FrameId>, call: &'a Call) -> Option<Frame> {
        let is_rotating = match call.name.text.as_str() {
            "rotating" => true,
            "moving" => false,
            "free" | "turning" | "hinged" => {
                let moves = self.free_frame(call);
                let parent = self.carrier(name, word, parent, moves.as_ref())?;
                return moves.map(|moves| moves.frame(parent));
            }
            other => {
                let known = ["rotating", "moving", "free", "turning", "hinged"];
                self.errors
                    .at(call.name.span, suggest::unknown("motion of a frame", other, known));
                return None;
            }
        };
        let motion = self.frame_motion(call, is_rotating);
        let parent = parent?;
        if let Some(word) = word.filter(|_| self.model.frames[parent.0].free.is_some()) {
            self.errors.at(word.span, say::prescribed_in_free(&word.text));
            return None;
        }
        let (origin, rotation) = motion?;
        Some(Frame {
            parent,
            origin,
            rotation,
            ..inertial()
        })
    }

    fn frame_motion(&mut self, call: &'a Call, is_rotating: bool) -> Option<([Value; 3], Option<Rotation>)> {
        let arguments = self.arguments(call, if is_rotating { &ROTATING } else { &MOVING })?;
        let origin = match arguments.named.get("origin") {
            Some(expr) => self
                .with_lookups(|check| check.vector(expr, Scope::Prescribed, ORIGIN))
                .filter(|origin| self.is_smooth(expr.area, &origin.values))
                .map(|origin| origin.values),
            None => Some(inertial().origin),
        };
        if !is_rotating {
            return Some((origin?, None));
        }
        let axis = self.axis(arguments.named["axis"]);
        let expr = arguments.named["angle"];
        let angle = self
            .with_lookups(|check| check.angle(expr, Scope::Prescribed, "the angle of a frame"))
            .filter(|angle| self.is_smooth(expr.area, [angle]));
        Some((
            origin?,
            Some(Rotation {
                axis: axis?,
                angle: angle?,
            }),
        ))
    }

    /// `x`, `y`, `z` or a constant vector; normalised.
    pub(in crate::check) fn axis(&mut self, expr: &'a Expr) -> Option<[f64; 3]> {
        if let ExprKind::Name(name) = &expr.kind {
            let axis = match name.text.as_str() {
                "x" => [1.0, 0.0, 0.0],
                "y" => [0.0, 1.0, 0.0],
                "z" => [0.0, 0.0, 1.0],
                other => {
                    self.errors
                        .at(name.span, suggest::unknown("axis", other, ["x", "y", "z", "[0, 0, 1]"]));
                    return None;
                }
            };
            return Some(axis);
        }
        let vector = self.vector(expr, Scope::Parameter, AXIS)?;
        let axis = vector.values.each_ref().map(fold::constant);
        let [Some(x), Some(y), Some(z)] = axis else {
            self.errors.at(expr.area, say::AXIS_CONSTANT);
            return None;
        };
        let norm = x.hypot(y).hypot(z);
        if !(norm > 0.0 && norm.is_finite()) {
            self.errors.at(expr.area, say::AXIS_ZERO);
            return None;
        }
        Some([x / norm, y / norm, z / norm])
    }
}
