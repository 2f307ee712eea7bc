//! What springs show: their forces and moments, and what these depend on.

use super::members::Thing;
use crate::check::values::scope::Scope;
use crate::check::values::vector::Quantity;
use crate::check::{Check, say};
use crate::parse::tree::Name;
use crate::suggest;

/// What can be observed of a spring, by names.
pub type Shown = Vec<(&'static str, Quantity)>;

impl<'a> Check<'a> {
    /// `spring.field`
    pub(in crate::check) fn of_spring(&mut self, name: &'a Name, field: &Name, scope: Scope) -> Option<Thing<'a>> {
        if self
            .names
            .get(name.text.as_str())
            .is_some_and(|item| Self::is_broken(item))
        {
            return None;
        }
        // Springs are read behind constraints and in their order, with laws that may ask for one of them.
        let Some(shown) = self.shown.get(&name.text).filter(|_| scope >= Scope::Force) else {
            if self.errors.is_empty() {
                self.errors.at(name.span, say::spring_not_known(&name.text));
            }
            return None;
        };
        let shown = shown.as_ref()?;
        match shown.iter().find(|(known, _)| *known == field.text) {
            Some((_, quantity)) => Some(Thing::Value(quantity.clone())),
            None => {
                let known = shown.iter().map(|(known, _)| *known);
                let message = suggest::unknown("quantity of a spring", &field.text, known);
                self.errors.at(field.span, message);
                None
            }
        }
    }
}
