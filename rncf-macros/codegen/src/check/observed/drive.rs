//! Coordinates of joints and frames, and their drives.

use crate::check::frames::plane;
use crate::check::joints::known::{Built, Known};
use crate::check::observed::members::{Thing, angular};
use crate::check::values::quantity::{self, Typed, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::values::words::AXES;
use crate::check::{Check, Shape, say};
use crate::errors::Area;
use crate::joints::{Angle, Party, Rows, Slide, Turned, algebra};
use crate::model::{Expr as Value, FrameId, INERTIAL, Marker, MarkerId, Motions};
use crate::parse::tree::{Call, Expr, ExprKind, Item, Keyword, Name};
use crate::suggest;
use crate::units::Dimension;

const SLIDE: Wanted = Wanted {
    what: "a driven slide",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};

/// What can be driven.
pub enum Coordinate {
    Angle(Angle, Option<usize>),
    Slide(Slide, Option<usize>),
}

impl<'a> Check<'a> {
    /// `drive(J.angle, f)`, `drive(J.slide, f)` or `drive(arm.angle, f)`.
    pub(in crate::check) fn drive(&mut self, item: &Item, call: &'a Call, known: &mut Known) -> Option<()> {
        let shape = Shape {
            positional: 2,
            named: &[],
            required: &[],
            usage: "drive(crank.angle, omega * t)",
        };
        let arguments = self.arguments(call, &shape)?;
        let coordinate = self.coordinate(arguments.positional[0]);
        let f = arguments.positional[1];
        let (rows, has_moment, normal) = match coordinate? {
            Coordinate::Angle(angle, normal) => {
                let value = self.with_lookups(|check| check.angle(f, Scope::Prescribed, "a driven angle"))?;
                let f = self.is_smooth(f.area, [&value]).then_some(value)?;
                (driven("angle", angle.drive(&f), angle.parties()), true, normal)
            }
            Coordinate::Slide(slide, normal) => {
                let value = self.with_lookups(|check| check.quantity(f, Scope::Prescribed, SLIDE))?;
                let f = self.is_smooth(f.area, [&value]).then_some(value)?;
                let row = algebra::subtract(slide.value(), f);
                (driven("slide", row, slide.parties()), false, normal)
            }
        };
        let (rows, is_reversed) = rows;
        let is_own = matches!(&arguments.positional[0].kind, ExprKind::Member { base, .. }
            if matches!(&base.kind, ExprKind::Name(name) if self.is_frame(&name.text)));
        let constraint = self.push_constraint(item, "drive", rows, None);
        let party = || Party::Frame {
            frame: INERTIAL,
            point: None,
        };
        known.built = Some(Built {
            constraint,
            word: "drive".into(),
            kind: None,
            is_reversed: is_reversed && !is_own,
            parties: [party(), party()],
            normal,
            axis: [0.0; 3],
            has_moment,
        });
        Some(())
    }

    /// `J.angle`, `J.slide` or `arm.angle`.
    fn coordinate(&mut self, expr: &'a Expr) -> Option<Coordinate> {
        let ExprKind::Member {
            base,
            field,
            arguments: None,
        } = &expr.kind
        else {
            self.errors.at(expr.area, say::COORDINATE_EXPECTED);
            return None;
        };
        let ExprKind::Name(name) = &base.kind else {
            self.errors.at(expr.area, say::COORDINATE_EXPECTED);
            return None;
        };
        if self.is_frame(&name.text) {
            let frame = self.frame(name)?;
            if field.text != "angle" {
                let message = say::not_driven(&name.text, &field.text);
                self.errors.at(field.span, message);
                return None;
            }
            let turned = self.own_angle(frame, field)?;
            let normal = self.frame_normal(frame);
            return Some(Coordinate::Angle(turned, normal));
        }
        let built = self.built_joint(name)?;
        self.coordinate_of(&built, name, field)
    }

    /// A joint with multipliers.
    pub(in crate::check) fn built_joint(&mut self, name: &Name) -> Option<Built> {
        self.item(name, Keyword::Joint)?;
        let known = self.joints.get(name.text.as_str())?;
        if known.built.is_none() && (known.kind.is_some() || known.is_share) {
            self.errors.at(name.span, say::no_coordinates(&name.text));
        }
        self.joints.get(name.text.as_str())?.built.clone()
    }

    fn coordinate_of(&mut self, built: &Built, name: &Name, field: &Name) -> Option<Coordinate> {
        let coordinates = coordinates(built);
        let word = field.text.as_str();
        if !coordinates.contains(&word) {
            let message = say::no_coordinate(&name.text, &built.word, word, &has(coordinates));
            self.errors.at(field.span, message);
            return None;
        }
        if word == "slide" {
            let markers = &mut self.model.markers;
            let slide = Slide::new(markers, built.parties.clone(), built.normal, built.axis);
            return Some(Coordinate::Slide(slide, built.normal));
        }
        self.angle_between(built, field)
            .map(|angle| Coordinate::Angle(angle, built.normal))
    }

    /// The angle of a joint.
    pub(in crate::check) fn angle_between(&mut self, built: &Built, field: &Name) -> Option<Angle> {
        let mut frames = Vec::new();
        for party in &built.parties {
            match party {
                Party::Frame { frame, .. } => frames.push(*frame),
                Party::Place { section: Some(_), .. } => {}
                Party::Place { body, .. } => {
                    // Of a body with mistakes nothing is known about its sections.
                    self.body_of(*body)?;
                    self.errors.at(field.span, say::ANGLE_OF_END);
                    return None;
                }
            }
        }
        let area = field.span.into();
        if let (Some(normal), [first, second]) = (built.normal, &frames[..]) {
            let (first, second) = (self.turned(*first, normal, area)?, self.turned(*second, normal, area)?);
            return Some(Angle::Counted { first, second });
        }
        if !frames.into_iter().all(|frame| self.has_orientation(frame, area)) {
            return None;
        }
        let markers = &mut self.model.markers;
        Some(Angle::between(markers, built.parties.clone(), built.normal, built.axis))
    }

    fn turned(&mut self, frame: FrameId, normal: usize, area: Area) -> Option<Turned> {
        match self.motions_of(frame) {
            Some(Motions::Shifting | Motions::ShiftingPlanar { .. }) => {
                let message = say::point_mass_turns(&self.model.frames[frame.0].name);
                self.errors.at(area, message);
                None
            }
            Some(motions) => {
                let is_opposite = matches!(motions, Motions::Hinged { axis } if axis[normal] < 0.0);
                let sign = if is_opposite { -1.0 } else { 1.0 };
                let parent = self.model.frames[frame.0].parent;
                let from = Box::new(self.prescribed_angle(parent, normal).at_time_zero());
                let marker = self.marker(Marker::Angle { frame });
                Some(Turned::Free { marker, sign, from })
            }
            None if frame == INERTIAL => Some(Turned::Still),
            None => {
                let angle = Box::new(self.prescribed_angle(frame, normal));
                let turn = self.marker(Marker::Turn { frame });
                Some(Turned::Prescribed { angle, turn, normal })
            }
        }
    }

    /// The own angle of a planar or hinged frame.
    pub(in crate::check) fn own_angle(&mut self, frame: FrameId, word: &Name) -> Option<Angle> {
        let name = self.model.frames[frame.0].name.clone();
        let message = match self.motions_of(frame) {
            Some(Motions::Planar { .. } | Motions::Hinged { .. }) => {
                let marker = self.marker(Marker::Angle { frame });
                return Some(Angle::Counted {
                    first: Turned::Still,
                    second: Turned::Free {
                        marker,
                        sign: 1.0,
                        from: Box::new(Value::Number(0.0)),
                    },
                });
            }
            Some(Motions::Shifting | Motions::ShiftingPlanar { .. }) => say::point_mass_turns(&name),
            Some(_) => say::no_angle_in_space(&name, "angle"),
            None => say::angle_of_prescribed(&name, "angle"),
        };
        self.errors.at(word.span, message);
        None
    }

    /// `J.rate` of a joint with one coordinate.
    fn rate_of_joint(&mut self, name: &Name, field: &Name, scope: Scope) -> Option<Typed> {
        let built = self.built_joint(name)?;
        let &[word] = coordinates(&built) else {
            let message = say::no_rate(&name.text, &built.word, &has(coordinates(&built)));
            self.errors.at(field.span, message);
            return None;
        };
        self.allows_rates(field, scope)?;
        let coordinate = Name::new(word, field.span);
        Some(match self.coordinate_of(&built, name, &coordinate)? {
            Coordinate::Angle(angle, _) => Typed {
                nature: angular(),
                ..Typed::new(angle.rate(), Dimension::of([0, 0, -1, 0, 0, 0]))
            },
            Coordinate::Slide(slide, _) => Typed::new(slide.rate(), Dimension::of([1, 0, -1, 0, 0, 0])),
        })
    }

    /// `J.angle`, `J.slide`, `J.rate`, `J.force` or `J.moment`.
    pub(in crate::check) fn of_joint(&mut self, name: &'a Name, field: &'a Name, scope: Scope) -> Option<Thing<'a>> {
        let known = self.joints.get(name.text.as_str())?.clone();
        let word = field.text.as_str();
        if word == "rate" {
            let typed = self.rate_of_joint(name, field, scope)?;
            return Some(Thing::Value(Quantity::Scalar(typed)));
        }
        let is_coordinate = matches!(word, "angle" | "slide");
        if is_coordinate {
            let built = self.built_joint(name)?;
            let typed = match self.coordinate_of(&built, name, field)? {
                Coordinate::Angle(angle, _) => Typed {
                    nature: angular(),
                    ..Typed::new(angle.value(), Dimension::NONE)
                },
                Coordinate::Slide(slide, _) => Typed::new(slide.value(), Dimension::of([1, 0, 0, 0, 0, 0])),
            };
            return Some(Thing::Value(Quantity::Scalar(typed)));
        }
        if scope != Scope::Output {
            self.errors.at(field.span, say::only_in_outputs(word));
            return None;
        }
        let Some(built) = known.built else {
            let seen = self.reaction(name, &[field])?;
            let mut vector = Vectorial {
                values: algebra::numbers([0.0; 3]),
                axes: Vec::new(),
                dimension: seen.dimension,
                nature: quantity::Nature::default(),
                frame: known.frame,
            };
            for (axis, observable) in seen.components {
                let axis = AXES.iter().position(|name| *name == axis)?;
                vector.values[axis] = Value::Observed(observable);
                vector.axes.push(axis);
            }
            let plane = known.body.and_then(|body| plane::normal(body.space?));
            let shown = known.frame?;
            return Some(Thing::Shown { vector, plane, shown });
        };
        let is_moment = match word {
            "force" => false,
            "moment" => true,
            _ => {
                let mut words = vec!["force", "moment"];
                words.extend(coordinates(&built));
                words.extend((coordinates(&built).len() == 1).then_some("rate"));
                self.errors
                    .at(field.span, suggest::unknown("quantity of a joint", word, words));
                return None;
            }
        };
        if is_moment && !built.has_moment {
            self.errors.at(field.span, say::no_moment(&name.text, &built.word));
            return None;
        }
        let exerted = self.exerted(&built, is_moment);
        match (exerted, known.frame) {
            // What holds a coordinate of a frame is seen in that frame.
            (Thing::Shown { vector, plane, .. }, Some(shown)) if built.word == "hold" => {
                Some(Thing::Shown { vector, plane, shown })
            }
            (exerted, _) => Some(exerted),
        }
    }
}

/// The coordinates of a joint, in space or in its plane.
fn coordinates(built: &Built) -> &'static [&'static str] {
    built
        .kind
        .map_or(&[][..], |kind| kind.coordinates[usize::from(built.normal.is_some())])
}

/// `; it has a and b`, or nothing.
fn has(coordinates: &[&str]) -> String {
    if coordinates.is_empty() {
        return String::new();
    }
    let quoted: Vec<String> = coordinates.iter().map(|word| format!("`{word}`")).collect();
    format!("; it has {}", quoted.join(" and "))
}

/// The row of a drive, and whether only the second party has markers: then it stands first.
fn driven(what: &str, row: Value, [first, second]: [Vec<MarkerId>; 2]) -> (Rows, bool) {
    let is_reversed = first.is_empty();
    let first_party = if is_reversed { second.len() } else { first.len() };
    let rows = Rows {
        markers: first.into_iter().chain(second).collect(),
        first_party,
        rows: vec![(what.into(), row)],
    };
    (rows, is_reversed)
}
