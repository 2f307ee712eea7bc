//! Where and how fast a body starts, along its axis.

use crate::check::values::quantity::{Typed, Vector, Wanted};
use crate::check::values::scope::Scope;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::model::{Expr as Value, Initial, Space};
use crate::parse::tree::{Expr, Item, Statement};
use crate::units::Dimension;

/// Name of the arclength in these statements.
const ARCLENGTH: &str = "x";

const POSITION: Wanted = Wanted {
    what: "an initial position",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const VELOCITY: Wanted = Wanted {
    what: "an initial velocity",
    dimension: [1, 0, -1, 0, 0, 0],
    unit: "m/s",
};

impl<'a> Check<'a> {
    /// `initial position [..];` and `initial velocity [..];`; `None`: reported.
    pub(in crate::check) fn initial(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        space: Option<Space>,
    ) -> Option<Initial> {
        let mut found: [Option<(Area, Option<Vector>)>; 2] = [None, None];
        let mut is_whole = true;
        for statement in statements {
            let Statement::Initial { word, area, value } = statement else {
                continue;
            };
            let which = usize::from(word.text == "velocity");
            if let Some((first, _)) = &found[which] {
                let line = first.line().to_string();
                let message = say::duplicate_statement(&format!("`initial {}`", word.text), &line);
                self.errors.at(*area, message);
                is_whole = false;
                continue;
            }
            is_whole &= self.may_start(item, statements, *area);
            let vector = self.along(value, [POSITION, VELOCITY][which], space);
            found[which] = Some((*area, vector));
        }
        let mut take = |which: usize| match found[which].take() {
            Some((_, Some(vector))) => Some(vector.values),
            Some((_, None)) => {
                is_whole = false;
                None
            }
            None => None,
        };
        let initial = Initial {
            position: take(0),
            velocity: take(1),
        };
        is_whole.then_some(initial)
    }

    /// Modes have no initial shape.
    fn may_start(&mut self, item: &Item, statements: &[Statement], area: Area) -> bool {
        let modes = statements.iter().find_map(|statement| match statement {
            Statement::Fidelity { word, .. } => Some(word),
            _ => None,
        });
        if let Some(word) = modes {
            self.errors.at(area, say::initial_of_modes(&word.text, &item.name.text));
        }
        modes.is_none()
    }

    /// A vector that may depend on the arclength.
    fn along(&mut self, value: &'a Expr, wanted: Wanted, space: Option<Space>) -> Option<Vector> {
        let length = Dimension::of([1, 0, 0, 0, 0, 0]);
        self.locals.insert(ARCLENGTH, Typed::new(Value::Arclength, length));
        let vector = self.vector(value, Scope::Parameter, wanted);
        self.locals.clear();
        let vector = vector?;
        if let Some(space) = space {
            self.in_plane(&vector, space, wanted.what);
        }
        for (component, area) in vector.values.iter().zip(vector.areas) {
            if fold::has_motion(component) {
                self.errors.at(area, say::INITIAL_WITHOUT_TIME);
                return None;
            }
        }
        Some(vector)
    }
}
