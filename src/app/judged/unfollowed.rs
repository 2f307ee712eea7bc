//! Vibrations that the start sets off and that the steps of a run do not follow.
//!
//! Steps follow what moves the unknowns by more than the tolerance. A stiff vibration has a small amplitude, and forces that are not small:
//! where it is shorter than the steps, implicit methods damp it away, and outputs that read forces, moments or accelerations show the mean that it swings about. Where
//! nothing damps it in the model, that is off by its amplitude, at the right positions. No estimate of a step's error sees this. So it is looked at: after the run a few
//! steps with a far smaller tolerance begin at the same start. What swings in them, lasts and is quicker than the steps of the run is missing in its outputs.

use super::compared::{Off, TOLD};
use super::marks::Marks;
use crate::app::writing::numbers::digits;
use crate::app::writing::sentences::listed;
use crate::{Integrator, Method, Options, Output, Scene, State, Statistics, Stop};

/// Tolerance of the look, of that of the run, and the least one.
const FINER: f64 = 1e-3;
const LEAST: f64 = 1e-10;
/// The look ends after so many mean steps of the run, or, at half as many steps as it, within these bounds,
const ENOUGH: f64 = 20.0;
const STEPS: [u64; 2] = [120, 300];
/// or where its iterations are this part of those of the run and, times the unknowns, more than these, which take some tenths of a second.
const SHARE: f64 = 0.2;
const AFFORDED: usize = 500_000;
/// Even times at which what was seen is judged.
const TIMES: usize = 256;
/// Amplitude that is nothing, in tolerances of what the output is made of.
const SMALL: f64 = 10.0;
/// States of which it is looked at what outputs are made of: one of so many.
const LOOKED_AT: usize = 16;
/// Least changes of sign about the mean.
const CHANGES: usize = 5;
/// A vibration lasts whose amplitude in the second half of the look is at least this part of that in the first half.
const LASTING: f64 = 0.7;
/// Steps of the run in a period that follow it.
const FOLLOWED: f64 = 4.0;
/// Part of a swing that an output has where the time in it stands still, if it is one of the motion.
const OF_MOTION: f64 = 0.1;
/// Part of a swing by which rows of the run and of the look differ that have it alike, and how many rows say so.
const SAME: f64 = 0.05;
const ROWS: usize = 2;
/// Most outputs that are told.
const MOST: usize = 4;
/// Part of the amplitude within which no change of sign counts.
const BAND: f64 = 0.2;

/// A vibration of an output.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Swing {
    /// s
    period: f64,
    /// In the unit of the output.
    amplitude: f64,
}

/// An output that misses a vibration.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Missed {
    output: usize,
    /// Of its columns, among those of all outputs.
    column: usize,
    swing: Swing,
    /// Amplitude over the largest value.
    part: f64,
}

/// What the steps of a run lose.
#[derive(Debug, Default)]
pub(in crate::app) struct Lost {
    /// One sentence where it is much of an output.
    pub told: Option<String>,
    /// How far outputs are off by it.
    pub off: Vec<Off>,
}

/// A run that came to its end.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct Followed<'r> {
    /// s
    pub t_end: f64,
    pub rtol: f64,
    pub statistics: &'r Statistics,
    /// Where its steps end, and their sizes, s; of a long run some of them.
    pub taken: &'r [[f64; 2]],
    /// State at the end.
    pub end: &'r State,
    pub marks: &'r Marks,
}

/// The vibrations that outputs of a run from `start` miss.
pub(in crate::app) fn unfollowed(scene: &mut dyn Scene, start: State, run: Followed<'_>, outputs: &[Output]) -> Lost {
    lost(scene, start, run, outputs).unwrap_or_default()
}

