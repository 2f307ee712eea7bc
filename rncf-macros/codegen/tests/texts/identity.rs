//! A model tells by a hash what it was built from: results of another one must not be taken for its own.

use std::path::{Path, PathBuf};

use rncf_codegen::elements::Library;
use rncf_codegen::expand;

/// The line with the hash, of a model beside these files.
fn hash_beside(folder: &Path, text: &str) -> String {
    let tokens = text.parse().expect("tokens");
    let written = expand::text_beside(tokens, &Library::standard(), Some(folder)).expect("a model without mistakes");
    let line = written.lines().find(|line| line.contains("const EQUATIONS_HASH: u64"));
    line.expect("every model has one").to_string()
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("rncf-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

const BODY: &str = "rigid b { plane xy; mass = 2 kg; inertia = 1 kg*m^2; } joint g = prismatic(inertial, b, axis = x); output v = b.velocity.x;";

#[test]
fn rows_of_a_table_are_part_of_a_model() {
    let folder = folder("rows");
    let text = format!(
        r#"pub model Pushed {{ {BODY} table rows = file("push.csv", at = time, interpolation = linear); load f = force(b, [rows.push(t), 0 N, 0]); }}"#
    );
    let hash = |last: f64| {
        std::fs::write(folder.join("push.csv"), format!("time[s],push[N]\n0,0\n1,{last}\n")).expect("a table");
        hash_beside(&folder, &text)
    };
    let first = hash(6.0);
    assert_ne!(first, hash(60.0));
    assert_eq!(first, hash(6.0));
    std::fs::remove_dir_all(folder).expect("the folder");
}

#[test]
fn libraries_are_part_of_a_model() {
    let hash = |extra: &str| {
        let library = format!(
            "library shelf {{ const extra = {extra}; component Push(body: frame, f: N) {{ load p = force(body, [f * extra / (1 N), 0 N, 0]); }} }}"
        );
        hash_beside(
            Path::new(""),
            &format!("{library} pub model Pushed {{ {BODY} part more = Push(body = b, f = 2 N); }}"),
        )
    };
    assert_ne!(hash("1 N"), hash("10 N"));
    assert_eq!(hash("1 N"), hash("1 N"));
}

#[test]
fn imported_files_are_part_of_a_model() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/reference/data");
    let folder = folder("imported");
    let text = r#"pub model Held { body arm { import "arm.npz"; interface root = node 10; modal(4); } joint root = clamp(arm.root, inertial); output mass = total.mass; }"#;
    let hash = |from: &str| {
        std::fs::copy(data.join(from), folder.join("arm.npz")).expect("a file");
        hash_beside(&folder, text)
    };
    let first = hash("beam.npz");
    assert_ne!(first, hash("beam_mm.npz"));
    assert_eq!(first, hash("beam.npz"));
    std::fs::remove_dir_all(folder).expect("the folder");
}

/// Nothing asks a file for what nothing reads.
#[test]
fn notes_of_a_table_are_no_columns_of_it() {
    let folder = folder("notes");
    std::fs::write(folder.join("road.csv"), "time[s],lift[m],_note[-]\n0,0,7\n1,2,8\n").expect("a table");
    let text = format!(
        r#"pub model Driven {{ {BODY} param road: table = file("road.csv", at = time, interpolation = linear); load f = force(b, [road.lift(t) * 1 [N/m], 0 N, 0]); }}"#
    );
    let tokens = text.parse().expect("tokens");
    let written = expand::text_beside(tokens, &Library::standard(), Some(&folder)).expect("a model without mistakes");
    assert!(written.contains("\"lift\"") && !written.contains("_note"));
    std::fs::remove_dir_all(folder).expect("the folder");
}
