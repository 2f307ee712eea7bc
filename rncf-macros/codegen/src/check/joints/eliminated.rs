//! Conditions of flexible ends that are linear in their nodal vectors, and eliminated (THEORY 6).

use super::known::{Built, Known};
use crate::check::frames::plane::{normal, plane};
use crate::check::places::place::{Hold, Place, Spot};
use crate::check::values::repeat::has_index;
use crate::check::values::words::AXES;
use crate::check::{Check, Shape, say};
use crate::errors::Area;
use crate::joints::{self, Builder, Party};
use crate::model::{self, BodyId, Expr as Value, FrameId, Joint, JointId, JointKind, Location, RepeatId};
use crate::parse::tree::{Call, ExprKind, Item};
use crate::suggest;

/// An end that an eliminated joint holds.
pub struct Held {
    body: BodyId,
    at: Location,
    line: usize,
    /// `None`: the twist of the section.
    kind: Option<JointKind>,
    has_section: bool,
}

impl Held {
    /// The nodal vectors that it is about.
    fn vectors(&self) -> &'static [model::Held] {
        use model::Held::{Position, SectionY, SectionZ, Slope};
        let Some(kind) = self.kind else {
            return &[SectionY, SectionZ];
        };
        match kind {
            JointKind::Pin => &[Position],
            JointKind::Clamp | JointKind::ClampFull if self.has_section => &[Position, SectionY, SectionZ],
            JointKind::Clamp | JointKind::ClampFull => &[Position, Slope],
            JointKind::Hold { of: Position, .. } => &[Position],
            JointKind::Hold { of: Slope, .. } => &[Slope],
            JointKind::Hold { of: SectionY, .. } => &[SectionY],
            JointKind::Hold { of: SectionZ, .. } => &[SectionZ],
        }
    }

    /// Line of the joint, where it holds this end.
    pub fn line_at(&self, body: BodyId, at: &Location) -> Option<usize> {
        (self.body == body && self.at == *at).then_some(self.line)
    }

    /// Whether both hold the same vector of the same end; two components of one are two things.
    fn overlaps(&self, other: &Self) -> bool {
        let is_hold = |held: &Self| matches!(held.kind, None | Some(JointKind::Hold { .. }));
        let is_same = match is_hold(self) && is_hold(other) {
            true => self.kind == other.kind,
            false => self.vectors().iter().any(|vector| other.vectors().contains(vector)),
        };
        self.body == other.body && self.at == other.at && is_same
    }
}

/// Joints of flexible ends, and what is written.
pub const ENDS: &[(&str, &str)] = &[
    ("clamp", "clamp(beam.start, hub)"),
    ("clamp_full", "clamp_full(beam.start, hub)"),
    ("pin", "pin(beam.end, inertial, at = [8, 0, 0] m)"),
];
/// Words for what a `hold` can be about besides the position.
const VECTORS: &[(&str, model::Held)] = &[
    ("slope", model::Held::Slope),
    ("ey", model::Held::SectionY),
    ("ez", model::Held::SectionZ),
];

impl<'a> Check<'a> {
    /// What is eliminated: a flexible end in a prescribed frame, or in the body's own one.
    pub(in crate::check) fn eliminated(&self, word: &str, first: &Hold, second: &Hold) -> Option<JointKind> {
        let Spot::Flexible(place) = &first.spot else {
            return None;
        };
        if place.beside.is_some() {
            return None;
        }
        let (frame, own) = (second.frame()?, place.body.frame?);
        let is_linear = frame == own || !self.is_free(frame) && !self.is_free(own);
        let is_planar = place.body.space.and_then(normal).is_some();
        let kind = match word {
            "clamp" | "weld" => JointKind::Clamp,
            "clamp_full" => JointKind::ClampFull,
            "pin" | "spherical" => JointKind::Pin,
            "revolute" if is_planar => JointKind::Pin,
            _ => return None,
        };
        let is_end = !place.at.is_along() || ENDS.iter().any(|(end, _)| *end == word);
        (is_linear && is_end).then_some(kind)
    }

