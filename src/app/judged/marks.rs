//! Outputs of a run at its rows, and of a second run at the same times: how far one is from the other.

use super::compared::{Compared, NOTHING, Off, ROUND_OFF, Run, TOLD, WRONG, compared, of_outputs};
use crate::app::writing::sentences::listed;
use crate::archive::{Archive, Keep};
use crate::model::Operands;
use crate::{Integrator, Method, Options, Output, Scene, State, Stop};

/// Most numbers that are kept, with the times and what a row costs beside them: of longer histories every second, third, .. row.
const NUMBERS: u64 = 400_000;
const BESIDE: u64 = 4;
/// The cure of a coarse mesh. Cubic elements have no step of the moment inside, and no kink between them.
pub(super) const MORE: &str = "Take more elements in `mesh`: twice as many make it some ten times less, or half where something acts within an element or bends a taut line";
/// In tolerances what steps of a run leave of a number that is kept.
const DRIFT: f64 = 10.0;
/// Part of what an output of an equilibrium is made of that is little.
const LITTLE: f64 = 1e-3;
/// A number whose multiples have fractions that are spread evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Most outputs that are told.
const MOST: usize = 4;

/// Outputs of a run at its rows, with their times (s). What dies away between two rows that are far apart would be missed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::app) struct Marks {
    pub rows: Vec<(f64, Vec<f64>)>,
    /// Rows from one that is kept to the next, less one.
    left_out: u64,
    /// What round-off makes of the outputs, by columns; empty until it is known.
    pub round_off: Vec<f64>,
    /// What the outputs are made of at most, by columns; empty where that is not looked at.
    pub operands: Vec<Operands>,
}

impl Keep for Marks {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            rows,
            left_out: _,
            round_off,
            operands,
        } = self;
        rows.keep(archive);
        round_off.keep(archive);
        operands.keep(archive);
    }
}

impl Marks {
    /// Of a history with so many rows and columns of outputs.
    pub fn of(rows: u64, columns: usize) -> Self {
        Self {
            left_out: rows.saturating_mul(columns as u64 + BESIDE) / NUMBERS,
            ..Self::default()
        }
    }

    /// Takes in a row by its number.
    pub fn meet(&mut self, row: u64, t: f64, values: &[f64]) {
        if row.is_multiple_of(self.left_out + 1) {
            self.rows.push((t, values.to_vec()));
        }
    }

