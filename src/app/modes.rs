//! Modes of small motions about a relative equilibrium, and how an observer sees them (THEORY 8.1, 8.2);
//! nothing is printed or written here.

use super::cautions;
use super::clock::{Clock, Seconds};
use super::run_error::RunError;
use super::sweep::{self, SweepSettings};
use crate::equilibrium::{Kind, Uniform, follow};
use crate::modes::{self, Mode, Wanted, Whirl};
use crate::{Formulation, Joints, Model, Scene, State};

/// A mode and its sense of whirl.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenMode {
    /// Rate of growth, 1/s.
    pub re: f64,
    /// Angular frequency in the reference frame, which turns with the system, rad/s, not negative.
    pub im: f64,
    /// Sense of the whirl, seen in the reference frame.
    pub whirl: Whirl,
    /// How round it is: 1 on circles with the spin, -1 against it; `None` where nothing moves across the
    /// axis or nothing spins.
    pub circulation: Option<f64>,
}

/// The modes about one equilibrium.
#[derive(Clone, Debug)]
pub struct Modes {
    /// What was asked for.
    pub settings: SweepSettings,
    /// Time whose motions and loads hold, s.
    pub t: f64,
    /// Spin of the equilibrium, rad/s.
    pub spin: f64,
    /// The modes of the lowest |s|, ascending frequencies.
    pub modes: Vec<SeenMode>,
    /// The same with their shapes.
    pub shapes: Vec<Mode>,
    /// Whether every mode that moves across the axis whirls on circles, as those about an axisymmetric,
    /// balanced equilibrium do: each is then seen at one frequency in the inertial frame.
    pub is_round: bool,
    /// Largest rate of growth, 1/s; `None` without modes.
    pub margin: Option<f64>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of the equilibrium.
    pub newton_iterations: u64,
    /// What the scene warns of at the equilibrium.
    pub warnings: Vec<String>,
    /// Time that it took.
    pub seconds: Seconds,
}

/// Circulation of what counts as a circle.
const ROUND: f64 = 0.999;
/// Rates of growth below this part of the largest |s| are round-off.
const NEUTRAL: f64 = 1e-9;

impl SeenMode {
    /// The mode with its sense in the scene.
    pub(super) fn of(scene: &mut dyn Scene, at: &Uniform, state: &State, mode: &Mode) -> Self {
        let circulation = scene.circulation(at, state, &mode.shape);
        Self {
            re: mode.re,
            im: mode.im,
            whirl: Whirl::of(mode.im, circulation),
            circulation,
        }
    }

    /// Whether the motion meets no stiffness: its eigenvalue is zero, and what is pushed along it drifts on.
    pub fn is_still(&self) -> bool {
        self.re == 0.0 && self.im == 0.0
    }

    /// Damping ratio -re/|s|: 0 undamped, 1 creeping back, negative where the motion grows; `None` for s = 0.
    pub fn damping_ratio(&self) -> Option<f64> {
        let size = self.re.hypot(self.im);
        (size > 0.0).then(|| -self.re / size)
    }

    /// Frequencies in the inertial frame, rad/s (THEORY 8.1), of a system that turns with `spin`: about a
    /// round equilibrium the one of the whirl, or the same where nothing moves across the axis; else
    /// both `spin + im` and `|spin - im|`.
    pub fn inertial(&self, spin: f64, is_round: bool) -> Vec<f64> {
        if spin == 0.0 || is_round && self.circulation.is_none() {
            return vec![self.im];
        }
        match self.whirl.inertial(self.im, spin) {
            Some(whirl) if is_round => vec![whirl.abs()],
            _ => vec![spin + self.im, (spin - self.im).abs()],
        }
    }
}

/// Whether all modes that oscillate across the axis do so on circles, and there are some.
pub(super) fn is_round(modes: &[SeenMode]) -> bool {
    let mut across = modes
        .iter()
        .filter(|mode| mode.im > 0.0)
        .filter_map(|mode| mode.circulation);
    let first = across.next();
    first.is_some_and(|first| first.abs() > ROUND) && across.all(|circulation| circulation.abs() > ROUND)
}

