//! Orders of convergence with fixed and with changing steps (THEORY 10, T1, T2).

use super::systems::{Oscillator, Pendulum};
use crate::integrate::alpha::Alpha;
use crate::integrate::coefficients::Coefficients;
use crate::integrate::scheme::{Outcome, Scheme};
use crate::integrate::{Options, Statistics, StepSize};
use crate::system::{State, System};

fn all() -> [(&'static str, Coefficients); 6] {
    [
        ("hht -0.05", Coefficients::hht(-0.05)),
        ("hht -0.2", Coefficients::hht(-0.2)),
        ("hht -0.3", Coefficients::hht(-0.3)),
        ("rho 0.5", Coefficients::generalized_alpha(0.5)),
        ("rho 0.8", Coefficients::generalized_alpha(0.8)),
        ("rho 0.9", Coefficients::generalized_alpha(0.9)),
    ]
}

/// Largest errors of position, velocity and multiplier.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    x: f64,
    v: f64,
    lambda: f64,
}

impl Errors {
    fn note(&mut self, state: &State, exact: &State) {
        let far = |y: &[f64], z: &[f64]| y.iter().zip(z).map(|(y, z)| (y - z).abs()).fold(0.0, f64::max);
        self.x = self.x.max(far(&state.x, &exact.x));
        self.v = self.v.max(far(&state.v, &exact.v));
        self.lambda = self.lambda.max(far(&state.lambda, &exact.lambda));
    }

    fn worst_ratio(&self, finer: &Errors) -> f64 {
        let ratio = |coarse: f64, fine: f64| if fine == 0.0 { f64::INFINITY } else { coarse / fine };
        ratio(self.x, finer.x)
            .min(ratio(self.v, finer.v))
            .min(ratio(self.lambda, finer.lambda))
    }
}

/// Takes the given steps; `exact` gives the state at the end of each.
fn run<S: System>(
    system: &mut S,
    coefficients: Coefficients,
    start: &State,
    steps: impl IntoIterator<Item = f64>,
    mut exact: impl FnMut(f64) -> State,
) -> Errors {
    let options = Options {
        step: StepSize::Fixed(1.0),
        ..Options::default()
    };
    let mut statistics = Statistics::default();
    let mut scheme = Alpha::new(system, coefficients, &options);
    let mut errors = Errors::default();
    let mut begun = false;
    for h in steps {
        if !begun {
            scheme.begin(system, start, h, &mut statistics).unwrap();
            begun = true;
        }
        let outcome = scheme.attempt(system, h, &mut statistics);
        assert!(matches!(outcome, Outcome::Accepted { .. }), "{outcome:?}");
        errors.note(scheme.state(), &exact(scheme.state().t));
    }
    errors
}

/// The pendulum of T1, T2 over the given steps.
fn pendulum(coefficients: Coefficients, steps: impl IntoIterator<Item = f64>) -> Errors {
    let mut system = Pendulum::at_rest();
    let reference = Pendulum::at_rest();
    let (mut t, mut y) = (0.0, [0.0, -3.0]);
    let start = reference.state(t, y[0], y[1]);
    run(&mut system, coefficients, &start, steps, |at| {
        y = reference.advance(y, t, at);
        t = at;
        reference.state(t, y[0], y[1])
    })
}

fn constant(h: f64, t_end: f64) -> Vec<f64> {
    vec![h; (t_end / h).round() as usize]
}

/// Steps around `h` that change by `ratio` up and down every four steps.
fn alternating(h: f64, ratio: f64, t_end: f64) -> Vec<f64> {
    let (mut steps, mut t) = (vec![], 0.0);
    while t < t_end {
        let h = if (steps.len() / 4) % 2 == 0 { h } else { h / ratio };
        steps.push(h);
        t += h;
    }
    steps
}

/// Steps of random lengths between `h / 2` and `h`.
fn random(h: f64, t_end: f64) -> Vec<f64> {
    let (mut steps, mut t, mut seed) = (vec![], 0.0, 12345_u64);
    while t < t_end {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let step = h * (0.5 + 0.5 * (seed >> 11) as f64 / (1_u64 << 53) as f64);
        steps.push(step);
        t += step;
    }
    steps
}

/// Halves h twice and asks for errors that fall by about four both times.
fn assert_second_order(name: &str, errors: impl Fn(f64) -> Errors) {
    let [coarse, middle, fine] = [0.01, 0.005, 0.0025].map(errors);
    for (one, half) in [(coarse, middle), (middle, fine)] {
        let ratio = one.worst_ratio(&half);
        assert!((3.3..5.5).contains(&ratio), "{name}: {one:?} -> {half:?}");
    }
}

#[test]
fn pendulum_of_index_3_is_second_order_in_all_variables() {
    for (name, method) in all() {
        assert_second_order(name, |h| pendulum(method, constant(h, 1.0)));
    }
}

