//! Scenario files: the words of a command line in a file of TOML, to be read, changed and kept.
//!
//! ```toml
//! model = "SpinUp"
//! command = "run"
//!
//! [params]
//! omega_s = "40 rad/s"
//!
//! [settings]
//! rtol = 1e-8
//! stabilised = true
//! ```

use std::fmt::Write;
use std::path::Path;

use clap::ArgMatches;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::command::Command;
use crate::app::writing::numbers::in_unit;
use crate::hash::hash;
use crate::nearest::nearest;
use crate::{AnyModel, ParamKind};

/// Flags that say where something goes and not what it is.
const OUTER: [&str; 7] = ["scenario", "save-scenario", "out", "quiet", "resume", "plan", "index"];

/// What a line says: its command, params and flags, as they are typed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::app) struct Scenario {
    pub command: Option<Command>,
    /// Name and value.
    pub params: Vec<(String, String)>,
    /// Name and value, none for those that take none.
    pub flags: Vec<(String, Option<String>)>,
}

/// The hash that a scenario names its model's text by.
pub(in crate::app) fn model_hash(model: &dyn AnyModel) -> String {
    format!("{:016x}", hash(model.source()))
}

impl Scenario {
    /// What the words say that `matches` has read; words without `=` are left to the reader of the line.
    pub fn of_line(line: &clap::Command, matches: &ArgMatches) -> Self {
        let mut words = matches.get_many::<String>("words").into_iter().flatten().peekable();
        let command = words.peek().and_then(|word| Command::named(word));
        let params = words.filter_map(|word| word.split_once('='));
        let flags = line.get_arguments().filter(|arg| is_inner(arg.get_id().as_str()));
        let given = flags.filter_map(|arg| {
            let id = arg.get_id().as_str();
            if matches.value_source(id) != Some(clap::parser::ValueSource::CommandLine) {
                return None;
            }
            let value = arg.get_action().takes_values().then(|| {
                let raw = matches.get_raw(id).into_iter().flatten().next();
                raw.map(|text| text.to_string_lossy().into_owned()).unwrap_or_default()
            });
            Some((id.to_owned(), value))
        });
        Self {
            command,
            params: params
                .map(|(name, value)| (name.trim().into(), value.trim().into()))
                .collect(),
            flags: given.collect(),
        }
    }

    /// This where `line` says nothing else.
    pub fn under(mut self, line: Scenario) -> Self {
        self.command = line.command.or(self.command);
        self.params
            .retain(|(name, _)| line.params.iter().all(|(other, _)| other != name));
        self.params.extend(line.params);
        self.flags
            .retain(|(name, _)| line.flags.iter().all(|(other, _)| other != name));
        self.flags.extend(line.flags);
        self
    }

    /// The words that say it.
    pub fn words(&self) -> Vec<String> {
        let command = self.command.map(|command| command.name().to_owned());
        let params = self.params.iter().map(|(name, value)| format!("{name}={value}"));
        let flags = self.flags.iter().map(|(name, value)| match value {
            Some(value) => format!("--{name}={value}"),
            None => format!("--{name}"),
        });
        command.into_iter().chain(params).chain(flags).collect()
    }

    /// The text of a file; params and flags stand in the order of the model and of the alphabet, `points` is the number of
    /// points of a plan.
    pub fn to_text(&self, model: &dyn AnyModel, command: Command, points: Option<usize>) -> String {
        let mut text = String::new();
        let _ = writeln!(text, "model = {}", quoted(model.name()));
        let _ = writeln!(text, "model_hash = {}", quoted(&model_hash(model)));
        let _ = writeln!(text, "command = {}", quoted(command.name()));
        if let Some(points) = points {
            let _ = writeln!(text, "points = {points}");
        }
        text += "\n[params]\n";
        for (index, param) in model.params().iter().enumerate() {
            match self.params.iter().find(|(name, _)| name == param.name) {
                Some((name, value)) => {
                    let _ = writeln!(text, "{name} = {}", quoted(value));
                }
                None => {
                    let default = in_unit(param, model.boxed().get(index));
                    let _ = writeln!(text, "# {} = {}", param.name, quoted(&default));
                }
            }
        }
        text += "\n[settings]\n";
        let mut flags: Vec<_> = self.flags.iter().collect();
        flags.sort();
        for (name, value) in flags {
            let value = value
                .as_deref()
                .map_or("true".into(), |value| match value.parse::<f64>() {
                    Ok(number) if number.is_finite() && is_toml_number(value) => value.to_owned(),
                    _ => quoted(value),
                });
            let _ = writeln!(text, "{name} = {value}");
        }
        text
    }
}

