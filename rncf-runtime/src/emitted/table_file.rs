//! Tables whose file a run may name: read, checked against the one that the model was built with, and kept as long as the
//! program runs.

use std::ops::Deref;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use super::table::{Between, Table};
use crate::error::ModelError;
use crate::hash::hash_bytes;
use crate::import::rows::{Disorder, Head, Rows, beyond_round_off, chords, in_order, text};
use crate::import::spline::{clamped_slopes, periodic_slopes, slopes};
use crate::nearest::nearest;
use crate::units::{Number, Unit};

/// All files that were read, so that one that is read again takes no more memory.
static READ: Mutex<Vec<TableFile>> = Mutex::new(Vec::new());

/// Part of an axis by which places stay off its ends, where a section may come to a point.
const OFF_ENDS: f64 = 1e-6;

/// What the files of a parameter have, after the one that the model was built with.
#[derive(Debug)]
pub struct TableForm {
    /// The table that the model was built with.
    pub table: &'static Table,
    /// Its file, beside the manifest of the model's crate.
    pub file: &'static str,
    /// Its columns, in the order of those of the table.
    pub columns: &'static [FileColumn],
    /// Columns that the places are made of: one, or the coordinates of points.
    pub places: &'static [usize],
    /// Columns that say the same entry of a symmetric matrix, the first of which counts, and those of the entries on its diagonal in their row and column.
    pub alike: &'static [[usize; 4]],
}

/// A column of a file.
#[derive(Clone, Copy, Debug)]
pub struct FileColumn {
    /// Name in the header.
    pub name: &'static str,
    /// SI unit of its values.
    pub unit: &'static str,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
}

impl PartialEq for TableForm {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for TableForm {}

/// The value of a parameter that names the file of a table: what the model was built with, or the numbers of another file.
#[derive(Clone, Copy, Debug)]
pub struct TableFile {
    form: &'static TableForm,
    table: &'static Table,
    path: &'static str,
    number: f64,
}

impl PartialEq for TableFile {
    fn eq(&self, other: &Self) -> bool {
        self.form == other.form && self.number == other.number
    }
}

impl Deref for TableFile {
    type Target = Table;

    fn deref(&self) -> &Table {
        self.table
    }
}

impl TableFile {
    /// The table that the model was built with.
    pub const fn declared(form: &'static TableForm) -> Self {
        Self {
            form,
            table: form.table,
            path: form.file,
            number: 0.0,
        }
    }

    /// The table of another file, as `model.blade = model.blade.read("data/other.csv")?`.
    ///
    /// A file is CSV with the columns of the one that the model was built with, in any order, and the unit of each in brackets
    /// behind its name, `EI [N*m^2]`. Columns whose name begins with `_` are left alone. What is read stays in memory as long as
    /// the program runs.
    ///
    /// # Errors
    /// The file, its line or column, and what would be right.
    pub fn read(self, path: impl AsRef<Path>) -> Result<Self, ModelError> {
        let path = path.as_ref();
        let shown = path.display().to_string();
        let text = text(path, "where the program is called")
            .map_err(|error| ModelError::new(format!("the file `{shown}` cannot be read: {error}")))?;
        let (places, columns) = self.form.parse(&text).map_err(|mistake| {
            let name = self.form.table.name;
            ModelError::new(format!("the file `{shown}` for `{name}`: {mistake}"))
        })?;
        let number = checksum(&shown, &places, &columns);
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(same) = read
            .iter()
            .find(|other| other.form == self.form && other.number == number)
        {
            return Ok(*same);
        }
        let declared = self.form.table;
        let between = match declared.between {
            Between::Spline(_) => Between::Spline(keep_columns(
                columns.iter().map(|column| slopes(&places, column)).collect(),
            )),
            Between::Clamped(_) => Between::Clamped(keep_columns(
                columns.iter().map(|column| clamped_slopes(&places, column)).collect(),
            )),
            Between::Periodic(_) => Between::Periodic(keep_columns(
                columns.iter().map(|column| periodic_slopes(&places, column)).collect(),
            )),
            other => other,
        };
        let table = Table {
            name: keep(format!("{shown}` for `{}", declared.name)),
            places: Box::leak(places.into_boxed_slice()),
            is_relative: declared.is_relative,
            between,
            columns: keep_columns(columns),
        };
        let file = Self {
            form: self.form,
            table: Box::leak(Box::new(table)),
            path: keep(shown),
            number,
        };
        read.push(file);
        Ok(file)
    }

