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
    const NOTES: &'static [&'static str] = &[
        "Body `blade` uses `full_beam_spatial_curved_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2810 and 38098).",
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
            additions: 223,
            multiplications: 336,
            divisions: 17,
            functions: 1,
            weighted: 647,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points2_tangent",
            additions: 2684,
            multiplications: 3832,
            divisions: 64,
            functions: 1,
            weighted: 6792,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points2_energy",
            additions: 56,
            multiplications: 84,
            divisions: 3,
            functions: 1,
            weighted: 172,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_force",
            additions: 84,
            multiplications: 124,
            divisions: 1,
            functions: 1,
            weighted: 232,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_tangent",
            additions: 419,
            multiplications: 694,
            divisions: 4,
            functions: 1,
            weighted: 1149,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_points3_energy",
            additions: 31,
            multiplications: 47,
            divisions: 0,
            functions: 1,
            weighted: 98,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_damped_reference",
            additions: 255,
            multiplications: 337,
            divisions: 5,
            functions: 5,
            weighted: 712,
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
            additions: 468,
            multiplications: 639,
            divisions: 37,
            functions: 2,
            weighted: 1295,
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
    /// * Body `blade` uses `full_beam_spatial_curved_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2810 and 38098).
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
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 2810 and 38098).
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
    /// Gauss rule with 2 points, and derivatives of the shape functions there.
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
    /// Gauss rule with 3 points, and derivatives of the shape functions there.
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
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 223 additions, 336 multiplications, 17 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
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
        let t80 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t81 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t82 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t83 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t84 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t85 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t86 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t87 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t88 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t89 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t90 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t91 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t92 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t93 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t94 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t95 = a_x * a_x + a_y * a_y + a_z * a_z - (t81 * t81 + t83 * t83);
        let t96 = t95.sqrt();
        let t97 = t96 - 1.0;
        let t98 = 0.5 * (t92 - t89);
        let t99 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t100 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t101 = t99 * t100;
        let t102 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t81 * t98) / t96;
        let t103 = t100 * t102;
        let t104 = (a_x * db_x + a_y * db_y + a_z * db_z - t83 * t98) / t96;
        let t105 = t99 * t104;
        let t106 = t98 * t101 + reference[12] * t103 - reference[13] * t105
            + reference[15] * t97 + t81 * reference[18];
        let t107 = 0.5 * (t87 + t87);
        let t108 = 0.5 * (t91 + t91);
        let t109 = t81 * 2.0;
        let t110 = t83 * 2.0;
        let t111 = 1.0 / (2.0 * t96);
        let t112 = (t80 + t80 - (t82 * t109 + t84 * t110)) * t111;
        let t113 = 0.5 * (t93 - t90);
        let t114 = t100 * ((t86 + (t82 * t98 + t81 * t113) - t102 * t112) / t96)
            - t102 * t108;
        let t115 = t99 * ((t85 - (t84 * t98 + t83 * t113) - t104 * t112) / t96)
            - t104 * t107;
        let t116 = t101 * t113 - t98 * (t100 * t107 + t99 * t108) + reference[12] * t114
            - reference[13] * t115;
        let t117 = t106 + t83 * reference[22] - reference[0]
            + damping
                * (t116 + reference[15] * t112 + t82 * reference[18]
                    + t84 * reference[22]);
        let t118 = length * reference[6] * t117;
        let t119 = t100 * (t102 * t111 / t96);
        let t120 = t99 * (t104 * t111 / t96);
        let t121 = t103 - reference[14] * t105 + reference[16] * t97
            + t81 * reference[19] + t83 * reference[23] - reference[1];
        let t122 = damping
            * (t114 - reference[14] * t115 + reference[16] * t112 + t82 * reference[19]
                + t84 * reference[23]);
        let t123 = length * reference[7] * (t121 + t122);
        let t124 = reference[17] * t97 - t105 + t81 * reference[20] + t83 * reference[24]
            - reference[2]
            + damping
                * (reference[17] * t112 - t115 + t82 * reference[20]
                    + t84 * reference[24]);
        let t125 = length * reference[8] * t124;
        let t126 = t109 * t111;
        let t127 = t100 * ((t98 + t102 * t126) / t96);
        let t128 = t99 * (t104 * t126 / t96);
        let t129 = t110 * t111;
        let t130 = t100 * (t102 * t129 / t96);
        let t131 = t99 * ((t104 * t129 - t98) / t96);
        let t132 = 1.0 / t96;
        let t133 = t99 * t132;
        let t134 = t100 * t132;
        let t135 = -0.5 * t104;
        let t136 = t100 * (t81 * (-0.5) / t96);
        let t137 = t99 * (t83 * (-0.5) / t96);
        let t138 = -0.5 * t102;
        let t139 = t100 * (0.5 * t81 / t96);
        let t140 = t99 * (0.5 * t83 / t96);
        let t141 = length * reference[29];
        let t142 = t118
            * (reference[13] * t120 - reference[12] * t119 + reference[15] * t111)
            + t123 * (reference[14] * t120 - t119 + reference[16] * t111);
        let t143 = t142 + t125 * (t120 + reference[17] * t111);
        let t144 = t118
            * (reference[18]
                + (reference[12] * t127 - reference[13] * t128 - reference[15] * t126))
            + t123
                * (reference[19] + (t127 - reference[14] * t128 - reference[16] * t126));
        let t145 = t144 + t125 * (reference[20] - (t128 + reference[17] * t126));
        let t146 = t118
            * (reference[22]
                + (reference[12] * t130 - reference[13] * t131 - reference[15] * t129))
            + t123
                * (reference[23] + (t130 - reference[14] * t131 - reference[16] * t129));
        let t147 = t146 + t125 * (reference[24] - (t131 + reference[17] * t129));
        let t148 = t118 * (t98 * (-0.5 * t100) - reference[13] * t135)
            - t123 * (reference[14] * t135) - t125 * t135;
        let t149 = t141
            * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3] + damping * t88);
        let t150 = t118 * (-0.5 * t101 + reference[12] * t136 + reference[13] * t137)
            + t123 * (t136 + reference[14] * t137);
        let t151 = length * reference[30]
            * (t89 + t92 - reference[5] + damping * (t90 + t93));
        let t152 = t118 * (t98 * (-0.5 * t99) + reference[12] * t138) + t123 * t138;
        let t153 = t118 * (0.5 * t101 + reference[12] * t139 + reference[13] * t140)
            + t123 * (t139 + reference[14] * t140);
        let t154 = t141
            * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4] + damping * t94);
        let t155 = inverse_length
            * (t118 * (reference[13] * t133) + t123 * (reference[14] * t133)
                + t125 * t133);
        let t156 = inverse_length * (t118 * (reference[12] * t134) + t123 * t134);
        let t157 = inverse_length * t149;
        let t158 = inverse_length * (t150 + t125 * t137 + t151);
        let t159 = inverse_length * (t151 + (t153 + t125 * t140));
        let t160 = inverse_length * t154;
        let t161 = t143 * (a_x * 2.0) + b_x * t145 + c_x * t147 - unit_db_x * t155
            + unit_dc_x * t156;
        let t162 = t143 * (a_y * 2.0) + b_y * t145 + c_y * t147 - unit_db_y * t155
            + unit_dc_y * t156;
        let t163 = t143 * (a_z * 2.0) + b_z * t145 + c_z * t147 - unit_db_z * t155
            + unit_dc_z * t156;
        forces[0][0] = t161;
        forces[0][1] = t162;
        forces[0][2] = t163;
        forces[1][0] = a_x * t145 + t148 * (b_x * 2.0) + unit_db_x * t157
            + unit_dc_x * t158;
        forces[1][1] = a_y * t145 + t148 * (b_y * 2.0) + unit_db_y * t157
            + unit_dc_y * t158;
        forces[1][2] = a_z * t145 + t148 * (b_z * 2.0) + unit_db_z * t157
            + unit_dc_z * t158;
        forces[2][0] = a_x * t147 + t152 * (c_x * 2.0) + unit_db_x * t159
            + unit_dc_x * t160;
        forces[2][1] = a_y * t147 + t152 * (c_y * 2.0) + unit_db_y * t159
            + unit_dc_y * t160;
        forces[2][2] = a_z * t147 + t152 * (c_z * 2.0) + unit_db_z * t159
            + unit_dc_z * t160;
        forces[3][0] = b_x * t157 - a_x * t155 + c_x * t159;
        forces[3][1] = b_y * t157 - a_y * t155 + c_y * t159;
        forces[3][2] = b_z * t157 - a_z * t155 + c_z * t159;
        forces[4][0] = a_x * t156 + b_x * t158 + c_x * t160;
        forces[4][1] = a_y * t156 + b_y * t158 + c_y * t160;
        forces[4][2] = a_z * t156 + b_z * t158 + c_z * t160;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 2684 additions, 3832 multiplications, 64 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
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
        let t80 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t81 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t82 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t83 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t84 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t85 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t86 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t87 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t88 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t89 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t90 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t91 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t92 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t93 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t94 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t95 = a_x * a_x + a_y * a_y + a_z * a_z - (t81 * t81 + t83 * t83);
        let t96 = t95.sqrt();
        let t97 = t96 - 1.0;
        let t98 = 0.5 * (t92 - t89);
        let t99 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t100 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t101 = t99 * t100;
        let t102 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t81 * t98) / t96;
        let t103 = t100 * t102;
        let t104 = (a_x * db_x + a_y * db_y + a_z * db_z - t83 * t98) / t96;
        let t105 = t99 * t104;
        let t106 = t98 * t101 + reference[12] * t103 - reference[13] * t105
            + reference[15] * t97 + t81 * reference[18];
        let t107 = length * reference[6];
        let t108 = 0.5 * (t87 + t87);
        let t109 = 0.5 * (t91 + t91);
        let t110 = t81 * 2.0;
        let t111 = t83 * 2.0;
        let t112 = t80 + t80 - (t82 * t110 + t84 * t111);
        let t113 = 2.0 * t96;
        let t114 = 1.0 / t113;
        let t115 = t112 * t114;
        let t116 = 0.5 * (t93 - t90);
        let t117 = t100 * t108 + t99 * t109;
        let t118 = (t86 + (t82 * t98 + t81 * t116) - t102 * t115) / t96;
        let t119 = t100 * t118 - t102 * t109;
        let t120 = (t85 - (t84 * t98 + t83 * t116) - t104 * t115) / t96;
        let t121 = t99 * t120 - t104 * t108;
        let t122 = t101 * t116 - t98 * t117 + reference[12] * t119 - reference[13] * t121
            + reference[15] * t115;
        let t123 = t106 + t83 * reference[22] - reference[0]
            + damping * (t122 + t82 * reference[18] + t84 * reference[22]);
        let t124 = t107 * t123;
        let t125 = t102 * t114 / t96;
        let t126 = t100 * t125;
        let t127 = t104 * t114 / t96;
        let t128 = t99 * t127;
        let t129 = reference[13] * t128 - reference[12] * t126 + reference[15] * t114;
        let t130 = length * reference[7];
        let t131 = t103 - reference[14] * t105 + reference[16] * t97
            + t81 * reference[19] + t83 * reference[23] - reference[1];
        let t132 = damping
            * (t119 - reference[14] * t121 + reference[16] * t115 + t82 * reference[19]
                + t84 * reference[23]);
        let t133 = t130 * (t131 + t132);
        let t134 = reference[14] * t128 - t126 + reference[16] * t114;
        let t135 = length * reference[8];
        let t136 = reference[17] * t97 - t105 + t81 * reference[20] + t83 * reference[24]
            - reference[2]
            + damping
                * (reference[17] * t115 - t121 + t82 * reference[20]
                    + t84 * reference[24]);
        let t137 = t135 * t136;
        let t138 = t128 + reference[17] * t114;
        let t139 = 2.0 * t114;
        let t140 = t114 * t139 / t113;
        let t141 = t112 * t140;
        let t142 = t109 * t125
            + t100 * ((t115 * t125 + t102 * t141 - t114 * t118) / t96);
        let t143 = t108 * t127 + t99 * ((t115 * t127 + t104 * t141 - t114 * t120) / t96);
        let t144 = t107
            * (t129
                + damping
                    * (reference[12] * t142 - reference[13] * t143
                        - reference[15] * t141));
        let t145 = t114 * t125;
        let t146 = t100 * ((t145 + (t145 + t102 * t140)) / t96);
        let t147 = t114 * t127;
        let t148 = t99 * ((t147 + (t147 + t104 * t140)) / t96);
        let t149 = t130
            * (t134 + damping * (t142 - reference[14] * t143 - reference[16] * t141));
        let t150 = t129 * t144
            + t124 * (reference[12] * t146 - reference[13] * t148 - reference[15] * t140)
            + (t134 * t149
                + t133 * (t146 - reference[14] * t148 - reference[16] * t140));
        let t151 = t135 * (t138 - damping * (t143 + reference[17] * t141));
        let t152 = t150 + (t138 * t151 - t137 * (t148 + reference[17] * t140));
        let t153 = t110 * t114;
        let t154 = (t98 + t102 * t153) / t96;
        let t155 = t100 * t154;
        let t156 = t104 * t153 / t96;
        let t157 = t99 * t156;
        let t158 = reference[18]
            + (reference[12] * t155 - reference[13] * t157 - reference[15] * t153);
        let t159 = reference[19] + (t155 - reference[14] * t157 - reference[16] * t153);
        let t160 = reference[20] - (t157 + reference[17] * t153);
        let t161 = t114 * (2.0 * t153) / t113;
        let t162 = t112 * t161 - t114 * (t82 * 2.0);
        let t163 = t100 * ((t116 - (t115 * t154 + t102 * t162) + t118 * t153) / t96)
            - t109 * t154;
        let t164 = t99 * ((t120 * t153 - (t115 * t156 + t104 * t162)) / t96)
            - t108 * t156;
        let t165 = t107
            * (t158
                + damping
                    * (reference[12] * t163 - reference[13] * t164
                        + reference[15] * t162));
        let t166 = t114 * t154;
        let t167 = t125 * t153;
        let t168 = t100 * ((t166 + t102 * t161 + t167) / t96);
        let t169 = t114 * t156;
        let t170 = t127 * t153;
        let t171 = t99 * ((t169 + t104 * t161 + t170) / t96);
        let t172 = t130
            * (t159 + damping * (t163 - reference[14] * t164 + reference[16] * t162));
        let t173 = t129 * t165
            + t124 * (reference[13] * t171 - reference[12] * t168 + reference[15] * t161)
            + (t134 * t172
                + t133 * (reference[14] * t171 - t168 + reference[16] * t161));
        let t174 = t135 * (t160 + damping * (reference[17] * t162 - t164));
        let t175 = t173 + (t138 * t174 + t137 * (t171 + reference[17] * t161));
        let t176 = t111 * t114;
        let t177 = t102 * t176 / t96;
        let t178 = t100 * t177;
        let t179 = (t104 * t176 - t98) / t96;
        let t180 = t99 * t179;
        let t181 = reference[22]
            + (reference[12] * t178 - reference[13] * t180 - reference[15] * t176);
        let t182 = reference[23] + (t178 - reference[14] * t180 - reference[16] * t176);
        let t183 = reference[24] - (t180 + reference[17] * t176);
        let t184 = t114 * (2.0 * t176) / t113;
        let t185 = t112 * t184 - t114 * (t84 * 2.0);
        let t186 = t100 * ((t118 * t176 - (t115 * t177 + t102 * t185)) / t96)
            - t109 * t177;
        let t187 = t99 * ((t120 * t176 - (t116 + (t115 * t179 + t104 * t185))) / t96)
            - t108 * t179;
        let t188 = t107
            * (t181
                + damping
                    * (reference[12] * t186 - reference[13] * t187
                        + reference[15] * t185));
        let t189 = t114 * t177;
        let t190 = t125 * t176;
        let t191 = t100 * ((t189 + t102 * t184 + t190) / t96);
        let t192 = t114 * t179;
        let t193 = t127 * t176;
        let t194 = t99 * ((t192 + t104 * t184 + t193) / t96);
        let t195 = t130
            * (t182 + damping * (t186 - reference[14] * t187 + reference[16] * t185));
        let t196 = t129 * t188
            + t124 * (reference[13] * t194 - reference[12] * t191 + reference[15] * t184)
            + (t134 * t195
                + t133 * (reference[14] * t194 - t191 + reference[16] * t184));
        let t197 = t135 * (t183 + damping * (reference[17] * t185 - t187));
        let t198 = t196 + (t138 * t197 + t137 * (t194 + reference[17] * t184));
        let t199 = 1.0 / t96;
        let t200 = t99 * t199;
        let t201 = reference[13] * t200;
        let t202 = reference[14] * t200;
        let t203 = t115 * t199 / t96;
        let t204 = t108 * t199 + t99 * t203;
        let t205 = t107 * (damping * (reference[13] * t204) - t201);
        let t206 = t114 * t199 / t96;
        let t207 = t99 * t206;
        let t208 = t124 * (reference[13] * t207);
        let t209 = t130 * (damping * (reference[14] * t204) - t202);
        let t210 = t133 * (reference[14] * t207);
        let t211 = t135 * (damping * t204 - t200);
        let t212 = t137 * t207;
        let t213 = t100 * t199;
        let t214 = reference[12] * t213;
        let t215 = t109 * t199 + t100 * t203;
        let t216 = t107 * (t214 - damping * (reference[12] * t215));
        let t217 = t100 * t206;
        let t218 = t124 * (reference[12] * t217);
        let t219 = t130 * (t213 - damping * t215);
        let t220 = t133 * t217;
        let t221 = -0.5 * t100;
        let t222 = -0.5 * t104;
        let t223 = t98 * t221 - reference[13] * t222;
        let t224 = reference[14] * t222;
        let t225 = -0.5 * t120;
        let t226 = t107
            * (t223
                + damping * (t116 * t221 - t98 * (-0.5 * t109) - reference[13] * t225));
        let t227 = -0.5 * t127;
        let t228 = t124 * (reference[13] * t227);
        let t229 = t130 * (t224 + damping * (reference[14] * t225));
        let t230 = t133 * (reference[14] * t227);
        let t231 = t135 * (t222 + damping * t225);
        let t232 = t137 * t227;
        let t233 = t129 * t226 + t228 + (t230 - t134 * t229) + (t232 - t138 * t231);
        let t234 = t81 * (-0.5) / t96;
        let t235 = t100 * t234;
        let t236 = t83 * (-0.5) / t96;
        let t237 = t99 * t236;
        let t238 = -0.5 * t101 + reference[12] * t235 + reference[13] * t237;
        let t239 = t235 + reference[14] * t237;
        let t240 = t100 * ((t82 * (-0.5) - t115 * t234) / t96) - t109 * t234;
        let t241 = t108 * t236 + t99 * ((t115 * t236 - t84 * (-0.5)) / t96);
        let t242 = t107
            * (t238
                + damping
                    * (reference[12] * t240 - (-0.5 * t117) - reference[13] * t241));
        let t243 = t100 * (t114 * t234 / t96);
        let t244 = t99 * (t114 * t236 / t96);
        let t245 = t124 * (reference[12] * t243 + reference[13] * t244);
        let t246 = t130 * (t239 + damping * (t240 - reference[14] * t241));
        let t247 = t133 * (t243 + reference[14] * t244);
        let t248 = t135 * (t237 - damping * t241);
        let t249 = t137 * t244;
        let t250 = -0.5 * t99;
        let t251 = -0.5 * t102;
        let t252 = t98 * t250 + reference[12] * t251;
        let t253 = -0.5 * t118;
        let t254 = t107
            * (t252
                + damping * (t116 * t250 - t98 * (-0.5 * t108) + reference[12] * t253));
        let t255 = -0.5 * t125;
        let t256 = t124 * (reference[12] * t255);
        let t257 = t130 * (t251 + damping * t253);
        let t258 = t133 * t255;
        let t259 = t129 * t254 - t256 + (t134 * t257 - t258);
        let t260 = 0.5 * t81 / t96;
        let t261 = t100 * t260;
        let t262 = 0.5 * t83 / t96;
        let t263 = t99 * t262;
        let t264 = 0.5 * t101 + reference[12] * t261 + reference[13] * t263;
        let t265 = t261 + reference[14] * t263;
        let t266 = t100 * ((0.5 * t82 - t115 * t260) / t96) - t109 * t260;
        let t267 = t108 * t262 + t99 * ((t115 * t262 - 0.5 * t84) / t96);
        let t268 = t107
            * (t264
                + damping * (reference[12] * t266 - 0.5 * t117 - reference[13] * t267));
        let t269 = t100 * (t114 * t260 / t96);
        let t270 = t99 * (t114 * t262 / t96);
        let t271 = t124 * (reference[12] * t269 + reference[13] * t270);
        let t272 = t130 * (t265 + damping * (t266 - reference[14] * t267));
        let t273 = t133 * (t269 + reference[14] * t270);
        let t274 = t135 * (t263 - damping * t267);
        let t275 = t137 * t270;
        let t276 = t110 * t140;
        let t277 = t100 * ((t166 + (t167 + t102 * t276)) / t96);
        let t278 = t99 * ((t169 + (t170 + t104 * t276)) / t96);
        let t279 = t144 * t158
            + t124 * (reference[13] * t278 - reference[12] * t277 + reference[15] * t276)
            + (t149 * t159
                + t133 * (reference[14] * t278 - t277 + reference[16] * t276));
        let t280 = t279 + (t151 * t160 + t137 * (t278 + reference[17] * t276));
        let t281 = t139 + t110 * t161;
        let t282 = t153 * t154;
        let t283 = t100 * ((t282 + (t282 + t102 * t281)) / t96);
        let t284 = t153 * t156;
        let t285 = t99 * ((t284 + (t284 + t104 * t281)) / t96);
        let t286 = t158 * t165
            + t124 * (reference[12] * t283 - reference[13] * t285 - reference[15] * t281)
            + (t159 * t172
                + t133 * (t283 - reference[14] * t285 - reference[16] * t281));
        let t287 = t286 + (t160 * t174 - t137 * (t285 + reference[17] * t281));
        let t288 = t110 * t184;
        let t289 = t153 * t177;
        let t290 = t154 * t176;
        let t291 = t100 * ((t289 + t102 * t288 + t290) / t96);
        let t292 = t153 * t179;
        let t293 = t156 * t176;
        let t294 = t99 * ((t292 + t104 * t288 + t293) / t96);
        let t295 = t158 * t188
            + t124 * (reference[12] * t291 - reference[13] * t294 - reference[15] * t288)
            + (t159 * t195
                + t133 * (t291 - reference[14] * t294 - reference[16] * t288));
        let t296 = t295 + (t160 * t197 - t137 * (t294 + reference[17] * t288));
        let t297 = t153 * t199 / t96;
        let t298 = t99 * t297;
        let t299 = t124 * (reference[13] * t298);
        let t300 = t133 * (reference[14] * t298);
        let t301 = t137 * t298;
        let t302 = t100 * t297;
        let t303 = t124 * (reference[12] * t302);
        let t304 = t133 * t302;
        let t305 = -0.5 * t156;
        let t306 = t124 * (reference[13] * t305);
        let t307 = t133 * (reference[14] * t305);
        let t308 = t137 * t305;
        let t309 = t158 * t226 - t306 - (t159 * t229 + t307) - (t160 * t231 + t308);
        let t310 = t100 * ((-0.5 + t153 * t234) / t96);
        let t311 = t99 * (t153 * t236 / t96);
        let t312 = t124 * (reference[12] * t310 + reference[13] * t311);
        let t313 = t133 * (t310 + reference[14] * t311);
        let t314 = t137 * t311;
        let t315 = -0.5 * t154;
        let t316 = t124 * (reference[12] * t315);
        let t317 = t133 * t315;
        let t318 = t158 * t254 + t316 + (t159 * t257 + t317);
        let t319 = t100 * ((0.5 + t153 * t260) / t96);
        let t320 = t99 * (t153 * t262 / t96);
        let t321 = t124 * (reference[12] * t319 + reference[13] * t320);
        let t322 = t133 * (t319 + reference[14] * t320);
        let t323 = t137 * t320;
        let t324 = t111 * t140;
        let t325 = t100 * ((t189 + (t190 + t102 * t324)) / t96);
        let t326 = t99 * ((t192 + (t193 + t104 * t324)) / t96);
        let t327 = t144 * t181
            + t124 * (reference[13] * t326 - reference[12] * t325 + reference[15] * t324)
            + (t149 * t182
                + t133 * (reference[14] * t326 - t325 + reference[16] * t324));
        let t328 = t327 + (t151 * t183 + t137 * (t326 + reference[17] * t324));
        let t329 = t111 * t161;
        let t330 = t100 * ((t289 + (t290 + t102 * t329)) / t96);
        let t331 = t99 * ((t292 + (t293 + t104 * t329)) / t96);
        let t332 = t165 * t181
            + t124 * (reference[12] * t330 - reference[13] * t331 - reference[15] * t329)
            + (t172 * t182
                + t133 * (t330 - reference[14] * t331 - reference[16] * t329));
        let t333 = t332 + (t174 * t183 - t137 * (t331 + reference[17] * t329));
        let t334 = t139 + t111 * t184;
        let t335 = t176 * t177;
        let t336 = t100 * ((t335 + (t335 + t102 * t334)) / t96);
        let t337 = t176 * t179;
        let t338 = t99 * ((t337 + (t337 + t104 * t334)) / t96);
        let t339 = t181 * t188
            + t124 * (reference[12] * t336 - reference[13] * t338 - reference[15] * t334)
            + (t182 * t195
                + t133 * (t336 - reference[14] * t338 - reference[16] * t334));
        let t340 = t339 + (t183 * t197 - t137 * (t338 + reference[17] * t334));
        let t341 = t176 * t199 / t96;
        let t342 = t99 * t341;
        let t343 = t124 * (reference[13] * t342);
        let t344 = t133 * (reference[14] * t342);
        let t345 = t137 * t342;
        let t346 = t100 * t341;
        let t347 = t124 * (reference[12] * t346);
        let t348 = t133 * t346;
        let t349 = -0.5 * t179;
        let t350 = t124 * (reference[13] * t349);
        let t351 = t133 * (reference[14] * t349);
        let t352 = t137 * t349;
        let t353 = t181 * t226 - t350 - (t182 * t229 + t351) - (t183 * t231 + t352);
        let t354 = t100 * (t176 * t234 / t96);
        let t355 = t99 * ((-0.5 + t176 * t236) / t96);
        let t356 = t124 * (reference[12] * t354 + reference[13] * t355);
        let t357 = t133 * (t354 + reference[14] * t355);
        let t358 = t137 * t355;
        let t359 = -0.5 * t177;
        let t360 = t124 * (reference[12] * t359);
        let t361 = t133 * t359;
        let t362 = t181 * t254 + t360 + (t182 * t257 + t361);
        let t363 = t100 * (t176 * t260 / t96);
        let t364 = t99 * ((0.5 + t176 * t262) / t96);
        let t365 = t124 * (reference[12] * t363 + reference[13] * t364);
        let t366 = t133 * (t363 + reference[14] * t364);
        let t367 = t137 * t364;
        let t368 = -0.5 * t199;
        let t369 = t124 * (reference[13] * t368);
        let t370 = t133 * (reference[14] * t368);
        let t371 = t137 * t368;
        let t372 = t124 * (reference[12] * t368);
        let t373 = t133 * t368;
        let t374 = t228 + t144 * t223 - (t149 * t224 - t230) - (t151 * t222 - t232);
        let t375 = t165 * t223 - t306 - (t307 + t172 * t224) - (t308 + t174 * t222);
        let t376 = t188 * t223 - t350 - (t351 + t195 * t224) - (t352 + t197 * t222);
        let t377 = t223 * t226 + t224 * t229 + t222 * t231;
        let t378 = -0.5 * t236;
        let t379 = t124 * (-0.5 * t221 + reference[13] * t378);
        let t380 = t133 * (reference[14] * t378);
        let t381 = t137 * t378;
        let t382 = t124 * (t98 * 0.25);
        let t383 = t223 * t254 + t382 - t224 * t257;
        let t384 = -0.5 * t262;
        let t385 = t124 * (0.5 * t221 + reference[13] * t384);
        let t386 = t133 * (reference[14] * t384);
        let t387 = t137 * t384;
        let t388 = length * reference[29];
        let t389 = length * reference[30];
        let t390 = -0.5 * t234;
        let t391 = t124 * (-0.5 * t250 + reference[12] * t390);
        let t392 = t133 * t390;
        let t393 = t144 * t252 - t256 + (t149 * t251 - t258);
        let t394 = t316 + t165 * t252 + (t317 + t172 * t251);
        let t395 = t360 + t188 * t252 + (t361 + t195 * t251);
        let t396 = t382 + t226 * t252 - t229 * t251;
        let t397 = t252 * t254 + t251 * t257;
        let t398 = -0.5 * t260;
        let t399 = t124 * (0.5 * t250 + reference[12] * t398);
        let t400 = t133 * t398;
        let t401 = t107 * (damping * t129);
        let t402 = t130 * (damping * t134);
        let t403 = t135 * (damping * t138);
        let t404 = t129 * t401 + t134 * t402 + t138 * t403;
        let t405 = t107 * (damping * t158);
        let t406 = t130 * (damping * t159);
        let t407 = t135 * (damping * t160);
        let t408 = t129 * t405 + t134 * t406 + t138 * t407;
        let t409 = t107 * (damping * t181);
        let t410 = t130 * (damping * t182);
        let t411 = t135 * (damping * t183);
        let t412 = t129 * t409 + t134 * t410 + t138 * t411;
        let t413 = t107 * (damping * t201);
        let t414 = t130 * (damping * t202);
        let t415 = t135 * (damping * t200);
        let t416 = t107 * (damping * t214);
        let t417 = t130 * (damping * t213);
        let t418 = 0.5 * t104;
        let t419 = t107 * (damping * (reference[13] * t418 - t98 * (0.5 * t100)));
        let t420 = t130 * (damping * (reference[14] * t418));
        let t421 = t135 * (damping * t418);
        let t422 = t129 * t419 + t134 * t420 + t138 * t421;
        let t423 = t107 * (damping * t238);
        let t424 = t130 * (damping * t239);
        let t425 = t135 * (damping * t237);
        let t426 = 0.5 * t102;
        let t427 = t107 * (damping * (t98 * (0.5 * t99) + reference[12] * t426));
        let t428 = t130 * (damping * t426);
        let t429 = t129 * t427 + t134 * t428;
        let t430 = t107 * (damping * t264);
        let t431 = t130 * (damping * t265);
        let t432 = t135 * (damping * t263);
        let t433 = t158 * t401 + t159 * t402 + t160 * t403;
        let t434 = t158 * t405 + t159 * t406 + t160 * t407;
        let t435 = t158 * t409 + t159 * t410 + t160 * t411;
        let t436 = t158 * t419 + t159 * t420 + t160 * t421;
        let t437 = t158 * t427 + t159 * t428;
        let t438 = t181 * t401 + t182 * t402 + t183 * t403;
        let t439 = t181 * t405 + t182 * t406 + t183 * t407;
        let t440 = t181 * t409 + t182 * t410 + t183 * t411;
        let t441 = t181 * t419 + t182 * t420 + t183 * t421;
        let t442 = t181 * t427 + t182 * t428;
        let t443 = t223 * t401 - t224 * t402 - t222 * t403;
        let t444 = t223 * t405 - t224 * t406 - t222 * t407;
        let t445 = t223 * t409 - t224 * t410 - t222 * t411;
        let t446 = t223 * t419 - t224 * t420 - t222 * t421;
        let t447 = t224 * t428 - t223 * t427;
        let t448 = damping * t389;
        let t449 = t252 * t401 + t251 * t402;
        let t450 = t252 * t405 + t251 * t406;
        let t451 = t252 * t409 + t251 * t410;
        let t452 = t252 * t419 + t251 * t420;
        let t453 = t252 * t427 + t251 * t428;
        let t454 = t124 * t158 + t133 * t159 + t137 * t160;
        let t455 = t124 * t181 + t133 * t182 + t137 * t183;
        let t456 = t388
            * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3] + damping * t88);
        let t457 = t389 * (t89 + t92 - reference[5] + damping * (t90 + t93));
        let t458 = t388
            * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4] + damping * t94);
        let t459 = inverse_length
            * (t129 * t205 + t208 + (t134 * t209 + t210) + (t138 * t211 + t212));
        let t460 = inverse_length * (t129 * t216 - t218 + (t134 * t219 - t220));
        let t461 = inverse_length
            * (t129 * t242 - t245 + (t134 * t246 - t247) + (t138 * t248 - t249));
        let t462 = inverse_length
            * (t129 * t268 - t271 + (t134 * t272 - t273) + (t138 * t274 - t275));
        let t463 = inverse_length * (t129 * t413 + t134 * t414 + t138 * t415);
        let t464 = inverse_length * (t129 * t416 + t134 * t417);
        let t465 = inverse_length * (t129 * t423 + t134 * t424 + t138 * t425);
        let t466 = inverse_length * (t129 * t430 + t134 * t431 + t138 * t432);
        let t467 = inverse_length
            * (t158 * t205 - t299 + (t159 * t209 - t300) + (t160 * t211 - t301));
        let t468 = inverse_length * (t158 * t216 + t303 + (t159 * t219 + t304));
        let t469 = inverse_length
            * (t158 * t242 + t312 + (t159 * t246 + t313) + (t160 * t248 + t314));
        let t470 = inverse_length
            * (t158 * t268 + t321 + (t159 * t272 + t322) + (t160 * t274 + t323));
        let t471 = inverse_length * (t158 * t413 + t159 * t414 + t160 * t415);
        let t472 = inverse_length * (t158 * t416 + t159 * t417);
        let t473 = inverse_length * (t158 * t423 + t159 * t424 + t160 * t425);
        let t474 = inverse_length * (t158 * t430 + t159 * t431 + t160 * t432);
        let t475 = inverse_length
            * (t181 * t205 - t343 + (t182 * t209 - t344) + (t183 * t211 - t345));
        let t476 = inverse_length * (t181 * t216 + t347 + (t182 * t219 + t348));
        let t477 = inverse_length
            * (t181 * t242 + t356 + (t182 * t246 + t357) + (t183 * t248 + t358));
        let t478 = inverse_length
            * (t181 * t268 + t365 + (t182 * t272 + t366) + (t183 * t274 + t367));
        let t479 = inverse_length * (t181 * t413 + t182 * t414 + t183 * t415);
        let t480 = inverse_length * (t181 * t416 + t182 * t417);
        let t481 = inverse_length * (t181 * t423 + t182 * t424 + t183 * t425);
        let t482 = inverse_length * (t181 * t430 + t182 * t431 + t183 * t432);
        let t483 = inverse_length * (t124 * t201 + t133 * t202 + t137 * t200);
        let t484 = inverse_length
            * (t144 * t201 - t208 + (t149 * t202 - t210) + (t151 * t200 - t212));
        let t485 = inverse_length
            * (t299 + t165 * t201 + (t300 + t172 * t202) + (t301 + t174 * t200));
        let t486 = inverse_length
            * (t343 + t188 * t201 + (t344 + t195 * t202) + (t345 + t197 * t200));
        let t487 = inverse_length * inverse_length;
        let t488 = (t201 * t205 + t202 * t209 + t200 * t211) * t487;
        let t489 = (t201 * t216 + t202 * t219) * t487;
        let t490 = inverse_length
            * (t201 * t226 + t369 + (t370 - t202 * t229) + (t371 - t200 * t231));
        let t491 = (t201 * t242 + t202 * t246 + t200 * t248) * t487;
        let t492 = inverse_length * (t201 * t254 + t202 * t257);
        let t493 = (t201 * t268 + t202 * t272 + t200 * t274) * t487;
        let t494 = inverse_length * (t201 * t401 + t202 * t402 + t200 * t403);
        let t495 = inverse_length * (t201 * t405 + t202 * t406 + t200 * t407);
        let t496 = inverse_length * (t201 * t409 + t202 * t410 + t200 * t411);
        let t497 = (t201 * t413 + t202 * t414 + t200 * t415) * t487;
        let t498 = (t201 * t416 + t202 * t417) * t487;
        let t499 = inverse_length * (t201 * t419 + t202 * t420 + t200 * t421);
        let t500 = (t201 * t423 + t202 * t424 + t200 * t425) * t487;
        let t501 = inverse_length * (t201 * t427 + t202 * t428);
        let t502 = (t201 * t430 + t202 * t431 + t200 * t432) * t487;
        let t503 = inverse_length * (t124 * t214 + t133 * t213);
        let t504 = inverse_length * (t144 * t214 - t218 + (t149 * t213 - t220));
        let t505 = inverse_length * (t303 + t165 * t214 + (t304 + t172 * t213));
        let t506 = inverse_length * (t347 + t188 * t214 + (t348 + t195 * t213));
        let t507 = (t205 * t214 + t209 * t213) * t487;
        let t508 = (t214 * t216 + t213 * t219) * t487;
        let t509 = inverse_length * (t214 * t226 - t213 * t229);
        let t510 = (t214 * t242 + t213 * t246) * t487;
        let t511 = inverse_length * (t214 * t254 + t372 + (t373 + t213 * t257));
        let t512 = (t214 * t268 + t213 * t272) * t487;
        let t513 = inverse_length * (t214 * t401 + t213 * t402);
        let t514 = inverse_length * (t214 * t405 + t213 * t406);
        let t515 = inverse_length * (t214 * t409 + t213 * t410);
        let t516 = (t214 * t413 + t213 * t414) * t487;
        let t517 = (t214 * t416 + t213 * t417) * t487;
        let t518 = inverse_length * (t214 * t419 + t213 * t420);
        let t519 = (t214 * t423 + t213 * t424) * t487;
        let t520 = inverse_length * (t214 * t427 + t213 * t428);
        let t521 = (t214 * t430 + t213 * t431) * t487;
        let t522 = inverse_length
            * (t205 * t223 - t369 - (t370 + t209 * t224) - (t371 + t211 * t222));
        let t523 = inverse_length * (t216 * t223 - t219 * t224);
        let t524 = inverse_length
            * (t223 * t242 + t379 - (t224 * t246 - t380) - (t222 * t248 - t381));
        let t525 = inverse_length
            * (t223 * t268 + t385 - (t224 * t272 - t386) - (t222 * t274 - t387));
        let t526 = inverse_length * (t224 * t414 - t223 * t413 + t222 * t415);
        let t527 = inverse_length * (t223 * t416 - t224 * t417);
        let t528 = inverse_length * (t223 * t423 - t224 * t424 - t222 * t425);
        let t529 = inverse_length * (t223 * t430 - t224 * t431 - t222 * t432);
        let t530 = inverse_length * t456;
        let t531 = t388 * t487;
        let t532 = damping * t388 * t487;
        let t533 = inverse_length * (t124 * t238 + t133 * t239 + t137 * t237 + t457);
        let t534 = inverse_length
            * (t144 * t238 - t245 + (t149 * t239 - t247) + (t151 * t237 - t249));
        let t535 = inverse_length
            * (t312 + t165 * t238 + (t313 + t172 * t239) + (t314 + t174 * t237));
        let t536 = inverse_length
            * (t356 + t188 * t238 + (t357 + t195 * t239) + (t358 + t197 * t237));
        let t537 = (t205 * t238 + t209 * t239 + t211 * t237) * t487;
        let t538 = (t216 * t238 + t219 * t239) * t487;
        let t539 = inverse_length
            * (t379 + t226 * t238 + (t380 - t229 * t239) + (t381 - t231 * t237));
        let t540 = (t389 + (t238 * t242 + t239 * t246 + t237 * t248)) * t487;
        let t541 = inverse_length * (t238 * t254 + t391 + (t239 * t257 + t392));
        let t542 = (t389 + (t238 * t268 + t239 * t272 + t237 * t274)) * t487;
        let t543 = inverse_length * (t238 * t401 + t239 * t402 + t237 * t403);
        let t544 = inverse_length * (t238 * t405 + t239 * t406 + t237 * t407);
        let t545 = inverse_length * (t238 * t409 + t239 * t410 + t237 * t411);
        let t546 = (t238 * t413 + t239 * t414 + t237 * t415) * t487;
        let t547 = (t238 * t416 + t239 * t417) * t487;
        let t548 = inverse_length * (t238 * t419 + t239 * t420 + t237 * t421);
        let t549 = (t238 * t423 + t239 * t424 + t237 * t425 + t448) * t487;
        let t550 = inverse_length * (t238 * t427 + t239 * t428);
        let t551 = (t448 + (t238 * t430 + t239 * t431 + t237 * t432)) * t487;
        let t552 = inverse_length * (t205 * t252 + t209 * t251);
        let t553 = inverse_length * (t372 + t216 * t252 + (t373 + t219 * t251));
        let t554 = inverse_length * (t391 + t242 * t252 + (t392 + t246 * t251));
        let t555 = inverse_length * (t252 * t268 + t399 + (t400 + t251 * t272));
        let t556 = inverse_length * (t252 * t413 + t251 * t414);
        let t557 = inverse_length * (t252 * t416 + t251 * t417);
        let t558 = inverse_length * (t252 * t423 + t251 * t424);
        let t559 = inverse_length * (t252 * t430 + t251 * t431);
        let t560 = inverse_length * (t457 + (t124 * t264 + t133 * t265 + t137 * t263));
        let t561 = inverse_length
            * (t144 * t264 - t271 + (t149 * t265 - t273) + (t151 * t263 - t275));
        let t562 = inverse_length
            * (t321 + t165 * t264 + (t322 + t172 * t265) + (t323 + t174 * t263));
        let t563 = inverse_length
            * (t365 + t188 * t264 + (t366 + t195 * t265) + (t367 + t197 * t263));
        let t564 = (t205 * t264 + t209 * t265 + t211 * t263) * t487;
        let t565 = (t216 * t264 + t219 * t265) * t487;
        let t566 = inverse_length
            * (t385 + t226 * t264 + (t386 - t229 * t265) + (t387 - t231 * t263));
        let t567 = (t389 + (t242 * t264 + t246 * t265 + t248 * t263)) * t487;
        let t568 = inverse_length * (t399 + t254 * t264 + (t400 + t257 * t265));
        let t569 = (t389 + (t264 * t268 + t265 * t272 + t263 * t274)) * t487;
        let t570 = inverse_length * (t264 * t401 + t265 * t402 + t263 * t403);
        let t571 = inverse_length * (t264 * t405 + t265 * t406 + t263 * t407);
        let t572 = inverse_length * (t264 * t409 + t265 * t410 + t263 * t411);
        let t573 = (t264 * t413 + t265 * t414 + t263 * t415) * t487;
        let t574 = (t264 * t416 + t265 * t417) * t487;
        let t575 = inverse_length * (t264 * t419 + t265 * t420 + t263 * t421);
        let t576 = (t448 + (t264 * t423 + t265 * t424 + t263 * t425)) * t487;
        let t577 = inverse_length * (t264 * t427 + t265 * t428);
        let t578 = (t448 + (t264 * t430 + t265 * t431 + t263 * t432)) * t487;
        let t579 = inverse_length * t458;
        let t580 = a_x * 2.0;
        let t581 = a_y * 2.0;
        let t582 = a_z * 2.0;
        let t583 = b_x * 2.0;
        let t584 = b_y * 2.0;
        let t585 = b_z * 2.0;
        let t586 = c_x * 2.0;
        let t587 = c_y * 2.0;
        let t588 = c_z * 2.0;
        let t589 = v_a_x * 2.0;
        let t590 = v_a_y * 2.0;
        let t591 = v_a_z * 2.0;
        let t592 = v_b_x * 2.0;
        let t593 = v_b_y * 2.0;
        let t594 = v_b_z * 2.0;
        let t595 = v_c_x * 2.0;
        let t596 = v_c_y * 2.0;
        let t597 = v_c_z * 2.0;
        let t598 = t152 * t580 + b_x * t175 + c_x * t198 + unit_db_x * t459
            + unit_dc_x * t460;
        let t599 = t152 * t581 + b_y * t175 + c_y * t198 + unit_db_y * t459
            + unit_dc_y * t460;
        let t600 = t152 * t582 + b_z * t175 + c_z * t198 + unit_db_z * t459
            + unit_dc_z * t460;
        let t601 = t280 * t580 + b_x * t287 + c_x * t296 + unit_db_x * t467
            + unit_dc_x * t468;
        let t602 = t280 * t581 + b_y * t287 + c_y * t296 + unit_db_y * t467
            + unit_dc_y * t468;
        let t603 = t280 * t582 + b_z * t287 + c_z * t296 + unit_db_z * t467
            + unit_dc_z * t468;
        let t604 = t328 * t580 + b_x * t333 + c_x * t340 + unit_db_x * t475
            + unit_dc_x * t476;
        let t605 = t328 * t581 + b_y * t333 + c_y * t340 + unit_db_y * t475
            + unit_dc_y * t476;
        let t606 = t328 * t582 + b_z * t333 + c_z * t340 + unit_db_z * t475
            + unit_dc_z * t476;
        let t607 = t484 * t580 + b_x * t485 + c_x * t486 + unit_db_x * t488
            + unit_dc_x * t489;
        let t608 = t484 * t581 + b_y * t485 + c_y * t486 + unit_db_y * t488
            + unit_dc_y * t489;
        let t609 = t484 * t582 + b_z * t485 + c_z * t486 + unit_db_z * t488
            + unit_dc_z * t489;
        let t610 = t504 * t580 + b_x * t505 + c_x * t506 + unit_db_x * t507
            + unit_dc_x * t508;
        let t611 = t504 * t581 + b_y * t505 + c_y * t506 + unit_db_y * t507
            + unit_dc_y * t508;
        let t612 = t504 * t582 + b_z * t505 + c_z * t506 + unit_db_z * t507
            + unit_dc_z * t508;
        let t613 = t374 * t580 + b_x * t375 + c_x * t376 + unit_db_x * t522
            + unit_dc_x * t523;
        let t614 = t374 * t581 + b_y * t375 + c_y * t376 + unit_db_y * t522
            + unit_dc_y * t523;
        let t615 = t374 * t582 + b_z * t375 + c_z * t376 + unit_db_z * t522
            + unit_dc_z * t523;
        let t616 = t534 * t580 + b_x * t535 + c_x * t536 + unit_db_x * t537
            + unit_dc_x * t538;
        let t617 = t534 * t581 + b_y * t535 + c_y * t536 + unit_db_y * t537
            + unit_dc_y * t538;
        let t618 = t534 * t582 + b_z * t535 + c_z * t536 + unit_db_z * t537
            + unit_dc_z * t538;
        let t619 = t393 * t580 + b_x * t394 + c_x * t395 + unit_db_x * t552
            + unit_dc_x * t553;
        let t620 = t393 * t581 + b_y * t394 + c_y * t395 + unit_db_y * t552
            + unit_dc_y * t553;
        let t621 = t393 * t582 + b_z * t394 + c_z * t395 + unit_db_z * t552
            + unit_dc_z * t553;
        let t622 = t561 * t580 + b_x * t562 + c_x * t563 + unit_db_x * t564
            + unit_dc_x * t565;
        let t623 = t561 * t581 + b_y * t562 + c_y * t563 + unit_db_y * t564
            + unit_dc_y * t565;
        let t624 = t561 * t582 + b_z * t562 + c_z * t563 + unit_db_z * t564
            + unit_dc_z * t565;
        let t625 = t404 * t589 + v_b_x * t408 + v_c_x * t412 - v_unit_db_x * t463
            + v_unit_dc_x * t464;
        let t626 = t404 * t590 + v_b_y * t408 + v_c_y * t412 - v_unit_db_y * t463
            + v_unit_dc_y * t464;
        let t627 = t404 * t591 + v_b_z * t408 + v_c_z * t412 - v_unit_db_z * t463
            + v_unit_dc_z * t464;
        let t628 = t433 * t589 + v_b_x * t434 + v_c_x * t435 - v_unit_db_x * t471
            + v_unit_dc_x * t472;
        let t629 = t433 * t590 + v_b_y * t434 + v_c_y * t435 - v_unit_db_y * t471
            + v_unit_dc_y * t472;
        let t630 = t433 * t591 + v_b_z * t434 + v_c_z * t435 - v_unit_db_z * t471
            + v_unit_dc_z * t472;
        let t631 = t438 * t589 + v_b_x * t439 + v_c_x * t440 - v_unit_db_x * t479
            + v_unit_dc_x * t480;
        let t632 = t438 * t590 + v_b_y * t439 + v_c_y * t440 - v_unit_db_y * t479
            + v_unit_dc_y * t480;
        let t633 = t438 * t591 + v_b_z * t439 + v_c_z * t440 - v_unit_db_z * t479
            + v_unit_dc_z * t480;
        let t634 = v_unit_db_x * t497 - (t494 * t589 + v_b_x * t495 + v_c_x * t496)
            - v_unit_dc_x * t498;
        let t635 = v_unit_db_y * t497 - (t494 * t590 + v_b_y * t495 + v_c_y * t496)
            - v_unit_dc_y * t498;
        let t636 = v_unit_db_z * t497 - (t494 * t591 + v_b_z * t495 + v_c_z * t496)
            - v_unit_dc_z * t498;
        let t637 = t513 * t589 + v_b_x * t514 + v_c_x * t515 - v_unit_db_x * t516
            + v_unit_dc_x * t517;
        let t638 = t513 * t590 + v_b_y * t514 + v_c_y * t515 - v_unit_db_y * t516
            + v_unit_dc_y * t517;
        let t639 = t513 * t591 + v_b_z * t514 + v_c_z * t515 - v_unit_db_z * t516
            + v_unit_dc_z * t517;
        let t640 = t443 * t589 + v_b_x * t444 + v_c_x * t445 + v_unit_db_x * t526
            + v_unit_dc_x * t527;
        let t641 = t443 * t590 + v_b_y * t444 + v_c_y * t445 + v_unit_db_y * t526
            + v_unit_dc_y * t527;
        let t642 = t443 * t591 + v_b_z * t444 + v_c_z * t445 + v_unit_db_z * t526
            + v_unit_dc_z * t527;
        let t643 = t543 * t589 + v_b_x * t544 + v_c_x * t545 - v_unit_db_x * t546
            + v_unit_dc_x * t547;
        let t644 = t543 * t590 + v_b_y * t544 + v_c_y * t545 - v_unit_db_y * t546
            + v_unit_dc_y * t547;
        let t645 = t543 * t591 + v_b_z * t544 + v_c_z * t545 - v_unit_db_z * t546
            + v_unit_dc_z * t547;
        let t646 = t449 * t589 + v_b_x * t450 + v_c_x * t451 - v_unit_db_x * t556
            + v_unit_dc_x * t557;
        let t647 = t449 * t590 + v_b_y * t450 + v_c_y * t451 - v_unit_db_y * t556
            + v_unit_dc_y * t557;
        let t648 = t449 * t591 + v_b_z * t450 + v_c_z * t451 - v_unit_db_z * t556
            + v_unit_dc_z * t557;
        let t649 = t570 * t589 + v_b_x * t571 + v_c_x * t572 - v_unit_db_x * t573
            + v_unit_dc_x * t574;
        let t650 = t570 * t590 + v_b_y * t571 + v_c_y * t572 - v_unit_db_y * t573
            + v_unit_dc_y * t574;
        let t651 = t570 * t591 + v_b_z * t571 + v_c_z * t572 - v_unit_db_z * t573
            + v_unit_dc_z * t574;
        let t652 = t598 + t625;
        let t653 = t599 + t626;
        let t654 = t600 + t627;
        let t655 = a_x * t175 + t233 * t583 + unit_dc_x * t461
            + (v_a_x * t408 + t422 * t592 + v_unit_dc_x * t465);
        let t656 = a_y * t175 + t233 * t584 + unit_dc_y * t461
            + (v_a_y * t408 + t422 * t593 + v_unit_dc_y * t465);
        let t657 = a_z * t175 + t233 * t585 + unit_dc_z * t461
            + (v_a_z * t408 + t422 * t594 + v_unit_dc_z * t465);
        let t658 = a_x * t198 + t259 * t586 + unit_db_x * t462
            + (v_a_x * t412 - t429 * t595 + v_unit_db_x * t466);
        let t659 = a_y * t198 + t259 * t587 + unit_db_y * t462
            + (v_a_y * t412 - t429 * t596 + v_unit_db_y * t466);
        let t660 = a_z * t198 + t259 * t588 + unit_db_z * t462
            + (v_a_z * t412 - t429 * t597 + v_unit_db_z * t466);
        let t661 = a_x * t459 + c_x * t462 + (v_c_x * t466 - v_a_x * t463);
        let t662 = a_y * t459 + c_y * t462 + (v_c_y * t466 - v_a_y * t463);
        let t663 = a_z * t459 + c_z * t462 + (v_c_z * t466 - v_a_z * t463);
        let t664 = a_x * t460 + b_x * t461 + (v_a_x * t464 + v_b_x * t465);
        let t665 = a_y * t460 + b_y * t461 + (v_a_y * t464 + v_b_y * t465);
        let t666 = a_z * t460 + b_z * t461 + (v_a_z * t464 + v_b_z * t465);
        let t667 = t601 + t628;
        let t668 = t602 + t629;
        let t669 = t603 + t630;
        let t670 = a_x * t287 + t309 * t583 + unit_dc_x * t469
            + (v_a_x * t434 + t436 * t592 + v_unit_dc_x * t473);
        let t671 = a_y * t287 + t309 * t584 + unit_dc_y * t469
            + (v_a_y * t434 + t436 * t593 + v_unit_dc_y * t473);
        let t672 = a_z * t287 + t309 * t585 + unit_dc_z * t469
            + (v_a_z * t434 + t436 * t594 + v_unit_dc_z * t473);
        let t673 = a_x * t296 + t318 * t586 + unit_db_x * t470
            + (v_a_x * t435 - t437 * t595 + v_unit_db_x * t474);
        let t674 = a_y * t296 + t318 * t587 + unit_db_y * t470
            + (v_a_y * t435 - t437 * t596 + v_unit_db_y * t474);
        let t675 = a_z * t296 + t318 * t588 + unit_db_z * t470
            + (v_a_z * t435 - t437 * t597 + v_unit_db_z * t474);
        let t676 = a_x * t467 + c_x * t470 + (v_c_x * t474 - v_a_x * t471);
        let t677 = a_y * t467 + c_y * t470 + (v_c_y * t474 - v_a_y * t471);
        let t678 = a_z * t467 + c_z * t470 + (v_c_z * t474 - v_a_z * t471);
        let t679 = a_x * t468 + b_x * t469 + (v_a_x * t472 + v_b_x * t473);
        let t680 = a_y * t468 + b_y * t469 + (v_a_y * t472 + v_b_y * t473);
        let t681 = a_z * t468 + b_z * t469 + (v_a_z * t472 + v_b_z * t473);
        let t682 = t604 + t631;
        let t683 = t605 + t632;
        let t684 = t606 + t633;
        let t685 = a_x * t333 + t353 * t583 + unit_dc_x * t477
            + (v_a_x * t439 + t441 * t592 + v_unit_dc_x * t481);
        let t686 = a_y * t333 + t353 * t584 + unit_dc_y * t477
            + (v_a_y * t439 + t441 * t593 + v_unit_dc_y * t481);
        let t687 = a_z * t333 + t353 * t585 + unit_dc_z * t477
            + (v_a_z * t439 + t441 * t594 + v_unit_dc_z * t481);
        let t688 = a_x * t340 + t362 * t586 + unit_db_x * t478
            + (v_a_x * t440 - t442 * t595 + v_unit_db_x * t482);
        let t689 = a_y * t340 + t362 * t587 + unit_db_y * t478
            + (v_a_y * t440 - t442 * t596 + v_unit_db_y * t482);
        let t690 = a_z * t340 + t362 * t588 + unit_db_z * t478
            + (v_a_z * t440 - t442 * t597 + v_unit_db_z * t482);
        let t691 = a_x * t475 + c_x * t478 + (v_c_x * t482 - v_a_x * t479);
        let t692 = a_y * t475 + c_y * t478 + (v_c_y * t482 - v_a_y * t479);
        let t693 = a_z * t475 + c_z * t478 + (v_c_z * t482 - v_a_z * t479);
        let t694 = a_x * t476 + b_x * t477 + (v_a_x * t480 + v_b_x * t481);
        let t695 = a_y * t476 + b_y * t477 + (v_a_y * t480 + v_b_y * t481);
        let t696 = a_z * t476 + b_z * t477 + (v_a_z * t480 + v_b_z * t481);
        let t697 = t634 - t607;
        let t698 = t635 - t608;
        let t699 = t636 - t609;
        let t700 = a_x * t485 + t490 * t583 + unit_dc_x * t491
            + (v_a_x * t495 + t499 * t592 + v_unit_dc_x * t500);
        let t701 = a_y * t485 + t490 * t584 + unit_dc_y * t491
            + (v_a_y * t495 + t499 * t593 + v_unit_dc_y * t500);
        let t702 = a_z * t485 + t490 * t585 + unit_dc_z * t491
            + (v_a_z * t495 + t499 * t594 + v_unit_dc_z * t500);
        let t703 = t501 * t595 - v_a_x * t496 - v_unit_db_x * t502
            - (a_x * t486 + t492 * t586 + unit_db_x * t493);
        let t704 = t501 * t596 - v_a_y * t496 - v_unit_db_y * t502
            - (a_y * t486 + t492 * t587 + unit_db_y * t493);
        let t705 = t501 * t597 - v_a_z * t496 - v_unit_db_z * t502
            - (a_z * t486 + t492 * t588 + unit_db_z * t493);
        let t706 = v_a_x * t497 - v_c_x * t502 - (a_x * t488 + c_x * t493);
        let t707 = v_a_y * t497 - v_c_y * t502 - (a_y * t488 + c_y * t493);
        let t708 = v_a_z * t497 - v_c_z * t502 - (a_z * t488 + c_z * t493);
        let t709 = a_x * t489 + b_x * t491 + (v_a_x * t498 + v_b_x * t500);
        let t710 = a_y * t489 + b_y * t491 + (v_a_y * t498 + v_b_y * t500);
        let t711 = a_z * t489 + b_z * t491 + (v_a_z * t498 + v_b_z * t500);
        let t712 = t610 + t637;
        let t713 = t611 + t638;
        let t714 = t612 + t639;
        let t715 = a_x * t505 + t509 * t583 + unit_dc_x * t510
            + (v_a_x * t514 + t518 * t592 + v_unit_dc_x * t519);
        let t716 = a_y * t505 + t509 * t584 + unit_dc_y * t510
            + (v_a_y * t514 + t518 * t593 + v_unit_dc_y * t519);
        let t717 = a_z * t505 + t509 * t585 + unit_dc_z * t510
            + (v_a_z * t514 + t518 * t594 + v_unit_dc_z * t519);
        let t718 = a_x * t506 + t511 * t586 + unit_db_x * t512
            + (v_a_x * t515 - t520 * t595 + v_unit_db_x * t521);
        let t719 = a_y * t506 + t511 * t587 + unit_db_y * t512
            + (v_a_y * t515 - t520 * t596 + v_unit_db_y * t521);
        let t720 = a_z * t506 + t511 * t588 + unit_db_z * t512
            + (v_a_z * t515 - t520 * t597 + v_unit_db_z * t521);
        let t721 = a_x * t507 + c_x * t512 + (v_c_x * t521 - v_a_x * t516);
        let t722 = a_y * t507 + c_y * t512 + (v_c_y * t521 - v_a_y * t516);
        let t723 = a_z * t507 + c_z * t512 + (v_c_z * t521 - v_a_z * t516);
        let t724 = a_x * t508 + b_x * t510 + (v_a_x * t517 + v_b_x * t519);
        let t725 = a_y * t508 + b_y * t510 + (v_a_y * t517 + v_b_y * t519);
        let t726 = a_z * t508 + b_z * t510 + (v_a_z * t517 + v_b_z * t519);
        let t727 = t613 + t640;
        let t728 = t614 + t641;
        let t729 = t615 + t642;
        let t730 = a_x * t375 + t377 * t583 + unit_dc_x * t524
            + (v_a_x * t444 + t446 * t592 + v_unit_dc_x * t528);
        let t731 = a_y * t375 + t377 * t584 + unit_dc_y * t524
            + (v_a_y * t444 + t446 * t593 + v_unit_dc_y * t528);
        let t732 = a_z * t375 + t377 * t585 + unit_dc_z * t524
            + (v_a_z * t444 + t446 * t594 + v_unit_dc_z * t528);
        let t733 = a_x * t376 + t383 * t586 + unit_db_x * t525
            + (v_a_x * t445 + t447 * t595 + v_unit_db_x * t529);
        let t734 = a_y * t376 + t383 * t587 + unit_db_y * t525
            + (v_a_y * t445 + t447 * t596 + v_unit_db_y * t529);
        let t735 = a_z * t376 + t383 * t588 + unit_db_z * t525
            + (v_a_z * t445 + t447 * t597 + v_unit_db_z * t529);
        let t736 = a_x * t522 + c_x * t525 + (v_a_x * t526 + v_c_x * t529);
        let t737 = a_y * t522 + c_y * t525 + (v_a_y * t526 + v_c_y * t529);
        let t738 = a_z * t522 + c_z * t525 + (v_a_z * t526 + v_c_z * t529);
        let t739 = a_x * t523 + b_x * t524 + (v_a_x * t527 + v_b_x * t528);
        let t740 = a_y * t523 + b_y * t524 + (v_a_y * t527 + v_b_y * t528);
        let t741 = a_z * t523 + b_z * t524 + (v_a_z * t527 + v_b_z * t528);
        let t742 = unit_db_x * t531 + v_unit_db_x * t532;
        let t743 = unit_db_y * t531 + v_unit_db_y * t532;
        let t744 = unit_db_z * t531 + v_unit_db_z * t532;
        let t745 = b_x * t531 + v_b_x * t532;
        let t746 = b_y * t531 + v_b_y * t532;
        let t747 = b_z * t531 + v_b_z * t532;
        let t748 = t616 + t643;
        let t749 = t617 + t644;
        let t750 = t618 + t645;
        let t751 = a_x * t535 + t539 * t583 + unit_dc_x * t540
            + (v_a_x * t544 + t548 * t592 + v_unit_dc_x * t549);
        let t752 = a_y * t535 + t539 * t584 + unit_dc_y * t540
            + (v_a_y * t544 + t548 * t593 + v_unit_dc_y * t549);
        let t753 = a_z * t535 + t539 * t585 + unit_dc_z * t540
            + (v_a_z * t544 + t548 * t594 + v_unit_dc_z * t549);
        let t754 = a_x * t536 + t541 * t586 + unit_db_x * t542
            + (v_a_x * t545 - t550 * t595 + v_unit_db_x * t551);
        let t755 = a_y * t536 + t541 * t587 + unit_db_y * t542
            + (v_a_y * t545 - t550 * t596 + v_unit_db_y * t551);
        let t756 = a_z * t536 + t541 * t588 + unit_db_z * t542
            + (v_a_z * t545 - t550 * t597 + v_unit_db_z * t551);
        let t757 = a_x * t537 + c_x * t542 + (v_c_x * t551 - v_a_x * t546);
        let t758 = a_y * t537 + c_y * t542 + (v_c_y * t551 - v_a_y * t546);
        let t759 = a_z * t537 + c_z * t542 + (v_c_z * t551 - v_a_z * t546);
        let t760 = a_x * t538 + b_x * t540 + (v_a_x * t547 + v_b_x * t549);
        let t761 = a_y * t538 + b_y * t540 + (v_a_y * t547 + v_b_y * t549);
        let t762 = a_z * t538 + b_z * t540 + (v_a_z * t547 + v_b_z * t549);
        let t763 = t619 + t646;
        let t764 = t620 + t647;
        let t765 = t621 + t648;
        let t766 = a_x * t394 + t396 * t583 + unit_dc_x * t554
            + (v_a_x * t450 + t452 * t592 + v_unit_dc_x * t558);
        let t767 = a_y * t394 + t396 * t584 + unit_dc_y * t554
            + (v_a_y * t450 + t452 * t593 + v_unit_dc_y * t558);
        let t768 = a_z * t394 + t396 * t585 + unit_dc_z * t554
            + (v_a_z * t450 + t452 * t594 + v_unit_dc_z * t558);
        let t769 = a_x * t395 + t397 * t586 + unit_db_x * t555
            + (v_a_x * t451 - t453 * t595 + v_unit_db_x * t559);
        let t770 = a_y * t395 + t397 * t587 + unit_db_y * t555
            + (v_a_y * t451 - t453 * t596 + v_unit_db_y * t559);
        let t771 = a_z * t395 + t397 * t588 + unit_db_z * t555
            + (v_a_z * t451 - t453 * t597 + v_unit_db_z * t559);
        let t772 = a_x * t552 + c_x * t555 + (v_c_x * t559 - v_a_x * t556);
        let t773 = a_y * t552 + c_y * t555 + (v_c_y * t559 - v_a_y * t556);
        let t774 = a_z * t552 + c_z * t555 + (v_c_z * t559 - v_a_z * t556);
        let t775 = a_x * t553 + b_x * t554 + (v_a_x * t557 + v_b_x * t558);
        let t776 = a_y * t553 + b_y * t554 + (v_a_y * t557 + v_b_y * t558);
        let t777 = a_z * t553 + b_z * t554 + (v_a_z * t557 + v_b_z * t558);
        let t778 = t622 + t649;
        let t779 = t623 + t650;
        let t780 = t624 + t651;
        let t781 = a_x * t562 + t566 * t583 + unit_dc_x * t567
            + (v_a_x * t571 + t575 * t592 + v_unit_dc_x * t576);
        let t782 = a_y * t562 + t566 * t584 + unit_dc_y * t567
            + (v_a_y * t571 + t575 * t593 + v_unit_dc_y * t576);
        let t783 = a_z * t562 + t566 * t585 + unit_dc_z * t567
            + (v_a_z * t571 + t575 * t594 + v_unit_dc_z * t576);
        let t784 = a_x * t563 + t568 * t586 + unit_db_x * t569
            + (v_a_x * t572 - t577 * t595 + v_unit_db_x * t578);
        let t785 = a_y * t563 + t568 * t587 + unit_db_y * t569
            + (v_a_y * t572 - t577 * t596 + v_unit_db_y * t578);
        let t786 = a_z * t563 + t568 * t588 + unit_db_z * t569
            + (v_a_z * t572 - t577 * t597 + v_unit_db_z * t578);
        let t787 = a_x * t564 + c_x * t569 + (v_c_x * t578 - v_a_x * t573);
        let t788 = a_y * t564 + c_y * t569 + (v_c_y * t578 - v_a_y * t573);
        let t789 = a_z * t564 + c_z * t569 + (v_c_z * t578 - v_a_z * t573);
        let t790 = a_x * t565 + b_x * t567 + (v_a_x * t574 + v_b_x * t576);
        let t791 = a_y * t565 + b_y * t567 + (v_a_y * t574 + v_b_y * t576);
        let t792 = a_z * t565 + b_z * t567 + (v_a_z * t574 + v_b_z * t576);
        let t793 = unit_dc_x * t531 + v_unit_dc_x * t532;
        let t794 = unit_dc_y * t531 + v_unit_dc_y * t532;
        let t795 = unit_dc_z * t531 + v_unit_dc_z * t532;
        let t796 = c_x * t531 + v_c_x * t532;
        let t797 = c_y * t531 + v_c_y * t532;
        let t798 = c_z * t531 + v_c_z * t532;
        let t799 = t580 * t652 + b_x * t667 + c_x * t682 + unit_db_x * t697
            + unit_dc_x * t712;
        let t800 = t580 * t653 + b_x * t668 + c_x * t683 + unit_db_x * t698
            + unit_dc_x * t713;
        let t801 = t580 * t654 + b_x * t669 + c_x * t684 + unit_db_x * t699
            + unit_dc_x * t714;
        let t802 = t581 * t652 + b_y * t667 + c_y * t682 + unit_db_y * t697
            + unit_dc_y * t712;
        let t803 = t581 * t653 + b_y * t668 + c_y * t683 + unit_db_y * t698
            + unit_dc_y * t713;
        let t804 = t581 * t654 + b_y * t669 + c_y * t684 + unit_db_y * t699
            + unit_dc_y * t714;
        let t805 = t582 * t652 + b_z * t667 + c_z * t682 + unit_db_z * t697
            + unit_dc_z * t712;
        let t806 = t582 * t653 + b_z * t668 + c_z * t683 + unit_db_z * t698
            + unit_dc_z * t713;
        let t807 = t582 * t654 + b_z * t669 + c_z * t684 + unit_db_z * t699
            + unit_dc_z * t714;
        let t808 = t580 * t655 + b_x * t670 + c_x * t685 - unit_db_x * t700
            + unit_dc_x * t715;
        let t809 = t580 * t656 + b_x * t671 + c_x * t686 - unit_db_x * t701
            + unit_dc_x * t716;
        let t810 = t580 * t657 + b_x * t672 + c_x * t687 - unit_db_x * t702
            + unit_dc_x * t717;
        let t811 = t581 * t655 + b_y * t670 + c_y * t685 - unit_db_y * t700
            + unit_dc_y * t715;
        let t812 = t581 * t656 + b_y * t671 + c_y * t686 - unit_db_y * t701
            + unit_dc_y * t716;
        let t813 = t581 * t657 + b_y * t672 + c_y * t687 - unit_db_y * t702
            + unit_dc_y * t717;
        let t814 = t582 * t655 + b_z * t670 + c_z * t685 - unit_db_z * t700
            + unit_dc_z * t715;
        let t815 = t582 * t656 + b_z * t671 + c_z * t686 - unit_db_z * t701
            + unit_dc_z * t716;
        let t816 = t582 * t657 + b_z * t672 + c_z * t687 - unit_db_z * t702
            + unit_dc_z * t717;
        let t817 = t580 * t658 + b_x * t673 + c_x * t688 + unit_db_x * t703
            + unit_dc_x * t718;
        let t818 = t580 * t659 + b_x * t674 + c_x * t689 + unit_db_x * t704
            + unit_dc_x * t719;
        let t819 = t580 * t660 + b_x * t675 + c_x * t690 + unit_db_x * t705
            + unit_dc_x * t720;
        let t820 = t581 * t658 + b_y * t673 + c_y * t688 + unit_db_y * t703
            + unit_dc_y * t718;
        let t821 = t581 * t659 + b_y * t674 + c_y * t689 + unit_db_y * t704
            + unit_dc_y * t719;
        let t822 = t581 * t660 + b_y * t675 + c_y * t690 + unit_db_y * t705
            + unit_dc_y * t720;
        let t823 = t582 * t658 + b_z * t673 + c_z * t688 + unit_db_z * t703
            + unit_dc_z * t718;
        let t824 = t582 * t659 + b_z * t674 + c_z * t689 + unit_db_z * t704
            + unit_dc_z * t719;
        let t825 = t582 * t660 + b_z * t675 + c_z * t690 + unit_db_z * t705
            + unit_dc_z * t720;
        let t826 = t580 * t661 + b_x * t676 + c_x * t691 + unit_db_x * t706
            + unit_dc_x * t721;
        let t827 = t580 * t662 + b_x * t677 + c_x * t692 + unit_db_x * t707
            + unit_dc_x * t722;
        let t828 = t580 * t663 + b_x * t678 + c_x * t693 + unit_db_x * t708
            + unit_dc_x * t723;
        let t829 = t581 * t661 + b_y * t676 + c_y * t691 + unit_db_y * t706
            + unit_dc_y * t721;
        let t830 = t581 * t662 + b_y * t677 + c_y * t692 + unit_db_y * t707
            + unit_dc_y * t722;
        let t831 = t581 * t663 + b_y * t678 + c_y * t693 + unit_db_y * t708
            + unit_dc_y * t723;
        let t832 = t582 * t661 + b_z * t676 + c_z * t691 + unit_db_z * t706
            + unit_dc_z * t721;
        let t833 = t582 * t662 + b_z * t677 + c_z * t692 + unit_db_z * t707
            + unit_dc_z * t722;
        let t834 = t582 * t663 + b_z * t678 + c_z * t693 + unit_db_z * t708
            + unit_dc_z * t723;
        let t835 = t580 * t664 + b_x * t679 + c_x * t694 - unit_db_x * t709
            + unit_dc_x * t724;
        let t836 = t580 * t665 + b_x * t680 + c_x * t695 - unit_db_x * t710
            + unit_dc_x * t725;
        let t837 = t580 * t666 + b_x * t681 + c_x * t696 - unit_db_x * t711
            + unit_dc_x * t726;
        let t838 = t581 * t664 + b_y * t679 + c_y * t694 - unit_db_y * t709
            + unit_dc_y * t724;
        let t839 = t581 * t665 + b_y * t680 + c_y * t695 - unit_db_y * t710
            + unit_dc_y * t725;
        let t840 = t581 * t666 + b_y * t681 + c_y * t696 - unit_db_y * t711
            + unit_dc_y * t726;
        let t841 = t582 * t664 + b_z * t679 + c_z * t694 - unit_db_z * t709
            + unit_dc_z * t724;
        let t842 = t582 * t665 + b_z * t680 + c_z * t695 - unit_db_z * t710
            + unit_dc_z * t725;
        let t843 = t582 * t666 + b_z * t681 + c_z * t696 - unit_db_z * t711
            + unit_dc_z * t726;
        let t844 = 2.0 * (t124 * t129 + t133 * t134 + t137 * t138);
        let t845 = 2.0 * (t124 * t223 - t133 * t224 - t137 * t222);
        let t846 = 2.0 * (t124 * t252 + t133 * t251);
        let t847 = t404 * t580 + b_x * t408 + c_x * t412 - unit_db_x * t463
            + unit_dc_x * t464;
        let t848 = t404 * t581 + b_y * t408 + c_y * t412 - unit_db_y * t463
            + unit_dc_y * t464;
        let t849 = t404 * t582 + b_z * t408 + c_z * t412 - unit_db_z * t463
            + unit_dc_z * t464;
        let t850 = a_x * t408 + t422 * t583 + unit_dc_x * t465;
        let t851 = a_y * t408 + t422 * t584 + unit_dc_y * t465;
        let t852 = a_z * t408 + t422 * t585 + unit_dc_z * t465;
        let t853 = a_x * t412 - t429 * t586 + unit_db_x * t466;
        let t854 = a_y * t412 - t429 * t587 + unit_db_y * t466;
        let t855 = a_z * t412 - t429 * t588 + unit_db_z * t466;
        let t856 = c_x * t466 - a_x * t463;
        let t857 = c_y * t466 - a_y * t463;
        let t858 = c_z * t466 - a_z * t463;
        let t859 = a_x * t464 + b_x * t465;
        let t860 = a_y * t464 + b_y * t465;
        let t861 = a_z * t464 + b_z * t465;
        let t862 = t433 * t580 + b_x * t434 + c_x * t435 - unit_db_x * t471
            + unit_dc_x * t472;
        let t863 = t433 * t581 + b_y * t434 + c_y * t435 - unit_db_y * t471
            + unit_dc_y * t472;
        let t864 = t433 * t582 + b_z * t434 + c_z * t435 - unit_db_z * t471
            + unit_dc_z * t472;
        let t865 = a_x * t434 + t436 * t583 + unit_dc_x * t473;
        let t866 = a_y * t434 + t436 * t584 + unit_dc_y * t473;
        let t867 = a_z * t434 + t436 * t585 + unit_dc_z * t473;
        let t868 = a_x * t435 - t437 * t586 + unit_db_x * t474;
        let t869 = a_y * t435 - t437 * t587 + unit_db_y * t474;
        let t870 = a_z * t435 - t437 * t588 + unit_db_z * t474;
        let t871 = c_x * t474 - a_x * t471;
        let t872 = c_y * t474 - a_y * t471;
        let t873 = c_z * t474 - a_z * t471;
        let t874 = a_x * t472 + b_x * t473;
        let t875 = a_y * t472 + b_y * t473;
        let t876 = a_z * t472 + b_z * t473;
        let t877 = t438 * t580 + b_x * t439 + c_x * t440 - unit_db_x * t479
            + unit_dc_x * t480;
        let t878 = t438 * t581 + b_y * t439 + c_y * t440 - unit_db_y * t479
            + unit_dc_y * t480;
        let t879 = t438 * t582 + b_z * t439 + c_z * t440 - unit_db_z * t479
            + unit_dc_z * t480;
        let t880 = a_x * t439 + t441 * t583 + unit_dc_x * t481;
        let t881 = a_y * t439 + t441 * t584 + unit_dc_y * t481;
        let t882 = a_z * t439 + t441 * t585 + unit_dc_z * t481;
        let t883 = a_x * t440 - t442 * t586 + unit_db_x * t482;
        let t884 = a_y * t440 - t442 * t587 + unit_db_y * t482;
        let t885 = a_z * t440 - t442 * t588 + unit_db_z * t482;
        let t886 = c_x * t482 - a_x * t479;
        let t887 = c_y * t482 - a_y * t479;
        let t888 = c_z * t482 - a_z * t479;
        let t889 = a_x * t480 + b_x * t481;
        let t890 = a_y * t480 + b_y * t481;
        let t891 = a_z * t480 + b_z * t481;
        let t892 = unit_db_x * t497 - (t494 * t580 + b_x * t495 + c_x * t496)
            - unit_dc_x * t498;
        let t893 = unit_db_y * t497 - (t494 * t581 + b_y * t495 + c_y * t496)
            - unit_dc_y * t498;
        let t894 = unit_db_z * t497 - (t494 * t582 + b_z * t495 + c_z * t496)
            - unit_dc_z * t498;
        let t895 = a_x * t495 + t499 * t583 + unit_dc_x * t500;
        let t896 = a_y * t495 + t499 * t584 + unit_dc_y * t500;
        let t897 = a_z * t495 + t499 * t585 + unit_dc_z * t500;
        let t898 = t501 * t586 - a_x * t496 - unit_db_x * t502;
        let t899 = t501 * t587 - a_y * t496 - unit_db_y * t502;
        let t900 = t501 * t588 - a_z * t496 - unit_db_z * t502;
        let t901 = a_x * t497 - c_x * t502;
        let t902 = a_y * t497 - c_y * t502;
        let t903 = a_z * t497 - c_z * t502;
        let t904 = a_x * t498 + b_x * t500;
        let t905 = a_y * t498 + b_y * t500;
        let t906 = a_z * t498 + b_z * t500;
        let t907 = t513 * t580 + b_x * t514 + c_x * t515 - unit_db_x * t516
            + unit_dc_x * t517;
        let t908 = t513 * t581 + b_y * t514 + c_y * t515 - unit_db_y * t516
            + unit_dc_y * t517;
        let t909 = t513 * t582 + b_z * t514 + c_z * t515 - unit_db_z * t516
            + unit_dc_z * t517;
        let t910 = a_x * t514 + t518 * t583 + unit_dc_x * t519;
        let t911 = a_y * t514 + t518 * t584 + unit_dc_y * t519;
        let t912 = a_z * t514 + t518 * t585 + unit_dc_z * t519;
        let t913 = a_x * t515 - t520 * t586 + unit_db_x * t521;
        let t914 = a_y * t515 - t520 * t587 + unit_db_y * t521;
        let t915 = a_z * t515 - t520 * t588 + unit_db_z * t521;
        let t916 = c_x * t521 - a_x * t516;
        let t917 = c_y * t521 - a_y * t516;
        let t918 = c_z * t521 - a_z * t516;
        let t919 = a_x * t517 + b_x * t519;
        let t920 = a_y * t517 + b_y * t519;
        let t921 = a_z * t517 + b_z * t519;
        let t922 = a_x * t444 + t446 * t583 + unit_dc_x * t528;
        let t923 = a_y * t444 + t446 * t584 + unit_dc_y * t528;
        let t924 = a_z * t444 + t446 * t585 + unit_dc_z * t528;
        let t925 = a_x * t445 + t447 * t586 + unit_db_x * t529;
        let t926 = a_y * t445 + t447 * t587 + unit_db_y * t529;
        let t927 = a_z * t445 + t447 * t588 + unit_db_z * t529;
        let t928 = a_x * t526 + c_x * t529;
        let t929 = a_y * t526 + c_y * t529;
        let t930 = a_z * t526 + c_z * t529;
        let t931 = a_x * t527 + b_x * t528;
        let t932 = a_y * t527 + b_y * t528;
        let t933 = a_z * t527 + b_z * t528;
        let t934 = unit_db_x * t532;
        let t935 = unit_db_y * t532;
        let t936 = unit_db_z * t532;
        let t937 = b_x * t532;
        let t938 = b_y * t532;
        let t939 = b_z * t532;
        let t940 = a_x * t544 + t548 * t583 + unit_dc_x * t549;
        let t941 = a_y * t544 + t548 * t584 + unit_dc_y * t549;
        let t942 = a_z * t544 + t548 * t585 + unit_dc_z * t549;
        let t943 = a_x * t545 - t550 * t586 + unit_db_x * t551;
        let t944 = a_y * t545 - t550 * t587 + unit_db_y * t551;
        let t945 = a_z * t545 - t550 * t588 + unit_db_z * t551;
        let t946 = c_x * t551 - a_x * t546;
        let t947 = c_y * t551 - a_y * t546;
        let t948 = c_z * t551 - a_z * t546;
        let t949 = a_x * t547 + b_x * t549;
        let t950 = a_y * t547 + b_y * t549;
        let t951 = a_z * t547 + b_z * t549;
        let t952 = a_x * t451 - t453 * t586 + unit_db_x * t559;
        let t953 = a_y * t451 - t453 * t587 + unit_db_y * t559;
        let t954 = a_z * t451 - t453 * t588 + unit_db_z * t559;
        let t955 = a_x * t557 + b_x * t558;
        let t956 = a_y * t557 + b_y * t558;
        let t957 = a_z * t557 + b_z * t558;
        let t958 = a_x * t571 + t575 * t583 + unit_dc_x * t576;
        let t959 = a_y * t571 + t575 * t584 + unit_dc_y * t576;
        let t960 = a_z * t571 + t575 * t585 + unit_dc_z * t576;
        let t961 = a_x * t572 - t577 * t586 + unit_db_x * t578;
        let t962 = a_y * t572 - t577 * t587 + unit_db_y * t578;
        let t963 = a_z * t572 - t577 * t588 + unit_db_z * t578;
        let t964 = c_x * t578 - a_x * t573;
        let t965 = c_y * t578 - a_y * t573;
        let t966 = c_z * t578 - a_z * t573;
        let t967 = a_x * t574 + b_x * t576;
        let t968 = a_y * t574 + b_y * t576;
        let t969 = a_z * t574 + b_z * t576;
        let t970 = unit_dc_x * t532;
        let t971 = unit_dc_y * t532;
        let t972 = unit_dc_z * t532;
        let t973 = c_x * t532;
        let t974 = c_y * t532;
        let t975 = c_z * t532;
        let t976 = t580 * t847 + b_x * t862 + c_x * t877 + unit_db_x * t892
            + unit_dc_x * t907;
        let t977 = t580 * t848 + b_x * t863 + c_x * t878 + unit_db_x * t893
            + unit_dc_x * t908;
        let t978 = t580 * t849 + b_x * t864 + c_x * t879 + unit_db_x * t894
            + unit_dc_x * t909;
        let t979 = t581 * t847 + b_y * t862 + c_y * t877 + unit_db_y * t892
            + unit_dc_y * t907;
        let t980 = t581 * t848 + b_y * t863 + c_y * t878 + unit_db_y * t893
            + unit_dc_y * t908;
        let t981 = t581 * t849 + b_y * t864 + c_y * t879 + unit_db_y * t894
            + unit_dc_y * t909;
        let t982 = t582 * t847 + b_z * t862 + c_z * t877 + unit_db_z * t892
            + unit_dc_z * t907;
        let t983 = t582 * t848 + b_z * t863 + c_z * t878 + unit_db_z * t893
            + unit_dc_z * t908;
        let t984 = t582 * t849 + b_z * t864 + c_z * t879 + unit_db_z * t894
            + unit_dc_z * t909;
        let t985 = t580 * t850 + b_x * t865 + c_x * t880 - unit_db_x * t895
            + unit_dc_x * t910;
        let t986 = t580 * t851 + b_x * t866 + c_x * t881 - unit_db_x * t896
            + unit_dc_x * t911;
        let t987 = t580 * t852 + b_x * t867 + c_x * t882 - unit_db_x * t897
            + unit_dc_x * t912;
        let t988 = t581 * t850 + b_y * t865 + c_y * t880 - unit_db_y * t895
            + unit_dc_y * t910;
        let t989 = t581 * t851 + b_y * t866 + c_y * t881 - unit_db_y * t896
            + unit_dc_y * t911;
        let t990 = t581 * t852 + b_y * t867 + c_y * t882 - unit_db_y * t897
            + unit_dc_y * t912;
        let t991 = t582 * t850 + b_z * t865 + c_z * t880 - unit_db_z * t895
            + unit_dc_z * t910;
        let t992 = t582 * t851 + b_z * t866 + c_z * t881 - unit_db_z * t896
            + unit_dc_z * t911;
        let t993 = t582 * t852 + b_z * t867 + c_z * t882 - unit_db_z * t897
            + unit_dc_z * t912;
        let t994 = t580 * t853 + b_x * t868 + c_x * t883 + unit_db_x * t898
            + unit_dc_x * t913;
        let t995 = t580 * t854 + b_x * t869 + c_x * t884 + unit_db_x * t899
            + unit_dc_x * t914;
        let t996 = t580 * t855 + b_x * t870 + c_x * t885 + unit_db_x * t900
            + unit_dc_x * t915;
        let t997 = t581 * t853 + b_y * t868 + c_y * t883 + unit_db_y * t898
            + unit_dc_y * t913;
        let t998 = t581 * t854 + b_y * t869 + c_y * t884 + unit_db_y * t899
            + unit_dc_y * t914;
        let t999 = t581 * t855 + b_y * t870 + c_y * t885 + unit_db_y * t900
            + unit_dc_y * t915;
        let t1000 = t582 * t853 + b_z * t868 + c_z * t883 + unit_db_z * t898
            + unit_dc_z * t913;
        let t1001 = t582 * t854 + b_z * t869 + c_z * t884 + unit_db_z * t899
            + unit_dc_z * t914;
        let t1002 = t582 * t855 + b_z * t870 + c_z * t885 + unit_db_z * t900
            + unit_dc_z * t915;
        let t1003 = t580 * t856 + b_x * t871 + c_x * t886 + unit_db_x * t901
            + unit_dc_x * t916;
        let t1004 = t580 * t857 + b_x * t872 + c_x * t887 + unit_db_x * t902
            + unit_dc_x * t917;
        let t1005 = t580 * t858 + b_x * t873 + c_x * t888 + unit_db_x * t903
            + unit_dc_x * t918;
        let t1006 = t581 * t856 + b_y * t871 + c_y * t886 + unit_db_y * t901
            + unit_dc_y * t916;
        let t1007 = t581 * t857 + b_y * t872 + c_y * t887 + unit_db_y * t902
            + unit_dc_y * t917;
        let t1008 = t581 * t858 + b_y * t873 + c_y * t888 + unit_db_y * t903
            + unit_dc_y * t918;
        let t1009 = t582 * t856 + b_z * t871 + c_z * t886 + unit_db_z * t901
            + unit_dc_z * t916;
        let t1010 = t582 * t857 + b_z * t872 + c_z * t887 + unit_db_z * t902
            + unit_dc_z * t917;
        let t1011 = t582 * t858 + b_z * t873 + c_z * t888 + unit_db_z * t903
            + unit_dc_z * t918;
        let t1012 = t580 * t859 + b_x * t874 + c_x * t889 - unit_db_x * t904
            + unit_dc_x * t919;
        let t1013 = t580 * t860 + b_x * t875 + c_x * t890 - unit_db_x * t905
            + unit_dc_x * t920;
        let t1014 = t580 * t861 + b_x * t876 + c_x * t891 - unit_db_x * t906
            + unit_dc_x * t921;
        let t1015 = t581 * t859 + b_y * t874 + c_y * t889 - unit_db_y * t904
            + unit_dc_y * t919;
        let t1016 = t581 * t860 + b_y * t875 + c_y * t890 - unit_db_y * t905
            + unit_dc_y * t920;
        let t1017 = t581 * t861 + b_y * t876 + c_y * t891 - unit_db_y * t906
            + unit_dc_y * t921;
        let t1018 = t582 * t859 + b_z * t874 + c_z * t889 - unit_db_z * t904
            + unit_dc_z * t919;
        let t1019 = t582 * t860 + b_z * t875 + c_z * t890 - unit_db_z * t905
            + unit_dc_z * t920;
        let t1020 = t582 * t861 + b_z * t876 + c_z * t891 - unit_db_z * t906
            + unit_dc_z * t921;
        stiffness[0][0] = t799 + t844;
        stiffness[0][1] = t800;
        stiffness[0][2] = t801;
        stiffness[0][3] = t802;
        stiffness[0][4] = t803 + t844;
        stiffness[0][5] = t804;
        stiffness[0][6] = t805;
        stiffness[0][7] = t806;
        stiffness[0][8] = t807 + t844;
        stiffness[1][0] = t454 + t808;
        stiffness[1][1] = t809;
        stiffness[1][2] = t810;
        stiffness[1][3] = t811;
        stiffness[1][4] = t454 + t812;
        stiffness[1][5] = t813;
        stiffness[1][6] = t814;
        stiffness[1][7] = t815;
        stiffness[1][8] = t454 + t816;
        stiffness[2][0] = t826 - t483;
        stiffness[2][1] = t827;
        stiffness[2][2] = t828;
        stiffness[2][3] = t829;
        stiffness[2][4] = t830 - t483;
        stiffness[2][5] = t831;
        stiffness[2][6] = t832;
        stiffness[2][7] = t833;
        stiffness[2][8] = t834 - t483;
        stiffness[3][0] = t455 + t817;
        stiffness[3][1] = t818;
        stiffness[3][2] = t819;
        stiffness[3][3] = t820;
        stiffness[3][4] = t455 + t821;
        stiffness[3][5] = t822;
        stiffness[3][6] = t823;
        stiffness[3][7] = t824;
        stiffness[3][8] = t455 + t825;
        stiffness[4][0] = t503 + t835;
        stiffness[4][1] = t836;
        stiffness[4][2] = t837;
        stiffness[4][3] = t838;
        stiffness[4][4] = t503 + t839;
        stiffness[4][5] = t840;
        stiffness[4][6] = t841;
        stiffness[4][7] = t842;
        stiffness[4][8] = t503 + t843;
        stiffness[5][0] = t454 + (a_x * t667 + t583 * t727 + unit_dc_x * t748);
        stiffness[5][1] = a_x * t668 + t583 * t728 + unit_dc_x * t749;
        stiffness[5][2] = a_x * t669 + t583 * t729 + unit_dc_x * t750;
        stiffness[5][3] = a_y * t667 + t584 * t727 + unit_dc_y * t748;
        stiffness[5][4] = t454 + (a_y * t668 + t584 * t728 + unit_dc_y * t749);
        stiffness[5][5] = a_y * t669 + t584 * t729 + unit_dc_y * t750;
        stiffness[5][6] = a_z * t667 + t585 * t727 + unit_dc_z * t748;
        stiffness[5][7] = a_z * t668 + t585 * t728 + unit_dc_z * t749;
        stiffness[5][8] = t454 + (a_z * t669 + t585 * t729 + unit_dc_z * t750);
        stiffness[6][0] = a_x * t697 + c_x * t778 - t483;
        stiffness[6][1] = a_x * t698 + c_x * t779;
        stiffness[6][2] = a_x * t699 + c_x * t780;
        stiffness[6][3] = a_y * t697 + c_y * t778;
        stiffness[6][4] = a_y * t698 + c_y * t779 - t483;
        stiffness[6][5] = a_y * t699 + c_y * t780;
        stiffness[6][6] = a_z * t697 + c_z * t778;
        stiffness[6][7] = a_z * t698 + c_z * t779;
        stiffness[6][8] = a_z * t699 + c_z * t780 - t483;
        stiffness[7][0] = a_x * t670 + t583 * t730 + unit_db_x * t742 + unit_dc_x * t751
            + t845;
        stiffness[7][1] = a_x * t671 + t583 * t731 + unit_db_x * t743 + unit_dc_x * t752;
        stiffness[7][2] = a_x * t672 + t583 * t732 + unit_db_x * t744 + unit_dc_x * t753;
        stiffness[7][3] = a_y * t670 + t584 * t730 + unit_db_y * t742 + unit_dc_y * t751;
        stiffness[7][4] = a_y * t671 + t584 * t731 + unit_db_y * t743 + unit_dc_y * t752
            + t845;
        stiffness[7][5] = a_y * t672 + t584 * t732 + unit_db_y * t744 + unit_dc_y * t753;
        stiffness[7][6] = a_z * t670 + t585 * t730 + unit_db_z * t742 + unit_dc_z * t751;
        stiffness[7][7] = a_z * t671 + t585 * t731 + unit_db_z * t743 + unit_dc_z * t752;
        stiffness[7][8] = a_z * t672 + t585 * t732 + unit_db_z * t744 + unit_dc_z * t753
            + t845;
        stiffness[8][0] = t530
            + (a_x * t676 + t583 * t736 + unit_db_x * t745 + unit_dc_x * t757);
        stiffness[8][1] = a_x * t677 + t583 * t737 + unit_db_x * t746 + unit_dc_x * t758;
        stiffness[8][2] = a_x * t678 + t583 * t738 + unit_db_x * t747 + unit_dc_x * t759;
        stiffness[8][3] = a_y * t676 + t584 * t736 + unit_db_y * t745 + unit_dc_y * t757;
        stiffness[8][4] = t530
            + (a_y * t677 + t584 * t737 + unit_db_y * t746 + unit_dc_y * t758);
        stiffness[8][5] = a_y * t678 + t584 * t738 + unit_db_y * t747 + unit_dc_y * t759;
        stiffness[8][6] = a_z * t676 + t585 * t736 + unit_db_z * t745 + unit_dc_z * t757;
        stiffness[8][7] = a_z * t677 + t585 * t737 + unit_db_z * t746 + unit_dc_z * t758;
        stiffness[8][8] = t530
            + (a_z * t678 + t585 * t738 + unit_db_z * t747 + unit_dc_z * t759);
        stiffness[9][0] = t530 + (b_x * t742 - a_x * t700 + c_x * t781);
        stiffness[9][1] = b_x * t743 - a_x * t701 + c_x * t782;
        stiffness[9][2] = b_x * t744 - a_x * t702 + c_x * t783;
        stiffness[9][3] = b_y * t742 - a_y * t700 + c_y * t781;
        stiffness[9][4] = t530 + (b_y * t743 - a_y * t701 + c_y * t782);
        stiffness[9][5] = b_y * t744 - a_y * t702 + c_y * t783;
        stiffness[9][6] = b_z * t742 - a_z * t700 + c_z * t781;
        stiffness[9][7] = b_z * t743 - a_z * t701 + c_z * t782;
        stiffness[9][8] = t530 + (b_z * t744 - a_z * t702 + c_z * t783);
        stiffness[10][0] = a_x * t706 + b_x * t745 + c_x * t787;
        stiffness[10][1] = a_x * t707 + b_x * t746 + c_x * t788;
        stiffness[10][2] = a_x * t708 + b_x * t747 + c_x * t789;
        stiffness[10][3] = a_y * t706 + b_y * t745 + c_y * t787;
        stiffness[10][4] = a_y * t707 + b_y * t746 + c_y * t788;
        stiffness[10][5] = a_y * t708 + b_y * t747 + c_y * t789;
        stiffness[10][6] = a_z * t706 + b_z * t745 + c_z * t787;
        stiffness[10][7] = a_z * t707 + b_z * t746 + c_z * t788;
        stiffness[10][8] = a_z * t708 + b_z * t747 + c_z * t789;
        stiffness[11][0] = a_x * t673 + t583 * t733 + unit_dc_x * t754;
        stiffness[11][1] = a_x * t674 + t583 * t734 + unit_dc_x * t755;
        stiffness[11][2] = a_x * t675 + t583 * t735 + unit_dc_x * t756;
        stiffness[11][3] = a_y * t673 + t584 * t733 + unit_dc_y * t754;
        stiffness[11][4] = a_y * t674 + t584 * t734 + unit_dc_y * t755;
        stiffness[11][5] = a_y * t675 + t584 * t735 + unit_dc_y * t756;
        stiffness[11][6] = a_z * t673 + t585 * t733 + unit_dc_z * t754;
        stiffness[11][7] = a_z * t674 + t585 * t734 + unit_dc_z * t755;
        stiffness[11][8] = a_z * t675 + t585 * t735 + unit_dc_z * t756;
        stiffness[12][0] = t533 + (a_x * t679 + t583 * t739 + unit_dc_x * t760);
        stiffness[12][1] = a_x * t680 + t583 * t740 + unit_dc_x * t761;
        stiffness[12][2] = a_x * t681 + t583 * t741 + unit_dc_x * t762;
        stiffness[12][3] = a_y * t679 + t584 * t739 + unit_dc_y * t760;
        stiffness[12][4] = t533 + (a_y * t680 + t584 * t740 + unit_dc_y * t761);
        stiffness[12][5] = a_y * t681 + t584 * t741 + unit_dc_y * t762;
        stiffness[12][6] = a_z * t679 + t585 * t739 + unit_dc_z * t760;
        stiffness[12][7] = a_z * t680 + t585 * t740 + unit_dc_z * t761;
        stiffness[12][8] = t533 + (a_z * t681 + t585 * t741 + unit_dc_z * t762);
        stiffness[13][0] = t560 + (a_x * t703 + c_x * t784);
        stiffness[13][1] = a_x * t704 + c_x * t785;
        stiffness[13][2] = a_x * t705 + c_x * t786;
        stiffness[13][3] = a_y * t703 + c_y * t784;
        stiffness[13][4] = t560 + (a_y * t704 + c_y * t785);
        stiffness[13][5] = a_y * t705 + c_y * t786;
        stiffness[13][6] = a_z * t703 + c_z * t784;
        stiffness[13][7] = a_z * t704 + c_z * t785;
        stiffness[13][8] = t560 + (a_z * t705 + c_z * t786);
        stiffness[14][0] = c_x * t790 - a_x * t709;
        stiffness[14][1] = c_x * t791 - a_x * t710;
        stiffness[14][2] = c_x * t792 - a_x * t711;
        stiffness[14][3] = c_y * t790 - a_y * t709;
        stiffness[14][4] = c_y * t791 - a_y * t710;
        stiffness[14][5] = c_y * t792 - a_y * t711;
        stiffness[14][6] = c_z * t790 - a_z * t709;
        stiffness[14][7] = c_z * t791 - a_z * t710;
        stiffness[14][8] = c_z * t792 - a_z * t711;
        stiffness[15][0] = t455 + (a_x * t682 + t586 * t763 + unit_db_x * t778);
        stiffness[15][1] = a_x * t683 + t586 * t764 + unit_db_x * t779;
        stiffness[15][2] = a_x * t684 + t586 * t765 + unit_db_x * t780;
        stiffness[15][3] = a_y * t682 + t587 * t763 + unit_db_y * t778;
        stiffness[15][4] = t455 + (a_y * t683 + t587 * t764 + unit_db_y * t779);
        stiffness[15][5] = a_y * t684 + t587 * t765 + unit_db_y * t780;
        stiffness[15][6] = a_z * t682 + t588 * t763 + unit_db_z * t778;
        stiffness[15][7] = a_z * t683 + t588 * t764 + unit_db_z * t779;
        stiffness[15][8] = t455 + (a_z * t684 + t588 * t765 + unit_db_z * t780);
        stiffness[16][0] = t503 + (a_x * t712 + b_x * t748);
        stiffness[16][1] = a_x * t713 + b_x * t749;
        stiffness[16][2] = a_x * t714 + b_x * t750;
        stiffness[16][3] = a_y * t712 + b_y * t748;
        stiffness[16][4] = t503 + (a_y * t713 + b_y * t749);
        stiffness[16][5] = a_y * t714 + b_y * t750;
        stiffness[16][6] = a_z * t712 + b_z * t748;
        stiffness[16][7] = a_z * t713 + b_z * t749;
        stiffness[16][8] = t503 + (a_z * t714 + b_z * t750);
        stiffness[17][0] = a_x * t685 + t586 * t766 + unit_db_x * t781;
        stiffness[17][1] = a_x * t686 + t586 * t767 + unit_db_x * t782;
        stiffness[17][2] = a_x * t687 + t586 * t768 + unit_db_x * t783;
        stiffness[17][3] = a_y * t685 + t587 * t766 + unit_db_y * t781;
        stiffness[17][4] = a_y * t686 + t587 * t767 + unit_db_y * t782;
        stiffness[17][5] = a_y * t687 + t587 * t768 + unit_db_y * t783;
        stiffness[17][6] = a_z * t685 + t588 * t766 + unit_db_z * t781;
        stiffness[17][7] = a_z * t686 + t588 * t767 + unit_db_z * t782;
        stiffness[17][8] = a_z * t687 + t588 * t768 + unit_db_z * t783;
        stiffness[18][0] = t560 + (a_x * t691 + t586 * t772 + unit_db_x * t787);
        stiffness[18][1] = a_x * t692 + t586 * t773 + unit_db_x * t788;
        stiffness[18][2] = a_x * t693 + t586 * t774 + unit_db_x * t789;
        stiffness[18][3] = a_y * t691 + t587 * t772 + unit_db_y * t787;
        stiffness[18][4] = t560 + (a_y * t692 + t587 * t773 + unit_db_y * t788);
        stiffness[18][5] = a_y * t693 + t587 * t774 + unit_db_y * t789;
        stiffness[18][6] = a_z * t691 + t588 * t772 + unit_db_z * t787;
        stiffness[18][7] = a_z * t692 + t588 * t773 + unit_db_z * t788;
        stiffness[18][8] = t560 + (a_z * t693 + t588 * t774 + unit_db_z * t789);
        stiffness[19][0] = t533 + (a_x * t715 + b_x * t751);
        stiffness[19][1] = a_x * t716 + b_x * t752;
        stiffness[19][2] = a_x * t717 + b_x * t753;
        stiffness[19][3] = a_y * t715 + b_y * t751;
        stiffness[19][4] = t533 + (a_y * t716 + b_y * t752);
        stiffness[19][5] = a_y * t717 + b_y * t753;
        stiffness[19][6] = a_z * t715 + b_z * t751;
        stiffness[19][7] = a_z * t716 + b_z * t752;
        stiffness[19][8] = t533 + (a_z * t717 + b_z * t753);
        stiffness[20][0] = a_x * t721 + b_x * t757;
        stiffness[20][1] = a_x * t722 + b_x * t758;
        stiffness[20][2] = a_x * t723 + b_x * t759;
        stiffness[20][3] = a_y * t721 + b_y * t757;
        stiffness[20][4] = a_y * t722 + b_y * t758;
        stiffness[20][5] = a_y * t723 + b_y * t759;
        stiffness[20][6] = a_z * t721 + b_z * t757;
        stiffness[20][7] = a_z * t722 + b_z * t758;
        stiffness[20][8] = a_z * t723 + b_z * t759;
        stiffness[21][0] = a_x * t688 + t586 * t769 + unit_db_x * t784 + unit_dc_x * t793
            + t846;
        stiffness[21][1] = a_x * t689 + t586 * t770 + unit_db_x * t785
            + unit_dc_x * t794;
        stiffness[21][2] = a_x * t690 + t586 * t771 + unit_db_x * t786
            + unit_dc_x * t795;
        stiffness[21][3] = a_y * t688 + t587 * t769 + unit_db_y * t784
            + unit_dc_y * t793;
        stiffness[21][4] = a_y * t689 + t587 * t770 + unit_db_y * t785 + unit_dc_y * t794
            + t846;
        stiffness[21][5] = a_y * t690 + t587 * t771 + unit_db_y * t786
            + unit_dc_y * t795;
        stiffness[21][6] = a_z * t688 + t588 * t769 + unit_db_z * t784
            + unit_dc_z * t793;
        stiffness[21][7] = a_z * t689 + t588 * t770 + unit_db_z * t785
            + unit_dc_z * t794;
        stiffness[21][8] = a_z * t690 + t588 * t771 + unit_db_z * t786 + unit_dc_z * t795
            + t846;
        stiffness[22][0] = t579
            + (a_x * t694 + t586 * t775 + unit_db_x * t790 + unit_dc_x * t796);
        stiffness[22][1] = a_x * t695 + t586 * t776 + unit_db_x * t791
            + unit_dc_x * t797;
        stiffness[22][2] = a_x * t696 + t586 * t777 + unit_db_x * t792
            + unit_dc_x * t798;
        stiffness[22][3] = a_y * t694 + t587 * t775 + unit_db_y * t790
            + unit_dc_y * t796;
        stiffness[22][4] = t579
            + (a_y * t695 + t587 * t776 + unit_db_y * t791 + unit_dc_y * t797);
        stiffness[22][5] = a_y * t696 + t587 * t777 + unit_db_y * t792
            + unit_dc_y * t798;
        stiffness[22][6] = a_z * t694 + t588 * t775 + unit_db_z * t790
            + unit_dc_z * t796;
        stiffness[22][7] = a_z * t695 + t588 * t776 + unit_db_z * t791
            + unit_dc_z * t797;
        stiffness[22][8] = t579
            + (a_z * t696 + t588 * t777 + unit_db_z * t792 + unit_dc_z * t798);
        stiffness[23][0] = t579 + (a_x * t718 + b_x * t754 + c_x * t793);
        stiffness[23][1] = a_x * t719 + b_x * t755 + c_x * t794;
        stiffness[23][2] = a_x * t720 + b_x * t756 + c_x * t795;
        stiffness[23][3] = a_y * t718 + b_y * t754 + c_y * t793;
        stiffness[23][4] = t579 + (a_y * t719 + b_y * t755 + c_y * t794);
        stiffness[23][5] = a_y * t720 + b_y * t756 + c_y * t795;
        stiffness[23][6] = a_z * t718 + b_z * t754 + c_z * t793;
        stiffness[23][7] = a_z * t719 + b_z * t755 + c_z * t794;
        stiffness[23][8] = t579 + (a_z * t720 + b_z * t756 + c_z * t795);
        stiffness[24][0] = a_x * t724 + b_x * t760 + c_x * t796;
        stiffness[24][1] = a_x * t725 + b_x * t761 + c_x * t797;
        stiffness[24][2] = a_x * t726 + b_x * t762 + c_x * t798;
        stiffness[24][3] = a_y * t724 + b_y * t760 + c_y * t796;
        stiffness[24][4] = a_y * t725 + b_y * t761 + c_y * t797;
        stiffness[24][5] = a_y * t726 + b_y * t762 + c_y * t798;
        stiffness[24][6] = a_z * t724 + b_z * t760 + c_z * t796;
        stiffness[24][7] = a_z * t725 + b_z * t761 + c_z * t797;
        stiffness[24][8] = a_z * t726 + b_z * t762 + c_z * t798;
        damping_matrix[0][0] = t976;
        damping_matrix[0][1] = t977;
        damping_matrix[0][2] = t978;
        damping_matrix[0][3] = t979;
        damping_matrix[0][4] = t980;
        damping_matrix[0][5] = t981;
        damping_matrix[0][6] = t982;
        damping_matrix[0][7] = t983;
        damping_matrix[0][8] = t984;
        damping_matrix[1][0] = t985;
        damping_matrix[1][1] = t986;
        damping_matrix[1][2] = t987;
        damping_matrix[1][3] = t988;
        damping_matrix[1][4] = t989;
        damping_matrix[1][5] = t990;
        damping_matrix[1][6] = t991;
        damping_matrix[1][7] = t992;
        damping_matrix[1][8] = t993;
        damping_matrix[2][0] = t1003;
        damping_matrix[2][1] = t1004;
        damping_matrix[2][2] = t1005;
        damping_matrix[2][3] = t1006;
        damping_matrix[2][4] = t1007;
        damping_matrix[2][5] = t1008;
        damping_matrix[2][6] = t1009;
        damping_matrix[2][7] = t1010;
        damping_matrix[2][8] = t1011;
        damping_matrix[3][0] = t994;
        damping_matrix[3][1] = t995;
        damping_matrix[3][2] = t996;
        damping_matrix[3][3] = t997;
        damping_matrix[3][4] = t998;
        damping_matrix[3][5] = t999;
        damping_matrix[3][6] = t1000;
        damping_matrix[3][7] = t1001;
        damping_matrix[3][8] = t1002;
        damping_matrix[4][0] = t1012;
        damping_matrix[4][1] = t1013;
        damping_matrix[4][2] = t1014;
        damping_matrix[4][3] = t1015;
        damping_matrix[4][4] = t1016;
        damping_matrix[4][5] = t1017;
        damping_matrix[4][6] = t1018;
        damping_matrix[4][7] = t1019;
        damping_matrix[4][8] = t1020;
        damping_matrix[5][0] = a_x * t865 + t583 * t922 + unit_db_x * t934
            + unit_dc_x * t940;
        damping_matrix[5][1] = a_x * t866 + t583 * t923 + unit_db_x * t935
            + unit_dc_x * t941;
        damping_matrix[5][2] = a_x * t867 + t583 * t924 + unit_db_x * t936
            + unit_dc_x * t942;
        damping_matrix[5][3] = a_y * t865 + t584 * t922 + unit_db_y * t934
            + unit_dc_y * t940;
        damping_matrix[5][4] = a_y * t866 + t584 * t923 + unit_db_y * t935
            + unit_dc_y * t941;
        damping_matrix[5][5] = a_y * t867 + t584 * t924 + unit_db_y * t936
            + unit_dc_y * t942;
        damping_matrix[5][6] = a_z * t865 + t585 * t922 + unit_db_z * t934
            + unit_dc_z * t940;
        damping_matrix[5][7] = a_z * t866 + t585 * t923 + unit_db_z * t935
            + unit_dc_z * t941;
        damping_matrix[5][8] = a_z * t867 + t585 * t924 + unit_db_z * t936
            + unit_dc_z * t942;
        damping_matrix[6][0] = a_x * t871 + t583 * t928 + unit_db_x * t937
            + unit_dc_x * t946;
        damping_matrix[6][1] = a_x * t872 + t583 * t929 + unit_db_x * t938
            + unit_dc_x * t947;
        damping_matrix[6][2] = a_x * t873 + t583 * t930 + unit_db_x * t939
            + unit_dc_x * t948;
        damping_matrix[6][3] = a_y * t871 + t584 * t928 + unit_db_y * t937
            + unit_dc_y * t946;
        damping_matrix[6][4] = a_y * t872 + t584 * t929 + unit_db_y * t938
            + unit_dc_y * t947;
        damping_matrix[6][5] = a_y * t873 + t584 * t930 + unit_db_y * t939
            + unit_dc_y * t948;
        damping_matrix[6][6] = a_z * t871 + t585 * t928 + unit_db_z * t937
            + unit_dc_z * t946;
        damping_matrix[6][7] = a_z * t872 + t585 * t929 + unit_db_z * t938
            + unit_dc_z * t947;
        damping_matrix[6][8] = a_z * t873 + t585 * t930 + unit_db_z * t939
            + unit_dc_z * t948;
        damping_matrix[7][0] = b_x * t934 - a_x * t895 + c_x * t958;
        damping_matrix[7][1] = b_x * t935 - a_x * t896 + c_x * t959;
        damping_matrix[7][2] = b_x * t936 - a_x * t897 + c_x * t960;
        damping_matrix[7][3] = b_y * t934 - a_y * t895 + c_y * t958;
        damping_matrix[7][4] = b_y * t935 - a_y * t896 + c_y * t959;
        damping_matrix[7][5] = b_y * t936 - a_y * t897 + c_y * t960;
        damping_matrix[7][6] = b_z * t934 - a_z * t895 + c_z * t958;
        damping_matrix[7][7] = b_z * t935 - a_z * t896 + c_z * t959;
        damping_matrix[7][8] = b_z * t936 - a_z * t897 + c_z * t960;
        damping_matrix[8][0] = a_x * t901 + b_x * t937 + c_x * t964;
        damping_matrix[8][1] = a_x * t902 + b_x * t938 + c_x * t965;
        damping_matrix[8][2] = a_x * t903 + b_x * t939 + c_x * t966;
        damping_matrix[8][3] = a_y * t901 + b_y * t937 + c_y * t964;
        damping_matrix[8][4] = a_y * t902 + b_y * t938 + c_y * t965;
        damping_matrix[8][5] = a_y * t903 + b_y * t939 + c_y * t966;
        damping_matrix[8][6] = a_z * t901 + b_z * t937 + c_z * t964;
        damping_matrix[8][7] = a_z * t902 + b_z * t938 + c_z * t965;
        damping_matrix[8][8] = a_z * t903 + b_z * t939 + c_z * t966;
        damping_matrix[9][0] = a_x * t868 + t583 * t925 + unit_dc_x * t943;
        damping_matrix[9][1] = a_x * t869 + t583 * t926 + unit_dc_x * t944;
        damping_matrix[9][2] = a_x * t870 + t583 * t927 + unit_dc_x * t945;
        damping_matrix[9][3] = a_y * t868 + t584 * t925 + unit_dc_y * t943;
        damping_matrix[9][4] = a_y * t869 + t584 * t926 + unit_dc_y * t944;
        damping_matrix[9][5] = a_y * t870 + t584 * t927 + unit_dc_y * t945;
        damping_matrix[9][6] = a_z * t868 + t585 * t925 + unit_dc_z * t943;
        damping_matrix[9][7] = a_z * t869 + t585 * t926 + unit_dc_z * t944;
        damping_matrix[9][8] = a_z * t870 + t585 * t927 + unit_dc_z * t945;
        damping_matrix[10][0] = a_x * t874 + t583 * t931 + unit_dc_x * t949;
        damping_matrix[10][1] = a_x * t875 + t583 * t932 + unit_dc_x * t950;
        damping_matrix[10][2] = a_x * t876 + t583 * t933 + unit_dc_x * t951;
        damping_matrix[10][3] = a_y * t874 + t584 * t931 + unit_dc_y * t949;
        damping_matrix[10][4] = a_y * t875 + t584 * t932 + unit_dc_y * t950;
        damping_matrix[10][5] = a_y * t876 + t584 * t933 + unit_dc_y * t951;
        damping_matrix[10][6] = a_z * t874 + t585 * t931 + unit_dc_z * t949;
        damping_matrix[10][7] = a_z * t875 + t585 * t932 + unit_dc_z * t950;
        damping_matrix[10][8] = a_z * t876 + t585 * t933 + unit_dc_z * t951;
        damping_matrix[11][0] = a_x * t898 + c_x * t961;
        damping_matrix[11][1] = a_x * t899 + c_x * t962;
        damping_matrix[11][2] = a_x * t900 + c_x * t963;
        damping_matrix[11][3] = a_y * t898 + c_y * t961;
        damping_matrix[11][4] = a_y * t899 + c_y * t962;
        damping_matrix[11][5] = a_y * t900 + c_y * t963;
        damping_matrix[11][6] = a_z * t898 + c_z * t961;
        damping_matrix[11][7] = a_z * t899 + c_z * t962;
        damping_matrix[11][8] = a_z * t900 + c_z * t963;
        damping_matrix[12][0] = c_x * t967 - a_x * t904;
        damping_matrix[12][1] = c_x * t968 - a_x * t905;
        damping_matrix[12][2] = c_x * t969 - a_x * t906;
        damping_matrix[12][3] = c_y * t967 - a_y * t904;
        damping_matrix[12][4] = c_y * t968 - a_y * t905;
        damping_matrix[12][5] = c_y * t969 - a_y * t906;
        damping_matrix[12][6] = c_z * t967 - a_z * t904;
        damping_matrix[12][7] = c_z * t968 - a_z * t905;
        damping_matrix[12][8] = c_z * t969 - a_z * t906;
        damping_matrix[13][0] = a_x * t883 + t586 * t952 + unit_db_x * t961
            + unit_dc_x * t970;
        damping_matrix[13][1] = a_x * t884 + t586 * t953 + unit_db_x * t962
            + unit_dc_x * t971;
        damping_matrix[13][2] = a_x * t885 + t586 * t954 + unit_db_x * t963
            + unit_dc_x * t972;
        damping_matrix[13][3] = a_y * t883 + t587 * t952 + unit_db_y * t961
            + unit_dc_y * t970;
        damping_matrix[13][4] = a_y * t884 + t587 * t953 + unit_db_y * t962
            + unit_dc_y * t971;
        damping_matrix[13][5] = a_y * t885 + t587 * t954 + unit_db_y * t963
            + unit_dc_y * t972;
        damping_matrix[13][6] = a_z * t883 + t588 * t952 + unit_db_z * t961
            + unit_dc_z * t970;
        damping_matrix[13][7] = a_z * t884 + t588 * t953 + unit_db_z * t962
            + unit_dc_z * t971;
        damping_matrix[13][8] = a_z * t885 + t588 * t954 + unit_db_z * t963
            + unit_dc_z * t972;
        damping_matrix[14][0] = a_x * t889 + t586 * t955 + unit_db_x * t967
            + unit_dc_x * t973;
        damping_matrix[14][1] = a_x * t890 + t586 * t956 + unit_db_x * t968
            + unit_dc_x * t974;
        damping_matrix[14][2] = a_x * t891 + t586 * t957 + unit_db_x * t969
            + unit_dc_x * t975;
        damping_matrix[14][3] = a_y * t889 + t587 * t955 + unit_db_y * t967
            + unit_dc_y * t973;
        damping_matrix[14][4] = a_y * t890 + t587 * t956 + unit_db_y * t968
            + unit_dc_y * t974;
        damping_matrix[14][5] = a_y * t891 + t587 * t957 + unit_db_y * t969
            + unit_dc_y * t975;
        damping_matrix[14][6] = a_z * t889 + t588 * t955 + unit_db_z * t967
            + unit_dc_z * t973;
        damping_matrix[14][7] = a_z * t890 + t588 * t956 + unit_db_z * t968
            + unit_dc_z * t974;
        damping_matrix[14][8] = a_z * t891 + t588 * t957 + unit_db_z * t969
            + unit_dc_z * t975;
        damping_matrix[15][0] = a_x * t913 + b_x * t943 + c_x * t970;
        damping_matrix[15][1] = a_x * t914 + b_x * t944 + c_x * t971;
        damping_matrix[15][2] = a_x * t915 + b_x * t945 + c_x * t972;
        damping_matrix[15][3] = a_y * t913 + b_y * t943 + c_y * t970;
        damping_matrix[15][4] = a_y * t914 + b_y * t944 + c_y * t971;
        damping_matrix[15][5] = a_y * t915 + b_y * t945 + c_y * t972;
        damping_matrix[15][6] = a_z * t913 + b_z * t943 + c_z * t970;
        damping_matrix[15][7] = a_z * t914 + b_z * t944 + c_z * t971;
        damping_matrix[15][8] = a_z * t915 + b_z * t945 + c_z * t972;
        damping_matrix[16][0] = a_x * t919 + b_x * t949 + c_x * t973;
        damping_matrix[16][1] = a_x * t920 + b_x * t950 + c_x * t974;
        damping_matrix[16][2] = a_x * t921 + b_x * t951 + c_x * t975;
        damping_matrix[16][3] = a_y * t919 + b_y * t949 + c_y * t973;
        damping_matrix[16][4] = a_y * t920 + b_y * t950 + c_y * t974;
        damping_matrix[16][5] = a_y * t921 + b_y * t951 + c_y * t975;
        damping_matrix[16][6] = a_z * t919 + b_z * t949 + c_z * t973;
        damping_matrix[16][7] = a_z * t920 + b_z * t950 + c_z * t974;
        damping_matrix[16][8] = a_z * t921 + b_z * t951 + c_z * t975;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 56 additions, 84 multiplications, 3 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points2_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
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
        let t58 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t59 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t60 = b_x * dc_x + b_y * dc_y + b_z * dc_z;
        let t61 = c_x * db_x + c_y * db_y + c_z * db_z;
        let t62 = a_x * a_x + a_y * a_y + a_z * a_z - (t58 * t58 + t59 * t59);
        let t63 = t62.sqrt();
        let t64 = t63 - 1.0;
        let t65 = 0.5 * (t61 - t60);
        let t66 = 1.0 - 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0);
        let t67 = 1.0 - 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0);
        let t68 = t67 * ((a_x * dc_x + a_y * dc_y + a_z * dc_z + t58 * t65) / t63);
        let t69 = t66 * ((a_x * db_x + a_y * db_y + a_z * db_z - t59 * t65) / t63);
        let t70 = t65 * (t66 * t67) + reference[12] * t68 - reference[13] * t69
            + reference[15] * t64 + t58 * reference[18];
        let t71 = t68 - reference[14] * t69 + reference[16] * t64 + t58 * reference[19]
            + t59 * reference[23] - reference[1];
        let t72 = (t70 + t59 * reference[22] - reference[0]).powi(2)
            * (0.5 * (length * reference[6]))
            + t71 * t71 * (0.5 * (length * reference[7]));
        let t73 = (reference[17] * t64 - t69 + t58 * reference[20] + t59 * reference[24]
            - reference[2])
            .powi(2) * (0.5 * (length * reference[8]));
        let t74 = 0.5 * (length * reference[29]);
        let t75 = t72 + t73
            + (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]).powi(2) * t74;
        let t76 = t75
            + t74 * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]).powi(2);
        *energy = t76
            + (t60 + t61 - reference[5]).powi(2) * (0.5 * (length * reference[30]));
    }
    /// Writes the forces on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 84 additions, 124 multiplications, 1 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t46 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t47 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t48 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t49 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t50 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t51 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t52 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t53 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t54 = a_x * a_x + a_y * a_y + a_z * a_z - (t47 * t47 + t49 * t49);
        let t55 = t54.sqrt();
        let t56 = t47 * 2.0;
        let t57 = t49 * 2.0;
        let t58 = 1.0 / (2.0 * t55);
        let t59 = (t46 + t46 - (t48 * t56 + t50 * t57)) * t58 + t48 * reference[21]
            + t50 * reference[25];
        let t60 = length * reference[9]
            * (t55 - 1.0 + t47 * reference[21] + t49 * reference[25] - reference[0]
                + damping * t59);
        let t61 = length * reference[27];
        let t62 = t58 * t60;
        let t63 = length * reference[10]
            * (t47 + t49 * reference[26] - reference[1]
                + damping * (t48 + t50 * reference[26]));
        let t64 = t60 * (reference[21] - t56 * t58) + t63;
        let t65 = t60 * (reference[25] - t57 * t58) + reference[26] * t63
            + length * reference[11] * (t49 - reference[2] + damping * t50);
        let t66 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[3]
            + damping * (0.5 * (t51 + t51));
        let t67 = 0.5 * (t61 * t66);
        let t68 = length * reference[28]
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5] + damping * t52);
        let t69 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[4]
            + damping * (0.5 * (t53 + t53));
        let t70 = 0.5 * (t61 * t69);
        forces[0][0] = t62 * (a_x * 2.0) + b_x * t64 + c_x * t65;
        forces[0][1] = t62 * (a_y * 2.0) + b_y * t64 + c_y * t65;
        forces[0][2] = t62 * (a_z * 2.0) + b_z * t64 + c_z * t65;
        forces[1][0] = a_x * t64 + t67 * (b_x * 2.0) + c_x * t68;
        forces[1][1] = a_y * t64 + t67 * (b_y * 2.0) + c_y * t68;
        forces[1][2] = a_z * t64 + t67 * (b_z * 2.0) + c_z * t68;
        forces[2][0] = a_x * t65 + b_x * t68 + t70 * (c_x * 2.0);
        forces[2][1] = a_y * t65 + b_y * t68 + t70 * (c_y * 2.0);
        forces[2][2] = a_z * t65 + b_z * t68 + t70 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 419 additions, 694 multiplications, 4 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 9],
        damping_matrix: &mut [[f64; 9]; 6],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t46 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t47 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t48 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t49 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t50 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t51 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t52 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t53 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t54 = a_x * a_x + a_y * a_y + a_z * a_z - (t47 * t47 + t49 * t49);
        let t55 = t54.sqrt();
        let t56 = length * reference[9];
        let t57 = t47 * 2.0;
        let t58 = t49 * 2.0;
        let t59 = t46 + t46 - (t48 * t57 + t50 * t58);
        let t60 = 2.0 * t55;
        let t61 = 1.0 / t60;
        let t62 = t55 - 1.0 + t47 * reference[21] + t49 * reference[25] - reference[0]
            + damping * (t59 * t61 + t48 * reference[21] + t50 * reference[25]);
        let t63 = t56 * t62;
        let t64 = 2.0 * t61;
        let t65 = t61 * t64 / t60;
        let t66 = t56 * (t61 - damping * (t59 * t65));
        let t67 = t61 * t66 - t63 * t65;
        let t68 = t57 * t61;
        let t69 = reference[21] - t68;
        let t70 = t61 * (2.0 * t68) / t60;
        let t71 = t56 * (t69 + damping * (t59 * t70 - t61 * (t48 * 2.0)));
        let t72 = t63 * t70 + t61 * t71;
        let t73 = t58 * t61;
        let t74 = reference[25] - t73;
        let t75 = t61 * (2.0 * t73) / t60;
        let t76 = t56 * (t74 + damping * (t59 * t75 - t61 * (t50 * 2.0)));
        let t77 = t63 * t75 + t61 * t76;
        let t78 = t66 * t69 + t63 * (t57 * t65);
        let t79 = length * reference[10];
        let t80 = t79 + (t69 * t71 - t63 * (t64 + t57 * t70));
        let t81 = reference[26] * t79;
        let t82 = t69 * t76 - t63 * (t57 * t75) + t81;
        let t83 = t66 * t74 + t63 * (t58 * t65);
        let t84 = t81 + (t71 * t74 - t63 * (t58 * t70));
        let t85 = length * reference[11];
        let t86 = t85 + (t74 * t76 - t63 * (t64 + t58 * t75) + reference[26] * t81);
        let t87 = length * reference[27];
        let t88 = 0.5 * (0.5 * t87);
        let t89 = length * reference[28];
        let t90 = t56 * (damping * t61);
        let t91 = t61 * t90;
        let t92 = t56 * (damping * t69);
        let t93 = t61 * t92;
        let t94 = t56 * (damping * t74);
        let t95 = t61 * t94;
        let t96 = t69 * t90;
        let t97 = damping * t79;
        let t98 = t69 * t92 + t97;
        let t99 = t79 * (damping * reference[26]);
        let t100 = t69 * t94 + t99;
        let t101 = t74 * t90;
        let t102 = t74 * t92 + reference[26] * t97;
        let t103 = t74 * t94 + reference[26] * t99 + damping * t85;
        let t104 = 0.5 * (t87 * (damping * 0.5));
        let t105 = damping * t89;
        let t106 = t79
            * (t47 + t49 * reference[26] - reference[1]
                + damping * (t48 + t50 * reference[26]));
        let t107 = t63 * t69 + t106;
        let t108 = t63 * t74 + reference[26] * t106
            + t85 * (t49 - reference[2] + damping * t50);
        let t109 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[3]
            + damping * (0.5 * (t51 + t51));
        let t110 = t89
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5] + damping * t52);
        let t111 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[4]
            + damping * (0.5 * (t53 + t53));
        let t112 = a_x * 2.0;
        let t113 = a_y * 2.0;
        let t114 = a_z * 2.0;
        let t115 = b_x * 2.0;
        let t116 = b_y * 2.0;
        let t117 = b_z * 2.0;
        let t118 = c_x * 2.0;
        let t119 = c_y * 2.0;
        let t120 = c_z * 2.0;
        let t121 = v_a_x * 2.0;
        let t122 = v_a_y * 2.0;
        let t123 = v_a_z * 2.0;
        let t124 = t67 * t112 + b_x * t72 + c_x * t77
            + (t91 * t121 + v_b_x * t93 + v_c_x * t95);
        let t125 = t67 * t113 + b_y * t72 + c_y * t77
            + (t91 * t122 + v_b_y * t93 + v_c_y * t95);
        let t126 = t67 * t114 + b_z * t72 + c_z * t77
            + (t91 * t123 + v_b_z * t93 + v_c_z * t95);
        let t127 = a_x * t72 + v_a_x * t93;
        let t128 = a_y * t72 + v_a_y * t93;
        let t129 = a_z * t72 + v_a_z * t93;
        let t130 = a_x * t77 + v_a_x * t95;
        let t131 = a_y * t77 + v_a_y * t95;
        let t132 = a_z * t77 + v_a_z * t95;
        let t133 = t78 * t112 + b_x * t80 + c_x * t82
            + (t96 * t121 + v_b_x * t98 + v_c_x * t100);
        let t134 = t78 * t113 + b_y * t80 + c_y * t82
            + (t96 * t122 + v_b_y * t98 + v_c_y * t100);
        let t135 = t78 * t114 + b_z * t80 + c_z * t82
            + (t96 * t123 + v_b_z * t98 + v_c_z * t100);
        let t136 = a_x * t80 + v_a_x * t98;
        let t137 = a_y * t80 + v_a_y * t98;
        let t138 = a_z * t80 + v_a_z * t98;
        let t139 = a_x * t82 + v_a_x * t100;
        let t140 = a_y * t82 + v_a_y * t100;
        let t141 = a_z * t82 + v_a_z * t100;
        let t142 = t83 * t112 + b_x * t84 + c_x * t86
            + (t101 * t121 + v_b_x * t102 + v_c_x * t103);
        let t143 = t83 * t113 + b_y * t84 + c_y * t86
            + (t101 * t122 + v_b_y * t102 + v_c_y * t103);
        let t144 = t83 * t114 + b_z * t84 + c_z * t86
            + (t101 * t123 + v_b_z * t102 + v_c_z * t103);
        let t145 = a_x * t84 + v_a_x * t102;
        let t146 = a_y * t84 + v_a_y * t102;
        let t147 = a_z * t84 + v_a_z * t102;
        let t148 = a_x * t86 + v_a_x * t103;
        let t149 = a_y * t86 + v_a_y * t103;
        let t150 = a_z * t86 + v_a_z * t103;
        let t151 = t88 * t115 + t104 * (v_b_x * 2.0);
        let t152 = t88 * t116 + t104 * (v_b_y * 2.0);
        let t153 = t88 * t117 + t104 * (v_b_z * 2.0);
        let t154 = c_x * t89 + v_c_x * t105;
        let t155 = c_y * t89 + v_c_y * t105;
        let t156 = c_z * t89 + v_c_z * t105;
        let t157 = b_x * t89 + v_b_x * t105;
        let t158 = b_y * t89 + v_b_y * t105;
        let t159 = b_z * t89 + v_b_z * t105;
        let t160 = t88 * t118 + t104 * (v_c_x * 2.0);
        let t161 = t88 * t119 + t104 * (v_c_y * 2.0);
        let t162 = t88 * t120 + t104 * (v_c_z * 2.0);
        let t163 = 2.0 * (t61 * t63);
        let t164 = 2.0 * (0.5 * (t87 * t109));
        let t165 = 2.0 * (0.5 * (t87 * t111));
        let t166 = t91 * t112 + b_x * t93 + c_x * t95;
        let t167 = t91 * t113 + b_y * t93 + c_y * t95;
        let t168 = t91 * t114 + b_z * t93 + c_z * t95;
        let t169 = a_x * t93;
        let t170 = a_y * t93;
        let t171 = a_z * t93;
        let t172 = a_x * t95;
        let t173 = a_y * t95;
        let t174 = a_z * t95;
        let t175 = t96 * t112 + b_x * t98 + c_x * t100;
        let t176 = t96 * t113 + b_y * t98 + c_y * t100;
        let t177 = t96 * t114 + b_z * t98 + c_z * t100;
        let t178 = a_x * t98;
        let t179 = a_y * t98;
        let t180 = a_z * t98;
        let t181 = a_x * t100;
        let t182 = a_y * t100;
        let t183 = a_z * t100;
        let t184 = t101 * t112 + b_x * t102 + c_x * t103;
        let t185 = t101 * t113 + b_y * t102 + c_y * t103;
        let t186 = t101 * t114 + b_z * t102 + c_z * t103;
        let t187 = a_x * t102;
        let t188 = a_y * t102;
        let t189 = a_z * t102;
        let t190 = a_x * t103;
        let t191 = a_y * t103;
        let t192 = a_z * t103;
        let t193 = t104 * t115;
        let t194 = t104 * t116;
        let t195 = t104 * t117;
        let t196 = c_x * t105;
        let t197 = c_y * t105;
        let t198 = c_z * t105;
        let t199 = b_x * t105;
        let t200 = b_y * t105;
        let t201 = b_z * t105;
        let t202 = t104 * t118;
        let t203 = t104 * t119;
        let t204 = t104 * t120;
        stiffness[0][0] = t112 * t124 + b_x * t133 + c_x * t142 + t163;
        stiffness[0][1] = t112 * t125 + b_x * t134 + c_x * t143;
        stiffness[0][2] = t112 * t126 + b_x * t135 + c_x * t144;
        stiffness[0][3] = t113 * t124 + b_y * t133 + c_y * t142;
        stiffness[0][4] = t113 * t125 + b_y * t134 + c_y * t143 + t163;
        stiffness[0][5] = t113 * t126 + b_y * t135 + c_y * t144;
        stiffness[0][6] = t114 * t124 + b_z * t133 + c_z * t142;
        stiffness[0][7] = t114 * t125 + b_z * t134 + c_z * t143;
        stiffness[0][8] = t114 * t126 + b_z * t135 + c_z * t144 + t163;
        stiffness[1][0] = t107 + (t112 * t127 + b_x * t136 + c_x * t145);
        stiffness[1][1] = t112 * t128 + b_x * t137 + c_x * t146;
        stiffness[1][2] = t112 * t129 + b_x * t138 + c_x * t147;
        stiffness[1][3] = t113 * t127 + b_y * t136 + c_y * t145;
        stiffness[1][4] = t107 + (t113 * t128 + b_y * t137 + c_y * t146);
        stiffness[1][5] = t113 * t129 + b_y * t138 + c_y * t147;
        stiffness[1][6] = t114 * t127 + b_z * t136 + c_z * t145;
        stiffness[1][7] = t114 * t128 + b_z * t137 + c_z * t146;
        stiffness[1][8] = t107 + (t114 * t129 + b_z * t138 + c_z * t147);
        stiffness[2][0] = t108 + (t112 * t130 + b_x * t139 + c_x * t148);
        stiffness[2][1] = t112 * t131 + b_x * t140 + c_x * t149;
        stiffness[2][2] = t112 * t132 + b_x * t141 + c_x * t150;
        stiffness[2][3] = t113 * t130 + b_y * t139 + c_y * t148;
        stiffness[2][4] = t108 + (t113 * t131 + b_y * t140 + c_y * t149);
        stiffness[2][5] = t113 * t132 + b_y * t141 + c_y * t150;
        stiffness[2][6] = t114 * t130 + b_z * t139 + c_z * t148;
        stiffness[2][7] = t114 * t131 + b_z * t140 + c_z * t149;
        stiffness[2][8] = t108 + (t114 * t132 + b_z * t141 + c_z * t150);
        stiffness[3][0] = t107 + a_x * t133;
        stiffness[3][1] = a_x * t134;
        stiffness[3][2] = a_x * t135;
        stiffness[3][3] = a_y * t133;
        stiffness[3][4] = t107 + a_y * t134;
        stiffness[3][5] = a_y * t135;
        stiffness[3][6] = a_z * t133;
        stiffness[3][7] = a_z * t134;
        stiffness[3][8] = t107 + a_z * t135;
        stiffness[4][0] = a_x * t136 + t115 * t151 + c_x * t154 + t164;
        stiffness[4][1] = a_x * t137 + t115 * t152 + c_x * t155;
        stiffness[4][2] = a_x * t138 + t115 * t153 + c_x * t156;
        stiffness[4][3] = a_y * t136 + t116 * t151 + c_y * t154;
        stiffness[4][4] = a_y * t137 + t116 * t152 + c_y * t155 + t164;
        stiffness[4][5] = a_y * t138 + t116 * t153 + c_y * t156;
        stiffness[4][6] = a_z * t136 + t117 * t151 + c_z * t154;
        stiffness[4][7] = a_z * t137 + t117 * t152 + c_z * t155;
        stiffness[4][8] = a_z * t138 + t117 * t153 + c_z * t156 + t164;
        stiffness[5][0] = t110 + (a_x * t139 + c_x * t157);
        stiffness[5][1] = a_x * t140 + c_x * t158;
        stiffness[5][2] = a_x * t141 + c_x * t159;
        stiffness[5][3] = a_y * t139 + c_y * t157;
        stiffness[5][4] = t110 + (a_y * t140 + c_y * t158);
        stiffness[5][5] = a_y * t141 + c_y * t159;
        stiffness[5][6] = a_z * t139 + c_z * t157;
        stiffness[5][7] = a_z * t140 + c_z * t158;
        stiffness[5][8] = t110 + (a_z * t141 + c_z * t159);
        stiffness[6][0] = t108 + a_x * t142;
        stiffness[6][1] = a_x * t143;
        stiffness[6][2] = a_x * t144;
        stiffness[6][3] = a_y * t142;
        stiffness[6][4] = t108 + a_y * t143;
        stiffness[6][5] = a_y * t144;
        stiffness[6][6] = a_z * t142;
        stiffness[6][7] = a_z * t143;
        stiffness[6][8] = t108 + a_z * t144;
        stiffness[7][0] = t110 + (a_x * t145 + b_x * t154);
        stiffness[7][1] = a_x * t146 + b_x * t155;
        stiffness[7][2] = a_x * t147 + b_x * t156;
        stiffness[7][3] = a_y * t145 + b_y * t154;
        stiffness[7][4] = t110 + (a_y * t146 + b_y * t155);
        stiffness[7][5] = a_y * t147 + b_y * t156;
        stiffness[7][6] = a_z * t145 + b_z * t154;
        stiffness[7][7] = a_z * t146 + b_z * t155;
        stiffness[7][8] = t110 + (a_z * t147 + b_z * t156);
        stiffness[8][0] = a_x * t148 + b_x * t157 + t118 * t160 + t165;
        stiffness[8][1] = a_x * t149 + b_x * t158 + t118 * t161;
        stiffness[8][2] = a_x * t150 + b_x * t159 + t118 * t162;
        stiffness[8][3] = a_y * t148 + b_y * t157 + t119 * t160;
        stiffness[8][4] = a_y * t149 + b_y * t158 + t119 * t161 + t165;
        stiffness[8][5] = a_y * t150 + b_y * t159 + t119 * t162;
        stiffness[8][6] = a_z * t148 + b_z * t157 + t120 * t160;
        stiffness[8][7] = a_z * t149 + b_z * t158 + t120 * t161;
        stiffness[8][8] = a_z * t150 + b_z * t159 + t120 * t162 + t165;
        damping_matrix[0][0] = t112 * t166 + b_x * t175 + c_x * t184;
        damping_matrix[0][1] = t112 * t167 + b_x * t176 + c_x * t185;
        damping_matrix[0][2] = t112 * t168 + b_x * t177 + c_x * t186;
        damping_matrix[0][3] = t113 * t166 + b_y * t175 + c_y * t184;
        damping_matrix[0][4] = t113 * t167 + b_y * t176 + c_y * t185;
        damping_matrix[0][5] = t113 * t168 + b_y * t177 + c_y * t186;
        damping_matrix[0][6] = t114 * t166 + b_z * t175 + c_z * t184;
        damping_matrix[0][7] = t114 * t167 + b_z * t176 + c_z * t185;
        damping_matrix[0][8] = t114 * t168 + b_z * t177 + c_z * t186;
        damping_matrix[1][0] = t112 * t169 + b_x * t178 + c_x * t187;
        damping_matrix[1][1] = t112 * t170 + b_x * t179 + c_x * t188;
        damping_matrix[1][2] = t112 * t171 + b_x * t180 + c_x * t189;
        damping_matrix[1][3] = t113 * t169 + b_y * t178 + c_y * t187;
        damping_matrix[1][4] = t113 * t170 + b_y * t179 + c_y * t188;
        damping_matrix[1][5] = t113 * t171 + b_y * t180 + c_y * t189;
        damping_matrix[1][6] = t114 * t169 + b_z * t178 + c_z * t187;
        damping_matrix[1][7] = t114 * t170 + b_z * t179 + c_z * t188;
        damping_matrix[1][8] = t114 * t171 + b_z * t180 + c_z * t189;
        damping_matrix[2][0] = t112 * t172 + b_x * t181 + c_x * t190;
        damping_matrix[2][1] = t112 * t173 + b_x * t182 + c_x * t191;
        damping_matrix[2][2] = t112 * t174 + b_x * t183 + c_x * t192;
        damping_matrix[2][3] = t113 * t172 + b_y * t181 + c_y * t190;
        damping_matrix[2][4] = t113 * t173 + b_y * t182 + c_y * t191;
        damping_matrix[2][5] = t113 * t174 + b_y * t183 + c_y * t192;
        damping_matrix[2][6] = t114 * t172 + b_z * t181 + c_z * t190;
        damping_matrix[2][7] = t114 * t173 + b_z * t182 + c_z * t191;
        damping_matrix[2][8] = t114 * t174 + b_z * t183 + c_z * t192;
        damping_matrix[3][0] = a_x * t178 + t115 * t193 + c_x * t196;
        damping_matrix[3][1] = a_x * t179 + t115 * t194 + c_x * t197;
        damping_matrix[3][2] = a_x * t180 + t115 * t195 + c_x * t198;
        damping_matrix[3][3] = a_y * t178 + t116 * t193 + c_y * t196;
        damping_matrix[3][4] = a_y * t179 + t116 * t194 + c_y * t197;
        damping_matrix[3][5] = a_y * t180 + t116 * t195 + c_y * t198;
        damping_matrix[3][6] = a_z * t178 + t117 * t193 + c_z * t196;
        damping_matrix[3][7] = a_z * t179 + t117 * t194 + c_z * t197;
        damping_matrix[3][8] = a_z * t180 + t117 * t195 + c_z * t198;
        damping_matrix[4][0] = a_x * t181 + c_x * t199;
        damping_matrix[4][1] = a_x * t182 + c_x * t200;
        damping_matrix[4][2] = a_x * t183 + c_x * t201;
        damping_matrix[4][3] = a_y * t181 + c_y * t199;
        damping_matrix[4][4] = a_y * t182 + c_y * t200;
        damping_matrix[4][5] = a_y * t183 + c_y * t201;
        damping_matrix[4][6] = a_z * t181 + c_z * t199;
        damping_matrix[4][7] = a_z * t182 + c_z * t200;
        damping_matrix[4][8] = a_z * t183 + c_z * t201;
        damping_matrix[5][0] = a_x * t190 + b_x * t199 + t118 * t202;
        damping_matrix[5][1] = a_x * t191 + b_x * t200 + t118 * t203;
        damping_matrix[5][2] = a_x * t192 + b_x * t201 + t118 * t204;
        damping_matrix[5][3] = a_y * t190 + b_y * t199 + t119 * t202;
        damping_matrix[5][4] = a_y * t191 + b_y * t200 + t119 * t203;
        damping_matrix[5][5] = a_y * t192 + b_y * t201 + t119 * t204;
        damping_matrix[5][6] = a_z * t190 + b_z * t199 + t120 * t202;
        damping_matrix[5][7] = a_z * t191 + b_z * t200 + t120 * t203;
        damping_matrix[5][8] = a_z * t192 + b_z * t201 + t120 * t204;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 31 additions, 47 multiplications, 1 function calls.
    pub fn full_beam_spatial_curved_damped_points3_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t36 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t37 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t38 = a_x * a_x + a_y * a_y + a_z * a_z - (t36 * t36 + t37 * t37);
        let t39 = 0.5 * (length * reference[27]);
        let t40 = (t38.sqrt() - 1.0 + t36 * reference[21] + t37 * reference[25]
            - reference[0])
            .powi(2) * (0.5 * (length * reference[9]));
        let t41 = t40
            + (t36 + t37 * reference[26] - reference[1]).powi(2)
                * (0.5 * (length * reference[10]))
            + (t37 - reference[2]).powi(2) * (0.5 * (length * reference[11]));
        let t42 = (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[3])
            .powi(2);
        let t43 = (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[4])
            .powi(2);
        let t44 = (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]).powi(2)
            * (0.5 * (length * reference[28]));
        *energy = t41 + t39 * t42 + t39 * t43 + t44;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 and 3 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 1211 additions, 1557 multiplications, 37 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_elastic_force(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 155],
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
                    ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
                    ::rncf::emitted::array(&reference[62 + 31 * point..][..31]),
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
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 and 3 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 17416 additions, 20537 multiplications, 140 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_elastic_tangent(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 155],
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
                    ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
                    ::rncf::emitted::array(&reference[62 + 31 * point..][..31]),
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
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 and 3 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 381 additions, 485 multiplications, 6 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_strain_energy(
        row: &FullBeamSpatialCurvedDamped,
        reference: &[f64; 155],
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
                            ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
                            ::rncf::emitted::array(&reference[62 + 31 * point..][..31]),
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
    /// Operations: 255 additions, 337 multiplications, 5 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_damped_reference(
        row: &FullBeamSpatialCurvedDamped,
        q: &[f64; 30],
        reference: &mut [f64; 155],
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
        let t103 = t86 * t98 + t87 * t99 + t88 * t100;
        let t104 = t92 * t95 + t93 * t96 + t94 * t97;
        let t105 = t80 * t80 + t81 * t81 + t82 * t82 - (t101 * t101 + t102 * t102);
        let t106 = t105.sqrt();
        let t107 = t106 - 1.0;
        let t108 = 0.5 * (t104 - t103);
        let t109 = 1.0 - 0.5 * (t86 * t86 + t87 * t87 + t88 * t88 - 1.0);
        let t110 = 1.0 - 0.5 * (t92 * t92 + t93 * t93 + t94 * t94 - 1.0);
        let t111 = t110 * ((t80 * t98 + t81 * t99 + t82 * t100 + t101 * t108) / t106);
        let t112 = t109 * ((t80 * t95 + t81 * t96 + t82 * t97 - t102 * t108) / t106);
        let t113 = t108 * (t109 * t110) + reference[12] * t111 - reference[13] * t112
            + reference[15] * t107 + t101 * reference[18];
        let t114 = r0x_x * (-0.2886751345948131) + d_x * 1.0000000000000004
            + r1x_x * 0.28867513459481264;
        let t115 = r0x_y * (-0.2886751345948131) + d_y * 1.0000000000000004
            + r1x_y * 0.28867513459481264;
        let t116 = r0x_z * (-0.2886751345948131) + d_z * 1.0000000000000004
            + r1x_z * 0.28867513459481264;
        let t117 = t83 + r0y_x * (-0.12200846792814612) + r1y_x * 0.4553418012614795;
        let t118 = t84 + r0y_y * (-0.12200846792814612) + r1y_y * 0.4553418012614795;
        let t119 = t85 + r0y_z * (-0.12200846792814612) + r1y_z * 0.4553418012614795;
        let t120 = t89 + r0z_x * (-0.12200846792814612) + r1z_x * 0.4553418012614795;
        let t121 = t90 + r0z_y * (-0.12200846792814612) + r1z_y * 0.4553418012614795;
        let t122 = t91 + r0z_z * (-0.12200846792814612) + r1z_z * 0.4553418012614795;
        let t123 = inverse_length
            * (r0y_x * 0.15470053837925146 + ry_half_x * (-2.309401076758503)
                + r1y_x * 2.1547005383792515);
        let t124 = inverse_length
            * (r0y_y * 0.15470053837925146 + ry_half_y * (-2.309401076758503)
                + r1y_y * 2.1547005383792515);
        let t125 = inverse_length
            * (r0y_z * 0.15470053837925146 + ry_half_z * (-2.309401076758503)
                + r1y_z * 2.1547005383792515);
        let t126 = inverse_length
            * (r0z_x * 0.15470053837925146 + rz_half_x * (-2.309401076758503)
                + r1z_x * 2.1547005383792515);
        let t127 = inverse_length
            * (r0z_y * 0.15470053837925146 + rz_half_y * (-2.309401076758503)
                + r1z_y * 2.1547005383792515);
        let t128 = inverse_length
            * (r0z_z * 0.15470053837925146 + rz_half_z * (-2.309401076758503)
                + r1z_z * 2.1547005383792515);
        let t129 = t114 * t117 + t115 * t118 + t116 * t119;
        let t130 = t114 * t120 + t115 * t121 + t116 * t122;
        let t131 = t117 * t126 + t118 * t127 + t119 * t128;
        let t132 = t120 * t123 + t121 * t124 + t122 * t125;
        let t133 = t114 * t114 + t115 * t115 + t116 * t116 - (t129 * t129 + t130 * t130);
        let t134 = t133.sqrt();
        let t135 = t134 - 1.0;
        let t136 = 0.5 * (t132 - t131);
        let t137 = 1.0 - 0.5 * (t117 * t117 + t118 * t118 + t119 * t119 - 1.0);
        let t138 = 1.0 - 0.5 * (t120 * t120 + t121 * t121 + t122 * t122 - 1.0);
        let t139 = t138
            * ((t114 * t126 + t115 * t127 + t116 * t128 + t129 * t136) / t134);
        let t140 = t137
            * ((t114 * t123 + t115 * t124 + t116 * t125 - t130 * t136) / t134);
        let t141 = t136 * (t137 * t138) + reference[43] * t139 - reference[44] * t140
            + reference[46] * t135 + t129 * reference[49];
        let t142 = d_x * 0.6;
        let t143 = d_y * 0.6;
        let t144 = d_z * 0.6;
        let t145 = r0x_x * 0.5872983346207417 + t142 + r1x_x * (-0.18729833462074166);
        let t146 = r0x_y * 0.5872983346207417 + t143 + r1x_y * (-0.18729833462074166);
        let t147 = r0x_z * 0.5872983346207417 + t144 + r1x_z * (-0.18729833462074166);
        let t148 = ry_half_x * 0.39999999999999997;
        let t149 = ry_half_y * 0.39999999999999997;
        let t150 = ry_half_z * 0.39999999999999997;
        let t151 = r0y_x * 0.6872983346207417 + t148 + r1y_x * (-0.08729833462074169);
        let t152 = r0y_y * 0.6872983346207417 + t149 + r1y_y * (-0.08729833462074169);
        let t153 = r0y_z * 0.6872983346207417 + t150 + r1y_z * (-0.08729833462074169);
        let t154 = rz_half_x * 0.39999999999999997;
        let t155 = rz_half_y * 0.39999999999999997;
        let t156 = rz_half_z * 0.39999999999999997;
        let t157 = r0z_x * 0.6872983346207417 + t154 + r1z_x * (-0.08729833462074169);
        let t158 = r0z_y * 0.6872983346207417 + t155 + r1z_y * (-0.08729833462074169);
        let t159 = r0z_z * 0.6872983346207417 + t156 + r1z_z * (-0.08729833462074169);
        let t160 = t145 * t151 + t146 * t152 + t147 * t153;
        let t161 = t145 * t157 + t146 * t158 + t147 * t159;
        let t162 = t145 * t145 + t146 * t146 + t147 * t147 - (t160 * t160 + t161 * t161);
        let t163 = r0x_x * (-0.25) + d_x * 1.5 + r1x_x * (-0.25);
        let t164 = r0x_y * (-0.25) + d_y * 1.5 + r1x_y * (-0.25);
        let t165 = r0x_z * (-0.25) + d_z * 1.5 + r1x_z * (-0.25);
        let t166 = ry_half_x * t163 + ry_half_y * t164 + ry_half_z * t165;
        let t167 = rz_half_x * t163 + rz_half_y * t164 + rz_half_z * t165;
        let t168 = t163 * t163 + t164 * t164 + t165 * t165 - (t166 * t166 + t167 * t167);
        let t169 = t142 + r0x_x * (-0.18729833462074175) + r1x_x * 0.5872983346207418;
        let t170 = t143 + r0x_y * (-0.18729833462074175) + r1x_y * 0.5872983346207418;
        let t171 = t144 + r0x_z * (-0.18729833462074175) + r1x_z * 0.5872983346207418;
        let t172 = t148 + r0y_x * (-0.08729833462074166) + r1y_x * 0.6872983346207417;
        let t173 = t149 + r0y_y * (-0.08729833462074166) + r1y_y * 0.6872983346207417;
        let t174 = t150 + r0y_z * (-0.08729833462074166) + r1y_z * 0.6872983346207417;
        let t175 = t154 + r0z_x * (-0.08729833462074166) + r1z_x * 0.6872983346207417;
        let t176 = t155 + r0z_y * (-0.08729833462074166) + r1z_y * 0.6872983346207417;
        let t177 = t156 + r0z_z * (-0.08729833462074166) + r1z_z * 0.6872983346207417;
        let t178 = t169 * t172 + t170 * t173 + t171 * t174;
        let t179 = t169 * t175 + t170 * t176 + t171 * t177;
        let t180 = t169 * t169 + t170 * t170 + t171 * t171 - (t178 * t178 + t179 * t179);
        reference[0] = t113 + t102 * reference[22];
        reference[1] = t111 - reference[14] * t112 + reference[16] * t107
            + t101 * reference[19] + t102 * reference[23];
        reference[2] = reference[17] * t107 - t112 + t101 * reference[20]
            + t102 * reference[24];
        reference[3] = t86 * t95 + t87 * t96 + t88 * t97;
        reference[4] = t92 * t98 + t93 * t99 + t94 * t100;
        reference[5] = t103 + t104;
        reference[31] = t141 + t130 * reference[53];
        reference[32] = t139 - reference[45] * t140 + reference[47] * t135
            + t129 * reference[50] + t130 * reference[54];
        reference[33] = reference[48] * t135 - t140 + t129 * reference[51]
            + t130 * reference[55];
        reference[34] = t117 * t123 + t118 * t124 + t119 * t125;
        reference[35] = t120 * t126 + t121 * t127 + t122 * t128;
        reference[36] = t131 + t132;
        reference[62] = t162.sqrt() - 1.0 + t160 * reference[83] + t161 * reference[87];
        reference[63] = t160 + t161 * reference[88];
        reference[64] = t161;
        reference[65] = 0.5 * (t151 * t151 + t152 * t152 + t153 * t153 - 1.0);
        reference[66] = 0.5 * (t157 * t157 + t158 * t158 + t159 * t159 - 1.0);
        reference[67] = t151 * t157 + t152 * t158 + t153 * t159;
        reference[93] = t168.sqrt() - 1.0 + t166 * reference[114]
            + t167 * reference[118];
        reference[94] = t166 + t167 * reference[119];
        reference[95] = t167;
        reference[96] = 0.5
            * (ry_half_x * ry_half_x + ry_half_y * ry_half_y + ry_half_z * ry_half_z
                - 1.0);
        reference[97] = 0.5
            * (rz_half_x * rz_half_x + rz_half_y * rz_half_y + rz_half_z * rz_half_z
                - 1.0);
        reference[98] = ry_half_x * rz_half_x + ry_half_y * rz_half_y
            + ry_half_z * rz_half_z;
        reference[124] = t180.sqrt() - 1.0 + t178 * reference[145]
            + t179 * reference[149];
        reference[125] = t178 + t179 * reference[150];
        reference[126] = t179;
        reference[127] = 0.5 * (t172 * t172 + t173 * t173 + t174 * t174 - 1.0);
        reference[128] = 0.5 * (t175 * t175 + t176 * t176 + t177 * t177 - 1.0);
        reference[129] = t172 * t175 + t173 * t176 + t174 * t177;
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
    /// Operations: 468 additions, 639 multiplications, 37 divisions, 2 function calls.
    pub fn full_beam_spatial_curved_damped_field_forces(
        row: &FullBeamSpatialCurvedDamped,
        coefficients: &[f64; 25],
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        rates: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let FullBeamSpatialCurvedDamped { length, damping, .. } = *row;
        let [D1, D2, D3, D4, D5, D6, L21, L31, L32, L41, L42, L43, L51, L52, L53, L54,
        L61, L62, L63, L64, L65, held, half_held, smooth, half_smooth] = *coefficients;
        let t83 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t84 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8];
        let t85 = fields[3] * fields[12] + fields[4] * fields[13]
            + fields[5] * fields[14];
        let t86 = fields[6] * fields[9] + fields[7] * fields[10]
            + fields[8] * fields[11];
        let t87 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0);
        let t88 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0);
        let t89 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
            - (t83 * t83 + t84 * t84);
        let t90 = t89.sqrt();
        let t91 = t90 - 1.0;
        let t92 = 0.5 * (t86 - t85);
        let t93 = 1.0 - t87;
        let t94 = 1.0 - t88;
        let t95 = t93 * t94;
        let t96 = (fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14] + t83 * t92) / t90;
        let t97 = t94 * t96;
        let t98 = (fields[0] * fields[9] + fields[1] * fields[10]
            + fields[2] * fields[11] - t84 * t92) / t90;
        let t99 = t93 * t98;
        let t100 = t92 * t95 + t97 * L21 - t99 * L31 + t91 * L41 + t83 * L51;
        let t101 = stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
            + stress_free[2] * stress_free[5];
        let t102 = stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
            + stress_free[2] * stress_free[8];
        let t103 = stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
            + stress_free[5] * stress_free[14];
        let t104 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11];
        let t105 = 0.5
            * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                + stress_free[5] * stress_free[5] - 1.0);
        let t106 = 0.5
            * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                + stress_free[8] * stress_free[8] - 1.0);
        let t107 = stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
            + stress_free[2] * stress_free[2] - (t101 * t101 + t102 * t102);
        let t108 = t107.sqrt();
        let t109 = t108 - 1.0;
        let t110 = 0.5 * (t104 - t103);
        let t111 = 1.0 - t105;
        let t112 = 1.0 - t106;
        let t113 = t112
            * ((stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14] + t101 * t110) / t108);
        let t114 = t111
            * ((stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11] - t102 * t110) / t108);
        let t115 = t110 * (t111 * t112) + L21 * t113 - L31 * t114 + L41 * t109
            + L51 * t101;
        let t116 = fields[0] * 2.0;
        let t117 = fields[1] * 2.0;
        let t118 = fields[2] * 2.0;
        let t119 = fields[3] * rates[0] + fields[0] * rates[3]
            + (fields[4] * rates[1] + fields[1] * rates[4])
            + (fields[5] * rates[2] + fields[2] * rates[5]);
        let t120 = fields[6] * rates[0] + fields[0] * rates[6]
            + (fields[7] * rates[1] + fields[1] * rates[7])
            + (fields[8] * rates[2] + fields[2] * rates[8]);
        let t121 = fields[9] * rates[0] + fields[0] * rates[9]
            + (fields[10] * rates[1] + fields[1] * rates[10])
            + (fields[11] * rates[2] + fields[2] * rates[11]);
        let t122 = fields[12] * rates[0] + fields[0] * rates[12]
            + (fields[13] * rates[1] + fields[1] * rates[13])
            + (fields[14] * rates[2] + fields[2] * rates[14]);
        let t123 = fields[3] * 2.0;
        let t124 = fields[4] * 2.0;
        let t125 = fields[5] * 2.0;
        let t126 = fields[12] * rates[3] + fields[3] * rates[12]
            + (fields[13] * rates[4] + fields[4] * rates[13])
            + (fields[14] * rates[5] + fields[5] * rates[14]);
        let t127 = fields[6] * 2.0;
        let t128 = fields[7] * 2.0;
        let t129 = fields[8] * 2.0;
        let t130 = fields[9] * rates[6] + fields[6] * rates[9]
            + (fields[10] * rates[7] + fields[7] * rates[10])
            + (fields[11] * rates[8] + fields[8] * rates[11]);
        let t131 = 0.5 * (rates[3] * t123 + rates[4] * t124 + rates[5] * t125);
        let t132 = 0.5 * (rates[6] * t127 + rates[7] * t128 + rates[8] * t129);
        let t133 = t83 * 2.0;
        let t134 = t84 * 2.0;
        let t135 = rates[0] * t116 + rates[1] * t117 + rates[2] * t118
            - (t119 * t133 + t120 * t134);
        let t136 = 1.0 / (t90 * 2.0);
        let t137 = t135 * t136;
        let t138 = 0.5 * (t130 - t126);
        let t139 = t94 * ((t122 + (t92 * t119 + t83 * t138) - t96 * t137) / t90)
            - t96 * t132;
        let t140 = t93 * ((t121 - (t92 * t120 + t84 * t138) - t98 * t137) / t90)
            - t98 * t131;
        let t141 = t95 * t138 - t92 * (t94 * t131 + t93 * t132) + L21 * t139
            - L31 * t140;
        let t142 = t100 + t84 * L61 - (t115 + L61 * t102)
            + damping * (t141 + L41 * t137 + L51 * t119 + L61 * t120);
        let t143 = D1 * t142;
        let t144 = t136 * (t116 - (fields[3] * t133 + fields[6] * t134));
        let t145 = t94 * ((fields[12] + fields[3] * t92 - t96 * t144) / t90);
        let t146 = t93 * ((fields[9] - fields[6] * t92 - t98 * t144) / t90);
        let t147 = L21 * t145 - L31 * t146 + L41 * t144 + fields[3] * L51
            + fields[6] * L61;
        let t148 = t136 * (t117 - (fields[4] * t133 + fields[7] * t134));
        let t149 = t94 * ((fields[13] + fields[4] * t92 - t96 * t148) / t90);
        let t150 = t93 * ((fields[10] - fields[7] * t92 - t98 * t148) / t90);
        let t151 = L21 * t149 - L31 * t150 + L41 * t148 + fields[4] * L51
            + fields[7] * L61;
        let t152 = t136 * (t118 - (fields[5] * t133 + fields[8] * t134));
        let t153 = t94 * ((fields[14] + fields[5] * t92 - t96 * t152) / t90);
        let t154 = t93 * ((fields[11] - fields[8] * t92 - t98 * t152) / t90);
        let t155 = L21 * t153 - L31 * t154 + L41 * t152 + fields[5] * L51
            + fields[8] * L61;
        let t156 = 0.5 * t123;
        let t157 = t136 * (fields[0] * t133);
        let t158 = fields[12] * 0.5;
        let t159 = fields[0] * t92;
        let t160 = t94 * ((t159 - t83 * t158 + t96 * t157) / t90);
        let t161 = t93 * ((t84 * t158 + t98 * t157) / t90) - t98 * t156;
        let t162 = L21 * t160 - (t95 * t158 + t92 * (t94 * t156)) - L31 * t161
            - L41 * t157;
        let t163 = 0.5 * t124;
        let t164 = t136 * (fields[1] * t133);
        let t165 = fields[13] * 0.5;
        let t166 = fields[1] * t92;
        let t167 = t94 * ((t166 - t83 * t165 + t96 * t164) / t90);
        let t168 = t93 * ((t84 * t165 + t98 * t164) / t90) - t98 * t163;
        let t169 = L21 * t167 - (t95 * t165 + t92 * (t94 * t163)) - L31 * t168
            - L41 * t164;
        let t170 = 0.5 * t125;
        let t171 = t136 * (fields[2] * t133);
        let t172 = fields[14] * 0.5;
        let t173 = fields[2] * t92;
        let t174 = t94 * ((t173 - t83 * t172 + t96 * t171) / t90);
        let t175 = t93 * ((t84 * t172 + t98 * t171) / t90) - t98 * t170;
        let t176 = L21 * t174 - (t95 * t172 + t92 * (t94 * t170)) - L31 * t175
            - L41 * t171;
        let t177 = 0.5 * t127;
        let t178 = t136 * (fields[0] * t134);
        let t179 = fields[9] * 0.5;
        let t180 = t94 * ((t83 * t179 + t96 * t178) / t90) - t96 * t177;
        let t181 = t93 * ((t98 * t178 - (t159 + t84 * t179)) / t90);
        let t182 = t95 * t179 - t92 * (t93 * t177) + L21 * t180 - L31 * t181
            - L41 * t178;
        let t183 = 0.5 * t128;
        let t184 = t136 * (fields[1] * t134);
        let t185 = fields[10] * 0.5;
        let t186 = t94 * ((t83 * t185 + t96 * t184) / t90) - t96 * t183;
        let t187 = t93 * ((t98 * t184 - (t166 + t84 * t185)) / t90);
        let t188 = t95 * t185 - t92 * (t93 * t183) + L21 * t186 - L31 * t187
            - L41 * t184;
        let t189 = 0.5 * t129;
        let t190 = t136 * (fields[2] * t134);
        let t191 = fields[11] * 0.5;
        let t192 = t94 * ((t83 * t191 + t96 * t190) / t90) - t96 * t189;
        let t193 = t93 * ((t98 * t190 - (t173 + t84 * t191)) / t90);
        let t194 = t95 * t191 - t92 * (t93 * t189) + L21 * t192 - L31 * t193
            - L41 * t190;
        let t195 = fields[6] * 0.5;
        let t196 = t94 * (t83 * t195 / t90);
        let t197 = t93 * ((fields[0] - t84 * t195) / t90);
        let t198 = fields[7] * 0.5;
        let t199 = t94 * (t83 * t198 / t90);
        let t200 = t93 * ((fields[1] - t84 * t198) / t90);
        let t201 = fields[8] * 0.5;
        let t202 = t94 * (t83 * t201 / t90);
        let t203 = t93 * ((fields[2] - t84 * t201) / t90);
        let t204 = fields[3] * 0.5;
        let t205 = t94 * ((fields[0] - t83 * t204) / t90);
        let t206 = t93 * (t84 * t204 / t90);
        let t207 = fields[4] * 0.5;
        let t208 = t94 * ((fields[1] - t83 * t207) / t90);
        let t209 = t93 * (t84 * t207 / t90);
        let t210 = fields[5] * 0.5;
        let t211 = t94 * ((fields[2] - t83 * t210) / t90);
        let t212 = t93 * (t84 * t210 / t90);
        let t213 = t97 - t99 * L32 + t91 * L42 + t83 * L52 + t84 * L62
            - (t113 - L32 * t114 + L42 * t109 + L52 * t101 + L62 * t102);
        let t214 = damping * (t139 - L32 * t140 + L42 * t137 + L52 * t119 + L62 * t120);
        let t215 = D2 * (t213 + t214);
        let t216 = t215
            * (t145 - L32 * t146 + L42 * t144 + fields[3] * L52 + fields[6] * L62);
        let t217 = t215
            * (t149 - L32 * t150 + L42 * t148 + fields[4] * L52 + fields[7] * L62);
        let t218 = t215
            * (t153 - L32 * t154 + L42 * t152 + fields[5] * L52 + fields[8] * L62);
        let t219 = t143 * (t162 + fields[0] * L51)
            + t215 * (t160 - L32 * t161 - L42 * t157 + fields[0] * L52);
        let t220 = t143 * (t169 + fields[1] * L51)
            + t215 * (t167 - L32 * t168 - L42 * t164 + fields[1] * L52);
        let t221 = t143 * (t176 + fields[2] * L51)
            + t215 * (t174 - L32 * t175 - L42 * t171 + fields[2] * L52);
        let t222 = t143 * (t182 + fields[0] * L61)
            + t215 * (t180 - L32 * t181 - L42 * t178 + fields[0] * L62);
        let t223 = t143 * (t188 + fields[1] * L61)
            + t215 * (t186 - L32 * t187 - L42 * t184 + fields[1] * L62);
        let t224 = t143 * (t194 + fields[2] * L61)
            + t215 * (t192 - L32 * t193 - L42 * t190 + fields[2] * L62);
        let t225 = t143 * (t95 * t195 + L21 * t196 - L31 * t197)
            + t215 * (t196 - L32 * t197);
        let t226 = t143 * (t95 * t198 + L21 * t199 - L31 * t200)
            + t215 * (t199 - L32 * t200);
        let t227 = t143 * (t95 * t201 + L21 * t202 - L31 * t203)
            + t215 * (t202 - L32 * t203);
        let t228 = t143 * (L21 * t205 - t95 * t204 - L31 * t206)
            + t215 * (t205 - L32 * t206);
        let t229 = t143 * (L21 * t208 - t95 * t207 - L31 * t209)
            + t215 * (t208 - L32 * t209);
        let t230 = t143 * (L21 * t211 - t95 * t210 - L31 * t212)
            + t215 * (t211 - L32 * t212);
        let t231 = t91 * L43 - t99 + t83 * L53 + t84 * L63
            - (L43 * t109 - t114 + L53 * t101 + L63 * t102);
        let t232 = D3 * (t231 + damping * (L43 * t137 - t140 + L53 * t119 + L63 * t120));
        let t233 = t143 * t147 + t216
            + t232 * (L43 * t144 - t146 + fields[3] * L53 + fields[6] * L63);
        let t234 = t143 * t151 + t217
            + t232 * (L43 * t148 - t150 + fields[4] * L53 + fields[7] * L63);
        let t235 = t143 * t155 + t218
            + t232 * (L43 * t152 - t154 + fields[5] * L53 + fields[8] * L63);
        let t236 = t91 + t83 * L54 + t84 * L64 - (t109 + L54 * t101 + L64 * t102);
        let t237 = D4 * (t236 + damping * (t137 + L54 * t119 + L64 * t120));
        let t238 = t219 + t232 * (fields[0] * L53 - (t161 + L43 * t157))
            + t237 * (fields[0] * L54 - t157);
        let t239 = t220 + t232 * (fields[1] * L53 - (t168 + L43 * t164))
            + t237 * (fields[1] * L54 - t164);
        let t240 = t221 + t232 * (fields[2] * L53 - (t175 + L43 * t171))
            + t237 * (fields[2] * L54 - t171);
        let t241 = t222 + t232 * (fields[0] * L63 - (t181 + L43 * t178))
            + t237 * (fields[0] * L64 - t178);
        let t242 = t223 + t232 * (fields[1] * L63 - (t187 + L43 * t184))
            + t237 * (fields[1] * L64 - t184);
        let t243 = t224 + t232 * (fields[2] * L63 - (t193 + L43 * t190))
            + t237 * (fields[2] * L64 - t190);
        let t244 = t83 + t84 * L65 - (t101 + L65 * t102) + damping * (t119 + L65 * t120);
        let t245 = D5 * t244;
        let t246 = t233 + t237 * (t144 + fields[3] * L54 + fields[6] * L64)
            + t245 * (fields[3] + fields[6] * L65);
        let t247 = t234 + t237 * (t148 + fields[4] * L54 + fields[7] * L64)
            + t245 * (fields[4] + fields[7] * L65);
        let t248 = t235 + t237 * (t152 + fields[5] * L54 + fields[8] * L64)
            + t245 * (fields[5] + fields[8] * L65);
        let t249 = D6 * (t84 - t102 + damping * t120);
        let t250 = held * (t87 - t105 + damping * t131);
        let t251 = held * (t88 - t106 + damping * t132);
        let t252 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t253 = fields[6] * rates[3] + fields[3] * rates[6]
            + (fields[7] * rates[4] + fields[4] * rates[7])
            + (fields[8] * rates[5] + fields[5] * rates[8]);
        let t254 = half_held * (t252 + damping * t253);
        let t255 = t241 + t245 * (fields[0] * L65) + fields[0] * t249 + t177 * t251
            + fields[3] * t254;
        let t256 = t242 + t245 * (fields[1] * L65) + fields[1] * t249 + t183 * t251
            + fields[4] * t254;
        let t257 = t243 + t245 * (fields[2] * L65) + fields[2] * t249 + t189 * t251
            + fields[5] * t254;
        let t258 = fields[3] * fields[9] + fields[4] * fields[10]
            + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t259 = fields[9] * rates[3] + fields[3] * rates[9]
            + (fields[10] * rates[4] + fields[4] * rates[10])
            + (fields[11] * rates[5] + fields[5] * rates[11]);
        let t260 = smooth * (t258 + damping * t259);
        let t261 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t262 = fields[12] * rates[6] + fields[6] * rates[12]
            + (fields[13] * rates[7] + fields[7] * rates[13])
            + (fields[14] * rates[8] + fields[8] * rates[14]);
        let t263 = smooth * (t261 + damping * t262);
        let t264 = half_smooth * (t85 + t86 - (t103 + t104) + damping * (t126 + t130));
        let t265 = t238 + fields[0] * t245 + t156 * t250 + fields[6] * t254
            + fields[9] * t260 + fields[12] * t264;
        let t266 = t239 + fields[1] * t245 + t163 * t250 + fields[7] * t254
            + fields[10] * t260 + fields[13] * t264;
        let t267 = t240 + fields[2] * t245 + t170 * t250 + fields[8] * t254
            + fields[11] * t260 + fields[14] * t264;
        forces[0] = t246 + fields[6] * t249;
        forces[1] = t247 + fields[7] * t249;
        forces[2] = t248 + fields[8] * t249;
        forces[3] = t265;
        forces[4] = t266;
        forces[5] = t267;
        forces[6] = t255 + fields[12] * t263 + fields[9] * t264;
        forces[7] = t256 + fields[13] * t263 + fields[10] * t264;
        forces[8] = t257 + fields[14] * t263 + fields[11] * t264;
        forces[9] = t225 - t197 * t232 + fields[3] * t260 + fields[6] * t264;
        forces[10] = t226 - t200 * t232 + fields[4] * t260 + fields[7] * t264;
        forces[11] = t227 - t203 * t232 + fields[5] * t260 + fields[8] * t264;
        forces[12] = t228 - t206 * t232 + fields[6] * t263 + fields[3] * t264;
        forces[13] = t229 - t209 * t232 + fields[7] * t263 + fields[4] * t264;
        forces[14] = t230 - t212 * t232 + fields[8] * t263 + fields[5] * t264;
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
    ) -> ::std::result::Result<([f64; 25], [f64; 6]), ::rncf::ModelError> {
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
        pub reference_blade: ::std::vec::Vec<[f64; 155]>,
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
                let mut reference = [0.0; 155];
                for (place, xi) in [
                    (6, 0.21132486540518713),
                    (37, 0.7886751345948129),
                    (68, 0.1127016653792583),
                    (99, 0.5),
                    (130, 0.8872983346207417),
                ] {
                    let (coefficients, _) = at(nodes[0] + xi * row.length)?;
                    reference[place..place + 25].copy_from_slice(&coefficients);
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
        fn properties(&self, body: usize, x: f64, length: f64) -> ::std::vec::Vec<f64> {
            let model = &self.model;
            ::std::vec::Vec::from([
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
                shape: ::rncf::emitted::SectionShape::General {
                    extent: [None, None],
                },
                area: 0.0,
                second_moments: [0.0, 0.0],
                torsion_constant: 0.0,
                young_over_shear: 0.0,
                softness_of_curves: 2.0,
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
