//! All ways of all scenes: what agrees, what does not, and a log.

use std::collections::BTreeMap;
use std::time::Instant;

use rncf::{Formulation, Joints, Method};

use super::copies::{copy_of, factor, in_units, odd};
use super::grow::grow;
use super::rest::{rest, still};
use super::run::{Apart, Columns, History, Maker, Way, compare, run, scales};
use super::tree::Tree;
use super::write::{Copy, Observed, Quantity, text};

/// A compiled scene and its copy.
pub struct Entry {
    /// What it is made of.
    pub seed: u64,
    /// As it is.
    pub original: (Maker, fn() -> Columns),
    /// Its copy, [`copy_of`].
    pub copy: (Maker, fn() -> Columns),
}

/// Rows of a history that are compared.
const ROWS: usize = 11;
/// Runs with more attempts are given up and counted.
const MOST: u64 = 700;
/// Tolerance of the reference and of all that must equal it.
const TIGHT: f64 = 1e-7;
/// Tolerance of the runs that must come near it.
const LOOSE: f64 = 1e-5;
/// Tolerance of the local error of methods of order 2.
const SECOND: f64 = 1e-6;

/// What became of one check of one scene.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// Within its limits; the largest difference of positions over the size.
    Agrees(f64),
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
            Quantity::Velocity | Quantity::Spin => limits.velocity,
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
    let sizes = scales(&case.observed, &reference);
    let length = sizes
        .iter()
        .find(|(quantity, _)| *quantity == Quantity::Position)
        .map_or(1.0, |(_, size)| *size);
    let drift = reference.drift.iter().fold(
        (0, 0.0f64),
        |worst, (index, off)| if *off > worst.1 { (*index, *off) } else { worst },
    );
    verdicts.push((
        "velocity is the derivative of position",
        if drift.1 <= EQUAL.position * length {
            Verdict::Agrees(drift.1 / length)
        } else {
            Verdict::Differs(format!("{} by {:.1e}", case.observed[drift.0].of, drift.1 / length))
        },
    ));
    if let Some((change, kinetic)) = reference.energy.filter(|(_, kinetic)| *kinetic > 0.0) {
        let relative = change / kinetic;
        verdicts.push((
            "energy is kept",
            if relative <= 1e-3 {
                Verdict::Agrees(relative)
            } else {
                Verdict::Differs(format!("by {relative:.1e} of {kinetic:.1e} J"))
            },
        ));
    }
    let hht = Method::Hht { alpha: -0.05 };
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
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
        ("HHT", way(Rncf, Eliminated, hht, SECOND), NEAR),
        ("generalized-alpha", way(Rncf, Eliminated, alpha, SECOND), NEAR),
    ] {
        verdicts.push((
            name,
            match case.own(at) {
                Ok(history) => judge(
                    &compare(&case.observed, &reference, &history, &Copy::AS_IS, 1.0),
                    limits,
                ),
                Err(error) => Verdict::Refused(error),
            },
        ));
    }
    let copy = copy_of(&case.tree);
    let copied = text(&case.tree, &copy, "M");
    let result = case.go(
        (entry.copy.0, &(entry.copy.1)()),
        &copied.values,
        tight,
        case.tree.t_end,
    );
    verdicts.push((
        "copy",
        match result {
            Ok(history) => judge(
                &compare(&case.observed, &reference, &history, &copy, odd(&case.tree, &copy)),
                EQUAL,
            ),
            Err(error) => Verdict::Refused(error),
        },
    ));
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
    let columns = (case.entry.copy.1)();
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
    let others = [
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
        (
            "at rest: copy",
            case.entry.copy.0,
            &columns,
            &copied,
            (Rncf, Eliminated),
            (odd(&case.tree, copy), copy),
        ),
    ];
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
    let bodies: Vec<String> = tree
        .bodies
        .iter()
        .map(|body| format!("{}*{}", if body.is_cable { "cable" } else { "beam" }, body.elements))
        .collect();
    let joints: Vec<&str> = tree.joints.iter().map(|joint| joint.word).collect();
    format!(
        "{}, {} frames, {}; {}; {} springs, {} loads",
        if tree.plane { "plane" } else { "space" },
        tree.frames.len(),
        bodies.join(" "),
        joints.join(" "),
        tree.springs.len(),
        tree.loads.len()
    )
}

/// Runs all scenes of the table with these draws; prints what differs, and a table of all checks at the end.
pub fn study(table: &[Entry], draws: std::ops::Range<u64>) {
    let mut counts: BTreeMap<&str, ([u32; 3], f64)> = BTreeMap::new();
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
                    Verdict::Refused(why) => {
                        count[2] += 1;
                        println!("    {name} stops: {why}");
                    }
                }
            }
        }
    }
    println!("\n{scenes} scenes in {:.0} s", clock.elapsed().as_secs_f64());
    println!("| check | agree | largest difference of these | differ | stopped |\n|---|---|---|---|---|");
    for (name, ([agree, differ, stopped], worst)) in counts {
        println!("| {name} | {agree} | {worst:.1e} | {differ} | {stopped} |");
    }
}
