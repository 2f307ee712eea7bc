//! Which motions of one element its energy resists, with a given quadrature: the rank of the tangent of a straight element
//! of unit length, free of stress or stretched.

use std::collections::HashMap;

use super::element::{Density, Element, Interpolant, NodalVector, Term, field_invariants};
use crate::symbolic::{Graph, Id, Invariant, Product};
use crate::tensors::{Rule, Sampling};

/// Points of a rule that integrates any energy of these elements well enough to leave no motion out.
const RICH: usize = 12;

/// Stretches at which the rank is looked at: without stress, and tight, where strings resist motion across.
pub const STRETCHES: [f64; 2] = [1.0, 1.125];

/// Pivots below this part of the largest entry are round-off.
const ROUND_OFF: f64 = 1e-9;

/// Values of coefficients, by their names; those that are not there are one.
pub type Coefficients = HashMap<&'static str, f64>;

/// How the terms of an energy are integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rules {
    /// As declared, with this number of points for terms without their own.
    Declared(usize),
    /// With many points.
    Rich,
}

/// Derivatives of one term with respect to the invariants, as expressions.
struct Slopes {
    first: Vec<Id>,
    second: Vec<Vec<Id>>,
}

impl Element {
    /// Derivatives of the energy of a straight element of unit length with respect to the components of its vectors.
    pub fn tangent(
        &self,
        dimension: usize,
        options: &[usize],
        stretch: f64,
        rules: Rules,
        coefficients: &Coefficients,
    ) -> Vec<Vec<f64>> {
        let mut graph = Graph::new();
        let (fields, symbols) = field_invariants(&mut graph, self, dimension);
        let terms = (self.energy)(&mut graph, &fields, options);
        let mut inputs: HashMap<Id, f64> = HashMap::new();
        for one in &self.coefficients {
            let value = coefficients.get(one.name).copied().unwrap_or(1.0);
            inputs.insert(graph.input(one.name), value);
        }
        let vectors: Vec<&NodalVector> = self.vectors_in(dimension).collect();
        let size = vectors.len() * dimension;
        let mut tangent = vec![vec![0.0; size]; size];
        for term in &terms {
            let Some(expressions) = slopes(&mut graph, term, &symbols) else {
                continue;
            };
            let points = match (rules, term.points) {
                (_, Some(nodes @ Sampling::Nodes(_))) => nodes,
                (Rules::Declared(_), Some(points)) => points,
                (Rules::Declared(points), None) => Sampling::Gauss(points),
                (Rules::Rich, _) => Sampling::Gauss(RICH),
            };
            let factor = coefficients.get(term.coefficient).copied().unwrap_or(1.0);
            let Rule { points, weights } = points.rule();
            for (xi, weight) in points.into_iter().zip(weights) {
                let point = Point::new(self, dimension, &vectors, xi, stretch);
                point.add(
                    &graph,
                    &symbols,
                    term,
                    &expressions,
                    &inputs,
                    weight * factor,
                    &mut tangent,
                );
            }
        }
        tangent
    }

    /// Number of independent motions that the energy resists.
    pub fn rank(
        &self,
        dimension: usize,
        options: &[usize],
        stretch: f64,
        rules: Rules,
        coefficients: &Coefficients,
    ) -> usize {
        rank(self.tangent(dimension, options, stretch, rules, coefficients))
    }

    /// Least number of Gauss points that leaves no motion without resistance that the energy itself resists.
    pub fn least_points(&self, dimension: usize, options: &[usize]) -> usize {
        let none = Coefficients::new();
        let rank = |stretch: f64, rules: Rules| self.rank(dimension, options, stretch, rules, &none);
        let rich = STRETCHES.map(|stretch| rank(stretch, Rules::Rich));
        let is_enough = |points: &usize| {
            let mut both = STRETCHES.into_iter().zip(rich);
            both.all(|(stretch, rich)| rank(stretch, Rules::Declared(*points)) >= rich)
        };
        (1..RICH).find(is_enough).unwrap_or(RICH)
    }
}

