//! Forces between two states that conserve energy: elements by their emitted kernels, constant forces as they are.
//!
//! Inertia forces in absolute coordinates are `M (a - g)` with a constant mass. A free frame without inertia is carried
//! along: as many constraints as it has motions tie it, so that their multipliers vanish.

use crate::emitted::MAX_SIZE;
use crate::scene::mesh_scene::MeshScene;
use crate::space::Matrix;
use crate::system::{Conserving, State, System};

impl MeshScene {
    /// What stands against forces that conserve energy, and what to do; `None`: nothing.
    pub(crate) fn conserving_obstacle(&self) -> Option<String> {
        if let Some(why) = self.parts.conserving_obstacle() {
            return Some(format!(
                "energy-momentum integration does not suit this model: {why}; take another integrator"
            ));
        }
        let turning = self
            .bodies
            .iter()
            .find(|body| self.frames.free_of[body.frame].is_some());
        if let Some(body) = turning {
            return Some(format!(
                "energy-momentum integration needs a constant mass, and body `{}` has its nodal vectors in the free frame \
                 `{}`: take `--formulation ancf` or another integrator",
                body.spec.label(),
                self.parts.frame_name(body.frame)
            ));
        }
        for frame in &self.frames.free {
            let rigid = &frame.spec.rigid;
            if rigid.mass != 0.0 || rigid.inertia != Matrix::zeros() {
                return Some(format!(
                    "energy-momentum integration knows flexible bodies and point masses fixed to them, and `{}` is a \
                     rigid body of its own: fix it to a flexible body or take another integrator",
                    self.parts.frame_name(frame.spec.frame)
                ));
            }
        }
        let marked = self
            .links
            .marked_loads
            .first()
            .map(|marked| self.dead_loads.specs[marked.load].name);
        if let Some(name) = self.links.forces.first().map(|force| force.name).or(marked) {
            return Some(format!(
                "energy-momentum integration has no conserving form of force `{name}`: take another integrator"
            ));
        }
        if self.constraints() - self.first_linked() != self.layout.border() {
            let name = self.links.constraints.first().map_or("", |linked| linked.spec.name);
            return Some(format!(
                "energy-momentum integration has no multipliers for constraints between bodies, as `{name}` is: let ends \
                 `share` a node, or take another integrator"
            ));
        }
        None
    }

    /// Components of an element at the start of a step and now.
    fn ends(&self, body: usize, element: usize) -> [[f64; MAX_SIZE]; 2] {
        let connectivity = &self.bodies[body].connectivity;
        [&self.buffers.begun, &self.buffers.q].map(|full| {
            let mut own = [0.0; MAX_SIZE];
            connectivity.gather(element, full, &mut own);
            own
        })
    }

    /// Fills in the components at both states, with the acceleration of the second.
    fn load_ends(&mut self, from: &State, to: &State) {
        self.load_state(from);
        self.buffers.begun.clone_from(&self.buffers.q);
        self.load_state(to);
    }
}

impl Conserving for MeshScene {
    fn residual(&mut self, from: &State, to: &State, out: &mut [f64]) {
        self.load_ends(from, to);
        let gravity = self.gravity(to.t);
        self.buffers.force.fill(0.0);
        self.add_inertia_forces(gravity);
        for index in 0..self.bodies.len() {
            let size = self.bodies[index].spec.element_size();
            for element in 0..self.bodies[index].spec.count {
                let [start, end] = self.ends(index, element);
                let mut force = [0.0; MAX_SIZE];
                let own = &mut force[..size];
                self.parts
                    .conserving_force(index, element, &start[..size], &end[..size], own);
                let components = self.bodies[index].connectivity.element(element);
                for (&component, value) in components.iter().zip(&force) {
                    self.buffers.force[component] += value;
                }
            }
        }
        self.add_loads(to.t, 1.0);
        self.layout.project(&self.buffers.force, out);
    }

    fn constraint_forces(&mut self, from: &State, to: &State, values: &mut [f64]) {
        self.constraint_jacobian(to, values);
        if !self.rigid_sections.is_empty() {
            self.load_ends(from, to);
            self.rigid_section_jacobian_halfway(values);
        }
    }

    fn matrix(&mut self, from: &State, to: &State, factors: [f64; 2], values: &mut [f64]) {
        self.load_ends(from, to);
        for (value, mass) in values.iter_mut().zip(&self.tabulated.mass) {
            *value = factors[0] * mass;
        }
        self.add_rigid_section_curvature(&to.lambda, |entry, value| values[entry] += factors[1] * value);
        let mut stiffness = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let size = body.spec.element_size();
            for element in 0..body.spec.count {
                let [start, end] = self.ends(index, element);
                stiffness.clear();
                stiffness.resize(size * size, 0.0);
                self.parts
                    .conserving_tangent(index, element, &start[..size], &end[..size], &mut stiffness);
                body.scatter
                    .add_by(element, &stiffness, |value| factors[1] * value, values);
            }
        }
    }
}
