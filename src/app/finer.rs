//! Whether the outputs of a run depend on its meshes: it is repeated with twice as many elements.
//!
//! From one state it is seen by how much elements are too stiff (`coarse.rs`), and not what becomes of it along a path: a frequency that is off by a
//! thousandth is a phase that is off by any part after enough turns, and a rope whose strain energy is nothing beside its kinetic energy goes another way.
//! So the same motion is found again on finer meshes, without modes, by Radau with a tolerance that suffices for the parts that are told. Where outputs differ,
//! the same is done on the meshes of the run: what differs between both is the error of the mesh, and what differs between this and the run that
//! of its steps.

use super::accumulated::Ended;
use super::marks::{Again, Marks, TOLD, again, is_judged, told};
use crate::model::Fidelity;
use crate::{Method, Options, Output, Scene, State, StepSize};

/// Elements for each one of the run.
pub(super) const FINER: usize = 2;
/// Tolerance that suffices for the parts that are told, of most motions. The error of Radau is more than ten times less with a tenth of it.
const RTOL: f64 = 1e-4;
const TEN: f64 = 10.0;
/// Part of the iterations of the run, times unknowns, that all of it may take,
const SHARE: f64 = 1.0;
/// or these: half a second of cables, some seconds of elements with sections;
const AFFORDED: f64 = 1.5e6;
/// of what is left the part for finer meshes. The rest takes those of the run as far.
const FIRST: f64 = 0.6;
/// Part of a difference that the errors of both steps may make.
const STEPS: f64 = 0.3;
/// Most bodies in the sentence.
const MOST: usize = 3;

/// What is found.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Found {
    /// Until when the run was compared, s, and whether that is all of it.
    pub until: f64,
    pub is_whole: bool,
    /// One sentence on the meshes, and one on steps, where outputs are off by much.
    pub mesh: Option<String>,
    pub steps: Option<String>,
}

impl Found {
    fn reaches(&mut self, seen: &Marks, all: &Marks) {
        self.until = seen.rows.last().map_or(0.0, |row| row.0);
        self.is_whole = seen.rows.len() == all.rows.len();
    }

    fn with(self, steps: Option<String>) -> Self {
        Self { steps, ..self }
    }

    /// What was found before, where this is of less of the run.
    fn or(self, earlier: Option<Self>) -> Self {
        match earlier {
            Some(earlier) if earlier.until > self.until => earlier,
            _ => self,
        }
    }
}

/// A scene with the state in which it starts.
pub(super) struct Begun<'s> {
    pub scene: &'s mut dyn Scene,
    pub start: State,
}

/// Compares a run that went from the start of `own` with the motion of the `finer` meshes, where there are any, and with that of other steps.
pub(super) fn compare(
    mut own: Begun<'_>,
    mut finer: Option<Begun<'_>>,
    run: Ended<'_>,
    outputs: &[Output],
    goes_on: &mut dyn FnMut() -> bool,
) -> Found {
    if !outputs.iter().any(is_judged) {
        return Found::default();
    }
    let unknowns = |of: &Begun<'_>| of.scene.unknowns().max(1) as f64;
    let mut left = AFFORDED.max(SHARE * run.iterations as f64 * unknowns(&own));
    let mut rows = |of: &mut Begun<'_>, rtol: f64, share: f64, marks: &Marks| {
        let how = Again {
            t_end: run.t_end,
            method: Method::Radau,
            options: Options {
                rtol,
                step: StepSize::Adaptive,
                ..run.options
            },
            most: (share * left / unknowns(of)).max(0.0) as u64,
        };
        let (rows, iterations) = again(of.scene, of.start.clone(), how, marks, goes_on);
        left -= iterations as f64 * unknowns(of);
        rows
    };
    let is_exact = run.method == Method::Radau && run.options.step == StepSize::Adaptive;
    let tolerances = tolerances(run.options.rtol, is_exact, finer.is_some());
    let mut earlier: Option<Found> = None;
    let mut on_steps = None;
    for (place, &rtol) in tolerances.iter().enumerate() {
        let is_last = place + 1 == tolerances.len();
        let mut seen = run.marks.clone();
        let mut found = Found::default();
        let there = finer.as_mut().map(|finer| rows(finer, rtol, FIRST, run.marks));
        if let Some(there) = &there {
            seen.rows.truncate(there.len());
            found.reaches(&seen, run.marks);
            if largest(&run.marks.differences(outputs, there, rtol)) <= TOLD {
                return found.or(earlier).with(on_steps);
            }
        }
        // The run itself serves where its steps are those of the second one.
        let mut steps = Vec::new();
        if !is_exact || run.options.rtol != rtol {
            let here = rows(&mut own, rtol, 1.0, &seen);
            steps = run.marks.differences(outputs, &here, rtol);
            seen = run.marks.with(here);
            found.reaches(&seen, run.marks);
        }
        let meshes = there.map_or(Vec::new(), |there| seen.differences(outputs, &there, rtol));
        if let Some(names) = told(outputs, &meshes) {
            let until = Some(found.until).filter(|_| !found.is_whole);
            found.mesh = Some(on_meshes(own.scene, &names, until));
        }
        let [by_meshes, by_steps] = [largest(&meshes), largest(&steps)];
        let looser = rtol / run.options.rtol;
        if !is_exact && is_last || is_exact && looser < 2.0 * TEN {
            // The error of the run is at most so much less than that of larger steps.
            let less = if is_exact { looser.max(1.0) } else { 1.0 };
            steps.iter_mut().for_each(|(_, part)| *part /= less);
            let sentence = told(outputs, &steps).map(|names| sentence_on_steps(&run, rtol, &names, is_exact));
            on_steps = sentence.or(on_steps);
        }
        if is_last || by_steps <= STEPS * by_meshes.max(TOLD) {
            return found.or(earlier).with(on_steps);
        }
        // The errors of these steps stand in the way of what is looked for.
        earlier = Some(found).filter(|_| by_meshes > by_steps);
    }
    earlier.unwrap_or_default().with(on_steps)
}

