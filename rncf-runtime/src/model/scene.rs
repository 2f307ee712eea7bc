//! A scene: a system with bodies in it.

use super::bodies::{DescribedBody, ExportedBody, MassProperties, MeshError, SectionBody, SectionState};
use super::circulating::Circulating;
use super::composition::Composition;
use super::operands::Operands;
use super::picture::{Configuration, Curve, Sign};
use super::uniform::Uniform;
use crate::archive::{Archive, Keep};
use crate::error::ModelError;
use crate::space::{Rotation, Vector};
use crate::system::{AsSystem, State, System, Tangent};

/// A system with bodies in it: outputs, initial states and relative equilibria.
pub trait Scene: System + Send {
    /// Number of scalar output columns: components of all [`Model::outputs`](super::Model::outputs) in their order.
    fn output_columns(&self) -> usize;

    /// Values of all outputs, SI, at a state.
    fn outputs(&mut self, state: &State, out: &mut [f64]);

    /// What all outputs are made of at a state, SI, one for each column. Default: the values themselves.
    fn operands(&mut self, state: &State) -> Vec<Operands> {
        let mut values = vec![0.0; self.output_columns()];
        self.outputs(state, &mut values);
        let of = |value: f64| Operands {
            size: value.abs(),
            balanced: 0.0,
        };
        values.into_iter().map(of).collect()
    }

    /// The flexible bodies whose section states are told, in the order of [`Scene::section_states`].
    fn section_bodies(&self) -> Vec<SectionBody> {
        Vec::new()
    }

    /// The meshed bodies of the declaration in its order, and how they are described here.
    fn bodies(&self) -> Vec<DescribedBody> {
        Vec::new()
    }

    /// Masses of the bodies and of what else has inertia at a state, and the sum of all at the end where there are several.
    fn masses(&mut self, _state: &State) -> Vec<MassProperties> {
        Vec::new()
    }

    /// The bodies that modes describe, for files that a body can be imported from.
    fn exported(&self) -> Vec<ExportedBody> {
        Vec::new()
    }

    /// The lines of a picture of the scene, in the order of [`Scene::configuration`].
    fn curves(&self) -> Vec<Curve> {
        Vec::new()
    }

    /// The joints of a picture, then what has no arrow, then loads and forces in the order of [`Configuration::acting`].
    fn signs(&self) -> Vec<Sign> {
        Vec::new()
    }

    /// By how much the section forces N, Q_y, Q_z (1/N) and moments T, M_y, M_z (1/(N m)) of every section state, in the order of
    /// [`Scene::section_states`], strain the axis there; zeros where that is not known.
    fn axial_compliances(&self) -> Vec<[f64; 6]> {
        Vec::new()
    }

    /// Names of all frames, in the order of [`Configuration::poses`].
    fn frame_names(&self) -> Vec<String> {
        Vec::new()
    }

    /// Where everything is at a state; `out` is overwritten.
    fn configuration(&mut self, _state: &State, out: &mut Configuration) {
        *out = Configuration::default();
    }

    /// What sections of all [`Scene::section_bodies`] carry at a state, body by body from start to end; `out`
    /// is overwritten.
    fn section_states(&mut self, _state: &State, out: &mut Vec<SectionState>) {
        out.clear();
    }

    /// The same in the uniform motion.
    fn uniform_section_states(&mut self, _at: &Uniform, _state: &State, out: &mut Vec<SectionState>) {
        out.clear();
    }

    /// Strain energy of all bodies with a mesh whose nodal vectors are unknown, J.
    fn elastic_energy(&mut self, _state: &State) -> f64 {
        0.0
    }

    /// How far the meshes of all [`Scene::section_bodies`] are from their bodies at a state; `out` is overwritten. Nothing
    /// where that is not known.
    fn mesh_errors(&mut self, _state: &State, out: &mut Vec<MeshError>) {
        out.clear();
    }

    /// The same in the uniform motion.
    fn uniform_mesh_errors(&mut self, _at: &Uniform, _state: &State, out: &mut Vec<MeshError>) {
        out.clear();
    }

