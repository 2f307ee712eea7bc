//! What an integrator sees of a model: residual, tangents and constraints of a second-order
//! differential-algebraic system on a Lie group, THEORY 2:
//!
//! ```text
//! M(t, x) a + f(t, x, v) + C_x(t, x)^T lambda = 0
//! C(t, x) = 0
//! ```
//!
//! `x` are the free unknowns (conditions that are linear in the nodal vectors are eliminated).
//! Most of them are numbers and `v` is their rate. A free orientation is three of them, see
//! [`System::turns`]: there `v` is the angular velocity in body axes, and derivatives are taken
//! with respect to right increments, `A <- A exp(dpi)`.

use crate::archive::{Archive, Keep};
use crate::course::{Courses, Path};
use crate::linalg::Pattern;
use crate::space::{Matrix, Rotation, Vector, inverse_tangent_map, three, turned};

/// Position, velocity, acceleration and multipliers of a system at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Time, s.
    pub t: f64,
    /// Unknowns; m for positions (displacements from the start for free frames), 1 for slopes, rad for angles. The three of an orientation are its
    /// rotation vector theta since `turns`, in body axes: `A = turn exp(theta)`.
    pub x: Vec<f64>,
    /// Orientations at theta = 0, one for each of [`System::turns`]. Constant during a step; the
    /// chart begins anew with every step, so that theta stays small.
    pub turns: Vec<Rotation>,
    /// First time derivative of `x`; angular velocity in body axes (rad/s) for an orientation.
    pub v: Vec<f64>,
    /// Time derivative of `v`.
    pub a: Vec<f64>,
    /// Multipliers of the constraints.
    pub lambda: Vec<f64>,
}

/// Of the same system: the lengths are those that the reader has.
impl Keep for State {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            t,
            x,
            turns,
            v,
            a,
            lambda,
        } = self;
        t.keep(archive);
        archive.fixed(turns);
        for values in [x, v, a, lambda] {
            archive.fixed(values);
        }
    }
}

impl State {
    /// A state of zeros at time `t` with `n` unknowns, none of them of an orientation, and `m`
    /// multipliers.
    pub fn zeros(t: f64, n: usize, m: usize) -> Self {
        Self {
            t,
            x: vec![0.0; n],
            turns: Vec::new(),
            v: vec![0.0; n],
            a: vec![0.0; n],
            lambda: vec![0.0; m],
        }
    }

    /// A state of zeros at time `t` for `system`, orientations along the inertial axes.
    pub fn of(system: &dyn System, t: f64) -> Self {
        Self {
            turns: vec![Rotation::identity(); system.turns().len()],
            ..Self::zeros(t, system.unknowns(), system.constraints())
        }
    }

    /// Orientation `index` of [`System::turns`], whose first unknown is `unknown`.
    pub fn orientation(&self, index: usize, unknown: usize) -> Rotation {
        turned(&self.turns[index], three(&self.x, unknown))
    }

    /// Begins the charts of the orientations with the given first unknowns anew: theta = 0.
    pub fn rebase(&mut self, turns: &[usize]) {
        for (index, &unknown) in turns.iter().enumerate() {
            self.turns[index] = self.orientation(index, unknown);
            self.x[unknown..unknown + 3].fill(0.0);
        }
    }
}

/// Derivatives of the residual on the pattern of [`System::pattern`].
#[derive(Clone, Debug, Default)]
pub struct Tangent {
    /// M(t, x).
    pub mass: Vec<f64>,
    /// d(M a + f + C_x^T lambda)/dx, right increments for orientations.
    pub stiffness: Vec<f64>,
    /// df/dv: damping and gyroscopic terms.
    pub damping: Vec<f64>,
}

/// Takes derivatives of the residual, entry by entry of [`System::pattern`].
pub trait Sums {
    /// Adds to M.
    fn mass(&mut self, entry: usize, value: f64);
    /// Adds to the derivative with respect to v.
    fn damping(&mut self, entry: usize, value: f64);
    /// Adds to the derivative with respect to x.
    fn stiffness(&mut self, entry: usize, value: f64);
    /// What [`Sums::stiffness`] adds to, and what it multiplies values by: for many at once.
    fn all_stiffness(&mut self) -> (&mut [f64], f64);
    /// The same of [`Sums::damping`], in columns that are no rotations.
    fn all_damping(&mut self) -> (&mut [f64], f64);
}

impl Sums for Tangent {
    fn mass(&mut self, entry: usize, value: f64) {
        self.mass[entry] += value;
    }

