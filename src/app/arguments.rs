//! The command line: `[run|steady] [name=value ...] [flags]`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches};

use super::parameters::{assign, in_unit, short, time};
use super::run::RunSettings;
use crate::{Formulation, Joints, Method, Model, Options, Start, StepSize};

/// What to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    /// Integrate in time.
    Run,
    /// Relative equilibria up to the spin at the end time.
    Steady,
}

/// A command line that makes sense.
#[derive(Clone, Debug)]
pub(super) struct Arguments<M> {
    pub command: Command,
    pub model: M,
    pub settings: RunSettings,
    pub out: PathBuf,
    pub quiet: bool,
}

/// Why there is nothing to run.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Refusal {
    /// Help was asked for.
    Help(String),
    /// A mistake, with what would be right.
    Mistake(String),
}

/// Reads the words after the program's name; `program` is the example's name.
///
/// # Errors
/// [`Refusal`].
pub(super) fn parse<M: Model>(
    program: &str,
    words: impl IntoIterator<Item = OsString>,
) -> Result<Arguments<M>, Refusal> {
    let line = std::iter::once(program.into()).chain(words);
    let matches = command_line::<M>(program)
        .try_get_matches_from(line)
        .map_err(|error| match error.kind() {
            clap::error::ErrorKind::DisplayHelp => Refusal::Help(error.to_string()),
            _ => Refusal::Mistake(error.to_string().trim_start_matches("error: ").trim_end().into()),
        })?;
    read(program, &matches).map_err(Refusal::Mistake)
}

fn read<M: Model>(program: &str, matches: &ArgMatches) -> Result<Arguments<M>, String> {
    let mut words: Vec<String> = matches.get_many("words").into_iter().flatten().cloned().collect();
    let command = match words.first().map(String::as_str) {
        Some("run") => Some(Command::Run),
        Some("steady") => Some(Command::Steady),
        _ => None,
    };
    if command.is_some() {
        words.remove(0);
    }
    let mut model = M::default();
    assign(&mut model, &words)?;
    let command = command.unwrap_or(Command::Run);
    if command == Command::Steady {
        refuse_with_steady(matches)?;
    }
    let out = matches.get_one::<PathBuf>("out").cloned();
    Ok(Arguments {
        command,
        model,
        settings: settings(matches)?,
        out: out.unwrap_or_else(|| PathBuf::from("out").join(program)),
        quiet: matches.get_flag("quiet"),
    })
}

/// Flags that say how to advance in time mean nothing for an equilibrium.
fn refuse_with_steady(matches: &ArgMatches) -> Result<(), String> {
    let flags = [
        "integrator",
        "rtol",
        "step",
        "max-step",
        "alpha",
        "rho-inf",
        "start",
        "every",
    ];
    if let Some(flag) = flags.into_iter().find(|flag| given(matches, flag)) {
        return Err(format!(
            "`--{flag}` belongs to `run`: `steady` does not advance in time"
        ));
    }
    if matches.get_flag("stabilised") {
        return Err("`--stabilised` belongs to `run`: `steady` does not advance in time".into());
    }
    if matches.get_flag("no-elimination") {
        return Err("`--no-elimination` belongs to `run`: `steady` eliminates all joints that it can".into());
    }
    if text(matches, "formulation") == Some("ancf") {
        return Err(
            "`--formulation ancf` belongs to `run`: a relative equilibrium is one of referenced coordinates".into(),
        );
    }
    Ok(())
}

fn settings(matches: &ArgMatches) -> Result<RunSettings, String> {
    let formulation = match text(matches, "formulation") {
        Some("ancf") => Formulation::Ancf,
        _ => Formulation::Rncf,
    };
    let flag_time = |name: &str, example| {
        let text = text(matches, name);
        text.map(|text| time(&format!("--{name}"), text, example)).transpose()
    };
    let step = flag_time("step", "0.01 s")?;
    let max_step = flag_time("max-step", "0.01 s")?;
    if step.is_some() && max_step.is_some() {
        return Err("`--max-step` is a ceiling of the adaptive step; `--step` fixes the step: give one of them".into());
    }
    let rtol = match number(matches, "rtol")? {
        Some(rtol) if !(rtol > 0.0 && rtol < 1.0) => {
            return Err(format!(
                "`--rtol {rtol}`: the tolerance lies between 0 and 1, e.g. `--rtol 1e-6`"
            ));
        }
        rtol => rtol.unwrap_or(Options::default().rtol),
    };
    Ok(RunSettings {
        formulation,
        joints: if matches.get_flag("no-elimination") {
            Joints::Multipliers
        } else {
            Joints::Eliminated
        },
        start: match text(matches, "start") {
            Some("steady") => Start::Steady,
            _ => Start::Rest,
        },
        method: method(matches)?,
        options: Options {
            rtol,
            step: step.map_or(StepSize::Adaptive, StepSize::Fixed),
            max_step: max_step.unwrap_or(f64::INFINITY),
            stabilised: matches.get_flag("stabilised"),
            ..Options::default()
        },
        t_end: flag_time("t-end", "20 s")?,
        every: flag_time("every", "0.05 s")?,
    })
}

