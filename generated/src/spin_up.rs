//! Expansion of `models/src/spin_up.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use spin_up_equations::SpinUp;
#[allow(clippy::all)]
impl Default for SpinUp {
    fn default() -> Self {
        Self {
            omega_s: 4.0,
            T_s: 15.0,
            elements: 6,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for SpinUp {
    const NAME: &'static str = "SpinUp";
    const DOC: &'static str = "Spin-up manoeuvre of a flexible beam (Ren & Yang 2021, section 4.1.1).";
    const SOURCE: &'static str = r#"pub model SpinUp {
    /// Steady angular velocity.
    param omega_s = 4 rad/s;
    /// Time to reach it.
    param T_s = 15 s;
    /// Number of elements.
    param elements: count = 6;

    material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
    section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }

    /// Angle of the hub, Eq. (22).
    motion theta(t) =
        if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { omega_s * (t - T_s/2) };
    frame hub = rotating(axis = z, angle = theta(t));

    body beam in hub {
        planar xy;
        line from [0, 0, 0] m to [8, 0, 0] m;
        mesh elements * cable(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);

    /// Elongation of the tip in the frame.
    output u = beam.end.x - 8 m;
    /// Deflection of the tip in the frame.
    output v = beam.end.y;

    run { t_end = 20 s; every = 0.05 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xb3555a21035c656d;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `cable_planar`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 185 and 554; points unrolled: 343 and 1077; loop over points: 375 and 1181; a loop counts 1.3 times).",
        "Body `beam` is planar: two components a vector, no motion along the normal.",
        "Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "CABLE_PLANAR_MASS_MATRIX",
            size: [4, 4],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_PLANAR_AXIAL_STRAIN",
            size: [6, 6],
            doc: "Tensor T_AB of the unit element in `axial strain`: U = 1/2 EA length T_AB (I_A - I0_A) (I_B - I0_B).",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_PLANAR_BENDING",
            size: [3, 3],
            doc: "Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB (I_A - I0_A) (I_B - I0_B).",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "cable_planar_elastic_force",
            additions: 81,
            multiplications: 103,
            divisions: 1,
            functions: 0,
            weighted: 188,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_elastic_tangent",
            additions: 277,
            multiplications: 276,
            divisions: 1,
            functions: 0,
            weighted: 557,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_strain_energy",
            additions: 58,
            multiplications: 76,
            divisions: 1,
            functions: 0,
            weighted: 138,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_mass",
            additions: 0,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_shapes_position_2",
            additions: 4,
            multiplications: 8,
            divisions: 2,
            functions: 0,
            weighted: 20,
        },
        ::rncf::model::KernelCount {
            name: "cable_planar_field_forces",
            additions: 10,
            multiplications: 22,
            divisions: 0,
            functions: 0,
            weighted: 32,
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
                default: 6.0,
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
                doc: "Elongation of the tip in the frame.",
            },
            ::rncf::Output {
                name: "v",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the tip in the frame.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_s,
            1 => self.T_s,
            2 => self.elements as f64,
            _ => panic!("SpinUp has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            _ => panic!("SpinUp has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        spin_up_equations::run_defaults(self, &mut run);
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
        let equations = spin_up_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`SpinUp`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod spin_up_equations {
    /// Spin-up manoeuvre of a flexible beam (Ren & Yang 2021, section 4.1.1).
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `cable_planar`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 185 and 554; points unrolled: 343 and 1077; loop over points: 375 and 1181; a loop counts 1.3 times).
    /// * Body `beam` is planar: two components a vector, no motion along the normal.
    /// * Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `beam`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as frame `hub` moves in a prescribed way.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct SpinUp {
        /// Steady angular velocity. (SI; declared in rad/s)
        pub omega_s: f64,
        /// Time to reach it. (SI; declared in s)
        pub T_s: f64,
        /// Number of elements. (count)
        pub elements: usize,
    }
    /// Constants of one element `cable_planar`. Hermite centre-line element: axial strain and bending, no shear, no torsion.
    ///
    /// Nodal vectors: r0, s0, r1, s1, 2 components each.
    ///
    /// Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 185 and 554; points unrolled: 343 and 1077; loop over points: 375 and 1181; a loop counts 1.3 times).
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct CablePlanar<T = f64> {
        /// Length, m.
        pub length: T,
        /// young * area, N.
        pub EA: T,
        /// young * second_moment, N m^2.
        pub EI: T,
        /// density * area, kg/m.
        pub rhoA: T,
    }
    impl CablePlanar {
        /// The constants of four elements side by side.
        #[inline(always)]
        pub fn side_by_side<L: ::rncf::emitted::lanes::Lanes>(
            rows: [&Self; 4],
            lanes: L,
        ) -> CablePlanar<L::Real> {
            CablePlanar {
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
    pub const CABLE_PLANAR_MASS_MATRIX: [[f64; 4]; 4] = [
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
    pub const CABLE_PLANAR_AXIAL_STRAIN: [[f64; 6]; 6] = [
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
    /// Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB (I_A - I0_A) (I_B - I0_B).
    ///
    /// Rows and columns: cross_s0_d, cross_s0_s1, cross_d_s1.
    pub const CABLE_PLANAR_BENDING: [[f64; 3]; 3] = [
        [7.2, -2.2, 1.2],
        [-2.2, 1.2, -2.2],
        [1.2, -2.2, 7.2],
    ];
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 81 additions, 103 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_planar_elastic_force<T: ::rncf::emitted::lanes::Real>(
        row: &CablePlanar<T>,
        q: &[T; 8],
        force: &mut [T::Cell; 8],
    ) {
        let CablePlanar { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, s0_x, s0_y, r1_x, r1_y, s1_x, s1_y] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let cross_s0_d = s0_x * d_y - s0_y * d_x;
        let cross_s0_s1 = s0_x * s1_y - s0_y * s1_x;
        let cross_d_s1 = s1_y * d_x - s1_x * d_y;
        let t41 = length * EA;
        let t42 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t43 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let t44 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][1] + t42 + t43
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][5];
        let stress_dot_s0_s0 = t41 * t44;
        let t46 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2];
        let t47 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[1][3];
        let t48 = strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let stress_dot_s0_d = t41
            * (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][1] + t46 + t47 + t48);
        let t50 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let stress_dot_s0_s1 = t41
            * (t48
                + (t50 + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2]));
        let t52 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let stress_dot_d_d = t41 * t52;
        let stress_dot_d_s1 = t41
            * (t47 + (t46 + t50) + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]);
        let t55 = t43
            + (t42
                + (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][0];
        let stress_dot_s1_s1 = t41 * t55;
        let t57 = inverse_length * EI;
        let t58 = cross_s0_s1 * CABLE_PLANAR_BENDING[0][1];
        let stress_cross_s0_d = t57
            * (cross_s0_d * CABLE_PLANAR_BENDING[0][0] + t58
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][2]);
        let stress_cross_s0_s1 = t57
            * (cross_s0_d * CABLE_PLANAR_BENDING[0][1]
                + cross_s0_s1 * CABLE_PLANAR_BENDING[0][2]
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][1]);
        let stress_cross_d_s1 = t57
            * (t58 + cross_s0_d * CABLE_PLANAR_BENDING[0][2]
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][0]);
        let t62 = stress_dot_s0_s0 * (s0_x * 2.0) + d_x * stress_dot_s0_d
            + s1_x * stress_dot_s0_s1 + d_y * stress_cross_s0_d
            + s1_y * stress_cross_s0_s1;
        let t63 = stress_dot_s0_s0 * (s0_y * 2.0) + d_y * stress_dot_s0_d
            + s1_y * stress_dot_s0_s1 - d_x * stress_cross_s0_d
            - s1_x * stress_cross_s0_s1;
        let t64 = s0_x * stress_dot_s0_d + stress_dot_d_d * (d_x * 2.0)
            + s1_x * stress_dot_d_s1 - s0_y * stress_cross_s0_d
            + s1_y * stress_cross_d_s1;
        let t65 = s0_y * stress_dot_s0_d + stress_dot_d_d * (d_y * 2.0)
            + s1_y * stress_dot_d_s1 + s0_x * stress_cross_s0_d
            - s1_x * stress_cross_d_s1;
        let t66 = s0_x * stress_dot_s0_s1 + d_x * stress_dot_d_s1
            + stress_dot_s1_s1 * (s1_x * 2.0) - s0_y * stress_cross_s0_s1
            - d_y * stress_cross_d_s1;
        let t67 = s0_y * stress_dot_s0_s1 + d_y * stress_dot_d_s1
            + stress_dot_s1_s1 * (s1_y * 2.0) + s0_x * stress_cross_s0_s1
            + d_x * stress_cross_d_s1;
        let t68 = inverse_length * t64;
        let t69 = inverse_length * t65;
        force[0] -= t68;
        force[1] -= t69;
        force[2] += t62;
        force[3] += t63;
        force[4] += t68;
        force[5] += t69;
        force[6] += t66;
        force[7] += t67;
    }
    /// [`cable_planar_elastic_force`] of four elements side by side.
    pub struct CablePlanarElasticForce<'a> {
        pub rows: [&'a CablePlanar; 4],
        pub q: &'a [[f64; 4]; 8],
        pub force: &'a mut [[f64; 4]; 8],
    }
    impl ::rncf::emitted::lanes::Kernel for CablePlanarElasticForce<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, force } = self;
            let row = CablePlanar::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_planar_elastic_force(&row, &q, force);
        }
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 277 additions, 276 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_planar_elastic_tangent<T: ::rncf::emitted::lanes::Real>(
        row: &CablePlanar<T>,
        q: &[T; 8],
        stiffness: &mut [T::Cell; 64],
    ) {
        let CablePlanar { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, s0_x, s0_y, r1_x, r1_y, s1_x, s1_y] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let cross_s0_d = s0_x * d_y - s0_y * d_x;
        let cross_s0_s1 = s0_x * s1_y - s0_y * s1_x;
        let cross_d_s1 = s1_y * d_x - s1_x * d_y;
        let t41 = length * EA;
        let t42 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t43 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let t44 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][1] + t42 + t43
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][5];
        let stress_dot_s0_s0 = t41 * t44;
        let t46 = t41 * CABLE_PLANAR_AXIAL_STRAIN[0][0];
        let t47 = t41 * CABLE_PLANAR_AXIAL_STRAIN[0][1];
        let t48 = t41 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t49 = t41 * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let t50 = t41 * CABLE_PLANAR_AXIAL_STRAIN[0][5];
        let t51 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2];
        let t52 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[1][3];
        let t53 = strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let stress_dot_s0_d = t41
            * (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][1] + t51 + t52 + t53);
        let t55 = t41 * CABLE_PLANAR_AXIAL_STRAIN[1][1];
        let t56 = t41 * CABLE_PLANAR_AXIAL_STRAIN[1][2];
        let t57 = t41 * CABLE_PLANAR_AXIAL_STRAIN[1][3];
        let t58 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let stress_dot_s0_s1 = t41
            * (t53
                + (t58 + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2]));
        let t60 = t41 * CABLE_PLANAR_AXIAL_STRAIN[2][2];
        let t61 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let stress_dot_d_d = t41 * t61;
        let t63 = t41 * CABLE_PLANAR_AXIAL_STRAIN[3][3];
        let stress_dot_d_s1 = t41
            * (t52 + (t51 + t58) + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]);
        let t65 = t43
            + (t42
                + (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][0];
        let stress_dot_s1_s1 = t41 * t65;
        let t67 = inverse_length * EI;
        let t68 = cross_s0_s1 * CABLE_PLANAR_BENDING[0][1];
        let stress_cross_s0_d = t67
            * (cross_s0_d * CABLE_PLANAR_BENDING[0][0] + t68
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][2]);
        let t70 = t67 * CABLE_PLANAR_BENDING[0][0];
        let t71 = t67 * CABLE_PLANAR_BENDING[0][1];
        let t72 = t67 * CABLE_PLANAR_BENDING[0][2];
        let stress_cross_s0_s1 = t67
            * (cross_s0_d * CABLE_PLANAR_BENDING[0][1]
                + cross_s0_s1 * CABLE_PLANAR_BENDING[0][2]
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][1]);
        let stress_cross_d_s1 = t67
            * (t68 + cross_s0_d * CABLE_PLANAR_BENDING[0][2]
                + cross_d_s1 * CABLE_PLANAR_BENDING[0][0]);
        let t75 = s0_x * 2.0;
        let t76 = s0_y * 2.0;
        let t77 = d_x * 2.0;
        let t78 = d_y * 2.0;
        let t79 = s1_x * 2.0;
        let t80 = s1_y * 2.0;
        let t81 = d_x * t47;
        let t82 = d_y * t47;
        let t83 = s1_x * t48;
        let t84 = s1_y * t48;
        let t85 = t46 * t76 + t82 + t84;
        let t86 = t83 + (s0_x * t47 + t49 * t77);
        let t87 = t84 + (s0_y * t47 + t49 * t78);
        let t88 = s0_x * t48;
        let t89 = s0_y * t48;
        let t90 = t88 + d_x * t48 + t50 * t79;
        let t91 = t89 + d_y * t48 + t50 * t80;
        let t92 = d_x * t55;
        let t93 = d_y * t55;
        let t94 = s1_x * t56;
        let t95 = s1_y * t56;
        let t96 = t47 * t76 + t93 + t95;
        let t97 = t57 * t77;
        let t98 = t57 * t78;
        let t99 = s0_x * t55 + t97;
        let t100 = s0_y * t55 + t98;
        let t101 = s0_x * t56;
        let t102 = s0_y * t56;
        let t103 = t48 * t79;
        let t104 = t48 * t80;
        let t105 = t101 + t103;
        let t106 = t102 + t104;
        let t107 = d_x * t56;
        let t108 = d_y * t56;
        let t109 = t48 * t76 + t108 + s1_y * t60;
        let t110 = t94 + t101;
        let t111 = t95 + t102;
        let t112 = t103 + (t107 + s0_x * t60);
        let t113 = t104 + (t108 + s0_y * t60);
        let t114 = s0_y * t57 + t63 * t78 + s1_y * t57;
        let t115 = d_x * t57 + t49 * t79;
        let t116 = d_y * t57 + t49 * t80;
        let t117 = t98 + s1_y * t55;
        let t118 = t92 + t101 + t47 * t79;
        let t119 = t93 + t102 + t47 * t80;
        let t120 = t82 + t89 + t46 * t80;
        let t121 = d_y * t70;
        let t122 = d_x * t70;
        let t123 = s1_y * t71;
        let t124 = s1_x * t71;
        let t125 = t122 + t124;
        let t126 = s1_y * t72;
        let t127 = s1_x * t72;
        let t128 = t126 - s0_y * t70;
        let t129 = s0_x * t70 - t127;
        let t130 = s0_y * t71;
        let t131 = s0_x * t71;
        let t132 = t130 + d_y * t72;
        let t133 = t131 + d_x * t72;
        let t134 = d_y * t71;
        let t135 = d_x * t71;
        let t136 = t127 + t135;
        let t137 = t123 - t130;
        let t138 = t131 - t124;
        let t139 = s0_y * t72;
        let t140 = s0_x * t72;
        let t141 = t134 + t139;
        let t142 = t135 + t140;
        let t143 = t140 - s1_x * t70;
        let t144 = t121 + t130;
        let t145 = t122 + t131;
        let t146 = t75 * (t46 * t75 + t81 + t83) + d_x * (t47 * t75 + t92 + t94);
        let t147 = s0_x * t99 + t77 * (s0_x * t57 + t63 * t77 + s1_x * t57)
            + s1_x * (t97 + s1_x * t55);
        let t148 = t146 + s1_x * (t48 * t75 + t107 + s1_x * t60) + d_y * (t121 + t123);
        let t149 = t75 * t85 + d_x * t96 + s1_x * t109 - d_y * t125 - s1_y * t136;
        let t150 = t76 * t85 + d_y * t96 + s1_y * t109 + d_x * t125 + s1_x * t136;
        let t151 = t75 * t86 + d_x * t99 + s1_x * t110 + d_y * t128 + s1_y * t137;
        let t152 = t75 * t87 + d_x * t100 + s1_x * t111 + d_y * t129 + s1_y * t138;
        let t153 = t76 * t86 + d_y * t99 + s1_y * t110 - d_x * t128 - s1_x * t137;
        let t154 = t76 * t87 + d_y * t100 + s1_y * t111 - d_x * t129 - s1_x * t138;
        let t155 = t75 * t90 + d_x * t105 + s1_x * t112 - d_y * t132 - s1_y * t141;
        let t156 = t75 * t91 + d_x * t106 + s1_x * t113 + d_y * t133 + s1_y * t142;
        let t157 = t76 * t90 + d_y * t105 + s1_y * t112 + d_x * t132 + s1_x * t141;
        let t158 = t76 * t91 + d_y * t106 + s1_y * t113 - d_x * t133 - s1_x * t142;
        let t159 = s0_x * t112 + d_x * t118 + t79 * (t81 + t88 + t46 * t79)
            + s0_y * t141;
        let t160 = s0_x * t100 + t77 * t114 + s1_x * t117 - s0_y * t129 + s1_y * t143;
        let t161 = s0_y * t100 + t78 * t114 + s1_y * t117 + s0_x * t129 - s1_x * t143;
        let t162 = s0_x * t105 + t77 * t115 + s1_x * t118 + s0_y * t132 - s1_y * t144;
        let t163 = s0_x * t106 + t77 * t116 + s1_x * t119 - s0_y * t133 + s1_y * t145;
        let t164 = s0_y * t105 + t78 * t115 + s1_y * t118 - s0_x * t132 + s1_x * t144;
        let t165 = s0_y * t106 + t78 * t116 + s1_y * t119 + s0_x * t133 - s1_x * t145;
        let t166 = s0_x * t113 + d_x * t119 + t79 * t120 - s0_y * t142 - d_y * t145;
        let t167 = s0_y * t113 + d_y * t119 + t80 * t120 + s0_x * t142 + d_x * t145;
        let t168 = stress_dot_s0_s0 * 2.0;
        let t169 = stress_dot_s0_s1 + t155;
        let t170 = stress_dot_s0_s1 + t158;
        let t171 = stress_dot_d_d * 2.0;
        let t172 = stress_dot_s1_s1 * 2.0;
        let t173 = stress_cross_s0_s1 + t156;
        let t174 = t157 - stress_cross_s0_s1;
        let t175 = inverse_length * inverse_length;
        let t176 = (t147 - s0_y * t128 + s1_y * (s1_y * t70 - t139) + t171) * t175;
        let t177 = t160 * t175;
        let t178 = inverse_length * (stress_dot_s0_d + t151);
        let t179 = inverse_length * (t153 - stress_cross_s0_d);
        let t180 = inverse_length * (stress_dot_d_s1 + t162);
        let t181 = inverse_length * (stress_cross_d_s1 + t163);
        let t182 = (t161 + t171) * t175;
        let t183 = inverse_length * (stress_cross_s0_d + t152);
        let t184 = inverse_length * (stress_dot_s0_d + t154);
        let t185 = inverse_length * (t164 - stress_cross_d_s1);
        let t186 = inverse_length * (stress_dot_d_s1 + t165);
        stiffness[0] += t176;
        stiffness[1] += t177;
        stiffness[2] -= t178;
        stiffness[3] -= t179;
        stiffness[4] -= t176;
        stiffness[5] -= t177;
        stiffness[6] -= t180;
        stiffness[7] -= t181;
        stiffness[8] += t177;
        stiffness[9] += t182;
        stiffness[10] -= t183;
        stiffness[11] -= t184;
        stiffness[12] -= t177;
        stiffness[13] -= t182;
        stiffness[14] -= t185;
        stiffness[15] -= t186;
        stiffness[16] -= t178;
        stiffness[17] -= t183;
        stiffness[18] += t148 + s1_y * (t126 + t134) + t168;
        stiffness[19] += t149;
        stiffness[20] += t178;
        stiffness[21] += t183;
        stiffness[22] += t169;
        stiffness[23] += t173;
        stiffness[24] -= t179;
        stiffness[25] -= t184;
        stiffness[26] += t149;
        stiffness[27] += t150 + t168;
        stiffness[28] += t179;
        stiffness[29] += t184;
        stiffness[30] += t174;
        stiffness[31] += t170;
        stiffness[32] -= t176;
        stiffness[33] -= t177;
        stiffness[34] += t178;
        stiffness[35] += t179;
        stiffness[36] += t176;
        stiffness[37] += t177;
        stiffness[38] += t180;
        stiffness[39] += t181;
        stiffness[40] -= t177;
        stiffness[41] -= t182;
        stiffness[42] += t183;
        stiffness[43] += t184;
        stiffness[44] += t177;
        stiffness[45] += t182;
        stiffness[46] += t185;
        stiffness[47] += t186;
        stiffness[48] -= t180;
        stiffness[49] -= t185;
        stiffness[50] += t169;
        stiffness[51] += t174;
        stiffness[52] += t180;
        stiffness[53] += t185;
        stiffness[54] += t159 + d_y * t144 + t172;
        stiffness[55] += t166;
        stiffness[56] -= t181;
        stiffness[57] -= t186;
        stiffness[58] += t173;
        stiffness[59] += t170;
        stiffness[60] += t181;
        stiffness[61] += t186;
        stiffness[62] += t166;
        stiffness[63] += t167 + t172;
    }
    /// [`cable_planar_elastic_tangent`] of four elements side by side.
    pub struct CablePlanarElasticTangent<'a> {
        pub rows: [&'a CablePlanar; 4],
        pub q: &'a [[f64; 4]; 8],
        pub stiffness: &'a mut [[f64; 4]; 64],
    }
    impl ::rncf::emitted::lanes::Kernel for CablePlanarElasticTangent<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, stiffness } = self;
            let row = CablePlanar::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_planar_elastic_tangent(&row, &q, stiffness);
        }
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 58 additions, 76 multiplications, 1 divisions.
    pub fn cable_planar_strain_energy(
        row: &CablePlanar,
        q: &[f64; 8],
        energy: &mut f64,
    ) {
        let CablePlanar { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, s0_x, s0_y, r1_x, r1_y, s1_x, s1_y] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let dot_s0_s0 = s0_x * s0_x + s0_y * s0_y;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let dot_s0_d = s0_x * d_x + s0_y * d_y;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let dot_s0_s1 = s0_x * s1_x + s0_y * s1_y;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let dot_d_d = d_x * d_x + d_y * d_y;
        let strain_dot_d_d = dot_d_d - 1.0;
        let dot_d_s1 = s1_x * d_x + s1_y * d_y;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let dot_s1_s1 = s1_x * s1_x + s1_y * s1_y;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let cross_s0_d = s0_x * d_y - s0_y * d_x;
        let cross_s0_s1 = s0_x * s1_y - s0_y * s1_x;
        let cross_d_s1 = s1_y * d_x - s1_x * d_y;
        let t41 = length * EA * 0.5;
        let t42 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t43 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let t44 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][1] + t42 + t43
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][5];
        let t45 = strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2];
        let t46 = strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[1][3];
        let t47 = strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t48 = t41 * (strain_dot_s0_s0 * t44)
            + t41
                * (strain_dot_s0_d
                    * (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
                        + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][1] + t45 + t46
                        + t47));
        let t49 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][2];
        let t50 = t41
            * (strain_dot_s0_s1
                * (t47
                    + (t49 + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][2]
                        + strain_dot_s0_s1 * CABLE_PLANAR_AXIAL_STRAIN[2][2]
                        + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][2])));
        let t51 = strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_PLANAR_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][3];
        let t52 = t48 + t50 + t41 * (strain_dot_d_d * t51)
            + t41
                * (strain_dot_d_s1
                    * (t46 + (t45 + t49)
                        + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[1][1]
                        + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]));
        let t53 = t43
            + (t42
                + (strain_dot_s0_s0 * CABLE_PLANAR_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_PLANAR_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_PLANAR_AXIAL_STRAIN[0][0];
        let t54 = 0.5 * (inverse_length * EI);
        let t55 = cross_s0_s1 * CABLE_PLANAR_BENDING[0][1];
        let t56 = t52 + t41 * (strain_dot_s1_s1 * t53)
            + t54
                * (cross_s0_d
                    * (cross_s0_d * CABLE_PLANAR_BENDING[0][0] + t55
                        + cross_d_s1 * CABLE_PLANAR_BENDING[0][2]));
        let t57 = t56
            + t54
                * (cross_s0_s1
                    * (cross_s0_d * CABLE_PLANAR_BENDING[0][1]
                        + cross_s0_s1 * CABLE_PLANAR_BENDING[0][2]
                        + cross_d_s1 * CABLE_PLANAR_BENDING[0][1]))
            + t54
                * (cross_d_s1
                    * (t55 + cross_s0_d * CABLE_PLANAR_BENDING[0][2]
                        + cross_d_s1 * CABLE_PLANAR_BENDING[0][0]));
        *energy += t57;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_planar_mass(row: &CablePlanar, mass: &mut [f64; 16]) {
        let CablePlanar { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * CABLE_PLANAR_MASS_MATRIX[0][0];
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * CABLE_PLANAR_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * CABLE_PLANAR_MASS_MATRIX[0][2];
        let mass_r0_s1 = t16 * CABLE_PLANAR_MASS_MATRIX[0][3];
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * CABLE_PLANAR_MASS_MATRIX[1][1];
        let mass_s0_r1 = t16 * CABLE_PLANAR_MASS_MATRIX[1][2];
        let mass_s0_s1 = t20 * CABLE_PLANAR_MASS_MATRIX[1][3];
        let mass_r1_s1 = t16 * CABLE_PLANAR_MASS_MATRIX[2][3];
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
    pub fn cable_planar_shapes_position_0(length: f64, xi: f64, weights: &mut [f64; 4]) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[2] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[3] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn cable_planar_shapes_position_1(length: f64, xi: f64, weights: &mut [f64; 4]) {
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
    pub fn cable_planar_shapes_position_2(length: f64, xi: f64, weights: &mut [f64; 4]) {
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
    /// Operations: 10 additions, 22 multiplications.
    pub fn cable_planar_field_forces(
        row: &CablePlanar,
        stress_free: &[f64; 4],
        fields: &[f64; 4],
        forces: &mut [f64; 4],
    ) {
        let CablePlanar { length, EA, EI, .. } = *row;
        let t22 = 0.5 * (fields[0] * fields[0] + fields[1] * fields[1] - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    - 1.0);
        let t23 = EA * t22;
        let t24 = EI
            * (fields[0] * fields[3] - fields[1] * fields[2]
                - (stress_free[0] * stress_free[3] - stress_free[1] * stress_free[2]));
        forces[0] = t23 * (0.5 * (fields[0] * 2.0)) + fields[3] * t24;
        forces[1] = t23 * (0.5 * (fields[1] * 2.0)) - fields[2] * t24;
        forces[2] = -fields[1] * t24;
        forces[3] = fields[0] * t24;
    }
    /// Motion of frame `hub` and its first two derivatives.
    ///
    /// Operations: 8 additions, 13 multiplications, 6 divisions, 4 function calls.
    pub fn frame_hub(model: &SpinUp, t: f64, motion: &mut ::rncf::emitted::FrameMotion) {
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
        model: &SpinUp,
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
    pub fn kinks(model: &SpinUp, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn outputs(model: &SpinUp, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0] - 8.0;
        out[1] = observed[1];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &SpinUp, run: &mut ::rncf::RunDefaults) {
        run.t_end = 20.0;
        run.every = 0.05;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: SpinUp,
        pub row_beam: CablePlanar,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &SpinUp) -> Self {
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
            ])
        }
        fn output_columns(&self) -> usize {
            2
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
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [8.0, 0.0, 0.0],
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
            let area = ::rncf::emitted::positive(
                "section `tube`",
                "area",
                7.299e-5,
                "m^2",
            )?;
            let second_moment = ::rncf::emitted::positive(
                "section `tube`",
                "second_moment",
                8.215e-9,
                "m^4",
            )?;
            self.row_beam = CablePlanar {
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
            cable_planar_mass(&self.row_beam, ::rncf::emitted::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            cable_planar_elastic_force(
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
            cable_planar_elastic_tangent(
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
            let four = CablePlanarElasticForce {
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
            let four = CablePlanarElasticTangent {
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
            cable_planar_strain_energy(
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
                    cable_planar_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    cable_planar_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 2) => {
                    cable_planar_shapes_position_2(
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
                area: 7.299e-5,
                second_moments: [8.215e-9, 8.215e-9],
                torsion_constant: 0.0,
                young_over_shear: 2.0 * (1.0 + 0.3),
                softness_of_curves: 4.0,
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
            cable_planar_field_forces(
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
