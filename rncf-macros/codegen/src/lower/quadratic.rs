//! The constant-tensor form (Eq. 7): an energy density that is quadratic in inner products of the
//! fields becomes `1/2 T_AB I_A I_B` in inner products of nodal vectors, with T exact.

use std::collections::HashMap;

use crate::elements::{Density, Element, Field, Interpolant, NodalVector, Term, field_invariants};
use crate::model::Quadrature;
use crate::symbolic::{Graph, Id};
use crate::symbolic::{Invariant, Product, invariants};
use crate::tensors::{Polynomial, Rational, integrate};

/// A term of the energy in tensor form:
/// `coefficient * length^power * 1/2 T_AB (I_A - I0_A) (I_B - I0_B)`.
#[derive(Clone, Debug)]
pub struct TensorTerm {
    /// Name of the term.
    pub name: &'static str,
    /// Name of the coefficient.
    pub coefficient: &'static str,
    /// Power of the element's length.
    pub power: i32,
    /// T on the invariants of the relative vectors, rounded once from exact fractions.
    pub tensor: Vec<Vec<f64>>,
    /// Whether the reference value is subtracted and damping applies (a measure).
    pub is_measure: bool,
}

/// Shape functions of the relative vectors: the position of the first node is the base, other
/// positions count relative to it and divided by the length, slopes as they are. Strains then
/// depend on differences only, and every power of the length is a common factor.
pub fn relative_shapes(vectors: &[&NodalVector]) -> Vec<(usize, Polynomial)> {
    let base = base_vector(vectors);
    let vectors = vectors.iter().enumerate();
    vectors
        .filter(|&(index, _)| index != base)
        .map(|(index, vector)| (index, vector.shape.clone()))
        .collect()
}

/// The nodal vector that positions are taken relative to.
pub fn base_vector(vectors: &[&NodalVector]) -> usize {
    vectors.iter().position(|vector| is_position(vector)).unwrap_or(0)
}

/// Whether a nodal vector is a position, which counts relative to the base.
pub fn is_position(vector: &NodalVector) -> bool {
    vector.of == Interpolant::Position && vector.order == 0
}

/// Power of the length between a field and the same derivative on the unit element, of relative vectors.
pub fn length_power(field: &Field) -> i32 {
    i32::from(field.of == Interpolant::Position) - field.order as i32
}

/// The terms in tensor form, or `None` where a density is not quadratic in the inner products, or the
/// element has a cross-section (with six and more vectors points are cheaper, THEORY 4.3).
pub fn tensor_terms(
    element: &Element,
    dimension: usize,
    options: &[usize],
    quadrature: Quadrature,
) -> Option<Vec<TensorTerm>> {
    if element.has_section() {
        return None;
    }
    let mut graph = Graph::new();
    let (fields, symbols) = field_invariants(&mut graph, element, dimension);
    let terms = (element.energy)(&mut graph, &fields, options);
    terms
        .iter()
        .map(|term| tensor_term(&mut graph, element, dimension, &symbols, term, quadrature))
        .collect()
}

