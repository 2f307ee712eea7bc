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
    const NOTES: &'static [&'static str] = &[
        "Body `blade` uses `full_beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1872 and 15955).",
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
            additions: 142,
            multiplications: 235,
            divisions: 15,
            functions: 1,
            weighted: 457,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points2_tangent",
            additions: 1134,
            multiplications: 1669,
            divisions: 51,
            functions: 1,
            weighted: 3027,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points2_energy",
            additions: 56,
            multiplications: 84,
            divisions: 3,
            functions: 1,
            weighted: 172,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_force",
            additions: 49,
            multiplications: 83,
            divisions: 1,
            functions: 1,
            weighted: 156,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_tangent",
            additions: 182,
            multiplications: 306,
            divisions: 4,
            functions: 1,
            weighted: 524,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_points3_energy",
            additions: 31,
            multiplications: 47,
            divisions: 0,
            functions: 1,
            weighted: 98,
        },
        ::rncf::model::KernelCount {
            name: "full_beam_spatial_curved_reference",
            additions: 255,
            multiplications: 337,
            divisions: 5,
            functions: 5,
            weighted: 712,
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
            additions: 376,
            multiplications: 529,
            divisions: 35,
            functions: 2,
            weighted: 1085,
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
    /// * Body `blade` uses `full_beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1872 and 15955).
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
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1872 and 15955).
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
    /// Gauss rule with 2 points, and derivatives of the shape functions there.
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
    /// Gauss rule with 3 points, and derivatives of the shape functions there.
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
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 142 additions, 235 multiplications, 15 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
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
        let t68 = t66 * t67;
        let t69 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t58 * t65) / t63;
        let t70 = t67 * t69;
        let t71 = (a_x * db_x + a_y * db_y + a_z * db_z - t59 * t65) / t63;
        let t72 = t66 * t71;
        let t73 = t65 * t68 + reference[12] * t70 - reference[13] * t72
            + reference[15] * t64 + t58 * reference[18];
        let t74 = length * reference[6] * (t73 + t59 * reference[22] - reference[0]);
        let t75 = 1.0 / (2.0 * t63);
        let t76 = t67 * (t69 * t75 / t63);
        let t77 = t66 * (t71 * t75 / t63);
        let t78 = t70 - reference[14] * t72 + reference[16] * t64 + t58 * reference[19]
            + t59 * reference[23] - reference[1];
        let t79 = length * reference[7] * t78;
        let t80 = length * reference[8]
            * (reference[17] * t64 - t72 + t58 * reference[20] + t59 * reference[24]
                - reference[2]);
        let t81 = t75 * (t58 * 2.0);
        let t82 = t67 * ((t65 + t69 * t81) / t63);
        let t83 = t66 * (t71 * t81 / t63);
        let t84 = t75 * (t59 * 2.0);
        let t85 = t67 * (t69 * t84 / t63);
        let t86 = t66 * ((t71 * t84 - t65) / t63);
        let t87 = 1.0 / t63;
        let t88 = t66 * t87;
        let t89 = t67 * t87;
        let t90 = -0.5 * t71;
        let t91 = t67 * (t58 * (-0.5) / t63);
        let t92 = t66 * (t59 * (-0.5) / t63);
        let t93 = -0.5 * t69;
        let t94 = t67 * (0.5 * t58 / t63);
        let t95 = t66 * (0.5 * t59 / t63);
        let t96 = length * reference[29];
        let t97 = t74 * (reference[13] * t77 - reference[12] * t76 + reference[15] * t75)
            + t79 * (reference[14] * t77 - t76 + reference[16] * t75);
        let t98 = t97 + t80 * (t77 + reference[17] * t75);
        let t99 = t74
            * (reference[18]
                + (reference[12] * t82 - reference[13] * t83 - reference[15] * t81))
            + t79 * (reference[19] + (t82 - reference[14] * t83 - reference[16] * t81));
        let t100 = t99 + t80 * (reference[20] - (t83 + reference[17] * t81));
        let t101 = t74
            * (reference[22]
                + (reference[12] * t85 - reference[13] * t86 - reference[15] * t84))
            + t79 * (reference[23] + (t85 - reference[14] * t86 - reference[16] * t84));
        let t102 = t101 + t80 * (reference[24] - (t86 + reference[17] * t84));
        let t103 = t74 * (t65 * (-0.5 * t67) - reference[13] * t90)
            - t79 * (reference[14] * t90) - t80 * t90;
        let t104 = t74 * (-0.5 * t68 + reference[12] * t91 + reference[13] * t92)
            + t79 * (t91 + reference[14] * t92);
        let t105 = length * reference[30] * (t60 + t61 - reference[5]);
        let t106 = t74 * (t65 * (-0.5 * t66) + reference[12] * t93) + t79 * t93;
        let t107 = t74 * (0.5 * t68 + reference[12] * t94 + reference[13] * t95)
            + t79 * (t94 + reference[14] * t95);
        let t108 = inverse_length
            * (t74 * (reference[13] * t88) + t79 * (reference[14] * t88) + t80 * t88);
        let t109 = inverse_length * (t74 * (reference[12] * t89) + t79 * t89);
        let t110 = inverse_length
            * (t96 * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]));
        let t111 = inverse_length * (t104 + t80 * t92 + t105);
        let t112 = inverse_length * (t105 + (t107 + t80 * t95));
        let t113 = inverse_length
            * (t96 * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]));
        let t114 = t98 * (a_x * 2.0) + b_x * t100 + c_x * t102 - unit_db_x * t108
            + unit_dc_x * t109;
        let t115 = t98 * (a_y * 2.0) + b_y * t100 + c_y * t102 - unit_db_y * t108
            + unit_dc_y * t109;
        let t116 = t98 * (a_z * 2.0) + b_z * t100 + c_z * t102 - unit_db_z * t108
            + unit_dc_z * t109;
        forces[0][0] = t114;
        forces[0][1] = t115;
        forces[0][2] = t116;
        forces[1][0] = a_x * t100 + t103 * (b_x * 2.0) + unit_db_x * t110
            + unit_dc_x * t111;
        forces[1][1] = a_y * t100 + t103 * (b_y * 2.0) + unit_db_y * t110
            + unit_dc_y * t111;
        forces[1][2] = a_z * t100 + t103 * (b_z * 2.0) + unit_db_z * t110
            + unit_dc_z * t111;
        forces[2][0] = a_x * t102 + t106 * (c_x * 2.0) + unit_db_x * t112
            + unit_dc_x * t113;
        forces[2][1] = a_y * t102 + t106 * (c_y * 2.0) + unit_db_y * t112
            + unit_dc_y * t113;
        forces[2][2] = a_z * t102 + t106 * (c_z * 2.0) + unit_db_z * t112
            + unit_dc_z * t113;
        forces[3][0] = b_x * t110 - a_x * t108 + c_x * t112;
        forces[3][1] = b_y * t110 - a_y * t108 + c_y * t112;
        forces[3][2] = b_z * t110 - a_z * t108 + c_z * t112;
        forces[4][0] = a_x * t109 + b_x * t111 + c_x * t113;
        forces[4][1] = a_y * t109 + b_y * t111 + c_y * t113;
        forces[4][2] = a_z * t109 + b_z * t111 + c_z * t113;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 1134 additions, 1669 multiplications, 51 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
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
        let t68 = t66 * t67;
        let t69 = (a_x * dc_x + a_y * dc_y + a_z * dc_z + t58 * t65) / t63;
        let t70 = t67 * t69;
        let t71 = (a_x * db_x + a_y * db_y + a_z * db_z - t59 * t65) / t63;
        let t72 = t66 * t71;
        let t73 = t65 * t68 + reference[12] * t70 - reference[13] * t72
            + reference[15] * t64 + t58 * reference[18];
        let t74 = length * reference[6];
        let t75 = t74 * (t73 + t59 * reference[22] - reference[0]);
        let t76 = 2.0 * t63;
        let t77 = 1.0 / t76;
        let t78 = t69 * t77 / t63;
        let t79 = t67 * t78;
        let t80 = t71 * t77 / t63;
        let t81 = t66 * t80;
        let t82 = reference[13] * t81 - reference[12] * t79 + reference[15] * t77;
        let t83 = length * reference[7];
        let t84 = t70 - reference[14] * t72 + reference[16] * t64 + t58 * reference[19]
            + t59 * reference[23] - reference[1];
        let t85 = t83 * t84;
        let t86 = reference[14] * t81 - t79 + reference[16] * t77;
        let t87 = length * reference[8];
        let t88 = t87
            * (reference[17] * t64 - t72 + t58 * reference[20] + t59 * reference[24]
                - reference[2]);
        let t89 = t81 + reference[17] * t77;
        let t90 = t74 * t82;
        let t91 = 2.0 * t77;
        let t92 = t77 * t91 / t76;
        let t93 = t77 * t78;
        let t94 = t67 * ((t93 + (t93 + t69 * t92)) / t63);
        let t95 = t77 * t80;
        let t96 = t66 * ((t95 + (t95 + t71 * t92)) / t63);
        let t97 = t83 * t86;
        let t98 = t82 * t90
            + t75 * (reference[12] * t94 - reference[13] * t96 - reference[15] * t92)
            + (t86 * t97 + t85 * (t94 - reference[14] * t96 - reference[16] * t92));
        let t99 = t87 * t89;
        let t100 = t98 + (t89 * t99 - t88 * (t96 + reference[17] * t92));
        let t101 = t58 * 2.0;
        let t102 = t77 * t101;
        let t103 = (t65 + t69 * t102) / t63;
        let t104 = t67 * t103;
        let t105 = t71 * t102 / t63;
        let t106 = t66 * t105;
        let t107 = reference[18]
            + (reference[12] * t104 - reference[13] * t106 - reference[15] * t102);
        let t108 = reference[19] + (t104 - reference[14] * t106 - reference[16] * t102);
        let t109 = reference[20] - (t106 + reference[17] * t102);
        let t110 = t74 * t107;
        let t111 = t77 * (2.0 * t102) / t76;
        let t112 = t77 * t103;
        let t113 = t78 * t102;
        let t114 = t67 * ((t112 + t69 * t111 + t113) / t63);
        let t115 = t77 * t105;
        let t116 = t80 * t102;
        let t117 = t66 * ((t115 + t71 * t111 + t116) / t63);
        let t118 = t83 * t108;
        let t119 = t82 * t110
            + t75 * (reference[13] * t117 - reference[12] * t114 + reference[15] * t111)
            + (t86 * t118 + t85 * (reference[14] * t117 - t114 + reference[16] * t111));
        let t120 = t87 * t109;
        let t121 = t119 + (t89 * t120 + t88 * (t117 + reference[17] * t111));
        let t122 = t59 * 2.0;
        let t123 = t77 * t122;
        let t124 = t69 * t123 / t63;
        let t125 = t67 * t124;
        let t126 = (t71 * t123 - t65) / t63;
        let t127 = t66 * t126;
        let t128 = reference[22]
            + (reference[12] * t125 - reference[13] * t127 - reference[15] * t123);
        let t129 = reference[23] + (t125 - reference[14] * t127 - reference[16] * t123);
        let t130 = reference[24] - (t127 + reference[17] * t123);
        let t131 = t74 * t128;
        let t132 = t77 * (2.0 * t123) / t76;
        let t133 = t77 * t124;
        let t134 = t78 * t123;
        let t135 = t67 * ((t133 + t69 * t132 + t134) / t63);
        let t136 = t77 * t126;
        let t137 = t80 * t123;
        let t138 = t66 * ((t136 + t71 * t132 + t137) / t63);
        let t139 = t83 * t129;
        let t140 = t82 * t131
            + t75 * (reference[13] * t138 - reference[12] * t135 + reference[15] * t132)
            + (t86 * t139 + t85 * (reference[14] * t138 - t135 + reference[16] * t132));
        let t141 = t87 * t130;
        let t142 = t140 + (t89 * t141 + t88 * (t138 + reference[17] * t132));
        let t143 = 1.0 / t63;
        let t144 = t66 * t143;
        let t145 = reference[13] * t144;
        let t146 = reference[14] * t144;
        let t147 = t74 * t145;
        let t148 = t77 * t143 / t63;
        let t149 = t66 * t148;
        let t150 = t75 * (reference[13] * t149);
        let t151 = t83 * t146;
        let t152 = t85 * (reference[14] * t149);
        let t153 = t87 * t144;
        let t154 = t88 * t149;
        let t155 = t67 * t143;
        let t156 = reference[12] * t155;
        let t157 = t74 * t156;
        let t158 = t67 * t148;
        let t159 = t75 * (reference[12] * t158);
        let t160 = t83 * t155;
        let t161 = t85 * t158;
        let t162 = -0.5 * t67;
        let t163 = -0.5 * t71;
        let t164 = t65 * t162 - reference[13] * t163;
        let t165 = reference[14] * t163;
        let t166 = t74 * t164;
        let t167 = -0.5 * t80;
        let t168 = t83 * t165;
        let t169 = t82 * t166 + t75 * (reference[13] * t167)
            + (t85 * (reference[14] * t167) - t86 * t168);
        let t170 = t87 * t163;
        let t171 = t169 + (t88 * t167 - t89 * t170);
        let t172 = t58 * (-0.5) / t63;
        let t173 = t67 * t172;
        let t174 = t59 * (-0.5) / t63;
        let t175 = t66 * t174;
        let t176 = -0.5 * t68 + reference[12] * t173 + reference[13] * t175;
        let t177 = t173 + reference[14] * t175;
        let t178 = t74 * t176;
        let t179 = t67 * (t77 * t172 / t63);
        let t180 = t66 * (t77 * t174 / t63);
        let t181 = t83 * t177;
        let t182 = t82 * t178 - t75 * (reference[12] * t179 + reference[13] * t180)
            + (t86 * t181 - t85 * (t179 + reference[14] * t180));
        let t183 = t87 * t175;
        let t184 = -0.5 * t66;
        let t185 = -0.5 * t69;
        let t186 = t65 * t184 + reference[12] * t185;
        let t187 = t74 * t186;
        let t188 = -0.5 * t78;
        let t189 = t83 * t185;
        let t190 = t82 * t187 - t75 * (reference[12] * t188) + (t86 * t189 - t85 * t188);
        let t191 = 0.5 * t58 / t63;
        let t192 = t67 * t191;
        let t193 = 0.5 * t59 / t63;
        let t194 = t66 * t193;
        let t195 = 0.5 * t68 + reference[12] * t192 + reference[13] * t194;
        let t196 = t192 + reference[14] * t194;
        let t197 = t74 * t195;
        let t198 = t67 * (t77 * t191 / t63);
        let t199 = t66 * (t77 * t193 / t63);
        let t200 = t83 * t196;
        let t201 = t82 * t197 - t75 * (reference[12] * t198 + reference[13] * t199)
            + (t86 * t200 - t85 * (t198 + reference[14] * t199));
        let t202 = t87 * t194;
        let t203 = t92 * t101;
        let t204 = t67 * ((t112 + (t113 + t69 * t203)) / t63);
        let t205 = t66 * ((t115 + (t116 + t71 * t203)) / t63);
        let t206 = t90 * t107
            + t75 * (reference[13] * t205 - reference[12] * t204 + reference[15] * t203)
            + (t97 * t108 + t85 * (reference[14] * t205 - t204 + reference[16] * t203));
        let t207 = t206 + (t99 * t109 + t88 * (t205 + reference[17] * t203));
        let t208 = t91 + t101 * t111;
        let t209 = t102 * t103;
        let t210 = t67 * ((t209 + (t209 + t69 * t208)) / t63);
        let t211 = t102 * t105;
        let t212 = t66 * ((t211 + (t211 + t71 * t208)) / t63);
        let t213 = t107 * t110
            + t75 * (reference[12] * t210 - reference[13] * t212 - reference[15] * t208)
            + (t108 * t118 + t85 * (t210 - reference[14] * t212 - reference[16] * t208));
        let t214 = t213 + (t109 * t120 - t88 * (t212 + reference[17] * t208));
        let t215 = t101 * t132;
        let t216 = t102 * t124;
        let t217 = t103 * t123;
        let t218 = t67 * ((t216 + t69 * t215 + t217) / t63);
        let t219 = t102 * t126;
        let t220 = t105 * t123;
        let t221 = t66 * ((t219 + t71 * t215 + t220) / t63);
        let t222 = t107 * t131
            + t75 * (reference[12] * t218 - reference[13] * t221 - reference[15] * t215)
            + (t108 * t139 + t85 * (t218 - reference[14] * t221 - reference[16] * t215));
        let t223 = t222 + (t109 * t141 - t88 * (t221 + reference[17] * t215));
        let t224 = t102 * t143 / t63;
        let t225 = t66 * t224;
        let t226 = t75 * (reference[13] * t225);
        let t227 = t85 * (reference[14] * t225);
        let t228 = t88 * t225;
        let t229 = t67 * t224;
        let t230 = t75 * (reference[12] * t229);
        let t231 = t85 * t229;
        let t232 = -0.5 * t105;
        let t233 = t75 * (reference[13] * t232);
        let t234 = t85 * (reference[14] * t232);
        let t235 = t88 * t232;
        let t236 = t107 * t166 - t233 - (t108 * t168 + t234) - (t109 * t170 + t235);
        let t237 = t67 * ((-0.5 + t102 * t172) / t63);
        let t238 = t66 * (t102 * t174 / t63);
        let t239 = t75 * (reference[12] * t237 + reference[13] * t238);
        let t240 = t85 * (t237 + reference[14] * t238);
        let t241 = t88 * t238;
        let t242 = -0.5 * t103;
        let t243 = t107 * t187 + t75 * (reference[12] * t242)
            + (t108 * t189 + t85 * t242);
        let t244 = t67 * ((0.5 + t102 * t191) / t63);
        let t245 = t66 * (t102 * t193 / t63);
        let t246 = t75 * (reference[12] * t244 + reference[13] * t245);
        let t247 = t85 * (t244 + reference[14] * t245);
        let t248 = t88 * t245;
        let t249 = t92 * t122;
        let t250 = t67 * ((t133 + (t134 + t69 * t249)) / t63);
        let t251 = t66 * ((t136 + (t137 + t71 * t249)) / t63);
        let t252 = t90 * t128
            + t75 * (reference[13] * t251 - reference[12] * t250 + reference[15] * t249)
            + (t97 * t129 + t85 * (reference[14] * t251 - t250 + reference[16] * t249));
        let t253 = t252 + (t99 * t130 + t88 * (t251 + reference[17] * t249));
        let t254 = t111 * t122;
        let t255 = t67 * ((t216 + (t217 + t69 * t254)) / t63);
        let t256 = t66 * ((t219 + (t220 + t71 * t254)) / t63);
        let t257 = t110 * t128
            + t75 * (reference[12] * t255 - reference[13] * t256 - reference[15] * t254)
            + (t118 * t129 + t85 * (t255 - reference[14] * t256 - reference[16] * t254));
        let t258 = t257 + (t120 * t130 - t88 * (t256 + reference[17] * t254));
        let t259 = t91 + t122 * t132;
        let t260 = t123 * t124;
        let t261 = t67 * ((t260 + (t260 + t69 * t259)) / t63);
        let t262 = t123 * t126;
        let t263 = t66 * ((t262 + (t262 + t71 * t259)) / t63);
        let t264 = t128 * t131
            + t75 * (reference[12] * t261 - reference[13] * t263 - reference[15] * t259)
            + (t129 * t139 + t85 * (t261 - reference[14] * t263 - reference[16] * t259));
        let t265 = t264 + (t130 * t141 - t88 * (t263 + reference[17] * t259));
        let t266 = t123 * t143 / t63;
        let t267 = t66 * t266;
        let t268 = t75 * (reference[13] * t267);
        let t269 = t85 * (reference[14] * t267);
        let t270 = t88 * t267;
        let t271 = t67 * t266;
        let t272 = t75 * (reference[12] * t271);
        let t273 = t85 * t271;
        let t274 = -0.5 * t126;
        let t275 = t75 * (reference[13] * t274);
        let t276 = t85 * (reference[14] * t274);
        let t277 = t88 * t274;
        let t278 = t128 * t166 - t275 - (t129 * t168 + t276) - (t130 * t170 + t277);
        let t279 = t67 * (t123 * t172 / t63);
        let t280 = t66 * ((-0.5 + t123 * t174) / t63);
        let t281 = t75 * (reference[12] * t279 + reference[13] * t280);
        let t282 = t85 * (t279 + reference[14] * t280);
        let t283 = t88 * t280;
        let t284 = -0.5 * t124;
        let t285 = t75 * (reference[12] * t284);
        let t286 = t85 * t284;
        let t287 = t128 * t187 + t285 + (t129 * t189 + t286);
        let t288 = t67 * (t123 * t191 / t63);
        let t289 = t66 * ((0.5 + t123 * t193) / t63);
        let t290 = t75 * (reference[12] * t288 + reference[13] * t289);
        let t291 = t85 * (t288 + reference[14] * t289);
        let t292 = t88 * t289;
        let t293 = -0.5 * t143;
        let t294 = t75 * (reference[13] * t293);
        let t295 = t85 * (reference[14] * t293);
        let t296 = t88 * t293;
        let t297 = t75 * (reference[12] * t293);
        let t298 = t85 * t293;
        let t299 = t110 * t164 - t233 - (t234 + t118 * t165) - (t235 + t120 * t163);
        let t300 = t131 * t164 - t275 - (t276 + t139 * t165) - (t277 + t141 * t163);
        let t301 = t164 * t166 + t165 * t168 + t163 * t170;
        let t302 = -0.5 * t174;
        let t303 = t75 * (-0.5 * t162 + reference[13] * t302);
        let t304 = t85 * (reference[14] * t302);
        let t305 = t88 * t302;
        let t306 = t164 * t187 + t75 * (t65 * 0.25) - t165 * t189;
        let t307 = -0.5 * t193;
        let t308 = t75 * (0.5 * t162 + reference[13] * t307);
        let t309 = t85 * (reference[14] * t307);
        let t310 = t88 * t307;
        let t311 = length * reference[29];
        let t312 = length * reference[30];
        let t313 = -0.5 * t172;
        let t314 = t75 * (-0.5 * t184 + reference[12] * t313);
        let t315 = t85 * t313;
        let t316 = t285 + t131 * t186 + (t286 + t139 * t185);
        let t317 = t186 * t187 + t185 * t189;
        let t318 = -0.5 * t191;
        let t319 = t75 * (0.5 * t184 + reference[12] * t318);
        let t320 = t85 * t318;
        let t321 = t75 * t107 + t85 * t108 + t88 * t109;
        let t322 = t75 * t128 + t85 * t129 + t88 * t130;
        let t323 = t312 * (t60 + t61 - reference[5]);
        let t324 = inverse_length
            * (t150 - t82 * t147 + (t152 - t86 * t151) + (t154 - t89 * t153));
        let t325 = inverse_length * (t82 * t157 - t159 + (t86 * t160 - t161));
        let t326 = inverse_length * (t182 + (t89 * t183 - t88 * t180));
        let t327 = inverse_length * (t201 + (t89 * t202 - t88 * t199));
        let t328 = inverse_length
            * (t107 * t147 + t226 + (t108 * t151 + t227) + (t109 * t153 + t228));
        let t329 = inverse_length * (t107 * t157 + t230 + (t108 * t160 + t231));
        let t330 = inverse_length
            * (t107 * t178 + t239 + (t108 * t181 + t240) + (t109 * t183 + t241));
        let t331 = inverse_length
            * (t107 * t197 + t246 + (t108 * t200 + t247) + (t109 * t202 + t248));
        let t332 = inverse_length
            * (t128 * t147 + t268 + (t129 * t151 + t269) + (t130 * t153 + t270));
        let t333 = inverse_length * (t128 * t157 + t272 + (t129 * t160 + t273));
        let t334 = inverse_length
            * (t128 * t178 + t281 + (t129 * t181 + t282) + (t130 * t183 + t283));
        let t335 = inverse_length
            * (t128 * t197 + t290 + (t129 * t200 + t291) + (t130 * t202 + t292));
        let t336 = inverse_length * (t75 * t145 + t85 * t146 + t88 * t144);
        let t337 = inverse_length
            * (t90 * t145 - t150 + (t97 * t146 - t152) + (t99 * t144 - t154));
        let t338 = inverse_length
            * (t226 + t110 * t145 + (t227 + t118 * t146) + (t228 + t120 * t144));
        let t339 = inverse_length
            * (t268 + t131 * t145 + (t269 + t139 * t146) + (t270 + t141 * t144));
        let t340 = inverse_length * inverse_length;
        let t341 = (t145 * t147 + t146 * t151 + t144 * t153) * t340;
        let t342 = (t145 * t157 + t146 * t160) * t340;
        let t343 = inverse_length
            * (t145 * t166 + t294 + (t295 - t146 * t168) + (t296 - t144 * t170));
        let t344 = (t145 * t178 + t146 * t181 + t144 * t183) * t340;
        let t345 = inverse_length * (t145 * t187 + t146 * t189);
        let t346 = (t145 * t197 + t146 * t200 + t144 * t202) * t340;
        let t347 = inverse_length * (t75 * t156 + t85 * t155);
        let t348 = inverse_length * (t90 * t156 - t159 + (t97 * t155 - t161));
        let t349 = inverse_length * (t230 + t110 * t156 + (t231 + t118 * t155));
        let t350 = inverse_length * (t272 + t131 * t156 + (t273 + t139 * t155));
        let t351 = (t147 * t156 + t151 * t155) * t340;
        let t352 = (t156 * t157 + t155 * t160) * t340;
        let t353 = inverse_length * (t156 * t166 - t155 * t168);
        let t354 = (t156 * t178 + t155 * t181) * t340;
        let t355 = inverse_length * (t156 * t187 + t297 + (t298 + t155 * t189));
        let t356 = (t156 * t197 + t155 * t200) * t340;
        let t357 = inverse_length
            * (t294 + t147 * t164 + (t295 - t151 * t165) + (t296 - t153 * t163));
        let t358 = inverse_length * (t157 * t164 - t160 * t165);
        let t359 = inverse_length
            * (t164 * t178 + t303 - (t165 * t181 - t304) - (t163 * t183 - t305));
        let t360 = inverse_length
            * (t164 * t197 + t308 - (t165 * t200 - t309) - (t163 * t202 - t310));
        let t361 = inverse_length
            * (t311 * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]));
        let t362 = t311 * t340;
        let t363 = inverse_length * (t75 * t176 + t85 * t177 + t88 * t175 + t323);
        let t364 = inverse_length
            * (t239 + t110 * t176 + (t240 + t118 * t177) + (t241 + t120 * t175));
        let t365 = inverse_length
            * (t281 + t131 * t176 + (t282 + t139 * t177) + (t283 + t141 * t175));
        let t366 = (t147 * t176 + t151 * t177 + t153 * t175) * t340;
        let t367 = (t157 * t176 + t160 * t177) * t340;
        let t368 = inverse_length
            * (t303 + t166 * t176 + (t304 - t168 * t177) + (t305 - t170 * t175));
        let t369 = (t312 + (t176 * t178 + t177 * t181 + t175 * t183)) * t340;
        let t370 = inverse_length * (t176 * t187 + t314 + (t177 * t189 + t315));
        let t371 = (t312 + (t176 * t197 + t177 * t200 + t175 * t202)) * t340;
        let t372 = inverse_length * (t297 + t157 * t186 + (t298 + t160 * t185));
        let t373 = inverse_length * (t314 + t178 * t186 + (t315 + t181 * t185));
        let t374 = inverse_length * (t186 * t197 + t319 + (t320 + t185 * t200));
        let t375 = inverse_length * (t323 + (t75 * t195 + t85 * t196 + t88 * t194));
        let t376 = inverse_length
            * (t246 + t110 * t195 + (t247 + t118 * t196) + (t248 + t120 * t194));
        let t377 = inverse_length
            * (t290 + t131 * t195 + (t291 + t139 * t196) + (t292 + t141 * t194));
        let t378 = (t147 * t195 + t151 * t196 + t153 * t194) * t340;
        let t379 = (t157 * t195 + t160 * t196) * t340;
        let t380 = inverse_length
            * (t308 + t166 * t195 + (t309 - t168 * t196) + (t310 - t170 * t194));
        let t381 = (t312 + (t178 * t195 + t181 * t196 + t183 * t194)) * t340;
        let t382 = inverse_length * (t319 + t187 * t195 + (t320 + t189 * t196));
        let t383 = (t312 + (t195 * t197 + t196 * t200 + t194 * t202)) * t340;
        let t384 = inverse_length
            * (t311 * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]));
        let t385 = a_x * 2.0;
        let t386 = a_y * 2.0;
        let t387 = a_z * 2.0;
        let t388 = b_x * 2.0;
        let t389 = b_y * 2.0;
        let t390 = b_z * 2.0;
        let t391 = c_x * 2.0;
        let t392 = c_y * 2.0;
        let t393 = c_z * 2.0;
        let t394 = t100 * t385 + b_x * t121 + c_x * t142 + unit_db_x * t324
            + unit_dc_x * t325;
        let t395 = t100 * t386 + b_y * t121 + c_y * t142 + unit_db_y * t324
            + unit_dc_y * t325;
        let t396 = t100 * t387 + b_z * t121 + c_z * t142 + unit_db_z * t324
            + unit_dc_z * t325;
        let t397 = a_x * t121 + t171 * t388 + unit_dc_x * t326;
        let t398 = a_y * t121 + t171 * t389 + unit_dc_y * t326;
        let t399 = a_z * t121 + t171 * t390 + unit_dc_z * t326;
        let t400 = a_x * t142 + t190 * t391 + unit_db_x * t327;
        let t401 = a_y * t142 + t190 * t392 + unit_db_y * t327;
        let t402 = a_z * t142 + t190 * t393 + unit_db_z * t327;
        let t403 = a_x * t324 + c_x * t327;
        let t404 = a_y * t324 + c_y * t327;
        let t405 = a_z * t324 + c_z * t327;
        let t406 = a_x * t325 + b_x * t326;
        let t407 = a_y * t325 + b_y * t326;
        let t408 = a_z * t325 + b_z * t326;
        let t409 = t207 * t385 + b_x * t214 + c_x * t223 - unit_db_x * t328
            + unit_dc_x * t329;
        let t410 = t207 * t386 + b_y * t214 + c_y * t223 - unit_db_y * t328
            + unit_dc_y * t329;
        let t411 = t207 * t387 + b_z * t214 + c_z * t223 - unit_db_z * t328
            + unit_dc_z * t329;
        let t412 = a_x * t214 + t236 * t388 + unit_dc_x * t330;
        let t413 = a_y * t214 + t236 * t389 + unit_dc_y * t330;
        let t414 = a_z * t214 + t236 * t390 + unit_dc_z * t330;
        let t415 = a_x * t223 + t243 * t391 + unit_db_x * t331;
        let t416 = a_y * t223 + t243 * t392 + unit_db_y * t331;
        let t417 = a_z * t223 + t243 * t393 + unit_db_z * t331;
        let t418 = c_x * t331 - a_x * t328;
        let t419 = c_y * t331 - a_y * t328;
        let t420 = c_z * t331 - a_z * t328;
        let t421 = a_x * t329 + b_x * t330;
        let t422 = a_y * t329 + b_y * t330;
        let t423 = a_z * t329 + b_z * t330;
        let t424 = t253 * t385 + b_x * t258 + c_x * t265 - unit_db_x * t332
            + unit_dc_x * t333;
        let t425 = t253 * t386 + b_y * t258 + c_y * t265 - unit_db_y * t332
            + unit_dc_y * t333;
        let t426 = t253 * t387 + b_z * t258 + c_z * t265 - unit_db_z * t332
            + unit_dc_z * t333;
        let t427 = a_x * t258 + t278 * t388 + unit_dc_x * t334;
        let t428 = a_y * t258 + t278 * t389 + unit_dc_y * t334;
        let t429 = a_z * t258 + t278 * t390 + unit_dc_z * t334;
        let t430 = a_x * t265 + t287 * t391 + unit_db_x * t335;
        let t431 = a_y * t265 + t287 * t392 + unit_db_y * t335;
        let t432 = a_z * t265 + t287 * t393 + unit_db_z * t335;
        let t433 = c_x * t335 - a_x * t332;
        let t434 = c_y * t335 - a_y * t332;
        let t435 = c_z * t335 - a_z * t332;
        let t436 = a_x * t333 + b_x * t334;
        let t437 = a_y * t333 + b_y * t334;
        let t438 = a_z * t333 + b_z * t334;
        let t439 = unit_db_x * t341 - (t337 * t385 + b_x * t338 + c_x * t339)
            - unit_dc_x * t342;
        let t440 = unit_db_y * t341 - (t337 * t386 + b_y * t338 + c_y * t339)
            - unit_dc_y * t342;
        let t441 = unit_db_z * t341 - (t337 * t387 + b_z * t338 + c_z * t339)
            - unit_dc_z * t342;
        let t442 = a_x * t338 + t343 * t388 + unit_dc_x * t344;
        let t443 = a_y * t338 + t343 * t389 + unit_dc_y * t344;
        let t444 = a_z * t338 + t343 * t390 + unit_dc_z * t344;
        let t445 = a_x * t339 + t345 * t391 + unit_db_x * t346;
        let t446 = a_y * t339 + t345 * t392 + unit_db_y * t346;
        let t447 = a_z * t339 + t345 * t393 + unit_db_z * t346;
        let t448 = a_x * t341 - c_x * t346;
        let t449 = a_y * t341 - c_y * t346;
        let t450 = a_z * t341 - c_z * t346;
        let t451 = a_x * t342 + b_x * t344;
        let t452 = a_y * t342 + b_y * t344;
        let t453 = a_z * t342 + b_z * t344;
        let t454 = t348 * t385 + b_x * t349 + c_x * t350 - unit_db_x * t351
            + unit_dc_x * t352;
        let t455 = t348 * t386 + b_y * t349 + c_y * t350 - unit_db_y * t351
            + unit_dc_y * t352;
        let t456 = t348 * t387 + b_z * t349 + c_z * t350 - unit_db_z * t351
            + unit_dc_z * t352;
        let t457 = a_x * t349 + t353 * t388 + unit_dc_x * t354;
        let t458 = a_y * t349 + t353 * t389 + unit_dc_y * t354;
        let t459 = a_z * t349 + t353 * t390 + unit_dc_z * t354;
        let t460 = a_x * t350 + t355 * t391 + unit_db_x * t356;
        let t461 = a_y * t350 + t355 * t392 + unit_db_y * t356;
        let t462 = a_z * t350 + t355 * t393 + unit_db_z * t356;
        let t463 = c_x * t356 - a_x * t351;
        let t464 = c_y * t356 - a_y * t351;
        let t465 = c_z * t356 - a_z * t351;
        let t466 = a_x * t352 + b_x * t354;
        let t467 = a_y * t352 + b_y * t354;
        let t468 = a_z * t352 + b_z * t354;
        let t469 = a_x * t299 + t301 * t388 + unit_dc_x * t359;
        let t470 = a_y * t299 + t301 * t389 + unit_dc_y * t359;
        let t471 = a_z * t299 + t301 * t390 + unit_dc_z * t359;
        let t472 = a_x * t300 + t306 * t391 + unit_db_x * t360;
        let t473 = a_y * t300 + t306 * t392 + unit_db_y * t360;
        let t474 = a_z * t300 + t306 * t393 + unit_db_z * t360;
        let t475 = c_x * t360 - a_x * t357;
        let t476 = c_y * t360 - a_y * t357;
        let t477 = c_z * t360 - a_z * t357;
        let t478 = a_x * t358 + b_x * t359;
        let t479 = a_y * t358 + b_y * t359;
        let t480 = a_z * t358 + b_z * t359;
        let t481 = unit_db_x * t362;
        let t482 = unit_db_y * t362;
        let t483 = unit_db_z * t362;
        let t484 = b_x * t362;
        let t485 = b_y * t362;
        let t486 = b_z * t362;
        let t487 = a_x * t364 + t368 * t388 + unit_dc_x * t369;
        let t488 = a_y * t364 + t368 * t389 + unit_dc_y * t369;
        let t489 = a_z * t364 + t368 * t390 + unit_dc_z * t369;
        let t490 = a_x * t365 + t370 * t391 + unit_db_x * t371;
        let t491 = a_y * t365 + t370 * t392 + unit_db_y * t371;
        let t492 = a_z * t365 + t370 * t393 + unit_db_z * t371;
        let t493 = c_x * t371 - a_x * t366;
        let t494 = c_y * t371 - a_y * t366;
        let t495 = c_z * t371 - a_z * t366;
        let t496 = a_x * t367 + b_x * t369;
        let t497 = a_y * t367 + b_y * t369;
        let t498 = a_z * t367 + b_z * t369;
        let t499 = a_x * t316 + t317 * t391 + unit_db_x * t374;
        let t500 = a_y * t316 + t317 * t392 + unit_db_y * t374;
        let t501 = a_z * t316 + t317 * t393 + unit_db_z * t374;
        let t502 = a_x * t372 + b_x * t373;
        let t503 = a_y * t372 + b_y * t373;
        let t504 = a_z * t372 + b_z * t373;
        let t505 = a_x * t376 + t380 * t388 + unit_dc_x * t381;
        let t506 = a_y * t376 + t380 * t389 + unit_dc_y * t381;
        let t507 = a_z * t376 + t380 * t390 + unit_dc_z * t381;
        let t508 = a_x * t377 + t382 * t391 + unit_db_x * t383;
        let t509 = a_y * t377 + t382 * t392 + unit_db_y * t383;
        let t510 = a_z * t377 + t382 * t393 + unit_db_z * t383;
        let t511 = c_x * t383 - a_x * t378;
        let t512 = c_y * t383 - a_y * t378;
        let t513 = c_z * t383 - a_z * t378;
        let t514 = a_x * t379 + b_x * t381;
        let t515 = a_y * t379 + b_y * t381;
        let t516 = a_z * t379 + b_z * t381;
        let t517 = unit_dc_x * t362;
        let t518 = unit_dc_y * t362;
        let t519 = unit_dc_z * t362;
        let t520 = c_x * t362;
        let t521 = c_y * t362;
        let t522 = c_z * t362;
        let t523 = t385 * t394 + b_x * t409 + c_x * t424 + unit_db_x * t439
            + unit_dc_x * t454;
        let t524 = t385 * t395 + b_x * t410 + c_x * t425 + unit_db_x * t440
            + unit_dc_x * t455;
        let t525 = t385 * t396 + b_x * t411 + c_x * t426 + unit_db_x * t441
            + unit_dc_x * t456;
        let t526 = t386 * t394 + b_y * t409 + c_y * t424 + unit_db_y * t439
            + unit_dc_y * t454;
        let t527 = t386 * t395 + b_y * t410 + c_y * t425 + unit_db_y * t440
            + unit_dc_y * t455;
        let t528 = t386 * t396 + b_y * t411 + c_y * t426 + unit_db_y * t441
            + unit_dc_y * t456;
        let t529 = t387 * t394 + b_z * t409 + c_z * t424 + unit_db_z * t439
            + unit_dc_z * t454;
        let t530 = t387 * t395 + b_z * t410 + c_z * t425 + unit_db_z * t440
            + unit_dc_z * t455;
        let t531 = t387 * t396 + b_z * t411 + c_z * t426 + unit_db_z * t441
            + unit_dc_z * t456;
        let t532 = t385 * t397 + b_x * t412 + c_x * t427 - unit_db_x * t442
            + unit_dc_x * t457;
        let t533 = t385 * t398 + b_x * t413 + c_x * t428 - unit_db_x * t443
            + unit_dc_x * t458;
        let t534 = t385 * t399 + b_x * t414 + c_x * t429 - unit_db_x * t444
            + unit_dc_x * t459;
        let t535 = t386 * t397 + b_y * t412 + c_y * t427 - unit_db_y * t442
            + unit_dc_y * t457;
        let t536 = t386 * t398 + b_y * t413 + c_y * t428 - unit_db_y * t443
            + unit_dc_y * t458;
        let t537 = t386 * t399 + b_y * t414 + c_y * t429 - unit_db_y * t444
            + unit_dc_y * t459;
        let t538 = t387 * t397 + b_z * t412 + c_z * t427 - unit_db_z * t442
            + unit_dc_z * t457;
        let t539 = t387 * t398 + b_z * t413 + c_z * t428 - unit_db_z * t443
            + unit_dc_z * t458;
        let t540 = t387 * t399 + b_z * t414 + c_z * t429 - unit_db_z * t444
            + unit_dc_z * t459;
        let t541 = t385 * t400 + b_x * t415 + c_x * t430 - unit_db_x * t445
            + unit_dc_x * t460;
        let t542 = t385 * t401 + b_x * t416 + c_x * t431 - unit_db_x * t446
            + unit_dc_x * t461;
        let t543 = t385 * t402 + b_x * t417 + c_x * t432 - unit_db_x * t447
            + unit_dc_x * t462;
        let t544 = t386 * t400 + b_y * t415 + c_y * t430 - unit_db_y * t445
            + unit_dc_y * t460;
        let t545 = t386 * t401 + b_y * t416 + c_y * t431 - unit_db_y * t446
            + unit_dc_y * t461;
        let t546 = t386 * t402 + b_y * t417 + c_y * t432 - unit_db_y * t447
            + unit_dc_y * t462;
        let t547 = t387 * t400 + b_z * t415 + c_z * t430 - unit_db_z * t445
            + unit_dc_z * t460;
        let t548 = t387 * t401 + b_z * t416 + c_z * t431 - unit_db_z * t446
            + unit_dc_z * t461;
        let t549 = t387 * t402 + b_z * t417 + c_z * t432 - unit_db_z * t447
            + unit_dc_z * t462;
        let t550 = t385 * t403 + b_x * t418 + c_x * t433 + unit_db_x * t448
            + unit_dc_x * t463;
        let t551 = t385 * t404 + b_x * t419 + c_x * t434 + unit_db_x * t449
            + unit_dc_x * t464;
        let t552 = t385 * t405 + b_x * t420 + c_x * t435 + unit_db_x * t450
            + unit_dc_x * t465;
        let t553 = t386 * t403 + b_y * t418 + c_y * t433 + unit_db_y * t448
            + unit_dc_y * t463;
        let t554 = t386 * t404 + b_y * t419 + c_y * t434 + unit_db_y * t449
            + unit_dc_y * t464;
        let t555 = t386 * t405 + b_y * t420 + c_y * t435 + unit_db_y * t450
            + unit_dc_y * t465;
        let t556 = t387 * t403 + b_z * t418 + c_z * t433 + unit_db_z * t448
            + unit_dc_z * t463;
        let t557 = t387 * t404 + b_z * t419 + c_z * t434 + unit_db_z * t449
            + unit_dc_z * t464;
        let t558 = t387 * t405 + b_z * t420 + c_z * t435 + unit_db_z * t450
            + unit_dc_z * t465;
        let t559 = t385 * t406 + b_x * t421 + c_x * t436 - unit_db_x * t451
            + unit_dc_x * t466;
        let t560 = t385 * t407 + b_x * t422 + c_x * t437 - unit_db_x * t452
            + unit_dc_x * t467;
        let t561 = t385 * t408 + b_x * t423 + c_x * t438 - unit_db_x * t453
            + unit_dc_x * t468;
        let t562 = t386 * t406 + b_y * t421 + c_y * t436 - unit_db_y * t451
            + unit_dc_y * t466;
        let t563 = t386 * t407 + b_y * t422 + c_y * t437 - unit_db_y * t452
            + unit_dc_y * t467;
        let t564 = t386 * t408 + b_y * t423 + c_y * t438 - unit_db_y * t453
            + unit_dc_y * t468;
        let t565 = t387 * t406 + b_z * t421 + c_z * t436 - unit_db_z * t451
            + unit_dc_z * t466;
        let t566 = t387 * t407 + b_z * t422 + c_z * t437 - unit_db_z * t452
            + unit_dc_z * t467;
        let t567 = t387 * t408 + b_z * t423 + c_z * t438 - unit_db_z * t453
            + unit_dc_z * t468;
        let t568 = 2.0 * (t75 * t82 + t85 * t86 + t88 * t89);
        let t569 = 2.0 * (t75 * t164 - t85 * t165 - t88 * t163);
        let t570 = 2.0 * (t75 * t186 + t85 * t185);
        stiffness[0][0] = t523 + t568;
        stiffness[0][1] = t524;
        stiffness[0][2] = t525;
        stiffness[0][3] = t526;
        stiffness[0][4] = t527 + t568;
        stiffness[0][5] = t528;
        stiffness[0][6] = t529;
        stiffness[0][7] = t530;
        stiffness[0][8] = t531 + t568;
        stiffness[1][0] = t321 + t532;
        stiffness[1][1] = t533;
        stiffness[1][2] = t534;
        stiffness[1][3] = t535;
        stiffness[1][4] = t321 + t536;
        stiffness[1][5] = t537;
        stiffness[1][6] = t538;
        stiffness[1][7] = t539;
        stiffness[1][8] = t321 + t540;
        stiffness[2][0] = t550 - t336;
        stiffness[2][1] = t551;
        stiffness[2][2] = t552;
        stiffness[2][3] = t553;
        stiffness[2][4] = t554 - t336;
        stiffness[2][5] = t555;
        stiffness[2][6] = t556;
        stiffness[2][7] = t557;
        stiffness[2][8] = t558 - t336;
        stiffness[3][0] = t322 + t541;
        stiffness[3][1] = t542;
        stiffness[3][2] = t543;
        stiffness[3][3] = t544;
        stiffness[3][4] = t322 + t545;
        stiffness[3][5] = t546;
        stiffness[3][6] = t547;
        stiffness[3][7] = t548;
        stiffness[3][8] = t322 + t549;
        stiffness[4][0] = t347 + t559;
        stiffness[4][1] = t560;
        stiffness[4][2] = t561;
        stiffness[4][3] = t562;
        stiffness[4][4] = t347 + t563;
        stiffness[4][5] = t564;
        stiffness[4][6] = t565;
        stiffness[4][7] = t566;
        stiffness[4][8] = t347 + t567;
        stiffness[5][0] = a_x * t412 + t388 * t469 + unit_db_x * t481 + unit_dc_x * t487
            + t569;
        stiffness[5][1] = a_x * t413 + t388 * t470 + unit_db_x * t482 + unit_dc_x * t488;
        stiffness[5][2] = a_x * t414 + t388 * t471 + unit_db_x * t483 + unit_dc_x * t489;
        stiffness[5][3] = a_y * t412 + t389 * t469 + unit_db_y * t481 + unit_dc_y * t487;
        stiffness[5][4] = a_y * t413 + t389 * t470 + unit_db_y * t482 + unit_dc_y * t488
            + t569;
        stiffness[5][5] = a_y * t414 + t389 * t471 + unit_db_y * t483 + unit_dc_y * t489;
        stiffness[5][6] = a_z * t412 + t390 * t469 + unit_db_z * t481 + unit_dc_z * t487;
        stiffness[5][7] = a_z * t413 + t390 * t470 + unit_db_z * t482 + unit_dc_z * t488;
        stiffness[5][8] = a_z * t414 + t390 * t471 + unit_db_z * t483 + unit_dc_z * t489
            + t569;
        stiffness[6][0] = t361
            + (a_x * t418 + t388 * t475 + unit_db_x * t484 + unit_dc_x * t493);
        stiffness[6][1] = a_x * t419 + t388 * t476 + unit_db_x * t485 + unit_dc_x * t494;
        stiffness[6][2] = a_x * t420 + t388 * t477 + unit_db_x * t486 + unit_dc_x * t495;
        stiffness[6][3] = a_y * t418 + t389 * t475 + unit_db_y * t484 + unit_dc_y * t493;
        stiffness[6][4] = t361
            + (a_y * t419 + t389 * t476 + unit_db_y * t485 + unit_dc_y * t494);
        stiffness[6][5] = a_y * t420 + t389 * t477 + unit_db_y * t486 + unit_dc_y * t495;
        stiffness[6][6] = a_z * t418 + t390 * t475 + unit_db_z * t484 + unit_dc_z * t493;
        stiffness[6][7] = a_z * t419 + t390 * t476 + unit_db_z * t485 + unit_dc_z * t494;
        stiffness[6][8] = t361
            + (a_z * t420 + t390 * t477 + unit_db_z * t486 + unit_dc_z * t495);
        stiffness[7][0] = t361 + (b_x * t481 - a_x * t442 + c_x * t505);
        stiffness[7][1] = b_x * t482 - a_x * t443 + c_x * t506;
        stiffness[7][2] = b_x * t483 - a_x * t444 + c_x * t507;
        stiffness[7][3] = b_y * t481 - a_y * t442 + c_y * t505;
        stiffness[7][4] = t361 + (b_y * t482 - a_y * t443 + c_y * t506);
        stiffness[7][5] = b_y * t483 - a_y * t444 + c_y * t507;
        stiffness[7][6] = b_z * t481 - a_z * t442 + c_z * t505;
        stiffness[7][7] = b_z * t482 - a_z * t443 + c_z * t506;
        stiffness[7][8] = t361 + (b_z * t483 - a_z * t444 + c_z * t507);
        stiffness[8][0] = a_x * t448 + b_x * t484 + c_x * t511;
        stiffness[8][1] = a_x * t449 + b_x * t485 + c_x * t512;
        stiffness[8][2] = a_x * t450 + b_x * t486 + c_x * t513;
        stiffness[8][3] = a_y * t448 + b_y * t484 + c_y * t511;
        stiffness[8][4] = a_y * t449 + b_y * t485 + c_y * t512;
        stiffness[8][5] = a_y * t450 + b_y * t486 + c_y * t513;
        stiffness[8][6] = a_z * t448 + b_z * t484 + c_z * t511;
        stiffness[8][7] = a_z * t449 + b_z * t485 + c_z * t512;
        stiffness[8][8] = a_z * t450 + b_z * t486 + c_z * t513;
        stiffness[9][0] = a_x * t415 + t388 * t472 + unit_dc_x * t490;
        stiffness[9][1] = a_x * t416 + t388 * t473 + unit_dc_x * t491;
        stiffness[9][2] = a_x * t417 + t388 * t474 + unit_dc_x * t492;
        stiffness[9][3] = a_y * t415 + t389 * t472 + unit_dc_y * t490;
        stiffness[9][4] = a_y * t416 + t389 * t473 + unit_dc_y * t491;
        stiffness[9][5] = a_y * t417 + t389 * t474 + unit_dc_y * t492;
        stiffness[9][6] = a_z * t415 + t390 * t472 + unit_dc_z * t490;
        stiffness[9][7] = a_z * t416 + t390 * t473 + unit_dc_z * t491;
        stiffness[9][8] = a_z * t417 + t390 * t474 + unit_dc_z * t492;
        stiffness[10][0] = t363 + (a_x * t421 + t388 * t478 + unit_dc_x * t496);
        stiffness[10][1] = a_x * t422 + t388 * t479 + unit_dc_x * t497;
        stiffness[10][2] = a_x * t423 + t388 * t480 + unit_dc_x * t498;
        stiffness[10][3] = a_y * t421 + t389 * t478 + unit_dc_y * t496;
        stiffness[10][4] = t363 + (a_y * t422 + t389 * t479 + unit_dc_y * t497);
        stiffness[10][5] = a_y * t423 + t389 * t480 + unit_dc_y * t498;
        stiffness[10][6] = a_z * t421 + t390 * t478 + unit_dc_z * t496;
        stiffness[10][7] = a_z * t422 + t390 * t479 + unit_dc_z * t497;
        stiffness[10][8] = t363 + (a_z * t423 + t390 * t480 + unit_dc_z * t498);
        stiffness[11][0] = t375 + (c_x * t508 - a_x * t445);
        stiffness[11][1] = c_x * t509 - a_x * t446;
        stiffness[11][2] = c_x * t510 - a_x * t447;
        stiffness[11][3] = c_y * t508 - a_y * t445;
        stiffness[11][4] = t375 + (c_y * t509 - a_y * t446);
        stiffness[11][5] = c_y * t510 - a_y * t447;
        stiffness[11][6] = c_z * t508 - a_z * t445;
        stiffness[11][7] = c_z * t509 - a_z * t446;
        stiffness[11][8] = t375 + (c_z * t510 - a_z * t447);
        stiffness[12][0] = c_x * t514 - a_x * t451;
        stiffness[12][1] = c_x * t515 - a_x * t452;
        stiffness[12][2] = c_x * t516 - a_x * t453;
        stiffness[12][3] = c_y * t514 - a_y * t451;
        stiffness[12][4] = c_y * t515 - a_y * t452;
        stiffness[12][5] = c_y * t516 - a_y * t453;
        stiffness[12][6] = c_z * t514 - a_z * t451;
        stiffness[12][7] = c_z * t515 - a_z * t452;
        stiffness[12][8] = c_z * t516 - a_z * t453;
        stiffness[13][0] = a_x * t430 + t391 * t499 + unit_db_x * t508 + unit_dc_x * t517
            + t570;
        stiffness[13][1] = a_x * t431 + t391 * t500 + unit_db_x * t509
            + unit_dc_x * t518;
        stiffness[13][2] = a_x * t432 + t391 * t501 + unit_db_x * t510
            + unit_dc_x * t519;
        stiffness[13][3] = a_y * t430 + t392 * t499 + unit_db_y * t508
            + unit_dc_y * t517;
        stiffness[13][4] = a_y * t431 + t392 * t500 + unit_db_y * t509 + unit_dc_y * t518
            + t570;
        stiffness[13][5] = a_y * t432 + t392 * t501 + unit_db_y * t510
            + unit_dc_y * t519;
        stiffness[13][6] = a_z * t430 + t393 * t499 + unit_db_z * t508
            + unit_dc_z * t517;
        stiffness[13][7] = a_z * t431 + t393 * t500 + unit_db_z * t509
            + unit_dc_z * t518;
        stiffness[13][8] = a_z * t432 + t393 * t501 + unit_db_z * t510 + unit_dc_z * t519
            + t570;
        stiffness[14][0] = t384
            + (a_x * t436 + t391 * t502 + unit_db_x * t514 + unit_dc_x * t520);
        stiffness[14][1] = a_x * t437 + t391 * t503 + unit_db_x * t515
            + unit_dc_x * t521;
        stiffness[14][2] = a_x * t438 + t391 * t504 + unit_db_x * t516
            + unit_dc_x * t522;
        stiffness[14][3] = a_y * t436 + t392 * t502 + unit_db_y * t514
            + unit_dc_y * t520;
        stiffness[14][4] = t384
            + (a_y * t437 + t392 * t503 + unit_db_y * t515 + unit_dc_y * t521);
        stiffness[14][5] = a_y * t438 + t392 * t504 + unit_db_y * t516
            + unit_dc_y * t522;
        stiffness[14][6] = a_z * t436 + t393 * t502 + unit_db_z * t514
            + unit_dc_z * t520;
        stiffness[14][7] = a_z * t437 + t393 * t503 + unit_db_z * t515
            + unit_dc_z * t521;
        stiffness[14][8] = t384
            + (a_z * t438 + t393 * t504 + unit_db_z * t516 + unit_dc_z * t522);
        stiffness[15][0] = t384 + (a_x * t460 + b_x * t490 + c_x * t517);
        stiffness[15][1] = a_x * t461 + b_x * t491 + c_x * t518;
        stiffness[15][2] = a_x * t462 + b_x * t492 + c_x * t519;
        stiffness[15][3] = a_y * t460 + b_y * t490 + c_y * t517;
        stiffness[15][4] = t384 + (a_y * t461 + b_y * t491 + c_y * t518);
        stiffness[15][5] = a_y * t462 + b_y * t492 + c_y * t519;
        stiffness[15][6] = a_z * t460 + b_z * t490 + c_z * t517;
        stiffness[15][7] = a_z * t461 + b_z * t491 + c_z * t518;
        stiffness[15][8] = t384 + (a_z * t462 + b_z * t492 + c_z * t519);
        stiffness[16][0] = a_x * t466 + b_x * t496 + c_x * t520;
        stiffness[16][1] = a_x * t467 + b_x * t497 + c_x * t521;
        stiffness[16][2] = a_x * t468 + b_x * t498 + c_x * t522;
        stiffness[16][3] = a_y * t466 + b_y * t496 + c_y * t520;
        stiffness[16][4] = a_y * t467 + b_y * t497 + c_y * t521;
        stiffness[16][5] = a_y * t468 + b_y * t498 + c_y * t522;
        stiffness[16][6] = a_z * t466 + b_z * t496 + c_z * t520;
        stiffness[16][7] = a_z * t467 + b_z * t497 + c_z * t521;
        stiffness[16][8] = a_z * t468 + b_z * t498 + c_z * t522;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 56 additions, 84 multiplications, 3 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points2_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
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
    /// Operations: 49 additions, 83 multiplications, 1 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points3_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t36 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t37 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t38 = a_x * a_x + a_y * a_y + a_z * a_z - (t36 * t36 + t37 * t37);
        let t39 = t38.sqrt();
        let t40 = length * reference[9]
            * (t39 - 1.0 + t36 * reference[21] + t37 * reference[25] - reference[0]);
        let t41 = 1.0 / (2.0 * t39);
        let t42 = length * reference[27];
        let t43 = t40 * t41;
        let t44 = length * reference[10] * (t36 + t37 * reference[26] - reference[1]);
        let t45 = t40 * (reference[21] - t41 * (t36 * 2.0)) + t44;
        let t46 = t40 * (reference[25] - t41 * (t37 * 2.0)) + reference[26] * t44
            + length * reference[11] * (t37 - reference[2]);
        let t47 = t42 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[3]);
        let t48 = 0.5 * t47;
        let t49 = length * reference[28]
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t50 = t42 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[4]);
        let t51 = 0.5 * t50;
        forces[0][0] = t43 * (a_x * 2.0) + b_x * t45 + c_x * t46;
        forces[0][1] = t43 * (a_y * 2.0) + b_y * t45 + c_y * t46;
        forces[0][2] = t43 * (a_z * 2.0) + b_z * t45 + c_z * t46;
        forces[1][0] = a_x * t45 + t48 * (b_x * 2.0) + c_x * t49;
        forces[1][1] = a_y * t45 + t48 * (b_y * 2.0) + c_y * t49;
        forces[1][2] = a_z * t45 + t48 * (b_z * 2.0) + c_z * t49;
        forces[2][0] = a_x * t46 + b_x * t49 + t51 * (c_x * 2.0);
        forces[2][1] = a_y * t46 + b_y * t49 + t51 * (c_y * 2.0);
        forces[2][2] = a_z * t46 + b_z * t49 + t51 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 182 additions, 306 multiplications, 4 divisions, 1 function calls.
    pub fn full_beam_spatial_curved_points3_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t36 = a_x * b_x + a_y * b_y + a_z * b_z;
        let t37 = a_x * c_x + a_y * c_y + a_z * c_z;
        let t38 = a_x * a_x + a_y * a_y + a_z * a_z - (t36 * t36 + t37 * t37);
        let t39 = t38.sqrt();
        let t40 = length * reference[9];
        let t41 = t40
            * (t39 - 1.0 + t36 * reference[21] + t37 * reference[25] - reference[0]);
        let t42 = 2.0 * t39;
        let t43 = 1.0 / t42;
        let t44 = t40 * t43;
        let t45 = 2.0 * t43;
        let t46 = t43 * t45 / t42;
        let t47 = t43 * t44 - t41 * t46;
        let t48 = t36 * 2.0;
        let t49 = t43 * t48;
        let t50 = reference[21] - t49;
        let t51 = t40 * t50;
        let t52 = t43 * (2.0 * t49) / t42;
        let t53 = t43 * t51 + t41 * t52;
        let t54 = t37 * 2.0;
        let t55 = t43 * t54;
        let t56 = reference[25] - t55;
        let t57 = t40 * t56;
        let t58 = t43 * (2.0 * t55) / t42;
        let t59 = t43 * t57 + t41 * t58;
        let t60 = t44 * t50 + t41 * (t46 * t48);
        let t61 = length * reference[10];
        let t62 = t61 + (t50 * t51 - t41 * (t45 + t48 * t52));
        let t63 = reference[26] * t61;
        let t64 = t50 * t57 - t41 * (t48 * t58) + t63;
        let t65 = t44 * t56 + t41 * (t46 * t54);
        let t66 = t63 + (t51 * t56 - t41 * (t52 * t54));
        let t67 = length * reference[11];
        let t68 = t67 + (t56 * t57 - t41 * (t45 + t54 * t58) + reference[26] * t63);
        let t69 = length * reference[27];
        let t70 = 0.5 * (0.5 * t69);
        let t71 = length * reference[28];
        let t72 = t61 * (t36 + t37 * reference[26] - reference[1]);
        let t73 = t41 * t50 + t72;
        let t74 = t41 * t56 + reference[26] * t72 + t67 * (t37 - reference[2]);
        let t75 = t69 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[3]);
        let t76 = t71 * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t77 = t69 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[4]);
        let t78 = a_x * 2.0;
        let t79 = a_y * 2.0;
        let t80 = a_z * 2.0;
        let t81 = b_x * 2.0;
        let t82 = b_y * 2.0;
        let t83 = b_z * 2.0;
        let t84 = c_x * 2.0;
        let t85 = c_y * 2.0;
        let t86 = c_z * 2.0;
        let t87 = t47 * t78 + b_x * t53 + c_x * t59;
        let t88 = t47 * t79 + b_y * t53 + c_y * t59;
        let t89 = t47 * t80 + b_z * t53 + c_z * t59;
        let t90 = a_x * t53;
        let t91 = a_y * t53;
        let t92 = a_z * t53;
        let t93 = a_x * t59;
        let t94 = a_y * t59;
        let t95 = a_z * t59;
        let t96 = t60 * t78 + b_x * t62 + c_x * t64;
        let t97 = t60 * t79 + b_y * t62 + c_y * t64;
        let t98 = t60 * t80 + b_z * t62 + c_z * t64;
        let t99 = a_x * t62;
        let t100 = a_y * t62;
        let t101 = a_z * t62;
        let t102 = a_x * t64;
        let t103 = a_y * t64;
        let t104 = a_z * t64;
        let t105 = t65 * t78 + b_x * t66 + c_x * t68;
        let t106 = t65 * t79 + b_y * t66 + c_y * t68;
        let t107 = t65 * t80 + b_z * t66 + c_z * t68;
        let t108 = a_x * t66;
        let t109 = a_y * t66;
        let t110 = a_z * t66;
        let t111 = a_x * t68;
        let t112 = a_y * t68;
        let t113 = a_z * t68;
        let t114 = t70 * t81;
        let t115 = t70 * t82;
        let t116 = t70 * t83;
        let t117 = c_x * t71;
        let t118 = c_y * t71;
        let t119 = c_z * t71;
        let t120 = b_x * t71;
        let t121 = b_y * t71;
        let t122 = b_z * t71;
        let t123 = t70 * t84;
        let t124 = t70 * t85;
        let t125 = t70 * t86;
        let t126 = 2.0 * (t41 * t43);
        let t127 = 2.0 * (0.5 * t75);
        let t128 = 2.0 * (0.5 * t77);
        stiffness[0][0] = t78 * t87 + b_x * t96 + c_x * t105 + t126;
        stiffness[0][1] = t78 * t88 + b_x * t97 + c_x * t106;
        stiffness[0][2] = t78 * t89 + b_x * t98 + c_x * t107;
        stiffness[0][3] = t79 * t87 + b_y * t96 + c_y * t105;
        stiffness[0][4] = t79 * t88 + b_y * t97 + c_y * t106 + t126;
        stiffness[0][5] = t79 * t89 + b_y * t98 + c_y * t107;
        stiffness[0][6] = t80 * t87 + b_z * t96 + c_z * t105;
        stiffness[0][7] = t80 * t88 + b_z * t97 + c_z * t106;
        stiffness[0][8] = t80 * t89 + b_z * t98 + c_z * t107 + t126;
        stiffness[1][0] = t73 + (t78 * t90 + b_x * t99 + c_x * t108);
        stiffness[1][1] = t78 * t91 + b_x * t100 + c_x * t109;
        stiffness[1][2] = t78 * t92 + b_x * t101 + c_x * t110;
        stiffness[1][3] = t79 * t90 + b_y * t99 + c_y * t108;
        stiffness[1][4] = t73 + (t79 * t91 + b_y * t100 + c_y * t109);
        stiffness[1][5] = t79 * t92 + b_y * t101 + c_y * t110;
        stiffness[1][6] = t80 * t90 + b_z * t99 + c_z * t108;
        stiffness[1][7] = t80 * t91 + b_z * t100 + c_z * t109;
        stiffness[1][8] = t73 + (t80 * t92 + b_z * t101 + c_z * t110);
        stiffness[2][0] = t74 + (t78 * t93 + b_x * t102 + c_x * t111);
        stiffness[2][1] = t78 * t94 + b_x * t103 + c_x * t112;
        stiffness[2][2] = t78 * t95 + b_x * t104 + c_x * t113;
        stiffness[2][3] = t79 * t93 + b_y * t102 + c_y * t111;
        stiffness[2][4] = t74 + (t79 * t94 + b_y * t103 + c_y * t112);
        stiffness[2][5] = t79 * t95 + b_y * t104 + c_y * t113;
        stiffness[2][6] = t80 * t93 + b_z * t102 + c_z * t111;
        stiffness[2][7] = t80 * t94 + b_z * t103 + c_z * t112;
        stiffness[2][8] = t74 + (t80 * t95 + b_z * t104 + c_z * t113);
        stiffness[3][0] = a_x * t99 + t81 * t114 + c_x * t117 + t127;
        stiffness[3][1] = a_x * t100 + t81 * t115 + c_x * t118;
        stiffness[3][2] = a_x * t101 + t81 * t116 + c_x * t119;
        stiffness[3][3] = a_y * t99 + t82 * t114 + c_y * t117;
        stiffness[3][4] = a_y * t100 + t82 * t115 + c_y * t118 + t127;
        stiffness[3][5] = a_y * t101 + t82 * t116 + c_y * t119;
        stiffness[3][6] = a_z * t99 + t83 * t114 + c_z * t117;
        stiffness[3][7] = a_z * t100 + t83 * t115 + c_z * t118;
        stiffness[3][8] = a_z * t101 + t83 * t116 + c_z * t119 + t127;
        stiffness[4][0] = t76 + (a_x * t102 + c_x * t120);
        stiffness[4][1] = a_x * t103 + c_x * t121;
        stiffness[4][2] = a_x * t104 + c_x * t122;
        stiffness[4][3] = a_y * t102 + c_y * t120;
        stiffness[4][4] = t76 + (a_y * t103 + c_y * t121);
        stiffness[4][5] = a_y * t104 + c_y * t122;
        stiffness[4][6] = a_z * t102 + c_z * t120;
        stiffness[4][7] = a_z * t103 + c_z * t121;
        stiffness[4][8] = t76 + (a_z * t104 + c_z * t122);
        stiffness[5][0] = a_x * t111 + b_x * t120 + t84 * t123 + t128;
        stiffness[5][1] = a_x * t112 + b_x * t121 + t84 * t124;
        stiffness[5][2] = a_x * t113 + b_x * t122 + t84 * t125;
        stiffness[5][3] = a_y * t111 + b_y * t120 + t85 * t123;
        stiffness[5][4] = a_y * t112 + b_y * t121 + t85 * t124 + t128;
        stiffness[5][5] = a_y * t113 + b_y * t122 + t85 * t125;
        stiffness[5][6] = a_z * t111 + b_z * t120 + t86 * t123;
        stiffness[5][7] = a_z * t112 + b_z * t121 + t86 * t124;
        stiffness[5][8] = a_z * t113 + b_z * t122 + t86 * t125 + t128;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 31 additions, 47 multiplications, 1 function calls.
    pub fn full_beam_spatial_curved_points3_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 31],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
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
    /// Operations: 773 additions, 1061 multiplications, 33 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_elastic_force(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 155],
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
                    ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
                    ::rncf::emitted::array(&reference[62 + 31 * point..][..31]),
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
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 and 3 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 7197 additions, 8639 multiplications, 114 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_elastic_tangent(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 155],
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
                    ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
                    ::rncf::emitted::array(&reference[62 + 31 * point..][..31]),
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
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 2 and 3 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 381 additions, 485 multiplications, 6 divisions, 5 function calls.
    pub fn full_beam_spatial_curved_strain_energy(
        row: &FullBeamSpatialCurved,
        reference: &[f64; 155],
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
                            ::rncf::emitted::array(&reference[0 + 31 * point..][..31]),
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
    pub fn full_beam_spatial_curved_reference(
        row: &FullBeamSpatialCurved,
        q: &[f64; 30],
        reference: &mut [f64; 155],
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
    /// Operations: 376 additions, 529 multiplications, 35 divisions, 2 function calls.
    pub fn full_beam_spatial_curved_field_forces(
        row: &FullBeamSpatialCurved,
        coefficients: &[f64; 25],
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let FullBeamSpatialCurved { length, .. } = *row;
        let [D1, D2, D3, D4, D5, D6, L21, L31, L32, L41, L42, L43, L51, L52, L53, L54,
        L61, L62, L63, L64, L65, held, half_held, smooth, half_smooth] = *coefficients;
        let t67 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t68 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8];
        let t69 = fields[3] * fields[12] + fields[4] * fields[13]
            + fields[5] * fields[14];
        let t70 = fields[6] * fields[9] + fields[7] * fields[10]
            + fields[8] * fields[11];
        let t71 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0);
        let t72 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0);
        let t73 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
            - (t67 * t67 + t68 * t68);
        let t74 = t73.sqrt();
        let t75 = t74 - 1.0;
        let t76 = 0.5 * (t70 - t69);
        let t77 = 1.0 - t71;
        let t78 = 1.0 - t72;
        let t79 = t77 * t78;
        let t80 = (fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14] + t67 * t76) / t74;
        let t81 = t78 * t80;
        let t82 = (fields[0] * fields[9] + fields[1] * fields[10]
            + fields[2] * fields[11] - t68 * t76) / t74;
        let t83 = t77 * t82;
        let t84 = t76 * t79 + t81 * L21 - t83 * L31 + t75 * L41 + t67 * L51;
        let t85 = stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
            + stress_free[2] * stress_free[5];
        let t86 = stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
            + stress_free[2] * stress_free[8];
        let t87 = stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
            + stress_free[5] * stress_free[14];
        let t88 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11];
        let t89 = 0.5
            * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                + stress_free[5] * stress_free[5] - 1.0);
        let t90 = 0.5
            * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                + stress_free[8] * stress_free[8] - 1.0);
        let t91 = stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
            + stress_free[2] * stress_free[2] - (t85 * t85 + t86 * t86);
        let t92 = t91.sqrt();
        let t93 = t92 - 1.0;
        let t94 = 0.5 * (t88 - t87);
        let t95 = 1.0 - t89;
        let t96 = 1.0 - t90;
        let t97 = t96
            * ((stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14] + t85 * t94) / t92);
        let t98 = t95
            * ((stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11] - t86 * t94) / t92);
        let t99 = t94 * (t95 * t96) + L21 * t97 - L31 * t98 + L41 * t93 + L51 * t85;
        let t100 = D1 * (t84 + t68 * L61 - (t99 + L61 * t86));
        let t101 = t67 * 2.0;
        let t102 = t68 * 2.0;
        let t103 = 1.0 / (t74 * 2.0);
        let t104 = (fields[0] * 2.0 - (fields[3] * t101 + fields[6] * t102)) * t103;
        let t105 = t78 * ((fields[12] + fields[3] * t76 - t80 * t104) / t74);
        let t106 = t77 * ((fields[9] - fields[6] * t76 - t82 * t104) / t74);
        let t107 = L21 * t105 - L31 * t106 + L41 * t104 + fields[3] * L51
            + fields[6] * L61;
        let t108 = t103 * (fields[1] * 2.0 - (fields[4] * t101 + fields[7] * t102));
        let t109 = t78 * ((fields[13] + fields[4] * t76 - t80 * t108) / t74);
        let t110 = t77 * ((fields[10] - fields[7] * t76 - t82 * t108) / t74);
        let t111 = L21 * t109 - L31 * t110 + L41 * t108 + fields[4] * L51
            + fields[7] * L61;
        let t112 = t103 * (fields[2] * 2.0 - (fields[5] * t101 + fields[8] * t102));
        let t113 = t78 * ((fields[14] + fields[5] * t76 - t80 * t112) / t74);
        let t114 = t77 * ((fields[11] - fields[8] * t76 - t82 * t112) / t74);
        let t115 = L21 * t113 - L31 * t114 + L41 * t112 + fields[5] * L51
            + fields[8] * L61;
        let t116 = 0.5 * (fields[3] * 2.0);
        let t117 = t103 * (fields[0] * t101);
        let t118 = fields[12] * 0.5;
        let t119 = fields[0] * t76;
        let t120 = t78 * ((t119 - t67 * t118 + t80 * t117) / t74);
        let t121 = t77 * ((t68 * t118 + t82 * t117) / t74) - t82 * t116;
        let t122 = L21 * t120 - (t79 * t118 + t76 * (t78 * t116)) - L31 * t121
            - L41 * t117;
        let t123 = 0.5 * (fields[4] * 2.0);
        let t124 = t103 * (fields[1] * t101);
        let t125 = fields[13] * 0.5;
        let t126 = fields[1] * t76;
        let t127 = t78 * ((t126 - t67 * t125 + t80 * t124) / t74);
        let t128 = t77 * ((t68 * t125 + t82 * t124) / t74) - t82 * t123;
        let t129 = L21 * t127 - (t79 * t125 + t76 * (t78 * t123)) - L31 * t128
            - L41 * t124;
        let t130 = 0.5 * (fields[5] * 2.0);
        let t131 = t103 * (fields[2] * t101);
        let t132 = fields[14] * 0.5;
        let t133 = fields[2] * t76;
        let t134 = t78 * ((t133 - t67 * t132 + t80 * t131) / t74);
        let t135 = t77 * ((t68 * t132 + t82 * t131) / t74) - t82 * t130;
        let t136 = L21 * t134 - (t79 * t132 + t76 * (t78 * t130)) - L31 * t135
            - L41 * t131;
        let t137 = 0.5 * (fields[6] * 2.0);
        let t138 = t103 * (fields[0] * t102);
        let t139 = fields[9] * 0.5;
        let t140 = t78 * ((t67 * t139 + t80 * t138) / t74) - t80 * t137;
        let t141 = t77 * ((t82 * t138 - (t119 + t68 * t139)) / t74);
        let t142 = t79 * t139 - t76 * (t77 * t137) + L21 * t140 - L31 * t141
            - L41 * t138;
        let t143 = 0.5 * (fields[7] * 2.0);
        let t144 = t103 * (fields[1] * t102);
        let t145 = fields[10] * 0.5;
        let t146 = t78 * ((t67 * t145 + t80 * t144) / t74) - t80 * t143;
        let t147 = t77 * ((t82 * t144 - (t126 + t68 * t145)) / t74);
        let t148 = t79 * t145 - t76 * (t77 * t143) + L21 * t146 - L31 * t147
            - L41 * t144;
        let t149 = 0.5 * (fields[8] * 2.0);
        let t150 = t103 * (fields[2] * t102);
        let t151 = fields[11] * 0.5;
        let t152 = t78 * ((t67 * t151 + t80 * t150) / t74) - t80 * t149;
        let t153 = t77 * ((t82 * t150 - (t133 + t68 * t151)) / t74);
        let t154 = t79 * t151 - t76 * (t77 * t149) + L21 * t152 - L31 * t153
            - L41 * t150;
        let t155 = fields[6] * 0.5;
        let t156 = t78 * (t67 * t155 / t74);
        let t157 = t77 * ((fields[0] - t68 * t155) / t74);
        let t158 = fields[7] * 0.5;
        let t159 = t78 * (t67 * t158 / t74);
        let t160 = t77 * ((fields[1] - t68 * t158) / t74);
        let t161 = fields[8] * 0.5;
        let t162 = t78 * (t67 * t161 / t74);
        let t163 = t77 * ((fields[2] - t68 * t161) / t74);
        let t164 = fields[3] * 0.5;
        let t165 = t78 * ((fields[0] - t67 * t164) / t74);
        let t166 = t77 * (t68 * t164 / t74);
        let t167 = fields[4] * 0.5;
        let t168 = t78 * ((fields[1] - t67 * t167) / t74);
        let t169 = t77 * (t68 * t167 / t74);
        let t170 = fields[5] * 0.5;
        let t171 = t78 * ((fields[2] - t67 * t170) / t74);
        let t172 = t77 * (t68 * t170 / t74);
        let t173 = t81 - t83 * L32 + t75 * L42 + t67 * L52 + t68 * L62
            - (t97 - L32 * t98 + L42 * t93 + L52 * t85 + L62 * t86);
        let t174 = D2 * t173;
        let t175 = t174
            * (t105 - L32 * t106 + L42 * t104 + fields[3] * L52 + fields[6] * L62);
        let t176 = t174
            * (t109 - L32 * t110 + L42 * t108 + fields[4] * L52 + fields[7] * L62);
        let t177 = t174
            * (t113 - L32 * t114 + L42 * t112 + fields[5] * L52 + fields[8] * L62);
        let t178 = t100 * (t122 + fields[0] * L51)
            + t174 * (t120 - L32 * t121 - L42 * t117 + fields[0] * L52);
        let t179 = t100 * (t129 + fields[1] * L51)
            + t174 * (t127 - L32 * t128 - L42 * t124 + fields[1] * L52);
        let t180 = t100 * (t136 + fields[2] * L51)
            + t174 * (t134 - L32 * t135 - L42 * t131 + fields[2] * L52);
        let t181 = t100 * (t142 + fields[0] * L61)
            + t174 * (t140 - L32 * t141 - L42 * t138 + fields[0] * L62);
        let t182 = t100 * (t148 + fields[1] * L61)
            + t174 * (t146 - L32 * t147 - L42 * t144 + fields[1] * L62);
        let t183 = t100 * (t154 + fields[2] * L61)
            + t174 * (t152 - L32 * t153 - L42 * t150 + fields[2] * L62);
        let t184 = t100 * (t79 * t155 + L21 * t156 - L31 * t157)
            + t174 * (t156 - L32 * t157);
        let t185 = t100 * (t79 * t158 + L21 * t159 - L31 * t160)
            + t174 * (t159 - L32 * t160);
        let t186 = t100 * (t79 * t161 + L21 * t162 - L31 * t163)
            + t174 * (t162 - L32 * t163);
        let t187 = t100 * (L21 * t165 - t79 * t164 - L31 * t166)
            + t174 * (t165 - L32 * t166);
        let t188 = t100 * (L21 * t168 - t79 * t167 - L31 * t169)
            + t174 * (t168 - L32 * t169);
        let t189 = t100 * (L21 * t171 - t79 * t170 - L31 * t172)
            + t174 * (t171 - L32 * t172);
        let t190 = t75 * L43 - t83 + t67 * L53 + t68 * L63
            - (L43 * t93 - t98 + L53 * t85 + L63 * t86);
        let t191 = D3 * t190;
        let t192 = t100 * t107 + t175
            + t191 * (L43 * t104 - t106 + fields[3] * L53 + fields[6] * L63);
        let t193 = t100 * t111 + t176
            + t191 * (L43 * t108 - t110 + fields[4] * L53 + fields[7] * L63);
        let t194 = t100 * t115 + t177
            + t191 * (L43 * t112 - t114 + fields[5] * L53 + fields[8] * L63);
        let t195 = t75 + t67 * L54 + t68 * L64 - (t93 + L54 * t85 + L64 * t86);
        let t196 = D4 * t195;
        let t197 = t178 + t191 * (fields[0] * L53 - (t121 + L43 * t117))
            + t196 * (fields[0] * L54 - t117);
        let t198 = t179 + t191 * (fields[1] * L53 - (t128 + L43 * t124))
            + t196 * (fields[1] * L54 - t124);
        let t199 = t180 + t191 * (fields[2] * L53 - (t135 + L43 * t131))
            + t196 * (fields[2] * L54 - t131);
        let t200 = t181 + t191 * (fields[0] * L63 - (t141 + L43 * t138))
            + t196 * (fields[0] * L64 - t138);
        let t201 = t182 + t191 * (fields[1] * L63 - (t147 + L43 * t144))
            + t196 * (fields[1] * L64 - t144);
        let t202 = t183 + t191 * (fields[2] * L63 - (t153 + L43 * t150))
            + t196 * (fields[2] * L64 - t150);
        let t203 = D5 * (t67 + t68 * L65 - (t85 + L65 * t86));
        let t204 = t192 + t196 * (t104 + fields[3] * L54 + fields[6] * L64)
            + t203 * (fields[3] + fields[6] * L65);
        let t205 = t193 + t196 * (t108 + fields[4] * L54 + fields[7] * L64)
            + t203 * (fields[4] + fields[7] * L65);
        let t206 = t194 + t196 * (t112 + fields[5] * L54 + fields[8] * L64)
            + t203 * (fields[5] + fields[8] * L65);
        let t207 = D6 * (t68 - t86);
        let t208 = held * (t71 - t89);
        let t209 = held * (t72 - t90);
        let t210 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t211 = half_held * t210;
        let t212 = t200 + t203 * (fields[0] * L65) + fields[0] * t207 + t137 * t209
            + fields[3] * t211;
        let t213 = t201 + t203 * (fields[1] * L65) + fields[1] * t207 + t143 * t209
            + fields[4] * t211;
        let t214 = t202 + t203 * (fields[2] * L65) + fields[2] * t207 + t149 * t209
            + fields[5] * t211;
        let t215 = fields[3] * fields[9] + fields[4] * fields[10]
            + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t216 = smooth * t215;
        let t217 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t218 = smooth * t217;
        let t219 = half_smooth * (t69 + t70 - (t87 + t88));
        let t220 = t197 + fields[0] * t203 + t116 * t208 + fields[6] * t211
            + fields[9] * t216 + fields[12] * t219;
        let t221 = t198 + fields[1] * t203 + t123 * t208 + fields[7] * t211
            + fields[10] * t216 + fields[13] * t219;
        let t222 = t199 + fields[2] * t203 + t130 * t208 + fields[8] * t211
            + fields[11] * t216 + fields[14] * t219;
        forces[0] = t204 + fields[6] * t207;
        forces[1] = t205 + fields[7] * t207;
        forces[2] = t206 + fields[8] * t207;
        forces[3] = t220;
        forces[4] = t221;
        forces[5] = t222;
        forces[6] = t212 + fields[12] * t218 + fields[9] * t219;
        forces[7] = t213 + fields[13] * t218 + fields[10] * t219;
        forces[8] = t214 + fields[14] * t218 + fields[11] * t219;
        forces[9] = t184 - t157 * t191 + fields[3] * t216 + fields[6] * t219;
        forces[10] = t185 - t160 * t191 + fields[4] * t216 + fields[7] * t219;
        forces[11] = t186 - t163 * t191 + fields[5] * t216 + fields[8] * t219;
        forces[12] = t187 - t166 * t191 + fields[6] * t218 + fields[3] * t219;
        forces[13] = t188 - t169 * t191 + fields[7] * t218 + fields[4] * t219;
        forces[14] = t189 - t172 * t191 + fields[8] * t218 + fields[5] * t219;
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
        pub model: Iea15mwBlade,
        pub row_blade: ::std::vec::Vec<FullBeamSpatialCurved>,
        pub reference_blade: ::std::vec::Vec<[f64; 155]>,
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
                        TABLE_POINTS.curve([0, 1, 2], &[0, 1, 2]),
                    ),
                    count: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Curve(
                                    TABLE_POINTS.curve([0, 1, 2], &[0, 1, 2]),
                                )
                                .length(),
                            (model.each as f64) as usize,
                        )
                        .len() - 1,
                    stations: TABLE_SECTIONS
                        .stations(
                            ::rncf::emitted::Line::Curve(
                                    TABLE_POINTS.curve([0, 1, 2], &[0, 1, 2]),
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
                                    TABLE_POINTS.curve([0, 1, 2], &[0, 1, 2]),
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
