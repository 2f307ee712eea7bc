//! Expansion of `models/src/roll_up.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use roll_up_equations::RollUp;
#[allow(clippy::all)]
impl Default for RollUp {
    fn default() -> Self {
        Self {
            turns: 1.0,
            slenderness: 0.005,
            elements: 8,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for RollUp {
    const NAME: &'static str = "RollUp";
    const DOC: &'static str = "Roll-up: an end moment of 2 pi EI/L bends a straight cantilever to a full circle.";
    const SOURCE: &'static str = r#"pub model RollUp {
    /// End moment over 2 pi EI/L: the number of turns of a slender beam.
    param turns = 1;
    /// Radius of the section over the length.
    param slenderness = 0.005;
    /// Number of elements.
    param elements: count = 8;

    const length = 1 m;
    const young = 210 [GPa];

    material steel { density = 7850 kg/m^3; young = young; poisson = 0.3; }
    section round = circle(radius = slenderness * length);

    body beam {
        planar xy;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * beam(round, steel);
    }
    // Whole: with both axes of the section held the convergence is that of THEORY 5.2.1.
    joint root = clamp_full(beam.start, inertial);
    load bend = moment(
        beam.end,
        [0 [N m], 0 [N m], turns * 2 * pi * young * pi / 4 * (slenderness * length)^4 / length],
        in = inertial
    );

    /// Position of the tip over the length.
    output x = beam.end.x / length;
    /// Position of the tip over the length.
    output y = beam.end.y / length;
    /// Distance of the tip from the root over the length.
    output gap = norm(beam.end.position - beam.start.position) / length;

    run { t_end = 1 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xfd461f4ac70ce996;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `beam_planar`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 446 and 1954).",
        "Body `beam` is planar: two components a vector, no motion along the normal.",
        "Body `beam` has nodal vectors for the section's y axis (r0y, ry_half, r1y): sections shear and have rotary inertia; there is no torsion in a plane.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `beam` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as load `bend` is a moment, which has no potential.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "BEAM_PLANAR_MASS_MATRIX",
            size: [7, 7],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "beam_planar_points3_force",
            additions: 9,
            multiplications: 27,
            divisions: 0,
            functions: 0,
            weighted: 36,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_points3_tangent",
            additions: 17,
            multiplications: 47,
            divisions: 0,
            functions: 0,
            weighted: 64,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_points3_energy",
            additions: 7,
            multiplications: 18,
            divisions: 0,
            functions: 0,
            weighted: 25,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_points2_force",
            additions: 4,
            multiplications: 20,
            divisions: 1,
            functions: 0,
            weighted: 28,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_points2_tangent",
            additions: 9,
            multiplications: 43,
            divisions: 1,
            functions: 0,
            weighted: 56,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_points2_energy",
            additions: 3,
            multiplications: 14,
            divisions: 1,
            functions: 0,
            weighted: 21,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_mass",
            additions: 0,
            multiplications: 17,
            divisions: 0,
            functions: 0,
            weighted: 17,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_field_forces",
            additions: 29,
            multiplications: 53,
            divisions: 0,
            functions: 0,
            weighted: 82,
        },
        ::rncf::model::KernelCount {
            name: "load_bend",
            additions: 0,
            multiplications: 7,
            divisions: 1,
            functions: 0,
            weighted: 11,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_position",
            additions: 4,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 4,
        },
        ::rncf::model::KernelCount {
            name: "moment_planar",
            additions: 3,
            multiplications: 4,
            divisions: 2,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "moment_tangent_planar",
            additions: 7,
            multiplications: 10,
            divisions: 6,
            functions: 0,
            weighted: 41,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 3,
            multiplications: 2,
            divisions: 0,
            functions: 1,
            weighted: 25,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "turns",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 1.0,
                doc: "End moment over 2 pi EI/L: the number of turns of a slender beam.",
            },
            ::rncf::Param {
                name: "slenderness",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.005,
                doc: "Radius of the section over the length.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 8.0,
                doc: "Number of elements.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "x",
                unit: "1",
                time_exponent: 0.0,
                components: &[],
                doc: "Position of the tip over the length.",
            },
            ::rncf::Output {
                name: "y",
                unit: "1",
                time_exponent: 0.0,
                components: &[],
                doc: "Position of the tip over the length.",
            },
            ::rncf::Output {
                name: "gap",
                unit: "1",
                time_exponent: 0.0,
                components: &[],
                doc: "Distance of the tip from the root over the length.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.turns,
            1 => self.slenderness,
            2 => self.elements as f64,
            _ => panic!("RollUp has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.turns = value,
            1 => self.slenderness = value,
            2 => self.elements = value as usize,
            _ => panic!("RollUp has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        roll_up_equations::run_defaults(self, &mut run);
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
        let equations = roll_up_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`RollUp`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod roll_up_equations {
    /// Roll-up: an end moment of 2 pi EI/L bends a straight cantilever to a full circle.
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `beam_planar`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 446 and 1954).
    /// * Body `beam` is planar: two components a vector, no motion along the normal.
    /// * Body `beam` has nodal vectors for the section's y axis (r0y, ry_half, r1y): sections shear and have rotary inertia; there is no torsion in a plane.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `beam` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as load `bend` is a moment, which has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct RollUp {
        /// End moment over 2 pi EI/L: the number of turns of a slender beam. (SI; declared in 1)
        pub turns: f64,
        /// Radius of the section over the length. (SI; declared in 1)
        pub slenderness: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `beam_planar`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, ry_half, r1, r1x, r1y, 2 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 446 and 1954).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamPlanar {
        /// Length, m.
        pub length: f64,
        /// young * area, N.
        pub EA: f64,
        /// shear_factor_y * shear_modulus * area, N.
        pub kyGA: f64,
        /// young * second_moment_z, N m^2.
        pub EIz: f64,
        /// shear_modulus * second_moment_z, N m^2.
        pub GIz: f64,
        /// density * area, kg/m.
        pub rhoA: f64,
        /// density * second_moment_z, kg m.
        pub rhoIz: f64,
    }
    /// Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.
    ///
    /// Rows and columns: r0, r0x, r0y, ry_half, r1, r1x, r1y; slopes are multiplied by the length. The sum of a row's columns of positions is the first moment d_a.
    pub const BEAM_PLANAR_MASS_MATRIX: [[f64; 7]; 7] = [
        [
            0.37142857142857144,
            0.05238095238095238,
            0.0,
            0.0,
            0.12857142857142856,
            -0.030952380952380953,
            0.0,
        ],
        [
            0.05238095238095238,
            0.009523809523809525,
            0.0,
            0.0,
            0.030952380952380953,
            -0.007142857142857143,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.13333333333333333,
            0.06666666666666667,
            0.0,
            0.0,
            -0.03333333333333333,
        ],
        [
            0.0,
            0.0,
            0.06666666666666667,
            0.5333333333333333,
            0.0,
            0.0,
            0.06666666666666667,
        ],
        [
            0.12857142857142856,
            0.030952380952380953,
            0.0,
            0.0,
            0.37142857142857144,
            -0.05238095238095238,
            0.0,
        ],
        [
            -0.030952380952380953,
            -0.007142857142857143,
            0.0,
            0.0,
            -0.05238095238095238,
            0.009523809523809525,
            0.0,
        ],
        [
            0.0,
            0.0,
            -0.03333333333333333,
            0.06666666666666667,
            0.0,
            0.0,
            0.13333333333333333,
        ],
    ];
    /// Nodal vectors by what they interpolate: Position, SectionY.
    static BEAM_PLANAR_VECTORS: ::rncf::emitted::Vectors<7, 2, 2, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 4, 5], [2, 3, 6]],
        positions: [[false, true, false], [false, false, false]],
    };
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static BEAM_PLANAR_POINTS3: ::rncf::emitted::Rule<3, 2, 3> = ::rncf::emitted::Rule {
        groups: [0, 1],
        weights: [0.2777777777777776, 0.4444444444444444, 0.2777777777777776],
        shapes: [
            [
                [0.5872983346207417, 0.6, -0.18729833462074166],
                [0.6872983346207417, 0.39999999999999997, -0.08729833462074169],
            ],
            [[-0.25, 1.5, -0.25], [0.0, 1.0, 0.0]],
            [
                [-0.18729833462074175, 0.6, 0.5872983346207418],
                [-0.08729833462074166, 0.39999999999999997, 0.6872983346207417],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_PLANAR_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 3> = BEAM_PLANAR_POINTS3
        .blocks(&[(0, 0), (0, 1), (1, 1)], &[(0, 0, 1), (1, 1, 2), (2, 2, 3)]);
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static BEAM_PLANAR_POINTS2: ::rncf::emitted::Rule<2, 3, 3> = ::rncf::emitted::Rule {
        groups: [0, 1, 1],
        weights: [0.5000000000000001, 0.5000000000000001],
        shapes: [
            [
                [0.28867513459481287, 1.0, -0.2886751345948129],
                [0.4553418012614795, 0.6666666666666667, -0.12200846792814622],
                [-2.1547005383792515, 2.309401076758503, -0.15470053837925146],
            ],
            [
                [-0.2886751345948131, 1.0000000000000004, 0.28867513459481264],
                [-0.12200846792814612, 0.6666666666666667, 0.4553418012614795],
                [0.15470053837925146, -2.309401076758503, 2.1547005383792515],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_PLANAR_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<2, 9, 6> = BEAM_PLANAR_POINTS2
        .blocks(
            &[(0, 0), (0, 2), (1, 1), (1, 2), (2, 1), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 6)],
        );
    /// Writes the forces on the fields a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 9 additions, 27 multiplications.
    pub fn beam_planar_points3_force(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 2],
        forces: &mut [[f64; 2]; 2],
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t19 = length * EA;
        let t20 = 0.5 * (t19 * (0.5 * (a_x * a_x + a_y * a_y - 1.0)));
        let t21 = (a_x * b_x + a_y * b_y) * (length * kyGA);
        let t22 = 0.5 * (t19 * (0.5 * (b_x * b_x + b_y * b_y - 1.0)));
        forces[0][0] = t20 * (a_x * 2.0) + b_x * t21;
        forces[0][1] = t20 * (a_y * 2.0) + b_y * t21;
        forces[1][0] = a_x * t21 + t22 * (b_x * 2.0);
        forces[1][1] = a_y * t21 + t22 * (b_y * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 17 additions, 47 multiplications.
    pub fn beam_planar_points3_tangent(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 2],
        stiffness: &mut [[f64; 4]; 3],
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t19 = length * EA;
        let t20 = length * kyGA;
        let t21 = 0.5 * (0.5 * t19);
        let t22 = (a_x * b_x + a_y * b_y) * t20;
        let t23 = a_x * 2.0;
        let t24 = a_y * 2.0;
        let t25 = b_x * 2.0;
        let t26 = b_y * 2.0;
        let t27 = t21 * t24;
        let t28 = b_y * t20;
        let t29 = a_x * t20;
        let t30 = a_y * t20;
        let t31 = t21 * t26;
        let t32 = t23 * t27 + b_x * t28;
        let t33 = a_x * t30 + t25 * t31;
        let t34 = 0.5 * (t19 * (0.5 * (a_x * a_x + a_y * a_y - 1.0))) * 2.0;
        let t35 = 0.5 * (t19 * (0.5 * (b_x * b_x + b_y * b_y - 1.0))) * 2.0;
        stiffness[0][0] = t23 * (t21 * t23) + b_x * (b_x * t20) + t34;
        stiffness[0][1] = t32;
        stiffness[0][2] = t32;
        stiffness[0][3] = t24 * t27 + b_y * t28 + t34;
        stiffness[1][0] = t22 + b_x * t29;
        stiffness[1][1] = b_x * t30;
        stiffness[1][2] = b_y * t29;
        stiffness[1][3] = t22 + b_y * t30;
        stiffness[2][0] = a_x * t29 + t25 * (t21 * t25) + t35;
        stiffness[2][1] = t33;
        stiffness[2][2] = t33;
        stiffness[2][3] = a_y * t30 + t26 * t31 + t35;
    }
    /// Writes the strain energy a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 7 additions, 18 multiplications.
    pub fn beam_planar_points3_energy(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 2],
        energy: &mut f64,
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t19 = 0.5 * (length * EA);
        let t20 = t19 * (0.5 * (a_x * a_x + a_y * a_y - 1.0)).powi(2)
            + t19 * (0.5 * (b_x * b_x + b_y * b_y - 1.0)).powi(2);
        *energy = t20 + 0.5 * (length * kyGA) * (a_x * b_x + a_y * b_y).powi(2);
    }
    /// Writes the forces on the fields a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 4 additions, 20 multiplications, 1 divisions.
    pub fn beam_planar_points2_force(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 3],
        forces: &mut [[f64; 2]; 3],
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t24 = inverse_length * ((a_x * db_x + a_y * db_y) * (length * EIz));
        let t25 = inverse_length * ((b_x * db_x + b_y * db_y) * (length * GIz));
        forces[0][0] = unit_db_x * t24;
        forces[0][1] = unit_db_y * t24;
        forces[1][0] = unit_db_x * t25;
        forces[1][1] = unit_db_y * t25;
        forces[2][0] = a_x * t24 + b_x * t25;
        forces[2][1] = a_y * t24 + b_y * t25;
    }
    /// Writes the blocks of the tangent on the fields a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 9 additions, 43 multiplications, 1 divisions.
    pub fn beam_planar_points2_tangent(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 3],
        stiffness: &mut [[f64; 4]; 6],
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t24 = length * EIz;
        let t25 = length * GIz;
        let t26 = inverse_length * ((a_x * db_x + a_y * db_y) * t24);
        let t27 = inverse_length * inverse_length;
        let t28 = t24 * t27;
        let t29 = inverse_length * ((b_x * db_x + b_y * db_y) * t25);
        let t30 = t25 * t27;
        let t31 = unit_db_y * t28;
        let t32 = a_x * t28;
        let t33 = a_y * t28;
        let t34 = unit_db_y * t30;
        let t35 = b_x * t30;
        let t36 = b_y * t30;
        let t37 = unit_db_x * t31;
        let t38 = unit_db_x * t34;
        let t39 = unit_db_x * t36;
        let t40 = unit_db_y * t35;
        let t41 = a_x * t33 + b_x * t36;
        let t42 = t29 + unit_db_x * t35;
        let t43 = t29 + unit_db_y * t36;
        stiffness[0][0] = unit_db_x * (unit_db_x * t28);
        stiffness[0][1] = t37;
        stiffness[0][2] = t37;
        stiffness[0][3] = unit_db_y * t31;
        stiffness[1][0] = t26 + unit_db_x * t32;
        stiffness[1][1] = unit_db_x * t33;
        stiffness[1][2] = unit_db_y * t32;
        stiffness[1][3] = t26 + unit_db_y * t33;
        stiffness[2][0] = unit_db_x * (unit_db_x * t30);
        stiffness[2][1] = t38;
        stiffness[2][2] = t38;
        stiffness[2][3] = unit_db_y * t34;
        stiffness[3][0] = t42;
        stiffness[3][1] = t39;
        stiffness[3][2] = t40;
        stiffness[3][3] = t43;
        stiffness[4][0] = t42;
        stiffness[4][1] = t40;
        stiffness[4][2] = t39;
        stiffness[4][3] = t43;
        stiffness[5][0] = a_x * t32 + b_x * t35;
        stiffness[5][1] = t41;
        stiffness[5][2] = t41;
        stiffness[5][3] = a_y * t33 + b_y * t36;
    }
    /// Writes the strain energy a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 3 additions, 14 multiplications, 1 divisions.
    pub fn beam_planar_points2_energy(
        row: &BeamPlanar,
        fields: &[[f64; 2]; 3],
        energy: &mut f64,
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t24 = 0.5 * (length * EIz) * (a_x * db_x + a_y * db_y).powi(2)
            + 0.5 * (length * GIz) * (b_x * db_x + b_y * db_y).powi(2);
        *energy = t24;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 179 additions, 265 multiplications, 2 divisions.
    pub fn beam_planar_elastic_force(
        row: &BeamPlanar,
        q: &[f64; 14],
        force: &mut [f64; 14],
    ) {
        let vectors = BEAM_PLANAR_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_PLANAR_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_planar_points3_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_PLANAR_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_planar_points2_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_PLANAR_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 897 additions, 1055 multiplications, 2 divisions.
    pub fn beam_planar_elastic_tangent(
        row: &BeamPlanar,
        q: &[f64; 14],
        stiffness: &mut [f64; 196],
    ) {
        let vectors = BEAM_PLANAR_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 4]; 3];
        BEAM_PLANAR_POINTS3
            .tangent(
                &vectors,
                (&BEAM_PLANAR_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_planar_points3_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_PLANAR_POINTS2
            .tangent(
                &vectors,
                (&BEAM_PLANAR_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_planar_points2_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_PLANAR_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 104 additions, 159 multiplications, 2 divisions.
    pub fn beam_planar_strain_energy(row: &BeamPlanar, q: &[f64; 14], energy: &mut f64) {
        let vectors = BEAM_PLANAR_VECTORS.relative(row.length, q);
        *energy
            += BEAM_PLANAR_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_planar_points3_energy(row, fields, &mut density);
                        density
                    },
                );
        *energy
            += BEAM_PLANAR_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_planar_points2_energy(row, fields, &mut density);
                        density
                    },
                );
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 17 multiplications.
    pub fn beam_planar_mass(row: &BeamPlanar, mass: &mut [f64; 49]) {
        let BeamPlanar { length, rhoA, rhoIz, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let mass_r0_r0 = element_mass * BEAM_PLANAR_MASS_MATRIX[0][0];
        let t18 = length * element_mass;
        let mass_r0_r0x = t18 * BEAM_PLANAR_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * BEAM_PLANAR_MASS_MATRIX[0][4];
        let mass_r0_r1x = t18 * BEAM_PLANAR_MASS_MATRIX[0][5];
        let t22 = element_mass * (length * length);
        let mass_r0x_r0x = t22 * BEAM_PLANAR_MASS_MATRIX[1][1];
        let mass_r0x_r1 = t18 * BEAM_PLANAR_MASS_MATRIX[1][4];
        let mass_r0x_r1x = t22 * BEAM_PLANAR_MASS_MATRIX[1][5];
        let mass_r0y_r0y = section_y_mass * BEAM_PLANAR_MASS_MATRIX[2][2];
        let mass_r0y_ry_half = section_y_mass * BEAM_PLANAR_MASS_MATRIX[2][3];
        let mass_r0y_r1y = section_y_mass * BEAM_PLANAR_MASS_MATRIX[2][6];
        let mass_ry_half_ry_half = section_y_mass * BEAM_PLANAR_MASS_MATRIX[3][3];
        let mass_r1_r1x = t18 * BEAM_PLANAR_MASS_MATRIX[4][5];
        mass[0] = mass_r0_r0;
        mass[1] = mass_r0_r0x;
        mass[2] = 0.0;
        mass[3] = 0.0;
        mass[4] = mass_r0_r1;
        mass[5] = mass_r0_r1x;
        mass[6] = 0.0;
        mass[7] = mass_r0_r0x;
        mass[8] = mass_r0x_r0x;
        mass[9] = 0.0;
        mass[10] = 0.0;
        mass[11] = mass_r0x_r1;
        mass[12] = mass_r0x_r1x;
        mass[13] = 0.0;
        mass[14] = 0.0;
        mass[15] = 0.0;
        mass[16] = mass_r0y_r0y;
        mass[17] = mass_r0y_ry_half;
        mass[18] = 0.0;
        mass[19] = 0.0;
        mass[20] = mass_r0y_r1y;
        mass[21] = 0.0;
        mass[22] = 0.0;
        mass[23] = mass_r0y_ry_half;
        mass[24] = mass_ry_half_ry_half;
        mass[25] = 0.0;
        mass[26] = 0.0;
        mass[27] = mass_r0y_ry_half;
        mass[28] = mass_r0_r1;
        mass[29] = mass_r0x_r1;
        mass[30] = 0.0;
        mass[31] = 0.0;
        mass[32] = mass_r0_r0;
        mass[33] = mass_r1_r1x;
        mass[34] = 0.0;
        mass[35] = mass_r0_r1x;
        mass[36] = mass_r0x_r1x;
        mass[37] = 0.0;
        mass[38] = 0.0;
        mass[39] = mass_r1_r1x;
        mass[40] = mass_r0x_r0x;
        mass[41] = 0.0;
        mass[42] = 0.0;
        mass[43] = 0.0;
        mass[44] = mass_r0y_r1y;
        mass[45] = mass_r0y_ry_half;
        mass[46] = 0.0;
        mass[47] = 0.0;
        mass[48] = mass_r0y_r0y;
    }
    /// Weights of the nodal vectors in the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 6 additions, 12 multiplications.
    pub fn beam_planar_shapes_position_0(length: f64, xi: f64, weights: &mut [f64; 7]) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[4] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[5] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn beam_planar_shapes_position_1(length: f64, xi: f64, weights: &mut [f64; 7]) {
        let t14 = 1.0 / length;
        let t15 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t14;
        weights[1] = 1.0 + xi * (-4.0 + t15);
        weights[4] = t14 * (xi * (6.0 + xi * (-6.0)));
        weights[5] = xi * (t15 + (-2.0));
    }
    /// Weights of the nodal vectors in the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_planar_shapes_section_y_0(length: f64, xi: f64, weights: &mut [f64; 7]) {
        let t13 = xi * 2.0;
        weights[2] = 1.0 + xi * (-3.0 + t13);
        weights[3] = xi * (4.0 + xi * (-4.0));
        weights[6] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_planar_shapes_section_y_1(length: f64, xi: f64, weights: &mut [f64; 7]) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[2] = (-3.0 + t14) * t15;
        weights[3] = t15 * (4.0 + xi * (-8.0));
        weights[6] = t15 * (t14 + (-1.0));
    }
    /// Writes the forces on the fields a, b, db at a point, dU/d(field) per unit length, from their values in the stress-free shape and at present.
    ///
    /// Operations: 29 additions, 53 multiplications.
    pub fn beam_planar_field_forces(
        row: &BeamPlanar,
        stress_free: &[f64; 6],
        fields: &[f64; 6],
        forces: &mut [f64; 6],
    ) {
        let BeamPlanar { length, EA, kyGA, EIz, GIz, .. } = *row;
        let t28 = 0.5 * (fields[0] * fields[0] + fields[1] * fields[1] - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    - 1.0);
        let t29 = EA * t28;
        let t30 = 0.5 * (fields[2] * fields[2] + fields[3] * fields[3] - 1.0)
            - 0.5
                * (stress_free[2] * stress_free[2] + stress_free[3] * stress_free[3]
                    - 1.0);
        let t31 = EA * t30;
        let t32 = kyGA
            * (fields[0] * fields[2] + fields[1] * fields[3]
                - (stress_free[0] * stress_free[2] + stress_free[1] * stress_free[3]));
        let t33 = EIz
            * (fields[0] * fields[4] + fields[1] * fields[5]
                - (stress_free[0] * stress_free[4] + stress_free[1] * stress_free[5]));
        let t34 = GIz
            * (fields[2] * fields[4] + fields[3] * fields[5]
                - (stress_free[2] * stress_free[4] + stress_free[3] * stress_free[5]));
        forces[0] = t29 * (0.5 * (fields[0] * 2.0)) + fields[2] * t32 + fields[4] * t33;
        forces[1] = t29 * (0.5 * (fields[1] * 2.0)) + fields[3] * t32 + fields[5] * t33;
        forces[2] = t31 * (0.5 * (fields[2] * 2.0)) + fields[0] * t32 + fields[4] * t34;
        forces[3] = t31 * (0.5 * (fields[3] * 2.0)) + fields[1] * t32 + fields[5] * t34;
        forces[4] = fields[0] * t33 + fields[2] * t34;
        forces[5] = fields[1] * t33 + fields[3] * t34;
    }
    /// Load `bend` in its frame's axes.
    ///
    /// Operations: 0 additions, 7 multiplications, 1 divisions.
    pub fn load_bend(model: &RollUp, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = 0.0;
        value[2] = 3.141592653589793
            * (model.turns * 2.0 * 3.141592653589793 * 210000000000.0) / 4.0
            * model.slenderness.powi(4);
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 4 additions, 0 multiplications.
    pub fn joint_root_absolute_position(
        model: &RollUp,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - data.point[1];
        rows[2] = q[2] - data.tangent[0];
        rows[3] = q[3] - data.tangent[1];
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_jacobian(
        model: &RollUp,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[5] = 1.0;
        jacobian[10] = 1.0;
        jacobian[15] = 1.0;
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_prescribed(
        model: &RollUp,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
    }
    /// Adds the generalised force of a moment on a slope, Q = m x s / (s . s) (virtual work of a turning slope).
    ///
    /// Operations: 3 additions, 4 multiplications, 2 divisions.
    pub fn moment_planar(slope: &[f64], moment: [f64; 3], force: &mut [f64]) {
        let t15 = slope[0] * slope[0] + slope[1] * slope[1];
        force[0] += -slope[1] * moment[0] / t15;
        force[1] += slope[0] * moment[0] / t15;
    }
    /// Adds its derivative with respect to the slope, rows first.
    ///
    /// Operations: 7 additions, 10 multiplications, 6 divisions.
    pub fn moment_tangent_planar(slope: &[f64], moment: [f64; 3], tangent: &mut [f64]) {
        let t15 = slope[0] * slope[0] + slope[1] * slope[1];
        let t16 = slope[1] * moment[0] / t15;
        let t17 = slope[0] * moment[0] / t15;
        let t18 = slope[0] * 2.0;
        let t19 = slope[1] * 2.0;
        tangent[0] += t16 * t18 / t15;
        tangent[1] += -(moment[0] - t16 * t19) / t15;
        tangent[2] += (moment[0] - t17 * t18) / t15;
        tangent[3] += -t17 * t19 / t15;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 3 additions, 2 multiplications, 1 function calls.
    pub fn outputs(model: &RollUp, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = ((observed[0] - observed[2]).powi(2)
            + (observed[1] - observed[3]).powi(2))
            .sqrt();
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &RollUp, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: RollUp,
        pub row_beam: BeamPlanar,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &RollUp) -> Self {
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
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 1,
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
            false
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
            Some("load `bend` is a moment, which has no potential")
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
                    axes: &[0, 1],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [1.0, 0.0, 0.0],
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
                            meaning: "section y axis",
                            of: ::rncf::emitted::Interpolant::SectionY,
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
                    ],
                    connectivity: &[0, 1, 2, 3, 4, 5, 6],
                    vectors_per_node: 3,
                    stride: 4,
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
                "material `steel`",
                "density",
                7850.0,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `steel`",
                "young",
                210000000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::emitted::poisson(
                "material `steel`",
                "poisson",
                0.3,
                "1",
            )?;
            let area = ::rncf::emitted::positive(
                "section `round`",
                "area",
                3.141592653589793 * (model.slenderness * model.slenderness),
                "m^2",
            )?;
            let second_moment_z = ::rncf::emitted::positive(
                "section `round`",
                "second_moment_z",
                0.7853981633974483 * model.slenderness.powi(4),
                "m^4",
            )?;
            let shear_factor_y = ::rncf::emitted::part(
                "section `round`",
                "shear_factor_y",
                0.8863636363636362,
                "1",
            )?;
            let radius = ::rncf::emitted::positive(
                "section `round`",
                "radius",
                model.slenderness,
                "m",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            self.row_beam = BeamPlanar {
                length,
                EA: young * area,
                kyGA: shear_factor_y * shear_modulus * area,
                EIz: young * second_moment_z,
                GIz: shear_modulus * second_moment_z,
                rhoA: density * area,
                rhoIz: density * second_moment_z,
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
            beam_planar_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_planar_elastic_force(
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
            beam_planar_elastic_tangent(
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
            beam_planar_strain_energy(
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
                    beam_planar_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    beam_planar_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    beam_planar_shapes_section_y_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    beam_planar_shapes_section_y_1(
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
                shape: ::rncf::emitted::SectionShape::Circle {
                    radius: model.slenderness,
                },
                area: 3.141592653589793 * (model.slenderness * model.slenderness),
                second_moments: [
                    0.7853981633974483 * model.slenderness.powi(4),
                    0.7853981633974483 * model.slenderness.powi(4),
                ],
                torsion_constant: 1.5707963267948966 * model.slenderness.powi(4),
                young_over_shear: 2.0 * (1.0 + 0.3),
                softness_of_curves: 2.0,
                yield_stress: None,
                material: "steel",
            }
        }
        fn fields(
            &self,
            body: usize,
        ) -> &'static [(::rncf::emitted::Interpolant, usize)] {
            &[
                (::rncf::emitted::Interpolant::Position, 1),
                (::rncf::emitted::Interpolant::SectionY, 0),
                (::rncf::emitted::Interpolant::SectionY, 1),
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
            beam_planar_field_forces(
                &self.row_beam,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array_mut(forces),
            );
        }
    }
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::JointConditions for Equations {
        fn joints(&self) -> ::std::vec::Vec<::rncf::emitted::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::JointSpec {
                    name: "root",
                    kind: ::rncf::emitted::JointKind::ClampFull,
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
                    name: "bend",
                    kind: ::rncf::emitted::LoadKind::Moment {
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
                0 => load_bend(&self.model, t, &mut value),
                _ => {}
            }
            value
        }
    }
    impl ::rncf::emitted::SlopeMoments for Equations {
        fn moment(
            &self,
            dimension: usize,
            slope: &[f64],
            moment: [f64; 3],
            force: &mut [f64],
        ) {
            match dimension {
                2 => moment_planar(slope, moment, force),
                _ => {}
            }
        }
        fn moment_tangent(
            &self,
            dimension: usize,
            slope: &[f64],
            moment: [f64; 3],
            tangent: &mut [f64],
        ) {
            match dimension {
                2 => moment_tangent_planar(slope, moment, tangent),
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::WithoutMarkerConstraints for Equations {}
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
