//! Round-off over a million steps: what is summed up keeps its last bits.

use crate::integrate::{Integrator, Method, Options, StepSize, Stop};
use crate::linalg::Pattern;
use crate::system::{ConstraintLevel, State, System, Tangent};

const STEPS: usize = 1_000_000;
const METHODS: [Method; 3] = [
    Method::GeneralizedAlpha { rho_inf: 1.0 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
    Method::Radau,
];

/// Point mass of 1 kg on a spring (N/m) under a constant force (N).
struct Mass {
    stiffness: f64,
    force: f64,
    pattern: Pattern,
    none: Pattern,
}

impl Mass {
    fn new(stiffness: f64, force: f64) -> Self {
        Self {
            stiffness,
            force,
            pattern: Pattern::new(1, 1, [(0, 0)]),
            none: Pattern::new(1, 0, []),
        }
    }

    /// The end of a million steps of size `h` (s), which start at `x` (m) and `v` (m/s).
    fn after(&mut self, method: Method, h: f64, x: f64, v: f64) -> State {
        let mut start = State::zeros(0.0, 1, 0);
        (start.x[0], start.v[0]) = (x, v);
        let options = Options {
            step: StepSize::Fixed(h),
            ..Options::default()
        };
        let end = STEPS as f64 * h;
        let mut integrator = Integrator::new(self, start, end, method, options).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        assert_eq!(integrator.statistics().steps, STEPS as u64, "{method:?}");
        assert_eq!(integrator.state().t, end, "{method:?}");
        integrator.state().clone()
    }
}

impl System for Mass {
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
        &self.none
    }
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        values[0] = 1.0;
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        out[0] = state.a[0] + self.stiffness * state.x[0] - self.force;
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        out.stiffness[0] = self.stiffness;
        out.damping[0] = 0.0;
    }
    fn constraint(&mut self, _level: ConstraintLevel, _state: &State, _out: &mut [f64]) {}
    fn constraint_jacobian(&mut self, _state: &State, _values: &mut [f64]) {}
    fn constraint_rate_tangent(&mut self, _state: &State, _values: &mut [f64]) {}
    fn sizes(&self) -> &[f64] {
        &[1.0]
    }
    fn describe_unknown(&self, _index: usize) -> String {
        "position".into()
    }
    fn describe_constraint(&self, _index: usize) -> String {
        String::new()
    }
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

#[test]
fn a_fall_of_a_million_steps_ends_where_it_should() {
    let (h, v, a) = (0.1, 0.3, 0.007);
    // The same sums without what rounding takes: all methods are exact for this motion.
    let (mut x_plain, mut v_plain, mut t_plain) = (0.0, v, 0.0);
    for _ in 0..STEPS {
        x_plain += h * (v_plain + 0.5 * h * a);
        v_plain += h * a;
        t_plain += h;
    }
    let t = STEPS as f64 * h;
    let (x_end, v_end) = (t * (v + 0.5 * a * t), v + a * t);
    let off = |x: f64, v: f64| [(x / x_end - 1.0).abs(), (v / v_end - 1.0).abs()];
    let plain = off(x_plain, v_plain);
    println!(
        "plain sums: off by {:.1e} of position, {:.1e} of velocity, {:.1e} s",
        plain[0],
        plain[1],
        t_plain - t
    );
    assert!(plain[0] > 1e-14 && plain[1] > 1e-12 && (t_plain - t).abs() > 1e-7);
    for method in METHODS {
        let end = Mass::new(0.0, a).after(method, h, 0.0, v);
        let found = off(end.x[0], end.v[0]);
        println!("{method:?}: {:.1e} and {:.1e}", found[0], found[1]);
        assert!(found.into_iter().all(|off| off < 1e-15), "{method:?}: {found:?}");
    }
}

#[test]
fn the_energy_of_a_million_steps_of_a_slow_oscillation_stays() {
    let (h, rate) = (0.1_f64, 0.013_f64);
    // The trapezoidal rule, which is generalized-alpha with rho = 1, keeps this energy.
    let energy = |x: f64, v: f64| 0.5 * (v * v + rate * rate * x * x);
    let (mut x, mut v) = (1.0, 0.0);
    let first = energy(x, v);
    let z = 0.25 * h * h * rate * rate;
    for _ in 0..STEPS {
        let slower = (v - z * v - h * rate * rate * x) / (1.0 + z);
        x += 0.5 * h * (v + slower);
        v = slower;
    }
    let plain = energy(x, v) / first - 1.0;
    let end = Mass::new(rate * rate, 0.0).after(METHODS[0], h, 1.0, 0.0);
    let found = energy(end.x[0], end.v[0]) / first - 1.0;
    println!("relative drift of the energy: plain {plain:.1e}, summed with low parts {found:.1e}");
    assert!(found.abs() < 1e-14, "{found:e}");
    assert!(plain.abs() > 10.0 * found.abs());
}
