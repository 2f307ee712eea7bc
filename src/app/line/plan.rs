//! What a plan is asked for: which points, what each computes, and what is looked for.

use clap::{Arg, ArgMatches};

use super::chart;
use super::command::Command;
use super::goal::Goal;
use super::parameters::{Varied, time};
use super::words::{text, value};
use crate::AnyModel;

/// What is asked of a plan.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct PlanSettings {
    /// What each point computes: `run`, `static`, `steady` or `modes`.
    pub of: Command,
    pub design: Design,
    pub seed: u64,
    /// In the order of the model.
    pub varied: Vec<Varied>,
    /// Columns of the history that stand in the table; `None`: all.
    pub outputs: Option<Vec<usize>>,
    /// Processor time after which a point is ended, s.
    pub limit: f64,
    /// Whether points are computed anew.
    pub is_fresh: bool,
    /// The point that `task` computes.
    pub index: Option<usize>,
    /// What `optimise` looks for.
    pub goal: Option<Goal>,
    /// Most points of `optimise`.
    pub most: Option<usize>,
}

/// How points are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Design {
    /// Every value of each parameter with every value of the others; the model's last one changes fastest.
    Grid,
    /// So many points that of each parameter every one of as many equally likely parts holds one (Latin hypercube).
    Latin(usize),
    /// So many independent points.
    Random(usize),
}

/// The flags of plans; `--outputs`, `--limit` and `--fresh` are those of `chart`, too.
pub(in crate::app) fn flags() -> Vec<Arg> {
    let value = |name, placeholder, help| value(name, placeholder, help).allow_hyphen_values(false);
    let choice =
        |arg: Arg, choices: &'static [&'static str]| arg.value_parser(choices.to_vec()).hide_possible_values(true);
    vec![
        choice(
            value(
                "of",
                "COMMAND",
                "What each point of a sweep computes: run, static, steady or modes (default: what the program does without a command)",
            ),
            &["run", "static", "steady", "modes"],
        ),
        value(
            "samples",
            "NUMBER",
            "Points drawn from ranges and distributions (default: a grid of all values)",
        ),
        choice(
            value(
                "design",
                "NAME",
                "How they are drawn: latin (one in every equally likely part, default) or random",
            ),
            &["latin", "random"],
        ),
        value("seed", "NUMBER", "Another number draws other points (default 0)"),
        value(
            "minimise",
            "RESULT",
            "What optimise makes small, e.g. \"tip.x max\": an output with last (default), min or max, \"mode 1 im\" or growth",
        ),
        value("maximise", "RESULT", "What optimise makes large"),
        value(
            "fit",
            "RESULT=VALUE,..",
            "What optimise brings near to values, e.g. \"tip.x max=3 m\": the sum of squared relative differences",
        )
        .allow_hyphen_values(true),
        value(
            "most",
            "NUMBER",
            "Points after which optimise gives up (default: the first ones and 200 for each parameter)",
        ),
        value("plan", "FILE", "The plan.toml of a sweep, for task and collect"),
        value("index", "NUMBER", "The point that task computes, from 0 on"),
    ]
}

/// Reads the flags; `default` is the command of a line without one.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn settings(
    model: &dyn AnyModel,
    matches: &ArgMatches,
    mut varied: Vec<Varied>,
    default: Command,
) -> Result<PlanSettings, String> {
    // A line and a file that say the same in another order make the same plan.
    varied.sort_by_key(|one| one.param);
    let whole = |name: &str| {
        let read = |text: &str| {
            let wanted = || format!("`--{name} {text}`: a whole number is needed");
            text.parse::<u64>().map_err(|_| wanted())
        };
        text(matches, name).map(read).transpose()
    };
    let design = match (whole("samples")?, text(matches, "design")) {
        (Some(count), _) if !(2..=1_000_000).contains(&count) => {
            return Err(format!(
                "`--samples {count}`: a whole number from 2 to 1000000 is needed"
            ));
        }
        (Some(count), Some("random")) => Design::Random(count as usize),
        (Some(count), _) => Design::Latin(count as usize),
        (None, Some(name)) => {
            return Err(format!(
                "`--design {name}` draws points: say with `--samples 100` how many"
            ));
        }
        (None, None) => Design::Grid,
    };
    let of = match text(matches, "of").and_then(Command::named).unwrap_or(default) {
        of @ (Command::Static | Command::Steady | Command::Modes) => of,
        _ => Command::Run,
    };
    Ok(PlanSettings {
        of,
        design,
        seed: whole("seed")?.unwrap_or(0),
        varied,
        outputs: chart::outputs(model, matches)?,
        limit: match text(matches, "limit") {
            Some(given) => time("--limit", given, "60 s")?,
            None => f64::INFINITY,
        },
        is_fresh: chart::fresh(matches),
        index: whole("index")?.map(|index| index as usize),
        goal: Goal::read(model, matches, of)?,
        most: whole("most")?.map(|most| most as usize),
    })
}