    /// Of small motions `Re(shape exp((s[0] + i s[1]) t))` of the unknowns about the uniform motion: for all [`Scene::section_bodies`]
    /// the stiffness that their meshes have too much, `shape . dK shape`; nothing where it is not known.
    fn mode_mesh_errors(&mut self, _at: &Uniform, _state: &State, _s: [f64; 2], _shape: &[[f64; 2]]) -> Vec<f64> {
        Vec::new()
    }

    /// The same scene with this number of elements for each one, and their nodal vectors as unknowns where there are modes; `None` where
    /// no mesh would change.
    ///
    /// # Errors
    /// As those of building it.
    fn with_finer_meshes(self: Box<Self>, _times: usize) -> Option<Result<Box<dyn Scene>, ModelError>> {
        None
    }

    /// Undeformed and at rest in the bodies' frames at time `t`; accelerations and multipliers zero.
    fn rest(&self, t: f64) -> State;

    /// The same bodies in referenced coordinates: positions and velocities of all nodal vectors in
    /// the bodies' frames, for carrying a state from one formulation to the other.
    fn frame_state(&mut self, state: &State) -> FrameState;

    /// The state with the nodal vectors of `frame`; accelerations and multipliers zero.
    fn state_of_frame(&self, frame: &FrameState) -> State;

    /// Whether the unknowns live in the declared frames (RNCF), so that a relative equilibrium is
    /// an equilibrium of `x`.
    fn is_referenced(&self) -> bool;

    /// Where nothing in the scene has a length, as in one of a single point: takes for it how far all loads at the time of `at` move what is stiff.
    fn measure_length(&mut self, _at: &Uniform) {}

    /// A state from which an equilibrium may be looked for: as [`Scene::rest`] at the time of `at`, what
    /// moves freely turned on with the prescribed frames since t = 0.
    fn uniform_guess(&self, at: &Uniform) -> State {
        self.rest(at.t)
    }

    /// Sets velocities and accelerations of the uniform motion (THEORY 8.1) from positions and
    /// orientations: about the axis through c with the angular velocity W (inertial axes)
    /// `r' = W x (r - c)`, `r'' = W x r'`, `w = A^T W`, `w' = 0`; nodal vectors rest in their frames.
    fn uniform_state(&mut self, at: &Uniform, state: &mut State);

    /// A state whose free frames are carried on with what turns since t = 0, or `back` to there: at one time, but with
    /// different angular velocities, states are next to each other only as at t = 0.
    fn carried(&mut self, _at: &Uniform, state: &State, _back: bool) -> State {
        state.clone()
    }

    /// The same of increments of the unknowns, as of modes: those of one motion at different angular velocities are alike only as at t = 0.
    fn carried_shape(&mut self, _at: &Uniform, _shape: &mut [[f64; 2]], _back: bool) {}

    /// `M a + f`, without constraint forces, in the uniform motion; prescribed frames and loads are
    /// those of `at`, velocities and accelerations those of [`Scene::uniform_state`].
    fn uniform_residual(&mut self, at: &Uniform, state: &State, out: &mut [f64]);

    /// Mass, damping and stiffness of small motions about the uniform one (THEORY 8.2), multipliers'
    /// stiffness included, on [`System::pattern`]. Perturbations y are co-rotating: dr = y in axes that
    /// turn with W, dpi = y in body axes, hence `dr' = y' + W x y`, `dr'' = y'' + 2 W x y' + W x (W x y)`,
    /// `dw = y' + w x y`, `dw' = y'' + w x y'`. The stiffness is the derivative of
    /// [`Scene::uniform_residual`] and of the constraint forces, velocities following positions.
    fn small_motions(&mut self, at: &Uniform, state: &State, out: &mut Tangent);

    /// Values of all outputs in the uniform motion, SI.
    fn uniform_outputs(&mut self, at: &Uniform, state: &State, out: &mut [f64]);

    /// Why no equilibrium with this rotation exists near the state, naming the frame, load, joint, force
    /// or constraint that is not invariant under it (THEORY 8.1), and what to do.
    fn uniform_obstacle(&mut self, at: &Uniform, state: &State) -> Option<String>;

