//! All points of a plan in one table.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::Plan;
use crate::app::line::goal::GROWTH;
use crate::app::writing::csv::cell;
use crate::app::writing::entries::Summary;
use crate::app::writing::numbers::{digits, in_unit};
use crate::{AnyModel, ParamKind};

/// A column of results.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Head {
    /// The output's column or the mode: `tip.x`, `mode 1`.
    pub name: String,
    /// What of it: `last`, `min`, `max`, `im`, `re`.
    pub what: &'static str,
    pub unit: String,
}

impl Head {
    pub fn text(&self) -> String {
        format!("{} {} [{}]", self.name, self.what, self.unit)
    }
}

/// What is known of a point.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    pub point: usize,
    /// Values of the varied parameters, SI.
    pub params: Vec<f64>,
    /// One for each head, SI; `None` is what the point does not tell.
    pub values: Vec<Option<f64>>,
    pub failed: Option<String>,
    /// What this point has to say.
    pub notes: Vec<String>,
}

/// The points that are there, in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Table {
    pub heads: Vec<Head>,
    pub rows: Vec<Row>,
    /// Points without a file.
    pub missing: Vec<usize>,
}

type Found = Vec<(Head, Option<f64>)>;

/// The values in the record of a point.
fn values(record: &Summary, outputs: Option<&[usize]>) -> Found {
    let mut found = Vec::new();
    let list = |key: &str| record.get(key).and_then(Value::as_array).into_iter().flatten();
    for (index, output) in list("outputs").enumerate() {
        if outputs.is_some_and(|chosen| !chosen.contains(&index)) {
            continue;
        }
        let text = |key: &str| output[key].as_str().unwrap_or_default().to_owned();
        let name = text("name");
        let parts = [
            ("last", record.get("last").and_then(|last| last[name.as_str()].as_f64())),
            ("min", output["min"].as_f64()),
            ("max", output["max"].as_f64()),
        ];
        for (what, value) in parts {
            let (name, unit) = (name.clone(), text("unit"));
            found.push((Head { name, what, unit }, value));
        }
    }
    for (index, mode) in list("modes").enumerate() {
        for (what, unit) in [("im", "rad/s"), ("re", "1/s")] {
            let name = format!("mode {}", index + 1);
            let unit = unit.to_owned();
            let value = mode[format!("{what} [{unit}]").as_str()].as_f64();
            found.push((Head { name, what, unit }, value));
        }
    }
    if let Some(margin) = record.get("stability_margin") {
        let head = Head {
            name: GROWTH.into(),
            what: "max",
            unit: "1/s".into(),
        };
        // What meets no stiffness, as an angle or a sum of work, tells nothing of how the others die away.
        let moving = list("modes").filter_map(|mode| {
            let [re, im] = ["re [1/s]", "im [rad/s]"].map(|part| mode[part].as_f64());
            re.filter(|&re| re != 0.0 || im != Some(0.0))
        });
        found.push((head, moving.reduce(f64::max).or(margin.as_f64())));
    }
    found
}

impl Table {
    /// The table of the records that `read` finds; `outputs` are the columns of the history that count, all without it.
    pub fn gather(
        model: &dyn AnyModel,
        plan: &Plan,
        outputs: Option<&[usize]>,
        mut read: impl FnMut(usize) -> Option<Summary>,
    ) -> Self {
        let mut table = Table::default();
        for (point, params) in plan.points.iter().enumerate() {
            let Some(record) = read(point) else {
                table.missing.push(point);
                continue;
            };
            // Those of the model are the same at all points.
            let notes = record.get("notes").and_then(Value::as_array).into_iter().flatten();
            let notes = notes.skip(model.notes().len()).filter_map(Value::as_str);
            let mut row = Row {
                point,
                params: params.clone(),
                values: vec![None; table.heads.len()],
                failed: record.get("reason").and_then(Value::as_str).map(str::to_owned),
                notes: notes.map(str::to_owned).collect(),
            };
            for (head, value) in values(&record, outputs) {
                // What a point had where it failed is not what it has.
                let value = value.filter(|_| row.failed.is_none());
                let place = table.heads.iter().position(|known| *known == head);
                let place = place.unwrap_or_else(|| {
                    table.heads.push(head);
                    table.heads.len() - 1
                });
                row.values.resize(table.heads.len(), None);
                row.values[place] = value;
            }
            table.rows.push(row);
        }
        for row in &mut table.rows {
            row.values.resize(table.heads.len(), None);
        }
        table
    }

