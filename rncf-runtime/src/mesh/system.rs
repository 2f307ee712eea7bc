//! A scene as the integrators see it.

use super::conditions::row_count;
use super::layout::VectorKind;
use super::parts::Parts;
use super::scene::{MeshScene, Regime};
use crate::linalg::Pattern;
use crate::system::{ConstraintLevel, State, System, Tangent};

/// Letters of the components.
const AXES: [&str; 3] = ["x", "y", "z"];

impl<P: Parts> System for MeshScene<P> {
    fn unknowns(&self) -> usize {
        self.layout.unknowns()
    }

    fn constraints(&self) -> usize {
        self.constraint_rows.len()
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }

    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        values.copy_from_slice(&self.mass);
    }

    fn residual(&mut self, state: &State, out: &mut [f64]) {
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        self.full_force(state.t, 1.0);
        self.layout.project(&self.buffers.force, out);
    }

    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        out.mass.clone_from(&self.mass);
        out.stiffness.resize(self.pattern.entries(), 0.0);
        out.damping.resize(self.pattern.entries(), 0.0);
        // The conditions are linear in the unknowns: C_x^T lambda has no derivative.
        self.full_tangent(state.t, 1.0, &mut out.stiffness, &mut out.damping);
    }

    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if self.constraint_rows.is_empty() {
            return;
        }
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        let mut column = 0;
        for condition in self.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let joint = &self.joints[condition.joint];
            let count = row_count(joint.kind, self.bodies[joint.body].spec.dimension());
            let mut rows = [0.0; 6];
            let [q, v, a] = [&self.buffers.q, &self.buffers.v, &self.buffers.a].map(|full| self.node(condition, full));
            let width = 2 * self.bodies[joint.body].spec.dimension();
            self.parts.condition(
                condition.joint,
                condition.absolute,
                level,
                state.t,
                &condition.data,
                &q[..width],
                &v[..width],
                &a[..width],
                &mut rows[..count],
            );
            for &row in &condition.rows {
                out[column] = rows[row];
                column += 1;
            }
        }
    }

    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        values.fill(0.0);
        let mut column = 0;
        for condition in self.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let joint = &self.joints[condition.joint];
            let dimension = self.bodies[joint.body].spec.dimension();
            let (count, width) = (row_count(joint.kind, dimension), 2 * dimension);
            let mut jacobian = [0.0; 36];
            let entries = &mut jacobian[..count * width];
            self.parts
                .condition_jacobian(condition.joint, condition.absolute, state.t, &condition.data, entries);
            for &row in &condition.rows {
                for (place, &component) in condition.components.iter().enumerate() {
                    if let Some((unknown, factor)) = self.layout.unknown(component)
                        && let Some(entry) = self.constraint_pattern.find(unknown, column)
                    {
                        values[entry] += factor * jacobian[row * width + place];
                    }
                }
                column += 1;
            }
        }
    }

    fn constraint_rate_tangent(&mut self, _state: &State, values: &mut [f64]) {
        // The conditions are linear in the unknowns.
        values.fill(0.0);
    }

    fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    fn describe_unknown(&self, index: usize) -> String {
        let (vector, component) = self.layout.origins()[index];
        let (body, node, local) = self.locate(vector);
        let what = match self.layout.kind(vector) {
            VectorKind::Directed(_) => "norm",
            _ => AXES[body.spec.axes[component]],
        };
        format!(
            "body `{}`, node {node}, {} {what}",
            body.spec.name, body.spec.meanings[local]
        )
    }

    fn describe_constraint(&self, index: usize) -> String {
        let (condition, row) = self.constraint_rows[index];
        let joint = &self.joints[self.conditions[condition].joint];
        let dimension = self.bodies[joint.body].spec.dimension();
        let what = if row < dimension { "position" } else { "direction" };
        format!("joint `{}`, {what}", joint.name)
    }

    fn kinks(&self) -> Vec<f64> {
        let mut kinks: Vec<f64> = self.parts.kinks().into_iter().filter(|t| t.is_finite()).collect();
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }

    fn energy(&mut self, state: &State) -> Option<f64> {
        self.total_energy(state)
    }
}
