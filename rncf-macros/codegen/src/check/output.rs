//! Outputs: expressions of what the simulated system does.

use super::expr::Scope;
use super::plane::AXES;
use super::vector::Quantity;
use super::{Check, say};
use crate::model::{Expr as Value, Output};
use crate::parse::tree::{Expr, ItemKind, Keyword};

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
        let typed = match self.value(value, Scope::Output)? {
            Quantity::Scalar(typed) => typed,
            Quantity::Vector(vector) => {
                let component = |axis: &usize| (AXES[*axis].to_string(), vector.values[*axis].clone());
                let unit = vector.dimension.symbol(vector.nature.angle);
                return Some((unit, vector.axes.iter().map(component).collect()));
            }
        };
        Some((
            typed.dimension.symbol(typed.nature.angle),
            vec![(String::new(), typed.value)],
        ))
    }
}
