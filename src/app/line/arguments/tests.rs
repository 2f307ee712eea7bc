//! Lines and what they mean.

use std::ffi::OsString;
use std::path::PathBuf;

use super::*;
use crate::app::judged::finer::Judging;
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::line::words::quoted;
use crate::app::results::run::RunSettings;
use crate::app::testing::Rotor;
use crate::app::writing::frequency::Frequency;
use crate::model::Fidelity;
use crate::space::Vector;
use crate::{Formulation, Joints, Method, Options, Start, StepSize};

fn read(line: &[&str]) -> Result<Arguments, Refusal> {
    let program = Program {
        name: "rotor",
        default: Command::Run,
        more: "",
        out: PathBuf::from("out/rotor"),
    };
    parse(&Rotor::default(), &program, line.iter().map(OsString::from))
}

fn mistake(line: &[&str]) -> String {
    match read(line) {
        Err(Refusal::Mistake(text)) => text,
        Err(Refusal::Help(text)) => panic!("help: {text}"),
        Ok(arguments) => panic!("accepted: {}", arguments.line),
    }
}

#[test]
fn nothing_given_is_a_run_with_defaults() {
    let arguments = read(&[]).unwrap();
    assert_eq!(arguments.command, Command::Run);
    assert_eq!(
        arguments.settings,
        RunSettings {
            judged: Judging::Affordable,
            ..RunSettings::default()
        }
    );
    assert_eq!(arguments.out, PathBuf::from("out/rotor"));
    assert!(!arguments.quiet && arguments.line.is_empty());
}

#[test]
fn the_line_is_told_as_a_shell_reads_it() {
    let arguments = read(&["run", "omega=4 rad/s", "--rtol", "1e-7"]).unwrap();
    assert_eq!(arguments.line, "run 'omega=4 rad/s' --rtol 1e-7");
    let again = read(&["run", "--resume", "omega=4 rad/s", "--rtol", "1e-7"]).unwrap();
    assert!(
        again.resume && !arguments.resume && again.line == arguments.line,
        "{}",
        again.line
    );
    assert_eq!(quoted("it's"), r"'it'\''s'");
}

#[test]
fn the_version_is_told() {
    let Err(Refusal::Help(text)) = read(&["--version"]) else {
        panic!("no version")
    };
    assert_eq!(text.trim(), concat!("Rotor of rncf ", env!("CARGO_PKG_VERSION")));
}

#[test]
fn all_flags_are_read() {
    let line = "run omega=4rad/s --formulation ancf --integrator hht --alpha -0.3 --rtol 1e-7 --max-step 0.01s \
        --no-elimination --fidelity rod=rigid,beam=modal(3) --stabilised --start steady --t-end 2s --every 0.5s --out here --quiet coils=3";
    let arguments = read(&line.split_whitespace().collect::<Vec<_>>()).unwrap();
    assert_eq!([0, 1].map(|index| arguments.model().get(index)), [4.0, 3.0]);
    let expected = RunSettings {
        formulation: Formulation::Ancf,
        joints: Joints::Multipliers,
        fidelity: vec![("rod".into(), Fidelity::Rigid), ("beam".into(), Fidelity::Modal(3))],
        start: Some(Start::Steady),
        method: Method::Hht { alpha: -0.3 },
        options: Options {
            rtol: 1e-7,
            max_step: 0.01,
            stabilised: true,
            ..Options::default()
        },
        t_end: Some(2.0),
        every: Some(0.5),
        pictures: false,
        judged: Judging::Affordable,
    };
    assert_eq!(arguments.settings, expected);
    assert_eq!(arguments.out, PathBuf::from("here"));
    assert!(arguments.quiet);
    let fixed = read(&["--step", "5 ms", "--integrator", "generalized-alpha"])
        .unwrap()
        .settings;
    let judged = |flag| read(&[flag]).unwrap().settings.judged;
    assert_eq!(
        (fixed.judged, judged("--unjudged"), judged("--thorough")),
        (Judging::Affordable, Judging::No, Judging::Whole)
    );
    assert!(read(&["--unjudged", "--thorough"]).is_err());
    assert_eq!(fixed.options.step, StepSize::Fixed(5e-3));
    assert_eq!(fixed.method, Method::GeneralizedAlpha { rho_inf: 0.8 });
    assert!(!fixed.options.proportional && read(&["--proportional"]).unwrap().settings.options.proportional);
    let line = "campbell omega=0..60rpm --at 1s --steps 7 --modes 5 --frequency Hz --spin 2rad/s --axis x";
    let arguments = read(&line.split_whitespace().collect::<Vec<_>>()).unwrap();
    assert_eq!(
        (arguments.command, arguments.frequency),
        (Command::Campbell, Frequency::Hertz)
    );
    let equilibrium = arguments.equilibrium;
    assert_eq!(
        (equilibrium.at, equilibrium.steps, equilibrium.count),
        (Some(1.0), 7, 5)
    );
    assert_eq!(equilibrium.spin.unwrap().velocity, Vector::new(2.0, 0.0, 0.0));
    assert_eq!(equilibrium.range.map(|range| (range.param, range.from)), Some((0, 0.0)));
}

