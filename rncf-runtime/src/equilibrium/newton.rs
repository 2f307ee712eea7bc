//! Newton's iteration for equilibria with the whole matrix `[[K, C_x^T, p], [C_x, 0, 0], [p^T, 0, 0]]`:
//! K alone may be singular, and phase conditions p hold what is neutral.

use crate::linalg::{Lu, Pattern};
use crate::model::{Scene, Uniform};
use crate::system::{ConstraintLevel, State, Tangent};

/// Most iterations.
const ITERATIONS: u32 = 30;
/// Increments below this, relative to the sizes of the unknowns, are round-off.
const ROUND_OFF: f64 = 1e-14;
/// Increments below this that shrink no more are the noise of the residual.
const NOISE: f64 = 1e-7;
/// Shrinkage that noise does not reach.
const STAGNANT: f64 = 0.25;
/// Part of the stiffness times the sizes up to which forces are balanced: where lengths are far below the sizes, increments are no noise.
const BALANCED: f64 = 1e-9;
/// Increments above this, relative to the sizes of the unknowns, end a strict iteration.
const ASTRAY: f64 = 10.0;
/// Largest entry of an increment that a patient iteration takes, relative to the size of its unknown.
const STRIDE: f64 = 0.3;
/// Part of it that a step of a flow aims at.
const AIMED: f64 = 0.7;
/// Steps of a flow; the first one, times the angular velocity squared; increments at which it is Newton's turn; the smallest step,
/// likewise: what is compressed at the start lets go within such steps.
const FLOWS: u32 = 2000;
const FLOW_START: f64 = 1e-2;
const FLOWN: f64 = 1e-4;
const FLOW_LEAST: f64 = 1e-10;
/// The largest one, likewise: along what nothing ties round-off flows with it.
const FLOW_MOST: f64 = 1e8;
/// Increments of a flow at which all is still.
const STILL: f64 = 1e-8;
/// Part of the acting forces that a phase condition may carry.
const UNBALANCED: f64 = 1e-6;
/// Part of the largest load that is round-off in a sum of loads.
const ROUNDED: f64 = 1e-12;
/// Part of the stiffness times the sizes that forces are resolved to.
const RESOLVED: f64 = 1e-11;
/// The same along what was found to be untied: a force that is lost there would let a body stand that falls.
const RESOLVED_UNTIED: f64 = 1e-15;
/// Part of the largest stiffness times the sizes that is left where constraints that are open by round-off exert forces of it, on levers of it.
const RESOLVED_TWICE: f64 = 1e-28;
/// Part of the largest inertia of an unknown, times its size and the square of the spin, that is round-off of centrifugal forces which cancel.
const RESOLVED_SPUN: f64 = 1e-14;
/// Part of its first increment by which an iteration may miss it, if that is larger than this, relative to the sizes.
const MISSED: f64 = 0.25;
const FAR: f64 = 1e-3;

/// Why no equilibrium was found; rows count unknowns first, then constraints.
pub(super) enum Failure {
    Singular(usize),
    /// What has no value, where it can be named.
    NotFinite(Option<String>),
    Slow(usize),
    Unbalanced(usize),
    /// A state goes on for ever.
    Running(usize),
    /// What was found does not continue the equilibria before.
    Leapt(usize),
}

impl Failure {
    /// What happened, and the row that it happened at; `where_` says at which part of the load.
    pub fn explain(&self, where_: &str) -> (String, Option<usize>) {
        match self {
            &Failure::Singular(row) => (
                format!("the stiffness is singular {where_}: a motion is neither tied nor stiff, or the bodies buckle"),
                Some(row),
            ),
            Failure::NotFinite(Some(text)) => (format!("{where_}, {text}"), None),
            Failure::NotFinite(None) => (
                format!("a force is not finite {where_}: a parameter is unphysical"),
                None,
            ),
            &Failure::Slow(row) => (
                format!(
                    "Newton's iteration does not converge {where_}: the bodies may buckle or have no equilibrium there"
                ),
                Some(row),
            ),
            &Failure::Leapt(row) => (
                format!(
                    "no equilibrium next to those before is found {where_}: the bodies may buckle or snap through there"
                ),
                Some(row),
            ),
            &Failure::Unbalanced(row) => (
                format!(
                    "a force or moment along a motion that nothing ties is not balanced {where_}: tie that motion, or leave the force away"
                ),
                Some(row),
            ),
            &Failure::Running(row) => (
                format!(
                    "what a state is the integral of is not zero {where_}, so that it does not come to rest there: leave that state out, or look at a run"
                ),
                Some(row),
            ),
        }
    }
}

