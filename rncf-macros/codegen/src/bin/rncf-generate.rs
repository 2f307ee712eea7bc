//! Refreshes `generated/` from `models/`; run it at the root of the workspace.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    match refresh() {
        Ok(count) => {
            println!("{count} files written to generated/src");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn refresh() -> Result<usize, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let files = rncf_codegen::generate::generate(&root.join("models/src"))?;
    for (name, text) in &files {
        let path = root.join("generated/src").join(name);
        std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(files.len())
}
