//! Critical values of a parameter: where the co-rotating stiffness is singular and a frequency seen in the
//! rotating axes is zero (THEORY 8.2; critical speeds, divergence, buckling).

use crate::error::SolveError;

/// A critical value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Critical {
    /// The value.
    pub value: f64,
    /// By how many the number of negative directions rises there; negative where it falls, and 2 where two
    /// directions become critical together, as those of a round shaft do.
    pub change: isize,
    /// Whether forces that come from no energy act: the stiffness is then singular in `change` directions, and which ones are negative on either
    /// side would depend on the mass.
    pub circulates: bool,
    /// How far off the value may be.
    pub within: f64,
    /// The interval around it in which no equilibrium was found, as next to a critical speed of an unbalanced shaft,
    /// where the deflection grows without bound; `None` where equilibria come as near as `within`.
    pub open: Option<[f64; 2]>,
}

/// The critical values between `from` and `to`, in the direction from one to the other, each to `tolerance`
/// (unit of the parameter): where `negatives` changes, the number of negative directions of the stiffness
/// ([`unstable_directions`](super::unstable_directions)) at a value of the parameter. What rises and falls
/// again between two values that were looked at is not seen: give it short intervals.
///
/// # Errors
/// The first one of `negatives`.
pub fn critical(
    from: f64,
    to: f64,
    tolerance: f64,
    mut negatives: impl FnMut(f64) -> Result<usize, SolveError>,
) -> Result<Vec<Critical>, SolveError> {
    let mut found = Vec::new();
    let mut open = vec![([from, to], [negatives(from)?, negatives(to)?])];
    while let Some(([low, high], [before, after])) = open.pop() {
        if before == after {
            continue;
        }
        let middle = 0.5 * (low + high);
        let is_narrow = (high - low).abs() <= tolerance || middle == low || middle == high;
        // A length that is no number ends as well.
        if is_narrow || !middle.is_finite() {
            found.push(Critical {
                value: middle,
                change: after as isize - before as isize,
                circulates: false,
                within: 0.5 * (high - low).abs(),
                open: None,
            });
            continue;
        }
        let between = negatives(middle)?;
        open.push(([middle, high], [between, after]));
        open.push(([low, middle], [before, between]));
    }
    Ok(found)
}
