//! All ways of all scenes: what agrees, what does not, and a log.

use std::collections::BTreeMap;
use std::time::Instant;

use rncf::{Formulation, Joints, Method};

use super::copies::{copy_of, factor, in_units, odd};
use super::grow::grow;
use super::rest::{rest, still};
use super::run::{Apart, Columns, History, Maker, Way, compare, run, scales};
use super::tree::{Kind, Load, Spring, Tie, Tree};
use super::write::{Copy, Observed, Quantity, text};

/// A compiled text: its maker and its columns.
pub type Compiled = (Maker, fn() -> Columns);

/// A compiled scene and its copy.
pub struct Entry {
    /// What it is made of.
    pub seed: u64,
    /// As it is.
    pub original: Compiled,
    /// Its copy, [`copy_of`].
    pub copy: Option<Compiled>,
}

/// Rows of a history that are compared.
const ROWS: usize = 11;
/// Runs with more attempts are given up and counted.
const MOST: u64 = 700;
/// Tolerance of the reference and of all that must equal it.
const TIGHT: f64 = 1e-7;
/// Tolerance with which fast vibrations are followed.
const FINE: f64 = 1e-9;
/// Tolerance of the runs that must come near it.
const LOOSE: f64 = 1e-5;
/// Tolerance of the local error of methods of order 2.
const SECOND: f64 = 1e-6;

/// Positions of a mesh that need not come nearer with twice the elements, of the size.
const MESHED: f64 = 2e-3;
const HHT: Method = Method::Hht { alpha: -0.05 };
const ALPHA: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };

/// What became of one check of one scene.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// Within its limits; the largest difference of positions over the size.
    Agrees(f64),
    /// Beyond them with the tight tolerance, within them with one that is a hundred times smaller.
    Unresolved(String),
    /// Beyond them: by how much what is off.
    Differs(String),
    /// The program said why not, or the run was given up.
    Refused(String),
}

/// Allowed differences, relative to what is largest of a quantity.
#[derive(Clone, Copy)]
struct Limits {
    position: f64,
    velocity: f64,
    force: f64,
}

/// Of runs with the tight tolerance. Forces follow accelerations of fast motions.
const EQUAL: Limits = Limits {
    position: 1e-5,
    velocity: 3e-4,
    force: 2e-2,
};
/// Of equilibria.
const STILL: Limits = Limits {
    position: 1e-6,
    velocity: 1e-6,
    force: 1e-5,
};
/// Of runs with another method or tolerance.
const NEAR: Limits = Limits {
    position: 1e-3,
    velocity: 1e-1,
    force: f64::INFINITY,
};

fn judge(apart: &[Apart], limits: Limits) -> Verdict {
    let mut position = 0.0f64;
    for part in apart {
        let limit = match part.quantity {
            Quantity::Position | Quantity::Angle => limits.position,
            Quantity::Velocity | Quantity::Spin | Quantity::Momentum | Quantity::AngularMomentum => limits.velocity,
            _ => limits.force,
        };
        if part.quantity == Quantity::Position {
            position = part.relative;
        }
        if part.relative.is_nan() || part.relative > limit {
            return Verdict::Differs(format!(
                "{:?} by {:.1e} of {:.2e}: {} at row {}; positions by {:.1e}",
                part.quantity,
                part.relative,
                part.size,
                part.of,
                part.row,
                apart
                    .iter()
                    .find(|part| part.quantity == Quantity::Position)
                    .map_or(0.0, |part| part.relative)
            ));
        }
    }
    Verdict::Agrees(position)
}

/// A tree with its text and its compiled models.
struct Case<'e> {
    entry: &'e Entry,
    tree: Tree,
    observed: Vec<Observed>,
    values: Vec<f64>,
    columns: Columns,
}

