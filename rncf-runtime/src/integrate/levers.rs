//! Translation of poses that turn, by the motion of their centres of mass.
//!
//! The update formulas of the alpha family are exact to second order for each unknown by itself. Where the centre of mass circles about the
//! origin of a pose, at the end of an arm c, both the origin's acceleration and the way R c to the centre change with the turning; the errors of the
//! two do not cancel, and what is left is an impulse that nothing exerts, in the same direction step after step. What is free has its momentum at the
//! centre: the formulas are therefore applied to `x + R c`, and the origin follows. With L = R c, known from the rotation and from the
//! unknowns of what deforms in the axes of the pose, in which c is linear, this is the update of x and
//!
//! ```text
//! x += L_0 + h L'_0 + h^2 ((1/2 - beta) A_0 + beta A_1) - L_1
//! v += L'_0 + h ((1 - gamma) A_0 + gamma A_1) - L'_1
//! ```
//!
//! with the algorithmic accelerations A of L, which follow from L'' as those of the unknowns from theirs. What it adds is of third order in h, and nothing where the
//! rotation stays. Its derivatives are h times the angular velocity smaller than those of L: the matrix of the iteration stays as it is.
//!
//! In the same way angular velocities in body axes turn where angular momentum does not. With the inertia J that the pose carries at the start, about its
//! centre, the formulas are applied to the angular momentum H = R J w instead of w; `w_1 = J^-1 R_1^T H_1`. (With what deformations have of it
//! to first order, the angular momentum of a bent rod on its chord was no better.)

use super::coefficients::Coefficients;
use super::compensated::{self, Low};
use crate::archive::{Archive, Keep};
use crate::space::{Matrix, Vector, exp, from_rows, matrix, three, turned};
use crate::system::{Carried, Lever, State, System, Turning};

/// Values for every position with a lever: of L, L' and L''.
type Motion = [Vec<f64>; 3];

/// Levers of the free poses and their update.
pub(super) struct Levers {
    coefficients: Coefficients,
    list: Vec<Lever>,
    /// First unknown of every orientation.
    turns: Vec<usize>,
    /// L at the start of the step, and at the end in the present iterate.
    start: Motion,
    end: Motion,
    /// Algorithmic accelerations at both ends.
    from: Vec<f64>,
    to: Vec<f64>,
    /// What is in the present iterate's positions and velocities.
    applied: [Vec<f64>; 2],
    /// (A - L'') / h at the last accepted state.
    offset: Vec<f64>,
    /// L' and A as the last step left them.
    left: [Vec<f64>; 2],
    spins: Vec<Spin>,
}

/// The angular momentum of one of them in a step, all in the axes of its start.
#[derive(Clone, Debug, Default)]
struct Spin {
    /// Index in the list, and first unknown of the orientation.
    lever: usize,
    first: usize,
    /// Angular momentum from which the step starts, rate of the true one.
    momentum: Vector,
    rate: Vector,
    /// Algorithmic rates at both ends.
    from: Vector,
    to: Vector,
    /// (algorithmic rate - true one) / h at the last accepted state, body axes.
    offset: Vector,
    /// Algorithmic rate as the last step left it, body axes.
    left: Vector,
}

impl Keep for Levers {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        archive.fixed(&mut self.offset);
        for values in &mut self.left {
            archive.fixed(values);
        }
        for spin in &mut self.spins {
            spin.offset.keep(archive);
            spin.left.keep(archive);
        }
    }
}

impl Levers {
    pub(super) fn new(system: &mut dyn System, coefficients: Coefficients) -> Self {
        let list = system.levers();
        let turns = system.turns().to_vec();
        let spin = |(lever, of): (usize, &Lever)| match of.turning {
            Turning::Orientation { index } if of.inertia.is_some() => Some(Spin {
                lever,
                first: turns[index],
                ..Spin::default()
            }),
            _ => None,
        };
        let count = list.iter().map(|lever| lever.positions.len()).sum();
        let zeros = || vec![0.0; count];
        let motion = || [zeros(), zeros(), zeros()];
        Self {
            coefficients,
            spins: list.iter().enumerate().filter_map(spin).collect(),
            turns,
            start: motion(),
            end: motion(),
            from: zeros(),
            to: zeros(),
            applied: [zeros(), zeros()],
            offset: zeros(),
            left: [zeros(), zeros()],
            list,
        }
    }

