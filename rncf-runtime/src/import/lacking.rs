//! What the kept modes of a body lack of the way that forces at its interfaces deflect it.

use super::files::{FULL_NODE, Sparse};
use super::freedoms::Freedoms;
use super::lowest::{Lowest, add_scaled, dot, factored, supports};

/// Displacements and rotations of all interfaces by forces and moments at them, rows first, that the matrices of a body give and its modes do not: those of
/// what is held, or of what accelerates as a whole. `None` where the stiffness cannot be solved.
pub(super) fn lacking(
    freedoms: &Freedoms,
    [stiffness, mass]: [&Sparse; 2],
    rigid: &[Vec<f64>],
    lowest: &Lowest,
) -> Option<Vec<f64>> {
    let unknowns: Vec<Option<usize>> = freedoms.interfaces.iter().flatten().copied().collect();
    let n = FULL_NODE * freedoms.interfaces.len();
    let supported = supports(rigid);
    let active: Vec<usize> = (0..stiffness.size())
        .filter(|at| supported.binary_search(at).is_err())
        .collect();
    let momenta: Vec<Vec<f64>> = rigid.iter().map(|motion| mass.times(motion)).collect();
    let mut factors = factored(stiffness, &active)?;
    let mut found = vec![0.0; n * n];
    for (column, unknown) in unknowns.iter().enumerate() {
        let Some(unknown) = *unknown else { continue };
        let mut load = vec![0.0; stiffness.size()];
        load[unknown] = 1.0;
        for (motion, momentum) in rigid.iter().zip(&momenta) {
            add_scaled(&mut load, -motion[unknown], momentum);
        }
        let mut solved: Vec<f64> = active.iter().map(|&at| load[at]).collect();
        factors.solve(&mut solved);
        let mut way = vec![0.0; stiffness.size()];
        active.iter().zip(solved).for_each(|(&at, value)| way[at] = value);
        for (motion, momentum) in rigid.iter().zip(&momenta) {
            let part = dot(momentum, &way);
            add_scaled(&mut way, -part, motion);
        }
        for (mode, frequency) in lowest.vectors.iter().zip(&lowest.frequencies) {
            add_scaled(&mut way, -mode[unknown] / frequency.powi(2), mode);
        }
        for (row, unknown) in unknowns.iter().enumerate() {
            found[row * n + column] = unknown.map_or(0.0, |unknown| way[unknown]);
        }
    }
    found.iter().all(|value| value.is_finite()).then_some(found)
}
