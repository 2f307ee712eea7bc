//! Where on the way modes begin to grow, or cease to: flutter, hunting, the whirl of a damped shaft.

use super::looked::{Looked, there};
use crate::State;
use crate::app::equilibria::continuation::Line;
use crate::app::results::campbell::{Campbell, Onset};
use crate::app::results::modes::{SeenMode, fastest};

/// Halvings of a step.
const LOOKS: u32 = 20;
/// How much faster a mode grows that tells, with the last one, where it does not.
const TWICE: f64 = 2.0;
/// Brackets within which a rate that bends may be zero.
const BENT: f64 = 4.0;
/// Part of the way on a line that it may be off by.
const LINEAR: f64 = 0.01;
/// Rate of decay, of the frequency of a mode, that round-off makes of a single one.
const SINGLE: f64 = 1e-9;
/// Part of a rate of growth or decay that is nothing beside it.
const SMALL: f64 = 1e-3;
/// Part of the |s| of a mode beyond which another one is none that it has become.
const NEXT: f64 = 0.5;
/// Part of a value within which a critical one beside it says the same.
const ALIKE: f64 = 1e-4;

/// The one in the last step, between a row where no mode grows and one where some do; `None` where both are alike, or where a critical value is: the
/// equilibrium diverges there.
pub(super) fn onset(line: &mut Line<'_>, diagram: &Campbell) -> Option<Onset> {
    let row = diagram.keys.len().checked_sub(2)?;
    let [before, after] = [row, row + 1].map(|row| fastest(&diagram.row(row).collect::<Vec<_>>()));
    if before.is_some() == after.is_some() {
        return None;
    }
    let (first, last) = line.last_two();
    let (first, last) = (first?.clone(), last.clone());
    let (mut low, mut high, mut guess) = (first.share, last.share, first.state.clone());
    let grown = if before.is_some() { first.share } else { last.share };
    let grows = before.or(after)?;
    let mut growing = vec![(grown, grows)];
    let size = |mode: &SeenMode| mode.re.hypot(mode.im);
    let grown_row = if before.is_some() { row } else { row + 1 };
    let lower = diagram.row(grown_row).filter(|mode| size(mode) < size(&grows)).count();
    // One beyond the lowest is seen where it grows alone: of few unknowns all are looked at.
    let count = match lower < diagram.settings.count || !diagram.is_all {
        true => diagram.settings.count,
        false => line.station().scene.unknowns(),
    };
    let [from, to] = [0.0, 1.0].map(|share| line.key(share));
    let share_of = |key: f64| (key - from) / (to - from);
    let mut seen: Vec<(f64, Vec<SeenMode>)> = (0..=row + 1)
        .map(|row| (share_of(diagram.keys[row]), diagram.row(row).collect()))
        .collect();
    for _ in 0..LOOKS {
        let share = low + 0.5 * (high - low);
        let Some((modes, back)) = look(line, count, share, &guess) else {
            break;
        };
        let found = fastest(&modes);
        seen.push((share, modes));
        growing.extend(found.map(|mode| (share, mode)));
        if found.is_some() == before.is_some() {
            (low, guess) = (share, back);
        } else {
            high = share;
        }
    }
    let last = *growing.last()?;
    let mut at = |share: f64| look(line, count, share, &first.state).map(|(modes, _)| modes);
    let (zero, away, im) = sign_changes(seen, last, before.is_none(), &mut at).unwrap_or_else(|| {
        let zero = zero_of(&growing, [low, high]);
        (zero, LINEAR * (zero - low).abs() + 0.5 * (high - low).abs(), last.1.im)
    });
    let key = line.key(zero);
    let within = (line.key(zero + away) - key).abs();
    let is_critical = |value: f64| (value - key).abs() <= within.max(ALIKE * key.abs());
    let is_known = diagram.critical.iter().any(|critical| is_critical(critical.value));
    (!is_known).then_some(Onset {
        key,
        within,
        im,
        begins: after.is_some(),
    })
}

