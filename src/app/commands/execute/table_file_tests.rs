//! Params that name files: on the command line, in scenarios, summaries, resumed runs and plans.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use serde_json::Value;

use crate::app::commands::execute::execute;
use crate::app::line::arguments::{Arguments, Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::Failure;
use crate::app::testing::{Rotor, temporary_folder};
use crate::emitted::{Between, Fidelity, FileColumn, Table, TableFile, TableForm};
use crate::model::{ConstantArray, KernelCount, Output, Param, ParamKind, RunDefaults};
use crate::{Formulation, Joints, Model, ModelError, Scene};

static COILS: Table = Table {
    name: "coil",
    places: &[0.0, 1.0],
    is_relative: true,
    between: Between::Line,
    columns: &[&[0.0, 1.0], &[100.0, 100.0]],
};

static FORM: TableForm = TableForm {
    table: &COILS,
    file: "data/no_such_folder/coil.csv",
    columns: &[
        FileColumn {
            name: "eta",
            unit: "1",
            dimension: [0; 6],
        },
        FileColumn {
            name: "stiffness",
            unit: "N/m",
            dimension: [0, 1, -2, 0, 0, 0],
        },
    ],
    places: &[0],
    alike: &[],
};

/// What a file with entries of a symmetric matrix has.
static MATRIX: TableForm = TableForm {
    table: &Table {
        name: "coil",
        places: &[0.0, 1.0],
        is_relative: true,
        between: Between::Line,
        columns: &[&[0.0, 1.0], &[1.0, 1.0], &[1.0, 1.0]],
    },
    file: "data/no_such_folder/matrix.csv",
    columns: &[
        FileColumn {
            name: "eta",
            unit: "1",
            dimension: [0; 6],
        },
        FileColumn {
            name: "K12",
            unit: "N",
            dimension: [1, 1, -2, 0, 0, 0],
        },
        FileColumn {
            name: "K21",
            unit: "N",
            dimension: [1, 1, -2, 0, 0, 0],
        },
    ],
    places: &[0],
    alike: &[[1, 2, 1, 1]],
};

/// The rotor with the stiffness in the middle of a table.
#[derive(Clone)]
struct Wound {
    rotor: Rotor,
    coil: TableFile,
}

impl Default for Wound {
    fn default() -> Self {
        Self {
            rotor: Rotor::default(),
            coil: TableFile::declared(&FORM),
        }
    }
}

impl Model for Wound {
    const NAME: &'static str = "Wound";
    const DOC: &'static str = "A rotor whose spring is in a table.";
    const SOURCE: &'static str = "pub model Wound { param coil: table = file(\"data/no_such_folder/coil.csv\"); }";
    const EQUATIONS_HASH: u64 = 1;
    const NOTES: &'static [&'static str] = &[];
    const CONSTANTS: &'static [ConstantArray] = &[];
    const KERNELS: &'static [KernelCount] = &[];

    fn params() -> &'static [Param] {
        static PARAMS: LazyLock<Vec<Param>> = LazyLock::new(|| {
            let omega = Rotor::params()[0];
            let coil = Param {
                name: "coil",
                kind: ParamKind::Table(&FORM),
                unit: "1",
                unit_si: 1.0,
                dimension: [0; 6],
                default: 0.0,
                doc: "Stiffness along the coil",
            };
            vec![omega, coil]
        });
        &PARAMS
    }

    fn outputs() -> &'static [Output] {
        Rotor::outputs()
    }

    fn get(&self, index: usize) -> f64 {
        if index == 0 {
            self.rotor.get(0)
        } else {
            self.coil.number()
        }
    }

    fn set(&mut self, index: usize, value: f64) {
        if index == 0 {
            self.rotor.set(0, value);
        } else {
            self.coil = self.coil.numbered(value);
        }
    }

    fn run(&self) -> RunDefaults {
        self.rotor.run()
    }

    fn build_as(
        &self,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError> {
        crate::model::check_params(self)?;
        let mut rotor = self.rotor.clone();
        rotor.set(2, self.coil.at(1, 0.5, 1.0));
        rotor.build_as(formulation, joints, fidelity)
    }
}

fn arguments(out: &Path, words: &[&str]) -> Result<Arguments, String> {
    let program = Program {
        name: "wound",
        default: Command::Run,
        more: "",
        out: out.into(),
    };
    parse(&Wound::default(), &program, words.iter().map(OsString::from)).map_err(|refusal| match refusal {
        Refusal::Help(text) | Refusal::Mistake(text) => text,
    })
}

fn run(out: &Path, words: &[&str], is_ended: bool) -> Result<String, Failure> {
    let arguments = arguments(out, words).unwrap_or_else(|text| panic!("{text}"));
    let steps = std::cell::Cell::new(0);
    execute(&arguments, || {
        steps.set(steps.get() + 1);
        is_ended && steps.get() > 20
    })
}

/// A folder for one test, gone with it.
struct Folder(PathBuf);

