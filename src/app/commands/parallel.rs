//! Tasks on all cores, and a single run with its limit.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::AnyModel;
use crate::app::machine::clock::{Clock, thread_cpu_time};
use crate::app::results::error::RunError;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::run::{RunResult, RunSettings};
use crate::app::runs::run::run_watched;

/// How often Ctrl-C is looked for, and the clock of a run.
const PAUSE: Duration = Duration::from_millis(20);
/// Large scenes work on other threads: a run is charged at least its process's time over so many times the cores, which
/// does not exceed its own time where each core has a run of its own.
const SHARE: f64 = 2.0;

/// What became of a run.
pub(in crate::app) enum Ended {
    Complete(Box<RunResult>),
    Failed(String),
    TooLong,
    Interrupted,
}

/// Ends work from within: where the program is to stop, and where it has used up its processor time.
pub(in crate::app) struct Watch<'s> {
    /// Processor seconds of this thread.
    limit: f64,
    stop: &'s AtomicBool,
    clock: Clock,
    own: Option<Duration>,
    seen: Instant,
    is_interrupted: bool,
    is_too_long: bool,
}

impl<'s> Watch<'s> {
    /// Begins now.
    pub fn new(limit: f64, stop: &'s AtomicBool) -> Self {
        Self {
            limit,
            stop,
            clock: Clock::start(),
            own: thread_cpu_time(),
            seen: Instant::now(),
            is_interrupted: stop.load(Ordering::Relaxed),
            is_too_long: false,
        }
    }

