//! What the steps of a method of second order add up to over a run.
//!
//! The tolerance holds for one step. Errors of steps add up, and in motions that last (orbits, bodies that spin) grow with the time; from within
//! a run nothing of that is seen. Radau with the same tolerance takes far fewer steps, whose errors are of fifth order: how far its motion is from that of
//! the run is the error of the run. Where that takes too long, the run is repeated with a hundred times the tolerance, in a fifth of the steps: its
//! distance, over what the order of the method promises, is the least error of the run.

use super::compared::{Off, TOLD};
use super::marks::{Again, Marks, again, is_of_motion, told};
use crate::{Method, Options, Output, Scene, State, StepSize};

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

/// A run that came to its end.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct Ended<'r> {
    pub t_end: f64,
    pub method: Method,
    pub options: Options,
    /// Steps and iterations.
    pub steps: u64,
    pub iterations: u64,
    /// The longest step, s.
    pub longest: f64,
    /// Whether steps are as long as motions and loads allow, and so with other tolerances too.
    pub is_shortened: bool,
    pub marks: &'r Marks,
    /// Whether it was compared with other steps until its end.
    pub is_compared: bool,
}

/// What the steps of a run add up to.
#[derive(Debug, Default)]
pub(in crate::app) struct Accumulated {
    /// One sentence where it is large.
    pub told: Option<String>,
    /// Whether it is known until the end of the run.
    pub is_known: bool,
    /// How far outputs are off.
    pub off: Vec<Off>,
}

impl Accumulated {
    fn known(told: Option<String>, off: Vec<Off>) -> Self {
        Self {
            told,
            is_known: true,
            off,
        }
    }
}

/// What the steps of a run from `start` add up to.
pub(in crate::app) fn accumulated(
    scene: &mut dyn Scene,
    start: State,
    run: Ended<'_>,
    outputs: &[Output],
    goes_on: &mut dyn FnMut() -> bool,
) -> Accumulated {
    let Ended { method, options, .. } = run;
    if !method.adds_up() || options.step != StepSize::Adaptive {
        return Accumulated::default();
    }
    if run.steps < STEPS {
        return Accumulated::known(None, Vec::new());
    }
    let afforded = (AFFORDED / scene.unknowns().max(1)) as u64;
    let most = SHARE.map(|share| afforded.max((share * run.iterations as f64) as u64));
    let by_radau = whole(
        scene,
        start.clone(),
        (run.t_end, Method::Radau, options, most[0]),
        run.marks,
        goes_on,
    );
    if let Some(rows) = by_radau {
        let off = run.marks.differences(outputs, &rows, options.rtol);
        let told = told_of_motion(outputs, &off).map(|names| format!(
            "The tolerance holds for each step, and errors of {} steps add up: Radau with the same tolerance finds another motion, from which outputs differ by parts of their largest change or value, {names}. Take `--integrator radau`, or a smaller `--rtol`.",
            run.steps
        ));
        return Accumulated::known(told, off);
    }
    let rtol = LOOSER * options.rtol;
    if rtol > LOOSEST {
        return Accumulated::default();
    }
    let looser = Options { rtol, ..options };
    let Some(rows) = whole(scene, start, (run.t_end, method, looser, most[1]), run.marks, goes_on) else {
        return Accumulated::default();
    };
    let mut found = run.marks.differences(outputs, &rows, options.rtol);
    found.iter_mut().for_each(|off| off.part /= ORDER - 1.0);
    let told = told_of_motion(outputs, &found).map(|names| format!(
        "The tolerance holds for each step, and errors of {} steps add up: the same run with a hundred times the tolerance ends so far away that outputs of this one may be off by parts of their largest change or value, {names} or more. Take `--integrator radau`, or a smaller `--rtol`.",
        run.steps
    ));
    Accumulated::known(told, found)
}

/// What is off, where places or speeds are: errors of forces alone do not add up.
fn told_of_motion(outputs: &[Output], found: &[Off]) -> Option<String> {
    let moves = |off: &Off| off.part > TOLD && is_of_motion(&outputs[off.output]);
    found.iter().any(moves).then(|| told(outputs, found))?
}

/// Rows at the times of the marks of a run with other options; `None` where it fails, or takes more iterations than these.
fn whole(
    scene: &mut dyn Scene,
    start: State,
    (t_end, method, options, most): (f64, Method, Options, u64),
    marks: &Marks,
    goes_on: &mut dyn FnMut() -> bool,
) -> Option<Vec<Vec<f64>>> {
    let how = Again {
        t_end,
        method,
        options,
        most,
    };
    let rows = again(scene, start, how, marks, goes_on).rows;
    (rows.len() == marks.rows.len()).then_some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::AnyModel;
    use crate::app::results::run::RunSettings;
    use crate::app::runs::run::run;
    use crate::app::testing::Rotor;

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
        let found = result.marks.differences(outputs, &rows, rtol);
        let error = found.first().map_or(0.0, |off| off.part);
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
            longest: result.statistics.largest_step,
            is_shortened: false,
            marks: &result.marks,
            is_compared: false,
        };
        let told = accumulated(scene.as_mut(), start, ended, outputs, &mut || true).told;
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
