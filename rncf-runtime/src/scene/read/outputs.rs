//! What is read off a scene: outputs, reactions, energy.

use crate::emitted::{Fidelity, JointKind, JointSpec, LoadKind, MAX_SIZE, ObservedSpec, PointQuantity, When};
use crate::scene::bodies::described::Kernels;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::place::PlaceVector;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Linked;
use crate::scene::pieces::reach::Reaches;
use crate::space::Vector;
use crate::system::{State, System};

impl MeshScene {
    /// Energy of a conservative model: kinetic, strain, and potential of gravity and dead forces.
    pub(crate) fn total_energy(&mut self, state: &State) -> Option<f64> {
        if !self.parts.conservative() {
            return None;
        }
        self.load_state(state);
        let gravity = self.gravity(state.t);
        let mut energy = self.marker_energy(state.t)?;
        energy += self.kinetic_energy(state);
        self.load_state(state);
        for (index, body) in self.bodies.iter().enumerate() {
            let (dimension, size) = (body.spec.dimension(), body.spec.element_size());
            let frame = &self.buffers.frames[body.frame];
            let pull = frame.direction_to_frame(gravity);
            let origin = self.origin(body.frame);
            for element in 0..body.spec.count {
                let mut q = [0.0; MAX_SIZE];
                body.connectivity.gather(element, &self.buffers.q, &mut q[..size]);
                energy += self.parts.energy(index, element, &q[..size]);
                let (count, masses) = (body.spec.nodal.len(), body.mass_of(element));
                for a in 0..count {
                    for b in 0..count {
                        // The shape functions of positions add up to one.
                        if body.spec.nodal[b].is_position() {
                            let mass = masses[a * count + b];
                            for c in 0..dimension {
                                energy -= mass * q[a * dimension + c] * pull[body.spec.axes[c]];
                            }
                            if body.spec.nodal[a].is_position() {
                                energy -= mass * gravity.dot(&origin);
                            }
                        }
                    }
                }
            }
        }
        for fixture in &self.fixtures {
            let origin = self.origin(self.bodies[fixture.point.body].frame);
            energy += self.fixture_potential(fixture, gravity) - fixture.spec.constants[0] * gravity.dot(&origin);
        }
        for frame in &self.frames.free {
            let rigid = &frame.spec.rigid;
            let motion = &self.buffers.frames[frame.spec.frame];
            let moment = motion.direction_to_inertial(rigid.moment);
            energy -= rigid.mass * gravity.dot(&motion.position) + gravity.dot(&moment);
        }
        for (index, load) in self.dead_loads.specs.iter().enumerate() {
            if let (LoadKind::Force { .. }, Some(point)) = (load.kind, &self.dead_loads.points[index]) {
                let body = &self.bodies[point.body];
                let force = self.parts.load(index, state.t);
                let position = self.at_point(point, PlaceVector::Position, &self.buffers.q);
                let frames = &self.buffers.frames;
                let position = frames[body.frame].direction_to_inertial(position);
                let position = frames[load.frame].direction_to_frame(self.origin(body.frame) + position);
                energy -= force[0] * position[0] + force[1] * position[1] + force[2] * position[2];
            }
        }
        Some(energy)
    }

    /// Origin of a free frame, inertial axes; prescribed ones add a constant to an energy at most.
    fn origin(&self, frame: usize) -> Vector {
        match self.frames.free_of[frame] {
            Some(_) => self.buffers.frames[frame].position,
            None => Vector::zeros(),
        }
    }

    /// The nodal vector at a place of the full arrays, in frame axes.
    pub(crate) fn vector_at(&self, body: &MeshBody, full: &[f64], place: usize) -> Vector {
        let dimension = body.spec.dimension();
        let mut components = [0.0; 3];
        components[..dimension].copy_from_slice(&full[place..place + dimension]);
        body.spread(components)
    }

    /// A vector of a body in its own axes, in the declared frame.
    pub(crate) fn in_declared(&self, body: &MeshBody, what: PointQuantity, [q, v]: [Vector; 2]) -> Vector {
        if body.frame == body.spec.frame {
            return if what == PointQuantity::Velocity { v } else { q };
        }
        let frame = &self.buffers.frames[body.spec.frame];
        match what {
            PointQuantity::Position => frame.point_to_frame(q),
            PointQuantity::Slope | PointQuantity::SectionY | PointQuantity::SectionZ => frame.direction_to_frame(q),
            PointQuantity::Velocity => frame.rate_to_frame(q - frame.position, v - frame.velocity),
        }
    }

