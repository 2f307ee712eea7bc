//! Scenes with modal bodies: the scene with all nodal vectors in front of the map of [`Reduction`].
//! Loads, markers, constraints and outputs see nodal vectors; inertia and elasticity of the modal
//! bodies come from their constants.

use std::sync::Arc;

use super::action::FrameAction;
use super::body::ModalBody;
use super::carried::Beside;
use super::reduction::{Block, Reduction};
use super::softening::LossOfStiffness;
use crate::course::{Courses, Path};
use crate::emitted::{Fidelity, Parts};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::model::{Formulation, Joints, Scene, Warning};
use crate::scene::MeshScene;
use crate::scene::bodies::described::{Elements, Kernels};
use crate::scene::jumps;
use crate::scene::levers::Inertia;
use crate::space::Vector;
use crate::system::{Branch, Conserving, ConstraintLevel, Jump, Lever, State, System, Tangent};

/// Builds the scene of a model with emitted parts: with modal coordinates where a body asks for them, and with bodies, by
/// their names, described otherwise than they are declared.
///
/// # Errors
/// A parameter that makes no physical sense, and a body whose modes do not exist or do not suffice, by name.
pub fn build_as(
    parts: impl Parts,
    formulation: Formulation,
    joints: Joints,
    fidelity: &[(String, Fidelity)],
) -> Result<Box<dyn Scene>, ModelError> {
    build_boxed(Box::new(parts), formulation, joints, fidelity)
}

fn build_boxed(
    parts: Box<dyn Parts>,
    formulation: Formulation,
    joints: Joints,
    fidelity: &[(String, Fidelity)],
) -> Result<Box<dyn Scene>, ModelError> {
    as_described(MeshScene::new(parts, formulation, joints, fidelity)?)
}

/// With modes where bodies have some.
pub(super) fn as_described(scene: MeshScene) -> Result<Box<dyn Scene>, ModelError> {
    if scene.bodies.iter().all(|body| body.spec.fidelity == Fidelity::Full) {
        return Ok(Box::new(scene));
    }
    Ok(Box::new(ModalScene::new(scene)?))
}

/// The deflection that modes have described worst so far.
#[derive(Clone, Debug)]
pub(super) struct Told {
    /// As [`ModalBody::hindrance`] or [`ModalBody::linear_work`].
    pub deflection: f64,
    /// What is told of it, if anything.
    pub warning: Option<Warning>,
}

/// A scene some of whose bodies have modal coordinates.
pub struct ModalScene {
    /// With all nodal vectors; the elements of modal bodies are left out.
    pub(super) scene: MeshScene,
    pub(super) reduction: Reduction,
    /// Body of every block of the reduction, and what describes it.
    pub(super) bodies: Vec<usize>,
    pub(super) modes: Vec<Arc<ModalBody>>,
    pub(super) pattern: Pattern,
    pub(super) constraint_pattern: Pattern,
    pub(super) turns: Vec<usize>,
    pub(super) states: Vec<usize>,
    pub(super) sizes: Vec<f64>,
    /// Mass matrix of the nodal vectors with all elements, for the energy.
    whole_mass: Vec<f64>,
    /// By body, where its modes have described its deflection worst.
    pub(super) worst: Vec<Option<Told>>,
    /// By body, the spin at which tension was asked for last, and what its modes lack of it.
    pub(super) tightened: Vec<Option<(Vector, Option<LossOfStiffness>)>>,
    /// The state with all nodal vectors.
    pub(super) full: State,
    pub(super) tangent: Tangent,
    pub(super) scratch: Vec<f64>,
}

