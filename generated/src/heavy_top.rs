//! Expansion of `models/src/heavy_top.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use heavy_top_equations::HeavyTop;
#[allow(clippy::all)]
impl Default for HeavyTop {
    fn default() -> Self {
        Self {}
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for HeavyTop {
    const NAME: &'static str = "HeavyTop";
    const DOC: &'static str = "Heavy top: a spinning disc on a weightless arm, whose end stays at the origin (Bruls, Cardona & Arnold 2012).";
    const SOURCE: &'static str = r#"pub model HeavyTop {
    /// The disc. Its frame has the axes of inertia and begins at the centre of mass; the arm lies along its y axis.
    rigid top {
        mass = 15 kg;
        inertia = [0.234375, 0.46875, 0.234375] kg*m^2;
        origin = [0, 1, 0] m;
        velocity = [4.61538, 0, 0] m/s;
        angular_velocity = [0, 150, -4.61538] rad/s;
    }
    joint pivot = spherical(top.at([0, -1, 0] m), inertial.at([0, 0, 0] m));
    load weight = gravity([0, 0, -9.81] m/s^2);

    /// Centre of mass in space, x.
    output x = top.center.x;
    /// Centre of mass in space, y.
    output y = top.center.y;
    /// Centre of mass in space, z.
    output z = top.center.z;
    /// Force of the pivot on the top, in space.
    output force = pivot.force;

    run { t_end = 1 s; every = 0.005 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x4155f27de401926c;
    const NOTES: &'static [&'static str] = &[
        "Rigid body `top` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Constraint `pivot` (spherical): 3 multipliers; linear in its vectors, no second derivatives.",
        "Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: there is no flexible body to derive forces for.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "constraint_position_pivot",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_pivot",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_pivot",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_pivot",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
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
                doc: "Centre of mass in space, x.",
            },
            ::rncf::Output {
                name: "y",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Centre of mass in space, y.",
            },
            ::rncf::Output {
                name: "z",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Centre of mass in space, z.",
            },
            ::rncf::Output {
                name: "force",
                unit: "N",
                time_exponent: -2.0,
                components: &["x", "y", "z"],
                doc: "Force of the pivot on the top, in space.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            _ => panic!("HeavyTop has 0 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            _ => panic!("HeavyTop has 0 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        heavy_top_equations::run_defaults(self, &mut run);
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
        let equations = heavy_top_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`HeavyTop`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod heavy_top_equations {
    /// Heavy top: a spinning disc on a weightless arm, whose end stays at the origin (Bruls, Cardona & Arnold 2012).
    ///
    /// # Chosen and left out
    ///
    /// * Rigid body `top` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Constraint `pivot` (spherical): 3 multipliers; linear in its vectors, no second derivatives.
    /// * Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: there is no flexible body to derive forces for.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct HeavyTop {}
    /// Rigid body `top`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `top`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// The disc. Its frame has the axes of inertia and begins at the centre of mass; the arm lies along its y axis.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_top(model: &HeavyTop, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[1] = 1.0;
        spec.velocity[0] = 4.61538;
        spec.spin[1] = 150.0;
        spec.spin[2] = -4.61538;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 15.0;
        spec.rigid.inertia[(0, 0)] = 0.234375;
        spec.rigid.inertia[(1, 1)] = 0.46875;
        spec.rigid.inertia[(2, 2)] = 0.234375;
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_weight(model: &HeavyTop, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = 0.0;
        value[2] = -9.81;
    }
    /// Constraint `pivot` (spherical): rows C(z, t).
    ///
    /// Of `pivot`: `z[0]` a point of `top`; `z[1]` a point of `inertial` (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[1][0][0]`
    /// * position y: `z[0][0][1] - z[1][0][1]`
    /// * position z: `z[0][0][2] - z[1][0][2]`
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_position_pivot(
        model: &HeavyTop,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][0][0] - z[1][0][0];
        rows[1] = z[0][0][1] - z[1][0][1];
        rows[2] = z[0][0][2] - z[1][0][2];
    }
    /// Constraint `pivot` (spherical): their rate dC/dt.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_velocity_pivot(
        model: &HeavyTop,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][1][0] - z[1][1][0];
        rows[1] = z[0][1][1] - z[1][1][1];
        rows[2] = z[0][1][2] - z[1][1][2];
    }
    /// Constraint `pivot` (spherical): their second time derivative.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_acceleration_pivot(
        model: &HeavyTop,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][2][0] - z[1][2][0];
        rows[1] = z[0][2][1] - z[1][2][1];
        rows[2] = z[0][2][2] - z[1][2][2];
    }
    /// Constraint `pivot` (spherical): their third time derivative.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_jerk_pivot(
        model: &HeavyTop,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][3][0] - z[1][3][0];
        rows[1] = z[0][3][1] - z[1][3][1];
        rows[2] = z[0][3][2] - z[1][3][2];
    }
    /// Constraint `pivot` (spherical): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_pivot(
        model: &HeavyTop,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..2];
        gradient[0] = 1.0;
        gradient[3] = -1.0;
        gradient[7] = 1.0;
        gradient[10] = -1.0;
        gradient[14] = 1.0;
        gradient[17] = -1.0;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &HeavyTop, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
        out[4] = observed[4];
        out[5] = observed[5];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &HeavyTop, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.005;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: HeavyTop,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &HeavyTop) -> Self {
            Self { model: model.clone() }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::ConstraintReaction {
                    constraint: 0,
                    moment: false,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::ConstraintReaction {
                    constraint: 0,
                    moment: false,
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::ConstraintReaction {
                    constraint: 0,
                    moment: false,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            6
        }
        fn frame_count(&self) -> usize {
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "top"][frame]
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
            ]);
            free_top(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.0, -1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.0, 0.0, 0.0],
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
                    name: "pivot",
                    kind: "spherical",
                    rows: &["position x", "position y", "position z"],
                    markers: &[0, 1],
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
                0 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_pivot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_pivot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_pivot(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_pivot(&self.model, t, z, rows)
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
                0 => constraint_gradient_pivot(&self.model, t, z, gradient),
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
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
