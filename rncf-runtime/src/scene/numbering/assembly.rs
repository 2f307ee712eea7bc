//! Assembly of element matrices and vectors: places are looked up once, and elements are added in a fixed order. Starts, which keep
//! what their elements give, have many of them evaluated in parallel.

use rayon::prelude::*;

use super::layout::Layout;
use crate::linalg::Pattern;

/// Fewer numbers than this are evaluated by the calling thread alone: to hand work to others and wait for them takes about
/// 60 us, the numbers a quarter of a millisecond and more (docs/measurements.md).
const PARALLEL_FROM: usize = 1 << 18;

/// Fewest units that one of the threads takes of so many: each gets one piece.
fn piece(units: usize) -> usize {
    (units / rayon::current_num_threads().next_power_of_two()).max(1)
}

/// Couples all of some unknowns with each other.
pub fn couple_all(unknowns: &[usize], entries: &mut Vec<(usize, usize)>) {
    entries.extend(unknowns.iter().flat_map(|&i| unknowns.iter().map(move |&j| (i, j))));
}

/// Where the components of the elements of one body are.
#[derive(Clone, Debug)]
pub struct Connectivity {
    /// Degrees of freedom of one element.
    pub size: usize,
    /// Component in the full arrays, for every element and local degree of freedom.
    pub components: Vec<usize>,
}

impl Connectivity {
    /// Components of one element.
    pub fn element(&self, element: usize) -> &[usize] {
        &self.components[element * self.size..(element + 1) * self.size]
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.components.len() / self.size
    }

    /// Copies the components of one element.
    pub fn gather(&self, element: usize, full: &[f64], local: &mut [f64]) {
        for (value, &component) in local.iter_mut().zip(self.element(element)) {
            *value = full[component];
        }
    }

    /// Adds the pattern entries of all elements.
    pub fn add_entries(&self, layout: &Layout, entries: &mut Vec<(usize, usize)>) {
        let mut unknowns = Vec::new();
        for element in 0..self.count() {
            unknowns.clear();
            for &component in self.element(element) {
                unknowns.extend(layout.unknowns_at(component).map(|(unknown, _)| unknown));
            }
            for &row in &unknowns {
                entries.extend(unknowns.iter().map(|&column| (row, column)));
            }
        }
    }
}

/// Places of element matrix entries on a pattern.
#[derive(Clone, Debug, Default)]
pub struct Scatter {
    runs: Vec<Run>,
    /// Start of every element's runs, and their number at the end.
    run_starts: Vec<u32>,
    odd: Vec<Odd>,
    odd_starts: Vec<u32>,
    size: usize,
}

/// Entries below each other that stand together on the pattern, too, with factor one.
#[derive(Clone, Copy, Debug)]
struct Run {
    place: u32,
    /// The first entry of the element's matrix, rows first.
    local: u16,
    length: u16,
}

/// An entry with a factor.
#[derive(Clone, Copy, Debug)]
struct Odd {
    place: u32,
    local: u16,
    factor: f64,
}

impl Run {
    /// Adds its entries, of a matrix of some size.
    #[inline(always)]
    fn add<T>(self, size: usize, local: &[T], entry: impl Fn(&T) -> f64, values: &mut [f64]) {
        let mut place = usize::from(self.local);
        for value in &mut values[self.place as usize..][..usize::from(self.length)] {
            *value += entry(&local[place]);
            place += size;
        }
    }
}

/// Adds runs of a matrix of a constant size, most of which are whole columns.
#[inline(always)]
fn add_columns<T, const N: usize>(runs: &[Run], local: &[T], entry: impl Fn(&T) -> f64, values: &mut [f64]) {
    let (rows, _) = local.as_chunks::<N>();
    for run in runs {
        let (column, places) = (
            usize::from(run.local),
            values[run.place as usize..].first_chunk_mut::<N>(),
        );
        match (rows.first_chunk::<N>(), places) {
            (Some(rows), Some(places)) if usize::from(run.length) == N && column < N => {
                for (place, row) in places.iter_mut().zip(rows) {
                    *place += entry(&row[column]);
                }
            }
            _ => run.add(N, local, &entry, values),
        }
    }
}

impl Scatter {
    /// Looks all places up.
    pub fn new(connectivity: &Connectivity, layout: &Layout, pattern: &Pattern) -> Self {
        let size = connectivity.size;
        let mut scatter = Self {
            run_starts: vec![0],
            odd_starts: vec![0],
            size,
            ..Self::default()
        };
        for element in 0..connectivity.count() {
            let components = connectivity.element(element);
            for (column, &by) in components.iter().enumerate() {
                for (j, b) in layout.unknowns_at(by) {
                    // Most rows stand behind the one before.
                    let mut before = None;
                    for (row, &of) in components.iter().enumerate() {
                        for (i, a) in layout.unknowns_at(of) {
                            before = pattern.find_behind(before, i, j);
                            if let Some(place) = before {
                                scatter.push(place as u32, (row * size + column) as u16, a * b);
                            }
                        }
                    }
                }
            }
            scatter.run_starts.push(scatter.runs.len() as u32);
            scatter.odd_starts.push(scatter.odd.len() as u32);
        }
        scatter
    }

    fn push(&mut self, place: u32, local: u16, factor: f64) {
        if factor != 1.0 {
            self.odd.push(Odd { place, local, factor });
            return;
        }
        let own = self.run_starts[self.run_starts.len() - 1] as usize;
        if let Some(run) = self.runs[own..].last_mut() {
            let next = run.local + run.length * self.size as u16;
            if run.place + u32::from(run.length) == place && next == local {
                run.length += 1;
                return;
            }
        }
        self.runs.push(Run {
            place,
            local,
            length: 1,
        });
    }

    /// Adds the matrix of one element, rows first.
    pub fn add(&self, element: usize, local: &[f64], values: &mut [f64]) {
        self.add_by(element, local, |value| *value, values);
    }

    /// Adds the matrix of one element, given by what stands in the places of its entries, rows first.
    #[inline]
    pub fn add_by<T>(&self, element: usize, local: &[T], entry: impl Fn(&T) -> f64, values: &mut [f64]) {
        let own = |starts: &[u32]| starts[element] as usize..starts[element + 1] as usize;
        let runs = &self.runs[own(&self.run_starts)];
        match self.size {
            // Sizes of the library's elements are constants of the code.
            8 => add_columns::<T, 8>(runs, local, &entry, values),
            12 => add_columns::<T, 12>(runs, local, &entry, values),
            24 => add_columns::<T, 24>(runs, local, &entry, values),
            size => runs.iter().for_each(|run| run.add(size, local, &entry, values)),
        }
        for odd in &self.odd[own(&self.odd_starts)] {
            values[odd.place as usize] += odd.factor * entry(&local[usize::from(odd.local)]);
        }
    }
}

/// Evaluates `count` elements into `results` (`width` numbers each, zeroed before), in parallel
/// where there are many. The results do not depend on the number of threads.
pub fn evaluate(count: usize, width: usize, results: &mut Vec<f64>, element: impl Fn(usize, &mut [f64]) + Sync) {
    results.clear();
    results.resize(count * width, 0.0);
    if count * width < PARALLEL_FROM {
        for (index, result) in results.chunks_exact_mut(width).enumerate() {
            element(index, result);
        }
    } else {
        results
            .par_chunks_exact_mut(width)
            .enumerate()
            .with_min_len(piece(count))
            .for_each(|(index, result)| element(index, result));
    }
}
