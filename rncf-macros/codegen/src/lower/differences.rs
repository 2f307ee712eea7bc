//! Whether constraints and forces depend on differences of places alone: then the runtime evaluates them near what they act on, where differences keep
//! their digits far from the origin. It is proved, by their derivative along a shift of all places: a force that is narrow in space
//! is the same at nearly all places, and is none of differences.

use std::collections::HashMap;

use super::markers::{Marked, localise};
use crate::model::{Expr, Marker, MarkerId, Model};

/// Whether expressions of markers stay the same where all places, and all their velocities, are shifted by one vector.
pub fn is_of_differences<'e>(
    model: &Model,
    markers: &[MarkerId],
    components: impl IntoIterator<Item = &'e Expr>,
) -> bool {
    let mut marked = Marked::values_and_rates(model, markers.len());
    let roots: Vec<_> = components
        .into_iter()
        .map(|component| marked.time.expression(&localise(component, markers)))
        .collect();
    let one = marked.time.graph.one();
    let places = || {
        markers
            .iter()
            .enumerate()
            .filter(|(_, marker)| is_place(model, **marker))
    };
    let symbols = marked.symbols.clone();
    symbols.iter().all(|symbols| {
        (0..3).all(|component| {
            let rates: HashMap<_, _> = places().map(|(at, _)| (symbols[3 * at + component], one)).collect();
            roots.iter().all(|&root| marked.time.graph.is_still(root, &rates))
        })
    })
}

fn is_place(model: &Model, marker: MarkerId) -> bool {
    match &model.markers[marker.0] {
        Marker::Point { .. } | Marker::BodyPoint { .. } => true,
        Marker::Matching { marker: other, .. } => is_place(model, *other),
        _ => false,
    }
}
