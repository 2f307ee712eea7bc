//! Loads per length that are integrated at points: functions of place, velocity and axes of the particle; and gravity that
//! changes from place to place.

use std::collections::HashMap;

use super::load::{GRAVITY, mentions};
use crate::check::bodies::body;
use crate::check::frames::plane::normal;
use crate::check::values::quantity::{Nature, Vector, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::values::words::PARTICLE;
use crate::check::{Check, fold, say};
use crate::joints::algebra::{self, cross, divide, dot, normalised, observed};
use crate::joints::unit;
use crate::model::{Distributed, Expr as Value, INERTIAL, LoadKind, Observable, ParticleVector, Space};
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Item};
use crate::suggest;
use crate::units::Dimension;

const FORCE: Wanted = Wanted {
    what: "a load per length",
    dimension: [0, 1, -2, 0, 0, 0],
    unit: "N/m",
};
const MOMENT: Wanted = Wanted {
    what: "a moment per length",
    dimension: [1, 1, -2, 0, 0, 0],
    unit: "N*m/m",
};

const LENGTH: [i8; 6] = [1, 0, 0, 0, 0, 0];
const SPEED: [i8; 6] = [1, 0, -1, 0, 0, 0];

/// Points of an element where nothing else is asked for: exact for a constant load, and a linear one times a cubic shape.
const POINTS: usize = 3;
const MOST_POINTS: usize = 5;

const USAGE: &str = "distributed(beam, -2 [kg/(m*s)] * velocity)";
const ARGUMENTS: [&str; 3] = ["moment", "in", "points"];

/// What a body has at a particle.
struct Particle {
    /// Plane normal.
    plane: Option<usize>,
    has_section: bool,
    /// Unit vectors of the section: along its normal (of a centre line its tangent), y and z; `None`: a centre line in space.
    axes: Option<[algebra::Vector; 3]>,
}

impl Particle {
    fn new(space: Space, has_section: bool) -> Self {
        let plane = normal(space);
        let vector = |of: ParticleVector| observed(of.marker(), 0, plane);
        let axes = match (plane, has_section) {
            (None, false) => None,
            (None, true) => {
                let y = normalised(&vector(ParticleVector::SectionY));
                let across = cross(&vector(ParticleVector::SectionY), &vector(ParticleVector::SectionZ));
                let x = normalised(&across);
                let z = cross(&x, &y);
                Some([x, y, z])
            }
            (Some(normal), _) => {
                let z = algebra::numbers(unit(normal));
                Some(if has_section {
                    let y = normalised(&vector(ParticleVector::SectionY));
                    [cross(&y, &z), y, z]
                } else {
                    let x = normalised(&vector(ParticleVector::Slope));
                    let y = cross(&z, &x);
                    [x, y, z]
                })
            }
        };
        Self {
            plane,
            has_section,
            axes,
        }
    }

    /// The words of the particle.
    fn words(&self, space: Space) -> HashMap<&'static str, Vectorial> {
        let vectorial = |values: algebra::Vector, dimension: [i8; 6], axes: &[usize]| Vectorial {
            values,
            axes: axes.to_vec(),
            dimension: Dimension::of(dimension),
            nature: Nature::default(),
            frame: Some(INERTIAL),
        };
        let (position, slope) = (ParticleVector::Position.marker(), ParticleVector::Slope.marker());
        let slope = observed(slope, 0, self.plane);
        let tangent = normalised(&slope);
        let axes = space.axes();
        let mut words = HashMap::from([
            ("position", vectorial(observed(position, 0, None), LENGTH, &[0, 1, 2])),
            (PARTICLE, vectorial(observed(position, 1, self.plane), SPEED, axes)),
            ("slope", vectorial(slope, [0; 6], axes)),
            ("tangent", vectorial(tangent, [0; 6], axes)),
        ]);
        if let Some([_, y, z]) = &self.axes {
            words.insert("section_y", vectorial(y.clone(), [0; 6], axes));
            if self.plane.is_none() {
                words.insert("section_z", vectorial(z.clone(), [0; 6], axes));
            }
        }
        words
    }

    /// Forces on the vectors of the particle that do the work of a moment on its section, or of a planar line on its slope.
    fn turned_by(&self, moment: &algebra::Vector) -> Vec<(ParticleVector, algebra::Vector)> {
        let vector = |of: ParticleVector| observed(of.marker(), 0, self.plane);
        if self.plane.is_some() {
            let of = if self.has_section {
                ParticleVector::SectionY
            } else {
                ParticleVector::Slope
            };
            return vec![(of, algebra::turning(moment, &vector(of)))];
        }
        // See `lower/loads.rs`: b x Q_y + c x Q_z = M.
        let (b, c) = (vector(ParticleVector::SectionY), vector(ParticleVector::SectionZ));
        let n = cross(&b, &c);
        let square = dot(&n, &n);
        let part = |along: &algebra::Vector| divide(dot(moment, along), square.clone());
        let twist = algebra::multiply(algebra::number(0.5), part(&n));
        let sum = |bending: Value, twist: Value, axis: &algebra::Vector| {
            algebra::both(
                &algebra::scale(&bending, &n),
                &algebra::scale(&twist, axis),
                algebra::add,
            )
        };
        vec![
            (
                ParticleVector::SectionY,
                sum(algebra::negate(part(&c)), twist.clone(), &c),
            ),
            (ParticleVector::SectionZ, sum(part(&b), algebra::negate(twist), &b)),
        ]
    }
}

