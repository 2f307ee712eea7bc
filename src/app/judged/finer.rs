//! Whether the outputs of a run depend on its meshes: it is repeated with twice as many elements.
//!
//! From one state it is seen by how much elements are too stiff (`coarse.rs`), and not what becomes of it along a path: a frequency that is off by a
//! thousandth is a phase that is off by any part after enough turns, and a rope whose strain energy is nothing beside its kinetic energy goes another way.
//! So the same motion is found again on finer meshes, without modes, by Radau with a tolerance that suffices for the parts that are told. Where outputs differ,
//! the same is done on the meshes of the run: what differs between both is the error of the mesh, and what differs between this and the run that
//! of its steps.

use std::cell::{Cell, RefCell};

use super::accumulated::Ended;
use super::compared::{Off, TOLD, count};
use super::marks::{Again, Marks, again, is_of_motion, largest, sorted, told};
use super::meshes::on_meshes;
use super::on_steps::{self, By, is_exact};
use super::rest::not_compared;
use crate::{Method, Options, Output, Scene, State, StepSize};

/// Elements for each one of the run.
pub(in crate::app) const FINER: usize = 2;
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
/// Part by which outputs of Radau with ten times the tolerance are off, from which on it is not taken for ten times the error of the run: where steps are too
/// long for what moves, both are wrong alike. A tenth of the tolerance tells.
const FAR: f64 = 2.0 * TOLD;
/// Longest step of that, as a part of the longest of the run: what moves by less than the tolerance, and grows, has steps that no tolerance chooses.
const SHORTER: f64 = 0.5;
/// Part of what Radau with a larger tolerance finds another method to be off by, below which a smaller tolerance comes nearer to it.
const NEARER: f64 = 0.5;
/// Part of the iterations of the run, times unknowns, that this may take.
const LAST: f64 = 2.5;
/// The work of Radau grows with the inverse of the tolerance to this power, at most.
const ORDER: f64 = 0.2;
/// How many smaller tolerances are tried where steps are as long as motions and loads allow, until it takes so many times the iterations.
const TRIES: usize = 4;
const OTHER: f64 = 1.3;
/// No tolerance is smaller: with 1e-13 round-off makes errors larger than they are with 1e-12.
const LEAST: f64 = 0.99e-12;
/// Iterations with ten times the tolerance, as a part of those of the run, from which on steps hardly follow it: by the order of the method there are a third less.
const ALIKE: f64 = 0.85;
/// How many smaller tolerances are tried for outputs that may be there, and be off, for all that larger ones tell.
const OPEN: usize = 2;

/// How far a run is compared with the same motion on finer meshes and with other steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Judging {
    /// Not at all.
    #[default]
    No,
    /// As far as it goes in about the time of the run.
    Affordable,
    /// To the end of the run, however long it takes.
    Whole,
}

impl Judging {
    /// As it stands in summaries.
    pub fn name(self) -> &'static str {
        match self {
            Self::No => "no",
            Self::Affordable => "affordable",
            Self::Whole => "whole",
        }
    }
}

/// What is found.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::app) struct Found {
    /// Until when the run was compared, s, and whether that is all of it.
    pub until: f64,
    pub is_whole: bool,
    /// Whether there are finer meshes.
    pub has_meshes: bool,
    /// One sentence on the meshes, and one on steps, where outputs are off by much.
    pub mesh: Option<String>,
    pub steps: Option<String>,
    /// One sentence on what was not compared.
    pub rest: Option<String>,
    /// How far all outputs are off, for meshes or steps, as far as they were compared; the largest part first.
    pub off: Vec<Off>,
    /// The tolerance of steps that are in this, where that is much larger than needed for the tolerance of the run.
    pub looser: Option<f64>,
}

/// A scene with the state in which it starts.
pub(in crate::app) struct Begun<'s> {
    pub scene: &'s mut dyn Scene,
    pub start: State,
}

