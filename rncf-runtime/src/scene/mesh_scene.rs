//! The scene of a model: what it consists of, sizes, and places on bodies.

use std::sync::Arc;

use super::evaluate::{TurnedColumns, weighted};
use super::frames::free_frames::FreeFrame;
use super::frames::ties::Tie;
use super::numbering::assembly::{Connectivity, Scatter};
use super::numbering::conditions::Condition;
use super::numbering::layout::Layout;
use super::read::point_forces::PointForce;
use super::terms::batches::Group;
use super::terms::density::Density;
use super::terms::density_lanes::Batches;
use super::terms::fixtures::Fixture;
use super::terms::inertia::{NodalMass, Padded};
use super::terms::inertia_tangent::Border;
use super::terms::linked::{Linked, MarkedLoad, Marker};
use super::terms::rigid_sections::RigidSection;
use crate::emitted::{
    BodySpec, ForceSpec, FrameMotion, Interpolant, JointSpec, LANES, LoadKind, LoadSpec, ObservedSpec, Parts, Place,
    PointQuantity, label,
};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::modal::ModalBody;
use crate::model::{Formulation, Warning};
use crate::vector::Vector;

/// A body with its numbering.
pub(crate) struct MeshBody {
    pub spec: BodySpec,
    /// Global number of its first nodal vector.
    pub first_vector: usize,
    /// Frame that its vectors live in: the declared one, or the inertial one.
    pub frame: usize,
    /// Where the plane of a planar body lies in that frame, m.
    pub offset: Vector,
    pub connectivity: Connectivity,
    pub scatter: Scatter,
    /// Mass matrix of an element's vectors; where elements differ one after the other.
    pub mass: Vec<f64>,
    /// Mass matrix of all its vectors, what is fixed to it included.
    pub whole_mass: NodalMass,
    /// The same of what is fixed to it alone.
    pub fixed_mass: NodalMass,
    /// Its modes, where modal coordinates describe it.
    pub modes: Option<ModalBody>,
}

impl MeshBody {
    /// Components in the body's order to three frame axes.
    pub fn spread(&self, components: [f64; 3]) -> Vector {
        let mut vector = [0.0; 3];
        for (place, &axis) in self.spec.axes.iter().enumerate() {
            vector[axis] = components[place];
        }
        vector
    }
}

/// A vector at a place of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaceVector {
    /// Position.
    Position,
    /// Slope dp/dx.
    Slope,
    /// Derivative of the position along the section's y axis.
    SectionY,
    /// Derivative of the position along the section's z axis.
    SectionZ,
}

impl PlaceVector {
    /// The axes of a section of a body with vectors of this dimension.
    pub fn section(dimension: usize) -> &'static [Self] {
        &[Self::SectionY, Self::SectionZ][..dimension - 1]
    }

    /// What it interpolates, and the order of its derivative by x.
    fn interpolates(self) -> (Interpolant, usize) {
        match self {
            Self::Position => (Interpolant::Position, 0),
            Self::Slope => (Interpolant::Position, 1),
            Self::SectionY => (Interpolant::SectionY, 0),
            Self::SectionZ => (Interpolant::SectionZ, 0),
        }
    }
}

/// A point of a body: its element, and weights of the nodal vectors there.
#[derive(Clone, Debug)]
pub(crate) struct MeshPoint {
    pub body: usize,
    pub element: usize,
    /// Place on the element, in [0, 1].
    pub xi: f64,
    /// Of position, slope and, with a section, its axes; all of the same length, zeros where the body
    /// does not carry the vector.
    weights: [Vec<f64>; 4],
}

impl From<PointQuantity> for PlaceVector {
    fn from(what: PointQuantity) -> Self {
        match what {
            PointQuantity::Position | PointQuantity::Velocity => Self::Position,
            PointQuantity::Slope => Self::Slope,
            PointQuantity::SectionY => Self::SectionY,
            PointQuantity::SectionZ => Self::SectionZ,
        }
    }
}

impl MeshPoint {
    /// Weights of the element's nodal vectors in a vector.
    pub fn weights(&self, of: PlaceVector) -> &[f64] {
        &self.weights[of as usize]
    }
}

/// Buffers of the full (not reduced) state.
pub(crate) struct Buffers {
    /// Time of the loaded state, s.
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    /// Jerks of prescribed vectors, else zero.
    pub jerks: Vec<f64>,
    /// Components at the start of a step, for forces between two states.
    pub begun: Vec<f64>,
    pub force: Vec<f64>,
    pub frames: Vec<FrameMotion>,
    /// Results of elements side by side.
    pub lanes: Vec<[f64; LANES]>,
    /// Accelerations in space of a body's vectors.
    pub nodal: Vec<[Padded; 1]>,
    /// Places, velocities and accelerations in space of a body's vectors.
    pub nodal_rates: Vec<[Padded; 3]>,
    /// Gravity of the loads that are applied, m/s^2, inertial axes; for section forces.
    pub gravity: Vector,
    /// What acts inside the elements of every body, for section forces.
    pub point_forces: Vec<Vec<PointForce>>,
    /// What is added to the forces of the elements of every body in modes, for section forces; else nothing.
    pub held: Vec<Vec<f64>>,
    /// Values of densities and the part of them that is applied, for section forces.
    pub density_values: Vec<Vec<f64>>,
    pub density_scale: f64,
    /// How the fields on every free frame change with each of its unknowns, inertial axes.
    pub field_changes: Vec<Vec<Vector>>,
}

