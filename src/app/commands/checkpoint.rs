//! The checkpoint of a run: what the run is, where its history stands, and all that it takes to go on. Whatever ends the program,
//! the last one that was written is whole.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use serde_json::{Value, json};

use crate::AnyModel;
use crate::app::line::arguments::Arguments;
use crate::app::machine::journal::Mark;
use crate::app::page::summary;
use crate::app::results::failure::{Failure, MISTAKE};
use crate::app::results::run::RunSettings;
use crate::app::runs::recorder::{Earlier, Written};
use crate::app::runs::run::complete_on_disk;
use crate::app::writing::entries::{Summary, put};
use crate::app::writing::numbers::short;
use crate::archive::{Archive, Keep};
use crate::hash::hash_on;

/// Name of the file.
pub(in crate::app) const NAME: &str = "checkpoint";
/// Where the next one is written first: the folder has one writer.
const PARTIAL: &str = ".checkpoint.partial";
/// First line; another form has another number.
const FORM: &str = "rncf checkpoint, form 1";

/// A checkpoint that was read.
#[derive(Debug)]
pub(in crate::app) struct Found {
    /// What runs.
    pub identity: Summary,
    /// Where the history stands.
    pub mark: Mark,
    /// What the run had gathered.
    pub earlier: Earlier,
}

/// All that the bits of a result depend on, by the names of the summary; numbers of unknowns and constraints where known.
pub(in crate::app) fn identity(model: &dyn AnyModel, settings: &RunSettings, size: Option<[usize; 2]>) -> Summary {
    let mut identity = summary::head(model, "run");
    for told in ["date", "model_text"] {
        identity.shift_remove(told);
    }
    summary::settings(&mut identity, settings);
    if let Some([unknowns, constraints]) = size {
        put(&mut identity, "unknowns", json!(unknowns));
        put(&mut identity, "constraints", json!(constraints));
    }
    identity
}

/// Writes the checkpoint in place of an earlier one.
///
/// # Errors
/// The path and the system's reason; the earlier one is then still there.
pub(in crate::app) fn write(folder: &Path, identity: &str, mark: Mark, written: Written<'_>) -> Result<(), String> {
    let mut bytes = format!("{FORM}\n{identity}\n").into_bytes();
    let mut mark = mark;
    mark.keep(&mut Archive::writing(&mut bytes));
    written(&mut bytes);
    bytes.extend(hash_on(0, &bytes).to_le_bytes());
    let (path, partial) = (folder.join(NAME), folder.join(PARTIAL));
    // Not waiting for the disk, which may take seconds: what a crash of the system leaves half-written is known by its hash.
    let done = fs::write(&partial, &bytes).and_then(|()| fs::rename(&partial, &path));
    done.map_err(|error| {
        // The partial file is of no use; that it cannot be removed either adds nothing.
        let _ = fs::remove_file(&partial);
        format!("cannot write {}: {error}", path.display())
    })
}

