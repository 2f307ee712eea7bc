//! What modal bodies are made of, from the scene with all nodal vectors.

use super::body::Nodal;
use crate::emitted::{FrameTie, Line, ObservedSpec};
use crate::error::ModelError;
use crate::scene::MeshScene;
use crate::scene::numbering::assembly::Connectivity;

/// Relative distance up to which a joint holds a body in its undeformed place.
const ROUND_OFF: f64 = 1e-9;

impl MeshScene {
    /// Refuses what modes cannot describe.
    pub(super) fn check_modal(&self, index: usize) -> Result<(), ModelError> {
        let body = &self.bodies[index];
        let name = body.spec.label();
        let refuse = |what: String| Err(ModelError::new(what));
        if body.frame != body.spec.frame {
            return refuse(format!(
                "body `{name}` is described in its frame `{}` by modes or as rigid, which absolute coordinates do not have: use the referenced formulation",
                self.parts.frame_name(body.spec.frame)
            ));
        }
        if body.spec.tie != FrameTie::Joints {
            return refuse(format!(
                "body `{name}` cannot have both `{word}` and modes: clamp it in its frame instead of `{word}`",
                word = body.spec.tie.word()
            ));
        }
        let first = self.layout.offset(body.first_vector);
        let own = first..first + body.spec.vectors() * body.spec.dimension();
        let (shape, length) = (self.shape(), body.spec.line.length());
        for condition in &self.conditions {
            let joint = &self.joints[condition.joint];
            if joint.body != index {
                continue;
            }
            if joint.frame != body.spec.frame {
                return refuse(format!(
                    "joint `{}` holds body `{name}` in frame `{}`, not in its own: modes are those of a body held by its own frame, so move the joint there, or leave `modal`, `small` or `rigid` out",
                    joint.name,
                    self.parts.frame_name(joint.frame)
                ));
            }
            let moved = |&place: &usize| {
                let distance = (self.buffers.q[place] - shape[place]).abs();
                own.contains(&place) && distance > ROUND_OFF * length.max(1.0)
            };
            if condition.components.iter().any(moved) {
                return refuse(format!(
                    "joint `{}` holds body `{name}` away from its undeformed place, about which its modes are: let the joint be where the body is",
                    joint.name
                ));
            }
        }
        Ok(())
    }

    /// What a modal body is made of, and its first unknown.
    pub(super) fn nodal(&self, index: usize) -> (Nodal, usize) {
        let body = &self.bodies[index];
        let spec = &body.spec;
        let (dimension, vectors) = (spec.dimension(), spec.vectors());
        let offset = self.layout.offset(body.first_vector);
        let components = offset..offset + vectors * dimension;
        let unknowns = |range: std::ops::Range<usize>| range.flat_map(|component| self.layout.unknowns_at(component));
        let after = |range: std::ops::Range<usize>| unknowns(range).map(|(unknown, _)| unknown + 1).max();
        let first = after(0..offset).unwrap_or(0);
        let dependence = |component: usize| {
            let unknowns = self.layout.unknowns_at(component);
            unknowns.map(|(unknown, factor)| (unknown - first, factor)).collect()
        };
        let count = spec.nodal.len();
        let mut mass = vec![0.0; vectors * vectors];
        let mut fixtures = mass.clone();
        let add = |sum: &mut [f64], element: usize, local: &[f64]| {
            let place = |a: usize| element * spec.stride + spec.connectivity[a];
            for (entry, value) in local.iter().enumerate() {
                sum[place(entry / count) * vectors + place(entry % count)] += value;
            }
        };
        (0..spec.count).for_each(|element| add(&mut mass, element, body.mass_of(element)));
        for fixture in self.fixtures.iter().filter(|fixture| fixture.point.body == index) {
            add(&mut fixtures, fixture.point.element, fixture.mass());
        }
        let is_position = |vector: usize| spec.nodal[spec.locate(vector).1].is_position();
        let nodal = Nodal {
            name: spec.label(),
            dimension,
            connectivity: Connectivity {
                size: body.connectivity.size,
                components: body.connectivity.components.iter().map(|c| c - offset).collect(),
            },
            shape: self.shape()[components.clone()].to_vec(),
            mass,
            fixtures,
            whole: (0..vectors)
                .map(|vector| if is_position(vector) { 1.0 } else { 0.0 })
                .collect(),
            map: components.clone().map(dependence).collect(),
            freedoms: after(components).map_or(0, |end| end - first),
        };
        (nodal, first)
    }

    /// Refuses to tell what a body carries that its joints alone do not hold.
    pub(super) fn check_loose(&self, index: usize) -> Result<(), ModelError> {
        let body = &self.bodies[index];
        let loose = body.modes.as_ref().is_some_and(|modes| modes.is_loose());
        let reads = |observed: &ObservedSpec| match *observed {
            ObservedSpec::Section { body, .. } => body == index,
            ObservedSpec::Reaction { joint, .. } => self.joints[joint].body == index,
            _ => false,
        };
        if !loose || !self.observed.specs.iter().any(reads) {
            return Ok(());
        }
        if matches!(body.spec.line, Line::Nodes(_)) {
            return Err(ModelError::new(format!(
                "an output reads what body `{}` carries or what a joint to its own frame exerts on it, but it comes from a file, and no elements carry its loads there: give it a free frame of its own, and tie it by a joint between moving parts, whose reaction is known",
                body.spec.label()
            )));
        }
        Err(ModelError::new(format!(
            "an output reads what body `{}` carries or what a joint exerts on it, but `{}` alone keeps it in its frame where its joints leave it free, so that nothing says where its loads go: clamp it in its frame",
            body.spec.label(),
            body.spec.fidelity
        )))
    }
}
