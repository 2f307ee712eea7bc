//! Another run beside this one: its curves in the same charts, and by how much the outputs differ.

use std::fmt::Write;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::app::results::history::{Column, HISTORY, SKETCHED};
use crate::app::results::sketch::Sketch;
use crate::app::writing::entries::Summary;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;

/// The history of another run, whose head is known.
#[derive(Clone, Debug)]
pub(in crate::app) struct Other {
    path: PathBuf,
    heads: Vec<String>,
}

/// The largest difference of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Difference {
    /// This run less the other one, SI.
    value: f64,
    /// When, s.
    at: f64,
    /// Largest magnitude in the other run at the times that are compared, SI.
    size: f64,
}

/// What is known of another run beside this one.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Beside {
    /// Where the other run's history is.
    pub name: String,
    /// Columns of this run that the other one has, too, with their heads, and the largest difference; none where no time is common.
    columns: Vec<(usize, String, Option<Difference>)>,
    /// Columns that one of them has.
    alone: Vec<String>,
    /// Rows of this run at times that the other one reaches, and all.
    rows: [u64; 2],
    /// Rows of the other run for pictures, common columns alone.
    keys: Vec<f64>,
    values: Vec<f64>,
}

impl Other {
    /// The history in a folder, or a file; `out` is the folder of this run, `own` are its columns.
    ///
    /// # Errors
    /// No such file, one that is no history, or of which no column is among these, or the one that this run writes.
    pub fn open(path: &Path, out: &Path, own: &[Column]) -> Result<Self, String> {
        let path = if path.is_dir() {
            path.join(HISTORY)
        } else {
            path.to_owned()
        };
        let shown = path.display();
        let same = |a: &Path, b: &Path| a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b));
        if same(&path, &out.join(HISTORY)) {
            return Err(format!(
                "--compare: {shown} is what this run writes; give the folder of another run, or `--out`"
            ));
        }
        let opened = Rows::open(&path);
        let (heads, _) = opened.map_err(|text| {
            format!("--compare: {text}; give the folder of another run of this model, or its history.csv")
        })?;
        let other = Self {
            path: path.clone(),
            heads,
        };
        if other.common(own).is_empty() {
            return Err(format!(
                "--compare: no output of {shown} is one of this model; it has {}",
                other.heads[1..].join(", ")
            ));
        }
        Ok(other)
    }

    /// Columns of this run with their places in the other one's rows.
    fn common(&self, own: &[Column]) -> Vec<(usize, usize)> {
        let place = |column: &Column| self.heads.iter().skip(1).position(|head| *head == column.head());
        own.iter()
            .enumerate()
            .filter_map(|(index, column)| Some((index, place(column)?)))
            .collect()
    }

    /// Compares with the history of this run, which is written.
    ///
    /// # Errors
    /// A file that cannot be read, or a line that is no row.
    pub fn beside(&self, own: &Path, columns: &[Column]) -> Result<Beside, String> {
        let common = self.common(columns);
        let (_, mut rows) = Rows::open(own)?;
        let (_, mut others) = Rows::open(&self.path)?;
        let head = |&(index, _): &(usize, usize)| (index, columns[index].head(), None);
        let mut found = Beside {
            name: self.path.display().to_string(),
            columns: common.iter().map(head).collect(),
            alone: Vec::new(),
            rows: [0; 2],
            keys: Vec::new(),
            values: Vec::new(),
        };
        let is_common = |head: &&String| columns.iter().any(|column| column.head() == **head);
        let own_alone = (0..columns.len()).filter(|index| !common.iter().any(|pair| pair.0 == *index));
        found
            .alone
            .extend(own_alone.map(|index| format!("{} (this run)", columns[index].head())));
        let other_alone = self.heads[1..].iter().filter(|head| !is_common(head));
        found
            .alone
            .extend(other_alone.map(|head| format!("{head} (the other)")));
        let mut sketch = Sketch::new(SKETCHED);
        let mut next = |found: &mut Beside| -> Result<Option<(f64, Vec<f64>)>, String> {
            let Some((t, row)) = others.next()? else {
                return Ok(None);
            };
            let row: Vec<f64> = common.iter().map(|&(_, place)| row[place]).collect();
            sketch.add(&mut found.keys, &mut found.values, t, &row);
            Ok(Some((t, row)))
        };
        // The rows of the other run before and behind a time.
        let mut before = next(&mut found)?;
        let mut behind = next(&mut found)?;
        while let Some((t, row)) = rows.next()? {
            found.rows[1] += 1;
            while behind.as_ref().is_some_and(|(end, _)| *end < t) {
                before = behind;
                behind = next(&mut found)?;
            }
            let Some(values) = between(before.as_ref(), behind.as_ref(), t) else {
                continue;
            };
            found.rows[0] += 1;
            for ((index, _, largest), other) in found.columns.iter_mut().zip(values) {
                let (value, size) = (row[*index] - other, other.abs());
                let met = largest.get_or_insert(Difference { value, at: t, size });
                met.size = met.size.max(size);
                if value.abs() > met.value.abs() {
                    (met.value, met.at) = (value, t);
                }
            }
        }
        while next(&mut found)?.is_some() {}
        Ok(found)
    }
}

