//! What the sections of all flexible bodies carry, for envelopes: both ends and the middle of every element.

use super::scene::MeshScene;
use super::section::{Reader, SectionState};

/// Where an element is sampled: what is largest lies at an end or, under a distributed load, near the middle.
const PLACES: [f64; 3] = [0.0, 0.5, 1.0];

/// A flexible body of a scene, as far as its section states need it.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionBody {
    /// Name in the declaration, with the number of the repetition where it is repeated.
    pub name: String,
    /// Length of the stress-free axis, m.
    pub length: f64,
    /// Number of its section states.
    pub states: usize,
    /// Whether its elements have sections, which shear; a centre line tells neither shear forces nor a torque.
    pub has_section: bool,
    /// Whether it stays in a plane, and carries no torque.
    pub is_planar: bool,
    /// Whether [`SectionState::stress`] is known: the section says where its outermost fibres are.
    pub knows_stress: bool,
    /// Area of the section, m^2.
    pub area: f64,
    /// Name of the material.
    pub material: &'static str,
    /// Its yield stress, Pa.
    pub yield_stress: Option<f64>,
}

impl MeshScene {
    /// The bodies that [`MeshScene::sample_sections`] samples.
    fn sampled(&self) -> impl Iterator<Item = usize> {
        (0..self.bodies.len()).filter(|&body| self.knows_sections(body))
    }

    /// What there is to sample.
    pub(super) fn sectioned(&self) -> Vec<SectionBody> {
        let describe = |body: usize| {
            let (spec, section) = (&self.bodies[body].spec, self.section_spec(body, 0.0));
            SectionBody {
                name: spec.label(),
                length: spec.line.length(),
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
    pub(super) fn sample_sections(&self, out: &mut Vec<SectionState>) {
        out.clear();
        for body in self.sampled() {
            let mut reader = Reader::new(self, body);
            for element in 0..self.bodies[body].spec.count {
                reader.element(element, &PLACES, out);
            }
        }
    }
}
