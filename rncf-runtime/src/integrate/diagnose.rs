//! Diagnosis of the initial state by name: constraints that depend on each other, and motions that
//! have neither inertia nor a tie (THEORY 9.4, T14).

use crate::linalg::{Pattern, Saddle};
use crate::system::{State, System};

/// What is left of a constraint's row, of norm one, that counts as nothing.
const DEPENDENT: f64 = 1e-9;
/// The same near a singular configuration.
const NEARLY_DEPENDENT: f64 = 1e-2;
/// Coefficients of a dependency below this are round-off.
const TAKES_PART: f64 = 1e-6;
/// More constraints than these are not searched for dependencies: the time grows with their cube.
const MOST: usize = 1000;
/// Dependencies that are listed.
const LISTED: usize = 3;
/// Inertia of a motion, relative to that of the unknowns it consists of, that counts as none.
const MASSLESS: f64 = 1e-12;
/// What is added to the mass to find such motions by inverse iteration, on the same scale.
const SHIFT: f64 = 1e-9;
/// Part of the largest component from which on an unknown is named, and how many are.
const NAMED: f64 = 0.1;
const NAMES: usize = 6;

/// Names joints that take freedoms which others take already, and what to weaken; `None` if the rows
/// of `C_x` are independent.
///
/// Rows are scaled by the sizes of the unknowns and to norm one, then orthogonalised.
pub(super) fn redundancy(system: &mut dyn System, state: &State) -> Option<String> {
    let m = system.constraints();
    if m == 0 || m > MOST {
        return None;
    }
    let rows = scaled_rows(system, state);
    if let Some(empty) = rows.iter().position(|row| row.iter().all(|entry| *entry == 0.0)) {
        return Some(format!(
            "{} restrains no motion here: move its points apart, turn its axes, or leave it out",
            system.describe_constraint(empty)
        ));
    }
    let pivoted = Basis::of(&rows, true, DEPENDENT);
    if pivoted.left.is_empty() {
        return None;
    }
    // In the declared order it is the later constraints that are one too many; the rank is known better
    // with the largest remainder first.
    let ordered = Basis::of(&rows, false, DEPENDENT);
    let basis = if ordered.left.len() == pivoted.left.len() {
        ordered
    } else {
        pivoted
    };
    let mut text = match basis.left.len() {
        1 => "one constraint is redundant".to_string(),
        count => format!("{count} constraints are redundant"),
    };
    let names: Vec<String> = (0..m).map(|row| system.describe_constraint(row)).collect();
    let mut owners: Vec<&str> = basis.left.iter().map(|&row| owner(&names[row])).collect();
    owners.dedup();
    for (place, &over) in owners.iter().take(LISTED).enumerate() {
        text.push_str(if place == 0 { ": " } else { "; " });
        text.push_str(&overlap(over, &basis, &names));
    }
    if owners.len() > LISTED {
        text.push_str(&format!("; and {} more", owners.len() - LISTED));
    }
    Some(text)
}

/// Names constraints that nearly depend on each other at the state: a singular configuration is near;
/// `None` if there are none.
pub(super) fn near_singular(system: &mut dyn System, state: &State) -> Option<String> {
    let m = system.constraints();
    if m == 0 || m > MOST {
        return None;
    }
    let basis = Basis::of(&scaled_rows(system, state), true, NEARLY_DEPENDENT);
    let &row = basis.left.first()?;
    let mut rows: Vec<usize> = basis.combination(row).iter().map(|&(row, _)| row).collect();
    rows.sort_unstable();
    let mut names: Vec<String> = rows.iter().map(|&row| system.describe_constraint(row)).collect();
    names.dedup();
    Some(format!("{} nearly depend on each other", names.join("; ")))
}

/// The joint that a constraint belongs to: its name stands before the first comma.
fn owner(name: &str) -> &str {
    name.split(',').next().unwrap_or_default()
}