impl Case<'_> {
    fn go(&self, (maker, columns): (Maker, &Columns), values: &[f64], way: Way, t_end: f64) -> Result<History, String> {
        let mut scene = maker(values, way.formulation, way.joints)?;
        run(scene.as_mut(), way, t_end, ROWS, MOST, (&self.observed, columns))
    }

    /// What two runs with the tight tolerance differ by may be fast vibrations that their steps do not follow, of which velocities
    /// and forces hold more than positions: then it vanishes where they are followed.
    fn resolved(
        &self,
        verdict: Verdict,
        (maker, columns, values): (Maker, &Columns, &[f64]),
        way: Way,
        (copy, odd): (&Copy, f64),
    ) -> Verdict {
        let Verdict::Differs(by) = &verdict else {
            return verdict;
        };
        if way.rtol != TIGHT {
            return verdict;
        }
        let go = |maker: Maker, columns: &Columns, values: &[f64], way: Way| {
            let finer = Way { rtol: FINE, ..way };
            let mut scene = maker(values, way.formulation, way.joints)?;
            let observed = (self.observed.as_slice(), columns);
            run(scene.as_mut(), finer, self.tree.t_end, ROWS, 20 * MOST, observed)
        };
        let own = super::study::way(Formulation::Rncf, Joints::Eliminated, way.method, FINE);
        let reference = go(self.entry.original.0, &self.columns, &self.values, own);
        match (reference, go(maker, columns, values, way)) {
            (Ok(reference), Ok(other)) => match judge(&compare(&self.observed, &reference, &other, copy, odd), EQUAL) {
                Verdict::Agrees(_) => Verdict::Unresolved(by.clone()),
                _ => verdict,
            },
            _ => verdict,
        }
    }

    fn own(&self, way: Way) -> Result<History, String> {
        self.go(
            (self.entry.original.0, &self.columns),
            &self.values,
            way,
            self.tree.t_end,
        )
    }
}

fn way(formulation: Formulation, joints: Joints, method: Method, rtol: f64) -> Way {
    Way {
        formulation,
        joints,
        method,
        rtol,
    }
}

/// All checks of one scene, by name.
pub fn checks(entry: &Entry, draw: u64) -> Vec<(&'static str, Verdict)> {
    use Formulation::{Ancf, Rncf};
    use Joints::{Eliminated, Multipliers};
    let tree = grow(entry.seed, draw);
    let written = text(&tree, &Copy::AS_IS, "M");
    let case = Case {
        entry,
        tree,
        observed: written.outputs,
        values: written.values,
        columns: (entry.original.1)(),
    };
    let mut verdicts = Vec::new();
    let tight = way(Rncf, Eliminated, Method::Radau, TIGHT);
    let reference = match case.own(tight) {
        Ok(reference) => reference,
        Err(error) => {
            // What one formulation refuses the other one may run.
            let other = match case.own(way(Ancf, Eliminated, Method::Radau, TIGHT)) {
                Ok(_) => "; ANCF runs".to_string(),
                Err(other) if other == error => String::new(),
                Err(other) => format!("; ANCF: {other}"),
            };
            return vec![("runs", Verdict::Refused(error + &other))];
        }
    };
    verdicts.push(("runs", Verdict::Agrees(0.0)));
    balances(&case, &reference, DERIVATIVES, &mut verdicts);
    if let Some((change, kinetic)) = reference.energy {
        // What rests has round-off alone.
        let relative = change / kinetic.max(1e-6);
        verdicts.push((
            "energy is kept",
            if relative <= 1e-3 {
                Verdict::Agrees(relative)
            } else {
                Verdict::Differs(format!("by {relative:.1e} of {kinetic:.1e} J"))
            },
        ));
    }
    for (name, at, limits) in [
        ("ANCF", way(Ancf, Eliminated, Method::Radau, TIGHT), EQUAL),
        ("no elimination", way(Rncf, Multipliers, Method::Radau, TIGHT), EQUAL),
        (
            "ANCF, no elimination",
            way(Ancf, Multipliers, Method::Radau, TIGHT),
            EQUAL,
        ),
        ("Radau, loose", way(Rncf, Eliminated, Method::Radau, LOOSE), NEAR),
        ("ANCF, loose", way(Ancf, Eliminated, Method::Radau, LOOSE), NEAR),
        ("HHT", way(Rncf, Eliminated, HHT, SECOND), NEAR),
        ("generalized-alpha", way(Rncf, Eliminated, ALPHA, SECOND), NEAR),
    ] {
        let verdict = match case.own(at) {
            Ok(history) => {
                if name == "ANCF" {
                    balances(&case, &history, ANCF_DERIVATIVES, &mut verdicts);
                }
                let apart = compare(&case.observed, &reference, &history, &Copy::AS_IS, 1.0);
                judge(&apart, limits)
            }
            Err(error) => Verdict::Refused(error),
        };
        let original = (entry.original.0, &case.columns, case.values.as_slice());
        let as_is = (&Copy::AS_IS, 1.0);
        verdicts.push((name, case.resolved(verdict, original, at, as_is)));
    }
    if draw == 0 {
        convergence(&case, &reference, &mut verdicts);
    }
    let copy = copy_of(&case.tree);
    if let Some((maker, columns)) = entry.copy {
        let copied = text(&case.tree, &copy, "M");
        let columns = columns();
        let odd = odd(&case.tree, &copy);
        let verdict = match case.go((maker, &columns), &copied.values, tight, case.tree.t_end) {
            Ok(history) => judge(&compare(&case.observed, &reference, &history, &copy, odd), EQUAL),
            Err(error) => Verdict::Refused(error),
        };
        let copied = (maker, &columns, copied.values.as_slice());
        verdicts.push(("copy", case.resolved(verdict, copied, tight, (&copy, odd))));
    }
    let (length, mass, time) = (1.0 / 1024.0, 1.0 / 65536.0, 1.0 / 16.0);
    let small = in_units(&case.tree, length, mass, time);
    let values = text(&small, &Copy::AS_IS, "M").values;
    let result = case.go((entry.original.0, &case.columns), &values, tight, small.t_end);
    verdicts.push((
        "units",
        match result {
            Ok(mut history) => {
                for row in &mut history.rows {
                    for (output, value) in case.observed.iter().zip(row.iter_mut()) {
                        *value = value.map(|x| x / factor(output.quantity, length, mass, time));
                    }
                }
                judge(&compare(&case.observed, &reference, &history, &Copy::AS_IS, 1.0), EQUAL)
            }
            Err(error) => Verdict::Refused(error),
        },
    ));
    resting(&case, &copy, &mut verdicts);
    verdicts
}

