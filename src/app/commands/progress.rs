//! Progress on standard error: time reached, step size, time to go.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::app::equilibria::continuation::EquilibriumProgress;
use crate::app::results::run::Progress;
use crate::app::writing::numbers::digits;

/// A bar, or nothing where nobody looks at a terminal.
pub(in crate::app) struct Bar {
    bar: ProgressBar,
    drawn: Instant,
}

const PARTS: u64 = 10_000;
const PAUSE: Duration = Duration::from_millis(50);
const TEMPLATE: &str = "{bar:32} {msg}  {eta} to go";

impl Bar {
    pub fn new(quiet: bool) -> Self {
        let bar = if quiet || !std::io::stderr().is_terminal() {
            ProgressBar::hidden()
        } else {
            ProgressBar::new(PARTS)
        };
        if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
            bar.set_style(style);
        }
        Self {
            bar,
            drawn: Instant::now(),
        }
    }

    /// Shows the step; at most some twenty times a second.
    pub fn show(&mut self, progress: &Progress) {
        if self.bar.is_hidden() || self.drawn.elapsed() < PAUSE {
            return;
        }
        self.drawn = Instant::now();
        let share = (progress.t / progress.t_end).clamp(0.0, 1.0);
        self.bar.set_position((share * PARTS as f64) as u64);
        let Progress { t, t_end, h } = progress;
        self.bar.set_message(format!("t = {t:.3}/{t_end} s  h = {h:.2e} s"));
    }

    /// Shows the step of a continuation by the value of its first column.
    pub fn show_equilibrium(&mut self, progress: &EquilibriumProgress) {
        if self.bar.is_hidden() || self.drawn.elapsed() < PAUSE {
            return;
        }
        self.drawn = Instant::now();
        self.bar.set_position((progress.share * PARTS as f64) as u64);
        self.bar.set_message(digits(progress.key, 5));
    }

    /// Shows which part of something is done.
    pub fn show_share(&mut self, share: f64, what: &str) {
        if self.bar.is_hidden() || self.drawn.elapsed() < PAUSE {
            return;
        }
        self.drawn = Instant::now();
        self.bar.set_position((share * PARTS as f64) as u64);
        self.bar.set_message(what.to_owned());
    }

    /// Takes the bar away; the summary follows in its place.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
