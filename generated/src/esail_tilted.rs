//! Expansion of `models/src/esail_tilted.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

#[doc(inline)]
#[allow(unused_imports)]
pub use esail_tilted_equations::EsailTilted;
#[allow(clippy::all)]
impl Default for EsailTilted {
    fn default() -> Self {
        Self {
            tilt: 0.6108652381980153,
            gain: 0.1,
            ring_share: 0.0,
            turning: 0.00444,
            ring_bias: 0.1,
            length: 10000.0,
            spin: 0.008726646259971648,
            voltage: 40000.0,
            tethers: 20,
            elements: 4,
            remote_mass: 0.45,
            core_mass: 18.0,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for EsailTilted {
    const NAME: &'static str = "EsailTilted";
    const DOC: &'static str = "A tilted E-sail with free attitude. The voltage of each main tether varies with its place, so that the thrust turns the\nplane of the spin with the orbit (Toivanen & Janhunen 2013). The part of that thrust in the plane then changes the rate\nof spin by orbital_rate tan(tilt): slowly faster where the sail is driven along its orbit, slower where against it. The ring\nof auxiliary tethers has no such part, so that charging it takes the change away (TI tether rig, Janhunen & Toivanen 2016).";
    const SOURCE: &'static str = r#"pub model EsailTilted {
    /// Angle of the spin axis to the direction from the Sun, positive towards the motion on the orbit.
    param tilt = 35 deg;
    /// How strongly the voltages answer to the angle that the spin axis is off.
    param gain = 0.1;
    /// Part of the turning that the ring does: 0 none, 1 all of it, 2 reverses the change of the spin.
    param ring_share = 0;
    /// Amplitude of the voltages that turns the spin axis with the orbit: 4 (m + rho A L / 3) spin orbital_rate / (f cos(tilt)),
    /// with the thrust f per length.
    param turning = 0.00444;
    /// Mean potential of the ring, as a part of that of the main tethers, where it does something.
    param ring_bias = 0.1;
    /// Length of a main tether.
    param length = 10 km;
    /// Rate of spin.
    param spin = 0.5 deg/s;
    /// Potential of the main tethers.
    param voltage = 40 kV;
    /// Number of main tethers.
    param tethers: count = 20;
    /// Number of elements of a main tether.
    param elements: count = 4;
    /// Mass of a remote unit.
    param remote_mass = 0.45 kg;
    /// Mass of the core.
    param core_mass = 18 kg;

    const distance = 1.5e11 m;
    const solar_gravity = 5.93e-3 m/s^2;
    const orbital_rate = sqrt(solar_gravity / distance);
    const wind = 1 kV;
    const thrust_factor = 2.4e-5 N/(kV km);
    const hub_radius = 5 m;

    material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
    section wire { area = 4.571428571428571e-9 m^2; second_moment = 1.663e-18 m^4; }

    // Its x axis is that of the spin at the start.
    frame tilted = rotating(axis = z, angle = tilt);
    /// Spins about its z axis.
    frame sail in tilted = free(
        origin = [distance * cos(tilt), -distance * sin(tilt), 0], axis = y, angle = 90 deg,
        velocity = [orbital_rate * distance * sin(tilt), orbital_rate * distance * cos(tilt), 0],
        angular_velocity = [0, 0, spin]
    );
    fixture core on sail { mass = core_mass; }

    for a in 0..tethers {
        body main[a] in sail {
            spatial;
            line from [hub_radius * cos(2*pi*a/tethers), hub_radius * sin(2*pi*a/tethers), 0]
                to [(hub_radius + length) * cos(2*pi*a/tethers), (hub_radius + length) * sin(2*pi*a/tethers), 0];
            mesh elements * tether(wire, aluminium);
        }
        joint hub[a] = clamp(main[a].start, sail);
        fixture remote[a] on main[a].end { mass = remote_mass; }
        load thrust[a] = density(main[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
            * (1 + (1 - ring_share) * dot(
                sin(2*pi*a/tethers) * sail.ex - cos(2*pi*a/tethers) * sail.ey,
                turning * cross([0, 0, 1], sail.ez)
                    + gain * (cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)) / norm(sail.position)))
            * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));

        body aux[a] in sail {
            spatial;
            line from [0, 0, 0] m to [2*pi*(hub_radius + length)/tethers, 0, 0];
            mesh 1 * tether(wire, aluminium);
            initial position [
                (hub_radius + length) * cos(2*pi*a/tethers + x/(hub_radius + length)),
                (hub_radius + length) * sin(2*pi*a/tethers + x/(hub_radius + length)),
                0
            ];
        }
        // Moments about the core: a main tether's thrust acts half way out, the ring's at the tips.
        load ring_thrust[a] = density(aux[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
            * (if ring_share > 0 { 1 } else { 0 })
            * (ring_bias + ring_share * tethers / (4*pi) * dot(
                sin(2*pi*(a + 0.5)/tethers) * sail.ex - cos(2*pi*(a + 0.5)/tethers) * sail.ey,
                turning * cross([0, 0, 1], sail.ez)
                    + gain * (cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)) / norm(sail.position)))
            * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));
        joint near[a] = share(aux[a].start, main[a].end);
        joint far[a] = share(aux[a].end, main[(a + 1) % tethers].end);
        joint ring[a] = merge(aux[a].end, aux[(a + 1) % tethers].start);
    }
    start spun = spinning(sail, angular_velocity = [0, 0, spin]);
    load sun = gravity(-solar_gravity * distance^2 * sail.position / norm(sail.position)^3, on = sail);

    /// Rate of spin.
    output spin: deg/s = sail.angular_velocity.z;
    /// Angle between spin axis and direction from the Sun.
    output angle: deg = atan2(norm(cross(sail.position, sail.ez)), dot(sail.position, sail.ez));
    /// Angle between spin axis and the direction where it is to be.
    output off: deg = asin(norm(cross(sail.ez, cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)))
        / norm(sail.position));
    /// Highest and lowest tip across the plane of the spin.
    output z_tip_max = max(a in 0..tethers, main[a].end.z);
    output z_tip_min = min(a in 0..tethers, main[a].end.z);

