//! Elastic and damping forces on modal coordinates, `F_ei = phi_ia . F_e^a(q(p))`: for energies of
//! quadratic strains cubic polynomials with constant coefficients (THEORY 3.2), else projected from
//! the elements.

use super::body::ModalBody;
use super::expansion::{Elastic, Expansion};
use crate::emitted::Fidelity;
use crate::linalg::times;
use crate::scene::bodies::described::Elements;
use crate::scene::numbering::assembly::evaluate;

/// With more modes the k^4 coefficients cost more than the elements.
const MOST_MODES: usize = 8;
/// Part of the modes' sizes at which coefficients are taken.
const AMPLITUDE: f64 = 0.1;
/// Relative difference from the elements up to which forces count as polynomial.
const ROUND_OFF: f64 = 1e-9;

impl ModalBody {
    /// Adds elastic and damping forces on the modal coordinates.
    pub(super) fn elastic_force(&self, elements: &dyn Elements, p: &[f64], v: &[f64], out: &mut [f64]) {
        match &self.elastic {
            Elastic::Elements => self.projected_force(elements, p, v, out),
            Elastic::Expanded { stiffness, damping } => {
                add_to(out, &stiffness.integral(p));
                if let Some(damping) = damping {
                    add_to(out, &times(p.len(), &damping.at(p), v));
                }
            }
        }
    }

    /// Adds their derivatives with respect to p and p'.
    pub(super) fn elastic_tangent(&self, elements: &dyn Elements, p: &[f64], v: &[f64], k: &mut [f64], c: &mut [f64]) {
        match &self.elastic {
            Elastic::Elements => self.projected_tangent(elements, p, v, k, c),
            Elastic::Expanded { stiffness, damping } => {
                add_to(k, &stiffness.at(p));
                if let Some(damping) = damping {
                    add_to(c, &damping.at(p));
                    damping.add_derivative(p, v, k);
                }
            }
        }
    }

    /// Constants where they serve: always for small deformations.
    pub(super) fn prepare_elastic(&self, elements: &dyn Elements) -> Elastic {
        let k = self.modes();
        let zeros = vec![0.0; k];
        let matrices = |p: &[f64]| {
            let (mut stiffness, mut damping) = (vec![0.0; k * k], vec![0.0; k * k]);
            self.projected_tangent(elements, p, &zeros, &mut stiffness, &mut damping);
            [stiffness, damping]
        };
        let some = |damping: Expansion| damping.constant.iter().any(|&c| c != 0.0).then_some(damping);
        if matches!(self.fidelity, Fidelity::Small(_)) {
            let mut stiffness = vec![0.0; k * k];
            for (i, frequency) in self.frequencies.iter().enumerate() {
                stiffness[i * k + i] = frequency * frequency;
            }
            let [_, damping] = matrices(&zeros);
            return Elastic::Expanded {
                stiffness: Expansion::constant(stiffness),
                damping: some(Expansion::constant(damping)),
            };
        }
        if k == 0 || k > MOST_MODES {
            return Elastic::Elements;
        }
        let steps: Vec<f64> = self.sizes.iter().map(|size| AMPLITUDE * size).collect();
        let [stiffness, damping] = [0, 1].map(|which| Expansion::of(&steps, |p| matrices(p)[which].clone()));
        let expanded = Self {
            elastic: Elastic::Expanded {
                stiffness,
                damping: some(damping),
            },
            ..self.clone()
        };
        if self.agrees(&expanded, elements, &steps) {
            expanded.elastic
        } else {
            Elastic::Elements
        }
    }

    /// Whether the constants reproduce the elements at a displaced and moving state.
    fn agrees(&self, expanded: &Self, elements: &dyn Elements, steps: &[f64]) -> bool {
        let k = self.modes();
        let p: Vec<f64> = steps
            .iter()
            .enumerate()
            .map(|(i, s)| s * (1.3 - 0.4 * i as f64))
            .collect();
        let v: Vec<f64> = steps
            .iter()
            .zip(&self.frequencies)
            .enumerate()
            .map(|(i, (s, w))| s * w * (0.6 + 0.3 * i as f64))
            .collect();
        let [mut force, mut other] = [vec![0.0; k], vec![0.0; k]];
        self.projected_force(elements, &p, &v, &mut force);
        expanded.elastic_force(elements, &p, &v, &mut other);
        let size = force.iter().map(|f| f.abs()).fold(0.0, f64::max);
        force.iter().zip(&other).all(|(a, b)| (a - b).abs() <= ROUND_OFF * size)
    }