/// What is known of outputs of one kind, those of motion or the others.
struct Kind<'r> {
    run: Ended<'r>,
    outputs: &'r [Output],
    is_of_motion: bool,
    is_settled: bool,
    /// Whether nothing differed on finer meshes, with steps that may be as wrong as those of the run.
    is_near: bool,
    /// Until when they were compared, s.
    until: f64,
    /// Until when with steps that suffice, s.
    stepped: f64,
    /// Parts of outputs that are off for the mesh, until then, and, with what tells it, for steps.
    mesh: Vec<Off>,
    steps: (By, Vec<Off>),
    /// What all outputs of this kind are off by, for the mesh and for steps, and the tolerance with which that was found.
    seen: [Vec<Off>; 2],
    seen_with: f64,
    /// Whether ten times the tolerance of the run is so far away that a tenth has to tell.
    is_far: bool,
}

impl<'r> Kind<'r> {
    fn new(run: Ended<'r>, outputs: &'r [Output], is_motion: bool) -> Self {
        Self {
            run,
            outputs,
            is_of_motion: is_motion,
            is_settled: !outputs.iter().any(|output| is_of_motion(output) == is_motion),
            is_near: false,
            until: 0.0,
            stepped: if run.is_compared { f64::INFINITY } else { 0.0 },
            mesh: Vec::new(),
            steps: (By::Radau(0.0), Vec::new()),
            seen: [Vec::new(), Vec::new()],
            seen_with: 0.0,
            is_far: false,
        }
    }

    /// The parts that are of this kind.
    fn of(&self, parts: &[Off]) -> Vec<Off> {
        let same = |off: &&Off| is_of_motion(&self.outputs[off.output]) == self.is_of_motion;
        parts.iter().filter(same).copied().collect()
    }

    /// Whether one of these outputs is of this kind.
    fn has(&self, those: &[bool]) -> bool {
        let same = |(output, &is): (&Output, &bool)| is && is_of_motion(output) == self.is_of_motion;
        self.outputs.iter().zip(those).any(same)
    }

    /// Nothing differs on finer meshes, found with a tolerance. The same method with a larger one is farther from the truth than the run is;
    /// another method may be off by as much, to the same side.
    fn meet_finer(&mut self, rtol: f64, until: f64, beyond: &[Off], open: &[bool]) {
        if !self.is_settled && largest(&self.of(beyond)) <= TOLD {
            self.is_near = !self.has(open);
            self.is_settled = self.is_near && (is_exact(&self.run) || rtol <= self.run.options.rtol);
            if self.is_settled {
                self.stepped = self.stepped.max(until);
            }
            if until >= self.until {
                (self.until, self.mesh) = (until, Vec::new());
                self.seen = [self.of(beyond), Vec::new()];
                self.seen_with = rtol;
            }
        }
    }

    /// What other meshes and other steps make of a second run with a tolerance.
    fn meet(&mut self, rtol: f64, is_last: bool, until: f64, [meshes, steps]: [&[Off]; 2], open: &[bool]) {
        if self.is_settled {
            return;
        }
        let (mut meshes, mut steps) = (self.of(meshes), self.of(steps));
        let is_exact = is_exact(&self.run);
        let [by_meshes, by_steps] = [largest(&meshes), largest(&steps)];
        let of = |parts: &[Off], index: usize| parts.iter().find(|of| of.output == index).map_or(0.0, |of| of.part);
        let mut is_clear = by_steps <= STEPS * by_meshes.max(TOLD);
        if !self.is_of_motion {
            // Steps that suffice for one force do not for another.
            is_clear = steps
                .iter()
                .all(|off| off.part <= STEPS * of(&meshes, off.output).max(TOLD));
            meshes.retain(|off| of(&steps, off.output) <= (STEPS * off.part).max(TOLD));
        }
        // What differs with larger steps alone is none of the mesh.
        let is_seen = |mesh: &Off| {
            let part = of(&meshes, mesh.output);
            part > TOLD && part > of(&steps, mesh.output)
        };
        let mesh: Vec<Off> = self.mesh.iter().copied().filter(is_seen).collect();
        let looser = rtol / self.run.options.rtol;
        if !is_exact && is_last || is_exact && looser < 2.0 * TEN {
            // The error of the run is at most so much less than that of larger steps.
            let is_looser = is_exact && looser > 1.0;
            // What joints exert, and accelerations, have errors that fall with the root of the tolerance: a difference of about twice those of the run.
            let (less, far) = match (is_looser, self.is_of_motion) {
                (true, true) => (looser, FAR),
                _ => (1.0, TOLD),
            };
            self.is_far |= is_looser && largest(&steps) > far;
            steps.iter_mut().for_each(|off| off.part /= less);
            if largest(&steps) > TOLD {
                self.steps = (By::Radau(rtol), steps.clone());
            }
        }
        self.is_settled = is_last || is_clear && !self.has(open);
        if self.is_settled {
            self.stepped = self.stepped.max(until);
        }
        if until >= self.until {
            self.seen[0].clone_from(&meshes);
            self.seen_with = rtol;
            // The run itself has no others.
            if !steps.is_empty() {
                self.seen[1] = steps;
            }
        }
        // Otherwise the errors of these steps stand in the way of what is looked for.
        if (self.is_settled || by_meshes > by_steps) && until >= self.until {
            meshes.retain(|mesh| mesh.part > TOLD);
            (self.until, self.mesh) = (until, meshes);
        } else if until >= self.until {
            self.mesh = mesh;
        }
    }

