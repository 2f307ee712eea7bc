//! Expansion of `models/src/curved_upwind.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use curved_upwind_equations::CurvedUpwind;
#[allow(clippy::all)]
impl Default for CurvedUpwind {
    fn default() -> Self {
        Self {
            omega_s: 4.0,
            T_s: 15.0,
            elements: 8,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for CurvedUpwind {
    const NAME: &'static str = "CurvedUpwind";
    const DOC: &'static str = "Spin-up of a beam that is curved towards its motion (Ren & Yang 2021, section 4.1.2).";
    const SOURCE: &'static str = r#"pub model CurvedUpwind {
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
        shear_factor = 0.53;
    }

    /// Angle of the hub, Eq. (22).
    motion theta(t) =
        if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { omega_s * (t - T_s/2) };
    frame hub = rotating(axis = z, angle = theta(t));

    body beam in hub {
        planar xy;
        arc from [0, 0, 0] m direction [1, 0, 0] radius bend angle turn;
        mesh elements * beam(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);

    /// Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.
    output u = beam.end.x - bend * sin(turn);
    /// The same along y, in the plane of rotation.
    output v = beam.end.y - bend * (1 - cos(turn));
    /// The same along z, the axis of rotation.
    output w = 0 m;

    run { t_end = 20 s; every = 0.05 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xaaf3b61711c56836;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `beam_planar_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 459 and 1967).",
        "Body `beam` is planar: two components a vector, no motion along the normal.",
        "Body `beam` has nodal vectors for the section's y axis (r0y, ry_half, r1y): sections shear and have rotary inertia; there is no torsion in a plane.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix.",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "BEAM_PLANAR_CURVED_MASS_MATRIX",
            size: [7, 7],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points3_force",
            additions: 12,
            multiplications: 27,
            divisions: 0,
            functions: 0,
            weighted: 39,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points3_tangent",
            additions: 20,
            multiplications: 47,
            divisions: 0,
            functions: 0,
            weighted: 67,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points3_energy",
            additions: 10,
            multiplications: 18,
            divisions: 0,
            functions: 0,
            weighted: 28,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points2_force",
            additions: 6,
            multiplications: 20,
            divisions: 1,
            functions: 0,
            weighted: 30,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points2_tangent",
            additions: 11,
            multiplications: 43,
            divisions: 1,
            functions: 0,
            weighted: 58,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_points2_energy",
            additions: 5,
            multiplications: 14,
            divisions: 1,
            functions: 0,
            weighted: 23,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_reference",
            additions: 65,
            multiplications: 96,
            divisions: 1,
            functions: 0,
            weighted: 165,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_mass",
            additions: 0,
            multiplications: 17,
            divisions: 0,
            functions: 0,
            weighted: 17,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_planar_curved_field_forces",
            additions: 29,
            multiplications: 53,
            divisions: 0,
            functions: 0,
            weighted: 82,
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
            additions: 3,
            multiplications: 2,
            divisions: 0,
            functions: 0,
            weighted: 5,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_position",
            additions: 11,
            multiplications: 16,
            divisions: 5,
            functions: 3,
            weighted: 107,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_velocity",
            additions: 11,
            multiplications: 21,
            divisions: 6,
            functions: 4,
            weighted: 136,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_acceleration",
            additions: 21,
            multiplications: 35,
            divisions: 6,
            functions: 4,
            weighted: 160,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jerk",
            additions: 36,
            multiplications: 51,
            divisions: 6,
            functions: 4,
            weighted: 191,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jacobian",
            additions: 6,
            multiplications: 10,
            divisions: 5,
            functions: 3,
            weighted: 96,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_prescribed",
            additions: 22,
            multiplications: 43,
            divisions: 6,
            functions: 4,
            weighted: 169,
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
            _ => panic!("CurvedUpwind has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            _ => panic!("CurvedUpwind has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        curved_upwind_equations::run_defaults(self, &mut run);
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
        let equations = curved_upwind_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`CurvedUpwind`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod curved_upwind_equations {
    /// Spin-up of a beam that is curved towards its motion (Ren & Yang 2021, section 4.1.2).
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `beam_planar_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 459 and 1967).
    /// * Body `beam` is planar: two components a vector, no motion along the normal.
    /// * Body `beam` has nodal vectors for the section's y axis (r0y, ry_half, r1y): sections shear and have rotary inertia; there is no torsion in a plane.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix.
    /// * Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct CurvedUpwind {
        /// Steady angular velocity. (SI; declared in rad/s)
        pub omega_s: f64,
        /// Time to reach it. (SI; declared in s)
        pub T_s: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `beam_planar_curved`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, ry_half, r1, r1x, r1y, 2 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 459 and 1967).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamPlanarCurved {
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
    pub const BEAM_PLANAR_CURVED_MASS_MATRIX: [[f64; 7]; 7] = [
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
    static BEAM_PLANAR_CURVED_VECTORS: ::rncf::emitted::Vectors<7, 2, 2, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 4, 5], [2, 3, 6]],
        positions: [[false, true, false], [false, false, false]],
    };
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static BEAM_PLANAR_CURVED_POINTS3: ::rncf::emitted::Rule<3, 2, 3> = ::rncf::emitted::Rule {
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
    static BEAM_PLANAR_CURVED_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 3> = BEAM_PLANAR_CURVED_POINTS3
        .blocks(&[(0, 0), (0, 1), (1, 1)], &[(0, 0, 1), (1, 1, 2), (2, 2, 3)]);
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static BEAM_PLANAR_CURVED_POINTS2: ::rncf::emitted::Rule<2, 3, 3> = ::rncf::emitted::Rule {
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
    static BEAM_PLANAR_CURVED_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<2, 9, 6> = BEAM_PLANAR_CURVED_POINTS2
        .blocks(
            &[(0, 0), (0, 2), (1, 1), (1, 2), (2, 1), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 6)],
        );
    /// Writes the forces on the fields a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 12 additions, 27 multiplications.
    pub fn beam_planar_curved_points3_force(
        row: &BeamPlanarCurved,
        reference: &[f64; 3],
        fields: &[[f64; 2]; 2],
        forces: &mut [[f64; 2]; 2],
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t22 = length * EA;
        let t23 = 0.5 * (t22 * (0.5 * (a_x * a_x + a_y * a_y - 1.0) - reference[0]));
        let t24 = length * kyGA * (a_x * b_x + a_y * b_y - reference[2]);
        let t25 = 0.5 * (t22 * (0.5 * (b_x * b_x + b_y * b_y - 1.0) - reference[1]));
        forces[0][0] = t23 * (a_x * 2.0) + b_x * t24;
        forces[0][1] = t23 * (a_y * 2.0) + b_y * t24;
        forces[1][0] = a_x * t24 + t25 * (b_x * 2.0);
        forces[1][1] = a_y * t24 + t25 * (b_y * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 20 additions, 47 multiplications.
    pub fn beam_planar_curved_points3_tangent(
        row: &BeamPlanarCurved,
        reference: &[f64; 3],
        fields: &[[f64; 2]; 2],
        stiffness: &mut [[f64; 4]; 3],
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t22 = length * EA;
        let t23 = length * kyGA;
        let t24 = 0.5 * (0.5 * t22);
        let t25 = t23 * (a_x * b_x + a_y * b_y - reference[2]);
        let t26 = a_x * 2.0;
        let t27 = a_y * 2.0;
        let t28 = b_x * 2.0;
        let t29 = b_y * 2.0;
        let t30 = t24 * t27;
        let t31 = b_y * t23;
        let t32 = a_x * t23;
        let t33 = a_y * t23;
        let t34 = t24 * t29;
        let t35 = t26 * t30 + b_x * t31;
        let t36 = a_x * t33 + t28 * t34;
        let t37 = 0.5 * (t22 * (0.5 * (a_x * a_x + a_y * a_y - 1.0) - reference[0]))
            * 2.0;
        let t38 = 0.5 * (t22 * (0.5 * (b_x * b_x + b_y * b_y - 1.0) - reference[1]))
            * 2.0;
        stiffness[0][0] = t26 * (t24 * t26) + b_x * (b_x * t23) + t37;
        stiffness[0][1] = t35;
        stiffness[0][2] = t35;
        stiffness[0][3] = t27 * t30 + b_y * t31 + t37;
        stiffness[1][0] = t25 + b_x * t32;
        stiffness[1][1] = b_x * t33;
        stiffness[1][2] = b_y * t32;
        stiffness[1][3] = t25 + b_y * t33;
        stiffness[2][0] = a_x * t32 + t28 * (t24 * t28) + t38;
        stiffness[2][1] = t36;
        stiffness[2][2] = t36;
        stiffness[2][3] = a_y * t33 + t29 * t34 + t38;
    }
    /// Writes the strain energy a, b at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 10 additions, 18 multiplications.
    pub fn beam_planar_curved_points3_energy(
        row: &BeamPlanarCurved,
        reference: &[f64; 3],
        fields: &[[f64; 2]; 2],
        energy: &mut f64,
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y]] = *fields;
        let t22 = 0.5 * (length * EA);
        let t23 = t22 * (0.5 * (a_x * a_x + a_y * a_y - 1.0) - reference[0]).powi(2)
            + t22 * (0.5 * (b_x * b_x + b_y * b_y - 1.0) - reference[1]).powi(2);
        let t24 = t23
            + 0.5 * (length * kyGA) * (a_x * b_x + a_y * b_y - reference[2]).powi(2);
        *energy = t24;
    }
    /// Writes the forces on the fields a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 6 additions, 20 multiplications, 1 divisions.
    pub fn beam_planar_curved_points2_force(
        row: &BeamPlanarCurved,
        reference: &[f64; 2],
        fields: &[[f64; 2]; 3],
        forces: &mut [[f64; 2]; 3],
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t26 = inverse_length
            * (length * EIz * (a_x * db_x + a_y * db_y - reference[0]));
        let t27 = inverse_length
            * (length * GIz * (b_x * db_x + b_y * db_y - reference[1]));
        forces[0][0] = unit_db_x * t26;
        forces[0][1] = unit_db_y * t26;
        forces[1][0] = unit_db_x * t27;
        forces[1][1] = unit_db_y * t27;
        forces[2][0] = a_x * t26 + b_x * t27;
        forces[2][1] = a_y * t26 + b_y * t27;
    }
    /// Writes the blocks of the tangent on the fields a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 11 additions, 43 multiplications, 1 divisions.
    pub fn beam_planar_curved_points2_tangent(
        row: &BeamPlanarCurved,
        reference: &[f64; 2],
        fields: &[[f64; 2]; 3],
        stiffness: &mut [[f64; 4]; 6],
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t26 = length * EIz;
        let t27 = length * GIz;
        let t28 = inverse_length * (t26 * (a_x * db_x + a_y * db_y - reference[0]));
        let t29 = inverse_length * inverse_length;
        let t30 = t26 * t29;
        let t31 = inverse_length * (t27 * (b_x * db_x + b_y * db_y - reference[1]));
        let t32 = t27 * t29;
        let t33 = unit_db_y * t30;
        let t34 = a_x * t30;
        let t35 = a_y * t30;
        let t36 = unit_db_y * t32;
        let t37 = b_x * t32;
        let t38 = b_y * t32;
        let t39 = unit_db_x * t33;
        let t40 = unit_db_x * t36;
        let t41 = unit_db_x * t38;
        let t42 = unit_db_y * t37;
        let t43 = a_x * t35 + b_x * t38;
        let t44 = t31 + unit_db_x * t37;
        let t45 = t31 + unit_db_y * t38;
        stiffness[0][0] = unit_db_x * (unit_db_x * t30);
        stiffness[0][1] = t39;
        stiffness[0][2] = t39;
        stiffness[0][3] = unit_db_y * t33;
        stiffness[1][0] = t28 + unit_db_x * t34;
        stiffness[1][1] = unit_db_x * t35;
        stiffness[1][2] = unit_db_y * t34;
        stiffness[1][3] = t28 + unit_db_y * t35;
        stiffness[2][0] = unit_db_x * (unit_db_x * t32);
        stiffness[2][1] = t40;
        stiffness[2][2] = t40;
        stiffness[2][3] = unit_db_y * t36;
        stiffness[3][0] = t44;
        stiffness[3][1] = t41;
        stiffness[3][2] = t42;
        stiffness[3][3] = t45;
        stiffness[4][0] = t44;
        stiffness[4][1] = t42;
        stiffness[4][2] = t41;
        stiffness[4][3] = t45;
        stiffness[5][0] = a_x * t34 + b_x * t37;
        stiffness[5][1] = t43;
        stiffness[5][2] = t43;
        stiffness[5][3] = a_y * t35 + b_y * t38;
    }
    /// Writes the strain energy a, b, db at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 5 additions, 14 multiplications, 1 divisions.
    pub fn beam_planar_curved_points2_energy(
        row: &BeamPlanarCurved,
        reference: &[f64; 2],
        fields: &[[f64; 2]; 3],
        energy: &mut f64,
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
        let [[a_x, a_y], [b_x, b_y], [unit_db_x, unit_db_y]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let t26 = 0.5 * (length * EIz) * (a_x * db_x + a_y * db_y - reference[0]).powi(2)
            + 0.5 * (length * GIz) * (b_x * db_x + b_y * db_y - reference[1]).powi(2);
        *energy = t26;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 192 additions, 265 multiplications, 2 divisions.
    pub fn beam_planar_curved_elastic_force(
        row: &BeamPlanarCurved,
        reference: &[f64; 13],
        q: &[f64; 14],
        force: &mut [f64; 14],
    ) {
        let vectors = BEAM_PLANAR_CURVED_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_PLANAR_CURVED_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_planar_curved_points3_force(
                    row,
                    ::rncf::emitted::array(&reference[0 + 3 * point..][..3]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_PLANAR_CURVED_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_planar_curved_points2_force(
                    row,
                    ::rncf::emitted::array(&reference[9 + 2 * point..][..2]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_PLANAR_CURVED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 910 additions, 1055 multiplications, 2 divisions.
    pub fn beam_planar_curved_elastic_tangent(
        row: &BeamPlanarCurved,
        reference: &[f64; 13],
        q: &[f64; 14],
        stiffness: &mut [f64; 196],
    ) {
        let vectors = BEAM_PLANAR_CURVED_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 4]; 3];
        BEAM_PLANAR_CURVED_POINTS3
            .tangent(
                &vectors,
                (&BEAM_PLANAR_CURVED_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_planar_curved_points3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[0 + 3 * point..][..3]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_PLANAR_CURVED_POINTS2
            .tangent(
                &vectors,
                (&BEAM_PLANAR_CURVED_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_planar_curved_points2_tangent(
                    row,
                    ::rncf::emitted::array(&reference[9 + 2 * point..][..2]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_PLANAR_CURVED_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 117 additions, 159 multiplications, 2 divisions.
    pub fn beam_planar_curved_strain_energy(
        row: &BeamPlanarCurved,
        reference: &[f64; 13],
        q: &[f64; 14],
        energy: &mut f64,
    ) {
        let vectors = BEAM_PLANAR_CURVED_VECTORS.relative(row.length, q);
        *energy
            += BEAM_PLANAR_CURVED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_planar_curved_points3_energy(
                            row,
                            ::rncf::emitted::array(&reference[0 + 3 * point..][..3]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += BEAM_PLANAR_CURVED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_planar_curved_points2_energy(
                            row,
                            ::rncf::emitted::array(&reference[9 + 2 * point..][..2]),
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
    /// Operations: 65 additions, 96 multiplications, 1 divisions.
    pub fn beam_planar_curved_reference(
        row: &BeamPlanarCurved,
        q: &[f64; 14],
        reference: &mut [f64; 13],
    ) {
        let BeamPlanarCurved { length, rhoA, rhoIz, .. } = *row;
        let [r0_x, r0_y, r0x_x, r0x_y, r0y_x, r0y_y, ry_half_x, ry_half_y, r1_x, r1_y,
        r1x_x, r1x_y, r1y_x, r1y_y] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let t30 = d_x * 0.6;
        let t31 = d_y * 0.6;
        let t32 = r0x_x * 0.5872983346207417 + t30 + r1x_x * (-0.18729833462074166);
        let t33 = r0x_y * 0.5872983346207417 + t31 + r1x_y * (-0.18729833462074166);
        let t34 = ry_half_x * 0.39999999999999997;
        let t35 = ry_half_y * 0.39999999999999997;
        let t36 = r0y_x * 0.6872983346207417 + t34 + r1y_x * (-0.08729833462074169);
        let t37 = r0y_y * 0.6872983346207417 + t35 + r1y_y * (-0.08729833462074169);
        let t38 = r0x_x * (-0.25) + d_x * 1.5 + r1x_x * (-0.25);
        let t39 = r0x_y * (-0.25) + d_y * 1.5 + r1x_y * (-0.25);
        let t40 = t30 + r0x_x * (-0.18729833462074175) + r1x_x * 0.5872983346207418;
        let t41 = t31 + r0x_y * (-0.18729833462074175) + r1x_y * 0.5872983346207418;
        let t42 = t34 + r0y_x * (-0.08729833462074166) + r1y_x * 0.6872983346207417;
        let t43 = t35 + r0y_y * (-0.08729833462074166) + r1y_y * 0.6872983346207417;
        let t44 = ry_half_x * 0.6666666666666667;
        let t45 = ry_half_y * 0.6666666666666667;
        let t46 = inverse_length
            * (r0y_x * (-2.1547005383792515) + ry_half_x * 2.309401076758503
                + r1y_x * (-0.15470053837925146));
        let t47 = inverse_length
            * (r0y_y * (-2.1547005383792515) + ry_half_y * 2.309401076758503
                + r1y_y * (-0.15470053837925146));
        let t48 = (d_x + r0x_x * 0.28867513459481287 + r1x_x * (-0.2886751345948129))
            * t46
            + (d_y + r0x_y * 0.28867513459481287 + r1x_y * (-0.2886751345948129)) * t47;
        let t49 = (r0y_x * 0.4553418012614795 + t44 + r1y_x * (-0.12200846792814622))
            * t46
            + (r0y_y * 0.4553418012614795 + t45 + r1y_y * (-0.12200846792814622)) * t47;
        let t50 = inverse_length
            * (r0y_x * 0.15470053837925146 + ry_half_x * (-2.309401076758503)
                + r1y_x * 2.1547005383792515);
        let t51 = inverse_length
            * (r0y_y * 0.15470053837925146 + ry_half_y * (-2.309401076758503)
                + r1y_y * 2.1547005383792515);
        let t52 = (r0x_x * (-0.2886751345948131) + d_x * 1.0000000000000004
            + r1x_x * 0.28867513459481264) * t50
            + (r0x_y * (-0.2886751345948131) + d_y * 1.0000000000000004
                + r1x_y * 0.28867513459481264) * t51;
        let t53 = (t44 + r0y_x * (-0.12200846792814612) + r1y_x * 0.4553418012614795)
            * t50
            + (t45 + r0y_y * (-0.12200846792814612) + r1y_y * 0.4553418012614795) * t51;
        reference[0] = 0.5 * (t32 * t32 + t33 * t33 - 1.0);
        reference[1] = 0.5 * (t36 * t36 + t37 * t37 - 1.0);
        reference[2] = t32 * t36 + t33 * t37;
        reference[3] = 0.5 * (t38 * t38 + t39 * t39 - 1.0);
        reference[4] = 0.5 * (ry_half_x * ry_half_x + ry_half_y * ry_half_y - 1.0);
        reference[5] = ry_half_x * t38 + ry_half_y * t39;
        reference[6] = 0.5 * (t40 * t40 + t41 * t41 - 1.0);
        reference[7] = 0.5 * (t42 * t42 + t43 * t43 - 1.0);
        reference[8] = t40 * t42 + t41 * t43;
        reference[9] = t48;
        reference[10] = t49;
        reference[11] = t52;
        reference[12] = t53;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 17 multiplications.
    pub fn beam_planar_curved_mass(row: &BeamPlanarCurved, mass: &mut [f64; 49]) {
        let BeamPlanarCurved { length, rhoA, rhoIz, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let mass_r0_r0 = element_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[0][0];
        let t18 = length * element_mass;
        let mass_r0_r0x = t18 * BEAM_PLANAR_CURVED_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[0][4];
        let mass_r0_r1x = t18 * BEAM_PLANAR_CURVED_MASS_MATRIX[0][5];
        let t22 = element_mass * (length * length);
        let mass_r0x_r0x = t22 * BEAM_PLANAR_CURVED_MASS_MATRIX[1][1];
        let mass_r0x_r1 = t18 * BEAM_PLANAR_CURVED_MASS_MATRIX[1][4];
        let mass_r0x_r1x = t22 * BEAM_PLANAR_CURVED_MASS_MATRIX[1][5];
        let mass_r0y_r0y = section_y_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[2][2];
        let mass_r0y_ry_half = section_y_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[2][3];
        let mass_r0y_r1y = section_y_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[2][6];
        let mass_ry_half_ry_half = section_y_mass * BEAM_PLANAR_CURVED_MASS_MATRIX[3][3];
        let mass_r1_r1x = t18 * BEAM_PLANAR_CURVED_MASS_MATRIX[4][5];
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
    pub fn beam_planar_curved_shapes_position_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 7],
    ) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[4] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[5] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn beam_planar_curved_shapes_position_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 7],
    ) {
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
    pub fn beam_planar_curved_shapes_section_y_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 7],
    ) {
        let t13 = xi * 2.0;
        weights[2] = 1.0 + xi * (-3.0 + t13);
        weights[3] = xi * (4.0 + xi * (-4.0));
        weights[6] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_planar_curved_shapes_section_y_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 7],
    ) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[2] = (-3.0 + t14) * t15;
        weights[3] = t15 * (4.0 + xi * (-8.0));
        weights[6] = t15 * (t14 + (-1.0));
    }
    /// Writes the forces on the fields a, b, db at a point, dU/d(field) per unit length, from their values in the stress-free shape and at present.
    ///
    /// Operations: 29 additions, 53 multiplications.
    pub fn beam_planar_curved_field_forces(
        row: &BeamPlanarCurved,
        stress_free: &[f64; 6],
        fields: &[f64; 6],
        forces: &mut [f64; 6],
    ) {
        let BeamPlanarCurved { length, EA, kyGA, EIz, GIz, .. } = *row;
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
    /// Motion of frame `hub` and its first two derivatives.
    ///
    /// Operations: 8 additions, 13 multiplications, 6 divisions, 4 function calls.
    pub fn frame_hub(
        model: &CurvedUpwind,
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
    /// Operations: 3 additions, 2 multiplications.
    pub fn joint_root_referenced_position(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - data.point[1];
        rows[2] = data.normals[0][0] * q[2] + data.normals[0][1] * q[3];
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jacobian(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[5] = 1.0;
        jacobian[10] = data.normals[0][0];
        jacobian[11] = data.normals[0][1];
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_prescribed(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 11 additions, 16 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_position(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t23 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t23
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t25 = theta.cos();
        let t26 = theta.sin();
        let t27 = q[2] * (t25 * data.normals[0][0] - t26 * data.normals[0][1])
            + q[3] * (t26 * data.normals[0][0] + t25 * data.normals[0][1]);
        rows[0] = q[0] - (t25 * data.point[0] - t26 * data.point[1]);
        rows[1] = q[1] - (t26 * data.point[0] + t25 * data.point[1]);
        rows[2] = t27;
    }
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 11 additions, 21 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_velocity(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t21 = model.omega_s / model.T_s;
        let t22 = (model.T_s / 6.283185307179586).powi(2);
        let t23 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t21 * (t * t / 2.0 + t22 * (t23.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t25 = (if t <= model.T_s {
            t21 * (t - t22 * (6.283185307179586 / model.T_s * t23.sin()))
        } else {
            model.omega_s
        });
        let t26 = theta.sin() * t25;
        let t27 = theta.cos() * t25;
        let t28 = q[3] * (data.normals[0][0] * t27 - data.normals[0][1] * t26)
            - q[2] * (data.normals[0][0] * t26 + data.normals[0][1] * t27);
        rows[0] = data.point[0] * t26 + data.point[1] * t27;
        rows[1] = data.point[1] * t26 - data.point[0] * t27;
        rows[2] = t28;
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 21 additions, 35 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_acceleration(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t23 = model.omega_s / model.T_s;
        let t24 = (model.T_s / 6.283185307179586).powi(2);
        let t25 = t * 6.283185307179586 / model.T_s;
        let t26 = t25.cos();
        let theta = (if t <= model.T_s {
            t23 * (t * t / 2.0 + t24 * (t26 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t28 = theta.cos();
        let t29 = theta.sin();
        let t30 = 6.283185307179586 / model.T_s;
        let t31 = (if t <= model.T_s {
            t23 * (t - t24 * (t30 * t25.sin()))
        } else {
            model.omega_s
        });
        let t32 = t29 * t31;
        let t33 = t28 * t31;
        let t34 = (if t <= model.T_s {
            t23 * (1.0 - t24 * (t30 * (t26 * t30)))
        } else {
            0.0
        });
        let t35 = t31 * t33 + t29 * t34;
        let t36 = t28 * t34 - t31 * t32;
        let t37 = v[2] * (data.normals[0][0] * t32 + data.normals[0][1] * t33);
        let t38 = v[3] * (data.normals[0][0] * t33 - data.normals[0][1] * t32);
        let t39 = t38
            + (t38 + q[3] * (data.normals[0][0] * t36 - data.normals[0][1] * t35))
            - (t37
                + (t37 + q[2] * (data.normals[0][0] * t35 + data.normals[0][1] * t36)));
        rows[0] = data.point[0] * t35 + data.point[1] * t36;
        rows[1] = data.point[1] * t35 - data.point[0] * t36;
        rows[2] = t39;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 36 additions, 51 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_jerk(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t25 = model.omega_s / model.T_s;
        let t26 = (model.T_s / 6.283185307179586).powi(2);
        let t27 = t * 6.283185307179586 / model.T_s;
        let t28 = t27.cos();
        let theta = (if t <= model.T_s {
            t25 * (t * t / 2.0 + t26 * (t28 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t30 = theta.cos();
        let t31 = theta.sin();
        let t32 = 6.283185307179586 / model.T_s;
        let t33 = t32 * t27.sin();
        let t34 = (if t <= model.T_s { t25 * (t - t26 * t33) } else { model.omega_s });
        let t35 = t31 * t34;
        let t36 = t30 * t34;
        let t37 = (if t <= model.T_s {
            t25 * (1.0 - t26 * (t32 * (t28 * t32)))
        } else {
            0.0
        });
        let t38 = t34 * t36 + t31 * t37;
        let t39 = t30 * t37 - t34 * t35;
        let t40 = (if t <= model.T_s { t25 * (t26 * (t32 * (t32 * t33))) } else { 0.0 });
        let t41 = t36 * t37;
        let t42 = t41 + t34 * t39 + (t41 + t31 * t40);
        let t43 = t35 * t37;
        let t44 = t30 * t40 - t43 - (t43 + t34 * t38);
        let t45 = a[2] * (data.normals[0][0] * t35 + data.normals[0][1] * t36);
        let t46 = v[2] * (data.normals[0][0] * t38 + data.normals[0][1] * t39);
        let t47 = t45 + t46;
        let t48 = a[3] * (data.normals[0][0] * t36 - data.normals[0][1] * t35);
        let t49 = v[3] * (data.normals[0][0] * t39 - data.normals[0][1] * t38);
        let t50 = t48 + t49;
        let t51 = t48 + t50
            + (t50
                + (t49 + q[3] * (data.normals[0][0] * t44 - data.normals[0][1] * t42)))
            - (t45 + t47
                + (t47
                    + (t46
                        + q[2]
                            * (data.normals[0][0] * t42 + data.normals[0][1] * t44))));
        rows[0] = data.point[0] * t42 + data.point[1] * t44;
        rows[1] = data.point[1] * t42 - data.point[0] * t44;
        rows[2] = t51;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 6 additions, 10 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_jacobian(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let t17 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t17
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t19 = theta.cos();
        let t20 = theta.sin();
        jacobian[0] = 1.0;
        jacobian[5] = 1.0;
        jacobian[10] = t19 * data.normals[0][0] - t20 * data.normals[0][1];
        jacobian[11] = t20 * data.normals[0][0] + t19 * data.normals[0][1];
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 22 additions, 43 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_prescribed(
        model: &CurvedUpwind,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let t19 = model.omega_s / model.T_s;
        let t20 = (model.T_s / 6.283185307179586).powi(2);
        let t21 = t * 6.283185307179586 / model.T_s;
        let t22 = t21.cos();
        let theta = (if t <= model.T_s {
            t19 * (t * t / 2.0 + t20 * (t22 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t24 = theta.cos();
        let t25 = theta.sin();
        let t26 = 6.283185307179586 / model.T_s;
        let t27 = (if t <= model.T_s {
            t19 * (t - t20 * (t26 * t21.sin()))
        } else {
            model.omega_s
        });
        let t28 = t25 * t27;
        let t29 = t24 * t27;
        let t30 = (if t <= model.T_s {
            t19 * (1.0 - t20 * (t26 * (t22 * t26)))
        } else {
            0.0
        });
        let t31 = t27 * t29 + t25 * t30;
        let t32 = t24 * t30 - t27 * t28;
        prescribed.position[0][0] = t24 * data.point[0] - t25 * data.point[1];
        prescribed.position[0][1] = t25 * data.point[0] + t24 * data.point[1];
        prescribed.position[1][0] = -(data.point[0] * t28 + data.point[1] * t29);
        prescribed.position[1][1] = data.point[0] * t29 - data.point[1] * t28;
        prescribed.position[2][0] = -(data.point[0] * t31 + data.point[1] * t32);
        prescribed.position[2][1] = data.point[0] * t32 - data.point[1] * t31;
        prescribed.slope[0][0] = t24 * data.tangent[0] - t25 * data.tangent[1];
        prescribed.slope[0][1] = t25 * data.tangent[0] + t24 * data.tangent[1];
        prescribed.slope[1][0] = -(data.tangent[0] * t28 + data.tangent[1] * t29);
        prescribed.slope[1][1] = data.tangent[0] * t29 - data.tangent[1] * t28;
        prescribed.slope[2][0] = -(data.tangent[0] * t31 + data.tangent[1] * t32);
        prescribed.slope[2][1] = data.tangent[0] * t32 - data.tangent[1] * t31;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &CurvedUpwind, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn outputs(model: &CurvedUpwind, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0] - 7.670808617667248;
        out[1] = observed[1] - 1.9586790097540359;
        out[2] = 0.0;
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &CurvedUpwind, run: &mut ::rncf::RunDefaults) {
        run.t_end = 20.0;
        run.every = 0.05;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: CurvedUpwind,
        pub row_beam: BeamPlanarCurved,
        pub reference_beam: ::std::vec::Vec<[f64; 13]>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &CurvedUpwind) -> Self {
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
                    axes: &[0, 1],
                    line: ::rncf::emitted::Line::Arc {
                        from: [0.0, 0.0, 0.0],
                        direction: [1.0, 0.0, 0.0],
                        normal: [0.0, 0.0, 1.0],
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
            let second_moment_z = ::rncf::emitted::positive(
                "section `tube`",
                "second_moment_z",
                8.215e-9,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::emitted::part(
                "section `tube`",
                "shear_factor_y",
                0.53,
                "1",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            self.row_beam = BeamPlanarCurved {
                length,
                EA: young * area,
                kyGA: shear_factor_y * shear_modulus * area,
                EIz: young * second_moment_z,
                GIz: shear_modulus * second_moment_z,
                rhoA: density * area,
                rhoIz: density * second_moment_z,
            };
            self.reference_beam = shape
                .chunks_exact(14)
                .map(|shape| {
                    let mut reference = [0.0; 13];
                    beam_planar_curved_reference(
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
            beam_planar_curved_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_planar_curved_elastic_force(
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
            beam_planar_curved_elastic_tangent(
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
            beam_planar_curved_strain_energy(
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
                    beam_planar_curved_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    beam_planar_curved_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    beam_planar_curved_shapes_section_y_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    beam_planar_curved_shapes_section_y_1(
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
                torsion_constant: 0.0,
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
            beam_planar_curved_field_forces(
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
