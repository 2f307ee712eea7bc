//! Outputs of a run at its rows, and of a second run at the same times: how far one is from the other.

use std::f64::consts::TAU;

use super::cautions::listed;
use crate::archive::{Archive, Keep};
use crate::{Integrator, Method, Options, Output, Scene, State, Stop};

/// Most numbers that are kept, with the times and what a row costs beside them: of longer histories every second, third, .. row.
const NUMBERS: u64 = 400_000;
const BESIDE: u64 = 4;
/// Part of the largest change of an output from which on its error is told.
pub(super) const TOLD: f64 = 0.01;
/// Least change that counts: of the largest change of an output of the same unit, and, times the tolerance, of the largest value. Less is what
/// a motion leaves where nothing moves, or a number that should not change.
const SMALL: f64 = 1e-3;
const KEPT: f64 = 1e3;
/// Relative error of a state that many steps leave.
const ROUND_OFF: f64 = 1e-13;
/// Part beyond which both are different motions.
const WRONG: f64 = 0.5;
/// Most outputs that are told.
const MOST: usize = 4;

/// Outputs of a run at its rows, with their times (s). What dies away between two rows that are far apart would be missed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Marks {
    pub rows: Vec<(f64, Vec<f64>)>,
    /// Rows from one that is kept to the next, less one.
    left_out: u64,
    /// What round-off makes of the outputs, by columns; empty until it is known.
    pub round_off: Vec<f64>,
}

impl Keep for Marks {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            rows,
            left_out: _,
            round_off,
        } = self;
        rows.keep(archive);
        round_off.keep(archive);
    }
}

impl Marks {
    /// Of a history with so many rows and columns of outputs.
    pub fn of(rows: u64, columns: usize) -> Self {
        Self {
            left_out: rows.saturating_mul(columns as u64 + BESIDE) / NUMBERS,
            ..Self::default()
        }
    }

    /// Takes in a row by its number.
    pub fn meet(&mut self, row: u64, t: f64, values: &[f64]) {
        if row.is_multiple_of(self.left_out + 1) {
            self.rows.push((t, values.to_vec()));
        }
    }

    /// Time of the last one, s.
    pub fn until(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.0)
    }

    /// The same times with other values, as far as there are any.
    pub fn with(&self, rows: Vec<Vec<f64>>) -> Self {
        let times = self.rows.iter().map(|row| row.0);
        Self {
            rows: times.zip(rows).collect(),
            left_out: self.left_out,
            round_off: self.round_off.clone(),
        }
    }

    /// The outputs with their distance from other rows, as part of their largest change, or of their largest
    /// value where that is less; the largest first. Rows that are
    /// not there are not compared; `rtol` is the tolerance of the run.
    pub fn differences(&self, outputs: &[Output], rows: &[Vec<f64>], rtol: f64) -> Vec<(usize, f64)> {
        self.between(outputs, self, rows, rtol)
    }

    /// The same of two other runs.
    pub fn between(&self, outputs: &[Output], here: &Self, there: &[Vec<f64>], rtol: f64) -> Vec<(usize, f64)> {
        let Some((_, begin)) = self.rows.first() else {
            return Vec::new();
        };
        let mut first = 0;
        let mut judged = Vec::new();
        for (index, output) in outputs.iter().enumerate() {
            let columns = first..first + output.width();
            first = columns.end;
            let size = |row: &[f64]| norm(row[columns.clone()].iter().copied());
            let over = |value: &dyn Fn(&[f64]) -> f64| self.rows.iter().map(|(_, row)| value(row)).fold(0.0, f64::max);
            let value = over(&size);
            let whole = turn(output.unit).filter(|turn| {
                let others = there.iter().map(|row| size(row)).fold(0.0, f64::max);
                value.max(others) <= 0.5 * turn * (1.0 + 1e-9)
            });
            let distance = |a: &[f64], b: &[f64]| norm(columns.clone().map(|column| a[column] - b[column]));
            let apart = |a: &[f64], b: &[f64]| {
                let far = distance(a, b);
                whole.map_or(far, |turn| far.min(turn - far))
            };
            let pairs = here.rows.iter().zip(there);
            let away = pairs.map(|((_, row), other)| apart(row, other)).fold(0.0, f64::max);
            let change = over(&|row| distance(row, begin));
            let round_off = self.round_off.get(columns).unwrap_or_default();
            judged.push((index, change, value, away, norm(round_off.iter().copied())));
        }
        let least = |unit: &str| {
            let same = || judged.iter().filter(|of| outputs[of.0].unit == unit);
            let change = SMALL * same().map(|of| of.1).fold(0.0, f64::max);
            let kept = (KEPT * rtol).min(SMALL) * same().map(|of| of.2).fold(0.0, f64::max);
            change.max(kept)
        };
        let parts = judged.iter().map(|&(index, change, value, away, round_off)| {
            let size = change.min(value).max(least(outputs[index].unit)).max(round_off);
            (index, away / size)
        });
        let mut found: Vec<(usize, f64)> = parts.collect();
        found.sort_by(|a, b| b.1.total_cmp(&a.1));
        found
    }
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

