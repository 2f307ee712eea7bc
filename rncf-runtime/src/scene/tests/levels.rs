//! Levels of the constraints against time differences along a smooth motion.

use super::random::Random;
use super::sections::everything_with_sections;
use crate::model::{Formulation, Scene};
use crate::scene::MeshScene;
use crate::space::{Vector, exp, matrix, product, turned};
use crate::system::{ConstraintLevel, State, System};

const STEP: f64 = 1e-4;

/// Cubic motions of the numbers, and orientations that turn about two axes at a time.
struct Motion {
    start: State,
    rates: [Vec<f64>; 3],
    axes: Vec<[Vector; 2]>,
}

/// Angle, rate and acceleration of the two turnings.
fn angles(t: f64) -> [[f64; 3]; 2] {
    [
        [t + 0.3 * t * t, 1.0 + 0.6 * t, 0.6],
        [0.5 * t - 0.7 * t * t, 0.5 - 1.4 * t, -1.4],
    ]
}

impl Motion {
    fn new(scene: &MeshScene) -> Self {
        let mut random = Random(11);
        let mut start = scene.rest(0.2);
        random.shake(scene, &mut start, 0.2);
        let mut numbers = || (0..start.x.len()).map(|_| random.number()).collect();
        let rates = [numbers(), numbers(), numbers()];
        let mut vector = || Vector::new(random.number(), random.number(), random.number());
        let axes = start.turns.iter().map(|_| [vector(), vector()]).collect();
        Self { start, rates, axes }
    }

    /// State at `s` seconds after the start.
    fn at(&self, scene: &MeshScene, s: f64) -> State {
        let mut state = self.start.clone();
        state.t += s;
        let [first, second, third] = &self.rates;
        for i in 0..state.x.len() {
            state.x[i] += s * (first[i] + s / 2.0 * (second[i] + s / 3.0 * third[i]));
            state.v[i] = first[i] + s * (second[i] + s / 2.0 * third[i]);
            state.a[i] = second[i] + s * third[i];
        }
        for (turn, &unknown) in scene.turns().iter().enumerate() {
            let [a, b] = self.axes[turn];
            let [alpha, beta] = angles(s);
            let second = exp(beta[0] * b);
            state.turns[turn] = product(&turned(&self.start.turns[turn], alpha[0] * a), &second);
            let seen = matrix(&second).tr_mul(&a);
            let spin = alpha[1] * seen + beta[1] * b;
            let turning = -beta[1] * alpha[1] * b.cross(&seen);
            let rate = turning + (alpha[2] * seen + beta[2] * b);
            state.x[unknown..unknown + 3].fill(0.0);
            state.v[unknown..unknown + 3].copy_from_slice(spin.as_slice());
            state.a[unknown..unknown + 3].copy_from_slice(rate.as_slice());
        }
        state
    }

    /// Jerks at `s`.
    fn jerk(&self, scene: &MeshScene, s: f64) -> Vec<f64> {
        let [high, low] = [STEP, -STEP].map(|step| self.at(scene, s + step).a);
        high.iter()
            .zip(&low)
            .map(|(high, low)| (high - low) / (2.0 * STEP))
            .collect()
    }
}

/// Time derivative of the given order of all constraints.
fn derivative(scene: &mut MeshScene, motion: &Motion, s: f64, level: ConstraintLevel) -> Vec<f64> {
    let state = motion.at(scene, s);
    let mut out = vec![0.0; scene.constraints()];
    scene.constraint(level, &state, &mut out);
    let highest = match level {
        ConstraintLevel::Position => return out,
        ConstraintLevel::Velocity => state.v.clone(),
        ConstraintLevel::Acceleration => state.a.clone(),
        ConstraintLevel::Jerk => motion.jerk(scene, s),
    };
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(&state, &mut jacobian);
    scene
        .constraint_pattern()
        .transpose_multiply_add(1.0, &jacobian, &highest, &mut out);
    out
}

#[test]
fn each_level_is_the_time_derivative_of_the_one_before() {
    use ConstraintLevel::{Acceleration, Jerk, Position, Velocity};
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let mut scene = everything_with_sections().scene(formulation);
        let motion = Motion::new(&scene);
        for (lower, level) in [(Position, Velocity), (Velocity, Acceleration), (Acceleration, Jerk)] {
            let exact = derivative(&mut scene, &motion, 0.0, level);
            let [high, low] = [STEP, -STEP].map(|s| derivative(&mut scene, &motion, s, lower));
            for row in 0..exact.len() {
                let expected = (high[row] - low[row]) / (2.0 * STEP);
                assert!(
                    (exact[row] - expected).abs() < 2e-6 * expected.abs().max(1.0),
                    "{formulation:?}, {level:?}, {}: {} instead of {expected}",
                    scene.describe_constraint(row),
                    exact[row]
                );
            }
        }
    }
}

#[test]
fn an_iteration_gets_at_once_what_it_would_get_one_by_one() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let mut scene = everything_with_sections().scene(formulation);
        let motion = Motion::new(&scene);
        let (n, m, entries) = (
            scene.unknowns(),
            scene.constraints(),
            scene.constraint_pattern().entries(),
        );
        let (state, other) = (motion.at(&scene, 0.1), motion.at(&scene, 0.3));
        let (mut residual, mut constraint, mut jacobian) = (vec![0.0; n], vec![0.0; m], vec![0.0; entries]);
        scene.residual(&state, &mut residual);
        scene.constraint(ConstraintLevel::Position, &state, &mut constraint);
        scene.constraint_jacobian(&state, &mut jacobian);
        assert!(
            [&residual, &constraint, &jacobian]
                .iter()
                .all(|all| all.iter().any(|value| *value != 0.0))
        );
        for with_jacobian in [true, false] {
            let (mut found, mut values, mut derivatives) = (vec![1.0; n], vec![1.0; m], vec![1.0; entries]);
            // What another state has left behind.
            scene.equations(&other, &mut found, &mut values, Some(&mut derivatives));
            scene.equations(
                &state,
                &mut found,
                &mut values,
                with_jacobian.then_some(&mut derivatives[..]),
            );
            assert!(found == residual && values == constraint, "{formulation:?}");
            assert_eq!(derivatives == jacobian, with_jacobian, "{formulation:?}");
        }
    }
}
