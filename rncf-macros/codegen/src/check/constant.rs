//! Constants, and quantities that are derived from params.

use super::expr::Scope;
use super::quantity::Typed;
use super::{Check, fold, say};
use crate::model::Expr as Value;
use crate::parse::tree::{Expr, Item, ItemKind, Keyword, Name};

impl<'a> Check<'a> {
    /// Value of a constant, computed at its first use.
    pub(super) fn constant(&mut self, item: &'a Item, used: &Name) -> Option<Typed> {
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

    /// Value of a derived quantity, an expression of params, resolved at its first use.
    pub(super) fn derived(&mut self, item: &'a Item, used: &Name, scope: Scope) -> Option<Typed> {
        let text = item.name.text.as_str();
        let ItemKind::Let(value) = &item.kind else {
            return None;
        };
        if !self.values.contains_key(text) {
            if !self.enter(text, used.span.into()) {
                return None;
            }
            // What has a meaning where it is used has none where it stands.
            let (locals, is_along) = (std::mem::take(&mut self.locals), std::mem::take(&mut self.is_along));
            let typed = self.expr(value, Scope::Parameter);
            (self.locals, self.is_along) = (locals, is_along);
            self.leave();
            self.values.insert(text, typed);
        }
        let typed = self.values.get(text).cloned().flatten()?;
        if scope == Scope::Constant && fold::constant(&typed.value).is_none() {
            self.errors.at(used.span, say::param_in_constant(text));
            return None;
        }
        Some(typed)
    }

    /// An expression of constants as a number.
    pub(super) fn folded(&mut self, expr: &'a Expr) -> Option<Typed> {
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

    /// Checks constants that nothing uses.
    pub(super) fn constants(&mut self) {
        for item in self.items(Keyword::Const) {
            self.constant(item, &item.name);
        }
        for item in self.items(Keyword::Let) {
            self.derived(item, &item.name, Scope::Parameter);
        }
    }
}
