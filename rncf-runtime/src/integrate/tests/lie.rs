//! The alpha family on a Lie group: heavy top (THEORY 9.7) and free top (THEORY 10, T9).

use super::heavy_top::{OFFSET, REFERENCE, Top, angular, attitude, errors};
use super::swarm::{Swarm, TURN};
use crate::integrate::alpha::Alpha;
use crate::integrate::coefficients::Coefficients;
use crate::integrate::scheme::{Outcome, Scheme};
use crate::integrate::{Integrator, Method, Options, Statistics, StepSize, Stop};
use crate::space::{Matrix, Vector, product, three};
use crate::system::{ConstraintLevel, State, System};

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

/// Position, angular velocity and multipliers of the heavy top.
fn point(state: &State) -> (f64, Vector, Vector, Vector) {
    (state.t, three(&state.x, 0), angular(&state.v), three(&state.lambda, 0))
}

/// Largest violations of position and velocity constraints.
fn violations(top: &mut Top, state: &State) -> [f64; 2] {
    let largest = |y: &[f64]| y.iter().fold(0.0_f64, |largest, c| largest.max(c.abs()));
    let (mut c, mut border) = (vec![0.0; 3], vec![0.0; top.constraint_pattern().entries()]);
    top.constraint(ConstraintLevel::Position, state, &mut c);
    let position = largest(&c);
    top.constraint(ConstraintLevel::Velocity, state, &mut c);
    top.constraint_jacobian(state, &mut border);
    top.constraint_pattern()
        .transpose_multiply_add(1.0, &border, &state.v, &mut c);
    [position, largest(&c)]
}

/// Largest errors of the heavy top at 0.5 s and 1.0 s.
fn heavy_top(method: Method, options: Options) -> ([f64; 3], Statistics) {
    heavy_top_from(Vector::zeros(), method, options)
}

/// The same with unknowns of another point than the centre of mass.
fn heavy_top_from(offset: Vector, method: Method, options: Options) -> ([f64; 3], Statistics) {
    let (mut largest, mut counts) = ([0.0_f64; 3], Statistics::default());
    for reference in &REFERENCE {
        let mut top = Top::heavy_from(offset);
        let start = top.start();
        let mut integrator = Integrator::new(&mut top, start, reference.0, method, options).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        let state = integrator.state().clone();
        let found = errors(&integrator.system().centred(&state), reference);
        largest = std::array::from_fn(|i| largest[i].max(found[i]));
        counts = integrator.statistics().clone();
    }
    (largest, counts)
}

/// Asks for errors that fall by about four with half the step.
fn assert_second_order(what: &str, coarse: [f64; 3], fine: [f64; 3]) {
    for i in 0..3 {
        let ratio = coarse[i] / fine[i];
        assert!(
            (3.3..5.5).contains(&ratio),
            "{what}, variable {i}: {coarse:?} -> {fine:?}"
        );
    }
}

#[test]
fn heavy_top_is_second_order_in_all_variables() {
    for method in METHODS {
        for stabilised in [false, true] {
            let [coarse, fine] = [1e-3, 5e-4].map(|h| heavy_top(method, fixed(h, stabilised)).0);
            assert_second_order(&format!("{method:?}, stabilised: {stabilised}"), coarse, fine);
            assert!(fine[0] < 3e-3 && fine[2] < 3.0, "{method:?}: {fine:?}");
        }
    }
}

#[test]
fn restarts_keep_second_order() {
    for method in METHODS {
        for stabilised in [false, true] {
            let [coarse, fine] = [1e-3, 5e-4].map(|h| {
                let mut top = Top::heavy();
                top.kinks = vec![0.1237, 0.3111, 0.4993];
                let start = top.start();
                let mut integrator = Integrator::new(&mut top, start, 0.5, method, fixed(h, stabilised)).unwrap();
                while integrator.step().unwrap() != Stop::End {}
                assert_eq!(integrator.statistics().restarts, 3);
                errors(integrator.state(), &REFERENCE[0])
            });
            for i in 0..3 {
                assert!(
                    coarse[i] > 3.0 * fine[i],
                    "{method:?}, {stabilised}, variable {i}: {coarse:?} -> {fine:?}"
                );
            }
        }
    }
}

#[test]
fn mass_that_depends_on_the_orientation_is_second_order() {
    for method in METHODS {
        for stabilised in [false, true] {
            let [coarse, fine] = [1e-3, 5e-4].map(|h| heavy_top_from(OFFSET, method, fixed(h, stabilised)).0);
            assert_second_order(&format!("{method:?}, stabilised: {stabilised}"), coarse, fine);
        }
    }
}

