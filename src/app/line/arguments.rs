//! The command line: `[command] [name=value ...] [flags]`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::ArgMatches;

use super::advise::{self, AdviseSettings};
use super::chart::{self, ChartSettings};
use super::command::Command;
use super::flags::command_line;
use super::parameters::{List, Values, Varied, angular_velocity, assign, instant, time};
use super::plan::{self, PlanSettings};
use super::program::Program;
use super::scenario::{self, Scenario};
use super::words::{number, quoted, text};
use crate::app::judged::finer::Judging;
use crate::app::results::equilibria::{EquilibriumSettings, Range};
use crate::app::results::run::RunSettings;
use crate::app::writing::frequency::Frequency;
use crate::equilibrium::Spin;
use crate::model::Fidelity;
use crate::space::Vector;
use crate::{AnyModel, Formulation, Joints, Method, Options, Start, StepSize};

/// A command line that makes sense.
pub(in crate::app) struct Arguments {
    pub command: Command,
    model: Box<dyn AnyModel>,
    pub settings: RunSettings,
    pub equilibrium: EquilibriumSettings,
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
    /// Another run to be shown beside.
    pub compare: Option<PathBuf>,
    /// Whether files for ParaView are written.
    pub vtu: bool,
    /// Whether bodies in modes are written as arrays.
    pub export: bool,
}

impl Arguments {
    /// The model with the parameters of the line.
    pub fn model(&self) -> &dyn AnyModel {
        self.model.as_ref()
    }
}

/// Why there is nothing to run.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) enum Refusal {
    /// Help was asked for.
    Help(String),
    /// A mistake, with what would be right.
    Mistake(String),
}

/// Reads the words after the program's name.
///
/// # Errors
/// [`Refusal`].
pub(in crate::app) fn parse(
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
        .map_err(|mut error| match error.kind() {
            clap::error::ErrorKind::DisplayHelp | clap::error::ErrorKind::DisplayVersion => {
                Refusal::Help(error.to_string())
            }
            _ => {
                // No flag is meant as a param: the tip to write `-- --flag` only leads on.
                error.remove(clap::error::ContextKind::Suggested);
                Refusal::Mistake(error.to_string().trim_start_matches("error: ").trim_end().into())
            }
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
        equilibrium: EquilibriumSettings {
            range,
            ..equilibrium(matches)?
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
        compare: matches.get_one::<PathBuf>("compare").cloned(),
        vtu: matches.get_flag("vtu"),
        export: matches.get_flag("export"),
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
                    "`{name}` is given as a range, which `{word}` does not take: give one value, or use steady, campbell, static, sweep or optimise"
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
    if !of.runs() && of != Command::Explain && text(matches, "formulation") == Some("ancf") {
        return Err(
            "`--formulation ancf` belongs to `run`: an equilibrium is one of referenced coordinates, with the same result"
                .into(),
        );
    }
    Ok(())
}

/// Settings of equilibria and modes; the parameter that is continued is not read here.
fn equilibrium(matches: &ArgMatches) -> Result<EquilibriumSettings, String> {
    let defaults = EquilibriumSettings::default();
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
            Some(Spin {
                velocity: Vector::ith(index, spin),
                point: Vector::zeros(),
            })
        }
    };
    Ok(EquilibriumSettings {
        at,
        steps: whole("steps", 100_000)?.map_or(defaults.steps, |steps| steps as u32),
        count: whole("modes", 1000)?.unwrap_or(defaults.count),
        spin,
        range: None,
        judged: judging(matches),
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
        start: text(matches, "start").and_then(|named| Start::ALL.into_iter().find(|start| start.name() == named)),
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
        judged: judging(matches),
    })
}

fn judging(matches: &ArgMatches) -> Judging {
    match (matches.get_flag("unjudged"), matches.get_flag("thorough")) {
        (true, _) => Judging::No,
        (_, true) => Judging::Whole,
        _ => Judging::Affordable,
    }
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
    let name = text(matches, "integrator").unwrap_or(Method::ALL[0].name());
    let mut method = Method::named(name).unwrap_or(Method::ALL[0]);
    for other in Method::ALL {
        let Some(own) = other.parameter() else { continue };
        let flag = own.name.replace('_', "-");
        let Some(value) = number(matches, &flag)? else {
            continue;
        };
        if other.name() != name {
            return Err(format!(
                "`--{flag}` belongs to `--integrator {}`; this run uses {name}",
                other.name()
            ));
        }
        if !own.allows(value) {
            let [low, high] = own.bounds();
            return Err(format!(
                "`--{flag} {value}`: {} lies between {low} and {high}, e.g. `--{flag} {}`",
                own.meaning, own.value
            ));
        }
        method = method.with(value);
    }
    Ok(method)
}

#[cfg(test)]
mod tests;
