//! How far apart two states are.

use crate::model::Scene;
use crate::space::product;
use crate::system::State;

/// Largest difference of two states' positions and orientations, relative to the sizes of the unknowns.
pub fn distance(scene: &dyn Scene, a: &State, b: &State) -> f64 {
    over(scene, a, b, scene.sizes())
}

/// The same with lengths below 1 m over 1 m: what is small and carried on without turning is near.
pub(super) fn turned(scene: &dyn Scene, a: &State, b: &State) -> f64 {
    let sizes: Vec<f64> = scene.sizes().iter().map(|size| size.max(1.0)).collect();
    over(scene, a, b, &sizes)
}

fn over(scene: &dyn Scene, a: &State, b: &State, sizes: &[f64]) -> f64 {
    let mut b = b.clone();
    // In the charts of a.
    for (index, &unknown) in scene.turns().iter().enumerate() {
        let away = product(&a.turns[index].inverse(), &b.orientation(index, unknown));
        b.x[unknown..unknown + 3].copy_from_slice(away.scaled_axis().as_slice());
    }
    // Those of equilibria have just begun anew. A state is as large as it is.
    let own = |unknown: usize| match scene.states().contains(&unknown) {
        true => sizes[unknown].max(a.x[unknown].abs()).max(b.x[unknown].abs()),
        false => sizes[unknown],
    };
    let parts = a.x.iter().zip(&b.x).enumerate();
    parts.fold(0.0, |largest: f64, (unknown, (a, b))| {
        largest.max((a - b).abs() / own(unknown))
    })
}
