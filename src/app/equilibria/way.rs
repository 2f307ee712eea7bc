//! The way of a continuation: which equilibria are asked for, and the scene at each part of it.

use crate::app::results::equilibria::{EquilibriumSettings, Range};
use crate::app::results::error::RunError;
use crate::app::writing::numbers::{digits, short};
use crate::app::writing::sentences::listed;
use crate::equilibrium::{Kind, Uniform};
use crate::{AnyModel, Formulation, Joints, ParamKind, Scene, State};

/// Most names in a sentence.
const MOST: usize = 3;

/// Most continuation steps that may be asked for.
const MOST_STEPS: u32 = 1_000_000;

/// Why there is no scene at a part of the way.
pub(in crate::app) enum Unplaced {
    Model(crate::ModelError),
    Time(String),
}

impl std::fmt::Display for Unplaced {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Unplaced::Model(error) => error.fmt(f),
            Unplaced::Time(text) => f.write_str(text),
        }
    }
}

/// The scene at a part of the way, and its uniform motion; eliminated joints give the same equilibrium
/// with fewer unknowns.
pub(in crate::app) fn placed(
    model: &dyn AnyModel,
    kind: Kind,
    settings: &EquilibriumSettings,
    share: f64,
) -> Result<(Box<dyn Scene>, Uniform), Unplaced> {
    let mut model = model.boxed();
    if let Some(range) = settings.range {
        model.set(range.param, between(range, share));
    }
    let at = uniform(model.as_ref(), kind, settings, share)?;
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(Unplaced::Model)?;
    scene.measure_length(&at);
    Ok((scene, at))
}

/// The uniform motion at a part of the way.
pub(in crate::app) fn uniform(
    model: &dyn AnyModel,
    kind: Kind,
    settings: &EquilibriumSettings,
    share: f64,
) -> Result<Uniform, Unplaced> {
    let t = time(model, settings).map_err(Unplaced::Time)?;
    let mut at = Uniform {
        kind,
        spin: settings.spin,
        ..Uniform::steady(t)
    };
    match (settings.range, kind) {
        (Some(_), _) => {}
        (None, Kind::Steady) => at.spinning = share,
        (None, Kind::Static) => at.scale = share,
    }
    Ok(at)
}

/// The time whose motions and loads hold, s.
pub(in crate::app) fn time(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<f64, String> {
    let t = settings.at.unwrap_or_else(|| model.run().t_end);
    if t >= 0.0 && t.is_finite() {
        Ok(t)
    } else {
        Err(format!("the time is {t} s; it must not be negative"))
    }
}

/// The model with the last value of the parameter that is continued.
pub(in crate::app) fn at_the_end(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Box<dyn AnyModel> {
    let mut model = model.boxed();
    if let Some(range) = settings.range {
        model.set(range.param, range.to);
    }
    model
}

/// That what starts in rotation was asked for at rest, and what that leaves out.
pub(in crate::app) fn stopped(scene: &dyn Scene, at: &Uniform) -> Option<String> {
    let speed = scene.spin(at.t);
    let is_stopped = at.kind == Kind::Steady && at.spin.is_some_and(|spin| spin.velocity.norm() == 0.0);
    (is_stopped && speed > 0.0).then(|| {
        format!(
            "all of the machine is at rest here: the {} rad/s in which it starts are left out (`--spin`), with the gyroscopic moments and the centrifugal forces of what turns",
            digits(speed, 7)
        )
    })
}

/// That what changes with time is taken as it is at the time of an equilibrium; of what turns all is the same at every time.
pub(in crate::app) fn as_it_is(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Option<String> {
    if scene.spin_in(at) > 0.0 {
        return None;
    }
    let names = listed(&scene.timed(at, state), MOST)?;
    Some(format!(
        "What changes with time is taken as it is at t = {} s (`--at`): {names}",
        short(at.t)
    ))
}

pub(in crate::app) fn between(range: Range, share: f64) -> f64 {
    if share == 1.0 {
        range.to
    } else {
        range.from + share * (range.to - range.from)
    }
}

pub(in crate::app) fn check(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<(), RunError> {
    if !(1..=MOST_STEPS).contains(&settings.steps) {
        let text = format!("{} steps: the number lies between 1 and {MOST_STEPS}", settings.steps);
        return Err(RunError::Settings(text));
    }
    let Some(range) = settings.range else {
        return Ok(());
    };
    let Some(param) = model.params().get(range.param) else {
        return Err(RunError::Settings(format!(
            "{} has no parameter {}",
            model.name(),
            range.param
        )));
    };
    let problem = if let ParamKind::Table(_) = param.kind {
        "a file does not change continuously: give one value"
    } else if param.kind == ParamKind::Count {
        "a count does not change continuously: give one value"
    } else if !(range.from.is_finite() && range.to.is_finite()) {
        "the range is not finite"
    } else if range.from == range.to {
        "the range begins where it ends: give one value"
    } else {
        return Ok(());
    };
    Err(RunError::Settings(format!("`{}`: {problem}", param.name)))
}
