//! chart.csv: one line a point, appended as soon as it is known, so that nothing is lost; of two lines of a point the
//! later one holds.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use super::errors::ColumnError;
use super::grid::{Grid, Setting};
use crate::Statistics;
use crate::app::line::chart::method_name;
use crate::app::machine::files;
use crate::app::results::history::{Column, History};

/// Name of the file.
pub(super) const NAME: &str = "chart.csv";

/// What became of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outcome {
    Complete,
    /// Why it stopped.
    Failed(String),
    /// It was ended after this processor time, s.
    TooLong(f64),
}

/// A setting with what it costs and how good it is.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub setting: Setting,
    /// Stands for the problem, the settings and the references.
    pub key: u64,
    pub outcome: Outcome,
    pub unknowns: u64,
    pub constraints: u64,
    pub counts: Counts,
    /// Processor time, s, the least of the repetitions; `None` before it is measured.
    pub cpu: Option<f64>,
    pub repetitions: u64,
    /// Difference from the reference, column by column; empty where the run is not complete.
    pub errors: Vec<ColumnError>,
    /// Difference from the converged run on the same mesh: that of the time integration alone.
    pub time_errors: Vec<ColumnError>,
}

/// Operation counts of a run, as [`Statistics`] has them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Counts {
    pub steps: u64,
    pub rejected: u64,
    pub at_ceiling: u64,
    pub newton: u64,
    pub residuals: u64,
    pub tangents: u64,
    pub factorizations: u64,
    pub solves: u64,
}

impl From<&Statistics> for Counts {
    fn from(statistics: &Statistics) -> Self {
        Self {
            steps: statistics.steps,
            rejected: statistics.rejected_steps,
            at_ceiling: statistics.steps_at_ceiling,
            newton: statistics.newton_iterations,
            residuals: statistics.residual_evaluations,
            tangents: statistics.jacobian_evaluations,
            factorizations: statistics.factorizations,
            solves: statistics.solves,
        }
    }
}

/// Fields before the errors.
const FIELDS: &str = "key,formulation,mesh,integrator,rtol,outcome,reason,unknowns,constraints,steps,rejected,at_ceiling,newton,residuals,tangents,factorizations,solves,cpu_s,repetitions";

/// The file of a chart.
pub(super) struct Table {
    folder: PathBuf,
    columns: Vec<Column>,
}

impl Table {
    /// In a folder, for histories with these columns.
    pub fn new(folder: &Path, history: &History) -> Self {
        Self {
            folder: folder.into(),
            columns: history.columns.clone(),
        }
    }

    fn head(&self) -> String {
        let mut head = FIELDS.to_owned();
        for kind in ["error_max", "error_rms", "time_error_max", "time_error_rms"] {
            for column in &self.columns {
                let _ = write!(head, ",{} {kind} [{}]", column.name, column.unit);
            }
        }
        head
    }