/// Names of the settings that a file may hold.
pub(in crate::app) fn settings(line: &clap::Command) -> Vec<&str> {
    let names = line.get_arguments().map(|arg| arg.get_id().as_str());
    names.filter(|name| is_inner(name)).collect()
}

fn is_inner(flag: &str) -> bool {
    !OUTER.contains(&flag) && !["words", "help", "version"].contains(&flag)
}

/// What TOML reads as a number.
fn is_toml_number(text: &str) -> bool {
    matches!(
        DeValue::parse(text).map(Spanned::into_inner),
        Ok(DeValue::Integer(_) | DeValue::Float(_))
    )
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted += "\\\"",
            '\\' => quoted += "\\\\",
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// A file that is read, with what its line numbers need.
struct Reader<'f> {
    path: &'f Path,
    text: &'f str,
}

/// Reads a scenario file; `line` knows the flags.
///
/// # Errors
/// The file with the line, what is wrong there, and what would be right.
pub(in crate::app) fn read(path: &Path, model: &dyn AnyModel, line: &clap::Command) -> Result<Scenario, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    Reader { path, text: &text }.read(model, line)
}

impl Reader<'_> {
    fn read(&self, model: &dyn AnyModel, line: &clap::Command) -> Result<Scenario, String> {
        let table = DeTable::parse(self.text).map_err(|error| {
            let place = error.span().map_or(0, |span| span.start);
            self.at(place, error.message())
        })?;
        let mut scenario = Scenario::default();
        for (key, value) in table.get_ref() {
            let (name, place) = (key.get_ref().as_ref(), key.span().start);
            match name {
                "model" => {
                    let given = self.string(name, value)?;
                    if given != model.name() {
                        let text = format!("it is for the model `{given}`; this program's is `{}`", model.name());
                        return Err(self.at(place, &text));
                    }
                }
                "model_hash" => {
                    if self.string(name, value)? != model_hash(model) {
                        let text = "it was saved for another text of the model; check that it still fits, and take this line out";
                        return Err(self.at(place, text));
                    }
                }
                "command" => {
                    let given = self.string(name, value)?;
                    scenario.command = Some(Command::named(&given).ok_or_else(|| {
                        let names = Command::ALL.map(Command::name);
                        self.at(place, &unknown("command", &given, &names))
                    })?);
                }
                // Counted anew where it matters; it stands there for programs that hand out the points.
                "points" => {}
                "params" => scenario.params = self.params(model, value)?,
                "settings" => scenario.flags = self.flags(line, value)?,
                _ => {
                    let known = ["model", "model_hash", "command", "points", "params", "settings"];
                    return Err(self.at(place, &unknown("key", name, &known)));
                }
            }
        }
        Ok(scenario)
    }

    fn params(&self, model: &dyn AnyModel, value: &Spanned<DeValue<'_>>) -> Result<Vec<(String, String)>, String> {
        let names: Vec<&str> = model.params().iter().map(|param| param.name).collect();
        let one = |(key, value): (&Spanned<_>, &Spanned<DeValue<'_>>)| {
            let name: &str = AsRef::<str>::as_ref(key.get_ref());
            let Some(param) = model.params().iter().find(|param| param.name == name) else {
                return Err(self.at(key.span().start, &unknown("param", name, &names)));
            };
            let example = match param.kind {
                ParamKind::Count => in_unit(param, param.default),
                ParamKind::Quantity | ParamKind::Table(_) => quoted(&in_unit(param, param.default)),
            };
            let text = match value.get_ref() {
                DeValue::Array(parts) => {
                    let parts = parts.iter().map(|part| self.scalar(part));
                    parts.collect::<Option<Vec<_>>>().map(|parts| parts.join(","))
                }
                _ => self.scalar(value),
            };
            let text = text.ok_or_else(|| self.at(key.span().start, &format!("write `{name} = {example}`")))?;
            Ok((name.to_owned(), text))
        };
        self.table("params", value)?.iter().map(one).collect()
    }

    fn flags(
        &self,
        line: &clap::Command,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<Vec<(String, Option<String>)>, String> {
        let mut flags = Vec::new();
        for (key, value) in self.table("settings", value)? {
            let (name, place): (&str, usize) = (key.get_ref().as_ref(), key.span().start);
            let known = settings(line);
            let arg = line.get_arguments().find(|arg| arg.get_id() == name);
            let Some(arg) = arg.filter(|_| known.contains(&name)) else {
                if OUTER.contains(&name) {
                    return Err(self.at(place, &format!("`{name}` stands on the command line, `--{name}`")));
                }
                return Err(self.at(place, &unknown("setting", name, &known)));
            };
            match (arg.get_action().takes_values(), value.get_ref()) {
                (false, DeValue::Boolean(true)) => flags.push((name.into(), None)),
                (false, DeValue::Boolean(false)) => {}
                (false, _) => return Err(self.at(place, &format!("write `{name} = true` or `{name} = false`"))),
                (true, DeValue::Array(parts)) => {
                    let parts = parts.iter().map(|part| self.scalar(part)).collect::<Option<Vec<_>>>();
                    let parts = parts.ok_or_else(|| self.at(place, "a list of texts or numbers is needed"))?;
                    flags.push((name.into(), Some(parts.join(","))));
                }
                (true, _) => {
                    let text = self.scalar(value);
                    let text = text.ok_or_else(|| self.at(place, "a text or a number is needed"))?;
                    flags.push((name.into(), Some(text)));
                }
            }
        }
        Ok(flags)
    }

    fn table<'v, 't>(&self, name: &str, value: &'v Spanned<DeValue<'t>>) -> Result<&'v DeTable<'t>, String> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(table),
            _ => Err(self.at(
                value.span().start,
                &format!("`{name}` is a table: write `[{name}]` on a line of its own"),
            )),
        }
    }

    fn string(&self, name: &str, value: &Spanned<DeValue<'_>>) -> Result<String, String> {
        match value.get_ref() {
            DeValue::String(text) => Ok(text.to_string()),
            _ => Err(self.at(
                value.span().start,
                &format!("`{name}` is a text: write `{name} = \"..\"`"),
            )),
        }
    }

    /// A text or number as it is typed on the line.
    fn scalar(&self, value: &Spanned<DeValue<'_>>) -> Option<String> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            DeValue::Integer(_) | DeValue::Float(_) => {
                let text = self.text.get(value.span())?;
                Some(text.replace('_', ""))
            }
            _ => None,
        }
    }

    /// A sentence with the file and line of a place in it.
    fn at(&self, place: usize, text: &str) -> String {
        let before = self.text.get(..place).unwrap_or(self.text);
        let line = 1 + before.matches('\n').count();
        format!("{}:{line}: {text}", self.path.display())
    }
}