#[test]
fn step_changes_keep_second_order() {
    for (name, method) in all() {
        for ratio in [1.5, 2.0] {
            assert_second_order(name, |h| pendulum(method, alternating(h, ratio, 1.0)));
        }
    }
}

#[test]
fn random_steps_stay_stable_and_accurate() {
    for (name, method) in all() {
        let [coarse, fine] = [0.01, 0.0025].map(|h| pendulum(method, random(h, 2.0)));
        let ratio = coarse.worst_ratio(&fine);
        // Two halvings; a random sequence is not halved exactly.
        assert!(ratio > 10.0, "{name}: {coarse:?} -> {fine:?}");
        assert!(fine.lambda < 0.02, "{name}: {fine:?}");
    }
}

/// x = cos 2t + t sin t, v and a follow.
fn oscillation(t: f64) -> State {
    State {
        t,
        turns: vec![],
        x: vec![(2.0 * t).cos() + t * t.sin()],
        v: vec![-2.0 * (2.0 * t).sin() + t.sin() + t * t.cos()],
        a: vec![-4.0 * (2.0 * t).cos() + 2.0 * t.cos() - t * t.sin()],
        lambda: vec![],
    }
}

#[test]
fn damped_forced_oscillator_is_second_order() {
    for (name, method) in all() {
        assert_second_order(name, |h| {
            let mut system = Oscillator::new(30.0, 0.7, |t| {
                let exact = oscillation(t);
                exact.a[0] + 0.7 * exact.v[0] + 30.0 * exact.x[0]
            });
            run(
                &mut system,
                method,
                &oscillation(0.0),
                alternating(4.0 * h, 1.5, 3.0),
                oscillation,
            )
        });
    }
}

#[test]
fn stiff_damped_start_does_not_overshoot() {
    // Rates 1e5 and 1e3 per second, a suddenly applied load, steps of 10 ms: x goes to 1.
    for (name, method) in all() {
        let mut system = Oscillator::new(1e8, 1e5, |_| 1e8);
        let options = Options {
            step: StepSize::Fixed(0.01),
            ..Options::default()
        };
        let mut statistics = Statistics::default();
        let mut scheme = Alpha::new(&mut system, method, &options);
        let start = State {
            a: vec![1e8],
            ..State::zeros(0.0, 1, 0)
        };
        scheme.begin(&mut system, &start, 0.01, &mut statistics).unwrap();
        let mut largest = 0.0_f64;
        for _ in 0..100 {
            scheme.attempt(&mut system, 0.01, &mut statistics);
            largest = largest.max((scheme.state().x[0] - 1.0).abs());
        }
        assert!(largest < 100.0, "{name}: {largest}");
        assert!((scheme.state().x[0] - 1.0).abs() < 1e-6, "{name}: {:?}", scheme.state());
    }
}

