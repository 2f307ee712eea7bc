//! Forces and tangents of all nodal components at a state.

use super::assembly::evaluate;
use super::conditions::Condition;
use super::moments::turned_by_moments;
use super::parts::{LoadKind, Prescribed};
use super::scene::{Buffers, MeshBody, MeshScene, PlaceVector, Regime};
use crate::model::Scene;
use crate::rotation::Rotation;
use crate::system::State;
use crate::vector::add;

/// Degrees of freedom of the largest element.
pub(super) const MAX_SIZE: usize = 32;
/// Most components of a node's vectors that a joint is about, and most of its conditions.
pub(super) const MOST: usize = 9;

/// `sum_a weight_a q_a` of an element.
pub(super) fn weighted(full: &[f64], components: &[usize], dimension: usize, weights: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (place, &component) in components.iter().enumerate() {
        sum[place % dimension] += weights[place / dimension] * full[component];
    }
    sum
}

impl MeshScene {
    /// Fills the full state: prescribed frames, unknowns, free frames, prescribed vectors.
    pub(super) fn load(&mut self, t: f64, turns: &[Rotation], [x, v, a]: [&[f64]; 3], regime: Regime) {
        let buffers = &mut self.buffers;
        self.parts.frames(t, &mut buffers.frames);
        if let Regime::Uniform(scale) = regime {
            for frame in &mut buffers.frames {
                *frame = frame.steady(scale);
            }
        }
        self.layout.expand(x, &mut buffers.q);
        self.layout.expand(v, &mut buffers.v);
        self.layout.expand(a, &mut buffers.a);
        let border = self.layout.vector_components();
        for frame in &self.free {
            let own = border + frame.first..border + frame.first + frame.count();
            let turn = frame.turn.and_then(|turn| turns.get(turn)).copied().unwrap_or_default();
            let [x, v, a] = [&buffers.q, &buffers.v, &buffers.a].map(|full| &full[own.clone()]);
            let parent = buffers.frames[frame.spec.parent];
            buffers.frames[frame.spec.frame] = frame.motion(&parent, turn, x, v, a);
        }
        for frame in &self.fixed {
            buffers.frames[frame.spec.frame] = frame.fixed();
        }
        self.set_prescribed(t, regime);
    }

    /// Fills the full state of a system's state as it moves.
    pub(super) fn load_state(&mut self, state: &State) {
        self.load(state.t, &state.turns, [&state.x, &state.v, &state.a], Regime::Moving);
    }

    /// Fills the full state of the declared start.
    pub(super) fn load_rest(&mut self) {
        let rest = self.rest(0.0);
        self.load_state(&rest);
    }

    /// Fills in what the eliminated conditions prescribe.
    fn set_prescribed(&mut self, t: f64, regime: Regime) {
        let buffers = &mut self.buffers;
        for condition in &self.conditions {
            let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
            let prescribes_directions = condition.prescribes_directions();
            if !condition.position_eliminated && !prescribes_directions {
                continue;
            }
            let mut prescribed = Prescribed::default();
            self.parts
                .prescribed(condition.joint, condition.absolute, t, &condition.data, &mut prescribed);
            if regime != Regime::Moving {
                for values in [&mut prescribed.position, &mut prescribed.slope, &mut prescribed.second] {
                    values[1..].fill([0.0; 3]);
                }
            }
            let mut set = |vector: usize, values: [[f64; 3]; 4]| {
                let place = self.layout.offset(vector);
                let full = [&mut buffers.q, &mut buffers.v, &mut buffers.a, &mut buffers.jerks];
                for (full, value) in full.into_iter().zip(values) {
                    full[place..place + dimension].copy_from_slice(&value[..dimension]);
                }
            };
            if condition.position_eliminated {
                set(condition.vectors[0], prescribed.position);
            }
            if prescribes_directions {
                for (&vector, values) in condition.vectors[1..].iter().zip([prescribed.slope, prescribed.second]) {
                    set(vector, values);
                }
            }
        }
    }

    /// Sum of all gravity loads, inertial axes.
    pub(super) fn gravity(&self, t: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (index, load) in self.loads.iter().enumerate() {
            if load.kind == LoadKind::Gravity {
                sum = add(
                    sum,
                    self.buffers.frames[load.frame].direction_to_inertial(self.parts.load(index, t)),
                );
            }
        }
        sum
    }

    /// `M a + f` of all components at the loaded state; loads are multiplied by `load_scale`.
    pub(super) fn full_force(&mut self, t: f64, load_scale: f64) {
        self.set_fields(t, load_scale);
        let gravity = self.gravity(t).map(|g| load_scale * g);
        let Buffers {
            q,
            v,
            a,
            force,
            frames,
            results,
            ..
        } = &mut self.buffers;
        force.fill(0.0);
        let in_modes = self.in_modes;
        let whole = |body: &&MeshBody| !in_modes || body.modes.is_none();
        for (index, body) in self.bodies.iter().enumerate().filter(|(_, body)| whole(body)) {
            let action = frames[body.frame].action(body.spec.axes, gravity);
            let size = body.spec.element_size();
            let (q, v, a): (&[f64], &[f64], &[f64]) = (q, v, a);
            evaluate(body.spec.count, size, results, |element, result| {
                let mut local = [[0.0; MAX_SIZE]; 3];
                for (values, full) in local.iter_mut().zip([q, v, a]) {
                    body.connectivity.gather(element, full, &mut values[..size]);
                }
                let [q, v, a] = &local;
                self.parts.force(
                    index,
                    element,
                    body.frame == 0,
                    &action,
                    &q[..size],
                    &v[..size],
                    &a[..size],
                    result,
                );
            });
            for element in 0..body.spec.count {
                let local = &results[element * size..(element + 1) * size];
                for (&component, value) in body.connectivity.element(element).iter().zip(local) {
                    force[component] += value;
                }
            }
        }
        self.add_loads(t, load_scale);
        self.add_carried_forces(gravity);
        self.add_fixture_forces(gravity);
        self.add_marker_forces(t, load_scale);
        self.add_density_forces(t, load_scale);
    }