impl Buffers {
    pub fn new(components: usize, frames: Vec<FrameMotion>) -> Self {
        let zeros = || vec![0.0; components];
        Self {
            t: 0.0,
            q: zeros(),
            v: zeros(),
            a: zeros(),
            jerks: zeros(),
            begun: Vec::new(),
            force: zeros(),
            frames,
            lanes: Vec::new(),
            nodal: Vec::new(),
            nodal_rates: Vec::new(),
            gravity: [0.0; 3],
            point_forces: Vec::new(),
            held: Vec::new(),
            density_values: Vec::new(),
            density_scale: 0.0,
            field_changes: Vec::new(),
        }
    }
}

/// How the frames are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Regime {
    /// As the motions say.
    Moving,
    /// In uniform rotation with this multiple of the spin: prescribed frames turn on so, and what
    /// they prescribe rests in its frame. Free frames move as the state says.
    Uniform(f64),
}

/// The scene of a model with emitted parts. They stand behind a pointer, so that the runtime is compiled once and
/// not for every model.
pub struct MeshScene {
    pub(crate) parts: Box<dyn Parts>,
    pub(crate) formulation: Formulation,
    pub(crate) bodies: Vec<MeshBody>,
    pub(crate) joints: Vec<JointSpec>,
    pub(crate) conditions: Vec<Condition>,
    pub(crate) loads: Vec<LoadSpec>,
    pub(crate) load_points: Vec<Option<MeshPoint>>,
    pub(crate) observed: Vec<ObservedSpec>,
    pub(crate) observed_points: Vec<Option<MeshPoint>>,
    /// Free frames whose poses are unknown, ascending.
    pub(crate) free: Vec<FreeFrame>,
    /// For every frame its index among the free ones.
    pub(crate) free_of: Vec<Option<usize>>,
    /// Frames that are no unknowns where the bodies are absolute: those that follow bodies, and those that nothing needs.
    /// They stay at their start, but where outputs find their poses.
    pub(crate) fixed: Vec<FreeFrame>,
    /// What such frames follow, and the shape of all bodies that this refers to, in their declared frames.
    pub(crate) followed: Vec<Tie>,
    pub(crate) followed_shape: Vec<f64>,
    /// Unknown frames that took over velocity and angular velocity (frame axes) of a body as a whole from its initial
    /// velocity.
    pub(crate) taken: Vec<(usize, [Vector; 2])>,
    /// First unknowns of orientations.
    pub(crate) turns: Vec<usize>,
    /// Their columns on the pattern.
    pub(crate) turned: Arc<[TurnedColumns]>,
    pub(crate) markers: Vec<Marker>,
    pub(crate) constraints: Vec<Linked>,
    pub(crate) forces: Vec<ForceSpec>,
    /// For every force the free frame near which differences of its points are taken.
    pub(crate) force_anchors: Vec<Option<usize>>,
    pub(crate) marked_loads: Vec<MarkedLoad>,
    pub(crate) densities: Vec<Density>,
    pub(crate) density_batches: Vec<Batches>,
    pub(crate) fixtures: Vec<Fixture>,
    pub(crate) ties: Vec<Tie>,
    pub(crate) rigid_sections: Vec<RigidSection>,
    /// For every body that starts in relative equilibrium the components of its vectors, frame axes; else nothing.
    pub(crate) settled: Vec<Vec<f64>>,
    /// For every body the places beside its free frame.
    pub(crate) borders: Vec<Border>,
    /// Elements that are evaluated side by side.
    pub(crate) groups: Vec<Group>,
    pub(crate) layout: Layout,
    pub(crate) pattern: Pattern,
    pub(crate) constraint_pattern: Pattern,
    /// What every constraint is.
    pub(crate) constraint_rows: Vec<Row>,
    pub(crate) sizes: Vec<f64>,
    /// Mass matrix of the nodal vectors.
    pub(crate) mass: Vec<f64>,
    /// What is to be told of how the scene starts.
    pub(crate) remarks: Vec<Warning>,
    /// Whether inertia and elasticity of bodies with modes are left to the modes.
    pub(crate) in_modes: bool,
    pub(crate) buffers: Buffers,
}

/// A row of the constraints.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Row {
    /// Of a joint's conditions on a node.
    Condition { condition: usize, row: usize },
    /// Of a body that its frame follows.
    Tie { tie: usize },
    /// Of the section below a rigid fixture.
    Rigid { section: usize, row: usize },
    /// Of a constraint on markers.
    Linked { linked: usize, row: usize },
}

