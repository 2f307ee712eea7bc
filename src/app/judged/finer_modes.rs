//! Whether frequencies depend on the meshes: small systems have their modes found again with twice as many elements.
//!
//! The energy that is error (`coarse.rs`) knows most of what elements are too stiff by, and not what locks in all of them alike.

use super::compared::TOLD;
use super::finer::Judging;
use super::marks::{MORE, percent};
use super::meshes::Meshes;
use super::{agreement, coarse};
use crate::app::writing::sentences::listed;
use crate::equilibrium::Uniform;
use crate::{Scene, State};

/// Most unknowns of a system that has its modes found again, unless all is asked for: those of the finer one take some tenths of a second.
const AFFORDED: usize = 400;
/// Most modes in the sentence.
const MOST: usize = 4;

/// What is found, in a sentence: that frequencies are off by much, or by how little.
pub(in crate::app) enum Found {
    Much(String),
    Little(String),
}

/// What is told of meshes: by the equilibrium, by modes about it, and how little frequencies are off.
pub(in crate::app) struct Told {
    pub equilibrium: Option<String>,
    pub modes: Option<String>,
    pub agreement: Option<String>,
}

impl Told {
    /// Of what finer meshes make of the modes; where they were not asked, `errors` has the parts of the energies of modes that are error.
    pub fn of(
        found: Option<Found>,
        scene: &mut dyn Scene,
        (at, state): (&Uniform, &State),
        errors: impl FnOnce(&mut dyn Scene) -> Vec<Vec<f64>>,
    ) -> Self {
        let (modes, agreement) = match found {
            Some(Found::Much(told)) => (Some(told), None),
            Some(Found::Little(told)) => (None, Some(told)),
            // Less than the frequencies themselves say the energies of the modes.
            None => {
                let errors = errors(scene);
                (coarse::of_modes(scene, &errors), None)
            }
        };
        Self {
            // Where frequencies agree, what the equilibrium is off by does not count: it may be the swelling of sections beside discs alone.
            equilibrium: match agreement {
                None => coarse::of_equilibrium(scene, at, state),
                Some(_) => None,
            },
            modes,
            agreement,
        }
    }
}

/// Whether the modes of a system with so many unknowns are compared.
pub(in crate::app) fn is_asked(judged: Judging, unknowns: usize) -> bool {
    match judged {
        Judging::No => false,
        Judging::Affordable => unknowns <= AFFORDED,
        Judging::Whole => true,
    }
}

/// That modes were not compared because they are many, where that was asked for as far as it is cheap.
pub(in crate::app) fn not_asked(judged: Judging, scene: &dyn Scene) -> Option<String> {
    let unknowns = scene.unknowns();
    let is_meshed = scene.bodies().iter().any(|body| body.elements > 0);
    (judged == Judging::Affordable && is_meshed && !is_asked(judged, unknowns)).then(|| {
        format!(
            "Frequencies and dampings were not compared with those of finer meshes, which takes long with {unknowns} unknowns. `--thorough` compares them, `--unjudged` says nothing."
        )
    })
}

/// Part of the damping that is told, as [`TOLD`] of what a run finds: it is off by a few times as much as the frequency.
const TOLD_OF_DAMPING: f64 = 2.0 * TOLD;
/// Damping ratio below which there is none but round-off.
const UNDAMPED: f64 = 1e-7;

/// Part of a frequency within which the next one is nearly equal.
const EQUAL: f64 = 0.01;

/// Number of a mode from 0, its rate of growth (1/s) and angular frequency (rad/s).
pub(in crate::app) type Vibration = (usize, [f64; 2]);

/// How far a mode is off: number, part of the frequency, part of the damping where there is some.
struct Off {
    mode: usize,
    frequency: f64,
    damping: f64,
}

/// What is told beside modes over a parameter: where they were compared, and critical values that are off by much, or by a part.
#[derive(Default)]
pub(in crate::app) struct Beside {
    /// Empty, or as ` at w = 10 rad/s`.
    pub place: String,
    pub values: Option<String>,
    pub of_values: Option<f64>,
}

