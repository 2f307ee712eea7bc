//! Modes about one equilibrium, and how an observer sees them who does not turn (THEORY 8.1, 8.2).

use super::equilibria::EquilibriumSettings;
use crate::app::machine::clock::Seconds;
use crate::app::pictures::Shapes;
use crate::equilibrium::Uniform;
use crate::model::{DescribedBody, MassProperties, ROUND};
use crate::modes::{Composition, Mode, Whirl};
use crate::{Scene, State};

/// A mode and its sense of whirl.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenMode {
    /// Rate of growth, 1/s.
    pub re: f64,
    /// Angular frequency in the reference frame, which turns with the system, rad/s, not negative.
    pub im: f64,
    /// Sense of the whirl, seen in the reference frame.
    pub whirl: Whirl,
    /// How round it is: 1 on circles with the spin, -1 against it; `None` where nothing moves across the
    /// axis or nothing spins.
    pub circulation: Option<f64>,
}

/// The modes about one equilibrium.
#[derive(Clone, Debug)]
pub struct Modes {
    /// What was asked for.
    pub settings: EquilibriumSettings,
    /// Time whose motions and loads hold, s.
    pub t: f64,
    /// Spin of the equilibrium, rad/s.
    pub spin: f64,
    /// The modes of the lowest |s|, and others that grow, ascending frequencies.
    pub modes: Vec<SeenMode>,
    /// The same with their shapes.
    pub shapes: Vec<Mode>,
    /// What moves in each of them.
    pub compositions: Vec<Composition>,
    /// What the bodies do in them; `None` where the scene does not draw itself.
    pub pictures: Option<Shapes>,
    /// Whether every mode that moves across the axis whirls on circles, as those about an axisymmetric,
    /// balanced equilibrium do: each is then seen at one frequency in the inertial frame.
    pub is_round: bool,
    /// Largest rate of growth, 1/s; `None` without modes.
    pub margin: Option<f64>,
    /// The meshed bodies, and how they are described.
    pub bodies: Vec<DescribedBody>,
    /// Masses of the bodies at the equilibrium, and of all.
    pub masses: Vec<MassProperties>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of the equilibrium.
    pub newton_iterations: u64,
    /// What the scene warns of at the equilibrium.
    pub warnings: Vec<String>,
    /// How far frequencies are from those of finer meshes, where that was asked for and is not worth a warning.
    pub agreement: Option<String>,
    /// Time that it took.
    pub seconds: Seconds,
}

/// Part of the spin below which a whirl in space is round-off.
const STILL: f64 = 1e-12;
/// Rates of growth below this part of the largest |s| are round-off.
const NEUTRAL: f64 = 1e-9;
/// Growth, of the frequency of the mode itself, that round-off makes of two equal ones: its root.
const DOUBLE: f64 = 1e-7;

impl SeenMode {
    /// The mode with its sense in the scene.
    pub(in crate::app) fn of(scene: &mut dyn Scene, at: &Uniform, state: &State, mode: &Mode) -> Self {
        let circulation = scene.circulation(at, state, &mode.shape);
        Self {
            re: mode.re,
            im: mode.im,
            whirl: Whirl::of(mode.im, circulation),
            circulation,
        }
    }

    /// Whether the motion meets no stiffness: its eigenvalue is zero, and what is pushed along it drifts on.
    pub fn is_still(&self) -> bool {
        self.re == 0.0 && self.im == 0.0
    }

    /// Damping ratio -re/|s| in the reference frame: 0 undamped, 1 creeping back, negative where the motion grows;
    /// `None` for s = 0.
    pub fn damping_ratio(&self) -> Option<f64> {
        ratio(self.re, self.im)
    }

    /// How an observer sees the mode who does not turn, of a system that turns with `spin` (rad/s; THEORY 8.1).
    pub fn inertial(&self, spin: f64) -> Inertial {
        match self.circulation {
            _ if spin == 0.0 => Inertial::One(self.im),
            None => Inertial::One(self.im),
            Some(circulation) if circulation.abs() > ROUND && self.im > 0.0 => {
                let velocity = spin + self.im * circulation.signum();
                // What stands still in space has the round-off of two equal numbers.
                let is_still = velocity.abs() <= STILL * spin;
                Inertial::Whirl(if is_still { 0.0 } else { velocity })
            }
            Some(_) => Inertial::Two([spin + self.im, (spin - self.im).abs()]),
        }
    }

