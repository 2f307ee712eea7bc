//! The pages of errors are true: every wrong example gets its message and no other, every cured
//! one gets none, and every message of the checks has an entry.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use crate::documents::{Page, blocks, pages};
use crate::language::{completed, example_model, messages};

/// Messages of the checks that no page shows yet, and why.
const NOT_SHOWN: &[(&str, &str)] = &[
    ("IMPORT_REPEATED", "not yet"),
    ("NEGATIVE_DAMPING", "not yet"),
    ("LONG_CHAIN", "not yet"),
    ("TOO_DEEP", "not yet"),
    ("NO_SLOPE", "not yet"),
    ("CURVED_ENERGY", "not yet"),
    ("CONDITION_OF_ELEMENT", "not yet"),
    ("HOLD_NOT_REPEATED", "not yet"),
    ("NOTHING_OBSERVED", "not yet"),
    ("THREE_COMPONENTS", "not yet"),
    ("ANGLE_OF_END", "not yet"),
    ("NO_OUTPUT", "not yet"),
    ("CAUTION_WITHOUT_TIME", "not yet"),
    ("NOT_REPETITIONS", "not yet"),
    ("INDEX_AS_COUNT", "not yet"),
    ("WHOLE_REPETITION", "not yet"),
    ("REPETITION_EXPRESSION", "not yet"),
    ("SAME_END_REPEATED", "not yet"),
    ("SAME_ENDS_REPEATED", "not yet"),
    ("REPEATED_TO_FREE", "not yet"),
    ("SHARED_INSIDE", "not yet"),
    ("SAME_END", "not yet"),
    ("modes_of_timed", "not yet"),
    ("quantity_as_repetitions", "not yet"),
    ("index_in_constant", "not yet"),
    ("repeated_inside", "not yet"),
    ("load_not_repeated", "not yet"),
    ("joint_not_repeated", "not yet"),
    ("statement_not_repeated", "not yet"),
    ("shared_and_held", "not yet"),
    ("shared_twice", "not yet"),
    ("unit_or_name", "not yet"),
    ("not_imported", "not yet"),
    ("import_without_modes", "not yet"),
    ("import_damping", "not yet"),
    ("import_wrong", "not yet"),
    ("node_twice", "not yet"),
    ("no_node", "not yet"),
    ("unit_of_file", "not yet"),
    ("energy_of_own_element", "not yet"),
    ("other_plane", "not yet"),
    ("distant_axis", "it is a warning, and entries are errors"),
    ("loose_tie", "it is a warning, and entries are errors"),
    ("balance_of_repeated", "not yet"),
    ("carried_by_point", "not yet"),
    ("no_component", "not yet"),
    ("start_twice", "not yet"),
    ("start_of_modes", "not yet"),
    ("start_with_velocity", "not yet"),
    ("start_out_of_plane", "not yet"),
    ("unused", "it is a warning, and entries are errors"),
    ("unseen", "it is a warning, and entries are errors"),
    ("unread_property", "it is a warning, and entries are errors"),
];

/// A wrong example, its message, and the cured example.
struct Entry {
    wrong: String,
    message: String,
    cured: String,
}

/// The entries of a page, in their order.
fn entries(page: &Page) -> Vec<Entry> {
    let (wrong, cured) = (blocks(&page.text, "error"), blocks(&page.text, "cured"));
    assert_eq!(wrong.len(), cured.len(), "{}: every error is cured", page.path);
    let entry = |(block, cured): (String, String)| {
        let (wrong, message) = block
            .split_once("\n//~ ")
            .unwrap_or_else(|| panic!("{}: no message in\n{block}", page.path));
        Entry {
            wrong: wrong.to_owned(),
            message: message.trim_end().to_owned(),
            cured,
        }
    };
    wrong.into_iter().zip(cured).map(entry).collect()
}

