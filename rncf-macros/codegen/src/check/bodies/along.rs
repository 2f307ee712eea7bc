//! What varies along an axis and is known when the model is built: tables cover the axis, and values are in their ranges.
//! With params the program checks the same when it builds the scene.

use std::collections::HashSet;

use super::body;
use super::curve::Curve;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::model::{Body, Expr as Value, Line, Model, SectionShape, Space, Stations, Table};
use crate::parse::tree::{Fields, Item, ItemKind, Keyword, Name, Statement};
use crate::suggest;
use crate::symbolic::path_of;
use crate::vocabulary::{BOTH_AXES, LAW, MATERIAL, Range, SECTION};

/// Relative size of what counts as round-off of places along an axis: that of the runtime's tables.
const ROUND_OFF: f64 = 1e-9;

/// The same of a curve whose length is measured: the program's own measure decides what is closer.
const MEASURED: f64 = 1e-6;

/// Relative size of what counts as round-off of declared properties of a section: that of the runtime's check.
const DECLARED: f64 = 1e-6;

/// Angle of a twist, rad, beyond what it turns by within the round-off of places.
const AT_ONCE: f64 = 1e-6;

/// Parts of an axis between which values are looked at, beside the rows of tables.
const PARTS: usize = 64;

/// Places along the axis of a body, where they are known.
struct Axis {
    /// Arclength of the whole axis at the body's start, m.
    from: f64,
    /// That of its end.
    to: f64,
    /// Length of the whole axis, m.
    whole: f64,
    /// Relative size of its round-off.
    round_off: f64,
}

impl Axis {
    fn of(model: &Model, body: &Body) -> Option<Self> {
        let own = length(model, &body.line)?;
        let (from, whole) = match &body.piece {
            Some(piece) => (fold::constant(&piece.from)?, fold::constant(&piece.whole)?),
            None => (0.0, own),
        };
        Some(Self {
            from,
            to: from + own,
            whole,
            round_off: match &body.line {
                Line::Curve { .. } | Line::Path { .. } => MEASURED,
                _ => ROUND_OFF,
            },
        })
    }

    /// Places between its ends: close to both, evenly, and on both sides of the rows of tables.
    fn places(&self, tables: &[&Table]) -> Vec<Place> {
        let length = self.to - self.from;
        let even = (0..=PARTS).map(|part| (part as f64 / PARTS as f64).clamp(1e-6, 1.0 - 1e-6));
        let mut places: Vec<Place> = Vec::new();
        for table in tables {
            let within = table
                .rows(self.whole)
                .filter(|(x, _)| (self.from..=self.to).contains(x));
            places.extend(within.map(|(x, row)| Place {
                x,
                row: Some((table.name.clone(), row)),
            }));
        }
        places.extend(even.map(|part| Place {
            x: self.from + part * length,
            row: None,
        }));
        places
    }
}

/// An arclength, and the row of a table that stands there.
struct Place {
    x: f64,
    row: Option<(String, usize)>,
}

impl Place {
    fn describe(&self, body: &str) -> String {
        match &self.row {
            Some((table, row)) => format!("row {row} of table `{table}`"),
            None => format!("{:.4} m along the axis of body `{body}`", self.x),
        }
    }
}

/// Length of an axis that does not depend on params, m.
fn length(model: &Model, line: &Line) -> Option<f64> {
    let length = match line {
        Line::Straight { from, to } => {
            let mut sum = 0.0;
            for (a, b) in from.iter().zip(to) {
                sum += (fold::constant(b)? - fold::constant(a)?).powi(2);
            }
            sum.sqrt()
        }
        Line::Arc { radius, angle, .. } => (fold::constant(radius)? * fold::constant(angle)?).abs(),
        // A run may name other points.
        Line::Curve {
            table,
            columns,
            directions,
        } => {
            let table = Some(&model.tables[table.0]).filter(|table| !table.is_param)?;
            Curve::through(&table.points(*columns), *directions).length()
        }
        Line::Path { position, range } => {
            let [from, to] = range.each_ref().map(fold::constant);
            let range = [from?, to?];
            let is_fixed = |value: &Value| fold::fixed_along(model, value, range[0], 1.0).is_some();
            if !position.iter().all(is_fixed) {
                return None;
            }
            Curve::along(range, path_of(model, position, 0.0)).length()
        }
        Line::Imported(_) => return None,
    };
    (length > 0.0 && length.is_finite()).then_some(length)
}

/// The tables that values are made of.
pub(in crate::check) fn tables_of<'m>(model: &'m Model, values: impl IntoIterator<Item = &'m Value>) -> Vec<&'m Table> {
    let mut tables: Vec<usize> = values.into_iter().flat_map(fold::tables).map(|table| table.0).collect();
    tables.sort_unstable();
    tables.dedup();
    tables.into_iter().map(|table| &model.tables[table]).collect()
}

