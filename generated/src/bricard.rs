//! Expansion of `models/src/bricard.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use bricard_equations::Bricard;
#[allow(clippy::all)]
impl Default for Bricard {
    fn default() -> Self {
        Self {}
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for Bricard {
    const NAME: &'static str = "Bricard";
    const DOC: &'static str = "Bricard's mechanism: five rods and the ground, joined by six revolute joints into a spatial loop. Six joints take\n30 freedoms of five bodies, but one of them twice: the loop moves.";
    const SOURCE: &'static str = r#"pub model Bricard {
    const m = 1 kg;
    /// Square rod 1 x 0.1 x 0.1 m about its axis.
    const along = 1 kg * (0.02 [m^2]) / 12;
    /// And across, about its centre.
    const across = 1 kg * (1.01 [m^2]) / 12;

    // All frames begin with the axes of space; rod Pi Pj begins at Pi.
    rigid p01 { mass = m; inertia = [along, across, across]; center = [0.5, 0, 0] m; }
    rigid p12 { mass = m; inertia = [across, along, across]; center = [0, -0.5, 0] m; origin = [1, 0, 0] m; }
    rigid p23 { mass = m; inertia = [across, across, along]; center = [0, 0, 0.5] m; origin = [1, -1, 0] m; }
    rigid p34 { mass = m; inertia = [along, across, across]; center = [-0.5, 0, 0] m; origin = [1, -1, 1] m; }
    rigid p45 { mass = m; inertia = [across, along, across]; center = [0, 0.5, 0] m; origin = [0, -1, 1] m; }

    joint p0 = revolute(p01, inertial.at([0, 0, 0] m), axis = y);
    joint p1 = revolute(p01.at([1, 0, 0] m), p12.at([0, 0, 0] m), axis = z);
    joint p2 = revolute(p12.at([0, -1, 0] m), p23.at([0, 0, 0] m), axis = x);
    joint p3 = revolute(p23.at([0, 0, 1] m), p34.at([0, 0, 0] m), axis = y);
    joint p4 = revolute(p34.at([-1, 0, 0] m), p45.at([0, 0, 0] m), axis = z);
    // Six revolute joints are refused as redundant: forces and moments that stress the loop without moving it are
    // not determined by the motion of rigid bodies. The last joint gives up one of its five conditions, the one
    // that carries the moment about z: the stress of the loop has such a moment in every position, so that what is
    // given up here is what the others hold twice. Left are the point, and the rod's x axis normal to z.
    joint p5 = universal(p45.at([0, 1, 0] m), inertial.at([0, 0, 1] m), axis = x, cross = z);
    load weight = gravity([0, -9.81, 0] m/s^2);

    /// Point P3, x.
    output x = p34.x;
    /// Point P3, y.
    output y = p34.y;
    /// Point P3, z.
    output z = p34.z;

    run { t_end = 10 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x7a030465b2e241ee;
    const NOTES: &'static [&'static str] = &[
        "Rigid body `p01` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `p12` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `p23` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `p34` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `p45` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): 5 multipliers; gradient and second derivatives are derived.",
        "Constraint `p5` (universal): 4 multipliers; gradient and second derivatives are derived.",
        "Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: there is no flexible body to derive forces for.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "constraint_position_p0",
            additions: 7,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 13,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_p0",
            additions: 13,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 25,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_p0",
            additions: 25,
            multiplications: 18,
            divisions: 0,
            functions: 0,
            weighted: 43,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_p0",
            additions: 43,
            multiplications: 24,
            divisions: 0,
            functions: 0,
            weighted: 67,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_p5",
            additions: 5,
            multiplications: 3,
            divisions: 0,
            functions: 0,
            weighted: 8,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_p5",
            additions: 8,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 14,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_p5",
            additions: 14,
            multiplications: 9,
            divisions: 0,
            functions: 0,
            weighted: 23,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_p5",
            additions: 23,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 35,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "x",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Point P3, x.",
            },
            ::rncf::Output {
                name: "y",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Point P3, y.",
            },
            ::rncf::Output {
                name: "z",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Point P3, z.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            _ => panic!("Bricard has 0 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            _ => panic!("Bricard has 0 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        bricard_equations::run_defaults(self, &mut run);
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
        let equations = bricard_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`Bricard`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod bricard_equations {
    /// Bricard's mechanism: five rods and the ground, joined by six revolute joints into a spatial loop. Six joints take
    /// 30 freedoms of five bodies, but one of them twice: the loop moves.
    ///
    /// # Chosen and left out
    ///
    /// * Rigid body `p01` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `p12` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `p23` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `p34` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `p45` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): 5 multipliers; gradient and second derivatives are derived.
    /// * Constraint `p5` (universal): 4 multipliers; gradient and second derivatives are derived.
    /// * Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: there is no flexible body to derive forces for.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct Bricard {}
    /// Rigid body `p01`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `p01`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_p01(model: &Bricard, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.moment[0] = 0.5;
        spec.rigid.inertia[(0, 0)] = 0.0016666666666666668;
        spec.rigid.inertia[(1, 1)] = 0.33416666666666667;
        spec.rigid.inertia[(2, 2)] = 0.33416666666666667;
    }
    /// Rigid body `p12`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `p12`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_p12(model: &Bricard, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 1.0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.33416666666666667;
        spec.rigid.moment[1] = -0.5;
        spec.rigid.inertia[(1, 1)] = 0.0016666666666666668;
        spec.rigid.inertia[(2, 2)] = 0.33416666666666667;
    }
    /// Rigid body `p23`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `p23`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_p23(model: &Bricard, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 1.0;
        spec.position[1] = -1.0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.33416666666666667;
        spec.rigid.inertia[(1, 1)] = 0.33416666666666667;
        spec.rigid.moment[2] = 0.5;
        spec.rigid.inertia[(2, 2)] = 0.0016666666666666668;
    }
    /// Rigid body `p34`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `p34`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_p34(model: &Bricard, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 1.0;
        spec.position[1] = -1.0;
        spec.position[2] = 1.0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.moment[0] = -0.5;
        spec.rigid.inertia[(0, 0)] = 0.0016666666666666668;
        spec.rigid.inertia[(1, 1)] = 0.33416666666666667;
        spec.rigid.inertia[(2, 2)] = 0.33416666666666667;
    }
    /// Rigid body `p45`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `p45`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_p45(model: &Bricard, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[1] = -1.0;
        spec.position[2] = 1.0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.33416666666666667;
        spec.rigid.moment[1] = 0.5;
        spec.rigid.inertia[(1, 1)] = 0.0016666666666666668;
        spec.rigid.inertia[(2, 2)] = 0.33416666666666667;
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_weight(model: &Bricard, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = -9.81;
        value[2] = 0.0;
    }
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): rows C(z, t).
    ///
    /// Of `p0`: `z[0]` fixed in `p01`, where another vector starts; `z[1]` a direction of `p01`; `z[2]` a point of `inertial`; `z[3]` fixed in `inertial`, normal to a direction at the start; `z[4]` fixed in `inertial`, normal to a direction at the start (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[2][0][0]`
    /// * position y: `z[0][0][1] - z[2][0][1]`
    /// * position z: `z[0][0][2] - z[2][0][2]`
    /// * direction 1: `z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1] + z[1][0][2] * z[3][0][2]`
    /// * direction 2: `z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1] + z[1][0][2] * z[4][0][2]`
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn constraint_position_p0(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): their rate dC/dt.
    ///
    /// Operations: 13 additions, 12 multiplications.
    pub fn constraint_velocity_p0(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): their second time derivative.
    ///
    /// Operations: 25 additions, 18 multiplications.
    pub fn constraint_acceleration_p0(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): their third time derivative.
    ///
    /// Operations: 43 additions, 24 multiplications.
    pub fn constraint_jerk_p0(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_p0(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_rate_gradient_p0(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
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
    /// Constraint `p0` (revolute), `p1` (revolute), `p2` (revolute), `p3` (revolute), `p4` (revolute): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_p0(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
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
    /// Constraint `p5` (universal): rows C(z, t).
    ///
    /// Of `p5`: `z[0]` a point of `p45`; `z[1]` a direction of `p45`; `z[2]` a point of `inertial`; `z[3]` fixed in `inertial`, where another vector starts (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[2][0][0]`
    /// * position y: `z[0][0][1] - z[2][0][1]`
    /// * position z: `z[0][0][2] - z[2][0][2]`
    /// * direction 1: `z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1] + z[1][0][2] * z[3][0][2]`
    ///
    /// Operations: 5 additions, 3 multiplications.
    pub fn constraint_position_p5(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..4];
        rows[0] = z[0][0][0] - z[2][0][0];
        rows[1] = z[0][0][1] - z[2][0][1];
        rows[2] = z[0][0][2] - z[2][0][2];
        rows[3] = z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1]
            + z[1][0][2] * z[3][0][2];
    }
    /// Constraint `p5` (universal): their rate dC/dt.
    ///
    /// Operations: 8 additions, 6 multiplications.
    pub fn constraint_velocity_p5(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..4];
        let t30 = z[3][0][0] * z[1][1][0] + z[1][0][0] * z[3][1][0]
            + (z[3][0][1] * z[1][1][1] + z[1][0][1] * z[3][1][1])
            + (z[3][0][2] * z[1][1][2] + z[1][0][2] * z[3][1][2]);
        rows[0] = z[0][1][0] - z[2][1][0];
        rows[1] = z[0][1][1] - z[2][1][1];
        rows[2] = z[0][1][2] - z[2][1][2];
        rows[3] = t30;
    }
    /// Constraint `p5` (universal): their second time derivative.
    ///
    /// Operations: 14 additions, 9 multiplications.
    pub fn constraint_acceleration_p5(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..4];
        let t36 = z[1][1][0] * z[3][1][0];
        let t37 = z[1][1][1] * z[3][1][1];
        let t38 = t36 + z[3][0][0] * z[1][2][0] + (t36 + z[1][0][0] * z[3][2][0])
            + (t37 + z[3][0][1] * z[1][2][1] + (t37 + z[1][0][1] * z[3][2][1]));
        let t39 = z[1][1][2] * z[3][1][2];
        rows[0] = z[0][2][0] - z[2][2][0];
        rows[1] = z[0][2][1] - z[2][2][1];
        rows[2] = z[0][2][2] - z[2][2][2];
        rows[3] = t38
            + (t39 + z[3][0][2] * z[1][2][2] + (t39 + z[1][0][2] * z[3][2][2]));
    }
    /// Constraint `p5` (universal): their third time derivative.
    ///
    /// Operations: 23 additions, 12 multiplications.
    pub fn constraint_jerk_p5(
        model: &Bricard,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..4];
        let t42 = z[3][1][0] * z[1][2][0];
        let t43 = z[1][1][0] * z[3][2][0];
        let t44 = t42 + t43;
        let t45 = z[3][1][1] * z[1][2][1];
        let t46 = z[1][1][1] * z[3][2][1];
        let t47 = t45 + t46;
        let t48 = t44 + (t42 + z[3][0][0] * z[1][3][0])
            + (t44 + (t43 + z[1][0][0] * z[3][3][0]))
            + (t47 + (t45 + z[3][0][1] * z[1][3][1])
                + (t47 + (t46 + z[1][0][1] * z[3][3][1])));
        let t49 = z[3][1][2] * z[1][2][2];
        let t50 = z[1][1][2] * z[3][2][2];
        let t51 = t49 + t50;
        rows[0] = z[0][3][0] - z[2][3][0];
        rows[1] = z[0][3][1] - z[2][3][1];
        rows[2] = z[0][3][2] - z[2][3][2];
        rows[3] = t48
            + (t51 + (t49 + z[3][0][2] * z[1][3][2])
                + (t51 + (t50 + z[1][0][2] * z[3][3][2])));
    }
    /// Constraint `p5` (universal): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_p5(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..4];
        gradient[0] = 1.0;
        gradient[6] = -1.0;
        gradient[13] = 1.0;
        gradient[19] = -1.0;
        gradient[26] = 1.0;
        gradient[32] = -1.0;
        gradient[39] = z[3][0];
        gradient[40] = z[3][1];
        gradient[41] = z[3][2];
        gradient[45] = z[1][0];
        gradient[46] = z[1][1];
        gradient[47] = z[1][2];
    }
    /// Constraint `p5` (universal): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_rate_gradient_p5(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..4];
        let velocity = &velocity[..4];
        gradient[39] = velocity[3][0];
        gradient[40] = velocity[3][1];
        gradient[41] = velocity[3][2];
        gradient[45] = velocity[1][0];
        gradient[46] = velocity[1][1];
        gradient[47] = velocity[1][2];
    }
    /// Constraint `p5` (universal): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_p5(
        model: &Bricard,
        t: f64,
        z: &[::rncf::emitted::Vector],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..4];
        let lambda = &lambda[..4];
        hessian[111] = lambda[3];
        hessian[45] = lambda[3];
        hessian[124] = lambda[3];
        hessian[58] = lambda[3];
        hessian[137] = lambda[3];
        hessian[71] = lambda[3];
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &Bricard, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &Bricard, run: &mut ::rncf::RunDefaults) {
        run.t_end = 10.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: Bricard,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &Bricard) -> Self {
            Self { model: model.clone() }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 16,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 16,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 16,
                    derivative: 0,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            3
        }
        fn frame_count(&self) -> usize {
            6
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "p01", "p12", "p23", "p34", "p45"][frame]
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
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 2,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 3,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 4,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
                ::rncf::emitted::FreeSpec {
                    frame: 5,
                    parent: 0,
                    is_body: true,
                    motions: ::rncf::emitted::Motions::Spatial,
                    ..still.clone()
                },
            ]);
            free_p01(&self.model, &mut specs[0]);
            free_p12(&self.model, &mut specs[1]);
            free_p23(&self.model, &mut specs[2]);
            free_p34(&self.model, &mut specs[3]);
            free_p45(&self.model, &mut specs[4]);
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
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 0,
                    marker: 2,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 0,
                    marker: 2,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 2,
                    marker: 7,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 2,
                    marker: 7,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, -1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 3,
                    marker: 12,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 3,
                    marker: 12,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 3,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 4,
                    marker: 17,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 4,
                    marker: 17,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [-1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 5,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 4,
                    along: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 5,
                    marker: 22,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 5,
                    marker: 22,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 5,
                    at: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 5,
                    along: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 5,
                    along: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 0,
                    marker: 28,
                },
            ])
        }
    }
    impl ::rncf::emitted::WithoutBodies for Equations {}
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::WithoutJointConditions for Equations {}
    impl ::rncf::emitted::Loads for Equations {
        fn loads(&self) -> ::std::vec::Vec<::rncf::emitted::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::LoadSpec {
                    name: "weight",
                    kind: ::rncf::emitted::LoadKind::Gravity,
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
                0 => load_weight(&self.model, t, &mut value),
                _ => {}
            }
            value
        }
    }
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::MarkerConstraints for Equations {
        fn constraints(&self) -> ::std::vec::Vec<::rncf::emitted::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ConstraintSpec {
                    name: "p0",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[1, 2, 0, 3, 4],
                    coupled: &[[1, 3], [1, 4]],
                    of_differences: true,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "p1",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[5, 7, 6, 8, 9],
                    coupled: &[[1, 3], [1, 4]],
                    of_differences: true,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "p2",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[10, 12, 11, 13, 14],
                    coupled: &[[1, 3], [1, 4]],
                    of_differences: true,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "p3",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[15, 17, 16, 18, 19],
                    coupled: &[[1, 3], [1, 4]],
                    of_differences: true,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "p4",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[20, 22, 21, 23, 24],
                    coupled: &[[1, 3], [1, 4]],
                    of_differences: true,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "p5",
                    kind: "universal",
                    rows: &["position x", "position y", "position z", "direction 1"],
                    markers: &[25, 27, 26, 29],
                    coupled: &[[1, 3]],
                    of_differences: true,
                    first_party: 2,
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
                0 | 1 | 2 | 3 | 4 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_p0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_p0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_p0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_p0(&self.model, t, z, rows)
                        }
                    }
                }
                5 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_p5(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_p5(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_p5(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_p5(&self.model, t, z, rows)
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
                0 | 1 | 2 | 3 | 4 => constraint_gradient_p0(&self.model, t, z, gradient),
                5 => constraint_gradient_p5(&self.model, t, z, gradient),
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
            match constraint {
                0 | 1 | 2 | 3 | 4 => {
                    constraint_rate_gradient_p0(&self.model, t, z, velocity, gradient)
                }
                5 => constraint_rate_gradient_p5(&self.model, t, z, velocity, gradient),
                _ => {}
            }
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
            match constraint {
                0 | 1 | 2 | 3 | 4 => {
                    constraint_hessian_p0(&self.model, t, z, lambda, hessian)
                }
                5 => constraint_hessian_p5(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
