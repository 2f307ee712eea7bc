//! Scenes with modal bodies: the scene with all nodal vectors in front of the map of [`Reduction`].
//! Loads, markers, constraints and outputs see nodal vectors; inertia and elasticity of the modal
//! bodies come from their constants.

use super::sources::Kernels;
use super::{Elements, ModalBody};
use crate::emitted::{Fidelity, Parts};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::modal::reduction::{Block, Reduction};
use crate::model::{
    Composition, Configuration, Curve, DescribedBody, Formulation, FrameState, Joints, Scene, SectionBody,
    SectionState, Uniform, Warning,
};
use crate::scene::MeshScene;
use crate::scene::frames::carried::{Beside, FrameAction};
use crate::system::{Conserving, ConstraintLevel, Jump, Lever, State, System, Tangent, Turning};

/// Builds the scene of a model with emitted parts: with modal coordinates where a body asks for them, and with bodies, by
/// their names, described otherwise than they are declared.
///
/// # Errors
/// As [`MeshScene::new`], and a body whose modes do not exist or do not suffice, by name.
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
    let scene = MeshScene::new(parts, formulation, joints, fidelity)?;
    if scene.bodies.iter().all(|body| body.spec.fidelity == Fidelity::Full) {
        return Ok(Box::new(scene));
    }
    Ok(Box::new(ModalScene::new(scene)?))
}

/// Growth of what modes hinder from which on the part that is missing is found anew: it takes a static problem of the
/// whole body.
const WORSE: f64 = 1.1;

/// What modes have hindered most so far.
#[derive(Clone, Debug)]
struct Told {
    /// As [`ModalBody::hindrance`].
    hindrance: f64,
    /// What is told of it, if anything.
    warning: Option<Warning>,
}

/// A scene some of whose bodies have modal coordinates.
pub struct ModalScene {
    /// With all nodal vectors; the elements of modal bodies are left out.
    scene: MeshScene,
    reduction: Reduction,
    /// Body of every block of the reduction.
    bodies: Vec<usize>,
    pattern: Pattern,
    constraint_pattern: Pattern,
    turns: Vec<usize>,
    sizes: Vec<f64>,
    /// By body, where its modes have hindered its deflection most.
    worst: Vec<Option<Told>>,
    /// The state with all nodal vectors.
    full: State,
    tangent: Tangent,
    scratch: Vec<f64>,
}

