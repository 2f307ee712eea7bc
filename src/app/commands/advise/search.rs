//! The search: runs the ladder, estimates errors, and finds the simplest rung that suffices.

use super::ladder::{Choices, Setting, descriptions};
use crate::AnyModel;
use crate::app::commands::chart::errors::{errors, scales, worst};
use crate::app::results::history::History;
use crate::model::Fidelity;

/// A run that came to its end.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    pub history: History,
    pub unknowns: usize,
    pub steps: u64,
    /// Processor time, s.
    pub cpu: f64,
    /// What the scene warns of and the model as declared does not.
    pub warnings: Vec<String>,
}

/// What became of a setting.
#[derive(Clone, Debug)]
pub(super) enum Outcome {
    Ran(Box<Trial>),
    /// There is no such scene, or it does not run; the text says why.
    Impossible(String),
    /// Ctrl-C.
    Interrupted,
}

/// Errors relative to the largest change of an output, the worst of those that count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Estimate {
    /// Difference from the next richer rung that ran, and from the one after it.
    pub next: [Option<f64>; 2],
    /// Difference from the richest rung.
    pub richest: f64,
}

/// A rung of the ladder.
#[derive(Clone, Debug)]
pub(super) struct Rung {
    pub setting: Setting,
    pub name: String,
    pub outcome: Outcome,
    pub estimate: Option<Estimate>,
    pub suffices: bool,
}

impl Rung {
    pub fn trial(&self) -> Option<&Trial> {
        match &self.outcome {
            Outcome::Ran(trial) => Some(trial),
            _ => None,
        }
    }
}

/// What the search has found.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    /// From cheap to rich; those of single bodies at the end.
    pub rungs: Vec<Rung>,
    /// The rung that counts as exact up to `remaining`.
    pub richest: Option<usize>,
    /// Estimated error of the richest rung by its mesh; `None` where there is one mesh only.
    pub remaining: Option<f64>,
    /// The simplest rung that suffices.
    pub named: Option<usize>,
    /// The model as it is declared.
    pub declared: Option<usize>,
    /// Whether that is no rung of the ladder but stands beside it.
    pub is_beside: bool,
    /// Columns that count.
    pub chosen: Vec<usize>,
    /// Columns' scales, SI.
    pub scales: Vec<f64>,
    pub is_interrupted: bool,
}

impl Found {
    /// Largest error of a rung, that of the richest included.
    pub fn error(&self, rung: usize) -> Option<f64> {
        let estimate = self.rungs[rung].estimate?;
        Some(estimate.richest + self.remaining.unwrap_or(0.0))
    }
}

/// Descriptions of a body that may fail in succession before still cheaper ones are not tried.
const FAILURES: usize = 2;
/// What moves less than this, relative to what moves most in its unit or to its own size, is round-off.
const STILL: f64 = 1e-9;

/// The search for one wanted accuracy.
pub(super) struct Search<'s> {
    pub model: &'s dyn AnyModel,
    pub choices: &'s Choices,
    /// Largest error that is wanted.
    pub wanted: f64,
    /// Columns that count; `None`: all that change.
    pub outputs: Option<&'s [usize]>,
    /// Runs a setting, with its name and an estimate of the share of the work that is done.
    pub solve: &'s mut dyn FnMut(&Setting, &str, f64) -> Outcome,
}