impl<'a> Check<'a> {
    /// `distributed(BODY, FORCE, moment = .., in = section, points = n)`
    pub(in crate::check) fn distributed_load(&mut self, item: &Item, call: &'a Call) -> Option<()> {
        let positional: Vec<&Argument> = call
            .arguments
            .iter()
            .filter(|argument| argument.name.is_none())
            .collect();
        let [Argument { value: place, .. }, Argument { value: expr, .. }] = positional[..] else {
            self.errors.at(call.area, say::usage("distributed", USAGE));
            return None;
        };
        let named = self.named_arguments(call)?;
        let (body, instance) = self.named_body(place)?;
        if item.repeat.is_some() && instance != Some(Value::Index)
            || instance.is_some_and(|instance| instance != Value::Index)
        {
            self.errors.at(place.area, say::DENSITY_REPETITION);
            return None;
        }
        let points = match named.get("points") {
            None => POINTS,
            Some(count) => self.points_of(count)?,
        };
        let in_section = match named.get("in") {
            None => false,
            Some(frame) => match &frame.kind {
                ExprKind::Name(name) if name.text == "section" => true,
                _ => {
                    self.errors.at(frame.area, say::DISTRIBUTED_AXES);
                    return None;
                }
            },
        };
        let space = body.space?;
        let has_section = self.has_section(body.id)?;
        let particle = Particle::new(space, has_section);
        if in_section && particle.axes.is_none() {
            self.errors.at(named["in"].area, say::LINE_WITHOUT_SECTION);
            return None;
        }
        let moment = named.get("moment").copied();
        if let Some(moment) = moment.filter(|_| particle.axes.is_none()) {
            self.errors.at(moment.area, say::LINE_WITHOUT_MOMENT);
            return None;
        }
        let (force, moment) = self.with_particle(particle.words(space), |check| {
            check.along_axis(|check| {
                let names = check.definitions(call)?;
                let force = check.of_particle(expr, (&particle, body), in_section, FORCE);
                let moment = moment.map(|moment| check.of_particle(moment, (&particle, body), in_section, MOMENT));
                names.into_iter().for_each(|name| {
                    check.locals.remove(name);
                });
                Some((force?, moment))
            })
        })?;
        let moment = match moment {
            Some(moment) => Some(moment?),
            None => None,
        };
        let mut forces = vec![(ParticleVector::Position, force)];
        if let Some(moment) = moment {
            forces.extend(particle.turned_by(&moment));
        }
        let along = |value: &Value| fold::has_arclength(value) || !fold::tables(value).is_empty();
        if self.body_of(body.id).is_some_and(|body| body.piece.is_some())
            && forces.iter().flat_map(|(_, components)| components).any(along)
        {
            self.errors.at(expr.area, say::LOAD_ALONG_CORNERS);
            return None;
        }
        self.model.distributed.push(Distributed {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            body: body.id,
            points,
            forces,
        });
        Some(())
    }

    /// The arguments with names of this form; others are definitions, which something must read.
    fn named_arguments(&mut self, call: &'a Call) -> Option<HashMap<&'a str, &'a Expr>> {
        let mut named = HashMap::new();
        let before = self.errors.len();
        for (at, argument) in call.arguments.iter().enumerate() {
            let Some(name) = &argument.name else { continue };
            let text = name.text.as_str();
            let others = call.arguments.iter().enumerate().filter(|(other, _)| *other != at);
            let mut values = others.map(|(_, other)| &other.value);
            if named.contains_key(text) {
                self.errors.at(name.span, say::twice(text));
            } else if !ARGUMENTS.contains(&text) && !values.any(|value| mentions(value, text)) {
                let message = suggest::unknown("argument of `distributed`", text, ARGUMENTS);
                self.errors.at(name.span, say::or_nothing_reads(&message, text));
            } else if self.names.contains_key(text) && !ARGUMENTS.contains(&text) {
                self.errors.at(name.span, say::definition_has_meaning(text));
            }
            named.insert(text, &argument.value);
        }
        (self.errors.len() == before).then_some(named)
    }

