//! The second constraint block of the stabilised index 2 (THEORY 7.4) for one eigenvalue of A^-1.
//!
//! In the chart (y, u) the stages satisfy `y' = u - C_y^T mu`, the equations of motion, `C = 0` and
//! `C_y u + C_t = 0`. With g the eigenvalue over h, B = `C_y^T`, F the forces of the multipliers and `R =
//! d(C_y u + C_t)/dy`, Newton's matrix is that of index 3, bordered:
//!
//! ```text
//! [[ g^2 M + g D + K, F, (g M + D) B ],
//!  [ C_y,             0, 0           ],
//!  [ g C_y + R,       0, C_y B       ]]
//! ```
//!
//! The change of B with y, times mu which is nearly zero, is left out; the residual has it all. With Y
//! the solution of the index-3 matrix for its last column, `C_y Y = 0`: the Schur complement is
//! `C_y B - R Y`.

use super::chart::Chart;
use crate::linalg::{Dense, Pattern, Saddle, Scalar, Singular};
use crate::system::Tangent;

/// Values on the chart's constraint pattern at the place of linearization.
#[derive(Debug, Default)]
pub(super) struct Slopes {
    /// `C_y^T`
    pub(super) jacobian: Vec<f64>,
    /// `R^T`
    pub(super) rate: Vec<f64>,
}

/// Responses to mu and the factored Schur complement.
#[derive(Debug)]
pub(super) struct Stabilised<T> {
    responses: Vec<T>,
    forces: Vec<T>,
    schur: Dense<T>,
    work: Vec<T>,
    /// A column of B, full.
    direction: Vec<T>,
}

impl<T: Scalar> Stabilised<T> {
    pub(super) fn new(n: usize, m: usize) -> Self {
        Self {
            responses: vec![T::default(); n * m],
            forces: vec![T::default(); m * m],
            schur: Dense::new(m),
            work: vec![T::default(); m],
            direction: vec![T::default(); n],
        }
    }

    /// Factors for eigenvalue `g` (over h) with the factored index-3 matrix.
    pub(super) fn factor(
        &mut self,
        chart: &Chart,
        g: T,
        tangent: &Tangent,
        slopes: &Slopes,
        saddle: &mut Saddle<T>,
    ) -> Result<(), Singular> {
        let (n, m) = (chart.constraints.rows(), chart.constraints.columns());
        let (constraints, block) = (&chart.constraints, &chart.block);
        self.responses.fill(T::default());
        self.forces.fill(T::default());
        self.schur.clear();
        for j in 0..m {
            let response = &mut self.responses[j * n..(j + 1) * n];
            for entry in constraints.starts()[j]..constraints.starts()[j + 1] {
                let (column, slope) = (constraints.indices()[entry], slopes.jacobian[entry]);
                for place in block.starts()[column]..block.starts()[column + 1] {
                    let value = g.times(tangent.mass[place]) + T::real(tangent.damping[place]);
                    response[block.indices()[place]] += value.times(slope);
                }
            }
            saddle.solve(response, &mut self.forces[j * m..(j + 1) * m]);
            self.direction.fill(T::default());
            for entry in constraints.starts()[j]..constraints.starts()[j + 1] {
                self.direction[constraints.indices()[entry]] = T::real(slopes.jacobian[entry]);
            }
            for i in 0..m {
                let (value, terms) = row_times(constraints, &slopes.jacobian, i, &self.direction);
                self.schur.add(i, j, value, terms);
                let (value, terms) = row_times(constraints, &slopes.rate, i, response);
                self.schur.add(i, j, -value, terms);
            }
        }
        self.schur.factor().map_err(Singular::Constraint)
    }

    /// Solves in place: right sides of the equations of motion, of the constraints and of their rates.
    pub(super) fn solve(
        &mut self,
        constraints: &Pattern,
        g: T,
        slopes: &Slopes,
        saddle: &mut Saddle<T>,
        (dynamics, positions, rates): (&mut [T], &mut [T], &mut [T]),
    ) {
        let (n, m) = (constraints.rows(), constraints.columns());
        self.work.copy_from_slice(positions);
        saddle.solve(dynamics, positions);
        for (i, rate) in rates.iter_mut().enumerate() {
            *rate -= g * self.work[i] + row_times(constraints, &slopes.rate, i, dynamics).0;
        }
        self.schur.solve(rates);
        for (j, &mu) in rates.iter().enumerate() {
            for (value, &response) in dynamics.iter_mut().zip(&self.responses[j * n..(j + 1) * n]) {
                *value -= response * mu;
            }
            for (value, &force) in positions.iter_mut().zip(&self.forces[j * m..(j + 1) * m]) {
                *value -= force * mu;
            }
        }
    }
}

/// Row i of a transposed pattern times x, and the sum of the sizes of its terms.
fn row_times<T: Scalar>(pattern: &Pattern, values: &[f64], i: usize, x: &[T]) -> (T, f64) {
    let (mut sum, mut terms) = (T::default(), 0.0);
    for entry in pattern.starts()[i]..pattern.starts()[i + 1] {
        let term = x[pattern.indices()[entry]].times(values[entry]);
        sum += term;
        terms += term.size();
    }
    (sum, terms)
}
