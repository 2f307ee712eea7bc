//! The long study of random scenes: writes a crate with the texts of many seeds, builds it, and runs each with many draws
//! of numbers in all ways.
//!
//! `cargo bench -p rncf-tests --bench scenes -- FIRST LAST DRAWS` takes the seeds FIRST to LAST - 1 (default 0 60 10). With no draws it
//! tells what the scenes consist of, and which texts are refused.

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

// The crate of the study uses the rest.
#[allow(dead_code)]
#[path = "../../accuracy/random_scenes/mod.rs"]
mod random_scenes;

use random_scenes::grow::grow;
use random_scenes::study::told;
use random_scenes::texts::{models, texts};
use rncf_codegen::elements::Library;
use rncf_codegen::expand;

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
    let standard = Library::standard();
    for seed in seeds {
        if let Some(why) = models(seed).iter().find_map(|model| refusal(model, &standard)) {
            println!("{seed}: the text is refused: {why}");
            continue;
        }
        if draws == 0 {
            println!("{seed}: {}", told(&grow(seed, 0)));
            continue;
        }
        write(&format!("src/s{seed}.rs"), texts(seed, true))?;
        modules += &format!("pub mod s{seed};\n");
        table += &format!(
            "    Entry {{ seed: {seed}, original: (maker::<s{seed}::A>, columns::<s{seed}::A>), copy: Some((maker::<s{seed}::B>, columns::<s{seed}::B>)) }},\n"
        );
    }
    if draws == 0 {
        return Ok(ExitCode::SUCCESS);
    }
    write("src/lib.rs", format!("#![allow(deprecated)]\n{modules}"))?;
    let library = tests.join("accuracy/random_scenes/mod.rs");
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

/// Why the generator refuses a model, if it does.
fn refusal(model: &str, library: &Library) -> Option<String> {
    let tokens = match model.parse() {
        Ok(tokens) => tokens,
        Err(error) => return Some(format!("{error}")),
    };
    let mistakes = expand::text(tokens, library).err()?;
    Some(
        mistakes
            .first()
            .map_or(String::new(), |mistake| mistake.message.clone()),
    )
}
