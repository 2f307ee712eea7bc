//! Relative equilibrium at constant spin (THEORY 8.1): `f(x) + C_x^T lambda = 0, C(x) = 0` in the
//! turning frames, by continuation from the bodies at rest.

use crate::error::{SolveError, SolveErrorKind};
use crate::linalg::{Lu, Pattern};
use crate::model::Scene;
use crate::system::{ConstraintLevel, State, Tangent};

/// Most Newton iterations of one continuation step.
const ITERATIONS: u32 = 30;
/// Increments below this, relative to the sizes of the unknowns, are round-off.
const ROUND_OFF: f64 = 1e-14;
/// Increments below this that shrink no more are the noise of the residual.
const NOISE: f64 = 1e-7;
/// Shrinkage that noise does not reach.
const STAGNANT: f64 = 0.25;
/// Increments above this, relative to the sizes of the unknowns, lead astray.
const ASTRAY: f64 = 10.0;
/// Smallest increment of the scale.
const SMALLEST: f64 = 1.0 / 65536.0;

/// A relative equilibrium and the way to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// The continuation steps in their order, the last one at scale 1.
    pub path: Vec<Continued>,
    /// Newton iterations of attempts that failed and were repeated with a smaller increment.
    pub wasted_iterations: u32,
}

/// One continuation step.
#[derive(Clone, Debug, PartialEq)]
pub struct Continued {
    /// Part of the angular velocity, 0 to 1.
    pub scale: f64,
    /// Equilibrium at that scale: positions and multipliers; velocities and accelerations zero.
    pub state: State,
    /// Newton iterations that it took.
    pub iterations: u32,
}

impl Equilibrium {
    /// The equilibrium at the full angular velocity.
    pub fn state(&self) -> Option<&State> {
        self.path.last().map(|step| &step.state)
    }

    /// Newton iterations of all attempts.
    pub fn iterations(&self) -> u32 {
        self.wasted_iterations + self.path.iter().map(|step| step.iterations).sum::<u32>()
    }
}

/// Relative equilibrium of `scene` with the spin, loads and constraints of time `t` (s).
///
/// # Errors
/// [`SolveErrorKind::NoEquilibrium`] if the unknowns are not those of the turning frames, if a load
/// or frame is not invariant under the rotation, or if no equilibrium continues the one at rest.
pub fn steady<S: Scene + ?Sized>(scene: &mut S, t: f64) -> Result<Equilibrium, SolveError> {
    follow(scene, t, 1.0, |_, _| ())
}

/// As [`steady`], with increments of the scale of at most `largest`; `visit` sees every step when it
/// is found, so that the way is known up to where it ends.
///
/// # Errors
/// As [`steady`].
pub fn follow<S: Scene + ?Sized>(
    scene: &mut S,
    t: f64,
    largest: f64,
    mut visit: impl FnMut(&mut S, &Continued),
) -> Result<Equilibrium, SolveError> {
    let fail = |text: String, worst| SolveError {
        kind: SolveErrorKind::NoEquilibrium(text),
        t,
        h: 0.0,
        worst,
    };
    if !scene.is_referenced() {
        let text = "the unknowns do not turn with the bodies; take the formulation rncf";
        return Err(fail(text.into(), None));
    }
    if let Some(obstacle) = scene.steady_obstacle(t) {
        return Err(fail(obstacle, None));
    }
    let mut newton = Newton::new(scene);
    let mut last = scene.rest(t);
    let (mut scale, mut increment) = (0.0, largest.clamp(SMALLEST, 1.0));
    let mut found = Equilibrium {
        path: vec![],
        wasted_iterations: 0,
    };
    while scale < 1.0 {
        let target = (scale + increment).min(1.0);
        let mut state = last.clone();
        let (result, iterations) = newton.solve(scene, target, &mut state);
        match result {
            Ok(()) => {
                scale = target;
                increment = (2.0 * increment).min(largest.clamp(SMALLEST, 1.0));
                last.clone_from(&state);
                let step = Continued {
                    scale,
                    state,
                    iterations,
                };
                visit(scene, &step);
                found.path.push(step);
            }
            Err(failure) => {
                found.wasted_iterations += iterations;
                increment = 0.5 * (target - scale);
                if increment < SMALLEST {
                    let (text, row) = failure.explain(scale);
                    return Err(fail(text, row.map(|row| describe(scene, row))));
                }
            }
        }
    }
    Ok(found)
}

fn describe<S: Scene + ?Sized>(scene: &S, row: usize) -> String {
    let n = scene.unknowns();
    if row < n {
        scene.describe_unknown(row)
    } else {
        scene.describe_constraint(row - n)
    }
}

/// Why a continuation step failed; rows count unknowns first, then constraints.
enum Failure {
    Singular(usize),
    NotFinite,
    Slow(usize),
}

impl Failure {
    fn explain(&self, scale: f64) -> (String, Option<usize>) {
        let beyond = format!("beyond {scale} of the angular velocity");
        match *self {
            Failure::Singular(row) => (
                format!("the stiffness is singular {beyond}: a motion is neither tied nor stiff, or the bodies buckle"),
                Some(row),
            ),
            Failure::NotFinite => (
                format!("a force is not finite {beyond}: a parameter is unphysical"),
                None,
            ),
            Failure::Slow(row) => (
                format!("Newton's iteration does not converge {beyond}: the bodies may have no equilibrium there"),
                Some(row),
            ),
        }
    }
}

/// Newton's iteration with the whole matrix `[[K, C_x^T], [C_x, 0]]`: K alone may be singular.
struct Newton {
    lu: Lu<f64>,
    /// Places in the whole matrix of the entries of K, of `C_x^T` and of `C_x`.
    block: Vec<usize>,
    border: Vec<[usize; 2]>,
    constraint_pattern: Pattern,
    values: Vec<f64>,
    stiffness: Vec<f64>,
    jacobian: Vec<f64>,
    tangent: Tangent,
    increments: Vec<f64>,
    inverse_sizes: Vec<f64>,
}

