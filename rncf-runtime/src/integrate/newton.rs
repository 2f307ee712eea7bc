//! Modified Newton iteration of one step of the alpha family (THEORY 7.3).
//!
//! The matrix is scaled by `beta h^2`, so that its entries stay of order one as h goes to 0, and
//! its factorization is kept across steps while the iteration contracts well.
//!
//! Orientations: the matrix is that of right increments dpi, `(b'M + g'C) T^-1 + K`, bordered by `C_x`;
//! dtheta = T^-1 dpi. This is the matrix of THEORY 7.2 with the columns divided by T, and the border
//! stays symmetric.
//!
//! The stabilised index 2 (THEORY 7.4) completes every solution by its multipliers mu, see
//! `stabiliser`.

use pulp::Arch;

use super::charts::Charts;
use super::coefficients::Factors;
use super::compensated::{self, Low};
use super::experience::Experience;
use super::lasting::Lasting;
use super::levers::Levers;
use super::noise::{self, BEARABLE};
use super::norms::{largest, norm, row};
use super::scheme::Cause;
use super::stabiliser::{Scales, Stabiliser};
use super::statistics::Statistics;
use crate::archive::{Archive, Keep};
use crate::linalg::{Pattern, Saddle, Vectorised, dispatch};
use crate::system::{State, System, Tangent};

/// Largest estimated error of a converged iterate, as a part of the error tolerance. What is left is a jump of the
/// acceleration, which weak dissipation keeps over many steps and the error estimate takes for an error of the step: with 0.05 a
/// beam that hangs on a joint took 4.6 times as many steps (T18), while a spin-up takes 2 to 17 % fewer iterations.
const CONVERGED: f64 = 0.01;
/// The same where accelerations remember those of earlier steps, and with them what was left: a thin rod on a joint took five
/// times as many steps with the above.
const CONVERGED_REMEMBERED: f64 = 5e-4;
/// The same relative to the sizes of the unknowns, at any tolerance: what is left in stiff directions is a force that
/// spoils the next prediction.
const COARSE: f64 = 1e-7;
/// The same as a part of the tolerance with constraints: what is left of them returns in the multipliers divided by h^2, and
/// weak dissipation adds it up over steps.
const CONVERGED_CONSTRAINED: f64 = 1e-4;
/// Contraction above which the matrix is refreshed within the iteration.
const POOR: f64 = 0.5;
/// Most iterations that a matrix of an earlier step may still need, by the contraction seen.
const PATIENCE: f64 = 4.0;
/// Contraction above which full Newton counts as diverging.
const DIVERGING: f64 = 0.9;
/// Contraction above which the next step starts with a new matrix.
const AGED: f64 = 0.3;
/// Most iterations of one attempt.
const ITERATIONS: u32 = 10;
/// The factorization is kept while the step is within this ratio of the one it was made for.
const SAME_STEP: f64 = 1.2;
/// Most iterations with a new matrix each, where a step cannot be shortened: something snaps through.
const PATIENT_ITERATIONS: u32 = 40;
/// Increments below this, relative to the sizes of the unknowns, are noise.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;

/// The end of a step: a predictor at first, converged in the end.
pub(super) struct Iterate {
    /// Time, position, velocity, true acceleration, multipliers.
    pub(super) state: State,
    /// What rounding took from time, position and velocity.
    pub(super) low: Low,
    /// Acceleration of the update formulas.
    pub(super) algorithmic: Vec<f64>,
    /// Ways from the origins of free poses to their centres of mass.
    pub(super) levers: Levers,
}

/// Newton's iteration with a kept factorization.
pub(super) struct Newton {
    constraint_pattern: Pattern,
    charts: Charts,
    /// Corrections of positions along `W C_x(x_n)^T`; index 3 has none.
    stabiliser: Option<Stabiliser>,
    factors: Factors,
    /// 1 / (weight of the unknown in the norm of the increments).
    inverse_weights: Vec<f64>,
    inverse_sizes: Vec<f64>,
    /// Largest estimated error of a converged iterate in the weighted norm.
    converged: f64,
    /// Largest round-off of constraints that a converged iterate may have, in the same norm.
    bearable: f64,
    /// Relative tolerance of the increments' norm.
    rtol: f64,
    saddle: Saddle<f64>,
    tangent: Tangent,
    block: Vec<f64>,
    jacobian: Vec<f64>,
    dx: Vec<f64>,
    dlambda: Vec<f64>,
    /// Step for which the matrix was factored; `None`: refresh before the next iteration.
    factored_for: Option<f64>,
    experience: Experience,
    /// What is left of motions that last.
    lasting: Lasting,
}