/// The measure, what is differentiated with respect to it, and its change: `S(e)` of a term.
fn slopes(graph: &mut Graph, term: &Term, symbols: &[(Invariant, Id)]) -> Option<Slopes> {
    let of = match term.density {
        Density::Viscous(_) => return None,
        Density::Energy(energy) => energy,
        Density::Measure(measure) | Density::Undamped(measure) | Density::Law { measure, .. } => measure,
    };
    let first: Vec<Id> = symbols.iter().map(|&(_, symbol)| graph.partial(of, symbol)).collect();
    let second = first
        .iter()
        .map(|&slope| {
            symbols
                .iter()
                .map(|&(_, symbol)| graph.partial(slope, symbol))
                .collect()
        })
        .collect();
    Some(Slopes { first, second })
}

/// A point of a straight element.
struct Point {
    dimension: usize,
    /// Fields, and the weights of the nodal vectors in them.
    fields: Vec<Vec<f64>>,
    weights: Vec<Vec<f64>>,
    /// Fields without stretch.
    unstretched: Vec<Vec<f64>>,
}

impl Point {
    fn new(element: &Element, dimension: usize, vectors: &[&NodalVector], xi: f64, stretch: f64) -> Self {
        let direction = |of: Interpolant, stretch: f64| -> Vec<f64> {
            let (axis, size) = match of {
                Interpolant::Position => (0, stretch),
                Interpolant::SectionY => (1, 1.0),
                Interpolant::SectionZ => (2, 1.0),
            };
            (0..dimension).map(|c| if c == axis { size } else { 0.0 }).collect()
        };
        let fields = |stretch: f64| {
            let value = |field: &super::element::Field| {
                let is_unit = field.order == usize::from(field.of == Interpolant::Position);
                direction(field.of, if is_unit { stretch } else { 0.0 })
                    .into_iter()
                    .map(|value| if is_unit { value } else { 0.0 })
                    .collect()
            };
            element.fields_in(dimension).map(value).collect()
        };
        let weights = element.fields_in(dimension).map(|field| {
            let weight = |vector: &&NodalVector| {
                if vector.of == field.of {
                    vector.shape.derivative(field.order).at(xi)
                } else {
                    0.0
                }
            };
            vectors.iter().map(weight).collect()
        });
        Self {
            dimension,
            weights: weights.collect(),
            fields: fields(stretch),
            unstretched: fields(1.0),
        }
    }

    /// Adds what a term has here.
    #[allow(clippy::too_many_arguments)]
    fn add(
        &self,
        graph: &Graph,
        symbols: &[(Invariant, Id)],
        term: &Term,
        slopes: &Slopes,
        inputs: &HashMap<Id, f64>,
        factor: f64,
        tangent: &mut [Vec<f64>],
    ) {
        let at = |fields: &[Vec<f64>]| {
            let mut values = inputs.clone();
            values.extend(symbols.iter().map(|&(one, symbol)| (symbol, invariant(one, fields))));
            values
        };
        let (now, before) = (at(&self.fields), at(&self.unstretched));
        let (stress, stiffness) = response(graph, term, &now, &before);
        let first = graph.evaluate(&slopes.first, &now);
        let dimension = self.dimension;
        let vectors = self.weights.first().map_or(0, Vec::len);
        let mut gradients: Vec<Vec<f64>> = Vec::new();
        for (one, _) in symbols {
            gradients.push(self.gradient(*one, vectors));
        }
        let size = vectors * dimension;
        let second: Vec<Vec<f64>> = slopes.second.iter().map(|row| graph.evaluate(row, &now)).collect();
        for (a, &slope) in first.iter().enumerate() {
            for (b, &other) in first.iter().enumerate() {
                let entry = factor * (stiffness * slope * other + stress * second[a][b]);
                if entry != 0.0 {
                    for row in 0..size {
                        for column in 0..size {
                            tangent[row][column] += entry * gradients[a][row] * gradients[b][column];
                        }
                    }
                }
            }
            let force = factor * stress * slope;
            if force != 0.0 {
                self.add_second(symbols[a].0, force, vectors, tangent);
            }
        }
    }