fn lost(scene: &mut dyn Scene, start: State, run: Followed<'_>, outputs: &[Output]) -> Option<Lost> {
    let (rtol, steps) = (run.rtol, run.statistics.steps);
    let step = run.t_end / steps.max(1) as f64;
    let finer = (FINER * rtol).max(LEAST);
    if finer > 0.1 * rtol {
        return None;
    }
    let ends = Ends {
        steps: (steps / 2).clamp(STEPS[0], STEPS[1]),
        iterations: ((SHARE * run.statistics.newton_iterations as f64) as u64)
            .max((AFFORDED / scene.unknowns().max(1)) as u64),
        time: ENOUGH * step,
    };
    let marks = sparsely(&run.marks.rows, start.t + ends.time);
    let Look { states, at_rows } = look(scene, start, (run.t_end, finer), &ends, &marks)?;
    let rows: Vec<(f64, Vec<f64>)> = states.iter().map(|state| (state.t, row(scene, state))).collect();
    let last = row(scene, run.end);
    let mut nothing = vec![0.0; last.len()];
    for state in states.iter().step_by(LOOKED_AT).chain([run.end]) {
        for (nothing, of) in nothing.iter_mut().zip(scene.operands(state)) {
            *nothing = f64::max(*nothing, SMALL * rtol * of.size);
        }
    }
    let mut found = missing(outputs, &rows, &last, &nothing, run.taken);
    found.retain(|missed| !shows(&run.marks.rows, rows[rows.len() - 1].0, missed));
    // Steps that are longer than a turn follow it where frames turn with what turns.
    found.retain(|missed| !agrees(&marks, &at_rows, missed));
    // What an output has of the time alone no step loses.
    let standing = states[states.len() / 2].t;
    found.retain(|missed| {
        let of_motion = states.iter().map(|state| {
            let still = State {
                t: standing,
                ..state.clone()
            };
            (state.t, row(scene, &still)[missed.column])
        });
        let left = swing(&of_motion.collect::<Vec<_>>());
        left.is_some_and(|left| left.amplitude >= OF_MOTION * missed.swing.amplitude)
    });
    let amplitudes: Vec<(usize, f64)> = found.iter().map(|of| (of.output, of.swing.amplitude)).collect();
    let off = run.marks.lost(outputs, &amplitudes, rtol);
    found.retain(|missed| off.iter().any(|off| off.output == missed.output && off.part > TOLD));
    found.sort_by(|a, b| b.part.total_cmp(&a.part));
    let told = |missed: &Missed| {
        let name = outputs[missed.output].name;
        format!(
            "`{name}` by {} % of its largest value, with a period of {:.1e} s",
            digits(100.0 * missed.part, 2),
            missed.swing.period
        )
    };
    let names = listed(&found.iter().map(told).collect::<Vec<_>>(), MOST);
    let told = names.map(|names| format!(
        "The start sets off vibrations that last and are quicker than the steps of the run ({step:.1e} s in the mean), which lose them: {names} show the mean that they swing about, without the swing. Give `damping` to what vibrates, start in equilibrium (`--start steady`, `start .. = spinning(..)`), or follow them with `--rtol {finer:.0e}`."
    ));
    Some(Lost { told, off })
}

/// Outputs at a state, SI.
fn row(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut row);
    row
}

/// What ends the look, where it comes first.
struct Ends {
    steps: u64,
    iterations: u64,
    /// s
    time: f64,
}

/// A short run with a small tolerance.
struct Look {
    /// At the ends of its steps.
    states: Vec<State>,
    /// Outputs at rows of the run, as far as it goes.
    at_rows: Vec<Vec<f64>>,
}

/// The look, with outputs at the times of these rows; none where it does not begin.
fn look(
    scene: &mut dyn Scene,
    start: State,
    (t_end, rtol): (f64, f64),
    ends: &Ends,
    marks: &[&(f64, Vec<f64>)],
) -> Option<Look> {
    let until = start.t + ends.time;
    let options = Options {
        rtol,
        ..Options::default()
    };
    let mut integrator = Integrator::new(scene, start, t_end, Method::Radau, options).ok()?;
    let mut states = vec![integrator.state().clone()];
    let mut at_rows = Vec::new();
    for _ in 0..ends.steps {
        let stop = integrator.step().ok()?;
        states.push(integrator.state().clone());
        let reached = integrator.state().t;
        while let Some(&&(t, ref own)) = marks.get(at_rows.len()).filter(|mark| mark.0 <= reached) {
            let mut state = integrator.state().clone();
            if t < reached {
                integrator.interpolate(t, &mut state);
            }
            let mut row = vec![0.0; own.len()];
            integrator.system().outputs(&state, &mut row);
            at_rows.push(row);
        }
        let is_enough = integrator.state().t > until || integrator.statistics().newton_iterations > ends.iterations;
        if stop != Stop::Step || is_enough {
            break;
        }
    }
    Some(Look { states, at_rows })
}