/// How far frequencies and dampings are off: vibrations, ascending, with the numbers of their modes, rates of growth and frequencies, beside those of a finer
/// one. Stiffness that a mesh adds raises every frequency, so that they are compared by their places; those of nearly equal frequencies, of which one may grow
/// as the other dies away, by their rates. `None` without any.
pub(in crate::app) fn compare(
    scene: &dyn Scene,
    own: &[Vibration],
    there: &[Vibration],
    beside: Beside,
) -> Option<Found> {
    let Beside {
        place,
        values,
        of_values,
    } = beside;
    let off: Vec<Off> = paired(own, there)
        .into_iter()
        .map(|[(mode, own), (_, there)]| off(mode + 1, own, there))
        .collect();
    let worst = off.iter().max_by(|a, b| a.frequency.total_cmp(&b.frequency))?;
    let damped = off
        .iter()
        .max_by(|a, b| a.damping.total_cmp(&b.damping))
        .filter(|of| of.damping > 0.0);
    let is_much = |of: &Off| [of.frequency > 0.5 * TOLD, of.damping > 0.5 * TOLD_OF_DAMPING];
    if values.is_none() && !off.iter().any(|of| is_much(of).contains(&true)) {
        let damping = damped.map(|of| (of.damping, of.mode));
        let frequency = (worst.frequency, worst.mode);
        return Some(Found::Little(agreement::of_modes(
            &place, frequency, damping, of_values,
        )));
    }
    let all = |which: usize, part: fn(&Off) -> f64| {
        let named: Vec<String> = off
            .iter()
            .filter(|of| is_much(of)[which])
            .map(|of| format!("of mode {} by {}", of.mode, percent(part(of))))
            .collect();
        listed(&named, MOST)
    };
    let frequencies =
        all(0, |of| of.frequency).map(|named| format!("frequencies{place} differ by parts of them, that {named}"));
    let dampings =
        all(1, |of| of.damping).map(|named| format!("the damping{place} differs by parts of it, that {named}"));
    let values = values.map(|named| format!("critical values differ by parts of them, {named}"));
    let told: Vec<String> = frequencies.into_iter().chain(dampings).chain(values).collect();
    let Meshes { too, how, more, names } = Meshes::of(&scene.bodies());
    Some(Found::Much(format!(
        "The mesh is too coarse for these modes{too}: with twice as many elements{how} in {names} {}. {MORE}{more}.",
        told.join("; ")
    )))
}

fn off(mode: usize, [re, im]: [f64; 2], [re_there, im_there]: [f64; 2]) -> Off {
    let is_damped = (re / im).abs().max((re_there / im_there).abs()) > UNDAMPED;
    Off {
        mode,
        frequency: (im - im_there).abs() / im_there,
        damping: if is_damped {
            (re - re_there).abs() / re_there.abs().max(UNDAMPED * im_there)
        } else {
            0.0
        },
    }
}

/// Vibrations beside those of the finer mesh.
fn paired(own: &[Vibration], there: &[Vibration]) -> Vec<[Vibration; 2]> {
    let frequency = |of: &Vibration| of.1[1];
    // What round-off makes of none says nothing.
    let rate = |of: &Vibration| {
        if of.1[0].abs() > UNDAMPED * of.1[1] {
            of.1[0]
        } else {
            0.0
        }
    };
    let count = own.len().min(there.len());
    let (mut own, mut there) = (own[..count].to_vec(), there[..count].to_vec());
    let mut from = 0;
    for next in 1..=count {
        let is_near = |next: usize| frequency(&own[next]) - frequency(&own[next - 1]) <= EQUAL * frequency(&own[next]);
        if next < count && is_near(next) {
            continue;
        }
        for all in [&mut own, &mut there] {
            all[from..next].sort_by(|a, b| rate(a).total_cmp(&rate(b)));
        }
        from = next;
    }
    own.into_iter().zip(there).map(|(own, there)| [own, there]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One of two equal vibrations grows as the other dies away; their order says nothing.
    #[test]
    fn equal_frequencies_are_compared_by_their_rates() {
        let own = [(0, [2.0, 10.0]), (1, [-2.0, 10.0]), (2, [-1.0, 30.0])];
        let there = [(0, [-2.0, 9.99]), (1, [2.0, 9.99]), (2, [-1.0, 29.9])];
        let pairs = paired(&own, &there);
        assert!(pairs.iter().all(|[own, there]| own.1[0] == there.1[0]), "{pairs:?}");
        assert_eq!(pairs.len(), 3);
        // Without damping they are compared by their places.
        let own = [(0, [1e-15, 10.0]), (1, [-1e-15, 10.04])];
        let there = [(0, [-1e-15, 9.99]), (1, [0.0, 10.03])];
        let pairs = paired(&own, &there);
        assert!(pairs.iter().all(|[own, there]| own.0 == there.0), "{pairs:?}");
    }
}
