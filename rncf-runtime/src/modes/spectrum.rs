//! The lowest eigenpairs of a pencil: found, refined, and one mode for every motion.

use super::arnoldi;
use super::dense;
use super::growth::may_feed;
use super::mode::number;
use super::pair::{CLOSE, Failure, Pair, SLOW, order};
use super::pencil::Pencil;
use super::refinement::Refinement;
use crate::linalg::c64;

/// Unknowns up to which full matrices are used, and up to which they are if many modes are wanted.
const SMALL: usize = 60;
const STILL_SMALL: usize = 600;
/// Part of the unknowns that counts as many modes: one of this many.
const MANY: usize = 4;
/// Growth, of |s|, that round-off makes of two equal frequencies.
const GROWS: f64 = 1e-7;
/// Multiple of the shift beyond which an eigenvalue that fits no equation is infinite.
const BEYOND: f64 = 1e5;

/// The `count` modes of lowest |s|, one of two conjugates, sorted by frequency, then by growth; all, if
/// there are fewer; none only where constraints leave no motion free.
pub(super) fn lowest(pencil: &Pencil, count: usize) -> Result<Vec<Pair>, Failure> {
    search(pencil, count).map(|found| found.modes)
}

/// The same, and those beyond that grow; whether all modes were looked at for that. Of more than 60 unknowns, and up to
/// `most`, they are where something may feed a motion.
pub(super) fn lowest_and_growing(pencil: &Pencil, count: usize, most: usize) -> Result<(Vec<Pair>, bool), Failure> {
    let Found { mut modes, mut beyond } = search(pencil, count)?;
    let is_all = modes.len() < count;
    if beyond.is_none() && !is_all && pencil.unknowns() <= most && may_feed(pencil) {
        let found = dense::spectrum(pencil)?;
        beyond = Some((found.shift, found.pairs));
    }
    let Some((shift, pairs)) = beyond else {
        return Ok((modes, is_all));
    };
    let last = modes.iter().map(|pair| pair.s.norm()).fold(0.0, f64::max);
    let mut refinement = Refinement::new(pencil, shift);
    let is_beyond = |pair: &Pair| pair.s.norm() > last * (1.0 + CLOSE) && pair.s.re > GROWS * pair.s.norm();
    let growing = pairs.into_iter().filter(|pair| pair.s.im >= 0.0).filter(is_beyond);
    // Those of the highest frequencies may be lost to round-off.
    let found = growing.filter_map(|pair| refinement.group(vec![pair])).flatten();
    modes.extend(found.filter(is_beyond));
    number(&mut modes, |pair| [pair.s.re, pair.s.im]);
    Ok((modes, true))
}

/// What a search finds.
struct Found {
    /// The lowest modes.
    modes: Vec<Pair>,
    /// The shift and all pairs as they were found, where all were.
    beyond: Option<(f64, Vec<Pair>)>,
}

fn search(pencil: &Pencil, count: usize) -> Result<Found, Failure> {
    if !pencil.is_finite() {
        return Err(Failure::NotFinite);
    }
    if count == 0 || pencil.unknowns() == 0 {
        return Ok(Found {
            modes: Vec::new(),
            beyond: None,
        });
    }
    let n = pencil.unknowns();
    let mut asked = count;
    loop {
        let is_small = n <= SMALL || n <= STILL_SMALL && MANY * asked >= n;
        let (shift, pairs, is_all, moving) = if is_small {
            let found = dense::spectrum(pencil)?;
            (found.shift, found.pairs, true, found.moving)
        } else {
            let (shift, pairs, is_all) = arnoldi::spectrum(pencil, asked)?;
            (shift, pairs, is_all, 0)
        };
        // A motion with inertia has two eigenvalues, and none of them is infinite.
        let is_lost = pairs.len() < 2 * moving;
        let finite = farthest(&pairs, 2 * moving);
        let beyond = is_small.then(|| (shift, pairs.clone()));
        let (mut modes, is_checked) = distinct(pencil, (shift, finite), pairs, [count, asked])?;
        // Of a motion that drifts two eigenvalues make one mode.
        if modes.len() < count && !(is_all && is_checked) {
            if asked >= 2 * n {
                return Err(Failure::Slow(modes.len()));
            }
            asked *= 2;
            continue;
        }
        let free = n.saturating_sub(pencil.constraints());
        if modes.is_empty() && free > 0 {
            return Err(Failure::Nothing(free));
        }
        if is_lost && modes.len() < count {
            return Err(Failure::Lost(modes.len()));
        }
        modes.truncate(count);
        number(&mut modes, |pair| [pair.s.re, pair.s.im]);
        return Ok(Found { modes, beyond });
    }
}

