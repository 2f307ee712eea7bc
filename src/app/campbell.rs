//! Campbell diagrams: modes over a parameter or the spin, each followed by its shape (THEORY 8.1);
//! nothing is printed or written here.

use std::ops::ControlFlow;

use super::cautions;
use super::clock::{Clock, Seconds};
use super::history::Column;
use super::modes::{SeenMode, is_round};
use super::run_error::{Incomplete, RunError};
use super::sweep::{Line, SweepProgress, SweepSettings};
use crate::equilibrium::Kind;
use crate::modes::{self, Critical, Mode, Wanted};
use crate::{Model, Scene, State};

/// Modes over the first column.
#[derive(Clone, Debug)]
pub struct Campbell {
    /// What was asked for.
    pub settings: SweepSettings,
    /// Time whose motions and loads hold at the last equilibrium, s.
    pub t: f64,
    /// What is continued: a parameter in its declared unit, or `spin [rad/s]`.
    pub key: Column,
    /// Values of the first column, in the order of the way.
    pub keys: Vec<f64>,
    /// Spin at each of them, rad/s.
    pub spins: Vec<f64>,
    /// Modes followed by their shapes: for each its values at each of [`Campbell::keys`], `None` where it
    /// is not among the lowest ones.
    pub tracks: Vec<Vec<Option<SeenMode>>>,
    /// Whether the modes whirl on circles at every spin but 0, as those about axisymmetric, balanced
    /// equilibria do.
    pub is_round: bool,
    /// Values of the first column where a frequency in the reference frame is zero: critical speeds, at
    /// which what stands still in the frame, an unbalance, excites a mode. Not looked for beyond
    /// [`Campbell::LARGEST`] unknowns.
    pub critical: Vec<Critical>,
    /// Where a frequency in the reference frame is that of the spin, or twice it.
    pub crossings: Vec<Crossing>,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Newton iterations of all steps.
    pub newton_iterations: u64,
    /// What the scene warns of at the last equilibrium.
    pub warnings: Vec<String>,
    /// Time that it took.
    pub seconds: Seconds,
    /// Why the diagram ends early; `None` where it is complete.
    pub incomplete: Option<Incomplete>,
}

/// Where the frequency of a mode, in the reference frame, is a multiple of the spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Index of the mode in [`Campbell::tracks`].
    pub track: usize,
    /// Multiple of the spin: 1 or 2.
    pub order: u32,
    /// Value of the first column, between two steps on straight lines.
    pub key: f64,
    /// The frequency there, rad/s.
    pub im: f64,
}

/// Modes that are looked at beyond those shown, so that one that leaves them is not lost at once.
const BEYOND: usize = 6;

impl Campbell {
    /// Most unknowns for which critical speeds are looked for, with full matrices.
    pub const LARGEST: usize = 800;

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
    /// lowest ones.
    pub fn to_csv(&self) -> String {
        let mut text = self.key.head();
        for index in 1..=self.tracks.len() {
            text += &format!(",mode {index} im [rad/s],mode {index} re [1/s]");
        }
        text.push('\n');
        for (row, key) in self.keys.iter().enumerate() {
            text += &format!("{key:.16e}");
            for track in &self.tracks {
                match track[row] {
                    Some(mode) => text += &format!(",{:.16e},{:.16e}", mode.im, mode.re),
                    None => text += ",,",
                }
            }
            text.push('\n');
        }
        text
    }

    /// Adds the modes of a step to their tracks; the indices of those that begin a track.
    fn add(&mut self, seen: &[SeenMode], partners: &[Option<usize>], count: usize) -> Vec<usize> {
        let row = self.keys.len() - 1;
        let mut is_taken = vec![false; seen.len()];
        for (track, partner) in self.tracks.iter_mut().zip(partners) {
            track.push(partner.map(|index| seen[index]));
            if let Some(index) = *partner {
                is_taken[index] = true;
            }
        }
        // Among the lowest ones by |s|, what continues no other mode is new.
        let mut order: Vec<usize> = (0..seen.len()).collect();
        let size = |index: &usize| seen[*index].re.hypot(seen[*index].im);
        order.sort_by(|a, b| size(a).total_cmp(&size(b)).then(a.cmp(b)));
        let lowest = order.into_iter().take(count);
        let mut new: Vec<usize> = lowest.filter(|&index| !is_taken[index]).collect();
        new.sort_unstable();
        for &index in &new {
            let mut track = vec![None; row];
            track.push(Some(seen[index]));
            self.tracks.push(track);
        }
        new
    }

