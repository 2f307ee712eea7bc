//! The command line: `[command] [name=value ...] [flags]`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches};

use super::advise::{self, AdviseSettings};
use super::chart::{self, ChartSettings};
use super::command::{Command, Frequency};
use super::help::{about, after_help};
use super::parameters::{List, Values, Varied, angular_velocity, assign, instant, time};
use super::plan::{self, PlanSettings};
use super::run::RunSettings;
use super::scenario::{self, Scenario};
use super::sweep::{Range, SweepSettings};
use crate::equilibrium::Spin;
use crate::model::Fidelity;
use crate::{AnyModel, Formulation, Joints, Method, Options, Start, StepSize};

/// A command line that makes sense.
pub(super) struct Arguments {
    pub command: Command,
    model: Box<dyn AnyModel>,
    pub settings: RunSettings,
    pub sweep: SweepSettings,
    pub chart: ChartSettings,
    pub advise: AdviseSettings,
    pub plan: PlanSettings,
    /// Parameters of which several values are tried.
    pub lists: Vec<List>,
    pub frequency: Frequency,
    pub out: PathBuf,
    /// What the line, and a scenario file below it, say.
    pub scenario: Scenario,
    /// Where that is kept.
    pub saved: Option<PathBuf>,
    /// The words behind the program's name that make the result from its beginning, quoted where a shell needs it.
    pub line: String,
    pub quiet: bool,
    /// Whether the run in the folder goes on.
    pub resume: bool,
    /// Whether an animation is written.
    pub animate: bool,
    /// Whether files for ParaView are written.
    pub vtu: bool,
}

impl Arguments {
    /// The model with the parameters of the line.
    pub fn model(&self) -> &dyn AnyModel {
        self.model.as_ref()
    }
}

/// Why there is nothing to run.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Refusal {
    /// Help was asked for.
    Help(String),
    /// A mistake, with what would be right.
    Mistake(String),
}

/// What a program says of itself: its name, what it does by default, and the choice of its models.
#[derive(Clone, Debug)]
pub(super) struct Program<'p> {
    /// The example's name, for the usage.
    pub name: &'p str,
    pub default: Command,
    /// More help at the end; empty: none.
    pub more: &'p str,
    /// Folder of the files.
    pub out: PathBuf,
}

/// Reads the words after the program's name.
///
/// # Errors
/// [`Refusal`].
pub(super) fn parse(
    model: &dyn AnyModel,
    program: &Program<'_>,
    words: impl IntoIterator<Item = OsString>,
) -> Result<Arguments, Refusal> {
    let words: Vec<OsString> = words.into_iter().collect();
    let line = command_line(model, program);
    let matches = matched(&line, program, words.clone())?;
    let given = Scenario::of_line(&line, &matches);
    let mistaken = Refusal::Mistake;
    if let Some(command @ (Command::Task | Command::Collect)) = given.command {
        return planned(model, program, command, &matches).map_err(mistaken);
    }
    let Some(path) = matches.get_one::<PathBuf>("scenario") else {
        let anew = words.iter().filter(|word| *word != "--resume");
        let told = anew.map(|word| quoted(&word.to_string_lossy())).collect::<Vec<_>>();
        return read(model, program, (told.join(" "), given), &matches).map_err(mistaken);
    };
    let merged = scenario::read(path, model, &line).map_err(mistaken)?.under(given);
    // Words that are no params are left for the reader, which says what is wrong with them.
    let strays = matches.get_many::<String>("words").into_iter().flatten();
    let strays = strays.filter(|word| !word.contains('=') && Command::named(word).is_none());
    let inner: Vec<OsString> = merged
        .words()
        .into_iter()
        .chain(strays.cloned())
        .map(OsString::from)
        .collect();
    let told = inner
        .iter()
        .map(|word| quoted(&word.to_string_lossy()))
        .collect::<Vec<_>>();
    let within = matched(&line, program, inner.clone())?;
    let mut arguments = read(model, program, (told.join(" "), merged), &within).map_err(mistaken)?;
    outer(&mut arguments, program, &matches);
    Ok(arguments)
}

fn matched(line: &clap::Command, program: &Program<'_>, words: Vec<OsString>) -> Result<ArgMatches, Refusal> {
    let words = std::iter::once(program.name.into()).chain(words);
    line.clone()
        .try_get_matches_from(words)
        .map_err(|error| match error.kind() {
            clap::error::ErrorKind::DisplayHelp | clap::error::ErrorKind::DisplayVersion => {
                Refusal::Help(error.to_string())
            }
            _ => Refusal::Mistake(error.to_string().trim_start_matches("error: ").trim_end().into()),
        })
}

