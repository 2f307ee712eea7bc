//! `generated/` is what the generator writes today, and it writes the same bytes twice.

use std::path::Path;

use rncf_codegen::generate::{COMMAND, generate};

#[test]
fn the_checked_in_expansion_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let files = generate(&root.join("models/src")).unwrap();
    assert_eq!(files, generate(&root.join("models/src")).unwrap(), "two runs differ");
    for (name, text) in &files {
        let checked_in = std::fs::read_to_string(root.join("generated/src").join(name)).unwrap_or_default();
        assert!(
            checked_in == *text,
            "generated/src/{name} is out of date: refresh it by\n    {COMMAND}"
        );
    }
    let count = std::fs::read_dir(root.join("generated/src")).unwrap().count();
    assert_eq!(
        count,
        files.len(),
        "generated/src holds files of models that are gone: delete them"
    );
}
