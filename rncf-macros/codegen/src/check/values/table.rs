//! Tables of numbers along an axis: columns in the declaration, or a file beside the crate's manifest.

use std::collections::HashSet;

use proc_macro2::TokenStream;

use super::quantity::{Nature, Typed, hertz};
use super::scope::Scope;
use super::words::PARTICLE;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::import::rows::{Disorder, Head, Rows, chords, in_order, text};
use crate::import::spline;
use crate::model::{Between, Column, Expr as Value, Table, TableId};
use crate::parse::cursor::Cursor;
use crate::parse::tree::{Argument, Expr, ExprKind, Field, Fields, Item, ItemKind, Keyword, Name};
use crate::parse::unit;
use crate::suggest;
use crate::units::{self, Compound, Dimension};

/// Columns that are places along the axis: m, or parts of the length.
const PLACES: [(&str, [i8; 6]); 2] = [("x", [1, 0, 0, 0, 0, 0]), ("eta", [0; 6])];
/// What values follow between rows, by its word.
const BETWEEN: [(&str, Between); 5] = [
    ("linear", Between::Line),
    ("monotone", Between::Monotone),
    ("spline", Between::Spline),
    ("clamped", Between::Clamped),
    ("periodic", Between::Periodic),
];
/// Columns that are the coordinates of points, m.
const COORDINATES: [&str; 3] = ["x", "y", "z"];

/// Where paths of files in a declaration begin.
pub(in crate::check) const PATHS_BEGIN: &str = "at the folder of the crate's Cargo.toml";

impl<'a> Check<'a> {
    /// Checks all tables, also those that nothing reads.
    pub(in crate::check) fn tables(&mut self) {
        for item in self.items(Keyword::Table) {
            let id = match &item.kind {
                ItemKind::Table(fields) => self.table_of_columns(item, fields),
                ItemKind::FileTable {
                    path, area, arguments, ..
                } => self.table_of_file(item, path, *area, arguments),
                _ => None,
            };
            self.tables.insert(item.name.text.as_str(), id);
        }
    }

    fn table_of_columns(&mut self, item: &Item, fields: &'a Fields) -> Option<TableId> {
        let (mut columns, mut between, mut is_whole) = (Vec::new(), Some(Between::Line), fields.complete);
        let mut places = None;
        let words = fields.fields.iter().filter(|field| !is_column(field));
        if !self.once(words.map(|field| &field.name)) {
            return None;
        }
        for field in &fields.fields {
            if field.name.text == "interpolation" {
                between = self.interpolation(&field.value);
                continue;
            }
            if let Some(name) = places_named(field) {
                places = Some(name);
                continue;
            }
            match self.column_values(&field.value) {
                Some((values, dimension, hertz)) => columns.push(Column {
                    name: field.name.text.clone(),
                    header: None,
                    dimension,
                    hertz,
                    values,
                    slopes: Vec::new(),
                }),
                None => is_whole = false,
            }
        }
        let rows = columns.first().map_or(0, |column| column.values.len());
        for (column, field) in columns
            .iter()
            .zip(fields.fields.iter().filter(|field| is_column(field)))
        {
            if is_whole && column.values.len() != rows {
                let message = say::rows_differ(&column.name, column.values.len(), &columns[0].name, rows);
                self.errors.at(field.name.span, message);
                return None;
            }
        }
        if !is_whole {
            return None;
        }
        let places = places.map(|name| (name.text.as_str(), Area::from(name.span)));
        self.add_table(item, columns, (between?, places), None, &|row| {
            format!("value {}", row + 1)
        })
    }

    /// Whether no word is given twice.
    fn once(&mut self, mut words: impl Iterator<Item = &'a Name>) -> bool {
        let mut seen = HashSet::new();
        let twice = words.find(|word| !seen.insert(&word.text));
        if let Some(word) = twice {
            self.errors.at(word.span, say::twice(&word.text));
        }
        twice.is_none()
    }

