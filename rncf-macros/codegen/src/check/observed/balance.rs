//! Mass, momentum, angular momentum, centre of mass and energies of bodies, of rigid bodies and of `total`, all that moves.

use super::members::{self, Thing};
use crate::check::frames::plane::normal;
use crate::check::values::quantity::{Nature, Typed};
use crate::check::values::read;
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::values::words::{BALANCES, TOTAL, balance_words, is_balance};
use crate::check::{Check, say};
use crate::joints::algebra;
use crate::model::{About, BalanceQuantity, Expr as Value, FrameId, INERTIAL, LoadKind, Observable, Owner, Space};
use crate::parse::tree::{Argument, Expr, ExprKind, Keyword, Name};
use crate::units::Dimension;

impl<'a> Check<'a> {
    /// `total.momentum`, `beam.mass`; `None` in the outer option where something else is written.
    pub(in crate::check) fn balance_of_thing(&mut self, expr: &'a Expr, scope: Scope) -> Option<Option<Thing<'a>>> {
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            return None;
        };
        let (ExprKind::Name(name) | ExprKind::Indexed { base: name, .. }) = &base.kind else {
            return None;
        };
        if name.text == TOTAL {
            if !is_balance(&field.text) {
                let message = crate::suggest::unknown("quantity of all that moves", &field.text, balance_words());
                self.errors.at(field.span, message);
                return Some(None);
            }
        } else if !is_balance(&field.text) || self.names.get(name.text.as_str())?.keyword != Keyword::Body {
            return None;
        }
        Some(
            self.balance_owner(base)
                .and_then(|(of, plane)| self.balance(of, plane, expr, field, arguments.as_deref(), scope)),
        )
    }

    /// What stands before the dot, and the plane that it stays in.
    fn balance_owner(&mut self, base: &'a Expr) -> Option<(Owner, Option<usize>)> {
        let (ExprKind::Name(name) | ExprKind::Indexed { base: name, .. }) = &base.kind else {
            self.errors.at(base.area, say::NOTHING_OBSERVED);
            return None;
        };
        if name.text == TOTAL {
            let plane = self.scene_normal();
            return Some((Owner::All, plane));
        }
        if self.is_frame(&name.text) {
            let frame = self.frame(name)?;
            return self.owning_frame(frame, name);
        }
        let (body, instance) = self.named_body(base)?;
        if instance.is_some() || body.repeat.is_some() {
            self.errors.at(base.area, say::balance_of_repeated(&name.text));
            return None;
        }
        let frame = body.frame?;
        let plane = normal(body.space?).filter(|normal| self.stays_in(frame, *normal));
        Some((Owner::Body(body.id), plane))
    }

    /// A free frame with mass of its own.
    fn owning_frame(&mut self, frame: FrameId, name: &Name) -> Option<(Owner, Option<usize>)> {
        // Fixtures give mass, too, and may be declared later.
        let carries = self.model.frames[frame.0]
            .free
            .as_ref()
            .is_some_and(|free| free.is_body || !free.parts.is_empty() || self.has_fixture(&name.text));
        if !carries {
            self.errors.at(name.span, say::balance_of_massless(&name.text));
            return None;
        }
        let plane = self.frame_normal(frame);
        Some((Owner::Frame(frame), plane))
    }

    /// Whether a fixture is declared on a frame.
    fn has_fixture(&self, frame: &str) -> bool {
        let places = self.tree.items.iter().filter_map(|item| match &item.kind {
            crate::parse::tree::ItemKind::Fixture { place, .. } => Some(place),
            _ => None,
        });
        let mut names = Vec::new();
        places.for_each(|place| read::names(place, &mut names));
        names.contains(&frame)
    }

