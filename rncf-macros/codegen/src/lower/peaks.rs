//! Where an exponential has a peak: a blow `exp(-((t - t0)/width)^2)`, a wall `1/cosh(x/width)^2`, a ramp `tanh((t - t0)/width)`. Beside it there is
//! nothing that a step could see, whatever its tolerance: one that begins and ends far from it would jump over it. Steps end at peaks.

use std::collections::HashMap;

use super::markers::Marked;
use crate::model::Function;
use crate::symbolic::{Id, Node, Time};

/// `tanh(z)` bends most where z^2 is this: there the acceleration of what moves so is greatest.
const BEND: f64 = 0.433;
/// Tells the runtime that numbers are of a peak.
const PEAK: f64 = -2.0;

/// What is zero at the peaks, below `roots`, of what time alone decides.
pub fn of_time(time: &mut Time<'_>, roots: &[Id], of_state: &[Id]) -> Vec<Id> {
    let t = time.t;
    let mut gaps = Vec::new();
    for id in time.graph.reachable(roots) {
        let Node::Call(function, argument) = time.graph.node(id) else {
            continue;
        };
        if time.graph.depends_on(argument, of_state) {
            continue;
        }
        let graph = &mut time.graph;
        let gap = match function {
            Function::Exp => graph.partial(argument, t),
            Function::Cosh => argument,
            Function::Tanh => {
                let square = graph.multiply(argument, argument);
                let bend = graph.number(BEND);
                graph.subtract(square, bend)
            }
            _ => continue,
        };
        if graph.depends_on(gap, &[t]) {
            gaps.push(gap);
        }
    }
    gaps
}

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
    let numbers = [0.0, PEAK, 0.0].map(|number| graph.number(number));
    let each = found.into_iter().flat_map(|rate| [&[rate][..], &numbers].concat());
    each.enumerate()
        .map(|(place, id)| (format!("out[{}]", begin + place), id))
        .collect()
}