    /// Whether a load acts through a marker, since a free frame feels it.
    fn is_marked(&self, load: usize) -> bool {
        self.marked_loads.iter().any(|marked| marked.load == load)
    }

    /// Force or moment of a load in the axes of its body, in their order.
    fn load_in_body(&self, index: usize, t: f64, body: &MeshBody) -> [f64; 3] {
        let load = &self.loads[index];
        let mut value = self.parts.load(index, t);
        if load.frame != body.frame {
            let frames = &self.buffers.frames;
            value = frames[body.frame].direction_to_frame(frames[load.frame].direction_to_inertial(value));
        }
        match (&load.kind, body.spec.axes) {
            (LoadKind::Moment { .. }, &[first, second]) => [value[3 - first - second], 0.0, 0.0],
            (_, axes) => {
                let mut components = [0.0; 3];
                for (place, &axis) in axes.iter().enumerate() {
                    components[place] = value[axis];
                }
                components
            }
        }
    }

    fn add_loads(&mut self, t: f64, load_scale: f64) {
        for index in 0..self.loads.len() {
            let Some(point) = self.load_points[index].as_ref().filter(|_| !self.is_marked(index)) else {
                continue;
            };
            let body = &self.bodies[point.body];
            let dimension = body.spec.dimension();
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let components = body.connectivity.element(point.element);
            match self.loads[index].kind {
                LoadKind::Gravity | LoadKind::Field { .. } => {}
                LoadKind::Force { .. } => {
                    for (place, &component) in components.iter().enumerate() {
                        let weight = point.weights(PlaceVector::Position)[place / dimension];
                        self.buffers.force[component] -= weight * value[place % dimension];
                    }
                }
                LoadKind::Moment { .. } => {
                    let force = self.moment_at(point, value);
                    for (&of, force) in turned_by_moments(&body.spec).iter().zip(force.chunks_exact(dimension)) {
                        for (place, &component) in components.iter().enumerate() {
                            let weight = point.weights(of)[place / dimension];
                            self.buffers.force[component] -= weight * force[place % dimension];
                        }
                    }
                }
            }
        }
    }

    /// Derivatives of [`MeshScene::full_force`] at the loaded state, on the pattern.
    pub(super) fn full_tangent(&mut self, t: f64, load_scale: f64, stiffness: &mut [f64], damping: &mut [f64]) {
        self.set_fields(t, load_scale);
        stiffness.fill(0.0);
        damping.fill(0.0);
        let Buffers {
            q, v, frames, results, ..
        } = &mut self.buffers;
        let in_modes = self.in_modes;
        let whole = |body: &&MeshBody| !in_modes || body.modes.is_none();
        for (index, body) in self.bodies.iter().enumerate().filter(|(_, body)| whole(body)) {
            let action = frames[body.frame].action(body.spec.axes, [0.0; 3]);
            let size = body.spec.element_size();
            let (q, v): (&[f64], &[f64]) = (q, v);
            let width = 2 * size * size;
            evaluate(body.spec.count, width, results, |element, result| {
                let mut local = [[0.0; MAX_SIZE]; 2];
                for (values, full) in local.iter_mut().zip([q, v]) {
                    body.connectivity.gather(element, full, &mut values[..size]);
                }
                let (k, c) = result.split_at_mut(size * size);
                let [q, v] = &local;
                self.parts
                    .tangent(index, element, body.frame == 0, &action, &q[..size], &v[..size], k, c);
            });
            for element in 0..body.spec.count {
                let (k, c) = results[element * width..(element + 1) * width].split_at(size * size);
                body.scatter.add(element, k, stiffness);
                body.scatter.add(element, c, damping);
            }
        }
        self.add_load_tangents(t, load_scale, stiffness);
        self.add_fixture_tangents(stiffness, damping);
        self.add_marker_force_tangents(t, load_scale, stiffness, damping);
    }

    fn add_load_tangents(&self, t: f64, load_scale: f64, stiffness: &mut [f64]) {
        for (index, point) in self.load_points.iter().enumerate() {
            let (Some(point), LoadKind::Moment { .. }) = (point, self.loads[index].kind) else {
                continue;
            };
            if self.is_marked(index) {
                continue;
            }
            let body = &self.bodies[point.body];
            let (dimension, size) = (body.spec.dimension(), body.spec.element_size());
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let block = self.moment_tangent_at(point, value);
            let vectors = turned_by_moments(&body.spec);
            let width = vectors.len() * dimension;
            let mut local = vec![0.0; size * size];
            for (place, entry) in local.iter_mut().enumerate() {
                let (row, column) = (place / size, place % size);
                for (m, &of) in vectors.iter().enumerate() {
                    for (n, &by) in vectors.iter().enumerate() {
                        let weight = point.weights(of)[row / dimension] * point.weights(by)[column / dimension];
                        let (i, j) = (m * dimension + row % dimension, n * dimension + column % dimension);
                        *entry -= weight * block[i * width + j];
                    }
                }
            }
            body.scatter.add(point.element, &local, stiffness);
        }
    }

    /// The vectors of a condition's node in one of the full arrays.
    pub(super) fn node(&self, condition: &Condition, full: &[f64]) -> [f64; MOST] {
        let mut node = [0.0; MOST];
        for (place, &component) in condition.components.iter().enumerate() {
            node[place] = full[component];
        }
        node
    }
}
