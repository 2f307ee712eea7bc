//! Points with their relative errors: who competes, what is cheapest, what an error costs.

use super::errors::{scales, worst};
use super::grid::Grid;
use super::peers::Peer;
use super::reference::References;
use super::select::{cheapest, cost_at};
use super::table::{Outcome, Point};
use crate::app::line::chart::method_name;
use crate::app::writing::numbers::digits;
use crate::{AnyModel, Formulation, Method};

/// Errors below so many times the reference's own uncertainty are not known well enough.
const MARGIN: f64 = 3.0;
/// An output that changes by less than this part of its value does not change.
const ROUND_OFF: f64 = 1e-12;

/// The columns whose errors count, and by what they are divided.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Measure {
    /// Indices of the columns.
    pub chosen: Vec<usize>,
    /// Names of these.
    pub names: Vec<String>,
    /// Largest change of every column, chosen or not, SI.
    pub scales: Vec<f64>,
    /// Columns that were left out because they do not change.
    pub still: Vec<String>,
    /// Uncertainty of the reference in the measure of the errors; `None` where it is not known.
    pub uncertainty: Option<f64>,
}

impl Measure {
    /// Of the columns that were asked for, or of all that change.
    ///
    /// # Errors
    /// A column that was asked for and does not change; or none does.
    pub fn new(model: &dyn AnyModel, references: &References, asked: Option<&[usize]>) -> Result<Self, String> {
        let exact = &references.exact;
        let scales = scales(model, exact);
        let is_still = |&index: &usize| {
            let size = exact.column(index).fold(0.0_f64, |size, value| size.max(value.abs()));
            let unknown = references.uncertainty.as_ref().map_or(0.0, |errors| errors[index].max);
            scales[index] <= (ROUND_OFF * size).max(MARGIN * unknown)
        };
        let name = |index: usize| exact.columns[index].name.clone();
        let all: Vec<usize> = (0..scales.len()).collect();
        let (still, moving): (Vec<usize>, Vec<usize>) = asked.unwrap_or(&all).iter().partition(|index| is_still(index));
        let still: Vec<String> = still.into_iter().map(name).collect();
        match (asked, &still[..], &moving[..]) {
            (Some(_), [first, ..], _) => {
                return Err(format!(
                    "output `{first}` does not change by more than the reference is uncertain, so that it has no relative error; choose others with `--outputs`"
                ));
            }
            (_, _, []) => return Err("no output changes by more than the reference is uncertain".into()),
            _ => {}
        }
        let uncertainty = references
            .uncertainty
            .as_ref()
            .map(|errors| worst(errors, &scales, &moving));
        Ok(Self {
            names: moving.iter().map(|&index| name(index)).collect(),
            chosen: moving,
            scales,
            still,
            uncertainty,
        })
    }

    /// Error below which points do not compete.
    pub fn floor(&self) -> Option<f64> {
        self.uncertainty.map(|uncertainty| MARGIN * uncertainty)
    }
}

/// All that a chart shows.
pub(super) struct Judged<'c> {
    /// The model with the parameters that are not the default ones.
    pub title: &'c str,
    pub grid: &'c Grid,
    pub references: &'c References,
    pub measure: &'c Measure,
    pub found: &'c [Option<Point>],
    pub peers: &'c [Peer],
    pub wanted: &'c [f64],
}