#[test]
fn heavy_top_starts_without_a_kick_of_its_multipliers() {
    // Largest errors over the first 40 ms, six radians of spin, against steps that are far smaller.
    let early = |method, h, stabilised| {
        let (mut top, mut fine) = (Top::heavy(), Top::heavy());
        let start = top.start();
        let mut integrator = Integrator::new(&mut top, start.clone(), 0.04, method, fixed(h, stabilised)).unwrap();
        let mut reference = Integrator::new(&mut fine, start, 0.04, METHODS[2], fixed(2e-5, false)).unwrap();
        let mut largest = [0.0_f64; 3];
        while integrator.step().unwrap() != Stop::End {
            while reference.state().t < integrator.state().t - 1e-9 {
                reference.step().unwrap();
            }
            let found = errors(integrator.state(), &point(reference.state()));
            largest = std::array::from_fn(|i| largest[i].max(found[i]));
        }
        largest
    };
    for method in METHODS {
        for stabilised in [false, true] {
            let [coarse, fine] = [1e-3, 5e-4].map(|h| early(method, h, stabilised));
            assert_second_order(&format!("{method:?}, stabilised: {stabilised}"), coarse, fine);
        }
    }
}

#[test]
fn heavy_top_keeps_second_order_while_steps_change() {
    let changing = |coefficients, h: f64, stabilised| {
        let mut top = Top::heavy();
        let (start, mut statistics) = (top.start(), Statistics::default());
        let mut scheme = Alpha::new(&mut top, coefficients, &fixed(h, stabilised));
        let mut fine = Top::heavy();
        let mut start = start;
        let consistent = Integrator::new(&mut fine, start.clone(), 1.0, METHODS[2], fixed(2e-5, false)).unwrap();
        start.clone_from(consistent.state());
        let mut reference = consistent;
        scheme.begin(&mut top, &start, h, &mut statistics).unwrap();
        let mut largest = [0.0_f64; 3];
        for step in 0..40 {
            let h = if (step / 4) % 2 == 0 { h } else { 0.5 * h };
            let outcome = scheme.attempt(&mut top, h, &mut statistics);
            assert!(matches!(outcome, Outcome::Accepted { .. }), "{outcome:?}");
            while reference.state().t < scheme.state().t - 1e-9 {
                reference.step().unwrap();
            }
            let found = errors(scheme.state(), &point(reference.state()));
            largest = std::array::from_fn(|i| largest[i].max(found[i]));
        }
        largest
    };
    for coefficients in [Coefficients::hht(-0.05), Coefficients::generalized_alpha(0.8)] {
        for stabilised in [false, true] {
            let [coarse, fine] = [8e-4, 4e-4].map(|h| changing(coefficients, h, stabilised));
            // Half the steps span half the time: errors may fall faster.
            for i in 0..3 {
                assert!(
                    coarse[i] > 3.0 * fine[i],
                    "{coefficients:?}, variable {i}: {coarse:?} -> {fine:?}"
                );
            }
        }
    }
}

#[test]
fn stabilised_index_2_holds_positions_and_velocities() {
    for method in METHODS {
        let mut top = Top::heavy();
        let start = top.start();
        let mut integrator = Integrator::new(&mut top, start, 0.1, method, fixed(1e-3, true)).unwrap();
        while integrator.step().unwrap() != Stop::End {
            let state = integrator.state().clone();
            let [position, velocity] = violations(integrator.system(), &state);
            assert!(position < 1e-12 && velocity < 1e-10, "{position:e} {velocity:e}");
        }
    }
}

#[test]
fn adaptive_heavy_top_follows_the_tolerance() {
    for method in METHODS {
        for stabilised in [false, true] {
            let at = |rtol| {
                heavy_top(
                    method,
                    Options {
                        rtol,
                        stabilised,
                        ..Options::default()
                    },
                )
            };
            let ((coarse, few), (fine, many)) = (at(1e-5), at(1e-7));
            // A hundredth of the tolerance: 4.6 times the steps, which change by no less than a fifth.
            for i in 0..3 {
                assert!(
                    coarse[i] > 7.0 * fine[i],
                    "{method:?}, {stabilised}, variable {i}: {coarse:?} -> {fine:?}"
                );
            }
            assert!((2.9..7.5).contains(&(many.steps as f64 / few.steps as f64)));
            assert!(many.rejected_steps * 20 < many.steps, "{many:?}");
        }
    }
}

/// The free top about its unstable axis over four seconds, and the largest relative errors of energy
/// and momentum; also the steepest pitch that was seen.
fn tumble(options: Options) -> ([f64; 2], f64) {
    let mut top = Top::free();
    let mut start = State::of(&top, 0.0);
    start.v.copy_from_slice(&[0.3, -0.2, 0.1, 0.05, 4.0, 0.1]);
    let (energy, spin) = (top.energy(&start).unwrap(), top.spin(&start));
    let mut integrator = Integrator::new(&mut top, start, 4.0, METHODS[2], options).unwrap();
    let (mut errors, mut steepest) = ([0.0_f64; 2], 0.0_f64);
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        let a = attitude(&state);
        let unit = a.transpose() * a;
        let rows = (unit - Matrix::identity())
            .row_iter()
            .map(|row| row.norm())
            .fold(0.0, f64::max);
        assert!(rows < 1e-14);
        steepest = steepest.max(a[(2, 0)].abs().min(1.0).asin());
        let top = integrator.system();
        errors[0] = errors[0].max((top.energy(&state).unwrap() / energy - 1.0).abs());
        errors[1] = errors[1].max((top.spin(&state) - spin).norm() / spin.norm());
        if stop == Stop::End {
            return (errors, steepest.to_degrees());
        }
    }
}