impl<'a> Check<'a> {
    /// Checks all bodies whose properties vary.
    pub(in crate::check) fn constants_along(&mut self) {
        let mut told = HashSet::new();
        let mut mistakes = Vec::new();
        for item in self.items(Keyword::Body) {
            let Some(body) = self.model.bodies.iter().find(|body| body.name == item.name.text) else {
                continue;
            };
            let Some(axis) = Axis::of(&self.model, body) else {
                continue;
            };
            mistakes.extend(self.uncovered(item, body, &axis));
            mistakes.extend(self.twist_in_steps(item, body, &axis));
            mistakes.extend(self.out_of_range(body, &axis));
        }
        for (area, message) in mistakes {
            // Bodies that share a section, and the pieces of one axis.
            if told.insert(message.clone()) {
                self.errors.at(area, message);
            }
        }
    }

    /// Tables whose rows end before the axis does.
    fn uncovered(&self, item: &'a Item, body: &Body, axis: &Axis) -> Vec<(Area, String)> {
        let fields = body.law.iter().flat_map(|law| &law.fields);
        let fields = body.properties.iter().chain(fields);
        let mut read: Vec<(&Table, Area)> = Vec::new();
        for (name, value) in fields {
            let area = self.area_of_property(body, name);
            read.extend(tables_of(&self.model, [value]).into_iter().map(|table| (table, area)));
        }
        if let ItemKind::Body { statements, .. } = &item.kind {
            for statement in statements {
                match (statement, &body.stations) {
                    (Statement::Twist { value, .. }, _) => {
                        let tables = tables_of(&self.model, [&body.twist]).into_iter();
                        read.extend(tables.map(|table| (table, value.area)));
                    }
                    (
                        Statement::Mesh {
                            stations: Some(name), ..
                        },
                        Some(Stations::Rows { table, .. }),
                    ) => read.push((&self.model.tables[table.0], name.span.into())),
                    _ => {}
                }
            }
        }
        let uncovered = |(table, area)| Some((area, uncovered(table, item, axis)?));
        read.into_iter().filter_map(uncovered).collect()
    }

    /// A twist that jumps at a step of its table: both elements there have one section.
    fn twist_in_steps(&self, item: &'a Item, body: &Body, axis: &Axis) -> Option<(Area, String)> {
        let ItemKind::Body { statements, .. } = &item.kind else {
            return None;
        };
        let area = statements.iter().find_map(|statement| match statement {
            Statement::Twist { value, .. } => Some(value.area),
            _ => None,
        })?;
        let turned = |x: f64| fold::fixed_along(&self.model, &body.twist, x, axis.whole);
        tables_of(&self.model, [&body.twist]).into_iter().find_map(|table| {
            let steps = table.places.windows(2).filter(|pair| pair[0] == pair[1]);
            let scale = if table.is_relative { axis.whole } else { 1.0 };
            let places = steps.map(|pair| pair[0] * scale);
            let mut inside = places.filter(|x| (axis.from..=axis.to).contains(x));
            inside.find_map(|x| {
                let step = turned(x * (1.0 + ROUND_OFF))? - turned(x * (1.0 - ROUND_OFF))?;
                let is_step = step.abs() > AT_ONCE;
                is_step.then(|| (area, say::twist_in_steps(&table.name, x, step)))
            })
        })
    }

    /// The first value out of range of each property that varies.
    fn out_of_range(&self, body: &Body, axis: &Axis) -> Vec<(Area, String)> {
        let fields = body.law.iter().flat_map(|law| &law.fields);
        let varying = body.properties.iter().chain(fields);
        let mut found = Vec::new();
        for (name, value) in varying.filter(|(_, value)| fold::has_arclength(value)) {
            let mut known = SECTION.iter().chain(MATERIAL).chain(LAW.iter());
            let Some(property) = known.find(|property| property.name == *name) else {
                continue;
            };
            let wrong = axis
                .places(&tables_of(&self.model, [value]))
                .into_iter()
                .find_map(|place| {
                    let found = fold::fixed_along(&self.model, value, place.x, axis.whole)?;
                    // A tip may come to a point.
                    let is_tip = found == 0.0 && (place.x == 0.0 || place.x == axis.whole);
                    let is_wrong = !(property.range.has(found) || is_tip) || !found.is_finite();
                    is_wrong.then_some((place, found))
                });
            if let Some((place, value)) = wrong {
                let where_ = place.describe(&body.name);
                let message = if *name == "inner_radius" {
                    say::thickness_along(&where_)
                } else {
                    say::value_along(&where_, name, value, property.unit, words(property.range))
                };
                found.push((self.area_of_property(body, name), message));
            }
        }
        if found.is_empty() {
            found.extend(self.impossible(body, axis));
        }
        found
    }

