//! What counts as exact: converged runs, one on every mesh, that of the finest mesh for all points; or a file.

use std::fs;
use std::path::{Path, PathBuf};

use super::errors::{ColumnError, errors};
use super::grid::{Grid, Setting};
use crate::app::commands::parallel::{Ended, on_all_cores, solve};
use crate::app::machine::files;
use crate::app::results::history::{Column, History};
use crate::app::results::run::RowTimes;
use crate::hash::hash;
use crate::{AnyModel, Method};

/// Folder of the converged runs, in that of the chart.
pub(super) const FOLDER: &str = "reference";
/// A converged run may take so many times as long as another one.
const PATIENCE: f64 = 10.0;

/// What points are compared with.
#[derive(Debug)]
pub(super) struct References {
    /// For all points.
    pub exact: History,
    /// What it is, in words.
    pub name: String,
    /// How much it changed when its tolerance was tightened tenfold; `None` for a file.
    pub uncertainty: Option<Vec<ColumnError>>,
    /// Converged runs on the meshes, in their order.
    pub on_meshes: Vec<History>,
    /// Stands for all of them.
    pub key: u64,
}

/// Why there is none.
pub(super) enum Unreferenced {
    Interrupted,
    /// The text says what is wrong.
    Failed(String),
}

impl From<String> for Unreferenced {
    fn from(text: String) -> Self {
        Unreferenced::Failed(text)
    }
}

/// A converged run that is asked for, with its history or why there is none.
struct Asked {
    setting: Setting,
    found: Result<History, String>,
}

/// Finds converged runs: in files of earlier calls, or by running them.
struct Finder<'f> {
    grid: &'f Grid,
    model: &'f dyn AnyModel,
    /// Where they are kept.
    folder: PathBuf,
    /// Processor time of a run, s.
    limit: f64,
}

/// Finds the references: converged runs are those of the first formulation with Radau, ten and a hundred times as tight
/// as the tightest tolerance of the grid; where the tighter one fails, the tolerance itself and ten times as tight.
/// They are kept in files, and taken from there. `told` hears of every run that is done, and how many there are.
///
/// # Errors
/// [`Unreferenced`].
pub(super) fn references(
    grid: &Grid,
    model: &dyn AnyModel,
    (folder, file): (&Path, Option<&Path>),
    limit: f64,
    interrupted: impl Fn() -> bool,
    mut told: impl FnMut(usize, usize),
) -> Result<References, Unreferenced> {
    let folder = folder.join(FOLDER);
    files::create_folder(&folder)?;
    let given = file.map(|path| read(model, grid, path).map(|history| (history, path)));
    let given = given.transpose()?;
    let finder = Finder {
        grid,
        model,
        folder,
        limit: PATIENCE * limit,
    };
    let pairs = (0..grid.meshes.len()).flat_map(|mesh| [converged(grid, mesh, 2), converged(grid, mesh, 1)]);
    let mut all = finder.find(pairs.collect(), &interrupted, &mut told)?;
    let has_failed = |asked: &&Asked| asked.found.is_err() && asked.setting == converged(grid, asked.setting.mesh, 2);
    let looser = all
        .iter()
        .filter(has_failed)
        .map(|asked| converged(grid, asked.setting.mesh, 0));
    let looser: Vec<Setting> = looser.collect();
    all.extend(finder.find(looser, &interrupted, &mut told)?);
    let mut on_meshes = Vec::new();
    for mesh in 0..grid.meshes.len() {
        let (mut mine, others): (Vec<Asked>, Vec<Asked>) =
            all.into_iter().partition(|asked| asked.setting.mesh == mesh);
        mine.sort_by(|a, b| a.setting.rtol.total_cmp(&b.setting.rtol));
        on_meshes.push(best_two(grid, mine)?);
        all = others;
    }
    let ((of, history), (_, check)) = &on_meshes[grid.finest()];
    let keys = (0..grid.meshes.len()).map(|mesh| grid.identity(model, &converged(grid, mesh, 2)));
    let mut keys: Vec<u64> = keys.collect();
    let (exact, name, uncertainty) = match given {
        None => {
            let name = format!("converged run ({})", grid.name(of));
            (history.clone(), name, Some(errors(check, history)))
        }
        Some((history, path)) => {
            keys.push(hash(&history.to_csv()));
            (history, path.display().to_string(), None)
        }
    };
    Ok(References {
        exact,
        name,
        uncertainty,
        on_meshes: on_meshes.into_iter().map(|(converged, _)| converged.1).collect(),
        key: hash(&format!("{keys:?}")),
    })
}

