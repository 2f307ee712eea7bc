//! Expansion of `models/src/four_bar.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use four_bar_equations::FourBar;
#[allow(clippy::all)]
impl Default for FourBar {
    fn default() -> Self {
        Self { speed: -1.0 }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for FourBar {
    const NAME: &'static str = "FourBar";
    const DOC: &'static str = "N-four-bar linkage with N = 2: three upright links on the ground, two couplers, gravity. Where the links lie flat\nall rods are in line and the linkage could leave its parallelogram; it happens twice a turn.";
    const SOURCE: &'static str = r#"pub model FourBar {
    /// Angular velocity of the links at the start, which moves their ends at 1 m/s.
    param speed = -1 rad/s;

    const length = 1 m;
    const m = 1 kg;
    /// Slender rod about its centre.
    const j = m * length^2 / 12;

    rigid link_0 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; speed = speed; }
    rigid link_1 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; origin = [1, 0, 0] m; speed = speed; }
    rigid link_2 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; origin = [2, 0, 0] m; speed = speed; }
    rigid coupler_1 {
        plane xy;
        mass = m;
        inertia = j;
        center = [0.5, 0, 0] m;
        origin = [0, 1, 0] m;
        velocity = [-length * speed, 0, 0];
    }
    rigid coupler_2 {
        plane xy;
        mass = m;
        inertia = j;
        center = [0.5, 0, 0] m;
        origin = [1, 1, 0] m;
        velocity = [-length * speed, 0, 0];
    }

    joint a0 = revolute(link_0, inertial.at([0, 0, 0] m));
    joint a1 = revolute(link_1, inertial.at([1, 0, 0] m));
    joint a2 = revolute(link_2, inertial.at([2, 0, 0] m));
    joint b0 = revolute(link_0.at([0, 1, 0] m), coupler_1.at([0, 0, 0] m));
    joint b1 = revolute(link_1.at([0, 1, 0] m), coupler_1.at([1, 0, 0] m));
    joint b12 = revolute(link_1.at([0, 1, 0] m), coupler_2.at([0, 0, 0] m));
    joint b2 = revolute(link_2.at([0, 1, 0] m), coupler_2.at([1, 0, 0] m));
    load weight = gravity([0, -9.81, 0] m/s^2);

    /// Point B0, the upper end of the first link, x.
    output x = link_0.at([0, 1, 0] m).x;
    /// Point B0, y.
    output y = link_0.at([0, 1, 0] m).y;

    run { t_end = 10 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xb6e3c4767c3676d8;
    const NOTES: &'static [&'static str] = &[
        "Rigid body `link_0` is free in three motions: two positions and an angle.",
        "Rigid body `link_1` is free in three motions: two positions and an angle.",
        "Rigid body `link_2` is free in three motions: two positions and an angle.",
        "Rigid body `coupler_1` is free in three motions: two positions and an angle.",
        "Rigid body `coupler_2` is free in three motions: two positions and an angle.",
        "Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): 2 multipliers; linear in its vectors, no second derivatives.",
        "Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.",
        "Energy-momentum integration: there is no flexible body to derive forces for.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "constraint_position_a0",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_a0",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_a0",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_a0",
            additions: 2,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 2,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "speed",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: -1.0,
                doc: "Angular velocity of the links at the start, which moves their ends at 1 m/s.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "x",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Point B0, the upper end of the first link, x.",
            },
            ::rncf::Output {
                name: "y",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Point B0, y.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.speed,
            _ => panic!("FourBar has 1 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.speed = value,
            _ => panic!("FourBar has 1 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        four_bar_equations::run_defaults(self, &mut run);
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
        let equations = four_bar_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`FourBar`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod four_bar_equations {
    /// N-four-bar linkage with N = 2: three upright links on the ground, two couplers, gravity. Where the links lie flat
    /// all rods are in line and the linkage could leave its parallelogram; it happens twice a turn.
    ///
    /// # Chosen and left out
    ///
    /// * Rigid body `link_0` is free in three motions: two positions and an angle.
    /// * Rigid body `link_1` is free in three motions: two positions and an angle.
    /// * Rigid body `link_2` is free in three motions: two positions and an angle.
    /// * Rigid body `coupler_1` is free in three motions: two positions and an angle.
    /// * Rigid body `coupler_2` is free in three motions: two positions and an angle.
    /// * Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): 2 multipliers; linear in its vectors, no second derivatives.
    /// * Not declared, so that no function is written for it: flexible bodies, fixtures, springs and forces on moving places, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, kinks of motions, cautions.
    /// * Energy-momentum integration: there is no flexible body to derive forces for.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct FourBar {
        /// Angular velocity of the links at the start, which moves their ends at 1 m/s. (SI; declared in rad/s)
        pub speed: f64,
    }
    /// Rigid body `link_0`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `link_0`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_link_0(model: &FourBar, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.spin[2] = model.speed;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.25;
        spec.rigid.moment[1] = 0.5;
        spec.rigid.inertia[(2, 2)] = 0.3333333333333333;
    }
    /// Rigid body `link_1`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `link_1`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_link_1(model: &FourBar, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 1.0;
        spec.spin[2] = model.speed;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.25;
        spec.rigid.moment[1] = 0.5;
        spec.rigid.inertia[(2, 2)] = 0.3333333333333333;
    }
    /// Rigid body `link_2`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `link_2`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_link_2(model: &FourBar, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 2.0;
        spec.spin[2] = model.speed;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.inertia[(0, 0)] = 0.25;
        spec.rigid.moment[1] = 0.5;
        spec.rigid.inertia[(2, 2)] = 0.3333333333333333;
    }
    /// Rigid body `coupler_1`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `coupler_1`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_coupler_1(model: &FourBar, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[1] = 1.0;
        spec.velocity[0] = -model.speed;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.moment[0] = 0.5;
        spec.rigid.inertia[(1, 1)] = 0.25;
        spec.rigid.inertia[(2, 2)] = 0.3333333333333333;
    }
    /// Rigid body `coupler_2`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `coupler_2`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_coupler_2(model: &FourBar, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 1.0;
        spec.position[1] = 1.0;
        spec.velocity[0] = -model.speed;
        spec.axis[2] = 1.0;
        spec.rigid.mass = 1.0;
        spec.rigid.moment[0] = 0.5;
        spec.rigid.inertia[(1, 1)] = 0.25;
        spec.rigid.inertia[(2, 2)] = 0.3333333333333333;
    }
    /// Load `weight` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_weight(model: &FourBar, t: f64, value: &mut [f64; 3]) {
        value[0] = 0.0;
        value[1] = -9.81;
        value[2] = 0.0;
    }
    /// Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): rows C(z, t).
    ///
    /// Of `a0`: `z[0]` fixed in `link_0`, where another vector starts; `z[1]` a point of `inertial` (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[1][0][0]`
    /// * position y: `z[0][0][1] - z[1][0][1]`
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_position_a0(
        model: &FourBar,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][0][0] - z[1][0][0];
        rows[1] = z[0][0][1] - z[1][0][1];
    }
    /// Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): their rate dC/dt.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_velocity_a0(
        model: &FourBar,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][1][0] - z[1][1][0];
        rows[1] = z[0][1][1] - z[1][1][1];
    }
    /// Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): their second time derivative.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_acceleration_a0(
        model: &FourBar,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][2][0] - z[1][2][0];
        rows[1] = z[0][2][1] - z[1][2][1];
    }
    /// Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): their third time derivative.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn constraint_jerk_a0(
        model: &FourBar,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][3][0] - z[1][3][0];
        rows[1] = z[0][3][1] - z[1][3][1];
    }
    /// Constraint `a0` (revolute), `a1` (revolute), `a2` (revolute), `b0` (revolute), `b1` (revolute), `b12` (revolute), `b2` (revolute): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_a0(
        model: &FourBar,
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
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &FourBar, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &FourBar, run: &mut ::rncf::RunDefaults) {
        run.t_end = 10.0;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: FourBar,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &FourBar) -> Self {
            Self { model: model.clone() }
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 6,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Marker {
                    marker: 6,
                    derivative: 0,
                    component: 1,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            2
        }
        fn frame_count(&self) -> usize {
            6
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "link_0", "link_1", "link_2", "coupler_1", "coupler_2"][frame]
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
            ]);
            free_link_0(&self.model, &mut specs[0]);
            free_link_1(&self.model, &mut specs[1]);
            free_link_2(&self.model, &mut specs[2]);
            free_coupler_1(&self.model, &mut specs[3]);
            free_coupler_2(&self.model, &mut specs[4]);
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
                    at: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 2,
                    marker: 2,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [2.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 3,
                    marker: 4,
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 4,
                    at: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 5,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 3,
                    at: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 5,
                    at: [1.0, 0.0, 0.0],
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
                    name: "a0",
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
                    name: "a1",
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
                    name: "a2",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[5, 4],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "b0",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[6, 7],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "b1",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[8, 9],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "b12",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[8, 10],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "b2",
                    kind: "revolute",
                    rows: &["position x", "position y"],
                    markers: &[11, 12],
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
                0 | 1 | 2 | 3 | 4 | 5 | 6 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_a0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_a0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_a0(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_a0(&self.model, t, z, rows)
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
                0 | 1 | 2 | 3 | 4 | 5 | 6 => {
                    constraint_gradient_a0(&self.model, t, z, gradient)
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
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::WithoutDensities for Equations {}
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::WithoutGravityFields for Equations {}
}
