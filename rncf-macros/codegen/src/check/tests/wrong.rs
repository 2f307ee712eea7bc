//! Wrong models, listed in wrong.txt, first.txt, free.txt, joints.txt, sections.txt, along.txt, elements.txt, repeat.txt, parts.txt, meaning.txt and space.txt: what is underlined, and what is said.
//!
//! `BLESS=1 cargo test -p rncf-codegen wrong` rewrites the expectations; read the difference.

use super::along::ALONG;
use super::elements::ELEMENTS;
use super::first::FIRST;
use super::free::FREE;
use super::joints::JOINTS;
use super::meaning::{MEANING, SPACE};
use super::parts::ROTOR;
use super::repeat::SAIL;
use super::sections::SECTIONS;
use super::{SPIN_UP, run};

/// The model of a block: the model with snippets exchanged, or a whole one.
fn text(block: &str, model: &str) -> String {
    let mut text = model.to_string();
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
fn found(block: &str, model: &str) -> String {
    let is_input = |line: &&str| {
        ["model:", "replace:", "with:"]
            .iter()
            .any(|word| line.starts_with(word))
    };
    let mut lines: Vec<String> = block.lines().filter(is_input).map(ToString::to_string).collect();
    for mistake in run(&text(block, model)).1 {
        let underlined = mistake.area.source_text().unwrap_or_default();
        let underlined = underlined.split_whitespace().collect::<Vec<_>>().join(" ");
        lines.push(format!("  {underlined}"));
        lines.push(format!("    {}", mistake.message));
    }
    lines.join("\n")
}

#[test]
fn wrong_models_say_what_would_be_right() {
    check(include_str!("wrong.txt"), "wrong.txt", SPIN_UP);
}

#[test]
fn first_attempts_say_what_would_be_right() {
    check(include_str!("first.txt"), "first.txt", FIRST);
}

#[test]
fn wrong_free_frames_say_what_would_be_right() {
    check(include_str!("free.txt"), "free.txt", FREE);
}

#[test]
fn wrong_joints_say_what_would_be_right() {
    check(include_str!("joints.txt"), "joints.txt", JOINTS);
}

#[test]
fn wrong_sections_say_what_would_be_right() {
    check(include_str!("sections.txt"), "sections.txt", SECTIONS);
}

#[test]
fn wrong_loops_say_what_would_be_right() {
    check(include_str!("repeat.txt"), "repeat.txt", SAIL);
}

#[test]
fn wrong_parts_say_what_would_be_right() {
    check(include_str!("parts.txt"), "parts.txt", ROTOR);
}

#[test]
fn texts_that_mean_nothing_are_refused() {
    check(include_str!("meaning.txt"), "meaning.txt", MEANING);
    check(include_str!("space.txt"), "space.txt", SPACE);
}

#[test]
fn wrong_tables_and_sections_along_an_axis_say_what_would_be_right() {
    check(include_str!("along.txt"), "along.txt", ALONG);
}

#[test]
fn wrong_elements_say_what_would_be_right() {
    check(include_str!("elements.txt"), "elements.txt", ELEMENTS);
}

fn check(list: &str, name: &str, model: &str) {
    let mut blocks = list.trim_end().split("\n\n");
    let head = blocks.next().expect("a heading");
    let blocks: Vec<&str> = blocks.collect();
    assert!(!blocks.is_empty());
    let found: Vec<String> = blocks.iter().map(|block| found(block, model)).collect();
    if std::env::var_os("BLESS").is_some() {
        let path = format!("{}/src/check/tests/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::write(path, format!("{head}\n\n{}\n", found.join("\n\n"))).expect("the list can be written");
    }
    for (block, found) in blocks.iter().zip(&found) {
        assert!(found.contains("\n    "), "no mistake found in\n{block}");
        assert_eq!(block, found);
    }
}
