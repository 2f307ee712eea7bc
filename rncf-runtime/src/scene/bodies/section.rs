//! What stresses of a section follow from, with what follows from its shape alone.

use std::f64::consts::PI;
use std::sync::OnceLock;

use crate::emitted::{SectionShape, SectionSpec};

/// What stresses of a section follow from.
pub(crate) struct Section {
    pub spec: SectionSpec,
    /// Of a rectangle, see [`Section::torsion_along_sides`]; found where something twists it.
    torsion_along_sides: OnceLock<[[f64; PLACES]; 2]>,
}

/// Places from the middle of a side of a rectangle towards its corner, closer and closer to each other ([`place`]).
pub(crate) const PLACES: usize = 20;

/// A place from the middle (0) to the corner (1) of a side.
pub(crate) fn place(index: usize) -> f64 {
    (0.5 * PI * index as f64 / PLACES as f64).sin()
}

impl Section {
    pub fn new(spec: SectionSpec) -> Self {
        Self {
            spec,
            torsion_along_sides: OnceLock::new(),
        }
    }

    /// Shear stress over T/J along the sides at `+-h/2` along y and `+-w/2` along z of a rectangle (h, w), m, in each [`place`]; nothing
    /// of other shapes.
    pub fn torsion_along_sides(&self) -> [[f64; PLACES]; 2] {
        let SectionShape::Rectangle { sizes } = self.spec.shape else {
            return [[0.0; PLACES]; 2];
        };
        *self.torsion_along_sides.get_or_init(|| torsion_along_sides(sizes))
    }
}

/// The series of Saint-Venant's torsion (Timoshenko and Goodier, Theory of Elasticity, section 109).
fn torsion_along_sides([height, width]: [f64; 2]) -> [[f64; PLACES]; 2] {
    let (long, short) = (height.max(width), height.min(width));
    let on_long = std::array::from_fn(|index| short * on_long(place(index), long / short));
    let on_short = std::array::from_fn(|index| short * on_short(place(index), long / short));
    // The side at +-h/2 along y has the length w.
    if width >= height {
        [on_long, on_short]
    } else {
        [on_short, on_long]
    }
}

/// Odd numbers below [`TERMS`] with `8 / (n pi)^2`.
fn terms() -> impl Iterator<Item = (f64, f64)> {
    let odd = (1..TERMS).step_by(2).map(f64::from);
    odd.map(|n| (n, 8.0 / (n * PI).powi(2)))
}

/// At a place of a long side, which is so many times as long as the other one. Exponential functions for hyperbolic ones, which overflow.
fn on_long(place: f64, ratio: f64) -> f64 {
    let mut sum = 1.0;
    for (n, weight) in terms() {
        let half = 0.5 * n * PI * ratio;
        let cosh = |at: f64| 1.0 + (-2.0 * half * at).exp();
        sum -= weight * (half * (place - 1.0)).exp() * cosh(place) / cosh(1.0);
    }
    sum
}

/// At a place of a short side. In its middle terms alternate: with half of the last one the sum is ten times as near.
fn on_short(place: f64, ratio: f64) -> f64 {
    let (mut sum, mut last, mut sign) = (0.0, 0.0, 1.0);
    for (n, weight) in terms() {
        last = sign * weight * (0.5 * n * PI * ratio).tanh() * (0.5 * n * PI * place).cos();
        sum += last;
        sign = -sign;
    }
    sum - 0.5 * last
}

/// What is left of the series is below 1e-5 in the middle of a side, and at its corners, where nothing is, below 1e-2.
const TERMS: i32 = 80;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_of_rectangles_are_those_of_the_handbook() {
        // Short sides have 0.859 of the stress of the long ones where these are 1.5 times as long.
        let torsion_of_sides = |sizes| torsion_along_sides(sizes).map(|along| along[0]);
        let [short, long] = torsion_of_sides([0.03, 0.02]);
        assert!((short / long / 0.859 - 1.0).abs() < 1e-3, "{short} {long}");
        let [short, long] = torsion_of_sides([0.02, 0.03]);
        assert!((long / short / 0.859 - 1.0).abs() < 1e-3, "{short} {long}");
        let [first, second] = torsion_of_sides([1.0, 1.0]);
        assert!((first / 0.6753 - 1.0).abs() < 1e-4, "{first}");
        assert!((second / first - 1.0).abs() < 1e-4, "{first} {second}");
    }

    #[test]
    fn sides_of_a_square_are_alike_up_to_their_corners() {
        let [first, second] = torsion_along_sides([1.0, 1.0]);
        for (first, second) in first.into_iter().zip(second) {
            assert!((first - second).abs() < 6e-3, "{first} {second}");
        }
        assert!(first[PLACES - 1] < 0.1 * first[0]);
        // Along a thin strip it is the same but near the ends.
        let [_, along] = torsion_along_sides([1.0, 0.02]);
        assert!(
            (along[PLACES / 2] / along[0] - 1.0).abs() < 1e-2 && along[PLACES - 1] < 0.8 * along[0],
            "{along:?}"
        );
    }
}