    /// Value of something observed at the loaded state; forces must be evaluated for reactions.
    fn observe(&self, index: usize, t: f64, lambda: &[f64], reaches: &mut [Reaches]) -> f64 {
        match self.observed.specs[index] {
            ObservedSpec::Point {
                body, what, component, ..
            } => {
                let Some(point) = &self.observed.points[index] else {
                    return f64::NAN;
                };
                let body = &self.bodies[body];
                let at = |full: &[f64]| self.at_point(point, what.into(), full);
                self.in_declared(body, what, [at(&self.buffers.q), at(&self.buffers.v)])[component]
            }
            ObservedSpec::Section { what, .. } => {
                let point = self.observed.points[index].as_ref();
                let value = point.and_then(|point| self.section_at(point, &mut reaches[point.body]).value(what));
                // Sections without stress are refused when the scene is built.
                value.unwrap_or(f64::NAN)
            }
            ObservedSpec::Marker {
                marker,
                derivative,
                component,
            } => self.jet(&self.links.markers[marker])[derivative][component],
            ObservedSpec::Balance { of, what, component } => self.balance_of(of, what, t, component),
            ObservedSpec::ConstraintReaction {
                constraint,
                moment,
                component,
            } => match self.linked(constraint) {
                Some(linked) => self.constraint_reaction(linked, t, lambda)[usize::from(moment)][component],
                None => 0.0,
            },
            ObservedSpec::Multiplier { constraint, row } => match self.linked(constraint) {
                Some(linked) => lambda[self.first_row(linked) + row],
                None => 0.0,
            },
            ObservedSpec::Reaction {
                joint,
                moment,
                component,
            } => self.reaction(joint, moment, t, lambda)[component],
        }
    }

    /// Place among the constraints that are there of a declared one.
    pub(super) fn linked(&self, constraint: usize) -> Option<usize> {
        self.links
            .constraints
            .iter()
            .position(|linked| linked.index == constraint)
    }

    /// What a joint exerts on its body, in the joint's frame: the unbalanced generalised force on
    /// its node is what the joint must supply; `m = slope x force on the slope`.
    pub(crate) fn reaction(&self, joint: usize, moment: bool, t: f64, lambda: &[f64]) -> Vector {
        let spec = &self.joints[joint];
        let body = &self.bodies[spec.body];
        let frames = &self.buffers.frames;
        let Some(condition) = self.conditions.iter().find(|condition| condition.joint == joint) else {
            return self.reaction_of_substitute(spec, moment, t, lambda);
        };
        let of = |vector: usize, full: &[f64]| {
            let mut value = self.vector_at(body, full, self.layout.offset(vector));
            if let JointKind::Hold { axis, .. } = spec.kind {
                value = Vector::from_fn(|i, _| if i == axis { value[i] } else { 0.0 });
            }
            value
        };
        let (q, force) = (&self.buffers.q, &self.buffers.force);
        let end = |of, order| body.spec.end_vector(spec.at_end, of, order);
        let held: Vec<usize> = match spec.kind {
            JointKind::Pin => vec![condition.vectors[0]],
            JointKind::Clamp | JointKind::ClampFull => condition.vectors.clone(),
            JointKind::Hold { of, order, .. } => end(of, order)
                .map(|place| body.first_vector + place)
                .into_iter()
                .collect(),
        };
        // A held position makes a force, held directions make a moment.
        let mut vector = Vector::zeros();
        for node in held {
            let exerted = of(node, force);
            match (node == condition.vectors[0], moment) {
                (true, false) => vector = exerted,
                (false, true) => {
                    let direction = self.vector_at(body, q, self.layout.offset(node));
                    vector += direction.cross(&exerted);
                }
                _ => {}
            }
        }
        if spec.frame == body.frame {
            return vector;
        }
        frames[spec.frame].direction_to_frame(frames[body.frame].direction_to_inertial(vector))
    }

