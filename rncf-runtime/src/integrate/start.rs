//! What must hold before the first step: settings in range, positions and velocities on the
//! constraints, and a first step that fits the scales of the motion.

use super::bordered::Bordered;
use super::newton::norm;
use super::{Method, Options, Statistics, StepSize};
use crate::error::SolveErrorKind;
use crate::linalg::Singular;
use crate::system::{ConstraintLevel, State, System};

/// Largest accepted violation of a constraint, relative to the sizes of what it ties.
const CONSISTENT: f64 = 1e-7;
/// First trial step, as a part of the time in which an unknown covers its size, or of the span.
const CAUTIOUS: f64 = 1e-2;

/// Checks the settings of a run.
pub(super) fn check_settings(t: f64, t_end: f64, method: Method, options: &Options) -> Result<(), SolveErrorKind> {
    let check = |valid: bool, name: &str, value: f64, range: &str| {
        if valid {
            Ok(())
        } else {
            Err(SolveErrorKind::Setting(format!(
                "{name} = {value} is out of range: it must be {range}"
            )))
        }
    };
    let positive = |value: f64| value > 0.0 && value.is_finite();
    match method {
        Method::Hht { alpha } => check((-1.0 / 3.0..=0.0).contains(&alpha), "alpha", alpha, "within [-1/3, 0]")?,
        Method::GeneralizedAlpha { rho_inf } => {
            check((0.0..=1.0).contains(&rho_inf), "rho_inf", rho_inf, "within [0, 1]")?
        }
        Method::Radau => {}
    }
    check(positive(options.rtol), "rtol", options.rtol, "positive and finite")?;
    if let StepSize::Fixed(h) = options.step {
        check(positive(h), "the fixed step (s)", h, "positive and finite")?;
    }
    if let Some(h) = options.first_step {
        check(positive(h), "the first step (s)", h, "positive and finite")?;
    }
    check(options.max_step > 0.0, "max_step (s)", options.max_step, "positive")?;
    check(t.is_finite(), "the start time (s)", t, "finite")?;
    let range = format!("finite and later than the start at {t} s");
    check(t_end.is_finite() && t_end > t, "t_end (s)", t_end, &range)
}

/// The largest violation of a constraint and its index, if it is too large: positions relative to
/// the change of the constraint when every unknown changes by its size, velocities relative to
/// their own terms.
pub(super) fn violation<S: System + ?Sized>(system: &mut S, state: &State, span: f64) -> Option<(f64, usize)> {
    let m = system.constraints();
    let mut jacobian = vec![0.0; system.constraint_pattern().entries()];
    let (mut position, mut velocity) = (vec![0.0; m], vec![0.0; m]);
    system.constraint(ConstraintLevel::Position, state, &mut position);
    system.constraint(ConstraintLevel::Velocity, state, &mut velocity);
    system.constraint_jacobian(state, &mut jacobian);
    let (pattern, sizes) = (system.constraint_pattern(), system.sizes());
    let mut worst: Option<(f64, usize)> = None;
    for column in 0..m {
        let (mut reach, mut rate) = (0.0, velocity[column].abs());
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            let row = pattern.indices()[place];
            reach += (jacobian[place] * sizes[row]).abs();
            rate += (jacobian[place] * state.v[row]).abs();
            velocity[column] += jacobian[place] * state.v[row];
        }
        let excess = |value: f64, scale: f64| (value.abs() > CONSISTENT * scale).then(|| value.abs());
        let found = excess(position[column], reach).or_else(|| excess(velocity[column], rate + reach / span));
        if let Some(size) = found
            && worst.is_none_or(|(worst, _)| size > worst)
        {
            worst = Some((size, column));
        }
    }
    worst
}

/// A first step (s) from the change of the accelerations over a cautious trial step; `bordered`
/// is left at the state.
pub(super) fn first_step<S: System + ?Sized>(
    system: &mut S,
    bordered: &mut Bordered,
    state: &State,
    rtol: f64,
    span: f64,
    statistics: &mut Statistics,
) -> Result<f64, Singular> {
    let inverse_sizes: Vec<f64> = system.sizes().iter().map(|size| 1.0 / size).collect();
    let speed = norm(&state.v, &inverse_sizes);
    let acceleration = norm(&state.a, &inverse_sizes);
    // Time in which the motion covers about one hundredth of the sizes, at most of the span.
    let mut trial = CAUTIOUS * span;
    if speed * trial > CAUTIOUS {
        trial = CAUTIOUS / speed;
    }
    if 0.5 * acceleration * trial * trial > CAUTIOUS {
        trial = (2.0 * CAUTIOUS / acceleration).sqrt();
    }
    trial *= CAUTIOUS;
    let mut later = state.clone();
    later.t += trial;
    for i in 0..state.x.len() {
        later.x[i] += trial * (state.v[i] + 0.5 * trial * state.a[i]);
        later.v[i] += trial * state.a[i];
    }
    bordered.move_to(system, &later);
    bordered.accelerations(system, &mut later, statistics)?;
    bordered.move_to(system, state);
    for i in 0..later.a.len() {
        later.a[i] = (later.a[i] - state.a[i]) / trial;
    }
    // A second-order method errs by about a twelfth of h^3 times the jerk: aim at a tenth of the tolerance.
    let jerk = norm(&later.a, &inverse_sizes);
    let by_jerk = if jerk > 0.0 {
        (rtol / jerk).cbrt()
    } else {
        f64::INFINITY
    };
    Ok(by_jerk.min(100.0 * trial))
}