/// Rates of growth up to this are round-off beside these modes, 1/s.
pub(super) fn neutral(modes: &[SeenMode]) -> f64 {
    let largest = modes.iter().map(|mode| mode.re.hypot(mode.im)).fold(0.0, f64::max);
    NEUTRAL * largest
}

/// The rate of growth of an unstable equilibrium, 1/s; `None` where it is stable, or neutral to round-off.
pub(super) fn growth(modes: &[SeenMode]) -> Option<f64> {
    let margin = modes.iter().map(|mode| mode.re).reduce(f64::max)?;
    (margin > neutral(modes)).then_some(margin)
}

/// The modes of a model about its relative equilibrium at the time of the settings; where a parameter is
/// continued, at its last value.
///
/// # Errors
/// A model that cannot be built; [`RunError::Equilibrium`] where there is no equilibrium or its modes are
/// not found.
pub fn modes<M: Model>(model: &M, settings: &SweepSettings) -> Result<Modes, RunError> {
    let clock = Clock::start();
    let model = sweep::at_the_end(model, settings);
    let t = sweep::time(&model, settings).map_err(RunError::Settings)?;
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(RunError::Model)?;
    let scene = scene.as_mut();
    let at = Uniform {
        t,
        scale: 1.0,
        kind: Kind::Steady,
        spin: settings.spin,
    };
    let told = |error: crate::SolveError| RunError::Equilibrium(error.to_string());
    let found = follow(scene, &at, 1.0, |_, _| ()).map_err(told)?;
    let state = found.state().cloned().unwrap_or_else(|| scene.uniform_guess(&at));
    let wanted = Wanted { count: settings.count };
    let shapes = modes::modes(scene, &at, &state, wanted).map_err(told)?;
    let modes: Vec<SeenMode> = shapes
        .iter()
        .map(|mode| SeenMode::of(scene, &at, &state, mode))
        .collect();
    Ok(Modes {
        settings: *settings,
        t,
        spin: sweep::spin(scene, &at),
        is_round: is_round(&modes),
        margin: modes::stability_margin(&shapes),
        modes,
        shapes,
        unknowns: scene.unknowns(),
        constraints: scene.constraints(),
        newton_iterations: u64::from(found.iterations()),
        warnings: cautions::cautioned(&model, scene.warnings(&state)),
        seconds: clock.seconds(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    #[test]
    fn a_spring_in_a_turning_frame_whirls_round() {
        // s^2 + 2 (d +- i W) s + w0^2 - W^2 = 0 of z = x + i y: internal damping d = 0.01 w0.
        let rotor = Rotor {
            omega: 10.0,
            ..Rotor::default()
        };
        let found = modes(&rotor, &SweepSettings::default()).unwrap();
        let (w0, spin, d) = (50f64.sqrt(), 10.0, 0.01 * 50f64.sqrt());
        // s = -i W - d +- sqrt((d + i W)^2 - (w0^2 - W^2)) = -i W - d +- (p + i q).
        let (re, im) = (d * d - w0 * w0, 2.0 * d * spin);
        let size = re.hypot(im);
        let (p, q) = ((0.5 * (size + re)).sqrt(), (0.5 * (size - re)).sqrt());
        let expected = [(p - d, spin - q), (-p - d, spin + q)];
        assert_eq!(found.modes.len(), 2);
        for (mode, (re, im)) in found.modes.iter().zip(expected) {
            assert!(
                (mode.re - re).abs() < 1e-9 && (mode.im - im).abs() < 1e-9,
                "{mode:?} {re} {im}"
            );
            assert_eq!(mode.whirl, Whirl::Backward);
        }
        // Faster than critical: the forward whirl of the shaft falls back in the frame, and grows.
        assert!(found.is_round && growth(&found.modes) == found.margin, "{found:?}");
        let seen: Vec<f64> = found.modes.iter().flat_map(|mode| mode.inertial(spin, true)).collect();
        assert!((seen[0] - q).abs() < 1e-9 && (seen[1] - q).abs() < 1e-9, "{seen:?}");
        assert_eq!(found.modes[0].inertial(2.0, false).len(), 2);
    }
}
