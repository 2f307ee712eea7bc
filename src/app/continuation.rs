//! Relative equilibria at constant spin (THEORY 8.1): Newton's iteration, continued from rest in
//! the scale of the spin.

use crate::linalg::{Saddle, Singular};
use crate::system::ConstraintLevel;
use crate::{Scene, SolveError, State};

use crate::error::SolveErrorKind;

/// First step of the scale.
const FIRST_STEP: f64 = 0.05;
/// Largest step of the scale: rows close enough for a chart.
const LARGEST_STEP: f64 = 0.05;
/// Below this step of the scale there is no equilibrium to follow.
const SMALLEST_STEP: f64 = 1e-6;
const MOST_ITERATIONS: usize = 12;
/// Last increment relative to the sizes; quadratic convergence leaves round-off behind it.
const CONVERGED: f64 = 1e-9;

/// An equilibrium on the way.
pub(super) struct Equilibrium<'e> {
    /// Spin relative to that of the frames at the time asked for, 0 to 1.
    pub scale: f64,
    /// Positions and multipliers; velocities and accelerations zero.
    pub state: &'e State,
}

/// Follows the equilibria from rest to the full spin at `t`, and calls `visit` at each.
/// Returns the last state and the number of Newton iterations.
///
/// # Errors
/// No equilibrium exists at `t`, the text says why, or none was found beyond some spin.
pub(super) fn follow(
    scene: &mut dyn Scene,
    t: f64,
    mut visit: impl FnMut(&mut dyn Scene, &Equilibrium<'_>) -> Result<(), String>,
) -> Result<(State, u64), SolveError> {
    let fail = |text: String| SolveError {
        kind: SolveErrorKind::NoEquilibrium(text),
        t,
        h: 0.0,
        worst: None,
    };
    if let Some(obstacle) = scene.steady_obstacle(t) {
        return Err(fail(obstacle));
    }
    let mut newton = Newton::new(scene, t);
    let mut state = scene.rest(t);
    state.v.fill(0.0);
    let mut iterations = 0;
    let (mut scale, mut step): (f64, f64) = (0.0, 0.0);
    let mut previous: Option<(f64, State)> = None;
    loop {
        let next = (scale + step).min(1.0);
        let mut trial = predicted(scale, &state, previous.as_ref(), next);
        match newton.solve(scene, next, &mut trial) {
            Ok(count) => {
                iterations += count;
                previous = (next > scale).then(|| (scale, std::mem::replace(&mut state, trial.clone())));
                (scale, state) = (next, trial);
                visit(scene, &Equilibrium { scale, state: &state }).map_err(fail)?;
                if scale >= 1.0 {
                    return Ok((state, iterations));
                }
                step = if step == 0.0 {
                    FIRST_STEP
                } else {
                    (1.5 * step).min(LARGEST_STEP)
                };
                // No step so short that its predictor is round-off.
                if 1.0 - (scale + step) < 1e-9 {
                    step = 1.0 - scale;
                }
            }
            Err(reason) => {
                step *= 0.5;
                if step < SMALLEST_STEP {
                    let spin = scale * scene.spin(t);
                    return Err(fail(format!(
                        "none was found beyond the spin {spin:e} rad/s ({reason})"
                    )));
                }
            }
        }
    }
}

/// The state carried on along the line through the last two.
fn predicted(scale: f64, state: &State, previous: Option<&(f64, State)>, next: f64) -> State {
    let mut trial = state.clone();
    if let Some((before, old)) = previous {
        // The state grows with the square of the spin.
        let ratio = (next * next - scale * scale) / (scale * scale - before * before);
        let carry = |new: &mut [f64], old: &[f64]| {
            for (value, old) in new.iter_mut().zip(old) {
                *value += ratio * (*value - old);
            }
        };
        carry(&mut trial.x, &old.x);
        carry(&mut trial.lambda, &old.lambda);
    }
    trial
}

/// Memory and factorization of the iteration.
struct Newton {
    t: f64,
    saddle: Saddle<f64>,
    stiffness: Vec<f64>,
    jacobian: Vec<f64>,
    residual: Vec<f64>,
    violation: Vec<f64>,
}

impl Newton {
    fn new(scene: &dyn Scene, t: f64) -> Self {
        let (pattern, constraints) = (scene.pattern(), scene.constraint_pattern());
        Self {
            t,
            saddle: Saddle::new(pattern, constraints),
            stiffness: vec![0.0; pattern.entries()],
            jacobian: vec![0.0; constraints.entries()],
            residual: vec![0.0; scene.unknowns()],
            violation: vec![0.0; scene.constraints()],
        }
    }

    /// Solves for positions and multipliers; the number of iterations, or why there is no solution.
    fn solve(&mut self, scene: &mut dyn Scene, scale: f64, state: &mut State) -> Result<u64, String> {
        for iteration in 1..=MOST_ITERATIONS {
            self.evaluate(scene, scale, state);
            self.saddle
                .factor(&self.stiffness, &self.jacobian)
                .map_err(|singular| described(scene, singular))?;
            self.saddle.solve(&mut self.residual, &mut self.violation);
            let mut largest = 0.0_f64;
            for ((x, change), size) in state.x.iter_mut().zip(&self.residual).zip(scene.sizes()) {
                *x -= change;
                // `max` would drop a NaN.
                let change = change.abs() / size;
                largest = if change <= largest { largest } else { change };
            }
            for (multiplier, change) in state.lambda.iter_mut().zip(&self.violation) {
                *multiplier -= change;
            }
            if !largest.is_finite() {
                return Err("a value is not finite".into());
            }
            if largest <= CONVERGED {
                return Ok(iteration as u64);
            }
        }
        Err("Newton's iteration does not converge".into())
    }

    fn evaluate(&mut self, scene: &mut dyn Scene, scale: f64, state: &State) {
        scene.steady_residual(self.t, scale, &state.x, &mut self.residual);
        scene.steady_tangent(self.t, scale, &state.x, &mut self.stiffness);
        scene.constraint(ConstraintLevel::Position, state, &mut self.violation);
        scene.constraint_jacobian(self.t, &state.x, &mut self.jacobian);
        let pattern = scene.constraint_pattern();
        pattern.multiply_add(1.0, &self.jacobian, &state.lambda, &mut self.residual);
    }
}

fn described(scene: &dyn Scene, singular: Singular) -> String {
    match singular {
        Singular::Unknown(index) => format!("the stiffness is singular at {}", scene.describe_unknown(index)),
        Singular::Constraint(index) => format!("{} is redundant", scene.describe_constraint(index)),
        Singular::Somewhere => "the stiffness is singular".into(),
    }
}