/// What became of an iteration.
pub(super) enum Failure {
    /// The matrix was of an earlier step: worth another go from the predictor with a new one.
    OldMatrix,
    /// Not even with a matrix of this step.
    Failed(Cause),
}

/// The failure after so many uses of the matrix; `None` if it is of an earlier step.
fn failure(uses: Option<u32>, cause: Cause) -> Failure {
    match uses {
        None => Failure::OldMatrix,
        Some(_) => Failure::Failed(cause),
    }
}

/// What an increment did.
struct Moved {
    /// Its weighted norm.
    size: f64,
    /// Size at which increments are round-off.
    floor: f64,
    /// Factor that it was multiplied by for the sake of a matrix of another step size.
    relaxation: f64,
}

/// What is known beyond the matrix, its experience and what serves one iteration.
impl Keep for Newton {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            constraint_pattern: _,
            charts: _,
            stabiliser: _,
            factors: _,
            inverse_weights: _,
            inverse_sizes: _,
            converged: _,
            bearable: _,
            rtol: _,
            saddle: _,
            tangent: _,
            block: _,
            jacobian: _,
            dx: _,
            dlambda: _,
            factored_for: _,
            experience: _,
            lasting,
        } = self;
        lasting.keep(archive);
    }
}

impl Newton {
    /// An iteration for `system`; `rtol` relative to the sizes of the unknowns is the error
    /// tolerance of a step.
    pub(super) fn new(system: &dyn System, factors: Factors, rtol: f64, stabilised: bool) -> Self {
        let (pattern, constraint_pattern) = (system.pattern(), system.constraint_pattern().clone());
        let entries = pattern.entries();
        Self {
            charts: Charts::new(system.turns(), pattern),
            stabiliser: (stabilised && system.constraints() > 0).then(|| Stabiliser::new(system)),
            factors,
            inverse_weights: system.sizes().iter().map(|size| 1.0 / (rtol * size)).collect(),
            inverse_sizes: system.sizes().iter().map(|size| 1.0 / size).collect(),
            converged: if system.constraints() == 0 {
                let most = if factors.remembers {
                    CONVERGED_REMEMBERED
                } else {
                    CONVERGED
                };
                most.min(COARSE / rtol)
            } else {
                CONVERGED_CONSTRAINED
            },
            bearable: BEARABLE,
            rtol,
            saddle: Saddle::new(pattern, system.border(), &constraint_pattern).sized(system.sizes()),
            tangent: Tangent {
                mass: vec![0.0; entries],
                stiffness: vec![0.0; entries],
                damping: vec![0.0; entries],
            },
            block: vec![0.0; entries],
            jacobian: vec![0.0; constraint_pattern.entries()],
            dx: vec![0.0; pattern.columns()],
            dlambda: vec![0.0; constraint_pattern.columns()],
            factored_for: None,
            experience: Experience::default(),
            lasting: Lasting::new(system, rtol, 0.0),
            constraint_pattern,
        }
    }

    /// As [`Newton::solve`], with a new matrix for each increment and without giving up while increments grow: for steps
    /// of fixed size in which something snaps through.
    pub(super) fn solve_patiently(
        &mut self,
        system: &mut dyn System,
        start: &State,
        h: f64,
        iterate: &mut Iterate,
        statistics: &mut Statistics,
    ) -> Result<(), Failure> {
        if let Some(stabiliser) = &mut self.stabiliser {
            stabiliser.begin(system, start);
        }
        let mut before: Option<f64> = None;
        for _ in 0..PATIENT_ITERATIONS {
            self.refresh(system, h, &iterate.state, statistics)?;
            let Moved { size, floor, .. } = self.advance(system, h, iterate, statistics).map_err(Failure::Failed)?;
            let contraction = before.map_or(1.0, |before| size / before);
            let stagnates =
                contraction > POOR && (size <= 1e3 * floor || self.is_at_noise(system, &iterate.state, size));
            let is_small = contraction < 1.0 && size * contraction / (1.0 - contraction) <= self.converged;
            if size <= floor || stagnates || is_small {
                return Ok(());
            }
            before = Some(size);
        }
        Err(self.diverged())
    }

