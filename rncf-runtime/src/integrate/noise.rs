//! Round-off of constraints: how far an iteration can come where they compare places far from the origin.

use crate::error::Short;
use crate::system::{State, System};

/// Part of the error tolerance that may be round-off of the constraints.
pub(super) const BEARABLE: f64 = 0.25;
/// What an iteration leaves may exceed the estimate of round-off by.
const MARGIN: f64 = 30.0;

/// Round-off of all constraints at a state.
struct Noise {
    /// The smallest increments that take it away, root mean square in the norm of the weights.
    size: f64,
    /// The constraint with most of it, and its round-off in its unit.
    worst: Option<(usize, f64)>,
}

/// Round-off of the constraints in increments of unknowns; 1 / weight of every unknown is given.
fn of_constraints(system: &mut dyn System, state: &State, inverse_weights: &[f64]) -> Noise {
    let m = system.constraints();
    let mut jacobian = vec![0.0; system.constraint_pattern().entries()];
    let mut noise = vec![0.0; m];
    if m > 0 {
        system.constraint_jacobian(state, &mut jacobian);
        system.constraint_noise(state, &mut noise);
    }
    let pattern = system.constraint_pattern();
    let (mut sum, mut worst, mut largest) = (0.0, None, 0.0);
    for (column, noise) in noise.iter_mut().enumerate() {
        let (mut terms, mut slope) = (0.0, 0.0);
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            let unknown = pattern.indices()[place];
            terms += (jacobian[place] * state.x[unknown]).abs();
            slope += (jacobian[place] / inverse_weights[unknown]).powi(2);
        }
        // What the unknowns are rounded to counts where the system does not know better.
        *noise = noise.max(f64::EPSILON * terms);
        if slope > 0.0 {
            let part = noise.powi(2) / slope;
            sum += part;
            if part > largest {
                (largest, worst) = (part, Some((column, *noise)));
            }
        }
    }
    Noise {
        size: (sum / state.x.len().max(1) as f64).sqrt(),
        worst,
    }
}

/// Whether an iteration that contracts no more, with increments of `size` in the norm of the weights, has come as far as
/// round-off of the constraints lets it, and that is `bearable`.
pub(super) fn is_all_that_is_left(
    system: &mut dyn System,
    state: &State,
    inverse_weights: &[f64],
    size: f64,
    bearable: f64,
) -> bool {
    size <= bearable && system.constraints() > 0 && size <= MARGIN * of_constraints(system, state, inverse_weights).size
}

/// Says that a tolerance cannot be met for round-off of a constraint, which one, and what to do; `None` if it can be.
pub(super) fn below_round_off(system: &mut dyn System, state: &State, rtol: f64) -> Option<String> {
    let inverse_weights: Vec<f64> = system.sizes().iter().map(|size| 1.0 / (rtol * size)).collect();
    let Noise { size, worst } = of_constraints(system, state, &inverse_weights);
    let (column, noise) = worst.filter(|_| MARGIN * size > BEARABLE)?;
    let name = system.describe_constraint(column);
    let least = rtol * size * MARGIN / BEARABLE;
    Some(format!(
        "the tolerance is below round-off: {name} is known to {} only, since it compares places that far from the origin; take a \
         tolerance of {} or more instead of {}, or an origin nearer to what moves",
        Short(noise),
        Short(least),
        Short(rtol)
    ))
}