    /// Resolves what the load defines for itself, in the order of the text; the names of its numbers.
    fn definitions(&mut self, call: &'a Call) -> Option<Vec<&'a str>> {
        let mut names = Vec::new();
        for argument in &call.arguments {
            let Some(name) = argument.name.as_ref().map(|name| name.text.as_str()) else {
                continue;
            };
            if ARGUMENTS.contains(&name) {
                continue;
            }
            match self.value(&argument.value, Scope::Force) {
                Some(Quantity::Scalar(typed)) => {
                    self.locals.insert(name, typed);
                    names.push(name);
                }
                Some(Quantity::Vector(vector)) => {
                    self.particle.insert(name, vector);
                }
                None => {
                    names.into_iter().for_each(|name| {
                        self.locals.remove(name);
                    });
                    return None;
                }
            }
        }
        Some(names)
    }

    fn points_of(&mut self, count: &'a Expr) -> Option<usize> {
        let typed = self.expr(count, Scope::Constant)?;
        let value = fold::constant(&typed.value).filter(|_| typed.dimension.is_none());
        let is_count = |value: &f64| *value == value.trunc() && (1.0..=MOST_POINTS as f64).contains(value);
        let Some(value) = value.filter(is_count) else {
            self.errors.at(count.area, say::DISTRIBUTED_POINTS);
            return None;
        };
        Some(value as usize)
    }

    /// A vector as a function of the particle, inertial axes.
    fn of_particle(
        &mut self,
        expr: &'a Expr,
        (particle, body): (&Particle, body::Known),
        in_section: bool,
        wanted: Wanted,
    ) -> Option<algebra::Vector> {
        let space = body.space?;
        let vector = self.field_vector(expr, wanted)?;
        let is_moment = wanted.unit == MOMENT.unit;
        let before = self.errors.len();
        let components = Vector {
            values: vector.values.clone(),
            areas: [expr.area; 3],
            area: expr.area,
        };
        let values = match (in_section, &particle.axes) {
            (true, Some(axes)) => {
                if vector.frame.is_some() {
                    self.errors.at(expr.area, say::DISTRIBUTED_IN_SECTION);
                    return None;
                }
                let zeros = |axes: &[usize]| {
                    let mut axes = axes.iter();
                    axes.all(|&axis| fold::constant(&components.values[axis]) == Some(0.0))
                };
                let leaves = particle.plane.is_some() && !(if is_moment { zeros(&[0, 1]) } else { zeros(&[2]) });
                if leaves {
                    self.errors.at(
                        expr.area,
                        if is_moment {
                            say::SECTION_MOMENT_IN_PLANE
                        } else {
                            say::SECTION_FORCE_IN_PLANE
                        },
                    );
                }
                let parts = axes.iter().zip(&vector.values);
                parts.fold(algebra::numbers([0.0; 3]), |sum, (axis, value)| {
                    algebra::both(&sum, &algebra::scale(value, axis), algebra::add)
                })
            }
            _ => {
                if is_moment {
                    if let Space::Planar { .. } = space {
                        self.moment_direction(&components, space, None, body.frame, INERTIAL);
                    }
                } else {
                    self.in_plane(&components, space, "the load");
                }
                vector.values.clone()
            }
        };
        (self.errors.len() == before).then_some(values)
    }

    /// Resolves with the words of a particle.
    fn with_particle<T>(&mut self, words: HashMap<&'a str, Vectorial>, resolve: impl FnOnce(&mut Self) -> T) -> T {
        self.particle = words;
        let result = resolve(self);
        self.particle.clear();
        result
    }

    /// A vector of params, time and the particle alone.
    fn field_vector(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Vectorial> {
        let vector = if let ExprKind::Vector { .. } = expr.kind {
            let vector = self.vector(expr, Scope::Force, wanted)?;
            Vectorial {
                values: vector.values,
                axes: vec![0, 1, 2],
                dimension: Dimension::of(wanted.dimension),
                nature: Nature::default(),
                frame: None,
            }
        } else {
            self.wanted_vector(expr, Scope::Force, wanted)?
        };
        let is_elsewhere = |value: &Value| {
            value.contains(&|part| {
                matches!(part, Value::Observed(Observable::Marker { marker, .. }) if ParticleVector::of(*marker).is_none())
                    || matches!(part, Value::Observed(other) if !matches!(other, Observable::Marker { .. }))
            })
        };
        if vector.values.iter().any(is_elsewhere) {
            self.errors.at(expr.area, say::DISTRIBUTED_ELSEWHERE);
            return None;
        }
        Some(vector)
    }

    /// `gravity(VECTOR)` as a function of the `position` of each particle of mass.
    pub(in crate::check) fn gravity_of_place(&mut self, expr: &'a Expr) -> Option<LoadKind> {
        let position = Vectorial {
            values: observed(ParticleVector::Position.marker(), 0, None),
            axes: vec![0, 1, 2],
            dimension: Dimension::of(LENGTH),
            nature: Nature::default(),
            frame: Some(INERTIAL),
        };
        let words = HashMap::from([("position", position)]);
        let vector = self.with_particle(words, |check| check.field_vector(expr, GRAVITY))?;
        Some(LoadKind::Around(vector.values))
    }
}