/// `task` or `collect`: everything but the place of the files stands in the plan.
fn planned(
    model: &dyn AnyModel,
    program: &Program<'_>,
    command: Command,
    matches: &ArgMatches,
) -> Result<Arguments, String> {
    refuse(command, command, matches)?;
    let name = command.name();
    if let Some(word) = matches.get_many::<String>("words").into_iter().flatten().nth(1) {
        return Err(format!("`{word}`: `{name}` takes no params, they stand in the plan"));
    }
    let Some(path) = text(matches, "plan") else {
        return Err(format!(
            "`{name}` needs the plan: `--plan plan.toml`, which `plan` and `sweep` write"
        ));
    };
    let line = command_line(model, program);
    let scenario = scenario::read(path.as_ref(), model, &line)?;
    if scenario.command != Some(Command::Sweep) {
        return Err(format!("{path}: this is no plan; write `command = \"sweep\"`"));
    }
    let words: Vec<OsString> = scenario.words().into_iter().map(OsString::from).collect();
    let told = format!("{name} --plan {}", quoted(path));
    let inner = matched(&line, program, words).map_err(|refusal| match refusal {
        Refusal::Help(text) | Refusal::Mistake(text) => format!("{path}: {text}"),
    })?;
    let mut arguments = read(model, program, (told, scenario), &inner)?;
    outer(&mut arguments, program, matches);
    arguments.command = command;
    arguments.plan.index = plan::settings(model, matches, Vec::new(), program.default)?.index;
    Ok(arguments)
}

/// Where things go, from the line itself.
fn outer(arguments: &mut Arguments, program: &Program<'_>, matches: &ArgMatches) {
    let out = matches.get_one::<PathBuf>("out").cloned();
    arguments.out = out.unwrap_or_else(|| program.out.clone());
    arguments.saved = matches.get_one::<PathBuf>("save-scenario").cloned();
    arguments.quiet = matches.get_flag("quiet");
    arguments.resume = matches.get_flag("resume");
}

/// A word as a shell reads it back.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_=./:,+%@".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

/// The arguments of matched words; `told` is the line in one text, and what it says.
fn read(
    model: &dyn AnyModel,
    program: &Program<'_>,
    (line, scenario): (String, Scenario),
    matches: &ArgMatches,
) -> Result<Arguments, String> {
    let mut words: Vec<String> = matches.get_many("words").into_iter().flatten().cloned().collect();
    let command = words.first().and_then(|word| Command::named(word));
    if command.is_some() {
        words.remove(0);
    }
    let mut model = model.boxed();
    let varied = assign(model.as_mut(), &words)?;
    let command = command.unwrap_or(program.default);
    let plan = plan::settings(model.as_ref(), matches, varied.clone(), program.default)?;
    refuse(command, if command.sweeps() { plan.of } else { command }, matches)?;
    let (range, lists) = if command.sweeps() {
        (None, Vec::new())
    } else {
        several(command, model.as_ref(), varied)?
    };
    let mut arguments = Arguments {
        command,
        settings: settings(matches)?,
        sweep: SweepSettings {
            range,
            ..sweep(matches)?
        },
        chart: chart::settings(model.as_ref(), matches)?,
        advise: advise::settings(model.as_ref(), matches)?,
        plan,
        model,
        lists,
        frequency: text(matches, "frequency").map_or_else(Frequency::default, Frequency::named),
        out: PathBuf::new(),
        scenario,
        saved: None,
        line,
        quiet: false,
        resume: false,
        animate: matches.get_flag("animate"),
        vtu: matches.get_flag("vtu"),
    };
    outer(&mut arguments, program, matches);
    Ok(arguments)
}

/// The range that is continued, and the lists that are tried.
fn several(command: Command, model: &dyn AnyModel, varied: Vec<Varied>) -> Result<(Option<Range>, Vec<List>), String> {
    let (mut continued, mut lists): (Option<Range>, Vec<List>) = (None, Vec::new());
    for Varied { param, values } in varied {
        let (name, word) = (model.params()[param].name, command.name());
        match values {
            Values::Normal(..) | Values::Range(_, _, Some(_)) => {
                return Err(format!(
                    "`{name}` is given many values, which `{word}` does not take: use sweep"
                ));
            }
            Values::List(_) if !command.takes_lists() => {
                return Err(format!(
                    "`{name}` is given as a list, which `{word}` does not take: give one value, or use sweep, chart or advise"
                ));
            }
            Values::List(values) => lists.push(List { param, values }),
            Values::Range(..) if !command.continues() => {
                return Err(format!(
                    "`{name}` is given as a range, which `{word}` does not take: give one value, or use steady, campbell, static or sweep"
                ));
            }
            Values::Range(from, to, None) => {
                let range = Range { param, from, to };
                if let Some(first) = continued.replace(range) {
                    let first = model.params()[first.param].name;
                    return Err(format!(
                        "`{first}` and `{name}` are both given as ranges: one parameter is continued at a time"
                    ));
                }
            }
        }
    }
    Ok((continued, lists))
}

