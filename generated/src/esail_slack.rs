//! Expansion of `models/src/esail_slack.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use esail_slack_equations::EsailSlack;
#[allow(clippy::all)]
impl Default for EsailSlack {
    fn default() -> Self {
        Self {
            length: 10000.0,
            spin: 0.004363323129985824,
            voltage: 40000.0,
            tethers: 100,
            elements: 16,
            remote_mass: 0.45,
            core_mass: 90.0,
            hub_radius: 0.0,
            asymmetry: 1e-6,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for EsailSlack {
    const NAME: &'static str = "EsailSlack";
    const DOC: &'static str = "Electric solar wind sail at one astronomical unit whose tethers go slack instead of carrying compression: a wire of\n628 m and 76 um buckles under 3e-12 N.";
    const SOURCE: &'static str = r#"pub model EsailSlack {
    /// Length of a main tether.
    param length = 10 km;
    /// Rate of spin.
    param spin = 0.25 deg/s;
    /// Potential of the main tethers.
    param voltage = 40 kV;
    /// Number of main tethers.
    param tethers: count = 100;
    /// Number of elements of a main tether.
    param elements: count = 16;
    /// Mass of a remote unit.
    param remote_mass = 0.45 kg;
    /// Mass of the core.
    param core_mass = 90 kg;
    /// Distance of the tethers' roots from the core.
    param hub_radius = 0 m;
    /// Relative differences of the remote units' masses, without a pattern: what a real sail buckles from.
    param asymmetry = 1e-6;

    const distance = 1.5e11 m;
    const solar_gravity = 5.93e-3 m/s^2;
    const orbital_rate = sqrt(solar_gravity / distance);
    /// Potential of the solar wind's protons.
    const wind = 1 kV;
    const thrust_factor = 2.4e-5 N/(kV km);

    // EA = 320 N, 1.23429e-5 kg/m, EI = 1.164e-7 N m^2
    material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
    section wire { area = 4.571428571428571e-9 m^2; second_moment = 1.663e-18 m^4; }

    /// Spins about its z axis, which points away from the Sun.
    frame sail = free(
        origin = [distance, 0, 0], axis = y, angle = 90 deg,
        velocity = [0, orbital_rate * distance, 0], angular_velocity = [-orbital_rate, 0, spin]
    );
    fixture core on sail { mass = core_mass; }

    for a in 0..tethers {
        body main[a] in sail {
            spatial;
            line from [hub_radius * cos(2*pi*a/tethers), hub_radius * sin(2*pi*a/tethers), 0]
                to [(hub_radius + length) * cos(2*pi*a/tethers), (hub_radius + length) * sin(2*pi*a/tethers), 0];
            mesh elements * tether(wire, aluminium, slack = true);
        }
        joint hub[a] = clamp(main[a].start, sail);
        fixture remote[a] on main[a].end { mass = remote_mass * (1 + asymmetry * cos(a^2)); }
        /// Thrust of the solar wind, across the tether.
        load thrust[a] = density(main[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
            * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));

        // One element between two tips, of the length of the arc.
        body aux[a] in sail {
            spatial;
            line from [0, 0, 0] m to [2*pi*(hub_radius + length)/tethers, 0, 0];
            mesh 1 * tether(wire, aluminium, slack = true);
            initial position [
                (hub_radius + length) * cos(2*pi*a/tethers + x/(hub_radius + length)),
                (hub_radius + length) * sin(2*pi*a/tethers + x/(hub_radius + length)),
                0
            ];
        }
        joint near[a] = share(aux[a].start, main[a].end);
        joint far[a] = share(aux[a].end, main[(a + 1) % tethers].end);
        joint ring[a] = merge(aux[a].end, aux[(a + 1) % tethers].start);
    }
    start spun = spinning(sail, angular_velocity = [0, 0, spin]);

    load sun = gravity(-solar_gravity * distance^2 * sail.position / norm(sail.position)^3, on = sail);
    constraint sun_x = dot(sail.ex, sail.position) / distance;
    constraint sun_y = dot(sail.ey, sail.position) / distance;

    /// Distance of the core from the Sun beyond that at the start.
    output radial = norm(sail.position) - distance;
    /// How far the tips are out of the plane of the spin, away from the Sun: the least of all.
    output z_tip_min = min(a in 0..tethers, main[a].end.z);
    /// The same: the greatest of all.
    output z_tip_max = max(a in 0..tethers, main[a].end.z);
    /// Angular velocity about the axis of the spin.
    output spin: deg/s = sail.angular_velocity.z;
    /// Tension at the roots of the main tethers: the greatest of all.
    output tension_main = max(a in 0..tethers, main[a].start.axial_force);
    /// Tension of the ring in the middle of its pieces: the least of all.
    output tension_aux_min = min(a in 0..tethers, aux[a].at(pi*(hub_radius + length)/tethers).axial_force);
    /// The same: the greatest of all.
    output tension_aux_max = max(a in 0..tethers, aux[a].at(pi*(hub_radius + length)/tethers).axial_force);
    /// Torques that keep the axis of the spin pointing at the Sun, THEORY (26).
    output torque_x = sun_x.multiplier;
    output torque_y = sun_y.multiplier;

    caution point_hub = "with a hub smaller than an element the torques are made by the mesh: they halve with every refinement"
        on torque_x, torque_y if hub_radius < length / elements;
    caution long = "a hub smaller than an element carries the spin axis round the orbit, which a real sail does not: beyond a day give a hub_radius"
        if (if hub_radius < length / elements { t_end } else { 0 s }) > 1 day;

    run { t_end = 200 s; every = 1 s; }
}"#;
    const EQUATIONS_HASH: u64 = 0x5dc3f902b2c37a66;
    const NOTES: &'static [&'static str] = &[
        "Body `main` uses `cable_spatial_slack`. Form: points unrolled (the cheapest; operations of force and tangent: points unrolled: 632 and 2395; loop over points: 677 and 2601; a loop counts 1.3 times).",
        "Body `main` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `main`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `main` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Body `aux` uses `cable_spatial_slack`. Form: points unrolled (the cheapest; operations of force and tangent: points unrolled: 632 and 2395; loop over points: 677 and 2601; a loop counts 1.3 times).",
        "Body `aux` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `aux`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `aux` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Joint `hub`: its conditions are linear in the nodal vectors of `main` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Frame `sail` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Constraint `sun_x` (constraint), `sun_y` (constraint): 1 multiplier; gradient and second derivatives are derived.",
        "Fixture `remote` adds constants to the inertia of `main` and no unknowns.",
        "Not declared, so that no function is written for it: springs and forces on moving places, gravity and dead loads, dead moments, kinks of motions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as the load per length `thrust` has no potential.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_SLACK_MASS_MATRIX",
            size: [4, 4],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_SLACK_DENSITY_IOTA",
            size: [4, 6],
            doc: "Tensor iota of the unit element for loads per length: the integrals of s_a h_j' h_m' over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_elastic_force",
            additions: 230,
            multiplications: 396,
            divisions: 1,
            functions: 5,
            weighted: 730,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_elastic_tangent",
            additions: 994,
            multiplications: 1390,
            divisions: 6,
            functions: 5,
            weighted: 2508,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_strain_energy",
            additions: 125,
            multiplications: 200,
            divisions: 6,
            functions: 10,
            weighted: 549,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_mass",
            additions: 0,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_shapes_position_2",
            additions: 4,
            multiplications: 8,
            divisions: 2,
            functions: 0,
            weighted: 20,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_slack_field_forces",
            additions: 22,
            multiplications: 54,
            divisions: 0,
            functions: 1,
            weighted: 96,
        },
        ::rncf::model::KernelCount {
            name: "initial_aux",
            additions: 2,
            multiplications: 7,
            divisions: 3,
            functions: 2,
            weighted: 61,
        },
        ::rncf::model::KernelCount {
            name: "joint_hub_referenced_position",
            additions: 7,
            multiplications: 6,
            divisions: 0,
            functions: 0,
            weighted: 13,
        },
        ::rncf::model::KernelCount {
            name: "constraint_position_sun_x",
            additions: 2,
            multiplications: 3,
            divisions: 1,
            functions: 0,
            weighted: 9,
        },
        ::rncf::model::KernelCount {
            name: "constraint_velocity_sun_x",
            additions: 5,
            multiplications: 6,
            divisions: 1,
            functions: 0,
            weighted: 15,
        },
        ::rncf::model::KernelCount {
            name: "constraint_acceleration_sun_x",
            additions: 11,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 24,
        },
        ::rncf::model::KernelCount {
            name: "constraint_jerk_sun_x",
            additions: 20,
            multiplications: 12,
            divisions: 1,
            functions: 0,
            weighted: 36,
        },
        ::rncf::model::KernelCount {
            name: "constraint_gradient_sun_x",
            additions: 0,
            multiplications: 0,
            divisions: 6,
            functions: 0,
            weighted: 24,
        },
        ::rncf::model::KernelCount {
            name: "constraint_rate_gradient_sun_x",
            additions: 0,
            multiplications: 0,
            divisions: 6,
            functions: 0,
            weighted: 24,
        },
        ::rncf::model::KernelCount {
            name: "constraint_hessian_sun_x",
            additions: 0,
            multiplications: 1,
            divisions: 0,
            functions: 0,
            weighted: 1,
        },
        ::rncf::model::KernelCount {
            name: "outputs",
            additions: 5,
            multiplications: 6,
            divisions: 1,
            functions: 1,
            weighted: 35,
        },
        ::rncf::model::KernelCount {
            name: "density_values_thrust",
            additions: 13,
            multiplications: 14,
            divisions: 1,
            functions: 0,
            weighted: 31,
        },
        ::rncf::model::KernelCount {
            name: "density_gradient_thrust",
            additions: 7,
            multiplications: 11,
            divisions: 4,
            functions: 0,
            weighted: 34,
        },
        ::rncf::model::KernelCount {
            name: "density_force_thrust",
            additions: 123,
            multiplications: 165,
            divisions: 3,
            functions: 0,
            weighted: 300,
        },
        ::rncf::model::KernelCount {
            name: "density_tangent_thrust",
            additions: 744,
            multiplications: 840,
            divisions: 3,
            functions: 0,
            weighted: 1596,
        },
        ::rncf::model::KernelCount {
            name: "field_sun",
            additions: 2,
            multiplications: 8,
            divisions: 3,
            functions: 1,
            weighted: 42,
        },
        ::rncf::model::KernelCount {
            name: "field_gradient_sun",
            additions: 5,
            multiplications: 29,
            divisions: 13,
            functions: 1,
            weighted: 106,
        },
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "length",
                kind: ::rncf::ParamKind::Quantity,
                unit: "km",
                unit_si: 1000.0,
                dimension: [1, 0, 0, 0, 0, 0],
                default: 10000.0,
                doc: "Length of a main tether.",
            },
            ::rncf::Param {
                name: "spin",
                kind: ::rncf::ParamKind::Quantity,
                unit: "deg/s",
                unit_si: 0.017453292519943295,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 0.004363323129985824,
                doc: "Rate of spin.",
            },
            ::rncf::Param {
                name: "voltage",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kV",
                unit_si: 1000.0,
                dimension: [2, 1, -3, 0, -1, 0],
                default: 40000.0,
                doc: "Potential of the main tethers.",
            },
            ::rncf::Param {
                name: "tethers",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 100.0,
                doc: "Number of main tethers.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 16.0,
                doc: "Number of elements of a main tether.",
            },
            ::rncf::Param {
                name: "remote_mass",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kg",
                unit_si: 1.0,
                dimension: [0, 1, 0, 0, 0, 0],
                default: 0.45,
                doc: "Mass of a remote unit.",
            },
            ::rncf::Param {
                name: "core_mass",
                kind: ::rncf::ParamKind::Quantity,
                unit: "kg",
                unit_si: 1.0,
                dimension: [0, 1, 0, 0, 0, 0],
                default: 90.0,
                doc: "Mass of the core.",
            },
            ::rncf::Param {
                name: "hub_radius",
                kind: ::rncf::ParamKind::Quantity,
                unit: "m",
                unit_si: 1.0,
                dimension: [1, 0, 0, 0, 0, 0],
                default: 0.0,
                doc: "Distance of the tethers' roots from the core.",
            },
            ::rncf::Param {
                name: "asymmetry",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 1e-6,
                doc: "Relative differences of the remote units' masses, without a pattern: what a real sail buckles from.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "radial",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Distance of the core from the Sun beyond that at the start.",
            },
            ::rncf::Output {
                name: "z_tip_min",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "How far the tips are out of the plane of the spin, away from the Sun: the least of all.",
            },
            ::rncf::Output {
                name: "z_tip_max",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "The same: the greatest of all.",
            },
            ::rncf::Output {
                name: "spin",
                unit: "deg/s",
                time_exponent: -1.0,
                components: &[],
                doc: "Angular velocity about the axis of the spin.",
            },
            ::rncf::Output {
                name: "tension_main",
                unit: "N",
                time_exponent: -2.0,
                components: &[],
                doc: "Tension at the roots of the main tethers: the greatest of all.",
            },
            ::rncf::Output {
                name: "tension_aux_min",
                unit: "N",
                time_exponent: -2.0,
                components: &[],
                doc: "Tension of the ring in the middle of its pieces: the least of all.",
            },
            ::rncf::Output {
                name: "tension_aux_max",
                unit: "N",
                time_exponent: -2.0,
                components: &[],
                doc: "The same: the greatest of all.",
            },
            ::rncf::Output {
                name: "torque_x",
                unit: "N m",
                time_exponent: -2.0,
                components: &[],
                doc: "Torques that keep the axis of the spin pointing at the Sun, THEORY (26).",
            },
            ::rncf::Output {
                name: "torque_y",
                unit: "N m",
                time_exponent: -2.0,
                components: &[],
                doc: "",
            },
        ]
    }
    fn cautions(&self, end_time: f64) -> ::std::vec::Vec<::rncf::Caution> {
        let model = self;
        let mut cautions = ::std::vec::Vec::new();
        if (model.hub_radius) < (model.length / (model.elements as f64)) {
            cautions
                .push(::rncf::Caution {
                    name: "point_hub",
                    text: "with a hub smaller than an element the torques are made by the mesh: they halve with every refinement",
                    outputs: &[7, 8],
                });
        }
        if ((if model.hub_radius < model.length / (model.elements as f64) {
            end_time
        } else {
            0.0
        })) > (86400.0)
        {
            cautions
                .push(::rncf::Caution {
                    name: "long",
                    text: "a hub smaller than an element carries the spin axis round the orbit, which a real sail does not: beyond a day give a hub_radius",
                    outputs: &[],
                });
        }
        cautions
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.length,
            1 => self.spin,
            2 => self.voltage,
            3 => self.tethers as f64,
            4 => self.elements as f64,
            5 => self.remote_mass,
            6 => self.core_mass,
            7 => self.hub_radius,
            8 => self.asymmetry,
            _ => panic!("EsailSlack has 9 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.length = value,
            1 => self.spin = value,
            2 => self.voltage = value,
            3 => self.tethers = value as usize,
            4 => self.elements = value as usize,
            5 => self.remote_mass = value,
            6 => self.core_mass = value,
            7 => self.hub_radius = value,
            8 => self.asymmetry = value,
            _ => panic!("EsailSlack has 9 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        esail_slack_equations::run_defaults(self, &mut run);
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
        let equations = esail_slack_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`EsailSlack`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod esail_slack_equations {
    /// Electric solar wind sail at one astronomical unit whose tethers go slack instead of carrying compression: a wire of
    /// 628 m and 76 um buckles under 3e-12 N.
    ///
    /// # Chosen and left out
    ///
    /// * Body `main` uses `cable_spatial_slack`. Form: points unrolled (the cheapest; operations of force and tangent: points unrolled: 632 and 2395; loop over points: 677 and 2601; a loop counts 1.3 times).
    /// * Body `main` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `main`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `main` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Body `aux` uses `cable_spatial_slack`. Form: points unrolled (the cheapest; operations of force and tangent: points unrolled: 632 and 2395; loop over points: 677 and 2601; a loop counts 1.3 times).
    /// * Body `aux` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `aux`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `aux` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Joint `hub`: its conditions are linear in the nodal vectors of `main` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Frame `sail` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Constraint `sun_x` (constraint), `sun_y` (constraint): 1 multiplier; gradient and second derivatives are derived.
    /// * Fixture `remote` adds constants to the inertia of `main` and no unknowns.
    /// * Not declared, so that no function is written for it: springs and forces on moving places, gravity and dead loads, dead moments, kinks of motions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as the load per length `thrust` has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct EsailSlack {
        /// Length of a main tether. (SI; declared in km)
        pub length: f64,
        /// Rate of spin. (SI; declared in deg/s)
        pub spin: f64,
        /// Potential of the main tethers. (SI; declared in kV)
        pub voltage: f64,
        /// Number of main tethers. (count)
        pub tethers: usize,
        /// Number of elements of a main tether. (count)
        pub elements: usize,
        /// Mass of a remote unit. (SI; declared in kg)
        pub remote_mass: f64,
        /// Mass of the core. (SI; declared in kg)
        pub core_mass: f64,
        /// Distance of the tethers' roots from the core. (SI; declared in m)
        pub hub_radius: f64,
        /// Relative differences of the remote units' masses, without a pattern: what a real sail buckles from. (SI; declared in 1)
        pub asymmetry: f64,
    }
    /// Constants of one element `cable_spatial_slack`. Hermite centre-line element: axial strain and bending, no shear, no torsion.
    ///
    /// Nodal vectors: r0, s0, r1, s1, 3 components each.
    ///
    /// Form: points unrolled (the cheapest; operations of force and tangent: points unrolled: 632 and 2395; loop over points: 677 and 2601; a loop counts 1.3 times).
    ///
    /// The energy is integrated with 5 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct CableSpatialSlack<T = f64> {
        /// Length, m.
        pub length: T,
        /// young * area, N.
        pub EA: T,
        /// young * second_moment, N m^2.
        pub EI: T,
        /// density * area, kg/m.
        pub rhoA: T,
    }
    impl CableSpatialSlack {
        /// The constants of four elements side by side.
        #[inline(always)]
        pub fn side_by_side<L: ::rncf::emitted::lanes::Lanes>(
            rows: [&Self; 4],
            lanes: L,
        ) -> CableSpatialSlack<L::Real> {
            CableSpatialSlack {
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
    pub const CABLE_SPATIAL_SLACK_MASS_MATRIX: [[f64; 4]; 4] = [
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
    /// Tensor iota of the unit element for loads per length: the integrals of s_a h_j' h_m' over xi from 0 to 1.
    ///
    /// Rows: s0, r1, s1, and 1 in place of a shape function (zeta). Columns: s0 s0, s0 r1, s0 s1, r1 r1, r1 s1, s1 s1.
    pub const CABLE_SPATIAL_SLACK_DENSITY_IOTA: [[f64; 6]; 4] = [
        [
            0.008333333333333333,
            -0.007142857142857143,
            -0.0011904761904761906,
            0.12857142857142856,
            -0.02142857142857143,
            0.005952380952380952,
        ],
        [
            0.030952380952380953,
            -0.11428571428571428,
            -0.016666666666666666,
            0.6,
            0.014285714285714285,
            0.10238095238095238,
        ],
        [
            -0.005952380952380952,
            0.02142857142857143,
            0.0011904761904761906,
            -0.12857142857142856,
            0.007142857142857143,
            -0.008333333333333333,
        ],
        [0.13333333333333333, -0.1, -0.03333333333333333, 1.2, -0.1, 0.13333333333333333],
    ];
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, slack = true, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, unrolled.
    ///
    /// Operations: 230 additions, 396 multiplications, 1 divisions, 5 function calls.
    #[inline(always)]
    pub fn cable_spatial_slack_elastic_force<T: ::rncf::emitted::lanes::Real>(
        row: &CableSpatialSlack<T>,
        q: &[T; 12],
        force: &mut [T::Cell; 12],
    ) {
        let CableSpatialSlack { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t31 = length * 0.1184634425280945;
        let t32 = s0_x * 0.8189613578583975 + d_x * 0.26825713022186887
            + s1_x * (-0.08721848808026642);
        let t33 = s0_y * 0.8189613578583975 + d_y * 0.26825713022186887
            + s1_y * (-0.08721848808026642);
        let t34 = s0_z * 0.8189613578583975 + d_z * 0.26825713022186887
            + s1_z * (-0.08721848808026642);
        let t35 = inverse_length
            * (s0_x * (-3.718539537815992) + d_x * 5.437079075631984
                + s1_x * (-1.718539537815992));
        let t36 = inverse_length
            * (s0_y * (-3.718539537815992) + d_y * 5.437079075631984
                + s1_y * (-1.718539537815992));
        let t37 = inverse_length
            * (s0_z * (-3.718539537815992) + d_z * 5.437079075631984
                + s1_z * (-1.718539537815992));
        let t38 = t32 * t32 + t33 * t33 + t34 * t34;
        let t39 = EA * t31;
        let t40 = EI * t31;
        let t41 = (t38 - 1.0) * 0.5;
        let t42 = t39 * ((t41 + (t41 * t41 + 1e-12).sqrt()) * 0.5) * 0.5
            + t40 * ((t35 * t35 + t36 * t36 + t37 * t37) * 0.5);
        let t43 = t40 * ((t32 * t35 + t33 * t36 + t34 * t37) * 2.0 * 0.5);
        let t44 = t40 * (t38 * 0.5);
        let t45 = t42 * (t32 * 2.0) - t35 * t43;
        let t46 = t42 * (t33 * 2.0) - t36 * t43;
        let t47 = t42 * (t34 * 2.0) - t37 * t43;
        let t48 = inverse_length * (t44 * (t35 * 2.0) - t32 * t43);
        let t49 = inverse_length * (t44 * (t36 * 2.0) - t33 * t43);
        let t50 = inverse_length * (t44 * (t37 * 2.0) - t34 * t43);
        let t51 = length * 0.23931433524968324;
        let t52 = d_x * 1.0650762031114644;
        let t53 = d_y * 1.0650762031114644;
        let t54 = d_z * 1.0650762031114644;
        let t55 = s0_x * 0.23669655349710927 + t52 + s1_x * (-0.30177275660857383);
        let t56 = s0_y * 0.23669655349710927 + t53 + s1_y * (-0.30177275660857383);
        let t57 = s0_z * 0.23669655349710927 + t54 + s1_z * (-0.30177275660857383);
        let t58 = inverse_length
            * (s0_x * (-2.6154079303170494) + d_x * 3.230815860634099
                + s1_x * (-0.6154079303170494));
        let t59 = inverse_length
            * (s0_y * (-2.6154079303170494) + d_y * 3.230815860634099
                + s1_y * (-0.6154079303170494));
        let t60 = inverse_length
            * (s0_z * (-2.6154079303170494) + d_z * 3.230815860634099
                + s1_z * (-0.6154079303170494));
        let t61 = t55 * t55 + t56 * t56 + t57 * t57;
        let t62 = EA * t51;
        let t63 = EI * t51;
        let t64 = (t61 - 1.0) * 0.5;
        let t65 = t62 * ((t64 + (t64 * t64 + 1e-12).sqrt()) * 0.5) * 0.5
            + t63 * ((t58 * t58 + t59 * t59 + t60 * t60) * 0.5);
        let t66 = t63 * ((t55 * t58 + t56 * t59 + t57 * t60) * 2.0 * 0.5);
        let t67 = t63 * (t61 * 0.5);
        let t68 = t65 * (t55 * 2.0) - t58 * t66;
        let t69 = t65 * (t56 * 2.0) - t59 * t66;
        let t70 = t65 * (t57 * 2.0) - t60 * t66;
        let t71 = inverse_length * (t67 * (t58 * 2.0) - t55 * t66);
        let t72 = inverse_length * (t67 * (t59 * 2.0) - t56 * t66);
        let t73 = inverse_length * (t67 * (t60 * 2.0) - t57 * t66);
        let t74 = length * 0.28444444444444444;
        let t75 = s0_x * (-0.25) + d_x * 1.5 + s1_x * (-0.25);
        let t76 = s0_y * (-0.25) + d_y * 1.5 + s1_y * (-0.25);
        let t77 = s0_z * (-0.25) + d_z * 1.5 + s1_z * (-0.25);
        let t78 = inverse_length * (s1_x - s0_x);
        let t79 = inverse_length * (s1_y - s0_y);
        let t80 = inverse_length * (s1_z - s0_z);
        let t81 = t75 * t75 + t76 * t76 + t77 * t77;
        let t82 = EI * t74;
        let t83 = (t81 - 1.0) * 0.5;
        let t84 = EA * t74 * ((t83 + (t83 * t83 + 1e-12).sqrt()) * 0.5) * 0.5
            + t82 * ((t78 * t78 + t79 * t79 + t80 * t80) * 0.5);
        let t85 = t82 * ((t75 * t78 + t76 * t79 + t77 * t80) * 2.0 * 0.5);
        let t86 = t82 * (t81 * 0.5);
        let t87 = t84 * (t75 * 2.0) - t78 * t85;
        let t88 = t84 * (t76 * 2.0) - t79 * t85;
        let t89 = t84 * (t77 * 2.0) - t80 * t85;
        let t90 = inverse_length * (t86 * (t78 * 2.0) - t75 * t85);
        let t91 = inverse_length * (t86 * (t79 * 2.0) - t76 * t85);
        let t92 = inverse_length * (t86 * (t80 * 2.0) - t77 * t85);
        let t93 = t87 * (-0.25);
        let t94 = t88 * (-0.25);
        let t95 = t89 * (-0.25);
        let t96 = t45 * 0.8189613578583975 + t48 * (-3.718539537815992)
            + (t68 * 0.23669655349710927 + t71 * (-2.6154079303170494)) + (t93 - t90);
        let t97 = t46 * 0.8189613578583975 + t49 * (-3.718539537815992)
            + (t69 * 0.23669655349710927 + t72 * (-2.6154079303170494)) + (t94 - t91);
        let t98 = t47 * 0.8189613578583975 + t50 * (-3.718539537815992)
            + (t70 * 0.23669655349710927 + t73 * (-2.6154079303170494)) + (t95 - t92);
        let t99 = t45 * 0.26825713022186887 + t48 * 5.437079075631984
            + (t68 * 1.0650762031114644 + t71 * 3.230815860634099) + t87 * 1.5;
        let t100 = t46 * 0.26825713022186887 + t49 * 5.437079075631984
            + (t69 * 1.0650762031114644 + t72 * 3.230815860634099) + t88 * 1.5;
        let t101 = t47 * 0.26825713022186887 + t50 * 5.437079075631984
            + (t70 * 1.0650762031114644 + t73 * 3.230815860634099) + t89 * 1.5;
        let t102 = t45 * (-0.08721848808026642) + t48 * (-1.718539537815992)
            + (t68 * (-0.30177275660857383) + t71 * (-0.6154079303170494)) + (t90 + t93);
        let t103 = t46 * (-0.08721848808026642) + t49 * (-1.718539537815992)
            + (t69 * (-0.30177275660857383) + t72 * (-0.6154079303170494)) + (t91 + t94);
        let t104 = t47 * (-0.08721848808026642) + t50 * (-1.718539537815992)
            + (t70 * (-0.30177275660857383) + t73 * (-0.6154079303170494)) + (t92 + t95);
        let t105 = t52 + s0_x * (-0.3017727566085737) + s1_x * 0.23669655349710933;
        let t106 = t53 + s0_y * (-0.3017727566085737) + s1_y * 0.23669655349710933;
        let t107 = t54 + s0_z * (-0.3017727566085737) + s1_z * 0.23669655349710933;
        let t108 = inverse_length
            * (s0_x * 0.6154079303170494 + d_x * (-3.230815860634099)
                + s1_x * 2.6154079303170494);
        let t109 = inverse_length
            * (s0_y * 0.6154079303170494 + d_y * (-3.230815860634099)
                + s1_y * 2.6154079303170494);
        let t110 = inverse_length
            * (s0_z * 0.6154079303170494 + d_z * (-3.230815860634099)
                + s1_z * 2.6154079303170494);
        let t111 = t105 * t105 + t106 * t106 + t107 * t107;
        let t112 = (t111 - 1.0) * 0.5;
        let t113 = t62 * ((t112 + (t112 * t112 + 1e-12).sqrt()) * 0.5) * 0.5
            + t63 * ((t108 * t108 + t109 * t109 + t110 * t110) * 0.5);
        let t114 = t63 * ((t105 * t108 + t106 * t109 + t107 * t110) * 2.0 * 0.5);
        let t115 = t63 * (t111 * 0.5);
        let t116 = t113 * (t105 * 2.0) - t108 * t114;
        let t117 = t113 * (t106 * 2.0) - t109 * t114;
        let t118 = t113 * (t107 * 2.0) - t110 * t114;
        let t119 = inverse_length * (t115 * (t108 * 2.0) - t105 * t114);
        let t120 = inverse_length * (t115 * (t109 * 2.0) - t106 * t114);
        let t121 = inverse_length * (t115 * (t110 * 2.0) - t107 * t114);
        let t122 = s0_x * (-0.08721848808026644) + d_x * 0.26825713022186914
            + s1_x * 0.8189613578583973;
        let t123 = s0_y * (-0.08721848808026644) + d_y * 0.26825713022186914
            + s1_y * 0.8189613578583973;
        let t124 = s0_z * (-0.08721848808026644) + d_z * 0.26825713022186914
            + s1_z * 0.8189613578583973;
        let t125 = inverse_length
            * (s0_x * 1.7185395378159916 + d_x * (-5.437079075631983)
                + s1_x * 3.7185395378159916);
        let t126 = inverse_length
            * (s0_y * 1.7185395378159916 + d_y * (-5.437079075631983)
                + s1_y * 3.7185395378159916);
        let t127 = inverse_length
            * (s0_z * 1.7185395378159916 + d_z * (-5.437079075631983)
                + s1_z * 3.7185395378159916);
        let t128 = t122 * t122 + t123 * t123 + t124 * t124;
        let t129 = (t128 - 1.0) * 0.5;
        let t130 = t39 * ((t129 + (t129 * t129 + 1e-12).sqrt()) * 0.5) * 0.5
            + t40 * ((t125 * t125 + t126 * t126 + t127 * t127) * 0.5);
        let t131 = t40 * ((t122 * t125 + t123 * t126 + t124 * t127) * 2.0 * 0.5);
        let t132 = t40 * (t128 * 0.5);
        let t133 = t130 * (t122 * 2.0) - t125 * t131;
        let t134 = t130 * (t123 * 2.0) - t126 * t131;
        let t135 = t130 * (t124 * 2.0) - t127 * t131;
        let t136 = inverse_length * (t132 * (t125 * 2.0) - t122 * t131);
        let t137 = inverse_length * (t132 * (t126 * 2.0) - t123 * t131);
        let t138 = inverse_length * (t132 * (t127 * 2.0) - t124 * t131);
        let t139 = inverse_length
            * (t99 + (t116 * 1.0650762031114644 + t119 * (-3.230815860634099))
                + (t133 * 0.26825713022186914 + t136 * (-5.437079075631983)));
        let t140 = inverse_length
            * (t100 + (t117 * 1.0650762031114644 + t120 * (-3.230815860634099))
                + (t134 * 0.26825713022186914 + t137 * (-5.437079075631983)));
        let t141 = inverse_length
            * (t101 + (t118 * 1.0650762031114644 + t121 * (-3.230815860634099))
                + (t135 * 0.26825713022186914 + t138 * (-5.437079075631983)));
        force[0] -= t139;
        force[1] -= t140;
        force[2] -= t141;
        force[3]
            += t96 + (t116 * (-0.3017727566085737) + t119 * 0.6154079303170494)
                + (t133 * (-0.08721848808026644) + t136 * 1.7185395378159916);
        force[4]
            += t97 + (t117 * (-0.3017727566085737) + t120 * 0.6154079303170494)
                + (t134 * (-0.08721848808026644) + t137 * 1.7185395378159916);
        force[5]
            += t98 + (t118 * (-0.3017727566085737) + t121 * 0.6154079303170494)
                + (t135 * (-0.08721848808026644) + t138 * 1.7185395378159916);
        force[6] += t139;
        force[7] += t140;
        force[8] += t141;
        force[9]
            += t102 + (t116 * 0.23669655349710933 + t119 * 2.6154079303170494)
                + (t133 * 0.8189613578583973 + t136 * 3.7185395378159916);
        force[10]
            += t103 + (t117 * 0.23669655349710933 + t120 * 2.6154079303170494)
                + (t134 * 0.8189613578583973 + t137 * 3.7185395378159916);
        force[11]
            += t104 + (t118 * 0.23669655349710933 + t121 * 2.6154079303170494)
                + (t135 * 0.8189613578583973 + t138 * 3.7185395378159916);
    }
    /// [`cable_spatial_slack_elastic_force`] of four elements side by side.
    pub struct CableSpatialSlackElasticForce<'a> {
        pub rows: [&'a CableSpatialSlack; 4],
        pub q: &'a [[f64; 4]; 12],
        pub force: &'a mut [[f64; 4]; 12],
    }
    impl ::rncf::emitted::lanes::Kernel for CableSpatialSlackElasticForce<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, force } = self;
            let row = CableSpatialSlack::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_slack_elastic_force(&row, &q, force);
        }
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, slack = true, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, unrolled.
    ///
    /// Operations: 994 additions, 1390 multiplications, 6 divisions, 5 function calls.
    #[inline(always)]
    pub fn cable_spatial_slack_elastic_tangent<T: ::rncf::emitted::lanes::Real>(
        row: &CableSpatialSlack<T>,
        q: &[T; 12],
        stiffness: &mut [T::Cell; 144],
    ) {
        let CableSpatialSlack { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = length.recip();
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t31 = length * 0.1184634425280945;
        let t32 = s0_x * 0.8189613578583975 + d_x * 0.26825713022186887
            + s1_x * (-0.08721848808026642);
        let t33 = s0_y * 0.8189613578583975 + d_y * 0.26825713022186887
            + s1_y * (-0.08721848808026642);
        let t34 = s0_z * 0.8189613578583975 + d_z * 0.26825713022186887
            + s1_z * (-0.08721848808026642);
        let t35 = inverse_length
            * (s0_x * (-3.718539537815992) + d_x * 5.437079075631984
                + s1_x * (-1.718539537815992));
        let t36 = inverse_length
            * (s0_y * (-3.718539537815992) + d_y * 5.437079075631984
                + s1_y * (-1.718539537815992));
        let t37 = inverse_length
            * (s0_z * (-3.718539537815992) + d_z * 5.437079075631984
                + s1_z * (-1.718539537815992));
        let t38 = t32 * t32 + t33 * t33 + t34 * t34;
        let t39 = EA * t31;
        let t40 = EI * t31;
        let t41 = (t38 - 1.0) * 0.5;
        let t42 = (t41 * t41 + 1e-12).sqrt();
        let t43 = t39 * (((t42 * 2.0).recip() * (t41 * 2.0 * 0.5) + 0.5) * 0.5) * 0.5;
        let t44 = t40 * 0.5;
        let t45 = t39 * ((t41 + t42) * 0.5) * 0.5
            + t40 * ((t35 * t35 + t36 * t36 + t37 * t37) * 0.5);
        let t46 = t40 * ((t32 * t35 + t33 * t36 + t34 * t37) * 2.0 * 0.5);
        let t47 = t32 * 2.0;
        let t48 = t33 * 2.0;
        let t49 = t34 * 2.0;
        let t50 = t43 * t48;
        let t51 = t43 * t49;
        let t52 = t44 * (t35 * 2.0);
        let t53 = t44 * (t36 * 2.0);
        let t54 = t44 * (t37 * 2.0);
        let t55 = t36 * t40;
        let t56 = t37 * t40;
        let t57 = t32 * t40;
        let t58 = t33 * t40;
        let t59 = t34 * t40;
        let t60 = t47 * t50 - t35 * t55;
        let t61 = t47 * t51 - t35 * t56;
        let t62 = t48 * t51 - t36 * t56;
        let t63 = t45 * 2.0;
        let t64 = t47 * (t43 * t47) - t35 * (t35 * t40) + t63;
        let t65 = t48 * t50 - t36 * t55 + t63;
        let t66 = t49 * t51 - t37 * t56 + t63;
        let t67 = t40 * (t38 * 0.5) * 2.0;
        let t68 = t60 * 0.26825713022186887;
        let t69 = t60 * (-0.08721848808026642);
        let t70 = t61 * 0.26825713022186887;
        let t71 = t61 * (-0.08721848808026642);
        let t72 = t62 * 0.26825713022186887;
        let t73 = t62 * (-0.08721848808026642);
        let t74 = inverse_length * (t47 * t52 - t35 * t57 - t46);
        let t75 = t64 * 0.26825713022186887 + t74 * 5.437079075631984;
        let t76 = t64 * (-0.08721848808026642) + t74 * (-1.718539537815992);
        let t77 = inverse_length * (t47 * t53 - t35 * t58);
        let t78 = t68 + t77 * 5.437079075631984;
        let t79 = t69 + t77 * (-1.718539537815992);
        let t80 = inverse_length * (t47 * t54 - t35 * t59);
        let t81 = t70 + t80 * 5.437079075631984;
        let t82 = t71 + t80 * (-1.718539537815992);
        let t83 = inverse_length * (t48 * t52 - t36 * t57);
        let t84 = t69 + t83 * (-1.718539537815992);
        let t85 = inverse_length * (t48 * t53 - t36 * t58 - t46);
        let t86 = t65 * 0.26825713022186887 + t85 * 5.437079075631984;
        let t87 = t65 * (-0.08721848808026642) + t85 * (-1.718539537815992);
        let t88 = inverse_length * (t48 * t54 - t36 * t59);
        let t89 = t72 + t88 * 5.437079075631984;
        let t90 = t73 + t88 * (-1.718539537815992);
        let t91 = inverse_length * (t49 * t52 - t37 * t57);
        let t92 = t71 + t91 * (-1.718539537815992);
        let t93 = inverse_length * (t49 * t53 - t37 * t58);
        let t94 = t73 + t93 * (-1.718539537815992);
        let t95 = inverse_length * (t49 * t54 - t37 * t59 - t46);
        let t96 = t66 * 0.26825713022186887 + t95 * 5.437079075631984;
        let t97 = t66 * (-0.08721848808026642) + t95 * (-1.718539537815992);
        let t98 = inverse_length * inverse_length;
        let t99 = (t67 - t32 * t57) * t98;
        let t100 = t74 * 0.26825713022186887 + t99 * 5.437079075631984;
        let t101 = t74 * (-0.08721848808026642) + t99 * (-1.718539537815992);
        let t102 = t32 * t58 * t98;
        let t103 = t102 * 5.437079075631984;
        let t104 = t83 * 0.26825713022186887 - t103;
        let t105 = t102 * (-1.718539537815992);
        let t106 = t83 * (-0.08721848808026642) - t105;
        let t107 = t32 * t59 * t98;
        let t108 = t107 * 5.437079075631984;
        let t109 = t91 * 0.26825713022186887 - t108;
        let t110 = t107 * (-1.718539537815992);
        let t111 = t91 * (-0.08721848808026642) - t110;
        let t112 = t77 * (-0.08721848808026642) - t105;
        let t113 = (t67 - t33 * t58) * t98;
        let t114 = t85 * 0.26825713022186887 + t113 * 5.437079075631984;
        let t115 = t85 * (-0.08721848808026642) + t113 * (-1.718539537815992);
        let t116 = t33 * t59 * t98;
        let t117 = t116 * 5.437079075631984;
        let t118 = t93 * 0.26825713022186887 - t117;
        let t119 = t116 * (-1.718539537815992);
        let t120 = t93 * (-0.08721848808026642) - t119;
        let t121 = t80 * (-0.08721848808026642) - t110;
        let t122 = t88 * (-0.08721848808026642) - t119;
        let t123 = (t67 - t34 * t59) * t98;
        let t124 = t95 * 0.26825713022186887 + t123 * 5.437079075631984;
        let t125 = t95 * (-0.08721848808026642) + t123 * (-1.718539537815992);
        let t126 = (t64 * 0.8189613578583975 + t74 * (-3.718539537815992))
            * 0.8189613578583975
            + (t74 * 0.8189613578583975 + t99 * (-3.718539537815992))
                * (-3.718539537815992);
        let t127 = (t60 * 0.8189613578583975 + t77 * (-3.718539537815992))
            * 0.8189613578583975
            + (t83 * 0.8189613578583975 - t102 * (-3.718539537815992))
                * (-3.718539537815992);
        let t128 = (t61 * 0.8189613578583975 + t80 * (-3.718539537815992))
            * 0.8189613578583975
            + (t91 * 0.8189613578583975 - t107 * (-3.718539537815992))
                * (-3.718539537815992);
        let t129 = (t65 * 0.8189613578583975 + t85 * (-3.718539537815992))
            * 0.8189613578583975
            + (t85 * 0.8189613578583975 + t113 * (-3.718539537815992))
                * (-3.718539537815992);
        let t130 = (t62 * 0.8189613578583975 + t88 * (-3.718539537815992))
            * 0.8189613578583975
            + (t93 * 0.8189613578583975 - t116 * (-3.718539537815992))
                * (-3.718539537815992);
        let t131 = (t66 * 0.8189613578583975 + t95 * (-3.718539537815992))
            * 0.8189613578583975
            + (t95 * 0.8189613578583975 + t123 * (-3.718539537815992))
                * (-3.718539537815992);
        let t132 = length * 0.23931433524968324;
        let t133 = d_x * 1.0650762031114644;
        let t134 = d_y * 1.0650762031114644;
        let t135 = d_z * 1.0650762031114644;
        let t136 = s0_x * 0.23669655349710927 + t133 + s1_x * (-0.30177275660857383);
        let t137 = s0_y * 0.23669655349710927 + t134 + s1_y * (-0.30177275660857383);
        let t138 = s0_z * 0.23669655349710927 + t135 + s1_z * (-0.30177275660857383);
        let t139 = inverse_length
            * (s0_x * (-2.6154079303170494) + d_x * 3.230815860634099
                + s1_x * (-0.6154079303170494));
        let t140 = inverse_length
            * (s0_y * (-2.6154079303170494) + d_y * 3.230815860634099
                + s1_y * (-0.6154079303170494));
        let t141 = inverse_length
            * (s0_z * (-2.6154079303170494) + d_z * 3.230815860634099
                + s1_z * (-0.6154079303170494));
        let t142 = t136 * t136 + t137 * t137 + t138 * t138;
        let t143 = EA * t132;
        let t144 = EI * t132;
        let t145 = (t142 - 1.0) * 0.5;
        let t146 = (t145 * t145 + 1e-12).sqrt();
        let t147 = t143 * (((t146 * 2.0).recip() * (t145 * 2.0 * 0.5) + 0.5) * 0.5)
            * 0.5;
        let t148 = t144 * 0.5;
        let t149 = t143 * ((t145 + t146) * 0.5) * 0.5
            + t144 * ((t139 * t139 + t140 * t140 + t141 * t141) * 0.5);
        let t150 = t144 * ((t136 * t139 + t137 * t140 + t138 * t141) * 2.0 * 0.5);
        let t151 = t136 * 2.0;
        let t152 = t137 * 2.0;
        let t153 = t138 * 2.0;
        let t154 = t147 * t152;
        let t155 = t147 * t153;
        let t156 = t148 * (t139 * 2.0);
        let t157 = t148 * (t140 * 2.0);
        let t158 = t148 * (t141 * 2.0);
        let t159 = t140 * t144;
        let t160 = t141 * t144;
        let t161 = t136 * t144;
        let t162 = t137 * t144;
        let t163 = t138 * t144;
        let t164 = t151 * t154 - t139 * t159;
        let t165 = t151 * t155 - t139 * t160;
        let t166 = t152 * t155 - t140 * t160;
        let t167 = t149 * 2.0;
        let t168 = t151 * (t147 * t151) - t139 * (t139 * t144) + t167;
        let t169 = t152 * t154 - t140 * t159 + t167;
        let t170 = t153 * t155 - t141 * t160 + t167;
        let t171 = t144 * (t142 * 0.5) * 2.0;
        let t172 = t164 * 1.0650762031114644;
        let t173 = t164 * (-0.30177275660857383);
        let t174 = t165 * 1.0650762031114644;
        let t175 = t165 * (-0.30177275660857383);
        let t176 = t166 * 1.0650762031114644;
        let t177 = t166 * (-0.30177275660857383);
        let t178 = inverse_length * (t151 * t156 - t139 * t161 - t150);
        let t179 = t168 * 1.0650762031114644 + t178 * 3.230815860634099;
        let t180 = t168 * (-0.30177275660857383) + t178 * (-0.6154079303170494);
        let t181 = inverse_length * (t151 * t157 - t139 * t162);
        let t182 = t172 + t181 * 3.230815860634099;
        let t183 = t173 + t181 * (-0.6154079303170494);
        let t184 = inverse_length * (t151 * t158 - t139 * t163);
        let t185 = t174 + t184 * 3.230815860634099;
        let t186 = t175 + t184 * (-0.6154079303170494);
        let t187 = inverse_length * (t152 * t156 - t140 * t161);
        let t188 = t173 + t187 * (-0.6154079303170494);
        let t189 = inverse_length * (t152 * t157 - t140 * t162 - t150);
        let t190 = t169 * 1.0650762031114644 + t189 * 3.230815860634099;
        let t191 = t169 * (-0.30177275660857383) + t189 * (-0.6154079303170494);
        let t192 = inverse_length * (t152 * t158 - t140 * t163);
        let t193 = t176 + t192 * 3.230815860634099;
        let t194 = t177 + t192 * (-0.6154079303170494);
        let t195 = inverse_length * (t153 * t156 - t141 * t161);
        let t196 = t175 + t195 * (-0.6154079303170494);
        let t197 = inverse_length * (t153 * t157 - t141 * t162);
        let t198 = t177 + t197 * (-0.6154079303170494);
        let t199 = inverse_length * (t153 * t158 - t141 * t163 - t150);
        let t200 = t170 * 1.0650762031114644 + t199 * 3.230815860634099;
        let t201 = t170 * (-0.30177275660857383) + t199 * (-0.6154079303170494);
        let t202 = t98 * (t171 - t136 * t161);
        let t203 = t178 * 1.0650762031114644 + t202 * 3.230815860634099;
        let t204 = t178 * (-0.30177275660857383) + t202 * (-0.6154079303170494);
        let t205 = t98 * (t136 * t162);
        let t206 = t205 * 3.230815860634099;
        let t207 = t187 * 1.0650762031114644 - t206;
        let t208 = t205 * (-0.6154079303170494);
        let t209 = t187 * (-0.30177275660857383) - t208;
        let t210 = t98 * (t136 * t163);
        let t211 = t210 * 3.230815860634099;
        let t212 = t195 * 1.0650762031114644 - t211;
        let t213 = t210 * (-0.6154079303170494);
        let t214 = t195 * (-0.30177275660857383) - t213;
        let t215 = t181 * (-0.30177275660857383) - t208;
        let t216 = t98 * (t171 - t137 * t162);
        let t217 = t189 * 1.0650762031114644 + t216 * 3.230815860634099;
        let t218 = t189 * (-0.30177275660857383) + t216 * (-0.6154079303170494);
        let t219 = t98 * (t137 * t163);
        let t220 = t219 * 3.230815860634099;
        let t221 = t197 * 1.0650762031114644 - t220;
        let t222 = t219 * (-0.6154079303170494);
        let t223 = t197 * (-0.30177275660857383) - t222;
        let t224 = t184 * (-0.30177275660857383) - t213;
        let t225 = t192 * (-0.30177275660857383) - t222;
        let t226 = t98 * (t171 - t138 * t163);
        let t227 = t199 * 1.0650762031114644 + t226 * 3.230815860634099;
        let t228 = t199 * (-0.30177275660857383) + t226 * (-0.6154079303170494);
        let t229 = (t168 * 0.23669655349710927 + t178 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t178 * 0.23669655349710927 + t202 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t230 = (t164 * 0.23669655349710927 + t181 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t187 * 0.23669655349710927 - t205 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t231 = (t165 * 0.23669655349710927 + t184 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t195 * 0.23669655349710927 - t210 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t232 = (t169 * 0.23669655349710927 + t189 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t189 * 0.23669655349710927 + t216 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t233 = (t166 * 0.23669655349710927 + t192 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t197 * 0.23669655349710927 - t219 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t234 = (t170 * 0.23669655349710927 + t199 * (-2.6154079303170494))
            * 0.23669655349710927
            + (t199 * 0.23669655349710927 + t226 * (-2.6154079303170494))
                * (-2.6154079303170494);
        let t235 = (t68 + t83 * 5.437079075631984) * 0.8189613578583975
            + (t77 * 0.26825713022186887 - t103) * (-3.718539537815992)
            + ((t172 + t187 * 3.230815860634099) * 0.23669655349710927
                + (t181 * 1.0650762031114644 - t206) * (-2.6154079303170494));
        let t236 = (t70 + t91 * 5.437079075631984) * 0.8189613578583975
            + (t80 * 0.26825713022186887 - t108) * (-3.718539537815992)
            + ((t174 + t195 * 3.230815860634099) * 0.23669655349710927
                + (t184 * 1.0650762031114644 - t211) * (-2.6154079303170494));
        let t237 = (t72 + t93 * 5.437079075631984) * 0.8189613578583975
            + (t88 * 0.26825713022186887 - t117) * (-3.718539537815992)
            + ((t176 + t197 * 3.230815860634099) * 0.23669655349710927
                + (t192 * 1.0650762031114644 - t220) * (-2.6154079303170494));
        let t238 = length * 0.28444444444444444;
        let t239 = s0_x * (-0.25) + d_x * 1.5 + s1_x * (-0.25);
        let t240 = s0_y * (-0.25) + d_y * 1.5 + s1_y * (-0.25);
        let t241 = s0_z * (-0.25) + d_z * 1.5 + s1_z * (-0.25);
        let t242 = inverse_length * (s1_x - s0_x);
        let t243 = inverse_length * (s1_y - s0_y);
        let t244 = inverse_length * (s1_z - s0_z);
        let t245 = t239 * t239 + t240 * t240 + t241 * t241;
        let t246 = EA * t238;
        let t247 = EI * t238;
        let t248 = (t245 - 1.0) * 0.5;
        let t249 = (t248 * t248 + 1e-12).sqrt();
        let t250 = t246 * (((t249 * 2.0).recip() * (t248 * 2.0 * 0.5) + 0.5) * 0.5)
            * 0.5;
        let t251 = t247 * 0.5;
        let t252 = t246 * ((t248 + t249) * 0.5) * 0.5
            + t247 * ((t242 * t242 + t243 * t243 + t244 * t244) * 0.5);
        let t253 = t247 * ((t239 * t242 + t240 * t243 + t241 * t244) * 2.0 * 0.5);
        let t254 = t239 * 2.0;
        let t255 = t240 * 2.0;
        let t256 = t241 * 2.0;
        let t257 = t250 * t255;
        let t258 = t250 * t256;
        let t259 = t251 * (t242 * 2.0);
        let t260 = t251 * (t243 * 2.0);
        let t261 = t251 * (t244 * 2.0);
        let t262 = t243 * t247;
        let t263 = t244 * t247;
        let t264 = t239 * t247;
        let t265 = t240 * t247;
        let t266 = t241 * t247;
        let t267 = t254 * t257 - t242 * t262;
        let t268 = t254 * t258 - t242 * t263;
        let t269 = t255 * t258 - t243 * t263;
        let t270 = t252 * 2.0;
        let t271 = t254 * (t250 * t254) - t242 * (t242 * t247) + t270;
        let t272 = t255 * t257 - t243 * t262 + t270;
        let t273 = t256 * t258 - t244 * t263 + t270;
        let t274 = t247 * (t245 * 0.5) * 2.0;
        let t275 = t271 * (-0.25);
        let t276 = t271 * 1.5;
        let t277 = t267 * (-0.25);
        let t278 = t267 * 1.5;
        let t279 = t268 * (-0.25);
        let t280 = t268 * 1.5;
        let t281 = t272 * (-0.25);
        let t282 = t272 * 1.5;
        let t283 = t269 * (-0.25);
        let t284 = t269 * 1.5;
        let t285 = t273 * (-0.25);
        let t286 = t273 * 1.5;
        let t287 = inverse_length * (t254 * t259 - t242 * t264 - t253);
        let t288 = t275 + t287;
        let t289 = inverse_length * (t254 * t260 - t242 * t265);
        let t290 = t277 + t289;
        let t291 = inverse_length * (t254 * t261 - t242 * t266);
        let t292 = t279 + t291;
        let t293 = inverse_length * (t255 * t259 - t243 * t264);
        let t294 = t277 + t293;
        let t295 = inverse_length * (t255 * t260 - t243 * t265 - t253);
        let t296 = t281 + t295;
        let t297 = inverse_length * (t255 * t261 - t243 * t266);
        let t298 = t283 + t297;
        let t299 = inverse_length * (t256 * t259 - t244 * t264);
        let t300 = t279 + t299;
        let t301 = inverse_length * (t256 * t260 - t244 * t265);
        let t302 = t283 + t301;
        let t303 = inverse_length * (t256 * t261 - t244 * t266 - t253);
        let t304 = t285 + t303;
        let t305 = t278 * (-0.25);
        let t306 = t280 * (-0.25);
        let t307 = t284 * (-0.25);
        let t308 = t288 * (-0.25);
        let t309 = t290 * (-0.25);
        let t310 = t292 * (-0.25);
        let t311 = t296 * (-0.25);
        let t312 = t298 * (-0.25);
        let t313 = t304 * (-0.25);
        let t314 = t287 * (-0.25);
        let t315 = t293 * (-0.25);
        let t316 = t299 * (-0.25);
        let t317 = t295 * (-0.25);
        let t318 = t301 * (-0.25);
        let t319 = t303 * (-0.25);
        let t320 = t98 * (t274 - t239 * t264);
        let t321 = t314 + t320;
        let t322 = t98 * (t239 * t265);
        let t323 = t98 * (t239 * t266);
        let t324 = t98 * (t274 - t240 * t265);
        let t325 = t317 + t324;
        let t326 = t98 * (t240 * t266);
        let t327 = t98 * (t274 - t241 * t266);
        let t328 = t319 + t327;
        let t329 = t75 * 0.8189613578583975 + t100 * (-3.718539537815992)
            + (t179 * 0.23669655349710927 + t203 * (-2.6154079303170494))
            + (t276 * (-0.25) - t287 * 1.5);
        let t330 = t78 * 0.8189613578583975 + t104 * (-3.718539537815992)
            + (t182 * 0.23669655349710927 + t207 * (-2.6154079303170494))
            + (t305 - t293 * 1.5);
        let t331 = t81 * 0.8189613578583975 + t109 * (-3.718539537815992)
            + (t185 * 0.23669655349710927 + t212 * (-2.6154079303170494))
            + (t306 - t299 * 1.5);
        let t332 = t86 * 0.8189613578583975 + t114 * (-3.718539537815992)
            + (t190 * 0.23669655349710927 + t217 * (-2.6154079303170494))
            + (t282 * (-0.25) - t295 * 1.5);
        let t333 = t89 * 0.8189613578583975 + t118 * (-3.718539537815992)
            + (t193 * 0.23669655349710927 + t221 * (-2.6154079303170494))
            + (t307 - t301 * 1.5);
        let t334 = t96 * 0.8189613578583975 + t124 * (-3.718539537815992)
            + (t200 * 0.23669655349710927 + t227 * (-2.6154079303170494))
            + (t286 * (-0.25) - t303 * 1.5);
        let t335 = t76 * 0.8189613578583975 + t101 * (-3.718539537815992)
            + (t180 * 0.23669655349710927 + t204 * (-2.6154079303170494))
            + (t308 - t321);
        let t336 = t79 * 0.8189613578583975 + t106 * (-3.718539537815992)
            + (t183 * 0.23669655349710927 + t209 * (-2.6154079303170494))
            + (t309 + (t322 - t315));
        let t337 = t82 * 0.8189613578583975 + t111 * (-3.718539537815992)
            + (t186 * 0.23669655349710927 + t214 * (-2.6154079303170494))
            + (t310 + (t323 - t316));
        let t338 = t84 * 0.8189613578583975 + t112 * (-3.718539537815992)
            + (t188 * 0.23669655349710927 + t215 * (-2.6154079303170494))
            + (t294 * (-0.25) + (t322 - t289 * (-0.25)));
        let t339 = t87 * 0.8189613578583975 + t115 * (-3.718539537815992)
            + (t191 * 0.23669655349710927 + t218 * (-2.6154079303170494))
            + (t311 - t325);
        let t340 = t90 * 0.8189613578583975 + t120 * (-3.718539537815992)
            + (t194 * 0.23669655349710927 + t223 * (-2.6154079303170494))
            + (t312 + (t326 - t318));
        let t341 = t92 * 0.8189613578583975 + t121 * (-3.718539537815992)
            + (t196 * 0.23669655349710927 + t224 * (-2.6154079303170494))
            + (t300 * (-0.25) + (t323 - t291 * (-0.25)));
        let t342 = t94 * 0.8189613578583975 + t122 * (-3.718539537815992)
            + (t198 * 0.23669655349710927 + t225 * (-2.6154079303170494))
            + (t302 * (-0.25) + (t326 - t297 * (-0.25)));
        let t343 = t97 * 0.8189613578583975 + t125 * (-3.718539537815992)
            + (t201 * 0.23669655349710927 + t228 * (-2.6154079303170494))
            + (t313 - t328);
        let t344 = t75 * 0.26825713022186887 + t100 * 5.437079075631984
            + (t179 * 1.0650762031114644 + t203 * 3.230815860634099) + t276 * 1.5;
        let t345 = t78 * 0.26825713022186887 + t104 * 5.437079075631984
            + (t182 * 1.0650762031114644 + t207 * 3.230815860634099) + t278 * 1.5;
        let t346 = t81 * 0.26825713022186887 + t109 * 5.437079075631984
            + (t185 * 1.0650762031114644 + t212 * 3.230815860634099) + t280 * 1.5;
        let t347 = t86 * 0.26825713022186887 + t114 * 5.437079075631984
            + (t190 * 1.0650762031114644 + t217 * 3.230815860634099) + t282 * 1.5;
        let t348 = t89 * 0.26825713022186887 + t118 * 5.437079075631984
            + (t193 * 1.0650762031114644 + t221 * 3.230815860634099) + t284 * 1.5;
        let t349 = t96 * 0.26825713022186887 + t124 * 5.437079075631984
            + (t200 * 1.0650762031114644 + t227 * 3.230815860634099) + t286 * 1.5;
        let t350 = t76 * 0.26825713022186887 + t101 * 5.437079075631984
            + (t180 * 1.0650762031114644 + t204 * 3.230815860634099) + t288 * 1.5;
        let t351 = t79 * 0.26825713022186887 + t106 * 5.437079075631984
            + (t183 * 1.0650762031114644 + t209 * 3.230815860634099) + t290 * 1.5;
        let t352 = t82 * 0.26825713022186887 + t111 * 5.437079075631984
            + (t186 * 1.0650762031114644 + t214 * 3.230815860634099) + t292 * 1.5;
        let t353 = t84 * 0.26825713022186887 + t112 * 5.437079075631984
            + (t188 * 1.0650762031114644 + t215 * 3.230815860634099) + t294 * 1.5;
        let t354 = t87 * 0.26825713022186887 + t115 * 5.437079075631984
            + (t191 * 1.0650762031114644 + t218 * 3.230815860634099) + t296 * 1.5;
        let t355 = t90 * 0.26825713022186887 + t120 * 5.437079075631984
            + (t194 * 1.0650762031114644 + t223 * 3.230815860634099) + t298 * 1.5;
        let t356 = t92 * 0.26825713022186887 + t121 * 5.437079075631984
            + (t196 * 1.0650762031114644 + t224 * 3.230815860634099) + t300 * 1.5;
        let t357 = t94 * 0.26825713022186887 + t122 * 5.437079075631984
            + (t198 * 1.0650762031114644 + t225 * 3.230815860634099) + t302 * 1.5;
        let t358 = t97 * 0.26825713022186887 + t125 * 5.437079075631984
            + (t201 * 1.0650762031114644 + t228 * 3.230815860634099) + t304 * 1.5;
        let t359 = t76 * (-0.08721848808026642) + t101 * (-1.718539537815992)
            + (t180 * (-0.30177275660857383) + t204 * (-0.6154079303170494))
            + (t308 + t321);
        let t360 = t79 * (-0.08721848808026642) + t106 * (-1.718539537815992)
            + (t183 * (-0.30177275660857383) + t209 * (-0.6154079303170494))
            + (t309 + (t315 - t322));
        let t361 = t82 * (-0.08721848808026642) + t111 * (-1.718539537815992)
            + (t186 * (-0.30177275660857383) + t214 * (-0.6154079303170494))
            + (t310 + (t316 - t323));
        let t362 = t87 * (-0.08721848808026642) + t115 * (-1.718539537815992)
            + (t191 * (-0.30177275660857383) + t218 * (-0.6154079303170494))
            + (t311 + t325);
        let t363 = t90 * (-0.08721848808026642) + t120 * (-1.718539537815992)
            + (t194 * (-0.30177275660857383) + t223 * (-0.6154079303170494))
            + (t312 + (t318 - t326));
        let t364 = t97 * (-0.08721848808026642) + t125 * (-1.718539537815992)
            + (t201 * (-0.30177275660857383) + t228 * (-0.6154079303170494))
            + (t313 + t328);
        let t365 = t133 + s0_x * (-0.3017727566085737) + s1_x * 0.23669655349710933;
        let t366 = t134 + s0_y * (-0.3017727566085737) + s1_y * 0.23669655349710933;
        let t367 = t135 + s0_z * (-0.3017727566085737) + s1_z * 0.23669655349710933;
        let t368 = inverse_length
            * (s0_x * 0.6154079303170494 + d_x * (-3.230815860634099)
                + s1_x * 2.6154079303170494);
        let t369 = inverse_length
            * (s0_y * 0.6154079303170494 + d_y * (-3.230815860634099)
                + s1_y * 2.6154079303170494);
        let t370 = inverse_length
            * (s0_z * 0.6154079303170494 + d_z * (-3.230815860634099)
                + s1_z * 2.6154079303170494);
        let t371 = t365 * t365 + t366 * t366 + t367 * t367;
        let t372 = (t371 - 1.0) * 0.5;
        let t373 = (t372 * t372 + 1e-12).sqrt();
        let t374 = t143 * (((t373 * 2.0).recip() * (t372 * 2.0 * 0.5) + 0.5) * 0.5)
            * 0.5;
        let t375 = t143 * ((t372 + t373) * 0.5) * 0.5
            + t144 * ((t368 * t368 + t369 * t369 + t370 * t370) * 0.5);
        let t376 = t144 * ((t365 * t368 + t366 * t369 + t367 * t370) * 2.0 * 0.5);
        let t377 = t365 * 2.0;
        let t378 = t366 * 2.0;
        let t379 = t367 * 2.0;
        let t380 = t374 * t378;
        let t381 = t374 * t379;
        let t382 = t148 * (t368 * 2.0);
        let t383 = t148 * (t369 * 2.0);
        let t384 = t148 * (t370 * 2.0);
        let t385 = t144 * t369;
        let t386 = t144 * t370;
        let t387 = t144 * t365;
        let t388 = t144 * t366;
        let t389 = t144 * t367;
        let t390 = t377 * t380 - t368 * t385;
        let t391 = t377 * t381 - t368 * t386;
        let t392 = t378 * t381 - t369 * t386;
        let t393 = t375 * 2.0;
        let t394 = t377 * (t374 * t377) - t368 * (t144 * t368) + t393;
        let t395 = t378 * t380 - t369 * t385 + t393;
        let t396 = t379 * t381 - t370 * t386 + t393;
        let t397 = t144 * (t371 * 0.5) * 2.0;
        let t398 = t390 * 1.0650762031114644;
        let t399 = t390 * 0.23669655349710933;
        let t400 = t391 * 1.0650762031114644;
        let t401 = t391 * 0.23669655349710933;
        let t402 = t392 * 1.0650762031114644;
        let t403 = t392 * 0.23669655349710933;
        let t404 = inverse_length * (t377 * t382 - t368 * t387 - t376);
        let t405 = t394 * 1.0650762031114644 + t404 * (-3.230815860634099);
        let t406 = t394 * 0.23669655349710933 + t404 * 2.6154079303170494;
        let t407 = inverse_length * (t377 * t383 - t368 * t388);
        let t408 = t398 + t407 * (-3.230815860634099);
        let t409 = t399 + t407 * 2.6154079303170494;
        let t410 = inverse_length * (t377 * t384 - t368 * t389);
        let t411 = t400 + t410 * (-3.230815860634099);
        let t412 = t401 + t410 * 2.6154079303170494;
        let t413 = inverse_length * (t378 * t382 - t369 * t387);
        let t414 = t399 + t413 * 2.6154079303170494;
        let t415 = inverse_length * (t378 * t383 - t369 * t388 - t376);
        let t416 = t395 * 1.0650762031114644 + t415 * (-3.230815860634099);
        let t417 = t395 * 0.23669655349710933 + t415 * 2.6154079303170494;
        let t418 = inverse_length * (t378 * t384 - t369 * t389);
        let t419 = t402 + t418 * (-3.230815860634099);
        let t420 = t403 + t418 * 2.6154079303170494;
        let t421 = inverse_length * (t379 * t382 - t370 * t387);
        let t422 = t401 + t421 * 2.6154079303170494;
        let t423 = inverse_length * (t379 * t383 - t370 * t388);
        let t424 = t403 + t423 * 2.6154079303170494;
        let t425 = inverse_length * (t379 * t384 - t370 * t389 - t376);
        let t426 = t396 * 1.0650762031114644 + t425 * (-3.230815860634099);
        let t427 = t396 * 0.23669655349710933 + t425 * 2.6154079303170494;
        let t428 = t98 * (t397 - t365 * t387);
        let t429 = t404 * 1.0650762031114644 + t428 * (-3.230815860634099);
        let t430 = t404 * 0.23669655349710933 + t428 * 2.6154079303170494;
        let t431 = t98 * (t365 * t388);
        let t432 = t431 * (-3.230815860634099);
        let t433 = t413 * 1.0650762031114644 - t432;
        let t434 = t431 * 2.6154079303170494;
        let t435 = t413 * 0.23669655349710933 - t434;
        let t436 = t98 * (t365 * t389);
        let t437 = t436 * (-3.230815860634099);
        let t438 = t421 * 1.0650762031114644 - t437;
        let t439 = t436 * 2.6154079303170494;
        let t440 = t421 * 0.23669655349710933 - t439;
        let t441 = t407 * 0.23669655349710933 - t434;
        let t442 = t98 * (t397 - t366 * t388);
        let t443 = t415 * 1.0650762031114644 + t442 * (-3.230815860634099);
        let t444 = t415 * 0.23669655349710933 + t442 * 2.6154079303170494;
        let t445 = t98 * (t366 * t389);
        let t446 = t445 * (-3.230815860634099);
        let t447 = t423 * 1.0650762031114644 - t446;
        let t448 = t445 * 2.6154079303170494;
        let t449 = t423 * 0.23669655349710933 - t448;
        let t450 = t410 * 0.23669655349710933 - t439;
        let t451 = t418 * 0.23669655349710933 - t448;
        let t452 = t98 * (t397 - t367 * t389);
        let t453 = t425 * 1.0650762031114644 + t452 * (-3.230815860634099);
        let t454 = t425 * 0.23669655349710933 + t452 * 2.6154079303170494;
        let t455 = (t394 * (-0.3017727566085737) + t404 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t404 * (-0.3017727566085737) + t428 * 0.6154079303170494)
                * 0.6154079303170494;
        let t456 = (t390 * (-0.3017727566085737) + t407 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t413 * (-0.3017727566085737) - t431 * 0.6154079303170494)
                * 0.6154079303170494;
        let t457 = (t391 * (-0.3017727566085737) + t410 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t421 * (-0.3017727566085737) - t436 * 0.6154079303170494)
                * 0.6154079303170494;
        let t458 = (t395 * (-0.3017727566085737) + t415 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t415 * (-0.3017727566085737) + t442 * 0.6154079303170494)
                * 0.6154079303170494;
        let t459 = (t392 * (-0.3017727566085737) + t418 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t423 * (-0.3017727566085737) - t445 * 0.6154079303170494)
                * 0.6154079303170494;
        let t460 = (t396 * (-0.3017727566085737) + t425 * 0.6154079303170494)
            * (-0.3017727566085737)
            + (t425 * (-0.3017727566085737) + t452 * 0.6154079303170494)
                * 0.6154079303170494;
        let t461 = t235 + (t305 - t289 * 1.5)
            + ((t398 + t413 * (-3.230815860634099)) * (-0.3017727566085737)
                + (t407 * 1.0650762031114644 - t432) * 0.6154079303170494);
        let t462 = t236 + (t306 - t291 * 1.5)
            + ((t400 + t421 * (-3.230815860634099)) * (-0.3017727566085737)
                + (t410 * 1.0650762031114644 - t437) * 0.6154079303170494);
        let t463 = t237 + (t307 - t297 * 1.5)
            + ((t402 + t423 * (-3.230815860634099)) * (-0.3017727566085737)
                + (t418 * 1.0650762031114644 - t446) * 0.6154079303170494);
        let t464 = s0_x * (-0.08721848808026644) + d_x * 0.26825713022186914
            + s1_x * 0.8189613578583973;
        let t465 = s0_y * (-0.08721848808026644) + d_y * 0.26825713022186914
            + s1_y * 0.8189613578583973;
        let t466 = s0_z * (-0.08721848808026644) + d_z * 0.26825713022186914
            + s1_z * 0.8189613578583973;
        let t467 = inverse_length
            * (s0_x * 1.7185395378159916 + d_x * (-5.437079075631983)
                + s1_x * 3.7185395378159916);
        let t468 = inverse_length
            * (s0_y * 1.7185395378159916 + d_y * (-5.437079075631983)
                + s1_y * 3.7185395378159916);
        let t469 = inverse_length
            * (s0_z * 1.7185395378159916 + d_z * (-5.437079075631983)
                + s1_z * 3.7185395378159916);
        let t470 = t464 * t464 + t465 * t465 + t466 * t466;
        let t471 = (t470 - 1.0) * 0.5;
        let t472 = (t471 * t471 + 1e-12).sqrt();
        let t473 = t39 * (((t472 * 2.0).recip() * (t471 * 2.0 * 0.5) + 0.5) * 0.5) * 0.5;
        let t474 = t39 * ((t471 + t472) * 0.5) * 0.5
            + t40 * ((t467 * t467 + t468 * t468 + t469 * t469) * 0.5);
        let t475 = t40 * ((t464 * t467 + t465 * t468 + t466 * t469) * 2.0 * 0.5);
        let t476 = t464 * 2.0;
        let t477 = t465 * 2.0;
        let t478 = t466 * 2.0;
        let t479 = t473 * t477;
        let t480 = t473 * t478;
        let t481 = t44 * (t467 * 2.0);
        let t482 = t44 * (t468 * 2.0);
        let t483 = t44 * (t469 * 2.0);
        let t484 = t40 * t468;
        let t485 = t40 * t469;
        let t486 = t40 * t464;
        let t487 = t40 * t465;
        let t488 = t40 * t466;
        let t489 = t476 * t479 - t467 * t484;
        let t490 = t476 * t480 - t467 * t485;
        let t491 = t477 * t480 - t468 * t485;
        let t492 = t474 * 2.0;
        let t493 = t476 * (t473 * t476) - t467 * (t40 * t467) + t492;
        let t494 = t477 * t479 - t468 * t484 + t492;
        let t495 = t478 * t480 - t469 * t485 + t492;
        let t496 = t40 * (t470 * 0.5) * 2.0;
        let t497 = t489 * 0.26825713022186914;
        let t498 = t489 * 0.8189613578583973;
        let t499 = t490 * 0.26825713022186914;
        let t500 = t490 * 0.8189613578583973;
        let t501 = t491 * 0.26825713022186914;
        let t502 = t491 * 0.8189613578583973;
        let t503 = inverse_length * (t476 * t481 - t467 * t486 - t475);
        let t504 = t493 * 0.26825713022186914 + t503 * (-5.437079075631983);
        let t505 = t493 * 0.8189613578583973 + t503 * 3.7185395378159916;
        let t506 = inverse_length * (t476 * t482 - t467 * t487);
        let t507 = t497 + t506 * (-5.437079075631983);
        let t508 = t498 + t506 * 3.7185395378159916;
        let t509 = inverse_length * (t476 * t483 - t467 * t488);
        let t510 = t499 + t509 * (-5.437079075631983);
        let t511 = t500 + t509 * 3.7185395378159916;
        let t512 = inverse_length * (t477 * t481 - t468 * t486);
        let t513 = t498 + t512 * 3.7185395378159916;
        let t514 = inverse_length * (t477 * t482 - t468 * t487 - t475);
        let t515 = t494 * 0.26825713022186914 + t514 * (-5.437079075631983);
        let t516 = t494 * 0.8189613578583973 + t514 * 3.7185395378159916;
        let t517 = inverse_length * (t477 * t483 - t468 * t488);
        let t518 = t501 + t517 * (-5.437079075631983);
        let t519 = t502 + t517 * 3.7185395378159916;
        let t520 = inverse_length * (t478 * t481 - t469 * t486);
        let t521 = t500 + t520 * 3.7185395378159916;
        let t522 = inverse_length * (t478 * t482 - t469 * t487);
        let t523 = t502 + t522 * 3.7185395378159916;
        let t524 = inverse_length * (t478 * t483 - t469 * t488 - t475);
        let t525 = t495 * 0.26825713022186914 + t524 * (-5.437079075631983);
        let t526 = t495 * 0.8189613578583973 + t524 * 3.7185395378159916;
        let t527 = t98 * (t496 - t464 * t486);
        let t528 = t503 * 0.26825713022186914 + t527 * (-5.437079075631983);
        let t529 = t503 * 0.8189613578583973 + t527 * 3.7185395378159916;
        let t530 = t98 * (t464 * t487);
        let t531 = t530 * (-5.437079075631983);
        let t532 = t512 * 0.26825713022186914 - t531;
        let t533 = t530 * 3.7185395378159916;
        let t534 = t512 * 0.8189613578583973 - t533;
        let t535 = t98 * (t464 * t488);
        let t536 = t535 * (-5.437079075631983);
        let t537 = t520 * 0.26825713022186914 - t536;
        let t538 = t535 * 3.7185395378159916;
        let t539 = t520 * 0.8189613578583973 - t538;
        let t540 = t506 * 0.8189613578583973 - t533;
        let t541 = t98 * (t496 - t465 * t487);
        let t542 = t514 * 0.26825713022186914 + t541 * (-5.437079075631983);
        let t543 = t514 * 0.8189613578583973 + t541 * 3.7185395378159916;
        let t544 = t98 * (t465 * t488);
        let t545 = t544 * (-5.437079075631983);
        let t546 = t522 * 0.26825713022186914 - t545;
        let t547 = t544 * 3.7185395378159916;
        let t548 = t522 * 0.8189613578583973 - t547;
        let t549 = t509 * 0.8189613578583973 - t538;
        let t550 = t517 * 0.8189613578583973 - t547;
        let t551 = t98 * (t496 - t466 * t488);
        let t552 = t524 * 0.26825713022186914 + t551 * (-5.437079075631983);
        let t553 = t524 * 0.8189613578583973 + t551 * 3.7185395378159916;
        let t554 = (t493 * (-0.08721848808026644) + t503 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t503 * (-0.08721848808026644) + t527 * 1.7185395378159916)
                * 1.7185395378159916;
        let t555 = (t489 * (-0.08721848808026644) + t506 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t512 * (-0.08721848808026644) - t530 * 1.7185395378159916)
                * 1.7185395378159916;
        let t556 = (t490 * (-0.08721848808026644) + t509 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t520 * (-0.08721848808026644) - t535 * 1.7185395378159916)
                * 1.7185395378159916;
        let t557 = (t494 * (-0.08721848808026644) + t514 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t514 * (-0.08721848808026644) + t541 * 1.7185395378159916)
                * 1.7185395378159916;
        let t558 = (t491 * (-0.08721848808026644) + t517 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t522 * (-0.08721848808026644) - t544 * 1.7185395378159916)
                * 1.7185395378159916;
        let t559 = (t495 * (-0.08721848808026644) + t524 * 1.7185395378159916)
            * (-0.08721848808026644)
            + (t524 * (-0.08721848808026644) + t551 * 1.7185395378159916)
                * 1.7185395378159916;
        let t560 = t127 + t230 + ((t277 - t289) * (-0.25) - (t315 + t322)) + t456 + t555;
        let t561 = t128 + t231 + ((t279 - t291) * (-0.25) - (t316 + t323)) + t457 + t556;
        let t562 = t130 + t233 + ((t283 - t297) * (-0.25) - (t318 + t326)) + t459 + t558;
        let t563 = t335 + (t406 * (-0.3017727566085737) + t430 * 0.6154079303170494)
            + (t505 * (-0.08721848808026644) + t529 * 1.7185395378159916);
        let t564 = t336 + (t409 * (-0.3017727566085737) + t435 * 0.6154079303170494)
            + (t508 * (-0.08721848808026644) + t534 * 1.7185395378159916);
        let t565 = t337 + (t412 * (-0.3017727566085737) + t440 * 0.6154079303170494)
            + (t511 * (-0.08721848808026644) + t539 * 1.7185395378159916);
        let t566 = t338 + (t414 * (-0.3017727566085737) + t441 * 0.6154079303170494)
            + (t513 * (-0.08721848808026644) + t540 * 1.7185395378159916);
        let t567 = t339 + (t417 * (-0.3017727566085737) + t444 * 0.6154079303170494)
            + (t516 * (-0.08721848808026644) + t543 * 1.7185395378159916);
        let t568 = t340 + (t420 * (-0.3017727566085737) + t449 * 0.6154079303170494)
            + (t519 * (-0.08721848808026644) + t548 * 1.7185395378159916);
        let t569 = t341 + (t422 * (-0.3017727566085737) + t450 * 0.6154079303170494)
            + (t521 * (-0.08721848808026644) + t549 * 1.7185395378159916);
        let t570 = t342 + (t424 * (-0.3017727566085737) + t451 * 0.6154079303170494)
            + (t523 * (-0.08721848808026644) + t550 * 1.7185395378159916);
        let t571 = t343 + (t427 * (-0.3017727566085737) + t454 * 0.6154079303170494)
            + (t526 * (-0.08721848808026644) + t553 * 1.7185395378159916);
        let t572 = t360 + (t409 * 0.23669655349710933 + t435 * 2.6154079303170494)
            + (t508 * 0.8189613578583973 + t534 * 3.7185395378159916);
        let t573 = t361 + (t412 * 0.23669655349710933 + t440 * 2.6154079303170494)
            + (t511 * 0.8189613578583973 + t539 * 3.7185395378159916);
        let t574 = t363 + (t420 * 0.23669655349710933 + t449 * 2.6154079303170494)
            + (t519 * 0.8189613578583973 + t548 * 3.7185395378159916);
        let t575 = t98
            * (t344 + (t405 * 1.0650762031114644 + t429 * (-3.230815860634099))
                + (t504 * 0.26825713022186914 + t528 * (-5.437079075631983)));
        let t576 = t98
            * (t345 + (t408 * 1.0650762031114644 + t433 * (-3.230815860634099))
                + (t507 * 0.26825713022186914 + t532 * (-5.437079075631983)));
        let t577 = t98
            * (t346 + (t411 * 1.0650762031114644 + t438 * (-3.230815860634099))
                + (t510 * 0.26825713022186914 + t537 * (-5.437079075631983)));
        let t578 = inverse_length
            * (t329 + (t405 * (-0.3017727566085737) + t429 * 0.6154079303170494)
                + (t504 * (-0.08721848808026644) + t528 * 1.7185395378159916));
        let t579 = inverse_length
            * (t461
                + ((t497 + t512 * (-5.437079075631983)) * (-0.08721848808026644)
                    + (t506 * 0.26825713022186914 - t531) * 1.7185395378159916));
        let t580 = inverse_length
            * (t462
                + ((t499 + t520 * (-5.437079075631983)) * (-0.08721848808026644)
                    + (t509 * 0.26825713022186914 - t536) * 1.7185395378159916));
        let t581 = inverse_length
            * (t350 + (t406 * 1.0650762031114644 + t430 * (-3.230815860634099))
                + (t505 * 0.26825713022186914 + t529 * (-5.437079075631983)));
        let t582 = inverse_length
            * (t351 + (t409 * 1.0650762031114644 + t435 * (-3.230815860634099))
                + (t508 * 0.26825713022186914 + t534 * (-5.437079075631983)));
        let t583 = inverse_length
            * (t352 + (t412 * 1.0650762031114644 + t440 * (-3.230815860634099))
                + (t511 * 0.26825713022186914 + t539 * (-5.437079075631983)));
        let t584 = t98
            * (t347 + (t416 * 1.0650762031114644 + t443 * (-3.230815860634099))
                + (t515 * 0.26825713022186914 + t542 * (-5.437079075631983)));
        let t585 = t98
            * (t348 + (t419 * 1.0650762031114644 + t447 * (-3.230815860634099))
                + (t518 * 0.26825713022186914 + t546 * (-5.437079075631983)));
        let t586 = inverse_length
            * (t330 + (t408 * (-0.3017727566085737) + t433 * 0.6154079303170494)
                + (t507 * (-0.08721848808026644) + t532 * 1.7185395378159916));
        let t587 = inverse_length
            * (t332 + (t416 * (-0.3017727566085737) + t443 * 0.6154079303170494)
                + (t515 * (-0.08721848808026644) + t542 * 1.7185395378159916));
        let t588 = inverse_length
            * (t463
                + ((t501 + t522 * (-5.437079075631983)) * (-0.08721848808026644)
                    + (t517 * 0.26825713022186914 - t545) * 1.7185395378159916));
        let t589 = inverse_length
            * (t353 + (t414 * 1.0650762031114644 + t441 * (-3.230815860634099))
                + (t513 * 0.26825713022186914 + t540 * (-5.437079075631983)));
        let t590 = inverse_length
            * (t354 + (t417 * 1.0650762031114644 + t444 * (-3.230815860634099))
                + (t516 * 0.26825713022186914 + t543 * (-5.437079075631983)));
        let t591 = inverse_length
            * (t355 + (t420 * 1.0650762031114644 + t449 * (-3.230815860634099))
                + (t519 * 0.26825713022186914 + t548 * (-5.437079075631983)));
        let t592 = t98
            * (t349 + (t426 * 1.0650762031114644 + t453 * (-3.230815860634099))
                + (t525 * 0.26825713022186914 + t552 * (-5.437079075631983)));
        let t593 = inverse_length
            * (t331 + (t411 * (-0.3017727566085737) + t438 * 0.6154079303170494)
                + (t510 * (-0.08721848808026644) + t537 * 1.7185395378159916));
        let t594 = inverse_length
            * (t333 + (t419 * (-0.3017727566085737) + t447 * 0.6154079303170494)
                + (t518 * (-0.08721848808026644) + t546 * 1.7185395378159916));
        let t595 = inverse_length
            * (t334 + (t426 * (-0.3017727566085737) + t453 * 0.6154079303170494)
                + (t525 * (-0.08721848808026644) + t552 * 1.7185395378159916));
        let t596 = inverse_length
            * (t356 + (t422 * 1.0650762031114644 + t450 * (-3.230815860634099))
                + (t521 * 0.26825713022186914 + t549 * (-5.437079075631983)));
        let t597 = inverse_length
            * (t357 + (t424 * 1.0650762031114644 + t451 * (-3.230815860634099))
                + (t523 * 0.26825713022186914 + t550 * (-5.437079075631983)));
        let t598 = inverse_length
            * (t358 + (t427 * 1.0650762031114644 + t454 * (-3.230815860634099))
                + (t526 * 0.26825713022186914 + t553 * (-5.437079075631983)));
        stiffness[0] += t575;
        stiffness[1] += t576;
        stiffness[2] += t577;
        stiffness[3] -= t578;
        stiffness[4] -= t579;
        stiffness[5] -= t580;
        stiffness[6] -= t575;
        stiffness[7] -= t576;
        stiffness[8] -= t577;
        stiffness[9] -= t581;
        stiffness[10] -= t582;
        stiffness[11] -= t583;
        stiffness[12] += t576;
        stiffness[13] += t584;
        stiffness[14] += t585;
        stiffness[15] -= t586;
        stiffness[16] -= t587;
        stiffness[17] -= t588;
        stiffness[18] -= t576;
        stiffness[19] -= t584;
        stiffness[20] -= t585;
        stiffness[21] -= t589;
        stiffness[22] -= t590;
        stiffness[23] -= t591;
        stiffness[24] += t577;
        stiffness[25] += t585;
        stiffness[26] += t592;
        stiffness[27] -= t593;
        stiffness[28] -= t594;
        stiffness[29] -= t595;
        stiffness[30] -= t577;
        stiffness[31] -= t585;
        stiffness[32] -= t592;
        stiffness[33] -= t596;
        stiffness[34] -= t597;
        stiffness[35] -= t598;
        stiffness[36] -= t578;
        stiffness[37] -= t586;
        stiffness[38] -= t593;
        stiffness[39]
            += t126 + t229 + ((t275 - t287) * (-0.25) + (t320 - t314)) + t455 + t554;
        stiffness[40] += t560;
        stiffness[41] += t561;
        stiffness[42] += t578;
        stiffness[43] += t586;
        stiffness[44] += t593;
        stiffness[45] += t563;
        stiffness[46] += t564;
        stiffness[47] += t565;
        stiffness[48] -= t579;
        stiffness[49] -= t587;
        stiffness[50] -= t594;
        stiffness[51] += t560;
        stiffness[52]
            += t129 + t232 + ((t281 - t295) * (-0.25) + (t324 - t317)) + t458 + t557;
        stiffness[53] += t562;
        stiffness[54] += t579;
        stiffness[55] += t587;
        stiffness[56] += t594;
        stiffness[57] += t566;
        stiffness[58] += t567;
        stiffness[59] += t568;
        stiffness[60] -= t580;
        stiffness[61] -= t588;
        stiffness[62] -= t595;
        stiffness[63] += t561;
        stiffness[64] += t562;
        stiffness[65]
            += t131 + t234 + ((t285 - t303) * (-0.25) + (t327 - t319)) + t460 + t559;
        stiffness[66] += t580;
        stiffness[67] += t588;
        stiffness[68] += t595;
        stiffness[69] += t569;
        stiffness[70] += t570;
        stiffness[71] += t571;
        stiffness[72] -= t575;
        stiffness[73] -= t576;
        stiffness[74] -= t577;
        stiffness[75] += t578;
        stiffness[76] += t579;
        stiffness[77] += t580;
        stiffness[78] += t575;
        stiffness[79] += t576;
        stiffness[80] += t577;
        stiffness[81] += t581;
        stiffness[82] += t582;
        stiffness[83] += t583;
        stiffness[84] -= t576;
        stiffness[85] -= t584;
        stiffness[86] -= t585;
        stiffness[87] += t586;
        stiffness[88] += t587;
        stiffness[89] += t588;
        stiffness[90] += t576;
        stiffness[91] += t584;
        stiffness[92] += t585;
        stiffness[93] += t589;
        stiffness[94] += t590;
        stiffness[95] += t591;
        stiffness[96] -= t577;
        stiffness[97] -= t585;
        stiffness[98] -= t592;
        stiffness[99] += t593;
        stiffness[100] += t594;
        stiffness[101] += t595;
        stiffness[102] += t577;
        stiffness[103] += t585;
        stiffness[104] += t592;
        stiffness[105] += t596;
        stiffness[106] += t597;
        stiffness[107] += t598;
        stiffness[108] -= t581;
        stiffness[109] -= t589;
        stiffness[110] -= t596;
        stiffness[111] += t563;
        stiffness[112] += t566;
        stiffness[113] += t569;
        stiffness[114] += t581;
        stiffness[115] += t589;
        stiffness[116] += t596;
        stiffness[117]
            += t359 + (t406 * 0.23669655349710933 + t430 * 2.6154079303170494)
                + (t505 * 0.8189613578583973 + t529 * 3.7185395378159916);
        stiffness[118] += t572;
        stiffness[119] += t573;
        stiffness[120] -= t582;
        stiffness[121] -= t590;
        stiffness[122] -= t597;
        stiffness[123] += t564;
        stiffness[124] += t567;
        stiffness[125] += t570;
        stiffness[126] += t582;
        stiffness[127] += t590;
        stiffness[128] += t597;
        stiffness[129] += t572;
        stiffness[130]
            += t362 + (t417 * 0.23669655349710933 + t444 * 2.6154079303170494)
                + (t516 * 0.8189613578583973 + t543 * 3.7185395378159916);
        stiffness[131] += t574;
        stiffness[132] -= t583;
        stiffness[133] -= t591;
        stiffness[134] -= t598;
        stiffness[135] += t565;
        stiffness[136] += t568;
        stiffness[137] += t571;
        stiffness[138] += t583;
        stiffness[139] += t591;
        stiffness[140] += t598;
        stiffness[141] += t573;
        stiffness[142] += t574;
        stiffness[143]
            += t364 + (t427 * 0.23669655349710933 + t454 * 2.6154079303170494)
                + (t526 * 0.8189613578583973 + t553 * 3.7185395378159916);
    }
    /// [`cable_spatial_slack_elastic_tangent`] of four elements side by side.
    pub struct CableSpatialSlackElasticTangent<'a> {
        pub rows: [&'a CableSpatialSlack; 4],
        pub q: &'a [[f64; 4]; 12],
        pub stiffness: &'a mut [[f64; 4]; 144],
    }
    impl ::rncf::emitted::lanes::Kernel for CableSpatialSlackElasticTangent<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, stiffness } = self;
            let row = CableSpatialSlack::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_slack_elastic_tangent(&row, &q, stiffness);
        }
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, slack = true, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 5 Gauss points, unrolled.
    ///
    /// Operations: 125 additions, 200 multiplications, 6 divisions, 10 function calls.
    pub fn cable_spatial_slack_strain_energy(
        row: &CableSpatialSlack,
        q: &[f64; 12],
        energy: &mut f64,
    ) {
        let CableSpatialSlack { length, EA, EI, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t31 = length * 0.1184634425280945;
        let t32 = s0_x * 0.8189613578583975 + d_x * 0.26825713022186887
            + s1_x * (-0.08721848808026642);
        let t33 = s0_y * 0.8189613578583975 + d_y * 0.26825713022186887
            + s1_y * (-0.08721848808026642);
        let t34 = s0_z * 0.8189613578583975 + d_z * 0.26825713022186887
            + s1_z * (-0.08721848808026642);
        let t35 = inverse_length
            * (s0_x * (-3.718539537815992) + d_x * 5.437079075631984
                + s1_x * (-1.718539537815992));
        let t36 = inverse_length
            * (s0_y * (-3.718539537815992) + d_y * 5.437079075631984
                + s1_y * (-1.718539537815992));
        let t37 = inverse_length
            * (s0_z * (-3.718539537815992) + d_z * 5.437079075631984
                + s1_z * (-1.718539537815992));
        let t38 = t32 * t32 + t33 * t33 + t34 * t34;
        let t39 = EA * t31;
        let t40 = EI * t31;
        let t41 = 0.5 * (t38 - 1.0);
        let t42 = t41 + (1e-12 + t41 * t41).sqrt();
        let t43 = t38 * (t35 * t35 + t36 * t36 + t37 * t37)
            - (t32 * t35 + t33 * t36 + t34 * t37).powi(2);
        let t44 = t39 * (0.25 * (t41 * t42 + 1e-12 * (t42 / 1e-6).ln()))
            + t40 * (0.5 * t43);
        let t45 = length * 0.23931433524968324;
        let t46 = d_x * 1.0650762031114644;
        let t47 = d_y * 1.0650762031114644;
        let t48 = d_z * 1.0650762031114644;
        let t49 = s0_x * 0.23669655349710927 + t46 + s1_x * (-0.30177275660857383);
        let t50 = s0_y * 0.23669655349710927 + t47 + s1_y * (-0.30177275660857383);
        let t51 = s0_z * 0.23669655349710927 + t48 + s1_z * (-0.30177275660857383);
        let t52 = inverse_length
            * (s0_x * (-2.6154079303170494) + d_x * 3.230815860634099
                + s1_x * (-0.6154079303170494));
        let t53 = inverse_length
            * (s0_y * (-2.6154079303170494) + d_y * 3.230815860634099
                + s1_y * (-0.6154079303170494));
        let t54 = inverse_length
            * (s0_z * (-2.6154079303170494) + d_z * 3.230815860634099
                + s1_z * (-0.6154079303170494));
        let t55 = t49 * t49 + t50 * t50 + t51 * t51;
        let t56 = EA * t45;
        let t57 = EI * t45;
        let t58 = 0.5 * (t55 - 1.0);
        let t59 = t58 + (1e-12 + t58 * t58).sqrt();
        let t60 = t55 * (t52 * t52 + t53 * t53 + t54 * t54)
            - (t49 * t52 + t50 * t53 + t51 * t54).powi(2);
        let t61 = t56 * (0.25 * (t58 * t59 + 1e-12 * (t59 / 1e-6).ln()))
            + t57 * (0.5 * t60);
        let t62 = length * 0.28444444444444444;
        let t63 = s0_x * (-0.25) + d_x * 1.5 + s1_x * (-0.25);
        let t64 = s0_y * (-0.25) + d_y * 1.5 + s1_y * (-0.25);
        let t65 = s0_z * (-0.25) + d_z * 1.5 + s1_z * (-0.25);
        let t66 = inverse_length * (s1_x - s0_x);
        let t67 = inverse_length * (s1_y - s0_y);
        let t68 = inverse_length * (s1_z - s0_z);
        let t69 = t63 * t63 + t64 * t64 + t65 * t65;
        let t70 = 0.5 * (t69 - 1.0);
        let t71 = t70 + (1e-12 + t70 * t70).sqrt();
        let t72 = t69 * (t66 * t66 + t67 * t67 + t68 * t68)
            - (t63 * t66 + t64 * t67 + t65 * t68).powi(2);
        let t73 = EA * t62 * (0.25 * (t70 * t71 + 1e-12 * (t71 / 1e-6).ln()))
            + EI * t62 * (0.5 * t72);
        let t74 = t46 + s0_x * (-0.3017727566085737) + s1_x * 0.23669655349710933;
        let t75 = t47 + s0_y * (-0.3017727566085737) + s1_y * 0.23669655349710933;
        let t76 = t48 + s0_z * (-0.3017727566085737) + s1_z * 0.23669655349710933;
        let t77 = inverse_length
            * (s0_x * 0.6154079303170494 + d_x * (-3.230815860634099)
                + s1_x * 2.6154079303170494);
        let t78 = inverse_length
            * (s0_y * 0.6154079303170494 + d_y * (-3.230815860634099)
                + s1_y * 2.6154079303170494);
        let t79 = inverse_length
            * (s0_z * 0.6154079303170494 + d_z * (-3.230815860634099)
                + s1_z * 2.6154079303170494);
        let t80 = t74 * t74 + t75 * t75 + t76 * t76;
        let t81 = 0.5 * (t80 - 1.0);
        let t82 = t81 + (1e-12 + t81 * t81).sqrt();
        let t83 = t80 * (t77 * t77 + t78 * t78 + t79 * t79)
            - (t74 * t77 + t75 * t78 + t76 * t79).powi(2);
        let t84 = t56 * (0.25 * (t81 * t82 + 1e-12 * (t82 / 1e-6).ln()))
            + t57 * (0.5 * t83);
        let t85 = s0_x * (-0.08721848808026644) + d_x * 0.26825713022186914
            + s1_x * 0.8189613578583973;
        let t86 = s0_y * (-0.08721848808026644) + d_y * 0.26825713022186914
            + s1_y * 0.8189613578583973;
        let t87 = s0_z * (-0.08721848808026644) + d_z * 0.26825713022186914
            + s1_z * 0.8189613578583973;
        let t88 = inverse_length
            * (s0_x * 1.7185395378159916 + d_x * (-5.437079075631983)
                + s1_x * 3.7185395378159916);
        let t89 = inverse_length
            * (s0_y * 1.7185395378159916 + d_y * (-5.437079075631983)
                + s1_y * 3.7185395378159916);
        let t90 = inverse_length
            * (s0_z * 1.7185395378159916 + d_z * (-5.437079075631983)
                + s1_z * 3.7185395378159916);
        let t91 = t85 * t85 + t86 * t86 + t87 * t87;
        let t92 = 0.5 * (t91 - 1.0);
        let t93 = t92 + (1e-12 + t92 * t92).sqrt();
        let t94 = t91 * (t88 * t88 + t89 * t89 + t90 * t90)
            - (t85 * t88 + t86 * t89 + t87 * t90).powi(2);
        let t95 = t39 * (0.25 * (t92 * t93 + 1e-12 * (t93 / 1e-6).ln()))
            + t40 * (0.5 * t94);
        *energy += t44 + t61 + t73 + t84 + t95;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_spatial_slack_mass(row: &CableSpatialSlack, mass: &mut [f64; 16]) {
        let CableSpatialSlack { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * CABLE_SPATIAL_SLACK_MASS_MATRIX[0][0];
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * CABLE_SPATIAL_SLACK_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * CABLE_SPATIAL_SLACK_MASS_MATRIX[0][2];
        let mass_r0_s1 = t16 * CABLE_SPATIAL_SLACK_MASS_MATRIX[0][3];
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * CABLE_SPATIAL_SLACK_MASS_MATRIX[1][1];
        let mass_s0_r1 = t16 * CABLE_SPATIAL_SLACK_MASS_MATRIX[1][2];
        let mass_s0_s1 = t20 * CABLE_SPATIAL_SLACK_MASS_MATRIX[1][3];
        let mass_r1_s1 = t16 * CABLE_SPATIAL_SLACK_MASS_MATRIX[2][3];
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
    pub fn cable_spatial_slack_shapes_position_0(
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
    pub fn cable_spatial_slack_shapes_position_1(
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
    pub fn cable_spatial_slack_shapes_position_2(
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
    /// Operations: 22 additions, 54 multiplications, 1 function calls.
    pub fn cable_spatial_slack_field_forces(
        row: &CableSpatialSlack,
        stress_free: &[f64; 6],
        fields: &[f64; 6],
        forces: &mut [f64; 6],
    ) {
        let CableSpatialSlack { length, EA, EI, .. } = *row;
        let t23 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2];
        let t24 = fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5];
        let t25 = 0.5 * (t23 - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t26 = EA * (0.5 * (t25 + (1e-12 + t25 * t25).sqrt()));
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
    /// Free frame `sail`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `core`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Spins about its z axis, which points away from the Sun.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_sail(model: &EsailSlack, spec: &mut ::rncf::emitted::FreeSpec) {
        spec.position[0] = 150000000000.0;
        spec.velocity[1] = 29824.48658401348;
        spec.spin[0] = -1.9882991056008987e-7;
        spec.spin[2] = model.spin;
        spec.angle = 1.5707963267948966;
        spec.axis[1] = 1.0;
        spec.rigid.mass = model.core_mass;
    }
    /// Start of body `aux` at the arclength x (m): position (m) and velocity (m/s) in its frame, each with its derivative by x.
    ///
    /// Operations: 2 additions, 7 multiplications, 3 divisions, 2 function calls.
    pub fn initial_aux(
        model: &EsailSlack,
        x: f64,
        index: f64,
        position: &mut [[f64; 3]; 2],
        velocity: &mut [[f64; 3]; 2],
    ) {
        let t17 = model.length + model.hub_radius;
        let t18 = index * 6.283185307179586 / (model.tethers as f64) + x / t17;
        let t19 = t18.cos();
        let t20 = t18.sin();
        let t21 = 1.0 / t17;
        position[0][0] = t17 * t19;
        position[0][1] = t17 * t20;
        position[1][0] = -t17 * (t20 * t21);
        position[1][1] = t17 * (t19 * t21);
    }
    /// Joint `hub`: conditions, position level.
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn joint_hub_referenced_position(
        model: &EsailSlack,
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
        rows[3] = data.normals[0][0] * q[3] + data.normals[0][1] * q[4]
            + data.normals[0][2] * q[5];
        rows[4] = data.normals[1][0] * q[3] + data.normals[1][1] * q[4]
            + data.normals[1][2] * q[5];
    }
    /// Joint `hub`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_hub_referenced_jacobian(
        model: &EsailSlack,
        t: f64,
        data: &::rncf::emitted::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[7] = 1.0;
        jacobian[14] = 1.0;
        jacobian[21] = data.normals[0][0];
        jacobian[22] = data.normals[0][1];
        jacobian[23] = data.normals[0][2];
        jacobian[27] = data.normals[1][0];
        jacobian[28] = data.normals[1][1];
        jacobian[29] = data.normals[1][2];
    }
    /// Joint `hub`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_hub_referenced_prescribed(
        model: &EsailSlack,
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
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): rows C(z, t).
    ///
    /// Of `sun_x`: `z[0]` a direction of `sail`; `z[1]` a point of `sail` (inertial axes).
    ///
    /// * value: `(z[0][0][0] * z[1][0][0] + z[0][0][1] * z[1][0][1] + z[0][0][2] * z[1][0][2]) / 150000000000.0`
    ///
    /// Operations: 2 additions, 3 multiplications, 1 divisions.
    pub fn constraint_position_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        rows[0] = (z[0][0][0] * z[1][0][0] + z[0][0][1] * z[1][0][1]
            + z[0][0][2] * z[1][0][2]) / 150000000000.0;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): their rate dC/dt.
    ///
    /// Operations: 5 additions, 6 multiplications, 1 divisions.
    pub fn constraint_velocity_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        let t24 = z[1][0][0] * z[0][1][0] + z[0][0][0] * z[1][1][0]
            + (z[1][0][1] * z[0][1][1] + z[0][0][1] * z[1][1][1])
            + (z[1][0][2] * z[0][1][2] + z[0][0][2] * z[1][1][2]);
        rows[0] = t24 / 150000000000.0;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): their second time derivative.
    ///
    /// Operations: 11 additions, 9 multiplications, 1 divisions.
    pub fn constraint_acceleration_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        let t30 = z[0][1][0] * z[1][1][0];
        let t31 = z[0][1][1] * z[1][1][1];
        let t32 = t30 + z[1][0][0] * z[0][2][0] + (t30 + z[0][0][0] * z[1][2][0])
            + (t31 + z[1][0][1] * z[0][2][1] + (t31 + z[0][0][1] * z[1][2][1]));
        let t33 = z[0][1][2] * z[1][1][2];
        rows[0] = (t32
            + (t33 + z[1][0][2] * z[0][2][2] + (t33 + z[0][0][2] * z[1][2][2])))
            / 150000000000.0;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): their third time derivative.
    ///
    /// Operations: 20 additions, 12 multiplications, 1 divisions.
    pub fn constraint_jerk_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[[::rncf::emitted::Vector; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..2];
        let t36 = z[1][1][0] * z[0][2][0];
        let t37 = z[0][1][0] * z[1][2][0];
        let t38 = t36 + t37;
        let t39 = z[1][1][1] * z[0][2][1];
        let t40 = z[0][1][1] * z[1][2][1];
        let t41 = t39 + t40;
        let t42 = t38 + (t36 + z[1][0][0] * z[0][3][0])
            + (t38 + (t37 + z[0][0][0] * z[1][3][0]))
            + (t41 + (t39 + z[1][0][1] * z[0][3][1])
                + (t41 + (t40 + z[0][0][1] * z[1][3][1])));
        let t43 = z[1][1][2] * z[0][2][2];
        let t44 = z[0][1][2] * z[1][2][2];
        let t45 = t43 + t44;
        let t46 = (t42
            + (t45 + (t43 + z[1][0][2] * z[0][3][2])
                + (t45 + (t44 + z[0][0][2] * z[1][3][2])))) / 150000000000.0;
        rows[0] = t46;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications, 6 divisions.
    pub fn constraint_gradient_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..2];
        gradient[0] = z[1][0] / 150000000000.0;
        gradient[1] = z[1][1] / 150000000000.0;
        gradient[2] = z[1][2] / 150000000000.0;
        gradient[3] = z[0][0] / 150000000000.0;
        gradient[4] = z[0][1] / 150000000000.0;
        gradient[5] = z[0][2] / 150000000000.0;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications, 6 divisions.
    pub fn constraint_rate_gradient_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let z = &z[..2];
        let velocity = &velocity[..2];
        gradient[0] = velocity[1][0] / 150000000000.0;
        gradient[1] = velocity[1][1] / 150000000000.0;
        gradient[2] = velocity[1][2] / 150000000000.0;
        gradient[3] = velocity[0][0] / 150000000000.0;
        gradient[4] = velocity[0][1] / 150000000000.0;
        gradient[5] = velocity[0][2] / 150000000000.0;
    }
    /// Constraint `sun_x` (constraint), `sun_y` (constraint): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 1 multiplications.
    pub fn constraint_hessian_sun_x(
        model: &EsailSlack,
        t: f64,
        z: &[::rncf::emitted::Vector],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..2];
        let lambda = &lambda[..1];
        let t13 = lambda[0] * 6.666666666666666e-12;
        hessian[18] = t13;
        hessian[3] = t13;
        hessian[25] = t13;
        hessian[10] = t13;
        hessian[32] = t13;
        hessian[17] = t13;
    }
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_0(
        model: &EsailSlack,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_1(
        model: &EsailSlack,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_2(
        model: &EsailSlack,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_3(
        model: &EsailSlack,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_4(
        model: &EsailSlack,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 5 additions, 6 multiplications, 1 divisions, 1 function calls.
    pub fn outputs(model: &EsailSlack, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = (observed[0] * observed[0] + observed[1] * observed[1]
            + observed[2] * observed[2])
            .sqrt() - 150000000000.0;
        out[1] = observed[11];
        out[2] = observed[12];
        out[3] = (observed[3] * observed[4] + observed[5] * observed[6]
            + observed[7] * observed[8]) / 0.017453292519943295;
        out[4] = observed[13];
        out[5] = observed[14];
        out[6] = observed[15];
        out[7] = observed[9];
        out[8] = observed[10];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &EsailSlack, run: &mut ::rncf::RunDefaults) {
        run.t_end = 200.0;
        run.every = 1.0;
    }
    /// Load per length `thrust`: writes what it depends on along the whole body.
    ///
    /// Of `thrust`: `z[0]` a point of `sail`; `z[1]` a direction of `sail`; `z[2]` a point of `inertial`; `z[3]` a direction of `sail`; `z[4]` a direction of `sail` (inertial axes).
    ///
    /// Operations: 13 additions, 14 multiplications, 1 divisions.
    pub fn density_values_thrust(
        model: &EsailSlack,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        values: &mut [f64],
    ) {
        let t28 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0
            / (z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2]);
        let t29 = z[2][0] - z[0][0];
        let t30 = z[2][1] - z[0][1];
        let t31 = z[2][2] - z[0][2];
        values[0] = z[1][0] * t29 + z[1][1] * t30 + z[1][2] * t31;
        values[1] = z[3][0] * t29 + z[3][1] * t30 + z[3][2] * t31;
        values[2] = z[4][0] * t29 + z[4][1] * t30 + z[4][2] * t31;
        values[3] = t28;
    }
    /// Load per length `thrust`: writes the derivatives of its values with respect to z, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 7 additions, 11 multiplications, 4 divisions.
    pub fn density_gradient_thrust(
        model: &EsailSlack,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let t28 = z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2];
        let t29 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0 / t28;
        let t30 = z[2][0] - z[0][0];
        let t31 = z[2][1] - z[0][1];
        let t32 = z[2][2] - z[0][2];
        gradient[0] = -z[1][0];
        gradient[1] = -z[1][1];
        gradient[2] = -z[1][2];
        gradient[3] = t30;
        gradient[4] = t31;
        gradient[5] = t32;
        gradient[6] = z[1][0];
        gradient[7] = z[1][1];
        gradient[8] = z[1][2];
        gradient[15] = -z[3][0];
        gradient[16] = -z[3][1];
        gradient[17] = -z[3][2];
        gradient[21] = z[3][0];
        gradient[22] = z[3][1];
        gradient[23] = z[3][2];
        gradient[24] = t30;
        gradient[25] = t31;
        gradient[26] = t32;
        gradient[30] = -z[4][0];
        gradient[31] = -z[4][1];
        gradient[32] = -z[4][2];
        gradient[36] = z[4][0];
        gradient[37] = z[4][1];
        gradient[38] = z[4][2];
        gradient[42] = t30;
        gradient[43] = t31;
        gradient[44] = t32;
        gradient[45] = -t29 * (z[0][0] * 2.0) / t28;
        gradient[46] = -t29 * (z[0][1] * 2.0) / t28;
        gradient[47] = -t29 * (z[0][2] * 2.0) / t28;
    }
    /// Load per length `thrust`: adds the generalised forces on the nodal vectors of one element, int s_a f dx, axes of the body's frame.
    ///
    /// Integrated exactly by constant tensors.
    ///
    /// The form is the cheaper one; weighted operations of force and tangent together: constant tensors 1896, points 1979.
    ///
    /// Operations: 123 additions, 165 multiplications, 3 divisions.
    #[inline(always)]
    pub fn density_force_thrust<T: ::rncf::emitted::lanes::Real>(
        length: &[T; 1],
        values: &[T; 4],
        q: &[T; 12],
        force: &mut [T::Cell; 12],
    ) {
        let [length] = *length;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let t29 = (r1_x - r0_x) / length;
        let t30 = (r1_y - r0_y) / length;
        let t31 = (r1_z - r0_z) / length;
        let t32 = s0_x * s0_x + s0_y * s0_y + s0_z * s0_z;
        let t33 = values[0] * s0_x + values[1] * s0_y + values[2] * s0_z;
        let t34 = s0_x * t33 - values[0] * t32;
        let t35 = s0_y * t33 - values[1] * t32;
        let t36 = s0_z * t33 - values[2] * t32;
        let t37 = values[0] * t29 + values[1] * t30 + values[2] * t31;
        let t38 = s0_x * 2.0;
        let t39 = s0_y * 2.0;
        let t40 = s0_z * 2.0;
        let t41 = t29 * t38 + t30 * t39 + t31 * t40;
        let t42 = t29 * t33 + s0_x * t37 - values[0] * t41;
        let t43 = t30 * t33 + s0_y * t37 - values[1] * t41;
        let t44 = t31 * t33 + s0_z * t37 - values[2] * t41;
        let t45 = values[0] * s1_x + values[1] * s1_y + values[2] * s1_z;
        let t46 = s1_x * t38 + s1_y * t39 + s1_z * t40;
        let t47 = s1_x * t33 + s0_x * t45 - values[0] * t46;
        let t48 = s1_y * t33 + s0_y * t45 - values[1] * t46;
        let t49 = s1_z * t33 + s0_z * t45 - values[2] * t46;
        let t50 = t29 * t29 + t30 * t30 + t31 * t31;
        let t51 = t29 * t37 - values[0] * t50;
        let t52 = t30 * t37 - values[1] * t50;
        let t53 = t31 * t37 - values[2] * t50;
        let t54 = s1_x * (t29 * 2.0) + s1_y * (t30 * 2.0) + s1_z * (t31 * 2.0);
        let t55 = s1_x * t37 + t29 * t45 - values[0] * t54;
        let t56 = s1_y * t37 + t30 * t45 - values[1] * t54;
        let t57 = s1_z * t37 + t31 * t45 - values[2] * t54;
        let t58 = s1_x * s1_x + s1_y * s1_y + s1_z * s1_z;
        let t59 = s1_x * t45 - values[0] * t58;
        let t60 = s1_y * t45 - values[1] * t58;
        let t61 = s1_z * t45 - values[2] * t58;
        let t62 = t34 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t51 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t63 = t35 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t48 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t52 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t56 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t64 = t36 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t49 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t65 = t34 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t47 * (-0.016666666666666666)
            + t51 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t66 = t35 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t48 * (-0.016666666666666666)
            + t52 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t56 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t67 = t36 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t49 * (-0.016666666666666666)
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t68 = t65 + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t69 = t66 + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t70 = t67 + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t71 = t34 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t51 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t72 = t35 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t48 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t52 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t56 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t73 = t36 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t49 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t74 = t34 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t42 * (-0.1)
            + t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t51 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t55 * (-0.1);
        let t75 = t35 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t43 * (-0.1)
            + t48 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t52 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t56 * (-0.1);
        let t76 = t36 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t44 * (-0.1)
            + t49 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t57 * (-0.1);
        let t77 = values[3] * (length * length);
        let t78 = values[3] * length;
        force[0] += (t74 + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t68) * t78;
        force[1] += (t75 + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t69) * t78;
        force[2] += (t76 + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t70) * t78;
        force[3] += (t62 + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t77;
        force[4] += (t63 + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t77;
        force[5] += (t64 + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t77;
        force[6] += t68 * t78;
        force[7] += t69 * t78;
        force[8] += t70 * t78;
        force[9] += (t71 + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t77;
        force[10] += (t72 + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t77;
        force[11] += (t73 + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t77;
    }
    /// [`density_force_thrust`] of four elements side by side.
    pub struct DensityForceThrust<'a> {
        pub length: &'a [[f64; 4]; 1],
        pub values: &'a [[f64; 4]; 4],
        pub q: &'a [[f64; 4]; 12],
        pub force: &'a mut [[f64; 4]; 12],
    }
    impl ::rncf::emitted::lanes::Kernel for DensityForceThrust<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { length, values, q, force } = self;
            let length = lanes.load_all(length);
            let values = lanes.load_all(values);
            let q = lanes.load_all(q);
            density_force_thrust(&length, &values, &q, force);
        }
    }
    /// Load per length `thrust`: adds the derivatives of the generalised forces with respect to q and to the values, rows first.
    ///
    /// Integrated exactly by constant tensors.
    ///
    /// The form is the cheaper one; weighted operations of force and tangent together: constant tensors 1896, points 1979.
    ///
    /// Operations: 744 additions, 840 multiplications, 3 divisions.
    #[inline(always)]
    pub fn density_tangent_thrust<T: ::rncf::emitted::lanes::Real>(
        length: &[T; 1],
        values: &[T; 4],
        q: &[T; 12],
        by_q: &mut [T::Cell; 144],
        by_values: &mut [T::Cell; 48],
    ) {
        let [length] = *length;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let t29 = (r1_x - r0_x) / length;
        let t30 = (r1_y - r0_y) / length;
        let t31 = (r1_z - r0_z) / length;
        let t32 = values[0] * s0_x;
        let t33 = values[1] * s0_y;
        let t34 = values[2] * s0_z;
        let t35 = t32 + t33 + t34;
        let t36 = s0_x * 2.0;
        let t37 = t32 + t35 - values[0] * t36;
        let t38 = s0_y * 2.0;
        let t39 = values[1] * s0_x - values[0] * t38;
        let t40 = s0_z * 2.0;
        let t41 = values[2] * s0_x - values[0] * t40;
        let t42 = values[0] * s0_y - values[1] * t36;
        let t43 = t33 + t35 - values[1] * t38;
        let t44 = values[2] * s0_y - values[1] * t40;
        let t45 = values[0] * s0_z - values[2] * t36;
        let t46 = values[1] * s0_z - values[2] * t38;
        let t47 = t34 + t35 - values[2] * t40;
        let t48 = values[0] * t29;
        let t49 = values[1] * t30;
        let t50 = values[2] * t31;
        let t51 = t48 + t49 + t50;
        let t52 = t29 * 2.0;
        let t53 = t48 + t51 - values[0] * t52;
        let t54 = t30 * 2.0;
        let t55 = values[1] * t29 - values[0] * t54;
        let t56 = t31 * 2.0;
        let t57 = values[2] * t29 - values[0] * t56;
        let t58 = values[0] * t30 - values[1] * t52;
        let t59 = t49 + t51 - values[1] * t54;
        let t60 = values[2] * t30 - values[1] * t56;
        let t61 = values[0] * t31 - values[2] * t52;
        let t62 = values[1] * t31 - values[2] * t54;
        let t63 = t50 + t51 - values[2] * t56;
        let t64 = values[0] * s1_x;
        let t65 = values[1] * s1_y;
        let t66 = values[2] * s1_z;
        let t67 = t64 + t65 + t66;
        let t68 = s1_x * 2.0;
        let t69 = t64 + t67 - values[0] * t68;
        let t70 = s1_y * 2.0;
        let t71 = values[1] * s1_x - values[0] * t70;
        let t72 = s1_z * 2.0;
        let t73 = values[2] * s1_x - values[0] * t72;
        let t74 = values[0] * s1_y - values[1] * t68;
        let t75 = t65 + t67 - values[1] * t70;
        let t76 = values[2] * s1_y - values[1] * t72;
        let t77 = values[0] * s1_z - values[2] * t68;
        let t78 = values[1] * s1_z - values[2] * t70;
        let t79 = t66 + t67 - values[2] * t72;
        let t80 = t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t69 * (-0.016666666666666666);
        let t81 = t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t74 * (-0.016666666666666666);
        let t82 = t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t77 * (-0.016666666666666666);
        let t83 = t53 * (-0.1);
        let t84 = t58 * (-0.1);
        let t85 = t61 * (-0.1);
        let t86 = t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t71 * (-0.016666666666666666);
        let t87 = t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t75 * (-0.016666666666666666);
        let t88 = t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t78 * (-0.016666666666666666);
        let t89 = t55 * (-0.1);
        let t90 = t59 * (-0.1);
        let t91 = t62 * (-0.1);
        let t92 = t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t73 * (-0.016666666666666666);
        let t93 = t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t76 * (-0.016666666666666666);
        let t94 = t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t79 * (-0.016666666666666666);
        let t95 = t57 * (-0.1);
        let t96 = t60 * (-0.1);
        let t97 = t63 * (-0.1);
        let t98 = t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t99 = t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t100 = t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t101 = t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t102 = t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t103 = t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t104 = t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t105 = t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t106 = t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t107 = t37 * (-0.016666666666666666)
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t108 = t42 * (-0.016666666666666666)
            + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t109 = t45 * (-0.016666666666666666)
            + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t110 = t39 * (-0.016666666666666666)
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t111 = t43 * (-0.016666666666666666)
            + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t112 = t46 * (-0.016666666666666666)
            + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t113 = t41 * (-0.016666666666666666)
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t114 = t44 * (-0.016666666666666666)
            + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t115 = t47 * (-0.016666666666666666)
            + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4]
            + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t116 = length * length;
        let t117 = values[3] * t116;
        let t118 = values[3] * length;
        let t119 = (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t120 = (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t121 = (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t122 = values[3] * t98;
        let t123 = values[3] * t99;
        let t124 = values[3] * t100;
        let t125 = (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t126 = (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t127 = (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t128 = values[3]
            * (t37 * (-0.1) + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t69 * (-0.1)
                - t98);
        let t129 = values[3]
            * (t42 * (-0.1) + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t74 * (-0.1)
                - t99);
        let t130 = values[3]
            * (t45 * (-0.1) + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t77 * (-0.1)
                - t100);
        let t131 = (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t132 = (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t133 = (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t134 = values[3] * t101;
        let t135 = values[3] * t102;
        let t136 = values[3] * t103;
        let t137 = (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t138 = (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t139 = (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t140 = values[3]
            * (t39 * (-0.1) + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t71 * (-0.1)
                - t101);
        let t141 = values[3]
            * (t43 * (-0.1) + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t75 * (-0.1)
                - t102);
        let t142 = values[3]
            * (t46 * (-0.1) + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t78 * (-0.1)
                - t103);
        let t143 = (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t144 = (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t145 = (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]) * t118;
        let t146 = values[3] * t104;
        let t147 = values[3] * t105;
        let t148 = values[3] * t106;
        let t149 = (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t150 = (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t151 = (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]) * t118;
        let t152 = values[3]
            * (t41 * (-0.1) + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t73 * (-0.1)
                - t104);
        let t153 = values[3]
            * (t44 * (-0.1) + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t76 * (-0.1)
                - t105);
        let t154 = values[3]
            * (t47 * (-0.1) + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t79 * (-0.1)
                - t106);
        let t155 = s0_x * s0_x;
        let t156 = s0_y * s0_y;
        let t157 = s0_z * s0_z;
        let t158 = t155 + t156 + t157;
        let t159 = s0_x * t35 - values[0] * t158;
        let t160 = s0_y * t35 - values[1] * t158;
        let t161 = s0_z * t35 - values[2] * t158;
        let t162 = t29 * t36 + t30 * t38 + t31 * t40;
        let t163 = t29 * t35 + s0_x * t51 - values[0] * t162;
        let t164 = t30 * t35 + s0_y * t51 - values[1] * t162;
        let t165 = t31 * t35 + s0_z * t51 - values[2] * t162;
        let t166 = s1_x * t36 + s1_y * t38 + s1_z * t40;
        let t167 = s1_x * t35 + s0_x * t67 - values[0] * t166;
        let t168 = s1_y * t35 + s0_y * t67 - values[1] * t166;
        let t169 = s1_z * t35 + s0_z * t67 - values[2] * t166;
        let t170 = t29 * t29;
        let t171 = t30 * t30;
        let t172 = t31 * t31;
        let t173 = t170 + t171 + t172;
        let t174 = t29 * t51 - values[0] * t173;
        let t175 = t30 * t51 - values[1] * t173;
        let t176 = t31 * t51 - values[2] * t173;
        let t177 = s1_x * t52 + s1_y * t54 + s1_z * t56;
        let t178 = s1_x * t51 + t29 * t67 - values[0] * t177;
        let t179 = s1_y * t51 + t30 * t67 - values[1] * t177;
        let t180 = s1_z * t51 + t31 * t67 - values[2] * t177;
        let t181 = s1_x * s1_x;
        let t182 = s1_y * s1_y;
        let t183 = s1_z * s1_z;
        let t184 = t181 + t182 + t183;
        let t185 = s1_x * t67 - values[0] * t184;
        let t186 = s1_y * t67 - values[1] * t184;
        let t187 = s1_z * t67 - values[2] * t184;
        let t188 = t159 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t163 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t167 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t174 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t178 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t189 = t160 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t164 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t168 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t175 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t179 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t190 = t161 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t165 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t169 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t176 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t180 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t191 = t159 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t163 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t167 * (-0.016666666666666666)
            + t174 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t178 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t192 = t160 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t164 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t168 * (-0.016666666666666666)
            + t175 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t179 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t193 = t161 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t165 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t169 * (-0.016666666666666666)
            + t176 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t180 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t194 = t191 + t185 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t195 = t192 + t186 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t196 = t193 + t187 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t197 = t159 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t163 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t167 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t174 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t178 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t198 = t160 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t164 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t168 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t175 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t179 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t199 = t161 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t165 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t169 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t176 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t180 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t200 = t159 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t163 * (-0.1)
            + t167 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t174 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t178 * (-0.1);
        let t201 = t160 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t164 * (-0.1)
            + t168 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t175 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t179 * (-0.1);
        let t202 = t161 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t165 * (-0.1)
            + t169 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t176 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t180 * (-0.1);
        let t203 = t155 - t158;
        let t204 = s0_x * t29;
        let t205 = t204 + t204 - t162;
        let t206 = s0_x * s1_x;
        let t207 = t206 + t206 - t166;
        let t208 = t170 - t173;
        let t209 = s1_x * t29;
        let t210 = t209 + t209 - t177;
        let t211 = t181 - t184;
        let t212 = t203 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t205 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t207 * (-0.016666666666666666)
            + t208 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t210 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t213 = t212 + t211 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t214 = t203 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t205 * (-0.1)
            + t207 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t208 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t210 * (-0.1);
        let t215 = s0_x * s0_y;
        let t216 = s0_y * t29 + s0_x * t30;
        let t217 = s0_y * s1_x + s0_x * s1_y;
        let t218 = t29 * t30;
        let t219 = s1_x * t30 + s1_y * t29;
        let t220 = s1_x * s1_y;
        let t221 = t215 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t216 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t217 * (-0.016666666666666666)
            + t218 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t219 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t222 = t221 + t220 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t223 = t215 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t216 * (-0.1)
            + t217 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t218 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t219 * (-0.1);
        let t224 = t118 * (t223 + t220 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t222);
        let t225 = s0_x * s0_z;
        let t226 = s0_z * t29 + s0_x * t31;
        let t227 = s0_z * s1_x + s0_x * s1_z;
        let t228 = t29 * t31;
        let t229 = s1_x * t31 + s1_z * t29;
        let t230 = s1_x * s1_z;
        let t231 = t225 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t226 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t227 * (-0.016666666666666666)
            + t228 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t229 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t232 = t231 + t230 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t233 = t225 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t226 * (-0.1)
            + t227 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t228 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t229 * (-0.1);
        let t234 = t118 * (t233 + t230 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t232);
        let t235 = t156 - t158;
        let t236 = s0_y * t30;
        let t237 = t236 + t236 - t162;
        let t238 = s0_y * s1_y;
        let t239 = t238 + t238 - t166;
        let t240 = t171 - t173;
        let t241 = s1_y * t30;
        let t242 = t241 + t241 - t177;
        let t243 = t182 - t184;
        let t244 = t235 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t237 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t239 * (-0.016666666666666666)
            + t240 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t242 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t245 = t244 + t243 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t246 = t235 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t237 * (-0.1)
            + t239 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t240 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t242 * (-0.1);
        let t247 = s0_y * s0_z;
        let t248 = s0_z * t30 + s0_y * t31;
        let t249 = s0_z * s1_y + s0_y * s1_z;
        let t250 = t30 * t31;
        let t251 = s1_y * t31 + s1_z * t30;
        let t252 = s1_y * s1_z;
        let t253 = t247 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t248 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t249 * (-0.016666666666666666)
            + t250 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t251 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t254 = t253 + t252 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t255 = t247 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t248 * (-0.1)
            + t249 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t250 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t251 * (-0.1);
        let t256 = t118 * (t255 + t252 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t254);
        let t257 = t157 - t158;
        let t258 = s0_z * t31;
        let t259 = t258 + t258 - t162;
        let t260 = s0_z * s1_z;
        let t261 = t260 + t260 - t166;
        let t262 = t172 - t173;
        let t263 = s1_z * t31;
        let t264 = t263 + t263 - t177;
        let t265 = t183 - t184;
        let t266 = t257 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][0]
            + t259 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][1]
            + t261 * (-0.016666666666666666)
            + t262 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][3]
            + t264 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][4];
        let t267 = t266 + t265 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[1][5];
        let t268 = t257 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t259 * (-0.1)
            + t261 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
            + t262 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][3] + t264 * (-0.1);
        let t269 = t203 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t205 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t207 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t208 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t210 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t270 = t215 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t216 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t217 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t218 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t219 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t271 = t117 * (t270 + t220 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        let t272 = t225 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t226 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t227 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t228 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t229 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t273 = t117 * (t272 + t230 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        let t274 = t235 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t237 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t239 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t240 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t242 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t275 = t247 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t248 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t249 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t250 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t251 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t276 = t117 * (t275 + t252 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        let t277 = t257 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
            + t259 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
            + t261 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
            + t262 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][3]
            + t264 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4];
        let t278 = t118 * t222;
        let t279 = t118 * t232;
        let t280 = t118 * t254;
        let t281 = t203 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t205 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t207 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t208 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t210 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t282 = t215 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t216 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t217 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t218 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t219 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t283 = t117 * (t282 + t220 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        let t284 = t225 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t226 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t227 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t228 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t229 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t285 = t117 * (t284 + t230 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        let t286 = t235 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t237 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t239 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t240 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t242 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t287 = t247 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t248 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t249 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t250 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t251 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        let t288 = t117 * (t287 + t252 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        let t289 = t257 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
            + t259 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
            + t261 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
            + t262 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][3]
            + t264 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4];
        by_q[0] -= t128;
        by_q[1] -= t140;
        by_q[2] -= t152;
        by_q[3]
            += (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t83
                + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t80) * t118;
        by_q[4]
            += t118
                * (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t89
                    + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t86);
        by_q[5]
            += t118
                * (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t95
                    + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t92);
        by_q[6] += t128;
        by_q[7] += t140;
        by_q[8] += t152;
        by_q[9]
            += t118
                * (t83 + t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t107);
        by_q[10]
            += t118
                * (t89 + t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t110);
        by_q[11]
            += t118
                * (t95 + t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t113);
        by_q[12] -= t129;
        by_q[13] -= t141;
        by_q[14] -= t153;
        by_q[15]
            += (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t84
                + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t81) * t118;
        by_q[16]
            += t118
                * (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t90
                    + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t87);
        by_q[17]
            += t118
                * (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t96
                    + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t93);
        by_q[18] += t129;
        by_q[19] += t141;
        by_q[20] += t153;
        by_q[21]
            += t118
                * (t84 + t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t108);
        by_q[22]
            += t118
                * (t90 + t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t111);
        by_q[23]
            += t118
                * (t96 + t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t114);
        by_q[24] -= t130;
        by_q[25] -= t142;
        by_q[26] -= t154;
        by_q[27]
            += (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t85
                + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t82) * t118;
        by_q[28]
            += t118
                * (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t91
                    + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t88);
        by_q[29]
            += t118
                * (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] + t97
                    + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2] - t94);
        by_q[30] += t130;
        by_q[31] += t142;
        by_q[32] += t154;
        by_q[33]
            += t118
                * (t85 + t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t109);
        by_q[34]
            += t118
                * (t91 + t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t112);
        by_q[35]
            += t118
                * (t97 + t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][2]
                    + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t115);
        by_q[36] -= t119;
        by_q[37] -= t131;
        by_q[38] -= t143;
        by_q[39]
            += (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[40]
            += (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[41]
            += (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[42] += t119;
        by_q[43] += t131;
        by_q[44] += t143;
        by_q[45]
            += (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[46]
            += (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[47]
            += (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[48] -= t120;
        by_q[49] -= t132;
        by_q[50] -= t144;
        by_q[51]
            += (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[52]
            += (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[53]
            += (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[54] += t120;
        by_q[55] += t132;
        by_q[56] += t144;
        by_q[57]
            += (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[58]
            += (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[59]
            += (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[60] -= t121;
        by_q[61] -= t133;
        by_q[62] -= t145;
        by_q[63]
            += (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[64]
            += (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[65]
            += (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][0]
                + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][1]
                + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]) * t117;
        by_q[66] += t121;
        by_q[67] += t133;
        by_q[68] += t145;
        by_q[69]
            += (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[70]
            += (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[71]
            += (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][2]
                + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][4]
                + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]) * t117;
        by_q[72] -= t122;
        by_q[73] -= t134;
        by_q[74] -= t146;
        by_q[75] += t80 * t118;
        by_q[76] += t86 * t118;
        by_q[77] += t92 * t118;
        by_q[78] += t122;
        by_q[79] += t134;
        by_q[80] += t146;
        by_q[81] += t107 * t118;
        by_q[82] += t110 * t118;
        by_q[83] += t113 * t118;
        by_q[84] -= t123;
        by_q[85] -= t135;
        by_q[86] -= t147;
        by_q[87] += t81 * t118;
        by_q[88] += t87 * t118;
        by_q[89] += t93 * t118;
        by_q[90] += t123;
        by_q[91] += t135;
        by_q[92] += t147;
        by_q[93] += t108 * t118;
        by_q[94] += t111 * t118;
        by_q[95] += t114 * t118;
        by_q[96] -= t124;
        by_q[97] -= t136;
        by_q[98] -= t148;
        by_q[99] += t82 * t118;
        by_q[100] += t88 * t118;
        by_q[101] += t94 * t118;
        by_q[102] += t124;
        by_q[103] += t136;
        by_q[104] += t148;
        by_q[105] += t109 * t118;
        by_q[106] += t112 * t118;
        by_q[107] += t115 * t118;
        by_q[108] -= t125;
        by_q[109] -= t137;
        by_q[110] -= t149;
        by_q[111]
            += (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[112]
            += (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[113]
            += (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[114] += t125;
        by_q[115] += t137;
        by_q[116] += t149;
        by_q[117]
            += (t37 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t53 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t69 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[118]
            += (t39 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t55 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t71 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[119]
            += (t41 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t57 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t73 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[120] -= t126;
        by_q[121] -= t138;
        by_q[122] -= t150;
        by_q[123]
            += (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[124]
            += (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[125]
            += (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[126] += t126;
        by_q[127] += t138;
        by_q[128] += t150;
        by_q[129]
            += (t42 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t58 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t74 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[130]
            += (t43 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t59 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t75 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[131]
            += (t44 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t60 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t76 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[132] -= t127;
        by_q[133] -= t139;
        by_q[134] -= t151;
        by_q[135]
            += (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[136]
            += (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[137]
            += (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][0]
                + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][1]
                + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]) * t117;
        by_q[138] += t127;
        by_q[139] += t139;
        by_q[140] += t151;
        by_q[141]
            += (t45 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t61 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t77 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[142]
            += (t46 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t62 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t78 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_q[143]
            += (t47 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][2]
                + t63 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][4]
                + t79 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]) * t117;
        by_values[0]
            += t118 * (t214 + t211 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t213);
        by_values[1] += t224;
        by_values[2] += t234;
        by_values[3]
            += length * (t200 + t185 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t194);
        by_values[4] += t224;
        by_values[5]
            += t118 * (t246 + t243 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t245);
        by_values[6] += t256;
        by_values[7]
            += length * (t201 + t186 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t195);
        by_values[8] += t234;
        by_values[9] += t256;
        by_values[10]
            += t118 * (t268 + t265 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t267);
        by_values[11]
            += length * (t202 + t187 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[3][0] - t196);
        by_values[12] += t117 * (t269 + t211 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[13] += t271;
        by_values[14] += t273;
        by_values[15] += t116 * (t188 + t185 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[16] += t271;
        by_values[17] += t117 * (t274 + t243 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[18] += t276;
        by_values[19] += t116 * (t189 + t186 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[20] += t273;
        by_values[21] += t276;
        by_values[22] += t117 * (t277 + t265 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[23] += t116 * (t190 + t187 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[0][5]);
        by_values[24] += t118 * t213;
        by_values[25] += t278;
        by_values[26] += t279;
        by_values[27] += length * t194;
        by_values[28] += t278;
        by_values[29] += t118 * t245;
        by_values[30] += t280;
        by_values[31] += length * t195;
        by_values[32] += t279;
        by_values[33] += t280;
        by_values[34] += t118 * t267;
        by_values[35] += length * t196;
        by_values[36] += t117 * (t281 + t211 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        by_values[37] += t283;
        by_values[38] += t285;
        by_values[39] += t116 * (t197 + t185 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        by_values[40] += t283;
        by_values[41] += t117 * (t286 + t243 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        by_values[42] += t288;
        by_values[43] += t116 * (t198 + t186 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        by_values[44] += t285;
        by_values[45] += t288;
        by_values[46] += t117 * (t289 + t265 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
        by_values[47] += t116 * (t199 + t187 * CABLE_SPATIAL_SLACK_DENSITY_IOTA[2][5]);
    }
    /// [`density_tangent_thrust`] of four elements side by side.
    pub struct DensityTangentThrust<'a> {
        pub length: &'a [[f64; 4]; 1],
        pub values: &'a [[f64; 4]; 4],
        pub q: &'a [[f64; 4]; 12],
        pub by_q: &'a mut [[f64; 4]; 144],
        pub by_values: &'a mut [[f64; 4]; 48],
    }
    impl ::rncf::emitted::lanes::Kernel for DensityTangentThrust<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { length, values, q, by_q, by_values } = self;
            let length = lanes.load_all(length);
            let values = lanes.load_all(values);
            let q = lanes.load_all(q);
            density_tangent_thrust(&length, &values, &q, by_q, by_values);
        }
    }
    /// Gravity field `sun`: g(z, t), m/s^2, inertial axes.
    ///
    /// Of `sun`: `z[0]` a point of `sail` (inertial axes).
    ///
    /// Operations: 2 additions, 8 multiplications, 3 divisions, 1 function calls.
    pub fn field_sun(
        model: &EsailSlack,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gravity: &mut [f64; 3],
    ) {
        let t15 = (z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2])
            .sqrt()
            .powi(3);
        gravity[0] = z[0][0] * (-1.33425e20) / t15;
        gravity[1] = z[0][1] * (-1.33425e20) / t15;
        gravity[2] = z[0][2] * (-1.33425e20) / t15;
    }
    /// Gravity field `sun`: writes dg/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 5 additions, 29 multiplications, 13 divisions, 1 function calls.
    pub fn field_gradient_sun(
        model: &EsailSlack,
        t: f64,
        z: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let t15 = (z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2]).sqrt();
        let t16 = t15 * t15 * t15;
        let t17 = z[0][0] * (-1.33425e20) / t16;
        let t18 = z[0][1] * (-1.33425e20) / t16;
        let t19 = z[0][2] * (-1.33425e20) / t16;
        let t20 = 1.0 / (2.0 * t15);
        let t21 = 3.0 * (t15 * t15);
        let t22 = z[0][0] * 2.0 * t20 * t21;
        let t23 = t21 * (z[0][1] * 2.0 * t20);
        let t24 = t21 * (z[0][2] * 2.0 * t20);
        gradient[0] = (-1.33425e20 - t17 * t22) / t16;
        gradient[1] = -t17 * t23 / t16;
        gradient[2] = -t17 * t24 / t16;
        gradient[3] = -t18 * t22 / t16;
        gradient[4] = (-1.33425e20 - t18 * t23) / t16;
        gradient[5] = -t18 * t24 / t16;
        gradient[6] = -t19 * t22 / t16;
        gradient[7] = -t19 * t23 / t16;
        gradient[8] = (-1.33425e20 - t19 * t24) / t16;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: EsailSlack,
        /// How often each loop is gone through.
        pub counts: [usize; 1],
        /// Number of the first repetition of every body.
        pub firsts: [usize; 2],
        /// Number of the first repetition of every joint.
        pub first_joints: [usize; 1],
        pub row_main: ::std::vec::Vec<CableSpatialSlack>,
        pub row_aux: ::std::vec::Vec<CableSpatialSlack>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &EsailSlack) -> Self {
            let counts = [model.tethers];
            Self {
                model: model.clone(),
                counts,
                firsts: ::rncf::emitted::firsts([counts[0], counts[0]]),
                first_joints: ::rncf::emitted::firsts([counts[0]]),
                row_main: Default::default(),
                row_aux: Default::default(),
            }
        }
        /// Declaration of a body, and number of the repetition.
        pub fn kind(&self, body: usize) -> (usize, usize) {
            let declaration = self.firsts.partition_point(|&first| first <= body) - 1;
            (declaration, body - self.firsts[declaration])
        }
        /// Number of the first repetition of a declared body.
        pub fn first(&self, declaration: usize) -> usize {
            self.firsts[declaration]
        }
        /// Declaration of a joint.
        pub fn joint_kind(&self, joint: usize) -> usize {
            self.first_joints.partition_point(|&first| first <= joint) - 1
        }
    }
    impl ::rncf::emitted::Parts for Equations {
        fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 0,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 1,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 1,
                    derivative: 0,
                    component: 2,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 4,
                    derivative: 0,
                    component: 0,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 1,
                    component: 0,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 4,
                    derivative: 0,
                    component: 1,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 1,
                    component: 1,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 4,
                    derivative: 0,
                    component: 2,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 5,
                    derivative: 1,
                    component: 2,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Multiplier {
                    constraint: 0,
                    row: 0,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Multiplier {
                    constraint: 1,
                    row: 0,
                });
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ObservedSpec::Point {
                        body: ::rncf::emitted::instance(
                            self.first(0),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::End,
                        what: ::rncf::emitted::PointQuantity::Position,
                        component: 2,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ObservedSpec::Point {
                        body: ::rncf::emitted::instance(
                            self.first(0),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::End,
                        what: ::rncf::emitted::PointQuantity::Position,
                        component: 2,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ObservedSpec::Section {
                        body: ::rncf::emitted::instance(
                            self.first(0),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::Start,
                        what: ::rncf::emitted::SectionQuantity::AxialForce,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ObservedSpec::Section {
                        body: ::rncf::emitted::instance(
                            self.first(1),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::At(
                            3.141592653589793 * (model.length + model.hub_radius)
                                / (model.tethers as f64),
                        ),
                        what: ::rncf::emitted::SectionQuantity::AxialForce,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ObservedSpec::Section {
                        body: ::rncf::emitted::instance(
                            self.first(1),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::At(
                            3.141592653589793 * (model.length + model.hub_radius)
                                / (model.tethers as f64),
                        ),
                        what: ::rncf::emitted::SectionQuantity::AxialForce,
                    });
            }
            specs
        }
        fn output_columns(&self) -> usize {
            9
        }
        fn frame_count(&self) -> usize {
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "sail"][frame]
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
            let model = &self.model;
            let (plain, mut rest) = observed.split_at(11);
            let mut seen = [0.0; 16];
            seen[..11].copy_from_slice(plain);
            seen[11] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Min,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_0(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            seen[12] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Max,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_1(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            seen[13] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Max,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_2(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            seen[14] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Min,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_3(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            seen[15] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Max,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_4(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            outputs(model, t, &seen, out);
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("the load per length `thrust` has no potential")
        }
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            ::rncf::emitted::repetitions("a", (model.tethers as f64))?;
            ::rncf::emitted::non_negative(
                "fixture `core`",
                "mass",
                model.core_mass,
                "kg",
            )?;
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                ::rncf::emitted::non_negative(
                    "fixture `remote`",
                    "mass",
                    model.remote_mass * (1.0 + model.asymmetry * (index * index).cos()),
                    "kg",
                )?;
            }
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
            free_sail(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::emitted::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 1,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 1,
                    along: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Turn {
                    frame: 1,
                },
            ])
        }
    }
    impl ::rncf::emitted::Bodies for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::emitted::BodySpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::BodySpec {
                        name: "main",
                        kind: 0,
                        instance: Some(instance),
                        frame: 1,
                        axes: &[0, 1, 2],
                        line: ::rncf::emitted::Line::Straight {
                            from: [
                                model.hub_radius
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .cos(),
                                model.hub_radius
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .sin(),
                                0.0,
                            ],
                            to: [
                                (model.length + model.hub_radius)
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .cos(),
                                (model.length + model.hub_radius)
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .sin(),
                                0.0,
                            ],
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
                        tie: ::rncf::emitted::FrameTie::Joints,
                        normals: ::std::vec::Vec::new(),
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::BodySpec {
                        name: "aux",
                        kind: 1,
                        instance: Some(instance),
                        frame: 1,
                        axes: &[0, 1, 2],
                        line: ::rncf::emitted::Line::Straight {
                            from: [0.0, 0.0, 0.0],
                            to: [
                                6.283185307179586 * (model.length + model.hub_radius)
                                    / (model.tethers as f64),
                                0.0,
                                0.0,
                            ],
                        },
                        count: 1,
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
                        tie: ::rncf::emitted::FrameTie::Joints,
                        normals: ::std::vec::Vec::new(),
                    });
            }
            specs
        }
        fn prepare(
            &mut self,
            body: usize,
            nodes: &[f64],
            shape: &[f64],
        ) -> ::std::result::Result<(), ::rncf::ModelError> {
            let (body, instance) = self.kind(body);
            let model = &self.model;
            match body {
                0 => {
                    let length = nodes[1] - nodes[0];
                    let density = ::rncf::emitted::positive(
                        "material `aluminium`",
                        "density",
                        2700.0,
                        "kg/m^3",
                    )?;
                    let young = ::rncf::emitted::positive(
                        "material `aluminium`",
                        "young",
                        70000000000.0,
                        "Pa",
                    )?;
                    let area = ::rncf::emitted::positive(
                        "section `wire`",
                        "area",
                        4.571428571428571e-9,
                        "m^2",
                    )?;
                    let second_moment = ::rncf::emitted::positive(
                        "section `wire`",
                        "second_moment",
                        1.663e-18,
                        "m^4",
                    )?;
                    let row = CableSpatialSlack {
                        length,
                        EA: young * area,
                        EI: young * second_moment,
                        rhoA: density * area,
                    };
                    self.row_main.truncate(instance);
                    self.row_main.push(row);
                }
                _ => {
                    let length = nodes[1] - nodes[0];
                    let density = ::rncf::emitted::positive(
                        "material `aluminium`",
                        "density",
                        2700.0,
                        "kg/m^3",
                    )?;
                    let young = ::rncf::emitted::positive(
                        "material `aluminium`",
                        "young",
                        70000000000.0,
                        "Pa",
                    )?;
                    let area = ::rncf::emitted::positive(
                        "section `wire`",
                        "area",
                        4.571428571428571e-9,
                        "m^2",
                    )?;
                    let second_moment = ::rncf::emitted::positive(
                        "section `wire`",
                        "second_moment",
                        1.663e-18,
                        "m^4",
                    )?;
                    let row = CableSpatialSlack {
                        length,
                        EA: young * area,
                        EI: young * second_moment,
                        rhoA: density * area,
                    };
                    self.row_aux.truncate(instance);
                    self.row_aux.push(row);
                }
            }
            Ok(())
        }
        fn initial(
            &self,
            body: usize,
            x: f64,
        ) -> [::std::option::Option<[[f64; 3]; 2]>; 2] {
            let (body, instance) = self.kind(body);
            let mut position = [[0.0; 3]; 2];
            let mut velocity = [[0.0; 3]; 2];
            match body {
                1 => {
                    initial_aux(
                        &self.model,
                        x,
                        instance as f64,
                        &mut position,
                        &mut velocity,
                    );
                    [Some(position), None]
                }
                _ => [None, None],
            }
        }
        fn shares(&self) -> ::std::vec::Vec<::rncf::emitted::ShareSpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ShareSpec {
                        name: "near",
                        ends: [
                            (
                                ::rncf::emitted::instance(
                                    self.first(1),
                                    self.counts[0],
                                    index,
                                ),
                                false,
                            ),
                            (
                                ::rncf::emitted::instance(
                                    self.first(0),
                                    self.counts[0],
                                    index,
                                ),
                                true,
                            ),
                        ],
                        smooth: false,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ShareSpec {
                        name: "far",
                        ends: [
                            (
                                ::rncf::emitted::instance(
                                    self.first(1),
                                    self.counts[0],
                                    index,
                                ),
                                true,
                            ),
                            (
                                ::rncf::emitted::instance(
                                    self.first(0),
                                    self.counts[0],
                                    (index + 1.0).rem_euclid((model.tethers as f64)),
                                ),
                                true,
                            ),
                        ],
                        smooth: false,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::ShareSpec {
                        name: "ring",
                        ends: [
                            (
                                ::rncf::emitted::instance(
                                    self.first(1),
                                    self.counts[0],
                                    index,
                                ),
                                true,
                            ),
                            (
                                ::rncf::emitted::instance(
                                    self.first(1),
                                    self.counts[0],
                                    (index + 1.0).rem_euclid((model.tethers as f64)),
                                ),
                                false,
                            ),
                        ],
                        smooth: true,
                    });
            }
            specs
        }
        fn starts(&self) -> ::std::vec::Vec<::rncf::emitted::StartSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::StartSpec {
                    name: "spun",
                    frame: 1,
                    spin: Some([0.0, 0.0, model.spin]),
                },
            ])
        }
        fn fixtures(&self) -> ::std::vec::Vec<::rncf::emitted::FixtureSpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::FixtureSpec {
                        name: "remote",
                        body: ::rncf::emitted::instance(
                            self.first(0),
                            self.counts[0],
                            index,
                        ),
                        at: ::rncf::emitted::Place::End,
                        constants: [
                            model.remote_mass
                                * (1.0 + model.asymmetry * (index * index).cos()),
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
                    });
            }
            specs
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
            let (body, instance) = self.kind(body);
            match body {
                0 => {
                    cable_spatial_slack_mass(
                        &self.row_main[instance],
                        ::rncf::emitted::array_mut(mass),
                    );
                }
                _ => {
                    cable_spatial_slack_mass(
                        &self.row_aux[instance],
                        ::rncf::emitted::array_mut(mass),
                    );
                }
            }
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            let (body, instance) = self.kind(body);
            match body {
                0 => {
                    cable_spatial_slack_elastic_force(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(force),
                    );
                }
                _ => {
                    cable_spatial_slack_elastic_force(
                        &self.row_aux[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(force),
                    );
                }
            }
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
            let (body, instance) = self.kind(body);
            match body {
                0 => {
                    cable_spatial_slack_elastic_tangent(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(stiffness),
                    );
                }
                _ => {
                    cable_spatial_slack_elastic_tangent(
                        &self.row_aux[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(stiffness),
                    );
                }
            }
        }
        fn elastic_force4(
            &self,
            elements: &[(usize, usize); 4],
            q: &[[f64; 4]],
            v: &[[f64; 4]],
            force: &mut [[f64; 4]],
        ) {
            let (body, _) = self.kind(elements[0].0);
            match body {
                0 => {
                    let four = CableSpatialSlackElasticForce {
                        rows: elements
                            .map(|(body, _)| &self.row_main[self.kind(body).1]),
                        q: ::rncf::emitted::array(q),
                        force: ::rncf::emitted::array_mut(force),
                    };
                    if !::rncf::emitted::lanes::run(four) {
                        ::rncf::emitted::elastic_force_one_by_one(
                            self,
                            elements,
                            q,
                            v,
                            force,
                        );
                    }
                }
                _ => {
                    let four = CableSpatialSlackElasticForce {
                        rows: elements.map(|(body, _)| &self.row_aux[self.kind(body).1]),
                        q: ::rncf::emitted::array(q),
                        force: ::rncf::emitted::array_mut(force),
                    };
                    if !::rncf::emitted::lanes::run(four) {
                        ::rncf::emitted::elastic_force_one_by_one(
                            self,
                            elements,
                            q,
                            v,
                            force,
                        );
                    }
                }
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
            let (body, _) = self.kind(elements[0].0);
            match body {
                0 => {
                    let four = CableSpatialSlackElasticTangent {
                        rows: elements
                            .map(|(body, _)| &self.row_main[self.kind(body).1]),
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
                _ => {
                    let four = CableSpatialSlackElasticTangent {
                        rows: elements.map(|(body, _)| &self.row_aux[self.kind(body).1]),
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
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let (body, instance) = self.kind(body);
            let mut energy = 0.0;
            match body {
                0 => {
                    cable_spatial_slack_strain_energy(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        &mut energy,
                    );
                }
                _ => {
                    cable_spatial_slack_strain_energy(
                        &self.row_aux[instance],
                        ::rncf::emitted::array(q),
                        &mut energy,
                    );
                }
            }
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
            let (body, instance) = self.kind(body);
            weights.fill(0.0);
            match body {
                0 => {
                    match (of, order) {
                        (::rncf::emitted::Interpolant::Position, 0) => {
                            cable_spatial_slack_shapes_position_0(
                                self.row_main[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 1) => {
                            cable_spatial_slack_shapes_position_1(
                                self.row_main[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 2) => {
                            cable_spatial_slack_shapes_position_2(
                                self.row_main[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        _ => {}
                    }
                }
                _ => {
                    match (of, order) {
                        (::rncf::emitted::Interpolant::Position, 0) => {
                            cable_spatial_slack_shapes_position_0(
                                self.row_aux[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 1) => {
                            cable_spatial_slack_shapes_position_1(
                                self.row_aux[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 2) => {
                            cable_spatial_slack_shapes_position_2(
                                self.row_aux[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        _ => {}
                    }
                }
            }
        }
        fn section(
            &self,
            body: usize,
            x: f64,
            length: f64,
        ) -> ::rncf::emitted::SectionSpec {
            let (body, instance) = self.kind(body);
            let model = &self.model;
            match body {
                0 => {
                    ::rncf::emitted::SectionSpec {
                        shape: ::rncf::emitted::SectionShape::General {
                            extent: [None, None],
                            shear_factors: [0.0, 0.0],
                        },
                        area: 4.571428571428571e-9,
                        second_moments: [1.663e-18, 1.663e-18],
                        torsion_constant: 0.0,
                        young_over_shear: 0.0,
                        softness_of_curves: 4.0,
                        yield_stress: None,
                        material: "aluminium",
                    }
                }
                _ => {
                    ::rncf::emitted::SectionSpec {
                        shape: ::rncf::emitted::SectionShape::General {
                            extent: [None, None],
                            shear_factors: [0.0, 0.0],
                        },
                        area: 4.571428571428571e-9,
                        second_moments: [1.663e-18, 1.663e-18],
                        torsion_constant: 0.0,
                        young_over_shear: 0.0,
                        softness_of_curves: 4.0,
                        yield_stress: None,
                        material: "aluminium",
                    }
                }
            }
        }
        fn fields(
            &self,
            body: usize,
        ) -> &'static [(::rncf::emitted::Interpolant, usize)] {
            let (body, instance) = self.kind(body);
            match body {
                0 => {
                    &[
                        (::rncf::emitted::Interpolant::Position, 1),
                        (::rncf::emitted::Interpolant::Position, 2),
                    ]
                }
                _ => {
                    &[
                        (::rncf::emitted::Interpolant::Position, 1),
                        (::rncf::emitted::Interpolant::Position, 2),
                    ]
                }
            }
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
            let (body, instance) = self.kind(body);
            match body {
                0 => {
                    cable_spatial_slack_field_forces(
                        &self.row_main[instance],
                        ::rncf::emitted::array(stress_free),
                        ::rncf::emitted::array(fields),
                        ::rncf::emitted::array_mut(forces),
                    );
                }
                _ => {
                    cable_spatial_slack_field_forces(
                        &self.row_aux[instance],
                        ::rncf::emitted::array(stress_free),
                        ::rncf::emitted::array(fields),
                        ::rncf::emitted::array_mut(forces),
                    );
                }
            }
        }
    }
    impl ::rncf::emitted::WithoutConservingForces for Equations {}
    impl ::rncf::emitted::WithoutTimedEnergies for Equations {}
    impl ::rncf::emitted::JointConditions for Equations {
        fn joints(&self) -> ::std::vec::Vec<::rncf::emitted::JointSpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::JointSpec {
                        name: "hub",
                        kind: ::rncf::emitted::JointKind::Clamp,
                        body: ::rncf::emitted::instance(
                            self.first(0),
                            self.counts[0],
                            index,
                        ),
                        at_end: false,
                        frame: 1,
                        point: None,
                    });
            }
            specs
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
            let joint = self.joint_kind(joint);
            match (joint, absolute) {
                (0, false) => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            joint_hub_referenced_position(
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
            let joint = self.joint_kind(joint);
            match (joint, absolute) {
                (0, false) => {
                    joint_hub_referenced_jacobian(&self.model, t, data, jacobian);
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
            let joint = self.joint_kind(joint);
            match (joint, absolute) {
                (0, false) => {
                    joint_hub_referenced_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::Loads for Equations {
        fn loads(&self) -> ::std::vec::Vec<::rncf::emitted::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::emitted::LoadSpec {
                    name: "sun",
                    kind: ::rncf::emitted::LoadKind::Field {
                        markers: &[1],
                    },
                    frame: 1,
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
                    name: "sun_x",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[0, 1],
                    coupled: &[[0, 1]],
                    of_differences: false,
                    first_party: 2,
                    branches: 0,
                    when: ::rncf::emitted::When::Always,
                },
                ::rncf::emitted::ConstraintSpec {
                    name: "sun_y",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[2, 1],
                    coupled: &[[0, 1]],
                    of_differences: false,
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
                0 | 1 => {
                    match level {
                        ::rncf::emitted::ConstraintLevel::Position => {
                            constraint_position_sun_x(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Velocity => {
                            constraint_velocity_sun_x(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Acceleration => {
                            constraint_acceleration_sun_x(&self.model, t, z, rows)
                        }
                        ::rncf::emitted::ConstraintLevel::Jerk => {
                            constraint_jerk_sun_x(&self.model, t, z, rows)
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
                0 | 1 => constraint_gradient_sun_x(&self.model, t, z, gradient),
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
                0 | 1 => {
                    constraint_rate_gradient_sun_x(&self.model, t, z, velocity, gradient)
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
                0 | 1 => constraint_hessian_sun_x(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutMarkerForces for Equations {}
    impl ::rncf::emitted::Densities for Equations {
        fn densities(&self) -> ::std::vec::Vec<::rncf::emitted::DensitySpec> {
            let model = &self.model;
            let mut specs = ::std::vec::Vec::new();
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::DensitySpec {
                        name: "thrust",
                        kind: 0,
                        body: self.first(0) + instance,
                        markers: &[1, 0, 3, 2, 4],
                        values: 4,
                    });
            }
            specs
        }
        fn density_values(
            &self,
            density: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            out: &mut [f64],
        ) {
            let (density, instance) = ::rncf::emitted::declared(
                &[self.counts[0]],
                density,
            );
            match density {
                0 => {
                    density_values_thrust(
                        &self.model,
                        t,
                        instance as f64,
                        z,
                        velocity,
                        out,
                    );
                }
                _ => {}
            }
        }
        fn density_values_gradient(
            &self,
            density: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            velocity: &[::rncf::emitted::Vector],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            let (density, instance) = ::rncf::emitted::declared(
                &[self.counts[0]],
                density,
            );
            match density {
                0 => {
                    density_gradient_thrust(
                        &self.model,
                        t,
                        instance as f64,
                        z,
                        velocity,
                        gradient,
                    );
                }
                _ => {}
            }
        }
        fn density_force4(
            &self,
            density: usize,
            elements: &[(usize, usize); 4],
            values: &[[f64; 4]],
            q: &[[f64; 4]],
            force: &mut [[f64; 4]],
        ) {
            let (density, _) = ::rncf::emitted::declared(&[self.counts[0]], density);
            match density {
                0 => {
                    let length = elements
                        .map(|(body, _)| self.row_main[self.kind(body).1].length);
                    let four = DensityForceThrust {
                        length: &[length],
                        values: ::rncf::emitted::array(values),
                        q: ::rncf::emitted::array(q),
                        force: ::rncf::emitted::array_mut(force),
                    };
                    if !::rncf::emitted::lanes::run(four) {
                        for lane in 0..4 {
                            let mut own_force = [0.0; 12];
                            let values: [f64; 4] = ::rncf::emitted::lane(values, lane);
                            let q: [f64; 12] = ::rncf::emitted::lane(q, lane);
                            density_force_thrust(
                                &[length[lane]],
                                &values,
                                &q,
                                &mut own_force,
                            );
                            ::rncf::emitted::add_lane(force, lane, &own_force);
                        }
                    }
                }
                _ => {}
            }
        }
        fn density_tangent4(
            &self,
            density: usize,
            elements: &[(usize, usize); 4],
            values: &[[f64; 4]],
            q: &[[f64; 4]],
            by_q: &mut [[f64; 4]],
            by_values: &mut [[f64; 4]],
        ) {
            let (density, _) = ::rncf::emitted::declared(&[self.counts[0]], density);
            match density {
                0 => {
                    let length = elements
                        .map(|(body, _)| self.row_main[self.kind(body).1].length);
                    let four = DensityTangentThrust {
                        length: &[length],
                        values: ::rncf::emitted::array(values),
                        q: ::rncf::emitted::array(q),
                        by_q: ::rncf::emitted::array_mut(by_q),
                        by_values: ::rncf::emitted::array_mut(by_values),
                    };
                    if !::rncf::emitted::lanes::run(four) {
                        for lane in 0..4 {
                            let mut own_by_q = [0.0; 144];
                            let mut own_by_values = [0.0; 48];
                            let values: [f64; 4] = ::rncf::emitted::lane(values, lane);
                            let q: [f64; 12] = ::rncf::emitted::lane(q, lane);
                            density_tangent_thrust(
                                &[length[lane]],
                                &values,
                                &q,
                                &mut own_by_q,
                                &mut own_by_values,
                            );
                            ::rncf::emitted::add_lane(by_q, lane, &own_by_q);
                            ::rncf::emitted::add_lane(by_values, lane, &own_by_values);
                        }
                    }
                }
                _ => {}
            }
        }
    }
    impl ::rncf::emitted::WithoutDistributedLoads for Equations {}
    impl ::rncf::emitted::WithoutPlacedGravity for Equations {}
    impl ::rncf::emitted::GravityFields for Equations {
        fn field(&self, load: usize, t: f64, z: &[::rncf::emitted::Vector]) -> [f64; 3] {
            let mut gravity = [0.0; 3];
            match load {
                0 => field_sun(&self.model, t, z, &mut gravity),
                _ => {}
            }
            gravity
        }
        fn field_gradient(
            &self,
            load: usize,
            t: f64,
            z: &[::rncf::emitted::Vector],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match load {
                0 => field_gradient_sun(&self.model, t, z, gradient),
                _ => {}
            }
        }
    }
}
