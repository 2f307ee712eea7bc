//! Runs that were ended before their time and go on: their files are those of a run that was not.

use std::cell::Cell;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::app::commands::checkpoint::{NAME, refusal};
use crate::app::commands::execute::execute;
use crate::app::line::arguments::parse;
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::{Failure, INTERRUPTION, MISTAKE};
use crate::app::testing::{Rotor, temporary_folder};
use crate::app::writing::entries::Summary;

/// A rotor with many rows and renewals, into a folder; `ends` says how many steps it takes until it is interrupted.
fn run(out: &Path, words: &[&str], ends: Option<u64>) -> Result<String, Failure> {
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: out.into(),
    };
    let Ok(mut arguments) = parse(&Rotor::default(), &program, words.iter().map(OsString::from)) else {
        panic!("a mistake on the command line: {words:?}")
    };
    arguments.settings.options.renewed_after = Some(150);
    let taken = Cell::new(0);
    execute(&arguments, || {
        taken.set(taken.get() + 1);
        ends.is_some_and(|ends| taken.get() >= ends)
    })
}

fn folder(name: &str) -> PathBuf {
    let folder = temporary_folder(&format!("resume-{name}"));
    // Of an earlier process with this number.
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// All files but for dates and times taken.
fn files(folder: &Path) -> (String, Value, Vec<String>) {
    let mut summary: Value = serde_json::from_str(&text(folder, "summary.json")).unwrap();
    for key in ["date", "cpu_seconds", "wall_seconds", "command_line"] {
        assert!(summary[key] != Value::Null, "{key}");
        summary[key] = Value::Null;
    }
    let page = text(folder, "report.html");
    let charts = page
        .split("<svg")
        .skip(1)
        .map(|part| part.split("</svg>").next().unwrap().to_owned());
    (text(folder, "history.csv"), summary, charts.collect())
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

const WAYS: [&[&str]; 5] = [
    &["--rtol", "1e-9", "--every", "1 ms"],
    &["--integrator", "hht", "--every", "10 ms"],
    &["--integrator", "generalized-alpha", "--step", "3 ms", "loss=0"],
    &["--step", "10 ms", "--every", "1 s", "loss=0"],
    &["--formulation", "ancf", "--start", "steady", "--rtol", "1e-8"],
];

#[test]
fn a_run_that_was_interrupted_often_has_the_files_of_one_that_was_not() {
    for (way, words) in WAYS.iter().enumerate() {
        let (whole, parts) = (folder(&format!("whole-{way}")), folder(&format!("parts-{way}")));
        run(&whole, words, None).map_err(|failure| failure.message).unwrap();
        assert_eq!(names(&whole), ["history.csv", "report.html", "summary.json"]);
        let (history, summary, charts) = files(&whole);
        let again = [*words, &["--resume"]].concat();
        let failure = run(&parts, words, Some(7)).unwrap_err();
        assert_eq!(failure.code, INTERRUPTION);
        assert!(
            failure
                .message
                .contains("checkpoint (the same command with `--resume` goes on)"),
            "{}",
            failure.message
        );
        // The steps since the last renewal are repeated, and count.
        for ends in [1, 40, 90, 25, 1, 60] {
            let length = text(&parts, "history.csv").len();
            let failure = run(&parts, &again, Some(ends)).unwrap_err();
            assert_eq!(failure.code, INTERRUPTION, "{}", failure.message);
            assert!(text(&parts, "history.csv").len() >= length, "rows were lost");
            assert!(parts.join(NAME).exists());
        }
        run(&parts, &again, None).map_err(|failure| failure.message).unwrap();
        let (history_again, summary_again, charts_again) = files(&parts);
        assert!(history_again == history, "{words:?}");
        assert_eq!(summary_again, summary, "{words:?}");
        assert!(charts_again == charts && charts.len() > 2, "{words:?}");
        assert_eq!(names(&parts), names(&whole));
        let line =
            |folder| serde_json::from_str::<Value>(&text(folder, "summary.json")).unwrap()["command_line"].clone();
        assert_eq!(line(&parts), line(&whole));
        for folder in [whole, parts] {
            fs::remove_dir_all(folder).unwrap();
        }
    }
}

#[test]
fn rows_behind_the_checkpoint_are_made_again() {
    let (whole, killed) = (folder("behind-whole"), folder("behind-killed"));
    let words = WAYS[0];
    run(&whole, words, None).map_err(|failure| failure.message).unwrap();
    run(&killed, words, Some(90)).unwrap_err();
    // A kill leaves more rows than the checkpoint knows, and half a row.
    let (history, _, charts) = files(&whole);
    fs::write(killed.join("history.csv"), &history[..history.len() - 7]).unwrap();
    let again = [words, &["--resume"]].concat();
    run(&killed, &again, None).map_err(|failure| failure.message).unwrap();
    let (history_again, _, charts_again) = files(&killed);
    assert!(history_again == history && charts_again == charts);
    for folder in [whole, killed] {
        fs::remove_dir_all(folder).unwrap();
    }
}

fn refused(out: &Path, words: &[&str]) -> String {
    let failure = run(out, words, None).unwrap_err();
    assert!(failure.code == MISTAKE || failure.code == 1, "{}", failure.message);
    failure.message.replace(&out.display().to_string(), "OUT")
}

#[test]
fn only_the_same_run_goes_on() {
    let out = folder("foreign");
    let nothing = "`--resume`: there is no run in OUT that could go on: begin one without `--resume`";
    assert_eq!(refused(&out, &["--resume"]), nothing);
    run(&out, &["omega=4 rad/s"], Some(9)).unwrap_err();
    let history = text(&out, "history.csv");
    let text_of = refused(
        &out,
        &[
            "--resume",
            "omega=5 rad/s",
            "coils=3",
            "--rtol",
            "1e-7",
            "--integrator",
            "hht",
        ],
    );
    let expected = "`--resume`: the run in OUT is another one than this:\n  omega: 4 rad/s there, 5 rad/s here\n  coils: 2 there, 3 here\n  \
        integrator: radau there, hht here\n  alpha: none there, -0.05 here\n  rtol: 1e-6 there, 1e-7 here\ngive the same, or begin \
        anew without `--resume`";
    assert_eq!(text_of, expected);
    let text_of = refused(&out, &["--resume", "omega=4.0000000000000009 rad/s"]);
    assert!(
        text_of.contains("omega: 4.0 there, 4.000000000000001 here (SI)"),
        "{text_of}"
    );
    for (word, part) in [
        ("--vtu", "pictures: false there, true here"),
        ("--t-end=9s", "t_end: 4.0 there, 9.0 here"),
    ] {
        let text_of = refused(&out, &["--resume", "omega=4 rad/s", word]);
        assert!(text_of.contains(part), "{text_of}");
    }
    // Nothing was touched.
    assert_eq!(text(&out, "history.csv"), history);
    run(&out, &["omega=4 rad/s", "--resume", "--quiet"], None)
        .map_err(|failure| failure.message)
        .unwrap();
    let told = run(&out, &["omega=4 rad/s", "--resume"], None)
        .map_err(|failure| failure.message)
        .unwrap();
    assert!(
        told.ends_with("is complete up to t = 4 s: there is nothing to go on with"),
        "{told}"
    );
    let text_of = refused(&out, &["--resume"]);
    assert!(text_of.contains("omega: 4 rad/s there, 3 rad/s here"), "{text_of}");
    fs::remove_dir_all(out).unwrap();
}

/// Of another table, library or imported file the text says nothing.
#[test]
fn a_program_that_was_built_from_something_else_is_refused() {
    let identity = |text: &str, equations: &str| -> Summary {
        let keys = [("model_hash", text), ("equations_hash", equations)];
        keys.map(|(key, hash)| (key.to_string(), json!(hash)))
            .into_iter()
            .collect()
    };
    let told = |there: Summary| refusal(Path::new("out"), &there, &identity("1", "1"));
    assert_eq!(told(identity("1", "1")), None);
    let other = told(identity("1", "2")).unwrap();
    assert!(
        other.contains("a table, a library or an imported file") && !other.contains("equations_hash"),
        "{other}"
    );
    let other = told(identity("2", "2")).unwrap();
    assert!(
        other.contains("the text of the model") && !other.contains("a table"),
        "{other}"
    );
}

#[test]
fn a_damaged_checkpoint_or_history_is_named() {
    let out = folder("damaged");
    run(&out, &[], Some(9)).unwrap_err();
    let (path, history) = (out.join(NAME), out.join("history.csv"));
    let (good, rows) = (fs::read(&path).unwrap(), fs::read(&history).unwrap());
    let damaged = "OUT/checkpoint is damaged: begin anew, without `--resume`";
    for length in [0, 9, good.len() / 2, good.len() - 1] {
        fs::write(&path, &good[..length]).unwrap();
        assert_eq!(refused(&out, &["--resume"]), damaged, "{length}");
    }
    let mut bytes = good.clone();
    bytes[good.len() / 2] ^= 1;
    fs::write(&path, &bytes).unwrap();
    assert_eq!(refused(&out, &["--resume"]), damaged);
    fs::write(&path, "rncf checkpoint, form 0\n").unwrap();
    let expected = "OUT/checkpoint was written by another version of rncf: begin anew, without `--resume`";
    assert_eq!(refused(&out, &["--resume"]), expected);
    fs::write(&path, &good).unwrap();
    fs::write(&history, &rows[..rows.len() - 1]).unwrap();
    let expected = "OUT/history.csv is not the table that the checkpoint belongs to: it was changed since";
    assert_eq!(refused(&out, &["--resume"]), expected);
    fs::remove_file(&history).unwrap();
    assert!(refused(&out, &["--resume"]).starts_with("cannot go on with OUT/history.csv: "));
    // What is left is not lost: with the file back in its place the run goes on.
    fs::write(&history, &rows).unwrap();
    run(&out, &["--resume"], None)
        .map_err(|failure| failure.message)
        .unwrap();
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn a_run_that_begins_anew_forgets_the_checkpoint() {
    let out = folder("anew");
    run(&out, &["omega=5 rad/s"], Some(9)).unwrap_err();
    run(&out, &[], None).map_err(|failure| failure.message).unwrap();
    assert!(!out.join(NAME).exists());
    assert!(refused(&out, &["--resume", "omega=5 rad/s"]).contains("omega: 3 rad/s there, 5 rad/s here"));
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn a_step_that_fails_fails_again() {
    let out = folder("failing");
    let first = run(&out, &["fail_at=2 s"], None).unwrap_err();
    assert!(
        first.message.contains(" t = 1.9") || first.message.contains(" t = 2 s"),
        "{}",
        first.message
    );
    let history = text(&out, "history.csv");
    let second = run(&out, &["fail_at=2 s", "--resume"], None).unwrap_err();
    let reason = |failure: &Failure| failure.message.lines().next().map(str::to_owned);
    assert_eq!((second.code, reason(&second)), (first.code, reason(&first)));
    assert_eq!(text(&out, "history.csv"), history);
    fs::remove_dir_all(out).unwrap();
}