/// What the iteration makes of growing increments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Patience {
    /// It ends: where increments grow, another branch may be near.
    Strict,
    /// It goes on with shortened ones, as what bends easily beside large stiffnesses needs: these answer to what
    /// turning leaves to second order. The caller asks where it came to.
    Patient,
}

/// A motion that nothing ties.
pub(super) struct Untied {
    /// Increments of the unknowns, the largest one as large as its size.
    pub direction: Vec<f64>,
    /// What it is, in the user's words.
    pub told: String,
}

/// The iteration and its memory.
pub(super) struct Newton {
    pub(super) lu: Lu<f64>,
    /// Scales of its rows and columns; nothing where it is factored as it is.
    pub(super) scales: Vec<f64>,
    /// Places in the whole matrix of the entries of K, of `C_x^T` and of `C_x`.
    block: Vec<usize>,
    border: Vec<[usize; 2]>,
    /// Row and column of the entries of K.
    pub(super) columns: Vec<(usize, usize)>,
    /// Phase conditions, and the places in the whole matrix of their columns and rows by unknown.
    pub(super) phases: Vec<Vec<f64>>,
    phase_places: Vec<Vec<(usize, [usize; 2])>>,
    /// Motions that nothing ties where the iteration came to last: the last ones of the phase conditions.
    pub(super) untied: Vec<Vec<f64>>,
    constraint_pattern: Pattern,
    pub(super) values: Vec<f64>,
    jacobian: Vec<f64>,
    pub(super) tangent: Tangent,
    pub(super) increments: Vec<f64>,
    pub(super) inverse_sizes: Vec<f64>,
    /// Whether an unknown is a state: a number, of which no length tells how far it may go.
    pub(super) is_state: Vec<bool>,
    /// Multipliers of the phase conditions.
    held: Vec<f64>,
    /// What acts on a start that is no equilibrium, and does not count; nothing where it is empty.
    pub(super) unbalanced: Vec<f64>,
    /// Largest energy of a force over the size of its unknown, J.
    acting: f64,
    /// The first increment of x, the sum of all, and whether increments grew or were shortened.
    first: Vec<f64>,
    moved: Vec<f64>,
    wandered: bool,
}

impl Newton {
    pub fn new(scene: &dyn Scene) -> Self {
        Self::with_phases(scene, Vec::new())
    }

    fn with_phases(scene: &dyn Scene, phases: Vec<Vec<f64>>) -> Self {
        let (pattern, constraint_pattern) = (scene.pattern(), scene.constraint_pattern());
        let (n, m) = (pattern.rows(), constraint_pattern.columns());
        let [block, border] = [pattern, constraint_pattern].map(|pattern| pattern.places().collect::<Vec<_>>());
        let support = |phase: &Vec<f64>| -> Vec<usize> { (0..n).filter(|&row| phase[row] != 0.0).collect() };
        let supports: Vec<Vec<usize>> = phases.iter().map(support).collect();
        let sides = border.iter().map(|&(row, j)| (row, n + j));
        let of_phases = supports
            .iter()
            .enumerate()
            .flat_map(|(j, rows)| rows.iter().map(move |&row| (row, n + m + j)));
        let sides: Vec<(usize, usize)> = sides.chain(of_phases).collect();
        let size = n + m + phases.len();
        let mirrored = sides.iter().flat_map(|&(row, column)| [(row, column), (column, row)]);
        let whole = Pattern::new(size, size, block.iter().copied().chain(mirrored));
        let place = |row, column| whole.find(row, column).expect("the whole pattern holds its parts");
        let both = |row, column| [place(row, column), place(column, row)];
        let phase_places = supports.iter().enumerate().map(|(j, rows)| {
            let places = rows.iter().map(|&row| (row, both(row, n + m + j)));
            places.collect()
        });
        let zeros = || vec![0.0; block.len()];
        let mut is_state = vec![false; n];
        scene.states().iter().for_each(|&state| is_state[state] = true);
        Self {
            is_state,
            phase_places: phase_places.collect(),
            block: block.iter().map(|&(row, column)| place(row, column)).collect(),
            border: border.iter().map(|&(row, j)| both(row, n + j)).collect(),
            constraint_pattern: constraint_pattern.clone(),
            values: vec![0.0; whole.entries()],
            jacobian: vec![0.0; border.len()],
            tangent: Tangent {
                mass: zeros(),
                stiffness: zeros(),
                damping: zeros(),
            },
            increments: vec![0.0; size],
            columns: block,
            inverse_sizes: scene.sizes().iter().map(|size| 1.0 / size).collect(),
            held: vec![0.0; phases.len()],
            phases,
            unbalanced: Vec::new(),
            acting: 0.0,
            first: Vec::new(),
            moved: vec![0.0; n],
            wandered: false,
            untied: Vec::new(),
            lu: Lu::new(&whole),
            scales: Vec::new(),
        }
    }

