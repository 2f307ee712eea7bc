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

/// Of two frames without a point the origin of the first is the place of a joint; where the other one is elsewhere, it may have been meant.
#[test]
fn an_axis_at_either_of_two_origins_is_told() {
    let told = |joint: &str| -> Vec<String> {
        let text = format!(
            "model Gear {{ rigid wheel {{ plane xy; mass = 1 kg; inertia = 1 kg*m^2; origin = [1, 0, 0] m; }} joint bearing = {joint}; output a = bearing.angle; }}"
        );
        let tokens = text.parse().expect("tokens");
        let warnings = expand::warnings(tokens, &Library::standard());
        warnings.into_iter().map(|warning| warning.message).collect()
    };
    let warnings = told("revolute(inertial, wheel)");
    assert!(
        warnings.len() == 1 && warnings[0].contains("the origin of `inertial`, and that of `wheel` is 1 m away"),
        "{warnings:?}"
    );
    for clear in [
        "revolute(inertial.at([0, 0, 0] m), wheel)",
        "revolute(inertial, wheel.at([0, 0, 0] m))",
    ] {
        assert_eq!(told(clear), Vec::<String>::new());
    }
}
