//! T13 of THEORY 10: a start whose multipliers are not those of its loads.

use rncf::linalg::{Pattern, Saddle};
use rncf::system::ConstraintLevel;
use rncf::{Formulation, Integrator, Joints, Method, Model, Scene, State};
use rncf_models::Esail;

use crate::failing::index_3::{Change, Family, Index3};
use crate::pendulum::{self, fixed};

const METHOD: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };

/// A small sail under the thrust that is there from t = 0+ on.
fn sail() -> Box<dyn Scene> {
    let model = Esail {
        tethers: 6,
        elements: 2,
        ..Esail::default()
    };
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// Sets the multipliers to zero; the accelerations follow from the loads alone.
fn without_multipliers(scene: &mut dyn Scene, state: &mut State) {
    let pattern = scene.pattern().clone();
    let mut saddle = Saddle::new(&pattern, scene.border(), &Pattern::new(scene.unknowns(), 0, []));
    let (mut mass, mut force) = (vec![0.0; pattern.entries()], vec![0.0; scene.unknowns()]);
    state.a.fill(0.0);
    state.lambda.fill(0.0);
    scene.mass(state, &mut mass);
    scene.residual(state, &mut force);
    force.iter_mut().for_each(|value| *value = -*value);
    saddle.factor_symmetric(&mass, &[]).unwrap();
    saddle.solve(&mut force, &mut []);
    state.a = force;
}

/// What is left of the equations of motion, and of the constraints' second derivative; their units.
fn residual(scene: &mut dyn Scene, state: &State) -> [f64; 2] {
    let borders = scene.constraint_pattern().clone();
    let mut border = vec![0.0; borders.entries()];
    scene.constraint_jacobian(state, &mut border);
    let (mut force, mut value) = (vec![0.0; scene.unknowns()], vec![0.0; scene.constraints()]);
    scene.residual(state, &mut force);
    borders.multiply_add(1.0, &border, &state.lambda, &mut force);
    scene.constraint(ConstraintLevel::Acceleration, state, &mut value);
    borders.transpose_multiply_add(1.0, &border, &state.a, &mut value);
    [force, value].map(|values| values.iter().fold(0.0, |most: f64, value| most.max(value.abs())))
}

/// The first multiplier after every step of a textbook's method.
fn textbook(scene: &mut dyn Scene, start: &State, family: Family, h: f64) -> Vec<f64> {
    let mut method = Index3::new(scene, start, family, Change::Carried);
    let step = |_| {
        method.step(h).unwrap();
        method.state.lambda[0]
    };
    (0..30).map(step).collect()
}

/// The same by the runtime, in `parts` of a step.
fn ours(scene: &mut dyn Scene, method: Method, h: f64, parts: usize) -> Vec<f64> {
    let rest = scene.rest(0.0);
    let mut integrator = Integrator::new(scene, rest, 1e3, method, fixed(h / parts as f64)).unwrap();
    let step = |_| {
        (0..parts).for_each(|_| {
            integrator.step().unwrap();
        });
        integrator.state().lambda[0]
    };
    (0..30).map(step).collect()
}

fn far(found: &[f64], exact: &[f64]) -> f64 {
    found
        .iter()
        .zip(exact)
        .fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

#[test]
fn multipliers_of_zero_are_paid_for_with_an_impulse() {
    for (name, mut scene, h) in [("pendulum", pendulum::scene(), 0.01), ("sail", sail(), 0.5)] {
        let scene = scene.as_mut();
        let rest = scene.rest(0.0);
        let start = Integrator::new(scene, rest, 1e3, METHOD, fixed(h))
            .unwrap()
            .state()
            .clone();
        let consistent = residual(scene, &start);
        println!(
            "{name}: residual at t = 0+ {:.1e}, {:.1e}",
            consistent[0], consistent[1]
        );
        assert!(consistent[0] < 1e-10 && consistent[1] < 1e-10);
        let mut zero = start.clone();
        without_multipliers(scene, &mut zero);
        let exact = ours(scene, Method::Radau, h, 8);
        let size = start.lambda[0].abs();
        let found = ours(scene, METHOD, h, 1);
        for family in [Family::generalized_alpha(0.8), Family::hht(-0.05)] {
            let spurious = textbook(scene, &zero, family, h);
            let off = [&spurious[..10], &spurious[10..20], &spurious[20..]]
                .iter()
                .enumerate()
                .map(|(part, found)| far(found, &exact[10 * part..]) / size)
                .collect::<Vec<_>>();
            let alternates = spurious
                .iter()
                .zip(&exact)
                .take(6)
                .map(|(a, b)| a > b)
                .collect::<Vec<_>>();
            println!(
                "{name}, {family:?}: off by {off:.2?} of lambda_0 in tens of steps, ours {:.1e}",
                far(&found, &exact) / size
            );
            assert!(off[0] > 0.8, "O(1) at first");
            assert!(off[1] < 0.5 * off[0] && off[1] > 0.05, "for about ten steps");
            assert!(alternates.windows(2).all(|pair| pair[0] != pair[1]), "up and down");
        }
        assert!(far(&found, &exact) < 0.01 * size);
    }
}