/// The tolerances to compare with, the largest first. Where outputs hardly differ, the first one suffices; else errors of meshes and
/// steps are told apart by smaller ones.
fn tolerances(rtol: f64, is_exact: bool, has_meshes: bool) -> Vec<f64> {
    let mut all = if is_exact && rtol > RTOL / TEN {
        vec![rtol / TEN]
    } else if is_exact {
        vec![RTOL, TEN * rtol]
    } else {
        vec![RTOL, 1e-2 * RTOL]
    };
    if is_exact && has_meshes {
        all.push(rtol);
    }
    all.dedup_by(|next, before| *next >= 0.99 * *before);
    all
}

fn sentence_on_steps(run: &Ended<'_>, rtol: f64, names: &str, is_exact: bool) -> String {
    let found = if is_exact && rtol > run.options.rtol {
        format!("with a tolerance of {rtol:.0e} outputs are so far away that those of this run may be off")
    } else {
        format!("Radau with a tolerance of {rtol:.0e} finds another motion, from which outputs differ")
    };
    format!(
        "The tolerance of {:e} holds for each step, and errors of {} steps add up: {found} by parts of their largest change or value, {names}. Take {}a smaller `--rtol`.",
        run.options.rtol,
        run.steps,
        if is_exact { "" } else { "`--integrator radau`, or " }
    )
}

fn largest(found: &[(usize, f64)]) -> f64 {
    found.first().map_or(0.0, |found| found.1)
}

fn on_meshes(scene: &dyn Scene, names: &str, until: Option<f64>) -> String {
    let described = scene.bodies();
    let deforming = described
        .iter()
        .filter(|body| !matches!(body.fidelity, Fidelity::Rigid | Fidelity::Point));
    let mut in_modes = false;
    let mut meshes: Vec<String> = Vec::new();
    for body in deforming {
        let elements = body.elements;
        meshes.push(if body.fidelity == Fidelity::Full {
            format!("`{}` ({elements})", body.name)
        } else {
            in_modes = true;
            format!("`{}` ({elements}, {})", body.name, body.fidelity)
        });
    }
    let others = meshes.len().saturating_sub(MOST);
    if others > 0 {
        meshes.truncate(MOST);
        meshes.push(format!("{others} more"));
    }
    let meshes = meshes.join(", ");
    let until = until.map_or(String::new(), |t| format!(" until {t:.3} s (farther was not looked)"));
    let [what, how, more] = if in_modes {
        [
            "The mesh is too coarse for this motion, or the modes are too few",
            " and without modes",
            ", or leave `modal` or `small` out",
        ]
    } else {
        ["The mesh is too coarse for this motion", "", ""]
    };
    format!(
        "{what}: with twice as many elements{how} in {meshes} outputs differ{until} by parts of their largest change or value, {names}. Take more elements in `mesh` (twice as many make it some ten times less){more}."
    )
}
