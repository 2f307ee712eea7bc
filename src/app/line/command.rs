//! The commands, what each takes, and the units in which frequencies are shown.

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
    /// Error over work of formulations, meshes, methods and tolerances.
    Chart,
    /// The cheapest model that suffices.
    Advise,
    /// Many runs with other values of the parameters.
    Sweep,
    /// Values of the parameters at which a result is least, largest, or as it is wanted.
    Optimise,
    /// The plan of a sweep, without its runs.
    Plan,
    /// One run of a plan.
    Task,
    /// One table of all runs of a plan.
    Collect,
    /// What the model consists of.
    Explain,
}

impl Command {
    /// All of them, as they stand in the help.
    pub(in crate::app) const ALL: [Command; 13] = [
        Command::Run,
        Command::Steady,
        Command::Modes,
        Command::Campbell,
        Command::Static,
        Command::Chart,
        Command::Advise,
        Command::Sweep,
        Command::Optimise,
        Command::Plan,
        Command::Task,
        Command::Collect,
        Command::Explain,
    ];

    /// The word on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Command::Run => "run",
            Command::Steady => "steady",
            Command::Modes => "modes",
            Command::Campbell => "campbell",
            Command::Static => "static",
            Command::Chart => "chart",
            Command::Advise => "advise",
            Command::Sweep => "sweep",
            Command::Optimise => "optimise",
            Command::Plan => "plan",
            Command::Task => "task",
            Command::Collect => "collect",
            Command::Explain => "explain",
        }
    }

    /// The command of a word.
    pub(in crate::app) fn named(word: &str) -> Option<Command> {
        Self::ALL.into_iter().find(|command| command.name() == word)
    }

    /// What it does, for the help.
    pub(in crate::app) fn doc(self) -> &'static str {
        match self {
            Command::Run => "Integrate in time",
            Command::Steady => "Relative equilibria, the spin growing from rest, or along name=from..to",
            Command::Modes => "Frequencies, damping and whirl of small motions about the relative equilibrium",
            Command::Campbell => "Campbell diagram: modes over the spin, or along name=from..to; critical speeds",
            Command::Static => "Equilibria at rest, the loads growing from nothing, or along name=from..to; buckling",
            Command::Chart => {
                "Error over work of formulations, meshes (name=4,8,16), methods and tolerances; the cheapest for an accuracy"
            }
            Command::Advise => {
                "The cheapest description of the bodies, and mesh, that gives the outputs to a wanted accuracy"
            }
            Command::Sweep => {
                "Many runs: lists (name=a,b,c), ranges (name=from..to in 9), samples (name=normal(mean, deviation) --samples 100)"
            }
            Command::Optimise => {
                "Values in ranges (name=from..to) at which a result is least, largest or as wanted: --minimise, --maximise, --fit"
            }
            Command::Plan => "The plan of a sweep alone, for other programs to hand out its points",
            Command::Task => "One point of a plan: --plan plan.toml --index 3",
            Command::Collect => "One table, and pictures, of the points of a plan that are done",
            Command::Explain => {
                "Unknowns, conditions, constant tensors, functions with their operations, and what an evaluation costs here"
            }
        }
    }

    /// Whether it integrates in time.
    pub(in crate::app) fn runs(self) -> bool {
        matches!(self, Command::Run | Command::Chart | Command::Advise)
    }

    /// Whether it follows equilibria along a range of a parameter.
    pub(in crate::app) fn continues(self) -> bool {
        matches!(
            self,
            Command::Steady | Command::Campbell | Command::Static | Command::Modes
        )
    }

    /// Whether it lays out many runs.
    pub(in crate::app) fn sweeps(self) -> bool {
        matches!(self, Command::Sweep | Command::Optimise | Command::Plan)
    }

    /// Whether it tries several values of a parameter, `name=a,b,c`.
    pub(in crate::app) fn takes_lists(self) -> bool {
        matches!(self, Command::Chart | Command::Advise)
    }

    /// Whether it takes the flag; flags that no list names are for all.
    fn takes(self, flag: &str) -> bool {
        if matches!(self, Command::Task | Command::Collect) {
            let is_one = self == Command::Task && flag == "index";
            return is_one || matches!(flag, "plan" | "out" | "quiet" | "words");
        }
        match flag {
            "of" | "samples" | "design" | "seed" => self.sweeps(),
            "minimise" | "maximise" | "fit" | "most" => self == Command::Optimise,
            "plan" | "index" => false,
            "no-elimination" => self.runs() || self == Command::Explain,
            "start" | "every" | "t-end" | "stabilised" | "max-step" => self.runs(),
            "integrator" | "rtol" | "alpha" | "rho-inf" => matches!(self, Command::Run | Command::Advise),
            "fidelity" => matches!(self, Command::Run | Command::Explain),
            "step" | "proportional" | "animate" | "compare" | "vtu" | "resume" => self == Command::Run,
            "unjudged" | "thorough" => {
                matches!(
                    self,
                    Command::Run | Command::Steady | Command::Static | Command::Modes | Command::Campbell
                )
            }
            "out" | "save-scenario" | "at" if self == Command::Explain => false,
            "formulation" => self != Command::Chart,
            "formulations" | "integrators" | "rtols" | "reference" | "beside" => self == Command::Chart,
            "fresh" => self == Command::Chart || self.sweeps(),
            "wanted" => matches!(self, Command::Chart | Command::Advise),
            "outputs" if self == Command::Optimise => false,
            "outputs" | "limit" => matches!(self, Command::Chart | Command::Advise) || self.sweeps(),
            "steps" => matches!(self, Command::Steady | Command::Campbell | Command::Static),
            "at" => !self.runs() && !self.sweeps(),
            "spin" | "axis" => matches!(self, Command::Steady | Command::Modes | Command::Campbell),
            "export" => self == Command::Modes,
            "modes" | "frequency" => matches!(self, Command::Modes | Command::Campbell),
            _ => true,
        }
    }

    /// Why the flag means nothing for this command; `None` where it does. `of` is what the points of a sweep compute,
    /// and the command itself otherwise.
    pub(in crate::app) fn refusal(self, of: Command, flag: &str) -> Option<String> {
        let is_of_many = matches!(flag, "animate" | "compare" | "vtu" | "resume" | "frequency" | "export");
        if self.takes(flag) || self.sweeps() && of.takes(flag) && !is_of_many {
            return None;
        }
        let owners: Vec<String> = Self::ALL
            .iter()
            .filter(|command| command.takes(flag))
            .map(|command| format!("`{}`", command.name()))
            .collect();
        let why = match (self, flag) {
            (Command::Task | Command::Collect, _) => "what is computed stands in the plan",
            (Command::Explain, _) => "it integrates nothing and writes no files",
            (_, "minimise" | "maximise" | "fit" | "most") => "it looks for no optimum",
            (Command::Optimise, "outputs") => "what counts stands behind `--minimise`, `--maximise` or `--fit`",
            (_, "of" | "samples" | "design" | "seed") => "it computes one point",
            (_, "plan" | "index") => "its params and settings stand on its line, or in a file named by `--scenario`",
            (_, "animate" | "compare" | "vtu" | "resume" | "frequency" | "export") if self.sweeps() => {
                "it computes many points"
            }
            (_, _) if self.sweeps() && of.runs() => "its points are runs in time (`--of`)",
            (_, _) if self.sweeps() => "its points do not advance in time (`--of`)",
            (
                _,
                "formulations" | "integrators" | "rtols" | "reference" | "beside" | "outputs" | "wanted" | "fresh"
                | "limit",
            ) => "it compares no runs",
            (Command::Chart, "formulation" | "integrator" | "rtol" | "alpha" | "rho-inf") => {
                "give lists, `--formulations`, `--integrators` or `--rtols`"
            }
            (_, "export") => "it looks for no modes",
            (Command::Chart, "resume") => "the same command goes on by itself where it was ended",
            (_, "resume") => "only a run leaves a checkpoint",
            (
                Command::Chart | Command::Advise,
                "step" | "proportional" | "animate" | "compare" | "vtu" | "fidelity" | "unjudged" | "thorough",
            ) => "it compares many runs",
            (Command::Run | Command::Chart | Command::Advise, _) => "a run in time looks for no equilibrium",
            (_, "no-elimination") => "equilibria eliminate all joints that they can",
            (_, "t-end") => "the time whose spin and loads hold is `--at`",
            (Command::Static, "spin" | "axis") => "nothing turns at rest",
            (_, "fidelity") => "equilibria take the bodies as they are declared",
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
