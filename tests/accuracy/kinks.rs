//! Kinks of motions and loads: where time alone decides they end a step exactly, however the condition is written;
//! where the state decides a step that has passed one is taken back and ends there, if the law tells it.

use std::f64::consts::PI;

use rncf::app::{Judging, RunSettings};
use rncf::linalg::Pattern;
use rncf::system::{Branch, ConstraintLevel, Tangent};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, State, Statistics, Stop, System};

use crate::runs::{adaptive, short};

rncf::model! {
    /// A mass on a spring along x, pushed by a load of many switches.
    pub model Switched {
        param omega = 7 rad/s;
        /// Before t = 1 s the sign of a cosine, then a constant.
        motion nested(t) = if t < 1 s { if cos(5 [rad/s] * t) > 0.3 { 1 } else { -1 } } else { 0.5 };
        /// Periodic, a window by a square, a product, an earlier motion.
        motion push(t) = (if sin(omega * t) > 0 { 2 } else { -1 })
            + (if (t - 0.7 s)^2 <= 0.04 [s^2] { 3 } else { 0 })
            + (if t * (t - 1.23 s) > 0 [s^2] { 1 } else { 0 })
            + nested(t);
        rigid bob { mass = 1 kg; origin = [1, 0, 0] m; }
        spring cord = linear(bob, inertial.at([0, 0, 0] m), stiffness = 9 N/m, length = 1 m);
        load field = gravity([push(t) * 1 [m/s^2], 0, 0]);
        output x = bob.x;
        run { t_end = 4 s; every = 0.1 s; }
    }
}

const END: f64 = 4.0;
const OMEGA: f64 = 7.0;

const METHODS: [Method; 3] = [
    Method::Hht { alpha: -0.05 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
    Method::Radau,
];

/// All times at which the load switches, s.
fn switches() -> Vec<f64> {
    let mut times: Vec<f64> = (1..)
        .map(|k| f64::from(k) * PI / OMEGA)
        .take_while(|t| *t < END)
        .collect();
    // Those of the nested one are found behind t = 1 s, too, where they do no harm.
    let first = 0.3_f64.acos();
    for turn in 0..4 {
        times.extend([first, 2.0 * PI - first].map(|angle| (angle + 2.0 * PI * f64::from(turn)) / 5.0));
    }
    times.extend([0.5, 0.9, 1.0, 1.23]);
    times.retain(|t| *t < END);
    times.sort_by(f64::total_cmp);
    times
}

fn push(t: f64) -> f64 {
    let nested = match t < 1.0 {
        true if (5.0 * t).cos() > 0.3 => 1.0,
        true => -1.0,
        false => 0.5,
    };
    let window = if (t - 0.7).powi(2) <= 0.04 { 3.0 } else { 0.0 };
    let product = if t * (t - 1.23) > 0.0 { 1.0 } else { 0.0 };
    (if (OMEGA * t).sin() > 0.0 { 2.0 } else { -1.0 }) + window + product + nested
}

/// Displacement at a time: `u'' = -9 u + push`, exact between switches.
fn exact(at: f64) -> f64 {
    let mut times = switches();
    times.retain(|t| *t < at);
    times.push(at);
    let ([mut u, mut v], mut t) = ([0.0, 0.0], 0.0);
    for next in times {
        // The middle of what lies between two switches.
        let rest = push(0.5 * (t + next)) / 9.0;
        let (s, c) = (3.0 * (next - t)).sin_cos();
        (u, v) = (rest + (u - rest) * c + v / 3.0 * s, v * c - 3.0 * (u - rest) * s);
        t = next;
    }
    u
}

/// Largest error at the switches and the end, m, and the times at which steps ended at a switch, s.
pub fn run(method: Method, options: Options) -> (f64, Statistics, Vec<f64>) {
    let mut scene = Switched::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), start, END, method, options).unwrap();
    let (mut kinks, mut largest, mut row) = (Vec::new(), 0.0_f64, [0.0]);
    loop {
        let stop = integrator.step().unwrap();
        if stop == Stop::Step {
            continue;
        }
        let state = integrator.state().clone();
        integrator.system().outputs(&state, &mut row);
        largest = largest.max((row[0] - 1.0 - exact(state.t)).abs());
        if stop == Stop::End {
            return (largest, integrator.statistics().clone(), kinks);
        }
        kinks.push(state.t);
    }
}

#[test]
fn switches_of_any_function_of_time_end_a_step() {
    for method in METHODS {
        let (_, statistics, kinks) = run(method, adaptive(1e-6));
        let expected = switches();
        assert_eq!(kinks.len(), expected.len(), "{method:?}: {kinks:?}\n{expected:?}");
        for (found, exact) in kinks.iter().zip(&expected) {
            assert!((found - exact).abs() < 1e-14, "{method:?}: {found} {exact}");
        }
        assert_eq!(statistics.restarts as usize, expected.len());
        assert!(
            statistics.rejected_steps <= 2 * statistics.restarts,
            "{method:?}: {statistics:?}"
        );
    }
}

#[test]
fn the_order_is_kept_across_switches() {
    for (method, slopes) in METHODS.into_iter().zip([0.58..0.75, 0.58..0.75, 0.85..1.5]) {
        let errors: Vec<f64> = [1e-4, 1e-6, 1e-8].map(|rtol| run(method, adaptive(rtol)).0).into();
        let slope = (errors[0] / errors[2]).log10() / 4.0;
        println!("{method:?}: {} slope {slope:.2}", short(&errors));
        assert!(
            slopes.contains(&slope),
            "{method:?}: {} slope {slope:.2}",
            short(&errors)
        );
    }
}

