//! Critical values between two equilibria at rest: where the bodies buckle or snap.

use super::continuation::{Line, Measured};
use crate::modes::Critical;

/// Where the number of negative directions changed in the last step.
pub(in crate::app) fn buckling(line: &mut Line<'_>) -> Vec<Critical> {
    let (Some(before), after) = line.last_two() else {
        return Vec::new();
    };
    let (Some(low), Some(high)) = (before.negative, after.negative) else {
        return Vec::new();
    };
    if low == high {
        return Vec::new();
    }
    let (before, after) = (before.clone(), after.clone());
    let known = |negative| Measured {
        negative,
        values: Vec::new(),
    };
    line.critical([&before, &after], [low, high].map(known), &mut |_, _, step, _| {
        step.negative.map(known)
    })
}
