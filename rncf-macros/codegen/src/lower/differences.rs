//! Which constraints and forces depend on differences of places alone: the runtime evaluates these near what they act on, where differences keep
//! their digits far from the origin. It is proved, by their derivative along a shift of all places: a force that is narrow in space
//! is the same at nearly all places, and is none of differences.

use std::collections::HashMap;

use super::markers::Marked;
use crate::model::{Expr, MarkerId, Model};

/// Those of some members, with their markers, whose common law stays the same where all places, and all their velocities, are shifted by one vector;
/// `law` counts the markers of a member.
pub fn of_differences<'m>(
    model: &Model,
    law: &[Expr],
    members: &[usize],
    markers: impl Fn(usize) -> &'m [MarkerId],
) -> Vec<usize> {
    let mut known: HashMap<Vec<bool>, bool> = HashMap::new();
    let mut is_one = |&member: &usize| {
        let places: Vec<bool> = markers(member).iter().map(|&marker| model.is_point(marker)).collect();
        *known
            .entry(places)
            .or_insert_with_key(|places| is_of_differences(model, law, places))
    };
    members.iter().copied().filter(|member| is_one(member)).collect()
}

/// Whether a law is of differences where these of its markers are places.
fn is_of_differences(model: &Model, law: &[Expr], places: &[bool]) -> bool {
    let mut marked = Marked::values_and_rates(model, places.len());
    let roots: Vec<_> = law.iter().map(|component| marked.time.expression(component)).collect();
    let (one, symbols) = (marked.time.graph.one(), marked.symbols.clone());
    symbols.iter().all(|symbols| {
        (0..3).all(|component| {
            let shifted = (0..places.len()).filter(|&at| places[at]);
            let rates: HashMap<_, _> = shifted.map(|at| (symbols[3 * at + component], one)).collect();
            roots.iter().all(|&root| marked.time.graph.is_still(root, &rates))
        })
    })
}