    /// Whether it is settled that outputs depend on the mesh.
    fn tells_of_meshes(&self) -> bool {
        self.is_settled && !self.mesh.is_empty()
    }

    /// What finer meshes make of all of the run with a tolerance near its own, where a larger one found that outputs hardly differ, or found that some do:
    /// steps that lead another way on one of both meshes are no error of the mesh.
    fn meet_near(&mut self, rtol: f64, beyond: &[Off]) {
        let beyond = self.of(beyond);
        self.seen = [beyond.clone(), Vec::new()];
        self.seen_with = rtol;
        self.mesh = beyond;
        self.mesh.retain(|mesh| mesh.part > TOLD);
    }

    /// What a smaller tolerance or a shorter step makes of all of the run.
    fn meet_shorter(&mut self, by: By, steps: &[Off]) {
        let steps = self.of(steps);
        self.seen[1].clone_from(&steps);
        self.steps = (by, if largest(&steps) > TOLD { steps } else { Vec::new() });
    }
}

/// What runs with different steps have found.
struct Sets<'r> {
    run: Ended<'r>,
    outputs: &'r [Output],
    /// Rows with the tolerance of Radau that found them, of finer meshes or not.
    sets: Vec<(Vec<Vec<f64>>, f64, bool)>,
    /// Outputs and components that two of them find alike: small as they may be beside what they are made of, they are there.
    known: Vec<bool>,
}

impl<'r> Sets<'r> {
    fn new(run: Ended<'r>, outputs: &'r [Output]) -> Self {
        Self {
            run,
            outputs,
            sets: Vec::new(),
            known: vec![false; count(outputs)],
        }
    }

    fn meet(&mut self, rows: &[Vec<f64>], rtol: f64, is_finer: bool) {
        let marks = self.run.marks;
        let mut alike = Vec::new();
        // Errors of the same steps may be alike.
        if !is_exact(&self.run) || differ(self.run.options.rtol, rtol) {
            alike.push(marks.known(self.outputs, &marks.rows, rows));
        }
        for (others, ..) in self.sets.iter().filter(|set| set.2 == is_finer && differ(set.1, rtol)) {
            alike.push(marks.known(self.outputs, &marks.with(others.clone()).rows, rows));
        }
        for alike in alike {
            self.known
                .iter_mut()
                .zip(alike)
                .for_each(|(known, alike)| *known |= alike);
        }
        self.sets.push((rows.to_vec(), rtol, is_finer));
    }

    /// How far the run is from others, of which a smaller tolerance may know more than the run promises: what is not there is off by its own tolerance.
    fn off(&self, rows: &[Vec<f64>], rtol: f64) -> Vec<Off> {
        let marks = self.run.marks;
        let rtol = if is_exact(&self.run) {
            rtol.max(self.run.options.rtol)
        } else {
            rtol
        };
        marks.between(self.outputs, &marks.rows, rows, &self.known, rtol)
    }

    fn open(&self, rows: &[Vec<f64>], rtol: f64) -> Vec<bool> {
        let marks = self.run.marks;
        marks.open(self.outputs, rows, &self.known, [self.run.options.rtol, rtol])
    }
}

/// Whether tolerances differ by so much that errors of steps do.
fn differ(one: f64, other: f64) -> bool {
    one.max(other) > 0.5 * TEN * one.min(other)
}