    /// The last mode of a track as it is expected next: its frequency on the secant, conjugate where that
    /// passes zero.
    fn expected(&self, mode: &Mode, track: &[Option<SeenMode>]) -> Mode {
        // The keys have the next value already.
        let [.., first, second, next] = self.keys[..] else {
            return mode.clone();
        };
        let [.., Some(before), Some(last)] = track else {
            return mode.clone();
        };
        let im = last.im + (last.im - before.im) * (next - second) / (second - first);
        let mut expected = if im < 0.0 { conjugate(mode) } else { mode.clone() };
        expected.im = im.abs();
        expected
    }

    /// Crossings with the spin and twice the spin in the last step.
    fn cross(&mut self) {
        let Some(row) = self.keys.len().checked_sub(2) else {
            return;
        };
        for (index, track) in self.tracks.iter().enumerate() {
            let (Some(before), Some(after)) = (track[row], track[row + 1]) else {
                continue;
            };
            for order in [1, 2] {
                let above = |mode: SeenMode, row: usize| mode.im - f64::from(order) * self.spins[row];
                let (low, high) = (above(before, row), above(after, row + 1));
                if (low > 0.0) != (high > 0.0) && low != 0.0 {
                    let share = low / (low - high);
                    self.crossings.push(Crossing {
                        track: index,
                        order,
                        key: self.keys[row] + share * (self.keys[row + 1] - self.keys[row]),
                        im: before.im + share * (after.im - before.im),
                    });
                }
            }
        }
    }
}

/// The modes of a model over a parameter, or over the spin from rest to that of the time of the settings.
///
/// # Errors
/// A model that cannot be built; [`RunError::Equilibrium`] where no equilibrium or no modes exist at the
/// start; [`RunError::Campbell`] with the modes found where the way ends early.
pub fn campbell<M: Model>(model: &M, settings: &SweepSettings) -> Result<Campbell, RunError> {
    campbell_watched(model, settings, |_| ControlFlow::Continue(()))
}

/// As [`campbell`]; `watch` is called after every step, and ends the way by [`ControlFlow::Break`].
///
/// # Errors
/// As [`campbell`].
pub fn campbell_watched<M: Model>(
    model: &M,
    settings: &SweepSettings,
    mut watch: impl FnMut(&SweepProgress) -> ControlFlow<()>,
) -> Result<Campbell, RunError> {
    let clock = Clock::start();
    let mut line = Line::start(model, Kind::Steady, settings)?;
    let mut tracker = Tracker::default();
    let mut diagram = Campbell {
        settings: *settings,
        t: 0.0,
        key: line.column(),
        keys: Vec::new(),
        spins: Vec::new(),
        tracks: Vec::new(),
        is_round: true,
        critical: Vec::new(),
        crossings: Vec::new(),
        unknowns: 0,
        constraints: 0,
        newton_iterations: 0,
        warnings: Vec::new(),
        seconds: Seconds::default(),
        incomplete: None,
    };
    let mut reason = tracker.look(&mut line, &mut diagram).err().map(Incomplete::Equilibrium);
    while reason.is_none() && !line.is_done() {
        reason = line
            .advance()
            .and_then(|()| tracker.look(&mut line, &mut diagram))
            .err()
            .map(Incomplete::Equilibrium);
        if watch(&line.progress()).is_break() && !line.is_done() {
            reason = reason.or(Some(Incomplete::Interrupted));
        }
    }
    if let (Some(Incomplete::Equilibrium(text)), true) = (&reason, diagram.keys.len() < 2) {
        return Err(RunError::Equilibrium(text.clone()));
    }
    diagram.is_round &= diagram.spins.iter().any(|&spin| spin > 0.0);
    diagram.incomplete = reason;
    diagram.newton_iterations = line.iterations;
    let station = line.station();
    diagram.t = station.at.t;
    diagram.unknowns = station.scene.unknowns();
    diagram.constraints = station.scene.constraints();
    diagram.warnings = cautions::cautioned(model, station.scene.warnings(station.state));
    diagram.seconds = clock.seconds();
    match diagram.incomplete {
        None => Ok(diagram),
        Some(_) => Err(RunError::Campbell(Box::new(diagram))),
    }
}