fn method(matches: &ArgMatches) -> Result<Method, String> {
    let name = text(matches, "integrator").unwrap_or("radau");
    let (alpha, rho_inf) = (number(matches, "alpha")?, number(matches, "rho-inf")?);
    if alpha.is_some() && name != "hht" {
        return Err(format!("`--alpha` belongs to `--integrator hht`; this run uses {name}"));
    }
    if rho_inf.is_some() && name != "generalized-alpha" {
        return Err(format!(
            "`--rho-inf` belongs to `--integrator generalized-alpha`; this run uses {name}"
        ));
    }
    if let Some(alpha) = alpha
        && !(-1.0 / 3.0 - 1e-12..=0.0).contains(&alpha)
    {
        return Err(format!(
            "`--alpha {alpha}`: alpha lies between -1/3 and 0, e.g. `--alpha -0.05`"
        ));
    }
    if let Some(rho) = rho_inf
        && !(0.0..=1.0).contains(&rho)
    {
        return Err(format!(
            "`--rho-inf {rho}`: the spectral radius lies between 0 and 1, e.g. `--rho-inf 0.8`"
        ));
    }
    Ok(match name {
        "hht" => Method::Hht {
            alpha: alpha.unwrap_or(-0.05),
        },
        "generalized-alpha" => Method::GeneralizedAlpha {
            rho_inf: rho_inf.unwrap_or(0.8),
        },
        _ => Method::Radau,
    })
}

fn given(matches: &ArgMatches, name: &str) -> bool {
    text(matches, name).is_some()
}

fn text<'m>(matches: &'m ArgMatches, name: &str) -> Option<&'m str> {
    matches.get_one::<String>(name).map(String::as_str)
}

fn number(matches: &ArgMatches, name: &str) -> Result<Option<f64>, String> {
    let read = |text: &str| match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`--{name} {text}`: a number without a unit is needed")),
    };
    text(matches, name).map(read).transpose()
}

fn command_line<M: Model>(program: &str) -> clap::Command {
    let value = |name: &'static str, placeholder: &'static str, help: &'static str| {
        Arg::new(name)
            .long(name)
            .value_name(placeholder)
            .help(help)
            .allow_hyphen_values(true)
    };
    let choice =
        |name: &'static str, placeholder: &'static str, choices: &'static [&'static str], help: &'static str| {
            Arg::new(name)
                .long(name)
                .value_name(placeholder)
                .value_parser(choices.to_vec())
                .hide_possible_values(true)
                .help(help)
        };
    let flag = |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
    let words = Arg::new("words").num_args(0..).hide(true);
    let usage = format!("{program} [run|steady] [name=value ...] [flags]");
    clap::Command::new(M::NAME)
        .about(about::<M>())
        .override_usage(usage)
        .after_help(after_help::<M>())
        .arg(words)
        .arg(choice(
            "formulation",
            "NAME",
            &["rncf", "ancf"],
            "Coordinates: rncf (referenced, default) or ancf (absolute)",
        ))
        .arg(choice(
            "integrator",
            "METHOD",
            &["hht", "generalized-alpha", "radau"],
            "hht, generalized-alpha or radau (default)",
        ))
        .arg(value(
            "rtol",
            "NUMBER",
            "Tolerance, relative to the size of each kind of unknown (default 1e-6)",
        ))
        .arg(value("step", "TIME", "Fixed step, e.g. \"0.01 s\" (default: adaptive)"))
        .arg(value(
            "max-step",
            "TIME",
            "Ceiling of the adaptive step (default: none)",
        ))
        .arg(value(
            "alpha",
            "NUMBER",
            "Dissipation of hht, -1/3 to 0 (default -0.05)",
        ))
        .arg(value(
            "rho-inf",
            "NUMBER",
            "Dissipation of generalized-alpha, 0 to 1 (default 0.8)",
        ))
        .arg(flag(
            "stabilised",
            "Keep velocities on the constraints, too (index 2 after Gear, Gupta and Leimkuhler)",
        ))
        .arg(flag(
            "no-elimination",
            "Keep all joints as constraints with multipliers",
        ))
        .arg(choice(
            "start",
            "STATE",
            &["rest", "steady"],
            "rest (undeformed, default) or steady (in relative equilibrium with the spin at t = 0)",
        ))
        .arg(value(
            "t-end",
            "TIME",
            "End time; `steady`: time whose spin is reached (default: the model's)",
        ))
        .arg(value(
            "every",
            "TIME",
            "Time between two rows of the history (default: the model's)",
        ))
        .arg(
            value("out", "FOLDER", "Where the files go (default out/<example>)")
                .value_parser(clap::value_parser!(PathBuf))
                .allow_hyphen_values(false),
        )
        .arg(flag("quiet", "No progress and no summary"))
}

