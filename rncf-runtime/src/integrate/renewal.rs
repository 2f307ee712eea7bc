//! Renewal: from time to time an integration forgets all that it could find again, and goes on from what it must know.
//!
//! Matrices, factorizations and what was seen of them are kept from step to step, and the last bits of a result depend on when
//! they were made. They are not worth storing. A renewal writes what must be known to bytes, makes the method anew and reads
//! the bytes, just as a run does that is taken up later from them: so both go on with the same bits, whatever the method
//! remembers. When a renewal is due is counted, not timed.

use super::bordered::Bordered;
use super::driver::{Driver, scheme_of};
use super::segments::Segments;
use super::switches::Switches;
use super::watch::Watch;
use super::{Method, Options, Statistics};
use crate::archive::{Archive, Keep};
use crate::error::{SolveError, SolveErrorKind};
use crate::system::System;

/// When the next renewal is due, and what the last one knew.
pub(super) struct Renewal {
    /// Evaluations of the residual from one to the next.
    after: u64,
    /// Evaluations at the last one.
    last: u64,
    /// What was known at the last one; empty before the first.
    known: Vec<u8>,
}

impl Renewal {
    /// A renewal after every so many evaluations of the residual.
    pub(super) fn new(after: u64) -> Self {
        Self {
            after,
            last: 0,
            known: Vec::new(),
        }
    }

    /// What was known at the last one; `None` before the first.
    pub(super) fn known(&self) -> Option<&[u8]> {
        (!self.known.is_empty()).then_some(&self.known)
    }

    /// Whether the time has come; to be asked after a step.
    pub(super) fn is_due(&self, statistics: &Statistics) -> bool {
        statistics.residual_evaluations - self.last >= self.after
    }
}

impl Driver {
    /// See [`super::Integrator::resume`].
    pub(super) fn resume(
        system: &mut dyn System,
        renewed: &[u8],
        method: Method,
        options: Options,
    ) -> Result<Self, SolveError> {
        let options = Options {
            rtol: options.local_tolerance(method),
            ..options
        };
        let mut driver = Self {
            bordered: Bordered::new(system),
            // The span comes with the segments.
            scheme: scheme_of(system, method, &options, 0.0),
            renewal: Renewal::new(options.renewal(system.unknowns())),
            violations: vec![0.0; system.constraints()],
            method,
            options,
            segments: Segments::new(0.0, 0.0, &[]),
            switches: Switches::default(),
            wanted: 0.0,
            at_kink: false,
            previous_time: 0.0,
            statistics: Statistics::default(),
            watch: Watch::default(),
        };
        driver.renewal.known = renewed.to_vec();
        driver.take_up(system).map_err(|kind| SolveError {
            kind,
            t: 0.0,
            h: 0.0,
            worst: None,
        })?;
        Ok(driver)
    }

    /// Forgets what can be found again.
    pub(super) fn renew(&mut self, system: &mut dyn System) {
        let mut known = std::mem::take(&mut self.renewal.known);
        known.clear();
        self.keep(system, &mut Archive::writing(&mut known));
        self.renewal.known = known;
        let taken_up = self.take_up(system);
        assert!(taken_up.is_ok(), "what this writes it reads");
    }

    /// Makes method and matrices anew, and goes on from what was known at the last renewal.
    fn take_up(&mut self, system: &mut dyn System) -> Result<(), SolveErrorKind> {
        let known = std::mem::take(&mut self.renewal.known);
        let mut archive = Archive::reading(&known);
        self.keep(system, &mut archive);
        let read = archive.end();
        self.renewal.known = known;
        self.renewal.last = self.statistics.residual_evaluations;
        read.map_err(|_| SolveErrorKind::Setting("it was not this system or method that ran so far".into()))?;
        self.scheme.take_up(system);
        Ok(())
    }

    /// Writes what must be known, or reads it into matrices and a method that are made anew.
    fn keep(&mut self, system: &mut dyn System, archive: &mut Archive<'_>) {
        let Self {
            method,
            scheme,
            options,
            segments,
            switches: _,
            bordered,
            wanted,
            at_kink,
            previous_time,
            statistics,
            watch,
            violations: _,
            renewal: _,
        } = self;
        segments.keep(archive);
        wanted.keep(archive);
        at_kink.keep(archive);
        previous_time.keep(archive);
        statistics.keep(archive);
        watch.keep(archive);
        if archive.is_reading() {
            *bordered = Bordered::new(system);
            *scheme = scheme_of(system, *method, options, segments.span());
        }
        scheme.keep(archive);
    }
}
