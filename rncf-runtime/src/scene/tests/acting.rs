//! What acts on parts by hand: loads, constraints and forces on markers, densities.

use super::model::{Hand, sine};
use super::{density, sections};
use crate::course::Courses;
use crate::emitted::{
    ConstraintSpec, Densities, DensitySpec, ForceSpec, GravityFields, LANES, LoadSpec, Loads, MarkerConstraints,
    MarkerForces, SectionMoments, SlopeMoments,
};
use crate::space::Vector;
use crate::system::ConstraintLevel;

impl Loads for Hand {
    fn loads(&self) -> Vec<LoadSpec> {
        self.loads.iter().map(|(load, _)| load.clone()).collect()
    }
    fn load_varies(&self, _load: usize) -> bool {
        false
    }
    fn load(&self, load: usize, _t: f64) -> [f64; 3] {
        self.loads[load].1.into()
    }
}

impl SlopeMoments for Hand {
    fn moment(&self, dimension: usize, slope: &[f64], moment: [f64; 3], force: &mut [f64]) {
        let [slope, moment] = spread(dimension, slope, moment.into());
        let value = on_slope(slope, moment);
        force.iter_mut().zip(&value).for_each(|(force, value)| *force += value);
    }
    fn moment_tangent(&self, dimension: usize, slope: &[f64], moment: [f64; 3], tangent: &mut [f64]) {
        let [slope, moment] = spread(dimension, slope, moment.into());
        let size = slope.dot(&slope);
        let value = on_slope(slope, moment);
        let turn = moment.cross_matrix();
        for i in 0..dimension {
            for j in 0..dimension {
                tangent[i * dimension + j] += turn[(i, j)] / size - 2.0 * value[i] * slope[j] / size;
            }
        }
    }
}

impl SectionMoments for Hand {
    fn section_moment(&self, axes: &[f64; 6], moment: [f64; 3], force: &mut [f64; 6]) {
        let value = sections::moment(axes, moment.into());
        force.iter_mut().zip(&value).for_each(|(force, value)| *force += value);
    }
    fn section_moment_tangent(&self, axes: &[f64; 6], moment: [f64; 3], tangent: &mut [f64; 36]) {
        for column in 0..6 {
            let at = |step: f64| {
                let mut moved = *axes;
                moved[column] += step;
                sections::moment(&moved, moment.into())
            };
            let [high, low] = [at(1e-5), at(-1e-5)];
            (0..6).for_each(|row| tangent[row * 6 + column] += (high[row] - low[row]) / 2e-5);
        }
    }
}

impl MarkerConstraints for Hand {
    fn constraints(&self) -> Vec<ConstraintSpec> {
        self.constraints.iter().map(|(spec, _)| spec.clone()).collect()
    }
    fn marker_constraint(
        &self,
        constraint: usize,
        level: ConstraintLevel,
        t: f64,
        z: &[[Vector; 4]],
        rows: &mut [f64],
    ) {
        const BINOMIAL: [[f64; 4]; 4] = [
            [1.0, 0.0, 0.0, 0.0],
            [1.0, 1.0, 0.0, 0.0],
            [1.0, 2.0, 1.0, 0.0],
            [1.0, 3.0, 3.0, 1.0],
        ];
        let order = level as usize;
        for (row, form) in rows.iter_mut().zip(&self.constraints[constraint].1) {
            *row = form.sine * sine(t, order) + if order == 0 { form.constant } else { 0.0 };
            for &(m, n, factor) in &form.products {
                for k in 0..=order {
                    *row += factor * BINOMIAL[order][k] * z[m][k].dot(&z[n][order - k]);
                }
            }
            for &(m, b) in &form.linear {
                *row += b.dot(&z[m][order]);
            }
        }
    }
    fn marker_constraint_gradient(&self, constraint: usize, _t: f64, z: &[Vector], gradient: &mut [f64]) {
        for (row, form) in gradient
            .chunks_exact_mut(3 * z.len())
            .zip(&self.constraints[constraint].1)
        {
            for i in 0..3 {
                for &(m, n, factor) in &form.products {
                    row[3 * m + i] += factor * z[n][i];
                    row[3 * n + i] += factor * z[m][i];
                }
                for &(m, b) in &form.linear {
                    row[3 * m + i] += b[i];
                }
            }
        }
    }
    fn marker_constraint_rate_gradient(
        &self,
        constraint: usize,
        _t: f64,
        z: &[Vector],
        velocity: &[Vector],
        gradient: &mut [f64],
    ) {
        for (row, form) in gradient
            .chunks_exact_mut(3 * z.len())
            .zip(&self.constraints[constraint].1)
        {
            for i in 0..3 {
                for &(m, n, factor) in &form.products {
                    row[3 * m + i] += factor * velocity[n][i];
                    row[3 * n + i] += factor * velocity[m][i];
                }
            }
        }
    }
    fn marker_constraint_hessian(&self, constraint: usize, _t: f64, z: &[Vector], lambda: &[f64], hessian: &mut [f64]) {
        let width = 3 * z.len();
        for (lambda, form) in lambda.iter().zip(&self.constraints[constraint].1) {
            for &(m, n, factor) in &form.products {
                for i in 0..3 {
                    hessian[(3 * m + i) * width + 3 * n + i] += lambda * factor;
                    hessian[(3 * n + i) * width + 3 * m + i] += lambda * factor;
                }
            }
        }
    }
    fn marker_constraint_branches(&self, _constraint: usize, _t: f64, _z: &[Vector], _out: &mut [f64]) {}
}

