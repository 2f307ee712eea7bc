//! Bodies: space, axis, mesh, and the properties that their element needs.

use std::collections::BTreeMap;

use super::expr::Scope;
use super::plane::{PLANES, is_zero, normal};
use super::quantity::{Vector, Wanted};
use super::{Check, fold, say};
use crate::elements::Element;
use crate::errors::Area;
use crate::model::{
    Body, BodyId, ElementId, Evaluation, Expr as Value, FrameId, INERTIAL, Line, Quadrature, SectionShape, Space,
};
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Fields, Item, ItemKind, Keyword, Name, Statement};
use crate::suggest;
use crate::vocabulary::{MATERIAL, Property, Range, SECTION};

/// What other items need to know of a body; `None`: reported.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    pub id: BodyId,
    pub space: Option<Space>,
    pub frame: Option<FrameId>,
    /// Length of the axis where it is constant, m.
    pub length: Option<f64>,
    /// Direction of the axis where it is straight and constant.
    pub tangent: Option<[f64; 3]>,
}

const FROM: Wanted = Wanted {
    what: "the start of the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const TO: Wanted = Wanted {
    what: "the end of the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const RADIUS: Wanted = Wanted {
    what: "the radius",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const DIRECTION: Wanted = Wanted {
    what: "a direction",
    dimension: [0; 6],
    unit: "1",
};

/// What a mesh statement says.
struct Mesh {
    count: Value,
    element: ElementId,
    options: Vec<usize>,
    material_name: String,
    section_name: String,
    properties: BTreeMap<&'static str, Value>,
    quadrature: Quadrature,
    evaluation: Evaluation,
}

impl<'a> Check<'a> {
    pub(super) fn bodies(&mut self) {
        self.property_blocks();
        for (at, item) in self.items(Keyword::Body).into_iter().enumerate() {
            self.body(BodyId(at), item);
        }
    }

    fn body(&mut self, id: BodyId, item: &'a Item) {
        let mut known = Known {
            id,
            space: None,
            frame: None,
            length: None,
            tangent: None,
        };
        let ItemKind::Body {
            frame,
            statements,
            complete,
        } = &item.kind
        else {
            self.bodies.insert(item.name.text.as_str(), known);
            return;
        };
        known.frame = frame.as_ref().map_or(Some(INERTIAL), |frame| self.frame(frame));
        known.space = self.space(item, statements, *complete);
        if let Some(frame_id) = known.frame
            && self.has_axes(frame_id, frame.as_ref())
            && let Some(normal) = known.space.and_then(normal)
        {
            let area = frame.as_ref().map_or(item.name.span, |frame| frame.span);
            self.keeps_plane(frame_id, normal, area);
        }
        let line = self.line(item, statements, *complete, &mut known);
        let mesh = self.mesh(item, statements, *complete, known.space);
        let fidelity = self.fidelity(statements);
        let mean_axes = self.mean_axes(statements, known.frame, known.space);
        let initial = self.initial(item, statements, known.space);
        if mean_axes {
            // In a prescribed frame that is a mistake of its own.
            self.note_held(id);
        }
        self.bodies.insert(item.name.text.as_str(), known);
        if let (Some(frame), Some(space), Some(line), Some(mesh), Some(fidelity), Some(initial)) =
            (known.frame, known.space, line, mesh, fidelity, initial)
        {
            self.model.bodies.push(Body {
                name: item.name.text.clone(),
                doc: item.doc.clone(),
                frame,
                space,
                line,
                count: mesh.count,
                element: mesh.element,
                options: mesh.options,
                material_name: mesh.material_name,
                section_name: mesh.section_name,
                properties: mesh.properties,
                quadrature: mesh.quadrature,
                evaluation: mesh.evaluation,
                fidelity,
                mean_axes,
                initial,
                strain_energy: None,
                shape: SectionShape::default(),
                section_y: None,
                twist: Value::Number(0.0),
            });
        }
    }

    /// The one statement of a kind; more and none are reported.
    fn single(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        complete: bool,
        word: &str,
        missing: &str,
        area_of: impl Fn(&Statement) -> Option<Area>,
    ) -> Option<&'a Statement> {
        let mut found = statements
            .iter()
            .filter_map(|statement| Some((statement, area_of(statement)?)));
        let Some((first, first_area)) = found.next() else {
            if complete {
                self.errors
                    .at(item.name.span, say::missing_statement(&item.name.text, missing));
            }
            return None;
        };
        for (_, area) in found {
            self.errors
                .at(area, say::duplicate_statement(word, &first_area.line().to_string()));
        }
        Some(first)
    }

    fn space(&mut self, item: &Item, statements: &'a [Statement], complete: bool) -> Option<Space> {
        let missing = "`planar xy;` (or `yz`, `zx`) or `spatial;`";
        let statement = self.single(
            item,
            statements,
            complete,
            "`planar` or `spatial`",
            missing,
            |statement| {
                if let Statement::Space { area, .. } = statement {
                    Some(*area)
                } else {
                    None
                }
            },
        )?;
        let Statement::Space { plane: Some(plane), .. } = statement else {
            return Some(Space::Spatial);
        };
        let normal = PLANES.iter().position(|name| *name == plane.text);
        if normal.is_none() {
            self.errors
                .at(plane.span, suggest::unknown("plane", &plane.text, ["xy", "yz", "zx"]));
        }
        normal.map(|normal| Space::Planar { normal })
    }

    fn line(&mut self, item: &Item, statements: &'a [Statement], complete: bool, known: &mut Known) -> Option<Line> {
        let missing = "its stress-free axis: `line from [..] m to [..] m;` or `arc ..;`";
        let statement = self.single(
            item,
            statements,
            complete,
            "`line` or `arc`",
            missing,
            |statement| match statement {
                Statement::Line { area, .. } | Statement::Arc { area, .. } => Some(*area),
                _ => None,
            },
        )?;
        match statement {
            Statement::Line { area, from, to } => self.straight(*area, from, to, known),
            Statement::Arc { .. } => self.arc(statement, known),
            _ => None,
        }
    }

    fn straight(&mut self, area: Area, from: &'a Expr, to: &'a Expr, known: &mut Known) -> Option<Line> {
        let from_vector = self.vector(from, Scope::Parameter, FROM);
        let to_vector = self.vector(to, Scope::Parameter, TO);
        let (from_vector, to_vector) = (from_vector?, to_vector?);
        for vector in [&from_vector, &to_vector] {
            self.in_space(vector, known.space, "the axis");
        }
        if let (Some(a), Some(b)) = (from_vector.constant(), to_vector.constant()) {
            let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
            let length = d[0].hypot(d[1]).hypot(d[2]);
            if !(length > 0.0 && length.is_finite()) {
                self.errors.at(area.to(to.area), say::ZERO_LENGTH);
                return None;
            }
            known.length = Some(length);
            known.tangent = Some(d.map(|x| x / length));
        }
        Some(Line::Straight {
            from: from_vector.values,
            to: to_vector.values,
        })
    }

    fn in_space(&mut self, vector: &Vector, space: Option<Space>, what: &str) {
        if let Some(space) = space {
            self.in_plane(vector, space, what, true);
        }
    }

    fn arc(&mut self, statement: &'a Statement, known: &mut Known) -> Option<Line> {
        let Statement::Arc {
            from,
            direction,
            radius,
            angle,
            ..
        } = statement
        else {
            return None;
        };
        let from = self.vector(from, Scope::Parameter, FROM);
        let direction_vector = self.vector(direction, Scope::Parameter, DIRECTION);
        let radius_value = self.quantity(radius, Scope::Parameter, RADIUS);
        let angle_value = self.angle(angle, Scope::Parameter, "the angle of an arc");
        let radius_constant = radius_value.as_ref().and_then(fold::constant);
        let angle_constant = angle_value.as_ref().and_then(fold::constant);
        if radius_constant.is_some_and(|radius| radius.is_nan() || radius <= 0.0) {
            self.errors.at(radius.area, say::positive("the radius"));
        }
        if angle_constant == Some(0.0) {
            self.errors.at(angle.area, say::ZERO_ANGLE);
        }
        let (from, direction_vector) = (from?, direction_vector?);
        let normal = known.space.and_then(normal).unwrap_or(2);
        let normal = std::array::from_fn(|axis| Value::Number(f64::from(u8::from(axis == normal))));
        if is_zero(&direction_vector.values) {
            self.errors.at(direction.area, say::ZERO_DIRECTION);
        }
        self.in_space(&from, known.space, "the axis");
        self.in_space(&direction_vector, known.space, "the direction");
        known.length = radius_constant
            .zip(angle_constant)
            .map(|(radius, angle)| (radius * angle).abs());
        Some(Line::Arc {
            from: from.values,
            direction: direction_vector.values,
            normal,
            radius: radius_value?,
            angle: angle_value?,
        })
    }

    fn mesh(&mut self, item: &Item, statements: &'a [Statement], complete: bool, space: Option<Space>) -> Option<Mesh> {
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
        let properties = self.properties(element, call, section, material);
        Some(Mesh {
            count: count?,
            element: ElementId(id),
            options: options?,
            material_name: material.text.clone(),
            section_name: section.text.clone(),
            properties: properties?,
            quadrature: quadrature?,
            evaluation: evaluation?,
        })
    }

    fn curved_in_space(&mut self, element: &Element, statements: &[Statement], space: Option<Space>) {
        if space != Some(Space::Spatial) {
            return;
        }
        for statement in statements {
            if let Statement::Arc { area, .. } = statement {
                self.errors
                    .at(*area, element.curved_in_space.unwrap_or(say::ARC_IN_SPACE));
            }
        }
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
            if word == "quadrature" {
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
                let known = element
                    .options
                    .iter()
                    .map(|option| option.name)
                    .chain(["quadrature", "evaluation"]);
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

    /// Checks all materials and sections, also those that nothing uses.
    fn property_blocks(&mut self) {
        for (keyword, vocabulary) in [(Keyword::Material, MATERIAL), (Keyword::Section, SECTION)] {
            for item in self.items(keyword) {
                if let ItemKind::Material(fields) | ItemKind::Section(fields) = &item.kind {
                    self.property_block(keyword, fields, vocabulary);
                }
            }
        }
    }

    fn property_block(&mut self, keyword: Keyword, fields: &'a Fields, vocabulary: &'static [Property]) {
        let mut seen: Vec<(&str, usize)> = Vec::new();
        for field in &fields.fields {
            let word = field.name.text.as_str();
            let Some(property) = vocabulary.iter().find(|property| property.name == word) else {
                let kind = format!("field of `{}`", keyword.word());
                let known = vocabulary.iter().map(|property| property.name);
                self.errors.at(field.name.span, suggest::unknown(&kind, word, known));
                continue;
            };
            if let Some((_, line)) = seen.iter().find(|(name, _)| *name == word) {
                self.errors.at(
                    field.name.span,
                    say::duplicate_statement(&format!("`{word}`"), &line.to_string()),
                );
            }
            seen.push((word, Area::from(field.name.span).line()));
            let wanted = Wanted {
                what: property.name,
                dimension: property.dimension,
                unit: property.unit,
            };
            let value = self.quantity(&field.value, Scope::Parameter, wanted);
            if let Some(constant) = value.as_ref().and_then(fold::constant) {
                self.range(property, constant, field.value.area);
            }
        }
    }

    fn range(&mut self, property: &Property, value: f64, area: Area) {
        let message = match property.range {
            Range::Positive if value > 0.0 => return,
            Range::NonNegative if value >= 0.0 => return,
            Range::Poisson if value > -1.0 && value < 0.5 => return,
            Range::Positive => say::positive(property.name),
            Range::NonNegative => say::not_negative(property.name),
            Range::Poisson => say::POISSON.into(),
        };
        self.errors.at(area, message);
    }

    /// What the material and section give, and defaults; what the element needs must be there.
    fn properties(
        &mut self,
        element: &Element,
        call: &Call,
        section: &'a Name,
        material: &'a Name,
    ) -> Option<BTreeMap<&'static str, Value>> {
        let section_item = self.item(section, Keyword::Section);
        let material_item = self.item(material, Keyword::Material);
        let (section_item, material_item) = (section_item?, material_item?);
        let mut properties = BTreeMap::new();
        let mut complete = true;
        for (item, name, vocabulary) in [(section_item, section, SECTION), (material_item, material, MATERIAL)] {
            let (ItemKind::Material(fields) | ItemKind::Section(fields)) = &item.kind else {
                complete = false;
                continue;
            };
            for property in vocabulary {
                let field = fields.fields.iter().find(|field| field.name.text == property.name);
                if let Some(field) = field {
                    // Reported with the block itself; here only its value counts.
                    match self.silent(&field.value) {
                        Some(value) => drop(properties.insert(property.name, value)),
                        None => complete = false,
                    }
                } else if let Some(default) = property.default {
                    properties.insert(property.name, Value::Number(default));
                } else if let Some(need) = need(element, property.name) {
                    complete = false;
                    // A misspelt field has been reported, and may be the missing one.
                    let is_known = |name: &str| vocabulary.iter().any(|property| property.name == name);
                    if fields.complete && fields.fields.iter().all(|field| is_known(&field.name.text)) {
                        let kind = item.keyword.word();
                        let message = say::missing_property(kind, &name.text, property.name, &call.name.text, &need);
                        self.errors.at(name.span, message);
                    }
                }
            }
        }
        complete.then_some(properties)
    }

    /// Value of an expression whose mistakes have been reported before.
    fn silent(&mut self, expr: &'a Expr) -> Option<Value> {
        let mut quiet = crate::errors::Errors::new();
        std::mem::swap(self.errors, &mut quiet);
        let value = self.expr(expr, Scope::Parameter).map(|typed| typed.value);
        std::mem::swap(self.errors, &mut quiet);
        let _ = quiet.finish();
        value
    }
}

/// The coefficient of an element that a property is a factor of: `rhoA = density * area`.
fn need(element: &Element, property: &str) -> Option<String> {
    let coefficient = element
        .coefficients
        .iter()
        .find(|coefficient| coefficient.factors.contains(&property))?;
    Some(format!("{} = {}", coefficient.name, coefficient.factors.join(" * ")))
}
