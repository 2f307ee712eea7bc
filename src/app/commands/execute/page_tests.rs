//! The page of messages of programs is true: every wrong line gets its message, every cured one runs.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::app::commands::execute::execute;
use crate::app::line::arguments::{Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::MISTAKE;
use crate::app::testing::{Rotor, temporary_folder};

const PAGE: &str = "docs/errors/command_line.md";
const SCENARIOS: &str = "docs/errors/scenario_files.md";

/// The fenced blocks of a tag.
fn blocks(text: &str, tag: &str) -> Vec<String> {
    let fence = format!("```{tag}\n");
    let parts = text.split(&fence).skip(1);
    parts
        .map(|part| part.split("\n```").next().unwrap_or_default().to_owned())
        .collect()
}

/// The words of a line as a shell splits it, with double quotes alone.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut is_quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            ' ' if !is_quoted => words.push(String::new()),
            _ => words.last_mut().unwrap().push(letter),
        }
    }
    words
}

/// What the program says of a mistake; nothing where it does its work.
fn told(line: &str, out: &Path) -> Option<String> {
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: PathBuf::from(out),
    };
    let arguments = match parse(&Rotor::default(), &program, words(line).into_iter().map(OsString::from)) {
        Ok(arguments) => arguments,
        Err(Refusal::Help(text) | Refusal::Mistake(text)) => return Some(text),
    };
    let failure = execute(&arguments, || false).err()?;
    assert_eq!(failure.code, MISTAKE, "{line}: {}", failure.message);
    Some(failure.message)
}

/// What differs from the page: the wrong ones get their message, the cured ones none.
fn differences(page: &str, tag: &str, told: impl Fn(&str) -> Option<String>) -> Vec<String> {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap();
    let (wrong, cured) = (blocks(&text, tag), blocks(&text, &format!("cured-{tag}")));
    assert!(wrong.len() == cured.len() && wrong.len() > 10);
    let mut differences = Vec::new();
    for (wrong, cured) in wrong.iter().zip(&cured) {
        let (words, message) = wrong.split_once("\n//~ ").expect("words and their message");
        let found = told(words);
        if found.as_deref() != Some(message) {
            differences.push(format!("{words}\n//~ {}", found.unwrap_or_default()));
        }
        if let Some(found) = told(cured) {
            differences.push(format!("cured: {cured}\n{found}"));
        }
    }
    differences
}

#[test]
fn every_line_gets_its_message_and_its_cure_runs() {
    let out = temporary_folder("page");
    let found = differences(PAGE, "line", |line| told(line, &out));
    let _ = fs::remove_dir_all(&out);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_scenario_gets_its_message_and_its_cure_runs() {
    let out = temporary_folder("page-scenarios");
    fs::create_dir_all(&out).unwrap();
    let file = out.join("run.toml");
    let found = differences(SCENARIOS, "scenario", |text| {
        fs::write(&file, text).unwrap();
        let line = format!("--scenario {} --quiet", file.display());
        told(&line, &out).map(|text| text.replace(&format!("{}/", out.display()), ""))
    });
    let _ = fs::remove_dir_all(&out);
    assert!(found.is_empty(), "{}", found.join("\n"));
}
