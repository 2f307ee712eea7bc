//! Nodes where something acts on a body. Within an element a cubic has no step of its moment: a disc, a weld or a moment there
//! converges with the first power of the elements' length, and with nodes as the rest does.

use super::start::Start;
use crate::model::{Body, BodyId, Expr, Fidelity, Line, LoadKind, Location, Marker, MarkerId, Model, Stations, fold};

/// Part of an element by which a place may miss a node for round-off.
const ROUND_OFF: f64 = 1e-9;

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
        let is_within = |place: &Expr| {
            let at = start.value(place) / length * count;
            at.is_finite() && (at - at.round()).abs() > ROUND_OFF * count
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

/// Where something acts on a body between its ends, each place once; those that differ between repetitions are left out.
fn places(model: &Model, body: BodyId) -> Vec<Expr> {
    let fixtures = model.fixtures.iter().map(|fixture| (fixture.body, &fixture.at));
    let loads = model.loads.iter().filter_map(|load| match &load.kind {
        LoadKind::Force { body, at, .. } | LoadKind::Moment { body, at, .. } => Some((*body, at)),
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
    let marked = forces.chain(tied).filter_map(|marker| on_body(model, marker));
    let mut places: Vec<Expr> = Vec::new();
    for (of, at) in fixtures.chain(loads).chain(marked) {
        if let (true, Location::At(place)) = (of == body, at.place())
            && !fold::has_index(place)
            && !places.contains(place)
        {
            places.push((**place).clone());
        }
    }
    places
}

/// The body and the place of a marker on one.
fn on_body(model: &Model, marker: MarkerId) -> Option<(BodyId, &Location)> {
    match &model.markers[marker.0] {
        Marker::BodyPoint { body, at }
        | Marker::BodySlope { body, at }
        | Marker::BodySection { body, at, .. }
        | Marker::InSection { body, at, .. }
        | Marker::SectionTurn { body, at } => Some((*body, at)),
        _ => None,
    }
}
