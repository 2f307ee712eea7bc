//! Orders of convergence under step halving of the soft rotating beams, in all formulations, against the reference by
//! russell_ode; and that a wrong reference is found out.

use rncf::{Formulation, Joints, Method, Model, Scene, State};

use crate::models::{SoftPlanar, SoftSpatial};
use crate::reference::{COMPARISONS, EVERY, Mistake, Reference, START};
use crate::runs::{WAYS, far, fixed, orders, short, states_at};

/// What is compared, in the order of [`Errors`].
const NAMES: [&str; 4] = ["positions", "velocities", "reactions", "multipliers"];

/// Largest errors of nodal vectors, their rates, reactions (outputs), and multipliers.
type Errors = [f64; 4];

/// The orders that a method must show.
type Expected = [f64; 4];

const ALPHA: [Method; 6] = [
    Method::Hht { alpha: -0.05 },
    Method::Hht { alpha: -0.2 },
    Method::Hht { alpha: -0.3 },
    Method::GeneralizedAlpha { rho_inf: 0.5 },
    Method::GeneralizedAlpha { rho_inf: 0.7 },
    Method::GeneralizedAlpha { rho_inf: 0.9 },
];

fn scene(reference: &Reference, (formulation, joints): (Formulation, Joints)) -> Box<dyn Scene> {
    let elements = reference.elements;
    if reference.dimension == 2 {
        let model = SoftPlanar {
            elements,
            ..SoftPlanar::default()
        };
        model.build(formulation, joints).unwrap()
    } else {
        let model = SoftSpatial {
            elements,
            ..SoftSpatial::default()
        };
        model.build(formulation, joints).unwrap()
    }
}

/// Errors against the reference at all its instants, the steps ending there.
fn errors(reference: &Reference, way: (Formulation, Joints), method: Method, h: f64) -> Errors {
    let mut scene = scene(reference, way);
    let times: Vec<f64> = (0..=COMPARISONS).map(|k| START + EVERY * k as f64).collect();
    let start = reference.start(scene.as_ref());
    let (states, _) = states_at(scene.as_mut(), start, method, fixed(h), &times);
    let mut errors = [0.0; 4];
    // The start is the same on both sides.
    for (state, exact) in states.iter().zip(&reference.instants).skip(1) {
        let found = compare(scene.as_mut(), state, reference, exact, way);
        for (error, found) in errors.iter_mut().zip(found) {
            *error = f64::max(*error, found);
        }
    }
    errors
}

fn compare(
    scene: &mut dyn Scene,
    state: &State,
    reference: &Reference,
    exact: &crate::reference::Instant,
    (formulation, joints): (Formulation, Joints),
) -> Errors {
    let frame = scene.frame_state(state);
    let mut outputs = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut outputs);
    let multipliers = exact.multipliers(formulation, joints, reference.dimension);
    [
        far(&frame.q, &exact.q),
        far(&frame.v, &exact.v),
        far(&outputs, &exact.reactions(reference.dimension)),
        far(&state.lambda, &multipliers),
    ]
}

/// Observed orders between the two finest steps, or what misses the expected ones by more than `slack`.
fn check(table: &[Errors], expected: Expected, slack: f64) -> Result<Errors, String> {
    let mut observed = [f64::NAN; 4];
    for (kind, name) in NAMES.iter().enumerate() {
        let column: Vec<f64> = table.iter().map(|errors| errors[kind]).collect();
        if column.iter().all(|&error| error == 0.0) && name == &"multipliers" {
            continue;
        }
        observed[kind] = orders(&column)[column.len() - 2];
        if observed[kind].is_nan() || observed[kind] < expected[kind] - slack {
            return Err(format!(
                "{name}: errors {}, order {:.2}",
                short(&column),
                observed[kind]
            ));
        }
    }
    Ok(observed)
}

fn table(reference: &Reference, way: (Formulation, Joints), method: Method, steps: &[f64]) -> Vec<Errors> {
    steps.iter().map(|&h| errors(reference, way, method, h)).collect()
}

