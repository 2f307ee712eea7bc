//! The long study of random scenes: writes a crate with the texts of many seeds, builds it, and runs each with many draws
//! of numbers in all ways.
//!
//! `cargo bench -p rncf-tests --bench scenes -- FIRST LAST DRAWS` takes the seeds FIRST to LAST - 1 (default 0 60 10).

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

// The crate of the study uses the rest.
#[allow(dead_code)]
mod random_scenes;

use random_scenes::texts::texts;

fn main() -> ExitCode {
    let numbers: Vec<u64> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let at = |index: usize, default| numbers.get(index).copied().unwrap_or(default);
    match study(at(0, 0)..at(1, 60), at(2, 10)) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn study(seeds: std::ops::Range<u64>, draws: u64) -> Result<ExitCode, String> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = tests.parent().ok_or("no workspace above the tests")?;
    let folder = root.join("target/scenes");
    fs::create_dir_all(folder.join("src")).map_err(|error| format!("{}: {error}", folder.display()))?;
    let write = |name: &str, text: String| {
        let path = folder.join(name);
        // What is unchanged is not compiled again.
        if fs::read_to_string(&path).ok().as_ref() == Some(&text) {
            return Ok(());
        }
        fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
    };
    let (mut modules, mut table) = (String::new(), String::new());
    for seed in seeds {
        write(&format!("src/s{seed}.rs"), texts(seed))?;
        modules += &format!("pub mod s{seed};\n");
        table += &format!(
            "    Entry {{ seed: {seed}, original: (maker::<s{seed}::A>, columns::<s{seed}::A>), copy: (maker::<s{seed}::B>, columns::<s{seed}::B>) }},\n"
        );
    }
    write("src/lib.rs", format!("#![allow(deprecated)]\n{modules}"))?;
    let library = tests.join("benches/scenes/random_scenes/mod.rs");
    write(
        "src/main.rs",
        format!(
            "#[allow(dead_code)]\n#[path = {library:?}]\nmod random_scenes;\nuse random_scenes::run::{{columns, maker}};\nuse random_scenes::study::{{Entry, study}};\nuse study_of_scenes::*;\n\nconst TABLE: &[Entry] = &[\n{table}];\n\nfn main() {{\n    study(TABLE, 0..{draws});\n}}\n"
        ),
    )?;
    write(
        "Cargo.toml",
        format!(
            "[package]\nname = \"study_of_scenes\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nrncf = {{ path = {root:?} }}\n\n[profile.release]\nopt-level = 1\n[profile.release.package.rncf-runtime]\nopt-level = 3\n"
        ),
    )?;
    let status = Command::new(env!("CARGO"))
        .args(["run", "--release", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .status()
        .map_err(|error| format!("cargo: {error}"))?;
    Ok(if status.success() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
