//! Expansion of `models/src/nrel5mw_blade.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use nrel5mw_blade_equations::Nrel5mwBlade;
#[allow(clippy::all)]
impl Default for Nrel5mwBlade {
    fn default() -> Self {
        Self {
            gravity: 9.8,
            speed: 0.0,
            each: 1,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for Nrel5mwBlade {
    const NAME: &'static str = "Nrel5mwBlade";
    const DOC: &'static str = "Blade of the NREL 5-MW turbine, 61.5 m, clamped at its root: 49 stations with full matrices of stiffness and mass.";
    const SOURCE: &'static str = r#"pub model Nrel5mwBlade {
    /// Gravity along -y, edgewise.
    param gravity = 9.8 [m/s^2];
    /// Speed of the rotor.
    param speed = 0 rpm;
    /// Elements from one station to the next.
    param each: count = 1;

    table sections = file("data/nrel5mw_section.csv");
    table points = file("data/nrel5mw_keypoints.csv");
    section layup = beamdyn(sections, damping = 2 ms);

    // The rotor turns about x, which points downwind.
    frame rotor = rotating(axis = x, angle = speed * t);
    body blade in rotor {
        spatial;
        line from [0, 0, 1.5] m to [0, 0, 63] m;
        section_y [1, 0, 0];
        twist -points.twist;
        mesh each at sections * beam(layup);
    }
    joint hub = clamp(blade.start, rotor);
    load weight = gravity([0 [m/s^2], -gravity, 0 [m/s^2]]);

    /// Displacement of the tip downwind.
    output tip_x = blade.end.x;
    /// Displacement of the tip edgewise.
    output tip_y = blade.end.y;
    /// Mass.
    output mass = blade.mass;

    run { t_end = 2 s; every = 0.05 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x0c17c674326c6a51;
    const NOTES: &'static [&'static str] = &[
        "Body `blade` uses `full_beam_spatial_curved_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2964 and 40649).",
        "Body `blade` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `blade` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `hub`: its conditions are linear in the nodal vectors of `blade` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as body `blade` is damped.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points2_force",
            additions: 187,
            multiplications: 296,
            divisions: 17,
            functions: 1,
            weighted: 571,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points2_tangent",
            additions: 2484,
            multiplications: 3620,
            divisions: 64,
            functions: 1,
            weighted: 6380,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points2_energy",
            additions: 45,
            multiplications: 68,
            divisions: 3,
            functions: 1,
            weighted: 145,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_force",
            additions: 47,
            multiplications: 71,
            divisions: 1,
            functions: 1,
            weighted: 142,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_tangent",
            additions: 271,
            multiplications: 504,
            divisions: 4,
            functions: 1,
            weighted: 811,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_energy",
            additions: 17,
            multiplications: 26,
            divisions: 0,
            functions: 1,
            weighted: 63,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_nodes3_force",
            additions: 31,
            multiplications: 53,
            divisions: 0,
            functions: 0,
            weighted: 84,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_nodes3_tangent",
            additions: 79,
            multiplications: 178,
            divisions: 0,
            functions: 0,
            weighted: 257,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_nodes3_energy",
            additions: 13,
            multiplications: 21,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_reference",
            additions: 245,
            multiplications: 325,
            divisions: 5,
            functions: 5,
            weighted: 690,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_section_z_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_shapes_section_z_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_field_forces",
            additions: 390,
            multiplications: 555,
            divisions: 37,
            functions: 2,
            weighted: 1133,
        },
        ::rncf::model::KernelCount {
            name: "frame_rotor",
            additions: 0,
            multiplications: 1,
            divisions: 0,
            functions: 2,
            weighted: 41,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_referenced_position",
            additions: 15,
            multiplications: 19,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_referenced_jacobian",
            additions: 3,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_position",
            additions: 21,
            multiplications: 32,
            divisions: 0,
            functions: 2,
            weighted: 93,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_velocity",
            additions: 22,
            multiplications: 42,
            divisions: 0,
            functions: 2,
            weighted: 104,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_acceleration",
            additions: 55,
            multiplications: 72,
            divisions: 0,
            functions: 2,
            weighted: 167,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_jerk",
            additions: 104,
            multiplications: 104,
            divisions: 0,
            functions: 2,
            weighted: 248,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_jacobian",
            additions: 8,
            multiplications: 21,
            divisions: 0,
            functions: 2,
            weighted: 69,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_prescribed",
            additions: 18,
            multiplications: 41,
            divisions: 0,
            functions: 2,
            weighted: 99,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "gravity",
                kind: ::rncf::ParamKind::Quantity,
                unit: "m/s^2",
                unit_si: 1.0,
                dimension: [1, 0, -2, 0, 0, 0],
                default: 9.8,
                doc: "Gravity along -y, edgewise.",
            },
            ::rncf::Param {
                name: "speed",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rpm",
                unit_si: 0.10471975511965977,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 0.0,
                doc: "Speed of the rotor.",
            },
            ::rncf::Param {
                name: "each",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 1.0,
                doc: "Elements from one station to the next.",
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
                doc: "Displacement of the tip downwind.",
            },
            ::rncf::Output {
                name: "tip_y",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Displacement of the tip edgewise.",
            },
            ::rncf::Output {
                name: "mass",
                unit: "kg",
                time_exponent: 0.0,
                components: &[],
                doc: "Mass.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.gravity,
            1 => self.speed,
            2 => self.each as f64,
            _ => panic!("Nrel5mwBlade has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.gravity = value,
            1 => self.speed = value,
            2 => self.each = value as usize,
            _ => panic!("Nrel5mwBlade has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        nrel5mw_blade_equations::run_defaults(self, &mut run);
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
        let equations = nrel5mw_blade_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`Nrel5mwBlade`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod nrel5mw_blade_equations {
    /// Blade of the NREL 5-MW turbine, 61.5 m, clamped at its root: 49 stations with full matrices of stiffness and mass.
    ///
    /// # Chosen and left out
    ///
    /// * Body `blade` uses `full_beam_spatial_curved_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2964 and 40649).
    /// * Body `blade` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
    /// * Body `blade` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `hub`: its conditions are linear in the nodal vectors of `blade` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as body `blade` is damped.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct Nrel5mwBlade {
        /// Gravity along -y, edgewise. (SI; declared in m/s^2)
        pub gravity: f64,
        /// Speed of the rotor. (SI; declared in rpm)
        pub speed: f64,
        /// Elements from one station to the next. (count)
        pub each: usize,
    }
    /// Table `sections`: eta, K11, K12, K13, K14, K15, K16, K22, K23, K24, K25, K26, K33, K34, K35, K36, K44, K45, K46, K55, K56, K66, M11, M12, M13, M14, M15, M16, M22, M23, M24, M25, M26, M33, M34, M35, M36, M44, M45, M46, M55, M56, M66.
    pub static TABLE_SECTIONS: ::rncf::emitted::Table = ::rncf::emitted::Table {
        name: "sections",
        places: &[
            0.0,
            0.00325,
            0.01951,
            0.03577,
            0.05203,
            0.06829,
            0.08455,
            0.10081,
            0.11707,
            0.13335,
            0.14959,
            0.16585,
            0.18211,
            0.19837,
            0.21465,
            0.23089,
            0.24715,
            0.26341,
            0.29595,
            0.32846,
            0.36098,
            0.3935,
            0.42602,
            0.45855,
            0.49106,
            0.52358,
            0.5561,
            0.58862,
            0.62115,
            0.65366,
            0.68618,
            0.7187,
            0.75122,
            0.78376,
            0.81626,
            0.84878,
            0.8813,
            0.89756,
            0.91382,
            0.93008,
            0.93821,
            0.94636,
            0.95447,
            0.9626,
            0.97073,
            0.97886,
            0.98699,
            0.99512,
            1.0,
        ],
        is_relative: true,
        between: ::rncf::emitted::Between::Line,
        columns: &[
            &[
                0.0,
                0.00325,
                0.01951,
                0.03577,
                0.05203,
                0.06829,
                0.08455,
                0.10081,
                0.11707,
                0.13335,
                0.14959,
                0.16585,
                0.18211,
                0.19837,
                0.21465,
                0.23089,
                0.24715,
                0.26341,
                0.29595,
                0.32846,
                0.36098,
                0.3935,
                0.42602,
                0.45855,
                0.49106,
                0.52358,
                0.5561,
                0.58862,
                0.62115,
                0.65366,
                0.68618,
                0.7187,
                0.75122,
                0.78376,
                0.81626,
                0.84878,
                0.8813,
                0.89756,
                0.91382,
                0.93008,
                0.93821,
                0.94636,
                0.95447,
                0.9626,
                0.97073,
                0.97886,
                0.98699,
                0.99512,
                1.0,
            ],
            &[
                972948000.0,
                972948000.0,
                1078950000.0,
                1006723000.0,
                986778000.0,
                760786000.0,
                549126000.0,
                497130000.0,
                449395000.0,
                403480000.0,
                403729000.0,
                416972000.0,
                408235000.0,
                408597000.0,
                366834000.0,
                314776000.0,
                301158000.0,
                288262000.0,
                261397000.0,
                235748000.0,
                214686000.0,
                194409000.0,
                163270000.0,
                143240000.0,
                116876000.0,
                104743000.0,
                92295000.0,
                76082000.0,
                64803000.0,
                53970000.0,
                53115000.0,
                46001000.0,
                37575000.0,
                32889000.0,
                24404000.0,
                21160000.0,
                18152000.0,
                16025000.0,
                10923000.0,
                10008000.0,
                9224000.0,
                6323000.0,
                5332000.0,
                4453000.0,
                3690000.0,
                2992000.0,
                2131000.0,
                485000.0,
                353000.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                972948000.0,
                972948000.0,
                1078950000.0,
                1006723000.0,
                986778000.0,
                760786000.0,
                549126000.0,
                497130000.0,
                449395000.0,
                403480000.0,
                403729000.0,
                416972000.0,
                408235000.0,
                408597000.0,
                366834000.0,
                314776000.0,
                301158000.0,
                288262000.0,
                261397000.0,
                235748000.0,
                214686000.0,
                194409000.0,
                163270000.0,
                143240000.0,
                116876000.0,
                104743000.0,
                92295000.0,
                76082000.0,
                64803000.0,
                53970000.0,
                53115000.0,
                46001000.0,
                37575000.0,
                32889000.0,
                24404000.0,
                21160000.0,
                18152000.0,
                16025000.0,
                10923000.0,
                10008000.0,
                9224000.0,
                6323000.0,
                5332000.0,
                4453000.0,
                3690000.0,
                2992000.0,
                2131000.0,
                485000.0,
                353000.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                9729480000.0,
                9729480000.0,
                10789500000.0,
                10067230000.0,
                9867780000.0,
                7607860000.0,
                5491260000.0,
                4971300000.0,
                4493950000.0,
                4034800000.0,
                4037290000.0,
                4169720000.0,
                4082350000.0,
                4085970000.0,
                3668340000.0,
                3147760000.0,
                3011580000.0,
                2882620000.0,
                2613970000.0,
                2357480000.0,
                2146860000.0,
                1944090000.0,
                1632700000.0,
                1432400000.0,
                1168760000.0,
                1047430000.0,
                922950000.0,
                760820000.0,
                648030000.0,
                539700000.0,
                531150000.0,
                460010000.0,
                375750000.0,
                328890000.0,
                244040000.0,
                211600000.0,
                181520000.0,
                160250000.0,
                109230000.0,
                100080000.0,
                92240000.0,
                63230000.0,
                53320000.0,
                44530000.0,
                36900000.0,
                29920000.0,
                21310000.0,
                4850000.0,
                3530000.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                18113600000.0,
                18113600000.0,
                19558600000.0,
                19497800000.0,
                19788800000.0,
                14858500000.0,
                10220600000.0,
                9144700000.0,
                8063160000.0,
                6884440000.0,
                7009180000.0,
                7167680000.0,
                7271660000.0,
                7081700000.0,
                6244530000.0,
                5048960000.0,
                4948490000.0,
                4808020000.0,
                4501400000.0,
                4244070000.0,
                3995280000.0,
                3750760000.0,
                3447140000.0,
                3139070000.0,
                2734240000.0,
                2554870000.0,
                2334030000.0,
                1828730000.0,
                1584100000.0,
                1323360000.0,
                1183680000.0,
                1020160000.0,
                797810000.0,
                709610000.0,
                518190000.0,
                454870000.0,
                395120000.0,
                353720000.0,
                304730000.0,
                281420000.0,
                261710000.0,
                158810000.0,
                137880000.0,
                118790000.0,
                101630000.0,
                85070000.0,
                64260000.0,
                6610000.0,
                5010000.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                18110000000.0,
                18110000000.0,
                19424900000.0,
                17455900000.0,
                15287400000.0,
                10782400000.0,
                7229720000.0,
                6309540000.0,
                5528360000.0,
                4980060000.0,
                4936840000.0,
                4691660000.0,
                3949460000.0,
                3386520000.0,
                2933740000.0,
                2568960000.0,
                2388650000.0,
                2271990000.0,
                2050050000.0,
                1828250000.0,
                1588710000.0,
                1361930000.0,
                1102380000.0,
                875800000.0,
                681300000.0,
                534720000.0,
                408900000.0,
                314540000.0,
                238630000.0,
                175880000.0,
                126010000.0,
                107260000.0,
                90880000.0,
                76310000.0,
                61050000.0,
                49480000.0,
                39360000.0,
                34670000.0,
                30410000.0,
                26520000.0,
                23840000.0,
                19630000.0,
                16000000.0,
                12830000.0,
                10080000.0,
                7550000.0,
                4600000.0,
                250000.0,
                170000.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                5564400000.0,
                5564400000.0,
                5431590000.0,
                4993980000.0,
                4666590000.0,
                3474710000.0,
                2323540000.0,
                1907870000.0,
                1570360000.0,
                1158260000.0,
                1002120000.0,
                855900000.0,
                672270000.0,
                547490000.0,
                448840000.0,
                335920000.0,
                311350000.0,
                291940000.0,
                261000000.0,
                228820000.0,
                200750000.0,
                174380000.0,
                144470000.0,
                119980000.0,
                81190000.0,
                69090000.0,
                57450000.0,
                45920000.0,
                35980000.0,
                27440000.0,
                20900000.0,
                18540000.0,
                16280000.0,
                14530000.0,
                9070000.0,
                8060000.0,
                7080000.0,
                6090000.0,
                5750000.0,
                5330000.0,
                4940000.0,
                4240000.0,
                3660000.0,
                3130000.0,
                2640000.0,
                2170000.0,
                1580000.0,
                250000.0,
                190000.0,
            ],
            &[
                678.935,
                678.935,
                773.363,
                740.55,
                740.042,
                592.496,
                450.275,
                424.054,
                400.638,
                382.062,
                399.655,
                426.321,
                416.82,
                406.186,
                381.42,
                352.822,
                349.477,
                346.538,
                339.333,
                330.004,
                321.99,
                313.82,
                294.734,
                287.12,
                263.343,
                253.207,
                241.666,
                220.638,
                200.293,
                179.404,
                165.094,
                154.411,
                138.935,
                129.555,
                107.264,
                98.776,
                90.248,
                83.001,
                72.906,
                68.772,
                66.264,
                59.34,
                55.914,
                52.484,
                49.114,
                45.818,
                41.669,
                11.453,
                10.319,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                678.935,
                678.935,
                773.363,
                740.55,
                740.042,
                592.496,
                450.275,
                424.054,
                400.638,
                382.062,
                399.655,
                426.321,
                416.82,
                406.186,
                381.42,
                352.822,
                349.477,
                346.538,
                339.333,
                330.004,
                321.99,
                313.82,
                294.734,
                287.12,
                263.343,
                253.207,
                241.666,
                220.638,
                200.293,
                179.404,
                165.094,
                154.411,
                138.935,
                129.555,
                107.264,
                98.776,
                90.248,
                83.001,
                72.906,
                68.772,
                66.264,
                59.34,
                55.914,
                52.484,
                49.114,
                45.818,
                41.669,
                11.453,
                10.319,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                678.935,
                678.935,
                773.363,
                740.55,
                740.042,
                592.496,
                450.275,
                424.054,
                400.638,
                382.062,
                399.655,
                426.321,
                416.82,
                406.186,
                381.42,
                352.822,
                349.477,
                346.538,
                339.333,
                330.004,
                321.99,
                313.82,
                294.734,
                287.12,
                263.343,
                253.207,
                241.666,
                220.638,
                200.293,
                179.404,
                165.094,
                154.411,
                138.935,
                129.555,
                107.264,
                98.776,
                90.248,
                83.001,
                72.906,
                68.772,
                66.264,
                59.34,
                55.914,
                52.484,
                49.114,
                45.818,
                41.669,
                11.453,
                10.319,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                973.04,
                973.04,
                1066.38,
                1047.36,
                1099.75,
                873.02,
                641.49,
                593.73,
                547.18,
                490.84,
                503.86,
                544.7,
                569.9,
                601.28,
                546.56,
                468.71,
                453.76,
                436.22,
                398.18,
                362.08,
                335.01,
                308.57,
                263.87,
                237.06,
                196.41,
                180.34,
                162.43,
                134.83,
                116.3,
                97.98,
                98.93,
                85.78,
                69.96,
                61.41,
                45.44,
                39.57,
                34.09,
                30.12,
                20.15,
                18.53,
                17.11,
                11.55,
                9.77,
                8.19,
                6.82,
                5.57,
                4.01,
                0.94,
                0.68,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                972.86,
                972.86,
                1091.52,
                966.09,
                873.81,
                648.55,
                456.76,
                400.53,
                351.61,
                316.12,
                303.6,
                289.24,
                246.57,
                215.91,
                187.11,
                160.84,
                148.56,
                140.3,
                124.61,
                109.42,
                94.36,
                80.24,
                62.67,
                49.42,
                37.34,
                29.14,
                22.16,
                17.33,
                13.3,
                9.96,
                7.3,
                6.22,
                5.19,
                4.36,
                3.36,
                2.75,
                2.21,
                1.93,
                1.69,
                1.49,
                1.34,
                1.1,
                0.89,
                0.71,
                0.56,
                0.42,
                0.25,
                0.04,
                0.02,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                1945.9,
                1945.9,
                2157.9,
                2013.45,
                1973.56,
                1521.57,
                1098.25,
                994.26,
                898.79,
                806.96,
                807.46,
                833.94,
                816.47,
                817.19,
                733.67,
                629.55,
                602.32,
                576.52,
                522.79,
                471.5,
                429.37,
                388.81,
                326.54,
                286.48,
                233.75,
                209.48,
                184.59,
                152.16,
                129.6,
                107.94,
                106.23,
                92.0,
                75.15,
                65.77,
                48.8,
                42.32,
                36.3,
                32.05,
                21.84,
                20.02,
                18.45,
                12.65,
                10.66,
                8.9,
                7.38,
                5.99,
                4.26,
                0.98,
                0.7,
            ],
        ],
    };
    /// Table `points`: x, y, z, twist, twist_fit.
    pub static TABLE_POINTS: ::rncf::emitted::Table = ::rncf::emitted::Table {
        name: "points",
        places: &[
            0.0,
            0.00325,
            0.01951,
            0.035769999999999996,
            0.05203,
            0.06829,
            0.08455,
            0.10081,
            0.11707,
            0.13335,
            0.14959,
            0.16585000000000003,
            0.18211,
            0.19837,
            0.21465,
            0.23089,
            0.24715,
            0.26341000000000003,
            0.29595000000000005,
            0.32846,
            0.36098,
            0.3935,
            0.42602,
            0.45854999999999996,
            0.49106,
            0.52358,
            0.5561,
            0.58862,
            0.62115,
            0.65366,
            0.6861799999999999,
            0.7187,
            0.75122,
            0.78376,
            0.81626,
            0.84878,
            0.8813,
            0.8975599999999999,
            0.9138200000000001,
            0.93008,
            0.93821,
            0.9463600000000001,
            0.95447,
            0.9626,
            0.97073,
            0.9788600000000001,
            0.98699,
            0.99512,
            1.0,
        ],
        is_relative: true,
        between: ::rncf::emitted::Between::Line,
        columns: &[
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
                0.0,
            ],
            &[
                0.0,
                0.199875,
                1.199865,
                2.199855,
                3.199845,
                4.199835,
                5.199825,
                6.199815,
                7.199805,
                8.201025,
                9.199785,
                10.199775,
                11.199765,
                12.199755,
                13.200975,
                14.199735,
                15.199725,
                16.199715,
                18.200925,
                20.20029,
                22.20027,
                24.20025,
                26.20023,
                28.200825,
                30.20019,
                32.20017,
                34.20015,
                36.20013,
                38.200725,
                40.20009,
                42.20007,
                44.20005,
                46.20003,
                48.20124,
                50.19999,
                52.19997,
                54.19995,
                55.19994,
                56.19993,
                57.19992,
                57.699915,
                58.20114,
                58.699905,
                59.1999,
                59.699895,
                60.19989,
                60.699885,
                61.19988,
                61.5,
            ],
            &[
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23226841685540536,
                0.23005184870537257,
                0.22423990229623147,
                0.21279054240314865,
                0.20177751482306444,
                0.19324285478081216,
                0.18835593287522803,
                0.17858208906405978,
                0.16880824525289156,
                0.1589994948566834,
                0.1489463983651961,
                0.13843951626819023,
                0.12777555453850487,
                0.11712904610133947,
                0.10684905680709285,
                0.09679596031560553,
                0.08676031711663812,
                0.07681194038027044,
                0.0669159235214626,
                0.05815437067645106,
                0.05044001538263613,
                0.04368559117741807,
                0.036931166972200016,
                0.0301941960595019,
                0.023422318561763904,
                0.016650441064025905,
                0.013264502315156905,
                0.01001818990644745,
                0.007051130178057092,
                0.005567600313861911,
                0.0044156830075456534,
                0.0037699111843077517,
                0.0031066860685499066,
                0.0024434609527920616,
                0.001762782544514273,
                0.0010821041362364843,
                0.0004014257279586958,
                0.0,
            ],
            &[
                0.23226859138833056,
                0.23295520391606514,
                0.23571875825367294,
                0.2374337187766826,
                0.23819311153422534,
                0.2380843775218261,
                0.2371876273521514,
                0.235583146170793,
                0.23334196887830708,
                0.23052937078871824,
                0.227220226526937,
                0.22346427797664517,
                0.21931894647023345,
                0.2148381626815884,
                0.2100636399798327,
                0.20505611582293576,
                0.19984159561675233,
                0.1944605709999286,
                0.1833306063599608,
                0.17192400703355182,
                0.16041897113733042,
                0.1489731019027516,
                0.13770263825799822,
                0.1266885634803628,
                0.11600051620699993,
                0.10566345464621311,
                0.09569675195269949,
                0.08610424785081346,
                0.07687634302966904,
                0.06801059402831344,
                0.059486929560348734,
                0.05130046270386932,
                0.04345224065642643,
                0.035951164597205196,
                0.028841740422131494,
                0.022163412572300395,
                0.01599925872010682,
                0.0131430273992181,
                0.010459060075501219,
                0.007966380837802918,
                0.006798406502368312,
                0.005684188307895133,
                0.004634372762820543,
                0.003644596544014559,
                0.0027207937709339603,
                0.0018666296350079354,
                0.0010861183935160714,
                0.00038309977081275534,
                -0.0,
            ],
        ],
    };
    /// Constants of one element `full_beam_spatial_curved_damped`. Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2964 and 40649).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct FullBeamSpatialCurvedDamped {
        /// Length, m.
        pub length: f64,
        /// Damping of the strain measures, s.
        pub damping: f64,
    }
    /// Nodal vectors by what they interpolate: Position, SectionY, SectionZ.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS: ::rncf::emitted::Vectors<
        10,
        3,
        3,
        3,
    > = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2: ::rncf::emitted::Rule<2, 5, 3> = ::rncf::emitted::Rule {
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
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<
        2,
        9,
        25,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 1),
                (0, 3),
                (0, 2),
                (0, 4),
                (1, 0),
                (3, 0),
                (1, 1),
                (1, 3),
                (3, 1),
                (3, 3),
                (1, 2),
                (1, 4),
                (3, 2),
                (3, 4),
                (2, 0),
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
                (1, 1, 3),
                (2, 3, 5),
                (3, 5, 7),
                (4, 7, 11),
                (5, 11, 15),
                (6, 15, 17),
                (7, 17, 21),
                (8, 21, 25),
            ],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2_DAMPING: ::rncf::emitted::Blocks<
        2,
        9,
        17,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 1),
                (0, 3),
                (0, 2),
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
            &[(0, 0, 1), (1, 1, 3), (2, 3, 5), (3, 5, 9), (4, 9, 13), (5, 13, 17)],
        );
    /// Weights of 3 Gauss points, and derivatives of the shape functions there.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3: ::rncf::emitted::Rule<3, 3, 3> = ::rncf::emitted::Rule {
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
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<
        3,
        9,
        9,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3
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
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3_DAMPING: ::rncf::emitted::Blocks<
        3,
        9,
        6,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Weights of 3 nodes, and derivatives of the shape functions there.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3: ::rncf::emitted::Rule<3, 2, 3> = ::rncf::emitted::Rule {
        groups: [1, 2],
        weights: [0.16666666666666666, 0.6666666666666666, 0.16666666666666666],
        shapes: [
            [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
            [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3_STIFFNESS: ::rncf::emitted::Blocks<
        3,
        9,
        4,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3
        .blocks(
            &[(0, 0), (0, 1), (1, 0), (1, 1)],
            &[(4, 0, 1), (5, 1, 2), (7, 2, 3), (8, 3, 4)],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3_DAMPING: ::rncf::emitted::Blocks<
        3,
        9,
        3,
    > = FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3
        .blocks(&[(0, 0), (0, 1), (1, 1)], &[(3, 0, 1), (4, 1, 2), (5, 2, 3)]);
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 187 additions, 296 multiplications, 17 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
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
        let t75 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t76 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t77 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t78 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t79 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t80 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t81 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t82 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t83 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t84 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t85 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t86 = a_x * a_x + a_y * a_y + a_z * a_z - (t76 * t76 + t78 * t78);
        let t87 = t86.sqrt();
        let t88 = t87 - 1.0;
        let t89 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t90 = 0.5 * t89;
        let t91 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t92 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t93 = t91 * t92;
        let t94 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t76 * t90) / t87;
        let t95 = t92 * t94;
        let t96 = (a_x * db_x + a_y * db_y + a_z * db_z - t78 * t90) / t87;
        let t97 = t91 * t96;
        let t98 = t90 * t93 + reference[9] * t95 - reference[10] * t97
            + reference[12] * t88 + t76 * reference[15];
        let t99 = 0.5 * (t82 + t82);
        let t100 = 0.5 * (t84 + t84);
        let t101 = t76 * 2.0;
        let t102 = t78 * 2.0;
        let t103 = 1.0 / (2.0 * t87);
        let t104 = (t75 + t75 - (t77 * t101 + t79 * t102)) * t103;
        let t105 = 0.5 * (t85 - t83);
        let t106 = t92 * ((t81 + (t77 * t90 + t76 * t105) - t94 * t104) / t87)
            - t94 * t100;
        let t107 = t91 * ((t80 - (t79 * t90 + t78 * t105) - t96 * t104) / t87)
            - t96 * t99;
        let t108 = t93 * t105 - t90 * (t92 * t99 + t91 * t100) + reference[9] * t106
            - reference[10] * t107;
        let t109 = t98 + t78 * reference[19] - reference[0]
            + damping
                * (t108 + reference[12] * t104 + t77 * reference[15]
                    + t79 * reference[19]);
        let t110 = length * reference[3] * t109;
        let t111 = t92 * (t94 * t103 / t87);
        let t112 = t91 * (t96 * t103 / t87);
        let t113 = t95 - reference[11] * t97 + reference[13] * t88 + t76 * reference[16]
            + t78 * reference[20] - reference[1];
        let t114 = damping
            * (t106 - reference[11] * t107 + reference[13] * t104 + t77 * reference[16]
                + t79 * reference[20]);
        let t115 = length * reference[4] * (t113 + t114);
        let t116 = reference[14] * t88 - t97 + t76 * reference[17] + t78 * reference[21]
            - reference[2]
            + damping
                * (reference[14] * t104 - t107 + t77 * reference[17]
                    + t79 * reference[21]);
        let t117 = length * reference[5] * t116;
        let t118 = t101 * t103;
        let t119 = t92 * ((t90 + t94 * t118) / t87);
        let t120 = t91 * (t96 * t118 / t87);
        let t121 = t102 * t103;
        let t122 = t92 * (t94 * t121 / t87);
        let t123 = t91 * ((t96 * t121 - t90) / t87);
        let t124 = 1.0 / t87;
        let t125 = t91 * t124;
        let t126 = t92 * t124;
        let t127 = -0.5 * t96;
        let t128 = t92 * (t76 * (-0.5) / t87);
        let t129 = t91 * (t78 * (-0.5) / t87);
        let t130 = -0.5 * t94;
        let t131 = t92 * (0.5 * t76 / t87);
        let t132 = t91 * (0.5 * t78 / t87);
        let t133 = t110
            * (reference[10] * t112 - reference[9] * t111 + reference[12] * t103)
            + t115 * (reference[11] * t112 - t111 + reference[13] * t103);
        let t134 = t133 + t117 * (t112 + reference[14] * t103);
        let t135 = t110
            * (reference[15]
                + (reference[9] * t119 - reference[10] * t120 - reference[12] * t118))
            + t115
                * (reference[16] + (t119 - reference[11] * t120 - reference[13] * t118));
        let t136 = t135 + t117 * (reference[17] - (t120 + reference[14] * t118));
        let t137 = t110
            * (reference[19]
                + (reference[9] * t122 - reference[10] * t123 - reference[12] * t121))
            + t115
                * (reference[20] + (t122 - reference[11] * t123 - reference[13] * t121));
        let t138 = t137 + t117 * (reference[21] - (t123 + reference[14] * t121));
        let t139 = t110 * (t90 * (-0.5 * t92) - reference[10] * t127)
            - t115 * (reference[11] * t127) - t117 * t127;
        let t140 = t110 * (-0.5 * t93 + reference[9] * t128 + reference[10] * t129)
            + t115 * (t128 + reference[11] * t129);
        let t141 = t110 * (t90 * (-0.5 * t91) + reference[9] * t130) + t115 * t130;
        let t142 = t110 * (0.5 * t93 + reference[9] * t131 + reference[10] * t132)
            + t115 * (t131 + reference[11] * t132);
        let t143 = inverse_length
            * (t110 * (reference[10] * t125) + t115 * (reference[11] * t125)
                + t117 * t125);
        let t144 = inverse_length * (t110 * (reference[9] * t126) + t115 * t126);
        let t145 = inverse_length * (t140 + t117 * t129);
        let t146 = inverse_length * (t142 + t117 * t132);
        let t147 = t134 * (a_x * 2.0) + b_x * t136 + c_x * t138 - unit_db_x * t143
            + unit_dc_x * t144;
        let t148 = t134 * (a_y * 2.0) + b_y * t136 + c_y * t138 - unit_db_y * t143
            + unit_dc_y * t144;
        let t149 = t134 * (a_z * 2.0) + b_z * t136 + c_z * t138 - unit_db_z * t143
            + unit_dc_z * t144;
        forces[0][0] = t147;
        forces[0][1] = t148;
        forces[0][2] = t149;
        forces[1][0] = a_x * t136 + t139 * (b_x * 2.0) + unit_dc_x * t145;
        forces[1][1] = a_y * t136 + t139 * (b_y * 2.0) + unit_dc_y * t145;
        forces[1][2] = a_z * t136 + t139 * (b_z * 2.0) + unit_dc_z * t145;
        forces[2][0] = a_x * t138 + t141 * (c_x * 2.0) + unit_db_x * t146;
        forces[2][1] = a_y * t138 + t141 * (c_y * 2.0) + unit_db_y * t146;
        forces[2][2] = a_z * t138 + t141 * (c_z * 2.0) + unit_db_z * t146;
        forces[3][0] = c_x * t146 - a_x * t143;
        forces[3][1] = c_y * t146 - a_y * t143;
        forces[3][2] = c_z * t146 - a_z * t143;
        forces[4][0] = a_x * t144 + b_x * t145;
        forces[4][1] = a_y * t144 + b_y * t145;
        forces[4][2] = a_z * t144 + b_z * t145;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 2484 additions, 3620 multiplications, 64 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 25],
        damping_matrix: &mut [[f64; 9]; 17],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
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
        let t75 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t76 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t77 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t78 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t79 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t80 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t81 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t82 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t83 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t84 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t85 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t86 = a_x * a_x + a_y * a_y + a_z * a_z - (t76 * t76 + t78 * t78);
        let t87 = t86.sqrt();
        let t88 = t87 - 1.0;
        let t89 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t90 = 0.5 * t89;
        let t91 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t92 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t93 = t91 * t92;
        let t94 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t76 * t90) / t87;
        let t95 = t92 * t94;
        let t96 = (a_x * db_x + a_y * db_y + a_z * db_z - t78 * t90) / t87;
        let t97 = t91 * t96;
        let t98 = t90 * t93 + reference[9] * t95 - reference[10] * t97
            + reference[12] * t88 + t76 * reference[15];
        let t99 = length * reference[3];
        let t100 = 0.5 * (t82 + t82);
        let t101 = 0.5 * (t84 + t84);
        let t102 = t76 * 2.0;
        let t103 = t78 * 2.0;
        let t104 = t75 + t75 - (t77 * t102 + t79 * t103);
        let t105 = 2.0 * t87;
        let t106 = 1.0 / t105;
        let t107 = t104 * t106;
        let t108 = 0.5 * (t85 - t83);
        let t109 = t92 * t100 + t91 * t101;
        let t110 = (t81 + (t77 * t90 + t76 * t108) - t94 * t107) / t87;
        let t111 = t92 * t110 - t94 * t101;
        let t112 = (t80 - (t79 * t90 + t78 * t108) - t96 * t107) / t87;
        let t113 = t91 * t112 - t96 * t100;
        let t114 = t93 * t108 - t90 * t109 + reference[9] * t111 - reference[10] * t113
            + reference[12] * t107;
        let t115 = t98 + t78 * reference[19] - reference[0]
            + damping * (t114 + t77 * reference[15] + t79 * reference[19]);
        let t116 = t99 * t115;
        let t117 = t94 * t106 / t87;
        let t118 = t92 * t117;
        let t119 = t96 * t106 / t87;
        let t120 = t91 * t119;
        let t121 = reference[10] * t120 - reference[9] * t118 + reference[12] * t106;
        let t122 = length * reference[4];
        let t123 = t95 - reference[11] * t97 + reference[13] * t88 + t76 * reference[16]
            + t78 * reference[20] - reference[1];
        let t124 = damping
            * (t111 - reference[11] * t113 + reference[13] * t107 + t77 * reference[16]
                + t79 * reference[20]);
        let t125 = t122 * (t123 + t124);
        let t126 = reference[11] * t120 - t118 + reference[13] * t106;
        let t127 = length * reference[5];
        let t128 = reference[14] * t88 - t97 + t76 * reference[17] + t78 * reference[21]
            - reference[2]
            + damping
                * (reference[14] * t107 - t113 + t77 * reference[17]
                    + t79 * reference[21]);
        let t129 = t127 * t128;
        let t130 = t120 + reference[14] * t106;
        let t131 = 2.0 * t106;
        let t132 = t106 * t131 / t105;
        let t133 = t104 * t132;
        let t134 = t101 * t117 + t92 * ((t107 * t117 + t94 * t133 - t106 * t110) / t87);
        let t135 = t100 * t119 + t91 * ((t107 * t119 + t96 * t133 - t106 * t112) / t87);
        let t136 = t99
            * (t121
                + damping
                    * (reference[9] * t134 - reference[10] * t135
                        - reference[12] * t133));
        let t137 = t106 * t117;
        let t138 = t92 * ((t137 + (t137 + t94 * t132)) / t87);
        let t139 = t106 * t119;
        let t140 = t91 * ((t139 + (t139 + t96 * t132)) / t87);
        let t141 = t122
            * (t126 + damping * (t134 - reference[11] * t135 - reference[13] * t133));
        let t142 = t121 * t136
            + t116 * (reference[9] * t138 - reference[10] * t140 - reference[12] * t132)
            + (t126 * t141
                + t125 * (t138 - reference[11] * t140 - reference[13] * t132));
        let t143 = t127 * (t130 - damping * (t135 + reference[14] * t133));
        let t144 = t142 + (t130 * t143 - t129 * (t140 + reference[14] * t132));
        let t145 = t102 * t106;
        let t146 = (t90 + t94 * t145) / t87;
        let t147 = t92 * t146;
        let t148 = t96 * t145 / t87;
        let t149 = t91 * t148;
        let t150 = reference[15]
            + (reference[9] * t147 - reference[10] * t149 - reference[12] * t145);
        let t151 = reference[16] + (t147 - reference[11] * t149 - reference[13] * t145);
        let t152 = reference[17] - (t149 + reference[14] * t145);
        let t153 = t106 * (2.0 * t145) / t105;
        let t154 = t104 * t153 - t106 * (t77 * 2.0);
        let t155 = t92 * ((t108 - (t107 * t146 + t94 * t154) + t110 * t145) / t87)
            - t101 * t146;
        let t156 = t91 * ((t112 * t145 - (t107 * t148 + t96 * t154)) / t87)
            - t100 * t148;
        let t157 = t99
            * (t150
                + damping
                    * (reference[9] * t155 - reference[10] * t156
                        + reference[12] * t154));
        let t158 = t106 * t146;
        let t159 = t117 * t145;
        let t160 = t92 * ((t158 + t94 * t153 + t159) / t87);
        let t161 = t106 * t148;
        let t162 = t119 * t145;
        let t163 = t91 * ((t161 + t96 * t153 + t162) / t87);
        let t164 = t122
            * (t151 + damping * (t155 - reference[11] * t156 + reference[13] * t154));
        let t165 = t121 * t157
            + t116 * (reference[10] * t163 - reference[9] * t160 + reference[12] * t153)
            + (t126 * t164
                + t125 * (reference[11] * t163 - t160 + reference[13] * t153));
        let t166 = t127 * (t152 + damping * (reference[14] * t154 - t156));
        let t167 = t165 + (t130 * t166 + t129 * (t163 + reference[14] * t153));
        let t168 = t103 * t106;
        let t169 = t94 * t168 / t87;
        let t170 = t92 * t169;
        let t171 = (t96 * t168 - t90) / t87;
        let t172 = t91 * t171;
        let t173 = reference[19]
            + (reference[9] * t170 - reference[10] * t172 - reference[12] * t168);
        let t174 = reference[20] + (t170 - reference[11] * t172 - reference[13] * t168);
        let t175 = reference[21] - (t172 + reference[14] * t168);
        let t176 = t106 * (2.0 * t168) / t105;
        let t177 = t104 * t176 - t106 * (t79 * 2.0);
        let t178 = t92 * ((t110 * t168 - (t107 * t169 + t94 * t177)) / t87)
            - t101 * t169;
        let t179 = t91 * ((t112 * t168 - (t108 + (t107 * t171 + t96 * t177))) / t87)
            - t100 * t171;
        let t180 = t99
            * (t173
                + damping
                    * (reference[9] * t178 - reference[10] * t179
                        + reference[12] * t177));
        let t181 = t106 * t169;
        let t182 = t117 * t168;
        let t183 = t92 * ((t181 + t94 * t176 + t182) / t87);
        let t184 = t106 * t171;
        let t185 = t119 * t168;
        let t186 = t91 * ((t184 + t96 * t176 + t185) / t87);
        let t187 = t122
            * (t174 + damping * (t178 - reference[11] * t179 + reference[13] * t177));
        let t188 = t121 * t180
            + t116 * (reference[10] * t186 - reference[9] * t183 + reference[12] * t176)
            + (t126 * t187
                + t125 * (reference[11] * t186 - t183 + reference[13] * t176));
        let t189 = t127 * (t175 + damping * (reference[14] * t177 - t179));
        let t190 = t188 + (t130 * t189 + t129 * (t186 + reference[14] * t176));
        let t191 = 1.0 / t87;
        let t192 = t91 * t191;
        let t193 = reference[10] * t192;
        let t194 = reference[11] * t192;
        let t195 = t107 * t191 / t87;
        let t196 = t100 * t191 + t91 * t195;
        let t197 = t99 * (damping * (reference[10] * t196) - t193);
        let t198 = t106 * t191 / t87;
        let t199 = t91 * t198;
        let t200 = t116 * (reference[10] * t199);
        let t201 = t122 * (damping * (reference[11] * t196) - t194);
        let t202 = t125 * (reference[11] * t199);
        let t203 = t127 * (damping * t196 - t192);
        let t204 = t129 * t199;
        let t205 = t92 * t191;
        let t206 = reference[9] * t205;
        let t207 = t101 * t191 + t92 * t195;
        let t208 = t99 * (t206 - damping * (reference[9] * t207));
        let t209 = t92 * t198;
        let t210 = t116 * (reference[9] * t209);
        let t211 = t122 * (t205 - damping * t207);
        let t212 = t125 * t209;
        let t213 = -0.5 * t92;
        let t214 = -0.5 * t96;
        let t215 = t90 * t213 - reference[10] * t214;
        let t216 = reference[11] * t214;
        let t217 = -0.5 * t112;
        let t218 = t99
            * (t215
                + damping * (t108 * t213 - t90 * (-0.5 * t101) - reference[10] * t217));
        let t219 = -0.5 * t119;
        let t220 = t116 * (reference[10] * t219);
        let t221 = t122 * (t216 + damping * (reference[11] * t217));
        let t222 = t125 * (reference[11] * t219);
        let t223 = t127 * (t214 + damping * t217);
        let t224 = t129 * t219;
        let t225 = t121 * t218 + t220 + (t222 - t126 * t221) + (t224 - t130 * t223);
        let t226 = t76 * (-0.5) / t87;
        let t227 = t92 * t226;
        let t228 = t78 * (-0.5) / t87;
        let t229 = t91 * t228;
        let t230 = -0.5 * t93 + reference[9] * t227 + reference[10] * t229;
        let t231 = t227 + reference[11] * t229;
        let t232 = t92 * ((t77 * (-0.5) - t107 * t226) / t87) - t101 * t226;
        let t233 = t100 * t228 + t91 * ((t107 * t228 - t79 * (-0.5)) / t87);
        let t234 = t99
            * (t230
                + damping
                    * (reference[9] * t232 - (-0.5 * t109) - reference[10] * t233));
        let t235 = t92 * (t106 * t226 / t87);
        let t236 = t91 * (t106 * t228 / t87);
        let t237 = t116 * (reference[9] * t235 + reference[10] * t236);
        let t238 = t122 * (t231 + damping * (t232 - reference[11] * t233));
        let t239 = t125 * (t235 + reference[11] * t236);
        let t240 = t127 * (t229 - damping * t233);
        let t241 = t129 * t236;
        let t242 = -0.5 * t91;
        let t243 = -0.5 * t94;
        let t244 = t90 * t242 + reference[9] * t243;
        let t245 = -0.5 * t110;
        let t246 = t99
            * (t244
                + damping * (t108 * t242 - t90 * (-0.5 * t100) + reference[9] * t245));
        let t247 = -0.5 * t117;
        let t248 = t116 * (reference[9] * t247);
        let t249 = t122 * (t243 + damping * t245);
        let t250 = t125 * t247;
        let t251 = t121 * t246 - t248 + (t126 * t249 - t250);
        let t252 = 0.5 * t76 / t87;
        let t253 = t92 * t252;
        let t254 = 0.5 * t78 / t87;
        let t255 = t91 * t254;
        let t256 = 0.5 * t93 + reference[9] * t253 + reference[10] * t255;
        let t257 = t253 + reference[11] * t255;
        let t258 = t92 * ((0.5 * t77 - t107 * t252) / t87) - t101 * t252;
        let t259 = t100 * t254 + t91 * ((t107 * t254 - 0.5 * t79) / t87);
        let t260 = t99
            * (t256
                + damping * (reference[9] * t258 - 0.5 * t109 - reference[10] * t259));
        let t261 = t92 * (t106 * t252 / t87);
        let t262 = t91 * (t106 * t254 / t87);
        let t263 = t116 * (reference[9] * t261 + reference[10] * t262);
        let t264 = t122 * (t257 + damping * (t258 - reference[11] * t259));
        let t265 = t125 * (t261 + reference[11] * t262);
        let t266 = t127 * (t255 - damping * t259);
        let t267 = t129 * t262;
        let t268 = t102 * t132;
        let t269 = t92 * ((t158 + (t159 + t94 * t268)) / t87);
        let t270 = t91 * ((t161 + (t162 + t96 * t268)) / t87);
        let t271 = t136 * t150
            + t116 * (reference[10] * t270 - reference[9] * t269 + reference[12] * t268)
            + (t141 * t151
                + t125 * (reference[11] * t270 - t269 + reference[13] * t268));
        let t272 = t271 + (t143 * t152 + t129 * (t270 + reference[14] * t268));
        let t273 = t131 + t102 * t153;
        let t274 = t145 * t146;
        let t275 = t92 * ((t274 + (t274 + t94 * t273)) / t87);
        let t276 = t145 * t148;
        let t277 = t91 * ((t276 + (t276 + t96 * t273)) / t87);
        let t278 = t150 * t157
            + t116 * (reference[9] * t275 - reference[10] * t277 - reference[12] * t273)
            + (t151 * t164
                + t125 * (t275 - reference[11] * t277 - reference[13] * t273));
        let t279 = t278 + (t152 * t166 - t129 * (t277 + reference[14] * t273));
        let t280 = t102 * t176;
        let t281 = t145 * t169;
        let t282 = t146 * t168;
        let t283 = t92 * ((t281 + t94 * t280 + t282) / t87);
        let t284 = t145 * t171;
        let t285 = t148 * t168;
        let t286 = t91 * ((t284 + t96 * t280 + t285) / t87);
        let t287 = t150 * t180
            + t116 * (reference[9] * t283 - reference[10] * t286 - reference[12] * t280)
            + (t151 * t187
                + t125 * (t283 - reference[11] * t286 - reference[13] * t280));
        let t288 = t287 + (t152 * t189 - t129 * (t286 + reference[14] * t280));
        let t289 = t145 * t191 / t87;
        let t290 = t91 * t289;
        let t291 = t116 * (reference[10] * t290);
        let t292 = t125 * (reference[11] * t290);
        let t293 = t129 * t290;
        let t294 = t92 * t289;
        let t295 = t116 * (reference[9] * t294);
        let t296 = t125 * t294;
        let t297 = -0.5 * t148;
        let t298 = t116 * (reference[10] * t297);
        let t299 = t125 * (reference[11] * t297);
        let t300 = t129 * t297;
        let t301 = t150 * t218 - t298 - (t151 * t221 + t299) - (t152 * t223 + t300);
        let t302 = t92 * ((-0.5 + t145 * t226) / t87);
        let t303 = t91 * (t145 * t228 / t87);
        let t304 = t116 * (reference[9] * t302 + reference[10] * t303);
        let t305 = t125 * (t302 + reference[11] * t303);
        let t306 = t129 * t303;
        let t307 = -0.5 * t146;
        let t308 = t116 * (reference[9] * t307);
        let t309 = t125 * t307;
        let t310 = t150 * t246 + t308 + (t151 * t249 + t309);
        let t311 = t92 * ((0.5 + t145 * t252) / t87);
        let t312 = t91 * (t145 * t254 / t87);
        let t313 = t116 * (reference[9] * t311 + reference[10] * t312);
        let t314 = t125 * (t311 + reference[11] * t312);
        let t315 = t129 * t312;
        let t316 = t103 * t132;
        let t317 = t92 * ((t181 + (t182 + t94 * t316)) / t87);
        let t318 = t91 * ((t184 + (t185 + t96 * t316)) / t87);
        let t319 = t136 * t173
            + t116 * (reference[10] * t318 - reference[9] * t317 + reference[12] * t316)
            + (t141 * t174
                + t125 * (reference[11] * t318 - t317 + reference[13] * t316));
        let t320 = t319 + (t143 * t175 + t129 * (t318 + reference[14] * t316));
        let t321 = t103 * t153;
        let t322 = t92 * ((t281 + (t282 + t94 * t321)) / t87);
        let t323 = t91 * ((t284 + (t285 + t96 * t321)) / t87);
        let t324 = t157 * t173
            + t116 * (reference[9] * t322 - reference[10] * t323 - reference[12] * t321)
            + (t164 * t174
                + t125 * (t322 - reference[11] * t323 - reference[13] * t321));
        let t325 = t324 + (t166 * t175 - t129 * (t323 + reference[14] * t321));
        let t326 = t131 + t103 * t176;
        let t327 = t168 * t169;
        let t328 = t92 * ((t327 + (t327 + t94 * t326)) / t87);
        let t329 = t168 * t171;
        let t330 = t91 * ((t329 + (t329 + t96 * t326)) / t87);
        let t331 = t173 * t180
            + t116 * (reference[9] * t328 - reference[10] * t330 - reference[12] * t326)
            + (t174 * t187
                + t125 * (t328 - reference[11] * t330 - reference[13] * t326));
        let t332 = t331 + (t175 * t189 - t129 * (t330 + reference[14] * t326));
        let t333 = t168 * t191 / t87;
        let t334 = t91 * t333;
        let t335 = t116 * (reference[10] * t334);
        let t336 = t125 * (reference[11] * t334);
        let t337 = t129 * t334;
        let t338 = t92 * t333;
        let t339 = t116 * (reference[9] * t338);
        let t340 = t125 * t338;
        let t341 = -0.5 * t171;
        let t342 = t116 * (reference[10] * t341);
        let t343 = t125 * (reference[11] * t341);
        let t344 = t129 * t341;
        let t345 = t173 * t218 - t342 - (t174 * t221 + t343) - (t175 * t223 + t344);
        let t346 = t92 * (t168 * t226 / t87);
        let t347 = t91 * ((-0.5 + t168 * t228) / t87);
        let t348 = t116 * (reference[9] * t346 + reference[10] * t347);
        let t349 = t125 * (t346 + reference[11] * t347);
        let t350 = t129 * t347;
        let t351 = -0.5 * t169;
        let t352 = t116 * (reference[9] * t351);
        let t353 = t125 * t351;
        let t354 = t173 * t246 + t352 + (t174 * t249 + t353);
        let t355 = t92 * (t168 * t252 / t87);
        let t356 = t91 * ((0.5 + t168 * t254) / t87);
        let t357 = t116 * (reference[9] * t355 + reference[10] * t356);
        let t358 = t125 * (t355 + reference[11] * t356);
        let t359 = t129 * t356;
        let t360 = -0.5 * t191;
        let t361 = t116 * (reference[10] * t360);
        let t362 = t125 * (reference[11] * t360);
        let t363 = t129 * t360;
        let t364 = t116 * (reference[9] * t360);
        let t365 = t125 * t360;
        let t366 = t220 + t136 * t215 - (t141 * t216 - t222) - (t143 * t214 - t224);
        let t367 = t157 * t215 - t298 - (t299 + t164 * t216) - (t300 + t166 * t214);
        let t368 = t180 * t215 - t342 - (t343 + t187 * t216) - (t344 + t189 * t214);
        let t369 = t215 * t218 + t216 * t221 + t214 * t223;
        let t370 = -0.5 * t228;
        let t371 = t116 * (-0.5 * t213 + reference[10] * t370);
        let t372 = t125 * (reference[11] * t370);
        let t373 = t129 * t370;
        let t374 = t116 * (t90 * 0.25);
        let t375 = t215 * t246 + t374 - t216 * t249;
        let t376 = -0.5 * t254;
        let t377 = t116 * (0.5 * t213 + reference[10] * t376);
        let t378 = t125 * (reference[11] * t376);
        let t379 = t129 * t376;
        let t380 = -0.5 * t226;
        let t381 = t116 * (-0.5 * t242 + reference[9] * t380);
        let t382 = t125 * t380;
        let t383 = t136 * t244 - t248 + (t141 * t243 - t250);
        let t384 = t308 + t157 * t244 + (t309 + t164 * t243);
        let t385 = t352 + t180 * t244 + (t353 + t187 * t243);
        let t386 = t374 + t218 * t244 - t221 * t243;
        let t387 = t244 * t246 + t243 * t249;
        let t388 = -0.5 * t252;
        let t389 = t116 * (0.5 * t242 + reference[9] * t388);
        let t390 = t125 * t388;
        let t391 = t99 * (damping * t121);
        let t392 = t122 * (damping * t126);
        let t393 = t127 * (damping * t130);
        let t394 = t121 * t391 + t126 * t392 + t130 * t393;
        let t395 = t99 * (damping * t150);
        let t396 = t122 * (damping * t151);
        let t397 = t127 * (damping * t152);
        let t398 = t121 * t395 + t126 * t396 + t130 * t397;
        let t399 = t99 * (damping * t173);
        let t400 = t122 * (damping * t174);
        let t401 = t127 * (damping * t175);
        let t402 = t121 * t399 + t126 * t400 + t130 * t401;
        let t403 = t99 * (damping * t193);
        let t404 = t122 * (damping * t194);
        let t405 = t127 * (damping * t192);
        let t406 = t99 * (damping * t206);
        let t407 = t122 * (damping * t205);
        let t408 = 0.5 * t96;
        let t409 = t99 * (damping * (reference[10] * t408 - t90 * (0.5 * t92)));
        let t410 = t122 * (damping * (reference[11] * t408));
        let t411 = t127 * (damping * t408);
        let t412 = t121 * t409 + t126 * t410 + t130 * t411;
        let t413 = t99 * (damping * t230);
        let t414 = t122 * (damping * t231);
        let t415 = t127 * (damping * t229);
        let t416 = 0.5 * t94;
        let t417 = t99 * (damping * (t90 * (0.5 * t91) + reference[9] * t416));
        let t418 = t122 * (damping * t416);
        let t419 = t121 * t417 + t126 * t418;
        let t420 = t99 * (damping * t256);
        let t421 = t122 * (damping * t257);
        let t422 = t127 * (damping * t255);
        let t423 = t150 * t391 + t151 * t392 + t152 * t393;
        let t424 = t150 * t395 + t151 * t396 + t152 * t397;
        let t425 = t150 * t399 + t151 * t400 + t152 * t401;
        let t426 = t150 * t409 + t151 * t410 + t152 * t411;
        let t427 = t150 * t417 + t151 * t418;
        let t428 = t173 * t391 + t174 * t392 + t175 * t393;
        let t429 = t173 * t395 + t174 * t396 + t175 * t397;
        let t430 = t173 * t399 + t174 * t400 + t175 * t401;
        let t431 = t173 * t409 + t174 * t410 + t175 * t411;
        let t432 = t173 * t417 + t174 * t418;
        let t433 = t215 * t391 - t216 * t392 - t214 * t393;
        let t434 = t215 * t395 - t216 * t396 - t214 * t397;
        let t435 = t215 * t399 - t216 * t400 - t214 * t401;
        let t436 = t215 * t409 - t216 * t410 - t214 * t411;
        let t437 = t216 * t418 - t215 * t417;
        let t438 = t244 * t391 + t243 * t392;
        let t439 = t244 * t395 + t243 * t396;
        let t440 = t244 * t399 + t243 * t400;
        let t441 = t244 * t409 + t243 * t410;
        let t442 = t244 * t417 + t243 * t418;
        let t443 = t116 * t150 + t125 * t151 + t129 * t152;
        let t444 = t116 * t173 + t125 * t174 + t129 * t175;
        let t445 = inverse_length
            * (t121 * t197 + t200 + (t126 * t201 + t202) + (t130 * t203 + t204));
        let t446 = inverse_length * (t121 * t208 - t210 + (t126 * t211 - t212));
        let t447 = inverse_length
            * (t121 * t234 - t237 + (t126 * t238 - t239) + (t130 * t240 - t241));
        let t448 = inverse_length
            * (t121 * t260 - t263 + (t126 * t264 - t265) + (t130 * t266 - t267));
        let t449 = inverse_length * (t121 * t403 + t126 * t404 + t130 * t405);
        let t450 = inverse_length * (t121 * t406 + t126 * t407);
        let t451 = inverse_length * (t121 * t413 + t126 * t414 + t130 * t415);
        let t452 = inverse_length * (t121 * t420 + t126 * t421 + t130 * t422);
        let t453 = inverse_length
            * (t150 * t197 - t291 + (t151 * t201 - t292) + (t152 * t203 - t293));
        let t454 = inverse_length * (t150 * t208 + t295 + (t151 * t211 + t296));
        let t455 = inverse_length
            * (t150 * t234 + t304 + (t151 * t238 + t305) + (t152 * t240 + t306));
        let t456 = inverse_length
            * (t150 * t260 + t313 + (t151 * t264 + t314) + (t152 * t266 + t315));
        let t457 = inverse_length * (t150 * t403 + t151 * t404 + t152 * t405);
        let t458 = inverse_length * (t150 * t406 + t151 * t407);
        let t459 = inverse_length * (t150 * t413 + t151 * t414 + t152 * t415);
        let t460 = inverse_length * (t150 * t420 + t151 * t421 + t152 * t422);
        let t461 = inverse_length
            * (t173 * t197 - t335 + (t174 * t201 - t336) + (t175 * t203 - t337));
        let t462 = inverse_length * (t173 * t208 + t339 + (t174 * t211 + t340));
        let t463 = inverse_length
            * (t173 * t234 + t348 + (t174 * t238 + t349) + (t175 * t240 + t350));
        let t464 = inverse_length
            * (t173 * t260 + t357 + (t174 * t264 + t358) + (t175 * t266 + t359));
        let t465 = inverse_length * (t173 * t403 + t174 * t404 + t175 * t405);
        let t466 = inverse_length * (t173 * t406 + t174 * t407);
        let t467 = inverse_length * (t173 * t413 + t174 * t414 + t175 * t415);
        let t468 = inverse_length * (t173 * t420 + t174 * t421 + t175 * t422);
        let t469 = inverse_length * (t116 * t193 + t125 * t194 + t129 * t192);
        let t470 = inverse_length
            * (t136 * t193 - t200 + (t141 * t194 - t202) + (t143 * t192 - t204));
        let t471 = inverse_length
            * (t291 + t157 * t193 + (t292 + t164 * t194) + (t293 + t166 * t192));
        let t472 = inverse_length
            * (t335 + t180 * t193 + (t336 + t187 * t194) + (t337 + t189 * t192));
        let t473 = inverse_length * inverse_length;
        let t474 = (t193 * t197 + t194 * t201 + t192 * t203) * t473;
        let t475 = (t193 * t208 + t194 * t211) * t473;
        let t476 = inverse_length
            * (t193 * t218 + t361 + (t362 - t194 * t221) + (t363 - t192 * t223));
        let t477 = (t193 * t234 + t194 * t238 + t192 * t240) * t473;
        let t478 = inverse_length * (t193 * t246 + t194 * t249);
        let t479 = (t193 * t260 + t194 * t264 + t192 * t266) * t473;
        let t480 = inverse_length * (t193 * t391 + t194 * t392 + t192 * t393);
        let t481 = inverse_length * (t193 * t395 + t194 * t396 + t192 * t397);
        let t482 = inverse_length * (t193 * t399 + t194 * t400 + t192 * t401);
        let t483 = (t193 * t403 + t194 * t404 + t192 * t405) * t473;
        let t484 = (t193 * t406 + t194 * t407) * t473;
        let t485 = inverse_length * (t193 * t409 + t194 * t410 + t192 * t411);
        let t486 = (t193 * t413 + t194 * t414 + t192 * t415) * t473;
        let t487 = inverse_length * (t193 * t417 + t194 * t418);
        let t488 = (t193 * t420 + t194 * t421 + t192 * t422) * t473;
        let t489 = inverse_length * (t116 * t206 + t125 * t205);
        let t490 = inverse_length * (t136 * t206 - t210 + (t141 * t205 - t212));
        let t491 = inverse_length * (t295 + t157 * t206 + (t296 + t164 * t205));
        let t492 = inverse_length * (t339 + t180 * t206 + (t340 + t187 * t205));
        let t493 = (t197 * t206 + t201 * t205) * t473;
        let t494 = (t206 * t208 + t205 * t211) * t473;
        let t495 = inverse_length * (t206 * t218 - t205 * t221);
        let t496 = (t206 * t234 + t205 * t238) * t473;
        let t497 = inverse_length * (t206 * t246 + t364 + (t365 + t205 * t249));
        let t498 = (t206 * t260 + t205 * t264) * t473;
        let t499 = inverse_length * (t206 * t391 + t205 * t392);
        let t500 = inverse_length * (t206 * t395 + t205 * t396);
        let t501 = inverse_length * (t206 * t399 + t205 * t400);
        let t502 = (t206 * t403 + t205 * t404) * t473;
        let t503 = (t206 * t406 + t205 * t407) * t473;
        let t504 = inverse_length * (t206 * t409 + t205 * t410);
        let t505 = (t206 * t413 + t205 * t414) * t473;
        let t506 = inverse_length * (t206 * t417 + t205 * t418);
        let t507 = (t206 * t420 + t205 * t421) * t473;
        let t508 = inverse_length
            * (t197 * t215 - t361 - (t362 + t201 * t216) - (t363 + t203 * t214));
        let t509 = inverse_length * (t208 * t215 - t211 * t216);
        let t510 = inverse_length
            * (t215 * t234 + t371 - (t216 * t238 - t372) - (t214 * t240 - t373));
        let t511 = inverse_length
            * (t215 * t260 + t377 - (t216 * t264 - t378) - (t214 * t266 - t379));
        let t512 = inverse_length * (t216 * t404 - t215 * t403 + t214 * t405);
        let t513 = inverse_length * (t215 * t406 - t216 * t407);
        let t514 = inverse_length * (t215 * t413 - t216 * t414 - t214 * t415);
        let t515 = inverse_length * (t215 * t420 - t216 * t421 - t214 * t422);
        let t516 = inverse_length * (t116 * t230 + t125 * t231 + t129 * t229);
        let t517 = inverse_length
            * (t136 * t230 - t237 + (t141 * t231 - t239) + (t143 * t229 - t241));
        let t518 = inverse_length
            * (t304 + t157 * t230 + (t305 + t164 * t231) + (t306 + t166 * t229));
        let t519 = inverse_length
            * (t348 + t180 * t230 + (t349 + t187 * t231) + (t350 + t189 * t229));
        let t520 = (t197 * t230 + t201 * t231 + t203 * t229) * t473;
        let t521 = (t208 * t230 + t211 * t231) * t473;
        let t522 = inverse_length
            * (t371 + t218 * t230 + (t372 - t221 * t231) + (t373 - t223 * t229));
        let t523 = (t230 * t234 + t231 * t238 + t229 * t240) * t473;
        let t524 = inverse_length * (t230 * t246 + t381 + (t231 * t249 + t382));
        let t525 = (t230 * t260 + t231 * t264 + t229 * t266) * t473;
        let t526 = inverse_length * (t230 * t391 + t231 * t392 + t229 * t393);
        let t527 = inverse_length * (t230 * t395 + t231 * t396 + t229 * t397);
        let t528 = inverse_length * (t230 * t399 + t231 * t400 + t229 * t401);
        let t529 = (t230 * t403 + t231 * t404 + t229 * t405) * t473;
        let t530 = (t230 * t406 + t231 * t407) * t473;
        let t531 = inverse_length * (t230 * t409 + t231 * t410 + t229 * t411);
        let t532 = (t230 * t413 + t231 * t414 + t229 * t415) * t473;
        let t533 = inverse_length * (t230 * t417 + t231 * t418);
        let t534 = (t230 * t420 + t231 * t421 + t229 * t422) * t473;
        let t535 = inverse_length * (t197 * t244 + t201 * t243);
        let t536 = inverse_length * (t364 + t208 * t244 + (t365 + t211 * t243));
        let t537 = inverse_length * (t381 + t234 * t244 + (t382 + t238 * t243));
        let t538 = inverse_length * (t244 * t260 + t389 + (t390 + t243 * t264));
        let t539 = inverse_length * (t244 * t403 + t243 * t404);
        let t540 = inverse_length * (t244 * t406 + t243 * t407);
        let t541 = inverse_length * (t244 * t413 + t243 * t414);
        let t542 = inverse_length * (t244 * t420 + t243 * t421);
        let t543 = inverse_length * (t116 * t256 + t125 * t257 + t129 * t255);
        let t544 = inverse_length
            * (t136 * t256 - t263 + (t141 * t257 - t265) + (t143 * t255 - t267));
        let t545 = inverse_length
            * (t313 + t157 * t256 + (t314 + t164 * t257) + (t315 + t166 * t255));
        let t546 = inverse_length
            * (t357 + t180 * t256 + (t358 + t187 * t257) + (t359 + t189 * t255));
        let t547 = (t197 * t256 + t201 * t257 + t203 * t255) * t473;
        let t548 = (t208 * t256 + t211 * t257) * t473;
        let t549 = inverse_length
            * (t377 + t218 * t256 + (t378 - t221 * t257) + (t379 - t223 * t255));
        let t550 = (t234 * t256 + t238 * t257 + t240 * t255) * t473;
        let t551 = inverse_length * (t389 + t246 * t256 + (t390 + t249 * t257));
        let t552 = (t256 * t260 + t257 * t264 + t255 * t266) * t473;
        let t553 = inverse_length * (t256 * t391 + t257 * t392 + t255 * t393);
        let t554 = inverse_length * (t256 * t395 + t257 * t396 + t255 * t397);
        let t555 = inverse_length * (t256 * t399 + t257 * t400 + t255 * t401);
        let t556 = (t256 * t403 + t257 * t404 + t255 * t405) * t473;
        let t557 = (t256 * t406 + t257 * t407) * t473;
        let t558 = inverse_length * (t256 * t409 + t257 * t410 + t255 * t411);
        let t559 = (t256 * t413 + t257 * t414 + t255 * t415) * t473;
        let t560 = inverse_length * (t256 * t417 + t257 * t418);
        let t561 = (t256 * t420 + t257 * t421 + t255 * t422) * t473;
        let t562 = a_x * 2.0;
        let t563 = a_y * 2.0;
        let t564 = a_z * 2.0;
        let t565 = b_x * 2.0;
        let t566 = b_y * 2.0;
        let t567 = b_z * 2.0;
        let t568 = c_x * 2.0;
        let t569 = c_y * 2.0;
        let t570 = c_z * 2.0;
        let t571 = v_a_x * 2.0;
        let t572 = v_a_y * 2.0;
        let t573 = v_a_z * 2.0;
        let t574 = v_b_x * 2.0;
        let t575 = v_b_y * 2.0;
        let t576 = v_b_z * 2.0;
        let t577 = v_c_x * 2.0;
        let t578 = v_c_y * 2.0;
        let t579 = v_c_z * 2.0;
        let t580 = t144 * t562 + b_x * t167 + c_x * t190 + unit_db_x * t445
            + unit_dc_x * t446;
        let t581 = t144 * t563 + b_y * t167 + c_y * t190 + unit_db_y * t445
            + unit_dc_y * t446;
        let t582 = t144 * t564 + b_z * t167 + c_z * t190 + unit_db_z * t445
            + unit_dc_z * t446;
        let t583 = t272 * t562 + b_x * t279 + c_x * t288 + unit_db_x * t453
            + unit_dc_x * t454;
        let t584 = t272 * t563 + b_y * t279 + c_y * t288 + unit_db_y * t453
            + unit_dc_y * t454;
        let t585 = t272 * t564 + b_z * t279 + c_z * t288 + unit_db_z * t453
            + unit_dc_z * t454;
        let t586 = t320 * t562 + b_x * t325 + c_x * t332 + unit_db_x * t461
            + unit_dc_x * t462;
        let t587 = t320 * t563 + b_y * t325 + c_y * t332 + unit_db_y * t461
            + unit_dc_y * t462;
        let t588 = t320 * t564 + b_z * t325 + c_z * t332 + unit_db_z * t461
            + unit_dc_z * t462;
        let t589 = t470 * t562 + b_x * t471 + c_x * t472 + unit_db_x * t474
            + unit_dc_x * t475;
        let t590 = t470 * t563 + b_y * t471 + c_y * t472 + unit_db_y * t474
            + unit_dc_y * t475;
        let t591 = t470 * t564 + b_z * t471 + c_z * t472 + unit_db_z * t474
            + unit_dc_z * t475;
        let t592 = t490 * t562 + b_x * t491 + c_x * t492 + unit_db_x * t493
            + unit_dc_x * t494;
        let t593 = t490 * t563 + b_y * t491 + c_y * t492 + unit_db_y * t493
            + unit_dc_y * t494;
        let t594 = t490 * t564 + b_z * t491 + c_z * t492 + unit_db_z * t493
            + unit_dc_z * t494;
        let t595 = t366 * t562 + b_x * t367 + c_x * t368 + unit_db_x * t508
            + unit_dc_x * t509;
        let t596 = t366 * t563 + b_y * t367 + c_y * t368 + unit_db_y * t508
            + unit_dc_y * t509;
        let t597 = t366 * t564 + b_z * t367 + c_z * t368 + unit_db_z * t508
            + unit_dc_z * t509;
        let t598 = t517 * t562 + b_x * t518 + c_x * t519 + unit_db_x * t520
            + unit_dc_x * t521;
        let t599 = t517 * t563 + b_y * t518 + c_y * t519 + unit_db_y * t520
            + unit_dc_y * t521;
        let t600 = t517 * t564 + b_z * t518 + c_z * t519 + unit_db_z * t520
            + unit_dc_z * t521;
        let t601 = t383 * t562 + b_x * t384 + c_x * t385 + unit_db_x * t535
            + unit_dc_x * t536;
        let t602 = t383 * t563 + b_y * t384 + c_y * t385 + unit_db_y * t535
            + unit_dc_y * t536;
        let t603 = t383 * t564 + b_z * t384 + c_z * t385 + unit_db_z * t535
            + unit_dc_z * t536;
        let t604 = t544 * t562 + b_x * t545 + c_x * t546 + unit_db_x * t547
            + unit_dc_x * t548;
        let t605 = t544 * t563 + b_y * t545 + c_y * t546 + unit_db_y * t547
            + unit_dc_y * t548;
        let t606 = t544 * t564 + b_z * t545 + c_z * t546 + unit_db_z * t547
            + unit_dc_z * t548;
        let t607 = t394 * t571 + v_b_x * t398 + v_c_x * t402 - v_unit_db_x * t449
            + v_unit_dc_x * t450;
        let t608 = t394 * t572 + v_b_y * t398 + v_c_y * t402 - v_unit_db_y * t449
            + v_unit_dc_y * t450;
        let t609 = t394 * t573 + v_b_z * t398 + v_c_z * t402 - v_unit_db_z * t449
            + v_unit_dc_z * t450;
        let t610 = t423 * t571 + v_b_x * t424 + v_c_x * t425 - v_unit_db_x * t457
            + v_unit_dc_x * t458;
        let t611 = t423 * t572 + v_b_y * t424 + v_c_y * t425 - v_unit_db_y * t457
            + v_unit_dc_y * t458;
        let t612 = t423 * t573 + v_b_z * t424 + v_c_z * t425 - v_unit_db_z * t457
            + v_unit_dc_z * t458;
        let t613 = t428 * t571 + v_b_x * t429 + v_c_x * t430 - v_unit_db_x * t465
            + v_unit_dc_x * t466;
        let t614 = t428 * t572 + v_b_y * t429 + v_c_y * t430 - v_unit_db_y * t465
            + v_unit_dc_y * t466;
        let t615 = t428 * t573 + v_b_z * t429 + v_c_z * t430 - v_unit_db_z * t465
            + v_unit_dc_z * t466;
        let t616 = v_unit_db_x * t483 - (t480 * t571 + v_b_x * t481 + v_c_x * t482)
            - v_unit_dc_x * t484;
        let t617 = v_unit_db_y * t483 - (t480 * t572 + v_b_y * t481 + v_c_y * t482)
            - v_unit_dc_y * t484;
        let t618 = v_unit_db_z * t483 - (t480 * t573 + v_b_z * t481 + v_c_z * t482)
            - v_unit_dc_z * t484;
        let t619 = t499 * t571 + v_b_x * t500 + v_c_x * t501 - v_unit_db_x * t502
            + v_unit_dc_x * t503;
        let t620 = t499 * t572 + v_b_y * t500 + v_c_y * t501 - v_unit_db_y * t502
            + v_unit_dc_y * t503;
        let t621 = t499 * t573 + v_b_z * t500 + v_c_z * t501 - v_unit_db_z * t502
            + v_unit_dc_z * t503;
        let t622 = t433 * t571 + v_b_x * t434 + v_c_x * t435 + v_unit_db_x * t512
            + v_unit_dc_x * t513;
        let t623 = t433 * t572 + v_b_y * t434 + v_c_y * t435 + v_unit_db_y * t512
            + v_unit_dc_y * t513;
        let t624 = t433 * t573 + v_b_z * t434 + v_c_z * t435 + v_unit_db_z * t512
            + v_unit_dc_z * t513;
        let t625 = t526 * t571 + v_b_x * t527 + v_c_x * t528 - v_unit_db_x * t529
            + v_unit_dc_x * t530;
        let t626 = t526 * t572 + v_b_y * t527 + v_c_y * t528 - v_unit_db_y * t529
            + v_unit_dc_y * t530;
        let t627 = t526 * t573 + v_b_z * t527 + v_c_z * t528 - v_unit_db_z * t529
            + v_unit_dc_z * t530;
        let t628 = t438 * t571 + v_b_x * t439 + v_c_x * t440 - v_unit_db_x * t539
            + v_unit_dc_x * t540;
        let t629 = t438 * t572 + v_b_y * t439 + v_c_y * t440 - v_unit_db_y * t539
            + v_unit_dc_y * t540;
        let t630 = t438 * t573 + v_b_z * t439 + v_c_z * t440 - v_unit_db_z * t539
            + v_unit_dc_z * t540;
        let t631 = t553 * t571 + v_b_x * t554 + v_c_x * t555 - v_unit_db_x * t556
            + v_unit_dc_x * t557;
        let t632 = t553 * t572 + v_b_y * t554 + v_c_y * t555 - v_unit_db_y * t556
            + v_unit_dc_y * t557;
        let t633 = t553 * t573 + v_b_z * t554 + v_c_z * t555 - v_unit_db_z * t556
            + v_unit_dc_z * t557;
        let t634 = t580 + t607;
        let t635 = t581 + t608;
        let t636 = t582 + t609;
        let t637 = a_x * t167 + t225 * t565 + unit_dc_x * t447
            + (v_a_x * t398 + t412 * t574 + v_unit_dc_x * t451);
        let t638 = a_y * t167 + t225 * t566 + unit_dc_y * t447
            + (v_a_y * t398 + t412 * t575 + v_unit_dc_y * t451);
        let t639 = a_z * t167 + t225 * t567 + unit_dc_z * t447
            + (v_a_z * t398 + t412 * t576 + v_unit_dc_z * t451);
        let t640 = a_x * t190 + t251 * t568 + unit_db_x * t448
            + (v_a_x * t402 - t419 * t577 + v_unit_db_x * t452);
        let t641 = a_y * t190 + t251 * t569 + unit_db_y * t448
            + (v_a_y * t402 - t419 * t578 + v_unit_db_y * t452);
        let t642 = a_z * t190 + t251 * t570 + unit_db_z * t448
            + (v_a_z * t402 - t419 * t579 + v_unit_db_z * t452);
        let t643 = a_x * t445 + c_x * t448 + (v_c_x * t452 - v_a_x * t449);
        let t644 = a_y * t445 + c_y * t448 + (v_c_y * t452 - v_a_y * t449);
        let t645 = a_z * t445 + c_z * t448 + (v_c_z * t452 - v_a_z * t449);
        let t646 = a_x * t446 + b_x * t447 + (v_a_x * t450 + v_b_x * t451);
        let t647 = a_y * t446 + b_y * t447 + (v_a_y * t450 + v_b_y * t451);
        let t648 = a_z * t446 + b_z * t447 + (v_a_z * t450 + v_b_z * t451);
        let t649 = t583 + t610;
        let t650 = t584 + t611;
        let t651 = t585 + t612;
        let t652 = a_x * t279 + t301 * t565 + unit_dc_x * t455
            + (v_a_x * t424 + t426 * t574 + v_unit_dc_x * t459);
        let t653 = a_y * t279 + t301 * t566 + unit_dc_y * t455
            + (v_a_y * t424 + t426 * t575 + v_unit_dc_y * t459);
        let t654 = a_z * t279 + t301 * t567 + unit_dc_z * t455
            + (v_a_z * t424 + t426 * t576 + v_unit_dc_z * t459);
        let t655 = a_x * t288 + t310 * t568 + unit_db_x * t456
            + (v_a_x * t425 - t427 * t577 + v_unit_db_x * t460);
        let t656 = a_y * t288 + t310 * t569 + unit_db_y * t456
            + (v_a_y * t425 - t427 * t578 + v_unit_db_y * t460);
        let t657 = a_z * t288 + t310 * t570 + unit_db_z * t456
            + (v_a_z * t425 - t427 * t579 + v_unit_db_z * t460);
        let t658 = a_x * t453 + c_x * t456 + (v_c_x * t460 - v_a_x * t457);
        let t659 = a_y * t453 + c_y * t456 + (v_c_y * t460 - v_a_y * t457);
        let t660 = a_z * t453 + c_z * t456 + (v_c_z * t460 - v_a_z * t457);
        let t661 = a_x * t454 + b_x * t455 + (v_a_x * t458 + v_b_x * t459);
        let t662 = a_y * t454 + b_y * t455 + (v_a_y * t458 + v_b_y * t459);
        let t663 = a_z * t454 + b_z * t455 + (v_a_z * t458 + v_b_z * t459);
        let t664 = t586 + t613;
        let t665 = t587 + t614;
        let t666 = t588 + t615;
        let t667 = a_x * t325 + t345 * t565 + unit_dc_x * t463
            + (v_a_x * t429 + t431 * t574 + v_unit_dc_x * t467);
        let t668 = a_y * t325 + t345 * t566 + unit_dc_y * t463
            + (v_a_y * t429 + t431 * t575 + v_unit_dc_y * t467);
        let t669 = a_z * t325 + t345 * t567 + unit_dc_z * t463
            + (v_a_z * t429 + t431 * t576 + v_unit_dc_z * t467);
        let t670 = a_x * t332 + t354 * t568 + unit_db_x * t464
            + (v_a_x * t430 - t432 * t577 + v_unit_db_x * t468);
        let t671 = a_y * t332 + t354 * t569 + unit_db_y * t464
            + (v_a_y * t430 - t432 * t578 + v_unit_db_y * t468);
        let t672 = a_z * t332 + t354 * t570 + unit_db_z * t464
            + (v_a_z * t430 - t432 * t579 + v_unit_db_z * t468);
        let t673 = a_x * t461 + c_x * t464 + (v_c_x * t468 - v_a_x * t465);
        let t674 = a_y * t461 + c_y * t464 + (v_c_y * t468 - v_a_y * t465);
        let t675 = a_z * t461 + c_z * t464 + (v_c_z * t468 - v_a_z * t465);
        let t676 = a_x * t462 + b_x * t463 + (v_a_x * t466 + v_b_x * t467);
        let t677 = a_y * t462 + b_y * t463 + (v_a_y * t466 + v_b_y * t467);
        let t678 = a_z * t462 + b_z * t463 + (v_a_z * t466 + v_b_z * t467);
        let t679 = t616 - t589;
        let t680 = t617 - t590;
        let t681 = t618 - t591;
        let t682 = a_x * t471 + t476 * t565 + unit_dc_x * t477
            + (v_a_x * t481 + t485 * t574 + v_unit_dc_x * t486);
        let t683 = a_y * t471 + t476 * t566 + unit_dc_y * t477
            + (v_a_y * t481 + t485 * t575 + v_unit_dc_y * t486);
        let t684 = a_z * t471 + t476 * t567 + unit_dc_z * t477
            + (v_a_z * t481 + t485 * t576 + v_unit_dc_z * t486);
        let t685 = t487 * t577 - v_a_x * t482 - v_unit_db_x * t488
            - (a_x * t472 + t478 * t568 + unit_db_x * t479);
        let t686 = t487 * t578 - v_a_y * t482 - v_unit_db_y * t488
            - (a_y * t472 + t478 * t569 + unit_db_y * t479);
        let t687 = t487 * t579 - v_a_z * t482 - v_unit_db_z * t488
            - (a_z * t472 + t478 * t570 + unit_db_z * t479);
        let t688 = v_a_x * t483 - v_c_x * t488 - (a_x * t474 + c_x * t479);
        let t689 = v_a_y * t483 - v_c_y * t488 - (a_y * t474 + c_y * t479);
        let t690 = v_a_z * t483 - v_c_z * t488 - (a_z * t474 + c_z * t479);
        let t691 = a_x * t475 + b_x * t477 + (v_a_x * t484 + v_b_x * t486);
        let t692 = a_y * t475 + b_y * t477 + (v_a_y * t484 + v_b_y * t486);
        let t693 = a_z * t475 + b_z * t477 + (v_a_z * t484 + v_b_z * t486);
        let t694 = t592 + t619;
        let t695 = t593 + t620;
        let t696 = t594 + t621;
        let t697 = a_x * t491 + t495 * t565 + unit_dc_x * t496
            + (v_a_x * t500 + t504 * t574 + v_unit_dc_x * t505);
        let t698 = a_y * t491 + t495 * t566 + unit_dc_y * t496
            + (v_a_y * t500 + t504 * t575 + v_unit_dc_y * t505);
        let t699 = a_z * t491 + t495 * t567 + unit_dc_z * t496
            + (v_a_z * t500 + t504 * t576 + v_unit_dc_z * t505);
        let t700 = a_x * t492 + t497 * t568 + unit_db_x * t498
            + (v_a_x * t501 - t506 * t577 + v_unit_db_x * t507);
        let t701 = a_y * t492 + t497 * t569 + unit_db_y * t498
            + (v_a_y * t501 - t506 * t578 + v_unit_db_y * t507);
        let t702 = a_z * t492 + t497 * t570 + unit_db_z * t498
            + (v_a_z * t501 - t506 * t579 + v_unit_db_z * t507);
        let t703 = a_x * t493 + c_x * t498 + (v_c_x * t507 - v_a_x * t502);
        let t704 = a_y * t493 + c_y * t498 + (v_c_y * t507 - v_a_y * t502);
        let t705 = a_z * t493 + c_z * t498 + (v_c_z * t507 - v_a_z * t502);
        let t706 = a_x * t494 + b_x * t496 + (v_a_x * t503 + v_b_x * t505);
        let t707 = a_y * t494 + b_y * t496 + (v_a_y * t503 + v_b_y * t505);
        let t708 = a_z * t494 + b_z * t496 + (v_a_z * t503 + v_b_z * t505);
        let t709 = t595 + t622;
        let t710 = t596 + t623;
        let t711 = t597 + t624;
        let t712 = a_x * t367 + t369 * t565 + unit_dc_x * t510
            + (v_a_x * t434 + t436 * t574 + v_unit_dc_x * t514);
        let t713 = a_y * t367 + t369 * t566 + unit_dc_y * t510
            + (v_a_y * t434 + t436 * t575 + v_unit_dc_y * t514);
        let t714 = a_z * t367 + t369 * t567 + unit_dc_z * t510
            + (v_a_z * t434 + t436 * t576 + v_unit_dc_z * t514);
        let t715 = a_x * t368 + t375 * t568 + unit_db_x * t511
            + (v_a_x * t435 + t437 * t577 + v_unit_db_x * t515);
        let t716 = a_y * t368 + t375 * t569 + unit_db_y * t511
            + (v_a_y * t435 + t437 * t578 + v_unit_db_y * t515);
        let t717 = a_z * t368 + t375 * t570 + unit_db_z * t511
            + (v_a_z * t435 + t437 * t579 + v_unit_db_z * t515);
        let t718 = a_x * t508 + c_x * t511 + (v_a_x * t512 + v_c_x * t515);
        let t719 = a_y * t508 + c_y * t511 + (v_a_y * t512 + v_c_y * t515);
        let t720 = a_z * t508 + c_z * t511 + (v_a_z * t512 + v_c_z * t515);
        let t721 = a_x * t509 + b_x * t510 + (v_a_x * t513 + v_b_x * t514);
        let t722 = a_y * t509 + b_y * t510 + (v_a_y * t513 + v_b_y * t514);
        let t723 = a_z * t509 + b_z * t510 + (v_a_z * t513 + v_b_z * t514);
        let t724 = t598 + t625;
        let t725 = t599 + t626;
        let t726 = t600 + t627;
        let t727 = a_x * t518 + t522 * t565 + unit_dc_x * t523
            + (v_a_x * t527 + t531 * t574 + v_unit_dc_x * t532);
        let t728 = a_y * t518 + t522 * t566 + unit_dc_y * t523
            + (v_a_y * t527 + t531 * t575 + v_unit_dc_y * t532);
        let t729 = a_z * t518 + t522 * t567 + unit_dc_z * t523
            + (v_a_z * t527 + t531 * t576 + v_unit_dc_z * t532);
        let t730 = a_x * t519 + t524 * t568 + unit_db_x * t525
            + (v_a_x * t528 - t533 * t577 + v_unit_db_x * t534);
        let t731 = a_y * t519 + t524 * t569 + unit_db_y * t525
            + (v_a_y * t528 - t533 * t578 + v_unit_db_y * t534);
        let t732 = a_z * t519 + t524 * t570 + unit_db_z * t525
            + (v_a_z * t528 - t533 * t579 + v_unit_db_z * t534);
        let t733 = a_x * t520 + c_x * t525 + (v_c_x * t534 - v_a_x * t529);
        let t734 = a_y * t520 + c_y * t525 + (v_c_y * t534 - v_a_y * t529);
        let t735 = a_z * t520 + c_z * t525 + (v_c_z * t534 - v_a_z * t529);
        let t736 = a_x * t521 + b_x * t523 + (v_a_x * t530 + v_b_x * t532);
        let t737 = a_y * t521 + b_y * t523 + (v_a_y * t530 + v_b_y * t532);
        let t738 = a_z * t521 + b_z * t523 + (v_a_z * t530 + v_b_z * t532);
        let t739 = t601 + t628;
        let t740 = t602 + t629;
        let t741 = t603 + t630;
        let t742 = a_x * t384 + t386 * t565 + unit_dc_x * t537
            + (v_a_x * t439 + t441 * t574 + v_unit_dc_x * t541);
        let t743 = a_y * t384 + t386 * t566 + unit_dc_y * t537
            + (v_a_y * t439 + t441 * t575 + v_unit_dc_y * t541);
        let t744 = a_z * t384 + t386 * t567 + unit_dc_z * t537
            + (v_a_z * t439 + t441 * t576 + v_unit_dc_z * t541);
        let t745 = a_x * t385 + t387 * t568 + unit_db_x * t538
            + (v_a_x * t440 - t442 * t577 + v_unit_db_x * t542);
        let t746 = a_y * t385 + t387 * t569 + unit_db_y * t538
            + (v_a_y * t440 - t442 * t578 + v_unit_db_y * t542);
        let t747 = a_z * t385 + t387 * t570 + unit_db_z * t538
            + (v_a_z * t440 - t442 * t579 + v_unit_db_z * t542);
        let t748 = a_x * t535 + c_x * t538 + (v_c_x * t542 - v_a_x * t539);
        let t749 = a_y * t535 + c_y * t538 + (v_c_y * t542 - v_a_y * t539);
        let t750 = a_z * t535 + c_z * t538 + (v_c_z * t542 - v_a_z * t539);
        let t751 = a_x * t536 + b_x * t537 + (v_a_x * t540 + v_b_x * t541);
        let t752 = a_y * t536 + b_y * t537 + (v_a_y * t540 + v_b_y * t541);
        let t753 = a_z * t536 + b_z * t537 + (v_a_z * t540 + v_b_z * t541);
        let t754 = t604 + t631;
        let t755 = t605 + t632;
        let t756 = t606 + t633;
        let t757 = a_x * t545 + t549 * t565 + unit_dc_x * t550
            + (v_a_x * t554 + t558 * t574 + v_unit_dc_x * t559);
        let t758 = a_y * t545 + t549 * t566 + unit_dc_y * t550
            + (v_a_y * t554 + t558 * t575 + v_unit_dc_y * t559);
        let t759 = a_z * t545 + t549 * t567 + unit_dc_z * t550
            + (v_a_z * t554 + t558 * t576 + v_unit_dc_z * t559);
        let t760 = a_x * t546 + t551 * t568 + unit_db_x * t552
            + (v_a_x * t555 - t560 * t577 + v_unit_db_x * t561);
        let t761 = a_y * t546 + t551 * t569 + unit_db_y * t552
            + (v_a_y * t555 - t560 * t578 + v_unit_db_y * t561);
        let t762 = a_z * t546 + t551 * t570 + unit_db_z * t552
            + (v_a_z * t555 - t560 * t579 + v_unit_db_z * t561);
        let t763 = a_x * t547 + c_x * t552 + (v_c_x * t561 - v_a_x * t556);
        let t764 = a_y * t547 + c_y * t552 + (v_c_y * t561 - v_a_y * t556);
        let t765 = a_z * t547 + c_z * t552 + (v_c_z * t561 - v_a_z * t556);
        let t766 = a_x * t548 + b_x * t550 + (v_a_x * t557 + v_b_x * t559);
        let t767 = a_y * t548 + b_y * t550 + (v_a_y * t557 + v_b_y * t559);
        let t768 = a_z * t548 + b_z * t550 + (v_a_z * t557 + v_b_z * t559);
        let t769 = t562 * t634 + b_x * t649 + c_x * t664 + unit_db_x * t679
            + unit_dc_x * t694;
        let t770 = t562 * t635 + b_x * t650 + c_x * t665 + unit_db_x * t680
            + unit_dc_x * t695;
        let t771 = t562 * t636 + b_x * t651 + c_x * t666 + unit_db_x * t681
            + unit_dc_x * t696;
        let t772 = t563 * t634 + b_y * t649 + c_y * t664 + unit_db_y * t679
            + unit_dc_y * t694;
        let t773 = t563 * t635 + b_y * t650 + c_y * t665 + unit_db_y * t680
            + unit_dc_y * t695;
        let t774 = t563 * t636 + b_y * t651 + c_y * t666 + unit_db_y * t681
            + unit_dc_y * t696;
        let t775 = t564 * t634 + b_z * t649 + c_z * t664 + unit_db_z * t679
            + unit_dc_z * t694;
        let t776 = t564 * t635 + b_z * t650 + c_z * t665 + unit_db_z * t680
            + unit_dc_z * t695;
        let t777 = t564 * t636 + b_z * t651 + c_z * t666 + unit_db_z * t681
            + unit_dc_z * t696;
        let t778 = t562 * t637 + b_x * t652 + c_x * t667 - unit_db_x * t682
            + unit_dc_x * t697;
        let t779 = t562 * t638 + b_x * t653 + c_x * t668 - unit_db_x * t683
            + unit_dc_x * t698;
        let t780 = t562 * t639 + b_x * t654 + c_x * t669 - unit_db_x * t684
            + unit_dc_x * t699;
        let t781 = t563 * t637 + b_y * t652 + c_y * t667 - unit_db_y * t682
            + unit_dc_y * t697;
        let t782 = t563 * t638 + b_y * t653 + c_y * t668 - unit_db_y * t683
            + unit_dc_y * t698;
        let t783 = t563 * t639 + b_y * t654 + c_y * t669 - unit_db_y * t684
            + unit_dc_y * t699;
        let t784 = t564 * t637 + b_z * t652 + c_z * t667 - unit_db_z * t682
            + unit_dc_z * t697;
        let t785 = t564 * t638 + b_z * t653 + c_z * t668 - unit_db_z * t683
            + unit_dc_z * t698;
        let t786 = t564 * t639 + b_z * t654 + c_z * t669 - unit_db_z * t684
            + unit_dc_z * t699;
        let t787 = t562 * t640 + b_x * t655 + c_x * t670 + unit_db_x * t685
            + unit_dc_x * t700;
        let t788 = t562 * t641 + b_x * t656 + c_x * t671 + unit_db_x * t686
            + unit_dc_x * t701;
        let t789 = t562 * t642 + b_x * t657 + c_x * t672 + unit_db_x * t687
            + unit_dc_x * t702;
        let t790 = t563 * t640 + b_y * t655 + c_y * t670 + unit_db_y * t685
            + unit_dc_y * t700;
        let t791 = t563 * t641 + b_y * t656 + c_y * t671 + unit_db_y * t686
            + unit_dc_y * t701;
        let t792 = t563 * t642 + b_y * t657 + c_y * t672 + unit_db_y * t687
            + unit_dc_y * t702;
        let t793 = t564 * t640 + b_z * t655 + c_z * t670 + unit_db_z * t685
            + unit_dc_z * t700;
        let t794 = t564 * t641 + b_z * t656 + c_z * t671 + unit_db_z * t686
            + unit_dc_z * t701;
        let t795 = t564 * t642 + b_z * t657 + c_z * t672 + unit_db_z * t687
            + unit_dc_z * t702;
        let t796 = t562 * t643 + b_x * t658 + c_x * t673 + unit_db_x * t688
            + unit_dc_x * t703;
        let t797 = t562 * t644 + b_x * t659 + c_x * t674 + unit_db_x * t689
            + unit_dc_x * t704;
        let t798 = t562 * t645 + b_x * t660 + c_x * t675 + unit_db_x * t690
            + unit_dc_x * t705;
        let t799 = t563 * t643 + b_y * t658 + c_y * t673 + unit_db_y * t688
            + unit_dc_y * t703;
        let t800 = t563 * t644 + b_y * t659 + c_y * t674 + unit_db_y * t689
            + unit_dc_y * t704;
        let t801 = t563 * t645 + b_y * t660 + c_y * t675 + unit_db_y * t690
            + unit_dc_y * t705;
        let t802 = t564 * t643 + b_z * t658 + c_z * t673 + unit_db_z * t688
            + unit_dc_z * t703;
        let t803 = t564 * t644 + b_z * t659 + c_z * t674 + unit_db_z * t689
            + unit_dc_z * t704;
        let t804 = t564 * t645 + b_z * t660 + c_z * t675 + unit_db_z * t690
            + unit_dc_z * t705;
        let t805 = t562 * t646 + b_x * t661 + c_x * t676 - unit_db_x * t691
            + unit_dc_x * t706;
        let t806 = t562 * t647 + b_x * t662 + c_x * t677 - unit_db_x * t692
            + unit_dc_x * t707;
        let t807 = t562 * t648 + b_x * t663 + c_x * t678 - unit_db_x * t693
            + unit_dc_x * t708;
        let t808 = t563 * t646 + b_y * t661 + c_y * t676 - unit_db_y * t691
            + unit_dc_y * t706;
        let t809 = t563 * t647 + b_y * t662 + c_y * t677 - unit_db_y * t692
            + unit_dc_y * t707;
        let t810 = t563 * t648 + b_y * t663 + c_y * t678 - unit_db_y * t693
            + unit_dc_y * t708;
        let t811 = t564 * t646 + b_z * t661 + c_z * t676 - unit_db_z * t691
            + unit_dc_z * t706;
        let t812 = t564 * t647 + b_z * t662 + c_z * t677 - unit_db_z * t692
            + unit_dc_z * t707;
        let t813 = t564 * t648 + b_z * t663 + c_z * t678 - unit_db_z * t693
            + unit_dc_z * t708;
        let t814 = 2.0 * (t116 * t121 + t125 * t126 + t129 * t130);
        let t815 = 2.0 * (t116 * t215 - t125 * t216 - t129 * t214);
        let t816 = 2.0 * (t116 * t244 + t125 * t243);
        let t817 = t394 * t562 + b_x * t398 + c_x * t402 - unit_db_x * t449
            + unit_dc_x * t450;
        let t818 = t394 * t563 + b_y * t398 + c_y * t402 - unit_db_y * t449
            + unit_dc_y * t450;
        let t819 = t394 * t564 + b_z * t398 + c_z * t402 - unit_db_z * t449
            + unit_dc_z * t450;
        let t820 = a_x * t398 + t412 * t565 + unit_dc_x * t451;
        let t821 = a_y * t398 + t412 * t566 + unit_dc_y * t451;
        let t822 = a_z * t398 + t412 * t567 + unit_dc_z * t451;
        let t823 = a_x * t402 - t419 * t568 + unit_db_x * t452;
        let t824 = a_y * t402 - t419 * t569 + unit_db_y * t452;
        let t825 = a_z * t402 - t419 * t570 + unit_db_z * t452;
        let t826 = c_x * t452 - a_x * t449;
        let t827 = c_y * t452 - a_y * t449;
        let t828 = c_z * t452 - a_z * t449;
        let t829 = a_x * t450 + b_x * t451;
        let t830 = a_y * t450 + b_y * t451;
        let t831 = a_z * t450 + b_z * t451;
        let t832 = t423 * t562 + b_x * t424 + c_x * t425 - unit_db_x * t457
            + unit_dc_x * t458;
        let t833 = t423 * t563 + b_y * t424 + c_y * t425 - unit_db_y * t457
            + unit_dc_y * t458;
        let t834 = t423 * t564 + b_z * t424 + c_z * t425 - unit_db_z * t457
            + unit_dc_z * t458;
        let t835 = a_x * t424 + t426 * t565 + unit_dc_x * t459;
        let t836 = a_y * t424 + t426 * t566 + unit_dc_y * t459;
        let t837 = a_z * t424 + t426 * t567 + unit_dc_z * t459;
        let t838 = a_x * t425 - t427 * t568 + unit_db_x * t460;
        let t839 = a_y * t425 - t427 * t569 + unit_db_y * t460;
        let t840 = a_z * t425 - t427 * t570 + unit_db_z * t460;
        let t841 = c_x * t460 - a_x * t457;
        let t842 = c_y * t460 - a_y * t457;
        let t843 = c_z * t460 - a_z * t457;
        let t844 = a_x * t458 + b_x * t459;
        let t845 = a_y * t458 + b_y * t459;
        let t846 = a_z * t458 + b_z * t459;
        let t847 = t428 * t562 + b_x * t429 + c_x * t430 - unit_db_x * t465
            + unit_dc_x * t466;
        let t848 = t428 * t563 + b_y * t429 + c_y * t430 - unit_db_y * t465
            + unit_dc_y * t466;
        let t849 = t428 * t564 + b_z * t429 + c_z * t430 - unit_db_z * t465
            + unit_dc_z * t466;
        let t850 = a_x * t429 + t431 * t565 + unit_dc_x * t467;
        let t851 = a_y * t429 + t431 * t566 + unit_dc_y * t467;
        let t852 = a_z * t429 + t431 * t567 + unit_dc_z * t467;
        let t853 = a_x * t430 - t432 * t568 + unit_db_x * t468;
        let t854 = a_y * t430 - t432 * t569 + unit_db_y * t468;
        let t855 = a_z * t430 - t432 * t570 + unit_db_z * t468;
        let t856 = c_x * t468 - a_x * t465;
        let t857 = c_y * t468 - a_y * t465;
        let t858 = c_z * t468 - a_z * t465;
        let t859 = a_x * t466 + b_x * t467;
        let t860 = a_y * t466 + b_y * t467;
        let t861 = a_z * t466 + b_z * t467;
        let t862 = unit_db_x * t483 - (t480 * t562 + b_x * t481 + c_x * t482)
            - unit_dc_x * t484;
        let t863 = unit_db_y * t483 - (t480 * t563 + b_y * t481 + c_y * t482)
            - unit_dc_y * t484;
        let t864 = unit_db_z * t483 - (t480 * t564 + b_z * t481 + c_z * t482)
            - unit_dc_z * t484;
        let t865 = a_x * t481 + t485 * t565 + unit_dc_x * t486;
        let t866 = a_y * t481 + t485 * t566 + unit_dc_y * t486;
        let t867 = a_z * t481 + t485 * t567 + unit_dc_z * t486;
        let t868 = t487 * t568 - a_x * t482 - unit_db_x * t488;
        let t869 = t487 * t569 - a_y * t482 - unit_db_y * t488;
        let t870 = t487 * t570 - a_z * t482 - unit_db_z * t488;
        let t871 = a_x * t483 - c_x * t488;
        let t872 = a_y * t483 - c_y * t488;
        let t873 = a_z * t483 - c_z * t488;
        let t874 = a_x * t484 + b_x * t486;
        let t875 = a_y * t484 + b_y * t486;
        let t876 = a_z * t484 + b_z * t486;
        let t877 = t499 * t562 + b_x * t500 + c_x * t501 - unit_db_x * t502
            + unit_dc_x * t503;
        let t878 = t499 * t563 + b_y * t500 + c_y * t501 - unit_db_y * t502
            + unit_dc_y * t503;
        let t879 = t499 * t564 + b_z * t500 + c_z * t501 - unit_db_z * t502
            + unit_dc_z * t503;
        let t880 = a_x * t500 + t504 * t565 + unit_dc_x * t505;
        let t881 = a_y * t500 + t504 * t566 + unit_dc_y * t505;
        let t882 = a_z * t500 + t504 * t567 + unit_dc_z * t505;
        let t883 = a_x * t501 - t506 * t568 + unit_db_x * t507;
        let t884 = a_y * t501 - t506 * t569 + unit_db_y * t507;
        let t885 = a_z * t501 - t506 * t570 + unit_db_z * t507;
        let t886 = c_x * t507 - a_x * t502;
        let t887 = c_y * t507 - a_y * t502;
        let t888 = c_z * t507 - a_z * t502;
        let t889 = a_x * t503 + b_x * t505;
        let t890 = a_y * t503 + b_y * t505;
        let t891 = a_z * t503 + b_z * t505;
        let t892 = a_x * t434 + t436 * t565 + unit_dc_x * t514;
        let t893 = a_y * t434 + t436 * t566 + unit_dc_y * t514;
        let t894 = a_z * t434 + t436 * t567 + unit_dc_z * t514;
        let t895 = a_x * t435 + t437 * t568 + unit_db_x * t515;
        let t896 = a_y * t435 + t437 * t569 + unit_db_y * t515;
        let t897 = a_z * t435 + t437 * t570 + unit_db_z * t515;
        let t898 = a_x * t512 + c_x * t515;
        let t899 = a_y * t512 + c_y * t515;
        let t900 = a_z * t512 + c_z * t515;
        let t901 = a_x * t513 + b_x * t514;
        let t902 = a_y * t513 + b_y * t514;
        let t903 = a_z * t513 + b_z * t514;
        let t904 = a_x * t527 + t531 * t565 + unit_dc_x * t532;
        let t905 = a_y * t527 + t531 * t566 + unit_dc_y * t532;
        let t906 = a_z * t527 + t531 * t567 + unit_dc_z * t532;
        let t907 = a_x * t528 - t533 * t568 + unit_db_x * t534;
        let t908 = a_y * t528 - t533 * t569 + unit_db_y * t534;
        let t909 = a_z * t528 - t533 * t570 + unit_db_z * t534;
        let t910 = c_x * t534 - a_x * t529;
        let t911 = c_y * t534 - a_y * t529;
        let t912 = c_z * t534 - a_z * t529;
        let t913 = a_x * t530 + b_x * t532;
        let t914 = a_y * t530 + b_y * t532;
        let t915 = a_z * t530 + b_z * t532;
        let t916 = a_x * t440 - t442 * t568 + unit_db_x * t542;
        let t917 = a_y * t440 - t442 * t569 + unit_db_y * t542;
        let t918 = a_z * t440 - t442 * t570 + unit_db_z * t542;
        let t919 = a_x * t540 + b_x * t541;
        let t920 = a_y * t540 + b_y * t541;
        let t921 = a_z * t540 + b_z * t541;
        let t922 = a_x * t554 + t558 * t565 + unit_dc_x * t559;
        let t923 = a_y * t554 + t558 * t566 + unit_dc_y * t559;
        let t924 = a_z * t554 + t558 * t567 + unit_dc_z * t559;
        let t925 = a_x * t555 - t560 * t568 + unit_db_x * t561;
        let t926 = a_y * t555 - t560 * t569 + unit_db_y * t561;
        let t927 = a_z * t555 - t560 * t570 + unit_db_z * t561;
        let t928 = c_x * t561 - a_x * t556;
        let t929 = c_y * t561 - a_y * t556;
        let t930 = c_z * t561 - a_z * t556;
        let t931 = a_x * t557 + b_x * t559;
        let t932 = a_y * t557 + b_y * t559;
        let t933 = a_z * t557 + b_z * t559;
        let t934 = t562 * t817 + b_x * t832 + c_x * t847 + unit_db_x * t862
            + unit_dc_x * t877;
        let t935 = t562 * t818 + b_x * t833 + c_x * t848 + unit_db_x * t863
            + unit_dc_x * t878;
        let t936 = t562 * t819 + b_x * t834 + c_x * t849 + unit_db_x * t864
            + unit_dc_x * t879;
        let t937 = t563 * t817 + b_y * t832 + c_y * t847 + unit_db_y * t862
            + unit_dc_y * t877;
        let t938 = t563 * t818 + b_y * t833 + c_y * t848 + unit_db_y * t863
            + unit_dc_y * t878;
        let t939 = t563 * t819 + b_y * t834 + c_y * t849 + unit_db_y * t864
            + unit_dc_y * t879;
        let t940 = t564 * t817 + b_z * t832 + c_z * t847 + unit_db_z * t862
            + unit_dc_z * t877;
        let t941 = t564 * t818 + b_z * t833 + c_z * t848 + unit_db_z * t863
            + unit_dc_z * t878;
        let t942 = t564 * t819 + b_z * t834 + c_z * t849 + unit_db_z * t864
            + unit_dc_z * t879;
        let t943 = t562 * t820 + b_x * t835 + c_x * t850 - unit_db_x * t865
            + unit_dc_x * t880;
        let t944 = t562 * t821 + b_x * t836 + c_x * t851 - unit_db_x * t866
            + unit_dc_x * t881;
        let t945 = t562 * t822 + b_x * t837 + c_x * t852 - unit_db_x * t867
            + unit_dc_x * t882;
        let t946 = t563 * t820 + b_y * t835 + c_y * t850 - unit_db_y * t865
            + unit_dc_y * t880;
        let t947 = t563 * t821 + b_y * t836 + c_y * t851 - unit_db_y * t866
            + unit_dc_y * t881;
        let t948 = t563 * t822 + b_y * t837 + c_y * t852 - unit_db_y * t867
            + unit_dc_y * t882;
        let t949 = t564 * t820 + b_z * t835 + c_z * t850 - unit_db_z * t865
            + unit_dc_z * t880;
        let t950 = t564 * t821 + b_z * t836 + c_z * t851 - unit_db_z * t866
            + unit_dc_z * t881;
        let t951 = t564 * t822 + b_z * t837 + c_z * t852 - unit_db_z * t867
            + unit_dc_z * t882;
        let t952 = t562 * t823 + b_x * t838 + c_x * t853 + unit_db_x * t868
            + unit_dc_x * t883;
        let t953 = t562 * t824 + b_x * t839 + c_x * t854 + unit_db_x * t869
            + unit_dc_x * t884;
        let t954 = t562 * t825 + b_x * t840 + c_x * t855 + unit_db_x * t870
            + unit_dc_x * t885;
        let t955 = t563 * t823 + b_y * t838 + c_y * t853 + unit_db_y * t868
            + unit_dc_y * t883;
        let t956 = t563 * t824 + b_y * t839 + c_y * t854 + unit_db_y * t869
            + unit_dc_y * t884;
        let t957 = t563 * t825 + b_y * t840 + c_y * t855 + unit_db_y * t870
            + unit_dc_y * t885;
        let t958 = t564 * t823 + b_z * t838 + c_z * t853 + unit_db_z * t868
            + unit_dc_z * t883;
        let t959 = t564 * t824 + b_z * t839 + c_z * t854 + unit_db_z * t869
            + unit_dc_z * t884;
        let t960 = t564 * t825 + b_z * t840 + c_z * t855 + unit_db_z * t870
            + unit_dc_z * t885;
        let t961 = t562 * t826 + b_x * t841 + c_x * t856 + unit_db_x * t871
            + unit_dc_x * t886;
        let t962 = t562 * t827 + b_x * t842 + c_x * t857 + unit_db_x * t872
            + unit_dc_x * t887;
        let t963 = t562 * t828 + b_x * t843 + c_x * t858 + unit_db_x * t873
            + unit_dc_x * t888;
        let t964 = t563 * t826 + b_y * t841 + c_y * t856 + unit_db_y * t871
            + unit_dc_y * t886;
        let t965 = t563 * t827 + b_y * t842 + c_y * t857 + unit_db_y * t872
            + unit_dc_y * t887;
        let t966 = t563 * t828 + b_y * t843 + c_y * t858 + unit_db_y * t873
            + unit_dc_y * t888;
        let t967 = t564 * t826 + b_z * t841 + c_z * t856 + unit_db_z * t871
            + unit_dc_z * t886;
        let t968 = t564 * t827 + b_z * t842 + c_z * t857 + unit_db_z * t872
            + unit_dc_z * t887;
        let t969 = t564 * t828 + b_z * t843 + c_z * t858 + unit_db_z * t873
            + unit_dc_z * t888;
        let t970 = t562 * t829 + b_x * t844 + c_x * t859 - unit_db_x * t874
            + unit_dc_x * t889;
        let t971 = t562 * t830 + b_x * t845 + c_x * t860 - unit_db_x * t875
            + unit_dc_x * t890;
        let t972 = t562 * t831 + b_x * t846 + c_x * t861 - unit_db_x * t876
            + unit_dc_x * t891;
        let t973 = t563 * t829 + b_y * t844 + c_y * t859 - unit_db_y * t874
            + unit_dc_y * t889;
        let t974 = t563 * t830 + b_y * t845 + c_y * t860 - unit_db_y * t875
            + unit_dc_y * t890;
        let t975 = t563 * t831 + b_y * t846 + c_y * t861 - unit_db_y * t876
            + unit_dc_y * t891;
        let t976 = t564 * t829 + b_z * t844 + c_z * t859 - unit_db_z * t874
            + unit_dc_z * t889;
        let t977 = t564 * t830 + b_z * t845 + c_z * t860 - unit_db_z * t875
            + unit_dc_z * t890;
        let t978 = t564 * t831 + b_z * t846 + c_z * t861 - unit_db_z * t876
            + unit_dc_z * t891;
        stiffness[0][0] = t769 + t814;
        stiffness[0][1] = t770;
        stiffness[0][2] = t771;
        stiffness[0][3] = t772;
        stiffness[0][4] = t773 + t814;
        stiffness[0][5] = t774;
        stiffness[0][6] = t775;
        stiffness[0][7] = t776;
        stiffness[0][8] = t777 + t814;
        stiffness[1][0] = t443 + t778;
        stiffness[1][1] = t779;
        stiffness[1][2] = t780;
        stiffness[1][3] = t781;
        stiffness[1][4] = t443 + t782;
        stiffness[1][5] = t783;
        stiffness[1][6] = t784;
        stiffness[1][7] = t785;
        stiffness[1][8] = t443 + t786;
        stiffness[2][0] = t796 - t469;
        stiffness[2][1] = t797;
        stiffness[2][2] = t798;
        stiffness[2][3] = t799;
        stiffness[2][4] = t800 - t469;
        stiffness[2][5] = t801;
        stiffness[2][6] = t802;
        stiffness[2][7] = t803;
        stiffness[2][8] = t804 - t469;
        stiffness[3][0] = t444 + t787;
        stiffness[3][1] = t788;
        stiffness[3][2] = t789;
        stiffness[3][3] = t790;
        stiffness[3][4] = t444 + t791;
        stiffness[3][5] = t792;
        stiffness[3][6] = t793;
        stiffness[3][7] = t794;
        stiffness[3][8] = t444 + t795;
        stiffness[4][0] = t489 + t805;
        stiffness[4][1] = t806;
        stiffness[4][2] = t807;
        stiffness[4][3] = t808;
        stiffness[4][4] = t489 + t809;
        stiffness[4][5] = t810;
        stiffness[4][6] = t811;
        stiffness[4][7] = t812;
        stiffness[4][8] = t489 + t813;
        stiffness[5][0] = t443 + (a_x * t649 + t565 * t709 + unit_dc_x * t724);
        stiffness[5][1] = a_x * t650 + t565 * t710 + unit_dc_x * t725;
        stiffness[5][2] = a_x * t651 + t565 * t711 + unit_dc_x * t726;
        stiffness[5][3] = a_y * t649 + t566 * t709 + unit_dc_y * t724;
        stiffness[5][4] = t443 + (a_y * t650 + t566 * t710 + unit_dc_y * t725);
        stiffness[5][5] = a_y * t651 + t566 * t711 + unit_dc_y * t726;
        stiffness[5][6] = a_z * t649 + t567 * t709 + unit_dc_z * t724;
        stiffness[5][7] = a_z * t650 + t567 * t710 + unit_dc_z * t725;
        stiffness[5][8] = t443 + (a_z * t651 + t567 * t711 + unit_dc_z * t726);
        stiffness[6][0] = a_x * t679 + c_x * t754 - t469;
        stiffness[6][1] = a_x * t680 + c_x * t755;
        stiffness[6][2] = a_x * t681 + c_x * t756;
        stiffness[6][3] = a_y * t679 + c_y * t754;
        stiffness[6][4] = a_y * t680 + c_y * t755 - t469;
        stiffness[6][5] = a_y * t681 + c_y * t756;
        stiffness[6][6] = a_z * t679 + c_z * t754;
        stiffness[6][7] = a_z * t680 + c_z * t755;
        stiffness[6][8] = a_z * t681 + c_z * t756 - t469;
        stiffness[7][0] = a_x * t652 + t565 * t712 + unit_dc_x * t727 + t815;
        stiffness[7][1] = a_x * t653 + t565 * t713 + unit_dc_x * t728;
        stiffness[7][2] = a_x * t654 + t565 * t714 + unit_dc_x * t729;
        stiffness[7][3] = a_y * t652 + t566 * t712 + unit_dc_y * t727;
        stiffness[7][4] = a_y * t653 + t566 * t713 + unit_dc_y * t728 + t815;
        stiffness[7][5] = a_y * t654 + t566 * t714 + unit_dc_y * t729;
        stiffness[7][6] = a_z * t652 + t567 * t712 + unit_dc_z * t727;
        stiffness[7][7] = a_z * t653 + t567 * t713 + unit_dc_z * t728;
        stiffness[7][8] = a_z * t654 + t567 * t714 + unit_dc_z * t729 + t815;
        stiffness[8][0] = a_x * t658 + t565 * t718 + unit_dc_x * t733;
        stiffness[8][1] = a_x * t659 + t565 * t719 + unit_dc_x * t734;
        stiffness[8][2] = a_x * t660 + t565 * t720 + unit_dc_x * t735;
        stiffness[8][3] = a_y * t658 + t566 * t718 + unit_dc_y * t733;
        stiffness[8][4] = a_y * t659 + t566 * t719 + unit_dc_y * t734;
        stiffness[8][5] = a_y * t660 + t566 * t720 + unit_dc_y * t735;
        stiffness[8][6] = a_z * t658 + t567 * t718 + unit_dc_z * t733;
        stiffness[8][7] = a_z * t659 + t567 * t719 + unit_dc_z * t734;
        stiffness[8][8] = a_z * t660 + t567 * t720 + unit_dc_z * t735;
        stiffness[9][0] = c_x * t757 - a_x * t682;
        stiffness[9][1] = c_x * t758 - a_x * t683;
        stiffness[9][2] = c_x * t759 - a_x * t684;
        stiffness[9][3] = c_y * t757 - a_y * t682;
        stiffness[9][4] = c_y * t758 - a_y * t683;
        stiffness[9][5] = c_y * t759 - a_y * t684;
        stiffness[9][6] = c_z * t757 - a_z * t682;
        stiffness[9][7] = c_z * t758 - a_z * t683;
        stiffness[9][8] = c_z * t759 - a_z * t684;
        stiffness[10][0] = a_x * t688 + c_x * t763;
        stiffness[10][1] = a_x * t689 + c_x * t764;
        stiffness[10][2] = a_x * t690 + c_x * t765;
        stiffness[10][3] = a_y * t688 + c_y * t763;
        stiffness[10][4] = a_y * t689 + c_y * t764;
        stiffness[10][5] = a_y * t690 + c_y * t765;
        stiffness[10][6] = a_z * t688 + c_z * t763;
        stiffness[10][7] = a_z * t689 + c_z * t764;
        stiffness[10][8] = a_z * t690 + c_z * t765;
        stiffness[11][0] = a_x * t655 + t565 * t715 + unit_dc_x * t730;
        stiffness[11][1] = a_x * t656 + t565 * t716 + unit_dc_x * t731;
        stiffness[11][2] = a_x * t657 + t565 * t717 + unit_dc_x * t732;
        stiffness[11][3] = a_y * t655 + t566 * t715 + unit_dc_y * t730;
        stiffness[11][4] = a_y * t656 + t566 * t716 + unit_dc_y * t731;
        stiffness[11][5] = a_y * t657 + t566 * t717 + unit_dc_y * t732;
        stiffness[11][6] = a_z * t655 + t567 * t715 + unit_dc_z * t730;
        stiffness[11][7] = a_z * t656 + t567 * t716 + unit_dc_z * t731;
        stiffness[11][8] = a_z * t657 + t567 * t717 + unit_dc_z * t732;
        stiffness[12][0] = t516 + (a_x * t661 + t565 * t721 + unit_dc_x * t736);
        stiffness[12][1] = a_x * t662 + t565 * t722 + unit_dc_x * t737;
        stiffness[12][2] = a_x * t663 + t565 * t723 + unit_dc_x * t738;
        stiffness[12][3] = a_y * t661 + t566 * t721 + unit_dc_y * t736;
        stiffness[12][4] = t516 + (a_y * t662 + t566 * t722 + unit_dc_y * t737);
        stiffness[12][5] = a_y * t663 + t566 * t723 + unit_dc_y * t738;
        stiffness[12][6] = a_z * t661 + t567 * t721 + unit_dc_z * t736;
        stiffness[12][7] = a_z * t662 + t567 * t722 + unit_dc_z * t737;
        stiffness[12][8] = t516 + (a_z * t663 + t567 * t723 + unit_dc_z * t738);
        stiffness[13][0] = t543 + (a_x * t685 + c_x * t760);
        stiffness[13][1] = a_x * t686 + c_x * t761;
        stiffness[13][2] = a_x * t687 + c_x * t762;
        stiffness[13][3] = a_y * t685 + c_y * t760;
        stiffness[13][4] = t543 + (a_y * t686 + c_y * t761);
        stiffness[13][5] = a_y * t687 + c_y * t762;
        stiffness[13][6] = a_z * t685 + c_z * t760;
        stiffness[13][7] = a_z * t686 + c_z * t761;
        stiffness[13][8] = t543 + (a_z * t687 + c_z * t762);
        stiffness[14][0] = c_x * t766 - a_x * t691;
        stiffness[14][1] = c_x * t767 - a_x * t692;
        stiffness[14][2] = c_x * t768 - a_x * t693;
        stiffness[14][3] = c_y * t766 - a_y * t691;
        stiffness[14][4] = c_y * t767 - a_y * t692;
        stiffness[14][5] = c_y * t768 - a_y * t693;
        stiffness[14][6] = c_z * t766 - a_z * t691;
        stiffness[14][7] = c_z * t767 - a_z * t692;
        stiffness[14][8] = c_z * t768 - a_z * t693;
        stiffness[15][0] = t444 + (a_x * t664 + t568 * t739 + unit_db_x * t754);
        stiffness[15][1] = a_x * t665 + t568 * t740 + unit_db_x * t755;
        stiffness[15][2] = a_x * t666 + t568 * t741 + unit_db_x * t756;
        stiffness[15][3] = a_y * t664 + t569 * t739 + unit_db_y * t754;
        stiffness[15][4] = t444 + (a_y * t665 + t569 * t740 + unit_db_y * t755);
        stiffness[15][5] = a_y * t666 + t569 * t741 + unit_db_y * t756;
        stiffness[15][6] = a_z * t664 + t570 * t739 + unit_db_z * t754;
        stiffness[15][7] = a_z * t665 + t570 * t740 + unit_db_z * t755;
        stiffness[15][8] = t444 + (a_z * t666 + t570 * t741 + unit_db_z * t756);
        stiffness[16][0] = t489 + (a_x * t694 + b_x * t724);
        stiffness[16][1] = a_x * t695 + b_x * t725;
        stiffness[16][2] = a_x * t696 + b_x * t726;
        stiffness[16][3] = a_y * t694 + b_y * t724;
        stiffness[16][4] = t489 + (a_y * t695 + b_y * t725);
        stiffness[16][5] = a_y * t696 + b_y * t726;
        stiffness[16][6] = a_z * t694 + b_z * t724;
        stiffness[16][7] = a_z * t695 + b_z * t725;
        stiffness[16][8] = t489 + (a_z * t696 + b_z * t726);
        stiffness[17][0] = a_x * t667 + t568 * t742 + unit_db_x * t757;
        stiffness[17][1] = a_x * t668 + t568 * t743 + unit_db_x * t758;
        stiffness[17][2] = a_x * t669 + t568 * t744 + unit_db_x * t759;
        stiffness[17][3] = a_y * t667 + t569 * t742 + unit_db_y * t757;
        stiffness[17][4] = a_y * t668 + t569 * t743 + unit_db_y * t758;
        stiffness[17][5] = a_y * t669 + t569 * t744 + unit_db_y * t759;
        stiffness[17][6] = a_z * t667 + t570 * t742 + unit_db_z * t757;
        stiffness[17][7] = a_z * t668 + t570 * t743 + unit_db_z * t758;
        stiffness[17][8] = a_z * t669 + t570 * t744 + unit_db_z * t759;
        stiffness[18][0] = t543 + (a_x * t673 + t568 * t748 + unit_db_x * t763);
        stiffness[18][1] = a_x * t674 + t568 * t749 + unit_db_x * t764;
        stiffness[18][2] = a_x * t675 + t568 * t750 + unit_db_x * t765;
        stiffness[18][3] = a_y * t673 + t569 * t748 + unit_db_y * t763;
        stiffness[18][4] = t543 + (a_y * t674 + t569 * t749 + unit_db_y * t764);
        stiffness[18][5] = a_y * t675 + t569 * t750 + unit_db_y * t765;
        stiffness[18][6] = a_z * t673 + t570 * t748 + unit_db_z * t763;
        stiffness[18][7] = a_z * t674 + t570 * t749 + unit_db_z * t764;
        stiffness[18][8] = t543 + (a_z * t675 + t570 * t750 + unit_db_z * t765);
        stiffness[19][0] = t516 + (a_x * t697 + b_x * t727);
        stiffness[19][1] = a_x * t698 + b_x * t728;
        stiffness[19][2] = a_x * t699 + b_x * t729;
        stiffness[19][3] = a_y * t697 + b_y * t727;
        stiffness[19][4] = t516 + (a_y * t698 + b_y * t728);
        stiffness[19][5] = a_y * t699 + b_y * t729;
        stiffness[19][6] = a_z * t697 + b_z * t727;
        stiffness[19][7] = a_z * t698 + b_z * t728;
        stiffness[19][8] = t516 + (a_z * t699 + b_z * t729);
        stiffness[20][0] = a_x * t703 + b_x * t733;
        stiffness[20][1] = a_x * t704 + b_x * t734;
        stiffness[20][2] = a_x * t705 + b_x * t735;
        stiffness[20][3] = a_y * t703 + b_y * t733;
        stiffness[20][4] = a_y * t704 + b_y * t734;
        stiffness[20][5] = a_y * t705 + b_y * t735;
        stiffness[20][6] = a_z * t703 + b_z * t733;
        stiffness[20][7] = a_z * t704 + b_z * t734;
        stiffness[20][8] = a_z * t705 + b_z * t735;
        stiffness[21][0] = a_x * t670 + t568 * t745 + unit_db_x * t760 + t816;
        stiffness[21][1] = a_x * t671 + t568 * t746 + unit_db_x * t761;
        stiffness[21][2] = a_x * t672 + t568 * t747 + unit_db_x * t762;
        stiffness[21][3] = a_y * t670 + t569 * t745 + unit_db_y * t760;
        stiffness[21][4] = a_y * t671 + t569 * t746 + unit_db_y * t761 + t816;
        stiffness[21][5] = a_y * t672 + t569 * t747 + unit_db_y * t762;
        stiffness[21][6] = a_z * t670 + t570 * t745 + unit_db_z * t760;
        stiffness[21][7] = a_z * t671 + t570 * t746 + unit_db_z * t761;
        stiffness[21][8] = a_z * t672 + t570 * t747 + unit_db_z * t762 + t816;
        stiffness[22][0] = a_x * t676 + t568 * t751 + unit_db_x * t766;
        stiffness[22][1] = a_x * t677 + t568 * t752 + unit_db_x * t767;
        stiffness[22][2] = a_x * t678 + t568 * t753 + unit_db_x * t768;
        stiffness[22][3] = a_y * t676 + t569 * t751 + unit_db_y * t766;
        stiffness[22][4] = a_y * t677 + t569 * t752 + unit_db_y * t767;
        stiffness[22][5] = a_y * t678 + t569 * t753 + unit_db_y * t768;
        stiffness[22][6] = a_z * t676 + t570 * t751 + unit_db_z * t766;
        stiffness[22][7] = a_z * t677 + t570 * t752 + unit_db_z * t767;
        stiffness[22][8] = a_z * t678 + t570 * t753 + unit_db_z * t768;
        stiffness[23][0] = a_x * t700 + b_x * t730;
        stiffness[23][1] = a_x * t701 + b_x * t731;
        stiffness[23][2] = a_x * t702 + b_x * t732;
        stiffness[23][3] = a_y * t700 + b_y * t730;
        stiffness[23][4] = a_y * t701 + b_y * t731;
        stiffness[23][5] = a_y * t702 + b_y * t732;
        stiffness[23][6] = a_z * t700 + b_z * t730;
        stiffness[23][7] = a_z * t701 + b_z * t731;
        stiffness[23][8] = a_z * t702 + b_z * t732;
        stiffness[24][0] = a_x * t706 + b_x * t736;
        stiffness[24][1] = a_x * t707 + b_x * t737;
        stiffness[24][2] = a_x * t708 + b_x * t738;
        stiffness[24][3] = a_y * t706 + b_y * t736;
        stiffness[24][4] = a_y * t707 + b_y * t737;
        stiffness[24][5] = a_y * t708 + b_y * t738;
        stiffness[24][6] = a_z * t706 + b_z * t736;
        stiffness[24][7] = a_z * t707 + b_z * t737;
        stiffness[24][8] = a_z * t708 + b_z * t738;
        damping_matrix[0][0] = t934;
        damping_matrix[0][1] = t935;
        damping_matrix[0][2] = t936;
        damping_matrix[0][3] = t937;
        damping_matrix[0][4] = t938;
        damping_matrix[0][5] = t939;
        damping_matrix[0][6] = t940;
        damping_matrix[0][7] = t941;
        damping_matrix[0][8] = t942;
        damping_matrix[1][0] = t943;
        damping_matrix[1][1] = t944;
        damping_matrix[1][2] = t945;
        damping_matrix[1][3] = t946;
        damping_matrix[1][4] = t947;
        damping_matrix[1][5] = t948;
        damping_matrix[1][6] = t949;
        damping_matrix[1][7] = t950;
        damping_matrix[1][8] = t951;
        damping_matrix[2][0] = t961;
        damping_matrix[2][1] = t962;
        damping_matrix[2][2] = t963;
        damping_matrix[2][3] = t964;
        damping_matrix[2][4] = t965;
        damping_matrix[2][5] = t966;
        damping_matrix[2][6] = t967;
        damping_matrix[2][7] = t968;
        damping_matrix[2][8] = t969;
        damping_matrix[3][0] = t952;
        damping_matrix[3][1] = t953;
        damping_matrix[3][2] = t954;
        damping_matrix[3][3] = t955;
        damping_matrix[3][4] = t956;
        damping_matrix[3][5] = t957;
        damping_matrix[3][6] = t958;
        damping_matrix[3][7] = t959;
        damping_matrix[3][8] = t960;
        damping_matrix[4][0] = t970;
        damping_matrix[4][1] = t971;
        damping_matrix[4][2] = t972;
        damping_matrix[4][3] = t973;
        damping_matrix[4][4] = t974;
        damping_matrix[4][5] = t975;
        damping_matrix[4][6] = t976;
        damping_matrix[4][7] = t977;
        damping_matrix[4][8] = t978;
        damping_matrix[5][0] = a_x * t835 + t565 * t892 + unit_dc_x * t904;
        damping_matrix[5][1] = a_x * t836 + t565 * t893 + unit_dc_x * t905;
        damping_matrix[5][2] = a_x * t837 + t565 * t894 + unit_dc_x * t906;
        damping_matrix[5][3] = a_y * t835 + t566 * t892 + unit_dc_y * t904;
        damping_matrix[5][4] = a_y * t836 + t566 * t893 + unit_dc_y * t905;
        damping_matrix[5][5] = a_y * t837 + t566 * t894 + unit_dc_y * t906;
        damping_matrix[5][6] = a_z * t835 + t567 * t892 + unit_dc_z * t904;
        damping_matrix[5][7] = a_z * t836 + t567 * t893 + unit_dc_z * t905;
        damping_matrix[5][8] = a_z * t837 + t567 * t894 + unit_dc_z * t906;
        damping_matrix[6][0] = a_x * t841 + t565 * t898 + unit_dc_x * t910;
        damping_matrix[6][1] = a_x * t842 + t565 * t899 + unit_dc_x * t911;
        damping_matrix[6][2] = a_x * t843 + t565 * t900 + unit_dc_x * t912;
        damping_matrix[6][3] = a_y * t841 + t566 * t898 + unit_dc_y * t910;
        damping_matrix[6][4] = a_y * t842 + t566 * t899 + unit_dc_y * t911;
        damping_matrix[6][5] = a_y * t843 + t566 * t900 + unit_dc_y * t912;
        damping_matrix[6][6] = a_z * t841 + t567 * t898 + unit_dc_z * t910;
        damping_matrix[6][7] = a_z * t842 + t567 * t899 + unit_dc_z * t911;
        damping_matrix[6][8] = a_z * t843 + t567 * t900 + unit_dc_z * t912;
        damping_matrix[7][0] = c_x * t922 - a_x * t865;
        damping_matrix[7][1] = c_x * t923 - a_x * t866;
        damping_matrix[7][2] = c_x * t924 - a_x * t867;
        damping_matrix[7][3] = c_y * t922 - a_y * t865;
        damping_matrix[7][4] = c_y * t923 - a_y * t866;
        damping_matrix[7][5] = c_y * t924 - a_y * t867;
        damping_matrix[7][6] = c_z * t922 - a_z * t865;
        damping_matrix[7][7] = c_z * t923 - a_z * t866;
        damping_matrix[7][8] = c_z * t924 - a_z * t867;
        damping_matrix[8][0] = a_x * t871 + c_x * t928;
        damping_matrix[8][1] = a_x * t872 + c_x * t929;
        damping_matrix[8][2] = a_x * t873 + c_x * t930;
        damping_matrix[8][3] = a_y * t871 + c_y * t928;
        damping_matrix[8][4] = a_y * t872 + c_y * t929;
        damping_matrix[8][5] = a_y * t873 + c_y * t930;
        damping_matrix[8][6] = a_z * t871 + c_z * t928;
        damping_matrix[8][7] = a_z * t872 + c_z * t929;
        damping_matrix[8][8] = a_z * t873 + c_z * t930;
        damping_matrix[9][0] = a_x * t838 + t565 * t895 + unit_dc_x * t907;
        damping_matrix[9][1] = a_x * t839 + t565 * t896 + unit_dc_x * t908;
        damping_matrix[9][2] = a_x * t840 + t565 * t897 + unit_dc_x * t909;
        damping_matrix[9][3] = a_y * t838 + t566 * t895 + unit_dc_y * t907;
        damping_matrix[9][4] = a_y * t839 + t566 * t896 + unit_dc_y * t908;
        damping_matrix[9][5] = a_y * t840 + t566 * t897 + unit_dc_y * t909;
        damping_matrix[9][6] = a_z * t838 + t567 * t895 + unit_dc_z * t907;
        damping_matrix[9][7] = a_z * t839 + t567 * t896 + unit_dc_z * t908;
        damping_matrix[9][8] = a_z * t840 + t567 * t897 + unit_dc_z * t909;
        damping_matrix[10][0] = a_x * t844 + t565 * t901 + unit_dc_x * t913;
        damping_matrix[10][1] = a_x * t845 + t565 * t902 + unit_dc_x * t914;
        damping_matrix[10][2] = a_x * t846 + t565 * t903 + unit_dc_x * t915;
        damping_matrix[10][3] = a_y * t844 + t566 * t901 + unit_dc_y * t913;
        damping_matrix[10][4] = a_y * t845 + t566 * t902 + unit_dc_y * t914;
        damping_matrix[10][5] = a_y * t846 + t566 * t903 + unit_dc_y * t915;
        damping_matrix[10][6] = a_z * t844 + t567 * t901 + unit_dc_z * t913;
        damping_matrix[10][7] = a_z * t845 + t567 * t902 + unit_dc_z * t914;
        damping_matrix[10][8] = a_z * t846 + t567 * t903 + unit_dc_z * t915;
        damping_matrix[11][0] = a_x * t868 + c_x * t925;
        damping_matrix[11][1] = a_x * t869 + c_x * t926;
        damping_matrix[11][2] = a_x * t870 + c_x * t927;
        damping_matrix[11][3] = a_y * t868 + c_y * t925;
        damping_matrix[11][4] = a_y * t869 + c_y * t926;
        damping_matrix[11][5] = a_y * t870 + c_y * t927;
        damping_matrix[11][6] = a_z * t868 + c_z * t925;
        damping_matrix[11][7] = a_z * t869 + c_z * t926;
        damping_matrix[11][8] = a_z * t870 + c_z * t927;
        damping_matrix[12][0] = c_x * t931 - a_x * t874;
        damping_matrix[12][1] = c_x * t932 - a_x * t875;
        damping_matrix[12][2] = c_x * t933 - a_x * t876;
        damping_matrix[12][3] = c_y * t931 - a_y * t874;
        damping_matrix[12][4] = c_y * t932 - a_y * t875;
        damping_matrix[12][5] = c_y * t933 - a_y * t876;
        damping_matrix[12][6] = c_z * t931 - a_z * t874;
        damping_matrix[12][7] = c_z * t932 - a_z * t875;
        damping_matrix[12][8] = c_z * t933 - a_z * t876;
        damping_matrix[13][0] = a_x * t853 + t568 * t916 + unit_db_x * t925;
        damping_matrix[13][1] = a_x * t854 + t568 * t917 + unit_db_x * t926;
        damping_matrix[13][2] = a_x * t855 + t568 * t918 + unit_db_x * t927;
        damping_matrix[13][3] = a_y * t853 + t569 * t916 + unit_db_y * t925;
        damping_matrix[13][4] = a_y * t854 + t569 * t917 + unit_db_y * t926;
        damping_matrix[13][5] = a_y * t855 + t569 * t918 + unit_db_y * t927;
        damping_matrix[13][6] = a_z * t853 + t570 * t916 + unit_db_z * t925;
        damping_matrix[13][7] = a_z * t854 + t570 * t917 + unit_db_z * t926;
        damping_matrix[13][8] = a_z * t855 + t570 * t918 + unit_db_z * t927;
        damping_matrix[14][0] = a_x * t859 + t568 * t919 + unit_db_x * t931;
        damping_matrix[14][1] = a_x * t860 + t568 * t920 + unit_db_x * t932;
        damping_matrix[14][2] = a_x * t861 + t568 * t921 + unit_db_x * t933;
        damping_matrix[14][3] = a_y * t859 + t569 * t919 + unit_db_y * t931;
        damping_matrix[14][4] = a_y * t860 + t569 * t920 + unit_db_y * t932;
        damping_matrix[14][5] = a_y * t861 + t569 * t921 + unit_db_y * t933;
        damping_matrix[14][6] = a_z * t859 + t570 * t919 + unit_db_z * t931;
        damping_matrix[14][7] = a_z * t860 + t570 * t920 + unit_db_z * t932;
        damping_matrix[14][8] = a_z * t861 + t570 * t921 + unit_db_z * t933;
        damping_matrix[15][0] = a_x * t883 + b_x * t907;
        damping_matrix[15][1] = a_x * t884 + b_x * t908;
        damping_matrix[15][2] = a_x * t885 + b_x * t909;
        damping_matrix[15][3] = a_y * t883 + b_y * t907;
        damping_matrix[15][4] = a_y * t884 + b_y * t908;
        damping_matrix[15][5] = a_y * t885 + b_y * t909;
        damping_matrix[15][6] = a_z * t883 + b_z * t907;
        damping_matrix[15][7] = a_z * t884 + b_z * t908;
        damping_matrix[15][8] = a_z * t885 + b_z * t909;
        damping_matrix[16][0] = a_x * t889 + b_x * t913;
        damping_matrix[16][1] = a_x * t890 + b_x * t914;
        damping_matrix[16][2] = a_x * t891 + b_x * t915;
        damping_matrix[16][3] = a_y * t889 + b_y * t913;
        damping_matrix[16][4] = a_y * t890 + b_y * t914;
        damping_matrix[16][5] = a_y * t891 + b_y * t915;
        damping_matrix[16][6] = a_z * t889 + b_z * t913;
        damping_matrix[16][7] = a_z * t890 + b_z * t914;
        damping_matrix[16][8] = a_z * t891 + b_z * t915;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 45 additions, 68 multiplications, 3 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t53 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t54 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t55 = a_x * a_x + a_y * a_y + a_z * a_z - (t53 * t53 + t54 * t54);
        let t56 = t55.sqrt();
        let t57 = t56 - 1.0;
        let t58 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t59 = 0.5 * t58;
        let t60 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t61 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t62 = t61 * ((a_x * dc_x + a_y * dc_y + a_z * dc_z + t53 * t59) / t56);
        let t63 = t60 * ((a_x * db_x + a_y * db_y + a_z * db_z - t54 * t59) / t56);
        let t64 = t59 * (t60 * t61) + reference[9] * t62 - reference[10] * t63
            + reference[12] * t57 + t53 * reference[15];
        let t65 = t62 - reference[11] * t63 + reference[13] * t57 + t53 * reference[16]
            + t54 * reference[20] - reference[1];
        let t66 = (t64 + t54 * reference[19] - reference[0]).powi(2)
            * (0.5 * (length * reference[3]))
            + t65 * t65 * (0.5 * (length * reference[4]));
        let t67 = (reference[14] * t57 - t63 + t53 * reference[17] + t54 * reference[21]
            - reference[2])
            .powi(2) * (0.5 * (length * reference[5]));
        *energy = t66 + t67;
    }
    /// Writes the forces on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 47 additions, 71 multiplications, 1 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t41 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t42 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t43 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t44 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t45 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t46 = a_x * a_x + a_y * a_y + a_z * a_z - (t42 * t42 + t44 * t44);
        let t47 = t46.sqrt();
        let t48 = t42 * 2.0;
        let t49 = t44 * 2.0;
        let t50 = 1.0 / (2.0 * t47);
        let t51 = (t41 + t41 - (t43 * t48 + t45 * t49)) * t50 + t43 * reference[18]
            + t45 * reference[22];
        let t52 = length * reference[6]
            * (t47 - 1.0 + t42 * reference[18] + t44 * reference[22] - reference[0]
                + damping * t51);
        let t53 = t50 * t52;
        let t54 = length * reference[7]
            * (t42 + t44 * reference[23] - reference[1]
                + damping * (t43 + t45 * reference[23]));
        let t55 = t52 * (reference[18] - t48 * t50) + t54;
        let t56 = t52 * (reference[22] - t49 * t50) + reference[23] * t54
            + length * reference[8] * (t44 - reference[2] + damping * t45);
        forces[0][0] = t53 * (a_x * 2.0) + b_x * t55 + c_x * t56;
        forces[0][1] = t53 * (a_y * 2.0) + b_y * t55 + c_y * t56;
        forces[0][2] = t53 * (a_z * 2.0) + b_z * t55 + c_z * t56;
        forces[1][0] = a_x * t55;
        forces[1][1] = a_y * t55;
        forces[1][2] = a_z * t55;
        forces[2][0] = a_x * t56;
        forces[2][1] = a_y * t56;
        forces[2][2] = a_z * t56;
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 271 additions, 504 multiplications, 4 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 9],
        damping_matrix: &mut [[f64; 9]; 6],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t41 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t42 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t43 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t44 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t45 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t46 = a_x * a_x + a_y * a_y + a_z * a_z - (t42 * t42 + t44 * t44);
        let t47 = t46.sqrt();
        let t48 = length * reference[6];
        let t49 = t42 * 2.0;
        let t50 = t44 * 2.0;
        let t51 = t41 + t41 - (t43 * t49 + t45 * t50);
        let t52 = 2.0 * t47;
        let t53 = 1.0 / t52;
        let t54 = t47 - 1.0 + t42 * reference[18] + t44 * reference[22] - reference[0]
            + damping * (t51 * t53 + t43 * reference[18] + t45 * reference[22]);
        let t55 = t48 * t54;
        let t56 = 2.0 * t53;
        let t57 = t53 * t56 / t52;
        let t58 = t48 * (t53 - damping * (t51 * t57));
        let t59 = t53 * t58 - t55 * t57;
        let t60 = t49 * t53;
        let t61 = reference[18] - t60;
        let t62 = t53 * (2.0 * t60) / t52;
        let t63 = t48 * (t61 + damping * (t51 * t62 - t53 * (t43 * 2.0)));
        let t64 = t55 * t62 + t53 * t63;
        let t65 = t50 * t53;
        let t66 = reference[22] - t65;
        let t67 = t53 * (2.0 * t65) / t52;
        let t68 = t48 * (t66 + damping * (t51 * t67 - t53 * (t45 * 2.0)));
        let t69 = t55 * t67 + t53 * t68;
        let t70 = t58 * t61 + t55 * (t49 * t57);
        let t71 = length * reference[7];
        let t72 = t71 + (t61 * t63 - t55 * (t56 + t49 * t62));
        let t73 = reference[23] * t71;
        let t74 = t61 * t68 - t55 * (t49 * t67) + t73;
        let t75 = t58 * t66 + t55 * (t50 * t57);
        let t76 = t73 + (t63 * t66 - t55 * (t50 * t62));
        let t77 = length * reference[8];
        let t78 = t77 + (t66 * t68 - t55 * (t56 + t50 * t67) + reference[23] * t73);
        let t79 = t48 * (damping * t53);
        let t80 = t53 * t79;
        let t81 = t48 * (damping * t61);
        let t82 = t53 * t81;
        let t83 = t48 * (damping * t66);
        let t84 = t53 * t83;
        let t85 = t61 * t79;
        let t86 = damping * t71;
        let t87 = t61 * t81 + t86;
        let t88 = t71 * (damping * reference[23]);
        let t89 = t61 * t83 + t88;
        let t90 = t66 * t79;
        let t91 = t66 * t81 + reference[23] * t86;
        let t92 = t66 * t83 + reference[23] * t88 + damping * t77;
        let t93 = t71
            * (t42 + t44 * reference[23] - reference[1]
                + damping * (t43 + t45 * reference[23]));
        let t94 = t55 * t61 + t93;
        let t95 = t55 * t66 + reference[23] * t93
            + t77 * (t44 - reference[2] + damping * t45);
        let t96 = a_x * 2.0;
        let t97 = a_y * 2.0;
        let t98 = a_z * 2.0;
        let t99 = v_a_x * 2.0;
        let t100 = v_a_y * 2.0;
        let t101 = v_a_z * 2.0;
        let t102 = t59 * t96 + b_x * t64 + c_x * t69
            + (t80 * t99 + v_b_x * t82 + v_c_x * t84);
        let t103 = t59 * t97 + b_y * t64 + c_y * t69
            + (t80 * t100 + v_b_y * t82 + v_c_y * t84);
        let t104 = t59 * t98 + b_z * t64 + c_z * t69
            + (t80 * t101 + v_b_z * t82 + v_c_z * t84);
        let t105 = a_x * t64 + v_a_x * t82;
        let t106 = a_y * t64 + v_a_y * t82;
        let t107 = a_z * t64 + v_a_z * t82;
        let t108 = a_x * t69 + v_a_x * t84;
        let t109 = a_y * t69 + v_a_y * t84;
        let t110 = a_z * t69 + v_a_z * t84;
        let t111 = t70 * t96 + b_x * t72 + c_x * t74
            + (t85 * t99 + v_b_x * t87 + v_c_x * t89);
        let t112 = t70 * t97 + b_y * t72 + c_y * t74
            + (t85 * t100 + v_b_y * t87 + v_c_y * t89);
        let t113 = t70 * t98 + b_z * t72 + c_z * t74
            + (t85 * t101 + v_b_z * t87 + v_c_z * t89);
        let t114 = a_x * t72 + v_a_x * t87;
        let t115 = a_y * t72 + v_a_y * t87;
        let t116 = a_z * t72 + v_a_z * t87;
        let t117 = a_x * t74 + v_a_x * t89;
        let t118 = a_y * t74 + v_a_y * t89;
        let t119 = a_z * t74 + v_a_z * t89;
        let t120 = t75 * t96 + b_x * t76 + c_x * t78
            + (t90 * t99 + v_b_x * t91 + v_c_x * t92);
        let t121 = t75 * t97 + b_y * t76 + c_y * t78
            + (t90 * t100 + v_b_y * t91 + v_c_y * t92);
        let t122 = t75 * t98 + b_z * t76 + c_z * t78
            + (t90 * t101 + v_b_z * t91 + v_c_z * t92);
        let t123 = a_x * t76 + v_a_x * t91;
        let t124 = a_y * t76 + v_a_y * t91;
        let t125 = a_z * t76 + v_a_z * t91;
        let t126 = a_x * t78 + v_a_x * t92;
        let t127 = a_y * t78 + v_a_y * t92;
        let t128 = a_z * t78 + v_a_z * t92;
        let t129 = 2.0 * (t53 * t55);
        let t130 = t80 * t96 + b_x * t82 + c_x * t84;
        let t131 = t80 * t97 + b_y * t82 + c_y * t84;
        let t132 = t80 * t98 + b_z * t82 + c_z * t84;
        let t133 = a_x * t82;
        let t134 = a_y * t82;
        let t135 = a_z * t82;
        let t136 = a_x * t84;
        let t137 = a_y * t84;
        let t138 = a_z * t84;
        let t139 = t85 * t96 + b_x * t87 + c_x * t89;
        let t140 = t85 * t97 + b_y * t87 + c_y * t89;
        let t141 = t85 * t98 + b_z * t87 + c_z * t89;
        let t142 = a_x * t87;
        let t143 = a_y * t87;
        let t144 = a_z * t87;
        let t145 = a_x * t89;
        let t146 = a_y * t89;
        let t147 = a_z * t89;
        let t148 = t90 * t96 + b_x * t91 + c_x * t92;
        let t149 = t90 * t97 + b_y * t91 + c_y * t92;
        let t150 = t90 * t98 + b_z * t91 + c_z * t92;
        let t151 = a_x * t91;
        let t152 = a_y * t91;
        let t153 = a_z * t91;
        let t154 = a_x * t92;
        let t155 = a_y * t92;
        let t156 = a_z * t92;
        stiffness[0][0] = t96 * t102 + b_x * t111 + c_x * t120 + t129;
        stiffness[0][1] = t96 * t103 + b_x * t112 + c_x * t121;
        stiffness[0][2] = t96 * t104 + b_x * t113 + c_x * t122;
        stiffness[0][3] = t97 * t102 + b_y * t111 + c_y * t120;
        stiffness[0][4] = t97 * t103 + b_y * t112 + c_y * t121 + t129;
        stiffness[0][5] = t97 * t104 + b_y * t113 + c_y * t122;
        stiffness[0][6] = t98 * t102 + b_z * t111 + c_z * t120;
        stiffness[0][7] = t98 * t103 + b_z * t112 + c_z * t121;
        stiffness[0][8] = t98 * t104 + b_z * t113 + c_z * t122 + t129;
        stiffness[1][0] = t94 + (t96 * t105 + b_x * t114 + c_x * t123);
        stiffness[1][1] = t96 * t106 + b_x * t115 + c_x * t124;
        stiffness[1][2] = t96 * t107 + b_x * t116 + c_x * t125;
        stiffness[1][3] = t97 * t105 + b_y * t114 + c_y * t123;
        stiffness[1][4] = t94 + (t97 * t106 + b_y * t115 + c_y * t124);
        stiffness[1][5] = t97 * t107 + b_y * t116 + c_y * t125;
        stiffness[1][6] = t98 * t105 + b_z * t114 + c_z * t123;
        stiffness[1][7] = t98 * t106 + b_z * t115 + c_z * t124;
        stiffness[1][8] = t94 + (t98 * t107 + b_z * t116 + c_z * t125);
        stiffness[2][0] = t95 + (t96 * t108 + b_x * t117 + c_x * t126);
        stiffness[2][1] = t96 * t109 + b_x * t118 + c_x * t127;
        stiffness[2][2] = t96 * t110 + b_x * t119 + c_x * t128;
        stiffness[2][3] = t97 * t108 + b_y * t117 + c_y * t126;
        stiffness[2][4] = t95 + (t97 * t109 + b_y * t118 + c_y * t127);
        stiffness[2][5] = t97 * t110 + b_y * t119 + c_y * t128;
        stiffness[2][6] = t98 * t108 + b_z * t117 + c_z * t126;
        stiffness[2][7] = t98 * t109 + b_z * t118 + c_z * t127;
        stiffness[2][8] = t95 + (t98 * t110 + b_z * t119 + c_z * t128);
        stiffness[3][0] = t94 + a_x * t111;
        stiffness[3][1] = a_x * t112;
        stiffness[3][2] = a_x * t113;
        stiffness[3][3] = a_y * t111;
        stiffness[3][4] = t94 + a_y * t112;
        stiffness[3][5] = a_y * t113;
        stiffness[3][6] = a_z * t111;
        stiffness[3][7] = a_z * t112;
        stiffness[3][8] = t94 + a_z * t113;
        stiffness[4][0] = a_x * t114;
        stiffness[4][1] = a_x * t115;
        stiffness[4][2] = a_x * t116;
        stiffness[4][3] = a_y * t114;
        stiffness[4][4] = a_y * t115;
        stiffness[4][5] = a_y * t116;
        stiffness[4][6] = a_z * t114;
        stiffness[4][7] = a_z * t115;
        stiffness[4][8] = a_z * t116;
        stiffness[5][0] = a_x * t117;
        stiffness[5][1] = a_x * t118;
        stiffness[5][2] = a_x * t119;
        stiffness[5][3] = a_y * t117;
        stiffness[5][4] = a_y * t118;
        stiffness[5][5] = a_y * t119;
        stiffness[5][6] = a_z * t117;
        stiffness[5][7] = a_z * t118;
        stiffness[5][8] = a_z * t119;
        stiffness[6][0] = t95 + a_x * t120;
        stiffness[6][1] = a_x * t121;
        stiffness[6][2] = a_x * t122;
        stiffness[6][3] = a_y * t120;
        stiffness[6][4] = t95 + a_y * t121;
        stiffness[6][5] = a_y * t122;
        stiffness[6][6] = a_z * t120;
        stiffness[6][7] = a_z * t121;
        stiffness[6][8] = t95 + a_z * t122;
        stiffness[7][0] = a_x * t123;
        stiffness[7][1] = a_x * t124;
        stiffness[7][2] = a_x * t125;
        stiffness[7][3] = a_y * t123;
        stiffness[7][4] = a_y * t124;
        stiffness[7][5] = a_y * t125;
        stiffness[7][6] = a_z * t123;
        stiffness[7][7] = a_z * t124;
        stiffness[7][8] = a_z * t125;
        stiffness[8][0] = a_x * t126;
        stiffness[8][1] = a_x * t127;
        stiffness[8][2] = a_x * t128;
        stiffness[8][3] = a_y * t126;
        stiffness[8][4] = a_y * t127;
        stiffness[8][5] = a_y * t128;
        stiffness[8][6] = a_z * t126;
        stiffness[8][7] = a_z * t127;
        stiffness[8][8] = a_z * t128;
        damping_matrix[0][0] = t96 * t130 + b_x * t139 + c_x * t148;
        damping_matrix[0][1] = t96 * t131 + b_x * t140 + c_x * t149;
        damping_matrix[0][2] = t96 * t132 + b_x * t141 + c_x * t150;
        damping_matrix[0][3] = t97 * t130 + b_y * t139 + c_y * t148;
        damping_matrix[0][4] = t97 * t131 + b_y * t140 + c_y * t149;
        damping_matrix[0][5] = t97 * t132 + b_y * t141 + c_y * t150;
        damping_matrix[0][6] = t98 * t130 + b_z * t139 + c_z * t148;
        damping_matrix[0][7] = t98 * t131 + b_z * t140 + c_z * t149;
        damping_matrix[0][8] = t98 * t132 + b_z * t141 + c_z * t150;
        damping_matrix[1][0] = t96 * t133 + b_x * t142 + c_x * t151;
        damping_matrix[1][1] = t96 * t134 + b_x * t143 + c_x * t152;
        damping_matrix[1][2] = t96 * t135 + b_x * t144 + c_x * t153;
        damping_matrix[1][3] = t97 * t133 + b_y * t142 + c_y * t151;
        damping_matrix[1][4] = t97 * t134 + b_y * t143 + c_y * t152;
        damping_matrix[1][5] = t97 * t135 + b_y * t144 + c_y * t153;
        damping_matrix[1][6] = t98 * t133 + b_z * t142 + c_z * t151;
        damping_matrix[1][7] = t98 * t134 + b_z * t143 + c_z * t152;
        damping_matrix[1][8] = t98 * t135 + b_z * t144 + c_z * t153;
        damping_matrix[2][0] = t96 * t136 + b_x * t145 + c_x * t154;
        damping_matrix[2][1] = t96 * t137 + b_x * t146 + c_x * t155;
        damping_matrix[2][2] = t96 * t138 + b_x * t147 + c_x * t156;
        damping_matrix[2][3] = t97 * t136 + b_y * t145 + c_y * t154;
        damping_matrix[2][4] = t97 * t137 + b_y * t146 + c_y * t155;
        damping_matrix[2][5] = t97 * t138 + b_y * t147 + c_y * t156;
        damping_matrix[2][6] = t98 * t136 + b_z * t145 + c_z * t154;
        damping_matrix[2][7] = t98 * t137 + b_z * t146 + c_z * t155;
        damping_matrix[2][8] = t98 * t138 + b_z * t147 + c_z * t156;
        damping_matrix[3][0] = a_x * t142;
        damping_matrix[3][1] = a_x * t143;
        damping_matrix[3][2] = a_x * t144;
        damping_matrix[3][3] = a_y * t142;
        damping_matrix[3][4] = a_y * t143;
        damping_matrix[3][5] = a_y * t144;
        damping_matrix[3][6] = a_z * t142;
        damping_matrix[3][7] = a_z * t143;
        damping_matrix[3][8] = a_z * t144;
        damping_matrix[4][0] = a_x * t145;
        damping_matrix[4][1] = a_x * t146;
        damping_matrix[4][2] = a_x * t147;
        damping_matrix[4][3] = a_y * t145;
        damping_matrix[4][4] = a_y * t146;
        damping_matrix[4][5] = a_y * t147;
        damping_matrix[4][6] = a_z * t145;
        damping_matrix[4][7] = a_z * t146;
        damping_matrix[4][8] = a_z * t147;
        damping_matrix[5][0] = a_x * t154;
        damping_matrix[5][1] = a_x * t155;
        damping_matrix[5][2] = a_x * t156;
        damping_matrix[5][3] = a_y * t154;
        damping_matrix[5][4] = a_y * t155;
        damping_matrix[5][5] = a_y * t156;
        damping_matrix[5][6] = a_z * t154;
        damping_matrix[5][7] = a_z * t155;
        damping_matrix[5][8] = a_z * t156;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 17 additions, 26 multiplications, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t31 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t32 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t33 = a_x * a_x + a_y * a_y + a_z * a_z - (t31 * t31 + t32 * t32);
        let t34 = (t33.sqrt() - 1.0 + t31 * reference[18] + t32 * reference[22]
            - reference[0])
            .powi(2) * (0.5 * (length * reference[6]));
        let t35 = t34
            + (t31 + t32 * reference[23] - reference[1]).powi(2)
                * (0.5 * (length * reference[7]))
            + (t32 - reference[2]).powi(2) * (0.5 * (length * reference[8]));
        *energy = t35;
    }
    /// Writes the forces on the fields b, c at a point of weight one on the unit element, for the terms that are integrated at 3 nodes; fields are derivatives on the unit element.
    ///
    /// Operations: 31 additions, 53 multiplications.
    pub fn full_beam_spatial_curved_damped_nodes3_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        rates: &[[f64; 3]; 2],
        forces: &mut [[f64; 3]; 2],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t31 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t32 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t33 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t34 = length * reference[24];
        let t35 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[0]
            + damping * (0.5 * (t31 + t31));
        let t36 = 0.5 * (t34 * t35);
        let t37 = length * reference[25]
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[2] + damping * t32);
        let t38 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[1]
            + damping * (0.5 * (t33 + t33));
        let t39 = 0.5 * (t34 * t38);
        forces[0][0] = t36 * (b_x * 2.0) + c_x * t37;
        forces[0][1] = t36 * (b_y * 2.0) + c_y * t37;
        forces[0][2] = t36 * (b_z * 2.0) + c_z * t37;
        forces[1][0] = b_x * t37 + t39 * (c_x * 2.0);
        forces[1][1] = b_y * t37 + t39 * (c_y * 2.0);
        forces[1][2] = b_z * t37 + t39 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields b, c at a point of weight one on the unit element, for the terms that are integrated at 3 nodes; fields are derivatives on the unit element.
    ///
    /// Operations: 79 additions, 178 multiplications.
    pub fn full_beam_spatial_curved_damped_nodes3_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        rates: &[[f64; 3]; 2],
        stiffness: &mut [[f64; 9]; 4],
        damping_matrix: &mut [[f64; 9]; 3],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t31 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t32 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t33 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t34 = length * reference[24];
        let t35 = 0.5 * (0.5 * t34);
        let t36 = length * reference[25];
        let t37 = 0.5 * (t34 * (damping * 0.5));
        let t38 = damping * t36;
        let t39 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[0]
            + damping * (0.5 * (t31 + t31));
        let t40 = t36
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[2] + damping * t32);
        let t41 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[1]
            + damping * (0.5 * (t33 + t33));
        let t42 = b_x * 2.0;
        let t43 = b_y * 2.0;
        let t44 = b_z * 2.0;
        let t45 = c_x * 2.0;
        let t46 = c_y * 2.0;
        let t47 = c_z * 2.0;
        let t48 = t35 * t42 + t37 * (v_b_x * 2.0);
        let t49 = t35 * t43 + t37 * (v_b_y * 2.0);
        let t50 = t35 * t44 + t37 * (v_b_z * 2.0);
        let t51 = c_x * t36 + v_c_x * t38;
        let t52 = c_y * t36 + v_c_y * t38;
        let t53 = c_z * t36 + v_c_z * t38;
        let t54 = b_x * t36 + v_b_x * t38;
        let t55 = b_y * t36 + v_b_y * t38;
        let t56 = b_z * t36 + v_b_z * t38;
        let t57 = t35 * t45 + t37 * (v_c_x * 2.0);
        let t58 = t35 * t46 + t37 * (v_c_y * 2.0);
        let t59 = t35 * t47 + t37 * (v_c_z * 2.0);
        let t60 = 0.5 * (t34 * t39) * 2.0;
        let t61 = 0.5 * (t34 * t41) * 2.0;
        let t62 = t37 * t43;
        let t63 = t37 * t44;
        let t64 = c_y * t38;
        let t65 = c_z * t38;
        let t66 = b_x * t38;
        let t67 = b_y * t38;
        let t68 = b_z * t38;
        let t69 = t37 * t46;
        let t70 = t37 * t47;
        let t71 = t42 * t62 + c_x * t64;
        let t72 = t42 * t63 + c_x * t65;
        let t73 = t43 * t63 + c_y * t65;
        let t74 = b_x * t67 + t45 * t69;
        let t75 = b_x * t68 + t45 * t70;
        let t76 = b_y * t68 + t46 * t70;
        stiffness[0][0] = t42 * t48 + c_x * t51 + t60;
        stiffness[0][1] = t42 * t49 + c_x * t52;
        stiffness[0][2] = t42 * t50 + c_x * t53;
        stiffness[0][3] = t43 * t48 + c_y * t51;
        stiffness[0][4] = t43 * t49 + c_y * t52 + t60;
        stiffness[0][5] = t43 * t50 + c_y * t53;
        stiffness[0][6] = t44 * t48 + c_z * t51;
        stiffness[0][7] = t44 * t49 + c_z * t52;
        stiffness[0][8] = t44 * t50 + c_z * t53 + t60;
        stiffness[1][0] = t40 + c_x * t54;
        stiffness[1][1] = c_x * t55;
        stiffness[1][2] = c_x * t56;
        stiffness[1][3] = c_y * t54;
        stiffness[1][4] = t40 + c_y * t55;
        stiffness[1][5] = c_y * t56;
        stiffness[1][6] = c_z * t54;
        stiffness[1][7] = c_z * t55;
        stiffness[1][8] = t40 + c_z * t56;
        stiffness[2][0] = t40 + b_x * t51;
        stiffness[2][1] = b_x * t52;
        stiffness[2][2] = b_x * t53;
        stiffness[2][3] = b_y * t51;
        stiffness[2][4] = t40 + b_y * t52;
        stiffness[2][5] = b_y * t53;
        stiffness[2][6] = b_z * t51;
        stiffness[2][7] = b_z * t52;
        stiffness[2][8] = t40 + b_z * t53;
        stiffness[3][0] = b_x * t54 + t45 * t57 + t61;
        stiffness[3][1] = b_x * t55 + t45 * t58;
        stiffness[3][2] = b_x * t56 + t45 * t59;
        stiffness[3][3] = b_y * t54 + t46 * t57;
        stiffness[3][4] = b_y * t55 + t46 * t58 + t61;
        stiffness[3][5] = b_y * t56 + t46 * t59;
        stiffness[3][6] = b_z * t54 + t47 * t57;
        stiffness[3][7] = b_z * t55 + t47 * t58;
        stiffness[3][8] = b_z * t56 + t47 * t59 + t61;
        damping_matrix[0][0] = t42 * (t37 * t42) + c_x * (c_x * t38);
        damping_matrix[0][1] = t71;
        damping_matrix[0][2] = t72;
        damping_matrix[0][3] = t71;
        damping_matrix[0][4] = t43 * t62 + c_y * t64;
        damping_matrix[0][5] = t73;
        damping_matrix[0][6] = t72;
        damping_matrix[0][7] = t73;
        damping_matrix[0][8] = t44 * t63 + c_z * t65;
        damping_matrix[1][0] = c_x * t66;
        damping_matrix[1][1] = c_x * t67;
        damping_matrix[1][2] = c_x * t68;
        damping_matrix[1][3] = c_y * t66;
        damping_matrix[1][4] = c_y * t67;
        damping_matrix[1][5] = c_y * t68;
        damping_matrix[1][6] = c_z * t66;
        damping_matrix[1][7] = c_z * t67;
        damping_matrix[1][8] = c_z * t68;
        damping_matrix[2][0] = b_x * t66 + t45 * (t37 * t45);
        damping_matrix[2][1] = t74;
        damping_matrix[2][2] = t75;
        damping_matrix[2][3] = t74;
        damping_matrix[2][4] = b_y * t67 + t46 * t69;
        damping_matrix[2][5] = t76;
        damping_matrix[2][6] = t75;
        damping_matrix[2][7] = t76;
        damping_matrix[2][8] = b_z * t68 + t47 * t70;
    }
    /// Writes the strain energy b, c at a point of weight one on the unit element, for the terms that are integrated at 3 nodes; fields are derivatives on the unit element.
    ///
    /// Operations: 13 additions, 21 multiplications.
    pub fn full_beam_spatial_curved_damped_nodes3_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t24 = 0.5 * (length * reference[24]);
        let t25 = (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[0])
            .powi(2);
        let t26 = (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[1])
            .powi(2);
        let t27 = (b_x * c_x + b_y * c_y + b_z * c_z - reference[2]).powi(2)
            * (0.5 * (length * reference[25]));
        *energy = t24 * t25 + t24 * t26 + t27;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 Gauss points and 3 Gauss points and 3 nodes, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 1283 additions, 1639 multiplications, 37 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_elastic_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 208],
        q: &[f64; 30],
        v: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.relative(row.length, q);
        let rates = FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.relative(row.length, v);
        let mut sums = Default::default();
        FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| full_beam_spatial_curved_damped_points2_force(
                    row,
                    ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| full_beam_spatial_curved_damped_points3_force(
                    row,
                    ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| full_beam_spatial_curved_damped_nodes3_force(
                    row,
                    ::rncf::emitted::array(&reference[130 + 26 * point..][..26]),
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 Gauss points and 3 Gauss points and 3 nodes, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 18618 additions, 21886 multiplications, 140 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_elastic_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 208],
        q: &[f64; 30],
        v: &[f64; 30],
        stiffness: &mut [f64; 900],
        damping_matrix: &mut [f64; 900],
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.relative(row.length, q);
        let rates = FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.relative(row.length, v);
        let mut tiles = [[[0.0; 9]; 9]; 9];
        let mut viscous = [[[0.0; 9]; 9]; 6];
        FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2
            .damped_tangent(
                (&vectors, &rates),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2_STIFFNESS, &mut tiles),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| full_beam_spatial_curved_damped_points2_tangent(
                    row,
                    ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3
            .damped_tangent(
                (&vectors, &rates),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3_STIFFNESS, &mut tiles),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| full_beam_spatial_curved_damped_points3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3
            .damped_tangent(
                (&vectors, &rates),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3_STIFFNESS, &mut tiles),
                (&FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| full_beam_spatial_curved_damped_nodes3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[130 + 26 * point..][..26]),
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS
            .add_general(row.length, &tiles, stiffness);
        FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS
            .add_symmetric(row.length, &viscous, damping_matrix);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 Gauss points and 3 Gauss points and 3 nodes, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 413 additions, 510 multiplications, 6 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_strain_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 208],
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_DAMPED_VECTORS.relative(row.length, q);
        *energy
            += FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_damped_points2_energy(
                            row,
                            ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += FULL_BEAM_SPATIAL_CURVED_DAMPED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_damped_points3_energy(
                            row,
                            ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += FULL_BEAM_SPATIAL_CURVED_DAMPED_NODES3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_damped_nodes3_energy(
                            row,
                            ::rncf::emitted::array(&reference[130 + 26 * point..][..26]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
    }
    /// Values of one element in the stress-free shape, which the other kernels subtract.
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points, unrolled.
    ///
    /// Operations: 245 additions, 325 multiplications, 5 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_reference(
        row: &FullBeamSpatialCurvedDamped,
        q: &[f64; 30],
        reference: &mut [f64; 208],
    ) {
        let FullBeamSpatialCurvedDamped { length, .. } = *row;
        let [r0_x, r0_y, r0_z, r0x_x, r0x_y, r0x_z, r0y_x, r0y_y, r0y_z, r0z_x, r0z_y,
        r0z_z, ry_half_x, ry_half_y, ry_half_z, rz_half_x, rz_half_y, rz_half_z, r1_x,
        r1_y, r1_z, r1x_x, r1x_y, r1x_z, r1y_x, r1y_y, r1y_z, r1z_x, r1z_y, r1z_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t80 = d_x + r0x_x * 0.28867513459481287 + r1x_x * (-0.2886751345948129);
        let t81 = d_y + r0x_y * 0.28867513459481287 + r1x_y * (-0.2886751345948129);
        let t82 = d_z + r0x_z * 0.28867513459481287 + r1x_z * (-0.2886751345948129);
        let t83 = ry_half_x * 0.6666666666666667;
        let t84 = ry_half_y * 0.6666666666666667;
        let t85 = ry_half_z * 0.6666666666666667;
        let t86 = r0y_x * 0.4553418012614795 + t83 + r1y_x * (-0.12200846792814622);
        let t87 = r0y_y * 0.4553418012614795 + t84 + r1y_y * (-0.12200846792814622);
        let t88 = r0y_z * 0.4553418012614795 + t85 + r1y_z * (-0.12200846792814622);
        let t89 = rz_half_x * 0.6666666666666667;
        let t90 = rz_half_y * 0.6666666666666667;
        let t91 = rz_half_z * 0.6666666666666667;
        let t92 = r0z_x * 0.4553418012614795 + t89 + r1z_x * (-0.12200846792814622);
        let t93 = r0z_y * 0.4553418012614795 + t90 + r1z_y * (-0.12200846792814622);
        let t94 = r0z_z * 0.4553418012614795 + t91 + r1z_z * (-0.12200846792814622);
        let t95 = inverse_length
            * (r0y_x * (-2.1547005383792515) + ry_half_x * 2.309401076758503
                + r1y_x * (-0.15470053837925146));
        let t96 = inverse_length
            * (r0y_y * (-2.1547005383792515) + ry_half_y * 2.309401076758503
                + r1y_y * (-0.15470053837925146));
        let t97 = inverse_length
            * (r0y_z * (-2.1547005383792515) + ry_half_z * 2.309401076758503
                + r1y_z * (-0.15470053837925146));
        let t98 = inverse_length
            * (r0z_x * (-2.1547005383792515) + rz_half_x * 2.309401076758503
                + r1z_x * (-0.15470053837925146));
        let t99 = inverse_length
            * (r0z_y * (-2.1547005383792515) + rz_half_y * 2.309401076758503
                + r1z_y * (-0.15470053837925146));
        let t100 = inverse_length
            * (r0z_z * (-2.1547005383792515) + rz_half_z * 2.309401076758503
                + r1z_z * (-0.15470053837925146));
        let t101 = t80 * t86 + t81 * t87 + t82 * t88;
        let t102 = t80 * t92 + t81 * t93 + t82 * t94;
        let t103 = t80 * t80 + t81 * t81 + t82 * t82 - (t101 * t101 + t102 * t102);
        let t104 = t103.sqrt();
        let t105 = t104 - 1.0;
        let t106 = t92 * t95 + t93 * t96 + t94 * t97
            - (t86 * t98 + t87 * t99 + t88 * t100);
        let t107 = 0.5 * t106;
        let t108 = 1.0 - 0.5 * (t86 * t86 + t87 * t87 + t88 * t88 - 1.0);
        let t109 = 1.0 - 0.5 * (t92 * t92 + t93 * t93 + t94 * t94 - 1.0);
        let t110 = t109 * ((t80 * t98 + t81 * t99 + t82 * t100 + t101 * t107) / t104);
        let t111 = t108 * ((t80 * t95 + t81 * t96 + t82 * t97 - t102 * t107) / t104);
        let t112 = t107 * (t108 * t109) + reference[9] * t110 - reference[10] * t111
            + reference[12] * t105 + t101 * reference[15];
        let t113 = r0x_x * (-0.2886751345948131) + d_x * 1.0000000000000004
            + r1x_x * 0.28867513459481264;
        let t114 = r0x_y * (-0.2886751345948131) + d_y * 1.0000000000000004
            + r1x_y * 0.28867513459481264;
        let t115 = r0x_z * (-0.2886751345948131) + d_z * 1.0000000000000004
            + r1x_z * 0.28867513459481264;
        let t116 = t83 + r0y_x * (-0.12200846792814612) + r1y_x * 0.4553418012614795;
        let t117 = t84 + r0y_y * (-0.12200846792814612) + r1y_y * 0.4553418012614795;
        let t118 = t85 + r0y_z * (-0.12200846792814612) + r1y_z * 0.4553418012614795;
        let t119 = t89 + r0z_x * (-0.12200846792814612) + r1z_x * 0.4553418012614795;
        let t120 = t90 + r0z_y * (-0.12200846792814612) + r1z_y * 0.4553418012614795;
        let t121 = t91 + r0z_z * (-0.12200846792814612) + r1z_z * 0.4553418012614795;
        let t122 = inverse_length
            * (r0y_x * 0.15470053837925146 + ry_half_x * (-2.309401076758503)
                + r1y_x * 2.1547005383792515);
        let t123 = inverse_length
            * (r0y_y * 0.15470053837925146 + ry_half_y * (-2.309401076758503)
                + r1y_y * 2.1547005383792515);
        let t124 = inverse_length
            * (r0y_z * 0.15470053837925146 + ry_half_z * (-2.309401076758503)
                + r1y_z * 2.1547005383792515);
        let t125 = inverse_length
            * (r0z_x * 0.15470053837925146 + rz_half_x * (-2.309401076758503)
                + r1z_x * 2.1547005383792515);
        let t126 = inverse_length
            * (r0z_y * 0.15470053837925146 + rz_half_y * (-2.309401076758503)
                + r1z_y * 2.1547005383792515);
        let t127 = inverse_length
            * (r0z_z * 0.15470053837925146 + rz_half_z * (-2.309401076758503)
                + r1z_z * 2.1547005383792515);
        let t128 = t113 * t116 + t114 * t117 + t115 * t118;
        let t129 = t113 * t119 + t114 * t120 + t115 * t121;
        let t130 = t113 * t113 + t114 * t114 + t115 * t115 - (t128 * t128 + t129 * t129);
        let t131 = t130.sqrt();
        let t132 = t131 - 1.0;
        let t133 = t119 * t122 + t120 * t123 + t121 * t124
            - (t116 * t125 + t117 * t126 + t118 * t127);
        let t134 = 0.5 * t133;
        let t135 = 1.0 - 0.5 * (t116 * t116 + t117 * t117 + t118 * t118 - 1.0);
        let t136 = 1.0 - 0.5 * (t119 * t119 + t120 * t120 + t121 * t121 - 1.0);
        let t137 = t136
            * ((t113 * t125 + t114 * t126 + t115 * t127 + t128 * t134) / t131);
        let t138 = t135
            * ((t113 * t122 + t114 * t123 + t115 * t124 - t129 * t134) / t131);
        let t139 = t134 * (t135 * t136) + reference[35] * t137 - reference[36] * t138
            + reference[38] * t132 + t128 * reference[41];
        let t140 = d_x * 0.6;
        let t141 = d_y * 0.6;
        let t142 = d_z * 0.6;
        let t143 = r0x_x * 0.5872983346207417 + t140 + r1x_x * (-0.18729833462074166);
        let t144 = r0x_y * 0.5872983346207417 + t141 + r1x_y * (-0.18729833462074166);
        let t145 = r0x_z * 0.5872983346207417 + t142 + r1x_z * (-0.18729833462074166);
        let t146 = ry_half_x * 0.39999999999999997;
        let t147 = ry_half_y * 0.39999999999999997;
        let t148 = ry_half_z * 0.39999999999999997;
        let t149 = rz_half_x * 0.39999999999999997;
        let t150 = rz_half_y * 0.39999999999999997;
        let t151 = rz_half_z * 0.39999999999999997;
        let t152 = t143
            * (r0y_x * 0.6872983346207417 + t146 + r1y_x * (-0.08729833462074169))
            + t144
                * (r0y_y * 0.6872983346207417 + t147 + r1y_y * (-0.08729833462074169));
        let t153 = t152
            + t145
                * (r0y_z * 0.6872983346207417 + t148 + r1y_z * (-0.08729833462074169));
        let t154 = t143
            * (r0z_x * 0.6872983346207417 + t149 + r1z_x * (-0.08729833462074169))
            + t144
                * (r0z_y * 0.6872983346207417 + t150 + r1z_y * (-0.08729833462074169));
        let t155 = t154
            + t145
                * (r0z_z * 0.6872983346207417 + t151 + r1z_z * (-0.08729833462074169));
        let t156 = t143 * t143 + t144 * t144 + t145 * t145 - (t153 * t153 + t155 * t155);
        let t157 = r0x_x * (-0.25) + d_x * 1.5 + r1x_x * (-0.25);
        let t158 = r0x_y * (-0.25) + d_y * 1.5 + r1x_y * (-0.25);
        let t159 = r0x_z * (-0.25) + d_z * 1.5 + r1x_z * (-0.25);
        let t160 = ry_half_x * t157 + ry_half_y * t158 + ry_half_z * t159;
        let t161 = rz_half_x * t157 + rz_half_y * t158 + rz_half_z * t159;
        let t162 = t157 * t157 + t158 * t158 + t159 * t159 - (t160 * t160 + t161 * t161);
        let t163 = t140 + r0x_x * (-0.18729833462074175) + r1x_x * 0.5872983346207418;
        let t164 = t141 + r0x_y * (-0.18729833462074175) + r1x_y * 0.5872983346207418;
        let t165 = t142 + r0x_z * (-0.18729833462074175) + r1x_z * 0.5872983346207418;
        let t166 = t163
            * (t146 + r0y_x * (-0.08729833462074166) + r1y_x * 0.6872983346207417)
            + t164
                * (t147 + r0y_y * (-0.08729833462074166) + r1y_y * 0.6872983346207417);
        let t167 = t166
            + t165
                * (t148 + r0y_z * (-0.08729833462074166) + r1y_z * 0.6872983346207417);
        let t168 = t163
            * (t149 + r0z_x * (-0.08729833462074166) + r1z_x * 0.6872983346207417)
            + t164
                * (t150 + r0z_y * (-0.08729833462074166) + r1z_y * 0.6872983346207417);
        let t169 = t168
            + t165
                * (t151 + r0z_z * (-0.08729833462074166) + r1z_z * 0.6872983346207417);
        let t170 = t163 * t163 + t164 * t164 + t165 * t165 - (t167 * t167 + t169 * t169);
        reference[0] = t112 + t102 * reference[19];
        reference[1] = t110 - reference[11] * t111 + reference[13] * t105
            + t101 * reference[16] + t102 * reference[20];
        reference[2] = reference[14] * t105 - t111 + t101 * reference[17]
            + t102 * reference[21];
        reference[26] = t139 + t129 * reference[45];
        reference[27] = t137 - reference[37] * t138 + reference[39] * t132
            + t128 * reference[42] + t129 * reference[46];
        reference[28] = reference[40] * t132 - t138 + t128 * reference[43]
            + t129 * reference[47];
        reference[52] = t156.sqrt() - 1.0 + t153 * reference[70] + t155 * reference[74];
        reference[53] = t153 + t155 * reference[75];
        reference[54] = t155;
        reference[78] = t162.sqrt() - 1.0 + t160 * reference[96] + t161 * reference[100];
        reference[79] = t160 + t161 * reference[101];
        reference[80] = t161;
        reference[104] = t170.sqrt() - 1.0 + t167 * reference[122]
            + t169 * reference[126];
        reference[105] = t167 + t169 * reference[127];
        reference[106] = t169;
        reference[130] = 0.5 * (r0y_x * r0y_x + r0y_y * r0y_y + r0y_z * r0y_z - 1.0);
        reference[131] = 0.5 * (r0z_x * r0z_x + r0z_y * r0z_y + r0z_z * r0z_z - 1.0);
        reference[132] = r0y_x * r0z_x + r0y_y * r0z_y + r0y_z * r0z_z;
        reference[156] = 0.5
            * (ry_half_x * ry_half_x + ry_half_y * ry_half_y + ry_half_z * ry_half_z
                - 1.0);
        reference[157] = 0.5
            * (rz_half_x * rz_half_x + rz_half_y * rz_half_y + rz_half_z * rz_half_z
                - 1.0);
        reference[158] = ry_half_x * rz_half_x + ry_half_y * rz_half_y
            + ry_half_z * rz_half_z;
        reference[182] = 0.5 * (r1y_x * r1y_x + r1y_y * r1y_y + r1y_z * r1y_z - 1.0);
        reference[183] = 0.5 * (r1z_x * r1z_x + r1z_y * r1z_y + r1z_z * r1z_z - 1.0);
        reference[184] = r1y_x * r1z_x + r1y_y * r1z_y + r1y_z * r1z_z;
    }
    /// Weights of the nodal vectors in the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 6 additions, 12 multiplications.
    pub fn full_beam_spatial_curved_damped_shapes_position_0(
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
    pub fn full_beam_spatial_curved_damped_shapes_position_1(
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
    pub fn full_beam_spatial_curved_damped_shapes_section_y_0(
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
    pub fn full_beam_spatial_curved_damped_shapes_section_y_1(
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
    pub fn full_beam_spatial_curved_damped_shapes_section_z_0(
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
    pub fn full_beam_spatial_curved_damped_shapes_section_z_1(
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
    /// Operations: 390 additions, 555 multiplications, 37 divisions, 2 function calls.
    pub fn full_beam_spatial_curved_damped_field_forces(
        row: &FullBeamSpatialCurvedDamped,
        coefficients: &[f64; 23],
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        rates: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [D1, D2, D3, D4, D5, D6, L21, L31, L32, L41, L42, L43, L51, L52, L53, L54,
        L61, L62, L63, L64, L65, held, half_held] = *coefficients;
        let t79 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t80 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8];
        let t81 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
            - (t79 * t79 + t80 * t80);
        let t82 = t81.sqrt();
        let t83 = t82 - 1.0;
        let t84 = fields[6] * fields[9] + fields[7] * fields[10] + fields[8] * fields[11]
            - (fields[3] * fields[12] + fields[4] * fields[13] + fields[5] * fields[14]);
        let t85 = 0.5 * t84;
        let t86 = 1.0
            - 0.5
                * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                    - 1.0);
        let t87 = 1.0
            - 0.5
                * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                    - 1.0);
        let t88 = t86 * t87;
        let t89 = (fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14] + t79 * t85) / t82;
        let t90 = t87 * t89;
        let t91 = (fields[0] * fields[9] + fields[1] * fields[10]
            + fields[2] * fields[11] - t80 * t85) / t82;
        let t92 = t86 * t91;
        let t93 = t85 * t88 + t90 * L21 - t92 * L31 + t83 * L41 + t79 * L51;
        let t94 = stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
            + stress_free[2] * stress_free[5];
        let t95 = stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
            + stress_free[2] * stress_free[8];
        let t96 = stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
            + stress_free[2] * stress_free[2] - (t94 * t94 + t95 * t95);
        let t97 = t96.sqrt();
        let t98 = t97 - 1.0;
        let t99 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11]
            - (stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
                + stress_free[5] * stress_free[14]);
        let t100 = 0.5 * t99;
        let t101 = 1.0
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t102 = 1.0
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t103 = t102
            * ((stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14] + t94 * t100) / t97);
        let t104 = t101
            * ((stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11] - t95 * t100) / t97);
        let t105 = t100 * (t101 * t102) + L21 * t103 - L31 * t104 + L41 * t98
            + L51 * t94;
        let t106 = fields[0] * 2.0;
        let t107 = fields[1] * 2.0;
        let t108 = fields[2] * 2.0;
        let t109 = fields[3] * rates[0] + fields[0] * rates[3]
            + (fields[4] * rates[1] + fields[1] * rates[4])
            + (fields[5] * rates[2] + fields[2] * rates[5]);
        let t110 = fields[6] * rates[0] + fields[0] * rates[6]
            + (fields[7] * rates[1] + fields[1] * rates[7])
            + (fields[8] * rates[2] + fields[2] * rates[8]);
        let t111 = fields[9] * rates[0] + fields[0] * rates[9]
            + (fields[10] * rates[1] + fields[1] * rates[10])
            + (fields[11] * rates[2] + fields[2] * rates[11]);
        let t112 = fields[12] * rates[0] + fields[0] * rates[12]
            + (fields[13] * rates[1] + fields[1] * rates[13])
            + (fields[14] * rates[2] + fields[2] * rates[14]);
        let t113 = fields[3] * 2.0;
        let t114 = fields[4] * 2.0;
        let t115 = fields[5] * 2.0;
        let t116 = fields[12] * rates[3] + fields[3] * rates[12]
            + (fields[13] * rates[4] + fields[4] * rates[13])
            + (fields[14] * rates[5] + fields[5] * rates[14]);
        let t117 = fields[6] * 2.0;
        let t118 = fields[7] * 2.0;
        let t119 = fields[8] * 2.0;
        let t120 = fields[9] * rates[6] + fields[6] * rates[9]
            + (fields[10] * rates[7] + fields[7] * rates[10])
            + (fields[11] * rates[8] + fields[8] * rates[11]);
        let t121 = 0.5 * (rates[3] * t113 + rates[4] * t114 + rates[5] * t115);
        let t122 = 0.5 * (rates[6] * t117 + rates[7] * t118 + rates[8] * t119);
        let t123 = t79 * 2.0;
        let t124 = t80 * 2.0;
        let t125 = rates[0] * t106 + rates[1] * t107 + rates[2] * t108
            - (t109 * t123 + t110 * t124);
        let t126 = 1.0 / (t82 * 2.0);
        let t127 = t125 * t126;
        let t128 = 0.5 * (t120 - t116);
        let t129 = t87 * ((t112 + (t85 * t109 + t79 * t128) - t89 * t127) / t82)
            - t89 * t122;
        let t130 = t86 * ((t111 - (t85 * t110 + t80 * t128) - t91 * t127) / t82)
            - t91 * t121;
        let t131 = t88 * t128 - t85 * (t87 * t121 + t86 * t122) + L21 * t129
            - L31 * t130;
        let t132 = t93 + t80 * L61 - (t105 + L61 * t95)
            + damping * (t131 + L41 * t127 + L51 * t109 + L61 * t110);
        let t133 = D1 * t132;
        let t134 = t126 * (t106 - (fields[3] * t123 + fields[6] * t124));
        let t135 = t87 * ((fields[12] + fields[3] * t85 - t89 * t134) / t82);
        let t136 = t86 * ((fields[9] - fields[6] * t85 - t91 * t134) / t82);
        let t137 = L21 * t135 - L31 * t136 + L41 * t134 + fields[3] * L51
            + fields[6] * L61;
        let t138 = t126 * (t107 - (fields[4] * t123 + fields[7] * t124));
        let t139 = t87 * ((fields[13] + fields[4] * t85 - t89 * t138) / t82);
        let t140 = t86 * ((fields[10] - fields[7] * t85 - t91 * t138) / t82);
        let t141 = L21 * t139 - L31 * t140 + L41 * t138 + fields[4] * L51
            + fields[7] * L61;
        let t142 = t126 * (t108 - (fields[5] * t123 + fields[8] * t124));
        let t143 = t87 * ((fields[14] + fields[5] * t85 - t89 * t142) / t82);
        let t144 = t86 * ((fields[11] - fields[8] * t85 - t91 * t142) / t82);
        let t145 = L21 * t143 - L31 * t144 + L41 * t142 + fields[5] * L51
            + fields[8] * L61;
        let t146 = 0.5 * t113;
        let t147 = t126 * (fields[0] * t123);
        let t148 = fields[12] * 0.5;
        let t149 = fields[0] * t85;
        let t150 = t87 * ((t149 - t79 * t148 + t89 * t147) / t82);
        let t151 = t86 * ((t80 * t148 + t91 * t147) / t82) - t91 * t146;
        let t152 = L21 * t150 - (t88 * t148 + t85 * (t87 * t146)) - L31 * t151
            - L41 * t147;
        let t153 = 0.5 * t114;
        let t154 = t126 * (fields[1] * t123);
        let t155 = fields[13] * 0.5;
        let t156 = fields[1] * t85;
        let t157 = t87 * ((t156 - t79 * t155 + t89 * t154) / t82);
        let t158 = t86 * ((t80 * t155 + t91 * t154) / t82) - t91 * t153;
        let t159 = L21 * t157 - (t88 * t155 + t85 * (t87 * t153)) - L31 * t158
            - L41 * t154;
        let t160 = 0.5 * t115;
        let t161 = t126 * (fields[2] * t123);
        let t162 = fields[14] * 0.5;
        let t163 = fields[2] * t85;
        let t164 = t87 * ((t163 - t79 * t162 + t89 * t161) / t82);
        let t165 = t86 * ((t80 * t162 + t91 * t161) / t82) - t91 * t160;
        let t166 = L21 * t164 - (t88 * t162 + t85 * (t87 * t160)) - L31 * t165
            - L41 * t161;
        let t167 = 0.5 * t117;
        let t168 = t126 * (fields[0] * t124);
        let t169 = fields[9] * 0.5;
        let t170 = t87 * ((t79 * t169 + t89 * t168) / t82) - t89 * t167;
        let t171 = t86 * ((t91 * t168 - (t149 + t80 * t169)) / t82);
        let t172 = t88 * t169 - t85 * (t86 * t167) + L21 * t170 - L31 * t171
            - L41 * t168;
        let t173 = 0.5 * t118;
        let t174 = t126 * (fields[1] * t124);
        let t175 = fields[10] * 0.5;
        let t176 = t87 * ((t79 * t175 + t89 * t174) / t82) - t89 * t173;
        let t177 = t86 * ((t91 * t174 - (t156 + t80 * t175)) / t82);
        let t178 = t88 * t175 - t85 * (t86 * t173) + L21 * t176 - L31 * t177
            - L41 * t174;
        let t179 = 0.5 * t119;
        let t180 = t126 * (fields[2] * t124);
        let t181 = fields[11] * 0.5;
        let t182 = t87 * ((t79 * t181 + t89 * t180) / t82) - t89 * t179;
        let t183 = t86 * ((t91 * t180 - (t163 + t80 * t181)) / t82);
        let t184 = t88 * t181 - t85 * (t86 * t179) + L21 * t182 - L31 * t183
            - L41 * t180;
        let t185 = fields[6] * 0.5;
        let t186 = t87 * (t79 * t185 / t82);
        let t187 = t86 * ((fields[0] - t80 * t185) / t82);
        let t188 = fields[7] * 0.5;
        let t189 = t87 * (t79 * t188 / t82);
        let t190 = t86 * ((fields[1] - t80 * t188) / t82);
        let t191 = fields[8] * 0.5;
        let t192 = t87 * (t79 * t191 / t82);
        let t193 = t86 * ((fields[2] - t80 * t191) / t82);
        let t194 = fields[3] * 0.5;
        let t195 = t87 * ((fields[0] - t79 * t194) / t82);
        let t196 = t86 * (t80 * t194 / t82);
        let t197 = fields[4] * 0.5;
        let t198 = t87 * ((fields[1] - t79 * t197) / t82);
        let t199 = t86 * (t80 * t197 / t82);
        let t200 = fields[5] * 0.5;
        let t201 = t87 * ((fields[2] - t79 * t200) / t82);
        let t202 = t86 * (t80 * t200 / t82);
        let t203 = t90 - t92 * L32 + t83 * L42 + t79 * L52 + t80 * L62
            - (t103 - L32 * t104 + L42 * t98 + L52 * t94 + L62 * t95);
        let t204 = damping * (t129 - L32 * t130 + L42 * t127 + L52 * t109 + L62 * t110);
        let t205 = D2 * (t203 + t204);
        let t206 = t205
            * (t135 - L32 * t136 + L42 * t134 + fields[3] * L52 + fields[6] * L62);
        let t207 = t205
            * (t139 - L32 * t140 + L42 * t138 + fields[4] * L52 + fields[7] * L62);
        let t208 = t205
            * (t143 - L32 * t144 + L42 * t142 + fields[5] * L52 + fields[8] * L62);
        let t209 = t133 * (t152 + fields[0] * L51)
            + t205 * (t150 - L32 * t151 - L42 * t147 + fields[0] * L52);
        let t210 = t133 * (t159 + fields[1] * L51)
            + t205 * (t157 - L32 * t158 - L42 * t154 + fields[1] * L52);
        let t211 = t133 * (t166 + fields[2] * L51)
            + t205 * (t164 - L32 * t165 - L42 * t161 + fields[2] * L52);
        let t212 = t133 * (t172 + fields[0] * L61)
            + t205 * (t170 - L32 * t171 - L42 * t168 + fields[0] * L62);
        let t213 = t133 * (t178 + fields[1] * L61)
            + t205 * (t176 - L32 * t177 - L42 * t174 + fields[1] * L62);
        let t214 = t133 * (t184 + fields[2] * L61)
            + t205 * (t182 - L32 * t183 - L42 * t180 + fields[2] * L62);
        let t215 = t133 * (t88 * t185 + L21 * t186 - L31 * t187)
            + t205 * (t186 - L32 * t187);
        let t216 = t133 * (t88 * t188 + L21 * t189 - L31 * t190)
            + t205 * (t189 - L32 * t190);
        let t217 = t133 * (t88 * t191 + L21 * t192 - L31 * t193)
            + t205 * (t192 - L32 * t193);
        let t218 = t133 * (L21 * t195 - t88 * t194 - L31 * t196)
            + t205 * (t195 - L32 * t196);
        let t219 = t133 * (L21 * t198 - t88 * t197 - L31 * t199)
            + t205 * (t198 - L32 * t199);
        let t220 = t133 * (L21 * t201 - t88 * t200 - L31 * t202)
            + t205 * (t201 - L32 * t202);
        let t221 = t83 * L43 - t92 + t79 * L53 + t80 * L63
            - (L43 * t98 - t104 + L53 * t94 + L63 * t95);
        let t222 = D3 * (t221 + damping * (L43 * t127 - t130 + L53 * t109 + L63 * t110));
        let t223 = t133 * t137 + t206
            + t222 * (L43 * t134 - t136 + fields[3] * L53 + fields[6] * L63);
        let t224 = t133 * t141 + t207
            + t222 * (L43 * t138 - t140 + fields[4] * L53 + fields[7] * L63);
        let t225 = t133 * t145 + t208
            + t222 * (L43 * t142 - t144 + fields[5] * L53 + fields[8] * L63);
        let t226 = t83 + t79 * L54 + t80 * L64 - (t98 + L54 * t94 + L64 * t95);
        let t227 = D4 * (t226 + damping * (t127 + L54 * t109 + L64 * t110));
        let t228 = t209 + t222 * (fields[0] * L53 - (t151 + L43 * t147))
            + t227 * (fields[0] * L54 - t147);
        let t229 = t210 + t222 * (fields[1] * L53 - (t158 + L43 * t154))
            + t227 * (fields[1] * L54 - t154);
        let t230 = t211 + t222 * (fields[2] * L53 - (t165 + L43 * t161))
            + t227 * (fields[2] * L54 - t161);
        let t231 = t212 + t222 * (fields[0] * L63 - (t171 + L43 * t168))
            + t227 * (fields[0] * L64 - t168);
        let t232 = t213 + t222 * (fields[1] * L63 - (t177 + L43 * t174))
            + t227 * (fields[1] * L64 - t174);
        let t233 = t214 + t222 * (fields[2] * L63 - (t183 + L43 * t180))
            + t227 * (fields[2] * L64 - t180);
        let t234 = t79 + t80 * L65 - (t94 + L65 * t95) + damping * (t109 + L65 * t110);
        let t235 = D5 * t234;
        let t236 = t223 + t227 * (t134 + fields[3] * L54 + fields[6] * L64)
            + t235 * (fields[3] + fields[6] * L65);
        let t237 = t224 + t227 * (t138 + fields[4] * L54 + fields[7] * L64)
            + t235 * (fields[4] + fields[7] * L65);
        let t238 = t225 + t227 * (t142 + fields[5] * L54 + fields[8] * L64)
            + t235 * (fields[5] + fields[8] * L65);
        let t239 = D6 * (t80 - t95 + damping * t110);
        forces[0] = t236 + fields[6] * t239;
        forces[1] = t237 + fields[7] * t239;
        forces[2] = t238 + fields[8] * t239;
        forces[3] = t228 + fields[0] * t235;
        forces[4] = t229 + fields[1] * t235;
        forces[5] = t230 + fields[2] * t235;
        forces[6] = t231 + t235 * (fields[0] * L65) + fields[0] * t239;
        forces[7] = t232 + t235 * (fields[1] * L65) + fields[1] * t239;
        forces[8] = t233 + t235 * (fields[2] * L65) + fields[2] * t239;
        forces[9] = t215 - t187 * t222;
        forces[10] = t216 - t190 * t222;
        forces[11] = t217 - t193 * t222;
        forces[12] = t218 - t196 * t222;
        forces[13] = t219 - t199 * t222;
        forces[14] = t220 - t202 * t222;
    }
    /// Motion of frame `rotor` and its first two derivatives.
    ///
    /// Operations: 0 additions, 1 multiplications, 2 function calls.
    pub fn frame_rotor(
        model: &Nrel5mwBlade,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let t14 = t * model.speed;
        let t15 = t14.cos();
        let t16 = t14.sin();
        motion.spin[0] = model.speed;
        motion.rotation[(1, 1)] = t15;
        motion.rotation[(1, 2)] = -t16;
        motion.rotation[(2, 1)] = t16;
        motion.rotation[(2, 2)] = t15;
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_weight(model: &Nrel5mwBlade, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = -model.gravity;
        value[2] = 0.0;
    }
    /// Joint `hub`: conditions, position level.
    ///
    /// Operations: 15 additions, 19 multiplications.
    pub fn joint_hub_referenced_position(
        model: &Nrel5mwBlade,
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
    /// Joint `hub`: derivatives of the conditions.
    ///
    /// Operations: 3 additions, 12 multiplications.
    pub fn joint_hub_referenced_jacobian(
        model: &Nrel5mwBlade,
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
    /// Joint `hub`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_hub_referenced_prescribed(
        model: &Nrel5mwBlade,
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
    /// Joint `hub`: conditions, position level.
    ///
    /// Operations: 21 additions, 32 multiplications, 2 function calls.
    pub fn joint_hub_absolute_position(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t32 = t * model.speed;
        let t33 = t32.cos();
        let t34 = t32.sin();
        let t35 = t33 * data.tangent[1] - t34 * data.tangent[2];
        let t36 = t34 * data.tangent[1] + t33 * data.tangent[2];
        let t37 = t33 * data.second[1] - t34 * data.second[2];
        let t38 = t34 * data.second[1] + t33 * data.second[2];
        let t39 = t35 * t38 - t36 * t37;
        let t40 = data.second[0] * t36 - data.tangent[0] * t38;
        let t41 = data.tangent[0] * t37 - data.second[0] * t35;
        let t42 = data.second[0] * q[3] + q[4] * t37 + q[5] * t38
            - (data.tangent[0] * q[6] + q[7] * t35 + q[8] * t36);
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t33 * data.point[1] - t34 * data.point[2]);
        rows[2] = q[2] - (t34 * data.point[1] + t33 * data.point[2]);
        rows[3] = q[3] * t39 + q[4] * t40 + q[5] * t41;
        rows[4] = q[6] * t39 + q[7] * t40 + q[8] * t41;
        rows[5] = 0.5 * t42;
    }
    /// Joint `hub`: conditions, velocity level.
    ///
    /// Operations: 22 additions, 42 multiplications, 2 function calls.
    pub fn joint_hub_absolute_velocity(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t28 = t * model.speed;
        let t29 = t28.cos();
        let t30 = t28.sin();
        let t31 = model.speed * t30;
        let t32 = model.speed * t29;
        let t33 = data.tangent[1] * t31 + data.tangent[2] * t32;
        let t34 = data.tangent[1] * t32 - data.tangent[2] * t31;
        let t35 = data.second[1] * t31 + data.second[2] * t32;
        let t36 = data.second[1] * t32 - data.second[2] * t31;
        let t37 = (t29 * data.tangent[1] - t30 * data.tangent[2]) * t36
            - (t30 * data.second[1] + t29 * data.second[2]) * t33;
        let t38 = (t29 * data.second[1] - t30 * data.second[2]) * t34
            - (t30 * data.tangent[1] + t29 * data.tangent[2]) * t35;
        let t39 = t37 - t38;
        let t40 = data.second[0] * t34 - data.tangent[0] * t36;
        let t41 = data.second[0] * t33 - data.tangent[0] * t35;
        rows[1] = data.point[1] * t31 + data.point[2] * t32;
        rows[2] = data.point[2] * t31 - data.point[1] * t32;
        rows[3] = q[5] * t41 + (q[3] * t39 + q[4] * t40);
        rows[4] = q[8] * t41 + (q[6] * t39 + q[7] * t40);
        rows[5] = 0.5 * (q[5] * t36 - q[4] * t35 - (q[8] * t34 - q[7] * t33));
    }
    /// Joint `hub`: conditions, acceleration level.
    ///
    /// Operations: 55 additions, 72 multiplications, 2 function calls.
    pub fn joint_hub_absolute_acceleration(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t34 = t * model.speed;
        let t35 = t34.cos();
        let t36 = t34.sin();
        let t37 = t35 * data.tangent[1] - t36 * data.tangent[2];
        let t38 = t36 * data.tangent[1] + t35 * data.tangent[2];
        let t39 = t35 * data.second[1] - t36 * data.second[2];
        let t40 = t36 * data.second[1] + t35 * data.second[2];
        let t41 = model.speed * t36;
        let t42 = model.speed * t35;
        let t43 = data.tangent[1] * t41 + data.tangent[2] * t42;
        let t44 = data.tangent[1] * t42 - data.tangent[2] * t41;
        let t45 = data.second[1] * t41 + data.second[2] * t42;
        let t46 = data.second[1] * t42 - data.second[2] * t41;
        let t47 = t37 * t46 - t40 * t43 - (t39 * t44 - t38 * t45);
        let t48 = data.second[0] * t44 - data.tangent[0] * t46;
        let t49 = data.second[0] * t43 - data.tangent[0] * t45;
        let t50 = model.speed * t42;
        let t51 = model.speed * t41;
        let t52 = data.tangent[1] * t50 - data.tangent[2] * t51;
        let t53 = data.tangent[1] * t51 + data.tangent[2] * t50;
        let t54 = data.second[1] * t50 - data.second[2] * t51;
        let t55 = data.second[1] * t51 + data.second[2] * t50;
        let t56 = t43 * t46;
        let t57 = t44 * t45;
        let t58 = t57 + t39 * t53 + (t57 + t38 * t54)
            - (t56 + t40 * t52 + (t56 + t37 * t55));
        let t59 = data.tangent[0] * t55 - data.second[0] * t53;
        let t60 = data.second[0] * t52 - data.tangent[0] * t54;
        let t61 = v[3] * t47;
        let t62 = v[4] * t48;
        let t63 = v[5] * t49;
        let t64 = v[6] * t47;
        let t65 = v[7] * t48;
        let t66 = v[8] * t49;
        let t67 = v[4] * t45;
        let t68 = v[5] * t46;
        let t69 = v[7] * t43;
        let t70 = v[8] * t44;
        let t71 = t61 + (t61 + q[3] * t58) + (t62 + (t62 + q[4] * t59))
            + (t63 + (t63 + q[5] * t60));
        let t72 = t64 + (t64 + q[6] * t58) + (t65 + (t65 + q[7] * t59))
            + (t66 + (t66 + q[8] * t60));
        let t73 = t68 + (t68 - q[5] * t55) - (t67 + (t67 + q[4] * t54))
            - (t70 + (t70 - q[8] * t53) - (t69 + (t69 + q[7] * t52)));
        rows[1] = data.point[1] * t50 - data.point[2] * t51;
        rows[2] = data.point[1] * t51 + data.point[2] * t50;
        rows[3] = t71;
        rows[4] = t72;
        rows[5] = 0.5 * t73;
    }
    /// Joint `hub`: conditions, jerk level.
    ///
    /// Operations: 104 additions, 104 multiplications, 2 function calls.
    pub fn joint_hub_absolute_jerk(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t40 = t * model.speed;
        let t41 = t40.cos();
        let t42 = t40.sin();
        let t43 = t41 * data.tangent[1] - t42 * data.tangent[2];
        let t44 = t42 * data.tangent[1] + t41 * data.tangent[2];
        let t45 = t41 * data.second[1] - t42 * data.second[2];
        let t46 = t42 * data.second[1] + t41 * data.second[2];
        let t47 = model.speed * t42;
        let t48 = model.speed * t41;
        let t49 = data.tangent[1] * t47 + data.tangent[2] * t48;
        let t50 = data.tangent[1] * t48 - data.tangent[2] * t47;
        let t51 = data.second[1] * t47 + data.second[2] * t48;
        let t52 = data.second[1] * t48 - data.second[2] * t47;
        let t53 = t43 * t52 - t46 * t49 - (t45 * t50 - t44 * t51);
        let t54 = data.second[0] * t50 - data.tangent[0] * t52;
        let t55 = data.second[0] * t49 - data.tangent[0] * t51;
        let t56 = model.speed * t48;
        let t57 = model.speed * t47;
        let t58 = data.tangent[1] * t56 - data.tangent[2] * t57;
        let t59 = data.tangent[1] * t57 + data.tangent[2] * t56;
        let t60 = data.second[1] * t56 - data.second[2] * t57;
        let t61 = data.second[1] * t57 + data.second[2] * t56;
        let t62 = t49 * t52;
        let t63 = t50 * t51;
        let t64 = t63 + t45 * t59 + (t63 + t44 * t60)
            - (t62 + t46 * t58 + (t62 + t43 * t61));
        let t65 = data.tangent[0] * t61 - data.second[0] * t59;
        let t66 = data.second[0] * t58 - data.tangent[0] * t60;
        let t67 = model.speed * t57;
        let t68 = model.speed * t56;
        let t69 = data.tangent[1] * t67 + data.tangent[2] * t68;
        let t70 = data.tangent[1] * t68 - data.tangent[2] * t67;
        let t71 = data.second[1] * t67 + data.second[2] * t68;
        let t72 = data.second[1] * t68 - data.second[2] * t67;
        let t73 = t52 * t58;
        let t74 = t49 * t61;
        let t75 = t73 - t74;
        let t76 = t51 * t59;
        let t77 = t50 * t60;
        let t78 = t77 - t76;
        let t79 = t78 + (t45 * t70 - t76) + (t78 + (t77 - t44 * t71))
            - (t75 + (t73 - t46 * t69) + (t75 + (t43 * t72 - t74)));
        let t80 = data.tangent[0] * t72 - data.second[0] * t70;
        let t81 = data.tangent[0] * t71 - data.second[0] * t69;
        let t82 = a[3] * t53;
        let t83 = v[3] * t64;
        let t84 = t82 + t83;
        let t85 = a[4] * t54;
        let t86 = v[4] * t65;
        let t87 = t85 + t86;
        let t88 = t82 + t84 + (t84 + (t83 + q[3] * t79))
            + (t85 + t87 + (t87 + (t86 + q[4] * t80)));
        let t89 = a[5] * t55;
        let t90 = v[5] * t66;
        let t91 = t89 + t90;
        let t92 = a[6] * t53;
        let t93 = v[6] * t64;
        let t94 = t92 + t93;
        let t95 = a[7] * t54;
        let t96 = v[7] * t65;
        let t97 = t95 + t96;
        let t98 = t92 + t94 + (t94 + (t93 + q[6] * t79))
            + (t95 + t97 + (t97 + (t96 + q[7] * t80)));
        let t99 = a[8] * t55;
        let t100 = v[8] * t66;
        let t101 = t99 + t100;
        let t102 = a[4] * t51;
        let t103 = v[4] * t60;
        let t104 = t102 + t103;
        let t105 = a[5] * t52;
        let t106 = v[5] * t61;
        let t107 = t105 - t106;
        let t108 = t105 + t107 + (t107 - (t106 + q[5] * t72))
            - (t102 + t104 + (t104 + (t103 - q[4] * t71)));
        let t109 = a[7] * t49;
        let t110 = v[7] * t58;
        let t111 = t109 + t110;
        let t112 = a[8] * t50;
        let t113 = v[8] * t59;
        let t114 = t112 - t113;
        let t115 = t112 + t114 + (t114 - (t113 + q[8] * t70))
            - (t109 + t111 + (t111 + (t110 - q[7] * t69)));
        rows[1] = -(data.point[1] * t67 + data.point[2] * t68);
        rows[2] = data.point[1] * t68 - data.point[2] * t67;
        rows[3] = t88 + (t89 + t91 + (t91 + (t90 + q[5] * t81)));
        rows[4] = t98 + (t99 + t101 + (t101 + (t100 + q[8] * t81)));
        rows[5] = 0.5 * (t108 - t115);
    }
    /// Joint `hub`: derivatives of the conditions.
    ///
    /// Operations: 8 additions, 21 multiplications, 2 function calls.
    pub fn joint_hub_absolute_jacobian(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let t20 = t * model.speed;
        let t21 = t20.cos();
        let t22 = t20.sin();
        let t23 = t21 * data.tangent[1];
        let t24 = t22 * data.tangent[2];
        let t25 = t23 - t24;
        let t26 = t22 * data.tangent[1] + t21 * data.tangent[2];
        let t27 = t21 * data.second[1] - t22 * data.second[2];
        let t28 = t22 * data.second[1] + t21 * data.second[2];
        let t29 = t25 * t28 - t26 * t27;
        let t30 = data.second[0] * t26 - data.tangent[0] * t28;
        let t31 = data.tangent[0] * t27 - data.second[0] * t25;
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = t29;
        jacobian[31] = t30;
        jacobian[32] = t31;
        jacobian[42] = t29;
        jacobian[43] = t30;
        jacobian[44] = t31;
        jacobian[48] = data.second[0] * 0.5;
        jacobian[49] = t27 * 0.5;
        jacobian[50] = t28 * 0.5;
        jacobian[51] = -data.tangent[0] * 0.5;
        jacobian[52] = 0.5 * (t24 - t23);
        jacobian[53] = -t26 * 0.5;
    }
    /// Joint `hub`: what it prescribes, and its derivatives.
    ///
    /// Operations: 18 additions, 41 multiplications, 2 function calls.
    pub fn joint_hub_absolute_prescribed(
        model: &Nrel5mwBlade,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let t23 = t * model.speed;
        let t24 = t23.cos();
        let t25 = t23.sin();
        let t26 = model.speed * t25;
        let t27 = model.speed * t24;
        let t28 = model.speed * t27;
        let t29 = model.speed * t26;
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t24 * data.point[1] - t25 * data.point[2];
        prescribed.position[0][2] = t25 * data.point[1] + t24 * data.point[2];
        prescribed.position[1][1] = -(data.point[1] * t26 + data.point[2] * t27);
        prescribed.position[1][2] = data.point[1] * t27 - data.point[2] * t26;
        prescribed.position[2][1] = data.point[2] * t29 - data.point[1] * t28;
        prescribed.position[2][2] = -(data.point[1] * t29 + data.point[2] * t28);
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t24 * data.tangent[1] - t25 * data.tangent[2];
        prescribed.slope[0][2] = t25 * data.tangent[1] + t24 * data.tangent[2];
        prescribed.slope[1][1] = -(data.tangent[1] * t26 + data.tangent[2] * t27);
        prescribed.slope[1][2] = data.tangent[1] * t27 - data.tangent[2] * t26;
        prescribed.slope[2][1] = data.tangent[2] * t29 - data.tangent[1] * t28;
        prescribed.slope[2][2] = -(data.tangent[1] * t29 + data.tangent[2] * t28);
        prescribed.second[0][0] = data.second[0];
        prescribed.second[0][1] = t24 * data.second[1] - t25 * data.second[2];
        prescribed.second[0][2] = t25 * data.second[1] + t24 * data.second[2];
        prescribed.second[1][1] = -(data.second[1] * t26 + data.second[2] * t27);
        prescribed.second[1][2] = data.second[1] * t27 - data.second[2] * t26;
        prescribed.second[2][1] = data.second[2] * t29 - data.second[1] * t28;
        prescribed.second[2][2] = -(data.second[1] * t29 + data.second[2] * t28);
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &Nrel5mwBlade, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &Nrel5mwBlade, run: &mut ::rncf::RunDefaults) {
        run.t_end = 2.0;
        run.every = 0.05;
    }
    /// Coefficients of body `blade` at the arclength x (m) of its axis, and its masses per length that move with r r, r r_y, r r_z, r_y r_y, r_z r_z, r_y r_z.
    pub fn along_blade(
        model: &Nrel5mwBlade,
        x: f64,
        length: f64,
    ) -> ::std::result::Result<([f64; 23], [f64; 6]), ::rncf::ModelError> {
        let law = ::rncf::emitted::SectionLaw::new(
            "layup",
            ::rncf::emitted::Stiffness::Matrix([
                TABLE_SECTIONS.at(12, x, length),
                TABLE_SECTIONS.at(3, x, length),
                TABLE_SECTIONS.at(8, x, length),
                TABLE_SECTIONS.at(15, x, length),
                TABLE_SECTIONS.at(13, x, length),
                TABLE_SECTIONS.at(14, x, length),
                TABLE_SECTIONS.at(1, x, length),
                TABLE_SECTIONS.at(2, x, length),
                TABLE_SECTIONS.at(6, x, length),
                TABLE_SECTIONS.at(4, x, length),
                TABLE_SECTIONS.at(5, x, length),
                TABLE_SECTIONS.at(7, x, length),
                TABLE_SECTIONS.at(11, x, length),
                TABLE_SECTIONS.at(9, x, length),
                TABLE_SECTIONS.at(10, x, length),
                TABLE_SECTIONS.at(21, x, length),
                TABLE_SECTIONS.at(18, x, length),
                TABLE_SECTIONS.at(20, x, length),
                TABLE_SECTIONS.at(16, x, length),
                TABLE_SECTIONS.at(17, x, length),
                TABLE_SECTIONS.at(19, x, length),
            ]),
            ::rncf::emitted::Mass::Matrix([
                TABLE_SECTIONS.at(33, x, length),
                TABLE_SECTIONS.at(24, x, length),
                TABLE_SECTIONS.at(29, x, length),
                TABLE_SECTIONS.at(36, x, length),
                TABLE_SECTIONS.at(34, x, length),
                TABLE_SECTIONS.at(35, x, length),
                TABLE_SECTIONS.at(22, x, length),
                TABLE_SECTIONS.at(23, x, length),
                TABLE_SECTIONS.at(27, x, length),
                TABLE_SECTIONS.at(25, x, length),
                TABLE_SECTIONS.at(26, x, length),
                TABLE_SECTIONS.at(28, x, length),
                TABLE_SECTIONS.at(32, x, length),
                TABLE_SECTIONS.at(30, x, length),
                TABLE_SECTIONS.at(31, x, length),
                TABLE_SECTIONS.at(42, x, length),
                TABLE_SECTIONS.at(39, x, length),
                TABLE_SECTIONS.at(41, x, length),
                TABLE_SECTIONS.at(37, x, length),
                TABLE_SECTIONS.at(38, x, length),
                TABLE_SECTIONS.at(40, x, length),
            ]),
        )?;
        Ok((law.coefficients(), law.masses()))
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: Nrel5mwBlade,
        pub row_blade: ::std::vec::Vec<FullBeamSpatialCurvedDamped>,
        pub reference_blade: ::std::vec::Vec<[f64; 208]>,
        pub mass_blade: ::std::vec::Vec<::std::vec::Vec<f64>>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &Nrel5mwBlade) -> Self {
            Self {
                model: model.clone(),
                row_blade: Default::default(),
                reference_blade: ::std::vec::Vec::new(),
                mass_blade: ::std::vec::Vec::new(),
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
                ::rncf::emitted::ObservedSpec::Balance {
                    of: ::rncf::emitted::Owner::Body(0),
                    what: ::rncf::emitted::BalanceQuantity::Mass,
                    component: 0,
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
            ["inertial", "rotor"][frame]
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
            frame_rotor(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("body `blade` is damped")
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
                    name: "blade",
                    kind: 0,
                    instance: None,
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 1.5],
                        to: [0.0, 0.0, 63.0],
                    },
                    count: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Straight {
                                from: [0.0, 0.0, 1.5],
                                to: [0.0, 0.0, 63.0],
                            }
                                .length(),
                            (model.each as f64) as usize,
                        )
                        .len() - 1,
                    stations: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Straight {
                                from: [0.0, 0.0, 1.5],
                                to: [0.0, 0.0, 63.0],
                            }
                                .length(),
                            (model.each as f64) as usize,
                        ),
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
                    section_y: Some([1.0, 0.0, 0.0]),
                    twist: {
                        let (model, length) = (
                            model.clone(),
                            ::rncf::emitted::Line::Straight {
                                from: [0.0, 0.0, 1.5],
                                to: [0.0, 0.0, 63.0],
                            }
                                .length(),
                        );
                        ::rncf::emitted::Twist::along(move |u| {
                            let x = u * length;
                            -TABLE_POINTS.at(3, x, length)
                        })
                    },
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
            let length = nodes[nodes.len() - 1];
            TABLE_SECTIONS.check("blade", length)?;
            TABLE_POINTS.check("blade", length)?;
            let at = |x: f64| {
                along_blade(model, x, length)
                    .map_err(|error| ::rncf::ModelError::new(
                        format!("{error}; at x = {x:.6} m of body `blade`"),
                    ))
            };
            let (mut rows, mut references, mut masses) = (
                ::std::vec::Vec::new(),
                ::std::vec::Vec::new(),
                ::std::vec::Vec::new(),
            );
            for (nodes, shape) in nodes.windows(2).zip(shape.chunks_exact(30)) {
                let row = FullBeamSpatialCurvedDamped {
                    length: nodes[1] - nodes[0],
                    damping: 0.002,
                };
                let mut reference = [0.0; 208];
                for (place, xi) in [
                    (3, 0.21132486540518713),
                    (29, 0.7886751345948129),
                    (55, 0.1127016653792583),
                    (81, 0.5),
                    (107, 0.8872983346207417),
                    (133, 0.0),
                    (159, 0.5),
                    (185, 1.0),
                ] {
                    let (coefficients, _) = at(nodes[0] + xi * row.length)?;
                    reference[place..place + 23].copy_from_slice(&coefficients);
                }
                full_beam_spatial_curved_damped_reference(
                    &row,
                    ::rncf::emitted::array(shape),
                    &mut reference,
                );
                masses
                    .push(
                        ::rncf::emitted::mass_along(
                            10,
                            row.length,
                            |xi| Ok(at(nodes[0] + xi * row.length)?.1),
                            |of, xi, weights| match of {
                                ::rncf::emitted::Interpolant::Position => {
                                    full_beam_spatial_curved_damped_shapes_position_0(
                                        row.length,
                                        xi,
                                        ::rncf::emitted::array_mut(weights),
                                    )
                                }
                                ::rncf::emitted::Interpolant::SectionY => {
                                    full_beam_spatial_curved_damped_shapes_section_y_0(
                                        row.length,
                                        xi,
                                        ::rncf::emitted::array_mut(weights),
                                    )
                                }
                                ::rncf::emitted::Interpolant::SectionZ => {
                                    full_beam_spatial_curved_damped_shapes_section_z_0(
                                        row.length,
                                        xi,
                                        ::rncf::emitted::array_mut(weights),
                                    )
                                }
                                #[allow(unreachable_patterns)]
                                _ => {}
                            },
                        )?,
                    );
                rows.push(row);
                references.push(reference);
            }
            self.row_blade = rows;
            self.reference_blade = references;
            self.mass_blade = masses;
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
            true
        }
        fn tables(
            &self,
            body: usize,
        ) -> ::std::vec::Vec<&'static ::rncf::emitted::Table> {
            ::std::vec::Vec::from([&TABLE_SECTIONS, &TABLE_POINTS])
        }
        fn properties(
            &self,
            body: usize,
            x: f64,
            length: f64,
        ) -> ::std::vec::Vec<(&'static str, f64)> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ("K11", TABLE_SECTIONS.at(12, x, length)),
                ("K12", TABLE_SECTIONS.at(3, x, length)),
                ("K13", TABLE_SECTIONS.at(8, x, length)),
                ("K14", TABLE_SECTIONS.at(15, x, length)),
                ("K15", TABLE_SECTIONS.at(13, x, length)),
                ("K16", TABLE_SECTIONS.at(14, x, length)),
                ("K22", TABLE_SECTIONS.at(1, x, length)),
                ("K23", TABLE_SECTIONS.at(2, x, length)),
                ("K24", TABLE_SECTIONS.at(6, x, length)),
                ("K25", TABLE_SECTIONS.at(4, x, length)),
                ("K26", TABLE_SECTIONS.at(5, x, length)),
                ("K33", TABLE_SECTIONS.at(7, x, length)),
                ("K34", TABLE_SECTIONS.at(11, x, length)),
                ("K35", TABLE_SECTIONS.at(9, x, length)),
                ("K36", TABLE_SECTIONS.at(10, x, length)),
                ("K44", TABLE_SECTIONS.at(21, x, length)),
                ("K45", TABLE_SECTIONS.at(18, x, length)),
                ("K46", TABLE_SECTIONS.at(20, x, length)),
                ("K55", TABLE_SECTIONS.at(16, x, length)),
                ("K56", TABLE_SECTIONS.at(17, x, length)),
                ("K66", TABLE_SECTIONS.at(19, x, length)),
                ("M11", TABLE_SECTIONS.at(33, x, length)),
                ("M12", TABLE_SECTIONS.at(24, x, length)),
                ("M13", TABLE_SECTIONS.at(29, x, length)),
                ("M14", TABLE_SECTIONS.at(36, x, length)),
                ("M15", TABLE_SECTIONS.at(34, x, length)),
                ("M16", TABLE_SECTIONS.at(35, x, length)),
                ("M22", TABLE_SECTIONS.at(22, x, length)),
                ("M23", TABLE_SECTIONS.at(23, x, length)),
                ("M24", TABLE_SECTIONS.at(27, x, length)),
                ("M25", TABLE_SECTIONS.at(25, x, length)),
                ("M26", TABLE_SECTIONS.at(26, x, length)),
                ("M33", TABLE_SECTIONS.at(28, x, length)),
                ("M34", TABLE_SECTIONS.at(32, x, length)),
                ("M35", TABLE_SECTIONS.at(30, x, length)),
                ("M36", TABLE_SECTIONS.at(31, x, length)),
                ("M44", TABLE_SECTIONS.at(42, x, length)),
                ("M45", TABLE_SECTIONS.at(39, x, length)),
                ("M46", TABLE_SECTIONS.at(41, x, length)),
                ("M55", TABLE_SECTIONS.at(37, x, length)),
                ("M56", TABLE_SECTIONS.at(38, x, length)),
                ("M66", TABLE_SECTIONS.at(40, x, length)),
            ])
        }
        fn mass(&self, body: usize, element: usize, mass: &mut [f64]) {
            mass.copy_from_slice(&self.mass_blade[element]);
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            full_beam_spatial_curved_damped_elastic_force(
                &self.row_blade[element],
                &self.reference_blade[element],
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
            full_beam_spatial_curved_damped_elastic_tangent(
                &self.row_blade[element],
                &self.reference_blade[element],
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
            full_beam_spatial_curved_damped_strain_energy(
                &self.row_blade[element],
                &self.reference_blade[element],
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
                    full_beam_spatial_curved_damped_shapes_position_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    full_beam_spatial_curved_damped_shapes_position_1(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    full_beam_spatial_curved_damped_shapes_section_y_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    full_beam_spatial_curved_damped_shapes_section_y_1(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 0) => {
                    full_beam_spatial_curved_damped_shapes_section_z_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 1) => {
                    full_beam_spatial_curved_damped_shapes_section_z_1(
                        self.row_blade[element].length,
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
                shape: ::rncf::emitted::SectionShape::Numbers {
                    square_of_gyration: f64::max(
                        TABLE_SECTIONS.at(16, x, length),
                        TABLE_SECTIONS.at(19, x, length),
                    ) / (TABLE_SECTIONS.at(12, x, length)),
                },
                area: 0.0,
                second_moments: [0.0, 0.0],
                torsion_constant: 0.0,
                young_over_shear: 0.0,
                softness_of_curves: 0.0,
                yield_stress: None,
                material: "",
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
            let [x, length] = at;
            if let Ok((coefficients, _)) = along_blade(&self.model, x, length) {
                full_beam_spatial_curved_damped_field_forces(
                    &self.row_blade[0],
                    &coefficients,
                    ::rncf::emitted::array(stress_free),
                    ::rncf::emitted::array(fields),
                    ::rncf::emitted::array(rates),
                    ::rncf::emitted::array_mut(forces),
                );
            }
        }
    }
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::JointConditions for Equations {
        fn joints(&self) -> ::std::vec::Vec<::rncf::emitted::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::JointSpec {
                    name: "hub",
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
                            joint_hub_referenced_position(
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
                            joint_hub_absolute_position(
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
                            joint_hub_absolute_velocity(
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
                            joint_hub_absolute_acceleration(
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
                            joint_hub_absolute_jerk(&self.model, t, data, q, v, a, rows)
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
                    joint_hub_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (0, _) => {
                    joint_hub_absolute_jacobian(&self.model, t, data, jacobian);
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
                    joint_hub_referenced_prescribed(&self.model, t, data, prescribed);
                }
                (0, _) => {
                    joint_hub_absolute_prescribed(&self.model, t, data, prescribed);
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
                    kind: ::rncf::emitted::LoadKind::Gravity,
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
