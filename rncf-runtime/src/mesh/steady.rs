//! Outputs, energy, changes of formulation, and relative equilibria of a scene.

use super::evaluate::{MAX_SIZE, weighted};
use super::frame::{FrameMotion, cross, norm, subtract};
use super::layout::VectorKind;
use super::parts::{LoadKind, ObservedSpec, Parts, PointQuantity};
use super::scene::{MeshBody, MeshScene, Regime, undeformed};
use crate::model::{FrameState, Scene};
use crate::system::{State, System};

/// Relative size below which a change of a motion, or a load's component across the spin, counts as
/// zero.
const NEGLIGIBLE: f64 = 1e-9;

/// Time after which a uniform motion must still be the same, s.
const A_WHILE: f64 = 1e-3;

/// Whether two spins (rad/s) or accelerations (m/s^2) differ by more than round-off; a motion that
/// sets out smoothly from rest counts as uniform there.
fn differs(a: [f64; 3], b: [f64; 3]) -> bool {
    norm(subtract(a, b)) > NEGLIGIBLE * norm(a).max(norm(b)).max(1.0)
}

impl<P: Parts> MeshScene<P> {
    /// Energy of a conservative model: kinetic, strain, and potential of gravity and dead forces.
    pub(super) fn total_energy(&mut self, state: &State) -> Option<f64> {
        if !self.parts.conservative() {
            return None;
        }
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        let gravity = self.gravity(state.t);
        let mut energy = 0.0;
        for (index, body) in self.bodies.iter().enumerate() {
            let (dimension, size) = (body.spec.dimension(), body.spec.element_size());
            let pull = self.buffers.frames[body.frame].direction_to_frame(gravity);
            for element in 0..body.spec.count {
                let mut q = [0.0; MAX_SIZE];
                let mut v = [0.0; MAX_SIZE];
                body.connectivity.gather(element, &self.buffers.q, &mut q[..size]);
                body.connectivity.gather(element, &self.buffers.v, &mut v[..size]);
                energy += self.parts.energy(index, element, &q[..size]);
                let count = body.spec.orders.len();
                for a in 0..count {
                    for b in 0..count {
                        let mass = body.mass[a * count + b];
                        for c in 0..dimension {
                            energy += 0.5 * mass * v[a * dimension + c] * v[b * dimension + c];
                            if body.spec.orders[b] == 0 {
                                // The shape functions of positions add up to one.
                                energy -= mass * q[a * dimension + c] * pull[body.spec.axes[c]];
                            }
                        }
                    }
                }
            }
        }
        for (index, load) in self.loads.iter().enumerate() {
            if let (LoadKind::Force { .. }, Some(point)) = (load.kind, &self.load_points[index]) {
                let body = &self.bodies[point.body];
                let force = self.parts.load(index, state.t);
                let components = body.connectivity.element(point.element);
                let position = self.spread(
                    body,
                    weighted(&self.buffers.q, components, body.spec.dimension(), &point.values),
                );
                let frames = &self.buffers.frames;
                let position =
                    frames[load.frame].direction_to_frame(frames[body.frame].direction_to_inertial(position));
                energy -= force[0] * position[0] + force[1] * position[1] + force[2] * position[2];
            }
        }
        Some(energy)
    }

    /// Components in the body's order to three frame axes.
    fn spread(&self, body: &MeshBody, components: [f64; 3]) -> [f64; 3] {
        let mut vector = [0.0; 3];
        for (place, &axis) in body.spec.axes.iter().enumerate() {
            vector[axis] = components[place];
        }
        vector
    }

    /// A vector of a body in its own axes, in the declared frame.
    fn in_declared(&self, body: &MeshBody, what: PointQuantity, [q, v]: [[f64; 3]; 2]) -> [f64; 3] {
        if body.frame == body.spec.frame {
            return if what == PointQuantity::Velocity { v } else { q };
        }
        let frame = &self.buffers.frames[body.spec.frame];
        match what {
            PointQuantity::Position => frame.point_to_frame(q),
            PointQuantity::Slope => frame.direction_to_frame(q),
            PointQuantity::Velocity => frame.rate_to_frame(subtract(q, frame.position), subtract(v, frame.velocity)),
        }
    }

    /// Value of something observed at the loaded state; forces must be evaluated for reactions.
    fn observe(&self, index: usize) -> f64 {
        match self.observed[index] {
            ObservedSpec::Point {
                body, what, component, ..
            } => {
                let Some(point) = &self.observed_points[index] else {
                    return f64::NAN;
                };
                let body = &self.bodies[body];
                let weights = if what == PointQuantity::Slope {
                    &point.slopes
                } else {
                    &point.values
                };
                let components = body.connectivity.element(point.element);
                let at = |full: &[f64]| self.spread(body, weighted(full, components, body.spec.dimension(), weights));
                self.in_declared(body, what, [at(&self.buffers.q), at(&self.buffers.v)])[component]
            }
            ObservedSpec::Reaction {
                joint,
                moment,
                component,
            } => self.reaction(joint, moment)[component],
        }
    }

