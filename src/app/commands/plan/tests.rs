//! Sweeps from the command line to the table.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::app::commands::execute::execute;
use crate::app::line::arguments::{Arguments, Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::Failure;
use crate::app::testing::{Rotor, temporary_folder};

fn read<S: AsRef<str>>(line: &[S]) -> Result<Arguments, String> {
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: PathBuf::from("out/rotor"),
    };
    parse(
        &Rotor::default(),
        &program,
        line.iter().map(|word| OsString::from(word.as_ref())),
    )
    .map_err(|refusal| match refusal {
        Refusal::Help(text) | Refusal::Mistake(text) => text,
    })
}

fn attempted<S: AsRef<str>>(line: &[S]) -> Result<String, Failure> {
    let arguments = read(line).unwrap_or_else(|text| panic!("{text}"));
    execute(&arguments, || false)
}

fn done<S: AsRef<str>>(line: &[S]) -> String {
    attempted(line).unwrap_or_else(|failure| panic!("{}", failure.message))
}

fn failed<S: AsRef<str>>(line: &[S]) -> String {
    attempted(line)
        .map(|said| panic!("{said}"))
        .unwrap_or_else(|failure: Failure| failure.message)
}

fn folder(name: &str) -> (PathBuf, String) {
    let folder = temporary_folder(name);
    let _ = fs::remove_dir_all(&folder);
    let text = folder.to_str().unwrap().to_owned();
    (folder, text)
}

fn points(folder: &Path) -> PathBuf {
    let mut found = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    found.find(|path| path.is_dir()).unwrap()
}

fn table(folder: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.join("sweep.csv")).unwrap();
    text.lines()
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect()
}

