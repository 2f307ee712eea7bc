//! A scene as the application sees it.

use super::parts::{ObservedSpec, Parts};
use super::scene::{MeshScene, Regime};
use crate::linalg::{Lu, Pattern};
use crate::model::{FrameState, Scene};
use crate::system::{State, System};
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
        let [q, v] = self.initial_shape();
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
        let lambda = self.steady_multipliers(t, scale, x);
        self.load(t, &[], [x, &zeros, &zeros], Regime::Steady(scale));
        self.evaluate_outputs(t, scale * scale, &lambda, out);
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

impl<P: Parts> MeshScene<P> {
    /// Multipliers of a relative equilibrium: `f + C_x^T lambda = 0` in the sense of least squares,
    /// exact where `x` is one.
    fn steady_multipliers(&mut self, t: f64, scale: f64, x: &[f64]) -> Vec<f64> {
        let m = self.constraints();
        let mut lambda = vec![0.0; m];
        if self.constraints.is_empty() {
            return lambda;
        }
        let mut forces = vec![0.0; x.len()];
        self.steady_residual(t, scale, x, &mut forces);
        let state = State {
            x: x.to_vec(),
            ..State::of(self, t)
        };
        let mut jacobian = vec![0.0; self.constraint_pattern.entries()];
        self.constraint_jacobian(&state, &mut jacobian);
        let pattern = &self.constraint_pattern;
        pattern.transpose_multiply_add(-1.0, &jacobian, &forces, &mut lambda);
        let whole = Pattern::new(m, m, (0..m * m).map(|place| (place % m, place / m)));
        let mut normal = vec![0.0; m * m];
        for (column, values) in normal.chunks_exact_mut(m).enumerate() {
            let mut unit = vec![0.0; m];
            unit[column] = 1.0;
            let mut along = vec![0.0; x.len()];
            pattern.multiply_add(1.0, &jacobian, &unit, &mut along);
            pattern.transpose_multiply_add(1.0, &jacobian, &along, values);
        }
        let mut lu = Lu::new(&whole);
        // Constraints that depend on each other have no equilibrium to begin with.
        if lu.factor(&normal).is_ok() {
            lu.solve(&mut lambda);
        }
        lambda
    }
}
