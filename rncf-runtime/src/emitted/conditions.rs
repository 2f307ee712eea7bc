//! Joints and constraints as emitted.

use super::joints::{JointData, JointSpec, Prescribed};
use super::markers::ConstraintSpec;
use crate::space::Vector;
use crate::system::ConstraintLevel;

/// Joints between ends of bodies and frames, and their conditions.
pub trait JointConditions {
    /// Joints.
    fn joints(&self) -> Vec<JointSpec>;
    /// Conditions of a joint on the position and slope of its node: position rows, then direction or
    /// slope rows. `q`, `v`, `a` hold the position, then the slope; with a section its axes instead, unless
    /// the joint holds the slope. `rows` come as zeros; what is zero is not written.
    #[allow(clippy::too_many_arguments)]
    fn condition(
        &self,
        joint: usize,
        absolute: bool,
        level: ConstraintLevel,
        t: f64,
        data: &JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    );
    /// Derivatives of the conditions with respect to position and slope, rows first, into zeros.
    fn condition_jacobian(&self, joint: usize, absolute: bool, t: f64, data: &JointData, jacobian: &mut [f64]);
    /// What the joint prescribes where its conditions are eliminated, into zeros.
    fn prescribed(&self, joint: usize, absolute: bool, t: f64, data: &JointData, prescribed: &mut Prescribed);
}

/// Of a model without joints at ends of bodies.
pub trait WithoutJointConditions {}

impl<T: WithoutJointConditions> JointConditions for T {
    fn joints(&self) -> Vec<JointSpec> {
        Vec::new()
    }
    fn condition(
        &self,
        _joint: usize,
        _absolute: bool,
        _level: ConstraintLevel,
        _t: f64,
        _data: &JointData,
        _q: &[f64],
        _v: &[f64],
        _a: &[f64],
        _rows: &mut [f64],
    ) {
    }
    fn condition_jacobian(&self, _joint: usize, _absolute: bool, _t: f64, _data: &JointData, _jacobian: &mut [f64]) {}
    fn prescribed(&self, _joint: usize, _absolute: bool, _t: f64, _data: &JointData, _prescribed: &mut Prescribed) {}
}

/// Constraints on markers with multipliers, and their functions.
pub trait MarkerConstraints {
    /// Constraints with multipliers.
    fn constraints(&self) -> Vec<ConstraintSpec>;
    /// Values of a constraint's rows, or of their total time derivatives (velocity, acceleration,
    /// jerk), from its markers' values and derivatives of that order and below.
    fn marker_constraint(&self, constraint: usize, level: ConstraintLevel, t: f64, z: &[[Vector; 4]], rows: &mut [f64]);
    /// dC/dz: rows x 3 k for k markers, rows first.
    fn marker_constraint_gradient(&self, constraint: usize, t: f64, z: &[Vector], gradient: &mut [f64]);
    /// d(dC/dt)/dz at constant z': rows x 3 k.
    fn marker_constraint_rate_gradient(
        &self,
        constraint: usize,
        t: f64,
        z: &[Vector],
        velocity: &[Vector],
        gradient: &mut [f64],
    );
    /// sum_i lambda_i d^2 C_i/dz dz: 3 k x 3 k.
    fn marker_constraint_hessian(&self, constraint: usize, t: f64, z: &[Vector], lambda: &[f64], hessian: &mut [f64]);
    /// For each angle that a constraint reads by its sine and cosine: both, by how much the constraint jumps where the angle goes from pi to -pi,
    /// and its size there.
    fn marker_constraint_branches(&self, constraint: usize, t: f64, z: &[Vector], out: &mut [f64]);
}

/// Of a model without constraints with multipliers.
pub trait WithoutMarkerConstraints {}

impl<T: WithoutMarkerConstraints> MarkerConstraints for T {
    fn constraints(&self) -> Vec<ConstraintSpec> {
        Vec::new()
    }
    fn marker_constraint(
        &self,
        _constraint: usize,
        _level: ConstraintLevel,
        _t: f64,
        _z: &[[Vector; 4]],
        _rows: &mut [f64],
    ) {
    }
    fn marker_constraint_gradient(&self, _constraint: usize, _t: f64, _z: &[Vector], _gradient: &mut [f64]) {}
    fn marker_constraint_rate_gradient(
        &self,
        _constraint: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        gradient: &mut [f64],
    ) {
        gradient.fill(0.0);
    }
    fn marker_constraint_hessian(
        &self,
        _constraint: usize,
        _t: f64,
        _z: &[Vector],
        _lambda: &[f64],
        hessian: &mut [f64],
    ) {
        hessian.fill(0.0);
    }
    fn marker_constraint_branches(&self, _constraint: usize, _t: f64, _z: &[Vector], _out: &mut [f64]) {}
}
