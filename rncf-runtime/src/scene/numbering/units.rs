//! Elements in units of four, one in each lane, and where their components are.

use std::ops::Range;

use crate::emitted::LANES;

/// Numbers side by side, one of each element.
pub(crate) type Lanes = [f64; LANES];

/// Elements of one kind, four by four.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    /// Degrees of freedom of an element.
    pub size: usize,
    /// Number of elements.
    elements: usize,
    /// Owner (a body, or a load on one) and element in every lane; the last unit repeats an element in lanes that it
    /// does not need.
    lanes: Vec<[(usize, usize); LANES]>,
    /// Components in the full arrays, unit by unit.
    components: Vec<[u32; LANES]>,
    /// Whether the components of every element of a unit follow each other.
    in_runs: Vec<bool>,
}

impl Units {
    /// Of elements (owner and element), whose components `of` gives.
    pub fn new<'a>(elements: &[(usize, usize)], size: usize, of: impl Fn((usize, usize)) -> &'a [usize]) -> Self {
        let lanes: Vec<[(usize, usize); LANES]> = elements
            .chunks(LANES)
            .map(|chunk| std::array::from_fn(|lane| chunk[lane.min(chunk.len() - 1)]))
            .collect();
        let places = lanes.iter().flat_map(|unit| (0..size).map(move |place| (unit, place)));
        let components: Vec<[u32; LANES]> = places
            .map(|(unit, place)| unit.map(|element| of(element)[place] as u32))
            .collect();
        let follow = |pair: &[[u32; LANES]]| (0..LANES).all(|lane| pair[0][lane] + 1 == pair[1][lane]);
        Self {
            size,
            elements: elements.len(),
            in_runs: components
                .chunks_exact(size.max(1))
                .map(|own| own.windows(2).all(follow))
                .collect(),
            components,
            lanes,
        }
    }

    /// Number of units.
    pub fn count(&self) -> usize {
        self.lanes.len()
    }

    /// Whether there are too few elements to fill a unit.
    pub fn are_few(&self) -> bool {
        self.elements < LANES
    }

    /// Owner and element in every lane of a unit.
    pub fn all(&self, unit: usize) -> &[(usize, usize); LANES] {
        &self.lanes[unit]
    }

    /// The same of the lanes whose results count.
    pub fn used(&self, unit: usize) -> &[(usize, usize)] {
        &self.lanes[unit][..(self.elements - unit * LANES).min(LANES)]
    }

    /// Components of a unit in the full arrays.
    fn components(&self, unit: usize) -> &[[u32; LANES]] {
        &self.components[unit * self.size..(unit + 1) * self.size]
    }

    /// Copies the components of a unit.
    pub fn gather(&self, unit: usize, full: &[f64], local: &mut [Lanes]) {
        let components = self.components(unit);
        if self.in_runs[unit] {
            let firsts = components[0].map(|first| first as usize);
            match self.size {
                // Sizes of the library's elements are constants of the code.
                8 => return gather_run::<8>(firsts, full, local),
                12 => return gather_run::<12>(firsts, full, local),
                24 => return gather_run::<24>(firsts, full, local),
                _ => {}
            }
        }
        for (values, components) in local.iter_mut().zip(components) {
            *values = components.map(|component| full[component as usize]);
        }
    }

    /// Adds `factor` times what some lanes of a unit have for their components, one lane after the other.
    pub fn add(&self, unit: usize, lanes: Range<usize>, factor: f64, local: &[Lanes], full: &mut [f64]) {
        match self.size {
            8 if self.in_runs[unit] => self.add_runs::<8>(unit, lanes, factor, local, full),
            12 if self.in_runs[unit] => self.add_runs::<12>(unit, lanes, factor, local, full),
            24 if self.in_runs[unit] => self.add_runs::<24>(unit, lanes, factor, local, full),
            _ => {
                for lane in lanes {
                    for (components, values) in self.components(unit).iter().zip(local) {
                        full[components[lane] as usize] += factor * values[lane];
                    }
                }
            }
        }
    }

    /// The same of `N` components of each element that follow each other.
    fn add_runs<const N: usize>(
        &self,
        unit: usize,
        lanes: Range<usize>,
        factor: f64,
        local: &[Lanes],
        full: &mut [f64],
    ) {
        let firsts = self.components(unit)[0];
        let Some(local) = local.first_chunk::<N>() else {
            unreachable!("a unit has the components of its elements");
        };
        for lane in lanes {
            let Some(sums) = full[firsts[lane] as usize..].first_chunk_mut::<N>() else {
                unreachable!("components are in the full arrays");
            };
            for i in 0..N {
                sums[i] += factor * local[i][lane];
            }
        }
    }
}

/// Copies `N` components that follow each other, of four elements.
fn gather_run<const N: usize>(firsts: [usize; LANES], full: &[f64], local: &mut [Lanes]) {
    // Written out: closures over arrays are not inlined here.
    let own = |lane: usize| full[firsts[lane]..].first_chunk::<N>();
    let (Some(a), Some(b), Some(c), Some(d)) = (own(0), own(1), own(2), own(3)) else {
        unreachable!("components are in the full arrays");
    };
    let Some(local) = local.first_chunk_mut::<N>() else {
        unreachable!("a unit has the components of its elements");
    };
    for i in 0..N {
        local[i] = [a[i], b[i], c[i], d[i]];
    }
}
