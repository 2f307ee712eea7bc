//! Pages of the documents: their fenced blocks, sections, links and the index of words.

use std::fs;
use std::path::{Path, PathBuf};

/// One file of markdown.
pub struct Page {
    /// Place from the root of the repository.
    pub path: String,
    pub text: String,
}

/// The folder of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub fn page(path: &str) -> Page {
    let text = fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
    Page {
        path: path.to_owned(),
        text,
    }
}

/// All pages of a folder, without those of its folders, in the order of their names.
pub fn pages(folder: &str) -> Vec<Page> {
    let files = fs::read_dir(root().join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
    let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".md")).collect();
    names.sort();
    names.iter().map(|name| page(&format!("{folder}/{name}"))).collect()
}

/// The index and the pages of the language.
pub fn language() -> Vec<Page> {
    let mut language = vec![page("docs/language.md")];
    language.extend(pages("docs/language"));
    language
}

/// All that is outside of fenced blocks.
pub fn prose(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// Targets of the links outside of fenced blocks and of code in backticks.
pub fn links(text: &str) -> Vec<String> {
    let prose = prose(text);
    let parts = prose.split("](").skip(1);
    parts
        .filter_map(|part| part.split_once(')').map(|(target, _)| target.to_owned()))
        .collect()
}

/// The depth of a heading and its name in links, as GitHub and mdBook make it.
fn heading(line: &str) -> Option<(usize, String)> {
    let title = line.trim_start_matches('#');
    let depth = line.len() - title.len();
    let title = title.strip_prefix(' ').filter(|_| depth > 0)?;
    let kept = title
        .trim()
        .chars()
        .filter(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | ' '));
    Some((depth, kept.collect::<String>().to_lowercase().replace(' ', "-")))
}

/// The lines of a page outside and inside of fenced blocks: whether one is a heading, and the line.
fn headed(text: &str) -> impl Iterator<Item = (Option<(usize, String)>, &str)> {
    let mut fenced = false;
    text.lines().map(move |line| {
        fenced ^= line.trim_start().starts_with("```");
        (heading(line).filter(|_| !fenced), line)
    })
}

/// Names of the headings of a page.
pub fn anchors(text: &str) -> Vec<String> {
    headed(text).filter_map(|(heading, _)| Some(heading?.1)).collect()
}

/// The text below a heading, `page.md#heading` seen from a folder, with that of the headings below it.
pub fn section(folder: &str, place: &str) -> String {
    let (path, anchor) = place
        .split_once('#')
        .unwrap_or_else(|| panic!("{place} has no heading"));
    let path = if path.is_empty() { "language.md" } else { path };
    let text = page(&format!("{folder}/{path}")).text;
    let mut depth = None;
    let mut section = String::new();
    for (heading, line) in headed(&text) {
        match (&heading, depth) {
            (Some((found, name)), None) if name == anchor => depth = Some(*found),
            (Some((found, _)), Some(depth)) if *found <= depth => break,
            _ => {}
        }
        if depth.is_some() {
            section += line;
            section.push('\n');
        }
    }
    assert!(depth.is_some(), "{place} does not exist");
    section
}

/// The rows of the table below `## All words`: the word, and the targets of the links beside it.
pub fn index_of_words(text: &str) -> Vec<(String, Vec<String>)> {
    let (_, index) = text.split_once("\n## All words\n").expect("the page has an index");
    let rows = index.lines().take_while(|line| !line.starts_with("## "));
    let rows = rows.filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    rows.map(|(word, places)| (word.to_owned(), links(places))).collect()
}
