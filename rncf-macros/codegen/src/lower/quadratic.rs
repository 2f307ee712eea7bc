//! The constant-tensor form (Eq. 7): an energy density that is quadratic in inner products of the
//! fields becomes `1/2 T_AB I_A I_B` in inner products of nodal vectors, with T exact.

use std::collections::HashMap;

use super::invariants::{Invariant, Product, invariants};
use crate::elements::{Density, Element, Invariants, Term};
use crate::model::Quadrature;
use crate::symbolic::{Graph, Id};
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
pub fn relative_shapes(element: &Element) -> Vec<(usize, Polynomial)> {
    let base = base_vector(element);
    let vectors = element.vectors.iter().enumerate();
    vectors
        .filter(|&(index, _)| index != base)
        .map(|(index, vector)| (index, (vector.shape)()))
        .collect()
}

/// The nodal vector that positions are taken relative to.
pub fn base_vector(element: &Element) -> usize {
    element.vectors.iter().position(|vector| vector.order == 0).unwrap_or(0)
}

/// Symbols for the invariants of the fields, as the energy's declaration takes them.
pub fn field_invariants(graph: &mut Graph, element: &Element, dimension: usize) -> (Invariants, Vec<(Invariant, Id)>) {
    let count = element.fields.len();
    let zero = graph.zero();
    let mut fields = Invariants {
        dimension,
        dots: vec![vec![zero; count]; count],
        crosses: vec![vec![zero; count]; count],
    };
    let mut symbols = Vec::new();
    let names: Vec<String> = element.fields.iter().map(|field| field.name.to_string()).collect();
    for invariant in invariants(count, dimension) {
        let symbol = graph.symbol(invariant.name(&names));
        let (i, j) = (invariant.i, invariant.j);
        match invariant.product {
            Product::Dot => (fields.dots[i][j], fields.dots[j][i]) = (symbol, symbol),
            Product::Cross => (fields.crosses[i][j], fields.crosses[j][i]) = (symbol, graph.negate(symbol)),
        }
        symbols.push((invariant, symbol));
    }
    (fields, symbols)
}

/// The terms in tensor form, or `None` where a density is not quadratic in the inner products.
pub fn tensor_terms(
    element: &Element,
    dimension: usize,
    options: &[usize],
    quadrature: Quadrature,
) -> Option<Vec<TensorTerm>> {
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
    let shapes = relative_shapes(element);
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
    use crate::elements::CABLE;

    /// The printed matrices of the paper's Appendix B follow from the tensors, to the last bit.
    #[test]
    fn axial_tensor_is_the_closed_form() {
        let terms = tensor_terms(&CABLE, 3, &[0], Quadrature::Exact).unwrap();
        assert_eq!((terms[0].coefficient, terms[0].power), ("EA", 1));
        assert_eq!((terms[1].coefficient, terms[1].power), ("EI", -1));
        // D comes second of the relative vectors: D.D is the fourth invariant.
        assert_eq!((invariants(3, 3)[3].i, invariants(3, 3)[3].j), (1, 1));
        // int 1/4 h_D^4 = 1/4 * 6^4 int xi^4 (1 - xi)^4 = 1296/2520
        assert_eq!(terms[0].tensor[3][3], (1296.0 / 4.0) / 630.0);
        assert!(tensor_terms(&CABLE, 3, &[1], Quadrature::Exact).is_none());
        assert!(tensor_terms(&CABLE, 2, &[1], Quadrature::Exact).is_none());
        let planar = tensor_terms(&CABLE, 2, &[0], Quadrature::Exact).unwrap();
        assert!(planar[1].is_measure);
    }
}
