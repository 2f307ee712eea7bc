//! What outputs observe: points of bodies and reactions of joints in their own frames; all else in `members`.

use super::section_forces::known_words;
use crate::check::frames::plane::{normal, plane};
use crate::check::places::place::Place;
use crate::check::values::expr::function;
use crate::check::values::quantity::{Nature, Typed};
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial, is_function};
use crate::check::values::words::AXES;
use crate::check::values::words::{TOTAL, is_balance, is_carried};
use crate::check::{Check, say};
use crate::joints::algebra;
use crate::model::{self, FrameId, JointKind, Observable, PointQuantity, Space};
use crate::parse::tree::{Expr, ExprKind, Keyword, Name};
use crate::suggest;
use crate::units::Dimension;

/// Something observed: one component, or all that there are.
pub struct Seen {
    /// Components with the names of their axes.
    pub components: Vec<(&'static str, Observable)>,
    /// Their dimension.
    pub dimension: Dimension,
    /// Whether a single component was asked for.
    pub is_scalar: bool,
}

/// `base.field.field`, from the left; the first part is the shortest that names something.
fn chain(expr: &Expr) -> (&Expr, Vec<&Name>) {
    let mut fields = Vec::new();
    let mut at = expr;
    while let ExprKind::Member { base, field, .. } = &at.kind {
        let is_place = matches!(base.kind, ExprKind::Name(_) | ExprKind::Indexed { .. });
        if is_place {
            break;
        }
        fields.push(field);
        at = base;
    }
    fields.reverse();
    (at, fields)
}

impl<'a> Check<'a> {
    /// A member expression as a scalar.
    pub(in crate::check) fn member(&mut self, expr: &'a Expr, scope: Scope) -> Option<Typed> {
        self.is_no_method(expr)?;
        if scope < Scope::Constraint {
            self.errors.at(expr.area, say::OBSERVED_OUTSIDE_OUTPUT);
            return None;
        }
        let quantity = self.observe(expr, scope)?;
        self.scalar(expr, quantity)
    }

    /// What a member expression, or the name of a frame, is.
    pub(in crate::check) fn observe(&mut self, expr: &'a Expr, scope: Scope) -> Option<Quantity> {
        self.is_no_method(expr)?;
        if scope == Scope::Output && self.is_plain(expr) {
            return self.observe_plain(expr);
        }
        let thing = self.thing(expr, scope)?;
        self.seen(thing, expr)
    }

    /// Refuses functions that are called like methods: `x.sqrt()`.
    fn is_no_method(&mut self, expr: &Expr) -> Option<()> {
        let ExprKind::Member {
            field,
            arguments: Some(_),
            ..
        } = &expr.kind
        else {
            return Some(());
        };
        let name = field.text.as_str();
        let message = match name {
            "pow" | "powi" | "powf" | "squared" => crate::messages::POWER.to_string(),
            _ if function(name).is_some() || is_function(name) => say::method(name),
            _ => return Some(()),
        };
        self.errors.at(field.span, message);
        None
    }

    /// Whether something is observed that the body or eliminated joint has in its own frame.
    fn is_plain(&self, expr: &Expr) -> bool {
        let (first, fields) = chain(expr);
        let ExprKind::Member { base, field, .. } = &first.kind else {
            return false;
        };
        let (ExprKind::Name(name) | ExprKind::Indexed { base: name, .. }) = &base.kind else {
            return false;
        };
        let words = fields
            .iter()
            .chain([&field])
            .map(|word| word.text.as_str())
            .collect::<Vec<_>>();
        let elsewhere = ["in", "beside", "acceleration"];
        let is_elsewhere = words.iter().any(|word| elsewhere.contains(word) || is_balance(word));
        let name = name.text.as_str();
        if self.names.get(name).is_some_and(|item| item.keyword == Keyword::Spring) {
            return false;
        }
        let has_rows = self.joints.get(name).is_some_and(|joint| joint.built.is_some());
        !is_elsewhere && name != TOTAL && !self.is_frame(name) && !has_rows && !self.constraints.contains_key(name)
    }

