use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::*;
use crate::Model;
use crate::app::line::arguments::parse;
use crate::app::line::program::Program;
use crate::app::results::failure::INTERRUPTION;
use crate::app::testing::{Rotor, temporary_folder};

/// Runs a command line; its outcome and the folder of its files.
fn command(name: &str, words: &[&str], interrupted: bool) -> (Result<String, Failure>, PathBuf) {
    let out = temporary_folder(name);
    let words = words
        .iter()
        .map(OsString::from)
        .chain(["--out".into(), out.clone().into()]);
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: PathBuf::new(),
    };
    let Ok(arguments) = parse(&Rotor::default(), &program, words) else {
        panic!("a mistake on the command line")
    };
    (execute(&arguments, || interrupted), out)
}

fn summary(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

fn rows(folder: &Path, name: &str) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(folder.join(name)).unwrap();
    let row = |line: &str| {
        line.split(',')
            .map(|number| number.parse().unwrap_or(f64::NAN))
            .collect()
    };
    text.lines().skip(1).map(row).collect()
}

#[test]
fn a_run_writes_its_three_files() {
    let words = ["coils=4", "loss=0", "--integrator", "hht", "--max-step", "1 ms"];
    let (outcome, folder) = command("complete", &words, false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(
        text.starts_with("Rotor: t = 4 s, ") && text.contains("report.html"),
        "{text}"
    );
    let table = rows(&folder, "history.csv");
    assert_eq!((table.len(), table[0].len(), table[80][0]), (81, 4, 80.0 * 0.05));
    let summary = summary(&folder);
    let expected = [
        ("model", "Rotor".into()),
        ("formulation", "rncf".into()),
        ("integrator", "hht".into()),
        ("alpha", (-0.05).into()),
        ("completed", true.into()),
        ("reason", Value::Null),
        ("t_end", 4.0.into()),
        ("unknowns", 2.into()),
        ("constraints", 0.into()),
        ("max_constraint_residual", Value::Null),
        ("max_step", 1e-3.into()),
    ];
    for (key, value) in expected {
        assert_eq!(summary[key], value, "{key}");
    }
    assert_eq!(summary["parameters"]["coils"], 4);
    assert_eq!(summary["parameters"]["omega"], 3.0);
    assert_eq!(summary["parameters_in_units"]["omega"], "3 rad/s");
    let line = summary["command_line"].as_str().unwrap();
    assert!(
        line.starts_with("coils=4 loss=0 --integrator hht --max-step '1 ms' --out "),
        "{line}"
    );
    assert_eq!(summary["model_text"], <Rotor as Model>::SOURCE);
    assert_eq!(summary["model_hash"].as_str().unwrap().len(), 16);
    assert!(summary["date"].as_str().unwrap().ends_with('Z'));
    for key in [
        "steps",
        "steps_at_ceiling",
        "newton_iterations",
        "residual_evaluations",
        "jacobian_evaluations",
        "factorizations",
        "cpu_seconds",
        "wall_seconds",
        "energy_error",
        "smallest_step",
        "largest_step",
    ] {
        assert!(summary[key].as_f64().unwrap() > 0.0, "{key}");
    }
    assert!(summary["rejected_steps"].is_u64());
    let least = table.iter().map(|row| row[1]).fold(f64::INFINITY, f64::min);
    assert_eq!(summary["outputs"][0]["name"], "tip.x");
    assert_eq!(summary["outputs"][0]["min"].as_f64().unwrap(), least);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert_eq!(page.matches("<svg ").count(), 3);
    assert!(page.contains("// a &lt; b &amp; c") && page.contains("The spring has no mass."));
    assert!(!page.contains("http") || page.matches("http").count() == page.matches("http://www.w3.org/").count());
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn ctrl_c_leaves_complete_files_and_its_reason() {
    let (outcome, folder) = command("interrupted", &["--integrator", "hht"], true);
    let failure = outcome.unwrap_err();
    assert_eq!(failure.code, INTERRUPTION);
    assert!(
        failure.message.contains("interrupted by the user"),
        "{}",
        failure.message
    );
    let summary = summary(&folder);
    assert_eq!(summary["completed"], false);
    assert_eq!(summary["reason"], "interrupted by the user");
    assert_eq!(rows(&folder, "history.csv")[0][0], 0.0);
    assert!(
        fs::read_to_string(folder.join("report.html"))
            .unwrap()
            .contains("interrupted by the user")
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn while_it_runs_the_rows_are_on_disk_and_the_summary_says_so() {
    let folder = temporary_folder("running");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("report.html"), "of an earlier run").unwrap();
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: folder.clone(),
    };
    let words = ["--every", "1 ms", "--integrator", "hht", "--t-end", "2 s"].map(OsString::from);
    let Ok(arguments) = parse(&Rotor::default(), &program, words) else {
        panic!("a mistake on the command line")
    };
    let seen = std::cell::Cell::new(0);
    let begun = std::time::Instant::now();
    let outcome = execute(&arguments, || {
        // What another process would find, or anybody after a kill.
        if seen.get() == 0 && begun.elapsed() > std::time::Duration::from_millis(600) {
            let text = fs::read_to_string(folder.join("history.csv")).unwrap();
            assert!(text.ends_with('\n') && text.lines().all(|line| line.split(',').count() == 4));
            seen.set(text.lines().count());
            let summary = summary(&folder);
            assert_eq!(summary["completed"], false);
            assert!(summary["reason"].as_str().unwrap().starts_with("still running"));
            assert!(!folder.join("report.html").exists());
            let error = files::claim(&folder).unwrap_err();
            assert!(error.contains("another run writes to"), "{error}");
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
        false
    });
    outcome.map_err(|failure| failure.message).unwrap();
    assert!(seen.get() > 10, "{} lines", seen.get());
    assert_eq!(rows(&folder, "history.csv").len(), 2001);
    assert_eq!(summary(&folder)["rows"], 2001);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_failing_step_leaves_complete_files_and_its_reason() {
    let (outcome, folder) = command("failing", &["fail_at=1.02 s", "--integrator", "hht"], false);
    let failure = outcome.unwrap_err();
    assert_eq!(failure.code, FAILURE);
    assert!(failure.message.contains(" t = 1.0"), "{}", failure.message);
    let summary = summary(&folder);
    assert_eq!(summary["completed"], false);
    assert!(summary["t_reached"].as_f64().unwrap() <= 1.02);
    assert_eq!(rows(&folder, "history.csv").len(), 21);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn steady_writes_its_table_over_the_spin() {
    let (outcome, folder) = command("steady", &["steady", "omega=60 rpm"], false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(
        text.contains("6.28318530718 rad/s") && text.contains("steady.csv"),
        "{text}"
    );
    let head = fs::read_to_string(folder.join("steady.csv")).unwrap();
    assert!(head.starts_with("spin [rad/s],tip.x [m],tip.y [m],pull [N]\n"));
    let last = rows(&folder, "steady.csv").pop().unwrap();
    assert_eq!(last[0], 60.0 * (std::f64::consts::PI / 30.0));
    let summary = summary(&folder);
    assert_eq!(summary["outputs"][0]["spin_max"].as_f64().unwrap(), last[0]);
    assert!(summary["completed"] == true && summary["newton_iterations"].as_u64().unwrap() > 0);
    assert!(
        fs::read_to_string(folder.join("report.html"))
            .unwrap()
            .contains("spin [rad/s]")
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn static_writes_its_table_over_the_load() {
    let (outcome, folder) = command("static", &["static", "--steps", "4"], false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(text.contains("5 steps up to load_factor = 1, "), "{text}");
    let head = fs::read_to_string(folder.join("static.csv")).unwrap();
    assert!(head.starts_with("load_factor [1],tip.x [m],"));
    assert_eq!(rows(&folder, "static.csv")[4][..2], [1.0, 2.0]);
    assert_eq!(summary(&folder)["critical_values"], serde_json::json!([]));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn modes_are_written_and_told_in_the_unit_that_is_asked_for() {
    let words = ["modes", "omega=10 rad/s", "loss=0", "--frequency", "rpm"];
    let (outcome, folder) = command("modes", &words, false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    let w0 = 50f64.sqrt();
    let rpm = |value: f64| digits(value * 30.0 / std::f64::consts::PI, 7);
    for part in [
        "frequency [rpm]".to_owned(),
        rpm(10.0 - w0),
        rpm(10.0 + w0),
        rpm(w0),
        "No mode grows".into(),
        "reference frame".into(),
    ] {
        assert!(text.contains(&part), "{part}\nin\n{text}");
    }
    let table = rows(&folder, "modes.csv");
    assert!(
        table.len() == 2 && (table[0][2] - (10.0 - w0)).abs() < 1e-9,
        "{table:?}"
    );
    assert_eq!(summary(&folder)["circular_whirl"], true);
    fs::remove_dir_all(folder).unwrap();
    let (outcome, folder) = command("unstable", &["modes", "omega=10 rad/s"], false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(text.contains("UNSTABLE"), "{text}");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_campbell_diagram_shows_what_is_read_off() {
    let words = ["campbell", "omega=0..60 rpm", "--frequency", "Hz"];
    let (outcome, folder) = command("campbell", &words, false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(text.contains("no critical speed in this range"), "{text}");
    // 0.5 sqrt(50) rad/s; in space both whirls have sqrt(50) rad/s.
    assert_eq!(
        text.matches("crosses 2x the spin at omega = 3.535").count(),
        2,
        "{text}"
    );
    assert!(!text.contains("within") && !text.contains("Mode 1 is"), "{text}");
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert_eq!(page.matches("<svg ").count(), 3);
    for part in [
        "omega [rad/s]",
        "frequency in the inertial frame [Hz]",
        "backward whirl",
        "1x",
    ] {
        assert!(page.contains(part), "{part}");
    }
    fs::remove_dir_all(folder).unwrap();
    let (outcome, folder) = command("campbell-interrupted", &words, true);
    assert_eq!(outcome.unwrap_err().code, INTERRUPTION);
    assert_eq!(summary(&folder)["reason"], "interrupted by the user");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_model_that_cannot_be_built_is_a_mistake() {
    let (outcome, folder) = command("unbuildable", &["stiffness=-1 N/m"], false);
    let failure = outcome.unwrap_err();
    assert_eq!(failure.code, MISTAKE);
    assert_eq!(failure.message, "parameter `stiffness` must be positive");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn another_run_stands_beside_and_a_wrong_one_is_refused_before_the_run() {
    let (outcome, first) = command("beside_first", &["loss=0"], false);
    outcome.map_err(|failure| failure.message).unwrap();
    let path = first.to_str().unwrap();
    let (outcome, second) = command("beside_second", &["loss=0.02", "--compare", path], false);
    outcome.map_err(|failure| failure.message).unwrap();
    let compared = &summary(&second)["compared"];
    let [own, other] = [&second, &first].map(|folder| rows(folder, "history.csv"));
    assert_eq!(compared["rows"], own.len());
    let largest = own.iter().zip(&other).map(|(own, other)| own[1] - other[1]);
    let largest = largest.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap();
    assert_eq!(compared["columns"][0]["column"], "tip.x [m]");
    assert_eq!(compared["columns"][0]["largest_difference"]["value"], largest);
    let page = fs::read_to_string(second.join("report.html")).unwrap();
    assert!(
        page.contains("<section class=\"beside\">") && page.contains("\"x the other\",\"color\":2"),
        "{page}"
    );
    // A line that is no row: the run is as it is, and the reason is told.
    fs::write(first.join("history.csv"), "t [s],pull [N]\n0,1\n1\n").unwrap();
    let words = ["--compare", path];
    let (outcome, second_again) = command("beside_second", &words, false);
    let text = outcome.map_err(|failure| failure.message).unwrap();
    assert!(
        text.contains("warning: --compare: ") && text.contains("line 3 is no row"),
        "{text}"
    );
    assert!(summary(&second_again)["compared"].is_null());
    fs::write(first.join("history.csv"), "spin [rad/s]\n").unwrap();
    let (outcome, third) = command("beside_third", &words, false);
    let failure = outcome.unwrap_err();
    assert_eq!(failure.code, MISTAKE);
    assert!(
        failure.message.contains("is no history of a run"),
        "{}",
        failure.message
    );
    assert!(!third.join("history.csv").exists());
    for folder in [first, second, third] {
        let _ = fs::remove_dir_all(folder);
    }
}
