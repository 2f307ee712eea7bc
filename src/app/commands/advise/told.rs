//! What was found, in words, as a table, and for the files.

use std::fmt::Write;

use serde_json::{Value, json};

use super::ladder::{Choices, Setting};
use super::picture;
use super::search::{Found, Outcome, Rung};
use super::work::TIGHTEST;
use crate::AnyModel;
use crate::app::machine::clock::Seconds;
use crate::app::page::summary::{self, described};
use crate::app::results::run::RunSettings;
use crate::app::writing::entries::{Summary, put};
use crate::app::writing::html::escape;
use crate::app::writing::numbers::{digits, time};
use crate::model::Fidelity;

/// The result of a search, ready to be told.
pub(super) struct Advice<'a> {
    pub model: &'a dyn AnyModel,
    /// With times and tolerance filled in.
    pub settings: &'a RunSettings,
    pub choices: &'a Choices,
    pub found: &'a Found,
    pub wanted: f64,
    /// Tolerance of all runs.
    pub rtol: f64,
    /// Error that the integration in time makes of the outputs.
    pub time_error: f64,
    pub seconds: Seconds,
    /// Warnings of the model as declared.
    pub warnings: &'a [String],
}

/// Part of the time of the simplest rung from which on a faster one is told.
const FASTER: f64 = 0.8;

/// An error for people: `2e-5`.
pub(super) fn size(error: f64) -> String {
    if error == 0.0 {
        "0".into()
    } else {
        format!("{error:.0e}")
    }
}

fn sizes(error: Option<f64>) -> String {
    error.map_or_else(String::new, size)
}

