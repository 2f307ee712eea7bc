//! Assembly of element matrices and vectors: places are looked up once, elements are evaluated in
//! parallel where there are many, and added in a fixed order.

use rayon::prelude::*;

use super::layout::Layout;
use crate::linalg::Pattern;

/// Fewer elements than this are evaluated by the calling thread alone.
const PARALLEL_FROM: usize = 256;

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

    /// Pattern entries of all elements.
    pub fn entries<'a>(&'a self, layout: &'a Layout) -> impl Iterator<Item = (usize, usize)> + 'a {
        (0..self.count()).flat_map(move |element| {
            let unknowns = move |component: &usize| layout.unknown(*component).map(|(unknown, _)| unknown);
            let rows = self.element(element).iter().filter_map(unknowns);
            rows.flat_map(move |row| {
                self.element(element)
                    .iter()
                    .filter_map(unknowns)
                    .map(move |column| (row, column))
            })
        })
    }
}

/// Places of element matrix entries on a pattern.
#[derive(Clone, Debug, Default)]
pub struct Scatter {
    entries: Vec<(u32, f64)>,
    size: usize,
}

/// Marks an entry that belongs to no unknown.
const NOWHERE: u32 = u32::MAX;

impl Scatter {
    /// Looks all places up.
    pub fn new(connectivity: &Connectivity, layout: &Layout, pattern: &Pattern) -> Self {
        let mut entries = Vec::with_capacity(connectivity.count() * connectivity.size.pow(2));
        for element in 0..connectivity.count() {
            for &row in connectivity.element(element) {
                for &column in connectivity.element(element) {
                    let place = match (layout.unknown(row), layout.unknown(column)) {
                        (Some((i, a)), Some((j, b))) => pattern.find(i, j).map(|place| (place as u32, a * b)),
                        _ => None,
                    };
                    entries.push(place.unwrap_or((NOWHERE, 0.0)));
                }
            }
        }
        Self {
            entries,
            size: connectivity.size.pow(2),
        }
    }

    /// Adds the matrix of one element.
    pub fn add(&self, element: usize, local: &[f64], values: &mut [f64]) {
        let entries = &self.entries[element * self.size..(element + 1) * self.size];
        for (&(place, weight), &value) in entries.iter().zip(local) {
            if place != NOWHERE {
                values[place as usize] += weight * value;
            }
        }
    }
}

/// Evaluates `count` elements into `results` (`width` numbers each, zeroed before), in parallel
/// where there are many. The results do not depend on the number of threads.
pub fn evaluate(count: usize, width: usize, results: &mut Vec<f64>, element: impl Fn(usize, &mut [f64]) + Sync) {
    results.clear();
    results.resize(count * width, 0.0);
    if count < PARALLEL_FROM {
        for (index, result) in results.chunks_exact_mut(width).enumerate() {
            element(index, result);
        }
    } else {
        results
            .par_chunks_exact_mut(width)
            .enumerate()
            .for_each(|(index, result)| element(index, result));
    }
}