    /// A joint that is eliminated.
    #[allow(clippy::too_many_arguments)]
    pub(in crate::check) fn tie_end(
        &mut self,
        item: &Item,
        kind: JointKind,
        place: Place,
        frame: FrameId,
        point: Option<[Value; 3]>,
        area: [Area; 2],
        known: &mut Known,
        held: &mut Vec<Held>,
    ) -> Option<()> {
        let Place { body, at, .. } = place.clone();
        (known.kind, known.body, known.frame) = (Some(kind), Some(body), Some(frame));
        if at.is_along() {
            self.errors.at(area[0], say::JOINT_INSIDE);
            return None;
        }
        if item.repeat.is_some() && !has_index(&at) {
            self.errors.at(area[0], say::SAME_END_REPEATED);
            return None;
        }
        self.note_end(item, &place, Some(kind), area[0], held);
        if let Some(normal) = body.space.and_then(normal) {
            self.keeps_plane(frame, normal, area[1]);
        }
        // Repeated ones have no place in absolute coordinates yet: `build` says so.
        if self.is_free(frame) && item.repeat.is_none() {
            self.stand_in(item, kind, &place, frame, point.clone())?;
        }
        known.id = JointId(self.model.joints.len());
        self.model.joints.push(Joint {
            repeat: item.repeat.map(RepeatId),
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            kind,
            body: body.id,
            at,
            frame,
            point,
        });
        Some(())
    }

    /// Notes what holds an end; reports what is held twice.
    fn note_end(&mut self, item: &Item, place: &Place, kind: Option<JointKind>, area: Area, held: &mut Vec<Held>) {
        let own = Held {
            body: place.body.id,
            at: place.at.clone(),
            line: item.name.line(),
            kind,
            has_section: place.has_section,
        };
        let lacks_slope = own.vectors().contains(&model::Held::Slope) && self.has_slope(place.body.id) == Some(false);
        if lacks_slope {
            self.errors.at(area, say::NO_SLOPE);
        } else if let Some(first) = held.iter().find(|other| other.overlaps(&own)) {
            self.errors.at(area, say::end_twice(&first.line.to_string()));
        } else {
            held.push(own);
        }
    }

    /// A coordinate that is held with a multiplier: of an axis that turns with a section, or in between; `None`: the twist.
    fn hold_section(
        &mut self,
        item: &Item,
        kind: Option<JointKind>,
        place: &Place,
        area: Area,
        known: &mut Known,
        held: &mut Vec<Held>,
    ) -> Option<()> {
        let frame = place.body.frame?;
        if item.repeat.is_some() {
            self.errors.at(area, say::HOLD_NOT_REPEATED);
            return None;
        }
        self.note_end(item, place, kind, area, held);
        let parties = [place.party(), Party::Frame { frame, point: None }];
        let normal = normal(place.body.space?);
        let mut builder = Builder::new(&mut self.model.markers, parties.clone(), normal);
        match kind {
            Some(JointKind::Hold { of, axis }) => joints::hold(&mut builder, of, axis),
            _ => joints::hold_twist(&mut builder),
        }
        let rows = builder.finish();
        let constraint = self.push_constraint(item, "hold", rows, None);
        known.frame = Some(frame);
        known.built = Some(Built {
            constraint,
            word: "hold".into(),
            kind: None,
            parties,
            normal,
            axis: [0.0; 3],
            has_moment: !matches!(
                kind,
                Some(JointKind::Hold {
                    of: model::Held::Position,
                    ..
                })
            ),
            is_reversed: false,
        });
        Some(())
    }