/// What a joint takes that others take already, in words, and what to do.
fn overlap(over: &str, basis: &Basis, names: &[String]) -> String {
    let own = |row: &usize| owner(&names[*row]) == over;
    let twice: Vec<usize> = basis.left.iter().copied().filter(own).collect();
    let all = (0..names.len()).filter(own).count();
    let mut involved: Vec<usize> = twice
        .iter()
        .flat_map(|&row| basis.combination(row))
        .map(|(row, _)| row)
        .collect();
    involved.sort_unstable();
    let mut others: Vec<&str> = involved.iter().map(|&row| owner(&names[row])).collect();
    others.retain(|&other| other != over);
    others.dedup();
    let others = listed(&others);
    if twice.len() == all && !others.is_empty() {
        return format!("{over} takes no freedom that {others} do not take already: leave it out");
    }
    let rows: Vec<&str> = twice
        .iter()
        .map(|&row| names[row].split_once(", ").map_or(over, |(_, what)| what))
        .collect();
    let beside = if others.is_empty() {
        String::new()
    } else {
        format!(" together with {others}")
    };
    format!(
        "{over}{beside} takes the freedom `{}` twice: weaken it such that it leaves this free{}",
        rows.join("`, `"),
        weaker(over, &rows)
    )
}

/// `a, b and c`.
fn listed(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [name] => (*name).to_string(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// A kind of joint that takes less, for rows of a kind that turns or shifts less.
fn weaker(over: &str, rows: &[&str]) -> &'static str {
    let turning = rows.iter().all(|row| row.starts_with("direction"));
    let is = |kind: &str| over.ends_with(kind);
    match (is("(revolute)"), is("(weld)"), is("(prismatic)"), is("(universal)")) {
        (true, ..) if turning && rows.len() == 1 => ", e.g. make it `universal`",
        (true, ..) if turning => ", e.g. make it `spherical`",
        (_, true, ..) if turning && rows.len() == 1 => ", e.g. make it `revolute`",
        (_, _, true, _) if turning && rows.len() == 1 => ", e.g. make it `cylindrical`",
        (_, _, _, true) if turning => ", e.g. make it `spherical`",
        _ => "",
    }
}

/// Rows of `C_x` relative to the sizes of the unknowns, of norm one, over the unknowns that occur.
fn scaled_rows(system: &mut dyn System, state: &State) -> Vec<Vec<f64>> {
    let mut values = vec![0.0; system.constraint_pattern().entries()];
    system.constraint_jacobian(state, &mut values);
    let (pattern, sizes) = (system.constraint_pattern(), system.sizes());
    let mut occurring = pattern.indices().to_vec();
    occurring.sort_unstable();
    occurring.dedup();
    (0..pattern.columns())
        .map(|column| {
            let mut row = vec![0.0; occurring.len()];
            for place in pattern.starts()[column]..pattern.starts()[column + 1] {
                let unknown = pattern.indices()[place];
                let index = occurring.partition_point(|&other| other < unknown);
                row[index] = values[place] * sizes[unknown];
            }
            let size = dot(&row, &row).sqrt();
            if size > 0.0 {
                row.iter_mut().for_each(|entry| *entry /= size);
            }
            row
        })
        .collect()
}

/// Orthonormal basis of rows, and the rows that add nothing to it.
struct Basis {
    /// Rows that made the basis, in order.
    chosen: Vec<usize>,
    left: Vec<usize>,
    /// Components of every row along the basis.
    components: Vec<Vec<f64>>,
}

impl Basis {
    /// The rows in their order, or (`pivoted`) the largest remainder first; what is left of a row that is
    /// no longer than `dependent` counts as nothing.
    fn of(rows: &[Vec<f64>], pivoted: bool, dependent: f64) -> Self {
        let mut rest = rows.to_vec();
        let mut left: Vec<usize> = (0..rows.len()).collect();
        let mut components = vec![Vec::new(); rows.len()];
        let mut chosen = Vec::new();
        let mut waiting = left.clone();
        while let Some(place) = if pivoted {
            largest(&rest, &waiting)
        } else {
            first(&waiting)
        } {
            let row = waiting.remove(place);
            let size = dot(&rest[row], &rest[row]).sqrt();
            if size <= dependent {
                continue;
            }
            left.retain(|&other| other != row);
            let direction: Vec<f64> = rest[row].iter().map(|entry| entry / size).collect();
            components[row].push(size);
            chosen.push(row);
            for &other in &waiting {
                let along = dot(&direction, &rest[other]);
                components[other].push(along);
                for (entry, direction) in rest[other].iter_mut().zip(&direction) {
                    *entry -= along * direction;
                }
            }
        }
        Self {
            chosen,
            left,
            components,
        }
    }

    /// The rows, with coefficients, that combine to zero with `row`, which is left.
    fn combination(&self, row: usize) -> Vec<(usize, f64)> {
        let mut rest = self.components[row].clone();
        let mut combination = vec![(row, -1.0)];
        // Rows chosen after this one have no part in it.
        for (place, &chosen) in self.chosen.iter().enumerate().take(rest.len()).rev() {
            let components = &self.components[chosen];
            let coefficient = rest[place] / components[place];
            for (rest, component) in rest.iter_mut().zip(components) {
                *rest -= coefficient * component;
            }
            if coefficient.abs() > TAKES_PART {
                combination.push((chosen, coefficient));
            }
        }
        combination
    }
}

fn first(waiting: &[usize]) -> Option<usize> {
    (!waiting.is_empty()).then_some(0)
}

/// Place in `left` of the largest remainder; the first of equals.
fn largest(rest: &[Vec<f64>], left: &[usize]) -> Option<usize> {
    let sizes: Vec<f64> = left.iter().map(|&row| dot(&rest[row], &rest[row])).collect();
    (0..left.len()).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]).then(b.cmp(&a)))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Names a motion that the constraints allow and that has no inertia, so that `[[M, C_x^T], [C_x, 0]]`
