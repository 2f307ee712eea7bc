//! Relative equilibria at constant spin, from rest up to the spin at a time; nothing is printed or
//! written here.

use super::clock::{Clock, Seconds};
use super::envelopes::Envelopes;
use super::history::History;
use super::run::{RunError, RunSettings};
use crate::equilibrium::{self, Uniform, follow};
use crate::error::SolveErrorKind;
use crate::model::FrameState;
use crate::{Formulation, Joints, Model, Scene, SolveError, State};

/// Relative equilibria at growing spin; always in referenced coordinates with eliminated joints.
#[derive(Clone, Debug)]
pub struct SteadyResult {
    /// Time whose spin is reached, s.
    pub t: f64,
    /// Spin at that time, rad/s.
    pub spin: f64,
    /// Outputs over the spin, one row for each step of the continuation.
    pub history: History,
    /// Largest section forces and stresses of the bodies, over the rows of the history.
    pub envelopes: Envelopes,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of all steps.
    pub newton_iterations: u64,
    /// What the scene warns of at the full spin.
    pub warnings: Vec<String>,
    /// Time that it took.
    pub seconds: Seconds,
    /// Why the last equilibrium is not that of the full spin; `None` where it is.
    pub incomplete: Option<SolveError>,
}

/// Rows close enough for a chart; a power of two, so that the scales are exact.
const LARGEST_STEP: f64 = 1.0 / 32.0;

/// Follows the relative equilibria of a model from rest to the spin at `settings.t_end` (`None`: the
/// model's end time); no other setting is used.
///
/// # Errors
/// A model that cannot be built; [`RunError::Start`] where no equilibrium exists, with the frame or
/// load that stands against it; [`RunError::Steady`] with the rows found where the way ends early.
pub fn steady<M: Model>(model: &M, settings: &RunSettings) -> Result<SteadyResult, RunError> {
    let clock = Clock::start();
    let t = settings.t_end.unwrap_or(model.run().t_end);
    if !(t >= 0.0 && t.is_finite()) {
        return Err(RunError::Settings(format!(
            "the time is {t} s; it must not be negative"
        )));
    }
    let mut scene = referenced(model)?;
    let spin = scene.spin(t);
    let at = Uniform::steady(t);
    let mut history = History::new::<M>("spin", "rad/s");
    let mut envelopes = Envelopes::new(scene.as_ref(), &history.key);
    let mut row = vec![0.0; scene.output_columns()];
    let mut spoiled = None;
    let mut newton_iterations = 0;
    let mut record = |scene: &mut dyn Scene, scale: f64, state: &State| {
        if spoiled.is_none() {
            scene.uniform_outputs(&at.scaled(scale), state, &mut row);
            spoiled = history.push(scale * spin, &row).err();
            envelopes.meet_uniform(scene, &at.scaled(scale), scale * spin, state);
        }
    };
    let mut rest = scene.uniform_guess(&at);
    scene.uniform_state(&at.scaled(0.0), &mut rest);
    record(scene.as_mut(), 0.0, &rest);
    let outcome = follow(scene.as_mut(), &at, LARGEST_STEP, |scene, step| {
        newton_iterations += u64::from(step.iterations);
        record(scene, step.scale, &step.state);
    });
    // Where no equilibrium is found the warning may say why.
    let last = outcome.as_ref().ok().and_then(equilibrium::Equilibrium::state);
    let mut warnings = scene.warnings(last.unwrap_or(&rest));
    warnings.extend(envelopes.warning());
    let incomplete = match (outcome, spoiled) {
        (Err(error), _) if newton_iterations == 0 => return Err(RunError::Start(error)),
        (Err(error), _) => Some(error),
        (Ok(_), Some(text)) => Some(SolveError {
            kind: SolveErrorKind::NoEquilibrium(text),
            t,
            h: 0.0,
            worst: None,
        }),
        (Ok(found), None) => {
            newton_iterations = u64::from(found.iterations());
            None
        }
    };
    let result = SteadyResult {
        t,
        spin,
        history,
        envelopes,
        unknowns: scene.unknowns(),
        constraints: scene.constraints(),
        newton_iterations,
        warnings,
        seconds: clock.seconds(),
        incomplete,
    };
    match result.incomplete {
        None => Ok(result),
        Some(_) => Err(RunError::Steady(Box::new(result))),
    }
}

/// Nodal vectors of the relative equilibrium with the spin at `t`, for a start in any formulation.
pub(super) fn frame_state<M: Model>(model: &M, t: f64) -> Result<FrameState, RunError> {
    let mut scene = referenced(model)?;
    let found = equilibrium::steady(scene.as_mut(), t).map_err(RunError::Start)?;
    Ok(scene.frame_state(found.state().unwrap_or(&scene.rest(t))))
}

/// Eliminated joints give the same equilibrium with fewer unknowns.
fn referenced<M: Model>(model: &M) -> Result<Box<dyn Scene>, RunError> {
    model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(RunError::Model)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::run::run;
    use crate::app::testing::Rotor;
    use crate::{Options, Start};

    #[test]
    fn the_spring_stretches_by_the_centrifugal_force() {
        let rotor = Rotor::default();
        let result = steady(&rotor, &RunSettings::default()).unwrap();
        assert_eq!((result.spin, result.unknowns), (3.0, 2));
        assert_eq!(result.history.keys.first(), Some(&0.0));
        assert_eq!(result.history.keys.last(), Some(&3.0));
        assert!(result.history.keys.len() > 10 && result.history.keys.is_sorted());
        for (spin, x) in result.history.keys.iter().zip(result.history.column(0)) {
            let exact = 2.0 * 50.0 / (50.0 - spin * spin);
            assert!((x - exact).abs() < 1e-12, "{x} {exact}");
        }
    }

    #[test]
    fn a_start_in_equilibrium_stays_there_in_both_formulations() {
        for formulation in [Formulation::Rncf, Formulation::Ancf] {
            let settings = RunSettings {
                start: Start::Steady,
                formulation,
                options: Options {
                    rtol: 1e-9,
                    ..Options::default()
                },
                ..RunSettings::default()
            };
            let result = run(&Rotor::default(), &settings).unwrap();
            let (low, high) = result.history.extremes(0).unwrap();
            let exact = 2.0 * 50.0 / 41.0;
            assert!((low.value - exact).abs() < 1e-6 && (high.value - exact).abs() < 1e-6);
        }
    }
}
