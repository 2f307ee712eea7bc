//! What the steps of a method of second order add up to over a run.
//!
//! The tolerance holds for one step. Errors of steps add up, and in motions that last (orbits, bodies that spin) grow with the time; from within
//! a run nothing of that is seen. Radau with the same tolerance takes far fewer steps, whose errors are of fifth order: how far its motion is from that of
//! the run is the error of the run. Where that takes too long, the run is repeated with a hundred times the tolerance, in a fifth of the steps: its
//! distance, over what the order of the method promises, is the least error of the run.

use super::cautions::listed;
use crate::archive::{Archive, Keep};
use crate::{Integrator, Method, Options, Output, Scene, State, StepSize, Stop};

/// Tolerance of the second run, in those of the first, and the largest one.
const LOOSER: f64 = 100.0;
const LOOSEST: f64 = 1e-2;
/// Error of the second run over that of the first: steps follow the third root of the tolerance, errors the square of the steps.
const ORDER: f64 = 21.5;
/// Parts of the Newton iterations of the run that Radau and a run with a larger tolerance may take,
const SHARE: [f64; 2] = [0.2, 0.4];
/// or, times the unknowns, these iterations, which take some tenths of a second.
const AFFORDED: usize = 500_000;
/// Least number of steps that add up to something.
const STEPS: u64 = 200;
/// Times at which both runs are compared.
const MARKS: f64 = 40.0;
/// Part of the largest change of an output from which on its error is told.
const TOLD: f64 = 0.01;
/// Most outputs that are told.
const MOST: usize = 4;
/// Units of what follows from where things are and how fast they move: forces and accelerations have vibrations of their own.
const UNITS: [&str; 6] = ["m", "rad", "1", "m/s", "rad/s", "J"];

/// Outputs of a run at some of its rows, with their times (s).
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Marks {
    rows: Vec<(f64, Vec<f64>)>,
    due: f64,
}

impl Keep for Marks {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { rows, due } = self;
        rows.keep(archive);
        due.keep(archive);
    }
}

impl Marks {
    /// Takes in a row of a run of `t_end`, s.
    pub fn meet(&mut self, t: f64, t_end: f64, values: &[f64]) {
        if t >= self.due {
            self.due = t + t_end / MARKS * (1.0 - 1e-9);
            self.rows.push((t, values.to_vec()));
        }
    }
}

/// A run that came to its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ended<'r> {
    pub t_end: f64,
    pub method: Method,
    pub options: Options,
    /// Steps and iterations.
    pub steps: u64,
    pub iterations: u64,
    pub marks: &'r Marks,
}

/// One sentence where what the steps of a run from `start` add up to is large.
pub(super) fn accumulated(scene: &mut dyn Scene, start: State, run: Ended<'_>, outputs: &[Output]) -> Option<String> {
    let Ended { method, options, .. } = run;
    let is_second = matches!(method, Method::Hht { .. } | Method::GeneralizedAlpha { .. });
    if !is_second || options.step != StepSize::Adaptive || run.steps < STEPS {
        return None;
    }
    let afforded = (AFFORDED / scene.unknowns().max(1)) as u64;
    let most = SHARE.map(|share| afforded.max((share * run.iterations as f64) as u64));
    let by_radau = again(
        scene,
        start.clone(),
        (run.t_end, Method::Radau, options, most[0]),
        run.marks,
    );
    if let Some(rows) = by_radau {
        let names = told(outputs, &differences(outputs, run.marks, &rows, 1.0))?;
        return Some(format!(
            "The tolerance holds for each step, and errors of {} steps add up: Radau with the same tolerance finds another motion, from which outputs differ by parts of their largest change, {names}. Take `--integrator radau`, or a smaller `--rtol`.",
            run.steps
        ));
    }
    let rtol = LOOSER * options.rtol;
    if rtol > LOOSEST {
        return None;
    }
    let looser = Options { rtol, ..options };
    let rows = again(scene, start, (run.t_end, method, looser, most[1]), run.marks)?;
    let names = told(outputs, &differences(outputs, run.marks, &rows, ORDER - 1.0))?;
    Some(format!(
        "The tolerance holds for each step, and errors of {} steps add up: the same run with a hundred times the tolerance ends so far away that outputs of this one may be off by parts of their largest change, {names} or more. Take `--integrator radau`, or a smaller `--rtol`.",
        run.steps
    ))
}

