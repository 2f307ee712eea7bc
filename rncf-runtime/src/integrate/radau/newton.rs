//! Simplified Newton iteration on the stage increments (THEORY 7.3), as in RADAU5.

use super::coefficients::Coefficients;
use super::matrices::Matrices;
use super::stages::{Stages, combined, slices};
use crate::archive::{Archive, Keep};
use crate::integrate::anderson::Acceleration;
use crate::integrate::bordered::add;
use crate::integrate::lasting::Lasting;
use crate::integrate::noise::{self, BEARABLE};
use crate::integrate::norms::norm;
use crate::integrate::statistics::Statistics;
use crate::system::{ConstraintLevel, State, System};

/// Most iterations of a step whose size is free, with three stages and for each more.
const ITERATIONS: u32 = 10;
const MORE: u32 = 2;
/// Most iterations of a fixed step: a slow iteration is all there is.
const PATIENT: u32 = 50;
/// Contraction at which the iteration is given up.
const DIVERGING: f64 = 0.99;
/// Contraction above which an iteration near round-off counts as at its end.
const STAGNANT: f64 = 0.3;
/// Ratio of successive increments above which they are accelerated.
const ACCELERATED: f64 = 0.05;
/// Iterations after which acceleration should show.
const LEARNING: u32 = 5;
/// Ratio of successive increments, accelerated, at which the iteration is given up.
const HOPELESS: f64 = 30.0;
/// Smallest amplification that is expected of a step before its contraction is seen.
const LEAST: f64 = 0.008;
/// Iterations beyond those of the positions that a tangent is kept for.
const FEW: u32 = 1;
/// Increments below this, relative to the sizes of the unknowns, are noise.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;
/// Increments near it that do not fall are noise whatever lasts.
const CERTAIN: f64 = 32.0;
/// Increments that are noise may exceed those that rounding makes by.
const MARGIN: f64 = 30.0;
/// Ratio of successive increments above which they do not fall.
const FALLING: f64 = 0.5;
/// Noise that the residual may add to that.
const AMPLIFIED: f64 = 1e3;

/// Why an iteration did not converge.
pub(super) enum Failure {
    /// It contracts too slowly, or leaves the chart; the row of the largest increment, and the ratio by which a shorter
    /// step would converge, where it can be told.
    Slow { worst: Option<usize>, ratio: f64 },
    /// A value is not finite.
    NotFinite,
}

/// What a converged iteration tells of its matrix.
#[derive(Clone, Copy)]
pub(super) struct Converged {
    /// Iterations until the positions were converged.
    pub(super) iterations: u32,
    /// Contraction till then; 0 after a single iteration.
    pub(super) contraction: f64,
    /// What lasts took many more iterations.
    pub(super) is_slow: bool,
}

/// Memory and settings of the iteration.
pub(super) struct Newton<const S: usize> {
    inverse_weights: Vec<f64>,
    inverse_sizes: Vec<f64>,
    /// Error of a converged iterate as a part of the weights.
    tolerance: f64,
    /// What is left of motions that last.
    lasting: Lasting,
    /// The step is fixed.
    patient: bool,
    /// Relative tolerance behind the weights.
    rtol: f64,
    /// theta / (1 - theta) of the last step, and its size.
    amplification: f64,
    seen_at: f64,
    dynamics: [Vec<f64>; S],
    constraints: [Vec<f64>; S],
    /// Right sides of the constraints' rates; empty with index 3.
    rates: [Vec<f64>; S],
    /// `C_x^T` of the stages, and one of them in the chart.
    jacobians: [Vec<f64>; S],
    jacobian: Vec<f64>,
    /// Change of a stage's drift.
    drift: Vec<f64>,
    stage: State,
    acceleration: Acceleration,
    /// Changes of an iteration in one piece: of increments of position, of multipliers.
    increment: Vec<f64>,
}

/// What is known beyond one iteration.
impl<const S: usize> Keep for Newton<S> {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            inverse_weights: _,
            inverse_sizes: _,
            tolerance: _,
            lasting,
            patient: _,
            rtol: _,
            amplification,
            seen_at,
            dynamics: _,
            constraints: _,
            rates: _,
            jacobians: _,
            jacobian: _,
            drift: _,
            stage: _,
            acceleration: _,
            increment: _,
        } = self;
        lasting.keep(archive);
        amplification.keep(archive);
        seen_at.keep(archive);
    }
}