#[test]
fn hht_satisfies_its_averaged_equation() {
    // THEORY 7.1 in its own words, with a_1 from the update of the position.
    let (alpha, h) = (-0.2, 0.01);
    let beta = (1.0_f64 - alpha) * (1.0 - alpha) / 4.0;
    let force = |t: f64, state: &State| 0.7 * state.v[0] + 30.0 * state.x[0] - t.cos();
    let mut system = Oscillator::new(30.0, 0.7, f64::cos);
    let options = Options {
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let mut statistics = Statistics::default();
    let mut scheme = Alpha::new(&mut system, Coefficients::hht(alpha), &options);
    let start = State {
        a: vec![1.0],
        ..State::zeros(0.0, 1, 0)
    };
    scheme.begin(&mut system, &start, h, &mut statistics).unwrap();
    let (mut last, mut a0) = (start, None::<f64>);
    for _ in 0..20 {
        scheme.attempt(&mut system, h, &mut statistics);
        let now = scheme.state();
        let (dx, dv) = (now.x[0] - last.x[0], now.v[0] - last.v[0]);
        // Without a_0 both updates together give a_0 and a_1.
        let gamma = 0.5 - alpha;
        let mean = 2.0 * (dx - h * last.v[0]) / (h * h);
        let (p, q) = (1.0 - 2.0 * beta, 2.0 * beta);
        let (r, s) = (1.0 - gamma, gamma);
        let a1 = (p * dv / h - r * mean) / (p * s - q * r);
        let first = (s * mean - q * dv / h) / (p * s - q * r);
        if let Some(a0) = a0 {
            assert!((first - a0).abs() < 1e-7, "a_0: {first} {a0}");
        }
        let left = a1 / (1.0 + alpha) + force(now.t, now) - alpha / (1.0 + alpha) * force(last.t, &last);
        assert!(left.abs() < 1e-7, "{left}");
        a0 = Some(a1);
        last = now.clone();
    }
}

/// A pivot that swings with 5 rad/s.
fn swing(t: f64) -> [f64; 4] {
    let (s, c) = (5.0 * t).sin_cos();
    [0.1 * s, 0.5 * c, -2.5 * s, -12.5 * c]
}

#[test]
fn rheonomic_constraint_is_second_order() {
    for (name, method) in all() {
        assert_second_order(name, |h| {
            let (mut system, reference) = (Pendulum::new(swing, vec![]), Pendulum::new(swing, vec![]));
            let (mut t, mut y) = (0.0, [0.0, -3.0]);
            let start = reference.state(t, y[0], y[1]);
            run(&mut system, method, &start, constant(h, 1.0), |at| {
                y = reference.advance(y, t, at);
                t = at;
                reference.state(t, y[0], y[1])
            })
        });
    }
}

#[test]
fn corrected_start_reaches_the_published_accuracy() {
    // THEORY 10, T2: rho = 0.8, largest early error of the multiplier.
    let method = Coefficients::generalized_alpha(0.8);
    for (h, published) in [(0.02, 5.2e-2), (0.01, 9.9e-3), (0.005, 2.5e-3)] {
        let early = pendulum(method, constant(h, 0.1)).lambda;
        assert!((published / 2.0..published * 2.0).contains(&early), "{h}: {early}");
    }
}

#[test]
fn stabilised_start_reaches_the_published_accuracy() {
    // THEORY 7.4: rho = 0.8, largest early error of the multiplier; velocities on the constraints.
    for (h, published) in [(0.02, 4.6e-2), (0.01, 6.5e-3), (0.005, 1.3e-3)] {
        let (mut system, reference) = (Pendulum::at_rest(), Pendulum::at_rest());
        let options = Options {
            step: StepSize::Fixed(h),
            stabilised: true,
            ..Options::default()
        };
        let (mut statistics, mut y) = (Statistics::default(), [0.0, -3.0]);
        let mut scheme = Alpha::new(&mut system, Coefficients::generalized_alpha(0.8), &options);
        let start = reference.state(0.0, y[0], y[1]);
        scheme.begin(&mut system, &start, h, &mut statistics).unwrap();
        let mut early = 0.0_f64;
        for step in 0..(0.1 / h) as usize {
            scheme.attempt(&mut system, h, &mut statistics);
            let state = scheme.state();
            y = reference.advance(y, step as f64 * h, state.t);
            early = early.max((state.lambda[0] - reference.state(state.t, y[0], y[1]).lambda[0]).abs());
            let slip = state.x[0] * state.v[0] + state.x[1] * state.v[1];
            assert!(slip.abs() < 1e-11, "{slip}");
        }
        assert!((published / 2.0..published * 2.0).contains(&early), "{h}: {early}");
    }
}

#[test]
fn corrected_step_change_reaches_the_published_accuracy() {
    // THEORY 10: ratio 1.5 every four steps, h the smaller step.
    let published = [
        (Coefficients::hht(-0.3), [0.082, 0.022, 0.0054]),
        (Coefficients::hht(-0.05), [0.067, 0.016, 0.0041]),
        (Coefficients::generalized_alpha(0.8), [0.058, 0.015, 0.0039]),
        (Coefficients::generalized_alpha(0.9), [0.069, 0.014, 0.0036]),
    ];
    for (method, published) in published {
        for (h, published) in [0.01, 0.005, 0.0025].into_iter().zip(published) {
            let error = pendulum(method, alternating(1.5 * h, 1.5, 1.0)).lambda;
            assert!(
                (published / 2.0..published * 2.0).contains(&error),
                "{method:?}, {h}: {error}, published {published}"
            );
        }
    }
}

#[test]
fn kick_grows_without_dissipation_and_dies_with_it() {
    // THEORY 10, T1: radial velocity 1e-4 at the start, h = 0.01, rho = 1.
    let kicked = |rho: f64, steps: usize| {
        let mut system = Pendulum::at_rest();
        let mut scheme = Alpha::new(
            &mut system,
            Coefficients::generalized_alpha(rho),
            &Options {
                step: StepSize::Fixed(0.01),
                ..Options::default()
            },
        );
        let mut statistics = Statistics::default();
        let reference = Pendulum::at_rest();
        let mut start = reference.state(0.0, 0.0, -3.0);
        start.v[0] += 1e-4;
        scheme.begin(&mut system, &start, 0.01, &mut statistics).unwrap();
        for _ in 0..steps {
            scheme.attempt(&mut system, 0.01, &mut statistics);
        }
        let state = scheme.state();
        let y = reference.advance([0.0, -3.0], 0.0, state.t);
        (state.lambda[0] - reference.state(state.t, y[0], y[1]).lambda[0]).abs()
    };
    // Published 0.5, 5.6, 184 after 2, 20, 100 steps; the growth is what matters.
    let first = kicked(1.0, 2);
    for (steps, published) in [(20, 5.6 / 0.5), (100, 184.0 / 0.5)] {
        let growth = kicked(1.0, steps) / first;
        assert!(
            (published / 2.0..published * 2.0).contains(&growth),
            "{steps}: {growth}"
        );
    }
    assert!(kicked(0.8, 100) < kicked(0.8, 2));
    assert!(kicked(0.8, 100) < 0.05);
}
