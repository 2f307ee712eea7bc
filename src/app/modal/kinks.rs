//! Kinks of laws at an equilibrium: what vibrates across one has no modes.

use crate::app::writing::sentences::listed;
use crate::linalg::c64;
use crate::modes::Mode;
use crate::{Scene, State};

/// Part of the sizes of the unknowns by which a mode is displaced to see which kinks it crosses.
const DISPLACED: f64 = 1e-8;
/// Part of a force that is another one on the other side of a kink.
const BENT: f64 = 1e-3;
/// Most laws that are named.
const MOST: usize = 3;

/// That laws change over at the equilibrium, along motions of these modes, which know one side of them.
pub(super) fn crossed(scene: &mut dyn Scene, state: &State, modes: &[Mode]) -> Option<String> {
    if !scene.branches(state).iter().any(|branch| branch.side().is_some()) {
        return None;
    }
    let mut names: Vec<String> = Vec::new();
    for mode in modes {
        // Where it turns back, and where it is on its way through the equilibrium.
        for turned in [c64::new(1.0, 0.0), c64::new(0.0, -1.0)] {
            let way = way(scene, mode, turned);
            let [there, back] = [1.0, -1.0].map(|sign| displaced(state, &way, sign));
            let sides = [&there, &back].map(|state| scene.branches(state));
            let crossed = sides[0].iter().zip(&sides[1]).enumerate();
            let crossed: Vec<usize> = crossed
                .filter(|(_, (there, back))| there.is_across_from(back))
                .map(|(index, _)| index)
                .collect();
            if crossed.is_empty() || !is_bent(scene, [&there, state, &back], &way) {
                continue;
            }
            let new = crossed.into_iter().map(|index| scene.describe_branch(index));
            for name in new.collect::<Vec<_>>() {
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        }
    }
    let names = listed(&names, MOST)?;
    Some(format!(
        "the equilibrium lies where {names} changes over: what moves across that has other frequencies and dampings than the modes, which know one side of it"
    ))
}

/// Small displacements and velocities of a mode at a part of its period.
fn way(scene: &dyn Scene, mode: &Mode, turned: c64) -> [Vec<f64>; 2] {
    let shape: Vec<c64> = mode.shape.iter().map(|[re, im]| c64::new(*re, *im) * turned).collect();
    let parts = shape.iter().zip(scene.sizes()).map(|(value, size)| value.norm() / size);
    let factor = DISPLACED / parts.fold(0.0, f64::max);
    let s = c64::new(mode.re, mode.im);
    let part = |value: c64| factor * value.re;
    [
        shape.iter().map(|&value| part(value)).collect(),
        shape.iter().map(|&value| part(s * value)).collect(),
    ]
}

fn displaced(state: &State, [shift, rate]: &[Vec<f64>; 2], sign: f64) -> State {
    let mut moved = state.clone();
    moved.x.iter_mut().zip(shift).for_each(|(x, shift)| *x += sign * shift);
    moved.v.iter_mut().zip(rate).for_each(|(v, rate)| *v += sign * rate);
    moved
}

/// Whether what resists a way is another part of it on one side than on the other: a law may change over without a bend.
fn is_bent(scene: &mut dyn Scene, states: [&State; 3], way: &[Vec<f64>; 2]) -> bool {
    let [there, here, back] = states.map(|state| {
        let mut force = vec![0.0; state.x.len()];
        scene.residual(state, &mut force);
        way.each_ref()
            .map(|along| along.iter().zip(&force).map(|(x, f)| x * f).sum::<f64>())
    });
    (0..2).any(|along| {
        let (up, down) = (there[along] - here[along], here[along] - back[along]);
        (up - down).abs() > BENT * up.abs().max(down.abs())
    })
}
