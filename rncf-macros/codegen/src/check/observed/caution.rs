//! Cautions: sentences that stand with the results where a condition on the parameters holds.

use crate::check::fold;
use crate::check::values::quantity::Typed;
use crate::check::values::scope::Scope;
use crate::check::{Check, say};
use crate::model::{Caution, Expr as Value};
use crate::parse::tree::{self, ItemKind, Keyword, Name};
use crate::suggest;
use crate::units::Dimension;

/// Name of the end time of the run in conditions.
const END_TIME: &str = "t_end";

impl<'a> Check<'a> {
    /// After the outputs, which they name.
    pub(in crate::check) fn cautions(&mut self) {
        for item in self.items(Keyword::Caution) {
            if let ItemKind::Caution(caution) = &item.kind
                && let Some(caution) = self.caution(&item.name.text, caution)
            {
                self.model.cautions.push(caution);
            }
        }
    }

    fn caution(&mut self, name: &str, caution: &'a tree::Caution) -> Option<Caution> {
        let outputs: Option<Vec<usize>> = {
            let found: Vec<Option<usize>> = caution.outputs.iter().map(|name| self.output_named(name)).collect();
            found.into_iter().collect()
        };
        let seconds = Dimension::of([0, 0, 1, 0, 0, 0]);
        self.locals.insert(END_TIME, Typed::new(Value::EndTime, seconds));
        let sides = [&caution.left, &caution.right].map(|side| self.expr(side, Scope::Parameter));
        self.locals.clear();
        let [Some(left), Some(right)] = sides else { return None };
        if left.dimension != right.dimension {
            self.unlike_terms(&caution.left, &left, &caution.right, &right);
            return None;
        }
        let motion = [(&caution.left, &left), (&caution.right, &right)]
            .into_iter()
            .find(|(_, side)| fold::has_motion(&side.value));
        if let Some((at, _)) = motion {
            self.errors.at(at.area, say::CAUTION_WITHOUT_TIME);
            return None;
        }
        Some(Caution {
            name: name.to_string(),
            text: caution.text.trim().to_string(),
            outputs: outputs?,
            condition: (caution.comparison, left.value, right.value),
        })
    }

    /// Index of an output; `None`: reported, or unreadable itself.
    fn output_named(&mut self, name: &Name) -> Option<usize> {
        let found = self.model.outputs.iter().position(|output| output.name == name.text);
        if found.is_none() {
            let known = self.known(&[Keyword::Output]);
            if !known.contains(&name.text.as_str())
                && !self
                    .tree
                    .lost
                    .iter()
                    .any(|lost| lost == name.word() || *lost == name.text)
            {
                self.errors.at(name.span, suggest::unknown("output", &name.text, known));
            }
        }
        found
    }
}