/// Compares a run that went from the start of `own` with the motion of the `finer` meshes, where there are any, and with that of other steps.
pub(in crate::app) fn compare(
    mut own: Begun<'_>,
    mut finer: Option<Begun<'_>>,
    run: Ended<'_>,
    outputs: &[Output],
    judging: Judging,
    goes_on: &mut dyn FnMut() -> bool,
) -> Found {
    let unknowns = |of: &Begun<'_>| of.scene.unknowns().max(1) as f64;
    let afforded = |share: f64, of: &Begun<'_>| match judging {
        Judging::Whole => f64::INFINITY,
        _ => AFFORDED.max(share * run.iterations as f64 * unknowns(of)),
    };
    let (left, last) = (Cell::new(afforded(SHARE, &own)), Cell::new(0.0));
    let failed = RefCell::new(None);
    let mut rows = |of: &mut Begun<'_>, (by, longest): (By, f64), share: f64, marks: &Marks| {
        let (method, rtol, step) = match by {
            By::Step(h) => (run.method, run.options.rtol, StepSize::Fixed(h)),
            By::Same(rtol) => (run.method, rtol, StepSize::Adaptive),
            By::Radau(rtol) if run.method.is_radau() => (run.method, rtol, StepSize::Adaptive),
            By::Radau(rtol) => (Method::Radau, rtol, StepSize::Adaptive),
        };
        let how = Again {
            t_end: run.t_end,
            method,
            options: Options {
                rtol,
                step,
                max_step: run.options.max_step.min(longest),
                ..run.options
            },
            // Of infinitely many there are u64::MAX.
            most: (share * left.get() / unknowns(of)).max(0.0) as u64,
        };
        let gone = again(of.scene, of.start.clone(), how, marks, goes_on);
        last.set(gone.iterations as f64 * unknowns(of));
        left.set(left.get() - last.get());
        if let Some(error) = gone.failed {
            failed.replace(Some((rtol, error)));
        }
        gone.rows
    };
    let mut kinds = [true, false].map(|is_motion| Kind::new(run, outputs, is_motion));
    let mut found_so_far = Sets::new(run, outputs);
    let (mut spent, mut is_alike) = (0.0, false);
    let tolerances = tolerances(&run, finer.is_some());
    for (place, &rtol) in tolerances.iter().enumerate() {
        if kinds.iter().all(|kind| kind.is_settled) {
            break;
        }
        let is_last = place + 1 == tolerances.len();
        let mut seen = run.marks.clone();
        let asks_meshes = kinds.iter().any(|kind| !kind.is_settled && !kind.is_near);
        let finer = finer.as_mut().filter(|_| asks_meshes);
        let there = finer.map(|finer| rows(finer, (By::Radau(rtol), f64::INFINITY), FIRST, run.marks));
        if place == 0 {
            spent = last.get();
        }
        if let Some(there) = &there {
            seen.rows.truncate(there.len());
            found_so_far.meet(there, rtol, true);
            let beyond = found_so_far.off(there, rtol);
            let open = found_so_far.open(there, rtol);
            for kind in &mut kinds {
                kind.meet_finer(rtol, seen.until(), &beyond, &open);
                if kind.tells_of_meshes() && there.len() == run.marks.rows.len() {
                    kind.meet_near(rtol, &beyond);
                }
            }
            if kinds.iter().all(|kind| kind.is_settled) {
                break;
            }
            if !is_last && kinds.iter().all(|kind| kind.is_settled || kind.is_near) {
                continue;
            }
        }
        // The run itself serves where its steps are those of the second one.
        let (mut steps, mut open) = (Vec::new(), Vec::new());
        if !is_exact(&run) || run.options.rtol != rtol {
            let here = rows(&mut own, (By::Radau(rtol), f64::INFINITY), 1.0, &seen);
            let all = run.iterations as f64 * unknowns(&own);
            is_alike |=
                here.len() == run.marks.rows.len() && last.get() >= ALIKE * all && differ(rtol, run.options.rtol);
            found_so_far.meet(&here, rtol, false);
            steps = found_so_far.off(&here, rtol);
            open = found_so_far.open(&here, rtol);
            seen = run.marks.with(here);
        }
        let meshes = there.map_or(Vec::new(), |there| {
            run.marks
                .between_meshes(outputs, &seen.rows, &there, &found_so_far.known, rtol)
        });
        kinds
            .iter_mut()
            .for_each(|kind| kind.meet(rtol, is_last, seen.until(), [&meshes, &steps], &open));
    }
    // A tolerance that suffices to tell of much finds errors of its own steps where those of the run are much less.
    let is_told = kinds.iter().any(Kind::tells_of_meshes);
    let near = (TEN * run.options.rtol).min(if is_told { RTOL / TEN } else { RTOL });
    let is_known = found_so_far.sets.iter().any(|set| set.2 && !differ(set.1, near));
    let expected = spent * (RTOL / near).powf(ORDER);
    if is_told {
        // Not to tell of a mesh what its steps do is worth as much again.
        left.set(left.get().max(afforded(SHARE, &own)));
    }
    if let Some(finer) = finer.as_mut().filter(|_| {
        let is_settled = kinds.iter().all(|kind| kind.is_settled && !kind.is_far);
        is_exact(&run) && near < RTOL && !is_known && is_settled && expected <= left.get()
    }) {
        let there = rows(finer, (By::Radau(near), f64::INFINITY), 1.0, run.marks);
        if there.len() == run.marks.rows.len() {
            found_so_far.meet(&there, near, true);
            let beyond = found_so_far.off(&there, near);
            kinds.iter_mut().for_each(|kind| kind.meet_near(near, &beyond));
        }
    }
    if !is_exact(&run) {
        let mut again = |by| {
            left.set(afforded(LAST, &own));
            rows(&mut own, (by, f64::INFINITY), 1.0, run.marks)
        };
        let smaller = tolerances[tolerances.len() - 1] / TEN;
        look_closer(&mut kinds, smaller, &found_so_far, &mut again);
    }
    // Where motions and loads shorten steps, or something else does, they are alike at ten times the tolerance, which then tells too little.
    let is_blind = is_exact(&run) && (run.is_shortened || is_alike);
    let has_open = |sets: &Sets<'_>| {
        let here = sets
            .sets
            .iter()
            .rev()
            .find(|set| !set.2 && set.0.len() == run.marks.rows.len());
        is_exact(&run) && here.is_some_and(|(rows, rtol, _)| sets.open(rows, *rtol).contains(&true))
    };
    // Errors that come from few steps, at the end of a stick or out of an unstable equilibrium, are with ten times the tolerance what they are with one.
    let is_quick = is_exact(&run) && LAST * run.iterations as f64 * unknowns(&own) <= AFFORDED;
    let tries = match () {
        () if is_blind => TRIES,
        () if has_open(&found_so_far) => OPEN,
        () => usize::from(is_quick || kinds.iter().any(|kind| kind.is_far)),
    };
    left.set(afforded(LAST, &own));
    let smaller = std::iter::successors(Some(run.options.rtol / TEN), |rtol| Some(rtol / TEN));
    for rtol in smaller.take(tries).take_while(|&rtol| rtol >= LEAST) {
        let here = rows(&mut own, (By::Radau(rtol), SHORTER * run.longest), 1.0, run.marks);
        if here.len() < run.marks.rows.len() {
            break;
        }
        found_so_far.meet(&here, rtol, false);
        let steps = found_so_far.off(&here, rtol);
        kinds
            .iter_mut()
            .for_each(|kind| kind.meet_shorter(By::Radau(rtol), &steps));
        // Until steps are others, and what they find is there.
        if last.get() >= OTHER * run.iterations as f64 * unknowns(&own) && !has_open(&found_so_far) {
            break;
        }
    }
    found(
        own.scene,
        &run,
        outputs,
        (judging, finer.is_some(), failed.take()),
        kinds,
    )
}

