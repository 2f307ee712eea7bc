//! Ends of bodies that are one node: assembly, no condition.

use super::eliminated::Held;
use super::known::Known;
use crate::check::places::place::Place;
use crate::check::values::repeat::has_index;
use crate::check::{Check, Shape, fold, say};
use crate::errors::Area;
use crate::model::{Body, Expr as Value, Fidelity, RepeatId, Share};
use crate::parse::tree::{Call, Expr, Item};

/// Words for shared nodes, and what is written.
pub const SHARES: &[(&str, &str)] = &[
    ("share", "share(left.end, right.start)"),
    ("merge", "merge(left.end, right.start)"),
];

impl<'a> Check<'a> {
    /// `share(left.end, right.start)` or `merge(..)`; `held` are the ends that joints hold.
    pub(in crate::check) fn share(
        &mut self,
        item: &'a Item,
        call: &'a Call,
        known: &mut Known,
        held: &[Held],
    ) -> Option<()> {
        known.is_share = true;
        let word = call.name.text.as_str();
        let shape = Shape {
            positional: 2,
            named: &[],
            required: &[],
            usage: SHARES.iter().find(|(share, _)| *share == word)?.1,
        };
        let arguments = self.arguments(call, &shape)?;
        let [first, second] = arguments.positional[..] else {
            return None;
        };
        let places = [self.shared_end(first, held), self.shared_end(second, held)];
        let [Some(a), Some(b)] = places else { return None };
        let areas = [first.area, second.area];
        self.may_be_one(item, word, [&a, &b], areas)?;
        self.model.shares.push(Share {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            repeat: item.repeat.map(RepeatId),
            ends: [(a.body.id, a.at), (b.body.id, b.at)],
            smooth: word == "merge",
        });
        Some(())
    }

    /// An end of a body with unknowns of its own, which no joint holds.
    fn shared_end(&mut self, expr: &'a Expr, held: &[Held]) -> Option<Place> {
        let place = self.place(expr)?;
        let body = self.body_of(place.body.id)?;
        let message = if place.at.is_along() {
            say::SHARED_INSIDE.into()
        } else if body.fidelity != Fidelity::Full {
            say::shared_modes(&body.name)
        } else if let Some(line) = held.iter().find_map(|held| held.line_at(place.body.id, &place.at)) {
            say::shared_and_held(&line.to_string())
        } else {
            return Some(place);
        };
        self.errors.at(expr.area, message);
        None
    }

    fn may_be_one(&mut self, item: &Item, word: &str, [a, b]: [&Place; 2], areas: [Area; 2]) -> Option<()> {
        let (first, second) = (self.body_of(a.body.id)?, self.body_of(b.body.id)?);
        let ends = [(a.body.id, &a.at), (b.body.id, &b.at)];
        let is_same = |share: &&Share| {
            let [first, second] = share.ends.each_ref().map(|(body, at)| (*body, at));
            [first, second] == ends || [second, first] == ends
        };
        let message = if ends[0] == ends[1] {
            say::SAME_END.into()
        } else if first.frame != second.frame {
            let [first, second] = [first, second].map(|body| self.model.frames[body.frame.0].name.as_str());
            say::shared_frames(first, second)
        } else if first.space != second.space {
            say::PLANAR_AND_SPATIAL.into()
        } else if word == "merge" && first.element != second.element {
            say::merged_elements(&first.name, &second.name)
        } else if word == "merge" && strains_jump(first, second) {
            say::merged_sections(&first.name, &second.name)
        } else if let Some(other) = self.model.shares.iter().find(is_same) {
            say::shared_twice(&other.name)
        } else if item.repeat.is_some() && !has_index(&a.at) && !has_index(&b.at) {
            say::SAME_ENDS_REPEATED.into()
        } else {
            return Some(());
        };
        self.errors.at(areas[1], message);
        None
    }
}

/// Properties that no strain hangs on: what two bodies of one node may have of their own.
const UNSTRAINED: &[&str] = &[
    "density",
    "damping",
    "yield",
    "extent_y",
    "extent_z",
    "mass",
    "inertia_y",
    "inertia_z",
];

/// Whether two bodies have different stiffnesses where they meet, so that their strains differ there; of what varies along them nothing is known.
fn strains_jump(first: &Body, second: &Body) -> bool {
    let differ = |a: &Value, b: &Value| {
        let varies = [a, b].into_iter().any(fold::has_arclength);
        !varies && (a != b || fold::has_index(a))
    };
    let counts = |name: &str| !UNSTRAINED.contains(&name);
    first.properties.iter().any(|(name, a)| {
        let other = second.properties.get(name);
        counts(name) && other.is_some_and(|b| differ(a, b))
    })
}