    /// Values of a column in SI, their dimension, and the exponent of hertz.
    fn column_values(&mut self, list: &'a Expr) -> Option<(Vec<f64>, [i8; 6], i8)> {
        let ExprKind::Vector { components, unit } = &list.kind else {
            self.errors.at(list.area, say::COLUMN);
            return None;
        };
        let compound = unit.as_ref().map(|unit| self.unit(unit));
        let mut values = Vec::new();
        let mut dimension: Option<Dimension> = None;
        let mut cycles = unit.as_ref().map_or(0, hertz);
        for part in components {
            let typed = match compound {
                Some(compound) => self.with_unit(part, (compound?, 0), Scope::Constant),
                None => self.expr(part, Scope::Constant),
            }?;
            let first = *dimension.get_or_insert(typed.dimension);
            if typed.dimension != first {
                self.errors
                    .at(part.area, say::unlike(&typed.describe(), &first.describe(false)));
                return None;
            }
            let Some(value) = fold::constant(&typed.value).filter(|value| value.is_finite()) else {
                self.errors.at(part.area, say::NOT_FINITE);
                return None;
            };
            cycles = if cycles == 0 { typed.nature.hertz } else { cycles };
            values.push(value);
        }
        let dimension = match compound.flatten() {
            Some(compound) => Some(compound.dimension),
            None => dimension.map_or(Some([0; 6]), |dimension| dimension.exponents(false)),
        };
        let Some(dimension) = dimension else {
            self.errors.at(list.area, say::WHOLE_EXPONENTS);
            return None;
        };
        Some((values, dimension, cycles))
    }

    fn interpolation(&mut self, value: &Expr) -> Option<Between> {
        let word = match &value.kind {
            ExprKind::Name(name) => name.text.as_str(),
            _ => "",
        };
        let found = BETWEEN.iter().find(|(known, _)| *known == word);
        if found.is_none() {
            let message = say::choices(
                "interpolation",
                "`linear`, `monotone`, `spline`, `clamped` or `periodic`",
            );
            self.errors.at(value.area, message);
        }
        found.map(|&(_, between)| between)
    }

    fn table_of_file(&mut self, item: &Item, path: &str, area: Area, arguments: &'a [Argument]) -> Option<TableId> {
        let mut between = Some(Between::Line);
        let mut places = None;
        if !self.once(arguments.iter().filter_map(|argument| argument.name.as_ref())) {
            return None;
        }
        for argument in arguments {
            match (&argument.name, &argument.value.kind) {
                (Some(name), ExprKind::Name(column)) if name.text == "at" => places = Some(column.text.clone()),
                (Some(name), _) if name.text == "interpolation" => between = self.interpolation(&argument.value),
                (Some(name), _) => {
                    let message = suggest::unknown("argument of `file`", &name.text, ["at", "interpolation"]);
                    self.errors.at(name.span, message);
                    return None;
                }
                (None, _) => {
                    let usage = "file(\"blade.csv\", at = span, interpolation = monotone)";
                    self.errors.at(argument.value.area, say::usage("file", usage));
                    return None;
                }
            }
        }
        let text = match text(&self.tree.folder.join(path), PATHS_BEGIN) {
            Ok(text) => text,
            Err(error) => {
                self.errors.at(area, say::unreadable_file(path, &error));
                return None;
            }
        };
        let rows = match Rows::read(&text) {
            Ok(rows) => rows,
            Err(mistake) => {
                self.errors.at(area, say::wrong_file(path, &mistake.to_string()));
                return None;
            }
        };
        let mut columns = Vec::new();
        for (place, head) in rows.heads.iter().enumerate().filter(|(_, head)| !head.is_note()) {
            let values = match unit_of(head) {
                Some((unit, hertz)) => (rows.columns(&[place], |_, cell| number(cell, unit)))
                    .map(|mut values| (unit.dimension, hertz, values.remove(0)))
                    .map_err(|mistake| say::wrong_file(path, &mistake.to_string())),
                None => Err(say::unit_of_column(path, head.name, head.unit)),
            };
            match values {
                Ok((dimension, hertz, values)) => columns.push(Column {
                    name: head.name.to_string(),
                    header: None,
                    dimension,
                    hertz,
                    values,
                    slopes: Vec::new(),
                }),
                Err(message) => {
                    self.errors.at(area, message);
                    return None;
                }
            }
        }
        let row = |row: usize| format!("line {} of `{path}`", rows.line(row));
        let places = places.as_deref().map(|name| (name, area));
        self.add_table(item, columns, (between?, places), Some((path, area)), &row)
    }