/// The modes at a part of the way, and the equilibrium there.
fn look(line: &mut Line<'_>, count: usize, share: f64, guess: &State) -> Option<(Vec<SeenMode>, State)> {
    let (mut scene, at, state, back) = line.between(share, guess)?;
    let looked = Looked::at(scene.as_mut(), &at, &state, count).ok()?;
    let seen = looked.modes.iter().map(|mode| {
        let mode = there(scene.as_mut(), &at, mode);
        SeenMode::of(scene.as_mut(), &at, &state, &mode)
    });
    Some((seen.collect(), back))
}

/// Where the rate of growth of a mode changes its sign, how far away that may be, in parts of the way, and its frequency there, rad/s: damped lightly, it does so long before it grows by more
/// than round-off makes of two equal frequencies. `None` where it decays nowhere by more than that of a single one. The mode grows at a part of the way,
/// and is followed down or up through what was seen.
fn sign_changes(
    mut seen: Vec<(f64, Vec<SeenMode>)>,
    (grown, mode): (f64, SeenMode),
    is_below: bool,
    at: &mut dyn FnMut(f64) -> Option<Vec<SeenMode>>,
) -> Option<(f64, f64, f64)> {
    seen.retain(|(share, _)| if is_below { *share < grown } else { *share > grown });
    seen.sort_by(|a, b| (a.0 - grown).abs().total_cmp(&(b.0 - grown).abs()));
    let mut above = (grown, mode);
    let mut below = None;
    for (share, modes) in seen {
        let Some(mode) = nearest(&modes, &above.1) else {
            continue;
        };
        if mode.re < -SINGLE * mode.re.hypot(mode.im) {
            below = Some((share, mode));
            break;
        }
        if mode.re > 0.0 {
            above = (share, mode);
        }
    }
    let mut below = below?;
    let zero = |below: &(f64, SeenMode), above: &(f64, SeenMode)| {
        below.0 - below.1.re * (above.0 - below.0) / (above.1.re - below.1.re)
    };
    let first = [below.1.re.abs(), above.1.re].into_iter().fold(f64::INFINITY, f64::min);
    let mut found = zero(&below, &above);
    let (mut away, mut im) = (0.5 * (above.0 - below.0).abs(), above.1.im);
    for _ in 0..LOOKS {
        let share = found;
        let mode = nearest(
            &at(share)?,
            if below.1.re.abs() < above.1.re {
                &below.1
            } else {
                &above.1
            },
        )?;
        if mode.re < 0.0 {
            below = (share, mode);
        } else {
            above = (share, mode);
        }
        found = zero(&below, &above);
        (away, im) = ((found - share).abs(), mode.im);
        if mode.re.abs() <= SMALL * first {
            break;
        }
    }
    Some((found, away, im))
}

/// Which of some modes has its value next to that of another; `None` where none is near.
fn nearest(modes: &[SeenMode], to: &SeenMode) -> Option<SeenMode> {
    let distance = |mode: &SeenMode| (mode.re - to.re).hypot(mode.im - to.im);
    let nearest = modes.iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.filter(|mode| distance(mode) <= NEXT * to.re.hypot(to.im))
}

/// Where the growth of the last of some modes is zero, each with its part of the way: growth that hardly differs from round-off counts as none, so that this is
/// beside the bracket. A rate that rises with a root does so within it.
fn zero_of(growing: &[(f64, SeenMode)], [low, high]: [f64; 2]) -> f64 {
    let middle = low + 0.5 * (high - low);
    let Some((last, others)) = growing.split_last() else {
        return middle;
    };
    let Some(other) = others.iter().rev().find(|other| other.1.re >= TWICE * last.1.re) else {
        return middle;
    };
    let on_line = last.0 - last.1.re * (other.0 - last.0) / (other.1.re - last.1.re);
    if (on_line - middle).abs() <= BENT * (high - low).abs() {
        middle
    } else {
        on_line
    }
}
