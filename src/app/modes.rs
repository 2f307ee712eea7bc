//! Modes of small motions about a relative equilibrium, and how an observer sees them (THEORY 8.1, 8.2);
//! nothing is printed or written here.

use super::cautions;
use super::clock::{Clock, Seconds};
use super::coarse;
use super::finer::FINER;
use super::finer_model::FinerModel;
use super::finer_modes::{self, Found};
use super::pictures::Shapes;
use super::run_error::RunError;
use super::way::{self, EquilibriumSettings};
use crate::equilibrium::{Kind, Uniform, follow};
use crate::model::{DescribedBody, MassProperties};
use crate::modes::{self, Composition, Mode, Wanted, Whirl};
use crate::{AnyModel, Formulation, Joints, Scene, State};

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
    pub settings: EquilibriumSettings,
    /// Time whose motions and loads hold, s.
    pub t: f64,
    /// Spin of the equilibrium, rad/s.
    pub spin: f64,
    /// The modes of the lowest |s|, ascending frequencies.
    pub modes: Vec<SeenMode>,
    /// The same with their shapes.
    pub shapes: Vec<Mode>,
    /// What moves in each of them.
    pub compositions: Vec<Composition>,
    /// What the bodies do in them; `None` where the scene does not draw itself.
    pub pictures: Option<Shapes>,
    /// Whether every mode that moves across the axis whirls on circles, as those about an axisymmetric,
    /// balanced equilibrium do: each is then seen at one frequency in the inertial frame.
    pub is_round: bool,
    /// Largest rate of growth, 1/s; `None` without modes.
    pub margin: Option<f64>,
    /// The meshed bodies, and how they are described.
    pub bodies: Vec<DescribedBody>,
    /// Masses of the bodies at the equilibrium, and of all.
    pub masses: Vec<MassProperties>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of the equilibrium.
    pub newton_iterations: u64,
    /// What the scene warns of at the equilibrium.
    pub warnings: Vec<String>,
    /// How far frequencies are from those of finer meshes, where that was asked for and is not worth a warning.
    pub agreement: Option<String>,
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

    /// Damping ratio -re/|s| in the reference frame: 0 undamped, 1 creeping back, negative where the motion grows;
    /// `None` for s = 0.
    pub fn damping_ratio(&self) -> Option<f64> {
        ratio(self.re, self.im)
    }

    /// How an observer sees the mode who does not turn, of a system that turns with `spin` (rad/s; THEORY 8.1).
    pub fn inertial(&self, spin: f64) -> Inertial {
        match self.circulation {
            _ if spin == 0.0 => Inertial::One(self.im),
            None => Inertial::One(self.im),
            Some(circulation) if circulation.abs() > ROUND && self.im > 0.0 => {
                Inertial::Whirl(spin + self.im * circulation.signum())
            }
            Some(_) => Inertial::Two([spin + self.im, (spin - self.im).abs()]),
        }
    }

    /// The same of all: frequencies, rad/s, not negative.
    pub fn inertial_frequencies(&self, spin: f64) -> Vec<f64> {
        match self.inertial(spin) {
            Inertial::One(im) => vec![im],
            Inertial::Whirl(velocity) => vec![velocity.abs()],
            Inertial::Two([fast, slow]) if fast == slow => vec![fast],
            Inertial::Two(both) => both.to_vec(),
        }
    }

    /// Damping ratios that belong to the [inertial frequencies](Self::inertial_frequencies).
    pub fn inertial_damping_ratios(&self, spin: f64) -> Vec<Option<f64>> {
        let frequencies = self.inertial_frequencies(spin).into_iter();
        frequencies.map(|im| ratio(self.re, im)).collect()
    }

    /// Logarithmic decrements -2 pi re/im that belong to them: of the amplitudes one period apart; `None` without a period.
    pub fn logarithmic_decrements(&self, spin: f64) -> Vec<Option<f64>> {
        let frequencies = self.inertial_frequencies(spin).into_iter();
        frequencies
            .map(|im| (im > 0.0).then(|| -std::f64::consts::TAU * self.re / im))
            .collect()
    }

    /// Sense of the whirl that this observer sees.
    pub fn inertial_whirl(&self, spin: f64) -> Whirl {
        match self.inertial(spin) {
            Inertial::Whirl(velocity) if velocity > 0.0 => Whirl::Forward,
            Inertial::Whirl(velocity) if velocity < 0.0 => Whirl::Backward,
            Inertial::Two(_) if self.im > 0.0 => Whirl::Mixed,
            _ => Whirl::None,
        }
    }
}

/// What an observer sees of a mode who does not turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertial {
    /// The frequency of the reference frame, rad/s: nothing turns, or next to nothing moves across the axis.
    One(f64),
    /// A whirl on circles with this angular velocity, rad/s, positive with the spin.
    Whirl(f64),
    /// Motions of two frequencies at once, spin + im and |spin - im|, rad/s.
    Two([f64; 2]),
}

