//! What is computed once for all states: patterns, sizes of unknowns, the constant mass matrix.

use super::batches::Group;
use super::border::Border;
use super::rows::Rows;
use crate::linalg::Pattern;

/// Patterns and constants of a scene that is numbered.
#[derive(Default)]
pub(crate) struct Tabulated {
    /// Of the unknowns.
    pub pattern: Pattern,
    /// Of unknowns and constraints.
    pub constraint_pattern: Pattern,
    /// Where the rows of every kind of constraint stand.
    pub rows: Rows,
    /// Sizes of the unknowns.
    pub sizes: Vec<f64>,
    /// Distance from the origin of what moves freely, m, where nothing in the scene has a length.
    pub distance: Option<f64>,
    /// Mass matrix of the nodal vectors.
    pub mass: Vec<f64>,
    /// For every body the places beside its free frame.
    pub borders: Vec<Border>,
    /// Elements that are evaluated side by side.
    pub groups: Vec<Group>,
}