/// is singular; `None` if there is none.
///
/// Inverse iteration with `[[M + shift, C_x^T], [C_x, 0]]`, unknowns scaled by the roots of their masses.
pub(super) fn untied(system: &mut dyn System, state: &State) -> Option<String> {
    let n = system.unknowns();
    let (pattern, border_pattern) = (system.pattern().clone(), system.constraint_pattern().clone());
    let (mut mass, mut border) = (vec![0.0; pattern.entries()], vec![0.0; border_pattern.entries()]);
    system.mass(state, &mut mass);
    // Of states any inertia is as good as none.
    let states = pattern.diagonal(system.states().iter().copied());
    states.for_each(|(_, place)| mass[place] = 1.0);
    if system.constraints() > 0 {
        system.constraint_jacobian(state, &mut border);
    }
    let own = |i: usize| pattern.find(i, i).map_or(0.0, |place| mass[place]);
    // What an unknown without inertia would need to count as much as the others: of no unit.
    let most = (0..n)
        .map(|i| own(i) * system.sizes()[i].powi(2))
        .fold(f64::MIN_POSITIVE, f64::max);
    let scale: Vec<f64> = (0..n)
        .map(|i| match own(i) {
            mass if mass > 0.0 => 1.0 / mass.sqrt(),
            _ => system.sizes()[i] / most.sqrt(),
        })
        .collect();
    scale_entries(&pattern, &mut mass, |row, column| scale[row] * scale[column]);
    scale_entries(&border_pattern, &mut border, |row, _| scale[row]);
    let mut shifted = mass.clone();
    for place in (0..n).filter_map(|i| pattern.find(i, i)) {
        shifted[place] += SHIFT;
    }
    let mut saddle = Saddle::new(&pattern, system.border(), &border_pattern);
    saddle.factor_symmetric(&shifted, &border).ok()?;
    // Any start that is not by chance without the motion sought.
    let mut motion: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * (i as f64 * 1.7).sin()).collect();
    let mut forces = vec![0.0; border_pattern.columns()];
    for _ in 0..3 {
        forces.fill(0.0);
        saddle.solve(&mut motion, &mut forces);
        let size = dot(&motion, &motion).sqrt();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        motion.iter_mut().for_each(|y| *y /= size);
    }
    let mut inertia = vec![0.0; n];
    pattern.multiply_add(1.0, &mass, &motion, &mut inertia);
    if dot(&inertia, &motion) > MASSLESS {
        return None;
    }
    let parts: Vec<f64> = (0..n)
        .map(|i| (motion[i] * scale[i] / system.sizes()[i]).abs())
        .collect();
    Some(motion_in_words(system, &parts))
}

fn scale_entries(pattern: &Pattern, values: &mut [f64], factor: impl Fn(usize, usize) -> f64) {
    for column in 0..pattern.columns() {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            values[place] *= factor(pattern.indices()[place], column);
        }
    }
}

/// Names the unknowns that take part in a motion; of many the last, which are poses.
fn motion_in_words(system: &dyn System, parts: &[f64]) -> String {
    let largest = parts.iter().copied().fold(0.0, f64::max);
    let named: Vec<usize> = (0..parts.len()).filter(|&i| parts[i] >= NAMED * largest).collect();
    let shown = &named[named.len().saturating_sub(NAMES)..];
    let names: Vec<String> = shown.iter().map(|&i| system.describe_unknown(i)).collect();
    let others = match named.len() - shown.len() {
        0 => String::new(),
        count => format!(" and {count} others"),
    };
    format!(
        "a motion of {}{others} has no inertia and nothing ties it: add a condition that holds it, or give it mass or inertia",
        names.join("; ")
    )
}
