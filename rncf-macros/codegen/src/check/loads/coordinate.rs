//! Springs along a coordinate of the user's own: an expression of positions, directions, angles and time. What acts on each place is
//! the force times the derivative of the coordinate by it, so that the work is that of the force along the coordinate.

use super::spring::{self, Acting, Elastic};
use crate::check::values::quantity::{Nature, Typed, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::Quantity;
use crate::check::{Check, Shape, say};
use crate::joints::algebra::{self, Vector, negate, number, subtract};
use crate::model::{Expr as Value, MarkerId, Observable};
use crate::parse::tree::{Call, Expr};
use crate::units::Dimension;

const SPRING: Shape = Shape {
    positional: 1,
    named: &["stiffness", "damping", "value"],
    required: &[],
    usage: "coordinate(20 mm * pinion.angle + 60 mm * wheel.angle, stiffness = 100 MN/m)",
};
const LAW: Shape = Shape {
    positional: 1,
    named: &["force", "moment"],
    required: &[],
    usage: "coordinate_law(2 * pinion.angle + wheel.angle, moment = k * value + c * rate)",
};

/// What a coordinate is measured in, and what belongs to it.
struct Measure {
    value: Wanted,
    is_angle: bool,
    rate: [i8; 6],
    stiffness: Wanted,
    damping: Wanted,
    /// Name of what acts along it.
    acts: &'static str,
    law: Wanted,
}

const LENGTHS: Measure = Measure {
    value: Wanted::new("the value without force", [1, 0, 0, 0, 0, 0], "m"),
    is_angle: false,
    rate: [1, 0, -1, 0, 0, 0],
    stiffness: spring::STIFFNESS,
    damping: spring::DAMPING,
    acts: "force",
    law: spring::FORCE,
};

const ANGLES: Measure = Measure {
    value: Wanted::new("the value without moment", [0; 6], "rad"),
    is_angle: true,
    rate: [0, 0, -1, 0, 0, 0],
    stiffness: spring::TORSION,
    damping: spring::FRICTION,
    acts: "moment",
    law: spring::MOMENT,
};

/// A coordinate and what it moves.
struct Coordinate {
    value: Value,
    measure: &'static Measure,
    slopes: Vec<(MarkerId, Vector)>,
}

impl<'a> Check<'a> {
    pub(super) fn coordinate_spring(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &SPRING)?;
        let coordinate = self.coordinate_along(arguments.positional[0])?;
        let measure = coordinate.measure;
        let stiffness = self.stiffness(call, arguments.named.get("stiffness").copied(), measure.stiffness);
        let damping = self.damping(arguments.named.get("damping").copied(), measure.damping);
        let rest = match arguments.named.get("value") {
            Some(expr) if measure.is_angle => self.angle(expr, Scope::Parameter, measure.value.what),
            Some(expr) => self.quantity(expr, Scope::Parameter, measure.value),
            None => Some(number(0.0)),
        };
        let (stiffness, damping, rest) = (stiffness?, damping?, rest?);
        let strain = subtract(coordinate.value.clone(), rest);
        let elastic = Elastic::new(stiffness, damping, strain, coordinate.rate());
        let energy = elastic.potential();
        let acting = coordinate.acted_on_by(elastic.force);
        Some(Acting {
            shown: spring::stored(acting.shown, &elastic.stored),
            energy,
            ..acting
        })
    }

    pub(super) fn coordinate_law(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &LAW)?;
        let coordinate = self.coordinate_along(arguments.positional[0])?;
        let measure = coordinate.measure;
        let (Some(law), 1) = (arguments.named.get(measure.acts).copied(), arguments.named.len()) else {
            self.errors.at(call.area, say::coordinate_law(measure.acts));
            return None;
        };
        let force = self.in_law(coordinate.locals(), |check| {
            check.quantity(law, Scope::Force, measure.law)
        })?;
        Some(coordinate.acted_on_by(force))
    }

    fn coordinate_along(&mut self, expr: &'a Expr) -> Option<Coordinate> {
        let typed = match self.with_lookups(|check| check.value(expr, Scope::Constraint))? {
            Quantity::Scalar(typed) => typed,
            Quantity::Vector(_) => {
                self.errors.at(expr.area, say::COORDINATE_IS_VECTOR);
                return None;
            }
        };
        let measures = [&LENGTHS, &ANGLES];
        let is_measured = |measure: &&Measure| typed.dimension == Dimension::of(measure.value.dimension);
        let Some(measure) = measures.into_iter().find(is_measured) else {
            self.errors.at(expr.area, say::coordinate_measure(&typed.describe()));
            return None;
        };
        let slopes = slopes(&typed.value);
        if !slopes.iter().any(|(marker, _)| self.moves(*marker)) {
            self.errors.at(expr.area, say::NOTHING_SPRUNG);
            return None;
        }
        Some(Coordinate {
            value: typed.value,
            measure,
            slopes,
        })
    }
}

impl Coordinate {
    fn rate(&self) -> Value {
        Value::Rate(Box::new(self.value.clone()))
    }

    fn locals(&self) -> [(&'static str, Typed); 2] {
        let nature = Nature::of_unit(i8::from(self.measure.is_angle));
        let typed = |value, dimension| Typed {
            nature,
            ..Typed::new(value, Dimension::of(dimension))
        };
        [
            ("value", typed(self.value.clone(), self.measure.value.dimension)),
            ("rate", typed(self.rate(), self.measure.rate)),
        ]
    }

    /// What a force does that is positive against growing values.
    fn acted_on_by(self, force: Value) -> Acting {
        let against = negate(force.clone());
        let forces = self.slopes.iter();
        let forces = forces.map(|(marker, slope)| (*marker, algebra::scale(&against, slope)));
        let acts = Typed::new(force, Dimension::of(self.measure.law.dimension));
        Acting {
            forces: forces.collect(),
            energy: None,
            shown: spring::shown(self.measure.acts, acts, self.locals()),
        }
    }
}

/// Derivatives of an expression by the markers that it is a function of.
fn slopes(value: &Value) -> Vec<(MarkerId, Vector)> {
    let mut slopes: Vec<(MarkerId, Vector)> = Vec::new();
    value.each_observable(&mut |observable| {
        let &Observable::Marker { marker, component, .. } = observable else {
            return;
        };
        let known = slopes.iter().position(|(other, _)| *other == marker);
        let at = known.unwrap_or_else(|| {
            slopes.push((marker, algebra::numbers([0.0; 3])));
            slopes.len() - 1
        });
        let by = Value::Observed(observable.clone());
        slopes[at].1[component] = Value::Slope(Box::new(value.clone()), Box::new(by));
    });
    slopes
}
