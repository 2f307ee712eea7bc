//! How a run starts. What it takes to find that is done in the axes of the bodies, so that the start is the same in any formulation.

use crate::app::judged::finer::Judging;
use crate::app::judged::finer_modes;
use crate::app::results::equilibria::EquilibriumSettings;
use crate::app::results::error::RunError;
use crate::app::results::uniform;
use crate::app::writing::numbers::digits;
use crate::equilibrium::{self, Uniform};
use crate::system::AsSystem;
use crate::{AnyModel, Formulation, Joints, Scene, Start, State, set_in_motion};

/// The state in which a run of the scene starts, and what is told of it.
pub(in crate::app) fn begin(
    model: &dyn AnyModel,
    start: Start,
    scene: &dyn Scene,
    judged: Judging,
) -> Result<(State, Vec<String>), RunError> {
    if start == Start::Rest {
        return Ok((scene.rest(0.0), Vec::new()));
    }
    let mut own = model.build(Formulation::Rncf, joints(start)).map_err(RunError::Model)?;
    let state = state(own.as_mut(), start)?;
    let told = match start {
        Start::Steady => doubts(own.as_mut(), &state, judged),
        Start::Rest | Start::Moving => Vec::new(),
    };
    Ok((scene.state_of_frame(&own.frame_state(&state)), told))
}

/// The same of a scene with this number of elements for each one of the model; `None` where no mesh would change.
pub(in crate::app) fn begin_finer(
    model: &dyn AnyModel,
    start: Start,
    scene: &dyn Scene,
    times: usize,
) -> Option<State> {
    if start == Start::Rest {
        return Some(scene.rest(0.0));
    }
    let own = model.build(Formulation::Rncf, joints(start)).ok()?;
    let mut own = own.with_finer_meshes(times)?.ok()?;
    let state = state(own.as_mut(), start).ok()?;
    let frame = own.frame_state(&state);
    Some(scene.state_of_frame(&frame))
}

/// What joints prescribe sets in motion what they hold where it is a constraint, and no value that something has.
fn joints(start: Start) -> Joints {
    match start {
        Start::Moving => Joints::Multipliers,
        Start::Rest | Start::Steady => Joints::Eliminated,
    }
}

fn state(scene: &mut dyn Scene, start: Start) -> Result<State, RunError> {
    let mut state = scene.rest(0.0);
    match start {
        Start::Rest => {}
        Start::Moving => set_in_motion(scene.as_system(), &mut state).map_err(RunError::Start)?,
        Start::Steady => {
            let found = equilibrium::steady(scene, 0.0).map_err(RunError::Start)?;
            state = found.state().cloned().unwrap_or(state);
        }
    }
    Ok(state)
}

/// What a start in relative equilibrium is not: that which the model declares, or that which stays.
fn doubts(scene: &mut dyn Scene, state: &State, judged: Judging) -> Vec<String> {
    let at = Uniform::steady(0.0);
    let unstable = if finer_modes::is_asked(judged, scene.unknowns()) {
        uniform::time_of_growth(scene, &at, state, EquilibriumSettings::default().count)
            .ok()
            .flatten()
    } else {
        None
    };
    let unstable = unstable.map(|time| {
        format!(
            "The equilibrium in which the run starts is unstable: a disturbance grows by the factor e in {} s, and without one the run stays in it. Give it a disturbance, or start at rest",
            digits(time, 4)
        )
    });
    uniform::taken_along(scene, &at).into_iter().chain(unstable).collect()
}