impl Advice<'_> {
    fn named(&self) -> Option<&Rung> {
        self.found.named.map(|named| &self.found.rungs[named])
    }

    /// Columns of the table, and one row for each rung.
    fn rows(&self) -> Vec<[String; 8]> {
        let head = ["rung", "unknowns", "steps", "time", "error", "next", "second", ""].map(String::from);
        let row = |(index, rung): (usize, &Rung)| {
            let [unknowns, steps, cpu] = match rung.trial() {
                Some(trial) => [trial.unknowns.to_string(), trial.steps.to_string(), time(trial.cpu)],
                None => Default::default(),
            };
            let next = rung.estimate.map(|estimate| estimate.next).unwrap_or_default();
            let error = sizes(self.found.error(index));
            [
                rung.name.clone(),
                unknowns,
                steps,
                cpu,
                error,
                sizes(next[0]),
                sizes(next[1]),
                self.remark(index),
            ]
        };
        std::iter::once(head)
            .chain(self.found.rungs.iter().enumerate().map(row))
            .collect()
    }

    /// What is to be said of a rung.
    fn remark(&self, index: usize) -> String {
        let (found, rung) = (self.found, &self.found.rungs[index]);
        let mut words = Vec::new();
        match &rung.outcome {
            Outcome::Impossible(reason) => words.push(format!("impossible: {reason}")),
            _ if found.named == Some(index) => words.push("suffices, the simplest".into()),
            _ if rung.suffices => words.push("suffices".into()),
            _ => {}
        }
        if found.declared == Some(index) {
            words.push("as declared".into());
        }
        if found.richest == Some(index) {
            words.push("counts as exact up to its error".into());
        }
        let count = rung.trial().map_or(0, |trial| trial.warnings.len());
        if count > 0 {
            words.push(if count == 1 {
                "1 warning".into()
            } else {
                format!("{count} warnings")
            });
        }
        words.join("; ")
    }

    /// Table, sentences and warnings for standard output.
    pub fn text(&self) -> String {
        let mut text = format!(
            "{}: {} rungs at rtol {:e}, {} s\n",
            self.model.name(),
            self.found.rungs.len(),
            self.rtol,
            digits(self.seconds.cpu, 3)
        );
        let rows = self.rows();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..7).map(width).collect();
        for row in &rows {
            let mut line = format!("  {:w$}", row[0], w = widths[0]);
            for column in 1..7 {
                let _ = write!(line, "  {:>w$}", row[column], w = widths[column]);
            }
            let _ = write!(line, "  {}", row[7]);
            text += line.trim_end();
            text.push('\n');
        }
        for line in self.sentences() {
            text += &line;
            text.push('\n');
        }
        for note in self.notes() {
            let _ = writeln!(text, "note: {note}");
        }
        text.trim_end().into()
    }

    /// The advice, or why there is none.
    pub fn sentences(&self) -> Vec<String> {
        let Some((index, rung, trial)) = self.found.named.and_then(|index| {
            let rung = &self.found.rungs[index];
            Some((index, rung, rung.trial()?))
        }) else {
            return vec![self.nothing()];
        };
        let error = size(self.found.error(index).unwrap_or_default());
        let mut sentence = format!(
            "{} for {:e} (error about {error}, {}",
            self.descriptions(&rung.setting),
            self.wanted,
            time(trial.cpu)
        );
        let declared = self.found.declared.filter(|declared| *declared != index);
        let declared = declared.and_then(|declared| self.found.rungs[declared].trial());
        match declared {
            Some(declared) => {
                let _ = write!(sentence, "); as declared: {}.", time(declared.cpu));
            }
            None if self.found.declared == Some(index) => sentence += "), as declared.",
            None => sentence += ").",
        }
        let mut lines = vec![sentence];
        lines.extend(self.changes(&rung.setting));
        lines.extend(self.faster(index));
        lines.extend(trial.warnings.iter().map(|warning| format!("It warns: {warning}")));
        lines
    }

    /// `` `rod`: rigid suffices``, with the mesh where it counts.
    fn descriptions(&self, setting: &Setting) -> String {
        let kinds: Vec<Fidelity> = setting.fidelity.iter().map(|(_, fidelity)| *fidelity).collect();
        let counts = || {
            let counts = setting
                .counts
                .iter()
                .map(|&(param, value)| format!("{} = {value}", self.model.params()[param].name));
            counts.collect::<Vec<_>>().join(", ")
        };
        let has_mesh = self.choices.meshes.len() > 1;
        let word = |fidelity: Fidelity| match fidelity {
            Fidelity::Full => "all nodal vectors".to_string(),
            other => other.to_string(),
        };
        let mut text = match &setting.fidelity[..] {
            [] => return format!("{} suffices", counts()),
            [(name, fidelity)] => format!("`{name}`: {} suffices", word(*fidelity)),
            [(_, first), ..] if kinds.iter().all(|kind| kind == first) => {
                let names: Vec<String> = setting.fidelity.iter().map(|(name, _)| format!("`{name}`")).collect();
                format!("{}: {} suffices", names.join(", "), word(*first))
            }
            all => {
                let each: Vec<String> = all
                    .iter()
                    .map(|(name, how)| format!("`{name}`: {}", word(*how)))
                    .collect();
                format!("{} suffice", each.join(", "))
            }
        };
        if has_mesh && self.choices.deforms(setting) {
            let _ = write!(text, " with {}", counts());
        }
        text
    }

    /// The fastest rung that suffices, where it is not the simplest one.
    fn faster(&self, named: usize) -> Option<String> {
        let cpu = |rung: &Rung| rung.trial().map_or(f64::INFINITY, |trial| trial.cpu);
        let all = self.found.rungs.iter().filter(|rung| rung.suffices);
        let fastest = all.min_by(|a, b| cpu(a).total_cmp(&cpu(b)))?;
        (cpu(fastest) < FASTER * cpu(&self.found.rungs[named])).then(|| {
            format!(
                "It is the simplest; the fastest is `{}` with {}.",
                fastest.name,
                time(cpu(fastest))
            )
        })
    }

    /// What to write into the model for a setting, and how to try it; nothing where it is as declared.
    fn changes(&self, setting: &Setting) -> Vec<String> {
        let declared = self.choices.as_declared();
        if *setting == declared {
            return Vec::new();
        }
        let mut parts = Vec::new();
        let pairs = setting.fidelity.iter().zip(&declared.fidelity);
        let changed: Vec<_> = pairs.filter(|(new, old)| new != old).collect();
        for ((name, new), (_, old)) in &changed {
            parts.push(match (new, old) {
                (Fidelity::Full, old) => format!("`{name}` without `{old};`"),
                (new, Fidelity::Full) => format!("`body {name} .. {{ .. {new}; }}`"),
                (new, old) => format!("`{new};` instead of `{old};` in `body {name}`"),
            });
        }
        // The mesh of what does not deform does not matter.
        let counts = setting.counts.iter().zip(&declared.counts);
        let counts = counts.filter(|(new, old)| new != old && self.choices.deforms(setting));
        let counts: Vec<_> = counts.map(|(new, _)| *new).collect();
        for &(param, value) in &counts {
            parts.push(format!("`param {}: count = {value};`", self.model.params()[param].name));
        }
        if parts.is_empty() {
            return Vec::new();
        }
        let mut words = vec!["run".to_string()];
        words.extend(
            counts
                .iter()
                .map(|&(param, value)| format!("{}={value}", self.model.params()[param].name)),
        );
        if !changed.is_empty() {
            let changed: Vec<_> = changed.iter().map(|(new, _)| (*new).clone()).collect();
            words.push(format!("--fidelity \"{}\"", described(&changed)));
        }
        vec![format!(
            "In the model: {}; to try it: `{}`.",
            parts.join(", "),
            words.join(" ")
        )]
    }

    /// Why no rung suffices, and what to do.
    fn nothing(&self) -> String {
        let (found, wanted) = (self.found, self.wanted);
        let Some(richest) = found.richest else {
            return "No rung of the ladder ran: the table says why.".into();
        };
        let name = &found.rungs[richest].name;
        if found.is_interrupted {
            return "The ladder is not complete: no advice.".into();
        }
        let finer = |what: &str| match self.choices.meshes.last().map(|mesh| &mesh[..]) {
            Some([(param, value), ..]) => {
                let param = self.model.params()[*param].name;
                format!(
                    "{what} finer meshes, e.g. `{param}={value},{},{}`",
                    2.0 * value,
                    4.0 * value
                )
            }
            _ => format!("{what} a param that counts the elements of its bodies"),
        };
        let is_limited = |rung: &Rung| matches!(&rung.outcome, Outcome::Impossible(why) if why.contains("--limit"));
        let limited = if found.rungs.iter().any(is_limited) {
            ", with more time for each run (`--limit`)"
        } else {
            ""
        };
        match found.remaining {
            Some(remaining) if remaining > wanted => format!(
                "Nothing on the ladder is known to reach {wanted:e}: with the finest mesh (`{name}`) an error of about {} is left. Give {}{limited}, or ask for no less than {}.",
                size(remaining),
                finer(""),
                size(2.0 * remaining)
            ),
            _ => format!(
                "Nothing on the ladder agrees to {wanted:e} with the two rungs above it and the richest (`{name}`). Give {}{limited}, or ask for less.",
                finer("")
            ),
        }
        .replace("Give  ", "Give ")
    }

    /// What is not questioned, and how well the integration in time serves.
    fn notes(&self) -> Vec<String> {
        let mut notes = self.choices.notes.clone();
        if self.time_error > 0.5 * self.wanted {
            let help = if self.rtol > 2.0 * TIGHTEST {
                "give a tighter `--rtol`"
            } else {
                "round-off is near, ask for less, or for outputs that change more"
            };
            notes.push(format!(
                "The integration in time makes an error of about {} at rtol {:e}: {help}.",
                size(self.time_error),
                self.rtol
            ));
        }
        notes.extend(self.warnings.iter().map(|warning| format!("As declared: {warning}")));
        let named = self.named().map(|rung| &rung.name);
        for rung in self.found.rungs.iter().filter(|rung| Some(&rung.name) != named) {
            for warning in rung.trial().into_iter().flat_map(|trial| &trial.warnings) {
                notes.push(format!("{}: {warning}", rung.name));
            }
        }
        notes
    }

    /// The rungs as comma-separated text; errors are relative to the largest change of the output.
    pub fn csv(&self) -> String {
        let richest = self.found.richest.and_then(|richest| self.found.rungs[richest].trial());
        let columns = richest.map_or(&[][..], |trial| &trial.history.columns[..]);
        let mut text = "rung,fidelity,mesh,unknowns,steps,cpu_s,error,to_next,to_second,to_richest,suffices,named,as_declared,reason".to_string();
        for &index in &self.found.chosen {
            let _ = write!(text, ",error {}", columns[index].name);
        }
        text.push('\n');
        let exact = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:.6e}"));
        for (index, rung) in self.found.rungs.iter().enumerate() {
            let (trial, estimate) = (rung.trial(), rung.estimate);
            let counts = rung.setting.counts.iter();
            let counts: Vec<String> = counts
                .map(|&(p, value)| format!("{}={value}", self.model.params()[p].name))
                .collect();
            let reason = match &rung.outcome {
                Outcome::Impossible(reason) => reason.as_str(),
                _ => "",
            };
            let next = estimate.map(|estimate| estimate.next).unwrap_or_default();
            let mut cells = vec![
                quoted(&rung.name),
                quoted(&described(&rung.setting.fidelity)),
                quoted(&counts.join(" ")),
                trial.map_or_else(String::new, |trial| trial.unknowns.to_string()),
                trial.map_or_else(String::new, |trial| trial.steps.to_string()),
                exact(trial.map(|trial| trial.cpu)),
                exact(self.found.error(index)),
                exact(next[0]),
                exact(next[1]),
                exact(estimate.map(|estimate| estimate.richest)),
                rung.suffices.to_string(),
                (self.found.named == Some(index)).to_string(),
                (self.found.declared == Some(index)).to_string(),
                quoted(reason),
            ];
            let errors = trial
                .zip(richest)
                .map(|(trial, richest)| crate::app::commands::chart::errors::errors(&trial.history, &richest.history));
            for &column in &self.found.chosen {
                let relative = errors
                    .as_ref()
                    .map(|errors| errors[column].max / self.found.scales[column]);
                cells.push(exact(relative));
            }
            text += &cells.join(",");
            text.push('\n');
        }
        text
    }

    /// The summary for the files.
    pub fn summary(&self) -> Summary {
        let mut summary = summary::head(self.model, "advise");
        let reason = self.found.is_interrupted.then(|| "interrupted by the user".to_owned());
        summary::outcome(&mut summary, reason);
        summary::settings(&mut summary, self.settings);
        put(&mut summary, "wanted", json!(self.wanted));
        put(&mut summary, "time_error", json!(self.time_error));
        put(&mut summary, "remaining_error", json!(self.found.remaining));
        put(&mut summary, "advice", json!(self.sentences()));
        put(
            &mut summary,
            "named",
            self.named().map_or(Value::Null, |rung| json!(rung.name)),
        );
        let rungs = self.found.rungs.iter().enumerate().map(|(index, rung)| {
            let trial = rung.trial();
            json!({
                "rung": rung.name,
                "fidelity": described(&rung.setting.fidelity),
                "unknowns": trial.map(|trial| trial.unknowns),
                "steps": trial.map(|trial| trial.steps),
                "cpu_seconds": trial.map(|trial| trial.cpu),
                "error": self.found.error(index),
                "suffices": rung.suffices,
                "remark": self.remark(index),
                "warnings": trial.map(|trial| trial.warnings.clone()),
            })
        });
        put(&mut summary, "rungs", rungs.collect());
        summary::seconds(&mut summary, self.seconds);
        put(&mut summary, "notes", summary::notes(self.model, &self.notes()));
        summary
    }

    /// Chart and table for the report.
    pub fn page(&self) -> String {
        let mut page = String::new();
        for line in self.sentences() {
            let _ = writeln!(page, "<p>{}</p>", escape(&line));
        }
        let _ = write!(
            page,
            "<figure>\n<figcaption>Error over processor time<span>relative to the largest change of an output; the line is \
             what is wanted</span></figcaption>\n{}\n</figure>\n",
            picture::svg(&self.dots(), self.wanted)
        );
        page += "<div class=\"scroll\"><table>\n";
        for (index, row) in self.rows().iter().enumerate() {
            let tag = if index == 0 { "th" } else { "td" };
            page += "<tr>";
            for (column, cell) in row.iter().enumerate() {
                let class = if (1..7).contains(&column) { " class=\"n\"" } else { "" };
                let _ = write!(page, "<{tag}{class}>{}</{tag}>", escape(cell));
            }
            page += "</tr>\n";
        }
        page += "</table></div>\n<p class=\"doc\">error: difference from the richest rung, with that rung's own error by its mesh; next, second: \
                 differences from the two next richer rungs. A rung suffices where all three are small enough.</p>\n";
        page
    }

    fn dots(&self) -> Vec<picture::Dot> {
        let dot = |(index, rung): (usize, &Rung)| {
            Some(picture::Dot {
                cost: rung.trial()?.cpu,
                error: self.found.error(index)?,
                label: rung.name.clone(),
                look: match (self.found.named == Some(index), rung.suffices) {
                    (true, _) => picture::Look::Named,
                    (false, true) => picture::Look::Suffices,
                    (false, false) => picture::Look::Fails,
                },
                is_warned: rung.trial().is_some_and(|trial| !trial.warnings.is_empty()),
            })
        };
        self.found.rungs.iter().enumerate().filter_map(dot).collect()
    }
}

/// A cell of a comma-separated table.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}
