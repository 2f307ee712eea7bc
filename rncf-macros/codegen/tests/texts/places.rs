//! What the documents point to is there: links with their headings, and files and folders in backticks.

use std::path::{Path, PathBuf};

use crate::documents::{Page, anchors, links, page, pages, prose, root};

/// All documents of the repository.
fn all() -> Vec<Page> {
    [".", "docs", "docs/language", "docs/guide"]
        .into_iter()
        .flat_map(pages)
        .collect()
}

#[test]
fn every_link_leads_somewhere() {
    let mut broken = Vec::new();
    for from in all() {
        let folder = Path::new(&from.path).parent().unwrap().to_owned();
        for target in links(&from.text) {
            if target.starts_with("http") {
                continue;
            }
            let (path, anchor) = target
                .split_once('#')
                .map_or((target.as_str(), None), |(p, a)| (p, Some(a)));
            let to = if path.is_empty() {
                PathBuf::from(&from.path)
            } else {
                folder.join(path)
            };
            let is_there = root().join(&to).exists();
            let has_heading = || {
                let Some(anchor) = anchor else { return true };
                anchors(&page(to.to_str().unwrap()).text)
                    .iter()
                    .any(|name| name == anchor)
            };
            if !is_there || !has_heading() {
                broken.push(format!("{}: {target}", from.path));
            }
        }
    }
    assert!(broken.is_empty(), "links that lead nowhere:\n{}", broken.join("\n"));
}

#[test]
fn the_summary_lists_every_page_once() {
    let mut listed = links(&page("docs/SUMMARY.md").text);
    listed.retain(|target| target != "../README.md");
    listed.sort();
    let folders = [
        ("docs", ""),
        ("docs/guide", "guide/"),
        ("docs/language", "language/"),
        ("docs/errors", "errors/"),
    ];
    let all = folders.iter().flat_map(|(folder, before)| {
        let names = pages(folder)
            .into_iter()
            .map(|page| page.path[folder.len() + 1..].to_owned());
        names.map(move |name| format!("{before}{name}"))
    });
    let mut all: Vec<String> = all.filter(|name| name != "SUMMARY.md").collect();
    all.sort();
    assert_eq!(listed, all);
}

/// All files and folders that are not made by a build, from the root of the repository.
fn files() -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(root().join(&folder)).unwrap() {
            let entry = entry.unwrap();
            let path = folder.join(entry.file_name());
            files.push(path.to_str().expect("names are UTF-8").to_owned());
            let is_made = ["target", "out", ".git"].iter().any(|made| entry.file_name() == *made);
            if entry.file_type().unwrap().is_dir() && !is_made {
                folders.push(path);
            }
        }
    }
    files
}

/// `a/{b,c}.rs` is `a/b.rs` and `a/c.rs`.
fn unfolded(span: &str) -> Vec<String> {
    let Some((before, rest)) = span.split_once('{') else {
        return vec![span.to_owned()];
    };
    let Some((choices, after)) = rest.split_once('}') else {
        return vec![span.to_owned()];
    };
    choices
        .split(',')
        .map(|choice| format!("{before}{choice}{after}"))
        .collect()
}

/// Whether what stands in backticks is meant as a file or folder of the repository.
fn is_place(span: &str, files: &[String]) -> bool {
    let is_name = |c: char| c.is_ascii_alphanumeric() || "_-./{},".contains(c);
    let is_made = span.starts_with("out/") || span.starts_with("target");
    let extension = span.rsplit_once('.').map(|(_, extension)| extension);
    let first = span.split('/').next().unwrap_or_default();
    span.chars().all(is_name)
        && !is_made
        && (matches!(extension, Some("rs" | "md" | "svg" | "sh" | "py" | "rncf"))
            || span.ends_with('/')
            || span.contains('/') && files.iter().any(|file| file == first))
}

#[test]
fn every_file_that_is_named_exists() {
    let files = files();
    let mut wrong = Vec::new();
    for path in [
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "README.md",
        "docs/inside.md",
        "docs/stability.md",
    ] {
        let text = prose(&page(path).text);
        for span in text.split('`').skip(1).step_by(2) {
            if !is_place(span, &files) {
                continue;
            }
            for place in unfolded(span) {
                let place = place.trim_end_matches('/');
                let tail = format!("/{place}");
                if !files.iter().any(|file| file == place || file.ends_with(&tail)) {
                    wrong.push(format!("{path}: {place}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "files that do not exist:\n{}", wrong.join("\n"));
}

/// ARCHITECTURE.md says so.
#[test]
fn every_scene_is_compared_with_differences() {
    let read = |path: &str| std::fs::read_to_string(root().join(path)).unwrap();
    let compared = read("tests/kernels/scenes.rs");
    let exported = read("models/src/lib.rs");
    // `pub use spin_up::{SpinUp, spin_up_equations};`
    let names: Vec<&str> = exported
        .lines()
        .filter_map(|line| line.strip_prefix("pub use ")?.split_once("::{")?.1.split_once(','))
        .map(|(name, _)| name)
        .collect();
    assert!(names.len() > 20, "{names:?}");
    let words: Vec<&str> = compared.split(|c: char| !c.is_alphanumeric()).collect();
    let missing: Vec<&&str> = names.iter().filter(|name| !words.contains(*name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
