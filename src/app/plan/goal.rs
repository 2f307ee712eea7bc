//! What `optimise` looks for: the least or largest value of a result, or results that come near given values.

use clap::ArgMatches;

use super::table::{Head, Row, Table};
use crate::AnyModel;
use crate::app::arguments::text;
use crate::app::chart::flags::column_names;
use crate::app::command::Command;
use crate::app::parameters::{digits, in_unit_of};
use crate::nearest::nearest;

/// The flags of which one says what is looked for.
const FLAGS: [&str; 3] = ["minimise", "maximise", "fit"];

/// A column of the table of results: of runs and equilibria `v min`, of modes `mode 1 im`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sought {
    name: String,
    what: &'static str,
    unit: String,
}

/// What is looked for.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Goal(pub(super) Aim);

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Aim {
    Least(Sought),
    Most(Sought),
    /// Results with the values that they are to have, in their units.
    Fit(Vec<(Sought, f64)>),
}

impl Sought {
    /// Reads `v min`, `tip.x`, `mode 1 re`.
    fn read(model: &dyn AnyModel, of: Command, given: &str) -> Result<Self, String> {
        let (head, word) = given.rsplit_once(char::is_whitespace).unwrap_or((given, ""));
        let whats: &[&'static str] = match of {
            Command::Modes => &["im", "re"],
            _ => &["last", "min", "max"],
        };
        let (name, what) = match whats.iter().find(|what| **what == word) {
            Some(what) => (head.trim(), *what),
            None => (given.trim(), whats[0]),
        };
        if of == Command::Modes {
            let number = name
                .strip_prefix("mode ")
                .and_then(|number| number.trim().parse::<usize>().ok());
            let number = number.filter(|number| *number > 0).ok_or_else(|| {
                format!(
                    "`{given}` is no result of modes: write `mode 1 im` (angular frequency) or `mode 1 re` (growth)"
                )
            })?;
            let unit = if what == "im" { "rad/s" } else { "1/s" };
            return Ok(Self {
                name: format!("mode {number}"),
                what,
                unit: unit.into(),
            });
        }
        let columns = column_names(model.outputs());
        let Some((output, _)) = columns.iter().find(|(_, column)| column == name) else {
            let known: Vec<&str> = columns.iter().map(|(_, column)| column.as_str()).collect();
            let right = match nearest(name, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!(
                    "there are {}; behind the name stands last, min or max",
                    known.join(", ")
                ),
            };
            return Err(format!("there is no result `{name}`, {right}"));
        };
        let unit = model.outputs().iter().find(|known| known.name == *output);
        Ok(Self {
            name: name.into(),
            what,
            unit: unit.map_or("", |output| output.unit).into(),
        })
    }

    fn is(&self, head: &Head) -> bool {
        head.name == self.name && head.what == self.what
    }

    fn words(&self) -> String {
        format!("{} {}", self.name, self.what)
    }

    /// The value with its unit.
    fn shown(&self, value: f64) -> String {
        match self.unit.as_str() {
            "" | "1" => digits(value, 7),
            unit => format!("{} {unit}", digits(value, 7)),
        }
    }

    fn of(&self, table: &Table, row: &Row) -> Option<f64> {
        let place = table.heads.iter().position(|head| self.is(head))?;
        row.values.get(place).copied().flatten()
    }
}

impl Goal {
    /// Reads the flags; `None` without them.
    ///
    /// # Errors
    /// The flag and what would be right.
    pub fn read(model: &dyn AnyModel, matches: &ArgMatches, of: Command) -> Result<Option<Self>, String> {
        let given: Vec<(&str, &str)> = FLAGS
            .iter()
            .filter_map(|flag| Some((*flag, text(matches, flag)?)))
            .collect();
        let (flag, given) = match given[..] {
            [] => return Ok(None),
            [one] => one,
            [(first, _), (second, _), ..] => {
                return Err(format!("`--{first}` and `--{second}` are two aims: give one of them"));
            }
        };
        let told = |mistake: String| format!("`--{flag} \"{given}\"`: {mistake}");
        let sought = |given: &str| Sought::read(model, of, given).map_err(told);
        Ok(Some(Goal(match flag {
            "minimise" => Aim::Least(sought(given)?),
            "maximise" => Aim::Most(sought(given)?),
            _ => Aim::Fit(
                given
                    .split(',')
                    .map(|part| {
                        let form = || told("write `result=value`, e.g. `--fit \"tip.x max=3 m\"`".into());
                        let (name, value) = part.split_once('=').ok_or_else(form)?;
                        let sought = sought(name.trim())?;
                        let value = in_unit_of(value.trim(), &sought.unit).map_err(told)?;
                        Ok((sought, value))
                    })
                    .collect::<Result<_, String>>()?,
            ),
        })))
    }

    /// What the search makes small at a point; `None` where the point has not all results.
    pub(super) fn height(&self, table: &Table, row: &Row) -> Option<f64> {
        if row.failed.is_some() {
            return None;
        }
        let height = match &self.0 {
            Aim::Least(sought) => sought.of(table, row)?,
            Aim::Most(sought) => -sought.of(table, row)?,
            Aim::Fit(wanted) => {
                let mut sum = 0.0;
                for (sought, value) in wanted {
                    let scale = if *value == 0.0 { 1.0 } else { *value };
                    sum += ((sought.of(table, row)? - value) / scale).powi(2);
                }
                sum
            }
        };
        Some(height)
    }

    /// What is looked for, in words.
    pub(super) fn words(&self) -> String {
        match &self.0 {
            Aim::Least(sought) => format!("the least `{}`", sought.words()),
            Aim::Most(sought) => format!("the largest `{}`", sought.words()),
            Aim::Fit(wanted) => {
                let one = |(sought, value): &(Sought, f64)| format!("`{}` = {}", sought.words(), sought.shown(*value));
                wanted.iter().map(one).collect::<Vec<_>>().join(", ")
            }
        }
    }

    /// Name and unit of the result on an axis.
    pub(super) fn axis(&self) -> String {
        match &self.0 {
            Aim::Least(sought) | Aim::Most(sought) => format!("{} [{}]", sought.words(), sought.unit),
            Aim::Fit(_) => self.words(),
        }
    }

    /// What a point has of it, in words.
    pub(super) fn found(&self, table: &Table, row: &Row) -> String {
        let one = |sought: &Sought| {
            let value = sought
                .of(table, row)
                .map_or("nothing".into(), |value| sought.shown(value));
            format!("`{}` = {value}", sought.words())
        };
        match &self.0 {
            Aim::Least(sought) | Aim::Most(sought) => one(sought),
            Aim::Fit(wanted) => {
                let all: Vec<_> = wanted.iter().map(|(sought, _)| one(sought)).collect();
                all.join(", ")
            }
        }
    }

    /// A result that no point has, if there is one.
    pub(super) fn lacking(&self, table: &Table) -> Option<String> {
        let sought: Vec<&Sought> = match &self.0 {
            Aim::Least(sought) | Aim::Most(sought) => vec![sought],
            Aim::Fit(wanted) => wanted.iter().map(|(sought, _)| sought).collect(),
        };
        let missing = sought
            .into_iter()
            .find(|sought| !table.heads.iter().any(|head| sought.is(head)));
        missing.map(Sought::words)
    }
}