fn tensor_term(
    graph: &mut Graph,
    element: &Element,
    dimension: usize,
    symbols: &[(Invariant, Id)],
    term: &Term,
    quadrature: Quadrature,
) -> Option<TensorTerm> {
    // weights[I][J] = d2(density)/dI dJ as exact numbers.
    let (weights, is_measure) = match term.density {
        Density::Measure(measure) => {
            let slopes: Option<Vec<Rational>> = symbols
                .iter()
                .map(|&(_, symbol)| constant(graph, measure, symbol))
                .collect();
            let slopes = slopes?;
            (
                slopes
                    .iter()
                    .map(|&a| slopes.iter().map(|&b| a * b).collect())
                    .collect::<Vec<Vec<Rational>>>(),
                true,
            )
        }
        Density::Law { .. } | Density::Undamped(_) | Density::Viscous(_) => return None,
        Density::Energy(energy) => {
            let mut weights = Vec::new();
            for &(_, symbol) in symbols {
                let slope = graph.partial(energy, symbol);
                let row: Option<Vec<Rational>> = symbols
                    .iter()
                    .map(|&(_, other)| constant(graph, slope, other))
                    .collect();
                weights.push(row?);
                if !vanishes_at_zero(graph, slope, symbols) {
                    return None;
                }
            }
            (weights, false)
        }
    };
    let power_of = |invariant: Invariant| element.fields[invariant.i].order + element.fields[invariant.j].order - 2;
    let vectors: Vec<&NodalVector> = element.vectors_in(dimension).collect();
    let shapes = relative_shapes(&vectors);
    let relative = invariants(shapes.len(), dimension);
    let mut densities = vec![vec![Polynomial::zero(); relative.len()]; relative.len()];
    let mut power = None;
    for (row, &(left, _)) in symbols.iter().enumerate() {
        for (column, &(right, _)) in symbols.iter().enumerate() {
            let weight = weights[row][column];
            if weight.is_zero() {
                continue;
            }
            let inverse_power = power_of(left) + power_of(right);
            if *power.get_or_insert(inverse_power) != inverse_power {
                return None;
            }
            for (a, &first) in relative.iter().enumerate() {
                for (b, &second) in relative.iter().enumerate() {
                    let density = part(element, &shapes, left, first).product(&part(element, &shapes, right, second));
                    densities[a][b] = densities[a][b].plus(&density.times(weight));
                }
            }
        }
    }
    let tensor = densities.iter().map(|row| {
        row.iter()
            .map(|density| integrate(density, quadrature).to_f64())
            .collect()
    });
    Some(TensorTerm {
        name: term.name,
        coefficient: term.coefficient,
        power: 1 - power.unwrap_or(0) as i32,
        tensor: tensor.collect(),
        is_measure,
    })
}

/// How much of the relative invariant is in the field invariant, as a polynomial in xi.
fn part(element: &Element, shapes: &[(usize, Polynomial)], field: Invariant, relative: Invariant) -> Polynomial {
    if field.product != relative.product {
        return Polynomial::zero();
    }
    let shape = |field: usize, vector: usize| shapes[vector].1.derivative(element.fields[field].order);
    let (i, j) = (relative.i, relative.j);
    let direct = shape(field.i, i).product(&shape(field.j, j));
    if i == j {
        return direct;
    }
    let swapped = shape(field.i, j).product(&shape(field.j, i));
    match field.product {
        Product::Dot => direct.plus(&swapped),
        Product::Cross => direct.plus(&swapped.times(Rational::whole(-1))),
    }
}

/// d(of)/d(symbol) if it is a number.
fn constant(graph: &mut Graph, of: Id, symbol: Id) -> Option<Rational> {
    let derivative = graph.partial(of, symbol);
    graph.value(derivative).and_then(Rational::from_f64)
}

