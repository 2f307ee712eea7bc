//! Small systems with hand-written equations and solutions.

use crate::linalg::Pattern;
use crate::system::{ConstraintLevel, State, System, Tangent};

/// Position and three time derivatives of a horizontally moved pivot.
pub(super) type Motion = fn(f64) -> [f64; 4];

/// Gravity, m/s^2.
const G: f64 = 9.81;

/// Point mass of 1 kg on a rigid rod of 1 m in Cartesian coordinates, pivot at (p(t), 0):
/// C = (|q - p|^2 - 1) / 2, the pendulum of THEORY 10.
pub(super) struct Pendulum {
    motion: Motion,
    kinks: Vec<f64>,
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Pendulum {
    pub(super) fn new(motion: Motion, kinks: Vec<f64>) -> Self {
        Self {
            motion,
            kinks,
            pattern: Pattern::new(2, 2, [(0, 0), (0, 1), (1, 0), (1, 1)]),
            constraint_pattern: Pattern::new(2, 1, [(0, 0), (1, 0)]),
        }
    }

    /// The pivot at rest.
    pub(super) fn at_rest() -> Self {
        Self::new(|_| [0.0; 4], vec![])
    }

    /// The state at angle `phi` above the horizontal with angular velocity `omega`.
    pub(super) fn state(&self, t: f64, phi: f64, omega: f64) -> State {
        let [p, dp, ddp, _] = (self.motion)(t);
        let (s, c) = phi.sin_cos();
        let alpha = -G * c + ddp * s;
        State {
            t,
            turns: vec![],
            x: vec![p + c, s],
            v: vec![dp - omega * s, omega * c],
            a: vec![ddp - alpha * s - omega * omega * c, alpha * c - omega * omega * s],
            lambda: vec![omega * omega - ddp * c - G * s],
        }
    }

    /// Advances angle and angular velocity from `t0` to `t1` by fine steps of the classical
    /// Runge-Kutta method; the motion must be smooth between.
    pub(super) fn advance(&self, [phi, omega]: [f64; 2], t0: f64, t1: f64) -> [f64; 2] {
        let steps = ((t1 - t0) / 1e-3).ceil().max(1.0);
        let h = (t1 - t0) / steps;
        let rate = |t: f64, y: [f64; 2]| [y[1], -G * y[0].cos() + (self.motion)(t)[2] * y[0].sin()];
        let moved = |y: [f64; 2], h: f64, k: [f64; 2]| [y[0] + h * k[0], y[1] + h * k[1]];
        let mut y = [phi, omega];
        for step in 0..steps as usize {
            let t = t0 + step as f64 * h;
            let k1 = rate(t, y);
            let k2 = rate(t + h / 2.0, moved(y, h / 2.0, k1));
            let k3 = rate(t + h / 2.0, moved(y, h / 2.0, k2));
            let k4 = rate(t + h, moved(y, h, k3));
            for i in 0..2 {
                y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
        }
        y
    }
}

impl System for Pendulum {
    fn unknowns(&self) -> usize {
        2
    }
    fn constraints(&self) -> usize {
        1
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        values.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let a = &state.a[..];
        out[0] = a[0];
        out[1] = a[1] + G;
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        let lambda = state.lambda[0];
        out.stiffness.copy_from_slice(&[lambda, 0.0, 0.0, lambda]);
        out.damping.fill(0.0);
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        let [p, dp, ddp, dddp] = (self.motion)(state.t);
        let r = [state.x[0] - p, state.x[1]];
        let w = [state.v[0] - dp, state.v[1]];
        out[0] = match level {
            ConstraintLevel::Position => 0.5 * (r[0] * r[0] + r[1] * r[1] - 1.0),
            ConstraintLevel::Velocity => -r[0] * dp,
            ConstraintLevel::Acceleration => w[0] * w[0] + w[1] * w[1] - r[0] * ddp,
            ConstraintLevel::Jerk => 3.0 * (w[0] * (state.a[0] - ddp) + w[1] * state.a[1]) - r[0] * dddp,
        };
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        values[0] = state.x[0] - (self.motion)(state.t)[0];
        values[1] = state.x[1];
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        values[0] = state.v[0] - (self.motion)(state.t)[1];
        values[1] = state.v[1];
    }
    fn sizes(&self) -> &[f64] {
        &[1.0, 1.0]
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("mass, {}", ["x", "y"][index])
    }
    fn describe_constraint(&self, _index: usize) -> String {
        "rod".into()
    }
    fn kinks(&self) -> Vec<f64> {
        self.kinks.clone()
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

/// Damped oscillator `x'' + damping x' + stiffness x = force(t)`.
pub(super) struct Oscillator {
    pub(super) stiffness: f64,
    pub(super) damping: f64,
    pub(super) force: Box<dyn Fn(f64) -> f64>,
    pub(super) kinks: Vec<f64>,
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Oscillator {
    pub(super) fn new(stiffness: f64, damping: f64, force: impl Fn(f64) -> f64 + 'static) -> Self {
        Self {
            stiffness,
            damping,
            force: Box::new(force),
            kinks: vec![],
            pattern: Pattern::new(1, 1, [(0, 0)]),
            constraint_pattern: Pattern::new(1, 0, []),
        }
    }
}

impl System for Oscillator {
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
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        values[0] = 1.0;
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let (t, x, v, a) = (state.t, &state.x[..], &state.v[..], &state.a[..]);
        out[0] = a[0] + self.damping * v[0] + self.stiffness * x[0] - (self.force)(t);
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        out.stiffness[0] = self.stiffness;
        out.damping[0] = self.damping;
    }
    fn constraint(&mut self, _level: ConstraintLevel, _state: &State, _out: &mut [f64]) {}
    fn constraint_jacobian(&mut self, _state: &State, _values: &mut [f64]) {}
    fn constraint_rate_tangent(&mut self, _state: &State, _values: &mut [f64]) {}
    fn sizes(&self) -> &[f64] {
        &[1.0]
    }
    fn describe_unknown(&self, _index: usize) -> String {
        "oscillator".into()
    }
    fn describe_constraint(&self, _index: usize) -> String {
        unreachable!("no constraints")
    }
    fn kinks(&self) -> Vec<f64> {
        self.kinks.clone()
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}
