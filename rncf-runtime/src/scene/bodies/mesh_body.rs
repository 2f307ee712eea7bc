//! A body with its numbering.

use std::sync::{Arc, OnceLock};

use super::described::Described;
use super::nodal_mass::NodalMass;
use super::section::Section;
use crate::emitted::BodySpec;
use crate::scene::numbering::assembly::{Connectivity, Scatter};
use crate::space::Vector;

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
    /// What stresses follow from, where that is the same along the body; found where they are read.
    pub section: OnceLock<Section>,
    /// Its modes, where modal coordinates describe it.
    pub modes: Option<Arc<dyn Described>>,
}

impl MeshBody {
    /// Components in the body's order to three frame axes.
    pub fn spread(&self, components: [f64; 3]) -> Vector {
        let mut vector = Vector::zeros();
        for (place, &axis) in self.spec.axes.iter().enumerate() {
            vector[axis] = components[place];
        }
        vector
    }

    /// Whether all elements are alike.
    pub fn is_even(&self) -> bool {
        self.mass.len() == self.spec.nodal.len().pow(2)
    }

    /// Mass matrix of the vectors of an element.
    pub fn mass_of(&self, element: usize) -> &[f64] {
        let size = self.spec.nodal.len().pow(2);
        let element = if self.is_even() { 0 } else { element };
        &self.mass[element * size..(element + 1) * size]
    }

    /// Mass of its nodal vectors; where modes describe the body, that of what is fixed to it.
    pub fn nodal_mass(&self, in_modes: bool) -> &NodalMass {
        if in_modes && self.modes.is_some() {
            &self.fixed_mass
        } else {
            &self.whole_mass
        }
    }
}
