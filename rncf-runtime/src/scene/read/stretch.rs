//! Which bodies are so stretched or compressed that their material gives way: what most rows are asked, and answered without a
//! search.

use pulp::Arch;

use super::compression::{LEAST_STRETCH, THREE};
use super::overstretch::{MOST, UNSHRUNK};
use crate::emitted::{Fidelity, Interpolant, Line, MAX_SIZE};
use crate::linalg::{Vectorised, dispatch};
use crate::scene::MeshScene;
use crate::scene::numbering::assembly::Connectivity;

/// What rounding may make of a square.
const ROUNDING: f64 = 1e-12;
/// Places of an element that are looked at, in [0, 1]: those of [`super::compression`] and of [`super::overstretch`].
const PLACES: [f64; 5] = [0.0, THREE[0], 0.5, THREE[2], 1.0];
/// These, up to the width of the machine.
const WIDTH: usize = 8;

impl MeshScene {
    /// Bodies whose axes may be stretched less or more than they bear at the loaded state, for all others are not for certain.
    /// Strains of small deformations are not those of the elements, and rigid bodies have none.
    pub(crate) fn strongly_stretched(&self) -> Vec<usize> {
        let told = |&body: &usize| {
            let spec = &self.bodies[body].spec;
            matches!(spec.fidelity, Fidelity::Full | Fidelity::Modal(_)) && !matches!(spec.line, Line::Nodes(_))
        };
        let bodies = (0..self.bodies.len()).filter(told);
        bodies.filter(|&body| !self.is_stretched_little(body)).collect()
    }

    fn is_stretched_little(&self, body: usize) -> bool {
        let spec = &self.bodies[body].spec;
        if !spec.stations.is_empty() {
            return false;
        }
        let count = spec.nodal.len();
        let mut slopes = [[0.0; WIDTH]; MAX_SIZE];
        for (place, &xi) in PLACES.iter().enumerate() {
            let mut weights = [0.0; MAX_SIZE];
            self.parts
                .shapes(body, 0, Interpolant::Position, 1, xi, &mut weights[..count]);
            for (all, weight) in slopes.iter_mut().zip(weights) {
                all[place] = weight;
            }
        }
        let of = Squares {
            q: &self.buffers.q,
            connectivity: &self.bodies[body].connectivity,
            elements: spec.count,
            slopes: &slopes[..count],
            dimension: spec.dimension(),
        };
        let [least, most] = dispatch(Arch::new(), of);
        let bound = if spec.has_section() { UNSHRUNK } else { MOST };
        least > LEAST_STRETCH * LEAST_STRETCH * (1.0 + ROUNDING) && most < bound * bound * (1.0 - ROUNDING)
    }
}

/// Least and largest square of the slope's length, which `slopes` of the nodal vectors add up to at the places; not ordered where
/// one is not a number.
struct Squares<'a> {
    q: &'a [f64],
    connectivity: &'a Connectivity,
    elements: usize,
    slopes: &'a [[f64; WIDTH]],
    dimension: usize,
}

impl Vectorised for Squares<'_> {
    type Output = [f64; 2];

    #[inline(always)]
    fn run<const F: bool>(self) -> [f64; 2] {
        match self.dimension {
            2 => self.found::<2>(),
            _ => self.found::<3>(),
        }
    }
}

impl Squares<'_> {
    #[inline(always)]
    fn found<const D: usize>(self) -> [f64; 2] {
        let (mut least, mut most, mut sum) = ([f64::INFINITY; WIDTH], [0.0; WIDTH], [0.0; WIDTH]);
        for element in 0..self.elements {
            let mut slope = [[0.0; WIDTH]; D];
            let (vectors, _) = self.connectivity.element(element).as_chunks::<D>();
            for (components, weights) in vectors.iter().zip(self.slopes) {
                for (sums, &component) in slope.iter_mut().zip(components) {
                    let component = self.q[component];
                    for (sum, weight) in sums.iter_mut().zip(weights) {
                        *sum += weight * component;
                    }
                }
            }
            let mut squares = [0.0; WIDTH];
            for sums in slope {
                for (square, sum) in squares.iter_mut().zip(sums) {
                    *square += sum * sum;
                }
            }
            for place in 0..WIDTH {
                let square = squares[place];
                least[place] = if square < least[place] { square } else { least[place] };
                most[place] = if square > most[place] { square } else { most[place] };
                sum[place] += square;
            }
        }
        if sum.iter().any(|sum| sum.is_nan()) {
            return [f64::NAN; 2];
        }
        [
            least[..PLACES.len()].iter().copied().fold(f64::INFINITY, f64::min),
            most[..PLACES.len()].iter().copied().fold(0.0, f64::max),
        ]
    }
}
