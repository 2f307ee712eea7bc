//! Where on the way modes begin to grow, or cease to: flutter, hunting, the whirl of a damped shaft.

use super::tracker::{Looked, there};
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
    let (mut low, mut high, mut guess) = (first.share, last.share, first.state);
    let grown = if before.is_some() { first.share } else { last.share };
    let mut growing = vec![(grown, before.or(after)?)];
    for _ in 0..LOOKS {
        let share = low + 0.5 * (high - low);
        let Some((mut scene, at, state, back)) = line.between(share, &guess) else {
            break;
        };
        let Ok(looked) = Looked::at(scene.as_mut(), &at, &state, diagram.settings.count) else {
            break;
        };
        let seen = looked.modes.iter().map(|mode| {
            let mode = there(scene.as_mut(), &at, mode);
            SeenMode::of(scene.as_mut(), &at, &state, &mode)
        });
        let found = fastest(&seen.collect::<Vec<_>>());
        growing.extend(found.map(|mode| (share, mode)));
        if found.is_some() == before.is_some() {
            (low, guess) = (share, back);
        } else {
            high = share;
        }
    }
    let zero = zero_of(&growing, [low, high]);
    let away = LINEAR * (zero - low).abs() + 0.5 * (high - low).abs();
    let key = line.key(zero);
    let within = (line.key(zero + away) - key).abs();
    let is_critical = |value: f64| (value - key).abs() <= within.max(ALIKE * key.abs());
    let is_known = diagram.critical.iter().any(|critical| is_critical(critical.value));
    (!is_known).then_some(Onset {
        key,
        within,
        im: growing.last()?.1.im,
        begins: after.is_some(),
    })
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