impl ModalScene {
    /// Finds the modes of the bodies that ask for them.
    ///
    /// # Errors
    /// As [`build_as`].
    pub(super) fn new(mut scene: MeshScene) -> Result<Self, ModelError> {
        let (mut blocks, mut bodies, mut all) = (Vec::new(), Vec::new(), Vec::new());
        for index in 0..scene.bodies.len() {
            let fidelity = scene.bodies[index].spec.fidelity;
            if fidelity == Fidelity::Full {
                continue;
            }
            scene.check_modal(index)?;
            let (nodal, first) = scene.nodal(index);
            scene.check_hanging(index, &nodal)?;
            let elements = Kernels {
                parts: &*scene.parts,
                body: index,
            };
            let modes = match scene.elsewhere(index)? {
                Some(body) => {
                    let held = scene.held_interfaces(index, &body)?;
                    ModalBody::imported(nodal, &scene.bodies[index].spec, &body, &held)?
                }
                None => ModalBody::new(nodal, fidelity, &elements)?,
            };
            scene.remarks.extend(modes.remarks());
            let modes = Arc::new(modes);
            blocks.push(Block::new(&modes, first));
            bodies.push(index);
            scene.bodies[index].modes = Some(modes.clone());
            all.push(modes);
            scene.check_loose(index)?;
        }
        let whole_mass = scene.tabulated.mass.clone();
        scene.in_modes = true;
        scene.assemble_mass();
        let reduction = Reduction::new(blocks, scene.unknowns());
        let pattern = reduction.square(scene.pattern());
        let constraint_pattern = reduction.rows(scene.constraint_pattern());
        let turns = scene.turns().iter().filter_map(|&turn| reduction.same(turn)).collect();
        let states = scene
            .states()
            .iter()
            .filter_map(|&state| reduction.same(state))
            .collect();
        let mut sizes = vec![0.0; reduction.unknowns()];
        for (unknown, &size) in scene.sizes().iter().enumerate() {
            if let Some(place) = reduction.same(unknown) {
                sizes[place] = size;
            }
        }
        for (block, modes) in reduction.blocks().iter().zip(&all) {
            sizes[block.coordinate..][..block.count].copy_from_slice(modes.sizes());
        }
        let entries = scene.pattern().entries();
        let zeros = || vec![0.0; entries];
        Ok(Self {
            modes: all,
            whole_mass,
            worst: vec![None; scene.bodies.len()],
            tightened: vec![None; scene.bodies.len()],
            full: State::of(&scene, 0.0),
            tangent: Tangent {
                mass: zeros(),
                stiffness: zeros(),
                damping: zeros(),
            },
            scratch: vec![0.0; scene.unknowns()],
            scene,
            reduction,
            bodies,
            pattern,
            constraint_pattern,
            turns,
            states,
            sizes,
        })
    }

    /// The map from modal coordinates.
    #[cfg(test)]
    pub(super) fn reduction(&self) -> &Reduction {
        &self.reduction
    }

    /// Expands the state to all nodal vectors.
    pub(super) fn expand(&mut self, state: &State) {
        let full = &mut self.full;
        full.t = state.t;
        full.turns.clone_from(&state.turns);
        full.lambda.clone_from(&state.lambda);
        self.reduction.expand(&state.x, true, &mut full.x);
        self.reduction.expand(&state.v, false, &mut full.v);
        self.reduction.expand(&state.a, false, &mut full.a);
    }

    /// The state with modal coordinates.
    pub(super) fn restricted(&self, full: &State) -> State {
        State {
            t: full.t,
            x: self.reduction.restrict(&full.x, true),
            turns: full.turns.clone(),
            v: self.reduction.restrict(&full.v, false),
            a: self.reduction.restrict(&full.a, false),
            lambda: full.lambda.clone(),
        }
    }

    /// Calls with every body that has modes: its block, the body, its modes, elements and frame at the
    /// loaded state.
    pub(super) fn each_body(
        &self,
        gravity: Vector,
        mut call: impl FnMut(&Block, usize, &ModalBody, &dyn Elements, &FrameAction),
    ) {
        for (place, (block, &index)) in self.reduction.blocks().iter().zip(&self.bodies).enumerate() {
            let body = &self.scene.bodies[index];
            let action = self.scene.buffers.frames[body.frame].action(body.spec.axes, gravity);
            let elements = Kernels {
                parts: &*self.scene.parts,
                body: index,
            };
            call(block, index, &self.modes[place], &elements, &action);
        }
    }

    pub(super) fn gravity(&self, t: f64, load_scale: f64) -> Vector {
        self.scene.gravity(t).map(|g| load_scale * g)
    }

