//! A run that is taken up where it was renewed goes on with the same bits, and renewals do not disturb it.

use super::systems::Pendulum;
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::system::State;

const END: f64 = 3.0;
const METHODS: [Method; 4] = [
    Method::Hht { alpha: -0.05 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
    Method::GeneralizedAlpha { rho_inf: 0.0 },
    Method::Radau,
];

/// A pivot that starts to move at 0.7 s and stops at 1.9 s.
fn pendulum() -> Pendulum {
    let motion = |t: f64| match t {
        t if t < 0.7 => [0.0; 4],
        t if t < 1.9 => [0.5 * (t - 0.7).powi(2), t - 0.7, 1.0, 0.0],
        t => [0.72 + 1.2 * (t - 1.9), 1.2, 0.0, 0.0],
    };
    Pendulum::new(motion, vec![0.7, 1.9])
}

fn options(step: StepSize, stabilised: bool, renewed_after: u64) -> Options {
    Options {
        rtol: 1e-5,
        step,
        stabilised,
        renewed_after: Some(renewed_after),
        ..Options::default()
    }
}

/// States at the ends of all steps and half-way, and what each renewal left.
#[derive(Default)]
struct Run {
    states: Vec<State>,
    statistics: Statistics,
    renewed: Vec<(usize, Vec<u8>)>,
}

fn go_on(mut integrator: Integrator<'_, Pendulum>) -> Run {
    let mut run = Run::default();
    loop {
        let stop = integrator.step().unwrap();
        let mut middle = State::of(integrator.system(), 0.0);
        let t = 0.5 * (integrator.previous_time() + integrator.state().t);
        integrator.interpolate(t, &mut middle);
        run.states.extend([middle, integrator.state().clone()]);
        if let Some(bytes) = integrator.renewed()
            && run.renewed.last().is_none_or(|(_, last)| last != bytes)
        {
            run.renewed.push((run.states.len(), bytes.to_vec()));
        }
        if stop == Stop::End {
            run.statistics = integrator.statistics().clone();
            return run;
        }
    }
}

fn run(method: Method, options: Options) -> Run {
    let mut system = pendulum();
    let start = system.state(0.0, -0.3, 0.5);
    go_on(Integrator::new(&mut system, start, END, method, options).unwrap())
}

#[test]
fn a_run_goes_on_from_every_renewal_with_the_same_bits() {
    for (method, stabilised, step) in METHODS.into_iter().flat_map(|method| {
        let steps = [StepSize::Adaptive, StepSize::Fixed(0.011)];
        [false, true]
            .map(|stabilised| steps.map(|step| (method, stabilised, step)))
            .concat()
    }) {
        let options = options(step, stabilised, 100);
        let whole = run(method, options);
        assert!(whole.renewed.len() > 3, "{method:?}: {}", whole.renewed.len());
        for (done, bytes) in &whole.renewed {
            let mut system = pendulum();
            let again = go_on(Integrator::resume(&mut system, bytes, method, options).unwrap());
            assert!(
                again.states == whole.states[*done..],
                "{method:?} {step:?} {stabilised} at {done}"
            );
            assert_eq!(again.statistics, whole.statistics, "{method:?} {step:?} {stabilised}");
        }
    }
}

/// What a renewal forgot would be missed by every step.
#[test]
fn renewals_after_every_step_leave_steps_and_results_as_they_are() {
    for method in METHODS {
        for stabilised in [false, true] {
            let [never, always] =
                [u64::MAX, 1].map(|after| run(method, options(StepSize::Adaptive, stabilised, after)));
            assert!(never.renewed.is_empty());
            let counts = [&never, &always].map(|run| run.statistics.steps as f64);
            assert!((counts[1] / counts[0] - 1.0).abs() < 0.02, "{method:?}: {counts:?}");
            let [one, other] = [&never, &always].map(|run| &run.states[run.states.len() - 1]);
            for i in 0..2 {
                // As far as either is from the exact motion: some 1e-5.
                assert!((one.x[i] - other.x[i]).abs() < 5e-5, "{method:?}: {one:?} {other:?}");
            }
        }
    }
}

#[test]
fn bytes_of_something_else_are_refused() {
    let options = options(StepSize::Adaptive, false, 100);
    let bytes = &run(Method::Radau, options).renewed[0].1;
    for (bytes, method) in [
        (&bytes[..bytes.len() - 8], Method::Radau),
        (&bytes[..], METHODS[0]),
        (&[], Method::Radau),
    ] {
        let mut system = pendulum();
        let error = Integrator::resume(&mut system, bytes, method, options).err().unwrap();
        assert!(error.to_string().contains("not this system or method"), "{error}");
    }
}