/// Refuses flags that mean nothing for the command.
fn refuse(command: Command, of: Command, matches: &ArgMatches) -> Result<(), String> {
    for id in matches.ids() {
        let flag = id.as_str();
        let is_given = matches.value_source(flag) == Some(clap::parser::ValueSource::CommandLine);
        if let (true, Some(refusal)) = (is_given, command.refusal(of, flag)) {
            return Err(refusal);
        }
    }
    if !of.runs() && text(matches, "formulation") == Some("ancf") {
        return Err(
            "`--formulation ancf` belongs to `run`: an equilibrium is one of referenced coordinates, with the same result"
                .into(),
        );
    }
    Ok(())
}

/// Settings of equilibria and modes; the parameter that is continued is not read here.
fn sweep(matches: &ArgMatches) -> Result<SweepSettings, String> {
    let defaults = SweepSettings::default();
    let whole = |name: &str, most: usize| {
        let read = |text: &str| match text.parse::<usize>() {
            Ok(count) if (1..=most).contains(&count) => Ok(count),
            _ => Err(format!("`--{name} {text}`: a whole number from 1 to {most} is needed")),
        };
        text(matches, name).map(read).transpose()
    };
    let at = text(matches, "at")
        .map(|text| instant("--at", text, "2 s"))
        .transpose()?;
    let spin = text(matches, "spin").map(|text| angular_velocity("--spin", text, "4 rad/s"));
    let axis = text(matches, "axis");
    let spin = match (spin.transpose()?, axis) {
        (None, None) => None,
        (None, Some(axis)) => {
            return Err(format!(
                "`--axis {axis}` says about which axis `--spin` turns: give both"
            ));
        }
        (Some(spin), axis) => {
            let index = ["x", "y", "z"].iter().position(|name| Some(*name) == axis).unwrap_or(2);
            let mut velocity = [0.0; 3];
            velocity[index] = spin;
            Some(Spin {
                velocity,
                point: [0.0; 3],
            })
        }
    };
    Ok(SweepSettings {
        at,
        steps: whole("steps", 100_000)?.map_or(defaults.steps, |steps| steps as u32),
        count: whole("modes", 1000)?.unwrap_or(defaults.count),
        spin,
        range: None,
    })
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
    let proportional = matches.get_flag("proportional");
    if step.is_some() && proportional {
        return Err(
            "`--proportional` rescales the tolerance of the adaptive step; `--step` fixes the step: give one of them"
                .into(),
        );
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
        fidelity: fidelity(matches)?,
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
            proportional,
            ..Options::default()
        },
        t_end: flag_time("t-end", "20 s")?,
        every: flag_time("every", "0.05 s")?,
        pictures: matches.get_flag("animate") || matches.get_flag("vtu"),
    })
}

/// `rod=rigid,beam=modal(3)`
fn fidelity(matches: &ArgMatches) -> Result<Vec<(String, Fidelity)>, String> {
    let Some(text) = text(matches, "fidelity") else {
        return Ok(Vec::new());
    };
    let one = |part: &str| {
        let (name, word) = part
            .split_once('=')
            .ok_or_else(|| format!("`--fidelity {part}`: write `body=description`, e.g. `--fidelity rod=rigid`"))?;
        let fidelity = Fidelity::named(word.trim()).map_err(|mistake| format!("`--fidelity {part}`: {mistake}"))?;
        Ok((name.trim().to_owned(), fidelity))
    };
    text.split(',').map(one).collect()
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
        "energy" => Method::EnergyMomentum,
        _ => Method::Radau,
    })
}

pub(super) fn text<'m>(matches: &'m ArgMatches, name: &str) -> Option<&'m str> {
    matches.get_one::<String>(name).map(String::as_str)
}

pub(super) fn number(matches: &ArgMatches, name: &str) -> Result<Option<f64>, String> {
    let read = |text: &str| match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`--{name} {text}`: a number without a unit is needed")),
    };
    text(matches, name).map(read).transpose()
}

