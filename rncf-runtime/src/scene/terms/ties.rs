//! Rows of the bodies that free frames follow.

use crate::emitted::{Fidelity, Interpolant, JointKind};
use crate::scene::MeshScene;
use crate::system::ConstraintLevel;

impl MeshScene {
    /// Rows of all ties at the loaded state.
    pub(crate) fn tie_rows(&self, level: ConstraintLevel, out: &mut [f64]) {
        let buffers = &self.buffers;
        let full = match level {
            ConstraintLevel::Position => &buffers.q,
            ConstraintLevel::Velocity => &buffers.v,
            ConstraintLevel::Acceleration => &buffers.a,
            ConstraintLevel::Jerk => &buffers.jerks,
        };
        let mut place = 0;
        for tie in &self.ties {
            for (value, reference) in tie.values(full).zip(&tie.reference) {
                out[place] = if level == ConstraintLevel::Position {
                    value - reference
                } else {
                    value
                };
                place += 1;
            }
        }
    }

    /// Adds the Jacobians of all ties from column `column` on.
    pub(crate) fn tie_jacobian(&self, mut column: usize, values: &mut [f64]) {
        for tie in &self.ties {
            for row in &tie.rows {
                for (component, value) in tie.entries(row) {
                    for (unknown, factor) in self.layout.unknowns_at(component) {
                        if let Some(entry) = self.constraint_pattern.find(unknown, column) {
                            values[entry] += factor * value;
                        }
                    }
                }
                column += 1;
            }
        }
    }

    /// What [`crate::system::System::loose_tie`] tells.
    pub(crate) fn loose_joint(&self, worst: &str) -> Option<String> {
        self.joints.iter().enumerate().find_map(|(index, joint)| {
            let spec = &self.bodies[joint.body].spec;
            let frame = &self.free[self.free_of[joint.frame]?];
            let is_own = joint.frame == spec.frame && spec.fidelity == Fidelity::Full;
            let turns = match joint.kind {
                JointKind::Clamp | JointKind::ClampFull => true,
                JointKind::Hold { of, order, .. } => (of, order) != (Interpolant::Position, 0),
                JointKind::Pin => false,
            };
            let carried = self.bodies.iter().any(|body| body.spec.frame == joint.frame && !body.spec.fidelity.deforms());
            let end = if joint.at_end { 1.0 } else { 0.0 };
            let carried = carried
                || self.fixtures.iter().any(|fixture| {
                    let last = if joint.at_end { spec.count - 1 } else { 0 };
                    let is_there = fixture.point.body == joint.body && fixture.point.element == last;
                    is_there && fixture.point.xi == end && fixture.spec.constants[4..].iter().any(|moment| *moment != 0.0)
                });
            if !is_own || !turns || carried || frame.has_rigid_parts() {
                return None;
            }
            let (name, body) = (self.parts.frame_name(joint.frame), spec.label());
            let named = |name: &str| worst.contains(&format!("`{name}`"));
            let what = if spec.has_section() { "section" } else { "slope" };
            (named(name) || named(&body)).then(|| {
                format!(
                    "joint `{}` turns frame `{name}`, which has no mass of its own, with the {what} at an end of body `{body}`, where only a part of an element resists; let the frame follow the body, `chord;` or `mean_axes;`, or give it mass with a fixture",
                    self.joint_label(index)
                )
            })
        })
    }
}