impl<const S: usize> Newton<S> {
    pub(super) fn new(
        system: &dyn System,
        matrices: &Matrices<S>,
        (rtol, tolerance): (f64, f64),
        lasting: Lasting,
        patient: bool,
        stabilised: bool,
    ) -> Self {
        let (n, m) = (system.unknowns(), system.constraints());
        let rates = if stabilised { m } else { 0 };
        Self {
            inverse_weights: system.sizes().iter().map(|size| 1.0 / (rtol * size)).collect(),
            inverse_sizes: system.sizes().iter().map(|size| 1.0 / size).collect(),
            tolerance,
            lasting,
            patient,
            rtol,
            amplification: 1.0,
            seen_at: 0.0,
            dynamics: std::array::from_fn(|_| vec![0.0; n]),
            constraints: std::array::from_fn(|_| vec![0.0; m]),
            rates: std::array::from_fn(|_| vec![0.0; rates]),
            jacobians: std::array::from_fn(|_| vec![0.0; matrices.constraint_pattern.entries()]),
            jacobian: vec![0.0; matrices.chart.constraints.entries()],
            drift: vec![0.0; if stabilised { n } else { 0 }],
            stage: State::of(system, 0.0),
            acceleration: Acceleration::new(
                S * (n + m + rates),
                system.sizes().repeat(S).iter().map(|size| 1.0 / size).collect(),
            ),
            increment: Vec::with_capacity(S * (n + m + rates)),
        }
    }

    /// Forgets the contraction that was seen.
    pub(super) fn restart(&mut self) {
        self.amplification = 1.0;
        self.lasting.restart();
    }

    /// Converges the increments and multipliers of `stages`, whose predictions are given; its
    /// velocities and accelerations follow. `start` comes with whether the tangent is of this step.
    pub(super) fn solve(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &mut Matrices<S>,
        (start, is_fresh): (&State, bool),
        stages: &mut Stages<S>,
        statistics: &mut Statistics,
    ) -> Result<Converged, Failure> {
        let floor = ROUND_OFF / self.rtol * (1.0 + norm(&start.x, &self.inverse_sizes));
        // The estimate of the last step, made cautious; contraction is of second order in the step.
        let growth = (stages.h / self.seen_at).clamp(1.0, 1e3);
        let mut amplification = self.amplification.max(LEAST).powf(0.8) * growth.powi(2);
        let (mut last, mut last_ratio, mut contraction) = (0.0, 0.0, 0.0);
        let mut rounding = None;
        // Set when the positions are converged.
        let mut converged = None;
        self.acceleration.restart();
        self.lasting.begin(stages.h);
        let free = ITERATIONS + MORE * (S as u32 - 3);
        let most = if self.patient { PATIENT } else { free };
        for iteration in 1..=most {
            self.differentiate(system, coefficients, matrices, start, stages);
            self.residual(system, coefficients, matrices, start, stages, statistics);
            let sides = [&mut self.dynamics, &mut self.constraints, &mut self.rates];
            matrices.solve_stages(coefficients, stages.h, sides, statistics);
            statistics.newton_iterations += 1;
            let size = self.size(matrices, stages.h);
            if !size.is_finite() {
                return Err(Failure::NotFinite);
            }
            if iteration > 1 {
                let ratio: f64 = size / last;
                contraction = if iteration == 2 {
                    ratio
                } else {
                    (ratio * last_ratio).sqrt()
                };
                last_ratio = ratio;
                amplification = contraction / (1.0 - contraction);
            }
            let (row, rate) = (&coefficients.inverse[S - 1], 1.0 / (stages.h * stages.h));
            let changes = slices(&self.dynamics, start.x.len());
            self.lasting.note(|i| combined(row, &changes, i) * rate);
            self.apply(stages, iteration > 1 && last_ratio > ACCELERATED);
            let stagnates = contraction > STAGNANT;
            let mut is_noise = |newton: &mut Self, system: &mut dyn System, stages: &mut Stages<S>| {
                let is_small = size <= AMPLIFIED * floor;
                // A fixed step is iterated down to round-off, and has no shorter one to go back to.
                newton.patient && is_small
                    || newton.is_of_constraints(system, start, size)
                    || is_small && {
                        // Slow contraction looks like noise: what rounding makes of the equations is measured, once in a step.
                        let rounding = rounding.get_or_insert_with(|| {
                            newton.rounding(system, coefficients, matrices, start, stages, statistics)
                        });
                        newton.is_within(rounding)
                    }
            };
            let at_noise = size <= floor || stagnates && is_noise(self, system, stages);
            if converged.is_none() && (at_noise || contraction < DIVERGING && amplification * size <= self.tolerance) {
                self.seen_at = stages.h;
                self.amplification = if contraction < DIVERGING { amplification } else { 1.0 };
                converged = Some(Converged {
                    iterations: iteration,
                    contraction,
                    is_slow: false,
                });
            }
            if let Some(converged) = converged {
                // What does not fall any more is noise near round-off alone: elsewhere the iteration contracts slowly.
                let (is_stagnant, is_last) = (self.lasting.is_stagnant(), iteration == most);
                let is_low = (self.patient || last_ratio > FALLING) && size <= CERTAIN * floor;
                let is_accepted = self.lasting.is_settled()
                    || is_stagnant && is_fresh && self.patient && is_last
                    || (is_stagnant && is_fresh
                        || at_noise
                            && (is_stagnant || is_last || is_low || self.is_of_constraints(system, start, size)))
                        && is_noise(self, system, stages);
                if is_accepted {
                    self.lasting.accept();
                    self.complete(system, coefficients, matrices, start, stages)?;
                    let is_slow = iteration > converged.iterations + FEW;
                    return Ok(Converged { is_slow, ..converged });
                }
                if is_stagnant && !(is_fresh && self.patient) {
                    return Err(self.slow(0.5));
                }
            } else if iteration > 1 {
                let left = (most - 1).saturating_sub(iteration) as i32;
                if last_ratio >= HOPELESS || iteration > LEARNING && contraction >= DIVERGING {
                    return Err(self.slow(0.5));
                }
                let expected = amplification * size * contraction.powi(left) / self.tolerance;
                if iteration > LEARNING && expected >= 1.0 && AMPLIFIED * floor < size * contraction.powi(left) {
                    let excess = expected.clamp(1e-4, 20.0);
                    return Err(self.slow(0.8 * excess.powf(-1.0 / (4.0 + f64::from(left)))));
                }
            }
            last = size.max(f64::MIN_POSITIVE);
        }
        Err(self.slow(0.5))
    }

