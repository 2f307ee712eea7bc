//! Fields of a section that says its stiffness and mass by itself.

use std::sync::LazyLock;

use super::property::{Property, Range};
use crate::units::Dimension;

/// Stiffness by constants about the centres, in the order of the runtime's `Stiffness::Centres`.
pub const CENTRES: &[&str] = &[
    "EA",
    "GAy",
    "GAz",
    "GJ",
    "EIy",
    "EIz",
    "tension_y",
    "tension_z",
    "shear_y",
    "shear_z",
    "principal",
];

/// Upper triangle of the matrix of stiffness, row by row: axial, shear along y and z, torsion, bending about y and z.
pub const STIFFNESS_ENTRIES: &[&str] = &[
    "K11", "K12", "K13", "K14", "K15", "K16", "K22", "K23", "K24", "K25", "K26", "K33", "K34", "K35", "K36", "K44",
    "K45", "K46", "K55", "K56", "K66",
];

/// Mass by constants, in the order of the runtime's `Mass::Centre`.
pub const MASSES: &[&str] = &["mass", "mass_y", "mass_z", "inertia_y", "inertia_z", "inertia_yz"];

/// Upper triangle of the matrix of mass in the same order.
pub const MASS_ENTRIES: &[&str] = &[
    "M11", "M12", "M13", "M14", "M15", "M16", "M22", "M23", "M24", "M25", "M26", "M33", "M34", "M35", "M36", "M44",
    "M45", "M46", "M55", "M56", "M66",
];

/// What products of a material's and a section's properties are of a section that says its stiffness by itself: what an element without axes in its
/// section, or one of a model's own, reads of it.
const PRODUCTS: &[(&str, &[&str])] = &[
    ("EA", &["area", "young"]),
    // Of an element that bends alike in all directions, [`ALIKE`].
    ("EIz", &["second_moment", "young"]),
    ("EIy", &["second_moment_y", "young"]),
    ("EIz", &["second_moment_z", "young"]),
    ("GAy", &["area", "shear_factor_y", "shear_modulus"]),
    ("GAz", &["area", "shear_factor_z", "shear_modulus"]),
    ("GJ", &["shear_modulus", "torsion_constant"]),
    ("mass", &["area", "density"]),
    ("inertia_y", &["density", "second_moment_y"]),
    ("inertia_z", &["density", "second_moment_z"]),
];

/// The second moment of an element that bends alike in all directions: that about z, and in space about y, too.
const ALIKE: &str = "second_moment";

/// The fields that a product of properties reads, first the one that it is: bending alike in all directions is in space about both axes.
pub fn fields_of_product(factors: &[&str], is_spatial: bool) -> Option<Vec<&'static str>> {
    let is_alike = is_spatial && factors.contains(&ALIKE);
    let other = is_alike.then_some("EIy");
    Some(std::iter::once(product_of(factors)?).chain(other).collect())
}

/// The field that a product of properties is.
pub fn product_of(factors: &[&str]) -> Option<&'static str> {
    let mut sorted = factors.to_vec();
    sorted.sort_unstable();
    let found = PRODUCTS.iter().find(|(_, product)| *product == sorted.as_slice());
    found.map(|(name, _)| *name)
}

/// A damping of its own for each strain.
pub const DAMPINGS: &[&str] = &["damping1", "damping2", "damping3", "damping4", "damping5", "damping6"];

/// What the energy of the element of such a section reads: pivots and factors of its stiffness `L D L^T` in the order torsion, bending
/// about y and z, axial, shear along y and z, then what holds the section in its plane; in the order of the runtime's
/// `SectionLaw::coefficients`.
pub const PIVOTS: &[&str] = &[
    "D1",
    "D2",
    "D3",
    "D4",
    "D5",
    "D6",
    "L21",
    "L31",
    "L32",
    "L41",
    "L42",
    "L43",
    "L51",
    "L52",
    "L53",
    "L54",
    "L61",
    "L62",
    "L63",
    "L64",
    "L65",
    "held",
    "half_held",
];

/// What follows in `SectionLaw::viscous_coefficients`: factors of the rates, with dampings in seconds.
pub const PIVOTS_OF_RATES: &[&str] = &[
    "V1", "V2", "V3", "V4", "V5", "V6", "W21", "W31", "W32", "W41", "W42", "W43", "W51", "W52", "W53", "W54", "W61",
    "W62", "W63", "W64", "W65",
];

/// Dimension of one of these.
pub fn pivot_dimension(name: &str) -> Dimension {
    let digit = |at: usize| name.as_bytes().get(at).map_or(0, |digit| digit.wrapping_sub(b'0'));
    Dimension::of(match name.as_bytes()[0] {
        b'D' if digit(1) > 3 => FORCE,
        b'D' => BENDING,
        b'h' => FORCE,
        b'L' | b'W' if digit(1) > 3 && digit(2) <= 3 => [-1, 0, 0, 0, 0, 0],
        _ => [0; 6],
    })
}