impl ModalScene {
    /// Finds the modes of the bodies that ask for them.
    ///
    /// # Errors
    /// As [`build_as`].
    pub(super) fn new(mut scene: MeshScene) -> Result<Self, ModelError> {
        let (mut blocks, mut bodies) = (Vec::new(), Vec::new());
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
            let modes = ModalBody::new(nodal, fidelity, &elements)?;
            blocks.push(Block::new(&modes, first));
            bodies.push(index);
            scene.bodies[index].modes = Some(modes);
            scene.check_loose(index)?;
        }
        scene.in_modes = true;
        scene.assemble_mass();
        let reduction = Reduction::new(blocks, scene.unknowns());
        let pattern = reduction.square(scene.pattern());
        let constraint_pattern = reduction.rows(scene.constraint_pattern());
        let turns = scene.turns().iter().filter_map(|&turn| reduction.same(turn)).collect();
        let mut sizes = vec![0.0; reduction.unknowns()];
        for (unknown, &size) in scene.sizes().iter().enumerate() {
            if let Some(place) = reduction.same(unknown) {
                sizes[place] = size;
            }
        }
        for (block, &body) in reduction.blocks().iter().zip(&bodies) {
            if let Some(modes) = &scene.bodies[body].modes {
                sizes[block.coordinate..][..block.count].copy_from_slice(modes.sizes());
            }
        }
        let entries = scene.pattern().entries();
        let zeros = || vec![0.0; entries];
        Ok(Self {
            worst: vec![None; scene.bodies.len()],
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
            sizes,
        })
    }

    /// The map from modal coordinates.
    #[cfg(test)]
    pub(super) fn reduction(&self) -> &Reduction {
        &self.reduction
    }

    /// Expands the state to all nodal vectors.
    fn expand(&mut self, state: &State) {
        let full = &mut self.full;
        full.t = state.t;
        full.turns.clone_from(&state.turns);
        full.lambda.clone_from(&state.lambda);
        self.reduction.expand(&state.x, true, &mut full.x);
        self.reduction.expand(&state.v, false, &mut full.v);
        self.reduction.expand(&state.a, false, &mut full.a);
    }

    /// The state with modal coordinates.
    fn restricted(&self, full: &State) -> State {
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
    fn each_body(
        &self,
        gravity: [f64; 3],
        mut call: impl FnMut(&Block, usize, &ModalBody, &dyn Elements, &FrameAction),
    ) {
        for (block, &index) in self.reduction.blocks().iter().zip(&self.bodies) {
            let body = &self.scene.bodies[index];
            if let Some(modes) = &body.modes {
                let action = self.scene.buffers.frames[body.frame].action(body.spec.axes, gravity);
                let elements = Kernels {
                    parts: &*self.scene.parts,
                    body: index,
                };
                call(block, index, modes, &elements, &action);
            }
        }
    }

    fn gravity(&self, t: f64, load_scale: f64) -> [f64; 3] {
        self.scene.gravity(t).map(|g| load_scale * g)
    }

    /// Residual at the loaded state with the unknowns and their derivatives.
    fn residual_of(&mut self, t: f64, load_scale: f64, at: [&[f64]; 3], out: &mut [f64]) {
        self.scene.full_force(t, load_scale);
        let gravity = self.gravity(t, load_scale);
        let mut carried = Vec::new();
        let mut modal = vec![0.0; out.len()];
        self.each_body(gravity, |block, index, modes, elements, action| {
            let own = block.coordinate..block.coordinate + block.count;
            let at = at.map(|values| &values[own.clone()]);
            modes.force(elements, action, at, &mut modal[own.clone()]);
            let body = &self.scene.bodies[index];
            if let Some(free) = self.scene.free_of[body.frame] {
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
    fn beside(&mut self, t: f64, load_scale: f64, state: &State) -> Vec<Option<Beside>> {
        let gravity = self.gravity(t, load_scale);
        let pairs = self.reduction.blocks().iter().zip(&self.bodies);
        pairs
            .map(|(block, &body)| {
                let own = block.coordinate..block.coordinate + block.count;
                let at = [&state.x, &state.v, &state.a].map(|values| &values[own.clone()]);
                self.scene.add_carried_modes(body, at, gravity, &mut self.tangent)
            })
            .collect()
    }

    /// Adds a k x n block of frame rows and an n x k block of modal rows.
    fn add_beside(&self, block: &Block, beside: &Beside, lower: &[f64], upper: &[f64], values: &mut [f64]) {
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
    fn add_modal(&self, block: &Block, matrix: &[f64], values: &mut [f64]) {
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
    fn reduce_mass(&self, beside: &[Option<Beside>], values: &mut [f64]) {
        let from = self.scene.pattern();
        self.reduction
            .reduce_square(from, &self.tangent.mass, &self.pattern, values);
        self.each_body([0.0; 3], |block, _, modes, _, _| {
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
    fn reduce_tangent(&mut self, t: f64, load_scale: f64, state: &State, out: &mut Tangent) {
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
    fn in_elements<T>(&mut self, call: impl FnOnce(&mut MeshScene, &State) -> T) -> T {
        self.scene.in_modes = false;
        let result = call(&mut self.scene, &self.full);
        self.scene.in_modes = true;
        result
    }

    fn is_small(&self) -> bool {
        let small = |&body: &usize| matches!(self.scene.bodies[body].spec.fidelity, Fidelity::Small(_));
        self.bodies.iter().any(small)
    }
}

/// The n x k transpose of a k x n matrix.
fn transposed(matrix: &[f64], k: usize, n: usize) -> Vec<f64> {
    (0..n).flat_map(|c| (0..k).map(move |i| matrix[i * n + c])).collect()
}

impl ModalScene {
    /// Increments of all nodal vectors in a mode.
    fn expanded_shape(&self, shape: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [real, imaginary] = [0, 1].map(|part| {
            let unknowns: Vec<f64> = shape.iter().map(|value| value[part]).collect();
            let mut full = Vec::new();
            self.reduction.expand(&unknowns, false, &mut full);
            full
        });
        real.into_iter().zip(imaginary).map(|(re, im)| [re, im]).collect()
    }
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
        let mut levers = self.scene.levers();
        let same = |unknown: &mut usize| match self.reduction.same(*unknown) {
            Some(own) => {
                *unknown = own;
                true
            }
            None => false,
        };
        levers.retain_mut(|lever| {
            let turns = match &mut lever.turning {
                Turning::Angle { unknown, .. } => same(unknown),
                Turning::Orientation { .. } => true,
            };
            turns && lever.positions.iter_mut().all(|(unknown, _)| same(unknown))
        });
        levers
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

    fn too_fast(&mut self, state: &State) -> Option<String> {
        self.expand(state);
        self.scene.too_fast(&self.full)
    }

    fn jumps(&mut self, state: &State, behind: f64) -> Vec<Jump> {
        self.expand(state);
        self.scene.jumps(&self.full, behind)
    }

    fn energy(&mut self, state: &State) -> Option<f64> {
        // Eqs. (18)-(20) do not conserve it.
        if self.is_small() {
            return None;
        }
        self.expand(state);
        self.scene.in_modes = false;
        self.scene.assemble_mass();
        let energy = self.scene.energy(&self.full);
        self.scene.in_modes = true;
        self.scene.assemble_mass();
        energy
    }
}

impl Scene for ModalScene {
    fn output_columns(&self) -> usize {
        self.scene.output_columns()
    }

    fn outputs_need_acceleration(&self) -> bool {
        self.scene.outputs_need_acceleration()
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.in_elements(|scene, full| scene.outputs(full, out));
    }

    fn curves(&self) -> Vec<Curve> {
        self.scene.curves()
    }

    fn bodies(&self) -> Vec<DescribedBody> {
        self.scene.described_bodies()
    }

    fn frame_names(&self) -> Vec<String> {
        self.scene.frame_names()
    }

    fn configuration(&mut self, state: &State, out: &mut Configuration) {
        self.expand(state);
        self.in_elements(|scene, full| scene.configuration(full, out));
    }

    fn section_bodies(&self) -> Vec<SectionBody> {
        self.scene.section_bodies()
    }

    fn section_states(&mut self, state: &State, out: &mut Vec<SectionState>) {
        self.expand(state);
        self.in_elements(|scene, full| scene.section_states(full, out));
    }

    fn uniform_section_states(&mut self, at: &Uniform, state: &State, out: &mut Vec<SectionState>) {
        self.expand(state);
        self.in_elements(|scene, full| scene.uniform_section_states(at, full, out));
    }

    fn rest(&self, t: f64) -> State {
        self.restricted(&self.scene.rest(t))
    }

    fn frame_state(&mut self, state: &State) -> FrameState {
        self.expand(state);
        self.scene.frame_state(&self.full)
    }

    fn state_of_frame(&self, frame: &FrameState) -> State {
        self.restricted(&self.scene.state_of_frame(frame))
    }

    fn is_referenced(&self) -> bool {
        self.scene.is_referenced()
    }

    fn uniform_guess(&self, at: &Uniform) -> State {
        self.restricted(&self.scene.uniform_guess(at))
    }

    fn carried(&mut self, at: &Uniform, state: &State, back: bool) -> State {
        self.expand(state);
        let full = self.scene.carried_state(at, &self.full, back);
        let mut carried = self.restricted(&full);
        carried.lambda.clone_from(&state.lambda);
        carried
    }

    fn uniform_state(&mut self, at: &Uniform, state: &mut State) {
        self.expand(state);
        self.scene.set_uniform(at, &mut self.full);
        state.t = at.t;
        state.v = self.reduction.restrict(&self.full.v, false);
        state.a = self.reduction.restrict(&self.full.a, false);
    }

    fn uniform_residual(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.scene.load_uniform(at, &self.full);
        self.residual_of(at.t, at.load(), [&state.x, &state.v, &state.a], out);
    }

    fn small_motions(&mut self, at: &Uniform, state: &State, out: &mut Tangent) {
        self.expand(state);
        self.scene.load_uniform(at, &self.full);
        self.scene.uniform_tangent(at, &self.full, &mut self.tangent);
        self.reduce_tangent(at.t, at.load(), state, out);
        for mut corotation in self.scene.corotations(at) {
            if let Some(first) = self.reduction.same(corotation.first) {
                corotation.first = first;
                corotation.apply(&self.pattern, out);
            }
        }
    }

    fn uniform_outputs(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.in_elements(|scene, full| scene.uniform_outputs(at, full, out));
    }

    fn circulation(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<f64> {
        self.expand(state);
        let full = self.expanded_shape(shape);
        self.scene.circulation_of(at, &self.full, &full)
    }

    fn composition(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Composition {
        self.expand(state);
        let full = self.expanded_shape(shape);
        self.scene.composition_of(at, &self.full, &full)
    }

    fn uniform_obstacle(&mut self, at: &Uniform, state: &State) -> Option<String> {
        self.expand(state);
        self.scene.uniform_obstacle(at, &self.full)
    }

    fn neutral_motions(&mut self, at: &Uniform, state: &State) -> Vec<Vec<f64>> {
        self.expand(state);
        let motions = self.scene.neutral_motions(at, &self.full);
        // Only poses of free frames move.
        let restricted = motions.iter().map(|motion| self.reduction.restrict(motion, false));
        restricted.collect()
    }

    fn spin(&self, t: f64) -> f64 {
        self.scene.spin(t)
    }

    fn warnings(&mut self, state: &State) -> Vec<Warning> {
        self.expand(state);
        let mut warnings = self.scene.warnings(&self.full);
        let mut worst = std::mem::take(&mut self.worst);
        self.each_body([0.0; 3], |block, body, modes, elements, action| {
            let own = |of: &[f64]| of[block.coordinate..][..block.count].to_vec();
            let [p, v, a] = [&state.x, &state.v, &state.a].map(|of| own(of));
            let loss = modes.loss_of_stiffness(elements, action, &p);
            warnings.extend(loss.map(|loss| Warning {
                text: loss.to_string(),
                weight: loss.whole - loss.remaining,
            }));
            let Some(hindrance) = modes.hindrance(elements, &p) else {
                return;
            };
            let told = &mut worst[body];
            if told.as_ref().is_none_or(|told| hindrance > WORSE * told.hindrance) {
                let locking = modes.locking(elements, [p.as_slice(), &v, &a]);
                let warning = locking.map(|locking| Warning {
                    text: locking.to_string(),
                    weight: hindrance,
                });
                *told = Some(Told { hindrance, warning });
            }
            warnings.extend(told.iter().filter_map(|told| told.warning.clone()));
        });
        self.worst = worst;
        warnings
    }
}
