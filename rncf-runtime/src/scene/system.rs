//! A scene as the integrators see it.

use super::evaluate::MOST;
use super::mesh_scene::MeshScene;
use crate::emitted::{Interpolant, JointKind};
use crate::linalg::Pattern;
use crate::scene::numbering::conditions::{Condition, row_count, width};
use crate::scene::numbering::layout::VectorKind;
use crate::scene::pieces::buffers::{Regime, Row};
use crate::scene::pieces::combination::Combination;
use crate::system::{Branch, Conserving, ConstraintLevel, Jump, Lever, State, System, Tangent};

/// Letters of the components.
const AXES: [&str; 3] = ["x", "y", "z"];

impl System for MeshScene {
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

    fn turns(&self) -> &[usize] {
        &self.turns
    }

    fn border(&self) -> usize {
        self.layout.border()
    }

    fn levers(&mut self) -> Vec<Lever> {
        self.free_levers()
    }

    fn mass(&mut self, state: &State, values: &mut [f64]) {
        values.copy_from_slice(&self.mass);
        if !self.free.is_empty() {
            self.load_state(state);
            self.add_inertia_borders(self.gravity(state.t), &Combination::only(0), values);
        }
    }

    fn residual(&mut self, state: &State, out: &mut [f64]) {
        self.load_state(state);
        self.full_force(state.t, 1.0);
        self.layout.project(&self.buffers.force, out);
    }

    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.load_state(state);
        self.full_tangent(state.t, 1.0, out);
        // Conditions on nodes and ties of frames are linear in the unknowns: they add nothing.
        self.marker_constraint_stiffness(state.t, &state.lambda, out);
        self.rigid_section_stiffness(&state.lambda, out);
    }

    fn iteration_matrix(&mut self, state: &State, factors: [f64; 3], values: &mut [f64]) {
        self.load_state(state);
        let combination = Combination::of_increments(factors, &self.turns, state);
        self.full_combination(state.t, &state.lambda, &combination, values);
    }

    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if self.constraint_rows.is_empty() {
            return;
        }
        self.load_level(level, state);
        let mut column = 0;
        for condition in self.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let joint = &self.joints[condition.joint];
            let spec = &self.bodies[joint.body].spec;
            let (count, width) = (row_count(joint.kind, spec), width(joint.kind, spec));
            let mut rows = [0.0; MOST];
            let [q, v, a] = [&self.buffers.q, &self.buffers.v, &self.buffers.a].map(|full| self.node(condition, full));
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
        self.tie_rows(level, &mut out[column..]);
        self.rigid_section_rows(level, &mut out[self.first_rigid()..]);
        let first = self.first_linked();
        self.marker_constraints(level, state.t, &mut out[first..]);
    }

    fn constraint_noise(&mut self, state: &State, out: &mut [f64]) {
        if !self.constraints.is_empty() {
            self.load_state(state);
            let first = self.first_linked();
            self.marker_constraint_noise(state.t, &mut out[first..]);
        }
    }

    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        values.fill(0.0);
        let mut column = 0;
        for condition in self.conditions.iter().filter(|condition| !condition.rows.is_empty()) {
            let joint = &self.joints[condition.joint];
            let spec = &self.bodies[joint.body].spec;
            let (count, width) = (row_count(joint.kind, spec), width(joint.kind, spec));
            let mut jacobian = [0.0; MOST * MOST];
            let entries = &mut jacobian[..count * width];
            self.parts
                .condition_jacobian(condition.joint, condition.absolute, state.t, &condition.data, entries);
            for &row in &condition.rows {
                for (place, &component) in condition.components.iter().enumerate() {
                    for (unknown, factor) in self.layout.unknowns_at(component) {
                        if let Some(entry) = self.constraint_pattern.find(unknown, column) {
                            values[entry] += factor * jacobian[row * width + place];
                        }
                    }
                }
                column += 1;
            }
        }
        self.tie_jacobian(column, values);
        if !self.constraints.is_empty() || !self.rigid_sections.is_empty() {
            self.load_state(state);
            self.rigid_section_jacobian(values);
            self.marker_jacobians(state.t, self.first_linked(), values);
        }
    }

    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        // Ties of frames are linear in the unknowns with constant coefficients.
        values.fill(0.0);
        self.condition_rate_tangents(state.t, values);
        if !self.constraints.is_empty() || !self.rigid_sections.is_empty() {
            self.load_state(state);
            self.rigid_section_rate_tangent(values);
            self.marker_rate_tangents(state.t, self.first_linked(), values);
        }
    }

    fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    fn describe_unknown(&self, index: usize) -> String {
        let border = self.layout.unknowns() - self.layout.border();
        if index >= border {
            let place = self.free.partition_point(|frame| frame.first <= index - border) - 1;
            let frame = &self.free[place];
            return frame.describe(self.parts.frame_name(frame.spec.frame), index - border - frame.first);
        }
        let (vector, component) = self.layout.origins()[index];
        let (body, node, local) = self.locate(vector);
        let what = match self.layout.kind(vector) {
            VectorKind::Directed(_) if body.spec.nodal[local].is_position() => "along its chord",
            VectorKind::InPlane { .. } if component == 1 => "shear in the section",
            VectorKind::Directed(_) | VectorKind::InPlane { .. } => "norm",
            _ => AXES[body.spec.axes[component]],
        };
        let (name, nodal) = (body.spec.label(), &body.spec.nodal[local]);
        if vector - body.first_vector >= body.spec.meshed_vectors() {
            return format!(
                "body `{name}`, element {}, normal of the section below a fixture {what}",
                node + 1
            );
        }
        let place = if nodal.xi == 0.0 {
            format!("node {node}")
        } else {
            format!("inside element {}", node + 1)
        };
        format!("body `{name}`, {place}, {} {what}", nodal.meaning)
    }

    fn describe_constraint(&self, index: usize) -> String {
        match self.constraint_rows[index] {
            Row::Condition { condition, row } => {
                let index = self.conditions[condition].joint;
                let joint = &self.joints[index];
                let spec = &self.bodies[joint.body].spec;
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
                format!("joint `{}`, {what}", self.joint_label(index))
            }
            Row::Tie { tie } => {
                let spec = &self.bodies[self.ties[tie].body].spec;
                format!("body `{}`, {}", spec.label(), spec.tie.describe())
            }
            Row::Rigid { section, row } => {
                let section = &self.rigid_sections[section];
                format!("fixture `{}`, {}", section.name, section.describe(row))
            }
            Row::Linked { linked, row } => {
                let spec = &self.constraints[linked].spec;
                let owner = match spec.kind {
                    "constraint" => format!("constraint `{}`", spec.name),
                    kind => format!("joint `{}` ({kind})", spec.name),
                };
                format!("{owner}, {}", spec.rows[row])
            }
        }
    }

    fn loose_tie(&self, worst: &str) -> Option<String> {
        self.loose_joint(worst)
    }

    fn undefined(&mut self, state: &State) -> Option<String> {
        self.load_state(state);
        self.undefined_now(state.t)
    }

    fn kinks(&self) -> Vec<f64> {
        let mut kinks: Vec<f64> = self.parts.kinks().into_iter().filter(|t| t.is_finite()).collect();
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }

    fn gaps(&self, t: f64, out: &mut Vec<[f64; 2]>) {
        self.parts.gaps(t, out);
    }

    fn too_fast(&mut self, state: &State) -> Option<String> {
        self.faster_than_light(state)
    }

    fn branches(&mut self, state: &State) -> Vec<Branch> {
        self.branches_at(state)
    }

    fn describe_branch(&self, index: usize) -> String {
        self.law_of_branch(index)
    }

    fn jumps(&mut self, state: &State, behind: f64) -> Vec<Jump> {
        self.jumps_between(state, behind)
    }

    fn energy(&mut self, state: &State) -> Option<f64> {
        self.total_energy(state)
    }

    fn conserving(&mut self) -> Result<&mut dyn Conserving, String> {
        match self.conserving_obstacle() {
            None => Ok(self),
            Some(text) => Err(text),
        }
    }
}

