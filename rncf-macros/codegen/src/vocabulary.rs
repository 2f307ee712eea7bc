//! The properties of materials and sections: names, dimensions and ranges, as data.

mod law;
pub mod members;
mod property;

pub use law::{
    CENTRES, DAMPINGS, LAW, MASS_ENTRIES, MASSES, PIVOTS, PIVOTS_OF_RATES, STIFFNESS_ENTRIES, fields_of_product,
    from_beamdyn, of_either_triangle, pivot_dimension, product_of,
};
pub use property::{Property, Range};

/// Properties of a material.
pub const MATERIAL: &[Property] = &[
    Property {
        name: "density",
        dimension: [-3, 1, 0, 0, 0, 0],
        unit: "kg/m^3",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "young",
        dimension: [-1, 1, -2, 0, 0, 0],
        unit: "Pa",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "poisson",
        dimension: [0, 0, 0, 0, 0, 0],
        unit: "1",
        range: Range::Poisson,
        default: None,
    },
    Property {
        name: "damping",
        dimension: [0, 0, 1, 0, 0, 0],
        unit: "s",
        range: Range::NonNegative,
        default: Some(0.0),
    },
    Property {
        name: "yield",
        dimension: [-1, 1, -2, 0, 0, 0],
        unit: "Pa",
        range: Range::Positive,
        default: None,
    },
];

/// Sizes of named kinds of sections: what a block gives no field for.
pub const SIZES: &[&str] = &["radius", "thickness", "inner_radius", "size_y", "size_z"];

/// Fields of a section's block that stand for two properties, one for each axis.
pub const BOTH_AXES: &[(&str, [&str; 2])] = &[
    ("second_moment", ["second_moment_y", "second_moment_z"]),
    ("shear_factor", ["shear_factor_y", "shear_factor_z"]),
    ("GA", ["GAy", "GAz"]),
    ("EI", ["EIy", "EIz"]),
];

/// A field of a list, or of those that stand for both axes that of the first one; with the word that is looked for.
pub fn field_of(list: &'static [Property], word: &str) -> Option<(&'static str, &'static Property)> {
    let named = |name: &str| list.iter().find(|property| property.name == name);
    if let Some(property) = named(word) {
        return Some((property.name, property));
    }
    let (both, [first, _]) = BOTH_AXES.iter().find(|(both, _)| *both == word)?;
    Some((both, named(first)?))
}

/// Properties of a section. `second_moment` is that of elements which bend alike in all directions.
pub const SECTION: &[Property] = &[
    Property {
        name: "area",
        dimension: [2, 0, 0, 0, 0, 0],
        unit: "m^2",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "second_moment",
        dimension: [4, 0, 0, 0, 0, 0],
        unit: "m^4",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "second_moment_y",
        dimension: [4, 0, 0, 0, 0, 0],
        unit: "m^4",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "second_moment_z",
        dimension: [4, 0, 0, 0, 0, 0],
        unit: "m^4",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "torsion_constant",
        dimension: [4, 0, 0, 0, 0, 0],
        unit: "m^4",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "shear_factor_y",
        dimension: [0, 0, 0, 0, 0, 0],
        unit: "1",
        range: Range::Part,
        default: None,
    },
    Property {
        name: "shear_factor_z",
        dimension: [0, 0, 0, 0, 0, 0],
        unit: "1",
        range: Range::Part,
        default: None,
    },
    Property {
        name: "extent_y",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "extent_z",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "radius",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "thickness",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "inner_radius",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "size_y",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
    Property {
        name: "size_z",
        dimension: [1, 0, 0, 0, 0, 0],
        unit: "m",
        range: Range::Positive,
        default: None,
    },
];

/// A property that follows from others.
#[derive(Clone, Copy, Debug)]
pub struct Derived {
    /// Name, as the coefficients of elements use it.
    pub name: &'static str,
    /// SI unit for documentation.
    pub unit: &'static str,
    /// Properties that it follows from.
    pub from: &'static [&'static str],
    /// Rust text, in terms of those.
    pub value: &'static str,
}

/// Properties that follow from others; the ranges of those keep them finite.
pub const DERIVED: &[Derived] = &[
    Derived {
        name: "shear_modulus",
        unit: "Pa",
        from: &["young", "poisson"],
        value: "young / (2.0 * (1.0 + poisson))",
    },
    Derived {
        name: "half_young",
        unit: "Pa",
        from: &["young"],
        value: "0.5 * young",
    },
    Derived {
        name: "quarter_polar_moment",
        unit: "m^4",
        from: &["second_moment_y", "second_moment_z"],
        value: "0.25 * (second_moment_y + second_moment_z)",
    },
    Derived {
        name: "double_shear_modulus",
        unit: "Pa",
        from: &["young", "poisson"],
        value: "young / (1.0 + poisson)",
    },
    Derived {
        name: "lame",
        unit: "Pa",
        from: &["young", "poisson"],
        value: "young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))",
    },
    // Of plane stress.
    Derived {
        name: "plane_lame",
        unit: "Pa",
        from: &["young", "poisson"],
        value: "young * poisson / ((1.0 + poisson) * (1.0 - poisson))",
    },
];