/// Outputs that swing quicker than steps follow, by more than is nothing in a column. What steps follow until the end of the look is seen by their
/// control: it lets go where the vibration has died away.
fn missing(
    outputs: &[Output],
    rows: &[(f64, Vec<f64>)],
    last: &[f64],
    nothing: &[f64],
    taken: &[[f64; 2]],
) -> Vec<Missed> {
    let mut first = 0;
    let columns: Vec<std::ops::Range<usize>> = outputs
        .iter()
        .map(|output| {
            let range = first..first + output.width();
            first = range.end;
            range
        })
        .collect();
    let size = |range: &std::ops::Range<usize>| {
        let of = |row: &[f64]| row[range.clone()].iter().map(|value| value * value).sum::<f64>().sqrt();
        rows.iter().map(|(_, row)| of(row)).fold(of(last), f64::max)
    };
    let sizes: Vec<f64> = columns.iter().map(size).collect();
    let until = rows.last().map_or(0.0, |row| row.0);
    let mut late: Vec<[f64; 2]> = taken.iter().copied().filter(|[end, _]| *end > 0.5 * until).collect();
    let ahead = late.iter().take_while(|[end, h]| end - h < until).count();
    late.truncate(ahead.max(1));
    let mut found = Vec::new();
    for (index, columns) in columns.iter().enumerate() {
        let swings = columns.clone().filter_map(|column| {
            let values: Vec<(f64, f64)> = rows.iter().map(|(t, row)| (*t, row[column])).collect();
            let swing = swing(&values).filter(|swing| swing.amplitude > nothing[column])?;
            let is_lost = late.iter().any(|[_, h]| swing.period < FOLLOWED * h);
            is_lost.then_some((column, swing))
        });
        let Some((column, swing)) = swings.max_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude)) else {
            continue;
        };
        found.push(Missed {
            output: index,
            column,
            swing,
            part: swing.amplitude / sizes[index],
        });
    }
    found
}

/// Whether rows of the run show a swing until the end of the look: that of a magnitude is twice as quick as what it is of, which steps follow.
fn shows(rows: &[(f64, Vec<f64>)], until: f64, missed: &Missed) -> bool {
    let seen = rows.iter().take_while(|(t, _)| *t <= until);
    let values: Vec<(f64, f64)> = seen.map(|(t, row)| (*t, row[missed.column])).collect();
    let span = values.last().map_or(0.0, |last| last.0 - values[0].0);
    let a_period = values.len() as f64 * missed.swing.period / span;
    a_period >= FOLLOWED && swing(&values).is_some_and(|swing| swing.amplitude >= LASTING * missed.swing.amplitude)
}

/// Some rows until a time, s, evenly spread: of many a few say as much.
fn sparsely(rows: &[(f64, Vec<f64>)], until: f64) -> Vec<&(f64, Vec<f64>)> {
    let within = rows.partition_point(|row| row.0 <= until);
    rows[..within].iter().step_by(within.div_ceil(TIMES).max(1)).collect()
}

/// Whether rows of the run have the values of the look: some of a swing that is lost would not.
fn agrees(rows: &[&(f64, Vec<f64>)], at_rows: &[Vec<f64>], missed: &Missed) -> bool {
    // The start is that of both.
    let pairs = || rows.iter().zip(at_rows).skip(1);
    let near = |(own, other): (&&(f64, Vec<f64>), &Vec<f64>)| {
        (own.1[missed.column] - other[missed.column]).abs() <= SAME * missed.swing.amplitude
    };
    pairs().count() >= ROWS && pairs().all(near)
}

/// What of values over time swings about a smooth mean, and lasts.
fn swing(values: &[(f64, f64)]) -> Option<Swing> {
    let even = evenly(values)?;
    let rest = without_parabola(&even);
    let half = TIMES / 2;
    let amplitude = |part: &[f64]| (2.0 * part.iter().map(|x| x * x).sum::<f64>() / part.len() as f64).sqrt();
    let [whole, early, late] = [&rest[..], &rest[..half], &rest[half..]].map(amplitude);
    let mut sign = 0.0;
    let mut changes = 0;
    for value in rest.iter().filter(|value| value.abs() > BAND * whole) {
        if sign * value < 0.0 {
            changes += 1;
        }
        sign = value.signum();
    }
    let span = values[values.len() - 1].0 - values[0].0;
    let lasts = late >= LASTING * early;
    (changes >= CHANGES && lasts && whole.is_finite()).then(|| Swing {
        period: 2.0 * span / changes as f64,
        amplitude: whole,
    })
}