impl MeshScene {
    /// Components of all nodal vectors of the undeformed bodies, in their declared frames.
    pub(crate) fn shape(&self) -> Vec<f64> {
        let mut shape = Vec::with_capacity(self.layout.vector_components());
        for body in &self.bodies {
            for within in 0..body.spec.vectors() {
                let (node, local) = body.spec.locate(within);
                shape.extend(body.spec.undeformed(node, local));
            }
        }
        self.set_normals([&mut shape, &mut Vec::new()]);
        shape
    }

    /// Name of a joint for messages.
    pub(crate) fn joint_label(&self, joint: usize) -> String {
        label(self.joints.iter().map(|joint| joint.name), joint)
    }

    /// Place of the first row of the sections below rigid fixtures.
    pub(crate) fn first_rigid(&self) -> usize {
        let before = |row: &&Row| matches!(row, Row::Condition { .. } | Row::Tie { .. });
        self.constraint_rows.iter().take_while(before).count()
    }

    /// Place of the first row of the constraints on markers.
    pub(crate) fn first_linked(&self) -> usize {
        let linked = |row: &Row| matches!(row, Row::Linked { .. });
        self.constraint_rows
            .iter()
            .position(linked)
            .unwrap_or(self.constraint_rows.len())
    }

    /// Body, node and local number (of the start node) of a nodal vector.
    pub(crate) fn locate(&self, vector: usize) -> (&MeshBody, usize, usize) {
        let index = self.bodies.partition_point(|body| body.first_vector <= vector) - 1;
        let body = &self.bodies[index];
        let (node, local) = body.spec.locate(vector - body.first_vector);
        (body, node, local)
    }

    pub(crate) fn load_point(&self, load: &LoadSpec) -> Result<Option<MeshPoint>, ModelError> {
        match load.kind {
            LoadKind::Gravity | LoadKind::Field { .. } => Ok(None),
            LoadKind::Force { body, at } | LoadKind::Moment { body, at } => self.point(body, at, load.name).map(Some),
        }
    }

    pub(crate) fn observed_point(&self, observed: &ObservedSpec) -> Result<Option<MeshPoint>, ModelError> {
        match *observed {
            ObservedSpec::Point { body, at, .. } => self.point(body, at, "an output").map(Some),
            ObservedSpec::Section { body, at, what } => {
                self.check_sections(body)?;
                self.check_stress(body, what)?;
                self.point(body, at, "an output").map(Some)
            }
            ObservedSpec::Balance { of, what, .. } => self.check_balance(of, what).map(|()| None),
            _ => Ok(None),
        }
    }

    pub(crate) fn point(&self, body: usize, at: Place, user: &str) -> Result<MeshPoint, ModelError> {
        place_on(&*self.parts, &self.bodies[body].spec, body, at, user)
    }

    /// A vector at a point in one of the full arrays, `sum_a weight_a q_a`, frame axes.
    pub(crate) fn at_point(&self, point: &MeshPoint, of: PlaceVector, full: &[f64]) -> Vector {
        let body = &self.bodies[point.body];
        let components = body.connectivity.element(point.element);
        body.spread(weighted(full, components, body.spec.dimension(), point.weights(of)))
    }
}

/// The place of a marker on a body.
pub(crate) fn mesh_point(
    parts: &dyn Parts,
    bodies: &[BodySpec],
    body: usize,
    at: Place,
    user: &str,
) -> Result<MeshPoint, ModelError> {
    place_on(parts, &bodies[body], body, at, user)
}

/// Element and weights of a place on a body.
fn place_on(parts: &dyn Parts, spec: &BodySpec, body: usize, at: Place, user: &str) -> Result<MeshPoint, ModelError> {
    let (element, xi) = element_at(spec, at, user)?;
    Ok(point_of(parts, spec, body, element, xi))
}

/// Element of a place on a body, and where on the element it is, in [0, 1].
///
/// # Errors
/// A place beyond the ends, by the name of its user.
pub(crate) fn element_at(spec: &BodySpec, at: Place, user: &str) -> Result<(usize, f64), ModelError> {
    let length = spec.line.length();
    Ok(match at {
        Place::Start => (0, 0.0),
        Place::End => (spec.count - 1, 1.0),
        Place::At(x) if (0.0..=length).contains(&x) => spec.find(x / length),
        Place::At(x) => {
            return Err(ModelError::new(format!(
                "{user} is at {x} m of body `{}`, which is {length} m long: choose a place between 0 and its length",
                spec.label()
            )));
        }
    })
}

/// The point of an element at `xi` in [0, 1].
pub(crate) fn point_of(parts: &dyn Parts, spec: &BodySpec, body: usize, element: usize, xi: f64) -> MeshPoint {
    let vectors = [
        PlaceVector::Position,
        PlaceVector::Slope,
        PlaceVector::SectionY,
        PlaceVector::SectionZ,
    ];
    let weights = vectors.map(|vector| {
        let mut weights = vec![0.0; spec.nodal.len()];
        let (of, order) = vector.interpolates();
        if spec.interpolates(of) {
            parts.shapes(body, element, of, order, xi, &mut weights);
        }
        weights
    });
    MeshPoint {
        body,
        element,
        xi,
        weights,
    }
}
