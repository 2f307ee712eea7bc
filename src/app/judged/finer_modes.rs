//! Whether frequencies depend on the meshes: small systems have their modes found again with twice as many elements.
//!
//! The energy that is error (`coarse.rs`) knows most of what elements are too stiff by, and not what locks in all of them alike.

use super::agreement;
use super::finer::{Judging, Meshes};
use super::marks::{TOLD, percent};
use crate::Scene;
use crate::app::writing::sentences::listed;

/// Most unknowns of a system that has its modes found again, unless all is asked for: those of the finer one take a second.
const AFFORDED: usize = 120;
/// Most modes in the sentence.
const MOST: usize = 4;

/// What is found, in a sentence: that frequencies are off by much, or by how little.
pub(in crate::app) enum Found {
    Much(String),
    Little(String),
}

/// Whether the modes of a system with so many unknowns are compared.
pub(in crate::app) fn is_asked(judged: Judging, unknowns: usize) -> bool {
    match judged {
        Judging::No => false,
        Judging::Affordable => unknowns <= AFFORDED,
        Judging::Whole => true,
    }
}

/// How far frequencies are off: ascending ones of vibrations, with the numbers of their modes, beside those of a finer one. Stiffness that a mesh adds
/// raises every one of them, so that they are compared by their places. `None` without any.
pub(in crate::app) fn compare(scene: &dyn Scene, own: &[(usize, f64)], there: &[(usize, f64)]) -> Option<Found> {
    let mut off: Vec<(usize, f64)> = own
        .iter()
        .zip(there)
        .map(|(&(mode, own), &(_, there))| (mode + 1, (own - there).abs() / there))
        .collect();
    let &(worst, most) = off.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    if most <= 0.5 * TOLD {
        return Some(Found::Little(agreement::of_modes(most, worst)));
    }
    off.retain(|of| of.1 > 0.5 * TOLD);
    let named: Vec<String> = off
        .iter()
        .map(|&(mode, part)| format!("of mode {mode} by {}", percent(part)))
        .collect();
    let Meshes { too, how, more, names } = Meshes::of(&scene.bodies());
    listed(&named, MOST).map(|named| {
        Found::Much(format!(
            "The mesh is too coarse for these modes{too}: with twice as many elements{how} in {names} frequencies differ by parts of them, that {named}. Take more elements in `mesh` (twice as many make it some ten times less){more}."
        ))
    })
}
