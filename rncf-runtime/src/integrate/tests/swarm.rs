//! Radau with numbers in front of a border: a rigid core with point masses on springs, which move with
//! it, flying freely or held at one mass. Mass depends on the state; momentum and energy are kept.

use super::radau::orders;
use crate::integrate::{Integrator, Method, Options, StepSize, Stop};
use crate::linalg::Pattern;
use crate::space::{Matrix, Vector, matrix, rows, three};
use crate::system::{ConstraintLevel, State, System, Tangent};

/// Core: mass, kg, and principal moments of inertia, kg m^2.
const CORE: f64 = 3.0;
const INERTIA: Vector = Vector::new(0.4, 0.7, 0.9);
/// Point masses, kg; stiffness of their springs, N/m; places, m.
const POINT: f64 = 0.8;
const STIFFNESS: f64 = 300.0;
const PLACES: [Vector; 4] = [
    Vector::new(1.0, 0.0, 0.2),
    Vector::new(-0.4, 0.9, 0.0),
    Vector::new(0.0, -0.5, 0.8),
    Vector::new(-0.3, -0.2, -0.9),
];
/// First unknowns of position and orientation of the core, behind the displacements.
const POSITION: usize = 12;
pub(super) const TURN: usize = 15;
const ALL: usize = 18;
/// Step of difference quotients.
const STEP: f64 = 1e-5;

pub(super) struct Swarm {
    pattern: Pattern,
    constraint_pattern: Pattern,
}

/// Of one point mass: place, velocity and acceleration since the core, all in its axes.
struct Point {
    place: Vector,
    velocity: Vector,
    acceleration: Vector,
}

fn attitude(state: &State) -> Matrix {
    matrix(&state.orientation(0, TURN))
}

fn point(state: &State, index: usize) -> Point {
    let (u, du, ddu) = (
        three(&state.x, 3 * index),
        three(&state.v, 3 * index),
        three(&state.a, 3 * index),
    );
    let (w, dw) = (three(&state.v, TURN), three(&state.a, TURN));
    let place = PLACES[index] + u;
    let carried = dw.cross(&place) + w.cross(&w.cross(&place));
    Point {
        place,
        velocity: du + w.cross(&place),
        acceleration: ddu + (2.0 * w.cross(&du) + carried),
    }
}

impl Swarm {
    pub(super) fn new(held: bool) -> Self {
        let leading = (0..POSITION).map(|i| (i, 3 * (i / 3)));
        let leading = leading.flat_map(|(row, column)| (0..3).map(move |k| (row, column + k)));
        let border = (0..ALL).flat_map(|i| (POSITION..ALL).flat_map(move |j| [(i, j), (j, i)]));
        let rows = (0..3).chain(POSITION..ALL);
        let entries = rows.flat_map(|row| (0..3).map(move |column| (row, column)));
        Self {
            pattern: Pattern::new(ALL, ALL, leading.chain(border)),
            constraint_pattern: if held {
                Pattern::new(ALL, 3, entries)
            } else {
                Pattern::new(ALL, 0, [])
            },
        }
    }

    pub(super) fn start(&self) -> State {
        let mut state = State::of(self, 0.0);
        state.v[TURN..].copy_from_slice(&[2.0, 5.0, -1.0]);
        state.v[3..6].copy_from_slice(&[0.3, 0.0, -0.2]);
        if self.constraints() > 0 {
            let place = -PLACES[0];
            state.x[POSITION..TURN].copy_from_slice(place.as_slice());
            let velocity = three(&state.v, TURN).cross(&place);
            state.v[POSITION..TURN].copy_from_slice(velocity.as_slice());
        }
        state
    }

    /// Angular momentum about the origin, N m s, and energy, J.
    fn invariants(&self, state: &State) -> (Vector, f64) {
        let a = attitude(state);
        let (r, dr, w) = (
            three(&state.x, POSITION),
            three(&state.v, POSITION),
            three(&state.v, TURN),
        );
        let spin = Vector::from_fn(|i, _| INERTIA[i] * w[i]);
        let mut momentum = CORE * r.cross(&dr) + a * spin;
        let mut energy = 0.5 * (CORE * dr.dot(&dr) + w.dot(&spin));
        for index in 0..PLACES.len() {
            let point = point(state, index);
            let (p, dp) = (r + a * point.place, dr + a * point.velocity);
            momentum += POINT * p.cross(&dp);
            let u = three(&state.x, 3 * index);
            energy += 0.5 * (POINT * dp.dot(&dp) + STIFFNESS * u.dot(&u));
        }
        (momentum, energy)
    }

