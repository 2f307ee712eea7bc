//! What stands before the dots: frames, places, directions, joints, constraints; and what they show.

use super::section_forces::known_words;
use crate::check::fold;
use crate::check::frames::plane::{self, plane};
use crate::check::joints::known::Built;
use crate::check::places::place::Spot;
use crate::check::values::quantity::{Nature, Typed, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::values::words::AXES;
use crate::check::values::words::{balance_words, is_balance, is_carried};
use crate::check::{Check, say};
use crate::errors::Area;
use crate::joints::algebra::{self, Vector, divide, norm, number, observed};
use crate::joints::unit;
use crate::model::{self, FrameId, INERTIAL, Marker, Motions, Observable};
use crate::parse::tree::{Argument, Expr, ExprKind, Keyword, Name};
use crate::suggest;
use crate::units::Dimension;
use crate::vocabulary::members;

const DIRECTION: Wanted = Wanted {
    what: "a direction",
    dimension: [0; 6],
    unit: "1",
};

/// Something that can be observed, or asked further.
pub enum Thing<'a> {
    /// A frame or rigid body.
    Frame(FrameId),
    /// A place and the frame that it is seen in, where that is written.
    Place(Spot, Option<FrameId>),
    /// A vector with components in a frame, to be shown in the axes of another.
    Shown {
        /// Components in the axes of `frame`.
        vector: Vectorial,
        /// The plane that it is in.
        plane: Option<usize>,
        /// Where it is shown.
        shown: FrameId,
    },
    /// A joint, by name.
    Joint(&'a Name),
    /// A declared constraint.
    Constraint(&'a Name),
    /// A spring.
    Spring(&'a Name),
    /// A value.
    Value(Quantity),
}

const LENGTH: [i8; 6] = [1, 0, 0, 0, 0, 0];

impl<'a> Check<'a> {
    /// Resolves what stands before a dot.
    pub(in crate::check) fn thing(&mut self, expr: &'a Expr, scope: Scope) -> Option<Thing<'a>> {
        self.nested(expr, |check| match &expr.kind {
            ExprKind::Name(name) => check.named_thing(name),
            ExprKind::Member { base, field, arguments } => {
                if let Some(thing) = check.balance_of_thing(expr, scope) {
                    return thing;
                }
                if let ExprKind::Name(name) | ExprKind::Indexed { base: name, .. } = &base.kind
                    && check.keyword_of(name) == Some(Keyword::Body)
                {
                    let place = check.place(expr)?;
                    check.is_single(expr, &place.at)?;
                    return Some(Thing::Place(Spot::Flexible(place), None));
                }
                let thing = check.thing(base, scope)?;
                check.part(thing, expr, field, arguments.as_deref(), scope)
            }
            _ => check.value(expr, scope).map(Thing::Value),
        })
    }

    fn keyword_of(&self, name: &Name) -> Option<Keyword> {
        self.names.get(name.text.as_str()).map(|item| item.keyword)
    }

    fn named_thing(&mut self, name: &'a Name) -> Option<Thing<'a>> {
        if self.is_frame(&name.text) {
            return self.frame(name).map(Thing::Frame);
        }
        match self.keyword_of(name) {
            Some(Keyword::Joint) => Some(Thing::Joint(name)),
            Some(Keyword::Constraint) => Some(Thing::Constraint(name)),
            Some(Keyword::Spring) => Some(Thing::Spring(name)),
            _ if self.particle.contains_key(name.text.as_str()) => {
                let vector = self.particle[name.text.as_str()].clone();
                Some(Thing::Value(Quantity::Vector(vector)))
            }
            _ if self.locals.contains_key(name.text.as_str()) => {
                let local = self.locals[name.text.as_str()].clone();
                Some(Thing::Value(Quantity::Scalar(local)))
            }
            _ => {
                self.no_thing(name);
                None
            }
        }
    }

    /// `thing.field` or `thing.field(arguments)`
    fn part(
        &mut self,
        thing: Thing<'a>,
        expr: &'a Expr,
        field: &'a Name,
        arguments: Option<&'a [Argument]>,
        scope: Scope,
    ) -> Option<Thing<'a>> {
        let takes = matches!(
            field.text.as_str(),
            "in" | "at" | "beside" | "direction" | "angular_momentum"
        );
        if arguments.is_some() && !takes {
            self.errors.at(expr.area, say::no_arguments(&field.text));
            return None;
        }
        match (thing, arguments) {
            (Thing::Value(_), Some(_)) if field.text == "in" => {
                self.errors.at(expr.area, say::IN_TWICE);
                None
            }
            (Thing::Value(quantity), _) => self.one_component(quantity, field).map(Thing::Value),
            (Thing::Constraint(name), None) => self.of_constraint(name, field, scope),
            (Thing::Joint(name), None) => self.of_joint(name, field, scope),
            (Thing::Spring(name), None) => self.of_spring(name, field, scope),
            (Thing::Place(Spot::Flexible(place), None), arguments) if field.text == "beside" => {
                let place = self.beside(place, expr, arguments)?;
                Some(Thing::Place(Spot::Flexible(place), None))
            }
            (Thing::Place(spot, None), Some(arguments)) if field.text == "in" => {
                let frame = self.in_argument(expr, arguments)?;
                Some(Thing::Place(spot, Some(frame)))
            }
            (Thing::Frame(frame), Some(arguments)) if field.text == "in" => {
                let seen = self.in_argument(expr, arguments)?;
                Some(Thing::Place(origin(frame), Some(seen)))
            }
            (Thing::Shown { vector, plane, .. }, Some(arguments)) if field.text == "in" => {
                let shown = self.in_argument(expr, arguments)?;
                Some(Thing::Shown { vector, plane, shown })
            }
            (Thing::Frame(frame), arguments) => self.of_frame(frame, expr, field, arguments, scope),
            (Thing::Place(spot, frame), None) => self.of_place(spot, frame, field, scope),
            (shown @ Thing::Shown { .. }, None) => {
                let quantity = self.seen(shown, expr)?;
                self.one_component(quantity, field).map(Thing::Value)
            }
            (_, Some(_)) => {
                let message = if field.text == "in" {
                    say::IN_TWICE
                } else {
                    say::NOTHING_OBSERVED
                };
                self.errors.at(expr.area, message);
                None
            }
        }
    }

    /// The frame in `.in(FRAME)`.
    fn in_argument(&mut self, expr: &Expr, arguments: &'a [Argument]) -> Option<FrameId> {
        match arguments {
            [Argument { name: None, value }] => self.frame_argument(value),
            _ => {
                self.errors.at(expr.area, say::usage("in", "beam.end.in(inertial)"));
                None
            }
        }
    }

    fn one_component(&mut self, quantity: Quantity, field: &'a Name) -> Option<Quantity> {
        let Quantity::Vector(vector) = quantity else {
            self.errors.at(field.span, say::after_component(&field.text));
            return None;
        };
        let zero = |axis: usize| match (0..3).find(|normal| vector.axes.len() == 2 && !vector.axes.contains(normal)) {
            Some(normal) => say::always_zero(AXES[axis], plane(normal)),
            None => say::no_component(AXES[axis]),
        };
        let (axes, _) = self.axes(&[field], &vector.axes, zero)?;
        Some(Quantity::Scalar(vector.component(axes[0])))
    }

    /// The value of what is observed.
    pub(in crate::check) fn seen(&mut self, thing: Thing<'a>, expr: &Expr) -> Option<Quantity> {
        match thing {
            Thing::Value(quantity) => Some(quantity),
            Thing::Frame(frame) => self.position(&origin(frame), None).map(Quantity::Vector),
            Thing::Place(spot, frame) => self.position(&spot, frame).map(Quantity::Vector),
            Thing::Joint(name) | Thing::Constraint(name) | Thing::Spring(name) => {
                let (kind, example) = match self.keyword_of(name) {
                    Some(Keyword::Constraint) => ("constraint", "multiplier"),
                    Some(Keyword::Spring) => ("spring", "force"),
                    _ => ("joint", "force.x"),
                };
                self.errors
                    .at(expr.area, say::whole_thing(&name.text, &say::a(kind), example));
                None
            }
            Thing::Shown { vector, plane, shown } => {
                let from = vector.frame.unwrap_or(INERTIAL);
                if from == shown {
                    return Some(Quantity::Vector(vector));
                }
                let plane = plane.filter(|normal| self.stays_in(from, *normal) && self.stays_in(shown, *normal));
                let inertial = self.in_inertial_axes(&vector.values, from, plane);
                let values = self.in_frame_axes(&inertial, shown, plane);
                let axes = if plane.is_some() {
                    vector.axes.clone()
                } else {
                    vec![0, 1, 2]
                };
                Some(Quantity::Vector(Vectorial {
                    values,
                    axes,
                    frame: Some(shown),
                    ..vector
                }))
            }
        }
    }

    /// The frame that a place is seen in where nothing is written.
    fn default_frame(spot: &Spot) -> Option<FrameId> {
        match spot {
            Spot::Flexible(place) => place.body.frame,
            Spot::Rigid { .. } => Some(INERTIAL),
        }
    }

    fn position(&mut self, spot: &Spot, frame: Option<FrameId>) -> Option<Vectorial> {
        self.motion_of(spot, frame, 0, LENGTH)
    }

    fn motion_of(
        &mut self,
        spot: &Spot,
        frame: Option<FrameId>,
        derivative: usize,
        dimension: [i8; 6],
    ) -> Option<Vectorial> {
        let frame = match frame {
            Some(frame) => frame,
            None => Self::default_frame(spot)?,
        };
        let values = self.place_in(spot, frame, derivative);
        let axes = self.moving_axes(spot, frame);
        Some(Vectorial {
            values,
            axes,
            dimension: Dimension::of(dimension),
            nature: Nature::default(),
            frame: Some(frame),
        })
    }

    /// Axes of a frame along which a place moves.
    pub(in crate::check) fn moving_axes(&mut self, spot: &Spot, frame: FrameId) -> Vec<usize> {
        match self.spot_normal(spot).filter(|normal| self.stays_in(frame, *normal)) {
            Some(normal) => model::Space::Planar { normal }.axes().to_vec(),
            None => vec![0, 1, 2],
        }
    }

    /// `PLACE.field`
    fn of_place(&mut self, spot: Spot, frame: Option<FrameId>, field: &'a Name, scope: Scope) -> Option<Thing<'a>> {
        if let Spot::Flexible(place) = &spot
            && is_carried(&field.text)
        {
            if place.beside.is_some() {
                self.errors.at(field.span, say::BESIDE_CARRIED);
                return None;
            }
            return self.carried(place, frame, field, scope).map(Thing::Value);
        }
        let vector = match (field.text.as_str(), &spot) {
            ("ey" | "ez", Spot::Flexible(place)) => self.section_direction(place, frame, field, scope)?,
            ("position", _) => self.position(&spot, frame)?,
            ("velocity", _) => {
                self.allows_rates(field, scope)?;
                self.motion_of(&spot, frame, 1, [1, 0, -1, 0, 0, 0])?
            }
            ("acceleration", _) => {
                if scope != Scope::Output {
                    self.errors.at(field.span, say::ACCELERATION);
                    return None;
                }
                let seen = frame.or_else(|| Self::default_frame(&spot))?;
                if seen != INERTIAL {
                    self.errors.at(field.span, say::INERTIAL_ACCELERATION);
                    return None;
                }
                self.motion_of(&spot, Some(INERTIAL), 2, [1, 0, -2, 0, 0, 0])?
            }
            ("slope", Spot::Flexible(place)) if scope == Scope::Constraint && place.has_section => {
                self.errors.at(field.span, say::SLOPE_SHEARS);
                return None;
            }
            ("slope", _) => self.slope(&spot, frame, field)?,
            (word, _) if AXES.contains(&word) => {
                let position = self.position(&spot, frame)?;
                return self.one_component(Quantity::Vector(position), field).map(Thing::Value);
            }
            (word, _) => {
                let mut known: Vec<&str> = members::words(members::OF_POINTS).collect();
                if let Spot::Flexible(place) = &spot {
                    known.push("slope");
                    known.extend(known_words(place));
                }
                self.errors
                    .at(field.span, suggest::unknown("quantity of a point", word, known));
                return None;
            }
        };
        Some(Thing::Value(Quantity::Vector(vector)))
    }

    fn slope(&mut self, spot: &Spot, frame: Option<FrameId>, field: &Name) -> Option<Vectorial> {
        let Spot::Flexible(place) = spot else {
            self.errors.at(field.span, say::RIGID_SLOPE);
            return None;
        };
        let (body, at) = (place.body.id, place.at.clone());
        self.direction_on(place, frame, Marker::BodySlope { body, at })
    }

    /// Whether velocities may stand here; reports where they may not.
    pub(in crate::check) fn allows_rates(&mut self, field: &Name, scope: Scope) -> Option<()> {
        if scope >= Scope::Force {
            return Some(());
        }
        let message = if self.is_distributed {
            say::rate_in_load(&field.text)
        } else {
            say::rate_in_constraint(&field.text)
        };
        self.errors.at(field.span, message);
        None
    }

    /// `FRAME.field`
    fn of_frame(
        &mut self,
        frame: FrameId,
        expr: &'a Expr,
        field: &'a Name,
        arguments: Option<&'a [Argument]>,
        scope: Scope,
    ) -> Option<Thing<'a>> {
        match (field.text.as_str(), arguments) {
            ("at", Some(arguments)) => {
                let at = self.point_of(frame, expr, arguments)?;
                Some(Thing::Place(Spot::Rigid { frame, at }, None))
            }
            ("at", None) => {
                self.errors.at(field.span, say::usage("at", "arm.at([1, 0, 0] m)"));
                None
            }
            ("center", None) => {
                let at = self.center_of(frame, field.span.into())?;
                Some(Thing::Place(Spot::Rigid { frame, at }, None))
            }
            ("ex" | "ey" | "ez", None) => {
                let axis = ["ex", "ey", "ez"].iter().position(|word| *word == field.text)?;
                self.direction(frame, algebra::numbers(unit(axis)), field.span.into())
            }
            ("direction", Some([Argument { name: None, value }])) => {
                let vector = self.vector(value, Scope::Parameter, DIRECTION)?;
                if plane::is_zero(&vector.values) {
                    self.errors.at(value.area, say::ZERO_DIRECTION);
                    return None;
                }
                let length = norm(&vector.values);
                let length = fold::constant(&length).map_or(length, number);
                let along = vector.values.map(|component| {
                    let quotient = divide(component, length.clone());
                    fold::constant(&quotient).map_or(quotient, number)
                });
                self.direction(frame, along, field.span.into())
            }
            ("direction", _) => {
                self.errors
                    .at(expr.area, say::usage("direction", "arm.direction([1, 1, 0])"));
                None
            }
            ("angle", None) => self.angle_of(frame, field, 0).map(Thing::Value),
            ("speed", None) => {
                self.allows_rates(field, scope)?;
                self.angle_of(frame, field, 1).map(Thing::Value)
            }
            ("angular_velocity", None) => {
                self.allows_rates(field, scope)?;
                self.turning(frame, field)
            }
            (word, arguments) if is_balance(word) => self.balance_of_frame(frame, expr, field, arguments, scope),
            ("x" | "y" | "z" | "position" | "velocity" | "acceleration" | "slope", _) => {
                self.of_place(origin(frame), None, field, scope)
            }
            (word, _) => {
                let known = members::words(members::OF_FRAMES).chain(members::words(members::OF_POINTS));
                let known = known.chain(balance_words());
                self.errors
                    .at(field.span, suggest::unknown("quantity of a frame", word, known));
                None
            }
        }
    }

    fn direction(&mut self, frame: FrameId, along: Vector, area: Area) -> Option<Thing<'a>> {
        if !self.has_orientation(frame, area) {
            return None;
        }
        let in_plane = self
            .frame_normal(frame)
            .filter(|normal| fold::constant(&along[*normal]) == Some(0.0));
        let axes = match in_plane {
            Some(normal) => model::Space::Planar { normal }.axes().to_vec(),
            None => vec![0, 1, 2],
        };
        let values = if frame == INERTIAL {
            along
        } else {
            let marker = self.marker(Marker::Direction { frame, along });
            observed(marker, 0, in_plane)
        };
        Some(Thing::Shown {
            vector: Vectorial {
                values,
                axes,
                dimension: Dimension::NONE,
                nature: Nature::default(),
                frame: Some(INERTIAL),
            },
            plane: in_plane,
            shown: INERTIAL,
        })
    }

    /// The angle (or its rate) of a planar or hinged frame.
    fn angle_of(&mut self, frame: FrameId, field: &Name, derivative: usize) -> Option<Quantity> {
        let name = self.model.frames[frame.0].name.clone();
        let message = match self.motions_of(frame) {
            Some(Motions::Planar { .. } | Motions::Hinged { .. }) => {
                let marker = self.marker(Marker::Angle { frame });
                let typed = Typed {
                    value: observed(marker, derivative, None)[0].clone(),
                    dimension: Dimension::of([0, 0, -i8::from(derivative == 1), 0, 0, 0]),
                    nature: angular(),
                };
                return Some(Quantity::Scalar(typed));
            }
            Some(Motions::Shifting | Motions::ShiftingPlanar { .. }) => say::point_mass_turns(&name),
            Some(_) => say::no_angle_in_space(&name, &field.text),
            None => say::angle_of_prescribed(&name, &field.text),
        };
        self.errors.at(field.span, message);
        None
    }

    fn turning(&mut self, frame: FrameId, field: &Name) -> Option<Thing<'a>> {
        if !self.has_orientation(frame, field.span.into()) {
            return None;
        }
        let marker = self.marker(Marker::Turn { frame });
        let values = observed(marker, 1, None);
        // About the normal of the plane only.
        let (values, axes) = match self.frame_normal(frame) {
            Some(normal) => {
                let mut flat = algebra::numbers([0.0; 3]);
                flat[normal] = values[normal].clone();
                (flat, vec![normal])
            }
            None => (values, vec![0, 1, 2]),
        };
        let plane = if let [normal] = axes[..] { Some(normal) } else { None };
        Some(Thing::Shown {
            vector: Vectorial {
                values,
                axes,
                dimension: Dimension::of([0, 0, -1, 0, 0, 0]),
                nature: angular(),
                frame: Some(if plane.is_some() { frame } else { INERTIAL }),
            },
            plane,
            shown: frame,
        })
    }

    /// `C.multiplier`, `C.force` or `C.moment` of a declared constraint.
    fn of_constraint(&mut self, name: &'a Name, field: &'a Name, scope: Scope) -> Option<Thing<'a>> {
        let known = self.constraints.get(name.text.as_str())?.clone();
        if scope != Scope::Output {
            self.errors.at(field.span, say::only_in_outputs(&field.text));
            return None;
        }
        if field.text != "multiplier" {
            let message = suggest::unknown(
                "quantity of a constraint",
                &field.text,
                members::words(members::OF_CONSTRAINTS),
            );
            self.errors.at(field.span, message);
            return None;
        }
        let energy = Dimension::of([2, 1, -2, 0, 0, 0]);
        let dimension = energy.divide(known.dimension)?;
        let observe = |row| {
            model::Expr::Observed(Observable::Multiplier {
                constraint: known.id,
                row,
            })
        };
        let Some(axes) = known.axes else {
            return Some(Thing::Value(Quantity::Scalar(Typed::new(observe(0), dimension))));
        };
        let mut values = algebra::numbers([0.0; 3]);
        for (row, axis) in axes.iter().enumerate() {
            values[*axis] = observe(row);
        }
        Some(Thing::Value(Quantity::Vector(Vectorial {
            values,
            axes,
            dimension,
            nature: Nature::default(),
            frame: known.frame,
        })))
    }

    /// What a joint with multipliers exerts on its first party.
    pub(in crate::check) fn exerted(&mut self, built: &Built, is_moment: bool) -> Thing<'a> {
        let (constraint, plane) = (built.constraint, built.normal);
        let axes = match (plane, is_moment) {
            (Some(normal), true) => vec![normal],
            (Some(normal), false) => model::Space::Planar { normal }.axes().to_vec(),
            (None, _) => vec![0, 1, 2],
        };
        let mut values = algebra::numbers([0.0; 3]);
        for &component in &axes {
            values[component] = model::Expr::Observed(Observable::ConstraintReaction {
                constraint,
                moment: is_moment,
                component,
            });
        }
        if built.is_reversed {
            values = values.map(algebra::negate);
        }
        let dimension = Dimension::of([1 + i8::from(is_moment), 1, -2, 0, 0, 0]);
        Thing::Shown {
            vector: Vectorial {
                values,
                axes,
                dimension,
                nature: Nature::default(),
                frame: Some(INERTIAL),
            },
            plane,
            shown: INERTIAL,
        }
    }
}

/// That of an angle.
pub fn angular() -> Nature {
    Nature::angular()
}

pub fn origin(frame: FrameId) -> Spot {
    let at = algebra::numbers([0.0; 3]);
    Spot::Rigid { frame, at }
}
