//! The pages of errors are true: every wrong example gets its message and no other, every cured
//! one gets none, and every message of the generator's tables has an entry.

use std::collections::HashSet;
use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use rncf_codegen::elements::Library;
use rncf_codegen::expand;

use crate::documents::{Page, pages};
use crate::language::{example_model, messages};
use crate::snippets::{blocks, completed, models};

/// The tables of messages, in `src`.
const TABLES: &[&str] = &[
    "messages.rs",
    "unfold/messages.rs",
    "parse/messages.rs",
    "check/messages.rs",
    "check/messages_along.rs",
    "check/element/messages.rs",
];

/// Messages that no page shows, and why.
const NOT_SHOWN: &[(&str, &str)] = &[
    ("unfold/TOO_DEEP", "its example would fill a page"),
    ("parse/TOO_DEEP", "its example would fill a page"),
    (
        "parse/USE_IN_LIBRARY",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    (
        "parse/USE",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    (
        "parse/not_shared",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    (
        "parse/after_library",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    (
        "parse/library_twice",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    (
        "parse/after_model",
        "it stands in a library or behind a model, and the pages' examples are items of one model",
    ),
    ("check/LONG_CHAIN", "its example would fill a page"),
    ("check/TOO_DEEP", "its example would fill a page"),
    (
        "check/THREE_COMPONENTS",
        "another number of components is told before, and this stands for what no text is known of",
    ),
    (
        "check/vector_wanted",
        "its words are put together of several texts, and its entry is not told from others",
    ),
    ("check/dropped", "it tells of a defect of the checks, and none is known"),
    ("check/energy_of_own_element", "its example would fill a page"),
    (
        "check/no_component",
        "a vector lacks the component across its plane alone, which is told to be zero",
    ),
];

/// A wrong example, its message, and the cured example.
struct Entry {
    wrong: String,
    message: String,
    cured: String,
}

/// The entries of a page, in their order.
fn entries(page: &Page) -> Vec<Entry> {
    tagged(page, ["error", "cured"])
}

/// The whole models of a page with their warnings, and the models that have none, in their order.
fn warned(page: &Page) -> Vec<Entry> {
    tagged(page, ["warned", "calm"])
}

fn tagged(page: &Page, tags: [&str; 2]) -> Vec<Entry> {
    let [wrong, cured] = tags.map(|tag| blocks(&page.text, tag));
    assert_eq!(wrong.len(), cured.len(), "{}: every `{}` is cured", page.path, tags[0]);
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
                        TokenTree::Ident(word) => name = word.to_string(),
                        TokenTree::Literal(literal) => {
                            let text: syn::LitStr = syn::parse_str(&literal.to_string()).expect("a message is a text");
                            found.push((name.clone(), text.value()));
                        }
                        _ => {}
                    }
                }
            }
            syn::Item::Fn(item) => {
                let block = &item.block;
                let text = last_format(quote::quote!(#block));
                found.extend(text.map(|text| (item.sig.ident.to_string(), text)));
            }
            _ => {}
        }
    }
    found
}

/// The text of the last `format!`, which is the message.
fn last_format(tokens: TokenStream) -> Option<String> {
    let mut found = None;
    let mut before = String::new();
    for token in tokens {
        if let TokenTree::Group(group) = &token {
            let first = group.stream().into_iter().next().filter(|_| before == "format!");
            let text = first.and_then(|token| syn::parse_str::<syn::LitStr>(&token.to_string()).ok());
            found = text
                .map(|text| text.value())
                .or_else(|| last_format(group.stream()))
                .or(found);
        }
        before = match token {
            TokenTree::Ident(word) => word.to_string(),
            TokenTree::Punct(mark) if mark.as_char() == '!' => before + "!",
            _ => String::new(),
        };
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

/// The model of the page with `words` in the place of those of the cured example, if these stand in it once; else the
/// example, and of the model what it does not declare.
fn filled_in(page: &Page, entry: &Entry, words: &str) -> TokenStream {
    let flush = |text: &str| text.lines().map(str::trim).collect::<Vec<_>>().join("\n");
    let model = blocks(&page.text, "rust")
        .into_iter()
        .find(|block| block.contains("model!"));
    let (model, cured) = (model.map(|model| flush(&model)), flush(entry.cured.trim()));
    match model.filter(|model| model.matches(&cured).count() == 1) {
        Some(model) => models(&format!("```rust\n{}\n```", model.replace(&cured, words.trim())))[0].clone(),
        None => completed(&example_model(page), words),
    }
}

#[test]
fn every_entry_is_told_and_cured() {
    let (mut wrong, mut seen, mut checked) = (Vec::new(), HashSet::new(), HashSet::new());
    for page in pages("docs/errors") {
        for entry in entries(&page) {
            let found = messages(filled_in(&page, &entry, &entry.wrong));
            if found != [entry.message.clone()] {
                wrong.push(format!("{}: {}\n  {}", page.path, entry.wrong, found.join("\n  ")));
            }
            let cured = filled_in(&page, &entry, &entry.cured);
            let found = match checked.insert(cured.to_string()) {
                true => messages(cured),
                false => Vec::new(),
            };
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
fn every_warning_is_told_and_cured() {
    let told = |text: &str| -> Vec<String> {
        let tokens: TokenStream = text.parse().unwrap_or_else(|error| panic!("{error} in\n{text}"));
        assert!(messages(tokens.clone()).is_empty(), "{text}: {:?}", messages(tokens));
        let warnings = expand::warnings(tokens, &Library::standard());
        warnings.into_iter().map(|warning| warning.message).collect()
    };
    let all: Vec<Entry> = pages("docs/errors").iter().flat_map(warned).collect();
    assert!(!all.is_empty());
    for entry in all {
        assert_eq!(told(&entry.wrong), [entry.message], "{}", entry.wrong);
        assert!(told(&entry.cured).is_empty(), "{}", entry.cured);
    }
}

/// Every entry says in a sentence what the message comes from, before it shows it.
#[test]
fn every_entry_tells_its_cause() {
    let mut silent = Vec::new();
    for page in pages("docs/errors") {
        for entry in page.text.split("\n### ").skip(1) {
            let (heading, rest) = entry.split_once('\n').unwrap_or((entry, ""));
            let cause = rest.split("```").next().unwrap_or("").trim();
            if !cause.ends_with(['.', ':', ')']) || cause.split_whitespace().count() < 3 {
                silent.push(format!("{}: {heading}", page.path));
            }
        }
    }
    assert!(silent.is_empty(), "entries without a cause:\n{}", silent.join("\n"));
}

#[test]
fn every_message_has_an_entry() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let tables: Vec<_> = TABLES
        .iter()
        .flat_map(|path| {
            let text = fs::read_to_string(source.join(path)).expect("a table of messages");
            let folder = path
                .trim_end_matches("messages.rs")
                .trim_end_matches("messages_along.rs");
            table(&text)
                .into_iter()
                .map(move |(name, text)| (format!("{folder}{name}"), text))
        })
        .collect();
    let table: Vec<_> = tables.iter().map(|(name, text)| (name.as_str(), parts(text))).collect();
    let literal = |parts: &[String]| parts.iter().map(String::len).sum::<usize>();
    let mut shown = HashSet::new();
    let pages = pages("docs/errors");
    for entry in pages.iter().flat_map(|page| [entries(page), warned(page)]).flatten() {
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
