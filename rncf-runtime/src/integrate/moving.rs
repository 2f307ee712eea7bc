//! A start with the velocities that joints and drives ask for.
//!
//! Of all velocities that constraints allow there are many where a mechanism has freedoms left, or deforms. Bodies are taken to go along as rigidly
//! as they can: the change has the least of `M + tau^2 K`, kinetic energy and that of the rates of strain, with the stiffness K of the bodies
//! alone. The time tau is long beside the periods of what deforms, so that K decides, and M does among what moves without strain.

use super::start;
use crate::error::SolveError;
use crate::linalg::Pattern;
use crate::system::{State, System};

/// `tau^2` in units of the shortest period of an unknown alone, over `(2 pi)^2`: bending that is a hundred thousand times slower than what is stiffest has less than
/// a thousandth of the rates that inertia alone gives it, and three digits are left to tell kinetic energies apart.
const STIFF: f64 = 1e13;

/// Gives the state, consistent but for its velocities, those nearest to its own that joints, drives and other constraints allow.
///
/// Positions that are slightly off the constraints are put onto them.
///
/// # Errors
/// Positions that violate a constraint by more than that, constraints that depend on each other or allow no velocity, and values that are not finite.
pub fn set_in_motion(system: &mut dyn System, state: &mut State) -> Result<(), SolveError> {
    if system.constraints() == 0 {
        return Ok(());
    }
    let entries = system.pattern().entries();
    let (mut mass, mut stiffness) = (vec![0.0; entries], vec![0.0; entries]);
    system.mass(state, &mut mass);
    let states = system.pattern().diagonal(system.states().iter().copied());
    states.for_each(|(_, place)| mass[place] = 1.0);
    system.elastic_stiffness(state, &mut stiffness);
    let slow = STIFF / fastest(system.pattern(), &mass, &stiffness);
    let weights = mass.iter().zip(&stiffness);
    let weights: Vec<f64> = if slow.is_finite() {
        weights.map(|(mass, stiffness)| mass + slow * stiffness).collect()
    } else {
        mass
    };
    let t = state.t;
    start::set_in_motion(system, state, weights).map_err(|(kind, worst)| SolveError { kind, t, h: 0.0, worst })
}

/// Square of the highest frequency of an unknown alone, rad^2/s^2.
fn fastest(pattern: &Pattern, mass: &[f64], stiffness: &[f64]) -> f64 {
    (0..pattern.columns())
        .filter_map(|index| pattern.find(index, index))
        .filter(|&entry| mass[entry] > 0.0)
        .map(|entry| stiffness[entry] / mass[entry])
        .fold(0.0, f64::max)
}
