//! A scene as the integrators see it.

use super::jumps;
use super::mesh_scene::MeshScene;
use crate::course::{Courses, Path};
use crate::linalg::Pattern;
use crate::scene::numbering::layout::VectorKind;
use crate::scene::pieces::buffers::Regime;
use crate::scene::pieces::combination::Combination;
use crate::scene::terms::kinds::CONSTRAINTS;
use crate::system::{Branch, Conserving, ConstraintLevel, Jump, Lever, State, System, Tangent};

/// Letters of the components.
const AXES: [&str; 3] = ["x", "y", "z"];

impl System for MeshScene {
    fn unknowns(&self) -> usize {
        self.layout.unknowns()
    }

    fn constraints(&self) -> usize {
        self.tabulated.rows.count()
    }

    fn pattern(&self) -> &Pattern {
        &self.tabulated.pattern
    }

    fn constraint_pattern(&self) -> &Pattern {
        &self.tabulated.constraint_pattern
    }

    fn turns(&self) -> &[usize] {
        &self.frames.turns
    }

    fn states(&self) -> &[usize] {
        &self.frames.states
    }

    fn border(&self) -> usize {
        self.layout.border()
    }

    fn levers(&mut self) -> Vec<Lever> {
        self.free_levers()
    }

    fn mass(&mut self, state: &State, values: &mut [f64]) {
        values.copy_from_slice(&self.tabulated.mass);
        if !self.frames.free.is_empty() {
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
        self.add_constraint_stiffness(state.t, &state.lambda, out);
    }

    fn elastic_stiffness(&mut self, state: &State, values: &mut [f64]) {
        self.load_state(state);
        values.fill(0.0);
        self.add_elastic_stiffness(values);
    }

    fn iteration_matrix(&mut self, state: &State, factors: [f64; 3], values: &mut [f64]) {
        self.load_state(state);
        let combination = Combination::of_increments(factors, &self.frames.turns, state);
        self.full_combination(state.t, &state.lambda, &combination, values);
    }

    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if self.constraints() == 0 {
            return;
        }
        self.load_level(level, state);
        self.constraint_values(level, state.t, out);
    }

    fn constraint_noise(&mut self, state: &State, out: &mut [f64]) {
        if CONSTRAINTS.iter().any(|constraint| constraint.is_curved(self)) {
            self.load_state(state);
            for (constraint, rows) in CONSTRAINTS.iter().zip(self.tabulated.rows.ranges()) {
                constraint.noise(self, state.t, &mut out[rows]);
            }
        }
    }

    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        if CONSTRAINTS.iter().any(|constraint| constraint.is_curved(self)) {
            self.load_state(state);
        }
        self.constraint_derivatives(state.t, values);
    }

    fn equations(&mut self, state: &State, residual: &mut [f64], constraint: &mut [f64], jacobian: Option<&mut [f64]>) {
        // The state is loaded once; constraints come first, as forces set the fields of the frames.
        self.load_state(state);
        self.constraint_values(ConstraintLevel::Position, state.t, constraint);
        if let Some(values) = jacobian {
            self.constraint_derivatives(state.t, values);
        }
        self.full_force(state.t, 1.0);
        self.layout.project(&self.buffers.force, residual);
    }

    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        values.fill(0.0);
        if CONSTRAINTS.iter().any(|constraint| constraint.is_curved(self)) {
            self.load_state(state);
        }
        for (constraint, rows) in CONSTRAINTS.iter().zip(self.tabulated.rows.ranges()) {
            constraint.add_rate_tangent(self, state.t, rows.start, values);
        }
    }

    fn sizes(&self) -> &[f64] {
        &self.tabulated.sizes
    }

    fn describe_unknown(&self, index: usize) -> String {
        let border = self.layout.unknowns() - self.layout.border();
        if index >= border {
            let place = self.frames.free.partition_point(|frame| frame.first <= index - border) - 1;
            let frame = &self.frames.free[place];
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
        let (kind, row) = self.tabulated.rows.locate(index);
        CONSTRAINTS[kind].describe(self, row)
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

    fn courses(&self) -> Vec<Courses> {
        let mut courses = self.parts.courses();
        courses.extend(self.courses_of_forces());
        courses
    }

    fn paths(&mut self, state: &State, readers: &[Vec<usize>]) -> Vec<Vec<Path>> {
        self.load_state(state);
        readers.iter().map(|markers| self.paths_of(markers, state.t)).collect()
    }

    fn reads_multipliers(&self) -> bool {
        self.observes_multipliers()
    }

    fn turns_in_unknowns(&self) -> bool {
        (0..self.bodies.len()).any(|body| self.may_turn_in_its_axes(body))
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

    fn is_branch_of_constraint(&self, index: usize) -> bool {
        self.is_constrained_by_branch(index)
    }

    fn jumps(&mut self, state: &State, behind: f64) -> Vec<Jump> {
        self.jumps_between(state, behind)
    }

    fn jolt(&mut self, state: &State, behind: f64, out: &mut [f64]) {
        let jolt = self.velocity_jumps(state, behind);
        jumps::inertia(self, |scene| scene, (state, behind), jolt, out);
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
    /// Values of all constraints at the loaded state.
    fn constraint_values(&self, level: ConstraintLevel, t: f64, out: &mut [f64]) {
        for (constraint, rows) in CONSTRAINTS.iter().zip(self.tabulated.rows.ranges()) {
            constraint.values(self, level, t, &mut out[rows]);
        }
    }

    /// `C_x^T` at the loaded state.
    fn constraint_derivatives(&self, t: f64, values: &mut [f64]) {
        values.fill(0.0);
        for (constraint, rows) in CONSTRAINTS.iter().zip(self.tabulated.rows.ranges()) {
            constraint.add_jacobian(self, t, rows.start, values);
        }
    }

    /// Fills the full state with the highest derivative of the level left out.
    fn load_level(&mut self, level: ConstraintLevel, state: &State) {
        let zeros = || vec![0.0; state.x.len()];
        match level {
            ConstraintLevel::Position | ConstraintLevel::Jerk => self.load_state(state),
            ConstraintLevel::Velocity => self.load_rates(state, [&zeros(), &zeros()]),
            ConstraintLevel::Acceleration => self.load_rates(state, [&state.v, &zeros()]),
        }
    }

    /// Fills the full state with these velocities and accelerations.
    fn load_rates(&mut self, state: &State, [v, a]: [&[f64]; 2]) {
        self.load(state.t, &state.turns, [&state.x, v, a], Regime::Moving);
    }
}
