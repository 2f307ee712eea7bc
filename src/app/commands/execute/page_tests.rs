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

#[test]
fn every_line_gets_its_message_and_its_cure_runs() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE)).unwrap();
    let (wrong, cured) = (blocks(&text, "line"), blocks(&text, "cured-line"));
    assert!(wrong.len() == cured.len() && wrong.len() > 10);
    let out = temporary_folder("page");
    let mut differences = Vec::new();
    for (wrong, cured) in wrong.iter().zip(&cured) {
        let (line, message) = wrong.split_once("\n//~ ").expect("a line and its message");
        let found = told(line, &out);
        if found.as_deref() != Some(message) {
            differences.push(format!("{line}\n//~ {}", found.unwrap_or_default()));
        }
        if let Some(found) = told(cured, &out) {
            differences.push(format!("cured: {cured}\n{found}"));
        }
    }
    let _ = fs::remove_dir_all(&out);
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}