    run { t_end = 1 day; every = 10 min; }
}"#;
    const EQUATIONS_HASH: u64 = 0x852aff74ae314136;
    const NOTES: &'static [&'static str] = &[
        "Body `main` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `main` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `main`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `main` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Body `aux` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).",
        "Body `aux` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
        "Body `aux`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.",
        "Body `aux` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Joint `hub`: its conditions are linear in the nodal vectors of `main` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Frame `sail` is free in six motions: three positions and a rotation vector that begins anew every step.",
        "Fixture `remote` adds constants to the inertia of `main` and no unknowns.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, kinks of motions, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as the load per length `thrust` has no potential.",
    ];
    const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_MASS_MATRIX",
            size: [4, 4],
            doc: "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_AXIAL_STRAIN",
            size: [6, 6],
            doc: "Tensor T_AB of the unit element in `axial strain`: U = 1/2 EA length T_AB (I_A - I0_A) (I_B - I0_B).",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_BENDING",
            size: [6, 6],
            doc: "Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB I_A I_B.",
        },
        ::rncf::model::ConstantArray {
            name: "CABLE_SPATIAL_DENSITY_IOTA",
            size: [4, 6],
            doc: "Tensor iota of the unit element for loads per length: the integrals of s_a h_j' h_m' over xi from 0 to 1.",
        },
    ];
    const KERNELS: &'static [::rncf::model::KernelCount] = &[
        ::rncf::model::KernelCount {
            name: "cable_spatial_elastic_force",
            additions: 98,
            multiplications: 118,
            divisions: 1,
            functions: 0,
            weighted: 220,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_elastic_tangent",
            additions: 410,
            multiplications: 370,
            divisions: 1,
            functions: 0,
            weighted: 784,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_strain_energy",
            additions: 74,
            multiplications: 93,
            divisions: 1,
            functions: 0,
            weighted: 171,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_mass",
            additions: 0,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 12,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_0",
            additions: 6,
            multiplications: 12,
            divisions: 0,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_1",
            additions: 5,
            multiplications: 9,
            divisions: 1,
            functions: 0,
            weighted: 18,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_shapes_position_2",
            additions: 4,
            multiplications: 8,
            divisions: 2,
            functions: 0,
            weighted: 20,
        },
        ::rncf::model::KernelCount {
            name: "cable_spatial_field_forces",
            additions: 20,
            multiplications: 52,
            divisions: 0,
            functions: 0,
            weighted: 72,
        },
        ::rncf::model::KernelCount {
            name: "frame_tilted",
            additions: 0,
            multiplications: 0,
            divisions: 0,
            functions: 2,
            weighted: 40,
        },
        ::rncf::model::KernelCount {
            name: "free_sail",
            additions: 0,
            multiplications: 4,
            divisions: 0,
            functions: 2,
            weighted: 44,
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
            name: "outputs",
            additions: 18,
            multiplications: 32,
            divisions: 4,
            functions: 7,
            weighted: 206,
        },
        ::rncf::model::KernelCount {
            name: "density_values_thrust",
            additions: 24,
            multiplications: 36,
            divisions: 5,
            functions: 5,
            weighted: 180,
        },
        ::rncf::model::KernelCount {
            name: "density_gradient_thrust",
            additions: 32,
            multiplications: 89,
            divisions: 18,
            functions: 5,
            weighted: 293,
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
            name: "density_values_ring_thrust",
            additions: 25,
            multiplications: 38,
            divisions: 6,
            functions: 5,
            weighted: 187,
        },
        ::rncf::model::KernelCount {
            name: "density_gradient_ring_thrust",
            additions: 33,
            multiplications: 94,
            divisions: 19,
            functions: 5,
            weighted: 303,
        },
        ::rncf::model::KernelCount {
            name: "density_force_ring_thrust",
            additions: 123,
            multiplications: 165,
            divisions: 3,
            functions: 0,
            weighted: 300,
        },
        ::rncf::model::KernelCount {
            name: "density_tangent_ring_thrust",
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
                name: "tilt",
                kind: ::rncf::ParamKind::Quantity,
                unit: "deg",
                unit_si: 0.017453292519943295,
                dimension: [0, 0, 0, 0, 0, 1],
                default: 0.6108652381980153,
                doc: "Angle of the spin axis to the direction from the Sun, positive towards the motion on the orbit.",
            },
            ::rncf::Param {
                name: "gain",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.1,
                doc: "How strongly the voltages answer to the angle that the spin axis is off.",
            },
            ::rncf::Param {
                name: "ring_share",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.0,
                doc: "Part of the turning that the ring does: 0 none, 1 all of it, 2 reverses the change of the spin.",
            },
            ::rncf::Param {
                name: "turning",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.00444,
                doc: "Amplitude of the voltages that turns the spin axis with the orbit: 4 (m + rho A L / 3) spin orbital_rate / (f cos(tilt)),\nwith the thrust f per length.",
            },
            ::rncf::Param {
                name: "ring_bias",
                kind: ::rncf::ParamKind::Quantity,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 0.1,
                doc: "Mean potential of the ring, as a part of that of the main tethers, where it does something.",
            },
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
                default: 0.008726646259971648,
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
                default: 20.0,
                doc: "Number of main tethers.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 4.0,
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
                default: 18.0,
                doc: "Mass of the core.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "spin",
                unit: "deg/s",
                time_exponent: -1.0,
                components: &[],
                doc: "Rate of spin.",
            },
            ::rncf::Output {
                name: "angle",
                unit: "deg",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle between spin axis and direction from the Sun.",
            },
            ::rncf::Output {
                name: "off",
                unit: "deg",
                time_exponent: 0.0,
                components: &[],
                doc: "Angle between spin axis and the direction where it is to be.",
            },
            ::rncf::Output {
                name: "z_tip_max",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "Highest and lowest tip across the plane of the spin.",
            },
            ::rncf::Output {
                name: "z_tip_min",
                unit: "m",
                time_exponent: 0.0,
                components: &[],
                doc: "",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.tilt,
            1 => self.gain,
            2 => self.ring_share,
            3 => self.turning,
            4 => self.ring_bias,
            5 => self.length,
            6 => self.spin,
            7 => self.voltage,
            8 => self.tethers as f64,
            9 => self.elements as f64,
            10 => self.remote_mass,
            11 => self.core_mass,
            _ => panic!("EsailTilted has 12 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.tilt = value,
            1 => self.gain = value,
            2 => self.ring_share = value,
            3 => self.turning = value,
            4 => self.ring_bias = value,
            5 => self.length = value,
            6 => self.spin = value,
            7 => self.voltage = value,
            8 => self.tethers = value as usize,
            9 => self.elements = value as usize,
            10 => self.remote_mass = value,
            11 => self.core_mass = value,
            _ => panic!("EsailTilted has 12 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
            start: ::rncf::Start::Rest,
        };
        esail_tilted_equations::run_defaults(self, &mut run);
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
        let equations = esail_tilted_equations::Equations::new(self);
        ::rncf::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`EsailTilted`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod esail_tilted_equations {
    /// A tilted E-sail with free attitude. The voltage of each main tether varies with its place, so that the thrust turns the
    /// plane of the spin with the orbit (Toivanen & Janhunen 2013). The part of that thrust in the plane then changes the rate
    /// of spin by orbital_rate tan(tilt): slowly faster where the sail is driven along its orbit, slower where against it. The ring
    /// of auxiliary tethers has no such part, so that charging it takes the change away (TI tether rig, Janhunen & Toivanen 2016).
    ///
    /// # Chosen and left out
    ///
    /// * Body `main` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).
    /// * Body `main` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `main`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `main` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Body `aux` uses `cable_spatial`. Form: constant tensor (the cheapest; operations of force and tangent: constant tensor: 217 and 781; points unrolled: 607 and 2331; loop over points: 652 and 2541; a loop counts 1.3 times).
    /// * Body `aux` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.
    /// * Body `aux`: its material has no damping: no rates of strain and no damping matrix; its axis is straight: no stress-free curvature for each element.
    /// * Body `aux` moves in the free frame `sail`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.
    /// * Joint `hub`: its conditions are linear in the nodal vectors of `main` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
    /// * Frame `sail` is free in six motions: three positions and a rotation vector that begins anew every step.
    /// * Fixture `remote` adds constants to the inertia of `main` and no unknowns.
    /// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
    /// * Not declared, so that no function is written for it: constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, kinks of motions, cautions.
    /// * Energy-momentum integration: no forces that conserve energy are emitted, as the load per length `thrust` has no potential.
    #[derive(Clone, Debug, PartialEq)]
    #[allow(non_snake_case)]
    pub struct EsailTilted {
        /// Angle of the spin axis to the direction from the Sun, positive towards the motion on the orbit. (SI; declared in deg)
        pub tilt: f64,
        /// How strongly the voltages answer to the angle that the spin axis is off. (SI; declared in 1)
        pub gain: f64,
        /// Part of the turning that the ring does: 0 none, 1 all of it, 2 reverses the change of the spin. (SI; declared in 1)
        pub ring_share: f64,
        /// Amplitude of the voltages that turns the spin axis with the orbit: 4 (m + rho A L / 3) spin orbital_rate / (f cos(tilt)),
        /// with the thrust f per length. (SI; declared in 1)
        pub turning: f64,
        /// Mean potential of the ring, as a part of that of the main tethers, where it does something. (SI; declared in 1)
        pub ring_bias: f64,
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
    }
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
    }
    impl CableSpatial {
        /// The constants of four elements side by side.
        #[inline(always)]
        pub fn side_by_side<L: ::rncf::emitted::lanes::Lanes>(
            rows: [&Self; 4],
            lanes: L,
        ) -> CableSpatial<L::Real> {
            CableSpatial {
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
    pub const CABLE_SPATIAL_MASS_MATRIX: [[f64; 4]; 4] = [
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
    /// Tensor T_AB of the unit element in `axial strain`: U = 1/2 EA length T_AB (I_A - I0_A) (I_B - I0_B).
    ///
    /// Rows and columns: dot_s0_s0, dot_s0_d, dot_s0_s1, dot_d_d, dot_d_s1, dot_s1_s1.
    pub const CABLE_SPATIAL_AXIAL_STRAIN: [[f64; 6]; 6] = [
        [
            0.014285714285714285,
            0.0035714285714285713,
            -0.0035714285714285713,
            0.02142857142857143,
            -0.0035714285714285713,
            0.0011904761904761906,
        ],
        [
            0.0035714285714285713,
            0.08571428571428572,
            -0.007142857142857143,
            -0.12857142857142856,
            0.0,
            -0.0035714285714285713,
        ],
        [
            -0.0035714285714285713,
            -0.007142857142857143,
            0.004761904761904762,
            0.0,
            -0.007142857142857143,
            -0.0035714285714285713,
        ],
        [
            0.02142857142857143,
            -0.12857142857142856,
            0.0,
            0.5142857142857142,
            -0.12857142857142856,
            0.02142857142857143,
        ],
        [
            -0.0035714285714285713,
            0.0,
            -0.007142857142857143,
            -0.12857142857142856,
            0.08571428571428572,
            0.0035714285714285713,
        ],
        [
            0.0011904761904761906,
            -0.0035714285714285713,
            -0.0035714285714285713,
            0.02142857142857143,
            0.0035714285714285713,
            0.014285714285714285,
        ],
    ];
    /// Tensor T_AB of the unit element in `bending`: U = 1/2 EI length^-1 T_AB I_A I_B.
    ///
    /// Rows and columns: dot_s0_s0, dot_s0_d, dot_s0_s1, dot_d_d, dot_d_s1, dot_s1_s1.
    pub const CABLE_SPATIAL_BENDING: [[f64; 6]; 6] = [
        [0.0, 0.0, 0.0, 3.6, -2.2, 0.6],
        [0.0, -7.2, 2.2, 0.0, 1.2, -2.2],
        [0.0, 2.2, -1.2, -1.2, 2.2, 0.0],
        [3.6, 0.0, -1.2, 0.0, 0.0, 3.6],
        [-2.2, 1.2, 2.2, 0.0, -7.2, 0.0],
        [0.6, -2.2, 0.0, 3.6, 0.0, 0.0],
    ];
    /// Tensor iota of the unit element for loads per length: the integrals of s_a h_j' h_m' over xi from 0 to 1.
    ///
    /// Rows: s0, r1, s1, and 1 in place of a shape function (zeta). Columns: s0 s0, s0 r1, s0 s1, r1 r1, r1 s1, s1 s1.
    pub const CABLE_SPATIAL_DENSITY_IOTA: [[f64; 6]; 4] = [
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
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 98 additions, 118 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_force<T: ::rncf::emitted::lanes::Real>(
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
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t48 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t49 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t51 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t52 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t53 = inverse_length * EI;
        let t54 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t43 * t46
            + t53
                * (t54 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t56 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t47 + t48 + t49)
            + t53
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t56
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t58 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t43
            * (t49
                + (t50 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t53
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t58
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let stress_dot_d_d = t43 * t51
            + t53
                * (t58 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t43
            * (t48 + (t47 + t50) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t53
                * (t56
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t43 * t52
            + t53
                * (t54
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
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
    impl ::rncf::emitted::lanes::Kernel for CableSpatialElasticForce<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, force } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_force(&row, &q, force);
        }
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
    ///
    /// U = 1/2 T_AB (I_A - I0_A) (I_B - I0_B) over the inner products I of d = (r1 - r0)/length and the slopes; stress S_A = dU/dI_A, force S_A dI_A/dq. T is integrated exactly, unrolled.
    ///
    /// Operations: 410 additions, 370 multiplications, 1 divisions.
    #[inline(always)]
    pub fn cable_spatial_elastic_tangent<T: ::rncf::emitted::lanes::Real>(
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
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t48 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][1];
        let t49 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t51 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t52 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t53 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t54 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t55 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t56 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[3][3];
        let t57 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t58 = inverse_length * EI;
        let t59 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let stress_dot_s0_s0 = t43 * t46
            + t58
                * (t59 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]);
        let t61 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + t58 * CABLE_SPATIAL_BENDING[0][3];
        let t62 = t49 + t58 * CABLE_SPATIAL_BENDING[0][4];
        let t63 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
            + t58 * CABLE_SPATIAL_BENDING[0][5];
        let t64 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let stress_dot_s0_d = t43
            * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t50 + t51 + t52)
            + t58
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t64
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]);
        let t66 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
            + t58 * CABLE_SPATIAL_BENDING[1][1];
        let t67 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
            + t58 * CABLE_SPATIAL_BENDING[1][2];
        let t68 = t58 * CABLE_SPATIAL_BENDING[1][4];
        let t69 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let stress_dot_s0_s1 = t43
            * (t52
                + (t54 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                    + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                    + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2]))
            + t58
                * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t69
                    + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]);
        let t71 = t58 * CABLE_SPATIAL_BENDING[2][2];
        let t72 = t43 * CABLE_SPATIAL_AXIAL_STRAIN[2][2] + t71;
        let stress_dot_d_d = t43 * t55
            + t58
                * (t69 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                    + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]);
        let stress_dot_d_s1 = t43
            * (t51 + (t50 + t54) + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1])
            + t58
                * (t64
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                    + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]);
        let stress_dot_s1_s1 = t43 * t57
            + t58
                * (t59
                    + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                        + dot_s0_d * CABLE_SPATIAL_BENDING[0][4]));
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
    impl ::rncf::emitted::lanes::Kernel for CableSpatialElasticTangent<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { rows, q, stiffness } = self;
            let row = CableSpatial::side_by_side(rows, lanes);
            let q = lanes.load_all(q);
            cable_spatial_elastic_tangent(&row, &q, stiffness);
        }
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = polynomial, axial = green.
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
        let t44 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t45 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t46 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][0]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][1] + t44 + t45
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][5];
        let t47 = strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2];
        let t48 = strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3];
        let t49 = strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t50 = t43 * (strain_dot_s0_s0 * t46)
            + t43
                * (strain_dot_s0_d
                    * (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
                        + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][1] + t47 + t48
                        + t49));
        let t51 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][2];
        let t52 = t43
            * (strain_dot_s0_s1
                * (t49
                    + (t51 + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][2]
                        + strain_dot_s0_s1 * CABLE_SPATIAL_AXIAL_STRAIN[2][2]
                        + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][2])));
        let t53 = strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][3]
            + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_d_d * CABLE_SPATIAL_AXIAL_STRAIN[3][3]
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][3]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][3];
        let t54 = t50 + t52 + t43 * (strain_dot_d_d * t53)
            + t43
                * (strain_dot_d_s1
                    * (t48 + (t47 + t51)
                        + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[1][1]
                        + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]));
        let t55 = t45
            + (t44
                + (strain_dot_s0_s0 * CABLE_SPATIAL_AXIAL_STRAIN[0][5]
                    + strain_dot_s0_d * CABLE_SPATIAL_AXIAL_STRAIN[0][2]))
            + strain_dot_d_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][1]
            + strain_dot_s1_s1 * CABLE_SPATIAL_AXIAL_STRAIN[0][0];
        let t56 = 0.5 * (inverse_length * EI);
        let t57 = dot_d_d * CABLE_SPATIAL_BENDING[0][3];
        let t58 = t54 + t43 * (strain_dot_s1_s1 * t55)
            + t56
                * (dot_s0_s0
                    * (t57 + dot_d_s1 * CABLE_SPATIAL_BENDING[0][4]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][5]));
        let t59 = dot_s0_s1 * CABLE_SPATIAL_BENDING[1][2];
        let t60 = t58
            + t56
                * (dot_s0_d
                    * (dot_s0_d * CABLE_SPATIAL_BENDING[1][1] + t59
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][4]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][4]));
        let t61 = dot_s0_s1 * CABLE_SPATIAL_BENDING[2][2];
        let t62 = t60
            + t56
                * (dot_s0_s1
                    * (dot_s0_d * CABLE_SPATIAL_BENDING[1][2] + t61
                        + dot_d_d * CABLE_SPATIAL_BENDING[2][2]
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][2]));
        let t63 = t62
            + t56
                * (dot_d_d
                    * (t61 + dot_s0_s0 * CABLE_SPATIAL_BENDING[0][3]
                        + dot_s1_s1 * CABLE_SPATIAL_BENDING[0][3]))
            + t56
                * (dot_d_s1
                    * (t59
                        + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][4]
                            + dot_s0_d * CABLE_SPATIAL_BENDING[1][4])
                        + dot_d_s1 * CABLE_SPATIAL_BENDING[1][1]));
        *energy
            += t63
                + t56
                    * (dot_s1_s1
                        * (t57
                            + (dot_s0_s0 * CABLE_SPATIAL_BENDING[0][5]
                                + dot_s0_d * CABLE_SPATIAL_BENDING[0][4])));
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 12 multiplications.
    pub fn cable_spatial_mass(row: &CableSpatial, mass: &mut [f64; 16]) {
        let CableSpatial { length, rhoA, .. } = *row;
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * CABLE_SPATIAL_MASS_MATRIX[0][0];
        let t16 = length * element_mass;
        let mass_r0_s0 = t16 * CABLE_SPATIAL_MASS_MATRIX[0][1];
        let mass_r0_r1 = element_mass * CABLE_SPATIAL_MASS_MATRIX[0][2];
        let mass_r0_s1 = t16 * CABLE_SPATIAL_MASS_MATRIX[0][3];
        let t20 = element_mass * (length * length);
        let mass_s0_s0 = t20 * CABLE_SPATIAL_MASS_MATRIX[1][1];
        let mass_s0_r1 = t16 * CABLE_SPATIAL_MASS_MATRIX[1][2];
        let mass_s0_s1 = t20 * CABLE_SPATIAL_MASS_MATRIX[1][3];
        let mass_r1_s1 = t16 * CABLE_SPATIAL_MASS_MATRIX[2][3];
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
    /// Motion of frame `tilted` and its first two derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications, 2 function calls.
    pub fn frame_tilted(
        model: &EsailTilted,
        t: f64,
        motion: &mut ::rncf::emitted::FrameMotion,
    ) {
        *motion = ::rncf::emitted::FrameMotion::INERTIAL;
        let t13 = model.tilt.cos();
        let t14 = model.tilt.sin();
        motion.rotation[(0, 0)] = t13;
        motion.rotation[(0, 1)] = -t14;
        motion.rotation[(1, 0)] = t14;
        motion.rotation[(1, 1)] = t13;
    }
    /// Free frame `sail`: its start relative to its parent, and its rigid parts.
    ///
    /// Parts `core`: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes.
    ///
    /// Spins about its z axis.
    ///
    /// Operations: 0 additions, 4 multiplications, 2 function calls.
    pub fn free_sail(model: &EsailTilted, spec: &mut ::rncf::emitted::FreeSpec) {
        let t15 = model.tilt.cos();
        let t16 = model.tilt.sin();
        spec.position[0] = 150000000000.0 * t15;
        spec.position[1] = -150000000000.0 * t16;
        spec.velocity[0] = t16 * 29824.48658401348;
        spec.velocity[1] = t15 * 29824.48658401348;
        spec.spin[2] = model.spin;
        spec.angle = 1.5707963267948966;
        spec.axis[1] = 1.0;
        spec.rigid.mass = model.core_mass;
    }
    /// Start of body `aux` at the arclength x (m): position (m) and velocity (m/s) in its frame, each with its derivative by x.
    ///
    /// Operations: 2 additions, 7 multiplications, 3 divisions, 2 function calls.
    pub fn initial_aux(
        model: &EsailTilted,
        x: f64,
        index: f64,
        position: &mut [[f64; 3]; 2],
        velocity: &mut [[f64; 3]; 2],
    ) {
        let t16 = model.length + 5.0;
        let t17 = index * 6.283185307179586 / (model.tethers as f64) + x / t16;
        let t18 = t17.cos();
        let t19 = t17.sin();
        let t20 = 1.0 / t16;
        position[0][0] = t16 * t18;
        position[0][1] = t16 * t19;
        position[1][0] = -t16 * (t19 * t20);
        position[1][1] = t16 * (t18 * t20);
    }
    /// Joint `hub`: conditions, position level.
    ///
    /// Operations: 7 additions, 6 multiplications.
    pub fn joint_hub_referenced_position(
        model: &EsailTilted,
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
        model: &EsailTilted,
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
        model: &EsailTilted,
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
    /// What an output reduces, of one repetition.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs_of_one_0(
        model: &EsailTilted,
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
        model: &EsailTilted,
        t: f64,
        index: f64,
        observed: &[f64],
        value: &mut [f64; 1],
    ) {
        value[0] = observed[0];
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 18 additions, 32 multiplications, 4 divisions, 7 function calls.
    pub fn outputs(model: &EsailTilted, t: f64, observed: &[f64], out: &mut [f64]) {
        let t24 = (observed[4] * observed[6] - observed[2] * observed[7]).powi(2)
            + (observed[0] * observed[7] - observed[4] * observed[8]).powi(2);
        let t25 = (t24 + (observed[2] * observed[8] - observed[0] * observed[6]).powi(2))
            .sqrt()
            .atan2(
                observed[0] * observed[8] + observed[2] * observed[6]
                    + observed[4] * observed[7],
            );
        let t26 = model.tilt.cos();
        let t27 = observed[7] * t26;
        let t28 = model.tilt.sin();
        let t29 = observed[6] * t26 + observed[8] * t28;
        let t30 = observed[8] * t26 - observed[6] * t28;
        let t31 = (observed[2] * t27 - observed[4] * t29).powi(2)
            + (observed[4] * t30 - observed[0] * t27).powi(2);
        let t32 = (t31 + (observed[0] * t29 - observed[2] * t30).powi(2)).sqrt()
            / (observed[8] * observed[8] + observed[6] * observed[6]
                + observed[7] * observed[7])
                .sqrt();
        out[0] = (observed[0] * observed[1] + observed[2] * observed[3]
            + observed[4] * observed[5]) / 0.017453292519943295;
        out[1] = t25 / 0.017453292519943295;
        out[2] = t32.asin() / 0.017453292519943295;
        out[3] = observed[9];
        out[4] = observed[10];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &EsailTilted, run: &mut ::rncf::RunDefaults) {
        run.t_end = 86400.0;
        run.every = 600.0;
    }
    /// Load per length `thrust`: writes what it depends on along the whole body.
    ///
    /// Of `thrust`: `z[0]` a point of `sail`; `z[1]` a direction of `sail`; `z[2]` a direction of `sail`; `z[3]` a direction of `sail`; `z[4]` a point of `inertial` (inertial axes).
    ///
    /// Operations: 24 additions, 36 multiplications, 5 divisions, 5 function calls.
    pub fn density_values_thrust(
        model: &EsailTilted,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        values: &mut [f64],
    ) {
        let t34 = z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2];
        let t35 = index * 6.283185307179586 / (model.tethers as f64);
        let t36 = t35.sin();
        let t37 = t35.cos();
        let t38 = model.tilt.cos();
        let t39 = model.tilt.sin();
        let t40 = t34.sqrt();
        let t41 = (z[1][0] * t36 - z[2][0] * t37)
            * (model.gain * (z[0][0] * t38 - z[0][1] * t39) / t40
                - model.turning * z[3][1]);
        let t42 = (z[1][1] * t36 - z[2][1] * t37)
            * (model.turning * z[3][0]
                + model.gain * (z[0][1] * t38 + z[0][0] * t39) / t40);
        let t43 = t41 + t42
            + (z[1][2] * t36 - z[2][2] * t37) * (model.gain * (z[0][2] * t38) / t40);
        let t44 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0 / t34 * (1.0 + (1.0 - model.ring_share) * t43);
        let t45 = z[4][0] - z[0][0];
        let t46 = z[4][1] - z[0][1];
        let t47 = z[4][2] - z[0][2];
        values[0] = z[1][0] * t45 + z[1][1] * t46 + z[1][2] * t47;
        values[1] = z[2][0] * t45 + z[2][1] * t46 + z[2][2] * t47;
        values[2] = z[3][0] * t45 + z[3][1] * t46 + z[3][2] * t47;
        values[3] = t44;
    }
    /// Load per length `thrust`: writes the derivatives of its values with respect to z, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 32 additions, 89 multiplications, 18 divisions, 5 function calls.
    pub fn density_gradient_thrust(
        model: &EsailTilted,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let t34 = z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2];
        let t35 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0 / t34;
        let t36 = 1.0 - model.ring_share;
        let t37 = index * 6.283185307179586 / (model.tethers as f64);
        let t38 = t37.sin();
        let t39 = t37.cos();
        let t40 = z[1][0] * t38 - z[2][0] * t39;
        let t41 = model.tilt.cos();
        let t42 = model.tilt.sin();
        let t43 = t34.sqrt();
        let t44 = model.gain * (z[0][0] * t41 - z[0][1] * t42) / t43;
        let t45 = t44 - model.turning * z[3][1];
        let t46 = z[1][1] * t38 - z[2][1] * t39;
        let t47 = model.gain * (z[0][1] * t41 + z[0][0] * t42) / t43;
        let t48 = model.turning * z[3][0] + t47;
        let t49 = z[1][2] * t38 - z[2][2] * t39;
        let t50 = model.gain * (z[0][2] * t41) / t43;
        let t51 = 1.0 + t36 * (t40 * t45 + t46 * t48 + t49 * t50);
        let t52 = z[4][0] - z[0][0];
        let t53 = z[4][1] - z[0][1];
        let t54 = z[4][2] - z[0][2];
        let t55 = z[0][0] * 2.0;
        let t56 = z[0][1] * 2.0;
        let t57 = z[0][2] * 2.0;
        let t58 = model.gain * t41;
        let t59 = 1.0 / (2.0 * t43);
        let t60 = t55 * t59;
        let t61 = model.gain * t42;
        let t62 = t40 * ((t58 - t44 * t60) / t43) + t46 * ((t61 - t47 * t60) / t43);
        let t63 = t35 * (t36 * (t62 - t49 * (t50 * t60 / t43)))
            - t51 * (t35 * t55 / t34);
        let t64 = t56 * t59;
        let t65 = t46 * ((t58 - t47 * t64) / t43) - t40 * ((t61 + t44 * t64) / t43);
        let t66 = t35 * (t36 * (t65 - t49 * (t50 * t64 / t43)))
            - t51 * (t35 * t56 / t34);
        let t67 = t57 * t59;
        let t68 = t49 * ((t58 - t50 * t67) / t43)
            - (t40 * (t44 * t67 / t43) + t46 * (t47 * t67 / t43));
        gradient[0] = -z[1][0];
        gradient[1] = -z[1][1];
        gradient[2] = -z[1][2];
        gradient[3] = t52;
        gradient[4] = t53;
        gradient[5] = t54;
        gradient[12] = z[1][0];
        gradient[13] = z[1][1];
        gradient[14] = z[1][2];
        gradient[15] = -z[2][0];
        gradient[16] = -z[2][1];
        gradient[17] = -z[2][2];
        gradient[21] = t52;
        gradient[22] = t53;
        gradient[23] = t54;
        gradient[27] = z[2][0];
        gradient[28] = z[2][1];
        gradient[29] = z[2][2];
        gradient[30] = -z[3][0];
        gradient[31] = -z[3][1];
        gradient[32] = -z[3][2];
        gradient[39] = t52;
        gradient[40] = t53;
        gradient[41] = t54;
        gradient[42] = z[3][0];
        gradient[43] = z[3][1];
        gradient[44] = z[3][2];
        gradient[45] = t63;
        gradient[46] = t66;
        gradient[47] = t35 * (t36 * t68) - t51 * (t35 * t57 / t34);
        gradient[48] = t35 * (t36 * (t38 * t45));
        gradient[49] = t35 * (t36 * (t38 * t48));
        gradient[50] = t35 * (t36 * (t38 * t50));
        gradient[51] = -t35 * (t36 * (t39 * t45));
        gradient[52] = -t35 * (t36 * (t39 * t48));
        gradient[53] = -t35 * (t36 * (t39 * t50));
        gradient[54] = t35 * (t36 * (model.turning * t46));
        gradient[55] = -t35 * (t36 * (model.turning * t40));
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
        let t62 = t34 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t63 = t35 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t64 = t36 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t65 = t34 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t47 * (-0.016666666666666666)
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t66 = t35 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t48 * (-0.016666666666666666)
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t67 = t36 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t49 * (-0.016666666666666666)
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t68 = t65 + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t69 = t66 + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t70 = t67 + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t71 = t34 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t72 = t35 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t73 = t36 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t74 = t34 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t42 * (-0.1)
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t55 * (-0.1);
        let t75 = t35 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t43 * (-0.1)
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t56 * (-0.1);
        let t76 = t36 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t44 * (-0.1)
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t57 * (-0.1);
        let t77 = values[3] * (length * length);
        let t78 = values[3] * length;
        force[0] += (t74 + t59 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t68) * t78;
        force[1] += (t75 + t60 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t69) * t78;
        force[2] += (t76 + t61 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t70) * t78;
        force[3] += (t62 + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[4] += (t63 + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[5] += (t64 + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[6] += t68 * t78;
        force[7] += t69 * t78;
        force[8] += t70 * t78;
        force[9] += (t71 + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
        force[10] += (t72 + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
        force[11] += (t73 + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
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
        let t80 = t37 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t69 * (-0.016666666666666666);
        let t81 = t42 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t74 * (-0.016666666666666666);
        let t82 = t45 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t77 * (-0.016666666666666666);
        let t83 = t53 * (-0.1);
        let t84 = t58 * (-0.1);
        let t85 = t61 * (-0.1);
        let t86 = t39 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t71 * (-0.016666666666666666);
        let t87 = t43 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t75 * (-0.016666666666666666);
        let t88 = t46 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t78 * (-0.016666666666666666);
        let t89 = t55 * (-0.1);
        let t90 = t59 * (-0.1);
        let t91 = t62 * (-0.1);
        let t92 = t41 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t73 * (-0.016666666666666666);
        let t93 = t44 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t76 * (-0.016666666666666666);
        let t94 = t47 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t79 * (-0.016666666666666666);
        let t95 = t57 * (-0.1);
        let t96 = t60 * (-0.1);
        let t97 = t63 * (-0.1);
        let t98 = t37 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t99 = t42 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t100 = t45 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t101 = t39 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t102 = t43 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t103 = t46 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t104 = t41 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t105 = t44 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t106 = t47 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t107 = t37 * (-0.016666666666666666) + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t108 = t42 * (-0.016666666666666666) + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t109 = t45 * (-0.016666666666666666) + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t110 = t39 * (-0.016666666666666666) + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t111 = t43 * (-0.016666666666666666) + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t112 = t46 * (-0.016666666666666666) + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t113 = t41 * (-0.016666666666666666) + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t114 = t44 * (-0.016666666666666666) + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t115 = t47 * (-0.016666666666666666) + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t116 = length * length;
        let t117 = values[3] * t116;
        let t118 = values[3] * length;
        let t119 = (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t120 = (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t121 = (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t122 = values[3] * t98;
        let t123 = values[3] * t99;
        let t124 = values[3] * t100;
        let t125 = (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t126 = (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t127 = (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t128 = values[3]
            * (t37 * (-0.1) + t53 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t69 * (-0.1)
                - t98);
        let t129 = values[3]
            * (t42 * (-0.1) + t58 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t74 * (-0.1)
                - t99);
        let t130 = values[3]
            * (t45 * (-0.1) + t61 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t77 * (-0.1)
                - t100);
        let t131 = (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t132 = (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t133 = (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t134 = values[3] * t101;
        let t135 = values[3] * t102;
        let t136 = values[3] * t103;
        let t137 = (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t138 = (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t139 = (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t140 = values[3]
            * (t39 * (-0.1) + t55 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t71 * (-0.1)
                - t101);
        let t141 = values[3]
            * (t43 * (-0.1) + t59 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t75 * (-0.1)
                - t102);
        let t142 = values[3]
            * (t46 * (-0.1) + t62 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t78 * (-0.1)
                - t103);
        let t143 = (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t144 = (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t145 = (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t146 = values[3] * t104;
        let t147 = values[3] * t105;
        let t148 = values[3] * t106;
        let t149 = (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t150 = (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t151 = (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t152 = values[3]
            * (t41 * (-0.1) + t57 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t73 * (-0.1)
                - t104);
        let t153 = values[3]
            * (t44 * (-0.1) + t60 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t76 * (-0.1)
                - t105);
        let t154 = values[3]
            * (t47 * (-0.1) + t63 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t79 * (-0.1)
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
        let t188 = t159 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t189 = t160 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t190 = t161 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t191 = t159 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t167 * (-0.016666666666666666)
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t192 = t160 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t168 * (-0.016666666666666666)
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t193 = t161 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t169 * (-0.016666666666666666)
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t194 = t191 + t185 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t195 = t192 + t186 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t196 = t193 + t187 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t197 = t159 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t198 = t160 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t199 = t161 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t200 = t159 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t163 * (-0.1)
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t178 * (-0.1);
        let t201 = t160 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t164 * (-0.1)
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t179 * (-0.1);
        let t202 = t161 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t165 * (-0.1)
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t180 * (-0.1);
        let t203 = t155 - t158;
        let t204 = s0_x * t29;
        let t205 = t204 + t204 - t162;
        let t206 = s0_x * s1_x;
        let t207 = t206 + t206 - t166;
        let t208 = t170 - t173;
        let t209 = s1_x * t29;
        let t210 = t209 + t209 - t177;
        let t211 = t181 - t184;
        let t212 = t203 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t207 * (-0.016666666666666666)
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t213 = t212 + t211 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t214 = t203 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t205 * (-0.1)
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t210 * (-0.1);
        let t215 = s0_x * s0_y;
        let t216 = s0_y * t29 + s0_x * t30;
        let t217 = s0_y * s1_x + s0_x * s1_y;
        let t218 = t29 * t30;
        let t219 = s1_x * t30 + s1_y * t29;
        let t220 = s1_x * s1_y;
        let t221 = t215 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t217 * (-0.016666666666666666)
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t222 = t221 + t220 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t223 = t215 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t216 * (-0.1)
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t219 * (-0.1);
        let t224 = t118 * (t223 + t220 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t222);
        let t225 = s0_x * s0_z;
        let t226 = s0_z * t29 + s0_x * t31;
        let t227 = s0_z * s1_x + s0_x * s1_z;
        let t228 = t29 * t31;
        let t229 = s1_x * t31 + s1_z * t29;
        let t230 = s1_x * s1_z;
        let t231 = t225 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t227 * (-0.016666666666666666)
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t232 = t231 + t230 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t233 = t225 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t226 * (-0.1)
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t229 * (-0.1);
        let t234 = t118 * (t233 + t230 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t232);
        let t235 = t156 - t158;
        let t236 = s0_y * t30;
        let t237 = t236 + t236 - t162;
        let t238 = s0_y * s1_y;
        let t239 = t238 + t238 - t166;
        let t240 = t171 - t173;
        let t241 = s1_y * t30;
        let t242 = t241 + t241 - t177;
        let t243 = t182 - t184;
        let t244 = t235 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t239 * (-0.016666666666666666)
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t245 = t244 + t243 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t246 = t235 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t237 * (-0.1)
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t242 * (-0.1);
        let t247 = s0_y * s0_z;
        let t248 = s0_z * t30 + s0_y * t31;
        let t249 = s0_z * s1_y + s0_y * s1_z;
        let t250 = t30 * t31;
        let t251 = s1_y * t31 + s1_z * t30;
        let t252 = s1_y * s1_z;
        let t253 = t247 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t249 * (-0.016666666666666666)
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t254 = t253 + t252 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t255 = t247 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t248 * (-0.1)
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t251 * (-0.1);
        let t256 = t118 * (t255 + t252 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t254);
        let t257 = t157 - t158;
        let t258 = s0_z * t31;
        let t259 = t258 + t258 - t162;
        let t260 = s0_z * s1_z;
        let t261 = t260 + t260 - t166;
        let t262 = t172 - t173;
        let t263 = s1_z * t31;
        let t264 = t263 + t263 - t177;
        let t265 = t183 - t184;
        let t266 = t257 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t261 * (-0.016666666666666666)
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t267 = t266 + t265 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t268 = t257 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t259 * (-0.1)
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t264 * (-0.1);
        let t269 = t203 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t270 = t215 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t271 = t117 * (t270 + t220 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t272 = t225 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t273 = t117 * (t272 + t230 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t274 = t235 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t275 = t247 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t276 = t117 * (t275 + t252 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t277 = t257 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t278 = t118 * t222;
        let t279 = t118 * t232;
        let t280 = t118 * t254;
        let t281 = t203 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t282 = t215 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t283 = t117 * (t282 + t220 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t284 = t225 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t285 = t117 * (t284 + t230 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t286 = t235 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t287 = t247 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t288 = t117 * (t287 + t252 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t289 = t257 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        by_q[0] -= t128;
        by_q[1] -= t140;
        by_q[2] -= t152;
        by_q[3]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t83
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t80) * t118;
        by_q[4]
            += t118
                * (t39 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t89
                    + t71 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t86);
        by_q[5]
            += t118
                * (t41 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t95
                    + t73 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t92);
        by_q[6] += t128;
        by_q[7] += t140;
        by_q[8] += t152;
        by_q[9]
            += t118
                * (t83 + t37 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t69 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t107);
        by_q[10]
            += t118
                * (t89 + t39 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t71 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t110);
        by_q[11]
            += t118
                * (t95 + t41 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t73 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t113);
        by_q[12] -= t129;
        by_q[13] -= t141;
        by_q[14] -= t153;
        by_q[15]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t84
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t81) * t118;
        by_q[16]
            += t118
                * (t43 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t90
                    + t75 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t87);
        by_q[17]
            += t118
                * (t44 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t96
                    + t76 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t93);
        by_q[18] += t129;
        by_q[19] += t141;
        by_q[20] += t153;
        by_q[21]
            += t118
                * (t84 + t42 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t74 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t108);
        by_q[22]
            += t118
                * (t90 + t43 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t75 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t111);
        by_q[23]
            += t118
                * (t96 + t44 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t76 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t114);
        by_q[24] -= t130;
        by_q[25] -= t142;
        by_q[26] -= t154;
        by_q[27]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t85
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t82) * t118;
        by_q[28]
            += t118
                * (t46 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t91
                    + t78 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t88);
        by_q[29]
            += t118
                * (t47 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t97
                    + t79 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t94);
        by_q[30] += t130;
        by_q[31] += t142;
        by_q[32] += t154;
        by_q[33]
            += t118
                * (t85 + t45 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t77 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t109);
        by_q[34]
            += t118
                * (t91 + t46 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t78 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t112);
        by_q[35]
            += t118
                * (t97 + t47 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t79 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t115);
        by_q[36] -= t119;
        by_q[37] -= t131;
        by_q[38] -= t143;
        by_q[39]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[40]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[41]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[42] += t119;
        by_q[43] += t131;
        by_q[44] += t143;
        by_q[45]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[46]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[47]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[48] -= t120;
        by_q[49] -= t132;
        by_q[50] -= t144;
        by_q[51]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[52]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[53]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[54] += t120;
        by_q[55] += t132;
        by_q[56] += t144;
        by_q[57]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[58]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[59]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[60] -= t121;
        by_q[61] -= t133;
        by_q[62] -= t145;
        by_q[63]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[64]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[65]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[66] += t121;
        by_q[67] += t133;
        by_q[68] += t145;
        by_q[69]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[70]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[71]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
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
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[112]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[113]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[114] += t125;
        by_q[115] += t137;
        by_q[116] += t149;
        by_q[117]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[118]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[119]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[120] -= t126;
        by_q[121] -= t138;
        by_q[122] -= t150;
        by_q[123]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[124]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[125]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[126] += t126;
        by_q[127] += t138;
        by_q[128] += t150;
        by_q[129]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[130]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[131]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[132] -= t127;
        by_q[133] -= t139;
        by_q[134] -= t151;
        by_q[135]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[136]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[137]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[138] += t127;
        by_q[139] += t139;
        by_q[140] += t151;
        by_q[141]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[142]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[143]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_values[0] += t118 * (t214 + t211 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t213);
        by_values[1] += t224;
        by_values[2] += t234;
        by_values[3] += length * (t200 + t185 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t194);
        by_values[4] += t224;
        by_values[5] += t118 * (t246 + t243 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t245);
        by_values[6] += t256;
        by_values[7] += length * (t201 + t186 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t195);
        by_values[8] += t234;
        by_values[9] += t256;
        by_values[10] += t118 * (t268 + t265 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t267);
        by_values[11]
            += length * (t202 + t187 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t196);
        by_values[12] += t117 * (t269 + t211 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[13] += t271;
        by_values[14] += t273;
        by_values[15] += t116 * (t188 + t185 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[16] += t271;
        by_values[17] += t117 * (t274 + t243 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[18] += t276;
        by_values[19] += t116 * (t189 + t186 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[20] += t273;
        by_values[21] += t276;
        by_values[22] += t117 * (t277 + t265 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[23] += t116 * (t190 + t187 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
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
        by_values[36] += t117 * (t281 + t211 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[37] += t283;
        by_values[38] += t285;
        by_values[39] += t116 * (t197 + t185 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[40] += t283;
        by_values[41] += t117 * (t286 + t243 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[42] += t288;
        by_values[43] += t116 * (t198 + t186 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[44] += t285;
        by_values[45] += t288;
        by_values[46] += t117 * (t289 + t265 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[47] += t116 * (t199 + t187 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
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
    /// Load per length `ring_thrust`: writes what it depends on along the whole body.
    ///
    /// Of `ring_thrust`: `z[0]` a point of `sail`; `z[1]` a direction of `sail`; `z[2]` a direction of `sail`; `z[3]` a direction of `sail`; `z[4]` a point of `inertial` (inertial axes).
    ///
    /// Operations: 25 additions, 38 multiplications, 6 divisions, 5 function calls.
    pub fn density_values_ring_thrust(
        model: &EsailTilted,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        values: &mut [f64],
    ) {
        let t35 = z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2];
        let t36 = 6.283185307179586 * (index + 0.5) / (model.tethers as f64);
        let t37 = t36.sin();
        let t38 = t36.cos();
        let t39 = model.tilt.cos();
        let t40 = model.tilt.sin();
        let t41 = t35.sqrt();
        let t42 = (z[1][0] * t37 - z[2][0] * t38)
            * (model.gain * (z[0][0] * t39 - z[0][1] * t40) / t41
                - model.turning * z[3][1]);
        let t43 = (z[1][1] * t37 - z[2][1] * t38)
            * (model.turning * z[3][0]
                + model.gain * (z[0][1] * t39 + z[0][0] * t40) / t41);
        let t44 = t42 + t43
            + (z[1][2] * t37 - z[2][2] * t38) * (model.gain * (z[0][2] * t39) / t41);
        let t45 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0 / t35 * (if model.ring_share > 0.0 { 1.0 } else { 0.0 })
            * (model.ring_bias
                + model.ring_share * (model.tethers as f64) / 12.566370614359172 * t44);
        let t46 = z[4][0] - z[0][0];
        let t47 = z[4][1] - z[0][1];
        let t48 = z[4][2] - z[0][2];
        values[0] = z[1][0] * t46 + z[1][1] * t47 + z[1][2] * t48;
        values[1] = z[2][0] * t46 + z[2][1] * t47 + z[2][2] * t48;
        values[2] = z[3][0] * t46 + z[3][1] * t47 + z[3][2] * t48;
        values[3] = t45;
    }
    /// Load per length `ring_thrust`: writes the derivatives of its values with respect to z, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 33 additions, 94 multiplications, 19 divisions, 5 function calls.
    pub fn density_gradient_ring_thrust(
        model: &EsailTilted,
        t: f64,
        index: f64,
        z: &[::rncf::emitted::Vector],
        velocity: &[::rncf::emitted::Vector],
        gradient: &mut [f64],
    ) {
        let t35 = z[0][0] * z[0][0] + z[0][1] * z[0][1] + z[0][2] * z[0][2];
        let t36 = 2.4e-11
            * (if model.voltage > 1000.0 { model.voltage - 1000.0 } else { 0.0 })
            * 150000000000.0 / t35;
        let t37 = (if model.ring_share > 0.0 { 1.0 } else { 0.0 });
        let t38 = t36 * t37;
        let t39 = model.ring_share * (model.tethers as f64) / 12.566370614359172;
        let t40 = 6.283185307179586 * (index + 0.5) / (model.tethers as f64);
        let t41 = t40.sin();
        let t42 = t40.cos();
        let t43 = z[1][0] * t41 - z[2][0] * t42;
        let t44 = model.tilt.cos();
        let t45 = model.tilt.sin();
        let t46 = t35.sqrt();
        let t47 = model.gain * (z[0][0] * t44 - z[0][1] * t45) / t46;
        let t48 = t47 - model.turning * z[3][1];
        let t49 = z[1][1] * t41 - z[2][1] * t42;
        let t50 = model.gain * (z[0][1] * t44 + z[0][0] * t45) / t46;
        let t51 = model.turning * z[3][0] + t50;
        let t52 = z[1][2] * t41 - z[2][2] * t42;
        let t53 = model.gain * (z[0][2] * t44) / t46;
        let t54 = model.ring_bias + t39 * (t43 * t48 + t49 * t51 + t52 * t53);
        let t55 = z[4][0] - z[0][0];
        let t56 = z[4][1] - z[0][1];
        let t57 = z[4][2] - z[0][2];
        let t58 = z[0][0] * 2.0;
        let t59 = z[0][1] * 2.0;
        let t60 = z[0][2] * 2.0;
        let t61 = model.gain * t44;
        let t62 = 1.0 / (2.0 * t46);
        let t63 = t58 * t62;
        let t64 = model.gain * t45;
        let t65 = t43 * ((t61 - t47 * t63) / t46) + t49 * ((t64 - t50 * t63) / t46);
        let t66 = t38 * (t39 * (t65 - t52 * (t53 * t63 / t46)))
            - t54 * (t37 * (t36 * t58 / t35));
        let t67 = t59 * t62;
        let t68 = t49 * ((t61 - t50 * t67) / t46) - t43 * ((t64 + t47 * t67) / t46);
        let t69 = t38 * (t39 * (t68 - t52 * (t53 * t67 / t46)))
            - t54 * (t37 * (t36 * t59 / t35));
        let t70 = t60 * t62;
        let t71 = t52 * ((t61 - t53 * t70) / t46)
            - (t43 * (t47 * t70 / t46) + t49 * (t50 * t70 / t46));
        gradient[0] = -z[1][0];
        gradient[1] = -z[1][1];
        gradient[2] = -z[1][2];
        gradient[3] = t55;
        gradient[4] = t56;
        gradient[5] = t57;
        gradient[12] = z[1][0];
        gradient[13] = z[1][1];
        gradient[14] = z[1][2];
        gradient[15] = -z[2][0];
        gradient[16] = -z[2][1];
        gradient[17] = -z[2][2];
        gradient[21] = t55;
        gradient[22] = t56;
        gradient[23] = t57;
        gradient[27] = z[2][0];
        gradient[28] = z[2][1];
        gradient[29] = z[2][2];
        gradient[30] = -z[3][0];
        gradient[31] = -z[3][1];
        gradient[32] = -z[3][2];
        gradient[39] = t55;
        gradient[40] = t56;
        gradient[41] = t57;
        gradient[42] = z[3][0];
        gradient[43] = z[3][1];
        gradient[44] = z[3][2];
        gradient[45] = t66;
        gradient[46] = t69;
        gradient[47] = t38 * (t39 * t71) - t54 * (t37 * (t36 * t60 / t35));
        gradient[48] = t38 * (t39 * (t41 * t48));
        gradient[49] = t38 * (t39 * (t41 * t51));
        gradient[50] = t38 * (t39 * (t41 * t53));
        gradient[51] = -t38 * (t39 * (t42 * t48));
        gradient[52] = -t38 * (t39 * (t42 * t51));
        gradient[53] = -t38 * (t39 * (t42 * t53));
        gradient[54] = t38 * (t39 * (model.turning * t49));
        gradient[55] = -t38 * (t39 * (model.turning * t43));
    }
    /// Load per length `ring_thrust`: adds the generalised forces on the nodal vectors of one element, int s_a f dx, axes of the body's frame.
    ///
    /// Integrated exactly by constant tensors.
    ///
    /// The form is the cheaper one; weighted operations of force and tangent together: constant tensors 1896, points 1979.
    ///
    /// Operations: 123 additions, 165 multiplications, 3 divisions.
    #[inline(always)]
    pub fn density_force_ring_thrust<T: ::rncf::emitted::lanes::Real>(
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
        let t62 = t34 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t63 = t35 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t64 = t36 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t65 = t34 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t47 * (-0.016666666666666666)
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t66 = t35 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t48 * (-0.016666666666666666)
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t67 = t36 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t49 * (-0.016666666666666666)
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t68 = t65 + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t69 = t66 + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t70 = t67 + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t71 = t34 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t42 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t72 = t35 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t43 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t56 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t73 = t36 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t44 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t74 = t34 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t42 * (-0.1)
            + t47 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t51 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t55 * (-0.1);
        let t75 = t35 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t43 * (-0.1)
            + t48 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t52 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t56 * (-0.1);
        let t76 = t36 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t44 * (-0.1)
            + t49 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t57 * (-0.1);
        let t77 = values[3] * (length * length);
        let t78 = values[3] * length;
        force[0] += (t74 + t59 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t68) * t78;
        force[1] += (t75 + t60 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t69) * t78;
        force[2] += (t76 + t61 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t70) * t78;
        force[3] += (t62 + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[4] += (t63 + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[5] += (t64 + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t77;
        force[6] += t68 * t78;
        force[7] += t69 * t78;
        force[8] += t70 * t78;
        force[9] += (t71 + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
        force[10] += (t72 + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
        force[11] += (t73 + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t77;
    }
    /// [`density_force_ring_thrust`] of four elements side by side.
    pub struct DensityForceRingThrust<'a> {
        pub length: &'a [[f64; 4]; 1],
        pub values: &'a [[f64; 4]; 4],
        pub q: &'a [[f64; 4]; 12],
        pub force: &'a mut [[f64; 4]; 12],
    }
    impl ::rncf::emitted::lanes::Kernel for DensityForceRingThrust<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { length, values, q, force } = self;
            let length = lanes.load_all(length);
            let values = lanes.load_all(values);
            let q = lanes.load_all(q);
            density_force_ring_thrust(&length, &values, &q, force);
        }
    }
    /// Load per length `ring_thrust`: adds the derivatives of the generalised forces with respect to q and to the values, rows first.
    ///
    /// Integrated exactly by constant tensors.
    ///
    /// The form is the cheaper one; weighted operations of force and tangent together: constant tensors 1896, points 1979.
    ///
    /// Operations: 744 additions, 840 multiplications, 3 divisions.
    #[inline(always)]
    pub fn density_tangent_ring_thrust<T: ::rncf::emitted::lanes::Real>(
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
        let t80 = t37 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t69 * (-0.016666666666666666);
        let t81 = t42 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t74 * (-0.016666666666666666);
        let t82 = t45 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t77 * (-0.016666666666666666);
        let t83 = t53 * (-0.1);
        let t84 = t58 * (-0.1);
        let t85 = t61 * (-0.1);
        let t86 = t39 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t71 * (-0.016666666666666666);
        let t87 = t43 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t75 * (-0.016666666666666666);
        let t88 = t46 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t78 * (-0.016666666666666666);
        let t89 = t55 * (-0.1);
        let t90 = t59 * (-0.1);
        let t91 = t62 * (-0.1);
        let t92 = t41 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t73 * (-0.016666666666666666);
        let t93 = t44 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t76 * (-0.016666666666666666);
        let t94 = t47 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t79 * (-0.016666666666666666);
        let t95 = t57 * (-0.1);
        let t96 = t60 * (-0.1);
        let t97 = t63 * (-0.1);
        let t98 = t37 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t99 = t42 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t100 = t45 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t101 = t39 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t102 = t43 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t103 = t46 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t104 = t41 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t105 = t44 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t106 = t47 * CABLE_SPATIAL_DENSITY_IOTA[1][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t107 = t37 * (-0.016666666666666666) + t53 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t108 = t42 * (-0.016666666666666666) + t58 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t109 = t45 * (-0.016666666666666666) + t61 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t110 = t39 * (-0.016666666666666666) + t55 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t111 = t43 * (-0.016666666666666666) + t59 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t112 = t46 * (-0.016666666666666666) + t62 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t113 = t41 * (-0.016666666666666666) + t57 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t114 = t44 * (-0.016666666666666666) + t60 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t115 = t47 * (-0.016666666666666666) + t63 * CABLE_SPATIAL_DENSITY_IOTA[1][4]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t116 = length * length;
        let t117 = values[3] * t116;
        let t118 = values[3] * length;
        let t119 = (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t120 = (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t121 = (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t122 = values[3] * t98;
        let t123 = values[3] * t99;
        let t124 = values[3] * t100;
        let t125 = (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t126 = (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t127 = (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t128 = values[3]
            * (t37 * (-0.1) + t53 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t69 * (-0.1)
                - t98);
        let t129 = values[3]
            * (t42 * (-0.1) + t58 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t74 * (-0.1)
                - t99);
        let t130 = values[3]
            * (t45 * (-0.1) + t61 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t77 * (-0.1)
                - t100);
        let t131 = (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t132 = (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t133 = (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t134 = values[3] * t101;
        let t135 = values[3] * t102;
        let t136 = values[3] * t103;
        let t137 = (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t138 = (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t139 = (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t140 = values[3]
            * (t39 * (-0.1) + t55 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t71 * (-0.1)
                - t101);
        let t141 = values[3]
            * (t43 * (-0.1) + t59 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t75 * (-0.1)
                - t102);
        let t142 = values[3]
            * (t46 * (-0.1) + t62 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t78 * (-0.1)
                - t103);
        let t143 = (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t144 = (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t145 = (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][4]) * t118;
        let t146 = values[3] * t104;
        let t147 = values[3] * t105;
        let t148 = values[3] * t106;
        let t149 = (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t150 = (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t151 = (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][4]) * t118;
        let t152 = values[3]
            * (t41 * (-0.1) + t57 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t73 * (-0.1)
                - t104);
        let t153 = values[3]
            * (t44 * (-0.1) + t60 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t76 * (-0.1)
                - t105);
        let t154 = values[3]
            * (t47 * (-0.1) + t63 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t79 * (-0.1)
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
        let t188 = t159 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t189 = t160 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t190 = t161 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t191 = t159 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t167 * (-0.016666666666666666)
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t192 = t160 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t168 * (-0.016666666666666666)
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t193 = t161 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t169 * (-0.016666666666666666)
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t194 = t191 + t185 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t195 = t192 + t186 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t196 = t193 + t187 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t197 = t159 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t163 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t178 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t198 = t160 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t164 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t179 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t199 = t161 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t165 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t180 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t200 = t159 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t163 * (-0.1)
            + t167 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t174 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t178 * (-0.1);
        let t201 = t160 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t164 * (-0.1)
            + t168 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t175 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t179 * (-0.1);
        let t202 = t161 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t165 * (-0.1)
            + t169 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t176 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t180 * (-0.1);
        let t203 = t155 - t158;
        let t204 = s0_x * t29;
        let t205 = t204 + t204 - t162;
        let t206 = s0_x * s1_x;
        let t207 = t206 + t206 - t166;
        let t208 = t170 - t173;
        let t209 = s1_x * t29;
        let t210 = t209 + t209 - t177;
        let t211 = t181 - t184;
        let t212 = t203 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t207 * (-0.016666666666666666)
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t213 = t212 + t211 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t214 = t203 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t205 * (-0.1)
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t210 * (-0.1);
        let t215 = s0_x * s0_y;
        let t216 = s0_y * t29 + s0_x * t30;
        let t217 = s0_y * s1_x + s0_x * s1_y;
        let t218 = t29 * t30;
        let t219 = s1_x * t30 + s1_y * t29;
        let t220 = s1_x * s1_y;
        let t221 = t215 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t217 * (-0.016666666666666666)
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t222 = t221 + t220 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t223 = t215 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t216 * (-0.1)
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t219 * (-0.1);
        let t224 = t118 * (t223 + t220 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t222);
        let t225 = s0_x * s0_z;
        let t226 = s0_z * t29 + s0_x * t31;
        let t227 = s0_z * s1_x + s0_x * s1_z;
        let t228 = t29 * t31;
        let t229 = s1_x * t31 + s1_z * t29;
        let t230 = s1_x * s1_z;
        let t231 = t225 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t227 * (-0.016666666666666666)
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t232 = t231 + t230 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t233 = t225 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t226 * (-0.1)
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t229 * (-0.1);
        let t234 = t118 * (t233 + t230 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t232);
        let t235 = t156 - t158;
        let t236 = s0_y * t30;
        let t237 = t236 + t236 - t162;
        let t238 = s0_y * s1_y;
        let t239 = t238 + t238 - t166;
        let t240 = t171 - t173;
        let t241 = s1_y * t30;
        let t242 = t241 + t241 - t177;
        let t243 = t182 - t184;
        let t244 = t235 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t239 * (-0.016666666666666666)
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t245 = t244 + t243 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t246 = t235 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t237 * (-0.1)
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t242 * (-0.1);
        let t247 = s0_y * s0_z;
        let t248 = s0_z * t30 + s0_y * t31;
        let t249 = s0_z * s1_y + s0_y * s1_z;
        let t250 = t30 * t31;
        let t251 = s1_y * t31 + s1_z * t30;
        let t252 = s1_y * s1_z;
        let t253 = t247 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t249 * (-0.016666666666666666)
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t254 = t253 + t252 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t255 = t247 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t248 * (-0.1)
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t251 * (-0.1);
        let t256 = t118 * (t255 + t252 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t254);
        let t257 = t157 - t158;
        let t258 = s0_z * t31;
        let t259 = t258 + t258 - t162;
        let t260 = s0_z * s1_z;
        let t261 = t260 + t260 - t166;
        let t262 = t172 - t173;
        let t263 = s1_z * t31;
        let t264 = t263 + t263 - t177;
        let t265 = t183 - t184;
        let t266 = t257 * CABLE_SPATIAL_DENSITY_IOTA[1][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[1][1] + t261 * (-0.016666666666666666)
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[1][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[1][4];
        let t267 = t266 + t265 * CABLE_SPATIAL_DENSITY_IOTA[1][5];
        let t268 = t257 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t259 * (-0.1)
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[3][3] + t264 * (-0.1);
        let t269 = t203 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t270 = t215 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t271 = t117 * (t270 + t220 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t272 = t225 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t273 = t117 * (t272 + t230 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t274 = t235 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t275 = t247 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t276 = t117 * (t275 + t252 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        let t277 = t257 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[0][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[0][4];
        let t278 = t118 * t222;
        let t279 = t118 * t232;
        let t280 = t118 * t254;
        let t281 = t203 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t205 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t207 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t208 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t210 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t282 = t215 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t216 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t217 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t218 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t219 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t283 = t117 * (t282 + t220 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t284 = t225 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t226 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t227 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t228 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t229 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t285 = t117 * (t284 + t230 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t286 = t235 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t237 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t239 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t240 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t242 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t287 = t247 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t248 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t249 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t250 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t251 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        let t288 = t117 * (t287 + t252 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        let t289 = t257 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
            + t259 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
            + t261 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
            + t262 * CABLE_SPATIAL_DENSITY_IOTA[2][3]
            + t264 * CABLE_SPATIAL_DENSITY_IOTA[2][4];
        by_q[0] -= t128;
        by_q[1] -= t140;
        by_q[2] -= t152;
        by_q[3]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t83
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t80) * t118;
        by_q[4]
            += t118
                * (t39 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t89
                    + t71 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t86);
        by_q[5]
            += t118
                * (t41 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t95
                    + t73 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t92);
        by_q[6] += t128;
        by_q[7] += t140;
        by_q[8] += t152;
        by_q[9]
            += t118
                * (t83 + t37 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t69 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t107);
        by_q[10]
            += t118
                * (t89 + t39 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t71 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t110);
        by_q[11]
            += t118
                * (t95 + t41 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t73 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t113);
        by_q[12] -= t129;
        by_q[13] -= t141;
        by_q[14] -= t153;
        by_q[15]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t84
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t81) * t118;
        by_q[16]
            += t118
                * (t43 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t90
                    + t75 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t87);
        by_q[17]
            += t118
                * (t44 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t96
                    + t76 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t93);
        by_q[18] += t129;
        by_q[19] += t141;
        by_q[20] += t153;
        by_q[21]
            += t118
                * (t84 + t42 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t74 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t108);
        by_q[22]
            += t118
                * (t90 + t43 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t75 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t111);
        by_q[23]
            += t118
                * (t96 + t44 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t76 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t114);
        by_q[24] -= t130;
        by_q[25] -= t142;
        by_q[26] -= t154;
        by_q[27]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t85
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t82) * t118;
        by_q[28]
            += t118
                * (t46 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t91
                    + t78 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t88);
        by_q[29]
            += t118
                * (t47 * CABLE_SPATIAL_DENSITY_IOTA[3][0] + t97
                    + t79 * CABLE_SPATIAL_DENSITY_IOTA[3][2] - t94);
        by_q[30] += t130;
        by_q[31] += t142;
        by_q[32] += t154;
        by_q[33]
            += t118
                * (t85 + t45 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t77 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t109);
        by_q[34]
            += t118
                * (t91 + t46 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t78 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t112);
        by_q[35]
            += t118
                * (t97 + t47 * CABLE_SPATIAL_DENSITY_IOTA[3][2]
                    + t79 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t115);
        by_q[36] -= t119;
        by_q[37] -= t131;
        by_q[38] -= t143;
        by_q[39]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[40]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[41]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[42] += t119;
        by_q[43] += t131;
        by_q[44] += t143;
        by_q[45]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[46]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[47]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[48] -= t120;
        by_q[49] -= t132;
        by_q[50] -= t144;
        by_q[51]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[52]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[53]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[54] += t120;
        by_q[55] += t132;
        by_q[56] += t144;
        by_q[57]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[58]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[59]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[60] -= t121;
        by_q[61] -= t133;
        by_q[62] -= t145;
        by_q[63]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[64]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[65]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][0]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][1]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][2]) * t117;
        by_q[66] += t121;
        by_q[67] += t133;
        by_q[68] += t145;
        by_q[69]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[70]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
        by_q[71]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[0][2]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[0][4]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[0][5]) * t117;
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
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[112]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[113]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[114] += t125;
        by_q[115] += t137;
        by_q[116] += t149;
        by_q[117]
            += (t37 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t53 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t69 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[118]
            += (t39 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t55 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t71 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[119]
            += (t41 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t57 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t73 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[120] -= t126;
        by_q[121] -= t138;
        by_q[122] -= t150;
        by_q[123]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[124]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[125]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[126] += t126;
        by_q[127] += t138;
        by_q[128] += t150;
        by_q[129]
            += (t42 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t58 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t74 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[130]
            += (t43 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t59 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t75 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[131]
            += (t44 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t60 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t76 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[132] -= t127;
        by_q[133] -= t139;
        by_q[134] -= t151;
        by_q[135]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[136]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[137]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][0]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][1]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][2]) * t117;
        by_q[138] += t127;
        by_q[139] += t139;
        by_q[140] += t151;
        by_q[141]
            += (t45 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t61 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t77 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[142]
            += (t46 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t62 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t78 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_q[143]
            += (t47 * CABLE_SPATIAL_DENSITY_IOTA[2][2]
                + t63 * CABLE_SPATIAL_DENSITY_IOTA[2][4]
                + t79 * CABLE_SPATIAL_DENSITY_IOTA[2][5]) * t117;
        by_values[0] += t118 * (t214 + t211 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t213);
        by_values[1] += t224;
        by_values[2] += t234;
        by_values[3] += length * (t200 + t185 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t194);
        by_values[4] += t224;
        by_values[5] += t118 * (t246 + t243 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t245);
        by_values[6] += t256;
        by_values[7] += length * (t201 + t186 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t195);
        by_values[8] += t234;
        by_values[9] += t256;
        by_values[10] += t118 * (t268 + t265 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t267);
        by_values[11]
            += length * (t202 + t187 * CABLE_SPATIAL_DENSITY_IOTA[3][0] - t196);
        by_values[12] += t117 * (t269 + t211 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[13] += t271;
        by_values[14] += t273;
        by_values[15] += t116 * (t188 + t185 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[16] += t271;
        by_values[17] += t117 * (t274 + t243 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[18] += t276;
        by_values[19] += t116 * (t189 + t186 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[20] += t273;
        by_values[21] += t276;
        by_values[22] += t117 * (t277 + t265 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
        by_values[23] += t116 * (t190 + t187 * CABLE_SPATIAL_DENSITY_IOTA[0][5]);
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
        by_values[36] += t117 * (t281 + t211 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[37] += t283;
        by_values[38] += t285;
        by_values[39] += t116 * (t197 + t185 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[40] += t283;
        by_values[41] += t117 * (t286 + t243 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[42] += t288;
        by_values[43] += t116 * (t198 + t186 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[44] += t285;
        by_values[45] += t288;
        by_values[46] += t117 * (t289 + t265 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
        by_values[47] += t116 * (t199 + t187 * CABLE_SPATIAL_DENSITY_IOTA[2][5]);
    }
    /// [`density_tangent_ring_thrust`] of four elements side by side.
    pub struct DensityTangentRingThrust<'a> {
        pub length: &'a [[f64; 4]; 1],
        pub values: &'a [[f64; 4]; 4],
        pub q: &'a [[f64; 4]; 12],
        pub by_q: &'a mut [[f64; 4]; 144],
        pub by_values: &'a mut [[f64; 4]; 48],
    }
    impl ::rncf::emitted::lanes::Kernel for DensityTangentRingThrust<'_> {
        #[inline(always)]
        fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {
            let Self { length, values, q, by_q, by_values } = self;
            let length = lanes.load_all(length);
            let values = lanes.load_all(values);
            let q = lanes.load_all(q);
            density_tangent_ring_thrust(&length, &values, &q, by_q, by_values);
        }
    }
    /// Gravity field `sun`: g(z, t), m/s^2, inertial axes.
    ///
    /// Of `sun`: `z[0]` a point of `sail` (inertial axes).
    ///
    /// Operations: 2 additions, 8 multiplications, 3 divisions, 1 function calls.
    pub fn field_sun(
        model: &EsailTilted,
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
        model: &EsailTilted,
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
        pub model: EsailTilted,
        /// How often each loop is gone through.
        pub counts: [usize; 1],
        /// Number of the first repetition of every body.
        pub firsts: [usize; 2],
        /// Number of the first repetition of every joint.
        pub first_joints: [usize; 1],
        pub row_main: ::std::vec::Vec<CableSpatial>,
        pub row_aux: ::std::vec::Vec<CableSpatial>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &EsailTilted) -> Self {
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
                    marker: 3,
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
                    marker: 3,
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
                    marker: 3,
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
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 1,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 2,
                });
            specs
                .push(::rncf::emitted::ObservedSpec::Marker {
                    marker: 0,
                    derivative: 0,
                    component: 0,
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
            specs
        }
        fn output_columns(&self) -> usize {
            5
        }
        fn frame_count(&self) -> usize {
            3
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "tilted", "sail"][frame]
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
            frame_tilted(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            let model = &self.model;
            let (plain, mut rest) = observed.split_at(9);
            let mut seen = [0.0; 11];
            seen[..9].copy_from_slice(plain);
            seen[9] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Max,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_0(model, t, index, observed, &mut value);
                    value[0]
                },
            );
            seen[10] = ::rncf::emitted::reduce(
                ::rncf::emitted::Reduction::Min,
                self.counts[0],
                1,
                &mut rest,
                |index, observed| {
                    let mut value = [0.0];
                    outputs_of_one_1(model, t, index, observed, &mut value);
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
                    model.remote_mass,
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
                    frame: 2,
                    parent: 1,
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
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 2,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [1.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 0.0, 1.0],
                },
                ::rncf::emitted::MarkerSpec::Point {
                    frame: 0,
                    at: [0.0, 0.0, 0.0],
                },
                ::rncf::emitted::MarkerSpec::Turn {
                    frame: 2,
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
                        frame: 2,
                        axes: &[0, 1, 2],
                        line: ::rncf::emitted::Line::Straight {
                            from: [
                                5.0
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .cos(),
                                5.0
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .sin(),
                                0.0,
                            ],
                            to: [
                                (model.length + 5.0)
                                    * (index * 6.283185307179586 / (model.tethers as f64))
                                        .cos(),
                                (model.length + 5.0)
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
                        frame: 2,
                        axes: &[0, 1, 2],
                        line: ::rncf::emitted::Line::Straight {
                            from: [0.0, 0.0, 0.0],
                            to: [
                                6.283185307179586 * (model.length + 5.0)
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
                    let row = CableSpatial {
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
                    let row = CableSpatial {
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
                    frame: 2,
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
                            model.remote_mass,
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
                    cable_spatial_mass(
                        &self.row_main[instance],
                        ::rncf::emitted::array_mut(mass),
                    );
                }
                _ => {
                    cable_spatial_mass(
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
                    cable_spatial_elastic_force(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(force),
                    );
                }
                _ => {
                    cable_spatial_elastic_force(
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
                    cable_spatial_elastic_tangent(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        ::rncf::emitted::array_mut(stiffness),
                    );
                }
                _ => {
                    cable_spatial_elastic_tangent(
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
                    let four = CableSpatialElasticForce {
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
                    let four = CableSpatialElasticForce {
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
                    let four = CableSpatialElasticTangent {
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
                    let four = CableSpatialElasticTangent {
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
                    cable_spatial_strain_energy(
                        &self.row_main[instance],
                        ::rncf::emitted::array(q),
                        &mut energy,
                    );
                }
                _ => {
                    cable_spatial_strain_energy(
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
                            cable_spatial_shapes_position_0(
                                self.row_main[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 1) => {
                            cable_spatial_shapes_position_1(
                                self.row_main[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 2) => {
                            cable_spatial_shapes_position_2(
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
                            cable_spatial_shapes_position_0(
                                self.row_aux[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 1) => {
                            cable_spatial_shapes_position_1(
                                self.row_aux[instance].length,
                                xi,
                                ::rncf::emitted::array_mut(weights),
                            )
                        }
                        (::rncf::emitted::Interpolant::Position, 2) => {
                            cable_spatial_shapes_position_2(
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
                    cable_spatial_field_forces(
                        &self.row_main[instance],
                        ::rncf::emitted::array(stress_free),
                        ::rncf::emitted::array(fields),
                        ::rncf::emitted::array_mut(forces),
                    );
                }
                _ => {
                    cable_spatial_field_forces(
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
                        frame: 2,
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
                        markers: &[0],
                    },
                    frame: 2,
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
    impl ::rncf::emitted::WithoutMarkerConstraints for Equations {}
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
                        markers: &[0, 1, 2, 3, 4],
                        values: 4,
                    });
            }
            for instance in 0..self.counts[0] {
                let index = instance as f64;
                specs
                    .push(::rncf::emitted::DensitySpec {
                        name: "ring_thrust",
                        kind: 1,
                        body: self.first(1) + instance,
                        markers: &[0, 1, 2, 3, 4],
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
                &[self.counts[0], self.counts[0]],
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
                1 => {
                    density_values_ring_thrust(
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
                &[self.counts[0], self.counts[0]],
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
                1 => {
                    density_gradient_ring_thrust(
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
            let (density, _) = ::rncf::emitted::declared(
                &[self.counts[0], self.counts[0]],
                density,
            );
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
                1 => {
                    let length = elements
                        .map(|(body, _)| self.row_aux[self.kind(body).1].length);
                    let four = DensityForceRingThrust {
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
                            density_force_ring_thrust(
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
            let (density, _) = ::rncf::emitted::declared(
                &[self.counts[0], self.counts[0]],
                density,
            );
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
                1 => {
                    let length = elements
                        .map(|(body, _)| self.row_aux[self.kind(body).1].length);
                    let four = DensityTangentRingThrust {
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
                            density_tangent_ring_thrust(
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
