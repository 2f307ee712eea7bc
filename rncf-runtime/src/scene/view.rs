//! A scene as the application sees it.

use super::mesh_scene::MeshScene;
use crate::error::ModelError;
use crate::model::{
    Circulating, Composition, Configuration, Curve, DescribedBody, FrameState, MassProperties, MeshError, Operands,
    Scene, SectionBody, SectionState, Sign, Uniform, Warning,
};
use crate::scene::frames::free_frames::declared_free;
use crate::system::{State, Tangent};

impl Scene for MeshScene {
    fn output_columns(&self) -> usize {
        self.parts.output_columns()
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        self.load_state(state);
        self.follow();
        self.evaluate_outputs(state.t, 1.0, &state.lambda, out);
    }

    fn operands(&mut self, state: &State) -> Vec<Operands> {
        self.load_state(state);
        self.follow();
        self.operands_of_outputs(state)
    }

    fn bodies(&self) -> Vec<DescribedBody> {
        self.described_bodies()
    }

    fn curves(&self) -> Vec<Curve> {
        self.drawn()
    }

    fn signs(&self) -> Vec<Sign> {
        MeshScene::signs(self)
    }

    fn axial_compliances(&self) -> Vec<[f64; 6]> {
        self.compliances()
    }

    fn frame_names(&self) -> Vec<String> {
        let frames = 0..self.drawn_frames();
        frames.map(|frame| self.parts.frame_name(frame).to_string()).collect()
    }

    fn masses(&mut self, state: &State) -> Vec<MassProperties> {
        self.load_state(state);
        self.masses_loaded()
    }

    fn configuration(&mut self, state: &State, out: &mut Configuration) {
        self.load_state(state);
        self.draw(out);
    }

    fn section_bodies(&self) -> Vec<SectionBody> {
        self.sectioned()
    }

    fn section_states(&mut self, state: &State, out: &mut Vec<SectionState>) {
        self.load_state(state);
        self.evaluate_sections(state.t, 1.0, &state.lambda);
        self.sample_sections(out);
    }

    fn uniform_section_states(&mut self, at: &Uniform, state: &State, out: &mut Vec<SectionState>) {
        self.load_uniform(at, state);
        self.evaluate_sections(at.t, at.load(), &state.lambda);
        self.sample_sections(out);
    }

    fn elastic_energy(&mut self, state: &State) -> f64 {
        self.load_state(state);
        self.energy_of_meshes()
    }

    fn mesh_errors(&mut self, state: &State, out: &mut Vec<MeshError>) {
        self.load_state(state);
        self.evaluate_sections(state.t, 1.0, &state.lambda);
        self.measure_meshes(out);
    }

    fn uniform_mesh_errors(&mut self, at: &Uniform, state: &State, out: &mut Vec<MeshError>) {
        self.load_uniform(at, state);
        self.evaluate_sections(at.t, at.load(), &state.lambda);
        self.measure_meshes(out);
    }

    fn mode_mesh_errors(&mut self, at: &Uniform, state: &State, s: [f64; 2], shape: &[[f64; 2]]) -> Vec<f64> {
        self.mode_errors(at, state, s, shape)
    }

    fn with_finer_meshes(self: Box<Self>, times: usize) -> Option<Result<Box<dyn Scene>, ModelError>> {
        let finer = MeshScene::with_finer_meshes(*self, times)?;
        Some(finer.map(|scene| Box::new(scene) as Box<dyn Scene>))
    }

    fn rest(&self, t: f64) -> State {
        let [q, v] = self.initial_shape();
        self.unknowns_from(t, &q, &v, &[])
    }

    fn frame_state(&mut self, state: &State) -> FrameState {
        self.load_state(state);
        self.follow();
        let [q, v] = self.vectors_in_frames([&self.buffers.q, &self.buffers.v]);
        let poses = self.poses();
        FrameState {
            t: state.t,
            q,
            v,
            poses,
        }
    }

    fn state_of_frame(&self, frame: &FrameState) -> State {
        self.unknowns_from(frame.t, &frame.q, &frame.v, &frame.poses)
    }

    fn is_referenced(&self) -> bool {
        self.formulation == crate::model::Formulation::Rncf
    }

