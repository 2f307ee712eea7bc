//! The matrices of small motions about a uniform one, and what is said where their modes are not found.

use super::pair::Failure;
use super::pencil::{Pencil, orthonormal};
use crate::equilibrium;
use crate::error::{SolveError, SolveErrorKind};
use crate::linalg::Pattern;
use crate::model::{Scene, Uniform};
use crate::system::{State, Tangent};

pub(super) fn tangent(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Tangent {
    let zeros = || vec![0.0; scene.pattern().entries()];
    let mut tangent = Tangent {
        mass: zeros(),
        stiffness: zeros(),
        damping: zeros(),
    };
    scene.small_motions(at, state, &mut tangent);
    tangent
}

/// The pencil of matrices on `pattern`, for what moves beside some directions of the unknowns: `r^T M x = 0`, with forces `M r` that hold nothing but these.
pub(super) fn apart_from(
    scene: &mut dyn Scene,
    state: &State,
    (pattern, tangent): (&Pattern, &Tangent),
    directions: Vec<Vec<f64>>,
) -> Pencil {
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    let (constraints, sizes) = (scene.constraint_pattern(), scene.sizes());
    let units = units(scene, pattern, tangent);
    let units = [&units.rows[..], &units.columns];
    let momentum = |mut direction: Vec<f64>| {
        direction.iter_mut().zip(sizes).for_each(|(value, size)| *value *= size);
        let mut momentum = vec![0.0; sizes.len()];
        pattern.multiply_add(1.0, &tangent.mass, &direction, &mut momentum);
        momentum
    };
    let momenta = orthonormal(directions, sizes).into_iter().map(momentum);
    // What has no mass has no momentum.
    let momenta: Vec<Vec<f64>> = momenta.filter(|all| all.iter().any(|part| *part != 0.0)).collect();
    if momenta.is_empty() {
        return Pencil::new(pattern, tangent, constraints, &jacobian, units);
    }
    let own = constraints.columns();
    let known = (0..own).flat_map(|column| {
        let rows = constraints.starts()[column]..constraints.starts()[column + 1];
        rows.map(move |entry| (constraints.indices()[entry], column))
    });
    let known = known.zip(jacobian.iter().copied());
    let held = momenta.iter().enumerate().flat_map(|(index, momentum)| {
        let parts = momentum.iter().enumerate().filter(|(_, part)| **part != 0.0);
        parts.map(move |(row, part)| ((row, own + index), *part))
    });
    let entries: Vec<((usize, usize), f64)> = known.chain(held).collect();
    let all = Pattern::new(
        sizes.len(),
        own + momenta.len(),
        entries.iter().map(|(place, _)| *place),
    );
    let mut values = vec![0.0; all.entries()];
    for ((row, column), value) in entries {
        values[all.find(row, column).expect("the pattern is made of these entries")] = value;
    }
    Pencil::new(pattern, tangent, &all, &values, units)
}

/// In what the equations and the unknowns of a pencil are measured.
struct Units {
    rows: Vec<f64>,
    columns: Vec<f64>,
}

/// Those are the sizes of what moves. The size of a state says what errors of a run are held to: here it is as large as what moves it makes it, and its
/// equation counts as much as a stiffness.
fn units(scene: &dyn Scene, pattern: &Pattern, tangent: &Tangent) -> Units {
    let sizes = scene.sizes();
    let mut units = Units {
        rows: sizes.to_vec(),
        columns: sizes.to_vec(),
    };
    let states = scene.states();
    let own = |values: &[f64], state: usize| pattern.find(state, state).map_or(0.0, |place| values[place]);
    if !states.iter().any(|&state| own(&tangent.mass, state) == 0.0) {
        return units;
    }
    let mut known: Vec<bool> = (0..sizes.len()).map(|unknown| !states.contains(&unknown)).collect();
    let places: Vec<((usize, usize), f64, f64)> = pattern
        .places()
        .zip(tangent.stiffness.iter().zip(&tangent.damping))
        .map(|(place, (&stiffness, &damping))| (place, stiffness, damping))
        .collect();
    let most = |values: &[f64]| {
        let energies = pattern.places().zip(values);
        let moving = energies.filter(|((row, column), _)| !states.contains(row) && !states.contains(column));
        moving.fold(0.0, |most: f64, ((row, column), value)| {
            most.max((value * sizes[row] * sizes[column]).abs())
        })
    };
    let [stiffest, heaviest] = [&tangent.stiffness, &tangent.mass].map(|values| most(values));
    let quick = (stiffest / heaviest).sqrt();
    // What reads others alone comes behind them; an integral changes as quickly as what it reads.
    for _ in states {
        for &state in states {
            let rate = own(&tangent.stiffness, state).abs();
            let read = places
                .iter()
                .filter(|((row, column), ..)| *row == state && *column != state && known[*column]);
            let moved = read.map(|&((_, column), stiffness, damping)| {
                let slowly = stiffness.abs() / if rate > 0.0 { rate } else { quick };
                let slowly = if slowly.is_finite() { slowly } else { 0.0 };
                slowly.max(damping.abs()) * units.columns[column]
            });
            let largest = moved.fold(0.0, f64::max);
            if largest > 0.0 && !known[state] {
                units.columns[state] = largest;
                known[state] = true;
            }
        }
    }
    for &state in states {
        units.rows[state] = if stiffest > 0.0 { stiffest } else { 1.0 } / units.columns[state];
    }
    units
}

/// The motions without stiffness: directions of the unknowns.
pub(super) fn still(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Vec<Vec<f64>> {
    let mut still = scene.neutral_motions(at, state);
    still.extend(equilibrium::untied_directions(scene, at, state));
    still
}

/// The symmetric part of a matrix on a symmetric pattern.
pub(super) fn symmetrise(pattern: &Pattern, values: &mut [f64]) {
    for column in 0..pattern.columns() {
        for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
            let row = pattern.indices()[entry];
            if let Some(other) = pattern.find(column, row).filter(|_| row < column) {
                let mean = 0.5 * (values[entry] + values[other]);
                (values[entry], values[other]) = (mean, mean);
            }
        }
    }
}

pub(super) fn error(scene: &dyn Scene, at: &Uniform, failure: &Failure) -> SolveError {
    let n = scene.unknowns();
    let (text, worst) = match *failure {
        Failure::Singular(row) => {
            let worst = row.map(|row| {
                if row < n {
                    scene.describe_unknown(row)
                } else {
                    scene.describe_constraint(row - n)
                }
            });
            let text = "a motion has neither inertia nor stiffness, or constraints depend on each other";
            (text.to_string(), worst)
        }
        Failure::NotFinite => (
            "a matrix of small motions is not finite: a parameter is unphysical".to_string(),
            None,
        ),
        Failure::NotFound => (
            "the eigenvalues of a full matrix were not found: look for values out of the range of numbers".to_string(),
            None,
        ),
        Failure::Slow(found) => (
            format!(
                "the search did not converge beyond {found} modes: ask for fewer, or for other numbers of elements"
            ),
            None,
        ),
        Failure::Nothing(free) => (
            format!(
                "no mode was found though {free} motions are free, so that nothing is known of the stability: look for masses or stiffnesses that lie too many orders apart"
            ),
            None,
        ),
        Failure::Lost(found) => (
            format!(
                "beyond {found} modes some are lost to round-off: masses or stiffnesses lie too many orders apart; ask for at most {found}"
            ),
            None,
        ),
        Failure::Inexact(index) => (
            format!(
                "mode {} does not satisfy its equations to round-off: ask for at most {index}",
                index + 1
            ),
            None,
        ),
    };
    SolveError {
        kind: SolveErrorKind::NoModes(text),
        t: at.t,
        h: 0.0,
        worst,
    }
}