fn about<M: Model>() -> String {
    let doc = M::DOC.trim();
    if doc.is_empty() {
        M::NAME.into()
    } else {
        format!("{}: {doc}", M::NAME)
    }
}

fn after_help<M: Model>() -> String {
    let mut text = String::from(
        "Commands:\n  run     Integrate in time (default)\n  steady  Relative equilibria from rest to the spin at the end time\n",
    );
    let params = M::params();
    let rows = params
        .iter()
        .map(|p| [p.name.into(), in_unit(p, p.default), p.doc.into()]);
    text += &table("Parameters, with defaults:", rows.collect());
    let outputs = M::outputs();
    let unit = |o: &crate::Output| match o.components {
        [] => format!("[{}]", o.unit),
        components => format!("[{}] ({})", o.unit, components.join(", ")),
    };
    let rows = outputs.iter().map(|o| [o.name.into(), unit(o), o.doc.into()]);
    text += &table("Outputs:", rows.collect());
    let run = M::default().run();
    let (t_end, every) = (short(run.t_end), short(run.every));
    text += &format!("\nThe model runs to {t_end} s with a row every {every} s.");
    text
}

/// Lines of three columns under a title; nothing without rows.
fn table(title: &str, rows: Vec<[String; 3]>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (first, second) = (width(0), width(1));
    let mut text = format!("\n{title}\n");
    for [name, value, doc] in &rows {
        let doc = doc.split_whitespace().collect::<Vec<_>>().join(" ");
        let line = format!("  {name:first$}  {value:second$}  {doc}");
        text += line.trim_end();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    fn read(line: &[&str]) -> Result<Arguments<Rotor>, Refusal> {
        parse("rotor", line.iter().map(OsString::from))
    }

    fn mistake(line: &[&str]) -> String {
        match read(line) {
            Err(Refusal::Mistake(text)) => text,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn nothing_given_is_a_run_with_defaults() {
        let arguments = read(&[]).unwrap();
        assert_eq!(arguments.command, Command::Run);
        assert_eq!(arguments.settings, RunSettings::default());
        assert_eq!(arguments.out, PathBuf::from("out/rotor"));
        assert!(!arguments.quiet);
    }

    #[test]
    fn all_flags_are_read() {
        let line = "run omega=4rad/s --formulation ancf --integrator hht --alpha -0.3 --rtol 1e-7 --max-step 0.01s \
            --no-elimination --stabilised --start steady --t-end 2s --every 0.5s --out here --quiet coils=3";
        let arguments = read(&line.split_whitespace().collect::<Vec<_>>()).unwrap();
        assert_eq!((arguments.model.omega, arguments.model.coils), (4.0, 3));
        let expected = RunSettings {
            formulation: Formulation::Ancf,
            joints: Joints::Multipliers,
            start: Start::Steady,
            method: Method::Hht { alpha: -0.3 },
            options: Options {
                rtol: 1e-7,
                max_step: 0.01,
                stabilised: true,
                ..Options::default()
            },
            t_end: Some(2.0),
            every: Some(0.5),
        };
        assert_eq!(arguments.settings, expected);
        assert_eq!(arguments.out, PathBuf::from("here"));
        assert!(arguments.quiet);
        let fixed = read(&["--step", "5 ms", "--integrator", "generalized-alpha"])
            .unwrap()
            .settings;
        assert_eq!(fixed.options.step, StepSize::Fixed(5e-3));
        assert_eq!(fixed.method, Method::GeneralizedAlpha { rho_inf: 0.8 });
        assert_eq!(read(&["steady", "--t-end", "1 s"]).unwrap().command, Command::Steady);
    }

    #[test]
    fn flags_that_make_no_sense_together_are_refused() {
        let cases: [(&[&str], &str); 7] = [
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
                "`--every` belongs to `run`: `steady` does not advance in time",
            ),
            (
                &["steady", "--formulation", "ancf"],
                "`--formulation ancf` belongs to `run`: a relative equilibrium is one of referenced coordinates",
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
            mistake(&["--rtol", "1 s"]),
            "`--rtol 1 s`: a number without a unit is needed"
        );
    }

    #[test]
    fn mistyped_flags_and_choices_show_the_nearest() {
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
}
