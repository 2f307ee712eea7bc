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
        let mut slopes = [[0.0; MAX_SIZE]; 3];
        for (&xi, slope) in places.iter().zip(&mut slopes) {
            let weights = &mut slope[..count];
            self.parts.shapes(body, 0, Interpolant::Position, 1, xi, weights);
        }
        let slopes = slopes.each_ref().map(|slope| &slope[..count]);
        let squares = match spec.dimension() {
            2 => self.squares_of_stretches::<2>(body, slopes),
            _ => self.squares_of_stretches::<3>(body, slopes),
        };
        squares[0] > least * least * (1.0 + ROUNDING) && squares[1] < most * most * (1.0 - ROUNDING)
    }

    /// Least and largest square of the slope's length; not ordered where one is not a number.
    fn squares_of_stretches<const D: usize>(&self, body: usize, slopes: [&[f64]; 3]) -> [f64; 2] {
        let (spec, connectivity) = (&self.bodies[body].spec, &self.bodies[body].connectivity);
        let [mut least, mut most] = [f64::INFINITY, 0.0_f64];
        for element in 0..spec.count {
            let mut slope = [[0.0; D]; 3];
            let (vectors, _) = connectivity.element(element).as_chunks::<D>();
            for (place, components) in vectors.iter().enumerate() {
                let vector = components.map(|component| self.buffers.q[component]);
                for (sum, weights) in slope.iter_mut().zip(slopes) {
                    for (sum, component) in sum.iter_mut().zip(vector) {
                        *sum += weights[place] * component;
                    }
                }
            }
            for slope in slope {
                let square: f64 = slope.iter().map(|component| component * component).sum();
                if square.is_nan() {
                    return [f64::NAN; 2];
                }
                (least, most) = (least.min(square), most.max(square));
            }
        }
        [least, most]
    }
}
