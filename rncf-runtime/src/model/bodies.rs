//! The bodies of a scene as it tells them: how they are described, and what their sections carry.

use crate::archive::{Archive, Keep};
use crate::emitted::{Fidelity, SectionQuantity};
use crate::import::{Named, archive};
use crate::space::{Matrix, Vector, magnitude};

/// A meshed body of the declaration, as it is described in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct DescribedBody {
    /// Name in the declaration.
    pub name: &'static str,
    /// Number of its repetitions where it stands in a loop; such a body has all its nodal vectors.
    pub repetitions: Option<usize>,
    /// How finely its deformation is described.
    pub fidelity: Fidelity,
    /// Number of elements of all repetitions.
    pub elements: usize,
    /// Whether they integrate loads per length.
    pub is_loaded: bool,
}

/// Mass of a body, or of all, and how it is distributed at a state; inertial axes.
#[derive(Clone, Debug, PartialEq)]
pub struct MassProperties {
    /// Name of the body, or of the frame that has the inertia; empty: all together.
    pub name: String,
    /// kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub centre: Vector,
    /// Inertia about the centre of mass, kg m^2.
    pub inertia: Matrix,
}

/// A flexible body of a scene, as far as its section states need it.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionBody {
    /// Name in the declaration, with the number of the repetition where it is repeated.
    pub name: String,
    /// Length of the stress-free axis, m.
    pub length: f64,
    /// Number of its elements.
    pub elements: usize,
    /// Number of its section states.
    pub states: usize,
    /// Whether its elements have sections, which shear; a centre line tells neither shear forces nor a torque.
    pub has_section: bool,
    /// Whether it stays in a plane, and carries no torque.
    pub is_planar: bool,
    /// Whether [`SectionState::stress`] is known: the section says where its outermost fibres are.
    pub knows_stress: bool,
    /// Whether [`SectionState::axial_stress`] is known: the section has an area.
    pub knows_area: bool,
    /// Name of the material.
    pub material: &'static str,
}

impl SectionBody {
    /// Stress that counts at a section, Pa: von Mises, or that of the axial force alone; `None` where neither is known.
    pub fn stress_of(&self, state: &SectionState) -> Option<f64> {
        if self.knows_stress {
            return state.stress;
        }
        state.axial_stress
    }
}

/// How far the mesh of a body is from it at a state: energies of what its sections carry, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshError {
    /// Of forces and moments that balance inertia and loads.
    pub energy: f64,
    /// Of their difference to those of the elements' strains: over `energy` by how much the mesh is too stiff.
    pub error: f64,
}

impl Keep for MeshError {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { energy, error } = self;
        energy.keep(archive);
        error.keep(archive);
    }
}

/// What a section carries at the loaded state, in its own axes x (along `r_y x r_z`, of a centre line its
/// slope), y (along r_y) and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionState {
    /// Arclength of the stress-free axis, m.
    pub x: f64,
    /// Axial force and shear forces along y and z, N.
    pub forces: Vector,
    /// Torque and moments about y and z, N m. A centre line has the last alone: about the plane's normal,
    /// in space its magnitude.
    pub moments: Vector,
    /// Largest von Mises stress over the section, Pa; `None` where the section's extents are not known.
    pub stress: Option<f64>,
    /// Magnitude of the axial force over the area of the section, Pa; `None` where it has none, or the largest stress is known.
    pub axial_stress: Option<f64>,
    /// Least that the moments add to it where there is a yield stress, Pa: no section has its outermost fibres nearer to its centre than its radius of gyration.
    pub least_bending: Option<f64>,
    /// Yield stress of the material there, Pa.
    pub yield_stress: Option<f64>,
    /// Whether the body stays in a plane: its moment keeps its sign.
    pub is_planar: bool,
}

impl SectionState {
    /// One of its numbers; `None` for a stress that is not known.
    pub fn value(&self, of: SectionQuantity) -> Option<f64> {
        let [axial, shear_y, shear_z]: [f64; 3] = self.forces.into();
        let [torque, moment_y, moment_z]: [f64; 3] = self.moments.into();
        Some(match of {
            SectionQuantity::AxialForce => axial,
            SectionQuantity::ShearY => shear_y,
            SectionQuantity::ShearZ => shear_z,
            SectionQuantity::Torque => torque,
            SectionQuantity::MomentY => moment_y,
            SectionQuantity::MomentZ => moment_z,
            SectionQuantity::Moment if self.is_planar => moment_z,
            SectionQuantity::Moment => self.bending_moment(),
            SectionQuantity::Stress => return self.stress,
        })
    }

    /// Magnitude of the shear force, N.
    pub fn shear_force(&self) -> f64 {
        magnitude(self.forces[1], self.forces[2])
    }

    /// Magnitude of the bending moment, N m.
    pub fn bending_moment(&self) -> f64 {
        magnitude(self.moments[1], self.moments[2])
    }
}

/// A body that modes describe, as arrays of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportedBody {
    /// Name of the body.
    pub name: String,
    /// Name, sizes and values of every array, the last index fastest; SI, frame axes.
    pub arrays: Vec<Named>,
}

impl ExportedBody {
    /// The arrays as the bytes of an .npz file.
    pub fn to_npz(&self) -> Vec<u8> {
        archive(&self.arrays)
    }
}
