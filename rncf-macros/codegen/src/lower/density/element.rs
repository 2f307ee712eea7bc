//! The generalised forces of a density on one element, and their derivatives: summed over points, or by constant tensors.

use std::collections::HashMap;

use super::integrals::Integrals;
use super::law::{Law, Split};
use crate::lower::quadratic::{base_vector, is_position, relative_shapes};
use crate::symbolic::{Graph, Id, linear::Vector};

/// Position and slope at a point, and what they depend on.
pub(super) struct Point {
    pub weight: f64,
    /// Shape functions of the relative vectors and their derivatives d/dxi.
    pub shapes: [Vec<f64>; 2],
}

/// How the density is integrated over the element.
pub(super) enum Rule {
    /// Gauss points.
    Points(Vec<Point>),
    /// Integrals of products of shape functions.
    Tensors(Integrals),
}

/// An integral of a density: with the shape functions of the relative vectors, and with 1.
pub(super) struct Part {
    pub sums: Vec<Vector>,
    pub whole: Vector,
}

/// Symbols of an element.
pub(super) struct Element<'r> {
    length: Id,
    /// Nodal vectors.
    q: Vec<Vector>,
    /// Vectors relative to the base, positions divided by the length; index and components.
    pub relative: Vec<(usize, Vector)>,
    base: usize,
    rule: &'r Rule,
}

impl<'r> Element<'r> {
    pub fn new(of: &Law, graph: &mut Graph, rule: &'r Rule) -> Self {
        let length = graph.symbol("length");
        let names = of.variant.component_names(of.library, "");
        let q: Vec<Vector> = names
            .into_iter()
            .map(|names| names.into_iter().map(|name| graph.symbol(name)).collect())
            .collect();
        let base = base_vector(&of.vectors);
        let shapes = relative_shapes(&of.vectors);
        let relative = shapes.iter().map(|&(index, _)| {
            if !is_position(of.vectors[index]) {
                return (index, q[index].clone());
            }
            let apart = graph.subtract_vectors(&q[index], &q[base]);
            (index, apart.into_iter().map(|x| graph.divide(x, length)).collect())
        });
        let relative = relative.collect();
        Self {
            length,
            q,
            relative,
            base,
            rule,
        }
    }

    /// What stands for position and slope at a point.
    fn locals(&self, split: &mut Split, point: &Point) -> HashMap<Id, Id> {
        let [position, slope] = split.locals.clone();
        let graph = &mut split.marked.time.graph;
        let mut at = HashMap::new();
        for c in 0..slope.len() {
            let sum = |graph: &mut Graph, weights: &[f64]| {
                let mut sum = graph.zero();
                for ((_, vector), &weight) in self.relative.iter().zip(weights) {
                    let weight = graph.number(weight);
                    let product = graph.multiply(weight, vector[c]);
                    sum = graph.add(sum, product);
                }
                sum
            };
            let within = sum(graph, &point.shapes[0]);
            let scaled = graph.multiply(self.length, within);
            at.insert(position[c], graph.add(self.q[self.base][c], scaled));
            at.insert(slope[c], sum(graph, &point.shapes[1]));
        }
        at
    }

    /// Generalised forces: those of positions add up to the whole, `Q_base = F - sum Q_position`.
    pub fn forces(&self, of: &Law, split: &mut Split) -> Vector {
        let part = match self.rule {
            Rule::Points(points) => self.force_by_points(of, split, points),
            Rule::Tensors(integrals) => self.force_by_tensors(split, integrals),
        };
        self.completed(of, split, part, 1).concat()
    }

    fn force_by_points(&self, of: &Law, split: &mut Split, points: &[Point]) -> Part {
        let d = of.axes.len();
        let zero = split.marked.time.graph.zero();
        let mut whole = vec![zero; d];
        let mut sums = vec![vec![zero; d]; self.relative.len()];
        for point in points {
            let at = self.locals(split, point);
            let graph = &mut split.marked.time.graph;
            let weight = graph.number(point.weight);
            for c in 0..d {
                let force = graph.substitute(split.force[c], &at);
                let force = graph.multiply(weight, force);
                whole[c] = graph.add(whole[c], force);
                for (sum, &shape) in sums.iter_mut().zip(&point.shapes[0]) {
                    let shape = graph.number(shape);
                    let product = graph.multiply(shape, force);
                    sum[c] = graph.add(sum[c], product);
                }
            }
        }
        Part { sums, whole }
    }

