//! Outputs: expressions of what the simulated system does.

use super::expr::Scope;
use super::{Check, say};
use crate::model::{Expr as Value, Output};
use crate::parse::tree::{Expr, ExprKind, ItemKind, Keyword};

impl<'a> Check<'a> {
    pub(super) fn outputs(&mut self) {
        let items = self.items(Keyword::Output);
        if items.is_empty() && self.tree.complete {
            self.errors.at(self.tree.name.span, say::NO_OUTPUT);
        }
        for item in items {
            let ItemKind::Output(value) = &item.kind else {
                continue;
            };
            if let Some((unit, components)) = self.output(value) {
                let (name, doc) = (item.name.text.clone(), item.doc.clone());
                self.model.outputs.push(Output {
                    name,
                    doc,
                    unit,
                    components,
                });
            }
        }
    }

    fn output(&mut self, value: &'a Expr) -> Option<(String, Vec<(String, Value)>)> {
        // A vector stands alone; in an expression only components do.
        if let ExprKind::Member { .. } = &value.kind {
            let seen = self.observe(value)?;
            let suffix = |axis: &str| {
                if seen.is_scalar {
                    String::new()
                } else {
                    axis.to_string()
                }
            };
            let components = seen
                .components
                .iter()
                .map(|(axis, it)| (suffix(axis), Value::Observed(it.clone())));
            return Some((seen.dimension.symbol(false), components.collect()));
        }
        let typed = self.expr(value, Scope::Output)?;
        Some((
            typed.dimension.symbol(typed.nature.angle),
            vec![(String::new(), typed.value)],
        ))
    }
}