    /// Residual with the forces of the multipliers.
    fn whole(&mut self, state: &State) -> Vec<f64> {
        let mut out = vec![0.0; ALL];
        let mut jacobian = vec![0.0; self.constraint_pattern.entries()];
        self.residual(state, &mut out);
        self.constraint_jacobian(state, &mut jacobian);
        self.constraint_pattern
            .multiply_add(1.0, &jacobian, &state.lambda, &mut out);
        out
    }

    /// Central differences of a function of many values, on the given pattern.
    fn differences(
        &mut self,
        pattern: &Pattern,
        mut of: impl FnMut(&mut Self, &State) -> Vec<f64>,
        moved: impl Fn(usize, f64) -> State,
    ) -> Vec<f64> {
        let mut values = vec![0.0; pattern.entries()];
        for column in 0..pattern.columns() {
            let (up, down) = (of(self, &moved(column, STEP)), of(self, &moved(column, -STEP)));
            for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
                let row = pattern.indices()[entry];
                values[entry] = (up[row] - down[row]) / (2.0 * STEP);
            }
        }
        values
    }
}

/// The state with unknown `i` moved by a right increment.
fn turned(state: &State, i: usize, h: f64) -> State {
    let mut moved = state.clone();
    if i >= TURN {
        moved.rebase(&[TURN]);
    }
    moved.x[i] += h;
    moved
}

impl System for Swarm {
    fn unknowns(&self) -> usize {
        ALL
    }
    fn constraints(&self) -> usize {
        self.constraint_pattern.columns()
    }
    fn turns(&self) -> &[usize] {
        &[TURN]
    }
    fn border(&self) -> usize {
        ALL - POSITION
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, state: &State, values: &mut [f64]) {
        let moved = |i: usize, h: f64| {
            let mut moved = state.clone();
            moved.a.fill(0.0);
            moved.a[i] = h / STEP; // linear
            moved
        };
        let pattern = self.pattern.clone();
        let residual = |system: &mut Self, state: &State| {
            let mut out = vec![0.0; ALL];
            system.residual(state, &mut out);
            out
        };
        let differences = self.differences(&pattern, residual, moved);
        values
            .iter_mut()
            .zip(differences)
            .for_each(|(value, change)| *value = STEP * change);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let a = attitude(state);
        let (ddr, w, dw) = (three(&state.a, POSITION), three(&state.v, TURN), three(&state.a, TURN));
        let times = |u: Vector| -> Vector { Vector::from_fn(|i, _| INERTIA[i] * u[i]) };
        let mut force = CORE * ddr;
        let mut moment = times(dw) + w.cross(&times(w));
        for index in 0..PLACES.len() {
            let point = point(state, index);
            let inertia = POINT * (a.tr_mul(&ddr) + point.acceleration);
            force += a * inertia;
            moment += point.place.cross(&inertia);
            let spring = STIFFNESS * three(&state.x, 3 * index);
            out[3 * index..3 * index + 3].copy_from_slice((inertia + spring).as_slice());
        }
        out[POSITION..TURN].copy_from_slice(force.as_slice());
        out[TURN..].copy_from_slice(moment.as_slice());
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        let pattern = self.pattern.clone();
        let faster = |i: usize, h: f64| {
            let mut moved = state.clone();
            moved.v[i] += h;
            moved
        };
        out.damping = self.differences(&pattern, Self::whole, faster);
        out.stiffness = self.differences(&pattern, Self::whole, |i, h| turned(state, i, h));
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if out.is_empty() {
            return;
        }
        let held = point(state, 0);
        let (w, dw) = (three(&state.v, TURN), three(&state.a, TURN));
        let (du, ddu) = (three(&state.v, 0), three(&state.a, 0));
        let local = match level {
            ConstraintLevel::Position => held.place,
            ConstraintLevel::Velocity => Vector::zeros(),
            ConstraintLevel::Acceleration => 2.0 * w.cross(&du) + w.cross(&w.cross(&held.place)),
            ConstraintLevel::Jerk => {
                let turning = dw.cross(&w.cross(&held.place)) + w.cross(&dw.cross(&held.place));
                let moving = 2.0 * w.cross(&ddu) + (3.0 * dw.cross(&du) + w.cross(&w.cross(&du)));
                w.cross(&held.acceleration) + (turning + moving)
            }
        };
        let r = if level == ConstraintLevel::Position {
            three(&state.x, POSITION)
        } else {
            Vector::zeros()
        };
        out.copy_from_slice((r + attitude(state) * local).as_slice());
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        let a = attitude(state);
        let by_turn = a * (-point(state, 0).place).cross_matrix();
        for (column, values) in values.chunks_exact_mut(9).enumerate() {
            values[..3].copy_from_slice(&rows(&a)[column]);
            values[3..6].fill(0.0);
            values[3 + column] = 1.0;
            values[6..].copy_from_slice(&rows(&by_turn)[column]);
        }
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        let pattern = self.constraint_pattern.clone();
        let rate = |state: &State| three(&state.v, POSITION) + attitude(state) * point(state, 0).velocity;
        for column in 0..pattern.columns() {
            for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
                let at = |h: f64| rate(&turned(state, pattern.indices()[entry], h))[column];
                values[entry] = (at(STEP) - at(-STEP)) / (2.0 * STEP);
            }
        }
    }
    fn sizes(&self) -> &[f64] {
        &[1.0; ALL]
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("swarm, unknown {index}")
    }
    fn describe_constraint(&self, index: usize) -> String {
        format!("held point, {}", ["x", "y", "z"][index])
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn energy(&mut self, state: &State) -> Option<f64> {
        Some(self.invariants(state).1)
    }
}