    fn damping(&mut self, entry: usize, value: f64) {
        self.damping[entry] += value;
    }

    fn stiffness(&mut self, entry: usize, value: f64) {
        self.stiffness[entry] += value;
    }

    fn all_stiffness(&mut self) -> (&mut [f64], f64) {
        (&mut self.stiffness, 1.0)
    }

    fn all_damping(&mut self) -> (&mut [f64], f64) {
        (&mut self.damping, 1.0)
    }
}

/// Which time derivative of the constraints is asked for.
///
/// Every level is the value with the highest derivative of `x` set to zero, so that the full
/// derivative is `C_x * (highest derivative) + value`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintLevel {
    /// `C(t, x)`.
    Position,
    /// `dC/dt` with v = 0: `C_t`.
    Velocity,
    /// `d^2C/dt^2` with a = 0; uses x, v.
    Acceleration,
    /// `d^3C/dt^3` with jerk = 0; uses x, v, a (THEORY 10, Gamma).
    Jerk,
}

/// A prescribed motion that is not continuous.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    /// What jumps, and by how much, in the user's words.
    pub text: String,
    /// Whether a position or angle jumps, which no body can follow; else a velocity, which acts as an impact.
    pub of_position: bool,
}

/// What turns a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turning {
    /// Three unknowns, an orientation.
    Orientation {
        /// Its index among [`System::turns`].
        index: usize,
    },
    /// One unknown, an angle.
    Angle {
        /// The unknown.
        unknown: usize,
        /// Axis, in the axes of the pose.
        axis: Vector,
        /// Rotation at the angle zero.
        base: Rotation,
    },
}

/// An unknown of what deforms in the axes of a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// The unknown.
    pub unknown: usize,
    /// Its value at the start.
    pub start: f64,
    /// By how much it shifts the centre of mass, m for one of its unit, in these axes.
    pub way: Vector,
}

/// The way from the origin of a pose to the centre of mass of what it carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Lever {
    /// Unknown positions of the origin, each with its direction in space.
    pub positions: Vec<(usize, Vector)>,
    /// What turns the pose.
    pub turning: Turning,
    /// The way at the start, m, in the axes of the pose.
    pub arm: Vector,
    /// What changes it, in the same axes.
    pub carried: Vec<Carried>,
    /// The inertia at the start about the centre then, kg m^2, and its inverse, in the axes of the pose; `None` where it is singular, or one number.
    pub inertia: Option<[Matrix; 2]>,
}

/// Where a law of what moves is not smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Branch {
    /// An angle that the law reads by its sine and cosine. The law jumps where the angle goes from pi to -pi, unless it is periodic.
    Angle {
        /// Sine, times what it has in common with the cosine.
        sine: f64,
        /// Cosine, likewise.
        cosine: f64,
        /// By how much the law jumps half a turn away from 0, in its unit.
        jump: f64,
        /// Its size there.
        size: f64,
    },
    /// `max`, `min` or `abs`: the law has a kink where this changes its sign.
    Kink(f64),
    /// An exponential of what moves has a peak where the rate of its exponent changes its sign.
    Peak {
        /// Time, s.
        t: f64,
        /// Rate of the exponent, 1/s.
        rate: f64,
    },
}

/// Part of the size of a law by which it jumps for round-off.
const PERIODIC: f64 = 1e-9;
/// What is left to half a turn, rad, where that is near.
const NEAR: f64 = 0.1;
/// Part of its change over a step that is as good as at the kink.
const AT_KINK: f64 = 1e-6;
/// Rise of an exponent to its peak at whose beginning the peak is out of sight: there is 2 % of it.
const OUT_OF_SIGHT: f64 = 4.0;

impl Branch {
    /// rad, in (-pi, pi], where a law jumps with it.
    fn jumping_angle(&self) -> Option<f64> {
        match *self {
            Branch::Angle {
                sine,
                cosine,
                jump,
                size,
            } if jump > PERIODIC * size => Some(sine.atan2(cosine)),
            _ => None,
        }
    }

    /// Whether a step that ends here has passed the place where the law jumps, by the shorter way.
    pub fn is_passed_from(&self, before: &Branch) -> bool {
        match (self.jumping_angle(), before.jumping_angle()) {
            (Some(now), Some(before)) => (now - before).abs() > std::f64::consts::PI,
            _ => false,
        }
    }

