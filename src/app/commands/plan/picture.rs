//! Pictures of a plan's table: curves over one parameter, maps over two, clouds of points over each of more.

use std::fmt::Write;

use super::Plan;
use super::table::{Head, Table, param_head};
use crate::app::line::parameters::Values;
use crate::app::line::plan::Design;
use crate::app::page::charts::{Chart, Line, figure};
use crate::app::page::map::{Axis, Cells, Map};
use crate::app::writing::html::escape;
use crate::app::writing::numbers::{digits, in_unit};
use crate::{AnyModel, ParamKind};

/// Columns of one output or mode, by their index in the table.
fn groups(heads: &[Head]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, head) in heads.iter().enumerate() {
        let same = |group: &&mut Vec<usize>| heads[group[0]].name == head.name && heads[group[0]].unit == head.unit;
        match groups.iter_mut().find(same) {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    groups
}

/// The part of the page with all pictures.
///
/// # Errors
/// A picture that cannot be drawn.
pub(super) fn part(model: &dyn AnyModel, plan: &Plan, table: &Table) -> Result<String, String> {
    let mut page = String::new();
    match (plan.design, plan.varied.len()) {
        (Design::Grid, 1) => curves(model, plan, table, &mut page)?,
        (Design::Grid, 2) => maps(model, plan, table, &mut page)?,
        _ => clouds(model, plan, table, &mut page)?,
    }
    if plan.design != Design::Grid {
        statistics(table, &mut page);
    }
    Ok(page)
}

/// All results over each parameter, as dots.
///
/// # Errors
/// A picture that cannot be drawn.
pub(super) fn clouds_of(model: &dyn AnyModel, plan: &Plan, table: &Table) -> Result<String, String> {
    let mut page = String::new();
    clouds(model, plan, table, &mut page)?;
    Ok(page)
}

/// The parameter's value in its declared unit; of files the number in their list.
fn shown(model: &dyn AnyModel, plan: &Plan, value: f64, place: usize) -> f64 {
    match files(model, plan, place) {
        Some(files) => (files.iter().position(|file| *file == value)).map_or(f64::NAN, |at| (at + 1) as f64),
        None => value / model.params()[plan.varied[place].param].unit_si,
    }
}

/// The files of a parameter that names them.
fn files<'p>(model: &dyn AnyModel, plan: &'p Plan, place: usize) -> Option<&'p [f64]> {
    let one = &plan.varied[place];
    match (model.params()[one.param].kind, &one.values) {
        (ParamKind::Table(_), Values::List(files)) => Some(files),
        _ => None,
    }
}

/// What stands at the axis of a parameter: its name and unit, or which file has which number.
fn named(model: &dyn AnyModel, plan: &Plan, place: usize) -> String {
    let param = &model.params()[plan.varied[place].param];
    let Some(files) = files(model, plan, place) else {
        return param_head(model, plan.varied[place].param);
    };
    let names = files.iter().enumerate();
    let names: Vec<String> = names
        .map(|(at, file)| format!("{} = {}", at + 1, in_unit(param, *file)))
        .collect();
    format!("{}: {}", param.name, names.join(", "))
}

/// A chart over one parameter; of each column of the group a line, or dots.
fn over(model: &dyn AnyModel, plan: &Plan, table: &Table, group: &[usize], place: usize) -> (Chart, String) {
    let unit = &table.heads[group[0]].unit;
    let mut chart = Chart {
        x: named(model, plan, place),
        y: format!("{} [{unit}]", table.heads[group[0]].name),
        ..Chart::default()
    };
    let mut names = Vec::new();
    let is_curve = plan.varied.len() == 1 && plan.design == Design::Grid;
    for (color, &index) in group.iter().enumerate() {
        let points = table
            .column(index)
            .map(|(row, value)| (shown(model, plan, row.params[place], place), value));
        let mut points: Vec<(f64, f64)> = points.collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let line = match is_curve {
            true => Line::new(points, color),
            false => Line::dots(points, color),
        };
        chart.lines.push(line.named(table.heads[index].what));
        names.push(format!("<i class=\"key k{color}\"></i>{}", table.heads[index].what));
    }
    // Last values are seen before the extremes, which often are the same.
    chart.lines.reverse();
    let caption = format!(
        "{}<span class=\"keys\">{}</span>",
        escape(&table.heads[group[0]].name),
        names.join(" &nbsp; ")
    );
    (chart, caption)
}

