//! Wrong models, listed in wrong.txt: what is underlined, and what is said.
//!
//! `BLESS=1 cargo test -p rncf-codegen wrong` rewrites the expectations; read the difference.

use super::{SPIN_UP, run};

const LIST: &str = include_str!("wrong.txt");

/// The model of a block: the spin-up model with snippets exchanged, or a whole one.
fn text(block: &str) -> String {
    let mut text = SPIN_UP.to_string();
    let mut from = None;
    for line in block.lines() {
        if let Some(model) = line.strip_prefix("model:") {
            return model.to_string();
        } else if let Some(snippet) = line.strip_prefix("replace: ") {
            from = Some(snippet);
        } else if let Some(to) = line.strip_prefix("with:") {
            let from = from.take().expect("`replace:` before `with:`");
            assert_eq!(text.matches(from).count(), 1, "`{from}` stands once in the text");
            text = text.replace(from, to.strip_prefix(' ').unwrap_or(to));
        }
    }
    text
}

/// The block with the mistakes that are found.
fn found(block: &str) -> String {
    let is_input = |line: &&str| {
        ["model:", "replace:", "with:"]
            .iter()
            .any(|word| line.starts_with(word))
    };
    let mut lines: Vec<String> = block.lines().filter(is_input).map(ToString::to_string).collect();
    for mistake in run(&text(block)).1 {
        let underlined = mistake.area.source_text().unwrap_or_default();
        let underlined = underlined.split_whitespace().collect::<Vec<_>>().join(" ");
        lines.push(format!("  {underlined}"));
        lines.push(format!("    {}", mistake.message));
    }
    lines.join("\n")
}

#[test]
fn wrong_models_say_what_would_be_right() {
    let mut blocks = LIST.trim_end().split("\n\n");
    let head = blocks.next().expect("a heading");
    let blocks: Vec<&str> = blocks.collect();
    assert!(blocks.len() > 100);
    let found: Vec<String> = blocks.iter().map(|block| found(block)).collect();
    if std::env::var_os("BLESS").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/check/tests/wrong.txt");
        std::fs::write(path, format!("{head}\n\n{}\n", found.join("\n\n"))).expect("wrong.txt can be written");
    }
    for (block, found) in blocks.iter().zip(&found) {
        assert!(found.contains("\n    "), "no mistake found in\n{block}");
        assert_eq!(block, found);
    }
}