    /// Its number among the values of a parameter: 0 for the table that the model was built with, else a checksum of path and rows.
    pub fn number(self) -> f64 {
        self.number
    }

    /// The file with this number; one that no file has that was read is no number, and refused when a scene is built.
    pub fn numbered(self, number: f64) -> Self {
        if number == 0.0 {
            return Self::declared(self.form);
        }
        let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        let is_it = |other: &&Self| other.form == self.form && other.number == number;
        read.iter().find(is_it).copied().unwrap_or(Self {
            number: f64::NAN,
            ..Self::declared(self.form)
        })
    }

    /// The path of the file: that of the declaration, or as it was read.
    pub fn path(self) -> &'static str {
        self.path
    }

    /// The rows.
    pub fn table(self) -> &'static Table {
        self.table
    }

    /// Tries what depends on the rows along a body at each of them: the place where the body begins on the axis, the body's length
    /// and that of the whole axis, m.
    ///
    /// # Errors
    /// That of the first row at which there is one, with the row.
    pub fn check_rows(
        self,
        [from, length, whole]: [f64; 3],
        at: impl Fn(f64) -> Result<(), ModelError>,
    ) -> Result<(), ModelError> {
        for (row, &place) in self.table.places.iter().enumerate() {
            let x = if self.table.is_relative { place * whole } else { place } - from;
            if !(-OFF_ENDS * length..=length * (1.0 + OFF_ENDS)).contains(&x) {
                continue;
            }
            // In front of a step what holds there.
            let is_before_step = self.table.places.get(row + 1) == Some(&place);
            let x = if is_before_step { x.next_down() } else { x };
            let x = x.clamp(OFF_ENDS * length, length * (1.0 - OFF_ENDS));
            at(x).map_err(|error| {
                let name = self.table.name;
                ModelError::new(format!("{error}; it stands in row {} of table `{name}`", row + 1))
            })?;
        }
        Ok(())
    }
}

fn keep(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

fn keep_columns(columns: Vec<Vec<f64>>) -> &'static [&'static [f64]] {
    let kept = columns
        .into_iter()
        .map(|column| Box::leak(column.into_boxed_slice()) as &[f64]);
    Box::leak(kept.collect::<Vec<_>>().into_boxed_slice())
}

/// A hash of a path and the bits of all values, as a whole number of 52 bits that is not zero.
fn checksum(path: &str, places: &[f64], columns: &[Vec<f64>]) -> f64 {
    let all = std::iter::once(places).chain(columns.iter().map(Vec::as_slice));
    let values = all.flatten().flat_map(|value| value.to_bits().to_le_bytes());
    ((hash_bytes(path.bytes().chain(values)) >> 12) as f64).max(1.0)
}

type Columns = Vec<Vec<f64>>;

