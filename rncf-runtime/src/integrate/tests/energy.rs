//! Energy-momentum integration of a mass on a spring whose energy is quadratic in r . r.

use crate::integrate::{Integrator, Method, Options, StepSize, Stop};
use crate::linalg::Pattern;
use crate::system::{Conserving, ConstraintLevel, State, System, Tangent};

/// `U = k/8 (r.r - 1)^2` in a plane, m = 1.
struct Spring {
    pattern: Pattern,
    none: Pattern,
    stiffness: f64,
}

impl Spring {
    fn new(stiffness: f64) -> Self {
        Self {
            pattern: Pattern::new(2, 2, (0..2).flat_map(|i| (0..2).map(move |j| (i, j)))),
            none: Pattern::new(2, 0, []),
            stiffness,
        }
    }

    fn values(&self, rows: [[f64; 2]; 2], values: &mut [f64]) {
        for (i, row) in rows.iter().enumerate() {
            for (j, &value) in row.iter().enumerate() {
                values[self.pattern.find(i, j).unwrap()] = value;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

impl System for Spring {
    fn unknowns(&self) -> usize {
        2
    }
    fn constraints(&self) -> usize {
        0
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.none
    }
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        self.values([[1.0, 0.0], [0.0, 1.0]], values);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let stress = 0.5 * self.stiffness * (dot(&state.x, &state.x) - 1.0);
        for i in 0..2 {
            out[i] = state.a[i] + stress * state.x[i];
        }
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        out.damping.fill(0.0);
        let (k, x) = (self.stiffness, &state.x);
        let stress = 0.5 * k * (dot(x, x) - 1.0);
        let entry = |i: usize, j: usize| k * x[i] * x[j] + if i == j { stress } else { 0.0 };
        self.values(
            [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]],
            &mut out.stiffness,
        );
    }
    fn constraint(&mut self, _level: ConstraintLevel, _state: &State, _out: &mut [f64]) {}
    fn constraint_jacobian(&mut self, _state: &State, _values: &mut [f64]) {}
    fn constraint_rate_tangent(&mut self, _state: &State, _values: &mut [f64]) {}
    fn sizes(&self) -> &[f64] {
        &[1.0, 1.0]
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("mass, {}", ["x", "y"][index])
    }
    fn describe_constraint(&self, _index: usize) -> String {
        String::new()
    }
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    fn energy(&mut self, state: &State) -> Option<f64> {
        let change = dot(&state.x, &state.x) - 1.0;
        Some(0.5 * dot(&state.v, &state.v) + self.stiffness / 8.0 * change * change)
    }
    fn conserving(&mut self) -> Result<&mut dyn Conserving, String> {
        Ok(self)
    }
}

impl Conserving for Spring {
    fn residual(&mut self, from: &State, to: &State, out: &mut [f64]) {
        let mean = 0.5 * (dot(&from.x, &from.x) + dot(&to.x, &to.x));
        let stress = 0.5 * self.stiffness * (mean - 1.0);
        for i in 0..2 {
            out[i] = to.a[i] + stress * 0.5 * (from.x[i] + to.x[i]);
        }
    }
    fn constraint_forces(&mut self, _: &State, _: &State, _: &mut [f64]) {}
    fn matrix(&mut self, from: &State, to: &State, [mass, by_mean]: [f64; 2], values: &mut [f64]) {
        let k = self.stiffness;
        let stress = 0.5 * k * (0.5 * (dot(&from.x, &from.x) + dot(&to.x, &to.x)) - 1.0);
        let entry = |i: usize, j: usize| {
            let unit = if i == j { 1.0 } else { 0.0 };
            mass * unit + by_mean * (stress * unit + k * 0.5 * (from.x[i] + to.x[i]) * to.x[j])
        };
        self.values([[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]], values);
    }
}

fn start() -> State {
    State {
        x: vec![1.2, 0.1],
        v: vec![-0.3, 1.1],
        ..State::zeros(0.0, 2, 0)
    }
}

fn options(step: StepSize, rtol: f64) -> Options {
    Options {
        step,
        rtol,
        ..Options::default()
    }
}

/// The end, and the largest changes of energy and angular momentum.
fn run(method: Method, stiffness: f64, options: Options, end: f64) -> (State, [f64; 2]) {
    let mut spring = Spring::new(stiffness);
    let kept = |spring: &mut Spring, state: &State| {
        let spin = state.x[0] * state.v[1] - state.x[1] * state.v[0];
        [spring.energy(state).unwrap(), spin]
    };
    let first = kept(&mut spring, &start());
    let mut integrator = Integrator::new(&mut spring, start(), end, method, options).unwrap();
    let mut changes = [0.0_f64; 2];
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        let now = kept(integrator.system(), &state);
        for ((change, now), first) in changes.iter_mut().zip(now).zip(first) {
            *change = change.max((now - first).abs() / first);
        }
        if stop == Stop::End {
            println!("{:?}: {changes:?}, {:?}", options.step, integrator.statistics());
            return (state, changes);
        }
    }
}

#[test]
fn energy_and_angular_momentum_stay_at_small_and_large_steps() {
    // Of a period of 2 pi / sqrt(k) = 0.2 s.
    for (stiffness, h, steps) in [(1e3, 1e-3, 1e4), (1e3, 0.03, 1e4)] {
        let (_, changes) = run(
            Method::EnergyMomentum,
            stiffness,
            options(StepSize::Fixed(h), 1e-6),
            h * steps,
        );
        assert!(changes.iter().all(|change| *change < 2e-13), "{h}: {changes:?}");
    }
}

#[test]
fn the_order_is_two_and_adaptive_steps_conserve_too() {
    let (exact, _) = run(Method::Radau, 1e3, options(StepSize::Adaptive, 1e-12), 2.0);
    let error = |options: Options| {
        let (state, changes) = run(Method::EnergyMomentum, 1e3, options, 2.0);
        assert!(changes.iter().all(|change| *change < 1e-13), "{changes:?}");
        let far = state.x.iter().zip(&exact.x).map(|(a, b)| (a - b).abs());
        far.fold(0.0, f64::max)
    };
    let errors = [2e-3, 1e-3, 5e-4].map(|h| error(options(StepSize::Fixed(h), 1e-6)));
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
    let errors = [1e-5, 1e-6, 1e-7].map(|rtol| error(options(StepSize::Adaptive, rtol)));
    println!("adaptive: {errors:?}");
    for pair in errors.windows(2) {
        let slope = (pair[0] / pair[1]).log10();
        assert!((slope - 2.0 / 3.0).abs() < 0.15, "{errors:?}");
    }
}