    /// Time of the last one, s.
    pub fn until(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.0)
    }

    /// The same times with other values, as far as there are any.
    pub fn with(&self, rows: Vec<Vec<f64>>) -> Self {
        let times = self.rows.iter().map(|row| row.0);
        Self {
            rows: times.zip(rows).collect(),
            left_out: self.left_out,
            round_off: self.round_off.clone(),
            operands: self.operands.clone(),
        }
    }

    /// Takes in what outputs are made of at a row.
    pub fn meet_operands(&mut self, values: &[Operands]) {
        self.operands.resize(values.len(), Operands::default());
        for (largest, value) in self.operands.iter_mut().zip(values) {
            // What has no size there may have one elsewhere.
            *largest = largest.max(*value);
        }
    }

    fn run(&self) -> Run<'_> {
        Run {
            rows: &self.rows,
            round_off: &self.round_off,
            operands: &self.operands,
        }
    }

    /// The outputs with their distance from the rows of a run with other steps, as part of their largest change, or of their largest value where that is
    /// less; the largest first. Rows that are not there are not compared; `rtol` is the tolerance of the run.
    pub fn differences(&self, outputs: &[Output], rows: &[Vec<f64>], rtol: f64) -> Vec<Off> {
        self.between(outputs, &self.rows, rows, &self.known(outputs, &self.rows, rows), rtol)
    }

    /// The same of two other runs, and what is known to be there: outputs, each before its components.
    pub fn between(
        &self,
        outputs: &[Output],
        here: &[(f64, Vec<f64>)],
        there: &[Vec<f64>],
        known: &[bool],
        rtol: f64,
    ) -> Vec<Off> {
        apart(&compared(self.run(), outputs, here, there), known, [rtol, 0.0])
    }

    /// [`Marks::between`] of runs on other meshes: of a number that hardly changes, such as a momentum, no part is told that steps of both with their
    /// tolerance may have left.
    pub fn between_meshes(
        &self,
        outputs: &[Output],
        here: &[(f64, Vec<f64>)],
        there: &[Vec<f64>],
        known: &[bool],
        rtol: f64,
    ) -> Vec<Off> {
        apart(&compared(self.run(), outputs, here, there), known, [rtol, DRIFT * rtol])
    }

    /// [`Marks::between`] of equilibria on other meshes: a number that loads hardly change, such as the sag of a chain, is off by nothing where that is
    /// little of what it is made of.
    pub fn between_equilibria(&self, outputs: &[Output], there: &[Vec<f64>], known: &[bool], rtol: f64) -> Vec<Off> {
        apart(&compared(self.run(), outputs, &self.rows, there), known, [rtol, LITTLE])
    }

    /// Which outputs, and components of them, two runs with different steps find alike.
    pub fn known(&self, outputs: &[Output], here: &[(f64, Vec<f64>)], there: &[Vec<f64>]) -> Vec<bool> {
        let compared = compared(self.run(), outputs, here, there);
        compared.iter().map(Compared::agrees).collect()
    }

    /// Which of the same are more than a part of what they are made of, in one of both.
    pub fn above(&self, outputs: &[Output], there: &[Vec<f64>], part: f64) -> Vec<bool> {
        let compared = compared(self.run(), outputs, &self.rows, there);
        compared
            .iter()
            .map(|of| of.sizes[0].max(of.sizes[1]) > (part * of.operands).max(of.round_off))
            .collect()
    }

    /// Which outputs, as a whole, differ by no more than the second of two tolerances knows of them, but would be off by much if they were there to the first, that of the run.
    pub fn open(&self, outputs: &[Output], there: &[Vec<f64>], known: &[bool], [own, other]: [f64; 2]) -> Vec<bool> {
        let compared = compared(self.run(), outputs, &self.rows, there);
        let is_open = |(of, is_known): (&Compared, bool)| {
            let nothing = (NOTHING * own * of.operands).max(of.round_off);
            of.away <= TOLD * of.measure(is_known, other)
                && of.away > TOLD * of.measure(true, own)
                && of.sizes[0].max(of.sizes[1]) > nothing
        };
        let wholes = compared.iter().zip(known.iter().copied());
        wholes.filter(|(of, _)| of.component.is_none()).map(is_open).collect()
    }

    /// Outputs that miss swings of such amplitudes, as `differences` tells them.
    pub fn lost(&self, outputs: &[Output], amplitudes: &[(usize, f64)], rtol: f64) -> Vec<Off> {
        let compared = compared(self.run(), outputs, &self.rows, &[]);
        let off = |&(output, amplitude): &(usize, f64)| {
            let missing = Compared {
                away: amplitude,
                // What steps lose is there.
                balanced: 0.0,
                ..*compared.iter().find(|of| of.output == output)?
            };
            Some(Off {
                is_open: false,
                ..missing.off(false, rtol)
            })
        };
        sorted(amplitudes.iter().filter_map(off).collect())
    }
}

/// What round-off of a state makes of the outputs, by columns: of places and speeds, and of the forces that it makes of multipliers.
pub(in crate::app) fn round_off(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let columns = scene.output_columns();
    let [mut values, mut others] = [vec![0.0; columns], vec![0.0; columns]];
    let [mut force, mut other] = [vec![0.0; scene.unknowns()], vec![0.0; scene.unknowns()]];
    let mut near = state.clone();
    // Of two bodies not the same: a distance between them would have none.
    let part = |index: usize| {
        let size = ROUND_OFF * (1.0 + (GOLDEN * index as f64).fract());
        if index % 3 == 1 { -size } else { size }
    };
    for (index, (x, size)) in near.x.iter_mut().zip(scene.sizes()).enumerate() {
        *x += part(index) * size.max(x.abs());
    }
    // What constraints keep at rest has the round-off of what moves: of the fastest, in sizes of the unknowns.
    let speeds = near.v.iter().zip(scene.sizes()).map(|(v, size)| v.abs() / size);
    let fastest = speeds.fold(0.0, f64::max);
    for (index, (v, size)) in near.v.iter_mut().zip(scene.sizes()).enumerate() {
        *v += part(index) * size * fastest;
    }
    scene.residual(state, &mut force);
    scene.residual(&near, &mut other);
    let change = force.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    for (index, multiplier) in near.lambda.iter_mut().enumerate() {
        *multiplier += change.copysign(part(index));
    }
    scene.outputs(state, &mut values);
    scene.outputs(&near, &mut others);
    values.iter().zip(&others).map(|(a, b)| (a - b).abs()).collect()
}

