//! Critical values between two equilibria at rest: where the bodies buckle or snap.

use super::continuation::Line;
use super::directions;
use crate::modes::Critical;

/// Where the number of negative directions changed in the last step.
pub(in crate::app) fn buckling(line: &mut Line<'_>) -> Vec<Critical> {
    let (Some(before), after) = line.last_two() else {
        return Vec::new();
    };
    let (Some(low), Some(high)) = (before.measured.clone(), after.measured.clone()) else {
        return Vec::new();
    };
    if low.negative == high.negative {
        return Vec::new();
    }
    let (before, after) = (before.clone(), after.clone());
    line.critical([&before, &after], [low, high], &mut |scene, at, step, _| {
        directions::at_rest(scene, at, step).ok().flatten()
    })
}
