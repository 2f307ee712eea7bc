//! How near the results of a point come to what `optimise` looks for, and how that is told.

use super::table::{Head, Row, Table};
use crate::app::line::goal::{Aim, Goal, Sought};
use crate::app::writing::numbers::digits;

/// Part of a wanted value by which a result may differ from it.
const MISSED: f64 = 0.01;

/// How far a result is from a wanted value, as a part of that where it is not zero.
fn part_off(found: f64, wanted: f64) -> f64 {
    let scale = if wanted == 0.0 { 1.0 } else { wanted };
    (found - wanted) / scale
}

impl Sought {
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
                    sum += part_off(sought.of(table, row)?, *value).powi(2);
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

    /// What is wanted and no point has, in sentences.
    pub(super) fn missed(&self, table: &Table, best: &Row) -> Vec<String> {
        let Aim::Fit(wanted) = &self.0 else {
            return Vec::new();
        };
        let missed = wanted.iter().filter_map(|(sought, value)| {
            let found = sought.of(table, best)?;
            (part_off(found, *value).abs() > MISSED).then(|| {
                format!(
                    "`{}` is {} at the best point, and not {}: no point of the ranges that were searched has all that is wanted",
                    sought.words(),
                    sought.shown(found),
                    sought.shown(*value)
                )
            })
        });
        missed.collect()
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
