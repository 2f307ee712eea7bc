//! Radau IIA with free orientations: orders, error control, invariants, the stabilised index 2.

use super::heavy_top::{REFERENCE, Top, angular, attitude, errors};
use super::radau::{Single, orders};
use super::systems::Pendulum;
use crate::error::SolveErrorKind;
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::space::{Matrix, Rotation, Vector, matrix, three};
use crate::system::{ConstraintLevel, State, System};

fn fixed(h: f64, stabilised: bool) -> Options {
    Options {
        step: StepSize::Fixed(h),
        stabilised,
        ..Options::default()
    }
}

fn adaptive(rtol: f64, stabilised: bool) -> Options {
    Options {
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
    (integrator.state().clone(), integrator.statistics().clone())
}

/// The heavy top to a reference time: errors of position, angular velocity, multipliers.
fn heavy(reference: usize, options: Options) -> ([f64; 3], Statistics) {
    let mut top = Top::heavy();
    let start = top.start();
    let (state, statistics) = run(&mut top, start, REFERENCE[reference].0, options, |_| {});
    (errors(&state, &REFERENCE[reference]), statistics)
}

/// Asserts the observed order of each column between successive halvings.
fn assert_orders<const N: usize>(rows: &[[f64; N]], least: [f64; N]) {
    for (k, least) in least.into_iter().enumerate() {
        let column: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        println!("{column:?} {:?}", orders(&column));
        assert!(orders(&column).iter().all(|order| *order > least), "column {k}");
    }
}

#[test]
fn heavy_top_of_index_3_converges_with_orders_5_3_2() {
    for reference in [0, 1] {
        let rows = [5e-3, 2.5e-3, 1.25e-3, 6.25e-4].map(|h| heavy(reference, fixed(h, false)).0);
        assert_orders(&rows, [4.7, 2.7, 1.9]);
        assert!(rows[3][0] < 1e-10, "{:?}", rows[3]);
    }
}

#[test]
fn stabilised_heavy_top_converges_with_orders_5_5_3() {
    for reference in [0, 1] {
        let rows = [5e-3, 2.5e-3, 1.25e-3].map(|h| heavy(reference, fixed(h, true)).0);
        assert_orders(&rows, [4.7, 4.7, 2.9]);
    }
}

#[test]
fn steps_of_a_radian_converge() {
    // |w| h = 1.05.
    for stabilised in [false, true] {
        let (errors, statistics) = heavy(1, fixed(7e-3, stabilised));
        assert!(errors[0] < 1e-4, "{errors:?}");
        let (iterations, steps) = (statistics.newton_iterations, statistics.steps);
        println!("{iterations} iterations, {steps} steps");
        assert!(iterations < 25 * steps, "to round-off at a contraction of a fifth");
    }
}

#[test]
fn heavy_top_follows_the_tolerance() {
    for stabilised in [false, true] {
        for (rtol, most) in [(1e-4, 250), (1e-6, 600), (1e-8, 1500), (1e-10, 4000)] {
            let (errors, statistics) = heavy(1, adaptive(rtol, stabilised));
            let (steps, rejected) = (statistics.steps, statistics.rejected_steps);
            println!("{rtol:e} {stabilised}: {errors:?}, {steps} steps, {rejected} rejected");
            assert!(errors[0] < 30.0 * rtol, "{errors:?}");
            assert!(steps < most && rejected < steps / 10, "{statistics:?}");
        }
    }
}

/// Largest velocity of the heavy top's fixed point (m/s) and its largest distance from its place (m).
fn point_slip(stabilised: bool) -> (f64, f64) {
    let mut top = Top::heavy();
    let start = top.start();
    let (mut slip, mut gap) = (0.0_f64, 0.0_f64);
    run(&mut top, start, 0.5, adaptive(1e-6, stabilised), |integrator| {
        let state = integrator.state().clone();
        let arm = attitude(&state) * angular(&state.v).cross(&Vector::y());
        slip = slip.max((three(&state.v, 0) - arm).norm());
        let mut gaps = Vector::zeros();
        integrator
            .system()
            .constraint(ConstraintLevel::Position, &state, gaps.as_mut_slice());
        gap = gap.max(gaps.norm());
    });
    (slip, gap)
}

#[test]
fn stabilised_velocities_stay_on_the_constraints() {
    let ((slip, gap), (free_slip, free_gap)) = (point_slip(true), point_slip(false));
    println!("slip {slip:e}, of index 3 {free_slip:e} m/s; gap {gap:e}, {free_gap:e} m");
    assert!(gap < 1e-7 && free_gap < 1e-7);
    assert!(
        slip < 1e-5 && free_slip > 10.0 * slip,
        "to the tolerance of the iteration"
    );
}

#[test]
fn stabilised_pendulum_converges_with_orders_5_5_3() {
    for motion in [
        |_| [0.0; 4],
        |t: f64| {
            let (s, c) = (3.0 * t).sin_cos();
            [0.1 * s, 0.3 * c, -0.9 * s, -2.7 * c]
        },
    ] {
        let reference = Pendulum::new(motion, vec![]);
        let far = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let rows = [20.0, 40.0, 80.0].map(|steps| {
            let (mut t, mut y, mut largest) = (0.0, [0.0, -3.0], [0.0_f64; 3]);
            let mut pendulum = Pendulum::new(motion, vec![]);
            let begin = reference.state(0.0, 0.0, -3.0);
            run(&mut pendulum, begin, 1.0, fixed(1.0 / steps, true), |integrator| {
                let state = integrator.state();
                y = reference.advance(y, t, state.t);
                t = state.t;
                let exact = reference.state(t, y[0], y[1]);
                let r = [state.x[0] - motion(t)[0], state.x[1]];
                let slip = r[0] * (state.v[0] - motion(t)[1]) + r[1] * state.v[1];
                assert!(slip.abs() < 1e-11, "{slip:e}");
                let errors = [
                    far(&state.x, &exact.x),
                    far(&state.v, &exact.v),
                    far(&state.lambda, &exact.lambda),
                ];
                largest.iter_mut().zip(errors).for_each(|(l, error)| *l = l.max(error));
            });
            largest
        });
        assert_orders(&rows, [4.7, 4.7, 2.7]);
    }
}

/// Inertia of [`Top::free`], kg m^2.
const INERTIA: Vector = Vector::new(1.0, 2.0, 3.0);

/// Angular velocity and orientation of the free top after `t` by fine steps of the classical
/// Runge-Kutta method.
fn tumbled(w: Vector, t: f64) -> (Vector, Matrix) {
    let rate = |(w, a): (Vector, Matrix)| {
        let moment = w.cross(&Vector::from(INERTIA).component_mul(&w));
        let dw = Vector::from_fn(|i, _| -moment[i] / INERTIA[i]);
        (dw, a * w.cross_matrix())
    };
    let moved = |(w, a): (Vector, Matrix), h: f64, (dw, da): (Vector, Matrix)| {
        let w = Vector::from_fn(|i, _| w[i] + h * dw[i]);
        let a = Matrix::from_fn(|i, j| a[(i, j)] + h * da[(i, j)]);
        (w, a)
    };
    let steps = (t / 1e-3).ceil();
    let h = t / steps;
    let mut y = (w, matrix(&Rotation::identity()));
    for _ in 0..steps as usize {
        let k1 = rate(y);
        let k2 = rate(moved(y, 0.5 * h, k1));
        let k3 = rate(moved(y, 0.5 * h, k2));
        let k4 = rate(moved(y, h, k3));
        for (weight, k) in [(1.0, k1), (2.0, k2), (2.0, k3), (1.0, k4)] {
            y = moved(y, weight * h / 6.0, k);
        }
    }
    y
}

/// A tumble about the unstable axis, rad/s.
const TUMBLE: Vector = Vector::new(0.1, 3.0, 0.2);

fn tumbling() -> State {
    let mut state = State::of(&Top::free(), 0.0);
    state.v[3..].copy_from_slice(TUMBLE.as_slice());
    state
}

/// Errors of angular velocity and orientation at the state's time.
fn tumble_errors(state: &State) -> [f64; 2] {
    let (w, a) = tumbled(TUMBLE, state.t);
    let got = attitude(state);
    let apart = (0..9).map(|i| (got[(i / 3, i % 3)] - a[(i / 3, i % 3)]).abs());
    [(angular(&state.v) - w).norm(), apart.fold(0.0, f64::max)]
}

#[test]
fn free_top_converges_with_order_5_and_between_steps_with_4() {
    let mut between = vec![];
    let ends = [20.0, 40.0, 80.0].map(|steps| {
        let mut top = Top::free();
        let mut largest = [0.0_f64; 2];
        let (state, _) = run(&mut top, tumbling(), 4.0, fixed(4.0 / steps, false), |integrator| {
            let mut state = State::default();
            integrator.interpolate(integrator.previous_time() + 1.5 / steps, &mut state);
            let errors = tumble_errors(&state);
            largest.iter_mut().zip(errors).for_each(|(l, error)| *l = l.max(error));
        });
        between.push(largest);
        tumble_errors(&state)
    });
    assert_orders(&ends, [4.7, 4.7]);
    assert_orders(&between, [3.7, 3.7]);
}

#[test]
fn free_top_keeps_its_momentum_and_energy_to_the_tolerance() {
    for rtol in [1e-6, 1e-10] {
        let mut top = Top::free();
        let start = tumbling();
        let (momentum, energy) = (top.spin(&start), top.energy(&start).unwrap());
        let (state, statistics) = run(&mut top, start, 20.0, adaptive(rtol, false), |_| {});
        let drift = (top.spin(&state) - momentum).norm() / momentum.norm();
        let gain = (top.energy(&state).unwrap() / energy - 1.0).abs();
        println!(
            "{rtol:e}: momentum {drift:e}, energy {gain:e}, {} steps",
            statistics.steps
        );
        assert!(drift < 50.0 * rtol && gain < 50.0 * rtol);
    }
}

#[test]
fn mass_that_depends_on_the_state_keeps_order_5() {
    // A bead of 1 kg on y = x^2 / 2: (1 + x^2) x'' + x x'^2 + 9.81 x = 0, against fine steps.
    let bead = || {
        Single::with_mass(
            |x| [1.0 + x * x, 2.0 * x],
            |_, x, v| [x * v * v + 9.81 * x, v * v + 9.81, 2.0 * x * v],
        )
    };
    let begin = || State {
        x: vec![1.0],
        ..State::zeros(0.0, 1, 0)
    };
    let ends: Vec<State> = [20.0, 40.0, 80.0, 320.0]
        .map(|steps| run(&mut bead(), begin(), 2.0, fixed(2.0 / steps, false), |_| {}).0)
        .into();
    let energy = |state: &State| 0.5 * (1.0 + state.x[0].powi(2)) * state.v[0].powi(2) + 4.905 * state.x[0].powi(2);
    assert!((energy(&ends[3]) / 4.905 - 1.0).abs() < 1e-9, "{}", energy(&ends[3]));
    let rows: Vec<_> = ends[..3]
        .iter()
        .map(|end| [(end.x[0] - ends[3].x[0]).abs(), (end.v[0] - ends[3].v[0]).abs()])
        .collect();
    assert_orders(&rows, [4.5, 4.5]);
    let (end, statistics) = run(&mut bead(), begin(), 2.0, adaptive(1e-8, false), |_| {});
    assert!((end.x[0] - ends[3].x[0]).abs() < 1e-7, "{statistics:?}");
}
#[test]
fn coarse_tolerances_find_their_way_back_to_the_constraints() {
    for stabilised in [false, true] {
        for rtol in [1.0, 0.1, 1e-2] {
            let (errors, statistics) = heavy(1, adaptive(rtol, stabilised));
            println!("{rtol:e} {stabilised}: {errors:?}, {} steps", statistics.steps);
            assert!(errors[0] < 0.3 && statistics.max_constraint_residual < 1e-3);
        }
    }
}

#[test]
fn step_beyond_the_chart_is_refused() {
    let mut top = Top::free();
    let mut start = tumbling();
    start.v[3..].copy_from_slice(&[0.0, 0.0, 3.0]);
    let mut integrator = Integrator::new(&mut top, start, 3.0, Method::Radau, fixed(1.5, false)).unwrap();
    let error = integrator.step().unwrap_err();
    assert!(matches!(error.kind, SolveErrorKind::NoConvergence), "{error:?}");
    assert!(
        error.worst.as_ref().is_some_and(|worst| worst.contains("orientation")),
        "{error:?}"
    );
    assert_eq!(integrator.state().t, 0.0);
}
