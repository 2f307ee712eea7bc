//! The way to the equilibrium.

use super::NEGLIGIBLE;
use super::balance::Balance;
use crate::emitted::StartSpec;
use crate::error::ModelError;
use crate::linalg::Lu;

/// Most iterations; strings that begin straight take some 20.
const ITERATIONS: usize = 300;
/// Increment of an unknown, relative to its size, beyond which a step is shortened.
const LONGEST: f64 = 0.3;
/// Root mean square of increments, relative to the unknowns' sizes, that ends the iteration.
const CONVERGED: f64 = 1e-14;
/// The same where round-off of the forces keeps the imbalance from falling.
const STAGNANT: f64 = 1e-7;
/// Iterations that bring nothing before it counts as round-off.
const IDLE: u32 = 3;
/// Largest drag, relative to w^2, at which increments tell the distance from the equilibrium.
const LIGHT: f64 = 1e-3;
/// Least drag, relative to w^2: what turns freely about the axis has no place of its own.
const LEAST: f64 = 1e-6;
/// Part of the foreseen decrease of the potential that a step must bring.
const ENOUGH: f64 = 1e-3;
/// Round-off of a potential, relative to its parts.
const NOISE: f64 = 1e-13;
/// Imbalance, relative to the largest inertia of a node, that no equilibrium has: strains of short elements have
/// round-off, and their stiffness is large.
const UNBALANCED: f64 = 1e-2;
/// Where the iteration is.
struct Point {
    x: Vec<f64>,
    residual: Vec<f64>,
    energies: [f64; 2],
    /// Largest energies of residual and inertia over the sizes of unknowns, J.
    imbalance: f64,
    acting: f64,
}

impl Point {
    fn potential(&self) -> f64 {
        self.energies[0] - self.energies[1]
    }

    fn noise(&self) -> f64 {
        NOISE * (self.energies[0].abs() + self.energies[1].abs())
    }
}