    /// Motions of the whole system, or of parts that move independently, that change nothing: unit
    /// directions of the unknowns (right increments) at the state, one after the other. The scene is
    /// invariant along each.
    fn neutral_motions(&mut self, _at: &Uniform, _state: &State) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Shifts across the axis of the rotation of what moves together, directions of the unknowns at the state: for each part two, by one unit of length,
    /// right-handed with the axis; nothing where nothing turns. Whether something ties them is not asked.
    fn shifts_across(&mut self, _at: &Uniform, _state: &State) -> Vec<[Vec<f64>; 2]> {
        Vec::new()
    }

    /// A direction of the unknowns at the state along which nothing is stiff, in the user's words; `None` where it deforms a
    /// body, or where the scene does not know: such a direction is a fault of the model, or a body buckles.
    fn untied_motion(&mut self, _at: &Uniform, _state: &State, _motion: &[f64]) -> Option<String> {
        None
    }

    /// Whether anything but its own rate and outputs reads the state that is this unknown ([`System::states`](crate::system::System::states)).
    fn is_read(&self, _state: usize) -> bool {
        true
    }

    /// What circulates about the axis of the rotation in a mode with complex increments `shape` of the unknowns that grow as
    /// exp(i |im| t), seen in co-rotating axes. `None` where nothing spins, or where the scene does not know its points.
    fn circulating(&mut self, _at: &Uniform, _state: &State, _shape: &[[f64; 2]]) -> Option<Circulating> {
        None
    }

    /// [`Circulating::sense`] of the same.
    fn circulation(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<f64> {
        self.circulating(at, state, shape)?.sense()
    }

    /// Parts of the kinetic energy of a mode about the uniform motion at `state`, by kinds of motion and by bodies; nothing
    /// where it is not known.
    fn composition(&mut self, _at: &Uniform, _state: &State, _shape: &[[f64; 2]]) -> Composition {
        Composition::default()
    }

    /// Largest angular velocity of a body's frame at `t`, rad/s.
    fn spin(&self, t: f64) -> f64;

    /// Angular velocity of a uniform motion, rad/s.
    fn spin_in(&self, at: &Uniform) -> f64 {
        at.speed() * at.spin.map_or_else(|| self.spin(at.t), |spin| spin.velocity.norm())
    }

    /// Names of what moves freely and is not declared to start in the rotation of a uniform motion.
    fn starting_otherwise(&self, _at: &Uniform) -> Vec<String> {
        Vec::new()
    }

    /// What changes with time at the state of a uniform motion, in the user's words: loads, forces, joints that drive.
    fn timed(&mut self, _at: &Uniform, _state: &State) -> Vec<String> {
        Vec::new()
    }

    /// Names of the prescribed frames that move at `t` (s).
    fn moving_frames(&self, _t: f64) -> Vec<String> {
        Vec::new()
    }

    /// Where the model does not describe its bodies well at a state, one sentence each, naming the body
    /// and what to do (THEORY 10, T10, T15).
    fn warnings(&mut self, _state: &State) -> Vec<Warning> {
        Vec::new()
    }
}

impl AsSystem for dyn Scene + '_ {
    fn as_system(&mut self) -> &mut dyn System {
        self
    }
}

/// Where a model does not describe its bodies well.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warning {
    /// One sentence.
    pub text: String,
    /// How bad it is: of several sentences that differ in their numbers only, the one with the greatest weight holds.
    pub weight: f64,
}

impl Keep for Warning {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { text, weight } = self;
        text.keep(archive);
        weight.keep(archive);
    }
}

/// Nodal vectors of all bodies in their declared frames at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameState {
    /// Time, s.
    pub t: f64,
    /// Components of all nodal vectors, frame axes.
    pub q: Vec<f64>,
    /// Their time derivatives in the frame.
    pub v: Vec<f64>,
    /// Poses and velocities of the free frames, ascending; empty: as declared.
    pub poses: Vec<Pose>,
}

/// Pose and velocities of a free frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Origin, m, inertial axes.
    pub position: Vector,
    /// From the frame's axes to the inertial ones.
    pub rotation: Rotation,
    /// Angle of a planar or hinged frame, rad, which counts beyond a turn; else 0.
    pub angle: f64,
    /// Velocity of the origin, m/s, inertial axes.
    pub velocity: Vector,
    /// Angular velocity, rad/s, frame axes.
    pub spin: Vector,
}