/// What round-off of a state makes of the outputs, by columns: of places, and of the forces that it makes of multipliers.
pub(super) fn round_off(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let columns = scene.output_columns();
    let [mut values, mut others] = [vec![0.0; columns], vec![0.0; columns]];
    let [mut force, mut other] = [vec![0.0; scene.unknowns()], vec![0.0; scene.unknowns()]];
    let mut near = state.clone();
    let sign = |index: usize| if index % 3 == 1 { -1.0 } else { 1.0 };
    for (index, (x, size)) in near.x.iter_mut().zip(scene.sizes()).enumerate() {
        *x += sign(index) * ROUND_OFF * size.max(x.abs());
    }
    scene.residual(state, &mut force);
    scene.residual(&near, &mut other);
    let change = force.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    for (index, multiplier) in near.lambda.iter_mut().enumerate() {
        *multiplier += sign(index) * change;
    }
    scene.outputs(state, &mut values);
    scene.outputs(&near, &mut others);
    values.iter().zip(&others).map(|(a, b)| (a - b).abs()).collect()
}

/// Whether an output follows from where things are and how fast they move. Forces, accelerations and energies have vibrations of their own, of
/// places that hardly change.
pub(super) fn is_of_motion(output: &Output) -> bool {
    output.time_exponent > -2.0
}

/// The largest part.
pub(super) fn largest(found: &[(usize, f64)]) -> f64 {
    found.first().map_or(0.0, |found| found.1)
}

/// The outputs whose errors are worth to be told, with these.
pub(super) fn told(outputs: &[Output], found: &[(usize, f64)]) -> Option<String> {
    let name = |&(output, part): &(usize, f64)| {
        if part > WRONG {
            return format!("`{}` by more than {:.0} %", outputs[output].name, 100.0 * WRONG);
        }
        let digits = usize::from(part < 0.1);
        format!("`{}` by about {:.digits$} %", outputs[output].name, 100.0 * part)
    };
    let worth = found.iter().filter(|&&(_, part)| part > TOLD);
    listed(&worth.map(name).collect::<Vec<_>>(), MOST)
}

/// How to go a second time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Again {
    pub t_end: f64,
    pub method: Method,
    pub options: Options,
    /// Most iterations.
    pub most: u64,
}