    /// Residual at the loaded state with the unknowns and their derivatives.
    pub(super) fn residual_of(&mut self, t: f64, load_scale: f64, at: [&[f64]; 3], out: &mut [f64]) {
        self.scene.full_force(t, load_scale);
        let gravity = self.gravity(t, load_scale);
        let mut carried = Vec::new();
        let mut modal = vec![0.0; out.len()];
        self.each_body(gravity, |block, index, modes, elements, action| {
            let own = block.coordinate..block.coordinate + block.count;
            let at = at.map(|values| &values[own.clone()]);
            modes.force(elements, action, at, &mut modal[own.clone()]);
            let body = &self.scene.bodies[index];
            if let Some(free) = self.scene.frames.free_of[body.frame] {
                let mut rows = vec![0.0; if body.spec.dimension() == 2 { 3 } else { 6 }];
                modes.carried(action, at, &mut rows);
                carried.push((free, body.spec.axes, rows));
            }
        });
        for (free, axes, rows) in carried {
            self.scene.add_to_frame(free, axes, &rows);
        }
        self.scene.layout.project(&self.scene.buffers.force, &mut self.scratch);
        self.reduction.project(&self.scratch, out);
        out.iter_mut().zip(modal).for_each(|(sum, value)| *sum += value);
    }

    /// Adds to the tangent of the nodal vectors what modal bodies make among the unknowns of free
    /// frames, and returns what they make beside them, block by block.
    pub(super) fn beside(&mut self, t: f64, load_scale: f64, state: &State) -> Vec<Option<Beside>> {
        let gravity = self.gravity(t, load_scale);
        let pairs = self.reduction.blocks().iter().zip(&self.bodies).zip(&self.modes);
        pairs
            .map(|((block, &body), modes)| {
                let own = block.coordinate..block.coordinate + block.count;
                let at = [&state.x, &state.v, &state.a].map(|values| &values[own.clone()]);
                self.scene
                    .add_carried_modes(body, modes, at, gravity, &mut self.tangent)
            })
            .collect()
    }

    /// Adds a k x n block of frame rows and an n x k block of modal rows.
    pub(super) fn add_beside(&self, block: &Block, beside: &Beside, lower: &[f64], upper: &[f64], values: &mut [f64]) {
        let (k, n) = (beside.count, block.count);
        let Some(frame) = self.reduction.same(beside.first) else {
            return;
        };
        for i in 0..k {
            for c in 0..n {
                if let Some(entry) = self.pattern.find(frame + i, block.coordinate + c) {
                    values[entry] += lower[i * n + c];
                }
                if let Some(entry) = self.pattern.find(block.coordinate + c, frame + i) {
                    values[entry] += upper[c * k + i];
                }
            }
        }
    }

    /// Adds an n x n block of modal rows and columns.
    pub(super) fn add_modal(&self, block: &Block, matrix: &[f64], values: &mut [f64]) {
        let n = block.count;
        for (place, value) in matrix.iter().enumerate() {
            if let Some(entry) = self
                .pattern
                .find(block.coordinate + place / n, block.coordinate + place % n)
            {
                values[entry] += value;
            }
        }
    }

    /// Reduces the mass of the nodal vectors and adds that of the modes.
    pub(super) fn reduce_mass(&self, beside: &[Option<Beside>], values: &mut [f64]) {
        let from = self.scene.pattern();
        self.reduction
            .reduce_square(from, &self.tangent.mass, &self.pattern, values);
        self.each_body(Vector::zeros(), |block, _, modes, _, _| {
            self.add_modal(block, modes.mass(), values)
        });
        for (block, beside) in self.reduction.blocks().iter().zip(beside) {
            if let Some(beside) = beside {
                let transposed = transposed(&beside.mass, beside.count, block.count);
                self.add_beside(block, beside, &beside.mass, &transposed, values);
            }
        }
    }

