//! Between which stretches the axis of a body lies: what most rows are asked, and answered without a search.

use crate::emitted::{Interpolant, MAX_SIZE};
use crate::scene::MeshScene;

/// What rounding may make of a square.
const ROUNDING: f64 = 1e-12;

impl MeshScene {
    /// Whether all stretches of a body's axis at these places of its elements lie between two bounds, for certain.
    pub(super) fn stretches_within(&self, body: usize, places: &[f64; 3], [least, most]: [f64; 2]) -> bool {
        let spec = &self.bodies[body].spec;
        if !spec.stations.is_empty() {
            return false;
        }
        let count = spec.nodal.len();
        // With a fourth place for the width of the machine.
        let mut slopes = [[0.0; 4]; MAX_SIZE];
        for (place, &xi) in places.iter().enumerate() {
            let mut weights = [0.0; MAX_SIZE];
            self.parts
                .shapes(body, 0, Interpolant::Position, 1, xi, &mut weights[..count]);
            slopes
                .iter_mut()
                .zip(weights)
                .for_each(|(all, weight)| all[place] = weight);
        }
        let slopes = &slopes[..count];
        let squares = match spec.dimension() {
            2 => self.squares_of_stretches::<2>(body, slopes),
            _ => self.squares_of_stretches::<3>(body, slopes),
        };
        squares[0] > least * least * (1.0 + ROUNDING) && squares[1] < most * most * (1.0 - ROUNDING)
    }

    /// Least and largest square of the slope's length, which `slopes` of the nodal vectors add up to at three places; not ordered where one is not a number.
    fn squares_of_stretches<const D: usize>(&self, body: usize, slopes: &[[f64; 4]]) -> [f64; 2] {
        let (spec, connectivity) = (&self.bodies[body].spec, &self.bodies[body].connectivity);
        let (mut least, mut most, mut sum) = ([f64::INFINITY; 4], [0.0; 4], 0.0);
        for element in 0..spec.count {
            let mut slope = [[0.0; 4]; D];
            let (vectors, _) = connectivity.element(element).as_chunks::<D>();
            for (components, weights) in vectors.iter().zip(slopes) {
                for (sums, &component) in slope.iter_mut().zip(components) {
                    let component = self.buffers.q[component];
                    for (sum, weight) in sums.iter_mut().zip(weights) {
                        *sum += weight * component;
                    }
                }
            }
            let mut squares = [0.0; 4];
            for sums in slope {
                for (square, sum) in squares.iter_mut().zip(sums) {
                    *square += sum * sum;
                }
            }
            for ((square, least), most) in squares.into_iter().zip(&mut least).zip(&mut most).take(3) {
                *least = if square < *least { square } else { *least };
                *most = if square > *most { square } else { *most };
                sum += square;
            }
        }
        if f64::is_nan(sum) {
            return [f64::NAN; 2];
        }
        [
            least.into_iter().fold(f64::INFINITY, f64::min),
            most.into_iter().fold(0.0, f64::max),
        ]
    }
}