impl MeshScene {
    /// Fills the full state with the highest derivative of the level left out.
    fn load_level(&mut self, level: ConstraintLevel, state: &State) {
        let zeros = vec![0.0; state.x.len()];
        let (v, a) = match level {
            ConstraintLevel::Position | ConstraintLevel::Jerk => (&state.v, &state.a),
            ConstraintLevel::Velocity => (&zeros, &zeros),
            ConstraintLevel::Acceleration => (&state.v, &zeros),
        };
        self.load(state.t, &state.turns, [&state.x, v, a], Regime::Moving);
    }

    /// Rates of the coefficients of conditions on nodes, which turn with their frames. The conditions are linear
    /// in the nodal vectors, so that a coefficient is the difference of two values.
    fn condition_rate_tangents(&self, t: f64, values: &mut [f64]) {
        let none = [0.0; MOST];
        for (column, row, condition) in self.condition_columns() {
            let joint = &self.joints[condition.joint];
            let spec = &self.bodies[joint.body].spec;
            let (count, width) = (row_count(joint.kind, spec), width(joint.kind, spec));
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
                    if let Some(entry) = self.constraint_pattern.find(unknown, column) {
                        let mut unit = none;
                        unit[place] = 1.0;
                        values[entry] += factor * (rate(&unit[..width]) - still);
                    }
                }
            }
        }
    }

    /// The conditions on nodes that are kept as constraints: column, row of the condition, condition.
    fn condition_columns(&self) -> impl Iterator<Item = (usize, usize, &Condition)> {
        let rows = self
            .conditions
            .iter()
            .flat_map(|condition| condition.rows.iter().map(move |&row| (row, condition)));
        rows.enumerate()
            .map(|(column, (row, condition))| (column, row, condition))
    }
}
