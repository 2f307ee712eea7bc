//! Axes that go through a place which was not meant: no mistake, but a warning at the joint. Of two frames or rigid bodies without a
//! point the origin of the first is the place of the joint; where that of the second is elsewhere, either may have been meant.

use super::start::Start;
use crate::check::messages as say;
use crate::check::values::arithmetic::{norm, subtract};
use crate::errors::{Area, Mistake};
use crate::model::{FrameId, INERTIAL, Model};
use crate::parse::tree::{Expr, ExprKind, Item, ItemKind, Keyword, Tree};

/// What the compiler says to be deprecated where such a warning stands.
const WARNING: &str = "distant_axis";
/// Joints that have a place about which the parties turn.
const TURNING: [&str; 4] = ["revolute", "spherical", "pin", "universal"];
/// Part of the coordinates by which origins differ for round-off.
const ROUND_OFF: f64 = 1e-9;

/// Warnings about a model without mistakes. A leading underscore of the joint's name silences them.
pub fn distant_axes(tree: &Tree, model: &Model) -> Vec<Mistake> {
    let joints = tree.items.iter().filter(|item| item.keyword == Keyword::Joint);
    joints.filter_map(|item| distant(item, model)).collect()
}

fn distant(item: &Item, model: &Model) -> Option<Mistake> {
    let ItemKind::Joint(call) = &item.kind else { return None };
    if item.name.word().starts_with('_') || !TURNING.contains(&call.name.text.as_str()) {
        return None;
    }
    let [first, second, ..] = call.arguments.as_slice() else {
        return None;
    };
    let [first, second] = [named(model, &first.value)?, named(model, &second.value)?];
    let [at, other] = [first.1, second.1].map(|frame| Start::new(model).pose(frame).origin);
    let way = norm(subtract(other, at));
    let is_far = way > ROUND_OFF * norm(at).max(norm(other));
    is_far.then(|| {
        let way: f64 = format!("{way:.3e}").parse().unwrap_or(way);
        let message = say::distant_axis(first.0, second.0, &way.to_string());
        Mistake::new(Area::from(item.name.span), message).called(WARNING)
    })
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
