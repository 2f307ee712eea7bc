//! Small motions about a relative equilibrium (THEORY 8.2): eigenvalues, modes, their stability and whirl,
//! and which mode is which when a parameter changes.
//!
//! `(K + s C + s^2 M) x + C_x^T lambda = 0, C_x x = 0` with the co-rotating matrices of
//! [`Scene::small_motions`]: time enters as exp(s t), s = re + i im, and frequencies are those seen by an
//! observer that turns with the system.

mod arnoldi;
mod carried;
mod circles;
mod critical;
mod dense;
mod growth;
mod matrices;
mod mode;
mod pair;
mod pencil;
mod refinement;
mod settled;
mod spectrum;
mod stiffness;
mod tracking;
mod whirl;

pub use crate::model::{Composition, Motion};
pub use critical::{Critical, critical};
pub use mode::{Mode, number};
pub use pencil::Pencil;
pub use stiffness::{Stiffness, stiffness_values};
pub use tracking::{assurance, followed, matched};
pub use whirl::Whirl;

use crate::error::SolveError;
use crate::linalg::{Pattern, c64};
use crate::model::{Scene, Uniform};
use crate::system::{State, Tangent};
use carried::carried;
use circles::turn_to_circles;
use matrices::{apart_from, error, still, tangent};
use pair::{Failure, Pair};
use settled::settled;

/// Which modes are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// Number of modes, those of the lowest |s|; a system with fewer has all of its modes returned.
    pub count: usize,
}

/// Modes of small motions about the equilibrium `state` of the uniform motion `at`, ascending frequencies,
/// those of equal frequency by their growth, or the one that goes round with the spin first, and behind them what creeps back without one. A motion that drifts (a free body's) is one mode though its
/// eigenvalue is a double one.
///
/// # Errors
/// [`SolveErrorKind::NoModes`](crate::error::SolveErrorKind::NoModes): the matrices are singular (naming the unknown or constraint), a value is
/// not finite, a mode was not found to the accuracy of the matrices, or none was found though motions are free.
pub fn modes(scene: &mut dyn Scene, at: &Uniform, state: &State, wanted: Wanted) -> Result<Vec<Mode>, SolveError> {
    let lowest = |pencil: &Pencil, count| Ok((spectrum::lowest(pencil, count)?, false));
    found(scene, at, state, wanted, lowest).map(|(modes, _)| modes)
}

/// The same modes, and those beyond them that grow; whether all modes were looked at for that. Of up to 60 unknowns they are, and up to `most` where forces
/// or damping may feed a motion: full matrices take time with the cube of the unknowns.
///
/// # Errors
/// As [`modes`].
pub fn modes_and_growing(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    wanted: Wanted,
    most: usize,
) -> Result<(Vec<Mode>, bool), SolveError> {
    let search = |pencil: &Pencil, count| spectrum::lowest_and_growing(pencil, count, most);
    found(scene, at, state, wanted, search)
}

/// Modes that a search finds of the pencil, and what it says of them.
fn found(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    wanted: Wanted,
    search: impl Fn(&Pencil, usize) -> Result<(Vec<Pair>, bool), Failure>,
) -> Result<(Vec<Mode>, bool), SolveError> {
    // What the scene knows to have no stiffness, or to be carried by nothing, needs not be told from round-off.
    let still = still(scene, at, state);
    let tangent = tangent(scene, at, state);
    let speed = scene.spin_in(at);
    let carried = carried(scene, at, state, &tangent, speed);
    let shifts = carried.iter().flat_map(|carried| carried.shifts.clone()).collect();
    let pattern = scene.pattern().clone();
    let pencil = apart_from(scene, state, (&pattern, &tangent), shifts)
        .without_stiffness_along(still)
        .turning(speed);
    let sizes = scene.sizes().to_vec();
    let (mut pairs, is_all) = search(&pencil, wanted.count).map_err(|failure| error(scene, at, &failure))?;
    let found = pairs.len().max(wanted.count);
    for carried in carried {
        let relative = carried.shape().into_iter().zip(pencil.scales());
        let x: Vec<_> = relative.map(|(value, scale)| value / *scale).collect();
        let s = c64::new(0.0, speed);
        // Where it is, and how it goes on: two motions of one shape.
        pairs.extend([x.clone(), x].map(|x| Pair { s, x }));
    }
    pairs.sort_by(|a, b| pair::order(a.s, b.s));
    pairs.truncate(found);
    number(&mut pairs, |pair| [pair.s.re, pair.s.im]);
    let states = scene.states();
    let mode = |pair: Pair| mode(&pencil, (&sizes, states), pair);
    let mut modes: Vec<Mode> = pairs.into_iter().map(mode).collect();
    turn_to_circles(scene, at, state, (&mut modes, &sizes));
    Ok((modes, is_all))
}