/// Setting of a converged run, so many decades tighter than the tightest tolerance of the grid.
fn converged(grid: &Grid, mesh: usize, decades: i32) -> Setting {
    let tightest = grid.rtols.iter().copied().fold(1.0, f64::min);
    let rtol = format!("{:.12e}", tightest * 10f64.powi(-decades));
    Setting {
        formulation: grid.formulations[0],
        mesh,
        method: Method::Radau,
        rtol: rtol.parse().unwrap_or(tightest),
    }
}

impl Finder<'_> {
    fn find(
        &self,
        wanted: Vec<Setting>,
        interrupted: impl Fn() -> bool,
        mut told: impl FnMut(usize, usize),
    ) -> Result<Vec<Asked>, Unreferenced> {
        let (mut all, mut tasks) = (Vec::new(), Vec::new());
        for setting in wanted {
            match read(self.model, self.grid, &self.folder.join(self.file(&setting))) {
                Ok(history) => all.push(Asked {
                    setting,
                    found: Ok(history),
                }),
                Err(_) => tasks.push(setting),
            }
        }
        let (count, mut number, mut is_interrupted) = (tasks.len(), 0, false);
        let work = |setting: &Setting, stop: &_| {
            let model = self.grid.model(self.model, setting.mesh);
            solve(model.as_ref(), &self.grid.run(setting), self.limit, stop)
        };
        on_all_cores(tasks, interrupted, work, |setting, ended| {
            number += 1;
            told(number, count);
            let found = match ended {
                Ended::Complete(result) => {
                    files::write(&self.folder, &self.file(&setting), &result.history.to_csv())?;
                    Ok(result.history)
                }
                Ended::Failed(text) => Err(text),
                Ended::TooLong => Err(format!(
                    "longer than {} s, {PATIENCE} times the limit; raise `--limit`, or choose looser `--rtols`",
                    self.limit
                )),
                Ended::Interrupted => {
                    is_interrupted = true;
                    return Ok(None);
                }
            };
            all.push(Asked { setting, found });
            Ok(None)
        })?;
        if is_interrupted {
            return Err(Unreferenced::Interrupted);
        }
        Ok(all)
    }

    /// Name of the file of a converged run.
    fn file(&self, setting: &Setting) -> String {
        format!("{:016x}.csv", self.grid.identity(self.model, setting))
    }
}

/// A converged run.
type Converged = (Setting, History);

/// The tightest two runs that were found, the tightest first.
fn best_two(grid: &Grid, asked: Vec<Asked>) -> Result<(Converged, Converged), String> {
    let mut found = Vec::new();
    let mut refusal = String::new();
    for Asked {
        setting,
        found: outcome,
    } in asked
    {
        match outcome {
            Ok(history) => found.push((setting, history)),
            Err(text) => refusal = format!("{}: {text}", grid.name(&setting)),
        }
    }
    let mut found = found.into_iter();
    match (found.next(), found.next()) {
        (Some(first), Some(second)) => Ok((first, second)),
        _ => Err(format!(
            "there is no converged run to compare with: {refusal}\ngive looser `--rtols` or a shorter `--t-end`"
        )),
    }
}