/// The largest of the `count` lowest |s|.
fn farthest(pairs: &[Pair], count: usize) -> f64 {
    let mut speeds: Vec<f64> = pairs.iter().map(|pair| pair.s.norm()).collect();
    speeds.sort_by(f64::total_cmp);
    count
        .checked_sub(1)
        .and_then(|last| speeds.get(last).or(speeds.last()))
        .copied()
        .unwrap_or(0.0)
}

/// Refines the pairs of about `count` modes and joins what is one mode; the lowest |s| first. `true` if
/// there were no more. Up to `finite` no eigenvalue stands for an infinite one; beyond those that are wanted what fits nothing is left out.
fn distinct(
    pencil: &Pencil,
    (shift, finite): (f64, f64),
    mut pairs: Vec<Pair>,
    [wanted, count]: [usize; 2],
) -> Result<(Vec<Pair>, bool), Failure> {
    pairs.sort_by(|a, b| order(a.s, b.s));
    let slow = pairs.partition_point(|pair| pair.s.norm() <= SLOW * shift);
    let mut refinement = Refinement::new(pencil, shift);
    let mut modes = refinement.still(slow);
    if !modes.is_empty() {
        pairs.drain(..slow);
        let running = refinement.running(&modes, SLOW * shift);
        modes.extend(running);
    }
    let mut pairs: Vec<Pair> = pairs.into_iter().flat_map(one_of_conjugates).collect();
    let found = modes.len() + pairs.len();
    // The one beyond the count only completes a group.
    pairs.truncate((count + 1).saturating_sub(modes.len()));
    while let Some(first) = pairs.first().map(|pair| pair.s) {
        let near = |pair: &Pair| (pair.s - first).norm() <= CLOSE * (first.norm() + shift);
        let (group, rest): (Vec<Pair>, Vec<Pair>) = pairs.into_iter().partition(near);
        pairs = rest;
        match refinement.group(group) {
            Some(group) => modes.extend(group),
            // Infinite eigenvalues come out as very large ones that fit nothing.
            None if first.norm() >= BEYOND * shift && first.norm() > finite => {}
            None if modes.len() >= wanted => {}
            None => return Err(Failure::Inexact(modes.len())),
        }
    }
    modes.sort_by(|a, b| order(a.s, b.s));
    Ok((modes, found <= count))
}

/// A pair, if it is the one of two conjugates that is taken; of two that round-off made of one real eigenvalue, which is there twice, both.
fn one_of_conjugates(Pair { s, x }: Pair) -> Vec<Pair> {
    if s.im < 0.0 {
        return Vec::new();
    }
    if s.im == 0.0 || s.im > CLOSE * s.norm() {
        return vec![Pair { s, x }];
    }
    let real = |part: fn(&c64) -> f64| Pair {
        s: c64::new(s.re, 0.0),
        x: x.iter().map(|value| c64::new(part(value), 0.0)).collect(),
    };
    let both = [real(|value| value.re), real(|value| value.im)];
    let is_some = |pair: &Pair| pair.x.iter().any(|value| value.re != 0.0);
    both.into_iter().filter(is_some).collect()
}