    /// The points of the file by their keys; what is in it is for other settings where a key is not met. A file of
    /// another form counts as empty, and so does a last line that was not completed.
    ///
    /// # Errors
    /// The file cannot be read, or a complete line makes no sense: its number.
    pub fn read(&self, settings: &[(Setting, u64)]) -> Result<HashMap<u64, Point>, String> {
        let path = self.folder.join(NAME);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(HashMap::new()),
            Err(error) => return Err(format!("cannot read {}: {error}", path.display())),
        };
        let known: HashMap<u64, Setting> = settings.iter().map(|&(setting, key)| (key, setting)).collect();
        let mut points = HashMap::new();
        let complete = text.rfind('\n').map_or("", |end| &text[..end]);
        let mut lines = complete.split('\n');
        if lines.next() != Some(self.head().as_str()) {
            return Ok(points);
        }
        for (index, line) in lines.enumerate() {
            let point = self.parse(line, &known).ok_or_else(|| {
                format!(
                    "{}, line {}: this is no point of a chart; `--fresh` begins anew",
                    path.display(),
                    index + 2
                )
            })?;
            if let Some(point) = point {
                points.insert(point.key, point);
            }
        }
        Ok(points)
    }

    /// The point of a line; `Some(None)` where its key is of no setting.
    fn parse(&self, line: &str, known: &HashMap<u64, Setting>) -> Option<Option<Point>> {
        let mut fields = line.split(',');
        let mut next = || fields.next();
        let key = u64::from_str_radix(next()?, 16).ok()?;
        // Formulation, mesh, integrator and tolerance are in the key.
        for _ in 0..4 {
            next()?;
        }
        let (word, reason) = (next()?, next()?);
        let outcome = match word {
            "complete" => Outcome::Complete,
            "failed" => Outcome::Failed(reason.into()),
            "too long" => Outcome::TooLong(reason.trim_end_matches(" s").parse().ok()?),
            _ => return None,
        };
        let mut numbers = [0_u64; 10];
        for number in &mut numbers {
            *number = next()?.parse().ok()?;
        }
        let [
            unknowns,
            constraints,
            steps,
            rejected,
            at_ceiling,
            newton,
            residuals,
            tangents,
            factorizations,
            solves,
        ] = numbers;
        let cpu = match next()? {
            "" => None,
            text => Some(text.parse().ok()?),
        };
        let repetitions = next()?.parse().ok()?;
        let mut values = Vec::new();
        if outcome == Outcome::Complete {
            for field in fields.by_ref() {
                values.push(field.parse::<f64>().ok().filter(|value| value.is_finite())?);
            }
        }
        let count = self.columns.len();
        if outcome == Outcome::Complete && values.len() != 4 * count {
            return None;
        }
        let errors = |first: usize| {
            let of = |index: usize| ColumnError {
                max: values[first * count + index],
                rms: values[(first + 1) * count + index],
            };
            (0..values.len() / 4).map(of).collect::<Vec<_>>()
        };
        let Some(&setting) = known.get(&key) else {
            return Some(None);
        };
        Some(Some(Point {
            setting,
            key,
            outcome,
            unknowns,
            constraints,
            counts: Counts {
                steps,
                rejected,
                at_ceiling,
                newton,
                residuals,
                tangents,
                factorizations,
                solves,
            },
            cpu,
            repetitions,
            errors: errors(0),
            time_errors: errors(2),
        }))
    }

    fn line(&self, grid: &Grid, point: &Point) -> String {
        let setting = &point.setting;
        let (word, reason) = match &point.outcome {
            Outcome::Complete => ("complete", String::new()),
            Outcome::Failed(reason) => ("failed", reason.replace(',', ";").replace(['\n', '\r'], " ")),
            Outcome::TooLong(limit) => ("too long", format!("{limit} s")),
        };
        let mesh = match grid.meshes[setting.mesh].name.as_str() {
            "" => "-",
            name => name,
        };
        let mut line = format!(
            "{:016x},{},{mesh},{},{:e},{word},{reason}",
            point.key,
            setting.formulation.name(),
            method_name(setting.method),
            setting.rtol
        );
        let c = &point.counts;
        for number in [
            point.unknowns,
            point.constraints,
            c.steps,
            c.rejected,
            c.at_ceiling,
            c.newton,
            c.residuals,
            c.tangents,
            c.factorizations,
            c.solves,
        ] {
            let _ = write!(line, ",{number}");
        }
        let cpu = point.cpu.map_or_else(String::new, |cpu| format!("{cpu:.4e}"));
        let _ = write!(line, ",{cpu},{}", point.repetitions);
        for errors in [&point.errors, &point.time_errors] {
            let max = errors.iter().map(|error| error.max);
            self.values(&mut line, max);
            let rms = errors.iter().map(|error| error.rms);
            self.values(&mut line, rms);
        }
        line.push('\n');
        line
    }

    /// A field for every column, empty where there is no value.
    fn values(&self, line: &mut String, mut values: impl Iterator<Item = f64>) {
        for _ in &self.columns {
            match values.next() {
                Some(value) => {
                    let _ = write!(line, ",{value:.6e}");
                }
                None => line.push(','),
            }
        }
    }

    /// Writes the whole file anew.
    ///
    /// # Errors
    /// The path and the system's reason.
    pub fn write<'p>(&self, grid: &Grid, points: impl IntoIterator<Item = &'p Point>) -> Result<(), String> {
        let mut text = self.head() + "\n";
        for point in points {
            text += &self.line(grid, point);
        }
        files::write(&self.folder, NAME, &text)
    }

    /// Adds a point at the end, a whole line at once.
    ///
    /// # Errors
    /// The path and the system's reason.
    pub fn append(&self, grid: &Grid, point: &Point) -> Result<(), String> {
        let path = self.folder.join(NAME);
        let added = OpenOptions::new()
            .append(true)
            .open(&path)
            .and_then(|mut file| file.write_all(self.line(grid, point).as_bytes()));
        added.map_err(|error| format!("cannot write {}: {error}", path.display()))
    }
}
