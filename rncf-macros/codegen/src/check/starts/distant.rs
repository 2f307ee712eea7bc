//! Joints at a place which was not meant: no mistake, but a warning at the joint. Of two frames or rigid bodies without a
//! point the origin of the first is the place of the joint; where that of the second is elsewhere, either may have been meant. A rigid body that does not
//! say where it starts is at the origin of its parent, and a joint elsewhere makes a lever of the way, whether that was meant or forgotten.

use super::start::Start;
use crate::check::messages as say;
use crate::check::values::arithmetic::{norm, subtract};
use crate::errors::{Area, Mistake};
use crate::model::{FrameId, INERTIAL, Marker, MarkerId, Model};
use crate::parse::tree::{Expr, ExprKind, Item, ItemKind, Keyword, Tree};

/// What the compiler says to be deprecated where such a warning stands.
const WARNING: &str = "distant_axis";
/// The same of a body that does not say where it starts.
const FORGOTTEN: &str = "forgotten_origin";
/// Joints that have a place about which the parties turn.
const TURNING: [&str; 4] = ["revolute", "spherical", "pin", "universal"];
/// Joints that hold the other party at their place, too.
const HOLDING: [&str; 6] = ["revolute", "spherical", "pin", "universal", "cylindrical", "weld"];
/// Part of the coordinates by which origins differ for round-off.
const ROUND_OFF: f64 = 1e-9;

/// Warnings about a model without mistakes. A leading underscore of the joint's name silences them.
pub fn distant_axes(tree: &Tree, model: &Model) -> Vec<Mistake> {
    let joints = tree.items.iter().filter(|item| item.keyword == Keyword::Joint);
    let joints = joints.filter(|item| !item.name.word().starts_with('_'));
    joints
        .filter_map(|item| {
            let ItemKind::Joint(call) = &item.kind else { return None };
            let [first, second, ..] = call.arguments.as_slice() else {
                return None;
            };
            let parties = [&first.value, &second.value].map(|expr| named(model, expr));
            match parties {
                [Some(first), Some(second)] if TURNING.contains(&call.name.text.as_str()) => {
                    distant(item, model, [first, second])
                }
                [Some(party), None] | [None, Some(party)] if HOLDING.contains(&call.name.text.as_str()) => {
                    forgotten(item, tree, model, party)
                }
                _ => None,
            }
        })
        .collect()
}

fn distant(item: &Item, model: &Model, [first, second]: [(&str, FrameId); 2]) -> Option<Mistake> {
    let [at, other] = [first.1, second.1].map(|frame| Start::new(model).pose(frame).origin);
    let way = norm(subtract(other, at));
    let is_far = way > ROUND_OFF * norm(at).max(norm(other));
    is_far.then(|| {
        let message = say::distant_axis(first.0, second.0, &rounded(way));
        Mistake::new(Area::from(item.name.span), message).called(WARNING)
    })
}

/// A joint at a place that is not the origin of a rigid body which says nothing of where that is.
fn forgotten(item: &Item, tree: &Tree, model: &Model, (name, frame): (&str, FrameId)) -> Option<Mistake> {
    let is_silent = tree.items.iter().any(|item| match &item.kind {
        ItemKind::Rigid { fields, .. } if item.name.text == name => {
            fields.fields.iter().all(|field| field.name.text != "origin")
        }
        _ => false,
    });
    let constraint = model.constraints.iter().find(|other| other.name == item.name.text);
    let start = Start::new(model);
    let is_own = |marker: &&MarkerId| match &model.markers[marker.0] {
        Marker::Point { frame: of, .. } | Marker::Matching { frame: of, .. } => {
            *of == frame && model.is_point(**marker)
        }
        _ => false,
    };
    let place = start.marker(*constraint?.markers.iter().find(is_own)?);
    let way = norm(subtract(place, start.pose(frame).origin));
    (is_silent && way > ROUND_OFF * norm(place)).then(|| {
        let message = say::forgotten_origin(name, &rounded(way));
        Mistake::new(Area::from(item.name.span), message).called(FORGOTTEN)
    })
}

/// A length as it is told.
fn rounded(way: f64) -> String {
    format!("{way:.3e}").parse().unwrap_or(way).to_string()
}

/// A frame or rigid body that stands alone.
fn named<'a>(model: &Model, expr: &'a Expr) -> Option<(&'a str, FrameId)> {
    let ExprKind::Name(name) = &expr.kind else { return None };
    let text = name.text.as_str();
    if text == "inertial" {
        return Some((text, INERTIAL));
    }
    let frame = model.frames.iter().position(|frame| frame.name == text)?;
    Some((text, FrameId(frame)))
}