/// Values at a time, on the straight line between two rows; none beyond them.
fn between(before: Option<&(f64, Vec<f64>)>, behind: Option<&(f64, Vec<f64>)>, t: f64) -> Option<Vec<f64>> {
    let (start, first) = before?;
    if t == *start {
        return Some(first.clone());
    }
    let (end, last) = behind?;
    if !(*start..=*end).contains(&t) {
        return None;
    }
    if t == *end {
        return Some(last.clone());
    }
    let part = (t - start) / (end - start);
    Some(first.iter().zip(last).map(|(a, b)| a + part * (b - a)).collect())
}

impl Beside {
    /// The curve of a column of this run in the other one.
    pub fn curve(&self, column: usize) -> Option<impl Iterator<Item = (f64, f64)> + '_> {
        let place = self.columns.iter().position(|(index, ..)| *index == column)?;
        let values = self.values.iter().skip(place).step_by(self.columns.len());
        Some(self.keys.iter().copied().zip(values.copied()))
    }

    /// Adds the differences to a summary.
    pub fn put(&self, summary: &mut Summary) {
        let entry = |(_, head, largest): &(usize, String, Option<Difference>)| {
            let told = largest.map(|of| json!({ "value": of.value, "at": of.at, "size": of.size }));
            json!({ "column": head, "largest_difference": told })
        };
        let columns: Vec<Value> = self.columns.iter().map(entry).collect();
        summary.insert(
            "compared".into(),
            json!({ "with": self.name, "rows": self.rows[0], "columns": columns, "not_in_both": self.alone }),
        );
    }

    /// The table of the report.
    pub fn table(&self) -> String {
        let mut text = format!("<section class=\"beside\">\n<h3>Beside {}</h3>\n", escape(&self.name));
        let [compared, all] = self.rows;
        let _ = writeln!(
            text,
            "<p class=\"doc\">Largest differences, this run less the other one, at {compared} of {all} rows; between rows of the other run there are straight lines.</p>"
        );
        text += "<div class=\"scroll\"><table>\n<tr><th>Output</th><th class=\"n\">Largest difference</th><th class=\"n\">At t [s]</th>\
            <th class=\"n\">Of the largest magnitude</th></tr>\n";
        for (_, head, largest) in &self.columns {
            let cells = match largest {
                Some(of) if of.size > 0.0 => [
                    digits(of.value, 4),
                    digits(of.at, 6),
                    format!("{} %", digits(100.0 * of.value.abs() / of.size, 3)),
                ],
                Some(of) => [digits(of.value, 4), digits(of.at, 6), "–".into()],
                None => ["–".into(), "–".into(), "–".into()],
            };
            let cells = cells.map(|cell| format!("<td class=\"n\">{cell}</td>"));
            let _ = writeln!(text, "<tr><td>{}</td>{}</tr>", escape(head), cells.concat());
        }
        text += "</table></div>\n";
        if !self.alone.is_empty() {
            let _ = writeln!(
                text,
                "<p class=\"doc\">Not in both: {}.</p>",
                escape(&self.alone.join(", "))
            );
        }
        text + "</section>\n"
    }
}

/// Rows of a history, one after the other.
struct Rows {
    path: PathBuf,
    lines: std::io::Lines<BufReader<File>>,
    width: usize,
    number: usize,
}

impl Rows {
    /// The heads, and what reads the rows.
    fn open(path: &Path) -> Result<(Vec<String>, Self), String> {
        let shown = path.display();
        let file = File::open(path).map_err(|error| format!("cannot read {shown}: {error}"))?;
        let mut lines = BufReader::new(file).lines();
        let head = lines.next().and_then(Result::ok).unwrap_or_default();
        let heads: Vec<String> = head.split(',').map(str::to_owned).collect();
        if heads[0] != Column::time().head() {
            return Err(format!(
                "{shown} is no history of a run: its first line does not begin with `t [s]`"
            ));
        }
        let rows = Self {
            path: path.to_owned(),
            lines,
            width: heads.len(),
            number: 1,
        };
        Ok((heads, rows))
    }

