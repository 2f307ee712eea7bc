//! The command as a whole, on the small rotor.

use std::cell::Cell;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::app::commands::execute::execute;
use crate::app::line::arguments::{Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::{Failure, INTERRUPTION, MISTAKE};
use crate::app::testing::{Rotor, temporary_folder};

/// Runs a command line into a folder; Ctrl-C comes when `interrupted` says so.
fn command(out: &Path, words: &[&str], interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let program = Program {
        name: "rotor",
        default: Command::Chart,
        more: "",
        out: PathBuf::new(),
    };
    let words = words.iter().map(OsString::from);
    match parse(&Rotor::default(), &program, words.chain(["--out".into(), out.into()])) {
        Ok(arguments) => execute(&arguments, interrupted),
        Err(Refusal::Mistake(text) | Refusal::Help(text)) => Err(Failure::new(MISTAKE, text)),
    }
}

fn done(out: &Path, words: &[&str]) -> String {
    command(out, words, || false)
        .map_err(|failure| failure.message)
        .unwrap()
}

fn refusal(out: &Path, words: &[&str]) -> String {
    let failure = command(out, words, || false).unwrap_err();
    assert_eq!(failure.code, MISTAKE, "{}", failure.message);
    failure.message
}

fn text(out: &Path, name: &str) -> String {
    fs::read_to_string(out.join(name)).unwrap()
}

fn summary(out: &Path) -> Value {
    serde_json::from_str(&text(out, "summary.json")).unwrap()
}

/// Fields of the points by the heads of the table.
fn field<'t>(table: &'t str, line: usize, name: &str) -> &'t str {
    let mut lines = table.lines();
    let index = lines.next().unwrap().split(',').position(|head| head == name).unwrap();
    lines.nth(line).unwrap().split(',').nth(index).unwrap()
}

const SMALL: [&str; 4] = ["--rtols", "1e-3..1e-6", "--t-end", "2 s"];

