//! The text of a declaration, for the documentation of what is generated.

use proc_macro2::{Delimiter, Group, Spacing, TokenStream, TokenTree};

use super::tree::Tree;

/// The declaration as written where the source is at hand, else printed readably from its tokens.
pub fn declaration(tree: &Tree, body: &Group) -> String {
    let mut head = tree.visibility_text();
    if !head.is_empty() {
        head.push(' ');
    }
    let body = body
        .span()
        .source_text()
        .map_or_else(|| printed(body), |text| dedent(&text));
    format!("{head}model {} {body}", tree.name.text)
}

/// Without the indentation that the closing brace has.
fn dedent(text: &str) -> String {
    let last = text.lines().last().unwrap_or_default();
    let indent = &last[..last.len() - last.trim_start().len()];
    let lines = text
        .lines()
        .map(|line| line.strip_prefix(indent).unwrap_or(line.trim_start()).trim_end());
    lines.collect::<Vec<_>>().join("\n")
}

fn printed(body: &Group) -> String {
    let mut out = String::new();
    group(body, 0, &mut out);
    out
}

fn group(group: &Group, level: usize, out: &mut String) {
    let (open, close) = match group.delimiter() {
        Delimiter::Parenthesis => ("(", ")"),
        Delimiter::Bracket => ("[", "]"),
        Delimiter::Brace => ("{", "}"),
        Delimiter::None => ("", ""),
    };
    out.push_str(open);
    // A block of statements gets lines of its own; a value in braces stays in its line.
    let is_block = group.delimiter() == Delimiter::Brace && has_statements(group.stream());
    let is_value = group.delimiter() == Delimiter::Brace && !is_block;
    if is_block {
        new_line(level + 1, out);
    } else if is_value {
        out.push(' ');
    }
    tokens(group.stream(), level + usize::from(is_block), is_block, out);
    if is_block {
        new_line(level, out);
    } else if is_value {
        out.push(' ');
    }
    out.push_str(close);
}

fn has_statements(stream: TokenStream) -> bool {
    stream
        .into_iter()
        .any(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';'))
}

fn new_line(level: usize, out: &mut String) {
    out.truncate(out.trim_end().len());
    out.push('\n');
    out.push_str(&"    ".repeat(level));
}

fn tokens(stream: TokenStream, level: usize, is_block: bool, out: &mut String) {
    let mut tokens = stream.into_iter().peekable();
    let mut tight = true;
    while let Some(token) = tokens.next() {
        if let TokenTree::Punct(punct) = &token
            && punct.as_char() == '#'
        {
            // A documentation comment; it is printed with the item that it describes.
            tokens.next();
            continue;
        }
        let sticks = match &token {
            TokenTree::Punct(punct) => ";,.^:/".contains(punct.as_char()),
            TokenTree::Group(group) => group.delimiter() == Delimiter::Parenthesis && ends_in_word(out),
            _ => false,
        };
        if !tight && !sticks {
            out.push(' ');
        }
        tight = matches!(&token, TokenTree::Punct(punct)
            if ".^/".contains(punct.as_char()) || punct.spacing() == Spacing::Joint);
        let is_end = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';');
        match token {
            TokenTree::Group(inner) => {
                group(&inner, level, out);
                if is_block && has_statements(inner.stream()) && tokens.peek().is_some() {
                    new_line(level, out);
                    tight = true;
                }
            }
            token => out.push_str(&token.to_string()),
        }
        if is_end && is_block && tokens.peek().is_some() {
            new_line(level, out);
            tight = true;
        }
    }
}

fn ends_in_word(out: &str) -> bool {
    out.ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_')
}
