//! Nodes that bodies share: vectors of several ends that are one. They need no equation, only a common number.

use super::conditions::Condition;
use super::layout::{Layout, VectorKind};
use crate::emitted::{BodySpec, Fidelity, Interpolant, JointKind, JointSpec, Parts, ShareSpec, label};
use crate::error::ModelError;

/// Vectors that an end node may have, with their names.
pub(crate) const VECTORS: [(Interpolant, usize, &str); 4] = [
    (Interpolant::Position, 0, "position"),
    (Interpolant::Position, 1, "slope"),
    (Interpolant::SectionY, 0, "section's y axis"),
    (Interpolant::SectionZ, 0, "section's z axis"),
];

/// Which vectors of all bodies are one.
pub(crate) struct Shared {
    /// Who makes them one.
    pub specs: Vec<ShareSpec>,
    /// For every vector the one whose value is that of its node.
    pub leaders: Vec<usize>,
    /// For every vector whether it is one with others, and by the first of which spec.
    by: Vec<Option<usize>>,
}

impl Shared {
    /// Unites the vectors of shared ends: chains of them are one node, whose leader is the first end's.
    ///
    /// # Errors
    /// Ends that cannot be one, by name.
    pub fn new(parts: &dyn Parts, bodies: &[BodySpec], firsts: &[usize]) -> Result<Self, ModelError> {
        let count = bodies.iter().map(BodySpec::vectors).sum();
        let mut shared = Self {
            specs: parts.shares(),
            leaders: (0..count).collect(),
            by: vec![None; count],
        };
        for index in 0..shared.specs.len() {
            shared.check(index, parts, bodies)?;
            let spec = &shared.specs[index];
            for &(of, order, _) in &VECTORS[..if spec.smooth { VECTORS.len() } else { 1 }] {
                let vector = |(body, at_end): (usize, bool)| {
                    let place = bodies[body].end_vector(at_end, of, order)?;
                    Some(firsts[body] + place)
                };
                if let [Some(first), Some(second)] = spec.ends.map(vector) {
                    let (leader, other) = (find(&mut shared.leaders, first), find(&mut shared.leaders, second));
                    shared.leaders[other] = leader;
                    for vector in [first, second] {
                        shared.by[vector].get_or_insert(index);
                    }
                }
            }
        }
        for vector in 0..count {
            find(&mut shared.leaders, vector);
        }
        Ok(shared)
    }

    /// `knot[3]`, the start of `aux[3]` with the end of `main[3]`.
    pub fn describe(&self, index: usize, bodies: &[BodySpec]) -> String {
        let name = label(self.specs.iter().map(|spec| spec.name), index);
        let [first, second] = self.specs[index].ends.map(|(body, at_end)| {
            let end = if at_end { "end" } else { "start" };
            format!("the {end} of `{}`", bodies[body].label())
        });
        format!("joint `{name}`, which makes {first} and {second} one,")
    }

    fn check(&self, index: usize, parts: &dyn Parts, bodies: &[BodySpec]) -> Result<(), ModelError> {
        let spec = &self.specs[index];
        let [first, second] = spec.ends.map(|(body, _)| &bodies[body]);
        let refuse = |what: String| Err(ModelError::new(format!("{} {what}", self.describe(index, bodies))));
        if spec.ends[0] == spec.ends[1] {
            return refuse("needs two different ends: an end is one with itself anyway".to_string());
        }
        if first.frame != second.frame {
            return refuse(format!(
                "needs bodies in one frame, not in `{}` and `{}`: put them into one frame, or tie them by a constraint",
                parts.frame_name(first.frame),
                parts.frame_name(second.frame)
            ));
        }
        if first.axes != second.axes {
            return refuse("needs both bodies in space or both in the same plane".to_string());
        }
        if let Some(body) = [first, second].into_iter().find(|body| body.fidelity != Fidelity::Full) {
            return refuse(format!(
                "needs all nodal vectors of both: leave `modal`, `small` or `rigid` of body `{}` out",
                body.label()
            ));
        }
        let has = |body: &BodySpec, at_end, of, order| body.end_vector(at_end, of, order).is_some();
        let differs = VECTORS
            .iter()
            .find(|&&(of, order, _)| has(first, spec.ends[0].1, of, order) != has(second, spec.ends[1].1, of, order));
        match differs {
            Some((_, _, name)) if spec.smooth => refuse(format!(
                "needs elements of one kind, and the nodes of only one of them have the {name}: share the positions alone, or mesh both alike"
            )),
            _ => Ok(()),
        }
    }

    /// Whether a vector is one with others.
    pub fn is_shared(&self, vector: usize) -> bool {
        self.by[vector].is_some()
    }

    /// Refuses joints that hold what is one with others: conditions are eliminated vector by vector.
    ///
    /// # Errors
    /// The joint and the share, by name.
    pub fn check_held(
        &self,
        conditions: &[Condition],
        joints: &[JointSpec],
        bodies: &[BodySpec],
        firsts: &[usize],
    ) -> Result<(), ModelError> {
        for condition in conditions {
            let joint = &joints[condition.joint];
            let body = &bodies[joint.body];
            let held: Vec<usize> = match joint.kind {
                JointKind::Hold { of, order, .. } => {
                    let place = body.end_vector(joint.at_end, of, order);
                    place.map(|place| firsts[joint.body] + place).into_iter().collect()
                }
                _ => condition.vectors.clone(),
            };
            if let Some(share) = held.iter().find_map(|&vector| self.by[vector]) {
                let name = label(joints.iter().map(|joint| joint.name), condition.joint);
                return Err(ModelError::new(format!(
                    "{} has an end that joint `{name}` holds: leave one of the two out; ends that a frame holds at one place need a joint each and no common node",
                    self.describe(share, bodies)
                )));
            }
        }
        Ok(())
    }
}

/// Leader of a vector; ways to it are cut short.
fn find(leaders: &mut [usize], vector: usize) -> usize {
    let mut leader = vector;
    while leaders[leader] != leader {
        leader = leaders[leader];
    }
    let mut next = vector;
    while leaders[next] != leader {
        next = std::mem::replace(&mut leaders[next], leader);
    }
    leader
}

/// Numbers the unknowns that conditions on the vectors and common nodes leave, and those of free frames.
pub(crate) fn numbering(specs: &[BodySpec], kinds: Vec<VectorKind>, shared: &Shared, border: usize) -> Layout {
    let dimensions = specs
        .iter()
        .flat_map(|spec| std::iter::repeat_n(spec.dimension(), spec.vectors()));
    let dimensions: Vec<usize> = dimensions.collect();
    Layout::new(&dimensions, kinds, shared.leaders.clone(), border)
}
