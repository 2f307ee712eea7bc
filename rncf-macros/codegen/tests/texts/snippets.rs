//! What stands in the fenced blocks of a page: whole models, and items that a model completes.
//! The build of `tests/guide` reads the guide with it, too.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use rncf_codegen::generate::declarations;

/// Items that end with their braces; all others, and sections with a `=`, end with a semicolon.
const BRACED: &[&str] = &[
    "material",
    "table",
    "section",
    "body",
    "rigid",
    "fixture",
    "run",
    "for",
    "component",
    "element",
];

/// Contents of the fenced blocks with a tag.
pub fn blocks(text: &str, tag: &str) -> Vec<String> {
    let mut blocks: Vec<String> = Vec::new();
    let mut open: Option<bool> = None;
    for line in text.lines() {
        match (line.trim_start().strip_prefix("```"), open) {
            (Some(found), None) => {
                open = Some(found.trim() == tag);
                blocks.extend(open.filter(|wanted| *wanted).map(|_| String::new()));
            }
            (Some(_), Some(_)) => open = None,
            (None, Some(true)) => *blocks.last_mut().unwrap() += &format!("{line}\n"),
            (None, _) => {}
        }
    }
    assert!(open.is_none(), "a fenced block is not closed");
    blocks
}

/// The tokens between the parentheses or braces of every `model!` in a document.
pub fn models(text: &str) -> Vec<TokenStream> {
    let mut models = Vec::new();
    for block in blocks(text, "rust").iter().filter(|block| block.contains("model!")) {
        models.extend(declarations(block).unwrap_or_else(|error| panic!("{error} in\n{block}")));
    }
    models
}

/// The items of a model: kind, name, tokens.
fn items(content: TokenStream) -> Vec<(String, String, TokenStream)> {
    let mut items = Vec::new();
    let mut item: Vec<TokenTree> = Vec::new();
    for token in content {
        let words = item.iter().filter_map(|token| match token {
            TokenTree::Ident(word) => Some(word.to_string()),
            _ => None,
        });
        let words: Vec<String> = words.take(2).collect();
        let is_assigned = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == '=');
        let braced = words.first().is_some_and(|word| BRACED.contains(&word.as_str())) && !item.iter().any(is_assigned);
        let ends = match &token {
            TokenTree::Punct(punct) => !braced && punct.as_char() == ';',
            TokenTree::Group(group) => braced && group.delimiter() == Delimiter::Brace,
            _ => false,
        };
        item.push(token);
        if ends {
            let [kind, name] = [0, 1].map(|at| words.get(at).cloned().unwrap_or_default());
            items.push((kind, name, item.drain(..).collect()));
        }
    }
    assert!(
        item.is_empty(),
        "items end with `;` or braces: {}",
        item.into_iter().collect::<TokenStream>()
    );
    items
}

/// `example` and, of the first model of the document, what it does not declare itself.
pub fn completed(tutorial: &TokenStream, example: &str) -> TokenStream {
    let example: TokenStream = example.parse().unwrap_or_else(|error| panic!("{error} in\n{example}"));
    let content = tutorial.clone().into_iter().find_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    });
    let declared = items(example.clone());
    let is_declared = |kind: &str, name: &str| {
        declared
            .iter()
            .any(|(k, n, _)| n == name && (k == kind || kind != "output"))
    };
    let rest = items(content.expect("a model has braces")).into_iter();
    let rest = rest
        .filter(|(kind, name, _)| !is_declared(kind, name))
        .map(|(.., tokens)| tokens);
    let all: TokenStream = std::iter::once(example).chain(rest).collect();
    format!("model Example {{ {all} }}")
        .parse()
        .expect("tokens make tokens")
}
