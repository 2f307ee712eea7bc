//! Entries of programs: the words of the process, the choice among models, and the exit code.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::app::commands::execute::execute;
use crate::app::judged::doubts::doubts;
use crate::app::line::arguments::{Refusal, parse};
use crate::app::line::command::Command;
use crate::app::line::program::Program;
use crate::app::results::failure::{Failure, INTERRUPTION, MISTAKE};
use crate::nearest::nearest;
use crate::{AnyModel, Model};

/// Set by Ctrl-C, or another signal that asks for the end; the work ends after its step, and its files are written.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Set while the files of an ended work are written: nothing interrupts that.
static IS_WRITING: AtomicBool = AtomicBool::new(false);

/// The words of a program and what it says of itself.
#[derive(Clone, Debug)]
pub struct Line {
    program: String,
    words: Vec<OsString>,
    default: Command,
    more: String,
    out: PathBuf,
}

/// What a program does with its line: [`enter`] for a model.
pub type Entry = fn(Line) -> ExitCode;

impl Line {
    /// The words of this process; without a command `default` is meant.
    pub fn of_process(default: Command) -> Self {
        let mut words = std::env::args_os();
        let path = words.next().unwrap_or_default();
        let program = match Path::new(&path).file_stem() {
            Some(stem) => stem.to_string_lossy().into_owned(),
            None => "model".into(),
        };
        Self::new(&program, words, default)
    }

    /// Words that a program has from elsewhere, without its name; its files go to the folder `out/` of the name.
    pub fn new(program: &str, words: impl IntoIterator<Item = impl Into<OsString>>, default: Command) -> Self {
        Self {
            program: program.into(),
            words: words.into_iter().map(Into::into).collect(),
            default,
            more: String::new(),
            out: PathBuf::from("out").join(program),
        }
    }

    /// Takes `--flag NAME` out of the words: the index of its name among `names`, the first one without it.
    fn choose(&mut self, flag: &str, names: &[&str]) -> Result<usize, String> {
        let long = format!("--{flag}");
        let all = names.join(", ");
        let mut given: Vec<String> = Vec::new();
        let mut kept = Vec::new();
        let mut words = std::mem::take(&mut self.words).into_iter();
        while let Some(word) = words.next() {
            let text = word.to_string_lossy().into_owned();
            if text == long {
                let name = words.next().map(|name| name.to_string_lossy().into_owned());
                given.push(name.ok_or_else(|| format!("`{long}` needs a name: {all}"))?);
            } else if let Some(name) = text.strip_prefix(&format!("{long}=")) {
                given.push(name.into());
            } else {
                kept.push(word);
            }
        }
        self.words = kept;
        let index = match &given[..] {
            [] => 0,
            [name] => names.iter().position(|known| known == name).ok_or_else(|| {
                match nearest(name, names.iter().copied()) {
                    Some(near) => format!("`{long} {name}`: did you mean `{near}`? There are {all}"),
                    None => format!("`{long} {name}`: there are {all}"),
                }
            })?,
            _ => return Err(format!("`{long}` is given more than once: there are {all}")),
        };
        self.more = format!("\n\nModels, chosen by `{long} NAME`: {all} (default {}).", names[0]);
        self.more += &format!("\nThis help is that of {}.", names[index]);
        self.out.push(names[index]);
        Ok(index)
    }
}

/// Reads the command line, does what it says with the model and writes its files.
///
/// Exit codes: 0 complete; 1 a step failed or a file cannot be written; 2 a mistake on the command
/// line or in a parameter; 130 Ctrl-C. Files are complete up to the last good time or value in all cases
/// in which the work has begun.
///
/// ```no_run
/// rncf::model! {
///     /// A ball that falls.
///     pub model Fall {
///         rigid ball { mass = 1 kg; }
///         load weight = gravity([0, 0, -10] m/s^2);
///         output z = ball.z;
///         run { t_end = 1 s; every = 0.1 s; }
///     }
/// }
///
/// fn main() -> std::process::ExitCode {
///     rncf::app::main::<Fall>()
/// }
/// ```
pub fn main<M: Model>() -> ExitCode {
    main_as::<M>(Command::Run)
}

/// As [`main`] with another command where none is given.
pub fn main_as<M: Model>(default: Command) -> ExitCode {
    enter::<M>(Line::of_process(default))
}

/// A program with several models: `--flag NAME` chooses among them, the first one is the default; the files go
/// to a folder of that name. The entries are `enter::<Model>`.
///
/// ```no_run
/// # use rncf::app::{Command, Entry, Line, enter, main_among};
/// # fn program<A: rncf::Model, B: rncf::Model>() -> std::process::ExitCode {
/// main_among("model", Command::Run, &[("upwind", enter::<A> as Entry), ("downwind", enter::<B>)])
/// # }
/// ```
///
/// # Panics
/// Never; without models the exit code is that of a mistake.
pub fn main_among(flag: &str, default: Command, models: &[(&str, Entry)]) -> ExitCode {
    let names: Vec<&str> = models.iter().map(|model| model.0).collect();
    if names.is_empty() {
        return fail(Failure::new(MISTAKE, "the program has no models"));
    }
    let mut line = Line::of_process(default);
    match line.choose(flag, &names) {
        Ok(index) => models[index].1(line),
        Err(text) => fail(Failure::new(MISTAKE, text)),
    }
}

