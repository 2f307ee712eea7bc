//! What a run gathers on its way: rows and what is read off them, the energy, the steps. All of it can be written down at any
//! time, with what the integrator knew at its last renewal, and taken up later: the steps since then are repeated, which
//! gives the same bits, and are not gathered twice.

use super::recorder::{Earlier, Recorder};
use crate::app::judged::cautions;
use crate::app::judged::coarse::Coarseness;
use crate::app::judged::finer::Judging;
use crate::app::judged::marks::Marks;
use crate::app::machine::clock::{Clock, Seconds};
use crate::app::pictures::Pictures;
use crate::app::results::history::SKETCHED;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::run::{RowTimes, RunResult, StepTaken};
use crate::app::results::sketch::Sketch;
use crate::archive::{Archive, Keep};
use crate::{Integrator, Scene, State, Warning};

/// Rows at which it is looked at what outputs are made of.
const OPERANDS: u64 = 32;

type Running<'s> = Integrator<'s, dyn Scene + 's>;

/// What a run has gathered beside its result.
pub(in crate::app) struct Course {
    rows: Rows,
    energy: EnergyDrift,
    steps: Steps,
    /// Accepted steps that are gathered.
    gathered: u64,
    clock: Clock,
    /// What the run took before it was taken up.
    before: Seconds,
}

/// Rows of the history.
struct Rows {
    times: RowTimes,
    next: u64,
    state: State,
    values: Vec<f64>,
    warnings: Vec<Warning>,
    coarseness: Coarseness,
    marks: Marks,
}

impl Course {
    /// Of a run that is about to begin; readies the result. Long tables are `thinned` for pictures of them where they are on disk.
    pub fn new(
        integrator: &mut Running<'_>,
        columns: usize,
        thinned: bool,
        result: &mut RunResult,
        clock: Clock,
    ) -> Self {
        let times = RowTimes::of(&result.settings);
        let count = times.count;
        if result.settings.pictures {
            result.pictures = Pictures::new(integrator.system(), count);
        }
        let mut steps = Steps::default();
        if thinned {
            result.history.thin();
            steps.thin();
        }
        Self {
            rows: Rows {
                times,
                next: 0,
                state: integrator.state().clone(),
                values: vec![0.0; columns],
                warnings: Vec::new(),
                coarseness: Coarseness::default(),
                marks: Marks::of(count, columns),
            },
            energy: EnergyDrift::default(),
            steps,
            gathered: 0,
            clock,
            before: Seconds::default(),
        }
    }

    /// Takes in the start.
    pub fn begin(&mut self, integrator: &mut Running<'_>, result: &mut RunResult) {
        self.meet(integrator, result);
    }

    /// Takes in the last step, unless it is one that is repeated.
    pub fn step(&mut self, integrator: &mut Running<'_>, result: &mut RunResult) {
        let count = integrator.statistics().steps;
        if count > self.gathered {
            self.gathered = count;
            let t = integrator.state().t;
            self.steps.push(t, t - integrator.previous_time());
            self.meet(integrator, result);
        }
    }

    /// Takes in the end of a step. Where no row is within the step, it is asked for what sections carry and for outputs, of which
    /// the least and greatest values are kept: rows may be much farther apart.
    fn meet(&mut self, integrator: &mut Running<'_>, result: &mut RunResult) {
        let has_row = self.rows.next_by(integrator.state().t).is_some();
        let state = &mut self.rows.state;
        state.clone_from(integrator.state());
        if !has_row {
            integrator.system().outputs(state, &mut self.rows.values);
            result.history.meet(state.t, &self.rows.values);
            result.envelopes.meet(integrator.system(), state.t, state);
            if let Some(pictures) = &mut result.pictures {
                pictures.meet(state.t, result.envelopes.states());
            }
        }
        self.energy.meet(integrator.system().energy(state));
        if self.energy.wants_potential() {
            state.v.fill(0.0);
            self.energy.meet_potential(integrator.system().energy(state));
        }
    }

