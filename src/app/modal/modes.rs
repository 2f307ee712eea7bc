//! Modes of small motions about a relative equilibrium, and how an observer sees them (THEORY 8.1, 8.2);
//! nothing is printed or written here.

use super::{finer, kinks};
use crate::app::equilibria::{directions, way};
use crate::app::judged::cautions;
use crate::app::judged::finer_model::FinerModel;
use crate::app::judged::finer_modes::{self, Told};
use crate::app::machine::clock::Clock;
use crate::app::pictures::Shapes;
use crate::app::results::equilibria::EquilibriumSettings;
use crate::app::results::error::RunError;
use crate::app::results::modes::{MANY, Modes, SeenMode, grows, is_round};
use crate::app::results::uniform;
use crate::equilibrium::{Uniform, assembled, follow, glance};
use crate::model::DescribedBody;
use crate::modes::{self, Mode, Wanted};
use crate::{AnyModel, Formulation, Joints, Scene, SolveError, State};

/// Relative distance of two sizes |s| that are one.
const SAME: f64 = 1e-9;

/// The modes of a model about its relative equilibrium at the time of the settings; where a parameter is
/// continued, at its last value.
///
/// # Errors
/// A model that cannot be built; [`RunError::Equilibrium`] where there is no equilibrium or its modes are
/// not found.
pub fn modes(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<Modes, RunError> {
    let clock = Clock::start();
    let model = way::at_the_end(model, settings);
    let mut found = about(model.as_ref(), settings, Look::Long)?;
    let seconds = clock.seconds();
    let told = found.told(model.as_ref(), settings);
    let About {
        mut scene,
        at,
        state,
        shapes,
        modes,
        newton_iterations,
    } = found;
    let (scene, t) = (scene.as_mut(), at.t);
    let compositions = shapes
        .iter()
        .map(|mode| scene.composition(&at, &state, &mode.shape))
        .collect();
    let mut warnings = cautions::cautioned(model.as_ref(), scene.warnings(&state));
    warnings.extend(way::stopped(scene, &at));
    warnings.extend(uniform::taken_along(scene, &at));
    warnings.extend(way::as_it_is(scene, &at, &state));
    warnings.extend(crate::equilibrium::untied(scene, &at, &state));
    warnings.extend(crate::equilibrium::closed(scene));
    warnings.extend(told.equilibrium);
    warnings.extend(fewer(scene, &modes, settings.count));
    warnings.extend(kinks::crossed(scene, &state, &shapes));
    warnings.extend(told.modes);
    warnings.extend(finer_modes::not_asked(settings.judged, scene));
    Ok(Modes {
        settings: *settings,
        t,
        spin: scene.spin_in(&at),
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
        agreement: told.agreement,
        seconds,
    })
}

/// That fewer modes are found than were asked for, where motions are left.
fn fewer(scene: &dyn Scene, modes: &[SeenMode], asked: usize) -> Option<String> {
    // A state has one eigenvalue where a motion has two, and two of them may make one mode.
    let states = scene.states().len();
    let free = scene.unknowns().saturating_sub(scene.constraints() + states);
    let (found, wanted) = (modes.len(), asked.min(free + states.div_ceil(2)));
    (found < wanted).then(|| {
        format!(
            "{found} of the {wanted} modes that were asked for are found: the others have no inertia, share eigenvalue and shape with one of them, or are lost beside masses, dampings or stiffnesses many orders larger"
        )
    })
}

/// What [`modes`] finds of the lowest modes.
pub(in crate::app) struct First {
    /// Time, s.
    pub t: f64,
    /// Spin, rad/s.
    pub spin: f64,
    pub modes: Vec<SeenMode>,
    /// That meshes are too coarse for them.
    pub coarse: Option<String>,
}

/// How long an equilibrium is looked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::app) enum Look {
    /// Where Newton's iteration leads straight to it: beside a run that ends in motion there may be none.
    Short,
    Long,
}

