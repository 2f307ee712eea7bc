//! How messages are written down as data, and those that reading and checking share.

/// Functions that fill the texts: `name(argument) = "text with {argument}";`.
macro_rules! messages {
    ($($name:ident($($argument:ident),*) = $text:literal;)*) => {
        $(pub fn $name($($argument: &str),*) -> String {
            format!($text)
        })*
    };
}

messages! {
    index_outside(name) = "`{name}` is the index of a loop and known between its braces only";
    duplicate(name, kind, line) = "`{name}` is already declared as `{kind}` in line {line}";
    not_ascii(text, plain) = "`{text}` is not ASCII: write `{plain}`";
    not_a_number(text) = "`{text}` is not a decimal number: write e.g. `8`, `0.5` or `1e-5`";
}
