//! What an integrator sees of a model: residual, tangents and constraints of a second-order
//! differential-algebraic system, THEORY 2 with prescribed frames:
//!
//! ```text
//! M(t, x) a + f(t, x, v) + C_x(t, x)^T lambda = 0
//! C(t, x) = 0
//! ```
//!
//! `x` are the free unknowns (conditions that are linear in the nodal vectors are eliminated).

use crate::linalg::Pattern;

/// Position, velocity, acceleration and multipliers of a system at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Time, s.
    pub t: f64,
    /// Unknowns; m for positions, 1 for slopes.
    pub x: Vec<f64>,
    /// First time derivative of `x`.
    pub v: Vec<f64>,
    /// Second time derivative of `x`.
    pub a: Vec<f64>,
    /// Multipliers of the constraints.
    pub lambda: Vec<f64>,
}

impl State {
    /// A state of zeros at time `t` with `n` unknowns and `m` multipliers.
    pub fn zeros(t: f64, n: usize, m: usize) -> Self {
        Self {
            t,
            x: vec![0.0; n],
            v: vec![0.0; n],
            a: vec![0.0; n],
            lambda: vec![0.0; m],
        }
    }
}

/// Derivatives of the residual on the pattern of [`System::pattern`].
#[derive(Clone, Debug, Default)]
pub struct Tangent {
    /// d(M a + f + C_x^T lambda)/dx.
    pub stiffness: Vec<f64>,
    /// df/dv: damping and gyroscopic terms.
    pub damping: Vec<f64>,
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

/// A second-order differential-algebraic system. Functions write into the caller's memory and
/// take `&mut self` for scratch only: the result depends on the arguments alone.
pub trait System {
    /// Number of unknowns n.
    fn unknowns(&self) -> usize;

    /// Number of constraints m that are kept with multipliers.
    fn constraints(&self) -> usize;

    /// Fixed sparsity pattern, n x n, common to mass, damping and stiffness; structurally
    /// symmetric, with the whole diagonal.
    fn pattern(&self) -> &Pattern;

    /// Fixed sparsity pattern of `C_x^T`, n rows x m columns: one column for each constraint.
    fn constraint_pattern(&self) -> &Pattern;

    /// Mass matrix on [`System::pattern`]. Constant in time and state (prescribed frames).
    fn mass(&mut self, values: &mut [f64]);

    /// `out = M a + f(t, x, v)`, without constraint forces; n entries.
    fn residual(&mut self, t: f64, x: &[f64], v: &[f64], a: &[f64], out: &mut [f64]);

    /// Derivatives of `M a + f + C_x^T lambda` on [`System::pattern`]; every entry is overwritten.
    fn tangent(&mut self, state: &State, out: &mut Tangent);

    /// Constraint values of the given level; m entries. `state.lambda` is not used.
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]);

    /// `C_x^T` on [`System::constraint_pattern`].
    fn constraint_jacobian(&mut self, t: f64, x: &[f64], values: &mut [f64]);

    /// Size of the kind of every unknown: body length for positions (m), 1 for slopes; n entries.
    /// The weight of an unknown in every error norm is `rtol` times this.
    fn sizes(&self) -> &[f64];

    /// The equation in the user's words, for error messages, e.g. `body beam, node 3, slope y`.
    fn describe_unknown(&self, index: usize) -> String;

    /// The constraint in the user's words, e.g. `joint root, direction`.
    fn describe_constraint(&self, index: usize) -> String;

    /// Times (s) at which a derivative of a prescribed motion or load may jump, ascending.
    /// An integrator ends a step just before and restarts just after each.
    fn kinks(&self) -> Vec<f64>;

    /// Total energy (J) where the model conserves it, else `None`.
    fn energy(&mut self, state: &State) -> Option<f64>;
}
