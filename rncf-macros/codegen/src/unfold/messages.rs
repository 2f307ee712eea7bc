//! What is said about loops, parts and the names in them.

pub use crate::messages::{
    beyond_repetitions, duplicate, meaning_of_its_own, negative_repetition, not_repeated, runs_out,
};
pub use crate::suggest::a;

pub const IN_KEPT: &str = "this loop stands in one whose number is a param and known at run time only: make that a `const n = 3;`, or count through both with one index";
pub const OUTPUT_IN_KEPT: &str = "the number of this loop is known at run time only, and outputs are columns: make it a `const n = 3;`, or look at one repetition from outside, e.g. `main[0].end.x`, or at all of them, e.g. `max(a in 0..n, main[a].end.x)`";
pub const PART_AS_VALUE: &str = "this is a part: say what of it, e.g. `blade.root`";
pub const OUTPUT_NAME: &str = "the name of an output stands here, e.g. `blade[0].tip`";
pub const NAME_WANTED: &str = "the name of a frame, rigid body or table stands here";
pub const TOO_DEEP: &str = "what parts are told is nested too deeply: give parts of it names with `let`";
pub const NOT_NUMBERED: &str = "this is not repeated: leave out the brackets";
pub const NO_CALL: &str = "only a motion has a value at a time, `pitch[b](t)`";
pub const NAMED_ARGUMENTS: &str = "a component is told by name: write e.g. `azimuth = 30 deg`";

pub const CORNERS_IN_KEPT: &str =
    "the number of this loop is known at run time only, where a body has no corners: make it a `const n = 3;`";

messages! {
    cornered_without(word) = "`{word}` is for a body without corners: leave it out, or declare the straight pieces as bodies and `weld` them";
    cornered_whole(name) = "`{name}` has corners: say which of its straight pieces, `{name}[0]`";
    cornered_place(name) = "places on a body with corners are `{name}.start`, `{name}.end`, and those of a straight piece, e.g. `{name}[1].at(0.2 m)`, counted from its corner";
    cornered_quantity(name, word) = "`{word}` is that of a straight piece, e.g. `{name}[0].{word}`: for all of `{name}` there is no sum of it";
    piece_unknown(name) = "this number of a straight piece of `{name}` must be known when the model is built: it is made of whole numbers, constants and indices of such loops";
    not_kept(word) = "{word} is repeated where the number is known at build time, and that of this loop is a param: make it a `const n = 3;`, or declare it outside of the loop, for each repetition that needs it";
    too_many(most) = "this becomes more than {most} items: a loop over a `param n: count` stands once, whatever its number";
    told_already(name, line) = "`{name}` is what the component is told (line {line}): choose another name";
    index_twice(name) = "`{name}` is the index of a loop around this one: choose another one";
    written_alike(name, other) = "`{name}` and `{other}` have the same name in generated code: choose another one";
    repeated(name, index) = "`{name}` is repeated: write the number of the repetition, `{name}{index}`";
    no_index(name) = "`{name}` is the index of no loop here";
    number_unknown(name) = "`{name}` is repeated at build time, so that this number must be known then: it is made of indices of such loops, whole numbers and constants";
    whole_number(name) = "repetitions of `{name}` have whole numbers from 0";
    none_exist(name) = "`{name}` is repeated 0 times: there is none";
    not_in_part(name, part) = "`{part}` has no `{name}`";
    recursion(name, chain) = "`{name}` is placed in itself: {chain}";
    missing(component, names) = "`{component}` must be told {names}";
    told_twice(name) = "`{name}` is told twice";
    wrong_item(name, kind, wanted) = "`{name}` is {kind}, but {wanted} is wanted here";
    name_wanted(wanted) = "the name of {wanted} is wanted here";
    not_a_component(name, kind) = "`{name}` is {kind}: a part is placed from a `component`";
}
