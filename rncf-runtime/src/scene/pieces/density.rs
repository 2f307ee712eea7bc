//! A load per length with its places on the pattern.

use crate::emitted::DensitySpec;
use crate::scene::numbering::units::{Lanes, Units};

/// A load per length with its places on the pattern.
pub(crate) struct Density {
    pub spec: DensitySpec,
    /// Components of the body's nodal vectors, ascending, each once.
    pub components: Vec<usize>,
    /// Places among them, one element after the other.
    pub places: Vec<usize>,
    /// Unknowns that its values depend on, then those of the body's free frame that are not among them.
    pub outer: Vec<usize>,
    /// Number of unknowns that its values depend on.
    pub driving: usize,
    /// For every component the factor of its unknown; zero where there is none.
    pub factors: Vec<f64>,
    /// Places of components that depend on a second unknown: what it has stands after that of all components.
    pub doubled: Vec<usize>,
    /// For every component the entries of (component, outer unknown).
    pub upper: Vec<u32>,
    /// For every component the entry of (first unknown of the frame, component); the others of the frame follow.
    pub lower: Vec<u32>,
    /// For every unknown of the frame the entry of (frame, outer unknown), unknowns first.
    pub square: Vec<Option<usize>>,
}

/// All loads per length of a scene.
#[derive(Default)]
pub(crate) struct Densities {
    pub all: Vec<Density>,
    /// Their elements, side by side.
    pub batches: Vec<Batches>,
}

/// Rows of force and moment, frame axes.
pub(crate) const ROWS: usize = 6;

/// Elements of one kind of density, four by four.
pub(crate) struct Batches {
    /// Number of values.
    pub values: usize,
    /// Density and element.
    pub units: Units,
}

/// Values and nodal vectors of four elements, and what was computed with them.
pub(crate) struct Evaluated<'a> {
    /// Generalised forces on the nodal vectors, axes of the body's frame.
    pub force: &'a [Lanes],
    /// Derivatives of the force by q, n x n, and by the values, n x k, rows first; empty where only forces are wanted.
    pub by_q: &'a [Lanes],
    pub by_values: &'a [Lanes],
    /// Force and moment on the frame, frame axes; their derivatives by q, 6 x n, and by the values, 6 x k.
    pub rows: &'a [Lanes],
    pub rows_by_q: &'a [Lanes],
    pub rows_by_values: &'a [Lanes],
}

impl Batches {
    /// Numbers that a unit needs for forces, or with derivatives.
    pub fn width(&self, with_derivatives: bool) -> usize {
        let (n, k) = (self.units.size, self.values);
        let forces = k + 2 * n + ROWS;
        if with_derivatives {
            forces + (n + ROWS) * (n + k)
        } else {
            forces
        }
    }

    /// Takes the results of a unit apart.
    pub fn evaluated<'a>(&self, result: &'a [Lanes]) -> Evaluated<'a> {
        let (n, k) = (self.units.size, self.values);
        let (force, rest) = result[k + n..].split_at(n);
        let (rows, rest) = rest.split_at(ROWS);
        let length = |length: usize| if rest.is_empty() { 0 } else { length };
        let (by_q, rest) = rest.split_at(length(n * n));
        let (by_values, rest) = rest.split_at(rest.len().min(n * k));
        let (rows_by_q, rows_by_values) = rest.split_at(rest.len().min(ROWS * n));
        Evaluated {
            force,
            by_q,
            by_values,
            rows,
            rows_by_q,
            rows_by_values,
        }
    }
}