/// Rows at the times of the marks of a run that goes so, as far as it comes and `goes_on` lets it, and what iterations it takes.
pub(super) fn again(
    scene: &mut dyn Scene,
    start: State,
    how: Again,
    marks: &Marks,
    goes_on: &mut dyn FnMut() -> bool,
) -> (Vec<Vec<f64>>, u64) {
    let columns = scene.output_columns();
    let mut rows = Vec::with_capacity(marks.rows.len());
    let Ok(mut integrator) = Integrator::new(scene, start, how.t_end, how.method, how.options) else {
        return (rows, 0);
    };
    let mut state = integrator.state().clone();
    loop {
        while let Some(&(t, _)) = marks.rows.get(rows.len()) {
            let reached = integrator.state().t;
            if t > reached * (1.0 + 1e-13) {
                break;
            }
            if t >= reached {
                state.clone_from(integrator.state());
            } else {
                integrator.interpolate(t, &mut state);
            }
            let mut row = vec![0.0; columns];
            integrator.system().outputs(&state, &mut row);
            rows.push(row);
        }
        let iterations = integrator.statistics().newton_iterations;
        if rows.len() == marks.rows.len() || iterations > how.most || !goes_on() {
            return (rows, iterations);
        }
        match integrator.step() {
            Ok(Stop::End) if integrator.state().t < how.t_end => return (rows, iterations),
            Ok(_) => {}
            Err(_) => return (rows, iterations),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn output(name: &'static str, unit: &'static str) -> Output {
        Output {
            name,
            unit,
            time_exponent: 0.0,
            components: &[],
            doc: "",
        }
    }

    /// Of three places one moves, one hardly and one not at all; energy is kept but for round-off; a force is as good as it is in any unit.
    #[test]
    fn what_does_not_move_is_compared_with_what_does() {
        let outputs = [
            output("moves", "m"),
            output("hardly", "m"),
            output("stays", "m"),
            output("energy", "J"),
            output("force", "kN"),
        ];
        let mut marks = Marks::default();
        for k in 0..=40u32 {
            let t = f64::from(k) / 40.0;
            marks.meet(k.into(), t, &[t, 1e-6 * t, 1e-13 * t, 5.0 + 1e-9 * t, t]);
        }
        let others: Vec<Vec<f64>> = marks
            .rows
            .iter()
            .map(|(t, _)| vec![1.02 * t, 2e-6 * t, 0.0, 5.0, 1.05 * t])
            .collect();
        let found = marks.differences(&outputs, &others, 1e-6);
        assert_eq!(found.len(), 5);
        assert!(found[1].0 == 0 && (found[1].1 - 0.02).abs() < 1e-12, "{found:?}");
        assert_eq!(
            told(&outputs, &found).unwrap(),
            "`force` by about 5.0 %, `moves` by about 2.0 %"
        );
        // As far as there are rows.
        assert!(told(&outputs, &marks.differences(&outputs, &others[..6], 1e-6)).is_none());
    }

    /// Between axes an angle jumps back by a turn: not at the same time in two runs.
    #[test]
    fn angles_that_jump_are_compared_the_shorter_way_round() {
        let outputs = [output("between", "deg"), output("counted", "deg")];
        let wrapped = |angle: f64| (angle + 180.0).rem_euclid(360.0) - 180.0;
        let row = |angle: f64| vec![wrapped(angle), angle];
        let mut marks = Marks::default();
        (0..1000).for_each(|k| marks.meet(k, k as f64, &row(k as f64)));
        let others: Vec<Vec<f64>> = (0..1000).map(|k| row(k as f64 + 2.0)).collect();
        let found = marks.differences(&outputs, &others, 1e-6);
        let of = |index: usize| found.iter().find(|found| found.0 == index).unwrap().1;
        assert!(
            (of(0) - 2.0 / 180.0).abs() < 1e-9 && (of(1) - 2.0 / 999.0).abs() < 1e-9,
            "{found:?}"
        );
    }

    /// Nothing is left out of a history that fits in memory; of a longer one as little as may be.
    #[test]
    fn all_rows_are_kept_but_of_very_long_histories() {
        for (count, kept) in [(301, 301), (50_000, 50_000), (160_000, 53_334)] {
            let mut marks = Marks::of(count, 2);
            (0..count).for_each(|row| marks.meet(row, row as f64, &[1.0, 2.0]));
            assert_eq!(marks.rows.len(), kept, "{count}");
        }
    }
}