    /// Begins anew at a state; `later` is the same state a short time `dt` (s) later.
    pub(super) fn begin(&mut self, now: &State, later: &State, dt: f64) {
        motion(&self.list, &self.turns, now, &mut self.start);
        motion(&self.list, &self.turns, later, &mut self.end);
        let shift = self.coefficients.shift();
        for (at, offset) in self.offset.iter_mut().enumerate() {
            *offset = shift * (self.end[2][at] - self.start[2][at]) / dt;
        }
        for spin in &mut self.spins {
            let lever = &self.list[spin.lever];
            let [before, behind] = [now, later].map(|state| spin.rate_at(lever, state));
            let behind = spin.to_start(later, behind);
            spin.offset = shift / dt * (behind - before);
        }
    }

    /// What a step of size `h` from `now` with the velocities `v` starts from; `goes_on`: with what the last one, of the same size, left.
    pub(super) fn prepare(&mut self, now: &State, v: &[f64], h: f64, goes_on: bool) {
        motion(&self.list, &self.turns, now, &mut self.start);
        for spin in &mut self.spins {
            let lever = &self.list[spin.lever];
            spin.rate = spin.rate_at(lever, now);
            spin.momentum = inertia(lever)[0] * three(v, spin.first);
            spin.from = if goes_on {
                spin.left
            } else {
                spin.rate + h * spin.offset
            };
        }
        if goes_on {
            self.start[1].copy_from_slice(&self.left[0]);
            self.from.copy_from_slice(&self.left[1]);
            return;
        }
        for (at, from) in self.from.iter_mut().enumerate() {
            *from = self.start[2][at] + h * self.offset[at];
        }
    }

    /// Nothing is in the iterate yet.
    pub(super) fn predict(&mut self) {
        self.applied.iter_mut().for_each(|values| values.fill(0.0));
    }

    /// Brings positions and velocities of the origins to the rotations of the iterate.
    pub(super) fn correct(&mut self, h: f64, state: &mut State, low: &mut Low) {
        if self.list.is_empty() {
            return;
        }
        motion(&self.list, &self.turns, state, &mut self.end);
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = self.coefficients;
        let unknowns = self.list.iter().flat_map(|lever| &lever.positions);
        for (at, &(unknown, _)) in unknowns.enumerate() {
            let ([x0, v0, a0], [x1, v1, a1]) =
                ([0, 1, 2].map(|k| self.start[k][at]), [0, 1, 2].map(|k| self.end[k][at]));
            let from = self.from[at];
            let to = ((1.0 - alpha_f) * a1 + alpha_f * a0 - alpha_m * from) / (1.0 - alpha_m);
            self.to[at] = to;
            let shift = (x0 - x1) + h * (v0 + h * ((0.5 - beta) * from + beta * to));
            let speed = (v0 - v1) + h * ((1.0 - gamma) * from + gamma * to);
            compensated::add(&mut state.x[unknown], &mut low.x[unknown], shift - self.applied[0][at]);
            compensated::add(&mut state.v[unknown], &mut low.v[unknown], speed - self.applied[1][at]);
            self.applied[0][at] = shift;
            self.applied[1][at] = speed;
        }
        for spin in &mut self.spins {
            let lever = &self.list[spin.lever];
            let rate = spin.to_start(state, spin.rate_at(lever, state));
            let known = alpha_f * spin.rate - alpha_m * spin.from;
            spin.to = 1.0 / (1.0 - alpha_m) * ((1.0 - alpha_f) * rate + known);
            let gained = (1.0 - gamma) * spin.from + gamma * spin.to;
            let momentum = spin.momentum + h * gained;
            let speed = inertia(lever)[1] * spin.to_end(state, momentum);
            for axis in 0..3 {
                let at = spin.first + axis;
                let change = speed[axis] - state.v[at] - low.v[at];
                compensated::add(&mut state.v[at], &mut low.v[at], change);
            }
        }
    }