    /// What a joint exerts on its body, in the joint's frame: the unbalanced generalised force on
    /// its node is what the joint must supply; `m = slope x force on the slope`.
    fn reaction(&self, joint: usize, moment: bool) -> [f64; 3] {
        let condition = &self.conditions[joint];
        let spec = &self.joints[joint];
        let body = &self.bodies[spec.body];
        let dimension = body.spec.dimension();
        let of = |vector: usize, full: &[f64]| {
            let place = self.layout.offset(vector);
            let mut components = [0.0; 3];
            components[..dimension].copy_from_slice(&full[place..place + dimension]);
            self.spread(body, components)
        };
        let vector = if moment {
            cross(
                of(condition.slope, &self.buffers.q),
                of(condition.slope, &self.buffers.force),
            )
        } else {
            of(condition.position, &self.buffers.force)
        };
        let frames = &self.buffers.frames;
        if spec.frame == body.frame {
            return vector;
        }
        frames[spec.frame].direction_to_frame(frames[body.frame].direction_to_inertial(vector))
    }

    /// Output columns at the loaded state.
    fn evaluate_outputs(&mut self, t: f64, load_scale: f64, out: &mut [f64]) {
        if self.outputs_need_acceleration() {
            self.full_force(t, load_scale);
        }
        let observed: Vec<f64> = (0..self.observed.len()).map(|index| self.observe(index)).collect();
        self.parts.outputs(t, &observed, out);
    }

    /// Nodal vectors of all bodies, from the full arrays, in their declared frames.
    fn vectors_in_frames(&self, full: [&[f64]; 2]) -> [Vec<f64>; 2] {
        let mut result = [Vec::new(), Vec::new()];
        self.each_vector(|body, order, place| {
            let dimension = body.spec.dimension();
            let at = |full: &[f64]| {
                let mut components = [0.0; 3];
                components[..dimension].copy_from_slice(&full[place..place + dimension]);
                self.spread(body, components)
            };
            let pair = [at(full[0]), at(full[1])];
            let (position, rate) = if order == 0 {
                (
                    PointQuantity::Position,
                    self.in_declared(body, PointQuantity::Velocity, pair),
                )
            } else {
                let frame = &self.buffers.frames[body.spec.frame];
                let rate = if body.frame == body.spec.frame {
                    pair[1]
                } else {
                    frame.rate_to_frame(pair[0], pair[1])
                };
                (PointQuantity::Slope, rate)
            };
            let value = self.in_declared(body, position, pair);
            result[0].extend(body.spec.axes.iter().map(|&axis| value[axis]));
            result[1].extend(body.spec.axes.iter().map(|&axis| rate[axis]));
        });
        result
    }

    /// Calls back with every nodal vector: body, order, place in the full arrays.
    fn each_vector(&self, mut each: impl FnMut(&MeshBody, usize, usize)) {
        for body in &self.bodies {
            for within in 0..body.spec.vectors() {
                let place = within % body.spec.vectors_per_node;
                let local = body
                    .spec
                    .connectivity
                    .iter()
                    .position(|&other| other == place)
                    .unwrap_or(0);
                each(
                    body,
                    body.spec.orders[local],
                    self.layout.offset(body.first_vector + within),
                );
            }
        }
    }

    /// The unknowns of nodal vectors in declared frames.
    fn unknowns_from(&self, t: f64, q: &[f64], v: &[f64]) -> State {
        let mut frames = vec![FrameMotion::INERTIAL; self.parts.frame_count()];
        self.parts.frames(t, &mut frames);
        let (mut full_q, mut full_v) = (q.to_vec(), v.to_vec());
        self.each_vector(|body, order, place| {
            if body.frame == body.spec.frame {
                return;
            }
            let dimension = body.spec.dimension();
            let frame = &frames[body.spec.frame];
            let at = |full: &[f64]| {
                let mut components = [0.0; 3];
                components[..dimension].copy_from_slice(&full[place..place + dimension]);
                self.spread(body, components)
            };
            let (value, rate) = (at(q), at(v));
            let mut inertial = [frame.direction_to_inertial(value), frame.rate_to_inertial(value, rate)];
            if order == 0 {
                inertial[0] = frame.point_to_inertial(value);
                inertial[1] = std::array::from_fn(|i| inertial[1][i] + frame.velocity[i]);
            }
            for (component, &axis) in body.spec.axes.iter().enumerate() {
                full_q[place + component] = inertial[0][axis];
                full_v[place + component] = inertial[1][axis];
            }
        });
        let mut state = State::zeros(t, self.unknowns(), self.constraints());
        self.layout.project(&full_q, &mut state.x);
        self.layout.project(&full_v, &mut state.v);
        state
    }
}

impl<P: Parts> Scene for MeshScene<P> {
    fn output_columns(&self) -> usize {
        self.parts.output_columns()
    }

    fn outputs_need_acceleration(&self) -> bool {
        self.observed
            .iter()
            .any(|observed| matches!(observed, ObservedSpec::Reaction { .. }))
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        self.evaluate_outputs(state.t, 1.0, out);
    }