impl Balance<'_> {
    fn point(&mut self, x: Vec<f64>) -> Point {
        self.load(&x);
        let n = x.len();
        let mut residual = vec![0.0; self.pattern.columns()];
        let acting = self.residual(&mut residual);
        Point {
            energies: self.energies(),
            imbalance: self.largest(&residual[..n]),
            residual,
            acting,
            x,
        }
    }

    /// Components of all vectors in the equilibrium.
    pub(super) fn find(&mut self, start: &StartSpec) -> Result<Vec<f64>, ModelError> {
        let n = self.layout.unknowns();
        let mut lu = Lu::<f64>::new(&self.pattern);
        let (mut tangent, mut matrix) = (Vec::new(), vec![0.0; self.pattern.entries()]);
        let x = self.unknowns();
        let mut at = self.point(x);
        self.tangent(&mut tangent);
        let unit = if self.square > 0.0 {
            self.square
        } else {
            self.softness(&tangent)
        };
        let (mut drag, mut idle) = (4.0 * unit, 0);
        for _ in 0..ITERATIONS {
            let all = at.residual.iter().chain(&tangent).chain(&at.energies);
            if !all.copied().all(f64::is_finite) {
                break;
            }
            let mut increments: Vec<f64> = at.residual.iter().map(|value| -value).collect();
            for ((sum, mass), value) in matrix.iter_mut().zip(&self.mass).zip(&tangent) {
                *sum = value + drag * mass;
            }
            if lu.factor(&matrix).is_err() {
                drag = 4.0 * drag.max(LEAST * unit);
                continue;
            }
            lu.solve(&mut increments);
            let (change, new) = increments.split_at(n);
            let size = self.size(change);
            let is_near = size <= CONVERGED || size <= STAGNANT && idle >= IDLE;
            if drag <= LIGHT * unit && is_near {
                return self.accept(start, &at);
            }
            let trial = self.attempt(&at, change, new, &tangent);
            let Some((next, quality)) = trial else {
                idle += u32::from(size <= STAGNANT);
                drag *= if size <= STAGNANT { 1.0 } else { 4.0 };
                continue;
            };
            idle = if next.imbalance > 0.5 * at.imbalance {
                idle + 1
            } else {
                0
            };
            drag *= if quality > 0.5 {
                0.1
            } else if quality < 0.25 {
                2.0
            } else {
                1.0
            };
            drag = drag.max(LEAST * unit);
            at = next;
            self.load(&at.x);
            self.tangent(&mut tangent);
        }
        Err(self.lost(start, &at))
    }

    /// The point behind an increment and how well its decrease of the potential was foreseen; `None` where the
    /// increment is too long or the potential does not fall.
    fn attempt(&mut self, at: &Point, change: &[f64], multipliers: &[f64], tangent: &[f64]) -> Option<(Point, f64)> {
        let n = change.len();
        let longest = change.iter().zip(&self.inverse_sizes);
        let longest = longest.fold(0.0, |most: f64, (change, inverse)| most.max((change * inverse).abs()));
        if longest > LONGEST || !change.iter().all(|change| change.is_finite()) {
            return None;
        }
        let slope: f64 = change
            .iter()
            .zip(&at.residual)
            .map(|(change, force)| change * force)
            .sum();
        let mut whole = change.to_vec();
        whole.resize(self.pattern.columns(), 0.0);
        let mut along = vec![0.0; whole.len()];
        self.pattern.multiply_add(1.0, tangent, &whole, &mut along);
        let curvature: f64 = change.iter().zip(&along).map(|(change, force)| change * force).sum();
        let foreseen = -(slope + 0.5 * curvature);
        let x = at.x.iter().zip(change).map(|(x, change)| x + change).collect();
        let mut next = self.point(x);
        if !multipliers.is_empty() {
            // Multipliers are found anew each time; the balance is that with them.
            let mut forces = next.residual[..n].to_vec();
            self.add_multipliers(multipliers, &mut forces);
            next.imbalance = self.largest(&forces);
        }
        let violated = at.residual[n..].iter().any(|value| value.abs() > NEGLIGIBLE);
        if violated {
            return Some((next, 1.0));
        }
        if foreseen.abs() <= at.noise() {
            return (next.imbalance <= 10.0 * at.imbalance.max(NEGLIGIBLE * at.acting)).then_some((next, 1.0));
        }
        let quality = (at.potential() - next.potential()) / foreseen;
        (foreseen > 0.0 && quality > ENOUGH).then_some((next, quality))
    }

    /// `C^T lambda` of ties.
    fn add_multipliers(&self, multipliers: &[f64], forces: &mut [f64]) {
        let mut column = 0;
        for tie in &self.ties {
            for row in &tie.rows {
                for (place, value) in row.iter().enumerate() {
                    for (unknown, factor) in self.layout.unknowns_at(tie.first + place) {
                        forces[unknown] += factor * value * multipliers[column];
                    }
                }
                column += 1;
            }
        }
    }

    /// A rate, 1/s^2, below those of the elastic forces.
    fn softness(&self, tangent: &[f64]) -> f64 {
        let trace = |values: &[f64]| -> f64 {
            let places = (0..self.layout.unknowns()).filter_map(|i| self.pattern.find(i, i));
            places.map(|place| values[place]).sum()
        };
        let rate = trace(tangent).abs() / trace(&self.mass);
        if rate.is_finite() && rate > 0.0 {
            1e-3 * rate
        } else {
            1.0
        }
    }

    /// Root mean square of increments relative to the sizes of the unknowns.
    fn size(&self, change: &[f64]) -> f64 {
        let parts = change.iter().zip(&self.inverse_sizes);
        let sum: f64 = parts.map(|(change, inverse)| (change * inverse).powi(2)).sum();
        (sum / change.len().max(1) as f64).sqrt()
    }

    fn accept(&mut self, start: &StartSpec, at: &Point) -> Result<Vec<f64>, ModelError> {
        if at.imbalance > UNBALANCED * at.acting {
            return Err(self.lost(start, at));
        }
        self.load(&at.x);
        Ok(self.q.clone())
    }

    /// Says how far the iteration came.
    fn lost(&self, start: &StartSpec, at: &Point) -> ModelError {
        let frame = self.scene.parts.frame_name(start.frame);
        let energy = |unknown: usize| (at.residual[unknown] / self.inverse_sizes[unknown]).abs();
        let worst = (0..at.x.len()).max_by(|&i, &j| energy(i).total_cmp(&energy(j)));
        let place = worst.map_or(String::new(), |unknown| {
            let (vector, _) = self.layout.origins()[unknown];
            let (body, node, local) = self.scene.locate(vector);
            let what = body.spec.nodal[local].meaning;
            format!(", most at the {what} of node {node} of body `{}`", body.spec.label())
        });
        let part = at.imbalance / at.acting;
        let part = if part.is_finite() {
            format!("what is not balanced is still {part:.1e} of the inertia{place}")
        } else {
            "its forces are not finite".to_string()
        };
        ModelError::new(format!(
            "start `{}`: no equilibrium of the bodies in frame `{frame}` with its rotation was found: {part}; give the bodies an initial shape nearer to it (`initial position`), hold what can fall over, or use more elements",
            start.name
        ))
    }
}
