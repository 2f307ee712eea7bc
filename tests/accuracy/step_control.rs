//! Error over tolerance, and the history of steps: against references that are not ours.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, StepSize, Stop};
use rncf_models::{HeavyTop, SpinUp};

use crate::runs::{adaptive, short};
use crate::{heavy_top, kinks};

const ALPHA: [Method; 3] = [
    Method::Hht { alpha: -0.05 },
    Method::Hht { alpha: -0.3 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
];

/// The centre of mass of the heavy top, m, against the published one.
fn top(method: Method, options: Options) -> f64 {
    heavy_top::errors(method, options)[0]
}

/// A mass on a spring under a load of many switches, m, against the exact motion.
fn switched(method: Method, options: Options) -> f64 {
    kinks::run(method, options).0
}

/// Checks that errors fall from tolerance to tolerance, by the given slope over all of them.
fn check(name: &str, method: Method, rtols: &[f64], slopes: std::ops::Range<f64>, error: impl Fn(f64) -> f64) {
    let errors: Vec<f64> = rtols.iter().map(|&rtol| error(rtol)).collect();
    let last = rtols.len() - 1;
    let slope = (errors[0] / errors[last]).ln() / (rtols[0] / rtols[last]).ln();
    println!("{name}, {method:?}: {} slope {slope:.2}", short(&errors));
    for pair in errors.windows(2) {
        assert!(pair[1] < pair[0], "{name}, {method:?}: {}", short(&errors));
    }
    assert!(
        slopes.contains(&slope),
        "{name}, {method:?}: {} slope {slope:.2}",
        short(&errors)
    );
}

/// Powers of ten.
fn decades(from: i32, to: i32) -> Vec<f64> {
    (from..=to).map(|exponent| 10f64.powi(-exponent)).collect()
}

#[test]
fn errors_fall_over_six_decades_of_the_tolerance() {
    let rtols = decades(3, 9);
    for method in ALPHA {
        check("top", method, &rtols, 0.6..0.75, |rtol| top(method, adaptive(rtol)));
        check("switched", method, &rtols, 0.6..0.75, |rtol| {
            switched(method, adaptive(rtol))
        });
    }
    // Stabilised, 1e-3 is as exact as 1e-4.
    for (stabilised, loosest) in [(false, 3), (true, 4)] {
        check("top", Method::Radau, &decades(loosest, 9), 0.95..1.4, |rtol| {
            let options = Options {
                stabilised,
                ..adaptive(rtol)
            };
            top(Method::Radau, options)
        });
    }
    check("switched", Method::Radau, &rtols, 0.85..1.35, |rtol| {
        switched(Method::Radau, adaptive(rtol))
    });
}

#[test]
fn a_proportional_tolerance_is_met_by_the_error_itself() {
    let options = |rtol| Options {
        proportional: true,
        ..adaptive(rtol)
    };
    // Five decades; sizes of 1 m.
    let rtols = decades(2, 7);
    for method in [ALPHA[0], ALPHA[2]] {
        check("top", method, &rtols, 0.85..1.15, |rtol| top(method, options(rtol)));
        check("switched", method, &rtols, 0.85..1.15, |rtol| {
            switched(method, options(rtol))
        });
        for error in [top(method, options(1e-5)), switched(method, options(1e-5))] {
            let ratio = error / 1e-5;
            assert!((0.05..10.0).contains(&ratio), "{method:?}: {ratio}");
        }
    }
    // Radau's tolerance stays what it is.
    let same = options(1e-6).local_tolerance(Method::Radau);
    assert_eq!(same, 1e-6);
}

/// What a run says of its steps.
struct Steps {
    taken: Vec<f64>,
    /// Times that the step grew after it had shrunk or the other way round, by more than 2 %.
    turns: usize,
    rejected: u64,
    factorizations: u64,
}

fn steps(scene: &mut dyn Scene, method: Method, rtol: f64, end: f64) -> Steps {
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene, start, end, method, adaptive(rtol)).unwrap();
    let (mut taken, mut turns, mut way) = (Vec::new(), 0, 0);
    loop {
        let stop = integrator.step().unwrap();
        let h = integrator.state().t - integrator.previous_time();
        if let Some(&last) = taken.last() {
            let ratio: f64 = h / last;
            let now = i32::from(ratio > 1.02) - i32::from(ratio < 0.98);
            turns += usize::from(now * way < 0);
            way = if now == 0 { way } else { now };
        }
        taken.push(h);
        if stop == Stop::End {
            break;
        }
    }
    Steps {
        taken,
        turns,
        rejected: integrator.statistics().rejected_steps,
        factorizations: integrator.statistics().factorizations,
    }
}

#[test]
fn steps_do_not_chatter() {
    for method in ALPHA.into_iter().chain([Method::Radau]) {
        let mut scene = HeavyTop::default()
            .build(Formulation::Rncf, Joints::Eliminated)
            .unwrap();
        let smooth = steps(scene.as_mut(), method, 1e-7, 0.5);
        println!(
            "top, {method:?}: {} turns of {} steps",
            smooth.turns,
            smooth.taken.len()
        );
        // The last two share what is left.
        assert!(
            smooth.turns <= 3 && smooth.rejected <= 2,
            "{method:?}: {} turns",
            smooth.turns
        );
        // A beam that swings while it is spun up: the error swings, too.
        let model = SpinUp::default();
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let swinging = steps(scene.as_mut(), method, 1e-8, 20.0);
        let count = swinging.taken.len();
        println!(
            "spin-up, {method:?}: {} turns of {count} steps, {} rejected, {} factorizations",
            swinging.turns, swinging.rejected, swinging.factorizations
        );
        assert!(
            swinging.turns * 8 < count,
            "{method:?}: {} turns of {count} steps",
            swinging.turns
        );
        assert!(
            swinging.rejected * 50 < count as u64,
            "{method:?}: {} rejected",
            swinging.rejected
        );
        let jumps = swinging
            .taken
            .windows(2)
            .filter(|pair| pair[1] > 2.1 * pair[0] || pair[1] < 0.4 * pair[0]);
        assert!(jumps.count() <= 12, "{method:?}");
        if method != Method::Radau {
            assert!(swinging.factorizations * 2 < count as u64, "{method:?}");
        }
    }
}

#[test]
fn a_fixed_step_takes_no_notice() {
    let run = |proportional| {
        let options = Options {
            step: StepSize::Fixed(1e-3),
            proportional,
            ..Options::default()
        };
        top(ALPHA[2], options)
    };
    let (plain, proportional) = (run(false), run(true));
    assert!(
        (plain - proportional).abs() < 1e-3 * plain,
        "{plain:e} {proportional:e}"
    );
}
