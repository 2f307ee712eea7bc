//! Expansion of `models/src/free_flight.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// A soft cable that flies and tumbles freely with a mass at its end: nothing acts on it, so that energy, momentum and
/// angular momentum stay.
#[derive(Clone, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct FreeFlight {
    /// Number of elements. (count)
    pub elements: usize,
    /// Mass at the end. (SI; declared in kg)
    pub tip_mass: f64,
    /// Radius of the arc that the cable starts in. (SI; declared in m)
    pub radius: f64,
    /// Initial angular velocity about the tangent at the cable's start: it keeps the cable bent, as the frame needs. (SI; declared in rad/s)
    pub roll: f64,
    /// Initial angular velocity in the plane of the arc, across the tangent. (SI; declared in rad/s)
    pub pitch: f64,
    /// Initial angular velocity about the normal of the arc. (SI; declared in rad/s)
    pub yaw: f64,
}
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
    /// Initial angular velocity about the tangent at the cable's start: it keeps the cable bent, as the frame needs.
    param roll = 4 rad/s;
    /// Initial angular velocity in the plane of the arc, across the tangent.
    param pitch = -1 rad/s;
    /// Initial angular velocity about the normal of the arc.
    param yaw = 1 rad/s;

    // EA = 400 N, EI = 2 N m^2 and 1.5 kg/m.
    material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
    section flat { area = 10 cm^2; second_moment = 500 cm^4; }

    /// Frame of the cable.
    frame f = free(
        origin = [0.3, -0.2, 0.5] m, axis = [1, 2, -1], angle = 40 deg,
        velocity = [-3, 1, 2] m/s, angular_velocity = [roll, pitch, yaw]
    );
    body cable in f {
        spatial;
        line from [0, 0, 0] m to [2, 0, 0] m;
        mesh elements * cable(flat, soft);
        initial position [radius * sin(x / radius), radius * (1 - cos(x / radius)), 0];
    }
    // Six ties of the frame to the cable: five at its start; the sixth, the spin about the cable's axis, by the end,
    // which stays in the frame's xy plane.
    joint root = clamp(cable.start, f);
    joint twist = hold(cable.end.z);
    fixture tip on cable.end { mass = tip_mass; }

    /// Start of the cable in space.
    output start = cable.start.in(inertial);
    /// End of the cable in space.
    output end = cable.end.in(inertial);
    /// Distance between the ends.
    output span = norm(cable.end.position - cable.start.position);

    run { t_end = 2 s; every = 0.01 s; }
}"#;
    const NOTES: &'static [&'static str] = &[
        "Body `cable` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `cable` moves in the free frame `f`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Frame `f` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Constraint `root` (clamp in absolute coordinates): 5 multipliers; gradient and second derivatives are derived.",
        "Constraint `twist` (hold in absolute coordinates): 1 multiplier; gradient and second derivatives are derived.",
        "Fixture `tip` adds constants to the inertia of `cable` and no unknowns.",
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
                doc: "Initial angular velocity about the tangent at the cable's start: it keeps the cable bent, as the frame needs.",
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
                components: &["x", "y", "z"],
                doc: "Start of the cable in space.",
            },
            ::rncf::Output {
                name: "end",
                unit: "m",
                components: &["x", "y", "z"],
                doc: "End of the cable in space.",
            },
            ::rncf::Output {
                name: "span",
                unit: "m",
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
        };
        free_flight_equations::run_defaults(self, &mut run);
        run
    }
    fn build(
        &self,
        formulation: ::rncf::Formulation,
        joints: ::rncf::Joints,
    ) -> ::std::result::Result<
        ::std::boxed::Box<dyn ::rncf::Scene>,
        ::rncf::ModelError,
    > {
        ::rncf::mesh::check_params(self)?;
        let equations = free_flight_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
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
        /// Damping of the strain measures, s.
        pub damping: T,
    }
    impl CableSpatial {
        /// The constants of four elements side by side.
        #[inline(always)]
        pub fn side_by_side<L: ::rncf::lanes::Lanes>(
            rows: [&Self; 4],
            lanes: L,
        ) -> CableSpatial<L::Real> {
            CableSpatial {
                length: lanes.load(rows.map(|row| row.length)),
                EA: lanes.load(rows.map(|row| row.EA)),
                EI: lanes.load(rows.map(|row| row.EI)),
                rhoA: lanes.load(rows.map(|row| row.rhoA)),
                damping: lanes.load(rows.map(|row| row.damping)),
            }
        }
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 98 additions, 118 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_force<T: ::rncf::lanes::Real>(
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
        let t44 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t45 = strain_dot_d_d * 0.02142857142857143;
        let t46 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t44 + t45
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t47 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t48 = strain_dot_d_d * (-0.12857142857142856);
        let t49 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t50 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t51 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t52 = t45
            + (t44
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t53 = inverse_length * EI;
        let t54 = dot_d_d * 3.6;
        let stress_dot_s0_s0 = t43 * t46
            + t53 * (t54 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6);
        let t56 = dot_s0_s1 * 2.2;
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * 0.0035714285714285713
                + strain_dot_s0_d * 0.08571428571428572 + t47 + t48 + t49)
            + t53 * (dot_s0_d * (-7.2) + t56 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2));
        let t58 = dot_s0_s1 * (-1.2);
        let stress_dot_s0_s1 = t43
            * (t49
                + (t50 + strain_dot_s0_d * (-0.007142857142857143)
                    + strain_dot_s0_s1 * 0.004761904761904762
                    + strain_dot_d_s1 * (-0.007142857142857143)))
            + t53 * (dot_s0_d * 2.2 + t58 + dot_d_d * (-1.2) + dot_d_s1 * 2.2);
        let stress_dot_d_d = t43 * t51 + t53 * (t58 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6);
        let stress_dot_d_s1 = t43
            * (t48 + (t47 + t50) + strain_dot_d_s1 * 0.08571428571428572
                + strain_dot_s1_s1 * 0.0035714285714285713)
            + t53 * (t56 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2));
        let stress_dot_s1_s1 = t43 * t52
            + t53 * (t54 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2)));
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
    impl ::rncf::lanes::Kernel for CableSpatialElasticForce<'_> {
        #[inline(always)]
        fn run<L: ::rncf::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, force } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_force(&row, &q, force);
        }
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 410 additions, 370 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_tangent<T: ::rncf::lanes::Real>(
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
        let t44 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t45 = strain_dot_d_d * 0.02142857142857143;
        let t46 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t44 + t45
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t47 = t43 * 0.014285714285714285;
        let t48 = t43 * 0.0035714285714285713;
        let t49 = t43 * (-0.0035714285714285713);
        let t50 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t51 = strain_dot_d_d * (-0.12857142857142856);
        let t52 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t53 = t43 * (-0.12857142857142856);
        let t54 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t55 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t56 = t43 * 0.5142857142857142;
        let t57 = t45
            + (t44
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t58 = inverse_length * EI;
        let t59 = dot_d_d * 3.6;
        let stress_dot_s0_s0 = t43 * t46
            + t58 * (t59 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6);
        let t61 = t43 * 0.02142857142857143 + t58 * 3.6;
        let t62 = t49 + t58 * (-2.2);
        let t63 = t43 * 0.0011904761904761906 + t58 * 0.6;
        let t64 = dot_s0_s1 * 2.2;
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * 0.0035714285714285713
                + strain_dot_s0_d * 0.08571428571428572 + t50 + t51 + t52)
            + t58 * (dot_s0_d * (-7.2) + t64 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2));
        let t66 = t43 * 0.08571428571428572 + t58 * (-7.2);
        let t67 = t43 * (-0.007142857142857143) + t58 * 2.2;
        let t68 = t58 * 1.2;
        let t69 = dot_s0_s1 * (-1.2);
        let stress_dot_s0_s1 = t43
            * (t52
                + (t54 + strain_dot_s0_d * (-0.007142857142857143)
                    + strain_dot_s0_s1 * 0.004761904761904762
                    + strain_dot_d_s1 * (-0.007142857142857143)))
            + t58 * (dot_s0_d * 2.2 + t69 + dot_d_d * (-1.2) + dot_d_s1 * 2.2);
        let t71 = t58 * (-1.2);
        let t72 = t43 * 0.004761904761904762 + t71;
        let stress_dot_d_d = t43 * t55 + t58 * (t69 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6);
        let stress_dot_d_s1 = t43
            * (t51 + (t50 + t54) + strain_dot_d_s1 * 0.08571428571428572
                + strain_dot_s1_s1 * 0.0035714285714285713)
            + t58 * (t64 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2));
        let stress_dot_s1_s1 = t43 * t57
            + t58 * (t59 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2)));
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
    impl ::rncf::lanes::Kernel for CableSpatialElasticTangent<'_> {
        #[inline(always)]
        fn run<L: ::rncf::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, stiffness } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_tangent(&row, &q, stiffness);
        }
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial.
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
        let t44 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t45 = strain_dot_d_d * 0.02142857142857143;
        let t46 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t44 + t45
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t47 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t48 = strain_dot_d_d * (-0.12857142857142856);
        let t49 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t50 = t43 * (strain_dot_s0_s0 * t46)
            + t43
                * (strain_dot_s0_d
                    * (strain_dot_s0_s0 * 0.0035714285714285713
                        + strain_dot_s0_d * 0.08571428571428572 + t47 + t48 + t49));
        let t51 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t52 = t43
            * (strain_dot_s0_s1
                * (t49
                    + (t51 + strain_dot_s0_d * (-0.007142857142857143)
                        + strain_dot_s0_s1 * 0.004761904761904762
                        + strain_dot_d_s1 * (-0.007142857142857143))));
        let t53 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t54 = t50 + t52 + t43 * (strain_dot_d_d * t53)
            + t43
                * (strain_dot_d_s1
                    * (t48 + (t47 + t51) + strain_dot_d_s1 * 0.08571428571428572
                        + strain_dot_s1_s1 * 0.0035714285714285713));
        let t55 = t45
            + (t44
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t56 = 0.5 * (inverse_length * EI);
        let t57 = dot_d_d * 3.6;
        let t58 = t54 + t43 * (strain_dot_s1_s1 * t55)
            + t56 * (dot_s0_s0 * (t57 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6));
        let t59 = dot_s0_s1 * 2.2;
        let t60 = t58
            + t56
                * (dot_s0_d
                    * (dot_s0_d * (-7.2) + t59 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2)));
        let t61 = dot_s0_s1 * (-1.2);
        let t62 = t60
            + t56
                * (dot_s0_s1
                    * (dot_s0_d * 2.2 + t61 + dot_d_d * (-1.2) + dot_d_s1 * 2.2));
        let t63 = t62 + t56 * (dot_d_d * (t61 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6))
            + t56
                * (dot_d_s1
                    * (t59 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2)));
        *energy
            += t63 + t56 * (dot_s1_s1 * (t57 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2))));
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_spatial_mass(row: &CableSpatial, mass: &mut [f64; 16]) {
        let CableSpatial { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t16 * (-0.030952380952380953);
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * 0.009523809523809525;
        let mass_s0_r1 = t16 * 0.030952380952380953;
        let mass_s0_s1 = t20 * (-0.007142857142857143);
        let mass_r1_s1 = t16 * (-0.05238095238095238);
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
    /// Adds the inertia forces of one element in a moving frame (Eq. 13): relative, Coriolis, Euler and centrifugal acceleration, the frame's acceleration and gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 138 additions, 168 multiplications.
    pub fn cable_spatial_inertia_force(
        row: &CableSpatial,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatial { length, rhoA, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let element_mass = length * rhoA;
        let t60 = r0_z * w_y - r0_y * w_z;
        let t61 = r0_x * w_z - r0_z * w_x;
        let t62 = r0_y * w_x - r0_x * w_y;
        let t63 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + (v_r0_z * w_y - v_r0_y * w_z) * 2.0);
        let t64 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + (v_r0_x * w_z - v_r0_z * w_x) * 2.0);
        let t65 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + (v_r0_y * w_x - v_r0_x * w_y) * 2.0);
        let total_r0_x = e_x + (w_y * t62 - w_z * t61 + t63);
        let total_r0_y = e_y + (w_z * t60 - w_x * t62 + t64);
        let total_r0_z = e_z + (w_x * t61 - w_y * t60 + t65);
        let t69 = s0_z * w_y - s0_y * w_z;
        let t70 = s0_x * w_z - s0_z * w_x;
        let t71 = s0_y * w_x - s0_x * w_y;
        let t72 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t73 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t74 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let total_s0_x = w_y * t71 - w_z * t70 + t72;
        let total_s0_y = w_z * t69 - w_x * t71 + t73;
        let total_s0_z = w_x * t70 - w_y * t69 + t74;
        let t78 = r1_z * w_y - r1_y * w_z;
        let t79 = r1_x * w_z - r1_z * w_x;
        let t80 = r1_y * w_x - r1_x * w_y;
        let t81 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t82 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t83 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let total_r1_x = e_x + (w_y * t80 - w_z * t79 + t81);
        let total_r1_y = e_y + (w_z * t78 - w_x * t80 + t82);
        let total_r1_z = e_z + (w_x * t79 - w_y * t78 + t83);
        let t87 = s1_z * w_y - s1_y * w_z;
        let t88 = s1_x * w_z - s1_z * w_x;
        let t89 = s1_y * w_x - s1_x * w_y;
        let t90 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t91 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t92 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let total_s1_x = w_y * t89 - w_z * t88 + t90;
        let total_s1_y = w_z * t87 - w_x * t89 + t91;
        let total_s1_z = w_x * t88 - w_y * t87 + t92;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t97 = length * element_mass;
        let mass_r0_s0 = t97 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t97 * (-0.030952380952380953);
        let t101 = element_mass * (length * length);
        let mass_s0_s0 = t101 * 0.009523809523809525;
        let mass_s0_r1 = t97 * 0.030952380952380953;
        let mass_s0_s1 = t101 * (-0.007142857142857143);
        let mass_r1_s1 = t97 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + total_s0_x * mass_r0_s0
                + total_r1_x * mass_r0_r1 + total_s1_x * mass_r0_s1;
        force[1]
            += total_r0_y * mass_r0_r0 + total_s0_y * mass_r0_s0
                + total_r1_y * mass_r0_r1 + total_s1_y * mass_r0_s1;
        force[2]
            += total_r0_z * mass_r0_r0 + total_s0_z * mass_r0_s0
                + total_r1_z * mass_r0_r1 + total_s1_z * mass_r0_s1;
        force[3]
            += total_r0_x * mass_r0_s0 + total_s0_x * mass_s0_s0
                + total_r1_x * mass_s0_r1 + total_s1_x * mass_s0_s1;
        force[4]
            += total_r0_y * mass_r0_s0 + total_s0_y * mass_s0_s0
                + total_r1_y * mass_s0_r1 + total_s1_y * mass_s0_s1;
        force[5]
            += total_r0_z * mass_r0_s0 + total_s0_z * mass_s0_s0
                + total_r1_z * mass_s0_r1 + total_s1_z * mass_s0_s1;
        force[6]
            += total_r0_x * mass_r0_r1 + total_s0_x * mass_s0_r1
                + total_r1_x * mass_r0_r0 + total_s1_x * mass_r1_s1;
        force[7]
            += total_r0_y * mass_r0_r1 + total_s0_y * mass_s0_r1
                + total_r1_y * mass_r0_r0 + total_s1_y * mass_r1_s1;
        force[8]
            += total_r0_z * mass_r0_r1 + total_s0_z * mass_s0_r1
                + total_r1_z * mass_r0_r0 + total_s1_z * mass_r1_s1;
        force[9]
            += total_r0_x * mass_r0_s1 + total_s0_x * mass_s0_s1
                + total_r1_x * mass_r1_s1 + total_s1_x * mass_s0_s0;
        force[10]
            += total_r0_y * mass_r0_s1 + total_s0_y * mass_s0_s1
                + total_r1_y * mass_r1_s1 + total_s1_y * mass_s0_s0;
        force[11]
            += total_r0_z * mass_r0_s1 + total_s0_z * mass_s0_s1
                + total_r1_z * mass_r1_s1 + total_s1_z * mass_s0_s0;
    }
    /// Adds the derivatives of the inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 297 additions, 117 multiplications.
    pub fn cable_spatial_inertia_tangent(
        row: &CableSpatial,
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 144],
        damping_matrix: &mut [f64; 144],
    ) {
        let CableSpatial { length, rhoA, .. } = *row;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t22 = length * element_mass;
        let mass_r0_s0 = t22 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t22 * (-0.030952380952380953);
        let t26 = element_mass * (length * length);
        let mass_s0_s0 = t26 * 0.009523809523809525;
        let mass_s0_r1 = t22 * 0.030952380952380953;
        let mass_s0_s1 = t26 * (-0.007142857142857143);
        let mass_r1_s1 = t22 * (-0.05238095238095238);
        let t31 = w_y * w_y;
        let t32 = w_z * w_z;
        let t33 = t31 + t32;
        let t34 = -mass_r0_r0 * t33;
        let t35 = w_x * w_y;
        let t36 = t35 - dw_z;
        let t37 = mass_r0_r0 * t36;
        let t38 = w_x * w_z;
        let t39 = dw_y + t38;
        let t40 = mass_r0_r0 * t39;
        let t41 = -mass_r0_s0 * t33;
        let t42 = mass_r0_s0 * t36;
        let t43 = mass_r0_s0 * t39;
        let t44 = -mass_r0_r1 * t33;
        let t45 = mass_r0_r1 * t36;
        let t46 = mass_r0_r1 * t39;
        let t47 = -mass_r0_s1 * t33;
        let t48 = mass_r0_s1 * t36;
        let t49 = mass_r0_s1 * t39;
        let t50 = dw_z + t35;
        let t51 = mass_r0_r0 * t50;
        let t52 = w_x * w_x;
        let t53 = t32 + t52;
        let t54 = -mass_r0_r0 * t53;
        let t55 = w_y * w_z;
        let t56 = t55 - dw_x;
        let t57 = mass_r0_r0 * t56;
        let t58 = mass_r0_s0 * t50;
        let t59 = -mass_r0_s0 * t53;
        let t60 = mass_r0_s0 * t56;
        let t61 = mass_r0_r1 * t50;
        let t62 = -mass_r0_r1 * t53;
        let t63 = mass_r0_r1 * t56;
        let t64 = mass_r0_s1 * t50;
        let t65 = -mass_r0_s1 * t53;
        let t66 = mass_r0_s1 * t56;
        let t67 = t38 - dw_y;
        let t68 = mass_r0_r0 * t67;
        let t69 = dw_x + t55;
        let t70 = mass_r0_r0 * t69;
        let t71 = t31 + t52;
        let t72 = -mass_r0_r0 * t71;
        let t73 = mass_r0_s0 * t67;
        let t74 = mass_r0_s0 * t69;
        let t75 = -mass_r0_s0 * t71;
        let t76 = mass_r0_r1 * t67;
        let t77 = mass_r0_r1 * t69;
        let t78 = -mass_r0_r1 * t71;
        let t79 = mass_r0_s1 * t67;
        let t80 = mass_r0_s1 * t69;
        let t81 = -mass_r0_s1 * t71;
        let t82 = -mass_s0_s0 * t33;
        let t83 = mass_s0_s0 * t36;
        let t84 = mass_s0_s0 * t39;
        let t85 = -mass_s0_r1 * t33;
        let t86 = mass_s0_r1 * t36;
        let t87 = mass_s0_r1 * t39;
        let t88 = -mass_s0_s1 * t33;
        let t89 = mass_s0_s1 * t36;
        let t90 = mass_s0_s1 * t39;
        let t91 = mass_s0_s0 * t50;
        let t92 = -mass_s0_s0 * t53;
        let t93 = mass_s0_s0 * t56;
        let t94 = mass_s0_r1 * t50;
        let t95 = -mass_s0_r1 * t53;
        let t96 = mass_s0_r1 * t56;
        let t97 = mass_s0_s1 * t50;
        let t98 = -mass_s0_s1 * t53;
        let t99 = mass_s0_s1 * t56;
        let t100 = mass_s0_s0 * t67;
        let t101 = mass_s0_s0 * t69;
        let t102 = -mass_s0_s0 * t71;
        let t103 = mass_s0_r1 * t67;
        let t104 = mass_s0_r1 * t69;
        let t105 = -mass_s0_r1 * t71;
        let t106 = mass_s0_s1 * t67;
        let t107 = mass_s0_s1 * t69;
        let t108 = -mass_s0_s1 * t71;
        let t109 = -mass_r1_s1 * t33;
        let t110 = mass_r1_s1 * t36;
        let t111 = mass_r1_s1 * t39;
        let t112 = mass_r1_s1 * t50;
        let t113 = -mass_r1_s1 * t53;
        let t114 = mass_r1_s1 * t56;
        let t115 = mass_r1_s1 * t67;
        let t116 = mass_r1_s1 * t69;
        let t117 = -mass_r1_s1 * t71;
        let t118 = w_z * 2.0;
        let t119 = mass_r0_r0 * t118;
        let t120 = w_y * 2.0;
        let t121 = mass_r0_r0 * t120;
        let t122 = mass_r0_s0 * t118;
        let t123 = mass_r0_s0 * t120;
        let t124 = mass_r0_r1 * t118;
        let t125 = mass_r0_r1 * t120;
        let t126 = mass_r0_s1 * t118;
        let t127 = mass_r0_s1 * t120;
        let t128 = w_x * 2.0;
        let t129 = mass_r0_r0 * t128;
        let t130 = mass_r0_s0 * t128;
        let t131 = mass_r0_r1 * t128;
        let t132 = mass_r0_s1 * t128;
        let t133 = mass_s0_s0 * t118;
        let t134 = mass_s0_s0 * t120;
        let t135 = mass_s0_r1 * t118;
        let t136 = mass_s0_r1 * t120;
        let t137 = mass_s0_s1 * t118;
        let t138 = mass_s0_s1 * t120;
        let t139 = mass_s0_s0 * t128;
        let t140 = mass_s0_r1 * t128;
        let t141 = mass_s0_s1 * t128;
        let t142 = mass_r1_s1 * t118;
        let t143 = mass_r1_s1 * t120;
        let t144 = mass_r1_s1 * t128;
        stiffness[0] += t34;
        stiffness[1] += t37;
        stiffness[2] += t40;
        stiffness[3] += t41;
        stiffness[4] += t42;
        stiffness[5] += t43;
        stiffness[6] += t44;
        stiffness[7] += t45;
        stiffness[8] += t46;
        stiffness[9] += t47;
        stiffness[10] += t48;
        stiffness[11] += t49;
        stiffness[12] += t51;
        stiffness[13] += t54;
        stiffness[14] += t57;
        stiffness[15] += t58;
        stiffness[16] += t59;
        stiffness[17] += t60;
        stiffness[18] += t61;
        stiffness[19] += t62;
        stiffness[20] += t63;
        stiffness[21] += t64;
        stiffness[22] += t65;
        stiffness[23] += t66;
        stiffness[24] += t68;
        stiffness[25] += t70;
        stiffness[26] += t72;
        stiffness[27] += t73;
        stiffness[28] += t74;
        stiffness[29] += t75;
        stiffness[30] += t76;
        stiffness[31] += t77;
        stiffness[32] += t78;
        stiffness[33] += t79;
        stiffness[34] += t80;
        stiffness[35] += t81;
        stiffness[36] += t41;
        stiffness[37] += t42;
        stiffness[38] += t43;
        stiffness[39] += t82;
        stiffness[40] += t83;
        stiffness[41] += t84;
        stiffness[42] += t85;
        stiffness[43] += t86;
        stiffness[44] += t87;
        stiffness[45] += t88;
        stiffness[46] += t89;
        stiffness[47] += t90;
        stiffness[48] += t58;
        stiffness[49] += t59;
        stiffness[50] += t60;
        stiffness[51] += t91;
        stiffness[52] += t92;
        stiffness[53] += t93;
        stiffness[54] += t94;
        stiffness[55] += t95;
        stiffness[56] += t96;
        stiffness[57] += t97;
        stiffness[58] += t98;
        stiffness[59] += t99;
        stiffness[60] += t73;
        stiffness[61] += t74;
        stiffness[62] += t75;
        stiffness[63] += t100;
        stiffness[64] += t101;
        stiffness[65] += t102;
        stiffness[66] += t103;
        stiffness[67] += t104;
        stiffness[68] += t105;
        stiffness[69] += t106;
        stiffness[70] += t107;
        stiffness[71] += t108;
        stiffness[72] += t44;
        stiffness[73] += t45;
        stiffness[74] += t46;
        stiffness[75] += t85;
        stiffness[76] += t86;
        stiffness[77] += t87;
        stiffness[78] += t34;
        stiffness[79] += t37;
        stiffness[80] += t40;
        stiffness[81] += t109;
        stiffness[82] += t110;
        stiffness[83] += t111;
        stiffness[84] += t61;
        stiffness[85] += t62;
        stiffness[86] += t63;
        stiffness[87] += t94;
        stiffness[88] += t95;
        stiffness[89] += t96;
        stiffness[90] += t51;
        stiffness[91] += t54;
        stiffness[92] += t57;
        stiffness[93] += t112;
        stiffness[94] += t113;
        stiffness[95] += t114;
        stiffness[96] += t76;
        stiffness[97] += t77;
        stiffness[98] += t78;
        stiffness[99] += t103;
        stiffness[100] += t104;
        stiffness[101] += t105;
        stiffness[102] += t68;
        stiffness[103] += t70;
        stiffness[104] += t72;
        stiffness[105] += t115;
        stiffness[106] += t116;
        stiffness[107] += t117;
        stiffness[108] += t47;
        stiffness[109] += t48;
        stiffness[110] += t49;
        stiffness[111] += t88;
        stiffness[112] += t89;
        stiffness[113] += t90;
        stiffness[114] += t109;
        stiffness[115] += t110;
        stiffness[116] += t111;
        stiffness[117] += t82;
        stiffness[118] += t83;
        stiffness[119] += t84;
        stiffness[120] += t64;
        stiffness[121] += t65;
        stiffness[122] += t66;
        stiffness[123] += t97;
        stiffness[124] += t98;
        stiffness[125] += t99;
        stiffness[126] += t112;
        stiffness[127] += t113;
        stiffness[128] += t114;
        stiffness[129] += t91;
        stiffness[130] += t92;
        stiffness[131] += t93;
        stiffness[132] += t79;
        stiffness[133] += t80;
        stiffness[134] += t81;
        stiffness[135] += t106;
        stiffness[136] += t107;
        stiffness[137] += t108;
        stiffness[138] += t115;
        stiffness[139] += t116;
        stiffness[140] += t117;
        stiffness[141] += t100;
        stiffness[142] += t101;
        stiffness[143] += t102;
        damping_matrix[1] -= t119;
        damping_matrix[2] += t121;
        damping_matrix[4] -= t122;
        damping_matrix[5] += t123;
        damping_matrix[7] -= t124;
        damping_matrix[8] += t125;
        damping_matrix[10] -= t126;
        damping_matrix[11] += t127;
        damping_matrix[12] += t119;
        damping_matrix[14] -= t129;
        damping_matrix[15] += t122;
        damping_matrix[17] -= t130;
        damping_matrix[18] += t124;
        damping_matrix[20] -= t131;
        damping_matrix[21] += t126;
        damping_matrix[23] -= t132;
        damping_matrix[24] -= t121;
        damping_matrix[25] += t129;
        damping_matrix[27] -= t123;
        damping_matrix[28] += t130;
        damping_matrix[30] -= t125;
        damping_matrix[31] += t131;
        damping_matrix[33] -= t127;
        damping_matrix[34] += t132;
        damping_matrix[37] -= t122;
        damping_matrix[38] += t123;
        damping_matrix[40] -= t133;
        damping_matrix[41] += t134;
        damping_matrix[43] -= t135;
        damping_matrix[44] += t136;
        damping_matrix[46] -= t137;
        damping_matrix[47] += t138;
        damping_matrix[48] += t122;
        damping_matrix[50] -= t130;
        damping_matrix[51] += t133;
        damping_matrix[53] -= t139;
        damping_matrix[54] += t135;
        damping_matrix[56] -= t140;
        damping_matrix[57] += t137;
        damping_matrix[59] -= t141;
        damping_matrix[60] -= t123;
        damping_matrix[61] += t130;
        damping_matrix[63] -= t134;
        damping_matrix[64] += t139;
        damping_matrix[66] -= t136;
        damping_matrix[67] += t140;
        damping_matrix[69] -= t138;
        damping_matrix[70] += t141;
        damping_matrix[73] -= t124;
        damping_matrix[74] += t125;
        damping_matrix[76] -= t135;
        damping_matrix[77] += t136;
        damping_matrix[79] -= t119;
        damping_matrix[80] += t121;
        damping_matrix[82] -= t142;
        damping_matrix[83] += t143;
        damping_matrix[84] += t124;
        damping_matrix[86] -= t131;
        damping_matrix[87] += t135;
        damping_matrix[89] -= t140;
        damping_matrix[90] += t119;
        damping_matrix[92] -= t129;
        damping_matrix[93] += t142;
        damping_matrix[95] -= t144;
        damping_matrix[96] -= t125;
        damping_matrix[97] += t131;
        damping_matrix[99] -= t136;
        damping_matrix[100] += t140;
        damping_matrix[102] -= t121;
        damping_matrix[103] += t129;
        damping_matrix[105] -= t143;
        damping_matrix[106] += t144;
        damping_matrix[109] -= t126;
        damping_matrix[110] += t127;
        damping_matrix[112] -= t137;
        damping_matrix[113] += t138;
        damping_matrix[115] -= t142;
        damping_matrix[116] += t143;
        damping_matrix[118] -= t133;
        damping_matrix[119] += t134;
        damping_matrix[120] += t126;
        damping_matrix[122] -= t132;
        damping_matrix[123] += t137;
        damping_matrix[125] -= t141;
        damping_matrix[126] += t142;
        damping_matrix[128] -= t144;
        damping_matrix[129] += t133;
        damping_matrix[131] -= t139;
        damping_matrix[132] -= t127;
        damping_matrix[133] += t132;
        damping_matrix[135] -= t138;
        damping_matrix[136] += t141;
        damping_matrix[138] -= t143;
        damping_matrix[139] += t144;
        damping_matrix[141] -= t134;
        damping_matrix[142] += t139;
    }
    /// Adds the inertia forces of one element in the inertial frame; e is minus gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 54 additions, 60 multiplications.
    pub fn cable_spatial_absolute_inertia_force(
        row: &CableSpatial,
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatial { length, rhoA, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let element_mass = length * rhoA;
        let total_r0_x = a_r0_x + e_x;
        let total_r0_y = a_r0_y + e_y;
        let total_r0_z = a_r0_z + e_z;
        let total_r1_x = a_r1_x + e_x;
        let total_r1_y = a_r1_y + e_y;
        let total_r1_z = a_r1_z + e_z;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t37 = length * element_mass;
        let mass_r0_s0 = t37 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t37 * (-0.030952380952380953);
        let t41 = element_mass * (length * length);
        let mass_s0_s0 = t41 * 0.009523809523809525;
        let mass_s0_r1 = t37 * 0.030952380952380953;
        let mass_s0_s1 = t41 * (-0.007142857142857143);
        let mass_r1_s1 = t37 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + a_s0_x * mass_r0_s0 + total_r1_x * mass_r0_r1
                + a_s1_x * mass_r0_s1;
        force[1]
            += total_r0_y * mass_r0_r0 + a_s0_y * mass_r0_s0 + total_r1_y * mass_r0_r1
                + a_s1_y * mass_r0_s1;
        force[2]
            += total_r0_z * mass_r0_r0 + a_s0_z * mass_r0_s0 + total_r1_z * mass_r0_r1
                + a_s1_z * mass_r0_s1;
        force[3]
            += total_r0_x * mass_r0_s0 + a_s0_x * mass_s0_s0 + total_r1_x * mass_s0_r1
                + a_s1_x * mass_s0_s1;
        force[4]
            += total_r0_y * mass_r0_s0 + a_s0_y * mass_s0_s0 + total_r1_y * mass_s0_r1
                + a_s1_y * mass_s0_s1;
        force[5]
            += total_r0_z * mass_r0_s0 + a_s0_z * mass_s0_s0 + total_r1_z * mass_s0_r1
                + a_s1_z * mass_s0_s1;
        force[6]
            += total_r0_x * mass_r0_r1 + a_s0_x * mass_s0_r1 + total_r1_x * mass_r0_r0
                + a_s1_x * mass_r1_s1;
        force[7]
            += total_r0_y * mass_r0_r1 + a_s0_y * mass_s0_r1 + total_r1_y * mass_r0_r0
                + a_s1_y * mass_r1_s1;
        force[8]
            += total_r0_z * mass_r0_r1 + a_s0_z * mass_s0_r1 + total_r1_z * mass_r0_r0
                + a_s1_z * mass_r1_s1;
        force[9]
            += total_r0_x * mass_r0_s1 + a_s0_x * mass_s0_s1 + total_r1_x * mass_r1_s1
                + a_s1_x * mass_s0_s0;
        force[10]
            += total_r0_y * mass_r0_s1 + a_s0_y * mass_s0_s1 + total_r1_y * mass_r1_s1
                + a_s1_y * mass_s0_s0;
        force[11]
            += total_r0_z * mass_r0_s1 + a_s0_z * mass_s0_s1 + total_r1_z * mass_r1_s1
                + a_s1_z * mass_s0_s0;
    }
    /// Adds force and moment about the origin that the inertia of what the frame carries needs, in frame axes (Eqs. 11, 12): F = m e + d_b a_b, T = (d_a q_a) x e + M_ab q_a x a_b, with the accelerations a = q'' + 2 w x q' + w' x q + w x (w x q) and that of the origin minus gravity, e.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 174 additions, 228 multiplications.
    pub fn cable_spatial_carried(
        row: &CableSpatial,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        out: &mut [f64; 6],
    ) {
        let CableSpatial { length, rhoA, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t61 = length * element_mass;
        let mass_r0_s0 = t61 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t61 * (-0.030952380952380953);
        let t65 = element_mass * (length * length);
        let mass_s0_s0 = t65 * 0.009523809523809525;
        let mass_s0_r1 = t61 * 0.030952380952380953;
        let mass_s0_s1 = t65 * (-0.007142857142857143);
        let mass_r1_s1 = t61 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t61 * 0.08333333333333333;
        let moment_s1 = t61 * (-0.08333333333333333);
        let t73 = r0_z * w_y - r0_y * w_z;
        let t74 = r0_x * w_z - r0_z * w_x;
        let t75 = r0_y * w_x - r0_x * w_y;
        let t76 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t77 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t78 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t79 = w_y * t75 - w_z * t74 + t76;
        let t80 = w_z * t73 - w_x * t75 + t77;
        let t81 = w_x * t74 - w_y * t73 + t78;
        let t82 = s0_z * w_y - s0_y * w_z;
        let t83 = s0_x * w_z - s0_z * w_x;
        let t84 = s0_y * w_x - s0_x * w_y;
        let t85 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t86 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t87 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t88 = w_y * t84 - w_z * t83 + t85;
        let t89 = w_z * t82 - w_x * t84 + t86;
        let t90 = w_x * t83 - w_y * t82 + t87;
        let t91 = r1_z * w_y - r1_y * w_z;
        let t92 = r1_x * w_z - r1_z * w_x;
        let t93 = r1_y * w_x - r1_x * w_y;
        let t94 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t95 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t96 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t97 = w_y * t93 - w_z * t92 + t94;
        let t98 = w_z * t91 - w_x * t93 + t95;
        let t99 = w_x * t92 - w_y * t91 + t96;
        let t100 = s1_z * w_y - s1_y * w_z;
        let t101 = s1_x * w_z - s1_z * w_x;
        let t102 = s1_y * w_x - s1_x * w_y;
        let t103 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t104 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t105 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t106 = w_y * t102 - w_z * t101 + t103;
        let t107 = w_z * t100 - w_x * t102 + t104;
        let t108 = w_x * t101 - w_y * t100 + t105;
        let t109 = moment_r0 * t79 + moment_s0 * t88 + moment_r0 * t97 + moment_s1 * t106
            + element_mass * e_x;
        let t110 = moment_r0 * t80 + moment_s0 * t89 + moment_r0 * t98 + moment_s1 * t107
            + element_mass * e_y;
        let t111 = moment_r0 * t81 + moment_s0 * t90 + moment_r0 * t99 + moment_s1 * t108
            + element_mass * e_z;
        let t112 = moment_r0 * r0_x + moment_s0 * s0_x + moment_r0 * r1_x
            + moment_s1 * s1_x;
        let t113 = moment_r0 * r0_y + moment_s0 * s0_y + moment_r0 * r1_y
            + moment_s1 * s1_y;
        let t114 = moment_r0 * r0_z + moment_s0 * s0_z + moment_r0 * r1_z
            + moment_s1 * s1_z;
        let t115 = mass_r0_r0 * r0_x + mass_r0_s0 * s0_x + mass_r0_r1 * r1_x
            + mass_r0_s1 * s1_x;
        let t116 = mass_r0_r0 * r0_y + mass_r0_s0 * s0_y + mass_r0_r1 * r1_y
            + mass_r0_s1 * s1_y;
        let t117 = mass_r0_r0 * r0_z + mass_r0_s0 * s0_z + mass_r0_r1 * r1_z
            + mass_r0_s1 * s1_z;
        let t118 = mass_r0_s0 * r0_x + mass_s0_s0 * s0_x + mass_s0_r1 * r1_x
            + mass_s0_s1 * s1_x;
        let t119 = mass_r0_s0 * r0_y + mass_s0_s0 * s0_y + mass_s0_r1 * r1_y
            + mass_s0_s1 * s1_y;
        let t120 = mass_r0_s0 * r0_z + mass_s0_s0 * s0_z + mass_s0_r1 * r1_z
            + mass_s0_s1 * s1_z;
        let t121 = e_z * t113 - e_y * t114 + (t81 * t116 - t80 * t117)
            + (t90 * t119 - t89 * t120);
        let t122 = e_x * t114 - e_z * t112 + (t79 * t117 - t81 * t115)
            + (t88 * t120 - t90 * t118);
        let t123 = e_y * t112 - e_x * t113 + (t80 * t115 - t79 * t116)
            + (t89 * t118 - t88 * t119);
        let t124 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t125 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t126 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t127 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t128 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t129 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        out[0] += t109;
        out[1] += t110;
        out[2] += t111;
        out[3] += t121 + (t99 * t125 - t98 * t126) + (t108 * t128 - t107 * t129);
        out[4] += t122 + (t97 * t126 - t99 * t124) + (t106 * t129 - t108 * t127);
        out[5] += t123 + (t98 * t124 - t97 * t125) + (t107 * t127 - t106 * t128);
    }
    /// Writes the derivatives of force F and moment T on the frame, rows first (THEORY 2.1): `mass` with respect to e, w', q''; `damping` to w, q'; `stiffness` to q; and of the nodal forces with respect to w, `spin`. Entries that are always zero are left alone.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 507 additions, 597 multiplications.
    pub fn cable_spatial_carried_tangent(
        row: &CableSpatial,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        mass: &mut [f64; 108],
        damping: &mut [f64; 90],
        spin: &mut [f64; 36],
        stiffness: &mut [f64; 72],
    ) {
        let CableSpatial { length, rhoA, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t61 = length * element_mass;
        let mass_r0_s0 = t61 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t61 * (-0.030952380952380953);
        let t65 = element_mass * (length * length);
        let mass_s0_s0 = t65 * 0.009523809523809525;
        let mass_s0_r1 = t61 * 0.030952380952380953;
        let mass_s0_s1 = t65 * (-0.007142857142857143);
        let mass_r1_s1 = t61 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t61 * 0.08333333333333333;
        let moment_s1 = t61 * (-0.08333333333333333);
        let t73 = r0_z * w_y - r0_y * w_z;
        let t74 = r0_x * w_z - r0_z * w_x;
        let t75 = r0_y * w_x - r0_x * w_y;
        let t76 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t77 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t78 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t79 = w_y * t75 - w_z * t74 + t76;
        let t80 = w_z * t73 - w_x * t75 + t77;
        let t81 = w_x * t74 - w_y * t73 + t78;
        let t82 = s0_z * w_y - s0_y * w_z;
        let t83 = s0_x * w_z - s0_z * w_x;
        let t84 = s0_y * w_x - s0_x * w_y;
        let t85 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t86 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t87 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t88 = w_y * t84 - w_z * t83 + t85;
        let t89 = w_z * t82 - w_x * t84 + t86;
        let t90 = w_x * t83 - w_y * t82 + t87;
        let t91 = r1_z * w_y - r1_y * w_z;
        let t92 = r1_x * w_z - r1_z * w_x;
        let t93 = r1_y * w_x - r1_x * w_y;
        let t94 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t95 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t96 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t97 = w_y * t93 - w_z * t92 + t94;
        let t98 = w_z * t91 - w_x * t93 + t95;
        let t99 = w_x * t92 - w_y * t91 + t96;
        let t100 = s1_z * w_y - s1_y * w_z;
        let t101 = s1_x * w_z - s1_z * w_x;
        let t102 = s1_y * w_x - s1_x * w_y;
        let t103 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t104 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t105 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t106 = w_y * t102 - w_z * t101 + t103;
        let t107 = w_z * t100 - w_x * t102 + t104;
        let t108 = w_x * t101 - w_y * t100 + t105;
        let t109 = moment_r0 * r0_x + moment_s0 * s0_x + moment_r0 * r1_x
            + moment_s1 * s1_x;
        let t110 = moment_r0 * r0_y + moment_s0 * s0_y + moment_r0 * r1_y
            + moment_s1 * s1_y;
        let t111 = moment_r0 * r0_z + moment_s0 * s0_z + moment_r0 * r1_z
            + moment_s1 * s1_z;
        let t112 = mass_r0_r0 * r0_x + mass_r0_s0 * s0_x + mass_r0_r1 * r1_x
            + mass_r0_s1 * s1_x;
        let t113 = mass_r0_r0 * r0_y + mass_r0_s0 * s0_y + mass_r0_r1 * r1_y
            + mass_r0_s1 * s1_y;
        let t114 = mass_r0_r0 * r0_z + mass_r0_s0 * s0_z + mass_r0_r1 * r1_z
            + mass_r0_s1 * s1_z;
        let t115 = mass_r0_s0 * r0_x + mass_s0_s0 * s0_x + mass_s0_r1 * r1_x
            + mass_s0_s1 * s1_x;
        let t116 = mass_r0_s0 * r0_y + mass_s0_s0 * s0_y + mass_s0_r1 * r1_y
            + mass_s0_s1 * s1_y;
        let t117 = mass_r0_s0 * r0_z + mass_s0_s0 * s0_z + mass_s0_r1 * r1_z
            + mass_s0_s1 * s1_z;
        let t118 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t119 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t120 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t121 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t122 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t123 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        let t124 = w_y * t114;
        let t125 = w_z * t113;
        let t126 = t124 - t125;
        let t127 = w_z * t112;
        let t128 = w_x * t114;
        let t129 = t127 - t128;
        let t130 = w_x * t113;
        let t131 = w_y * t112;
        let t132 = t130 - t131;
        let t133 = moment_r0 * e_x;
        let t134 = moment_r0 * e_y;
        let t135 = moment_r0 * e_z;
        let t136 = w_y * t117;
        let t137 = w_z * t116;
        let t138 = t136 - t137;
        let t139 = w_z * t115;
        let t140 = w_x * t117;
        let t141 = t139 - t140;
        let t142 = w_x * t116;
        let t143 = w_y * t115;
        let t144 = t142 - t143;
        let t145 = w_y * t120;
        let t146 = w_z * t119;
        let t147 = t145 - t146;
        let t148 = w_z * t118;
        let t149 = w_x * t120;
        let t150 = t148 - t149;
        let t151 = w_x * t119;
        let t152 = w_y * t118;
        let t153 = t151 - t152;
        let t154 = w_y * t123;
        let t155 = w_z * t122;
        let t156 = t154 - t155;
        let t157 = w_z * t121;
        let t158 = w_x * t123;
        let t159 = t157 - t158;
        let t160 = w_x * t122;
        let t161 = w_y * t121;
        let t162 = t160 - t161;
        let t163 = r0_y * t113;
        let t164 = r0_z * t114;
        let t165 = s0_y * t116;
        let t166 = s0_z * t117;
        let t167 = r1_y * t119;
        let t168 = r1_z * t120;
        let t169 = s1_y * t122;
        let t170 = s1_z * t123;
        let t171 = r0_x * t112;
        let t172 = s0_x * t115;
        let t173 = r1_x * t118;
        let t174 = s1_x * t121;
        let t175 = w_y * t113;
        let t176 = w_z * t114;
        let t177 = t175 + t176;
        let t178 = w_y * t119;
        let t179 = w_z * t120;
        let t180 = t178 + t179;
        let t181 = 2.0
            * (mass_r0_r0 * v_r0_z + mass_r0_s0 * v_s0_z + mass_r0_r1 * v_r1_z
                + mass_r0_s1 * v_s1_z);
        let t182 = t181 + (t132 - t131);
        let t183 = 2.0
            * (mass_r0_r1 * v_r0_z + mass_s0_r1 * v_s0_z + mass_r0_r0 * v_r1_z
                + mass_r1_s1 * v_s1_z);
        let t184 = t183 + (t153 - t152);
        let t185 = 2.0
            * (mass_r0_r0 * v_r0_y + mass_r0_s0 * v_s0_y + mass_r0_r1 * v_r1_y
                + mass_r0_s1 * v_s1_y);
        let t186 = t185 + (t127 + t129);
        let t187 = 2.0
            * (mass_r0_r1 * v_r0_y + mass_s0_r1 * v_s0_y + mass_r0_r0 * v_r1_y
                + mass_r1_s1 * v_s1_y);
        let t188 = t187 + (t148 + t150);
        let t189 = t181 + (t130 + t132);
        let t190 = t183 + (t151 + t153);
        let t191 = w_x * t112;
        let t192 = t176 + t191;
        let t193 = w_x * t118;
        let t194 = t179 + t193;
        let t195 = 2.0
            * (mass_r0_r0 * v_r0_x + mass_r0_s0 * v_s0_x + mass_r0_r1 * v_r1_x
                + mass_r0_s1 * v_s1_x);
        let t196 = t195 + (t126 - t125);
        let t197 = 2.0
            * (mass_r0_r1 * v_r0_x + mass_s0_r1 * v_s0_x + mass_r0_r0 * v_r1_x
                + mass_r1_s1 * v_s1_x);
        let t198 = t197 + (t147 - t146);
        let t199 = t185 + (t129 - t128);
        let t200 = t187 + (t150 - t149);
        let t201 = t195 + (t124 + t126);
        let t202 = t197 + (t145 + t147);
        let t203 = t175 + t191;
        let t204 = t178 + t193;
        let t205 = 2.0
            * (mass_r0_s0 * v_r0_z + mass_s0_s0 * v_s0_z + mass_s0_r1 * v_r1_z
                + mass_s0_s1 * v_s1_z);
        let t206 = 2.0
            * (mass_r0_s0 * v_r0_y + mass_s0_s0 * v_s0_y + mass_s0_r1 * v_r1_y
                + mass_s0_s1 * v_s1_y);
        let t207 = t205 + (t142 + t144);
        let t208 = t206 + (t141 - t140);
        let t209 = r0_y * t199 + r0_z * t189 + (s0_y * t208 + s0_z * t207)
            + (r1_y * t200 + r1_z * t190);
        let t210 = 2.0
            * (mass_r0_s1 * v_r0_z + mass_s0_s1 * v_s0_z + mass_r1_s1 * v_r1_z
                + mass_s0_s0 * v_s1_z);
        let t211 = 2.0
            * (mass_r0_s1 * v_r0_y + mass_s0_s1 * v_s0_y + mass_r1_s1 * v_r1_y
                + mass_s0_s0 * v_s1_y);
        let t212 = t210 + (t160 + t162);
        let t213 = t211 + (t159 - t158);
        let t214 = 2.0
            * (mass_r0_s0 * v_r0_x + mass_s0_s0 * v_s0_x + mass_s0_r1 * v_r1_x
                + mass_s0_s1 * v_s1_x);
        let t215 = w_z * t117;
        let t216 = w_x * t115;
        let t217 = t215 + t216;
        let t218 = t214 + (t136 + t138);
        let t219 = r0_y * t201 + r0_z * t192 + (s0_y * t218 + s0_z * t217)
            + (r1_y * t202 + r1_z * t194);
        let t220 = 2.0
            * (mass_r0_s1 * v_r0_x + mass_s0_s1 * v_s0_x + mass_r1_s1 * v_r1_x
                + mass_s0_s0 * v_s1_x);
        let t221 = w_z * t123;
        let t222 = w_x * t121;
        let t223 = t221 + t222;
        let t224 = t220 + (t154 + t156);
        let t225 = w_y * t116;
        let t226 = t216 + t225;
        let t227 = t214 + (t138 - t137);
        let t228 = r0_y * t203 - r0_z * t196 + (s0_y * t226 - s0_z * t227)
            + (r1_y * t204 - r1_z * t198);
        let t229 = w_y * t122;
        let t230 = t222 + t229;
        let t231 = t220 + (t156 - t155);
        let t232 = t215 + t225;
        let t233 = r0_z * t177 - r0_x * t199 + (s0_z * t232 - s0_x * t208)
            + (r1_z * t180 - r1_x * t200);
        let t234 = t221 + t229;
        let t235 = t205 + (t144 - t143);
        let t236 = r0_z * t182 + r0_x * t201 + (s0_z * t235 + s0_x * t218)
            + (r1_z * t184 + r1_x * t202);
        let t237 = t210 + (t162 - t161);
        let t238 = t206 + (t139 + t141);
        let t239 = r0_z * t186 + r0_x * t203 + (s0_z * t238 + s0_x * t226)
            + (r1_z * t188 + r1_x * t204);
        let t240 = t211 + (t157 + t159);
        let t241 = r0_x * t189 + r0_y * t177 + (s0_x * t207 + s0_y * t232)
            + (r1_x * t190 + r1_y * t180);
        let t242 = r0_x * t192 - r0_y * t182 + (s0_x * t217 - s0_y * t235)
            + (r1_x * t194 - r1_y * t184);
        let t243 = r0_x * t196 + r0_y * t186 + (s0_x * t227 + s0_y * t238)
            + (r1_x * t198 + r1_y * t188);
        let t244 = w_z * 2.0;
        let t245 = moment_r0 * t244;
        let t246 = w_y * 2.0;
        let t247 = moment_r0 * t246;
        let t248 = moment_s0 * t244;
        let t249 = moment_s0 * t246;
        let t250 = moment_s1 * t244;
        let t251 = moment_s1 * t246;
        let t252 = w_x * 2.0;
        let t253 = moment_r0 * t252;
        let t254 = moment_s0 * t252;
        let t255 = moment_s1 * t252;
        let t256 = t113 * t246;
        let t257 = t114 * t244;
        let t258 = t116 * t246;
        let t259 = t117 * t244;
        let t260 = t119 * t246;
        let t261 = t120 * t244;
        let t262 = t122 * t246;
        let t263 = t123 * t244;
        let t264 = t112 * t252;
        let t265 = t115 * t252;
        let t266 = t118 * t252;
        let t267 = t121 * t252;
        let t268 = w_y * w_y;
        let t269 = w_z * w_z;
        let t270 = t268 + t269;
        let t271 = -moment_r0 * t270;
        let t272 = w_x * w_y;
        let t273 = t272 - dw_z;
        let t274 = moment_r0 * t273;
        let t275 = w_x * w_z;
        let t276 = dw_y + t275;
        let t277 = moment_r0 * t276;
        let t278 = dw_z + t272;
        let t279 = moment_r0 * t278;
        let t280 = w_x * w_x;
        let t281 = t269 + t280;
        let t282 = -moment_r0 * t281;
        let t283 = w_y * w_z;
        let t284 = t283 - dw_x;
        let t285 = moment_r0 * t284;
        let t286 = t275 - dw_y;
        let t287 = moment_r0 * t286;
        let t288 = dw_x + t283;
        let t289 = moment_r0 * t288;
        let t290 = t268 + t280;
        let t291 = -moment_r0 * t290;
        let t292 = mass_r0_r0 * t81;
        let t293 = mass_r0_s0 * t90;
        let t294 = mass_r0_r1 * t99;
        let t295 = mass_r0_s1 * t108;
        let t296 = mass_r0_r0 * t80;
        let t297 = mass_r0_s0 * t89;
        let t298 = mass_r0_r1 * t98;
        let t299 = mass_r0_s1 * t107;
        let t300 = moment_s0 * e_z + mass_r0_s0 * t81;
        let t301 = mass_s0_s0 * t90;
        let t302 = mass_s0_r1 * t99;
        let t303 = mass_s0_s1 * t108;
        let t304 = moment_s0 * e_y + mass_r0_s0 * t80;
        let t305 = mass_s0_s0 * t89;
        let t306 = mass_s0_r1 * t98;
        let t307 = mass_s0_s1 * t107;
        let t308 = t135 + mass_r0_r1 * t81 + mass_s0_r1 * t90;
        let t309 = mass_r0_r0 * t99;
        let t310 = mass_r1_s1 * t108;
        let t311 = t134 + mass_r0_r1 * t80 + mass_s0_r1 * t89;
        let t312 = mass_r0_r0 * t98;
        let t313 = mass_r1_s1 * t107;
        let t314 = moment_s1 * e_z + mass_r0_s1 * t81 + mass_s0_s1 * t90
            + mass_r1_s1 * t99;
        let t315 = mass_s0_s0 * t108;
        let t316 = moment_s1 * e_y + mass_r0_s1 * t80 + mass_s0_s1 * t89
            + mass_r1_s1 * t98;
        let t317 = mass_s0_s0 * t107;
        let t318 = mass_r0_r0 * t79;
        let t319 = mass_r0_s0 * t88;
        let t320 = mass_r0_r1 * t97;
        let t321 = mass_r0_s1 * t106;
        let t322 = moment_s0 * e_x + mass_r0_s0 * t79;
        let t323 = mass_s0_s0 * t88;
        let t324 = mass_s0_r1 * t97;
        let t325 = mass_s0_s1 * t106;
        let t326 = t133 + mass_r0_r1 * t79 + mass_s0_r1 * t88;
        let t327 = mass_r0_r0 * t97;
        let t328 = mass_r1_s1 * t106;
        let t329 = moment_s1 * e_x + mass_r0_s1 * t79 + mass_s0_s1 * t88
            + mass_r1_s1 * t97;
        let t330 = mass_s0_s0 * t106;
        mass[0] = element_mass;
        mass[4] = t111;
        mass[5] = -t110;
        mass[6] = moment_r0;
        mass[9] = moment_s0;
        mass[12] = moment_r0;
        mass[15] = moment_s1;
        mass[19] = element_mass;
        mass[21] = -t111;
        mass[23] = t109;
        mass[25] = moment_r0;
        mass[28] = moment_s0;
        mass[31] = moment_r0;
        mass[34] = moment_s1;
        mass[38] = element_mass;
        mass[39] = t110;
        mass[40] = -t109;
        mass[44] = moment_r0;
        mass[47] = moment_s0;
        mass[50] = moment_r0;
        mass[53] = moment_s1;
        mass[55] = -t111;
        mass[56] = t110;
        mass[57] = t163 + t164 + (t165 + t166) + (t167 + t168) + (t169 + t170);
        mass[58] = -(r0_x * t113 + s0_x * t116 + r1_x * t119 + s1_x * t122);
        mass[59] = -(r0_x * t114 + s0_x * t117 + r1_x * t120 + s1_x * t123);
        mass[61] = -t114;
        mass[62] = t113;
        mass[64] = -t117;
        mass[65] = t116;
        mass[67] = -t120;
        mass[68] = t119;
        mass[70] = -t123;
        mass[71] = t122;
        mass[72] = t111;
        mass[74] = -t109;
        mass[75] = -(r0_y * t112 + s0_y * t115 + r1_y * t118 + s1_y * t121);
        mass[76] = t164 + t171 + (t166 + t172) + (t168 + t173) + (t170 + t174);
        mass[77] = -(r0_y * t114 + s0_y * t117 + r1_y * t120 + s1_y * t123);
        mass[78] = t114;
        mass[80] = -t112;
        mass[81] = t117;
        mass[83] = -t115;
        mass[84] = t120;
        mass[86] = -t118;
        mass[87] = t123;
        mass[89] = -t121;
        mass[90] = -t110;
        mass[91] = t109;
        mass[93] = -(r0_z * t112 + s0_z * t115 + r1_z * t118 + s1_z * t121);
        mass[94] = -(r0_z * t113 + s0_z * t116 + r1_z * t119 + s1_z * t122);
        mass[95] = t163 + t171 + (t165 + t172) + (t167 + t173) + (t169 + t174);
        mass[96] = -t113;
        mass[97] = t112;
        mass[99] = -t116;
        mass[100] = t115;
        mass[102] = -t119;
        mass[103] = t118;
        mass[105] = -t122;
        mass[106] = t121;
        damping[0] = t177 + t180;
        damping[1] = t182 + t184;
        damping[2] = -(t186 + t188);
        damping[15] = -(t189 + t190);
        damping[16] = t192 + t194;
        damping[17] = t196 + t198;
        damping[30] = t199 + t200;
        damping[31] = -(t201 + t202);
        damping[32] = t203 + t204;
        damping[45] = t209 + (s1_y * t213 + s1_z * t212);
        damping[46] = -(t219 + (s1_y * t224 + s1_z * t223));
        damping[47] = t228 + (s1_y * t230 - s1_z * t231);
        damping[60] = t233 + (s1_z * t234 - s1_x * t213);
        damping[61] = t236 + (s1_z * t237 + s1_x * t224);
        damping[62] = -(t239 + (s1_z * t240 + s1_x * t230));
        damping[75] = -(t241 + (s1_x * t212 + s1_y * t234));
        damping[76] = t242 + (s1_x * t223 - s1_y * t237);
        damping[77] = t243 + (s1_x * t231 + s1_y * t240);
        damping[4] = -t245;
        damping[5] = t247;
        damping[7] = -t248;
        damping[8] = t249;
        damping[10] = -t245;
        damping[11] = t247;
        damping[13] = -t250;
        damping[14] = t251;
        damping[18] = t245;
        damping[20] = -t253;
        damping[21] = t248;
        damping[23] = -t254;
        damping[24] = t245;
        damping[26] = -t253;
        damping[27] = t250;
        damping[29] = -t255;
        damping[33] = -t247;
        damping[34] = t253;
        damping[36] = -t249;
        damping[37] = t254;
        damping[39] = -t247;
        damping[40] = t253;
        damping[42] = -t251;
        damping[43] = t255;
        damping[48] = -(t256 + t257);
        damping[49] = t113 * t252;
        damping[50] = t114 * t252;
        damping[51] = -(t258 + t259);
        damping[52] = t116 * t252;
        damping[53] = t117 * t252;
        damping[54] = -(t260 + t261);
        damping[55] = t119 * t252;
        damping[56] = t120 * t252;
        damping[57] = -(t262 + t263);
        damping[58] = t122 * t252;
        damping[59] = t123 * t252;
        damping[63] = t112 * t246;
        damping[64] = -(t257 + t264);
        damping[65] = t114 * t246;
        damping[66] = t115 * t246;
        damping[67] = -(t259 + t265);
        damping[68] = t117 * t246;
        damping[69] = t118 * t246;
        damping[70] = -(t261 + t266);
        damping[71] = t120 * t246;
        damping[72] = t121 * t246;
        damping[73] = -(t263 + t267);
        damping[74] = t123 * t246;
        damping[78] = t112 * t244;
        damping[79] = t113 * t244;
        damping[80] = -(t256 + t264);
        damping[81] = t115 * t244;
        damping[82] = t116 * t244;
        damping[83] = -(t258 + t265);
        damping[84] = t118 * t244;
        damping[85] = t119 * t244;
        damping[86] = -(t260 + t266);
        damping[87] = t121 * t244;
        damping[88] = t122 * t244;
        damping[89] = -(t262 + t267);
        spin[0] = t177;
        spin[1] = t182;
        spin[2] = -t186;
        spin[3] = -t189;
        spin[4] = t192;
        spin[5] = t196;
        spin[6] = t199;
        spin[7] = -t201;
        spin[8] = t203;
        spin[9] = t232;
        spin[10] = t235;
        spin[11] = -t238;
        spin[12] = -t207;
        spin[13] = t217;
        spin[14] = t227;
        spin[15] = t208;
        spin[16] = -t218;
        spin[17] = t226;
        spin[18] = t180;
        spin[19] = t184;
        spin[20] = -t188;
        spin[21] = -t190;
        spin[22] = t194;
        spin[23] = t198;
        spin[24] = t200;
        spin[25] = -t202;
        spin[26] = t204;
        spin[27] = t234;
        spin[28] = t237;
        spin[29] = -t240;
        spin[30] = -t212;
        spin[31] = t223;
        spin[32] = t231;
        spin[33] = t213;
        spin[34] = -t224;
        spin[35] = t230;
        stiffness[0] = t271;
        stiffness[1] = t274;
        stiffness[2] = t277;
        stiffness[3] = -moment_s0 * t270;
        stiffness[4] = moment_s0 * t273;
        stiffness[5] = moment_s0 * t276;
        stiffness[6] = t271;
        stiffness[7] = t274;
        stiffness[8] = t277;
        stiffness[9] = -moment_s1 * t270;
        stiffness[10] = moment_s1 * t273;
        stiffness[11] = moment_s1 * t276;
        stiffness[12] = t279;
        stiffness[13] = t282;
        stiffness[14] = t285;
        stiffness[15] = moment_s0 * t278;
        stiffness[16] = -moment_s0 * t281;
        stiffness[17] = moment_s0 * t284;
        stiffness[18] = t279;
        stiffness[19] = t282;
        stiffness[20] = t285;
        stiffness[21] = moment_s1 * t278;
        stiffness[22] = -moment_s1 * t281;
        stiffness[23] = moment_s1 * t284;
        stiffness[24] = t287;
        stiffness[25] = t289;
        stiffness[26] = t291;
        stiffness[27] = moment_s0 * t286;
        stiffness[28] = moment_s0 * t288;
        stiffness[29] = -moment_s0 * t290;
        stiffness[30] = t287;
        stiffness[31] = t289;
        stiffness[32] = t291;
        stiffness[33] = moment_s1 * t286;
        stiffness[34] = moment_s1 * t288;
        stiffness[35] = -moment_s1 * t290;
        stiffness[36] = t113 * t286 - t114 * t278;
        stiffness[37] = t135 + (t113 * t288 + t292 + t114 * t281) + t293 + t294 + t295;
        stiffness[38] = -(t134 + (t113 * t290 + (t114 * t284 + t296)) + t297 + t298
            + t299);
        stiffness[39] = t116 * t286 - t117 * t278;
        stiffness[40] = t300 + (t116 * t288 + t301 + t117 * t281) + t302 + t303;
        stiffness[41] = -(t304 + (t116 * t290 + (t117 * t284 + t305)) + t306 + t307);
        stiffness[42] = t119 * t286 - t120 * t278;
        stiffness[43] = t308 + (t119 * t288 + t309 + t120 * t281) + t310;
        stiffness[44] = -(t311 + (t119 * t290 + (t120 * t284 + t312)) + t313);
        stiffness[45] = t122 * t286 - t123 * t278;
        stiffness[46] = t314 + (t122 * t288 + t315 + t123 * t281);
        stiffness[47] = -(t316 + (t122 * t290 + (t123 * t284 + t317)));
        stiffness[48] = -(t295
            + (t294 + (t293 + (t135 + (t114 * t270 + (t292 + t112 * t286))))));
        stiffness[49] = t114 * t273 - t112 * t288;
        stiffness[50] = t133 + (t114 * t276 + t318 + t112 * t290) + t319 + t320 + t321;
        stiffness[51] = -(t303 + (t302 + (t300 + (t117 * t270 + (t301 + t115 * t286)))));
        stiffness[52] = t117 * t273 - t115 * t288;
        stiffness[53] = t322 + (t117 * t276 + t323 + t115 * t290) + t324 + t325;
        stiffness[54] = -(t310 + (t308 + (t120 * t270 + (t309 + t118 * t286))));
        stiffness[55] = t120 * t273 - t118 * t288;
        stiffness[56] = t326 + (t120 * t276 + t327 + t118 * t290) + t328;
        stiffness[57] = -(t314 + (t123 * t270 + (t315 + t121 * t286)));
        stiffness[58] = t123 * t273 - t121 * t288;
        stiffness[59] = t329 + (t123 * t276 + t330 + t121 * t290);
        stiffness[60] = t299
            + (t298 + (t297 + (t134 + (t296 + t112 * t278 + t113 * t270))));
        stiffness[61] = -(t321
            + (t320 + (t319 + (t133 + (t112 * t281 + (t318 + t113 * t273))))));
        stiffness[62] = t112 * t284 - t113 * t276;
        stiffness[63] = t307 + (t306 + (t304 + (t305 + t115 * t278 + t116 * t270)));
        stiffness[64] = -(t325 + (t324 + (t322 + (t115 * t281 + (t323 + t116 * t273)))));
        stiffness[65] = t115 * t284 - t116 * t276;
        stiffness[66] = t313 + (t311 + (t312 + t118 * t278 + t119 * t270));
        stiffness[67] = -(t328 + (t326 + (t118 * t281 + (t327 + t119 * t273))));
        stiffness[68] = t118 * t284 - t119 * t276;
        stiffness[69] = t316 + (t317 + t121 * t278 + t122 * t270);
        stiffness[70] = -(t329 + (t121 * t281 + (t330 + t122 * t273)));
        stiffness[71] = t121 * t284 - t122 * t276;
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
    /// Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in the inertial frame; e is minus gravity: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 18 additions, 18 multiplications.
    pub fn fixture_spatial_absolute_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 6],
        force: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        force[0] += m * a_r_x + m_x * a_s_x + m * e_x;
        force[1] += m * a_r_y + m_x * a_s_y + m * e_y;
        force[2] += m * a_r_z + m_x * a_s_z + m * e_z;
        force[3] += m_x * a_r_x + p_xx * a_s_x + m_x * e_x;
        force[4] += m_x * a_r_y + p_xx * a_s_y + m_x * e_y;
        force[5] += m_x * a_r_z + p_xx * a_s_z + m_x * e_z;
    }
    /// Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in a moving frame: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 60 additions, 72 multiplications.
    pub fn fixture_spatial_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        force: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t42 = r_z * w_y - r_y * w_z;
        let t43 = r_x * w_z - r_z * w_x;
        let t44 = r_y * w_x - r_x * w_y;
        let t45 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t46 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t47 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t48 = w_y * t44 - w_z * t43 + t45;
        let t49 = w_z * t42 - w_x * t44 + t46;
        let t50 = w_x * t43 - w_y * t42 + t47;
        let t51 = s_z * w_y - s_y * w_z;
        let t52 = s_x * w_z - s_z * w_x;
        let t53 = s_y * w_x - s_x * w_y;
        let t54 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t55 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t56 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t57 = w_y * t53 - w_z * t52 + t54;
        let t58 = w_z * t51 - w_x * t53 + t55;
        let t59 = w_x * t52 - w_y * t51 + t56;
        force[0] += m * t48 + m_x * t57 + m * e_x;
        force[1] += m * t49 + m_x * t58 + m * e_y;
        force[2] += m * t50 + m_x * t59 + m * e_z;
        force[3] += m_x * t48 + p_xx * t57 + m_x * e_x;
        force[4] += m_x * t49 + p_xx * t58 + m_x * e_y;
        force[5] += m_x * t50 + p_xx * t59 + m_x * e_z;
    }
    /// Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Operations: 69 additions, 57 multiplications.
    pub fn fixture_spatial_inertia_tangent(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 36],
        damping_matrix: &mut [f64; 36],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let t21 = w_y * w_y;
        let t22 = w_z * w_z;
        let t23 = t21 + t22;
        let t24 = w_x * w_y;
        let t25 = t24 - dw_z;
        let t26 = w_x * w_z;
        let t27 = dw_y + t26;
        let t28 = dw_z + t24;
        let t29 = w_x * w_x;
        let t30 = t22 + t29;
        let t31 = w_y * w_z;
        let t32 = t31 - dw_x;
        let t33 = t26 - dw_y;
        let t34 = dw_x + t31;
        let t35 = t21 + t29;
        let t36 = w_z * 2.0;
        let t37 = m * t36;
        let t38 = w_y * 2.0;
        let t39 = m * t38;
        let t40 = m_x * t36;
        let t41 = m_x * t38;
        let t42 = w_x * 2.0;
        let t43 = m * t42;
        let t44 = m_x * t42;
        let t45 = m_x * t36;
        let t46 = m_x * t38;
        let t47 = p_xx * t36;
        let t48 = p_xx * t38;
        let t49 = m_x * t42;
        let t50 = p_xx * t42;
        stiffness[0] += -m * t23;
        stiffness[1] += m * t25;
        stiffness[2] += m * t27;
        stiffness[3] += -m_x * t23;
        stiffness[4] += m_x * t25;
        stiffness[5] += m_x * t27;
        stiffness[6] += m * t28;
        stiffness[7] += -m * t30;
        stiffness[8] += m * t32;
        stiffness[9] += m_x * t28;
        stiffness[10] += -m_x * t30;
        stiffness[11] += m_x * t32;
        stiffness[12] += m * t33;
        stiffness[13] += m * t34;
        stiffness[14] += -m * t35;
        stiffness[15] += m_x * t33;
        stiffness[16] += m_x * t34;
        stiffness[17] += -m_x * t35;
        stiffness[18] += -m_x * t23;
        stiffness[19] += m_x * t25;
        stiffness[20] += m_x * t27;
        stiffness[21] += -p_xx * t23;
        stiffness[22] += p_xx * t25;
        stiffness[23] += p_xx * t27;
        stiffness[24] += m_x * t28;
        stiffness[25] += -m_x * t30;
        stiffness[26] += m_x * t32;
        stiffness[27] += p_xx * t28;
        stiffness[28] += -p_xx * t30;
        stiffness[29] += p_xx * t32;
        stiffness[30] += m_x * t33;
        stiffness[31] += m_x * t34;
        stiffness[32] += -m_x * t35;
        stiffness[33] += p_xx * t33;
        stiffness[34] += p_xx * t34;
        stiffness[35] += -p_xx * t35;
        damping_matrix[1] -= t37;
        damping_matrix[2] += t39;
        damping_matrix[4] -= t40;
        damping_matrix[5] += t41;
        damping_matrix[6] += t37;
        damping_matrix[8] -= t43;
        damping_matrix[9] += t40;
        damping_matrix[11] -= t44;
        damping_matrix[12] -= t39;
        damping_matrix[13] += t43;
        damping_matrix[15] -= t41;
        damping_matrix[16] += t44;
        damping_matrix[19] -= t45;
        damping_matrix[20] += t46;
        damping_matrix[22] -= t47;
        damping_matrix[23] += t48;
        damping_matrix[24] += t45;
        damping_matrix[26] -= t49;
        damping_matrix[27] += t47;
        damping_matrix[29] -= t50;
        damping_matrix[30] -= t46;
        damping_matrix[31] += t49;
        damping_matrix[33] -= t48;
        damping_matrix[34] += t50;
    }
    /// Adds force and moment about the origin that the inertia of what the frame carries needs, in frame axes (Eqs. 11, 12): F = m e + d_b a_b, T = (d_a q_a) x e + M_ab q_a x a_b, with the accelerations a = q'' + 2 w x q' + w' x q + w x (w x q) and that of the origin minus gravity, e.
    ///
    /// Operations: 78 additions, 96 multiplications.
    pub fn fixture_spatial_carried(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        out: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t42 = r_z * w_y - r_y * w_z;
        let t43 = r_x * w_z - r_z * w_x;
        let t44 = r_y * w_x - r_x * w_y;
        let t45 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t46 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t47 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t48 = w_y * t44 - w_z * t43 + t45;
        let t49 = w_z * t42 - w_x * t44 + t46;
        let t50 = w_x * t43 - w_y * t42 + t47;
        let t51 = s_z * w_y - s_y * w_z;
        let t52 = s_x * w_z - s_z * w_x;
        let t53 = s_y * w_x - s_x * w_y;
        let t54 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t55 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t56 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t57 = w_y * t53 - w_z * t52 + t54;
        let t58 = w_z * t51 - w_x * t53 + t55;
        let t59 = w_x * t52 - w_y * t51 + t56;
        let t60 = m * r_x;
        let t61 = t60 + m_x * s_x;
        let t62 = m * r_y;
        let t63 = t62 + m_x * s_y;
        let t64 = m * r_z;
        let t65 = t64 + m_x * s_z;
        let t66 = t60 + m_x * s_x;
        let t67 = t62 + m_x * s_y;
        let t68 = t64 + m_x * s_z;
        let t69 = m_x * r_x + p_xx * s_x;
        let t70 = m_x * r_y + p_xx * s_y;
        let t71 = m_x * r_z + p_xx * s_z;
        let t72 = e_z * t63 - e_y * t65 + (t50 * t67 - t49 * t68)
            + (t59 * t70 - t58 * t71);
        let t73 = e_x * t65 - e_z * t61 + (t48 * t68 - t50 * t66)
            + (t57 * t71 - t59 * t69);
        let t74 = e_y * t61 - e_x * t63 + (t49 * t66 - t48 * t67)
            + (t58 * t69 - t57 * t70);
        out[0] += m * t48 + m_x * t57 + m * e_x;
        out[1] += m * t49 + m_x * t58 + m * e_y;
        out[2] += m * t50 + m_x * t59 + m * e_z;
        out[3] += t72;
        out[4] += t73;
        out[5] += t74;
    }
    /// Writes the derivatives of force F and moment T on the frame, rows first (THEORY 2.1): `mass` with respect to e, w', q''; `damping` to w, q'; `stiffness` to q; and of the nodal forces with respect to w, `spin`. Entries that are always zero are left alone.
    ///
    /// Operations: 204 additions, 267 multiplications.
    pub fn fixture_spatial_carried_tangent(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        mass: &mut [f64; 72],
        damping: &mut [f64; 54],
        spin: &mut [f64; 18],
        stiffness: &mut [f64; 36],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t42 = r_z * w_y - r_y * w_z;
        let t43 = r_x * w_z - r_z * w_x;
        let t44 = r_y * w_x - r_x * w_y;
        let t45 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t46 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t47 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t48 = w_y * t44 - w_z * t43 + t45;
        let t49 = w_z * t42 - w_x * t44 + t46;
        let t50 = w_x * t43 - w_y * t42 + t47;
        let t51 = s_z * w_y - s_y * w_z;
        let t52 = s_x * w_z - s_z * w_x;
        let t53 = s_y * w_x - s_x * w_y;
        let t54 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t55 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t56 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t57 = w_y * t53 - w_z * t52 + t54;
        let t58 = w_z * t51 - w_x * t53 + t55;
        let t59 = w_x * t52 - w_y * t51 + t56;
        let t60 = m * t48;
        let t61 = m_x * t57;
        let t62 = m * t49;
        let t63 = m_x * t58;
        let t64 = m * t50;
        let t65 = m_x * t59;
        let t66 = m * e_x;
        let t67 = m * e_y;
        let t68 = m * e_z;
        let t69 = m * r_x;
        let t70 = t69 + m_x * s_x;
        let t71 = m * r_y;
        let t72 = t71 + m_x * s_y;
        let t73 = m * r_z;
        let t74 = t73 + m_x * s_z;
        let t75 = t69 + m_x * s_x;
        let t76 = t71 + m_x * s_y;
        let t77 = t73 + m_x * s_z;
        let t78 = p_xx * s_x;
        let t79 = m_x * r_x + t78;
        let t80 = p_xx * s_y;
        let t81 = m_x * r_y + t80;
        let t82 = p_xx * s_z;
        let t83 = m_x * r_z + t82;
        let t84 = w_y * t74;
        let t85 = w_z * t72;
        let t86 = t84 - t85;
        let t87 = w_z * t70;
        let t88 = w_x * t74;
        let t89 = t87 - t88;
        let t90 = w_x * t72;
        let t91 = w_y * t70;
        let t92 = t90 - t91;
        let t93 = t78 + m_x * r_x;
        let t94 = t80 + m_x * r_y;
        let t95 = t82 + m_x * r_z;
        let t96 = w_y * t95;
        let t97 = w_z * t94;
        let t98 = t96 - t97;
        let t99 = w_z * t93;
        let t100 = w_x * t95;
        let t101 = t99 - t100;
        let t102 = w_x * t94;
        let t103 = w_y * t93;
        let t104 = t102 - t103;
        let t105 = r_y * t76;
        let t106 = r_z * t77;
        let t107 = s_y * t81;
        let t108 = s_z * t83;
        let t109 = r_x * t75;
        let t110 = s_x * t79;
        let t111 = w_y * t72;
        let t112 = w_z * t74;
        let t113 = t111 + t112;
        let t114 = 2.0 * (m * v_r_z + m_x * v_s_z);
        let t115 = t114 + (t92 - t91);
        let t116 = 2.0 * (m * v_r_y + m_x * v_s_y);
        let t117 = t116 + (t87 + t89);
        let t118 = t114 + (t90 + t92);
        let t119 = w_x * t70;
        let t120 = t112 + t119;
        let t121 = 2.0 * (m * v_r_x + m_x * v_s_x);
        let t122 = t121 + (t86 - t85);
        let t123 = t116 + (t89 - t88);
        let t124 = t121 + (t84 + t86);
        let t125 = t111 + t119;
        let t126 = 2.0 * (m_x * v_r_z + p_xx * v_s_z);
        let t127 = 2.0 * (m_x * v_r_y + p_xx * v_s_y);
        let t128 = t126 + (t102 + t104);
        let t129 = t127 + (t101 - t100);
        let t130 = 2.0 * (m_x * v_r_x + p_xx * v_s_x);
        let t131 = w_z * t95;
        let t132 = w_x * t93;
        let t133 = t131 + t132;
        let t134 = t130 + (t96 + t98);
        let t135 = w_y * t94;
        let t136 = t132 + t135;
        let t137 = t130 + (t98 - t97);
        let t138 = t131 + t135;
        let t139 = t126 + (t104 - t103);
        let t140 = t127 + (t99 + t101);
        let t141 = w_z * 2.0;
        let t142 = m * t141;
        let t143 = w_y * 2.0;
        let t144 = m * t143;
        let t145 = m_x * t141;
        let t146 = m_x * t143;
        let t147 = w_x * 2.0;
        let t148 = m * t147;
        let t149 = m_x * t147;
        let t150 = t76 * t143;
        let t151 = t77 * t141;
        let t152 = t81 * t143;
        let t153 = t83 * t141;
        let t154 = t75 * t147;
        let t155 = t79 * t147;
        let t156 = w_y * w_y;
        let t157 = w_z * w_z;
        let t158 = t156 + t157;
        let t159 = w_x * w_y;
        let t160 = t159 - dw_z;
        let t161 = w_x * w_z;
        let t162 = dw_y + t161;
        let t163 = dw_z + t159;
        let t164 = w_x * w_x;
        let t165 = t157 + t164;
        let t166 = w_y * w_z;
        let t167 = t166 - dw_x;
        let t168 = t161 - dw_y;
        let t169 = dw_x + t166;
        let t170 = t156 + t164;
        let t171 = m_x * e_z + m_x * t50;
        let t172 = p_xx * t59;
        let t173 = m_x * e_y + m_x * t49;
        let t174 = p_xx * t58;
        let t175 = m_x * e_x + m_x * t48;
        let t176 = p_xx * t57;
        mass[0] = m;
        mass[4] = t74;
        mass[5] = -t72;
        mass[6] = m;
        mass[9] = m_x;
        mass[13] = m;
        mass[15] = -t74;
        mass[17] = t70;
        mass[19] = m;
        mass[22] = m_x;
        mass[26] = m;
        mass[27] = t72;
        mass[28] = -t70;
        mass[32] = m;
        mass[35] = m_x;
        mass[37] = -t74;
        mass[38] = t72;
        mass[39] = t105 + t106 + (t107 + t108);
        mass[40] = -(r_x * t76 + s_x * t81);
        mass[41] = -(r_x * t77 + s_x * t83);
        mass[43] = -t77;
        mass[44] = t76;
        mass[46] = -t83;
        mass[47] = t81;
        mass[48] = t74;
        mass[50] = -t70;
        mass[51] = -(r_y * t75 + s_y * t79);
        mass[52] = t106 + t109 + (t108 + t110);
        mass[53] = -(r_y * t77 + s_y * t83);
        mass[54] = t77;
        mass[56] = -t75;
        mass[57] = t83;
        mass[59] = -t79;
        mass[60] = -t72;
        mass[61] = t70;
        mass[63] = -(r_z * t75 + s_z * t79);
        mass[64] = -(r_z * t76 + s_z * t81);
        mass[65] = t105 + t109 + (t107 + t110);
        mass[66] = -t76;
        mass[67] = t75;
        mass[69] = -t81;
        mass[70] = t79;
        damping[0] = t113;
        damping[1] = t115;
        damping[2] = -t117;
        damping[9] = -t118;
        damping[10] = t120;
        damping[11] = t122;
        damping[18] = t123;
        damping[19] = -t124;
        damping[20] = t125;
        damping[27] = r_y * t123 + r_z * t118 + (s_y * t129 + s_z * t128);
        damping[28] = -(r_y * t124 + r_z * t120 + (s_y * t134 + s_z * t133));
        damping[29] = r_y * t125 - r_z * t122 + (s_y * t136 - s_z * t137);
        damping[36] = r_z * t113 - r_x * t123 + (s_z * t138 - s_x * t129);
        damping[37] = r_z * t115 + r_x * t124 + (s_z * t139 + s_x * t134);
        damping[38] = -(r_z * t117 + r_x * t125 + (s_z * t140 + s_x * t136));
        damping[45] = -(r_x * t118 + r_y * t113 + (s_x * t128 + s_y * t138));
        damping[46] = r_x * t120 - r_y * t115 + (s_x * t133 - s_y * t139);
        damping[47] = r_x * t122 + r_y * t117 + (s_x * t137 + s_y * t140);
        damping[4] = -t142;
        damping[5] = t144;
        damping[7] = -t145;
        damping[8] = t146;
        damping[12] = t142;
        damping[14] = -t148;
        damping[15] = t145;
        damping[17] = -t149;
        damping[21] = -t144;
        damping[22] = t148;
        damping[24] = -t146;
        damping[25] = t149;
        damping[30] = -(t150 + t151);
        damping[31] = t76 * t147;
        damping[32] = t77 * t147;
        damping[33] = -(t152 + t153);
        damping[34] = t81 * t147;
        damping[35] = t83 * t147;
        damping[39] = t75 * t143;
        damping[40] = -(t151 + t154);
        damping[41] = t77 * t143;
        damping[42] = t79 * t143;
        damping[43] = -(t153 + t155);
        damping[44] = t83 * t143;
        damping[48] = t75 * t141;
        damping[49] = t76 * t141;
        damping[50] = -(t150 + t154);
        damping[51] = t79 * t141;
        damping[52] = t81 * t141;
        damping[53] = -(t152 + t155);
        spin[0] = t113;
        spin[1] = t115;
        spin[2] = -t117;
        spin[3] = -t118;
        spin[4] = t120;
        spin[5] = t122;
        spin[6] = t123;
        spin[7] = -t124;
        spin[8] = t125;
        spin[9] = t138;
        spin[10] = t139;
        spin[11] = -t140;
        spin[12] = -t128;
        spin[13] = t133;
        spin[14] = t137;
        spin[15] = t129;
        spin[16] = -t134;
        spin[17] = t136;
        stiffness[0] = -m * t158;
        stiffness[1] = m * t160;
        stiffness[2] = m * t162;
        stiffness[3] = -m_x * t158;
        stiffness[4] = m_x * t160;
        stiffness[5] = m_x * t162;
        stiffness[6] = m * t163;
        stiffness[7] = -m * t165;
        stiffness[8] = m * t167;
        stiffness[9] = m_x * t163;
        stiffness[10] = -m_x * t165;
        stiffness[11] = m_x * t167;
        stiffness[12] = m * t168;
        stiffness[13] = m * t169;
        stiffness[14] = -m * t170;
        stiffness[15] = m_x * t168;
        stiffness[16] = m_x * t169;
        stiffness[17] = -m_x * t170;
        stiffness[18] = t76 * t168 - t77 * t163;
        stiffness[19] = t65 + (t68 + (t64 + t76 * t169 + t77 * t165));
        stiffness[20] = -(t63 + (t67 + (t76 * t170 + (t62 + t77 * t167))));
        stiffness[21] = t81 * t168 - t83 * t163;
        stiffness[22] = t171 + (t81 * t169 + t172 + t83 * t165);
        stiffness[23] = -(t173 + (t81 * t170 + (t83 * t167 + t174)));
        stiffness[24] = -(t65 + (t68 + (t77 * t158 + (t64 + t75 * t168))));
        stiffness[25] = t77 * t160 - t75 * t169;
        stiffness[26] = t61 + (t66 + (t60 + t77 * t162 + t75 * t170));
        stiffness[27] = -(t171 + (t83 * t158 + (t172 + t79 * t168)));
        stiffness[28] = t83 * t160 - t79 * t169;
        stiffness[29] = t175 + (t83 * t162 + t176 + t79 * t170);
        stiffness[30] = t63 + (t67 + (t62 + t75 * t163 + t76 * t158));
        stiffness[31] = -(t61 + (t66 + (t75 * t165 + (t60 + t76 * t160))));
        stiffness[32] = t75 * t167 - t76 * t162;
        stiffness[33] = t173 + (t174 + t79 * t163 + t81 * t158);
        stiffness[34] = -(t175 + (t79 * t165 + (t176 + t81 * t160)));
        stiffness[35] = t79 * t167 - t81 * t162;
    }
    /// Free frame `f`: its start relative to its parent, and its rigid parts.
    ///
    /// Frame of the cable.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_f(model: &super::FreeFlight, spec: &mut ::rncf::mesh::FreeSpec) {
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
        model: &super::FreeFlight,
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
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn joint_root_referenced_position(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
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
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_velocity(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
        rows[1] = 0.0;
        rows[2] = 0.0;
        rows[3] = 0.0;
        rows[4] = 0.0;
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_acceleration(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
        rows[1] = 0.0;
        rows[2] = 0.0;
        rows[3] = 0.0;
        rows[4] = 0.0;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jerk(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
        rows[1] = 0.0;
        rows[2] = 0.0;
        rows[3] = 0.0;
        rows[4] = 0.0;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jacobian(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[1] = 0.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
        jacobian[6] = 0.0;
        jacobian[7] = 1.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 0.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 1.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
        jacobian[18] = 0.0;
        jacobian[19] = 0.0;
        jacobian[20] = 0.0;
        jacobian[21] = data.normals[0][0];
        jacobian[22] = data.normals[0][1];
        jacobian[23] = data.normals[0][2];
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
        jacobian[27] = data.normals[1][0];
        jacobian[28] = data.normals[1][1];
        jacobian[29] = data.normals[1][2];
    }
    /// Joint `root`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_prescribed(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = 0.0;
        prescribed.position[1][1] = 0.0;
        prescribed.position[1][2] = 0.0;
        prescribed.position[2][0] = 0.0;
        prescribed.position[2][1] = 0.0;
        prescribed.position[2][2] = 0.0;
        prescribed.position[3][0] = 0.0;
        prescribed.position[3][1] = 0.0;
        prescribed.position[3][2] = 0.0;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = 0.0;
        prescribed.slope[1][1] = 0.0;
        prescribed.slope[1][2] = 0.0;
        prescribed.slope[2][0] = 0.0;
        prescribed.slope[2][1] = 0.0;
        prescribed.slope[2][2] = 0.0;
        prescribed.slope[3][0] = 0.0;
        prescribed.slope[3][1] = 0.0;
        prescribed.slope[3][2] = 0.0;
    }
    /// Joint `twist`: conditions, position level.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn joint_twist_referenced_position(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[2] - data.point[2];
    }
    /// Joint `twist`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_twist_referenced_velocity(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `twist`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_twist_referenced_acceleration(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `twist`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_twist_referenced_jerk(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `twist`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_twist_referenced_jacobian(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 0.0;
        jacobian[1] = 0.0;
        jacobian[2] = 1.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
    }
    /// Joint `twist`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_twist_referenced_prescribed(
        model: &super::FreeFlight,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = 0.0;
        prescribed.position[1][1] = 0.0;
        prescribed.position[1][2] = 0.0;
        prescribed.position[2][0] = 0.0;
        prescribed.position[2][1] = 0.0;
        prescribed.position[2][2] = 0.0;
        prescribed.position[3][0] = 0.0;
        prescribed.position[3][1] = 0.0;
        prescribed.position[3][2] = 0.0;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = 0.0;
        prescribed.slope[1][1] = 0.0;
        prescribed.slope[1][2] = 0.0;
        prescribed.slope[2][0] = 0.0;
        prescribed.slope[2][1] = 0.0;
        prescribed.slope[2][2] = 0.0;
        prescribed.slope[3][0] = 0.0;
        prescribed.slope[3][1] = 0.0;
        prescribed.slope[3][2] = 0.0;
    }
    /// Constraint `root` (clamp in absolute coordinates): rows C(z, t).
    ///
    /// Of `root`: `z[0]` a place on `cable`; `z[1]` a slope of `cable`; `z[2]` fixed in `f`, where another vector starts; `z[3]` fixed in `f`, normal to a direction at the start; `z[4]` fixed in `f`, normal to a direction at the start (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[2][0][0]`
    /// * position y: `z[0][0][1] - z[2][0][1]`
    /// * position z: `z[0][0][2] - z[2][0][2]`
    /// * direction 1: `z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1] + z[1][0][2] * z[3][0][2]`
    /// * direction 2: `z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1] + z[1][0][2] * z[4][0][2]`
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn constraint_position_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..5];
        rows[0] = z[0][0][0] - z[2][0][0];
        rows[1] = z[0][0][1] - z[2][0][1];
        rows[2] = z[0][0][2] - z[2][0][2];
        rows[3] = z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1]
            + z[1][0][2] * z[3][0][2];
        rows[4] = z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1]
            + z[1][0][2] * z[4][0][2];
    }
    /// Constraint `root` (clamp in absolute coordinates): their rate dC/dt.
    ///
    /// Operations: 13 additions, 12 multiplications.
    pub fn constraint_velocity_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..5];
        let t36 = z[3][0][0] * z[1][1][0] + z[1][0][0] * z[3][1][0]
            + (z[3][0][1] * z[1][1][1] + z[1][0][1] * z[3][1][1])
            + (z[3][0][2] * z[1][1][2] + z[1][0][2] * z[3][1][2]);
        let t37 = z[4][0][0] * z[1][1][0] + z[1][0][0] * z[4][1][0]
            + (z[4][0][1] * z[1][1][1] + z[1][0][1] * z[4][1][1])
            + (z[4][0][2] * z[1][1][2] + z[1][0][2] * z[4][1][2]);
        rows[0] = z[0][1][0] - z[2][1][0];
        rows[1] = z[0][1][1] - z[2][1][1];
        rows[2] = z[0][1][2] - z[2][1][2];
        rows[3] = t36;
        rows[4] = t37;
    }
    /// Constraint `root` (clamp in absolute coordinates): their second time derivative.
    ///
    /// Operations: 25 additions, 18 multiplications.
    pub fn constraint_acceleration_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..5];
        let t45 = z[1][1][0] * z[3][1][0];
        let t46 = z[1][1][1] * z[3][1][1];
        let t47 = t45 + z[3][0][0] * z[1][2][0] + (t45 + z[1][0][0] * z[3][2][0])
            + (t46 + z[3][0][1] * z[1][2][1] + (t46 + z[1][0][1] * z[3][2][1]));
        let t48 = z[1][1][2] * z[3][1][2];
        let t49 = z[1][1][0] * z[4][1][0];
        let t50 = z[1][1][1] * z[4][1][1];
        let t51 = t49 + z[4][0][0] * z[1][2][0] + (t49 + z[1][0][0] * z[4][2][0])
            + (t50 + z[4][0][1] * z[1][2][1] + (t50 + z[1][0][1] * z[4][2][1]));
        let t52 = z[1][1][2] * z[4][1][2];
        rows[0] = z[0][2][0] - z[2][2][0];
        rows[1] = z[0][2][1] - z[2][2][1];
        rows[2] = z[0][2][2] - z[2][2][2];
        rows[3] = t47
            + (t48 + z[3][0][2] * z[1][2][2] + (t48 + z[1][0][2] * z[3][2][2]));
        rows[4] = t51
            + (t52 + z[4][0][2] * z[1][2][2] + (t52 + z[1][0][2] * z[4][2][2]));
    }
    /// Constraint `root` (clamp in absolute coordinates): their third time derivative.
    ///
    /// Operations: 43 additions, 24 multiplications.
    pub fn constraint_jerk_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..5];
        let t54 = z[3][1][0] * z[1][2][0];
        let t55 = z[1][1][0] * z[3][2][0];
        let t56 = t54 + t55;
        let t57 = z[3][1][1] * z[1][2][1];
        let t58 = z[1][1][1] * z[3][2][1];
        let t59 = t57 + t58;
        let t60 = t56 + (t54 + z[3][0][0] * z[1][3][0])
            + (t56 + (t55 + z[1][0][0] * z[3][3][0]))
            + (t59 + (t57 + z[3][0][1] * z[1][3][1])
                + (t59 + (t58 + z[1][0][1] * z[3][3][1])));
        let t61 = z[3][1][2] * z[1][2][2];
        let t62 = z[1][1][2] * z[3][2][2];
        let t63 = t61 + t62;
        let t64 = z[4][1][0] * z[1][2][0];
        let t65 = z[1][1][0] * z[4][2][0];
        let t66 = t64 + t65;
        let t67 = z[4][1][1] * z[1][2][1];
        let t68 = z[1][1][1] * z[4][2][1];
        let t69 = t67 + t68;
        let t70 = t66 + (t64 + z[4][0][0] * z[1][3][0])
            + (t66 + (t65 + z[1][0][0] * z[4][3][0]))
            + (t69 + (t67 + z[4][0][1] * z[1][3][1])
                + (t69 + (t68 + z[1][0][1] * z[4][3][1])));
        let t71 = z[4][1][2] * z[1][2][2];
        let t72 = z[1][1][2] * z[4][2][2];
        let t73 = t71 + t72;
        rows[0] = z[0][3][0] - z[2][3][0];
        rows[1] = z[0][3][1] - z[2][3][1];
        rows[2] = z[0][3][2] - z[2][3][2];
        rows[3] = t60
            + (t63 + (t61 + z[3][0][2] * z[1][3][2])
                + (t63 + (t62 + z[1][0][2] * z[3][3][2])));
        rows[4] = t70
            + (t73 + (t71 + z[4][0][2] * z[1][3][2])
                + (t73 + (t72 + z[1][0][2] * z[4][3][2])));
    }
    /// Constraint `root` (clamp in absolute coordinates): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..5];
        gradient[0] = 1.0;
        gradient[6] = -1.0;
        gradient[16] = 1.0;
        gradient[22] = -1.0;
        gradient[32] = 1.0;
        gradient[38] = -1.0;
        gradient[48] = z[3][0];
        gradient[49] = z[3][1];
        gradient[50] = z[3][2];
        gradient[54] = z[1][0];
        gradient[55] = z[1][1];
        gradient[56] = z[1][2];
        gradient[63] = z[4][0];
        gradient[64] = z[4][1];
        gradient[65] = z[4][2];
        gradient[72] = z[1][0];
        gradient[73] = z[1][1];
        gradient[74] = z[1][2];
    }
    /// Constraint `root` (clamp in absolute coordinates): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_rate_gradient_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        velocity: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..5];
        let velocity = &velocity[..5];
        gradient[48] = velocity[3][0];
        gradient[49] = velocity[3][1];
        gradient[50] = velocity[3][2];
        gradient[54] = velocity[1][0];
        gradient[55] = velocity[1][1];
        gradient[56] = velocity[1][2];
        gradient[63] = velocity[4][0];
        gradient[64] = velocity[4][1];
        gradient[65] = velocity[4][2];
        gradient[72] = velocity[1][0];
        gradient[73] = velocity[1][1];
        gradient[74] = velocity[1][2];
    }
    /// Constraint `root` (clamp in absolute coordinates): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_root(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..5];
        let lambda = &lambda[..5];
        hessian[138] = lambda[3];
        hessian[54] = lambda[3];
        hessian[154] = lambda[3];
        hessian[70] = lambda[3];
        hessian[170] = lambda[3];
        hessian[86] = lambda[3];
        hessian[183] = lambda[4];
        hessian[57] = lambda[4];
        hessian[199] = lambda[4];
        hessian[73] = lambda[4];
        hessian[215] = lambda[4];
        hessian[89] = lambda[4];
    }
    /// Constraint `twist` (hold in absolute coordinates): rows C(z, t).
    ///
    /// Of `twist`: `z[0]` a place on `cable`; `z[1]` fixed in `f`, where another vector starts; `z[2]` a direction of `f` (inertial axes).
    ///
    /// * position z: `z[2][0][0] * (z[0][0][0] - z[1][0][0]) + z[2][0][1] * (z[0][0][1] - z[1][0][1]) + z[2][0][2] * (z[0][0][2] - z[1][0][2])`
    ///
    /// Operations: 5 additions, 3 multiplications.
    pub fn constraint_position_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        rows[0] = z[2][0][0] * (z[0][0][0] - z[1][0][0])
            + z[2][0][1] * (z[0][0][1] - z[1][0][1])
            + z[2][0][2] * (z[0][0][2] - z[1][0][2]);
    }
    /// Constraint `twist` (hold in absolute coordinates): their rate dC/dt.
    ///
    /// Operations: 11 additions, 6 multiplications.
    pub fn constraint_velocity_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t30 = z[2][1][0] * (z[0][0][0] - z[1][0][0])
            + z[2][0][0] * (z[0][1][0] - z[1][1][0])
            + (z[2][1][1] * (z[0][0][1] - z[1][0][1])
                + z[2][0][1] * (z[0][1][1] - z[1][1][1]));
        rows[0] = t30
            + (z[2][1][2] * (z[0][0][2] - z[1][0][2])
                + z[2][0][2] * (z[0][1][2] - z[1][1][2]));
    }
    /// Constraint `twist` (hold in absolute coordinates): their second time derivative.
    ///
    /// Operations: 20 additions, 9 multiplications.
    pub fn constraint_acceleration_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t39 = z[2][1][0] * (z[0][1][0] - z[1][1][0]);
        let t40 = z[2][1][1] * (z[0][1][1] - z[1][1][1]);
        let t41 = z[2][2][0] * (z[0][0][0] - z[1][0][0]) + t39
            + (t39 + z[2][0][0] * (z[0][2][0] - z[1][2][0]))
            + (z[2][2][1] * (z[0][0][1] - z[1][0][1]) + t40
                + (t40 + z[2][0][1] * (z[0][2][1] - z[1][2][1])));
        let t42 = z[2][1][2] * (z[0][1][2] - z[1][1][2]);
        rows[0] = t41
            + (z[2][2][2] * (z[0][0][2] - z[1][0][2]) + t42
                + (t42 + z[2][0][2] * (z[0][2][2] - z[1][2][2])));
    }
    /// Constraint `twist` (hold in absolute coordinates): their third time derivative.
    ///
    /// Operations: 32 additions, 12 multiplications.
    pub fn constraint_jerk_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t48 = z[2][2][0] * (z[0][1][0] - z[1][1][0]);
        let t49 = z[2][1][0] * (z[0][2][0] - z[1][2][0]);
        let t50 = t48 + t49;
        let t51 = z[2][3][0] * (z[0][0][0] - z[1][0][0]) + t48 + t50
            + (t50 + (t49 + z[2][0][0] * (z[0][3][0] - z[1][3][0])));
        let t52 = z[2][2][1] * (z[0][1][1] - z[1][1][1]);
        let t53 = z[2][1][1] * (z[0][2][1] - z[1][2][1]);
        let t54 = t52 + t53;
        let t55 = z[2][3][1] * (z[0][0][1] - z[1][0][1]) + t52 + t54
            + (t54 + (t53 + z[2][0][1] * (z[0][3][1] - z[1][3][1])));
        let t56 = z[2][2][2] * (z[0][1][2] - z[1][1][2]);
        let t57 = z[2][1][2] * (z[0][2][2] - z[1][2][2]);
        let t58 = t56 + t57;
        let t59 = z[2][3][2] * (z[0][0][2] - z[1][0][2]) + t56 + t58
            + (t58 + (t57 + z[2][0][2] * (z[0][3][2] - z[1][3][2])));
        rows[0] = t51 + t55 + t59;
    }
    /// Constraint `twist` (hold in absolute coordinates): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_gradient_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..3];
        gradient[0] = z[2][0];
        gradient[1] = z[2][1];
        gradient[2] = z[2][2];
        gradient[3] = -z[2][0];
        gradient[4] = -z[2][1];
        gradient[5] = -z[2][2];
        gradient[6] = z[0][0] - z[1][0];
        gradient[7] = z[0][1] - z[1][1];
        gradient[8] = z[0][2] - z[1][2];
    }
    /// Constraint `twist` (hold in absolute coordinates): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_rate_gradient_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        velocity: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..3];
        let velocity = &velocity[..3];
        gradient[0] = velocity[2][0];
        gradient[1] = velocity[2][1];
        gradient[2] = velocity[2][2];
        gradient[3] = -velocity[2][0];
        gradient[4] = -velocity[2][1];
        gradient[5] = -velocity[2][2];
        gradient[6] = velocity[0][0] - velocity[1][0];
        gradient[7] = velocity[0][1] - velocity[1][1];
        gradient[8] = velocity[0][2] - velocity[1][2];
    }
    /// Constraint `twist` (hold in absolute coordinates): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_twist(
        model: &super::FreeFlight,
        t: f64,
        z: &[[f64; 3]],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..3];
        let lambda = &lambda[..1];
        hessian[54] = lambda[0];
        hessian[6] = lambda[0];
        hessian[57] = -lambda[0];
        hessian[33] = -lambda[0];
        hessian[64] = lambda[0];
        hessian[16] = lambda[0];
        hessian[67] = -lambda[0];
        hessian[43] = -lambda[0];
        hessian[74] = lambda[0];
        hessian[26] = lambda[0];
        hessian[77] = -lambda[0];
        hessian[53] = -lambda[0];
    }
    /// Times at which a derivative of a motion or load may jump (s).
    pub fn kinks(model: &super::FreeFlight, kinks: &mut [f64; 0]) {}
    /// Output columns from what they observe.
    ///
    /// Operations: 5 additions, 3 multiplications, 1 function calls.
    pub fn outputs(
        model: &super::FreeFlight,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
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
    pub fn run_defaults(model: &super::FreeFlight, run: &mut ::rncf::RunDefaults) {
        run.t_end = 2.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::FreeFlight,
        pub row_cable: CableSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::FreeFlight) -> Self {
            Self {
                model: model.clone(),
                row_cable: Default::default(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "cable",
                    kind: 0,
                    instance: None,
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [2.0, 0.0, 0.0],
                    },
                    count: (model.elements as f64) as usize,
                    nodal: &[
                        ::rncf::mesh::NodalSpec {
                            meaning: "position",
                            of: ::rncf::mesh::Interpolant::Position,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "slope",
                            of: ::rncf::mesh::Interpolant::Position,
                            order: 1,
                            xi: 0.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "position",
                            of: ::rncf::mesh::Interpolant::Position,
                            order: 0,
                            xi: 1.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "slope",
                            of: ::rncf::mesh::Interpolant::Position,
                            order: 1,
                            xi: 1.0,
                        },
                    ],
                    connectivity: &[0, 1, 2, 3],
                    vectors_per_node: 2,
                    stride: 2,
                    section_y: None,
                    twist: 0.0,
                    fidelity: ::rncf::mesh::Fidelity::Full,
                    mean_axes: false,
                },
            ])
        }
        fn joints(&self) -> ::std::vec::Vec<::rncf::mesh::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::JointSpec {
                    name: "root",
                    kind: ::rncf::mesh::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 1,
                    point: None,
                },
                ::rncf::mesh::JointSpec {
                    name: "twist",
                    kind: ::rncf::mesh::JointKind::Hold {
                        of: ::rncf::mesh::Interpolant::Position,
                        order: 0,
                        axis: 2,
                    },
                    body: 0,
                    at_end: true,
                    frame: 1,
                    point: None,
                },
            ])
        }
        fn loads(&self) -> ::std::vec::Vec<::rncf::mesh::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([])
        }
        fn observed(&self) -> ::std::vec::Vec<::rncf::mesh::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
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
        fn load_varies(&self, load: usize) -> bool {
            const VARIES: [bool; 0] = [];
            VARIES[load]
        }
        fn conservative(&self) -> bool {
            true
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 0];
            kinks(&self.model, &mut times);
            times.to_vec()
        }
        fn prepare(
            &mut self,
            body: usize,
            length: f64,
            shape: &[f64],
        ) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            let density = ::rncf::mesh::positive(
                "material `soft`",
                "density",
                1500.0,
                "kg/m^3",
            )?;
            let young = ::rncf::mesh::positive(
                "material `soft`",
                "young",
                400000.0,
                "Pa",
            )?;
            let damping = ::rncf::mesh::non_negative(
                "material `soft`",
                "damping",
                0.0,
                "s",
            )?;
            let area = ::rncf::mesh::positive("section `flat`", "area", 0.001, "m^2")?;
            let second_moment = ::rncf::mesh::positive(
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
                damping: damping,
            };
            Ok(())
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
        }
        fn load(&self, load: usize, t: f64) -> [f64; 3] {
            let mut value = [0.0; 3];
            match load {
                _ => {}
            }
            value
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
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
        fn mass(&self, body: usize, mass: &mut [f64]) {
            cable_spatial_mass(&self.row_cable, ::rncf::mesh::array_mut(mass));
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
                ::rncf::mesh::array(q),
                ::rncf::mesh::array_mut(force),
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
                ::rncf::mesh::array(q),
                ::rncf::mesh::array_mut(stiffness),
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
                q: ::rncf::mesh::array(q),
                force: ::rncf::mesh::array_mut(force),
            };
            if !::rncf::lanes::run(four) {
                ::rncf::mesh::elastic_force_one_by_one(self, elements, q, v, force);
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
                q: ::rncf::mesh::array(q),
                stiffness: ::rncf::mesh::array_mut(stiffness),
            };
            if !::rncf::lanes::run(four) {
                ::rncf::mesh::elastic_tangent_one_by_one(
                    self,
                    elements,
                    q,
                    v,
                    stiffness,
                    damping,
                );
            }
        }
        fn force(
            &self,
            body: usize,
            element: usize,
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            force: &mut [f64],
        ) {
            self.elastic_force(body, element, q, v, force);
            let [q, v, a]: [&[f64; 12]; 3] = [q, v, a].map(::rncf::mesh::array);
            let force = ::rncf::mesh::array_mut(force);
            if absolute {
                cable_spatial_absolute_inertia_force(&self.row_cable, frame, a, force);
            } else {
                cable_spatial_inertia_force(&self.row_cable, frame, q, v, a, force);
            }
        }
        fn tangent(
            &self,
            body: usize,
            element: usize,
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            stiffness: &mut [f64],
            damping: &mut [f64],
        ) {
            self.elastic_tangent(body, element, q, v, stiffness, damping);
            if !absolute {
                cable_spatial_inertia_tangent(
                    &self.row_cable,
                    frame,
                    ::rncf::mesh::array_mut(stiffness),
                    ::rncf::mesh::array_mut(damping),
                );
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            cable_spatial_strain_energy(
                &self.row_cable,
                ::rncf::mesh::array(q),
                &mut energy,
            );
            energy
        }
        fn shapes(
            &self,
            body: usize,
            of: ::rncf::mesh::Interpolant,
            order: usize,
            xi: f64,
            weights: &mut [f64],
        ) {
            weights.fill(0.0);
            match (of, order) {
                (::rncf::mesh::Interpolant::Position, 0) => {
                    cable_spatial_shapes_position_0(
                        self.row_cable.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 1) => {
                    cable_spatial_shapes_position_1(
                        self.row_cable.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 2) => {
                    cable_spatial_shapes_position_2(
                        self.row_cable.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                _ => {}
            }
        }
        fn section(&self, body: usize) -> ::rncf::mesh::SectionSpec {
            let model = &self.model;
            ::rncf::mesh::SectionSpec {
                shape: ::rncf::mesh::SectionShape::General {
                    extent: [None, None],
                },
                area: 0.001,
                second_moments: [5e-6, 5e-6],
                torsion_constant: 0.0,
                yield_stress: None,
                material: "soft",
            }
        }
        fn fields(&self, body: usize) -> &'static [(::rncf::mesh::Interpolant, usize)] {
            &[
                (::rncf::mesh::Interpolant::Position, 1),
                (::rncf::mesh::Interpolant::Position, 2),
            ]
        }
        fn field_forces(
            &self,
            body: usize,
            stress_free: &[f64],
            fields: &[f64],
            rates: &[f64],
            forces: &mut [f64],
        ) {
            cable_spatial_field_forces(
                &self.row_cable,
                ::rncf::mesh::array(stress_free),
                ::rncf::mesh::array(fields),
                ::rncf::mesh::array_mut(forces),
            );
        }
        fn moment(
            &self,
            dimension: usize,
            slope: &[f64],
            moment: [f64; 3],
            force: &mut [f64],
        ) {
            match dimension {
                _ => {}
            }
        }
        fn moment_tangent(
            &self,
            dimension: usize,
            slope: &[f64],
            moment: [f64; 3],
            tangent: &mut [f64],
        ) {
            match dimension {
                _ => {}
            }
        }
        fn condition(
            &self,
            joint: usize,
            absolute: bool,
            level: ::rncf::system::ConstraintLevel,
            t: f64,
            data: &::rncf::mesh::JointData,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            rows: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, false) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_root_referenced_velocity(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            joint_root_referenced_acceleration(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            joint_root_referenced_jerk(
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
                        ::rncf::system::ConstraintLevel::Position => {
                            joint_twist_referenced_position(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_twist_referenced_velocity(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            joint_twist_referenced_acceleration(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            joint_twist_referenced_jerk(
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
            data: &::rncf::mesh::JointData,
            jacobian: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, false) => {
                    joint_root_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (1, false) => {
                    joint_twist_referenced_jacobian(&self.model, t, data, jacobian);
                }
                _ => {}
            }
        }
        fn prescribed(
            &self,
            joint: usize,
            absolute: bool,
            t: f64,
            data: &::rncf::mesh::JointData,
            prescribed: &mut ::rncf::mesh::Prescribed,
        ) {
            match (joint, absolute) {
                (0, false) => {
                    joint_root_referenced_prescribed(&self.model, t, data, prescribed);
                }
                (1, false) => {
                    joint_twist_referenced_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            ::rncf::mesh::non_negative("fixture `tip`", "mass", model.tip_mass, "kg")?;
            Ok(())
        }
        fn free(&self) -> ::std::vec::Vec<::rncf::mesh::FreeSpec> {
            let still = ::rncf::mesh::FreeSpec {
                frame: 0,
                parent: 0,
                is_body: false,
                motions: ::rncf::mesh::Motions::Spatial,
                position: [0.0; 3],
                axis: [0.0; 3],
                angle: 0.0,
                velocity: [0.0; 3],
                spin: [0.0; 3],
                rigid: ::rncf::mesh::RigidSpec::default(),
            };
            let mut specs = ::std::vec::Vec::from([
                ::rncf::mesh::FreeSpec {
                    frame: 1,
                    parent: 0,
                    is_body: false,
                    motions: ::rncf::mesh::Motions::Spatial,
                    ..still.clone()
                },
            ]);
            free_f(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::mesh::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                },
                ::rncf::mesh::MarkerSpec::Matching {
                    frame: 1,
                    marker: 0,
                },
                ::rncf::mesh::MarkerSpec::BodySlope {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                },
                ::rncf::mesh::MarkerSpec::Normal {
                    frame: 1,
                    marker: 2,
                    which: 0,
                },
                ::rncf::mesh::MarkerSpec::Normal {
                    frame: 1,
                    marker: 2,
                    which: 1,
                },
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                },
                ::rncf::mesh::MarkerSpec::Matching {
                    frame: 1,
                    marker: 5,
                },
                ::rncf::mesh::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 0.0, 1.0],
                },
            ])
        }
        fn constraints(&self) -> ::std::vec::Vec<::rncf::mesh::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ConstraintSpec {
                    name: "root",
                    kind: "clamp",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[0, 2, 1, 3, 4],
                    first_party: 2,
                    when: ::rncf::mesh::When::Absolute(0),
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "twist",
                    kind: "hold",
                    rows: &["position z"],
                    markers: &[5, 6, 7],
                    first_party: 1,
                    when: ::rncf::mesh::When::Absolute(0),
                },
            ])
        }
        fn marker_constraint(
            &self,
            constraint: usize,
            level: ::rncf::system::ConstraintLevel,
            t: f64,
            z: &[[[f64; 3]; 4]],
            rows: &mut [f64],
        ) {
            match constraint {
                0 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_root(&self.model, t, z, rows)
                        }
                    }
                }
                1 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_twist(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_twist(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_twist(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_twist(&self.model, t, z, rows)
                        }
                    }
                }
                _ => {}
            }
        }
        fn marker_constraint_gradient(
            &self,
            constraint: usize,
            t: f64,
            z: &[[f64; 3]],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match constraint {
                0 => constraint_gradient_root(&self.model, t, z, gradient),
                1 => constraint_gradient_twist(&self.model, t, z, gradient),
                _ => {}
            }
        }
        fn marker_constraint_rate_gradient(
            &self,
            constraint: usize,
            t: f64,
            z: &[[f64; 3]],
            velocity: &[[f64; 3]],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match constraint {
                0 => constraint_rate_gradient_root(&self.model, t, z, velocity, gradient),
                1 => {
                    constraint_rate_gradient_twist(&self.model, t, z, velocity, gradient)
                }
                _ => {}
            }
        }
        fn marker_constraint_hessian(
            &self,
            constraint: usize,
            t: f64,
            z: &[[f64; 3]],
            lambda: &[f64],
            hessian: &mut [f64],
        ) {
            hessian.fill(0.0);
            match constraint {
                0 => constraint_hessian_root(&self.model, t, z, lambda, hessian),
                1 => constraint_hessian_twist(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
        fn fixtures(&self) -> ::std::vec::Vec<::rncf::mesh::FixtureSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::FixtureSpec {
                    name: "tip",
                    body: 0,
                    at: ::rncf::mesh::Place::End,
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
                },
            ])
        }
        fn fixture_force(
            &self,
            dimension: usize,
            vectors: usize,
            constants: [f64; 10],
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            force: &mut [f64],
        ) {
            match (dimension, vectors) {
                (3, 2) => {
                    if absolute {
                        fixture_spatial_absolute_inertia_force(
                            constants,
                            frame,
                            ::rncf::mesh::array(a),
                            ::rncf::mesh::array_mut(force),
                        );
                    } else {
                        fixture_spatial_inertia_force(
                            constants,
                            frame,
                            ::rncf::mesh::array(q),
                            ::rncf::mesh::array(v),
                            ::rncf::mesh::array(a),
                            ::rncf::mesh::array_mut(force),
                        );
                    }
                }
                _ => {}
            }
        }
        fn fixture_tangent(
            &self,
            dimension: usize,
            vectors: usize,
            constants: [f64; 10],
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            stiffness: &mut [f64],
            damping: &mut [f64],
        ) {
            match (dimension, vectors) {
                (3, 2) => {
                    if !absolute {
                        fixture_spatial_inertia_tangent(
                            constants,
                            frame,
                            ::rncf::mesh::array_mut(stiffness),
                            ::rncf::mesh::array_mut(damping),
                        );
                    }
                }
                _ => {}
            }
        }
        fn carried(
            &self,
            of: ::rncf::mesh::Carried,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            out: &mut [f64],
        ) {
            match of {
                ::rncf::mesh::Carried::Element { body: 0 } => {
                    cable_spatial_carried(
                        &self.row_cable,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(out),
                    )
                }
                ::rncf::mesh::Carried::Fixture {
                    dimension: 3,
                    vectors: 2,
                    constants,
                } => {
                    fixture_spatial_carried(
                        constants,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(out),
                    )
                }
                _ => {}
            }
        }
        fn carried_tangent(
            &self,
            of: ::rncf::mesh::Carried,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            out: &mut ::rncf::mesh::CarriedTangent,
        ) {
            const DIMENSIONS: [usize; 1] = [3];
            let (d, n) = match of {
                ::rncf::mesh::Carried::Element { body } => (DIMENSIONS[body], q.len()),
                ::rncf::mesh::Carried::Fixture { dimension, .. } => (dimension, q.len()),
                ::rncf::mesh::Carried::Rigid(_) => (3, 0),
            };
            let s = if d == 2 { 1 } else { 3 };
            let b = d + s;
            for (block, size) in [
                (&mut out.mass, b * (b + n)),
                (&mut out.damping, b * (s + n)),
                (&mut out.spin, n * s),
                (&mut out.stiffness, b * n),
            ] {
                block.clear();
                block.resize(size, 0.0);
            }
            match of {
                ::rncf::mesh::Carried::Element { body: 0 } => {
                    cable_spatial_carried_tangent(
                        &self.row_cable,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(&mut out.mass),
                        ::rncf::mesh::array_mut(&mut out.damping),
                        ::rncf::mesh::array_mut(&mut out.spin),
                        ::rncf::mesh::array_mut(&mut out.stiffness),
                    )
                }
                ::rncf::mesh::Carried::Fixture {
                    dimension: 3,
                    vectors: 2,
                    constants,
                } => {
                    fixture_spatial_carried_tangent(
                        constants,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(&mut out.mass),
                        ::rncf::mesh::array_mut(&mut out.damping),
                        ::rncf::mesh::array_mut(&mut out.spin),
                        ::rncf::mesh::array_mut(&mut out.stiffness),
                    )
                }
                _ => {}
            }
        }
    }
}
