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
    pub struct CableSpatial {
        /// Length, m.
        pub length: f64,
        /// young * area, N.
        pub EA: f64,
        /// young * second_moment, N m^2.
        pub EI: f64,
        /// density * area, kg/m.
        pub rhoA: f64,
        /// Damping of the strain measures, s.
        pub damping: f64,
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 98 additions, 118 multiplications, 1 divisions.
    pub fn cable_spatial_elastic_force(
        row: &CableSpatial,
        q: &[f64; 12],
        force: &mut [f64; 12],
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
        let t46 = length * EA;
        let t47 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t48 = strain_dot_d_d * 0.02142857142857143;
        let t49 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t47 + t48
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t50 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t51 = strain_dot_d_d * (-0.12857142857142856);
        let t52 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t53 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t54 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t55 = t48
            + (t47
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t56 = inverse_length * EI;
        let t57 = dot_d_d * 3.6;
        let stress_dot_s0_s0 = t46 * t49
            + t56 * (t57 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6);
        let t59 = dot_s0_s1 * 2.2;
        let stress_dot_s0_d = t46
            * (strain_dot_s0_s0 * 0.0035714285714285713
                + strain_dot_s0_d * 0.08571428571428572 + t50 + t51 + t52)
            + t56 * (dot_s0_d * (-7.2) + t59 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2));
        let t61 = dot_s0_s1 * (-1.2);
        let stress_dot_s0_s1 = t46
            * (t52
                + (t53 + strain_dot_s0_d * (-0.007142857142857143)
                    + strain_dot_s0_s1 * 0.004761904761904762
                    + strain_dot_d_s1 * (-0.007142857142857143)))
            + t56 * (dot_s0_d * 2.2 + t61 + dot_d_d * (-1.2) + dot_d_s1 * 2.2);
        let stress_dot_d_d = t46 * t54 + t56 * (t61 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6);
        let stress_dot_d_s1 = t46
            * (t51 + (t50 + t53) + strain_dot_d_s1 * 0.08571428571428572
                + strain_dot_s1_s1 * 0.0035714285714285713)
            + t56 * (t59 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2));
        let stress_dot_s1_s1 = t46 * t55
            + t56 * (t57 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2)));
        let t66 = inverse_length
            * (s0_x * stress_dot_s0_d + stress_dot_d_d * (d_x * 2.0)
                + s1_x * stress_dot_d_s1);
        let t67 = inverse_length
            * (s0_y * stress_dot_s0_d + stress_dot_d_d * (d_y * 2.0)
                + s1_y * stress_dot_d_s1);
        let t68 = inverse_length
            * (s0_z * stress_dot_s0_d + stress_dot_d_d * (d_z * 2.0)
                + s1_z * stress_dot_d_s1);
        force[0] -= t66;
        force[1] -= t67;
        force[2] -= t68;
        force[3]
            += stress_dot_s0_s0 * (s0_x * 2.0) + d_x * stress_dot_s0_d
                + s1_x * stress_dot_s0_s1;
        force[4]
            += stress_dot_s0_s0 * (s0_y * 2.0) + d_y * stress_dot_s0_d
                + s1_y * stress_dot_s0_s1;
        force[5]
            += stress_dot_s0_s0 * (s0_z * 2.0) + d_z * stress_dot_s0_d
                + s1_z * stress_dot_s0_s1;
        force[6] += t66;
        force[7] += t67;
        force[8] += t68;
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
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 410 additions, 370 multiplications, 1 divisions.
    pub fn cable_spatial_elastic_tangent(
        row: &CableSpatial,
        q: &[f64; 12],
        stiffness: &mut [f64; 144],
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
        let t46 = length * EA;
        let t47 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t48 = strain_dot_d_d * 0.02142857142857143;
        let t49 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t47 + t48
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t50 = t46 * 0.014285714285714285;
        let t51 = t46 * 0.0035714285714285713;
        let t52 = t46 * (-0.0035714285714285713);
        let t53 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t54 = strain_dot_d_d * (-0.12857142857142856);
        let t55 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t56 = t46 * (-0.12857142857142856);
        let t57 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t58 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t59 = t46 * 0.5142857142857142;
        let t60 = t48
            + (t47
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t61 = inverse_length * EI;
        let t62 = dot_d_d * 3.6;
        let stress_dot_s0_s0 = t46 * t49
            + t61 * (t62 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6);
        let t64 = t46 * 0.02142857142857143 + t61 * 3.6;
        let t65 = t52 + t61 * (-2.2);
        let t66 = t46 * 0.0011904761904761906 + t61 * 0.6;
        let t67 = dot_s0_s1 * 2.2;
        let stress_dot_s0_d = t46
            * (strain_dot_s0_s0 * 0.0035714285714285713
                + strain_dot_s0_d * 0.08571428571428572 + t53 + t54 + t55)
            + t61 * (dot_s0_d * (-7.2) + t67 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2));
        let t69 = t46 * 0.08571428571428572 + t61 * (-7.2);
        let t70 = t46 * (-0.007142857142857143) + t61 * 2.2;
        let t71 = t61 * 1.2;
        let t72 = dot_s0_s1 * (-1.2);
        let stress_dot_s0_s1 = t46
            * (t55
                + (t57 + strain_dot_s0_d * (-0.007142857142857143)
                    + strain_dot_s0_s1 * 0.004761904761904762
                    + strain_dot_d_s1 * (-0.007142857142857143)))
            + t61 * (dot_s0_d * 2.2 + t72 + dot_d_d * (-1.2) + dot_d_s1 * 2.2);
        let t74 = t61 * (-1.2);
        let t75 = t46 * 0.004761904761904762 + t74;
        let stress_dot_d_d = t46 * t58 + t61 * (t72 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6);
        let stress_dot_d_s1 = t46
            * (t54 + (t53 + t57) + strain_dot_d_s1 * 0.08571428571428572
                + strain_dot_s1_s1 * 0.0035714285714285713)
            + t61 * (t67 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2));
        let stress_dot_s1_s1 = t46 * t60
            + t61 * (t62 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2)));
        let t79 = s0_x * 2.0;
        let t80 = s0_y * 2.0;
        let t81 = s0_z * 2.0;
        let t82 = d_x * 2.0;
        let t83 = d_y * 2.0;
        let t84 = d_z * 2.0;
        let t85 = s1_x * 2.0;
        let t86 = s1_y * 2.0;
        let t87 = s1_z * 2.0;
        let t88 = d_x * t51;
        let t89 = d_y * t51;
        let t90 = d_z * t51;
        let t91 = t50 * t80 + t89 + s1_y * t52;
        let t92 = t50 * t81 + t90 + s1_z * t52;
        let t93 = s0_x * t51 + t64 * t82 + s1_x * t65;
        let t94 = s0_y * t51 + t64 * t83 + s1_y * t65;
        let t95 = s0_z * t51 + t64 * t84 + s1_z * t65;
        let t96 = s0_x * t52;
        let t97 = s0_y * t52;
        let t98 = s0_z * t52;
        let t99 = t96 + d_x * t65 + t66 * t85;
        let t100 = t97 + d_y * t65 + t66 * t86;
        let t101 = t98 + d_z * t65 + t66 * t87;
        let t102 = d_x * t69;
        let t103 = d_y * t69;
        let t104 = d_z * t69;
        let t105 = s1_x * t70;
        let t106 = s1_y * t70;
        let t107 = s1_z * t70;
        let t108 = t51 * t80 + t103 + t106;
        let t109 = t51 * t81 + t104 + t107;
        let t110 = t56 * t82;
        let t111 = t56 * t83;
        let t112 = t56 * t84;
        let t113 = s0_x * t69 + t110 + s1_x * t71;
        let t114 = s0_y * t69 + t111 + s1_y * t71;
        let t115 = s0_z * t69 + t112 + s1_z * t71;
        let t116 = s0_x * t70;
        let t117 = s0_y * t70;
        let t118 = s0_z * t70;
        let t119 = t116 + d_x * t71 + t65 * t85;
        let t120 = t117 + d_y * t71 + t65 * t86;
        let t121 = t118 + d_z * t71 + t65 * t87;
        let t122 = d_x * t70;
        let t123 = d_y * t70;
        let t124 = d_z * t70;
        let t125 = t52 * t80 + t123 + s1_y * t75;
        let t126 = t52 * t81 + t124 + s1_z * t75;
        let t127 = t105 + (t116 + t74 * t82);
        let t128 = t106 + (t117 + t74 * t83);
        let t129 = t107 + (t118 + t74 * t84);
        let t130 = t122 + s0_x * t75 + t52 * t85;
        let t131 = t123 + s0_y * t75 + t52 * t86;
        let t132 = t124 + s0_z * t75 + t52 * t87;
        let t133 = s0_y * t56 + t59 * t83 + s1_y * t56;
        let t134 = s0_z * t56 + t59 * t84 + s1_z * t56;
        let t135 = d_x * t56 + s0_x * t74 + t64 * t85;
        let t136 = d_y * t56 + s0_y * t74 + t64 * t86;
        let t137 = d_z * t56 + s0_z * t74 + t64 * t87;
        let t138 = t111 + s0_y * t71 + s1_y * t69;
        let t139 = t112 + s0_z * t71 + s1_z * t69;
        let t140 = t102 + t116 + t51 * t85;
        let t141 = t103 + t117 + t51 * t86;
        let t142 = t104 + t118 + t51 * t87;
        let t143 = t89 + t97 + t50 * t86;
        let t144 = t90 + t98 + t50 * t87;
        let t145 = t79 * (t50 * t79 + t88 + s1_x * t52)
            + d_x * (t51 * t79 + t102 + t105);
        let t146 = t79 * t91 + d_x * t108 + s1_x * t125;
        let t147 = t79 * t92 + d_x * t109 + s1_x * t126;
        let t148 = t80 * t92 + d_y * t109 + s1_y * t126;
        let t149 = t79 * t100 + d_x * t120 + s1_x * t131;
        let t150 = t79 * t101 + d_x * t121 + s1_x * t132;
        let t151 = t80 * t99 + d_y * t119 + s1_y * t130;
        let t152 = t80 * t101 + d_y * t121 + s1_y * t132;
        let t153 = t81 * t99 + d_z * t119 + s1_z * t130;
        let t154 = t81 * t100 + d_z * t120 + s1_z * t131;
        let t155 = s0_x * t113 + t82 * (s0_x * t56 + t59 * t82 + s1_x * t56)
            + s1_x * (t110 + s0_x * t71 + s1_x * t69);
        let t156 = s0_x * t131 + d_x * t141 + t85 * t143;
        let t157 = s0_x * t132 + d_x * t142 + t85 * t144;
        let t158 = s0_y * t132 + d_y * t142 + t86 * t144;
        let t159 = stress_dot_s0_s0 * 2.0;
        let t160 = stress_dot_s0_s1 + (t79 * t99 + d_x * t119 + s1_x * t130);
        let t161 = stress_dot_s0_s1 + (t80 * t100 + d_y * t120 + s1_y * t131);
        let t162 = stress_dot_s0_s1 + (t81 * t101 + d_z * t121 + s1_z * t132);
        let t163 = stress_dot_d_d * 2.0;
        let t164 = stress_dot_s1_s1 * 2.0;
        let t165 = s0_x * t130 + d_x * t140 + t85 * (t88 + t96 + t50 * t85) + t164;
        let t166 = inverse_length * inverse_length;
        let t167 = (t155 + t163) * t166;
        let t168 = (s0_x * t114 + t82 * t133 + s1_x * t138) * t166;
        let t169 = (s0_x * t115 + t82 * t134 + s1_x * t139) * t166;
        let t170 = inverse_length
            * (stress_dot_s0_d + (t79 * t93 + d_x * t113 + s1_x * t127));
        let t171 = inverse_length * (t80 * t93 + d_y * t113 + s1_y * t127);
        let t172 = inverse_length * (t81 * t93 + d_z * t113 + s1_z * t127);
        let t173 = inverse_length
            * (stress_dot_d_s1 + (s0_x * t119 + t82 * t135 + s1_x * t140));
        let t174 = inverse_length * (s0_x * t120 + t82 * t136 + s1_x * t141);
        let t175 = inverse_length * (s0_x * t121 + t82 * t137 + s1_x * t142);
        let t176 = (s0_y * t114 + t83 * t133 + s1_y * t138 + t163) * t166;
        let t177 = (s0_y * t115 + t83 * t134 + s1_y * t139) * t166;
        let t178 = inverse_length * (t79 * t94 + d_x * t114 + s1_x * t128);
        let t179 = inverse_length
            * (stress_dot_s0_d + (t80 * t94 + d_y * t114 + s1_y * t128));
        let t180 = inverse_length * (t81 * t94 + d_z * t114 + s1_z * t128);
        let t181 = inverse_length * (s0_y * t119 + t83 * t135 + s1_y * t140);
        let t182 = inverse_length
            * (stress_dot_d_s1 + (s0_y * t120 + t83 * t136 + s1_y * t141));
        let t183 = inverse_length * (s0_y * t121 + t83 * t137 + s1_y * t142);
        let t184 = (s0_z * t115 + t84 * t134 + s1_z * t139 + t163) * t166;
        let t185 = inverse_length * (t79 * t95 + d_x * t115 + s1_x * t129);
        let t186 = inverse_length * (t80 * t95 + d_y * t115 + s1_y * t129);
        let t187 = inverse_length
            * (stress_dot_s0_d + (t81 * t95 + d_z * t115 + s1_z * t129));
        let t188 = inverse_length * (s0_z * t119 + t84 * t135 + s1_z * t140);
        let t189 = inverse_length * (s0_z * t120 + t84 * t136 + s1_z * t141);
        let t190 = inverse_length
            * (stress_dot_d_s1 + (s0_z * t121 + t84 * t137 + s1_z * t142));
        stiffness[0] += t167;
        stiffness[1] += t168;
        stiffness[2] += t169;
        stiffness[3] -= t170;
        stiffness[4] -= t171;
        stiffness[5] -= t172;
        stiffness[6] -= t167;
        stiffness[7] -= t168;
        stiffness[8] -= t169;
        stiffness[9] -= t173;
        stiffness[10] -= t174;
        stiffness[11] -= t175;
        stiffness[12] += t168;
        stiffness[13] += t176;
        stiffness[14] += t177;
        stiffness[15] -= t178;
        stiffness[16] -= t179;
        stiffness[17] -= t180;
        stiffness[18] -= t168;
        stiffness[19] -= t176;
        stiffness[20] -= t177;
        stiffness[21] -= t181;
        stiffness[22] -= t182;
        stiffness[23] -= t183;
        stiffness[24] += t169;
        stiffness[25] += t177;
        stiffness[26] += t184;
        stiffness[27] -= t185;
        stiffness[28] -= t186;
        stiffness[29] -= t187;
        stiffness[30] -= t169;
        stiffness[31] -= t177;
        stiffness[32] -= t184;
        stiffness[33] -= t188;
        stiffness[34] -= t189;
        stiffness[35] -= t190;
        stiffness[36] -= t170;
        stiffness[37] -= t178;
        stiffness[38] -= t185;
        stiffness[39] += t145 + s1_x * (t52 * t79 + t122 + s1_x * t75) + t159;
        stiffness[40] += t146;
        stiffness[41] += t147;
        stiffness[42] += t170;
        stiffness[43] += t178;
        stiffness[44] += t185;
        stiffness[45] += t160;
        stiffness[46] += t149;
        stiffness[47] += t150;
        stiffness[48] -= t171;
        stiffness[49] -= t179;
        stiffness[50] -= t186;
        stiffness[51] += t146;
        stiffness[52] += t80 * t91 + d_y * t108 + s1_y * t125 + t159;
        stiffness[53] += t148;
        stiffness[54] += t171;
        stiffness[55] += t179;
        stiffness[56] += t186;
        stiffness[57] += t151;
        stiffness[58] += t161;
        stiffness[59] += t152;
        stiffness[60] -= t172;
        stiffness[61] -= t180;
        stiffness[62] -= t187;
        stiffness[63] += t147;
        stiffness[64] += t148;
        stiffness[65] += t81 * t92 + d_z * t109 + s1_z * t126 + t159;
        stiffness[66] += t172;
        stiffness[67] += t180;
        stiffness[68] += t187;
        stiffness[69] += t153;
        stiffness[70] += t154;
        stiffness[71] += t162;
        stiffness[72] -= t167;
        stiffness[73] -= t168;
        stiffness[74] -= t169;
        stiffness[75] += t170;
        stiffness[76] += t171;
        stiffness[77] += t172;
        stiffness[78] += t167;
        stiffness[79] += t168;
        stiffness[80] += t169;
        stiffness[81] += t173;
        stiffness[82] += t174;
        stiffness[83] += t175;
        stiffness[84] -= t168;
        stiffness[85] -= t176;
        stiffness[86] -= t177;
        stiffness[87] += t178;
        stiffness[88] += t179;
        stiffness[89] += t180;
        stiffness[90] += t168;
        stiffness[91] += t176;
        stiffness[92] += t177;
        stiffness[93] += t181;
        stiffness[94] += t182;
        stiffness[95] += t183;
        stiffness[96] -= t169;
        stiffness[97] -= t177;
        stiffness[98] -= t184;
        stiffness[99] += t185;
        stiffness[100] += t186;
        stiffness[101] += t187;
        stiffness[102] += t169;
        stiffness[103] += t177;
        stiffness[104] += t184;
        stiffness[105] += t188;
        stiffness[106] += t189;
        stiffness[107] += t190;
        stiffness[108] -= t173;
        stiffness[109] -= t181;
        stiffness[110] -= t188;
        stiffness[111] += t160;
        stiffness[112] += t151;
        stiffness[113] += t153;
        stiffness[114] += t173;
        stiffness[115] += t181;
        stiffness[116] += t188;
        stiffness[117] += t165;
        stiffness[118] += t156;
        stiffness[119] += t157;
        stiffness[120] -= t174;
        stiffness[121] -= t182;
        stiffness[122] -= t189;
        stiffness[123] += t149;
        stiffness[124] += t161;
        stiffness[125] += t154;
        stiffness[126] += t174;
        stiffness[127] += t182;
        stiffness[128] += t189;
        stiffness[129] += t156;
        stiffness[130] += s0_y * t131 + d_y * t141 + t86 * t143 + t164;
        stiffness[131] += t158;
        stiffness[132] -= t175;
        stiffness[133] -= t183;
        stiffness[134] -= t190;
        stiffness[135] += t150;
        stiffness[136] += t152;
        stiffness[137] += t162;
        stiffness[138] += t175;
        stiffness[139] += t183;
        stiffness[140] += t190;
        stiffness[141] += t157;
        stiffness[142] += t158;
        stiffness[143] += s0_z * t132 + d_z * t142 + t87 * t144 + t164;
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
        let t46 = length * EA * 0.5;
        let t47 = strain_dot_s0_s1 * (-0.0035714285714285713);
        let t48 = strain_dot_d_d * 0.02142857142857143;
        let t49 = strain_dot_s0_s0 * 0.014285714285714285
            + strain_dot_s0_d * 0.0035714285714285713 + t47 + t48
            + strain_dot_d_s1 * (-0.0035714285714285713)
            + strain_dot_s1_s1 * 0.0011904761904761906;
        let t50 = strain_dot_s0_s1 * (-0.007142857142857143);
        let t51 = strain_dot_d_d * (-0.12857142857142856);
        let t52 = strain_dot_s1_s1 * (-0.0035714285714285713);
        let t53 = t46 * (strain_dot_s0_s0 * t49)
            + t46
                * (strain_dot_s0_d
                    * (strain_dot_s0_s0 * 0.0035714285714285713
                        + strain_dot_s0_d * 0.08571428571428572 + t50 + t51 + t52));
        let t54 = strain_dot_s0_s0 * (-0.0035714285714285713);
        let t55 = t46
            * (strain_dot_s0_s1
                * (t52
                    + (t54 + strain_dot_s0_d * (-0.007142857142857143)
                        + strain_dot_s0_s1 * 0.004761904761904762
                        + strain_dot_d_s1 * (-0.007142857142857143))));
        let t56 = strain_dot_s0_s0 * 0.02142857142857143
            + strain_dot_s0_d * (-0.12857142857142856)
            + strain_dot_d_d * 0.5142857142857142
            + strain_dot_d_s1 * (-0.12857142857142856)
            + strain_dot_s1_s1 * 0.02142857142857143;
        let t57 = t53 + t55 + t46 * (strain_dot_d_d * t56)
            + t46
                * (strain_dot_d_s1
                    * (t51 + (t50 + t54) + strain_dot_d_s1 * 0.08571428571428572
                        + strain_dot_s1_s1 * 0.0035714285714285713));
        let t58 = t48
            + (t47
                + (strain_dot_s0_s0 * 0.0011904761904761906
                    + strain_dot_s0_d * (-0.0035714285714285713)))
            + strain_dot_d_s1 * 0.0035714285714285713
            + strain_dot_s1_s1 * 0.014285714285714285;
        let t59 = 0.5 * (inverse_length * EI);
        let t60 = dot_d_d * 3.6;
        let t61 = t57 + t46 * (strain_dot_s1_s1 * t58)
            + t59 * (dot_s0_s0 * (t60 + dot_d_s1 * (-2.2) + dot_s1_s1 * 0.6));
        let t62 = dot_s0_s1 * 2.2;
        let t63 = t61
            + t59
                * (dot_s0_d
                    * (dot_s0_d * (-7.2) + t62 + dot_d_s1 * 1.2 + dot_s1_s1 * (-2.2)));
        let t64 = dot_s0_s1 * (-1.2);
        let t65 = t63
            + t59
                * (dot_s0_s1
                    * (dot_s0_d * 2.2 + t64 + dot_d_d * (-1.2) + dot_d_s1 * 2.2));
        let t66 = t65 + t59 * (dot_d_d * (t64 + dot_s0_s0 * 3.6 + dot_s1_s1 * 3.6))
            + t59
                * (dot_d_s1
                    * (t62 + (dot_s0_s0 * (-2.2) + dot_s0_d * 1.2) + dot_d_s1 * (-7.2)));
        *energy
            += t66 + t59 * (dot_s1_s1 * (t60 + (dot_s0_s0 * 0.6 + dot_s0_d * (-2.2))));
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
        let t19 = length * element_mass;
        let mass_r0_s0 = t19 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t19 * (-0.030952380952380953);
        let t23 = element_mass * (length * length);
        let mass_s0_s0 = t23 * 0.009523809523809525;
        let mass_s0_r1 = t19 * 0.030952380952380953;
        let mass_s0_s1 = t23 * (-0.007142857142857143);
        let mass_r1_s1 = t19 * (-0.05238095238095238);
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
        let t63 = r0_z * w_y - r0_y * w_z;
        let t64 = r0_x * w_z - r0_z * w_x;
        let t65 = r0_y * w_x - r0_x * w_y;
        let t66 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + (v_r0_z * w_y - v_r0_y * w_z) * 2.0);
        let t67 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + (v_r0_x * w_z - v_r0_z * w_x) * 2.0);
        let t68 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + (v_r0_y * w_x - v_r0_x * w_y) * 2.0);
        let total_r0_x = e_x + (w_y * t65 - w_z * t64 + t66);
        let total_r0_y = e_y + (w_z * t63 - w_x * t65 + t67);
        let total_r0_z = e_z + (w_x * t64 - w_y * t63 + t68);
        let t72 = s0_z * w_y - s0_y * w_z;
        let t73 = s0_x * w_z - s0_z * w_x;
        let t74 = s0_y * w_x - s0_x * w_y;
        let t75 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t76 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t77 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let total_s0_x = w_y * t74 - w_z * t73 + t75;
        let total_s0_y = w_z * t72 - w_x * t74 + t76;
        let total_s0_z = w_x * t73 - w_y * t72 + t77;
        let t81 = r1_z * w_y - r1_y * w_z;
        let t82 = r1_x * w_z - r1_z * w_x;
        let t83 = r1_y * w_x - r1_x * w_y;
        let t84 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t85 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t86 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let total_r1_x = e_x + (w_y * t83 - w_z * t82 + t84);
        let total_r1_y = e_y + (w_z * t81 - w_x * t83 + t85);
        let total_r1_z = e_z + (w_x * t82 - w_y * t81 + t86);
        let t90 = s1_z * w_y - s1_y * w_z;
        let t91 = s1_x * w_z - s1_z * w_x;
        let t92 = s1_y * w_x - s1_x * w_y;
        let t93 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t94 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t95 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let total_s1_x = w_y * t92 - w_z * t91 + t93;
        let total_s1_y = w_z * t90 - w_x * t92 + t94;
        let total_s1_z = w_x * t91 - w_y * t90 + t95;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t100 = length * element_mass;
        let mass_r0_s0 = t100 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t100 * (-0.030952380952380953);
        let t104 = element_mass * (length * length);
        let mass_s0_s0 = t104 * 0.009523809523809525;
        let mass_s0_r1 = t100 * 0.030952380952380953;
        let mass_s0_s1 = t104 * (-0.007142857142857143);
        let mass_r1_s1 = t100 * (-0.05238095238095238);
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
        let t25 = length * element_mass;
        let mass_r0_s0 = t25 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t25 * (-0.030952380952380953);
        let t29 = element_mass * (length * length);
        let mass_s0_s0 = t29 * 0.009523809523809525;
        let mass_s0_r1 = t25 * 0.030952380952380953;
        let mass_s0_s1 = t29 * (-0.007142857142857143);
        let mass_r1_s1 = t25 * (-0.05238095238095238);
        let t34 = w_y * w_y;
        let t35 = w_z * w_z;
        let t36 = t34 + t35;
        let t37 = -mass_r0_r0 * t36;
        let t38 = w_x * w_y;
        let t39 = t38 - dw_z;
        let t40 = mass_r0_r0 * t39;
        let t41 = w_x * w_z;
        let t42 = dw_y + t41;
        let t43 = mass_r0_r0 * t42;
        let t44 = -mass_r0_s0 * t36;
        let t45 = mass_r0_s0 * t39;
        let t46 = mass_r0_s0 * t42;
        let t47 = -mass_r0_r1 * t36;
        let t48 = mass_r0_r1 * t39;
        let t49 = mass_r0_r1 * t42;
        let t50 = -mass_r0_s1 * t36;
        let t51 = mass_r0_s1 * t39;
        let t52 = mass_r0_s1 * t42;
        let t53 = dw_z + t38;
        let t54 = mass_r0_r0 * t53;
        let t55 = w_x * w_x;
        let t56 = t35 + t55;
        let t57 = -mass_r0_r0 * t56;
        let t58 = w_y * w_z;
        let t59 = t58 - dw_x;
        let t60 = mass_r0_r0 * t59;
        let t61 = mass_r0_s0 * t53;
        let t62 = -mass_r0_s0 * t56;
        let t63 = mass_r0_s0 * t59;
        let t64 = mass_r0_r1 * t53;
        let t65 = -mass_r0_r1 * t56;
        let t66 = mass_r0_r1 * t59;
        let t67 = mass_r0_s1 * t53;
        let t68 = -mass_r0_s1 * t56;
        let t69 = mass_r0_s1 * t59;
        let t70 = t41 - dw_y;
        let t71 = mass_r0_r0 * t70;
        let t72 = dw_x + t58;
        let t73 = mass_r0_r0 * t72;
        let t74 = t34 + t55;
        let t75 = -mass_r0_r0 * t74;
        let t76 = mass_r0_s0 * t70;
        let t77 = mass_r0_s0 * t72;
        let t78 = -mass_r0_s0 * t74;
        let t79 = mass_r0_r1 * t70;
        let t80 = mass_r0_r1 * t72;
        let t81 = -mass_r0_r1 * t74;
        let t82 = mass_r0_s1 * t70;
        let t83 = mass_r0_s1 * t72;
        let t84 = -mass_r0_s1 * t74;
        let t85 = -mass_s0_s0 * t36;
        let t86 = mass_s0_s0 * t39;
        let t87 = mass_s0_s0 * t42;
        let t88 = -mass_s0_r1 * t36;
        let t89 = mass_s0_r1 * t39;
        let t90 = mass_s0_r1 * t42;
        let t91 = -mass_s0_s1 * t36;
        let t92 = mass_s0_s1 * t39;
        let t93 = mass_s0_s1 * t42;
        let t94 = mass_s0_s0 * t53;
        let t95 = -mass_s0_s0 * t56;
        let t96 = mass_s0_s0 * t59;
        let t97 = mass_s0_r1 * t53;
        let t98 = -mass_s0_r1 * t56;
        let t99 = mass_s0_r1 * t59;
        let t100 = mass_s0_s1 * t53;
        let t101 = -mass_s0_s1 * t56;
        let t102 = mass_s0_s1 * t59;
        let t103 = mass_s0_s0 * t70;
        let t104 = mass_s0_s0 * t72;
        let t105 = -mass_s0_s0 * t74;
        let t106 = mass_s0_r1 * t70;
        let t107 = mass_s0_r1 * t72;
        let t108 = -mass_s0_r1 * t74;
        let t109 = mass_s0_s1 * t70;
        let t110 = mass_s0_s1 * t72;
        let t111 = -mass_s0_s1 * t74;
        let t112 = -mass_r1_s1 * t36;
        let t113 = mass_r1_s1 * t39;
        let t114 = mass_r1_s1 * t42;
        let t115 = mass_r1_s1 * t53;
        let t116 = -mass_r1_s1 * t56;
        let t117 = mass_r1_s1 * t59;
        let t118 = mass_r1_s1 * t70;
        let t119 = mass_r1_s1 * t72;
        let t120 = -mass_r1_s1 * t74;
        let t121 = w_z * 2.0;
        let t122 = mass_r0_r0 * t121;
        let t123 = w_y * 2.0;
        let t124 = mass_r0_r0 * t123;
        let t125 = mass_r0_s0 * t121;
        let t126 = mass_r0_s0 * t123;
        let t127 = mass_r0_r1 * t121;
        let t128 = mass_r0_r1 * t123;
        let t129 = mass_r0_s1 * t121;
        let t130 = mass_r0_s1 * t123;
        let t131 = w_x * 2.0;
        let t132 = mass_r0_r0 * t131;
        let t133 = mass_r0_s0 * t131;
        let t134 = mass_r0_r1 * t131;
        let t135 = mass_r0_s1 * t131;
        let t136 = mass_s0_s0 * t121;
        let t137 = mass_s0_s0 * t123;
        let t138 = mass_s0_r1 * t121;
        let t139 = mass_s0_r1 * t123;
        let t140 = mass_s0_s1 * t121;
        let t141 = mass_s0_s1 * t123;
        let t142 = mass_s0_s0 * t131;
        let t143 = mass_s0_r1 * t131;
        let t144 = mass_s0_s1 * t131;
        let t145 = mass_r1_s1 * t121;
        let t146 = mass_r1_s1 * t123;
        let t147 = mass_r1_s1 * t131;
        stiffness[0] += t37;
        stiffness[1] += t40;
        stiffness[2] += t43;
        stiffness[3] += t44;
        stiffness[4] += t45;
        stiffness[5] += t46;
        stiffness[6] += t47;
        stiffness[7] += t48;
        stiffness[8] += t49;
        stiffness[9] += t50;
        stiffness[10] += t51;
        stiffness[11] += t52;
        stiffness[12] += t54;
        stiffness[13] += t57;
        stiffness[14] += t60;
        stiffness[15] += t61;
        stiffness[16] += t62;
        stiffness[17] += t63;
        stiffness[18] += t64;
        stiffness[19] += t65;
        stiffness[20] += t66;
        stiffness[21] += t67;
        stiffness[22] += t68;
        stiffness[23] += t69;
        stiffness[24] += t71;
        stiffness[25] += t73;
        stiffness[26] += t75;
        stiffness[27] += t76;
        stiffness[28] += t77;
        stiffness[29] += t78;
        stiffness[30] += t79;
        stiffness[31] += t80;
        stiffness[32] += t81;
        stiffness[33] += t82;
        stiffness[34] += t83;
        stiffness[35] += t84;
        stiffness[36] += t44;
        stiffness[37] += t45;
        stiffness[38] += t46;
        stiffness[39] += t85;
        stiffness[40] += t86;
        stiffness[41] += t87;
        stiffness[42] += t88;
        stiffness[43] += t89;
        stiffness[44] += t90;
        stiffness[45] += t91;
        stiffness[46] += t92;
        stiffness[47] += t93;
        stiffness[48] += t61;
        stiffness[49] += t62;
        stiffness[50] += t63;
        stiffness[51] += t94;
        stiffness[52] += t95;
        stiffness[53] += t96;
        stiffness[54] += t97;
        stiffness[55] += t98;
        stiffness[56] += t99;
        stiffness[57] += t100;
        stiffness[58] += t101;
        stiffness[59] += t102;
        stiffness[60] += t76;
        stiffness[61] += t77;
        stiffness[62] += t78;
        stiffness[63] += t103;
        stiffness[64] += t104;
        stiffness[65] += t105;
        stiffness[66] += t106;
        stiffness[67] += t107;
        stiffness[68] += t108;
        stiffness[69] += t109;
        stiffness[70] += t110;
        stiffness[71] += t111;
        stiffness[72] += t47;
        stiffness[73] += t48;
        stiffness[74] += t49;
        stiffness[75] += t88;
        stiffness[76] += t89;
        stiffness[77] += t90;
        stiffness[78] += t37;
        stiffness[79] += t40;
        stiffness[80] += t43;
        stiffness[81] += t112;
        stiffness[82] += t113;
        stiffness[83] += t114;
        stiffness[84] += t64;
        stiffness[85] += t65;
        stiffness[86] += t66;
        stiffness[87] += t97;
        stiffness[88] += t98;
        stiffness[89] += t99;
        stiffness[90] += t54;
        stiffness[91] += t57;
        stiffness[92] += t60;
        stiffness[93] += t115;
        stiffness[94] += t116;
        stiffness[95] += t117;
        stiffness[96] += t79;
        stiffness[97] += t80;
        stiffness[98] += t81;
        stiffness[99] += t106;
        stiffness[100] += t107;
        stiffness[101] += t108;
        stiffness[102] += t71;
        stiffness[103] += t73;
        stiffness[104] += t75;
        stiffness[105] += t118;
        stiffness[106] += t119;
        stiffness[107] += t120;
        stiffness[108] += t50;
        stiffness[109] += t51;
        stiffness[110] += t52;
        stiffness[111] += t91;
        stiffness[112] += t92;
        stiffness[113] += t93;
        stiffness[114] += t112;
        stiffness[115] += t113;
        stiffness[116] += t114;
        stiffness[117] += t85;
        stiffness[118] += t86;
        stiffness[119] += t87;
        stiffness[120] += t67;
        stiffness[121] += t68;
        stiffness[122] += t69;
        stiffness[123] += t100;
        stiffness[124] += t101;
        stiffness[125] += t102;
        stiffness[126] += t115;
        stiffness[127] += t116;
        stiffness[128] += t117;
        stiffness[129] += t94;
        stiffness[130] += t95;
        stiffness[131] += t96;
        stiffness[132] += t82;
        stiffness[133] += t83;
        stiffness[134] += t84;
        stiffness[135] += t109;
        stiffness[136] += t110;
        stiffness[137] += t111;
        stiffness[138] += t118;
        stiffness[139] += t119;
        stiffness[140] += t120;
        stiffness[141] += t103;
        stiffness[142] += t104;
        stiffness[143] += t105;
        damping_matrix[1] -= t122;
        damping_matrix[2] += t124;
        damping_matrix[4] -= t125;
        damping_matrix[5] += t126;
        damping_matrix[7] -= t127;
        damping_matrix[8] += t128;
        damping_matrix[10] -= t129;
        damping_matrix[11] += t130;
        damping_matrix[12] += t122;
        damping_matrix[14] -= t132;
        damping_matrix[15] += t125;
        damping_matrix[17] -= t133;
        damping_matrix[18] += t127;
        damping_matrix[20] -= t134;
        damping_matrix[21] += t129;
        damping_matrix[23] -= t135;
        damping_matrix[24] -= t124;
        damping_matrix[25] += t132;
        damping_matrix[27] -= t126;
        damping_matrix[28] += t133;
        damping_matrix[30] -= t128;
        damping_matrix[31] += t134;
        damping_matrix[33] -= t130;
        damping_matrix[34] += t135;
        damping_matrix[37] -= t125;
        damping_matrix[38] += t126;
        damping_matrix[40] -= t136;
        damping_matrix[41] += t137;
        damping_matrix[43] -= t138;
        damping_matrix[44] += t139;
        damping_matrix[46] -= t140;
        damping_matrix[47] += t141;
        damping_matrix[48] += t125;
        damping_matrix[50] -= t133;
        damping_matrix[51] += t136;
        damping_matrix[53] -= t142;
        damping_matrix[54] += t138;
        damping_matrix[56] -= t143;
        damping_matrix[57] += t140;
        damping_matrix[59] -= t144;
        damping_matrix[60] -= t126;
        damping_matrix[61] += t133;
        damping_matrix[63] -= t137;
        damping_matrix[64] += t142;
        damping_matrix[66] -= t139;
        damping_matrix[67] += t143;
        damping_matrix[69] -= t141;
        damping_matrix[70] += t144;
        damping_matrix[73] -= t127;
        damping_matrix[74] += t128;
        damping_matrix[76] -= t138;
        damping_matrix[77] += t139;
        damping_matrix[79] -= t122;
        damping_matrix[80] += t124;
        damping_matrix[82] -= t145;
        damping_matrix[83] += t146;
        damping_matrix[84] += t127;
        damping_matrix[86] -= t134;
        damping_matrix[87] += t138;
        damping_matrix[89] -= t143;
        damping_matrix[90] += t122;
        damping_matrix[92] -= t132;
        damping_matrix[93] += t145;
        damping_matrix[95] -= t147;
        damping_matrix[96] -= t128;
        damping_matrix[97] += t134;
        damping_matrix[99] -= t139;
        damping_matrix[100] += t143;
        damping_matrix[102] -= t124;
        damping_matrix[103] += t132;
        damping_matrix[105] -= t146;
        damping_matrix[106] += t147;
        damping_matrix[109] -= t129;
        damping_matrix[110] += t130;
        damping_matrix[112] -= t140;
        damping_matrix[113] += t141;
        damping_matrix[115] -= t145;
        damping_matrix[116] += t146;
        damping_matrix[118] -= t136;
        damping_matrix[119] += t137;
        damping_matrix[120] += t129;
        damping_matrix[122] -= t135;
        damping_matrix[123] += t140;
        damping_matrix[125] -= t144;
        damping_matrix[126] += t145;
        damping_matrix[128] -= t147;
        damping_matrix[129] += t136;
        damping_matrix[131] -= t142;
        damping_matrix[132] -= t130;
        damping_matrix[133] += t135;
        damping_matrix[135] -= t141;
        damping_matrix[136] += t144;
        damping_matrix[138] -= t146;
        damping_matrix[139] += t147;
        damping_matrix[141] -= t137;
        damping_matrix[142] += t142;
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
        let t40 = length * element_mass;
        let mass_r0_s0 = t40 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t40 * (-0.030952380952380953);
        let t44 = element_mass * (length * length);
        let mass_s0_s0 = t44 * 0.009523809523809525;
        let mass_s0_r1 = t40 * 0.030952380952380953;
        let mass_s0_s1 = t44 * (-0.007142857142857143);
        let mass_r1_s1 = t40 * (-0.05238095238095238);
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
        let t64 = length * element_mass;
        let mass_r0_s0 = t64 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t64 * (-0.030952380952380953);
        let t68 = element_mass * (length * length);
        let mass_s0_s0 = t68 * 0.009523809523809525;
        let mass_s0_r1 = t64 * 0.030952380952380953;
        let mass_s0_s1 = t68 * (-0.007142857142857143);
        let mass_r1_s1 = t64 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t64 * 0.08333333333333333;
        let moment_s1 = t64 * (-0.08333333333333333);
        let t76 = r0_z * w_y - r0_y * w_z;
        let t77 = r0_x * w_z - r0_z * w_x;
        let t78 = r0_y * w_x - r0_x * w_y;
        let t79 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t80 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t81 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t82 = w_y * t78 - w_z * t77 + t79;
        let t83 = w_z * t76 - w_x * t78 + t80;
        let t84 = w_x * t77 - w_y * t76 + t81;
        let t85 = s0_z * w_y - s0_y * w_z;
        let t86 = s0_x * w_z - s0_z * w_x;
        let t87 = s0_y * w_x - s0_x * w_y;
        let t88 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t89 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t90 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t91 = w_y * t87 - w_z * t86 + t88;
        let t92 = w_z * t85 - w_x * t87 + t89;
        let t93 = w_x * t86 - w_y * t85 + t90;
        let t94 = r1_z * w_y - r1_y * w_z;
        let t95 = r1_x * w_z - r1_z * w_x;
        let t96 = r1_y * w_x - r1_x * w_y;
        let t97 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t98 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t99 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t100 = w_y * t96 - w_z * t95 + t97;
        let t101 = w_z * t94 - w_x * t96 + t98;
        let t102 = w_x * t95 - w_y * t94 + t99;
        let t103 = s1_z * w_y - s1_y * w_z;
        let t104 = s1_x * w_z - s1_z * w_x;
        let t105 = s1_y * w_x - s1_x * w_y;
        let t106 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t107 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t108 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t109 = w_y * t105 - w_z * t104 + t106;
        let t110 = w_z * t103 - w_x * t105 + t107;
        let t111 = w_x * t104 - w_y * t103 + t108;
        let t112 = moment_r0 * t82 + moment_s0 * t91 + moment_r0 * t100
            + moment_s1 * t109 + element_mass * e_x;
        let t113 = moment_r0 * t83 + moment_s0 * t92 + moment_r0 * t101
            + moment_s1 * t110 + element_mass * e_y;
        let t114 = moment_r0 * t84 + moment_s0 * t93 + moment_r0 * t102
            + moment_s1 * t111 + element_mass * e_z;
        let t115 = moment_r0 * r0_x + moment_s0 * s0_x + moment_r0 * r1_x
            + moment_s1 * s1_x;
        let t116 = moment_r0 * r0_y + moment_s0 * s0_y + moment_r0 * r1_y
            + moment_s1 * s1_y;
        let t117 = moment_r0 * r0_z + moment_s0 * s0_z + moment_r0 * r1_z
            + moment_s1 * s1_z;
        let t118 = mass_r0_r0 * r0_x + mass_r0_s0 * s0_x + mass_r0_r1 * r1_x
            + mass_r0_s1 * s1_x;
        let t119 = mass_r0_r0 * r0_y + mass_r0_s0 * s0_y + mass_r0_r1 * r1_y
            + mass_r0_s1 * s1_y;
        let t120 = mass_r0_r0 * r0_z + mass_r0_s0 * s0_z + mass_r0_r1 * r1_z
            + mass_r0_s1 * s1_z;
        let t121 = mass_r0_s0 * r0_x + mass_s0_s0 * s0_x + mass_s0_r1 * r1_x
            + mass_s0_s1 * s1_x;
        let t122 = mass_r0_s0 * r0_y + mass_s0_s0 * s0_y + mass_s0_r1 * r1_y
            + mass_s0_s1 * s1_y;
        let t123 = mass_r0_s0 * r0_z + mass_s0_s0 * s0_z + mass_s0_r1 * r1_z
            + mass_s0_s1 * s1_z;
        let t124 = e_z * t116 - e_y * t117 + (t84 * t119 - t83 * t120)
            + (t93 * t122 - t92 * t123);
        let t125 = e_x * t117 - e_z * t115 + (t82 * t120 - t84 * t118)
            + (t91 * t123 - t93 * t121);
        let t126 = e_y * t115 - e_x * t116 + (t83 * t118 - t82 * t119)
            + (t92 * t121 - t91 * t122);
        let t127 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t128 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t129 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t130 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t131 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t132 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        out[0] += t112;
        out[1] += t113;
        out[2] += t114;
        out[3] += t124 + (t102 * t128 - t101 * t129) + (t111 * t131 - t110 * t132);
        out[4] += t125 + (t100 * t129 - t102 * t127) + (t109 * t132 - t111 * t130);
        out[5] += t126 + (t101 * t127 - t100 * t128) + (t110 * t130 - t109 * t131);
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
        let t64 = length * element_mass;
        let mass_r0_s0 = t64 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t64 * (-0.030952380952380953);
        let t68 = element_mass * (length * length);
        let mass_s0_s0 = t68 * 0.009523809523809525;
        let mass_s0_r1 = t64 * 0.030952380952380953;
        let mass_s0_s1 = t68 * (-0.007142857142857143);
        let mass_r1_s1 = t64 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t64 * 0.08333333333333333;
        let moment_s1 = t64 * (-0.08333333333333333);
        let t76 = r0_z * w_y - r0_y * w_z;
        let t77 = r0_x * w_z - r0_z * w_x;
        let t78 = r0_y * w_x - r0_x * w_y;
        let t79 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t80 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t81 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t82 = w_y * t78 - w_z * t77 + t79;
        let t83 = w_z * t76 - w_x * t78 + t80;
        let t84 = w_x * t77 - w_y * t76 + t81;
        let t85 = s0_z * w_y - s0_y * w_z;
        let t86 = s0_x * w_z - s0_z * w_x;
        let t87 = s0_y * w_x - s0_x * w_y;
        let t88 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t89 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t90 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t91 = w_y * t87 - w_z * t86 + t88;
        let t92 = w_z * t85 - w_x * t87 + t89;
        let t93 = w_x * t86 - w_y * t85 + t90;
        let t94 = r1_z * w_y - r1_y * w_z;
        let t95 = r1_x * w_z - r1_z * w_x;
        let t96 = r1_y * w_x - r1_x * w_y;
        let t97 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t98 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t99 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t100 = w_y * t96 - w_z * t95 + t97;
        let t101 = w_z * t94 - w_x * t96 + t98;
        let t102 = w_x * t95 - w_y * t94 + t99;
        let t103 = s1_z * w_y - s1_y * w_z;
        let t104 = s1_x * w_z - s1_z * w_x;
        let t105 = s1_y * w_x - s1_x * w_y;
        let t106 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t107 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t108 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t109 = w_y * t105 - w_z * t104 + t106;
        let t110 = w_z * t103 - w_x * t105 + t107;
        let t111 = w_x * t104 - w_y * t103 + t108;
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
        let t121 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t122 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t123 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t124 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t125 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t126 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        let t127 = w_y * t117;
        let t128 = w_z * t116;
        let t129 = t127 - t128;
        let t130 = w_z * t115;
        let t131 = w_x * t117;
        let t132 = t130 - t131;
        let t133 = w_x * t116;
        let t134 = w_y * t115;
        let t135 = t133 - t134;
        let t136 = moment_r0 * e_x;
        let t137 = moment_r0 * e_y;
        let t138 = moment_r0 * e_z;
        let t139 = w_y * t120;
        let t140 = w_z * t119;
        let t141 = t139 - t140;
        let t142 = w_z * t118;
        let t143 = w_x * t120;
        let t144 = t142 - t143;
        let t145 = w_x * t119;
        let t146 = w_y * t118;
        let t147 = t145 - t146;
        let t148 = w_y * t123;
        let t149 = w_z * t122;
        let t150 = t148 - t149;
        let t151 = w_z * t121;
        let t152 = w_x * t123;
        let t153 = t151 - t152;
        let t154 = w_x * t122;
        let t155 = w_y * t121;
        let t156 = t154 - t155;
        let t157 = w_y * t126;
        let t158 = w_z * t125;
        let t159 = t157 - t158;
        let t160 = w_z * t124;
        let t161 = w_x * t126;
        let t162 = t160 - t161;
        let t163 = w_x * t125;
        let t164 = w_y * t124;
        let t165 = t163 - t164;
        let t166 = r0_y * t116;
        let t167 = r0_z * t117;
        let t168 = s0_y * t119;
        let t169 = s0_z * t120;
        let t170 = r1_y * t122;
        let t171 = r1_z * t123;
        let t172 = s1_y * t125;
        let t173 = s1_z * t126;
        let t174 = r0_x * t115;
        let t175 = s0_x * t118;
        let t176 = r1_x * t121;
        let t177 = s1_x * t124;
        let t178 = w_y * t116;
        let t179 = w_z * t117;
        let t180 = t178 + t179;
        let t181 = w_y * t122;
        let t182 = w_z * t123;
        let t183 = t181 + t182;
        let t184 = 2.0
            * (mass_r0_r0 * v_r0_z + mass_r0_s0 * v_s0_z + mass_r0_r1 * v_r1_z
                + mass_r0_s1 * v_s1_z);
        let t185 = t184 + (t135 - t134);
        let t186 = 2.0
            * (mass_r0_r1 * v_r0_z + mass_s0_r1 * v_s0_z + mass_r0_r0 * v_r1_z
                + mass_r1_s1 * v_s1_z);
        let t187 = t186 + (t156 - t155);
        let t188 = 2.0
            * (mass_r0_r0 * v_r0_y + mass_r0_s0 * v_s0_y + mass_r0_r1 * v_r1_y
                + mass_r0_s1 * v_s1_y);
        let t189 = t188 + (t130 + t132);
        let t190 = 2.0
            * (mass_r0_r1 * v_r0_y + mass_s0_r1 * v_s0_y + mass_r0_r0 * v_r1_y
                + mass_r1_s1 * v_s1_y);
        let t191 = t190 + (t151 + t153);
        let t192 = t184 + (t133 + t135);
        let t193 = t186 + (t154 + t156);
        let t194 = w_x * t115;
        let t195 = t179 + t194;
        let t196 = w_x * t121;
        let t197 = t182 + t196;
        let t198 = 2.0
            * (mass_r0_r0 * v_r0_x + mass_r0_s0 * v_s0_x + mass_r0_r1 * v_r1_x
                + mass_r0_s1 * v_s1_x);
        let t199 = t198 + (t129 - t128);
        let t200 = 2.0
            * (mass_r0_r1 * v_r0_x + mass_s0_r1 * v_s0_x + mass_r0_r0 * v_r1_x
                + mass_r1_s1 * v_s1_x);
        let t201 = t200 + (t150 - t149);
        let t202 = t188 + (t132 - t131);
        let t203 = t190 + (t153 - t152);
        let t204 = t198 + (t127 + t129);
        let t205 = t200 + (t148 + t150);
        let t206 = t178 + t194;
        let t207 = t181 + t196;
        let t208 = 2.0
            * (mass_r0_s0 * v_r0_z + mass_s0_s0 * v_s0_z + mass_s0_r1 * v_r1_z
                + mass_s0_s1 * v_s1_z);
        let t209 = 2.0
            * (mass_r0_s0 * v_r0_y + mass_s0_s0 * v_s0_y + mass_s0_r1 * v_r1_y
                + mass_s0_s1 * v_s1_y);
        let t210 = t208 + (t145 + t147);
        let t211 = t209 + (t144 - t143);
        let t212 = r0_y * t202 + r0_z * t192 + (s0_y * t211 + s0_z * t210)
            + (r1_y * t203 + r1_z * t193);
        let t213 = 2.0
            * (mass_r0_s1 * v_r0_z + mass_s0_s1 * v_s0_z + mass_r1_s1 * v_r1_z
                + mass_s0_s0 * v_s1_z);
        let t214 = 2.0
            * (mass_r0_s1 * v_r0_y + mass_s0_s1 * v_s0_y + mass_r1_s1 * v_r1_y
                + mass_s0_s0 * v_s1_y);
        let t215 = t213 + (t163 + t165);
        let t216 = t214 + (t162 - t161);
        let t217 = 2.0
            * (mass_r0_s0 * v_r0_x + mass_s0_s0 * v_s0_x + mass_s0_r1 * v_r1_x
                + mass_s0_s1 * v_s1_x);
        let t218 = w_z * t120;
        let t219 = w_x * t118;
        let t220 = t218 + t219;
        let t221 = t217 + (t139 + t141);
        let t222 = r0_y * t204 + r0_z * t195 + (s0_y * t221 + s0_z * t220)
            + (r1_y * t205 + r1_z * t197);
        let t223 = 2.0
            * (mass_r0_s1 * v_r0_x + mass_s0_s1 * v_s0_x + mass_r1_s1 * v_r1_x
                + mass_s0_s0 * v_s1_x);
        let t224 = w_z * t126;
        let t225 = w_x * t124;
        let t226 = t224 + t225;
        let t227 = t223 + (t157 + t159);
        let t228 = w_y * t119;
        let t229 = t219 + t228;
        let t230 = t217 + (t141 - t140);
        let t231 = r0_y * t206 - r0_z * t199 + (s0_y * t229 - s0_z * t230)
            + (r1_y * t207 - r1_z * t201);
        let t232 = w_y * t125;
        let t233 = t225 + t232;
        let t234 = t223 + (t159 - t158);
        let t235 = t218 + t228;
        let t236 = r0_z * t180 - r0_x * t202 + (s0_z * t235 - s0_x * t211)
            + (r1_z * t183 - r1_x * t203);
        let t237 = t224 + t232;
        let t238 = t208 + (t147 - t146);
        let t239 = r0_z * t185 + r0_x * t204 + (s0_z * t238 + s0_x * t221)
            + (r1_z * t187 + r1_x * t205);
        let t240 = t213 + (t165 - t164);
        let t241 = t209 + (t142 + t144);
        let t242 = r0_z * t189 + r0_x * t206 + (s0_z * t241 + s0_x * t229)
            + (r1_z * t191 + r1_x * t207);
        let t243 = t214 + (t160 + t162);
        let t244 = r0_x * t192 + r0_y * t180 + (s0_x * t210 + s0_y * t235)
            + (r1_x * t193 + r1_y * t183);
        let t245 = r0_x * t195 - r0_y * t185 + (s0_x * t220 - s0_y * t238)
            + (r1_x * t197 - r1_y * t187);
        let t246 = r0_x * t199 + r0_y * t189 + (s0_x * t230 + s0_y * t241)
            + (r1_x * t201 + r1_y * t191);
        let t247 = w_z * 2.0;
        let t248 = moment_r0 * t247;
        let t249 = w_y * 2.0;
        let t250 = moment_r0 * t249;
        let t251 = moment_s0 * t247;
        let t252 = moment_s0 * t249;
        let t253 = moment_s1 * t247;
        let t254 = moment_s1 * t249;
        let t255 = w_x * 2.0;
        let t256 = moment_r0 * t255;
        let t257 = moment_s0 * t255;
        let t258 = moment_s1 * t255;
        let t259 = t116 * t249;
        let t260 = t117 * t247;
        let t261 = t119 * t249;
        let t262 = t120 * t247;
        let t263 = t122 * t249;
        let t264 = t123 * t247;
        let t265 = t125 * t249;
        let t266 = t126 * t247;
        let t267 = t115 * t255;
        let t268 = t118 * t255;
        let t269 = t121 * t255;
        let t270 = t124 * t255;
        let t271 = w_y * w_y;
        let t272 = w_z * w_z;
        let t273 = t271 + t272;
        let t274 = -moment_r0 * t273;
        let t275 = w_x * w_y;
        let t276 = t275 - dw_z;
        let t277 = moment_r0 * t276;
        let t278 = w_x * w_z;
        let t279 = dw_y + t278;
        let t280 = moment_r0 * t279;
        let t281 = dw_z + t275;
        let t282 = moment_r0 * t281;
        let t283 = w_x * w_x;
        let t284 = t272 + t283;
        let t285 = -moment_r0 * t284;
        let t286 = w_y * w_z;
        let t287 = t286 - dw_x;
        let t288 = moment_r0 * t287;
        let t289 = t278 - dw_y;
        let t290 = moment_r0 * t289;
        let t291 = dw_x + t286;
        let t292 = moment_r0 * t291;
        let t293 = t271 + t283;
        let t294 = -moment_r0 * t293;
        let t295 = mass_r0_r0 * t84;
        let t296 = mass_r0_s0 * t93;
        let t297 = mass_r0_r1 * t102;
        let t298 = mass_r0_s1 * t111;
        let t299 = mass_r0_r0 * t83;
        let t300 = mass_r0_s0 * t92;
        let t301 = mass_r0_r1 * t101;
        let t302 = mass_r0_s1 * t110;
        let t303 = moment_s0 * e_z + mass_r0_s0 * t84;
        let t304 = mass_s0_s0 * t93;
        let t305 = mass_s0_r1 * t102;
        let t306 = mass_s0_s1 * t111;
        let t307 = moment_s0 * e_y + mass_r0_s0 * t83;
        let t308 = mass_s0_s0 * t92;
        let t309 = mass_s0_r1 * t101;
        let t310 = mass_s0_s1 * t110;
        let t311 = t138 + mass_r0_r1 * t84 + mass_s0_r1 * t93;
        let t312 = mass_r0_r0 * t102;
        let t313 = mass_r1_s1 * t111;
        let t314 = t137 + mass_r0_r1 * t83 + mass_s0_r1 * t92;
        let t315 = mass_r0_r0 * t101;
        let t316 = mass_r1_s1 * t110;
        let t317 = moment_s1 * e_z + mass_r0_s1 * t84 + mass_s0_s1 * t93
            + mass_r1_s1 * t102;
        let t318 = mass_s0_s0 * t111;
        let t319 = moment_s1 * e_y + mass_r0_s1 * t83 + mass_s0_s1 * t92
            + mass_r1_s1 * t101;
        let t320 = mass_s0_s0 * t110;
        let t321 = mass_r0_r0 * t82;
        let t322 = mass_r0_s0 * t91;
        let t323 = mass_r0_r1 * t100;
        let t324 = mass_r0_s1 * t109;
        let t325 = moment_s0 * e_x + mass_r0_s0 * t82;
        let t326 = mass_s0_s0 * t91;
        let t327 = mass_s0_r1 * t100;
        let t328 = mass_s0_s1 * t109;
        let t329 = t136 + mass_r0_r1 * t82 + mass_s0_r1 * t91;
        let t330 = mass_r0_r0 * t100;
        let t331 = mass_r1_s1 * t109;
        let t332 = moment_s1 * e_x + mass_r0_s1 * t82 + mass_s0_s1 * t91
            + mass_r1_s1 * t100;
        let t333 = mass_s0_s0 * t109;
        mass[0] = element_mass;
        mass[4] = t114;
        mass[5] = -t113;
        mass[6] = moment_r0;
        mass[9] = moment_s0;
        mass[12] = moment_r0;
        mass[15] = moment_s1;
        mass[19] = element_mass;
        mass[21] = -t114;
        mass[23] = t112;
        mass[25] = moment_r0;
        mass[28] = moment_s0;
        mass[31] = moment_r0;
        mass[34] = moment_s1;
        mass[38] = element_mass;
        mass[39] = t113;
        mass[40] = -t112;
        mass[44] = moment_r0;
        mass[47] = moment_s0;
        mass[50] = moment_r0;
        mass[53] = moment_s1;
        mass[55] = -t114;
        mass[56] = t113;
        mass[57] = t166 + t167 + (t168 + t169) + (t170 + t171) + (t172 + t173);
        mass[58] = -(r0_x * t116 + s0_x * t119 + r1_x * t122 + s1_x * t125);
        mass[59] = -(r0_x * t117 + s0_x * t120 + r1_x * t123 + s1_x * t126);
        mass[61] = -t117;
        mass[62] = t116;
        mass[64] = -t120;
        mass[65] = t119;
        mass[67] = -t123;
        mass[68] = t122;
        mass[70] = -t126;
        mass[71] = t125;
        mass[72] = t114;
        mass[74] = -t112;
        mass[75] = -(r0_y * t115 + s0_y * t118 + r1_y * t121 + s1_y * t124);
        mass[76] = t167 + t174 + (t169 + t175) + (t171 + t176) + (t173 + t177);
        mass[77] = -(r0_y * t117 + s0_y * t120 + r1_y * t123 + s1_y * t126);
        mass[78] = t117;
        mass[80] = -t115;
        mass[81] = t120;
        mass[83] = -t118;
        mass[84] = t123;
        mass[86] = -t121;
        mass[87] = t126;
        mass[89] = -t124;
        mass[90] = -t113;
        mass[91] = t112;
        mass[93] = -(r0_z * t115 + s0_z * t118 + r1_z * t121 + s1_z * t124);
        mass[94] = -(r0_z * t116 + s0_z * t119 + r1_z * t122 + s1_z * t125);
        mass[95] = t166 + t174 + (t168 + t175) + (t170 + t176) + (t172 + t177);
        mass[96] = -t116;
        mass[97] = t115;
        mass[99] = -t119;
        mass[100] = t118;
        mass[102] = -t122;
        mass[103] = t121;
        mass[105] = -t125;
        mass[106] = t124;
        damping[0] = t180 + t183;
        damping[1] = t185 + t187;
        damping[2] = -(t189 + t191);
        damping[15] = -(t192 + t193);
        damping[16] = t195 + t197;
        damping[17] = t199 + t201;
        damping[30] = t202 + t203;
        damping[31] = -(t204 + t205);
        damping[32] = t206 + t207;
        damping[45] = t212 + (s1_y * t216 + s1_z * t215);
        damping[46] = -(t222 + (s1_y * t227 + s1_z * t226));
        damping[47] = t231 + (s1_y * t233 - s1_z * t234);
        damping[60] = t236 + (s1_z * t237 - s1_x * t216);
        damping[61] = t239 + (s1_z * t240 + s1_x * t227);
        damping[62] = -(t242 + (s1_z * t243 + s1_x * t233));
        damping[75] = -(t244 + (s1_x * t215 + s1_y * t237));
        damping[76] = t245 + (s1_x * t226 - s1_y * t240);
        damping[77] = t246 + (s1_x * t234 + s1_y * t243);
        damping[4] = -t248;
        damping[5] = t250;
        damping[7] = -t251;
        damping[8] = t252;
        damping[10] = -t248;
        damping[11] = t250;
        damping[13] = -t253;
        damping[14] = t254;
        damping[18] = t248;
        damping[20] = -t256;
        damping[21] = t251;
        damping[23] = -t257;
        damping[24] = t248;
        damping[26] = -t256;
        damping[27] = t253;
        damping[29] = -t258;
        damping[33] = -t250;
        damping[34] = t256;
        damping[36] = -t252;
        damping[37] = t257;
        damping[39] = -t250;
        damping[40] = t256;
        damping[42] = -t254;
        damping[43] = t258;
        damping[48] = -(t259 + t260);
        damping[49] = t116 * t255;
        damping[50] = t117 * t255;
        damping[51] = -(t261 + t262);
        damping[52] = t119 * t255;
        damping[53] = t120 * t255;
        damping[54] = -(t263 + t264);
        damping[55] = t122 * t255;
        damping[56] = t123 * t255;
        damping[57] = -(t265 + t266);
        damping[58] = t125 * t255;
        damping[59] = t126 * t255;
        damping[63] = t115 * t249;
        damping[64] = -(t260 + t267);
        damping[65] = t117 * t249;
        damping[66] = t118 * t249;
        damping[67] = -(t262 + t268);
        damping[68] = t120 * t249;
        damping[69] = t121 * t249;
        damping[70] = -(t264 + t269);
        damping[71] = t123 * t249;
        damping[72] = t124 * t249;
        damping[73] = -(t266 + t270);
        damping[74] = t126 * t249;
        damping[78] = t115 * t247;
        damping[79] = t116 * t247;
        damping[80] = -(t259 + t267);
        damping[81] = t118 * t247;
        damping[82] = t119 * t247;
        damping[83] = -(t261 + t268);
        damping[84] = t121 * t247;
        damping[85] = t122 * t247;
        damping[86] = -(t263 + t269);
        damping[87] = t124 * t247;
        damping[88] = t125 * t247;
        damping[89] = -(t265 + t270);
        spin[0] = t180;
        spin[1] = t185;
        spin[2] = -t189;
        spin[3] = -t192;
        spin[4] = t195;
        spin[5] = t199;
        spin[6] = t202;
        spin[7] = -t204;
        spin[8] = t206;
        spin[9] = t235;
        spin[10] = t238;
        spin[11] = -t241;
        spin[12] = -t210;
        spin[13] = t220;
        spin[14] = t230;
        spin[15] = t211;
        spin[16] = -t221;
        spin[17] = t229;
        spin[18] = t183;
        spin[19] = t187;
        spin[20] = -t191;
        spin[21] = -t193;
        spin[22] = t197;
        spin[23] = t201;
        spin[24] = t203;
        spin[25] = -t205;
        spin[26] = t207;
        spin[27] = t237;
        spin[28] = t240;
        spin[29] = -t243;
        spin[30] = -t215;
        spin[31] = t226;
        spin[32] = t234;
        spin[33] = t216;
        spin[34] = -t227;
        spin[35] = t233;
        stiffness[0] = t274;
        stiffness[1] = t277;
        stiffness[2] = t280;
        stiffness[3] = -moment_s0 * t273;
        stiffness[4] = moment_s0 * t276;
        stiffness[5] = moment_s0 * t279;
        stiffness[6] = t274;
        stiffness[7] = t277;
        stiffness[8] = t280;
        stiffness[9] = -moment_s1 * t273;
        stiffness[10] = moment_s1 * t276;
        stiffness[11] = moment_s1 * t279;
        stiffness[12] = t282;
        stiffness[13] = t285;
        stiffness[14] = t288;
        stiffness[15] = moment_s0 * t281;
        stiffness[16] = -moment_s0 * t284;
        stiffness[17] = moment_s0 * t287;
        stiffness[18] = t282;
        stiffness[19] = t285;
        stiffness[20] = t288;
        stiffness[21] = moment_s1 * t281;
        stiffness[22] = -moment_s1 * t284;
        stiffness[23] = moment_s1 * t287;
        stiffness[24] = t290;
        stiffness[25] = t292;
        stiffness[26] = t294;
        stiffness[27] = moment_s0 * t289;
        stiffness[28] = moment_s0 * t291;
        stiffness[29] = -moment_s0 * t293;
        stiffness[30] = t290;
        stiffness[31] = t292;
        stiffness[32] = t294;
        stiffness[33] = moment_s1 * t289;
        stiffness[34] = moment_s1 * t291;
        stiffness[35] = -moment_s1 * t293;
        stiffness[36] = t116 * t289 - t117 * t281;
        stiffness[37] = t138 + (t116 * t291 + t295 + t117 * t284) + t296 + t297 + t298;
        stiffness[38] = -(t137 + (t116 * t293 + (t117 * t287 + t299)) + t300 + t301
            + t302);
        stiffness[39] = t119 * t289 - t120 * t281;
        stiffness[40] = t303 + (t119 * t291 + t304 + t120 * t284) + t305 + t306;
        stiffness[41] = -(t307 + (t119 * t293 + (t120 * t287 + t308)) + t309 + t310);
        stiffness[42] = t122 * t289 - t123 * t281;
        stiffness[43] = t311 + (t122 * t291 + t312 + t123 * t284) + t313;
        stiffness[44] = -(t314 + (t122 * t293 + (t123 * t287 + t315)) + t316);
        stiffness[45] = t125 * t289 - t126 * t281;
        stiffness[46] = t317 + (t125 * t291 + t318 + t126 * t284);
        stiffness[47] = -(t319 + (t125 * t293 + (t126 * t287 + t320)));
        stiffness[48] = -(t298
            + (t297 + (t296 + (t138 + (t117 * t273 + (t295 + t115 * t289))))));
        stiffness[49] = t117 * t276 - t115 * t291;
        stiffness[50] = t136 + (t117 * t279 + t321 + t115 * t293) + t322 + t323 + t324;
        stiffness[51] = -(t306 + (t305 + (t303 + (t120 * t273 + (t304 + t118 * t289)))));
        stiffness[52] = t120 * t276 - t118 * t291;
        stiffness[53] = t325 + (t120 * t279 + t326 + t118 * t293) + t327 + t328;
        stiffness[54] = -(t313 + (t311 + (t123 * t273 + (t312 + t121 * t289))));
        stiffness[55] = t123 * t276 - t121 * t291;
        stiffness[56] = t329 + (t123 * t279 + t330 + t121 * t293) + t331;
        stiffness[57] = -(t317 + (t126 * t273 + (t318 + t124 * t289)));
        stiffness[58] = t126 * t276 - t124 * t291;
        stiffness[59] = t332 + (t126 * t279 + t333 + t124 * t293);
        stiffness[60] = t302
            + (t301 + (t300 + (t137 + (t299 + t115 * t281 + t116 * t273))));
        stiffness[61] = -(t324
            + (t323 + (t322 + (t136 + (t115 * t284 + (t321 + t116 * t276))))));
        stiffness[62] = t115 * t287 - t116 * t279;
        stiffness[63] = t310 + (t309 + (t307 + (t308 + t118 * t281 + t119 * t273)));
        stiffness[64] = -(t328 + (t327 + (t325 + (t118 * t284 + (t326 + t119 * t276)))));
        stiffness[65] = t118 * t287 - t119 * t279;
        stiffness[66] = t316 + (t314 + (t315 + t121 * t281 + t122 * t273));
        stiffness[67] = -(t331 + (t329 + (t121 * t284 + (t330 + t122 * t276))));
        stiffness[68] = t121 * t287 - t122 * t279;
        stiffness[69] = t319 + (t320 + t124 * t281 + t125 * t273);
        stiffness[70] = -(t332 + (t124 * t284 + (t333 + t125 * t276)));
        stiffness[71] = t124 * t287 - t125 * t279;
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
        let t17 = 1.0 / length;
        let t18 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t17;
        weights[1] = 1.0 + xi * (-4.0 + t18);
        weights[2] = t17 * (xi * (6.0 + xi * (-6.0)));
        weights[3] = xi * (t18 + (-2.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 8 multiplications, 2 divisions.
    pub fn cable_spatial_shapes_position_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 4],
    ) {
        let t17 = 1.0 / (length * length);
        let t18 = xi * 6.0;
        let t19 = 1.0 / length;
        weights[0] = (-6.0 + xi * 12.0) * t17;
        weights[1] = (-4.0 + t18) * t19;
        weights[2] = t17 * (6.0 + xi * (-12.0));
        weights[3] = t19 * (t18 + (-2.0));
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
        let t26 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2];
        let t27 = fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5];
        let t28 = 0.5 * (t26 - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t29 = EA * t28;
        let t30 = fields[0] * 2.0;
        let t31 = fields[1] * 2.0;
        let t32 = fields[2] * 2.0;
        let t33 = (fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5])
            * 2.0;
        forces[0] = t29 * (0.5 * t30) + EI * (0.5 * (t27 * t30 - fields[3] * t33));
        forces[1] = t29 * (0.5 * t31) + EI * (0.5 * (t27 * t31 - fields[4] * t33));
        forces[2] = t29 * (0.5 * t32) + EI * (0.5 * (t27 * t32 - fields[5] * t33));
        forces[3] = EI * (0.5 * (t26 * (fields[3] * 2.0) - fields[0] * t33));
        forces[4] = EI * (0.5 * (t26 * (fields[4] * 2.0) - fields[1] * t33));
        forces[5] = EI * (0.5 * (t26 * (fields[5] * 2.0) - fields[2] * t33));
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
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        force[0] += m * t51 + m_x * t60 + m * e_x;
        force[1] += m * t52 + m_x * t61 + m * e_y;
        force[2] += m * t53 + m_x * t62 + m * e_z;
        force[3] += m_x * t51 + p_xx * t60 + m_x * e_x;
        force[4] += m_x * t52 + p_xx * t61 + m_x * e_y;
        force[5] += m_x * t53 + p_xx * t62 + m_x * e_z;
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
        let t24 = w_y * w_y;
        let t25 = w_z * w_z;
        let t26 = t24 + t25;
        let t27 = w_x * w_y;
        let t28 = t27 - dw_z;
        let t29 = w_x * w_z;
        let t30 = dw_y + t29;
        let t31 = dw_z + t27;
        let t32 = w_x * w_x;
        let t33 = t25 + t32;
        let t34 = w_y * w_z;
        let t35 = t34 - dw_x;
        let t36 = t29 - dw_y;
        let t37 = dw_x + t34;
        let t38 = t24 + t32;
        let t39 = w_z * 2.0;
        let t40 = m * t39;
        let t41 = w_y * 2.0;
        let t42 = m * t41;
        let t43 = m_x * t39;
        let t44 = m_x * t41;
        let t45 = w_x * 2.0;
        let t46 = m * t45;
        let t47 = m_x * t45;
        let t48 = m_x * t39;
        let t49 = m_x * t41;
        let t50 = p_xx * t39;
        let t51 = p_xx * t41;
        let t52 = m_x * t45;
        let t53 = p_xx * t45;
        stiffness[0] += -m * t26;
        stiffness[1] += m * t28;
        stiffness[2] += m * t30;
        stiffness[3] += -m_x * t26;
        stiffness[4] += m_x * t28;
        stiffness[5] += m_x * t30;
        stiffness[6] += m * t31;
        stiffness[7] += -m * t33;
        stiffness[8] += m * t35;
        stiffness[9] += m_x * t31;
        stiffness[10] += -m_x * t33;
        stiffness[11] += m_x * t35;
        stiffness[12] += m * t36;
        stiffness[13] += m * t37;
        stiffness[14] += -m * t38;
        stiffness[15] += m_x * t36;
        stiffness[16] += m_x * t37;
        stiffness[17] += -m_x * t38;
        stiffness[18] += -m_x * t26;
        stiffness[19] += m_x * t28;
        stiffness[20] += m_x * t30;
        stiffness[21] += -p_xx * t26;
        stiffness[22] += p_xx * t28;
        stiffness[23] += p_xx * t30;
        stiffness[24] += m_x * t31;
        stiffness[25] += -m_x * t33;
        stiffness[26] += m_x * t35;
        stiffness[27] += p_xx * t31;
        stiffness[28] += -p_xx * t33;
        stiffness[29] += p_xx * t35;
        stiffness[30] += m_x * t36;
        stiffness[31] += m_x * t37;
        stiffness[32] += -m_x * t38;
        stiffness[33] += p_xx * t36;
        stiffness[34] += p_xx * t37;
        stiffness[35] += -p_xx * t38;
        damping_matrix[1] -= t40;
        damping_matrix[2] += t42;
        damping_matrix[4] -= t43;
        damping_matrix[5] += t44;
        damping_matrix[6] += t40;
        damping_matrix[8] -= t46;
        damping_matrix[9] += t43;
        damping_matrix[11] -= t47;
        damping_matrix[12] -= t42;
        damping_matrix[13] += t46;
        damping_matrix[15] -= t44;
        damping_matrix[16] += t47;
        damping_matrix[19] -= t48;
        damping_matrix[20] += t49;
        damping_matrix[22] -= t50;
        damping_matrix[23] += t51;
        damping_matrix[24] += t48;
        damping_matrix[26] -= t52;
        damping_matrix[27] += t50;
        damping_matrix[29] -= t53;
        damping_matrix[30] -= t49;
        damping_matrix[31] += t52;
        damping_matrix[33] -= t51;
        damping_matrix[34] += t53;
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
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        let t63 = m * r_x;
        let t64 = t63 + m_x * s_x;
        let t65 = m * r_y;
        let t66 = t65 + m_x * s_y;
        let t67 = m * r_z;
        let t68 = t67 + m_x * s_z;
        let t69 = t63 + m_x * s_x;
        let t70 = t65 + m_x * s_y;
        let t71 = t67 + m_x * s_z;
        let t72 = m_x * r_x + p_xx * s_x;
        let t73 = m_x * r_y + p_xx * s_y;
        let t74 = m_x * r_z + p_xx * s_z;
        let t75 = e_z * t66 - e_y * t68 + (t53 * t70 - t52 * t71)
            + (t62 * t73 - t61 * t74);
        let t76 = e_x * t68 - e_z * t64 + (t51 * t71 - t53 * t69)
            + (t60 * t74 - t62 * t72);
        let t77 = e_y * t64 - e_x * t66 + (t52 * t69 - t51 * t70)
            + (t61 * t72 - t60 * t73);
        out[0] += m * t51 + m_x * t60 + m * e_x;
        out[1] += m * t52 + m_x * t61 + m * e_y;
        out[2] += m * t53 + m_x * t62 + m * e_z;
        out[3] += t75;
        out[4] += t76;
        out[5] += t77;
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
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        let t63 = m * t51;
        let t64 = m_x * t60;
        let t65 = m * t52;
        let t66 = m_x * t61;
        let t67 = m * t53;
        let t68 = m_x * t62;
        let t69 = m * e_x;
        let t70 = m * e_y;
        let t71 = m * e_z;
        let t72 = m * r_x;
        let t73 = t72 + m_x * s_x;
        let t74 = m * r_y;
        let t75 = t74 + m_x * s_y;
        let t76 = m * r_z;
        let t77 = t76 + m_x * s_z;
        let t78 = t72 + m_x * s_x;
        let t79 = t74 + m_x * s_y;
        let t80 = t76 + m_x * s_z;
        let t81 = p_xx * s_x;
        let t82 = m_x * r_x + t81;
        let t83 = p_xx * s_y;
        let t84 = m_x * r_y + t83;
        let t85 = p_xx * s_z;
        let t86 = m_x * r_z + t85;
        let t87 = w_y * t77;
        let t88 = w_z * t75;
        let t89 = t87 - t88;
        let t90 = w_z * t73;
        let t91 = w_x * t77;
        let t92 = t90 - t91;
        let t93 = w_x * t75;
        let t94 = w_y * t73;
        let t95 = t93 - t94;
        let t96 = t81 + m_x * r_x;
        let t97 = t83 + m_x * r_y;
        let t98 = t85 + m_x * r_z;
        let t99 = w_y * t98;
        let t100 = w_z * t97;
        let t101 = t99 - t100;
        let t102 = w_z * t96;
        let t103 = w_x * t98;
        let t104 = t102 - t103;
        let t105 = w_x * t97;
        let t106 = w_y * t96;
        let t107 = t105 - t106;
        let t108 = r_y * t79;
        let t109 = r_z * t80;
        let t110 = s_y * t84;
        let t111 = s_z * t86;
        let t112 = r_x * t78;
        let t113 = s_x * t82;
        let t114 = w_y * t75;
        let t115 = w_z * t77;
        let t116 = t114 + t115;
        let t117 = 2.0 * (m * v_r_z + m_x * v_s_z);
        let t118 = t117 + (t95 - t94);
        let t119 = 2.0 * (m * v_r_y + m_x * v_s_y);
        let t120 = t119 + (t90 + t92);
        let t121 = t117 + (t93 + t95);
        let t122 = w_x * t73;
        let t123 = t115 + t122;
        let t124 = 2.0 * (m * v_r_x + m_x * v_s_x);
        let t125 = t124 + (t89 - t88);
        let t126 = t119 + (t92 - t91);
        let t127 = t124 + (t87 + t89);
        let t128 = t114 + t122;
        let t129 = 2.0 * (m_x * v_r_z + p_xx * v_s_z);
        let t130 = 2.0 * (m_x * v_r_y + p_xx * v_s_y);
        let t131 = t129 + (t105 + t107);
        let t132 = t130 + (t104 - t103);
        let t133 = 2.0 * (m_x * v_r_x + p_xx * v_s_x);
        let t134 = w_z * t98;
        let t135 = w_x * t96;
        let t136 = t134 + t135;
        let t137 = t133 + (t99 + t101);
        let t138 = w_y * t97;
        let t139 = t135 + t138;
        let t140 = t133 + (t101 - t100);
        let t141 = t134 + t138;
        let t142 = t129 + (t107 - t106);
        let t143 = t130 + (t102 + t104);
        let t144 = w_z * 2.0;
        let t145 = m * t144;
        let t146 = w_y * 2.0;
        let t147 = m * t146;
        let t148 = m_x * t144;
        let t149 = m_x * t146;
        let t150 = w_x * 2.0;
        let t151 = m * t150;
        let t152 = m_x * t150;
        let t153 = t79 * t146;
        let t154 = t80 * t144;
        let t155 = t84 * t146;
        let t156 = t86 * t144;
        let t157 = t78 * t150;
        let t158 = t82 * t150;
        let t159 = w_y * w_y;
        let t160 = w_z * w_z;
        let t161 = t159 + t160;
        let t162 = w_x * w_y;
        let t163 = t162 - dw_z;
        let t164 = w_x * w_z;
        let t165 = dw_y + t164;
        let t166 = dw_z + t162;
        let t167 = w_x * w_x;
        let t168 = t160 + t167;
        let t169 = w_y * w_z;
        let t170 = t169 - dw_x;
        let t171 = t164 - dw_y;
        let t172 = dw_x + t169;
        let t173 = t159 + t167;
        let t174 = m_x * e_z + m_x * t53;
        let t175 = p_xx * t62;
        let t176 = m_x * e_y + m_x * t52;
        let t177 = p_xx * t61;
        let t178 = m_x * e_x + m_x * t51;
        let t179 = p_xx * t60;
        mass[0] = m;
        mass[4] = t77;
        mass[5] = -t75;
        mass[6] = m;
        mass[9] = m_x;
        mass[13] = m;
        mass[15] = -t77;
        mass[17] = t73;
        mass[19] = m;
        mass[22] = m_x;
        mass[26] = m;
        mass[27] = t75;
        mass[28] = -t73;
        mass[32] = m;
        mass[35] = m_x;
        mass[37] = -t77;
        mass[38] = t75;
        mass[39] = t108 + t109 + (t110 + t111);
        mass[40] = -(r_x * t79 + s_x * t84);
        mass[41] = -(r_x * t80 + s_x * t86);
        mass[43] = -t80;
        mass[44] = t79;
        mass[46] = -t86;
        mass[47] = t84;
        mass[48] = t77;
        mass[50] = -t73;
        mass[51] = -(r_y * t78 + s_y * t82);
        mass[52] = t109 + t112 + (t111 + t113);
        mass[53] = -(r_y * t80 + s_y * t86);
        mass[54] = t80;
        mass[56] = -t78;
        mass[57] = t86;
        mass[59] = -t82;
        mass[60] = -t75;
        mass[61] = t73;
        mass[63] = -(r_z * t78 + s_z * t82);
        mass[64] = -(r_z * t79 + s_z * t84);
        mass[65] = t108 + t112 + (t110 + t113);
        mass[66] = -t79;
        mass[67] = t78;
        mass[69] = -t84;
        mass[70] = t82;
        damping[0] = t116;
        damping[1] = t118;
        damping[2] = -t120;
        damping[9] = -t121;
        damping[10] = t123;
        damping[11] = t125;
        damping[18] = t126;
        damping[19] = -t127;
        damping[20] = t128;
        damping[27] = r_y * t126 + r_z * t121 + (s_y * t132 + s_z * t131);
        damping[28] = -(r_y * t127 + r_z * t123 + (s_y * t137 + s_z * t136));
        damping[29] = r_y * t128 - r_z * t125 + (s_y * t139 - s_z * t140);
        damping[36] = r_z * t116 - r_x * t126 + (s_z * t141 - s_x * t132);
        damping[37] = r_z * t118 + r_x * t127 + (s_z * t142 + s_x * t137);
        damping[38] = -(r_z * t120 + r_x * t128 + (s_z * t143 + s_x * t139));
        damping[45] = -(r_x * t121 + r_y * t116 + (s_x * t131 + s_y * t141));
        damping[46] = r_x * t123 - r_y * t118 + (s_x * t136 - s_y * t142);
        damping[47] = r_x * t125 + r_y * t120 + (s_x * t140 + s_y * t143);
        damping[4] = -t145;
        damping[5] = t147;
        damping[7] = -t148;
        damping[8] = t149;
        damping[12] = t145;
        damping[14] = -t151;
        damping[15] = t148;
        damping[17] = -t152;
        damping[21] = -t147;
        damping[22] = t151;
        damping[24] = -t149;
        damping[25] = t152;
        damping[30] = -(t153 + t154);
        damping[31] = t79 * t150;
        damping[32] = t80 * t150;
        damping[33] = -(t155 + t156);
        damping[34] = t84 * t150;
        damping[35] = t86 * t150;
        damping[39] = t78 * t146;
        damping[40] = -(t154 + t157);
        damping[41] = t80 * t146;
        damping[42] = t82 * t146;
        damping[43] = -(t156 + t158);
        damping[44] = t86 * t146;
        damping[48] = t78 * t144;
        damping[49] = t79 * t144;
        damping[50] = -(t153 + t157);
        damping[51] = t82 * t144;
        damping[52] = t84 * t144;
        damping[53] = -(t155 + t158);
        spin[0] = t116;
        spin[1] = t118;
        spin[2] = -t120;
        spin[3] = -t121;
        spin[4] = t123;
        spin[5] = t125;
        spin[6] = t126;
        spin[7] = -t127;
        spin[8] = t128;
        spin[9] = t141;
        spin[10] = t142;
        spin[11] = -t143;
        spin[12] = -t131;
        spin[13] = t136;
        spin[14] = t140;
        spin[15] = t132;
        spin[16] = -t137;
        spin[17] = t139;
        stiffness[0] = -m * t161;
        stiffness[1] = m * t163;
        stiffness[2] = m * t165;
        stiffness[3] = -m_x * t161;
        stiffness[4] = m_x * t163;
        stiffness[5] = m_x * t165;
        stiffness[6] = m * t166;
        stiffness[7] = -m * t168;
        stiffness[8] = m * t170;
        stiffness[9] = m_x * t166;
        stiffness[10] = -m_x * t168;
        stiffness[11] = m_x * t170;
        stiffness[12] = m * t171;
        stiffness[13] = m * t172;
        stiffness[14] = -m * t173;
        stiffness[15] = m_x * t171;
        stiffness[16] = m_x * t172;
        stiffness[17] = -m_x * t173;
        stiffness[18] = t79 * t171 - t80 * t166;
        stiffness[19] = t68 + (t71 + (t67 + t79 * t172 + t80 * t168));
        stiffness[20] = -(t66 + (t70 + (t79 * t173 + (t65 + t80 * t170))));
        stiffness[21] = t84 * t171 - t86 * t166;
        stiffness[22] = t174 + (t84 * t172 + t175 + t86 * t168);
        stiffness[23] = -(t176 + (t84 * t173 + (t86 * t170 + t177)));
        stiffness[24] = -(t68 + (t71 + (t80 * t161 + (t67 + t78 * t171))));
        stiffness[25] = t80 * t163 - t78 * t172;
        stiffness[26] = t64 + (t69 + (t63 + t80 * t165 + t78 * t173));
        stiffness[27] = -(t174 + (t86 * t161 + (t175 + t82 * t171)));
        stiffness[28] = t86 * t163 - t82 * t172;
        stiffness[29] = t178 + (t86 * t165 + t179 + t82 * t173);
        stiffness[30] = t66 + (t70 + (t65 + t78 * t166 + t79 * t161));
        stiffness[31] = -(t64 + (t69 + (t78 * t168 + (t63 + t79 * t163))));
        stiffness[32] = t78 * t170 - t79 * t165;
        stiffness[33] = t176 + (t177 + t82 * t166 + t84 * t161);
        stiffness[34] = -(t178 + (t82 * t168 + (t179 + t84 * t163)));
        stiffness[35] = t82 * t170 - t84 * t165;
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
        let t17 = x / model.radius;
        let t18 = t17.sin();
        let t19 = t17.cos();
        let t20 = 1.0 / model.radius;
        position[0][0] = model.radius * t18;
        position[0][1] = model.radius * (1.0 - t19);
        position[1][0] = model.radius * (t19 * t20);
        position[1][1] = model.radius * (t18 * t20);
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
        let t39 = z[3][0][0] * z[1][1][0] + z[1][0][0] * z[3][1][0]
            + (z[3][0][1] * z[1][1][1] + z[1][0][1] * z[3][1][1])
            + (z[3][0][2] * z[1][1][2] + z[1][0][2] * z[3][1][2]);
        let t40 = z[4][0][0] * z[1][1][0] + z[1][0][0] * z[4][1][0]
            + (z[4][0][1] * z[1][1][1] + z[1][0][1] * z[4][1][1])
            + (z[4][0][2] * z[1][1][2] + z[1][0][2] * z[4][1][2]);
        rows[0] = z[0][1][0] - z[2][1][0];
        rows[1] = z[0][1][1] - z[2][1][1];
        rows[2] = z[0][1][2] - z[2][1][2];
        rows[3] = t39;
        rows[4] = t40;
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
        let t48 = z[1][1][0] * z[3][1][0];
        let t49 = z[1][1][1] * z[3][1][1];
        let t50 = t48 + z[3][0][0] * z[1][2][0] + (t48 + z[1][0][0] * z[3][2][0])
            + (t49 + z[3][0][1] * z[1][2][1] + (t49 + z[1][0][1] * z[3][2][1]));
        let t51 = z[1][1][2] * z[3][1][2];
        let t52 = z[1][1][0] * z[4][1][0];
        let t53 = z[1][1][1] * z[4][1][1];
        let t54 = t52 + z[4][0][0] * z[1][2][0] + (t52 + z[1][0][0] * z[4][2][0])
            + (t53 + z[4][0][1] * z[1][2][1] + (t53 + z[1][0][1] * z[4][2][1]));
        let t55 = z[1][1][2] * z[4][1][2];
        rows[0] = z[0][2][0] - z[2][2][0];
        rows[1] = z[0][2][1] - z[2][2][1];
        rows[2] = z[0][2][2] - z[2][2][2];
        rows[3] = t50
            + (t51 + z[3][0][2] * z[1][2][2] + (t51 + z[1][0][2] * z[3][2][2]));
        rows[4] = t54
            + (t55 + z[4][0][2] * z[1][2][2] + (t55 + z[1][0][2] * z[4][2][2]));
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
        let t57 = z[3][1][0] * z[1][2][0];
        let t58 = z[1][1][0] * z[3][2][0];
        let t59 = t57 + t58;
        let t60 = z[3][1][1] * z[1][2][1];
        let t61 = z[1][1][1] * z[3][2][1];
        let t62 = t60 + t61;
        let t63 = t59 + (t57 + z[3][0][0] * z[1][3][0])
            + (t59 + (t58 + z[1][0][0] * z[3][3][0]))
            + (t62 + (t60 + z[3][0][1] * z[1][3][1])
                + (t62 + (t61 + z[1][0][1] * z[3][3][1])));
        let t64 = z[3][1][2] * z[1][2][2];
        let t65 = z[1][1][2] * z[3][2][2];
        let t66 = t64 + t65;
        let t67 = z[4][1][0] * z[1][2][0];
        let t68 = z[1][1][0] * z[4][2][0];
        let t69 = t67 + t68;
        let t70 = z[4][1][1] * z[1][2][1];
        let t71 = z[1][1][1] * z[4][2][1];
        let t72 = t70 + t71;
        let t73 = t69 + (t67 + z[4][0][0] * z[1][3][0])
            + (t69 + (t68 + z[1][0][0] * z[4][3][0]))
            + (t72 + (t70 + z[4][0][1] * z[1][3][1])
                + (t72 + (t71 + z[1][0][1] * z[4][3][1])));
        let t74 = z[4][1][2] * z[1][2][2];
        let t75 = z[1][1][2] * z[4][2][2];
        let t76 = t74 + t75;
        rows[0] = z[0][3][0] - z[2][3][0];
        rows[1] = z[0][3][1] - z[2][3][1];
        rows[2] = z[0][3][2] - z[2][3][2];
        rows[3] = t63
            + (t66 + (t64 + z[3][0][2] * z[1][3][2])
                + (t66 + (t65 + z[1][0][2] * z[3][3][2])));
        rows[4] = t73
            + (t76 + (t74 + z[4][0][2] * z[1][3][2])
                + (t76 + (t75 + z[1][0][2] * z[4][3][2])));
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
        let t33 = z[2][1][0] * (z[0][0][0] - z[1][0][0])
            + z[2][0][0] * (z[0][1][0] - z[1][1][0])
            + (z[2][1][1] * (z[0][0][1] - z[1][0][1])
                + z[2][0][1] * (z[0][1][1] - z[1][1][1]));
        rows[0] = t33
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
        let t42 = z[2][1][0] * (z[0][1][0] - z[1][1][0]);
        let t43 = z[2][1][1] * (z[0][1][1] - z[1][1][1]);
        let t44 = z[2][2][0] * (z[0][0][0] - z[1][0][0]) + t42
            + (t42 + z[2][0][0] * (z[0][2][0] - z[1][2][0]))
            + (z[2][2][1] * (z[0][0][1] - z[1][0][1]) + t43
                + (t43 + z[2][0][1] * (z[0][2][1] - z[1][2][1])));
        let t45 = z[2][1][2] * (z[0][1][2] - z[1][1][2]);
        rows[0] = t44
            + (z[2][2][2] * (z[0][0][2] - z[1][0][2]) + t45
                + (t45 + z[2][0][2] * (z[0][2][2] - z[1][2][2])));
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
        let t51 = z[2][2][0] * (z[0][1][0] - z[1][1][0]);
        let t52 = z[2][1][0] * (z[0][2][0] - z[1][2][0]);
        let t53 = t51 + t52;
        let t54 = z[2][3][0] * (z[0][0][0] - z[1][0][0]) + t51 + t53
            + (t53 + (t52 + z[2][0][0] * (z[0][3][0] - z[1][3][0])));
        let t55 = z[2][2][1] * (z[0][1][1] - z[1][1][1]);
        let t56 = z[2][1][1] * (z[0][2][1] - z[1][2][1]);
        let t57 = t55 + t56;
        let t58 = z[2][3][1] * (z[0][0][1] - z[1][0][1]) + t55 + t57
            + (t57 + (t56 + z[2][0][1] * (z[0][3][1] - z[1][3][1])));
        let t59 = z[2][2][2] * (z[0][1][2] - z[1][1][2]);
        let t60 = z[2][1][2] * (z[0][2][2] - z[1][2][2]);
        let t61 = t59 + t60;
        let t62 = z[2][3][2] * (z[0][0][2] - z[1][0][2]) + t59 + t61
            + (t61 + (t60 + z[2][0][2] * (z[0][3][2] - z[1][3][2])));
        rows[0] = t54 + t58 + t62;
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
        let t27 = ((observed[6] - observed[7]).powi(2)
            + (observed[8] - observed[9]).powi(2)
            + (observed[10] - observed[11]).powi(2))
            .sqrt();
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
        out[4] = observed[4];
        out[5] = observed[5];
        out[6] = t27;
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
            let [q, v, a]: [&[f64; 12]; 3] = [q, v, a].map(::rncf::mesh::array);
            let force = ::rncf::mesh::array_mut(force);
            cable_spatial_elastic_force(&self.row_cable, q, force);
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
            let [q, v]: [&[f64; 12]; 2] = [q, v].map(::rncf::mesh::array);
            let stiffness = ::rncf::mesh::array_mut(stiffness);
            let damping_matrix = ::rncf::mesh::array_mut(damping);
            cable_spatial_elastic_tangent(&self.row_cable, q, stiffness);
            if !absolute {
                cable_spatial_inertia_tangent(
                    &self.row_cable,
                    frame,
                    stiffness,
                    damping_matrix,
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
