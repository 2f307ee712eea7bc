//! What the sections of all flexible bodies carry, for envelopes: both ends and the middle of every element.

use super::section::Reader;
use super::strained::Strained;
use crate::emitted::{Fidelity, Line};
use crate::model::{SectionBody, SectionState};
use crate::scene::MeshScene;

/// Where elements are sampled: what is largest lies at an end, where something acts or, under a load per length, between the ends. The fewer
/// elements a body has the more places they have.
const HALVES: [f64; 3] = [0.0, 0.5, 1.0];
const QUARTERS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const EIGHTHS: [f64; 9] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];

/// The places on each element of a body with so many.
fn places(elements: usize) -> &'static [f64] {
    match elements {
        0..4 => &EIGHTHS,
        4..8 => &QUARTERS,
        _ => &HALVES,
    }
}

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
                states: places(spec.count).len() * spec.count,
                has_section: spec.has_section(),
                is_planar: spec.dimension() == 2,
                knows_stress: self.knows_stress(body),
                knows_area: section.area > 0.0,
                material: section.material,
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
            match self.bodies[body].spec.count {
                0..4 => reader.all(&EIGHTHS, out),
                4..8 => reader.all(&QUARTERS, out),
                _ => reader.all(&HALVES, out),
            }
        }
        self.buffers.reaches = reaches;
    }

    /// First rows of the flexibilities of all sampled sections, undeformed, in the same order: strain of the axis by axial force, shear
    /// forces, torque and moments. Zeros of bodies that do not strain, or have elements with other fields than an axis and a section.
    pub(crate) fn compliances(&self) -> Vec<[f64; 6]> {
        let mut all = Vec::new();
        for body in self.sampled() {
            let spec = &self.bodies[body].spec;
            let strains =
                !matches!(spec.fidelity, Fidelity::Rigid | Fidelity::Point) && !matches!(spec.line, Line::Nodes(_));
            let Some(strained) = strains.then(|| Strained::new(self, body)).flatten() else {
                all.resize(all.len() + places(spec.count).len() * spec.count, [0.0; 6]);
                continue;
            };
            let (mut same, length) = (None, spec.line.length());
            for element in 0..spec.count {
                let local = 0..spec.nodal.len();
                let undeformed: Vec<f64> = local.flat_map(|local| spec.undeformed(element, local)).collect();
                for &xi in places(spec.count) {
                    let found = same.unwrap_or_else(|| {
                        let free = strained.fields_at(&strained.weights(element, xi), &undeformed);
                        let row = strained
                            .flexibility(spec.arclength_inside(length, element, xi), &free)
                            .values[0];
                        std::array::from_fn(|component| row[component])
                    });
                    same = same.or_else(|| (!self.parts.varies(body)).then_some(found));
                    all.push(found);
                }
            }
        }
        all
    }
}
