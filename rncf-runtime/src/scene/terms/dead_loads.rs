//! Declared forces and moments on bodies, constant or as functions of time, where no free frame feels them.

use super::force::{At, Force};
use super::moments::turned_by_moments;
use crate::emitted::LoadKind;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::place::PlaceVector;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::combined::Combined;
use crate::space::Vector;
use crate::system::{Sums, Tangent};

/// Loads at places of bodies.
pub(crate) struct DeadLoads;

impl Force for DeadLoads {
    /// Nothing beside what their elements couple.
    fn couple(&self, _: &MeshScene, _: &mut Vec<(usize, usize)>) {}

    fn add(&self, scene: &mut MeshScene, at: &At) {
        scene.add_loads(at.t, at.load_scale);
    }

    fn add_tangent(&self, scene: &mut MeshScene, at: &At, out: &mut Tangent) {
        scene.add_load_tangents(at.t, at.load_scale, out);
    }

    fn add_combined(&self, scene: &mut MeshScene, at: &At, out: &mut Combined) {
        scene.add_load_tangents(at.t, at.load_scale, out);
    }
}

impl MeshScene {
    /// Whether a load acts through a marker, since a free frame feels it.
    pub(crate) fn is_marked(&self, load: usize) -> bool {
        self.links.marked_loads.iter().any(|marked| marked.load == load)
    }

    /// Force or moment of a load in the axes of its body, in their order.
    pub(crate) fn load_in_body(&self, index: usize, t: f64, body: &MeshBody) -> [f64; 3] {
        let load = &self.dead_loads.specs[index];
        let mut value = Vector::from(self.parts.load(index, t));
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

    /// Adds constant and follower loads on bodies.
    pub(crate) fn add_loads(&mut self, t: f64, load_scale: f64) {
        for index in 0..self.dead_loads.specs.len() {
            let Some(point) = self.dead_loads.points[index]
                .as_ref()
                .filter(|_| !self.is_marked(index))
            else {
                continue;
            };
            let body = &self.bodies[point.body];
            let dimension = body.spec.dimension();
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let components = body.connectivity.element(point.element);
            match self.dead_loads.specs[index].kind {
                LoadKind::Gravity | LoadKind::Around | LoadKind::Field { .. } => {}
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

    fn add_load_tangents(&self, t: f64, load_scale: f64, out: &mut impl Sums) {
        for (index, point) in self.dead_loads.points.iter().enumerate() {
            let (Some(point), LoadKind::Moment { .. }) = (point, self.dead_loads.specs[index].kind) else {
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
            let components = body.connectivity.element(point.element);
            for (place, &value) in local.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                for (entry, factor) in self.entries_of(components[place / size], components[place % size]) {
                    out.stiffness(entry, factor * value);
                }
            }
        }
    }
}