    fn rest(&self, t: f64) -> State {
        let mut q = Vec::with_capacity(self.layout.components());
        for body in &self.bodies {
            for within in 0..body.spec.vectors() {
                let (node, place) = (within / body.spec.vectors_per_node, within % body.spec.vectors_per_node);
                let local = body
                    .spec
                    .connectivity
                    .iter()
                    .position(|&other| other == place)
                    .unwrap_or(0);
                q.extend(undeformed(&body.spec, node, body.spec.orders[local]));
            }
        }
        let v = vec![0.0; q.len()];
        self.unknowns_from(t, &q, &v)
    }

    fn frame_state(&mut self, state: &State) -> FrameState {
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        let [q, v] = self.vectors_in_frames([&self.buffers.q, &self.buffers.v]);
        FrameState { t: state.t, q, v }
    }

    fn state_of_frame(&self, frame: &FrameState) -> State {
        self.unknowns_from(frame.t, &frame.q, &frame.v)
    }

    fn is_referenced(&self) -> bool {
        self.formulation == crate::model::Formulation::Rncf
    }

    fn steady_residual(&mut self, t: f64, scale: f64, x: &[f64], out: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load_state(t, x, &zeros, &zeros, Regime::Steady(scale));
        self.full_force(t, scale * scale);
        self.layout.project(&self.buffers.force, out);
    }

    fn steady_tangent(&mut self, t: f64, scale: f64, x: &[f64], values: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load_state(t, x, &zeros, &zeros, Regime::Steady(scale));
        let mut damping = vec![0.0; values.len()];
        self.full_tangent(t, scale * scale, values, &mut damping);
    }

    fn steady_outputs(&mut self, t: f64, scale: f64, x: &[f64], out: &mut [f64]) {
        let zeros = vec![0.0; x.len()];
        self.load_state(t, x, &zeros, &zeros, Regime::Steady(scale));
        self.evaluate_outputs(t, scale * scale, out);
    }

    fn steady_obstacle(&self, t: f64) -> Option<String> {
        let motions_at = |t: f64| {
            let mut frames = vec![FrameMotion::INERTIAL; self.parts.frame_count()];
            self.parts.frames(t, &mut frames);
            frames
        };
        let (frames, later) = (motions_at(t), motions_at(t + A_WHILE));
        for (index, load) in self.loads.iter().enumerate() {
            if self.parts.load_varies(index) {
                return Some(format!("load `{}` varies with time", load.name));
            }
        }
        for body in &self.bodies {
            let (frame, next) = (&frames[body.spec.frame], &later[body.spec.frame]);
            let spin = norm(frame.spin);
            let name = self.parts.frame_name(body.spec.frame);
            let pull = |frame: &FrameMotion| frame.direction_to_frame(frame.acceleration);
            if differs(frame.spin, next.spin) || differs(pull(frame), pull(next)) {
                return Some(format!(
                    "frame `{name}` does not move uniformly: its spin or acceleration changes"
                ));
            }
            for (index, load) in self.loads.iter().enumerate() {
                if load.frame == body.spec.frame || spin == 0.0 {
                    continue;
                }
                let value = frames[load.frame].direction_to_inertial(self.parts.load(index, t));
                let axis = frame.direction_to_inertial(frame.spin);
                let acts = match load.kind {
                    LoadKind::Gravity => true,
                    LoadKind::Force { body: other, .. } | LoadKind::Moment { body: other, .. } => {
                        std::ptr::eq(body, &self.bodies[other])
                    }
                };
                if acts && norm(cross(axis, value)) > NEGLIGIBLE * spin * norm(value) {
                    return Some(format!(
                        "load `{}` keeps its direction while body `{}` turns with frame `{name}`",
                        load.name, body.spec.name
                    ));
                }
            }
        }
        for condition in &self.conditions {
            let joint = &self.joints[condition.joint];
            let body = &self.bodies[joint.body].spec;
            if joint.frame != body.frame
                && norm(frames[body.frame].spin) > 0.0
                && condition.slope_kind != VectorKind::Free
            {
                return Some(format!(
                    "joint `{}` holds body `{}` in a frame that does not turn with it",
                    joint.name, body.name
                ));
            }
            if joint.frame != body.frame {
                let spin = frames[body.frame].spin;
                let at = frames[body.frame].direction_to_frame(subtract(
                    frames[joint.frame].point_to_inertial(condition.data.point),
                    frames[body.frame].position,
                ));
                if norm(cross(spin, at)) > NEGLIGIBLE * norm(spin) * norm(at).max(1e-300) {
                    return Some(format!(
                        "joint `{}` holds body `{}` at a point off its axis of rotation",
                        joint.name, body.name
                    ));
                }
            }
        }
        None
    }

    fn spin(&self, t: f64) -> f64 {
        let mut frames = vec![FrameMotion::INERTIAL; self.parts.frame_count()];
        self.parts.frames(t, &mut frames);
        self.bodies
            .iter()
            .map(|body| norm(frames[body.spec.frame].spin))
            .fold(0.0, f64::max)
    }
}