/// As [`main`] with the words of a line.
///
/// ```
/// # use std::process::ExitCode;
/// use rncf::app::{Command, Line, enter};
///
/// rncf::model! {
///     pub model Fall {
///         rigid ball { mass = 1 kg; }
///         load weight = gravity([0, 0, -10] m/s^2);
///         output z = ball.z;
///         run { t_end = 1 s; every = 0.1 s; }
///     }
/// }
///
/// let out = std::env::temp_dir().join(format!("fall-{}", std::process::id()));
/// let words = ["--t-end", "0.5 s", "--quiet", "--out", out.to_str().unwrap()];
/// assert_eq!(enter::<Fall>(Line::new("fall", words, Command::Run)), ExitCode::SUCCESS);
/// let table = std::fs::read_to_string(out.join("history.csv"))?;
/// assert!(table.lines().last().unwrap().starts_with("0.5,-1.25"));
/// std::fs::remove_dir_all(out)?;
/// # std::io::Result::Ok(())
/// ```
pub fn enter<M: Model>(line: Line) -> ExitCode {
    entered(&M::default(), line)
}

/// With the default parameters of the model.
fn entered(model: &dyn AnyModel, line: Line) -> ExitCode {
    let program = Program {
        name: &line.program,
        default: line.default,
        more: &line.more,
        out: line.out,
    };
    let arguments = match parse(model, &program, line.words) {
        Ok(arguments) => arguments,
        Err(Refusal::Help(text)) => {
            say(&text);
            return ExitCode::SUCCESS;
        }
        Err(Refusal::Mistake(text)) => return fail(Failure::new(MISTAKE, text)),
    };
    watch_for_interruption();
    for doubt in doubts(arguments.model(), arguments.settings.options.rtol) {
        let _ = writeln!(std::io::stderr(), "warning: {doubt}");
    }
    let interrupted = || {
        let is_interrupted = INTERRUPTED.load(Ordering::SeqCst);
        // What is interrupted goes on to its files.
        IS_WRITING.store(is_interrupted, Ordering::SeqCst);
        is_interrupted
    };
    match execute(&arguments, interrupted) {
        Ok(text) => {
            if !arguments.quiet {
                say(&text);
            }
            ExitCode::SUCCESS
        }
        Err(failure) => fail(failure),
    }
}

/// Writes to standard output; that nobody reads it is no failure of the run.
fn say(text: &str) {
    let _ = writeln!(std::io::stdout(), "{}", text.trim_end());
}

fn fail(failure: Failure) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "error: {}", failure.message);
    ExitCode::from(failure.code)
}

/// The first Ctrl-C (SIGTERM, SIGHUP) ends the work in good order, a second one ends the program at once, unless it already
/// writes its files. Rows of a history are on disk before that.
fn watch_for_interruption() {
    // Without a handler Ctrl-C ends the program as usual, which is the best that is left.
    let _ = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::SeqCst) && !IS_WRITING.load(Ordering::SeqCst) {
            std::process::exit(i32::from(INTERRUPTION));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(words: &[&str]) -> (Result<usize, String>, Line) {
        let mut line = Line {
            program: "curved".into(),
            words: words.iter().map(OsString::from).collect(),
            default: Command::Run,
            more: String::new(),
            out: PathBuf::from("out/curved"),
        };
        (line.choose("model", &["upwind", "downwind"]), line)
    }

    #[test]
    fn the_model_is_taken_out_of_the_words() {
        let (index, line) = chosen(&["steady", "--model", "downwind", "--quiet"]);
        assert_eq!(
            (index, &line.words[..]),
            (Ok(1), &["steady".into(), "--quiet".into()][..])
        );
        assert_eq!(line.out, PathBuf::from("out/curved/downwind"));
        assert!(line.more.contains("upwind, downwind (default upwind)"), "{}", line.more);
        assert_eq!(chosen(&["--model=downwind"]).0, Ok(1));
        assert_eq!(chosen(&["run"]).0, Ok(0));
        for (words, expected) in [
            (&["--model"][..], "`--model` needs a name: upwind, downwind"),
            (
                &["--model", "upwnd"],
                "`--model upwnd`: did you mean `upwind`? There are upwind, downwind",
            ),
            (
                &["--model=upwind", "--model=downwind"],
                "`--model` is given more than once: there are upwind, downwind",
            ),
        ] {
            assert_eq!(chosen(words).0, Err(expected.into()));
        }
    }
}
