//! The alpha family on a Lie group: heavy top (BENCHMARKS 3) and free top (THEORY 10, T9).

use super::heavy_top::{REFERENCE, Top, angular, attitude, errors};
use crate::integrate::{Integrator, Method, Options, StepSize, Stop};
use crate::rotation::Rotation;
use crate::system::{ConstraintLevel, State, System};
use crate::vector::{apply, identity, multiply, norm, subtract, transpose};

const METHODS: [Method; 3] = [
    Method::Hht { alpha: -0.3 },
    Method::Hht { alpha: -0.05 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
];

fn fixed(h: f64, stabilised: bool) -> Options {
    Options {
        step: StepSize::Fixed(h),
        stabilised,
        ..Options::default()
    }
}

/// Largest errors at 0.5 s and 1.0 s.
fn heavy_top(method: Method, options: Options) -> [f64; 3] {
    let mut largest = [0.0_f64; 3];
    for reference in &REFERENCE {
        let mut top = Top::heavy();
        let start = top.start();
        let mut integrator = Integrator::new(&mut top, start, reference.0, method, options).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        println!("{:?}", integrator.statistics());
        let found = errors(integrator.state(), reference);
        largest = std::array::from_fn(|i| largest[i].max(found[i]));
    }
    largest
}

#[test]
fn explore() {
    for method in METHODS {
        for stabilised in [false, true] {
            for h in [0.002, 0.001, 0.0005] {
                println!(
                    "{method:?} {stabilised} {h} {:?}",
                    heavy_top(method, fixed(h, stabilised))
                );
            }
        }
    }
}

#[test]
fn explore_early() {
    // early multipliers against fine run
    for method in METHODS {
        for stabilised in [false, true] {
            for h in [0.002, 0.001, 0.0005] {
                let mut fine = Top::heavy();
                let mut top = Top::heavy();
                let start = top.start();
                let mut integrator =
                    Integrator::new(&mut top, start.clone(), 0.04, method, fixed(h, stabilised)).unwrap();
                let mut reference = Integrator::new(
                    &mut fine,
                    start,
                    0.04,
                    Method::GeneralizedAlpha { rho_inf: 0.8 },
                    fixed(2e-5, false),
                )
                .unwrap();
                let mut worst = [0.0_f64; 3];
                let mut all = vec![];
                loop {
                    let stop = integrator.step().unwrap();
                    while reference.state().t < integrator.state().t - 1e-9 {
                        reference.step().unwrap();
                    }
                    let s = reference.state();
                    let r = (
                        s.t,
                        [s.x[0], s.x[1], s.x[2]],
                        angular(&s.v),
                        [s.lambda[0], s.lambda[1], s.lambda[2]],
                    );
                    let found = errors(integrator.state(), &r);
                    all.push(found[2]);
                    worst = std::array::from_fn(|i| worst[i].max(found[i]));
                    if stop == Stop::End {
                        break;
                    }
                }
                println!("{method:?} {stabilised} {h} {worst:?} {:?}", &all[..6]);
            }
        }
    }
}
