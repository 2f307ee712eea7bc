//! What stresses of a section follow from, with what follows from its shape alone.

use std::f64::consts::PI;
use std::sync::OnceLock;

use crate::emitted::{SectionShape, SectionSpec};

/// What stresses of a section follow from.
pub(crate) struct Section {
    pub spec: SectionSpec,
    /// Of a rectangle, see [`Section::torsion_of_sides`]; found where something twists it.
    torsion_of_sides: OnceLock<[f64; 2]>,
}

impl Section {
    pub fn new(spec: SectionSpec) -> Self {
        Self {
            spec,
            torsion_of_sides: OnceLock::new(),
        }
    }

    /// Shear stress over T/J in the middles of the sides at `+-h/2` along y and `+-w/2` along z of a rectangle (h, w), m; nothing
    /// of other shapes.
    pub fn torsion_of_sides(&self) -> [f64; 2] {
        let SectionShape::Rectangle { sizes } = self.spec.shape else {
            return [0.0; 2];
        };
        *self.torsion_of_sides.get_or_init(|| torsion_of_sides(sizes))
    }
}

/// The series of Saint-Venant's torsion (Timoshenko and Goodier, Theory of Elasticity, section 109).
fn torsion_of_sides([height, width]: [f64; 2]) -> [f64; 2] {
    let (long, short) = (height.max(width), height.min(width));
    let (mut on_long, mut on_short) = (1.0, 0.0);
    let mut sign = 1.0;
    for n in (1..TERMS).step_by(2).map(f64::from) {
        let argument = 0.5 * n * PI * long / short;
        // 8 / (n pi)^2
        let weight = 8.0 / (n * PI).powi(2);
        on_long -= weight / argument.cosh();
        on_short += sign * weight * argument.tanh();
        sign = -sign;
    }
    // The side at +-h/2 along y has the length w.
    if width >= height {
        [short * on_long, short * on_short]
    } else {
        [short * on_short, short * on_long]
    }
}

/// Terms of alternating series that fall with 1/n^2: an error below 1e-5.
const TERMS: i32 = 400;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_of_rectangles_are_those_of_the_handbook() {
        // Short sides have 0.859 of the stress of the long ones where these are 1.5 times as long.
        let [short, long] = torsion_of_sides([0.03, 0.02]);
        assert!((short / long / 0.859 - 1.0).abs() < 1e-3, "{short} {long}");
        let [short, long] = torsion_of_sides([0.02, 0.03]);
        assert!((long / short / 0.859 - 1.0).abs() < 1e-3, "{short} {long}");
        let [first, second] = torsion_of_sides([1.0, 1.0]);
        assert!((first / 0.6753 - 1.0).abs() < 1e-4, "{first}");
        assert!((second / first - 1.0).abs() < 1e-4, "{first} {second}");
    }
}