/// What a smaller tolerance of Radau makes of what a larger one told of another method. Where it comes nearer to the run, Radau is what is off, and the method
/// itself tells: half of a fixed step, or a tenth of its tolerance.
fn look_closer(
    kinds: &mut [Kind<'_>],
    smaller: f64,
    found_so_far: &Sets<'_>,
    rows: &mut dyn FnMut(By) -> Vec<Vec<f64>>,
) {
    let mut told: Vec<&mut Kind<'_>> = kinds.iter_mut().filter(|kind| !kind.steps.1.is_empty()).collect();
    let run = found_so_far.run;
    let own_way = match run.options.step {
        StepSize::Fixed(h) => By::Step(0.5 * h),
        StepSize::Adaptive => By::Same(run.options.rtol / TEN),
    };
    for by in [By::Radau(smaller), own_way] {
        if told.is_empty() {
            return;
        }
        let there = rows(by);
        if there.len() < run.marks.rows.len() {
            return;
        }
        let off = found_so_far.off(&there, smaller);
        let is_last = by == own_way;
        told.retain_mut(|kind| {
            let is_nearer = largest(&kind.of(&off)) <= NEARER * largest(&kind.steps.1);
            if is_last || !is_nearer {
                kind.meet_shorter(by, &off);
            }
            is_nearer
        });
    }
}

/// The sentences.
fn found(
    scene: &dyn Scene,
    run: &Ended<'_>,
    outputs: &[Output],
    (judging, has_meshes, failed): (Judging, bool, Option<(f64, String)>),
    kinds: [Kind<'_>; 2],
) -> Found {
    let there = || {
        kinds
            .iter()
            .filter(|kind| outputs.iter().any(|output| is_of_motion(output) == kind.is_of_motion))
    };
    // What differs for the mesh is told as far as it was seen.
    let until = |kind: &Kind<'_>| match kind.mesh.is_empty() {
        true => kind.until.min(kind.stepped),
        false => kind.until,
    };
    let until = there().map(until).fold(f64::INFINITY, f64::min);
    let until = if until.is_finite() { until } else { 0.0 };
    let whole = run.marks.until();
    let meshes = sorted(kinds.iter().flat_map(|kind| kind.mesh.clone()).collect());
    let seen = kinds.iter().filter(|kind| !kind.mesh.is_empty()).map(|kind| kind.until);
    let seen = Some(seen.fold(whole, f64::min)).filter(|&seen| seen < whole);
    let off = each(kinds.iter().flat_map(|kind| kind.seen.concat()).collect());
    let seen_with = kinds.iter().map(|kind| kind.seen_with).fold(0.0, f64::max);
    // Of another method than Radau, which has no tolerance in common with it, every tolerance but the smallest.
    let near = if is_exact(run) {
        TEN * run.options.rtol
    } else {
        1e-2 * RTOL
    };
    let looser = Some(seen_with).filter(|&with| with > near && differ(with, near));
    let [motion, others] = kinds.map(|kind| kind.steps);
    // What is off in places is off in forces too.
    let by = if motion.1.is_empty() { others.0 } else { motion.0 };
    let steps = sorted([motion.1, others.1].concat());
    Found {
        until,
        is_whole: until >= whole,
        has_meshes,
        rest: (until < whole)
            .then(|| not_compared([until, whole], !meshes.is_empty(), judging == Judging::Whole, failed))
            .flatten(),
        mesh: told(outputs, &meshes).map(|names| on_meshes(&scene.bodies(), ("this motion", seen), &names)),
        steps: on_steps::sentence(run, by, outputs, &steps, scene.unknowns() > scene.constraints()),
        off,
        looser,
    }
}

/// The largest part of each output.
pub(in crate::app) fn each(parts: Vec<Off>) -> Vec<Off> {
    let mut each: Vec<Off> = Vec::new();
    for off in sorted(parts) {
        if each.iter().all(|other| other.output != off.output) {
            each.push(off);
        }
    }
    each
}

/// The tolerances to compare with, the largest first. Where outputs hardly differ, the first one suffices; else errors of meshes and
/// steps are told apart by smaller ones.
fn tolerances(run: &Ended<'_>, has_meshes: bool) -> Vec<f64> {
    let (rtol, is_exact) = (run.options.rtol, is_exact(run));
    let loosest = if is_exact { RTOL.min(run.method.loosest()) } else { RTOL };
    let mut all = if is_exact && rtol > loosest / TEN {
        vec![rtol / TEN]
    } else if is_exact && has_meshes {
        vec![loosest, TEN * rtol]
    } else if is_exact {
        // Without meshes errors of steps are all there is: what a much larger tolerance finds says little of them.
        vec![TEN * rtol]
    } else {
        vec![RTOL, 1e-2 * RTOL]
    };
    if is_exact && has_meshes {
        all.push(rtol);
    }
    all.dedup_by(|next, before| *next >= 0.99 * *before);
    all
}
