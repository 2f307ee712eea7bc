//! The commands, what each takes, and the units in which frequencies are shown.

use super::parameters::digits;

/// What to do with a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Integrate in time.
    Run,
    /// Relative equilibria over the spin or a parameter.
    Steady,
    /// Modes about a relative equilibrium.
    Modes,
    /// Modes over the spin or a parameter.
    Campbell,
    /// Equilibria at rest over the load or a parameter.
    Static,
}

impl Command {
    /// All of them, as they stand in the help.
    pub(super) const ALL: [Command; 5] = [
        Command::Run,
        Command::Steady,
        Command::Modes,
        Command::Campbell,
        Command::Static,
    ];

    /// The word on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Command::Run => "run",
            Command::Steady => "steady",
            Command::Modes => "modes",
            Command::Campbell => "campbell",
            Command::Static => "static",
        }
    }

    /// The command of a word.
    pub(super) fn named(word: &str) -> Option<Command> {
        Self::ALL.into_iter().find(|command| command.name() == word)
    }

    /// What it does, for the help.
    pub(super) fn doc(self) -> &'static str {
        match self {
            Command::Run => "Integrate in time",
            Command::Steady => "Relative equilibria, the spin growing from rest, or along name=from..to",
            Command::Modes => "Frequencies, damping and whirl of small motions about the relative equilibrium",
            Command::Campbell => "Campbell diagram: modes over the spin, or along name=from..to; critical speeds",
            Command::Static => "Equilibria at rest, the loads growing from nothing, or along name=from..to; buckling",
        }
    }

    /// Whether it takes the flag; flags that no list names are for all.
    fn takes(self, flag: &str) -> bool {
        match flag {
            "integrator" | "rtol" | "step" | "max-step" | "alpha" | "rho-inf" | "start" | "every" | "t-end"
            | "stabilised" | "no-elimination" | "animate" | "vtu" => self == Command::Run,
            "steps" => matches!(self, Command::Steady | Command::Campbell | Command::Static),
            "at" => self != Command::Run,
            "spin" | "axis" => matches!(self, Command::Steady | Command::Modes | Command::Campbell),
            "modes" | "frequency" => matches!(self, Command::Modes | Command::Campbell),
            _ => true,
        }
    }

    /// Why the flag means nothing for this command; `None` where it does.
    pub(super) fn refusal(self, flag: &str) -> Option<String> {
        if self.takes(flag) {
            return None;
        }
        let owners: Vec<String> = Self::ALL
            .iter()
            .filter(|command| command.takes(flag))
            .map(|command| format!("`{}`", command.name()))
            .collect();
        let why = match (self, flag) {
            (Command::Run, _) => "a run in time looks for no equilibrium",
            (_, "no-elimination") => "equilibria eliminate all joints that they can",
            (_, "t-end") => "the time whose spin and loads hold is `--at`",
            (Command::Static, "spin" | "axis") => "nothing turns at rest",
            (_, "modes" | "frequency") => "it looks for no modes",
            (_, "steps") => "it takes one equilibrium",
            _ => "it does not advance in time",
        };
        let why = why.to_owned();
        let name = self.name();
        Some(format!(
            "`--{flag}` belongs to {}, not to `{name}`: {why}",
            owners.join(", ")
        ))
    }
}

/// Unit in which frequencies are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) enum Frequency {
    #[default]
    RadPerSecond,
    Hertz,
    Rpm,
}

impl Frequency {
    /// All names, as they are typed.
    pub const NAMES: [&'static str; 3] = ["rad/s", "Hz", "rpm"];

    pub fn named(name: &str) -> Frequency {
        match name {
            "Hz" => Frequency::Hertz,
            "rpm" => Frequency::Rpm,
            _ => Frequency::RadPerSecond,
        }
    }

    pub fn unit(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The value in this unit of a frequency in rad/s.
    pub fn of(self, frequency: f64) -> f64 {
        match self {
            Frequency::RadPerSecond => frequency,
            Frequency::Hertz => frequency / std::f64::consts::TAU,
            Frequency::Rpm => frequency * (30.0 / std::f64::consts::PI),
        }
    }

    /// The value with seven digits and the unit.
    pub fn shown(self, frequency: f64) -> String {
        format!("{} {}", digits(self.of(frequency), 7), self.unit())
    }
}