    /// Properties that no section has together.
    fn impossible(&self, body: &Body, axis: &Axis) -> Option<(Area, String)> {
        let SectionShape::General { extent } = &body.shape else {
            return None;
        };
        let of = |name: &str| body.properties.get(name);
        // Of a centre line in space both moments are equal; that of a planar body is about the normal of its plane.
        let both = of("second_moment").filter(|_| body.space == Space::Spatial);
        let y = of("second_moment_y").or(both);
        let z = of("second_moment_z").or_else(|| of("second_moment"));
        let (area, torsion) = (of("area"), of("torsion_constant"));
        let all = [area, y, z, torsion, extent[0].as_ref(), extent[1].as_ref()];
        if !all.iter().flatten().any(|value| fold::has_arclength(value)) {
            return None;
        }
        let tables = tables_of(&self.model, all.into_iter().flatten());
        axis.places(&tables).into_iter().find_map(|place| {
            let at = |value: Option<&Value>| fold::fixed_along(&self.model, value?, place.x, axis.whole);
            let [area, y, z, torsion, extent_y, extent_z] = all.map(at);
            let bounds = [
                (
                    "torsion_constant",
                    torsion,
                    y.zip(z).map(|(y, z)| y + z),
                    "the sum of the second moments",
                ),
                (
                    "second_moment_z",
                    z,
                    area.zip(extent_y).map(|(a, e)| a * e * e),
                    "area * extent_y^2",
                ),
                (
                    "second_moment_y",
                    y,
                    area.zip(extent_z).map(|(a, e)| a * e * e),
                    "area * extent_z^2",
                ),
            ];
            let wrong = bounds.into_iter().find_map(|(name, value, most, what)| {
                let (value, most) = (value?, most?);
                (value > most * (1.0 + DECLARED)).then_some((name, value, most, what))
            });
            let (name, value, most, what) = wrong?;
            let message = say::section_along(&place.describe(&body.name), name, value, what, most);
            Some((self.area_of_property(body, name), message))
        })
    }

    /// Where the section or material of a body says a property; else where the section has its name.
    fn area_of_property(&self, body: &Body, name: &str) -> Area {
        let items = [&body.section_name, &body.material_name].map(|item| self.names.get(item.as_str()).copied());
        let found = items.into_iter().flatten().find_map(|item| area_in(item, name));
        let whole = items[0].map(|item| match &item.kind {
            ItemKind::NamedSection(call) => call.area,
            _ => item.name.span.into(),
        });
        found.or(whole).unwrap_or_else(|| self.tree.name.span.into())
    }
}

/// A table that does not cover the axis of a body.
fn uncovered(table: &Table, item: &Item, axis: &Axis) -> Option<String> {
    let (end, unit) = if table.is_relative {
        (1.0, "of the length")
    } else {
        (axis.whole, "m")
    };
    let (first, last) = (table.places[0], table.places[table.places.len() - 1]);
    if table.is_relative && last > end * (1.0 + axis.round_off) {
        return Some(say::beyond_the_length(&table.name, last));
    }
    if first <= axis.round_off * end && last >= end * (1.0 - axis.round_off) {
        return None;
    }
    // A measured length in the digits that say something.
    let end = if axis.round_off == MEASURED {
        suggest::written(end).parse().unwrap_or(end)
    } else {
        end
    };
    let body = body::piece(item).map_or(item.name.text.as_str(), |(whole, _)| whole);
    Some(say::not_covered(&table.name, [first, last], body, end, unit))
}

/// Where an item has a field or argument with the name of a property.
pub(in crate::check) fn area_in(item: &Item, name: &str) -> Option<Area> {
    let both = BOTH_AXES
        .iter()
        .find(|(_, axes)| axes.contains(&name))
        .map(|(word, _)| *word);
    let axes = BOTH_AXES.iter().find(|(both, _)| *both == name).map(|(_, axes)| axes);
    let argument = match name {
        "size_y" => "y",
        "size_z" => "z",
        "inner_radius" => "thickness",
        other => other,
    };
    let of_fields = |fields: &Fields| -> Option<Area> {
        let is_it = |word: &str| word == name || Some(word) == both || axes.is_some_and(|axes| axes.contains(&word));
        let field = fields.fields.iter().find(|field| is_it(&field.name.text))?;
        Some(field.value.area)
    };
    match &item.kind {
        ItemKind::Section(fields) | ItemKind::Material(fields) => of_fields(fields),
        ItemKind::NamedSection(call) => {
            let is_it = |name: &Name| name.text == argument;
            let found = call.arguments.iter().find(|one| one.name.as_ref().is_some_and(is_it));
            found.map(|found| found.value.area)
        }
        _ => None,
    }
}

fn words(range: Range) -> &'static str {
    match range {
        Range::Positive => "greater than zero",
        Range::NonNegative => "zero or greater",
        Range::Part => "greater than zero and at most 1",
        Range::Poisson => "between -1 and 0.5",
        Range::Any => "finite",
    }
}