/// The names and texts of a table of messages: `const NAME: &str = "..";` and `name(..) = "..";`.
fn table(source: &str) -> Vec<(String, String)> {
    let file = syn::parse_file(source).expect("a table of messages is Rust");
    let mut found = Vec::new();
    for item in file.items {
        match item {
            syn::Item::Const(item) => {
                if let syn::Expr::Lit(syn::ExprLit {
                    lit: syn::Lit::Str(text),
                    ..
                }) = *item.expr
                {
                    // A text without arguments has no braces to fill.
                    let text = text.value().replace('{', "{{").replace('}', "}}");
                    found.push((item.ident.to_string(), text));
                }
            }
            syn::Item::Macro(item) if item.mac.path.is_ident("messages") => {
                let mut name = String::new();
                for token in item.mac.tokens {
                    match token {
                        proc_macro2::TokenTree::Ident(word) => name = word.to_string(),
                        proc_macro2::TokenTree::Literal(literal) => {
                            let text: syn::LitStr = syn::parse_str(&literal.to_string()).expect("a message is a text");
                            found.push((name.clone(), text.value()));
                        }
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }
    found
}

/// The parts of a text between its arguments.
fn parts(text: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        let doubled = letters.peek() == Some(&letter);
        match letter {
            '{' | '}' if doubled => parts.last_mut().unwrap().extend(letters.next()),
            '{' => {
                while letters.next_if(|letter| *letter != '}').is_some() {}
                letters.next();
                parts.push(String::new());
            }
            _ => parts.last_mut().unwrap().push(letter),
        }
    }
    parts
}

/// Whether a message is made of these parts, with anything between them.
fn is_made_of(message: &str, parts: &[String]) -> bool {
    let [first, between @ .., last] = parts else {
        return message == parts[0];
    };
    let Some(mut rest) = message.strip_prefix(first.as_str()) else {
        return false;
    };
    for part in between {
        match rest.split_once(part.as_str()) {
            Some((_, behind)) => rest = behind,
            None => return false,
        }
    }
    rest.ends_with(last.as_str())
}

#[test]
fn every_entry_is_told_and_cured() {
    let (mut wrong, mut seen) = (Vec::new(), HashSet::new());
    for page in pages("docs/errors") {
        let model = example_model(&page);
        for entry in entries(&page) {
            let found = messages(completed(&model, &entry.wrong));
            if found != [entry.message.clone()] {
                wrong.push(format!("{}: {}\n  {}", page.path, entry.wrong, found.join("\n  ")));
            }
            let found = messages(completed(&model, &entry.cured));
            if !found.is_empty() {
                wrong.push(format!(
                    "{}, cured: {}\n  {}",
                    page.path,
                    entry.cured,
                    found.join("\n  ")
                ));
            }
            if !seen.insert(entry.message.clone()) {
                wrong.push(format!("{}: twice: {}", page.path, entry.message));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(!seen.is_empty(), "the pages have entries");
}

#[test]
fn every_message_of_the_checks_has_an_entry() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/check/messages.rs");
    let table = table(&fs::read_to_string(source).expect("the table of messages"));
    let table: Vec<_> = table.iter().map(|(name, text)| (name.as_str(), parts(text))).collect();
    let literal = |parts: &[String]| parts.iter().map(String::len).sum::<usize>();
    let mut shown = HashSet::new();
    for entry in pages("docs/errors").iter().flat_map(entries) {
        // Of all texts that fit, the one with the most words of its own is meant.
        let fits = table.iter().filter(|(_, parts)| is_made_of(&entry.message, parts));
        shown.extend(fits.max_by_key(|(_, parts)| literal(parts)).map(|(name, _)| *name));
    }
    let excused: HashSet<&str> = NOT_SHOWN.iter().map(|(name, _)| *name).collect();
    let names: HashSet<&str> = table.iter().map(|(name, _)| *name).collect();
    let wrong = |what: &str, names: Vec<&str>| assert!(names.is_empty(), "{what}: {names:#?}");
    let missing = table.iter().map(|(name, _)| *name);
    wrong(
        "no entry shows",
        missing
            .filter(|name| !shown.contains(name) && !excused.contains(name))
            .collect(),
    );
    wrong("NOT_SHOWN, and shown", excused.intersection(&shown).copied().collect());
    wrong(
        "NOT_SHOWN, and no message",
        excused.difference(&names).copied().collect(),
    );
}
