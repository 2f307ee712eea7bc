//! Declared moments on bodies: what they do to the vectors of their place, with exact virtual work. A
//! moment acts on the slope of a centre line, and on the axes of a section (THEORY 5.2.1).

use crate::emitted::BodySpec;
use crate::scene::bodies::place::{MeshPoint, PlaceVector, weighted};
use crate::scene::mesh_scene::MeshScene;

/// Most components of the vectors that a moment acts on.
pub(crate) const MOST: usize = 6;

/// The vectors of a place that a moment acts on.
pub(crate) fn turned_by_moments(spec: &BodySpec) -> &'static [PlaceVector] {
    if spec.has_section() {
        PlaceVector::section(spec.dimension())
    } else {
        &[PlaceVector::Slope]
    }
}

impl MeshScene {
    /// The vectors of a place that a moment acts on, one after the other in the body's order.
    fn turned_at(&self, point: &MeshPoint) -> [f64; MOST] {
        let body = &self.bodies[point.body];
        let dimension = body.spec.dimension();
        let components = body.connectivity.element(point.element);
        let mut directions = [0.0; MOST];
        let parts = directions.chunks_exact_mut(dimension);
        for (part, &of) in parts.zip(turned_by_moments(&body.spec)) {
            let value = weighted(&self.buffers.q, components, dimension, point.weights(of));
            part.copy_from_slice(&value[..dimension]);
        }
        directions
    }

    /// Generalised force of a moment (body's axes; planar: first component) on the vectors that it acts on,
    /// at the loaded state.
    pub(crate) fn moment_at(&self, point: &MeshPoint, moment: [f64; 3]) -> [f64; MOST] {
        let spec = &self.bodies[point.body].spec;
        let dimension = spec.dimension();
        let directions = self.turned_at(point);
        let mut force = [0.0; MOST];
        if turned_by_moments(spec).len() == 2 {
            self.parts.section_moment(&directions, moment, &mut force);
        } else {
            let force = &mut force[..dimension];
            self.parts.moment(dimension, &directions[..dimension], moment, force);
        }
        force
    }

    /// Its derivatives with respect to those vectors: rows of as many components as they have.
    pub(crate) fn moment_tangent_at(&self, point: &MeshPoint, moment: [f64; 3]) -> [f64; MOST * MOST] {
        let spec = &self.bodies[point.body].spec;
        let dimension = spec.dimension();
        let directions = self.turned_at(point);
        let mut tangent = [0.0; MOST * MOST];
        if turned_by_moments(spec).len() == 2 {
            self.parts.section_moment_tangent(&directions, moment, &mut tangent);
        } else {
            let tangent = &mut tangent[..dimension * dimension];
            self.parts
                .moment_tangent(dimension, &directions[..dimension], moment, tangent);
        }
        tangent
    }
}