impl MarkerForces for Hand {
    fn forces(&self) -> Vec<ForceSpec> {
        self.forces.iter().map(|(spec, _)| spec.clone()).collect()
    }
    fn is_load(&self, _force: usize) -> bool {
        false
    }
    fn marker_force(&self, force: usize, _t: f64, z: &[Vector], velocity: &[Vector], out: &mut [f64]) {
        self.forces[force].1.force(z, velocity, out);
    }
    fn marker_force_tangent(
        &self,
        force: usize,
        _t: f64,
        z: &[Vector],
        _velocity: &[Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        self.forces[force].1.tangent(z, by_value, by_velocity);
    }
    fn marker_energy(&self, force: usize, _t: f64, z: &[Vector]) -> f64 {
        self.forces[force].1.energy(z)
    }
    fn marker_force_branches(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    fn force_course(&self, _force: usize) -> Option<Courses> {
        None
    }
}

impl Densities for Hand {
    /// Of the strain energies 3/2 (r_x . r_x - 1)^2 and r_xx . r_xx per unit length.
    fn densities(&self) -> Vec<DensitySpec> {
        self.densities.clone()
    }
    fn density_values(&self, _density: usize, t: f64, z: &[Vector], _velocity: &[Vector], out: &mut [f64]) {
        out.copy_from_slice(&density::values(t, z));
    }
    fn density_values_gradient(
        &self,
        _density: usize,
        _t: f64,
        z: &[Vector],
        _velocity: &[Vector],
        gradient: &mut [f64],
    ) {
        density::gradient(z, gradient);
    }
    fn density_force4(
        &self,
        _density: usize,
        elements: &[(usize, usize); LANES],
        values: &[[f64; LANES]],
        q: &[[f64; LANES]],
        force: &mut [[f64; LANES]],
    ) {
        let lengths = elements.map(|(body, _)| self.lengths[body]);
        density::force(lengths, values, q, force);
    }
    fn density_tangent4(
        &self,
        _density: usize,
        elements: &[(usize, usize); LANES],
        values: &[[f64; LANES]],
        q: &[[f64; LANES]],
        by_q: &mut [[f64; LANES]],
        by_values: &mut [[f64; LANES]],
    ) {
        let lengths = elements.map(|(body, _)| self.lengths[body]);
        density::tangent(lengths, values, q, by_q, by_values);
    }
}

impl GravityFields for Hand {
    fn field(&self, load: usize, _t: f64, z: &[Vector]) -> [f64; 3] {
        density::field(self.loads[load].1, z).into()
    }
    fn field_gradient(&self, load: usize, _t: f64, z: &[Vector], gradient: &mut [f64]) {
        density::field_gradient(self.loads[load].1, z, gradient);
    }
}

/// A slope's force from a moment: `m x s / |s|^2`, planar: about the normal.
fn on_slope(slope: Vector, moment: Vector) -> Vector {
    1.0 / slope.dot(&slope) * moment.cross(&slope)
}

fn spread(dimension: usize, slope: &[f64], moment: Vector) -> [Vector; 2] {
    let mut full = [0.0; 3];
    full[..dimension].copy_from_slice(slope);
    let moment = if dimension == 2 {
        [0.0, 0.0, moment[0]]
    } else {
        moment.into()
    };
    [full.into(), moment.into()]
}
