//! A density on its way to functions.

use crate::elements::{Library, NodalVector};
use crate::lower::markers::Marked;
use crate::lower::variant::Variant;
use crate::model::{Density, Expr, Model};
use crate::symbolic::{Id, linear::Vector};

/// A density on its way to functions.
pub(super) struct Law<'m> {
    pub(super) model: &'m Model,
    pub(super) density: &'m Density,
    pub(super) name: String,
    pub(super) variant: Variant,
    pub(super) vectors: Vec<&'m NodalVector>,
    /// Frame axes of the components of a nodal vector.
    pub(super) axes: &'static [usize],
    /// Components along those, with markers counted in the density's own list.
    pub(super) components: Vec<Expr>,
    pub(super) library: &'m Library,
}

/// The polynomial with symbols.
pub(super) struct Split<'m> {
    pub(super) marked: Marked<'m>,
    /// What is the same along the body.
    pub(super) values: Vec<Id>,
    /// Their symbols.
    pub(super) symbols: Vec<Id>,
    /// Components of the density over [`Split::factor`] as polynomials of [`Split::locals`] and [`Split::symbols`].
    pub(super) force: Vector,
    /// What all components are multiplied with, the same along the body; it is multiplied with the integrals.
    pub(super) factor: Id,
    /// Symbols of position and slope.
    pub(super) locals: [Vector; 2],
}