    /// The same of all: frequencies, rad/s, not negative.
    pub fn inertial_frequencies(&self, spin: f64) -> Vec<f64> {
        match self.inertial(spin) {
            Inertial::One(im) => vec![im],
            Inertial::Whirl(velocity) => vec![velocity.abs()],
            Inertial::Two([fast, slow]) if fast == slow => vec![fast],
            Inertial::Two(both) => both.to_vec(),
        }
    }

    /// Damping ratios that belong to the [inertial frequencies](Self::inertial_frequencies).
    pub fn inertial_damping_ratios(&self, spin: f64) -> Vec<Option<f64>> {
        let frequencies = self.inertial_frequencies(spin).into_iter();
        frequencies.map(|im| ratio(self.re, im)).collect()
    }

    /// Logarithmic decrements -2 pi re/im that belong to them: of the amplitudes one period apart; `None` without a period.
    pub fn logarithmic_decrements(&self, spin: f64) -> Vec<Option<f64>> {
        let frequencies = self.inertial_frequencies(spin).into_iter();
        frequencies
            .map(|im| (im > 0.0).then(|| -std::f64::consts::TAU * self.re / im))
            .collect()
    }

    /// Whether it vibrates with some of its kinetic energy across the axis of the rotation.
    pub fn is_across(&self) -> bool {
        self.im > 0.0 && self.circulation.is_some()
    }

    /// Sense of the whirl that this observer sees.
    pub fn inertial_whirl(&self, spin: f64) -> Whirl {
        match self.inertial(spin) {
            Inertial::Whirl(velocity) if velocity > 0.0 => Whirl::Forward,
            Inertial::Whirl(velocity) if velocity < 0.0 => Whirl::Backward,
            Inertial::Two(_) if self.im > 0.0 => Whirl::Mixed,
            _ => Whirl::None,
        }
    }
}

/// What an observer sees of a mode who does not turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertial {
    /// The frequency of the reference frame, rad/s: nothing turns, or next to nothing moves across the axis.
    One(f64),
    /// A whirl on circles with this angular velocity, rad/s, positive with the spin.
    Whirl(f64),
    /// Motions of two frequencies at once, spin + im and |spin - im|, rad/s.
    Two([f64; 2]),
}

fn ratio(re: f64, im: f64) -> Option<f64> {
    let size = re.hypot(im);
    (size > 0.0).then(|| -re / size)
}

/// Whether all modes that oscillate across the axis do so on circles, and there are some.
pub(in crate::app) fn is_round(modes: &[SeenMode]) -> bool {
    let mut across = modes
        .iter()
        .filter(|mode| mode.is_across())
        .filter_map(|mode| mode.circulation);
    let first = across.next();
    first.is_some_and(|first| first.abs() > ROUND) && across.all(|circulation| circulation.abs() > ROUND)
}

/// Rates of growth up to this are round-off beside these modes, 1/s.
pub(in crate::app) fn neutral(modes: &[SeenMode]) -> f64 {
    NEUTRAL * largest(modes)
}

/// The largest |s|, 1/s.
fn largest(modes: &[SeenMode]) -> f64 {
    modes.iter().map(|mode| mode.re.hypot(mode.im)).fold(0.0, f64::max)
}

/// Unknowns up to which all modes are looked at for growth, once.
pub(in crate::app) const MANY: usize = 300;

/// Whether a mode grows, and not by the round-off of modes of which this is the largest |s|.
pub(in crate::app) fn grows(re: f64, im: f64, largest: f64) -> bool {
    re > NEUTRAL * largest && re > DOUBLE * re.hypot(im)
}

/// The rate of growth of an unstable equilibrium, 1/s; `None` where it is stable, or neutral to round-off.
pub(in crate::app) fn growth(modes: &[SeenMode]) -> Option<f64> {
    fastest(modes).map(|mode| mode.re)
}

/// The mode that grows fastest, as of [`growth`].
pub(in crate::app) fn fastest(modes: &[SeenMode]) -> Option<SeenMode> {
    let largest = largest(modes);
    let growing = modes.iter().filter(|mode| grows(mode.re, mode.im, largest));
    growing.copied().max_by(|a, b| a.re.total_cmp(&b.re))
}