#[test]
fn flags_that_make_no_sense_together_are_refused() {
    let cases: [(&[&str], &str); 14] = [
        (
            &["--step", "1 ms", "--proportional"],
            "`--proportional` rescales the tolerance of the adaptive step; `--step` fixes the step: give one of them",
        ),
        (
            &["--alpha", "-0.1"],
            "`--alpha` belongs to `--integrator hht`; this run uses radau",
        ),
        (
            &["--integrator", "hht", "--rho-inf", "0.5"],
            "`--rho-inf` belongs to `--integrator generalized-alpha`; this run uses hht",
        ),
        (
            &["--step", "1 ms", "--max-step", "1 s"],
            "`--max-step` is a ceiling of the adaptive step; `--step` fixes the step: give one of them",
        ),
        (
            &["steady", "--every", "1 s"],
            "`--every` belongs to `run`, `chart`, `advise`, not to `steady`: it does not advance in time",
        ),
        (
            &["static", "--spin", "1 rad/s"],
            "`--spin` belongs to `steady`, `modes`, `campbell`, not to `static`: nothing turns at rest",
        ),
        (
            &["--modes", "3"],
            "`--modes` belongs to `modes`, `campbell`, not to `run`: a run in time looks for no equilibrium",
        ),
        (
            &["modes", "--stabilised"],
            "`--stabilised` belongs to `run`, `chart`, `advise`, not to `modes`: it does not advance in time",
        ),
        (
            &["chart", "--unjudged"],
            "`--unjudged` belongs to `run`, `steady`, `modes`, `campbell`, `static`, not to `chart`: it compares many runs",
        ),
        (
            &["modes", "--axis", "x"],
            "`--axis x` says about which axis `--spin` turns: give both",
        ),
        (
            &["omega=1..2 rad/s"],
            "`omega` is given as a range, which `run` does not take: give one value, or use steady, campbell, static, sweep or optimise",
        ),
        (
            &["steady", "--formulation", "ancf"],
            "`--formulation ancf` belongs to `run`: an equilibrium is one of referenced coordinates, with the same result",
        ),
        (
            &["--integrator", "hht", "--alpha", "0.1"],
            "`--alpha 0.1`: alpha lies between -1/3 and 0, e.g. `--alpha -0.05`",
        ),
        (
            &["--rtol", "0"],
            "`--rtol 0`: the tolerance lies between 0 and 1, e.g. `--rtol 1e-6`",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(mistake(line), expected);
    }
    assert_eq!(
        mistake(&["--fidelity", "rod"]),
        "`--fidelity rod`: write `body=description`, e.g. `--fidelity rod=rigid`"
    );
    assert!(mistake(&["--fidelity", "rod=modal(0)"]).contains("`modal(0)` describes no body"));
    assert_eq!(
        mistake(&["--rtol", "1 s"]),
        "`--rtol 1 s`: a number without a unit is needed"
    );
}

#[test]
fn mistyped_flags_and_choices_show_the_nearest() {
    let far = mistake(&["--hht", "1e-4"]);
    assert!(
        far.contains("unexpected argument '--hht'") && !far.contains("tip"),
        "{far}"
    );
    let text = mistake(&["--integratr", "hht"]);
    assert!(
        text.contains("--integratr") && text.contains("'--integrator'"),
        "{text}"
    );
    let text = mistake(&["--formulation", "acnf"]);
    assert!(text.contains("'acnf'") && text.contains("'ancf'"), "{text}");
}

#[test]
fn help_lists_parameters_and_outputs() {
    let Err(Refusal::Help(text)) = read(&["--help"]) else {
        panic!()
    };
    for line in [
        "  omega      3 rad/s  Angular velocity of the frame",
        "  coils      2        Coils in series",
        "  tip   [m] (x, y)  Mass in the frame",
        "  pull  [N]         Force of the spring",
        "The model runs to 4 s with a row every 0.05 s.",
    ] {
        assert!(text.contains(line), "{line}\nin\n{text}");
    }
}
