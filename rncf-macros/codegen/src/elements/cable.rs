//! Hermite centre-line element (THEORY 5.1): axial strain and bending of a thin beam, cable or
//! tether; no shear, no torsion.

use super::{Coefficient, Element, ElementOption, Field, Invariants, Term};
use crate::symbolic::Graph;

/// The element behind the words `cable` and `tether`.
pub const CABLE: Element = Element {
    names: &["cable", "tether"],
    doc: "Hermite centre-line element: axial strain and bending, no shear, no torsion",
    vectors: &[],
    fields: &[Field { name: "a", order: 1 }, Field { name: "b", order: 2 }],
    coefficients: &[
        Coefficient {
            name: "EA",
            unit: "N",
            factors: &["young", "area"],
        },
        Coefficient {
            name: "EI",
            unit: "N m^2",
            factors: &["young", "second_moment"],
        },
        Coefficient {
            name: "rhoA",
            unit: "kg/m",
            factors: &["density", "area"],
        },
    ],
    inertia: "rhoA",
    damping: "damping",
    options: &[ElementOption {
        name: "bending",
        values: &["polynomial", "exact"],
        doc: "bending energy 1/2 EI |r_x x r_xx|^2 (polynomial), or divided by |r_x|^4 (exact)",
    }],
    energy,
    default_points: 5,
    least_points: 3,
    curved_in_space: Some(
        "in space the centre line alone does not know which way it is curved: use the beam with a cross-section",
    ),
};

fn energy(_: &mut Graph, _: &Invariants, _: &[usize]) -> Vec<Term> {
    Vec::new()
}