    /// Holds what is neutral at the state, and what nothing ties.
    pub(super) fn hold(&mut self, scene: &mut dyn Scene, at: &Uniform, state: &State) {
        let mut phases = scene.neutral_motions(at, state);
        phases.extend(self.untied.iter().cloned());
        for phase in &mut phases {
            // In the metric of the sizes, so that a phase condition depends on no unit.
            for (value, factor) in phase.iter_mut().zip(&self.inverse_sizes) {
                *value *= factor * factor;
            }
            let largest = phase.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
            phase.iter_mut().for_each(|value| *value /= largest);
        }
        let is_zero = |phase: &Vec<f64>| -> Vec<bool> { phase.iter().map(|&value| value == 0.0).collect() };
        if phases.iter().map(is_zero).eq(self.phases.iter().map(is_zero)) {
            self.phases = phases;
        } else {
            let untied = std::mem::take(&mut self.untied);
            let unbalanced = std::mem::take(&mut self.unbalanced);
            *self = Self::with_phases(scene, phases);
            (self.untied, self.unbalanced) = (untied, unbalanced);
        }
        self.held.fill(0.0);
    }

    /// Converges `state` down to round-off; also the number of iterations. Velocities and accelerations are
    /// those of the uniform motion.
    pub fn solve(
        &mut self,
        scene: &mut dyn Scene,
        at: &Uniform,
        state: &mut State,
        patience: Patience,
    ) -> (Result<(), Failure>, u32) {
        let start = state.clone();
        let (mut result, mut iterations) = self.iterate(scene, at, state, patience);
        if result.is_err() || !self.untied.is_empty() || self.is_doubtful() {
            let more;
            (result, more) = self.hold_untied(scene, at, (&start, state), patience, result);
            iterations += more;
        }
        scene.uniform_state(at, state);
        (result.and_then(|()| self.check_phases(scene, at, state)), iterations)
    }

    /// The same where the stiffness is singular, or may be: from the start anew with what nothing ties there held, then with
    /// what nothing ties where that came to.
    fn hold_untied(
        &mut self,
        scene: &mut dyn Scene,
        at: &Uniform,
        (start, state): (&State, &mut State),
        patience: Patience,
        result: Result<(), Failure>,
    ) -> (Result<(), Failure>, u32) {
        let mut iterations = 0;
        if result.is_err() || self.untied.is_empty() {
            let untied = Self::untied(scene, at, start, false);
            if !untied.is_empty() || !self.untied.is_empty() {
                self.untied = directions(untied);
                state.clone_from(start);
                let (result, taken) = self.iterate(scene, at, state, patience);
                iterations += taken;
                // What acts along such a motion leads away from the start.
                let result = result.and_then(|()| self.check_phases(scene, at, state));
                if result.is_err() {
                    return (result, iterations);
                }
            } else if result.is_err() {
                return (result, iterations);
            }
        }
        let untied = Self::untied(scene, at, state, false);
        if untied.len() != self.untied.len() {
            // How the iteration came here is that of the one before.
            let way = (self.first.clone(), self.moved.clone(), self.wandered);
            self.untied = directions(untied);
            let (result, taken) = self.iterate(scene, at, state, patience);
            (self.first, self.moved, self.wandered) = way;
            return (result, iterations + taken);
        }
        (Ok(()), iterations)
    }

