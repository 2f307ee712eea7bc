//! Angles that forces and constraints read by their sines and cosines, and kinks and peaks of forces.

use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::push::Law;
use crate::system::{Branch, State};

/// What is written in the place of the jump of an angle: -1 of a kink, -2 of a peak.
const KINK: f64 = -1.0;

impl MeshScene {
    /// Number of these angles, kinks and peaks.
    pub(crate) fn angles_read(&self) -> usize {
        let of_constraints: usize = self.links.constraints.iter().map(|linked| linked.spec.branches).sum();
        self.branches_of_forces() + of_constraints
    }

    /// Those of forces, which stand before those of constraints.
    fn branches_of_forces(&self) -> usize {
        self.links.forces.iter().map(|push| push.branches).sum()
    }

    /// Whether a branch is of a constraint.
    pub(in crate::scene) fn is_constrained_by_branch(&self, index: usize) -> bool {
        index >= self.branches_of_forces()
    }

    /// Of all forces, then of all constraints.
    pub(in crate::scene) fn branches_at(&mut self, state: &State) -> Vec<Branch> {
        let count = self.angles_read();
        if count == 0 {
            return Vec::new();
        }
        self.load_state(state);
        let mut numbers = vec![[0.0; 4]; count];
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
        numbers.iter().map(branch).collect()
    }

    /// The force or constraint of a branch.
    pub(in crate::scene) fn law_of_branch(&self, index: usize) -> String {
        let forces = self.links.forces.iter().map(|spec| (spec.branches, spec.name));
        let constraints = self
            .links
            .constraints
            .iter()
            .map(|linked| (linked.spec.branches, linked.spec.name));
        let mut names = forces
            .chain(constraints)
            .flat_map(|(count, name)| std::iter::repeat_n(name, count));
        names.nth(index).map_or_else(String::new, |name| format!("`{name}`"))
    }
}
