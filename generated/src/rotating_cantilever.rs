//! Expansion of `models/src/rotating_cantilever.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use rotating_cantilever_equations::RotatingCantilever;
#[allow(clippy::all)]
impl Default for RotatingCantilever {
    fn default() -> Self {
        Self {
            eta: 6.0,
            hub_ratio: 0.0,
            elements: 16,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for RotatingCantilever {
    const NAME: &'static str = "RotatingCantilever";
    const DOC: &'static str = "Uniform cantilever on a rotating hub (Wright et al. 1982). Length, mass and bending stiffness are 1 in SI, so that\nrad/s are multiples of sqrt(EI/(rhoA L^4)).";
    const SOURCE: &'static str = r#"pub model RotatingCantilever {
    /// Angular velocity over sqrt(EI/(rhoA L^4)).
    param eta = 6;
    /// Radius of the hub over the length.
    param hub_ratio = 0;
    /// Number of elements.
    param elements: count = 16;

    const length = 1 m;

    // EI/(EA L^2) = 1e-8: the axis hardly stretches.
    material unit { density = 1 kg/m^3; young = 100 MPa; }
    section slender { area = 1 m^2; second_moment = 1e-8 m^4; }

    motion theta(t) = eta * 1 [rad/s] * t;
    frame hub = rotating(axis = z, angle = theta(t));

    body beam in hub {
        spatial;
        line from [hub_ratio * length, 0 m, 0 m] to [(hub_ratio + 1) * length, 0 m, 0 m];
        mesh elements * cable(slender, unit);
    }
    joint root = clamp(beam.start, hub);

    /// Elongation of the tip.
    output u = beam.end.x - (hub_ratio + 1) * length;
    /// Deflection of the tip in the plane of rotation.
    output v = beam.end.y;
    /// Deflection of the tip along the axis of rotation.
    output w = beam.end.z;
    /// Tension in the root.
    output tension = beam.start.axial_force;

    run { t_end = 1 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x049349e6e2705035;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_MASS_MATRIX",
            size: [4, 4],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_AXIAL_STRAIN",
            size: [6, 6],
            doc: "Tensor T_AB of the unit element in `axial strain`: U = 1/2 EA length T_AB (I_A - I0_A) (I_B - I0_B).",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_BENDING",
            size: [6, 6],
            doc: "Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB I_A I_B.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "cable_spatial_elastic_force",
            additions: 98,
            multiplications: 118,
            divisions: 1,
            functions: 0,
            weighted: 220,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_elastic_tangent",
            additions: 410,
            multiplications: 370,
            divisions: 1,
            functions: 0,
            weighted: 784,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_strain_energy",
            additions: 74,
            multiplications: 93,
            divisions: 1,
            functions: 0,
            weighted: 171,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_mass",
            additions: 0,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_2",
            additions: 4,
            multiplications: 8,
            divisions: 2,
            functions: 0,
            weighted: 20,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_field_forces",
            additions: 20,
            multiplications: 52,
            divisions: 0,
            functions: 0,
            weighted: 72,
        },
        ::rncf::model::KernelCount {
            name: "frame_hub",
            additions: 0,
            multiplications: 1,
            divisions: 0,
            functions: 2,
            weighted: 41,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_referenced_position",
            additions: 7,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 13,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_position",
            additions: 13,
            multiplications: 19,
            divisions: 0,
            functions: 2,
            weighted: 72,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_velocity",
            additions: 8,
            multiplications: 19,
            divisions: 0,
            functions: 2,
            weighted: 67,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_acceleration",
            additions: 20,
            multiplications: 33,
            divisions: 0,
            functions: 2,
            weighted: 93,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jerk",
            additions: 36,
            multiplications: 47,
            divisions: 0,
            functions: 2,
            weighted: 123,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_jacobian",
            additions: 4,
            multiplications: 9,
            divisions: 0,
            functions: 2,
            weighted: 53,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_absolute_prescribed",
            additions: 12,
            multiplications: 29,
            divisions: 0,
            functions: 2,
            weighted: 81,
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
                name: "eta",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 6.0,
                doc: "Angular velocity over sqrt(EI/(rhoA L^4)).",
            },
            ::rncf::Param {
                name: "hub_ratio",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.0,
                doc: "Radius of the hub over the length.",
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
                name: "u",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Elongation of the tip.",
            },
            ::rncf::Output {
                name: "v",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the tip in the plane of rotation.",
            },
            ::rncf::Output {
                name: "w",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the tip along the axis of rotation.",
            },
            ::rncf::Output {
                name: "tension",
                unit: "N",
                time_exponent: -2.0,
                components: &[],
                doc: "Tension in the root.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.eta,
            1 => self.hub_ratio,
            2 => self.elements as f64,
            _ => panic!("RotatingCantilever has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.eta = value,
            1 => self.hub_ratio = value,
            2 => self.elements = value as usize,
            _ => panic!("RotatingCantilever has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        rotating_cantilever_equations::run_defaults(self, &mut run);
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
        let equations = rotating_cantilever_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`RotatingCantilever`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod rotating_cantilever_equations {
    /// Uniform cantilever on a rotating hub (Wright et al. 1982). Length, mass and bending stiffness are 1 in SI, so that
    /// rad/s are multiples of sqrt(EI/(rhoA L^4)).
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).
    /// * Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct RotatingCantilever {
        /// Angular velocity over sqrt(EI/(rhoA L^4)). (SI; declared in 1)
        pub eta: f64,
        /// Radius of the hub over the length. (SI; declared in 1)
        pub hub_ratio: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `cable_spatial`. Hermite centre-line element: axial strain and bending, no shear, no torsion.
    ///
    /// Nodal vectors: r0, s0, r1, s1, 3 components each.
    ///
    /// Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct CableSpatial<T = f64> {
        /// Length, m.
        pub length: T,
        /// young * area, N.
        pub EA: T,
        /// young * second_moment, N m^2.
        pub EI: T,
        /// density * area, kg/m.
        pub rhoA: T,
    }
    impl CableSpatial {
        /// The constants of four elements side by side.
        #[inline(always)]
        pub fn side_by_side<L: ::rncf::emitted::lanes::Lanes>(
            rows: [&Self; 4],
            lanes: L,
        ) -> CableSpatial<L::Real> {
            CableSpatial {
                length: lanes.of_each(rows, |row| row.length),
                EA: lanes.of_each(rows, |row| row.EA),
                EI: lanes.of_each(rows, |row| row.EI),
                rhoA: lanes.of_each(rows, |row| row.rhoA),
            }
        }
    }
    /// Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.
    ///
    /// Rows and columns: r0, s0, r1, s1; slopes are multiplied by the length. The sum of a row's columns of positions is the first moment d_a.
    pub const CABLE_SPATIAL_MASS_MATRIX: [[f64; 4]; 4] = [
        [
            0.37142857142857144,
            0.05238095238095238,
            0.12857142857142856,
            -0.030952380952380953,
        ],
        [
            0.05238095238095238,
            0.009523809523809525,
            0.030952380952380953,
            -0.007142857142857143,
        ],
        [
            0.12857142857142856,
            0.030952380952380953,
            0.37142857142857144,
            -0.05238095238095238,
        ],
        [
            -0.030952380952380953,
            -0.007142857142857143,
            -0.05238095238095238,
            0.009523809523809525,
        ],
    ];
    /// Tensor T_AB of the unit element in `axial strain`: U = 1/2 EA length T_AB (I_A - I0_A) (I_B - I0_B).
    ///
    /// Rows and columns: dot_s0_s0, dot_s0_d, dot_s0_s1, dot_d_d, dot_d_s1, dot_s1_s1.
    pub const CABLE_SPATIAL_AXIAL_STRAIN: [[f64; 6]; 6] = [
        [
            0.014285714285714285,
            0.0035714285714285713,
            -0.0035714285714285713,
            0.02142857142857143,
            -0.0035714285714285713,
            0.0011904761904761906,
        ],
        [
            0.0035714285714285713,
            0.08571428571428572,
            -0.007142857142857143,
            -0.12857142857142856,
            0.0,
            -0.0035714285714285713,
        ],
        [
            -0.0035714285714285713,
            -0.007142857142857143,
            0.004761904761904762,
            0.0,
            -0.007142857142857143,
            -0.0035714285714285713,
        ],
        [
            0.02142857142857143,
            -0.12857142857142856,
            0.0,
            0.5142857142857142,
            -0.12857142857142856,
            0.02142857142857143,
        ],
        [
            -0.0035714285714285713,
            0.0,
            -0.007142857142857143,
            -0.12857142857142856,
            0.08571428571428572,
            0.0035714285714285713,
        ],
        [
            0.0011904761904761906,
            -0.0035714285714285713,
            -0.0035714285714285713,
            0.02142857142857143,
            0.0035714285714285713,
            0.014285714285714285,
        ],
    ];
    /// Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB I_A I_B.
    ///
    /// Rows and columns: dot_s0_s0, dot_s0_d, dot_s0_s1, dot_d_d, dot_d_s1, dot_s1_s1.
    pub const CABLE_SPATIAL_BENDING: [[f64; 6]; 6] = [
        [0.0, 0.0, 0.0, 3.6, -2.2, 0.6],
        [0.0, -7.2, 2.2, 0.0, 1.2, -2.2],
        [0.0, 2.2, -1.2, -1.2, 2.2, 0.0],
        [3.6, 0.0, -1.2, 0.0, 0.0, 3.6],
        [-2.2, 1.2, 2.2, 0.0, -7.2, 0.0],
        [0.6, -2.2, 0.0, 3.6, 0.0, 0.0],
    ];
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 98 additions, 118 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_force<T: ::rncf::emitted::lanes::Real>(
        row: &CableSpatial<T>,
        q: &[T; 12],
        force: &mut [T::Cell; 12],
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y + s0_z * s0_z;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y + s0_z * d_z;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y + s0_z * s1_z;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y + d_z * d_z;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y + s1_z * d_z;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y + s1_z * s1_z;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let t43 = length * EA;
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t48 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t49 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t51 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t52 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t53 = inverse_length * EI;
        let t54 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t43 * t46
            + t53
                * (t54 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t56 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t47 + t48 + t49)
            + t53
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t56
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t58 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t43
            * (t49
                + (t50 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t53
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t58
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let stress_dot_d_d = t43 * t51
            + t53
                * (t58 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t43
            * (t48 + (t47 + t50) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t53
                * (t56
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t43 * t52
            + t53
                * (t54
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
        let t63 = inverse_length
            * (s0_x * stress_dot_s0_d + stress_dot_d_d * (d_x * 2.0)
                + s1_x * stress_dot_d_s1);
        let t64 = inverse_length
            * (s0_y * stress_dot_s0_d + stress_dot_d_d * (d_y * 2.0)
                + s1_y * stress_dot_d_s1);
        let t65 = inverse_length
            * (s0_z * stress_dot_s0_d + stress_dot_d_d * (d_z * 2.0)
                + s1_z * stress_dot_d_s1);
        force[0] -= t63;
        force[1] -= t64;
        force[2] -= t65;
        force[3]
            += stress_dot_s0_s0 * (s0_x * 2.0) + d_x * stress_dot_s0_d
                + s1_x * stress_dot_s0_s1;
        force[4]
            += stress_dot_s0_s0 * (s0_y * 2.0) + d_y * stress_dot_s0_d
                + s1_y * stress_dot_s0_s1;
        force[5]
            += stress_dot_s0_s0 * (s0_z * 2.0) + d_z * stress_dot_s0_d
                + s1_z * stress_dot_s0_s1;
        force[6] += t63;
        force[7] += t64;
        force[8] += t65;
        force[9]
            += s0_x * stress_dot_s0_s1 + d_x * stress_dot_d_s1
                + stress_dot_s1_s1 * (s1_x * 2.0);
        force[10]
            += s0_y * stress_dot_s0_s1 + d_y * stress_dot_d_s1
                + stress_dot_s1_s1 * (s1_y * 2.0);
        force[11]
            += s0_z * stress_dot_s0_s1 + d_z * stress_dot_d_s1
                + stress_dot_s1_s1 * (s1_z * 2.0);
    }
    /// [`cable_spatial_elastic_force`] of four elements side by side.
    pub struct CableSpatialElasticForce<'a> {
        pub rows: [&'a CableSpatial; 4],
        pub q: &'a [[f64; 4]; 12],
        pub force: &'a mut [[f64; 4]; 12],
    }
    impl ::rncf::emitted::lanes::Kernel for CableSpatialElasticForce<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, force } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_force(&row, &q, force);
        }
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 410 additions, 370 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_tangent<T: ::rncf::emitted::lanes::Real>(
        row: &CableSpatial<T>,
        q: &[T; 12],
        stiffness: &mut [T::Cell; 144],
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y + s0_z * s0_z;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y + s0_z * d_z;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y + s0_z * s1_z;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y + d_z * d_z;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y + s1_z * d_z;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y + s1_z * s1_z;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let t43 = length * EA;
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t48 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][1];
        let t49 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t51 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t52 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t53 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t54 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t55 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t56 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[3][3];
        let t57 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t58 = inverse_length * EI;
        let t59 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t43 * t46
            + t58
                * (t59 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t61 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + t58 * CABLE_SPATIAL_BENDING[0][3];
        let t62 = t49 + t58 * CABLE_SPATIAL_BENDING[0][4];
        let t63 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
            + t58 * CABLE_SPATIAL_BENDING[0][5];
        let t64 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t50 + t51 + t52)
            + t58
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t64
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t66 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
            + t58 * CABLE_SPATIAL_BENDING[1][1];
        let t67 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
            + t58 * CABLE_SPATIAL_BENDING[1][2];
        let t68 = t58 * CABLE_SPATIAL_BENDING[1][4];
        let t69 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t43
            * (t52
                + (t54 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t58
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t69
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let t71 = t58 * CABLE_SPATIAL_BENDING[2][2];
        let t72 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[2][2] + t71;
        let stress_dot_d_d = t43 * t55
            + t58
                * (t69 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t43
            * (t51 + (t50 + t54) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t58
                * (t64
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t43 * t57
            + t58
                * (t59
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
        let t76 = s0_x * 2.0;
        let t77 = s0_y * 2.0;
        let t78 = s0_z * 2.0;
        let t79 = d_x * 2.0;
        let t80 = d_y * 2.0;
        let t81 = d_z * 2.0;
        let t82 = s1_x * 2.0;
        let t83 = s1_y * 2.0;
        let t84 = s1_z * 2.0;
        let t85 = d_x * t48;
        let t86 = d_y * t48;
        let t87 = d_z * t48;
        let t88 = t47 * t77 + t86 + s1_y * t49;
        let t89 = t47 * t78 + t87 + s1_z * t49;
        let t90 = s0_x * t48 + t61 * t79 + s1_x * t62;
        let t91 = s0_y * t48 + t61 * t80 + s1_y * t62;
        let t92 = s0_z * t48 + t61 * t81 + s1_z * t62;
        let t93 = s0_x * t49;
        let t94 = s0_y * t49;
        let t95 = s0_z * t49;
        let t96 = t93 + d_x * t62 + t63 * t82;
        let t97 = t94 + d_y * t62 + t63 * t83;
        let t98 = t95 + d_z * t62 + t63 * t84;
        let t99 = d_x * t66;
        let t100 = d_y * t66;
        let t101 = d_z * t66;
        let t102 = s1_x * t67;
        let t103 = s1_y * t67;
        let t104 = s1_z * t67;
        let t105 = t48 * t77 + t100 + t103;
        let t106 = t48 * t78 + t101 + t104;
        let t107 = t53 * t79;
        let t108 = t53 * t80;
        let t109 = t53 * t81;
        let t110 = s0_x * t66 + t107 + s1_x * t68;
        let t111 = s0_y * t66 + t108 + s1_y * t68;
        let t112 = s0_z * t66 + t109 + s1_z * t68;
        let t113 = s0_x * t67;
        let t114 = s0_y * t67;
        let t115 = s0_z * t67;
        let t116 = t113 + d_x * t68 + t62 * t82;
        let t117 = t114 + d_y * t68 + t62 * t83;
        let t118 = t115 + d_z * t68 + t62 * t84;
        let t119 = d_x * t67;
        let t120 = d_y * t67;
        let t121 = d_z * t67;
        let t122 = t49 * t77 + t120 + s1_y * t72;
        let t123 = t49 * t78 + t121 + s1_z * t72;
        let t124 = t102 + (t113 + t71 * t79);
        let t125 = t103 + (t114 + t71 * t80);
        let t126 = t104 + (t115 + t71 * t81);
        let t127 = t119 + s0_x * t72 + t49 * t82;
        let t128 = t120 + s0_y * t72 + t49 * t83;
        let t129 = t121 + s0_z * t72 + t49 * t84;
        let t130 = s0_y * t53 + t56 * t80 + s1_y * t53;
        let t131 = s0_z * t53 + t56 * t81 + s1_z * t53;
        let t132 = d_x * t53 + s0_x * t71 + t61 * t82;
        let t133 = d_y * t53 + s0_y * t71 + t61 * t83;
        let t134 = d_z * t53 + s0_z * t71 + t61 * t84;
        let t135 = t108 + s0_y * t68 + s1_y * t66;
        let t136 = t109 + s0_z * t68 + s1_z * t66;
        let t137 = t99 + t113 + t48 * t82;
        let t138 = t100 + t114 + t48 * t83;
        let t139 = t101 + t115 + t48 * t84;
        let t140 = t86 + t94 + t47 * t83;
        let t141 = t87 + t95 + t47 * t84;
        let t142 = t76 * (t47 * t76 + t85 + s1_x * t49) + d_x * (t48 * t76 + t99 + t102);
        let t143 = t76 * t88 + d_x * t105 + s1_x * t122;
        let t144 = t76 * t89 + d_x * t106 + s1_x * t123;
        let t145 = t77 * t89 + d_y * t106 + s1_y * t123;
        let t146 = t76 * t97 + d_x * t117 + s1_x * t128;
        let t147 = t76 * t98 + d_x * t118 + s1_x * t129;
        let t148 = t77 * t96 + d_y * t116 + s1_y * t127;
        let t149 = t77 * t98 + d_y * t118 + s1_y * t129;
        let t150 = t78 * t96 + d_z * t116 + s1_z * t127;
        let t151 = t78 * t97 + d_z * t117 + s1_z * t128;
        let t152 = s0_x * t110 + t79 * (s0_x * t53 + t56 * t79 + s1_x * t53)
            + s1_x * (t107 + s0_x * t68 + s1_x * t66);
        let t153 = s0_x * t128 + d_x * t138 + t82 * t140;
        let t154 = s0_x * t129 + d_x * t139 + t82 * t141;
        let t155 = s0_y * t129 + d_y * t139 + t83 * t141;
        let t156 = stress_dot_s0_s0 * 2.0;
        let t157 = stress_dot_s0_s1 + (t76 * t96 + d_x * t116 + s1_x * t127);
        let t158 = stress_dot_s0_s1 + (t77 * t97 + d_y * t117 + s1_y * t128);
        let t159 = stress_dot_s0_s1 + (t78 * t98 + d_z * t118 + s1_z * t129);
        let t160 = stress_dot_d_d * 2.0;
        let t161 = stress_dot_s1_s1 * 2.0;
        let t162 = s0_x * t127 + d_x * t137 + t82 * (t85 + t93 + t47 * t82) + t161;
        let t163 = inverse_length * inverse_length;
        let t164 = (t152 + t160) * t163;
        let t165 = (s0_x * t111 + t79 * t130 + s1_x * t135) * t163;
        let t166 = (s0_x * t112 + t79 * t131 + s1_x * t136) * t163;
        let t167 = inverse_length
            * (stress_dot_s0_d + (t76 * t90 + d_x * t110 + s1_x * t124));
        let t168 = inverse_length * (t77 * t90 + d_y * t110 + s1_y * t124);
        let t169 = inverse_length * (t78 * t90 + d_z * t110 + s1_z * t124);
        let t170 = inverse_length
            * (stress_dot_d_s1 + (s0_x * t116 + t79 * t132 + s1_x * t137));
        let t171 = inverse_length * (s0_x * t117 + t79 * t133 + s1_x * t138);
        let t172 = inverse_length * (s0_x * t118 + t79 * t134 + s1_x * t139);
        let t173 = (s0_y * t111 + t80 * t130 + s1_y * t135 + t160) * t163;
        let t174 = (s0_y * t112 + t80 * t131 + s1_y * t136) * t163;
        let t175 = inverse_length * (t76 * t91 + d_x * t111 + s1_x * t125);
        let t176 = inverse_length
            * (stress_dot_s0_d + (t77 * t91 + d_y * t111 + s1_y * t125));
        let t177 = inverse_length * (t78 * t91 + d_z * t111 + s1_z * t125);
        let t178 = inverse_length * (s0_y * t116 + t80 * t132 + s1_y * t137);
        let t179 = inverse_length
            * (stress_dot_d_s1 + (s0_y * t117 + t80 * t133 + s1_y * t138));
        let t180 = inverse_length * (s0_y * t118 + t80 * t134 + s1_y * t139);
        let t181 = (s0_z * t112 + t81 * t131 + s1_z * t136 + t160) * t163;
        let t182 = inverse_length * (t76 * t92 + d_x * t112 + s1_x * t126);
        let t183 = inverse_length * (t77 * t92 + d_y * t112 + s1_y * t126);
        let t184 = inverse_length
            * (stress_dot_s0_d + (t78 * t92 + d_z * t112 + s1_z * t126));
        let t185 = inverse_length * (s0_z * t116 + t81 * t132 + s1_z * t137);
        let t186 = inverse_length * (s0_z * t117 + t81 * t133 + s1_z * t138);
        let t187 = inverse_length
            * (stress_dot_d_s1 + (s0_z * t118 + t81 * t134 + s1_z * t139));
        stiffness[0] += t164;
        stiffness[1] += t165;
        stiffness[2] += t166;
        stiffness[3] -= t167;
        stiffness[4] -= t168;
        stiffness[5] -= t169;
        stiffness[6] -= t164;
        stiffness[7] -= t165;
        stiffness[8] -= t166;
        stiffness[9] -= t170;
        stiffness[10] -= t171;
        stiffness[11] -= t172;
        stiffness[12] += t165;
        stiffness[13] += t173;
        stiffness[14] += t174;
        stiffness[15] -= t175;
        stiffness[16] -= t176;
        stiffness[17] -= t177;
        stiffness[18] -= t165;
        stiffness[19] -= t173;
        stiffness[20] -= t174;
        stiffness[21] -= t178;
        stiffness[22] -= t179;
        stiffness[23] -= t180;
        stiffness[24] += t166;
        stiffness[25] += t174;
        stiffness[26] += t181;
        stiffness[27] -= t182;
        stiffness[28] -= t183;
        stiffness[29] -= t184;
        stiffness[30] -= t166;
        stiffness[31] -= t174;
        stiffness[32] -= t181;
        stiffness[33] -= t185;
        stiffness[34] -= t186;
        stiffness[35] -= t187;
        stiffness[36] -= t167;
        stiffness[37] -= t175;
        stiffness[38] -= t182;
        stiffness[39] += t142 + s1_x * (t49 * t76 + t119 + s1_x * t72) + t156;
        stiffness[40] += t143;
        stiffness[41] += t144;
        stiffness[42] += t167;
        stiffness[43] += t175;
        stiffness[44] += t182;
        stiffness[45] += t157;
        stiffness[46] += t146;
        stiffness[47] += t147;
        stiffness[48] -= t168;
        stiffness[49] -= t176;
        stiffness[50] -= t183;
        stiffness[51] += t143;
        stiffness[52] += t77 * t88 + d_y * t105 + s1_y * t122 + t156;
        stiffness[53] += t145;
        stiffness[54] += t168;
        stiffness[55] += t176;
        stiffness[56] += t183;
        stiffness[57] += t148;
        stiffness[58] += t158;
        stiffness[59] += t149;
        stiffness[60] -= t169;
        stiffness[61] -= t177;
        stiffness[62] -= t184;
        stiffness[63] += t144;
        stiffness[64] += t145;
        stiffness[65] += t78 * t89 + d_z * t106 + s1_z * t123 + t156;
        stiffness[66] += t169;
        stiffness[67] += t177;
        stiffness[68] += t184;
        stiffness[69] += t150;
        stiffness[70] += t151;
        stiffness[71] += t159;
        stiffness[72] -= t164;
        stiffness[73] -= t165;
        stiffness[74] -= t166;
        stiffness[75] += t167;
        stiffness[76] += t168;
        stiffness[77] += t169;
        stiffness[78] += t164;
        stiffness[79] += t165;
        stiffness[80] += t166;
        stiffness[81] += t170;
        stiffness[82] += t171;
        stiffness[83] += t172;
        stiffness[84] -= t165;
        stiffness[85] -= t173;
        stiffness[86] -= t174;
        stiffness[87] += t175;
        stiffness[88] += t176;
        stiffness[89] += t177;
        stiffness[90] += t165;
        stiffness[91] += t173;
        stiffness[92] += t174;
        stiffness[93] += t178;
        stiffness[94] += t179;
        stiffness[95] += t180;
        stiffness[96] -= t166;
        stiffness[97] -= t174;
        stiffness[98] -= t181;
        stiffness[99] += t182;
        stiffness[100] += t183;
        stiffness[101] += t184;
        stiffness[102] += t166;
        stiffness[103] += t174;
        stiffness[104] += t181;
        stiffness[105] += t185;
        stiffness[106] += t186;
        stiffness[107] += t187;
        stiffness[108] -= t170;
        stiffness[109] -= t178;
        stiffness[110] -= t185;
        stiffness[111] += t157;
        stiffness[112] += t148;
        stiffness[113] += t150;
        stiffness[114] += t170;
        stiffness[115] += t178;
        stiffness[116] += t185;
        stiffness[117] += t162;
        stiffness[118] += t153;
        stiffness[119] += t154;
        stiffness[120] -= t171;
        stiffness[121] -= t179;
        stiffness[122] -= t186;
        stiffness[123] += t146;
        stiffness[124] += t158;
        stiffness[125] += t151;
        stiffness[126] += t171;
        stiffness[127] += t179;
        stiffness[128] += t186;
        stiffness[129] += t153;
        stiffness[130] += s0_y * t128 + d_y * t138 + t83 * t140 + t161;
        stiffness[131] += t155;
        stiffness[132] -= t172;
        stiffness[133] -= t180;
        stiffness[134] -= t187;
        stiffness[135] += t147;
        stiffness[136] += t149;
        stiffness[137] += t159;
        stiffness[138] += t172;
        stiffness[139] += t180;
        stiffness[140] += t187;
        stiffness[141] += t154;
        stiffness[142] += t155;
        stiffness[143] += s0_z * t129 + d_z * t139 + t84 * t141 + t161;
    }
    /// [`cable_spatial_elastic_tangent`] of four elements side by side.
    pub struct CableSpatialElasticTangent<'a> {
        pub rows: [&'a CableSpatial; 4],
        pub q: &'a [[f64; 4]; 12],
        pub stiffness: &'a mut [[f64; 4]; 144],
    }
    impl ::rncf::emitted::lanes::Kernel for CableSpatialElasticTangent<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, stiffness } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_tangent(&row, &q, stiffness);
        }
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 74 additions, 93 multiplications, 1 divisions.
    pub fn cable_spatial_strain_energy(
        row: &CableSpatial,
        q: &[f64; 12],
        energy: &mut f64,
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y + s0_z * s0_z;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y + s0_z * d_z;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y + s0_z * s1_z;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y + d_z * d_z;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y + s1_z * d_z;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y + s1_z * s1_z;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let t43 = length * EA * 0.5;
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t48 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t49 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = t43 * (strain_dot_s0_s0 * t46)
            + t43
                * (strain_dot_s0_d
                    * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                        + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t47 + t48
                        + t49));
        let t51 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t52 = t43
            * (strain_dot_s0_s1
                * (t49
                    + (t51 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                        + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                        + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2])));
        let t53 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t54 = t50 + t52 + t43 * (strain_dot_d_d * t53)
            + t43
                * (strain_dot_d_s1
                    * (t48 + (t47 + t51)
                        + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                        + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]));
        let t55 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t56 = 0.5 * (inverse_length * EI);
        let t57 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let t58 = t54 + t43 * (strain_dot_s1_s1 * t55)
            + t56
                * (dot_s0_s0
                    * (t57 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]));
        let t59 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let t60 = t58
            + t56
                * (dot_s0_d
                    * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t59
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]));
        let t61 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let t62 = t60
            + t56
                * (dot_s0_s1
                    * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t61
                        + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]));
        let t63 = t62
            + t56
                * (dot_d_d
                    * (t61 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]))
            + t56
                * (dot_d_s1
                    * (t59
                        + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                            + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]));
        *energy
            += t63
                + t56
                    * (dot_s1_s1
                        * (t57
                            + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                                + dot_s0_d * CABLE_SPATIAL_BENDING[0][4])));
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_spatial_mass(row: &CableSpatial, mass: &mut [f64; 16]) {
        let CableSpatial { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * CABLE_SPATIAL_MASS_MATRIX[0][0];
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * CABLE_SPATIAL_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * CABLE_SPATIAL_MASS_MATRIX[0][2];
        let mass_r0_s1 = t16 * CABLE_SPATIAL_MASS_MATRIX[0][3];
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * CABLE_SPATIAL_MASS_MATRIX[1][1];
        let mass_s0_r1 = t16 * CABLE_SPATIAL_MASS_MATRIX[1][2];
        let mass_s0_s1 = t20 * CABLE_SPATIAL_MASS_MATRIX[1][3];
        let mass_r1_s1 = t16 * CABLE_SPATIAL_MASS_MATRIX[2][3];
        mass[0] = mass_r0_r0;
        mass[1] = mass_r0_s0;
        mass[2] = mass_r0_r1;
        mass[3] = mass_r0_s1;
        mass[4] = mass_r0_s0;
        mass[5] = mass_s0_s0;
        mass[6] = mass_s0_r1;
        mass[7] = mass_s0_s1;
        mass[8] = mass_r0_r1;
        mass[9] = mass_s0_r1;
        mass[10] = mass_r0_r0;
        mass[11] = mass_r1_s1;
        mass[12] = mass_r0_s1;
        mass[13] = mass_s0_s1;
        mass[14] = mass_r1_s1;
        mass[15] = mass_s0_s0;
    }
    /// Weights of the nodal vectors in the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 6 additions, 12 multiplications.
    pub fn cable_spatial_shapes_position_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 4],
    ) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[2] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[3] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn cable_spatial_shapes_position_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 4],
    ) {
        let t14 = 1.0 / length;
        let t15 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t14;
        weights[1] = 1.0 + xi * (-4.0 + t15);
        weights[2] = t14 * (xi * (6.0 + xi * (-6.0)));
        weights[3] = xi * (t15 + (-2.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 8 multiplications, 2 divisions.
    pub fn cable_spatial_shapes_position_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 4],
    ) {
        let t14 = 1.0 / (length * length);
        let t15 = xi * 6.0;
        let t16 = 1.0 / length;
        weights[0] = (-6.0 + xi * 12.0) * t14;
        weights[1] = (-4.0 + t15) * t16;
        weights[2] = t14 * (6.0 + xi * (-12.0));
        weights[3] = t16 * (t15 + (-2.0));
    }
    /// Writes the forces on the fields a, b at a point, dU/d(field) per unit length, from their values in the stress-free shape and at present.
    ///
    /// Operations: 20 additions, 52 multiplications.
    pub fn cable_spatial_field_forces(
        row: &CableSpatial,
        stress_free: &[f64; 6],
        fields: &[f64; 6],
        forces: &mut [f64; 6],
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let t23 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2];
        let t24 = fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5];
        let t25 = 0.5 * (t23 - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t26 = EA * t25;
        let t27 = fields[0] * 2.0;
        let t28 = fields[1] * 2.0;
        let t29 = fields[2] * 2.0;
        let t30 = (fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5])
            * 2.0;
        forces[0] = t26 * (0.5 * t27) + EI * (0.5 * (t24 * t27 - fields[3] * t30));
        forces[1] = t26 * (0.5 * t28) + EI * (0.5 * (t24 * t28 - fields[4] * t30));
        forces[2] = t26 * (0.5 * t29) + EI * (0.5 * (t24 * t29 - fields[5] * t30));
        forces[3] = EI * (0.5 * (t23 * (fields[3] * 2.0) - fields[0] * t30));
        forces[4] = EI * (0.5 * (t23 * (fields[4] * 2.0) - fields[1] * t30));
        forces[5] = EI * (0.5 * (t23 * (fields[5] * 2.0) - fields[2] * t30));
    }
    /// Motion of frame `hub` and its first two derivatives.
    ///
    /// Operations: 0 additions, 1 multiplications, 2 function calls.
    pub fn frame_hub(
        model: &RotatingCantilever,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let theta = t * model.eta;
        let t15 = theta.cos();
        let t16 = theta.sin();
        motion.spin[2] = model.eta;
        motion.rotation[(0, 0)] = t15;
        motion.rotation[(0, 1)] = -t16;
        motion.rotation[(1, 0)] = t16;
        motion.rotation[(1, 1)] = t15;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn joint_root_referenced_position(
        model: &RotatingCantilever,
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
        rows[3] = data.normals[0][0] * q[3] + data.normals[0][1] * q[4]
            + data.normals[0][2] * q[5];
        rows[4] = data.normals[1][0] * q[3] + data.normals[1][1] * q[4]
            + data.normals[1][2] * q[5];
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jacobian(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[7] = 1.0;
        jacobian[14] = 1.0;
        jacobian[21] = data.normals[0][0];
        jacobian[22] = data.normals[0][1];
        jacobian[23] = data.normals[0][2];
        jacobian[27] = data.normals[1][0];
        jacobian[28] = data.normals[1][1];
        jacobian[29] = data.normals[1][2];
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_prescribed(
        model: &RotatingCantilever,
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
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 13 additions, 19 multiplications, 2 function calls.
    pub fn joint_root_absolute_position(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let theta = t * model.eta;
        let t30 = theta.cos();
        let t31 = theta.sin();
        let t32 = q[3] * (t30 * data.normals[0][0] - t31 * data.normals[0][1])
            + q[4] * (t31 * data.normals[0][0] + t30 * data.normals[0][1]);
        let t33 = q[3] * (t30 * data.normals[1][0] - t31 * data.normals[1][1])
            + q[4] * (t31 * data.normals[1][0] + t30 * data.normals[1][1]);
        rows[0] = q[0] - (t30 * data.point[0] - t31 * data.point[1]);
        rows[1] = q[1] - (t31 * data.point[0] + t30 * data.point[1]);
        rows[2] = q[2] - data.point[2];
        rows[3] = t32 + data.normals[0][2] * q[5];
        rows[4] = t33 + data.normals[1][2] * q[5];
    }
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 8 additions, 19 multiplications, 2 function calls.
    pub fn joint_root_absolute_velocity(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let theta = t * model.eta;
        let t23 = model.eta * theta.sin();
        let t24 = model.eta * theta.cos();
        let t25 = q[4] * (data.normals[0][0] * t24 - data.normals[0][1] * t23)
            - q[3] * (data.normals[0][0] * t23 + data.normals[0][1] * t24);
        let t26 = q[4] * (data.normals[1][0] * t24 - data.normals[1][1] * t23)
            - q[3] * (data.normals[1][0] * t23 + data.normals[1][1] * t24);
        rows[0] = data.point[0] * t23 + data.point[1] * t24;
        rows[1] = data.point[1] * t23 - data.point[0] * t24;
        rows[3] = t25;
        rows[4] = t26;
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 20 additions, 33 multiplications, 2 function calls.
    pub fn joint_root_absolute_acceleration(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let theta = t * model.eta;
        let t25 = model.eta * theta.sin();
        let t26 = model.eta * theta.cos();
        let t27 = model.eta * t26;
        let t28 = model.eta * t25;
        let t29 = v[3] * (data.normals[0][0] * t25 + data.normals[0][1] * t26);
        let t30 = v[4] * (data.normals[0][0] * t26 - data.normals[0][1] * t25);
        let t31 = v[3] * (data.normals[1][0] * t25 + data.normals[1][1] * t26);
        let t32 = v[4] * (data.normals[1][0] * t26 - data.normals[1][1] * t25);
        let t33 = t30
            + (t30 - q[4] * (data.normals[0][0] * t28 + data.normals[0][1] * t27))
            - (t29
                + (t29 + q[3] * (data.normals[0][0] * t27 - data.normals[0][1] * t28)));
        let t34 = t32
            + (t32 - q[4] * (data.normals[1][0] * t28 + data.normals[1][1] * t27))
            - (t31
                + (t31 + q[3] * (data.normals[1][0] * t27 - data.normals[1][1] * t28)));
        rows[0] = data.point[0] * t27 - data.point[1] * t28;
        rows[1] = data.point[0] * t28 + data.point[1] * t27;
        rows[3] = t33;
        rows[4] = t34;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 36 additions, 47 multiplications, 2 function calls.
    pub fn joint_root_absolute_jerk(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let theta = t * model.eta;
        let t27 = model.eta * theta.sin();
        let t28 = model.eta * theta.cos();
        let t29 = model.eta * t28;
        let t30 = model.eta * t27;
        let t31 = model.eta * t30;
        let t32 = model.eta * t29;
        let t33 = a[3] * (data.normals[0][0] * t27 + data.normals[0][1] * t28);
        let t34 = v[3] * (data.normals[0][0] * t29 - data.normals[0][1] * t30);
        let t35 = t33 + t34;
        let t36 = a[4] * (data.normals[0][0] * t28 - data.normals[0][1] * t27);
        let t37 = v[4] * (data.normals[0][0] * t30 + data.normals[0][1] * t29);
        let t38 = t36 - t37;
        let t39 = t36 + t38
            + (t38
                - (t37 + q[4] * (data.normals[0][0] * t32 - data.normals[0][1] * t31)))
            - (t33 + t35
                + (t35
                    + (t34
                        - q[3]
                            * (data.normals[0][0] * t31 + data.normals[0][1] * t32))));
        let t40 = a[3] * (data.normals[1][0] * t27 + data.normals[1][1] * t28);
        let t41 = v[3] * (data.normals[1][0] * t29 - data.normals[1][1] * t30);
        let t42 = t40 + t41;
        let t43 = a[4] * (data.normals[1][0] * t28 - data.normals[1][1] * t27);
        let t44 = v[4] * (data.normals[1][0] * t30 + data.normals[1][1] * t29);
        let t45 = t43 - t44;
        let t46 = t43 + t45
            + (t45
                - (t44 + q[4] * (data.normals[1][0] * t32 - data.normals[1][1] * t31)))
            - (t40 + t42
                + (t42
                    + (t41
                        - q[3]
                            * (data.normals[1][0] * t31 + data.normals[1][1] * t32))));
        rows[0] = -(data.point[0] * t31 + data.point[1] * t32);
        rows[1] = data.point[0] * t32 - data.point[1] * t31;
        rows[3] = t39;
        rows[4] = t46;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 4 additions, 9 multiplications, 2 function calls.
    pub fn joint_root_absolute_jacobian(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        let theta = t * model.eta;
        let t21 = theta.cos();
        let t22 = theta.sin();
        jacobian[0] = 1.0;
        jacobian[7] = 1.0;
        jacobian[14] = 1.0;
        jacobian[21] = t21 * data.normals[0][0] - t22 * data.normals[0][1];
        jacobian[22] = t22 * data.normals[0][0] + t21 * data.normals[0][1];
        jacobian[23] = data.normals[0][2];
        jacobian[27] = t21 * data.normals[1][0] - t22 * data.normals[1][1];
        jacobian[28] = t22 * data.normals[1][0] + t21 * data.normals[1][1];
        jacobian[29] = data.normals[1][2];
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 12 additions, 29 multiplications, 2 function calls.
    pub fn joint_root_absolute_prescribed(
        model: &RotatingCantilever,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        let theta = t * model.eta;
        let t21 = theta.cos();
        let t22 = theta.sin();
        let t23 = model.eta * t22;
        let t24 = model.eta * t21;
        let t25 = model.eta * t24;
        let t26 = model.eta * t23;
        prescribed.position[0][0] = t21 * data.point[0] - t22 * data.point[1];
        prescribed.position[0][1] = t22 * data.point[0] + t21 * data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = -(data.point[0] * t23 + data.point[1] * t24);
        prescribed.position[1][1] = data.point[0] * t24 - data.point[1] * t23;
        prescribed.position[2][0] = data.point[1] * t26 - data.point[0] * t25;
        prescribed.position[2][1] = -(data.point[0] * t26 + data.point[1] * t25);
        prescribed.slope[0][0] = t21 * data.tangent[0] - t22 * data.tangent[1];
        prescribed.slope[0][1] = t22 * data.tangent[0] + t21 * data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = -(data.tangent[0] * t23 + data.tangent[1] * t24);
        prescribed.slope[1][1] = data.tangent[0] * t24 - data.tangent[1] * t23;
        prescribed.slope[2][0] = data.tangent[1] * t26 - data.tangent[0] * t25;
        prescribed.slope[2][1] = -(data.tangent[0] * t26 + data.tangent[1] * t25);
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn outputs(
        model: &RotatingCantilever,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
        out[0] = observed[0] - (model.hub_ratio + 1.0);
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &RotatingCantilever, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: RotatingCantilever,
        pub row_beam: CableSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &RotatingCantilever) -> Self {
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
                ::rncf::emitted::ObservedSpec::Section {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::SectionQuantity::AxialForce,
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
            ["inertial", "hub"][frame]
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
                    line: ::rncf::emitted::Line::Straight {
                        from: [model.hub_ratio, 0.0, 0.0],
                        to: [model.hub_ratio + 1.0, 0.0, 0.0],
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
                    ],
                    connectivity: &[0, 1, 2, 3],
                    vectors_per_node: 2,
                    stride: 2,
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
                "material `unit`",
                "density",
                1.0,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `unit`",
                "young",
                100000000.0,
                "Pa",
            )?;
            let area = ::rncf::emitted::positive(
                "section `slender`",
                "area",
                1.0,
                "m^2",
            )?;
            let second_moment = ::rncf::emitted::positive(
                "section `slender`",
                "second_moment",
                1e-8,
                "m^4",
            )?;
            self.row_beam = CableSpatial {
                length,
                EA: young * area,
                EI: young * second_moment,
                rhoA: density * area,
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
            cable_spatial_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            cable_spatial_elastic_force(
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
            cable_spatial_elastic_tangent(
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
            let four = CableSpatialElasticForce {
                rows: [&self.row_beam; 4],
                q: ::rncf::emitted::array(q),
                force: ::rncf::emitted::array_mut(force),
            };
            if !::rncf::emitted::lanes::run(four) {
                ::rncf::emitted::elastic_force_one_by_one(self, elements, q, v, force);
            }
        }
        fn elastic_tangent4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            stiffness: &mut [[f64; 4]],
            damping: &mut [[f64; 4]],
        ) {
            let four = CableSpatialElasticTangent {
                rows: [&self.row_beam; 4],
                q: ::rncf::emitted::array(q),
                stiffness: ::rncf::emitted::array_mut(stiffness),
            };
            if !::rncf::emitted::lanes::run(four) {
                ::rncf::emitted::elastic_tangent_one_by_one(
                    self,
                    elements,
                    q,
                    v,
                    stiffness,
                    damping,
                );
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            cable_spatial_strain_energy(
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
                    cable_spatial_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    cable_spatial_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 2) => {
                    cable_spatial_shapes_position_2(
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
                    shear_factors: [0.0, 0.0],
                },
                area: 1.0,
                second_moments: [1e-8, 1e-8],
                torsion_constant: 0.0,
                young_over_shear: 0.0,
                softness_of_curves: 4.0,
                yield_stress: None,
                material: "unit",
            }
        }
        fn fields(
            &self,
            body: usize,
        ) -> &'static [(::rncf::emitted::Interpolant, usize)] {
            &[
                (::rncf::emitted::Interpolant::Position, 1),
                (::rncf::emitted::Interpolant::Position, 2),
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
            cable_spatial_field_forces(
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
