//! Whole scenes: mass, stiffness, damping and constraint Jacobians against central differences of
//! residual and constraints along right increments.

use rncf::linalg::Pattern;
use rncf::prelude::*;
use rncf::system::{ConstraintLevel, State, Tangent};

/// Difference step relative to the sizes of the unknowns.
const STEP: f64 = 1e-5;

/// A sequence without pattern in [-1, 1], the same on every machine.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// The initial state of a scene, disturbed in everything.
fn disturbed(scene: &mut dyn Scene, part: f64) -> State {
    let mut numbers = Numbers(7);
    let mut state = scene.rest(0.3);
    for index in 0..state.x.len() {
        let size = scene.sizes()[index];
        state.x[index] += 0.02 * part * size * numbers.next();
        state.v[index] += size * numbers.next();
        state.a[index] += size * numbers.next();
    }
    state.rebase(scene.turns());
    for lambda in &mut state.lambda {
        *lambda = numbers.next();
    }
    state
}

/// Residual with constraint forces.
fn forces(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.unknowns()];
    scene.residual(state, &mut out);
    let pattern = scene.constraint_pattern().clone();
    let mut jacobian = vec![0.0; pattern.entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    pattern.multiply_add(1.0, &jacobian, &state.lambda, &mut out);
    out
}

fn constraints(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.constraints()];
    scene.constraint(ConstraintLevel::Position, state, &mut out);
    out
}

/// Total time derivative of the constraints.
fn rates(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.constraints()];
    scene.constraint(ConstraintLevel::Velocity, state, &mut out);
    let pattern = scene.constraint_pattern().clone();
    let mut jacobian = vec![0.0; pattern.entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    pattern.transpose_multiply_add(1.0, &jacobian, &state.v, &mut out);
    out
}

/// Central difference of `of` in one number of the state.
fn difference(
    scene: &mut dyn Scene,
    state: &State,
    h: f64,
    entry: impl Fn(&mut State) -> &mut f64,
    of: impl Fn(&mut dyn Scene, &State) -> Vec<f64>,
) -> Vec<f64> {
    let mut at = |h: f64| {
        let mut moved = state.clone();
        *entry(&mut moved) += h;
        of(scene, &moved)
    };
    let (up, down) = (at(h), at(-h));
    up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * h)).collect()
}

/// Column `column` of a matrix on a pattern.
fn column_of(pattern: &Pattern, values: &[f64], column: usize) -> Vec<f64> {
    let mut out = vec![0.0; pattern.rows()];
    for place in pattern.starts()[column]..pattern.starts()[column + 1] {
        out[pattern.indices()[place]] = values[place];
    }
    out
}

/// Row `row` of the constraint Jacobian's transpose: derivatives of all constraints.
fn row_of(pattern: &Pattern, values: &[f64], row: usize) -> Vec<f64> {
    (0..pattern.columns())
        .map(|column| column_of(pattern, values, column)[row])
        .collect()
}

fn compare(name: &str, what: &str, unknown: &str, ours: &[f64], differences: &[f64], scale: f64, noise: f64) {
    for (row, (a, b)) in ours.iter().zip(differences).enumerate() {
        assert!(
            (a - b).abs() <= 3e-6 * scale + noise,
            "{name}: {what} with respect to {unknown}, row {row}: {a:e} instead of {b:e} (scale {scale:e})"
        );
    }
}

/// Compares all derivatives of the model's scene with its parameters, at a disturbed state.
///
/// # Panics
/// Where one of them is not the derivative, naming it, or where there is no scene.
pub fn compare_tangents<M: Model>(model: &M, formulation: Formulation, joints: Joints) {
    compare_tangents_near(model, formulation, joints, 1.0);
}

/// The same with displacements and differences that are `part` of those: for elements that are shorter than these.
pub fn compare_tangents_near<M: Model>(model: &M, formulation: Formulation, joints: Joints, part: f64) {
    let mut scene = model.build(formulation, joints).expect("the model has a scene");
    let scene = scene.as_mut();
    let state = disturbed(scene, part);
    let name = format!("{} in {}", M::NAME, formulation.name());
    let (pattern, of_constraints) = (scene.pattern().clone(), scene.constraint_pattern().clone());
    let entries = || vec![0.0; pattern.entries()];
    let mut tangent = Tangent {
        mass: entries(),
        stiffness: entries(),
        damping: entries(),
    };
    scene.tangent(&state, &mut tangent);
    let mut mass = entries();
    scene.mass(&state, &mut mass);
    assert_eq!(mass, tangent.mass, "{name}: one mass matrix");
    let (mut jacobian, mut rate_tangent) = (vec![0.0; of_constraints.entries()], vec![0.0; of_constraints.entries()]);
    scene.constraint_jacobian(&state, &mut jacobian);
    scene.constraint_rate_tangent(&state, &mut rate_tangent);
    let largest = |differences: &[f64], ours: &[f64]| -> f64 {
        differences
            .iter()
            .chain(ours)
            .fold(1e-9, |largest: f64, x| largest.max(x.abs()))
    };
    // Large elastic forces cancel in the differences.
    let round_off = 1e-14
        * forces(scene, &state)
            .iter()
            .fold(1.0, |most: f64, force| most.max(force.abs()));
    for column in 0..scene.unknowns() {
        let h = STEP * part * scene.sizes()[column];
        let unknown = scene.describe_unknown(column);
        let verify = |what: &str, ours: Vec<f64>, differences: Vec<f64>| {
            compare(
                &name,
                what,
                &unknown,
                &ours,
                &differences,
                largest(&differences, &ours),
                round_off / h,
            );
        };
        let differences = difference(scene, &state, h, |state| &mut state.a[column], forces);
        verify("mass", column_of(&pattern, &mass, column), differences);
        let differences = difference(scene, &state, h, |state| &mut state.v[column], forces);
        verify("damping", column_of(&pattern, &tangent.damping, column), differences);
        let differences = difference(scene, &state, h, |state| &mut state.x[column], forces);
        verify(
            "stiffness",
            column_of(&pattern, &tangent.stiffness, column),
            differences,
        );
        let differences = difference(scene, &state, h, |state| &mut state.x[column], constraints);
        verify("constraints", row_of(&of_constraints, &jacobian, column), differences);
        let differences = difference(scene, &state, h, |state| &mut state.x[column], rates);
        verify(
            "rates of constraints",
            row_of(&of_constraints, &rate_tangent, column),
            differences,
        );
    }
}