impl Newton {
    fn new<S: Scene + ?Sized>(scene: &S) -> Self {
        let (pattern, constraint_pattern) = (scene.pattern(), scene.constraint_pattern());
        let (n, m) = (pattern.rows(), constraint_pattern.columns());
        let (block, border) = (entries(pattern), entries(constraint_pattern));
        let whole = Pattern::new(
            n + m,
            n + m,
            block
                .iter()
                .copied()
                .chain(border.iter().flat_map(|&(row, j)| [(row, n + j), (n + j, row)])),
        );
        let place = |row, column| whole.find(row, column).expect("the whole pattern holds its parts");
        Self {
            lu: Lu::new(&whole),
            block: block.iter().map(|&(row, column)| place(row, column)).collect(),
            border: border
                .iter()
                .map(|&(row, j)| [place(row, n + j), place(n + j, row)])
                .collect(),
            constraint_pattern: constraint_pattern.clone(),
            values: vec![0.0; whole.entries()],
            stiffness: vec![0.0; block.len()],
            jacobian: vec![0.0; border.len()],
            tangent: Tangent {
                mass: vec![0.0; block.len()],
                stiffness: vec![0.0; block.len()],
                damping: vec![0.0; block.len()],
            },
            increments: vec![0.0; n + m],
            inverse_sizes: scene.sizes().iter().map(|size| 1.0 / size).collect(),
        }
    }

    /// Converges `state` at the given scale down to round-off; also the number of iterations.
    fn solve<S: Scene + ?Sized>(&mut self, scene: &mut S, scale: f64, state: &mut State) -> (Result<(), Failure>, u32) {
        let n = state.x.len();
        let mut last = f64::INFINITY;
        let mut taken = 0;
        for iteration in 1..=ITERATIONS {
            taken = iteration;
            self.linearize(scene, scale, state);
            if !self
                .increments
                .iter()
                .chain(&self.values)
                .all(|value| value.is_finite())
            {
                return (Err(Failure::NotFinite), iteration);
            }
            if let Err(row) = self.lu.factor(&self.values) {
                return (Err(Failure::Singular(row)), iteration);
            }
            self.lu.solve(&mut self.increments);
            let size = self.size();
            if !size.is_finite() {
                return (Err(Failure::NotFinite), iteration);
            }
            for (value, change) in state.x.iter_mut().chain(&mut state.lambda).zip(&self.increments) {
                *value += change;
            }
            if size <= ROUND_OFF || size <= NOISE && size > STAGNANT * last {
                return (Ok(()), iteration);
            }
            // An iteration that wanders may end on another branch.
            if size > ASTRAY || iteration > 2 && size > last {
                break;
            }
            last = size;
        }
        let weighted = |i: usize| (self.increments[i] * self.inverse_sizes[i]).abs();
        let worst = (0..n).max_by(|&i, &j| weighted(i).total_cmp(&weighted(j))).unwrap_or(0);
        (Err(Failure::Slow(worst)), taken)
    }

    /// Matrix and right side (the negative residual, in `increments`) at `state`.
    fn linearize<S: Scene + ?Sized>(&mut self, scene: &mut S, scale: f64, state: &State) {
        let (n, m) = (state.x.len(), state.lambda.len());
        let (forces, violations) = self.increments.split_at_mut(n);
        scene.steady_residual(state.t, scale, &state.x, forces);
        scene.steady_tangent(state.t, scale, &state.x, &mut self.stiffness);
        if m > 0 {
            scene.constraint(ConstraintLevel::Position, state, violations);
            scene.constraint_jacobian(state, &mut self.jacobian);
            self.constraint_pattern
                .multiply_add(1.0, &self.jacobian, &state.lambda, forces);
            self.add_constraint_stiffness(scene, state);
        }
        self.increments.iter_mut().for_each(|value| *value = -*value);
        self.values.fill(0.0);
        for (&place, &value) in self.block.iter().zip(&self.stiffness) {
            self.values[place] = value;
        }
        for (&[upper, lower], &value) in self.border.iter().zip(&self.jacobian) {
            self.values[upper] = value;
            self.values[lower] = value;
        }
    }

    /// Adds d(C_x^T lambda)/dx: the part of the system's stiffness that multipliers make.
    fn add_constraint_stiffness<S: Scene + ?Sized>(&mut self, scene: &mut S, state: &State) {
        scene.tangent(state, &mut self.tangent);
        for (sum, value) in self.stiffness.iter_mut().zip(&self.tangent.stiffness) {
            *sum += value;
        }
        let mut unloaded = state.clone();
        unloaded.lambda.fill(0.0);
        scene.tangent(&unloaded, &mut self.tangent);
        for (sum, value) in self.stiffness.iter_mut().zip(&self.tangent.stiffness) {
            *sum -= value;
        }
    }

    /// Root mean square of the increments of `x`, relative to the sizes of the unknowns.
    fn size(&self) -> f64 {
        let parts = self.increments.iter().zip(&self.inverse_sizes);
        let sum: f64 = parts.map(|(change, factor)| (change * factor).powi(2)).sum();
        (sum / self.inverse_sizes.len().max(1) as f64).sqrt()
    }
}

/// Row and column of every entry, in the order of the values.
fn entries(pattern: &Pattern) -> Vec<(usize, usize)> {
    (0..pattern.columns())
        .flat_map(|column| {
            pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
                .iter()
                .map(move |&row| (row, column))
        })
        .collect()
}

#[cfg(test)]
#[path = "equilibrium_tests.rs"]
mod tests;