fn curves(model: &dyn AnyModel, plan: &Plan, table: &Table, page: &mut String) -> Result<(), String> {
    for group in groups(&table.heads) {
        let (chart, caption) = over(model, plan, table, &group, 0);
        figure(page, &caption, &chart, "")?;
    }
    Ok(())
}

fn clouds(model: &dyn AnyModel, plan: &Plan, table: &Table, page: &mut String) -> Result<(), String> {
    for group in groups(&table.heads) {
        for place in 0..plan.varied.len() {
            let (chart, caption) = over(model, plan, table, &group, place);
            figure(page, &caption, &chart, "")?;
        }
    }
    Ok(())
}

fn maps(model: &dyn AnyModel, plan: &Plan, table: &Table, page: &mut String) -> Result<(), String> {
    let axis = |place: usize| {
        if let Some(files) = files(model, plan, place) {
            return files.to_vec();
        }
        let points = plan.points.iter().map(|point| point[place]);
        let mut values: Vec<f64> = points.collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let (x, y) = (axis(0), axis(1));
    let drawn = |place: usize, values: &[f64]| Axis {
        name: named(model, plan, place),
        values: values.iter().map(|value| shown(model, plan, *value, place)).collect(),
        logarithmic: files(model, plan, place).is_none() && is_geometric(values),
    };
    for index in shown_columns(table) {
        let head = &table.heads[index];
        let mut cells = vec![f64::NAN; x.len() * y.len()];
        for (row, value) in table.column(index) {
            let place = |values: &[f64], value: f64| values.iter().position(|known| *known == value);
            if let (Some(column), Some(line)) = (place(&x, row.params[0]), place(&y, row.params[1])) {
                cells[line * x.len() + column] = value;
            }
        }
        let map = Map {
            heading: head.text(),
            x: drawn(0, &x),
            y: drawn(1, &y),
            cells: Cells::Signed(cells),
            marks: Vec::new(),
        };
        *page += &map.part()?;
    }
    Ok(())
}

/// Whether ratios of the values are more alike than their differences.
fn is_geometric(values: &[f64]) -> bool {
    let largest = |steps: &dyn Fn(f64, f64) -> f64| {
        let steps = values.windows(2).map(|pair| steps(pair[0], pair[1]));
        let (low, high) = steps.fold((f64::INFINITY, 0.0_f64), |(low, high), step| {
            (low.min(step), high.max(step))
        });
        high / low
    };
    values[0] > 0.0 && largest(&|a, b| (b / a).ln()) < largest(&|a, b| b - a)
}

/// Of every output its last value and that of the extremes which is larger; of modes all.
fn shown_columns(table: &Table) -> Vec<usize> {
    let size = |index: usize| {
        table
            .column(index)
            .fold(0.0, |most: f64, (_, value)| most.max(value.abs()))
    };
    let mut shown = Vec::new();
    for group in groups(&table.heads) {
        let is = |what: &str| group.iter().copied().find(|&index| table.heads[index].what == what);
        match (is("min"), is("max")) {
            (Some(low), Some(high)) => {
                shown.extend(is("last"));
                shown.push(if size(low) > size(high) { low } else { high });
            }
            _ => shown.extend(group),
        }
    }
    shown
}

fn statistics(table: &Table, page: &mut String) {
    page.push_str("<h2>Statistics</h2>\n<div class=\"scroll\"><table>\n<tr><th>Result</th>");
    for head in ["Mean", "Standard deviation", "5 %", "Median", "95 %"] {
        let _ = write!(page, "<th>{head}</th>");
    }
    page.push_str("</tr>\n");
    let statistics = table.statistics();
    for entry in statistics.as_array().into_iter().flatten() {
        let text = |key: &str| entry[key].as_str().unwrap_or_default();
        let head = format!("{} {} [{}]", text("name"), text("what"), text("unit"));
        let _ = write!(page, "<tr><td>{}</td>", escape(&head));
        for key in ["mean", "deviation", "p05", "p50", "p95"] {
            let value = entry[key].as_f64().unwrap_or(f64::NAN);
            let _ = write!(page, "<td class=\"n\">{}</td>", digits(value, 6));
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</table></div>\n");
}