    /// The reaction of the constraint of the same name that stands for a joint to the body's own
    /// free frame in absolute coordinates.
    fn reaction_of_substitute(&self, joint: &JointSpec, moment: bool, t: f64, lambda: &[f64]) -> Vector {
        let stands = |linked: &Linked| linked.spec.when == When::Absolute(joint.body) && linked.spec.name == joint.name;
        match self.links.constraints.iter().position(stands) {
            Some(linked) => {
                let reaction = self.constraint_reaction(linked, t, lambda)[usize::from(moment)];
                self.buffers.frames[joint.frame].direction_to_frame(reaction)
            }
            None => Vector::zeros(),
        }
    }

    /// Forces of all components at the loaded state as joints on nodes supply them: what constraints on markers and rigid
    /// sections do is part of them, and bodies in modes carry what their modes leave unbalanced to their joints.
    fn evaluate_reactions(&mut self, t: f64, load_scale: f64, lambda: &[f64]) {
        self.evaluate_acting(t, load_scale, lambda);
        self.hold_modes();
    }

    /// The same without what bodies in modes carry to their joints.
    pub(crate) fn evaluate_acting(&mut self, t: f64, load_scale: f64, lambda: &[f64]) {
        self.full_force(t, load_scale);
        self.add_marker_constraint_forces(t, lambda);
        self.add_rigid_section_forces(lambda);
    }

    /// Lets the joints of modal bodies take what their modes leave unbalanced in the evaluated forces, and remembers
    /// what their elements carry to them.
    fn hold_modes(&mut self) {
        self.buffers.held.resize(self.bodies.len(), Vec::new());
        for (index, body) in self.bodies.iter().enumerate() {
            if let Some(modes) = &body.modes {
                let first = self.layout.offset(body.first_vector);
                let own = first..first + modes.shape().len();
                let elements = Kernels {
                    parts: &*self.parts,
                    body: index,
                };
                let (q, force) = (&self.buffers.q[own.clone()], &mut self.buffers.force[own]);
                self.buffers.held[index] = modes.held(&elements, q, force);
            }
        }
    }

    /// Prepares the loaded state for what sections carry.
    pub(crate) fn evaluate_sections(&mut self, t: f64, load_scale: f64, lambda: &[f64]) {
        if self.has_modes() {
            self.evaluate_reactions(t, load_scale, lambda);
        }
        self.set_sections(t, load_scale, lambda);
    }

    fn has_modes(&self) -> bool {
        self.bodies.iter().any(|body| body.modes.is_some())
    }

    pub(super) fn observes(&self, such: impl Fn(&ObservedSpec) -> bool) -> bool {
        self.observed.specs.iter().any(such)
    }

    /// Whether outputs, or what sections carry, are made of multipliers.
    pub(crate) fn observes_multipliers(&self) -> bool {
        let is_of_multipliers = |observed: &ObservedSpec| {
            matches!(
                observed,
                ObservedSpec::ConstraintReaction { .. }
                    | ObservedSpec::Multiplier { .. }
                    | ObservedSpec::Reaction { .. }
                    | ObservedSpec::Section { .. }
            )
        };
        // Bodies that strain in their elements carry what their strains tell; others what acts on them.
        let is_carried = |body: usize| self.bodies[body].spec.fidelity != Fidelity::Full && self.knows_sections(body);
        self.observes(is_of_multipliers) || (0..self.bodies.len()).any(is_carried)
    }

    /// Output columns at the loaded state.
    pub(crate) fn evaluate_outputs(&mut self, t: f64, load_scale: f64, lambda: &[f64], out: &mut [f64]) {
        let has_sections = self.observes(|observed| matches!(observed, ObservedSpec::Section { .. }));
        let needs_acceleration = |observed: &ObservedSpec| {
            matches!(
                observed,
                ObservedSpec::Reaction { .. } | ObservedSpec::Marker { derivative: 2, .. }
            )
        };
        if self.observes(needs_acceleration) || has_sections && self.has_modes() {
            self.evaluate_reactions(t, load_scale, lambda);
        }
        if has_sections {
            self.set_sections(t, load_scale, lambda);
        }
        let observed = self.observed_values(t, lambda);
        self.parts.outputs(t, &observed, out);
    }

    /// What outputs read at the loaded state; forces must be evaluated for reactions.
    pub(crate) fn observed_values(&mut self, t: f64, lambda: &[f64]) -> Vec<f64> {
        let mut reaches = self.taken_reaches();
        let observed = (0..self.observed.specs.len())
            .map(|index| self.observe(index, t, lambda, &mut reaches))
            .collect();
        self.buffers.reaches = reaches;
        observed
    }
}
