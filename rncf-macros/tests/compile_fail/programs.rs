//! The programs through the compiler, and their models through the library.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use rncf_codegen::elements::Library;
use rncf_codegen::errors::{Mistake, WARNING};
use rncf_codegen::expand;

use crate::expected::{Report, reports, without_numbers};

/// The compiler that the `.stderr` files belong to.
const COMPILER: &str = include_str!("rustc-version.txt");

/// The program that is one of each kind, as modules.
const EACH_KIND: &str = "each_kind";

/// All programs with a model of their own, in the order of their paths.
fn programs() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/compile_fail");
    let entries = |folder: &Path| -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).expect("a folder of cases can be read");
        entries.map(|entry| entry.expect("an entry").path()).collect()
    };
    let folders = entries(&root).into_iter().filter(|path| path.is_dir());
    let mut programs: Vec<PathBuf> = folders.flat_map(|folder| entries(&folder)).collect();
    programs.retain(|path| {
        path.extension().is_some_and(|extension| extension == "rs")
            && path.file_stem().is_some_and(|name| name != EACH_KIND)
    });
    programs.sort();
    assert!(programs.len() >= 18, "{} cases", programs.len());
    programs
}

/// The declaration inside `rncf::model! { .. }`, on the lines where it stands.
fn declaration(program: &str) -> String {
    const HEAD: &str = "rncf::model! {";
    let start = program.find(HEAD).expect("a program declares a model") + HEAD.len();
    let mut depth = 1;
    let end = program[start..].find(|letter| {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        depth == 0
    });
    let above = "\n".repeat(program[..start].matches('\n').count());
    above + &program[start..start + end.expect("the braces of the model close")]
}

/// What the library says of a program's model, in the form of the compiler's report.
fn found(program: &str) -> Vec<Report> {
    let text = declaration(program);
    let tokens = text.parse().expect("the declaration consists of tokens");
    let mistakes = match expand::text(tokens, &Library::standard()) {
        Err(mistakes) => mistakes,
        // What is wrong with a program whose model is right are warnings that it denies.
        Ok(_) => warnings(&text),
    };
    assert!(!mistakes.is_empty(), "the model is right:\n{text}");
    let mut reports: Vec<Report> = mistakes
        .into_iter()
        .map(|mistake| Report {
            line: text
                .lines()
                .nth(mistake.area.line() - 1)
                .unwrap_or_default()
                .trim()
                .to_string(),
            underlined: mistake.area.source_text().expect("the text is at hand"),
            message: mistake.message,
        })
        .collect();
    reports.sort();
    reports
}

/// Warnings about a model, in the words of the compiler.
fn warnings(text: &str) -> Vec<Mistake> {
    let tokens = text.parse().expect("the declaration consists of tokens");
    let mut warnings = expand::warnings(tokens, &Library::standard());
    for warning in &mut warnings {
        warning.message = format!("use of deprecated constant `_::{WARNING}`: {}", warning.message);
    }
    warnings
}

/// What the compiler prints of a program.
fn printed(path: &Path) -> Vec<Report> {
    let stderr = fs::read_to_string(path.with_extension("stderr"))
        .unwrap_or_else(|error| panic!("{}: {error}: write it with BLESS=1", path.display()));
    reports(&stderr)
}

#[test]
fn the_library_says_what_the_compiler_prints() {
    for path in programs() {
        let program = fs::read_to_string(&path).expect("a program can be read");
        assert_eq!(printed(&path), found(&program), "{}", path.display());
    }
}

/// What is denied is told by the compiler where nothing else is wrong: such programs are built alone.
const ALONE: [&str; 2] = ["influence", "several"];

fn is_alone(path: &Path) -> bool {
    path.parent()
        .is_some_and(|folder| ALONE.iter().any(|alone| folder.ends_with(alone)))
}

fn each_kind() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/compile_fail/several");
    root.join(EACH_KIND).with_extension("rs")
}

#[test]
fn one_program_of_each_kind_is_built_with_the_others() {
    let mut kinds: Vec<PathBuf> = programs().into_iter().filter(|path| !is_alone(path)).collect();
    kinds.dedup_by_key(|path| path.parent().map(Path::to_path_buf));
    let text = fs::read_to_string(each_kind()).expect("the program can be read");
    let named: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("#[path = \"../"))
        .collect();
    let mut all: Vec<Report> = kinds.iter().flat_map(|path| printed(path)).collect();
    all.sort();
    assert_eq!(printed(&each_kind()), all);
    assert!(
        named.len() == kinds.len()
            && kinds
                .iter()
                .zip(named)
                .all(|(path, name)| path.ends_with(name.trim_end_matches("\"]"))),
        "{kinds:?}"
    );
}

/// Where the library `rncf` lies with which the test was built. It may be there for several sets of features; the newest is of
/// today's sources, for this test was built after them.
fn library() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows its program");
    let folder = test.parent().expect("a program lies in a folder");
    let entries = fs::read_dir(folder).expect("the folder of the libraries can be read");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let libraries = paths.filter(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("librncf-") && name.ends_with(".rlib")
    });
    libraries
        .max_by_key(|path| fs::metadata(path).and_then(|file| file.modified()).ok())
        .expect("the library rncf lies beside the test")
}

/// What the compiler prints of a program now, without numbers of lines and the summary at the end. It only checks.
fn build(compiler: &OsStr, library: &Path, program: &Path) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut external = OsString::from("rncf=");
    external.push(library);
    let mut dependencies = OsString::from("dependency=");
    dependencies.push(library.parent().expect("a library lies in a folder"));
    let output = Command::new(compiler)
        .current_dir(root)
        .args([
            "--edition=2024",
            "--crate-type=bin",
            "--emit=metadata=-",
            "--color=never",
        ])
        .arg("--extern")
        .arg(external)
        .arg("-L")
        .arg(dependencies)
        .arg(program.strip_prefix(root).expect("a program lies in this package"))
        .output()
        .expect("rustc runs");
    assert!(
        !output.status.success(),
        "{} is built without an error",
        program.display()
    );
    without_numbers(&String::from_utf8_lossy(&output.stderr))
}

#[test]
fn the_compiler_prints_it() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(&compiler).arg("--version").output().expect("rustc runs");
    let version = String::from_utf8_lossy(&output.stdout);
    if version.trim() != COMPILER.trim() {
        // Written past the test harness, which shows nothing of a test that passes.
        let text = format!(
            "\nskipped the_compiler_prints_it: the .stderr files belong to {}, this is {}; messages and underlined \
             words are checked through the library\n",
            COMPILER.trim(),
            version.trim()
        );
        std::io::stderr()
            .write_all(text.as_bytes())
            .expect("standard error is open");
        return;
    }
    let bless = std::env::var_os("BLESS").is_some();
    let mut programs = programs();
    // The library has been compared with all reports; that the macro passes its mistakes on shows in one of each kind.
    if !bless && std::env::var_os("ALL").is_none() {
        programs.retain(|path| is_alone(path));
    }
    programs.push(each_kind());
    let library = library();
    for path in programs {
        let (expected, found) = (path.with_extension("stderr"), build(&compiler, &library, &path));
        if bless {
            fs::write(&expected, &found).expect("the report can be written");
        }
        let expected = fs::read_to_string(&expected).expect("a report can be read");
        assert!(
            expected == found,
            "{} is said to print\n{expected}\nand prints\n{found}",
            path.display()
        );
    }
}
