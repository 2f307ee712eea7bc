//! A scene with modal bodies as the application sees it.

use super::scene::{ModalScene, Told, as_described};
use crate::emitted::Line;
use crate::error::ModelError;
use crate::model::{
    Circulating, Composition, Configuration, Curve, DescribedBody, ExportedBody, FrameState, MassProperties, MeshError,
    Operands, Scene, SectionBody, SectionState, Sign, Uniform, Warning,
};
use crate::scene::bodies::mesh_body::MeshBody;
use crate::space::Vector;
use crate::system::{State, System, Tangent};

/// Growth of a deflection from which on what its modes get wrong is found anew: it takes a static problem of the
/// whole body.
const WORSE: f64 = 1.1;
/// Change of the spin up to which tension is the same.
const SAME_SPIN: f64 = 0.02;

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

impl Scene for ModalScene {
    fn output_columns(&self) -> usize {
        self.scene.output_columns()
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        self.expand(state);
        self.in_elements(|scene, full| scene.outputs(full, out));
    }

    fn operands(&mut self, state: &State) -> Vec<Operands> {
        self.expand(state);
        self.in_elements(|scene, full| scene.operands(full))
    }

    fn curves(&self) -> Vec<Curve> {
        self.scene.curves()
    }

    fn bodies(&self) -> Vec<DescribedBody> {
        self.scene.described_bodies()
    }

    fn exported(&self) -> Vec<ExportedBody> {
        self.exported_bodies()
    }

    fn signs(&self) -> Vec<Sign> {
        Scene::signs(&self.scene)
    }

    fn axial_compliances(&self) -> Vec<[f64; 6]> {
        self.scene.axial_compliances()
    }

    fn frame_names(&self) -> Vec<String> {
        self.scene.frame_names()
    }

    fn masses(&mut self, state: &State) -> Vec<MassProperties> {
        self.expand(state);
        self.in_elements(|scene, full| scene.masses(full))
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

    fn elastic_energy(&mut self, state: &State) -> f64 {
        self.expand(state);
        self.in_elements(|scene, full| scene.elastic_energy(full))
    }

    fn mesh_errors(&mut self, state: &State, out: &mut Vec<MeshError>) {
        self.expand(state);
        self.in_elements(|scene, full| scene.mesh_errors(full, out));
    }

    fn uniform_mesh_errors(&mut self, at: &Uniform, state: &State, out: &mut Vec<MeshError>) {
        self.expand(state);
        self.in_elements(|scene, full| scene.uniform_mesh_errors(at, full, out));
    }

    fn mode_mesh_errors(&mut self, at: &Uniform, state: &State, s: [f64; 2], shape: &[[f64; 2]]) -> Vec<f64> {
        self.expand(state);
        let shape = self.expanded_shape(shape);
        self.in_elements(|scene, full| scene.mode_mesh_errors(at, full, s, &shape))
    }

    fn with_finer_meshes(self: Box<Self>, times: usize) -> Option<Result<Box<dyn Scene>, ModelError>> {
        Some(self.scene.with_finer_meshes(times)?.and_then(as_described))
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

    fn carried_shape(&mut self, at: &Uniform, shape: &mut [[f64; 2]], back: bool) {
        for mut carried in self.scene.carried_increments(at, back) {
            if let Some(first) = self.reduction.same(carried.first) {
                carried.first = first;
                carried.apply(shape);
            }
        }
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

    fn is_read(&self, state: usize) -> bool {
        let all = self.scene.states().iter();
        let whole = all.copied().find(|&whole| self.reduction.same(whole) == Some(state));
        whole.is_none_or(|whole| self.scene.is_read(whole))
    }

    fn circulating(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<Circulating> {
        self.expand(state);
        let full = self.expanded_shape(shape);
        self.scene.circulating_of(at, &self.full, &full)
    }

    fn composition(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Composition {
        // Of a body from a file no mass is known where its nodes are, and no axis.
        let is_from_file = |body: &MeshBody| matches!(body.spec.line, Line::Nodes(_));
        if self.scene.bodies.iter().any(is_from_file) {
            return Composition::default();
        }
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

    fn shifts_across(&mut self, at: &Uniform, state: &State) -> Vec<[Vec<f64>; 2]> {
        self.expand(state);
        let shifts = self.scene.shifts_across(at, &self.full).into_iter();
        shifts
            .map(|pair| pair.map(|shift| self.reduction.restrict(&shift, false)))
            .collect()
    }

    fn untied_motion(&mut self, at: &Uniform, state: &State, motion: &[f64]) -> Option<String> {
        self.expand(state);
        let shape: Vec<[f64; 2]> = motion.iter().map(|&value| [value, 0.0]).collect();
        let full: Vec<f64> = self.expanded_shape(&shape).iter().map(|value| value[0]).collect();
        self.scene.untied_motion(at, &self.full, &full)
    }

    fn spin(&self, t: f64) -> f64 {
        self.scene.spin(t)
    }

    fn starting_otherwise(&self, at: &Uniform) -> Vec<String> {
        self.scene.starting_otherwise(at)
    }

    fn timed(&mut self, at: &Uniform, state: &State) -> Vec<String> {
        self.expand(state);
        self.scene.timed(at, &self.full)
    }

    fn moving_frames(&self, t: f64) -> Vec<String> {
        self.scene.moving_frames(t)
    }

    fn warnings(&mut self, state: &State) -> Vec<Warning> {
        self.expand(state);
        let mut warnings = self.scene.warnings(&self.full);
        let acting = match self.modes.iter().any(|modes| modes.lacks()) {
            true => self.scene.on_all_interfaces(&self.full),
            false => Vec::new(),
        };
        let mut worst = std::mem::take(&mut self.worst);
        let mut tightened = std::mem::take(&mut self.tightened);
        self.each_body(Vector::zeros(), |block, body, modes, elements, action| {
            let own = |of: &[f64]| of[block.coordinate..][..block.count].to_vec();
            let [p, v, a] = [&state.x, &state.v, &state.a].map(|of| own(of));
            if modes.elsewhere.is_some() {
                warnings.extend(modes.told(action, &p, acting.get(body).map_or(&[], Vec::as_slice)));
                return;
            }
            let asked = &mut tightened[body];
            let is_near = |last: Vector| (action.spin - last).norm() <= SAME_SPIN * last.norm();
            if asked.as_ref().is_none_or(|(last, _)| !is_near(*last)) {
                *asked = Some((action.spin, modes.lack_of_tension(elements, action)));
            }
            let lack = asked.as_ref().and_then(|(_, lack)| lack.clone());
            let loss = modes.loss_of_stiffness(elements, action, &p).or(lack);
            warnings.extend(loss.map(|loss| Warning {
                text: loss.to_string(),
                weight: loss.whole - loss.remaining,
            }));
            let hindrance = modes.hindrance(elements, &p);
            let Some(deflection) = hindrance.or_else(|| modes.linear_work(&p)) else {
                return;
            };
            let told = &mut worst[body];
            if told.as_ref().is_none_or(|told| deflection > WORSE * told.deflection) {
                let text = if hindrance.is_some() {
                    let locking = modes.locking(elements, [p.as_slice(), &v, &a]);
                    locking.map(|locking| locking.to_string())
                } else {
                    modes.beyond_linear(elements, &p).map(|beyond| beyond.to_string())
                };
                let warning = text.map(|text| Warning {
                    text,
                    weight: deflection,
                });
                *told = Some(Told { deflection, warning });
            }
            warnings.extend(told.iter().filter_map(|told| told.warning.clone()));
        });
        (self.worst, self.tightened) = (worst, tightened);
        warnings
    }
}