impl Judged<'_> {
    /// Largest error of a complete run relative to the change of its output, the worst of those that count.
    pub fn error(&self, point: &Point) -> Option<f64> {
        let measure = self.measure;
        (point.outcome == Outcome::Complete).then(|| worst(&point.errors, &measure.scales, &measure.chosen))
    }

    /// The same against the converged run on the same mesh.
    pub fn time_error(&self, point: &Point) -> Option<f64> {
        let measure = self.measure;
        (point.outcome == Outcome::Complete).then(|| worst(&point.time_errors, &measure.scales, &measure.chosen))
    }

    /// Whether the reference is too uncertain for a point.
    pub fn is_hollow(&self, point: &Point) -> bool {
        match (self.error(point), self.measure.floor()) {
            (Some(error), Some(floor)) => error < floor,
            _ => false,
        }
    }

    /// All points that are there.
    pub fn points(&self) -> impl Iterator<Item = &Point> {
        self.found.iter().flatten()
    }

    /// Complete points whose error is known well enough and which `has` names, with their costs and errors.
    pub fn competing(
        &self,
        cost: impl Fn(&Point) -> Option<f64>,
        has: impl Fn(&Point) -> bool,
    ) -> Vec<(&Point, (f64, f64))> {
        let points = self.points().filter(|point| has(point) && !self.is_hollow(point));
        let with = points.filter_map(|point| Some((point, (cost(point)?, self.error(point)?))));
        with.collect()
    }

    /// The point that reaches an error in the least processor time.
    pub fn cheapest(&self, wanted: f64) -> Option<&Point> {
        let competing = self.competing(|point| point.cpu, |_| true);
        let costs: Vec<(f64, f64)> = competing.iter().map(|entry| entry.1).collect();
        cheapest(&costs, wanted).map(|index| competing[index].0)
    }

    /// Processor time to an error, s, between two settings where it lies there.
    pub fn time_to(&self, wanted: f64, has: impl Fn(&Point) -> bool) -> Option<f64> {
        let competing = self.competing(|point| point.cpu, has);
        let costs: Vec<(f64, f64)> = competing.iter().map(|entry| entry.1).collect();
        cost_at(&costs, wanted)
    }

    /// The same of another code.
    pub fn time_of(&self, code: &str, wanted: f64) -> Option<f64> {
        let peers = self.peers.iter().filter(|peer| peer.code == code);
        let costs: Vec<(f64, f64)> = peers.map(|peer| (peer.cpu, peer.error)).collect();
        cost_at(&costs, wanted)
    }

    /// Names of the other codes.
    pub fn codes(&self) -> Vec<&str> {
        let mut codes: Vec<&str> = Vec::new();
        for peer in self.peers {
            if !codes.contains(&peer.code.as_str()) {
                codes.push(&peer.code);
            }
        }
        codes
    }

    /// For each formulation and method, then each other code: its name and the time to each wanted error, s.
    pub fn times(&self) -> Vec<(String, Vec<Option<f64>>)> {
        let of = |formulation: Formulation, method: Method| {
            let has = move |point: &Point| point.setting.formulation == formulation && point.setting.method == method;
            let times = self.wanted.iter().map(|&wanted| self.time_to(wanted, has)).collect();
            (format!("{} {}", formulation.name(), method_name(method)), times)
        };
        let grid = self.grid;
        let ours = grid.formulations.iter().flat_map(|&formulation| {
            let methods = grid.methods.iter();
            methods.map(move |&method| of(formulation, method))
        });
        let others = self.codes().into_iter().map(|code| {
            let times = self.wanted.iter().map(|&wanted| self.time_of(code, wanted)).collect();
            (code.to_owned(), times)
        });
        ours.chain(others).collect()
    }

    /// The cheapest setting for each wanted error in words, one line each.
    pub fn lines(&self) -> Vec<String> {
        self.wanted.iter().map(|&wanted| self.line(wanted)).collect()
    }

    fn line(&self, wanted: f64) -> String {
        let Some(point) = self.cheapest(wanted) else {
            if self.measure.floor().is_some_and(|floor| wanted < floor) {
                return format!("{wanted:e}: the reference is not exact enough for that: give tighter `--rtols`");
            }
            let least = self
                .competing(|point| point.cpu, |_| true)
                .iter()
                .map(|entry| entry.1.1)
                .fold(f64::INFINITY, f64::min);
            return if least.is_finite() {
                format!("{wanted:e}: nothing here is that good; the least error is {least:.1e}")
            } else {
                format!("{wanted:e}: no point competes yet")
            };
        };
        let mut line = format!(
            "{wanted:e}: {}: {}, {} steps, {} factorizations (error {:.1e})",
            self.grid.name(&point.setting),
            point.cpu.map_or_else(String::new, time),
            point.counts.steps,
            point.counts.factorizations,
            self.error(point).unwrap_or(f64::NAN),
        );
        let own = |other: &Point| other.setting.formulation == point.setting.formulation;
        if let Some(best) = self.time_to(wanted, own) {
            let others = self
                .grid
                .formulations
                .iter()
                .filter(|&&other| other != point.setting.formulation);
            for &other in others {
                let of = |point: &Point| point.setting.formulation == other;
                line += &times_as_long(other.name(), self.time_to(wanted, of), best);
            }
            for code in self.codes() {
                line += &times_as_long(code, self.time_of(code, wanted), best);
            }
        }
        line
    }
}

fn times_as_long(name: &str, seconds: Option<f64>, best: f64) -> String {
    match seconds {
        Some(seconds) => format!("; {name} {} x", digits(seconds / best, 3)),
        None => format!("; {name} is never that good"),
    }
}

/// A processor time for people.
pub(super) fn time(seconds: f64) -> String {
    if seconds < 1e-3 {
        format!("{} \u{b5}s", digits(1e6 * seconds, 3))
    } else if seconds < 1.0 {
        format!("{} ms", digits(1e3 * seconds, 3))
    } else {
        format!("{} s", digits(seconds, 3))
    }
}