    /// Reduces the tangent of the nodal vectors at the loaded state and adds what the modes make.
    pub(super) fn reduce_tangent(&mut self, t: f64, load_scale: f64, state: &State, out: &mut Tangent) {
        let beside = self.beside(t, load_scale, state);
        let entries = self.pattern.entries();
        for values in [&mut out.mass, &mut out.stiffness, &mut out.damping] {
            values.resize(entries, 0.0);
        }
        self.reduce_mass(&beside, &mut out.mass);
        let (from, to) = (self.scene.pattern(), &self.pattern);
        let Tangent { stiffness, damping, .. } = &self.tangent;
        self.reduction.reduce_square(from, stiffness, to, &mut out.stiffness);
        self.reduction.reduce_square(from, damping, to, &mut out.damping);
        self.each_body(self.gravity(t, load_scale), |block, _, modes, elements, action| {
            let own = block.coordinate..block.coordinate + block.count;
            let square = block.count * block.count;
            let (mut k, mut c) = (vec![0.0; square], vec![0.0; square]);
            let at = [&state.x[own.clone()], &state.v[own]];
            modes.tangent(elements, action, at, &mut k, &mut c);
            self.add_modal(block, &k, &mut out.stiffness);
            self.add_modal(block, &c, &mut out.damping);
        });
        for (block, beside) in self.reduction.blocks().iter().zip(&beside) {
            if let Some(beside) = beside {
                let [lower, upper] = &beside.stiffness;
                self.add_beside(block, beside, lower, upper, &mut out.stiffness);
                let [lower, upper] = &beside.damping;
                self.add_beside(block, beside, lower, upper, &mut out.damping);
            }
        }
    }

    /// Calls with the scene in which modal bodies are made of elements, for what is read off it.
    pub(super) fn in_elements<T>(&mut self, call: impl FnOnce(&mut MeshScene, &State) -> T) -> T {
        self.scene.in_modes = false;
        let result = call(&mut self.scene, &self.full);
        self.scene.in_modes = true;
        result
    }

    pub(super) fn is_small(&self) -> bool {
        let small = |&body: &usize| matches!(self.scene.bodies[body].spec.fidelity, Fidelity::Small(_));
        self.bodies.iter().any(small)
    }
}

/// The n x k transpose of a k x n matrix.
fn transposed(matrix: &[f64], k: usize, n: usize) -> Vec<f64> {
    (0..n).flat_map(|c| (0..k).map(move |i| matrix[i * n + c])).collect()
}

impl System for ModalScene {
    fn unknowns(&self) -> usize {
        self.reduction.unknowns()
    }

    fn conserving(&mut self) -> Result<&mut dyn Conserving, String> {
        let body = self
            .bodies
            .first()
            .map_or("", |&body| self.scene.bodies[body].spec.name);
        Err(format!(
            "body `{body}` is described by modes or is rigid: energy-momentum integration needs all its nodal vectors"
        ))
    }

    fn constraints(&self) -> usize {
        self.scene.constraints()
    }

    fn turns(&self) -> &[usize] {
        &self.turns
    }

    fn states(&self) -> &[usize] {
        &self.states
    }

    fn border(&self) -> usize {
        self.scene.border()
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }

    fn levers(&mut self) -> Vec<Lever> {
        if self.scene.frames.free.is_empty() {
            return Vec::new();
        }
        let start = self.restricted(&self.scene.rest(0.0));
        let mut mass = vec![0.0; self.pattern.entries()];
        self.mass(&start, &mut mass);
        Inertia::new(self, &start.x, &mass).levers(&self.scene.frames.free)
    }

    fn mass(&mut self, state: &State, values: &mut [f64]) {
        self.expand(state);
        self.scene.load_state(&self.full);
        self.scene.mass(&self.full, &mut self.tangent.mass);
        let beside = self.beside(state.t, 1.0, state);
        self.reduce_mass(&beside, values);
    }

