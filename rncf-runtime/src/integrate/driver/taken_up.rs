//! The driver writes what it must know, forgets the rest, and goes on from what it wrote.

use super::{Driver, scheme_of};
use crate::archive::{Archive, Keep};
use crate::error::{SolveError, SolveErrorKind};
use crate::integrate::bordered::Bordered;
use crate::integrate::method::Method;
use crate::integrate::options::Options;
use crate::integrate::renewal::Renewal;
use crate::integrate::segments::Segments;
use crate::integrate::statistics::Statistics;
use crate::integrate::switches::Switches;
use crate::integrate::watch::Watch;
use crate::system::System;

impl Driver {
    /// See [`Integrator::resume`](crate::integrate::Integrator::resume).
    pub(in crate::integrate) fn resume(
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
            sight: None,
            strays: None,
            wanted: 0.0,
            at_kink: false,
            at_corner: false,
            met: Vec::new(),
            awaited: Vec::new(),
            previous_time: 0.0,
            longest: 0.0,
            has_left: false,
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
    pub(in crate::integrate) fn renew(&mut self, system: &mut dyn System) {
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
            sight,
            strays,
            bordered,
            wanted,
            at_kink,
            at_corner,
            met,
            awaited,
            previous_time,
            longest,
            has_left,
            statistics,
            watch,
            violations: _,
            renewal: _,
        } = self;
        segments.keep(archive);
        wanted.keep(archive);
        at_kink.keep(archive);
        at_corner.keep(archive);
        met.keep(archive);
        awaited.keep(archive);
        previous_time.keep(archive);
        longest.keep(archive);
        has_left.keep(archive);
        statistics.keep(archive);
        watch.keep(archive);
        if archive.is_reading() {
            (*sight, *strays) = (None, None);
            *bordered = Bordered::new(system);
            *scheme = scheme_of(system, *method, options, segments.span());
        }
        scheme.keep(archive);
    }
}
