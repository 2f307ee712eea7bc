//! The driver: adaptive steps, kinks, ends, errors.

use super::systems::{Oscillator, Pendulum};
use crate::error::{SolveError, SolveErrorKind};
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::system::State;

/// Largest errors of position, velocity and multiplier over an adaptive run of the pendulum.
fn pendulum(method: Method, options: Options, t_end: f64) -> ([f64; 3], Statistics) {
    let (mut system, reference) = (Pendulum::at_rest(), Pendulum::at_rest());
    let mut y = [0.0, -3.0];
    let mut integrator =
        Integrator::new(&mut system, reference.state(0.0, y[0], y[1]), t_end, method, options).unwrap();
    let mut errors = [0.0_f64; 3];
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state();
        y = reference.advance(y, integrator.previous_time(), state.t);
        let exact = reference.state(state.t, y[0], y[1]);
        for (error, (got, exact)) in errors.iter_mut().zip([
            (&state.x, &exact.x),
            (&state.v, &exact.v),
            (&state.lambda, &exact.lambda),
        ]) {
            *error = got.iter().zip(exact).map(|(y, z)| (y - z).abs()).fold(*error, f64::max);
        }
        if stop == Stop::End {
            assert_eq!(state.t, t_end);
            return (errors, integrator.statistics().clone());
        }
    }
}