    /// Whether the law jumps within some degrees.
    pub fn is_near(&self) -> bool {
        self.jumping_angle()
            .is_some_and(|angle| angle.abs() > std::f64::consts::PI - NEAR)
    }

    /// Whether steps end where it changes over.
    pub fn ends_steps(&self) -> bool {
        matches!(self, Branch::Kink(_) | Branch::Peak { .. })
    }

    /// On which side of its kink it is.
    pub fn side(&self) -> Option<bool> {
        match self {
            Branch::Kink(gap) => Some(*gap > 0.0),
            _ => None,
        }
    }

    /// Whether it is nearer to its kink.
    pub fn is_nearer_than(&self, other: &Branch) -> bool {
        matches!((self, other), (Branch::Kink(own), Branch::Kink(other)) if own.abs() < other.abs())
    }

    /// Whether it is on the other side of a kink.
    pub fn is_across_from(&self, other: &Branch) -> bool {
        matches!((self, other), (Branch::Kink(one), Branch::Kink(other)) if one * other < 0.0)
    }

    /// Whether a step that begins `before` has passed a kink here at which it did not begin, or a peak that was out of sight there.
    pub fn is_kink_passed_from(&self, before: &Branch) -> bool {
        let begins_at_kink = match (self, before) {
            (Branch::Kink(now), Branch::Kink(before)) => before.abs() <= AT_KINK * (now - before).abs(),
            _ => false,
        };
        !begins_at_kink && self.is_kink_passed_since(before)
    }

    /// The same of two places within a step.
    pub fn is_kink_passed_since(&self, before: &Branch) -> bool {
        match (self, before) {
            (Branch::Kink(_), Branch::Kink(_)) => self.is_across_from(before),
            (Branch::Peak { t, rate: now }, Branch::Peak { t: from, rate: before }) => {
                // The rise of a parabola with these slopes.
                *before > 0.0 && *now < 0.0 && 0.5 * before * before * (t - from) > OUT_OF_SIGHT * (before - now)
            }
            _ => false,
        }
    }
}

/// A second-order differential-algebraic system. Functions write into the caller's memory and
/// take `&mut self` for scratch only: the result depends on the arguments alone.
pub trait System {
    /// Number of unknowns n.
    fn unknowns(&self) -> usize;

    /// Number of constraints m that are kept with multipliers.
    fn constraints(&self) -> usize;

    /// First of the three unknowns of every free orientation, ascending; none of them are ordinary
    /// numbers.
    fn turns(&self) -> &[usize] {
        &[]
    }

    /// Unknowns of first order, ascending: states without inertia. Their equations are `z' = g`, with `z'` alone in its place of
    /// the damping, and no constraint touches them.
    fn states(&self) -> &[usize] {
        &[]
    }

    /// The largest of the sizes of what moves; states have units of their own.
    fn largest_length(&self) -> f64 {
        let moving = self
            .sizes()
            .iter()
            .enumerate()
            .filter(|(unknown, _)| !self.states().contains(unknown));
        moving.fold(0.0, |largest: f64, (_, size)| largest.max(*size))
    }

    /// Number of unknowns at the end (poses of free frames and rigid bodies) whose rows and columns
    /// may be full: linear algebra borders them. What is in front of them has a regular mass matrix.
    fn border(&self) -> usize {
        0
    }

    /// Poses that no constraint touches, with what their inertia is like. A method of second order keeps neither the momentum of what circles
    /// about the origin of a pose nor an angular momentum in turning axes; of these it keeps the momentum, and the angular momentum of a rigid body.
    fn levers(&mut self) -> Vec<Lever> {
        Vec::new()
    }

    /// Fixed sparsity pattern, n x n, common to mass, damping and stiffness; structurally
    /// symmetric, with the whole diagonal.
    fn pattern(&self) -> &Pattern;

    /// Fixed sparsity pattern of `C_x^T`, n rows x m columns: one column for each constraint.
    fn constraint_pattern(&self) -> &Pattern;

    /// Mass matrix at the state's time and position, on [`System::pattern`]. It may be singular where
    /// `[[M, C_x^T], [C_x, 0]]` is not.
    fn mass(&mut self, state: &State, values: &mut [f64]);

    /// `out = M a + f(t, x, v)`, without constraint forces; n entries.
    fn residual(&mut self, state: &State, out: &mut [f64]);

    /// Mass and derivatives of `M a + f + C_x^T lambda` on [`System::pattern`]; every entry is
    /// overwritten.
    fn tangent(&mut self, state: &State, out: &mut Tangent);

