//! Whether a run will come to its end. The work that is left is extrapolated from how far each doubling of the number of
//! steps has come: at constant steps each doubling comes twice as far as the one before; where a motion grows
//! exponentially and its frequency with it, each comes as far as the one before, and `ln(steps)` is all that time grows
//! with. A transient shows in one or two doublings, and the watch needs several.
//!
//! Steps also fall where a motion gathers in a small part of a model, as in the tip of a whip. There they cannot fall for ever: what energy there is bounds
//! every speed. So a motion grows only where its kinetic energy does.

use crate::archive::{Archive, Keep};

/// The first doubling ends with this step.
const FIRST: u64 = 512;
/// Doublings over which progress is averaged: from 16 times fewer steps than now.
const AVERAGED: usize = 4;
/// Averages in a row that must say the same.
const AGREEING: u64 = 3;
/// Steps that nobody waits for; a fixed step has the same limit.
const MOST: f64 = 1e9;
/// A motion grows where doubling the steps comes at most this much farther: a spin-up at constant torque, whose steps
/// shrink too, comes 1.41 times as far.
const STALLED: f64 = 1.3;
/// Growth of the kinetic energy over the averaged doublings that counts.
const GROWTH: f64 = 4.0;
/// Looks at the energy in each doubling: it goes up and down. In the first one, which nothing is compared with, there are none: each costs a mass matrix.
const LOOKS: u64 = 32;
/// Part of the energy that steps gain or lose by their errors.
const DRIFT: f64 = 1e-6;

/// Where a doubling of the number of steps ended.
#[derive(Clone, Copy, Debug, Default)]
struct Mark {
    /// Time, s.
    t: f64,
    /// Largest kinetic energy within the doubling, J.
    energy: f64,
}

/// Why a run will not come to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Trouble {
    /// The kinetic energy has grown by this factor over so many steps.
    Grows { factor: f64, steps: u64 },
    /// So many steps are left.
    Endless { left: f64 },
}

/// Looks at the accepted steps of adaptive runs.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    steps: u64,
    /// Step at which the present doubling ends.
    next: u64,
    marks: Vec<Mark>,
    /// Largest kinetic energy in the present doubling, J.
    most: f64,
    /// Least in the run, J: what flies or turns evenly keeps that.
    least: f64,
    growing: u64,
    endless: u64,
}

impl Keep for Mark {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { t, energy } = self;
        t.keep(archive);
        energy.keep(archive);
    }
}

impl Keep for Watch {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            steps,
            next,
            marks,
            most,
            least,
            growing,
            endless,
        } = self;
        steps.keep(archive);
        next.keep(archive);
        marks.keep(archive);
        most.keep(archive);
        least.keep(archive);
        growing.keep(archive);
        endless.keep(archive);
    }
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            steps: 0,
            next: FIRST,
            marks: Vec::new(),
            most: f64::NEG_INFINITY,
            least: f64::INFINITY,
            growing: 0,
            endless: 0,
        }
    }
}

impl Watch {
    /// Looks at an accepted step that ended at `t` (s) with `left` (s) to the end of the run; its kinetic energy (J) is asked for at times.
    pub(super) fn accepted(&mut self, t: f64, left: f64, energy: impl FnOnce() -> f64) -> Option<Trouble> {
        self.steps += 1;
        if self.steps > FIRST && self.steps.is_multiple_of(self.next / (2 * LOOKS)) {
            let energy = energy();
            self.most = self.most.max(energy);
            self.least = self.least.min(energy);
        }
        if self.steps < self.next {
            return None;
        }
        self.next *= 2;
        self.marks.push(Mark { t, energy: self.most });
        self.most = f64::NEG_INFINITY;
        let first = self.marks.len().checked_sub(AVERAGED + 2)?;
        let marks = &self.marks[first..];
        let come = |at: usize| marks[at + 1].t - marks[at].t;
        let (before, now) = (come(0), come(AVERAGED));
        let progress = (now / before).powf(1.0 / AVERAGED as f64);
        let gained = |mark: Mark| mark.energy - self.least;
        let factor = gained(marks[AVERAGED + 1]) / gained(marks[1]).max(DRIFT * marks[AVERAGED + 1].energy);
        let left_at = |progress: f64| steps_left(self.steps as f64, left / now, progress);
        let grows = progress < STALLED && factor > GROWTH && left_at(progress) > MOST;
        // At the best of the last doublings, and not worse from now on.
        let best = (0..=AVERAGED).map(|at| come(at) / (1_u64 << at) as f64);
        let best = best.fold(0.0, f64::max) * f64::from(1 << AVERAGED);
        let constant = steps_left(self.steps as f64, left / best, progress.max(2.0));
        let count = |given: u64, holds: bool| if holds { given + 1 } else { 0 };
        self.growing = count(self.growing, grows);
        self.endless = count(self.endless, constant > MOST);
        if self.growing >= AGREEING {
            let steps = self.steps - (self.steps >> AVERAGED);
            Some(Trouble::Grows { factor, steps })
        } else if self.endless >= AGREEING {
            Some(Trouble::Endless { left: constant })
        } else {
            None
        }
    }
}

