//! Modes over a parameter or the spin, and where their frequencies are critical.

use super::equilibria::EquilibriumSettings;
use super::history::Column;
use super::incomplete::Incomplete;
use super::modes::{Inertial, SeenMode};
use crate::app::machine::clock::Seconds;
use crate::app::writing::csv::{cell, push_number};
use crate::model::{DescribedBody, MassProperties};
use crate::modes::{Composition, Critical, Whirl};

/// Modes over the first column.
#[derive(Clone, Debug)]
pub struct Campbell {
    /// What was asked for.
    pub settings: EquilibriumSettings,
    /// Time whose motions and loads hold at the last equilibrium, s.
    pub t: f64,
    /// What is continued: a parameter in its declared unit, or `spin [rad/s]`.
    pub key: Column,
    /// Values of the first column, in the order of the way.
    pub keys: Vec<f64>,
    /// Spin at each of them, rad/s.
    pub spins: Vec<f64>,
    /// Angular velocity with whose multiples frequencies are compared at each of them, rad/s: the spin, or where nothing turns that of a rotor in
    /// bearings that stand still, as which a continued parameter counts that is an angular velocity.
    pub excitations: Vec<f64>,
    /// Modes followed by their shapes: for each its values at each of [`Campbell::keys`], `None` where it
    /// is not among the lowest ones.
    pub tracks: Vec<Vec<Option<SeenMode>>>,
    /// Whether the modes whirl on circles at every spin but 0, as those about axisymmetric, balanced
    /// equilibria do.
    pub is_round: bool,
    /// Whether all modes were looked at for growth, and not the lowest ones alone.
    pub is_all: bool,
    /// Values of the first column where the stiffness in the reference frame vanishes: critical speeds, at
    /// which what stands still in the frame, an unbalance, excites a mode.
    pub critical: Vec<Critical>,
    /// Whether a frequency in the reference frame is zero at each of them. With damping none is: forward modes
    /// cross the spin elsewhere ([`Campbell::crossings`]).
    pub standing: Vec<bool>,
    /// Whether the last equilibrium is the one nearest to the undeformed shape: an unbalanced shaft that stiffens as it bends goes on as a rope that is swung.
    pub is_near: bool,
    /// Where a frequency is one of [`Campbell::excitations`], or twice it.
    pub crossings: Vec<Crossing>,
    /// Where a mode begins to grow, or the last one ceases to, while the stiffness does not vanish.
    pub onsets: Vec<Onset>,
    /// What moves in the modes of [`Campbell::tracks`], at the last value at which each is known.
    pub compositions: Vec<Composition>,
    /// For each of [`Campbell::tracks`] the parts by which the meshes of the bodies make its frequency too high; empty where nothing is known.
    pub(in crate::app) mesh_errors: Vec<Vec<f64>>,
    /// How bodies are described.
    pub bodies: Vec<DescribedBody>,
    /// Masses with their centres and inertia at the last equilibrium.
    pub masses: Vec<MassProperties>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of all steps.
    pub newton_iterations: u64,
    /// What the scene warns of at the last equilibrium.
    pub warnings: Vec<String>,
    /// How far frequencies and critical values are from those of finer meshes, where that was asked for and is not worth a warning.
    pub agreement: Option<String>,
    /// Time that it took.
    pub seconds: Seconds,
    /// Why the diagram ends early; `None` where it is complete.
    pub incomplete: Option<Incomplete>,
}

/// Where the frequency of a mode is a multiple of what excites: as an observer sees it who does not turn, or in the reference
/// frame where that observer sees two frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Index of the mode in [`Campbell::tracks`].
    pub track: usize,
    /// Multiple: 1 or 2.
    pub order: u32,
    /// Sense of the whirl in the inertial frame; [`Whirl::None`] where nothing moves across the axis, [`Whirl::Mixed`] where
    /// the frequency is that of the reference frame.
    pub whirl: Whirl,
    /// Value of the first column.
    pub key: f64,
    /// How far off it may be.
    pub within: f64,
    /// The frequency there, rad/s.
    pub im: f64,
}

/// Where an equilibrium becomes unstable by a mode that oscillates, or stable again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Onset {
    /// Value of the first column.
    pub key: f64,
    /// How far off it may be.
    pub within: f64,
    /// Angular frequency of the mode in the reference frame, rad/s.
    pub im: f64,
    /// Whether modes grow behind it, and not before.
    pub begins: bool,
}

impl Campbell {
    /// Whether anything turns.
    pub(in crate::app) fn is_turning(&self) -> bool {
        self.spins.iter().any(|&spin| spin > 0.0)
    }

    /// Whether there is anything with whose multiples frequencies are compared.
    pub(in crate::app) fn is_excited(&self) -> bool {
        self.excitations.iter().any(|&excitation| excitation > 0.0)
    }

    /// The largest rate of growth at each of [`Campbell::keys`], 1/s.
    pub fn margins(&self) -> Vec<Option<f64>> {
        let at = |row: usize| self.row(row).map(|mode| mode.re).reduce(f64::max);
        (0..self.keys.len()).map(at).collect()
    }

    /// The modes at one of [`Campbell::keys`].
    pub fn row(&self, row: usize) -> impl Iterator<Item = SeenMode> + '_ {
        self.tracks.iter().filter_map(move |track| track[row])
    }

    /// The table as comma-separated text, 17 significant digits; empty where a mode is not among the
    /// lowest ones. Inertial frequencies are negative for a backward whirl, and empty where there are two.
    pub fn to_csv(&self) -> String {
        let mut text = self.key.head();
        for index in 1..=self.tracks.len() {
            text += &format!(",mode {index} im [rad/s],mode {index} re [1/s],mode {index} inertial [rad/s]");
        }
        text.push('\n');
        for (row, key) in self.keys.iter().enumerate() {
            push_number(&mut text, *key);
            for track in &self.tracks {
                match track[row] {
                    Some(mode) => {
                        text += &format!(",{},{},", cell(mode.im), cell(mode.re));
                        match mode.inertial(self.spins[row]) {
                            Inertial::One(velocity) | Inertial::Whirl(velocity) => push_number(&mut text, velocity),
                            Inertial::Two(_) => {}
                        }
                    }
                    None => text += ",,,",
                }
            }
            text.push('\n');
        }
        text
    }
}
