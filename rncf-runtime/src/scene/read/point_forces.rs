//! What acts at single places inside elements: loads, springs, joints and fixtures. Section forces change there by
//! a leap; what acts on a node stands between two elements and is no part of either.

use crate::emitted::LoadKind;
use crate::scene::bodies::nodal_mass::{Padded, Total, Transport, padded, vector};
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::point_force::PointForce;
use crate::scene::terms::moments::turned_by_moments;
use crate::space::Vector;

/// The vectors of a place, in the order of a fixture's constants.
const VECTORS: [PlaceVector; 4] = [
    PlaceVector::Position,
    PlaceVector::Slope,
    PlaceVector::SectionY,
    PlaceVector::SectionZ,
];

impl MeshScene {
    /// Remembers what acts inside the elements of every body at the loaded state.
    pub(crate) fn set_point_forces(&mut self, t: f64, load_scale: f64, lambda: &[f64]) {
        let mut all: Vec<Vec<PointForce>> = vec![Vec::new(); self.bodies.len()];
        let mut act = |point: &MeshPoint, of: PlaceVector, force: Vector| {
            if point.xi <= 0.0 || point.xi >= 1.0 {
                return;
            }
            let mut within = Vector::zeros();
            for &axis in self.bodies[point.body].spec.axes {
                within[axis] = force[axis];
            }
            for (on_position, weights, factor) in point.shares(of) {
                all[point.body].push(PointForce {
                    element: point.element,
                    xi: point.xi,
                    on_position,
                    weights: weights.to_vec(),
                    force: factor * within,
                });
            }
        };
        self.each_marker_force(t, load_scale, lambda, |marker, force| {
            let (Marker::Body { point, .. } | Marker::Section { point, .. } | Marker::SectionTurn { point }) = marker
            else {
                return;
            };
            let force = self.buffers.frames[self.bodies[point.body].frame].direction_to_frame(force);
            let moment = match marker {
                Marker::Body { of, .. } => return act(point, *of, force),
                Marker::Section { along, is_point, .. } => {
                    if *is_point {
                        act(point, PlaceVector::Position, force);
                    }
                    self.direction_in_section(point, *along).cross(&force)
                }
                _ => force,
            };
            for (of, force) in self.on_section_axes(point, moment) {
                act(point, of, force);
            }
        });
        for index in 0..self.dead_loads.specs.len() {
            let Some(point) = self.dead_loads.points[index]
                .as_ref()
                .filter(|_| !self.is_marked(index))
            else {
                continue;
            };
            let body = &self.bodies[point.body];
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            match self.dead_loads.specs[index].kind {
                LoadKind::Gravity | LoadKind::Around | LoadKind::Field { .. } => {}
                LoadKind::Force { .. } => act(point, PlaceVector::Position, body.spread(value)),
                LoadKind::Moment { .. } => {
                    let forces = self.moment_at(point, value);
                    let parts = forces.chunks_exact(body.spec.dimension());
                    for (&of, part) in turned_by_moments(&body.spec).iter().zip(parts) {
                        let force = std::array::from_fn(|i| part.get(i).copied().unwrap_or(0.0));
                        act(point, of, body.spread(force));
                    }
                }
            }
        }
        for fixture in &self.fixtures {
            let (point, block) = (&fixture.point, fixture.block());
            let body = &self.bodies[point.body];
            let transport = Transport::new(&self.buffers.frames[body.frame], body.spec.axes, self.buffers.gravity);
            let total = Total::new(&transport);
            let of_place = &VECTORS[..1 + body.spec.interpolants()];
            // What is along the normal of a rigid section comes through the forces that keep it rigid.
            let normal = fixture
                .normal
                .map(|normal| self.layout.offset(body.first_vector + normal));
            let along_normal = |of: PlaceVector| normal.filter(|_| of == PlaceVector::Slope);
            let accelerations: Vec<Vector> = of_place
                .iter()
                .map(|&of| {
                    let full = [&self.buffers.q, &self.buffers.v, &self.buffers.a];
                    let value = |full: &[f64]| match along_normal(of) {
                        Some(first) => self.vector_at(body, full, first),
                        None => self.at_point(point, of, full),
                    };
                    let at: [Padded; 3] = full.map(|full| padded(value(full)));
                    vector(total.acceleration(of == PlaceVector::Position, at.each_ref()))
                })
                .collect();
            for (&of, row) in of_place.iter().zip(block) {
                let parts = row.into_iter().zip(&accelerations);
                let force = parts.fold(Vector::zeros(), |sum, (mass, &a)| sum - mass * a);
                if along_normal(of).is_none() {
                    act(point, of, force);
                }
            }
        }
        self.each_rigid_section_force(lambda, act);
        self.buffers.point_forces = all;
    }
}