    /// Gradient of an invariant with respect to the components of the nodal vectors.
    fn gradient(&self, one: Invariant, vectors: usize) -> Vec<f64> {
        let dimension = self.dimension;
        let mut gradient = vec![0.0; vectors * dimension];
        for (field, other, sign) in [(one.i, one.j, 1.0), (one.j, one.i, -1.0)] {
            let other = &self.fields[other];
            let slope: Vec<f64> = match one.product {
                Product::Dot => other.clone(),
                Product::Cross => vec![sign * other[1], -sign * other[0]],
            };
            for vector in 0..vectors {
                for (c, value) in slope.iter().enumerate() {
                    gradient[vector * dimension + c] += self.weights[field][vector] * value;
                }
            }
        }
        gradient
    }

    /// Adds the second derivatives of an invariant, times a factor.
    fn add_second(&self, one: Invariant, factor: f64, vectors: usize, tangent: &mut [Vec<f64>]) {
        let dimension = self.dimension;
        for v in 0..vectors {
            for w in 0..vectors {
                let weight = |i: usize, j: usize| self.weights[i][v] * self.weights[j][w];
                let (straight, swapped) = (weight(one.i, one.j), weight(one.j, one.i));
                match one.product {
                    Product::Dot => {
                        for c in 0..dimension {
                            tangent[v * dimension + c][w * dimension + c] += factor * (straight + swapped);
                        }
                    }
                    Product::Cross => {
                        let both = factor * (straight - swapped);
                        tangent[v * dimension][w * dimension + 1] += both;
                        tangent[v * dimension + 1][w * dimension] -= both;
                    }
                }
            }
        }
    }
}

fn invariant(one: Invariant, fields: &[Vec<f64>]) -> f64 {
    let (a, b) = (&fields[one.i], &fields[one.j]);
    match one.product {
        Product::Dot => a.iter().zip(b).map(|(a, b)| a * b).sum(),
        Product::Cross => a[0] * b[1] - a[1] * b[0],
    }
}

/// Stress of a term and its derivative, both with respect to its measure; of an energy one and zero.
fn response(graph: &Graph, term: &Term, now: &HashMap<Id, f64>, before: &HashMap<Id, f64>) -> (f64, f64) {
    let Some(measure) = term.density.measure() else {
        return (1.0, 0.0);
    };
    let value = |of: Id, inputs: &HashMap<Id, f64>| graph.evaluate(&[of], inputs)[0];
    let change = value(measure, now) - value(measure, before);
    let Density::Law {
        change: symbol, stress, ..
    } = term.density
    else {
        return (change, 1.0);
    };
    let mut graph = graph.clone();
    let stiffness = graph.partial(stress, symbol);
    let mut inputs = now.clone();
    inputs.insert(symbol, change);
    let values = graph.evaluate(&[stress, stiffness], &inputs);
    (values[0], values[1])
}

/// Rank by elimination with complete pivots.
fn rank(mut matrix: Vec<Vec<f64>>) -> usize {
    let size = matrix.len();
    let largest = matrix
        .iter()
        .flatten()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    for step in 0..size {
        let mut pivot = (step, step);
        for row in step..size {
            for column in step..size {
                if matrix[row][column].abs() > matrix[pivot.0][pivot.1].abs() {
                    pivot = (row, column);
                }
            }
        }
        if matrix[pivot.0][pivot.1].abs() <= ROUND_OFF * largest {
            return step;
        }
        matrix.swap(step, pivot.0);
        for row in &mut matrix {
            row.swap(step, pivot.1);
        }
        let (upper, lower) = matrix.split_at_mut(step + 1);
        let top = &upper[step];
        for row in lower {
            let factor = row[step] / top[step];
            for (value, above) in row.iter_mut().zip(top).skip(step) {
                *value -= factor * above;
            }
        }
    }
    size
}

/// Points that integrate a quartic energy of the axis exactly, where it is straight: what its fourth powers need.
pub fn points_for<'v>(vectors: impl Iterator<Item = &'v NodalVector>) -> usize {
    let degrees = vectors.map(|vector| {
        let order = usize::from(vector.of == Interpolant::Position);
        vector.shape.derivative(order).degree()
    });
    (4 * degrees.max().unwrap_or(0)) / 2 + 1
}