/// Steps that are left where the last doubling of `steps` came one part of `left` far, and every further one comes
/// `progress` times as far as the one before.
fn steps_left(steps: f64, left: f64, progress: f64) -> f64 {
    let doublings = if (progress - 1.0).abs() < 1e-3 {
        left
    } else {
        let sum = 1.0 + left * (progress - 1.0) / progress;
        // The geometric sum does not reach the end.
        if sum <= 0.0 {
            return f64::INFINITY;
        }
        sum.ln() / progress.ln()
    };
    steps * (doublings.exp2() - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// When a run of `end` (s) is stopped: step and speed of 2 kg from time, until so many steps.
    fn run(end: f64, most: u64, step: impl Fn(f64) -> f64, speed: impl Fn(f64) -> f64) -> Option<(u64, Trouble)> {
        let (mut watch, mut t) = (Watch::default(), 0.0);
        for at in 1..=most {
            t += step(t);
            if t > end {
                return None;
            }
            if let Some(trouble) = watch.accepted(t, end - t, || speed(t).powi(2)) {
                return Some((at, trouble));
            }
        }
        None
    }

    #[test]
    fn steps_that_are_left_at_constant_and_at_shrinking_steps() {
        // 1000 steps so far, half of them in the last doubling: 8 times its way are 4000 steps.
        assert!((steps_left(1000.0, 8.0, 2.0) - 4000.0).abs() < 1e-6);
        assert!((steps_left(1000.0, 10.0, 1.0) / 1e6 - 1.023).abs() < 1e-6);
        assert_eq!(steps_left(1000.0, 10.0, 0.5), f64::INFINITY);
    }

    #[test]
    fn growing_motions_and_endless_runs_are_stopped() {
        // Amplitude and frequency grow with exp(50 t): 10 s would be exp(500) steps.
        let (at, trouble) = run(10.0, 100_000, |t| 1e-3 * (-50.0 * t).exp(), |t| (50.0 * t).exp()).unwrap();
        assert!(
            at == 65_536 && matches!(trouble, Trouble::Grows { factor, .. } if factor > 10.0),
            "{at} {trouble:?}"
        );
        // The same beside what flies at 7 km/s, of the same mass.
        let beside = |t: f64| 7000.0_f64.hypot((50.0 * t).exp());
        let (at, trouble) = run(10.0, 300_000, |t| 1e-3 * (-50.0 * t).exp(), beside).unwrap();
        assert!(
            at <= 131_072 && matches!(trouble, Trouble::Grows { factor, .. } if factor > 10.0),
            "{at} {trouble:?}"
        );
        let (at, trouble) = run(1.0, 100_000, |_| 1e-10, |_| 1.0).unwrap();
        assert!(
            at == 65_536 && matches!(trouble, Trouble::Endless { left } if (left / 1e10 - 1.0).abs() < 1e-3),
            "{at} {trouble:?}"
        );
    }

    #[test]
    fn runs_that_end_are_not_stopped() {
        // 10^8 equal steps, of which 10^6 are done here; a spin-up at constant torque that would take 2 10^7.
        assert_eq!(run(1.0, 1_000_000, |_| 1e-8, |_| 1.0), None);
        assert_eq!(run(1000.0, 1_000_000, |t| 0.1 / (1.0 + 10.0 * t), |t| t), None);
        // Flutter that grows from noise into a cycle: a step of order 5 falls with the sixth root of the amplitude.
        let cycle = |t: f64| (1e-9 * (5.0 * t).exp()).min(1.0);
        assert_eq!(run(100.0, 1_000_000, |t| 1e-6 * cycle(t).powf(-1.0 / 6.0), cycle), None);
        // A cycle that is thirty times as fast as its beginning.
        let cycle = |t: f64| (5.0 * t).exp().min(30.0);
        assert_eq!(run(1000.0, 1_000_000, |t| 1e-3 / cycle(t), cycle), None);
        // A blow whose waves die away: steps from 1e-10 s of 100 s back to 1e-2 s.
        assert_eq!(
            run(100.0, 1_000_000, |t| (1e-10 + 0.1 * t).min(1e-2), |t| 1.0 / (1e-9 + t)),
            None
        );
        // A whip: one place becomes quicker and quicker, while the energy swings between two bounds, or stays but for the errors of steps.
        let whip = |t: f64| 1e-3 * (-2.0 * t).exp();
        assert_eq!(run(1000.0, 1_000_000, whip, |t| 3.0 * (2.0 * t).sin()), None);
        assert_eq!(run(1000.0, 1_000_000, whip, |t| 3.0 + 1e-9 * t.exp().sin()), None);
        // Steps that fluctuate by a factor of 30 at random, as in chaos, with growing peaks of speed.
        let wild = |t: f64| (1e4 * t).sin().abs().max(0.03);
        assert_eq!(run(10.0, 1_000_000, |t| 1e-5 * wild(t), |t| 1.0 + t), None);
    }
}