/// The modes of [`modes`] alone, with how far the meshes are off.
pub(in crate::app) fn first(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
    look: Look,
) -> Result<First, RunError> {
    let model = way::at_the_end(model, settings);
    let mut found = about(model.as_ref(), settings, look)?;
    let coarse = found.told(model.as_ref(), settings).modes;
    Ok(First {
        t: found.at.t,
        spin: found.scene.spin_in(&found.at),
        modes: found.modes,
        coarse,
    })
}

/// The same modes of a finer model, where its bodies are others.
pub(super) fn of_finer(
    finer: &dyn AnyModel,
    settings: &EquilibriumSettings,
    own: &[DescribedBody],
) -> Option<Vec<SeenMode>> {
    let there = about(finer, settings, Look::Long).ok()?;
    (there.scene.bodies() != own).then_some(there.modes)
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

impl About {
    /// How far the meshes are off.
    fn told(&mut self, model: &dyn AnyModel, settings: &EquilibriumSettings) -> Told {
        let (scene, at, state) = (self.scene.as_mut(), &self.at, &self.state);
        let there = finer_modes::is_asked(settings.judged, scene.unknowns())
            .then(|| of_finer(&FinerModel::of(model), settings, &scene.bodies()));
        let found = there
            .flatten()
            .and_then(|there| finer::of_modes(scene, &self.modes, &there));
        Told::of(found, scene, (at, state), |scene| {
            modes::mesh_errors(scene, at, state, &self.shapes)
        })
    }
}

/// The modes of a model about its relative equilibrium.
fn about(model: &dyn AnyModel, settings: &EquilibriumSettings, look: Look) -> Result<About, RunError> {
    let t = way::time(model, settings).map_err(RunError::Settings)?;
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(RunError::Model)?;
    let at = Uniform {
        spin: settings.spin,
        ..Uniform::steady(t)
    };
    let told = |error: SolveError| RunError::Equilibrium(error.to_string());
    let found = match look {
        Look::Short => glance(scene.as_mut(), &at),
        Look::Long => follow(scene.as_mut(), &at, 1.0, |_, _| ()),
    };
    let found = found.map_err(told)?;
    let state = found.state().cloned().unwrap_or_else(|| assembled(scene.as_mut(), &at));
    let shapes = lowest_and_growing(scene.as_mut(), &at, &state, settings.count).map_err(told)?;
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

/// The `count` modes of the lowest |s|, and those beyond that grow, as far as they are looked for: of few unknowns all, at rest those of negative
/// directions of the stiffness.
fn lowest_and_growing(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    count: usize,
) -> Result<Vec<Mode>, SolveError> {
    let (found, is_all) = modes::modes_and_growing(scene, at, state, Wanted { count }, MANY)?;
    if is_all || count == 0 || scene.spin_in(at) != 0.0 {
        return Ok(found);
    }
    let negative = directions::whole(scene, at, state, false).map_or(0, |measured| measured.negative);
    let known = found.iter().filter(|mode| mode.im == 0.0 && mode.re > 0.0).count();
    if negative <= known {
        return Ok(found);
    }
    // Of each of them there are two modes, and what vibrates as slowly.
    let count = count + 4 * negative;
    let beyond = modes::modes(scene, at, state, Wanted { count });
    // Those of the highest frequencies may be lost to round-off.
    let Ok(beyond) = beyond else {
        return Ok(found);
    };
    let size = |mode: &Mode| mode.re.hypot(mode.im);
    let largest = beyond.iter().map(size).fold(0.0, f64::max);
    let last = found.iter().map(size).fold(0.0, f64::max);
    let extra = beyond
        .into_iter()
        .filter(|mode| size(mode) > last * (1.0 + SAME) && grows(mode.re, mode.im, largest));
    let mut all: Vec<Mode> = found.into_iter().chain(extra).collect();
    modes::number(&mut all, |mode| [mode.re, mode.im]);
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::results::modes::growth;
    use crate::app::testing::Rotor;
    use crate::modes::Whirl;

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
