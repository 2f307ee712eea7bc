//! Round-off of constraints: what rounding of the places that they compare leaves of them.

use super::constraints::part;
use crate::scene::MeshScene;
use crate::scene::pieces::marker::{Linked, Marker};

impl MeshScene {
    /// Round-off of all links at the loaded state, in their units.
    pub(super) fn link_noise(&self, t: f64, out: &mut [f64]) {
        let mut first = 0;
        for linked in &self.links.constraints {
            let gradient = self.gradient_of(linked, t);
            let terms: Vec<f64> = linked
                .spec
                .markers
                .iter()
                .map(|&marker| self.marker_terms(linked, &self.links.markers[marker]))
                .collect();
            let rows = gradient.chunks_exact(3 * terms.len());
            for (out, row) in out[first..].iter_mut().zip(rows) {
                let parts = terms.iter().enumerate();
                *out = f64::EPSILON * parts.map(|(place, terms)| part(row, place).norm() * terms).sum::<f64>();
            }
            first += linked.spec.rows.len();
        }
    }

    /// Sum of the sizes of what a marker of a constraint is made of.
    fn marker_terms(&self, linked: &Linked, marker: &Marker) -> f64 {
        let own = self.within(marker)[0].norm();
        if !marker.is_point() {
            return own;
        }
        let frame = self.marker_frame(marker);
        let anchor = linked.anchor.map(|anchor| &self.frames.free[anchor]);
        let t = self.buffers.t;
        let origin = match self.frames.free_of[frame].map(|free| &self.frames.free[free]) {
            Some(free) if free.shifts() > 0 => {
                let first = self.layout.vector_components() + free.first;
                free.terms(anchor, t, &self.buffers.q[first..])
            }
            _ => {
                let position = self.buffers.frames[frame].position.norm();
                position + anchor.map_or(0.0, |anchor| anchor.terms(None, t, &[]))
            }
        };
        origin + own
    }
}