/// Number of directions in which the co-rotating stiffness (its symmetric part: what dissipates in axes
/// that stand still is left out) is negative at a state, constraints kept. Where it changes with a
/// parameter, a frequency is zero: a critical speed or a buckling load. Full matrices: time grows with the
/// cube of the unknowns.
///
/// # Errors
/// [`SolveErrorKind::NoModes`](crate::error::SolveErrorKind::NoModes) if a value is not finite.
pub fn unstable_directions(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Result<usize, SolveError> {
    let pencil = beside_still(scene, at, state);
    dense::negative_stiffness(&pencil).map_err(|failure| error(scene, at, &failure))
}

/// The pencil with states at rest, which knows the motions without stiffness.
fn beside_still(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Pencil {
    let still = still(scene, at, state);
    let speed = scene.spin_in(at);
    let tangent = tangent(scene, at, state);
    let (pattern, tangent) = settled(scene, tangent);
    apart_from(scene, state, (&pattern, &tangent), Vec::new())
        .without_stiffness_along(still)
        .turning(speed)
}

/// Whether circulatory forces act, the skew part of the stiffness: then an equilibrium may be unstable in growing vibrations
/// though its stiffness is positive, and [`unstable_directions`] does not tell.
pub fn is_circulatory(scene: &mut dyn Scene, at: &Uniform, state: &State) -> bool {
    let tangent = tangent(scene, at, state);
    let (pattern, Tangent { stiffness, .. }) = settled(scene, tangent);
    let sizes = scene.sizes();
    let places = || {
        let all = pattern.places().enumerate();
        all.map(|(entry, (row, column))| (entry, row, column))
    };
    let scaled = |entry: usize, row: usize, column: usize| stiffness[entry] * sizes[row] * sizes[column];
    let mut largest = vec![0.0_f64; pattern.columns()];
    for (entry, row, column) in places() {
        largest[row] = largest[row].max(scaled(entry, row, column).abs());
    }
    // Rows that cancel are round-off of what has cancelled.
    let cancelled = CANCELLED * largest.iter().copied().fold(0.0, f64::max);
    places()
        .filter(|&(_, row, column)| row < column)
        .any(|(entry, row, column)| {
            let other = pattern
                .find(column, row)
                .map_or(0.0, |other| scaled(other, column, row));
            let skew = (scaled(entry, row, column) - other).abs();
            skew > cancelled + CIRCULATORY * (largest[row] * largest[column]).sqrt()
        })
}

/// Part of the stiffness of their rows from which on two entries that differ count as different.
const CIRCULATORY: f64 = 1e-9;
/// Round-off of an entry, of the largest one.
const CANCELLED: f64 = 8.0 * f64::EPSILON;

/// Stability margin: the largest rate of growth, 1/s. Negative: the equilibrium is asymptotically stable in
/// these modes; 0 to round-off: neutral, as without damping; `None` without modes.
pub fn stability_margin(modes: &[Mode]) -> Option<f64> {
    modes.iter().map(|mode| mode.re).reduce(f64::max)
}

/// How far the frequencies of modes about a uniform motion are too high for the meshes of the bodies, as parts of them: for each
/// mode one number for every body of [`Scene::section_bodies`]. To first order what the meshes have too much of stiffness
/// changes s by `x . dK x / (x . (2 s M + C) x)`. Of motions that creep nothing is known.
pub fn mesh_errors(scene: &mut dyn Scene, at: &Uniform, state: &State, modes: &[Mode]) -> Vec<Vec<f64>> {
    let tangent = tangent(scene, at, state);
    let of = |scene: &mut dyn Scene, mode: &Mode| -> Vec<f64> {
        let size = mode.re.hypot(mode.im);
        if mode.im <= CREEPING * size || size == 0.0 {
            return Vec::new();
        }
        let [mass, damping] =
            [&tangent.mass, &tangent.damping].map(|values| form(scene.pattern(), values, &mode.shape));
        let by = [
            2.0 * (mode.re * mass[0] - mode.im * mass[1]) + damping[0],
            2.0 * (mode.re * mass[1] + mode.im * mass[0]) + damping[1],
        ];
        let changed = by[0].hypot(by[1]) * size;
        let errors = scene.mode_mesh_errors(at, state, [mode.re, mode.im], &mode.shape);
        errors.into_iter().map(|error| error / changed).collect()
    };
    modes.iter().map(|mode| of(scene, mode)).collect()
}

/// Part of |s| below which a frequency is that of a motion that creeps.
const CREEPING: f64 = 0.3;

/// `conj(x) . A x` of a matrix on a pattern.
fn form(pattern: &Pattern, values: &[f64], x: &[[f64; 2]]) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for column in 0..pattern.columns() {
        for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
            let ([a, b], [c, d]) = (x[pattern.indices()[entry]], x[column]);
            sum[0] += values[entry] * (a * c + b * d);
            sum[1] += values[entry] * (a * d - b * c);
        }
    }
    sum
}

/// Part of what moves, of what states change in a mode, that is round-off: nothing moves.
const UNMOVED: f64 = 1e-8;

/// The mode in the unknowns and their true sizes.
fn mode(pencil: &Pencil, (sizes, states): (&[f64], &[usize]), Pair { s, mut x }: Pair) -> Mode {
    let most = |is_one: &dyn Fn(usize) -> bool| {
        let parts = x.iter().enumerate().filter(|(unknown, _)| is_one(*unknown));
        parts.fold(0.0, |largest: f64, (_, value)| largest.max(value.norm()))
    };
    let [of_states, of_others] = [true, false].map(|wanted| most(&|unknown| states.contains(&unknown) == wanted));
    let is_moved = of_others > UNMOVED * of_states;
    for (unknown, value) in x.iter_mut().enumerate() {
        let is_shown = is_moved || states.contains(&unknown);
        let factor = pencil.scales()[unknown] / sizes[unknown];
        *value = if is_shown { *value * factor } else { c64::default() };
    }
    pair::normalise(&mut x, &mut []);
    Mode {
        re: s.re,
        im: s.im,
        shape: mode::shape(&x, sizes),
    }
}

#[cfg(test)]
mod tests;
