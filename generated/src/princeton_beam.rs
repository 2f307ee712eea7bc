//! Expansion of `models/src/princeton_beam.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use princeton_beam_equations::PrincetonBeam;
#[allow(clippy::all)]
impl Default for PrincetonBeam {
    fn default() -> Self {
        Self {
            load: 8.896,
            angle: 0.5235987755982988,
            elements: 16,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for PrincetonBeam {
    const NAME: &'static str = "PrincetonBeam";
    const DOC: &'static str = "Princeton beam experiment: a cantilever strip under a dead load at its tip, at an angle to its principal axes.";
    const SOURCE: &'static str = r#"pub model PrincetonBeam {
    /// Load at the tip.
    param load = 8.896 N;
    /// Angle of the load from the strip's wide side.
    param angle = 30 deg;
    /// Number of elements.
    param elements: count = 16;

    const length = 0.508 m;

    material aluminium { density = 2700 kg/m^3; young = 71.7 GPa; poisson = 0.31; }
    section strip = rectangle(y = 12.3777 mm, z = 3.2024 mm);

    body beam {
        spatial;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * beam(strip, aluminium);
    }
    joint root = clamp(beam.start, inertial);
    load weight = force(beam.end, [0 N, load * cos(angle), load * sin(angle)], in = inertial);

    /// Displacement of the tip along the strip.
    output tip_x = beam.end.x - length;
    /// Displacement of the tip along its wide side.
    output tip_y = beam.end.y;
    /// Displacement of the tip along its thin side.
    output tip_z = beam.end.z;

    run { t_end = 1 s; every = 1 ms; }
}"#;
    const EQUATIONS_HASH: u64 = 0x8cae99f946f8d7ba;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `beam_spatial`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1231 and 9765).",
        "Body `beam` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `beam` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: forces between two states that conserve energy are derived.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "BEAM_SPATIAL_MASS_MATRIX",
            size: [10, 10],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "beam_spatial_points3_force",
            additions: 33,
            multiplications: 70,
            divisions: 0,
            functions: 0,
            weighted: 103,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points3_tangent",
            additions: 69,
            multiplications: 156,
            divisions: 0,
            functions: 0,
            weighted: 225,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points3_energy",
            additions: 20,
            multiplications: 41,
            divisions: 0,
            functions: 0,
            weighted: 61,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points2_force",
            additions: 37,
            multiplications: 81,
            divisions: 1,
            functions: 0,
            weighted: 122,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points2_tangent",
            additions: 143,
            multiplications: 342,
            divisions: 1,
            functions: 0,
            weighted: 489,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points2_energy",
            additions: 19,
            multiplications: 49,
            divisions: 1,
            functions: 0,
            weighted: 72,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_mass",
            additions: 0,
            multiplications: 22,
            divisions: 0,
            functions: 0,
            weighted: 22,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_section_z_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_shapes_section_z_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_field_forces",
            additions: 130,
            multiplications: 197,
            divisions: 0,
            functions: 0,
            weighted: 327,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points3_conserving_force",
            additions: 60,
            multiplications: 103,
            divisions: 0,
            functions: 0,
            weighted: 163,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points3_conserving_tangent",
            additions: 123,
            multiplications: 252,
            divisions: 0,
            functions: 0,
            weighted: 375,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points2_conserving_force",
            additions: 70,
            multiplications: 126,
            divisions: 1,
            functions: 0,
            weighted: 200,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_points2_conserving_tangent",
            additions: 188,
            multiplications: 441,
            divisions: 1,
            functions: 0,
            weighted: 633,
        },
        ::rncf::model::KernelCount {
            name: "load_weight",
            additions: 0,
            multiplications: 2,
            divisions: 0,
            functions: 2,
            weighted: 42,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_position",
            additions: 15,
            multiplications: 19,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jacobian",
            additions: 3,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 1,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 1,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "load",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 8.896,
                doc: "Load at the tip.",
            },
            ::rncf::Param {
                name: "angle",
                kind: ::rncf::ParamKind::Quantity,
                unit: "deg",
                unit_si: 0.017453292519943295,
                dimension: [0, 0, 0, 0, 0, 1],
                default: 0.5235987755982988,
                doc: "Angle of the load from the strip's wide side.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 16.0,
                doc: "Number of elements.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "tip_x",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Displacement of the tip along the strip.",
            },
            ::rncf::Output {
                name: "tip_y",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Displacement of the tip along its wide side.",
            },
            ::rncf::Output {
                name: "tip_z",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Displacement of the tip along its thin side.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.load,
            1 => self.angle,
            2 => self.elements as f64,
            _ => panic!("PrincetonBeam has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.load = value,
            1 => self.angle = value,
            2 => self.elements = value as usize,
            _ => panic!("PrincetonBeam has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        princeton_beam_equations::run_defaults(self, &mut run);
        run
    }
    fn build_as(
        &self,
        formulation: ::rncf::Formulation,
        joints: ::rncf::Joints,
        fidelity: &[(::std::string::String, ::rncf::emitted::Fidelity)],
    ) -> ::std::result::Result<
        ::std::boxed::Box<dyn ::rncf::Scene>,
        ::rncf::ModelError,
    > {
        ::rncf::model::check_params(self)?;
        let equations = princeton_beam_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`PrincetonBeam`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod princeton_beam_equations {
    /// Princeton beam experiment: a cantilever strip under a dead load at its tip, at an angle to its principal axes.
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `beam_spatial`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1231 and 9765).
    /// * Body `beam` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `beam` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: forces between two states that conserve energy are derived.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct PrincetonBeam {
        /// Load at the tip. (SI; declared in N)
        pub load: f64,
        /// Angle of the load from the strip's wide side. (SI; declared in deg)
        pub angle: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `beam_spatial`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1231 and 9765).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatial {
        /// Length, m.
        pub length: f64,
        /// young * area, N.
        pub EA: f64,
        /// shear_factor_y * shear_modulus * area, N.
        pub kyGA: f64,
        /// shear_factor_z * shear_modulus * area, N.
        pub kzGA: f64,
        /// half_young * area, N.
        pub halfEA: f64,
        /// young * second_moment_z, N m^2.
        pub EIz: f64,
        /// young * second_moment_y, N m^2.
        pub EIy: f64,
        /// shear_modulus * torsion_constant, N m^2.
        pub GJ: f64,
        /// shear_modulus * second_moment_z, N m^2.
        pub GIz: f64,
        /// shear_modulus * second_moment_y, N m^2.
        pub GIy: f64,
        /// shear_modulus * quarter_polar_moment, N m^2.
        pub GIyz: f64,
        /// density * area, kg/m.
        pub rhoA: f64,
        /// density * second_moment_z, kg m.
        pub rhoIz: f64,
        /// density * second_moment_y, kg m.
        pub rhoIy: f64,
    }
    /// Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.
    ///
    /// Rows and columns: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z; slopes are multiplied by the length. The sum of a row's columns of positions is the first moment d_a.
    pub const BEAM_SPATIAL_MASS_MATRIX: [[f64; 10]; 10] = [
        [
            0.37142857142857144,
            0.05238095238095238,
            0.0,
            0.0,
            0.0,
            0.0,
            0.12857142857142856,
            -0.030952380952380953,
            0.0,
            0.0,
        ],
        [
            0.05238095238095238,
            0.009523809523809525,
            0.0,
            0.0,
            0.0,
            0.0,
            0.030952380952380953,
            -0.007142857142857143,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.13333333333333333,
            0.0,
            0.06666666666666667,
            0.0,
            0.0,
            0.0,
            -0.03333333333333333,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.13333333333333333,
            0.0,
            0.06666666666666667,
            0.0,
            0.0,
            0.0,
            -0.03333333333333333,
        ],
        [
            0.0,
            0.0,
            0.06666666666666667,
            0.0,
            0.5333333333333333,
            0.0,
            0.0,
            0.0,
            0.06666666666666667,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.06666666666666667,
            0.0,
            0.5333333333333333,
            0.0,
            0.0,
            0.0,
            0.06666666666666667,
        ],
        [
            0.12857142857142856,
            0.030952380952380953,
            0.0,
            0.0,
            0.0,
            0.0,
            0.37142857142857144,
            -0.05238095238095238,
            0.0,
            0.0,
        ],
        [
            -0.030952380952380953,
            -0.007142857142857143,
            0.0,
            0.0,
            0.0,
            0.0,
            -0.05238095238095238,
            0.009523809523809525,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            -0.03333333333333333,
            0.0,
            0.06666666666666667,
            0.0,
            0.0,
            0.0,
            0.13333333333333333,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            -0.03333333333333333,
            0.0,
            0.06666666666666667,
            0.0,
            0.0,
            0.0,
            0.13333333333333333,
        ],
    ];
    /// Nodal vectors by what they interpolate: Position, SectionY, SectionZ.
    static BEAM_SPATIAL_VECTORS: ::rncf::emitted::Vectors<10, 3, 3, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_POINTS3: ::rncf::emitted::Rule<3, 3, 3> = ::rncf::emitted::Rule {
        groups: [0, 1, 2],
        weights: [0.2777777777777776, 0.4444444444444444, 0.2777777777777776],
        shapes: [
            [
                [0.5872983346207417, 0.6, -0.18729833462074166],
                [0.6872983346207417, 0.39999999999999997, -0.08729833462074169],
                [0.6872983346207417, 0.39999999999999997, -0.08729833462074169],
            ],
            [[-0.25, 1.5, -0.25], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            [
                [-0.18729833462074175, 0.6, 0.5872983346207418],
                [-0.08729833462074166, 0.39999999999999997, 0.6872983346207417],
                [-0.08729833462074166, 0.39999999999999997, 0.6872983346207417],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 6> = BEAM_SPATIAL_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_POINTS2: ::rncf::emitted::Rule<2, 5, 3> = ::rncf::emitted::Rule {
        groups: [0, 1, 2, 1, 2],
        weights: [0.5000000000000001, 0.5000000000000001],
        shapes: [
            [
                [0.28867513459481287, 1.0, -0.2886751345948129],
                [0.4553418012614795, 0.6666666666666667, -0.12200846792814622],
                [0.4553418012614795, 0.6666666666666667, -0.12200846792814622],
                [-2.1547005383792515, 2.309401076758503, -0.15470053837925146],
                [-2.1547005383792515, 2.309401076758503, -0.15470053837925146],
            ],
            [
                [-0.2886751345948131, 1.0000000000000004, 0.28867513459481264],
                [-0.12200846792814612, 0.6666666666666667, 0.4553418012614795],
                [-0.12200846792814612, 0.6666666666666667, 0.4553418012614795],
                [0.15470053837925146, -2.309401076758503, 2.1547005383792515],
                [0.15470053837925146, -2.309401076758503, 2.1547005383792515],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<2, 9, 15> = BEAM_SPATIAL_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 3),
                (0, 4),
                (1, 1),
                (1, 3),
                (3, 1),
                (3, 3),
                (1, 2),
                (1, 4),
                (3, 2),
                (3, 4),
                (2, 2),
                (2, 4),
                (4, 2),
                (4, 4),
            ],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 7), (4, 7, 11), (5, 11, 15)],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_POINTS3_BETWEEN: ::rncf::emitted::Blocks<3, 9, 9> = BEAM_SPATIAL_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)],
            &[
                (0, 0, 1),
                (1, 1, 2),
                (2, 2, 3),
                (3, 3, 4),
                (4, 4, 5),
                (5, 5, 6),
                (6, 6, 7),
                (7, 7, 8),
                (8, 8, 9),
            ],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_POINTS2_BETWEEN: ::rncf::emitted::Blocks<2, 9, 21> = BEAM_SPATIAL_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 3),
                (0, 4),
                (3, 0),
                (1, 1),
                (1, 3),
                (3, 1),
                (3, 3),
                (1, 2),
                (1, 4),
                (3, 2),
                (3, 4),
                (4, 0),
                (2, 1),
                (2, 3),
                (4, 1),
                (4, 3),
                (2, 2),
                (2, 4),
                (4, 2),
                (4, 4),
            ],
            &[
                (0, 0, 1),
                (1, 1, 2),
                (2, 2, 3),
                (3, 3, 4),
                (4, 4, 8),
                (5, 8, 12),
                (6, 12, 13),
                (7, 13, 17),
                (8, 17, 21),
            ],
        );
    /// Writes the forces on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 33 additions, 70 multiplications.
    pub fn beam_spatial_points3_force(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t26 = length * EA;
        let t27 = 0.5 * (t26 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)));
        let t28 = (a_x * b_x + a_y * b_y + a_z * b_z) * (length * kyGA);
        let t29 = (a_x * c_x + a_y * c_y + a_z * c_z) * (length * kzGA);
        let t30 = 0.5 * (t26 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)));
        let t31 = (b_x * c_x + b_y * c_y + b_z * c_z) * (length * halfEA);
        let t32 = 0.5 * (t26 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)));
        forces[0][0] = t27 * (a_x * 2.0) + b_x * t28 + c_x * t29;
        forces[0][1] = t27 * (a_y * 2.0) + b_y * t28 + c_y * t29;
        forces[0][2] = t27 * (a_z * 2.0) + b_z * t28 + c_z * t29;
        forces[1][0] = a_x * t28 + t30 * (b_x * 2.0) + c_x * t31;
        forces[1][1] = a_y * t28 + t30 * (b_y * 2.0) + c_y * t31;
        forces[1][2] = a_z * t28 + t30 * (b_z * 2.0) + c_z * t31;
        forces[2][0] = a_x * t29 + b_x * t31 + t32 * (c_x * 2.0);
        forces[2][1] = a_y * t29 + b_y * t31 + t32 * (c_y * 2.0);
        forces[2][2] = a_z * t29 + b_z * t31 + t32 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 69 additions, 156 multiplications.
    pub fn beam_spatial_points3_tangent(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t26 = length * EA;
        let t27 = length * kyGA;
        let t28 = length * kzGA;
        let t29 = length * halfEA;
        let t30 = 0.5 * (0.5 * t26);
        let t31 = 0.5 * (t26 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)));
        let t32 = (a_x * b_x + a_y * b_y + a_z * b_z) * t27;
        let t33 = (a_x * c_x + a_y * c_y + a_z * c_z) * t28;
        let t34 = 0.5 * (t26 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)));
        let t35 = (b_x * c_x + b_y * c_y + b_z * c_z) * t29;
        let t36 = 0.5 * (t26 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)));
        let t37 = a_x * 2.0;
        let t38 = a_y * 2.0;
        let t39 = a_z * 2.0;
        let t40 = b_x * 2.0;
        let t41 = b_y * 2.0;
        let t42 = b_z * 2.0;
        let t43 = c_x * 2.0;
        let t44 = c_y * 2.0;
        let t45 = c_z * 2.0;
        let t46 = t30 * t38;
        let t47 = t30 * t39;
        let t48 = b_y * t27;
        let t49 = b_z * t27;
        let t50 = a_x * t27;
        let t51 = a_y * t27;
        let t52 = a_z * t27;
        let t53 = c_y * t28;
        let t54 = c_z * t28;
        let t55 = a_x * t28;
        let t56 = a_y * t28;
        let t57 = a_z * t28;
        let t58 = t30 * t41;
        let t59 = t30 * t42;
        let t60 = c_y * t29;
        let t61 = c_z * t29;
        let t62 = b_x * t29;
        let t63 = b_y * t29;
        let t64 = b_z * t29;
        let t65 = t30 * t44;
        let t66 = t30 * t45;
        let t67 = t37 * t46 + b_x * t48 + c_x * t53;
        let t68 = t37 * t47 + b_x * t49 + c_x * t54;
        let t69 = t38 * t47 + b_y * t49 + c_y * t54;
        let t70 = a_x * t51 + t40 * t58 + c_x * t60;
        let t71 = a_x * t52 + t40 * t59 + c_x * t61;
        let t72 = a_y * t52 + t41 * t59 + c_y * t61;
        let t73 = a_x * t56 + b_x * t63 + t43 * t65;
        let t74 = a_x * t57 + b_x * t64 + t43 * t66;
        let t75 = a_y * t57 + b_y * t64 + t44 * t66;
        let t76 = t31 * 2.0;
        let t77 = t37 * (t30 * t37) + b_x * (b_x * t27) + c_x * (c_x * t28) + t76;
        let t78 = t34 * 2.0;
        let t79 = t36 * 2.0;
        stiffness[0][0] = t77;
        stiffness[0][1] = t67;
        stiffness[0][2] = t68;
        stiffness[0][3] = t67;
        stiffness[0][4] = t38 * t46 + b_y * t48 + c_y * t53 + t76;
        stiffness[0][5] = t69;
        stiffness[0][6] = t68;
        stiffness[0][7] = t69;
        stiffness[0][8] = t39 * t47 + b_z * t49 + c_z * t54 + t76;
        stiffness[1][0] = t32 + b_x * t50;
        stiffness[1][1] = b_x * t51;
        stiffness[1][2] = b_x * t52;
        stiffness[1][3] = b_y * t50;
        stiffness[1][4] = t32 + b_y * t51;
        stiffness[1][5] = b_y * t52;
        stiffness[1][6] = b_z * t50;
        stiffness[1][7] = b_z * t51;
        stiffness[1][8] = t32 + b_z * t52;
        stiffness[2][0] = t33 + c_x * t55;
        stiffness[2][1] = c_x * t56;
        stiffness[2][2] = c_x * t57;
        stiffness[2][3] = c_y * t55;
        stiffness[2][4] = t33 + c_y * t56;
        stiffness[2][5] = c_y * t57;
        stiffness[2][6] = c_z * t55;
        stiffness[2][7] = c_z * t56;
        stiffness[2][8] = t33 + c_z * t57;
        stiffness[3][0] = a_x * t50 + t40 * (t30 * t40) + c_x * (c_x * t29) + t78;
        stiffness[3][1] = t70;
        stiffness[3][2] = t71;
        stiffness[3][3] = t70;
        stiffness[3][4] = a_y * t51 + t41 * t58 + c_y * t60 + t78;
        stiffness[3][5] = t72;
        stiffness[3][6] = t71;
        stiffness[3][7] = t72;
        stiffness[3][8] = a_z * t52 + t42 * t59 + c_z * t61 + t78;
        stiffness[4][0] = t35 + c_x * t62;
        stiffness[4][1] = c_x * t63;
        stiffness[4][2] = c_x * t64;
        stiffness[4][3] = c_y * t62;
        stiffness[4][4] = t35 + c_y * t63;
        stiffness[4][5] = c_y * t64;
        stiffness[4][6] = c_z * t62;
        stiffness[4][7] = c_z * t63;
        stiffness[4][8] = t35 + c_z * t64;
        stiffness[5][0] = a_x * t55 + b_x * t62 + t43 * (t30 * t43) + t79;
        stiffness[5][1] = t73;
        stiffness[5][2] = t74;
        stiffness[5][3] = t73;
        stiffness[5][4] = a_y * t56 + b_y * t63 + t44 * t65 + t79;
        stiffness[5][5] = t75;
        stiffness[5][6] = t74;
        stiffness[5][7] = t75;
        stiffness[5][8] = a_z * t57 + b_z * t64 + t45 * t66 + t79;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 20 additions, 41 multiplications.
    pub fn beam_spatial_points3_energy(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t26 = 0.5 * (length * EA);
        let t27 = t26 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)).powi(2);
        let t28 = t26 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)).powi(2);
        let t29 = t26 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)).powi(2);
        let t30 = 0.5 * (length * kyGA) * (a_x * b_x + a_y * b_y + a_z * b_z).powi(2);
        let t31 = 0.5 * (length * kzGA) * (a_x * c_x + a_y * c_y + a_z * c_z).powi(2);
        let t32 = 0.5 * (length * halfEA) * (b_x * c_x + b_y * c_y + b_z * c_z).powi(2);
        *energy = t27 + t28 + t29 + t30 + t31 + t32;
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 37 additions, 81 multiplications, 1 divisions.
    pub fn beam_spatial_points2_force(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t41 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t42 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t43 = length * GJ * (0.5 * (t42 - t41));
        let t44 = length * GIyz * (t41 + t42);
        let t45 = inverse_length
            * ((a_x * db_x + a_y * db_y + a_z * db_z) * (length * EIz));
        let t46 = inverse_length
            * ((a_x * dc_x + a_y * dc_y + a_z * dc_z) * (length * EIy));
        let t47 = inverse_length
            * ((b_x * db_x + b_y * db_y + b_z * db_z) * (length * GIz));
        let t48 = inverse_length * (-0.5 * t43 + t44);
        let t49 = inverse_length * (t44 + 0.5 * t43);
        let t50 = inverse_length
            * ((c_x * dc_x + c_y * dc_y + c_z * dc_z) * (length * GIy));
        forces[0][0] = unit_db_x * t45 + unit_dc_x * t46;
        forces[0][1] = unit_db_y * t45 + unit_dc_y * t46;
        forces[0][2] = unit_db_z * t45 + unit_dc_z * t46;
        forces[1][0] = unit_db_x * t47 + unit_dc_x * t48;
        forces[1][1] = unit_db_y * t47 + unit_dc_y * t48;
        forces[1][2] = unit_db_z * t47 + unit_dc_z * t48;
        forces[2][0] = unit_db_x * t49 + unit_dc_x * t50;
        forces[2][1] = unit_db_y * t49 + unit_dc_y * t50;
        forces[2][2] = unit_db_z * t49 + unit_dc_z * t50;
        forces[3][0] = a_x * t45 + b_x * t47 + c_x * t49;
        forces[3][1] = a_y * t45 + b_y * t47 + c_y * t49;
        forces[3][2] = a_z * t45 + b_z * t47 + c_z * t49;
        forces[4][0] = a_x * t46 + b_x * t48 + c_x * t50;
        forces[4][1] = a_y * t46 + b_y * t48 + c_y * t50;
        forces[4][2] = a_z * t46 + b_z * t48 + c_z * t50;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 143 additions, 342 multiplications, 1 divisions.
    pub fn beam_spatial_points2_tangent(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t41 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t42 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t43 = length * EIz;
        let t44 = length * EIy;
        let t45 = length * GJ;
        let t46 = 0.5 * t45;
        let t47 = length * GIz;
        let t48 = length * GIy;
        let t49 = length * GIyz;
        let t50 = t45 * (-0.5);
        let t51 = t45 * (0.5 * (t42 - t41));
        let t52 = t49 * (t41 + t42);
        let t53 = inverse_length * ((a_x * db_x + a_y * db_y + a_z * db_z) * t43);
        let t54 = inverse_length * inverse_length;
        let t55 = t43 * t54;
        let t56 = inverse_length * ((a_x * dc_x + a_y * dc_y + a_z * dc_z) * t44);
        let t57 = t44 * t54;
        let t58 = inverse_length * ((b_x * db_x + b_y * db_y + b_z * db_z) * t47);
        let t59 = t47 * t54;
        let t60 = inverse_length * (-0.5 * t51 + t52);
        let t61 = (t49 + (-0.5 * t50)) * t54;
        let t62 = (t49 + (-0.5 * t46)) * t54;
        let t63 = inverse_length * (t52 + 0.5 * t51);
        let t64 = (t49 + 0.5 * t50) * t54;
        let t65 = (t49 + 0.5 * t46) * t54;
        let t66 = inverse_length * ((c_x * dc_x + c_y * dc_y + c_z * dc_z) * t48);
        let t67 = t48 * t54;
        let t68 = unit_db_x * t55;
        let t69 = unit_db_y * t55;
        let t70 = unit_db_z * t55;
        let t71 = a_x * t55;
        let t72 = a_y * t55;
        let t73 = a_z * t55;
        let t74 = unit_dc_x * t57;
        let t75 = unit_dc_y * t57;
        let t76 = unit_dc_z * t57;
        let t77 = a_x * t57;
        let t78 = a_y * t57;
        let t79 = a_z * t57;
        let t80 = unit_db_x * t59;
        let t81 = unit_db_y * t59;
        let t82 = unit_db_z * t59;
        let t83 = b_x * t59;
        let t84 = b_y * t59;
        let t85 = b_z * t59;
        let t86 = unit_dc_x * t61;
        let t87 = unit_dc_y * t61;
        let t88 = unit_dc_z * t61;
        let t89 = unit_db_x * t62;
        let t90 = unit_db_y * t62;
        let t91 = unit_db_z * t62;
        let t92 = c_x * t62;
        let t93 = c_y * t62;
        let t94 = c_z * t62;
        let t95 = b_x * t61;
        let t96 = b_y * t61;
        let t97 = b_z * t61;
        let t98 = unit_dc_x * t64;
        let t99 = unit_dc_y * t64;
        let t100 = unit_dc_z * t64;
        let t101 = unit_db_x * t65;
        let t102 = unit_db_y * t65;
        let t103 = unit_db_z * t65;
        let t104 = c_x * t65;
        let t105 = c_y * t65;
        let t106 = c_z * t65;
        let t107 = b_x * t64;
        let t108 = b_y * t64;
        let t109 = b_z * t64;
        let t110 = unit_dc_x * t67;
        let t111 = unit_dc_y * t67;
        let t112 = unit_dc_z * t67;
        let t113 = c_x * t67;
        let t114 = c_y * t67;
        let t115 = c_z * t67;
        stiffness[0][0] = unit_db_x * t68 + unit_dc_x * t74;
        stiffness[0][1] = unit_db_x * t69 + unit_dc_x * t75;
        stiffness[0][2] = unit_db_x * t70 + unit_dc_x * t76;
        stiffness[0][3] = unit_db_y * t68 + unit_dc_y * t74;
        stiffness[0][4] = unit_db_y * t69 + unit_dc_y * t75;
        stiffness[0][5] = unit_db_y * t70 + unit_dc_y * t76;
        stiffness[0][6] = unit_db_z * t68 + unit_dc_z * t74;
        stiffness[0][7] = unit_db_z * t69 + unit_dc_z * t75;
        stiffness[0][8] = unit_db_z * t70 + unit_dc_z * t76;
        stiffness[1][0] = t53 + unit_db_x * t71;
        stiffness[1][1] = unit_db_x * t72;
        stiffness[1][2] = unit_db_x * t73;
        stiffness[1][3] = unit_db_y * t71;
        stiffness[1][4] = t53 + unit_db_y * t72;
        stiffness[1][5] = unit_db_y * t73;
        stiffness[1][6] = unit_db_z * t71;
        stiffness[1][7] = unit_db_z * t72;
        stiffness[1][8] = t53 + unit_db_z * t73;
        stiffness[2][0] = t56 + unit_dc_x * t77;
        stiffness[2][1] = unit_dc_x * t78;
        stiffness[2][2] = unit_dc_x * t79;
        stiffness[2][3] = unit_dc_y * t77;
        stiffness[2][4] = t56 + unit_dc_y * t78;
        stiffness[2][5] = unit_dc_y * t79;
        stiffness[2][6] = unit_dc_z * t77;
        stiffness[2][7] = unit_dc_z * t78;
        stiffness[2][8] = t56 + unit_dc_z * t79;
        stiffness[3][0] = unit_db_x * t80 + unit_dc_x * t86;
        stiffness[3][1] = unit_db_x * t81 + unit_dc_x * t87;
        stiffness[3][2] = unit_db_x * t82 + unit_dc_x * t88;
        stiffness[3][3] = unit_db_y * t80 + unit_dc_y * t86;
        stiffness[3][4] = unit_db_y * t81 + unit_dc_y * t87;
        stiffness[3][5] = unit_db_y * t82 + unit_dc_y * t88;
        stiffness[3][6] = unit_db_z * t80 + unit_dc_z * t86;
        stiffness[3][7] = unit_db_z * t81 + unit_dc_z * t87;
        stiffness[3][8] = unit_db_z * t82 + unit_dc_z * t88;
        stiffness[4][0] = t58 + (unit_db_x * t83 + unit_dc_x * t92);
        stiffness[4][1] = unit_db_x * t84 + unit_dc_x * t93;
        stiffness[4][2] = unit_db_x * t85 + unit_dc_x * t94;
        stiffness[4][3] = unit_db_y * t83 + unit_dc_y * t92;
        stiffness[4][4] = t58 + (unit_db_y * t84 + unit_dc_y * t93);
        stiffness[4][5] = unit_db_y * t85 + unit_dc_y * t94;
        stiffness[4][6] = unit_db_z * t83 + unit_dc_z * t92;
        stiffness[4][7] = unit_db_z * t84 + unit_dc_z * t93;
        stiffness[4][8] = t58 + (unit_db_z * t85 + unit_dc_z * t94);
        stiffness[5][0] = t58 + (b_x * t80 + c_x * t98);
        stiffness[5][1] = b_x * t81 + c_x * t99;
        stiffness[5][2] = b_x * t82 + c_x * t100;
        stiffness[5][3] = b_y * t80 + c_y * t98;
        stiffness[5][4] = t58 + (b_y * t81 + c_y * t99);
        stiffness[5][5] = b_y * t82 + c_y * t100;
        stiffness[5][6] = b_z * t80 + c_z * t98;
        stiffness[5][7] = b_z * t81 + c_z * t99;
        stiffness[5][8] = t58 + (b_z * t82 + c_z * t100);
        stiffness[6][0] = a_x * t71 + b_x * t83 + c_x * t104;
        stiffness[6][1] = a_x * t72 + b_x * t84 + c_x * t105;
        stiffness[6][2] = a_x * t73 + b_x * t85 + c_x * t106;
        stiffness[6][3] = a_y * t71 + b_y * t83 + c_y * t104;
        stiffness[6][4] = a_y * t72 + b_y * t84 + c_y * t105;
        stiffness[6][5] = a_y * t73 + b_y * t85 + c_y * t106;
        stiffness[6][6] = a_z * t71 + b_z * t83 + c_z * t104;
        stiffness[6][7] = a_z * t72 + b_z * t84 + c_z * t105;
        stiffness[6][8] = a_z * t73 + b_z * t85 + c_z * t106;
        stiffness[7][0] = unit_dc_x * t89;
        stiffness[7][1] = unit_dc_x * t90;
        stiffness[7][2] = unit_dc_x * t91;
        stiffness[7][3] = unit_dc_y * t89;
        stiffness[7][4] = unit_dc_y * t90;
        stiffness[7][5] = unit_dc_y * t91;
        stiffness[7][6] = unit_dc_z * t89;
        stiffness[7][7] = unit_dc_z * t90;
        stiffness[7][8] = unit_dc_z * t91;
        stiffness[8][0] = t60 + unit_dc_x * t95;
        stiffness[8][1] = unit_dc_x * t96;
        stiffness[8][2] = unit_dc_x * t97;
        stiffness[8][3] = unit_dc_y * t95;
        stiffness[8][4] = t60 + unit_dc_y * t96;
        stiffness[8][5] = unit_dc_y * t97;
        stiffness[8][6] = unit_dc_z * t95;
        stiffness[8][7] = unit_dc_z * t96;
        stiffness[8][8] = t60 + unit_dc_z * t97;
        stiffness[9][0] = t63 + c_x * t101;
        stiffness[9][1] = c_x * t102;
        stiffness[9][2] = c_x * t103;
        stiffness[9][3] = c_y * t101;
        stiffness[9][4] = t63 + c_y * t102;
        stiffness[9][5] = c_y * t103;
        stiffness[9][6] = c_z * t101;
        stiffness[9][7] = c_z * t102;
        stiffness[9][8] = t63 + c_z * t103;
        stiffness[10][0] = c_x * t107;
        stiffness[10][1] = c_x * t108;
        stiffness[10][2] = c_x * t109;
        stiffness[10][3] = c_y * t107;
        stiffness[10][4] = c_y * t108;
        stiffness[10][5] = c_y * t109;
        stiffness[10][6] = c_z * t107;
        stiffness[10][7] = c_z * t108;
        stiffness[10][8] = c_z * t109;
        stiffness[11][0] = unit_db_x * t101 + unit_dc_x * t110;
        stiffness[11][1] = unit_db_x * t102 + unit_dc_x * t111;
        stiffness[11][2] = unit_db_x * t103 + unit_dc_x * t112;
        stiffness[11][3] = unit_db_y * t101 + unit_dc_y * t110;
        stiffness[11][4] = unit_db_y * t102 + unit_dc_y * t111;
        stiffness[11][5] = unit_db_y * t103 + unit_dc_y * t112;
        stiffness[11][6] = unit_db_z * t101 + unit_dc_z * t110;
        stiffness[11][7] = unit_db_z * t102 + unit_dc_z * t111;
        stiffness[11][8] = unit_db_z * t103 + unit_dc_z * t112;
        stiffness[12][0] = t66 + (unit_db_x * t107 + unit_dc_x * t113);
        stiffness[12][1] = unit_db_x * t108 + unit_dc_x * t114;
        stiffness[12][2] = unit_db_x * t109 + unit_dc_x * t115;
        stiffness[12][3] = unit_db_y * t107 + unit_dc_y * t113;
        stiffness[12][4] = t66 + (unit_db_y * t108 + unit_dc_y * t114);
        stiffness[12][5] = unit_db_y * t109 + unit_dc_y * t115;
        stiffness[12][6] = unit_db_z * t107 + unit_dc_z * t113;
        stiffness[12][7] = unit_db_z * t108 + unit_dc_z * t114;
        stiffness[12][8] = t66 + (unit_db_z * t109 + unit_dc_z * t115);
        stiffness[13][0] = t66 + (b_x * t89 + c_x * t110);
        stiffness[13][1] = b_x * t90 + c_x * t111;
        stiffness[13][2] = b_x * t91 + c_x * t112;
        stiffness[13][3] = b_y * t89 + c_y * t110;
        stiffness[13][4] = t66 + (b_y * t90 + c_y * t111);
        stiffness[13][5] = b_y * t91 + c_y * t112;
        stiffness[13][6] = b_z * t89 + c_z * t110;
        stiffness[13][7] = b_z * t90 + c_z * t111;
        stiffness[13][8] = t66 + (b_z * t91 + c_z * t112);
        stiffness[14][0] = a_x * t77 + b_x * t95 + c_x * t113;
        stiffness[14][1] = a_x * t78 + b_x * t96 + c_x * t114;
        stiffness[14][2] = a_x * t79 + b_x * t97 + c_x * t115;
        stiffness[14][3] = a_y * t77 + b_y * t95 + c_y * t113;
        stiffness[14][4] = a_y * t78 + b_y * t96 + c_y * t114;
        stiffness[14][5] = a_y * t79 + b_y * t97 + c_y * t115;
        stiffness[14][6] = a_z * t77 + b_z * t95 + c_z * t113;
        stiffness[14][7] = a_z * t78 + b_z * t96 + c_z * t114;
        stiffness[14][8] = a_z * t79 + b_z * t97 + c_z * t115;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 19 additions, 49 multiplications, 1 divisions.
    pub fn beam_spatial_points2_energy(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t41 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t42 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t43 = 0.5 * (length * EIz) * (a_x * db_x + a_y * db_y + a_z * db_z).powi(2);
        let t44 = 0.5 * (length * EIy) * (a_x * dc_x + a_y * dc_y + a_z * dc_z).powi(2);
        let t45 = 0.5 * (length * GIz) * (b_x * db_x + b_y * db_y + b_z * db_z).powi(2);
        let t46 = t43 + t44 + 0.5 * (length * GJ) * (0.5 * (t42 - t41)).powi(2) + t45;
        let t47 = 0.5 * (length * GIy) * (c_x * dc_x + c_y * dc_y + c_z * dc_z).powi(2);
        *energy = t46 + t47 + 0.5 * (length * GIyz) * (t41 + t42).powi(2);
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 515 additions, 714 multiplications, 2 divisions.
    pub fn beam_spatial_elastic_force(
        row: &BeamSpatial,
        q: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_SPATIAL_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_points3_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_points2_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 4552 additions, 5211 multiplications, 2 divisions.
    pub fn beam_spatial_elastic_tangent(
        row: &BeamSpatial,
        q: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_POINTS3
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_points3_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_POINTS2
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_points2_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 274 additions, 397 multiplications, 2 divisions.
    pub fn beam_spatial_strain_energy(
        row: &BeamSpatial,
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_points3_energy(row, fields, &mut density);
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_points2_energy(row, fields, &mut density);
                        density
                    },
                );
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_mass(row: &BeamSpatial, mass: &mut [f64; 100]) {
        let BeamSpatial { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let mass_r0_r0 = element_mass * BEAM_SPATIAL_MASS_MATRIX[0][0];
        let t20 = length * element_mass;
        let mass_r0_r0x = t20 * BEAM_SPATIAL_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * BEAM_SPATIAL_MASS_MATRIX[0][6];
        let mass_r0_r1x = t20 * BEAM_SPATIAL_MASS_MATRIX[0][7];
        let t24 = element_mass * (length * length);
        let mass_r0x_r0x = t24 * BEAM_SPATIAL_MASS_MATRIX[1][1];
        let mass_r0x_r1 = t20 * BEAM_SPATIAL_MASS_MATRIX[1][6];
        let mass_r0x_r1x = t24 * BEAM_SPATIAL_MASS_MATRIX[1][7];
        let mass_r0y_r0y = section_y_mass * BEAM_SPATIAL_MASS_MATRIX[2][2];
        let mass_r0y_ry_half = section_y_mass * BEAM_SPATIAL_MASS_MATRIX[2][4];
        let mass_r0y_r1y = section_y_mass * BEAM_SPATIAL_MASS_MATRIX[2][8];
        let mass_r0z_r0z = section_z_mass * BEAM_SPATIAL_MASS_MATRIX[2][2];
        let mass_r0z_rz_half = section_z_mass * BEAM_SPATIAL_MASS_MATRIX[2][4];
        let mass_r0z_r1z = section_z_mass * BEAM_SPATIAL_MASS_MATRIX[2][8];
        let mass_ry_half_ry_half = section_y_mass * BEAM_SPATIAL_MASS_MATRIX[4][4];
        let mass_rz_half_rz_half = section_z_mass * BEAM_SPATIAL_MASS_MATRIX[4][4];
        let mass_r1_r1x = t20 * BEAM_SPATIAL_MASS_MATRIX[6][7];
        mass[0] = mass_r0_r0;
        mass[1] = mass_r0_r0x;
        mass[2] = 0.0;
        mass[3] = 0.0;
        mass[4] = 0.0;
        mass[5] = 0.0;
        mass[6] = mass_r0_r1;
        mass[7] = mass_r0_r1x;
        mass[8] = 0.0;
        mass[9] = 0.0;
        mass[10] = mass_r0_r0x;
        mass[11] = mass_r0x_r0x;
        mass[12] = 0.0;
        mass[13] = 0.0;
        mass[14] = 0.0;
        mass[15] = 0.0;
        mass[16] = mass_r0x_r1;
        mass[17] = mass_r0x_r1x;
        mass[18] = 0.0;
        mass[19] = 0.0;
        mass[20] = 0.0;
        mass[21] = 0.0;
        mass[22] = mass_r0y_r0y;
        mass[23] = 0.0;
        mass[24] = mass_r0y_ry_half;
        mass[25] = 0.0;
        mass[26] = 0.0;
        mass[27] = 0.0;
        mass[28] = mass_r0y_r1y;
        mass[29] = 0.0;
        mass[30] = 0.0;
        mass[31] = 0.0;
        mass[32] = 0.0;
        mass[33] = mass_r0z_r0z;
        mass[34] = 0.0;
        mass[35] = mass_r0z_rz_half;
        mass[36] = 0.0;
        mass[37] = 0.0;
        mass[38] = 0.0;
        mass[39] = mass_r0z_r1z;
        mass[40] = 0.0;
        mass[41] = 0.0;
        mass[42] = mass_r0y_ry_half;
        mass[43] = 0.0;
        mass[44] = mass_ry_half_ry_half;
        mass[45] = 0.0;
        mass[46] = 0.0;
        mass[47] = 0.0;
        mass[48] = mass_r0y_ry_half;
        mass[49] = 0.0;
        mass[50] = 0.0;
        mass[51] = 0.0;
        mass[52] = 0.0;
        mass[53] = mass_r0z_rz_half;
        mass[54] = 0.0;
        mass[55] = mass_rz_half_rz_half;
        mass[56] = 0.0;
        mass[57] = 0.0;
        mass[58] = 0.0;
        mass[59] = mass_r0z_rz_half;
        mass[60] = mass_r0_r1;
        mass[61] = mass_r0x_r1;
        mass[62] = 0.0;
        mass[63] = 0.0;
        mass[64] = 0.0;
        mass[65] = 0.0;
        mass[66] = mass_r0_r0;
        mass[67] = mass_r1_r1x;
        mass[68] = 0.0;
        mass[69] = 0.0;
        mass[70] = mass_r0_r1x;
        mass[71] = mass_r0x_r1x;
        mass[72] = 0.0;
        mass[73] = 0.0;
        mass[74] = 0.0;
        mass[75] = 0.0;
        mass[76] = mass_r1_r1x;
        mass[77] = mass_r0x_r0x;
        mass[78] = 0.0;
        mass[79] = 0.0;
        mass[80] = 0.0;
        mass[81] = 0.0;
        mass[82] = mass_r0y_r1y;
        mass[83] = 0.0;
        mass[84] = mass_r0y_ry_half;
        mass[85] = 0.0;
        mass[86] = 0.0;
        mass[87] = 0.0;
        mass[88] = mass_r0y_r0y;
        mass[89] = 0.0;
        mass[90] = 0.0;
        mass[91] = 0.0;
        mass[92] = 0.0;
        mass[93] = mass_r0z_r1z;
        mass[94] = 0.0;
        mass[95] = mass_r0z_rz_half;
        mass[96] = 0.0;
        mass[97] = 0.0;
        mass[98] = 0.0;
        mass[99] = mass_r0z_r0z;
    }
    /// Weights of the nodal vectors in the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 6 additions, 12 multiplications.
    pub fn beam_spatial_shapes_position_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[6] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[7] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn beam_spatial_shapes_position_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = 1.0 / length;
        let t15 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t14;
        weights[1] = 1.0 + xi * (-4.0 + t15);
        weights[6] = t14 * (xi * (6.0 + xi * (-6.0)));
        weights[7] = xi * (t15 + (-2.0));
    }
    /// Weights of the nodal vectors in the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_shapes_section_y_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t13 = xi * 2.0;
        weights[2] = 1.0 + xi * (-3.0 + t13);
        weights[4] = xi * (4.0 + xi * (-4.0));
        weights[8] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_shapes_section_y_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[2] = (-3.0 + t14) * t15;
        weights[4] = t15 * (4.0 + xi * (-8.0));
        weights[8] = t15 * (t14 + (-1.0));
    }
    /// Weights of the nodal vectors in the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_shapes_section_z_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t13 = xi * 2.0;
        weights[3] = 1.0 + xi * (-3.0 + t13);
        weights[5] = xi * (4.0 + xi * (-4.0));
        weights[9] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_shapes_section_z_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[3] = (-3.0 + t14) * t15;
        weights[5] = t15 * (4.0 + xi * (-8.0));
        weights[9] = t15 * (t14 + (-1.0));
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point, dU/d(field) per unit length, from their values in the stress-free shape and at present.
    ///
    /// Operations: 130 additions, 197 multiplications.
    pub fn beam_spatial_field_forces(
        row: &BeamSpatial,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let t52 = fields[3] * fields[12] + fields[4] * fields[13]
            + fields[5] * fields[14];
        let t53 = fields[6] * fields[9] + fields[7] * fields[10]
            + fields[8] * fields[11];
        let t54 = 0.5
            * (fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
                - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t55 = EA * t54;
        let t56 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0)
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t57 = EA * t56;
        let t58 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0)
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t59 = EA * t58;
        let t60 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5]
            - (stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
                + stress_free[2] * stress_free[5]);
        let t61 = kyGA * t60;
        let t62 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8]
            - (stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
                + stress_free[2] * stress_free[8]);
        let t63 = kzGA * t62;
        let t64 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t65 = halfEA * t64;
        let t66 = fields[0] * fields[9] + fields[1] * fields[10] + fields[2] * fields[11]
            - (stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11]);
        let t67 = EIz * t66;
        let t68 = t55 * (0.5 * (fields[0] * 2.0)) + fields[3] * t61 + fields[6] * t63
            + fields[9] * t67;
        let t69 = t55 * (0.5 * (fields[1] * 2.0)) + fields[4] * t61 + fields[7] * t63
            + fields[10] * t67;
        let t70 = t55 * (0.5 * (fields[2] * 2.0)) + fields[5] * t61 + fields[8] * t63
            + fields[11] * t67;
        let t71 = fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14]
            - (stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14]);
        let t72 = EIy * t71;
        let t73 = stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
            + stress_free[5] * stress_free[14];
        let t74 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11];
        let t75 = GJ * (0.5 * (t53 - t52) - 0.5 * (t74 - t73));
        let t76 = t57 * (0.5 * (fields[3] * 2.0)) + fields[0] * t61 + fields[6] * t65
            - t75 * (fields[12] * 0.5);
        let t77 = t57 * (0.5 * (fields[4] * 2.0)) + fields[1] * t61 + fields[7] * t65
            - t75 * (fields[13] * 0.5);
        let t78 = t57 * (0.5 * (fields[5] * 2.0)) + fields[2] * t61 + fields[8] * t65
            - t75 * (fields[14] * 0.5);
        let t79 = t59 * (0.5 * (fields[6] * 2.0)) + fields[0] * t63 + fields[3] * t65
            + t75 * (fields[9] * 0.5);
        let t80 = t59 * (0.5 * (fields[7] * 2.0)) + fields[1] * t63 + fields[4] * t65
            + t75 * (fields[10] * 0.5);
        let t81 = t59 * (0.5 * (fields[8] * 2.0)) + fields[2] * t63 + fields[5] * t65
            + t75 * (fields[11] * 0.5);
        let t82 = fields[3] * fields[9] + fields[4] * fields[10] + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t83 = GIz * t82;
        let t84 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t85 = GIy * t84;
        let t86 = GIyz * (t52 + t53 - (t73 + t74));
        forces[0] = t68 + fields[12] * t72;
        forces[1] = t69 + fields[13] * t72;
        forces[2] = t70 + fields[14] * t72;
        forces[3] = t76 + fields[9] * t83 + fields[12] * t86;
        forces[4] = t77 + fields[10] * t83 + fields[13] * t86;
        forces[5] = t78 + fields[11] * t83 + fields[14] * t86;
        forces[6] = t79 + fields[12] * t85 + fields[9] * t86;
        forces[7] = t80 + fields[13] * t85 + fields[10] * t86;
        forces[8] = t81 + fields[14] * t85 + fields[11] * t86;
        forces[9] = fields[0] * t67 + t75 * (fields[6] * 0.5) + fields[3] * t83
            + fields[6] * t86;
        forces[10] = fields[1] * t67 + t75 * (fields[7] * 0.5) + fields[4] * t83
            + fields[7] * t86;
        forces[11] = fields[2] * t67 + t75 * (fields[8] * 0.5) + fields[5] * t83
            + fields[8] * t86;
        forces[12] = fields[0] * t72 - t75 * (fields[3] * 0.5) + fields[6] * t85
            + fields[3] * t86;
        forces[13] = fields[1] * t72 - t75 * (fields[4] * 0.5) + fields[7] * t85
            + fields[4] * t86;
        forces[14] = fields[2] * t72 - t75 * (fields[5] * 0.5) + fields[8] * t85
            + fields[5] * t86;
    }
    /// Writes the conserving forces on the fields a, b, c at a point of weight one on the unit element between two states, for the terms that are integrated at 3 Gauss points.
    ///
    /// Operations: 60 additions, 103 multiplications.
    pub fn beam_spatial_points3_conserving_force(
        row: &BeamSpatial,
        start: &[[f64; 3]; 3],
        end: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[o_a_x, o_a_y, o_a_z], [o_b_x, o_b_y, o_b_z], [o_c_x, o_c_y, o_c_z]] = *start;
        let [[e_a_x, e_a_y, e_a_z], [e_b_x, e_b_y, e_b_z], [e_c_x, e_c_y, e_c_z]] = *end;
        let t35 = 0.5 * (o_a_x + e_a_x);
        let t36 = 0.5 * (o_a_y + e_a_y);
        let t37 = 0.5 * (o_a_z + e_a_z);
        let t38 = 0.5 * (o_b_x + e_b_x);
        let t39 = 0.5 * (o_b_y + e_b_y);
        let t40 = 0.5 * (o_b_z + e_b_z);
        let t41 = 0.5 * (o_c_x + e_c_x);
        let t42 = 0.5 * (o_c_y + e_c_y);
        let t43 = 0.5 * (o_c_z + e_c_z);
        let t44 = o_a_x * o_a_x + o_a_y * o_a_y + o_a_z * o_a_z
            + (e_a_x * e_a_x + e_a_y * e_a_y + e_a_z * e_a_z);
        let t45 = o_a_x * o_b_x + o_a_y * o_b_y + o_a_z * o_b_z
            + (e_a_x * e_b_x + e_a_y * e_b_y + e_a_z * e_b_z);
        let t46 = o_a_x * o_c_x + o_a_y * o_c_y + o_a_z * o_c_z
            + (e_a_x * e_c_x + e_a_y * e_c_y + e_a_z * e_c_z);
        let t47 = o_b_x * o_b_x + o_b_y * o_b_y + o_b_z * o_b_z
            + (e_b_x * e_b_x + e_b_y * e_b_y + e_b_z * e_b_z);
        let t48 = o_b_x * o_c_x + o_b_y * o_c_y + o_b_z * o_c_z
            + (e_b_x * e_c_x + e_b_y * e_c_y + e_b_z * e_c_z);
        let t49 = o_c_x * o_c_x + o_c_y * o_c_y + o_c_z * o_c_z
            + (e_c_x * e_c_x + e_c_y * e_c_y + e_c_z * e_c_z);
        let t50 = length * EA;
        let t51 = 0.5 * (t50 * (0.5 * (0.5 * t44 - 1.0)));
        let t52 = 0.5 * t45 * (length * kyGA);
        let t53 = 0.5 * t46 * (length * kzGA);
        let t54 = 0.5 * (t50 * (0.5 * (0.5 * t47 - 1.0)));
        let t55 = 0.5 * t48 * (length * halfEA);
        let t56 = 0.5 * (t50 * (0.5 * (0.5 * t49 - 1.0)));
        forces[0][0] = t51 * (t35 * 2.0) + t38 * t52 + t41 * t53;
        forces[0][1] = t51 * (t36 * 2.0) + t39 * t52 + t42 * t53;
        forces[0][2] = t51 * (t37 * 2.0) + t40 * t52 + t43 * t53;
        forces[1][0] = t35 * t52 + t54 * (t38 * 2.0) + t41 * t55;
        forces[1][1] = t36 * t52 + t54 * (t39 * 2.0) + t42 * t55;
        forces[1][2] = t37 * t52 + t54 * (t40 * 2.0) + t43 * t55;
        forces[2][0] = t35 * t53 + t38 * t55 + t56 * (t41 * 2.0);
        forces[2][1] = t36 * t53 + t39 * t55 + t56 * (t42 * 2.0);
        forces[2][2] = t37 * t53 + t40 * t55 + t56 * (t43 * 2.0);
    }
    /// Writes the blocks of the derivative by the mean of both states on the fields a, b, c at a point of weight one on the unit element between two states, for the terms that are integrated at 3 Gauss points.
    ///
    /// Operations: 123 additions, 252 multiplications.
    pub fn beam_spatial_points3_conserving_tangent(
        row: &BeamSpatial,
        start: &[[f64; 3]; 3],
        end: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 9],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[o_a_x, o_a_y, o_a_z], [o_b_x, o_b_y, o_b_z], [o_c_x, o_c_y, o_c_z]] = *start;
        let [[e_a_x, e_a_y, e_a_z], [e_b_x, e_b_y, e_b_z], [e_c_x, e_c_y, e_c_z]] = *end;
        let t35 = 0.5 * (o_a_x + e_a_x);
        let t36 = 0.5 * (o_a_y + e_a_y);
        let t37 = 0.5 * (o_a_z + e_a_z);
        let t38 = 0.5 * (o_b_x + e_b_x);
        let t39 = 0.5 * (o_b_y + e_b_y);
        let t40 = 0.5 * (o_b_z + e_b_z);
        let t41 = 0.5 * (o_c_x + e_c_x);
        let t42 = 0.5 * (o_c_y + e_c_y);
        let t43 = 0.5 * (o_c_z + e_c_z);
        let t44 = o_a_x * o_a_x + o_a_y * o_a_y + o_a_z * o_a_z
            + (e_a_x * e_a_x + e_a_y * e_a_y + e_a_z * e_a_z);
        let t45 = o_a_x * o_b_x + o_a_y * o_b_y + o_a_z * o_b_z
            + (e_a_x * e_b_x + e_a_y * e_b_y + e_a_z * e_b_z);
        let t46 = o_a_x * o_c_x + o_a_y * o_c_y + o_a_z * o_c_z
            + (e_a_x * e_c_x + e_a_y * e_c_y + e_a_z * e_c_z);
        let t47 = o_b_x * o_b_x + o_b_y * o_b_y + o_b_z * o_b_z
            + (e_b_x * e_b_x + e_b_y * e_b_y + e_b_z * e_b_z);
        let t48 = o_b_x * o_c_x + o_b_y * o_c_y + o_b_z * o_c_z
            + (e_b_x * e_c_x + e_b_y * e_c_y + e_b_z * e_c_z);
        let t49 = o_c_x * o_c_x + o_c_y * o_c_y + o_c_z * o_c_z
            + (e_c_x * e_c_x + e_c_y * e_c_y + e_c_z * e_c_z);
        let t50 = length * EA;
        let t51 = length * kyGA;
        let t52 = length * kzGA;
        let t53 = length * halfEA;
        let t54 = 0.5 * (0.5 * t50);
        let t55 = 0.5 * t45 * t51;
        let t56 = 0.5 * t46 * t52;
        let t57 = 0.5 * t48 * t53;
        let t58 = t35 * 2.0;
        let t59 = t36 * 2.0;
        let t60 = t37 * 2.0;
        let t61 = t38 * 2.0;
        let t62 = t39 * 2.0;
        let t63 = t40 * 2.0;
        let t64 = t41 * 2.0;
        let t65 = t42 * 2.0;
        let t66 = t43 * 2.0;
        let t67 = t54 * (e_a_x * 2.0);
        let t68 = t54 * (e_a_y * 2.0);
        let t69 = t54 * (e_a_z * 2.0);
        let t70 = e_b_x * t51;
        let t71 = e_b_y * t51;
        let t72 = e_b_z * t51;
        let t73 = e_a_x * t51;
        let t74 = e_a_y * t51;
        let t75 = e_a_z * t51;
        let t76 = e_c_x * t52;
        let t77 = e_c_y * t52;
        let t78 = e_c_z * t52;
        let t79 = e_a_x * t52;
        let t80 = e_a_y * t52;
        let t81 = e_a_z * t52;
        let t82 = t54 * (e_b_x * 2.0);
        let t83 = t54 * (e_b_y * 2.0);
        let t84 = t54 * (e_b_z * 2.0);
        let t85 = e_c_x * t53;
        let t86 = e_c_y * t53;
        let t87 = e_c_z * t53;
        let t88 = e_b_x * t53;
        let t89 = e_b_y * t53;
        let t90 = e_b_z * t53;
        let t91 = t54 * (e_c_x * 2.0);
        let t92 = t54 * (e_c_y * 2.0);
        let t93 = t54 * (e_c_z * 2.0);
        let t94 = 0.5 * (t50 * (0.5 * (0.5 * t44 - 1.0))) * 2.0;
        let t95 = 0.5 * (t50 * (0.5 * (0.5 * t47 - 1.0))) * 2.0;
        let t96 = 0.5 * (t50 * (0.5 * (0.5 * t49 - 1.0))) * 2.0;
        stiffness[0][0] = t58 * t67 + t38 * t70 + t41 * t76 + t94;
        stiffness[0][1] = t58 * t68 + t38 * t71 + t41 * t77;
        stiffness[0][2] = t58 * t69 + t38 * t72 + t41 * t78;
        stiffness[0][3] = t59 * t67 + t39 * t70 + t42 * t76;
        stiffness[0][4] = t59 * t68 + t39 * t71 + t42 * t77 + t94;
        stiffness[0][5] = t59 * t69 + t39 * t72 + t42 * t78;
        stiffness[0][6] = t60 * t67 + t40 * t70 + t43 * t76;
        stiffness[0][7] = t60 * t68 + t40 * t71 + t43 * t77;
        stiffness[0][8] = t60 * t69 + t40 * t72 + t43 * t78 + t94;
        stiffness[1][0] = t55 + t38 * t73;
        stiffness[1][1] = t38 * t74;
        stiffness[1][2] = t38 * t75;
        stiffness[1][3] = t39 * t73;
        stiffness[1][4] = t55 + t39 * t74;
        stiffness[1][5] = t39 * t75;
        stiffness[1][6] = t40 * t73;
        stiffness[1][7] = t40 * t74;
        stiffness[1][8] = t55 + t40 * t75;
        stiffness[2][0] = t56 + t41 * t79;
        stiffness[2][1] = t41 * t80;
        stiffness[2][2] = t41 * t81;
        stiffness[2][3] = t42 * t79;
        stiffness[2][4] = t56 + t42 * t80;
        stiffness[2][5] = t42 * t81;
        stiffness[2][6] = t43 * t79;
        stiffness[2][7] = t43 * t80;
        stiffness[2][8] = t56 + t43 * t81;
        stiffness[3][0] = t55 + t35 * t70;
        stiffness[3][1] = t35 * t71;
        stiffness[3][2] = t35 * t72;
        stiffness[3][3] = t36 * t70;
        stiffness[3][4] = t55 + t36 * t71;
        stiffness[3][5] = t36 * t72;
        stiffness[3][6] = t37 * t70;
        stiffness[3][7] = t37 * t71;
        stiffness[3][8] = t55 + t37 * t72;
        stiffness[4][0] = t35 * t73 + t61 * t82 + t41 * t85 + t95;
        stiffness[4][1] = t35 * t74 + t61 * t83 + t41 * t86;
        stiffness[4][2] = t35 * t75 + t61 * t84 + t41 * t87;
        stiffness[4][3] = t36 * t73 + t62 * t82 + t42 * t85;
        stiffness[4][4] = t36 * t74 + t62 * t83 + t42 * t86 + t95;
        stiffness[4][5] = t36 * t75 + t62 * t84 + t42 * t87;
        stiffness[4][6] = t37 * t73 + t63 * t82 + t43 * t85;
        stiffness[4][7] = t37 * t74 + t63 * t83 + t43 * t86;
        stiffness[4][8] = t37 * t75 + t63 * t84 + t43 * t87 + t95;
        stiffness[5][0] = t57 + t41 * t88;
        stiffness[5][1] = t41 * t89;
        stiffness[5][2] = t41 * t90;
        stiffness[5][3] = t42 * t88;
        stiffness[5][4] = t57 + t42 * t89;
        stiffness[5][5] = t42 * t90;
        stiffness[5][6] = t43 * t88;
        stiffness[5][7] = t43 * t89;
        stiffness[5][8] = t57 + t43 * t90;
        stiffness[6][0] = t56 + t35 * t76;
        stiffness[6][1] = t35 * t77;
        stiffness[6][2] = t35 * t78;
        stiffness[6][3] = t36 * t76;
        stiffness[6][4] = t56 + t36 * t77;
        stiffness[6][5] = t36 * t78;
        stiffness[6][6] = t37 * t76;
        stiffness[6][7] = t37 * t77;
        stiffness[6][8] = t56 + t37 * t78;
        stiffness[7][0] = t57 + t38 * t85;
        stiffness[7][1] = t38 * t86;
        stiffness[7][2] = t38 * t87;
        stiffness[7][3] = t39 * t85;
        stiffness[7][4] = t57 + t39 * t86;
        stiffness[7][5] = t39 * t87;
        stiffness[7][6] = t40 * t85;
        stiffness[7][7] = t40 * t86;
        stiffness[7][8] = t57 + t40 * t87;
        stiffness[8][0] = t35 * t79 + t38 * t88 + t64 * t91 + t96;
        stiffness[8][1] = t35 * t80 + t38 * t89 + t64 * t92;
        stiffness[8][2] = t35 * t81 + t38 * t90 + t64 * t93;
        stiffness[8][3] = t36 * t79 + t39 * t88 + t65 * t91;
        stiffness[8][4] = t36 * t80 + t39 * t89 + t65 * t92 + t96;
        stiffness[8][5] = t36 * t81 + t39 * t90 + t65 * t93;
        stiffness[8][6] = t37 * t79 + t40 * t88 + t66 * t91;
        stiffness[8][7] = t37 * t80 + t40 * t89 + t66 * t92;
        stiffness[8][8] = t37 * t81 + t40 * t90 + t66 * t93 + t96;
    }
    /// Writes the conserving forces on the fields a, b, c, db, dc at a point of weight one on the unit element between two states, for the terms that are integrated at 2 Gauss points.
    ///
    /// Operations: 70 additions, 126 multiplications, 1 divisions.
    pub fn beam_spatial_points2_conserving_force(
        row: &BeamSpatial,
        start: &[[f64; 3]; 5],
        end: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[o_a_x, o_a_y, o_a_z], [o_b_x, o_b_y, o_b_z], [o_c_x, o_c_y, o_c_z],
        [o_unit_db_x, o_unit_db_y, o_unit_db_z], [o_unit_dc_x, o_unit_dc_y, o_unit_dc_z],
        ] = *start;
        let [[e_a_x, e_a_y, e_a_z], [e_b_x, e_b_y, e_b_z], [e_c_x, e_c_y, e_c_z],
        [e_unit_db_x, e_unit_db_y, e_unit_db_z], [e_unit_dc_x, e_unit_dc_y, e_unit_dc_z],
        ] = *end;
        let inverse_length = 1.0 / length;
        let o_db_x = inverse_length * o_unit_db_x;
        let o_db_y = inverse_length * o_unit_db_y;
        let o_db_z = inverse_length * o_unit_db_z;
        let o_dc_x = inverse_length * o_unit_dc_x;
        let o_dc_y = inverse_length * o_unit_dc_y;
        let o_dc_z = inverse_length * o_unit_dc_z;
        let e_db_x = inverse_length * e_unit_db_x;
        let e_db_y = inverse_length * e_unit_db_y;
        let e_db_z = inverse_length * e_unit_db_z;
        let e_dc_x = inverse_length * e_unit_dc_x;
        let e_dc_y = inverse_length * e_unit_dc_y;
        let e_dc_z = inverse_length * e_unit_dc_z;
        let t62 = 0.5 * (o_a_x + e_a_x);
        let t63 = 0.5 * (o_a_y + e_a_y);
        let t64 = 0.5 * (o_a_z + e_a_z);
        let t65 = 0.5 * (o_b_x + e_b_x);
        let t66 = 0.5 * (o_b_y + e_b_y);
        let t67 = 0.5 * (o_b_z + e_b_z);
        let t68 = 0.5 * (o_c_x + e_c_x);
        let t69 = 0.5 * (o_c_y + e_c_y);
        let t70 = 0.5 * (o_c_z + e_c_z);
        let t71 = 0.5 * (o_unit_db_x + e_unit_db_x);
        let t72 = 0.5 * (o_unit_db_y + e_unit_db_y);
        let t73 = 0.5 * (o_unit_db_z + e_unit_db_z);
        let t74 = 0.5 * (o_unit_dc_x + e_unit_dc_x);
        let t75 = 0.5 * (o_unit_dc_y + e_unit_dc_y);
        let t76 = 0.5 * (o_unit_dc_z + e_unit_dc_z);
        let t77 = o_a_x * o_db_x + o_a_y * o_db_y + o_a_z * o_db_z
            + (e_a_x * e_db_x + e_a_y * e_db_y + e_a_z * e_db_z);
        let t78 = o_a_x * o_dc_x + o_a_y * o_dc_y + o_a_z * o_dc_z
            + (e_a_x * e_dc_x + e_a_y * e_dc_y + e_a_z * e_dc_z);
        let t79 = o_b_x * o_db_x + o_b_y * o_db_y + o_b_z * o_db_z
            + (e_b_x * e_db_x + e_b_y * e_db_y + e_b_z * e_db_z);
        let t80 = o_b_x * o_dc_x + o_b_y * o_dc_y + o_b_z * o_dc_z
            + (e_b_x * e_dc_x + e_b_y * e_dc_y + e_b_z * e_dc_z);
        let t81 = 0.5 * t80;
        let t82 = o_c_x * o_db_x + o_c_y * o_db_y + o_c_z * o_db_z
            + (e_c_x * e_db_x + e_c_y * e_db_y + e_c_z * e_db_z);
        let t83 = 0.5 * t82;
        let t84 = o_c_x * o_dc_x + o_c_y * o_dc_y + o_c_z * o_dc_z
            + (e_c_x * e_dc_x + e_c_y * e_dc_y + e_c_z * e_dc_z);
        let t85 = length * GJ * (0.5 * (t83 - t81));
        let t86 = length * GIyz * (t81 + t83);
        let t87 = inverse_length * (0.5 * t77 * (length * EIz));
        let t88 = inverse_length * (0.5 * t78 * (length * EIy));
        let t89 = inverse_length * (0.5 * t79 * (length * GIz));
        let t90 = inverse_length * (-0.5 * t85 + t86);
        let t91 = inverse_length * (t86 + 0.5 * t85);
        let t92 = inverse_length * (0.5 * t84 * (length * GIy));
        forces[0][0] = t71 * t87 + t74 * t88;
        forces[0][1] = t72 * t87 + t75 * t88;
        forces[0][2] = t73 * t87 + t76 * t88;
        forces[1][0] = t71 * t89 + t74 * t90;
        forces[1][1] = t72 * t89 + t75 * t90;
        forces[1][2] = t73 * t89 + t76 * t90;
        forces[2][0] = t71 * t91 + t74 * t92;
        forces[2][1] = t72 * t91 + t75 * t92;
        forces[2][2] = t73 * t91 + t76 * t92;
        forces[3][0] = t62 * t87 + t65 * t89 + t68 * t91;
        forces[3][1] = t63 * t87 + t66 * t89 + t69 * t91;
        forces[3][2] = t64 * t87 + t67 * t89 + t70 * t91;
        forces[4][0] = t62 * t88 + t65 * t90 + t68 * t92;
        forces[4][1] = t63 * t88 + t66 * t90 + t69 * t92;
        forces[4][2] = t64 * t88 + t67 * t90 + t70 * t92;
    }
    /// Writes the blocks of the derivative by the mean of both states on the fields a, b, c, db, dc at a point of weight one on the unit element between two states, for the terms that are integrated at 2 Gauss points.
    ///
    /// Operations: 188 additions, 441 multiplications, 1 divisions.
    pub fn beam_spatial_points2_conserving_tangent(
        row: &BeamSpatial,
        start: &[[f64; 3]; 5],
        end: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 21],
    ) {
        let BeamSpatial {
            length,
            EA,
            kyGA,
            kzGA,
            halfEA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            GIyz,
            ..
        } = *row;
        let [[o_a_x, o_a_y, o_a_z], [o_b_x, o_b_y, o_b_z], [o_c_x, o_c_y, o_c_z],
        [o_unit_db_x, o_unit_db_y, o_unit_db_z], [o_unit_dc_x, o_unit_dc_y, o_unit_dc_z],
        ] = *start;
        let [[e_a_x, e_a_y, e_a_z], [e_b_x, e_b_y, e_b_z], [e_c_x, e_c_y, e_c_z],
        [e_unit_db_x, e_unit_db_y, e_unit_db_z], [e_unit_dc_x, e_unit_dc_y, e_unit_dc_z],
        ] = *end;
        let inverse_length = 1.0 / length;
        let o_db_x = inverse_length * o_unit_db_x;
        let o_db_y = inverse_length * o_unit_db_y;
        let o_db_z = inverse_length * o_unit_db_z;
        let o_dc_x = inverse_length * o_unit_dc_x;
        let o_dc_y = inverse_length * o_unit_dc_y;
        let o_dc_z = inverse_length * o_unit_dc_z;
        let e_db_x = inverse_length * e_unit_db_x;
        let e_db_y = inverse_length * e_unit_db_y;
        let e_db_z = inverse_length * e_unit_db_z;
        let e_dc_x = inverse_length * e_unit_dc_x;
        let e_dc_y = inverse_length * e_unit_dc_y;
        let e_dc_z = inverse_length * e_unit_dc_z;
        let t62 = 0.5 * (o_a_x + e_a_x);
        let t63 = 0.5 * (o_a_y + e_a_y);
        let t64 = 0.5 * (o_a_z + e_a_z);
        let t65 = 0.5 * (o_b_x + e_b_x);
        let t66 = 0.5 * (o_b_y + e_b_y);
        let t67 = 0.5 * (o_b_z + e_b_z);
        let t68 = 0.5 * (o_c_x + e_c_x);
        let t69 = 0.5 * (o_c_y + e_c_y);
        let t70 = 0.5 * (o_c_z + e_c_z);
        let t71 = 0.5 * (o_unit_db_x + e_unit_db_x);
        let t72 = 0.5 * (o_unit_db_y + e_unit_db_y);
        let t73 = 0.5 * (o_unit_db_z + e_unit_db_z);
        let t74 = 0.5 * (o_unit_dc_x + e_unit_dc_x);
        let t75 = 0.5 * (o_unit_dc_y + e_unit_dc_y);
        let t76 = 0.5 * (o_unit_dc_z + e_unit_dc_z);
        let t77 = o_a_x * o_db_x + o_a_y * o_db_y + o_a_z * o_db_z
            + (e_a_x * e_db_x + e_a_y * e_db_y + e_a_z * e_db_z);
        let t78 = o_a_x * o_dc_x + o_a_y * o_dc_y + o_a_z * o_dc_z
            + (e_a_x * e_dc_x + e_a_y * e_dc_y + e_a_z * e_dc_z);
        let t79 = o_b_x * o_db_x + o_b_y * o_db_y + o_b_z * o_db_z
            + (e_b_x * e_db_x + e_b_y * e_db_y + e_b_z * e_db_z);
        let t80 = o_b_x * o_dc_x + o_b_y * o_dc_y + o_b_z * o_dc_z
            + (e_b_x * e_dc_x + e_b_y * e_dc_y + e_b_z * e_dc_z);
        let t81 = 0.5 * t80;
        let t82 = o_c_x * o_db_x + o_c_y * o_db_y + o_c_z * o_db_z
            + (e_c_x * e_db_x + e_c_y * e_db_y + e_c_z * e_db_z);
        let t83 = 0.5 * t82;
        let t84 = o_c_x * o_dc_x + o_c_y * o_dc_y + o_c_z * o_dc_z
            + (e_c_x * e_dc_x + e_c_y * e_dc_y + e_c_z * e_dc_z);
        let t85 = length * EIz;
        let t86 = length * EIy;
        let t87 = length * GJ;
        let t88 = 0.5 * t87;
        let t89 = length * GIz;
        let t90 = length * GIy;
        let t91 = length * GIyz;
        let t92 = t87 * (-0.5);
        let t93 = t87 * (0.5 * (t83 - t81));
        let t94 = t91 * (t81 + t83);
        let t95 = inverse_length * (0.5 * t77 * t85);
        let t96 = inverse_length * inverse_length;
        let t97 = t85 * t96;
        let t98 = inverse_length * (0.5 * t78 * t86);
        let t99 = t86 * t96;
        let t100 = inverse_length * (0.5 * t79 * t89);
        let t101 = t89 * t96;
        let t102 = inverse_length * (-0.5 * t93 + t94);
        let t103 = (t91 + (-0.5 * t92)) * t96;
        let t104 = (t91 + (-0.5 * t88)) * t96;
        let t105 = inverse_length * (t94 + 0.5 * t93);
        let t106 = (t91 + 0.5 * t92) * t96;
        let t107 = (t91 + 0.5 * t88) * t96;
        let t108 = inverse_length * (0.5 * t84 * t90);
        let t109 = t90 * t96;
        let t110 = e_unit_db_x * t97;
        let t111 = e_unit_db_y * t97;
        let t112 = e_unit_db_z * t97;
        let t113 = e_a_x * t97;
        let t114 = e_a_y * t97;
        let t115 = e_a_z * t97;
        let t116 = e_unit_dc_x * t99;
        let t117 = e_unit_dc_y * t99;
        let t118 = e_unit_dc_z * t99;
        let t119 = e_a_x * t99;
        let t120 = e_a_y * t99;
        let t121 = e_a_z * t99;
        let t122 = e_unit_db_x * t101;
        let t123 = e_unit_db_y * t101;
        let t124 = e_unit_db_z * t101;
        let t125 = e_b_x * t101;
        let t126 = e_b_y * t101;
        let t127 = e_b_z * t101;
        let t128 = e_unit_dc_x * t103;
        let t129 = e_unit_dc_y * t103;
        let t130 = e_unit_dc_z * t103;
        let t131 = e_unit_db_x * t104;
        let t132 = e_unit_db_y * t104;
        let t133 = e_unit_db_z * t104;
        let t134 = e_c_x * t104;
        let t135 = e_c_y * t104;
        let t136 = e_c_z * t104;
        let t137 = e_b_x * t103;
        let t138 = e_b_y * t103;
        let t139 = e_b_z * t103;
        let t140 = e_unit_dc_x * t106;
        let t141 = e_unit_dc_y * t106;
        let t142 = e_unit_dc_z * t106;
        let t143 = e_unit_db_x * t107;
        let t144 = e_unit_db_y * t107;
        let t145 = e_unit_db_z * t107;
        let t146 = e_c_x * t107;
        let t147 = e_c_y * t107;
        let t148 = e_c_z * t107;
        let t149 = e_b_x * t106;
        let t150 = e_b_y * t106;
        let t151 = e_b_z * t106;
        let t152 = e_unit_dc_x * t109;
        let t153 = e_unit_dc_y * t109;
        let t154 = e_unit_dc_z * t109;
        let t155 = e_c_x * t109;
        let t156 = e_c_y * t109;
        let t157 = e_c_z * t109;
        stiffness[0][0] = t71 * t110 + t74 * t116;
        stiffness[0][1] = t71 * t111 + t74 * t117;
        stiffness[0][2] = t71 * t112 + t74 * t118;
        stiffness[0][3] = t72 * t110 + t75 * t116;
        stiffness[0][4] = t72 * t111 + t75 * t117;
        stiffness[0][5] = t72 * t112 + t75 * t118;
        stiffness[0][6] = t73 * t110 + t76 * t116;
        stiffness[0][7] = t73 * t111 + t76 * t117;
        stiffness[0][8] = t73 * t112 + t76 * t118;
        stiffness[1][0] = t95 + t71 * t113;
        stiffness[1][1] = t71 * t114;
        stiffness[1][2] = t71 * t115;
        stiffness[1][3] = t72 * t113;
        stiffness[1][4] = t95 + t72 * t114;
        stiffness[1][5] = t72 * t115;
        stiffness[1][6] = t73 * t113;
        stiffness[1][7] = t73 * t114;
        stiffness[1][8] = t95 + t73 * t115;
        stiffness[2][0] = t98 + t74 * t119;
        stiffness[2][1] = t74 * t120;
        stiffness[2][2] = t74 * t121;
        stiffness[2][3] = t75 * t119;
        stiffness[2][4] = t98 + t75 * t120;
        stiffness[2][5] = t75 * t121;
        stiffness[2][6] = t76 * t119;
        stiffness[2][7] = t76 * t120;
        stiffness[2][8] = t98 + t76 * t121;
        stiffness[3][0] = t95 + t62 * t110;
        stiffness[3][1] = t62 * t111;
        stiffness[3][2] = t62 * t112;
        stiffness[3][3] = t63 * t110;
        stiffness[3][4] = t95 + t63 * t111;
        stiffness[3][5] = t63 * t112;
        stiffness[3][6] = t64 * t110;
        stiffness[3][7] = t64 * t111;
        stiffness[3][8] = t95 + t64 * t112;
        stiffness[4][0] = t71 * t122 + t74 * t128;
        stiffness[4][1] = t71 * t123 + t74 * t129;
        stiffness[4][2] = t71 * t124 + t74 * t130;
        stiffness[4][3] = t72 * t122 + t75 * t128;
        stiffness[4][4] = t72 * t123 + t75 * t129;
        stiffness[4][5] = t72 * t124 + t75 * t130;
        stiffness[4][6] = t73 * t122 + t76 * t128;
        stiffness[4][7] = t73 * t123 + t76 * t129;
        stiffness[4][8] = t73 * t124 + t76 * t130;
        stiffness[5][0] = t100 + (t71 * t125 + t74 * t134);
        stiffness[5][1] = t71 * t126 + t74 * t135;
        stiffness[5][2] = t71 * t127 + t74 * t136;
        stiffness[5][3] = t72 * t125 + t75 * t134;
        stiffness[5][4] = t100 + (t72 * t126 + t75 * t135);
        stiffness[5][5] = t72 * t127 + t75 * t136;
        stiffness[5][6] = t73 * t125 + t76 * t134;
        stiffness[5][7] = t73 * t126 + t76 * t135;
        stiffness[5][8] = t100 + (t73 * t127 + t76 * t136);
        stiffness[6][0] = t100 + (t65 * t122 + t68 * t140);
        stiffness[6][1] = t65 * t123 + t68 * t141;
        stiffness[6][2] = t65 * t124 + t68 * t142;
        stiffness[6][3] = t66 * t122 + t69 * t140;
        stiffness[6][4] = t100 + (t66 * t123 + t69 * t141);
        stiffness[6][5] = t66 * t124 + t69 * t142;
        stiffness[6][6] = t67 * t122 + t70 * t140;
        stiffness[6][7] = t67 * t123 + t70 * t141;
        stiffness[6][8] = t100 + (t67 * t124 + t70 * t142);
        stiffness[7][0] = t62 * t113 + t65 * t125 + t68 * t146;
        stiffness[7][1] = t62 * t114 + t65 * t126 + t68 * t147;
        stiffness[7][2] = t62 * t115 + t65 * t127 + t68 * t148;
        stiffness[7][3] = t63 * t113 + t66 * t125 + t69 * t146;
        stiffness[7][4] = t63 * t114 + t66 * t126 + t69 * t147;
        stiffness[7][5] = t63 * t115 + t66 * t127 + t69 * t148;
        stiffness[7][6] = t64 * t113 + t67 * t125 + t70 * t146;
        stiffness[7][7] = t64 * t114 + t67 * t126 + t70 * t147;
        stiffness[7][8] = t64 * t115 + t67 * t127 + t70 * t148;
        stiffness[8][0] = t74 * t131;
        stiffness[8][1] = t74 * t132;
        stiffness[8][2] = t74 * t133;
        stiffness[8][3] = t75 * t131;
        stiffness[8][4] = t75 * t132;
        stiffness[8][5] = t75 * t133;
        stiffness[8][6] = t76 * t131;
        stiffness[8][7] = t76 * t132;
        stiffness[8][8] = t76 * t133;
        stiffness[9][0] = t102 + t74 * t137;
        stiffness[9][1] = t74 * t138;
        stiffness[9][2] = t74 * t139;
        stiffness[9][3] = t75 * t137;
        stiffness[9][4] = t102 + t75 * t138;
        stiffness[9][5] = t75 * t139;
        stiffness[9][6] = t76 * t137;
        stiffness[9][7] = t76 * t138;
        stiffness[9][8] = t102 + t76 * t139;
        stiffness[10][0] = t105 + t68 * t143;
        stiffness[10][1] = t68 * t144;
        stiffness[10][2] = t68 * t145;
        stiffness[10][3] = t69 * t143;
        stiffness[10][4] = t105 + t69 * t144;
        stiffness[10][5] = t69 * t145;
        stiffness[10][6] = t70 * t143;
        stiffness[10][7] = t70 * t144;
        stiffness[10][8] = t105 + t70 * t145;
        stiffness[11][0] = t68 * t149;
        stiffness[11][1] = t68 * t150;
        stiffness[11][2] = t68 * t151;
        stiffness[11][3] = t69 * t149;
        stiffness[11][4] = t69 * t150;
        stiffness[11][5] = t69 * t151;
        stiffness[11][6] = t70 * t149;
        stiffness[11][7] = t70 * t150;
        stiffness[11][8] = t70 * t151;
        stiffness[12][0] = t98 + t62 * t116;
        stiffness[12][1] = t62 * t117;
        stiffness[12][2] = t62 * t118;
        stiffness[12][3] = t63 * t116;
        stiffness[12][4] = t98 + t63 * t117;
        stiffness[12][5] = t63 * t118;
        stiffness[12][6] = t64 * t116;
        stiffness[12][7] = t64 * t117;
        stiffness[12][8] = t98 + t64 * t118;
        stiffness[13][0] = t71 * t140;
        stiffness[13][1] = t71 * t141;
        stiffness[13][2] = t71 * t142;
        stiffness[13][3] = t72 * t140;
        stiffness[13][4] = t72 * t141;
        stiffness[13][5] = t72 * t142;
        stiffness[13][6] = t73 * t140;
        stiffness[13][7] = t73 * t141;
        stiffness[13][8] = t73 * t142;
        stiffness[14][0] = t105 + t71 * t146;
        stiffness[14][1] = t71 * t147;
        stiffness[14][2] = t71 * t148;
        stiffness[14][3] = t72 * t146;
        stiffness[14][4] = t105 + t72 * t147;
        stiffness[14][5] = t72 * t148;
        stiffness[14][6] = t73 * t146;
        stiffness[14][7] = t73 * t147;
        stiffness[14][8] = t105 + t73 * t148;
        stiffness[15][0] = t102 + t65 * t128;
        stiffness[15][1] = t65 * t129;
        stiffness[15][2] = t65 * t130;
        stiffness[15][3] = t66 * t128;
        stiffness[15][4] = t102 + t66 * t129;
        stiffness[15][5] = t66 * t130;
        stiffness[15][6] = t67 * t128;
        stiffness[15][7] = t67 * t129;
        stiffness[15][8] = t102 + t67 * t130;
        stiffness[16][0] = t65 * t134;
        stiffness[16][1] = t65 * t135;
        stiffness[16][2] = t65 * t136;
        stiffness[16][3] = t66 * t134;
        stiffness[16][4] = t66 * t135;
        stiffness[16][5] = t66 * t136;
        stiffness[16][6] = t67 * t134;
        stiffness[16][7] = t67 * t135;
        stiffness[16][8] = t67 * t136;
        stiffness[17][0] = t71 * t143 + t74 * t152;
        stiffness[17][1] = t71 * t144 + t74 * t153;
        stiffness[17][2] = t71 * t145 + t74 * t154;
        stiffness[17][3] = t72 * t143 + t75 * t152;
        stiffness[17][4] = t72 * t144 + t75 * t153;
        stiffness[17][5] = t72 * t145 + t75 * t154;
        stiffness[17][6] = t73 * t143 + t76 * t152;
        stiffness[17][7] = t73 * t144 + t76 * t153;
        stiffness[17][8] = t73 * t145 + t76 * t154;
        stiffness[18][0] = t108 + (t71 * t149 + t74 * t155);
        stiffness[18][1] = t71 * t150 + t74 * t156;
        stiffness[18][2] = t71 * t151 + t74 * t157;
        stiffness[18][3] = t72 * t149 + t75 * t155;
        stiffness[18][4] = t108 + (t72 * t150 + t75 * t156);
        stiffness[18][5] = t72 * t151 + t75 * t157;
        stiffness[18][6] = t73 * t149 + t76 * t155;
        stiffness[18][7] = t73 * t150 + t76 * t156;
        stiffness[18][8] = t108 + (t73 * t151 + t76 * t157);
        stiffness[19][0] = t108 + (t65 * t131 + t68 * t152);
        stiffness[19][1] = t65 * t132 + t68 * t153;
        stiffness[19][2] = t65 * t133 + t68 * t154;
        stiffness[19][3] = t66 * t131 + t69 * t152;
        stiffness[19][4] = t108 + (t66 * t132 + t69 * t153);
        stiffness[19][5] = t66 * t133 + t69 * t154;
        stiffness[19][6] = t67 * t131 + t70 * t152;
        stiffness[19][7] = t67 * t132 + t70 * t153;
        stiffness[19][8] = t108 + (t67 * t133 + t70 * t154);
        stiffness[20][0] = t62 * t119 + t65 * t137 + t68 * t155;
        stiffness[20][1] = t62 * t120 + t65 * t138 + t68 * t156;
        stiffness[20][2] = t62 * t121 + t65 * t139 + t68 * t157;
        stiffness[20][3] = t63 * t119 + t66 * t137 + t69 * t155;
        stiffness[20][4] = t63 * t120 + t66 * t138 + t69 * t156;
        stiffness[20][5] = t63 * t121 + t66 * t139 + t69 * t157;
        stiffness[20][6] = t64 * t119 + t67 * t137 + t70 * t155;
        stiffness[20][7] = t64 * t120 + t67 * t138 + t70 * t156;
        stiffness[20][8] = t64 * t121 + t67 * t139 + t70 * t157;
    }
    /// Adds the elastic force of one element between two states that does the work U(end) - U(start) over the step and has no moment about the mean positions: S_A(mean of I) dI_A/dq(mean of q).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    pub fn beam_spatial_conserving_force(
        row: &BeamSpatial,
        start: &[f64; 30],
        end: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let start = BEAM_SPATIAL_VECTORS.relative(row.length, start);
        let end = BEAM_SPATIAL_VECTORS.relative(row.length, end);
        let mut sums = Default::default();
        BEAM_SPATIAL_POINTS3
            .force(
                &start,
                &end,
                |point, start, end, forces| beam_spatial_points3_conserving_force(
                    row,
                    start,
                    end,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_POINTS2
            .force(
                &start,
                &end,
                |point, start, end, forces| beam_spatial_points2_conserving_force(
                    row,
                    start,
                    end,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the derivative of the conserving force of one element with respect to the mean of both states at a fixed start (half of it is that with respect to the end), rows first; not symmetric.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    pub fn beam_spatial_conserving_tangent(
        row: &BeamSpatial,
        start: &[f64; 30],
        end: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let start = BEAM_SPATIAL_VECTORS.relative(row.length, start);
        let end = BEAM_SPATIAL_VECTORS.relative(row.length, end);
        let mut tiles = [[[0.0; 9]; 9]; 9];
        BEAM_SPATIAL_POINTS3
            .tangent_between(
                &start,
                &end,
                (&BEAM_SPATIAL_POINTS3_BETWEEN, &mut tiles),
                |point, start, end, stiffness| beam_spatial_points3_conserving_tangent(
                    row,
                    start,
                    end,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_POINTS2
            .tangent_between(
                &start,
                &end,
                (&BEAM_SPATIAL_POINTS2_BETWEEN, &mut tiles),
                |point, start, end, stiffness| beam_spatial_points2_conserving_tangent(
                    row,
                    start,
                    end,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_VECTORS.add_general(row.length, &tiles, stiffness);
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 2 multiplications, 2 function calls.
    pub fn load_weight(model: &PrincetonBeam, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = model.load * model.angle.cos();
        value[2] = model.load * model.angle.sin();
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 15 additions, 19 multiplications.
    pub fn joint_root_absolute_position(
        model: &PrincetonBeam,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t30 = data.tangent[1] * data.second[2] - data.tangent[2] * data.second[1];
        let t31 = data.tangent[2] * data.second[0] - data.tangent[0] * data.second[2];
        let t32 = data.tangent[0] * data.second[1] - data.tangent[1] * data.second[0];
        let t33 = data.second[0] * q[3] + data.second[1] * q[4] + data.second[2] * q[5]
            - (data.tangent[0] * q[6] + data.tangent[1] * q[7] + data.tangent[2] * q[8]);
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - data.point[1];
        rows[2] = q[2] - data.point[2];
        rows[3] = q[3] * t30 + q[4] * t31 + q[5] * t32;
        rows[4] = q[6] * t30 + q[7] * t31 + q[8] * t32;
        rows[5] = 0.5 * t33;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 3 additions, 12 multiplications.
    pub fn joint_root_absolute_jacobian(
        model: &PrincetonBeam,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let t18 = data.tangent[1] * data.second[2] - data.tangent[2] * data.second[1];
        let t19 = data.tangent[2] * data.second[0] - data.tangent[0] * data.second[2];
        let t20 = data.tangent[0] * data.second[1] - data.tangent[1] * data.second[0];
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = t18;
        jacobian[31] = t19;
        jacobian[32] = t20;
        jacobian[42] = t18;
        jacobian[43] = t19;
        jacobian[44] = t20;
        jacobian[48] = data.second[0] * 0.5;
        jacobian[49] = data.second[1] * 0.5;
        jacobian[50] = data.second[2] * 0.5;
        jacobian[51] = -data.tangent[0] * 0.5;
        jacobian[52] = -data.tangent[1] * 0.5;
        jacobian[53] = -data.tangent[2] * 0.5;
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_prescribed(
        model: &PrincetonBeam,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.second[0][0] = data.second[0];
        prescribed.second[0][1] = data.second[1];
        prescribed.second[0][2] = data.second[2];
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn outputs(model: &PrincetonBeam, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0] - 0.508;
        out[1] = observed[1];
        out[2] = observed[2];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &PrincetonBeam, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.001;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: PrincetonBeam,
        pub row_beam: BeamSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &PrincetonBeam) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
            }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            3
        }
        fn frame_count(&self) -> usize {
            1
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial"][frame]
        }
        fn conservative(&self) -> bool {
            true
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            ::std::vec::Vec::new()
        }
        fn gaps(&self, t: f64, out: &mut ::std::vec::Vec<[f64; 2]>) {}
        fn courses(&self) -> ::std::vec::Vec<::rncf::emitted::Courses> {
            ::std::vec::Vec::new()
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::emitted::FrameMotion]) {
            motions[0] = ::rncf::emitted::FrameMotion::INERTIAL;
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            None
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            Ok(())
        }
        fn free(&self) -> ::std::vec::Vec<::rncf::emitted::FreeSpec> {
            ::std::vec::Vec::new()
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            ::std::vec::Vec::new()
        }
    }
    impl ::rncf::emitted::Bodies for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::emitted::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::BodySpec {
                    name: "beam",
                    kind: 0,
                    instance: None,
                    frame: 0,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [0.508, 0.0, 0.0],
                    },
                    count: (model.elements as f64) as usize,
                    stations: ::std::vec::Vec::new(),
                    nodal: &[
                        ::rncf::emitted::NodalSpec {
                            meaning: "position",
                            of: ::rncf::emitted::Interpolant::Position,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "slope",
                            of: ::rncf::emitted::Interpolant::Position,
                            order: 1,
                            xi: 0.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section y axis",
                            of: ::rncf::emitted::Interpolant::SectionY,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::emitted::Interpolant::SectionZ,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section y axis",
                            of: ::rncf::emitted::Interpolant::SectionY,
                            order: 0,
                            xi: 0.5,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::emitted::Interpolant::SectionZ,
                            order: 0,
                            xi: 0.5,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "position",
                            of: ::rncf::emitted::Interpolant::Position,
                            order: 0,
                            xi: 1.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "slope",
                            of: ::rncf::emitted::Interpolant::Position,
                            order: 1,
                            xi: 1.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section y axis",
                            of: ::rncf::emitted::Interpolant::SectionY,
                            order: 0,
                            xi: 1.0,
                        },
                        ::rncf::emitted::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::emitted::Interpolant::SectionZ,
                            order: 0,
                            xi: 1.0,
                        },
                    ],
                    connectivity: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
                    vectors_per_node: 4,
                    stride: 6,
                    section_y: None,
                    twist: ::rncf::emitted::Twist::even(0.0),
                    fidelity: ::rncf::emitted::Fidelity::Full,
                    damps: false,
                    tie: ::rncf::emitted::FrameTie::Joints,
                    normals: ::std::vec::Vec::new(),
                },
            ])
        }
        fn prepare(
            &mut self,
            body: usize,
            nodes: &[f64],
            shape: &[f64],
        ) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            let length = nodes[1] - nodes[0];
            let density = ::rncf::emitted::positive(
                "material `aluminium`",
                "density",
                2700.0,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `aluminium`",
                "young",
                71700000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::emitted::poisson(
                "material `aluminium`",
                "poisson",
                0.31,
                "1",
            )?;
            let area = ::rncf::emitted::positive(
                "section `strip`",
                "area",
                3.963834648e-5,
                "m^2",
            )?;
            let second_moment_y = ::rncf::emitted::positive(
                "section `strip`",
                "second_moment_y",
                3.3875478439500715e-11,
                "m^4",
            )?;
            let second_moment_z = ::rncf::emitted::positive(
                "section `strip`",
                "second_moment_z",
                5.060741896150687e-10,
                "m^4",
            )?;
            let torsion_constant = ::rncf::emitted::positive(
                "section `strip`",
                "torsion_constant",
                1.1340719248267313e-10,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::emitted::part(
                "section `strip`",
                "shear_factor_y",
                0.8333333333333334,
                "1",
            )?;
            let shear_factor_z = ::rncf::emitted::part(
                "section `strip`",
                "shear_factor_z",
                0.8333333333333334,
                "1",
            )?;
            let size_y = ::rncf::emitted::positive(
                "section `strip`",
                "size_y",
                0.0123777,
                "m",
            )?;
            let size_z = ::rncf::emitted::positive(
                "section `strip`",
                "size_z",
                0.0032024,
                "m",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            let half_young = 0.5 * young;
            let quarter_polar_moment = 0.25 * (second_moment_y + second_moment_z);
            self.row_beam = BeamSpatial {
                length,
                EA: young * area,
                kyGA: shear_factor_y * shear_modulus * area,
                kzGA: shear_factor_z * shear_modulus * area,
                halfEA: half_young * area,
                EIz: young * second_moment_z,
                EIy: young * second_moment_y,
                GJ: shear_modulus * torsion_constant,
                GIz: shear_modulus * second_moment_z,
                GIy: shear_modulus * second_moment_y,
                GIyz: shear_modulus * quarter_polar_moment,
                rhoA: density * area,
                rhoIz: density * second_moment_z,
                rhoIy: density * second_moment_y,
            };
            Ok(())
        }
        fn initial(
            &self,
            body: usize,
            x: f64,
        ) -> [::std::option::Option<[[f64; 3]; 2]>; 2] {
            [None, None]
        }
        fn shares(&self) -> ::std::vec::Vec<::rncf::emitted::ShareSpec> {
            ::std::vec::Vec::new()
        }
        fn starts(&self) -> ::std::vec::Vec<::rncf::emitted::StartSpec> {
            ::std::vec::Vec::new()
        }
        fn fixtures(&self) -> ::std::vec::Vec<::rncf::emitted::FixtureSpec> {
            ::std::vec::Vec::new()
        }
        fn varies(&self, body: usize) -> bool {
            false
        }
        fn tables(
            &self,
            body: usize,
        ) -> ::std::vec::Vec<&'static ::rncf::emitted::Table> {
            ::std::vec::Vec::new()
        }
        fn properties(
            &self,
            body: usize,
            x: f64,
            length: f64,
        ) -> ::std::vec::Vec<(&'static str, f64)> {
            ::std::vec::Vec::new()
        }
        fn mass(&self, body: usize, element: usize, mass: &mut [f64]) {
            beam_spatial_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_spatial_elastic_force(
                &self.row_beam,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array_mut(force),
            );
        }
        fn elastic_tangent(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            stiffness: &mut [f64],
            damping: &mut [f64],
        ) {
            beam_spatial_elastic_tangent(
                &self.row_beam,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array_mut(stiffness),
            );
        }
        fn elastic_force4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            force: &mut [[f64; 4]],
        ) {
            ::rncf::emitted::elastic_force_one_by_one(self, elements, q, v, force);
        }
        fn elastic_tangent4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            stiffness: &mut [[f64; 4]],
            damping: &mut [[f64; 4]],
        ) {
            ::rncf::emitted::elastic_tangent_one_by_one(
                self,
                elements,
                q,
                v,
                stiffness,
                damping,
            );
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            beam_spatial_strain_energy(
                &self.row_beam,
                ::rncf::emitted::array(q),
                &mut energy,
            );
            energy
        }
        fn shapes(
            &self,
            body: usize,
            element: usize,
            of: ::rncf::emitted::Interpolant,
            order: usize,
            xi: f64,
            weights: &mut [f64],
        ) {
            weights.fill(0.0);
            match (of, order) {
                (::rncf::emitted::Interpolant::Position, 0) => {
                    beam_spatial_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    beam_spatial_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    beam_spatial_shapes_section_y_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    beam_spatial_shapes_section_y_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 0) => {
                    beam_spatial_shapes_section_z_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 1) => {
                    beam_spatial_shapes_section_z_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                _ => {}
            }
        }
        fn section(
            &self,
            body: usize,
            x: f64,
            length: f64,
        ) -> ::rncf::emitted::SectionSpec {
            let model = &self.model;
            ::rncf::emitted::SectionSpec {
                shape: ::rncf::emitted::SectionShape::Rectangle {
                    sizes: [0.0123777, 0.0032024],
                },
                area: 3.963834648e-5,
                second_moments: [3.3875478439500715e-11, 5.060741896150687e-10],
                torsion_constant: 1.1340719248267313e-10,
                young_over_shear: 2.0 * (1.0 + 0.31),
                softness_of_curves: 2.0,
                yield_stress: None,
                material: "aluminium",
            }
        }
        fn fields(
            &self,
            body: usize,
        ) -> &'static [(::rncf::emitted::Interpolant, usize)] {
            &[
                (::rncf::emitted::Interpolant::Position, 1),
                (::rncf::emitted::Interpolant::SectionY, 0),
                (::rncf::emitted::Interpolant::SectionZ, 0),
                (::rncf::emitted::Interpolant::SectionY, 1),
                (::rncf::emitted::Interpolant::SectionZ, 1),
            ]
        }
        fn field_forces(
            &self,
            body: usize,
            at: [f64; 2],
            stress_free: &[f64],
            fields: &[f64],
            rates: &[f64],
            forces: &mut [f64],
        ) {
            beam_spatial_field_forces(
                &self.row_beam,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array_mut(forces),
            );
        }
    }
    impl ::rncf::emitted::ConservingForces for Equations {
        fn conserving_force(
            &self,
            body: usize,
            element: usize,
            start: &[f64],
            end: &[f64],
            force: &mut [f64],
        ) {
            beam_spatial_conserving_force(
                &self.row_beam,
                ::rncf::emitted::array(start),
                ::rncf::emitted::array(end),
                ::rncf::emitted::array_mut(force),
            );
        }
        fn conserving_tangent(
            &self,
            body: usize,
            element: usize,
            start: &[f64],
            end: &[f64],
            stiffness: &mut [f64],
        ) {
            beam_spatial_conserving_tangent(
                &self.row_beam,
                ::rncf::emitted::array(start),
                ::rncf::emitted::array(end),
                ::rncf::emitted::array_mut(stiffness),
            );
        }
    }
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::JointConditions for Equations {
        fn joints(&self) -> ::std::vec::Vec<::rncf::emitted::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::JointSpec {
                    name: "root",
                    kind: ::rncf::emitted::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 0,
                    point: None,
                },
            ])
        }
        fn condition(
            &self,
            joint: usize,
            absolute: bool,
            level: ::rncf::emitted::ConstraintLevel,
            t: f64,
            data: &::rncf::emitted::JointData,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            rows: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, _) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_root_absolute_position(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        _ => {}
                    }
                }
                _ => {}
            }
        }
        fn condition_jacobian(
            &self,
            joint: usize,
            absolute: bool,
            t: f64,
            data: &::rncf::emitted::JointData,
            jacobian: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, _) => {
                    joint_root_absolute_jacobian(&self.model, t, data, jacobian);
                }
                _ => {}
            }
        }
        fn prescribed(
            &self,
            joint: usize,
            absolute: bool,
            t: f64,
            data: &::rncf::emitted::JointData,
            prescribed: &mut ::rncf::emitted::Prescribed,
        ) {
            match (joint, absolute) {
                (0, _) => {
                    joint_root_absolute_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::Loads for Equations {
        fn loads(&self) -> ::std::vec::Vec<::rncf::emitted::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::LoadSpec {
                    name: "weight",
                    kind: ::rncf::emitted::LoadKind::Force {
                        body: 0,
                        at: ::rncf::emitted::Place::End,
                    },
                    frame: 0,
                },
            ])
        }
        fn load_varies(&self, load: usize) -> bool {
            const VARIES: [bool; 1] = [false];
            VARIES[load]
        }
        fn load(&self, load: usize, t: f64) -> [f64; 3] {
            let mut value = [0.0; 3];
            match load {
                0 => load_weight(&self.model, t, &mut value),
                _ => {}
            }
            value
        }
    }
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::WithoutMarkerConstraints for Equations {}
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
