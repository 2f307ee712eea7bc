//! Whether equilibria depend on their meshes: the same way is gone with twice as many elements.
//!
//! The energy that is error (`coarse.rs`) belongs to one state. A straight column has none in front of its buckling, and buckles at a load that may be a
//! fifth too large; forces and stresses converge more slowly than energies.

use super::buckling::buckling;
use super::continuation::Line;
use crate::AnyModel;
use crate::app::judged::agreement;
use crate::app::judged::compared::{Off, TOLD};
use crate::app::judged::finer::Judging;
use crate::app::judged::finer_model::FinerModel;
use crate::app::judged::marks::{Marks, percent, told};
use crate::app::judged::meshes::on_meshes;
use crate::app::results::equilibria::EquilibriumSettings;
use crate::app::results::history::{Column, History};
use crate::equilibrium::Kind;
use crate::model::{DescribedBody, Operands};
use crate::modes::Critical;

/// Iterations of the own way, times unknowns, that the finer one may take,
const SHARE: f64 = 4.0;
/// or these.
const AFFORDED: f64 = 1.5e6;
/// Part of what an output is made of that counts as nothing: what Newton's iteration leaves, and any mesh of a zero.
const LEFT: f64 = 1e-7;
/// Outputs are measured as those of runs with this tolerance: not by less than a thousandth of their value.
const RTOL: f64 = 1e-6;
/// What the equilibria of one mesh are.
const THESE: &str = "these equilibria";

/// The equilibria of a model on its own meshes.
pub(in crate::app) struct Own<'e> {
    pub kind: Kind,
    pub settings: &'e EquilibriumSettings,
    pub history: &'e History,
    pub critical: &'e [Critical],
    /// Whether no equilibrium is missing at its end.
    pub is_whole: bool,
    pub bodies: &'e [DescribedBody],
    pub unknowns: usize,
    pub iterations: u64,
    /// What round-off makes of the outputs, and what they are made of, by columns.
    pub round_off: Vec<f64>,
    pub operands: Vec<Operands>,
}

/// What is found.
#[derive(Debug, Default)]
pub(in crate::app) struct Found {
    /// Whether anything was compared.
    pub is_compared: bool,
    /// One sentence where outputs or critical values are off by much.
    pub told: Option<String>,
    /// One where they are not.
    pub agreement: Option<String>,
    /// Outputs with how far they are off, as those of a run.
    pub off_by: Vec<(usize, f64)>,
}

impl Found {
    /// Why nothing is found.
    fn nothing(why: &str) -> Self {
        Self {
            agreement: Some(format!("Not compared with twice as many elements: {why}.")),
            ..Self::default()
        }
    }
}

/// Goes the way of `own` on finer meshes; `None` where no mesh changes.
pub(in crate::app) fn compare(model: &dyn AnyModel, own: &Own<'_>, goes_on: &mut dyn FnMut() -> bool) -> Option<Found> {
    let finer = FinerModel::of(model);
    let most = match own.settings.judged {
        Judging::No => return None,
        Judging::Affordable => AFFORDED.max(SHARE * own.iterations as f64 * own.unknowns as f64),
        Judging::Whole => f64::INFINITY,
    };
    let mut line = match Line::start(&finer, own.kind, own.settings) {
        Ok(line) => line,
        Err(error) => return Some(Found::nothing(&error.to_string())),
    };
    let scene = &line.station().scene;
    let unknowns = scene.unknowns();
    if scene.bodies() == own.bodies {
        return None;
    }
    let mut rows: Vec<Row> = Vec::new();
    let mut critical = Vec::new();
    loop {
        let is_balanced = line.begins_balanced || line.last_two().0.is_some();
        let station = line.station();
        let mut row = vec![0.0; station.scene.output_columns()];
        station.scene.uniform_outputs(&station.at, station.state, &mut row);
        if is_balanced {
            rows.push((station.key, row));
        }
        if line.is_done() {
            break;
        }
        if !goes_on() {
            return None;
        }
        if line.iterations as f64 * unknowns as f64 > most {
            return Some(Found::nothing(
                "it would take several times as long (`--thorough` takes it)",
            ));
        }
        if let Err(text) = line.advance() {
            if own.is_whole && rows.len() < 2 {
                // That Newton's iteration does not even begin says nothing of the own mesh.
                return Some(Found::nothing(&text));
            }
            break;
        }
        critical.extend(buckling(&mut line));
    }
    let ends = [own.history.keys.last().copied()?, rows.last()?.0];
    let (mut here, mut there) = common(own.history, &rows);
    if !line.begins_balanced {
        // Without an equilibrium of no loads that they could change from, outputs are measured by their values.
        here.insert(0, (0.0, vec![0.0; own.history.columns.len()]));
        there.insert(0, vec![0.0; own.history.columns.len()]);
    }
    let mut marks = Marks::default();
    (marks.rows, marks.round_off, marks.operands) = (here, own.round_off.clone(), own.operands.clone());
    let outputs = model.outputs();
    let known = marks.above(outputs, &there, LEFT);
    let off = marks.between_equilibria(outputs, &there, &known, RTOL);
    let key = &own.history.key;
    let values = told_of_values(key, own.critical, &critical);
    let of_values = farthest(own.critical, &critical);
    let beyond = (own.is_whole && !line.is_done()).then(|| {
        let last = key.at(ends[1], 4);
        format!("no equilibrium is found beyond {last}, and none may be there")
    });
    let ends = told_of_ends(key, ends, own.is_whole).filter(|_| values.is_none());
    let names: Vec<String> = told(outputs, &off)
        .into_iter()
        .chain(values)
        .chain(ends)
        .chain(beyond)
        .collect();
    Some(Found {
        is_compared: true,
        told: (!names.is_empty()).then(|| on_meshes(own.bodies, (THESE, None), &names.join(", "))),
        agreement: names
            .is_empty()
            .then(|| agreement::of_equilibria(outputs, &off, of_values))
            .flatten(),
        off_by: off.iter().filter_map(Off::known).collect(),
    })
}

