//! Parts: components with what they are told.

use super::messages as say;
use super::{Place, Scope, Step, Told, Unfold};
use crate::errors::Area;
use crate::parse::tree::{Argument, Call, Keyword, Parameter, ParameterKind, Tree};
use crate::suggest;

impl<'t> Unfold<'t, '_> {
    /// Places a component under a name.
    pub(super) fn place(&mut self, name: &str, call: &'t Call, at: &Place) -> Option<()> {
        if self.parts.contains_key(name) {
            // The name is there already, which is told.
            return Some(());
        }
        let component = self.component(call)?;
        let text = component.name.text.as_str();
        if let Some(first) = self.placing.iter().position(|other| *other == text) {
            let chain: Vec<&str> = self.placing[first..].iter().copied().chain([text]).collect();
            self.errors
                .at(call.name.span, say::recursion(text, &chain.join(" -> ")));
            return None;
        }
        let mut scope = Scope::new(component, format!("{name}."));
        let id = self.scopes.len();
        let is_told = self.tell(&mut scope, id, component, call, at);
        self.scopes.push(scope);
        is_told?;
        self.parts.insert(name.to_string(), id);
        self.is_copied = true;
        for parameter in component.parameters.iter().filter(|parameter| is_quantity(parameter)) {
            self.existing.insert(format!("{name}.{}", parameter.name.text));
            self.steps.push(Step::Told { scope: id, parameter });
        }
        self.declare(id);
        self.placing.push(text);
        self.walk(id, None, 0..component.items.len(), &[], None);
        self.placing.pop();
        Some(())
    }

    fn component(&mut self, call: &Call) -> Option<&'t Tree> {
        let text = call.name.text.as_str();
        let root = self.root;
        let found = root.components.iter().find(|component| component.name.text == text);
        if found.is_none() && !root.lost.iter().any(|lost| lost == text) {
            let message = match self.scopes[0].names.get(text) {
                Some(declared) => say::not_a_component(text, &say::a(declared.item.keyword.noun())),
                None => {
                    let known = root.components.iter().map(|component| component.name.text.as_str());
                    suggest::unknown("component", text, known)
                }
            };
            self.errors.at(call.name.span, message);
        }
        found
    }

    /// Sorts what is told to the names of what the component takes.
    fn tell(
        &mut self,
        scope: &mut Scope<'t>,
        id: usize,
        component: &'t Tree,
        call: &'t Call,
        at: &Place,
    ) -> Option<()> {
        let before = self.errors.len();
        for Argument { name, value } in &call.arguments {
            let Some(name) = name else {
                self.errors.at(value.area, say::NAMED_ARGUMENTS);
                continue;
            };
            let parameter = component
                .parameters
                .iter()
                .find(|parameter| parameter.name.text == name.text);
            if parameter.is_none() && component.lost.contains(&name.text) {
                continue;
            }
            let Some(parameter) = parameter else {
                let kind = format!("argument of `{}`", component.name.text);
                let known = component
                    .parameters
                    .iter()
                    .map(|parameter| parameter.name.text.as_str());
                self.errors.at(name.span, suggest::unknown(&kind, &name.text, known));
                continue;
            };
            let at = at.clone();
            let told = Told { parameter, value, at };
            if scope.told.insert(&parameter.name.text, told).is_some() {
                self.errors.at(name.span, say::told_twice(&name.text));
            }
        }
        let mut missing = Vec::new();
        for parameter in &component.parameters {
            let text = parameter.name.text.as_str();
            if scope.told.contains_key(text) {
                continue;
            }
            let Some(value) = &parameter.default else {
                missing.push(format!("`{text}`"));
                continue;
            };
            // A default may refer to what else the component is told.
            let turns = Vec::new();
            let at = Place { scope: id, turns };
            scope.told.insert(text, Told { parameter, value, at });
        }
        if !missing.is_empty() && component.complete && self.errors.len() == before {
            let message = say::missing(&component.name.text, &missing.join(", "));
            self.errors.at(Area::from(call.name.span).to(call.area), message);
        }
        (missing.is_empty() && self.errors.len() == before).then_some(())
    }
}

/// Whether a value of its own is told, which gets a name; all else stands where its name does.
pub fn is_quantity(parameter: &Parameter) -> bool {
    matches!(
        parameter.kind,
        ParameterKind::Number | ParameterKind::Angle | ParameterKind::Quantity(_)
    )
}

/// The kind of item that is wanted, in a sentence.
pub fn noun(keywords: &[Keyword]) -> &'static str {
    keywords.first().map_or("item", |keyword| keyword.noun())
}
