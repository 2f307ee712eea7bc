//! What is told of the steps of a run.

use super::accumulated::Ended;
use super::compared::{Off, TOLD};
use super::marks::{is_of_motion, told};
use crate::{Output, StepSize};

/// What tells of the steps of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum By {
    /// Radau with a tolerance.
    Radau(f64),
    /// The method of the run with a tolerance.
    Same(f64),
    /// The method of the run with a fixed step, s.
    Step(f64),
}

impl By {
    fn words(self) -> String {
        match self {
            Self::Radau(rtol) => format!("Radau with a tolerance of {rtol:.0e}"),
            Self::Same(rtol) => format!("the same method with a tolerance of {rtol:.0e}"),
            Self::Step(h) => format!("a step of {h:e} s"),
        }
    }
}

/// What parts of outputs say of the steps of a run, and what finds them.
///
/// Where nothing is free to move, nothing vibrates.
pub(super) fn sentence(run: &Ended<'_>, by: By, outputs: &[Output], parts: &[Off], is_free: bool) -> Option<String> {
    let names = told(outputs, parts)?;
    let is_exact = is_exact(run);
    let moves = parts
        .iter()
        .any(|off| off.part > TOLD && is_of_motion(&outputs[off.output]));
    let is_fixed = matches!(run.options.step, StepSize::Fixed(_));
    let finder = by.words();
    if !is_exact && !moves {
        let shorter = if is_fixed { "`--step`" } else { "`--rtol`" };
        let (first, rest) = finder.split_at(1);
        let cause = match is_free {
            true => format!(
                "They follow vibrations that are too quick for the steps, which one method damps and the other keeps. Take a smaller {shorter}, or give the model the damping that such vibrations have."
            ),
            false => {
                format!("Drives move all there is, and these are the errors of the steps. Take a smaller {shorter}.")
            }
        };
        return Some(format!(
            "{}{rest} finds the same motion with other forces, accelerations or energies, which differ by parts of their largest change or value, {names}. {cause}",
            first.to_uppercase()
        ));
    }
    let found = match by {
        By::Radau(rtol) if is_exact && rtol > run.options.rtol => {
            format!("with a tolerance of {rtol:.0e} outputs are so far away that those of this run may be off")
        }
        _ => format!("{finder} finds another motion, from which outputs differ"),
    };
    if let StepSize::Fixed(h) = run.options.step {
        return Some(format!(
            "Steps of {h:e} s are chosen by no tolerance: {found} by parts of their largest change or value, {names}. Take a smaller `--step`, or leave it out."
        ));
    }
    Some(format!(
        "The tolerance of {:e} holds for each step, and errors of {} steps add up: {found} by parts of their largest change or value, {names}. Take {}a smaller `--rtol`.",
        run.options.rtol,
        run.steps,
        if is_exact { "" } else { "`--integrator radau`, or " }
    ))
}

/// Whether the steps of a run are those of a second one by Radau, but for the tolerance.
pub(super) fn is_exact(run: &Ended<'_>) -> bool {
    run.method.is_radau() && run.options.step == StepSize::Adaptive
}