    /// Comma-separated text: parameters in their declared units, results in SI.
    pub fn to_csv(&self, model: &dyn AnyModel, plan: &Plan) -> String {
        let mut text = String::from("point");
        for one in &plan.varied {
            let _ = write!(text, ",{}", field(&param_head(model, one.param)));
        }
        for head in &self.heads {
            let _ = write!(text, ",{}", field(&head.text()));
        }
        text += ",failed,notes\n";
        for row in &self.rows {
            let _ = write!(text, "{}", row.point);
            for (one, value) in plan.varied.iter().zip(&row.params) {
                let param = &model.params()[one.param];
                let shown = match param.kind {
                    ParamKind::Table(_) => field(&in_unit(param, *value)),
                    _ => digits(value / param.unit_si, 15),
                };
                let _ = write!(text, ",{shown}");
            }
            for value in &row.values {
                text.push(',');
                text.push_str(&cell(*value));
            }
            let failed = row.failed.as_deref().unwrap_or("");
            let _ = writeln!(text, ",{},{}", field(failed), field(&row.notes.join(" | ")));
        }
        text
    }

    /// The points that failed.
    pub fn failed(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.failed.is_some())
    }

    /// The values of a column at the points that did not fail.
    pub fn column(&self, index: usize) -> impl Iterator<Item = (&Row, f64)> {
        let sound = self.rows.iter().filter(|row| row.failed.is_none());
        sound.filter_map(move |row| Some((row, row.values[index]?)))
    }

    /// Mean, standard deviation and percentiles of every column, for points that are drawn.
    pub fn statistics(&self) -> Value {
        let one = |(index, head): (usize, &Head)| {
            let mut values: Vec<f64> = self.column(index).map(|(_, value)| value).collect();
            values.sort_by(f64::total_cmp);
            let spread = Spread::of(&values)?;
            let mut entry = Map::new();
            entry.insert("name".into(), json!(head.name));
            entry.insert("what".into(), json!(head.what));
            entry.insert("unit".into(), json!(head.unit));
            entry.insert("mean".into(), json!(spread.mean));
            entry.insert("deviation".into(), json!(spread.deviation));
            for (key, value) in ["p05", "p50", "p95"].iter().zip(spread.percentiles) {
                entry.insert((*key).into(), json!(value));
            }
            Some(Value::Object(entry))
        };
        self.heads.iter().enumerate().filter_map(one).collect()
    }
}

/// Statistics of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spread {
    pub mean: f64,
    /// Of the sample, with n - 1.
    pub deviation: f64,
    /// 5, 50 and 95 per cent lie below them.
    pub percentiles: [f64; 3],
}

impl Spread {
    /// Of two or more ascending values.
    pub fn of(values: &[f64]) -> Option<Self> {
        let count = values.len();
        if count < 2 {
            return None;
        }
        let mean = values.iter().sum::<f64>() / count as f64;
        let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        let percentile = |part: f64| {
            let place = part * (count - 1) as f64;
            let low = place.floor() as usize;
            let high = (low + 1).min(count - 1);
            values[low] + (place - low as f64) * (values[high] - values[low])
        };
        Some(Self {
            mean,
            deviation: (square / (count - 1) as f64).sqrt(),
            percentiles: [0.05, 0.5, 0.95].map(percentile),
        })
    }
}

/// Name and unit of a parameter.
pub(super) fn param_head(model: &dyn AnyModel, param: usize) -> String {
    let param = &model.params()[param];
    match (param.kind, param.unit) {
        (ParamKind::Table(_), _) => param.name.to_owned(),
        (ParamKind::Count, _) | (_, "") => format!("{} [1]", param.name),
        (_, unit) => format!("{} [{unit}]", param.name),
    }
}

/// A field of comma-separated text, in quotes where it needs them (RFC 4180); one line.
fn field(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    if text.contains([',', '"']) {
        return format!("\"{}\"", text.replace('"', "\"\""));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_with_commas_and_quotes_are_quoted() {
        assert_eq!(field("plain"), "plain");
        assert_eq!(field("a, \"b\"\nc"), "\"a, \"\"b\"\" c\"");
    }

    #[test]
    fn the_spread_of_a_sample_is_that_of_the_textbook() {
        let spread = Spread::of(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]).unwrap();
        assert_eq!((spread.mean, spread.percentiles[1]), (5.0, 4.5));
        assert!((spread.deviation - (32.0_f64 / 7.0).sqrt()).abs() < 1e-15);
        assert!((spread.percentiles[0] - 2.7).abs() < 1e-12);
        assert_eq!(Spread::of(&[1.0]), None);
    }

    /// An angle that nothing holds, or a sum of work, has s = 0 at every point: the others count.
    #[test]
    fn growth_is_that_of_what_dies_away() {
        let of = |modes: Value| {
            let record = serde_json::json!({ "modes": modes, "stability_margin": 0.0 });
            let found = values(record.as_object().unwrap(), None);
            found.into_iter().find(|(head, _)| head.name == GROWTH).unwrap().1
        };
        let mode = |re: f64, im: f64| serde_json::json!({ "re [1/s]": re, "im [rad/s]": im });
        assert_eq!(
            of(Value::from(vec![mode(0.0, 0.0), mode(-1.5, 3.0), mode(-2.0, 0.0)])),
            Some(-1.5)
        );
        assert_eq!(of(Value::from(vec![mode(0.0, 2.0), mode(-1.5, 3.0)])), Some(0.0));
        assert_eq!(of(Value::from(vec![mode(0.0, 0.0)])), Some(0.0));
    }
}