mod blow {
    rncf::model! {
        /// Blows of 15 N s within 3 ns, behind 400 s of a run of 1000 s: by conditions, and by a table.
        pub model Blow {
            table pulse {
                at = t; t = [0 [s], 400 [s], 400.000000001 [s], 400.000000003 [s], 1000 [s]]; f = [0, 0, 10e9, 0, 0] N; interpolation = linear;
            }
            rigid a { plane xy; mass = 5 kg; velocity = [0.1, 0, 0] m/s; }
            load kick = force(a, [if t > 400 s { if t < 400.000000003 s { 5e9 N } else { 0 N } } else { 0 N }, 0 N, 0 N]);
            rigid b { plane xy; mass = 5 kg; velocity = [0.1, 0, 0] m/s; }
            load push = force(b, [pulse.f(t), 0 N, 0 N]);
            output va = a.velocity.x; output vb = b.velocity.x;
            run { t_end = 1000 s; every = 10 s; }
        }
    }
}

/// However long a run is, what acts between two switches acts: kinks within 1e-11 of the run were one, and the blows nothing. Times at 400 s are
/// multiples of 57 fs.
#[test]
fn blows_of_nanoseconds_act_in_a_long_run() {
    for method in METHODS.into_iter().chain([Method::Radau9]) {
        // Of the ramps of the table a method of second order has the tolerance of its steps.
        let bound = if method.adds_up() { 3e-3 } else { 3e-4 };
        let settings = RunSettings {
            method,
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = rncf::app::run(&blow::Blow {}, &settings).unwrap();
        for column in [0, 1] {
            let v = found.history.column(column).last().unwrap();
            assert!((v - 3.1).abs() < bound, "{method:?}: {v}");
        }
    }
}

/// A mass that falls onto a spring without being tied to it: the spring's force has a kink where they meet.
struct Bouncing {
    pattern: Pattern,
    none: Pattern,
    /// Whether it says where its kink is, as generated laws do.
    tells: bool,
}

/// Stiffness over mass, 1/s^2; gravity, m/s^2; height at the start, m.
const STIFF: f64 = 400.0;
const GRAVITY: f64 = 9.81;
const HEIGHT: f64 = 0.5;

impl System for Bouncing {
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
        values.fill(1.0);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        out[0] = state.a[0] + GRAVITY + STIFF * state.x[0].min(0.0);
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        out.mass.fill(1.0);
        out.damping.fill(0.0);
        out.stiffness.fill(if state.x[0] < 0.0 { STIFF } else { 0.0 });
    }
    fn constraint(&mut self, _level: ConstraintLevel, _state: &State, _out: &mut [f64]) {}
    fn constraint_jacobian(&mut self, _state: &State, _values: &mut [f64]) {}
    fn constraint_rate_tangent(&mut self, _state: &State, _values: &mut [f64]) {}
    fn sizes(&self) -> &[f64] {
        &[1.0]
    }
    fn describe_unknown(&self, _index: usize) -> String {
        "height".into()
    }
    fn describe_constraint(&self, _index: usize) -> String {
        String::new()
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn branches(&mut self, state: &State) -> Vec<Branch> {
        if self.tells {
            vec![Branch::Kink(state.x[0])]
        } else {
            vec![]
        }
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

/// Time from the top to the top, s: two falls, and the spring from `v` back to `v`.
fn period() -> f64 {
    let (fall, w) = ((2.0 * HEIGHT / GRAVITY).sqrt(), STIFF.sqrt());
    let speed = GRAVITY * fall;
    // x = -g/k + g/k cos(w t) - v/w sin(w t) comes back to zero.
    2.0 * fall + (2.0 * PI - 2.0 * (speed / w).atan2(GRAVITY / STIFF)) / w
}

#[test]
fn kinks_of_the_state_that_a_law_tells_end_a_step_and_others_are_left_to_the_error_control() {
    for method in METHODS {
        let errors = bounced(method, false);
        assert!(
            errors[2] < errors[1] && errors[1] < errors[0],
            "{method:?}: {}",
            short(&errors)
        );
        assert!(errors[2] < 5e-3 * errors[0], "{method:?}: {}", short(&errors));
        let told = bounced(method, true);
        let parts = if matches!(method, Method::Radau) {
            [1.0, 0.1, 0.01]
        } else {
            [2.0, 1.0, 1.0]
        };
        for ((told, left), part) in told.iter().zip(&errors).zip(parts) {
            assert!(told < &(part * left), "{method:?}: {told:e} {left:e}");
        }
    }
}

/// Errors of height and velocity after four periods at `rtol` 1e-4, 1e-6, 1e-8.
fn bounced(method: Method, tells: bool) -> Vec<f64> {
    let end = 4.0 * period();
    let mut errors = Vec::new();
    for rtol in [1e-4, 1e-6, 1e-8] {
        let mut system = Bouncing {
            pattern: Pattern::new(1, 1, [(0, 0)]),
            none: Pattern::new(1, 0, []),
            tells,
        };
        let mut start = State::of(&system, 0.0);
        start.x[0] = HEIGHT;
        let mut integrator = Integrator::new(&mut system, start, end, method, adaptive(rtol)).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        let statistics = integrator.statistics();
        // Eight kinks.
        println!(
            "{method:?} {rtol:e} {tells}: {} steps, {} rejected",
            statistics.steps, statistics.rejected_steps
        );
        assert!(
            statistics.rejected_steps <= 8 * 14,
            "{method:?} {rtol:e}: {statistics:?}"
        );
        errors.push((integrator.state().x[0] - HEIGHT).abs() + (integrator.state().v[0] / 10.0).abs());
    }
    println!("{method:?} {tells}: {}", short(&errors));
    errors
}
