//! Meshes: number and kind of the elements, their options, and what they are made of.

use std::sync::Arc;

use crate::check::sections::material::{Stuff, Used};
use crate::check::{Check, say};
use crate::elements::{BETWEEN_INTERFACES, Element};
use crate::joints::algebra::multiply;
use crate::model::{ElementId, Evaluation, Expr as Value, Law, Quadrature, Space, Stations, TableId};
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Item, Keyword, Name, Statement};
use crate::suggest;

/// What a mesh statement says.
pub struct Mesh {
    pub count: Value,
    pub element: ElementId,
    pub options: Vec<usize>,
    pub material_name: String,
    pub section_name: String,
    pub stuff: Stuff,
    pub law: Option<Law>,
    pub stations: Option<Stations>,
    pub quadrature: Quadrature,
    pub evaluation: Evaluation,
}

impl<'a> Check<'a> {
    pub(in crate::check) fn mesh(
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
            count,
            stations,
            element: call,
            ..
        } = statement
        else {
            return None;
        };
        let count = self.count(count);
        let stations = match stations {
            Some(name) => Some(self.table(name)?),
            None => None,
        };
        let word = call.name.text.as_str();
        let Some(id) = self.library.find(word) else {
            if self.is_declared_element(word) || !self.is_news(word) {
                return None;
            }
            let known = self
                .library
                .elements
                .iter()
                .filter(|element| !element.of_stiffness)
                .flat_map(|element| element.names.iter().copied())
                .filter(|name| *name != BETWEEN_INTERFACES && !name.contains('.'));
            self.errors.at(call.name.span, suggest::unknown("element", word, known));
            return None;
        };
        if let Some(section) = self.lawful_section(call) {
            let mesh = self.mesh_of_law((call, id), section, statements, space?)?;
            return Some(self.at_stations(mesh, count?, stations));
        }
        let library = Arc::clone(&self.library);
        let element = &library.elements[id];
        if element.is_planar() && space == Some(Space::Spatial) {
            self.errors.at(call.name.span, say::element_of_plane(word));
            return None;
        }
        let (options, quadrature, evaluation) = self.options(element, space, call);
        let (section, material) = self.property_arguments(call)?;
        let defaults = vec![0; element.options.len()];
        self.curved(element, options.as_ref().unwrap_or(&defaults), statements, space);
        let used = Used {
            element,
            word,
            space: space?,
            options: options.as_ref().unwrap_or(&defaults),
        };
        let stuff = self.stuff(used, call, section, material);
        let mesh = Mesh {
            count: Value::Number(1.0),
            stations: None,
            law: None,
            element: ElementId(id),
            options: options?,
            material_name: material.text.clone(),
            section_name: section.text.clone(),
            stuff: stuff?,
            quadrature: quadrature?,
            evaluation: evaluation?,
        };
        Some(self.at_stations(mesh, count?, stations))
    }

    /// A mesh with its number of elements, and its nodes at the rows of a table.
    fn at_stations(&self, mesh: Mesh, count: Value, stations: Option<TableId>) -> Mesh {
        let Some(table) = stations else {
            return Mesh { count, ..mesh };
        };
        let spans = self.model.tables[table.0].stations() - 1;
        Mesh {
            count: multiply(Value::Number(spans as f64), count.clone()),
            stations: Some(Stations::Rows { table, each: count }),
            ..mesh
        }
    }

    /// The section or material that is named: `tube`, and of one that stands in a loop over a param that of the same repetition,
    /// `tube[i]`.
    pub(super) fn own(&mut self, expr: &'a Expr, keyword: Keyword) -> Option<&'a Name> {
        let name = named(expr)?;
        let item = self
            .names
            .get(name.text.as_str())
            .filter(|item| item.keyword == keyword);
        let repeat = item.and_then(|item| item.repeat);
        let number = match &expr.kind {
            ExprKind::Indexed { index, .. } => Some(index.as_ref()),
            _ => None,
        };
        match (repeat, number) {
            (None, None) => Some(name),
            (None, Some(_)) if item.is_none() => Some(name),
            (None, Some(number)) => {
                self.errors.at(number.area, say::not_repeated(&name.text));
                None
            }
            (Some(repeat), number) => match self.own_repetition(&name.text, repeat, number) {
                Ok(()) => Some(name),
                Err(message) => {
                    self.errors.at(expr.area, message);
                    None
                }
            },
        }
    }

    /// Options of the element, integration rule, form of the kernels.
    #[allow(clippy::type_complexity)]
    pub(super) fn options(
        &mut self,
        element: &Element,
        space: Option<Space>,
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
                quadrature = self.quadrature(element, space, value);
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
                match (self.choice(value, word, &element.options[at].values), &mut options) {
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

    fn quadrature(&mut self, element: &Element, space: Option<Space>, value: &Expr) -> Option<Quadrature> {
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
                let least = element.least_points(
                    space.map_or(2, |space| space.dimension()),
                    &vec![0; element.options.len()],
                );
                if points < least {
                    let message = say::too_few_points(&points.to_string(), &least.to_string());
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
        if let Some(wrong) = [*section, *material].into_iter().find(|expr| named(expr).is_none()) {
            self.errors.at(
                wrong.area,
                say::usage(element, &format!("{element}(section, material)")),
            );
            return None;
        }
        let (section_name, material_name) = (
            self.own(section, Keyword::Section),
            self.own(material, Keyword::Material),
        );
        let (section_name, material_name) = (section_name?, material_name?);
        Some((section_name, material_name))
    }
}

/// The name that an expression is, or what is before the number of a repetition.
pub(super) fn named(expr: &Expr) -> Option<&Name> {
    match &expr.kind {
        ExprKind::Name(name) | ExprKind::Indexed { base: name, .. } => Some(name),
        _ => None,
    }
}