    /// Finds the places, and checks their order.
    fn add_table(
        &mut self,
        item: &Item,
        mut columns: Vec<Column>,
        (between, named): (Between, Option<(&str, Area)>),
        file: Option<(&str, Area)>,
        row: &dyn Fn(usize) -> String,
    ) -> Option<TableId> {
        let area = file.map_or(item.name.span.into(), |(_, area)| area);
        let mut dimension = None;
        if let Some((name, area)) = named {
            let Some(column) = columns.iter().find(|column| column.name == name) else {
                let known: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
                self.errors.at(area, suggest::unknown("column", name, known));
                return None;
            };
            let is_along = PLACES.iter().find(|(_, own)| column.dimension == *own);
            let is_coordinate = |column: &Column| column.dimension == PLACES[0].1;
            let has = |word: &str| {
                columns
                    .iter()
                    .any(|column| column.name == word && is_coordinate(column))
            };
            if is_along.is_some() && COORDINATES.into_iter().all(has) {
                self.errors.at(area, say::places_of_points(&item.name.text, name));
                return None;
            }
            match is_along {
                // Under its own name, and as the places.
                Some(&(word, _)) => {
                    let column = Column {
                        name: word.to_string(),
                        header: Some(name.to_string()),
                        ..column.clone()
                    };
                    columns.retain(|column| column.name != word);
                    columns.push(column);
                }
                None => dimension = Some(column.dimension),
            }
        }
        let columns = columns;
        let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
        if let Some(twice) = (1..names.len()).find(|&at| names[..at].contains(&names[at])) {
            self.errors.at(area, say::column_twice(names[twice]));
            return None;
        }
        let find = |name: &str| columns.iter().find(|column| column.name == name);
        let named = named.map(|(name, _)| name);
        let coordinates = COORDINATES.map(|name| find(name).filter(|column| column.dimension == PLACES[0].1));
        let looked_up = dimension.and_then(|_| find(named?));
        let (places, is_relative, is_points) = if let Some(column) = looked_up {
            (column.values.clone(), false, false)
        } else if let [Some(x), Some(y), Some(z)] = coordinates {
            (chords([&x.values, &y.values, &z.values]), true, true)
        } else {
            let own = |(at, (name, dimension)): (usize, &(&str, [i8; 6]))| {
                Some((at, find(name).filter(|column| column.dimension == *dimension)?))
            };
            let found: Vec<_> = PLACES.iter().enumerate().filter_map(own).collect();
            if found.len() == PLACES.len() && named.is_none() {
                self.errors.at(area, say::two_places(&item.name.text));
                return None;
            }
            // What is named was put last, under the name of what it is.
            let found = named
                .and_then(|_| found.iter().find(|(_, column)| column.header.is_some()))
                .or(found.first());
            let Some(&(at, column)) = found else {
                self.errors.at(area, say::table_without_places(&item.name.text));
                return None;
            };
            (column.values.clone(), at == 1, false)
        };
        if let Err(disorder) = in_order(&places, is_points) {
            let message = match disorder {
                Disorder::TooFew => say::table_of_one_row(&item.name.text),
                Disorder::Order(at) if is_points => say::points_coincide(&row(at)),
                Disorder::Order(at) => say::rows_do_not_ascend(&row(at), places[at], places[at - 1]),
                Disorder::StepAtEnd => say::STEP_AT_END.to_string(),
            };
            self.errors.at(area, message);
            return None;
        }
        let is_spline = matches!(between, Between::Spline | Between::Clamped | Between::Periodic);
        if let Some(step) = (1..places.len()).find(|&at| is_spline && places[at] == places[at - 1]) {
            self.errors.at(area, say::step_in_spline(&row(step)));
            return None;
        }
        let by = |name: &str| columns.iter().position(|column| column.name == name);
        let placed_by: Vec<usize> = match (looked_up, is_points) {
            (Some(column), _) => by(&column.name).into_iter().collect(),
            (None, true) => COORDINATES.into_iter().filter_map(by).collect(),
            (None, false) => by(PLACES[usize::from(is_relative)].0).into_iter().collect(),
        };
        let of_axis = PLACES[usize::from(is_relative)].1;
        let last = places.len() - 1;
        let mut read = columns
            .iter()
            .enumerate()
            .filter(|(at, _)| between == Between::Periodic && !placed_by.contains(at));
        if let Some((_, open)) = read.find(|(_, column)| column.values[0] != column.values[last]) {
            self.errors.at(area, say::open_period(&row(last), &open.name));
            return None;
        }
        let mut columns = columns;
        for column in columns.iter_mut().filter(|_| is_spline) {
            column.slopes = match between {
                Between::Periodic => spline::periodic_slopes(&places, &column.values),
                Between::Clamped => spline::clamped_slopes(&places, &column.values),
                _ => spline::slopes(&places, &column.values),
            };
        }
        let id = TableId(self.model.tables.len());
        self.model.tables.push(Table {
            name: item.name.text.clone(),
            file: file.map(|(path, _)| path.to_string()),
            places,
            dimension: dimension.unwrap_or(of_axis),
            is_relative,
            between,
            columns,
            placed_by,
            alike: Vec::new(),
            is_param: item.is_param(),
        });
        Some(id)
    }