/// Relative errors of angular momentum and energy after 1 s, and iterations a step.
fn errors(held: bool, options: Options) -> ([f64; 2], f64) {
    let mut swarm = Swarm::new(held);
    let start = swarm.start();
    let (momentum, energy) = swarm.invariants(&start);
    let mut integrator = Integrator::new(&mut swarm, start, 1.0, Method::Radau, options).unwrap();
    while integrator.step().unwrap() != Stop::End {}
    let (state, statistics) = (integrator.state().clone(), integrator.statistics().clone());
    let (end, left) = integrator.system().invariants(&state);
    let drift = (end - momentum).norm() / momentum.norm();
    let iterations = statistics.newton_iterations as f64 / statistics.steps as f64;
    ([drift, (left / energy - 1.0).abs()], iterations)
}

#[test]
fn swarm_keeps_momentum_and_energy_with_order_5() {
    for (held, stabilised) in [(false, false), (true, true)] {
        let rows = [40.0, 80.0, 160.0].map(|steps: f64| {
            let step = StepSize::Fixed(1.0 / steps);
            errors(
                held,
                Options {
                    step,
                    stabilised,
                    ..Options::default()
                },
            )
        });
        println!("{rows:?}");
        for k in 0..2 {
            let column: Vec<f64> = rows.iter().map(|row| row.0[k]).collect();
            println!("{column:?} {:?}", orders(&column));
            assert!(orders(&column).iter().all(|order| *order > 4.5));
        }
        assert!(rows[1].1 < 12.0, "iterations to round-off");
    }
}

#[test]
fn swarm_follows_the_tolerance() {
    for (held, stabilised) in [(false, false), (true, false), (true, true)] {
        for rtol in [1e-5, 1e-8] {
            let (errors, iterations) = errors(
                held,
                Options {
                    rtol,
                    stabilised,
                    ..Options::default()
                },
            );
            println!("{held} {stabilised} {rtol:e}: {errors:?}, {iterations} iterations a step");
            assert!(errors.iter().all(|error| *error < 30.0 * rtol), "{errors:?}");
            assert!(iterations < 4.0, "{iterations}");
        }
    }
}
