//! Rows of two runs in one output, as a whole and in each component of a vector: how far they are apart, and what of.

use std::f64::consts::TAU;

use crate::Output;
use crate::model::Operands;

/// Part of the largest change of an output from which on its error is told.
pub(in crate::app) const TOLD: f64 = 0.01;

/// Least change that counts, in tolerances and at most: of the largest value of an output, and where nothing says that it is there, of what it is made of.
/// Less is what a motion leaves where nothing moves, or a number that should not change.
const KEPT: f64 = 1e3;
const SMALL: f64 = 1e-3;
/// Most part of the forces that it balances below which one is nothing that two runs do not find alike; less where the root of the tolerance, as which forces
/// are known, is.
const BALANCED: f64 = 0.1;
/// Part of its value by which a number changes that is told as one which should not.
const CONSTANT: f64 = 0.01;
/// Part of the tolerance, of what an output is made of, below which it is nothing.
pub(super) const NOTHING: f64 = 1e-3;
/// Part of what an output is made of that may be the same noise in two runs, and what this is at most in its round-off.
const LEAST: f64 = 1e-10;
const FEW: f64 = 3.0;
/// Part by which runs are apart, until they have changed by as large a part of what they do at all, that leaves no doubt that there is something.
const EARLY: f64 = 0.1;
/// Relative error of a state that many steps leave.
pub(super) const ROUND_OFF: f64 = 1e-13;
/// Part of its value by which a number changes that does not.
const STILL: f64 = 1e-9;
/// Part beyond which both are different motions.
pub(super) const WRONG: f64 = 0.5;
/// What a component of a vector is made of, in largest values of the vector: errors of the others turn into it, those of forces by the root of the tolerance.
const OTHERS: f64 = 10.0;
/// A component is told in the place of its vector where its part is larger by this factor.
const APART: f64 = 3.0;

/// How far an output is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) struct Off {
    pub output: usize,
    /// The component that is off by much more than the vector.
    pub component: Option<usize>,
    /// As part of its largest change or value, whichever is less,
    pub part: f64,
    /// or of this, in its unit, where both are nothing.
    pub nothing: Option<f64>,
    /// Whether it may be there for all that the tolerance tells, and be off by much of its change.
    pub is_open: bool,
}

impl Off {
    /// The output and its part, unless that is little of what the output is made of: it says nothing of its change then.
    pub fn known(&self) -> Option<(usize, f64)> {
        (self.nothing.is_none() || self.part > TOLD).then_some((self.output, self.part))
    }

    /// As it is written: `tip`, `tip.x`.
    pub fn name(&self, outputs: &[Output]) -> String {
        let output = &outputs[self.output];
        match self.component {
            Some(component) => format!("{}.{}", output.name, output.components[component]),
            None => output.name.to_string(),
        }
    }
}

/// Rows of two runs in one output, or in one component of a vector.
#[derive(Clone, Copy)]
pub(super) struct Compared {
    pub output: usize,
    pub component: Option<usize>,
    /// Their largest distance.
    pub away: f64,
    /// Largest change or value, whichever is less, of all rows of the run; largest value.
    pub size: f64,
    pub value: f64,
    /// The same size of both runs as far as both go.
    pub sizes: [f64; 2],
    pub operands: f64,
    pub round_off: f64,
    /// Forces that it balances, if it is a reaction or what a section carries.
    pub balanced: f64,
    /// Whether both are near each other at first, however far apart they are later.
    pub begins_alike: bool,
}

impl Compared {
    /// Two runs with different steps agree that there is something: it is no error of steps.
    pub fn agrees(&self) -> bool {
        let size = self.sizes[0].min(self.sizes[1]);
        size > noise(self.operands, self.round_off) && (self.away <= WRONG * size || self.begins_alike)
    }

    /// The size by which a distance is measured, of an output that is known to be there or not.
    pub fn measure(&self, is_known: bool, rtol: f64) -> f64 {
        let least = (KEPT * rtol).min(SMALL);
        let balanced = (rtol.sqrt() / TOLD).min(BALANCED) * self.balanced;
        let nothing = if is_known {
            0.0
        } else {
            balanced.max(least * self.operands)
        };
        self.size.max(least * self.value).max(nothing).max(self.round_off)
    }

    pub fn off(&self, is_known: bool, rtol: f64) -> Off {
        // What is known to a small part of its change has one, however small.
        let changes = self.away <= TOLD * self.size && self.size > noise(self.operands, self.round_off);
        let measure = if changes {
            self.size
        } else {
            self.measure(is_known, rtol)
        };
        let part = self.away / measure;
        // Of a number that hardly changes, and by no more than it is off, parts of its change say nothing.
        let is_constant = part > WRONG && self.size < CONSTANT * self.value;
        let is_open = measure > self.size
            && self.away > TOLD * self.size
            && self.away > (NOTHING * rtol * self.operands).max(self.round_off);
        Off {
            output: self.output,
            component: self.component,
            part,
            nothing: Some(measure).filter(|measure| *measure > self.size || is_constant),
            // Of a vector that is there, a component may be nothing.
            is_open: is_open && self.component.is_none(),
        }
    }
}

/// Rows of a run, and what round-off makes of its outputs and what they are made of, by columns.
#[derive(Clone, Copy)]
pub(super) struct Run<'r> {
    pub rows: &'r [(f64, Vec<f64>)],
    pub round_off: &'r [f64],
    pub operands: &'r [Operands],
}

