//! What is said about text that cannot be read: what is wrong, and what would be right.

pub use crate::messages::{POWER, meaning_of_its_own, not_a_number, not_ascii};
use crate::suggest::a;
pub use crate::suggest::unknown;

pub const TOO_DEEP: &str = "this is nested too deeply: give parts of it names with `const` or `motion`";
pub const PLUS_SIGN: &str = "a leading `+` has no meaning here: leave it out";
pub const MISSING_ELSE: &str = "an `if` is a value and needs both cases: `if t < T { .. } else { .. }`";
pub const NO_EQUALITY: &str =
    "values are compared with `<`, `<=`, `>` or `>=`: two real numbers are never safely equal";
pub const TERNARY: &str = "a choice is written `if a < b { x } else { y }`";
pub const COMMENT: &str = "a comment begins with `//`";
pub const QUOTES: &str = "quotes have no meaning here: leave them out";
pub const VECTOR_BRACKETS: &str = "a vector stands in square brackets: `[x, y, z]`";
pub const IF_PARENTHESES: &str = "a condition stands without parentheses: `if a < b { x } else { y }`";
pub const RANGE_AS_VALUE: &str = "a range is no value: it stands behind `in` of a loop, and on the command line";
pub const FIELDS_WITHOUT_EQUALS: &str = "fields stand right behind the name: leave out `=`";
pub const COUNT_BEHIND: &str =
    "the number of elements stands in front of the element: `mesh 6 * cable(section, material);`";
pub const COUNT_IN_BRACKETS: &str =
    "a number of elements that is computed stands in brackets: `mesh (2*n) * cable(section, material);`";
pub const INCH: &str = "an inch is written `inch`: `in` stands before frames and ranges";
pub const NO_LOGIC: &str =
    "conditions are not combined: put one `if` into the other, `if a < b { if c < d { x } else { y } } else { y }`";
pub const LONE_COMPARISON: &str = "a comparison stands behind `if`: write `if a < b { x } else { y }`";
pub const PERCENT: &str = "a percentage is written as a plain number: `0.3` for 30 %";
pub const MOTION_ARGUMENT: &str = "a motion is a function of time: write `(t)`";
pub const INNER_DOC: &str = "documentation stands before what it describes: write `///`";
pub const ATTRIBUTE: &str = "attributes have no meaning here; only documentation comments `///` do";

pub const COMPONENT_IN_LOOP: &str =
    "a component is declared once, outside of loops: in the loop stands `part name[a] = ..;`";
pub const COMPONENT_INSIDE: &str =
    "a component is declared beside others, not in them: take it out, and place it here with `part name = ..;`";
pub const PARAM_INSIDE: &str = "params belong to the model: let the component be told it, `(name: unit = value)`";
pub const USE_IN_LIBRARY: &str =
    "a library uses no other one: let the model use both, then each finds the names of the other";
pub const USE: &str = "a library is used by its path: `use crate::blades;`, in front of `model`, each by itself";
pub const RUN_INSIDE: &str = "a `run` belongs to the model: write it outside of components";
pub const RANGE: &str = "a loop needs its range: write `0..` and the number of repetitions, e.g. `0..n`";
pub const RANGE_START: &str = "repetitions are numbered from 0: write `0..` and their number, e.g. `0..n`";
pub const RANGE_END: &str = "`0..n` counts from 0 to n - 1: leave out `=` and count one more, `0..4` and not `0..=3`";

pub const ELEMENT_ARGUMENTS: &str = "an element is made of a section and a material: write `(section, material)`";
pub const ELEMENT_DOMAIN: &str =
    "the unit element of a line is `0..1`: write `domain xi in 0..1;`; surfaces and solids are not there yet";

messages! {
    coefficient_without_unit(name) = "the unit of `{name}` is missing: write e.g. `coefficient {name}: N = ..;`";
    file_of_table(name) = "what a file holds is a table: write `param {name}: table = file(\"..\");`";
    outside_of_loops(word) = "`{word}` stands outside of loops: it is the same for all repetitions";
    after_library(found) = "one `library!` declares one library: nothing may follow its braces, found {found}";
    library_twice(name) = "the library `{name}` is used twice: leave one out";
    parameter_twice(name) = "the component is told `{name}` twice: leave one out";
    parameter_kind(word, words) = "`{word}` says not what the component is told: write a unit such as `m` or `kg/m`, or `{words}`";
    lacks_index(name, index) = "`{name}` stands in a loop: write `{name}[{index}]`";
    index_without_loop(name) = "`{name}` stands in no loop: leave out the brackets, or put it into one, `for a in 0..n {{ .. }}`";
    other_index(name, index) = "the index of this loop is `{index}`: write `{name}[{index}]`";
    not_a_reduction(name) = "`{name}` does not go over repetitions: `max`, `min`, `sum` and `mean` do";
    expected(what, found) = "expected {what}, found {found}";
    missing_semicolon(found) = "missing `;` after this (next comes {found})";
    without_keyword(name, keyword, call) = "what `{name}` is does not stand in front of it: write `{keyword} {name} = {call}(..);`";
    missing_name(keyword) = "`{keyword}` needs a name: `{keyword} name ..`";
    unnamed(keyword, word) = "`{keyword}` needs a name in front of `{word}`: `{keyword} name = {word} ..;`";
    quantity_kind(name) = "a quantity is written `param {name} = 2 m;`: only a whole number, `{name}: count`, and a table, `{name}: table`, have their kind in front";
    named_by_colon(name) = "what an argument is stands behind `=`: `{name} = ..`";
    decimal_comma(left, right) = "a decimal number is written with a point: `{left}.{right}`";
    bare_point(digits) = "a number begins with a digit: `0.{digits}`";
    unit_point(left, right) = "factors of a unit are joined by `*`: write `[{left}*{right}]`";
    unit_of_output(unit) = "the unit that an output is told in stands behind its name: `output name: {unit} = ..;`";
    seen_in(frame) = "the frame that an output is seen in stands behind the place: `.in({frame})`";
    after_model(found) = "one `model!` declares one model: nothing may follow its braces, found {found}";
    missing_space(number, unit) = "a space is missing between number and unit: `{number} {unit}`";
    no_equals(word) = "a statement of a body has no `=`: write the value right behind `{word}`";
    mode_count(word) = "`{word}` takes the number of modes: `{word}(4);`";
    unit_power(number, unit, power) = "after a number in an expression one unit symbol is read: write the power in brackets, `{number} [{unit}^{power}]`, or mean `({number} {unit})^{power}`";
    unit_after_slash(found) = "is {found} above or below the line? write `*`, or parentheses as in `W/(m K)`";
    raw_name(plain) = "raw names are not allowed: choose another name than `{plain}`, which is a keyword of Rust";
    rust_keyword(text) = "`{text}` is a keyword of Rust and cannot be a name: try `{text}_`";
}

/// An inertia with another number of components.
pub fn inertia_components(count: usize) -> String {
    format!("an inertia has three components `[xx, yy, zz]` or six, `[xx, yy, zz, xy, xz, yz]`, this one has {count}")
}

/// `[..]` with another number of components.
pub fn three_components(count: usize) -> String {
    format!("a vector has three components `[x, y, z]`, this one has {count}")
}

/// What belongs to a model and stands in a library, which may hold `shared` and components.
pub fn not_shared(word: &str, shared: &[&str]) -> String {
    let list: Vec<String> = shared.iter().map(|word| format!("`{word}`")).collect();
    format!(
        "{} belongs to a model: in a library there are {} and `component`",
        a(&format!("`{word}`")),
        list.join(", ")
    )
}
