//! What is put right, and what is refused by name, before the first step.

use super::heavy_top::{Top, attitude};
use super::systems::Pendulum;
use crate::error::{SolveError, SolveErrorKind};
use crate::integrate::{Integrator, Method, Options, StepSize, Stop};
use crate::linalg::Pattern;
use crate::space::{Vector, exp, matrix, three};
use crate::system::{ConstraintLevel, State, System, Tangent};

const METHODS: [Method; 2] = [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }];

/// Masses on springs to their zeros, tied by `rows x = 0`; a mass may be zero.
struct Tied {
    mass: Vec<f64>,
    stiffness: Vec<f64>,
    rows: Vec<(&'static str, Vec<f64>)>,
    sizes: Vec<f64>,
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Tied {
    fn new(mass: &[f64], stiffness: &[f64], rows: &[(&'static str, &[f64])]) -> Self {
        let n = mass.len();
        let full = |columns: usize| (0..n * columns).map(move |place| (place % n, place / n));
        Self {
            mass: mass.to_vec(),
            stiffness: stiffness.to_vec(),
            rows: rows.iter().map(|(name, row)| (*name, row.to_vec())).collect(),
            sizes: vec![1.0; n],
            pattern: Pattern::new(n, n, full(n)),
            constraint_pattern: Pattern::new(n, rows.len(), full(rows.len())),
        }
    }

    fn diagonal(&self, diagonal: &[f64], values: &mut [f64]) {
        values.fill(0.0);
        for (i, value) in diagonal.iter().enumerate() {
            values[i * (diagonal.len() + 1)] = *value;
        }
    }
}

impl System for Tied {
    fn unknowns(&self) -> usize {
        self.mass.len()
    }
    fn constraints(&self) -> usize {
        self.rows.len()
    }
    fn border(&self) -> usize {
        self.mass.len()
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        self.diagonal(&self.mass, values);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        for (i, out) in out.iter_mut().enumerate() {
            *out = self.mass[i] * state.a[i] + self.stiffness[i] * state.x[i];
        }
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        self.diagonal(&self.stiffness, &mut out.stiffness);
        out.damping.fill(0.0);
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        out.fill(0.0);
        if level == ConstraintLevel::Position {
            for (out, (_, row)) in out.iter_mut().zip(&self.rows) {
                *out = row.iter().zip(&state.x).map(|(factor, x)| factor * x).sum();
            }
        }
    }
    fn constraint_jacobian(&mut self, _state: &State, values: &mut [f64]) {
        let entries = self.rows.iter().flat_map(|(_, row)| row);
        values
            .iter_mut()
            .zip(entries)
            .for_each(|(value, entry)| *value = *entry);
    }
    fn constraint_rate_tangent(&mut self, _state: &State, values: &mut [f64]) {
        values.fill(0.0);
    }
    fn sizes(&self) -> &[f64] {
        &self.sizes
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("mass {index}")
    }
    fn describe_constraint(&self, index: usize) -> String {
        self.rows[index].0.into()
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

fn refusal(mut system: Tied) -> SolveError {
    let start = State::of(&system, 0.0);
    Integrator::new(&mut system, start, 1.0, METHODS[0], Options::default())
        .err()
        .expect("must be refused")
}

#[test]
fn redundant_constraints_are_named_with_what_to_weaken() {
    let error = refusal(Tied::new(
        &[1.0; 4],
        &[0.0; 4],
        &[
            ("joint a, x", &[1.0, 0.0, 0.0, 0.0]),
            ("joint free, x", &[0.0, 0.0, 0.0, 1.0]),
            ("joint b, y", &[0.0, 1.0, 0.0, 0.0]),
            ("joint c, slightly", &[1e-3, 1.0, 1.0, 0.0]),
            ("joint c, mostly", &[1.0, 1e-3, 0.0, 0.0]),
        ],
    ));
    let SolveErrorKind::Redundant(text) = &error.kind else {
        panic!("{error:?}")
    };
    assert!(text.contains("one constraint is redundant"), "{text}");
    assert!(
        text.contains("joint c together with joint a and joint b takes the freedom `mostly` twice"),
        "{text}"
    );
    let error = refusal(Tied::new(&[1.0], &[0.0], &[("joint idle, x", &[0.0])]));
    assert!(
        error.to_string().contains("joint idle, x restrains no motion"),
        "{error}"
    );
}

#[test]
fn motion_without_inertia_that_nothing_ties_is_named() {
    // Masses 1 and 2 move against each other without inertia; 0 has mass.
    let error = refusal(Tied::new(
        &[1.0, 0.0, 0.0],
        &[1.0; 3],
        &[("joint a, x", &[0.0, 1.0, 1.0])],
    ));
    let SolveErrorKind::Untied(text) = &error.kind else {
        panic!("{error:?}")
    };
    assert!(text.contains("a motion of mass 1; mass 2 has no inertia"), "{text}");
}

#[test]
fn singular_mass_that_constraints_hold_is_no_obstacle() {
    // x_1 = 2 x_0 carries a spring of 9 / 4 N/m and no mass: x_0 swings with 3 rad/s.
    for method in METHODS {
        for stabilised in [false, true] {
            let error = |h| {
                let mut system = Tied::new(&[1.0, 0.0], &[0.0, 2.25], &[("joint lever, x", &[2.0, -1.0])]);
                let start = State {
                    x: vec![1.0, 2.0],
                    ..State::of(&system, 0.0)
                };
                let options = Options {
                    step: StepSize::Fixed(h),
                    stabilised,
                    ..Options::default()
                };
                let mut integrator = Integrator::new(&mut system, start, 1.0, method, options).unwrap();
                while integrator.step().unwrap() != Stop::End {}
                let state = integrator.state();
                assert!((state.x[1] - 2.0 * state.x[0]).abs() < 1e-13);
                // lambda holds the spring: -lambda + 2.25 x_1 = 0
                let force = (state.lambda[0] - 4.5 * 3.0_f64.cos()).abs();
                force.max((state.x[0] - 3.0_f64.cos()).abs())
            };
            let (coarse, fine) = (error(0.02), error(0.01));
            assert!((3.5..4.5).contains(&(coarse / fine)), "{method:?}: {coarse} {fine}");
        }
    }
}

#[test]
fn small_violations_are_projected_and_reported() {
    let mut top = Top::heavy();
    let mut start = top.start();
    start.turns[0] = exp(Vector::new(0.3, -0.2, 0.5));
    let arm = matrix(&start.turns[0]) * Vector::y();
    for i in 0..3 {
        start.x[i] = arm[i] + [3e-3, -2e-3, 1e-3][i];
    }
    let spin = Vector::new(0.0, 150.0, -4.61538);
    let velocity = matrix(&start.turns[0]) * spin.cross(&Vector::y());
    for i in 0..3 {
        start.v[i] = velocity[i] + 1e-2;
    }
    let integrator = Integrator::new(&mut top, start, 1.0, METHODS[1], Options::default()).unwrap();
    let counts = integrator.statistics().clone();
    assert!((5e-4..3e-3).contains(&counts.position_correction), "{counts:?}");
    assert!((5e-3..2e-2).contains(&counts.velocity_correction), "{counts:?}");
    let state = integrator.state();
    let arm = attitude(state) * Vector::y();
    assert!((arm - three(&state.x, 0)).norm() < 1e-14);
    // The arm moved the least: position and orientation share the correction.
    assert!((arm - matrix(&exp(Vector::new(0.3, -0.2, 0.5))) * Vector::y()).norm() > 1e-4);
}

#[test]
fn large_violations_name_the_constraint() {
    let start = || Pendulum::at_rest().state(0.0, 0.0, -3.0);
    let (mut long, mut radial) = (start(), start());
    long.x[0] = 1.05;
    radial.v[0] = 0.1;
    for (state, size, worst) in [(long, 0.05125, "rod"), (radial, 0.1, "the rate of rod")] {
        let mut system = Pendulum::at_rest();
        let error = Integrator::new(&mut system, state, 1.0, METHODS[0], Options::default())
            .err()
            .expect("must be refused");
        assert!(
            matches!(error.kind, SolveErrorKind::Inconsistent(found) if (found - size).abs() < 1e-6),
            "{error:?}"
        );
        assert_eq!(error.worst.as_deref(), Some(worst));
    }
}

#[test]
fn orientations_of_the_wrong_number_are_refused() {
    let mut top = Top::heavy();
    let start = State {
        turns: vec![],
        ..top.start()
    };
    let error = Integrator::new(&mut top, start, 1.0, METHODS[0], Options::default()).err();
    assert!(error.unwrap().to_string().contains("0 orientations"));
}
