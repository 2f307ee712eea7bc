//! Seconds that each model of some files takes to expand, phase by phase; without arguments those of `models/`.
//!
//! `cargo run -p rncf-codegen --example expansion_time -- tests/kernels/models.rs`

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use rncf_codegen::check::check_with_elements;
use rncf_codegen::elements::Library;
use rncf_codegen::errors::Errors;
use rncf_codegen::{emit, expand, lower, parse, unfold};

fn main() -> Result<(), Box<dyn Error>> {
    let mut files: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if files.is_empty() {
        files = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/src"))?
            .map(|entry| entry.map(|entry| entry.path()))
            .collect::<Result<_, _>>()?;
        files.sort();
    }
    println!("model                 check   derive   format    total  [s]   lines");
    for path in files {
        // Files of tables stand beside the manifest of the crate that has the model.
        let folder = path.ancestors().find(|folder| folder.join("Cargo.toml").exists());
        let folder = folder.unwrap_or(Path::new("")).to_path_buf();
        for item in syn::parse_file(&fs::read_to_string(&path)?)?.items {
            if let syn::Item::Macro(item) = item {
                time(item.mac.tokens, &folder).map_err(|message| format!("{}: {message}", path.display()))?;
            }
        }
    }
    Ok(())
}

/// Expands one declaration and prints a line.
fn time(tokens: proc_macro2::TokenStream, folder: &Path) -> Result<(), String> {
    let (library, start) = (Library::standard(), Instant::now());
    let mut errors = Errors::new();
    let model = parse::parse(tokens, &mut errors).and_then(|mut tree| {
        tree.folder = folder.into();
        check_with_elements(&unfold::unfold(tree, &mut errors), &library, &mut errors)
    });
    let mistakes = errors.finish();
    let Some((model, library)) = model.filter(|_| mistakes.is_empty()) else {
        return Err(mistakes
            .first()
            .map_or("no model".into(), |mistake| mistake.message.clone()));
    };
    let checked = start.elapsed().as_secs_f64();
    let text = emit::model(&model, &library, lower::lower(&model, &library));
    let derived = start.elapsed().as_secs_f64();
    let lines = expand::format(&text).lines().count();
    let total = start.elapsed().as_secs_f64();
    let (derive, format) = (derived - checked, total - derived);
    println!(
        "{:<20} {checked:>6.4}   {derive:>6.4}   {format:>6.4}   {total:>6.4}        {lines:>5}",
        model.name
    );
    Ok(())
}
