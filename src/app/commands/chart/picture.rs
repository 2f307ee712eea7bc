//! The two pictures of a chart: error over time, and error over steps and factorizations.

use super::judged::Judged;
use super::scatter::{Axis, Dot, Entry, Look, Marker, Panel, Scatter, Series};
use super::select::front;
use super::table::Point;
use crate::Formulation;
use crate::app::line::chart::method_name;
use crate::app::page::charts::live;

/// Faintest shade of a mesh.
const FAINT: f64 = 0.35;
/// Markers of other codes, again from the start where there are more.
const OTHERS: [Marker; 2] = [Marker::Diamond, Marker::Square];
/// Colour of other codes.
const GREY: usize = 5;

/// A cost of a point.
type Cost = fn(&Point) -> Option<f64>;

/// Error over processor time.
pub(super) fn time_chart(judged: &Judged<'_>) -> Scatter {
    scatter(judged, vec![over_time(judged)])
}

/// Error over steps, and over factorizations.
pub(super) fn work_chart(judged: &Judged<'_>) -> Scatter {
    scatter(judged, vec![over_steps(judged), over_factorizations(judged)])
}

/// The three charts one after the other, as figures of a page.
pub(super) fn part(judged: &Judged<'_>) -> String {
    let mut page = String::new();
    for (caption, panel) in [
        ("Error over processor time", over_time(judged)),
        ("Error over steps", over_steps(judged)),
        ("Error over factorizations", over_factorizations(judged)),
    ] {
        let data = panel.to_json();
        live(
            &mut page,
            caption,
            &scatter(judged, vec![panel]).to_svg(false),
            &data,
            "",
        );
    }
    page
}

fn over_time(judged: &Judged<'_>) -> Panel {
    let peers = |index: usize| Some((judged.peers[index].cpu, judged.peers[index].error));
    panel(judged, Axis::Time, |point| point.cpu, &peers)
}

fn over_steps(judged: &Judged<'_>) -> Panel {
    let peers = |index: usize| Some((judged.peers[index].steps as f64, judged.peers[index].error));
    panel(
        judged,
        Axis::Count("steps"),
        |point| Some(point.counts.steps as f64),
        &peers,
    )
}

/// Other codes do not tell theirs.
fn over_factorizations(judged: &Judged<'_>) -> Panel {
    panel(
        judged,
        Axis::Count("factorizations"),
        |point| Some(point.counts.factorizations as f64),
        &|_| None,
    )
}

fn scatter(judged: &Judged<'_>, panels: Vec<Panel>) -> Scatter {
    Scatter {
        title: judged.title.into(),
        panels,
        legend: legend(judged),
    }
}

fn look(judged: &Judged<'_>, point: &Point) -> Look {
    let grid = judged.grid;
    let color = grid
        .methods
        .iter()
        .position(|&method| method == point.setting.method)
        .unwrap_or(0);
    // Grey is for other codes.
    let color = color % GREY;
    Look {
        color,
        marker: marker(point.setting.formulation),
        shade: shade(judged, point.setting.mesh),
    }
}

fn marker(formulation: Formulation) -> Marker {
    match formulation {
        Formulation::Rncf => Marker::Circle,
        Formulation::Ancf => Marker::Triangle,
    }
}

fn shade(judged: &Judged<'_>, mesh: usize) -> f64 {
    let count = judged.grid.meshes.len();
    if count == 1 {
        return 1.0;
    }
    FAINT + (1.0 - FAINT) * mesh as f64 / (count - 1) as f64
}

fn panel(judged: &Judged<'_>, x: Axis, cost: Cost, peer: &dyn Fn(usize) -> Option<(f64, f64)>) -> Panel {
    let mut series: Vec<Series> = Vec::new();
    for chunk in judged.found.chunks(judged.grid.rtols.len()) {
        let Some(first) = chunk.iter().flatten().next() else {
            continue;
        };
        let dots = chunk.iter().flatten().filter_map(|point| {
            Some(Dot {
                x: cost(point)?,
                y: judged.error(point)?,
                is_hollow: judged.is_hollow(point),
                name: judged.grid.name(&point.setting),
            })
        });
        let name = judged.grid.name(&first.setting);
        series.push(Series {
            name: name.rsplit_once(", rtol").map_or("", |(series, _)| series).into(),
            look: look(judged, first),
            dots: dots.collect(),
        });
    }
    let mut competing: Vec<(f64, f64)> = judged
        .competing(cost, |_| true)
        .into_iter()
        .map(|entry| entry.1)
        .collect();
    for (index, code) in judged.codes().into_iter().enumerate() {
        let own = (0..judged.peers.len()).filter(|&peer| judged.peers[peer].code == code);
        let dots = own.filter_map(|index| {
            let (x, y) = peer(index)?;
            let name = format!("{code}, {}", judged.peers[index].setting);
            Some(Dot {
                x,
                y,
                is_hollow: false,
                name,
            })
        });
        let dots: Vec<Dot> = dots.collect();
        competing.extend(dots.iter().map(|dot| (dot.x, dot.y)));
        series.push(Series {
            name: code.into(),
            look: look_of_code(index),
            dots,
        });
    }
    competing.retain(|(_, error)| *error > 0.0 && *error <= super::scatter::LARGEST);
    Panel {
        x,
        y: format!("largest error of {} / largest change", names(&judged.measure.names)),
        series,
        front: front(&competing).into_iter().map(|index| competing[index]).collect(),
        floor: judged.measure.floor(),
    }
}

fn look_of_code(index: usize) -> Look {
    Look {
        color: GREY,
        marker: OTHERS[index % OTHERS.len()],
        shade: 1.0,
    }
}

/// Names of outputs, of many the first ones.
fn names(names: &[String]) -> String {
    match names {
        [a, b, c, _, ..] => format!("{a}, {b}, {c}, ..."),
        _ => names.join(", "),
    }
}

fn legend(judged: &Judged<'_>) -> Vec<Entry> {
    let grid = judged.grid;
    let look = |color: usize, marker: Marker, shade: f64| Look { color, marker, shade };
    let mut legend = vec![Entry::Heading("integrator")];
    for (color, &method) in grid.methods.iter().enumerate() {
        legend.push(Entry::Look(
            look(color % GREY, Marker::Circle, 1.0),
            method_name(method),
        ));
    }
    legend.push(Entry::Heading("coordinates"));
    for &formulation in &grid.formulations {
        legend.push(Entry::Look(
            look(0, marker(formulation), 1.0),
            formulation.name().to_uppercase(),
        ));
    }
    if grid.meshes.len() > 1 {
        legend.push(Entry::Heading("mesh"));
        for (mesh, entry) in grid.meshes.iter().enumerate() {
            legend.push(Entry::Look(
                look(0, Marker::Circle, shade(judged, mesh)),
                entry.name.clone(),
            ));
        }
    }
    let codes = judged.codes();
    if !codes.is_empty() {
        legend.push(Entry::Heading("other codes"));
    }
    for (index, code) in codes.into_iter().enumerate() {
        legend.push(Entry::Look(look_of_code(index), code.into()));
    }
    legend.push(Entry::Heading("points"));
    legend.push(Entry::Front("Pareto front".into()));
    if judged.points().any(|point| judged.is_hollow(point)) {
        legend.push(Entry::Hollow("below the reference's".into()));
        legend.push(Entry::Text("own uncertainty".into()));
    }
    legend
}