const METHODS: [Method; 4] = [
    Method::Hht { alpha: -0.05 },
    Method::Hht { alpha: -0.3 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
    Method::GeneralizedAlpha { rho_inf: 0.9 },
];

#[test]
fn errors_follow_the_tolerance() {
    for method in METHODS {
        let at = |rtol| {
            pendulum(
                method,
                Options {
                    rtol,
                    ..Options::default()
                },
                2.0,
            )
        };
        let ((coarse, few), (fine, many)) = (at(1e-5), at(1e-8));
        // A thousandth of the tolerance: a tenth of the step, a hundredth of all errors.
        for i in 0..3 {
            assert!(
                coarse[i] > 20.0 * fine[i],
                "{method:?}, variable {i}: {coarse:?} -> {fine:?}"
            );
        }
        assert!((7.0..14.0).contains(&(many.steps as f64 / few.steps as f64)));
        assert!(many.rejected_steps * 20 < many.steps, "{many:?}");
        assert!(many.factorizations * 4 < many.steps, "{many:?}");
        assert!(many.max_constraint_residual < 1e-10, "{many:?}");
    }
}

#[test]
fn runs_are_deterministic() {
    let run = || pendulum(METHODS[2], Options::default(), 1.0);
    assert_eq!(run(), run());
}

/// A pivot that accelerates with 4 m/s^2 and from 0.5 s on with -4 m/s^2.
fn shuttle(t: f64) -> [f64; 4] {
    if t < 0.5 {
        [2.0 * t * t, 4.0 * t, 4.0, 0.0]
    } else {
        let s = t - 0.5;
        [0.5 + 2.0 * s - 2.0 * s * s, 2.0 - 4.0 * s, -4.0, 0.0]
    }
}

/// Runs over the kink with a fixed step and returns the largest errors behind it.
fn over_the_kink(method: Method, h: f64) -> ([f64; 3], Statistics) {
    let mut system = Pendulum::new(shuttle, vec![0.5]);
    let reference = Pendulum::new(shuttle, vec![]);
    let mut y = [0.3, 0.0];
    let options = Options {
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let start = reference.state(0.0, y[0], y[1]);
    let mut integrator = Integrator::new(&mut system, start, 1.0, method, options).unwrap();
    let (mut errors, mut kinks) = ([0.0_f64; 3], 0);
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state();
        y = reference.advance(y, integrator.previous_time(), state.t);
        let exact = reference.state(state.t, y[0], y[1]);
        for (error, (got, exact)) in errors.iter_mut().zip([
            (&state.x, &exact.x),
            (&state.v, &exact.v),
            (&state.lambda, &exact.lambda),
        ]) {
            *error = got.iter().zip(exact).map(|(y, z)| (y - z).abs()).fold(*error, f64::max);
        }
        match stop {
            Stop::Step => {}
            Stop::Kink => {
                assert_eq!(state.t, 0.5_f64.next_down());
                kinks += 1;
            }
            Stop::End => break,
        }
    }
    assert_eq!(kinks, 1);
    (errors, integrator.statistics().clone())
}

#[test]
fn kink_keeps_second_order() {
    for method in METHODS {
        // 0.5 s is no multiple of these steps.
        let [(coarse, counts), (fine, _)] = [0.012, 0.006].map(|h| over_the_kink(method, h));
        for i in 0..3 {
            let ratio = coarse[i] / fine[i];
            assert!(
                (3.0..6.0).contains(&ratio),
                "{method:?}, variable {i}: {coarse:?} -> {fine:?}"
            );
        }
        assert_eq!(counts.restarts, 1);
        assert!(counts.smallest_step > 0.006, "{counts:?}");
    }
}

#[test]
fn step_ceiling_is_kept_and_counted() {
    let options = Options {
        rtol: 1e-4,
        max_step: 0.01,
        ..Options::default()
    };
    let (_, counts) = pendulum(METHODS[1], options, 1.0);
    assert!(counts.largest_step <= 0.01 * (1.0 + 1e-8), "{counts:?}");
    assert!(
        counts.steps_at_ceiling > 90 && counts.steps_at_ceiling < counts.steps,
        "{counts:?}"
    );
}

#[test]
fn dense_output_is_as_accurate_as_the_steps() {
    let exact = |t: f64| (3.0 * t).sin();
    let mut system = Oscillator::new(9.0, 0.0, |_| 0.0);
    let start = State {
        v: vec![3.0],
        ..State::zeros(0.0, 1, 0)
    };
    let mut integrator = Integrator::new(&mut system, start, 3.0, METHODS[2], Options::default()).unwrap();
    let (mut at_steps, mut between) = (0.0_f64, 0.0_f64);
    let mut out = State::default();
    while integrator.step().unwrap() != Stop::End {
        let (t0, state) = (integrator.previous_time(), integrator.state());
        let (t1, x1) = (state.t, state.x[0]);
        at_steps = at_steps.max((x1 - exact(t1)).abs());
        for part in [0.25, 0.5, 0.75] {
            let t = t0 + part * (t1 - t0);
            integrator.interpolate(t, &mut out);
            assert_eq!(out.t, t);
            between = between.max((out.x[0] - exact(t)).abs());
        }
    }
    assert!(between < 1.5 * at_steps, "{between} {at_steps}");
}

fn refusal(start: State, t_end: f64, method: Method, options: Options) -> SolveError {
    let mut system = Pendulum::at_rest();
    Integrator::new(&mut system, start, t_end, method, options)
        .err()
        .expect("must be refused")
}

#[test]
fn settings_out_of_range_are_named() {
    let start = || Pendulum::at_rest().state(0.0, 0.0, -3.0);
    let with = |options| refusal(start(), 1.0, METHODS[0], options).to_string();
    let default = Options::default();
    assert!(with(Options { rtol: 0.0, ..default }).contains("rtol"));
    assert!(
        with(Options {
            step: StepSize::Fixed(-1.0),
            ..default
        })
        .contains("fixed step")
    );
    assert!(
        with(Options {
            first_step: Some(0.0),
            ..default
        })
        .contains("first step")
    );
    assert!(
        with(Options {
            max_step: f64::NAN,
            ..default
        })
        .contains("max_step")
    );
    let method = |method| refusal(start(), 1.0, method, default).to_string();
    assert!(method(Method::Hht { alpha: 0.1 }).contains("[-1/3, 0]"));
    assert!(method(Method::GeneralizedAlpha { rho_inf: f64::NAN }).contains("rho_inf"));
    let loose = Options { rtol: 1e-4, ..default };
    let of_high_order = refusal(start(), 1.0, Method::Radau13, loose).to_string();
    assert!(of_high_order.contains("rtol = 0.0001 is out of range: it must be at most 1e-5 with radau13"));
    assert!(refusal(start(), 0.0, METHODS[0], default).to_string().contains("t_end"));
    let short = State {
        x: vec![1.0],
        ..start()
    };
    assert!(
        refusal(short, 1.0, METHODS[0], default)
            .to_string()
            .contains("1 positions")
    );
}

#[test]
fn jump_that_is_not_declared_stops_with_the_last_good_state() {
    // The force is not a number behind 0.5 s.
    let mut system = Oscillator::new(1.0, 0.0, |t| if t < 0.5 { 1.0 } else { f64::NAN });
    let start = State::zeros(0.0, 1, 0);
    let mut integrator = Integrator::new(&mut system, start, 1.0, METHODS[0], Options::default()).unwrap();
    let error = loop {
        if let Err(error) = integrator.step() {
            break error;
        }
    };
    assert_eq!(error.kind, SolveErrorKind::NotFinite);
    assert!(error.t < 0.5 && error.t > 0.49 && error.t == integrator.state().t);
    assert!(integrator.state().x[0].is_finite());
    assert!(integrator.statistics().rejected_by_newton > 0);
}
