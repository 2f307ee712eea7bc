//! Expansion of `models/src/iea15mw_blade.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use iea15mw_blade_equations::Iea15mwBlade;
#[allow(clippy::all)]
impl Default for Iea15mwBlade {
    fn default() -> Self {
        Self {
            downwind: 0.0,
            edgewise: 0.0,
            each: 1,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for Iea15mwBlade {
    const NAME: &'static str = "Iea15mwBlade";
    const DOC: &'static str = "Blade of the IEA 15-MW turbine (v1.1.6), 117 m along a bent axis, clamped at its root: 26 stations with full matrices of stiffness and mass.";
    const SOURCE: &'static str = r#"pub model Iea15mwBlade {
    /// Dead force at the tip, downwind.
    param downwind = 0 N;
    /// Dead force at the tip, edgewise.
    param edgewise = 0 N;
    /// Elements from one station to the next.
    param each: count = 1;

    table sections = file("data/iea15_section.csv");
    table points = file("data/iea15_keypoints.csv");
    section layup = beamdyn(sections);

    body blade {
        spatial;
        curve through points;
        section_y [1, 0, 0];
        twist -points.twist;
        mesh each at sections * beam(layup);
    }
    joint hub = clamp(blade.start, inertial);
    load pull = force(blade.end, [downwind, edgewise, 0 N], in = inertial);

    /// Position of the tip.
    output tip = blade.end.position;
    /// Mass.
    output mass = blade.mass;
    /// Moment that the blade exerts on its clamp.
    output root = -hub.moment;

    run { t_end = 1 s; every = 0.1 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xa2f887b3fc60a5b2;
    const NOTES: &'static [&'static str] = &[
        "Body `blade` uses `full_beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1976 and 16994).",
        "Body `blade` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `blade`: its section has no damping: no rates of strain and no damping matrix.",
        "Body `blade` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.",
        "Joint `hub`: its conditions are linear in the nodal vectors of `blade` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as body `blade` has an energy that is not quadratic in the inner products of its vectors.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points2_force",
            additions: 120,
            multiplications: 210,
            divisions: 15,
            functions: 1,
            weighted: 410,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points2_tangent",
            additions: 1036,
            multiplications: 1571,
            divisions: 51,
            functions: 1,
            weighted: 2831,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points2_energy",
            additions: 45,
            multiplications: 68,
            divisions: 3,
            functions: 1,
            weighted: 145,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_force",
            additions: 26,
            multiplications: 47,
            divisions: 1,
            functions: 1,
            weighted: 97,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_tangent",
            additions: 117,
            multiplications: 221,
            divisions: 4,
            functions: 1,
            weighted: 374,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_energy",
            additions: 17,
            multiplications: 26,
            divisions: 0,
            functions: 1,
            weighted: 63,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_nodes3_force",
            additions: 17,
            multiplications: 36,
            divisions: 0,
            functions: 0,
            weighted: 53,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_nodes3_tangent",
            additions: 32,
            multiplications: 73,
            divisions: 0,
            functions: 0,
            weighted: 105,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_nodes3_energy",
            additions: 13,
            multiplications: 21,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_reference",
            additions: 245,
            multiplications: 325,
            divisions: 5,
            functions: 5,
            weighted: 690,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_section_y_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_section_y_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_section_z_0",
            additions: 4,
            multiplications: 5,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_shapes_section_z_1",
            additions: 3,
            multiplications: 5,
            divisions: 1,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_field_forces",
            additions: 320,
            multiplications: 469,
            divisions: 35,
            functions: 2,
            weighted: 969,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_position",
            additions: 15,
            multiplications: 19,
            divisions: 0,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_absolute_jacobian",
            additions: 3,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 15,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "downwind",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 0.0,
                doc: "Dead force at the tip, downwind.",
            },
            ::rncf::Param {
                name: "edgewise",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 0.0,
                doc: "Dead force at the tip, edgewise.",
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
                name: "tip",
                unit: "m",
                time_exponent: 0.0,
                components: &["x", "y", "z"],
                doc: "Position of the tip.",
            },
            ::rncf::Output {
                name: "mass",
                unit: "kg",
                time_exponent: 0.0,
                components: &[],
                doc: "Mass.",
            },
            ::rncf::Output {
                name: "root",
                unit: "N m",
                time_exponent: -2.0,
                components: &["x", "y", "z"],
                doc: "Moment that the blade exerts on its clamp.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.downwind,
            1 => self.edgewise,
            2 => self.each as f64,
            _ => panic!("Iea15mwBlade has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.downwind = value,
            1 => self.edgewise = value,
            2 => self.each = value as usize,
            _ => panic!("Iea15mwBlade has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        iea15mw_blade_equations::run_defaults(self, &mut run);
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
        let equations = iea15mw_blade_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`Iea15mwBlade`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod iea15mw_blade_equations {
    /// Blade of the IEA 15-MW turbine (v1.1.6), 117 m along a bent axis, clamped at its root: 26 stations with full matrices of stiffness and mass.
    ///
    /// # Chosen and left out
    ///
    /// * Body `blade` uses `full_beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1976 and 16994).
    /// * Body `blade` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
    /// * Body `blade`: its section has no damping: no rates of strain and no damping matrix.
    /// * Body `blade` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.
    /// * Joint `hub`: its conditions are linear in the nodal vectors of `blade` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as body `blade` has an energy that is not quadratic in the inner products of its vectors.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct Iea15mwBlade {
        /// Dead force at the tip, downwind. (SI; declared in N)
        pub downwind: f64,
        /// Dead force at the tip, edgewise. (SI; declared in N)
        pub edgewise: f64,
        /// Elements from one station to the next. (count)
        pub each: usize,
    }
    /// Table `sections`: eta, K11, K12, K13, K14, K15, K16, K22, K23, K24, K25, K26, K33, K34, K35, K36, K44, K45, K46, K55, K56, K66, M11, M12, M13, M14, M15, M16, M22, M23, M24, M25, M26, M33, M34, M35, M36, M44, M45, M46, M55, M56, M66.
    pub static TABLE_SECTIONS: ::rncf::emitted::Table = ::rncf::emitted::Table {
        name: "sections",
        places: &[
            0.0,
            0.01,
            0.02,
            0.03,
            0.04,
            0.05,
            0.075,
            0.1,
            0.15,
            0.2,
            0.25,
            0.3,
            0.35,
            0.4,
            0.45,
            0.5,
            0.55,
            0.6,
            0.65,
            0.7,
            0.75,
            0.8,
            0.85,
            0.9,
            0.95,
            1.0,
        ],
        is_relative: true,
        between: ::rncf::emitted::Between::Line,
        columns: &[
            &[
                0.0,
                0.01,
                0.02,
                0.03,
                0.04,
                0.05,
                0.075,
                0.1,
                0.15,
                0.2,
                0.25,
                0.3,
                0.35,
                0.4,
                0.45,
                0.5,
                0.55,
                0.6,
                0.65,
                0.7,
                0.75,
                0.8,
                0.85,
                0.9,
                0.95,
                1.0,
            ],
            &[
                6740375994.2,
                6384592445.51,
                6033428473.03,
                5399937528.56,
                4800672070.89,
                4245595846.6,
                3015180949.07,
                2419253237.98,
                936314786.897,
                459476847.225,
                281350049.449,
                224644322.017,
                187672692.573,
                161609316.902,
                137969183.99,
                116600478.452,
                97422515.9833,
                81358328.9585,
                67080158.8242,
                55553240.5837,
                44994384.5687,
                36509915.3833,
                27272722.3361,
                19745236.354,
                9179700.67568,
                931474.181705,
            ],
            &[
                2653738.58741,
                -376400.647447,
                -5351360.12733,
                2545105.37002,
                6445969.84526,
                6455163.70265,
                -6056529.37031,
                113285786.003,
                80833117.6608,
                50723215.9643,
                19062499.8909,
                4177613.49921,
                -2993741.65664,
                -3309906.62256,
                -2612569.6185,
                -1443459.82647,
                -997091.037995,
                122590.70891,
                1150059.00122,
                1941394.58229,
                2180662.57618,
                2151842.31426,
                993432.171826,
                510321.800419,
                307950.617362,
                232415.294563,
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
            ],
            &[
                148446683.008,
                -93807158.5472,
                -302258358.415,
                -376430490.911,
                -410026336.098,
                -423187047.46,
                -335581833.175,
                -235382612.5,
                110222775.825,
                44624062.1147,
                39788481.5583,
                22822651.1063,
                14817252.6551,
                14196051.9459,
                10110737.4145,
                9756447.07568,
                7650615.7891,
                7709138.63463,
                8354890.67176,
                8124277.1876,
                7061108.35339,
                6124281.75121,
                3331136.31245,
                1832045.89916,
                1267110.07815,
                106353.528997,
            ],
            &[
                6729088765.4,
                6388480690.31,
                6055417688.52,
                5758216767.87,
                5468722459.96,
                5195984070.29,
                4552086385.17,
                3985354344.87,
                2314391966.66,
                963021463.342,
                480065126.665,
                346901262.385,
                324078740.909,
                317531903.303,
                309152872.555,
                303218881.821,
                292909738.469,
                300285135.273,
                334604810.692,
                376257910.104,
                395913126.768,
                375210610.3,
                239673891.333,
                144312493.866,
                86939021.6748,
                15879263.6105,
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
            ],
            &[
                38985021.6653,
                16608264.9357,
                5594870.11467,
                19709135.8539,
                28462348.9384,
                35814075.9438,
                53346766.102,
                87781196.9178,
                102518319.263,
                63418511.854,
                35649958.0013,
                26944490.4843,
                22977520.6769,
                19104038.487,
                15276680.6013,
                12426129.2123,
                11590547.0254,
                12779793.3656,
                15336313.59,
                18041654.778,
                19527620.3355,
                17825049.8174,
                10738401.6327,
                6016948.89773,
                3396279.81952,
                117375.666081,
            ],
            &[
                46051081603.6,
                43751344063.2,
                41569662567.5,
                38669982721.7,
                36038990116.7,
                33746441410.2,
                29212071034.7,
                27339201435.3,
                22665764106.9,
                20450235426.0,
                20473859852.0,
                21366371296.5,
                21785402237.0,
                21621041012.0,
                20779461548.8,
                19923519424.8,
                18925122694.7,
                17539655765.2,
                15853197990.9,
                14061229868.5,
                11003024089.8,
                7310260724.86,
                4521289678.95,
                2675615584.14,
                1203040036.15,
                118283403.932,
            ],
            &[
                -1092494742.14,
                582609637.84,
                2071574619.54,
                2739604966.98,
                3310499851.24,
                3921047165.84,
                5225114500.37,
                8519455804.02,
                10699908369.4,
                9176487472.16,
                9004633626.17,
                8306288511.85,
                7885934214.42,
                6912268845.28,
                6380607368.42,
                5510503208.48,
                4939813431.15,
                3340368066.2,
                1772039285.16,
                1013471013.85,
                625226575.782,
                354179115.289,
                266089109.403,
                184789087.684,
                137345812.756,
                1168848.14318,
            ],
            &[
                18829097.3018,
                3336008.29883,
                -39669072.5379,
                -139140684.3,
                -201959858.663,
                -248900545.303,
                -316621483.967,
                -518317006.66,
                -252339646.166,
                -318201927.73,
                -370375609.629,
                -349173302.592,
                -281941707.051,
                -151464382.087,
                -81958836.2259,
                -145792800.154,
                -215770838.71,
                -299940988.574,
                -358354291.377,
                -411634704.484,
                -386594144.727,
                -261309728.474,
                -148760396.985,
                -79832450.7483,
                -31896540.3793,
                -795943.416893,
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
            ],
            &[
                149629012638.0,
                142328864113.0,
                135212838311.0,
                123284345388.0,
                112223397787.0,
                102686583994.0,
                82456226298.0,
                72781368868.4,
                54125167812.0,
                39196915729.9,
                35299428705.3,
                31051165577.6,
                26088284004.5,
                22217425411.0,
                18717308525.8,
                15586807919.1,
                12739863625.7,
                8379809772.74,
                4637021573.47,
                2889083609.85,
                1877272361.94,
                1099701983.69,
                683571619.677,
                420297066.767,
                231512293.707,
                1384839.76994,
            ],
            &[
                -22581466.1664,
                -232559270.061,
                -606773042.4,
                -1348337968.62,
                -2131730557.9,
                -2938603122.3,
                -4823615805.9,
                -6133557676.83,
                -4839685559.61,
                -3395447917.87,
                -1524671060.65,
                -615674444.315,
                -91553134.3129,
                -10375272.8535,
                2259343.50518,
                -28845801.8403,
                -43922352.5191,
                -29747619.2878,
                -2424421.89771,
                -12258851.3499,
                -15695344.2666,
                -6469059.31118,
                -4841801.23669,
                -4125365.22483,
                -3561131.72533,
                -26483.6917424,
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
            ],
            &[
                149729095916.0,
                143137826353.0,
                137008541713.0,
                119514275125.0,
                104365370042.0,
                91978034767.2,
                68686121530.7,
                52263394041.4,
                27988353518.9,
                21820483410.2,
                15615256841.1,
                13362814423.4,
                10663481378.1,
                8537806429.68,
                6549534664.53,
                4893346064.32,
                3604017503.7,
                2655217532.06,
                1917970315.44,
                1351951128.69,
                838106592.742,
                466233432.881,
                243066553.44,
                113253467.97,
                36395660.0209,
                186239.912939,
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
            ],
            &[
                87489183048.0,
                83285587642.8,
                79106159653.8,
                69973323042.1,
                61533150488.5,
                54135840079.7,
                38418612295.4,
                25428346793.3,
                8076640558.86,
                2768066330.97,
                1026128471.86,
                627053086.269,
                461211585.491,
                364794590.157,
                285660364.099,
                220544333.375,
                168037150.442,
                128226839.007,
                95377930.582,
                71456369.556,
                52519301.1763,
                38106482.5137,
                23330158.8618,
                13417874.4622,
                6805118.09072,
                71452.3363137,
            ],
            &[
                3127.40211554,
                2964.73253181,
                2805.12733239,
                2591.13678351,
                2389.11540592,
                2203.52246957,
                1793.56218005,
                1694.50712265,
                1050.50416173,
                668.838920522,
                531.061274951,
                483.985158095,
                458.083886734,
                433.871601706,
                404.917806654,
                377.731233031,
                350.484340036,
                307.347825074,
                260.265335637,
                223.942561946,
                179.584070672,
                129.308005481,
                84.4557374527,
                54.7047303251,
                34.4499288523,
                5.39497069134,
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
            ],
            &[
                73.9319547106,
                -39.6893415304,
                -140.751489022,
                -186.507103749,
                -225.672531859,
                -266.669822458,
                -349.638937534,
                -525.431000243,
                -610.17118968,
                -519.324144086,
                -469.187315965,
                -429.547370313,
                -387.997906184,
                -345.889201725,
                -311.07188809,
                -272.850088372,
                -237.979492201,
                -164.729199252,
                -93.43468152,
                -57.935047674,
                -38.0523975504,
                -23.2260251308,
                -16.3954622586,
                -11.0331853968,
                -8.11949279771,
                -0.158885936609,
            ],
            &[
                3127.40211554,
                2964.73253181,
                2805.12733239,
                2591.13678351,
                2389.11540592,
                2203.52246957,
                1793.56218005,
                1694.50712265,
                1050.50416173,
                668.838920522,
                531.061274951,
                483.985158095,
                458.083886734,
                433.871601706,
                404.917806654,
                377.731233031,
                350.484340036,
                307.347825074,
                260.265335637,
                223.942561946,
                179.584070672,
                129.308005481,
                84.4557374527,
                54.7047303251,
                34.4499288523,
                5.39497069134,
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
            ],
            &[
                -0.232279310353,
                -0.169645525317,
                2.40571576968,
                8.85032223379,
                12.729809187,
                15.7761549755,
                21.3206299843,
                33.6314977651,
                24.4884490941,
                20.2751445598,
                18.4068665304,
                15.2493826042,
                12.5415361474,
                9.38510066641,
                7.47576361586,
                7.81556160621,
                8.18297620938,
                7.95168602739,
                7.29266131652,
                7.22303738244,
                6.57235772285,
                4.71916228979,
                2.82105727002,
                1.64182540284,
                0.916505016263,
                0.0369610891827,
            ],
            &[
                3127.40211554,
                2964.73253181,
                2805.12733239,
                2591.13678351,
                2389.11540592,
                2203.52246957,
                1793.56218005,
                1694.50712265,
                1050.50416173,
                668.838920522,
                531.061274951,
                483.985158095,
                458.083886734,
                433.871601706,
                404.917806654,
                377.731233031,
                350.484340036,
                307.347825074,
                260.265335637,
                223.942561946,
                179.584070672,
                129.308005481,
                84.4557374527,
                54.7047303251,
                34.4499288523,
                5.39497069134,
            ],
            &[
                -73.9319547106,
                39.6893415304,
                140.751489022,
                186.507103749,
                225.672531859,
                266.669822458,
                349.638937534,
                525.431000243,
                610.17118968,
                519.324144086,
                469.187315965,
                429.547370313,
                387.997906184,
                345.889201725,
                311.07188809,
                272.850088372,
                237.979492201,
                164.729199252,
                93.43468152,
                57.935047674,
                38.0523975504,
                23.2260251308,
                16.3954622586,
                11.0331853968,
                8.11949279771,
                0.158885936609,
            ],
            &[
                0.232279310353,
                0.169645525317,
                -2.40571576968,
                -8.85032223379,
                -12.729809187,
                -15.7761549755,
                -21.3206299843,
                -33.6314977651,
                -24.4884490941,
                -20.2751445598,
                -18.4068665304,
                -15.2493826042,
                -12.5415361474,
                -9.38510066641,
                -7.47576361586,
                -7.81556160621,
                -8.18297620938,
                -7.95168602739,
                -7.29266131652,
                -7.22303738244,
                -6.57235772285,
                -4.71916228979,
                -2.82105727002,
                -1.64182540284,
                -0.916505016263,
                -0.0369610891827,
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
            ],
            &[
                10167.9763222,
                9670.81748801,
                9183.72374182,
                8366.67054793,
                7605.99920525,
                6947.02169118,
                5542.2219892,
                4883.61158578,
                3320.8865205,
                2253.55866741,
                1848.57838506,
                1564.73596854,
                1286.71758191,
                1076.14328596,
                895.751382115,
                735.407926824,
                593.107800042,
                389.109674846,
                215.469368889,
                131.654541485,
                84.6496214991,
                51.4548023309,
                31.5075395814,
                19.3198560795,
                12.2628219999,
                0.0937342769229,
            ],
            &[
                1.06831307341,
                -0.913395557761,
                -6.14336448436,
                -30.176017664,
                -51.1381480054,
                -69.342936424,
                -103.281856723,
                -159.422510927,
                -109.412357645,
                -74.2565750259,
                -51.0004786673,
                -34.0708422376,
                -23.3864191006,
                -18.7515232418,
                -15.6036263099,
                -13.6442162639,
                -11.6622505928,
                -7.8369665203,
                -4.17613306908,
                -2.64210376046,
                -1.79961187768,
                -1.04052776059,
                -0.623207766245,
                -0.368487550765,
                -0.249561660626,
                -0.00227683260519,
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
            ],
            &[
                10166.2844272,
                9677.50665828,
                9189.97916645,
                7913.55513776,
                6778.70787427,
                5816.7305131,
                3914.59682817,
                2785.95574743,
                956.30886983,
                476.363668172,
                268.559502721,
                204.067743057,
                154.747170747,
                120.16301069,
                90.5084917753,
                66.5158719476,
                48.3879168462,
                35.2221701565,
                25.2155466211,
                17.745330078,
                11.2711949233,
                6.68458057576,
                3.61633766405,
                1.78333715736,
                0.757383616141,
                0.0071808104318,
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
            ],
            &[
                20334.2607494,
                19348.3241463,
                18373.7029083,
                16280.2256857,
                14384.7070795,
                12763.7522043,
                9456.81881737,
                7669.56733321,
                4277.19539033,
                2729.92233558,
                2117.13788778,
                1768.8037116,
                1441.46475266,
                1196.30629665,
                986.25987389,
                801.923798771,
                641.495716888,
                424.331845002,
                240.68491551,
                149.399871563,
                95.9208164224,
                58.1393829067,
                35.1238772454,
                21.1031932369,
                13.020205616,
                0.100915087355,
            ],
        ],
    };
    /// Table `points`: x, y, z, twist.
    pub static TABLE_POINTS: ::rncf::emitted::Table = ::rncf::emitted::Table {
        name: "points",
        places: &[
            0.0,
            0.02038285588185154,
            0.04076603838265927,
            0.06114980490993738,
            0.08153383684104454,
            0.10191825879071695,
            0.12230189445593462,
            0.14268604273261304,
            0.16306885593243006,
            0.18345199529979062,
            0.20383470854910038,
            0.22421645095414613,
            0.24459904635777452,
            0.26498079277745956,
            0.28536340030302365,
            0.305745162404963,
            0.3261277900257249,
            0.34650956728904464,
            0.366892252227808,
            0.3872743580587653,
            0.4076579866398128,
            0.42804330234367655,
            0.4484292921596035,
            0.4688179097491075,
            0.48920684634010153,
            0.5095973405172878,
            0.5299878609593782,
            0.5503819861963051,
            0.5707806745251311,
            0.5911850004089223,
            0.6115937567066093,
            0.6320054818576903,
            0.6524203352231988,
            0.6728361129323439,
            0.6932532750240027,
            0.7136731035214979,
            0.7340987119965195,
            0.7545278666054221,
            0.7749621738549273,
            0.7953991781578034,
            0.8158400148079428,
            0.8362839633183025,
            0.8567328129138665,
            0.8771783660297681,
            0.8976372104387067,
            0.9181018787219818,
            0.9385712306516921,
            0.9590375158190995,
            0.9795159750880484,
            1.0,
        ],
        is_relative: true,
        between: ::rncf::emitted::Between::Line,
        columns: &[
            &[
                0.0,
                0.0183726,
                0.0422062,
                0.0713101,
                0.10361,
                0.13705,
                0.169613,
                0.199102,
                0.223601,
                0.241069,
                0.249238,
                0.250309,
                0.249413,
                0.247571,
                0.244817,
                0.241329,
                0.23699,
                0.232446,
                0.225312,
                0.211013,
                0.186954,
                0.147931,
                0.099171,
                0.0411154,
                -0.0223395,
                -0.0888277,
                -0.15892,
                -0.239251,
                -0.336643,
                -0.446936,
                -0.567957,
                -0.697521,
                -0.831916,
                -0.969965,
                -1.10909,
                -1.25513,
                -1.41034,
                -1.5733,
                -1.7435,
                -1.91945,
                -2.10009,
                -2.2855,
                -2.47569,
                -2.67342,
                -2.87783,
                -3.09009,
                -3.30846,
                -3.53371,
                -3.7635,
                -4.0,
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
                0.0,
            ],
            &[
                0.0,
                2.38776,
                4.77551,
                7.16327,
                9.55102,
                11.9388,
                14.3265,
                16.7143,
                19.102,
                21.4898,
                23.8776,
                26.2653,
                28.6531,
                31.0408,
                33.4286,
                35.8163,
                38.2041,
                40.5918,
                42.9796,
                45.3673,
                47.7551,
                50.1429,
                52.5306,
                54.9184,
                57.3061,
                59.6939,
                62.0816,
                64.4694,
                66.8571,
                69.2449,
                71.6327,
                74.0204,
                76.4082,
                78.7959,
                81.1837,
                83.5714,
                85.9592,
                88.3469,
                90.7347,
                93.1224,
                95.5102,
                97.898,
                100.286,
                102.673,
                105.061,
                107.449,
                109.837,
                112.224,
                114.612,
                117.0,
            ],
            &[
                0.2721771155315077,
                0.2720566878131201,
                0.26896920036634214,
                0.26090228856362435,
                0.24885777139561147,
                0.23382350521893233,
                0.21680479968273564,
                0.1988732869477459,
                0.18100809672433193,
                0.16413076285754674,
                0.14925218005014548,
                0.13671425830259382,
                0.12551273516329423,
                0.11434751487243609,
                0.10356783781334351,
                0.09330687260794365,
                0.08371175051217963,
                0.07498964210826317,
                0.06714211819252107,
                0.06013252685066143,
                0.05370221028753872,
                0.0477096223008162,
                0.04210135581538282,
                0.036855943281439055,
                0.03191160004346432,
                0.02720584331423721,
                0.022731866309674945,
                0.01857780815700324,
                0.014720909762776093,
                0.011110137699665184,
                0.007627594976698298,
                0.0041828037254520506,
                0.0006925065046185541,
                -0.00301641763963676,
                -0.007104956132188597,
                -0.011874836258133981,
                -0.017440970495424216,
                -0.02304759637136072,
                -0.02833192974762395,
                -0.03288846082580555,
                -0.0364115824538813,
                -0.037768925013157296,
                -0.03797557199659342,
                -0.03761708136823379,
                -0.03670270337311396,
                -0.03522772562225355,
                -0.03310435805427725,
                -0.03009523589091382,
                -0.02632183404810208,
                -0.02168379609385235,
            ],
        ],
    };
    /// Constants of one element `full_beam_spatial_curved`. Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1976 and 16994).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct FullBeamSpatialCurved {
        /// Length, m.
        pub length: f64,
    }
    /// Nodal vectors by what they interpolate: Position, SectionY, SectionZ.
    static FULL_BEAM_SPATIAL_CURVED_VECTORS: ::rncf::emitted::Vectors<10, 3, 3, 3> = ::rncf::emitted::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Weights of 2 Gauss points, and derivatives of the shape functions there.
    static FULL_BEAM_SPATIAL_CURVED_POINTS2: ::rncf::emitted::Rule<2, 5, 3> = ::rncf::emitted::Rule {
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
    static FULL_BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS: ::rncf::emitted::Blocks<
        2,
        9,
        17,
    > = FULL_BEAM_SPATIAL_CURVED_POINTS2
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
    static FULL_BEAM_SPATIAL_CURVED_POINTS3: ::rncf::emitted::Rule<3, 3, 3> = ::rncf::emitted::Rule {
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
    static FULL_BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS: ::rncf::emitted::Blocks<
        3,
        9,
        6,
    > = FULL_BEAM_SPATIAL_CURVED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Weights of 3 nodes, and derivatives of the shape functions there.
    static FULL_BEAM_SPATIAL_CURVED_NODES3: ::rncf::emitted::Rule<3, 2, 3> = ::rncf::emitted::Rule {
        groups: [1, 2],
        weights: [0.16666666666666666, 0.6666666666666666, 0.16666666666666666],
        shapes: [
            [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
            [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static FULL_BEAM_SPATIAL_CURVED_NODES3_STIFFNESS: ::rncf::emitted::Blocks<3, 9, 3> = FULL_BEAM_SPATIAL_CURVED_NODES3
        .blocks(&[(0, 0), (0, 1), (1, 1)], &[(3, 0, 1), (4, 1, 2), (5, 2, 3)]);
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 120 additions, 210 multiplications, 15 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
        let t62 = t60 * t61;
        let t63 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t53 * t59) / t56;
        let t64 = t61 * t63;
        let t65 = (a_x * db_x + a_y * db_y + a_z * db_z - t54 * t59) / t56;
        let t66 = t60 * t65;
        let t67 = t59 * t62 + reference[9] * t64 - reference[10] * t66
            + reference[12] * t57 + t53 * reference[15];
        let t68 = length * reference[3] * (t67 + t54 * reference[19] - reference[0]);
        let t69 = 1.0 / (2.0 * t56);
        let t70 = t61 * (t63 * t69 / t56);
        let t71 = t60 * (t65 * t69 / t56);
        let t72 = t64 - reference[11] * t66 + reference[13] * t57 + t53 * reference[16]
            + t54 * reference[20] - reference[1];
        let t73 = length * reference[4] * t72;
        let t74 = length * reference[5]
            * (reference[14] * t57 - t66 + t53 * reference[17] + t54 * reference[21]
                - reference[2]);
        let t75 = t69 * (t53 * 2.0);
        let t76 = t61 * ((t59 + t63 * t75) / t56);
        let t77 = t60 * (t65 * t75 / t56);
        let t78 = t69 * (t54 * 2.0);
        let t79 = t61 * (t63 * t78 / t56);
        let t80 = t60 * ((t65 * t78 - t59) / t56);
        let t81 = 1.0 / t56;
        let t82 = t60 * t81;
        let t83 = t61 * t81;
        let t84 = -0.5 * t65;
        let t85 = t61 * (t53 * (-0.5) / t56);
        let t86 = t60 * (t54 * (-0.5) / t56);
        let t87 = -0.5 * t63;
        let t88 = t61 * (0.5 * t53 / t56);
        let t89 = t60 * (0.5 * t54 / t56);
        let t90 = t68 * (reference[10] * t71 - reference[9] * t70 + reference[12] * t69)
            + t73 * (reference[11] * t71 - t70 + reference[13] * t69);
        let t91 = t90 + t74 * (t71 + reference[14] * t69);
        let t92 = t68
            * (reference[15]
                + (reference[9] * t76 - reference[10] * t77 - reference[12] * t75))
            + t73 * (reference[16] + (t76 - reference[11] * t77 - reference[13] * t75));
        let t93 = t92 + t74 * (reference[17] - (t77 + reference[14] * t75));
        let t94 = t68
            * (reference[19]
                + (reference[9] * t79 - reference[10] * t80 - reference[12] * t78))
            + t73 * (reference[20] + (t79 - reference[11] * t80 - reference[13] * t78));
        let t95 = t94 + t74 * (reference[21] - (t80 + reference[14] * t78));
        let t96 = t68 * (t59 * (-0.5 * t61) - reference[10] * t84)
            - t73 * (reference[11] * t84) - t74 * t84;
        let t97 = t68 * (-0.5 * t62 + reference[9] * t85 + reference[10] * t86)
            + t73 * (t85 + reference[11] * t86);
        let t98 = t68 * (t59 * (-0.5 * t60) + reference[9] * t87) + t73 * t87;
        let t99 = t68 * (0.5 * t62 + reference[9] * t88 + reference[10] * t89)
            + t73 * (t88 + reference[11] * t89);
        let t100 = inverse_length
            * (t68 * (reference[10] * t82) + t73 * (reference[11] * t82) + t74 * t82);
        let t101 = inverse_length * (t68 * (reference[9] * t83) + t73 * t83);
        let t102 = inverse_length * (t97 + t74 * t86);
        let t103 = inverse_length * (t99 + t74 * t89);
        let t104 = t91 * (a_x * 2.0) + b_x * t93 + c_x * t95 - unit_db_x * t100
            + unit_dc_x * t101;
        let t105 = t91 * (a_y * 2.0) + b_y * t93 + c_y * t95 - unit_db_y * t100
            + unit_dc_y * t101;
        let t106 = t91 * (a_z * 2.0) + b_z * t93 + c_z * t95 - unit_db_z * t100
            + unit_dc_z * t101;
        forces[0][0] = t104;
        forces[0][1] = t105;
        forces[0][2] = t106;
        forces[1][0] = a_x * t93 + t96 * (b_x * 2.0) + unit_dc_x * t102;
        forces[1][1] = a_y * t93 + t96 * (b_y * 2.0) + unit_dc_y * t102;
        forces[1][2] = a_z * t93 + t96 * (b_z * 2.0) + unit_dc_z * t102;
        forces[2][0] = a_x * t95 + t98 * (c_x * 2.0) + unit_db_x * t103;
        forces[2][1] = a_y * t95 + t98 * (c_y * 2.0) + unit_db_y * t103;
        forces[2][2] = a_z * t95 + t98 * (c_z * 2.0) + unit_db_z * t103;
        forces[3][0] = c_x * t103 - a_x * t100;
        forces[3][1] = c_y * t103 - a_y * t100;
        forces[3][2] = c_z * t103 - a_z * t100;
        forces[4][0] = a_x * t101 + b_x * t102;
        forces[4][1] = a_y * t101 + b_y * t102;
        forces[4][2] = a_z * t101 + b_z * t102;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 1036 additions, 1571 multiplications, 51 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 17],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
        let t62 = t60 * t61;
        let t63 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t53 * t59) / t56;
        let t64 = t61 * t63;
        let t65 = (a_x * db_x + a_y * db_y + a_z * db_z - t54 * t59) / t56;
        let t66 = t60 * t65;
        let t67 = t59 * t62 + reference[9] * t64 - reference[10] * t66
            + reference[12] * t57 + t53 * reference[15];
        let t68 = length * reference[3];
        let t69 = t68 * (t67 + t54 * reference[19] - reference[0]);
        let t70 = 2.0 * t56;
        let t71 = 1.0 / t70;
        let t72 = t63 * t71 / t56;
        let t73 = t61 * t72;
        let t74 = t65 * t71 / t56;
        let t75 = t60 * t74;
        let t76 = reference[10] * t75 - reference[9] * t73 + reference[12] * t71;
        let t77 = length * reference[4];
        let t78 = t64 - reference[11] * t66 + reference[13] * t57 + t53 * reference[16]
            + t54 * reference[20] - reference[1];
        let t79 = t77 * t78;
        let t80 = reference[11] * t75 - t73 + reference[13] * t71;
        let t81 = length * reference[5];
        let t82 = t81
            * (reference[14] * t57 - t66 + t53 * reference[17] + t54 * reference[21]
                - reference[2]);
        let t83 = t75 + reference[14] * t71;
        let t84 = t68 * t76;
        let t85 = 2.0 * t71;
        let t86 = t71 * t85 / t70;
        let t87 = t71 * t72;
        let t88 = t61 * ((t87 + (t87 + t63 * t86)) / t56);
        let t89 = t71 * t74;
        let t90 = t60 * ((t89 + (t89 + t65 * t86)) / t56);
        let t91 = t77 * t80;
        let t92 = t76 * t84
            + t69 * (reference[9] * t88 - reference[10] * t90 - reference[12] * t86)
            + (t80 * t91 + t79 * (t88 - reference[11] * t90 - reference[13] * t86));
        let t93 = t81 * t83;
        let t94 = t92 + (t83 * t93 - t82 * (t90 + reference[14] * t86));
        let t95 = t53 * 2.0;
        let t96 = t71 * t95;
        let t97 = (t59 + t63 * t96) / t56;
        let t98 = t61 * t97;
        let t99 = t65 * t96 / t56;
        let t100 = t60 * t99;
        let t101 = reference[15]
            + (reference[9] * t98 - reference[10] * t100 - reference[12] * t96);
        let t102 = reference[16] + (t98 - reference[11] * t100 - reference[13] * t96);
        let t103 = reference[17] - (t100 + reference[14] * t96);
        let t104 = t68 * t101;
        let t105 = t71 * (2.0 * t96) / t70;
        let t106 = t71 * t97;
        let t107 = t72 * t96;
        let t108 = t61 * ((t106 + t63 * t105 + t107) / t56);
        let t109 = t71 * t99;
        let t110 = t74 * t96;
        let t111 = t60 * ((t109 + t65 * t105 + t110) / t56);
        let t112 = t77 * t102;
        let t113 = t76 * t104
            + t69 * (reference[10] * t111 - reference[9] * t108 + reference[12] * t105)
            + (t80 * t112 + t79 * (reference[11] * t111 - t108 + reference[13] * t105));
        let t114 = t81 * t103;
        let t115 = t113 + (t83 * t114 + t82 * (t111 + reference[14] * t105));
        let t116 = t54 * 2.0;
        let t117 = t71 * t116;
        let t118 = t63 * t117 / t56;
        let t119 = t61 * t118;
        let t120 = (t65 * t117 - t59) / t56;
        let t121 = t60 * t120;
        let t122 = reference[19]
            + (reference[9] * t119 - reference[10] * t121 - reference[12] * t117);
        let t123 = reference[20] + (t119 - reference[11] * t121 - reference[13] * t117);
        let t124 = reference[21] - (t121 + reference[14] * t117);
        let t125 = t68 * t122;
        let t126 = t71 * (2.0 * t117) / t70;
        let t127 = t71 * t118;
        let t128 = t72 * t117;
        let t129 = t61 * ((t127 + t63 * t126 + t128) / t56);
        let t130 = t71 * t120;
        let t131 = t74 * t117;
        let t132 = t60 * ((t130 + t65 * t126 + t131) / t56);
        let t133 = t77 * t123;
        let t134 = t76 * t125
            + t69 * (reference[10] * t132 - reference[9] * t129 + reference[12] * t126)
            + (t80 * t133 + t79 * (reference[11] * t132 - t129 + reference[13] * t126));
        let t135 = t81 * t124;
        let t136 = t134 + (t83 * t135 + t82 * (t132 + reference[14] * t126));
        let t137 = 1.0 / t56;
        let t138 = t60 * t137;
        let t139 = reference[10] * t138;
        let t140 = reference[11] * t138;
        let t141 = t68 * t139;
        let t142 = t71 * t137 / t56;
        let t143 = t60 * t142;
        let t144 = t69 * (reference[10] * t143);
        let t145 = t77 * t140;
        let t146 = t79 * (reference[11] * t143);
        let t147 = t81 * t138;
        let t148 = t82 * t143;
        let t149 = t61 * t137;
        let t150 = reference[9] * t149;
        let t151 = t68 * t150;
        let t152 = t61 * t142;
        let t153 = t69 * (reference[9] * t152);
        let t154 = t77 * t149;
        let t155 = t79 * t152;
        let t156 = -0.5 * t61;
        let t157 = -0.5 * t65;
        let t158 = t59 * t156 - reference[10] * t157;
        let t159 = reference[11] * t157;
        let t160 = t68 * t158;
        let t161 = -0.5 * t74;
        let t162 = t77 * t159;
        let t163 = t76 * t160 + t69 * (reference[10] * t161)
            + (t79 * (reference[11] * t161) - t80 * t162);
        let t164 = t81 * t157;
        let t165 = t163 + (t82 * t161 - t83 * t164);
        let t166 = t53 * (-0.5) / t56;
        let t167 = t61 * t166;
        let t168 = t54 * (-0.5) / t56;
        let t169 = t60 * t168;
        let t170 = -0.5 * t62 + reference[9] * t167 + reference[10] * t169;
        let t171 = t167 + reference[11] * t169;
        let t172 = t68 * t170;
        let t173 = t61 * (t71 * t166 / t56);
        let t174 = t60 * (t71 * t168 / t56);
        let t175 = t77 * t171;
        let t176 = t76 * t172 - t69 * (reference[9] * t173 + reference[10] * t174)
            + (t80 * t175 - t79 * (t173 + reference[11] * t174));
        let t177 = t81 * t169;
        let t178 = -0.5 * t60;
        let t179 = -0.5 * t63;
        let t180 = t59 * t178 + reference[9] * t179;
        let t181 = t68 * t180;
        let t182 = -0.5 * t72;
        let t183 = t77 * t179;
        let t184 = t76 * t181 - t69 * (reference[9] * t182) + (t80 * t183 - t79 * t182);
        let t185 = 0.5 * t53 / t56;
        let t186 = t61 * t185;
        let t187 = 0.5 * t54 / t56;
        let t188 = t60 * t187;
        let t189 = 0.5 * t62 + reference[9] * t186 + reference[10] * t188;
        let t190 = t186 + reference[11] * t188;
        let t191 = t68 * t189;
        let t192 = t61 * (t71 * t185 / t56);
        let t193 = t60 * (t71 * t187 / t56);
        let t194 = t77 * t190;
        let t195 = t76 * t191 - t69 * (reference[9] * t192 + reference[10] * t193)
            + (t80 * t194 - t79 * (t192 + reference[11] * t193));
        let t196 = t81 * t188;
        let t197 = t86 * t95;
        let t198 = t61 * ((t106 + (t107 + t63 * t197)) / t56);
        let t199 = t60 * ((t109 + (t110 + t65 * t197)) / t56);
        let t200 = t84 * t101
            + t69 * (reference[10] * t199 - reference[9] * t198 + reference[12] * t197)
            + (t91 * t102 + t79 * (reference[11] * t199 - t198 + reference[13] * t197));
        let t201 = t200 + (t93 * t103 + t82 * (t199 + reference[14] * t197));
        let t202 = t85 + t95 * t105;
        let t203 = t96 * t97;
        let t204 = t61 * ((t203 + (t203 + t63 * t202)) / t56);
        let t205 = t96 * t99;
        let t206 = t60 * ((t205 + (t205 + t65 * t202)) / t56);
        let t207 = t101 * t104
            + t69 * (reference[9] * t204 - reference[10] * t206 - reference[12] * t202)
            + (t102 * t112 + t79 * (t204 - reference[11] * t206 - reference[13] * t202));
        let t208 = t207 + (t103 * t114 - t82 * (t206 + reference[14] * t202));
        let t209 = t95 * t126;
        let t210 = t96 * t118;
        let t211 = t97 * t117;
        let t212 = t61 * ((t210 + t63 * t209 + t211) / t56);
        let t213 = t96 * t120;
        let t214 = t99 * t117;
        let t215 = t60 * ((t213 + t65 * t209 + t214) / t56);
        let t216 = t101 * t125
            + t69 * (reference[9] * t212 - reference[10] * t215 - reference[12] * t209)
            + (t102 * t133 + t79 * (t212 - reference[11] * t215 - reference[13] * t209));
        let t217 = t216 + (t103 * t135 - t82 * (t215 + reference[14] * t209));
        let t218 = t96 * t137 / t56;
        let t219 = t60 * t218;
        let t220 = t69 * (reference[10] * t219);
        let t221 = t79 * (reference[11] * t219);
        let t222 = t82 * t219;
        let t223 = t61 * t218;
        let t224 = t69 * (reference[9] * t223);
        let t225 = t79 * t223;
        let t226 = -0.5 * t99;
        let t227 = t69 * (reference[10] * t226);
        let t228 = t79 * (reference[11] * t226);
        let t229 = t82 * t226;
        let t230 = t101 * t160 - t227 - (t102 * t162 + t228) - (t103 * t164 + t229);
        let t231 = t61 * ((-0.5 + t96 * t166) / t56);
        let t232 = t60 * (t96 * t168 / t56);
        let t233 = t69 * (reference[9] * t231 + reference[10] * t232);
        let t234 = t79 * (t231 + reference[11] * t232);
        let t235 = t82 * t232;
        let t236 = -0.5 * t97;
        let t237 = t101 * t181 + t69 * (reference[9] * t236)
            + (t102 * t183 + t79 * t236);
        let t238 = t61 * ((0.5 + t96 * t185) / t56);
        let t239 = t60 * (t96 * t187 / t56);
        let t240 = t69 * (reference[9] * t238 + reference[10] * t239);
        let t241 = t79 * (t238 + reference[11] * t239);
        let t242 = t82 * t239;
        let t243 = t86 * t116;
        let t244 = t61 * ((t127 + (t128 + t63 * t243)) / t56);
        let t245 = t60 * ((t130 + (t131 + t65 * t243)) / t56);
        let t246 = t84 * t122
            + t69 * (reference[10] * t245 - reference[9] * t244 + reference[12] * t243)
            + (t91 * t123 + t79 * (reference[11] * t245 - t244 + reference[13] * t243));
        let t247 = t246 + (t93 * t124 + t82 * (t245 + reference[14] * t243));
        let t248 = t105 * t116;
        let t249 = t61 * ((t210 + (t211 + t63 * t248)) / t56);
        let t250 = t60 * ((t213 + (t214 + t65 * t248)) / t56);
        let t251 = t104 * t122
            + t69 * (reference[9] * t249 - reference[10] * t250 - reference[12] * t248)
            + (t112 * t123 + t79 * (t249 - reference[11] * t250 - reference[13] * t248));
        let t252 = t251 + (t114 * t124 - t82 * (t250 + reference[14] * t248));
        let t253 = t85 + t116 * t126;
        let t254 = t117 * t118;
        let t255 = t61 * ((t254 + (t254 + t63 * t253)) / t56);
        let t256 = t117 * t120;
        let t257 = t60 * ((t256 + (t256 + t65 * t253)) / t56);
        let t258 = t122 * t125
            + t69 * (reference[9] * t255 - reference[10] * t257 - reference[12] * t253)
            + (t123 * t133 + t79 * (t255 - reference[11] * t257 - reference[13] * t253));
        let t259 = t258 + (t124 * t135 - t82 * (t257 + reference[14] * t253));
        let t260 = t117 * t137 / t56;
        let t261 = t60 * t260;
        let t262 = t69 * (reference[10] * t261);
        let t263 = t79 * (reference[11] * t261);
        let t264 = t82 * t261;
        let t265 = t61 * t260;
        let t266 = t69 * (reference[9] * t265);
        let t267 = t79 * t265;
        let t268 = -0.5 * t120;
        let t269 = t69 * (reference[10] * t268);
        let t270 = t79 * (reference[11] * t268);
        let t271 = t82 * t268;
        let t272 = t122 * t160 - t269 - (t123 * t162 + t270) - (t124 * t164 + t271);
        let t273 = t61 * (t117 * t166 / t56);
        let t274 = t60 * ((-0.5 + t117 * t168) / t56);
        let t275 = t69 * (reference[9] * t273 + reference[10] * t274);
        let t276 = t79 * (t273 + reference[11] * t274);
        let t277 = t82 * t274;
        let t278 = -0.5 * t118;
        let t279 = t69 * (reference[9] * t278);
        let t280 = t79 * t278;
        let t281 = t122 * t181 + t279 + (t123 * t183 + t280);
        let t282 = t61 * (t117 * t185 / t56);
        let t283 = t60 * ((0.5 + t117 * t187) / t56);
        let t284 = t69 * (reference[9] * t282 + reference[10] * t283);
        let t285 = t79 * (t282 + reference[11] * t283);
        let t286 = t82 * t283;
        let t287 = -0.5 * t137;
        let t288 = t69 * (reference[10] * t287);
        let t289 = t79 * (reference[11] * t287);
        let t290 = t82 * t287;
        let t291 = t69 * (reference[9] * t287);
        let t292 = t79 * t287;
        let t293 = t104 * t158 - t227 - (t228 + t112 * t159) - (t229 + t114 * t157);
        let t294 = t125 * t158 - t269 - (t270 + t133 * t159) - (t271 + t135 * t157);
        let t295 = t158 * t160 + t159 * t162 + t157 * t164;
        let t296 = -0.5 * t168;
        let t297 = t69 * (-0.5 * t156 + reference[10] * t296);
        let t298 = t79 * (reference[11] * t296);
        let t299 = t82 * t296;
        let t300 = t158 * t181 + t69 * (t59 * 0.25) - t159 * t183;
        let t301 = -0.5 * t187;
        let t302 = t69 * (0.5 * t156 + reference[10] * t301);
        let t303 = t79 * (reference[11] * t301);
        let t304 = t82 * t301;
        let t305 = -0.5 * t166;
        let t306 = t69 * (-0.5 * t178 + reference[9] * t305);
        let t307 = t79 * t305;
        let t308 = t279 + t125 * t180 + (t280 + t133 * t179);
        let t309 = t180 * t181 + t179 * t183;
        let t310 = -0.5 * t185;
        let t311 = t69 * (0.5 * t178 + reference[9] * t310);
        let t312 = t79 * t310;
        let t313 = t69 * t101 + t79 * t102 + t82 * t103;
        let t314 = t69 * t122 + t79 * t123 + t82 * t124;
        let t315 = inverse_length
            * (t144 - t76 * t141 + (t146 - t80 * t145) + (t148 - t83 * t147));
        let t316 = inverse_length * (t76 * t151 - t153 + (t80 * t154 - t155));
        let t317 = inverse_length * (t176 + (t83 * t177 - t82 * t174));
        let t318 = inverse_length * (t195 + (t83 * t196 - t82 * t193));
        let t319 = inverse_length
            * (t101 * t141 + t220 + (t102 * t145 + t221) + (t103 * t147 + t222));
        let t320 = inverse_length * (t101 * t151 + t224 + (t102 * t154 + t225));
        let t321 = inverse_length
            * (t101 * t172 + t233 + (t102 * t175 + t234) + (t103 * t177 + t235));
        let t322 = inverse_length
            * (t101 * t191 + t240 + (t102 * t194 + t241) + (t103 * t196 + t242));
        let t323 = inverse_length
            * (t122 * t141 + t262 + (t123 * t145 + t263) + (t124 * t147 + t264));
        let t324 = inverse_length * (t122 * t151 + t266 + (t123 * t154 + t267));
        let t325 = inverse_length
            * (t122 * t172 + t275 + (t123 * t175 + t276) + (t124 * t177 + t277));
        let t326 = inverse_length
            * (t122 * t191 + t284 + (t123 * t194 + t285) + (t124 * t196 + t286));
        let t327 = inverse_length * (t69 * t139 + t79 * t140 + t82 * t138);
        let t328 = inverse_length
            * (t84 * t139 - t144 + (t91 * t140 - t146) + (t93 * t138 - t148));
        let t329 = inverse_length
            * (t220 + t104 * t139 + (t221 + t112 * t140) + (t222 + t114 * t138));
        let t330 = inverse_length
            * (t262 + t125 * t139 + (t263 + t133 * t140) + (t264 + t135 * t138));
        let t331 = inverse_length * inverse_length;
        let t332 = (t139 * t141 + t140 * t145 + t138 * t147) * t331;
        let t333 = (t139 * t151 + t140 * t154) * t331;
        let t334 = inverse_length
            * (t139 * t160 + t288 + (t289 - t140 * t162) + (t290 - t138 * t164));
        let t335 = (t139 * t172 + t140 * t175 + t138 * t177) * t331;
        let t336 = inverse_length * (t139 * t181 + t140 * t183);
        let t337 = (t139 * t191 + t140 * t194 + t138 * t196) * t331;
        let t338 = inverse_length * (t69 * t150 + t79 * t149);
        let t339 = inverse_length * (t84 * t150 - t153 + (t91 * t149 - t155));
        let t340 = inverse_length * (t224 + t104 * t150 + (t225 + t112 * t149));
        let t341 = inverse_length * (t266 + t125 * t150 + (t267 + t133 * t149));
        let t342 = (t141 * t150 + t145 * t149) * t331;
        let t343 = (t150 * t151 + t149 * t154) * t331;
        let t344 = inverse_length * (t150 * t160 - t149 * t162);
        let t345 = (t150 * t172 + t149 * t175) * t331;
        let t346 = inverse_length * (t150 * t181 + t291 + (t292 + t149 * t183));
        let t347 = (t150 * t191 + t149 * t194) * t331;
        let t348 = inverse_length
            * (t288 + t141 * t158 + (t289 - t145 * t159) + (t290 - t147 * t157));
        let t349 = inverse_length * (t151 * t158 - t154 * t159);
        let t350 = inverse_length
            * (t158 * t172 + t297 - (t159 * t175 - t298) - (t157 * t177 - t299));
        let t351 = inverse_length
            * (t158 * t191 + t302 - (t159 * t194 - t303) - (t157 * t196 - t304));
        let t352 = inverse_length * (t69 * t170 + t79 * t171 + t82 * t169);
        let t353 = inverse_length
            * (t233 + t104 * t170 + (t234 + t112 * t171) + (t235 + t114 * t169));
        let t354 = inverse_length
            * (t275 + t125 * t170 + (t276 + t133 * t171) + (t277 + t135 * t169));
        let t355 = (t141 * t170 + t145 * t171 + t147 * t169) * t331;
        let t356 = (t151 * t170 + t154 * t171) * t331;
        let t357 = inverse_length
            * (t297 + t160 * t170 + (t298 - t162 * t171) + (t299 - t164 * t169));
        let t358 = (t170 * t172 + t171 * t175 + t169 * t177) * t331;
        let t359 = inverse_length * (t170 * t181 + t306 + (t171 * t183 + t307));
        let t360 = (t170 * t191 + t171 * t194 + t169 * t196) * t331;
        let t361 = inverse_length * (t291 + t151 * t180 + (t292 + t154 * t179));
        let t362 = inverse_length * (t306 + t172 * t180 + (t307 + t175 * t179));
        let t363 = inverse_length * (t180 * t191 + t311 + (t312 + t179 * t194));
        let t364 = inverse_length * (t69 * t189 + t79 * t190 + t82 * t188);
        let t365 = inverse_length
            * (t240 + t104 * t189 + (t241 + t112 * t190) + (t242 + t114 * t188));
        let t366 = inverse_length
            * (t284 + t125 * t189 + (t285 + t133 * t190) + (t286 + t135 * t188));
        let t367 = (t141 * t189 + t145 * t190 + t147 * t188) * t331;
        let t368 = (t151 * t189 + t154 * t190) * t331;
        let t369 = inverse_length
            * (t302 + t160 * t189 + (t303 - t162 * t190) + (t304 - t164 * t188));
        let t370 = (t172 * t189 + t175 * t190 + t177 * t188) * t331;
        let t371 = inverse_length * (t311 + t181 * t189 + (t312 + t183 * t190));
        let t372 = (t189 * t191 + t190 * t194 + t188 * t196) * t331;
        let t373 = a_x * 2.0;
        let t374 = a_y * 2.0;
        let t375 = a_z * 2.0;
        let t376 = b_x * 2.0;
        let t377 = b_y * 2.0;
        let t378 = b_z * 2.0;
        let t379 = c_x * 2.0;
        let t380 = c_y * 2.0;
        let t381 = c_z * 2.0;
        let t382 = t94 * t373 + b_x * t115 + c_x * t136 + unit_db_x * t315
            + unit_dc_x * t316;
        let t383 = t94 * t374 + b_y * t115 + c_y * t136 + unit_db_y * t315
            + unit_dc_y * t316;
        let t384 = t94 * t375 + b_z * t115 + c_z * t136 + unit_db_z * t315
            + unit_dc_z * t316;
        let t385 = a_x * t115 + t165 * t376 + unit_dc_x * t317;
        let t386 = a_y * t115 + t165 * t377 + unit_dc_y * t317;
        let t387 = a_z * t115 + t165 * t378 + unit_dc_z * t317;
        let t388 = a_x * t136 + t184 * t379 + unit_db_x * t318;
        let t389 = a_y * t136 + t184 * t380 + unit_db_y * t318;
        let t390 = a_z * t136 + t184 * t381 + unit_db_z * t318;
        let t391 = a_x * t315 + c_x * t318;
        let t392 = a_y * t315 + c_y * t318;
        let t393 = a_z * t315 + c_z * t318;
        let t394 = a_x * t316 + b_x * t317;
        let t395 = a_y * t316 + b_y * t317;
        let t396 = a_z * t316 + b_z * t317;
        let t397 = t201 * t373 + b_x * t208 + c_x * t217 - unit_db_x * t319
            + unit_dc_x * t320;
        let t398 = t201 * t374 + b_y * t208 + c_y * t217 - unit_db_y * t319
            + unit_dc_y * t320;
        let t399 = t201 * t375 + b_z * t208 + c_z * t217 - unit_db_z * t319
            + unit_dc_z * t320;
        let t400 = a_x * t208 + t230 * t376 + unit_dc_x * t321;
        let t401 = a_y * t208 + t230 * t377 + unit_dc_y * t321;
        let t402 = a_z * t208 + t230 * t378 + unit_dc_z * t321;
        let t403 = a_x * t217 + t237 * t379 + unit_db_x * t322;
        let t404 = a_y * t217 + t237 * t380 + unit_db_y * t322;
        let t405 = a_z * t217 + t237 * t381 + unit_db_z * t322;
        let t406 = c_x * t322 - a_x * t319;
        let t407 = c_y * t322 - a_y * t319;
        let t408 = c_z * t322 - a_z * t319;
        let t409 = a_x * t320 + b_x * t321;
        let t410 = a_y * t320 + b_y * t321;
        let t411 = a_z * t320 + b_z * t321;
        let t412 = t247 * t373 + b_x * t252 + c_x * t259 - unit_db_x * t323
            + unit_dc_x * t324;
        let t413 = t247 * t374 + b_y * t252 + c_y * t259 - unit_db_y * t323
            + unit_dc_y * t324;
        let t414 = t247 * t375 + b_z * t252 + c_z * t259 - unit_db_z * t323
            + unit_dc_z * t324;
        let t415 = a_x * t252 + t272 * t376 + unit_dc_x * t325;
        let t416 = a_y * t252 + t272 * t377 + unit_dc_y * t325;
        let t417 = a_z * t252 + t272 * t378 + unit_dc_z * t325;
        let t418 = a_x * t259 + t281 * t379 + unit_db_x * t326;
        let t419 = a_y * t259 + t281 * t380 + unit_db_y * t326;
        let t420 = a_z * t259 + t281 * t381 + unit_db_z * t326;
        let t421 = c_x * t326 - a_x * t323;
        let t422 = c_y * t326 - a_y * t323;
        let t423 = c_z * t326 - a_z * t323;
        let t424 = a_x * t324 + b_x * t325;
        let t425 = a_y * t324 + b_y * t325;
        let t426 = a_z * t324 + b_z * t325;
        let t427 = unit_db_x * t332 - (t328 * t373 + b_x * t329 + c_x * t330)
            - unit_dc_x * t333;
        let t428 = unit_db_y * t332 - (t328 * t374 + b_y * t329 + c_y * t330)
            - unit_dc_y * t333;
        let t429 = unit_db_z * t332 - (t328 * t375 + b_z * t329 + c_z * t330)
            - unit_dc_z * t333;
        let t430 = a_x * t329 + t334 * t376 + unit_dc_x * t335;
        let t431 = a_y * t329 + t334 * t377 + unit_dc_y * t335;
        let t432 = a_z * t329 + t334 * t378 + unit_dc_z * t335;
        let t433 = a_x * t330 + t336 * t379 + unit_db_x * t337;
        let t434 = a_y * t330 + t336 * t380 + unit_db_y * t337;
        let t435 = a_z * t330 + t336 * t381 + unit_db_z * t337;
        let t436 = a_x * t332 - c_x * t337;
        let t437 = a_y * t332 - c_y * t337;
        let t438 = a_z * t332 - c_z * t337;
        let t439 = a_x * t333 + b_x * t335;
        let t440 = a_y * t333 + b_y * t335;
        let t441 = a_z * t333 + b_z * t335;
        let t442 = t339 * t373 + b_x * t340 + c_x * t341 - unit_db_x * t342
            + unit_dc_x * t343;
        let t443 = t339 * t374 + b_y * t340 + c_y * t341 - unit_db_y * t342
            + unit_dc_y * t343;
        let t444 = t339 * t375 + b_z * t340 + c_z * t341 - unit_db_z * t342
            + unit_dc_z * t343;
        let t445 = a_x * t340 + t344 * t376 + unit_dc_x * t345;
        let t446 = a_y * t340 + t344 * t377 + unit_dc_y * t345;
        let t447 = a_z * t340 + t344 * t378 + unit_dc_z * t345;
        let t448 = a_x * t341 + t346 * t379 + unit_db_x * t347;
        let t449 = a_y * t341 + t346 * t380 + unit_db_y * t347;
        let t450 = a_z * t341 + t346 * t381 + unit_db_z * t347;
        let t451 = c_x * t347 - a_x * t342;
        let t452 = c_y * t347 - a_y * t342;
        let t453 = c_z * t347 - a_z * t342;
        let t454 = a_x * t343 + b_x * t345;
        let t455 = a_y * t343 + b_y * t345;
        let t456 = a_z * t343 + b_z * t345;
        let t457 = a_x * t293 + t295 * t376 + unit_dc_x * t350;
        let t458 = a_y * t293 + t295 * t377 + unit_dc_y * t350;
        let t459 = a_z * t293 + t295 * t378 + unit_dc_z * t350;
        let t460 = a_x * t294 + t300 * t379 + unit_db_x * t351;
        let t461 = a_y * t294 + t300 * t380 + unit_db_y * t351;
        let t462 = a_z * t294 + t300 * t381 + unit_db_z * t351;
        let t463 = c_x * t351 - a_x * t348;
        let t464 = c_y * t351 - a_y * t348;
        let t465 = c_z * t351 - a_z * t348;
        let t466 = a_x * t349 + b_x * t350;
        let t467 = a_y * t349 + b_y * t350;
        let t468 = a_z * t349 + b_z * t350;
        let t469 = a_x * t353 + t357 * t376 + unit_dc_x * t358;
        let t470 = a_y * t353 + t357 * t377 + unit_dc_y * t358;
        let t471 = a_z * t353 + t357 * t378 + unit_dc_z * t358;
        let t472 = a_x * t354 + t359 * t379 + unit_db_x * t360;
        let t473 = a_y * t354 + t359 * t380 + unit_db_y * t360;
        let t474 = a_z * t354 + t359 * t381 + unit_db_z * t360;
        let t475 = c_x * t360 - a_x * t355;
        let t476 = c_y * t360 - a_y * t355;
        let t477 = c_z * t360 - a_z * t355;
        let t478 = a_x * t356 + b_x * t358;
        let t479 = a_y * t356 + b_y * t358;
        let t480 = a_z * t356 + b_z * t358;
        let t481 = a_x * t308 + t309 * t379 + unit_db_x * t363;
        let t482 = a_y * t308 + t309 * t380 + unit_db_y * t363;
        let t483 = a_z * t308 + t309 * t381 + unit_db_z * t363;
        let t484 = a_x * t361 + b_x * t362;
        let t485 = a_y * t361 + b_y * t362;
        let t486 = a_z * t361 + b_z * t362;
        let t487 = a_x * t365 + t369 * t376 + unit_dc_x * t370;
        let t488 = a_y * t365 + t369 * t377 + unit_dc_y * t370;
        let t489 = a_z * t365 + t369 * t378 + unit_dc_z * t370;
        let t490 = a_x * t366 + t371 * t379 + unit_db_x * t372;
        let t491 = a_y * t366 + t371 * t380 + unit_db_y * t372;
        let t492 = a_z * t366 + t371 * t381 + unit_db_z * t372;
        let t493 = c_x * t372 - a_x * t367;
        let t494 = c_y * t372 - a_y * t367;
        let t495 = c_z * t372 - a_z * t367;
        let t496 = a_x * t368 + b_x * t370;
        let t497 = a_y * t368 + b_y * t370;
        let t498 = a_z * t368 + b_z * t370;
        let t499 = t373 * t382 + b_x * t397 + c_x * t412 + unit_db_x * t427
            + unit_dc_x * t442;
        let t500 = t373 * t383 + b_x * t398 + c_x * t413 + unit_db_x * t428
            + unit_dc_x * t443;
        let t501 = t373 * t384 + b_x * t399 + c_x * t414 + unit_db_x * t429
            + unit_dc_x * t444;
        let t502 = t374 * t382 + b_y * t397 + c_y * t412 + unit_db_y * t427
            + unit_dc_y * t442;
        let t503 = t374 * t383 + b_y * t398 + c_y * t413 + unit_db_y * t428
            + unit_dc_y * t443;
        let t504 = t374 * t384 + b_y * t399 + c_y * t414 + unit_db_y * t429
            + unit_dc_y * t444;
        let t505 = t375 * t382 + b_z * t397 + c_z * t412 + unit_db_z * t427
            + unit_dc_z * t442;
        let t506 = t375 * t383 + b_z * t398 + c_z * t413 + unit_db_z * t428
            + unit_dc_z * t443;
        let t507 = t375 * t384 + b_z * t399 + c_z * t414 + unit_db_z * t429
            + unit_dc_z * t444;
        let t508 = t373 * t385 + b_x * t400 + c_x * t415 - unit_db_x * t430
            + unit_dc_x * t445;
        let t509 = t373 * t386 + b_x * t401 + c_x * t416 - unit_db_x * t431
            + unit_dc_x * t446;
        let t510 = t373 * t387 + b_x * t402 + c_x * t417 - unit_db_x * t432
            + unit_dc_x * t447;
        let t511 = t374 * t385 + b_y * t400 + c_y * t415 - unit_db_y * t430
            + unit_dc_y * t445;
        let t512 = t374 * t386 + b_y * t401 + c_y * t416 - unit_db_y * t431
            + unit_dc_y * t446;
        let t513 = t374 * t387 + b_y * t402 + c_y * t417 - unit_db_y * t432
            + unit_dc_y * t447;
        let t514 = t375 * t385 + b_z * t400 + c_z * t415 - unit_db_z * t430
            + unit_dc_z * t445;
        let t515 = t375 * t386 + b_z * t401 + c_z * t416 - unit_db_z * t431
            + unit_dc_z * t446;
        let t516 = t375 * t387 + b_z * t402 + c_z * t417 - unit_db_z * t432
            + unit_dc_z * t447;
        let t517 = t373 * t388 + b_x * t403 + c_x * t418 - unit_db_x * t433
            + unit_dc_x * t448;
        let t518 = t373 * t389 + b_x * t404 + c_x * t419 - unit_db_x * t434
            + unit_dc_x * t449;
        let t519 = t373 * t390 + b_x * t405 + c_x * t420 - unit_db_x * t435
            + unit_dc_x * t450;
        let t520 = t374 * t388 + b_y * t403 + c_y * t418 - unit_db_y * t433
            + unit_dc_y * t448;
        let t521 = t374 * t389 + b_y * t404 + c_y * t419 - unit_db_y * t434
            + unit_dc_y * t449;
        let t522 = t374 * t390 + b_y * t405 + c_y * t420 - unit_db_y * t435
            + unit_dc_y * t450;
        let t523 = t375 * t388 + b_z * t403 + c_z * t418 - unit_db_z * t433
            + unit_dc_z * t448;
        let t524 = t375 * t389 + b_z * t404 + c_z * t419 - unit_db_z * t434
            + unit_dc_z * t449;
        let t525 = t375 * t390 + b_z * t405 + c_z * t420 - unit_db_z * t435
            + unit_dc_z * t450;
        let t526 = t373 * t391 + b_x * t406 + c_x * t421 + unit_db_x * t436
            + unit_dc_x * t451;
        let t527 = t373 * t392 + b_x * t407 + c_x * t422 + unit_db_x * t437
            + unit_dc_x * t452;
        let t528 = t373 * t393 + b_x * t408 + c_x * t423 + unit_db_x * t438
            + unit_dc_x * t453;
        let t529 = t374 * t391 + b_y * t406 + c_y * t421 + unit_db_y * t436
            + unit_dc_y * t451;
        let t530 = t374 * t392 + b_y * t407 + c_y * t422 + unit_db_y * t437
            + unit_dc_y * t452;
        let t531 = t374 * t393 + b_y * t408 + c_y * t423 + unit_db_y * t438
            + unit_dc_y * t453;
        let t532 = t375 * t391 + b_z * t406 + c_z * t421 + unit_db_z * t436
            + unit_dc_z * t451;
        let t533 = t375 * t392 + b_z * t407 + c_z * t422 + unit_db_z * t437
            + unit_dc_z * t452;
        let t534 = t375 * t393 + b_z * t408 + c_z * t423 + unit_db_z * t438
            + unit_dc_z * t453;
        let t535 = t373 * t394 + b_x * t409 + c_x * t424 - unit_db_x * t439
            + unit_dc_x * t454;
        let t536 = t373 * t395 + b_x * t410 + c_x * t425 - unit_db_x * t440
            + unit_dc_x * t455;
        let t537 = t373 * t396 + b_x * t411 + c_x * t426 - unit_db_x * t441
            + unit_dc_x * t456;
        let t538 = t374 * t394 + b_y * t409 + c_y * t424 - unit_db_y * t439
            + unit_dc_y * t454;
        let t539 = t374 * t395 + b_y * t410 + c_y * t425 - unit_db_y * t440
            + unit_dc_y * t455;
        let t540 = t374 * t396 + b_y * t411 + c_y * t426 - unit_db_y * t441
            + unit_dc_y * t456;
        let t541 = t375 * t394 + b_z * t409 + c_z * t424 - unit_db_z * t439
            + unit_dc_z * t454;
        let t542 = t375 * t395 + b_z * t410 + c_z * t425 - unit_db_z * t440
            + unit_dc_z * t455;
        let t543 = t375 * t396 + b_z * t411 + c_z * t426 - unit_db_z * t441
            + unit_dc_z * t456;
        let t544 = 2.0 * (t69 * t76 + t79 * t80 + t82 * t83);
        let t545 = 2.0 * (t69 * t158 - t79 * t159 - t82 * t157);
        let t546 = 2.0 * (t69 * t180 + t79 * t179);
        stiffness[0][0] = t499 + t544;
        stiffness[0][1] = t500;
        stiffness[0][2] = t501;
        stiffness[0][3] = t502;
        stiffness[0][4] = t503 + t544;
        stiffness[0][5] = t504;
        stiffness[0][6] = t505;
        stiffness[0][7] = t506;
        stiffness[0][8] = t507 + t544;
        stiffness[1][0] = t313 + t508;
        stiffness[1][1] = t509;
        stiffness[1][2] = t510;
        stiffness[1][3] = t511;
        stiffness[1][4] = t313 + t512;
        stiffness[1][5] = t513;
        stiffness[1][6] = t514;
        stiffness[1][7] = t515;
        stiffness[1][8] = t313 + t516;
        stiffness[2][0] = t526 - t327;
        stiffness[2][1] = t527;
        stiffness[2][2] = t528;
        stiffness[2][3] = t529;
        stiffness[2][4] = t530 - t327;
        stiffness[2][5] = t531;
        stiffness[2][6] = t532;
        stiffness[2][7] = t533;
        stiffness[2][8] = t534 - t327;
        stiffness[3][0] = t314 + t517;
        stiffness[3][1] = t518;
        stiffness[3][2] = t519;
        stiffness[3][3] = t520;
        stiffness[3][4] = t314 + t521;
        stiffness[3][5] = t522;
        stiffness[3][6] = t523;
        stiffness[3][7] = t524;
        stiffness[3][8] = t314 + t525;
        stiffness[4][0] = t338 + t535;
        stiffness[4][1] = t536;
        stiffness[4][2] = t537;
        stiffness[4][3] = t538;
        stiffness[4][4] = t338 + t539;
        stiffness[4][5] = t540;
        stiffness[4][6] = t541;
        stiffness[4][7] = t542;
        stiffness[4][8] = t338 + t543;
        stiffness[5][0] = a_x * t400 + t376 * t457 + unit_dc_x * t469 + t545;
        stiffness[5][1] = a_x * t401 + t376 * t458 + unit_dc_x * t470;
        stiffness[5][2] = a_x * t402 + t376 * t459 + unit_dc_x * t471;
        stiffness[5][3] = a_y * t400 + t377 * t457 + unit_dc_y * t469;
        stiffness[5][4] = a_y * t401 + t377 * t458 + unit_dc_y * t470 + t545;
        stiffness[5][5] = a_y * t402 + t377 * t459 + unit_dc_y * t471;
        stiffness[5][6] = a_z * t400 + t378 * t457 + unit_dc_z * t469;
        stiffness[5][7] = a_z * t401 + t378 * t458 + unit_dc_z * t470;
        stiffness[5][8] = a_z * t402 + t378 * t459 + unit_dc_z * t471 + t545;
        stiffness[6][0] = a_x * t406 + t376 * t463 + unit_dc_x * t475;
        stiffness[6][1] = a_x * t407 + t376 * t464 + unit_dc_x * t476;
        stiffness[6][2] = a_x * t408 + t376 * t465 + unit_dc_x * t477;
        stiffness[6][3] = a_y * t406 + t377 * t463 + unit_dc_y * t475;
        stiffness[6][4] = a_y * t407 + t377 * t464 + unit_dc_y * t476;
        stiffness[6][5] = a_y * t408 + t377 * t465 + unit_dc_y * t477;
        stiffness[6][6] = a_z * t406 + t378 * t463 + unit_dc_z * t475;
        stiffness[6][7] = a_z * t407 + t378 * t464 + unit_dc_z * t476;
        stiffness[6][8] = a_z * t408 + t378 * t465 + unit_dc_z * t477;
        stiffness[7][0] = c_x * t487 - a_x * t430;
        stiffness[7][1] = c_x * t488 - a_x * t431;
        stiffness[7][2] = c_x * t489 - a_x * t432;
        stiffness[7][3] = c_y * t487 - a_y * t430;
        stiffness[7][4] = c_y * t488 - a_y * t431;
        stiffness[7][5] = c_y * t489 - a_y * t432;
        stiffness[7][6] = c_z * t487 - a_z * t430;
        stiffness[7][7] = c_z * t488 - a_z * t431;
        stiffness[7][8] = c_z * t489 - a_z * t432;
        stiffness[8][0] = a_x * t436 + c_x * t493;
        stiffness[8][1] = a_x * t437 + c_x * t494;
        stiffness[8][2] = a_x * t438 + c_x * t495;
        stiffness[8][3] = a_y * t436 + c_y * t493;
        stiffness[8][4] = a_y * t437 + c_y * t494;
        stiffness[8][5] = a_y * t438 + c_y * t495;
        stiffness[8][6] = a_z * t436 + c_z * t493;
        stiffness[8][7] = a_z * t437 + c_z * t494;
        stiffness[8][8] = a_z * t438 + c_z * t495;
        stiffness[9][0] = a_x * t403 + t376 * t460 + unit_dc_x * t472;
        stiffness[9][1] = a_x * t404 + t376 * t461 + unit_dc_x * t473;
        stiffness[9][2] = a_x * t405 + t376 * t462 + unit_dc_x * t474;
        stiffness[9][3] = a_y * t403 + t377 * t460 + unit_dc_y * t472;
        stiffness[9][4] = a_y * t404 + t377 * t461 + unit_dc_y * t473;
        stiffness[9][5] = a_y * t405 + t377 * t462 + unit_dc_y * t474;
        stiffness[9][6] = a_z * t403 + t378 * t460 + unit_dc_z * t472;
        stiffness[9][7] = a_z * t404 + t378 * t461 + unit_dc_z * t473;
        stiffness[9][8] = a_z * t405 + t378 * t462 + unit_dc_z * t474;
        stiffness[10][0] = t352 + (a_x * t409 + t376 * t466 + unit_dc_x * t478);
        stiffness[10][1] = a_x * t410 + t376 * t467 + unit_dc_x * t479;
        stiffness[10][2] = a_x * t411 + t376 * t468 + unit_dc_x * t480;
        stiffness[10][3] = a_y * t409 + t377 * t466 + unit_dc_y * t478;
        stiffness[10][4] = t352 + (a_y * t410 + t377 * t467 + unit_dc_y * t479);
        stiffness[10][5] = a_y * t411 + t377 * t468 + unit_dc_y * t480;
        stiffness[10][6] = a_z * t409 + t378 * t466 + unit_dc_z * t478;
        stiffness[10][7] = a_z * t410 + t378 * t467 + unit_dc_z * t479;
        stiffness[10][8] = t352 + (a_z * t411 + t378 * t468 + unit_dc_z * t480);
        stiffness[11][0] = t364 + (c_x * t490 - a_x * t433);
        stiffness[11][1] = c_x * t491 - a_x * t434;
        stiffness[11][2] = c_x * t492 - a_x * t435;
        stiffness[11][3] = c_y * t490 - a_y * t433;
        stiffness[11][4] = t364 + (c_y * t491 - a_y * t434);
        stiffness[11][5] = c_y * t492 - a_y * t435;
        stiffness[11][6] = c_z * t490 - a_z * t433;
        stiffness[11][7] = c_z * t491 - a_z * t434;
        stiffness[11][8] = t364 + (c_z * t492 - a_z * t435);
        stiffness[12][0] = c_x * t496 - a_x * t439;
        stiffness[12][1] = c_x * t497 - a_x * t440;
        stiffness[12][2] = c_x * t498 - a_x * t441;
        stiffness[12][3] = c_y * t496 - a_y * t439;
        stiffness[12][4] = c_y * t497 - a_y * t440;
        stiffness[12][5] = c_y * t498 - a_y * t441;
        stiffness[12][6] = c_z * t496 - a_z * t439;
        stiffness[12][7] = c_z * t497 - a_z * t440;
        stiffness[12][8] = c_z * t498 - a_z * t441;
        stiffness[13][0] = a_x * t418 + t379 * t481 + unit_db_x * t490 + t546;
        stiffness[13][1] = a_x * t419 + t379 * t482 + unit_db_x * t491;
        stiffness[13][2] = a_x * t420 + t379 * t483 + unit_db_x * t492;
        stiffness[13][3] = a_y * t418 + t380 * t481 + unit_db_y * t490;
        stiffness[13][4] = a_y * t419 + t380 * t482 + unit_db_y * t491 + t546;
        stiffness[13][5] = a_y * t420 + t380 * t483 + unit_db_y * t492;
        stiffness[13][6] = a_z * t418 + t381 * t481 + unit_db_z * t490;
        stiffness[13][7] = a_z * t419 + t381 * t482 + unit_db_z * t491;
        stiffness[13][8] = a_z * t420 + t381 * t483 + unit_db_z * t492 + t546;
        stiffness[14][0] = a_x * t424 + t379 * t484 + unit_db_x * t496;
        stiffness[14][1] = a_x * t425 + t379 * t485 + unit_db_x * t497;
        stiffness[14][2] = a_x * t426 + t379 * t486 + unit_db_x * t498;
        stiffness[14][3] = a_y * t424 + t380 * t484 + unit_db_y * t496;
        stiffness[14][4] = a_y * t425 + t380 * t485 + unit_db_y * t497;
        stiffness[14][5] = a_y * t426 + t380 * t486 + unit_db_y * t498;
        stiffness[14][6] = a_z * t424 + t381 * t484 + unit_db_z * t496;
        stiffness[14][7] = a_z * t425 + t381 * t485 + unit_db_z * t497;
        stiffness[14][8] = a_z * t426 + t381 * t486 + unit_db_z * t498;
        stiffness[15][0] = a_x * t448 + b_x * t472;
        stiffness[15][1] = a_x * t449 + b_x * t473;
        stiffness[15][2] = a_x * t450 + b_x * t474;
        stiffness[15][3] = a_y * t448 + b_y * t472;
        stiffness[15][4] = a_y * t449 + b_y * t473;
        stiffness[15][5] = a_y * t450 + b_y * t474;
        stiffness[15][6] = a_z * t448 + b_z * t472;
        stiffness[15][7] = a_z * t449 + b_z * t473;
        stiffness[15][8] = a_z * t450 + b_z * t474;
        stiffness[16][0] = a_x * t454 + b_x * t478;
        stiffness[16][1] = a_x * t455 + b_x * t479;
        stiffness[16][2] = a_x * t456 + b_x * t480;
        stiffness[16][3] = a_y * t454 + b_y * t478;
        stiffness[16][4] = a_y * t455 + b_y * t479;
        stiffness[16][5] = a_y * t456 + b_y * t480;
        stiffness[16][6] = a_z * t454 + b_z * t478;
        stiffness[16][7] = a_z * t455 + b_z * t479;
        stiffness[16][8] = a_z * t456 + b_z * t480;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated at 2 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 45 additions, 68 multiplications, 3 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
    /// Operations: 26 additions, 47 multiplications, 1 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points3_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t31 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t32 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t33 = a_x * a_x + a_y * a_y + a_z * a_z - (t31 * t31 + t32 * t32);
        let t34 = t33.sqrt();
        let t35 = length * reference[6]
            * (t34 - 1.0 + t31 * reference[18] + t32 * reference[22] - reference[0]);
        let t36 = 1.0 / (2.0 * t34);
        let t37 = t35 * t36;
        let t38 = length * reference[7] * (t31 + t32 * reference[23] - reference[1]);
        let t39 = t35 * (reference[18] - t36 * (t31 * 2.0)) + t38;
        let t40 = t35 * (reference[22] - t36 * (t32 * 2.0)) + reference[23] * t38
            + length * reference[8] * (t32 - reference[2]);
        forces[0][0] = t37 * (a_x * 2.0) + b_x * t39 + c_x * t40;
        forces[0][1] = t37 * (a_y * 2.0) + b_y * t39 + c_y * t40;
        forces[0][2] = t37 * (a_z * 2.0) + b_z * t39 + c_z * t40;
        forces[1][0] = a_x * t39;
        forces[1][1] = a_y * t39;
        forces[1][2] = a_z * t39;
        forces[2][0] = a_x * t40;
        forces[2][1] = a_y * t40;
        forces[2][2] = a_z * t40;
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 117 additions, 221 multiplications, 4 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points3_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t31 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t32 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t33 = a_x * a_x + a_y * a_y + a_z * a_z - (t31 * t31 + t32 * t32);
        let t34 = t33.sqrt();
        let t35 = length * reference[6];
        let t36 = t35
            * (t34 - 1.0 + t31 * reference[18] + t32 * reference[22] - reference[0]);
        let t37 = 2.0 * t34;
        let t38 = 1.0 / t37;
        let t39 = t35 * t38;
        let t40 = 2.0 * t38;
        let t41 = t38 * t40 / t37;
        let t42 = t38 * t39 - t36 * t41;
        let t43 = t31 * 2.0;
        let t44 = t38 * t43;
        let t45 = reference[18] - t44;
        let t46 = t35 * t45;
        let t47 = t38 * (2.0 * t44) / t37;
        let t48 = t38 * t46 + t36 * t47;
        let t49 = t32 * 2.0;
        let t50 = t38 * t49;
        let t51 = reference[22] - t50;
        let t52 = t35 * t51;
        let t53 = t38 * (2.0 * t50) / t37;
        let t54 = t38 * t52 + t36 * t53;
        let t55 = t39 * t45 + t36 * (t41 * t43);
        let t56 = length * reference[7];
        let t57 = t56 + (t45 * t46 - t36 * (t40 + t43 * t47));
        let t58 = reference[23] * t56;
        let t59 = t45 * t52 - t36 * (t43 * t53) + t58;
        let t60 = t39 * t51 + t36 * (t41 * t49);
        let t61 = t58 + (t46 * t51 - t36 * (t47 * t49));
        let t62 = length * reference[8];
        let t63 = t62 + (t51 * t52 - t36 * (t40 + t49 * t53) + reference[23] * t58);
        let t64 = t56 * (t31 + t32 * reference[23] - reference[1]);
        let t65 = t36 * t45 + t64;
        let t66 = t36 * t51 + reference[23] * t64 + t62 * (t32 - reference[2]);
        let t67 = a_x * 2.0;
        let t68 = a_y * 2.0;
        let t69 = a_z * 2.0;
        let t70 = t42 * t67 + b_x * t48 + c_x * t54;
        let t71 = t42 * t68 + b_y * t48 + c_y * t54;
        let t72 = t42 * t69 + b_z * t48 + c_z * t54;
        let t73 = a_x * t48;
        let t74 = a_y * t48;
        let t75 = a_z * t48;
        let t76 = a_x * t54;
        let t77 = a_y * t54;
        let t78 = a_z * t54;
        let t79 = t55 * t67 + b_x * t57 + c_x * t59;
        let t80 = t55 * t68 + b_y * t57 + c_y * t59;
        let t81 = t55 * t69 + b_z * t57 + c_z * t59;
        let t82 = a_x * t57;
        let t83 = a_y * t57;
        let t84 = a_z * t57;
        let t85 = a_x * t59;
        let t86 = a_y * t59;
        let t87 = a_z * t59;
        let t88 = t60 * t67 + b_x * t61 + c_x * t63;
        let t89 = t60 * t68 + b_y * t61 + c_y * t63;
        let t90 = t60 * t69 + b_z * t61 + c_z * t63;
        let t91 = a_x * t61;
        let t92 = a_y * t61;
        let t93 = a_z * t61;
        let t94 = a_x * t63;
        let t95 = a_y * t63;
        let t96 = a_z * t63;
        let t97 = 2.0 * (t36 * t38);
        stiffness[0][0] = t67 * t70 + b_x * t79 + c_x * t88 + t97;
        stiffness[0][1] = t67 * t71 + b_x * t80 + c_x * t89;
        stiffness[0][2] = t67 * t72 + b_x * t81 + c_x * t90;
        stiffness[0][3] = t68 * t70 + b_y * t79 + c_y * t88;
        stiffness[0][4] = t68 * t71 + b_y * t80 + c_y * t89 + t97;
        stiffness[0][5] = t68 * t72 + b_y * t81 + c_y * t90;
        stiffness[0][6] = t69 * t70 + b_z * t79 + c_z * t88;
        stiffness[0][7] = t69 * t71 + b_z * t80 + c_z * t89;
        stiffness[0][8] = t69 * t72 + b_z * t81 + c_z * t90 + t97;
        stiffness[1][0] = t65 + (t67 * t73 + b_x * t82 + c_x * t91);
        stiffness[1][1] = t67 * t74 + b_x * t83 + c_x * t92;
        stiffness[1][2] = t67 * t75 + b_x * t84 + c_x * t93;
        stiffness[1][3] = t68 * t73 + b_y * t82 + c_y * t91;
        stiffness[1][4] = t65 + (t68 * t74 + b_y * t83 + c_y * t92);
        stiffness[1][5] = t68 * t75 + b_y * t84 + c_y * t93;
        stiffness[1][6] = t69 * t73 + b_z * t82 + c_z * t91;
        stiffness[1][7] = t69 * t74 + b_z * t83 + c_z * t92;
        stiffness[1][8] = t65 + (t69 * t75 + b_z * t84 + c_z * t93);
        stiffness[2][0] = t66 + (t67 * t76 + b_x * t85 + c_x * t94);
        stiffness[2][1] = t67 * t77 + b_x * t86 + c_x * t95;
        stiffness[2][2] = t67 * t78 + b_x * t87 + c_x * t96;
        stiffness[2][3] = t68 * t76 + b_y * t85 + c_y * t94;
        stiffness[2][4] = t66 + (t68 * t77 + b_y * t86 + c_y * t95);
        stiffness[2][5] = t68 * t78 + b_y * t87 + c_y * t96;
        stiffness[2][6] = t69 * t76 + b_z * t85 + c_z * t94;
        stiffness[2][7] = t69 * t77 + b_z * t86 + c_z * t95;
        stiffness[2][8] = t66 + (t69 * t78 + b_z * t87 + c_z * t96);
        stiffness[3][0] = a_x * t82;
        stiffness[3][1] = a_x * t83;
        stiffness[3][2] = a_x * t84;
        stiffness[3][3] = a_y * t82;
        stiffness[3][4] = a_y * t83;
        stiffness[3][5] = a_y * t84;
        stiffness[3][6] = a_z * t82;
        stiffness[3][7] = a_z * t83;
        stiffness[3][8] = a_z * t84;
        stiffness[4][0] = a_x * t85;
        stiffness[4][1] = a_x * t86;
        stiffness[4][2] = a_x * t87;
        stiffness[4][3] = a_y * t85;
        stiffness[4][4] = a_y * t86;
        stiffness[4][5] = a_y * t87;
        stiffness[4][6] = a_z * t85;
        stiffness[4][7] = a_z * t86;
        stiffness[4][8] = a_z * t87;
        stiffness[5][0] = a_x * t94;
        stiffness[5][1] = a_x * t95;
        stiffness[5][2] = a_x * t96;
        stiffness[5][3] = a_y * t94;
        stiffness[5][4] = a_y * t95;
        stiffness[5][5] = a_y * t96;
        stiffness[5][6] = a_z * t94;
        stiffness[5][7] = a_z * t95;
        stiffness[5][8] = a_z * t96;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated at 3 Gauss points; fields are derivatives on the unit element.
    ///
    /// Operations: 17 additions, 26 multiplications, 1 function calls.
    pub fn full_beam_spatial_curved_points3_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
    /// Operations: 17 additions, 36 multiplications.
    pub fn full_beam_spatial_curved_nodes3_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        forces: &mut [[f64; 3]; 2],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t24 = length * reference[24];
        let t25 = t24 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[0]);
        let t26 = 0.5 * t25;
        let t27 = length * reference[25]
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[2]);
        let t28 = t24 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[1]);
        let t29 = 0.5 * t28;
        forces[0][0] = t26 * (b_x * 2.0) + c_x * t27;
        forces[0][1] = t26 * (b_y * 2.0) + c_y * t27;
        forces[0][2] = t26 * (b_z * 2.0) + c_z * t27;
        forces[1][0] = b_x * t27 + t29 * (c_x * 2.0);
        forces[1][1] = b_y * t27 + t29 * (c_y * 2.0);
        forces[1][2] = b_z * t27 + t29 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields b, c at a point of weight one on the unit element, for the terms that are integrated at 3 nodes; fields are derivatives on the unit element.
    ///
    /// Operations: 32 additions, 73 multiplications.
    pub fn full_beam_spatial_curved_nodes3_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        stiffness: &mut [[f64; 9]; 3],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t24 = length * reference[24];
        let t25 = 0.5 * (0.5 * t24);
        let t26 = length * reference[25];
        let t27 = t24 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[0]);
        let t28 = t26 * (b_x * c_x + b_y * c_y + b_z * c_z - reference[2]);
        let t29 = t24 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[1]);
        let t30 = b_x * 2.0;
        let t31 = b_y * 2.0;
        let t32 = b_z * 2.0;
        let t33 = c_x * 2.0;
        let t34 = c_y * 2.0;
        let t35 = c_z * 2.0;
        let t36 = t25 * t31;
        let t37 = t25 * t32;
        let t38 = c_y * t26;
        let t39 = c_z * t26;
        let t40 = b_x * t26;
        let t41 = b_y * t26;
        let t42 = b_z * t26;
        let t43 = t25 * t34;
        let t44 = t25 * t35;
        let t45 = t30 * t36 + c_x * t38;
        let t46 = t30 * t37 + c_x * t39;
        let t47 = t31 * t37 + c_y * t39;
        let t48 = b_x * t41 + t33 * t43;
        let t49 = b_x * t42 + t33 * t44;
        let t50 = b_y * t42 + t34 * t44;
        let t51 = 0.5 * t27 * 2.0;
        let t52 = 0.5 * t29 * 2.0;
        stiffness[0][0] = t30 * (t25 * t30) + c_x * (c_x * t26) + t51;
        stiffness[0][1] = t45;
        stiffness[0][2] = t46;
        stiffness[0][3] = t45;
        stiffness[0][4] = t31 * t36 + c_y * t38 + t51;
        stiffness[0][5] = t47;
        stiffness[0][6] = t46;
        stiffness[0][7] = t47;
        stiffness[0][8] = t32 * t37 + c_z * t39 + t51;
        stiffness[1][0] = t28 + c_x * t40;
        stiffness[1][1] = c_x * t41;
        stiffness[1][2] = c_x * t42;
        stiffness[1][3] = c_y * t40;
        stiffness[1][4] = t28 + c_y * t41;
        stiffness[1][5] = c_y * t42;
        stiffness[1][6] = c_z * t40;
        stiffness[1][7] = c_z * t41;
        stiffness[1][8] = t28 + c_z * t42;
        stiffness[2][0] = b_x * t40 + t33 * (t25 * t33) + t52;
        stiffness[2][1] = t48;
        stiffness[2][2] = t49;
        stiffness[2][3] = t48;
        stiffness[2][4] = b_y * t41 + t34 * t43 + t52;
        stiffness[2][5] = t50;
        stiffness[2][6] = t49;
        stiffness[2][7] = t50;
        stiffness[2][8] = b_z * t42 + t35 * t44 + t52;
    }
    /// Writes the strain energy b, c at a point of weight one on the unit element, for the terms that are integrated at 3 nodes; fields are derivatives on the unit element.
    ///
    /// Operations: 13 additions, 21 multiplications.
    pub fn full_beam_spatial_curved_nodes3_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 26],
        fields: &[[f64; 3]; 2],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
    /// Operations: 819 additions, 1119 multiplications, 33 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_elastic_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 208],
        q: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        FULL_BEAM_SPATIAL_CURVED_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| full_beam_spatial_curved_points2_force(
                    row,
                    ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| full_beam_spatial_curved_points3_force(
                    row,
                    ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_NODES3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| full_beam_spatial_curved_nodes3_force(
                    row,
                    ::rncf::emitted::array(&reference[130 + 26 * point..][..26]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        FULL_BEAM_SPATIAL_CURVED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 Gauss points and 3 Gauss points and 3 nodes, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 7685 additions, 9190 multiplications, 114 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_elastic_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 208],
        q: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 9]; 6];
        FULL_BEAM_SPATIAL_CURVED_POINTS2
            .tangent(
                &vectors,
                (&FULL_BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| full_beam_spatial_curved_points2_tangent(
                    row,
                    ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                    fields,
                    stiffness,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_POINTS3
            .tangent(
                &vectors,
                (&FULL_BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| full_beam_spatial_curved_points3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                    fields,
                    stiffness,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_NODES3
            .tangent(
                &vectors,
                (&FULL_BEAM_SPATIAL_CURVED_NODES3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| full_beam_spatial_curved_nodes3_tangent(
                    row,
                    ::rncf::emitted::array(&reference[130 + 26 * point..][..26]),
                    fields,
                    stiffness,
                ),
            );
        FULL_BEAM_SPATIAL_CURVED_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled; .
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 Gauss points and 3 Gauss points and 3 nodes, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 413 additions, 510 multiplications, 6 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_strain_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 208],
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = FULL_BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        *energy
            += FULL_BEAM_SPATIAL_CURVED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_points2_energy(
                            row,
                            ::rncf::emitted::array(&reference[0 + 26 * point..][..26]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += FULL_BEAM_SPATIAL_CURVED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_points3_energy(
                            row,
                            ::rncf::emitted::array(&reference[52 + 26 * point..][..26]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += FULL_BEAM_SPATIAL_CURVED_NODES3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        full_beam_spatial_curved_nodes3_energy(
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
    pub fn full_beam_spatial_curved_reference(
        row: &FullBeamSpatialCurved,
        q: &[f64; 30],
        reference: &mut [f64; 208],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
    pub fn full_beam_spatial_curved_shapes_position_0(
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
    pub fn full_beam_spatial_curved_shapes_position_1(
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
    pub fn full_beam_spatial_curved_shapes_section_y_0(
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
    pub fn full_beam_spatial_curved_shapes_section_y_1(
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
    pub fn full_beam_spatial_curved_shapes_section_z_0(
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
    pub fn full_beam_spatial_curved_shapes_section_z_1(
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
    /// Operations: 320 additions, 469 multiplications, 35 divisions, 2 function calls.
    pub fn full_beam_spatial_curved_field_forces(
        row: &FullBeamSpatialCurved,
        coefficients: &[f64; 23],
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [D1, D2, D3, D4, D5, D6, L21, L31, L32, L41, L42, L43, L51, L52, L53, L54,
        L61, L62, L63, L64, L65, held, half_held] = *coefficients;
        let t63 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t64 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8];
        let t65 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
            - (t63 * t63 + t64 * t64);
        let t66 = t65.sqrt();
        let t67 = t66 - 1.0;
        let t68 = fields[6] * fields[9] + fields[7] * fields[10] + fields[8] * fields[11]
            - (fields[3] * fields[12] + fields[4] * fields[13] + fields[5] * fields[14]);
        let t69 = 0.5 * t68;
        let t70 = 1.0
            - 0.5
                * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                    - 1.0);
        let t71 = 1.0
            - 0.5
                * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                    - 1.0);
        let t72 = t70 * t71;
        let t73 = (fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14] + t63 * t69) / t66;
        let t74 = t71 * t73;
        let t75 = (fields[0] * fields[9] + fields[1] * fields[10]
            + fields[2] * fields[11] - t64 * t69) / t66;
        let t76 = t70 * t75;
        let t77 = t69 * t72 + t74 * L21 - t76 * L31 + t67 * L41 + t63 * L51;
        let t78 = stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
            + stress_free[2] * stress_free[5];
        let t79 = stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
            + stress_free[2] * stress_free[8];
        let t80 = stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
            + stress_free[2] * stress_free[2] - (t78 * t78 + t79 * t79);
        let t81 = t80.sqrt();
        let t82 = t81 - 1.0;
        let t83 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11]
            - (stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
                + stress_free[5] * stress_free[14]);
        let t84 = 0.5 * t83;
        let t85 = 1.0
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t86 = 1.0
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t87 = t86
            * ((stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14] + t78 * t84) / t81);
        let t88 = t85
            * ((stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11] - t79 * t84) / t81);
        let t89 = t84 * (t85 * t86) + L21 * t87 - L31 * t88 + L41 * t82 + L51 * t78;
        let t90 = D1 * (t77 + t64 * L61 - (t89 + L61 * t79));
        let t91 = t63 * 2.0;
        let t92 = t64 * 2.0;
        let t93 = 1.0 / (t66 * 2.0);
        let t94 = (fields[0] * 2.0 - (fields[3] * t91 + fields[6] * t92)) * t93;
        let t95 = t71 * ((fields[12] + fields[3] * t69 - t73 * t94) / t66);
        let t96 = t70 * ((fields[9] - fields[6] * t69 - t75 * t94) / t66);
        let t97 = L21 * t95 - L31 * t96 + L41 * t94 + fields[3] * L51 + fields[6] * L61;
        let t98 = t93 * (fields[1] * 2.0 - (fields[4] * t91 + fields[7] * t92));
        let t99 = t71 * ((fields[13] + fields[4] * t69 - t73 * t98) / t66);
        let t100 = t70 * ((fields[10] - fields[7] * t69 - t75 * t98) / t66);
        let t101 = L21 * t99 - L31 * t100 + L41 * t98 + fields[4] * L51
            + fields[7] * L61;
        let t102 = t93 * (fields[2] * 2.0 - (fields[5] * t91 + fields[8] * t92));
        let t103 = t71 * ((fields[14] + fields[5] * t69 - t73 * t102) / t66);
        let t104 = t70 * ((fields[11] - fields[8] * t69 - t75 * t102) / t66);
        let t105 = L21 * t103 - L31 * t104 + L41 * t102 + fields[5] * L51
            + fields[8] * L61;
        let t106 = 0.5 * (fields[3] * 2.0);
        let t107 = t93 * (fields[0] * t91);
        let t108 = fields[12] * 0.5;
        let t109 = fields[0] * t69;
        let t110 = t71 * ((t109 - t63 * t108 + t73 * t107) / t66);
        let t111 = t70 * ((t64 * t108 + t75 * t107) / t66) - t75 * t106;
        let t112 = L21 * t110 - (t72 * t108 + t69 * (t71 * t106)) - L31 * t111
            - L41 * t107;
        let t113 = 0.5 * (fields[4] * 2.0);
        let t114 = t93 * (fields[1] * t91);
        let t115 = fields[13] * 0.5;
        let t116 = fields[1] * t69;
        let t117 = t71 * ((t116 - t63 * t115 + t73 * t114) / t66);
        let t118 = t70 * ((t64 * t115 + t75 * t114) / t66) - t75 * t113;
        let t119 = L21 * t117 - (t72 * t115 + t69 * (t71 * t113)) - L31 * t118
            - L41 * t114;
        let t120 = 0.5 * (fields[5] * 2.0);
        let t121 = t93 * (fields[2] * t91);
        let t122 = fields[14] * 0.5;
        let t123 = fields[2] * t69;
        let t124 = t71 * ((t123 - t63 * t122 + t73 * t121) / t66);
        let t125 = t70 * ((t64 * t122 + t75 * t121) / t66) - t75 * t120;
        let t126 = L21 * t124 - (t72 * t122 + t69 * (t71 * t120)) - L31 * t125
            - L41 * t121;
        let t127 = 0.5 * (fields[6] * 2.0);
        let t128 = t93 * (fields[0] * t92);
        let t129 = fields[9] * 0.5;
        let t130 = t71 * ((t63 * t129 + t73 * t128) / t66) - t73 * t127;
        let t131 = t70 * ((t75 * t128 - (t109 + t64 * t129)) / t66);
        let t132 = t72 * t129 - t69 * (t70 * t127) + L21 * t130 - L31 * t131
            - L41 * t128;
        let t133 = 0.5 * (fields[7] * 2.0);
        let t134 = t93 * (fields[1] * t92);
        let t135 = fields[10] * 0.5;
        let t136 = t71 * ((t63 * t135 + t73 * t134) / t66) - t73 * t133;
        let t137 = t70 * ((t75 * t134 - (t116 + t64 * t135)) / t66);
        let t138 = t72 * t135 - t69 * (t70 * t133) + L21 * t136 - L31 * t137
            - L41 * t134;
        let t139 = 0.5 * (fields[8] * 2.0);
        let t140 = t93 * (fields[2] * t92);
        let t141 = fields[11] * 0.5;
        let t142 = t71 * ((t63 * t141 + t73 * t140) / t66) - t73 * t139;
        let t143 = t70 * ((t75 * t140 - (t123 + t64 * t141)) / t66);
        let t144 = t72 * t141 - t69 * (t70 * t139) + L21 * t142 - L31 * t143
            - L41 * t140;
        let t145 = fields[6] * 0.5;
        let t146 = t71 * (t63 * t145 / t66);
        let t147 = t70 * ((fields[0] - t64 * t145) / t66);
        let t148 = fields[7] * 0.5;
        let t149 = t71 * (t63 * t148 / t66);
        let t150 = t70 * ((fields[1] - t64 * t148) / t66);
        let t151 = fields[8] * 0.5;
        let t152 = t71 * (t63 * t151 / t66);
        let t153 = t70 * ((fields[2] - t64 * t151) / t66);
        let t154 = fields[3] * 0.5;
        let t155 = t71 * ((fields[0] - t63 * t154) / t66);
        let t156 = t70 * (t64 * t154 / t66);
        let t157 = fields[4] * 0.5;
        let t158 = t71 * ((fields[1] - t63 * t157) / t66);
        let t159 = t70 * (t64 * t157 / t66);
        let t160 = fields[5] * 0.5;
        let t161 = t71 * ((fields[2] - t63 * t160) / t66);
        let t162 = t70 * (t64 * t160 / t66);
        let t163 = t74 - t76 * L32 + t67 * L42 + t63 * L52 + t64 * L62
            - (t87 - L32 * t88 + L42 * t82 + L52 * t78 + L62 * t79);
        let t164 = D2 * t163;
        let t165 = t164
            * (t95 - L32 * t96 + L42 * t94 + fields[3] * L52 + fields[6] * L62);
        let t166 = t164
            * (t99 - L32 * t100 + L42 * t98 + fields[4] * L52 + fields[7] * L62);
        let t167 = t164
            * (t103 - L32 * t104 + L42 * t102 + fields[5] * L52 + fields[8] * L62);
        let t168 = t90 * (t112 + fields[0] * L51)
            + t164 * (t110 - L32 * t111 - L42 * t107 + fields[0] * L52);
        let t169 = t90 * (t119 + fields[1] * L51)
            + t164 * (t117 - L32 * t118 - L42 * t114 + fields[1] * L52);
        let t170 = t90 * (t126 + fields[2] * L51)
            + t164 * (t124 - L32 * t125 - L42 * t121 + fields[2] * L52);
        let t171 = t90 * (t132 + fields[0] * L61)
            + t164 * (t130 - L32 * t131 - L42 * t128 + fields[0] * L62);
        let t172 = t90 * (t138 + fields[1] * L61)
            + t164 * (t136 - L32 * t137 - L42 * t134 + fields[1] * L62);
        let t173 = t90 * (t144 + fields[2] * L61)
            + t164 * (t142 - L32 * t143 - L42 * t140 + fields[2] * L62);
        let t174 = t90 * (t72 * t145 + L21 * t146 - L31 * t147)
            + t164 * (t146 - L32 * t147);
        let t175 = t90 * (t72 * t148 + L21 * t149 - L31 * t150)
            + t164 * (t149 - L32 * t150);
        let t176 = t90 * (t72 * t151 + L21 * t152 - L31 * t153)
            + t164 * (t152 - L32 * t153);
        let t177 = t90 * (L21 * t155 - t72 * t154 - L31 * t156)
            + t164 * (t155 - L32 * t156);
        let t178 = t90 * (L21 * t158 - t72 * t157 - L31 * t159)
            + t164 * (t158 - L32 * t159);
        let t179 = t90 * (L21 * t161 - t72 * t160 - L31 * t162)
            + t164 * (t161 - L32 * t162);
        let t180 = t67 * L43 - t76 + t63 * L53 + t64 * L63
            - (L43 * t82 - t88 + L53 * t78 + L63 * t79);
        let t181 = D3 * t180;
        let t182 = t90 * t97 + t165
            + t181 * (L43 * t94 - t96 + fields[3] * L53 + fields[6] * L63);
        let t183 = t90 * t101 + t166
            + t181 * (L43 * t98 - t100 + fields[4] * L53 + fields[7] * L63);
        let t184 = t90 * t105 + t167
            + t181 * (L43 * t102 - t104 + fields[5] * L53 + fields[8] * L63);
        let t185 = t67 + t63 * L54 + t64 * L64 - (t82 + L54 * t78 + L64 * t79);
        let t186 = D4 * t185;
        let t187 = t168 + t181 * (fields[0] * L53 - (t111 + L43 * t107))
            + t186 * (fields[0] * L54 - t107);
        let t188 = t169 + t181 * (fields[1] * L53 - (t118 + L43 * t114))
            + t186 * (fields[1] * L54 - t114);
        let t189 = t170 + t181 * (fields[2] * L53 - (t125 + L43 * t121))
            + t186 * (fields[2] * L54 - t121);
        let t190 = t171 + t181 * (fields[0] * L63 - (t131 + L43 * t128))
            + t186 * (fields[0] * L64 - t128);
        let t191 = t172 + t181 * (fields[1] * L63 - (t137 + L43 * t134))
            + t186 * (fields[1] * L64 - t134);
        let t192 = t173 + t181 * (fields[2] * L63 - (t143 + L43 * t140))
            + t186 * (fields[2] * L64 - t140);
        let t193 = D5 * (t63 + t64 * L65 - (t78 + L65 * t79));
        let t194 = t182 + t186 * (t94 + fields[3] * L54 + fields[6] * L64)
            + t193 * (fields[3] + fields[6] * L65);
        let t195 = t183 + t186 * (t98 + fields[4] * L54 + fields[7] * L64)
            + t193 * (fields[4] + fields[7] * L65);
        let t196 = t184 + t186 * (t102 + fields[5] * L54 + fields[8] * L64)
            + t193 * (fields[5] + fields[8] * L65);
        let t197 = D6 * (t64 - t79);
        forces[0] = t194 + fields[6] * t197;
        forces[1] = t195 + fields[7] * t197;
        forces[2] = t196 + fields[8] * t197;
        forces[3] = t187 + fields[0] * t193;
        forces[4] = t188 + fields[1] * t193;
        forces[5] = t189 + fields[2] * t193;
        forces[6] = t190 + t193 * (fields[0] * L65) + fields[0] * t197;
        forces[7] = t191 + t193 * (fields[1] * L65) + fields[1] * t197;
        forces[8] = t192 + t193 * (fields[2] * L65) + fields[2] * t197;
        forces[9] = t174 - t147 * t181;
        forces[10] = t175 - t150 * t181;
        forces[11] = t176 - t153 * t181;
        forces[12] = t177 - t156 * t181;
        forces[13] = t178 - t159 * t181;
        forces[14] = t179 - t162 * t181;
    }
    /// Load `pull` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_pull(model: &Iea15mwBlade, t: f64, value: &mut [f64; 3]) {
        value[0] = model.downwind;
        value[1] = model.edgewise;
        value[2] = 0.0;
    }
    /// Joint `hub`: conditions, position level.
    ///
    /// Operations: 15 additions, 19 multiplications.
    pub fn joint_hub_absolute_position(
        model: &Iea15mwBlade,
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
    pub fn joint_hub_absolute_jacobian(
        model: &Iea15mwBlade,
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
    pub fn joint_hub_absolute_prescribed(
        model: &Iea15mwBlade,
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
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &Iea15mwBlade, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
        out[4] = -observed[4];
        out[5] = -observed[5];
        out[6] = -observed[6];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &Iea15mwBlade, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.1;
    }
    /// Coefficients of body `blade` at the arclength x (m) of its axis, and its masses per length that move with r r, r r_y, r r_z, r_y r_y, r_z r_z, r_y r_z.
    pub fn along_blade(
        model: &Iea15mwBlade,
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
        pub model: Iea15mwBlade,
        pub row_blade: ::std::vec::Vec<FullBeamSpatialCurved>,
        pub reference_blade: ::std::vec::Vec<[f64; 208]>,
        pub mass_blade: ::std::vec::Vec<::std::vec::Vec<f64>>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &Iea15mwBlade) -> Self {
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
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Balance {
                    of: ::rncf::emitted::Owner::Body(0),
                    what: ::rncf::emitted::BalanceQuantity::Mass,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Reaction {
                    joint: 0,
                    moment: true,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Reaction {
                    joint: 0,
                    moment: true,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Reaction {
                    joint: 0,
                    moment: true,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            7
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
            Some(
                "body `blade` has an energy that is not quadratic in the inner products of its vectors",
            )
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
                    frame: 0,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Curve(
                        TABLE_POINTS.curve([0, 1, 2], [None, None], &[0, 1, 2]),
                    ),
                    count: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Curve(
                                    TABLE_POINTS.curve([0, 1, 2], [None, None], &[0, 1, 2]),
                                )
                                .length(),
                            (model.each as f64) as usize,
                        )
                        .len() - 1,
                    stations: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Curve(
                                    TABLE_POINTS.curve([0, 1, 2], [None, None], &[0, 1, 2]),
                                )
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
                            ::rncf::emitted::Line::Curve(
                                    TABLE_POINTS.curve([0, 1, 2], [None, None], &[0, 1, 2]),
                                )
                                .length(),
                        );
                        ::rncf::emitted::Twist::along(move |u| {
                            let x = u * length;
                            -TABLE_POINTS.at(3, x, length)
                        })
                    },
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
                let row = FullBeamSpatialCurved {
                    length: nodes[1] - nodes[0],
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
                full_beam_spatial_curved_reference(
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
                                    full_beam_spatial_curved_shapes_position_0(
                                        row.length,
                                        xi,
                                        ::rncf::emitted::array_mut(weights),
                                    )
                                }
                                ::rncf::emitted::Interpolant::SectionY => {
                                    full_beam_spatial_curved_shapes_section_y_0(
                                        row.length,
                                        xi,
                                        ::rncf::emitted::array_mut(weights),
                                    )
                                }
                                ::rncf::emitted::Interpolant::SectionZ => {
                                    full_beam_spatial_curved_shapes_section_z_0(
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
            full_beam_spatial_curved_elastic_force(
                &self.row_blade[element],
                &self.reference_blade[element],
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
            full_beam_spatial_curved_elastic_tangent(
                &self.row_blade[element],
                &self.reference_blade[element],
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
            full_beam_spatial_curved_strain_energy(
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
                    full_beam_spatial_curved_shapes_position_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    full_beam_spatial_curved_shapes_position_1(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 0) => {
                    full_beam_spatial_curved_shapes_section_y_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionY, 1) => {
                    full_beam_spatial_curved_shapes_section_y_1(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 0) => {
                    full_beam_spatial_curved_shapes_section_z_0(
                        self.row_blade[element].length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::SectionZ, 1) => {
                    full_beam_spatial_curved_shapes_section_z_1(
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
                full_beam_spatial_curved_field_forces(
                    &self.row_blade[0],
                    &coefficients,
                    ::rncf::emitted::array(stress_free),
                    ::rncf::emitted::array(fields),
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
                    name: "pull",
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
                0 => load_pull(&self.model, t, &mut value),
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
