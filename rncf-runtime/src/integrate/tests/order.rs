//! Orders of convergence with fixed and with changing steps (THEORY 10, T1, T2).

use super::systems::{Oscillator, Pendulum};
use crate::integrate::alpha::{Alpha, Coefficients};
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

#[test]
#[ignore]
fn print() {
    for (name, c) in all() {
        for h in [0.02, 0.01, 0.005, 0.0025] {
            let e = pendulum(c, constant(h, 1.0));
            let early = pendulum(c, constant(h, 0.2));
            let a = pendulum(c, alternating(h, 1.5, 1.0));
            let b = pendulum(c, alternating(h, 2.0, 1.0));
            println!(
                "{name} h {h}: x {:.2e} v {:.2e} lam {:.2e} early {:.2e} | 1.5: {:.2e} {:.2e} {:.2e} | 2: {:.2e} {:.2e} {:.2e}",
                e.x, e.v, e.lambda, early.lambda, a.x, a.v, a.lambda, b.x, b.v, b.lambda
            );
        }
    }
    for h in [0.02, 0.01, 0.005] {
        let mut k = 0.0;
        let e: Vec<String> = (1..=20)
            .map(|i| {
                k = i as f64 * 0.05;
                let e = pendulum(all()[5].1, constant(h, k));
                format!("{:.1e}", e.lambda)
            })
            .collect();
        println!("{h}: {}", e.join(" "));
    }
    let mut o = Oscillator::new(1.0, 0.0, |_| 0.0);
    let _ = run(&mut o, all()[0].1, &State::zeros(0.0, 1, 0), [0.1], |t| {
        State::zeros(t, 1, 0)
    })
    .worst_ratio(&Errors::default());
}
