//! Radau IIA: orders of convergence, error control, stiffness.

use super::systems::{Oscillator, Pendulum};
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::linalg::Pattern;
use crate::system::{ConstraintLevel, State, System, Tangent};

/// One free unknown, `m(x) x'' + f(t, x, v) = 0`, by m and its derivative and f and its derivatives
/// with respect to x and v.
pub(super) struct Single {
    mass: fn(f64) -> [f64; 2],
    force: fn(f64, f64, f64) -> [f64; 3],
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Single {
    fn new(force: fn(f64, f64, f64) -> [f64; 3]) -> Self {
        Self::with_mass(|_| [1.0, 0.0], force)
    }

    pub(super) fn with_mass(mass: fn(f64) -> [f64; 2], force: fn(f64, f64, f64) -> [f64; 3]) -> Self {
        Self {
            mass,
            force,
            pattern: Pattern::new(1, 1, [(0, 0)]),
            constraint_pattern: Pattern::new(1, 0, []),
        }
    }
}

impl System for Single {
    fn unknowns(&self) -> usize {
        1
    }
    fn constraints(&self) -> usize {
        0
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, state: &State, values: &mut [f64]) {
        values[0] = (self.mass)(state.x[0])[0];
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let (t, x, v, a) = (state.t, &state.x[..], &state.v[..], &state.a[..]);
        out[0] = (self.mass)(x[0])[0] * a[0] + (self.force)(t, x[0], v[0])[0];
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        let [_, stiffness, damping] = (self.force)(state.t, state.x[0], state.v[0]);
        out.stiffness[0] = stiffness + (self.mass)(state.x[0])[1] * state.a[0];
        out.damping[0] = damping;
    }
    fn constraint(&mut self, _level: ConstraintLevel, _state: &State, _out: &mut [f64]) {}
    fn constraint_jacobian(&mut self, _state: &State, _values: &mut [f64]) {}
    fn constraint_rate_tangent(&mut self, _state: &State, _values: &mut [f64]) {}
    fn sizes(&self) -> &[f64] {
        &[1.0]
    }
    fn describe_unknown(&self, _index: usize) -> String {
        "x".into()
    }
    fn describe_constraint(&self, _index: usize) -> String {
        String::new()
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

fn start(x: f64, v: f64) -> State {
    State {
        x: vec![x],
        v: vec![v],
        ..State::zeros(0.0, 1, 0)
    }
}

/// Runs with three stages to `t_end` and shows every accepted step.
fn run<S: System>(
    system: &mut S,
    start: State,
    t_end: f64,
    options: Options,
    see: impl FnMut(&mut Integrator<S>),
) -> (State, Statistics) {
    run_by(Method::Radau, system, start, t_end, options, see)
}

/// Runs to `t_end` and shows every accepted step.
pub(super) fn run_by<S: System>(
    method: Method,
    system: &mut S,
    start: State,
    t_end: f64,
    options: Options,
    mut see: impl FnMut(&mut Integrator<S>),
) -> (State, Statistics) {
    let mut integrator = Integrator::new(system, start, t_end, method, options).unwrap();
    while integrator.step().unwrap() != Stop::End {
        see(&mut integrator);
    }
    see(&mut integrator);
    (integrator.state().clone(), integrator.statistics().clone())
}

fn fixed(h: f64) -> Options {
    Options {
        step: StepSize::Fixed(h),
        ..Options::default()
    }
}

pub(super) fn adaptive(rtol: f64) -> Options {
    Options {
        rtol,
        ..Options::default()
    }
}

/// Observed orders between successive halvings.
pub(super) fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

#[test]
fn free_pendulum_converges_with_order_5() {
    let exact = Pendulum::at_rest().advance([0.0, -3.0], 0.0, 1.0);
    let (mut position, mut velocity) = (vec![], vec![]);
    for steps in [10.0, 20.0, 40.0] {
        let mut system = Single::new(|_, x, _| [9.81 * x.cos(), -9.81 * x.sin(), 0.0]);
        let (state, statistics) = run(&mut system, start(0.0, -3.0), 1.0, fixed(1.0 / steps), |_| {});
        assert!(
            statistics.jacobian_evaluations > 0 && statistics.factorizations < 10,
            "{statistics:?}"
        );
        position.push((state.x[0] - exact[0]).abs());
        velocity.push((state.v[0] - exact[1]).abs());
    }
    println!(
        "x {position:?} {:?}\nv {velocity:?} {:?}",
        orders(&position),
        orders(&velocity)
    );
    assert!(
        orders(&position)
            .iter()
            .chain(&orders(&velocity))
            .all(|order| *order > 4.7)
    );
}

/// Damped and driven: `x'' + 0.4 v + 4 x = sin 3 t` from rest at 0.
fn driven() -> Oscillator {
    Oscillator::new(4.0, 0.4, |t| (3.0 * t).sin())
}

fn driven_exact(t: f64) -> f64 {
    // Particular solution p sin 3t + q cos 3t: (-5 p - 1.2 q) = 1, (-5 q + 1.2 p) = 0.
    let p = -5.0 / 26.44;
    let q = 0.24 * p;
    let (decay, omega) = (0.2, 3.96_f64.sqrt());
    let b = -(3.0 * p + decay * q) / omega;
    let free = (-decay * t).exp() * (-q * (omega * t).cos() + b * (omega * t).sin());
    p * (3.0 * t).sin() + q * (3.0 * t).cos() + free
}

#[test]
fn driven_oscillator_converges_with_order_5_and_between_steps_with_4() {
    let (mut ends, mut between) = (vec![], vec![]);
    for steps in [20.0, 40.0, 80.0] {
        let mut largest = 0.0_f64;
        let mut out = State::default();
        let (state, _) = run(&mut driven(), start(0.0, 0.0), 4.0, fixed(4.0 / steps), |integrator| {
            let t = integrator.previous_time() + 1.5 / steps;
            integrator.interpolate(t, &mut out);
            largest = largest.max((out.x[0] - driven_exact(t)).abs());
        });
        ends.push((state.x[0] - driven_exact(4.0)).abs());
        between.push(largest);
    }
    println!("{ends:?} {:?}\n{between:?} {:?}", orders(&ends), orders(&between));
    assert!(orders(&ends).iter().all(|order| *order > 4.7));
    assert!(orders(&between).iter().all(|order| *order > 3.7));
}

/// Largest errors of positions, velocities, multipliers and accelerations of the pendulum of index 3 over a second, by steps in it.
pub(super) fn errors_of_pendulum(method: Method, steps: &[f64]) -> [Vec<f64>; 4] {
    let reference = Pendulum::at_rest();
    let mut errors = [const { Vec::new() }; 4];
    for steps in steps {
        let (mut t, mut y) = (0.0, [0.0, -3.0]);
        let mut largest = [0.0_f64; 4];
        run_by(
            method,
            &mut Pendulum::at_rest(),
            reference.state(0.0, 0.0, -3.0),
            1.0,
            fixed(1.0 / steps),
            |integrator| {
                let state = integrator.state();
                y = reference.advance(y, t, state.t);
                t = state.t;
                let exact = reference.state(t, y[0], y[1]);
                let far = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                for (largest, error) in largest.iter_mut().zip([
                    far(&state.x, &exact.x),
                    far(&state.v, &exact.v),
                    far(&state.lambda, &exact.lambda),
                    far(&state.a, &exact.a),
                ]) {
                    *largest = largest.max(error);
                }
            },
        );
        errors
            .iter_mut()
            .zip(largest)
            .for_each(|(errors, largest)| errors.push(largest));
    }
    errors
}

#[test]
fn index_3_pendulum_converges_with_orders_5_3_2() {
    let errors = errors_of_pendulum(Method::Radau, &[20.0, 40.0, 80.0]);
    for (errors, least) in errors.iter().zip([4.7, 2.7, 1.7, 1.7]) {
        println!("{errors:?} {:?}", orders(errors));
        assert!(
            orders(errors).iter().all(|order| *order > least),
            "{:?}",
            orders(errors)
        );
    }
}

#[test]
fn error_follows_the_tolerance() {
    let exact = Pendulum::at_rest().advance([0.0, -3.0], 0.0, 5.0);
    let mut last = f64::INFINITY;
    for rtol in [1e-4, 1e-6, 1e-8, 1e-10] {
        let mut system = Single::new(|_, x, _| [9.81 * x.cos(), -9.81 * x.sin(), 0.0]);
        let (state, free) = run(&mut system, start(0.0, -3.0), 5.0, adaptive(rtol), |_| {});
        let error = (state.x[0] - exact[0]).abs();
        let mut pendulum = Pendulum::at_rest();
        let begin = pendulum.state(0.0, 0.0, -3.0);
        let (state, tied) = run(&mut pendulum, begin, 5.0, adaptive(rtol), |_| {});
        let tied_error = (state.x[0] - exact[0].cos())
            .abs()
            .max((state.x[1] - exact[0].sin()).abs());
        println!(
            "rtol {rtol:e}: error {error:e}, {} steps, {} rejected, {} iterations, {} factorizations; index 3: {tied_error:e}, {} steps, {} rejected by error, {} by Newton, {} iterations, {} factorizations",
            free.steps,
            free.rejected_steps,
            free.newton_iterations,
            free.factorizations,
            tied.steps,
            tied.rejected_by_error,
            tied.rejected_by_newton,
            tied.newton_iterations,
            tied.factorizations
        );
        assert!(
            error < 50.0 * rtol && tied_error < 50.0 * rtol,
            "{error:e} {tied_error:e}"
        );
        assert!(error < last);
        assert!(free.steps < (10.0 * rtol.powf(-0.25)) as u64 && tied.steps < (20.0 * rtol.powf(-0.25)) as u64);
        last = error;
    }
}

#[test]
fn fast_motion_that_is_slaved_does_not_bind_the_step() {
    // x follows sin t; its own motion has 1e5 rad/s.
    let mut system = Oscillator::new(1e10, 0.0, |t| 1e10 * t.sin());
    let begin = start(0.0, 1.0);
    let (state, statistics) = run(&mut system, begin, 10.0, adaptive(1e-6), |_| {});
    println!("{statistics:?}");
    assert!(
        (state.x[0] - 10_f64.sin()).abs() < 1e-5,
        "{}",
        state.x[0] - 10_f64.sin()
    );
    assert!(statistics.steps < 150, "{}", statistics.steps);
}
