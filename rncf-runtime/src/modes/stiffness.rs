//! The values of the co-rotating stiffness next to zero: each that passes zero along a parameter is a critical one.

use super::matrices::{apart_from, error, still, symmetrise, tangent};
use super::pair::Failure;
use super::pencil::Pencil;
use super::settled::settled;
use super::spectrum;
use crate::error::SolveError;
use crate::linalg::c64;
use crate::model::{Scene, Uniform};
use crate::system::{State, Tangent};

/// Part of what stands beside the mass that is round-off in a value of the stiffness: of motions that change nothing.
const NEUTRAL: f64 = 1e-10;
/// Part of the next larger value of the stiffness below which one is next to zero, and part of the larger one that then stands beside.
const NEXT: f64 = 1e-6;
const BESIDE: f64 = 1e-3;
/// Imaginary part of a real value that is round-off.
const REAL: f64 = 1e-6;

/// A part of the co-rotating stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stiffness {
    /// The symmetric one of what turns with this spin, rad/s: what dissipates in axes that stand still is left out.
    Symmetric(f64),
    /// All of it, circulatory forces as well: it is singular where an equilibrium at rest diverges, and its symmetric part elsewhere.
    Whole,
}

/// The lowest values mu of `K x = mu M x`, ascending, with a part of the co-rotating stiffness and constraints kept, 1/s^2: up to
/// the first `count` positive ones, of the symmetric part from `-2 spin^2`, below which turning brings none, of the whole one those that are
/// smaller in size than the largest one. The number of negative ones of the symmetric part is that of
/// [`unstable_directions`](super::unstable_directions), found from sparse matrices where there are many unknowns. Two conjugate values,
/// of what vibrates and grows, stand as their size: they pass zero nowhere. What moves without stiffness has zeros.
///
/// # Errors
/// As [`modes`](super::modes).
pub fn stiffness_values(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    count: usize,
    of: Stiffness,
) -> Result<Vec<f64>, SolveError> {
    let tangent = tangent(scene, at, state);
    let (pattern, mut tangent) = settled(scene, tangent);
    tangent.damping.fill(0.0);
    // What moves without stiffness has a value of zero at every parameter. Where forces follow what bends, another one that
    // becomes zero is not apart from it: to bend is to drift, too.
    let still = still(scene, at, state);
    let zeros = vec![0.0; still.len()];
    let beside_still = match of {
        Stiffness::Symmetric(spin) => {
            symmetrise(&pattern, &mut tangent.stiffness);
            // Beside the mass nothing is singular, and the lowest ones are those that are looked for.
            let tangent = beside_mass(&tangent, 2.0 * spin * spin);
            let pencil = apart_from(scene, state, (&pattern, &tangent), still);
            values(scene, at, &pencil, count, 2.0 * spin * spin)?
        }
        Stiffness::Whole => {
            let pencil = |scene: &mut dyn Scene, beside| {
                let tangent = beside_mass(&tangent, beside);
                apart_from(scene, state, (&pattern, &tangent), still.clone())
            };
            let bare = pencil(scene, 0.0);
            let mut found = values(scene, at, &bare, count, 0.0)?;
            if found.iter().all(|&value| value <= 0.0) {
                // Next to what is singular the others may be round-off.
                let beside = bare.guess().powi(2);
                let shifted = pencil(scene, beside);
                found = values(scene, at, &shifted, count, beside)?;
            }
            // What is next to zero has its sign beside the mass, where no value is. What is driven along a motion without stiffness, as a rocket that
            // leans, has none there, but round-off.
            match next_to_zero(&found).map(|next| BESIDE * next) {
                Some(beside) => {
                    let shifted = pencil(scene, beside);
                    values(scene, at, &shifted, count, beside)?
                }
                None => found,
            }
        }
    };
    let mut all = [zeros, beside_still].concat();
    all.sort_by(f64::total_cmp);
    Ok(all)
}

/// The largest of the values, in size, beside which the one below it is next to zero; `None` where none is.
fn next_to_zero(values: &[f64]) -> Option<f64> {
    let mut sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let pair = sizes
        .windows(2)
        .rfind(|pair| pair[0] <= NEXT * pair[1] && pair[1] > 0.0)?;
    Some(pair[1])
}

/// The tangent with so much of the mass, 1/s^2, beside the stiffness.
fn beside_mass(tangent: &Tangent, beside: f64) -> Tangent {
    let mut tangent = tangent.clone();
    let entries = tangent.stiffness.iter_mut().zip(&tangent.mass);
    entries.for_each(|(stiffness, mass)| *stiffness += beside * mass);
    tangent
}

/// The values of a pencil with so much of the mass, 1/s^2, beside its stiffness.
fn values(
    scene: &mut dyn Scene,
    at: &Uniform,
    pencil: &Pencil,
    count: usize,
    beside: f64,
) -> Result<Vec<f64>, SolveError> {
    let free = pencil.unknowns().saturating_sub(pencil.constraints());
    let mut asked = 2 * count;
    loop {
        let mut found = spectrum::lowest(pencil, asked);
        if let Err(Failure::Inexact(exact @ 1..)) = found {
            // Beside much larger ones the others are round-off; those next to zero are not.
            asked = free;
            found = spectrum::lowest(pencil, exact);
        }
        let pairs = found.map_err(|failure| error(scene, at, &failure))?;
        // Of a value below the range there are two eigenvalues +-s.
        let one = pairs.iter().map(|pair| pair.s).filter(|s| s.im > 0.0 || s.re >= 0.0);
        let signed = |s: c64| match value(s, beside) {
            value if value.abs() <= NEUTRAL * beside => 0.0,
            value => value,
        };
        let mut values: Vec<f64> = one.map(signed).collect();
        values.sort_by(f64::total_cmp);
        let positive = values.iter().filter(|&&value| value > 0.0).count();
        if positive >= count || asked >= free {
            return Ok(values);
        }
        asked *= 2;
    }
}

/// `-s^2` less what stands beside it, where that is a real number, else its size.
fn value(s: c64, beside: f64) -> f64 {
    let square = s * s;
    if square.im.abs() <= REAL * square.norm() {
        -square.re - beside
    } else {
        (square + beside).norm()
    }
}
