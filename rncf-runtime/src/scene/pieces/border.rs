//! Places on the pattern beside free frames.

use crate::scene::bodies::nodal_mass::Padded;

/// Places on the pattern of the entries between a body's components and the unknowns of its frame.
#[derive(Clone, Debug, Default)]
pub(crate) struct Border {
    /// For every component the factor of its unknown; zero where there is none.
    pub factors: Vec<f64>,
    /// For every component the place of the first of the frame's rows in its column; the others follow.
    pub lower: Vec<u32>,
    /// For every component the places of its row in the frame's columns.
    pub upper: Vec<u32>,
    /// Components that depend on a second unknown: what it has stands after that of all components, in this order.
    pub doubled: Vec<usize>,
}

impl Border {
    /// Adds the entries of a vector's component along `axis`: for every unknown its row by the component, and the reverse.
    #[inline(always)]
    pub fn add(&self, entry: usize, axis: usize, beside: &[[Padded; 2]], values: &mut [f64]) {
        let (factor, width) = (self.factors[entry], beside.len());
        let lower = self.lower[entry] as usize;
        for (value, [lower, _]) in values[lower..lower + width].iter_mut().zip(beside) {
            *value += factor * lower[axis & 3];
        }
        let upper = &self.upper[entry * width..(entry + 1) * width];
        for (&place, [_, upper]) in upper.iter().zip(beside) {
            values[place as usize] += factor * upper[axis & 3];
        }
    }
}