/// Values at even times, on cubics through the four values around each: on lines a parabola through long steps would swing.
fn evenly(values: &[(f64, f64)]) -> Option<Vec<f64>> {
    let (from, to) = (values.first()?.0, values.last()?.0);
    let mut at = 0;
    let even = (0..TIMES).map(|number| {
        let t = from + (to - from) * number as f64 / (TIMES - 1) as f64;
        while at + 2 < values.len() && values[at + 1].0 < t {
            at += 1;
        }
        let around = &values[at.saturating_sub(1)..(at + 3).min(values.len())];
        let shares = around.iter().enumerate().map(|(k, (tk, yk))| {
            let others = around.iter().enumerate().filter(|(other, _)| *other != k);
            others.fold(*yk, |share, (_, (other, _))| share * (t - other) / (tk - other))
        });
        shares.sum()
    });
    (to > from).then(|| even.collect())
}

/// Values at even times less the parabola that is nearest to them.
fn without_parabola(values: &[f64]) -> Vec<f64> {
    let last = (values.len() - 1) as f64;
    let place = |at: usize| 2.0 * at as f64 / last - 1.0;
    // Legendre's polynomials, made orthogonal on the places by Gram and Schmidt.
    let mut rest = values.to_vec();
    let mut base: Vec<Vec<f64>> = Vec::new();
    for degree in 0..3 {
        let mut shape: Vec<f64> = (0..values.len()).map(|at| place(at).powi(degree)).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for other in &base {
            let part = dot(&shape, other);
            shape.iter_mut().zip(other).for_each(|(x, y)| *x -= part * y);
        }
        let norm = dot(&shape, &shape).sqrt();
        shape.iter_mut().for_each(|x| *x /= norm);
        let part = dot(&rest, &shape);
        rest.iter_mut().zip(&shape).for_each(|(x, y)| *x -= part * y);
        base.push(shape);
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::AnyModel;
    use crate::app::results::run::RunSettings;
    use crate::app::runs::run::run;
    use crate::app::testing::Rotor;

    /// The pull at the end of a run of a rotor, N, and what is told.
    fn told(rotor: &Rotor) -> (f64, Option<String>) {
        let settings = RunSettings::default();
        let result = run(rotor, &settings).unwrap();
        let mut scene = rotor.build_as(settings.formulation, settings.joints, &[]).unwrap();
        let mut row = [0.0; 3];
        scene.outputs(&result.state, &mut row);
        let start = scene.rest(0.0);
        let of_run = Followed {
            t_end: result.settings.t_end.unwrap(),
            rtol: settings.options.rtol,
            statistics: &result.statistics,
            taken: &result.steps.iter().map(|step| [step.t, step.h]).collect::<Vec<_>>(),
            end: &result.state,
            marks: &result.marks,
        };
        (
            row[2],
            unfollowed(scene.as_mut(), start, of_run, AnyModel::outputs(rotor)).told,
        )
    }

    /// A stiff spring that starts without force in a turning frame: its force swings between 0 and twice the mean, for ever.
    #[test]
    fn a_lost_vibration_of_a_stiff_spring_is_told_with_its_size_and_period() {
        let soft = Rotor::default();
        let stiff = Rotor {
            stiffness: 1e7 * soft.omega * soft.omega,
            coils: 1,
            loss: 0.0,
            ..Rotor::default()
        };
        let (pull, note) = told(&stiff);
        let note = note.expect("a note");
        // The run shows the centrifugal force of 1 kg, the look its swing of the same size, 2 pi / sqrt(9e7 / s^2).
        let mean = stiff.omega * stiff.omega * stiff.length;
        assert!((pull / mean - 1.0).abs() < 0.02, "{pull} N");
        assert!(note.contains("`pull` by 4") || note.contains("`pull` by 5"), "{note}");
        assert!(note.contains("with a period of 6.") && note.contains("e-4 s"), "{note}");
        // Where it is damped, or followed, nothing is missed.
        let damped = Rotor { loss: 0.1, ..stiff };
        assert_eq!(told(&damped).1, None);
        assert_eq!(told(&soft).1, None);
    }

    /// Values of a function at 100 steps that grow at first, to 1 s.
    fn seen(of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (0..=100)
            .map(|k| (f64::from(k) / 100.0).powf(1.2))
            .map(|t| (t, of(t)))
            .collect()
    }

    #[test]
    fn what_swings_about_a_smooth_mean_is_found_and_nothing_else() {
        let found = swing(&seen(|t| 3.0 + t - t * t + 0.5 * (40.0 * t).cos())).unwrap();
        assert!(
            (found.period - 2.0 * std::f64::consts::PI / 40.0).abs() < 0.02,
            "{found:?}"
        );
        assert!((found.amplitude - 0.5).abs() < 0.05, "{found:?}");
        for smooth in [|t: f64| t.exp(), |t: f64| (3.0 * t).sin(), |t: f64| 1.0 / (0.1 + t)] {
            assert_eq!(swing(&seen(smooth)), None);
        }
        // Nor does a parabola in few long steps.
        let few: Vec<(f64, f64)> = (0..12).map(f64::from).map(|t| (t, t * t)).collect();
        assert_eq!(swing(&few), None);
        // What dies within the look leaves the mean.
        assert_eq!(swing(&seen(|t| 1.0 + (-4.0 * t).exp() * (40.0 * t).cos())), None);
    }

    /// Steps of one length.
    fn even(h: f64) -> Vec<[f64; 2]> {
        (1..200).map(|k| [f64::from(k) * h, h]).collect()
    }

    #[test]
    fn what_the_steps_follow_is_not_missed_though_they_grow_later() {
        let outputs = [Output {
            name: "rate",
            unit: "m/s",
            time_exponent: 0.0,
            components: &[],
            doc: "",
        }];
        let rows: Vec<(f64, Vec<f64>)> = seen(|t| t)
            .iter()
            .map(|&(t, _)| (t, vec![(-0.2 * t).exp() * (40.0 * t).cos()]))
            .collect();
        let grown = |until: f64| {
            let mut steps: Vec<_> = even(0.01).into_iter().filter(|[end, _]| *end < until).collect();
            steps.extend(even(0.1).into_iter().filter(|[end, _]| *end > until));
            missing(&outputs, &rows, &[0.0], &[1e-5], &steps).len()
        };
        assert_eq!([0.4, 0.9, 1.05].map(grown), [1, 1, 0]);
    }

    #[test]
    fn slow_and_small_swings_are_not_missed() {
        let output = |name, unit| Output {
            name,
            unit,
            time_exponent: 0.0,
            components: &[],
            doc: "",
        };
        let outputs = [output("quick", "N"), output("little", "N"), output("alone", "m")];
        let values = |t: f64| {
            let quick = (40.0 * t).cos();
            vec![1.0 + quick, 1e-6 * quick, 1.0 + 1e-3 * quick]
        };
        let rows: Vec<(f64, Vec<f64>)> = seen(|t| t).iter().map(|&(t, _)| (t, values(t))).collect();
        let found = missing(&outputs, &rows, &values(1.0), &[1e-5; 3], &even(0.1));
        let of: Vec<usize> = found.iter().map(|missed| missed.output).collect();
        assert_eq!(of, [0, 2], "{found:?}");
        assert!(missing(&outputs, &rows, &values(1.0), &[1e-5; 3], &even(0.01)).is_empty());
        // Of small things a small number is all.
        let found = missing(&outputs, &rows, &values(1.0), &[1e-5, 1e-8, 1e-5], &even(0.1));
        assert!(found.len() == 3 && found[1].output == 1, "{found:?}");
    }

    #[test]
    fn what_the_run_shows_is_not_missed() {
        let missed = Missed {
            output: 0,
            column: 0,
            swing: swing(&seen(|t| (40.0 * t).cos().abs())).unwrap(),
            part: 0.5,
        };
        let rows = |of: fn(f64) -> f64| -> Vec<(f64, Vec<f64>)> {
            (0..=200)
                .map(|k| f64::from(k) / 100.0)
                .map(|t| (t, vec![of(t)]))
                .collect()
        };
        assert!(shows(&rows(|t| (40.0 * t).cos().abs()), 1.0, &missed));
        assert!(!shows(&rows(|t| 0.6 + 0.05 * (40.0 * t).cos()), 1.0, &missed));
        // Rows far apart show nothing.
        let few: Vec<_> = rows(|t| (40.0 * t).cos().abs()).into_iter().step_by(10).collect();
        assert!(!shows(&few, 1.0, &missed));
    }
}
