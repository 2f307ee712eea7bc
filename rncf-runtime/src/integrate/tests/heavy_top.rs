//! Heavy top of THEORY 9.7 and the free top: a free frame of six unknowns, reference point r and
//! orientation A, written by hand. The reference point is the centre of mass, or off it: then the mass
//! depends on the orientation.

use crate::linalg::Pattern;
use crate::space::{Matrix, Vector, exp, matrix, rows, three};
use crate::system::{ConstraintLevel, State, System, Tangent};

/// Gravity, m/s^2.
const GRAVITY: Vector = Vector::new(0.0, 0.0, -9.81);
/// Fixed point to centre of mass, body axes, m.
const ARM: Vector = Vector::new(0.0, 1.0, 0.0);

/// An offset of the reference point in no special direction, m.
pub(super) const OFFSET: Vector = Vector::new(0.3, -0.2, 0.4);

/// A rigid body whose point `r - A (ARM + offset)` is held at the origin, or one that flies freely.
pub(super) struct Top {
    mass: f64,
    /// Principal moments of inertia about the centre of mass, kg m^2.
    inertia: Vector,
    /// Centre of mass to reference point, body axes, m.
    offset: Vector,
    gravity: Vector,
    /// Times at which integrators begin anew, s.
    pub(super) kinks: Vec<f64>,
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Top {
    /// The heavy top: C = r - A X, three constraints.
    pub(super) fn heavy() -> Self {
        let arm_rows = (0..3).flat_map(|j| (0..3).map(move |i| (3 + i, j)));
        Self::new(
            Vector::new(0.234375, 0.46875, 0.234375),
            GRAVITY,
            3,
            (0..3).map(|j| (j, j)).chain(arm_rows),
        )
    }

    /// The heavy top with unknowns of another point: `r = centre + A offset`.
    pub(super) fn heavy_from(offset: Vector) -> Self {
        Self {
            offset,
            ..Self::heavy()
        }
    }

    /// A free asymmetric top without loads.
    pub(super) fn free() -> Self {
        Self::new(Vector::new(1.0, 2.0, 3.0), Vector::zeros(), 0, [])
    }

    fn new(
        inertia: Vector,
        gravity: Vector,
        constraints: usize,
        entries: impl IntoIterator<Item = (usize, usize)>,
    ) -> Self {
        Self {
            mass: 15.0,
            inertia,
            offset: Vector::zeros(),
            gravity,
            kinks: vec![],
            pattern: Pattern::new(6, 6, (0..36).map(|place| (place / 6, place % 6))),
            constraint_pattern: Pattern::new(6, constraints, entries),
        }
    }

    /// State of the heavy top at t = 0.
    pub(super) fn start(&self) -> State {
        let mut state = State::of(self, 0.0);
        let w = Vector::new(0.0, 150.0, -4.61538);
        state.x[..3].copy_from_slice(self.arm().as_slice());
        state.v[..3].copy_from_slice((Vector::new(4.61538, 0.0, 0.0) + w.cross(&self.offset)).as_slice());
        state.v[3..].copy_from_slice(w.as_slice());
        state
    }

    /// Fixed point to reference point, body axes, m.
    fn arm(&self) -> Vector {
        ARM + self.offset
    }

    /// The state with the centre of mass in place of the reference point.
    pub(super) fn centred(&self, state: &State) -> State {
        let mut centred = state.clone();
        let offset = attitude(state) * self.offset;
        centred.x[..3].copy_from_slice((three(&state.x, 0) - offset).as_slice());
        centred
    }

    /// Acceleration of the reference point less gravity, body axes, and acceleration relative to it of
    /// the centre of mass, reversed.
    fn accelerations(&self, state: &State) -> (Vector, Vector) {
        let (w, dw) = (angular(&state.v), angular(&state.a));
        let point = three(&state.a, 0) - self.gravity;
        let turning = dw.cross(&self.offset) + w.cross(&w.cross(&self.offset));
        (attitude(state).tr_mul(&point), turning)
    }

    /// Angular momentum about the centre of mass, inertial axes, N m s.
    pub(super) fn spin(&self, state: &State) -> Vector {
        attitude(state) * self.times_inertia(angular(&state.v))
    }

    fn times_inertia(&self, w: Vector) -> Vector {
        Vector::from_fn(|i, _| self.inertia[i] * w[i])
    }

    fn place(&self, i: usize, j: usize) -> usize {
        6 * j + i
    }

    /// Adds `factor * block` from the given row and column on.
    fn add_block(&self, values: &mut [f64], (first, second): (usize, usize), factor: f64, block: &Matrix) {
        for (i, row) in rows(block).iter().enumerate() {
            for (j, &value) in row.iter().enumerate() {
                values[self.place(first + i, second + j)] += factor * value;
            }
        }
    }

    /// Writes `(1, rotation)` as the rows of the constraints.
    fn write_border(&self, identity: f64, rotation: &Matrix, values: &mut [f64]) {
        for (j, row) in rows(rotation).iter().enumerate() {
            values[4 * j] = identity;
            values[4 * j + 1..4 * j + 4].copy_from_slice(row);
        }
    }
}

/// Orientation matrix of the top.
pub(super) fn attitude(state: &State) -> Matrix {
    matrix(&state.orientation(0, 3))
}

/// The angular part of a vector of unknowns.
pub(super) fn angular(y: &[f64]) -> Vector {
    Vector::new(y[3], y[4], y[5])
}

/// Reference of the heavy top at 0.5 s and 1.0 s: time, centre of mass, angular velocity, multipliers.
pub(super) const REFERENCE: [(f64, Vector, Vector, Vector); 2] = [
    (
        0.5,
        Vector::new(-0.70246829706, -0.02116518470, -0.71140025765),
        Vector::new(-0.4710531017, 150.0, 5.9010830483),
        Vector::new(-523.281244, -404.206178, -357.336176),
    ),
    (
        1.0,
        Vector::new(0.17334396410, 0.64008859207, -0.74849079113),
        Vector::new(-0.8220781017, 150.0, -5.9232913481),
        Vector::new(517.600739, 396.843101, -404.574925),
    ),
];

/// Errors of position (m), angular velocity (rad/s) and multipliers (N) against a reference.
pub(super) fn errors(state: &State, reference: &(f64, Vector, Vector, Vector)) -> [f64; 3] {
    let &(t, r, w, lambda) = reference;
    assert!((state.t - t).abs() < 1e-9, "{} {t}", state.t);
    let far = |y: &[f64], exact: Vector| (three(y, 0) - exact).norm();
    [far(&state.x, r), far(&state.v[3..], w), far(&state.lambda, lambda)]
}

impl System for Top {
    fn unknowns(&self) -> usize {
        6
    }
    fn constraints(&self) -> usize {
        self.constraint_pattern.columns()
    }
    fn turns(&self) -> &[usize] {
        &[3]
    }
    fn border(&self) -> usize {
        6
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, state: &State, values: &mut [f64]) {
        values.fill(0.0);
        for i in 0..3 {
            values[self.place(i, i)] = self.mass;
            values[self.place(3 + i, 3 + i)] = self.inertia[i];
        }
        let p = self.offset.cross_matrix();
        let coupling = attitude(state) * p;
        self.add_block(values, (0, 3), self.mass, &coupling);
        self.add_block(values, (3, 0), self.mass, &coupling.transpose());
        self.add_block(values, (3, 3), -self.mass, &(p * p));
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let w = angular(&state.v);
        let (point, turning) = self.accelerations(state);
        let inertial = self.mass * (point - turning);
        let force = attitude(state) * inertial;
        let gyroscopic = w.cross(&self.times_inertia(w));
        let moment = self.times_inertia(angular(&state.a)) + gyroscopic;
        let moment = moment - self.offset.cross(&inertial);
        out[..3].copy_from_slice(force.as_slice());
        out[3..].copy_from_slice(moment.as_slice());
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.mass(state, &mut out.mass);
        out.stiffness.fill(0.0);
        out.damping.fill(0.0);
        let (w, a, p) = (angular(&state.v), attitude(state), self.offset.cross_matrix());
        self.add_block(&mut out.damping, (3, 3), -1.0, &self.times_inertia(w).cross_matrix());
        let turn = w.cross_matrix();
        let gyroscopic = Matrix::from_fn(|i, j| turn[(i, j)] * self.inertia[j]);
        self.add_block(&mut out.damping, (3, 3), 1.0, &gyroscopic);
        // d(w x (w x p)) = -([w x p] + [w][p]) dw
        for centrifugal in [w.cross(&self.offset).cross_matrix(), turn * p] {
            self.add_block(&mut out.damping, (0, 3), self.mass, &(a * centrifugal));
            self.add_block(&mut out.damping, (3, 3), -self.mass, &(p * centrifugal));
        }
        let (point, turning) = self.accelerations(state);
        self.add_block(&mut out.stiffness, (0, 3), self.mass, &(a * turning.cross_matrix()));
        self.add_block(&mut out.stiffness, (3, 3), -self.mass, &(p * point.cross_matrix()));
        if let &[x, y, z] = &state.lambda[..] {
            let force = a.tr_mul(&Vector::new(x, y, z)).cross_matrix();
            self.add_block(&mut out.stiffness, (3, 3), -1.0, &(self.arm().cross_matrix() * force));
        }
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if out.is_empty() {
            return;
        }
        let (w, dw, held) = (angular(&state.v), angular(&state.a), self.arm());
        let wx = w.cross(&held);
        let arm = match level {
            ConstraintLevel::Position => held,
            ConstraintLevel::Velocity => Vector::zeros(),
            ConstraintLevel::Acceleration => w.cross(&wx),
            ConstraintLevel::Jerk => 2.0 * w.cross(&dw.cross(&held)) + dw.cross(&wx) + w.cross(&w.cross(&wx)),
        };
        let arm = attitude(state) * arm;
        for i in 0..3 {
            let position = if level == ConstraintLevel::Position {
                state.x[i]
            } else {
                0.0
            };
            out[i] = position - arm[i];
        }
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        if !values.is_empty() {
            // d(A X) = A (dpi x X)
            self.write_border(1.0, &(attitude(state) * self.arm().cross_matrix()), values);
        }
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        if !values.is_empty() {
            // d(-A (w x X)) = -A (dpi x (w x X))
            let velocity = angular(&state.v).cross(&self.arm());
            self.write_border(0.0, &(attitude(state) * velocity.cross_matrix()), values);
        }
    }
    fn sizes(&self) -> &[f64] {
        &[1.0; 6]
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!(
            "top, {} {}",
            ["centre", "orientation"][index / 3],
            ["x", "y", "z"][index % 3]
        )
    }
    fn describe_constraint(&self, index: usize) -> String {
        format!("joint point, {}", ["x", "y", "z"][index])
    }
    fn kinks(&self) -> Vec<f64> {
        self.kinks.clone()
    }
    fn energy(&mut self, state: &State) -> Option<f64> {
        let (w, a) = (angular(&state.v), attitude(state));
        let point = three(&state.v, 0);
        let v = point - a * w.cross(&self.offset);
        let centre = self.centred(state).x;
        let r = three(&centre, 0);
        let kinetic = 0.5 * (self.mass * v.dot(&v) + w.dot(&self.times_inertia(w)));
        Some(kinetic - self.mass * self.gravity.dot(&r))
    }
}

#[test]
fn hand_written_derivatives_are_those_of_the_functions() {
    use ConstraintLevel::{Acceleration, Jerk, Position, Velocity};
    let mut top = Top::heavy_from(OFFSET);
    let mut state = top.start();
    state.turns[0] = exp(Vector::new(0.3, -0.4, 0.9));
    state.v.copy_from_slice(&[0.1, -0.7, 0.4, 1.3, -0.8, 0.6]);
    state.a.copy_from_slice(&[0.2, 0.9, -0.4, 0.3, 1.8, -0.6]);
    state.lambda.copy_from_slice(&[3.0, -2.0, 5.0]);
    // Along the motion with constant acceleration every level is the derivative of the one before.
    let along = |top: &mut Top, t: f64, level: ConstraintLevel| {
        let mut moved = state.clone();
        for i in 0..6 {
            moved.x[i] += t * (state.v[i] + 0.5 * t * state.a[i]);
            moved.v[i] += t * state.a[i];
        }
        // theta' = T^-1(theta) w has no part along w x w' below t^3.
        let mut out = vec![0.0; 3];
        top.constraint(level, &moved, &mut out);
        let mut border = vec![0.0; top.constraint_pattern().entries()];
        top.constraint_jacobian(&moved, &mut border);
        match level {
            Position => {}
            Velocity => top
                .constraint_pattern
                .transpose_multiply_add(1.0, &border, &moved.v, &mut out),
            _ => top
                .constraint_pattern
                .transpose_multiply_add(1.0, &border, &moved.a, &mut out),
        }
        out
    };
    let mut jerk = vec![0.0; 3];
    top.constraint(Jerk, &state, &mut jerk);
    let step = 1e-5;
    for (level, next) in [(Position, Velocity), (Velocity, Acceleration), (Acceleration, Jerk)] {
        let (up, down) = (along(&mut top, step, level), along(&mut top, -step, level));
        let exact = if next == Jerk {
            jerk.clone()
        } else {
            along(&mut top, 0.0, next)
        };
        for i in 0..3 {
            assert!(((up[i] - down[i]) / (2.0 * step) - exact[i]).abs() < 1e-8, "{next:?}");
        }
    }
    tangents_are_derivatives(&mut top, &state);
}

/// `M a + f + C_x^T lambda` and `C_x v` against differences, at theta = 0.
fn tangents_are_derivatives(top: &mut Top, state: &State) {
    let pattern = top.constraint_pattern().clone();
    let sum = |top: &mut Top, state: &State| {
        let (mut out, mut border) = (vec![0.0; 9], vec![0.0; pattern.entries()]);
        top.residual(state, &mut out[..6]);
        top.constraint_jacobian(state, &mut border);
        pattern.multiply_add(1.0, &border, &state.lambda, &mut out[..6]);
        pattern.transpose_multiply_add(1.0, &border, &state.v, &mut out[6..]);
        out
    };
    let mut tangent = Tangent {
        mass: vec![0.0; 36],
        stiffness: vec![0.0; 36],
        damping: vec![0.0; 36],
    };
    top.tangent(state, &mut tangent);
    let (mut border, mut rate) = (vec![0.0; pattern.entries()], vec![0.0; pattern.entries()]);
    top.constraint_jacobian(state, &mut border);
    top.constraint_rate_tangent(state, &mut rate);
    let step = 1e-5;
    /// What is varied, and the derivatives of the sum and of the constraint's rate.
    type Part<'a> = (fn(&mut State) -> &mut Vec<f64>, &'a [f64], Option<&'a [f64]>);
    let parts: [Part<'_>; 3] = [
        (|state| &mut state.x, &tangent.stiffness, Some(&rate)),
        (|state| &mut state.v, &tangent.damping, Some(&border)),
        (|state| &mut state.a, &tangent.mass, None),
    ];
    for (part, derivative, constraint) in parts {
        for j in 0..6 {
            let mut at = |h: f64| {
                let mut moved = state.clone();
                part(&mut moved)[j] += h;
                sum(top, &moved)
            };
            let (up, down) = (at(step), at(-step));
            for i in 0..9 {
                let exact = if i < 6 {
                    derivative[6 * j + i]
                } else {
                    let place = pattern.find(j, i - 6);
                    constraint.zip(place).map_or(0.0, |(values, place)| values[place])
                };
                let found = (up[i] - down[i]) / (2.0 * step);
                assert!((found - exact).abs() < 1e-7, "{i} {j}: {found} {exact}");
            }
        }
    }
}
