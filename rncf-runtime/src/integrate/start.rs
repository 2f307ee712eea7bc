//! Before the first step: settings in range, and a first step that fits the scales of the motion.

use super::bordered::Bordered;
use super::newton::norm;
use super::{Method, Options, Statistics, StepSize};
use crate::error::SolveErrorKind;
use crate::linalg::Singular;
use crate::system::{State, System};

/// First trial step, as a part of the time in which an unknown covers its size, or of the span.
const CAUTIOUS: f64 = 1e-2;

/// Least tolerance: a few units of the last place of numbers.
const LEAST: f64 = 1e-15;

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
        Method::Radau | Method::EnergyMomentum => {}
    }
    check(positive(options.rtol), "rtol", options.rtol, "positive and finite")?;
    check(
        options.rtol >= LEAST,
        "rtol",
        options.rtol,
        "at least 1e-15: below is the round-off of numbers",
    )?;
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

/// Checks that a method on constraints of index 3 has dissipation: without any, errors of the multipliers grow from
/// step to step, however short the steps are (THEORY 10, T1).
pub(super) fn check_dissipation(constraints: usize, method: Method, options: &Options) -> Result<(), SolveErrorKind> {
    let undamped = match method {
        Method::Hht { alpha: 0.0 } => "alpha = 0",
        Method::GeneralizedAlpha { rho_inf: 1.0 } => "rho_inf = 1",
        _ => return Ok(()),
    };
    if constraints == 0 || options.stabilised {
        return Ok(());
    }
    Err(SolveErrorKind::Setting(format!(
        "{undamped} damps nothing, and without damping errors in the forces of constraints grow from step to step: \
         take e.g. rho_inf = 0.8 or alpha = -0.05, or `stabilised` constraints"
    )))
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
