//! Sections as the generator describes them: what is read off them, and what stresses follow from.

/// What a section carries, in its own axes (of a centre line: along and across its slope).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionQuantity {
    /// Force along the axis, N; tension is positive.
    AxialForce,
    /// Force along the section's y axis, N.
    ShearY,
    /// Force along the section's z axis, N.
    ShearZ,
    /// Moment about the axis, N m.
    Torque,
    /// Moment about the section's y axis, N m.
    MomentY,
    /// Moment about the section's z axis, N m; of a planar body that about the plane's normal.
    MomentZ,
    /// Magnitude of the bending moment, N m; of a planar body signed, about the plane's normal.
    Moment,
    /// Largest von Mises stress over the section, Pa.
    Stress,
}

/// Shape of a section, for stresses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SectionShape {
    /// Distances of the outermost fibres along y and z, m, where known.
    General {
        /// Along y and z.
        extent: [Option<f64>; 2],
        /// Shear factors along y and z, 0 where unknown: the web of a thin-walled section carries `Q / (k A)`.
        shear_factors: [f64; 2],
    },
    /// A full circle.
    Circle {
        /// Radius, m.
        radius: f64,
    },
    /// A circular tube.
    Tube {
        /// Outer radius, m.
        radius: f64,
        /// Thickness of the wall, m.
        thickness: f64,
    },
    /// A rectangle.
    Rectangle {
        /// Sizes along y and z, m.
        sizes: [f64; 2],
    },
    /// None: the section says its stiffness and mass by itself, and its stress is not known.
    Numbers {
        /// The larger stiffness of bending over that of the axis, m^2: the square of the radius of gyration.
        square_of_gyration: f64,
    },
}

/// What stresses of a body's section follow from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionSpec {
    /// Shape.
    pub shape: SectionShape,
    /// Area, m^2.
    pub area: f64,
    /// Second moments about the section's y and z axes, m^4: int Z^2 dA, int Y^2 dA.
    pub second_moments: [f64; 2],
    /// Torsion constant, m^4; 0 where unknown.
    pub torsion_constant: f64,
    /// Young's modulus over the shear modulus of the material; 0 of one that is given otherwise.
    pub young_over_shear: f64,
    /// By how many parts `I curvature^2 / A` a moment turns a curved axis more than that of a thin beam.
    pub softness_of_curves: f64,
    /// Yield stress of the material, Pa.
    pub yield_stress: Option<f64>,
    /// Name of the material, for messages.
    pub material: &'static str,
}

impl SectionSpec {
    /// Of a model without bodies, whose sections nobody asks for.
    pub(crate) const NONE: Self = Self {
        shape: SectionShape::General {
            extent: [None, None],
            shear_factors: [0.0; 2],
        },
        area: 0.0,
        second_moments: [0.0; 2],
        torsion_constant: 0.0,
        young_over_shear: 0.0,
        softness_of_curves: 0.0,
        yield_stress: None,
        material: "",
    };
}
