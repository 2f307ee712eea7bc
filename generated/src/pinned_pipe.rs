//! Expansion of `models/src/pinned_pipe.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use pinned_pipe_equations::PinnedPipe;
#[allow(clippy::all)]
impl Default for PinnedPipe {
    fn default() -> Self {
        Self {
            elements: 16,
            support: 40000.0,
            push: 200.0,
            rate: 60.0,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for PinnedPipe {
    const NAME: &'static str = "PinnedPipe";
    const DOC: &'static str = "A pipe on nine elastic supports, shaken by a force between two of them. It has a frame of its own that it hardly needs,\nas nothing turns far: every support ties the frame and the pipe to the ground.";
    const SOURCE: &'static str = r#"pub model PinnedPipe {
    /// Number of elements.
    param elements: count = 16;
    /// Stiffness of a support along each axis.
    param support = 40 kN/m;
    /// Amplitude of the force.
    param push = 200 N;
    /// Its angular frequency.
    param rate = 60 rad/s;

    const length = 8 m;

    material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
    section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }

    /// Follows the pipe's chord.
    frame own = free(plane = xy);
    body pipe in own {
        planar xy;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * cable(tube, aluminium);
        chord;
    }

    spring support_0 = bushing(pipe.start, inertial.at([0, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_1 = bushing(pipe.at(1 m), inertial.at([1, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_2 = bushing(pipe.at(2 m), inertial.at([2, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_3 = bushing(pipe.at(3 m), inertial.at([3, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_4 = bushing(pipe.at(4 m), inertial.at([4, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_5 = bushing(pipe.at(5 m), inertial.at([5, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_6 = bushing(pipe.at(6 m), inertial.at([6, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_7 = bushing(pipe.at(7 m), inertial.at([7, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
    spring support_8 = bushing(pipe.end, inertial.at([8, 0, 0] m), stiffness = [support, support, 0 [N/m]]);

    load shake = force(pipe.at(3.5 m), [0 N, push * sin(rate * t), 0 N], in = inertial);

    /// Deflection under the force.
    output v = pipe.at(3.5 m).in(inertial).y;
    /// Deflection of the far end.
    output v_end = pipe.end.in(inertial).y;

    run { t_end = 0.5 s; every = 2.5 ms; }
}"#;
    const EQUATIONS_HASH: u64 = 0x151d863dfad377c5;
    const NOTES: &'static [&'static str] = &[
        "Body `pipe` uses `cable_planar`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 185 and 554; points unrolled: 343 and 1077; loop over points: 375 and 1181; a loop counts 1.3 times).",
        "Body `pipe` is planar: two components a vector, no motion along the normal.",
        "Body `pipe` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `pipe`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `pipe` moves in the free frame `own`, which follows the body's chord: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Frame `own` is free in three motions: two positions and an angle.",
        "Force `support_0`, `support_1`, `support_2`, `support_3`, `support_4`, `support_5`, `support_6`, `support_7`, `support_8`: a potential; its tangents are derived.",
        "Force `shake`: no potential; its tangents are derived.",
        "Not declared, so that no function is written for it: fixtures, constraints with multipliers, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as force `shake` has no potential.",
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
            name: "force_value_support_0",
            additions: 2,
            multiplications: 2,
            divisions: 0,
            functions: 0,
            weighted: 4,
        },
        ::rncf::model::KernelCount {
            name: "force_energy_support_0",
            additions: 3,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "force_value_shake",
            additions: 0,
            multiplications: 2,
            divisions: 0,
            functions: 1,
            weighted: 22,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 16.0,
                doc: "Number of elements.",
            },
            ::rncf::Param {
                name: "support",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kN/m",
                unit_si: 1000.0,
                dimension: [0, 1, -2, 0, 0, 0],
                default: 40000.0,
                doc: "Stiffness of a support along each axis.",
            },
            ::rncf::Param {
                name: "push",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 200.0,
                doc: "Amplitude of the force.",
            },
            ::rncf::Param {
                name: "rate",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 60.0,
                doc: "Its angular frequency.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "v",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection under the force.",
            },
            ::rncf::Output {
                name: "v_end",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Deflection of the far end.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.elements as f64,
            1 => self.support,
            2 => self.push,
            3 => self.rate,
            _ => panic!("PinnedPipe has 4 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.elements = value as usize,
            1 => self.support = value,
            2 => self.push = value,
            3 => self.rate = value,
            _ => panic!("PinnedPipe has 4 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        pinned_pipe_equations::run_defaults(self, &mut run);
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
        let equations = pinned_pipe_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`PinnedPipe`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod pinned_pipe_equations {
    /// A pipe on nine elastic supports, shaken by a force between two of them. It has a frame of its own that it hardly needs,
    /// as nothing turns far: every support ties the frame and the pipe to the ground.
    ///
    /// # Chosen and left out
    ///
    /// * Body `pipe` uses `cable_planar`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 185 and 554; points unrolled: 343 and 1077; loop over points: 375 and 1181; a loop counts 1.3 times).
    /// * Body `pipe` is planar: two components a vector, no motion along the normal.
    /// * Body `pipe` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `pipe`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `pipe` moves in the free frame `own`, which follows the body's chord: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Frame `own` is free in three motions: two positions and an angle.
    /// * Force `support_0`, `support_1`, `support_2`, `support_3`, `support_4`, `support_5`, `support_6`, `support_7`, `support_8`: a potential; its tangents are derived.
    /// * Force `shake`: no potential; its tangents are derived.
    /// * Not declared, so that no function is written for it: fixtures, constraints with multipliers, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as force `shake` has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct PinnedPipe {
        /// Number of elements. (count)
        pub elements: usize,
        /// Stiffness of a support along each axis. (SI; declared in kN/m)
        pub support: f64,
        /// Amplitude of the force. (SI; declared in N)
        pub push: f64,
        /// Its angular frequency. (SI; declared in rad/s)
        pub rate: f64,
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
    /// Free frame `own`: its start relative to its parent, and its rigid parts.
    ///
    /// Follows the pipe's chord.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_own(model: &PinnedPipe, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.axis[2] = 1.0;
    }
    /// Force `support_0`, `support_1`, `support_2`, `support_3`, `support_4`, `support_5`, `support_6`, `support_7`, `support_8`: writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.
    ///
    /// Of `support_0`: `z[0]` a place on `pipe`; `z[1]` a point of `inertial` (inertial axes).
    ///
    /// Operations: 2 additions, 2 multiplications.
    pub fn force_value_support_0(
        model: &PinnedPipe,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        out: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        out[0] = -model.support * (z[0][0] - z[1][0]);
        out[1] = -model.support * (z[0][1] - z[1][1]);
    }
    /// Force `support_0`, `support_1`, `support_2`, `support_3`, `support_4`, `support_5`, `support_6`, `support_7`, `support_8`: writes df/dz and df/dz', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn force_tangent_support_0(
        model: &PinnedPipe,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        by_value[0] = -model.support;
        by_value[3] = model.support;
        by_value[7] = -model.support;
        by_value[10] = model.support;
    }
    /// Force `support_0`, `support_1`, `support_2`, `support_3`, `support_4`, `support_5`, `support_6`, `support_7`, `support_8`: its potential (J).
    ///
    /// Operations: 3 additions, 6 multiplications.
    pub fn force_energy_support_0(
        model: &PinnedPipe,
        t: f64,
        z: &[::rncf::emitted::Vector],
        energy: &mut f64,
    ) {
        let z = &z[..2];
        let t17 = z[0][0] - z[1][0];
        let t18 = z[0][1] - z[1][1];
        *energy = t17 * (0.5 * (model.support * t17))
            + t18 * (0.5 * (model.support * t18));
    }
    /// Force `shake`: writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.
    ///
    /// Of `shake`: `z[0]` a place on `pipe` (inertial axes).
    ///
    /// Operations: 0 additions, 2 multiplications, 1 function calls.
    pub fn force_value_shake(
        model: &PinnedPipe,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        out: &mut [f64],
    ) {
        let z = &z[..1];
        let velocity = &velocity[..1];
        out[1] = model.push * (t * model.rate).sin();
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &PinnedPipe, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &PinnedPipe, run: &mut ::rncf::RunDefaults) {
        run.t_end = 0.5;
        run.every = 0.0025;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: PinnedPipe,
        pub row_pipe: CablePlanar,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &PinnedPipe) -> Self {
            Self {
                model: model.clone(),
                row_pipe: Default::default(),
            }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 19,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 17,
                    derivative: 0,
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
            ["inertial", "own"][frame]
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
            Some("force `shake` has no potential")
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            Ok(())
        }
        fn free(&self) -> ::std::vec::Vec<::rncf::emitted::FreeSpec> {
            let still = ::rncf::emitted::FreeSpec {
                frame: 0,
                parent: 0,
                is_body: false,
                motions: ::rncf::emitted::Motions::Spatial,
                position: ::rncf::emitted::Vector::zeros(),
                axis: ::rncf::emitted::Vector::zeros(),
                angle: 0.0,
                velocity: ::rncf::emitted::Vector::zeros(),
                spin: ::rncf::emitted::Vector::zeros(),
                rigid: ::rncf::emitted::RigidSpec::default(),
                size: 1.0,
            };
            let mut specs = ::std::vec::Vec::from([
                ::rncf::emitted::FreeSpec {
                    frame: 1,
                    parent: 0,
                    is_body: false,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
            ]);
            free_own(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Turn {
                    frame: 0,
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(1.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(2.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [2.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(3.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [3.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(4.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [4.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(5.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [5.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(6.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [6.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(7.0),
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [7.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [8.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::At(3.5),
                },
            ])
        }
    }
    impl ::rncf::emitted::Bodies for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::emitted::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::BodySpec {
                    name: "pipe",
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
                    tie: ::rncf::emitted::FrameTie::Chord,
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
            self.row_pipe = CablePlanar {
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
            cable_planar_mass(&self.row_pipe, ::rncf::emitted::array_mut(mass));
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
                &self.row_pipe,
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
                &self.row_pipe,
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
                rows: [&self.row_pipe; 4],
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
                rows: [&self.row_pipe; 4],
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
                &self.row_pipe,
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
                        self.row_pipe.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    cable_planar_shapes_position_1(
                        self.row_pipe.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 2) => {
                    cable_planar_shapes_position_2(
                        self.row_pipe.length,
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
                young_over_shear: 0.0,
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
                &self.row_pipe,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array_mut(forces),
            );
        }
    }
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::WithoutJointConditions for Equations {}
    impl ::rncf::emitted::WithoutLoads for Equations {}
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::WithoutMarkerConstraints for Equations {}
    impl ::rncf::emitted::MarkerForces for Equations {
        fn forces(&self) -> ::std::vec::Vec<::rncf::emitted::ForceSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ForceSpec {
                    name: "support_0",
                    markers: &[0, 1],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_1",
                    markers: &[3, 4],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_2",
                    markers: &[5, 6],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_3",
                    markers: &[7, 8],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_4",
                    markers: &[9, 10],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_5",
                    markers: &[11, 12],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_6",
                    markers: &[13, 14],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_7",
                    markers: &[15, 16],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "support_8",
                    markers: &[17, 18],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "shake",
                    markers: &[19],
                    conservative: false,
                    of_differences: true,
                    branches: 0,
                },
            ])
        }
        fn is_load(&self, force: usize) -> bool {
            matches!(force, 9)
        }
        fn marker_force(
            &self,
            force: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            out: &mut [f64],
        ) {
            out.fill(0.0);
            match force {
                0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 => {
                    force_value_support_0(&self.model, t, z, velocity, out)
                }
                9 => force_value_shake(&self.model, t, z, velocity, out),
                _ => {}
            }
        }
        fn marker_force_tangent(
            &self,
            force: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            by_value: &mut [f64],
            by_velocity: &mut [f64],
        ) {
            by_value.fill(0.0);
            by_velocity.fill(0.0);
            match force {
                0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 => {
                    force_tangent_support_0(
                        &self.model,
                        t,
                        z,
                        velocity,
                        by_value,
                        by_velocity,
                    )
                }
                _ => {}
            }
        }
        fn marker_force_branches(
            &self,
            force: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            out: &mut [f64],
        ) {}
        fn force_course(
            &self,
            force: usize,
        ) -> ::std::option::Option<::rncf::emitted::Courses> {
            ::std::option::Option::None
        }
        fn marker_energy(
            &self,
            force: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
        ) -> f64 {
            let mut energy = 0.0;
            match force {
                0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 => {
                    force_energy_support_0(&self.model, t, z, &mut energy)
                }
                _ => {}
            }
            energy
        }
    }
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