    /// A point of a body or a reaction of a joint, in the own frame.
    fn observe_plain(&mut self, expr: &'a Expr) -> Option<Quantity> {
        let (first, fields) = chain(expr);
        if let [word, rest @ ..] = &fields[..]
            && is_carried(&word.text)
            && !has_arguments_behind(expr, first)
        {
            return self.carried_by(first, word, rest);
        }
        let (seen, frame) = self.plain(expr)?;
        let mut values = algebra::numbers([0.0; 3]);
        let mut axes = Vec::new();
        for (name, observable) in seen.components {
            let axis = AXES.iter().position(|axis| *axis == name)?;
            values[axis] = model::Expr::Observed(observable);
            axes.push(axis);
        }
        let vector = Vectorial {
            values,
            dimension: seen.dimension,
            nature: Nature::default(),
            frame,
            axes,
        };
        Some(if seen.is_scalar {
            Quantity::Scalar(vector.component(vector.axes[0]))
        } else {
            Quantity::Vector(vector)
        })
    }

    fn plain(&mut self, expr: &'a Expr) -> Option<(Seen, Option<FrameId>)> {
        let (first, fields) = chain(expr);
        let ExprKind::Member { base, field, arguments } = &first.kind else {
            self.errors.at(expr.area, say::NOTHING_OBSERVED);
            return None;
        };
        let (ExprKind::Name(name) | ExprKind::Indexed { base: name, .. }) = &base.kind else {
            self.errors.at(expr.area, say::NOTHING_OBSERVED);
            return None;
        };
        if has_arguments_behind(expr, first) {
            self.errors.at(expr.area, say::NOTHING_OBSERVED);
            return None;
        }
        match self.names.get(name.text.as_str()).map(|item| item.keyword) {
            Some(Keyword::Joint) if arguments.is_none() => {
                let mut fields = fields;
                fields.insert(0, field);
                let frame = self.joints.get(name.text.as_str()).and_then(|joint| joint.frame);
                Some((self.reaction(name, &fields)?, frame))
            }
            Some(Keyword::Body) => {
                let place = self.place(first)?;
                let frame = place.body.frame;
                Some((self.point(place, &fields)?, frame))
            }
            _ => {
                self.no_thing(name);
                None
            }
        }
    }

    /// Reports a name that nothing can be observed of.
    pub(in crate::check) fn no_thing(&mut self, name: &Name) {
        match self.names.get(name.text.as_str()).copied() {
            Some(item) if Self::is_broken(item) => {}
            Some(item) => {
                let message = say::not_observable(&name.text, &say::a(item.keyword.noun()));
                self.errors.at(name.span, message);
            }
            None => {
                if self.is_news(&name.text) {
                    let known = self.known(&[Keyword::Body, Keyword::Rigid, Keyword::Joint, Keyword::Constraint]);
                    self.errors
                        .at(name.span, suggest::unknown("body or joint", &name.text, known));
                }
            }
        }
    }