/// Reads the checkpoint of a folder.
///
/// # Errors
/// There is none, it is damaged, or of another form.
pub(in crate::app) fn read(folder: &Path) -> Result<Found, String> {
    let path = folder.join(NAME);
    let bytes = fs::read(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let form = bytes.split(|&byte| byte == b'\n').next();
    if form.is_none_or(|form| form.starts_with(b"rncf checkpoint, form ") && form != FORM.as_bytes()) {
        return Err(format!(
            "{} was written by another version of rncf: begin anew, without `--resume`",
            path.display()
        ));
    }
    parts(&bytes).ok_or_else(|| format!("{} is damaged: begin anew, without `--resume`", path.display()))
}

fn parts(bytes: &[u8]) -> Option<Found> {
    let (bytes, hash) = bytes.split_last_chunk()?;
    if hash_on(0, bytes) != u64::from_le_bytes(*hash) {
        return None;
    }
    let mut lines = bytes.splitn(3, |&byte| byte == b'\n');
    let (_, identity, rest) = (lines.next()?, lines.next()?, lines.next()?);
    let Ok(Value::Object(identity)) = serde_json::from_slice(identity) else {
        return None;
    };
    let mut found = Found {
        identity,
        mark: Mark::default(),
        earlier: Earlier::default(),
    };
    let mut archive = Archive::reading(rest);
    found.mark.keep(&mut archive);
    found.earlier.keep(&mut archive);
    archive.end().ok()?;
    Some(found)
}

/// Takes away the checkpoint of a run that is complete.
///
/// # Errors
/// The path and the system's reason.
pub(in crate::app) fn remove(folder: &Path) -> Result<(), String> {
    crate::app::machine::files::remove(folder, &[NAME, PARTIAL])
}

/// Why a run with the identity `here` is not the one that is `there` in a folder; `None` where it is.
pub(in crate::app) fn refusal(folder: &Path, there: &Summary, here: &Summary) -> Option<String> {
    let differences = differences(there, here);
    (!differences.is_empty()).then(|| {
        format!(
            "`--resume`: the run in {} is another one than this:\n{}\ngive the same, or begin anew without `--resume`",
            folder.display(),
            differences.join("\n")
        )
    })
}

/// What differs, one a line.
fn differences(there: &Summary, here: &Summary) -> Vec<String> {
    // Numbers that were written and read compare as such.
    let here = match serde_json::from_str(&Value::Object(here.clone()).to_string()) {
        Ok(Value::Object(again)) => again,
        _ => here.clone(),
    };
    let mut lines = Vec::new();
    if there.get("model_hash") != here.get("model_hash") {
        lines.push("  the text of the model".to_owned());
    } else if there.get("equations_hash") != here.get("equations_hash") {
        lines.push(
            "  what the model reads beside its text: a table, a library or an imported file; or the generator"
                .to_owned(),
        );
    }
    for (key, value) in &here {
        let other = there.get(key).unwrap_or(&Value::Null);
        match key.as_str() {
            "parameters_in_units" | "model_hash" | "equations_hash" => {}
            "parameters" => {
                let (Value::Object(values), empty) = (value, Summary::new()) else {
                    continue;
                };
                let others = other.as_object().unwrap_or(&empty);
                for (name, value) in values {
                    let other = others.get(name).unwrap_or(&Value::Null);
                    if value != other {
                        let told = |all: &Summary, value: &Value| match &all["parameters_in_units"][name] {
                            Value::String(text) => text.clone(),
                            _ => shown(value),
                        };
                        let (was, is) = (told(there, other), told(&here, value));
                        // They may differ in a digit that is not shown.
                        lines.push(match was == is {
                            true => format!("  {name}: {} there, {} here (SI)", shown(other), shown(value)),
                            false => format!("  {name}: {was} there, {is} here"),
                        });
                    }
                }
            }
            _ if value != other => lines.push(format!("  {key}: {} there, {} here", shown(other), shown(value))),
            _ => {}
        }
    }
    lines
}

/// A value in a sentence.
fn shown(value: &Value) -> String {
    match value {
        Value::Null => "none".into(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// What to say where there is nothing to go on with: the run of the folder is complete.
///
/// # Errors
/// It is another run, or there is none.
pub(in crate::app) fn complete(arguments: &Arguments) -> Result<Option<String>, Failure> {
    let folder = &arguments.out;
    if fs::exists(folder.join(NAME)).unwrap_or(true) {
        return Ok(None);
    }
    let there: Option<Value> = match fs::read_to_string(folder.join("summary.json")) {
        Ok(text) => serde_json::from_str(&text).ok(),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => {
            return Err(Failure::new(
                MISTAKE,
                format!("cannot read the summary in {}: {error}", folder.display()),
            ));
        }
    };
    let Some(Value::Object(there)) = there.filter(|there| there["completed"] == true && there["command"] == "run")
    else {
        return Err(Failure::new(
            MISTAKE,
            format!(
                "`--resume`: there is no run in {} that could go on: begin one without `--resume`",
                folder.display()
            ),
        ));
    };
    let settings =
        complete_on_disk(&arguments.settings, arguments.model().run()).map_err(|error| Failure::from(&error))?;
    if let Some(text) = refusal(folder, &there, &identity(arguments.model(), &settings, None)) {
        return Err(Failure::new(MISTAKE, text));
    }
    let reached = there["t_reached"]
        .as_f64()
        .map_or("its end".into(), |t| format!("t = {} s", short(t)));
    Ok(Some(format!(
        "{}: the run in {} is complete up to {reached}: there is nothing to go on with",
        arguments.model().name(),
        folder.display()
    )))
}

#[cfg(test)]
mod tests;