    /// A step of size `h` was accepted at `state`, the one that [`Levers::correct`] saw last.
    pub(super) fn accept(&mut self, h: f64, state: &State) {
        for spin in &mut self.spins {
            spin.left = spin.to_end(state, spin.to);
            let rate = spin.rate_at(&self.list[spin.lever], state);
            spin.offset = 1.0 / h * (spin.left - rate);
        }
        self.left[0].copy_from_slice(&self.end[1]);
        self.left[1].copy_from_slice(&self.to);
        for (at, offset) in self.offset.iter_mut().enumerate() {
            *offset = (self.to[at] - self.end[2][at]) / h;
        }
    }
}

impl Spin {
    /// Rate of the angular momentum at a state, body axes.
    fn rate_at(&self, lever: &Lever, state: &State) -> Vector {
        let [inertia, _] = inertia(lever);
        let spin = three(&state.v, self.first);
        inertia * three(&state.a, self.first) + spin.cross(&(inertia * spin))
    }

    /// A vector in the body axes of a state within the step, in those of the start.
    fn to_start(&self, state: &State, vector: Vector) -> Vector {
        self.turned(state) * vector
    }

    fn to_end(&self, state: &State, vector: Vector) -> Vector {
        self.turned(state).tr_mul(&vector)
    }

    /// Rotation since the start of the step, where the chart begins.
    fn turned(&self, state: &State) -> Matrix {
        matrix(&exp(three(&state.x, self.first)))
    }
}

/// The inertia of a lever that has one.
fn inertia(lever: &Lever) -> &[Matrix; 2] {
    const ZERO: Matrix = from_rows(&[[0.0; 3]; 3]);
    const NONE: [Matrix; 2] = [ZERO; 2];
    lever.inertia.as_ref().unwrap_or(&NONE)
}

/// Way to the centre of mass at a state, and its rates, in the axes of the pose.
fn arm(lever: &Lever, state: &State) -> [Vector; 3] {
    let mut ways = [lever.arm, Vector::zeros(), Vector::zeros()];
    for Carried { unknown, start, way } in &lever.carried {
        let values = [state.x[*unknown] - start, state.v[*unknown], state.a[*unknown]];
        for (sum, value) in ways.iter_mut().zip(values) {
            *sum += value * way;
        }
    }
    ways
}

/// L, L' and L'' at a state.
fn motion(list: &[Lever], turns: &[usize], state: &State, out: &mut Motion) {
    let mut at = 0;
    for lever in list {
        let (rotation, spin, rate): (_, Vector, Vector) = match lever.turning {
            Turning::Orientation { index } => {
                let first = turns[index];
                let at = |y: &[f64]| three(y, first);
                (turned(&state.turns[index], at(&state.x)), at(&state.v), at(&state.a))
            }
            Turning::Angle { unknown, axis, base } => (
                turned(&base, state.x[unknown] * axis),
                state.v[unknown] * axis,
                state.a[unknown] * axis,
            ),
        };
        let matrix = matrix(&rotation);
        let [arm, moving, gaining] = arm(lever, state);
        let carried = spin.cross(&arm);
        let gaining = gaining + rate.cross(&arm) + spin.cross(&(carried + 2.0 * moving));
        let ways = [arm, carried + moving, gaining];
        let ways = ways.map(|way| matrix * way);
        for (_, direction) in &lever.positions {
            for (values, way) in out.iter_mut().zip(ways) {
                values[at] = direction.dot(&way);
            }
            at += 1;
        }
    }
}