/// The outputs with their errors.
fn told(outputs: &[Output], found: &[(usize, f64)]) -> Option<String> {
    let name = |&(output, part): &(usize, f64)| format!("`{}` by about {:.1} %", outputs[output].name, 100.0 * part);
    listed(&found.iter().map(name).collect::<Vec<_>>(), MOST)
}

/// Rows at the times of the marks of a run with other options; `None` where it fails, or takes more iterations than these.
fn again(
    scene: &mut dyn Scene,
    start: State,
    (t_end, method, options, most): (f64, Method, Options, u64),
    marks: &Marks,
) -> Option<Vec<Vec<f64>>> {
    let columns = scene.output_columns();
    let mut integrator = Integrator::new(scene, start, t_end, method, options).ok()?;
    let mut state = integrator.state().clone();
    let mut rows = Vec::with_capacity(marks.rows.len());
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
        if rows.len() == marks.rows.len() {
            return Some(rows);
        }
        if integrator.statistics().newton_iterations > most
            || integrator.step().ok()? == Stop::End && integrator.state().t < t_end
        {
            return None;
        }
    }
}

/// Outputs whose error is told, their distance from other rows over `order`, as part of their largest change; the largest first.
fn differences(outputs: &[Output], marks: &Marks, rows: &[Vec<f64>], order: f64) -> Vec<(usize, f64)> {
    let mut first = 0;
    let mut found = Vec::new();
    for (index, output) in outputs.iter().enumerate() {
        let columns = first..first + output.width();
        first = columns.end;
        if !UNITS.contains(&output.unit) {
            continue;
        }
        let distance = |a: &[f64], b: &[f64]| {
            let squares = columns.clone().map(|column| (a[column] - b[column]).powi(2));
            squares.sum::<f64>().sqrt()
        };
        let Some((_, begin)) = marks.rows.first() else {
            return found;
        };
        let change = marks
            .rows
            .iter()
            .map(|(_, row)| distance(row, begin))
            .fold(0.0, f64::max);
        let pairs = marks.rows.iter().zip(rows);
        let away = pairs.map(|((_, row), other)| distance(row, other)).fold(0.0, f64::max);
        let part = away / order / change;
        if part > TOLD {
            found.push((index, part));
        }
    }
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    found
}

#[cfg(test)]
mod tests {
    use super::super::run::{RunSettings, run};
    use super::super::testing::Rotor;
    use super::*;
    use crate::AnyModel;

    /// Error of the position at the end of a run over its largest change, and the part that is told.
    fn error_and_told(method: Method, rtol: f64) -> (f64, Option<f64>) {
        let rotor = Rotor {
            loss: 0.0,
            ..Rotor::default()
        };
        let settings = |method, rtol| RunSettings {
            method,
            t_end: Some(60.0),
            options: Options {
                rtol,
                ..Options::default()
            },
            ..RunSettings::default()
        };
        let result = run(&rotor, &settings(method, rtol)).unwrap();
        let exact = run(&rotor, &settings(Method::Radau, 1e-11)).unwrap();
        let outputs = AnyModel::outputs(&rotor);
        let rows: Vec<Vec<f64>> = exact.marks.rows.iter().map(|(_, row)| row.clone()).collect();
        let found = differences(outputs, &result.marks, &rows, 1.0);
        let error = found.first().map_or(0.0, |found| found.1);
        let mut scene = rotor
            .build_as(settings(method, rtol).formulation, crate::Joints::Eliminated, &[])
            .unwrap();
        let start = scene.rest(0.0);
        let ended = Ended {
            t_end: 60.0,
            method,
            options: result.settings.options,
            steps: result.statistics.steps,
            iterations: result.statistics.newton_iterations,
            marks: &result.marks,
        };
        let told = accumulated(scene.as_mut(), start, ended, outputs);
        let part = |text: String| -> f64 {
            let after = text.split("by about ").nth(1).unwrap();
            after.split(' ').next().unwrap().parse::<f64>().unwrap() / 100.0
        };
        (error, told.map(part))
    }

    /// A spring in a turning frame that nothing damps, 60 s: the errors of its phase add up.
    #[test]
    fn what_steps_of_second_order_add_up_to_is_told_with_its_size() {
        for method in [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
            let (error, told) = error_and_told(method, 1e-5);
            let told = told.expect("a note");
            assert!(
                error > 0.02 && (0.7..1.4).contains(&(told / error)),
                "{method:?}: {error}, told {told}"
            );
            assert_eq!(error_and_told(method, 1e-9).1, None);
        }
        assert_eq!(error_and_told(Method::Radau, 1e-6).1, None);
    }
}