impl Search<'_> {
    /// Runs the ladder.
    pub fn run(mut self) -> Found {
        let mut found = Found::default();
        let full = self.meshes(&mut found);
        if !found.is_interrupted {
            self.descriptions(&mut found, &full);
        }
        self.declared(&mut found);
        if found.richest.is_none() {
            return found;
        }
        self.judge(&mut found);
        found.named = simplest(&found);
        if !found.is_interrupted {
            self.each_body(&mut found);
        }
        found
    }

    /// Runs one setting, unless it has run.
    fn tried(&mut self, found: &mut Found, setting: Setting) -> Option<usize> {
        if let Some(place) = found.rungs.iter().position(|rung| rung.setting == setting) {
            return Some(place);
        }
        let name = self.choices.name(self.model, &setting);
        let all = self.choices.meshes.len() + descriptions().len();
        let share = found.rungs.len() as f64 / (all + 3 * self.choices.bodies.len().saturating_sub(1)) as f64;
        let outcome = (self.solve)(&setting, &name, share.min(1.0));
        if matches!(outcome, Outcome::Interrupted) {
            found.is_interrupted = true;
            return None;
        }
        found.rungs.push(Rung {
            setting,
            name,
            outcome,
            estimate: None,
            suffices: false,
        });
        Some(found.rungs.len() - 1)
    }

    /// All nodal vectors on all meshes, from coarse to fine: the rungs that ran.
    fn meshes(&mut self, found: &mut Found) -> Vec<usize> {
        let mut ran = Vec::new();
        for mesh in 0..self.choices.meshes.len() {
            let setting = self.choices.together(Fidelity::Full, mesh);
            let Some(rung) = self.tried(found, setting) else {
                break;
            };
            if found.rungs[rung].trial().is_some() {
                ran.push(rung);
            }
        }
        if let Some(&richest) = ran.last() {
            self.measure(found, richest);
            found.remaining = self.remaining(found, &ran);
        }
        ran
    }

    /// Takes a rung as the one that counts as exact.
    fn measure(&self, found: &mut Found, richest: usize) {
        let Some(trial) = found.rungs[richest].trial() else {
            return;
        };
        (found.scales, found.chosen) = measure(self.model, &trial.history, self.outputs);
        found.richest = Some(richest);
    }

    /// Difference of two rungs that ran.
    fn difference(&self, found: &Found, a: usize, b: usize) -> Option<f64> {
        let (a, b) = (found.rungs[a].trial()?, found.rungs[b].trial()?);
        Some(difference(found, &a.history, &b.history))
    }

    /// Error of the finest mesh, from the last differences on the way to it as those of a geometric series.
    fn remaining(&self, found: &Found, full: &[usize]) -> Option<f64> {
        let difference = |back: usize| {
            let last = full.len().checked_sub(back)?;
            self.difference(found, *full.get(last.checked_sub(1)?)?, *full.get(last)?)
        };
        let last = difference(1)?;
        let ratio = difference(2).map_or(0.5, |before| if before > 0.0 { last / before } else { 0.5 });
        // Faster than quartering is taken as quartering: one lucky difference proves nothing. Slower ones are those of
        // the integration.
        let ratio = ratio.clamp(0.25, 0.75);
        Some(last * ratio / (1.0 - ratio))
    }

    /// The cheaper descriptions, from cheap to rich, on the coarsest mesh that suffices with all nodal vectors; they
    /// are put before those with all nodal vectors.
    fn descriptions(&mut self, found: &mut Found, full: &[usize]) {
        let richest = found.richest;
        let suffices = |&&rung: &&usize| {
            let error = richest.and_then(|richest| self.difference(found, rung, richest));
            error.is_some_and(|error| error + found.remaining.unwrap_or(0.0) <= self.wanted)
        };
        let counts = full.iter().find(suffices).or(full.last());
        let counts = counts.map(|&rung| found.rungs[rung].setting.counts.clone());
        let meshes = &self.choices.meshes;
        let mesh = counts.and_then(|counts| meshes.iter().position(|mesh| *mesh == counts));
        let mesh = mesh.unwrap_or(meshes.len() - 1);
        let before = found.rungs.len();
        for fidelity in descriptions()
            .into_iter()
            .filter(|fidelity| *fidelity != Fidelity::Full)
        {
            let setting = self.choices.together(fidelity, mesh);
            if self.tried(found, setting).is_none() {
                break;
            }
        }
        let count = found.rungs.len() - before;
        found.rungs.rotate_right(count);
        found.richest = richest.map(|richest| richest + count);
        if richest.is_none()
            && let Some(last) = (0..found.rungs.len())
                .rev()
                .find(|&rung| found.rungs[rung].trial().is_some())
        {
            self.measure(found, last);
        }
    }

    /// The model as it is declared, where it is no rung yet.
    fn declared(&mut self, found: &mut Found) {
        if !found.is_interrupted {
            let before = found.rungs.len();
            found.declared = self.tried(found, self.choices.as_declared());
            found.is_beside = found.rungs.len() > before;
        }
    }

    /// Estimates of all rungs that ran, against what is richer.
    fn judge(&self, found: &mut Found) {
        for rung in 0..found.rungs.len() {
            let richer = self.richer(found, rung);
            self.estimate(found, rung, &richer);
        }
    }

    /// The next two richer rungs that ran: of descriptions on a mesh those on it, then finer meshes.
    fn richer(&self, found: &Found, rung: usize) -> Vec<usize> {
        let is_full = |setting: &Setting| *setting == self.full_on(setting);
        let own = &found.rungs[rung].setting;
        let Some(mesh) = self.choices.meshes.iter().position(|mesh| *mesh == own.counts) else {
            return found.richest.into_iter().collect();
        };
        let follows = |&other: &usize| {
            let setting = &found.rungs[other].setting;
            let place = self.choices.meshes.iter().position(|mesh| *mesh == setting.counts);
            let is_finer = is_full(setting) && place.is_some_and(|place| place >= mesh);
            let is_same = setting.counts == own.counts && !is_full(own);
            let is_beside = found.is_beside && found.declared == Some(other);
            found.rungs[other].trial().is_some() && (is_finer || is_same) && !is_beside
        };
        (rung + 1..found.rungs.len()).filter(follows).take(2).collect()
    }

    /// The same mesh with all nodal vectors.
    fn full_on(&self, setting: &Setting) -> Setting {
        let mut full = self.choices.together(Fidelity::Full, 0);
        full.counts.clone_from(&setting.counts);
        full
    }

    /// Estimates the error of a rung against richer ones, the next first.
    fn estimate(&self, found: &mut Found, rung: usize, richer: &[usize]) {
        let Some(richest) = found.richest.and_then(|richest| self.difference(found, rung, richest)) else {
            return;
        };
        let next = [0, 1].map(|place| richer.get(place).and_then(|&other| self.difference(found, rung, other)));
        found.rungs[rung].estimate = Some(Estimate { next, richest });
        let worst = next.into_iter().flatten().chain(found.error(rung)).fold(0.0, f64::max);
        found.rungs[rung].suffices = worst <= self.wanted && !found.chosen.is_empty();
    }

    /// Takes each body alone as far down as it goes, with the others as found.
    fn each_body(&mut self, found: &mut Found) {
        if self.choices.bodies.len() < 2 {
            return;
        }
        for body in 0..self.choices.bodies.len() {
            let Some(mut above) = found.named.map(|named| vec![named]) else {
                return;
            };
            let fidelity = found.rungs[above[0]].setting.fidelity[body].1;
            let base = found.rungs[above[0]].setting.clone();
            let mut failures = 0;
            for lower in self.choices.below(body, fidelity) {
                let Some(rung) = self.tried(found, Choices::with(&base, body, lower)) else {
                    return;
                };
                if found.rungs[rung].trial().is_none() {
                    continue;
                }
                if found.rungs[rung].estimate.is_none() {
                    let richer: Vec<usize> = above.iter().rev().copied().collect();
                    self.estimate(found, rung, &richer);
                }
                if found.rungs[rung].suffices {
                    (found.named, failures) = (Some(rung), 0);
                } else {
                    failures += 1;
                }
                above.push(rung);
                if failures == FAILURES {
                    break;
                }
            }
        }
    }
}

