//! The checked-in expansion of a folder of models.

use std::fs;
use std::path::Path;

use proc_macro2::TokenStream;

use crate::elements::Library;
use crate::errors::Mistake;
use crate::expand;

/// The command that refreshes `generated/`.
pub const COMMAND: &str = "cargo run -p rncf-codegen --bin rncf-generate";

/// What stands between the parentheses or braces of every `model!` in a text of Rust.
///
/// # Errors
/// The text is no Rust.
pub fn declarations(text: &str) -> syn::Result<Vec<TokenStream>> {
    let is_model = |path: &syn::Path| path.segments.last().is_some_and(|segment| segment.ident == "model");
    let declared = |item| match item {
        syn::Item::Macro(item) if is_model(&item.mac.path) => Some(item.mac.tokens),
        _ => None,
    };
    Ok(syn::parse_file(text)?.items.into_iter().filter_map(declared).collect())
}

/// Expands every model below `models`: file names and contents, in the order of the names.
///
/// # Errors
/// A file that cannot be read, or a model with mistakes, as text.
pub fn generate(models: &Path) -> Result<Vec<(String, String)>, String> {
    let mut files: Vec<_> = fs::read_dir(models)
        .map_err(|error| format!("{}: {error}", models.display()))?
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect();
    files.sort();
    let mut generated = Vec::new();
    let mut modules = String::new();
    for path in files {
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut expansion = String::new();
        for tokens in declarations(&text).map_err(|error| format!("{}: {error}", path.display()))? {
            let told = |mistakes: Vec<Mistake>| {
                let messages: Vec<String> = mistakes.iter().map(|mistake| mistake.message.clone()).collect();
                format!("{}: {}", path.display(), messages.join("; "))
            };
            expansion += &expand::text_beside(tokens, &Library::standard(), models.parent()).map_err(told)?;
        }
        if expansion.is_empty() {
            continue;
        }
        modules += &format!("#[rustfmt::skip]\npub mod {name};\n");
        let head = format!("//! Expansion of `models/src/{name}.rs`; refreshed by `{COMMAND}`.\n\n");
        generated.push((format!("{name}.rs"), head + &expansion));
    }
    let head = "//! The checked-in expansion of the models, to be read: it depends on the runtime alone.\n\n";
    generated.push(("lib.rs".to_string(), head.to_string() + &modules));
    Ok(generated)
}