    /// Lets round-off of constraints be as large as it is: of a fixed step nobody asks for a tolerance.
    pub(super) fn bear_noise(&mut self) {
        self.bearable = f64::INFINITY;
    }

    /// How what is left of motions that last is measured; without this it is not.
    pub(super) fn lasts(&mut self, lasting: Lasting) {
        self.lasting = lasting;
    }

    /// Makes the next iteration start with a new matrix.
    pub(super) fn discard(&mut self) {
        self.factored_for = None;
    }

    /// Iterates from the predictor in `iterate` until the step of size `h` from `start` has converged.
    pub(super) fn solve(
        &mut self,
        system: &mut dyn System,
        start: &State,
        h: f64,
        iterate: &mut Iterate,
        statistics: &mut Statistics,
    ) -> Result<(), Failure> {
        // Increments with the matrix since it was made; `None` if it is of an earlier step.
        let mut uses = None;
        if let Some(stabiliser) = &mut self.stabiliser {
            stabiliser.begin(system, start);
        }
        if !self.is_made_for(h) {
            self.refresh(system, h, &iterate.state, statistics)?;
            uses = Some(0);
        }
        let mut before: Option<f64> = None;
        let mut seen: Option<f64> = None;
        let mut is_converged = false;
        self.lasting.begin(h);
        for _ in 0..ITERATIONS {
            uses = uses.map(|uses| uses + 1);
            let Moved {
                size,
                floor,
                relaxation,
            } = self
                .advance(system, h, iterate, statistics)
                .map_err(|cause| failure(uses, cause))?;
            // Seen now, else expected from earlier steps; never better than a changed step allows.
            let contraction = match before {
                Some(before) => size / before,
                None => self.experience.expected(),
            };
            let rate = self.factors.gamma / (self.factors.beta * h * h);
            let dx = &self.dx;
            self.lasting.note(|i| rate * dx[i]);
            if before.is_some() && !is_converged {
                seen = Some(seen.map_or(contraction, |seen: f64| seen.max(contraction)));
            }
            let expected = contraction.max((relaxation - 1.0).abs());
            is_converged |= size <= floor || expected < 1.0 && size * expected / (1.0 - expected) <= self.converged;
            if is_converged {
                let is_stagnant = self.lasting.is_stagnant();
                if size <= floor || self.lasting.is_settled() || is_stagnant && uses.is_some() {
                    self.lasting.accept();
                    self.finish(seen);
                    return Ok(());
                }
                if is_stagnant {
                    return Err(Failure::OldMatrix);
                }
                before = Some(size);
                continue;
            }
            if before.is_some() && contraction > POOR {
                if size <= 1e3 * floor || self.is_at_noise(system, &iterate.state, size) {
                    return Ok(()); // stagnates at the noise of the residual
                }
                let Some(count) = uses else {
                    return Err(Failure::OldMatrix);
                };
                if (count == 1 && contraction > DIVERGING) || contraction > 2.0 {
                    return Err(self.diverged());
                }
                self.refresh(system, h, &iterate.state, statistics)?;
                uses = Some(0);
            }
            // A new matrix costs less than many more iterations with that of an earlier step.
            let missing = (self.converged / size).min(1.0).ln() / contraction.ln();
            if before.is_some() && uses.is_none() && missing > PATIENCE {
                self.refresh(system, h, &iterate.state, statistics)?;
                uses = Some(0);
            }
            before = Some(size);
        }
        match uses {
            None => Err(Failure::OldMatrix),
            Some(_) => Err(self.diverged()),
        }
    }