    /// Stiffness of the elasticity of bodies alone on [`System::pattern`], symmetric; every entry is overwritten.
    fn elastic_stiffness(&mut self, _state: &State, values: &mut [f64]) {
        values.fill(0.0);
    }

    /// `(factors[0] M + factors[1] C) T^-1 + factors[2] K` on [`System::pattern`], the matrix of Newton's iteration
    /// for right increments: M, C and K as in [`System::tangent`], with T(theta) in the columns of orientations
    /// (THEORY 7.2). Every entry is overwritten.
    fn iteration_matrix(&mut self, state: &State, factors: [f64; 3], values: &mut [f64]) {
        let zeros = || vec![0.0; values.len()];
        let mut tangent = Tangent {
            mass: zeros(),
            stiffness: zeros(),
            damping: zeros(),
        };
        self.tangent(state, &mut tangent);
        let [b, g, k] = factors;
        for ((value, mass), damping) in values.iter_mut().zip(&tangent.mass).zip(&tangent.damping) {
            *value = b * mass + g * damping;
        }
        for &turn in self.turns() {
            columns_to_increments(self.pattern(), turn, state, values);
        }
        for (value, stiffness) in values.iter_mut().zip(&tangent.stiffness) {
            *value += k * stiffness;
        }
    }

    /// Constraint values of the given level; m entries. `state.lambda` is not used.
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]);

    /// Round-off of the values of the constraints at the state, in their units: of what they are differences of; m entries,
    /// which are zero on entry. Round-off of the unknowns need not be counted.
    fn constraint_noise(&mut self, _state: &State, _out: &mut [f64]) {}

    /// `C_x^T` at the state's time and position, on [`System::constraint_pattern`].
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]);

    /// What an iteration asks for at one state: [`System::residual`], positions of constraints, and, where it is wanted,
    /// [`System::constraint_jacobian`].
    fn equations(&mut self, state: &State, residual: &mut [f64], constraint: &mut [f64], jacobian: Option<&mut [f64]>) {
        self.residual(state, residual);
        self.constraint(ConstraintLevel::Position, state, constraint);
        if let Some(values) = jacobian {
            self.constraint_jacobian(state, values);
        }
    }

    /// `(d(C_x v + C_t)/dx)^T` on [`System::constraint_pattern`], for the stabilised index 2
    /// (THEORY 7.4).
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]);

    /// Size of the kind of every unknown: body length for positions (m), 1 for slopes and angles; n
    /// entries.
    /// The weight of an unknown in every error norm is `rtol` times this.
    fn sizes(&self) -> &[f64];

    /// The equation in the user's words, for error messages, e.g. `body beam, node 3, slope y`.
    fn describe_unknown(&self, index: usize) -> String;

    /// The constraint in the user's words, e.g. `joint root, direction`.
    fn describe_constraint(&self, index: usize) -> String;

    /// Ties that turn a frame without mass of its own with a slope or section without inertia, where something named in
    /// the text `worst` (that of an unknown or constraint) takes part: what they do, and what would be better.
    fn loose_tie(&self, _worst: &str) -> Option<String> {
        None
    }

    /// What has no finite value or derivative at the state, in the user's words and with what can be
    /// done, e.g. a spring whose ends coincide; `None` where nothing can be named.
    fn undefined(&mut self, _state: &State) -> Option<String> {
        None
    }

    /// Times (s) at which a derivative of a prescribed motion or load may jump, ascending.
    /// An integrator ends a step just before and restarts just after each.
    fn kinks(&self) -> Vec<f64>;

    /// Appends values (in any unit) that change their sign, at time `t`, s, where else a derivative of a prescribed motion or
    /// load may jump, and their time derivatives: always the same number of them, in the same order. An integrator finds
    /// their roots as it goes on, and treats them as [`System::kinks`].
    fn gaps(&self, _t: f64, _out: &mut Vec<[f64; 2]>) {}

    /// What motions and loads do over time alone, where it may be over within a step. An integrator bounds it over every step, and shortens one that
    /// would jump over it.
    fn courses(&self) -> Vec<Courses> {
        Vec::new()
    }

    /// How the vectors that forces read, by the numbers that courses have of them, go on from a state.
    fn paths(&mut self, _state: &State, _readers: &[Vec<usize>]) -> Vec<Vec<Path>> {
        Vec::new()
    }

    /// Prescribed motions that are not continuous between a state and the time `behind` (s) just after its own, on the two
    /// sides of a kink.
    fn jumps(&mut self, _state: &State, _behind: f64) -> Vec<Jump> {
        Vec::new()
    }

    /// What [`jumps`](Self::jumps) of velocities exert on the unknowns, N s or N m s: inertia of what prescribed frames and places carry along.
    /// The state has the velocities before; `out` is overwritten.
    fn jolt(&mut self, _state: &State, _behind: f64, out: &mut [f64]) {
        out.fill(0.0);
    }

    /// Angles that laws read, and their kinks, always in the same order.
    fn branches(&mut self, _state: &State) -> Vec<Branch> {
        Vec::new()
    }

    /// The law that a branch is of, in the user's words.
    fn describe_branch(&self, index: usize) -> String {
        format!("angle {index}")
    }

    /// Whether a branch is of a constraint, whose rate a kink changes at once.
    fn is_branch_of_constraint(&self, _index: usize) -> bool {
        false
    }

    /// Whether somebody reads multipliers: between the ends of steps they may cost an iteration of Newton.
    fn reads_multipliers(&self) -> bool {
        true
    }

    /// Whether flexible bodies may turn in the axes of their unknowns.
    fn turns_in_unknowns(&self) -> bool {
        false
    }

    /// What moves faster than light at the state, and how fast, in the user's words: a motion that has grown beyond all
    /// meaning.
    fn too_fast(&mut self, _state: &State) -> Option<String> {
        None
    }

    /// Kinetic energy of the rates of the unknowns, J: of what bodies do in prescribed frames, without what the frames do.
    fn kinetic_energy(&mut self, state: &State) -> f64 {
        let mut mass = vec![0.0; self.pattern().entries()];
        self.mass(state, &mut mass);
        let mut momentum = vec![0.0; state.v.len()];
        self.pattern().multiply_add(1.0, &mass, &state.v, &mut momentum);
        0.5 * momentum.iter().zip(&state.v).map(|(p, v)| p * v).sum::<f64>()
    }

    /// Total energy (J) where the model conserves it, else `None`.
    fn energy(&mut self, state: &State) -> Option<f64>;

    /// Forces between two states that conserve energy, for [`crate::Method::EnergyMomentum`].
    ///
    /// # Errors
    /// Why there are none, in the user's words and with what can be done.
    fn conserving(&mut self) -> Result<&mut dyn Conserving, String> {
        Err("it has no forces between two states that conserve energy: take another integrator".to_string())
    }
}

