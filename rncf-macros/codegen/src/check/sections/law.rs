//! Sections that say their stiffness and mass by themselves, field by field or from the columns of a table.

use std::collections::BTreeMap;

use super::known::{Section, Values};
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::import::rows::beyond_round_off;
use crate::model::{Column, Expr as Value, Law, TableId};
use crate::parse::tree::{Call, ExprKind};
use crate::suggest;
use crate::vocabulary::{
    BOTH_AXES, CENTRES, DAMPINGS, LAW, MASS_ENTRIES, MASSES, Property, STIFFNESS_ENTRIES, field_of, from_beamdyn,
    of_either_triangle,
};

/// The name here of a column: in either triangle of a matrix, and of BeamDyn's where it is one of that.
fn own_name(column: &str, is_beamdyn: bool) -> Option<&str> {
    if is_beamdyn {
        return from_beamdyn(column);
    }
    of_either_triangle(column).or(Some(column))
}

/// The entries on the diagonal in the row and in the column of an entry of a matrix, `K11` and `K22` of `K12`.
fn diagonal(entry: &str) -> [String; 2] {
    let (matrix, digits) = entry.split_at(1);
    [0, 1].map(|at| {
        let digit = digits.get(at..=at).unwrap_or_default();
        format!("{matrix}{digit}{digit}")
    })
}

/// Words before parentheses that make a section of a table.
pub const OF_TABLE: [&str; 2] = ["columns", "beamdyn"];

/// A field of such a section, or one that stands for both axes.
pub fn law_property(word: &str) -> Option<&'static Property> {
    field_of(&LAW, word).map(|(_, property)| property)
}

/// Words for these fields.
pub fn law_words() -> impl Iterator<Item = &'static str> {
    let both = BOTH_AXES.iter().map(|(both, _)| *both);
    let both = both.filter(|both| law_property(both).is_some());
    LAW.iter().map(|property| property.name).chain(both)
}

impl<'a> Check<'a> {
    /// `section name = columns(table);` or `= beamdyn(table, damping = ..);`
    pub(in crate::check) fn section_of_table(&mut self, name: &str, call: &'a Call) -> Option<Section> {
        let mut values = Values::new();
        let mut table = None;
        for argument in &call.arguments {
            match (&argument.name, &argument.value.kind) {
                (None, ExprKind::Name(word)) if table.is_none() => table = Some(self.table(word)?),
                (Some(word), _) => {
                    let Some((field, property)) = field_of(&LAW, &word.text) else {
                        let message = suggest::unknown("field of `section`", &word.text, law_words());
                        self.errors.at(word.span, message);
                        return None;
                    };
                    let value = self.along_axis(|check| check.field_value(field, &argument.value, property));
                    values.insert(field, (value?, argument.value.area));
                }
                _ => {
                    let usage = format!("{}(blade, damping = 2 ms)", call.name.text);
                    self.errors.at(call.area, say::usage(&call.name.text, &usage));
                    return None;
                }
            }
        }
        let Some(table) = table else {
            let usage = format!("{}(blade)", call.name.text);
            self.errors.at(call.area, say::usage(&call.name.text, &usage));
            return None;
        };
        self.fields_of_columns(table, call, &mut values)?;
        self.stiffness_law(name, values, call.area)
    }

    /// Adds the fields that columns of a table are; `None`: reported.
    fn fields_of_columns(&mut self, table: TableId, call: &'a Call, values: &mut Values) -> Option<()> {
        let is_beamdyn = call.name.text == OF_TABLE[1];
        let columns = self.model.tables[table.0].columns.clone();
        let mut taken: BTreeMap<&'static str, &Column> = BTreeMap::new();
        for (at, column) in columns.iter().enumerate() {
            let own = own_name(&column.name, is_beamdyn).and_then(|name| field_of(&LAW, name));
            let Some((field, property)) = own else {
                // Places, and what a name with an underscore tells to be spare, are nobody's field.
                if !self.model.tables[table.0].is_place(at) && !column.name.starts_with('_') {
                    self.spare_columns.push((table, at, call));
                }
                continue;
            };
            if column.dimension != property.dimension {
                let message = say::column_dimension(&column.name, field, property.unit);
                self.errors.at(call.area, message);
                return None;
            }
            for (row, &value) in column.values.iter().enumerate() {
                if !property.range.has(value) {
                    let place = self.model.tables[table.0].places[row];
                    let message = say::row_out_of_range(row + 1, place, &column.name, value);
                    self.errors.at(call.area, message);
                    return None;
                }
            }
            // Both triangles of a symmetric matrix may stand in a table, where they are one matrix.
            if let Some(other) = taken.insert(field, column) {
                let index = |field: &str| {
                    columns
                        .iter()
                        .position(|column| own_name(&column.name, is_beamdyn) == Some(field))
                };
                let diagonal = diagonal(field).map(|on_it| index(&on_it).unwrap_or(at));
                let apart = |row: usize| {
                    let values = diagonal.map(|column| columns[column].values[row]);
                    beyond_round_off([other.values[row], column.values[row]], values)
                };
                if let Some(row) = (0..column.values.len()).find(|&row| apart(row)) {
                    let values = [other, column].map(|column| (column.name.as_str(), column.values[row]));
                    self.errors.at(call.area, say::not_symmetric(values, row + 1));
                    return None;
                }
                let other = columns.iter().position(|column| column.name == other.name);
                let [i, j] = diagonal;
                self.model.tables[table.0]
                    .alike
                    .extend(other.map(|other| [other, at, i, j]));
                continue;
            }
            if let Some((_, area)) = values.get(field) {
                self.errors.at(*area, say::field_and_column(field, &column.name));
                return None;
            }
            let value = self.column_at(table, at).value;
            values.insert(field, (value, call.area));
        }
        Some(())
    }