    /// Time and values of the next row.
    fn next(&mut self) -> Result<Option<(f64, Vec<f64>)>, String> {
        let Some(line) = self.lines.next() else { return Ok(None) };
        self.number += 1;
        let line = line.map_err(|error| format!("cannot read {}: {error}", self.path.display()))?;
        let numbers: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        match numbers {
            Ok(mut numbers) if numbers.len() == self.width && numbers.iter().all(|x| x.is_finite()) => {
                let t = numbers.remove(0);
                Ok(Some((t, numbers)))
            }
            _ => Err(format!(
                "{}: line {} is no row of its {} columns",
                self.path.display(),
                self.number,
                self.width
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::app::testing::temporary_folder;

    fn columns() -> Vec<Column> {
        let column = |name: &str, unit| Column {
            name: name.into(),
            unit,
        };
        vec![column("u", "m"), column("pull", "N"), column("own", "m")]
    }

    /// Two files in a folder.
    fn files(name: &str, own: &str, other: &str) -> (PathBuf, PathBuf) {
        let folder = temporary_folder(name);
        fs::create_dir_all(folder.join("other")).unwrap();
        fs::write(folder.join(HISTORY), own).unwrap();
        fs::write(folder.join("other").join(HISTORY), other).unwrap();
        (folder.clone(), folder.join("other"))
    }

    #[test]
    fn the_largest_difference_stands_with_its_time_and_size() {
        let own = "t [s],u [m],pull [N],own [m]\n0,1,10,0\n0.5,2,10,0\n1,3,10,0\n1.5,9,10,0\n2,9,99,0\n";
        let other = "t [s],pull [N],more [m],u [m]\n0,10,0,1\n1,12,0,2\n1.75,10,0,9\n";
        let (folder, path) = files("compare", own, other);
        let found = Other::open(&path, &folder, &columns()).unwrap();
        let beside = found.beside(&folder.join(HISTORY), &columns()).unwrap();
        fs::remove_dir_all(folder).unwrap();
        // At 1.5 s the other has 2 + 7 * 2/3; at 2 s nothing.
        let (value, size) = (9.0 - (2.0 + 14.0 / 3.0), 2.0 + 14.0 / 3.0);
        let [u, pull] = [0, 1].map(|column: usize| beside.columns[column].2.unwrap());
        assert!(
            (u.value - value).abs() < 1e-12 && u.at == 1.5 && (u.size - size).abs() < 1e-12,
            "{u:?}"
        );
        assert_eq!((pull.value, pull.at, pull.size), (-2.0, 1.0, 12.0));
        assert_eq!(beside.rows, [4, 5]);
        assert_eq!(beside.alone, ["own [m] (this run)", "more [m] (the other)"]);
        let curve: Vec<(f64, f64)> = beside.curve(0).unwrap().collect();
        assert_eq!(curve, [(0.0, 1.0), (1.0, 2.0), (1.75, 9.0)]);
        assert!(beside.curve(2).is_none());
        let table = beside.table();
        assert!(
            table.contains("<td>pull [N]</td><td class=\"n\">-2</td><td class=\"n\">1</td><td class=\"n\">16.7 %</td>"),
            "{table}"
        );
    }

    #[test]
    fn what_cannot_be_compared_is_refused_by_name() {
        let (folder, path) = files("incomparable", "t [s],u [m]\n0,1\n", "t [s],u [m]\n0,1\n1,x\n");
        let refused = |path: &Path| Other::open(path, &folder, &columns()).unwrap_err();
        assert!(refused(&folder).contains("is what this run writes"));
        assert!(refused(&folder.join("nowhere")).contains("cannot read"));
        fs::write(folder.join("table.csv"), "spin [rad/s],u [m]\n0,1\n").unwrap();
        assert!(refused(&folder.join("table.csv")).contains("does not begin with `t [s]`"));
        fs::write(folder.join("table.csv"), "t [s],u [mm]\n0,1\n").unwrap();
        assert!(refused(&folder.join("table.csv")).ends_with("it has u [mm]"));
        let found = Other::open(&path, &folder, &columns()[..1]).unwrap();
        let wrong = found.beside(&folder.join(HISTORY), &columns()[..1]).unwrap_err();
        fs::remove_dir_all(&folder).unwrap();
        assert!(wrong.ends_with("line 3 is no row of its 2 columns"), "{wrong}");
    }
}
