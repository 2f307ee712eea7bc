//! Motions of the centres of mass of a body's sections, and of the sections about them.
//!
//! Nodal vectors refer to the axis that a body is declared by. Where the mass of its sections lies beside that axis, a rotation of a section
//! moves mass across, too: the mass matrix couples both. The motion `u_a + M_aa^-1 M_as u_s` of the vectors of the axis is that of the
//! mass in the mean; what is left of the kinetic energy is of the sections about it, with `M_ss - M_sa M_aa^-1 M_as`. So parts of the
//! energy do not depend on the axis that was chosen.

use crate::scene::bodies::nodal_mass::{NodalMass, Padded, add_scaled};

/// Remainder of a solution, part of its right side.
const SOLVED: f64 = 1e-10;

/// Real and imaginary part of a displacement of every nodal vector.
pub(super) type Displacements = Vec<[Padded; 2]>;

/// A body's mass, by vectors of its axis and of its sections.
pub(super) struct Sections<'a> {
    mass: &'a NodalMass,
    is_axis: &'a [bool],
    /// Masses of single vectors of the axis, zero elsewhere.
    diagonal: Vec<f64>,
    /// Whether mass lies beside the axis.
    is_beside: bool,
}

impl<'a> Sections<'a> {
    pub(super) fn new(mass: &'a NodalMass, is_axis: &'a [bool]) -> Self {
        let mut diagonal = vec![0.0; is_axis.len()];
        let mut is_beside = false;
        for row in (0..is_axis.len()).filter(|&row| is_axis[row]) {
            for (column, value) in mass.entries(row) {
                if column == row {
                    diagonal[row] = value;
                }
                is_beside |= !is_axis[column] && value != 0.0;
            }
        }
        Self {
            mass,
            is_axis,
            diagonal,
            is_beside,
        }
    }

    /// Displacements of the axis at which the mass is in the mean, and zero for vectors of the sections.
    pub(super) fn centres(&self, displaced: &[[Padded; 2]]) -> Displacements {
        let mut centres = self.only(displaced, true);
        if self.is_beside {
            let shift = self.shift(&self.only(displaced, false));
            add(&mut centres, 1.0, &shift);
        }
        centres
    }

    /// Product with the mass, of vectors of the axis alone.
    pub(super) fn image_of_axis(&self, displaced: &[[Padded; 2]]) -> Displacements {
        self.image(&self.only(displaced, true), true)
    }

    /// Product with the mass about the centres, of vectors of the sections alone.
    pub(super) fn image_of_sections(&self, displaced: &[[Padded; 2]]) -> Displacements {
        let own = self.only(displaced, false);
        let mut image = self.image(&own, false);
        if self.is_beside {
            let carried = self.image(&self.shift(&own), false);
            add(&mut image, -1.0, &carried);
        }
        image
    }

    fn only(&self, displaced: &[[Padded; 2]], axis: bool) -> Displacements {
        let own = displaced.iter().zip(self.is_axis);
        own.map(|(value, &is_axis)| if is_axis == axis { *value } else { Default::default() })
            .collect()
    }

    /// Rows of the product with the mass, of the axis or of the sections; zero elsewhere.
    fn image(&self, displaced: &[[Padded; 2]], axis: bool) -> Displacements {
        let row = |row: usize| match self.is_axis[row] == axis {
            true => self.mass.product(row, displaced),
            false => Default::default(),
        };
        (0..self.is_axis.len()).map(row).collect()
    }

    /// `M_aa^-1 M_as u_s`, by conjugate gradients.
    fn shift(&self, sections: &[[Padded; 2]]) -> Displacements {
        let mut left = self.image(sections, true);
        let mut found = vec![Default::default(); left.len()];
        let scaled = |left: &Displacements| -> Displacements {
            let rows = left.iter().zip(&self.diagonal);
            rows.map(|(value, &mass)| value.map(|part| part.map(|x| if mass > 0.0 { x / mass } else { 0.0 })))
                .collect()
        };
        let mut direction = scaled(&left);
        let mut size = inner(&left, &direction);
        let least = SOLVED * SOLVED * size;
        for _ in 0..2 * left.len() {
            if size <= least {
                break;
            }
            let image = self.image(&direction, true);
            let step = size / inner(&direction, &image);
            add(&mut found, step, &direction);
            add(&mut left, -step, &image);
            let next = scaled(&left);
            let before = size;
            size = inner(&left, &next);
            for (direction, next) in direction.iter_mut().zip(next) {
                for (direction, next) in direction.iter_mut().zip(next) {
                    let mut sum = next;
                    add_scaled(&mut sum, size / before, direction);
                    *direction = sum;
                }
            }
        }
        found
    }
}

fn add(sums: &mut Displacements, factor: f64, values: &[[Padded; 2]]) {
    for (sum, value) in sums.iter_mut().zip(values) {
        for (sum, value) in sum.iter_mut().zip(value) {
            add_scaled(sum, factor, value);
        }
    }
}

/// Sum of the products of all components.
pub(super) fn inner(a: &[[Padded; 2]], b: &[[Padded; 2]]) -> f64 {
    let pairs = a.iter().flatten().flatten().zip(b.iter().flatten().flatten());
    pairs.map(|(a, b)| a * b).sum()
}
