//! Modes followed by their shapes from step to step of a way, and what is between the steps: critical values and crossings
//! with multiples of the spin.

use super::known::{self, Known};
use super::looked::{Looked, size, there};
use crate::app::equilibria::continuation::{Found, Line};
use crate::app::equilibria::directions::{self, Measured};
use crate::app::results::campbell::{Campbell, Crossing};
use crate::app::results::modes::{Inertial, SeenMode, is_round};
use crate::modes::{self, Composition, Critical, Mode, Whirl};
use crate::{SolveError, State};

/// Times that a step is halved to find where a mode goes.
const HALVINGS: u32 = 4;
/// Part of the largest |s| of a step beyond which a mode that is lost may have left the lowest ones.
const INSIDE: f64 = 0.9;
/// Looks at a crossing, and the width at which it is found, part of the way.
const LOOKS: u32 = 8;
const WIDTH: f64 = 1e-7;
/// Damping, as part of the spin, at which a forward whirl hardly crosses the spin elsewhere than without: by half of its square.
const UNDAMPED: f64 = 0.01;
const ALIKE: f64 = 1e-4;
/// Part of the spin within which the rate of a mode between two steps is as expected.
const NEAR: f64 = 1e-3;

/// What the next step is compared with.
#[derive(Default)]
pub(in crate::app) struct Tracker {
    /// The last mode of each track of the diagram.
    last: Vec<Mode>,
    /// What moves in it.
    compositions: Vec<Composition>,
    /// Whether it was among the lowest ones at a step: others are followed, and not shown.
    is_shown: Vec<bool>,
    /// What the meshes of the bodies make of each track.
    mesh_errors: Vec<Judged>,
    /// Of the symmetric part of the stiffness.
    symmetric: Known,
    /// Of the whole of it, where circulatory forces act: it is singular where a frequency is zero, and without damping its symmetric part is, too.
    whole: Known,
    /// Whether circulatory forces act at the last step.
    circulates: bool,
    /// Whether something stands still in the last step that nothing holds.
    is_loose: bool,
}

/// By how much the meshes of the bodies make a frequency too high, rad/s, and the largest frequency at which that was looked at.
#[derive(Clone, Default)]
struct Judged {
    size: f64,
    errors: Vec<f64>,
}

impl Judged {
    fn meet(&mut self, size: f64, parts: Vec<f64>) {
        let errors: Vec<f64> = parts.into_iter().map(|part| part * size).collect();
        self.size = self.size.max(size);
        if errors.iter().sum::<f64>() > self.errors.iter().sum() {
            self.errors = errors;
        }
    }

    fn parts(self) -> Vec<f64> {
        self.errors.into_iter().map(|error| error / self.size).collect()
    }
}

/// Part of a frequency by which it and the spin differ for round-off.
const SAME: f64 = 1e-9;