    /// Rates and their derivatives of the converged stages, which must not have left the chart.
    fn complete(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &Matrices<S>,
        start: &State,
        stages: &mut Stages<S>,
    ) -> Result<(), Failure> {
        if !self.rates[0].is_empty() {
            self.differentiate(system, coefficients, matrices, start, stages);
        }
        stages.differentiate(coefficients, start);
        match matrices.chart.left_by(&stages.z[S - 1]) {
            None => Ok(()),
            Some(turn) => Err(Failure::Slow {
                worst: Some(turn),
                ratio: 0.5,
            }),
        }
    }

    /// `C_x^T` at all stages, then drift, rates and their derivatives.
    fn differentiate(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &Matrices<S>,
        start: &State,
        stages: &mut Stages<S>,
    ) {
        let chart = &matrices.chart;
        for s in 0..S {
            if stages.lambda[s].is_empty() {
                break;
            }
            stages.place(coefficients, s, start, &mut self.stage);
            system.constraint_jacobian(&self.stage, &mut self.jacobians[s]);
            if !stages.mu[s].is_empty() {
                chart.jacobian(&self.stage.x, &self.jacobians[s], &mut self.jacobian);
                stages.drift[s].fill(0.0);
                chart
                    .constraints
                    .multiply_add(1.0, &self.jacobian, &stages.mu[s], &mut stages.drift[s]);
            }
        }
        stages.differentiate(coefficients, start);
    }

    /// Right sides `-R` and `-C`, and `-dC/dt` with the stabilised index 2, of all stages.
    fn residual(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &Matrices<S>,
        start: &State,
        stages: &Stages<S>,
        statistics: &mut Statistics,
    ) {
        let pattern = &matrices.constraint_pattern;
        for s in 0..S {
            let (state, out, values) = (&mut self.stage, &mut self.dynamics[s], &self.jacobians[s]);
            stages.stage(coefficients, &matrices.chart, s, start, state);
            if state.lambda.is_empty() {
                system.residual(state, out);
            } else {
                system.equations(state, out, &mut self.constraints[s], None);
                pattern.multiply_add(1.0, values, &state.lambda, out);
            }
            let rates = &mut self.rates[s];
            if !rates.is_empty() {
                system.constraint(ConstraintLevel::Velocity, state, rates);
                pattern.transpose_multiply_add(1.0, values, &state.v, rates);
            }
            for sides in [out, &mut self.constraints[s], rates] {
                sides.iter_mut().for_each(|value| *value = -*value);
            }
        }
        statistics.residual_evaluations += S as u64;
    }

    /// Weighted size of the increments, h times the change of drift like one of position.
    fn size(&mut self, matrices: &Matrices<S>, h: f64) -> f64 {
        let mut sum = 0.0;
        for s in 0..S {
            sum += norm(&self.dynamics[s], &self.inverse_weights).powi(2) / S as f64;
            if !self.rates[s].is_empty() {
                self.drift.fill(0.0);
                let (pattern, slopes) = (&matrices.chart.constraints, &matrices.slopes.jacobian);
                pattern.multiply_add(h, slopes, &self.rates[s], &mut self.drift);
                sum += norm(&self.drift, &self.inverse_weights).powi(2) / S as f64;
            }
            // Multipliers carry no weight, but must be finite.
            sum += self.constraints[s].iter().map(|change| 0.0 * change).sum::<f64>();
        }
        sum.sqrt()
    }

