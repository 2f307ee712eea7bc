//! Expansion of `models/src/curved_out_of_plane.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use curved_out_of_plane_equations::CurvedOutOfPlane;
#[allow(clippy::all)]
impl Default for CurvedOutOfPlane {
    fn default() -> Self {
        Self {
            omega_s: 4.0,
            T_s: 15.0,
            elements: 8,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for CurvedOutOfPlane {
    const NAME: &'static str = "CurvedOutOfPlane";
    const DOC: &'static str = "Spin-up of a beam that is curved along the axis of rotation (Ren & Yang 2021, section 4.1.2).";
    const SOURCE: &'static str = r#"pub model CurvedOutOfPlane {
    /// Steady angular velocity.
    param omega_s = 4 rad/s;
    /// Time to reach it.
    param T_s = 15 s;
    /// Number of elements.
    param elements: count = 8;

    const bend = 16 m;
    const turn = 0.5 rad;

    material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
    section tube {
        area = 0.7299 cm^2;
        second_moment = 0.8215 cm^4;
        torsion_constant = 1.643 cm^4;
        shear_factor = 0.53;
    }

    /// Angle of the hub, Eq. (22).
    motion theta(t) =
        if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { omega_s * (t - T_s/2) };
    frame hub = rotating(axis = z, angle = theta(t));

    body beam in hub {
        spatial;
        arc from [0, 0, 0] m direction [1, 0, 0] normal [0, -1, 0] radius bend angle turn;
        mesh elements * beam(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);

    /// Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.
    output u = beam.end.x - bend * sin(turn);
    /// The same along y, in the plane of rotation.
    output v = beam.end.y;
    /// The same along z, the axis of rotation.
    output w = beam.end.z - bend * (1 - cos(turn));

    run { t_end = 20 s; every = 0.05 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x558db6e355455b27;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1261 and 9795).",
        "Body `beam` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix.",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "BEAM_SPATIAL_CURVED_MASS_MATRIX",
            size: [10, 10],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points3_force",
            additions: 39,
            multiplications: 70,
            divisions: 0,
            functions: 0,
            weighted: 109,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points3_tangent",
            additions: 75,
            multiplications: 156,
            divisions: 0,
            functions: 0,
            weighted: 231,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points3_energy",
            additions: 26,
            multiplications: 41,
            divisions: 0,
            functions: 0,
            weighted: 67,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points2_force",
            additions: 43,
            multiplications: 81,
            divisions: 1,
            functions: 0,
            weighted: 128,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points2_tangent",
            additions: 149,
            multiplications: 342,
            divisions: 1,
            functions: 0,
            weighted: 495,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_points2_energy",
            additions: 25,
            multiplications: 49,
            divisions: 1,
            functions: 0,
            weighted: 78,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_reference",
            additions: 178,
            multiplications: 251,
            divisions: 1,
            functions: 0,
            weighted: 433,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_mass",
            additions: 0,
            multiplications: 22,
            divisions: 0,
            functions: 0,
            weighted: 22,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_section_z_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_shapes_section_z_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_curved_field_forces",
            additions: 130,
            multiplications: 197,
            divisions: 0,
            functions: 0,
            weighted: 327,
        },
        ::rncf::model::KernelCount {
            name: "frame_hub",
            additions: 8,
            multiplications: 13,
            divisions: 6,
            functions: 4,
            weighted: 125,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_referenced_position",
            additions: 15,
            multiplications: 19,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_referenced_jacobian",
            additions: 3,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_position",
            additions: 25,
            multiplications: 37,
            divisions: 5,
            functions: 3,
            weighted: 142,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_velocity",
            additions: 28,
            multiplications: 50,
            divisions: 6,
            functions: 4,
            weighted: 182,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_acceleration",
            additions: 65,
            multiplications: 86,
            divisions: 6,
            functions: 4,
            weighted: 255,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jerk",
            additions: 121,
            multiplications: 126,
            divisions: 6,
            functions: 4,
            weighted: 351,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jacobian",
            additions: 12,
            multiplications: 26,
            divisions: 5,
            functions: 3,
            weighted: 118,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_prescribed",
            additions: 28,
            multiplications: 55,
            divisions: 6,
            functions: 4,
            weighted: 187,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "omega_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 4.0,
                doc: "Steady angular velocity.",
            },
            ::rncf::Param {
                name: "T_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 15.0,
                doc: "Time to reach it.",
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
                name: "u",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.",
            },
            ::rncf::Output {
                name: "v",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "The same along y, in the plane of rotation.",
            },
            ::rncf::Output {
                name: "w",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "The same along z, the axis of rotation.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_s,
            1 => self.T_s,
            2 => self.elements as f64,
            _ => panic!("CurvedOutOfPlane has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            _ => panic!("CurvedOutOfPlane has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        curved_out_of_plane_equations::run_defaults(self, &mut run);
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
        let equations = curved_out_of_plane_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`CurvedOutOfPlane`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod curved_out_of_plane_equations {
    /// Spin-up of a beam that is curved along the axis of rotation (Ren & Yang 2021, section 4.1.2).
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1261 and 9795).
    /// * Body `beam` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix.
    /// * Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct CurvedOutOfPlane {
        /// Steady angular velocity. (SI; declared in rad/s)
        pub omega_s: f64,
        /// Time to reach it. (SI; declared in s)
        pub T_s: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `beam_spatial_curved`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1261 and 9795).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatialCurved {
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
    pub const BEAM_SPATIAL_CURVED_MASS_MATRIX: [[f64; 10]; 10] = [
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
    static BEAM_SPATIAL_CURVED_VECTORS: ::rncf::emitted::Vectors<10, 3, 3, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_CURVED_POINTS3: ::rncf::emitted::Rule<3, 3, 3> = ::rncf::emitted::Rule {
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
    static BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 6> = BEAM_SPATIAL_CURVED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_CURVED_POINTS2: ::rncf::emitted::Rule<2, 5, 3> = ::rncf::emitted::Rule {
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
    static BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<2, 9, 15> = BEAM_SPATIAL_CURVED_POINTS2
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
    /// Writes the forces on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 39 additions, 70 multiplications.
    pub fn beam_spatial_curved_points3_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatialCurved {
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
        let t32 = length * EA;
        let t33 = t32 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0]);
        let t34 = 0.5 * t33;
        let t35 = length * kyGA * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]);
        let t36 = length * kzGA * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]);
        let t37 = t32 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1]);
        let t38 = 0.5 * t37;
        let t39 = length * halfEA * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t40 = t32 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2]);
        let t41 = 0.5 * t40;
        forces[0][0] = t34 * (a_x * 2.0) + b_x * t35 + c_x * t36;
        forces[0][1] = t34 * (a_y * 2.0) + b_y * t35 + c_y * t36;
        forces[0][2] = t34 * (a_z * 2.0) + b_z * t35 + c_z * t36;
        forces[1][0] = a_x * t35 + t38 * (b_x * 2.0) + c_x * t39;
        forces[1][1] = a_y * t35 + t38 * (b_y * 2.0) + c_y * t39;
        forces[1][2] = a_z * t35 + t38 * (b_z * 2.0) + c_z * t39;
        forces[2][0] = a_x * t36 + b_x * t39 + t41 * (c_x * 2.0);
        forces[2][1] = a_y * t36 + b_y * t39 + t41 * (c_y * 2.0);
        forces[2][2] = a_z * t36 + b_z * t39 + t41 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 75 additions, 156 multiplications.
    pub fn beam_spatial_curved_points3_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatialCurved {
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
        let t32 = length * EA;
        let t33 = length * kyGA;
        let t34 = length * kzGA;
        let t35 = length * halfEA;
        let t36 = 0.5 * (0.5 * t32);
        let t37 = t32 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0]);
        let t38 = t33 * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]);
        let t39 = t34 * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]);
        let t40 = t32 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1]);
        let t41 = t35 * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t42 = t32 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2]);
        let t43 = a_x * 2.0;
        let t44 = a_y * 2.0;
        let t45 = a_z * 2.0;
        let t46 = b_x * 2.0;
        let t47 = b_y * 2.0;
        let t48 = b_z * 2.0;
        let t49 = c_x * 2.0;
        let t50 = c_y * 2.0;
        let t51 = c_z * 2.0;
        let t52 = t36 * t44;
        let t53 = t36 * t45;
        let t54 = b_y * t33;
        let t55 = b_z * t33;
        let t56 = a_x * t33;
        let t57 = a_y * t33;
        let t58 = a_z * t33;
        let t59 = c_y * t34;
        let t60 = c_z * t34;
        let t61 = a_x * t34;
        let t62 = a_y * t34;
        let t63 = a_z * t34;
        let t64 = t36 * t47;
        let t65 = t36 * t48;
        let t66 = c_y * t35;
        let t67 = c_z * t35;
        let t68 = b_x * t35;
        let t69 = b_y * t35;
        let t70 = b_z * t35;
        let t71 = t36 * t50;
        let t72 = t36 * t51;
        let t73 = t43 * t52 + b_x * t54 + c_x * t59;
        let t74 = t43 * t53 + b_x * t55 + c_x * t60;
        let t75 = t44 * t53 + b_y * t55 + c_y * t60;
        let t76 = a_x * t57 + t46 * t64 + c_x * t66;
        let t77 = a_x * t58 + t46 * t65 + c_x * t67;
        let t78 = a_y * t58 + t47 * t65 + c_y * t67;
        let t79 = a_x * t62 + b_x * t69 + t49 * t71;
        let t80 = a_x * t63 + b_x * t70 + t49 * t72;
        let t81 = a_y * t63 + b_y * t70 + t50 * t72;
        let t82 = 0.5 * t37 * 2.0;
        let t83 = t43 * (t36 * t43) + b_x * (b_x * t33) + c_x * (c_x * t34) + t82;
        let t84 = 0.5 * t40 * 2.0;
        let t85 = 0.5 * t42 * 2.0;
        stiffness[0][0] = t83;
        stiffness[0][1] = t73;
        stiffness[0][2] = t74;
        stiffness[0][3] = t73;
        stiffness[0][4] = t44 * t52 + b_y * t54 + c_y * t59 + t82;
        stiffness[0][5] = t75;
        stiffness[0][6] = t74;
        stiffness[0][7] = t75;
        stiffness[0][8] = t45 * t53 + b_z * t55 + c_z * t60 + t82;
        stiffness[1][0] = t38 + b_x * t56;
        stiffness[1][1] = b_x * t57;
        stiffness[1][2] = b_x * t58;
        stiffness[1][3] = b_y * t56;
        stiffness[1][4] = t38 + b_y * t57;
        stiffness[1][5] = b_y * t58;
        stiffness[1][6] = b_z * t56;
        stiffness[1][7] = b_z * t57;
        stiffness[1][8] = t38 + b_z * t58;
        stiffness[2][0] = t39 + c_x * t61;
        stiffness[2][1] = c_x * t62;
        stiffness[2][2] = c_x * t63;
        stiffness[2][3] = c_y * t61;
        stiffness[2][4] = t39 + c_y * t62;
        stiffness[2][5] = c_y * t63;
        stiffness[2][6] = c_z * t61;
        stiffness[2][7] = c_z * t62;
        stiffness[2][8] = t39 + c_z * t63;
        stiffness[3][0] = a_x * t56 + t46 * (t36 * t46) + c_x * (c_x * t35) + t84;
        stiffness[3][1] = t76;
        stiffness[3][2] = t77;
        stiffness[3][3] = t76;
        stiffness[3][4] = a_y * t57 + t47 * t64 + c_y * t66 + t84;
        stiffness[3][5] = t78;
        stiffness[3][6] = t77;
        stiffness[3][7] = t78;
        stiffness[3][8] = a_z * t58 + t48 * t65 + c_z * t67 + t84;
        stiffness[4][0] = t41 + c_x * t68;
        stiffness[4][1] = c_x * t69;
        stiffness[4][2] = c_x * t70;
        stiffness[4][3] = c_y * t68;
        stiffness[4][4] = t41 + c_y * t69;
        stiffness[4][5] = c_y * t70;
        stiffness[4][6] = c_z * t68;
        stiffness[4][7] = c_z * t69;
        stiffness[4][8] = t41 + c_z * t70;
        stiffness[5][0] = a_x * t61 + b_x * t68 + t49 * (t36 * t49) + t85;
        stiffness[5][1] = t79;
        stiffness[5][2] = t80;
        stiffness[5][3] = t79;
        stiffness[5][4] = a_y * t62 + b_y * t69 + t50 * t71 + t85;
        stiffness[5][5] = t81;
        stiffness[5][6] = t80;
        stiffness[5][7] = t81;
        stiffness[5][8] = a_z * t63 + b_z * t70 + t51 * t72 + t85;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 26 additions, 41 multiplications.
    pub fn beam_spatial_curved_points3_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatialCurved {
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
        let t32 = 0.5 * (length * EA);
        let t33 = (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0])
            .powi(2);
        let t34 = (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1])
            .powi(2);
        let t35 = (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2])
            .powi(2);
        let t36 = 0.5 * (length * kyGA)
            * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]).powi(2);
        let t37 = 0.5 * (length * kzGA)
            * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]).powi(2);
        let t38 = 0.5 * (length * halfEA)
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]).powi(2);
        *energy = t32 * t33 + t32 * t34 + t32 * t35 + t36 + t37 + t38;
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 43 additions, 81 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatialCurved {
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
        let t47 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t48 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t49 = length * GJ * (0.5 * (t48 - t47) - reference[2]);
        let t50 = length * GIyz * (t47 + t48 - reference[5]);
        let t51 = inverse_length
            * (length * EIz * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]));
        let t52 = inverse_length
            * (length * EIy * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]));
        let t53 = inverse_length
            * (length * GIz * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]));
        let t54 = inverse_length * (-0.5 * t49 + t50);
        let t55 = inverse_length * (t50 + 0.5 * t49);
        let t56 = inverse_length
            * (length * GIy * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]));
        forces[0][0] = unit_db_x * t51 + unit_dc_x * t52;
        forces[0][1] = unit_db_y * t51 + unit_dc_y * t52;
        forces[0][2] = unit_db_z * t51 + unit_dc_z * t52;
        forces[1][0] = unit_db_x * t53 + unit_dc_x * t54;
        forces[1][1] = unit_db_y * t53 + unit_dc_y * t54;
        forces[1][2] = unit_db_z * t53 + unit_dc_z * t54;
        forces[2][0] = unit_db_x * t55 + unit_dc_x * t56;
        forces[2][1] = unit_db_y * t55 + unit_dc_y * t56;
        forces[2][2] = unit_db_z * t55 + unit_dc_z * t56;
        forces[3][0] = a_x * t51 + b_x * t53 + c_x * t55;
        forces[3][1] = a_y * t51 + b_y * t53 + c_y * t55;
        forces[3][2] = a_z * t51 + b_z * t53 + c_z * t55;
        forces[4][0] = a_x * t52 + b_x * t54 + c_x * t56;
        forces[4][1] = a_y * t52 + b_y * t54 + c_y * t56;
        forces[4][2] = a_z * t52 + b_z * t54 + c_z * t56;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 149 additions, 342 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatialCurved {
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
        let t47 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t48 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t49 = length * EIz;
        let t50 = length * EIy;
        let t51 = length * GJ;
        let t52 = 0.5 * t51;
        let t53 = length * GIz;
        let t54 = length * GIy;
        let t55 = length * GIyz;
        let t56 = t51 * (-0.5);
        let t57 = t51 * (0.5 * (t48 - t47) - reference[2]);
        let t58 = t55 * (t47 + t48 - reference[5]);
        let t59 = inverse_length
            * (t49 * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]));
        let t60 = inverse_length * inverse_length;
        let t61 = t49 * t60;
        let t62 = inverse_length
            * (t50 * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]));
        let t63 = t50 * t60;
        let t64 = inverse_length
            * (t53 * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]));
        let t65 = t53 * t60;
        let t66 = inverse_length * (-0.5 * t57 + t58);
        let t67 = (t55 + (-0.5 * t56)) * t60;
        let t68 = (t55 + (-0.5 * t52)) * t60;
        let t69 = inverse_length * (t58 + 0.5 * t57);
        let t70 = (t55 + 0.5 * t56) * t60;
        let t71 = (t55 + 0.5 * t52) * t60;
        let t72 = inverse_length
            * (t54 * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]));
        let t73 = t54 * t60;
        let t74 = unit_db_x * t61;
        let t75 = unit_db_y * t61;
        let t76 = unit_db_z * t61;
        let t77 = a_x * t61;
        let t78 = a_y * t61;
        let t79 = a_z * t61;
        let t80 = unit_dc_x * t63;
        let t81 = unit_dc_y * t63;
        let t82 = unit_dc_z * t63;
        let t83 = a_x * t63;
        let t84 = a_y * t63;
        let t85 = a_z * t63;
        let t86 = unit_db_x * t65;
        let t87 = unit_db_y * t65;
        let t88 = unit_db_z * t65;
        let t89 = b_x * t65;
        let t90 = b_y * t65;
        let t91 = b_z * t65;
        let t92 = unit_dc_x * t67;
        let t93 = unit_dc_y * t67;
        let t94 = unit_dc_z * t67;
        let t95 = unit_db_x * t68;
        let t96 = unit_db_y * t68;
        let t97 = unit_db_z * t68;
        let t98 = c_x * t68;
        let t99 = c_y * t68;
        let t100 = c_z * t68;
        let t101 = b_x * t67;
        let t102 = b_y * t67;
        let t103 = b_z * t67;
        let t104 = unit_dc_x * t70;
        let t105 = unit_dc_y * t70;
        let t106 = unit_dc_z * t70;
        let t107 = unit_db_x * t71;
        let t108 = unit_db_y * t71;
        let t109 = unit_db_z * t71;
        let t110 = c_x * t71;
        let t111 = c_y * t71;
        let t112 = c_z * t71;
        let t113 = b_x * t70;
        let t114 = b_y * t70;
        let t115 = b_z * t70;
        let t116 = unit_dc_x * t73;
        let t117 = unit_dc_y * t73;
        let t118 = unit_dc_z * t73;
        let t119 = c_x * t73;
        let t120 = c_y * t73;
        let t121 = c_z * t73;
        stiffness[0][0] = unit_db_x * t74 + unit_dc_x * t80;
        stiffness[0][1] = unit_db_x * t75 + unit_dc_x * t81;
        stiffness[0][2] = unit_db_x * t76 + unit_dc_x * t82;
        stiffness[0][3] = unit_db_y * t74 + unit_dc_y * t80;
        stiffness[0][4] = unit_db_y * t75 + unit_dc_y * t81;
        stiffness[0][5] = unit_db_y * t76 + unit_dc_y * t82;
        stiffness[0][6] = unit_db_z * t74 + unit_dc_z * t80;
        stiffness[0][7] = unit_db_z * t75 + unit_dc_z * t81;
        stiffness[0][8] = unit_db_z * t76 + unit_dc_z * t82;
        stiffness[1][0] = t59 + unit_db_x * t77;
        stiffness[1][1] = unit_db_x * t78;
        stiffness[1][2] = unit_db_x * t79;
        stiffness[1][3] = unit_db_y * t77;
        stiffness[1][4] = t59 + unit_db_y * t78;
        stiffness[1][5] = unit_db_y * t79;
        stiffness[1][6] = unit_db_z * t77;
        stiffness[1][7] = unit_db_z * t78;
        stiffness[1][8] = t59 + unit_db_z * t79;
        stiffness[2][0] = t62 + unit_dc_x * t83;
        stiffness[2][1] = unit_dc_x * t84;
        stiffness[2][2] = unit_dc_x * t85;
        stiffness[2][3] = unit_dc_y * t83;
        stiffness[2][4] = t62 + unit_dc_y * t84;
        stiffness[2][5] = unit_dc_y * t85;
        stiffness[2][6] = unit_dc_z * t83;
        stiffness[2][7] = unit_dc_z * t84;
        stiffness[2][8] = t62 + unit_dc_z * t85;
        stiffness[3][0] = unit_db_x * t86 + unit_dc_x * t92;
        stiffness[3][1] = unit_db_x * t87 + unit_dc_x * t93;
        stiffness[3][2] = unit_db_x * t88 + unit_dc_x * t94;
        stiffness[3][3] = unit_db_y * t86 + unit_dc_y * t92;
        stiffness[3][4] = unit_db_y * t87 + unit_dc_y * t93;
        stiffness[3][5] = unit_db_y * t88 + unit_dc_y * t94;
        stiffness[3][6] = unit_db_z * t86 + unit_dc_z * t92;
        stiffness[3][7] = unit_db_z * t87 + unit_dc_z * t93;
        stiffness[3][8] = unit_db_z * t88 + unit_dc_z * t94;
        stiffness[4][0] = t64 + (unit_db_x * t89 + unit_dc_x * t98);
        stiffness[4][1] = unit_db_x * t90 + unit_dc_x * t99;
        stiffness[4][2] = unit_db_x * t91 + unit_dc_x * t100;
        stiffness[4][3] = unit_db_y * t89 + unit_dc_y * t98;
        stiffness[4][4] = t64 + (unit_db_y * t90 + unit_dc_y * t99);
        stiffness[4][5] = unit_db_y * t91 + unit_dc_y * t100;
        stiffness[4][6] = unit_db_z * t89 + unit_dc_z * t98;
        stiffness[4][7] = unit_db_z * t90 + unit_dc_z * t99;
        stiffness[4][8] = t64 + (unit_db_z * t91 + unit_dc_z * t100);
        stiffness[5][0] = t64 + (b_x * t86 + c_x * t104);
        stiffness[5][1] = b_x * t87 + c_x * t105;
        stiffness[5][2] = b_x * t88 + c_x * t106;
        stiffness[5][3] = b_y * t86 + c_y * t104;
        stiffness[5][4] = t64 + (b_y * t87 + c_y * t105);
        stiffness[5][5] = b_y * t88 + c_y * t106;
        stiffness[5][6] = b_z * t86 + c_z * t104;
        stiffness[5][7] = b_z * t87 + c_z * t105;
        stiffness[5][8] = t64 + (b_z * t88 + c_z * t106);
        stiffness[6][0] = a_x * t77 + b_x * t89 + c_x * t110;
        stiffness[6][1] = a_x * t78 + b_x * t90 + c_x * t111;
        stiffness[6][2] = a_x * t79 + b_x * t91 + c_x * t112;
        stiffness[6][3] = a_y * t77 + b_y * t89 + c_y * t110;
        stiffness[6][4] = a_y * t78 + b_y * t90 + c_y * t111;
        stiffness[6][5] = a_y * t79 + b_y * t91 + c_y * t112;
        stiffness[6][6] = a_z * t77 + b_z * t89 + c_z * t110;
        stiffness[6][7] = a_z * t78 + b_z * t90 + c_z * t111;
        stiffness[6][8] = a_z * t79 + b_z * t91 + c_z * t112;
        stiffness[7][0] = unit_dc_x * t95;
        stiffness[7][1] = unit_dc_x * t96;
        stiffness[7][2] = unit_dc_x * t97;
        stiffness[7][3] = unit_dc_y * t95;
        stiffness[7][4] = unit_dc_y * t96;
        stiffness[7][5] = unit_dc_y * t97;
        stiffness[7][6] = unit_dc_z * t95;
        stiffness[7][7] = unit_dc_z * t96;
        stiffness[7][8] = unit_dc_z * t97;
        stiffness[8][0] = t66 + unit_dc_x * t101;
        stiffness[8][1] = unit_dc_x * t102;
        stiffness[8][2] = unit_dc_x * t103;
        stiffness[8][3] = unit_dc_y * t101;
        stiffness[8][4] = t66 + unit_dc_y * t102;
        stiffness[8][5] = unit_dc_y * t103;
        stiffness[8][6] = unit_dc_z * t101;
        stiffness[8][7] = unit_dc_z * t102;
        stiffness[8][8] = t66 + unit_dc_z * t103;
        stiffness[9][0] = t69 + c_x * t107;
        stiffness[9][1] = c_x * t108;
        stiffness[9][2] = c_x * t109;
        stiffness[9][3] = c_y * t107;
        stiffness[9][4] = t69 + c_y * t108;
        stiffness[9][5] = c_y * t109;
        stiffness[9][6] = c_z * t107;
        stiffness[9][7] = c_z * t108;
        stiffness[9][8] = t69 + c_z * t109;
        stiffness[10][0] = c_x * t113;
        stiffness[10][1] = c_x * t114;
        stiffness[10][2] = c_x * t115;
        stiffness[10][3] = c_y * t113;
        stiffness[10][4] = c_y * t114;
        stiffness[10][5] = c_y * t115;
        stiffness[10][6] = c_z * t113;
        stiffness[10][7] = c_z * t114;
        stiffness[10][8] = c_z * t115;
        stiffness[11][0] = unit_db_x * t107 + unit_dc_x * t116;
        stiffness[11][1] = unit_db_x * t108 + unit_dc_x * t117;
        stiffness[11][2] = unit_db_x * t109 + unit_dc_x * t118;
        stiffness[11][3] = unit_db_y * t107 + unit_dc_y * t116;
        stiffness[11][4] = unit_db_y * t108 + unit_dc_y * t117;
        stiffness[11][5] = unit_db_y * t109 + unit_dc_y * t118;
        stiffness[11][6] = unit_db_z * t107 + unit_dc_z * t116;
        stiffness[11][7] = unit_db_z * t108 + unit_dc_z * t117;
        stiffness[11][8] = unit_db_z * t109 + unit_dc_z * t118;
        stiffness[12][0] = t72 + (unit_db_x * t113 + unit_dc_x * t119);
        stiffness[12][1] = unit_db_x * t114 + unit_dc_x * t120;
        stiffness[12][2] = unit_db_x * t115 + unit_dc_x * t121;
        stiffness[12][3] = unit_db_y * t113 + unit_dc_y * t119;
        stiffness[12][4] = t72 + (unit_db_y * t114 + unit_dc_y * t120);
        stiffness[12][5] = unit_db_y * t115 + unit_dc_y * t121;
        stiffness[12][6] = unit_db_z * t113 + unit_dc_z * t119;
        stiffness[12][7] = unit_db_z * t114 + unit_dc_z * t120;
        stiffness[12][8] = t72 + (unit_db_z * t115 + unit_dc_z * t121);
        stiffness[13][0] = t72 + (b_x * t95 + c_x * t116);
        stiffness[13][1] = b_x * t96 + c_x * t117;
        stiffness[13][2] = b_x * t97 + c_x * t118;
        stiffness[13][3] = b_y * t95 + c_y * t116;
        stiffness[13][4] = t72 + (b_y * t96 + c_y * t117);
        stiffness[13][5] = b_y * t97 + c_y * t118;
        stiffness[13][6] = b_z * t95 + c_z * t116;
        stiffness[13][7] = b_z * t96 + c_z * t117;
        stiffness[13][8] = t72 + (b_z * t97 + c_z * t118);
        stiffness[14][0] = a_x * t83 + b_x * t101 + c_x * t119;
        stiffness[14][1] = a_x * t84 + b_x * t102 + c_x * t120;
        stiffness[14][2] = a_x * t85 + b_x * t103 + c_x * t121;
        stiffness[14][3] = a_y * t83 + b_y * t101 + c_y * t119;
        stiffness[14][4] = a_y * t84 + b_y * t102 + c_y * t120;
        stiffness[14][5] = a_y * t85 + b_y * t103 + c_y * t121;
        stiffness[14][6] = a_z * t83 + b_z * t101 + c_z * t119;
        stiffness[14][7] = a_z * t84 + b_z * t102 + c_z * t120;
        stiffness[14][8] = a_z * t85 + b_z * t103 + c_z * t121;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 25 additions, 49 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatialCurved {
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
        let t47 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t48 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t49 = 0.5 * (length * EIz)
            * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]).powi(2);
        let t50 = 0.5 * (length * EIy)
            * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]).powi(2);
        let t51 = t49 + t50
            + 0.5 * (length * GJ) * (0.5 * (t48 - t47) - reference[2]).powi(2);
        let t52 = 0.5 * (length * GIz)
            * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]).powi(2);
        let t53 = 0.5 * (length * GIy)
            * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]).powi(2);
        let t54 = t51 + t52 + t53
            + 0.5 * (length * GIyz) * (t47 + t48 - reference[5]).powi(2);
        *energy = t54;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 545 additions, 714 multiplications, 2 divisions.
    pub fn beam_spatial_curved_elastic_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 30],
        q: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_SPATIAL_CURVED_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_curved_points3_force(
                    row,
                    ::rncf::emitted::array(&reference[0 + 6 * point..][..6]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_CURVED_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_curved_points2_force(
                    row,
                    ::rncf::emitted::array(&reference[18 + 6 * point..][..6]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_CURVED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 4582 additions, 5211 multiplications, 2 divisions.
    pub fn beam_spatial_curved_elastic_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 30],
        q: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_CURVED_POINTS3
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_curved_points3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[0 + 6 * point..][..6]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_CURVED_POINTS2
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_curved_points2_tangent(
                    row,
                    ::rncf::emitted::array(&reference[18 + 6 * point..][..6]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_CURVED_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 304 additions, 397 multiplications, 2 divisions.
    pub fn beam_spatial_curved_strain_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 30],
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_CURVED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_curved_points3_energy(
                            row,
                            ::rncf::emitted::array(&reference[0 + 6 * point..][..6]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_CURVED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_curved_points2_energy(
                            row,
                            ::rncf::emitted::array(&reference[18 + 6 * point..][..6]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
    }
    /// Values of one element in the stress-free shape, which the other kernels subtract.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points, unrolled.
    ///
    /// Operations: 178 additions, 251 multiplications, 1 divisions.
    pub fn beam_spatial_curved_reference(
        row: &BeamSpatialCurved,
        q: &[f64; 30],
        reference: &mut [f64; 30],
    ) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let [r0_x, r0_y, r0_z, r0x_x, r0x_y, r0x_z, r0y_x, r0y_y, r0y_z, r0z_x, r0z_y,
        r0z_z, ry_half_x, ry_half_y, ry_half_z, rz_half_x, rz_half_y, rz_half_z, r1_x,
        r1_y, r1_z, r1x_x, r1x_y, r1x_z, r1y_x, r1y_y, r1y_z, r1z_x, r1z_y, r1z_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t47 = d_x * 0.6;
        let t48 = d_y * 0.6;
        let t49 = d_z * 0.6;
        let t50 = r0x_x * 0.5872983346207417 + t47 + r1x_x * (-0.18729833462074166);
        let t51 = r0x_y * 0.5872983346207417 + t48 + r1x_y * (-0.18729833462074166);
        let t52 = r0x_z * 0.5872983346207417 + t49 + r1x_z * (-0.18729833462074166);
        let t53 = ry_half_x * 0.39999999999999997;
        let t54 = ry_half_y * 0.39999999999999997;
        let t55 = ry_half_z * 0.39999999999999997;
        let t56 = r0y_x * 0.6872983346207417 + t53 + r1y_x * (-0.08729833462074169);
        let t57 = r0y_y * 0.6872983346207417 + t54 + r1y_y * (-0.08729833462074169);
        let t58 = r0y_z * 0.6872983346207417 + t55 + r1y_z * (-0.08729833462074169);
        let t59 = rz_half_x * 0.39999999999999997;
        let t60 = rz_half_y * 0.39999999999999997;
        let t61 = rz_half_z * 0.39999999999999997;
        let t62 = r0z_x * 0.6872983346207417 + t59 + r1z_x * (-0.08729833462074169);
        let t63 = r0z_y * 0.6872983346207417 + t60 + r1z_y * (-0.08729833462074169);
        let t64 = r0z_z * 0.6872983346207417 + t61 + r1z_z * (-0.08729833462074169);
        let t65 = r0x_x * (-0.25) + d_x * 1.5 + r1x_x * (-0.25);
        let t66 = r0x_y * (-0.25) + d_y * 1.5 + r1x_y * (-0.25);
        let t67 = r0x_z * (-0.25) + d_z * 1.5 + r1x_z * (-0.25);
        let t68 = t47 + r0x_x * (-0.18729833462074175) + r1x_x * 0.5872983346207418;
        let t69 = t48 + r0x_y * (-0.18729833462074175) + r1x_y * 0.5872983346207418;
        let t70 = t49 + r0x_z * (-0.18729833462074175) + r1x_z * 0.5872983346207418;
        let t71 = t53 + r0y_x * (-0.08729833462074166) + r1y_x * 0.6872983346207417;
        let t72 = t54 + r0y_y * (-0.08729833462074166) + r1y_y * 0.6872983346207417;
        let t73 = t55 + r0y_z * (-0.08729833462074166) + r1y_z * 0.6872983346207417;
        let t74 = t59 + r0z_x * (-0.08729833462074166) + r1z_x * 0.6872983346207417;
        let t75 = t60 + r0z_y * (-0.08729833462074166) + r1z_y * 0.6872983346207417;
        let t76 = t61 + r0z_z * (-0.08729833462074166) + r1z_z * 0.6872983346207417;
        let t77 = d_x + r0x_x * 0.28867513459481287 + r1x_x * (-0.2886751345948129);
        let t78 = d_y + r0x_y * 0.28867513459481287 + r1x_y * (-0.2886751345948129);
        let t79 = d_z + r0x_z * 0.28867513459481287 + r1x_z * (-0.2886751345948129);
        let t80 = ry_half_x * 0.6666666666666667;
        let t81 = ry_half_y * 0.6666666666666667;
        let t82 = ry_half_z * 0.6666666666666667;
        let t83 = r0y_x * 0.4553418012614795 + t80 + r1y_x * (-0.12200846792814622);
        let t84 = r0y_y * 0.4553418012614795 + t81 + r1y_y * (-0.12200846792814622);
        let t85 = r0y_z * 0.4553418012614795 + t82 + r1y_z * (-0.12200846792814622);
        let t86 = rz_half_x * 0.6666666666666667;
        let t87 = rz_half_y * 0.6666666666666667;
        let t88 = rz_half_z * 0.6666666666666667;
        let t89 = r0z_x * 0.4553418012614795 + t86 + r1z_x * (-0.12200846792814622);
        let t90 = r0z_y * 0.4553418012614795 + t87 + r1z_y * (-0.12200846792814622);
        let t91 = r0z_z * 0.4553418012614795 + t88 + r1z_z * (-0.12200846792814622);
        let t92 = inverse_length
            * (r0y_x * (-2.1547005383792515) + ry_half_x * 2.309401076758503
                + r1y_x * (-0.15470053837925146));
        let t93 = inverse_length
            * (r0y_y * (-2.1547005383792515) + ry_half_y * 2.309401076758503
                + r1y_y * (-0.15470053837925146));
        let t94 = inverse_length
            * (r0y_z * (-2.1547005383792515) + ry_half_z * 2.309401076758503
                + r1y_z * (-0.15470053837925146));
        let t95 = inverse_length
            * (r0z_x * (-2.1547005383792515) + rz_half_x * 2.309401076758503
                + r1z_x * (-0.15470053837925146));
        let t96 = inverse_length
            * (r0z_y * (-2.1547005383792515) + rz_half_y * 2.309401076758503
                + r1z_y * (-0.15470053837925146));
        let t97 = inverse_length
            * (r0z_z * (-2.1547005383792515) + rz_half_z * 2.309401076758503
                + r1z_z * (-0.15470053837925146));
        let t98 = t83 * t95 + t84 * t96 + t85 * t97;
        let t99 = t89 * t92 + t90 * t93 + t91 * t94;
        let t100 = r0x_x * (-0.2886751345948131) + d_x * 1.0000000000000004
            + r1x_x * 0.28867513459481264;
        let t101 = r0x_y * (-0.2886751345948131) + d_y * 1.0000000000000004
            + r1x_y * 0.28867513459481264;
        let t102 = r0x_z * (-0.2886751345948131) + d_z * 1.0000000000000004
            + r1x_z * 0.28867513459481264;
        let t103 = t80 + r0y_x * (-0.12200846792814612) + r1y_x * 0.4553418012614795;
        let t104 = t81 + r0y_y * (-0.12200846792814612) + r1y_y * 0.4553418012614795;
        let t105 = t82 + r0y_z * (-0.12200846792814612) + r1y_z * 0.4553418012614795;
        let t106 = t86 + r0z_x * (-0.12200846792814612) + r1z_x * 0.4553418012614795;
        let t107 = t87 + r0z_y * (-0.12200846792814612) + r1z_y * 0.4553418012614795;
        let t108 = t88 + r0z_z * (-0.12200846792814612) + r1z_z * 0.4553418012614795;
        let t109 = inverse_length
            * (r0y_x * 0.15470053837925146 + ry_half_x * (-2.309401076758503)
                + r1y_x * 2.1547005383792515);
        let t110 = inverse_length
            * (r0y_y * 0.15470053837925146 + ry_half_y * (-2.309401076758503)
                + r1y_y * 2.1547005383792515);
        let t111 = inverse_length
            * (r0y_z * 0.15470053837925146 + ry_half_z * (-2.309401076758503)
                + r1y_z * 2.1547005383792515);
        let t112 = inverse_length
            * (r0z_x * 0.15470053837925146 + rz_half_x * (-2.309401076758503)
                + r1z_x * 2.1547005383792515);
        let t113 = inverse_length
            * (r0z_y * 0.15470053837925146 + rz_half_y * (-2.309401076758503)
                + r1z_y * 2.1547005383792515);
        let t114 = inverse_length
            * (r0z_z * 0.15470053837925146 + rz_half_z * (-2.309401076758503)
                + r1z_z * 2.1547005383792515);
        let t115 = t103 * t112 + t104 * t113 + t105 * t114;
        let t116 = t106 * t109 + t107 * t110 + t108 * t111;
        reference[0] = 0.5 * (t50 * t50 + t51 * t51 + t52 * t52 - 1.0);
        reference[1] = 0.5 * (t56 * t56 + t57 * t57 + t58 * t58 - 1.0);
        reference[2] = 0.5 * (t62 * t62 + t63 * t63 + t64 * t64 - 1.0);
        reference[3] = t50 * t56 + t51 * t57 + t52 * t58;
        reference[4] = t50 * t62 + t51 * t63 + t52 * t64;
        reference[5] = t56 * t62 + t57 * t63 + t58 * t64;
        reference[6] = 0.5 * (t65 * t65 + t66 * t66 + t67 * t67 - 1.0);
        reference[7] = 0.5
            * (ry_half_x * ry_half_x + ry_half_y * ry_half_y + ry_half_z * ry_half_z
                - 1.0);
        reference[8] = 0.5
            * (rz_half_x * rz_half_x + rz_half_y * rz_half_y + rz_half_z * rz_half_z
                - 1.0);
        reference[9] = ry_half_x * t65 + ry_half_y * t66 + ry_half_z * t67;
        reference[10] = rz_half_x * t65 + rz_half_y * t66 + rz_half_z * t67;
        reference[11] = ry_half_x * rz_half_x + ry_half_y * rz_half_y
            + ry_half_z * rz_half_z;
        reference[12] = 0.5 * (t68 * t68 + t69 * t69 + t70 * t70 - 1.0);
        reference[13] = 0.5 * (t71 * t71 + t72 * t72 + t73 * t73 - 1.0);
        reference[14] = 0.5 * (t74 * t74 + t75 * t75 + t76 * t76 - 1.0);
        reference[15] = t68 * t71 + t69 * t72 + t70 * t73;
        reference[16] = t68 * t74 + t69 * t75 + t70 * t76;
        reference[17] = t71 * t74 + t72 * t75 + t73 * t76;
        reference[18] = t77 * t92 + t78 * t93 + t79 * t94;
        reference[19] = t77 * t95 + t78 * t96 + t79 * t97;
        reference[20] = 0.5 * (t99 - t98);
        reference[21] = t83 * t92 + t84 * t93 + t85 * t94;
        reference[22] = t89 * t95 + t90 * t96 + t91 * t97;
        reference[23] = t98 + t99;
        reference[24] = t100 * t109 + t101 * t110 + t102 * t111;
        reference[25] = t100 * t112 + t101 * t113 + t102 * t114;
        reference[26] = 0.5 * (t116 - t115);
        reference[27] = t103 * t109 + t104 * t110 + t105 * t111;
        reference[28] = t106 * t112 + t107 * t113 + t108 * t114;
        reference[29] = t115 + t116;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_curved_mass(row: &BeamSpatialCurved, mass: &mut [f64; 100]) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let mass_r0_r0 = element_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[0][0];
        let t20 = length * element_mass;
        let mass_r0_r0x = t20 * BEAM_SPATIAL_CURVED_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[0][6];
        let mass_r0_r1x = t20 * BEAM_SPATIAL_CURVED_MASS_MATRIX[0][7];
        let t24 = element_mass * (length * length);
        let mass_r0x_r0x = t24 * BEAM_SPATIAL_CURVED_MASS_MATRIX[1][1];
        let mass_r0x_r1 = t20 * BEAM_SPATIAL_CURVED_MASS_MATRIX[1][6];
        let mass_r0x_r1x = t24 * BEAM_SPATIAL_CURVED_MASS_MATRIX[1][7];
        let mass_r0y_r0y = section_y_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][2];
        let mass_r0y_ry_half = section_y_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][4];
        let mass_r0y_r1y = section_y_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][8];
        let mass_r0z_r0z = section_z_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][2];
        let mass_r0z_rz_half = section_z_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][4];
        let mass_r0z_r1z = section_z_mass * BEAM_SPATIAL_CURVED_MASS_MATRIX[2][8];
        let mass_ry_half_ry_half = section_y_mass
            * BEAM_SPATIAL_CURVED_MASS_MATRIX[4][4];
        let mass_rz_half_rz_half = section_z_mass
            * BEAM_SPATIAL_CURVED_MASS_MATRIX[4][4];
        let mass_r1_r1x = t20 * BEAM_SPATIAL_CURVED_MASS_MATRIX[6][7];
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
    pub fn beam_spatial_curved_shapes_position_0(
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
    pub fn beam_spatial_curved_shapes_position_1(
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
    pub fn beam_spatial_curved_shapes_section_y_0(
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
    pub fn beam_spatial_curved_shapes_section_y_1(
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
    pub fn beam_spatial_curved_shapes_section_z_0(
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
    pub fn beam_spatial_curved_shapes_section_z_1(
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
    pub fn beam_spatial_curved_field_forces(
        row: &BeamSpatialCurved,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatialCurved {
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
    /// Motion of frame `hub` and its first two derivatives.
    ///
    /// Operations: 8 additions, 13 multiplications, 6 divisions, 4 function calls.
    pub fn frame_hub(
        model: &CurvedOutOfPlane,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let t15 = model.omega_s / model.T_s;
        let t16 = (model.T_s / 6.283185307179586).powi(2);
        let t17 = t * 6.283185307179586 / model.T_s;
        let t18 = t17.cos();
        let theta = (if t <= model.T_s {
            t15 * (t * t / 2.0 + t16 * (t18 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t20 = theta.cos();
        let t21 = theta.sin();
        let t22 = 6.283185307179586 / model.T_s;
        let theta_t = (if t <= model.T_s {
            t15 * (t - t16 * (t22 * t17.sin()))
        } else {
            model.omega_s
        });
        let theta_t_t = (if t <= model.T_s {
            t15 * (1.0 - t16 * (t22 * (t18 * t22)))
        } else {
            0.0
        });
        motion.spin[2] = theta_t;
        motion.spin_rate[2] = theta_t_t;
        motion.rotation[(0, 0)] = t20;
        motion.rotation[(0, 1)] = -t21;
        motion.rotation[(1, 0)] = t21;
        motion.rotation[(1, 1)] = t20;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 15 additions, 19 multiplications.
    pub fn joint_root_referenced_position(
        model: &CurvedOutOfPlane,
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
    pub fn joint_root_referenced_jacobian(
        model: &CurvedOutOfPlane,
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
    pub fn joint_root_referenced_prescribed(
        model: &CurvedOutOfPlane,
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
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 25 additions, 37 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_position(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t33 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t33
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t35 = theta.cos();
        let t36 = theta.sin();
        let t37 = t35 * data.tangent[0] - t36 * data.tangent[1];
        let t38 = t36 * data.tangent[0] + t35 * data.tangent[1];
        let t39 = t35 * data.second[0] - t36 * data.second[1];
        let t40 = t36 * data.second[0] + t35 * data.second[1];
        let t41 = data.second[2] * t38 - data.tangent[2] * t40;
        let t42 = data.tangent[2] * t39 - data.second[2] * t37;
        let t43 = t37 * t40 - t38 * t39;
        let t44 = q[3] * t39 + q[4] * t40 + data.second[2] * q[5]
            - (q[6] * t37 + q[7] * t38 + data.tangent[2] * q[8]);
        rows[0] = q[0] - (t35 * data.point[0] - t36 * data.point[1]);
        rows[1] = q[1] - (t36 * data.point[0] + t35 * data.point[1]);
        rows[2] = q[2] - data.point[2];
        rows[3] = q[3] * t41 + q[4] * t42 + q[5] * t43;
        rows[4] = q[6] * t41 + q[7] * t42 + q[8] * t43;
        rows[5] = 0.5 * t44;
    }
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 28 additions, 50 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_velocity(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t29 = model.omega_s / model.T_s;
        let t30 = (model.T_s / 6.283185307179586).powi(2);
        let t31 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t29 * (t * t / 2.0 + t30 * (t31.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t33 = theta.cos();
        let t34 = theta.sin();
        let t35 = (if t <= model.T_s {
            t29 * (t - t30 * (6.283185307179586 / model.T_s * t31.sin()))
        } else {
            model.omega_s
        });
        let t36 = t34 * t35;
        let t37 = t33 * t35;
        let t38 = data.tangent[0] * t36 + data.tangent[1] * t37;
        let t39 = data.tangent[0] * t37 - data.tangent[1] * t36;
        let t40 = data.second[0] * t36 + data.second[1] * t37;
        let t41 = data.second[0] * t37 - data.second[1] * t36;
        let t42 = data.second[2] * t39 - data.tangent[2] * t41;
        let t43 = data.second[2] * t38 - data.tangent[2] * t40;
        let t44 = (t33 * data.tangent[0] - t34 * data.tangent[1]) * t41
            - (t34 * data.second[0] + t33 * data.second[1]) * t38;
        let t45 = (t33 * data.second[0] - t34 * data.second[1]) * t39
            - (t34 * data.tangent[0] + t33 * data.tangent[1]) * t40;
        let t46 = t44 - t45;
        rows[0] = data.point[0] * t36 + data.point[1] * t37;
        rows[1] = data.point[1] * t36 - data.point[0] * t37;
        rows[3] = q[5] * t46 + (q[3] * t42 + q[4] * t43);
        rows[4] = q[8] * t46 + (q[6] * t42 + q[7] * t43);
        rows[5] = 0.5 * (q[4] * t41 - q[3] * t40 - (q[7] * t39 - q[6] * t38));
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 65 additions, 86 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_acceleration(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t35 = model.omega_s / model.T_s;
        let t36 = (model.T_s / 6.283185307179586).powi(2);
        let t37 = t * 6.283185307179586 / model.T_s;
        let t38 = t37.cos();
        let theta = (if t <= model.T_s {
            t35 * (t * t / 2.0 + t36 * (t38 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t40 = theta.cos();
        let t41 = theta.sin();
        let t42 = t40 * data.tangent[0] - t41 * data.tangent[1];
        let t43 = t41 * data.tangent[0] + t40 * data.tangent[1];
        let t44 = t40 * data.second[0] - t41 * data.second[1];
        let t45 = t41 * data.second[0] + t40 * data.second[1];
        let t46 = 6.283185307179586 / model.T_s;
        let t47 = (if t <= model.T_s {
            t35 * (t - t36 * (t46 * t37.sin()))
        } else {
            model.omega_s
        });
        let t48 = t41 * t47;
        let t49 = t40 * t47;
        let t50 = data.tangent[0] * t48 + data.tangent[1] * t49;
        let t51 = data.tangent[0] * t49 - data.tangent[1] * t48;
        let t52 = data.second[0] * t48 + data.second[1] * t49;
        let t53 = data.second[0] * t49 - data.second[1] * t48;
        let t54 = data.second[2] * t51 - data.tangent[2] * t53;
        let t55 = data.second[2] * t50 - data.tangent[2] * t52;
        let t56 = t42 * t53 - t45 * t50 - (t44 * t51 - t43 * t52);
        let t57 = (if t <= model.T_s {
            t35 * (1.0 - t36 * (t46 * (t38 * t46)))
        } else {
            0.0
        });
        let t58 = t47 * t49 + t41 * t57;
        let t59 = t40 * t57 - t47 * t48;
        let t60 = data.tangent[0] * t58 + data.tangent[1] * t59;
        let t61 = data.tangent[0] * t59 - data.tangent[1] * t58;
        let t62 = data.second[0] * t58 + data.second[1] * t59;
        let t63 = data.second[0] * t59 - data.second[1] * t58;
        let t64 = data.second[2] * t61 - data.tangent[2] * t63;
        let t65 = data.second[2] * t60 - data.tangent[2] * t62;
        let t66 = t50 * t53;
        let t67 = t51 * t52;
        let t68 = t42 * t63 - t66 - (t66 + t45 * t60)
            - (t44 * t61 - t67 - (t67 + t43 * t62));
        let t69 = v[3] * t54;
        let t70 = v[4] * t55;
        let t71 = v[5] * t56;
        let t72 = v[6] * t54;
        let t73 = v[7] * t55;
        let t74 = v[8] * t56;
        let t75 = v[3] * t52;
        let t76 = v[4] * t53;
        let t77 = v[6] * t50;
        let t78 = v[7] * t51;
        let t79 = t69 + (t69 + q[3] * t64) + (t70 + (t70 + q[4] * t65))
            + (t71 + (t71 + q[5] * t68));
        let t80 = t72 + (t72 + q[6] * t64) + (t73 + (t73 + q[7] * t65))
            + (t74 + (t74 + q[8] * t68));
        let t81 = t76 + (t76 + q[4] * t63) - (t75 + (t75 + q[3] * t62))
            - (t78 + (t78 + q[7] * t61) - (t77 + (t77 + q[6] * t60)));
        rows[0] = data.point[0] * t58 + data.point[1] * t59;
        rows[1] = data.point[1] * t58 - data.point[0] * t59;
        rows[3] = t79;
        rows[4] = t80;
        rows[5] = 0.5 * t81;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 121 additions, 126 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_jerk(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t41 = model.omega_s / model.T_s;
        let t42 = (model.T_s / 6.283185307179586).powi(2);
        let t43 = t * 6.283185307179586 / model.T_s;
        let t44 = t43.cos();
        let theta = (if t <= model.T_s {
            t41 * (t * t / 2.0 + t42 * (t44 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t46 = theta.cos();
        let t47 = theta.sin();
        let t48 = t46 * data.tangent[0] - t47 * data.tangent[1];
        let t49 = t47 * data.tangent[0] + t46 * data.tangent[1];
        let t50 = t46 * data.second[0] - t47 * data.second[1];
        let t51 = t47 * data.second[0] + t46 * data.second[1];
        let t52 = 6.283185307179586 / model.T_s;
        let t53 = t52 * t43.sin();
        let t54 = (if t <= model.T_s { t41 * (t - t42 * t53) } else { model.omega_s });
        let t55 = t47 * t54;
        let t56 = t46 * t54;
        let t57 = data.tangent[0] * t55 + data.tangent[1] * t56;
        let t58 = data.tangent[0] * t56 - data.tangent[1] * t55;
        let t59 = data.second[0] * t55 + data.second[1] * t56;
        let t60 = data.second[0] * t56 - data.second[1] * t55;
        let t61 = data.second[2] * t58 - data.tangent[2] * t60;
        let t62 = data.second[2] * t57 - data.tangent[2] * t59;
        let t63 = t48 * t60 - t51 * t57 - (t50 * t58 - t49 * t59);
        let t64 = (if t <= model.T_s {
            t41 * (1.0 - t42 * (t52 * (t44 * t52)))
        } else {
            0.0
        });
        let t65 = t54 * t56 + t47 * t64;
        let t66 = t46 * t64 - t54 * t55;
        let t67 = data.tangent[0] * t65 + data.tangent[1] * t66;
        let t68 = data.tangent[0] * t66 - data.tangent[1] * t65;
        let t69 = data.second[0] * t65 + data.second[1] * t66;
        let t70 = data.second[0] * t66 - data.second[1] * t65;
        let t71 = data.second[2] * t68 - data.tangent[2] * t70;
        let t72 = data.second[2] * t67 - data.tangent[2] * t69;
        let t73 = t57 * t60;
        let t74 = t58 * t59;
        let t75 = t48 * t70 - t73 - (t73 + t51 * t67)
            - (t50 * t68 - t74 - (t74 + t49 * t69));
        let t76 = (if t <= model.T_s { t41 * (t42 * (t52 * (t52 * t53))) } else { 0.0 });
        let t77 = t56 * t64;
        let t78 = t77 + t54 * t66 + (t77 + t47 * t76);
        let t79 = t55 * t64;
        let t80 = t46 * t76 - t79 - (t79 + t54 * t65);
        let t81 = data.tangent[0] * t78 + data.tangent[1] * t80;
        let t82 = data.tangent[0] * t80 - data.tangent[1] * t78;
        let t83 = data.second[0] * t78 + data.second[1] * t80;
        let t84 = data.second[0] * t80 - data.second[1] * t78;
        let t85 = data.second[2] * t82 - data.tangent[2] * t84;
        let t86 = data.second[2] * t81 - data.tangent[2] * t83;
        let t87 = t60 * t67;
        let t88 = t57 * t70;
        let t89 = t87 + t88;
        let t90 = t59 * t68;
        let t91 = t58 * t69;
        let t92 = t90 + t91;
        let t93 = t48 * t84 - t88 - t89 - (t89 + (t87 + t51 * t81))
            - (t50 * t82 - t90 - t92 - (t92 + (t91 + t49 * t83)));
        let t94 = a[3] * t61;
        let t95 = v[3] * t71;
        let t96 = t94 + t95;
        let t97 = a[4] * t62;
        let t98 = v[4] * t72;
        let t99 = t97 + t98;
        let t100 = t94 + t96 + (t96 + (t95 + q[3] * t85))
            + (t97 + t99 + (t99 + (t98 + q[4] * t86)));
        let t101 = a[5] * t63;
        let t102 = v[5] * t75;
        let t103 = t101 + t102;
        let t104 = a[6] * t61;
        let t105 = v[6] * t71;
        let t106 = t104 + t105;
        let t107 = a[7] * t62;
        let t108 = v[7] * t72;
        let t109 = t107 + t108;
        let t110 = t104 + t106 + (t106 + (t105 + q[6] * t85))
            + (t107 + t109 + (t109 + (t108 + q[7] * t86)));
        let t111 = a[8] * t63;
        let t112 = v[8] * t75;
        let t113 = t111 + t112;
        let t114 = a[3] * t59;
        let t115 = v[3] * t69;
        let t116 = t114 + t115;
        let t117 = a[4] * t60;
        let t118 = v[4] * t70;
        let t119 = t117 + t118;
        let t120 = t117 + t119 + (t119 + (t118 + q[4] * t84))
            - (t114 + t116 + (t116 + (t115 + q[3] * t83)));
        let t121 = a[6] * t57;
        let t122 = v[6] * t67;
        let t123 = t121 + t122;
        let t124 = a[7] * t58;
        let t125 = v[7] * t68;
        let t126 = t124 + t125;
        let t127 = t124 + t126 + (t126 + (t125 + q[7] * t82))
            - (t121 + t123 + (t123 + (t122 + q[6] * t81)));
        rows[0] = data.point[0] * t78 + data.point[1] * t80;
        rows[1] = data.point[1] * t78 - data.point[0] * t80;
        rows[3] = t100 + (t101 + t103 + (t103 + (t102 + q[5] * t93)));
        rows[4] = t110 + (t111 + t113 + (t113 + (t112 + q[8] * t93)));
        rows[5] = 0.5 * (t120 - t127);
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 12 additions, 26 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_jacobian(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let t21 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t21
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = t23 * data.tangent[0];
        let t26 = t24 * data.tangent[1];
        let t27 = t25 - t26;
        let t28 = t24 * data.tangent[0] + t23 * data.tangent[1];
        let t29 = t23 * data.second[0] - t24 * data.second[1];
        let t30 = t24 * data.second[0] + t23 * data.second[1];
        let t31 = data.second[2] * t28 - data.tangent[2] * t30;
        let t32 = data.tangent[2] * t29 - data.second[2] * t27;
        let t33 = t27 * t30 - t28 * t29;
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = t31;
        jacobian[31] = t32;
        jacobian[32] = t33;
        jacobian[42] = t31;
        jacobian[43] = t32;
        jacobian[44] = t33;
        jacobian[48] = t29 * 0.5;
        jacobian[49] = t30 * 0.5;
        jacobian[50] = data.second[2] * 0.5;
        jacobian[51] = 0.5 * (t26 - t25);
        jacobian[52] = -t28 * 0.5;
        jacobian[53] = -data.tangent[2] * 0.5;
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 28 additions, 55 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_prescribed(
        model: &CurvedOutOfPlane,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let t24 = model.omega_s / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.omega_s
        });
        let t33 = t30 * t32;
        let t34 = t29 * t32;
        let t35 = (if t <= model.T_s {
            t24 * (1.0 - t25 * (t31 * (t27 * t31)))
        } else {
            0.0
        });
        let t36 = t32 * t34 + t30 * t35;
        let t37 = t29 * t35 - t32 * t33;
        prescribed.position[0][0] = t29 * data.point[0] - t30 * data.point[1];
        prescribed.position[0][1] = t30 * data.point[0] + t29 * data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = -(data.point[0] * t33 + data.point[1] * t34);
        prescribed.position[1][1] = data.point[0] * t34 - data.point[1] * t33;
        prescribed.position[2][0] = -(data.point[0] * t36 + data.point[1] * t37);
        prescribed.position[2][1] = data.point[0] * t37 - data.point[1] * t36;
        prescribed.slope[0][0] = t29 * data.tangent[0] - t30 * data.tangent[1];
        prescribed.slope[0][1] = t30 * data.tangent[0] + t29 * data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = -(data.tangent[0] * t33 + data.tangent[1] * t34);
        prescribed.slope[1][1] = data.tangent[0] * t34 - data.tangent[1] * t33;
        prescribed.slope[2][0] = -(data.tangent[0] * t36 + data.tangent[1] * t37);
        prescribed.slope[2][1] = data.tangent[0] * t37 - data.tangent[1] * t36;
        prescribed.second[0][0] = t29 * data.second[0] - t30 * data.second[1];
        prescribed.second[0][1] = t30 * data.second[0] + t29 * data.second[1];
        prescribed.second[0][2] = data.second[2];
        prescribed.second[1][0] = -(data.second[0] * t33 + data.second[1] * t34);
        prescribed.second[1][1] = data.second[0] * t34 - data.second[1] * t33;
        prescribed.second[2][0] = -(data.second[0] * t36 + data.second[1] * t37);
        prescribed.second[2][1] = data.second[0] * t37 - data.second[1] * t36;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &CurvedOutOfPlane, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn outputs(model: &CurvedOutOfPlane, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0] - 7.670808617667248;
        out[1] = observed[1];
        out[2] = observed[2] - 1.9586790097540359;
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &CurvedOutOfPlane, run: &mut ::rncf::RunDefaults) {
        run.t_end = 20.0;
        run.every = 0.05;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: CurvedOutOfPlane,
        pub row_beam: BeamSpatialCurved,
        pub reference_beam: ::std::vec::Vec<[f64; 30]>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &CurvedOutOfPlane) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
                reference_beam: ::std::vec::Vec::new(),
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
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "hub"][frame]
        }
        fn conservative(&self) -> bool {
            false
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 1];
            kinks(&self.model, &mut times);
            times.to_vec()
        }
        fn gaps(&self, t: f64, out: &mut ::std::vec::Vec<[f64; 2]>) {}
        fn courses(&self) -> ::std::vec::Vec<::rncf::emitted::Courses> {
            ::std::vec::Vec::new()
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::emitted::FrameMotion]) {
            motions[0] = ::rncf::emitted::FrameMotion::INERTIAL;
            frame_hub(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("frame `hub` moves in a prescribed way")
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
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Arc {
                        from: [0.0, 0.0, 0.0],
                        direction: [1.0, 0.0, 0.0],
                        normal: [0.0, -1.0, 0.0],
                        radius: 16.0,
                        angle: 0.5,
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
                2766.67,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `aluminium`",
                "young",
                68950000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::emitted::poisson(
                "material `aluminium`",
                "poisson",
                0.3,
                "1",
            )?;
            let area = ::rncf::emitted::positive(
                "section `tube`",
                "area",
                7.299e-5,
                "m^2",
            )?;
            let second_moment_y = ::rncf::emitted::positive(
                "section `tube`",
                "second_moment_y",
                8.215e-9,
                "m^4",
            )?;
            let second_moment_z = ::rncf::emitted::positive(
                "section `tube`",
                "second_moment_z",
                8.215e-9,
                "m^4",
            )?;
            let torsion_constant = ::rncf::emitted::positive(
                "section `tube`",
                "torsion_constant",
                1.643e-8,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::emitted::part(
                "section `tube`",
                "shear_factor_y",
                0.53,
                "1",
            )?;
            let shear_factor_z = ::rncf::emitted::part(
                "section `tube`",
                "shear_factor_z",
                0.53,
                "1",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            let half_young = 0.5 * young;
            let quarter_polar_moment = 0.25 * (second_moment_y + second_moment_z);
            self.row_beam = BeamSpatialCurved {
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
            self.reference_beam = shape
                .chunks_exact(30)
                .map(|shape| {
                    let mut reference = [0.0; 30];
                    beam_spatial_curved_reference(
                        &self.row_beam,
                        ::rncf::emitted::array(shape),
                        &mut reference,
                    );
                    reference
                })
                .collect();
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
            beam_spatial_curved_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_spatial_curved_elastic_force(
                &self.row_beam,
                &self.reference_beam[element],
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
            beam_spatial_curved_elastic_tangent(
                &self.row_beam,
                &self.reference_beam[element],
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
            beam_spatial_curved_strain_energy(
                &self.row_beam,
                &self.reference_beam[element],
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
                    beam_spatial_curved_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    beam_spatial_curved_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    beam_spatial_curved_shapes_section_y_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    beam_spatial_curved_shapes_section_y_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 0) => {
                    beam_spatial_curved_shapes_section_z_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 1) => {
                    beam_spatial_curved_shapes_section_z_1(
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
                shape: ::rncf::emitted::SectionShape::General {
                    extent: [None, None],
                    shear_factors: [0.53, 0.53],
                },
                area: 7.299e-5,
                second_moments: [8.215e-9, 8.215e-9],
                torsion_constant: 1.643e-8,
                young_over_shear: 2.0 * (1.0 + 0.3),
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
            beam_spatial_curved_field_forces(
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
                    kind: ::rncf::emitted::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 1,
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
                (0, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_root_referenced_position(
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
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            joint_root_absolute_velocity(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            joint_root_absolute_acceleration(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            joint_root_absolute_jerk(&self.model, t, data, q, v, a, rows)
                        }
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
                (0, false) => {
                    joint_root_referenced_jacobian(&self.model, t, data, jacobian);
                }
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
                (0, false) => {
                    joint_root_referenced_prescribed(&self.model, t, data, prescribed);
                }
                (0, _) => {
                    joint_root_absolute_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutLoads for Equations {}
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::WithoutMarkerConstraints for Equations {}
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