/// What the next step is compared with.
#[derive(Default)]
struct Tracker {
    /// The last mode of each track.
    last: Vec<Mode>,
    /// Negative directions of the stiffness at the last step.
    negative: Option<usize>,
}

impl Tracker {
    /// Adds the last equilibrium of the line to the diagram.
    fn look<M: Model>(&mut self, line: &mut Line<'_, M>, diagram: &mut Campbell) -> Result<(), String> {
        let count = diagram.settings.count;
        let station = line.station();
        let (at, state, key) = (station.at, station.state, station.key);
        let told = |error: crate::SolveError| format!("at {} = {key} {}: {error}", diagram.key.name, diagram.key.unit);
        let wanted = Wanted { count: count + BEYOND };
        let found = modes::modes(station.scene, &at, state, wanted).map_err(told)?;
        let seen: Vec<SeenMode> = found
            .iter()
            .map(|mode| SeenMode::of(station.scene, &at, state, mode))
            .collect();
        let weights = masses(station.scene, state);
        let is_turning = station.spin > 0.0 && diagram.spins.last().is_some_and(|&spin| spin > 0.0);
        let negative = if state.x.len() <= Campbell::LARGEST {
            Some(modes::unstable_directions(station.scene, &at, state).map_err(told)?)
        } else {
            None
        };
        diagram.keys.push(key);
        diagram.spins.push(station.spin);
        let is_spinning = station.spin > 0.0;
        let expected: Vec<Mode> = self
            .last
            .iter()
            .zip(&diagram.tracks)
            .map(|(mode, track)| diagram.expected(mode, track))
            .collect();
        let least = if is_turning { CLEAR } else { 0.0 };
        let partners = partners(&expected, &found, &weights, least);
        let new = diagram.add(&seen, &partners, count);
        if is_spinning {
            // The highest ones, which the mesh hardly shows, are not asked.
            let shown: Vec<SeenMode> = diagram.row(diagram.keys.len() - 1).collect();
            diagram.is_round &= is_round(&shown);
        }
        for (last, partner) in self.last.iter_mut().zip(&partners) {
            if let Some(index) = *partner {
                last.clone_from(&found[index]);
            }
        }
        self.last.extend(new.into_iter().map(|index| found[index].clone()));
        diagram.cross();
        self.locate(line, diagram, negative);
        Ok(())
    }

    /// The critical values in the last step.
    fn locate<M: Model>(&mut self, line: &mut Line<'_, M>, diagram: &mut Campbell, negative: Option<usize>) {
        let before = std::mem::replace(&mut self.negative, negative);
        let (Some(low), Some(high), (Some(first), last)) = (before, negative, line.last_two()) else {
            return;
        };
        if low == high {
            return;
        }
        let (first, last) = (first.clone(), last.clone());
        let found = line.critical(&first, &last, [low, high], |scene, at, step| {
            modes::unstable_directions(scene, at, &step.state).ok()
        });
        let critical = found.into_iter().map(|(value, change)| Critical { value, change });
        diagram.critical.extend(critical);
    }
}

/// Assurance below this is another mode, unless the whirls part at the first spin.
const CLEAR: f64 = 0.6;