    /// Refuses columns of sections' tables that nothing reads: behind one of them may be an entry of a matrix with a wrong name.
    pub(in crate::check) fn unread_columns(&mut self) {
        for (table, at, call) in std::mem::take(&mut self.spare_columns) {
            if self.read_columns.contains(&(table, at)) {
                continue;
            }
            let known: Vec<&str> = if call.name.text == OF_TABLE[1] {
                [STIFFNESS_ENTRIES, MASS_ENTRIES].concat()
            } else {
                law_words().collect()
            };
            let table = &self.model.tables[table.0];
            let column = table.columns[at].name.as_str();
            let message = say::unread_column(column, &table.name, &call.name.text, suggest::nearest(column, &known));
            self.errors.at(call.area, message);
        }
    }

    /// The law that fields are, checked for what contradicts, and for what a matrix lacks: of constants an element needs its own.
    pub(in crate::check) fn stiffness_law(&mut self, name: &str, values: Values, area: Area) -> Option<Section> {
        let values = self.on_each_axis(values).ok()?;
        let has = |list: &[&str]| list.iter().any(|field| values.contains_key(field));
        let mut fields: BTreeMap<&'static str, Value> = BTreeMap::new();
        for (field, (value, area)) in &values {
            if field.starts_with("damping") && fold::has_arclength(value) {
                self.errors.at(*area, say::DAMPING_ALONG);
                return None;
            }
            fields.insert(field, value.clone());
        }
        let (is_matrix, has_mass_matrix) = (has(STIFFNESS_ENTRIES), has(MASS_ENTRIES));
        for (matrix, constants) in [(STIFFNESS_ENTRIES, CENTRES), (MASS_ENTRIES, MASSES)] {
            if has(matrix) && has(constants) {
                let first = |list: &[&'static str]| {
                    list.iter()
                        .copied()
                        .find(|field| values.contains_key(field))
                        .unwrap_or("")
                };
                let message = say::two_laws(first(matrix), first(constants));
                self.errors.at(values[first(constants)].1, message);
                return None;
            }
        }
        if let Some(own) = DAMPINGS.iter().find(|own| values.contains_key(**own))
            && let Some((_, area)) = values.get("damping")
        {
            self.errors.at(*area, say::two_dampings(own));
            return None;
        }
        let law = Law {
            is_matrix,
            has_mass_matrix,
            fields,
        };
        let matrices = [(is_matrix, STIFFNESS_ENTRIES), (has_mass_matrix, MASS_ENTRIES)];
        let given = matrices.into_iter().filter(|(is_given, _)| *is_given);
        let missing = lacking(&law, given.flat_map(|(_, entries)| entries));
        if !missing.is_empty() {
            self.errors.at(area, say::missing_of_law(name, &missing));
            return None;
        }
        if !self.is_sound(name, &law, &values, area) {
            return None;
        }
        Some(Section {
            law: Some(law),
            is_whole: true,
            ..Section::default()
        })
    }
}

/// Which of some fields without defaults a law does not have.
pub fn lacking<'f>(law: &Law, fields: impl IntoIterator<Item = &'f &'static str>) -> Vec<&'static str> {
    let is_needed = |field: &&str| law_property(field).is_some_and(|property| property.default.is_none());
    let fields = fields.into_iter().copied().filter(is_needed);
    fields.filter(|field| !law.fields.contains_key(field)).collect()
}
