//! Expansion of `models/src/slider_crank.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use slider_crank_equations::SliderCrank;
#[allow(clippy::all)]
impl Default for SliderCrank {
    fn default() -> Self {
        Self {
            omega_s: 8.0,
            T_s: 1.0,
            elements: 8,
            damping: 0.0,
            slider_mass: 0.08,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for SliderCrank {
    const NAME: &'static str = "SliderCrank";
    const DOC: &'static str = "Flexible slider-crank (Ren & Yang 2021, section 4.2): a soft connecting rod between a crank that is driven about x\nand a slider on the x axis.";
    const SOURCE: &'static str = r#"pub model SliderCrank {
    /// Steady angular velocity of the crank.
    param omega_s = 8 rad/s;
    /// Time to reach it.
    param T_s = 1 s;
    /// Number of elements.
    param elements: count = 8;
    /// Damping time of the rod's axial strain.
    param damping = 0 s;
    /// Mass of the slider.
    param slider_mass = 0.08 kg;

    const crank = 0.14 m;
    const length = 0.3 m;
    const radius = 8 mm;

    // A thousand times softer than steel, so that deflections can be seen; the underscore: axial strain alone is meant to be damped.
    material _soft { density = 7870 kg/m^3; young = 0.2 GPa; poisson = 0.29; damping = damping; }
    section round { area = pi * radius^2; second_moment = pi * radius^4 / 4; }

    /// Angle of the crank, THEORY (22).
    motion theta(t) =
        if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { omega_s * (t - T_s/2) };
    /// Moves with the crank's pin, which begins at the origin; the crank's axis lies below it.
    frame pin_frame = moving(origin = [0, -crank * sin(theta(t)), crank * (cos(theta(t)) - 1)]);
    /// Frame of the rod.
    frame rod in pin_frame = turning();

    body beam in rod {
        spatial;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * cable(round, _soft, bending = exact);
    }
    // The rod's own frame follows its chord: five ties. A centre line has no twist, so that the sixth is the universal
    // joint at the pin, whose cross axis on the crank is tangential: normal to the crank and to x. (Along x it would
    // be the rod's own axis once a turn.) The start's tangent instead of the chord, as in the paper, is the same
    // model: `joint root = clamp(beam.start, rod);`. But then all of the rod follows the quick bending of its first
    // element, and the integrators take up to three times as many steps (docs/measurements.md).
    joint root = pin(beam.start, rod);
    joint chord_y = hold(beam.end.y);
    joint chord_z = hold(beam.end.z);
    constraint cross_axis = dot([0, cos(theta(t)), sin(theta(t))], rod.ez);
    // Spherical joint on a slider that moves along x.
    fixture slider on beam.end { mass = slider_mass; }
    constraint guide_y = beam.end.in(inertial).y;
    constraint guide_z = beam.end.in(inertial).z;

    /// Position of the slider.
    output x_slider = beam.end.in(inertial).x;
    /// The same less that of a rigid rod.
    output dx = beam.end.in(inertial).x - sqrt(length^2 - crank^2 * (2 - 2 * cos(theta(t))));
    /// Distance of the rod's middle from its chord's.
    output mid = norm(beam.at(length / 2).position - 0.5 * (beam.start.position + beam.end.position));

    run { t_end = 2.5 s; every = 0.01 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0xebdc6f013549c1f9;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `cable_spatial_exact_damped`. Form: loop over points (the cheapest; operations of force and tangent: points unrolled: 795 and 4638; loop over points: 843 and 5093; a loop counts 1.3 times).",
        "Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `beam`: its axis is straight: no stress-free curvature for each element.",
        "Body `beam` moves in the free frame `rod`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Joint `chord_y`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Joint `chord_z`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Frame `rod` is free in three motions: a rotation vector that begins anew every step.",
        "Constraint `root` (pin in absolute coordinates): 3 multipliers; linear in its vectors, no second derivatives.",
        "Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): 1 multiplier; gradient and second derivatives are derived.",
        "Constraint `cross_axis` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Constraint `guide_y` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Constraint `guide_z` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Fixture `slider` adds constants to the inertia of `beam` and no unknowns.",
        "Not declared, so that no function is written for it: springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as body `beam` is damped.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX",
            size: [4, 4],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_elastic_force",
            additions: 298,
            multiplications: 534,
            divisions: 11,
            functions: 0,
            weighted: 876,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_elastic_tangent",
            additions: 2179,
            multiplications: 2898,
            divisions: 16,
            functions: 0,
            weighted: 5141,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_strain_energy",
            additions: 114,
            multiplications: 218,
            divisions: 6,
            functions: 0,
            weighted: 356,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_mass",
            additions: 0,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_shapes_position_2",
            additions: 4,
            multiplications: 8,
            divisions: 2,
            functions: 0,
            weighted: 20,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_exact_damped_field_forces",
            additions: 27,
            multiplications: 76,
            divisions: 4,
            functions: 0,
            weighted: 119,
        },
        ::rncf::model::KernelCount {
            name: "frame_pin_frame",
            additions: 18,
            multiplications: 37,
            divisions: 6,
            functions: 4,
            weighted: 159,
        },
        ::rncf::model::KernelCount {
            name: "joint_root_referenced_position",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "joint_chord_y_referenced_position",
            additions: 1,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 1,
        },
        ::rncf::model::KernelCount {
            name: "joint_chord_z_referenced_position",
            additions: 1,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 1,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_root",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_root",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_root",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_root",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_chord_y",
            additions: 5,
            multiplications: 3,
            divisions: 0,
            functions: 0,
            weighted: 8,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_chord_y",
            additions: 11,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 17,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_chord_y",
            additions: 20,
            multiplications: 9,
            divisions: 0,
            functions: 0,
            weighted: 29,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_chord_y",
            additions: 32,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 44,
        },
        ::rncf::model::KernelCount {
            name: "constraint_gradient_chord_y",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_rate_gradient_chord_y",
            additions: 3,
            multiplications: 0,
            divisions: 0,
            functions: 0,
            weighted: 3,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_cross_axis",
            additions: 5,
            multiplications: 8,
            divisions: 5,
            functions: 3,
            weighted: 93,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_cross_axis",
            additions: 9,
            multiplications: 15,
            divisions: 6,
            functions: 4,
            weighted: 128,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_cross_axis",
            additions: 17,
            multiplications: 25,
            divisions: 6,
            functions: 4,
            weighted: 146,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_cross_axis",
            additions: 30,
            multiplications: 37,
            divisions: 6,
            functions: 4,
            weighted: 171,
        },
        ::rncf::model::KernelCount {
            name: "constraint_gradient_cross_axis",
            additions: 4,
            multiplications: 6,
            divisions: 5,
            functions: 3,
            weighted: 90,
        },
        ::rncf::model::KernelCount {
            name: "constraint_rate_gradient_cross_axis",
            additions: 6,
            multiplications: 11,
            divisions: 6,
            functions: 4,
            weighted: 121,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 15,
            multiplications: 14,
            divisions: 5,
            functions: 4,
            weighted: 129,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "omega_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 8.0,
                doc: "Steady angular velocity of the crank.",
            },
            ::rncf::Param {
                name: "T_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 1.0,
                doc: "Time to reach it.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 8.0,
                doc: "Number of elements.",
            },
            ::rncf::Param {
                name: "damping",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 0.0,
                doc: "Damping time of the rod's axial strain.",
            },
            ::rncf::Param {
                name: "slider_mass",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kg",
                unit_si: 1.0,
                dimension: [0, 1, 0, 0, 0, 0],
                default: 0.08,
                doc: "Mass of the slider.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "x_slider",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Position of the slider.",
            },
            ::rncf::Output {
                name: "dx",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "The same less that of a rigid rod.",
            },
            ::rncf::Output {
                name: "mid",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Distance of the rod's middle from its chord's.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_s,
            1 => self.T_s,
            2 => self.elements as f64,
            3 => self.damping,
            4 => self.slider_mass,
            _ => panic!("SliderCrank has 5 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            3 => self.damping = value,
            4 => self.slider_mass = value,
            _ => panic!("SliderCrank has 5 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        slider_crank_equations::run_defaults(self, &mut run);
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
        let equations = slider_crank_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`SliderCrank`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod slider_crank_equations {
    /// Flexible slider-crank (Ren & Yang 2021, section 4.2): a soft connecting rod between a crank that is driven about x
    /// and a slider on the x axis.
    ///
    /// # Chosen and left out
    ///
    /// * Body `beam` uses `cable_spatial_exact_damped`. Form: loop over points (the cheapest; operations of force and tangent: points unrolled: 795 and 4638; loop over points: 843 and 5093; a loop counts 1.3 times).
    /// * Body `beam` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `beam`: its axis is straight: no stress-free curvature for each element.
    /// * Body `beam` moves in the free frame `rod`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Joint `root`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Joint `chord_y`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Joint `chord_z`: its conditions are linear in the nodal vectors of `beam` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Frame `rod` is free in three motions: a rotation vector that begins anew every step.
    /// * Constraint `root` (pin in absolute coordinates): 3 multipliers; linear in its vectors, no second derivatives.
    /// * Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): 1 multiplier; gradient and second derivatives are derived.
    /// * Constraint `cross_axis` (constraint): 1 multiplier; linear in its vectors, no second derivatives.
    /// * Constraint `guide_y` (constraint): 1 multiplier; linear in its vectors, no second derivatives.
    /// * Constraint `guide_z` (constraint): 1 multiplier; linear in its vectors, no second derivatives.
    /// * Fixture `slider` adds constants to the inertia of `beam` and no unknowns.
    /// * Not declared, so that no function is written for it: springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as body `beam` is damped.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct SliderCrank {
        /// Steady angular velocity of the crank. (SI; declared in rad/s)
        pub omega_s: f64,
        /// Time to reach it. (SI; declared in s)
        pub T_s: f64,
        /// Number of elements. (count)
        pub elements: usize,
        /// Damping time of the rod's axial strain. (SI; declared in s)
        pub damping: f64,
        /// Mass of the slider. (SI; declared in kg)
        pub slider_mass: f64,
    }
    /// Constants of one element `cable_spatial_exact_damped`. Hermite centre-line element: axial strain and bending, no shear, no torsion.
    ///
    /// Nodal vectors: r0, s0, r1, s1, 3 components each.
    ///
    /// Form: loop over points (the cheapest; operations of force and tangent: points unrolled: 795 and 4638; loop over points: 843 and 5093; a loop counts 1.3 times).
    ///
    /// The energy is integrated with 5 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct CableSpatialExactDamped {
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
    /// Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.
    ///
    /// Rows and columns: r0, s0, r1, s1; slopes are multiplied by the length. The sum of a row's columns of positions is the first moment d_a.
    pub const CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX: [[f64; 4]; 4] = [
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
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, in a loop.
    ///
    /// Operations: 298 additions, 534 multiplications, 11 divisions.
    pub fn cable_spatial_exact_damped_elastic_force(
        row: &CableSpatialExactDamped,
        q: &[f64; 12],
        v: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatialExactDamped { length, EA, EI, damping, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let v_d_x = inverse_length * (v_r1_x - v_r0_x);
        let v_d_y = inverse_length * (v_r1_y - v_r0_y);
        let v_d_z = inverse_length * (v_r1_z - v_r0_z);
        let mut force_0_0 = 0.0;
        let mut force_0_1 = 0.0;
        let mut force_0_2 = 0.0;
        let mut force_1_0 = 0.0;
        let mut force_1_1 = 0.0;
        let mut force_1_2 = 0.0;
        let mut force_2_0 = 0.0;
        let mut force_2_1 = 0.0;
        let mut force_2_2 = 0.0;
        /// Columns: weight, a[s0], a[d], a[s1], b[s0], b[d], b[s1].
        const TABLE: [[f64; 7]; 5] = [
            [
                0.1184634425280945,
                0.8189613578583975,
                0.26825713022186887,
                -0.08721848808026642,
                -3.718539537815992,
                5.437079075631984,
                -1.718539537815992,
            ],
            [
                0.23931433524968324,
                0.23669655349710927,
                1.0650762031114644,
                -0.30177275660857383,
                -2.6154079303170494,
                3.230815860634099,
                -0.6154079303170494,
            ],
            [0.28444444444444444, -0.25, 1.5, -0.25, -1.0, 0.0, 1.0],
            [
                0.23931433524968324,
                -0.3017727566085737,
                1.0650762031114644,
                0.23669655349710933,
                0.6154079303170494,
                -3.230815860634099,
                2.6154079303170494,
            ],
            [
                0.1184634425280945,
                -0.08721848808026644,
                0.26825713022186914,
                0.8189613578583973,
                1.7185395378159916,
                -5.437079075631983,
                3.7185395378159916,
            ],
        ];
        for (point, table) in TABLE.iter().enumerate() {
            let t63 = length * table[0];
            let a_x = s0_x * table[1] + d_x * table[2] + s1_x * table[3];
            let a_y = s0_y * table[1] + d_y * table[2] + s1_y * table[3];
            let a_z = s0_z * table[1] + d_z * table[2] + s1_z * table[3];
            let b_x = inverse_length
                * (s0_x * table[4] + d_x * table[5] + s1_x * table[6]);
            let b_y = inverse_length
                * (s0_y * table[4] + d_y * table[5] + s1_y * table[6]);
            let b_z = inverse_length
                * (s0_z * table[4] + d_z * table[5] + s1_z * table[6]);
            let v_a_x = v_s0_x * table[1] + v_d_x * table[2] + v_s1_x * table[3];
            let v_a_y = v_s0_y * table[1] + v_d_y * table[2] + v_s1_y * table[3];
            let v_a_z = v_s0_z * table[1] + v_d_z * table[2] + v_s1_z * table[3];
            let t73 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t74 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
            let t75 = a_x * b_x + a_y * b_y + a_z * b_z;
            let t76 = b_x * b_x + b_y * b_y + b_z * b_z;
            let t77 = EI * t63;
            let t78 = t73 * t73;
            let t79 = 1.0 / t78;
            let t80 = 0.5
                * (EA * t63 * (0.5 * (t73 - 1.0) + damping * (0.5 * (t74 + t74))));
            let t81 = t76 * t79 - (t73 * t76 - t75 * t75) * (t79 * (t73 * 2.0) / t78);
            let t82 = t80 + t77 * (0.5 * t81);
            let t83 = t77 * (0.5 * (t79 * (t75 * 2.0)));
            let t84 = t77 * (0.5 * (t73 * t79));
            let t85 = t82 * (a_x * 2.0) - b_x * t83;
            let t86 = t82 * (a_y * 2.0) - b_y * t83;
            let t87 = t82 * (a_z * 2.0) - b_z * t83;
            let t88 = inverse_length * (t84 * (b_x * 2.0) - a_x * t83);
            let t89 = inverse_length * (t84 * (b_y * 2.0) - a_y * t83);
            let t90 = inverse_length * (t84 * (b_z * 2.0) - a_z * t83);
            force_0_0 += table[1] * t85 + table[4] * t88;
            force_0_1 += table[1] * t86 + table[4] * t89;
            force_0_2 += table[1] * t87 + table[4] * t90;
            force_1_0 += table[2] * t85 + table[5] * t88;
            force_1_1 += table[2] * t86 + table[5] * t89;
            force_1_2 += table[2] * t87 + table[5] * t90;
            force_2_0 += table[3] * t85 + table[6] * t88;
            force_2_1 += table[3] * t86 + table[6] * t89;
            force_2_2 += table[3] * t87 + table[6] * t90;
        }
        let t91 = inverse_length * force_1_0;
        let t92 = inverse_length * force_1_1;
        let t93 = inverse_length * force_1_2;
        force[0] -= t91;
        force[1] -= t92;
        force[2] -= t93;
        force[3] += force_0_0;
        force[4] += force_0_1;
        force[5] += force_0_2;
        force[6] += t91;
        force[7] += t92;
        force[8] += t93;
        force[9] += force_2_0;
        force[10] += force_2_1;
        force[11] += force_2_2;
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, in a loop.
    ///
    /// Operations: 2179 additions, 2898 multiplications, 16 divisions.
    pub fn cable_spatial_exact_damped_elastic_tangent(
        row: &CableSpatialExactDamped,
        q: &[f64; 12],
        v: &[f64; 12],
        stiffness: &mut [f64; 144],
        damping_matrix: &mut [f64; 144],
    ) {
        let CableSpatialExactDamped { length, EA, EI, damping, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let v_d_x = inverse_length * (v_r1_x - v_r0_x);
        let v_d_y = inverse_length * (v_r1_y - v_r0_y);
        let v_d_z = inverse_length * (v_r1_z - v_r0_z);
        let t216 = damping * 0.5;
        let t217 = inverse_length * inverse_length;
        let mut stiffness_00_00 = 0.0;
        let mut stiffness_00_01 = 0.0;
        let mut stiffness_00_02 = 0.0;
        let mut stiffness_00_10 = 0.0;
        let mut stiffness_00_11 = 0.0;
        let mut stiffness_00_12 = 0.0;
        let mut stiffness_00_20 = 0.0;
        let mut stiffness_00_21 = 0.0;
        let mut stiffness_00_22 = 0.0;
        let mut stiffness_01_00 = 0.0;
        let mut stiffness_01_01 = 0.0;
        let mut stiffness_01_02 = 0.0;
        let mut stiffness_01_10 = 0.0;
        let mut stiffness_01_11 = 0.0;
        let mut stiffness_01_12 = 0.0;
        let mut stiffness_01_20 = 0.0;
        let mut stiffness_01_21 = 0.0;
        let mut stiffness_01_22 = 0.0;
        let mut stiffness_02_00 = 0.0;
        let mut stiffness_02_01 = 0.0;
        let mut stiffness_02_02 = 0.0;
        let mut stiffness_02_10 = 0.0;
        let mut stiffness_02_11 = 0.0;
        let mut stiffness_02_12 = 0.0;
        let mut stiffness_02_20 = 0.0;
        let mut stiffness_02_21 = 0.0;
        let mut stiffness_02_22 = 0.0;
        let mut stiffness_10_00 = 0.0;
        let mut stiffness_10_01 = 0.0;
        let mut stiffness_10_02 = 0.0;
        let mut stiffness_10_10 = 0.0;
        let mut stiffness_10_11 = 0.0;
        let mut stiffness_10_12 = 0.0;
        let mut stiffness_10_20 = 0.0;
        let mut stiffness_10_21 = 0.0;
        let mut stiffness_10_22 = 0.0;
        let mut stiffness_11_00 = 0.0;
        let mut stiffness_11_01 = 0.0;
        let mut stiffness_11_02 = 0.0;
        let mut stiffness_11_10 = 0.0;
        let mut stiffness_11_11 = 0.0;
        let mut stiffness_11_12 = 0.0;
        let mut stiffness_11_20 = 0.0;
        let mut stiffness_11_21 = 0.0;
        let mut stiffness_11_22 = 0.0;
        let mut stiffness_12_00 = 0.0;
        let mut stiffness_12_01 = 0.0;
        let mut stiffness_12_02 = 0.0;
        let mut stiffness_12_10 = 0.0;
        let mut stiffness_12_11 = 0.0;
        let mut stiffness_12_12 = 0.0;
        let mut stiffness_12_20 = 0.0;
        let mut stiffness_12_21 = 0.0;
        let mut stiffness_12_22 = 0.0;
        let mut stiffness_20_00 = 0.0;
        let mut stiffness_20_01 = 0.0;
        let mut stiffness_20_02 = 0.0;
        let mut stiffness_20_10 = 0.0;
        let mut stiffness_20_11 = 0.0;
        let mut stiffness_20_12 = 0.0;
        let mut stiffness_20_20 = 0.0;
        let mut stiffness_20_21 = 0.0;
        let mut stiffness_20_22 = 0.0;
        let mut stiffness_21_00 = 0.0;
        let mut stiffness_21_01 = 0.0;
        let mut stiffness_21_02 = 0.0;
        let mut stiffness_21_10 = 0.0;
        let mut stiffness_21_11 = 0.0;
        let mut stiffness_21_12 = 0.0;
        let mut stiffness_21_20 = 0.0;
        let mut stiffness_21_21 = 0.0;
        let mut stiffness_21_22 = 0.0;
        let mut stiffness_22_00 = 0.0;
        let mut stiffness_22_01 = 0.0;
        let mut stiffness_22_02 = 0.0;
        let mut stiffness_22_10 = 0.0;
        let mut stiffness_22_11 = 0.0;
        let mut stiffness_22_12 = 0.0;
        let mut stiffness_22_20 = 0.0;
        let mut stiffness_22_21 = 0.0;
        let mut stiffness_22_22 = 0.0;
        let mut damping_00_00 = 0.0;
        let mut damping_00_01 = 0.0;
        let mut damping_00_02 = 0.0;
        let mut damping_00_10 = 0.0;
        let mut damping_00_11 = 0.0;
        let mut damping_00_12 = 0.0;
        let mut damping_00_20 = 0.0;
        let mut damping_00_21 = 0.0;
        let mut damping_00_22 = 0.0;
        let mut damping_01_00 = 0.0;
        let mut damping_01_01 = 0.0;
        let mut damping_01_02 = 0.0;
        let mut damping_01_10 = 0.0;
        let mut damping_01_11 = 0.0;
        let mut damping_01_12 = 0.0;
        let mut damping_01_20 = 0.0;
        let mut damping_01_21 = 0.0;
        let mut damping_01_22 = 0.0;
        let mut damping_02_00 = 0.0;
        let mut damping_02_01 = 0.0;
        let mut damping_02_02 = 0.0;
        let mut damping_02_10 = 0.0;
        let mut damping_02_11 = 0.0;
        let mut damping_02_12 = 0.0;
        let mut damping_02_20 = 0.0;
        let mut damping_02_21 = 0.0;
        let mut damping_02_22 = 0.0;
        let mut damping_10_00 = 0.0;
        let mut damping_10_01 = 0.0;
        let mut damping_10_02 = 0.0;
        let mut damping_10_10 = 0.0;
        let mut damping_10_11 = 0.0;
        let mut damping_10_12 = 0.0;
        let mut damping_10_20 = 0.0;
        let mut damping_10_21 = 0.0;
        let mut damping_10_22 = 0.0;
        let mut damping_11_00 = 0.0;
        let mut damping_11_01 = 0.0;
        let mut damping_11_02 = 0.0;
        let mut damping_11_10 = 0.0;
        let mut damping_11_11 = 0.0;
        let mut damping_11_12 = 0.0;
        let mut damping_11_20 = 0.0;
        let mut damping_11_21 = 0.0;
        let mut damping_11_22 = 0.0;
        let mut damping_12_00 = 0.0;
        let mut damping_12_01 = 0.0;
        let mut damping_12_02 = 0.0;
        let mut damping_12_10 = 0.0;
        let mut damping_12_11 = 0.0;
        let mut damping_12_12 = 0.0;
        let mut damping_12_20 = 0.0;
        let mut damping_12_21 = 0.0;
        let mut damping_12_22 = 0.0;
        let mut damping_20_00 = 0.0;
        let mut damping_20_01 = 0.0;
        let mut damping_20_02 = 0.0;
        let mut damping_20_10 = 0.0;
        let mut damping_20_11 = 0.0;
        let mut damping_20_12 = 0.0;
        let mut damping_20_20 = 0.0;
        let mut damping_20_21 = 0.0;
        let mut damping_20_22 = 0.0;
        let mut damping_21_00 = 0.0;
        let mut damping_21_01 = 0.0;
        let mut damping_21_02 = 0.0;
        let mut damping_21_10 = 0.0;
        let mut damping_21_11 = 0.0;
        let mut damping_21_12 = 0.0;
        let mut damping_21_20 = 0.0;
        let mut damping_21_21 = 0.0;
        let mut damping_21_22 = 0.0;
        let mut damping_22_00 = 0.0;
        let mut damping_22_01 = 0.0;
        let mut damping_22_02 = 0.0;
        let mut damping_22_10 = 0.0;
        let mut damping_22_11 = 0.0;
        let mut damping_22_12 = 0.0;
        let mut damping_22_20 = 0.0;
        let mut damping_22_21 = 0.0;
        let mut damping_22_22 = 0.0;
        /// Columns: weight, a[s0], a[d], a[s1], b[s0], b[d], b[s1].
        const TABLE: [[f64; 7]; 5] = [
            [
                0.1184634425280945,
                0.8189613578583975,
                0.26825713022186887,
                -0.08721848808026642,
                -3.718539537815992,
                5.437079075631984,
                -1.718539537815992,
            ],
            [
                0.23931433524968324,
                0.23669655349710927,
                1.0650762031114644,
                -0.30177275660857383,
                -2.6154079303170494,
                3.230815860634099,
                -0.6154079303170494,
            ],
            [0.28444444444444444, -0.25, 1.5, -0.25, -1.0, 0.0, 1.0],
            [
                0.23931433524968324,
                -0.3017727566085737,
                1.0650762031114644,
                0.23669655349710933,
                0.6154079303170494,
                -3.230815860634099,
                2.6154079303170494,
            ],
            [
                0.1184634425280945,
                -0.08721848808026644,
                0.26825713022186914,
                0.8189613578583973,
                1.7185395378159916,
                -5.437079075631983,
                3.7185395378159916,
            ],
        ];
        for (point, table) in TABLE.iter().enumerate() {
            let t218 = length * table[0];
            let a_x = s0_x * table[1] + d_x * table[2] + s1_x * table[3];
            let a_y = s0_y * table[1] + d_y * table[2] + s1_y * table[3];
            let a_z = s0_z * table[1] + d_z * table[2] + s1_z * table[3];
            let b_x = inverse_length
                * (s0_x * table[4] + d_x * table[5] + s1_x * table[6]);
            let b_y = inverse_length
                * (s0_y * table[4] + d_y * table[5] + s1_y * table[6]);
            let b_z = inverse_length
                * (s0_z * table[4] + d_z * table[5] + s1_z * table[6]);
            let v_a_x = v_s0_x * table[1] + v_d_x * table[2] + v_s1_x * table[3];
            let v_a_y = v_s0_y * table[1] + v_d_y * table[2] + v_s1_y * table[3];
            let v_a_z = v_s0_z * table[1] + v_d_z * table[2] + v_s1_z * table[3];
            let t228 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t229 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
            let t230 = a_x * b_x + a_y * b_y + a_z * b_z;
            let t231 = b_x * b_x + b_y * b_y + b_z * b_z;
            let t232 = EA * t218;
            let t233 = EI * t218;
            let t234 = t228 * t231 - t230 * t230;
            let t235 = t228 * t228;
            let t236 = 1.0 / t235;
            let t237 = t228 * 2.0;
            let t238 = t236 * t237 / t235;
            let t239 = t237 * t238;
            let t240 = 2.0 * t236;
            let t241 = t231 * t238;
            let t242 = 0.5 * (0.5 * t232)
                - t233 * (0.5 * (t241 + (t241 + t234 * ((t240 - t239 - t239) / t235))));
            let t243 = t230 * 2.0;
            let t244 = t233 * (0.5 * (t238 * t243));
            let t245 = t233 * (0.5 * (t236 - t228 * t238));
            let t246 = t233 * (0.5 * t240);
            let t247 = 0.5 * (t232 * t216);
            let t248 = 0.5
                * (t232 * (0.5 * (t228 - 1.0) + damping * (0.5 * (t229 + t229))))
                + t233 * (0.5 * (t231 * t236 - t234 * t238));
            let t249 = t233 * (0.5 * (t236 * t243));
            let t250 = a_x * 2.0;
            let t251 = a_y * 2.0;
            let t252 = a_z * 2.0;
            let t253 = t242 * t251 + b_y * t244;
            let t254 = t242 * t252 + b_z * t244;
            let t255 = a_x * t244 + t245 * (b_x * 2.0);
            let t256 = a_y * t244 + t245 * (b_y * 2.0);
            let t257 = a_z * t244 + t245 * (b_z * 2.0);
            let t258 = t244 * t251 - b_y * t246;
            let t259 = t244 * t252 - b_z * t246;
            let t260 = a_x * t246;
            let t261 = a_y * t246;
            let t262 = a_z * t246;
            let t263 = t250 * (t242 * t250 + b_x * t244)
                + b_x * (t244 * t250 - b_x * t246);
            let t264 = t250 * t253 + b_x * t258;
            let t265 = t250 * t254 + b_x * t259;
            let t266 = t251 * t254 + b_y * t259;
            let t267 = 2.0 * t248;
            let t268 = 2.0 * (t233 * (0.5 * (t228 * t236)));
            let t269 = t247 * (v_a_x * 2.0);
            let t270 = t247 * (v_a_y * 2.0);
            let t271 = t247 * (v_a_z * 2.0);
            let t272 = t263 + t267 + t250 * t269;
            let t273 = t264 + t250 * t270;
            let t274 = t265 + t250 * t271;
            let t275 = t264 + t251 * t269;
            let t276 = t251 * t253 + b_y * t258 + t267 + t251 * t270;
            let t277 = t266 + t251 * t271;
            let t278 = t265 + t252 * t269;
            let t279 = t266 + t252 * t270;
            let t280 = t252 * t254 + b_z * t259 + t267 + t252 * t271;
            let t281 = t247 * t250;
            let t282 = t247 * t251;
            let t283 = t247 * t252;
            let t284 = t250 * t281;
            let t285 = t250 * t282;
            let t286 = t250 * t283;
            let t287 = t251 * t281;
            let t288 = t251 * t282;
            let t289 = t251 * t283;
            let t290 = t252 * t281;
            let t291 = t252 * t282;
            let t292 = t252 * t283;
            let t293 = inverse_length * (t250 * t255 - b_x * t260 - t249);
            let t294 = table[1] * t272 + table[4] * t293;
            let t295 = table[2] * t272 + table[5] * t293;
            let t296 = table[3] * t272 + table[6] * t293;
            let t297 = inverse_length * (t250 * t256 - b_x * t261);
            let t298 = table[1] * t273 + table[4] * t297;
            let t299 = table[2] * t273 + table[5] * t297;
            let t300 = table[3] * t273 + table[6] * t297;
            let t301 = inverse_length * (t250 * t257 - b_x * t262);
            let t302 = table[1] * t274 + table[4] * t301;
            let t303 = table[2] * t274 + table[5] * t301;
            let t304 = table[3] * t274 + table[6] * t301;
            let t305 = inverse_length * (t251 * t255 - b_y * t260);
            let t306 = table[1] * t275 + table[4] * t305;
            let t307 = table[2] * t275 + table[5] * t305;
            let t308 = table[3] * t275 + table[6] * t305;
            let t309 = inverse_length * (t251 * t256 - b_y * t261 - t249);
            let t310 = table[1] * t276 + table[4] * t309;
            let t311 = table[2] * t276 + table[5] * t309;
            let t312 = table[3] * t276 + table[6] * t309;
            let t313 = inverse_length * (t251 * t257 - b_y * t262);
            let t314 = table[1] * t277 + table[4] * t313;
            let t315 = table[2] * t277 + table[5] * t313;
            let t316 = table[3] * t277 + table[6] * t313;
            let t317 = inverse_length * (t252 * t255 - b_z * t260);
            let t318 = table[1] * t278 + table[4] * t317;
            let t319 = table[2] * t278 + table[5] * t317;
            let t320 = table[3] * t278 + table[6] * t317;
            let t321 = inverse_length * (t252 * t256 - b_z * t261);
            let t322 = table[1] * t279 + table[4] * t321;
            let t323 = table[2] * t279 + table[5] * t321;
            let t324 = table[3] * t279 + table[6] * t321;
            let t325 = inverse_length * (t252 * t257 - b_z * t262 - t249);
            let t326 = table[1] * t280 + table[4] * t325;
            let t327 = table[2] * t280 + table[5] * t325;
            let t328 = table[3] * t280 + table[6] * t325;
            let t329 = (t268 - a_x * t260) * t217;
            let t330 = table[1] * t293 + table[4] * t329;
            let t331 = table[2] * t293 + table[5] * t329;
            let t332 = table[3] * t293 + table[6] * t329;
            let t333 = a_x * t261 * t217;
            let t334 = table[4] * t333;
            let t335 = table[1] * t305 - t334;
            let t336 = table[5] * t333;
            let t337 = table[2] * t305 - t336;
            let t338 = table[6] * t333;
            let t339 = table[3] * t305 - t338;
            let t340 = a_x * t262 * t217;
            let t341 = table[4] * t340;
            let t342 = table[1] * t317 - t341;
            let t343 = table[5] * t340;
            let t344 = table[2] * t317 - t343;
            let t345 = table[6] * t340;
            let t346 = table[3] * t317 - t345;
            let t347 = table[1] * t297 - t334;
            let t348 = table[2] * t297 - t336;
            let t349 = table[3] * t297 - t338;
            let t350 = (t268 - a_y * t261) * t217;
            let t351 = table[1] * t309 + table[4] * t350;
            let t352 = table[2] * t309 + table[5] * t350;
            let t353 = table[3] * t309 + table[6] * t350;
            let t354 = a_y * t262 * t217;
            let t355 = table[4] * t354;
            let t356 = table[1] * t321 - t355;
            let t357 = table[5] * t354;
            let t358 = table[2] * t321 - t357;
            let t359 = table[6] * t354;
            let t360 = table[3] * t321 - t359;
            let t361 = table[1] * t301 - t341;
            let t362 = table[2] * t301 - t343;
            let t363 = table[3] * t301 - t345;
            let t364 = table[1] * t313 - t355;
            let t365 = table[2] * t313 - t357;
            let t366 = table[3] * t313 - t359;
            let t367 = (t268 - a_z * t262) * t217;
            let t368 = table[1] * t325 + table[4] * t367;
            let t369 = table[2] * t325 + table[5] * t367;
            let t370 = table[3] * t325 + table[6] * t367;
            let t371 = table[1] * t284;
            let t372 = table[2] * t284;
            let t373 = table[3] * t284;
            let t374 = table[1] * t285;
            let t375 = table[2] * t285;
            let t376 = table[3] * t285;
            let t377 = table[1] * t286;
            let t378 = table[2] * t286;
            let t379 = table[3] * t286;
            let t380 = table[1] * t287;
            let t381 = table[2] * t287;
            let t382 = table[3] * t287;
            let t383 = table[1] * t288;
            let t384 = table[2] * t288;
            let t385 = table[3] * t288;
            let t386 = table[1] * t289;
            let t387 = table[2] * t289;
            let t388 = table[3] * t289;
            let t389 = table[1] * t290;
            let t390 = table[2] * t290;
            let t391 = table[3] * t290;
            let t392 = table[1] * t291;
            let t393 = table[2] * t291;
            let t394 = table[3] * t291;
            let t395 = table[1] * t292;
            let t396 = table[2] * t292;
            let t397 = table[3] * t292;
            stiffness_00_00 += table[1] * t294 + table[4] * t330;
            stiffness_00_01 += table[1] * t298 + table[4] * t335;
            stiffness_00_02 += table[1] * t302 + table[4] * t342;
            stiffness_00_10 += table[1] * t306 + table[4] * t347;
            stiffness_00_11 += table[1] * t310 + table[4] * t351;
            stiffness_00_12 += table[1] * t314 + table[4] * t356;
            stiffness_00_20 += table[1] * t318 + table[4] * t361;
            stiffness_00_21 += table[1] * t322 + table[4] * t364;
            stiffness_00_22 += table[1] * t326 + table[4] * t368;
            stiffness_01_00 += table[1] * t295 + table[4] * t331;
            stiffness_01_01 += table[1] * t299 + table[4] * t337;
            stiffness_01_02 += table[1] * t303 + table[4] * t344;
            stiffness_01_10 += table[1] * t307 + table[4] * t348;
            stiffness_01_11 += table[1] * t311 + table[4] * t352;
            stiffness_01_12 += table[1] * t315 + table[4] * t358;
            stiffness_01_20 += table[1] * t319 + table[4] * t362;
            stiffness_01_21 += table[1] * t323 + table[4] * t365;
            stiffness_01_22 += table[1] * t327 + table[4] * t369;
            stiffness_02_00 += table[1] * t296 + table[4] * t332;
            stiffness_02_01 += table[1] * t300 + table[4] * t339;
            stiffness_02_02 += table[1] * t304 + table[4] * t346;
            stiffness_02_10 += table[1] * t308 + table[4] * t349;
            stiffness_02_11 += table[1] * t312 + table[4] * t353;
            stiffness_02_12 += table[1] * t316 + table[4] * t360;
            stiffness_02_20 += table[1] * t320 + table[4] * t363;
            stiffness_02_21 += table[1] * t324 + table[4] * t366;
            stiffness_02_22 += table[1] * t328 + table[4] * t370;
            stiffness_10_00 += table[2] * t294 + table[5] * t330;
            stiffness_10_01 += table[2] * t298 + table[5] * t335;
            stiffness_10_02 += table[2] * t302 + table[5] * t342;
            stiffness_10_10 += table[2] * t306 + table[5] * t347;
            stiffness_10_11 += table[2] * t310 + table[5] * t351;
            stiffness_10_12 += table[2] * t314 + table[5] * t356;
            stiffness_10_20 += table[2] * t318 + table[5] * t361;
            stiffness_10_21 += table[2] * t322 + table[5] * t364;
            stiffness_10_22 += table[2] * t326 + table[5] * t368;
            stiffness_11_00 += table[2] * t295 + table[5] * t331;
            stiffness_11_01 += table[2] * t299 + table[5] * t337;
            stiffness_11_02 += table[2] * t303 + table[5] * t344;
            stiffness_11_10 += table[2] * t307 + table[5] * t348;
            stiffness_11_11 += table[2] * t311 + table[5] * t352;
            stiffness_11_12 += table[2] * t315 + table[5] * t358;
            stiffness_11_20 += table[2] * t319 + table[5] * t362;
            stiffness_11_21 += table[2] * t323 + table[5] * t365;
            stiffness_11_22 += table[2] * t327 + table[5] * t369;
            stiffness_12_00 += table[2] * t296 + table[5] * t332;
            stiffness_12_01 += table[2] * t300 + table[5] * t339;
            stiffness_12_02 += table[2] * t304 + table[5] * t346;
            stiffness_12_10 += table[2] * t308 + table[5] * t349;
            stiffness_12_11 += table[2] * t312 + table[5] * t353;
            stiffness_12_12 += table[2] * t316 + table[5] * t360;
            stiffness_12_20 += table[2] * t320 + table[5] * t363;
            stiffness_12_21 += table[2] * t324 + table[5] * t366;
            stiffness_12_22 += table[2] * t328 + table[5] * t370;
            stiffness_20_00 += table[3] * t294 + table[6] * t330;
            stiffness_20_01 += table[3] * t298 + table[6] * t335;
            stiffness_20_02 += table[3] * t302 + table[6] * t342;
            stiffness_20_10 += table[3] * t306 + table[6] * t347;
            stiffness_20_11 += table[3] * t310 + table[6] * t351;
            stiffness_20_12 += table[3] * t314 + table[6] * t356;
            stiffness_20_20 += table[3] * t318 + table[6] * t361;
            stiffness_20_21 += table[3] * t322 + table[6] * t364;
            stiffness_20_22 += table[3] * t326 + table[6] * t368;
            stiffness_21_00 += table[3] * t295 + table[6] * t331;
            stiffness_21_01 += table[3] * t299 + table[6] * t337;
            stiffness_21_02 += table[3] * t303 + table[6] * t344;
            stiffness_21_10 += table[3] * t307 + table[6] * t348;
            stiffness_21_11 += table[3] * t311 + table[6] * t352;
            stiffness_21_12 += table[3] * t315 + table[6] * t358;
            stiffness_21_20 += table[3] * t319 + table[6] * t362;
            stiffness_21_21 += table[3] * t323 + table[6] * t365;
            stiffness_21_22 += table[3] * t327 + table[6] * t369;
            stiffness_22_00 += table[3] * t296 + table[6] * t332;
            stiffness_22_01 += table[3] * t300 + table[6] * t339;
            stiffness_22_02 += table[3] * t304 + table[6] * t346;
            stiffness_22_10 += table[3] * t308 + table[6] * t349;
            stiffness_22_11 += table[3] * t312 + table[6] * t353;
            stiffness_22_12 += table[3] * t316 + table[6] * t360;
            stiffness_22_20 += table[3] * t320 + table[6] * t363;
            stiffness_22_21 += table[3] * t324 + table[6] * t366;
            stiffness_22_22 += table[3] * t328 + table[6] * t370;
            damping_00_00 += table[1] * t371;
            damping_00_01 += table[1] * t374;
            damping_00_02 += table[1] * t377;
            damping_00_10 += table[1] * t380;
            damping_00_11 += table[1] * t383;
            damping_00_12 += table[1] * t386;
            damping_00_20 += table[1] * t389;
            damping_00_21 += table[1] * t392;
            damping_00_22 += table[1] * t395;
            damping_01_00 += table[1] * t372;
            damping_01_01 += table[1] * t375;
            damping_01_02 += table[1] * t378;
            damping_01_10 += table[1] * t381;
            damping_01_11 += table[1] * t384;
            damping_01_12 += table[1] * t387;
            damping_01_20 += table[1] * t390;
            damping_01_21 += table[1] * t393;
            damping_01_22 += table[1] * t396;
            damping_02_00 += table[1] * t373;
            damping_02_01 += table[1] * t376;
            damping_02_02 += table[1] * t379;
            damping_02_10 += table[1] * t382;
            damping_02_11 += table[1] * t385;
            damping_02_12 += table[1] * t388;
            damping_02_20 += table[1] * t391;
            damping_02_21 += table[1] * t394;
            damping_02_22 += table[1] * t397;
            damping_10_00 += table[2] * t371;
            damping_10_01 += table[2] * t374;
            damping_10_02 += table[2] * t377;
            damping_10_10 += table[2] * t380;
            damping_10_11 += table[2] * t383;
            damping_10_12 += table[2] * t386;
            damping_10_20 += table[2] * t389;
            damping_10_21 += table[2] * t392;
            damping_10_22 += table[2] * t395;
            damping_11_00 += table[2] * t372;
            damping_11_01 += table[2] * t375;
            damping_11_02 += table[2] * t378;
            damping_11_10 += table[2] * t381;
            damping_11_11 += table[2] * t384;
            damping_11_12 += table[2] * t387;
            damping_11_20 += table[2] * t390;
            damping_11_21 += table[2] * t393;
            damping_11_22 += table[2] * t396;
            damping_12_00 += table[2] * t373;
            damping_12_01 += table[2] * t376;
            damping_12_02 += table[2] * t379;
            damping_12_10 += table[2] * t382;
            damping_12_11 += table[2] * t385;
            damping_12_12 += table[2] * t388;
            damping_12_20 += table[2] * t391;
            damping_12_21 += table[2] * t394;
            damping_12_22 += table[2] * t397;
            damping_20_00 += table[3] * t371;
            damping_20_01 += table[3] * t374;
            damping_20_02 += table[3] * t377;
            damping_20_10 += table[3] * t380;
            damping_20_11 += table[3] * t383;
            damping_20_12 += table[3] * t386;
            damping_20_20 += table[3] * t389;
            damping_20_21 += table[3] * t392;
            damping_20_22 += table[3] * t395;
            damping_21_00 += table[3] * t372;
            damping_21_01 += table[3] * t375;
            damping_21_02 += table[3] * t378;
            damping_21_10 += table[3] * t381;
            damping_21_11 += table[3] * t384;
            damping_21_12 += table[3] * t387;
            damping_21_20 += table[3] * t390;
            damping_21_21 += table[3] * t393;
            damping_21_22 += table[3] * t396;
            damping_22_00 += table[3] * t373;
            damping_22_01 += table[3] * t376;
            damping_22_02 += table[3] * t379;
            damping_22_10 += table[3] * t382;
            damping_22_11 += table[3] * t385;
            damping_22_12 += table[3] * t388;
            damping_22_20 += table[3] * t391;
            damping_22_21 += table[3] * t394;
            damping_22_22 += table[3] * t397;
        }
        let t398 = t217 * stiffness_11_00;
        let t399 = t217 * stiffness_11_01;
        let t400 = t217 * stiffness_11_02;
        let t401 = inverse_length * stiffness_10_00;
        let t402 = inverse_length * stiffness_10_01;
        let t403 = inverse_length * stiffness_10_02;
        let t404 = inverse_length * stiffness_12_00;
        let t405 = inverse_length * stiffness_12_01;
        let t406 = inverse_length * stiffness_12_02;
        let t407 = t217 * stiffness_11_10;
        let t408 = t217 * stiffness_11_11;
        let t409 = t217 * stiffness_11_12;
        let t410 = inverse_length * stiffness_10_10;
        let t411 = inverse_length * stiffness_10_11;
        let t412 = inverse_length * stiffness_10_12;
        let t413 = inverse_length * stiffness_12_10;
        let t414 = inverse_length * stiffness_12_11;
        let t415 = inverse_length * stiffness_12_12;
        let t416 = t217 * stiffness_11_20;
        let t417 = t217 * stiffness_11_21;
        let t418 = t217 * stiffness_11_22;
        let t419 = inverse_length * stiffness_10_20;
        let t420 = inverse_length * stiffness_10_21;
        let t421 = inverse_length * stiffness_10_22;
        let t422 = inverse_length * stiffness_12_20;
        let t423 = inverse_length * stiffness_12_21;
        let t424 = inverse_length * stiffness_12_22;
        let t425 = inverse_length * stiffness_01_00;
        let t426 = inverse_length * stiffness_01_01;
        let t427 = inverse_length * stiffness_01_02;
        let t428 = inverse_length * stiffness_01_10;
        let t429 = inverse_length * stiffness_01_11;
        let t430 = inverse_length * stiffness_01_12;
        let t431 = inverse_length * stiffness_01_20;
        let t432 = inverse_length * stiffness_01_21;
        let t433 = inverse_length * stiffness_01_22;
        let t434 = inverse_length * stiffness_21_00;
        let t435 = inverse_length * stiffness_21_01;
        let t436 = inverse_length * stiffness_21_02;
        let t437 = inverse_length * stiffness_21_10;
        let t438 = inverse_length * stiffness_21_11;
        let t439 = inverse_length * stiffness_21_12;
        let t440 = inverse_length * stiffness_21_20;
        let t441 = inverse_length * stiffness_21_21;
        let t442 = inverse_length * stiffness_21_22;
        let t443 = t217 * damping_11_00;
        let t444 = t217 * damping_11_01;
        let t445 = t217 * damping_11_02;
        let t446 = inverse_length * damping_10_00;
        let t447 = inverse_length * damping_10_01;
        let t448 = inverse_length * damping_10_02;
        let t449 = inverse_length * damping_12_00;
        let t450 = inverse_length * damping_12_01;
        let t451 = inverse_length * damping_12_02;
        let t452 = t217 * damping_11_10;
        let t453 = t217 * damping_11_11;
        let t454 = t217 * damping_11_12;
        let t455 = inverse_length * damping_10_10;
        let t456 = inverse_length * damping_10_11;
        let t457 = inverse_length * damping_10_12;
        let t458 = inverse_length * damping_12_10;
        let t459 = inverse_length * damping_12_11;
        let t460 = inverse_length * damping_12_12;
        let t461 = t217 * damping_11_20;
        let t462 = t217 * damping_11_21;
        let t463 = t217 * damping_11_22;
        let t464 = inverse_length * damping_10_20;
        let t465 = inverse_length * damping_10_21;
        let t466 = inverse_length * damping_10_22;
        let t467 = inverse_length * damping_12_20;
        let t468 = inverse_length * damping_12_21;
        let t469 = inverse_length * damping_12_22;
        let t470 = inverse_length * damping_01_00;
        let t471 = inverse_length * damping_01_01;
        let t472 = inverse_length * damping_01_02;
        let t473 = inverse_length * damping_01_10;
        let t474 = inverse_length * damping_01_11;
        let t475 = inverse_length * damping_01_12;
        let t476 = inverse_length * damping_01_20;
        let t477 = inverse_length * damping_01_21;
        let t478 = inverse_length * damping_01_22;
        let t479 = inverse_length * damping_21_00;
        let t480 = inverse_length * damping_21_01;
        let t481 = inverse_length * damping_21_02;
        let t482 = inverse_length * damping_21_10;
        let t483 = inverse_length * damping_21_11;
        let t484 = inverse_length * damping_21_12;
        let t485 = inverse_length * damping_21_20;
        let t486 = inverse_length * damping_21_21;
        let t487 = inverse_length * damping_21_22;
        stiffness[0] += t398;
        stiffness[1] += t399;
        stiffness[2] += t400;
        stiffness[3] -= t401;
        stiffness[4] -= t402;
        stiffness[5] -= t403;
        stiffness[6] -= t398;
        stiffness[7] -= t399;
        stiffness[8] -= t400;
        stiffness[9] -= t404;
        stiffness[10] -= t405;
        stiffness[11] -= t406;
        stiffness[12] += t407;
        stiffness[13] += t408;
        stiffness[14] += t409;
        stiffness[15] -= t410;
        stiffness[16] -= t411;
        stiffness[17] -= t412;
        stiffness[18] -= t407;
        stiffness[19] -= t408;
        stiffness[20] -= t409;
        stiffness[21] -= t413;
        stiffness[22] -= t414;
        stiffness[23] -= t415;
        stiffness[24] += t416;
        stiffness[25] += t417;
        stiffness[26] += t418;
        stiffness[27] -= t419;
        stiffness[28] -= t420;
        stiffness[29] -= t421;
        stiffness[30] -= t416;
        stiffness[31] -= t417;
        stiffness[32] -= t418;
        stiffness[33] -= t422;
        stiffness[34] -= t423;
        stiffness[35] -= t424;
        stiffness[36] -= t425;
        stiffness[37] -= t426;
        stiffness[38] -= t427;
        stiffness[39] += stiffness_00_00;
        stiffness[40] += stiffness_00_01;
        stiffness[41] += stiffness_00_02;
        stiffness[42] += t425;
        stiffness[43] += t426;
        stiffness[44] += t427;
        stiffness[45] += stiffness_02_00;
        stiffness[46] += stiffness_02_01;
        stiffness[47] += stiffness_02_02;
        stiffness[48] -= t428;
        stiffness[49] -= t429;
        stiffness[50] -= t430;
        stiffness[51] += stiffness_00_10;
        stiffness[52] += stiffness_00_11;
        stiffness[53] += stiffness_00_12;
        stiffness[54] += t428;
        stiffness[55] += t429;
        stiffness[56] += t430;
        stiffness[57] += stiffness_02_10;
        stiffness[58] += stiffness_02_11;
        stiffness[59] += stiffness_02_12;
        stiffness[60] -= t431;
        stiffness[61] -= t432;
        stiffness[62] -= t433;
        stiffness[63] += stiffness_00_20;
        stiffness[64] += stiffness_00_21;
        stiffness[65] += stiffness_00_22;
        stiffness[66] += t431;
        stiffness[67] += t432;
        stiffness[68] += t433;
        stiffness[69] += stiffness_02_20;
        stiffness[70] += stiffness_02_21;
        stiffness[71] += stiffness_02_22;
        stiffness[72] -= t398;
        stiffness[73] -= t399;
        stiffness[74] -= t400;
        stiffness[75] += t401;
        stiffness[76] += t402;
        stiffness[77] += t403;
        stiffness[78] += t398;
        stiffness[79] += t399;
        stiffness[80] += t400;
        stiffness[81] += t404;
        stiffness[82] += t405;
        stiffness[83] += t406;
        stiffness[84] -= t407;
        stiffness[85] -= t408;
        stiffness[86] -= t409;
        stiffness[87] += t410;
        stiffness[88] += t411;
        stiffness[89] += t412;
        stiffness[90] += t407;
        stiffness[91] += t408;
        stiffness[92] += t409;
        stiffness[93] += t413;
        stiffness[94] += t414;
        stiffness[95] += t415;
        stiffness[96] -= t416;
        stiffness[97] -= t417;
        stiffness[98] -= t418;
        stiffness[99] += t419;
        stiffness[100] += t420;
        stiffness[101] += t421;
        stiffness[102] += t416;
        stiffness[103] += t417;
        stiffness[104] += t418;
        stiffness[105] += t422;
        stiffness[106] += t423;
        stiffness[107] += t424;
        stiffness[108] -= t434;
        stiffness[109] -= t435;
        stiffness[110] -= t436;
        stiffness[111] += stiffness_20_00;
        stiffness[112] += stiffness_20_01;
        stiffness[113] += stiffness_20_02;
        stiffness[114] += t434;
        stiffness[115] += t435;
        stiffness[116] += t436;
        stiffness[117] += stiffness_22_00;
        stiffness[118] += stiffness_22_01;
        stiffness[119] += stiffness_22_02;
        stiffness[120] -= t437;
        stiffness[121] -= t438;
        stiffness[122] -= t439;
        stiffness[123] += stiffness_20_10;
        stiffness[124] += stiffness_20_11;
        stiffness[125] += stiffness_20_12;
        stiffness[126] += t437;
        stiffness[127] += t438;
        stiffness[128] += t439;
        stiffness[129] += stiffness_22_10;
        stiffness[130] += stiffness_22_11;
        stiffness[131] += stiffness_22_12;
        stiffness[132] -= t440;
        stiffness[133] -= t441;
        stiffness[134] -= t442;
        stiffness[135] += stiffness_20_20;
        stiffness[136] += stiffness_20_21;
        stiffness[137] += stiffness_20_22;
        stiffness[138] += t440;
        stiffness[139] += t441;
        stiffness[140] += t442;
        stiffness[141] += stiffness_22_20;
        stiffness[142] += stiffness_22_21;
        stiffness[143] += stiffness_22_22;
        damping_matrix[0] += t443;
        damping_matrix[1] += t444;
        damping_matrix[2] += t445;
        damping_matrix[3] -= t446;
        damping_matrix[4] -= t447;
        damping_matrix[5] -= t448;
        damping_matrix[6] -= t443;
        damping_matrix[7] -= t444;
        damping_matrix[8] -= t445;
        damping_matrix[9] -= t449;
        damping_matrix[10] -= t450;
        damping_matrix[11] -= t451;
        damping_matrix[12] += t452;
        damping_matrix[13] += t453;
        damping_matrix[14] += t454;
        damping_matrix[15] -= t455;
        damping_matrix[16] -= t456;
        damping_matrix[17] -= t457;
        damping_matrix[18] -= t452;
        damping_matrix[19] -= t453;
        damping_matrix[20] -= t454;
        damping_matrix[21] -= t458;
        damping_matrix[22] -= t459;
        damping_matrix[23] -= t460;
        damping_matrix[24] += t461;
        damping_matrix[25] += t462;
        damping_matrix[26] += t463;
        damping_matrix[27] -= t464;
        damping_matrix[28] -= t465;
        damping_matrix[29] -= t466;
        damping_matrix[30] -= t461;
        damping_matrix[31] -= t462;
        damping_matrix[32] -= t463;
        damping_matrix[33] -= t467;
        damping_matrix[34] -= t468;
        damping_matrix[35] -= t469;
        damping_matrix[36] -= t470;
        damping_matrix[37] -= t471;
        damping_matrix[38] -= t472;
        damping_matrix[39] += damping_00_00;
        damping_matrix[40] += damping_00_01;
        damping_matrix[41] += damping_00_02;
        damping_matrix[42] += t470;
        damping_matrix[43] += t471;
        damping_matrix[44] += t472;
        damping_matrix[45] += damping_02_00;
        damping_matrix[46] += damping_02_01;
        damping_matrix[47] += damping_02_02;
        damping_matrix[48] -= t473;
        damping_matrix[49] -= t474;
        damping_matrix[50] -= t475;
        damping_matrix[51] += damping_00_10;
        damping_matrix[52] += damping_00_11;
        damping_matrix[53] += damping_00_12;
        damping_matrix[54] += t473;
        damping_matrix[55] += t474;
        damping_matrix[56] += t475;
        damping_matrix[57] += damping_02_10;
        damping_matrix[58] += damping_02_11;
        damping_matrix[59] += damping_02_12;
        damping_matrix[60] -= t476;
        damping_matrix[61] -= t477;
        damping_matrix[62] -= t478;
        damping_matrix[63] += damping_00_20;
        damping_matrix[64] += damping_00_21;
        damping_matrix[65] += damping_00_22;
        damping_matrix[66] += t476;
        damping_matrix[67] += t477;
        damping_matrix[68] += t478;
        damping_matrix[69] += damping_02_20;
        damping_matrix[70] += damping_02_21;
        damping_matrix[71] += damping_02_22;
        damping_matrix[72] -= t443;
        damping_matrix[73] -= t444;
        damping_matrix[74] -= t445;
        damping_matrix[75] += t446;
        damping_matrix[76] += t447;
        damping_matrix[77] += t448;
        damping_matrix[78] += t443;
        damping_matrix[79] += t444;
        damping_matrix[80] += t445;
        damping_matrix[81] += t449;
        damping_matrix[82] += t450;
        damping_matrix[83] += t451;
        damping_matrix[84] -= t452;
        damping_matrix[85] -= t453;
        damping_matrix[86] -= t454;
        damping_matrix[87] += t455;
        damping_matrix[88] += t456;
        damping_matrix[89] += t457;
        damping_matrix[90] += t452;
        damping_matrix[91] += t453;
        damping_matrix[92] += t454;
        damping_matrix[93] += t458;
        damping_matrix[94] += t459;
        damping_matrix[95] += t460;
        damping_matrix[96] -= t461;
        damping_matrix[97] -= t462;
        damping_matrix[98] -= t463;
        damping_matrix[99] += t464;
        damping_matrix[100] += t465;
        damping_matrix[101] += t466;
        damping_matrix[102] += t461;
        damping_matrix[103] += t462;
        damping_matrix[104] += t463;
        damping_matrix[105] += t467;
        damping_matrix[106] += t468;
        damping_matrix[107] += t469;
        damping_matrix[108] -= t479;
        damping_matrix[109] -= t480;
        damping_matrix[110] -= t481;
        damping_matrix[111] += damping_20_00;
        damping_matrix[112] += damping_20_01;
        damping_matrix[113] += damping_20_02;
        damping_matrix[114] += t479;
        damping_matrix[115] += t480;
        damping_matrix[116] += t481;
        damping_matrix[117] += damping_22_00;
        damping_matrix[118] += damping_22_01;
        damping_matrix[119] += damping_22_02;
        damping_matrix[120] -= t482;
        damping_matrix[121] -= t483;
        damping_matrix[122] -= t484;
        damping_matrix[123] += damping_20_10;
        damping_matrix[124] += damping_20_11;
        damping_matrix[125] += damping_20_12;
        damping_matrix[126] += t482;
        damping_matrix[127] += t483;
        damping_matrix[128] += t484;
        damping_matrix[129] += damping_22_10;
        damping_matrix[130] += damping_22_11;
        damping_matrix[131] += damping_22_12;
        damping_matrix[132] -= t485;
        damping_matrix[133] -= t486;
        damping_matrix[134] -= t487;
        damping_matrix[135] += damping_20_20;
        damping_matrix[136] += damping_20_21;
        damping_matrix[137] += damping_20_22;
        damping_matrix[138] += t485;
        damping_matrix[139] += t486;
        damping_matrix[140] += t487;
        damping_matrix[141] += damping_22_20;
        damping_matrix[142] += damping_22_21;
        damping_matrix[143] += damping_22_22;
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, in a loop.
    ///
    /// Operations: 114 additions, 218 multiplications, 6 divisions.
    pub fn cable_spatial_exact_damped_strain_energy(
        row: &CableSpatialExactDamped,
        q: &[f64; 12],
        energy: &mut f64,
    ) {
        let CableSpatialExactDamped { length, EA, EI, damping, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let mut energy_sum = 0.0;
        /// Columns: weight, a[s0], a[d], a[s1], b[s0], b[d], b[s1].
        const TABLE: [[f64; 7]; 5] = [
            [
                0.1184634425280945,
                0.8189613578583975,
                0.26825713022186887,
                -0.08721848808026642,
                -3.718539537815992,
                5.437079075631984,
                -1.718539537815992,
            ],
            [
                0.23931433524968324,
                0.23669655349710927,
                1.0650762031114644,
                -0.30177275660857383,
                -2.6154079303170494,
                3.230815860634099,
                -0.6154079303170494,
            ],
            [0.28444444444444444, -0.25, 1.5, -0.25, -1.0, 0.0, 1.0],
            [
                0.23931433524968324,
                -0.3017727566085737,
                1.0650762031114644,
                0.23669655349710933,
                0.6154079303170494,
                -3.230815860634099,
                2.6154079303170494,
            ],
            [
                0.1184634425280945,
                -0.08721848808026644,
                0.26825713022186914,
                0.8189613578583973,
                1.7185395378159916,
                -5.437079075631983,
                3.7185395378159916,
            ],
        ];
        for (point, table) in TABLE.iter().enumerate() {
            let t39 = length * table[0];
            let a_x = s0_x * table[1] + d_x * table[2] + s1_x * table[3];
            let a_y = s0_y * table[1] + d_y * table[2] + s1_y * table[3];
            let a_z = s0_z * table[1] + d_z * table[2] + s1_z * table[3];
            let b_x = inverse_length
                * (s0_x * table[4] + d_x * table[5] + s1_x * table[6]);
            let b_y = inverse_length
                * (s0_y * table[4] + d_y * table[5] + s1_y * table[6]);
            let b_z = inverse_length
                * (s0_z * table[4] + d_z * table[5] + s1_z * table[6]);
            let t46 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t47 = t46 * (b_x * b_x + b_y * b_y + b_z * b_z)
                - (a_x * b_x + a_y * b_y + a_z * b_z).powi(2);
            let t48 = 0.5 * (EA * t39) * (0.5 * (t46 - 1.0)).powi(2)
                + EI * t39 * (0.5 * (t47 * (1.0 / (t46 * t46))));
            energy_sum += t48;
        }
        *energy += energy_sum;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_spatial_exact_damped_mass(
        row: &CableSpatialExactDamped,
        mass: &mut [f64; 16],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[0][0];
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[0][2];
        let mass_r0_s1 = t16 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[0][3];
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[1][1];
        let mass_s0_r1 = t16 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[1][2];
        let mass_s0_s1 = t20 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[1][3];
        let mass_r1_s1 = t16 * CABLE_SPATIAL_EXACT_DAMPED_MASS_MATRIX[2][3];
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
    pub fn cable_spatial_exact_damped_shapes_position_0(
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
    pub fn cable_spatial_exact_damped_shapes_position_1(
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
    pub fn cable_spatial_exact_damped_shapes_position_2(
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
    /// Operations: 27 additions, 76 multiplications, 4 divisions.
    pub fn cable_spatial_exact_damped_field_forces(
        row: &CableSpatialExactDamped,
        stress_free: &[f64; 6],
        fields: &[f64; 6],
        rates: &[f64; 6],
        forces: &mut [f64; 6],
    ) {
        let CableSpatialExactDamped { length, EA, EI, damping, .. } = *row;
        let t27 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2];
        let t28 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t29 = fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5];
        let t30 = t27 * t29 - t28 * t28;
        let t31 = t27 * t27;
        let t32 = 1.0 / t31;
        let t33 = 0.5 * (t27 - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t34 = fields[0] * 2.0;
        let t35 = fields[1] * 2.0;
        let t36 = fields[2] * 2.0;
        let t37 = EA
            * (t33
                + damping * (0.5 * (rates[0] * t34 + rates[1] * t35 + rates[2] * t36)));
        let t38 = t28 * 2.0;
        let t39 = t27 * 2.0;
        let t40 = t32 * (t29 * t34 - fields[3] * t38) - t30 * (t32 * (t34 * t39) / t31);
        let t41 = t32 * (t29 * t35 - fields[4] * t38) - t30 * (t32 * (t35 * t39) / t31);
        let t42 = t32 * (t29 * t36 - fields[5] * t38) - t30 * (t32 * (t36 * t39) / t31);
        forces[0] = t37 * (0.5 * t34) + EI * (0.5 * t40);
        forces[1] = t37 * (0.5 * t35) + EI * (0.5 * t41);
        forces[2] = t37 * (0.5 * t36) + EI * (0.5 * t42);
        forces[3] = EI * (0.5 * (t32 * (t27 * (fields[3] * 2.0) - fields[0] * t38)));
        forces[4] = EI * (0.5 * (t32 * (t27 * (fields[4] * 2.0) - fields[1] * t38)));
        forces[5] = EI * (0.5 * (t32 * (t27 * (fields[5] * 2.0) - fields[2] * t38)));
    }
    /// Motion of frame `pin_frame` and its first three derivatives.
    ///
    /// Moves with the crank's pin, which begins at the origin; the crank's axis lies below it.
    ///
    /// Operations: 18 additions, 37 multiplications, 6 divisions, 4 function calls.
    pub fn frame_pin_frame(
        model: &SliderCrank,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let t15 = model.omega_s / model.T_s;
        let t16 = (model.T_s / 6.283185307179586).powi(2);
        let t17 = t * 6.283185307179586 / model.T_s;
        let t18 = t17.cos();
        let theta = (if t <= model.T_s {
            t15 * (t * t / 2.0 + t16 * (t18 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t20 = theta.sin();
        let t21 = theta.cos();
        let t22 = 6.283185307179586 / model.T_s;
        let t23 = t22 * t17.sin();
        let t24 = (if t <= model.T_s { t15 * (t - t16 * t23) } else { model.omega_s });
        let t25 = t21 * t24;
        let t26 = t20 * t24;
        let t27 = (if t <= model.T_s {
            t15 * (1.0 - t16 * (t22 * (t18 * t22)))
        } else {
            0.0
        });
        let t28 = t21 * t27 - t24 * t26;
        let t29 = t24 * t25 + t20 * t27;
        let t30 = (if t <= model.T_s { t15 * (t16 * (t22 * (t22 * t23))) } else { 0.0 });
        let t31 = t26 * t27;
        let t32 = t25 * t27;
        motion.position[1] = -0.14 * t20;
        motion.position[2] = 0.14 * (t21 - 1.0);
        motion.velocity[1] = -0.14 * t25;
        motion.velocity[2] = -0.14 * t26;
        motion.acceleration[1] = -0.14 * t28;
        motion.acceleration[2] = -0.14 * t29;
        motion.jerk[1] = -0.14 * (t21 * t30 - t31 - (t31 + t24 * t29));
        motion.jerk[2] = -0.14 * (t32 + t24 * t28 + (t32 + t20 * t30));
    }
    /// Free frame `rod`: its start relative to its parent, and its rigid parts.
    ///
    /// Frame of the rod.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_rod(model: &SliderCrank, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.axis[2] = 1.0;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn joint_root_referenced_position(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - data.point[1];
        rows[2] = q[2] - data.point[2];
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jacobian(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[7] = 1.0;
        jacobian[14] = 1.0;
    }
    /// Joint `root`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_prescribed(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
    }
    /// Joint `chord_y`: conditions, position level.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_position(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[1] - data.point[1];
    }
    /// Joint `chord_y`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_jacobian(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[1] = 1.0;
    }
    /// Joint `chord_y`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_prescribed(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
    }
    /// Joint `chord_z`: conditions, position level.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_position(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[2] - data.point[2];
    }
    /// Joint `chord_z`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_jacobian(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[2] = 1.0;
    }
    /// Joint `chord_z`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_prescribed(
        model: &SliderCrank,
        t: f64,
        data: &::rncf::emitted::JointData,
        prescribed: &mut ::rncf::emitted::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
    }
    /// Constraint `root` (pin in absolute coordinates): rows C(z, t).
    ///
    /// Of `root`: `z[0]` a place on `beam`; `z[1]` fixed in `rod`, where another vector starts (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[1][0][0]`
    /// * position y: `z[0][0][1] - z[1][0][1]`
    /// * position z: `z[0][0][2] - z[1][0][2]`
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_position_root(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][0][0] - z[1][0][0];
        rows[1] = z[0][0][1] - z[1][0][1];
        rows[2] = z[0][0][2] - z[1][0][2];
    }
    /// Constraint `root` (pin in absolute coordinates): their rate dC/dt.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_velocity_root(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][1][0] - z[1][1][0];
        rows[1] = z[0][1][1] - z[1][1][1];
        rows[2] = z[0][1][2] - z[1][1][2];
    }
    /// Constraint `root` (pin in absolute coordinates): their second time derivative.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_acceleration_root(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][2][0] - z[1][2][0];
        rows[1] = z[0][2][1] - z[1][2][1];
        rows[2] = z[0][2][2] - z[1][2][2];
    }
    /// Constraint `root` (pin in absolute coordinates): their third time derivative.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_jerk_root(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = z[0][3][0] - z[1][3][0];
        rows[1] = z[0][3][1] - z[1][3][1];
        rows[2] = z[0][3][2] - z[1][3][2];
    }
    /// Constraint `root` (pin in absolute coordinates): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_root(
        model: &SliderCrank,
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): rows C(z, t).
    ///
    /// Of `chord_y`: `z[0]` a place on `beam`; `z[1]` fixed in `rod`, where another vector starts; `z[2]` a direction of `rod` (inertial axes).
    ///
    /// * position y: `z[2][0][0] * (z[0][0][0] - z[1][0][0]) + z[2][0][1] * (z[0][0][1] - z[1][0][1]) + z[2][0][2] * (z[0][0][2] - z[1][0][2])`
    ///
    /// Operations: 5 additions, 3 multiplications.
    pub fn constraint_position_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        rows[0] = z[2][0][0] * (z[0][0][0] - z[1][0][0])
            + z[2][0][1] * (z[0][0][1] - z[1][0][1])
            + z[2][0][2] * (z[0][0][2] - z[1][0][2]);
    }
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): their rate dC/dt.
    ///
    /// Operations: 11 additions, 6 multiplications.
    pub fn constraint_velocity_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): their second time derivative.
    ///
    /// Operations: 20 additions, 9 multiplications.
    pub fn constraint_acceleration_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): their third time derivative.
    ///
    /// Operations: 32 additions, 12 multiplications.
    pub fn constraint_jerk_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_gradient_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_rate_gradient_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
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
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_hessian_chord_y(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
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
    /// Constraint `cross_axis` (constraint): rows C(z, t).
    ///
    /// Of `cross_axis`: `z[0]` a direction of `rod` (inertial axes).
    ///
    /// * value
    ///
    /// Operations: 5 additions, 8 multiplications, 5 divisions, 3 function calls.
    pub fn constraint_position_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t17 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t17
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        rows[0] = z[0][0][1] * theta.cos() + z[0][0][2] * theta.sin();
    }
    /// Constraint `cross_axis` (constraint): their rate dC/dt.
    ///
    /// Operations: 9 additions, 15 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_velocity_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t19 = model.omega_s / model.T_s;
        let t20 = (model.T_s / 6.283185307179586).powi(2);
        let t21 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t19 * (t * t / 2.0 + t20 * (t21.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = (if t <= model.T_s {
            t19 * (t - t20 * (6.283185307179586 / model.T_s * t21.sin()))
        } else {
            model.omega_s
        });
        let t26 = z[0][1][1] * t23 - z[0][0][1] * (t24 * t25)
            + (z[0][1][2] * t24 + z[0][0][2] * (t23 * t25));
        rows[0] = t26;
    }
    /// Constraint `cross_axis` (constraint): their second time derivative.
    ///
    /// Operations: 17 additions, 25 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_acceleration_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t21 = model.omega_s / model.T_s;
        let t22 = (model.T_s / 6.283185307179586).powi(2);
        let t23 = t * 6.283185307179586 / model.T_s;
        let t24 = t23.cos();
        let theta = (if t <= model.T_s {
            t21 * (t * t / 2.0 + t22 * (t24 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t26 = theta.cos();
        let t27 = theta.sin();
        let t28 = 6.283185307179586 / model.T_s;
        let t29 = (if t <= model.T_s {
            t21 * (t - t22 * (t28 * t23.sin()))
        } else {
            model.omega_s
        });
        let t30 = t27 * t29;
        let t31 = t26 * t29;
        let t32 = (if t <= model.T_s {
            t21 * (1.0 - t22 * (t28 * (t24 * t28)))
        } else {
            0.0
        });
        let t33 = z[0][1][1] * t30;
        let t34 = z[0][1][2] * t31;
        let t35 = z[0][2][1] * t26 - t33 - (t33 + z[0][0][1] * (t29 * t31 + t27 * t32))
            + (z[0][2][2] * t27 + t34 + (t34 + z[0][0][2] * (t26 * t32 - t29 * t30)));
        rows[0] = t35;
    }
    /// Constraint `cross_axis` (constraint): their third time derivative.
    ///
    /// Operations: 30 additions, 37 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_jerk_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t23 = model.omega_s / model.T_s;
        let t24 = (model.T_s / 6.283185307179586).powi(2);
        let t25 = t * 6.283185307179586 / model.T_s;
        let t26 = t25.cos();
        let theta = (if t <= model.T_s {
            t23 * (t * t / 2.0 + t24 * (t26 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t28 = theta.cos();
        let t29 = theta.sin();
        let t30 = 6.283185307179586 / model.T_s;
        let t31 = t30 * t25.sin();
        let t32 = (if t <= model.T_s { t23 * (t - t24 * t31) } else { model.omega_s });
        let t33 = t29 * t32;
        let t34 = t28 * t32;
        let t35 = (if t <= model.T_s {
            t23 * (1.0 - t24 * (t30 * (t26 * t30)))
        } else {
            0.0
        });
        let t36 = t32 * t34 + t29 * t35;
        let t37 = t28 * t35 - t32 * t33;
        let t38 = (if t <= model.T_s { t23 * (t24 * (t30 * (t30 * t31))) } else { 0.0 });
        let t39 = t34 * t35;
        let t40 = z[0][2][1] * t33;
        let t41 = z[0][1][1] * t36;
        let t42 = t40 + t41;
        let t43 = z[0][3][1] * t28 - t40 - t42
            - (t42 + (t41 + z[0][0][1] * (t39 + t32 * t37 + (t39 + t29 * t38))));
        let t44 = t33 * t35;
        let t45 = z[0][2][2] * t34;
        let t46 = z[0][1][2] * t37;
        let t47 = t45 + t46;
        let t48 = z[0][3][2] * t29 + t45 + t47
            + (t47 + (t46 + z[0][0][2] * (t28 * t38 - t44 - (t44 + t32 * t36))));
        rows[0] = t43 + t48;
    }
    /// Constraint `cross_axis` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 4 additions, 6 multiplications, 5 divisions, 3 function calls.
    pub fn constraint_gradient_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        let t15 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t15
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        gradient[1] = theta.cos();
        gradient[2] = theta.sin();
    }
    /// Constraint `cross_axis` (constraint): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 6 additions, 11 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_rate_gradient_cross_axis(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        let velocity = &velocity[..1];
        let t15 = model.omega_s / model.T_s;
        let t16 = (model.T_s / 6.283185307179586).powi(2);
        let t17 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t15 * (t * t / 2.0 + t16 * (t17.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t19 = (if t <= model.T_s {
            t15 * (t - t16 * (6.283185307179586 / model.T_s * t17.sin()))
        } else {
            model.omega_s
        });
        gradient[1] = -theta.sin() * t19;
        gradient[2] = theta.cos() * t19;
    }
    /// Constraint `guide_y` (constraint): rows C(z, t).
    ///
    /// Of `guide_y`: `z[0]` a place on `beam` (inertial axes).
    ///
    /// * value: `z[0][0][1]`
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_position_guide_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][0][1];
    }
    /// Constraint `guide_y` (constraint): their rate dC/dt.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_velocity_guide_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][1][1];
    }
    /// Constraint `guide_y` (constraint): their second time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_acceleration_guide_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][2][1];
    }
    /// Constraint `guide_y` (constraint): their third time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_jerk_guide_y(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][3][1];
    }
    /// Constraint `guide_y` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_guide_y(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        gradient[1] = 1.0;
    }
    /// Constraint `guide_z` (constraint): rows C(z, t).
    ///
    /// Of `guide_z`: `z[0]` a place on `beam` (inertial axes).
    ///
    /// * value: `z[0][0][2]`
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_position_guide_z(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][0][2];
    }
    /// Constraint `guide_z` (constraint): their rate dC/dt.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_velocity_guide_z(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][1][2];
    }
    /// Constraint `guide_z` (constraint): their second time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_acceleration_guide_z(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][2][2];
    }
    /// Constraint `guide_z` (constraint): their third time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_jerk_guide_z(
        model: &SliderCrank,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][3][2];
    }
    /// Constraint `guide_z` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_guide_z(
        model: &SliderCrank,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        gradient[2] = 1.0;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &SliderCrank, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 15 additions, 14 multiplications, 5 divisions, 4 function calls.
    pub fn outputs(model: &SliderCrank, t: f64, observed: &[f64], out: &mut [f64]) {
        let t25 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t25
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t27 = (observed[1] - 0.5 * (observed[2] + observed[3])).powi(2)
            + (observed[4] - 0.5 * (observed[5] + observed[6])).powi(2);
        out[0] = observed[0];
        out[1] = observed[0]
            - (0.09 - 0.019600000000000003 * (2.0 - 2.0 * theta.cos())).sqrt();
        out[2] = (t27 + (observed[7] - 0.5 * (observed[8] + observed[9])).powi(2))
            .sqrt();
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &SliderCrank, run: &mut ::rncf::RunDefaults) {
        run.t_end = 2.5;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: SliderCrank,
        pub row_beam: CableSpatialExactDamped,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &SliderCrank) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
            }
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
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.15),
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
                    component: 0,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.15),
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
                    component: 1,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::At(0.15),
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::emitted::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    what: ::rncf::emitted::PointQuantity::Position,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            3
        }
        fn frame_count(&self) -> usize {
            3
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "pin_frame", "rod"][frame]
        }
        fn conservative(&self) -> bool {
            false
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 1];
            kinks(&self.model, &mut times);
            times.to_vec()
        }
        fn gaps(&self, t: f64, out: &mut ::std::vec::Vec<[f64; 2]>) {}
        fn courses(&self) -> ::std::vec::Vec<::rncf::emitted::Courses> {
            ::std::vec::Vec::new()
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::emitted::FrameMotion]) {
            motions[0] = ::rncf::emitted::FrameMotion::INERTIAL;
            frame_pin_frame(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("body `beam` is damped")
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            ::rncf::emitted::non_negative(
                "fixture `slider`",
                "mass",
                model.slider_mass,
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
                    frame: 2,
                    parent: 1,
                    is_body: false,
                    motions: ::rncf::emitted::Motions::Turning,
                    ..still.clone()
                },
            ]);
            free_rod(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::Start,
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 2,
                    marker: 0,
                },
                ::rncf::emitted::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                },
                ::rncf::emitted::MarkerSpec::Matching {
                    frame: 2,
                    marker: 2,
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 0.0, 1.0],
                },
            ])
        }
    }
    impl ::rncf::emitted::Bodies for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::emitted::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::BodySpec {
                    name: "beam",
                    kind: 0,
                    instance: None,
                    frame: 2,
                    axes: &[0, 1, 2],
                    line: ::rncf::emitted::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [0.3, 0.0, 0.0],
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
                    damps: true,
                    tie: ::rncf::emitted::FrameTie::Joints,
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
                "material `_soft`",
                "density",
                7870.0,
                "kg/m^3",
            )?;
            let young = ::rncf::emitted::positive(
                "material `_soft`",
                "young",
                200000000.0,
                "Pa",
            )?;
            let damping = ::rncf::emitted::non_negative(
                "material `_soft`",
                "damping",
                model.damping,
                "s",
            )?;
            let area = ::rncf::emitted::positive(
                "section `round`",
                "area",
                0.00020106192982974675,
                "m^2",
            )?;
            let second_moment = ::rncf::emitted::positive(
                "section `round`",
                "second_moment",
                3.216990877275948e-9,
                "m^4",
            )?;
            self.row_beam = CableSpatialExactDamped {
                length,
                EA: young * area,
                EI: young * second_moment,
                rhoA: density * area,
                damping: damping,
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
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::FixtureSpec {
                    name: "slider",
                    body: 0,
                    at: ::rncf::emitted::Place::End,
                    constants: [
                        model.slider_mass,
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
            cable_spatial_exact_damped_mass(
                &self.row_beam,
                ::rncf::emitted::array_mut(mass),
            );
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            cable_spatial_exact_damped_elastic_force(
                &self.row_beam,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array(v),
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
            cable_spatial_exact_damped_elastic_tangent(
                &self.row_beam,
                ::rncf::emitted::array(q),
                ::rncf::emitted::array(v),
                ::rncf::emitted::array_mut(stiffness),
                ::rncf::emitted::array_mut(damping),
            );
        }
        fn elastic_force4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            force: &mut [[f64; 4]],
        ) {
            ::rncf::emitted::elastic_force_one_by_one(self, elements, q, v, force);
        }
        fn elastic_tangent4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            stiffness: &mut [[f64; 4]],
            damping: &mut [[f64; 4]],
        ) {
            ::rncf::emitted::elastic_tangent_one_by_one(
                self,
                elements,
                q,
                v,
                stiffness,
                damping,
            );
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            cable_spatial_exact_damped_strain_energy(
                &self.row_beam,
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
                    cable_spatial_exact_damped_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 1) => {
                    cable_spatial_exact_damped_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::emitted::array_mut(weights),
                    )
                }
                (::rncf::emitted::Interpolant::Position, 2) => {
                    cable_spatial_exact_damped_shapes_position_2(
                        self.row_beam.length,
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
                area: 0.00020106192982974675,
                second_moments: [3.216990877275948e-9, 3.216990877275948e-9],
                torsion_constant: 0.0,
                young_over_shear: 2.0 * (1.0 + 0.29),
                softness_of_curves: 0.0,
                yield_stress: None,
                material: "_soft",
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
            cable_spatial_exact_damped_field_forces(
                &self.row_beam,
                ::rncf::emitted::array(stress_free),
                ::rncf::emitted::array(fields),
                ::rncf::emitted::array(rates),
                ::rncf::emitted::array_mut(forces),
            );
        }
    }
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::JointConditions for Equations {
        fn joints(&self) -> ::std::vec::Vec<::rncf::emitted::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::JointSpec {
                    name: "root",
                    kind: ::rncf::emitted::JointKind::Pin,
                    body: 0,
                    at_end: false,
                    frame: 2,
                    point: None,
                },
                ::rncf::emitted::JointSpec {
                    name: "chord_y",
                    kind: ::rncf::emitted::JointKind::Hold {
                        of: ::rncf::emitted::Interpolant::Position,
                        order: 0,
                        axis: 1,
                    },
                    body: 0,
                    at_end: true,
                    frame: 2,
                    point: None,
                },
                ::rncf::emitted::JointSpec {
                    name: "chord_z",
                    kind: ::rncf::emitted::JointKind::Hold {
                        of: ::rncf::emitted::Interpolant::Position,
                        order: 0,
                        axis: 2,
                    },
                    body: 0,
                    at_end: true,
                    frame: 2,
                    point: None,
                },
            ])
        }
        fn condition(
            &self,
            joint: usize,
            absolute: bool,
            level: ::rncf::emitted::ConstraintLevel,
            t: f64,
            data: &::rncf::emitted::JointData,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            rows: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
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
                        _ => {}
                    }
                }
                (1, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_chord_y_referenced_position(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        _ => {}
                    }
                }
                (2, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_chord_z_referenced_position(
                                &self.model,
                                t,
                                data,
                                q,
                                v,
                                a,
                                rows,
                            )
                        }
                        _ => {}
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
            data: &::rncf::emitted::JointData,
            jacobian: &mut [f64],
        ) {
            match (joint, absolute) {
                (0, false) => {
                    joint_root_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (1, false) => {
                    joint_chord_y_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (2, false) => {
                    joint_chord_z_referenced_jacobian(&self.model, t, data, jacobian);
                }
                _ => {}
            }
        }
        fn prescribed(
            &self,
            joint: usize,
            absolute: bool,
            t: f64,
            data: &::rncf::emitted::JointData,
            prescribed: &mut ::rncf::emitted::Prescribed,
        ) {
            match (joint, absolute) {
                (0, false) => {
                    joint_root_referenced_prescribed(&self.model, t, data, prescribed);
                }
                (1, false) => {
                    joint_chord_y_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (2, false) => {
                    joint_chord_z_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutLoads for Equations {}
    impl ::rncf::emitted::WithoutSlopeMoments for Equations {}
    impl ::rncf::emitted::WithoutSectionMoments for Equations {}
    impl ::rncf::emitted::MarkerConstraints for Equations {
        fn constraints(&self) -> ::std::vec::Vec<::rncf::emitted::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::ConstraintSpec {
                    name: "root",
                    kind: "pin",
                    rows: &["position x", "position y", "position z"],
                    markers: &[0, 1],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Absolute(0),
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "chord_y",
                    kind: "hold",
                    rows: &["position y"],
                    markers: &[2, 3, 4],
                    coupled: &[[0, 2], [1, 2]],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Absolute(0),
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "chord_z",
                    kind: "hold",
                    rows: &["position z"],
                    markers: &[2, 3, 5],
                    coupled: &[[0, 2], [1, 2]],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Absolute(0),
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "cross_axis",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[5],
                    coupled: &[],
                    of_differences: true,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "guide_y",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[2],
                    coupled: &[],
                    of_differences: false,
                    first_party: 1,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "guide_z",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[2],
                    coupled: &[],
                    of_differences: false,
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
                            constraint_position_root(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_root(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_root(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_root(&self.model, t, z, rows)
                        }
                    }
                }
                1 | 2 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_chord_y(&self.model, t, z, rows)
                        }
                    }
                }
                3 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_cross_axis(&self.model, t, z, rows)
                        }
                    }
                }
                4 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_guide_y(&self.model, t, z, rows)
                        }
                    }
                }
                5 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_guide_z(&self.model, t, z, rows)
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
                0 => constraint_gradient_root(&self.model, t, z, gradient),
                1 | 2 => constraint_gradient_chord_y(&self.model, t, z, gradient),
                3 => constraint_gradient_cross_axis(&self.model, t, z, gradient),
                4 => constraint_gradient_guide_y(&self.model, t, z, gradient),
                5 => constraint_gradient_guide_z(&self.model, t, z, gradient),
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
                1 | 2 => {
                    constraint_rate_gradient_chord_y(
                        &self.model,
                        t,
                        z,
                        velocity,
                        gradient,
                    )
                }
                3 => {
                    constraint_rate_gradient_cross_axis(
                        &self.model,
                        t,
                        z,
                        velocity,
                        gradient,
                    )
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
                1 | 2 => constraint_hessian_chord_y(&self.model, t, z, lambda, hessian),
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