    /// The table with this name; `None`: reported.
    pub(in crate::check) fn table(&mut self, name: &Name) -> Option<TableId> {
        let item = self.item(name, Keyword::Table)?;
        self.tables.get(item.name.text.as_str()).copied().flatten()
    }

    /// `table.column` where the place along an axis is known; `None`: something else.
    pub(in crate::check) fn column(&mut self, expr: &'a Expr, scope: Scope) -> Option<Option<Typed>> {
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            return None;
        };
        let ExprKind::Name(name) = &base.kind else {
            return None;
        };
        if self.particle.contains_key(name.text.as_str()) {
            return None;
        }
        let Some(item) = self.names.get(name.text.as_str()) else {
            let tables = self.known(&[Keyword::Table]);
            // Elsewhere a body or joint may be meant.
            let is_table = self.is_along || self.looks_up && suggest::nearest(&name.text, &tables).is_some();
            if !is_table || tables.is_empty() || !self.is_news(&name.text) {
                return None;
            }
            self.errors.at(name.span, suggest::unknown("table", &name.text, tables));
            return Some(None);
        };
        if item.keyword != Keyword::Table {
            return None;
        }
        let Some(known) = self.tables.get(name.text.as_str()) else {
            // What is resolved before tables cannot read them.
            let message = if arguments.is_some() {
                say::LOOKUP_ELSEWHERE
            } else {
                say::COLUMN_ELSEWHERE
            };
            self.errors.at(expr.area, message);
            return Some(None);
        };
        let Some(id) = *known else {
            return Some(None);
        };
        let table = &self.model.tables[id.0];
        let Some(column) = table.columns.iter().position(|column| column.name == field.text) else {
            let known: Vec<String> = table.columns.iter().map(|column| column.name.clone()).collect();
            let message = suggest::unknown(
                &format!("column of `{}`", name.text),
                &field.text,
                known.iter().map(String::as_str),
            );
            self.errors.at(field.span, message);
            return Some(None);
        };
        self.read_columns.insert((id, column));
        if let Some(arguments) = arguments {
            return Some(self.looked_up(expr, (id, column), arguments, scope));
        }
        if !table.is_along() {
            let message = say::lookup_without_place(&name.text, &field.text);
            self.errors.at(expr.area, message);
            return Some(None);
        }
        if self.looks_up && !self.is_along {
            let message = say::lookup_in_law(&name.text, &field.text);
            self.errors.at(expr.area, message);
            return Some(None);
        }
        if !self.is_along {
            self.errors.at(expr.area, say::COLUMN_ELSEWHERE);
            return Some(None);
        }
        Some(Some(self.column_at(id, column)))
    }

    /// `table.column(place)`
    fn looked_up(
        &mut self,
        expr: &'a Expr,
        (id, column): (TableId, usize),
        arguments: &'a [Argument],
        scope: Scope,
    ) -> Option<Typed> {
        if !self.may_look_up() {
            self.errors.at(expr.area, say::LOOKUP_ELSEWHERE);
            return None;
        }
        let [Argument { name: None, value }] = arguments else {
            self.errors.at(expr.area, say::LOOKUP);
            return None;
        };
        let at = self.expr(value, scope)?;
        let table = &self.model.tables[id.0];
        let is_angle = table.dimension[5] != 0;
        let wanted = Dimension::of(table.dimension);
        if at.dimension != wanted {
            let message = say::lookup_of(&table.name, &wanted.describe(is_angle), &at.describe());
            self.errors.at(value.area, message);
            return None;
        }
        if wanted.is_none() && at.nature.angle && !is_angle {
            let message = say::lookup_of_angle(&table.name);
            self.errors.at(value.area, message);
            return None;
        }
        if wanted.is_none() && is_angle {
            self.no_bare_number("the place in a table over an angle", value)?;
        }
        let table = &self.model.tables[id.0];
        let of_rows = table.placed_by.first().map(|&place| self.column_at(id, place).nature);
        if of_rows.is_some_and(|rows| rows.clashes(at.nature)) {
            self.errors.at(value.area, say::HERTZ);
            return None;
        }
        let typed = self.column_at(id, column);
        Some(Typed {
            value: Value::Lookup {
                table: id,
                column,
                at: Box::new(at.value),
            },
            ..typed
        })
    }

    /// Whether a table has a meaning at a certain place here.
    pub(in crate::check) fn may_look_up(&self) -> bool {
        self.looks_up || self.particle.contains_key(PARTICLE)
    }

    /// Resolves what tables are looked up in.
    pub(in crate::check) fn with_lookups<T>(&mut self, resolve: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.looks_up, true);
        let result = resolve(self);
        self.looks_up = before;
        result
    }

    /// Whether what prescribes a motion looks up tables alone whose accelerations have no steps; or else reported.
    pub(in crate::check) fn is_smooth<'e>(&mut self, area: Area, values: impl IntoIterator<Item = &'e Value>) -> bool {
        let rough = values.into_iter().find_map(|value| self.rough_table(value));
        if let Some(table) = rough {
            let message = say::rough_motion(&self.model.tables[table.0].name);
            self.errors.at(area, message);
        }
        rough.is_none()
    }

    /// A table without accelerations that a value looks up, by itself or by motions.
    fn rough_table(&self, value: &Value) -> Option<TableId> {
        let own = match value {
            Value::Lookup { table, .. } if self.model.tables[table.0].slopes_step() => Some(*table),
            Value::Motion(motion, _) => self.rough_table(&self.model.motions[motion.0].value),
            _ => None,
        };
        own.or_else(|| value.parts().into_iter().find_map(|part| self.rough_table(part)))
    }

    /// A column as a value along the axis.
    pub(in crate::check) fn column_at(&self, table: TableId, column: usize) -> Typed {
        let dimension = self.model.tables[table.0].columns[column].dimension;
        let mut typed = Typed::new(Value::Table { table, column }, Dimension::of(dimension));
        typed.nature = Nature {
            hertz: self.model.tables[table.0].columns[column].hertz,
            ..Nature::of_unit(dimension[5])
        };
        typed
    }

    /// Resolves what may depend on the place along an axis: `x`, unless something declared has this name, and columns of
    /// tables.
    pub(in crate::check) fn along_axis<T>(&mut self, resolve: impl FnOnce(&mut Self) -> T) -> T {
        let is_free = !self.names.contains_key("x");
        if is_free {
            let length = Dimension::of(PLACES[0].1);
            self.locals.insert("x", Typed::new(Value::Arclength, length));
        }
        self.is_along = true;
        let result = resolve(self);
        self.is_along = false;
        if is_free {
            self.locals.remove("x");
        }
        result
    }
}

