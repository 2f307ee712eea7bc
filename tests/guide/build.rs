//! Takes the models out of the guide's pages, so that what is tested is what stands there.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "../../rncf-macros/codegen/tests/texts/snippets.rs"]
mod snippets;

use snippets::{blocks, completed, models};

/// Pages with a model of their own.
const PAGES: [&str; 11] = [
    "first_rope",
    "frames",
    "joints",
    "beams",
    "blades",
    "own_element",
    "imported",
    "equilibria",
    "rotors",
    "sail",
    "trust",
];

/// Changes of a page's model that are computed with: page, which of its `rncf` blocks, name.
const CHANGES: [(&str, usize, &str); 6] = [
    ("frames", 1, "flight"),
    ("joints", 0, "flexible"),
    ("beams", 2, "coil"),
    ("blades", 2, "filed"),
    ("equilibria", 0, "leaning"),
    ("imported", 0, "craft"),
];

fn main() {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    let guide = here.join("../../docs/guide");
    println!("cargo:rerun-if-changed=build.rs");
    for page in PAGES {
        let path = guide.join(page).with_extension("md");
        println!("cargo:rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let model = models(&text).remove(0);
        write(&out, page, &model.to_string());
        for (_, number, name) in CHANGES.iter().filter(|change| change.0 == page) {
            let changed = completed(&model, &blocks(&text, "rncf")[*number]);
            write(&out, name, &format!("/// Example.\npub {changed}"));
        }
    }
    // The page on Python has the model of the template.
    let template = here.join("../../examples/template/src/lib.rs");
    println!("cargo:rerun-if-changed={}", template.display());
    let text = fs::read_to_string(&template).unwrap_or_else(|error| panic!("{}: {error}", template.display()));
    write(&out, "python", &models(&format!("```rust\n{text}\n```"))[0].to_string());
}

/// A file with a model.
fn write(folder: &Path, name: &str, model: &str) {
    let path = folder.join(name).with_extension("rs");
    fs::write(&path, format!("rncf::model! {{ {model} }}\n")).unwrap_or_else(|error| panic!("{name}: {error}"));
}
