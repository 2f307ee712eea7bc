//! The driver: adaptive steps, kinks, ends, errors.

use super::systems::{Oscillator, Pendulum};
use crate::error::{SolveError, SolveErrorKind};
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::system::{State, System};

#[test]
#[ignore]
fn print_adaptive() {
    for method in [Method::Hht { alpha: -0.05 }, Method::Hht { alpha: -0.3 }, Method::GeneralizedAlpha { rho_inf: 0.8 }, Method::GeneralizedAlpha { rho_inf: 0.9 }] {
        for rtol in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            let (errors, s) = pendulum(method, Options { rtol, ..Options::default() }, 2.0);
            println!("{method:?} {rtol:e}: x {:.1e} v {:.1e} lam {:.1e}: {} steps, rej {}+{}, newton {}, jac {} fact {} solves {} h {:.1e} {:.1e}", errors[0], errors[1], errors[2],
              s.steps, s.rejected_by_error, s.rejected_by_newton, s.newton_iterations, s.jacobian_evaluations, s.factorizations, s.solves, s.smallest_step, s.largest_step);
        }
    }
    for method in [Method::Hht { alpha: -0.3 }, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
        for rtol in [1e-4, 1e-6, 1e-8] {
            let mut system = Oscillator::new(400.0, 0.1, |t| 400.0 * t.cos());
            let start = State { v: vec![1.0], ..State::zeros(0.0, 1, 0) };
            let mut i = Integrator::new(&mut system, start, 10.0, method, Options { rtol, ..Options::default() }).unwrap();
            while i.step().unwrap() != Stop::End {}
            let s = i.statistics();
            println!("osc {method:?} {rtol:e}: {} steps, rej {}+{}, newton {}, jac {} fact {} solves {} h {:.1e} {:.1e}",
              s.steps, s.rejected_by_error, s.rejected_by_newton, s.newton_iterations, s.jacobian_evaluations, s.factorizations, s.solves, s.smallest_step, s.largest_step);
        }
    }
}

/// Largest errors of position, velocity and multiplier over an adaptive run of the pendulum.
fn pendulum(method: Method, options: Options, t_end: f64) -> ([f64; 3], Statistics) {
    let (mut system, reference) = (Pendulum::at_rest(), Pendulum::at_rest());
    let mut y = [0.0, -3.0];
    let mut integrator = Integrator::new(&mut system, reference.state(0.0, y[0], y[1]), t_end, method, options).unwrap();
    let mut errors = [0.0_f64; 3];
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state();
        y = reference.advance(y, integrator.previous_time(), state.t);
        let exact = reference.state(state.t, y[0], y[1]);
        for (error, (got, exact)) in errors.iter_mut().zip([(&state.x, &exact.x), (&state.v, &exact.v), (&state.lambda, &exact.lambda)]) {
            *error = got.iter().zip(exact).map(|(y, z)| (y - z).abs()).fold(*error, f64::max);
        }
        if stop == Stop::End {
            assert_eq!(state.t, t_end);
            return (errors, integrator.statistics().clone());
        }
    }
}
