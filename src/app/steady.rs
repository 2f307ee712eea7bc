//! Relative equilibria from rest up to the spin at a time.
use super::clock::Seconds;
use super::history::History;
use super::run::{RunError, RunSettings};
use crate::model::FrameState;
use crate::{Joints, Model, SolveError};
/// Relative equilibria at growing spin.
#[derive(Clone, Debug)]
pub struct SteadyResult {
    /// Time whose spin is reached, s.
    pub t: f64,
    /// Spin at that time, rad/s.
    pub spin: f64,
    /// What became of linear joints.
    pub joints: Joints,
    /// Outputs over the spin, one row for each step of the continuation.
    pub history: History,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of all steps.
    pub newton_iterations: u64,
    /// Time that it took.
    pub seconds: Seconds,
    /// What the reader must know.
    pub notes: Vec<String>,
    /// Why the last equilibrium is not that of the full spin.
    pub incomplete: Option<SolveError>,
}
/// X
pub fn steady<M: Model>(model: &M, settings: &RunSettings) -> Result<SteadyResult, RunError> {
    let _ = (model, settings);
    todo!()
}
pub(super) fn frame_state<M: Model>(model: &M, joints: Joints, t: f64) -> Result<FrameState, RunError> {
    let _ = (model, joints, t);
    todo!()
}
