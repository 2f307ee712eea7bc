//! Expansion of `models/src/spin_up_spatial.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// Spin-up manoeuvre of a flexible beam in space (Ren & Yang 2021, section 4.1.1).
#[derive(Clone, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct SpinUpSpatial {
    /// Steady angular velocity. (SI; declared in rad/s)
    pub omega_s: f64,
    /// Time to reach it. (SI; declared in s)
    pub T_s: f64,
    /// Number of elements. (count)
    pub elements: usize,
}
#[allow(clippy::all)]
impl Default for SpinUpSpatial {
    fn default() -> Self {
        Self {
            omega_s: 4.0,
            T_s: 15.0,
            elements: 6,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for SpinUpSpatial {
    const NAME: &'static str = "SpinUpSpatial";
    const DOC: &'static str = "Spin-up manoeuvre of a flexible beam in space (Ren & Yang 2021, section 4.1.1).";
    const SOURCE: &'static str = r#"pub model SpinUpSpatial {
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
        spatial;
        line from [0, 0, 0] m to [8, 0, 0] m;
        mesh elements * cable(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);

    /// Elongation of the tip in the frame.
    output u = beam.end.x - 8 m;
    /// Deflection of the tip in the plane of rotation.
    output v = beam.end.y;
    /// Deflection of the tip along the axis of rotation; zero by symmetry.
    output w = beam.end.z;

    run { t_end = 20 s; every = 0.05 s; }
}"#;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
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
                components: &[],
                doc: "Elongation of the tip in the frame.",
            },
            ::rncf::Output {
                name: "v",
                unit: "m",
                components: &[],
                doc: "Deflection of the tip in the plane of rotation.",
            },
            ::rncf::Output {
                name: "w",
                unit: "m",
                components: &[],
                doc: "Deflection of the tip along the axis of rotation; zero by symmetry.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_s,
            1 => self.T_s,
            2 => self.elements as f64,
            _ => panic!("SpinUpSpatial has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            _ => panic!("SpinUpSpatial has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
        };
        spin_up_spatial_equations::run_defaults(self, &mut run);
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
        let equations = spin_up_spatial_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
    }
}
/// Equations of [`SpinUpSpatial`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod spin_up_spatial_equations {
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
    /// Motion of frame `hub` and its first three derivatives.
    ///
    /// Operations: 9 additions, 17 multiplications, 6 divisions, 4 function calls.
    pub fn frame_hub(
        model: &super::SpinUpSpatial,
        t: f64,
        motion: &mut ::rncf::mesh::FrameMotion,
    ) {
        *motion = ::rncf::mesh::FrameMotion::INERTIAL;
        let t18 = model.omega_s / model.T_s;
        let t19 = (model.T_s / 6.283185307179586).powi(2);
        let t20 = t * 6.283185307179586 / model.T_s;
        let t21 = t20.cos();
        let theta = (if t <= model.T_s {
            t18 * (t * t / 2.0 + t19 * (t21 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = 6.283185307179586 / model.T_s;
        let t26 = t25 * t20.sin();
        let theta_t = (if t <= model.T_s {
            t18 * (t - t19 * t26)
        } else {
            model.omega_s
        });
        let theta_t_t = (if t <= model.T_s {
            t18 * (1.0 - t19 * (t25 * (t21 * t25)))
        } else {
            0.0
        });
        let theta_t_t_t = (if t <= model.T_s {
            t18 * (t19 * (t25 * (t25 * t26)))
        } else {
            0.0
        });
        motion.spin[2] = theta_t;
        motion.spin_rate[2] = theta_t_t;
        motion.spin_jerk[2] = theta_t_t_t;
        motion.rotation[0][0] = t23;
        motion.rotation[0][1] = -t24;
        motion.rotation[1][0] = t24;
        motion.rotation[1][1] = t23;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn joint_root_referenced_position(
        model: &super::SpinUpSpatial,
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
        model: &super::SpinUpSpatial,
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
        model: &super::SpinUpSpatial,
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
        model: &super::SpinUpSpatial,
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
        model: &super::SpinUpSpatial,
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
        model: &super::SpinUpSpatial,
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
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 17 additions, 24 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_position(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t33 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t33
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t35 = theta.cos();
        let t36 = theta.sin();
        let t37 = q[3] * (t35 * data.normals[0][0] - t36 * data.normals[0][1])
            + q[4] * (t36 * data.normals[0][0] + t35 * data.normals[0][1]);
        let t38 = q[3] * (t35 * data.normals[1][0] - t36 * data.normals[1][1])
            + q[4] * (t36 * data.normals[1][0] + t35 * data.normals[1][1]);
        rows[0] = q[0] - (t35 * data.point[0] - t36 * data.point[1]);
        rows[1] = q[1] - (t36 * data.point[0] + t35 * data.point[1]);
        rows[2] = q[2] - data.point[2];
        rows[3] = t37 + data.normals[0][2] * q[5];
        rows[4] = t38 + data.normals[1][2] * q[5];
    }
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 14 additions, 27 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_velocity(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t26 = model.omega_s / model.T_s;
        let t27 = (model.T_s / 6.283185307179586).powi(2);
        let t28 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t26 * (t * t / 2.0 + t27 * (t28.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t30 = (if t <= model.T_s {
            t26 * (t - t27 * (6.283185307179586 / model.T_s * t28.sin()))
        } else {
            model.omega_s
        });
        let t31 = theta.sin() * t30;
        let t32 = theta.cos() * t30;
        let t33 = q[4] * (data.normals[0][0] * t32 - data.normals[0][1] * t31)
            - q[3] * (data.normals[0][0] * t31 + data.normals[0][1] * t32);
        let t34 = q[4] * (data.normals[1][0] * t32 - data.normals[1][1] * t31)
            - q[3] * (data.normals[1][0] * t31 + data.normals[1][1] * t32);
        rows[0] = data.point[0] * t31 + data.point[1] * t32;
        rows[1] = data.point[1] * t31 - data.point[0] * t32;
        rows[2] = 0.0;
        rows[3] = t33;
        rows[4] = t34;
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 30 additions, 47 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_acceleration(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t28 = model.omega_s / model.T_s;
        let t29 = (model.T_s / 6.283185307179586).powi(2);
        let t30 = t * 6.283185307179586 / model.T_s;
        let t31 = t30.cos();
        let theta = (if t <= model.T_s {
            t28 * (t * t / 2.0 + t29 * (t31 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t33 = theta.cos();
        let t34 = theta.sin();
        let t35 = 6.283185307179586 / model.T_s;
        let t36 = (if t <= model.T_s {
            t28 * (t - t29 * (t35 * t30.sin()))
        } else {
            model.omega_s
        });
        let t37 = t34 * t36;
        let t38 = t33 * t36;
        let t39 = (if t <= model.T_s {
            t28 * (1.0 - t29 * (t35 * (t31 * t35)))
        } else {
            0.0
        });
        let t40 = t36 * t38 + t34 * t39;
        let t41 = t33 * t39 - t36 * t37;
        let t42 = v[3] * (data.normals[0][0] * t37 + data.normals[0][1] * t38);
        let t43 = v[4] * (data.normals[0][0] * t38 - data.normals[0][1] * t37);
        let t44 = v[3] * (data.normals[1][0] * t37 + data.normals[1][1] * t38);
        let t45 = v[4] * (data.normals[1][0] * t38 - data.normals[1][1] * t37);
        let t46 = t43
            + (t43 + q[4] * (data.normals[0][0] * t41 - data.normals[0][1] * t40))
            - (t42
                + (t42 + q[3] * (data.normals[0][0] * t40 + data.normals[0][1] * t41)));
        let t47 = t45
            + (t45 + q[4] * (data.normals[1][0] * t41 - data.normals[1][1] * t40))
            - (t44
                + (t44 + q[3] * (data.normals[1][0] * t40 + data.normals[1][1] * t41)));
        rows[0] = data.point[0] * t40 + data.point[1] * t41;
        rows[1] = data.point[1] * t40 - data.point[0] * t41;
        rows[2] = 0.0;
        rows[3] = t46;
        rows[4] = t47;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 53 additions, 69 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_jerk(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t30 = model.omega_s / model.T_s;
        let t31 = (model.T_s / 6.283185307179586).powi(2);
        let t32 = t * 6.283185307179586 / model.T_s;
        let t33 = t32.cos();
        let theta = (if t <= model.T_s {
            t30 * (t * t / 2.0 + t31 * (t33 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t35 = theta.cos();
        let t36 = theta.sin();
        let t37 = 6.283185307179586 / model.T_s;
        let t38 = t37 * t32.sin();
        let t39 = (if t <= model.T_s { t30 * (t - t31 * t38) } else { model.omega_s });
        let t40 = t36 * t39;
        let t41 = t35 * t39;
        let t42 = (if t <= model.T_s {
            t30 * (1.0 - t31 * (t37 * (t33 * t37)))
        } else {
            0.0
        });
        let t43 = t39 * t41 + t36 * t42;
        let t44 = t35 * t42 - t39 * t40;
        let t45 = (if t <= model.T_s { t30 * (t31 * (t37 * (t37 * t38))) } else { 0.0 });
        let t46 = t41 * t42;
        let t47 = t46 + t39 * t44 + (t46 + t36 * t45);
        let t48 = t40 * t42;
        let t49 = t35 * t45 - t48 - (t48 + t39 * t43);
        let t50 = a[3] * (data.normals[0][0] * t40 + data.normals[0][1] * t41);
        let t51 = v[3] * (data.normals[0][0] * t43 + data.normals[0][1] * t44);
        let t52 = t50 + t51;
        let t53 = a[4] * (data.normals[0][0] * t41 - data.normals[0][1] * t40);
        let t54 = v[4] * (data.normals[0][0] * t44 - data.normals[0][1] * t43);
        let t55 = t53 + t54;
        let t56 = t53 + t55
            + (t55
                + (t54 + q[4] * (data.normals[0][0] * t49 - data.normals[0][1] * t47)))
            - (t50 + t52
                + (t52
                    + (t51
                        + q[3]
                            * (data.normals[0][0] * t47 + data.normals[0][1] * t49))));
        let t57 = a[3] * (data.normals[1][0] * t40 + data.normals[1][1] * t41);
        let t58 = v[3] * (data.normals[1][0] * t43 + data.normals[1][1] * t44);
        let t59 = t57 + t58;
        let t60 = a[4] * (data.normals[1][0] * t41 - data.normals[1][1] * t40);
        let t61 = v[4] * (data.normals[1][0] * t44 - data.normals[1][1] * t43);
        let t62 = t60 + t61;
        let t63 = t60 + t62
            + (t62
                + (t61 + q[4] * (data.normals[1][0] * t49 - data.normals[1][1] * t47)))
            - (t57 + t59
                + (t59
                    + (t58
                        + q[3]
                            * (data.normals[1][0] * t47 + data.normals[1][1] * t49))));
        rows[0] = data.point[0] * t47 + data.point[1] * t49;
        rows[1] = data.point[1] * t47 - data.point[0] * t49;
        rows[2] = 0.0;
        rows[3] = t56;
        rows[4] = t63;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 8 additions, 14 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_jacobian(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        let t24 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t24
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t26 = theta.cos();
        let t27 = theta.sin();
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
        jacobian[21] = t26 * data.normals[0][0] - t27 * data.normals[0][1];
        jacobian[22] = t27 * data.normals[0][0] + t26 * data.normals[0][1];
        jacobian[23] = data.normals[0][2];
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
        jacobian[27] = t26 * data.normals[1][0] - t27 * data.normals[1][1];
        jacobian[28] = t27 * data.normals[1][0] + t26 * data.normals[1][1];
        jacobian[29] = data.normals[1][2];
    }
    /// Joint `root`: what it prescribes, with three derivatives.
    ///
    /// Operations: 33 additions, 61 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_prescribed(
        model: &super::SpinUpSpatial,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t24 = model.omega_s / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = t31 * t26.sin();
        let t33 = (if t <= model.T_s { t24 * (t - t25 * t32) } else { model.omega_s });
        let t34 = t30 * t33;
        let t35 = t29 * t33;
        let t36 = (if t <= model.T_s {
            t24 * (1.0 - t25 * (t31 * (t27 * t31)))
        } else {
            0.0
        });
        let t37 = t33 * t35 + t30 * t36;
        let t38 = t29 * t36 - t33 * t34;
        let t39 = (if t <= model.T_s { t24 * (t25 * (t31 * (t31 * t32))) } else { 0.0 });
        let t40 = t35 * t36;
        let t41 = t40 + t33 * t38 + (t40 + t30 * t39);
        let t42 = t34 * t36;
        let t43 = t29 * t39 - t42 - (t42 + t33 * t37);
        prescribed.position[0][0] = t29 * data.point[0] - t30 * data.point[1];
        prescribed.position[0][1] = t30 * data.point[0] + t29 * data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = -(data.point[0] * t34 + data.point[1] * t35);
        prescribed.position[1][1] = data.point[0] * t35 - data.point[1] * t34;
        prescribed.position[1][2] = 0.0;
        prescribed.position[2][0] = -(data.point[0] * t37 + data.point[1] * t38);
        prescribed.position[2][1] = data.point[0] * t38 - data.point[1] * t37;
        prescribed.position[2][2] = 0.0;
        prescribed.position[3][0] = -(data.point[0] * t41 + data.point[1] * t43);
        prescribed.position[3][1] = data.point[0] * t43 - data.point[1] * t41;
        prescribed.position[3][2] = 0.0;
        prescribed.slope[0][0] = t29 * data.tangent[0] - t30 * data.tangent[1];
        prescribed.slope[0][1] = t30 * data.tangent[0] + t29 * data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = -(data.tangent[0] * t34 + data.tangent[1] * t35);
        prescribed.slope[1][1] = data.tangent[0] * t35 - data.tangent[1] * t34;
        prescribed.slope[1][2] = 0.0;
        prescribed.slope[2][0] = -(data.tangent[0] * t37 + data.tangent[1] * t38);
        prescribed.slope[2][1] = data.tangent[0] * t38 - data.tangent[1] * t37;
        prescribed.slope[2][2] = 0.0;
        prescribed.slope[3][0] = -(data.tangent[0] * t41 + data.tangent[1] * t43);
        prescribed.slope[3][1] = data.tangent[0] * t43 - data.tangent[1] * t41;
        prescribed.slope[3][2] = 0.0;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &super::SpinUpSpatial, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn outputs(
        model: &super::SpinUpSpatial,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
        out[0] = observed[0] - 8.0;
        out[1] = observed[1];
        out[2] = observed[2];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &super::SpinUpSpatial, run: &mut ::rncf::RunDefaults) {
        run.t_end = 20.0;
        run.every = 0.05;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::SpinUpSpatial,
        pub row_beam: CableSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::SpinUpSpatial) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "beam",
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [8.0, 0.0, 0.0],
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
            ])
        }
        fn loads(&self) -> ::std::vec::Vec<::rncf::mesh::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([])
        }
        fn observed(&self) -> ::std::vec::Vec<::rncf::mesh::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
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
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
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
            ["inertial", "hub"][frame]
        }
        fn load_varies(&self, load: usize) -> bool {
            const VARIES: [bool; 0] = [];
            VARIES[load]
        }
        fn conservative(&self) -> bool {
            false
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 1];
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
                "material `aluminium`",
                "density",
                2766.67,
                "kg/m^3",
            )?;
            let young = ::rncf::mesh::positive(
                "material `aluminium`",
                "young",
                68950000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::mesh::poisson(
                "material `aluminium`",
                "poisson",
                0.3,
                "1",
            )?;
            let damping = ::rncf::mesh::non_negative(
                "material `aluminium`",
                "damping",
                0.0,
                "s",
            )?;
            let area = ::rncf::mesh::positive(
                "section `tube`",
                "area",
                7.299e-5,
                "m^2",
            )?;
            let second_moment = ::rncf::mesh::positive(
                "section `tube`",
                "second_moment",
                8.215e-9,
                "m^4",
            )?;
            self.row_beam = CableSpatial {
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
            frame_hub(&self.model, t, &mut motions[1]);
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
        fn mass(&self, body: usize, mass: &mut [f64]) {
            cable_spatial_mass(&self.row_beam, ::rncf::mesh::array_mut(mass));
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
            cable_spatial_elastic_force(&self.row_beam, q, force);
            if absolute {
                cable_spatial_absolute_inertia_force(&self.row_beam, frame, a, force);
            } else {
                cable_spatial_inertia_force(&self.row_beam, frame, q, v, a, force);
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
            cable_spatial_elastic_tangent(&self.row_beam, q, stiffness);
            if !absolute {
                cable_spatial_inertia_tangent(
                    &self.row_beam,
                    frame,
                    stiffness,
                    damping_matrix,
                );
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            cable_spatial_strain_energy(
                &self.row_beam,
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
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 1) => {
                    cable_spatial_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 2) => {
                    cable_spatial_shapes_position_2(
                        self.row_beam.length,
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
                area: 7.299e-5,
                second_moments: [8.215e-9, 8.215e-9],
                torsion_constant: 0.0,
                yield_stress: None,
                material: "aluminium",
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
                &self.row_beam,
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
                (0, _) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
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
                        ::rncf::system::ConstraintLevel::Velocity => {
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
                        ::rncf::system::ConstraintLevel::Acceleration => {
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
                        ::rncf::system::ConstraintLevel::Jerk => {
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
            data: &::rncf::mesh::JointData,
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
            data: &::rncf::mesh::JointData,
            prescribed: &mut ::rncf::mesh::Prescribed,
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
}
