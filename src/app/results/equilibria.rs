//! Which equilibria are asked for, and what was found.

use super::envelopes::Envelopes;
use super::history::History;
use super::incomplete::Incomplete;
use crate::Caution;
use crate::app::judged::finer::Judging;
use crate::app::machine::clock::Seconds;
use crate::equilibrium::{Kind, Spin};
use crate::model::{DescribedBody, MassProperties};
use crate::modes::Critical;

/// A parameter that is continued from one value to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Index in [`Model::params`]; a quantity, not a count.
    pub param: usize,
    /// First value, SI.
    pub from: f64,
    /// Last value, SI; may be less than the first one.
    pub to: f64,
}

/// Which equilibria are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquilibriumSettings {
    /// Time whose motions, loads and constraints hold, s; `None`: the model's end time.
    pub at: Option<f64>,
    /// Parameter that is continued; `None`: the spin or the load grows from nothing.
    pub range: Option<Range>,
    /// Number of continuation steps; more are taken where Newton's iteration needs shorter ones.
    pub steps: u32,
    /// Rotation of what moves freely; `None`: that of the prescribed frames or of the declared start.
    pub spin: Option<Spin>,
    /// Number of modes.
    pub count: usize,
    /// How far the way is gone again on finer meshes, to tell what its outputs and critical values are off by.
    pub judged: Judging,
}

impl Default for EquilibriumSettings {
    /// 32 steps of the spin or load at the model's end time; eight modes; not judged.
    fn default() -> Self {
        Self {
            at: None,
            range: None,
            steps: 32,
            spin: None,
            count: 8,
            judged: Judging::No,
        }
    }
}

/// Equilibria one after the other; always in referenced coordinates with eliminated joints.
#[derive(Clone, Debug)]
pub struct Equilibria {
    /// Rotation or rest.
    pub kind: Kind,
    /// What was asked for.
    pub settings: EquilibriumSettings,
    /// Time whose motions and loads hold at the last equilibrium, s.
    pub t: f64,
    /// Spin of the last equilibrium, rad/s.
    pub spin: f64,
    /// Outputs over the first column, one row for each step of the continuation: the parameter in its
    /// declared unit, `spin [rad/s]` or `load_factor [1]`.
    pub history: History,
    /// Largest section forces and stresses of the bodies, over the rows of the history.
    pub envelopes: Envelopes,
    /// Of static equilibria: values of the first column where the number of negative directions of the
    /// stiffness changes and the bodies buckle or snap.
    pub critical: Vec<Critical>,
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
    /// What the model says a reader must know.
    pub cautions: Vec<Caution>,
    /// The same in sentences, and what the scene warns of at the last equilibrium.
    pub warnings: Vec<String>,
    /// Outputs, by their index in `outputs()`, with how far they are off from those of finer meshes: as part of the largest change or value, whichever is
    /// less. The largest first; none where they were not compared.
    pub off_by: Vec<(usize, f64)>,
    /// The same in a sentence, where nothing is worth a warning.
    pub agreement: Option<String>,
    /// Time that it took.
    pub seconds: Seconds,
    /// Why the last equilibrium is not that of the end; `None` where it is.
    pub incomplete: Option<Incomplete>,
}