fn vanishes_at_zero(graph: &mut Graph, of: Id, symbols: &[(Invariant, Id)]) -> bool {
    let zero = graph.zero();
    let zeros: HashMap<Id, Id> = symbols.iter().map(|&(_, symbol)| (symbol, zero)).collect();
    let value = graph.substitute(of, &zeros);
    graph.is_zero(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::Library;

    fn cable() -> Element {
        let library = Library::standard();
        library.elements[library.find("cable").unwrap()].clone()
    }
    use crate::tensors::gauss_rule;

    /// `int h_i h_j h_m h_n dxi` of the relative vectors s0, d, s1, by hand: THEORY 5.1's kappa.
    #[test]
    fn tensors_are_the_closed_forms_to_the_last_bit() {
        let terms = tensor_terms(&cable(), 3, &[0], Quadrature::Exact).unwrap();
        assert_eq!((terms[0].coefficient, terms[0].power), ("EA", 1));
        assert_eq!((terms[1].coefficient, terms[1].power), ("EI", -1));
        let axial = &terms[0].tensor;
        // Invariants: s0.s0, s0.d, s0.s1, d.d, d.s1, s1.s1; the measure is 1/2 (a.a - 1).
        assert_eq!(axial[3][3], 18.0 / 35.0); // 1/4 int (6 xi - 6 xi^2)^4
        assert_eq!(axial[0][0], 1.0 / 70.0); // 1/4 int (1 - 4 xi + 3 xi^2)^4
        assert_eq!(axial[5][5], 1.0 / 70.0);
        assert_eq!(axial[0][5], 1.0 / 840.0);
        let planar = tensor_terms(&cable(), 2, &[0], Quadrature::Exact).unwrap();
        assert!(planar[1].is_measure);
        assert_eq!(planar[1].power, -1);
    }

    /// The exact tensors against a second evaluation by floating-point Gauss sums, full and reduced.
    #[test]
    fn tensors_equal_floating_point_gauss_sums() {
        let shapes = relative_shapes(&cable().vectors_in(3).collect::<Vec<_>>());
        for (dimension, quadrature, points) in [
            (2, Quadrature::Exact, 5),
            (3, Quadrature::Exact, 5),
            (2, Quadrature::Gauss(3), 3),
            (3, Quadrature::Gauss(3), 3),
        ] {
            let rule = gauss_rule(points);
            let relative = invariants(3, dimension);
            for term in tensor_terms(&cable(), dimension, &[0], quadrature).unwrap() {
                for (a, &first) in relative.iter().enumerate() {
                    for (b, &second) in relative.iter().enumerate() {
                        let at = |xi: f64| density(&shapes, &term, first, second, xi);
                        let sum: f64 = rule
                            .points
                            .iter()
                            .zip(&rule.weights)
                            .map(|(&xi, &weight)| weight * at(xi))
                            .sum();
                        let error = (sum - term.tensor[a][b]).abs();
                        assert!(
                            error < 1e-14 * 144.0,
                            "{} {a} {b}: {sum} {}",
                            term.name,
                            term.tensor[a][b]
                        );
                    }
                }
            }
        }
    }

    /// `d2(density)/dI dJ` at a point, written by hand for the two terms of the cable.
    fn density(shapes: &[(usize, Polynomial)], term: &TensorTerm, first: Invariant, second: Invariant, xi: f64) -> f64 {
        let derivative = |vector: usize, order: usize| shapes[vector].1.derivative(order).at(xi);
        let product = |invariant: Invariant, m: usize, n: usize, sign: f64| {
            let (i, j) = (invariant.i, invariant.j);
            let direct = derivative(i, m) * derivative(j, n);
            if i == j {
                direct
            } else {
                direct + sign * derivative(j, m) * derivative(i, n)
            }
        };
        let dot = |invariant: Invariant, m: usize, n: usize| {
            if invariant.product == Product::Dot {
                product(invariant, m, n, 1.0)
            } else {
                0.0
            }
        };
        let cross = |invariant: Invariant| {
            if invariant.product == Product::Cross {
                product(invariant, 1, 2, -1.0)
            } else {
                0.0
            }
        };
        match (term.coefficient, term.is_measure) {
            ("EA", _) => 0.25 * dot(first, 1, 1) * dot(second, 1, 1),
            (_, true) => cross(first) * cross(second),
            (_, false) => {
                0.5 * (dot(first, 1, 1) * dot(second, 2, 2) + dot(first, 2, 2) * dot(second, 1, 1))
                    - dot(first, 1, 2) * dot(second, 1, 2)
            }
        }
    }

    #[test]
    fn other_exponents_have_no_tensor() {
        assert!(tensor_terms(&cable(), 3, &[1], Quadrature::Exact).is_none());
        assert!(tensor_terms(&cable(), 2, &[1], Quadrature::Exact).is_none());
    }
}