/// Names of the checks that what changes is the integral of its rate.
const DERIVATIVES: [&str; 3] = [
    "velocity is the derivative of position",
    "forces balance momentum",
    "moments balance angular momentum",
];
const ANCF_DERIVATIVES: [&str; 3] = [
    "velocity is the derivative of position, ANCF",
    "forces balance momentum, ANCF",
    "moments balance angular momentum, ANCF",
];

/// What a run changed against the integrals of the rates, relative to what is largest of a quantity.
fn balances(case: &Case, history: &History, names: [&'static str; 3], verdicts: &mut Vec<(&'static str, Verdict)>) {
    let sizes = scales(&case.observed, history);
    let quantities = [Quantity::Position, Quantity::Momentum, Quantity::AngularMomentum];
    for (name, quantity) in names.into_iter().zip(quantities) {
        let Some((_, size)) = sizes.iter().find(|(of, _)| *of == quantity) else {
            continue;
        };
        let mut worst: Option<(&str, f64)> = None;
        for (index, off) in &history.drift {
            let output = &case.observed[*index];
            let relative = if *off == 0.0 { 0.0 } else { off / size };
            if output.quantity == quantity && worst.is_none_or(|(_, most)| relative > most || relative.is_nan()) {
                worst = Some((&output.of, relative));
            }
        }
        let Some((of, off)) = worst else { continue };
        verdicts.push((
            name,
            if off <= EQUAL.position {
                Verdict::Agrees(off)
            } else {
                Verdict::Differs(format!("{of} by {off:.1e} of {size:.1e}"))
            },
        ));
    }
}