    fn point(&mut self, place: Place, fields: &[&'a Name]) -> Option<Seen> {
        let space = place.body.space?;
        let (what, rest) = match fields.split_first().map(|(first, rest)| (first.text.as_str(), rest)) {
            Some(("velocity", rest)) => (PointQuantity::Velocity, rest),
            Some(("slope", rest)) => (PointQuantity::Slope, rest),
            Some(("ey" | "ez", rest)) => match self.section_axis(&place, fields[0])? {
                1 => (PointQuantity::SectionY, rest),
                _ => (PointQuantity::SectionZ, rest),
            },
            Some(("position", rest)) => (PointQuantity::Position, rest),
            Some(("moment_x", _)) if place.has_section => {
                self.errors.at(fields[0].span, say::MOMENT_ABOUT_AXIS);
                return None;
            }
            Some((word, _)) if !AXES.contains(&word) => {
                let mut known = vec!["x", "y", "z", "velocity", "slope", "position"];
                known.extend(known_words(&place));
                self.errors
                    .at(fields[0].span, suggest::unknown("quantity of a point", word, known));
                return None;
            }
            _ => (PointQuantity::Position, fields),
        };
        let dimension = Dimension::of(match what {
            PointQuantity::Position => [1, 0, 0, 0, 0, 0],
            PointQuantity::Velocity => [1, 0, -1, 0, 0, 0],
            PointQuantity::Slope | PointQuantity::SectionY | PointQuantity::SectionZ => [0; 6],
        });
        let axes = space.axes().to_vec();
        let (axes, is_scalar) = self.axes(rest, &axes, |axis| match normal(space) {
            Some(normal) => say::always_zero(AXES[axis], plane(normal)),
            None => String::new(),
        })?;
        let body = place.body.id;
        let observe = |axis| Observable::Point {
            body,
            at: place.at.clone(),
            what,
            component: axis,
        };
        let components = axes.into_iter().map(|axis| (AXES[axis], observe(axis))).collect();
        Some(Seen {
            components,
            dimension,
            is_scalar,
        })
    }

    pub(in crate::check) fn reaction(&mut self, name: &Name, fields: &[&'a Name]) -> Option<Seen> {
        let known = self.joints.get(name.text.as_str())?.clone();
        if known.is_repeated {
            self.repeated_reaction(name);
            return None;
        }
        if known.is_share {
            self.errors.at(name.span, say::reaction_of_share(&name.text));
            return None;
        }
        // Of a joint with mistakes nothing is known.
        let kind = known.kind?;
        let (first, rest) = fields.split_first()?;
        let is_moment = match first.text.as_str() {
            "force" => false,
            "moment" => true,
            "angle" | "slide" => {
                self.errors.at(name.span, say::no_coordinates(&name.text));
                return None;
            }
            other => {
                self.errors
                    .at(first.span, suggest::unknown("reaction", other, ["force", "moment"]));
                return None;
            }
        };
        let space = known.body?.space?;
        if is_moment && kind == JointKind::Pin {
            self.errors.at(first.span, say::pin_moment(&name.text));
            return None;
        }
        let axes = match space {
            Space::Planar { normal } if is_moment => vec![normal],
            space => space.axes().to_vec(),
        };
        let (axes, is_scalar) = self.axes(rest, &axes, |axis| match (normal(space), is_moment) {
            (Some(normal), true) => say::moment_always_zero(AXES[axis], plane(normal), AXES[normal]),
            (Some(normal), false) => say::always_zero(AXES[axis], plane(normal)),
            (None, _) => String::new(),
        })?;
        let dimension = Dimension::of(if is_moment {
            [2, 1, -2, 0, 0, 0]
        } else {
            [1, 1, -2, 0, 0, 0]
        });
        let observe = |axis| Observable::Reaction {
            joint: known.id,
            moment: is_moment,
            component: axis,
        };
        let components = axes.into_iter().map(|axis| (AXES[axis], observe(axis))).collect();
        Some(Seen {
            components,
            dimension,
            is_scalar,
        })
    }

    /// The axis that the last word asks for, or all that there are.
    pub(in crate::check) fn axes(
        &mut self,
        fields: &[&'a Name],
        valid: &[usize],
        zero: impl Fn(usize) -> String,
    ) -> Option<(Vec<usize>, bool)> {
        let Some((first, rest)) = fields.split_first() else {
            return Some((valid.to_vec(), false));
        };
        if let Some(surplus) = rest.first() {
            self.errors.at(surplus.span, say::after_component(&surplus.text));
            return None;
        }
        let Some(axis) = AXES.iter().position(|axis| *axis == first.text) else {
            let known = valid.iter().map(|axis| AXES[*axis]).collect::<Vec<_>>();
            self.errors
                .at(first.span, suggest::unknown("component", &first.text, known));
            return None;
        };
        if !valid.contains(&axis) {
            self.errors.at(first.span, zero(axis));
            return None;
        }
        Some((vec![axis], true))
    }
}

/// Whether a word behind the place is called: `beam.end.x(3)`.
fn has_arguments_behind(expr: &Expr, first: &Expr) -> bool {
    let mut at = expr;
    while !std::ptr::eq(at, first) {
        let ExprKind::Member { base, arguments, .. } = &at.kind else {
            return false;
        };
        if arguments.is_some() {
            return true;
        }
        at = base;
    }
    false
}