impl Tracker {
    /// Adds the last equilibrium of the line to the diagram.
    ///
    /// # Errors
    /// Why there are no modes, with the value at which.
    pub fn look(&mut self, line: &mut Line<'_>, diagram: &mut Campbell) -> Result<(), String> {
        let count = diagram.settings.count;
        let station = line.station();
        let (at, key, spin, excitation) = (station.at, station.key, station.spin, station.excitation);
        let told = |error: SolveError| format!("at {} = {key} {}: {error}", diagram.key.name, diagram.key.unit);
        let found = Looked::at(station.scene, &at, station.state, count).map_err(told)?;
        let symmetric = directions::turning(station.scene, &at, station.state, false).map_err(told)?;
        let circulated = self.circulates;
        self.circulates = modes::is_circulatory(station.scene, &at, station.state);
        let whole = if self.circulates {
            directions::whole(station.scene, &at, station.state, true).ok()
        } else {
            Some(symmetric.clone())
        };
        diagram.keys.push(key);
        diagram.spins.push(spin);
        diagram.excitations.push(excitation);
        let before = self.last.clone();
        let expected: Vec<Mode> = before
            .iter()
            .zip(&diagram.tracks)
            .map(|(mode, track)| expected(diagram, mode, track))
            .collect();
        let fresh: Vec<usize> = (0..before.len())
            .filter(|&track| diagram.tracks[track].last().is_some_and(Option::is_some))
            .collect();
        let tolerance = self.tolerance(diagram);
        let mut partners = modes::followed(&expected, &found.modes, &found.weights, tolerance);
        if spin > 0.0
            && self.loses(&fresh, &expected, &partners, &found)
            && let Some(other) = self.followed_between(line, &fresh, &expected, &found, count, tolerance)
        {
            for (track, partner) in fresh.iter().zip(other) {
                partners[*track] = partner;
            }
        }
        let station = line.station();
        let mut is_taken = vec![false; found.modes.len()];
        for (track, partner) in partners.iter().enumerate() {
            let mode = partner.as_ref().map(|(index, mode)| {
                is_taken[*index] = true;
                self.last[track].clone_from(mode);
                let mode = there(station.scene, &at, mode);
                self.compositions[track] = station.scene.composition(&at, station.state, &mode.shape);
                SeenMode::of(station.scene, &at, station.state, &mode)
            });
            diagram.tracks[track].push(mode);
        }
        let row = diagram.keys.len() - 1;
        for (index, mode) in found.modes.iter().enumerate().filter(|(index, _)| !is_taken[*index]) {
            let mut track = vec![None; row];
            let seen = there(station.scene, &at, mode);
            track.push(Some(SeenMode::of(station.scene, &at, station.state, &seen)));
            diagram.tracks.push(track);
            self.last.push(mode.clone());
            self.compositions
                .push(station.scene.composition(&at, station.state, &seen.shape));
            self.is_shown.push(false);
            partners.push(Some((index, mode.clone())));
        }
        let lowest: Vec<usize> = found.order().into_iter().take(count).collect();
        let is_shown = |index: &usize| lowest.contains(index) || found.grows(*index);
        for (track, partner) in partners.iter().enumerate() {
            self.is_shown[track] |= partner.as_ref().is_some_and(|(index, _)| is_shown(index));
        }
        diagram.is_all &= found.is_all;
        if spin > 0.0 {
            // The highest ones, which the mesh hardly shows, are not asked.
            let tracks = diagram.tracks.iter().zip(&self.is_shown);
            let shown: Vec<SeenMode> = tracks
                .filter(|(_, is_shown)| **is_shown)
                .filter_map(|(track, _)| track[row])
                .collect();
            diagram.is_round &= is_round(&shown);
        }
        // At rest nothing tells the sign of what only turning makes stiff, as hinged blades.
        let is_loose = spin == 0.0 && found.modes.iter().any(|mode| size(mode) == 0.0);
        let was_loose = std::mem::replace(&mut self.is_loose, is_loose);
        if was_loose && spin > 0.0 {
            (self.symmetric, self.whole) = (Known::default(), Known::default());
        }
        let turned = row > 0 && diagram.spins[row - 1] > 0.0;
        let measured = [Some(symmetric), whole].map(|measured| measured.filter(|_| !(is_loose && turned)));
        self.locate(line, diagram, measured, circulated || self.circulates);
        self.cross(line, diagram, &before);
        Ok(())
    }

    /// Leaves in the diagram what is shown.
    pub fn finish(self, diagram: &mut Campbell) {
        let mut numbers = vec![None; self.is_shown.len()];
        let shown = (0..self.is_shown.len()).filter(|&track| self.is_shown[track]);
        for (number, track) in shown.enumerate() {
            numbers[track] = Some(number);
        }
        let shown = |index: &mut usize| {
            let number = numbers[*index];
            *index += 1;
            number.is_some()
        };
        let mut index = 0;
        diagram.tracks.retain(|_| shown(&mut index));
        diagram.compositions = self.compositions;
        index = 0;
        diagram.compositions.retain(|_| shown(&mut index));
        diagram.mesh_errors = self.mesh_errors.into_iter().map(Judged::parts).collect();
        index = 0;
        diagram.mesh_errors.retain(|_| shown(&mut index));
        diagram.crossings.retain_mut(|crossing| {
            let number = numbers[crossing.track];
            crossing.track = number.unwrap_or(0);
            number.is_some()
        });
    }