/// Whether a field of a table is a column.
fn is_column(field: &Field) -> bool {
    field.name.text != "interpolation" && places_named(field).is_none()
}

/// The column that a field `at = column` names as the places of a table.
fn places_named(field: &Field) -> Option<&Name> {
    match &field.value.kind {
        ExprKind::Name(name) if field.name.text == "at" => Some(name),
        _ => None,
    }
}

/// The unit of a column, and the exponent of hertz in it; `None`: there is no such unit.
fn unit_of(head: &Head<'_>) -> Option<(Compound, i8)> {
    let text = head.spelled();
    if text.is_empty() {
        return Some((Compound::ONE, 0));
    }
    let tokens: TokenStream = text.parse().ok()?;
    let mut cursor = Cursor::new(tokens, proc_macro2::Span::call_site());
    let parsed = unit::compound(&mut cursor).ok().filter(|_| cursor.is_empty())?;
    let mut factors = parsed.factors.iter();
    let compound = factors.try_fold(Compound::ONE, |all, (name, exponent)| {
        all.times(units::find(&name.text)?, *exponent)
    });
    Some((compound?, hertz(&parsed)))
}

/// The number of a cell, in SI.
fn number(cell: &str, unit: Compound) -> Option<f64> {
    let (sign, digits) = match cell.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, cell.strip_prefix('+').unwrap_or(cell)),
    };
    let value = units::scale(&digits.to_lowercase().replace("e+", "e"), unit).ok()?;
    Some(sign * value)
}