/// The words that a program of the model understands.
pub(super) fn command_line(model: &dyn AnyModel, program: &Program<'_>) -> clap::Command {
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
    let names = Command::ALL.map(Command::name).join("|");
    let usage = format!("{} [{names}] [name=value ...] [name=from..to] [flags]", program.name);
    clap::Command::new(model.name())
        .version(concat!("of rncf ", env!("CARGO_PKG_VERSION")))
        .about(about(model))
        .override_usage(usage)
        .after_help(after_help(model, program.default, program.more))
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
            &["hht", "generalized-alpha", "radau", "energy"],
            "hht, generalized-alpha, radau (default) or energy (conserves it; ANCF)",
        ))
        .arg(value(
            "rtol",
            "NUMBER",
            "Tolerance, relative to the size of each kind of unknown (default 1e-6)",
        ))
        .arg(flag(
            "proportional",
            "Rescale the tolerance so that the error of the result, not of a step, is proportional to it",
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
        .arg(value(
            "fidelity",
            "BODY=HOW,..",
            "Describe bodies otherwise than declared: point, rigid, modal(4), small(4) or full, e.g. rod=rigid",
        ))
        .arg(choice(
            "start",
            "STATE",
            &["rest", "steady"],
            "rest (undeformed, default) or steady (in relative equilibrium with the spin at t = 0)",
        ))
        .arg(value("t-end", "TIME", "End time (default: the model's)"))
        .arg(value(
            "every",
            "TIME",
            "Time between two rows of the history (default: the model's)",
        ))
        .arg(value(
            "at",
            "TIME",
            "Time whose spin and loads hold in an equilibrium (default: the model's end time)",
        ))
        .arg(value(
            "steps",
            "NUMBER",
            "Continuation steps of steady, campbell and static (default 32)",
        ))
        .arg(value(
            "spin",
            "SPEED",
            "Rotation where nothing turns in a prescribed way, e.g. \"4 rad/s\" (default: the declared start's)",
        ))
        .arg(choice(
            "axis",
            "AXIS",
            &["x", "y", "z"],
            "Axis of `--spin`, through the origin: x, y or z (default)",
        ))
        .arg(value("modes", "NUMBER", "Number of modes, the lowest ones (default 8)"))
        .arg(choice(
            "frequency",
            "UNIT",
            &Frequency::NAMES,
            "Unit in which frequencies are shown: rad/s (default), Hz or rpm; files are in rad/s",
        ))
        .arg(
            value("out", "FOLDER", "Where the files go (default out/<example>)")
                .value_parser(clap::value_parser!(PathBuf))
                .allow_hyphen_values(false),
        )
        .arg(
            value(
                "scenario",
                "FILE",
                "Params and settings from a file of TOML; what stands on the line comes before it",
            )
            .value_parser(clap::value_parser!(PathBuf))
            .allow_hyphen_values(false),
        )
        .arg(
            value(
                "save-scenario",
                "FILE",
                "Keep the params and settings of this line in such a file",
            )
            .value_parser(clap::value_parser!(PathBuf))
            .allow_hyphen_values(false),
        )
        .arg(flag(
            "resume",
            "Go on with the run in the folder that was ended before its time, with the same result",
        ))
        .arg(flag(
            "animate",
            "Write animation.html: the bodies over time, in any browser",
        ))
        .arg(flag("vtu", "Write paraview.pvd: the bodies over time, for ParaView"))
        .args(chart::flags())
        .args(advise::flags())
        .args(plan::flags())
        .arg(flag("quiet", "No progress and no summary"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

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
        assert_eq!(arguments.settings, RunSettings::default());
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
        assert_eq!([0, 1].map(|index| arguments.model.get(index)), [4.0, 3.0]);
        let expected = RunSettings {
            formulation: Formulation::Ancf,
            joints: Joints::Multipliers,
            fidelity: vec![("rod".into(), Fidelity::Rigid), ("beam".into(), Fidelity::Modal(3))],
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
            pictures: false,
        };
        assert_eq!(arguments.settings, expected);
        assert_eq!(arguments.out, PathBuf::from("here"));
        assert!(arguments.quiet);
        let fixed = read(&["--step", "5 ms", "--integrator", "generalized-alpha"])
            .unwrap()
            .settings;
        assert_eq!(fixed.options.step, StepSize::Fixed(5e-3));
        assert_eq!(fixed.method, Method::GeneralizedAlpha { rho_inf: 0.8 });
        assert!(!fixed.options.proportional && read(&["--proportional"]).unwrap().settings.options.proportional);
        let line = "campbell omega=0..60rpm --at 1s --steps 7 --modes 5 --frequency Hz --spin 2rad/s --axis x";
        let arguments = read(&line.split_whitespace().collect::<Vec<_>>()).unwrap();
        assert_eq!(
            (arguments.command, arguments.frequency),
            (Command::Campbell, Frequency::Hertz)
        );
        let sweep = arguments.sweep;
        assert_eq!((sweep.at, sweep.steps, sweep.count), (Some(1.0), 7, 5));
        assert_eq!(sweep.spin.unwrap().velocity, [2.0, 0.0, 0.0]);
        assert_eq!(sweep.range.map(|range| (range.param, range.from)), Some((0, 0.0)));
    }

    #[test]
    fn flags_that_make_no_sense_together_are_refused() {
        let cases: [(&[&str], &str); 13] = [
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
                &["modes", "--axis", "x"],
                "`--axis x` says about which axis `--spin` turns: give both",
            ),
            (
                &["omega=1..2 rad/s"],
                "`omega` is given as a range, which `run` does not take: give one value, or use steady, campbell, static or sweep",
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