    /// Judges the meshes by the modes at the last equilibrium. Next to a critical speed every error is large beside the frequency: errors of
    /// several looks are parts of the largest one.
    pub fn judge_meshes(&mut self, line: &mut Line<'_>, diagram: &Campbell) {
        let station = line.station();
        let known = |track: &usize| diagram.tracks[*track].last().is_some_and(Option::is_some);
        let tracks: Vec<usize> = (0..self.last.len()).filter(known).collect();
        let shapes = tracks
            .iter()
            .map(|&track| there(station.scene, &station.at, &self.last[track]));
        let shapes: Vec<Mode> = shapes.collect();
        let errors = modes::mesh_errors(station.scene, &station.at, station.state, &shapes);
        self.mesh_errors.resize(self.last.len(), Judged::default());
        for ((track, errors), shape) in tracks.into_iter().zip(errors).zip(&shapes) {
            self.mesh_errors[track].meet(size(shape), errors);
        }
    }

    /// Distance of eigenvalues within which modes may mix in the last step: of modes that are equal at rest one goes forward
    /// and one backward.
    fn tolerance(&self, diagram: &Campbell) -> f64 {
        match diagram.spins[..] {
            [.., before, after] => 2.0 * (after - before).abs(),
            _ => 0.0,
        }
    }

    /// Whether a mode that is shown, and not one of the last that were looked at, has no partner.
    fn loses(&self, fresh: &[usize], expected: &[Mode], partners: &[Option<(usize, Mode)>], found: &Looked) -> bool {
        let is_inside = |&&track: &&usize| self.is_shown[track] && size(&expected[track]) < INSIDE * found.largest;
        fresh.iter().filter(is_inside).any(|&track| partners[track].is_none())
    }

    /// Partners of the tracks found by way of equilibria between the last two; `None` where that loses modes as well.
    fn followed_between(
        &self,
        line: &mut Line<'_>,
        fresh: &[usize],
        expected: &[Mode],
        found: &Looked,
        count: usize,
        tolerance: f64,
    ) -> Option<Vec<Option<(usize, Mode)>>> {
        let (Some(first), last) = line.last_two() else {
            return None;
        };
        let (first, last) = (first.clone(), last.clone());
        for halvings in 1..=HALVINGS {
            let parts = 1_u32 << halvings;
            let mut guess = first.state.clone();
            // Where each track is: its mode, as long as it is not lost.
            let mut now: Vec<Option<Mode>> = fresh.iter().map(|&track| Some(self.last[track].clone())).collect();
            let part = tolerance / f64::from(parts);
            for step in 1..parts {
                let share = first.share + (last.share - first.share) * f64::from(step) / f64::from(parts);
                let (mut scene, at, state, back) = line.between(share, &guess)?;
                let looked = Looked::at(scene.as_mut(), &at, &state, count).ok()?;
                now = next(&now, &looked, part)
                    .into_iter()
                    .map(|found| found.map(|(_, mode)| mode))
                    .collect();
                guess = back;
            }
            let partners = next(&now, found, part);
            let mut all: Vec<Option<(usize, Mode)>> = vec![None; expected.len()];
            for (&track, partner) in fresh.iter().zip(&partners) {
                all[track].clone_from(partner);
            }
            if !self.loses(fresh, expected, &all, found) {
                return Some(partners);
            }
        }
        None
    }

