//! Constants, and quantities that are derived from params.

use super::quantity::{Typed, Wanted, bare_literal};
use super::scope::Scope;
use crate::check::{Check, fold, say};
use crate::model::Expr as Value;
use crate::parse::tree::{Expr, Given, Item, ItemKind, Keyword, Name, ParameterKind};
use crate::units::Dimension;

/// What a component is told, in a sentence.
const TOLD: &str = "this";

impl<'a> Check<'a> {
    /// Value of a constant, computed at its first use.
    pub(in crate::check) fn constant(&mut self, item: &'a Item, used: &Name) -> Option<Typed> {
        let text = item.name.text.as_str();
        if let Some(known) = self.values.get(text) {
            return known.clone();
        }
        let ItemKind::Const(value) = &item.kind else {
            return None;
        };
        if !self.enter(text, used.span.into()) {
            return None;
        }
        let folded = self.folded(value);
        self.leave();
        self.values.insert(text, folded.clone());
        folded
    }

    /// Value of a derived quantity, an expression of params and of the place along an axis, resolved at its first use.
    pub(in crate::check) fn derived(&mut self, item: &'a Item, used: &Name, scope: Scope) -> Option<Typed> {
        let text = item.name.text.as_str();
        let ItemKind::Let(value) = &item.kind else {
            return None;
        };
        if !self.values.contains_key(text) {
            if !self.enter(text, used.span.into()) {
                return None;
            }
            // What has a meaning where it is used has none where it stands.
            let (locals, is_along) = (std::mem::take(&mut self.locals), self.is_along);
            let typed = self.with_lookups(|check| check.along_axis(|check| check.expr(value, Scope::Parameter)));
            (self.locals, self.is_along) = (locals, is_along);
            self.leave();
            self.values.insert(text, typed);
        }
        let typed = self.values.get(text).cloned().flatten()?;
        if fold::has_arclength(&typed.value) && !self.is_along {
            self.errors.at(used.span, say::along_elsewhere(text));
            return None;
        }
        if scope == Scope::Constant && fold::constant(&typed.value).is_none() {
            self.errors.at(used.span, say::param_in_constant(text));
            return None;
        }
        // What it is looked up for must be one that looks up tables.
        if looks_up(&typed.value) && !self.may_look_up() {
            self.errors.at(used.span, say::LOOKUP_ELSEWHERE);
            return None;
        }
        Some(typed)
    }

    /// An expression of constants as a number.
    pub(in crate::check) fn folded(&mut self, expr: &'a Expr) -> Option<Typed> {
        let typed = self.expr(expr, Scope::Constant)?;
        match fold::constant(&typed.value).filter(|value| value.is_finite()) {
            Some(value) => Some(Typed {
                value: Value::Number(value),
                ..typed
            }),
            None => {
                self.errors.at(expr.area, say::NOT_FINITE);
                None
            }
        }
    }

    /// Checks what parts were told: it is what their components take.
    pub(in crate::check) fn given(&mut self) {
        for given in &self.tree.given {
            if self.is_as_wanted(given).is_none() {
                // It is told once, and not where it is used.
                self.values.insert(given.name.as_str(), None);
            }
        }
    }

    fn is_as_wanted(&mut self, Given { kind, value, .. }: &'a Given) -> Option<()> {
        let dimension = match kind {
            ParameterKind::Angle => return self.angle(value, Scope::Parameter, TOLD).map(|_| ()),
            ParameterKind::Number => [0; 6],
            ParameterKind::Quantity(unit) => {
                let compound = self.unit(unit)?;
                if let Some(text) = bare_literal(value).filter(|_| !Dimension::of(compound.dimension).is_none()) {
                    let kind = Dimension::of(compound.dimension).describe(compound.dimension[5] != 0);
                    let message = say::no_unit(TOLD, &kind, &text, &unit.text);
                    self.errors.at(value.area, message);
                    return None;
                }
                let typed = self.expr(value, Scope::Parameter)?;
                if let Some(message) = typed.nature.misread_in(unit, compound) {
                    self.errors.at(value.area, message);
                    return None;
                }
                compound.dimension
            }
            _ => return Some(()),
        };
        let (what, unit) = (TOLD, "1");
        let wanted = Wanted { what, dimension, unit };
        self.quantity(value, Scope::Parameter, wanted).map(|_| ())
    }

    /// Checks constants that nothing uses.
    pub(in crate::check) fn constants(&mut self) {
        for item in self.items(Keyword::Const) {
            self.constant(item, &item.name);
        }
    }

    /// Checks derived quantities that nothing uses; they may look up tables.
    pub(in crate::check) fn quantities(&mut self) {
        for item in self.items(Keyword::Let) {
            self.with_lookups(|check| check.along_axis(|check| check.derived(item, &item.name, Scope::Parameter)));
        }
    }
}

/// Whether a value hangs on what a table has somewhere.
fn looks_up(value: &Value) -> bool {
    matches!(value, Value::Lookup { .. }) || value.parts().into_iter().any(looks_up)
}
