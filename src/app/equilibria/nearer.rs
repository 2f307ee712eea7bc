//! Whether another relative equilibrium is nearer to the undeformed shape than that at which a way along the spin or a param ends: an unbalanced shaft that stiffens as
//! it bends goes on, beyond its critical speed, as a rope that is swung, and runs as quietly as below it besides.

use super::continuation::Station;
use crate::app::results::history::History;
use crate::equilibrium::{self, assembled, continue_from, goes_back, is_nearer};

/// Part of an output by which both must differ.
const APART: f64 = 0.01;

/// What helps the equilibria of a way, and a diagram of modes about them.
pub(super) const EQUILIBRIA: &str = "For the other one begin where there is no second one, as beyond a critical speed (a range of a param), or look at `modes`, which take it";
pub(in crate::app) const DIAGRAM: &str = "Modes and critical values are those of this way, and not those about the other one: go the way from its other end, or make what bends it, as an unbalance, smaller";

/// That there is one, with the output that differs most, and what helps.
pub(in crate::app) fn nearer(station: &mut Station<'_>, history: &History, cure: &str) -> Option<String> {
    let (scene, at, state) = (&mut *station.scene, &station.at, station.state);
    // What nothing ties is at no certain place.
    if !scene.neutral_motions(at, state).is_empty() || !equilibrium::untied(scene, at, state).is_empty() {
        return None;
    }
    let start = assembled(scene, at);
    if goes_back(scene, at, &start, state) != Some(false) {
        return None;
    }
    let other = continue_from(scene, at, &start).ok()?;
    // Newton's iteration may leap over this one, too.
    if !is_nearer(scene, &start, &other.state, state) {
        return None;
    }
    let [mut here, mut there] = [vec![0.0; scene.output_columns()], vec![0.0; scene.output_columns()]];
    scene.uniform_outputs(at, state, &mut here);
    scene.uniform_outputs(at, &other.state, &mut there);
    // A component that both have nothing of is no witness.
    let vector = |column: usize| history.columns[column].name.split('.').next();
    let part = |column: usize| {
        let of_vector = (0..here.len()).filter(|&other| vector(other) == vector(column));
        let size = of_vector.fold(0.0f64, |size, other| {
            size.max(here[other].abs()).max(there[other].abs())
        });
        if size > 0.0 {
            (here[column] - there[column]).abs() / size
        } else {
            0.0
        }
    };
    let most = (0..here.len()).max_by(|&a, &b| part(a).total_cmp(&part(b)))?;
    if part(most) <= APART {
        return None;
    }
    let output = &history.columns[most];
    Some(format!(
        "at {} another equilibrium is nearer to the undeformed shape, with `{}` = {} and not {}: this way came along as a slow change without losses does. {cure}",
        history.key.at(station.key, 6),
        output.name,
        output.quantity(there[most], 4),
        output.quantity(here[most], 4),
    ))
}