    /// Adds the increments, accelerated or as they are.
    fn apply(&mut self, stages: &mut Stages<S>, accelerated: bool) {
        if self.patient {
            // Iterated down to round-off, where differences tell nothing.
            for (values, changes) in [
                (&mut stages.w, &self.dynamics),
                (&mut stages.lambda, &self.constraints),
                (&mut stages.mu, &self.rates),
            ] {
                for (values, changes) in values.iter_mut().zip(changes) {
                    add(values, changes);
                }
            }
            return;
        }
        self.increment.clear();
        for changes in [&self.dynamics, &self.constraints, &self.rates] {
            for changes in changes {
                self.increment.extend_from_slice(changes);
            }
        }
        self.acceleration.follow(&mut self.increment, accelerated);
        let mut changes = self.increment.as_slice();
        for values in [&mut stages.w, &mut stages.lambda, &mut stages.mu] {
            for values in values {
                let (these, others) = changes.split_at(values.len());
                add(values, these);
                changes = others;
            }
        }
    }

    /// Whether round-off of constraints is all that is left of increments of this size; where the step is fixed nobody asks for
    /// a tolerance.
    fn is_of_constraints(&self, system: &mut dyn System, start: &State, size: f64) -> bool {
        let bearable = if self.patient { f64::INFINITY } else { BEARABLE };
        noise::is_all_that_is_left(system, start, &self.inverse_weights, size, bearable)
    }

    /// What rounding makes of the increments of each unknown: those that follow from places and increments that are rounded
    /// otherwise, up and down in turns.
    fn rounding(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &mut Matrices<S>,
        start: &State,
        stages: &mut Stages<S>,
        statistics: &mut Statistics,
    ) -> Vec<f64> {
        let last = self.sides();
        self.differentiate(system, coefficients, matrices, start, stages);
        self.residual(system, coefficients, matrices, start, stages, statistics);
        let here = self.sides();
        let ulp = |turn: usize, value: f64| [1.0, -1.0][turn % 2] * f64::EPSILON * value.abs();
        let mut rounded = start.clone();
        for (index, x) in rounded.x.iter_mut().enumerate() {
            *x += ulp(index, x.abs() + 1.0 / self.inverse_sizes[index]);
        }
        let given = stages.w.clone();
        for (stage, (w, z)) in stages.w.iter_mut().zip(&stages.z).enumerate() {
            for (index, (w, z)) in w.iter_mut().zip(z).enumerate() {
                *w += ulp(index + stage, *z);
            }
        }
        stages.differentiate(coefficients, start);
        self.residual(system, coefficients, matrices, &rounded, stages, statistics);
        stages.w = given;
        for (sides, here) in self.all_sides().zip(here) {
            sides.iter_mut().zip(here).for_each(|(side, here)| *side -= here);
        }
        let sides = [&mut self.dynamics, &mut self.constraints, &mut self.rates];
        matrices.solve_stages(coefficients, stages.h, sides, statistics);
        let changes = slices(&self.dynamics, start.x.len());
        let largest = |index: usize| {
            let changes = (0..S).map(|s| changes[s][index].abs() + f64::EPSILON * stages.z[s][index].abs());
            changes.fold(0.0, f64::max)
        };
        let rounding = (0..start.x.len()).map(largest).collect();
        for (sides, last) in self.all_sides().zip(last) {
            *sides = last;
        }
        rounding
    }

    /// Whether no increment exceeds what rounding makes by much.
    fn is_within(&self, rounding: &[f64]) -> bool {
        let is_within = |changes: &Vec<f64>| {
            let mut pairs = changes.iter().zip(rounding);
            pairs.all(|(change, rounding)| change.abs() <= MARGIN * rounding)
        };
        self.dynamics.iter().all(is_within)
    }

    /// What stands for right sides, and for increments once they are solved for: of all stages, one kind after the other.
    fn all_sides(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        let Self {
            dynamics,
            constraints,
            rates,
            ..
        } = self;
        dynamics.iter_mut().chain(constraints).chain(rates)
    }

    fn sides(&mut self) -> Vec<Vec<f64>> {
        self.all_sides().map(|sides| sides.clone()).collect()
    }

    fn slow(&self, ratio: f64) -> Failure {
        let size = |&i: &usize| -> f64 {
            (0..S)
                .map(|s| (self.dynamics[s][i] * self.inverse_sizes[i]).abs())
                .sum()
        };
        let worst = (0..self.inverse_sizes.len()).max_by(|i, j| size(i).total_cmp(&size(j)));
        Failure::Slow { worst, ratio }
    }
}