    /// Flows towards an equilibrium in a viscous medium, `M dx/ds = -R`, by implicit steps that grow until they are those of
    /// Newton's iteration; `speed` is the angular velocity, rad/s. What is stiff settles in the first step, and with it
    /// the forces that make the rest stiff.
    pub fn flow(&mut self, scene: &mut dyn Scene, at: &Uniform, state: &mut State, speed: f64) -> Result<(), Failure> {
        if speed.is_nan() || speed <= 0.0 {
            return Err(Failure::NotFinite(None));
        }
        self.untied.clear();
        state.rebase(scene.turns());
        self.hold(scene, at, state);
        let bordering = self.lu.pattern().columns() - self.inverse_sizes.len();
        let mut step = FLOW_START / (speed * speed);
        let mut last = f64::INFINITY;
        for _ in 0..FLOWS {
            self.linearize(scene, at, state);
            let right = self.increments.clone();
            loop {
                for (entry, &place) in self.block.iter().enumerate() {
                    self.values[place] = self.tangent.stiffness[entry] + self.tangent.mass[entry] / step;
                }
                self.increments.clone_from(&right);
                if !self
                    .increments
                    .iter()
                    .chain(&self.values)
                    .all(|value| value.is_finite())
                {
                    return Err(Failure::NotFinite(scene.undefined(state)));
                }
                let is_factored = self.factor().is_ok();
                // With a negative direction the step would go uphill.
                let is_uphill = self.lu.is_determinant_negative() == bordering.is_multiple_of(2);
                if is_factored && !is_uphill {
                    self.solve_increments();
                    if self.stride(Patience::Patient) == 1.0 {
                        break;
                    }
                }
                step *= 0.25;
                if step * speed * speed < FLOW_LEAST {
                    return Err(Failure::Slow(self.largest(&right)));
                }
            }
            let unknowns = state.x.iter_mut().chain(&mut state.lambda).chain(&mut self.held);
            for (value, change) in unknowns.zip(&self.increments) {
                *value += change;
            }
            state.rebase(scene.turns());
            let size = self.size();
            // What nothing ties is known only where all else is still.
            let long = step * speed * speed;
            if size <= STILL && long > 1.0 / FLOWN || size <= FLOWN && long >= 0.5 * FLOW_MOST {
                return Ok(());
            }
            // What only falls goes about as far with each step as one may go.
            step *= (AIMED * STRIDE / self.reach()).min(if size < last { 2.0 } else { 1.1 });
            step = step.min(FLOW_MOST / (speed * speed));
            last = size;
        }
        if last <= FLOWN {
            return Ok(());
        }
        Err(Failure::Slow(self.largest(&self.increments)))
    }

    /// Newton's iteration with what is held at the state; also the number of iterations.
    fn iterate(
        &mut self,
        scene: &mut dyn Scene,
        at: &Uniform,
        state: &mut State,
        patience: Patience,
    ) -> (Result<(), Failure>, u32) {
        state.rebase(scene.turns());
        self.hold(scene, at, state);
        let n = state.x.len();
        let mut last = f64::INFINITY;
        let mut taken = 0;
        self.wandered = false;
        self.moved = vec![0.0; n];
        for iteration in 1..=ITERATIONS {
            taken = iteration;
            self.linearize(scene, at, state);
            let away = most(self.increments.iter().copied(), &self.inverse_sizes);
            let all = self.increments.iter().chain(&self.values);
            if !all.copied().all(f64::is_finite) {
                return (Err(Failure::NotFinite(scene.undefined(state))), iteration);
            }
            if let Err(row) = self.factor() {
                return (Err(Failure::Singular(row)), iteration);
            }
            self.solve_increments();
            self.measure_states(scene, state);
            let size = self.size();
            if !size.is_finite() {
                return (Err(Failure::NotFinite(None)), iteration);
            }
            let part = self.stride(patience);
            self.wandered |= part < 1.0 || iteration > 2 && size > last;
            let unknowns = state.x.iter_mut().chain(&mut state.lambda).chain(&mut self.held);
            for (value, change) in unknowns.zip(&self.increments) {
                *value += part * change;
            }
            if iteration == 1 {
                self.first = self.increments[..n].to_vec();
            }
            let increments = self.moved.iter_mut().zip(&self.increments);
            increments.for_each(|(sum, change)| *sum += part * change);
            state.rebase(scene.turns());
            let is_noise = size <= NOISE && size > STAGNANT * last && away <= BALANCED * self.stiffest(|_| true);
            if size <= ROUND_OFF || is_noise {
                return (Ok(()), iteration);
            }
            // An iteration that wanders may end on another branch; a patient one is judged by where it ended.
            if patience == Patience::Strict && (size > ASTRAY || iteration > 2 && size > last) {
                break;
            }
            last = size;
        }
        let worst = self.largest(&self.increments);
        (Err(Failure::Slow(worst)), taken)
    }