#[test]
fn a_chart_has_all_points_and_names_the_cheapest() {
    let out = temporary_folder("chart-complete");
    let words = ["--wanted", "1e-2,1e-12", "--integrators", "radau,hht:-0.3"];
    let said = done(&out, &[&SMALL[..], &words].concat());
    assert!(
        said.starts_with("Rotor: 16 points; largest error of tip.x, tip.y, pull"),
        "{said}"
    );
    assert!(said.contains("1e-2: ") && said.contains(" steps, "), "{said}");
    assert!(
        said.contains("1e-12: the reference is not exact enough for that"),
        "{said}"
    );
    let table = text(&out, "chart.csv");
    assert_eq!(table.lines().count(), 17);
    let error = |line| field(&table, line, "tip.x error_max [m]").parse::<f64>().unwrap();
    // Radau's error falls with the tolerance, and both formulations are the same model.
    assert!(error(0) > 30.0 * error(3) && error(3) > 0.0, "{table}");
    assert_eq!(
        (field(&table, 8, "formulation"), field(&table, 8, "integrator")),
        ("ancf", "radau")
    );
    assert!(error(11) < 1e-5, "{table}");
    for line in 0..16 {
        assert!(field(&table, line, "cpu_s").parse::<f64>().unwrap() > 0.0);
        // One mesh: both errors are against the same run.
        assert_eq!(
            field(&table, line, "pull error_rms [N]"),
            field(&table, line, "pull time_error_rms [N]")
        );
    }
    let summary = summary(&out);
    assert_eq!((&summary["points"], &summary["complete"]), (&16.into(), &16.into()));
    let cheapest = &summary["cheapest"][0]["cheapest"];
    assert!(cheapest["error"].as_f64().unwrap() <= 1e-2 && summary["cheapest"][1]["cheapest"].is_null());
    for name in ["chart_time.svg", "chart_work.svg", "report.html"] {
        let text = text(&out, name);
        assert!(
            text.contains("</svg>") && text.contains("Pareto front") && !text.contains("NaN"),
            "{name}"
        );
    }
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn a_chart_goes_on_where_it_was_interrupted_killed_or_is_complete() {
    let out = temporary_folder("chart-resumed");
    let words = [&SMALL[..], &["--formulations", "rncf", "--integrators", "radau"]].concat();
    // Interrupted at once: nothing but the folder. Later: whole lines.
    let failure = command(&out, &words, || true).unwrap_err();
    assert_eq!(failure.code, INTERRUPTION, "{}", failure.message);
    let asked = Cell::new(0);
    let after_the_errors = || {
        asked.set(asked.get() + 1);
        fs::read_to_string(out.join("chart.csv")).is_ok_and(|table| table.lines().count() == 5)
    };
    let failure = command(&out, &words, after_the_errors).unwrap_err();
    assert_eq!(failure.code, INTERRUPTION, "{}", failure.message);
    assert!(failure.message.contains("the same command again goes on") && asked.get() > 0);
    assert_eq!(summary(&out)["completed"], false);
    let table = text(&out, "chart.csv");
    assert_eq!((table.lines().count(), field(&table, 0, "cpu_s")), (5, ""));
    // Killed within the last line: that point alone is missing. A mark in another one shows that it is kept.
    let kept = table.lines().nth(1).unwrap();
    let marked = kept.replacen(&format!(",{},", field(&table, 0, "steps")), ",777777,", 1);
    let killed = table.replace(kept, &marked);
    fs::write(out.join("chart.csv"), &killed[..killed.len() - 9]).unwrap();
    done(&out, &words);
    let table = text(&out, "chart.csv");
    assert_eq!(table.lines().count(), 5);
    assert!(
        table.contains("777777") && (0..4).all(|line| !field(&table, line, "cpu_s").is_empty()),
        "{table}"
    );
    // Complete: nothing changes, not even a time.
    done(&out, &words);
    assert_eq!(text(&out, "chart.csv"), table);
    // More tolerances within the same range, or other words about the points: these stay.
    done(&out, &[&words[..], &["--wanted", "1e-4", "--outputs", "pull"]].concat());
    assert_eq!(text(&out, "chart.csv"), table);
    // Another problem, and a wish for a new beginning, begin anew.
    done(&out, &[&words[..], &["loss=0.02"]].concat());
    assert!(!text(&out, "chart.csv").contains("777777"));
    fs::write(out.join("chart.csv"), &table).unwrap();
    done(&out, &[&words[..], &["--fresh"]].concat());
    assert!(!text(&out, "chart.csv").contains("777777"));
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn a_line_that_is_no_point_is_named() {
    let out = temporary_folder("chart-spoiled");
    let words = [&SMALL[..], &["--formulations", "rncf", "--integrators", "radau"]].concat();
    done(&out, &words);
    let table = text(&out, "chart.csv");
    let spoiled = table
        .replacen("complete", "complte", 2)
        .replacen("complte", "complete", 1);
    fs::write(out.join("chart.csv"), spoiled).unwrap();
    let failure = command(&out, &words, || false).unwrap_err();
    assert!(
        failure
            .message
            .contains("chart.csv, line 3: this is no point of a chart"),
        "{}",
        failure.message
    );
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn several_meshes_are_measured_against_the_finest() {
    let out = temporary_folder("chart-meshes");
    let words = ["coils=2,4", "--formulations", "rncf", "--integrators", "radau"];
    let said = done(&out, &[&SMALL[..], &words].concat());
    assert!(
        said.contains("coils=4, radau, rtol 1e-8") && said.contains("against coils=4"),
        "{said}"
    );
    let table = text(&out, "chart.csv");
    let error = |line, name| field(&table, line, name).parse::<f64>().unwrap();
    // Softer springs are another motion: the error of the coarse mesh does not fall, that of its time integration does.
    assert_eq!(
        (field(&table, 3, "mesh"), field(&table, 4, "mesh")),
        ("coils=2", "coils=4")
    );
    assert!(
        error(3, "tip.x error_max [m]") > 0.1 && error(3, "tip.x time_error_max [m]") < 1e-4,
        "{table}"
    );
    assert_eq!(error(7, "tip.x error_max [m]"), error(7, "tip.x time_error_max [m]"));
    assert_eq!(summary(&out)["parameters"]["coils"], serde_json::json!([2, 4]));
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn failures_and_long_runs_are_reported_and_tried_again_with_more_patience() {
    let out = temporary_folder("chart-failing");
    let words = [&SMALL[..], &["--formulations", "rncf", "--integrators", "radau"]].concat();
    done(&out, &words);
    // As if the first run had failed, and the second one had taken longer than 60 s.
    let table = text(&out, "chart.csv");
    let mut lines: Vec<String> = table.lines().map(String::from).collect();
    lines.truncate(3);
    let commas = ",".repeat(12);
    lines[1] = lines[1].replace("complete,", "failed,the step became too small");
    let end = lines[1].find("too small").unwrap() + "too small".len();
    lines[1] = lines[1][..end].to_owned() + ",2,0,0,0,0,0,0,0,0,0,,0" + &commas;
    lines[2] = lines[2].replace("complete,", "too long,60 s");
    let end = lines[2].find("60 s").unwrap() + "60 s".len();
    lines[2] = lines[2][..end].to_owned() + ",2,0,0,0,0,0,0,0,0,0,,0" + &commas;
    fs::write(out.join("chart.csv"), lines.join("\n") + "\n").unwrap();
    let said = done(&out, &words);
    assert!(
        said.contains("note: rncf, radau, rtol 1e-3: the step became too small"),
        "{said}"
    );
    assert!(
        said.contains("note: rncf, radau, rtol 1e-4: ended after 60 s"),
        "{said}"
    );
    assert!(said.contains("no point competes yet"), "{said}");
    assert_eq!(text(&out, "chart.csv").lines().count(), 3);
    assert_eq!(
        (&summary(&out)["failed"], &summary(&out)["too_long"]),
        (&1.into(), &1.into())
    );
    done(&out, &[&words[..], &["--limit", "61 s"]].concat());
    assert_eq!(
        (&summary(&out)["complete"], &summary(&out)["too_long"]),
        (&3.into(), &0.into())
    );
    // A converged run needs time, too.
    let short = [
        "--limit",
        "1 us",
        "--t-end",
        "20000 s",
        "--every",
        "1 s",
        "fail_at=1e9 s",
    ];
    let all = [
        &[
            "--rtols",
            "1e-2,1e-8",
            "--formulations",
            "rncf",
            "--integrators",
            "radau",
        ][..],
        &short,
    ]
    .concat();
    let failure = command(&out, &all, || false).unwrap_err();
    assert!(failure.message.contains("raise `--limit`"), "{}", failure.message);
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn other_codes_stand_beside() {
    let out = temporary_folder("chart-beside");
    crate::app::machine::files::create_folder(&out).unwrap();
    let file = out.join("peers.csv");
    let head = "code,setting,output,error_max,error_rms,cpu_s,steps";
    fs::write(
        &file,
        format!("{head}\nexact,h,pull,1e-9,1e-9,1e-9,1\nslow,h,pull,1e-9,1e-9,900,5\n"),
    )
    .unwrap();
    let file = file.display().to_string();
    let words = [
        "--formulations",
        "rncf",
        "--integrators",
        "radau",
        "--beside",
        &file,
        "--wanted",
        "1e-3",
    ];
    let all = [&SMALL[..], &words].concat();
    assert!(refusal(&out, &all).contains("has no output `tip.x`; choose others with `--outputs`"));
    let said = done(&out, &[&all[..], &["--outputs", "pull"]].concat());
    assert!(
        said.contains("; slow ") && said.contains("; exact ") && said.contains(" x"),
        "{said}"
    );
    assert!(text(&out, "chart_time.svg").contains("other codes"));
    assert!(text(&out, "report.html").contains("another code"));
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn mistakes_in_lists_and_files_are_refused_by_name() {
    let out = temporary_folder("chart-mistakes");
    let cases = [
        (
            &["--formulations", "rncf,anfc"][..],
            "`--formulations anfc`: did you mean `ancf`?",
        ),
        (
            &["--formulations", "rncf,rncf"],
            "`--formulations rncf,rncf`: `rncf` is given twice",
        ),
        (
            &["--integrators", "radau,hht:-0.5"],
            "`--integrators hht:-0.5`: the number lies between -1/3 and 0",
        ),
        (
            &["--integrators", "radau:5"],
            "`--integrators radau:5`: radau has no parameter",
        ),
        (
            &["--integrators", "raudau"],
            "`--integrators raudau`: did you mean `radau`?",
        ),
        (
            &["--rtols", "1e-3..0"],
            "`--rtols 1e-3..0`: a tolerance lies between 0 and 1",
        ),
        (&["--rtols", "1e-3,1e-3"], "`--rtols 1e-3,1e-3`: 1e-3 is given twice"),
        (&["--outputs", "tip.x,pul"], "`--outputs pul`: did you mean `pull`?"),
        (
            &["--wanted", "2"],
            "`--wanted 2`: an error relative to the largest change lies between 0 and 1",
        ),
        (&["--limit", "60"], "`--limit 60`: the unit is missing"),
        (
            &["omega=1,2 rad/s"],
            "`omega` is given as a list, but a chart is of one problem",
        ),
        (
            &["--every", "9 s"],
            "the time between rows, 9 s, is longer than the run of 4 s",
        ),
        (&["--beside", "/nowhere.csv"], "cannot read /nowhere.csv: "),
        (
            &["stiffness=-1 N/m"],
            "rncf is left out: parameter `stiffness` must be positive",
        ),
        (&["--rtol", "1e-3"], "`--rtol` belongs to"),
        (
            &["run", "--rtols", "1e-3"],
            "`--rtols` belongs to `chart`, not to `run`",
        ),
    ];
    for (words, expected) in cases {
        let refusal = refusal(&out, words);
        assert!(refusal.contains(expected), "{refusal}\ninstead of\n{expected}");
    }
    let failure = command(&out, &["--reference", "/nowhere.csv"], || false).unwrap_err();
    assert!(
        failure.message.contains("cannot read /nowhere.csv: "),
        "{}",
        failure.message
    );
    fs::remove_dir_all(out).unwrap();
}

#[test]
fn an_output_that_stays_is_left_out_or_refused() {
    let out = temporary_folder("chart-still");
    // Without spin nothing moves.
    let words = [&SMALL[..], &["omega=0 rad/s"]].concat();
    assert!(refusal(&out, &words).contains("no output changes"), "{out:?}");
    let words = [&words[..], &["--outputs", "pull"]].concat();
    assert!(refusal(&out, &words).contains("output `pull` does not change"));
    fs::remove_dir_all(out).unwrap();
}
