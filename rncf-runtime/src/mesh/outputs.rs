//! What is read off a scene: outputs, reactions, energy.

use super::evaluate::{MAX_SIZE, weighted};
use super::parts::{LoadKind, ObservedSpec, Parts, PointQuantity};
use super::scene::{MeshBody, MeshScene, Regime};
use crate::model::Scene;
use crate::system::State;
use crate::vector::{cross, subtract};

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
    pub(super) fn spread(&self, body: &MeshBody, components: [f64; 3]) -> [f64; 3] {
        let mut vector = [0.0; 3];
        for (place, &axis) in body.spec.axes.iter().enumerate() {
            vector[axis] = components[place];
        }
        vector
    }

    /// The nodal vector at a place of the full arrays, in frame axes.
    pub(super) fn vector_at(&self, body: &MeshBody, full: &[f64], place: usize) -> [f64; 3] {
        let dimension = body.spec.dimension();
        let mut components = [0.0; 3];
        components[..dimension].copy_from_slice(&full[place..place + dimension]);
        self.spread(body, components)
    }

    /// A vector of a body in its own axes, in the declared frame.
    pub(super) fn in_declared(&self, body: &MeshBody, what: PointQuantity, [q, v]: [[f64; 3]; 2]) -> [f64; 3] {
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
            ObservedSpec::Marker { .. } | ObservedSpec::ConstraintReaction { .. } | ObservedSpec::Multiplier { .. } => {
                f64::NAN
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
        let of = |vector: usize, full: &[f64]| self.vector_at(body, full, self.layout.offset(vector));
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
    pub(super) fn evaluate_outputs(&mut self, t: f64, load_scale: f64, out: &mut [f64]) {
        if self.outputs_need_acceleration() {
            self.full_force(t, load_scale);
        }
        let observed: Vec<f64> = (0..self.observed.len()).map(|index| self.observe(index)).collect();
        self.parts.outputs(t, &observed, out);
    }
}
