//! Radau IIA with free orientations: orders, error control, invariants, the stabilised index 2.

use super::heavy_top::{REFERENCE, Top, attitude, errors};
use super::systems::Pendulum;
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::rotation::Rotation;
use crate::system::{ConstraintLevel, State, System};
use crate::vector::{norm, subtract};

fn options(step: StepSize, rtol: f64, stabilised: bool) -> Options {
    Options {
        step,
        rtol,
        stabilised,
        ..Options::default()
    }
}

/// Runs to `t_end` and shows every accepted step.
fn run<S: System>(
    system: &mut S,
    start: State,
    t_end: f64,
    options: Options,
    mut see: impl FnMut(&mut Integrator<S>),
) -> (State, Statistics) {
    let mut integrator = Integrator::new(system, start, t_end, Method::Radau, options).unwrap();
    while integrator.step().unwrap() != Stop::End {
        see(&mut integrator);
    }
    see(&mut integrator);
    (integrator.state().clone(), integrator.statistics().clone())
}

/// The heavy top to a reference time: errors of position, angular velocity, multipliers.
fn heavy(reference: usize, options: Options) -> ([f64; 3], Statistics) {
    let mut top = Top::heavy();
    let start = top.start();
    let (state, statistics) = run(&mut top, start, REFERENCE[reference].0, options, |_| {});
    (errors(&state, &REFERENCE[reference]), statistics)
}

#[test]
fn explore() {
    for stabilised in [false, true] {
        for reference in [0, 1] {
            for h in [1e-2, 5e-3, 2.5e-3, 1.25e-3, 6.25e-4, 3.125e-4] {
                let mut top = Top::heavy();
                let start = top.start();
                let o = options(StepSize::Fixed(h), 1e-6, stabilised);
                let mut integrator = Integrator::new(&mut top, start, REFERENCE[reference].0, Method::Radau, o).unwrap();
                let e = loop {
                    match integrator.step() {
                        Ok(Stop::End) => break true,
                        Ok(_) => {}
                        Err(e) => {
                            println!("{h} {e}");
                            break false;
                        }
                    }
                };
                if e {
                    let s = integrator.statistics();
                    println!(
                        "{stabilised} {h} {:?} it/step {}",
                        errors(integrator.state(), &REFERENCE[reference]),
                        s.newton_iterations as f64 / s.steps as f64
                    );
                }
            }
        }
        for rtol in [1e-4, 1e-6, 1e-8, 1e-10] {
            let (e, s) = heavy(1, options(StepSize::Adaptive, rtol, stabilised));
            println!("{rtol:e} {e:?} {s:?}");
        }
    }
}