    /// Matrix and right side (the negative residual, in `increments`) at `state`.
    pub(super) fn linearize(&mut self, scene: &mut dyn Scene, at: &Uniform, state: &mut State) {
        let (n, m) = (state.x.len(), state.lambda.len());
        scene.uniform_state(at, state);
        let (forces, others) = self.increments.split_at_mut(n);
        let violations = &mut others[..m];
        scene.uniform_residual(at, state, forces);
        let still = forces.iter_mut().zip(&self.unbalanced);
        still.for_each(|(force, part)| *force -= part);
        scene.small_motions(at, state, &mut self.tangent);
        self.acting = most(forces.iter().copied(), &self.inverse_sizes);
        if m > 0 {
            scene.constraint(ConstraintLevel::Position, state, violations);
            scene.constraint_jacobian(state, &mut self.jacobian);
            self.constraint_pattern
                .multiply_add(1.0, &self.jacobian, &state.lambda, forces);
        }
        others[m..].fill(0.0);
        self.values.fill(0.0);
        for (&place, &value) in self.block.iter().zip(&self.tangent.stiffness) {
            self.values[place] = value;
        }
        for (&[upper, lower], &value) in self.border.iter().zip(&self.jacobian) {
            self.values[upper] = value;
            self.values[lower] = value;
        }
        for ((phase, places), held) in self.phases.iter().zip(&self.phase_places).zip(&self.held) {
            for &(row, [upper, lower]) in places {
                self.values[upper] = phase[row];
                self.values[lower] = phase[row];
                self.increments[row] += phase[row] * held;
            }
        }
        self.increments.iter_mut().for_each(|value| *value = -*value);
    }

    /// A state is as large as it is, or becomes: its size says what errors of a run are held to.
    fn measure_states(&mut self, scene: &dyn Scene, state: &State) {
        for &unknown in scene.states() {
            let (now, next) = (state.x[unknown], state.x[unknown] + self.increments[unknown]);
            let size = scene.sizes()[unknown].max(now.abs()).max(next.abs());
            self.inverse_sizes[unknown] = 1.0 / size;
        }
    }

    /// Along a neutral motion nothing may act.
    fn check_phases(&self, scene: &mut dyn Scene, at: &Uniform, state: &State) -> Result<(), Failure> {
        if self.phases.is_empty() {
            return Ok(());
        }
        // Loads that balance each other do so but for their round-off.
        let [mut loaded, mut unloaded] = [(); 2].map(|()| vec![0.0; state.x.len()]);
        scene.uniform_residual(at, state, &mut loaded);
        scene.uniform_residual(&at.scaled(0.0), state, &mut unloaded);
        let loads = loaded.iter().zip(&unloaded).map(|(with, without)| with - without);
        let rounded = ROUNDED * most(loads, &self.inverse_sizes);
        let known = self.phases.len() - self.untied.len();
        let twice = RESOLVED_TWICE * self.stiffest(|_| true);
        let spun = RESOLVED_SPUN * scene.spin_in(at).powi(2) * self.heaviest();
        for (place, (phase, held)) in self.phases.iter().zip(&self.held).enumerate() {
            let energy = |row: usize| (held * phase[row] / self.inverse_sizes[row]).abs();
            let rows = 0..phase.len();
            let worst = rows.max_by(|&i, &j| energy(i).total_cmp(&energy(j))).unwrap_or(0);
            let resolved = if place < known { RESOLVED } else { RESOLVED_UNTIED };
            let stiff = resolved * self.stiffest(|row| phase[row] != 0.0);
            if energy(worst) > UNBALANCED * self.acting + rounded + stiff + twice + spun {
                if !self.is_state[worst] {
                    return Err(Failure::Unbalanced(worst));
                }
                // What keeps books of a machine may go on for ever.
                if scene.is_read(worst) {
                    return Err(Failure::Running(worst));
                }
            }
        }
        Ok(())
    }

