//! Expansion of `models/src/free_flight.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use free_flight_equations::FreeFlight;
#[allow(clippy::all)]
impl Default for FreeFlight {
    fn default() -> Self {
        Self {
            elements: 3,
            tip_mass: 0.7,
            radius: 1.5,
            roll: 4.0,
            pitch: -1.0,
            yaw: 1.0,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for FreeFlight {
    const NAME: &'static str = "FreeFlight";
    const DOC: &'static str = "A soft cable that flies and tumbles freely with a mass at its end: nothing acts on it, so that energy, momentum and\nangular momentum stay.";
    const SOURCE: &'static str = r#"pub model FreeFlight {
    /// Number of elements.
    param elements: count = 3;
    /// Mass at the end.
    param tip_mass = 0.7 kg;
    /// Radius of the arc that the cable starts in.
    param radius = 1.5 m;
    /// Initial angular velocity about the tangent at the cable's start: it keeps the cable bent.
    param roll = 4 rad/s;
    /// Initial angular velocity in the plane of the arc, across the tangent.
    param pitch = -1 rad/s;
    /// Initial angular velocity about the normal of the arc.
    param yaw = 1 rad/s;

    // EA = 400 N, EI = 2 N m^2 and 1.5 kg/m.
    material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
    section flat { area = 10 cm^2; second_moment = 500 cm^4; }

    /// Frame of the cable: it follows the chord, which no quick bending turns.
    frame f = free(
        origin = [0.3, -0.2, 0.5] m, axis = [1, 2, -1], angle = 40 deg,
        velocity = [-3, 1, 2] m/s, angular_velocity = [roll, pitch, yaw]
    );
    body cable in f {
        spatial;
        line from [0, 0, 0] m to [2, 0, 0] m;
        mesh elements * cable(flat, soft);
        initial position [radius * sin(x / radius), radius * (1 - cos(x / radius)), 0];
        chord;
    }
    fixture tip on cable.end { mass = tip_mass; }

    /// Start of the cable in space.
    output start = cable.start.in(inertial);
    /// End of the cable in space.
    output end = cable.end.in(inertial);
    /// Distance between the ends.
    output span = norm(cable.end.position - cable.start.position);

    run { t_end = 2 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xd51e7bd782ea4fca;
    const NOTES: &'static [&'static str] = &[
        "Body `cable` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `cable` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `cable`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `cable` moves in the free frame `f`, which follows the body's chord: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Frame `f` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Fixture `tip` adds constants to the inertia of `cable` and no unknowns.",
        "Not declared, so that no function is written for it: constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: forces between two states that conserve energy are derived.",
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
            name: "cable_spatial_conserving_force",
            additions: 128,
            multiplications: 154,
            divisions: 1,
            functions: 0,
            weighted: 286,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_conserving_tangent",
            additions: 545,
            multiplications: 562,
            divisions: 1,
            functions: 0,
            weighted: 1111,
        },
        ::rncf::model::KernelCount {
            name: "initial_cable",
            additions: 1,
            multiplications: 6,
            divisions: 2,
            functions: 2,
            weighted: 55,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 5,
            multiplications: 3,
            divisions: 0,
            functions: 1,
            weighted: 28,
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
                default: 3.0,
                doc: "Number of elements.",
            },
            ::rncf::Param {
                name: "tip_mass",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kg",
                unit_si: 1.0,
                dimension: [0, 1, 0, 0, 0, 0],
                default: 0.7,
                doc: "Mass at the end.",
            },
            ::rncf::Param {
                name: "radius",
                kind: ::rncf::ParamKind::Quantity,
                unit: "m",
                unit_si: 1.0,
                dimension: [1, 0, 0, 0, 0, 0],
                default: 1.5,
                doc: "Radius of the arc that the cable starts in.",
            },
            ::rncf::Param {
                name: "roll",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 4.0,
                doc: "Initial angular velocity about the tangent at the cable's start: it keeps the cable bent.",
            },
            ::rncf::Param {
                name: "pitch",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: -1.0,
                doc: "Initial angular velocity in the plane of the arc, across the tangent.",
            },
            ::rncf::Param {
                name: "yaw",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 1.0,
                doc: "Initial angular velocity about the normal of the arc.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "start",
                unit: "m",
                time_exponent: 0.0,
                components: &["x", "y", "z"],
                doc: "Start of the cable in space.",
            },
            ::rncf::Output {
                name: "end",
                unit: "m",
                time_exponent: 0.0,
                components: &["x", "y", "z"],
                doc: "End of the cable in space.",
            },
            ::rncf::Output {
                name: "span",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Distance between the ends.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.elements as f64,
            1 => self.tip_mass,
            2 => self.radius,
            3 => self.roll,
            4 => self.pitch,
            5 => self.yaw,
            _ => panic!("FreeFlight has 6 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.elements = value as usize,
            1 => self.tip_mass = value,
            2 => self.radius = value,
            3 => self.roll = value,
            4 => self.pitch = value,
            5 => self.yaw = value,
            _ => panic!("FreeFlight has 6 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        free_flight_equations::run_defaults(self, &mut run);
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
        let equations = free_flight_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`FreeFlight`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod free_flight_equations {
    /// A soft cable that flies and tumbles freely with a mass at its end: nothing acts on it, so that energy, momentum and
    /// angular momentum stay.
    ///
    /// # Chosen and left out
    ///
    /// * Body `cable` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).
    /// * Body `cable` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `cable`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `cable` moves in the free frame `f`, which follows the body's chord: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Frame `f` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Fixture `tip` adds constants to the inertia of `cable` and no unknowns.
    /// * Not declared, so that no function is written for it: constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: forces between two states that conserve energy are derived.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct FreeFlight {
        /// Number of elements. (count)
        pub elements: usize,
        /// Mass at the end. (SI; declared in kg)
        pub tip_mass: f64,
        /// Radius of the arc that the cable starts in. (SI; declared in m)
        pub radius: f64,
        /// Initial angular velocity about the tangent at the cable's start: it keeps the cable bent. (SI; declared in rad/s)
        pub roll: f64,
        /// Initial angular velocity in the plane of the arc, across the tangent. (SI; declared in rad/s)
        pub pitch: f64,
        /// Initial angular velocity about the normal of the arc. (SI; declared in rad/s)
        pub yaw: f64,
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
    /// Adds the elastic force of one element between two states that does the work U(end) - U(start) over the step and has no moment about the mean positions: S_A(mean of I) dI_A/dq(mean of q).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 128 additions, 154 multiplications, 1 divisions.
    pub fn cable_spatial_conserving_force(
        row: &CableSpatial,
        start: &[f64; 12],
        end: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let [o_r0_x, o_r0_y, o_r0_z, o_s0_x, o_s0_y, o_s0_z, o_r1_x, o_r1_y, o_r1_z,
        o_s1_x, o_s1_y, o_s1_z] = *start;
        let [e_r0_x, e_r0_y, e_r0_z, e_s0_x, e_s0_y, e_s0_z, e_r1_x, e_r1_y, e_r1_z,
        e_s1_x, e_s1_y, e_s1_z] = *end;
        let inverse_length = 1.0 / length;
        let o_d_x = inverse_length * (o_r1_x - o_r0_x);
        let o_d_y = inverse_length * (o_r1_y - o_r0_y);
        let o_d_z = inverse_length * (o_r1_z - o_r0_z);
        let e_d_x = inverse_length * (e_r1_x - e_r0_x);
        let e_d_y = inverse_length * (e_r1_y - e_r0_y);
        let e_d_z = inverse_length * (e_r1_z - e_r0_z);
        let t46 = 0.5 * (o_s0_x + e_s0_x);
        let t47 = 0.5 * (o_s0_y + e_s0_y);
        let t48 = 0.5 * (o_s0_z + e_s0_z);
        let t49 = 0.5 * (o_d_x + e_d_x);
        let t50 = 0.5 * (o_d_y + e_d_y);
        let t51 = 0.5 * (o_d_z + e_d_z);
        let t52 = 0.5 * (o_s1_x + e_s1_x);
        let t53 = 0.5 * (o_s1_y + e_s1_y);
        let t54 = 0.5 * (o_s1_z + e_s1_z);
        let t55 = o_s0_x * o_s0_x + o_s0_y * o_s0_y + o_s0_z * o_s0_z
            + (e_s0_x * e_s0_x + e_s0_y * e_s0_y + e_s0_z * e_s0_z);
        let dot_s0_s0 = 0.5 * t55;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let t58 = o_s0_x * o_d_x + o_s0_y * o_d_y + o_s0_z * o_d_z
            + (e_s0_x * e_d_x + e_s0_y * e_d_y + e_s0_z * e_d_z);
        let dot_s0_d = 0.5 * t58;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let t61 = o_s0_x * o_s1_x + o_s0_y * o_s1_y + o_s0_z * o_s1_z
            + (e_s0_x * e_s1_x + e_s0_y * e_s1_y + e_s0_z * e_s1_z);
        let dot_s0_s1 = 0.5 * t61;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let t64 = o_d_x * o_d_x + o_d_y * o_d_y + o_d_z * o_d_z
            + (e_d_x * e_d_x + e_d_y * e_d_y + e_d_z * e_d_z);
        let dot_d_d = 0.5 * t64;
        let strain_dot_d_d = dot_d_d - 1.0;
        let t67 = o_s1_x * o_d_x + o_s1_y * o_d_y + o_s1_z * o_d_z
            + (e_s1_x * e_d_x + e_s1_y * e_d_y + e_s1_z * e_d_z);
        let dot_d_s1 = 0.5 * t67;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let t70 = o_s1_x * o_s1_x + o_s1_y * o_s1_y + o_s1_z * o_s1_z
            + (e_s1_x * e_s1_x + e_s1_y * e_s1_y + e_s1_z * e_s1_z);
        let dot_s1_s1 = 0.5 * t70;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let t73 = length * EA;
        let t74 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t75 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t76 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t74 + t75
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t77 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t78 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t79 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t80 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t81 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t82 = t75
            + (t74
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t83 = inverse_length * EI;
        let t84 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t73 * t76
            + t83
                * (t84 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t86 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t73
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t77 + t78 + t79)
            + t83
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t86
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t88 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t73
            * (t79
                + (t80 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t83
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t88
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let stress_dot_d_d = t73 * t81
            + t83
                * (t88 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t73
            * (t78 + (t77 + t80) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t83
                * (t86
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t73 * t82
            + t83
                * (t84
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
        let t93 = inverse_length
            * (t46 * stress_dot_s0_d + stress_dot_d_d * (t49 * 2.0)
                + t52 * stress_dot_d_s1);
        let t94 = inverse_length
            * (t47 * stress_dot_s0_d + stress_dot_d_d * (t50 * 2.0)
                + t53 * stress_dot_d_s1);
        let t95 = inverse_length
            * (t48 * stress_dot_s0_d + stress_dot_d_d * (t51 * 2.0)
                + t54 * stress_dot_d_s1);
        force[0] -= t93;
        force[1] -= t94;
        force[2] -= t95;
        force[3]
            += stress_dot_s0_s0 * (t46 * 2.0) + t49 * stress_dot_s0_d
                + t52 * stress_dot_s0_s1;
        force[4]
            += stress_dot_s0_s0 * (t47 * 2.0) + t50 * stress_dot_s0_d
                + t53 * stress_dot_s0_s1;
        force[5]
            += stress_dot_s0_s0 * (t48 * 2.0) + t51 * stress_dot_s0_d
                + t54 * stress_dot_s0_s1;
        force[6] += t93;
        force[7] += t94;
        force[8] += t95;
        force[9]
            += t46 * stress_dot_s0_s1 + t49 * stress_dot_d_s1
                + stress_dot_s1_s1 * (t52 * 2.0);
        force[10]
            += t47 * stress_dot_s0_s1 + t50 * stress_dot_d_s1
                + stress_dot_s1_s1 * (t53 * 2.0);
        force[11]
            += t48 * stress_dot_s0_s1 + t51 * stress_dot_d_s1
                + stress_dot_s1_s1 * (t54 * 2.0);
    }
    /// Adds the derivative of the conserving force of one element with respect to the mean of both states at a fixed start (half of it is that with respect to the end), rows first; not symmetric.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 545 additions, 562 multiplications, 1 divisions.
    pub fn cable_spatial_conserving_tangent(
        row: &CableSpatial,
        start: &[f64; 12],
        end: &[f64; 12],
        stiffness: &mut [f64; 144],
    ) {
        let CableSpatial { length, EA, EI, .. } = *row;
        let [o_r0_x, o_r0_y, o_r0_z, o_s0_x, o_s0_y, o_s0_z, o_r1_x, o_r1_y, o_r1_z,
        o_s1_x, o_s1_y, o_s1_z] = *start;
        let [e_r0_x, e_r0_y, e_r0_z, e_s0_x, e_s0_y, e_s0_z, e_r1_x, e_r1_y, e_r1_z,
        e_s1_x, e_s1_y, e_s1_z] = *end;
        let inverse_length = 1.0 / length;
        let o_d_x = inverse_length * (o_r1_x - o_r0_x);
        let o_d_y = inverse_length * (o_r1_y - o_r0_y);
        let o_d_z = inverse_length * (o_r1_z - o_r0_z);
        let e_d_x = inverse_length * (e_r1_x - e_r0_x);
        let e_d_y = inverse_length * (e_r1_y - e_r0_y);
        let e_d_z = inverse_length * (e_r1_z - e_r0_z);
        let t46 = 0.5 * (o_s0_x + e_s0_x);
        let t47 = 0.5 * (o_s0_y + e_s0_y);
        let t48 = 0.5 * (o_s0_z + e_s0_z);
        let t49 = 0.5 * (o_d_x + e_d_x);
        let t50 = 0.5 * (o_d_y + e_d_y);
        let t51 = 0.5 * (o_d_z + e_d_z);
        let t52 = 0.5 * (o_s1_x + e_s1_x);
        let t53 = 0.5 * (o_s1_y + e_s1_y);
        let t54 = 0.5 * (o_s1_z + e_s1_z);
        let t55 = o_s0_x * o_s0_x + o_s0_y * o_s0_y + o_s0_z * o_s0_z
            + (e_s0_x * e_s0_x + e_s0_y * e_s0_y + e_s0_z * e_s0_z);
        let dot_s0_s0 = 0.5 * t55;
        let strain_dot_s0_s0 = dot_s0_s0 - 1.0;
        let t58 = o_s0_x * o_d_x + o_s0_y * o_d_y + o_s0_z * o_d_z
            + (e_s0_x * e_d_x + e_s0_y * e_d_y + e_s0_z * e_d_z);
        let dot_s0_d = 0.5 * t58;
        let strain_dot_s0_d = dot_s0_d - 1.0;
        let t61 = o_s0_x * o_s1_x + o_s0_y * o_s1_y + o_s0_z * o_s1_z
            + (e_s0_x * e_s1_x + e_s0_y * e_s1_y + e_s0_z * e_s1_z);
        let dot_s0_s1 = 0.5 * t61;
        let strain_dot_s0_s1 = dot_s0_s1 - 1.0;
        let t64 = o_d_x * o_d_x + o_d_y * o_d_y + o_d_z * o_d_z
            + (e_d_x * e_d_x + e_d_y * e_d_y + e_d_z * e_d_z);
        let dot_d_d = 0.5 * t64;
        let strain_dot_d_d = dot_d_d - 1.0;
        let t67 = o_s1_x * o_d_x + o_s1_y * o_d_y + o_s1_z * o_d_z
            + (e_s1_x * e_d_x + e_s1_y * e_d_y + e_s1_z * e_d_z);
        let dot_d_s1 = 0.5 * t67;
        let strain_dot_d_s1 = dot_d_s1 - 1.0;
        let t70 = o_s1_x * o_s1_x + o_s1_y * o_s1_y + o_s1_z * o_s1_z
            + (e_s1_x * e_s1_x + e_s1_y * e_s1_y + e_s1_z * e_s1_z);
        let dot_s1_s1 = 0.5 * t70;
        let strain_dot_s1_s1 = dot_s1_s1 - 1.0;
        let t73 = length * EA;
        let t74 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t75 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t76 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t74 + t75
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t77 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t78 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[0][1];
        let t79 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t80 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t81 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t82 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t83 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t84 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t85 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t86 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[3][3];
        let t87 = t75
            + (t74
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t88 = inverse_length * EI;
        let t89 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t73 * t76
            + t88
                * (t89 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t91 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + t88 * CABLE_SPATIAL_BENDING[0][3];
        let t92 = t79 + t88 * CABLE_SPATIAL_BENDING[0][4];
        let t93 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
            + t88 * CABLE_SPATIAL_BENDING[0][5];
        let t94 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t73
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t80 + t81 + t82)
            + t88
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t94
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t96 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
            + t88 * CABLE_SPATIAL_BENDING[1][1];
        let t97 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
            + t88 * CABLE_SPATIAL_BENDING[1][2];
        let t98 = t88 * CABLE_SPATIAL_BENDING[1][4];
        let t99 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t73
            * (t82
                + (t84 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t88
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t99
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let t101 = t88 * CABLE_SPATIAL_BENDING[2][2];
        let t102 = t73 * CABLE_SPATIAL_AXIAL_STRAIN[2][2] + t101;
        let stress_dot_d_d = t73 * t85
            + t88
                * (t99 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t73
            * (t81 + (t80 + t84) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t88
                * (t94
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t73 * t87
            + t88
                * (t89
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
        let t106 = t46 * 2.0;
        let t107 = t47 * 2.0;
        let t108 = t48 * 2.0;
        let t109 = t49 * 2.0;
        let t110 = t50 * 2.0;
        let t111 = t51 * 2.0;
        let t112 = t52 * 2.0;
        let t113 = t53 * 2.0;
        let t114 = t54 * 2.0;
        let t115 = e_s0_x * 2.0;
        let t116 = e_s0_y * 2.0;
        let t117 = e_s0_z * 2.0;
        let t118 = e_d_x * 2.0;
        let t119 = e_d_y * 2.0;
        let t120 = e_d_z * 2.0;
        let t121 = e_s1_x * 2.0;
        let t122 = e_s1_y * 2.0;
        let t123 = e_s1_z * 2.0;
        let t124 = e_d_x * t78;
        let t125 = e_d_y * t78;
        let t126 = e_d_z * t78;
        let t127 = e_s1_x * t79;
        let t128 = e_s1_y * t79;
        let t129 = e_s1_z * t79;
        let t130 = t77 * t115 + t124 + t127;
        let t131 = t77 * t116 + t125 + t128;
        let t132 = t77 * t117 + t126 + t129;
        let t133 = t91 * t118;
        let t134 = t91 * t119;
        let t135 = t91 * t120;
        let t136 = e_s0_x * t78 + t133 + e_s1_x * t92;
        let t137 = e_s0_y * t78 + t134 + e_s1_y * t92;
        let t138 = e_s0_z * t78 + t135 + e_s1_z * t92;
        let t139 = e_s0_x * t79;
        let t140 = e_s0_y * t79;
        let t141 = e_s0_z * t79;
        let t142 = e_d_x * t92;
        let t143 = e_d_y * t92;
        let t144 = e_d_z * t92;
        let t145 = t139 + t142 + t93 * t121;
        let t146 = t140 + t143 + t93 * t122;
        let t147 = t141 + t144 + t93 * t123;
        let t148 = e_d_x * t96;
        let t149 = e_d_y * t96;
        let t150 = e_d_z * t96;
        let t151 = e_s1_x * t97;
        let t152 = e_s1_y * t97;
        let t153 = e_s1_z * t97;
        let t154 = t78 * t115 + t148 + t151;
        let t155 = t78 * t116 + t149 + t152;
        let t156 = t78 * t117 + t150 + t153;
        let t157 = t83 * t118;
        let t158 = t83 * t119;
        let t159 = t83 * t120;
        let t160 = e_s0_x * t96 + t157 + e_s1_x * t98;
        let t161 = e_s0_y * t96 + t158 + e_s1_y * t98;
        let t162 = e_s0_z * t96 + t159 + e_s1_z * t98;
        let t163 = e_s0_x * t97;
        let t164 = e_s0_y * t97;
        let t165 = e_s0_z * t97;
        let t166 = e_d_x * t98;
        let t167 = e_d_y * t98;
        let t168 = e_d_z * t98;
        let t169 = t163 + t166 + t92 * t121;
        let t170 = t164 + t167 + t92 * t122;
        let t171 = t165 + t168 + t92 * t123;
        let t172 = e_d_x * t97;
        let t173 = e_d_y * t97;
        let t174 = e_d_z * t97;
        let t175 = t79 * t115 + t172 + e_s1_x * t102;
        let t176 = t79 * t116 + t173 + e_s1_y * t102;
        let t177 = t79 * t117 + t174 + e_s1_z * t102;
        let t178 = t151 + (t163 + t101 * t118);
        let t179 = t152 + (t164 + t101 * t119);
        let t180 = t153 + (t165 + t101 * t120);
        let t181 = t172 + e_s0_x * t102 + t79 * t121;
        let t182 = t173 + e_s0_y * t102 + t79 * t122;
        let t183 = t174 + e_s0_z * t102 + t79 * t123;
        let t184 = e_d_x * t83;
        let t185 = e_d_y * t83;
        let t186 = e_d_z * t83;
        let t187 = t91 * t115 + t184 + e_s1_x * t101;
        let t188 = t91 * t116 + t185 + e_s1_y * t101;
        let t189 = t91 * t117 + t186 + e_s1_z * t101;
        let t190 = e_s0_x * t83 + t86 * t118 + e_s1_x * t83;
        let t191 = e_s0_y * t83 + t86 * t119 + e_s1_y * t83;
        let t192 = e_s0_z * t83 + t86 * t120 + e_s1_z * t83;
        let t193 = t184 + e_s0_x * t101 + t91 * t121;
        let t194 = t185 + e_s0_y * t101 + t91 * t122;
        let t195 = t186 + e_s0_z * t101 + t91 * t123;
        let t196 = t151 + (t166 + t92 * t115);
        let t197 = t152 + (t167 + t92 * t116);
        let t198 = t153 + (t168 + t92 * t117);
        let t199 = t157 + e_s0_x * t98 + e_s1_x * t96;
        let t200 = t158 + e_s0_y * t98 + e_s1_y * t96;
        let t201 = t159 + e_s0_z * t98 + e_s1_z * t96;
        let t202 = t148 + t163 + t78 * t121;
        let t203 = t149 + t164 + t78 * t122;
        let t204 = t150 + t165 + t78 * t123;
        let t205 = t127 + (t142 + t93 * t115);
        let t206 = t128 + (t143 + t93 * t116);
        let t207 = t129 + (t144 + t93 * t117);
        let t208 = t133 + e_s0_x * t92 + e_s1_x * t78;
        let t209 = t134 + e_s0_y * t92 + e_s1_y * t78;
        let t210 = t135 + e_s0_z * t92 + e_s1_z * t78;
        let t211 = t124 + t139 + t77 * t121;
        let t212 = t125 + t140 + t77 * t122;
        let t213 = t126 + t141 + t77 * t123;
        let t214 = stress_dot_s0_s0 * 2.0;
        let t215 = stress_dot_d_d * 2.0;
        let t216 = stress_dot_s1_s1 * 2.0;
        let t217 = inverse_length * inverse_length;
        let t218 = (t46 * t160 + t109 * t190 + t52 * t199 + t215) * t217;
        let t219 = (t46 * t161 + t109 * t191 + t52 * t200) * t217;
        let t220 = (t46 * t162 + t109 * t192 + t52 * t201) * t217;
        let t221 = inverse_length
            * (stress_dot_s0_d + (t46 * t154 + t109 * t187 + t52 * t196));
        let t222 = inverse_length * (t46 * t155 + t109 * t188 + t52 * t197);
        let t223 = inverse_length * (t46 * t156 + t109 * t189 + t52 * t198);
        let t224 = inverse_length
            * (stress_dot_d_s1 + (t46 * t169 + t109 * t193 + t52 * t202));
        let t225 = inverse_length * (t46 * t170 + t109 * t194 + t52 * t203);
        let t226 = inverse_length * (t46 * t171 + t109 * t195 + t52 * t204);
        let t227 = (t47 * t160 + t110 * t190 + t53 * t199) * t217;
        let t228 = (t47 * t161 + t110 * t191 + t53 * t200 + t215) * t217;
        let t229 = (t47 * t162 + t110 * t192 + t53 * t201) * t217;
        let t230 = inverse_length * (t47 * t154 + t110 * t187 + t53 * t196);
        let t231 = inverse_length
            * (stress_dot_s0_d + (t47 * t155 + t110 * t188 + t53 * t197));
        let t232 = inverse_length * (t47 * t156 + t110 * t189 + t53 * t198);
        let t233 = inverse_length * (t47 * t169 + t110 * t193 + t53 * t202);
        let t234 = inverse_length
            * (stress_dot_d_s1 + (t47 * t170 + t110 * t194 + t53 * t203));
        let t235 = inverse_length * (t47 * t171 + t110 * t195 + t53 * t204);
        let t236 = (t48 * t160 + t111 * t190 + t54 * t199) * t217;
        let t237 = (t48 * t161 + t111 * t191 + t54 * t200) * t217;
        let t238 = (t48 * t162 + t111 * t192 + t54 * t201 + t215) * t217;
        let t239 = inverse_length * (t48 * t154 + t111 * t187 + t54 * t196);
        let t240 = inverse_length * (t48 * t155 + t111 * t188 + t54 * t197);
        let t241 = inverse_length
            * (stress_dot_s0_d + (t48 * t156 + t111 * t189 + t54 * t198));
        let t242 = inverse_length * (t48 * t169 + t111 * t193 + t54 * t202);
        let t243 = inverse_length * (t48 * t170 + t111 * t194 + t54 * t203);
        let t244 = inverse_length
            * (stress_dot_d_s1 + (t48 * t171 + t111 * t195 + t54 * t204));
        let t245 = inverse_length
            * (stress_dot_s0_d + (t106 * t136 + t49 * t160 + t52 * t178));
        let t246 = inverse_length * (t106 * t137 + t49 * t161 + t52 * t179);
        let t247 = inverse_length * (t106 * t138 + t49 * t162 + t52 * t180);
        let t248 = inverse_length * (t107 * t136 + t50 * t160 + t53 * t178);
        let t249 = inverse_length
            * (stress_dot_s0_d + (t107 * t137 + t50 * t161 + t53 * t179));
        let t250 = inverse_length * (t107 * t138 + t50 * t162 + t53 * t180);
        let t251 = inverse_length * (t108 * t136 + t51 * t160 + t54 * t178);
        let t252 = inverse_length * (t108 * t137 + t51 * t161 + t54 * t179);
        let t253 = inverse_length
            * (stress_dot_s0_d + (t108 * t138 + t51 * t162 + t54 * t180));
        let t254 = inverse_length
            * (stress_dot_d_s1 + (t46 * t178 + t49 * t199 + t112 * t208));
        let t255 = inverse_length * (t46 * t179 + t49 * t200 + t112 * t209);
        let t256 = inverse_length * (t46 * t180 + t49 * t201 + t112 * t210);
        let t257 = inverse_length * (t47 * t178 + t50 * t199 + t113 * t208);
        let t258 = inverse_length
            * (stress_dot_d_s1 + (t47 * t179 + t50 * t200 + t113 * t209));
        let t259 = inverse_length * (t47 * t180 + t50 * t201 + t113 * t210);
        let t260 = inverse_length * (t48 * t178 + t51 * t199 + t114 * t208);
        let t261 = inverse_length * (t48 * t179 + t51 * t200 + t114 * t209);
        let t262 = inverse_length
            * (stress_dot_d_s1 + (t48 * t180 + t51 * t201 + t114 * t210));
        stiffness[0] += t218;
        stiffness[1] += t219;
        stiffness[2] += t220;
        stiffness[3] -= t221;
        stiffness[4] -= t222;
        stiffness[5] -= t223;
        stiffness[6] -= t218;
        stiffness[7] -= t219;
        stiffness[8] -= t220;
        stiffness[9] -= t224;
        stiffness[10] -= t225;
        stiffness[11] -= t226;
        stiffness[12] += t227;
        stiffness[13] += t228;
        stiffness[14] += t229;
        stiffness[15] -= t230;
        stiffness[16] -= t231;
        stiffness[17] -= t232;
        stiffness[18] -= t227;
        stiffness[19] -= t228;
        stiffness[20] -= t229;
        stiffness[21] -= t233;
        stiffness[22] -= t234;
        stiffness[23] -= t235;
        stiffness[24] += t236;
        stiffness[25] += t237;
        stiffness[26] += t238;
        stiffness[27] -= t239;
        stiffness[28] -= t240;
        stiffness[29] -= t241;
        stiffness[30] -= t236;
        stiffness[31] -= t237;
        stiffness[32] -= t238;
        stiffness[33] -= t242;
        stiffness[34] -= t243;
        stiffness[35] -= t244;
        stiffness[36] -= t245;
        stiffness[37] -= t246;
        stiffness[38] -= t247;
        stiffness[39] += t106 * t130 + t49 * t154 + t52 * t175 + t214;
        stiffness[40] += t106 * t131 + t49 * t155 + t52 * t176;
        stiffness[41] += t106 * t132 + t49 * t156 + t52 * t177;
        stiffness[42] += t245;
        stiffness[43] += t246;
        stiffness[44] += t247;
        stiffness[45] += stress_dot_s0_s1 + (t106 * t145 + t49 * t169 + t52 * t181);
        stiffness[46] += t106 * t146 + t49 * t170 + t52 * t182;
        stiffness[47] += t106 * t147 + t49 * t171 + t52 * t183;
        stiffness[48] -= t248;
        stiffness[49] -= t249;
        stiffness[50] -= t250;
        stiffness[51] += t107 * t130 + t50 * t154 + t53 * t175;
        stiffness[52] += t107 * t131 + t50 * t155 + t53 * t176 + t214;
        stiffness[53] += t107 * t132 + t50 * t156 + t53 * t177;
        stiffness[54] += t248;
        stiffness[55] += t249;
        stiffness[56] += t250;
        stiffness[57] += t107 * t145 + t50 * t169 + t53 * t181;
        stiffness[58] += stress_dot_s0_s1 + (t107 * t146 + t50 * t170 + t53 * t182);
        stiffness[59] += t107 * t147 + t50 * t171 + t53 * t183;
        stiffness[60] -= t251;
        stiffness[61] -= t252;
        stiffness[62] -= t253;
        stiffness[63] += t108 * t130 + t51 * t154 + t54 * t175;
        stiffness[64] += t108 * t131 + t51 * t155 + t54 * t176;
        stiffness[65] += t108 * t132 + t51 * t156 + t54 * t177 + t214;
        stiffness[66] += t251;
        stiffness[67] += t252;
        stiffness[68] += t253;
        stiffness[69] += t108 * t145 + t51 * t169 + t54 * t181;
        stiffness[70] += t108 * t146 + t51 * t170 + t54 * t182;
        stiffness[71] += stress_dot_s0_s1 + (t108 * t147 + t51 * t171 + t54 * t183);
        stiffness[72] -= t218;
        stiffness[73] -= t219;
        stiffness[74] -= t220;
        stiffness[75] += t221;
        stiffness[76] += t222;
        stiffness[77] += t223;
        stiffness[78] += t218;
        stiffness[79] += t219;
        stiffness[80] += t220;
        stiffness[81] += t224;
        stiffness[82] += t225;
        stiffness[83] += t226;
        stiffness[84] -= t227;
        stiffness[85] -= t228;
        stiffness[86] -= t229;
        stiffness[87] += t230;
        stiffness[88] += t231;
        stiffness[89] += t232;
        stiffness[90] += t227;
        stiffness[91] += t228;
        stiffness[92] += t229;
        stiffness[93] += t233;
        stiffness[94] += t234;
        stiffness[95] += t235;
        stiffness[96] -= t236;
        stiffness[97] -= t237;
        stiffness[98] -= t238;
        stiffness[99] += t239;
        stiffness[100] += t240;
        stiffness[101] += t241;
        stiffness[102] += t236;
        stiffness[103] += t237;
        stiffness[104] += t238;
        stiffness[105] += t242;
        stiffness[106] += t243;
        stiffness[107] += t244;
        stiffness[108] -= t254;
        stiffness[109] -= t255;
        stiffness[110] -= t256;
        stiffness[111] += stress_dot_s0_s1 + (t46 * t175 + t49 * t196 + t112 * t205);
        stiffness[112] += t46 * t176 + t49 * t197 + t112 * t206;
        stiffness[113] += t46 * t177 + t49 * t198 + t112 * t207;
        stiffness[114] += t254;
        stiffness[115] += t255;
        stiffness[116] += t256;
        stiffness[117] += t46 * t181 + t49 * t202 + t112 * t211 + t216;
        stiffness[118] += t46 * t182 + t49 * t203 + t112 * t212;
        stiffness[119] += t46 * t183 + t49 * t204 + t112 * t213;
        stiffness[120] -= t257;
        stiffness[121] -= t258;
        stiffness[122] -= t259;
        stiffness[123] += t47 * t175 + t50 * t196 + t113 * t205;
        stiffness[124] += stress_dot_s0_s1 + (t47 * t176 + t50 * t197 + t113 * t206);
        stiffness[125] += t47 * t177 + t50 * t198 + t113 * t207;
        stiffness[126] += t257;
        stiffness[127] += t258;
        stiffness[128] += t259;
        stiffness[129] += t47 * t181 + t50 * t202 + t113 * t211;
        stiffness[130] += t47 * t182 + t50 * t203 + t113 * t212 + t216;
        stiffness[131] += t47 * t183 + t50 * t204 + t113 * t213;
        stiffness[132] -= t260;
        stiffness[133] -= t261;
        stiffness[134] -= t262;
        stiffness[135] += t48 * t175 + t51 * t196 + t114 * t205;
        stiffness[136] += t48 * t176 + t51 * t197 + t114 * t206;
        stiffness[137] += stress_dot_s0_s1 + (t48 * t177 + t51 * t198 + t114 * t207);
        stiffness[138] += t260;
        stiffness[139] += t261;
        stiffness[140] += t262;
        stiffness[141] += t48 * t181 + t51 * t202 + t114 * t211;
        stiffness[142] += t48 * t182 + t51 * t203 + t114 * t212;
        stiffness[143] += t48 * t183 + t51 * t204 + t114 * t213 + t216;
    }
    /// Free frame `f`: its start relative to its parent, and its rigid parts.
    ///
    /// Frame of the cable: it follows the chord, which no quick bending turns.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_f(model: &FreeFlight, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 0.3;
        spec.position[1] = -0.2;
        spec.position[2] = 0.5;
        spec.velocity[0] = -3.0;
        spec.velocity[1] = 1.0;
        spec.velocity[2] = 2.0;
        spec.spin[0] = model.roll;
        spec.spin[1] = model.pitch;
        spec.spin[2] = model.yaw;
        spec.angle = 0.6981317007977318;
        spec.axis[0] = 0.408248290463863;
        spec.axis[1] = 0.816496580927726;
        spec.axis[2] = -0.408248290463863;
    }
    /// Start of body `cable` at the arclength x (m): position (m) and velocity (m/s) in its frame, each with its derivative by x.
    ///
    /// Operations: 1 additions, 6 multiplications, 2 divisions, 2 function calls.
    pub fn initial_cable(
        model: &FreeFlight,
        x: f64,
        position: &mut [[f64; 3]; 2],
        velocity: &mut [[f64; 3]; 2],
    ) {
        let t14 = x / model.radius;
        let t15 = t14.sin();
        let t16 = t14.cos();
        let t17 = 1.0 / model.radius;
        position[0][0] = model.radius * t15;
        position[0][1] = model.radius * (1.0 - t16);
        position[1][0] = model.radius * (t16 * t17);
        position[1][1] = model.radius * (t15 * t17);
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 5 additions, 3 multiplications, 1 function calls.
    pub fn outputs(model: &FreeFlight, t: f64, observed: &[f64], out: &mut [f64]) {
        let t24 = ((observed[6] - observed[7]).powi(2)
            + (observed[8] - observed[9]).powi(2)
            + (observed[10] - observed[11]).powi(2))
            .sqrt();
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
        out[4] = observed[4];
        out[5] = observed[5];
        out[6] = t24;
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &FreeFlight, run: &mut ::rncf::RunDefaults) {
        run.t_end = 2.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: FreeFlight,
        pub row_cable: CableSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &FreeFlight) -> Self {
            Self {
                model: model.clone(),
                row_cable: Default::default(),
            }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
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
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            7
        }
        fn frame_count(&self) -> usize {
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "f"][frame]
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
            None
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            ::rncf::emitted::non_negative(
                "fixture `tip`",
                "mass",
                model.tip_mass,
                "kg",
            )?;
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
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
            ]);
            free_f(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                },
            ])
        }
    }
    impl ::rncf::emitted::Bodies for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::emitted::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::BodySpec {
                    name: "cable",
                    kind: 0,
                    instance: None,
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [2.0, 0.0, 0.0],
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
                "material `soft`",
                "density",
                1500.0,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `soft`",
                "young",
                400000.0,
                "Pa",
            )?;
            let area = ::rncf::emitted::positive(
                "section `flat`",
                "area",
                0.001,
                "m^2",
            )?;
            let second_moment = ::rncf::emitted::positive(
                "section `flat`",
                "second_moment",
                5e-6,
                "m^4",
            )?;
            self.row_cable = CableSpatial {
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
            let mut position = [[0.0; 3]; 2];
            let mut velocity = [[0.0; 3]; 2];
            match body {
                0 => {
                    initial_cable(&self.model, x, &mut position, &mut velocity);
                    [Some(position), None]
                }
                _ => [None, None],
            }
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
                    name: "tip",
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    constants: [
                        model.tip_mass,
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
                    elastic: false,
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
            cable_spatial_mass(&self.row_cable, ::rncf::emitted::array_mut(mass));
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
                &self.row_cable,
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
                &self.row_cable,
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
                rows: [&self.row_cable; 4],
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
                rows: [&self.row_cable; 4],
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
                &self.row_cable,
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
                        self.row_cable.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    cable_spatial_shapes_position_1(
                        self.row_cable.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 2) => {
                    cable_spatial_shapes_position_2(
                        self.row_cable.length,
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
                area: 0.001,
                second_moments: [5e-6, 5e-6],
                torsion_constant: 0.0,
                young_over_shear: 0.0,
                softness_of_curves: 4.0,
                yield_stress: None,
                material: "soft",
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
                &self.row_cable,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array_mut(forces),
            );
        }
    }
    impl ::rncf::emitted::ConservingForces for Equations {
        fn conserving_force(
            &self,
            body: usize,
            element: usize,
            start: &[f64],
            end: &[f64],
            force: &mut [f64],
        ) {
            cable_spatial_conserving_force(
                &self.row_cable,
                ::rncf::emitted::array(start),
                ::rncf::emitted::array(end),
                ::rncf::emitted::array_mut(force),
            );
        }
        fn conserving_tangent(
            &self,
            body: usize,
            element: usize,
            start: &[f64],
            end: &[f64],
            stiffness: &mut [f64],
        ) {
            cable_spatial_conserving_tangent(
                &self.row_cable,
                ::rncf::emitted::array(start),
                ::rncf::emitted::array(end),
                ::rncf::emitted::array_mut(stiffness),
            );
        }
    }
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::WithoutJointConditions for Equations {}
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
