//! The two elements behind the word `beam` where the section says its stiffness by itself, of one declaration.

use std::sync::Arc;

use super::element::{Element, Invariants, VISCOUS};
use crate::symbolic::Graph;

/// Those of the declaration `full`, by the value of its option: without and with a damping of its own for each strain, where the stress of
/// the rates is `sqrt(c_i c_j) K_ij e_j'`. `beam` says how they are called.
pub fn full_beam(full: &Element, beam: &Element) -> [Element; 2] {
    [(full.kernel, 0), (VISCOUS, 1)].map(|(kernel, choice)| {
        let energy = Arc::clone(&full.energy);
        let coefficients = full.coefficients_in(3, &[choice]).into_iter().cloned();
        Element {
            names: beam.names.clone(),
            kernel,
            coefficients: coefficients.collect(),
            options: Vec::new(),
            energy: Arc::new(move |graph: &mut Graph, fields: &Invariants, _: &[usize]| {
                energy(graph, fields, &[choice])
            }),
            ..full.clone()
        }
    })
}