    /// Part of the increment that is taken.
    fn stride(&self, patience: Patience) -> f64 {
        if patience == Patience::Strict {
            return 1.0;
        }
        (STRIDE / self.reach()).min(1.0)
    }

    /// Largest entry of an increment of what moves, relative to the size of its unknown.
    fn reach(&self) -> f64 {
        let parts = self.increments.iter().zip(&self.inverse_sizes).zip(&self.is_state);
        let moving = parts.filter(|(_, is_state)| !**is_state);
        moving.fold(0.0, |largest: f64, ((change, inverse), _)| {
            largest.max((change * inverse).abs())
        })
    }

    /// Whether the last solution held motions that nothing ties.
    pub fn holds_untied(&self) -> bool {
        !self.untied.is_empty()
    }

    /// Unknown that moved most in the last iteration.
    pub fn farthest(&self) -> usize {
        self.largest(&self.moved)
    }

    /// Unknown with the largest change relative to its size.
    fn largest(&self, changes: &[f64]) -> usize {
        let weighted = |i: usize| (changes[i] * self.inverse_sizes[i]).abs();
        let rows = 0..self.inverse_sizes.len();
        rows.max_by(|&i, &j| weighted(i).total_cmp(&weighted(j))).unwrap_or(0)
    }

    /// Whether increments grew or were shortened in the last iteration: it may have leapt to another branch.
    pub fn has_wandered(&self) -> bool {
        self.wandered
    }

    /// Whether the last iteration ended against the direction of its first increment, which therefore was not
    /// towards it.
    pub fn has_turned_back(&self) -> bool {
        let parts = self.first.iter().zip(&self.moved).zip(&self.inverse_sizes);
        parts
            .map(|((first, moved), inverse)| first * moved * inverse * inverse)
            .sum::<f64>()
            < 0.0
    }

    /// Whether the last iteration ended far from where its first increment pointed: limit points may lie between.
    pub fn has_strayed(&self) -> bool {
        let missed = self.moved.iter().zip(&self.first).map(|(moved, first)| moved - first);
        let first = self.mean(self.first.iter().copied());
        first > FAR && self.mean(missed) > MISSED * first
    }

    /// Whether the last iteration moved the unknowns by a visible part of their sizes.
    pub fn has_moved_far(&self) -> bool {
        self.mean(self.moved.iter().copied()) > FAR
    }

    /// Angular velocity, rad/s, at whose inertia forces what acts on the state would be: the pace of a flow where nothing turns.
    pub fn pace(&mut self, scene: &mut dyn Scene, at: &Uniform, state: &State) -> f64 {
        let mut state = state.clone();
        state.rebase(scene.turns());
        self.hold(scene, at, &state);
        self.linearize(scene, at, &mut state);
        let forces = self.increments.iter().zip(&self.inverse_sizes);
        let acting: f64 = forces.map(|(force, inverse)| (force / inverse).abs()).sum();
        let diagonal = self.columns.iter().zip(&self.tangent.mass);
        let inert: f64 = diagonal
            .filter(|((row, column), _)| row == column)
            .map(|(&(row, _), mass)| mass / self.inverse_sizes[row].powi(2))
            .sum();
        (acting / inert).sqrt()
    }

    /// Root mean square of the increments of `x`, relative to the sizes of the unknowns.
    fn size(&self) -> f64 {
        self.mean(self.increments.iter().copied())
    }

    /// Root mean square of changes of `x`, relative to the sizes of the unknowns.
    fn mean(&self, changes: impl Iterator<Item = f64>) -> f64 {
        let parts = changes.zip(&self.inverse_sizes);
        let sum: f64 = parts.map(|(change, factor)| (change * factor).powi(2)).sum();
        (sum / self.inverse_sizes.len().max(1) as f64).sqrt()
    }
}

/// Largest of some forces times the sizes of their unknowns, J.
fn most(forces: impl Iterator<Item = f64>, inverse_sizes: &[f64]) -> f64 {
    let forces = forces.zip(inverse_sizes);
    forces.fold(0.0, |largest: f64, (force, inverse)| {
        largest.max((force / inverse).abs())
    })
}

fn directions(untied: Vec<Untied>) -> Vec<Vec<f64>> {
    untied.into_iter().map(|motion| motion.direction).collect()
}