impl std::ops::Deref for Folder {
    type Target = Path;
    fn deref(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn folder(name: &str) -> Folder {
    let folder = temporary_folder(&format!("table-file-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    Folder(folder)
}

fn coil(folder: &Path, name: &str, stiffness: &str) -> String {
    let path = folder.join(name);
    fs::write(
        &path,
        format!("eta, stiffness [kN/m]\n0, {stiffness}\n1, {stiffness}\n"),
    )
    .unwrap();
    format!("coil={}", path.display())
}

fn summary(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
}

#[test]
fn a_file_gives_the_run_of_its_rows_and_the_summary_names_it() {
    let here = folder("run");
    let word = coil(&here, "soft.csv", "0.05");
    let (given, declared) = (here.join("given"), here.join("declared"));
    run(&given, &[&word], false).map_err(|failure| failure.message).unwrap();
    run(&declared, &[], false).map_err(|failure| failure.message).unwrap();
    let told = summary(&given);
    assert_eq!(told["parameters"]["coil"], word[5..]);
    assert_eq!(told["parameters_in_units"]["coil"], word[5..]);
    assert_ne!(told["checksums_of_tables"]["coil"], "0000000000000");
    assert_eq!(summary(&declared)["parameters"]["coil"], FORM.file);
    assert_eq!(summary(&declared)["checksums_of_tables"]["coil"], "0000000000000");
    let page = fs::read_to_string(given.join("report.html")).unwrap();
    assert!(page.contains(&word[5..]) && page.contains(FORM.file));
    // The same spring as a number.
    let mut rotor = Rotor::default();
    rotor.set(2, 50.0);
    let wanted = crate::app::run(&rotor, &crate::app::RunSettings::default()).unwrap_or_else(|error| panic!("{error}"));
    let history = fs::read_to_string(given.join("history.csv")).unwrap();
    let last: Vec<f64> = history
        .lines()
        .last()
        .unwrap()
        .split(',')
        .map(|cell| cell.parse().unwrap())
        .collect();
    let row = wanted.history.values.len() - (last.len() - 1);
    assert_eq!(wanted.history.values[row..], last[1..]);
    // The path of the declaration is the table of the build, where no file has it.
    let same = format!("coil={}", FORM.file);
    assert_eq!(arguments(&here, &[&same]).unwrap().model().get(1), 0.0);
    let help = arguments(&here, &["--help"]).err().unwrap();
    assert!(help.contains(FORM.file), "{help}");
}

#[test]
fn wrong_files_and_lists_of_files_are_told() {
    let here = folder("wrong");
    let told = |word: &str| arguments(&here, &[word]).err().unwrap();
    let wrong = told(&coil(&here, "wrong.csv", "soft"));
    assert!(
        wrong.contains("line 2: `soft` in column `stiffness` is no finite number"),
        "{wrong}"
    );
    let unknown = told("coil=nowhere.csv");
    assert!(
        unknown.contains("`coil=nowhere.csv`: the file `nowhere.csv` cannot be read"),
        "{unknown}"
    );
    let list = told("coil=a.csv,b.csv");
    assert!(list.contains("the file `a.csv` cannot be read"), "{list}");
    let soft = coil(&here, "soft.csv", "0.05");
    let twice = told(&format!("{soft},{}", &soft[5..]));
    assert!(twice.contains("a value is given twice"), "{twice}");
    // A run has one.
    let hard = coil(&here, "hard.csv", "0.2");
    let several = told(&format!("{soft},{}", &hard[5..]));
    assert!(several.contains("sweep"), "{several}");
    // Dots and commas may stand in a path.
    let odd = coil(&here, "a,b..c.csv", "0.05");
    assert!(arguments(&here, &[&odd]).is_ok());
}

#[test]
fn a_saved_scenario_reads_the_file_again() {
    let here = folder("scenario");
    let word = coil(&here, "soft.csv", "0.05");
    let path = here.join("saved.toml");
    let saved = path.to_str().unwrap();
    run(&here.join("out"), &[&word, "--save-scenario", saved], false)
        .map_err(|failure| failure.message)
        .unwrap();
    let again = arguments(&here, &["--scenario", saved]).unwrap();
    assert_eq!(again.model().get(1), arguments(&here, &[&word]).unwrap().model().get(1));
    assert!(
        fs::read_to_string(&path)
            .unwrap()
            .contains(&format!("coil = \"{}\"", &word[5..]))
    );
}

#[test]
fn a_file_that_has_changed_is_another_run_and_another_plan() {
    let here = folder("changed");
    let out = here.join("out");
    let word = coil(&here, "soft.csv", "0.05");
    run(&out, &[&word], true).unwrap_err();
    let plan = here.join("plan.toml");
    let words = [
        "sweep",
        &word,
        "omega=1..3 rad/s in 2",
        "--save-scenario",
        plan.to_str().unwrap(),
    ];
    let points = |out: &Path| -> Vec<String> {
        let names = fs::read_dir(out)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.starts_with("points-")).collect()
    };
    let swept = here.join("swept");
    run(&swept, &words, false).map_err(|failure| failure.message).unwrap();
    let before = points(&swept);
    coil(&here, "soft.csv", "0.06");
    let failure = run(&out, &[&word, "--resume"], false).unwrap_err();
    assert!(failure.message.contains("checksums_of_tables"), "{}", failure.message);
    run(&swept, &words, false).map_err(|failure| failure.message).unwrap();
    assert!(points(&swept).iter().any(|name| !before.contains(name)));
    coil(&here, "soft.csv", "0.05");
    run(&out, &[&word, "--resume"], false)
        .map_err(|failure| failure.message)
        .unwrap();
}

/// The table, the summary and the plan name the files, and a point is the run with its file.
#[test]
fn a_sweep_takes_a_list_of_files() {
    let here = folder("sweep");
    let (soft, hard) = (coil(&here, "soft.csv", "0.05"), coil(&here, "hard.csv", "0.2"));
    let out = here.join("out");
    let both = format!("{soft},{}", &hard[5..]);
    let words = ["sweep", &both, "omega=1..2 rad/s in 2"];
    run(&out, &words, false).map_err(|failure| failure.message).unwrap();
    let table = fs::read_to_string(out.join("sweep.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 5, "{table}");
    assert!(lines[0].starts_with("point,omega [rad/s],coil"), "{table}");
    let paths = [&soft[5..], &hard[5..]];
    for (line, path) in lines[1..].iter().zip([paths[0], paths[1], paths[0], paths[1]]) {
        assert_eq!(line.split(',').nth(2), Some(path), "{table}");
    }
    let alone = here.join("alone");
    let words = ["sweep", &hard, "omega=1..2 rad/s in 2"];
    run(&alone, &words, false).map_err(|failure| failure.message).unwrap();
    let of_hard = fs::read_to_string(alone.join("sweep.csv")).unwrap();
    let results = |line: &str, from: usize| line.split(',').skip(from).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(results(lines[2], 3), results(of_hard.lines().nth(1).unwrap(), 2));
    assert_ne!(results(lines[1], 3), results(lines[2], 3));
    assert_eq!(
        summary(&out)["varied"],
        format!("omega = 1..2 rad/s in 2; coil = {}, {}", paths[0], paths[1])
    );
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains(&format!("coil: 1 = {}, 2 = {}", paths[0], paths[1])));
    let plan = out.join("plan.toml");
    assert!(fs::read_to_string(&plan).unwrap().contains(&both[5..]));
    // The plan is enough for others to do its points; with other rows in a file its points are other ones.
    let plan = plan.to_str().unwrap();
    let there = run(&out, &["task", "--plan", plan, "--index", "3"], false).map_err(|failure| failure.message);
    assert!(there.unwrap().contains("there already"));
    coil(&here, "soft.csv", "0.06");
    let anew = run(&out, &["collect", "--plan", plan], false).err().unwrap();
    assert!(anew.message.contains("4 of 4 points are missing"), "{}", anew.message);
}

/// The page of messages: every file gets its message, every cured one is read.
#[test]
fn every_file_of_the_page_gets_its_message_and_its_cure_is_read() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/errors/table_files.md");
    let page = fs::read_to_string(page).unwrap();
    let blocks = |tag: &str| -> Vec<String> {
        let fence = format!("```{tag}\n");
        let parts = page.split(&fence).skip(1);
        parts
            .map(|part| part.split("\n```").next().unwrap_or_default().to_owned())
            .collect()
    };
    let here = folder("page");
    let path = here.join("other.csv");
    let told = |text: &str| -> Result<(), String> {
        fs::write(&path, format!("{text}\n")).unwrap();
        if text.contains("K12") {
            let read = TableFile::declared(&MATRIX).read(&path);
            return read.map(drop).map_err(|error| error.to_string());
        }
        arguments(&here, &[&format!("coil={}", path.display())]).map(drop)
    };
    let (wrong, cured) = (blocks("file"), blocks("cured-file"));
    assert!(wrong.len() == cured.len() && wrong.len() > 10);
    for (wrong, cured) in wrong.iter().zip(&cured) {
        let (text, message) = wrong.split_once("\n//~ ").expect("a file and its message");
        let found = told(text).expect_err(text);
        assert!(found.contains(&format!("for `coil`: {message}")), "{text}\n//~ {found}");
        told(cured).unwrap_or_else(|found| panic!("{cured}\n{found}"));
    }
    let good = coil(&here, "good.csv", "0.1");
    for given in blocks("no-file") {
        let (words, message) = given.split_once("\n//~ ").expect("a word and its message");
        let words = words.replace("DECLARED", FORM.file).replace("GOOD", &good[5..]);
        let found = arguments(&here, &[&format!("coil={words}")]).err().expect("a refusal");
        assert!(found.ends_with(message), "{words}\n//~ {found}");
    }
}
