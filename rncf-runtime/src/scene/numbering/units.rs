//! Elements in units of four, one in each lane, and where their components are.

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
}

impl Units {
    /// Of elements (owner and element), whose components `of` gives.
    pub fn new<'a>(elements: &[(usize, usize)], size: usize, of: impl Fn((usize, usize)) -> &'a [usize]) -> Self {
        let lanes: Vec<[(usize, usize); LANES]> = elements
            .chunks(LANES)
            .map(|chunk| std::array::from_fn(|lane| chunk[lane.min(chunk.len() - 1)]))
            .collect();
        let places = lanes.iter().flat_map(|unit| (0..size).map(move |place| (unit, place)));
        Self {
            size,
            elements: elements.len(),
            components: places
                .map(|(unit, place)| unit.map(|element| of(element)[place] as u32))
                .collect(),
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
    pub fn components(&self, unit: usize) -> &[[u32; LANES]] {
        &self.components[unit * self.size..(unit + 1) * self.size]
    }

    /// Copies the components of a unit.
    pub fn gather(&self, unit: usize, full: &[f64], local: &mut [Lanes]) {
        for (values, components) in local.iter_mut().zip(self.components(unit)) {
            *values = components.map(|component| full[component as usize]);
        }
    }
}
