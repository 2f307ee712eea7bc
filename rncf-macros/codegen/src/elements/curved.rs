//! Axes that are curved, or sections that are twisted, without stress: what the energy counts from there.
//!
//! A strain counts from its value in the stress-free shape. An energy W of inner products I without a strain counts from the inner
//! products I0 there: it is `W(I - I0 + I1)`, with the I1 of a straight axis. At rest its derivatives are those of a straight axis, so
//! that it has no stress where dW/dI vanishes there; where it does not, such as with the square of a curvature in space, a straight axis
//! is without stress for another reason, which a curved one has not.

use std::collections::HashMap;

use super::element::{Density, Element, Field, Interpolant, field_invariants};
use crate::symbolic::{Graph, Id, Invariant};

/// Values of coefficients at which the derivatives of an energy are looked at; what changes with time takes both.
const COEFFICIENTS: [f64; 2] = [1.0, 0.3];

/// Derivative that is round-off.
const ROUND_OFF: f64 = 1e-9;

impl Density {
    /// What counts from its value in the stress-free shape: the measure, or the inner products that an energy without one is of.
    pub fn counted(self, graph: &Graph, products: &[Id]) -> Vec<Id> {
        let Density::Energy(energy) = self else {
            return self.measure().into_iter().collect();
        };
        let reached = graph.reachable(&[energy]);
        products.iter().copied().filter(|one| reached.contains(one)).collect()
    }
}

impl Field {
    /// Whether it is a unit vector in a straight element that nothing deforms; the others vanish there.
    pub fn is_unit(&self) -> bool {
        self.order == usize::from(self.of == Interpolant::Position)
    }
}

/// The value of an inner product of fields in a straight, untwisted element that nothing deforms.
pub fn at_rest(one: Invariant, fields: &[&Field]) -> f64 {
    let (a, b) = (fields[one.i], fields[one.j]);
    if a.is_unit() && b.is_unit() {
        one.orthonormal(a.of == b.of)
    } else {
        0.0
    }
}

impl Element {
    /// The part of the energy that has a stress where an axis is curved, or its sections twisted, without stress.
    pub fn stressed_by_curvature(&self, dimension: usize, options: &[usize]) -> Option<&'static str> {
        let mut graph = Graph::new();
        let (products, symbols) = field_invariants(&mut graph, self, dimension);
        let terms = (self.energy)(&mut graph, &products, options);
        let fields: Vec<&Field> = self.fields_in(dimension).collect();
        let mut is_stressed = |energy: Id| {
            let slopes: Vec<Id> = symbols
                .iter()
                .map(|&(_, symbol)| graph.partial(energy, symbol))
                .collect();
            COEFFICIENTS.into_iter().any(|timed| {
                let rest = symbols.iter().map(|&(one, symbol)| (symbol, at_rest(one, &fields)));
                let mut inputs: HashMap<Id, f64> = rest.collect();
                for one in &self.coefficients {
                    let value = if one.is_timed() { timed } else { COEFFICIENTS[0] };
                    inputs.insert(graph.input(one.name), value);
                }
                let slopes = graph.evaluate(&slopes, &inputs);
                // A slope that is no number is none that vanishes.
                slopes
                    .into_iter()
                    .any(|slope| slope.is_nan() || slope.abs() > ROUND_OFF)
            })
        };
        let mut energies = terms.iter().filter_map(|term| match term.density {
            Density::Energy(energy) => Some((term.name, energy)),
            _ => None,
        });
        energies.find(|&(_, energy)| is_stressed(energy)).map(|(name, _)| name)
    }
}
