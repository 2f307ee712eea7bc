//! The words that a program understands: commands, params and flags, with their help.

use std::path::PathBuf;

use clap::{Arg, ArgAction};

use super::command::Command;
use super::help::{about, after_help};
use super::program::Program;
use super::words::value;
use super::{chart, plan};
use crate::app::writing::frequency::Frequency;
use crate::{AnyModel, Method, Start};

/// Names of the methods of integration.
static METHODS: [&str; Method::ALL.len()] = {
    let mut names = [""; Method::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = Method::ALL[at].name();
        at += 1;
    }
    names
};

/// Names of the starts of a run.
static STARTS: [&str; Start::ALL.len()] = {
    let mut names = [""; Start::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = Start::ALL[at].name();
        at += 1;
    }
    names
};

/// The words that a program of the model understands.
pub(in crate::app) fn command_line(model: &dyn AnyModel, program: &Program<'_>) -> clap::Command {
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
            &METHODS,
            "radau (default), radau9 and radau13 (of higher order, for tight tolerances), hht, generalized-alpha or energy (conserves it; ANCF)",
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
        .arg(flag(
            "unjudged",
            "Do not repeat a run on finer meshes and with other steps, nor equilibria and modes on finer meshes, to tell what they are off by",
        ))
        .arg(
            flag(
                "thorough",
                "Compare all of a run or way with finer meshes and other steps, however long that takes",
            )
            .conflicts_with("unjudged"),
        )
        .arg(value(
            "fidelity",
            "BODY=HOW,..",
            "Describe bodies otherwise than declared: point, rigid, modal(4), small(4) or full, e.g. rod=rigid",
        ))
        .arg(choice(
            "start",
            "STATE",
            &STARTS,
            "rest (undeformed), moving (with the velocities that joints and drives ask for) or steady (in relative equilibrium with the spin at t = 0); default: the model's",
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
        .arg(value("modes", "NUMBER", "Number of modes, the lowest ones; those that grow are shown beside them (default 8)"))
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
        .arg(
            value(
                "compare",
                "FOLDER",
                "Another run whose curves and differences the report shows beside: its folder, or its history.csv",
            )
            .value_parser(clap::value_parser!(PathBuf))
            .allow_hyphen_values(false),
        )
        .arg(flag("vtu", "Write paraview.pvd: the bodies over time, for ParaView"))
        .arg(flag(
            "export",
            "Write BODY.npz for each body in modes: nodes, modes and invariants, which `import` reads",
        ))
        .args(chart::flags())
        .args(plan::flags())
        .arg(flag("quiet", "No progress and no summary"))
}
