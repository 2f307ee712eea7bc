//! The constant tensors of a density that is a polynomial of second degree in the slope (docs/theory.md, Eq. 38): with the relative
//! vectors p and their shape functions h,
//!
//! `int s_a f dxi = d_a f(0) + zeta_aj L p_j + iota_ajm B(p_j, p_m)`, f(u) = f(0) + L u + B(u, u),
//!
//! where iota is the integral of s_a h_j' h_m'; with s = 1 it is zeta, of the whole force.

use std::collections::HashMap;

use super::element::{Element, Part};
use super::integrals::{Integrals, pairs};
use super::law::Split;
use crate::symbolic::{Graph, Id, linear::Vector};

/// Whether the density is a polynomial of second degree in the slope, and does not depend on the position.
pub(super) fn is_quadratic(split: &mut Split) -> bool {
    let [position, slope] = split.locals.clone();
    let force = split.force.clone();
    let graph = &mut split.marked.time.graph;
    let of_slope = |graph: &Graph, id: Id| graph.depends_on(id, &slope);
    force.iter().all(|&component| {
        !graph.depends_on(component, &position)
            && slope.iter().all(|&first| {
                let once = graph.partial(component, first);
                slope.iter().all(|&second| {
                    let twice = graph.partial(once, second);
                    !of_slope(graph, twice)
                })
            })
    }) && force.iter().any(|&component| of_slope(graph, component))
}

impl Element<'_> {
    /// The density with the slope replaced.
    fn at(&self, split: &mut Split, of: &[Id], slope: &[Id]) -> Vector {
        let symbols = split.locals[1].clone();
        let at: HashMap<Id, Id> = symbols.into_iter().zip(slope.iter().copied()).collect();
        let graph = &mut split.marked.time.graph;
        of.iter().map(|&id| graph.substitute(id, &at)).collect()
    }

    /// f(0) and `L p_j` of a density.
    fn affine(&self, split: &mut Split) -> (Vector, Vec<Vector>) {
        let slope = split.locals[1].clone();
        let force = split.force.clone();
        let none = vec![split.marked.time.graph.zero(); slope.len()];
        let constant = self.at(split, &force, &none);
        let gradient: Vec<Vector> = self.gradient(split);
        let gradient: Vec<Vector> = gradient.iter().map(|row| self.at(split, row, &none)).collect();
        let graph = &mut split.marked.time.graph;
        let of_vector = |(_, p): &(usize, Vector)| gradient.iter().map(|row| graph.dot(row, p)).collect();
        (constant, self.relative.iter().map(of_vector).collect())
    }

    /// Derivatives of the density by the slope, rows first.
    fn gradient(&self, split: &mut Split) -> Vec<Vector> {
        let slope = split.locals[1].clone();
        let force = split.force.clone();
        let graph = &mut split.marked.time.graph;
        let row = |&component: &Id| slope.iter().map(|&by| graph.partial(component, by)).collect();
        force.iter().map(row).collect()
    }

    /// The integrals of the density with all shape functions of relative vectors, and with 1.
    pub(super) fn force_by_tensors(&self, split: &mut Split, integrals: &Integrals) -> Part {
        let (constant, linear) = self.affine(split);
        let products = self.products(split, &constant, &linear);
        let graph = &mut split.marked.time.graph;
        let mut rows = (0..=self.relative.len()).map(|row| -> Vector {
            let mut sum: Vector = {
                let weight = graph.number(integrals.constant[row]);
                graph.scale(weight, &constant)
            };
            for (j, part) in linear.iter().enumerate() {
                let weight = graph.number(integrals.linear[row][j]);
                let part = graph.scale(weight, part);
                sum = graph.add_vectors(&sum, &part);
            }
            for (part, &weight) in products.iter().zip(&integrals.quadratic[row]) {
                let weight = graph.number(weight);
                let part = graph.scale(weight, part);
                sum = graph.add_vectors(&sum, &part);
            }
            sum
        });
        let sums = rows.by_ref().take(self.relative.len()).collect();
        Part {
            sums,
            whole: rows.next().unwrap_or_default(),
        }
    }

    /// `B(p_j, p_j)`, and `2 B(p_j, p_m)` of different vectors, by pairs.
    fn products(&self, split: &mut Split, constant: &[Id], linear: &[Vector]) -> Vec<Vector> {
        let force = split.force.clone();
        let step = split.marked.time.graph.symbol("step");
        let mut products = Vec::new();
        for (j, m) in pairs(self.relative.len()) {
            let (p, other) = (&self.relative[j].1, &self.relative[m].1);
            if j == m {
                let whole = self.at(split, &force, p);
                let graph = &mut split.marked.time.graph;
                let without = graph.subtract_vectors(&whole, constant);
                products.push(graph.subtract_vectors(&without, &linear[j]));
                continue;
            }
            // The derivative of f(p_j + step p_m) by the step is L p_m + 2 B(p_j, p_m) at zero.
            let graph = &mut split.marked.time.graph;
            let way = graph.scale(step, other);
            let moved = graph.add_vectors(p, &way);
            let along = self.at(split, &force, &moved);
            let graph = &mut split.marked.time.graph;
            let zero = graph.zero();
            let start = HashMap::from([(step, zero)]);
            let derivative: Vector = along
                .into_iter()
                .map(|id| {
                    let rate = graph.partial(id, step);
                    graph.substitute(rate, &start)
                })
                .collect();
            products.push(graph.subtract_vectors(&derivative, &linear[m]));
        }
        products
    }

    /// Derivatives of those integrals by the components of the relative vectors, column by column.
    pub(super) fn tangent_by_tensors(&self, split: &mut Split, integrals: &Integrals) -> Vec<Part> {
        let d = split.force.len();
        let zero = split.marked.time.graph.zero();
        let gradient = self.gradient(split);
        let none = vec![zero; d];
        let linear: Vec<Vector> = gradient.iter().map(|row| self.at(split, row, &none)).collect();
        // What is linear in the vectors: 2 B(p_m, .).
        let mut bilinear: Vec<Vec<Vector>> = Vec::new();
        for (_, p) in &self.relative {
            let rows = gradient.iter().zip(&linear).map(|(row, linear)| {
                let whole = self.at(split, row, p);
                split.marked.time.graph.subtract_vectors(&whole, linear)
            });
            bilinear.push(rows.collect());
        }
        let graph = &mut split.marked.time.graph;
        let mut parts = Vec::new();
        for column in 0..self.relative.len() {
            for by in 0..d {
                let mut rows = (0..=self.relative.len()).map(|row| -> Vector {
                    (0..d)
                        .map(|component| {
                            let weight = graph.number(integrals.linear[row][column]);
                            let mut sum = graph.multiply(weight, linear[component][by]);
                            for (m, matrix) in bilinear.iter().enumerate() {
                                let weight = graph.number(integrals.quadratic(row, column, m));
                                let product = graph.multiply(weight, matrix[component][by]);
                                sum = graph.add(sum, product);
                            }
                            sum
                        })
                        .collect()
                });
                let sums = rows.by_ref().take(self.relative.len()).collect();
                parts.push(Part {
                    sums,
                    whole: rows.next().unwrap_or_default(),
                });
            }
        }
        parts
    }
}
