//! Every block of the derivatives against central differences of sixth order along right increments.

use super::law::Law;
use super::model::Hand;
use super::random::{Random, moved};
use super::scenery::everything;
use super::sections::everything_with_sections;
use crate::linalg::Pattern;
use crate::model::{Formulation, Scene};
use crate::scene::MeshScene;
use crate::system::{ConstraintLevel, State, System, Tangent};

const STEP: f64 = 1e-3;
const TOLERANCE: f64 = 1e-9;

pub fn dense(pattern: &Pattern, values: &[f64]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; pattern.columns()]; pattern.rows()];
    for column in 0..pattern.columns() {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            matrix[pattern.indices()[place]][column] = values[place];
        }
    }
    matrix
}

/// Residual with the constraint forces.
fn balance(scene: &mut MeshScene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.unknowns()];
    scene.residual(state, &mut out);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    scene
        .constraint_pattern()
        .multiply_add(1.0, &jacobian, &state.lambda, &mut out);
    out
}

/// `C`, and `C_x v + C_t`.
fn constraints(scene: &mut MeshScene, state: &State) -> [Vec<f64>; 2] {
    let zeros = || vec![0.0; state.lambda.len()];
    let (mut values, mut rates) = (zeros(), zeros());
    scene.constraint(ConstraintLevel::Position, state, &mut values);
    scene.constraint(ConstraintLevel::Velocity, state, &mut rates);
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    scene
        .constraint_pattern()
        .transpose_multiply_add(1.0, &jacobian, &state.v, &mut rates);
    [values, rates]
}

/// Derivative at zero; exact up to round-off for polynomials of degree six.
fn difference(mut at: impl FnMut(f64) -> Vec<f64>) -> Vec<f64> {
    let mut sum = Vec::new();
    for (place, weight) in [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)] {
        let [high, low] = [at(place * STEP), at(-place * STEP)];
        sum.resize(high.len(), 0.0);
        for ((sum, high), low) in sum.iter_mut().zip(high).zip(low) {
            *sum += weight * (high - low) / (60.0 * STEP);
        }
    }
    sum
}

/// Compares column `column` of a matrix, relative to its largest entry.
fn compare(what: &str, matrix: &[Vec<f64>], column: usize, expected: &[f64], scene: &MeshScene) {
    let scale = matrix
        .iter()
        .flatten()
        .fold(1.0, |scale: f64, value| scale.max(value.abs()));
    for (row, expected) in expected.iter().enumerate() {
        let error = (matrix[row][column] - expected).abs();
        assert!(
            error < TOLERANCE * scale,
            "{what} ({row}, {column}): {} instead of {expected}; {} by {}",
            matrix[row][column],
            scene.describe_unknown(row.min(scene.unknowns() - 1)),
            scene.describe_unknown(column),
        );
    }
}

pub fn check(hand: Hand, formulation: Formulation, seed: u64) {
    let mut scene = hand.scene(formulation);
    let mut state = scene.rest(0.3);
    Random(seed).shake(&scene, &mut state, 0.2);
    let mut tangent = Tangent::default();
    scene.tangent(&state, &mut tangent);
    let mut mass = vec![0.0; scene.pattern().entries()];
    scene.mass(&state, &mut mass);
    let of = |values: &[f64], scene: &MeshScene| dense(scene.pattern(), values);
    let [by_x, by_v, by_a] = [&tangent.stiffness, &tangent.damping, &tangent.mass].map(|values| of(values, &scene));
    let mass = of(&mass, &scene);
    let mut values = vec![0.0; scene.constraint_pattern().entries()];
    let transposed = |matrix: Vec<Vec<f64>>| -> Vec<Vec<f64>> {
        let columns = matrix.first().map_or(0, Vec::len);
        (0..columns)
            .map(|j| matrix.iter().map(|row| row[j]).collect())
            .collect()
    };
    scene.constraint_jacobian(&state, &mut values);
    let jacobian = transposed(dense(scene.constraint_pattern(), &values));
    scene.constraint_rate_tangent(&state, &mut values);
    let rates = transposed(dense(scene.constraint_pattern(), &values));
    for i in 0..scene.unknowns() {
        for j in 0..scene.unknowns() {
            assert!((mass[i][j] - mass[j][i]).abs() < 1e-12, "mass ({i}, {j})");
            assert!((mass[i][j] - by_a[i][j]).abs() < 1e-12, "masses ({i}, {j})");
        }
        let expected = difference(|step| {
            let moved = moved(&scene, &state, i, step);
            balance(&mut scene, &moved)
        });
        compare("stiffness", &by_x, i, &expected, &scene);
        for (place, (what, matrix)) in [("jacobian", &jacobian), ("rates", &rates)].into_iter().enumerate() {
            let expected = difference(|step| {
                let moved = moved(&scene, &state, i, step);
                constraints(&mut scene, &moved)[place].clone()
            });
            compare(what, matrix, i, &expected, &scene);
        }
        let expected = difference(|step| {
            let mut state = state.clone();
            state.v[i] += step;
            balance(&mut scene, &state)
        });
        compare("damping", &by_v, i, &expected, &scene);
        let expected = difference(|step| {
            let mut state = state.clone();
            state.a[i] += step;
            balance(&mut scene, &state)
        });
        compare("mass", &by_a, i, &expected, &scene);
    }
}

#[test]
fn derivatives_in_referenced_coordinates() {
    check(everything(), Formulation::Rncf, 1);
    check(everything(), Formulation::Rncf, 2);
    check(everything_with_sections(), Formulation::Rncf, 6);
}

#[test]
fn derivatives_in_absolute_coordinates() {
    check(everything(), Formulation::Ancf, 3);
    check(everything(), Formulation::Ancf, 4);
    check(everything_with_sections(), Formulation::Ancf, 7);
}

/// The rate of the energy along any motion is the power of what is out of balance.
#[test]
fn energy_is_the_integral_of_the_residual() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let mut hand = everything_with_sections();
        hand.moving = false;
        hand.conservative = true;
        hand.constraints.clear();
        // Loads along turning axes and moments have no potential.
        hand.loads.truncate(2);
        hand.forces.truncate(2);
        for (spec, law) in &mut hand.forces {
            spec.conservative = true;
            if let Law::Spring(_, _, damping) = law {
                *damping = 0.0;
            }
        }
        let mut scene = hand.scene(formulation);
        let mut state = scene.rest(0.0);
        Random(5).shake(&scene, &mut state, 0.2);
        let along = |step: f64| {
            let mut later = state.clone();
            for i in 0..state.x.len() {
                later.x[i] += step * (state.v[i] + 0.5 * step * state.a[i]);
                later.v[i] += step * state.a[i];
            }
            later
        };
        let energy = |step: f64| vec![scene.energy(&along(step)).expect("nothing takes or gives energy here")];
        let rate = difference(energy)[0];
        let mut residual = vec![0.0; scene.unknowns()];
        scene.residual(&state, &mut residual);
        let power: f64 = residual.iter().zip(&state.v).map(|(r, v)| r * v).sum();
        assert!(
            (rate - power).abs() < 1e-9 * power.abs().max(1.0),
            "{formulation:?}: {rate} {power}"
        );
    }
}