fn unknown(what: &str, name: &str, known: &[&str]) -> String {
    match nearest(name, known.iter().copied()) {
        Some(near) => format!("there is no {what} `{name}`; did you mean `{near}`?"),
        None => format!("there is no {what} `{name}`; there are {}", known.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::fs;
    use std::path::PathBuf;

    use super::*;
    use crate::app::line::arguments::{Arguments, Refusal, parse};
    use crate::app::line::program::Program;
    use crate::app::testing::{Rotor, temporary_folder};

    fn line(words: &[&str]) -> Result<Arguments, String> {
        let program = Program {
            name: "rotor",
            default: Command::Run,
            more: "",
            out: PathBuf::from("out/rotor"),
        };
        parse(&Rotor::default(), &program, words.iter().map(OsString::from)).map_err(|refusal| match refusal {
            Refusal::Help(text) | Refusal::Mistake(text) => text,
        })
    }

    /// The arguments of a line with a scenario of this text.
    fn with(name: &str, text: &str, words: &[&str]) -> Result<Arguments, String> {
        let folder = temporary_folder(&format!("scenario-{name}"));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("s.toml");
        fs::write(&path, text).unwrap();
        let path = path.to_str().unwrap().to_owned();
        let words: Vec<&str> = words.iter().copied().chain(["--scenario", &path]).collect();
        let found = line(&words).map_err(|text| text.replace(&path, "s.toml"));
        fs::remove_dir_all(&folder).unwrap();
        found
    }

    const TEXT: &str = "model = \"Rotor\"\ncommand = \"run\"\n[params]\nomega = \"4 rad/s\"\ncoils = 3\n\n[settings]\n\
        integrator = \"hht\"\nrtol = 1_0e-9\nstabilised = true\nproportional = false\n";

    #[test]
    fn a_file_stands_for_the_words_of_a_line_which_come_before_it() {
        let found = with("words", TEXT, &["coils=5", "--rtol", "1e-5", "--quiet"]).unwrap();
        let typed = line(&[
            "run",
            "omega=4 rad/s",
            "coils=5",
            "--integrator",
            "hht",
            "--stabilised",
            "--rtol",
            "1e-5",
        ]);
        let typed = typed.unwrap();
        assert_eq!(found.settings, typed.settings);
        assert_eq!([0, 1].map(|index| found.model().get(index)), [4.0, 5.0]);
        assert!(found.quiet && found.line.contains("--integrator=hht"), "{}", found.line);
        assert_eq!(with("rtol", TEXT, &[]).unwrap().settings.options.rtol, 1e-8);
    }

    #[test]
    fn what_is_kept_is_read_back_the_same() {
        let given = line(&[
            "run",
            "omega=0.1 rad/s",
            "--fidelity",
            "rod=rigid",
            "--rtol",
            "1e-7",
            "--no-elimination",
        ]);
        let given = given.unwrap();
        let text = given.scenario.to_text(given.model(), given.command, None);
        assert!(text.contains("omega = \"0.1 rad/s\"\n# coils = \"2\"\n"), "{text}");
        assert!(
            text.contains("fidelity = \"rod=rigid\"\nno-elimination = true\nrtol = 1e-7\n"),
            "{text}"
        );
        let again = with("again", &text, &[]).unwrap();
        assert_eq!((&again.settings, again.model().get(0)), (&given.settings, 0.1));
        assert_eq!(again.scenario.to_text(again.model(), again.command, None), text);
    }

    #[test]
    fn mistakes_name_the_line_and_what_would_be_right() {
        for (text, expected) in [
            (
                "modl = \"Rotor\"",
                "s.toml:1: there is no key `modl`; did you mean `model`?",
            ),
            (
                "model = \"Sail\"",
                "s.toml:1: it is for the model `Sail`; this program's is `Rotor`",
            ),
            (
                "\ncommand = \"swep\"",
                "s.toml:2: there is no command `swep`; did you mean `sweep`?",
            ),
            (
                "[params]\nomga = \"1 rad/s\"",
                "s.toml:2: there is no param `omga`; did you mean `omega`?",
            ),
            ("[params]\nomega = true", "s.toml:2: write `omega = \"3 rad/s\"`"),
            (
                "[settings]\nrtl = 1e-3",
                "s.toml:2: there is no setting `rtl`; did you mean `rtol`?",
            ),
            (
                "[settings]\nout = \"here\"",
                "s.toml:2: `out` stands on the command line, `--out`",
            ),
            (
                "[settings]\nstabilised = 1",
                "s.toml:2: write `stabilised = true` or `stabilised = false`",
            ),
            (
                "params = 3",
                "s.toml:1: `params` is a table: write `[params]` on a line of its own",
            ),
            (
                "model_hash = \"00\"",
                "s.toml:1: it was saved for another text of the model; check that it still fits, and take this line out",
            ),
        ] {
            assert_eq!(with("mistakes", text, &[]).map(drop), Err(expected.into()));
        }
        let error = with("broken", "a = [1, ", &[]).map(drop).unwrap_err();
        assert!(error.starts_with("s.toml:1: "), "{error}");
        let error = with("unit", "[params]\nomega = 3", &[]).map(drop).unwrap_err();
        assert!(error.contains("`omega=3`: the unit is missing"), "{error}");
        assert!(line(&["--scenario", "nowhere.toml"]).is_err_and(|text| text.starts_with("cannot read nowhere.toml")));
    }
}
