//! Processor and wall time of a run.

use std::time::{Duration, Instant};

use crate::archive::{Archive, Keep};

/// Started at the beginning of a run.
pub(in crate::app) struct Clock {
    wall: Instant,
    cpu: Option<Duration>,
}

/// Seconds that a run took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds {
    /// Processor time of the whole process, all threads; wall time where the system tells no more.
    pub cpu: f64,
    /// Time on the wall.
    pub wall: f64,
    /// Whether `cpu` is processor time.
    pub cpu_is_measured: bool,
}

impl Keep for Seconds {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            cpu,
            wall,
            cpu_is_measured,
        } = self;
        cpu.keep(archive);
        wall.keep(archive);
        cpu_is_measured.keep(archive);
    }
}

impl Seconds {
    /// These and further seconds.
    pub(in crate::app) fn and(self, further: Seconds) -> Self {
        Self {
            cpu: self.cpu + further.cpu,
            wall: self.wall + further.wall,
            cpu_is_measured: further.cpu_is_measured,
        }
    }
}

impl Clock {
    pub fn start() -> Self {
        Self {
            wall: Instant::now(),
            cpu: cpu_time(),
        }
    }

    /// Seconds since the start.
    pub fn seconds(&self) -> Seconds {
        let wall = self.wall.elapsed().as_secs_f64();
        let cpu = self
            .cpu
            .zip(cpu_time())
            .map(|(start, end)| (end.saturating_sub(start)).as_secs_f64());
        Seconds {
            cpu: cpu.unwrap_or(wall),
            wall,
            cpu_is_measured: cpu.is_some(),
        }
    }
}

#[cfg(unix)]
fn cpu_time() -> Option<Duration> {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_PROCESS_CPUTIME_ID)
        .ok()
        .map(Duration::from)
}

/// Processor time of the calling thread alone; `None` where the system does not tell.
#[cfg(unix)]
pub(in crate::app) fn thread_cpu_time() -> Option<Duration> {
    use nix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::CLOCK_THREAD_CPUTIME_ID).ok().map(Duration::from)
}

#[cfg(not(unix))]
pub(in crate::app) fn thread_cpu_time() -> Option<Duration> {
    None
}

#[cfg(not(unix))]
fn cpu_time() -> Option<Duration> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn sleep_costs_wall_time_but_no_processor_time() {
        // Other tests of this process run meanwhile, so only a lower bound holds for the processor.
        let clock = Clock::start();
        std::thread::sleep(Duration::from_millis(20));
        let mut sum = 0.0_f64;
        while clock.seconds().cpu < 1e-3 {
            sum += sum.sin() + 1.0;
        }
        let seconds = clock.seconds();
        assert!(
            seconds.cpu_is_measured && seconds.cpu >= 1e-3 && seconds.wall >= 0.02,
            "{seconds:?} {sum}"
        );
    }
}