    fn measure_length(&mut self, at: &Uniform) {
        self.measure_loads(at);
    }

    fn uniform_guess(&self, at: &Uniform) -> State {
        self.guess(at)
    }

    fn carried(&mut self, at: &Uniform, state: &State, back: bool) -> State {
        self.carried_state(at, state, back)
    }

    fn carried_shape(&mut self, at: &Uniform, shape: &mut [[f64; 2]], back: bool) {
        for carried in self.carried_increments(at, back) {
            carried.apply(shape);
        }
    }

    fn uniform_state(&mut self, at: &Uniform, state: &mut State) {
        self.set_uniform(at, state);
    }

    fn uniform_residual(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        self.load_uniform(at, state);
        self.full_force(at.t, at.load());
        self.layout.project(&self.buffers.force, out);
    }

    fn small_motions(&mut self, at: &Uniform, state: &State, out: &mut Tangent) {
        self.load_uniform(at, state);
        self.uniform_tangent(at, state, out);
        for corotation in self.corotations(at) {
            corotation.apply(&self.tabulated.pattern, out);
        }
    }

    fn uniform_outputs(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        self.load_uniform(at, state);
        self.follow();
        self.evaluate_outputs(at.t, at.load(), &state.lambda, out);
    }

    fn is_read(&self, state: usize) -> bool {
        self.reads(state)
    }

    fn circulating(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<Circulating> {
        self.circulating_of(at, state, shape)
    }

    fn composition(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Composition {
        self.composition_of(at, state, shape)
    }

    fn uniform_obstacle(&mut self, at: &Uniform, state: &State) -> Option<String> {
        self.obstacle(at, state)
    }

    fn neutral_motions(&mut self, at: &Uniform, state: &State) -> Vec<Vec<f64>> {
        self.neutral(at, state)
    }

    fn shifts_across(&mut self, at: &Uniform, state: &State) -> Vec<[Vec<f64>; 2]> {
        self.across(at, state)
    }

    fn untied_motion(&mut self, at: &Uniform, state: &State, motion: &[f64]) -> Option<String> {
        self.moved_as_wholes(at, state, motion)
    }

    fn spin(&self, t: f64) -> f64 {
        let frames = self.motions(t);
        let prescribed = self.bodies.iter().map(|body| body.spec.frame);
        let prescribed = prescribed.filter(|&frame| self.frames.free_of[frame].is_none());
        let free = self.frames.free.iter().map(|_| self.rotation(&Uniform::steady(t)));
        let free = free.map(|spin| spin.unwrap_or_default().velocity.norm());
        prescribed
            .map(|frame| frames[frame].spin.norm())
            .chain(free.take(1))
            .fold(0.0, f64::max)
    }

    fn starting_otherwise(&self, at: &Uniform) -> Vec<String> {
        self.not_starting_in_rotation(at)
    }

    fn timed(&mut self, at: &Uniform, state: &State) -> Vec<String> {
        MeshScene::timed(self, at, state)
    }

    fn moving_frames(&self, t: f64) -> Vec<String> {
        let free = declared_free(&*self.parts);
        let motions = self.motions(t);
        let moves = |frame: usize| {
            let of = &motions[frame];
            [of.velocity, of.acceleration, of.spin, of.spin_rate]
                .iter()
                .any(|rate| rate.norm() > 0.0)
        };
        let moving = (0..free.len()).filter(|&frame| !free[frame] && moves(frame));
        moving.map(|frame| self.parts.frame_name(frame).to_string()).collect()
    }

    fn warnings(&mut self, state: &State) -> Vec<Warning> {
        self.load_state(state);
        let mut warnings = self.remarks.clone();
        let stretched = self.strongly_stretched();
        warnings.extend(self.giving_way(&stretched));
        warnings.extend(self.overstretched(&stretched));
        warnings.extend(self.strained_fixtures());
        warnings.extend(self.between_points(state.t));
        let missed = self.missed.get_or_init(|| self.missed_within_elements());
        warnings.extend(missed.iter().cloned());
        warnings.extend(self.apart_from_fibres());
        warnings
    }
}