    /// Rows of all nodal vectors from the whole and those of the relative ones, times their lengths, a power of the element's, and
    /// the density's factor.
    fn completed(&self, of: &Law, split: &mut Split, part: Part, power: i32) -> Vec<Vector> {
        let factor = split.factor;
        let graph = &mut split.marked.time.graph;
        let mut rows = vec![Vec::new(); self.q.len()];
        let mut base = part.whole;
        for ((index, _), sum) in self.relative.iter().zip(part.sums) {
            let vector = of.vectors[*index];
            if is_position(vector) {
                base = graph.subtract_vectors(&base, &sum);
            }
            let scale = graph.power(self.length, power + vector.order as i32);
            let scale = graph.multiply(scale, factor);
            rows[*index] = graph.scale(scale, &sum);
        }
        let scale = graph.power(self.length, power);
        let scale = graph.multiply(scale, factor);
        rows[self.base] = graph.scale(scale, &base);
        rows
    }

    /// dQ/dq; columns of positions are differences, the base takes what is left.
    pub fn by_q(&self, of: &Law, split: &mut Split) -> Vec<(String, Id)> {
        let (d, count) = (of.axes.len(), self.q.len());
        let size = d * count;
        let zero = split.marked.time.graph.zero();
        let parts = match self.rule {
            Rule::Points(points) => self.tangent_by_points(of, split, points),
            Rule::Tensors(integrals) => self.tangent_by_tensors(split, integrals),
        };
        let mut entries = vec![vec![zero; size]; size];
        for (to, part) in parts.into_iter().enumerate() {
            let (column, by) = (to / d, to % d);
            // Relative positions are divided by the length.
            let index = self.relative.get(column).map(|&(index, _)| index);
            let is_position = index.is_some_and(|index| is_position(of.vectors[index]));
            let rows = self.completed(of, split, part, i32::from(!is_position)).concat();
            let graph = &mut split.marked.time.graph;
            for (row, entry) in rows.into_iter().enumerate() {
                let base = self.base * d + by;
                let Some(index) = index else {
                    entries[row][base] = graph.add(entries[row][base], entry);
                    continue;
                };
                entries[row][index * d + by] = entry;
                if is_position {
                    entries[row][base] = graph.subtract(entries[row][base], entry);
                }
            }
        }
        let graph = &split.marked.time.graph;
        let mut outputs = Vec::new();
        for (row, entries) in entries.into_iter().enumerate() {
            let places = entries.into_iter().enumerate();
            let there = places.filter(|&(_, entry)| !graph.is_zero(entry));
            outputs.extend(there.map(|(column, entry)| (format!("by_q[{}]", row * size + column), entry)));
        }
        outputs
    }

    /// By relative vectors, then by a shift of the whole element, from the derivatives of the density by slope and position at
    /// each point.
    fn tangent_by_points(&self, of: &Law, split: &mut Split, points: &[Point]) -> Vec<Part> {
        let d = of.axes.len();
        let zero = split.marked.time.graph.zero();
        let columns = self.relative.len() + 1;
        let mut whole = vec![vec![zero; d]; columns * d];
        let mut sums = vec![vec![vec![zero; d]; self.relative.len()]; columns * d];
        let partials = [0, 1].map(|order| -> Vec<Vector> {
            let locals = split.locals[order].clone();
            let graph = &mut split.marked.time.graph;
            let of_component = |&force: &Id| locals.iter().map(|&local| graph.partial(force, local)).collect();
            split.force.iter().map(of_component).collect()
        });
        for point in points {
            let at = self.locals(split, point);
            let graph = &mut split.marked.time.graph;
            let weight = graph.number(point.weight);
            for row in 0..d {
                for by in 0..d {
                    let [position, slope] = [0, 1].map(|order| {
                        let partial = graph.substitute(partials[order][row][by], &at);
                        graph.multiply(weight, partial)
                    });
                    let carried = graph.multiply(self.length, position);
                    for column in 0..columns {
                        let change = match (point.shapes[0].get(column), point.shapes[1].get(column)) {
                            (Some(&shape), Some(&derivative)) => {
                                let (shape, derivative) = (graph.number(shape), graph.number(derivative));
                                let (a, b) = (graph.multiply(shape, carried), graph.multiply(derivative, slope));
                                graph.add(a, b)
                            }
                            _ => position,
                        };
                        let to = column * d + by;
                        whole[to][row] = graph.add(whole[to][row], change);
                        for (sum, &shape) in sums[to].iter_mut().zip(&point.shapes[0]) {
                            let shape = graph.number(shape);
                            let product = graph.multiply(shape, change);
                            sum[row] = graph.add(sum[row], product);
                        }
                    }
                }
            }
        }
        let parts = whole.into_iter().zip(sums);
        parts.map(|(whole, sums)| Part { sums, whole }).collect()
    }
}
