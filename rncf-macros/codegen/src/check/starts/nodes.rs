//! Nodes where something acts on a body. Within an element a cubic has no step of its moment: a disc, a weld or a moment there
//! converges with the first power of the elements' length, and with nodes as the rest does.

use super::start::Start;
use crate::model::{Body, BodyId, Expr, Fidelity, Line, LoadKind, Location, Model, NodeAt, Stations, fold};

/// Part of an element by which a place may miss a node for round-off.
const ROUND_OFF: f64 = 1e-9;
/// Repetitions of a loop that are looked at.
const LOOKED_AT: usize = 100;

/// Lets nodes stand at the places where something acts, of bodies that say nothing else of their nodes. Places that are nodes
/// of equal elements with the defaults of params stay what they are.
pub fn stand_where_something_acts(model: &mut Model) {
    for index in 0..model.bodies.len() {
        let body = &model.bodies[index];
        if !is_free_to_choose(body) {
            continue;
        }
        let places = places(model, BodyId(index));
        let start = Start::new(model);
        let (length, count) = (start.length(BodyId(index)), start.value(&body.count));
        let misses = |place: f64| {
            let at = place / length * count;
            at.is_finite() && (at - at.round()).abs() > ROUND_OFF * count
        };
        let is_within = |of: &NodeAt| {
            let times = match of.over.or(body.repeat).filter(|_| fold::has_index(&of.place)) {
                Some(repeat) => start.value(&model.repeats[repeat.0].count) as usize,
                None => 1,
            };
            let value = |index: usize| fold::of_repetition(model, &of.place, 0.0, index as f64);
            let unit = if of.is_part { length } else { 1.0 };
            (0..times.min(LOOKED_AT))
                .filter_map(value)
                .any(|place| misses(place * unit))
        };
        if places.iter().any(is_within) {
            model.bodies[index].stations = Some(Stations::Places(places));
        }
    }
}

/// Whether its nodes may be anywhere: a mesh of equal elements that deforms.
fn is_free_to_choose(body: &Body) -> bool {
    let deforms = !matches!(body.fidelity, Fidelity::Rigid | Fidelity::Point);
    let is_meshed = !matches!(body.line, Line::Imported(_));
    body.stations.is_none() && body.piece.is_none() && deforms && is_meshed
}

/// Where something acts on a body between its ends, each place once.
fn places(model: &Model, body: BodyId) -> Vec<NodeAt> {
    let own = model.bodies[body.0].repeat;
    let fixtures = model
        .fixtures
        .iter()
        .map(|fixture| (fixture.body, &fixture.at, fixture.repeat));
    let loads = model.loads.iter().filter_map(|load| match &load.kind {
        LoadKind::Force { body, at, .. } | LoadKind::Moment { body, at, .. } => Some((*body, at, None)),
        _ => None,
    });
    let zero = |components: &[Expr; 3]| components.iter().all(|part| *part == Expr::Number(0.0));
    let forces = model.forces.iter().flat_map(|force| {
        let acting = force.markers.iter().zip(&force.components);
        acting
            .filter(move |(_, components)| !zero(components))
            .map(|(marker, _)| *marker)
    });
    let tied = model
        .constraints
        .iter()
        .flat_map(|constraint| constraint.markers.iter().copied());
    let marked = forces.chain(tied).filter_map(|marker| {
        let (body, at) = model.markers[marker.0].on_body()?;
        Some((body, at, None))
    });
    let mut places: Vec<NodeAt> = Vec::new();
    for (of, at, repeat) in fixtures.chain(loads).chain(marked) {
        let (place, is_part) = match at.place() {
            Location::At(place) => (place, false),
            Location::Part(part) => (part, true),
            _ => continue,
        };
        if of != body {
            continue;
        }
        let over = match (fold::has_index(place), own, repeat) {
            (false, ..) => None,
            (true, None, Some(repeat)) => Some(repeat),
            (true, Some(own), Some(repeat)) if own == repeat => None,
            // Those that differ between repetitions for another reason are left out.
            (true, ..) => continue,
        };
        let place = NodeAt {
            place: (**place).clone(),
            is_part,
            over,
        };
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places
}