/// Forces F(q0, q1) between two states that do the work U(q1) - U(q0) and have no resultant where the potential U has
/// none. The mass matrix is constant; what has no inertia is carried along by as many constraints.
pub trait Conserving {
    /// `out = M a + F(from, to)` with the acceleration `a` of the second state; n entries.
    fn residual(&mut self, from: &State, to: &State, out: &mut [f64]);

    /// Gradients of the constraints between the two states, `C(q1) - C(q0) = G (q1 - q0)`, on
    /// [`System::constraint_pattern`]: along them multipliers do no work.
    fn constraint_forces(&mut self, from: &State, to: &State, values: &mut [f64]);

    /// `factors[0] M + factors[1] dF/d((q0 + q1) / 2)` at a fixed first state on [`System::pattern`]; every entry is
    /// overwritten. Not symmetric.
    fn matrix(&mut self, from: &State, to: &State, factors: [f64; 2], values: &mut [f64]);
}

/// What is a [`System`], seen as nothing else: a type that implements it, or what is `dyn` already.
pub trait AsSystem {
    /// The same, as a system.
    fn as_system(&mut self) -> &mut dyn System;
}

impl<S: System> AsSystem for S {
    fn as_system(&mut self) -> &mut dyn System {
        self
    }
}

impl AsSystem for dyn System + '_ {
    fn as_system(&mut self) -> &mut dyn System {
        self
    }
}

/// Multiplies the columns of the orientation whose first unknown is `turn` by `T(theta)^-1`.
fn columns_to_increments(pattern: &Pattern, turn: usize, state: &State, values: &mut [f64]) {
    let map = inverse_tangent_map(three(&state.x, turn));
    for row in 0..pattern.rows() {
        let places: [Option<usize>; 3] = std::array::from_fn(|j| pattern.find(row, turn + j));
        let old = places.map(|place| place.map_or(0.0, |place| values[place]));
        for (j, place) in places.into_iter().enumerate() {
            if let Some(place) = place {
                values[place] = (0..3).map(|l| old[l] * map[(l, j)]).sum();
            }
        }
    }
}
