//! Outputs: expressions of what the simulated system does.

use crate::check::values::scope::Scope;
use crate::check::values::vector::Quantity;
use crate::check::values::words::AXES;
use crate::check::{Check, say};
use crate::model::{Binary, Expr as Value, Output};
use crate::parse::tree::{Expr, ItemKind, Keyword, UnitText};
use crate::units::Dimension;

/// Values in a unit, with the suffixes of their components.
struct Told {
    unit: String,
    dimension: Dimension,
    components: Vec<(String, Value)>,
}

impl<'a> Check<'a> {
    pub(in crate::check) fn outputs(&mut self) {
        let items = self.items(Keyword::Output);
        if items.is_empty() && self.tree.complete {
            self.errors.at(self.tree.name.span, say::NO_OUTPUT);
        }
        for item in items {
            let ItemKind::Output { unit: told, value } = &item.kind else {
                continue;
            };
            let told = told.as_ref();
            if let Some(told) = self.output(value, told) {
                self.model.outputs.push(Output {
                    name: item.name.text.clone(),
                    doc: item.doc.clone(),
                    unit: told.unit,
                    time_exponent: told.dimension.time(),
                    components: told.components,
                });
            }
        }
    }

    fn output(&mut self, value: &'a Expr, told: Option<&'a UnitText>) -> Option<Told> {
        let quantity = self.with_lookups(|check| check.value(value, Scope::Output))?;
        let (dimension, nature, mut components) = match quantity {
            Quantity::Scalar(typed) => (typed.dimension, typed.nature, vec![(String::new(), typed.value)]),
            Quantity::Vector(vector) => {
                let component = |axis: &usize| (AXES[*axis].to_string(), vector.values[*axis].clone());
                let components = vector.axes.iter().map(component).collect();
                (vector.dimension, vector.nature, components)
            }
        };
        let Some(told) = told else {
            return Some(Told {
                unit: dimension.symbol(nature.angle),
                dimension,
                components,
            });
        };
        let unit = self.unit(told)?;
        if Dimension::of(unit.dimension) != dimension {
            let (own, other) = (
                dimension.describe(nature.angle),
                Dimension::of(unit.dimension).describe(false),
            );
            self.errors.at(told.area, say::output_unit(&own, &other));
            return None;
        }
        if let Some(message) = nature.misread_in(told, unit) {
            self.errors.at(told.area, message);
            return None;
        }
        let si = Box::new(Value::Number(unit.si()));
        for (_, value) in &mut components {
            *value = Value::Binary(Binary::Divide, Box::new(value.clone()), si.clone());
        }
        Some(Told {
            unit: told.text.clone(),
            dimension,
            components,
        })
    }
}