    /// Adds the rows up to the end of the last step.
    pub fn record(
        &mut self,
        integrator: &mut Running<'_>,
        result: &mut RunResult,
        recorder: &mut dyn Recorder,
    ) -> Result<(), Incomplete> {
        while self.rows.take_next(integrator, result, recorder)? {
            recorder
                .keep_up(&mut |bytes| self.write(integrator, result, bytes))
                .map_err(Incomplete::Files)?;
        }
        recorder
            .keep_up(&mut |bytes| self.write(integrator, result, bytes))
            .map_err(Incomplete::Files)
    }

    /// Appends what takes the run up here.
    pub fn write(&mut self, integrator: &Running<'_>, result: &mut RunResult, bytes: &mut Vec<u8>) {
        let mut earlier = Earlier {
            renewed: integrator.renewed().unwrap_or_default().to_vec(),
            course: Vec::new(),
        };
        self.keep(result, &mut Archive::writing(&mut earlier.course));
        earlier.keep(&mut Archive::writing(bytes));
    }

    /// Reads a course.
    ///
    /// # Errors
    /// It is not that of this run.
    pub fn take_up(&mut self, course: &[u8], result: &mut RunResult) -> Result<(), String> {
        let mut archive = Archive::reading(course);
        self.keep(result, &mut archive);
        archive
            .end()
            .map_err(|_| "the checkpoint holds another run than this one".to_owned())
    }

    fn keep(&mut self, result: &mut RunResult, archive: &mut Archive<'_>) {
        let Self {
            rows:
                Rows {
                    times: _,
                    next,
                    state,
                    values: _,
                    warnings,
                    coarseness,
                    marks,
                },
            energy,
            steps,
            gathered,
            clock,
            before,
        } = self;
        next.keep(archive);
        warnings.keep(archive);
        coarseness.keep(state, archive);
        marks.keep(archive);
        energy.keep(archive);
        steps.keep(archive);
        gathered.keep(archive);
        let mut so_far = before.and(clock.seconds());
        so_far.keep(archive);
        if archive.is_reading() {
            *before = so_far;
        }
        result.history.keep(archive);
        result.envelopes.keep(archive);
        if let Some(pictures) = &mut result.pictures {
            pictures.keep(archive);
        }
    }

    /// Fills the result with what is gathered; `moved` is what the start corrected.
    pub fn fill(self, integrator: &mut Running<'_>, result: &mut RunResult, moved: Vec<String>) {
        result.steps = self.steps.taken();
        result.energy_error = self.energy.relative();
        let yielding: Vec<String> = result.envelopes.warnings().collect();
        let iterations = integrator.statistics().newton_iterations;
        let coarse = self.rows.coarseness.warning(integrator.system(), iterations);
        result.marks = self.rows.marks;
        let told = cautions::texts(self.rows.warnings);
        result.warnings = moved.into_iter().chain(told).chain(yielding).collect();
        result.coarse = coarse;
        result.seconds = self.before.and(self.clock.seconds());
    }
}

impl Rows {
    /// Time of the next row where a time has reached it, s.
    fn next_by(&self, reached: f64) -> Option<f64> {
        // Steps end a rounding before a kink: a row at the kink is that of the step before.
        let is_due = |time: &f64| *time <= reached + self.slack();
        let next = (self.next < self.times.count).then(|| self.times.at(self.next).min(self.times.t_end));
        next.filter(is_due)
    }

    fn slack(&self) -> f64 {
        1e-13 * self.times.t_end
    }