/// Size up to which an output may be noise.
fn noise(operands: f64, round_off: f64) -> f64 {
    match LEAST * operands {
        least if round_off > 0.0 => least.min(FEW * round_off),
        least => least,
    }
}

/// How many there are to compare.
pub(super) fn count(outputs: &[Output]) -> usize {
    outputs.iter().map(|output| 1 + output.components.len()).sum()
}

/// All outputs of a run in two others, each before its components.
pub(super) fn compared(
    run: Run<'_>,
    outputs: &[Output],
    here: &[(f64, Vec<f64>)],
    there: &[Vec<f64>],
) -> Vec<Compared> {
    let Some((_, begin)) = run.rows.first() else {
        return Vec::new();
    };
    let mut first = 0;
    let mut all = Vec::with_capacity(count(outputs));
    for (index, output) in outputs.iter().enumerate() {
        let columns = first..first + output.width();
        first = columns.end;
        let of = |component: Option<usize>| {
            let columns = component.map_or(columns.clone(), |at| columns.start + at..columns.start + at + 1);
            let size = |row: &[f64]| norm(row[columns.clone()].iter().copied());
            let distance = |a: &[f64], b: &[f64]| norm(columns.clone().map(|column| a[column] - b[column]));
            let of = |rows: &mut dyn Iterator<Item = &[f64]>| {
                rows.fold([0.0f64, 0.0f64], |[change, value], row| {
                    [change.max(distance(row, begin)), value.max(size(row))]
                })
            };
            let own = |rows: &[(f64, Vec<f64>)], count: usize| of(&mut rows.iter().take(count).map(|row| &row.1[..]));
            let [change, value] = own(run.rows, usize::MAX);
            let both = [
                own(here, there.len()),
                of(&mut there.iter().take(here.len()).map(|row| &row[..])),
            ];
            let whole = turn(output.unit).filter(|turn| value.max(both[1][1]) <= 0.5 * turn * (1.0 + 1e-9));
            let apart = |a: &[f64], b: &[f64]| {
                let far = distance(a, b);
                whole.map_or(far, |turn| far.min(turn - far))
            };
            let pairs = || here.iter().map(|(_, row)| &row[..]).zip(there);
            let norm_of = |of: &dyn Fn(usize) -> Option<f64>| norm(columns.clone().filter_map(of));
            let in_columns = |size: &dyn Fn(&Operands) -> f64| norm_of(&|column| run.operands.get(column).map(size));
            // What changes nowhere, such as a mass, or a force at rest, is measured by its value.
            let stays = |rows: &mut dyn Iterator<Item = &[f64]>| {
                let rows: Vec<&[f64]> = rows.collect();
                let change = rows.iter().map(|row| distance(row, rows[0])).fold(0.0, f64::max);
                change <= STILL * value
            };
            let is_still = stays(&mut run.rows.iter().map(|row| &row.1[..]))
                && stays(&mut here.iter().take(there.len()).map(|row| &row.1[..]))
                && stays(&mut there.iter().map(|row| &row[..]));
            let sizes = both.map(|[change, value]| change.min(value));
            let round_off = norm_of(&|column| run.round_off.get(column).copied());
            let operands = match in_columns(&|of| of.size) {
                // Places are made of unknowns alone: of a body in a frame far away not of where that is.
                operands if output.time_exponent == 0.0 && round_off > 0.0 => operands.min(round_off / ROUND_OFF),
                operands => operands,
            };
            let begins_alike = {
                let least = noise(operands, round_off).max(EARLY * sizes[0].min(sizes[1]));
                let mut so_far = [0.0f64; 3];
                pairs().any(|(row, other)| {
                    let now = [apart(row, other), distance(row, begin), distance(other, begin)];
                    so_far.iter_mut().zip(now).for_each(|(most, now)| *most = most.max(now));
                    let [away, own, others] = so_far;
                    own.min(others) > least && away <= EARLY * own.min(others)
                })
            };
            Compared {
                output: index,
                component,
                away: pairs().map(|(row, other)| apart(row, other)).fold(0.0, f64::max),
                size: if is_still { value } else { change.min(value) },
                value,
                sizes,
                operands,
                round_off,
                balanced: in_columns(&|of| of.balanced),
                begins_alike,
            }
        };
        let whole = of(None);
        all.push(whole);
        all.extend((0..output.components.len()).map(|component| {
            let own = of(Some(component));
            Compared {
                operands: own.operands.max(OTHERS * whole.value),
                round_off: whole.round_off,
                ..own
            }
        }));
    }
    all
}

/// What each output is off by: of a vector as a whole, or in the component that is off by much more.
pub(super) fn of_outputs(parts: impl Iterator<Item = Off>) -> Vec<Off> {
    let mut all: Vec<Off> = Vec::new();
    for off in parts {
        match all.last_mut().filter(|last| last.output == off.output) {
            Some(last) => {
                let needed = if last.component.is_none() { APART } else { 1.0 };
                if off.part > needed * last.part {
                    *last = off;
                }
            }
            None => all.push(off),
        }
    }
    all
}

/// A whole turn in a unit of angles. An angle that is known up to whole turns, between -1/2 and 1/2 of one, jumps in one run a little before it does in
/// another: both are as far apart as it is the shorter way round.
fn turn(unit: &str) -> Option<f64> {
    match unit {
        "rad" => Some(TAU),
        "mrad" => Some(1e3 * TAU),
        "deg" => Some(360.0),
        "rev" => Some(1.0),
        _ => None,
    }
}

fn norm(values: impl Iterator<Item = f64>) -> f64 {
    values.map(|value| value * value).sum::<f64>().sqrt()
}
