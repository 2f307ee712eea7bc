//! The checked-in expansion of a folder of models.

use std::fs;
use std::path::Path;

use crate::elements::Library;
use crate::expand;

/// The command that refreshes `generated/`.
pub const COMMAND: &str = "cargo run -p rncf-codegen --bin rncf-generate";

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
        let file = syn::parse_file(&text).map_err(|error| format!("{}: {error}", path.display()))?;
        let mut expansion = String::new();
        for item in file.items {
            let syn::Item::Macro(item) = item else { continue };
            if item
                .mac
                .path
                .segments
                .last()
                .is_some_and(|segment| segment.ident == "model")
            {
                let text = expand::text_beside(item.mac.tokens, &Library::standard(), models.parent()).map_err(
                    |mistakes| {
                        let messages: Vec<String> = mistakes.iter().map(|mistake| mistake.message.clone()).collect();
                        format!("{}: {}", path.display(), messages.join("; "))
                    },
                )?;
                expansion += &text;
            }
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
