//! What `optimise` looks for: the least or largest value of a result, or results that come near given values.

use clap::ArgMatches;

use super::chart::column_names;
use super::command::Command;
use super::parameters::in_unit_of;
use super::words::text;
use crate::AnyModel;
use crate::nearest::nearest;

/// The flags of which one says what is looked for.
const FLAGS: [&str; 3] = ["minimise", "maximise", "fit"];

/// The largest rate of growth of the modes of a point, whichever mode has it.
pub(in crate::app) const GROWTH: &str = "growth";

/// A column of the table of results: of runs and equilibria `v min`, of modes `mode 1 im`.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Sought {
    pub name: String,
    pub what: &'static str,
    pub unit: String,
}

/// What is looked for.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Goal(pub(in crate::app) Aim);

#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) enum Aim {
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
            Command::Modes if given.starts_with(GROWTH) => &["max"],
            Command::Modes => &["im", "re"],
            _ => &["last", "min", "max"],
        };
        let (name, what) = match whats.iter().find(|what| **what == word) {
            Some(what) => (head.trim(), *what),
            None => (given.trim(), whats[0]),
        };
        if of == Command::Modes && name == GROWTH {
            return Ok(Self {
                name: GROWTH.into(),
                what: "max",
                unit: "1/s".into(),
            });
        }
        if of == Command::Modes {
            let number = name
                .strip_prefix("mode ")
                .and_then(|number| number.trim().parse::<usize>().ok());
            let number = number.filter(|number| *number > 0).ok_or_else(|| {
                format!(
                    "`{given}` is no result of modes: write `mode 1 im` (angular frequency), `mode 1 re` (its growth) or `growth` (the largest of all modes)"
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
}