fn ratio(re: f64, im: f64) -> Option<f64> {
    let size = re.hypot(im);
    (size > 0.0).then(|| -re / size)
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
pub fn modes(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<Modes, RunError> {
    let clock = Clock::start();
    let model = way::at_the_end(model, settings);
    let About {
        mut scene,
        at,
        state,
        shapes,
        modes,
        newton_iterations,
    } = about(model.as_ref(), settings)?;
    let (scene, t) = (scene.as_mut(), at.t);
    let compositions = shapes
        .iter()
        .map(|mode| scene.composition(&at, &state, &mode.shape))
        .collect();
    let mut warnings = cautions::cautioned(model.as_ref(), scene.warnings(&state));
    warnings.extend(crate::equilibrium::untied(scene, &at, &state));
    warnings.extend(coarse::of_equilibrium(scene, &at, &state));
    let seconds = clock.seconds();
    let mut agreement = None;
    match on_finer_meshes(model.as_ref(), settings, scene.unknowns(), &modes) {
        Some(Found::Much(told)) => warnings.push(told),
        Some(Found::Little(told)) => agreement = Some(told),
        // Less than the frequencies themselves say the energies of the modes.
        None => {
            let errors = modes::mesh_errors(scene, &at, &state, &shapes);
            warnings.extend(coarse::of_modes(scene, &errors));
        }
    }
    Ok(Modes {
        settings: *settings,
        t,
        spin: way::spin(scene, &at),
        is_round: is_round(&modes),
        margin: modes::stability_margin(&shapes),
        modes,
        pictures: Shapes::new(scene, &state, &shapes),
        shapes,
        compositions,
        bodies: scene.bodies(),
        masses: scene.masses(&state),
        unknowns: scene.unknowns(),
        constraints: scene.constraints(),
        newton_iterations,
        warnings,
        agreement,
        seconds,
    })
}

/// What finer meshes make of the frequencies, where that is asked for.
fn on_finer_meshes(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
    unknowns: usize,
    modes: &[SeenMode],
) -> Option<Found> {
    if !finer_modes::is_asked(settings.judged, unknowns) {
        return None;
    }
    let finer = FinerModel {
        model: model.boxed(),
        times: FINER,
    };
    let there = about(&finer, settings)
        .ok()
        .filter(|there| there.scene.unknowns() != unknowns)?;
    // Those of a motion that creeps have no frequency.
    let vibrating = |modes: &[SeenMode]| -> Vec<(usize, f64)> {
        let all = modes.iter().enumerate().filter(|(_, mode)| mode.im > mode.re.abs());
        all.map(|(index, mode)| (index, mode.im)).collect()
    };
    finer_modes::compare(&*there.scene, &vibrating(modes), &vibrating(&there.modes))
}

/// Time (s), spin (rad/s) and modes of [`modes`] alone, without how far the meshes are off and what else is told beside them.
pub(super) fn first(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
) -> Result<(f64, f64, Vec<SeenMode>), RunError> {
    let model = way::at_the_end(model, settings);
    let mut about = about(model.as_ref(), settings)?;
    let spin = way::spin(about.scene.as_mut(), &about.at);
    Ok((about.at.t, spin, about.modes))
}

/// Modes about an equilibrium of a scene.
struct About {
    scene: Box<dyn Scene>,
    at: Uniform,
    state: State,
    shapes: Vec<Mode>,
    modes: Vec<SeenMode>,
    newton_iterations: u64,
}

/// The modes of a model about its relative equilibrium.
fn about(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<About, RunError> {
    let t = way::time(model, settings).map_err(RunError::Settings)?;
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(RunError::Model)?;
    let at = Uniform {
        t,
        scale: 1.0,
        kind: Kind::Steady,
        spin: settings.spin,
    };
    let told = |error: crate::SolveError| RunError::Equilibrium(error.to_string());
    let found = follow(scene.as_mut(), &at, 1.0, |_, _| ()).map_err(told)?;
    let state = found.state().cloned().unwrap_or_else(|| scene.uniform_guess(&at));
    let wanted = Wanted { count: settings.count };
    let shapes = modes::modes(scene.as_mut(), &at, &state, wanted).map_err(told)?;
    let modes = shapes
        .iter()
        .map(|mode| SeenMode::of(scene.as_mut(), &at, &state, mode))
        .collect();
    Ok(About {
        scene,
        at,
        state,
        shapes,
        modes,
        newton_iterations: u64::from(found.iterations()),
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
        let found = modes(&rotor, &EquilibriumSettings::default()).unwrap();
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
        let seen: Vec<f64> = found
            .modes
            .iter()
            .flat_map(|mode| mode.inertial_frequencies(spin))
            .collect();
        assert!((seen[0] - q).abs() < 1e-9 && (seen[1] - q).abs() < 1e-9, "{seen:?}");
        // In space damping acts on w0, above the critical speed against it.
        for (mode, sense) in found.modes.iter().zip([Whirl::Forward, Whirl::Backward]) {
            assert_eq!(mode.inertial_whirl(spin), sense);
            let zeta = mode.inertial_damping_ratios(spin)[0].unwrap();
            let decrement = mode.logarithmic_decrements(spin)[0].unwrap();
            assert!((zeta + mode.re / mode.re.hypot(q)).abs() < 1e-12, "{zeta}");
            let exact = std::f64::consts::TAU * zeta / (1.0 - zeta * zeta).sqrt();
            assert!((decrement - exact).abs() < 1e-12, "{decrement} {exact}");
        }
        let straight = SeenMode {
            circulation: Some(0.5),
            ..found.modes[0]
        };
        assert_eq!(straight.inertial_frequencies(2.0).len(), 2);
    }
}