    /// The same joint with multipliers, for where the nodal vectors are in the inertial frame.
    fn stand_in(
        &mut self,
        item: &Item,
        kind: JointKind,
        place: &Place,
        frame: FrameId,
        point: Option<[Value; 3]>,
    ) -> Option<()> {
        let parties = [place.party(), Party::Frame { frame, point }];
        let normal = normal(place.body.space?);
        let mut builder = Builder::new(&mut self.model.markers, parties, normal);
        let word = match kind {
            JointKind::Clamp | JointKind::ClampFull => {
                joints::clamp(&mut builder, kind == JointKind::ClampFull);
                "clamp"
            }
            JointKind::Pin => {
                let points = builder.points();
                builder.s(points);
                "pin"
            }
            JointKind::Hold { of, axis } => {
                joints::hold(&mut builder, of, axis);
                "hold"
            }
        };
        let rows = builder.finish();
        self.push_constraint(item, word, rows, Some(place.body.id));
        Some(())
    }

    /// `hold(beam.end.z)`, `hold(beam.end.slope.y)`, `hold(beam.end.ey.z)` or `hold(beam.end.twist)`.
    pub(in crate::check) fn hold(
        &mut self,
        item: &Item,
        call: &'a Call,
        known: &mut Known,
        held: &mut Vec<Held>,
    ) -> Option<()> {
        let shape = Shape {
            positional: 1,
            named: &[],
            required: &[],
            usage: "hold(beam.end.z)",
        };
        let arguments = self.arguments(call, &shape)?;
        let expr = arguments.positional[0];
        let usage = || say::usage("hold", "hold(beam.end.z)");
        let ExprKind::Member { base, field, .. } = &expr.kind else {
            self.errors.at(expr.area, usage());
            return None;
        };
        if field.text == "twist" {
            let place = self.place(base)?;
            known.body = Some(place.body);
            self.section_axis(&place, field)?;
            if let Some(normal) = place.body.space.and_then(normal) {
                self.errors.at(field.span, say::no_twist(plane(normal)));
                return None;
            }
            return self.hold_section(item, None, &place, expr.area, known, held);
        }
        let (of, vector, place) = match &base.kind {
            ExprKind::Member { base: place, field, .. } => match VECTORS.iter().find(|(word, _)| *word == field.text) {
                Some((_, of)) => (*of, Some(field), place.as_ref()),
                None if matches!(place.kind, ExprKind::Member { .. }) => {
                    let known = VECTORS.iter().map(|(word, _)| *word);
                    self.errors
                        .at(field.span, suggest::unknown("direction at an end", &field.text, known));
                    return None;
                }
                None => (model::Held::Position, None, base.as_ref()),
            },
            ExprKind::Name(name) if self.is_frame(&name.text) => {
                self.errors.at(base.area, say::hold_frame(&name.text, &field.text));
                return None;
            }
            _ => {
                self.errors.at(expr.area, usage());
                return None;
            }
        };
        let place = self.place(place)?;
        if let Some(word) = vector.filter(|_| of != model::Held::Slope) {
            self.section_axis(&place, word)?;
        }
        if of == model::Held::Slope && place.has_section {
            self.errors.at(expr.area, say::SLOPE_SHEARS);
            return None;
        }
        known.body = Some(place.body);
        let Some(axis) = AXES.iter().position(|axis| *axis == field.text) else {
            let message = match VECTORS.iter().find(|(word, _)| *word == field.text) {
                Some((word, _)) => say::usage("hold", &format!("hold(beam.end.{word}.z)")),
                None => suggest::unknown("component", &field.text, AXES),
            };
            self.errors.at(field.span, message);
            return None;
        };
        if let Some(normal) = place.body.space.and_then(normal).filter(|normal| *normal == axis) {
            self.errors.at(field.span, say::always_zero(AXES[axis], plane(normal)));
            return None;
        }
        let frame = place.body.frame?;
        let area = [expr.area; 2];
        let kind = JointKind::Hold { of, axis };
        let is_section = matches!(of, model::Held::SectionY | model::Held::SectionZ);
        let is_spatial = place.body.space.and_then(normal).is_none();
        if is_section && is_spatial || place.at.is_along() {
            if let Some(normal) = place.body.space.and_then(normal) {
                self.keeps_plane(frame, normal, expr.area);
            }
            return self.hold_section(item, Some(kind), &place, expr.area, known, held);
        }
        self.tie_end(item, kind, place, frame, None, area, known, held)
    }
}
