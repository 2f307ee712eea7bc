//! Expansion of `models/src/andrews_squeezer.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use andrews_squeezer_equations::AndrewsSqueezer;
#[allow(clippy::all)]
impl Default for AndrewsSqueezer {
    fn default() -> Self {
        Self { torque: 0.033 }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for AndrewsSqueezer {
    const NAME: &'static str = "AndrewsSqueezer";
    const DOC: &'static str = "Andrews' squeezer: seven planar bodies, ten revolute joints, a motor and a spring. The crank makes two and\na half turns in 30 ms, while the triangle hardly moves.";
    const SOURCE: &'static str = r#"pub model AndrewsSqueezer {
    /// Torque of the motor on the crank.
    param torque = 0.033 N*m;

    // Angles at the start, which close all loops.
    const beta_0 = -0.0617138900142764496 rad;
    const gamma_0 = 0.455279819163070380 rad;
    const phi_0 = 0.222668390165885885 rad;
    const delta_0 = 0.487364979543842550 rad;
    const epsilon_0 = 1.23054744454982119 rad;

    // Lengths between joints, under their published names.
    const rr = 7 mm;
    const d = 28 mm;
    const ss = 35 mm;
    const e = 20 mm;
    const zt = 40 mm;
    const zf = 20 mm;
    const u = 40 mm;
    // Fixed points on the ground: A carries k5 and k7, B carries k3, the spring ends at C.
    const x_a = -69.34 mm;
    const y_a = -2.27 mm;
    const x_b = -36.35 mm;
    const y_b = 32.73 mm;

    /// Crank, turning about the origin.
    rigid k1 {
        plane xy;
        mass = 0.04325 kg;
        inertia = 2.194e-6 kg*m^2;
        center = [0.92, 0, 0] mm;
        angle = beta_0;
    }
    /// Rod from the crank's end to the point F, in which four bodies meet.
    rigid k2 {
        plane xy;
        mass = 0.00365 kg;
        inertia = 4.410e-7 kg*m^2;
        center = [-11.5, 0, 0] mm;
        origin = [rr * cos(beta_0), rr * sin(beta_0), 0];
        angle = beta_0;
    }
    /// Triangle on the ground's point B, which the spring pulls.
    rigid k3 {
        plane xy;
        mass = 0.02373 kg;
        inertia = 5.255e-6 kg*m^2;
        center = [10.43, -18.74, 0] mm;
        origin = [x_b, y_b, 0];
        angle = gamma_0;
    }
    /// Rod from k5 to F.
    rigid k4 {
        plane xy;
        mass = 0.00706 kg;
        inertia = 5.667e-7 kg*m^2;
        center = [0, -5.79, 0] mm;
        origin = [x_a + zt * cos(delta_0), y_a + zt * sin(delta_0), 0];
        angle = phi_0 + delta_0;
    }
    /// Lower arm on the ground's point A.
    rigid k5 {
        plane xy;
        mass = 0.07050 kg;
        inertia = 1.169e-5 kg*m^2;
        center = [23.08, 9.16, 0] mm;
        origin = [x_a, y_a, 0];
        angle = delta_0;
    }
    /// Rod from k7 to F.
    rigid k6 {
        plane xy;
        mass = 0.00706 kg;
        inertia = 5.667e-7 kg*m^2;
        center = [5.79, 0, 0] mm;
        origin = [x_a + u * sin(epsilon_0), y_a - u * cos(epsilon_0), 0];
        angle = epsilon_0 - phi_0;
    }
    /// Upper arm on the ground's point A.
    rigid k7 {
        plane xy;
        mass = 0.05498 kg;
        inertia = 1.912e-5 kg*m^2;
        center = [-4.49, -12.28, 0] mm;
        origin = [x_a, y_a, 0];
        angle = epsilon_0;
    }

    joint o = revolute(k1, inertial.at([0, 0, 0] m));
    joint a5 = revolute(k5, inertial.at([x_a, y_a, 0]));
    joint a7 = revolute(k7, inertial.at([x_a, y_a, 0]));
    joint b = revolute(k3, inertial.at([x_b, y_b, 0]));
    joint k = revolute(k1.at([rr, 0, 0]), k2.at([0, 0, 0] m));
    joint e54 = revolute(k5.at([zt, 0, 0]), k4.at([0, 0, 0] m));
    joint h76 = revolute(k7.at([0, -u, 0]), k6.at([0, 0, 0] m));
    joint f23 = revolute(k2.at([-d, 0, 0]), k3.at([0, -ss, 0]));
    joint f24 = revolute(k2.at([-d, 0, 0]), k4.at([0, -e, 0]));
    joint f26 = revolute(k2.at([-d, 0, 0]), k6.at([zf, 0, 0]));

    load motor = moment(k1, [0, 0, torque]);
    spring tension = linear(
        k3.at([20, -18, 0] mm), inertial.at([14, 72, 0] mm), stiffness = 4530 [N/m], length = 77.85 mm
    );

    /// Angle of the crank.
    output beta = k1.angle;
    /// Angle of k2 to the crank.
    output theta = k2.angle - k1.angle;
    /// Angle of the triangle.
    output gamma = k3.angle;
    /// Angle of k4 to k5.
    output phi = k4.angle - k5.angle;
    /// Angle of the lower arm.
    output delta = k5.angle;
    /// Angle of k6 to k7.
    output omega = k6.angle - k7.angle;
    /// Angle of the upper arm.
    output epsilon = k7.angle;

    run { t_end = 0.03 s; every = 0.1 ms; }
}"#;
    const EQUATIONS_HASH: u64 = 0xce7fc38ab890b968;
    const NOTES: &'static [&'static str] = &[
        "Rigid body `k1` is free in three motions: two positions and an angle.",
        "Rigid body `k2` is free in three motions: two positions and an angle.",
        "Rigid body `k3` is free in three motions: two positions and an angle.",
        "Rigid body `k4` is free in three motions: two positions and an angle.",
        "Rigid body `k5` is free in three motions: two positions and an angle.",
        "Rigid body `k6` is free in three motions: two positions and an angle.",
        "Rigid body `k7` is free in three motions: two positions and an angle.",
        "Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): 2 multipliers; linear in its vectors, no second derivatives.",
        "Force `tension`: a potential; its tangents are derived.",
        "Force `motor`: no potential; its tangents are derived.",
        "Not declared, so that no function is written for it: flexible bodies, fixtures, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as force `motor` has no potential.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "constraint_position_o",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_o",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_o",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_o",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "force_value_tension",
            additions: 4,
            multiplications: 5,
            divisions: 1,
            functions: 1,
            weighted: 33,
        },
        ::rncf::model::KernelCount {
            name: "force_tangent_tension",
            additions: 14,
            multiplications: 20,
            divisions: 6,
            functions: 1,
            weighted: 78,
        },
        ::rncf::model::KernelCount {
            name: "force_energy_tension",
            additions: 4,
            multiplications: 4,
            divisions: 0,
            functions: 1,
            weighted: 28,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "torque",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N m",
                unit_si: 1.0,
                dimension: [2, 1, -2, 0, 0, 0],
                default: 0.033,
                doc: "Torque of the motor on the crank.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "beta",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of the crank.",
            },
            ::rncf::Output {
                name: "theta",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of k2 to the crank.",
            },
            ::rncf::Output {
                name: "gamma",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of the triangle.",
            },
            ::rncf::Output {
                name: "phi",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of k4 to k5.",
            },
            ::rncf::Output {
                name: "delta",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of the lower arm.",
            },
            ::rncf::Output {
                name: "omega",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of k6 to k7.",
            },
            ::rncf::Output {
                name: "epsilon",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of the upper arm.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.torque,
            _ => panic!("AndrewsSqueezer has 1 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.torque = value,
            _ => panic!("AndrewsSqueezer has 1 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        andrews_squeezer_equations::run_defaults(self, &mut run);
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
        let equations = andrews_squeezer_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`AndrewsSqueezer`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod andrews_squeezer_equations {
    /// Andrews' squeezer: seven planar bodies, ten revolute joints, a motor and a spring. The crank makes two and
    /// a half turns in 30 ms, while the triangle hardly moves.
    ///
    /// # Chosen and left out
    ///
    /// * Rigid body `k1` is free in three motions: two positions and an angle.
    /// * Rigid body `k2` is free in three motions: two positions and an angle.
    /// * Rigid body `k3` is free in three motions: two positions and an angle.
    /// * Rigid body `k4` is free in three motions: two positions and an angle.
    /// * Rigid body `k5` is free in three motions: two positions and an angle.
    /// * Rigid body `k6` is free in three motions: two positions and an angle.
    /// * Rigid body `k7` is free in three motions: two positions and an angle.
    /// * Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): 2 multipliers; linear in its vectors, no second derivatives.
    /// * Force `tension`: a potential; its tangents are derived.
    /// * Force `motor`: no potential; its tangents are derived.
    /// * Not declared, so that no function is written for it: flexible bodies, fixtures, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as force `motor` has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct AndrewsSqueezer {
        /// Torque of the motor on the crank. (SI; declared in N m)
        pub torque: f64,
    }
    /// Rigid body `k1`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k1`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Crank, turning about the origin.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k1(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.angle = -0.06171389001427645;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.04325;
        spec.rigid.moment[0] = 3.979e-5;
        spec.rigid.inertia[(1, 1)] = 3.66068e-8;
        spec.rigid.inertia[(2, 2)] = 2.2306068e-6;
    }
    /// Rigid body `k2`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k2`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Rod from the crank's end to the point F, in which four bodies meet.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k2(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 0.006986674115451445;
        spec.position[1] = -0.0004317230645688955;
        spec.angle = -0.06171389001427645;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.00365;
        spec.rigid.moment[0] = -4.1975e-5;
        spec.rigid.inertia[(1, 1)] = 4.827125e-7;
        spec.rigid.inertia[(2, 2)] = 9.237125e-7;
    }
    /// Rigid body `k3`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k3`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Triangle on the ground's point B, which the spring pulls.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k3(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.03635;
        spec.position[1] = 0.03273;
        spec.angle = 0.45527981916307037;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.02373;
        spec.rigid.moment[0] = 0.00024750390000000003;
        spec.rigid.inertia[(0, 0)] = 8.333681748e-6;
        spec.rigid.inertia[(0, 1)] = 4.638223086000001e-6;
        spec.rigid.moment[1] = -0.00044470020000000004;
        spec.rigid.inertia[(1, 0)] = 4.638223086000001e-6;
        spec.rigid.inertia[(1, 1)] = 2.581465677e-6;
        spec.rigid.inertia[(2, 2)] = 1.6170147425e-5;
    }
    /// Rigid body `k4`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k4`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Rod from k5 to F.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k4(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.03399720388583998;
        spec.position[1] = 0.01646197167499768;
        spec.angle = 0.7100333697097284;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.00706;
        spec.rigid.inertia[(0, 0)] = 2.3668014600000003e-7;
        spec.rigid.moment[1] = -4.08774e-5;
        spec.rigid.inertia[(2, 2)] = 8.03380146e-7;
    }
    /// Rigid body `k5`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k5`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Lower arm on the ground's point A.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k5(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.06934;
        spec.position[1] = -0.00227;
        spec.angle = 0.48736497954384256;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.0705;
        spec.rigid.moment[0] = 0.0016271399999999998;
        spec.rigid.inertia[(0, 0)] = 5.915344799999999e-6;
        spec.rigid.inertia[(0, 1)] = -1.4904602399999998e-5;
        spec.rigid.moment[1] = 0.0006457799999999999;
        spec.rigid.inertia[(1, 0)] = -1.4904602399999998e-5;
        spec.rigid.inertia[(1, 1)] = 3.755439119999999e-5;
        spec.rigid.inertia[(2, 2)] = 5.515973599999999e-5;
    }
    /// Rigid body `k6`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k6`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Rod from k7 to F.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k6(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.03163313450740889;
        spec.position[1] = -0.015618868668304536;
        spec.angle = 1.0078790543839353;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.00706;
        spec.rigid.moment[0] = 4.08774e-5;
        spec.rigid.inertia[(1, 1)] = 2.3668014600000003e-7;
        spec.rigid.inertia[(2, 2)] = 8.03380146e-7;
    }
    /// Rigid body `k7`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `k7`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Upper arm on the ground's point A.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_k7(model: &AndrewsSqueezer, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.06934;
        spec.position[1] = -0.00227;
        spec.angle = 1.2305474445498212;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.05498;
        spec.rigid.moment[0] = -0.0002468602;
        spec.rigid.inertia[(0, 0)] = 8.290896032e-6;
        spec.rigid.inertia[(0, 1)] = -3.031443256e-6;
        spec.rigid.moment[1] = -0.0006751544;
        spec.rigid.inertia[(1, 0)] = -3.031443256e-6;
        spec.rigid.inertia[(1, 1)] = 1.1084022980000001e-6;
        spec.rigid.inertia[(2, 2)] = 2.8519298330000002e-5;
    }
    /// Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): rows C(z, t).
    ///
    /// Of `o`: `z[0]` fixed in `k1`, where another vector starts; `z[1]` a point of `inertial` (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[1][0][0]`
    /// * position y: `z[0][0][1] - z[1][0][1]`
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_position_o(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][0][0] - z[1][0][0];
        rows[1] = z[0][0][1] - z[1][0][1];
    }
    /// Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): their rate dC/dt.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_velocity_o(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][1][0] - z[1][1][0];
        rows[1] = z[0][1][1] - z[1][1][1];
    }
    /// Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): their second time derivative.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_acceleration_o(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][2][0] - z[1][2][0];
        rows[1] = z[0][2][1] - z[1][2][1];
    }
    /// Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): their third time derivative.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_jerk_o(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][3][0] - z[1][3][0];
        rows[1] = z[0][3][1] - z[1][3][1];
    }
    /// Constraint `o` (revolute), `a5` (revolute), `a7` (revolute), `b` (revolute), `k` (revolute), `e54` (revolute), `h76` (revolute), `f23` (revolute), `f24` (revolute), `f26` (revolute): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_o(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..2];
        gradient[0] = 1.0;
        gradient[3] = -1.0;
        gradient[7] = 1.0;
        gradient[10] = -1.0;
    }
    /// Force `tension`: writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.
    ///
    /// Of `tension`: `z[0]` a point of `k3`; `z[1]` a point of `inertial` (inertial axes).
    ///
    /// Operations: 4 additions, 5 multiplications, 1 divisions, 1 function calls.
    pub fn force_value_tension(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        out: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        let t16 = z[1][0] - z[0][0];
        let t17 = z[1][1] - z[0][1];
        let t18 = (t16 * t16 + t17 * t17).sqrt();
        let t19 = 4530.0 * (t18 - 0.07785) / t18;
        let t20 = t16 * t19;
        let t21 = t17 * t19;
        out[0] = t20;
        out[1] = t21;
        out[3] = -t20;
        out[4] = -t21;
    }
    /// Force `tension`: writes df/dz and df/dz', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 14 additions, 20 multiplications, 6 divisions, 1 function calls.
    pub fn force_tangent_tension(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        let t16 = z[1][0] - z[0][0];
        let t17 = z[1][1] - z[0][1];
        let t18 = (t16 * t16 + t17 * t17).sqrt();
        let t19 = 4530.0 * (t18 - 0.07785) / t18;
        let t20 = 1.0 / (t18 * 2.0);
        let t21 = t16 * 2.0 * t20;
        let t22 = 4530.0 * t21;
        let t23 = t19 * t21;
        let t24 = (t23 - t22) / t18;
        let t25 = t16 * t24;
        let t26 = t17 * 2.0 * t20;
        let t27 = 4530.0 * t26;
        let t28 = t19 * t26;
        let t29 = (t28 - t27) / t18;
        let t30 = t16 * t29;
        let t31 = (t22 - t23) / t18;
        let t32 = t19 + t16 * t31;
        let t33 = (t27 - t28) / t18;
        let t34 = t16 * t33;
        let t35 = t17 * t24;
        let t36 = t17 * t29;
        let t37 = t17 * t31;
        let t38 = t19 + t17 * t33;
        by_value[0] = t25 - t19;
        by_value[1] = t30;
        by_value[3] = t32;
        by_value[4] = t34;
        by_value[6] = t35;
        by_value[7] = t36 - t19;
        by_value[9] = t37;
        by_value[10] = t38;
        by_value[18] = t19 - t25;
        by_value[19] = -t30;
        by_value[21] = -t32;
        by_value[22] = -t34;
        by_value[24] = -t35;
        by_value[25] = t19 - t36;
        by_value[27] = -t37;
        by_value[28] = -t38;
    }
    /// Force `tension`: its potential (J).
    ///
    /// Operations: 4 additions, 4 multiplications, 1 function calls.
    pub fn force_energy_tension(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[::rncf::emitted::Vector],
        energy: &mut f64,
    ) {
        let z = &z[..2];
        let t16 = 2265.0
            * (((z[1][0] - z[0][0]).powi(2) + (z[1][1] - z[0][1]).powi(2)).sqrt()
                - 0.07785)
                .powi(2);
        *energy = t16;
    }
    /// Force `motor`: writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.
    ///
    /// Of `motor`: `z[0]` the turning of `k1` (inertial axes).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn force_value_motor(
        model: &AndrewsSqueezer,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        out: &mut [f64],
    ) {
        let z = &z[..1];
        let velocity = &velocity[..1];
        out[2] = model.torque;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn outputs(model: &AndrewsSqueezer, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1] - observed[0];
        out[2] = observed[2];
        out[3] = observed[3] - observed[4];
        out[4] = observed[4];
        out[5] = observed[5] - observed[6];
        out[6] = observed[6];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &AndrewsSqueezer, run: &mut ::rncf::RunDefaults) {
        run.t_end = 0.03;
        run.every = 0.0001;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: AndrewsSqueezer,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &AndrewsSqueezer) -> Self {
            Self { model: model.clone() }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 20,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 21,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 22,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 23,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 24,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 25,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 26,
                    derivative: 0,
                    component: 0,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            7
        }
        fn frame_count(&self) -> usize {
            8
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "k1", "k2", "k3", "k4", "k5", "k6", "k7"][frame]
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
            Some("force `motor` has no potential")
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
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 2,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 3,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 4,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 5,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 6,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 7,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Planar {
                        normal: 2,
                    },
                    ..still.clone()
                },
            ]);
            free_k1(&self.model, &mut specs[0]);
            free_k2(&self.model, &mut specs[1]);
            free_k3(&self.model, &mut specs[2]);
            free_k4(&self.model, &mut specs[3]);
            free_k5(&self.model, &mut specs[4]);
            free_k6(&self.model, &mut specs[5]);
            free_k7(&self.model, &mut specs[6]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 1,
                    marker: 0,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [-0.06934, -0.00227, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 5,
                    marker: 2,
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 7,
                    marker: 2,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [-0.03635, 0.03273, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 3,
                    marker: 5,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.007, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 5,
                    at: [0.04, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 7,
                    at: [0.0, -0.04, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 6,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [-0.028, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.0, -0.035, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [0.0, -0.02, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 6,
                    at: [0.02, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.02, -0.018, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.014, 0.072, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Turn {
                    frame: 1,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 1,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 2,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 3,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 4,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 5,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 6,
                },
                ::rncf::emitted::MarkerSpec::Angle {
                    frame: 7,
                },
            ])
        }
    }
    impl ::rncf::emitted::WithoutBodies for Equations {}
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::WithoutJointConditions for Equations {}
    impl ::rncf::emitted::WithoutLoads for Equations {}
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::MarkerConstraints for Equations {
        fn constraints(&self) -> ::std::vec::Vec<::rncf::emitted::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ConstraintSpec {
                    name: "o",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[1, 0],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "a5",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[3, 2],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "a7",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[4, 2],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "b",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[6, 5],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "k",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[7, 8],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "e54",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[9, 10],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "h76",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[11, 12],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "f23",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[13, 14],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "f24",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[13, 15],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "f26",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[13, 16],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
            ])
        }
        fn marker_constraint(
            &self,
            constraint: usize,
            level: ::rncf::emitted::ConstraintLevel,
            t: f64,
            z: &[[::rncf::emitted::Vector; 4]],
            rows: &mut [f64],
        ) {
            match constraint {
                0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_o(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_o(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_o(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_o(&self.model, t, z, rows)
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
            z: &[::rncf::emitted::Vector],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match constraint {
                0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9 => {
                    constraint_gradient_o(&self.model, t, z, gradient)
                }
                _ => {}
            }
        }
        fn marker_constraint_rate_gradient(
            &self,
            constraint: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
        }
        fn marker_constraint_branches(
            &self,
            constraint: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            out: &mut [f64],
        ) {}
        fn marker_constraint_hessian(
            &self,
            constraint: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            lambda: &[f64],
            hessian: &mut [f64],
        ) {
            hessian.fill(0.0);
        }
    }
    impl ::rncf::emitted::MarkerForces for Equations {
        fn forces(&self) -> ::std::vec::Vec<::rncf::emitted::ForceSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ForceSpec {
                    name: "tension",
                    markers: &[17, 18],
                    conservative: true,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "motor",
                    markers: &[19],
                    conservative: false,
                    of_differences: true,
                    branches: 0,
                },
            ])
        }
        fn is_load(&self, force: usize) -> bool {
            matches!(force, 1)
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
                0 => force_value_tension(&self.model, t, z, velocity, out),
                1 => force_value_motor(&self.model, t, z, velocity, out),
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
                0 => {
                    force_tangent_tension(
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
                0 => force_energy_tension(&self.model, t, z, &mut energy),
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
