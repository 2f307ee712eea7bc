//! The start of a run in its relative equilibrium.

use crate::app::results::error::RunError;
use crate::model::FrameState;
use crate::{AnyModel, Formulation, Joints, Scene, equilibrium};

/// Nodal vectors of the relative equilibrium with the spin at `t`, for a start in any formulation.
pub(in crate::app) fn frame_state(model: &dyn AnyModel, t: f64) -> Result<FrameState, RunError> {
    let scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(RunError::Model)?;
    frame_state_of(scene, t)
}

/// The same on meshes with this number of elements for each one; `None` where no mesh would change.
pub(in crate::app) fn finer_frame_state(model: &dyn AnyModel, times: usize, t: f64) -> Option<FrameState> {
    let scene = model.build(Formulation::Rncf, Joints::Eliminated).ok()?;
    frame_state_of(scene.with_finer_meshes(times)?.ok()?, t).ok()
}

fn frame_state_of(mut scene: Box<dyn Scene>, t: f64) -> Result<FrameState, RunError> {
    let found = equilibrium::steady(scene.as_mut(), t).map_err(RunError::Start)?;
    Ok(scene.frame_state(found.state().unwrap_or(&scene.rest(t))))
}
