//! Whether the state in which a model starts is an equilibrium without spin and loads.

use crate::equilibrium::{Uniform, goes_back};
use crate::{Scene, State};

/// Part of the sizes of the unknowns by which a state that is in balance may be off.
const OFF: f64 = 1e-9;

/// A declared initial shape may be none: it is strained. Where Newton's iteration finds nothing, as of a rope that nothing stiffens, the forces are those of
/// a state that is off by this part, or less.
pub(in crate::app) fn is_balanced(scene: &mut dyn Scene, at: &Uniform, state: &State) -> bool {
    if let Some(stays) = goes_back(scene, at, state, state) {
        return stays;
    }
    let [mut forces, mut near] = [vec![0.0; scene.unknowns()], vec![0.0; scene.unknowns()]];
    let mut moved = state.clone();
    for (index, (x, size)) in moved.x.iter_mut().zip(scene.sizes()).enumerate() {
        *x += if index % 2 == 0 { OFF } else { -OFF } * size.max(x.abs());
    }
    scene.uniform_residual(at, state, &mut forces);
    scene.uniform_residual(at, &moved, &mut near);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    let change = largest(&mut forces.iter().zip(&near).map(|(a, b)| a - b));
    largest(&mut forces.iter().copied()) <= change
}
