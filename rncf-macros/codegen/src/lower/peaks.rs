//! Where an exponential of what moves has a peak: a wall `exp(-(x/width)^2)` or `1/cosh(x/width)^2`. Beside it there is nothing that a step could see,
//! whatever its tolerance: one that begins and ends far from it would jump over it. Steps end at peaks. Of what time decides see `courses.rs`.

use std::collections::HashMap;

use super::branches::told;
use super::markers::Marked;
use crate::model::Function;
use crate::symbolic::{Id, Node};

/// Tells the runtime that numbers are of a peak.
const PEAK: f64 = -2.0;

/// Rates of the exponents that what moves decides: each is positive before a peak and negative behind it. With what tells it from angles and kinks.
pub fn outputs(marked: &mut Marked<'_>, components: &[Id], begin: usize) -> Vec<(String, Id)> {
    let [values, speeds] = [0, 1].map(|derivative| marked.symbols[derivative].clone());
    let graph = &mut marked.time.graph;
    let mut rates: HashMap<Id, Id> = values.iter().copied().zip(speeds.iter().copied()).collect();
    rates.insert(marked.time.t, graph.one());
    let mut found = Vec::new();
    for id in graph.reachable(components) {
        let Node::Call(function @ (Function::Exp | Function::Cosh), argument) = graph.node(id) else {
            continue;
        };
        if graph.depends_on(argument, &speeds) {
            continue;
        }
        let rate = graph.differentiate(argument, &rates);
        let rate = if function == Function::Cosh {
            let slope = graph.call(Function::Tanh, argument);
            let falling = graph.multiply(slope, rate);
            graph.negate(falling)
        } else {
            rate
        };
        // What grows evenly along the way has no peak.
        if graph.depends_on(rate, &values) && !found.contains(&rate) {
            found.push(rate);
        }
    }
    told(graph, PEAK, found, begin)
}