#[test]
fn free_top_tumbles_through_steep_pitch() {
    let [(coarse, _), (fine, pitch)] = [5e-3, 2.5e-3].map(|h| tumble(fixed(h, false)));
    assert!(pitch > 88.0, "{pitch}");
    for i in 0..2 {
        assert!(coarse[i] > 3.5 * fine[i] && fine[i] < 2e-4, "{coarse:?} -> {fine:?}");
    }
    let (adaptive, _) = tumble(Options::default());
    assert!(adaptive.iter().all(|error| *error < 1e-3), "{adaptive:?}");
}

#[test]
fn orientations_between_steps_are_as_accurate_as_at_them() {
    let (mut top, mut fine) = (Top::free(), Top::free());
    let mut start = State::of(&top, 0.0);
    start.v.copy_from_slice(&[0.0, 0.0, 0.0, 0.5, 4.0, 1.0]);
    let mut integrator = Integrator::new(&mut top, start.clone(), 1.0, METHODS[2], fixed(0.02, false)).unwrap();
    let mut reference = Integrator::new(&mut fine, start, 1.0, METHODS[2], fixed(5e-4, false)).unwrap();
    let far = |one: &State, other: &State| {
        let (a, b) = (one.orientation(0, 3), other.orientation(0, 3));
        product(&a.inverse(), &b)
            .scaled_axis()
            .norm()
            .max((angular(&one.v) - angular(&other.v)).norm())
    };
    let (mut at_steps, mut between, mut out) = (0.0_f64, 0.0_f64, State::default());
    loop {
        let stop = integrator.step().unwrap();
        for part in [0.25, 0.5, 0.75, 1.0] {
            let (t0, t1) = (integrator.previous_time(), integrator.state().t);
            let t = t0 + part * (t1 - t0);
            while reference.state().t < t - 1e-9 {
                reference.step().unwrap();
            }
            integrator.interpolate(t, &mut out);
            assert_eq!(out.t, t);
            let error = far(&out, reference.state());
            if part == 1.0 {
                assert!(far(&out, integrator.state()) < 1e-14);
                at_steps = at_steps.max(error);
            } else {
                between = between.max(error);
            }
        }
        if stop == Stop::End {
            break;
        }
    }
    assert!(at_steps > 1e-4 && between < 1.1 * at_steps, "{between} {at_steps}");
}

/// The swarm after half a second.
fn swarm(held: bool, method: Method, options: Options) -> (State, Statistics) {
    let mut swarm = Swarm::new(held);
    let start = swarm.start();
    let mut integrator = Integrator::new(&mut swarm, start, 0.5, method, options).unwrap();
    while integrator.step().unwrap() != Stop::End {}
    (integrator.state().clone(), integrator.statistics().clone())
}

#[test]
fn numbers_in_front_of_a_border_are_second_order() {
    // A core with masses on springs: what is free to move against a free frame.
    for held in [false, true] {
        let tight = Options {
            rtol: 1e-11,
            stabilised: held,
            ..Options::default()
        };
        let (exact, _) = swarm(held, Method::Radau, tight);
        let far = |state: &State| {
            let largest = |y: &[f64], z: &[f64]| y.iter().zip(z).map(|(y, z)| (y - z).abs()).fold(0.0, f64::max);
            let (one, other) = (state.orientation(0, TURN), exact.orientation(0, TURN));
            let turned = product(&one.inverse(), &other).scaled_axis().norm();
            [
                turned.max(largest(&state.x[..TURN], &exact.x[..TURN])),
                largest(&state.v, &exact.v),
                largest(&state.a, &exact.a).max(largest(&state.lambda, &exact.lambda)),
            ]
        };
        for method in METHODS {
            for stabilised in [false, true] {
                let [coarse, fine] = [2e-3, 1e-3].map(|h| far(&swarm(held, method, fixed(h, stabilised)).0));
                let what = format!("{method:?}, held: {held}, stabilised: {stabilised}");
                assert_second_order(&what, coarse, fine);
            }
            let (state, counts) = swarm(held, method, Options::default());
            assert!(far(&state)[0] < 1e-3, "{method:?}: {:?}", far(&state));
            // One of them is for the core, whose velocity lasts.
            assert!(counts.newton_iterations < 5 * counts.steps, "{counts:?}");
        }
    }
}