    fn residual(&mut self, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.scene.load_state(&self.full);
        self.residual_of(state.t, 1.0, [&state.x, &state.v, &state.a], out);
    }

    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.expand(state);
        self.scene.tangent(&self.full, &mut self.tangent);
        self.scene.load_state(&self.full);
        self.reduce_tangent(state.t, 1.0, state, out);
    }

    fn elastic_stiffness(&mut self, state: &State, out: &mut [f64]) {
        self.expand(state);
        let mut nodal = vec![0.0; self.scene.pattern().entries()];
        self.scene.elastic_stiffness(&self.full, &mut nodal);
        let (from, to) = (self.scene.pattern(), &self.pattern);
        self.reduction.reduce_square(from, &nodal, to, out);
        self.each_body(Vector::zeros(), |block, _, modes, elements, _| {
            let own = block.coordinate..block.coordinate + block.count;
            let square = block.count * block.count;
            let (mut k, mut c) = (vec![0.0; square], vec![0.0; square]);
            let at = [&state.x[own.clone()], &state.v[own]];
            modes.tangent(elements, &FrameAction::default(), at, &mut k, &mut c);
            self.add_modal(block, &k, out);
        });
    }

    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.scene.constraint(level, &self.full, out);
    }

    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        self.expand(state);
        let mut full = vec![0.0; self.scene.constraint_pattern().entries()];
        self.scene.constraint_jacobian(&self.full, &mut full);
        let from = self.scene.constraint_pattern();
        self.reduction
            .reduce_rows(from, &full, &self.constraint_pattern, values);
    }

    fn constraint_noise(&mut self, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.scene.constraint_noise(&self.full, out);
    }

    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        self.expand(state);
        let mut full = vec![0.0; self.scene.constraint_pattern().entries()];
        self.scene.constraint_rate_tangent(&self.full, &mut full);
        let from = self.scene.constraint_pattern();
        self.reduction
            .reduce_rows(from, &full, &self.constraint_pattern, values);
    }

    fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    fn describe_unknown(&self, index: usize) -> String {
        for (block, &body) in self.reduction.blocks().iter().zip(&self.bodies) {
            if (block.coordinate..block.coordinate + block.count).contains(&index) {
                let name = self.scene.bodies[body].spec.label();
                return format!("body `{name}`, mode {}", index - block.coordinate + 1);
            }
        }
        let full = (0..self.scene.unknowns()).find(|&unknown| self.reduction.same(unknown) == Some(index));
        full.map_or_else(String::new, |unknown| self.scene.describe_unknown(unknown))
    }

    fn describe_constraint(&self, index: usize) -> String {
        self.scene.describe_constraint(index)
    }

    fn loose_tie(&self, worst: &str) -> Option<String> {
        self.scene.loose_tie(worst)
    }

    fn undefined(&mut self, state: &State) -> Option<String> {
        self.expand(state);
        self.scene.undefined(&self.full)
    }

    fn kinks(&self) -> Vec<f64> {
        self.scene.kinks()
    }

    fn gaps(&self, t: f64, out: &mut Vec<[f64; 2]>) {
        self.scene.gaps(t, out);
    }

    fn courses(&self) -> Vec<Courses> {
        self.scene.courses()
    }

    fn paths(&mut self, state: &State, readers: &[Vec<usize>]) -> Vec<Vec<Path>> {
        self.expand(state);
        self.scene.paths(&self.full, readers)
    }

    fn too_fast(&mut self, state: &State) -> Option<String> {
        self.expand(state);
        self.scene.too_fast(&self.full)
    }

    fn branches(&mut self, state: &State) -> Vec<Branch> {
        if !self.scene.has_branches() {
            return Vec::new();
        }
        self.expand(state);
        self.scene.branches(&self.full)
    }

    fn describe_branch(&self, index: usize) -> String {
        self.scene.describe_branch(index)
    }

    fn is_branch_of_constraint(&self, index: usize) -> bool {
        self.scene.is_branch_of_constraint(index)
    }

    fn reads_multipliers(&self) -> bool {
        self.scene.reads_multipliers()
    }

    fn turns_in_unknowns(&self) -> bool {
        self.scene.turns_in_unknowns()
    }

    fn jumps(&mut self, state: &State, behind: f64) -> Vec<Jump> {
        self.expand(state);
        self.scene.jumps(&self.full, behind)
    }

    fn jolt(&mut self, state: &State, behind: f64, out: &mut [f64]) {
        self.expand(state);
        let jolt = self.scene.velocity_jumps(&self.full, behind);
        jumps::inertia(self, |modal| &mut modal.scene, (state, behind), jolt, out);
    }

    fn energy(&mut self, state: &State) -> Option<f64> {
        // Eqs. (18)-(20) do not conserve it, and bodies from elsewhere have no elements.
        let is_elsewhere = self.modes.iter().any(|modes| modes.elsewhere.is_some());
        if self.is_small() || is_elsewhere || !self.scene.parts.conservative() {
            return None;
        }
        self.expand(state);
        std::mem::swap(&mut self.scene.tabulated.mass, &mut self.whole_mass);
        let energy = self.in_elements(|scene, full| scene.energy(full));
        std::mem::swap(&mut self.scene.tabulated.mass, &mut self.whole_mass);
        energy
    }
}