    /// To be called after every step.
    pub fn look(&mut self) -> ControlFlow<()> {
        self.is_interrupted |= self.stop.load(Ordering::Relaxed);
        if self.is_interrupted {
            return ControlFlow::Break(());
        }
        if self.seen.elapsed() < PAUSE {
            return ControlFlow::Continue(());
        }
        self.seen = Instant::now();
        let all = self.clock.seconds().cpu;
        let used = match (self.own, thread_cpu_time()) {
            (Some(start), Some(now)) => now.saturating_sub(start).as_secs_f64().max(all / (SHARE * cores())),
            _ => all,
        };
        self.is_too_long = used > self.limit;
        if self.is_too_long {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Whether the program was to stop at the last look.
    pub fn is_interrupted(&self) -> bool {
        self.is_interrupted
    }

    /// Whether the time was used up at the last look.
    pub fn is_too_long(&self) -> bool {
        self.is_too_long
    }
}

/// Runs a model; `limit` in processor seconds of this thread.
pub(in crate::app) fn solve(model: &dyn AnyModel, settings: &RunSettings, limit: f64, stop: &AtomicBool) -> Ended {
    let mut watch = Watch::new(limit, stop);
    if watch.is_interrupted() {
        return Ended::Interrupted;
    }
    match run_watched(model, settings, |_| watch.look()) {
        Ok(result) => Ended::Complete(Box::new(result)),
        Err(RunError::Incomplete(result)) if result.incomplete == Some(Incomplete::Interrupted) => {
            if watch.is_too_long() {
                Ended::TooLong
            } else {
                Ended::Interrupted
            }
        }
        Err(error) => Ended::Failed(error.to_string()),
    }
}

fn cores() -> f64 {
    thread::available_parallelism().map_or(1.0, |cores| cores.get() as f64)
}

/// Works on tasks on all cores. In this thread `done` gets every result, which may bring the next task, and
/// `interrupted` is asked some fifty times a second: where it is true, the flag that `work` sees is set, and no task is
/// begun any more.
///
/// # Errors
/// That of `done`, after which no task is begun any more.
pub(in crate::app) fn on_all_cores<T: Send, R: Send>(
    tasks: Vec<T>,
    interrupted: impl Fn() -> bool,
    work: impl Fn(&T, &AtomicBool) -> R + Sync,
    mut done: impl FnMut(T, R) -> Result<Option<T>, String>,
) -> Result<(), String> {
    let cores = cores() as usize;
    let stop = AtomicBool::new(false);
    let mut failure = Ok(());
    thread::scope(|scope| {
        let (to_do, waiting) = channel::<T>();
        let (results, finished) = channel::<(T, R)>();
        let waiting = std::sync::Arc::new(Mutex::new(waiting));
        let workers: Vec<_> = (0..cores.min(tasks.len()))
            .map(|_| {
                let (waiting, results) = (waiting.clone(), results.clone());
                let (work, stop) = (&work, &stop);
                scope.spawn(move || {
                    loop {
                        let next = waiting.lock().unwrap_or_else(PoisonError::into_inner).recv();
                        let Ok(task) = next else { break };
                        let result = work(&task, stop);
                        if results.send((task, result)).is_err() {
                            break;
                        }
                    }
                })
            })
            .collect();
        drop((results, waiting));
        let mut outstanding = tasks.len();
        for task in tasks {
            // A worker that is gone has panicked, which the end of the scope tells.
            let _ = to_do.send(task);
        }
        while outstanding > 0 {
            if interrupted() {
                stop.store(true, Ordering::Relaxed);
            }
            match finished.recv_timeout(PAUSE) {
                Ok((task, result)) => {
                    outstanding -= 1;
                    match done(task, result) {
                        Ok(Some(next)) if !stop.load(Ordering::Relaxed) => {
                            outstanding += 1;
                            let _ = to_do.send(next);
                        }
                        Ok(_) => {}
                        Err(text) => {
                            stop.store(true, Ordering::Relaxed);
                            failure = Err(text);
                        }
                    }
                }
                Err(RecvTimeoutError::Timeout) if workers.iter().any(|worker| worker.is_finished()) => break,
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        drop(to_do);
    });
    failure
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::app::testing::Rotor;

    #[test]
    fn every_task_is_done_once_and_may_bring_the_next() {
        let mut sum = 0;
        let found = on_all_cores(
            vec![1_u32, 2, 3, 4, 5],
            || false,
            |task, _| task * 10,
            |task, result| {
                assert_eq!(result, task * 10);
                sum += result;
                Ok((task < 3).then_some(task + 100))
            },
        );
        assert_eq!((found, sum), (Ok(()), 150 + 1010 + 1020));
        assert_eq!(
            on_all_cores(Vec::<u32>::new(), || false, |_, _| (), |_, ()| Ok(None)),
            Ok(())
        );
    }

    #[test]
    fn an_interruption_and_a_failure_end_the_work() {
        let (asked, count) = (Cell::new(0), Cell::new(0));
        let forever = |task, ()| {
            count.set(count.get() + 1);
            Ok(Some(task))
        };
        let interrupted = || {
            asked.set(asked.get() + 1);
            asked.get() > 10
        };
        assert_eq!(on_all_cores(vec![1, 2], interrupted, |_, _| (), forever), Ok(()));
        assert!(count.get() >= 2);
        let failing = |_, ()| Err("full".into());
        assert_eq!(
            on_all_cores(vec![1, 2], || false, |_, _| (), failing),
            Err("full".into())
        );
    }

    #[test]
    fn a_run_ends_at_its_limit_by_interruption_or_by_failure() {
        let stop = AtomicBool::new(false);
        let settings = RunSettings {
            t_end: Some(1e6),
            every: Some(1e6),
            ..RunSettings::default()
        };
        let rotor = Rotor {
            loss: 0.0,
            fail_at: f64::INFINITY,
            ..Rotor::default()
        };
        let ended = solve(&rotor, &settings, 0.05, &stop);
        assert!(matches!(ended, Ended::TooLong));
        let failing = Rotor {
            fail_at: 1.0,
            ..Rotor::default()
        };
        assert!(matches!(solve(&failing, &settings, 10.0, &stop), Ended::Failed(text) if text.contains(" t = ")));
        stop.store(true, Ordering::Relaxed);
        assert!(matches!(solve(&rotor, &settings, 10.0, &stop), Ended::Interrupted));
    }
}
