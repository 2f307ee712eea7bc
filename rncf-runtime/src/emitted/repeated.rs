//! What large scenes need of a model: shared nodes, starts in equilibrium, loads per length.

use super::extremes;
use crate::error::ModelError;

/// Two ends of bodies in one frame that are one node.
#[derive(Clone, Debug)]
pub struct ShareSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// The ends: body, and whether it is the body's end instead of its start.
    pub ends: [(usize, bool); 2],
    /// Whether all nodal vectors are one, else the position alone.
    pub smooth: bool,
}

/// The bodies of a frame start in relative equilibrium with its uniform rotation, without loads.
#[derive(Clone, Debug)]
pub struct StartSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Frame.
    pub frame: usize,
    /// Angular velocity, rad/s, frame axes; `None`: that of the frame at t = 0.
    pub spin: Option<[f64; 3]>,
}

/// A load per length on one body.
#[derive(Clone, Debug)]
pub struct DensitySpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Index of its declaration: densities of one kind share kernels.
    pub kind: usize,
    /// Body.
    pub body: usize,
    /// Markers that its values depend on.
    pub markers: &'static [usize],
    /// Number of its values.
    pub values: usize,
}

/// How often something may be repeated: far more than any computer holds, far less than a count that went wrong.
const MOST: f64 = 1e7;

/// Global number of a repetition: `first` is that of the first of `count`; where there is no such one, a number
/// that no body has: `usize::MAX - first`, so that messages know whose repetition was meant.
pub fn instance(first: usize, count: usize, number: f64) -> usize {
    if number == number.trunc() && (0.0..count as f64).contains(&number) {
        first + number as usize
    } else {
        usize::MAX - first
    }
}

/// Numbers at which declarations begin that stand for so many things each.
pub fn firsts<const N: usize>(counts: [usize; N]) -> [usize; N] {
    let mut next = 0_usize;
    counts.map(|count| {
        let first = next;
        next = next.saturating_add(count);
        first
    })
}

/// Checks how often a loop is gone through; a count that is computed is rounded down.
///
/// # Errors
/// Less than once, or more often than makes sense, by the loop's index.
pub fn repetitions(index: &str, count: f64) -> Result<(), ModelError> {
    if (1.0..=MOST).contains(&count) {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "the loop over `{index}` is gone through {count} times: its count must be at least 1 and at most {MOST:e}"
    )))
}

/// What a reduction over repetitions tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reduction {
    /// Largest value.
    Max,
    /// Smallest value.
    Min,
    /// Sum.
    Sum,
    /// Mean.
    Mean,
}

/// Reduces a value over `count` repetitions: `value` gets the index and the `width` observed numbers of its
/// repetition, which stand one repetition after the other at the front of `observed` and are taken off it. What is
/// no number in one repetition is none in the result.
pub fn reduce(
    reduction: Reduction,
    count: usize,
    width: usize,
    observed: &mut &[f64],
    mut value: impl FnMut(f64, &[f64]) -> f64,
) -> f64 {
    let (own, rest) = observed.split_at(count * width);
    *observed = rest;
    let values = (0..count).map(|index| value(index as f64, &own[index * width..(index + 1) * width]));
    match reduction {
        Reduction::Max => values.reduce(extremes::max).unwrap_or(f64::NAN),
        Reduction::Min => values.reduce(extremes::min).unwrap_or(f64::NAN),
        Reduction::Sum => values.sum(),
        Reduction::Mean => values.sum::<f64>() / count as f64,
    }
}

/// Name for messages of one of several that are named in order: `tip`, or `tip[3]` where a loop repeats it.
pub(crate) fn label<'a>(names: impl Iterator<Item = &'a str>, index: usize) -> String {
    let names: Vec<&str> = names.collect();
    let name = names[index];
    let first = names.iter().position(|&other| other == name).unwrap_or(index);
    if first < index || names.get(index + 1) == Some(&name) {
        format!("{name}[{}]", index - first)
    } else {
        name.to_string()
    }
}

/// Declaration and number of the repetition of what has this number, where declarations are repeated so many times.
pub fn declared(counts: &[usize], number: usize) -> (usize, usize) {
    let mut rest = number;
    for (declaration, &count) in counts.iter().enumerate() {
        match rest.checked_sub(count) {
            Some(beyond) => rest = beyond,
            None => return (declaration, rest),
        }
    }
    (counts.len(), rest)
}

#[cfg(test)]
mod tests {
    use crate::emitted::repeated::*;

    #[test]
    fn the_number_of_a_repetition_tells_whose_is_missing() {
        assert_eq!(instance(7, 3, 2.0), 9);
        for number in [-1.0, 3.0, 0.5, f64::NAN, f64::INFINITY] {
            assert_eq!(usize::MAX - instance(7, 3, number), 7, "{number}");
        }
    }

    #[test]
    fn loops_are_gone_through_at_least_once() {
        assert!(repetitions("a", 1.0).is_ok() && repetitions("a", 400.0).is_ok());
        for count in [0.0, 0.9, -3.0, f64::NAN, f64::INFINITY, 1e9] {
            let message = repetitions("a", count).unwrap_err().message;
            assert!(message.contains("`a`"), "{message}");
        }
    }

    #[test]
    fn reductions_take_their_own_and_let_no_missing_number_through() {
        let seen = [1.0, 10.0, 4.0, 40.0, 2.0, 20.0, 5.0];
        let of = |reduction: Reduction| {
            let mut rest = &seen[..];
            let value = reduce(reduction, 3, 2, &mut rest, |index, own| index + own[0] - own[1]);
            assert_eq!(rest, [5.0]);
            value
        };
        assert_eq!(of(Reduction::Max), -9.0);
        assert_eq!(of(Reduction::Min), -35.0);
        assert_eq!(of(Reduction::Sum), -60.0);
        assert_eq!(of(Reduction::Mean), -20.0);
        let all = [Reduction::Max, Reduction::Min, Reduction::Sum, Reduction::Mean];
        for reduction in all {
            for place in 0..3 {
                let mut seen = [1.0, 2.0, 3.0];
                seen[place] = f64::NAN;
                let value = reduce(reduction, 3, 1, &mut &seen[..], |_, own| own[0]);
                assert!(value.is_nan(), "{reduction:?} {place}");
            }
        }
        // Without anything observed the index alone is reduced.
        assert_eq!(reduce(Reduction::Sum, 4, 0, &mut &[][..], |index, _| index), 6.0);
    }

    #[test]
    fn only_what_is_repeated_has_a_number() {
        let names = ["root", "tip", "tip", "tip", "end"];
        let labels: Vec<String> = (0..5).map(|index| label(names.into_iter(), index)).collect();
        assert_eq!(labels, ["root", "tip[0]", "tip[1]", "tip[2]", "end"]);
    }
}