    /// Adds the next row where the last step has reached it, and says whether it has.
    fn take_next(
        &mut self,
        integrator: &mut Running<'_>,
        result: &mut RunResult,
        recorder: &mut dyn Recorder,
    ) -> Result<bool, Incomplete> {
        let reached = integrator.state().t;
        let Some(t) = self.next_by(reached) else {
            return Ok(false);
        };
        let time = self.times.at(self.next);
        if t >= reached - self.slack() {
            self.state.clone_from(integrator.state());
        } else {
            integrator.interpolate(t, &mut self.state);
        }
        integrator.system().outputs(&self.state, &mut self.values);
        for warning in integrator.system().warnings(&self.state) {
            cautions::meet(&mut self.warnings, warning);
        }
        result.history.push(time, &self.values).map_err(Incomplete::Output)?;
        recorder.row(time, &self.values);
        result.envelopes.meet(integrator.system(), time, &self.state);
        self.marks.meet(self.next, t, &self.values);
        if result.settings.judged != Judging::No && self.next.is_multiple_of(self.times.count / OPERANDS + 1) {
            let operands = integrator.system().operands(&self.state);
            self.marks.meet_operands(&operands);
        }
        self.coarseness.meet(integrator.system(), &self.state, self.times.t_end);
        if let Some(pictures) = &mut result.pictures {
            pictures.take(
                self.next,
                integrator.system(),
                time,
                &self.state,
                result.envelopes.states(),
            );
        }
        self.next += 1;
        Ok(true)
    }
}

/// The accepted steps.
#[derive(Default)]
struct Steps {
    ends: Vec<f64>,
    sizes: Vec<f64>,
    sketch: Option<Sketch>,
}

impl Keep for Steps {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { ends, sizes, sketch } = self;
        ends.keep(archive);
        sizes.keep(archive);
        if let Some(sketch) = sketch {
            sketch.keep(archive);
        }
        if ends.len() != sizes.len() {
            archive.misfit();
        }
    }
}

impl Steps {
    /// Keeps from now on what pictures need.
    fn thin(&mut self) {
        self.sketch = Some(Sketch::new(SKETCHED));
    }

    fn push(&mut self, t: f64, h: f64) {
        match &mut self.sketch {
            Some(sketch) => sketch.add(&mut self.ends, &mut self.sizes, t, &[h]),
            None => {
                self.ends.push(t);
                self.sizes.push(h);
            }
        }
    }

    fn taken(self) -> Vec<StepTaken> {
        let steps = self.ends.into_iter().zip(self.sizes);
        steps.map(|(t, h)| StepTaken { t, h }).collect()
    }
}

/// Deviation of the energy from its first value. It is measured in the largest kinetic energy: the zero of a potential is
/// anybody's choice.
#[derive(Default)]
struct EnergyDrift {
    first: Option<f64>,
    lost: bool,
    deviation: f64,
    last: f64,
    kinetic: f64,
    /// States met.
    count: u64,
}

/// The kinetic energy is looked at in one of so many states: it serves as a size.
const LOOKED_AT: u64 = 4;

impl Keep for EnergyDrift {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            first,
            lost,
            deviation,
            last,
            kinetic,
            count,
        } = self;
        first.keep(archive);
        lost.keep(archive);
        deviation.keep(archive);
        last.keep(archive);
        kinetic.keep(archive);
        count.keep(archive);
    }
}

impl EnergyDrift {
    fn meet(&mut self, energy: Option<f64>) {
        let Some(energy) = energy else {
            self.lost = true;
            return;
        };
        let first = *self.first.get_or_insert(energy);
        self.deviation = self.deviation.max((energy - first).abs());
        self.last = energy;
        self.count += 1;
    }

    fn wants_potential(&self) -> bool {
        !self.lost && self.count % LOOKED_AT == 1
    }

    /// The energy of the same state without velocities.
    fn meet_potential(&mut self, energy: Option<f64>) {
        if let Some(potential) = energy {
            // In a turning frame that of the rotation counts against it.
            self.kinetic = self.kinetic.max((self.last - potential).abs());
        }
    }

    fn relative(&self) -> Option<f64> {
        if self.lost || self.first.is_none() {
            return None;
        }
        Some(if self.deviation == 0.0 {
            0.0
        } else {
            self.deviation / self.kinetic.max(self.deviation)
        })
    }
}
