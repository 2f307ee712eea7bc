//! All phases in order: what `model!` does with its tokens.

use std::collections::HashMap;
use std::path::Path;

use proc_macro2::{Group, Span, TokenStream, TokenTree};

use crate::check::Spans;
use crate::check::influence::influence;
use crate::elements::Library;
use crate::errors::{Errors, Mistake};
use crate::model::Model;
use crate::parse::tree::Tree;
use crate::{check, editor, emit, lower, parse, stub, unfold};

/// Expands a declaration with the standard elements. Mistakes become `compile_error!`s where they
/// were made, beside a stand-in for the struct that keeps the rest of the crate free of them. What has no influence
/// becomes a warning.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::new();
    if let Some(call) = parse::library::used(&tokens, &mut errors) {
        let mut tokens = errors.into_tokens();
        tokens.extend(call);
        return tokens;
    }
    let written = tokens.clone();
    let tree = read(tokens, None, &mut errors);
    let model = tree
        .as_ref()
        .and_then(|tree| check::check_with_elements(tree, &Library::standard(), &mut errors));
    match (tree, model) {
        (Some(tree), Some((model, library))) if errors.is_empty() => {
            let _ = errors.finish();
            let warnings = influence(&tree, &model, &library);
            let text = written_out(&model, &library) + &dependences(&model);
            if emit::is_ambiguous(&model, &text) {
                let mut errors = Errors::new();
                errors.at(tree.name.span, name_taken(&model.name));
                return errors.into_tokens();
            }
            match text.parse::<TokenStream>() {
                Ok(tokens) => {
                    let mut items = editor::items(written, &tree);
                    items.extend(respan(tokens, &names(&tree)));
                    items.extend(warnings.iter().map(Mistake::to_warning));
                    items
                }
                Err(error) => {
                    let mut errors = Errors::new();
                    errors.at(
                        Span::call_site(),
                        format!("the generator wrote text that is no Rust ({error}): a defect of rncf"),
                    );
                    errors.into_tokens()
                }
            }
        }
        (Some(tree), _) => {
            let mut items = editor::items(written, &tree);
            items.extend(errors.into_tokens_beside(tree.name.span));
            items.extend(stub::stub(&tree));
            items
        }
        (None, _) => errors.into_tokens(),
    }
}

/// The syntax tree, with a folder for files of tables instead of that of the crate that is built.
fn read(tokens: TokenStream, folder: Option<&Path>, errors: &mut Errors) -> Option<Tree> {
    let mut tree = parse::parse(tokens, errors)?;
    if let Some(folder) = folder {
        tree.folder = folder.into();
    }
    Some(unfold::unfold(tree, errors))
}

/// Expands a library into a macro that hands its items to models.
pub fn library(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::new();
    let library = parse::library::library(tokens, &mut errors);
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    match library {
        Ok(library) => {
            let mut tokens = errors.into_tokens();
            tokens.extend(parse::library::macro_of(&library, Path::new(&folder)));
            tokens
        }
        Err(mistake) => {
            errors.push(mistake);
            errors.into_tokens()
        }
    }
}

/// The last two phases: a model that was checked as text.
pub fn written_out(model: &Model, library: &Library) -> String {
    emit::model(model, library, lower::lower(model, library))
}

fn name_taken(name: &str) -> String {
    format!("`{name}` is the name of something that is written for this model: choose another name")
}

/// Statements that let cargo expand the model anew when the file of a table changes.
fn dependences(model: &Model) -> String {
    let files = model.tables.iter().filter_map(|table| table.file.as_ref());
    let statement = |file: &String| format!("const _: &[u8] = {};\n", emit::included(file));
    files.map(statement).collect()
}

/// The expansion as formatted Rust text, with the given elements.
///
/// # Errors
/// All mistakes of the declaration.
pub fn text(tokens: TokenStream, library: &Library) -> Result<String, Vec<Mistake>> {
    text_beside(tokens, library, None)
}

/// As [`text`], with files of tables in a folder instead of that of the crate that is built.
///
/// # Errors
/// All mistakes of the declaration.
pub fn text_beside(tokens: TokenStream, library: &Library, folder: Option<&Path>) -> Result<String, Vec<Mistake>> {
    let mut errors = Errors::new();
    let tree = read(tokens, folder, &mut errors);
    let model = tree
        .as_ref()
        .and_then(|tree| check::check_with_elements(tree, library, &mut errors));
    let mistakes = errors.finish();
    match model {
        Some((model, library)) if mistakes.is_empty() => Ok(format(&written_out(&model, &library))),
        _ => Err(mistakes),
    }
}

/// Warnings about a declaration without mistakes, which the text of [`text`] does not contain; none where there are
/// mistakes.
pub fn warnings(tokens: TokenStream, library: &Library) -> Vec<Mistake> {
    let mut errors = Errors::new();
    let tree = read(tokens, None, &mut errors);
    let model = tree
        .as_ref()
        .and_then(|tree| check::check_with_elements(tree, library, &mut errors));
    let is_right = errors.finish().is_empty();
    match (tree, model) {
        (Some(tree), Some((model, library))) if is_right => influence(&tree, &model, &library),
        _ => Vec::new(),
    }
}

/// Formats Rust text; stable, since the same text always gives the same tokens.
///
/// # Panics
/// If the text is no Rust: a defect of the generator.
pub fn format(text: &str) -> String {
    let file =
        syn::parse_file(text).unwrap_or_else(|error| panic!("the generator wrote text that is no Rust: {error}"));
    prettyplease::unparse(&file)
}

fn names(tree: &Tree) -> HashMap<String, Span> {
    let spans = Spans::of(tree);
    let mut names = HashMap::from([(tree.name.text.clone(), spans.name)]);
    let params = tree.params();
    names.extend(
        params
            .zip(spans.params)
            .map(|(item, span)| (item.name.text.clone(), span)),
    );
    names
}

/// Identifiers that the user wrote point to where they were written.
fn respan(tokens: TokenStream, names: &HashMap<String, Span>) -> TokenStream {
    let token = |token: TokenTree| match token {
        TokenTree::Ident(mut ident) => {
            if let Some(&span) = names.get(&ident.to_string()) {
                ident.set_span(span.resolved_at(Span::call_site()));
            }
            TokenTree::Ident(ident)
        }
        TokenTree::Group(group) => {
            let mut inner = Group::new(group.delimiter(), respan(group.stream(), names));
            inner.set_span(group.span());
            TokenTree::Group(inner)
        }
        other => other,
    };
    tokens.into_iter().map(token).collect()
}

#[cfg(test)]
mod tests {
    /// rustc would say what is wrong, and not where.
    #[test]
    fn names_that_mean_something_in_the_expansion_are_refused() {
        let refusal = |text: String| {
            let tokens = super::expand(text.parse().expect("tokens")).to_string();
            assert!(tokens.contains("choose another name"), "{text}: {tokens}");
        };
        for name in ["Equations", "Default", "bool", "f64", "rncf", "str", "usize"] {
            refusal(format!(
                "pub model {name} {{ rigid p {{ mass = 1 kg; }} output x = p.x; }}"
            ));
        }
        for name in ["Some", "Ok", "Err"] {
            refusal(format!(
                "pub model Fall {{ motion {name}(t) = 2 m/s * t; rigid p {{ mass = 1 kg; }} output x = p.x; output y = {name}(t); }}"
            ));
        }
    }
}