    /// The critical values in the last step. Where nothing turns the whole stiffness alone tells them.
    fn locate(
        &mut self,
        line: &mut Line<'_>,
        diagram: &mut Campbell,
        [symmetric, whole]: [Option<Measured>; 2],
        circulates: bool,
    ) {
        let turns = diagram.spins.iter().rev().take(2).any(|&spin| spin > 0.0);
        let known = diagram.critical.len();
        let found = self
            .symmetric
            .locate(line, symmetric, directions::turning, turns || !circulates);
        let of_whole = self.whole.locate(line, whole, known::whole, circulates);
        for critical in found {
            let (first, last) = line.last_two();
            let guess = first.unwrap_or(last).state.clone();
            // What comes to rest does so at the value of the whole stiffness.
            let is_moved = of_whole.iter().any(|other| is_beside(&critical, other));
            // Where no force circulates the whole stiffness is the symmetric one.
            let stands = !circulates || !is_moved && stands(line, critical.value, &guess, diagram);
            diagram.standing.push(stands);
            diagram.critical.push(critical);
        }
        for critical in of_whole {
            let before = diagram.critical[..known].iter().zip(&mut diagram.standing);
            for (earlier, stands) in before {
                *stands &= earlier.circulates || !is_beside(earlier, &critical);
            }
            let is_known = |other: &Critical| (other.value - critical.value).abs() <= ALIKE * critical.value.abs();
            if !diagram.critical[known..].iter().any(is_known) {
                diagram.standing.push(true);
                diagram.critical.push(critical);
            }
        }
    }

    /// Crossings with the spin and twice the spin in the last step.
    fn cross(&self, line: &mut Line<'_>, diagram: &mut Campbell, before: &[Mode]) {
        let (Some(first), last) = line.last_two() else {
            return;
        };
        let (first, last) = (first.clone(), last.clone());
        for crossing in crossed(diagram) {
            if !self.is_shown[crossing.track] {
                continue;
            }
            // At rest shapes of equal modes say nothing.
            let row = diagram.keys.len() - 1;
            let ends = [(&self.last[..], row), (before, row - 1)];
            let refined = ends
                .into_iter()
                .find_map(|end| refined(line, crossing, end, [&first, &last], diagram));
            let crossing = refined.unwrap_or(crossing);
            if !is_critical(&crossing, diagram) {
                diagram.crossings.push(crossing);
            }
        }
    }
}

/// Whether a value of the symmetric stiffness is that of the whole one but for damping.
fn is_beside(critical: &Critical, whole: &Critical) -> bool {
    let away = (whole.value - critical.value).abs() / critical.value.abs();
    ALIKE < away && away <= UNDAMPED
}

/// Whether a mode stands still in the reference frame at a critical value, as one does without damping; also where nothing tells it.
fn stands(line: &mut Line<'_>, value: f64, guess: &State, diagram: &Campbell) -> bool {
    let [from, to] = [0.0, 1.0].map(|share| line.key(share));
    let Some((mut scene, at, state, _)) = line.between((value - from) / (to - from), guess) else {
        return true;
    };
    let Ok(looked) = Looked::at(scene.as_mut(), &at, &state, diagram.settings.count) else {
        return true;
    };
    let spin = scene.spin_in(&at);
    let last = diagram.keys.len() - 1;
    let drifts = looked.modes.iter().filter(|mode| size(mode) == 0.0).count();
    let drifts_beside = diagram.row(last).filter(|mode| mode.re.hypot(mode.im) == 0.0).count();
    let is_slow = |mode: &Mode| size(mode) > 0.0 && size(mode) <= UNDAMPED * spin;
    spin == 0.0 || drifts > drifts_beside || looked.modes.iter().any(is_slow)
}

