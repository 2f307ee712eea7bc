//! How messages are written down as data, and those that reading and checking share.

/// Functions that fill the texts: `name(argument) = "text with {argument}";`.
macro_rules! messages {
    ($($name:ident($($argument:ident),*) = $text:literal;)*) => {
        $(pub fn $name($($argument: &str),*) -> String {
            format!($text)
        })*
    };
}

pub const POWER: &str = "a power is written with `^`: `a^2`";

messages! {
    index_outside(name) = "`{name}` is the index of a loop and known between its braces only";
    duplicate(name, kind, line) = "`{name}` is already declared as `{kind}` in line {line}";
    not_repeated(name) = "`{name}` is not repeated: leave out the brackets";
    meaning_of_its_own(name) = "`{name}` has a meaning of its own: choose another name";
    runs_out(index, at, number, name, last) = "for {index} = {at} this is {number}, but repetitions of `{name}` are numbered from 0 to {last}: a ring closes with `%`, e.g. `({index} + 1) % n`";
    beyond_repetitions(name, last) = "repetitions of `{name}` are numbered from 0 to {last}";
    negative_repetition(name) = "repetitions of `{name}` are numbered from 0";
    not_ascii(text, plain) = "`{text}` is not ASCII: write `{plain}`";
    not_a_number(text) = "`{text}` is not a decimal number: write e.g. `8`, `0.5` or `1e-5`";
}
