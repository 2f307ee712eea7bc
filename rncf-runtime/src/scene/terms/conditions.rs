//! Conditions of joints on nodes that keep multipliers: linear in the nodal vectors, with coefficients that turn with
//! the joint's frame.

use super::constraint::Constraint;
use crate::emitted::{Interpolant, JointKind};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::conditions::{Condition, row_count, width};
use crate::scene::pieces::combined::Combined;
use crate::system::{ConstraintLevel, Tangent};

/// Most components of a node's vectors that a joint is about, and most of its conditions.
const MOST: usize = 9;

/// Joints between a node and a frame.
pub(crate) struct Conditions;

impl Constraint for Conditions {
    fn rows(&self, scene: &MeshScene) -> Vec<Vec<usize>> {
        let rows = scene.condition_rows();
        rows.map(|(.., condition)| scene.unknowns_of(condition.components.iter().copied()))
            .collect()
    }

    /// Nothing: they are linear.
    fn couple(&self, _: &MeshScene, _: &mut Vec<(usize, usize)>) {}

    fn describe(&self, scene: &MeshScene, row: usize) -> String {
        let Some((_, row, condition)) = scene.condition_rows().nth(row) else {
            return String::new();
        };
        let joint = &scene.joints[condition.joint];
        let spec = &scene.bodies[joint.body].spec;
        let dimension = spec.dimension();
        let what = match joint.kind {
            JointKind::Hold { of, order, .. } => match (of, order) {
                (Interpolant::Position, 0) => "held position",
                (Interpolant::Position, _) => "held slope",
                (Interpolant::SectionY, _) => "held section y axis",
                (Interpolant::SectionZ, _) => "held section z axis",
            },
            _ if row < dimension => "position",
            _ if !spec.has_section() => "direction",
            JointKind::ClampFull if row < 2 * dimension => "section y axis",
            JointKind::ClampFull => "section z axis",
            _ if row == dimension => "direction of the section y axis",
            _ if row == dimension + 1 => "direction of the section z axis",
            _ => "twist of the section",
        };
        format!("joint `{}`, {what}", scene.joint_label(condition.joint))
    }

    fn is_curved(&self, _: &MeshScene) -> bool {
        false
    }

    fn values(&self, scene: &MeshScene, level: ConstraintLevel, t: f64, rows: &mut [f64]) {
        let mut out = rows.iter_mut();
        for condition in scene.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let (count, width) = scene.extent_of(condition);
            let mut rows = [0.0; MOST];
            let [q, v, a] = [&scene.buffers.q, &scene.buffers.v, &scene.buffers.a].map(|full| node(condition, full));
            scene.parts.condition(
                condition.joint,
                condition.absolute,
                level,
                t,
                &condition.data,
                &q[..width],
                &v[..width],
                &a[..width],
                &mut rows[..count],
            );
            for (&row, out) in condition.rows.iter().zip(&mut out) {
                *out = rows[row];
            }
        }
    }

    fn add_jacobian(&self, scene: &MeshScene, t: f64, first: usize, values: &mut [f64]) {
        let mut column = first;
        for condition in scene.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let (count, width) = scene.extent_of(condition);
            let mut jacobian = [0.0; MOST * MOST];
            let entries = &mut jacobian[..count * width];
            scene
                .parts
                .condition_jacobian(condition.joint, condition.absolute, t, &condition.data, entries);
            for &row in &condition.rows {
                for (place, &component) in condition.components.iter().enumerate() {
                    scene.add_to_row(component, column, jacobian[row * width + place], values);
                }
                column += 1;
            }
        }
    }

    fn add_rate_tangent(&self, scene: &MeshScene, t: f64, first: usize, values: &mut [f64]) {
        scene.condition_rate_tangents(t, first, values);
    }

    /// Nothing: they are linear.
    fn add_stiffness(&self, _: &MeshScene, _: f64, _: &[f64], _: &mut Tangent) {}

    /// Nothing: they are linear.
    fn add_combined(&self, _: &MeshScene, _: f64, _: &[f64], _: &mut Combined) {}

    /// None: what they compare are the unknowns themselves.
    fn noise(&self, _: &MeshScene, _: f64, _: &mut [f64]) {}
}

/// The vectors of a condition's node in one of the full arrays.
fn node(condition: &Condition, full: &[f64]) -> [f64; MOST] {
    let mut node = [0.0; MOST];
    for (place, &component) in condition.components.iter().enumerate() {
        node[place] = full[component];
    }
    node
}

impl MeshScene {
    /// Number of rows of a condition, eliminated ones included, and of components that they are about.
    fn extent_of(&self, condition: &Condition) -> (usize, usize) {
        let joint = &self.joints[condition.joint];
        let spec = &self.bodies[joint.body].spec;
        (row_count(joint.kind, spec), width(joint.kind, spec))
    }

    /// Rates of the coefficients of conditions on nodes, which turn with their frames. The conditions are linear
    /// in the nodal vectors, so that a coefficient is the difference of two values.
    fn condition_rate_tangents(&self, t: f64, first: usize, values: &mut [f64]) {
        let none = [0.0; MOST];
        for (place, row, condition) in self.condition_rows() {
            let column = first + place;
            let (count, width) = self.extent_of(condition);
            let rate = |q: &[f64]| {
                let mut rows = [0.0; MOST];
                self.parts.condition(
                    condition.joint,
                    condition.absolute,
                    ConstraintLevel::Velocity,
                    t,
                    &condition.data,
                    q,
                    &none[..width],
                    &none[..width],
                    &mut rows[..count],
                );
                rows[row]
            };
            let still = rate(&none[..width]);
            for (place, &component) in condition.components.iter().enumerate() {
                for (unknown, factor) in self.layout.unknowns_at(component) {
                    if let Some(entry) = self.tabulated.constraint_pattern.find(unknown, column) {
                        let mut unit = none;
                        unit[place] = 1.0;
                        values[entry] += factor * (rate(&unit[..width]) - still);
                    }
                }
            }
        }
    }

    /// The conditions on nodes that are kept as constraints: row, row of the condition, condition.
    fn condition_rows(&self) -> impl Iterator<Item = (usize, usize, &Condition)> {
        let rows = self
            .conditions
            .iter()
            .flat_map(|condition| condition.rows.iter().map(move |&row| (row, condition)));
        rows.enumerate()
            .map(|(column, (row, condition))| (column, row, condition))
    }
}