/// Meshes with twice and four times the elements, and methods of order 2 with a tolerance ten times looser.
fn convergence(case: &Case, reference: &History, verdicts: &mut Vec<(&'static str, Verdict)>) {
    use Formulation::Rncf;
    use Joints::Eliminated;
    let apart = |a: &History, b: &History| {
        compare(&case.observed, a, b, &Copy::AS_IS, 1.0)
            .iter()
            .find(|apart| apart.quantity == Quantity::Position)
            .map_or(0.0, |apart| apart.relative)
    };
    let tight = way(Rncf, Eliminated, Method::Radau, LOOSE);
    let refined = |times: usize| {
        let mut tree = case.tree.clone();
        for body in &mut tree.bodies {
            body.elements *= times;
        }
        let values = text(&tree, &Copy::AS_IS, "M").values;
        case.go((case.entry.original.0, &case.columns), &values, tight, tree.t_end)
    };
    verdicts.push((
        "meshes",
        match (refined(2), refined(4)) {
            (Ok(two), Ok(four)) => {
                let (coarse, fine) = (apart(&four, reference), apart(&four, &two));
                if fine <= (0.5 * coarse).max(MESHED) {
                    Verdict::Agrees(fine)
                } else {
                    Verdict::Differs(format!("by {coarse:.1e} and {fine:.1e} with twice the elements"))
                }
            }
            (Err(error), _) | (_, Err(error)) => Verdict::Refused(error),
        },
    ));
    for (name, method) in [("HHT, order", HHT), ("generalized-alpha, order", ALPHA)] {
        let runs = [10.0 * SECOND, SECOND].map(|rtol| case.own(way(Rncf, Eliminated, method, rtol)));
        verdicts.push((
            name,
            match runs {
                [Ok(loose), Ok(tight)] => {
                    let (loose, tight) = (apart(reference, &loose), apart(reference, &tight));
                    if tight <= (0.5 * loose).max(100.0 * SECOND) {
                        Verdict::Agrees(tight)
                    } else {
                        Verdict::Differs(format!("by {loose:.1e}, and {tight:.1e} with a tenth of the tolerance"))
                    }
                }
                [Err(error), _] | [_, Err(error)] => Verdict::Refused(error),
            },
        ));
    }
}

/// Equilibrium at rest and modes: in all ways the same, and the same as in time.
fn resting(case: &Case, copy: &Copy, verdicts: &mut Vec<(&'static str, Verdict)>) {
    use Formulation::{Ancf, Rncf};
    use Joints::{Eliminated, Multipliers};
    let tree = still(&case.tree);
    let values = text(&tree, &Copy::AS_IS, "M").values;
    let copied = text(&tree, copy, "M").values;
    let positions: Vec<usize> = (0..case.observed.len())
        .filter(|index| case.observed[*index].quantity == Quantity::Position)
        .collect();
    let maker = case.entry.original.0;
    let own = match rest(maker, &case.columns, &values, (Rncf, Eliminated), &positions) {
        Ok(own) => own,
        Err(error) => return verdicts.push(("at rest", Verdict::Refused(error))),
    };
    verdicts.push(("at rest", Verdict::Agrees(0.0)));
    if let Some(off) = own.vibration {
        verdicts.push((
            "a mode vibrates so in time",
            if off <= 3e-2 {
                Verdict::Agrees(off)
            } else {
                Verdict::Differs(format!("by {off:.1e} of its displacement, modes {:?}", own.pairs))
            },
        ));
    }
    let as_is = (1.0, &Copy::AS_IS);
    let mut others = vec![
        (
            "at rest: ANCF",
            maker,
            &case.columns,
            &values,
            (Ancf, Eliminated),
            as_is,
        ),
        (
            "at rest: no elimination",
            maker,
            &case.columns,
            &values,
            (Rncf, Multipliers),
            as_is,
        ),
    ];
    let columns = case.entry.copy.map(|(_, columns)| columns());
    if let (Some((maker, _)), Some(columns)) = (case.entry.copy, &columns) {
        others.push((
            "at rest: copy",
            maker,
            columns,
            &copied,
            (Rncf, Eliminated),
            (odd(&case.tree, copy), copy),
        ));
    }
    for (name, maker, columns, values, way, (odd, copy)) in others {
        let verdict = match rest(maker, columns, values, way, &[]) {
            Ok(other) => {
                let [a, b] = [&own, &other].map(|rest| History {
                    rows: vec![rest.row.clone()],
                    ..History::default()
                });
                match judge(&compare(&case.observed, &a, &b, copy, odd), STILL) {
                    Verdict::Agrees(by) => same_modes(&own.pairs, &other.pairs, by),
                    other => other,
                }
            }
            Err(error) => Verdict::Refused(error),
        };
        verdicts.push((name, verdict));
    }
}

/// Frequencies above 1 rad/s agree to 1e-5 of themselves; slower ones to as much of 1 rad/s.
fn same_modes(a: &[[f64; 2]], b: &[[f64; 2]], by: f64) -> Verdict {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-5 * a.abs().max(1.0);
    // What does not oscillate may be neutral: a double zero is known to the root of the round-off.
    let slow = |pairs: &[[f64; 2]]| pairs.iter().filter(|[re, im]| re.hypot(*im) < 1e-2).count();
    let quick = |pairs: &[[f64; 2]]| {
        let list = pairs.iter().filter(|[re, im]| re.hypot(*im) >= 1e-2);
        list.copied().collect::<Vec<_>>()
    };
    let (first, second) = (quick(a), quick(b));
    let agree = slow(a) == slow(b)
        && first.len() == second.len()
        && first
            .iter()
            .zip(&second)
            .all(|(a, b)| near(a[1], b[1]) && near(a[0], b[0]));
    if agree {
        Verdict::Agrees(by)
    } else {
        Verdict::Differs(format!("modes {a:?}, {b:?}"))
    }
}

/// What is in a scene, in a line.
pub fn told(tree: &Tree) -> String {
    let list = |words: Vec<String>| {
        if words.is_empty() {
            "-".to_string()
        } else {
            words.join(" ")
        }
    };
    let frames = tree.frames.iter().map(|frame| {
        let word = match frame.kind {
            Kind::Rotating { .. } => "rotating",
            Kind::Moving { .. } => "moving",
            Kind::Free => "free",
            Kind::Rigid { .. } => "rigid",
        };
        let inside = frame.parent.map_or(String::new(), |parent| format!("(f{parent})"));
        format!("{word}{inside}")
    });
    let bodies = tree.bodies.iter().map(|body| {
        let inside = body.frame.map_or(String::new(), |frame| format!("(f{frame})"));
        let tie = if body.tie == Tie::MeanAxes { ":mean_axes" } else { "" };
        let word = if body.is_cable { "cable" } else { "beam" };
        format!("{word}*{}{inside}{tie}", body.elements)
    });
    let joints = tree.joints.iter().map(|joint| {
        let driven = if joint.drive.is_some() { "+drive" } else { "" };
        let coil = if joint.coil.is_some() { "+torsional" } else { "" };
        format!("{}{driven}{coil}", joint.word)
    });
    let springs = tree.springs.iter().map(|spring| match spring {
        Spring::Linear { .. } => "linear",
        Spring::Law { .. } => "law",
        Spring::Bushing { .. } => "bushing",
    });
    let loads = tree.loads.iter().map(|load| match load {
        Load::Force { .. } => "force",
        Load::Moment { .. } => "moment",
        Load::Follower { .. } => "follower",
        Load::Density { .. } => "density",
    });
    let gravity = tree.gravity.map(|_| "gravity");
    format!(
        "{}; {}; {}; {}; {}; {}",
        if tree.plane { "plane" } else { "space" },
        list(frames.collect()),
        list(bodies.collect()),
        list(joints.collect()),
        list(springs.map(str::to_string).collect()),
        list(loads.chain(gravity).map(str::to_string).collect())
    )
}

/// Runs all scenes of the table with these draws; prints what differs, and a table of all checks at the end.
pub fn study(table: &[Entry], draws: std::ops::Range<u64>) {
    let mut counts: BTreeMap<&str, ([u32; 4], f64)> = BTreeMap::new();
    let clock = Instant::now();
    let mut scenes = 0;
    for draw in draws {
        for entry in table {
            scenes += 1;
            let start = Instant::now();
            let verdicts = checks(entry, draw);
            println!(
                "{} {draw}: {} ({:.1} s)",
                entry.seed,
                told(&grow(entry.seed, draw)),
                start.elapsed().as_secs_f64()
            );
            for (name, verdict) in verdicts {
                let (count, worst) = counts.entry(name).or_default();
                match verdict {
                    Verdict::Agrees(by) => {
                        count[0] += 1;
                        *worst = worst.max(by);
                    }
                    Verdict::Differs(by) => {
                        count[1] += 1;
                        println!("    {name} DIFFERS: {by}");
                    }
                    Verdict::Unresolved(by) => {
                        count[3] += 1;
                        println!("    {name} is not resolved: {by}");
                    }
                    Verdict::Refused(why) => {
                        count[2] += 1;
                        println!("    {name} stops: {why}");
                    }
                }
            }
        }
    }
    println!("\n{scenes} scenes in {:.0} s", clock.elapsed().as_secs_f64());
    println!(
        "| check | agree | largest difference of these | agree with rtol 1e-9 | differ | stopped |\n|---|---|---|---|---|---|"
    );
    for (name, ([agree, differ, stopped, finer], worst)) in counts {
        println!("| {name} | {agree} | {worst:.1e} | {finer} | {differ} | {stopped} |");
    }
}
