//! What a kind of constraint tells, of those that keep multipliers.

use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::combined::Combined;
use crate::system::{ConstraintLevel, Tangent};

/// A kind of constraint. Its rows in a scene follow each other; all its methods take the loaded state.
pub(crate) trait Constraint {
    /// For each of its rows the unknowns that it depends on, ascending.
    fn rows(&self, scene: &MeshScene) -> Vec<Vec<usize>>;

    /// Adds the entries of the pattern that its stiffness needs.
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>);

    /// A row in the user's words.
    fn describe(&self, scene: &MeshScene, row: usize) -> String;

    /// Whether its Jacobian depends on the state.
    fn is_curved(&self, scene: &MeshScene) -> bool;

    /// Sets its rows, on a level.
    fn values(&self, scene: &MeshScene, level: ConstraintLevel, t: f64, rows: &mut [f64]);

    /// Adds its Jacobian, in columns from `first` on.
    fn add_jacobian(&self, scene: &MeshScene, t: f64, first: usize, values: &mut [f64]);

    /// Adds `(d(C_x v + C_t)/dx)^T`, in columns from `first` on.
    fn add_rate_tangent(&self, scene: &MeshScene, t: f64, first: usize, values: &mut [f64]);

    /// Adds `d(C_x^T lambda)/dx`, of all multipliers of the scene.
    fn add_stiffness(&self, scene: &MeshScene, t: f64, lambda: &[f64], out: &mut Tangent);

    /// Adds the same to a combination.
    fn add_combined(&self, scene: &MeshScene, t: f64, lambda: &[f64], out: &mut Combined);

    /// Sets the round-off of its rows, which are zero.
    fn noise(&self, scene: &MeshScene, t: f64, rows: &mut [f64]);
}

impl MeshScene {
    /// Adds to the derivative of a row (a column of the constraints' pattern) by a component.
    pub(crate) fn add_to_row(&self, component: usize, column: usize, value: f64, values: &mut [f64]) {
        for (unknown, factor) in self.layout.unknowns_at(component) {
            if let Some(entry) = self.tabulated.constraint_pattern.find(unknown, column) {
                values[entry] += factor * value;
            }
        }
    }

    /// Unknowns of components, ascending, each once.
    pub(crate) fn unknowns_of(&self, components: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut unknowns: Vec<usize> = components
            .flat_map(|component| self.layout.unknowns_at(component).map(|(unknown, _)| unknown))
            .collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        unknowns
    }
}