/// Whether a crossing in the last step is a critical speed, which is known already: that of an undamped forward whirl with the spin is one. With damping the
/// stiffness in the reference frame vanishes elsewhere.
fn is_critical(crossing: &Crossing, diagram: &Campbell) -> bool {
    let last = diagram.keys.len() - 1;
    let is_damped = |row: usize| {
        let mode = diagram.tracks[crossing.track][row];
        mode.is_some_and(|mode| mode.re.abs() > UNDAMPED * diagram.spins[row])
    };
    let is_known = |value: f64| (value - crossing.key).abs() <= crossing.within.max(ALIKE * value.abs());
    crossing.whirl == Whirl::Forward
        && crossing.order == 1
        && !(last - 1..=last).any(is_damped)
        && diagram.critical.iter().any(|critical| is_known(critical.value))
}

/// Partners of what is not lost.
fn next(now: &[Option<Mode>], looked: &Looked, tolerance: f64) -> Vec<Option<(usize, Mode)>> {
    let kept: Vec<Mode> = now.iter().flatten().cloned().collect();
    let mut found = modes::followed(&kept, &looked.modes, &looked.weights, tolerance).into_iter();
    now.iter()
        .map(|mode| mode.as_ref().and_then(|_| found.next().flatten()))
        .collect()
}

/// The last mode of a track as it is expected next: its frequency on the secant, conjugate where that
/// passes zero.
fn expected(diagram: &Campbell, mode: &Mode, track: &[Option<SeenMode>]) -> Mode {
    // The keys have the next value already.
    let [.., first, second, next] = diagram.keys[..] else {
        return mode.clone();
    };
    let [.., Some(before), Some(last)] = track else {
        return mode.clone();
    };
    let im = last.im + (last.im - before.im) * (next - second) / (second - first);
    let mut expected = if im < 0.0 { mode.conjugate() } else { mode.clone() };
    expected.im = im.abs();
    expected
}

/// A frequency that is compared with multiples of what excites, and the sense of its whirl as of [`Crossing`].
fn compared(mode: SeenMode, spin: f64) -> (f64, Whirl) {
    match mode.inertial(spin) {
        Inertial::One(im) => (im, Whirl::None),
        Inertial::Whirl(velocity) => (velocity.abs(), mode.inertial_whirl(spin)),
        Inertial::Two(_) => (mode.im, Whirl::Mixed),
    }
}

/// How far a frequency is from a multiple: the free tilt of what nothing holds has that of the spin itself.
fn apart(im: f64, multiple: f64) -> f64 {
    if (im - multiple).abs() <= SAME * multiple {
        return 0.0;
    }
    im - multiple
}

/// Crossings with what excites and twice that in the last step, on straight lines.
fn crossed(diagram: &Campbell) -> Vec<Crossing> {
    let mut found = Vec::new();
    let Some(row) = diagram.keys.len().checked_sub(2) else {
        return found;
    };
    let spins = [diagram.spins[row], diagram.spins[row + 1]];
    let excitations = [diagram.excitations[row], diagram.excitations[row + 1]];
    if excitations == [0.0; 2] {
        return found;
    }
    let keys = [diagram.keys[row], diagram.keys[row + 1]];
    for (index, track) in diagram.tracks.iter().enumerate() {
        let (Some(before), Some(after)) = (track[row], track[row + 1]) else {
            continue;
        };
        let [mut first, mut last] = [compared(before, spins[0]), compared(after, spins[1])];
        // At rest nothing whirls.
        if spins[0] == 0.0 {
            first.1 = last.1;
        }
        if spins[1] == 0.0 {
            last.1 = first.1;
        }
        if first.1 != last.1 {
            continue;
        }
        for order in [1, 2] {
            let ends = [(first.0, excitations[0]), (last.0, excitations[1])];
            let [low, high] = ends.map(|(im, excitation)| apart(im, f64::from(order) * excitation));
            if low != 0.0 && low * high <= 0.0 {
                let share = low / (low - high);
                found.push(Crossing {
                    track: index,
                    order,
                    whirl: first.1,
                    key: keys[0] + share * (keys[1] - keys[0]),
                    within: (keys[1] - keys[0]).abs() * share.max(1.0 - share),
                    im: first.0 + share * (last.0 - first.0),
                });
            }
        }
    }
    found
}

