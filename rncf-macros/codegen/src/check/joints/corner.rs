//! Rigid corners of a body: joints between its straight pieces that nobody writes.

use super::known::Known;
use crate::check::places::place::{Hold, Spot};
use crate::check::{Check, Shape, say};
use crate::joints::KINDS;
use crate::model::Space;
use crate::parse::tree::{Call, Item};

impl<'a> Check<'a> {
    /// A corner between two pieces; what it cannot keep is told at the first corner of the body.
    pub(in crate::check) fn corner(&mut self, item: &'a Item, call: &'a Call, known: &mut Known) -> Option<()> {
        let shape = Shape {
            positional: 2,
            named: &[],
            required: &[],
            usage: "",
        };
        let arguments = self.arguments(call, &shape)?;
        let holds: [Option<Hold>; 2] = [0, 1].map(|end| self.hold_on(arguments.positional[end]));
        let [Some(first), Some(second)] = holds else {
            return None;
        };
        let (Spot::Flexible(a), Spot::Flexible(b)) = (&first.spot, &second.spot) else {
            return None;
        };
        known.body = Some(a.body);
        self.corners.push([a.body.id, b.body.id]);
        let message = match (a.is_line, a.body.space) {
            (true, Some(Space::Spatial)) => Some(say::CORNER_OF_LINE),
            (true, _) if self.has_slope(a.body.id) == Some(false) => Some(say::CORNER_WITHOUT_SLOPE),
            _ => None,
        };
        if let Some(message) = message {
            if item.name.text.ends_with(".corner[1]") {
                self.errors.at(item.name.span, message);
            }
            return None;
        }
        let weld = KINDS.iter().find(|kind| kind.name == "weld");
        self.with_multipliers(item, &call.name, weld, &arguments, [first, second], known)
    }
}
