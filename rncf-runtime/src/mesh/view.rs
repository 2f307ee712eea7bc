//! A scene as the application sees it.

use super::parts::{ObservedSpec, Parts};
use super::scene::{MeshScene, Regime};
use crate::model::{FrameState, Scene};
use crate::system::State;
use crate::vector::norm;

impl<P: Parts> Scene for MeshScene<P> {
    fn output_columns(&self) -> usize {
        self.parts.output_columns()
    }

    fn outputs_need_acceleration(&self) -> bool {
        self.observed.iter().any(|observed| {
            matches!(
                observed,
                ObservedSpec::Reaction { .. } | ObservedSpec::Marker { derivative: 2, .. }
            )
        })
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        self.load_state(state);
        self.evaluate_outputs(state.t, 1.0, &state.lambda, out);
    }

    fn rest(&self, t: f64) -> State {
        let q = self.shape();
        let v = vec![0.0; q.len()];
        self.unknowns_from(t, &q, &v, &[])
    }

    fn frame_state(&mut self, state: &State) -> FrameState {
        self.load_state(state);
        let [q, v] = self.vectors_in_frames([&self.buffers.q, &self.buffers.v]);
        let poses = self.poses();
        FrameState {
            t: state.t,
            q,
            v,
            poses,
        }
    }

    fn state_of_frame(&self, frame: &FrameState) -> State {
        self.unknowns_from(frame.t, &frame.q, &frame.v, &frame.poses)
    }

    fn is_referenced(&self) -> bool {
        self.formulation == crate::model::Formulation::Rncf
    }

    fn steady_residual(&mut self, t: f64, scale: f64, x: &[f64], out: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load(t, &[], [x, &zeros, &zeros], Regime::Steady(scale));
        self.full_force(t, scale * scale);
        self.layout.project(&self.buffers.force, out);
    }

    fn steady_tangent(&mut self, t: f64, scale: f64, x: &[f64], values: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load(t, &[], [x, &zeros, &zeros], Regime::Steady(scale));
        let mut damping = vec![0.0; values.len()];
        self.full_tangent(t, scale * scale, values, &mut damping);
    }

    fn steady_outputs(&mut self, t: f64, scale: f64, x: &[f64], out: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load(t, &[], [x, &zeros, &zeros], Regime::Steady(scale));
        self.evaluate_outputs(t, scale * scale, &[], out);
    }

    fn steady_obstacle(&self, t: f64) -> Option<String> {
        self.obstacle(t)
    }

    fn spin(&self, t: f64) -> f64 {
        let frames = self.motions(t);
        self.bodies
            .iter()
            .map(|body| norm(frames[body.spec.frame].spin))
            .fold(0.0, f64::max)
    }
}
