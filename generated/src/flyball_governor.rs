//! Expansion of `models/src/flyball_governor.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use flyball_governor_equations::FlyballGovernor;
#[allow(clippy::all)]
impl Default for FlyballGovernor {
    fn default() -> Self {
        Self {
            omega_0: 1.0053096491487339,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for FlyballGovernor {
    const NAME: &'static str = "FlyballGovernor";
    const DOC: &'static str = "Flyball governor: two arms with balls on a spinning shaft, held by stiff, strongly damped springs on a slider.";
    const SOURCE: &'static str = r#"pub model FlyballGovernor {
    /// Spin at the start. Some sources begin with 2 pi rad/s.
    param omega_0 = 2 * pi * 0.16 Hz;

    const raised = 30 deg;
    // Square rods, 10 mm wide and 1 m long, about their own axis and across it.
    const along = 0.3 kg * (2e-4 [m^2]) / 12;
    const across = 0.3 kg * (1.0001 [m^2]) / 12;

    /// Shaft, from the ground to the arms' pins.
    rigid shaft {
        mass = 0.3 kg;
        inertia = [across, across, along];
        center = [0, 0, 0.5] m;
        angular_velocity = [0, 0, omega_0];
    }
    /// Slider; the springs stand on it beside the shaft.
    rigid slider {
        mass = 3 kg;
        inertia = [0.005, 0.005, 0.005] kg*m^2;
        origin = [0, 0, 0.5] m;
        angular_velocity = [0, 0, omega_0];
    }
    // The arms' own x axes lie along the rods, both to the right.
    rigid right {
        mass = 0.3 kg;
        inertia = [along, across, across];
        center = [0.5, 0, 0] m;
        origin = [0.05, 0, 1] m;
        axis = y;
        angle = raised;
        velocity = [0, 0.05 m * omega_0, 0];
        angular_velocity = [-omega_0 * sin(raised), 0, omega_0 * cos(raised)];
    }
    rigid left {
        mass = 0.3 kg;
        inertia = [along, across, across];
        center = [-0.5, 0, 0] m;
        origin = [-0.05, 0, 1] m;
        axis = y;
        angle = -raised;
        velocity = [0, -0.05 m * omega_0, 0];
        angular_velocity = [omega_0 * sin(raised), 0, omega_0 * cos(raised)];
    }
    fixture right_ball on right.at([1, 0, 0] m) { mass = 5 kg; }
    fixture left_ball on left.at([-1, 0, 0] m) { mass = 5 kg; }

    joint foot = revolute(shaft, inertial.at([0, 0, 0] m), axis = z);
    joint guide = prismatic(shaft, slider, axis = z);
    joint right_pin = revolute(shaft.at([0.05, 0, 1] m), right.at([0, 0, 0] m), axis = y);
    joint left_pin = revolute(shaft.at([-0.05, 0, 1] m), left.at([0, 0, 0] m), axis = y);

    // At the start they are as long as at rest: the slider falls a little until they carry it.
    spring right_strut = linear(
        slider.at([0.05, 0, 0] m), right.at([0.5, 0, 0] m),
        stiffness = 8e5 [N/m], damping = 4e4 [N*s/m], length = 0.5 m
    );
    spring left_strut = linear(
        slider.at([-0.05, 0, 0] m), left.at([-0.5, 0, 0] m),
        stiffness = 8e5 [N/m], damping = 4e4 [N*s/m], length = 0.5 m
    );
    load weight = gravity([0, 0, -9.81] m/s^2);

    /// Angle of the arms below the horizontal.
    output alpha = asin(-right.ex.z);
    /// Height of the slider.
    output s = slider.z;
    /// Spin of the shaft.
    output spin = shaft.angular_velocity.z;

    run { t_end = 10 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xe7e10986cb92a22e;
    const NOTES: &'static [&'static str] = &[
        "Rigid body `shaft` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `slider` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `right` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Rigid body `left` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): 5 multipliers; gradient and second derivatives are derived.",
        "Constraint `guide` (prismatic): 5 multipliers; gradient and second derivatives are derived.",
        "Force `right_strut`, `left_strut`: no potential; its tangents are derived.",
        "Not declared, so that no function is written for it: flexible bodies, fixtures, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as force `right_strut` has no potential.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "free_right",
            additions: 0,
            multiplications: 3,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "free_left",
            additions: 0,
            multiplications: 3,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_foot",
            additions: 7,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 13,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_foot",
            additions: 13,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 25,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_foot",
            additions: 25,
            multiplications: 18,
            divisions: 0,
            functions: 0,
            weighted: 43,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_foot",
            additions: 43,
            multiplications: 24,
            divisions: 0,
            functions: 0,
            weighted: 67,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_guide",
            additions: 13,
            multiplications: 15,
            divisions: 0,
            functions: 0,
            weighted: 28,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_guide",
            additions: 31,
            multiplications: 30,
            divisions: 0,
            functions: 0,
            weighted: 61,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_guide",
            additions: 64,
            multiplications: 45,
            divisions: 0,
            functions: 0,
            weighted: 109,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_guide",
            additions: 112,
            multiplications: 60,
            divisions: 0,
            functions: 0,
            weighted: 172,
        },
        ::rncf::model::KernelCount {
            name: "constraint_gradient_guide",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_rate_gradient_guide",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "force_value_right_strut",
            additions: 12,
            multiplications: 11,
            divisions: 2,
            functions: 1,
            weighted: 51,
        },
        ::rncf::model::KernelCount {
            name: "force_tangent_right_strut",
            additions: 45,
            multiplications: 72,
            divisions: 27,
            functions: 1,
            weighted: 245,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 2,
            multiplications: 3,
            divisions: 0,
            functions: 1,
            weighted: 25,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "omega_0",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 1.0053096491487339,
                doc: "Spin at the start. Some sources begin with 2 pi rad/s.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "alpha",
                unit: "rad",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle of the arms below the horizontal.",
            },
            ::rncf::Output {
                name: "s",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Height of the slider.",
            },
            ::rncf::Output {
                name: "spin",
                unit: "rad/s",
                time_exponent: -1.0,
                components: &[],
                doc: "Spin of the shaft.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_0,
            _ => panic!("FlyballGovernor has 1 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_0 = value,
            _ => panic!("FlyballGovernor has 1 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        flyball_governor_equations::run_defaults(self, &mut run);
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
        let equations = flyball_governor_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`FlyballGovernor`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod flyball_governor_equations {
    /// Flyball governor: two arms with balls on a spinning shaft, held by stiff, strongly damped springs on a slider.
    ///
    /// # Chosen and left out
    ///
    /// * Rigid body `shaft` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `slider` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `right` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Rigid body `left` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): 5 multipliers; gradient and second derivatives are derived.
    /// * Constraint `guide` (prismatic): 5 multipliers; gradient and second derivatives are derived.
    /// * Force `right_strut`, `left_strut`: no potential; its tangents are derived.
    /// * Not declared, so that no function is written for it: flexible bodies, fixtures, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as force `right_strut` has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct FlyballGovernor {
        /// Spin at the start. Some sources begin with 2 pi rad/s. (SI; declared in rad/s)
        pub omega_0: f64,
    }
    /// Rigid body `shaft`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `shaft`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Shaft, from the ground to the arms' pins.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_shaft(model: &FlyballGovernor, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.spin[2] = model.omega_0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 0.3;
        spec.rigid.inertia[(0, 0)] = 0.1000025;
        spec.rigid.inertia[(1, 1)] = 0.1000025;
        spec.rigid.moment[2] = 0.15;
        spec.rigid.inertia[(2, 2)] = 5e-6;
    }
    /// Rigid body `slider`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `slider`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Slider; the springs stand on it beside the shaft.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_slider(model: &FlyballGovernor, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[2] = 0.5;
        spec.spin[2] = model.omega_0;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 3.0;
        spec.rigid.inertia[(0, 0)] = 0.005;
        spec.rigid.inertia[(1, 1)] = 0.005;
        spec.rigid.inertia[(2, 2)] = 0.005;
    }
    /// Rigid body `right`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `right`, `right_ball`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 3 multiplications.
    pub fn free_right(model: &FlyballGovernor, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 0.05;
        spec.position[2] = 1.0;
        spec.velocity[1] = model.omega_0 * 0.05;
        spec.spin[0] = -model.omega_0 * 0.49999999999999994;
        spec.spin[2] = model.omega_0 * 0.8660254037844387;
        spec.angle = 0.5235987755982988;
        spec.axis[1] = 1.0;
        spec.rigid.mass = 5.3;
        spec.rigid.moment[0] = 5.15;
        spec.rigid.inertia[(0, 0)] = 5e-6;
        spec.rigid.inertia[(1, 1)] = 5.1000025;
        spec.rigid.inertia[(2, 2)] = 5.1000025;
    }
    /// Rigid body `left`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `left`, `left_ball`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 3 multiplications.
    pub fn free_left(model: &FlyballGovernor, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = -0.05;
        spec.position[2] = 1.0;
        spec.velocity[1] = model.omega_0 * (-0.05);
        spec.spin[0] = model.omega_0 * 0.49999999999999994;
        spec.spin[2] = model.omega_0 * 0.8660254037844387;
        spec.angle = -0.5235987755982988;
        spec.axis[1] = 1.0;
        spec.rigid.mass = 5.3;
        spec.rigid.moment[0] = -5.15;
        spec.rigid.inertia[(0, 0)] = 5e-6;
        spec.rigid.inertia[(1, 1)] = 5.1000025;
        spec.rigid.inertia[(2, 2)] = 5.1000025;
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_weight(model: &FlyballGovernor, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = 0.0;
        value[2] = -9.81;
    }
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): rows C(z, t).
    ///
    /// Of `foot`: `z[0]` fixed in `shaft`, where another vector starts; `z[1]` a direction of `shaft`; `z[2]` a point of `inertial`; `z[3]` fixed in `inertial`, normal to a direction at the start; `z[4]` fixed in `inertial`, normal to a direction at the start (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[2][0][0]`
    /// * position y: `z[0][0][1] - z[2][0][1]`
    /// * position z: `z[0][0][2] - z[2][0][2]`
    /// * direction 1: `z[1][0][0] * z[3][0][0] + z[1][0][1] * z[3][0][1] + z[1][0][2] * z[3][0][2]`
    /// * direction 2: `z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1] + z[1][0][2] * z[4][0][2]`
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn constraint_position_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): their rate dC/dt.
    ///
    /// Operations: 13 additions, 12 multiplications.
    pub fn constraint_velocity_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): their second time derivative.
    ///
    /// Operations: 25 additions, 18 multiplications.
    pub fn constraint_acceleration_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): their third time derivative.
    ///
    /// Operations: 43 additions, 24 multiplications.
    pub fn constraint_jerk_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_rate_gradient_foot(
        model: &FlyballGovernor,
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
    /// Constraint `foot` (revolute), `right_pin` (revolute), `left_pin` (revolute): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_foot(
        model: &FlyballGovernor,
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
    /// Constraint `guide` (prismatic): rows C(z, t).
    ///
    /// Of `guide`: `z[0]` a direction of `shaft`; `z[1]` fixed in `shaft`, normal to a direction at the start; `z[2]` a point of `shaft`; `z[3]` fixed in `slider`, normal to a direction at the start; `z[4]` fixed in `slider`, normal to a direction at the start; `z[5]` fixed in `slider`, where another vector starts (inertial axes).
    ///
    /// * direction 1: `z[0][0][0] * z[3][0][0] + z[0][0][1] * z[3][0][1] + z[0][0][2] * z[3][0][2]`
    /// * direction 2: `z[0][0][0] * z[4][0][0] + z[0][0][1] * z[4][0][1] + z[0][0][2] * z[4][0][2]`
    /// * direction 3: `z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1] + z[1][0][2] * z[4][0][2]`
    /// * offset 1: `z[3][0][0] * (z[5][0][0] - z[2][0][0]) + z[3][0][1] * (z[5][0][1] - z[2][0][1]) + z[3][0][2] * (z[5][0][2] - z[2][0][2])`
    /// * offset 2: `z[4][0][0] * (z[5][0][0] - z[2][0][0]) + z[4][0][1] * (z[5][0][1] - z[2][0][1]) + z[4][0][2] * (z[5][0][2] - z[2][0][2])`
    ///
    /// Operations: 13 additions, 15 multiplications.
    pub fn constraint_position_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..6];
        let t30 = z[5][0][0] - z[2][0][0];
        let t31 = z[5][0][1] - z[2][0][1];
        let t32 = z[5][0][2] - z[2][0][2];
        rows[0] = z[0][0][0] * z[3][0][0] + z[0][0][1] * z[3][0][1]
            + z[0][0][2] * z[3][0][2];
        rows[1] = z[0][0][0] * z[4][0][0] + z[0][0][1] * z[4][0][1]
            + z[0][0][2] * z[4][0][2];
        rows[2] = z[1][0][0] * z[4][0][0] + z[1][0][1] * z[4][0][1]
            + z[1][0][2] * z[4][0][2];
        rows[3] = z[3][0][0] * t30 + z[3][0][1] * t31 + z[3][0][2] * t32;
        rows[4] = z[4][0][0] * t30 + z[4][0][1] * t31 + z[4][0][2] * t32;
    }
    /// Constraint `guide` (prismatic): their rate dC/dt.
    ///
    /// Operations: 31 additions, 30 multiplications.
    pub fn constraint_velocity_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..6];
        let t48 = z[5][0][0] - z[2][0][0];
        let t49 = z[5][0][1] - z[2][0][1];
        let t50 = z[5][0][2] - z[2][0][2];
        let t51 = z[3][0][0] * z[0][1][0] + z[0][0][0] * z[3][1][0]
            + (z[3][0][1] * z[0][1][1] + z[0][0][1] * z[3][1][1])
            + (z[3][0][2] * z[0][1][2] + z[0][0][2] * z[3][1][2]);
        let t52 = z[4][0][0] * z[0][1][0] + z[0][0][0] * z[4][1][0]
            + (z[4][0][1] * z[0][1][1] + z[0][0][1] * z[4][1][1])
            + (z[4][0][2] * z[0][1][2] + z[0][0][2] * z[4][1][2]);
        let t53 = z[4][0][0] * z[1][1][0] + z[1][0][0] * z[4][1][0]
            + (z[4][0][1] * z[1][1][1] + z[1][0][1] * z[4][1][1])
            + (z[4][0][2] * z[1][1][2] + z[1][0][2] * z[4][1][2]);
        let t54 = z[5][1][0] - z[2][1][0];
        let t55 = z[5][1][1] - z[2][1][1];
        let t56 = z[5][1][2] - z[2][1][2];
        let t57 = z[3][1][0] * t48 + z[3][0][0] * t54
            + (z[3][1][1] * t49 + z[3][0][1] * t55)
            + (z[3][1][2] * t50 + z[3][0][2] * t56);
        let t58 = z[4][1][0] * t48 + z[4][0][0] * t54
            + (z[4][1][1] * t49 + z[4][0][1] * t55)
            + (z[4][1][2] * t50 + z[4][0][2] * t56);
        rows[0] = t51;
        rows[1] = t52;
        rows[2] = t53;
        rows[3] = t57;
        rows[4] = t58;
    }
    /// Constraint `guide` (prismatic): their second time derivative.
    ///
    /// Operations: 64 additions, 45 multiplications.
    pub fn constraint_acceleration_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..6];
        let t66 = z[5][0][0] - z[2][0][0];
        let t67 = z[5][0][1] - z[2][0][1];
        let t68 = z[5][0][2] - z[2][0][2];
        let t69 = z[5][1][0] - z[2][1][0];
        let t70 = z[5][1][1] - z[2][1][1];
        let t71 = z[5][1][2] - z[2][1][2];
        let t72 = z[0][1][0] * z[3][1][0];
        let t73 = z[0][1][1] * z[3][1][1];
        let t74 = t72 + z[3][0][0] * z[0][2][0] + (t72 + z[0][0][0] * z[3][2][0])
            + (t73 + z[3][0][1] * z[0][2][1] + (t73 + z[0][0][1] * z[3][2][1]));
        let t75 = z[0][1][2] * z[3][1][2];
        let t76 = z[0][1][0] * z[4][1][0];
        let t77 = z[0][1][1] * z[4][1][1];
        let t78 = t76 + z[4][0][0] * z[0][2][0] + (t76 + z[0][0][0] * z[4][2][0])
            + (t77 + z[4][0][1] * z[0][2][1] + (t77 + z[0][0][1] * z[4][2][1]));
        let t79 = z[0][1][2] * z[4][1][2];
        let t80 = z[1][1][0] * z[4][1][0];
        let t81 = z[1][1][1] * z[4][1][1];
        let t82 = t80 + z[4][0][0] * z[1][2][0] + (t80 + z[1][0][0] * z[4][2][0])
            + (t81 + z[4][0][1] * z[1][2][1] + (t81 + z[1][0][1] * z[4][2][1]));
        let t83 = z[1][1][2] * z[4][1][2];
        let t84 = z[5][2][0] - z[2][2][0];
        let t85 = z[3][1][0] * t69;
        let t86 = z[5][2][1] - z[2][2][1];
        let t87 = z[3][1][1] * t70;
        let t88 = z[3][2][0] * t66 + t85 + (t85 + z[3][0][0] * t84)
            + (z[3][2][1] * t67 + t87 + (t87 + z[3][0][1] * t86));
        let t89 = z[5][2][2] - z[2][2][2];
        let t90 = z[3][1][2] * t71;
        let t91 = z[4][1][0] * t69;
        let t92 = z[4][1][1] * t70;
        let t93 = z[4][2][0] * t66 + t91 + (t91 + z[4][0][0] * t84)
            + (z[4][2][1] * t67 + t92 + (t92 + z[4][0][1] * t86));
        let t94 = z[4][1][2] * t71;
        rows[0] = t74
            + (t75 + z[3][0][2] * z[0][2][2] + (t75 + z[0][0][2] * z[3][2][2]));
        rows[1] = t78
            + (t79 + z[4][0][2] * z[0][2][2] + (t79 + z[0][0][2] * z[4][2][2]));
        rows[2] = t82
            + (t83 + z[4][0][2] * z[1][2][2] + (t83 + z[1][0][2] * z[4][2][2]));
        rows[3] = t88 + (z[3][2][2] * t68 + t90 + (t90 + z[3][0][2] * t89));
        rows[4] = t93 + (z[4][2][2] * t68 + t94 + (t94 + z[4][0][2] * t89));
    }
    /// Constraint `guide` (prismatic): their third time derivative.
    ///
    /// Operations: 112 additions, 60 multiplications.
    pub fn constraint_jerk_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..6];
        let t84 = z[5][0][0] - z[2][0][0];
        let t85 = z[5][0][1] - z[2][0][1];
        let t86 = z[5][0][2] - z[2][0][2];
        let t87 = z[5][1][0] - z[2][1][0];
        let t88 = z[5][1][1] - z[2][1][1];
        let t89 = z[5][1][2] - z[2][1][2];
        let t90 = z[5][2][0] - z[2][2][0];
        let t91 = z[5][2][1] - z[2][2][1];
        let t92 = z[5][2][2] - z[2][2][2];
        let t93 = z[3][1][0] * z[0][2][0];
        let t94 = z[0][1][0] * z[3][2][0];
        let t95 = t93 + t94;
        let t96 = z[3][1][1] * z[0][2][1];
        let t97 = z[0][1][1] * z[3][2][1];
        let t98 = t96 + t97;
        let t99 = t95 + (t93 + z[3][0][0] * z[0][3][0])
            + (t95 + (t94 + z[0][0][0] * z[3][3][0]))
            + (t98 + (t96 + z[3][0][1] * z[0][3][1])
                + (t98 + (t97 + z[0][0][1] * z[3][3][1])));
        let t100 = z[3][1][2] * z[0][2][2];
        let t101 = z[0][1][2] * z[3][2][2];
        let t102 = t100 + t101;
        let t103 = z[4][1][0] * z[0][2][0];
        let t104 = z[0][1][0] * z[4][2][0];
        let t105 = t103 + t104;
        let t106 = z[4][1][1] * z[0][2][1];
        let t107 = z[0][1][1] * z[4][2][1];
        let t108 = t106 + t107;
        let t109 = t105 + (t103 + z[4][0][0] * z[0][3][0])
            + (t105 + (t104 + z[0][0][0] * z[4][3][0]))
            + (t108 + (t106 + z[4][0][1] * z[0][3][1])
                + (t108 + (t107 + z[0][0][1] * z[4][3][1])));
        let t110 = z[4][1][2] * z[0][2][2];
        let t111 = z[0][1][2] * z[4][2][2];
        let t112 = t110 + t111;
        let t113 = z[4][1][0] * z[1][2][0];
        let t114 = z[1][1][0] * z[4][2][0];
        let t115 = t113 + t114;
        let t116 = z[4][1][1] * z[1][2][1];
        let t117 = z[1][1][1] * z[4][2][1];
        let t118 = t116 + t117;
        let t119 = t115 + (t113 + z[4][0][0] * z[1][3][0])
            + (t115 + (t114 + z[1][0][0] * z[4][3][0]))
            + (t118 + (t116 + z[4][0][1] * z[1][3][1])
                + (t118 + (t117 + z[1][0][1] * z[4][3][1])));
        let t120 = z[4][1][2] * z[1][2][2];
        let t121 = z[1][1][2] * z[4][2][2];
        let t122 = t120 + t121;
        let t123 = z[5][3][0] - z[2][3][0];
        let t124 = z[3][2][0] * t87;
        let t125 = z[3][1][0] * t90;
        let t126 = t124 + t125;
        let t127 = z[5][3][1] - z[2][3][1];
        let t128 = z[3][2][1] * t88;
        let t129 = z[3][1][1] * t91;
        let t130 = t128 + t129;
        let t131 = z[3][3][0] * t84 + t124 + t126 + (t126 + (t125 + z[3][0][0] * t123))
            + (z[3][3][1] * t85 + t128 + t130 + (t130 + (t129 + z[3][0][1] * t127)));
        let t132 = z[5][3][2] - z[2][3][2];
        let t133 = z[3][2][2] * t89;
        let t134 = z[3][1][2] * t92;
        let t135 = t133 + t134;
        let t136 = z[4][2][0] * t87;
        let t137 = z[4][1][0] * t90;
        let t138 = t136 + t137;
        let t139 = z[4][2][1] * t88;
        let t140 = z[4][1][1] * t91;
        let t141 = t139 + t140;
        let t142 = z[4][3][0] * t84 + t136 + t138 + (t138 + (t137 + z[4][0][0] * t123))
            + (z[4][3][1] * t85 + t139 + t141 + (t141 + (t140 + z[4][0][1] * t127)));
        let t143 = z[4][2][2] * t89;
        let t144 = z[4][1][2] * t92;
        let t145 = t143 + t144;
        rows[0] = t99
            + (t102 + (t100 + z[3][0][2] * z[0][3][2])
                + (t102 + (t101 + z[0][0][2] * z[3][3][2])));
        rows[1] = t109
            + (t112 + (t110 + z[4][0][2] * z[0][3][2])
                + (t112 + (t111 + z[0][0][2] * z[4][3][2])));
        rows[2] = t119
            + (t122 + (t120 + z[4][0][2] * z[1][3][2])
                + (t122 + (t121 + z[1][0][2] * z[4][3][2])));
        rows[3] = t131
            + (z[3][3][2] * t86 + t133 + t135 + (t135 + (t134 + z[3][0][2] * t132)));
        rows[4] = t142
            + (z[4][3][2] * t86 + t143 + t145 + (t145 + (t144 + z[4][0][2] * t132)));
    }
    /// Constraint `guide` (prismatic): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_gradient_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..6];
        let t30 = z[5][0] - z[2][0];
        let t31 = z[5][1] - z[2][1];
        let t32 = z[5][2] - z[2][2];
        gradient[0] = z[3][0];
        gradient[1] = z[3][1];
        gradient[2] = z[3][2];
        gradient[9] = z[0][0];
        gradient[10] = z[0][1];
        gradient[11] = z[0][2];
        gradient[18] = z[4][0];
        gradient[19] = z[4][1];
        gradient[20] = z[4][2];
        gradient[30] = z[0][0];
        gradient[31] = z[0][1];
        gradient[32] = z[0][2];
        gradient[39] = z[4][0];
        gradient[40] = z[4][1];
        gradient[41] = z[4][2];
        gradient[48] = z[1][0];
        gradient[49] = z[1][1];
        gradient[50] = z[1][2];
        gradient[60] = -z[3][0];
        gradient[61] = -z[3][1];
        gradient[62] = -z[3][2];
        gradient[63] = t30;
        gradient[64] = t31;
        gradient[65] = t32;
        gradient[69] = z[3][0];
        gradient[70] = z[3][1];
        gradient[71] = z[3][2];
        gradient[78] = -z[4][0];
        gradient[79] = -z[4][1];
        gradient[80] = -z[4][2];
        gradient[84] = t30;
        gradient[85] = t31;
        gradient[86] = t32;
        gradient[87] = z[4][0];
        gradient[88] = z[4][1];
        gradient[89] = z[4][2];
    }
    /// Constraint `guide` (prismatic): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_rate_gradient_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..6];
        let velocity = &velocity[..6];
        let t30 = velocity[5][0] - velocity[2][0];
        let t31 = velocity[5][1] - velocity[2][1];
        let t32 = velocity[5][2] - velocity[2][2];
        gradient[0] = velocity[3][0];
        gradient[1] = velocity[3][1];
        gradient[2] = velocity[3][2];
        gradient[9] = velocity[0][0];
        gradient[10] = velocity[0][1];
        gradient[11] = velocity[0][2];
        gradient[18] = velocity[4][0];
        gradient[19] = velocity[4][1];
        gradient[20] = velocity[4][2];
        gradient[30] = velocity[0][0];
        gradient[31] = velocity[0][1];
        gradient[32] = velocity[0][2];
        gradient[39] = velocity[4][0];
        gradient[40] = velocity[4][1];
        gradient[41] = velocity[4][2];
        gradient[48] = velocity[1][0];
        gradient[49] = velocity[1][1];
        gradient[50] = velocity[1][2];
        gradient[60] = -velocity[3][0];
        gradient[61] = -velocity[3][1];
        gradient[62] = -velocity[3][2];
        gradient[63] = t30;
        gradient[64] = t31;
        gradient[65] = t32;
        gradient[69] = velocity[3][0];
        gradient[70] = velocity[3][1];
        gradient[71] = velocity[3][2];
        gradient[78] = -velocity[4][0];
        gradient[79] = -velocity[4][1];
        gradient[80] = -velocity[4][2];
        gradient[84] = t30;
        gradient[85] = t31;
        gradient[86] = t32;
        gradient[87] = velocity[4][0];
        gradient[88] = velocity[4][1];
        gradient[89] = velocity[4][2];
    }
    /// Constraint `guide` (prismatic): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_guide(
        model: &FlyballGovernor,
        t: f64,
        z: &[::rncf::emitted::Vector],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..6];
        let lambda = &lambda[..5];
        hessian[162] = lambda[0];
        hessian[9] = lambda[0];
        hessian[168] = -lambda[3];
        hessian[117] = -lambda[3];
        hessian[181] = lambda[0];
        hessian[28] = lambda[0];
        hessian[187] = -lambda[3];
        hessian[136] = -lambda[3];
        hessian[200] = lambda[0];
        hessian[47] = lambda[0];
        hessian[206] = -lambda[3];
        hessian[155] = -lambda[3];
        hessian[216] = lambda[1];
        hessian[12] = lambda[1];
        hessian[219] = lambda[2];
        hessian[66] = lambda[2];
        hessian[222] = -lambda[4];
        hessian[120] = -lambda[4];
        hessian[235] = lambda[1];
        hessian[31] = lambda[1];
        hessian[238] = lambda[2];
        hessian[85] = lambda[2];
        hessian[241] = -lambda[4];
        hessian[139] = -lambda[4];
        hessian[254] = lambda[1];
        hessian[50] = lambda[1];
        hessian[257] = lambda[2];
        hessian[104] = lambda[2];
        hessian[260] = -lambda[4];
        hessian[158] = -lambda[4];
        hessian[279] = lambda[3];
        hessian[177] = lambda[3];
        hessian[282] = lambda[4];
        hessian[231] = lambda[4];
        hessian[298] = lambda[3];
        hessian[196] = lambda[3];
        hessian[301] = lambda[4];
        hessian[250] = lambda[4];
        hessian[317] = lambda[3];
        hessian[215] = lambda[3];
        hessian[320] = lambda[4];
        hessian[269] = lambda[4];
    }
    /// Force `right_strut`, `left_strut`: writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.
    ///
    /// Of `right_strut`: `z[0]` a point of `slider`; `z[1]` a point of `right` (inertial axes).
    ///
    /// Operations: 12 additions, 11 multiplications, 2 divisions, 1 function calls.
    pub fn force_value_right_strut(
        model: &FlyballGovernor,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        out: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        let t24 = z[1][0] - z[0][0];
        let t25 = z[1][1] - z[0][1];
        let t26 = z[1][2] - z[0][2];
        let t27 = (t24 * t24 + t25 * t25 + t26 * t26).sqrt();
        let t28 = (t24 * (velocity[1][0] - velocity[0][0])
            + t25 * (velocity[1][1] - velocity[0][1])
            + t26 * (velocity[1][2] - velocity[0][2])) / t27;
        let t29 = (800000.0 * (t27 - 0.5) + 40000.0 * t28) / t27;
        let t30 = t24 * t29;
        let t31 = t25 * t29;
        let t32 = t26 * t29;
        out[0] = t30;
        out[1] = t31;
        out[2] = t32;
        out[3] = -t30;
        out[4] = -t31;
        out[5] = -t32;
    }
    /// Force `right_strut`, `left_strut`: writes df/dz and df/dz', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 45 additions, 72 multiplications, 27 divisions, 1 function calls.
    pub fn force_tangent_right_strut(
        model: &FlyballGovernor,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        let t24 = z[1][0] - z[0][0];
        let t25 = z[1][1] - z[0][1];
        let t26 = z[1][2] - z[0][2];
        let t27 = (t24 * t24 + t25 * t25 + t26 * t26).sqrt();
        let t28 = velocity[1][0] - velocity[0][0];
        let t29 = velocity[1][1] - velocity[0][1];
        let t30 = velocity[1][2] - velocity[0][2];
        let t31 = (t24 * t28 + t25 * t29 + t26 * t30) / t27;
        let t32 = (800000.0 * (t27 - 0.5) + 40000.0 * t31) / t27;
        let t33 = 1.0 / (t27 * 2.0);
        let t34 = t24 * 2.0 * t33;
        let t35 = 800000.0 * t34;
        let t36 = t31 * t34;
        let t37 = t32 * t34;
        let t38 = (40000.0 * ((velocity[0][0] - velocity[1][0] + t36) / t27) - t35 + t37)
            / t27;
        let t39 = t24 * t38;
        let t40 = t25 * 2.0 * t33;
        let t41 = 800000.0 * t40;
        let t42 = t31 * t40;
        let t43 = t32 * t40;
        let t44 = (40000.0 * ((velocity[0][1] - velocity[1][1] + t42) / t27) - t41 + t43)
            / t27;
        let t45 = t24 * t44;
        let t46 = t26 * 2.0 * t33;
        let t47 = 800000.0 * t46;
        let t48 = t31 * t46;
        let t49 = t32 * t46;
        let t50 = (40000.0 * ((velocity[0][2] - velocity[1][2] + t48) / t27) - t47 + t49)
            / t27;
        let t51 = t24 * t50;
        let t52 = (t35 + 40000.0 * ((t28 - t36) / t27) - t37) / t27;
        let t53 = t32 + t24 * t52;
        let t54 = (t41 + 40000.0 * ((t29 - t42) / t27) - t43) / t27;
        let t55 = t24 * t54;
        let t56 = (t47 + 40000.0 * ((t30 - t48) / t27) - t49) / t27;
        let t57 = t24 * t56;
        let t58 = t25 * t38;
        let t59 = t25 * t44;
        let t60 = t25 * t50;
        let t61 = t25 * t52;
        let t62 = t32 + t25 * t54;
        let t63 = t25 * t56;
        let t64 = t26 * t38;
        let t65 = t26 * t44;
        let t66 = t26 * t50;
        let t67 = t26 * t52;
        let t68 = t26 * t54;
        let t69 = t32 + t26 * t56;
        let t70 = 40000.0 * ((z[0][0] - z[1][0]) / t27) / t27;
        let t71 = t24 * t70;
        let t72 = 40000.0 * ((z[0][1] - z[1][1]) / t27) / t27;
        let t73 = t24 * t72;
        let t74 = 40000.0 * ((z[0][2] - z[1][2]) / t27) / t27;
        let t75 = t24 * t74;
        let t76 = 40000.0 * (t24 / t27) / t27;
        let t77 = t24 * t76;
        let t78 = 40000.0 * (t25 / t27) / t27;
        let t79 = t24 * t78;
        let t80 = 40000.0 * (t26 / t27) / t27;
        let t81 = t24 * t80;
        let t82 = t25 * t70;
        let t83 = t25 * t72;
        let t84 = t25 * t74;
        let t85 = t25 * t76;
        let t86 = t25 * t78;
        let t87 = t25 * t80;
        let t88 = t26 * t70;
        let t89 = t26 * t72;
        let t90 = t26 * t74;
        let t91 = t26 * t76;
        let t92 = t26 * t78;
        let t93 = t26 * t80;
        by_value[0] = t39 - t32;
        by_value[1] = t45;
        by_value[2] = t51;
        by_value[3] = t53;
        by_value[4] = t55;
        by_value[5] = t57;
        by_value[6] = t58;
        by_value[7] = t59 - t32;
        by_value[8] = t60;
        by_value[9] = t61;
        by_value[10] = t62;
        by_value[11] = t63;
        by_value[12] = t64;
        by_value[13] = t65;
        by_value[14] = t66 - t32;
        by_value[15] = t67;
        by_value[16] = t68;
        by_value[17] = t69;
        by_value[18] = t32 - t39;
        by_value[19] = -t45;
        by_value[20] = -t51;
        by_value[21] = -t53;
        by_value[22] = -t55;
        by_value[23] = -t57;
        by_value[24] = -t58;
        by_value[25] = t32 - t59;
        by_value[26] = -t60;
        by_value[27] = -t61;
        by_value[28] = -t62;
        by_value[29] = -t63;
        by_value[30] = -t64;
        by_value[31] = -t65;
        by_value[32] = t32 - t66;
        by_value[33] = -t67;
        by_value[34] = -t68;
        by_value[35] = -t69;
        by_velocity[0] = t71;
        by_velocity[1] = t73;
        by_velocity[2] = t75;
        by_velocity[3] = t77;
        by_velocity[4] = t79;
        by_velocity[5] = t81;
        by_velocity[6] = t82;
        by_velocity[7] = t83;
        by_velocity[8] = t84;
        by_velocity[9] = t85;
        by_velocity[10] = t86;
        by_velocity[11] = t87;
        by_velocity[12] = t88;
        by_velocity[13] = t89;
        by_velocity[14] = t90;
        by_velocity[15] = t91;
        by_velocity[16] = t92;
        by_velocity[17] = t93;
        by_velocity[18] = -t71;
        by_velocity[19] = -t73;
        by_velocity[20] = -t75;
        by_velocity[21] = -t77;
        by_velocity[22] = -t79;
        by_velocity[23] = -t81;
        by_velocity[24] = -t82;
        by_velocity[25] = -t83;
        by_velocity[26] = -t84;
        by_velocity[27] = -t85;
        by_velocity[28] = -t86;
        by_velocity[29] = -t87;
        by_velocity[30] = -t88;
        by_velocity[31] = -t89;
        by_velocity[32] = -t90;
        by_velocity[33] = -t91;
        by_velocity[34] = -t92;
        by_velocity[35] = -t93;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 3 multiplications, 1 function calls.
    pub fn outputs(model: &FlyballGovernor, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = (-observed[0]).asin();
        out[1] = observed[1];
        out[2] = observed[2] * observed[3] + observed[4] * observed[5]
            + observed[6] * observed[7];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &FlyballGovernor, run: &mut ::rncf::RunDefaults) {
        run.t_end = 10.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: FlyballGovernor,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &FlyballGovernor) -> Self {
            Self { model: model.clone() }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 23,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 24,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 25,
                    derivative: 1,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 25,
                    derivative: 1,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 25,
                    derivative: 1,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            3
        }
        fn frame_count(&self) -> usize {
            5
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "shaft", "slider", "right", "left"][frame]
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
            Some("force `right_strut` has no potential")
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
            ]);
            free_shaft(&self.model, &mut specs[0]);
            free_slider(&self.model, &mut specs[1]);
            free_right(&self.model, &mut specs[2]);
            free_left(&self.model, &mut specs[3]);
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
                    along: [0.0, 0.0, 1.0],
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
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 2,
                    marker: 2,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 2,
                    marker: 2,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 1,
                    marker: 2,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 2,
                    marker: 8,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.05, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 1.0, 0.0],
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
                    frame: 1,
                    at: [-0.05, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 4,
                    marker: 12,
                    which: 0,
                },
                ::rncf::emitted::MarkerSpec::Normal {
                    frame: 4,
                    marker: 12,
                    which: 1,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.05, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.5, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [-0.05, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [-0.5, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 3,
                    along: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Turn {
                    frame: 1,
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [1.0, 0.0, 0.0],
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
                    name: "foot",
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
                    name: "guide",
                    kind: "prismatic",
                    rows: &[
                        "direction 1",
                        "direction 2",
                        "direction 3",
                        "offset 1",
                        "offset 2",
                    ],
                    markers: &[2, 7, 8, 5, 6, 9],
                    coupled: &[[0, 3], [0, 4], [1, 4], [2, 3], [2, 4], [3, 5], [4, 5]],
                    of_differences: true,
                    first_party: 3,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "right_pin",
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
                    name: "left_pin",
                    kind: "revolute",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                    ],
                    markers: &[15, 12, 16, 17, 18],
                    coupled: &[[1, 3], [1, 4]],
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
                0 | 2 | 3 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_foot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_foot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_foot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_foot(&self.model, t, z, rows)
                        }
                    }
                }
                1 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_guide(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_guide(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_guide(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_guide(&self.model, t, z, rows)
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
                0 | 2 | 3 => constraint_gradient_foot(&self.model, t, z, gradient),
                1 => constraint_gradient_guide(&self.model, t, z, gradient),
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
                0 | 2 | 3 => {
                    constraint_rate_gradient_foot(&self.model, t, z, velocity, gradient)
                }
                1 => {
                    constraint_rate_gradient_guide(&self.model, t, z, velocity, gradient)
                }
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
                0 | 2 | 3 => constraint_hessian_foot(&self.model, t, z, lambda, hessian),
                1 => constraint_hessian_guide(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::MarkerForces for Equations {
        fn forces(&self) -> ::std::vec::Vec<::rncf::emitted::ForceSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ForceSpec {
                    name: "right_strut",
                    markers: &[19, 20],
                    conservative: false,
                    of_differences: true,
                    branches: 0,
                },
                ::rncf::emitted::ForceSpec {
                    name: "left_strut",
                    markers: &[21, 22],
                    conservative: false,
                    of_differences: true,
                    branches: 0,
                },
            ])
        }
        fn is_load(&self, force: usize) -> bool {
            false
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
                0 | 1 => force_value_right_strut(&self.model, t, z, velocity, out),
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
                0 | 1 => {
                    force_tangent_right_strut(
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
            0.0
        }
    }
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
