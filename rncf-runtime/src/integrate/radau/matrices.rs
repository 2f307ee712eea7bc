//! The two factorizations of a step: the Newton matrix of three stages, split by the
//! eigenvectors of A^-1 into a real and a complex system of the size of one stage.

use super::coefficients::Coefficients;
use crate::integrate::Statistics;
use crate::linalg::{Pattern, Saddle, Singular, c64};
use crate::system::{State, System, Tangent};

/// Tangent, constraint Jacobian and the factorizations made of them.
pub(super) struct Matrices {
    pub(super) pattern: Pattern,
    pub(super) constraint_pattern: Pattern,
    pub(super) mass: Vec<f64>,
    pub(super) tangent: Tangent,
    pub(super) jacobian: Vec<f64>,
    /// Memory for the constraint Jacobian of a stage.
    pub(super) stage_jacobian: Vec<f64>,
    real: Saddle<f64>,
    complex: Saddle<c64>,
    real_block: Vec<f64>,
    complex_block: Vec<c64>,
    complex_dynamics: Vec<c64>,
    complex_constraints: Vec<c64>,
    real_dynamics: Vec<f64>,
    real_constraints: Vec<f64>,
    /// Step size of the factorizations; none if they do not fit the tangent.
    factored: Option<f64>,
}

impl Matrices {
    pub(super) fn new<S: System + ?Sized>(system: &mut S) -> Self {
        let (pattern, constraint_pattern) = (system.pattern().clone(), system.constraint_pattern().clone());
        let (n, m, entries) = (pattern.rows(), constraint_pattern.columns(), pattern.entries());
        let mut mass = vec![0.0; entries];
        system.mass(&State::of(system, 0.0), &mut mass);
        Self {
            mass,
            tangent: Tangent {
                mass: vec![0.0; entries],
                stiffness: vec![0.0; entries],
                damping: vec![0.0; entries],
            },
            jacobian: vec![0.0; constraint_pattern.entries()],
            stage_jacobian: vec![0.0; constraint_pattern.entries()],
            real: Saddle::new(&pattern, system.border(), &constraint_pattern),
            complex: Saddle::new(&pattern, system.border(), &constraint_pattern),
            real_block: vec![0.0; entries],
            complex_block: vec![c64::default(); entries],
            complex_dynamics: vec![c64::default(); n],
            complex_constraints: vec![c64::default(); m],
            real_dynamics: vec![0.0; n],
            real_constraints: vec![0.0; m],
            factored: None,
            pattern,
            constraint_pattern,
        }
    }

    /// Evaluates tangent and constraint Jacobian at `state`.
    pub(super) fn linearize<S: System + ?Sized>(&mut self, system: &mut S, state: &State, statistics: &mut Statistics) {
        system.tangent(state, &mut self.tangent);
        system.constraint_jacobian(state, &mut self.jacobian);
        statistics.jacobian_evaluations += 1;
        self.factored = None;
    }

    /// Factors for step size `h` unless that is done.
    pub(super) fn factor(
        &mut self,
        coefficients: &Coefficients,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.factored == Some(h) {
            return Ok(());
        }
        self.factored = None;
        let (g, z) = (coefficients.real / h, coefficients.complex / h);
        let square = z * z;
        for entry in 0..self.mass.len() {
            let (m, d, k) = (
                self.mass[entry],
                self.tangent.damping[entry],
                self.tangent.stiffness[entry],
            );
            self.real_block[entry] = (g * m + d) * g + k;
            self.complex_block[entry] = c64::new(square.re * m + z.re * d + k, square.im * m + z.im * d);
        }
        statistics.factorizations += 2;
        self.real.factor_symmetric(&self.real_block, &self.jacobian)?;
        self.complex.factor_symmetric(&self.complex_block, &self.jacobian)?;
        self.factored = Some(h);
        Ok(())
    }

    /// Solves `(G^2 (x) M + G (x) D + 1 (x) K) dZ + C^T dL = dynamics, C dZ = constraints` with
    /// G = A^-1 / h in place.
    pub(super) fn solve_stages(
        &mut self,
        coefficients: &Coefficients,
        dynamics: &mut [Vec<f64>; 3],
        constraints: &mut [Vec<f64>; 3],
        statistics: &mut Statistics,
    ) {
        let split = |stages: &[Vec<f64>; 3], real: &mut [f64], complex: &mut [c64]| {
            for i in 0..real.len() {
                real[i] = (0..3).map(|s| coefficients.real_left[s] * stages[s][i]).sum();
                complex[i] = (0..3).map(|s| coefficients.complex_left[s] * stages[s][i]).sum();
            }
        };
        split(dynamics, &mut self.real_dynamics, &mut self.complex_dynamics);
        split(constraints, &mut self.real_constraints, &mut self.complex_constraints);
        self.real.solve(&mut self.real_dynamics, &mut self.real_constraints);
        self.complex
            .solve(&mut self.complex_dynamics, &mut self.complex_constraints);
        statistics.solves += 2;
        let join = |stages: &mut [Vec<f64>; 3], real: &[f64], complex: &[c64]| {
            for (s, stage) in stages.iter_mut().enumerate() {
                let (a, b) = (coefficients.real_right[s], coefficients.complex_right[s]);
                for i in 0..real.len() {
                    stage[i] = a * real[i] + 2.0 * (b.re * complex[i].re - b.im * complex[i].im);
                }
            }
        };
        join(dynamics, &self.real_dynamics, &self.complex_dynamics);
        join(constraints, &self.real_constraints, &self.complex_constraints);
    }

    /// Solves with the real matrix `(g/h)^2 M + (g/h) D + K` and the constraints in place.
    pub(super) fn solve_real(&mut self, dynamics: &mut [f64], constraints: &mut [f64], statistics: &mut Statistics) {
        self.real.solve(dynamics, constraints);
        statistics.solves += 1;
    }
}