/// Scales of all columns, SI, and those of the given columns (all without them) that change by more than round-off.
pub(super) fn measure(model: &dyn AnyModel, history: &History, outputs: Option<&[usize]>) -> (Vec<f64>, Vec<usize>) {
    let (scales, columns) = (scales(model, history), &history.columns);
    let moves = |&index: &usize| {
        let same = (0..columns.len()).filter(|&other| columns[other].unit == columns[index].unit);
        let most = same.map(|other| scales[other]).fold(0.0, f64::max);
        let size = history.column(index).map(f64::abs).fold(0.0, f64::max);
        scales[index] > STILL * most.max(size)
    };
    let chosen = match outputs {
        Some(outputs) => outputs.iter().copied().filter(moves).collect(),
        None => (0..columns.len()).filter(moves).collect(),
    };
    (scales, chosen)
}

/// Largest difference of two runs relative to the largest change of an output in the richest one.
pub(super) fn difference(found: &Found, a: &History, b: &History) -> f64 {
    worst(&errors(a, b), &found.scales, &found.chosen)
}

/// The first rung from below that suffices. Times do not take part, so that the advice is the same in every run.
fn simplest(found: &Found) -> Option<usize> {
    (0..found.rungs.len()).find(|&rung| found.rungs[rung].suffices)
}