    /// `FRAME.momentum`
    pub(in crate::check) fn balance_of_frame(
        &mut self,
        frame: FrameId,
        expr: &'a Expr,
        field: &'a Name,
        arguments: Option<&'a [Argument]>,
        scope: Scope,
    ) -> Option<Thing<'a>> {
        let ExprKind::Member { base, .. } = &expr.kind else {
            return None;
        };
        let ExprKind::Name(name) = &base.kind else {
            self.errors.at(base.area, say::NOTHING_OBSERVED);
            return None;
        };
        let (of, plane) = self.owning_frame(frame, name)?;
        self.balance(of, plane, expr, field, arguments, scope)
    }

    fn balance(
        &mut self,
        of: Owner,
        plane: Option<usize>,
        expr: &'a Expr,
        field: &'a Name,
        arguments: Option<&'a [Argument]>,
        scope: Scope,
    ) -> Option<Thing<'a>> {
        let (_, what, dimension) = *BALANCES.iter().find(|(known, ..)| *known == field.text)?;
        if scope != Scope::Output {
            self.errors.at(field.span, say::only_in_outputs(&field.text));
            return None;
        }
        let what = match (what, arguments) {
            (_, None) => what,
            (BalanceQuantity::AngularMomentum(_), Some(arguments)) => {
                BalanceQuantity::AngularMomentum(self.about(expr, arguments, scope)?)
            }
            (_, Some(_)) => {
                self.errors.at(expr.area, say::no_arguments(&field.text));
                return None;
            }
        };
        if what == BalanceQuantity::StrainEnergy && matches!(of, Owner::Frame(_)) {
            self.errors.at(field.span, say::RIGID_STRAIN);
            return None;
        }
        let placed = self
            .model
            .loads
            .iter()
            .find(|load| matches!(load.kind, LoadKind::Around(_)));
        if what == BalanceQuantity::GravityEnergy
            && let Some(load) = placed
        {
            let message = say::energy_of_placed_gravity(&load.name);
            self.errors.at(field.span, message);
            return None;
        }
        let dimension = Dimension::of(dimension);
        let observe = |component| Value::Observed(Observable::Balance { of, what, component });
        let axes = match (what, plane) {
            (BalanceQuantity::AngularMomentum(_), Some(normal)) => vec![normal],
            (BalanceQuantity::AngularMomentum(_), None) => vec![0, 1, 2],
            (BalanceQuantity::Momentum | BalanceQuantity::CenterOfMass, plane) => plane
                .map_or(Space::Spatial, |normal| Space::Planar { normal })
                .axes()
                .to_vec(),
            _ => return Some(Thing::Value(Quantity::Scalar(Typed::new(observe(0), dimension)))),
        };
        let mut values = algebra::numbers([0.0; 3]);
        for &axis in &axes {
            values[axis] = observe(axis);
        }
        let vector = Vectorial {
            values,
            axes,
            dimension,
            nature: Nature::default(),
            frame: Some(INERTIAL),
        };
        Some(match what {
            // A place is seen from an origin, which `.in(..)` would have to change, too.
            BalanceQuantity::CenterOfMass => Thing::Value(Quantity::Vector(vector)),
            _ => Thing::Shown {
                vector,
                plane,
                shown: INERTIAL,
            },
        })
    }

    /// `(about = PLACE)`
    fn about(&mut self, expr: &Expr, arguments: &'a [Argument], scope: Scope) -> Option<About> {
        let usage = || say::usage("angular_momentum", "beam.angular_momentum(about = arm.center)");
        let [
            Argument {
                name: Some(name),
                value,
            },
        ] = arguments
        else {
            self.errors.at(expr.area, usage());
            return None;
        };
        if name.text != "about" {
            self.errors.at(name.span, usage());
            return None;
        }
        if let ExprKind::Member {
            base,
            field,
            arguments: None,
        } = &value.kind
            && field.text == "center_of_mass"
        {
            return self.balance_owner(base).map(|(of, _)| About::CenterOf(of));
        }
        match self.thing(value, scope)? {
            Thing::Frame(INERTIAL) => Some(About::Origin),
            Thing::Frame(frame) => {
                let spot = members::origin(frame);
                Some(About::Marker(self.point_marker(&spot)))
            }
            Thing::Place(spot, None) => Some(About::Marker(self.point_marker(&spot))),
            _ => {
                self.errors.at(value.area, usage());
                None
            }
        }
    }
}
