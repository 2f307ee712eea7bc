//! The scene of a model: what it consists of, sizes, and places on bodies.

use std::sync::OnceLock;

use crate::emitted::{Fidelity, JointKind, JointSpec, LoadKind, LoadSpec, ObservedSpec, Parts, Place, label};
use crate::error::ModelError;
use crate::model::{Formulation, Joints, Warning};
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::place::{MeshPoint, PlaceVector, place_on, weighted};
use crate::scene::frames::all::SceneFrames;
use crate::scene::numbering::conditions::Condition;
use crate::scene::numbering::layout::Layout;
use crate::scene::pieces::buffers::Buffers;
use crate::scene::pieces::density::Densities;
use crate::scene::pieces::fixture::Fixture;
use crate::scene::pieces::links::Links;
use crate::scene::pieces::placed::Placed;
use crate::scene::pieces::rigid_section::RigidSection;
use crate::scene::pieces::rows::{LINKS, RIGID_SECTIONS};
use crate::scene::pieces::tabulated::Tabulated;
use crate::space::Vector;

/// The scene of a model with emitted parts. They stand behind a pointer, so that the runtime is compiled once and
/// not for every model.
pub struct MeshScene {
    pub(crate) parts: Box<dyn Parts>,
    pub(crate) formulation: Formulation,
    /// What becomes of linear joints.
    pub(crate) declared: Joints,
    pub(crate) bodies: Vec<MeshBody>,
    pub(crate) frames: SceneFrames,
    pub(crate) joints: Vec<JointSpec>,
    pub(crate) conditions: Vec<Condition>,
    pub(crate) links: Links,
    pub(crate) dead_loads: Placed<LoadSpec>,
    pub(crate) distributed: Densities,
    pub(crate) fixtures: Vec<Fixture>,
    pub(crate) rigid_sections: Vec<RigidSection>,
    pub(crate) observed: Placed<ObservedSpec>,
    /// For every body that starts in relative equilibrium the components of its vectors, frame axes; else nothing.
    pub(crate) settled: Vec<Vec<f64>>,
    /// What is to be told of how the scene starts.
    pub(crate) remarks: Vec<Warning>,
    /// What elements miss of properties along an axis, once it was asked for.
    pub(crate) missed: OnceLock<Vec<Warning>>,
    /// Whether inertia and elasticity of bodies with modes are left to the modes.
    pub(crate) in_modes: bool,
    pub(crate) layout: Layout,
    pub(crate) tabulated: Tabulated,
    pub(crate) buffers: Buffers,
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

    /// Whether a body may turn in the axes of its unknowns: neither do they follow it, nor does a joint clamp it to them.
    pub(crate) fn may_turn_in_its_axes(&self, index: usize) -> bool {
        let body = &self.bodies[index];
        let is_followed = body.frame != 0 && self.frames.free_of[body.frame].is_some();
        let clamps = |joint: &&JointSpec| matches!(joint.kind, JointKind::Clamp | JointKind::ClampFull);
        // Joints, of which there are as many as bodies, are asked last.
        let mut clamps = self.joints.iter().filter(clamps);
        let mut is_clamped = || clamps.any(|joint| joint.body == index && joint.frame == body.frame);
        body.spec.fidelity == Fidelity::Full && !is_followed && !is_clamped()
    }

    /// Name of a joint for messages.
    pub(crate) fn joint_label(&self, joint: usize) -> String {
        label(self.joints.iter().map(|joint| joint.name), joint)
    }

    /// Place of the first row of the sections below rigid fixtures.
    pub(crate) fn first_rigid(&self) -> usize {
        self.tabulated.rows.first(RIGID_SECTIONS)
    }

    /// Place of the first row of the constraints on markers.
    pub(crate) fn first_linked(&self) -> usize {
        self.tabulated.rows.first(LINKS)
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
            LoadKind::Gravity | LoadKind::Around | LoadKind::Field { .. } => Ok(None),
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
