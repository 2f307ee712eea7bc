//! Places: on flexible bodies, on frames and rigid bodies.

use crate::check::bodies::body;
use crate::check::frames::plane::normal;
use crate::check::values::quantity::Wanted;
use crate::check::values::repeat::place_of;
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::values::words::{balance_words, is_carried};
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::joints::{Party, algebra};
use crate::model::{Body, BodyId, Expr as Value, FrameId, Location, Motions, Space};
use crate::parse::tree::{Argument, Expr, ExprKind, Keyword};
use crate::suggest;
use crate::vocabulary::members;

const PART: Wanted = Wanted {
    what: "the part of the length",
    dimension: [0; 6],
    unit: "",
};
const PLACE: Wanted = Wanted {
    what: "the place on a body",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const OFFSET: Wanted = Wanted {
    what: "the distance from the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const BESIDE: &str = "beam.end.beside([0, 20, 0] mm)";
const POINT: Wanted = Wanted {
    what: "a point of a frame",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};

/// A place on a flexible body, as written.
#[derive(Clone, Debug)]
pub struct Place {
    pub body: body::Known,
    pub at: Location,
    /// How far beside the axis, m, along the section's y and z axes.
    pub beside: Option<[Value; 2]>,
    /// Whether the body has cross-sections, or a centre line alone; neither where it has mistakes.
    pub has_section: bool,
    pub is_line: bool,
}

impl Place {
    /// As the joint library has it.
    pub fn party(&self) -> Party {
        Party::Place {
            body: self.body.id,
            at: self.at.clone(),
            beside: self.beside.clone(),
            section: self.body.frame.filter(|_| self.has_section),
        }
    }
}

/// A place on anything.
#[derive(Clone, Debug)]
pub enum Spot {
    /// On a flexible body.
    Flexible(Place),
    /// Fixed in a frame or rigid body, m, frame axes.
    Rigid { frame: FrameId, at: [Value; 3] },
}

/// A place as one of the two that a joint or spring holds on to.
#[derive(Clone, Debug)]
pub struct Hold {
    pub spot: Spot,
    /// Whether it is a frame or rigid body, named without a point of it.
    pub is_bare: bool,
    pub area: Area,
}

impl Hold {
    /// As the joint library has it.
    pub fn party(&self) -> Party {
        match self.spot.clone() {
            Spot::Flexible(place) => place.party(),
            Spot::Rigid { frame, at } => Party::Frame {
                frame,
                point: (!self.is_bare).then_some(at),
            },
        }
    }

    /// Whether it is a place on a centre line, which has a tangent and no orientation.
    pub fn is_line(&self) -> bool {
        matches!(&self.spot, Spot::Flexible(place) if place.is_line)
    }

    /// Whether it is a section of a flexible body.
    pub fn is_section(&self) -> bool {
        matches!(&self.spot, Spot::Flexible(place) if place.has_section)
    }

    /// Its frame, where it is one.
    pub fn frame(&self) -> Option<FrameId> {
        match self.spot {
            Spot::Rigid { frame, .. } => Some(frame),
            Spot::Flexible(_) => None,
        }
    }
}

impl<'a> Check<'a> {
    /// A place that something holds on to.
    pub(in crate::check) fn hold_on(&mut self, expr: &'a Expr) -> Option<Hold> {
        let area = expr.area;
        match &expr.kind {
            ExprKind::Name(name) => {
                if self
                    .names
                    .get(name.text.as_str())
                    .is_some_and(|item| item.keyword == Keyword::Body)
                {
                    self.errors.at(area, say::PLACE_EXPECTED);
                    return None;
                }
                let frame = self.frame(name)?;
                let at = algebra::numbers([0.0; 3]);
                let spot = Spot::Rigid { frame, at };
                Some(Hold {
                    spot,
                    is_bare: true,
                    area,
                })
            }
            ExprKind::Member { base, field, arguments } => {
                if let ExprKind::Name(name) = &base.kind
                    && self.is_frame(&name.text)
                {
                    let frame = self.frame(name)?;
                    let at = match (field.text.as_str(), arguments) {
                        ("at", Some(arguments)) => self.point_of(frame, expr, arguments)?,
                        ("center", None) => self.center_of(frame, field.span.into())?,
                        _ => {
                            self.errors.at(area, say::RIGID_PLACE);
                            return None;
                        }
                    };
                    return Some(Hold {
                        spot: Spot::Rigid { frame, at },
                        is_bare: false,
                        area,
                    });
                }
                let place = if field.text == "beside" {
                    let place = self.place(base)?;
                    self.beside(place, expr, arguments.as_deref())?
                } else {
                    self.place(expr)?
                };
                Some(Hold {
                    spot: Spot::Flexible(place),
                    is_bare: false,
                    area,
                })
            }
            _ => {
                self.errors.at(area, say::PLACE_EXPECTED);
                None
            }
        }
    }

    /// `arm.at([..] m)`: the point.
    pub(in crate::check) fn point_of(
        &mut self,
        frame: FrameId,
        expr: &Expr,
        arguments: &'a [Argument],
    ) -> Option<[Value; 3]> {
        let [Argument { name: None, value }] = arguments else {
            self.errors.at(expr.area, say::usage("at", "arm.at([1, 0, 0] m)"));
            return None;
        };
        let vector = self.vector(value, Scope::Parameter, POINT)?;
        if self.is_point_mass(frame) && vector.constant() != Some([0.0; 3]) {
            let message = say::point_mass(&self.model.frames[frame.0].name, "at(..)");
            self.errors.at(vector.area, message);
            return None;
        }
        if let Some(Motions::Planar { normal } | Motions::ShiftingPlanar { normal }) = self.motions_of(frame) {
            let space = Space::Planar { normal: *normal };
            self.in_plane(&vector, space, "the point");
        }
        Some(vector.values)
    }

    /// `arm.center`
    pub(in crate::check) fn center_of(&mut self, frame: FrameId, area: Area) -> Option<[Value; 3]> {
        let declared = &self.model.frames[frame.0];
        let own = declared
            .free
            .as_ref()
            .filter(|free| free.is_body)
            .and_then(|free| free.parts.first());
        if own.is_none() {
            let message = say::no_center(&declared.name);
            self.errors.at(area, message);
        }
        own.map(|part| part.center.clone())
    }

    /// The plane that two things move in, `Some(None)` in space; things that do not fit are reported.
    pub(in crate::check) fn common_plane(&mut self, holds: [&Hold; 2]) -> Option<Option<usize>> {
        let spaces = holds.map(|hold| match &hold.spot {
            Spot::Flexible(place) => place.body.space,
            Spot::Rigid { frame, .. } => match self.motions_of(*frame)? {
                Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => {
                    Some(Space::Planar { normal: *normal })
                }
                Motions::Spatial | Motions::Turning | Motions::Shifting => Some(Space::Spatial),
                Motions::Hinged { .. } | Motions::State => None,
            },
        });
        match spaces {
            [Some(first), Some(second)] if first == second => Some(normal(first)),
            [Some(_), Some(_)] => {
                self.errors.at(holds[1].area, say::PLANAR_AND_SPATIAL);
                None
            }
            [None, None] => {
                let plane = self.scene_normal();
                let frames = holds.map(Hold::frame);
                let stays = |check: &mut Self, normal| {
                    let mut frames = frames.into_iter().flatten();
                    frames.all(|frame| check.stays_in(frame, normal))
                };
                Some(plane.filter(|normal| stays(self, *normal)))
            }
            [Some(space), None] | [None, Some(space)] => {
                let Some(normal) = normal(space) else {
                    return Some(None);
                };
                let other = if spaces[0].is_none() { holds[0] } else { holds[1] };
                match other.frame() {
                    Some(frame) => self.keeps_plane(frame, normal, other.area).then_some(Some(normal)),
                    // A body whose space has been reported.
                    None => None,
                }
            }
        }
    }

    /// `beam.start`, `beam.end` or `beam.at(4 m)`, or of one repetition, `main[a].end`.
    pub(in crate::check) fn place(&mut self, expr: &'a Expr) -> Option<Place> {
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            self.errors.at(expr.area, say::PLACE_EXPECTED);
            return None;
        };
        if !matches!(base.kind, ExprKind::Name(_) | ExprKind::Indexed { .. }) {
            self.errors.at(expr.area, say::PLACE_EXPECTED);
            return None;
        }
        let (body, instance) = self.named_body(base)?;
        if arguments.is_none()
            && let Some(found) = self.interface_of(body.id, field)
        {
            let at = place_of(instance, found?);
            let has_section = self.has_section(body.id);
            return Some(Place {
                body,
                at,
                beside: None,
                has_section: has_section == Some(true),
                is_line: has_section == Some(false),
            });
        }
        let at = match (field.text.as_str(), arguments) {
            ("start", None) => Location::Start,
            ("end", None) => Location::End,
            ("at", Some(arguments)) => match arguments.as_slice() {
                [argument] if argument.name.is_none() => {
                    let at = self.quantity(&argument.value, Scope::Parameter, PLACE)?;
                    self.on_axis(&argument.value, fold::constant(&at), body.length);
                    Location::At(Box::new(at))
                }
                [argument] if argument.name.as_ref().is_some_and(|name| name.text == "eta") => {
                    let part = self.quantity(&argument.value, Scope::Parameter, PART)?;
                    if fold::constant(&part).is_some_and(|part| !(0.0..=1.0).contains(&part)) {
                        self.errors.at(argument.value.area, say::PART_OF_LENGTH);
                    }
                    Location::Part(Box::new(part))
                }
                _ => {
                    self.errors
                        .at(expr.area, say::usage("at", "beam.at(4 m)` or `beam.at(eta = 0.5)"));
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
                let message = match &base.kind {
                    ExprKind::Name(body) if is_of_place(other) => say::of_place(other, &body.text),
                    _ => {
                        let known = members::words(members::PLACES).chain(balance_words());
                        suggest::unknown("place on a body", other, known)
                    }
                };
                self.errors.at(field.span, message);
                return None;
            }
        };
        let has_section = self.has_section(body.id);
        Some(Place {
            body,
            at: place_of(instance, at),
            beside: None,
            has_section: has_section == Some(true),
            is_line: has_section == Some(false),
        })
    }

    /// `PLACE.beside([0, y, z] m)`: a place that is fixed in the section.
    pub(in crate::check) fn beside(
        &mut self,
        place: Place,
        expr: &Expr,
        arguments: Option<&'a [Argument]>,
    ) -> Option<Place> {
        let Some([Argument { name: None, value }]) = arguments else {
            self.errors.at(expr.area, say::usage("beside", BESIDE));
            return None;
        };
        let vector = self.vector(value, Scope::Parameter, OFFSET)?;
        if !place.has_section {
            if place.is_line {
                self.errors.at(expr.area, say::BESIDE_LINE);
            }
            return None;
        }
        if place.beside.is_some() {
            self.errors.at(expr.area, say::BESIDE_TWICE);
            return None;
        }
        let is_planar = place.body.space.and_then(normal).is_some();
        let [along, y, z] = vector.values;
        if fold::constant(&along) != Some(0.0) {
            self.errors.at(vector.areas[0], say::BESIDE_ALONG);
            return None;
        }
        if is_planar && fold::constant(&z) != Some(0.0) {
            self.errors.at(vector.areas[2], say::BESIDE_PLANE);
            return None;
        }
        Some(Place {
            beside: Some([y, z]),
            ..place
        })
    }

    /// A body of the model; `None` where something of it has been reported.
    pub(in crate::check) fn body_of(&self, id: BodyId) -> Option<&Body> {
        let item = self.items(Keyword::Body).into_iter().nth(id.0)?;
        self.model.bodies.iter().find(|body| body.name == item.name.text)
    }

    /// Whether a body's element has cross-sections.
    pub(in crate::check) fn has_section(&self, id: BodyId) -> Option<bool> {
        let body = self.body_of(id)?;
        Some(self.library.elements[body.element.0].has_section())
    }

    /// Whether the nodes of a body carry the slope of its axis.
    pub(in crate::check) fn has_slope(&self, id: BodyId) -> Option<bool> {
        let body = self.body_of(id)?;
        Some(self.library.elements[body.element.0].has_slope())
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

/// Whether a word asks something of a place.
fn is_of_place(word: &str) -> bool {
    is_carried(word) || ["velocity", "position", "acceleration", "slope"].contains(&word) || AXES.contains(&word)
}