/// The diagonal of the mass matrix: shapes of different modes are nearly orthogonal with it.
fn masses(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut values = vec![0.0; scene.pattern().entries()];
    scene.mass(state, &mut values);
    let pattern = scene.pattern();
    (0..state.x.len())
        .map(|row| pattern.find(row, row).map_or(0.0, |place| values[place].abs()))
        .collect()
}

/// For every mode before, its index among those after. One that is not found may have passed zero and
/// come back as its conjugate: what is left is compared with that.
fn partners(before: &[Mode], after: &[Mode], weights: &[f64], least: f64) -> Vec<Option<usize>> {
    let clear = |before: &[Mode], after: &[Mode]| {
        let mut partners = modes::matched(before, after, weights);
        for (mode, partner) in before.iter().zip(&mut partners) {
            partner.take_if(|index| modes::assurance(&mode.shape, &after[*index].shape, weights) < least);
        }
        partners
    };
    let mut partners = clear(before, after);
    let lost: Vec<usize> = (0..before.len()).filter(|&index| partners[index].is_none()).collect();
    let new: Vec<usize> = (0..after.len())
        .filter(|&index| !partners.contains(&Some(index)))
        .collect();
    let turned: Vec<Mode> = lost.iter().map(|&index| conjugate(&before[index])).collect();
    let rest: Vec<Mode> = new.iter().map(|&index| after[index].clone()).collect();
    for (&index, partner) in lost.iter().zip(clear(&turned, &rest)) {
        partners[index] = partner.map(|place| new[place]);
    }
    partners
}

fn conjugate(mode: &Mode) -> Mode {
    let mut mode = mode.clone();
    mode.shape.iter_mut().for_each(|value| value[1] = -value[1]);
    mode
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::sweep::Range;
    use crate::app::testing::Rotor;
    use crate::modes::Whirl;

    #[test]
    fn a_rotor_over_its_speed() {
        let rotor = Rotor {
            loss: 0.0,
            length: 0.0,
            ..Rotor::default()
        };
        let settings = SweepSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to: 12.0,
            }),
            steps: 25,
            ..SweepSettings::default()
        };
        let found = campbell(&rotor, &settings).unwrap();
        let w0 = 50f64.sqrt();
        assert_eq!((found.keys.len(), found.tracks.len(), found.is_round), (26, 2, true));
        // Both whirls of the shaft, w0 in axes that stand still, each on its track throughout.
        let mut tracks: Vec<_> = found.tracks.iter().collect();
        tracks.sort_by(|a, b| a[1].unwrap().im.total_cmp(&b[1].unwrap().im));
        for (row, spin) in found.spins.iter().enumerate().skip(1) {
            let [forward, backward] = [tracks[0][row].unwrap(), tracks[1][row].unwrap()];
            assert!((forward.im - (w0 - spin).abs()).abs() < 1e-9, "{row} {forward:?}");
            assert!((backward.im - (w0 + spin)).abs() < 1e-9, "{row} {backward:?}");
            let sense = if *spin < w0 { Whirl::Forward } else { Whirl::Backward };
            assert_eq!((forward.whirl, backward.whirl), (sense, Whirl::Backward));
            for mode in [forward, backward] {
                assert!((mode.inertial(*spin, true)[0] - w0).abs() < 1e-9);
            }
        }
        assert_eq!(found.critical.len(), 1);
        assert_eq!(found.critical[0].change, 2);
        assert!((found.critical[0].value - w0).abs() < 1e-5, "{:?}", found.critical);
        // w0 - W = W and 2 W; w0 + W = 2 W.
        let mut keys: Vec<f64> = found.crossings.iter().map(|crossing| crossing.key).collect();
        keys.sort_by(f64::total_cmp);
        for (key, exact) in keys.iter().zip([w0 / 3.0, w0 / 2.0, w0]) {
            assert!((key - exact).abs() < 1e-9, "{keys:?}");
        }
        assert_eq!(keys.len(), 3);
        let text = found.to_csv();
        assert!(text.starts_with("omega [rad/s],mode 1 im [rad/s],mode 1 re [1/s],mode 2 im [rad/s],"));
        assert_eq!(text.lines().count(), 27);
    }
}
