//! Angles that forces and constraints read by their sines and cosines, and kinks and peaks of forces and of loads along bodies.

use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::push::Law;
use crate::space::Vector;
use crate::system::{Branch, State};

/// What is written in the place of the jump of an angle: -1 of a kink, -2 of a peak.
const KINK: f64 = -1.0;

/// Largest and smallest of what changes its sign at a kink, over all places of a load along a body: where its first particle passes the kink, and where
/// its last does.
struct Extremes {
    name: &'static str,
    law: Law,
    most: f64,
    least: f64,
}

impl MeshScene {
    /// Whether there are any.
    pub(crate) fn has_branches(&self) -> bool {
        self.links.forces.iter().any(|push| push.branches > 0) || self.branches_of_constraints() > 0
    }

    /// Those of forces, which stand before those of constraints; loads along bodies come last.
    fn branches_of_forces(&self) -> usize {
        let forces = self.links.forces.iter();
        let forces = forces.filter(|push| matches!(push.law, Law::Force(_)));
        forces.map(|push| push.branches).sum()
    }

    fn branches_of_constraints(&self) -> usize {
        self.links.constraints.iter().map(|linked| linked.spec.branches).sum()
    }

    /// Whether a branch is of a constraint.
    pub(in crate::scene) fn is_constrained_by_branch(&self, index: usize) -> bool {
        let first = self.branches_of_forces();
        (first..first + self.branches_of_constraints()).contains(&index)
    }

    /// What changes its sign at each kink of a load along a body, or of gravity, where it acts.
    pub(in crate::scene) fn gaps_of(&self, law: Law, t: f64, z: &[Vector], velocity: &[Vector]) -> Vec<f64> {
        let mut gaps = Vec::new();
        match law {
            Law::Distributed { load, at, .. } => self.parts.distributed_gaps(load, t, at, z, velocity, &mut gaps),
            Law::Gravity { load, .. } => self.parts.around_gaps(load, t, z[0], &mut gaps),
            Law::Force(_) => {}
        }
        gaps
    }

    /// Those of all places of each load, one for each of its kinks.
    fn extremes(&self, t: f64) -> Vec<Extremes> {
        let mut all: Vec<Extremes> = Vec::new();
        for (index, push) in self.links.forces.iter().enumerate() {
            if matches!(push.law, Law::Force(_)) || push.branches == 0 {
                continue;
            }
            let (z, velocity) = self.force_arguments(index);
            let gaps = self.gaps_of(push.law, t, &z, &velocity);
            match all.iter().position(|one| one.law.is_of_same_load(push.law)) {
                Some(first) => {
                    for (one, gap) in all[first..].iter_mut().zip(gaps) {
                        one.most = one.most.max(gap);
                        one.least = one.least.min(gap);
                    }
                }
                None => all.extend(gaps.into_iter().map(|gap| Extremes {
                    name: push.name,
                    law: push.law,
                    most: gap,
                    least: gap,
                })),
            }
        }
        all
    }

    /// Of all forces, of all constraints, and of loads along bodies.
    pub(in crate::scene) fn branches_at(&mut self, state: &State) -> Vec<Branch> {
        if !self.has_branches() {
            return Vec::new();
        }
        self.load_state(state);
        let mut numbers = vec![[0.0; 4]; self.branches_of_forces() + self.branches_of_constraints()];
        let mut rest = numbers.as_flattened_mut();
        for (index, push) in self.links.forces.iter().enumerate() {
            if let (Law::Force(force), 1..) = (push.law, push.branches) {
                let (z, velocity) = self.force_arguments(index);
                let (own, others) = rest.split_at_mut(4 * push.branches);
                self.parts.marker_force_branches(force, state.t, &z, &velocity, own);
                rest = others;
            }
        }
        for linked in self.links.constraints.iter().filter(|linked| linked.spec.branches > 0) {
            let z = self.marker_values(linked);
            let (own, others) = rest.split_at_mut(4 * linked.spec.branches);
            self.parts.marker_constraint_branches(linked.index, state.t, &z, own);
            rest = others;
        }
        let branch = |&[sine, cosine, jump, size]: &[f64; 4]| {
            if jump < KINK {
                Branch::Peak { t: state.t, rate: sine }
            } else if jump < 0.0 {
                Branch::Kink(sine)
            } else {
                Branch::Angle {
                    sine,
                    cosine,
                    jump,
                    size,
                }
            }
        };
        let extremes = self.extremes(state.t).into_iter().flat_map(|one| [one.most, one.least]);
        numbers.iter().map(branch).chain(extremes.map(Branch::Kink)).collect()
    }

    /// The force or constraint of a branch.
    pub(in crate::scene) fn law_of_branch(&self, index: usize) -> String {
        let forces = self
            .links
            .forces
            .iter()
            .filter(|push| matches!(push.law, Law::Force(_)));
        let forces = forces.map(|push| (push.branches, push.name));
        let constraints = self
            .links
            .constraints
            .iter()
            .map(|linked| (linked.spec.branches, linked.spec.name));
        let loads = self.extremes(0.0).into_iter().map(|one| (2, one.name));
        let mut names = forces
            .chain(constraints)
            .chain(loads)
            .flat_map(|(count, name)| std::iter::repeat_n(name, count));
        names.nth(index).map_or_else(String::new, |name| format!("`{name}`"))
    }
}