impl TableForm {
    /// Places and columns that a text has.
    fn parse(&self, text: &str) -> Result<(Vec<f64>, Columns), String> {
        let rows = Rows::read(text).map_err(|mistake| mistake.to_string())?;
        let sources = self.sources(&rows.heads)?;
        let cells: Vec<usize> = sources.iter().map(|&(cell, _)| cell).collect();
        let number = |column: usize, cell: &str| {
            let (number, _) = Number::split(cell).filter(|(_, rest)| rest.is_empty())?;
            Some(sources[column].1.to_si(number))
        };
        let columns = rows.columns(&cells, number).map_err(|mistake| mistake.to_string())?;
        let places = self.placed(&columns, &rows)?;
        let last = places.len() - 1;
        let repeats = matches!(self.table.between, Between::Periodic(_));
        let mut read = (0..columns.len()).filter(|column| repeats && !self.places.contains(column));
        if let Some(open) = read.find(|&column| columns[column][0] != columns[column][last]) {
            return Err(format!(
                "line {}: the last row of `{}` repeats the first one, and differs from it",
                rows.line(last),
                self.columns[open].name
            ));
        }
        for &[one, other, i, j] in self.alike {
            let differ = |&row: &usize| {
                let values = |of: [usize; 2]| of.map(|column| columns[column][row]);
                beyond_round_off(values([one, other]), values([i, j]))
            };
            if let Some(row) = (0..places.len()).find(differ) {
                let [one, other] = [one, other].map(|column| (self.columns[column].name, columns[column][row]));
                return Err(format!(
                    "line {}: `{}` and `{}` are one entry of a symmetric matrix, and differ: {} and {}",
                    rows.line(row),
                    one.0,
                    other.0,
                    one.1,
                    other.1
                ));
            }
        }
        Ok((places, columns))
    }

