//! Weight that acts twice: no mistake, but a warning. Gravity acts on everything, wherever its load is written, and that of a component stands once for
//! each part.

use crate::check::messages as say;
use crate::check::values::read;
use crate::errors::{Area, Mistake};
use crate::parse::tree::{Call, Item, ItemKind, Keyword, Tree};

/// What the compiler says to be deprecated where such a warning stands.
const WARNING: &str = "added_weight";

/// Warnings about uniform gravity beside another one. A leading underscore of the load's name silences them.
pub fn added_weights(tree: &Tree) -> Vec<Mistake> {
    let loads = tree.items.iter().filter(|item| item.keyword == Keyword::Load);
    let weights: Vec<&Item> = loads
        .filter(|item| matches!(&item.kind, ItemKind::Load(call) if is_uniform(call)))
        .collect();
    let beside = |pair: &[&Item]| {
        let [first, second] = [pair[0], pair[1]].map(|item| &item.name);
        let message = say::added_weight(&first.text, &second.text);
        (!second.word().starts_with('_')).then(|| Mistake::new(Area::from(second.span), message).called(WARNING))
    };
    weights.windows(2).filter_map(beside).collect()
}

/// Whether a load is gravity on everything.
pub fn is_everywhere(call: &Call) -> bool {
    let has_frame = call.arguments.iter().any(|argument| argument.name.is_some());
    call.name.text == "gravity" && !has_frame
}

/// Whether it is the same at all places, too.
fn is_uniform(call: &Call) -> bool {
    let mut names = Vec::new();
    call.arguments
        .iter()
        .for_each(|argument| read::names(&argument.value, &mut names));
    is_everywhere(call) && !names.contains(&"position")
}
