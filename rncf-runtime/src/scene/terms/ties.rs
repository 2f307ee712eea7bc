//! Rows of the bodies that free frames follow: linear in the unknowns, with constant coefficients.

use super::constraint::Constraint;
use crate::emitted::{Fidelity, Interpolant, JointKind};
use crate::scene::MeshScene;
use crate::scene::frames::ties::Tie;
use crate::scene::pieces::combined::Combined;
use crate::system::{ConstraintLevel, Tangent};

/// Frames that follow bodies.
pub(crate) struct Ties;

impl Constraint for Ties {
    fn rows(&self, scene: &MeshScene) -> Vec<Vec<usize>> {
        let rows = |tie: &Tie| {
            let rows = tie.rows.iter();
            let unknowns = rows.map(|row| scene.unknowns_of(tie.entries(row).map(|(component, _)| component)));
            unknowns.collect::<Vec<_>>()
        };
        scene.frames.ties.iter().flat_map(rows).collect()
    }

    /// Nothing: they are linear.
    fn couple(&self, _: &MeshScene, _: &mut Vec<(usize, usize)>) {}

    fn describe(&self, scene: &MeshScene, row: usize) -> String {
        let mut bodies = scene
            .frames
            .ties
            .iter()
            .flat_map(|tie| tie.rows.iter().map(|_| tie.body));
        let spec = bodies.nth(row).map(|body| &scene.bodies[body].spec);
        spec.map_or(String::new(), |spec| {
            format!("body `{}`, {}", spec.label(), spec.tie.describe())
        })
    }

    fn is_curved(&self, _: &MeshScene) -> bool {
        false
    }

    fn values(&self, scene: &MeshScene, level: ConstraintLevel, _: f64, rows: &mut [f64]) {
        let buffers = &scene.buffers;
        let full = match level {
            ConstraintLevel::Position => &buffers.q,
            ConstraintLevel::Velocity => &buffers.v,
            ConstraintLevel::Acceleration => &buffers.a,
            ConstraintLevel::Jerk => &buffers.jerks,
        };
        let mut rows = rows.iter_mut();
        for tie in &scene.frames.ties {
            for ((value, reference), out) in tie.values(full).zip(&tie.reference).zip(&mut rows) {
                *out = if level == ConstraintLevel::Position {
                    value - reference
                } else {
                    value
                };
            }
        }
    }

    fn add_jacobian(&self, scene: &MeshScene, _: f64, first: usize, values: &mut [f64]) {
        let rows = scene
            .frames
            .ties
            .iter()
            .flat_map(|tie| tie.rows.iter().map(move |row| tie.entries(row)));
        for (place, entries) in rows.enumerate() {
            for (component, value) in entries {
                scene.add_to_row(component, first + place, value, values);
            }
        }
    }

    /// Nothing: their coefficients are constant.
    fn add_rate_tangent(&self, _: &MeshScene, _: f64, _: usize, _: &mut [f64]) {}

    /// Nothing: they are linear.
    fn add_stiffness(&self, _: &MeshScene, _: f64, _: &[f64], _: &mut Tangent) {}

    /// Nothing: they are linear.
    fn add_combined(&self, _: &MeshScene, _: f64, _: &[f64], _: &mut Combined) {}

    /// None: what they compare are the unknowns themselves.
    fn noise(&self, _: &MeshScene, _: f64, _: &mut [f64]) {}
}

impl MeshScene {
    /// What [`crate::system::System::loose_tie`] tells.
    pub(crate) fn loose_joint(&self, worst: &str) -> Option<String> {
        self.joints.iter().enumerate().find_map(|(index, joint)| {
            let spec = &self.bodies[joint.body].spec;
            let frame = &self.frames.free[self.frames.free_of[joint.frame]?];
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