    /// Where in a header each column stands, and in which unit.
    fn sources(&self, heads: &[Head<'_>]) -> Result<Vec<(usize, Unit)>, String> {
        let known = || self.columns.iter().map(|column| column.name);
        for (at, head) in heads.iter().enumerate() {
            let name = head.name;
            if heads[..at].iter().any(|other| other.name == name) {
                return Err(format!("two columns have the name `{name}`"));
            }
            if !known().any(|known| known == name) && !head.is_note() {
                let near = nearest(name, known()).map_or(String::new(), |near| format!("did you mean `{near}`? Or "));
                return Err(format!(
                    "nothing reads the column `{name}`, which `{}` does not have; {near}take it out, or call it `_{name}`",
                    self.file
                ));
            }
        }
        let source = |column: &FileColumn| {
            let Some(cell) = heads.iter().position(|head| head.name == column.name) else {
                let unit = if column.unit == "1" { "-" } else { column.unit };
                return Err(format!("the column `{} [{unit}]` is missing", column.name));
            };
            if heads[cell].unit.is_empty() && column.dimension != [0; 6] {
                return Err(format!(
                    "the column `{0}` has no unit; write e.g. `{0} [{1}]`",
                    column.name, column.unit
                ));
            }
            let unit = Unit::parse(&heads[cell].spelled());
            let unit = unit.map_err(|mistake| format!("column `{}`: {mistake}", column.name))?;
            if unit.dimension != column.dimension {
                return Err(format!(
                    "the unit `{}` of column `{}` does not have the dimension of {}",
                    heads[cell].unit, column.name, column.unit
                ));
            }
            Ok((cell, unit))
        };
        self.columns.iter().map(source).collect()
    }

    /// The places of the rows, which ascend.
    fn placed(&self, columns: &[Vec<f64>], rows: &Rows<'_>) -> Result<Vec<f64>, String> {
        let places = match *self.places {
            [x, y, z] => chords([&columns[x], &columns[y], &columns[z]]),
            [one, ..] => columns[one].clone(),
            [] => Vec::new(),
        };
        in_order(&places, self.places.len() == 3).map_err(|disorder| match disorder {
            Disorder::TooFew => "it has fewer than two rows".to_string(),
            Disorder::Order(row) if self.places.len() == 3 => format!(
                "line {}: the point is where the one before it is, or at no finite distance from it: points follow each other along an axis",
                rows.line(row)
            ),
            Disorder::Order(row) => format!(
                "line {}: places of rows ascend, and {} follows {}",
                rows.line(row),
                places[row],
                places[row - 1]
            ),
            Disorder::StepAtEnd => {
                "it begins or ends with a step: two rows at one place stand between others".to_string()
            }
        })?;
        let is_spline = matches!(
            self.table.between,
            Between::Spline(_) | Between::Clamped(_) | Between::Periodic(_)
        );
        match (1..places.len()).find(|&row| is_spline && places[row] == places[row - 1]) {
            Some(row) => Err(format!(
                "line {}: it is at the place of the one before it, and a spline has no steps: leave it out",
                rows.line(row)
            )),
            None => Ok(places),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static MAST: Table = Table {
        name: "mast",
        places: &[0.0, 2.0],
        is_relative: false,
        between: Between::Line,
        columns: &[&[0.0, 2.0], &[1.0, 3.0], &[5.0, 5.0]],
    };

    static FORM: TableForm = TableForm {
        table: &MAST,
        file: "mast.csv",
        columns: &[
            FileColumn {
                name: "x",
                unit: "m",
                dimension: [1, 0, 0, 0, 0, 0],
            },
            FileColumn {
                name: "EI",
                unit: "N m^2",
                dimension: [3, 1, -2, 0, 0, 0],
            },
            FileColumn {
                name: "EI_again",
                unit: "N m^2",
                dimension: [3, 1, -2, 0, 0, 0],
            },
        ],
        places: &[0],
        alike: &[[1, 2, 1, 1]],
    };

    fn read(name: &str, text: &str) -> Result<TableFile, ModelError> {
        let path = std::env::temp_dir().join(format!("rncf-table-{}-{name}.csv", std::process::id()));
        std::fs::write(&path, text).unwrap();
        let found = TableFile::declared(&FORM).read(&path);
        std::fs::remove_file(&path).unwrap();
        found
    }

    #[test]
    fn columns_stand_in_any_order_and_unit() {
        let text = "# a mast\n\nEI_again [kN*m^2], _note, x [in], EI [N m^2]\n0.5, a, 0, 500\n+1e0, b, 10, 1000\n";
        let file = read("order", text).unwrap();
        assert_eq!(file.places, [0.0, 10.0 * 0.0254]);
        assert_eq!(
            file.columns,
            [&[0.0, 10.0 * 0.0254], &[500.0, 1000.0], &[500.0, 1000.0]]
        );
        let nearly = text.replace("0.5, a", "0.5000000000001, a");
        assert_eq!(read("nearly", &nearly).unwrap().columns[1], [500.0, 1000.0]);
        let declared = TableFile::declared(&FORM);
        assert_eq!((declared.number(), declared.path()), (0.0, "mast.csv"));
        assert_eq!(declared.numbered(file.number()), file);
        assert!(file != declared && file.numbered(0.0) == declared && declared.numbered(3.0).number().is_nan());
        // The same file again takes no memory; another one with these rows is told by its own name.
        let again = read("order", text).unwrap();
        assert!(again == file && std::ptr::eq(again.table(), file.table()));
        let other = read("other", text).unwrap();
        assert!(other != file && other.columns == file.columns && other.path().contains("other"));
    }

    #[test]
    fn wrong_files_are_told_at_the_line_or_column() {
        let head = "x [m], EI [N*m^2], EI_again [N*m^2]\n";
        for (name, text, wanted) in [
            ("empty", "# nothing\n", "it is empty"),
            (
                "missing",
                "x [m], EI [N*m^2]\n0, 1\n1, 2\n",
                "the column `EI_again [N m^2]` is missing",
            ),
            (
                "near",
                "x [m], EI [N*m^2], EI_agian [N*m^2]\n",
                "did you mean `EI_again`?",
            ),
            (
                "spare",
                "x [m], EI [N*m^2], EI_again [N*m^2], height\n",
                "call it `_height`",
            ),
            ("twice", "x [m], x [m]\n", "two columns have the name `x`"),
            (
                "unit",
                "x [m], EI [N*m], EI_again [N*m^2]\n",
                "the unit `N*m` of column `EI` does not",
            ),
            (
                "symbol",
                "x [mtr], EI [N*m^2], EI_again [N*m^2]\n",
                "column `x`: `mtr` is not a unit",
            ),
            ("cells", &format!("{head}0, 1\n"), "line 2 has 2 cells"),
            (
                "nan",
                &format!("{head}0, 1, 1\n1, NaN, 1\n"),
                "line 3: `NaN` in column `EI`",
            ),
            (
                "order",
                &format!("{head}0, 1, 1\n2, 1, 1\n1, 1, 1\n"),
                "line 4: places of rows ascend, and 1 follows 2",
            ),
            ("row", &format!("{head}0, 1, 1\n"), "fewer than two rows"),
            (
                "step",
                &format!("{head}0, 1, 1\n0, 1, 1\n"),
                "begins or ends with a step",
            ),
            (
                "alike",
                &format!("{head}0, 1, 1\n1, 1, 2\n"),
                "line 3: `EI` and `EI_again` are one entry of a symmetric matrix, and differ: 1 and 2",
            ),
        ] {
            let told = read(name, text).unwrap_err().to_string();
            assert!(told.contains(wanted) && told.contains("for `mast`"), "{name}: {told}");
        }
        let plain = read("plain", "x, EI [N*m^2], EI_again [N*m^2]\n0, 1, 1\n1, 1, 1\n")
            .unwrap_err()
            .to_string();
        assert!(
            plain.contains("the column `x` has no unit; write e.g. `x [m]`"),
            "{plain}"
        );
        let told = |path: &str| TableFile::declared(&FORM).read(path).unwrap_err().to_string();
        let missing = told("no/such.csv");
        assert!(
            missing.contains("`no/such.csv` cannot be read")
                && missing.ends_with("a path begins where the program is called"),
            "{missing}"
        );
        let folder = told(env!("CARGO_MANIFEST_DIR"));
        assert!(
            folder.contains("cannot be read") && folder.ends_with("give the path of a file in it"),
            "{folder}"
        );
    }

    #[test]
    fn text_that_is_not_utf_8_is_told_with_its_line() {
        let write = |name: &str, bytes: &[u8]| {
            let path = std::env::temp_dir().join(format!("rncf-table-{}-{name}.csv", std::process::id()));
            std::fs::write(&path, bytes).unwrap();
            let told = TableFile::declared(&FORM).read(&path).unwrap_err().to_string();
            std::fs::remove_file(&path).unwrap();
            told
        };
        let latin = write(
            "latin",
            b"x [m], EI [N*m^2], EI_again [N*m^2], _turn\n0, 1, 1, 2\n1, 1, 1, 2\xb0\n",
        );
        assert!(
            latin.ends_with("line 3 is no text in UTF-8; save the file as UTF-8"),
            "{latin}"
        );
        let wide: Vec<u8> = "x [m], EI\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let wide = write("wide", &[&[0xff, 0xfe], &wide[..]].concat());
        assert!(wide.contains("line 1 is no text in UTF-8"), "{wide}");
    }

    /// A table of a million rows is read, looked up, and taken for the same when it is read again.
    #[test]
    fn a_million_rows_are_read() {
        use std::fmt::Write;
        let count = 1_000_000;
        let mut text = "x [mm]; EI [N*m^2]; EI_again [N*m^2]\n".to_string();
        for row in 0..count {
            let _ = writeln!(text, "{row};{0};{0}", 2 * row + 1);
        }
        let file = read("million", &text).unwrap();
        assert_eq!(file.places.len(), count);
        assert!((file.at(1, 777.5, 1e3) - 1_555_001.0).abs() < 1e-6);
        assert!(std::ptr::eq(read("million", &text).unwrap().table(), file.table()));
    }

    #[test]
    fn the_row_is_told_at_which_something_is_wrong() {
        let file = TableFile::declared(&FORM);
        let at = |x: f64| (x < 1.0).then_some(()).ok_or_else(|| ModelError::new("too far"));
        let told = file.check_rows([0.0, 2.0, 2.0], at).unwrap_err().to_string();
        assert_eq!(told, "too far; it stands in row 2 of table `mast`");
        // A piece that ends before that row.
        assert!(file.check_rows([0.0, 1.0, 2.0], at).is_ok());
    }
}