const FORCE: [i8; 6] = [1, 1, -2, 0, 0, 0];
const MOMENT: [i8; 6] = [2, 1, -2, 0, 0, 0];
const BENDING: [i8; 6] = [3, 1, -2, 0, 0, 0];
const LENGTH: [i8; 6] = [1, 0, 0, 0, 0, 0];
const MASS: [i8; 6] = [-1, 1, 0, 0, 0, 0];
const FIRST: [i8; 6] = [0, 1, 0, 0, 0, 0];
const SECOND: [i8; 6] = [1, 1, 0, 0, 0, 0];
const ANGLE: [i8; 6] = [0, 0, 0, 0, 0, 1];
const TIME: [i8; 6] = [0, 0, 1, 0, 0, 0];

/// All of these fields.
pub static LAW: LazyLock<Vec<Property>> = LazyLock::new(|| {
    let field = |name, dimension, unit, range, default| Property {
        name,
        dimension,
        unit,
        range,
        default,
    };
    let mut list: Vec<Property> = Vec::new();
    for name in CENTRES {
        let (dimension, unit) = match *name {
            "EA" | "GAy" | "GAz" => (FORCE, "N"),
            "GJ" | "EIy" | "EIz" => (BENDING, "N m^2"),
            "principal" => (ANGLE, "rad"),
            _ => (LENGTH, "m"),
        };
        let is_stiffness = matches!(dimension, FORCE | BENDING);
        list.push(if is_stiffness {
            field(name, dimension, unit, Range::Positive, None)
        } else {
            field(name, dimension, unit, Range::Any, Some(0.0))
        });
    }
    for (names, dimensions, units) in [
        (STIFFNESS_ENTRIES, [FORCE, MOMENT, BENDING], ["N", "N m", "N m^2"]),
        (MASS_ENTRIES, [MASS, FIRST, SECOND], ["kg/m", "kg", "kg m"]),
    ] {
        for name in names {
            let digits = &name.as_bytes()[1..];
            let turns = digits.iter().filter(|digit| **digit > b'3').count();
            let is_diagonal = digits[0] == digits[1];
            let (range, default) = if is_diagonal {
                (Range::Positive, None)
            } else {
                (Range::Any, Some(0.0))
            };
            list.push(field(name, dimensions[turns], units[turns], range, default));
        }
    }
    list.push(field("mass", MASS, "kg/m", Range::Positive, None));
    list.push(field("mass_y", LENGTH, "m", Range::Any, Some(0.0)));
    list.push(field("mass_z", LENGTH, "m", Range::Any, Some(0.0)));
    list.push(field("inertia_y", SECOND, "kg m", Range::Positive, None));
    list.push(field("inertia_z", SECOND, "kg m", Range::Positive, None));
    list.push(field("inertia_yz", SECOND, "kg m", Range::Any, Some(0.0)));
    for name in ["damping"].iter().chain(DAMPINGS) {
        list.push(field(name, TIME, "s", Range::NonNegative, Some(0.0)));
    }
    list
});

/// The entry of a matrix of this program that an entry of BeamDyn's (shear x, shear y, axial z, bending x, bending y, torsion z)
/// is, of either triangle: its x is BeamDyn's z, its y is x, its z is y.
pub fn from_beamdyn(name: &str) -> Option<&'static str> {
    entry(name, [2, 3, 1, 5, 6, 4])
}

/// The entry of the upper triangle of `K` or `M` that `name` is, which may be one of the lower one.
pub fn of_either_triangle(name: &str) -> Option<&'static str> {
    entry(name, [1, 2, 3, 4, 5, 6])
}

/// The entry of a symmetric matrix whose rows and columns stand in another order: `order[0]` is the place of its first one here,
/// counted from 1.
fn entry(name: &str, order: [usize; 6]) -> Option<&'static str> {
    let all = match name.as_bytes().first()? {
        b'K' => STIFFNESS_ENTRIES,
        b'M' => MASS_ENTRIES,
        _ => return None,
    };
    let digit = |at: usize| {
        let digit = (*name.as_bytes().get(at)?).checked_sub(b'1')?;
        order.get(usize::from(digit)).copied()
    };
    let (row, column) = (digit(1)?, digit(2)?);
    let wanted = format!("{}{}{}", &name[..1], row.min(column), row.max(column));
    all.iter().copied().find(|entry| *entry == wanted && name.len() == 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_beamdyn_are_turned_into_the_axes_of_this_program() {
        // Edgewise bending (about BeamDyn's x) is bending about this program's y; axial with bending about x.
        for (theirs, own) in [
            ("K33", "K11"),
            ("K44", "K55"),
            ("K55", "K66"),
            ("K66", "K44"),
            ("K34", "K15"),
            ("M16", "M24"),
        ] {
            assert_eq!(from_beamdyn(theirs), Some(own));
        }
        assert_eq!(from_beamdyn("K71"), None);
        assert_eq!(from_beamdyn("eta"), None);
        assert_eq!(
            ["K12", "K21", "M64", "K7", "EA"].map(of_either_triangle),
            [Some("K12"), Some("K12"), Some("M46"), None, None]
        );
    }
}