/// A history of the model's outputs at the rows of the grid; the file may have more of both.
///
/// # Errors
/// The path, and the column, row or number that is missing or wrong.
fn read(model: &dyn AnyModel, grid: &Grid, path: &Path) -> Result<History, String> {
    let name = path.display();
    let text = fs::read_to_string(path).map_err(|error| format!("cannot read {name}: {error}"))?;
    let mut history = History::new(model, Column::time());
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().unwrap_or("").split(',').map(str::trim).collect();
    let place = |head: String| {
        let found = heads.iter().position(|other| *other == head);
        found.ok_or_else(|| format!("{name} has no column `{head}`: a history.csv of this model is needed"))
    };
    let key = place(history.key.head())?;
    let columns = history.columns.iter().map(|column| place(column.head()));
    let columns = columns.collect::<Result<Vec<usize>, String>>()?;
    let rows = RowTimes::of(&grid.base);
    let RowTimes { t_end, every, .. } = rows;
    let mut wanted = (0..rows.count).map(|row| rows.at(row)).peekable();
    for (index, line) in lines.enumerate() {
        let Some(&t) = wanted.peek() else { break };
        let numbers: Option<Vec<f64>> = line.split(',').map(|field| field.trim().parse().ok()).collect();
        let numbers = numbers.filter(|numbers| numbers.len() == heads.len());
        let numbers = numbers.ok_or_else(|| format!("{name}, line {}: this is no row of numbers", index + 2))?;
        if (numbers[key] - t).abs() > 1e-9 * t_end {
            continue;
        }
        let row: Vec<f64> = columns.iter().map(|&column| numbers[column]).collect();
        history.push(t, &row).map_err(|text| format!("{name}: {text}"))?;
        wanted.next();
    }
    match wanted.next() {
        None => Ok(history),
        Some(t) => Err(format!(
            "{name} has no row at t = {t} s: it must have a row every {every} s up to {t_end} s, as the chart's runs"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::commands::chart::grid::meshes;
    use crate::app::results::run::RunSettings;
    use crate::app::runs::run::run;
    use crate::app::testing::{Rotor, temporary_folder};

    fn grid() -> Grid {
        Grid {
            formulations: vec![crate::Formulation::Rncf],
            meshes: meshes(&Rotor::default(), &[]).unwrap(),
            methods: vec![Method::Radau],
            rtols: vec![1e-3, 1e-6],
            base: RunSettings {
                t_end: Some(2.0),
                every: Some(0.1),
                ..RunSettings::default()
            },
        }
    }

    fn found(model: &Rotor, grid: &Grid, folder: &Path, file: Option<&Path>) -> (Result<References, String>, usize) {
        let mut runs = 0;
        let found = references(grid, model, (folder, file), 60.0, || false, |_, _| runs += 1);
        let found = found.map_err(|reason| match reason {
            Unreferenced::Interrupted => "interrupted".into(),
            Unreferenced::Failed(text) => text,
        });
        (found, runs)
    }

    #[test]
    fn converged_runs_are_kept_and_know_how_good_they_are() {
        let (folder, rotor, grid) = (temporary_folder("references"), Rotor::default(), grid());
        let (first, runs) = found(&rotor, &grid, &folder, None);
        let first = first.unwrap();
        assert_eq!((runs, first.exact.keys.len(), first.on_meshes.len()), (2, 21, 1));
        assert!(first.name.contains("rtol 1e-8"), "{}", first.name);
        let change = first.uncertainty.as_ref().unwrap()[0].max;
        assert!(change > 0.0 && change < 1e-6, "{change:e}");
        let (again, runs) = found(&rotor, &grid, &folder, None);
        let again = again.unwrap().exact;
        // What is kept are rows; extremes between them are not.
        let rows = |of: &History| (of.columns.clone(), of.keys.clone(), of.values.clone());
        assert_eq!((runs, rows(&again)), (0, rows(&first.exact)));
        // Another problem has other references.
        let other = Rotor { loss: 0.0, ..rotor };
        let (other, runs) = found(&other, &grid, &folder, None);
        assert!(runs == 2 && other.unwrap().key != first.key);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_model_without_a_converged_run_is_refused_with_the_reason() {
        let folder = temporary_folder("references-failing");
        let failing = Rotor {
            fail_at: 1.0,
            ..Rotor::default()
        };
        let text = found(&failing, &grid(), &folder, None).0.unwrap_err();
        assert!(
            text.starts_with("there is no converged run") && text.contains(" t = "),
            "{text}"
        );
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn files_are_read_by_column_and_row_and_refused_by_name() {
        let (folder, rotor, grid) = (temporary_folder("references-file"), Rotor::default(), grid());
        files::create_folder(&folder).unwrap();
        let settings = RunSettings {
            every: Some(0.05),
            ..grid.base.clone()
        };
        let finer = run(&rotor, &settings).unwrap().history;
        files::write(&folder, "finer.csv", &finer.to_csv()).unwrap();
        let file = folder.join("finer.csv");
        let found = found(&rotor, &grid, &folder, Some(&file)).0.unwrap();
        assert!(found.uncertainty.is_none() && found.name.ends_with("finer.csv"));
        assert_eq!(
            found.exact.values[..6],
            [
                finer.values[0],
                finer.values[1],
                finer.values[2],
                finer.values[6],
                finer.values[7],
                finer.values[8]
            ]
        );
        let refusal = |name: &str, text: &str| {
            files::write(&folder, name, text).unwrap();
            read(&Rotor::default(), &grid, &folder.join(name)).unwrap_err()
        };
        let text = finer.to_csv();
        let cases = [
            (
                "a.csv",
                text.replace("tip.y [m]", "tip.z [m]"),
                "a.csv has no column `tip.y [m]`",
            ),
            (
                "b.csv",
                text.lines().take(12).collect::<Vec<_>>().join("\n"),
                "b.csv has no row at t = 0.6",
            ),
            (
                "c.csv",
                text.replacen("\n0.0,", "\n0.0,x", 1),
                "c.csv, line 2: this is no row of numbers",
            ),
        ];
        for (name, text, expected) in cases {
            let refusal = refusal(name, &text);
            assert!(refusal.contains(expected), "{refusal}");
        }
        assert!(
            read(&Rotor::default(), &grid, &folder.join("none.csv"))
                .unwrap_err()
                .starts_with("cannot read ")
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