    /// Nodal vectors of one element and k numbers of phi for each of its components.
    pub(super) fn gathered(&self, element: usize, full: &[f64]) -> Vec<f64> {
        let mut local = vec![0.0; self.nodal.connectivity.size];
        self.nodal.connectivity.gather(element, full, &mut local);
        local
    }

    pub(super) fn full(&self, p: &[f64], v: &[f64]) -> [Vec<f64>; 2] {
        let mut full = [vec![0.0; self.nodal.shape.len()], vec![0.0; self.nodal.shape.len()]];
        self.expand(p, &mut full[0]);
        self.expand_rate(v, &mut full[1]);
        full
    }

    /// Adds the forces of all elements, projected.
    pub(super) fn projected_force(&self, elements: &dyn Elements, p: &[f64], v: &[f64], out: &mut [f64]) {
        let k = self.modes();
        if k == 0 {
            return;
        }
        let [q, v] = self.full(p, v);
        let connectivity = &self.nodal.connectivity;
        let mut results = Vec::new();
        evaluate(connectivity.count(), k, &mut results, |element, result| {
            let mut force = vec![0.0; connectivity.size];
            let (q, v) = (self.gathered(element, &q), self.gathered(element, &v));
            elements.force(element, &q, &v, &mut force);
            for (value, &component) in force.iter().zip(connectivity.element(element)) {
                for (sum, mode) in result.iter_mut().zip(self.mode_row(component)) {
                    *sum += mode * value;
                }
            }
        });
        results.chunks_exact(k).for_each(|part| add_to(out, part));
    }

    /// Adds the tangents of all elements, projected from both sides.
    pub(super) fn projected_tangent(
        &self,
        elements: &dyn Elements,
        p: &[f64],
        v: &[f64],
        stiffness: &mut [f64],
        damping: &mut [f64],
    ) {
        let k = self.modes();
        if k == 0 {
            return;
        }
        let [q, v] = self.full(p, v);
        let connectivity = &self.nodal.connectivity;
        let mut results = Vec::new();
        evaluate(connectivity.count(), 2 * k * k, &mut results, |element, result| {
            let entries = connectivity.size * connectivity.size;
            let mut local = [vec![0.0; entries], vec![0.0; entries]];
            let (q, v) = (self.gathered(element, &q), self.gathered(element, &v));
            let [by_position, by_rate] = &mut local;
            elements.tangent(element, &q, &v, by_position, by_rate);
            for (matrix, out) in local.iter().zip(result.chunks_exact_mut(k * k)) {
                self.project_matrix(connectivity.element(element), matrix, out);
            }
        });
        for part in results.chunks_exact(2 * k * k) {
            add_to(stiffness, &part[..k * k]);
            add_to(damping, &part[k * k..]);
        }
    }

    /// Adds `phi^T A phi` of one element.
    fn project_matrix(&self, components: &[usize], matrix: &[f64], out: &mut [f64]) {
        let k = self.modes();
        let mut line = vec![0.0; k];
        for (&row, entries) in components.iter().zip(matrix.chunks_exact(components.len())) {
            // Undamped elements have no damping matrix.
            if entries.iter().all(|&entry| entry == 0.0) {
                continue;
            }
            line.fill(0.0);
            for (&column, entry) in components.iter().zip(entries) {
                for (sum, mode) in line.iter_mut().zip(self.mode_row(column)) {
                    *sum += entry * mode;
                }
            }
            for (part, mode) in out.chunks_exact_mut(k).zip(self.mode_row(row)) {
                part.iter_mut().zip(&line).for_each(|(sum, value)| *sum += mode * value);
            }
        }
    }
}

fn add_to(sum: &mut [f64], values: &[f64]) {
    sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
}