/// Whether an output follows from where things are and how fast they move. Forces, accelerations and energies have vibrations of their own, of
/// places that hardly change.
pub(in crate::app) fn is_of_motion(output: &Output) -> bool {
    output.time_exponent > -2.0
}

/// The largest part.
pub(in crate::app) fn largest(found: &[Off]) -> f64 {
    found.first().map_or(0.0, |off| off.part)
}

/// How far two runs are apart, each by what is known to be there to the first of two tolerances; a number that hardly changes by nothing, where that is
/// within a second part of its value.
fn apart(compared: &[Compared], known: &[bool], [rtol, drift]: [f64; 2]) -> Vec<Off> {
    let all = compared.iter().zip(known);
    let off = all.map(|(of, &is_known)| match of.off(is_known, rtol) {
        off if off.nothing.is_some() && of.away <= drift * of.value.max(of.operands) => Off {
            part: 0.0,
            is_open: false,
            ..off
        },
        off => off,
    });
    sorted(of_outputs(off))
}

/// The largest first.
pub(in crate::app) fn sorted(mut found: Vec<Off>) -> Vec<Off> {
    found.sort_by(|a, b| b.part.total_cmp(&a.part));
    found
}

/// The outputs whose errors are worth to be told, with these.
pub(in crate::app) fn told(outputs: &[Output], found: &[Off]) -> Option<String> {
    let name = |off: &Off| {
        let (name, unit, part) = (off.name(outputs), outputs[off.output].unit, off.part);
        match off.nothing {
            // What should not change has no part of its change.
            Some(size) if unit == "1" => format!("`{name}` by about {:.1e}", part * size),
            Some(size) => format!("`{name}` by about {:.1e} {unit}", part * size),
            None => format!("`{name}` by {}", percent(part)),
        }
    };
    let worth = found.iter().filter(|off| off.part > TOLD);
    listed(&worth.map(name).collect::<Vec<_>>(), MOST)
}

/// A part with two digits; beyond one half both are different.
pub(in crate::app) fn percent(part: f64) -> String {
    if part > WRONG {
        return format!("more than {:.0} %", 100.0 * WRONG);
    }
    let digits = usize::from(part < 0.1);
    format!("about {:.digits$} %", 100.0 * part)
}

/// How to go a second time.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct Again {
    pub t_end: f64,
    pub method: Method,
    pub options: Options,
    /// Most iterations.
    pub most: u64,
}

/// A run that went so.
pub(in crate::app) struct Gone {
    /// Rows at the times of the marks, as far as it came.
    pub rows: Vec<Vec<f64>>,
    /// Iterations that it took.
    pub iterations: u64,
    /// Why it came no further, where that is an error.
    pub failed: Option<String>,
}