/// The same crossing from equilibria between the steps, by the modes of all tracks at a row: shapes of overdamped ones are like those of others. `None`
/// where it is not found nearer than on a straight line.
fn refined(
    line: &mut Line<'_>,
    crossing: Crossing,
    (modes, known): (&[Mode], usize),
    [first, last]: [&Found; 2],
    diagram: &Campbell,
) -> Option<Crossing> {
    let is_known = |index: &usize| diagram.tracks[*index][known].is_some();
    let tracks: Vec<usize> = (0..modes.len()).filter(is_known).collect();
    let shapes: Vec<Mode> = tracks.iter().map(|&index| modes[index].clone()).collect();
    let own = tracks.iter().position(|&index| index == crossing.track)?;
    let row = diagram.keys.len() - 2;
    let track = &diagram.tracks[crossing.track];
    let order = f64::from(crossing.order);
    let end = |row: usize| {
        let (spin, excitation) = (diagram.spins[row], diagram.excitations[row]);
        track[row].map(|mode| compared(mode, spin).0 - order * excitation)
    };
    let (mut low, mut high) = ((first.share, end(row)?), (last.share, end(row + 1)?));
    let slope = (high.1 - low.1) / (high.0 - low.0);
    let rates = [track[row]?.re, track[row + 1]?.re];
    let mut place = (f64::NAN, 0.0, 0.0);
    let mut rate = None;
    let mut kept = 0;
    for _ in 0..LOOKS {
        let share = low.0 + low.1 / (low.1 - high.1) * (high.0 - low.0);
        let (mut scene, at, state, _) = line.between(share, &first.state)?;
        let looked = Looked::at(scene.as_mut(), &at, &state, diagram.settings.count).ok()?;
        let spin = scene.spin_in(&at);
        let excitation = line.excitation(share, spin);
        let is_with_spin = crossing.order == 1 && crossing.whirl == Whirl::Forward;
        let part = (share - first.share) / (last.share - first.share);
        let expected = rate.unwrap_or(rates[0] + part * (rates[1] - rates[0]));
        if let Some(off) = standing(&looked, expected, spin).filter(|_| is_with_spin) {
            place = (share, spin, (off / slope).abs());
            break;
        }
        let followed = modes::followed(&shapes, &looked.modes, &looked.weights, 0.0);
        let (_, best) = followed.into_iter().nth(own).flatten()?;
        let best = there(scene.as_mut(), &at, &best);
        let (im, whirl) = compared(SeenMode::of(scene.as_mut(), &at, &state, &best), spin);
        if whirl != crossing.whirl {
            return None;
        }
        let value = im - order * excitation;
        rate = Some(best.re);
        place = (share, im, (value / slope).abs());
        if place.2 <= WIDTH {
            break;
        }
        // Regula falsi; an end that stays twice is weighted less.
        if (value > 0.0) == (low.1 > 0.0) {
            low = (share, value);
            high.1 *= if kept == 1 { 0.5 } else { 1.0 };
            kept = 1;
        } else {
            high = (share, value);
            low.1 *= if kept == -1 { 0.5 } else { 1.0 };
            kept = -1;
        }
    }
    let key = line.key(place.0);
    let within = (line.key(place.0 + 2.0 * place.2) - key).abs();
    (within < crossing.within).then_some(Crossing {
        key,
        im: place.1,
        within,
        ..crossing
    })
}

/// Whether a mode stands still in the reference frame, whirling with the spin, and by how much its rate differs from the expected one, 1/s. There its pair of
/// eigenvalues may be two real ones, with shapes of their own.
fn standing(looked: &Looked, expected: f64, spin: f64) -> Option<f64> {
    let still = looked.modes.iter().filter(|mode| mode.im <= WIDTH * spin);
    let off = still.map(|mode| (mode.re - expected).abs()).reduce(f64::min);
    off.filter(|off| *off <= NEAR * spin)
}