/// A key and the outputs there.
type Row = (f64, Vec<f64>);

/// Rows of both at the same keys, in the order of the way.
fn common(own: &History, rows: &[Row]) -> (Vec<Row>, Vec<Vec<f64>>) {
    let width = own.columns.len();
    let mut there = rows.iter().peekable();
    let mut both = (Vec::new(), Vec::new());
    for (row, &key) in own.keys.iter().enumerate() {
        // Either way may have taken shorter steps somewhere.
        let mut ahead = there.clone();
        if let Some((_, other)) = ahead.find(|(of, _)| *of == key) {
            both.0.push((key, own.values[row * width..(row + 1) * width].to_vec()));
            both.1.push(other.clone());
            there = ahead;
        }
    }
    both
}

/// Critical values, each as often as directions are critical there: round-off parts two directions of a round shaft, or not.
fn one_by_one(values: &[Critical]) -> impl Iterator<Item = &Critical> {
    values
        .iter()
        .flat_map(|value| std::iter::repeat_n(value, value.change.unsigned_abs()))
}

/// How far a critical value is off, as part of it.
fn apart((own, finer): (&Critical, &Critical)) -> f64 {
    (own.value - finer.value).abs() / own.value.abs()
}

/// The largest of these parts. Both may lie in the same gap, in which neither is known.
pub(in crate::app) fn farthest(own: &[Critical], finer: &[Critical]) -> Option<f64> {
    let part = |both: (&Critical, &Critical)| apart(both).max(both.0.within / both.0.value.abs());
    let both = one_by_one(own).zip(one_by_one(finer));
    both.map(part).reduce(f64::max)
}

/// What critical values are off by, where that is much.
pub(in crate::app) fn told_of_values(key: &Column, own: &[Critical], finer: &[Critical]) -> Option<String> {
    let mut parts: Vec<String> = one_by_one(own)
        .zip(one_by_one(finer))
        .map(|both| (both.0.value, apart(both)))
        .filter(|(_, part)| *part > TOLD)
        .map(|(value, part)| format!("the critical value {} by {}", at(key, value), percent(part)))
        .collect();
    parts.dedup();
    let [here, there] = [own, finer].map(|values| one_by_one(values).count());
    if here != there {
        parts.push(format!("the number of critical values is {there} and not {here}"));
    }
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Where one way ends early, and not where the other one does.
fn told_of_ends(key: &Column, [here, there]: [f64; 2], is_whole: bool) -> Option<String> {
    let part = (here - there).abs() / here.abs().max(there.abs());
    (!is_whole && part > TOLD).then(|| format!("the way ends {} and not {}", at(key, there), at(key, here)))
}

fn at(key: &Column, value: f64) -> String {
    format!("at {}", key.at(value, 4))
}
