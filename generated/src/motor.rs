//! Expansion of `models/src/motor.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use motor_equations::Motor;
#[allow(clippy::all)]
impl Default for Motor {
    fn default() -> Self {
        Self {
            speed: 1047.1975511965977,
            T_s: 1.0,
            elements: 4,
            damping: 0.0,
            eccentricity: 0.05,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for Motor {
    const NAME: &'static str = "Motor";
    const DOC: &'static str = "High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end\ncarries an unbalanced disc in its middle.";
    const SOURCE: &'static str = r#"pub model Motor {
    /// Steady angular velocity.
    param speed = 10000 rpm;
    /// Time to reach it.
    param T_s = 1 s;
    /// Number of elements; an even one has a node under the disc.
    param elements: count = 4;
    /// Damping time of the shaft's strains.
    param damping = 0 s;
    /// Distance of the disc's centre from the axis, along y.
    param eccentricity = 50 mm;

    const length = 1.02 m;
    const disc_radius = 0.1 m;
    const disc_thickness = 10 mm;
    const disc_mass = 7800 [kg/m^3] * pi * disc_radius^2 * disc_thickness;

    material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; damping = damping; yield = 355 MPa; }
    section round = circle(radius = 50 mm);

    /// Angle of the motor, Eq. (22).
    motion theta(t) =
        if t <= T_s { (speed/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { speed * (t - T_s/2) };
    frame rotor = rotating(axis = x, angle = theta(t));

    body shaft in rotor {
        spatial;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * beam(round, steel);
    }
    joint drive_end = clamp(shaft.start, rotor);
    joint far_end = pin(shaft.end, rotor);
    // The section strains with the disc: the records of this example were made so, by chains of particles.
    fixture disc on shaft.at(length / 2) {
        section = elastic;
        mass = disc_mass;
        center = [0 m, eccentricity, 0 m];
        inertia = [
            disc_mass * disc_radius^2 / 2,
            disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
            disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
        ];
    }

    /// Deflection of the shaft's middle towards the disc's centre, in the rotating frame.
    output v_mid = shaft.at(length / 2).y;
    /// Deflection of the shaft's middle across it.
    output w_mid = shaft.at(length / 2).z;
    /// Bending moment in the clamp.
    output clamp_moment = shaft.start.moment_z;
    /// Largest stress in the clamp.
    output clamp_stress = shaft.start.stress;

    run { t_end = 1.2 s; every = 1 ms; }
}"#;
    const EQUATIONS_HASH: u64 = 0xc78ebcb0eca87495;
    const NOTES: &'static [&'static str] = &[
        "Body `shaft` uses `beam_spatial_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1945 and 23675).",
        "Body `shaft` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `shaft`: its axis is straight: no stress-free curvature for each element.",
        "Body `shaft` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `drive_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Joint `far_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Fixture `disc` adds constants to the inertia of `shaft` and no unknowns.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as body `shaft` is damped.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "BEAM_SPATIAL_DAMPED_MASS_MATRIX",
            size: [10, 10],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points3_force",
            additions: 63,
            multiplications: 106,
            divisions: 0,
            functions: 0,
            weighted: 169,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points3_tangent",
            additions: 189,
            multiplications: 396,
            divisions: 0,
            functions: 0,
            weighted: 585,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points3_energy",
            additions: 20,
            multiplications: 41,
            divisions: 0,
            functions: 0,
            weighted: 61,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points2_force",
            additions: 75,
            multiplications: 130,
            divisions: 1,
            functions: 0,
            weighted: 209,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points2_tangent",
            additions: 344,
            multiplications: 796,
            divisions: 1,
            functions: 0,
            weighted: 1144,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_points2_energy",
            additions: 19,
            multiplications: 49,
            divisions: 1,
            functions: 0,
            weighted: 72,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_mass",
            additions: 0,
            multiplications: 22,
            divisions: 0,
            functions: 0,
            weighted: 22,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_section_z_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_shapes_section_z_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "beam_spatial_damped_field_forces",
            additions: 195,
            multiplications: 276,
            divisions: 0,
            functions: 0,
            weighted: 471,
        },
        ::rncf::model::KernelCount {
            name: "frame_rotor",
            additions: 8,
            multiplications: 13,
            divisions: 6,
            functions: 4,
            weighted: 125,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_referenced_position",
            additions: 15,
            multiplications: 19,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_referenced_jacobian",
            additions: 3,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_position",
            additions: 25,
            multiplications: 37,
            divisions: 5,
            functions: 3,
            weighted: 142,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_velocity",
            additions: 28,
            multiplications: 50,
            divisions: 6,
            functions: 4,
            weighted: 182,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_acceleration",
            additions: 65,
            multiplications: 86,
            divisions: 6,
            functions: 4,
            weighted: 255,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_jerk",
            additions: 121,
            multiplications: 126,
            divisions: 6,
            functions: 4,
            weighted: 351,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_jacobian",
            additions: 12,
            multiplications: 26,
            divisions: 5,
            functions: 3,
            weighted: 118,
        },
        ::rncf::model::KernelCount {
            name: "joint_drive_end_absolute_prescribed",
            additions: 28,
            multiplications: 55,
            divisions: 6,
            functions: 4,
            weighted: 187,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_referenced_position",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_absolute_position",
            additions: 9,
            multiplications: 10,
            divisions: 5,
            functions: 3,
            weighted: 99,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_absolute_velocity",
            additions: 8,
            multiplications: 15,
            divisions: 6,
            functions: 4,
            weighted: 127,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_absolute_acceleration",
            additions: 12,
            multiplications: 23,
            divisions: 6,
            functions: 4,
            weighted: 139,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_absolute_jerk",
            additions: 19,
            multiplications: 33,
            divisions: 6,
            functions: 4,
            weighted: 156,
        },
        ::rncf::model::KernelCount {
            name: "joint_far_end_absolute_prescribed",
            additions: 28,
            multiplications: 55,
            divisions: 6,
            functions: 4,
            weighted: 187,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "speed",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rpm",
                unit_si: 0.10471975511965977,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 1047.1975511965977,
                doc: "Steady angular velocity.",
            },
            ::rncf::Param {
                name: "T_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 1.0,
                doc: "Time to reach it.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 4.0,
                doc: "Number of elements; an even one has a node under the disc.",
            },
            ::rncf::Param {
                name: "damping",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 0.0,
                doc: "Damping time of the shaft's strains.",
            },
            ::rncf::Param {
                name: "eccentricity",
                kind: ::rncf::ParamKind::Quantity,
                unit: "mm",
                unit_si: 0.001,
                dimension: [1, 0, 0, 0, 0, 0],
                default: 0.05,
                doc: "Distance of the disc's centre from the axis, along y.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "v_mid",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the shaft's middle towards the disc's centre, in the rotating frame.",
            },
            ::rncf::Output {
                name: "w_mid",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the shaft's middle across it.",
            },
            ::rncf::Output {
                name: "clamp_moment",
                unit: "N m",
                time_exponent: -2.0,
                components: &[],
                doc: "Bending moment in the clamp.",
            },
            ::rncf::Output {
                name: "clamp_stress",
                unit: "Pa",
                time_exponent: -2.0,
                components: &[],
                doc: "Largest stress in the clamp.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.speed,
            1 => self.T_s,
            2 => self.elements as f64,
            3 => self.damping,
            4 => self.eccentricity,
            _ => panic!("Motor has 5 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.speed = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            3 => self.damping = value,
            4 => self.eccentricity = value,
            _ => panic!("Motor has 5 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        motor_equations::run_defaults(self, &mut run);
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
        let equations = motor_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`Motor`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod motor_equations {
    /// High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end
    /// carries an unbalanced disc in its middle.
    ///
    /// # Chosen and left out
    ///
    /// * Body `shaft` uses `beam_spatial_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1945 and 23675).
    /// * Body `shaft` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
    /// * Body `shaft`: its axis is straight: no stress-free curvature for each element.
    /// * Body `shaft` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `drive_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Joint `far_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Fixture `disc` adds constants to the inertia of `shaft` and no unknowns.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as body `shaft` is damped.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct Motor {
        /// Steady angular velocity. (SI; declared in rpm)
        pub speed: f64,
        /// Time to reach it. (SI; declared in s)
        pub T_s: f64,
        /// Number of elements; an even one has a node under the disc. (count)
        pub elements: usize,
        /// Damping time of the shaft's strains. (SI; declared in s)
        pub damping: f64,
        /// Distance of the disc's centre from the axis, along y. (SI; declared in mm)
        pub eccentricity: f64,
    }
    /// Constants of one element `beam_spatial_damped`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1945 and 23675).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatialDamped {
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
        /// Damping of the strain measures, s.
        pub damping: f64,
    }
    /// Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.
    ///
    /// Rows and columns: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z; slopes are multiplied by the length. The sum of a row's columns of positions is the first moment d_a.
    pub const BEAM_SPATIAL_DAMPED_MASS_MATRIX: [[f64; 10]; 10] = [
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
    static BEAM_SPATIAL_DAMPED_VECTORS: ::rncf::emitted::Vectors<10, 3, 3, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_DAMPED_POINTS3: ::rncf::emitted::Rule<3, 3, 3> = ::rncf::emitted::Rule {
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
    static BEAM_SPATIAL_DAMPED_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 9> = BEAM_SPATIAL_DAMPED_POINTS3
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
    static BEAM_SPATIAL_DAMPED_POINTS3_DAMPING: ::rncf::emitted::Blocks<3, 9, 6> = BEAM_SPATIAL_DAMPED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_DAMPED_POINTS2: ::rncf::emitted::Rule<2, 5, 3> = ::rncf::emitted::Rule {
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
    static BEAM_SPATIAL_DAMPED_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<2, 9, 21> = BEAM_SPATIAL_DAMPED_POINTS2
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
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_DAMPED_POINTS2_DAMPING: ::rncf::emitted::Blocks<2, 9, 15> = BEAM_SPATIAL_DAMPED_POINTS2
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
    /// Operations: 63 additions, 106 multiplications.
    pub fn beam_spatial_damped_points3_force(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatialDamped {
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
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t36 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t37 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t38 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t39 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t40 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t41 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t42 = length * EA;
        let t43 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t36 + t36));
        let t44 = 0.5 * (t42 * t43);
        let t45 = length * kyGA * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t37);
        let t46 = length * kzGA * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t38);
        let t47 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t48 = 0.5 * (t42 * t47);
        let t49 = length * halfEA * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t40);
        let t50 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t41 + t41));
        let t51 = 0.5 * (t42 * t50);
        forces[0][0] = t44 * (a_x * 2.0) + b_x * t45 + c_x * t46;
        forces[0][1] = t44 * (a_y * 2.0) + b_y * t45 + c_y * t46;
        forces[0][2] = t44 * (a_z * 2.0) + b_z * t45 + c_z * t46;
        forces[1][0] = a_x * t45 + t48 * (b_x * 2.0) + c_x * t49;
        forces[1][1] = a_y * t45 + t48 * (b_y * 2.0) + c_y * t49;
        forces[1][2] = a_z * t45 + t48 * (b_z * 2.0) + c_z * t49;
        forces[2][0] = a_x * t46 + b_x * t49 + t51 * (c_x * 2.0);
        forces[2][1] = a_y * t46 + b_y * t49 + t51 * (c_y * 2.0);
        forces[2][2] = a_z * t46 + b_z * t49 + t51 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 189 additions, 396 multiplications.
    pub fn beam_spatial_damped_points3_tangent(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 9],
        damping_matrix: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatialDamped {
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
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t36 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t37 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t38 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t39 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t40 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t41 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t42 = length * EA;
        let t43 = length * kyGA;
        let t44 = length * kzGA;
        let t45 = length * halfEA;
        let t46 = 0.5 * (0.5 * t42);
        let t47 = 0.5 * (t42 * (damping * 0.5));
        let t48 = damping * t43;
        let t49 = damping * t44;
        let t50 = damping * t45;
        let t51 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t36 + t36));
        let t52 = t43 * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t37);
        let t53 = t44 * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t38);
        let t54 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t55 = t45 * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t40);
        let t56 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t41 + t41));
        let t57 = a_x * 2.0;
        let t58 = a_y * 2.0;
        let t59 = a_z * 2.0;
        let t60 = b_x * 2.0;
        let t61 = b_y * 2.0;
        let t62 = b_z * 2.0;
        let t63 = c_x * 2.0;
        let t64 = c_y * 2.0;
        let t65 = c_z * 2.0;
        let t66 = t46 * t57 + t47 * (v_a_x * 2.0);
        let t67 = t46 * t58 + t47 * (v_a_y * 2.0);
        let t68 = t46 * t59 + t47 * (v_a_z * 2.0);
        let t69 = b_x * t43 + v_b_x * t48;
        let t70 = b_y * t43 + v_b_y * t48;
        let t71 = b_z * t43 + v_b_z * t48;
        let t72 = a_x * t43 + v_a_x * t48;
        let t73 = a_y * t43 + v_a_y * t48;
        let t74 = a_z * t43 + v_a_z * t48;
        let t75 = c_x * t44 + v_c_x * t49;
        let t76 = c_y * t44 + v_c_y * t49;
        let t77 = c_z * t44 + v_c_z * t49;
        let t78 = a_x * t44 + v_a_x * t49;
        let t79 = a_y * t44 + v_a_y * t49;
        let t80 = a_z * t44 + v_a_z * t49;
        let t81 = t46 * t60 + t47 * (v_b_x * 2.0);
        let t82 = t46 * t61 + t47 * (v_b_y * 2.0);
        let t83 = t46 * t62 + t47 * (v_b_z * 2.0);
        let t84 = c_x * t45 + v_c_x * t50;
        let t85 = c_y * t45 + v_c_y * t50;
        let t86 = c_z * t45 + v_c_z * t50;
        let t87 = b_x * t45 + v_b_x * t50;
        let t88 = b_y * t45 + v_b_y * t50;
        let t89 = b_z * t45 + v_b_z * t50;
        let t90 = t46 * t63 + t47 * (v_c_x * 2.0);
        let t91 = t46 * t64 + t47 * (v_c_y * 2.0);
        let t92 = t46 * t65 + t47 * (v_c_z * 2.0);
        let t93 = 0.5 * (t42 * t51) * 2.0;
        let t94 = 0.5 * (t42 * t54) * 2.0;
        let t95 = 0.5 * (t42 * t56) * 2.0;
        let t96 = t47 * t58;
        let t97 = t47 * t59;
        let t98 = b_y * t48;
        let t99 = b_z * t48;
        let t100 = a_x * t48;
        let t101 = a_y * t48;
        let t102 = a_z * t48;
        let t103 = c_y * t49;
        let t104 = c_z * t49;
        let t105 = a_x * t49;
        let t106 = a_y * t49;
        let t107 = a_z * t49;
        let t108 = t47 * t61;
        let t109 = t47 * t62;
        let t110 = c_y * t50;
        let t111 = c_z * t50;
        let t112 = b_x * t50;
        let t113 = b_y * t50;
        let t114 = b_z * t50;
        let t115 = t47 * t64;
        let t116 = t47 * t65;
        let t117 = t57 * t96 + b_x * t98 + c_x * t103;
        let t118 = t57 * t97 + b_x * t99 + c_x * t104;
        let t119 = t58 * t97 + b_y * t99 + c_y * t104;
        let t120 = a_x * t101 + t60 * t108 + c_x * t110;
        let t121 = a_x * t102 + t60 * t109 + c_x * t111;
        let t122 = a_y * t102 + t61 * t109 + c_y * t111;
        let t123 = a_x * t106 + b_x * t113 + t63 * t115;
        let t124 = a_x * t107 + b_x * t114 + t63 * t116;
        let t125 = a_y * t107 + b_y * t114 + t64 * t116;
        stiffness[0][0] = t57 * t66 + b_x * t69 + c_x * t75 + t93;
        stiffness[0][1] = t57 * t67 + b_x * t70 + c_x * t76;
        stiffness[0][2] = t57 * t68 + b_x * t71 + c_x * t77;
        stiffness[0][3] = t58 * t66 + b_y * t69 + c_y * t75;
        stiffness[0][4] = t58 * t67 + b_y * t70 + c_y * t76 + t93;
        stiffness[0][5] = t58 * t68 + b_y * t71 + c_y * t77;
        stiffness[0][6] = t59 * t66 + b_z * t69 + c_z * t75;
        stiffness[0][7] = t59 * t67 + b_z * t70 + c_z * t76;
        stiffness[0][8] = t59 * t68 + b_z * t71 + c_z * t77 + t93;
        stiffness[1][0] = t52 + b_x * t72;
        stiffness[1][1] = b_x * t73;
        stiffness[1][2] = b_x * t74;
        stiffness[1][3] = b_y * t72;
        stiffness[1][4] = t52 + b_y * t73;
        stiffness[1][5] = b_y * t74;
        stiffness[1][6] = b_z * t72;
        stiffness[1][7] = b_z * t73;
        stiffness[1][8] = t52 + b_z * t74;
        stiffness[2][0] = t53 + c_x * t78;
        stiffness[2][1] = c_x * t79;
        stiffness[2][2] = c_x * t80;
        stiffness[2][3] = c_y * t78;
        stiffness[2][4] = t53 + c_y * t79;
        stiffness[2][5] = c_y * t80;
        stiffness[2][6] = c_z * t78;
        stiffness[2][7] = c_z * t79;
        stiffness[2][8] = t53 + c_z * t80;
        stiffness[3][0] = t52 + a_x * t69;
        stiffness[3][1] = a_x * t70;
        stiffness[3][2] = a_x * t71;
        stiffness[3][3] = a_y * t69;
        stiffness[3][4] = t52 + a_y * t70;
        stiffness[3][5] = a_y * t71;
        stiffness[3][6] = a_z * t69;
        stiffness[3][7] = a_z * t70;
        stiffness[3][8] = t52 + a_z * t71;
        stiffness[4][0] = a_x * t72 + t60 * t81 + c_x * t84 + t94;
        stiffness[4][1] = a_x * t73 + t60 * t82 + c_x * t85;
        stiffness[4][2] = a_x * t74 + t60 * t83 + c_x * t86;
        stiffness[4][3] = a_y * t72 + t61 * t81 + c_y * t84;
        stiffness[4][4] = a_y * t73 + t61 * t82 + c_y * t85 + t94;
        stiffness[4][5] = a_y * t74 + t61 * t83 + c_y * t86;
        stiffness[4][6] = a_z * t72 + t62 * t81 + c_z * t84;
        stiffness[4][7] = a_z * t73 + t62 * t82 + c_z * t85;
        stiffness[4][8] = a_z * t74 + t62 * t83 + c_z * t86 + t94;
        stiffness[5][0] = t55 + c_x * t87;
        stiffness[5][1] = c_x * t88;
        stiffness[5][2] = c_x * t89;
        stiffness[5][3] = c_y * t87;
        stiffness[5][4] = t55 + c_y * t88;
        stiffness[5][5] = c_y * t89;
        stiffness[5][6] = c_z * t87;
        stiffness[5][7] = c_z * t88;
        stiffness[5][8] = t55 + c_z * t89;
        stiffness[6][0] = t53 + a_x * t75;
        stiffness[6][1] = a_x * t76;
        stiffness[6][2] = a_x * t77;
        stiffness[6][3] = a_y * t75;
        stiffness[6][4] = t53 + a_y * t76;
        stiffness[6][5] = a_y * t77;
        stiffness[6][6] = a_z * t75;
        stiffness[6][7] = a_z * t76;
        stiffness[6][8] = t53 + a_z * t77;
        stiffness[7][0] = t55 + b_x * t84;
        stiffness[7][1] = b_x * t85;
        stiffness[7][2] = b_x * t86;
        stiffness[7][3] = b_y * t84;
        stiffness[7][4] = t55 + b_y * t85;
        stiffness[7][5] = b_y * t86;
        stiffness[7][6] = b_z * t84;
        stiffness[7][7] = b_z * t85;
        stiffness[7][8] = t55 + b_z * t86;
        stiffness[8][0] = a_x * t78 + b_x * t87 + t63 * t90 + t95;
        stiffness[8][1] = a_x * t79 + b_x * t88 + t63 * t91;
        stiffness[8][2] = a_x * t80 + b_x * t89 + t63 * t92;
        stiffness[8][3] = a_y * t78 + b_y * t87 + t64 * t90;
        stiffness[8][4] = a_y * t79 + b_y * t88 + t64 * t91 + t95;
        stiffness[8][5] = a_y * t80 + b_y * t89 + t64 * t92;
        stiffness[8][6] = a_z * t78 + b_z * t87 + t65 * t90;
        stiffness[8][7] = a_z * t79 + b_z * t88 + t65 * t91;
        stiffness[8][8] = a_z * t80 + b_z * t89 + t65 * t92 + t95;
        damping_matrix[0][0] = t57 * (t47 * t57) + b_x * (b_x * t48) + c_x * (c_x * t49);
        damping_matrix[0][1] = t117;
        damping_matrix[0][2] = t118;
        damping_matrix[0][3] = t117;
        damping_matrix[0][4] = t58 * t96 + b_y * t98 + c_y * t103;
        damping_matrix[0][5] = t119;
        damping_matrix[0][6] = t118;
        damping_matrix[0][7] = t119;
        damping_matrix[0][8] = t59 * t97 + b_z * t99 + c_z * t104;
        damping_matrix[1][0] = b_x * t100;
        damping_matrix[1][1] = b_x * t101;
        damping_matrix[1][2] = b_x * t102;
        damping_matrix[1][3] = b_y * t100;
        damping_matrix[1][4] = b_y * t101;
        damping_matrix[1][5] = b_y * t102;
        damping_matrix[1][6] = b_z * t100;
        damping_matrix[1][7] = b_z * t101;
        damping_matrix[1][8] = b_z * t102;
        damping_matrix[2][0] = c_x * t105;
        damping_matrix[2][1] = c_x * t106;
        damping_matrix[2][2] = c_x * t107;
        damping_matrix[2][3] = c_y * t105;
        damping_matrix[2][4] = c_y * t106;
        damping_matrix[2][5] = c_y * t107;
        damping_matrix[2][6] = c_z * t105;
        damping_matrix[2][7] = c_z * t106;
        damping_matrix[2][8] = c_z * t107;
        damping_matrix[3][0] = a_x * t100 + t60 * (t47 * t60) + c_x * (c_x * t50);
        damping_matrix[3][1] = t120;
        damping_matrix[3][2] = t121;
        damping_matrix[3][3] = t120;
        damping_matrix[3][4] = a_y * t101 + t61 * t108 + c_y * t110;
        damping_matrix[3][5] = t122;
        damping_matrix[3][6] = t121;
        damping_matrix[3][7] = t122;
        damping_matrix[3][8] = a_z * t102 + t62 * t109 + c_z * t111;
        damping_matrix[4][0] = c_x * t112;
        damping_matrix[4][1] = c_x * t113;
        damping_matrix[4][2] = c_x * t114;
        damping_matrix[4][3] = c_y * t112;
        damping_matrix[4][4] = c_y * t113;
        damping_matrix[4][5] = c_y * t114;
        damping_matrix[4][6] = c_z * t112;
        damping_matrix[4][7] = c_z * t113;
        damping_matrix[4][8] = c_z * t114;
        damping_matrix[5][0] = a_x * t105 + b_x * t112 + t63 * (t47 * t63);
        damping_matrix[5][1] = t123;
        damping_matrix[5][2] = t124;
        damping_matrix[5][3] = t123;
        damping_matrix[5][4] = a_y * t106 + b_y * t113 + t64 * t115;
        damping_matrix[5][5] = t125;
        damping_matrix[5][6] = t124;
        damping_matrix[5][7] = t125;
        damping_matrix[5][8] = a_z * t107 + b_z * t114 + t65 * t116;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 20 additions, 41 multiplications.
    pub fn beam_spatial_damped_points3_energy(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatialDamped {
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
            damping,
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
    /// Operations: 75 additions, 130 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_force(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatialDamped {
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
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z],
        [v_unit_db_x, v_unit_db_y, v_unit_db_z], [v_unit_dc_x, v_unit_dc_y, v_unit_dc_z],
        ] = *rates;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let v_db_x = inverse_length * v_unit_db_x;
        let v_db_y = inverse_length * v_unit_db_y;
        let v_db_z = inverse_length * v_unit_db_z;
        let v_dc_x = inverse_length * v_unit_dc_x;
        let v_dc_y = inverse_length * v_unit_dc_y;
        let v_dc_z = inverse_length * v_unit_dc_z;
        let t63 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t64 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t65 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t66 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t67 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t68 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t69 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t70 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t71 = length * EIz * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t63);
        let t72 = length * EIy * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t64);
        let t73 = length * GIz * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t65);
        let t74 = length * GJ * (0.5 * (t68 - t66) + damping * (0.5 * (t69 - t67)));
        let t75 = length * GIyz * (t66 + t68 + damping * (t67 + t69));
        let t76 = length * GIy * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t70);
        let t77 = inverse_length * t71;
        let t78 = inverse_length * t72;
        let t79 = inverse_length * t73;
        let t80 = inverse_length * (-0.5 * t74 + t75);
        let t81 = inverse_length * (t75 + 0.5 * t74);
        let t82 = inverse_length * t76;
        forces[0][0] = unit_db_x * t77 + unit_dc_x * t78;
        forces[0][1] = unit_db_y * t77 + unit_dc_y * t78;
        forces[0][2] = unit_db_z * t77 + unit_dc_z * t78;
        forces[1][0] = unit_db_x * t79 + unit_dc_x * t80;
        forces[1][1] = unit_db_y * t79 + unit_dc_y * t80;
        forces[1][2] = unit_db_z * t79 + unit_dc_z * t80;
        forces[2][0] = unit_db_x * t81 + unit_dc_x * t82;
        forces[2][1] = unit_db_y * t81 + unit_dc_y * t82;
        forces[2][2] = unit_db_z * t81 + unit_dc_z * t82;
        forces[3][0] = a_x * t77 + b_x * t79 + c_x * t81;
        forces[3][1] = a_y * t77 + b_y * t79 + c_y * t81;
        forces[3][2] = a_z * t77 + b_z * t79 + c_z * t81;
        forces[4][0] = a_x * t78 + b_x * t80 + c_x * t82;
        forces[4][1] = a_y * t78 + b_y * t80 + c_y * t82;
        forces[4][2] = a_z * t78 + b_z * t80 + c_z * t82;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 344 additions, 796 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_tangent(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 21],
        damping_matrix: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatialDamped {
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
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z],
        [v_unit_db_x, v_unit_db_y, v_unit_db_z], [v_unit_dc_x, v_unit_dc_y, v_unit_dc_z],
        ] = *rates;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let v_db_x = inverse_length * v_unit_db_x;
        let v_db_y = inverse_length * v_unit_db_y;
        let v_db_z = inverse_length * v_unit_db_z;
        let v_dc_x = inverse_length * v_unit_dc_x;
        let v_dc_y = inverse_length * v_unit_dc_y;
        let v_dc_z = inverse_length * v_unit_dc_z;
        let t63 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t64 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t65 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t66 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t67 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t68 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t69 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t70 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t71 = length * EIz;
        let t72 = length * EIy;
        let t73 = length * GJ;
        let t74 = 0.5 * t73;
        let t75 = length * GIz;
        let t76 = length * GIy;
        let t77 = length * GIyz;
        let t78 = t73 * (-0.5);
        let t79 = t73 * (damping * (-0.5));
        let t80 = damping * t77;
        let t81 = t73 * (damping * 0.5);
        let t82 = t73 * (0.5 * (t68 - t66) + damping * (0.5 * (t69 - t67)));
        let t83 = t77 * (t66 + t68 + damping * (t67 + t69));
        let t84 = inverse_length
            * (t71 * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t63));
        let t85 = inverse_length * inverse_length;
        let t86 = t71 * t85;
        let t87 = damping * t71 * t85;
        let t88 = inverse_length
            * (t72 * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t64));
        let t89 = t72 * t85;
        let t90 = damping * t72 * t85;
        let t91 = inverse_length
            * (t75 * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t65));
        let t92 = t75 * t85;
        let t93 = damping * t75 * t85;
        let t94 = inverse_length * (-0.5 * t82 + t83);
        let t95 = (t77 + (-0.5 * t78)) * t85;
        let t96 = (t77 + (-0.5 * t74)) * t85;
        let t97 = (-0.5 * t79 + t80) * t85;
        let t98 = (t80 + (-0.5 * t81)) * t85;
        let t99 = inverse_length * (t83 + 0.5 * t82);
        let t100 = (t77 + 0.5 * t78) * t85;
        let t101 = (t77 + 0.5 * t74) * t85;
        let t102 = (t80 + 0.5 * t79) * t85;
        let t103 = (t80 + 0.5 * t81) * t85;
        let t104 = inverse_length
            * (t76 * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t70));
        let t105 = t76 * t85;
        let t106 = damping * t76 * t85;
        let t107 = unit_db_x * t86 + v_unit_db_x * t87;
        let t108 = unit_db_y * t86 + v_unit_db_y * t87;
        let t109 = unit_db_z * t86 + v_unit_db_z * t87;
        let t110 = a_x * t86 + v_a_x * t87;
        let t111 = a_y * t86 + v_a_y * t87;
        let t112 = a_z * t86 + v_a_z * t87;
        let t113 = unit_dc_x * t89 + v_unit_dc_x * t90;
        let t114 = unit_dc_y * t89 + v_unit_dc_y * t90;
        let t115 = unit_dc_z * t89 + v_unit_dc_z * t90;
        let t116 = a_x * t89 + v_a_x * t90;
        let t117 = a_y * t89 + v_a_y * t90;
        let t118 = a_z * t89 + v_a_z * t90;
        let t119 = unit_db_x * t92 + v_unit_db_x * t93;
        let t120 = unit_db_y * t92 + v_unit_db_y * t93;
        let t121 = unit_db_z * t92 + v_unit_db_z * t93;
        let t122 = b_x * t92 + v_b_x * t93;
        let t123 = b_y * t92 + v_b_y * t93;
        let t124 = b_z * t92 + v_b_z * t93;
        let t125 = unit_dc_x * t95 + v_unit_dc_x * t97;
        let t126 = unit_dc_y * t95 + v_unit_dc_y * t97;
        let t127 = unit_dc_z * t95 + v_unit_dc_z * t97;
        let t128 = unit_db_x * t96 + v_unit_db_x * t98;
        let t129 = unit_db_y * t96 + v_unit_db_y * t98;
        let t130 = unit_db_z * t96 + v_unit_db_z * t98;
        let t131 = c_x * t96 + v_c_x * t98;
        let t132 = c_y * t96 + v_c_y * t98;
        let t133 = c_z * t96 + v_c_z * t98;
        let t134 = b_x * t95 + v_b_x * t97;
        let t135 = b_y * t95 + v_b_y * t97;
        let t136 = b_z * t95 + v_b_z * t97;
        let t137 = unit_dc_x * t100 + v_unit_dc_x * t102;
        let t138 = unit_dc_y * t100 + v_unit_dc_y * t102;
        let t139 = unit_dc_z * t100 + v_unit_dc_z * t102;
        let t140 = unit_db_x * t101 + v_unit_db_x * t103;
        let t141 = unit_db_y * t101 + v_unit_db_y * t103;
        let t142 = unit_db_z * t101 + v_unit_db_z * t103;
        let t143 = c_x * t101 + v_c_x * t103;
        let t144 = c_y * t101 + v_c_y * t103;
        let t145 = c_z * t101 + v_c_z * t103;
        let t146 = b_x * t100 + v_b_x * t102;
        let t147 = b_y * t100 + v_b_y * t102;
        let t148 = b_z * t100 + v_b_z * t102;
        let t149 = unit_dc_x * t105 + v_unit_dc_x * t106;
        let t150 = unit_dc_y * t105 + v_unit_dc_y * t106;
        let t151 = unit_dc_z * t105 + v_unit_dc_z * t106;
        let t152 = c_x * t105 + v_c_x * t106;
        let t153 = c_y * t105 + v_c_y * t106;
        let t154 = c_z * t105 + v_c_z * t106;
        let t155 = unit_db_x * t87;
        let t156 = unit_db_y * t87;
        let t157 = unit_db_z * t87;
        let t158 = a_x * t87;
        let t159 = a_y * t87;
        let t160 = a_z * t87;
        let t161 = unit_dc_x * t90;
        let t162 = unit_dc_y * t90;
        let t163 = unit_dc_z * t90;
        let t164 = a_x * t90;
        let t165 = a_y * t90;
        let t166 = a_z * t90;
        let t167 = unit_db_x * t93;
        let t168 = unit_db_y * t93;
        let t169 = unit_db_z * t93;
        let t170 = b_x * t93;
        let t171 = b_y * t93;
        let t172 = b_z * t93;
        let t173 = unit_dc_x * t97;
        let t174 = unit_dc_y * t97;
        let t175 = unit_dc_z * t97;
        let t176 = unit_db_x * t98;
        let t177 = unit_db_y * t98;
        let t178 = unit_db_z * t98;
        let t179 = c_x * t98;
        let t180 = c_y * t98;
        let t181 = c_z * t98;
        let t182 = b_x * t97;
        let t183 = b_y * t97;
        let t184 = b_z * t97;
        let t185 = unit_dc_x * t102;
        let t186 = unit_dc_y * t102;
        let t187 = unit_dc_z * t102;
        let t188 = unit_db_x * t103;
        let t189 = unit_db_y * t103;
        let t190 = unit_db_z * t103;
        let t191 = c_x * t103;
        let t192 = c_y * t103;
        let t193 = c_z * t103;
        let t194 = b_x * t102;
        let t195 = b_y * t102;
        let t196 = b_z * t102;
        let t197 = unit_dc_x * t106;
        let t198 = unit_dc_y * t106;
        let t199 = unit_dc_z * t106;
        let t200 = c_x * t106;
        let t201 = c_y * t106;
        let t202 = c_z * t106;
        stiffness[0][0] = unit_db_x * t107 + unit_dc_x * t113;
        stiffness[0][1] = unit_db_x * t108 + unit_dc_x * t114;
        stiffness[0][2] = unit_db_x * t109 + unit_dc_x * t115;
        stiffness[0][3] = unit_db_y * t107 + unit_dc_y * t113;
        stiffness[0][4] = unit_db_y * t108 + unit_dc_y * t114;
        stiffness[0][5] = unit_db_y * t109 + unit_dc_y * t115;
        stiffness[0][6] = unit_db_z * t107 + unit_dc_z * t113;
        stiffness[0][7] = unit_db_z * t108 + unit_dc_z * t114;
        stiffness[0][8] = unit_db_z * t109 + unit_dc_z * t115;
        stiffness[1][0] = t84 + unit_db_x * t110;
        stiffness[1][1] = unit_db_x * t111;
        stiffness[1][2] = unit_db_x * t112;
        stiffness[1][3] = unit_db_y * t110;
        stiffness[1][4] = t84 + unit_db_y * t111;
        stiffness[1][5] = unit_db_y * t112;
        stiffness[1][6] = unit_db_z * t110;
        stiffness[1][7] = unit_db_z * t111;
        stiffness[1][8] = t84 + unit_db_z * t112;
        stiffness[2][0] = t88 + unit_dc_x * t116;
        stiffness[2][1] = unit_dc_x * t117;
        stiffness[2][2] = unit_dc_x * t118;
        stiffness[2][3] = unit_dc_y * t116;
        stiffness[2][4] = t88 + unit_dc_y * t117;
        stiffness[2][5] = unit_dc_y * t118;
        stiffness[2][6] = unit_dc_z * t116;
        stiffness[2][7] = unit_dc_z * t117;
        stiffness[2][8] = t88 + unit_dc_z * t118;
        stiffness[3][0] = t84 + a_x * t107;
        stiffness[3][1] = a_x * t108;
        stiffness[3][2] = a_x * t109;
        stiffness[3][3] = a_y * t107;
        stiffness[3][4] = t84 + a_y * t108;
        stiffness[3][5] = a_y * t109;
        stiffness[3][6] = a_z * t107;
        stiffness[3][7] = a_z * t108;
        stiffness[3][8] = t84 + a_z * t109;
        stiffness[4][0] = unit_db_x * t119 + unit_dc_x * t125;
        stiffness[4][1] = unit_db_x * t120 + unit_dc_x * t126;
        stiffness[4][2] = unit_db_x * t121 + unit_dc_x * t127;
        stiffness[4][3] = unit_db_y * t119 + unit_dc_y * t125;
        stiffness[4][4] = unit_db_y * t120 + unit_dc_y * t126;
        stiffness[4][5] = unit_db_y * t121 + unit_dc_y * t127;
        stiffness[4][6] = unit_db_z * t119 + unit_dc_z * t125;
        stiffness[4][7] = unit_db_z * t120 + unit_dc_z * t126;
        stiffness[4][8] = unit_db_z * t121 + unit_dc_z * t127;
        stiffness[5][0] = t91 + (unit_db_x * t122 + unit_dc_x * t131);
        stiffness[5][1] = unit_db_x * t123 + unit_dc_x * t132;
        stiffness[5][2] = unit_db_x * t124 + unit_dc_x * t133;
        stiffness[5][3] = unit_db_y * t122 + unit_dc_y * t131;
        stiffness[5][4] = t91 + (unit_db_y * t123 + unit_dc_y * t132);
        stiffness[5][5] = unit_db_y * t124 + unit_dc_y * t133;
        stiffness[5][6] = unit_db_z * t122 + unit_dc_z * t131;
        stiffness[5][7] = unit_db_z * t123 + unit_dc_z * t132;
        stiffness[5][8] = t91 + (unit_db_z * t124 + unit_dc_z * t133);
        stiffness[6][0] = t91 + (b_x * t119 + c_x * t137);
        stiffness[6][1] = b_x * t120 + c_x * t138;
        stiffness[6][2] = b_x * t121 + c_x * t139;
        stiffness[6][3] = b_y * t119 + c_y * t137;
        stiffness[6][4] = t91 + (b_y * t120 + c_y * t138);
        stiffness[6][5] = b_y * t121 + c_y * t139;
        stiffness[6][6] = b_z * t119 + c_z * t137;
        stiffness[6][7] = b_z * t120 + c_z * t138;
        stiffness[6][8] = t91 + (b_z * t121 + c_z * t139);
        stiffness[7][0] = a_x * t110 + b_x * t122 + c_x * t143;
        stiffness[7][1] = a_x * t111 + b_x * t123 + c_x * t144;
        stiffness[7][2] = a_x * t112 + b_x * t124 + c_x * t145;
        stiffness[7][3] = a_y * t110 + b_y * t122 + c_y * t143;
        stiffness[7][4] = a_y * t111 + b_y * t123 + c_y * t144;
        stiffness[7][5] = a_y * t112 + b_y * t124 + c_y * t145;
        stiffness[7][6] = a_z * t110 + b_z * t122 + c_z * t143;
        stiffness[7][7] = a_z * t111 + b_z * t123 + c_z * t144;
        stiffness[7][8] = a_z * t112 + b_z * t124 + c_z * t145;
        stiffness[8][0] = unit_dc_x * t128;
        stiffness[8][1] = unit_dc_x * t129;
        stiffness[8][2] = unit_dc_x * t130;
        stiffness[8][3] = unit_dc_y * t128;
        stiffness[8][4] = unit_dc_y * t129;
        stiffness[8][5] = unit_dc_y * t130;
        stiffness[8][6] = unit_dc_z * t128;
        stiffness[8][7] = unit_dc_z * t129;
        stiffness[8][8] = unit_dc_z * t130;
        stiffness[9][0] = t94 + unit_dc_x * t134;
        stiffness[9][1] = unit_dc_x * t135;
        stiffness[9][2] = unit_dc_x * t136;
        stiffness[9][3] = unit_dc_y * t134;
        stiffness[9][4] = t94 + unit_dc_y * t135;
        stiffness[9][5] = unit_dc_y * t136;
        stiffness[9][6] = unit_dc_z * t134;
        stiffness[9][7] = unit_dc_z * t135;
        stiffness[9][8] = t94 + unit_dc_z * t136;
        stiffness[10][0] = t99 + c_x * t140;
        stiffness[10][1] = c_x * t141;
        stiffness[10][2] = c_x * t142;
        stiffness[10][3] = c_y * t140;
        stiffness[10][4] = t99 + c_y * t141;
        stiffness[10][5] = c_y * t142;
        stiffness[10][6] = c_z * t140;
        stiffness[10][7] = c_z * t141;
        stiffness[10][8] = t99 + c_z * t142;
        stiffness[11][0] = c_x * t146;
        stiffness[11][1] = c_x * t147;
        stiffness[11][2] = c_x * t148;
        stiffness[11][3] = c_y * t146;
        stiffness[11][4] = c_y * t147;
        stiffness[11][5] = c_y * t148;
        stiffness[11][6] = c_z * t146;
        stiffness[11][7] = c_z * t147;
        stiffness[11][8] = c_z * t148;
        stiffness[12][0] = t88 + a_x * t113;
        stiffness[12][1] = a_x * t114;
        stiffness[12][2] = a_x * t115;
        stiffness[12][3] = a_y * t113;
        stiffness[12][4] = t88 + a_y * t114;
        stiffness[12][5] = a_y * t115;
        stiffness[12][6] = a_z * t113;
        stiffness[12][7] = a_z * t114;
        stiffness[12][8] = t88 + a_z * t115;
        stiffness[13][0] = unit_db_x * t137;
        stiffness[13][1] = unit_db_x * t138;
        stiffness[13][2] = unit_db_x * t139;
        stiffness[13][3] = unit_db_y * t137;
        stiffness[13][4] = unit_db_y * t138;
        stiffness[13][5] = unit_db_y * t139;
        stiffness[13][6] = unit_db_z * t137;
        stiffness[13][7] = unit_db_z * t138;
        stiffness[13][8] = unit_db_z * t139;
        stiffness[14][0] = t99 + unit_db_x * t143;
        stiffness[14][1] = unit_db_x * t144;
        stiffness[14][2] = unit_db_x * t145;
        stiffness[14][3] = unit_db_y * t143;
        stiffness[14][4] = t99 + unit_db_y * t144;
        stiffness[14][5] = unit_db_y * t145;
        stiffness[14][6] = unit_db_z * t143;
        stiffness[14][7] = unit_db_z * t144;
        stiffness[14][8] = t99 + unit_db_z * t145;
        stiffness[15][0] = t94 + b_x * t125;
        stiffness[15][1] = b_x * t126;
        stiffness[15][2] = b_x * t127;
        stiffness[15][3] = b_y * t125;
        stiffness[15][4] = t94 + b_y * t126;
        stiffness[15][5] = b_y * t127;
        stiffness[15][6] = b_z * t125;
        stiffness[15][7] = b_z * t126;
        stiffness[15][8] = t94 + b_z * t127;
        stiffness[16][0] = b_x * t131;
        stiffness[16][1] = b_x * t132;
        stiffness[16][2] = b_x * t133;
        stiffness[16][3] = b_y * t131;
        stiffness[16][4] = b_y * t132;
        stiffness[16][5] = b_y * t133;
        stiffness[16][6] = b_z * t131;
        stiffness[16][7] = b_z * t132;
        stiffness[16][8] = b_z * t133;
        stiffness[17][0] = unit_db_x * t140 + unit_dc_x * t149;
        stiffness[17][1] = unit_db_x * t141 + unit_dc_x * t150;
        stiffness[17][2] = unit_db_x * t142 + unit_dc_x * t151;
        stiffness[17][3] = unit_db_y * t140 + unit_dc_y * t149;
        stiffness[17][4] = unit_db_y * t141 + unit_dc_y * t150;
        stiffness[17][5] = unit_db_y * t142 + unit_dc_y * t151;
        stiffness[17][6] = unit_db_z * t140 + unit_dc_z * t149;
        stiffness[17][7] = unit_db_z * t141 + unit_dc_z * t150;
        stiffness[17][8] = unit_db_z * t142 + unit_dc_z * t151;
        stiffness[18][0] = t104 + (unit_db_x * t146 + unit_dc_x * t152);
        stiffness[18][1] = unit_db_x * t147 + unit_dc_x * t153;
        stiffness[18][2] = unit_db_x * t148 + unit_dc_x * t154;
        stiffness[18][3] = unit_db_y * t146 + unit_dc_y * t152;
        stiffness[18][4] = t104 + (unit_db_y * t147 + unit_dc_y * t153);
        stiffness[18][5] = unit_db_y * t148 + unit_dc_y * t154;
        stiffness[18][6] = unit_db_z * t146 + unit_dc_z * t152;
        stiffness[18][7] = unit_db_z * t147 + unit_dc_z * t153;
        stiffness[18][8] = t104 + (unit_db_z * t148 + unit_dc_z * t154);
        stiffness[19][0] = t104 + (b_x * t128 + c_x * t149);
        stiffness[19][1] = b_x * t129 + c_x * t150;
        stiffness[19][2] = b_x * t130 + c_x * t151;
        stiffness[19][3] = b_y * t128 + c_y * t149;
        stiffness[19][4] = t104 + (b_y * t129 + c_y * t150);
        stiffness[19][5] = b_y * t130 + c_y * t151;
        stiffness[19][6] = b_z * t128 + c_z * t149;
        stiffness[19][7] = b_z * t129 + c_z * t150;
        stiffness[19][8] = t104 + (b_z * t130 + c_z * t151);
        stiffness[20][0] = a_x * t116 + b_x * t134 + c_x * t152;
        stiffness[20][1] = a_x * t117 + b_x * t135 + c_x * t153;
        stiffness[20][2] = a_x * t118 + b_x * t136 + c_x * t154;
        stiffness[20][3] = a_y * t116 + b_y * t134 + c_y * t152;
        stiffness[20][4] = a_y * t117 + b_y * t135 + c_y * t153;
        stiffness[20][5] = a_y * t118 + b_y * t136 + c_y * t154;
        stiffness[20][6] = a_z * t116 + b_z * t134 + c_z * t152;
        stiffness[20][7] = a_z * t117 + b_z * t135 + c_z * t153;
        stiffness[20][8] = a_z * t118 + b_z * t136 + c_z * t154;
        damping_matrix[0][0] = unit_db_x * t155 + unit_dc_x * t161;
        damping_matrix[0][1] = unit_db_x * t156 + unit_dc_x * t162;
        damping_matrix[0][2] = unit_db_x * t157 + unit_dc_x * t163;
        damping_matrix[0][3] = unit_db_y * t155 + unit_dc_y * t161;
        damping_matrix[0][4] = unit_db_y * t156 + unit_dc_y * t162;
        damping_matrix[0][5] = unit_db_y * t157 + unit_dc_y * t163;
        damping_matrix[0][6] = unit_db_z * t155 + unit_dc_z * t161;
        damping_matrix[0][7] = unit_db_z * t156 + unit_dc_z * t162;
        damping_matrix[0][8] = unit_db_z * t157 + unit_dc_z * t163;
        damping_matrix[1][0] = unit_db_x * t158;
        damping_matrix[1][1] = unit_db_x * t159;
        damping_matrix[1][2] = unit_db_x * t160;
        damping_matrix[1][3] = unit_db_y * t158;
        damping_matrix[1][4] = unit_db_y * t159;
        damping_matrix[1][5] = unit_db_y * t160;
        damping_matrix[1][6] = unit_db_z * t158;
        damping_matrix[1][7] = unit_db_z * t159;
        damping_matrix[1][8] = unit_db_z * t160;
        damping_matrix[2][0] = unit_dc_x * t164;
        damping_matrix[2][1] = unit_dc_x * t165;
        damping_matrix[2][2] = unit_dc_x * t166;
        damping_matrix[2][3] = unit_dc_y * t164;
        damping_matrix[2][4] = unit_dc_y * t165;
        damping_matrix[2][5] = unit_dc_y * t166;
        damping_matrix[2][6] = unit_dc_z * t164;
        damping_matrix[2][7] = unit_dc_z * t165;
        damping_matrix[2][8] = unit_dc_z * t166;
        damping_matrix[3][0] = unit_db_x * t167 + unit_dc_x * t173;
        damping_matrix[3][1] = unit_db_x * t168 + unit_dc_x * t174;
        damping_matrix[3][2] = unit_db_x * t169 + unit_dc_x * t175;
        damping_matrix[3][3] = unit_db_y * t167 + unit_dc_y * t173;
        damping_matrix[3][4] = unit_db_y * t168 + unit_dc_y * t174;
        damping_matrix[3][5] = unit_db_y * t169 + unit_dc_y * t175;
        damping_matrix[3][6] = unit_db_z * t167 + unit_dc_z * t173;
        damping_matrix[3][7] = unit_db_z * t168 + unit_dc_z * t174;
        damping_matrix[3][8] = unit_db_z * t169 + unit_dc_z * t175;
        damping_matrix[4][0] = unit_db_x * t170 + unit_dc_x * t179;
        damping_matrix[4][1] = unit_db_x * t171 + unit_dc_x * t180;
        damping_matrix[4][2] = unit_db_x * t172 + unit_dc_x * t181;
        damping_matrix[4][3] = unit_db_y * t170 + unit_dc_y * t179;
        damping_matrix[4][4] = unit_db_y * t171 + unit_dc_y * t180;
        damping_matrix[4][5] = unit_db_y * t172 + unit_dc_y * t181;
        damping_matrix[4][6] = unit_db_z * t170 + unit_dc_z * t179;
        damping_matrix[4][7] = unit_db_z * t171 + unit_dc_z * t180;
        damping_matrix[4][8] = unit_db_z * t172 + unit_dc_z * t181;
        damping_matrix[5][0] = b_x * t167 + c_x * t185;
        damping_matrix[5][1] = b_x * t168 + c_x * t186;
        damping_matrix[5][2] = b_x * t169 + c_x * t187;
        damping_matrix[5][3] = b_y * t167 + c_y * t185;
        damping_matrix[5][4] = b_y * t168 + c_y * t186;
        damping_matrix[5][5] = b_y * t169 + c_y * t187;
        damping_matrix[5][6] = b_z * t167 + c_z * t185;
        damping_matrix[5][7] = b_z * t168 + c_z * t186;
        damping_matrix[5][8] = b_z * t169 + c_z * t187;
        damping_matrix[6][0] = a_x * t158 + b_x * t170 + c_x * t191;
        damping_matrix[6][1] = a_x * t159 + b_x * t171 + c_x * t192;
        damping_matrix[6][2] = a_x * t160 + b_x * t172 + c_x * t193;
        damping_matrix[6][3] = a_y * t158 + b_y * t170 + c_y * t191;
        damping_matrix[6][4] = a_y * t159 + b_y * t171 + c_y * t192;
        damping_matrix[6][5] = a_y * t160 + b_y * t172 + c_y * t193;
        damping_matrix[6][6] = a_z * t158 + b_z * t170 + c_z * t191;
        damping_matrix[6][7] = a_z * t159 + b_z * t171 + c_z * t192;
        damping_matrix[6][8] = a_z * t160 + b_z * t172 + c_z * t193;
        damping_matrix[7][0] = unit_dc_x * t176;
        damping_matrix[7][1] = unit_dc_x * t177;
        damping_matrix[7][2] = unit_dc_x * t178;
        damping_matrix[7][3] = unit_dc_y * t176;
        damping_matrix[7][4] = unit_dc_y * t177;
        damping_matrix[7][5] = unit_dc_y * t178;
        damping_matrix[7][6] = unit_dc_z * t176;
        damping_matrix[7][7] = unit_dc_z * t177;
        damping_matrix[7][8] = unit_dc_z * t178;
        damping_matrix[8][0] = unit_dc_x * t182;
        damping_matrix[8][1] = unit_dc_x * t183;
        damping_matrix[8][2] = unit_dc_x * t184;
        damping_matrix[8][3] = unit_dc_y * t182;
        damping_matrix[8][4] = unit_dc_y * t183;
        damping_matrix[8][5] = unit_dc_y * t184;
        damping_matrix[8][6] = unit_dc_z * t182;
        damping_matrix[8][7] = unit_dc_z * t183;
        damping_matrix[8][8] = unit_dc_z * t184;
        damping_matrix[9][0] = c_x * t188;
        damping_matrix[9][1] = c_x * t189;
        damping_matrix[9][2] = c_x * t190;
        damping_matrix[9][3] = c_y * t188;
        damping_matrix[9][4] = c_y * t189;
        damping_matrix[9][5] = c_y * t190;
        damping_matrix[9][6] = c_z * t188;
        damping_matrix[9][7] = c_z * t189;
        damping_matrix[9][8] = c_z * t190;
        damping_matrix[10][0] = c_x * t194;
        damping_matrix[10][1] = c_x * t195;
        damping_matrix[10][2] = c_x * t196;
        damping_matrix[10][3] = c_y * t194;
        damping_matrix[10][4] = c_y * t195;
        damping_matrix[10][5] = c_y * t196;
        damping_matrix[10][6] = c_z * t194;
        damping_matrix[10][7] = c_z * t195;
        damping_matrix[10][8] = c_z * t196;
        damping_matrix[11][0] = unit_db_x * t188 + unit_dc_x * t197;
        damping_matrix[11][1] = unit_db_x * t189 + unit_dc_x * t198;
        damping_matrix[11][2] = unit_db_x * t190 + unit_dc_x * t199;
        damping_matrix[11][3] = unit_db_y * t188 + unit_dc_y * t197;
        damping_matrix[11][4] = unit_db_y * t189 + unit_dc_y * t198;
        damping_matrix[11][5] = unit_db_y * t190 + unit_dc_y * t199;
        damping_matrix[11][6] = unit_db_z * t188 + unit_dc_z * t197;
        damping_matrix[11][7] = unit_db_z * t189 + unit_dc_z * t198;
        damping_matrix[11][8] = unit_db_z * t190 + unit_dc_z * t199;
        damping_matrix[12][0] = unit_db_x * t194 + unit_dc_x * t200;
        damping_matrix[12][1] = unit_db_x * t195 + unit_dc_x * t201;
        damping_matrix[12][2] = unit_db_x * t196 + unit_dc_x * t202;
        damping_matrix[12][3] = unit_db_y * t194 + unit_dc_y * t200;
        damping_matrix[12][4] = unit_db_y * t195 + unit_dc_y * t201;
        damping_matrix[12][5] = unit_db_y * t196 + unit_dc_y * t202;
        damping_matrix[12][6] = unit_db_z * t194 + unit_dc_z * t200;
        damping_matrix[12][7] = unit_db_z * t195 + unit_dc_z * t201;
        damping_matrix[12][8] = unit_db_z * t196 + unit_dc_z * t202;
        damping_matrix[13][0] = b_x * t176 + c_x * t197;
        damping_matrix[13][1] = b_x * t177 + c_x * t198;
        damping_matrix[13][2] = b_x * t178 + c_x * t199;
        damping_matrix[13][3] = b_y * t176 + c_y * t197;
        damping_matrix[13][4] = b_y * t177 + c_y * t198;
        damping_matrix[13][5] = b_y * t178 + c_y * t199;
        damping_matrix[13][6] = b_z * t176 + c_z * t197;
        damping_matrix[13][7] = b_z * t177 + c_z * t198;
        damping_matrix[13][8] = b_z * t178 + c_z * t199;
        damping_matrix[14][0] = a_x * t164 + b_x * t182 + c_x * t200;
        damping_matrix[14][1] = a_x * t165 + b_x * t183 + c_x * t201;
        damping_matrix[14][2] = a_x * t166 + b_x * t184 + c_x * t202;
        damping_matrix[14][3] = a_y * t164 + b_y * t182 + c_y * t200;
        damping_matrix[14][4] = a_y * t165 + b_y * t183 + c_y * t201;
        damping_matrix[14][5] = a_y * t166 + b_y * t184 + c_y * t202;
        damping_matrix[14][6] = a_z * t164 + b_z * t182 + c_z * t200;
        damping_matrix[14][7] = a_z * t165 + b_z * t183 + c_z * t201;
        damping_matrix[14][8] = a_z * t166 + b_z * t184 + c_z * t202;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 19 additions, 49 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_energy(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatialDamped {
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
            damping,
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
    /// Operations: 852 additions, 1091 multiplications, 2 divisions.
    pub fn beam_spatial_damped_elastic_force(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        v: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        let rates = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, v);
        let mut sums = Default::default();
        BEAM_SPATIAL_DAMPED_POINTS3
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| beam_spatial_damped_points3_force(
                    row,
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_DAMPED_POINTS2
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| beam_spatial_damped_points2_force(
                    row,
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_DAMPED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 11074 additions, 12599 multiplications, 2 divisions.
    pub fn beam_spatial_damped_elastic_tangent(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        v: &[f64; 30],
        stiffness: &mut [f64; 900],
        damping_matrix: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        let rates = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, v);
        let mut tiles = [[[0.0; 9]; 9]; 9];
        let mut viscous = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_DAMPED_POINTS3
            .damped_tangent(
                (&vectors, &rates),
                (&BEAM_SPATIAL_DAMPED_POINTS3_STIFFNESS, &mut tiles),
                (&BEAM_SPATIAL_DAMPED_POINTS3_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| beam_spatial_damped_points3_tangent(
                    row,
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        BEAM_SPATIAL_DAMPED_POINTS2
            .damped_tangent(
                (&vectors, &rates),
                (&BEAM_SPATIAL_DAMPED_POINTS2_STIFFNESS, &mut tiles),
                (&BEAM_SPATIAL_DAMPED_POINTS2_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| beam_spatial_damped_points2_tangent(
                    row,
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        BEAM_SPATIAL_DAMPED_VECTORS.add_general(row.length, &tiles, stiffness);
        BEAM_SPATIAL_DAMPED_VECTORS.add_symmetric(row.length, &viscous, damping_matrix);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 274 additions, 397 multiplications, 2 divisions.
    pub fn beam_spatial_damped_strain_energy(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_DAMPED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_damped_points3_energy(row, fields, &mut density);
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_DAMPED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_damped_points2_energy(row, fields, &mut density);
                        density
                    },
                );
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_damped_mass(row: &BeamSpatialDamped, mass: &mut [f64; 100]) {
        let BeamSpatialDamped { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let mass_r0_r0 = element_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[0][0];
        let t20 = length * element_mass;
        let mass_r0_r0x = t20 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[0][6];
        let mass_r0_r1x = t20 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[0][7];
        let t24 = element_mass * (length * length);
        let mass_r0x_r0x = t24 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[1][1];
        let mass_r0x_r1 = t20 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[1][6];
        let mass_r0x_r1x = t24 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[1][7];
        let mass_r0y_r0y = section_y_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][2];
        let mass_r0y_ry_half = section_y_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][4];
        let mass_r0y_r1y = section_y_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][8];
        let mass_r0z_r0z = section_z_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][2];
        let mass_r0z_rz_half = section_z_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][4];
        let mass_r0z_r1z = section_z_mass * BEAM_SPATIAL_DAMPED_MASS_MATRIX[2][8];
        let mass_ry_half_ry_half = section_y_mass
            * BEAM_SPATIAL_DAMPED_MASS_MATRIX[4][4];
        let mass_rz_half_rz_half = section_z_mass
            * BEAM_SPATIAL_DAMPED_MASS_MATRIX[4][4];
        let mass_r1_r1x = t20 * BEAM_SPATIAL_DAMPED_MASS_MATRIX[6][7];
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
    pub fn beam_spatial_damped_shapes_position_0(
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
    pub fn beam_spatial_damped_shapes_position_1(
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
    pub fn beam_spatial_damped_shapes_section_y_0(
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
    pub fn beam_spatial_damped_shapes_section_y_1(
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
    pub fn beam_spatial_damped_shapes_section_z_0(
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
    pub fn beam_spatial_damped_shapes_section_z_1(
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
    /// Operations: 195 additions, 276 multiplications.
    pub fn beam_spatial_damped_field_forces(
        row: &BeamSpatialDamped,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        rates: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatialDamped {
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
            damping,
            ..
        } = *row;
        let t68 = fields[3] * fields[12] + fields[4] * fields[13]
            + fields[5] * fields[14];
        let t69 = fields[6] * fields[9] + fields[7] * fields[10]
            + fields[8] * fields[11];
        let t70 = 0.5
            * (fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
                - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t71 = fields[0] * 2.0;
        let t72 = fields[1] * 2.0;
        let t73 = fields[2] * 2.0;
        let t74 = EA
            * (t70
                + damping * (0.5 * (rates[0] * t71 + rates[1] * t72 + rates[2] * t73)));
        let t75 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0)
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t76 = fields[3] * 2.0;
        let t77 = fields[4] * 2.0;
        let t78 = fields[5] * 2.0;
        let t79 = EA
            * (t75
                + damping * (0.5 * (rates[3] * t76 + rates[4] * t77 + rates[5] * t78)));
        let t80 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0)
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t81 = fields[6] * 2.0;
        let t82 = fields[7] * 2.0;
        let t83 = fields[8] * 2.0;
        let t84 = EA
            * (t80
                + damping * (0.5 * (rates[6] * t81 + rates[7] * t82 + rates[8] * t83)));
        let t85 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5]
            - (stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
                + stress_free[2] * stress_free[5]);
        let t86 = fields[3] * rates[0] + fields[0] * rates[3]
            + (fields[4] * rates[1] + fields[1] * rates[4])
            + (fields[5] * rates[2] + fields[2] * rates[5]);
        let t87 = kyGA * (t85 + damping * t86);
        let t88 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8]
            - (stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
                + stress_free[2] * stress_free[8]);
        let t89 = fields[6] * rates[0] + fields[0] * rates[6]
            + (fields[7] * rates[1] + fields[1] * rates[7])
            + (fields[8] * rates[2] + fields[2] * rates[8]);
        let t90 = kzGA * (t88 + damping * t89);
        let t91 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t92 = fields[6] * rates[3] + fields[3] * rates[6]
            + (fields[7] * rates[4] + fields[4] * rates[7])
            + (fields[8] * rates[5] + fields[5] * rates[8]);
        let t93 = halfEA * (t91 + damping * t92);
        let t94 = fields[0] * fields[9] + fields[1] * fields[10] + fields[2] * fields[11]
            - (stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11]);
        let t95 = fields[9] * rates[0] + fields[0] * rates[9]
            + (fields[10] * rates[1] + fields[1] * rates[10])
            + (fields[11] * rates[2] + fields[2] * rates[11]);
        let t96 = EIz * (t94 + damping * t95);
        let t97 = fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14]
            - (stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14]);
        let t98 = fields[12] * rates[0] + fields[0] * rates[12]
            + (fields[13] * rates[1] + fields[1] * rates[13])
            + (fields[14] * rates[2] + fields[2] * rates[14]);
        let t99 = EIy * (t97 + damping * t98);
        let t100 = t74 * (0.5 * t71) + fields[3] * t87 + fields[6] * t90
            + fields[9] * t96 + fields[12] * t99;
        let t101 = t74 * (0.5 * t72) + fields[4] * t87 + fields[7] * t90
            + fields[10] * t96 + fields[13] * t99;
        let t102 = t74 * (0.5 * t73) + fields[5] * t87 + fields[8] * t90
            + fields[11] * t96 + fields[14] * t99;
        let t103 = stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
            + stress_free[5] * stress_free[14];
        let t104 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11];
        let t105 = fields[12] * rates[3] + fields[3] * rates[12]
            + (fields[13] * rates[4] + fields[4] * rates[13])
            + (fields[14] * rates[5] + fields[5] * rates[14]);
        let t106 = fields[9] * rates[6] + fields[6] * rates[9]
            + (fields[10] * rates[7] + fields[7] * rates[10])
            + (fields[11] * rates[8] + fields[8] * rates[11]);
        let t107 = 0.5 * (t69 - t68) - 0.5 * (t104 - t103)
            + damping * (0.5 * (t106 - t105));
        let t108 = GJ * t107;
        let t109 = t79 * (0.5 * t76) + fields[0] * t87 + fields[6] * t93
            - t108 * (fields[12] * 0.5);
        let t110 = t79 * (0.5 * t77) + fields[1] * t87 + fields[7] * t93
            - t108 * (fields[13] * 0.5);
        let t111 = t79 * (0.5 * t78) + fields[2] * t87 + fields[8] * t93
            - t108 * (fields[14] * 0.5);
        let t112 = t84 * (0.5 * t81) + fields[0] * t90 + fields[3] * t93
            + t108 * (fields[9] * 0.5);
        let t113 = t84 * (0.5 * t82) + fields[1] * t90 + fields[4] * t93
            + t108 * (fields[10] * 0.5);
        let t114 = t84 * (0.5 * t83) + fields[2] * t90 + fields[5] * t93
            + t108 * (fields[11] * 0.5);
        let t115 = fields[3] * fields[9] + fields[4] * fields[10]
            + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t116 = fields[9] * rates[3] + fields[3] * rates[9]
            + (fields[10] * rates[4] + fields[4] * rates[10])
            + (fields[11] * rates[5] + fields[5] * rates[11]);
        let t117 = GIz * (t115 + damping * t116);
        let t118 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t119 = fields[12] * rates[6] + fields[6] * rates[12]
            + (fields[13] * rates[7] + fields[7] * rates[13])
            + (fields[14] * rates[8] + fields[8] * rates[14]);
        let t120 = GIy * (t118 + damping * t119);
        let t121 = GIyz * (t68 + t69 - (t103 + t104) + damping * (t105 + t106));
        forces[0] = t100;
        forces[1] = t101;
        forces[2] = t102;
        forces[3] = t109 + fields[9] * t117 + fields[12] * t121;
        forces[4] = t110 + fields[10] * t117 + fields[13] * t121;
        forces[5] = t111 + fields[11] * t117 + fields[14] * t121;
        forces[6] = t112 + fields[12] * t120 + fields[9] * t121;
        forces[7] = t113 + fields[13] * t120 + fields[10] * t121;
        forces[8] = t114 + fields[14] * t120 + fields[11] * t121;
        forces[9] = fields[0] * t96 + t108 * (fields[6] * 0.5) + fields[3] * t117
            + fields[6] * t121;
        forces[10] = fields[1] * t96 + t108 * (fields[7] * 0.5) + fields[4] * t117
            + fields[7] * t121;
        forces[11] = fields[2] * t96 + t108 * (fields[8] * 0.5) + fields[5] * t117
            + fields[8] * t121;
        forces[12] = fields[0] * t99 - t108 * (fields[3] * 0.5) + fields[6] * t120
            + fields[3] * t121;
        forces[13] = fields[1] * t99 - t108 * (fields[4] * 0.5) + fields[7] * t120
            + fields[4] * t121;
        forces[14] = fields[2] * t99 - t108 * (fields[5] * 0.5) + fields[8] * t120
            + fields[5] * t121;
    }
    /// Motion of frame `rotor` and its first two derivatives.
    ///
    /// Operations: 8 additions, 13 multiplications, 6 divisions, 4 function calls.
    pub fn frame_rotor(
        model: &Motor,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let t15 = model.speed / model.T_s;
        let t16 = (model.T_s / 6.283185307179586).powi(2);
        let t17 = t * 6.283185307179586 / model.T_s;
        let t18 = t17.cos();
        let theta = (if t <= model.T_s {
            t15 * (t * t / 2.0 + t16 * (t18 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t20 = theta.cos();
        let t21 = theta.sin();
        let t22 = 6.283185307179586 / model.T_s;
        let theta_t = (if t <= model.T_s {
            t15 * (t - t16 * (t22 * t17.sin()))
        } else {
            model.speed
        });
        let theta_t_t = (if t <= model.T_s {
            t15 * (1.0 - t16 * (t22 * (t18 * t22)))
        } else {
            0.0
        });
        motion.spin[0] = theta_t;
        motion.spin_rate[0] = theta_t_t;
        motion.rotation[(1, 1)] = t20;
        motion.rotation[(1, 2)] = -t21;
        motion.rotation[(2, 1)] = t21;
        motion.rotation[(2, 2)] = t20;
    }
    /// Joint `drive_end`: conditions, position level.
    ///
    /// Operations: 15 additions, 19 multiplications.
    pub fn joint_drive_end_referenced_position(
        model: &Motor,
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
    /// Joint `drive_end`: derivatives of the conditions.
    ///
    /// Operations: 3 additions, 12 multiplications.
    pub fn joint_drive_end_referenced_jacobian(
        model: &Motor,
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
    /// Joint `drive_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_prescribed(
        model: &Motor,
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
    /// Joint `drive_end`: conditions, position level.
    ///
    /// Operations: 25 additions, 37 multiplications, 5 divisions, 3 function calls.
    pub fn joint_drive_end_absolute_position(
        model: &Motor,
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
            model.speed / model.T_s * t33
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t35 = theta.cos();
        let t36 = theta.sin();
        let t37 = t35 * data.tangent[1] - t36 * data.tangent[2];
        let t38 = t36 * data.tangent[1] + t35 * data.tangent[2];
        let t39 = t35 * data.second[1] - t36 * data.second[2];
        let t40 = t36 * data.second[1] + t35 * data.second[2];
        let t41 = t37 * t40 - t38 * t39;
        let t42 = data.second[0] * t38 - data.tangent[0] * t40;
        let t43 = data.tangent[0] * t39 - data.second[0] * t37;
        let t44 = data.second[0] * q[3] + q[4] * t39 + q[5] * t40
            - (data.tangent[0] * q[6] + q[7] * t37 + q[8] * t38);
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t35 * data.point[1] - t36 * data.point[2]);
        rows[2] = q[2] - (t36 * data.point[1] + t35 * data.point[2]);
        rows[3] = q[3] * t41 + q[4] * t42 + q[5] * t43;
        rows[4] = q[6] * t41 + q[7] * t42 + q[8] * t43;
        rows[5] = 0.5 * t44;
    }
    /// Joint `drive_end`: conditions, velocity level.
    ///
    /// Operations: 28 additions, 50 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_velocity(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t29 = model.speed / model.T_s;
        let t30 = (model.T_s / 6.283185307179586).powi(2);
        let t31 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t29 * (t * t / 2.0 + t30 * (t31.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t33 = theta.cos();
        let t34 = theta.sin();
        let t35 = (if t <= model.T_s {
            t29 * (t - t30 * (6.283185307179586 / model.T_s * t31.sin()))
        } else {
            model.speed
        });
        let t36 = t34 * t35;
        let t37 = t33 * t35;
        let t38 = data.tangent[1] * t36 + data.tangent[2] * t37;
        let t39 = data.tangent[1] * t37 - data.tangent[2] * t36;
        let t40 = data.second[1] * t36 + data.second[2] * t37;
        let t41 = data.second[1] * t37 - data.second[2] * t36;
        let t42 = (t33 * data.tangent[1] - t34 * data.tangent[2]) * t41
            - (t34 * data.second[1] + t33 * data.second[2]) * t38;
        let t43 = (t33 * data.second[1] - t34 * data.second[2]) * t39
            - (t34 * data.tangent[1] + t33 * data.tangent[2]) * t40;
        let t44 = t42 - t43;
        let t45 = data.second[0] * t39 - data.tangent[0] * t41;
        let t46 = data.second[0] * t38 - data.tangent[0] * t40;
        rows[1] = data.point[1] * t36 + data.point[2] * t37;
        rows[2] = data.point[2] * t36 - data.point[1] * t37;
        rows[3] = q[5] * t46 + (q[3] * t44 + q[4] * t45);
        rows[4] = q[8] * t46 + (q[6] * t44 + q[7] * t45);
        rows[5] = 0.5 * (q[5] * t41 - q[4] * t40 - (q[8] * t39 - q[7] * t38));
    }
    /// Joint `drive_end`: conditions, acceleration level.
    ///
    /// Operations: 65 additions, 86 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_acceleration(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t35 = model.speed / model.T_s;
        let t36 = (model.T_s / 6.283185307179586).powi(2);
        let t37 = t * 6.283185307179586 / model.T_s;
        let t38 = t37.cos();
        let theta = (if t <= model.T_s {
            t35 * (t * t / 2.0 + t36 * (t38 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t40 = theta.cos();
        let t41 = theta.sin();
        let t42 = t40 * data.tangent[1] - t41 * data.tangent[2];
        let t43 = t41 * data.tangent[1] + t40 * data.tangent[2];
        let t44 = t40 * data.second[1] - t41 * data.second[2];
        let t45 = t41 * data.second[1] + t40 * data.second[2];
        let t46 = 6.283185307179586 / model.T_s;
        let t47 = (if t <= model.T_s {
            t35 * (t - t36 * (t46 * t37.sin()))
        } else {
            model.speed
        });
        let t48 = t41 * t47;
        let t49 = t40 * t47;
        let t50 = data.tangent[1] * t48 + data.tangent[2] * t49;
        let t51 = data.tangent[1] * t49 - data.tangent[2] * t48;
        let t52 = data.second[1] * t48 + data.second[2] * t49;
        let t53 = data.second[1] * t49 - data.second[2] * t48;
        let t54 = t42 * t53 - t45 * t50 - (t44 * t51 - t43 * t52);
        let t55 = data.second[0] * t51 - data.tangent[0] * t53;
        let t56 = data.second[0] * t50 - data.tangent[0] * t52;
        let t57 = (if t <= model.T_s {
            t35 * (1.0 - t36 * (t46 * (t38 * t46)))
        } else {
            0.0
        });
        let t58 = t47 * t49 + t41 * t57;
        let t59 = t40 * t57 - t47 * t48;
        let t60 = data.tangent[1] * t58 + data.tangent[2] * t59;
        let t61 = data.tangent[1] * t59 - data.tangent[2] * t58;
        let t62 = data.second[1] * t58 + data.second[2] * t59;
        let t63 = data.second[1] * t59 - data.second[2] * t58;
        let t64 = t50 * t53;
        let t65 = t51 * t52;
        let t66 = t42 * t63 - t64 - (t64 + t45 * t60)
            - (t44 * t61 - t65 - (t65 + t43 * t62));
        let t67 = data.second[0] * t61 - data.tangent[0] * t63;
        let t68 = data.second[0] * t60 - data.tangent[0] * t62;
        let t69 = v[3] * t54;
        let t70 = v[4] * t55;
        let t71 = v[5] * t56;
        let t72 = v[6] * t54;
        let t73 = v[7] * t55;
        let t74 = v[8] * t56;
        let t75 = v[4] * t52;
        let t76 = v[5] * t53;
        let t77 = v[7] * t50;
        let t78 = v[8] * t51;
        let t79 = t69 + (t69 + q[3] * t66) + (t70 + (t70 + q[4] * t67))
            + (t71 + (t71 + q[5] * t68));
        let t80 = t72 + (t72 + q[6] * t66) + (t73 + (t73 + q[7] * t67))
            + (t74 + (t74 + q[8] * t68));
        let t81 = t76 + (t76 + q[5] * t63) - (t75 + (t75 + q[4] * t62))
            - (t78 + (t78 + q[8] * t61) - (t77 + (t77 + q[7] * t60)));
        rows[1] = data.point[1] * t58 + data.point[2] * t59;
        rows[2] = data.point[2] * t58 - data.point[1] * t59;
        rows[3] = t79;
        rows[4] = t80;
        rows[5] = 0.5 * t81;
    }
    /// Joint `drive_end`: conditions, jerk level.
    ///
    /// Operations: 121 additions, 126 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_jerk(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t41 = model.speed / model.T_s;
        let t42 = (model.T_s / 6.283185307179586).powi(2);
        let t43 = t * 6.283185307179586 / model.T_s;
        let t44 = t43.cos();
        let theta = (if t <= model.T_s {
            t41 * (t * t / 2.0 + t42 * (t44 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t46 = theta.cos();
        let t47 = theta.sin();
        let t48 = t46 * data.tangent[1] - t47 * data.tangent[2];
        let t49 = t47 * data.tangent[1] + t46 * data.tangent[2];
        let t50 = t46 * data.second[1] - t47 * data.second[2];
        let t51 = t47 * data.second[1] + t46 * data.second[2];
        let t52 = 6.283185307179586 / model.T_s;
        let t53 = t52 * t43.sin();
        let t54 = (if t <= model.T_s { t41 * (t - t42 * t53) } else { model.speed });
        let t55 = t47 * t54;
        let t56 = t46 * t54;
        let t57 = data.tangent[1] * t55 + data.tangent[2] * t56;
        let t58 = data.tangent[1] * t56 - data.tangent[2] * t55;
        let t59 = data.second[1] * t55 + data.second[2] * t56;
        let t60 = data.second[1] * t56 - data.second[2] * t55;
        let t61 = t48 * t60 - t51 * t57 - (t50 * t58 - t49 * t59);
        let t62 = data.second[0] * t58 - data.tangent[0] * t60;
        let t63 = data.second[0] * t57 - data.tangent[0] * t59;
        let t64 = (if t <= model.T_s {
            t41 * (1.0 - t42 * (t52 * (t44 * t52)))
        } else {
            0.0
        });
        let t65 = t54 * t56 + t47 * t64;
        let t66 = t46 * t64 - t54 * t55;
        let t67 = data.tangent[1] * t65 + data.tangent[2] * t66;
        let t68 = data.tangent[1] * t66 - data.tangent[2] * t65;
        let t69 = data.second[1] * t65 + data.second[2] * t66;
        let t70 = data.second[1] * t66 - data.second[2] * t65;
        let t71 = t57 * t60;
        let t72 = t58 * t59;
        let t73 = t48 * t70 - t71 - (t71 + t51 * t67)
            - (t50 * t68 - t72 - (t72 + t49 * t69));
        let t74 = data.second[0] * t68 - data.tangent[0] * t70;
        let t75 = data.second[0] * t67 - data.tangent[0] * t69;
        let t76 = (if t <= model.T_s { t41 * (t42 * (t52 * (t52 * t53))) } else { 0.0 });
        let t77 = t56 * t64;
        let t78 = t77 + t54 * t66 + (t77 + t47 * t76);
        let t79 = t55 * t64;
        let t80 = t46 * t76 - t79 - (t79 + t54 * t65);
        let t81 = data.tangent[1] * t78 + data.tangent[2] * t80;
        let t82 = data.tangent[1] * t80 - data.tangent[2] * t78;
        let t83 = data.second[1] * t78 + data.second[2] * t80;
        let t84 = data.second[1] * t80 - data.second[2] * t78;
        let t85 = t60 * t67;
        let t86 = t57 * t70;
        let t87 = t85 + t86;
        let t88 = t59 * t68;
        let t89 = t58 * t69;
        let t90 = t88 + t89;
        let t91 = t48 * t84 - t86 - t87 - (t87 + (t85 + t51 * t81))
            - (t50 * t82 - t88 - t90 - (t90 + (t89 + t49 * t83)));
        let t92 = data.second[0] * t82 - data.tangent[0] * t84;
        let t93 = data.second[0] * t81 - data.tangent[0] * t83;
        let t94 = a[3] * t61;
        let t95 = v[3] * t73;
        let t96 = t94 + t95;
        let t97 = a[4] * t62;
        let t98 = v[4] * t74;
        let t99 = t97 + t98;
        let t100 = t94 + t96 + (t96 + (t95 + q[3] * t91))
            + (t97 + t99 + (t99 + (t98 + q[4] * t92)));
        let t101 = a[5] * t63;
        let t102 = v[5] * t75;
        let t103 = t101 + t102;
        let t104 = a[6] * t61;
        let t105 = v[6] * t73;
        let t106 = t104 + t105;
        let t107 = a[7] * t62;
        let t108 = v[7] * t74;
        let t109 = t107 + t108;
        let t110 = t104 + t106 + (t106 + (t105 + q[6] * t91))
            + (t107 + t109 + (t109 + (t108 + q[7] * t92)));
        let t111 = a[8] * t63;
        let t112 = v[8] * t75;
        let t113 = t111 + t112;
        let t114 = a[4] * t59;
        let t115 = v[4] * t69;
        let t116 = t114 + t115;
        let t117 = a[5] * t60;
        let t118 = v[5] * t70;
        let t119 = t117 + t118;
        let t120 = t117 + t119 + (t119 + (t118 + q[5] * t84))
            - (t114 + t116 + (t116 + (t115 + q[4] * t83)));
        let t121 = a[7] * t57;
        let t122 = v[7] * t67;
        let t123 = t121 + t122;
        let t124 = a[8] * t58;
        let t125 = v[8] * t68;
        let t126 = t124 + t125;
        let t127 = t124 + t126 + (t126 + (t125 + q[8] * t82))
            - (t121 + t123 + (t123 + (t122 + q[7] * t81)));
        rows[1] = data.point[1] * t78 + data.point[2] * t80;
        rows[2] = data.point[2] * t78 - data.point[1] * t80;
        rows[3] = t100 + (t101 + t103 + (t103 + (t102 + q[5] * t93)));
        rows[4] = t110 + (t111 + t113 + (t113 + (t112 + q[8] * t93)));
        rows[5] = 0.5 * (t120 - t127);
    }
    /// Joint `drive_end`: derivatives of the conditions.
    ///
    /// Operations: 12 additions, 26 multiplications, 5 divisions, 3 function calls.
    pub fn joint_drive_end_absolute_jacobian(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let t21 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t21
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = t23 * data.tangent[1];
        let t26 = t24 * data.tangent[2];
        let t27 = t25 - t26;
        let t28 = t24 * data.tangent[1] + t23 * data.tangent[2];
        let t29 = t23 * data.second[1] - t24 * data.second[2];
        let t30 = t24 * data.second[1] + t23 * data.second[2];
        let t31 = t27 * t30 - t28 * t29;
        let t32 = data.second[0] * t28 - data.tangent[0] * t30;
        let t33 = data.tangent[0] * t29 - data.second[0] * t27;
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = t31;
        jacobian[31] = t32;
        jacobian[32] = t33;
        jacobian[42] = t31;
        jacobian[43] = t32;
        jacobian[44] = t33;
        jacobian[48] = data.second[0] * 0.5;
        jacobian[49] = t29 * 0.5;
        jacobian[50] = t30 * 0.5;
        jacobian[51] = -data.tangent[0] * 0.5;
        jacobian[52] = 0.5 * (t26 - t25);
        jacobian[53] = -t28 * 0.5;
    }
    /// Joint `drive_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 28 additions, 55 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_prescribed(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let t24 = model.speed / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.speed
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
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t29 * data.point[1] - t30 * data.point[2];
        prescribed.position[0][2] = t30 * data.point[1] + t29 * data.point[2];
        prescribed.position[1][1] = -(data.point[1] * t33 + data.point[2] * t34);
        prescribed.position[1][2] = data.point[1] * t34 - data.point[2] * t33;
        prescribed.position[2][1] = -(data.point[1] * t36 + data.point[2] * t37);
        prescribed.position[2][2] = data.point[1] * t37 - data.point[2] * t36;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t29 * data.tangent[1] - t30 * data.tangent[2];
        prescribed.slope[0][2] = t30 * data.tangent[1] + t29 * data.tangent[2];
        prescribed.slope[1][1] = -(data.tangent[1] * t33 + data.tangent[2] * t34);
        prescribed.slope[1][2] = data.tangent[1] * t34 - data.tangent[2] * t33;
        prescribed.slope[2][1] = -(data.tangent[1] * t36 + data.tangent[2] * t37);
        prescribed.slope[2][2] = data.tangent[1] * t37 - data.tangent[2] * t36;
        prescribed.second[0][0] = data.second[0];
        prescribed.second[0][1] = t29 * data.second[1] - t30 * data.second[2];
        prescribed.second[0][2] = t30 * data.second[1] + t29 * data.second[2];
        prescribed.second[1][1] = -(data.second[1] * t33 + data.second[2] * t34);
        prescribed.second[1][2] = data.second[1] * t34 - data.second[2] * t33;
        prescribed.second[2][1] = -(data.second[1] * t36 + data.second[2] * t37);
        prescribed.second[2][2] = data.second[1] * t37 - data.second[2] * t36;
    }
    /// Joint `far_end`: conditions, position level.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn joint_far_end_referenced_position(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - data.point[1];
        rows[2] = q[2] - data.point[2];
    }
    /// Joint `far_end`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_jacobian(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
    }
    /// Joint `far_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_prescribed(
        model: &Motor,
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
    /// Joint `far_end`: conditions, position level.
    ///
    /// Operations: 9 additions, 10 multiplications, 5 divisions, 3 function calls.
    pub fn joint_far_end_absolute_position(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t21 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t21
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t23 * data.point[1] - t24 * data.point[2]);
        rows[2] = q[2] - (t24 * data.point[1] + t23 * data.point[2]);
    }
    /// Joint `far_end`: conditions, velocity level.
    ///
    /// Operations: 8 additions, 15 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_velocity(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t19.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t21 = (if t <= model.T_s {
            t17 * (t - t18 * (6.283185307179586 / model.T_s * t19.sin()))
        } else {
            model.speed
        });
        let t22 = theta.sin() * t21;
        let t23 = theta.cos() * t21;
        rows[1] = data.point[1] * t22 + data.point[2] * t23;
        rows[2] = data.point[2] * t22 - data.point[1] * t23;
    }
    /// Joint `far_end`: conditions, acceleration level.
    ///
    /// Operations: 12 additions, 23 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_acceleration(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let t20 = t19.cos();
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t20 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t22 = theta.cos();
        let t23 = theta.sin();
        let t24 = 6.283185307179586 / model.T_s;
        let t25 = (if t <= model.T_s {
            t17 * (t - t18 * (t24 * t19.sin()))
        } else {
            model.speed
        });
        let t26 = (if t <= model.T_s {
            t17 * (1.0 - t18 * (t24 * (t20 * t24)))
        } else {
            0.0
        });
        let t27 = t25 * (t22 * t25) + t23 * t26;
        let t28 = t22 * t26 - t25 * (t23 * t25);
        rows[1] = data.point[1] * t27 + data.point[2] * t28;
        rows[2] = data.point[2] * t27 - data.point[1] * t28;
    }
    /// Joint `far_end`: conditions, jerk level.
    ///
    /// Operations: 19 additions, 33 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_jerk(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let t20 = t19.cos();
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t20 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t22 = theta.cos();
        let t23 = theta.sin();
        let t24 = 6.283185307179586 / model.T_s;
        let t25 = t24 * t19.sin();
        let t26 = (if t <= model.T_s { t17 * (t - t18 * t25) } else { model.speed });
        let t27 = t23 * t26;
        let t28 = t22 * t26;
        let t29 = (if t <= model.T_s {
            t17 * (1.0 - t18 * (t24 * (t20 * t24)))
        } else {
            0.0
        });
        let t30 = (if t <= model.T_s { t17 * (t18 * (t24 * (t24 * t25))) } else { 0.0 });
        let t31 = t28 * t29;
        let t32 = t31 + t26 * (t22 * t29 - t26 * t27) + (t31 + t23 * t30);
        let t33 = t27 * t29;
        let t34 = t22 * t30 - t33 - (t33 + t26 * (t26 * t28 + t23 * t29));
        rows[1] = data.point[1] * t32 + data.point[2] * t34;
        rows[2] = data.point[2] * t32 - data.point[1] * t34;
    }
    /// Joint `far_end`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_absolute_jacobian(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
    }
    /// Joint `far_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 28 additions, 55 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_prescribed(
        model: &Motor,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let t24 = model.speed / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.speed
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
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t29 * data.point[1] - t30 * data.point[2];
        prescribed.position[0][2] = t30 * data.point[1] + t29 * data.point[2];
        prescribed.position[1][1] = -(data.point[1] * t33 + data.point[2] * t34);
        prescribed.position[1][2] = data.point[1] * t34 - data.point[2] * t33;
        prescribed.position[2][1] = -(data.point[1] * t36 + data.point[2] * t37);
        prescribed.position[2][2] = data.point[1] * t37 - data.point[2] * t36;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t29 * data.tangent[1] - t30 * data.tangent[2];
        prescribed.slope[0][2] = t30 * data.tangent[1] + t29 * data.tangent[2];
        prescribed.slope[1][1] = -(data.tangent[1] * t33 + data.tangent[2] * t34);
        prescribed.slope[1][2] = data.tangent[1] * t34 - data.tangent[2] * t33;
        prescribed.slope[2][1] = -(data.tangent[1] * t36 + data.tangent[2] * t37);
        prescribed.slope[2][2] = data.tangent[1] * t37 - data.tangent[2] * t36;
        prescribed.second[0][0] = data.second[0];
        prescribed.second[0][1] = t29 * data.second[1] - t30 * data.second[2];
        prescribed.second[0][2] = t30 * data.second[1] + t29 * data.second[2];
        prescribed.second[1][1] = -(data.second[1] * t33 + data.second[2] * t34);
        prescribed.second[1][2] = data.second[1] * t34 - data.second[2] * t33;
        prescribed.second[2][1] = -(data.second[1] * t36 + data.second[2] * t37);
        prescribed.second[2][2] = data.second[1] * t37 - data.second[2] * t36;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &Motor, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &Motor, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &Motor, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.2;
        run.every = 0.001;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: Motor,
        pub row_shaft: BeamSpatialDamped,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &Motor) -> Self {
            Self {
                model: model.clone(),
                row_shaft: Default::default(),
            }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.51),
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.51),
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Section {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::SectionQuantity::MomentZ,
                },
                ::rncf::emitted::ObservedSpec::Section {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::SectionQuantity::Stress,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            4
        }
        fn frame_count(&self) -> usize {
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "rotor"][frame]
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
            frame_rotor(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("body `shaft` is damped")
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
                    name: "shaft",
                    kind: 0,
                    instance: None,
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [1.02, 0.0, 0.0],
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
                    damps: true,
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
                7800.0,
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
            let damping = ::rncf::emitted::non_negative(
                "material `steel`",
                "damping",
                model.damping,
                "s",
            )?;
            let yield_stress = ::rncf::emitted::positive(
                "material `steel`",
                "yield",
                355000000.0,
                "Pa",
            )?;
            let area = ::rncf::emitted::positive(
                "section `round`",
                "area",
                0.007853981633974483,
                "m^2",
            )?;
            let second_moment_y = ::rncf::emitted::positive(
                "section `round`",
                "second_moment_y",
                4.908738521234054e-6,
                "m^4",
            )?;
            let second_moment_z = ::rncf::emitted::positive(
                "section `round`",
                "second_moment_z",
                4.908738521234054e-6,
                "m^4",
            )?;
            let torsion_constant = ::rncf::emitted::positive(
                "section `round`",
                "torsion_constant",
                9.817477042468108e-6,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::emitted::part(
                "section `round`",
                "shear_factor_y",
                0.8863636363636362,
                "1",
            )?;
            let shear_factor_z = ::rncf::emitted::part(
                "section `round`",
                "shear_factor_z",
                0.8863636363636362,
                "1",
            )?;
            let radius = ::rncf::emitted::positive(
                "section `round`",
                "radius",
                0.05,
                "m",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            let half_young = 0.5 * young;
            let quarter_polar_moment = 0.25 * (second_moment_y + second_moment_z);
            self.row_shaft = BeamSpatialDamped {
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
                damping: damping,
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
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::FixtureSpec {
                    name: "disc",
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.51),
                    constants: [
                        2.450442269800039,
                        0.0,
                        model.eccentricity * 2.450442269800039,
                        0.0,
                        2.0420352248333093e-5,
                        0.006126105674500098
                            + model.eccentricity
                                * (model.eccentricity * 2.450442269800039),
                        0.006126105674500098,
                        0.0,
                        0.0,
                        0.0,
                    ],
                    elastic: true,
                },
            ])
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
            beam_spatial_damped_mass(&self.row_shaft, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_spatial_damped_elastic_force(
                &self.row_shaft,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array(v),
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
            beam_spatial_damped_elastic_tangent(
                &self.row_shaft,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array(v),
                ::rncf::emitted::array_mut(stiffness),
                ::rncf::emitted::array_mut(damping),
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
            beam_spatial_damped_strain_energy(
                &self.row_shaft,
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
                    beam_spatial_damped_shapes_position_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    beam_spatial_damped_shapes_position_1(
                        self.row_shaft.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    beam_spatial_damped_shapes_section_y_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    beam_spatial_damped_shapes_section_y_1(
                        self.row_shaft.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 0) => {
                    beam_spatial_damped_shapes_section_z_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 1) => {
                    beam_spatial_damped_shapes_section_z_1(
                        self.row_shaft.length,
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
                    radius: 0.05,
                },
                area: 0.007853981633974483,
                second_moments: [4.908738521234054e-6, 4.908738521234054e-6],
                torsion_constant: 9.817477042468108e-6,
                young_over_shear: 2.0 * (1.0 + 0.3),
                softness_of_curves: 2.0,
                yield_stress: Some(355000000.0),
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
            beam_spatial_damped_field_forces(
                &self.row_shaft,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array(rates),
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
                    name: "drive_end",
                    kind: ::rncf::emitted::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 1,
                    point: None,
                },
                ::rncf::emitted::JointSpec {
                    name: "far_end",
                    kind: ::rncf::emitted::JointKind::Pin,
                    body: 0,
                    at_end: true,
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
                            joint_drive_end_referenced_position(
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
                            joint_drive_end_absolute_position(
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
                            joint_drive_end_absolute_velocity(
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
                            joint_drive_end_absolute_acceleration(
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
                            joint_drive_end_absolute_jerk(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                    }
                }
                (1, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_far_end_referenced_position(
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
                (1, _) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_far_end_absolute_position(
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
                            joint_far_end_absolute_velocity(
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
                            joint_far_end_absolute_acceleration(
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
                            joint_far_end_absolute_jerk(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
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
                    joint_drive_end_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (0, _) => {
                    joint_drive_end_absolute_jacobian(&self.model, t, data, jacobian);
                }
                (1, false) => {
                    joint_far_end_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (1, _) => {
                    joint_far_end_absolute_jacobian(&self.model, t, data, jacobian);
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
                    joint_drive_end_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (0, _) => {
                    joint_drive_end_absolute_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (1, false) => {
                    joint_far_end_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (1, _) => {
                    joint_far_end_absolute_prescribed(&self.model, t, data, prescribed);
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
