//! Work-precision charts: error over work of formulations, meshes, methods and tolerances of one model.
//!
//! A [`grid`](grid::Grid) of settings is run, errors ([`errors`]) are taken against converged runs ([`reference`]), every
//! point goes to chart.csv as soon as it is known ([`table`]), and the cheapest settings are named ([`judged`]).

pub(in crate::app) mod errors;
mod grid;
mod judged;
mod outcome;
mod peers;
mod picture;
mod points;
mod reference;
mod scatter;
mod select;
mod table;

use std::fs;
use std::io::ErrorKind;
use std::path::PathBuf;

use self::grid::{Grid, meshes};
use self::judged::{Judged, Measure};
use self::picture::{time_chart, work_chart};
use self::reference::{Unreferenced, references};
use self::table::Table;
use crate::AnyModel;
use crate::app::commands::progress::Bar;
use crate::app::line::arguments::Arguments;
use crate::app::machine::files;
use crate::app::page::{report, summary};
use crate::app::results::failure::{FAILURE, Failure, INTERRUPTION, MISTAKE};
use crate::app::runs::run::complete;
use crate::app::writing::entries::to_text;
use crate::app::writing::numbers::in_unit;

const AGAIN: &str = "interrupted by the user; the same command again goes on from here";

/// Does it all and writes; the text for standard output.
///
/// # Errors
/// With its exit code: a mistake in flags, parameters or files; no reference; a file that cannot be written; Ctrl-C, where
/// all that is known is written.
pub(in crate::app) fn execute(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let (settings, model, out) = (&arguments.chart, arguments.model(), &arguments.out);
    let (grid, refused) = grid_of(arguments)?;
    if settings.is_fresh {
        begin_anew(out)?;
    }
    let mut bar = Bar::new(arguments.quiet);
    let found = references(
        &grid,
        model,
        (out, settings.reference.as_deref()),
        settings.limit,
        &interrupted,
        |number, count| bar.show_share(number as f64 / count as f64, "converged runs"),
    );
    let references = found.map_err(|reason| {
        bar.clear();
        match reason {
            Unreferenced::Interrupted => Failure::new(INTERRUPTION, AGAIN),
            Unreferenced::Failed(text) => Failure::new(FAILURE, text),
        }
    })?;
    let measure = Measure::new(model, &references, settings.outputs.as_deref()).map_err(mistake)?;
    let peers = match &settings.beside {
        None => Vec::new(),
        Some(path) => {
            let scale = |(&index, name): (&usize, &String)| (name.clone(), measure.scales[index]);
            let outputs: Vec<(String, f64)> = measure.chosen.iter().zip(&measure.names).map(scale).collect();
            peers::read(path, &outputs).map_err(mistake)?
        }
    };
    let table = Table::new(out, &references.exact);
    let points = points::find(
        (&grid, model),
        &references,
        &table,
        settings.limit,
        &interrupted,
        &mut |what, number, count| bar.show_share(number as f64 / count.max(1) as f64, what),
    );
    bar.clear();
    let points = points.map_err(|text| Failure::new(FAILURE, text))?;
    let judged = Judged {
        title: &title(model, &grid),
        grid: &grid,
        references: &references,
        measure: &measure,
        found: &points.found,
        peers: &peers,
        wanted: &settings.wanted,
    };
    let text =
        write(arguments, &judged, points.is_interrupted, &refused).map_err(|text| Failure::new(FAILURE, text))?;
    if points.is_interrupted {
        return Err(Failure::new(INTERRUPTION, format!("{AGAIN}\nup to there:\n{text}")));
    }
    Ok(text)
}

fn mistake(text: String) -> Failure {
    Failure::new(MISTAKE, text)
}

/// The grid of what the model can be built in, and a note for each formulation that it cannot.
fn grid_of(arguments: &Arguments) -> Result<(Grid, Vec<String>), Failure> {
    let settings = &arguments.chart;
    let mut grid = Grid {
        formulations: settings.formulations.clone(),
        meshes: meshes(arguments.model(), &arguments.lists).map_err(mistake)?,
        methods: settings.methods.clone(),
        rtols: settings.rtols.clone(),
        base: complete(&arguments.settings, arguments.model().run()).map_err(|error| Failure::from(&error))?,
    };
    let mut refused = Vec::new();
    for &formulation in &settings.formulations {
        let refusal = (0..grid.meshes.len()).find_map(|mesh| {
            let model = grid.model(arguments.model(), mesh);
            model.build(formulation, grid.base.joints).err()
        });
        if let Some(refusal) = refusal {
            refused.push(format!("{} is left out: {refusal}", formulation.name()));
            grid.formulations.retain(|&other| other != formulation);
        }
    }
    if grid.formulations.is_empty() {
        return Err(mistake(refused.join("\n")));
    }
    Ok((grid, refused))
}

/// The model with the parameters that are neither the default ones nor tried in several values.
fn title(model: &dyn AnyModel, grid: &Grid) -> String {
    let counts = &grid.meshes[0].counts;
    let mut title = model.name().to_owned();
    for (index, param) in model.params().iter().enumerate() {
        let value = model.get(index);
        if value != param.default && counts.iter().all(|count| count.0 != index) {
            title += &format!(", {} = {}", param.name, in_unit(param, value));
        }
    }
    title
}

/// Removes what an earlier call has found.
fn begin_anew(out: &std::path::Path) -> Result<(), Failure> {
    let told = |path: PathBuf, outcome: std::io::Result<()>| match outcome {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(Failure::new(
            FAILURE,
            format!("cannot remove {}: {error}", path.display()),
        )),
        _ => Ok(()),
    };
    let (table, folder) = (out.join(table::NAME), out.join(reference::FOLDER));
    told(table.clone(), fs::remove_file(table))?;
    // Only what a chart wrote: a folder of that name may hold more.
    let Ok(entries) = fs::read_dir(&folder) else {
        return Ok(());
    };
    for path in entries.flatten().map(|entry| entry.path()) {
        let stem = path.file_stem().map_or(0, |stem| stem.len());
        if stem == 16 && path.extension().is_some_and(|extension| extension == "csv") {
            told(path.clone(), fs::remove_file(path))?;
        }
    }
    Ok(())
}

/// Writes the charts, the summary and the report; what to say.
fn write(
    arguments: &Arguments,
    judged: &Judged<'_>,
    is_interrupted: bool,
    refused: &[String],
) -> Result<String, String> {
    let notes = outcome::notes(judged, refused);
    let reason = is_interrupted.then(|| AGAIN.to_owned());
    let mut summary = outcome::summary(arguments.model(), judged, reason, &notes);
    summary::command_line(&mut summary, &arguments.line);
    let page = report::page(arguments.model(), "chart", &summary, &outcome::part(judged));
    let contents = [
        ("chart_time.svg", time_chart(judged).to_svg(true)),
        ("chart_work.svg", work_chart(judged).to_svg(true)),
        ("summary.json", to_text(&summary)),
        ("report.html", page),
    ];
    let mut text = format!("{}: {}\n", arguments.model().name(), outcome::what(judged));
    for line in judged.lines() {
        text += &format!("  {line}\n");
    }
    for note in &notes {
        text += &format!("note: {note}\n");
    }
    text += &format!("  {}", arguments.out.join(table::NAME).display());
    for (name, content) in contents {
        files::write(&arguments.out, name, &content)?;
        text += &format!("\n  {}", arguments.out.join(name).display());
    }
    Ok(text)
}

#[cfg(test)]
mod tests;