/// A run that goes so, as far as it comes and `goes_on` lets it.
pub(in crate::app) fn again(
    scene: &mut dyn Scene,
    start: State,
    how: Again,
    marks: &Marks,
    goes_on: &mut dyn FnMut() -> bool,
) -> Gone {
    let columns = scene.output_columns();
    let mut rows = Vec::with_capacity(marks.rows.len());
    let gone = |rows, iterations, failed| Gone {
        rows,
        iterations,
        failed,
    };
    let mut integrator = match Integrator::new(scene, start, how.t_end, how.method, how.options) {
        Ok(integrator) => integrator,
        Err(error) => return gone(rows, 0, Some(error.to_string())),
    };
    let mut state = integrator.state().clone();
    loop {
        while let Some(&(t, _)) = marks.rows.get(rows.len()) {
            let reached = integrator.state().t;
            if t > reached * (1.0 + ROUND_OFF) {
                break;
            }
            if t >= reached {
                state.clone_from(integrator.state());
            } else {
                integrator.interpolate(t, &mut state);
            }
            let mut row = vec![0.0; columns];
            integrator.system().outputs(&state, &mut row);
            rows.push(row);
        }
        let iterations = integrator.statistics().newton_iterations;
        if rows.len() == marks.rows.len() || iterations > how.most || !goes_on() {
            return gone(rows, iterations, None);
        }
        match integrator.step() {
            // A run that ends at a kink ends just before it.
            Ok(Stop::End) if integrator.state().t * (1.0 + ROUND_OFF) < how.t_end => {
                return gone(rows, iterations, None);
            }
            Ok(_) => {}
            Err(error) => return gone(rows, iterations, Some(error.to_string())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn output(name: &'static str, unit: &'static str) -> Output {
        Output {
            name,
            unit,
            time_exponent: 0.0,
            components: &[],
            doc: "",
        }
    }

    #[test]
    fn a_constant_that_is_off_is_told_in_its_unit() {
        let outputs = [output("reaction", "N")];
        let rows = |values: [f64; 3]| {
            [0.0, 1.0, 2.0]
                .into_iter()
                .zip(values.map(|value| vec![value]))
                .collect()
        };
        let marks = Marks {
            rows: rows([5.0, 5.03, 5.0]),
            ..Marks::default()
        };
        let found = marks.differences(&outputs, &[vec![5.0], vec![5.0], vec![5.0]], 1e-6);
        assert_eq!(told(&outputs, &found).unwrap(), "`reaction` by about 3.0e-2 N");
        let swings = Marks {
            rows: rows([5.0, 8.0, 5.0]),
            ..Marks::default()
        };
        let found = swings.differences(&outputs, &[vec![5.0], vec![5.0], vec![5.0]], 1e-6);
        assert_eq!(told(&outputs, &found).unwrap(), "`reaction` by more than 50 %");
    }

    /// A spinning top goes round by a decimetre and nods by a tenth of a millimetre: the runs agree that it nods, not how.
    #[test]
    fn a_small_component_of_a_vector_is_told_beside_it() {
        let vector = |name| Output {
            components: &["x", "y", "z"],
            ..output(name, "m")
        };
        let outputs = [vector("centre"), vector("still")];
        let row = |t: f64, nods: f64, error: f64| vec![t, 0.0, nods * t, t, error, error];
        let mut marks = Marks::default();
        (0..=10).for_each(|k| marks.meet(k, k as f64, &row(k as f64, 1e-4, 0.0)));
        let other = |nods: f64, error: f64| -> Vec<Vec<f64>> {
            (0..=10).map(|k| row(k as f64 * (1.0 + 1e-6), nods, error)).collect()
        };
        let told_of = |rows: &[Vec<f64>]| told(&outputs, &marks.differences(&outputs, rows, 1e-6));
        assert_eq!(told_of(&other(1.2e-4, 1e-5)).unwrap(), "`centre.z` by about 20 %");
        // Errors of the others turn into a component that is nothing, and are told from a ten-thousandth of the vector on.
        assert_eq!(told_of(&other(1.0001e-4, 5e-4)), None);
        assert_eq!(told_of(&other(1.0001e-4, 3e-3)).unwrap(), "`still.y` by about 3.0e-3 m");
        let found = marks.differences(&outputs, &other(1.0001e-4, 0.0), 1e-6);
        assert_eq!((found[0].name(&outputs), found.len()), ("centre.z".into(), 2));
    }

    /// A momentum drifts by what the tolerance of a run knows of it on each mesh; beyond, it is off.
    #[test]
    fn no_mesh_is_blamed_for_what_both_keep_to_their_tolerance() {
        let outputs = [output("momentum", "kg m/s")];
        let mut marks = Marks::default();
        (0..=10).for_each(|k| marks.meet(k, k as f64, &[0.745 + 4e-7 * k as f64]));
        let found = |drift: f64| {
            let there: Vec<Vec<f64>> = (0..=10).map(|k| vec![0.745 + drift * f64::from(k)]).collect();
            let between = marks.between_meshes(&outputs, &marks.rows, &there, &[true], 1e-4);
            (
                told(&outputs, &between),
                told(&outputs, &marks.differences(&outputs, &there, 1e-4)),
            )
        };
        assert_eq!(found(1e-5).0, None);
        assert!(found(1e-5).1.is_some());
        assert!(found(7e-4).0.is_some());
    }

    /// Of four places one moves, two hardly, of which the runs agree on one, and one not at all; energy is kept in one run and not in the other; a force is as good
    /// as it is in any unit.
    #[test]
    fn what_two_runs_do_not_agree_on_is_compared_with_what_it_is_made_of() {
        let outputs = [
            output("moves", "m"),
            output("hardly", "m"),
            output("little", "m"),
            output("stays", "m"),
            output("energy", "J"),
            output("force", "kN"),
        ];
        let mut marks = Marks::default();
        for k in 0..=40u32 {
            let t = f64::from(k) / 40.0;
            marks.meet(k.into(), t, &[t, 1e-6 * t, 1e-6 * t, 1e-13 * t, 5.0 + 1e-9 * t, t]);
        }
        let others = |hardly: f64| -> Vec<Vec<f64>> {
            let row = |t: f64| vec![1.02 * t, hardly * t, 1.04e-6 * t, 0.0, 5.0 + 1e-3 * t, 1.05 * t];
            marks.rows.iter().map(|(t, _)| row(*t)).collect()
        };
        let rows = others(3e-6);
        // What nothing is known of is made of itself.
        let part = |marks: &Marks, rows: &[Vec<f64>], index: usize| {
            let found = marks.differences(&outputs, rows, 1e-6);
            found.iter().find(|found| found.output == index).unwrap().part
        };
        assert!((part(&marks, &rows, 1) - 2.0).abs() < 1e-9);
        let mut measured = marks.clone();
        let made_of = |size| Operands { size, balanced: 0.0 };
        measured.meet_operands(&[1.0, 1.0, 1.0, 1.0, 5.0, 1.0].map(made_of));
        let found = measured.differences(&outputs, &rows, 1e-6);
        assert_eq!(
            told(&outputs, &found).unwrap(),
            "`energy` by about 1.0e-3 J, `force` by about 5.0 %, `little` by about 4.0 %, `moves` by about 2.0 %"
        );
        // A number that is 1e-6 of what it is made of may be an error of the steps, or there: another comparison has to tell.
        let known = measured.known(&outputs, &measured.rows, &rows);
        assert_eq!(known, [true, false, true, false, false, true]);
        let open = measured.open(&outputs, &rows, &known, [1e-6, 1e-6]);
        assert_eq!(open, [false, true, false, false, false, false]);
        // A hundred times the tolerance knows less of what is there, and of what may be.
        let mut small = measured.clone();
        small.rows.iter_mut().for_each(|(_, row)| row[1] += 1.0);
        let mut there = others(3e-6);
        there.iter_mut().for_each(|row| row[1] += 1.0);
        let known = small.known(&outputs, &small.rows, &there);
        let open = |other: f64| small.open(&outputs, &there, &known, [1e-9, other])[1];
        assert!(open(1e-6) && !open(1e-9));
        let nearer = others(2.8e-6);
        let known = measured.known(&outputs, &measured.with(rows.clone()).rows, &nearer);
        assert!(known[1] && !known[3]);
        let found = measured.between(&outputs, &measured.rows, &nearer, &known, 1e-6);
        assert!(found[0].output == 1 && (found[0].part - 1.8).abs() < 1e-9, "{found:?}");
        // As far as there are rows.
        assert!(told(&outputs, &measured.differences(&outputs, &rows[..1], 1e-6)).is_none());
    }

    /// Between axes an angle jumps back by a turn: not at the same time in two runs.
    #[test]
    fn angles_that_jump_are_compared_the_shorter_way_round() {
        let outputs = [output("between", "deg"), output("counted", "deg")];
        let wrapped = |angle: f64| (angle + 180.0).rem_euclid(360.0) - 180.0;
        let row = |angle: f64| vec![wrapped(angle), angle];
        let mut marks = Marks::default();
        (0..1000).for_each(|k| marks.meet(k, k as f64, &row(k as f64)));
        let others: Vec<Vec<f64>> = (0..1000).map(|k| row(k as f64 + 2.0)).collect();
        let found = marks.differences(&outputs, &others, 1e-6);
        let of = |index: usize| found.iter().find(|found| found.output == index).unwrap().part;
        assert!(
            (of(0) - 2.0 / 180.0).abs() < 1e-9 && (of(1) - 2.0 / 999.0).abs() < 1e-9,
            "{found:?}"
        );
    }

    /// Nothing is left out of a history that fits in memory; of a longer one as little as may be.
    #[test]
    fn all_rows_are_kept_but_of_very_long_histories() {
        for (count, kept) in [(301, 301), (50_000, 50_000), (160_000, 53_334)] {
            let mut marks = Marks::of(count, 2);
            (0..count).for_each(|row| marks.meet(row, row as f64, &[1.0, 2.0]));
            assert_eq!(marks.rows.len(), kept, "{count}");
        }
    }
}
