//! What the sections of all flexible bodies carry, for envelopes: both ends and the middle of every element.

use super::section::Reader;
use crate::model::{SectionBody, SectionState};
use crate::scene::MeshScene;

/// Where an element is sampled: what is largest lies at an end or, under a distributed load, near the middle.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];

impl MeshScene {
    /// The bodies that [`MeshScene::sample_sections`] samples.
    fn sampled(&self) -> impl Iterator<Item = usize> {
        (0..self.bodies.len()).filter(|&body| self.knows_sections(body))
    }

    /// What there is to sample.
    pub(crate) fn sectioned(&self) -> Vec<SectionBody> {
        let describe = |body: usize| {
            let (spec, section) = (&self.bodies[body].spec, self.section_spec(body, 0.0));
            SectionBody {
                name: spec.label(),
                length: spec.line.length(),
                elements: spec.count,
                states: PLACES.len() * spec.count,
                has_section: spec.has_section(),
                is_planar: spec.dimension() == 2,
                knows_stress: self.knows_stress(body),
                area: section.area,
                material: section.material,
                yield_stress: section.yield_stress,
            }
        };
        self.sampled().map(describe).collect()
    }

    /// Section states of all sampled bodies at the loaded state, in their order, from start to end.
    pub(crate) fn sample_sections(&mut self, out: &mut Vec<SectionState>) {
        out.clear();
        let mut reaches = self.taken_reaches();
        for body in self.sampled() {
            let mut reader = Reader::new(self, body, &mut reaches[body]);
            for element in 0..self.bodies[body].spec.count {
                reader.element(element, &PLACES, out);
            }
        }
        self.buffers.reaches = reaches;
    }
}
