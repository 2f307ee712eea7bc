//! Every model of this repository is free of warnings: what it declares has an influence.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use rncf_codegen::elements::Library;
use rncf_codegen::expand;

/// Rust files below a folder; wrong models are meant to be wrong, and random ones declare what they do not use.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            if !["compile_fail", "target", "sampled_scenes"].contains(&name.as_str()) {
                sources(&path, found);
            }
        } else if name.ends_with(".rs") {
            found.push(path);
        }
    }
}

/// The tokens in every `model! { .. }`, wherever it stands.
fn models(tokens: TokenStream, found: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let is_macro = matches!(
            &tokens[at.saturating_sub(2)..at],
            [TokenTree::Ident(word), TokenTree::Punct(mark)] if word == "model" && mark.as_char() == '!'
        );
        if is_macro {
            found.push(group.stream());
        } else {
            models(group.stream(), found);
        }
    }
}

#[test]
fn models_of_this_repository_have_no_warnings() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = Vec::new();
    for folder in ["models", "examples", "tests", "src"] {
        sources(&root.join(folder), &mut paths);
    }
    paths.sort();
    let (mut count, mut warnings) = (0, Vec::new());
    for path in paths {
        let text = fs::read_to_string(&path).expect("a source can be read");
        let mut found = Vec::new();
        models(text.parse().expect("a source consists of tokens"), &mut found);
        count += found.len();
        for tokens in found {
            for warning in expand::warnings(tokens, &Library::standard()) {
                let (line, message) = (warning.area.line(), warning.message);
                warnings.push(format!("{}:{line}: {message}", path.display()));
            }
        }
    }
    assert!(count > 40, "{count} models");
    assert!(
        warnings.is_empty(),
        "{} warnings:\n{}",
        warnings.len(),
        warnings.join("\n")
    );
}
