//! Meshes: number and kind of the elements, their options, and what they are made of.

use super::material::{Stuff, Used};
use super::{Check, say};
use crate::elements::Element;
use crate::model::{ElementId, Evaluation, Expr as Value, Quadrature, Space};
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Item, Name, Statement};
use crate::suggest;

/// What a mesh statement says.
pub struct Mesh {
    pub count: Value,
    pub element: ElementId,
    pub options: Vec<usize>,
    pub material_name: String,
    pub section_name: String,
    pub stuff: Stuff,
    pub quadrature: Quadrature,
    pub evaluation: Evaluation,
}

impl<'a> Check<'a> {
    pub(super) fn mesh(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        complete: bool,
        space: Option<Space>,
    ) -> Option<Mesh> {
        let missing = "its elements: `mesh 6 * element(section, material);`";
        let statement = self.single(item, statements, complete, "`mesh`", missing, |statement| {
            if let Statement::Mesh { area, .. } = statement {
                Some(*area)
            } else {
                None
            }
        })?;
        let Statement::Mesh {
            count, element: call, ..
        } = statement
        else {
            return None;
        };
        let count = self.count(count);
        let word = call.name.text.as_str();
        let Some(id) = self.library.find(word) else {
            let known = self
                .library
                .elements
                .iter()
                .flat_map(|element| element.names.iter().copied());
            self.errors.at(call.name.span, suggest::unknown("element", word, known));
            return None;
        };
        let element = &self.library.elements[id];
        self.curved_in_space(element, statements, space);
        let (options, quadrature, evaluation) = self.options(element, call);
        let (section, material) = self.property_arguments(call)?;
        let defaults = vec![0; element.options.len()];
        let used = Used {
            element,
            word,
            space: space?,
            options: options.as_ref().unwrap_or(&defaults),
        };
        let stuff = self.stuff(used, call, section, material);
        Some(Mesh {
            count: count?,
            element: ElementId(id),
            options: options?,
            material_name: material.text.clone(),
            section_name: section.text.clone(),
            stuff: stuff?,
            quadrature: quadrature?,
            evaluation: evaluation?,
        })
    }

    /// Options of the element, integration rule, form of the kernels.
    #[allow(clippy::type_complexity)]
    fn options(
        &mut self,
        element: &Element,
        call: &'a Call,
    ) -> (Option<Vec<usize>>, Option<Quadrature>, Option<Evaluation>) {
        let mut options = Some(vec![0; element.options.len()]);
        let (mut quadrature, mut evaluation) = (Some(Quadrature::Exact), Some(Evaluation::Automatic));
        let mut seen: Vec<&str> = Vec::new();
        for Argument { name, value } in &call.arguments {
            let Some(name) = name else { continue };
            let word = name.text.as_str();
            if seen.contains(&word) {
                self.errors.at(name.span, say::twice(word));
            }
            seen.push(word);
            if element.own_rule && ["quadrature", "evaluation"].contains(&word) {
                self.errors.at(name.span, say::own_rule(&call.name.text, word));
                (quadrature, evaluation) = (None, None);
            } else if word == "quadrature" {
                quadrature = self.quadrature(element, value);
            } else if word == "evaluation" {
                let chosen = self.choice(value, word, &["automatic", "tensor", "points", "loop"]);
                let forms = [
                    Evaluation::Automatic,
                    Evaluation::Tensor,
                    Evaluation::Points,
                    Evaluation::Loop,
                ];
                evaluation = chosen.map(|at| forms[at]);
            } else if let Some(at) = element.options.iter().position(|option| option.name == word) {
                match (self.choice(value, word, element.options[at].values), &mut options) {
                    (Some(chosen), Some(options)) => options[at] = chosen,
                    _ => options = None,
                }
            } else {
                let of_code: &[&str] = if element.own_rule {
                    &[]
                } else {
                    &["quadrature", "evaluation"]
                };
                let own = element.options.iter().map(|option| option.name);
                let known = own.chain(of_code.iter().copied());
                let kind = format!("option of `{}`", call.name.text);
                self.errors.at(name.span, suggest::unknown(&kind, word, known));
            }
        }
        (options, quadrature, evaluation)
    }

    fn choice(&mut self, value: &Expr, option: &str, values: &[&str]) -> Option<usize> {
        let word = if let ExprKind::Name(name) = &value.kind {
            name.text.as_str()
        } else {
            ""
        };
        let chosen = values.iter().position(|value| *value == word);
        if chosen.is_none() {
            let message = if word.is_empty() {
                say::choices(option, &suggest::list(values))
            } else {
                suggest::unknown(&format!("value of `{option}`"), word, values.iter().copied())
            };
            self.errors.at(value.area, message);
        }
        chosen
    }

    fn quadrature(&mut self, element: &Element, value: &Expr) -> Option<Quadrature> {
        match &value.kind {
            ExprKind::Name(name) if name.text == "exact" => Some(Quadrature::Exact),
            ExprKind::Call(call) if call.name.text == "gauss" => {
                let points = match call.arguments.as_slice() {
                    [
                        Argument {
                            name: None,
                            value:
                                Expr {
                                    kind: ExprKind::Number { text, unit: None },
                                    ..
                                },
                        },
                    ] => text.parse::<usize>().ok(),
                    _ => None,
                };
                let Some(points) = points.filter(|points| (1..=20).contains(points)) else {
                    self.errors.at(call.area, say::GAUSS_POINTS);
                    return None;
                };
                if points < element.least_points {
                    let message = say::too_few_points(&points.to_string(), &element.least_points.to_string());
                    self.errors.at(call.area, message);
                    return None;
                }
                Some(Quadrature::Gauss(points))
            }
            _ => {
                self.errors
                    .at(value.area, say::choices("quadrature", "`exact` or `gauss(3)`"));
                None
            }
        }
    }

    /// `element(section, material)`: the two names.
    fn property_arguments(&mut self, call: &'a Call) -> Option<(&'a Name, &'a Name)> {
        let positional: Vec<&Expr> = call
            .arguments
            .iter()
            .filter(|argument| argument.name.is_none())
            .map(|argument| &argument.value)
            .collect();
        let element = call.name.text.as_str();
        let [section, material] = positional.as_slice() else {
            self.errors
                .at(call.area, say::usage(element, &format!("{element}(section, material)")));
            return None;
        };
        let name = |expr: &'a Expr| {
            if let ExprKind::Name(name) = &expr.kind {
                Some(name)
            } else {
                None
            }
        };
        let (Some(section_name), Some(material_name)) = (name(section), name(material)) else {
            let wrong = if name(section).is_none() { section } else { material };
            self.errors.at(
                wrong.area,
                say::usage(element, &format!("{element}(section, material)")),
            );
            return None;
        };
        Some((section_name, material_name))
    }
}
