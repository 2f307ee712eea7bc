//! States: integrals over time that loads, laws and other states read, such as those of controllers, filters and lags.
//!
//! A state z has the equation `z' = g`. In the model it is a frame with one unknown that moves nothing, and `g - z'` is the
//! force on it.

use crate::check::values::quantity::Typed;
use crate::check::values::scope::Scope;
use crate::check::{Check, Shape, fold, inertial, say};
use crate::joints::algebra::{number, observed, subtract};
use crate::model::{Frame, FrameId, Free, Marker, MarkerId, Motions, Rotation};
use crate::parse::tree::{Call, Expr, Item, ItemKind, Keyword, Name};
use crate::suggest;
use crate::units::Dimension;

const INTEGRAL: Shape = Shape {
    positional: 1,
    named: &["start", "size"],
    required: &["start"],
    usage: "integral(wanted - hinge.angle, start = 0 [rad*s])",
};
/// Along what the number of a state stands in place of an angle.
const AXIS: [f64; 3] = [1.0, 0.0, 0.0];

impl<'a> Check<'a> {
    /// What states are, by their starts: rates may read any of them.
    pub(in crate::check) fn states(&mut self) {
        for item in self.items(Keyword::State) {
            if let ItemKind::State(call) = &item.kind {
                let known = self.state(item, call);
                self.states.insert(item.name.text.as_str(), known);
            }
        }
    }

    fn state(&mut self, item: &Item, call: &'a Call) -> Option<(MarkerId, Typed)> {
        if call.name.text != "integral" {
            let message = suggest::unknown("kind of state", &call.name.text, ["integral"]);
            self.errors.at(call.name.span, message);
            return None;
        }
        let arguments = self.arguments(call, &INTEGRAL)?;
        let start = self.expr(arguments.named["start"], Scope::Parameter);
        let size = arguments.named.get("size").copied();
        let given = size.map(|size| self.expr(size, Scope::Parameter));
        let start = start?;
        self.is_finite(&start.value, arguments.named["start"].area)?;
        let size = match (size, given) {
            (Some(expr), Some(given)) => self.size_of_state(expr, given?, &start)?,
            _ => number(1.0),
        };
        let zeros = || [0.0; 3].map(number);
        let frame = FrameId(self.model.frames.len());
        self.model.frames.push(Frame {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            rotation: Some(Rotation {
                axis: AXIS,
                angle: start.value.clone(),
            }),
            free: Some(Free {
                motions: Motions::State,
                velocity: zeros(),
                spin: zeros(),
                parts: Vec::new(),
                is_body: false,
                size: Some(size),
            }),
            ..inertial()
        });
        let marker = self.marker(Marker::Angle { frame });
        let [value, ..] = observed(marker, 0, None);
        Some((marker, Typed { value, ..start }))
    }

    fn size_of_state(&mut self, expr: &Expr, size: Typed, start: &Typed) -> Option<crate::model::Expr> {
        if size.dimension != start.dimension {
            let message = say::wrong_dimension("the size of a state", &start.describe(), &size.describe());
            self.errors.at(expr.area, message);
            return None;
        }
        if fold::constant(&size.value).is_some_and(|value| value <= 0.0) {
            self.errors.at(expr.area, say::STATE_SIZE);
            return None;
        }
        Some(size.value)
    }

    /// The equations of states, behind springs, whose forces they may read.
    pub(in crate::check) fn rates_of_states(&mut self) {
        for item in self.items(Keyword::State) {
            if let ItemKind::State(call) = &item.kind
                && let Some(Some((marker, state))) = self.states.get(item.name.text.as_str()).cloned()
                && let Some(rate) = call.arguments.iter().find(|argument| argument.name.is_none())
            {
                self.rate_of_state(item, &rate.value, marker, &state);
            }
        }
    }

    fn rate_of_state(&mut self, item: &Item, expr: &'a Expr, marker: MarkerId, state: &Typed) -> Option<()> {
        let rate = self.with_lookups(|check| check.expr(expr, Scope::Force))?;
        let second = Dimension::of([0, 0, 1, 0, 0, 0]);
        let wanted = state.dimension.divide(second)?;
        if wanted != rate.dimension {
            let wanted = wanted.describe(state.nature.angle);
            let message = say::rate_of_state(&state.describe(), &wanted, &rate.describe());
            self.errors.at(expr.area, message);
            return None;
        }
        self.is_finite(&rate.value, expr.area)?;
        let [derivative, ..] = observed(marker, 1, None);
        let force = [subtract(rate.value, derivative), number(0.0), number(0.0)];
        self.push_force(item, vec![(marker, force)], None);
        Some(())
    }

    /// The value of a state where it is known.
    pub(in crate::check) fn state_value(&mut self, name: &Name, scope: Scope) -> Option<Typed> {
        if scope < Scope::Force {
            self.errors.at(name.span, say::STATE_OUTSIDE);
            return None;
        }
        let (_, state) = self.states.get(name.text.as_str()).cloned().flatten()?;
        Some(state)
    }
}
