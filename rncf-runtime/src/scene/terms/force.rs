//! What a kind of force tells, of which the equations of motion `M a + f + C_x^T lambda = 0` are made of.

use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::combined::Combined;
use crate::space::Vector;
use crate::system::Tangent;

/// Where forces are wanted: at the loaded state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct At {
    /// Time, s.
    pub t: f64,
    /// What multiplies all loads.
    pub load_scale: f64,
    /// Gravity of all loads, m/s^2, inertial axes, so multiplied.
    pub gravity: Vector,
}

/// A kind of force. All its methods add, and take the loaded state.
pub(crate) trait Force {
    /// Adds the entries of the pattern that its derivatives need.
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>);

    /// Adds to the left side, for all components in the buffer `force`.
    fn add(&self, scene: &mut MeshScene, at: &At);

    /// Adds its derivatives with respect to a, v and x; the constant mass is there already.
    fn add_tangent(&self, scene: &mut MeshScene, at: &At, out: &mut Tangent);

    /// Adds a combination of the same.
    fn add_combined(&self, scene: &mut MeshScene, at: &At, out: &mut Combined);
}