fn show(reference: &Reference, (formulation, joints): (Formulation, Joints), method: Method, h: f64, found: &str) {
    let Reference {
        dimension, elements, ..
    } = reference;
    println!(
        "{dimension}D n={elements} {:4} {joints:?} {method:?} at h = {h}: {found}",
        formulation.name()
    );
}

fn figures(errors: &Errors, orders: &Errors) -> String {
    let pairs: Vec<String> = NAMES
        .iter()
        .zip(errors.iter().zip(orders))
        .map(|(name, (error, order))| format!("{name} {error:.1e} ({order:.2})"))
        .collect();
    pairs.join(", ")
}

/// Every way of every beam by one family of methods.
fn converge(methods: &[Method], steps: &[f64], expected: impl Fn((Formulation, Joints)) -> Expected, slack: f64) {
    for (dimension, elements) in [(2, 1), (2, 3), (3, 1), (3, 3)] {
        // Without damping, the faster bending modes of three elements count.
        let divisor = match (dimension, elements, methods) {
            (3, 3, [Method::Radau]) => 2.0,
            (3, 3, _) => 4.0,
            _ => 1.0,
        };
        let steps: Vec<f64> = steps.iter().map(|h| h / divisor).collect();
        let reference = Reference::new(dimension, elements, Mistake::None);
        println!(
            "reference {dimension}D n={elements}: tolerances agree to {:.1e}",
            reference.agreement
        );
        for way in WAYS {
            for &method in methods {
                let table = table(&reference, way, method, &steps);
                let finest = steps.len() - 1;
                let found = check(&table, expected(way), slack);
                let text = match &found {
                    Ok(orders) => figures(&table[finest], orders),
                    Err(text) => text.clone(),
                };
                show(&reference, way, method, steps[finest], &text);
                assert!(
                    found.is_ok(),
                    "{dimension}D, {elements} elements, {way:?}, {method:?}: {text}"
                );
            }
        }
    }
}

const ALPHA_STEPS: [f64; 3] = [0.005, 0.0025, 0.00125];
const RADAU_STEPS: [f64; 3] = [0.0125, 0.00625, 0.003125];

#[test]
fn alpha_methods_are_second_order() {
    converge(&ALPHA, &ALPHA_STEPS, |_| [2.0; 4], 0.15);
}

/// Conditions that do not move in the coordinates hold at all stages as if they were eliminated: RNCF keeps order 5
/// in everything. In ANCF they turn, and index 3 shows.
fn radau_orders((formulation, _): (Formulation, Joints)) -> Expected {
    match formulation {
        Formulation::Rncf => [5.0; 4],
        Formulation::Ancf => [5.0, 3.0, 2.0, 2.0],
    }
}

#[test]
fn radau_is_of_order_5_and_with_turning_multipliers_of_orders_5_3_2() {
    converge(&[Method::Radau], &RADAU_STEPS, radau_orders, 0.2);
}

#[test]
fn wrong_references_are_found_out() {
    let methods = [
        (Method::Radau, RADAU_STEPS, 0.2),
        (ALPHA[1], ALPHA_STEPS, 0.15),
        (ALPHA[5], ALPHA_STEPS, 0.15),
    ];
    for dimension in [2, 3] {
        for mistake in [Mistake::Axial, Mistake::Bending, Mistake::Radius, Mistake::Coriolis] {
            let wrong = Reference::new(dimension, 1, mistake);
            for way in [WAYS[0], WAYS[3]] {
                for (method, steps, slack) in methods {
                    let expected = if method == Method::Radau {
                        radau_orders(way)
                    } else {
                        [2.0; 4]
                    };
                    let found = check(&table(&wrong, way, method, &steps), expected, slack);
                    let text = match &found {
                        Ok(orders) => format!("not found: {orders:.2?}"),
                        Err(text) => text.clone(),
                    };
                    show(&wrong, way, method, steps[2], &format!("1 % {mistake:?}: {text}"));
                    assert!(
                        found.is_err(),
                        "{dimension}D {way:?} {method:?}: 1 % {mistake:?} passes"
                    );
                }
            }
        }
    }
}