#[test]
fn a_grid_is_swept_and_every_row_is_the_run_with_its_values() {
    let (path, out) = folder("sweep-grid");
    let said = done(&[
        "sweep",
        "coils=2,4",
        "omega=1..3 rad/s in 3",
        "--t-end",
        "1 s",
        "--out",
        &out,
    ]);
    assert!(said.starts_with("Rotor: 6 of 6 points of `run`"), "{said}");
    let rows = table(&path);
    assert_eq!(
        rows[0][..4],
        ["point", "omega [rad/s]", "coils [1]", "tip.x last [m]"].map(String::from)
    );
    assert_eq!((rows.len(), &rows[6][1][..], &rows[6][2][..]), (7, "3", "4"));
    let single = read(&["coils=4", "omega=3 rad/s", "--t-end", "1 s"]).unwrap();
    let result = crate::app::run(single.model(), &single.settings).unwrap();
    let last = result.history.values[result.history.values.len() - 3];
    let (low, high) = result.history.extremes(0).unwrap();
    for (place, expected) in [(3, last), (4, low.value), (5, high.value)] {
        assert_eq!(rows[6][place].parse::<f64>().unwrap(), expected, "{}", rows[0][place]);
    }
    let page = fs::read_to_string(path.join("report.html")).unwrap();
    assert_eq!(page.matches("\"cells\":").count(), 6);
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn points_that_are_there_are_kept_and_tasks_make_the_same_table() {
    let (path, out) = folder("sweep-tasks");
    // Not in the order of the model, which is that of the plan's file.
    let line = ["stiffness=90,110 N/m", "omega=1..3 rad/s in 3", "--t-end", "0.5 s"];
    let with = |command: &'static str, more: &[&'static str]| -> Vec<String> {
        let words = std::iter::once(command).chain(line).chain(more.iter().copied());
        words.map(str::to_owned).chain(["--out".into(), out.clone()]).collect()
    };
    done(&with("sweep", &[]));
    // What is varied has no single value, and what the macro chose is no note on the results.
    let page = fs::read_to_string(path.join("report.html")).unwrap();
    for told in [
        "<td>1..3 rad/s in 3</td>",
        "<td>90, 110 N/m</td>",
        "<b>Complete</b></p>",
    ] {
        assert!(page.contains(told), "{told}: {page}");
    }
    let whole = table(&path);
    assert_eq!(whole[0][1..3], ["omega [rad/s]", "stiffness [N/m]"].map(String::from));
    // One file is lost, another is cut off in the middle, a third is kept though its content is changed.
    let folder = points(&path);
    fs::remove_file(folder.join("point-000001.json")).unwrap();
    fs::write(folder.join("point-000002.json"), "{ \"plan\"").unwrap();
    let marked = fs::read_to_string(folder.join("point-000003.json")).unwrap();
    fs::write(folder.join("point-000003.json"), format!("{marked}\n\n")).unwrap();
    let plan = path.join("plan.toml").to_str().unwrap().to_owned();
    let missing = failed(&["collect", "--plan", &plan, "--out", &out]);
    assert!(
        missing.starts_with("2 of 6 points are missing, the first is point 1"),
        "{}",
        missing
    );
    for index in ["1", "2", "3"] {
        let said = done(&["task", "--plan", &plan, "--index", index, "--out", &out]);
        assert_eq!(said.contains("is there already"), index == "3", "{said}");
    }
    assert!(
        fs::read_to_string(folder.join("point-000003.json"))
            .unwrap()
            .ends_with("\n\n")
    );
    done(&["collect", "--plan", &plan, "--out", &out]);
    assert_eq!(table(&path), whole);
    // Another plan has another folder.
    done(&with("sweep", &["--rtol", "1e-5"]));
    assert_ne!(table(&path), whole);
    let folders = fs::read_dir(&path)
        .unwrap()
        .filter(|entry| entry.as_ref().unwrap().path().is_dir());
    assert_eq!(folders.count(), 2);
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn a_point_that_fails_is_recorded_and_told() {
    let (path, out) = folder("sweep-failing");
    let said = done(&["sweep", "fail_at=0.5,9 s", "--t-end", "1 s", "--out", &out]);
    assert!(
        said.contains("1 of 2 points") && said.contains("warning: point 0 (fail_at = 0.5 s) failed: "),
        "{said}"
    );
    let rows = table(&path);
    let place = rows[0].iter().position(|head| head == "failed").unwrap();
    assert!(!rows[1][place].is_empty() && rows[2][place].is_empty(), "{rows:?}");
    // Where it was when it failed is not what it comes to.
    assert!(rows[1][2..place].iter().all(String::is_empty), "{rows:?}");
    assert!(rows[2][2..place].iter().all(|value| !value.is_empty()), "{rows:?}");
    let all = failed(&["sweep", "fail_at=0.5,0.4 s", "--t-end", "1 s", "--out", &out]);
    assert!(all.starts_with("all points failed, the first one: "), "{}", all);
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn an_interrupted_sweep_goes_on() {
    let (path, out) = folder("sweep-interrupted");
    let line = ["sweep", "omega=1..3 rad/s in 4", "--t-end", "1 s", "--out", &out];
    let Err(ended) = execute(&read(&line).unwrap(), || true) else {
        panic!("it was interrupted")
    };
    assert_eq!(ended.code, 130);
    assert!(done(&line).contains("4 of 4 points"));
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn equilibria_and_modes_are_swept_too() {
    let (path, out) = folder("sweep-modes");
    done(&[
        "sweep",
        "--of",
        "modes",
        "stiffness=100,400 N/m",
        "omega=1 rad/s",
        "--modes",
        "2",
        "--out",
        &out,
    ]);
    let rows = table(&path);
    assert_eq!(rows[0][2], "mode 1 im [rad/s]");
    let lowest: Vec<f64> = rows[1..].iter().map(|row| row[2].parse().unwrap()).collect();
    // A mass of 1 kg on two coils in series: sqrt(k/2) -+ omega in the turning frame, hardly damped.
    for (found, k) in lowest.iter().zip([50.0_f64, 200.0]) {
        assert!((found / (k.sqrt() - 1.0) - 1.0).abs() < 1e-3, "{found} {k}");
    }
    // The largest rate of growth is that of some mode, whichever it is.
    let column = |name: &str| rows[0].iter().position(|head| head == name).unwrap();
    let [growth, first, second] = ["growth max [1/s]", "mode 1 re [1/s]", "mode 2 re [1/s]"].map(column);
    for row in &rows[1..] {
        let [growth, first, second] = [growth, first, second].map(|at| row[at].parse::<f64>().unwrap());
        assert_eq!(growth, first.max(second));
    }
    let least = [
        "optimise",
        "stiffness=100..400 N/m",
        "--of",
        "modes",
        "--modes",
        "2",
        "--minimise",
        "growth",
        "--out",
        &out,
    ];
    let told = done(&least);
    assert!(told.contains("the least `growth max`"), "{told}");
    done(&["sweep", "--of", "steady", "stiffness=100,400 N/m", "--out", &out]);
    assert_eq!(table(&path)[0][2], "tip.x last [m]");
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn lines_that_make_no_sense_are_refused() {
    for (line, part) in [
        (
            &["task", "--index", "1"][..],
            "`task` needs the plan: `--plan plan.toml`",
        ),
        (
            &["task", "omega=1 rad/s", "--plan", "p"],
            "`omega=1 rad/s`: `task` takes no params",
        ),
        (
            &["task", "--plan", "p", "--rtol", "1e-3"],
            "what is computed stands in the plan",
        ),
        (
            &["run", "--samples", "9"],
            "`--samples` belongs to `sweep`, `optimise`, `plan`, not to `run`: it computes one point",
        ),
        (
            &["run", "omega=1..2 rad/s in 3"],
            "`omega` is given many values, which `run` does not take: use sweep",
        ),
        (&["sweep", "omega=1,2 rad/s", "--animate"], "it computes many points"),
        (
            &["sweep", "omega=1,2 rad/s", "--steps", "3"],
            "its points are runs in time (`--of`)",
        ),
        (
            &["sweep", "omega=1,2 rad/s", "--of", "modes", "--rtol", "1e-3"],
            "its points do not advance in time",
        ),
        (
            &["sweep", "omega=1,2 rad/s", "--design", "random"],
            "say with `--samples 100` how many",
        ),
        (
            &["sweep", "omega=1,2 rad/s", "--samples", "1"],
            "a whole number from 2 to 1000000",
        ),
    ] {
        let text = read(line).map(drop).unwrap_err();
        assert!(text.contains(part), "{text}");
    }
    let (path, out) = folder("sweep-nothing");
    let nothing = failed(&["sweep", "omega=1 rad/s", "--out", &out]);
    let _ = fs::remove_dir_all(path);
    assert!(nothing.starts_with("no parameter has several values"), "{}", nothing);
}

/// In the turning frame the mass rests where k (x - 2 m) = w^2 x: x = 3 m with a force of 48 N at k = 48 N/m, of two coils of
/// 96 N/m, and w = 4 rad/s.
#[test]
fn what_is_fitted_is_the_closed_form_and_a_search_goes_on_where_it_was() {
    let (path, out) = folder("optimise");
    let with = |more: &[&str]| -> Vec<String> {
        let words = ["optimise", "omega=1..6 rad/s", "--of", "steady", "--out", &out];
        words.iter().chain(more).map(|word| (*word).to_owned()).collect()
    };
    let fit = ["stiffness=-0.05..0.2 kN/m", "--fit", "tip.x=300 cm, pull=48 N"];
    let early = failed(&with(&[&fit[..], &["--most", "20"]].concat()));
    assert!(early.starts_with("the search has not ended after 20 points"), "{early}");
    let marked = points(&path).join("point-000007.json");
    let text = fs::read_to_string(&marked).unwrap();
    fs::write(&marked, format!("{text}\n\n")).unwrap();
    let said = done(&with(&fit));
    assert!(
        said.starts_with("Rotor: `tip.x last` = 3 m, `pull last` = 48 N: "),
        "{said}"
    );
    assert!(
        fs::read_to_string(&marked).unwrap().ends_with("\n\n\n"),
        "the point was kept"
    );
    let page = fs::read_to_string(path.join("report.html")).unwrap();
    let best = page.split("<p><b>").find(|text| text.contains("= 3 m")).expect(&page);
    assert!(
        best.contains("tip.x last` = 3.0000") && best.contains(" at omega='"),
        "{best}"
    );
    assert!(page.contains("<td>1..6 rad/s</td>") && page.contains("<td>-50..200 N/m</td>"));
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(path.join("summary.json")).unwrap()).unwrap();
    let found = ["omega", "stiffness"].map(|name| summary["best_values"][name].as_f64().unwrap());
    assert!(
        (found[0] - 4.0).abs() < 1e-4 && (found[1] - 96.0).abs() < 2e-3,
        "{found:?}"
    );
    // A spring whose stiffness is not positive is refused: such points are in the table, and the search goes around them.
    assert!(summary["points_failed"].as_u64().unwrap() > 0, "{said}");
    let csv = fs::read_to_string(path.join("optimise.csv")).unwrap();
    assert_eq!(csv.lines().count() as u64, 1 + summary["points"].as_u64().unwrap());
    let best = read(&["--scenario", path.join("best.toml").to_str().unwrap()]).unwrap();
    assert_eq!(best.command, Command::Steady);
    assert_eq!(best.model().get(0), found[0]);

    // A pull that no stiffness has beside this place.
    let missed = done(&with(&[
        "stiffness=0.01..0.2 kN/m",
        "--fit",
        "tip.x=300 cm, pull=480 N",
        "--fresh",
    ]));
    assert!(missed.contains("and not 480 N: no point of the ranges"), "{missed}");
    assert!(!said.contains("no point of the ranges"), "{said}");

    let line = [
        "optimise",
        "stiffness=80..90 N/m",
        "--of",
        "steady",
        "--maximise",
        "pull",
        "--out",
        &out,
    ];
    let bound = done(&line);
    assert!(
        bound.contains("`stiffness` lies at the end of its range, 80 N/m"),
        "{bound}"
    );
    fs::remove_dir_all(&path).unwrap();
}

#[test]
fn searches_that_make_no_sense_are_refused() {
    let cases = [
        (
            vec!["optimise", "omega=1..6 rad/s", "--minimise", "tip"],
            "`--minimise \"tip\"`: there is no result `tip`, there are tip.x",
        ),
        (
            vec!["optimise", "omega=1..6 rad/s", "--fit", "pull=3 m"],
            "`--fit \"pull=3 m\"`: `m` does not have",
        ),
        (
            vec!["optimise", "omega=1..6 rad/s", "--fit", "pull"],
            "`--fit \"pull\"`: write `result=value`",
        ),
        (
            vec!["optimise", "omega=1..6 rad/s", "--of", "modes", "--minimise", "pull"],
            "`--minimise \"pull\"`: `pull` is no result of modes",
        ),
        (
            vec!["run", "--minimise", "pull"],
            "`--minimise` belongs to `optimise`, not to `run`: it looks for no optimum",
        ),
    ];
    for (line, expected) in cases {
        let found = read(&line).err().unwrap();
        assert!(found.starts_with(expected), "{found}");
    }
    let (path, out) = folder("optimise-nothing");
    for (line, expected) in [
        (["omega=1..6 rad/s", "--seed=1"], "say what is looked for"),
        (
            ["omega=1,2 rad/s", "--minimise=pull"],
            "`omega`: `optimise` searches whole ranges",
        ),
        (
            ["omega=1 rad/s", "--minimise=pull"],
            "no parameter has a range to search",
        ),
    ] {
        let found = failed(&[&["optimise", "--out", &out][..], &line].concat());
        assert!(found.starts_with(expected), "{found}");
    }
    fs::remove_dir_all(&path).unwrap();
}
