//! Declarations of which nothing became though nothing was said about them: a mistake of these checks, which no model may fall silent to.

use std::collections::HashSet;

use super::Check;
use super::messages as say;
use crate::parse::tree::{Item, Keyword};

impl<'a> Check<'a> {
    /// Reports them; to be asked where no mistake has been found.
    pub(super) fn dropped(&mut self) {
        let made = self.made();
        let dropped: Vec<&'a Item> = self
            .tree
            .items
            .iter()
            .filter(|item| !self.is_made(item, &made))
            .collect();
        for item in dropped {
            self.errors
                .at(item.name.span, say::dropped(item.keyword.noun(), &item.name.text));
        }
    }

    /// Names of what acts, holds or is told in the model.
    fn made(&self) -> HashSet<&str> {
        let model = &self.model;
        let outputs = model.outputs.iter().map(|output| &output.name);
        let starts = model.starts.iter().map(|start| &start.name);
        let constraints = model.constraints.iter().map(|constraint| &constraint.name);
        let forces = model.forces.iter().map(|force| &force.name);
        let loads = model.loads.iter().map(|load| &load.name);
        let densities = model.densities.iter().map(|density| &density.name);
        let distributed = model.distributed.iter().map(|load| &load.name);
        let fixtures = model.fixtures.iter().map(|fixture| &fixture.name);
        let parts = model
            .frames
            .iter()
            .flat_map(|frame| &frame.free)
            .flat_map(|free| &free.parts);
        let fixtures = fixtures.chain(parts.map(|part| &part.name));
        let acting = forces.chain(loads).chain(densities).chain(distributed).chain(fixtures);
        outputs
            .chain(starts)
            .chain(constraints)
            .chain(acting)
            .map(String::as_str)
            .collect()
    }

    fn is_made(&self, item: &Item, made: &HashSet<&str>) -> bool {
        let name = item.name.text.as_str();
        match item.keyword {
            Keyword::Frame | Keyword::Rigid => self.frames.get(name).is_some_and(Option::is_some),
            Keyword::Body => self.bodies.contains_key(name),
            Keyword::Joint => self
                .joints
                .get(name)
                .is_some_and(|joint| joint.kind.is_some() || joint.built.is_some() || joint.is_share),
            Keyword::Output
            | Keyword::Start
            | Keyword::Constraint
            | Keyword::Spring
            | Keyword::State
            | Keyword::Load
            | Keyword::Fixture => made.contains(name),
            _ => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::Library;
    use crate::errors::Errors;

    #[test]
    fn what_nothing_is_made_of_is_told() {
        let text = "model Drop { rigid ball { mass = 1 kg; } load g = gravity([0, 0, -9.81] m/s^2); output x = ball; }";
        let mut errors = Errors::new();
        let tree = crate::parse::parse(text.parse().unwrap(), &mut errors).unwrap();
        let library = Library::default();
        let mut check = Check::new(&tree, &library, &mut errors);
        check.names();
        check.frames();
        check.dropped();
        let found: Vec<String> = errors.finish().into_iter().map(|mistake| mistake.message).collect();
        assert_eq!(found, [say::dropped("load", "g"), say::dropped("output", "x")]);
    }
}
