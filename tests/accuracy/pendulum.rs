//! The pendulum of THEORY 10, T1 in Cartesian coordinates, written by hand as a system of index 3, against its angle
//! integrated by russell_ode.

use rncf::linalg::Pattern;
use rncf::system::{ConstraintLevel, Tangent};
use rncf::{Integrator, Method, State, Stop, System};
use rncf_reference::integrate::{Method as Explicit, agreed};
use rncf_reference::pendulum::Pendulum;

use crate::runs::{far, fixed, orders, short};

/// Mass, kg; length, m; gravity, m/s^2.
const DATA: [f64; 3] = [1.3, 0.8, 9.81];
/// Velocity of the horizontal start, m/s.
const SPEED: f64 = -3.0;
/// Time between comparisons, s.
const EVERY: f64 = 0.1;

/// `M a + (0, m g) + lambda (x, y) = 0`, `1/2 (x^2 + y^2 - l^2) = 0`.
struct Cartesian {
    pattern: Pattern,
    constraint_pattern: Pattern,
    sizes: [f64; 2],
}

impl Cartesian {
    fn new() -> Self {
        Self {
            pattern: Pattern::new(2, 2, [(0, 0), (1, 1)]),
            constraint_pattern: Pattern::new(2, 1, [(0, 0), (1, 0)]),
            sizes: [DATA[1]; 2],
        }
    }
}

impl System for Cartesian {
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
        values.fill(DATA[0]);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let a = &state.a[..];
        out[0] = DATA[0] * a[0];
        out[1] = DATA[0] * (a[1] + DATA[2]);
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        out.stiffness.fill(state.lambda[0]);
        out.damping.fill(0.0);
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        let dot = |a: &[f64], b: &[f64]| a[0] * b[0] + a[1] * b[1];
        out[0] = match level {
            ConstraintLevel::Position => 0.5 * (dot(&state.x, &state.x) - DATA[1] * DATA[1]),
            ConstraintLevel::Velocity => 0.0,
            ConstraintLevel::Acceleration => dot(&state.v, &state.v),
            ConstraintLevel::Jerk => 3.0 * dot(&state.v, &state.a),
        };
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        values.copy_from_slice(&state.x);
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        values.copy_from_slice(&state.v);
    }
    fn sizes(&self) -> &[f64] {
        &self.sizes
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("mass, {}", ["x", "y"][index])
    }
    fn describe_constraint(&self, _index: usize) -> String {
        "rod".into()
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

/// States of the exact motion at whole multiples of [`EVERY`], by the given gravity (m/s^2).
fn exact(gravity: f64) -> Vec<State> {
    let pendulum = Pendulum::new(DATA[0], DATA[1], gravity).unwrap();
    let times: Vec<f64> = (0..=10).map(|k| EVERY * f64::from(k)).collect();
    let start = pendulum.horizontal_start(SPEED);
    let run = agreed(&pendulum, Explicit::DoPri8, 1e-13, &start, &times, 1e-11).unwrap();
    let states = run.states.iter().zip(times).map(|(y, t)| {
        let motion = pendulum.cartesian(y);
        State {
            t,
            turns: vec![],
            x: motion.position.to_vec(),
            v: motion.velocity.to_vec(),
            a: motion.acceleration.to_vec(),
            lambda: vec![pendulum.multiplier(y)],
        }
    });
    states.collect()
}

/// Largest errors of position, velocity, multiplier.
fn errors(exact: &[State], method: Method, h: f64) -> [f64; 3] {
    let mut system = Cartesian::new();
    let end = exact[exact.len() - 1].t;
    let mut integrator = Integrator::new(&mut system, exact[0].clone(), end, method, fixed(h)).unwrap();
    let (mut errors, mut compared) = ([0.0; 3], 0);
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state();
        let next = &exact[compared + 1];
        if (state.t - next.t).abs() < 1e-10 {
            compared += 1;
            for (error, found) in errors.iter_mut().zip([
                far(&state.x, &next.x),
                far(&state.v, &next.v),
                far(&state.lambda, &next.lambda),
            ]) {
                *error = f64::max(*error, found);
            }
        }
        if stop == Stop::End {
            assert_eq!(compared + 1, exact.len());
            return errors;
        }
    }
}

/// The lowest order seen of each, or which one is below what is expected.
fn check(exact: &[State], method: Method, steps: &[f64], expected: [f64; 3]) -> Result<[f64; 3], String> {
    let table: Vec<[f64; 3]> = steps.iter().map(|&h| errors(exact, method, h)).collect();
    let mut lowest = [f64::INFINITY; 3];
    for kind in 0..3 {
        let column: Vec<f64> = table.iter().map(|row| row[kind]).collect();
        lowest[kind] = orders(&column).into_iter().fold(f64::INFINITY, f64::min);
        if lowest[kind].is_nan() || lowest[kind] < expected[kind] - 0.15 {
            let name = ["positions", "velocities", "multipliers"][kind];
            return Err(format!(
                "{method:?}, {name}: {}, order {:.2}",
                short(&column),
                lowest[kind]
            ));
        }
    }
    println!(
        "pendulum, {method:?}: errors {}, orders {lowest:.2?}",
        short(&table[table.len() - 1])
    );
    Ok(lowest)
}

const RADAU_STEPS: [f64; 3] = [0.05, 0.025, 0.0125];
const ALPHA_STEPS: [f64; 3] = [0.005, 0.0025, 0.00125];

#[test]
fn orders_of_index_3() {
    let exact = exact(DATA[2]);
    check(&exact, Method::Radau, &RADAU_STEPS, [5.0, 3.0, 2.0]).unwrap();
    for alpha in [-0.05, -0.2, -0.3] {
        check(&exact, Method::Hht { alpha }, &ALPHA_STEPS, [2.0; 3]).unwrap();
    }
    for rho_inf in [0.5, 0.7, 0.9] {
        check(&exact, Method::GeneralizedAlpha { rho_inf }, &ALPHA_STEPS, [2.0; 3]).unwrap();
    }
}

#[test]
fn wrong_gravity_is_found_out() {
    let wrong = exact(1.01 * DATA[2]);
    for (method, steps, expected) in [
        (Method::Radau, RADAU_STEPS, [5.0, 3.0, 2.0]),
        (Method::Hht { alpha: -0.3 }, ALPHA_STEPS, [2.0; 3]),
        (Method::GeneralizedAlpha { rho_inf: 0.9 }, ALPHA_STEPS, [2.0; 3]),
    ] {
        let text = check(&wrong, method, &steps, expected).unwrap_err();
        println!("1 % more gravity: {text}");
    }
}