    /// Adds one increment to the iterate.
    fn advance(
        &mut self,
        system: &mut dyn System,
        h: f64,
        iterate: &mut Iterate,
        statistics: &mut Statistics,
    ) -> Result<Moved, Cause> {
        let relaxation = self.increment(system, h, &iterate.state, statistics);
        let size = norm(&self.dx, &self.inverse_weights) + self.shifted();
        if !size.is_finite() || !self.dlambda.iter().all(|d| d.is_finite()) {
            return Err(Cause::NotFinite);
        }
        self.apply(h, iterate);
        if let worst @ Some(_) = self.charts.overturned(&iterate.state) {
            return Err(Cause::Newton { worst });
        }
        Ok(Moved {
            size,
            floor: ROUND_OFF / self.rtol * (1.0 + norm(&iterate.state.x, &self.inverse_sizes)),
            relaxation,
        })
    }

    /// Filters a derivative `y` at `state` by the matrix of a step of size `h`: smooth parts change by
    /// O(h), the constrained part stays, stiff parts that the step does not resolve vanish.
    pub(super) fn filter(
        &mut self,
        system: &mut dyn System,
        h: f64,
        state: &State,
        y: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Failure> {
        if let Some(stabiliser) = &mut self.stabiliser {
            stabiliser.begin(system, state);
        }
        self.refresh(system, h, state, statistics)?;
        self.dx.fill(0.0);
        let mass = &mut self.tangent.mass;
        system.mass(state, mass);
        system.pattern().multiply_add(self.factors.mass, mass, y, &mut self.dx);
        self.dlambda.fill(0.0);
        self.constraint_pattern
            .transpose_multiply_add(1.0, &self.jacobian, y, &mut self.dlambda);
        self.saddle.solve(&mut self.dx, &mut self.dlambda);
        statistics.solves += 1;
        y.copy_from_slice(&self.dx);
        Ok(())
    }

    /// Whether round-off of constraints is all that is left of increments of this size.
    fn is_at_noise(&self, system: &mut dyn System, state: &State, size: f64) -> bool {
        noise::is_all_that_is_left(system, state, &self.inverse_weights, size, self.bearable)
    }

    fn is_made_for(&self, h: f64) -> bool {
        self.factored_for
            .is_some_and(|made| h <= SAME_STEP * made && made <= SAME_STEP * h)
    }

    /// Learns from a converged iteration; a matrix that contracts badly is not used again.
    fn finish(&mut self, seen: Option<f64>) {
        self.experience.note(seen);
        if seen.is_some_and(|contraction| contraction > AGED) {
            self.discard();
        }
    }

    fn diverged(&self) -> Failure {
        let worst = largest(&self.dx, &self.inverse_weights);
        Failure::Failed(Cause::Newton { worst })
    }

    /// Evaluates and factors `[[(mass M + gamma h D) T^-1 + beta h^2 K, C_x^T], [C_x, 0]]` at `state`.
    fn refresh(
        &mut self,
        system: &mut dyn System,
        h: f64,
        state: &State,
        statistics: &mut Statistics,
    ) -> Result<(), Failure> {
        let factors = [self.factors.mass, self.factors.gamma * h, self.factors.beta * h * h];
        if self.stabiliser.is_none() {
            system.iteration_matrix(state, factors, &mut self.block);
        } else {
            // The stabiliser needs the stiffness by itself.
            self.combine(system, state, factors);
        }
        statistics.jacobian_evaluations += 1;
        if !self.dlambda.is_empty() {
            system.constraint_jacobian(state, &mut self.jacobian);
        }
        self.factored_for = None;
        statistics.factorizations += 1;
        let singular = |singular| {
            Failure::Failed(Cause::Singular {
                worst: row(singular, state.x.len()),
            })
        };
        let factored = self.saddle.factor_symmetric(&self.block, &self.jacobian);
        // A value that is not finite makes a matrix singular, or solutions that are not finite.
        factored.map_err(|other| match self.block.iter().all(|value| value.is_finite()) {
            true => singular(other),
            false => Failure::Failed(Cause::NotFinite),
        })?;
        if let Some(stabiliser) = &mut self.stabiliser {
            let (tools, values) = (
                (&mut self.saddle, &self.charts),
                (&self.tangent.stiffness[..], &self.jacobian[..]),
            );
            stabiliser
                .refresh(system, state, scales(self.factors, h), tools, values, statistics)
                .map_err(singular)?;
        }
        self.factored_for = Some(h);
        self.experience = Experience::default();
        self.lasting.restart();
        Ok(())
    }

    /// The matrix of the iteration from mass, damping and stiffness, which stay.
    fn combine(&mut self, system: &mut dyn System, state: &State, [mass, damping, stiffness]: [f64; 3]) {
        let tangent = &mut self.tangent;
        system.tangent(state, tangent);
        for i in 0..self.block.len() {
            self.block[i] = mass * tangent.mass[i] + damping * tangent.damping[i];
        }
        self.charts.columns_to_increments(state, &mut self.block);
        for i in 0..self.block.len() {
            self.block[i] += stiffness * tangent.stiffness[i];
        }
    }

    /// Increments of position and multipliers at `state`; returns the factor by which the dynamic
    /// rows were relaxed because the matrix is of another step size.
    fn increment(&mut self, system: &mut dyn System, h: f64, state: &State, statistics: &mut Statistics) -> f64 {
        let lambda = &state.lambda;
        statistics.residual_evaluations += 1;
        statistics.newton_iterations += 1;
        if lambda.is_empty() {
            system.residual(state, &mut self.dx);
        } else {
            system.equations(state, &mut self.dx, &mut self.dlambda, Some(&mut self.jacobian));
            self.constraint_pattern
                .multiply_add(1.0, &self.jacobian, lambda, &mut self.dx);
            self.dlambda.iter_mut().for_each(|c| *c = -*c);
        }
        // Stiffness enters by h^2, mass by 1: the mean of the two errors is the best single factor.
        let ratio = self.factored_for.map_or(1.0, |made| h / made);
        let relaxation = 2.0 / (1.0 + ratio * ratio);
        let scale = -relaxation * self.factors.beta * h * h;
        self.dx.iter_mut().for_each(|r| *r *= scale);
        self.saddle.solve(&mut self.dx, &mut self.dlambda);
        statistics.solves += 1;
        if let Some(stabiliser) = &mut self.stabiliser {
            let (tools, solution) = (
                (&self.charts, &self.jacobian[..]),
                (&mut self.dx[..], &mut self.dlambda[..]),
            );
            stabiliser.solve(system, state, scales(self.factors, h), tools, solution);
        }
        self.charts.to_chart(state, &mut self.dx);
        relaxation
    }

    /// Weighted norm of the last correction of positions by mu.
    fn shifted(&self) -> f64 {
        self.stabiliser
            .as_ref()
            .map_or(0.0, |stabiliser| norm(stabiliser.shift(), &self.inverse_weights))
    }

    fn apply(&self, h: f64, iterate: &mut Iterate) {
        let Iterate {
            state,
            low,
            algorithmic,
            levers,
        } = iterate;
        let acceleration = 1.0 / (self.factors.beta * h * h);
        let velocity = self.factors.gamma / (self.factors.beta * h);
        let mass = self.factors.mass * acceleration;
        let changed = Changed {
            by: &self.dx,
            summed: [(&mut state.x, &mut low.x, 1.0), (&mut state.v, &mut low.v, velocity)],
            added: [(algorithmic, acceleration), (&mut state.a, mass)],
        };
        dispatch(Arch::new(), changed);
        if let Some(stabiliser) = &self.stabiliser {
            compensated::add_multiple(&mut state.x, &mut low.x, 1.0, stabiliser.shift());
        }
        for (lambda, d) in state.lambda.iter_mut().zip(&self.dlambda) {
            *lambda += acceleration * d;
        }
        levers.correct(h, state, low);
    }
}

/// Multiples of an increment that are added to what belongs to it, with the instructions of the processor.
struct Changed<'a> {
    by: &'a [f64],
    /// Values, what rounding took from them, and factors.
    summed: [(&'a mut [f64], &'a mut [f64], f64); 2],
    added: [(&'a mut [f64], f64); 2],
}

impl Vectorised for Changed<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        for (high, low, factor) in self.summed {
            compensated::add_multiple(high, low, factor, self.by);
        }
        for (values, factor) in self.added {
            for (value, change) in values.iter_mut().zip(self.by) {
                *value += factor * change;
            }
        }
    }
}

/// Scales of the rows of a step of size `h`.
fn scales(factors: Factors, h: f64) -> Scales {
    Scales {
        dynamics: factors.beta * h * h,
        velocity: factors.beta * h / factors.gamma,
    }
}
