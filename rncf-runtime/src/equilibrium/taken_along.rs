//! What a uniform motion takes along that is declared to start otherwise.

use crate::integrate::moves_off;
use crate::model::{Scene, Uniform};

/// Names of what moves freely and counts as turning with all else in a uniform motion, while constraints would let it start as it is declared: at
/// rest, or with another rotation. Where they do not, they turn it.
pub fn taken_along(scene: &mut dyn Scene, at: &Uniform) -> Vec<String> {
    let names = scene.starting_otherwise(at);
    let (start, turn) = (scene.rest(0.0), 1.0 / scene.spin(0.0));
    if names.is_empty() || moves_off(scene, &start, turn) {
        return Vec::new();
    }
    names
}
