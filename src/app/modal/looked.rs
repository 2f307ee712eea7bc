//! The modes at one equilibrium of a way: the lowest ones, and those beyond them that grow.

use crate::app::results::modes::grows;
use crate::equilibrium::Uniform;
use crate::modes::{self, Mode, Wanted};
use crate::{Scene, SolveError, State};

/// Modes that are looked at beyond those shown, so that one that leaves them is not lost at once: as many of these as can be had.
const BEYOND: [usize; 2] = [6, 2];
/// Unknowns up to which all modes are looked at for growth, at every step.
const FEW: usize = 60;

/// The modes at an equilibrium, with shapes that are turned back with the system to t = 0: at one time systems have turned by other angles at other speeds.
pub(super) struct Looked {
    /// The lowest ones, and those beyond them that grow.
    pub modes: Vec<Mode>,
    /// Whether all were looked at for that.
    pub is_all: bool,
    /// The largest |s| of the lowest ones.
    pub largest: f64,
    pub weights: Vec<f64>,
}

impl Looked {
    pub fn at(scene: &mut dyn Scene, at: &Uniform, state: &State, count: usize) -> Result<Self, SolveError> {
        let modes = |scene: &mut dyn Scene, count| {
            let (modes, is_all) = modes::modes_and_growing(scene, at, state, Wanted { count }, FEW)?;
            Ok((modes, is_all, count))
        };
        // Those beyond what is asked for may be too many.
        let beyond = BEYOND.into_iter().find_map(|beyond| modes(scene, count + beyond).ok());
        let (mut modes, is_all, lowest) = beyond.map_or_else(|| modes(scene, count), Ok)?;
        let mut sizes: Vec<f64> = modes.iter().map(size).collect();
        sizes.sort_by(f64::total_cmp);
        let largest = sizes.into_iter().take(lowest).next_back().unwrap_or(0.0);
        for mode in &mut modes {
            scene.carried_shape(at, &mut mode.shape, true);
        }
        let weights = masses(scene, state);
        Ok(Self {
            modes,
            is_all,
            largest,
            weights,
        })
    }

    pub fn grows(&self, index: usize) -> bool {
        let largest = self.modes.iter().map(size).fold(0.0, f64::max);
        let mode = &self.modes[index];
        grows(mode.re, mode.im, largest)
    }

    /// Indices from the lowest |s|.
    pub fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.modes.len()).collect();
        let size = |&index: &usize| size(&self.modes[index]);
        order.sort_by(|a, b| size(a).total_cmp(&size(b)).then(a.cmp(b)));
        order
    }
}

/// A mode with the shape that it has at the time of the equilibrium.
pub(super) fn there(scene: &mut dyn Scene, at: &Uniform, mode: &Mode) -> Mode {
    let mut mode = mode.clone();
    scene.carried_shape(at, &mut mode.shape, false);
    mode
}

pub(super) fn size(mode: &Mode) -> f64 {
    mode.re.hypot(mode.im)
}

/// Weight of a state beside the heaviest unknown: it tells modes apart in which nothing else moves.
const OF_STATES: f64 = 1e-6;

/// The diagonal of the mass matrix: shapes of different modes are nearly orthogonal with it.
fn masses(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut values = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut values);
    let (pattern, sizes) = (scene.pattern(), scene.sizes());
    let mut masses: Vec<f64> = (0..state.x.len())
        .map(|row| pattern.find(row, row).map_or(0.0, |place| values[place].abs()))
        .collect();
    let heaviest = masses
        .iter()
        .zip(sizes)
        .map(|(mass, size)| mass * size * size)
        .fold(0.0, f64::max);
    for &state in scene.states() {
        masses[state] = OF_STATES * if heaviest > 0.0 { heaviest } else { 1.0 } / sizes[state].powi(2);
    }
    masses
}
