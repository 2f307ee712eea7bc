//! Expansion of `models/src/motor.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end
/// carries an unbalanced disc in its middle.
///
/// # Chosen and left out
///
/// * Body `shaft` uses `beam_spatial_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1929 and 23641).
/// * Body `shaft` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.
/// * Body `shaft`: its axis is straight: no stress-free curvature for each element.
/// * Body `shaft` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.
/// * Joint `drive_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
/// * Joint `far_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.
/// * Fixture `disc` adds constants to the inertia of `shaft` and no unknowns.
/// * Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.
/// * Not declared, so that no function is written for it: free frames and rigid bodies, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.
/// * Energy-momentum integration: no forces that conserve energy are emitted, as body `shaft` is damped.
#[derive(Clone, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct Motor {
    /// Steady angular velocity. (SI; declared in rpm)
    pub speed: f64,
    /// Time to reach it. (SI; declared in s)
    pub T_s: f64,
    /// Number of elements; an even one has a node under the disc. (count)
    pub elements: usize,
    /// Damping time of the shaft's strains. (SI; declared in s)
    pub damping: f64,
    /// Distance of the disc's centre from the axis, along y. (SI; declared in mm)
    pub eccentricity: f64,
}
#[allow(clippy::all)]
impl Default for Motor {
    fn default() -> Self {
        Self {
            speed: 1047.1975511965977,
            T_s: 1.0,
            elements: 4,
            damping: 0.0,
            eccentricity: 0.05,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for Motor {
    const NAME: &'static str = "Motor";
    const DOC: &'static str = "High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end\ncarries an unbalanced disc in its middle.";
    const SOURCE: &'static str = r#"pub model Motor {
    /// Steady angular velocity.
    param speed = 10000 rpm;
    /// Time to reach it.
    param T_s = 1 s;
    /// Number of elements; an even one has a node under the disc.
    param elements: count = 4;
    /// Damping time of the shaft's strains.
    param damping = 0 s;
    /// Distance of the disc's centre from the axis, along y.
    param eccentricity = 50 mm;

    const length = 1.02 m;
    const disc_radius = 0.1 m;
    const disc_thickness = 10 mm;
    const disc_mass = 7800 [kg/m^3] * pi * disc_radius^2 * disc_thickness;

    material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; damping = damping; yield = 355 MPa; }
    section round = circle(radius = 50 mm);

    /// Angle of the motor, Eq. (22).
    motion theta(t) =
        if t <= T_s { (speed/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { speed * (t - T_s/2) };
    frame rotor = rotating(axis = x, angle = theta(t));

    body shaft in rotor {
        spatial;
        line from [0, 0, 0] m to [length, 0, 0];
        mesh elements * beam(round, steel);
    }
    joint drive_end = clamp(shaft.start, rotor);
    joint far_end = pin(shaft.end, rotor);
    fixture disc on shaft.at(length / 2) {
        mass = disc_mass;
        center = [0 m, eccentricity, 0 m];
        inertia = [
            disc_mass * disc_radius^2 / 2,
            disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
            disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
        ];
    }

    /// Deflection of the shaft's middle towards the disc's centre, in the rotating frame.
    output v_mid = shaft.at(length / 2).y;
    /// Deflection of the shaft's middle across it.
    output w_mid = shaft.at(length / 2).z;
    /// Bending moment in the clamp.
    output clamp_moment = shaft.start.moment_z;
    /// Largest stress in the clamp.
    output clamp_stress = shaft.start.stress;

    run { t_end = 1.2 s; every = 1 ms; }
}"#;
    const NOTES: &'static [&'static str] = &[
        "Body `shaft` uses `beam_spatial_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1929 and 23641).",
        "Body `shaft` has nodal vectors for the section's y and z axes (r0y, r0z, ry_half, rz_half, r1y, r1z): sections shear, twist and have rotary inertia.",
        "Body `shaft`: its axis is straight: no stress-free curvature for each element.",
        "Body `shaft` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.",
        "Joint `drive_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Joint `far_end`: its conditions are linear in the nodal vectors of `shaft` and eliminated, neither unknowns nor multipliers; they do not change with time, so that there are no functions for their rates.",
        "Fixture `disc` adds constants to the inertia of `shaft` and no unknowns.",
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes alone, and there are none.",
        "Not declared, so that no function is written for it: free frames and rigid bodies, constraints with multipliers, springs and forces on moving places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, starts in equilibrium, cautions.",
        "Energy-momentum integration: no forces that conserve energy are emitted, as body `shaft` is damped.",
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "speed",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rpm",
                unit_si: 0.10471975511965977,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 1047.1975511965977,
                doc: "Steady angular velocity.",
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
                default: 4.0,
                doc: "Number of elements; an even one has a node under the disc.",
            },
            ::rncf::Param {
                name: "damping",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 0.0,
                doc: "Damping time of the shaft's strains.",
            },
            ::rncf::Param {
                name: "eccentricity",
                kind: ::rncf::ParamKind::Quantity,
                unit: "mm",
                unit_si: 0.001,
                dimension: [1, 0, 0, 0, 0, 0],
                default: 0.05,
                doc: "Distance of the disc's centre from the axis, along y.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "v_mid",
                unit: "m",
                components: &[],
                doc: "Deflection of the shaft's middle towards the disc's centre, in the rotating frame.",
            },
            ::rncf::Output {
                name: "w_mid",
                unit: "m",
                components: &[],
                doc: "Deflection of the shaft's middle across it.",
            },
            ::rncf::Output {
                name: "clamp_moment",
                unit: "N m",
                components: &[],
                doc: "Bending moment in the clamp.",
            },
            ::rncf::Output {
                name: "clamp_stress",
                unit: "Pa",
                components: &[],
                doc: "Largest stress in the clamp.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.speed,
            1 => self.T_s,
            2 => self.elements as f64,
            3 => self.damping,
            4 => self.eccentricity,
            _ => panic!("Motor has 5 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.speed = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            3 => self.damping = value,
            4 => self.eccentricity = value,
            _ => panic!("Motor has 5 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
        };
        motor_equations::run_defaults(self, &mut run);
        run
    }
    fn build_as(
        &self,
        formulation: ::rncf::Formulation,
        joints: ::rncf::Joints,
        fidelity: &[(::std::string::String, ::rncf::mesh::Fidelity)],
    ) -> ::std::result::Result<
        ::std::boxed::Box<dyn ::rncf::Scene>,
        ::rncf::ModelError,
    > {
        ::rncf::mesh::check_params(self)?;
        let equations = motor_equations::Equations::new(self);
        ::rncf::mesh::build_as(equations, formulation, joints, fidelity)
    }
}
/// Equations of [`Motor`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod motor_equations {
    /// Constants of one element `beam_spatial_damped`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1929 and 23641).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatialDamped {
        /// Length, m.
        pub length: f64,
        /// young * area, N.
        pub EA: f64,
        /// shear_factor_y * shear_modulus * area, N.
        pub kyGA: f64,
        /// shear_factor_z * shear_modulus * area, N.
        pub kzGA: f64,
        /// shear_modulus * area, N.
        pub GA: f64,
        /// young * second_moment_z, N m^2.
        pub EIz: f64,
        /// young * second_moment_y, N m^2.
        pub EIy: f64,
        /// shear_modulus * torsion_constant, N m^2.
        pub GJ: f64,
        /// shear_modulus * second_moment_z, N m^2.
        pub GIz: f64,
        /// shear_modulus * second_moment_y, N m^2.
        pub GIy: f64,
        /// density * area, kg/m.
        pub rhoA: f64,
        /// density * second_moment_z, kg m.
        pub rhoIz: f64,
        /// density * second_moment_y, kg m.
        pub rhoIy: f64,
        /// Damping of the strain measures, s.
        pub damping: f64,
    }
    /// Nodal vectors by what they interpolate: Position, SectionY, SectionZ.
    static BEAM_SPATIAL_DAMPED_VECTORS: ::rncf::mesh::Vectors<10, 3, 3, 3> = ::rncf::mesh::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Gauss rule with 3 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_DAMPED_POINTS3: ::rncf::mesh::Rule<3, 3, 3> = ::rncf::mesh::Rule {
        groups: [0, 1, 2],
        weights: [0.2777777777777776, 0.4444444444444444, 0.2777777777777776],
        shapes: [
            [
                [0.5872983346207417, 0.6, -0.18729833462074166],
                [0.6872983346207417, 0.39999999999999997, -0.08729833462074169],
                [0.6872983346207417, 0.39999999999999997, -0.08729833462074169],
            ],
            [[-0.25, 1.5, -0.25], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            [
                [-0.18729833462074175, 0.6, 0.5872983346207418],
                [-0.08729833462074166, 0.39999999999999997, 0.6872983346207417],
                [-0.08729833462074166, 0.39999999999999997, 0.6872983346207417],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_DAMPED_POINTS3_STIFFNESS: ::rncf::mesh::Blocks<3, 9, 9> = BEAM_SPATIAL_DAMPED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)],
            &[
                (0, 0, 1),
                (1, 1, 2),
                (2, 2, 3),
                (3, 3, 4),
                (4, 4, 5),
                (5, 5, 6),
                (6, 6, 7),
                (7, 7, 8),
                (8, 8, 9),
            ],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_DAMPED_POINTS3_DAMPING: ::rncf::mesh::Blocks<3, 9, 6> = BEAM_SPATIAL_DAMPED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Gauss rule with 2 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_DAMPED_POINTS2: ::rncf::mesh::Rule<2, 5, 3> = ::rncf::mesh::Rule {
        groups: [0, 1, 2, 1, 2],
        weights: [0.5000000000000001, 0.5000000000000001],
        shapes: [
            [
                [0.28867513459481287, 1.0, -0.2886751345948129],
                [0.4553418012614795, 0.6666666666666667, -0.12200846792814622],
                [0.4553418012614795, 0.6666666666666667, -0.12200846792814622],
                [-2.1547005383792515, 2.309401076758503, -0.15470053837925146],
                [-2.1547005383792515, 2.309401076758503, -0.15470053837925146],
            ],
            [
                [-0.2886751345948131, 1.0000000000000004, 0.28867513459481264],
                [-0.12200846792814612, 0.6666666666666667, 0.4553418012614795],
                [-0.12200846792814612, 0.6666666666666667, 0.4553418012614795],
                [0.15470053837925146, -2.309401076758503, 2.1547005383792515],
                [0.15470053837925146, -2.309401076758503, 2.1547005383792515],
            ],
        ],
    };
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_DAMPED_POINTS2_STIFFNESS: ::rncf::mesh::Blocks<2, 9, 21> = BEAM_SPATIAL_DAMPED_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 3),
                (0, 4),
                (3, 0),
                (1, 1),
                (1, 3),
                (3, 1),
                (3, 3),
                (1, 2),
                (1, 4),
                (3, 2),
                (3, 4),
                (4, 0),
                (2, 1),
                (2, 3),
                (4, 1),
                (4, 3),
                (2, 2),
                (2, 4),
                (4, 2),
                (4, 4),
            ],
            &[
                (0, 0, 1),
                (1, 1, 2),
                (2, 2, 3),
                (3, 3, 4),
                (4, 4, 8),
                (5, 8, 12),
                (6, 12, 13),
                (7, 13, 17),
                (8, 17, 21),
            ],
        );
    /// Blocks that the tangent's kernel writes, by pairs of fields.
    static BEAM_SPATIAL_DAMPED_POINTS2_DAMPING: ::rncf::mesh::Blocks<2, 9, 15> = BEAM_SPATIAL_DAMPED_POINTS2
        .blocks(
            &[
                (0, 0),
                (0, 3),
                (0, 4),
                (1, 1),
                (1, 3),
                (3, 1),
                (3, 3),
                (1, 2),
                (1, 4),
                (3, 2),
                (3, 4),
                (2, 2),
                (2, 4),
                (4, 2),
                (4, 4),
            ],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 7), (4, 7, 11), (5, 11, 15)],
        );
    /// Writes the forces on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 63 additions, 106 multiplications.
    pub fn beam_spatial_damped_points3_force(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t36 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t37 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t38 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t39 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t40 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t41 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t42 = length * EA;
        let t43 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t36 + t36));
        let t44 = 0.5 * (t42 * t43);
        let t45 = length * kyGA * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t37);
        let t46 = length * kzGA * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t38);
        let t47 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t48 = 0.5 * (t42 * t47);
        let t49 = length * GA * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t40);
        let t50 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t41 + t41));
        let t51 = 0.5 * (t42 * t50);
        forces[0][0] = t44 * (a_x * 2.0) + b_x * t45 + c_x * t46;
        forces[0][1] = t44 * (a_y * 2.0) + b_y * t45 + c_y * t46;
        forces[0][2] = t44 * (a_z * 2.0) + b_z * t45 + c_z * t46;
        forces[1][0] = a_x * t45 + t48 * (b_x * 2.0) + c_x * t49;
        forces[1][1] = a_y * t45 + t48 * (b_y * 2.0) + c_y * t49;
        forces[1][2] = a_z * t45 + t48 * (b_z * 2.0) + c_z * t49;
        forces[2][0] = a_x * t46 + b_x * t49 + t51 * (c_x * 2.0);
        forces[2][1] = a_y * t46 + b_y * t49 + t51 * (c_y * 2.0);
        forces[2][2] = a_z * t46 + b_z * t49 + t51 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 189 additions, 396 multiplications.
    pub fn beam_spatial_damped_points3_tangent(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        rates: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 9],
        damping_matrix: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z]] = *rates;
        let t36 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t37 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t38 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t39 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t40 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t41 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t42 = length * EA;
        let t43 = length * kyGA;
        let t44 = length * kzGA;
        let t45 = length * GA;
        let t46 = 0.5 * (0.5 * t42);
        let t47 = 0.5 * (t42 * (damping * 0.5));
        let t48 = damping * t43;
        let t49 = damping * t44;
        let t50 = damping * t45;
        let t51 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t36 + t36));
        let t52 = t43 * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t37);
        let t53 = t44 * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t38);
        let t54 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t55 = t45 * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t40);
        let t56 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t41 + t41));
        let t57 = a_x * 2.0;
        let t58 = a_y * 2.0;
        let t59 = a_z * 2.0;
        let t60 = b_x * 2.0;
        let t61 = b_y * 2.0;
        let t62 = b_z * 2.0;
        let t63 = c_x * 2.0;
        let t64 = c_y * 2.0;
        let t65 = c_z * 2.0;
        let t66 = t46 * t57 + t47 * (v_a_x * 2.0);
        let t67 = t46 * t58 + t47 * (v_a_y * 2.0);
        let t68 = t46 * t59 + t47 * (v_a_z * 2.0);
        let t69 = b_x * t43 + v_b_x * t48;
        let t70 = b_y * t43 + v_b_y * t48;
        let t71 = b_z * t43 + v_b_z * t48;
        let t72 = a_x * t43 + v_a_x * t48;
        let t73 = a_y * t43 + v_a_y * t48;
        let t74 = a_z * t43 + v_a_z * t48;
        let t75 = c_x * t44 + v_c_x * t49;
        let t76 = c_y * t44 + v_c_y * t49;
        let t77 = c_z * t44 + v_c_z * t49;
        let t78 = a_x * t44 + v_a_x * t49;
        let t79 = a_y * t44 + v_a_y * t49;
        let t80 = a_z * t44 + v_a_z * t49;
        let t81 = t46 * t60 + t47 * (v_b_x * 2.0);
        let t82 = t46 * t61 + t47 * (v_b_y * 2.0);
        let t83 = t46 * t62 + t47 * (v_b_z * 2.0);
        let t84 = c_x * t45 + v_c_x * t50;
        let t85 = c_y * t45 + v_c_y * t50;
        let t86 = c_z * t45 + v_c_z * t50;
        let t87 = b_x * t45 + v_b_x * t50;
        let t88 = b_y * t45 + v_b_y * t50;
        let t89 = b_z * t45 + v_b_z * t50;
        let t90 = t46 * t63 + t47 * (v_c_x * 2.0);
        let t91 = t46 * t64 + t47 * (v_c_y * 2.0);
        let t92 = t46 * t65 + t47 * (v_c_z * 2.0);
        let t93 = 0.5 * (t42 * t51) * 2.0;
        let t94 = 0.5 * (t42 * t54) * 2.0;
        let t95 = 0.5 * (t42 * t56) * 2.0;
        let t96 = t47 * t58;
        let t97 = t47 * t59;
        let t98 = b_y * t48;
        let t99 = b_z * t48;
        let t100 = a_x * t48;
        let t101 = a_y * t48;
        let t102 = a_z * t48;
        let t103 = c_y * t49;
        let t104 = c_z * t49;
        let t105 = a_x * t49;
        let t106 = a_y * t49;
        let t107 = a_z * t49;
        let t108 = t47 * t61;
        let t109 = t47 * t62;
        let t110 = c_y * t50;
        let t111 = c_z * t50;
        let t112 = b_x * t50;
        let t113 = b_y * t50;
        let t114 = b_z * t50;
        let t115 = t47 * t64;
        let t116 = t47 * t65;
        let t117 = t57 * t96 + b_x * t98 + c_x * t103;
        let t118 = t57 * t97 + b_x * t99 + c_x * t104;
        let t119 = t58 * t97 + b_y * t99 + c_y * t104;
        let t120 = a_x * t101 + t60 * t108 + c_x * t110;
        let t121 = a_x * t102 + t60 * t109 + c_x * t111;
        let t122 = a_y * t102 + t61 * t109 + c_y * t111;
        let t123 = a_x * t106 + b_x * t113 + t63 * t115;
        let t124 = a_x * t107 + b_x * t114 + t63 * t116;
        let t125 = a_y * t107 + b_y * t114 + t64 * t116;
        stiffness[0][0] = t57 * t66 + b_x * t69 + c_x * t75 + t93;
        stiffness[0][1] = t57 * t67 + b_x * t70 + c_x * t76;
        stiffness[0][2] = t57 * t68 + b_x * t71 + c_x * t77;
        stiffness[0][3] = t58 * t66 + b_y * t69 + c_y * t75;
        stiffness[0][4] = t58 * t67 + b_y * t70 + c_y * t76 + t93;
        stiffness[0][5] = t58 * t68 + b_y * t71 + c_y * t77;
        stiffness[0][6] = t59 * t66 + b_z * t69 + c_z * t75;
        stiffness[0][7] = t59 * t67 + b_z * t70 + c_z * t76;
        stiffness[0][8] = t59 * t68 + b_z * t71 + c_z * t77 + t93;
        stiffness[1][0] = t52 + b_x * t72;
        stiffness[1][1] = b_x * t73;
        stiffness[1][2] = b_x * t74;
        stiffness[1][3] = b_y * t72;
        stiffness[1][4] = t52 + b_y * t73;
        stiffness[1][5] = b_y * t74;
        stiffness[1][6] = b_z * t72;
        stiffness[1][7] = b_z * t73;
        stiffness[1][8] = t52 + b_z * t74;
        stiffness[2][0] = t53 + c_x * t78;
        stiffness[2][1] = c_x * t79;
        stiffness[2][2] = c_x * t80;
        stiffness[2][3] = c_y * t78;
        stiffness[2][4] = t53 + c_y * t79;
        stiffness[2][5] = c_y * t80;
        stiffness[2][6] = c_z * t78;
        stiffness[2][7] = c_z * t79;
        stiffness[2][8] = t53 + c_z * t80;
        stiffness[3][0] = t52 + a_x * t69;
        stiffness[3][1] = a_x * t70;
        stiffness[3][2] = a_x * t71;
        stiffness[3][3] = a_y * t69;
        stiffness[3][4] = t52 + a_y * t70;
        stiffness[3][5] = a_y * t71;
        stiffness[3][6] = a_z * t69;
        stiffness[3][7] = a_z * t70;
        stiffness[3][8] = t52 + a_z * t71;
        stiffness[4][0] = a_x * t72 + t60 * t81 + c_x * t84 + t94;
        stiffness[4][1] = a_x * t73 + t60 * t82 + c_x * t85;
        stiffness[4][2] = a_x * t74 + t60 * t83 + c_x * t86;
        stiffness[4][3] = a_y * t72 + t61 * t81 + c_y * t84;
        stiffness[4][4] = a_y * t73 + t61 * t82 + c_y * t85 + t94;
        stiffness[4][5] = a_y * t74 + t61 * t83 + c_y * t86;
        stiffness[4][6] = a_z * t72 + t62 * t81 + c_z * t84;
        stiffness[4][7] = a_z * t73 + t62 * t82 + c_z * t85;
        stiffness[4][8] = a_z * t74 + t62 * t83 + c_z * t86 + t94;
        stiffness[5][0] = t55 + c_x * t87;
        stiffness[5][1] = c_x * t88;
        stiffness[5][2] = c_x * t89;
        stiffness[5][3] = c_y * t87;
        stiffness[5][4] = t55 + c_y * t88;
        stiffness[5][5] = c_y * t89;
        stiffness[5][6] = c_z * t87;
        stiffness[5][7] = c_z * t88;
        stiffness[5][8] = t55 + c_z * t89;
        stiffness[6][0] = t53 + a_x * t75;
        stiffness[6][1] = a_x * t76;
        stiffness[6][2] = a_x * t77;
        stiffness[6][3] = a_y * t75;
        stiffness[6][4] = t53 + a_y * t76;
        stiffness[6][5] = a_y * t77;
        stiffness[6][6] = a_z * t75;
        stiffness[6][7] = a_z * t76;
        stiffness[6][8] = t53 + a_z * t77;
        stiffness[7][0] = t55 + b_x * t84;
        stiffness[7][1] = b_x * t85;
        stiffness[7][2] = b_x * t86;
        stiffness[7][3] = b_y * t84;
        stiffness[7][4] = t55 + b_y * t85;
        stiffness[7][5] = b_y * t86;
        stiffness[7][6] = b_z * t84;
        stiffness[7][7] = b_z * t85;
        stiffness[7][8] = t55 + b_z * t86;
        stiffness[8][0] = a_x * t78 + b_x * t87 + t63 * t90 + t95;
        stiffness[8][1] = a_x * t79 + b_x * t88 + t63 * t91;
        stiffness[8][2] = a_x * t80 + b_x * t89 + t63 * t92;
        stiffness[8][3] = a_y * t78 + b_y * t87 + t64 * t90;
        stiffness[8][4] = a_y * t79 + b_y * t88 + t64 * t91 + t95;
        stiffness[8][5] = a_y * t80 + b_y * t89 + t64 * t92;
        stiffness[8][6] = a_z * t78 + b_z * t87 + t65 * t90;
        stiffness[8][7] = a_z * t79 + b_z * t88 + t65 * t91;
        stiffness[8][8] = a_z * t80 + b_z * t89 + t65 * t92 + t95;
        damping_matrix[0][0] = t57 * (t47 * t57) + b_x * (b_x * t48) + c_x * (c_x * t49);
        damping_matrix[0][1] = t117;
        damping_matrix[0][2] = t118;
        damping_matrix[0][3] = t117;
        damping_matrix[0][4] = t58 * t96 + b_y * t98 + c_y * t103;
        damping_matrix[0][5] = t119;
        damping_matrix[0][6] = t118;
        damping_matrix[0][7] = t119;
        damping_matrix[0][8] = t59 * t97 + b_z * t99 + c_z * t104;
        damping_matrix[1][0] = b_x * t100;
        damping_matrix[1][1] = b_x * t101;
        damping_matrix[1][2] = b_x * t102;
        damping_matrix[1][3] = b_y * t100;
        damping_matrix[1][4] = b_y * t101;
        damping_matrix[1][5] = b_y * t102;
        damping_matrix[1][6] = b_z * t100;
        damping_matrix[1][7] = b_z * t101;
        damping_matrix[1][8] = b_z * t102;
        damping_matrix[2][0] = c_x * t105;
        damping_matrix[2][1] = c_x * t106;
        damping_matrix[2][2] = c_x * t107;
        damping_matrix[2][3] = c_y * t105;
        damping_matrix[2][4] = c_y * t106;
        damping_matrix[2][5] = c_y * t107;
        damping_matrix[2][6] = c_z * t105;
        damping_matrix[2][7] = c_z * t106;
        damping_matrix[2][8] = c_z * t107;
        damping_matrix[3][0] = a_x * t100 + t60 * (t47 * t60) + c_x * (c_x * t50);
        damping_matrix[3][1] = t120;
        damping_matrix[3][2] = t121;
        damping_matrix[3][3] = t120;
        damping_matrix[3][4] = a_y * t101 + t61 * t108 + c_y * t110;
        damping_matrix[3][5] = t122;
        damping_matrix[3][6] = t121;
        damping_matrix[3][7] = t122;
        damping_matrix[3][8] = a_z * t102 + t62 * t109 + c_z * t111;
        damping_matrix[4][0] = c_x * t112;
        damping_matrix[4][1] = c_x * t113;
        damping_matrix[4][2] = c_x * t114;
        damping_matrix[4][3] = c_y * t112;
        damping_matrix[4][4] = c_y * t113;
        damping_matrix[4][5] = c_y * t114;
        damping_matrix[4][6] = c_z * t112;
        damping_matrix[4][7] = c_z * t113;
        damping_matrix[4][8] = c_z * t114;
        damping_matrix[5][0] = a_x * t105 + b_x * t112 + t63 * (t47 * t63);
        damping_matrix[5][1] = t123;
        damping_matrix[5][2] = t124;
        damping_matrix[5][3] = t123;
        damping_matrix[5][4] = a_y * t106 + b_y * t113 + t64 * t115;
        damping_matrix[5][5] = t125;
        damping_matrix[5][6] = t124;
        damping_matrix[5][7] = t125;
        damping_matrix[5][8] = a_z * t107 + b_z * t114 + t65 * t116;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 20 additions, 41 multiplications.
    pub fn beam_spatial_damped_points3_energy(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t26 = 0.5 * (length * EA);
        let t27 = t26 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)).powi(2);
        let t28 = t26 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)).powi(2);
        let t29 = t26 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)).powi(2);
        let t30 = 0.5 * (length * kyGA) * (a_x * b_x + a_y * b_y + a_z * b_z).powi(2);
        let t31 = 0.5 * (length * kzGA) * (a_x * c_x + a_y * c_y + a_z * c_z).powi(2);
        let t32 = 0.5 * (length * GA) * (b_x * c_x + b_y * c_y + b_z * c_z).powi(2);
        *energy = t27 + t28 + t29 + t30 + t31 + t32;
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 70 additions, 127 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_force(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z],
        [v_unit_db_x, v_unit_db_y, v_unit_db_z], [v_unit_dc_x, v_unit_dc_y, v_unit_dc_z],
        ] = *rates;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let v_db_x = inverse_length * v_unit_db_x;
        let v_db_y = inverse_length * v_unit_db_y;
        let v_db_z = inverse_length * v_unit_db_z;
        let v_dc_x = inverse_length * v_unit_dc_x;
        let v_dc_y = inverse_length * v_unit_dc_y;
        let v_dc_z = inverse_length * v_unit_dc_z;
        let t62 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t63 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t64 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t65 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t66 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t67 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t68 = length * EIz * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t62);
        let t69 = length * EIy * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t63);
        let t70 = length * GIz * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t64);
        let t71 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t72 = length * GJ * (0.5 * t71 + damping * (0.5 * (t66 - t65)));
        let t73 = length * GIy * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t67);
        let t74 = inverse_length * t68;
        let t75 = inverse_length * t69;
        let t76 = inverse_length * t70;
        let t77 = inverse_length * (-0.5 * t72);
        let t78 = inverse_length * (0.5 * t72);
        let t79 = inverse_length * t73;
        forces[0][0] = unit_db_x * t74 + unit_dc_x * t75;
        forces[0][1] = unit_db_y * t74 + unit_dc_y * t75;
        forces[0][2] = unit_db_z * t74 + unit_dc_z * t75;
        forces[1][0] = unit_db_x * t76 + unit_dc_x * t77;
        forces[1][1] = unit_db_y * t76 + unit_dc_y * t77;
        forces[1][2] = unit_db_z * t76 + unit_dc_z * t77;
        forces[2][0] = unit_db_x * t78 + unit_dc_x * t79;
        forces[2][1] = unit_db_y * t78 + unit_dc_y * t79;
        forces[2][2] = unit_db_z * t78 + unit_dc_z * t79;
        forces[3][0] = a_x * t74 + b_x * t76 + c_x * t78;
        forces[3][1] = a_y * t74 + b_y * t76 + c_y * t78;
        forces[3][2] = a_z * t74 + b_z * t76 + c_z * t78;
        forces[4][0] = a_x * t75 + b_x * t77 + c_x * t79;
        forces[4][1] = a_y * t75 + b_y * t77 + c_y * t79;
        forces[4][2] = a_z * t75 + b_z * t77 + c_z * t79;
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 331 additions, 792 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_tangent(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        rates: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 21],
        damping_matrix: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let [[v_a_x, v_a_y, v_a_z], [v_b_x, v_b_y, v_b_z], [v_c_x, v_c_y, v_c_z],
        [v_unit_db_x, v_unit_db_y, v_unit_db_z], [v_unit_dc_x, v_unit_dc_y, v_unit_dc_z],
        ] = *rates;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let v_db_x = inverse_length * v_unit_db_x;
        let v_db_y = inverse_length * v_unit_db_y;
        let v_db_z = inverse_length * v_unit_db_z;
        let v_dc_x = inverse_length * v_unit_dc_x;
        let v_dc_y = inverse_length * v_unit_dc_y;
        let v_dc_z = inverse_length * v_unit_dc_z;
        let t62 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t63 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t64 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t65 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t66 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t67 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t68 = length * EIz;
        let t69 = length * EIy;
        let t70 = length * GJ;
        let t71 = 0.5 * t70;
        let t72 = length * GIz;
        let t73 = length * GIy;
        let t74 = t70 * (-0.5);
        let t75 = t70 * (damping * (-0.5));
        let t76 = t70 * (damping * 0.5);
        let t77 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t78 = t70 * (0.5 * t77 + damping * (0.5 * (t66 - t65)));
        let t79 = inverse_length
            * (t68 * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t62));
        let t80 = inverse_length * inverse_length;
        let t81 = t68 * t80;
        let t82 = damping * t68 * t80;
        let t83 = inverse_length
            * (t69 * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t63));
        let t84 = t69 * t80;
        let t85 = damping * t69 * t80;
        let t86 = inverse_length
            * (t72 * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t64));
        let t87 = t72 * t80;
        let t88 = damping * t72 * t80;
        let t89 = inverse_length * (-0.5 * t78);
        let t90 = -0.5 * t74 * t80;
        let t91 = -0.5 * t71 * t80;
        let t92 = -0.5 * t75 * t80;
        let t93 = -0.5 * t76 * t80;
        let t94 = inverse_length * (0.5 * t78);
        let t95 = 0.5 * t74 * t80;
        let t96 = 0.5 * t71 * t80;
        let t97 = 0.5 * t75 * t80;
        let t98 = 0.5 * t76 * t80;
        let t99 = inverse_length
            * (t73 * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t67));
        let t100 = t73 * t80;
        let t101 = damping * t73 * t80;
        let t102 = unit_db_x * t81 + v_unit_db_x * t82;
        let t103 = unit_db_y * t81 + v_unit_db_y * t82;
        let t104 = unit_db_z * t81 + v_unit_db_z * t82;
        let t105 = a_x * t81 + v_a_x * t82;
        let t106 = a_y * t81 + v_a_y * t82;
        let t107 = a_z * t81 + v_a_z * t82;
        let t108 = unit_dc_x * t84 + v_unit_dc_x * t85;
        let t109 = unit_dc_y * t84 + v_unit_dc_y * t85;
        let t110 = unit_dc_z * t84 + v_unit_dc_z * t85;
        let t111 = a_x * t84 + v_a_x * t85;
        let t112 = a_y * t84 + v_a_y * t85;
        let t113 = a_z * t84 + v_a_z * t85;
        let t114 = unit_db_x * t87 + v_unit_db_x * t88;
        let t115 = unit_db_y * t87 + v_unit_db_y * t88;
        let t116 = unit_db_z * t87 + v_unit_db_z * t88;
        let t117 = b_x * t87 + v_b_x * t88;
        let t118 = b_y * t87 + v_b_y * t88;
        let t119 = b_z * t87 + v_b_z * t88;
        let t120 = unit_dc_x * t90 + v_unit_dc_x * t92;
        let t121 = unit_dc_y * t90 + v_unit_dc_y * t92;
        let t122 = unit_dc_z * t90 + v_unit_dc_z * t92;
        let t123 = unit_db_x * t91 + v_unit_db_x * t93;
        let t124 = unit_db_y * t91 + v_unit_db_y * t93;
        let t125 = unit_db_z * t91 + v_unit_db_z * t93;
        let t126 = c_x * t91 + v_c_x * t93;
        let t127 = c_y * t91 + v_c_y * t93;
        let t128 = c_z * t91 + v_c_z * t93;
        let t129 = b_x * t90 + v_b_x * t92;
        let t130 = b_y * t90 + v_b_y * t92;
        let t131 = b_z * t90 + v_b_z * t92;
        let t132 = unit_dc_x * t95 + v_unit_dc_x * t97;
        let t133 = unit_dc_y * t95 + v_unit_dc_y * t97;
        let t134 = unit_dc_z * t95 + v_unit_dc_z * t97;
        let t135 = unit_db_x * t96 + v_unit_db_x * t98;
        let t136 = unit_db_y * t96 + v_unit_db_y * t98;
        let t137 = unit_db_z * t96 + v_unit_db_z * t98;
        let t138 = c_x * t96 + v_c_x * t98;
        let t139 = c_y * t96 + v_c_y * t98;
        let t140 = c_z * t96 + v_c_z * t98;
        let t141 = b_x * t95 + v_b_x * t97;
        let t142 = b_y * t95 + v_b_y * t97;
        let t143 = b_z * t95 + v_b_z * t97;
        let t144 = unit_dc_x * t100 + v_unit_dc_x * t101;
        let t145 = unit_dc_y * t100 + v_unit_dc_y * t101;
        let t146 = unit_dc_z * t100 + v_unit_dc_z * t101;
        let t147 = c_x * t100 + v_c_x * t101;
        let t148 = c_y * t100 + v_c_y * t101;
        let t149 = c_z * t100 + v_c_z * t101;
        let t150 = unit_db_x * t82;
        let t151 = unit_db_y * t82;
        let t152 = unit_db_z * t82;
        let t153 = a_x * t82;
        let t154 = a_y * t82;
        let t155 = a_z * t82;
        let t156 = unit_dc_x * t85;
        let t157 = unit_dc_y * t85;
        let t158 = unit_dc_z * t85;
        let t159 = a_x * t85;
        let t160 = a_y * t85;
        let t161 = a_z * t85;
        let t162 = unit_db_x * t88;
        let t163 = unit_db_y * t88;
        let t164 = unit_db_z * t88;
        let t165 = b_x * t88;
        let t166 = b_y * t88;
        let t167 = b_z * t88;
        let t168 = unit_dc_x * t92;
        let t169 = unit_dc_y * t92;
        let t170 = unit_dc_z * t92;
        let t171 = unit_db_x * t93;
        let t172 = unit_db_y * t93;
        let t173 = unit_db_z * t93;
        let t174 = c_x * t93;
        let t175 = c_y * t93;
        let t176 = c_z * t93;
        let t177 = b_x * t92;
        let t178 = b_y * t92;
        let t179 = b_z * t92;
        let t180 = unit_dc_x * t97;
        let t181 = unit_dc_y * t97;
        let t182 = unit_dc_z * t97;
        let t183 = unit_db_x * t98;
        let t184 = unit_db_y * t98;
        let t185 = unit_db_z * t98;
        let t186 = c_x * t98;
        let t187 = c_y * t98;
        let t188 = c_z * t98;
        let t189 = b_x * t97;
        let t190 = b_y * t97;
        let t191 = b_z * t97;
        let t192 = unit_dc_x * t101;
        let t193 = unit_dc_y * t101;
        let t194 = unit_dc_z * t101;
        let t195 = c_x * t101;
        let t196 = c_y * t101;
        let t197 = c_z * t101;
        stiffness[0][0] = unit_db_x * t102 + unit_dc_x * t108;
        stiffness[0][1] = unit_db_x * t103 + unit_dc_x * t109;
        stiffness[0][2] = unit_db_x * t104 + unit_dc_x * t110;
        stiffness[0][3] = unit_db_y * t102 + unit_dc_y * t108;
        stiffness[0][4] = unit_db_y * t103 + unit_dc_y * t109;
        stiffness[0][5] = unit_db_y * t104 + unit_dc_y * t110;
        stiffness[0][6] = unit_db_z * t102 + unit_dc_z * t108;
        stiffness[0][7] = unit_db_z * t103 + unit_dc_z * t109;
        stiffness[0][8] = unit_db_z * t104 + unit_dc_z * t110;
        stiffness[1][0] = t79 + unit_db_x * t105;
        stiffness[1][1] = unit_db_x * t106;
        stiffness[1][2] = unit_db_x * t107;
        stiffness[1][3] = unit_db_y * t105;
        stiffness[1][4] = t79 + unit_db_y * t106;
        stiffness[1][5] = unit_db_y * t107;
        stiffness[1][6] = unit_db_z * t105;
        stiffness[1][7] = unit_db_z * t106;
        stiffness[1][8] = t79 + unit_db_z * t107;
        stiffness[2][0] = t83 + unit_dc_x * t111;
        stiffness[2][1] = unit_dc_x * t112;
        stiffness[2][2] = unit_dc_x * t113;
        stiffness[2][3] = unit_dc_y * t111;
        stiffness[2][4] = t83 + unit_dc_y * t112;
        stiffness[2][5] = unit_dc_y * t113;
        stiffness[2][6] = unit_dc_z * t111;
        stiffness[2][7] = unit_dc_z * t112;
        stiffness[2][8] = t83 + unit_dc_z * t113;
        stiffness[3][0] = t79 + a_x * t102;
        stiffness[3][1] = a_x * t103;
        stiffness[3][2] = a_x * t104;
        stiffness[3][3] = a_y * t102;
        stiffness[3][4] = t79 + a_y * t103;
        stiffness[3][5] = a_y * t104;
        stiffness[3][6] = a_z * t102;
        stiffness[3][7] = a_z * t103;
        stiffness[3][8] = t79 + a_z * t104;
        stiffness[4][0] = unit_db_x * t114 + unit_dc_x * t120;
        stiffness[4][1] = unit_db_x * t115 + unit_dc_x * t121;
        stiffness[4][2] = unit_db_x * t116 + unit_dc_x * t122;
        stiffness[4][3] = unit_db_y * t114 + unit_dc_y * t120;
        stiffness[4][4] = unit_db_y * t115 + unit_dc_y * t121;
        stiffness[4][5] = unit_db_y * t116 + unit_dc_y * t122;
        stiffness[4][6] = unit_db_z * t114 + unit_dc_z * t120;
        stiffness[4][7] = unit_db_z * t115 + unit_dc_z * t121;
        stiffness[4][8] = unit_db_z * t116 + unit_dc_z * t122;
        stiffness[5][0] = t86 + (unit_db_x * t117 + unit_dc_x * t126);
        stiffness[5][1] = unit_db_x * t118 + unit_dc_x * t127;
        stiffness[5][2] = unit_db_x * t119 + unit_dc_x * t128;
        stiffness[5][3] = unit_db_y * t117 + unit_dc_y * t126;
        stiffness[5][4] = t86 + (unit_db_y * t118 + unit_dc_y * t127);
        stiffness[5][5] = unit_db_y * t119 + unit_dc_y * t128;
        stiffness[5][6] = unit_db_z * t117 + unit_dc_z * t126;
        stiffness[5][7] = unit_db_z * t118 + unit_dc_z * t127;
        stiffness[5][8] = t86 + (unit_db_z * t119 + unit_dc_z * t128);
        stiffness[6][0] = t86 + (b_x * t114 + c_x * t132);
        stiffness[6][1] = b_x * t115 + c_x * t133;
        stiffness[6][2] = b_x * t116 + c_x * t134;
        stiffness[6][3] = b_y * t114 + c_y * t132;
        stiffness[6][4] = t86 + (b_y * t115 + c_y * t133);
        stiffness[6][5] = b_y * t116 + c_y * t134;
        stiffness[6][6] = b_z * t114 + c_z * t132;
        stiffness[6][7] = b_z * t115 + c_z * t133;
        stiffness[6][8] = t86 + (b_z * t116 + c_z * t134);
        stiffness[7][0] = a_x * t105 + b_x * t117 + c_x * t138;
        stiffness[7][1] = a_x * t106 + b_x * t118 + c_x * t139;
        stiffness[7][2] = a_x * t107 + b_x * t119 + c_x * t140;
        stiffness[7][3] = a_y * t105 + b_y * t117 + c_y * t138;
        stiffness[7][4] = a_y * t106 + b_y * t118 + c_y * t139;
        stiffness[7][5] = a_y * t107 + b_y * t119 + c_y * t140;
        stiffness[7][6] = a_z * t105 + b_z * t117 + c_z * t138;
        stiffness[7][7] = a_z * t106 + b_z * t118 + c_z * t139;
        stiffness[7][8] = a_z * t107 + b_z * t119 + c_z * t140;
        stiffness[8][0] = unit_dc_x * t123;
        stiffness[8][1] = unit_dc_x * t124;
        stiffness[8][2] = unit_dc_x * t125;
        stiffness[8][3] = unit_dc_y * t123;
        stiffness[8][4] = unit_dc_y * t124;
        stiffness[8][5] = unit_dc_y * t125;
        stiffness[8][6] = unit_dc_z * t123;
        stiffness[8][7] = unit_dc_z * t124;
        stiffness[8][8] = unit_dc_z * t125;
        stiffness[9][0] = t89 + unit_dc_x * t129;
        stiffness[9][1] = unit_dc_x * t130;
        stiffness[9][2] = unit_dc_x * t131;
        stiffness[9][3] = unit_dc_y * t129;
        stiffness[9][4] = t89 + unit_dc_y * t130;
        stiffness[9][5] = unit_dc_y * t131;
        stiffness[9][6] = unit_dc_z * t129;
        stiffness[9][7] = unit_dc_z * t130;
        stiffness[9][8] = t89 + unit_dc_z * t131;
        stiffness[10][0] = t94 + c_x * t135;
        stiffness[10][1] = c_x * t136;
        stiffness[10][2] = c_x * t137;
        stiffness[10][3] = c_y * t135;
        stiffness[10][4] = t94 + c_y * t136;
        stiffness[10][5] = c_y * t137;
        stiffness[10][6] = c_z * t135;
        stiffness[10][7] = c_z * t136;
        stiffness[10][8] = t94 + c_z * t137;
        stiffness[11][0] = c_x * t141;
        stiffness[11][1] = c_x * t142;
        stiffness[11][2] = c_x * t143;
        stiffness[11][3] = c_y * t141;
        stiffness[11][4] = c_y * t142;
        stiffness[11][5] = c_y * t143;
        stiffness[11][6] = c_z * t141;
        stiffness[11][7] = c_z * t142;
        stiffness[11][8] = c_z * t143;
        stiffness[12][0] = t83 + a_x * t108;
        stiffness[12][1] = a_x * t109;
        stiffness[12][2] = a_x * t110;
        stiffness[12][3] = a_y * t108;
        stiffness[12][4] = t83 + a_y * t109;
        stiffness[12][5] = a_y * t110;
        stiffness[12][6] = a_z * t108;
        stiffness[12][7] = a_z * t109;
        stiffness[12][8] = t83 + a_z * t110;
        stiffness[13][0] = unit_db_x * t132;
        stiffness[13][1] = unit_db_x * t133;
        stiffness[13][2] = unit_db_x * t134;
        stiffness[13][3] = unit_db_y * t132;
        stiffness[13][4] = unit_db_y * t133;
        stiffness[13][5] = unit_db_y * t134;
        stiffness[13][6] = unit_db_z * t132;
        stiffness[13][7] = unit_db_z * t133;
        stiffness[13][8] = unit_db_z * t134;
        stiffness[14][0] = t94 + unit_db_x * t138;
        stiffness[14][1] = unit_db_x * t139;
        stiffness[14][2] = unit_db_x * t140;
        stiffness[14][3] = unit_db_y * t138;
        stiffness[14][4] = t94 + unit_db_y * t139;
        stiffness[14][5] = unit_db_y * t140;
        stiffness[14][6] = unit_db_z * t138;
        stiffness[14][7] = unit_db_z * t139;
        stiffness[14][8] = t94 + unit_db_z * t140;
        stiffness[15][0] = t89 + b_x * t120;
        stiffness[15][1] = b_x * t121;
        stiffness[15][2] = b_x * t122;
        stiffness[15][3] = b_y * t120;
        stiffness[15][4] = t89 + b_y * t121;
        stiffness[15][5] = b_y * t122;
        stiffness[15][6] = b_z * t120;
        stiffness[15][7] = b_z * t121;
        stiffness[15][8] = t89 + b_z * t122;
        stiffness[16][0] = b_x * t126;
        stiffness[16][1] = b_x * t127;
        stiffness[16][2] = b_x * t128;
        stiffness[16][3] = b_y * t126;
        stiffness[16][4] = b_y * t127;
        stiffness[16][5] = b_y * t128;
        stiffness[16][6] = b_z * t126;
        stiffness[16][7] = b_z * t127;
        stiffness[16][8] = b_z * t128;
        stiffness[17][0] = unit_db_x * t135 + unit_dc_x * t144;
        stiffness[17][1] = unit_db_x * t136 + unit_dc_x * t145;
        stiffness[17][2] = unit_db_x * t137 + unit_dc_x * t146;
        stiffness[17][3] = unit_db_y * t135 + unit_dc_y * t144;
        stiffness[17][4] = unit_db_y * t136 + unit_dc_y * t145;
        stiffness[17][5] = unit_db_y * t137 + unit_dc_y * t146;
        stiffness[17][6] = unit_db_z * t135 + unit_dc_z * t144;
        stiffness[17][7] = unit_db_z * t136 + unit_dc_z * t145;
        stiffness[17][8] = unit_db_z * t137 + unit_dc_z * t146;
        stiffness[18][0] = t99 + (unit_db_x * t141 + unit_dc_x * t147);
        stiffness[18][1] = unit_db_x * t142 + unit_dc_x * t148;
        stiffness[18][2] = unit_db_x * t143 + unit_dc_x * t149;
        stiffness[18][3] = unit_db_y * t141 + unit_dc_y * t147;
        stiffness[18][4] = t99 + (unit_db_y * t142 + unit_dc_y * t148);
        stiffness[18][5] = unit_db_y * t143 + unit_dc_y * t149;
        stiffness[18][6] = unit_db_z * t141 + unit_dc_z * t147;
        stiffness[18][7] = unit_db_z * t142 + unit_dc_z * t148;
        stiffness[18][8] = t99 + (unit_db_z * t143 + unit_dc_z * t149);
        stiffness[19][0] = t99 + (b_x * t123 + c_x * t144);
        stiffness[19][1] = b_x * t124 + c_x * t145;
        stiffness[19][2] = b_x * t125 + c_x * t146;
        stiffness[19][3] = b_y * t123 + c_y * t144;
        stiffness[19][4] = t99 + (b_y * t124 + c_y * t145);
        stiffness[19][5] = b_y * t125 + c_y * t146;
        stiffness[19][6] = b_z * t123 + c_z * t144;
        stiffness[19][7] = b_z * t124 + c_z * t145;
        stiffness[19][8] = t99 + (b_z * t125 + c_z * t146);
        stiffness[20][0] = a_x * t111 + b_x * t129 + c_x * t147;
        stiffness[20][1] = a_x * t112 + b_x * t130 + c_x * t148;
        stiffness[20][2] = a_x * t113 + b_x * t131 + c_x * t149;
        stiffness[20][3] = a_y * t111 + b_y * t129 + c_y * t147;
        stiffness[20][4] = a_y * t112 + b_y * t130 + c_y * t148;
        stiffness[20][5] = a_y * t113 + b_y * t131 + c_y * t149;
        stiffness[20][6] = a_z * t111 + b_z * t129 + c_z * t147;
        stiffness[20][7] = a_z * t112 + b_z * t130 + c_z * t148;
        stiffness[20][8] = a_z * t113 + b_z * t131 + c_z * t149;
        damping_matrix[0][0] = unit_db_x * t150 + unit_dc_x * t156;
        damping_matrix[0][1] = unit_db_x * t151 + unit_dc_x * t157;
        damping_matrix[0][2] = unit_db_x * t152 + unit_dc_x * t158;
        damping_matrix[0][3] = unit_db_y * t150 + unit_dc_y * t156;
        damping_matrix[0][4] = unit_db_y * t151 + unit_dc_y * t157;
        damping_matrix[0][5] = unit_db_y * t152 + unit_dc_y * t158;
        damping_matrix[0][6] = unit_db_z * t150 + unit_dc_z * t156;
        damping_matrix[0][7] = unit_db_z * t151 + unit_dc_z * t157;
        damping_matrix[0][8] = unit_db_z * t152 + unit_dc_z * t158;
        damping_matrix[1][0] = unit_db_x * t153;
        damping_matrix[1][1] = unit_db_x * t154;
        damping_matrix[1][2] = unit_db_x * t155;
        damping_matrix[1][3] = unit_db_y * t153;
        damping_matrix[1][4] = unit_db_y * t154;
        damping_matrix[1][5] = unit_db_y * t155;
        damping_matrix[1][6] = unit_db_z * t153;
        damping_matrix[1][7] = unit_db_z * t154;
        damping_matrix[1][8] = unit_db_z * t155;
        damping_matrix[2][0] = unit_dc_x * t159;
        damping_matrix[2][1] = unit_dc_x * t160;
        damping_matrix[2][2] = unit_dc_x * t161;
        damping_matrix[2][3] = unit_dc_y * t159;
        damping_matrix[2][4] = unit_dc_y * t160;
        damping_matrix[2][5] = unit_dc_y * t161;
        damping_matrix[2][6] = unit_dc_z * t159;
        damping_matrix[2][7] = unit_dc_z * t160;
        damping_matrix[2][8] = unit_dc_z * t161;
        damping_matrix[3][0] = unit_db_x * t162 + unit_dc_x * t168;
        damping_matrix[3][1] = unit_db_x * t163 + unit_dc_x * t169;
        damping_matrix[3][2] = unit_db_x * t164 + unit_dc_x * t170;
        damping_matrix[3][3] = unit_db_y * t162 + unit_dc_y * t168;
        damping_matrix[3][4] = unit_db_y * t163 + unit_dc_y * t169;
        damping_matrix[3][5] = unit_db_y * t164 + unit_dc_y * t170;
        damping_matrix[3][6] = unit_db_z * t162 + unit_dc_z * t168;
        damping_matrix[3][7] = unit_db_z * t163 + unit_dc_z * t169;
        damping_matrix[3][8] = unit_db_z * t164 + unit_dc_z * t170;
        damping_matrix[4][0] = unit_db_x * t165 + unit_dc_x * t174;
        damping_matrix[4][1] = unit_db_x * t166 + unit_dc_x * t175;
        damping_matrix[4][2] = unit_db_x * t167 + unit_dc_x * t176;
        damping_matrix[4][3] = unit_db_y * t165 + unit_dc_y * t174;
        damping_matrix[4][4] = unit_db_y * t166 + unit_dc_y * t175;
        damping_matrix[4][5] = unit_db_y * t167 + unit_dc_y * t176;
        damping_matrix[4][6] = unit_db_z * t165 + unit_dc_z * t174;
        damping_matrix[4][7] = unit_db_z * t166 + unit_dc_z * t175;
        damping_matrix[4][8] = unit_db_z * t167 + unit_dc_z * t176;
        damping_matrix[5][0] = b_x * t162 + c_x * t180;
        damping_matrix[5][1] = b_x * t163 + c_x * t181;
        damping_matrix[5][2] = b_x * t164 + c_x * t182;
        damping_matrix[5][3] = b_y * t162 + c_y * t180;
        damping_matrix[5][4] = b_y * t163 + c_y * t181;
        damping_matrix[5][5] = b_y * t164 + c_y * t182;
        damping_matrix[5][6] = b_z * t162 + c_z * t180;
        damping_matrix[5][7] = b_z * t163 + c_z * t181;
        damping_matrix[5][8] = b_z * t164 + c_z * t182;
        damping_matrix[6][0] = a_x * t153 + b_x * t165 + c_x * t186;
        damping_matrix[6][1] = a_x * t154 + b_x * t166 + c_x * t187;
        damping_matrix[6][2] = a_x * t155 + b_x * t167 + c_x * t188;
        damping_matrix[6][3] = a_y * t153 + b_y * t165 + c_y * t186;
        damping_matrix[6][4] = a_y * t154 + b_y * t166 + c_y * t187;
        damping_matrix[6][5] = a_y * t155 + b_y * t167 + c_y * t188;
        damping_matrix[6][6] = a_z * t153 + b_z * t165 + c_z * t186;
        damping_matrix[6][7] = a_z * t154 + b_z * t166 + c_z * t187;
        damping_matrix[6][8] = a_z * t155 + b_z * t167 + c_z * t188;
        damping_matrix[7][0] = unit_dc_x * t171;
        damping_matrix[7][1] = unit_dc_x * t172;
        damping_matrix[7][2] = unit_dc_x * t173;
        damping_matrix[7][3] = unit_dc_y * t171;
        damping_matrix[7][4] = unit_dc_y * t172;
        damping_matrix[7][5] = unit_dc_y * t173;
        damping_matrix[7][6] = unit_dc_z * t171;
        damping_matrix[7][7] = unit_dc_z * t172;
        damping_matrix[7][8] = unit_dc_z * t173;
        damping_matrix[8][0] = unit_dc_x * t177;
        damping_matrix[8][1] = unit_dc_x * t178;
        damping_matrix[8][2] = unit_dc_x * t179;
        damping_matrix[8][3] = unit_dc_y * t177;
        damping_matrix[8][4] = unit_dc_y * t178;
        damping_matrix[8][5] = unit_dc_y * t179;
        damping_matrix[8][6] = unit_dc_z * t177;
        damping_matrix[8][7] = unit_dc_z * t178;
        damping_matrix[8][8] = unit_dc_z * t179;
        damping_matrix[9][0] = c_x * t183;
        damping_matrix[9][1] = c_x * t184;
        damping_matrix[9][2] = c_x * t185;
        damping_matrix[9][3] = c_y * t183;
        damping_matrix[9][4] = c_y * t184;
        damping_matrix[9][5] = c_y * t185;
        damping_matrix[9][6] = c_z * t183;
        damping_matrix[9][7] = c_z * t184;
        damping_matrix[9][8] = c_z * t185;
        damping_matrix[10][0] = c_x * t189;
        damping_matrix[10][1] = c_x * t190;
        damping_matrix[10][2] = c_x * t191;
        damping_matrix[10][3] = c_y * t189;
        damping_matrix[10][4] = c_y * t190;
        damping_matrix[10][5] = c_y * t191;
        damping_matrix[10][6] = c_z * t189;
        damping_matrix[10][7] = c_z * t190;
        damping_matrix[10][8] = c_z * t191;
        damping_matrix[11][0] = unit_db_x * t183 + unit_dc_x * t192;
        damping_matrix[11][1] = unit_db_x * t184 + unit_dc_x * t193;
        damping_matrix[11][2] = unit_db_x * t185 + unit_dc_x * t194;
        damping_matrix[11][3] = unit_db_y * t183 + unit_dc_y * t192;
        damping_matrix[11][4] = unit_db_y * t184 + unit_dc_y * t193;
        damping_matrix[11][5] = unit_db_y * t185 + unit_dc_y * t194;
        damping_matrix[11][6] = unit_db_z * t183 + unit_dc_z * t192;
        damping_matrix[11][7] = unit_db_z * t184 + unit_dc_z * t193;
        damping_matrix[11][8] = unit_db_z * t185 + unit_dc_z * t194;
        damping_matrix[12][0] = unit_db_x * t189 + unit_dc_x * t195;
        damping_matrix[12][1] = unit_db_x * t190 + unit_dc_x * t196;
        damping_matrix[12][2] = unit_db_x * t191 + unit_dc_x * t197;
        damping_matrix[12][3] = unit_db_y * t189 + unit_dc_y * t195;
        damping_matrix[12][4] = unit_db_y * t190 + unit_dc_y * t196;
        damping_matrix[12][5] = unit_db_y * t191 + unit_dc_y * t197;
        damping_matrix[12][6] = unit_db_z * t189 + unit_dc_z * t195;
        damping_matrix[12][7] = unit_db_z * t190 + unit_dc_z * t196;
        damping_matrix[12][8] = unit_db_z * t191 + unit_dc_z * t197;
        damping_matrix[13][0] = b_x * t171 + c_x * t192;
        damping_matrix[13][1] = b_x * t172 + c_x * t193;
        damping_matrix[13][2] = b_x * t173 + c_x * t194;
        damping_matrix[13][3] = b_y * t171 + c_y * t192;
        damping_matrix[13][4] = b_y * t172 + c_y * t193;
        damping_matrix[13][5] = b_y * t173 + c_y * t194;
        damping_matrix[13][6] = b_z * t171 + c_z * t192;
        damping_matrix[13][7] = b_z * t172 + c_z * t193;
        damping_matrix[13][8] = b_z * t173 + c_z * t194;
        damping_matrix[14][0] = a_x * t159 + b_x * t177 + c_x * t195;
        damping_matrix[14][1] = a_x * t160 + b_x * t178 + c_x * t196;
        damping_matrix[14][2] = a_x * t161 + b_x * t179 + c_x * t197;
        damping_matrix[14][3] = a_y * t159 + b_y * t177 + c_y * t195;
        damping_matrix[14][4] = a_y * t160 + b_y * t178 + c_y * t196;
        damping_matrix[14][5] = a_y * t161 + b_y * t179 + c_y * t197;
        damping_matrix[14][6] = a_z * t159 + b_z * t177 + c_z * t195;
        damping_matrix[14][7] = a_z * t160 + b_z * t178 + c_z * t196;
        damping_matrix[14][8] = a_z * t161 + b_z * t179 + c_z * t197;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 17 additions, 45 multiplications, 1 divisions.
    pub fn beam_spatial_damped_points2_energy(
        row: &BeamSpatialDamped,
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t40 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t41 = 0.5 * (length * EIz) * (a_x * db_x + a_y * db_y + a_z * db_z).powi(2);
        let t42 = 0.5 * (length * EIy) * (a_x * dc_x + a_y * dc_y + a_z * dc_z).powi(2);
        let t43 = 0.5 * (length * GIz) * (b_x * db_x + b_y * db_y + b_z * db_z).powi(2);
        let t44 = 0.5 * (length * GIy) * (c_x * dc_x + c_y * dc_y + c_z * dc_z).powi(2);
        let t45 = t41 + t42 + 0.5 * (length * GJ) * (0.5 * t40).powi(2) + t43 + t44;
        *energy = t45;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 842 additions, 1085 multiplications, 2 divisions.
    pub fn beam_spatial_damped_elastic_force(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        v: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        let rates = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, v);
        let mut sums = Default::default();
        BEAM_SPATIAL_DAMPED_POINTS3
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| beam_spatial_damped_points3_force(
                    row,
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_DAMPED_POINTS2
            .force(
                &vectors,
                &rates,
                |point, fields, rates, forces| beam_spatial_damped_points2_force(
                    row,
                    fields,
                    rates,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_DAMPED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 11048 additions, 12591 multiplications, 2 divisions.
    pub fn beam_spatial_damped_elastic_tangent(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        v: &[f64; 30],
        stiffness: &mut [f64; 900],
        damping_matrix: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        let rates = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, v);
        let mut tiles = [[[0.0; 9]; 9]; 9];
        let mut viscous = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_DAMPED_POINTS3
            .damped_tangent(
                (&vectors, &rates),
                (&BEAM_SPATIAL_DAMPED_POINTS3_STIFFNESS, &mut tiles),
                (&BEAM_SPATIAL_DAMPED_POINTS3_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| beam_spatial_damped_points3_tangent(
                    row,
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        BEAM_SPATIAL_DAMPED_POINTS2
            .damped_tangent(
                (&vectors, &rates),
                (&BEAM_SPATIAL_DAMPED_POINTS2_STIFFNESS, &mut tiles),
                (&BEAM_SPATIAL_DAMPED_POINTS2_DAMPING, &mut viscous),
                |point, fields, rates, stiffness, damping_matrix| beam_spatial_damped_points2_tangent(
                    row,
                    fields,
                    rates,
                    stiffness,
                    damping_matrix,
                ),
            );
        BEAM_SPATIAL_DAMPED_VECTORS.add_general(row.length, &tiles, stiffness);
        BEAM_SPATIAL_DAMPED_VECTORS.add_symmetric(row.length, &viscous, damping_matrix);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none, axial = green.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 270 additions, 389 multiplications, 2 divisions.
    pub fn beam_spatial_damped_strain_energy(
        row: &BeamSpatialDamped,
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_DAMPED_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_DAMPED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_damped_points3_energy(row, fields, &mut density);
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_DAMPED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_damped_points2_energy(row, fields, &mut density);
                        density
                    },
                );
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_damped_mass(row: &BeamSpatialDamped, mass: &mut [f64; 100]) {
        let BeamSpatialDamped { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t20 = length * element_mass;
        let mass_r0_r0x = t20 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_r1x = t20 * (-0.030952380952380953);
        let t24 = element_mass * (length * length);
        let mass_r0x_r0x = t24 * 0.009523809523809525;
        let mass_r0x_r1 = t20 * 0.030952380952380953;
        let mass_r0x_r1x = t24 * (-0.007142857142857143);
        let mass_r0y_r0y = section_y_mass * 0.13333333333333333;
        let mass_r0y_ry_half = section_y_mass * 0.06666666666666667;
        let mass_r0y_r1y = section_y_mass * (-0.03333333333333333);
        let mass_r0z_r0z = section_z_mass * 0.13333333333333333;
        let mass_r0z_rz_half = section_z_mass * 0.06666666666666667;
        let mass_r0z_r1z = section_z_mass * (-0.03333333333333333);
        let mass_ry_half_ry_half = section_y_mass * 0.5333333333333333;
        let mass_rz_half_rz_half = section_z_mass * 0.5333333333333333;
        let mass_r1_r1x = t20 * (-0.05238095238095238);
        mass[0] = mass_r0_r0;
        mass[1] = mass_r0_r0x;
        mass[2] = 0.0;
        mass[3] = 0.0;
        mass[4] = 0.0;
        mass[5] = 0.0;
        mass[6] = mass_r0_r1;
        mass[7] = mass_r0_r1x;
        mass[8] = 0.0;
        mass[9] = 0.0;
        mass[10] = mass_r0_r0x;
        mass[11] = mass_r0x_r0x;
        mass[12] = 0.0;
        mass[13] = 0.0;
        mass[14] = 0.0;
        mass[15] = 0.0;
        mass[16] = mass_r0x_r1;
        mass[17] = mass_r0x_r1x;
        mass[18] = 0.0;
        mass[19] = 0.0;
        mass[20] = 0.0;
        mass[21] = 0.0;
        mass[22] = mass_r0y_r0y;
        mass[23] = 0.0;
        mass[24] = mass_r0y_ry_half;
        mass[25] = 0.0;
        mass[26] = 0.0;
        mass[27] = 0.0;
        mass[28] = mass_r0y_r1y;
        mass[29] = 0.0;
        mass[30] = 0.0;
        mass[31] = 0.0;
        mass[32] = 0.0;
        mass[33] = mass_r0z_r0z;
        mass[34] = 0.0;
        mass[35] = mass_r0z_rz_half;
        mass[36] = 0.0;
        mass[37] = 0.0;
        mass[38] = 0.0;
        mass[39] = mass_r0z_r1z;
        mass[40] = 0.0;
        mass[41] = 0.0;
        mass[42] = mass_r0y_ry_half;
        mass[43] = 0.0;
        mass[44] = mass_ry_half_ry_half;
        mass[45] = 0.0;
        mass[46] = 0.0;
        mass[47] = 0.0;
        mass[48] = mass_r0y_ry_half;
        mass[49] = 0.0;
        mass[50] = 0.0;
        mass[51] = 0.0;
        mass[52] = 0.0;
        mass[53] = mass_r0z_rz_half;
        mass[54] = 0.0;
        mass[55] = mass_rz_half_rz_half;
        mass[56] = 0.0;
        mass[57] = 0.0;
        mass[58] = 0.0;
        mass[59] = mass_r0z_rz_half;
        mass[60] = mass_r0_r1;
        mass[61] = mass_r0x_r1;
        mass[62] = 0.0;
        mass[63] = 0.0;
        mass[64] = 0.0;
        mass[65] = 0.0;
        mass[66] = mass_r0_r0;
        mass[67] = mass_r1_r1x;
        mass[68] = 0.0;
        mass[69] = 0.0;
        mass[70] = mass_r0_r1x;
        mass[71] = mass_r0x_r1x;
        mass[72] = 0.0;
        mass[73] = 0.0;
        mass[74] = 0.0;
        mass[75] = 0.0;
        mass[76] = mass_r1_r1x;
        mass[77] = mass_r0x_r0x;
        mass[78] = 0.0;
        mass[79] = 0.0;
        mass[80] = 0.0;
        mass[81] = 0.0;
        mass[82] = mass_r0y_r1y;
        mass[83] = 0.0;
        mass[84] = mass_r0y_ry_half;
        mass[85] = 0.0;
        mass[86] = 0.0;
        mass[87] = 0.0;
        mass[88] = mass_r0y_r0y;
        mass[89] = 0.0;
        mass[90] = 0.0;
        mass[91] = 0.0;
        mass[92] = 0.0;
        mass[93] = mass_r0z_r1z;
        mass[94] = 0.0;
        mass[95] = mass_r0z_rz_half;
        mass[96] = 0.0;
        mass[97] = 0.0;
        mass[98] = 0.0;
        mass[99] = mass_r0z_r0z;
    }
    /// Weights of the nodal vectors in the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 6 additions, 12 multiplications.
    pub fn beam_spatial_damped_shapes_position_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        weights[0] = 1.0 + xi * (xi * (-3.0 + xi * 2.0));
        weights[1] = length * (xi * (1.0 + xi * (xi + (-2.0))));
        weights[6] = xi * (xi * (3.0 + xi * (-2.0)));
        weights[7] = length * (xi * (xi * (xi + (-1.0))));
    }
    /// Weights of the nodal vectors in d/dx of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_position_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = 1.0 / length;
        let t15 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t14;
        weights[1] = 1.0 + xi * (-4.0 + t15);
        weights[6] = t14 * (xi * (6.0 + xi * (-6.0)));
        weights[7] = xi * (t15 + (-2.0));
    }
    /// Weights of the nodal vectors in the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_damped_shapes_section_y_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t13 = xi * 2.0;
        weights[2] = 1.0 + xi * (-3.0 + t13);
        weights[4] = xi * (4.0 + xi * (-4.0));
        weights[8] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_y_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[2] = (-3.0 + t14) * t15;
        weights[4] = t15 * (4.0 + xi * (-8.0));
        weights[8] = t15 * (t14 + (-1.0));
    }
    /// Weights of the nodal vectors in the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_damped_shapes_section_z_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t13 = xi * 2.0;
        weights[3] = 1.0 + xi * (-3.0 + t13);
        weights[5] = xi * (4.0 + xi * (-4.0));
        weights[9] = xi * (t13 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_z_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t14 = xi * 4.0;
        let t15 = 1.0 / length;
        weights[3] = (-3.0 + t14) * t15;
        weights[5] = t15 * (4.0 + xi * (-8.0));
        weights[9] = t15 * (t14 + (-1.0));
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point, dU/d(field) per unit length, from their values in the stress-free shape and at present.
    ///
    /// Operations: 178 additions, 262 multiplications.
    pub fn beam_spatial_damped_field_forces(
        row: &BeamSpatialDamped,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        rates: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatialDamped {
            length,
            EA,
            kyGA,
            kzGA,
            GA,
            EIz,
            EIy,
            GJ,
            GIz,
            GIy,
            damping,
            ..
        } = *row;
        let t67 = fields[6] * fields[9] + fields[7] * fields[10] + fields[8] * fields[11]
            - (fields[3] * fields[12] + fields[4] * fields[13] + fields[5] * fields[14]);
        let t68 = 0.5
            * (fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
                - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t69 = fields[0] * 2.0;
        let t70 = fields[1] * 2.0;
        let t71 = fields[2] * 2.0;
        let t72 = EA
            * (t68
                + damping * (0.5 * (rates[0] * t69 + rates[1] * t70 + rates[2] * t71)));
        let t73 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0)
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t74 = fields[3] * 2.0;
        let t75 = fields[4] * 2.0;
        let t76 = fields[5] * 2.0;
        let t77 = EA
            * (t73
                + damping * (0.5 * (rates[3] * t74 + rates[4] * t75 + rates[5] * t76)));
        let t78 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0)
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t79 = fields[6] * 2.0;
        let t80 = fields[7] * 2.0;
        let t81 = fields[8] * 2.0;
        let t82 = EA
            * (t78
                + damping * (0.5 * (rates[6] * t79 + rates[7] * t80 + rates[8] * t81)));
        let t83 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5]
            - (stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
                + stress_free[2] * stress_free[5]);
        let t84 = fields[3] * rates[0] + fields[0] * rates[3]
            + (fields[4] * rates[1] + fields[1] * rates[4])
            + (fields[5] * rates[2] + fields[2] * rates[5]);
        let t85 = kyGA * (t83 + damping * t84);
        let t86 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8]
            - (stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
                + stress_free[2] * stress_free[8]);
        let t87 = fields[6] * rates[0] + fields[0] * rates[6]
            + (fields[7] * rates[1] + fields[1] * rates[7])
            + (fields[8] * rates[2] + fields[2] * rates[8]);
        let t88 = kzGA * (t86 + damping * t87);
        let t89 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t90 = fields[6] * rates[3] + fields[3] * rates[6]
            + (fields[7] * rates[4] + fields[4] * rates[7])
            + (fields[8] * rates[5] + fields[5] * rates[8]);
        let t91 = GA * (t89 + damping * t90);
        let t92 = fields[0] * fields[9] + fields[1] * fields[10] + fields[2] * fields[11]
            - (stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11]);
        let t93 = fields[9] * rates[0] + fields[0] * rates[9]
            + (fields[10] * rates[1] + fields[1] * rates[10])
            + (fields[11] * rates[2] + fields[2] * rates[11]);
        let t94 = EIz * (t92 + damping * t93);
        let t95 = fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14]
            - (stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14]);
        let t96 = fields[12] * rates[0] + fields[0] * rates[12]
            + (fields[13] * rates[1] + fields[1] * rates[13])
            + (fields[14] * rates[2] + fields[2] * rates[14]);
        let t97 = EIy * (t95 + damping * t96);
        let t98 = t72 * (0.5 * t69) + fields[3] * t85 + fields[6] * t88 + fields[9] * t94
            + fields[12] * t97;
        let t99 = t72 * (0.5 * t70) + fields[4] * t85 + fields[7] * t88
            + fields[10] * t94 + fields[13] * t97;
        let t100 = t72 * (0.5 * t71) + fields[5] * t85 + fields[8] * t88
            + fields[11] * t94 + fields[14] * t97;
        let t101 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11]
            - (stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
                + stress_free[5] * stress_free[14]);
        let t102 = fields[12] * rates[3] + fields[3] * rates[12]
            + (fields[13] * rates[4] + fields[4] * rates[13])
            + (fields[14] * rates[5] + fields[5] * rates[14]);
        let t103 = fields[9] * rates[6] + fields[6] * rates[9]
            + (fields[10] * rates[7] + fields[7] * rates[10])
            + (fields[11] * rates[8] + fields[8] * rates[11]);
        let t104 = GJ * (0.5 * t67 - 0.5 * t101 + damping * (0.5 * (t103 - t102)));
        let t105 = t77 * (0.5 * t74) + fields[0] * t85 + fields[6] * t91
            - t104 * (fields[12] * 0.5);
        let t106 = t77 * (0.5 * t75) + fields[1] * t85 + fields[7] * t91
            - t104 * (fields[13] * 0.5);
        let t107 = t77 * (0.5 * t76) + fields[2] * t85 + fields[8] * t91
            - t104 * (fields[14] * 0.5);
        let t108 = t82 * (0.5 * t79) + fields[0] * t88 + fields[3] * t91
            + t104 * (fields[9] * 0.5);
        let t109 = t82 * (0.5 * t80) + fields[1] * t88 + fields[4] * t91
            + t104 * (fields[10] * 0.5);
        let t110 = t82 * (0.5 * t81) + fields[2] * t88 + fields[5] * t91
            + t104 * (fields[11] * 0.5);
        let t111 = fields[3] * fields[9] + fields[4] * fields[10]
            + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t112 = fields[9] * rates[3] + fields[3] * rates[9]
            + (fields[10] * rates[4] + fields[4] * rates[10])
            + (fields[11] * rates[5] + fields[5] * rates[11]);
        let t113 = GIz * (t111 + damping * t112);
        let t114 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t115 = fields[12] * rates[6] + fields[6] * rates[12]
            + (fields[13] * rates[7] + fields[7] * rates[13])
            + (fields[14] * rates[8] + fields[8] * rates[14]);
        let t116 = GIy * (t114 + damping * t115);
        forces[0] = t98;
        forces[1] = t99;
        forces[2] = t100;
        forces[3] = t105 + fields[9] * t113;
        forces[4] = t106 + fields[10] * t113;
        forces[5] = t107 + fields[11] * t113;
        forces[6] = t108 + fields[12] * t116;
        forces[7] = t109 + fields[13] * t116;
        forces[8] = t110 + fields[14] * t116;
        forces[9] = fields[0] * t94 + t104 * (fields[6] * 0.5) + fields[3] * t113;
        forces[10] = fields[1] * t94 + t104 * (fields[7] * 0.5) + fields[4] * t113;
        forces[11] = fields[2] * t94 + t104 * (fields[8] * 0.5) + fields[5] * t113;
        forces[12] = fields[0] * t97 - t104 * (fields[3] * 0.5) + fields[6] * t116;
        forces[13] = fields[1] * t97 - t104 * (fields[4] * 0.5) + fields[7] * t116;
        forces[14] = fields[2] * t97 - t104 * (fields[5] * 0.5) + fields[8] * t116;
    }
    /// Motion of frame `rotor` and its first two derivatives.
    ///
    /// Operations: 8 additions, 13 multiplications, 6 divisions, 4 function calls.
    pub fn frame_rotor(
        model: &super::Motor,
        t: f64,
        motion: &mut ::rncf::mesh::FrameMotion,
    ) {
        *motion = ::rncf::mesh::FrameMotion::INERTIAL;
        let t15 = model.speed / model.T_s;
        let t16 = (model.T_s / 6.283185307179586).powi(2);
        let t17 = t * 6.283185307179586 / model.T_s;
        let t18 = t17.cos();
        let theta = (if t <= model.T_s {
            t15 * (t * t / 2.0 + t16 * (t18 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t20 = theta.cos();
        let t21 = theta.sin();
        let t22 = 6.283185307179586 / model.T_s;
        let theta_t = (if t <= model.T_s {
            t15 * (t - t16 * (t22 * t17.sin()))
        } else {
            model.speed
        });
        let theta_t_t = (if t <= model.T_s {
            t15 * (1.0 - t16 * (t22 * (t18 * t22)))
        } else {
            0.0
        });
        motion.spin[0] = theta_t;
        motion.spin_rate[0] = theta_t_t;
        motion.rotation[1][1] = t20;
        motion.rotation[1][2] = -t21;
        motion.rotation[2][1] = t21;
        motion.rotation[2][2] = t20;
    }
    /// Joint `drive_end`: conditions, position level.
    ///
    /// Operations: 11 additions, 12 multiplications.
    pub fn joint_drive_end_referenced_position(
        model: &super::Motor,
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
        rows[5] = data.second[1][0] * q[6] + data.second[1][1] * q[7]
            + data.second[1][2] * q[8];
        rows[6] = data.second[2][0] * q[6] + data.second[2][1] * q[7]
            + data.second[2][2] * q[8];
    }
    /// Joint `drive_end`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_jacobian(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = data.normals[0][0];
        jacobian[31] = data.normals[0][1];
        jacobian[32] = data.normals[0][2];
        jacobian[39] = data.normals[1][0];
        jacobian[40] = data.normals[1][1];
        jacobian[41] = data.normals[1][2];
        jacobian[51] = data.second[1][0];
        jacobian[52] = data.second[1][1];
        jacobian[53] = data.second[1][2];
        jacobian[60] = data.second[2][0];
        jacobian[61] = data.second[2][1];
        jacobian[62] = data.second[2][2];
    }
    /// Joint `drive_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = data.second[0][1];
        prescribed.second[0][2] = data.second[0][2];
    }
    /// Joint `drive_end`: conditions, position level.
    ///
    /// Operations: 25 additions, 38 multiplications, 5 divisions, 3 function calls.
    pub fn joint_drive_end_absolute_position(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t39 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t39
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t41 = theta.cos();
        let t42 = theta.sin();
        let t43 = data.normals[0][0] * q[3]
            + q[4] * (t41 * data.normals[0][1] - t42 * data.normals[0][2])
            + q[5] * (t42 * data.normals[0][1] + t41 * data.normals[0][2]);
        let t44 = data.normals[1][0] * q[3]
            + q[4] * (t41 * data.normals[1][1] - t42 * data.normals[1][2])
            + q[5] * (t42 * data.normals[1][1] + t41 * data.normals[1][2]);
        let t45 = data.second[1][0] * q[6]
            + q[7] * (t41 * data.second[1][1] - t42 * data.second[1][2])
            + q[8] * (t42 * data.second[1][1] + t41 * data.second[1][2]);
        let t46 = data.second[2][0] * q[6]
            + q[7] * (t41 * data.second[2][1] - t42 * data.second[2][2])
            + q[8] * (t42 * data.second[2][1] + t41 * data.second[2][2]);
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t41 * data.point[1] - t42 * data.point[2]);
        rows[2] = q[2] - (t42 * data.point[1] + t41 * data.point[2]);
        rows[3] = t43;
        rows[4] = t44;
        rows[5] = t45;
        rows[6] = t46;
    }
    /// Joint `drive_end`: conditions, velocity level.
    ///
    /// Operations: 20 additions, 39 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_velocity(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t29 = model.speed / model.T_s;
        let t30 = (model.T_s / 6.283185307179586).powi(2);
        let t31 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t29 * (t * t / 2.0 + t30 * (t31.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t33 = (if t <= model.T_s {
            t29 * (t - t30 * (6.283185307179586 / model.T_s * t31.sin()))
        } else {
            model.speed
        });
        let t34 = theta.sin() * t33;
        let t35 = theta.cos() * t33;
        let t36 = q[5] * (data.normals[0][1] * t35 - data.normals[0][2] * t34)
            - q[4] * (data.normals[0][1] * t34 + data.normals[0][2] * t35);
        let t37 = q[5] * (data.normals[1][1] * t35 - data.normals[1][2] * t34)
            - q[4] * (data.normals[1][1] * t34 + data.normals[1][2] * t35);
        let t38 = q[8] * (data.second[1][1] * t35 - data.second[1][2] * t34)
            - q[7] * (data.second[1][1] * t34 + data.second[1][2] * t35);
        let t39 = q[8] * (data.second[2][1] * t35 - data.second[2][2] * t34)
            - q[7] * (data.second[2][1] * t34 + data.second[2][2] * t35);
        rows[1] = data.point[1] * t34 + data.point[2] * t35;
        rows[2] = data.point[2] * t34 - data.point[1] * t35;
        rows[3] = t36;
        rows[4] = t37;
        rows[5] = t38;
        rows[6] = t39;
    }
    /// Joint `drive_end`: conditions, acceleration level.
    ///
    /// Operations: 48 additions, 71 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_acceleration(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t33 = model.speed / model.T_s;
        let t34 = (model.T_s / 6.283185307179586).powi(2);
        let t35 = t * 6.283185307179586 / model.T_s;
        let t36 = t35.cos();
        let theta = (if t <= model.T_s {
            t33 * (t * t / 2.0 + t34 * (t36 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t38 = theta.cos();
        let t39 = theta.sin();
        let t40 = 6.283185307179586 / model.T_s;
        let t41 = (if t <= model.T_s {
            t33 * (t - t34 * (t40 * t35.sin()))
        } else {
            model.speed
        });
        let t42 = t39 * t41;
        let t43 = t38 * t41;
        let t44 = (if t <= model.T_s {
            t33 * (1.0 - t34 * (t40 * (t36 * t40)))
        } else {
            0.0
        });
        let t45 = t41 * t43 + t39 * t44;
        let t46 = t38 * t44 - t41 * t42;
        let t47 = v[4] * (data.normals[0][1] * t42 + data.normals[0][2] * t43);
        let t48 = v[5] * (data.normals[0][1] * t43 - data.normals[0][2] * t42);
        let t49 = v[4] * (data.normals[1][1] * t42 + data.normals[1][2] * t43);
        let t50 = v[5] * (data.normals[1][1] * t43 - data.normals[1][2] * t42);
        let t51 = v[7] * (data.second[1][1] * t42 + data.second[1][2] * t43);
        let t52 = v[8] * (data.second[1][1] * t43 - data.second[1][2] * t42);
        let t53 = v[7] * (data.second[2][1] * t42 + data.second[2][2] * t43);
        let t54 = v[8] * (data.second[2][1] * t43 - data.second[2][2] * t42);
        let t55 = t48
            + (t48 + q[5] * (data.normals[0][1] * t46 - data.normals[0][2] * t45))
            - (t47
                + (t47 + q[4] * (data.normals[0][1] * t45 + data.normals[0][2] * t46)));
        let t56 = t50
            + (t50 + q[5] * (data.normals[1][1] * t46 - data.normals[1][2] * t45))
            - (t49
                + (t49 + q[4] * (data.normals[1][1] * t45 + data.normals[1][2] * t46)));
        let t57 = t52
            + (t52 + q[8] * (data.second[1][1] * t46 - data.second[1][2] * t45))
            - (t51 + (t51 + q[7] * (data.second[1][1] * t45 + data.second[1][2] * t46)));
        let t58 = t54
            + (t54 + q[8] * (data.second[2][1] * t46 - data.second[2][2] * t45))
            - (t53 + (t53 + q[7] * (data.second[2][1] * t45 + data.second[2][2] * t46)));
        rows[1] = data.point[1] * t45 + data.point[2] * t46;
        rows[2] = data.point[2] * t45 - data.point[1] * t46;
        rows[3] = t55;
        rows[4] = t56;
        rows[5] = t57;
        rows[6] = t58;
    }
    /// Joint `drive_end`: conditions, jerk level.
    ///
    /// Operations: 87 additions, 105 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_jerk(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t37 = model.speed / model.T_s;
        let t38 = (model.T_s / 6.283185307179586).powi(2);
        let t39 = t * 6.283185307179586 / model.T_s;
        let t40 = t39.cos();
        let theta = (if t <= model.T_s {
            t37 * (t * t / 2.0 + t38 * (t40 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t42 = theta.cos();
        let t43 = theta.sin();
        let t44 = 6.283185307179586 / model.T_s;
        let t45 = t44 * t39.sin();
        let t46 = (if t <= model.T_s { t37 * (t - t38 * t45) } else { model.speed });
        let t47 = t43 * t46;
        let t48 = t42 * t46;
        let t49 = (if t <= model.T_s {
            t37 * (1.0 - t38 * (t44 * (t40 * t44)))
        } else {
            0.0
        });
        let t50 = t46 * t48 + t43 * t49;
        let t51 = t42 * t49 - t46 * t47;
        let t52 = (if t <= model.T_s { t37 * (t38 * (t44 * (t44 * t45))) } else { 0.0 });
        let t53 = t48 * t49;
        let t54 = t53 + t46 * t51 + (t53 + t43 * t52);
        let t55 = t47 * t49;
        let t56 = t42 * t52 - t55 - (t55 + t46 * t50);
        let t57 = a[4] * (data.normals[0][1] * t47 + data.normals[0][2] * t48);
        let t58 = v[4] * (data.normals[0][1] * t50 + data.normals[0][2] * t51);
        let t59 = t57 + t58;
        let t60 = a[5] * (data.normals[0][1] * t48 - data.normals[0][2] * t47);
        let t61 = v[5] * (data.normals[0][1] * t51 - data.normals[0][2] * t50);
        let t62 = t60 + t61;
        let t63 = t60 + t62
            + (t62
                + (t61 + q[5] * (data.normals[0][1] * t56 - data.normals[0][2] * t54)))
            - (t57 + t59
                + (t59
                    + (t58
                        + q[4]
                            * (data.normals[0][1] * t54 + data.normals[0][2] * t56))));
        let t64 = a[4] * (data.normals[1][1] * t47 + data.normals[1][2] * t48);
        let t65 = v[4] * (data.normals[1][1] * t50 + data.normals[1][2] * t51);
        let t66 = t64 + t65;
        let t67 = a[5] * (data.normals[1][1] * t48 - data.normals[1][2] * t47);
        let t68 = v[5] * (data.normals[1][1] * t51 - data.normals[1][2] * t50);
        let t69 = t67 + t68;
        let t70 = t67 + t69
            + (t69
                + (t68 + q[5] * (data.normals[1][1] * t56 - data.normals[1][2] * t54)))
            - (t64 + t66
                + (t66
                    + (t65
                        + q[4]
                            * (data.normals[1][1] * t54 + data.normals[1][2] * t56))));
        let t71 = a[7] * (data.second[1][1] * t47 + data.second[1][2] * t48);
        let t72 = v[7] * (data.second[1][1] * t50 + data.second[1][2] * t51);
        let t73 = t71 + t72;
        let t74 = a[8] * (data.second[1][1] * t48 - data.second[1][2] * t47);
        let t75 = v[8] * (data.second[1][1] * t51 - data.second[1][2] * t50);
        let t76 = t74 + t75;
        let t77 = t74 + t76
            + (t76 + (t75 + q[8] * (data.second[1][1] * t56 - data.second[1][2] * t54)))
            - (t71 + t73
                + (t73
                    + (t72
                        + q[7] * (data.second[1][1] * t54 + data.second[1][2] * t56))));
        let t78 = a[7] * (data.second[2][1] * t47 + data.second[2][2] * t48);
        let t79 = v[7] * (data.second[2][1] * t50 + data.second[2][2] * t51);
        let t80 = t78 + t79;
        let t81 = a[8] * (data.second[2][1] * t48 - data.second[2][2] * t47);
        let t82 = v[8] * (data.second[2][1] * t51 - data.second[2][2] * t50);
        let t83 = t81 + t82;
        let t84 = t81 + t83
            + (t83 + (t82 + q[8] * (data.second[2][1] * t56 - data.second[2][2] * t54)))
            - (t78 + t80
                + (t80
                    + (t79
                        + q[7] * (data.second[2][1] * t54 + data.second[2][2] * t56))));
        rows[1] = data.point[1] * t54 + data.point[2] * t56;
        rows[2] = data.point[2] * t54 - data.point[1] * t56;
        rows[3] = t63;
        rows[4] = t70;
        rows[5] = t77;
        rows[6] = t84;
    }
    /// Joint `drive_end`: derivatives of the conditions.
    ///
    /// Operations: 12 additions, 22 multiplications, 5 divisions, 3 function calls.
    pub fn joint_drive_end_absolute_jacobian(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        let t27 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t27
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
        jacobian[30] = data.normals[0][0];
        jacobian[31] = t29 * data.normals[0][1] - t30 * data.normals[0][2];
        jacobian[32] = t30 * data.normals[0][1] + t29 * data.normals[0][2];
        jacobian[39] = data.normals[1][0];
        jacobian[40] = t29 * data.normals[1][1] - t30 * data.normals[1][2];
        jacobian[41] = t30 * data.normals[1][1] + t29 * data.normals[1][2];
        jacobian[51] = data.second[1][0];
        jacobian[52] = t29 * data.second[1][1] - t30 * data.second[1][2];
        jacobian[53] = t30 * data.second[1][1] + t29 * data.second[1][2];
        jacobian[60] = data.second[2][0];
        jacobian[61] = t29 * data.second[2][1] - t30 * data.second[2][2];
        jacobian[62] = t30 * data.second[2][1] + t29 * data.second[2][2];
    }
    /// Joint `drive_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 28 additions, 55 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t24 = model.speed / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.speed
        });
        let t33 = t30 * t32;
        let t34 = t29 * t32;
        let t35 = (if t <= model.T_s {
            t24 * (1.0 - t25 * (t31 * (t27 * t31)))
        } else {
            0.0
        });
        let t36 = t32 * t34 + t30 * t35;
        let t37 = t29 * t35 - t32 * t33;
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t29 * data.point[1] - t30 * data.point[2];
        prescribed.position[0][2] = t30 * data.point[1] + t29 * data.point[2];
        prescribed.position[1][1] = -(data.point[1] * t33 + data.point[2] * t34);
        prescribed.position[1][2] = data.point[1] * t34 - data.point[2] * t33;
        prescribed.position[2][1] = -(data.point[1] * t36 + data.point[2] * t37);
        prescribed.position[2][2] = data.point[1] * t37 - data.point[2] * t36;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t29 * data.tangent[1] - t30 * data.tangent[2];
        prescribed.slope[0][2] = t30 * data.tangent[1] + t29 * data.tangent[2];
        prescribed.slope[1][1] = -(data.tangent[1] * t33 + data.tangent[2] * t34);
        prescribed.slope[1][2] = data.tangent[1] * t34 - data.tangent[2] * t33;
        prescribed.slope[2][1] = -(data.tangent[1] * t36 + data.tangent[2] * t37);
        prescribed.slope[2][2] = data.tangent[1] * t37 - data.tangent[2] * t36;
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = t29 * data.second[0][1] - t30 * data.second[0][2];
        prescribed.second[0][2] = t30 * data.second[0][1] + t29 * data.second[0][2];
        prescribed.second[1][1] = -(data.second[0][1] * t33 + data.second[0][2] * t34);
        prescribed.second[1][2] = data.second[0][1] * t34 - data.second[0][2] * t33;
        prescribed.second[2][1] = -(data.second[0][1] * t36 + data.second[0][2] * t37);
        prescribed.second[2][2] = data.second[0][1] * t37 - data.second[0][2] * t36;
    }
    /// Joint `far_end`: conditions, position level.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn joint_far_end_referenced_position(
        model: &super::Motor,
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
    }
    /// Joint `far_end`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_jacobian(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
    }
    /// Joint `far_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = data.second[0][1];
        prescribed.second[0][2] = data.second[0][2];
    }
    /// Joint `far_end`: conditions, position level.
    ///
    /// Operations: 9 additions, 10 multiplications, 5 divisions, 3 function calls.
    pub fn joint_far_end_absolute_position(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t21 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t21
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t23 * data.point[1] - t24 * data.point[2]);
        rows[2] = q[2] - (t24 * data.point[1] + t23 * data.point[2]);
    }
    /// Joint `far_end`: conditions, velocity level.
    ///
    /// Operations: 8 additions, 15 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_velocity(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t19.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t21 = (if t <= model.T_s {
            t17 * (t - t18 * (6.283185307179586 / model.T_s * t19.sin()))
        } else {
            model.speed
        });
        let t22 = theta.sin() * t21;
        let t23 = theta.cos() * t21;
        rows[1] = data.point[1] * t22 + data.point[2] * t23;
        rows[2] = data.point[2] * t22 - data.point[1] * t23;
    }
    /// Joint `far_end`: conditions, acceleration level.
    ///
    /// Operations: 12 additions, 23 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_acceleration(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let t20 = t19.cos();
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t20 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t22 = theta.cos();
        let t23 = theta.sin();
        let t24 = 6.283185307179586 / model.T_s;
        let t25 = (if t <= model.T_s {
            t17 * (t - t18 * (t24 * t19.sin()))
        } else {
            model.speed
        });
        let t26 = (if t <= model.T_s {
            t17 * (1.0 - t18 * (t24 * (t20 * t24)))
        } else {
            0.0
        });
        let t27 = t25 * (t22 * t25) + t23 * t26;
        let t28 = t22 * t26 - t25 * (t23 * t25);
        rows[1] = data.point[1] * t27 + data.point[2] * t28;
        rows[2] = data.point[2] * t27 - data.point[1] * t28;
    }
    /// Joint `far_end`: conditions, jerk level.
    ///
    /// Operations: 19 additions, 33 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_jerk(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t17 = model.speed / model.T_s;
        let t18 = (model.T_s / 6.283185307179586).powi(2);
        let t19 = t * 6.283185307179586 / model.T_s;
        let t20 = t19.cos();
        let theta = (if t <= model.T_s {
            t17 * (t * t / 2.0 + t18 * (t20 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t22 = theta.cos();
        let t23 = theta.sin();
        let t24 = 6.283185307179586 / model.T_s;
        let t25 = t24 * t19.sin();
        let t26 = (if t <= model.T_s { t17 * (t - t18 * t25) } else { model.speed });
        let t27 = t23 * t26;
        let t28 = t22 * t26;
        let t29 = (if t <= model.T_s {
            t17 * (1.0 - t18 * (t24 * (t20 * t24)))
        } else {
            0.0
        });
        let t30 = (if t <= model.T_s { t17 * (t18 * (t24 * (t24 * t25))) } else { 0.0 });
        let t31 = t28 * t29;
        let t32 = t31 + t26 * (t22 * t29 - t26 * t27) + (t31 + t23 * t30);
        let t33 = t27 * t29;
        let t34 = t22 * t30 - t33 - (t33 + t26 * (t26 * t28 + t23 * t29));
        rows[1] = data.point[1] * t32 + data.point[2] * t34;
        rows[2] = data.point[2] * t32 - data.point[1] * t34;
    }
    /// Joint `far_end`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_absolute_jacobian(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 1.0;
        jacobian[10] = 1.0;
        jacobian[20] = 1.0;
    }
    /// Joint `far_end`: what it prescribes, and its derivatives.
    ///
    /// Operations: 28 additions, 55 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t24 = model.speed / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.speed
        });
        let t33 = t30 * t32;
        let t34 = t29 * t32;
        let t35 = (if t <= model.T_s {
            t24 * (1.0 - t25 * (t31 * (t27 * t31)))
        } else {
            0.0
        });
        let t36 = t32 * t34 + t30 * t35;
        let t37 = t29 * t35 - t32 * t33;
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t29 * data.point[1] - t30 * data.point[2];
        prescribed.position[0][2] = t30 * data.point[1] + t29 * data.point[2];
        prescribed.position[1][1] = -(data.point[1] * t33 + data.point[2] * t34);
        prescribed.position[1][2] = data.point[1] * t34 - data.point[2] * t33;
        prescribed.position[2][1] = -(data.point[1] * t36 + data.point[2] * t37);
        prescribed.position[2][2] = data.point[1] * t37 - data.point[2] * t36;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t29 * data.tangent[1] - t30 * data.tangent[2];
        prescribed.slope[0][2] = t30 * data.tangent[1] + t29 * data.tangent[2];
        prescribed.slope[1][1] = -(data.tangent[1] * t33 + data.tangent[2] * t34);
        prescribed.slope[1][2] = data.tangent[1] * t34 - data.tangent[2] * t33;
        prescribed.slope[2][1] = -(data.tangent[1] * t36 + data.tangent[2] * t37);
        prescribed.slope[2][2] = data.tangent[1] * t37 - data.tangent[2] * t36;
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = t29 * data.second[0][1] - t30 * data.second[0][2];
        prescribed.second[0][2] = t30 * data.second[0][1] + t29 * data.second[0][2];
        prescribed.second[1][1] = -(data.second[0][1] * t33 + data.second[0][2] * t34);
        prescribed.second[1][2] = data.second[0][1] * t34 - data.second[0][2] * t33;
        prescribed.second[2][1] = -(data.second[0][1] * t36 + data.second[0][2] * t37);
        prescribed.second[2][2] = data.second[0][1] * t37 - data.second[0][2] * t36;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &super::Motor, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn outputs(model: &super::Motor, t: f64, observed: &[f64], out: &mut [f64]) {
        out[0] = observed[0];
        out[1] = observed[1];
        out[2] = observed[2];
        out[3] = observed[3];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &super::Motor, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.2;
        run.every = 0.001;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::Motor,
        pub row_shaft: BeamSpatialDamped,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::Motor) -> Self {
            Self {
                model: model.clone(),
                row_shaft: Default::default(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "shaft",
                    kind: 0,
                    instance: None,
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [1.02, 0.0, 0.0],
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
                            meaning: "section y axis",
                            of: ::rncf::mesh::Interpolant::SectionY,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::mesh::Interpolant::SectionZ,
                            order: 0,
                            xi: 0.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "section y axis",
                            of: ::rncf::mesh::Interpolant::SectionY,
                            order: 0,
                            xi: 0.5,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::mesh::Interpolant::SectionZ,
                            order: 0,
                            xi: 0.5,
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
                        ::rncf::mesh::NodalSpec {
                            meaning: "section y axis",
                            of: ::rncf::mesh::Interpolant::SectionY,
                            order: 0,
                            xi: 1.0,
                        },
                        ::rncf::mesh::NodalSpec {
                            meaning: "section z axis",
                            of: ::rncf::mesh::Interpolant::SectionZ,
                            order: 0,
                            xi: 1.0,
                        },
                    ],
                    connectivity: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
                    vectors_per_node: 4,
                    stride: 6,
                    section_y: None,
                    twist: 0.0,
                    fidelity: ::rncf::mesh::Fidelity::Full,
                    tie: ::rncf::mesh::FrameTie::Joints,
                },
            ])
        }
        fn prepare(
            &mut self,
            body: usize,
            length: f64,
            shape: &[f64],
        ) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            let density = ::rncf::mesh::positive(
                "material `steel`",
                "density",
                7800.0,
                "kg/m^3",
            )?;
            let young = ::rncf::mesh::positive(
                "material `steel`",
                "young",
                210000000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::mesh::poisson(
                "material `steel`",
                "poisson",
                0.3,
                "1",
            )?;
            let damping = ::rncf::mesh::non_negative(
                "material `steel`",
                "damping",
                model.damping,
                "s",
            )?;
            let yield_stress = ::rncf::mesh::positive(
                "material `steel`",
                "yield",
                355000000.0,
                "Pa",
            )?;
            let area = ::rncf::mesh::positive(
                "section `round`",
                "area",
                0.007853981633974483,
                "m^2",
            )?;
            let second_moment_y = ::rncf::mesh::positive(
                "section `round`",
                "second_moment_y",
                4.908738521234054e-6,
                "m^4",
            )?;
            let second_moment_z = ::rncf::mesh::positive(
                "section `round`",
                "second_moment_z",
                4.908738521234054e-6,
                "m^4",
            )?;
            let torsion_constant = ::rncf::mesh::positive(
                "section `round`",
                "torsion_constant",
                9.817477042468108e-6,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::mesh::positive(
                "section `round`",
                "shear_factor_y",
                0.8863636363636362,
                "1",
            )?;
            let shear_factor_z = ::rncf::mesh::positive(
                "section `round`",
                "shear_factor_z",
                0.8863636363636362,
                "1",
            )?;
            let radius = ::rncf::mesh::positive("section `round`", "radius", 0.05, "m")?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            self.row_shaft = BeamSpatialDamped {
                length,
                EA: young * area,
                kyGA: shear_factor_y * shear_modulus * area,
                kzGA: shear_factor_z * shear_modulus * area,
                GA: shear_modulus * area,
                EIz: young * second_moment_z,
                EIy: young * second_moment_y,
                GJ: shear_modulus * torsion_constant,
                GIz: shear_modulus * second_moment_z,
                GIy: shear_modulus * second_moment_y,
                rhoA: density * area,
                rhoIz: density * second_moment_z,
                rhoIy: density * second_moment_y,
                damping: damping,
            };
            Ok(())
        }
        fn mass(&self, body: usize, mass: &mut [f64]) {
            beam_spatial_damped_mass(&self.row_shaft, ::rncf::mesh::array_mut(mass));
        }
        fn elastic_force(
            &self,
            body: usize,
            element: usize,
            q: &[f64],
            v: &[f64],
            force: &mut [f64],
        ) {
            beam_spatial_damped_elastic_force(
                &self.row_shaft,
                ::rncf::mesh::array(q),
                ::rncf::mesh::array(v),
                ::rncf::mesh::array_mut(force),
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
            beam_spatial_damped_elastic_tangent(
                &self.row_shaft,
                ::rncf::mesh::array(q),
                ::rncf::mesh::array(v),
                ::rncf::mesh::array_mut(stiffness),
                ::rncf::mesh::array_mut(damping),
            );
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            beam_spatial_damped_strain_energy(
                &self.row_shaft,
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
                    beam_spatial_damped_shapes_position_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 1) => {
                    beam_spatial_damped_shapes_position_1(
                        self.row_shaft.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionY, 0) => {
                    beam_spatial_damped_shapes_section_y_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionY, 1) => {
                    beam_spatial_damped_shapes_section_y_1(
                        self.row_shaft.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionZ, 0) => {
                    beam_spatial_damped_shapes_section_z_0(
                        self.row_shaft.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionZ, 1) => {
                    beam_spatial_damped_shapes_section_z_1(
                        self.row_shaft.length,
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
                shape: ::rncf::mesh::SectionShape::Circle {
                    radius: 0.05,
                },
                area: 0.007853981633974483,
                second_moments: [4.908738521234054e-6, 4.908738521234054e-6],
                torsion_constant: 9.817477042468108e-6,
                yield_stress: Some(355000000.0),
                material: "steel",
            }
        }
        fn fields(&self, body: usize) -> &'static [(::rncf::mesh::Interpolant, usize)] {
            &[
                (::rncf::mesh::Interpolant::Position, 1),
                (::rncf::mesh::Interpolant::SectionY, 0),
                (::rncf::mesh::Interpolant::SectionZ, 0),
                (::rncf::mesh::Interpolant::SectionY, 1),
                (::rncf::mesh::Interpolant::SectionZ, 1),
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
            beam_spatial_damped_field_forces(
                &self.row_shaft,
                ::rncf::mesh::array(stress_free),
                ::rncf::mesh::array(fields),
                ::rncf::mesh::array(rates),
                ::rncf::mesh::array_mut(forces),
            );
        }
        fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {
            Some("body `shaft` is damped")
        }
        fn joints(&self) -> ::std::vec::Vec<::rncf::mesh::JointSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::JointSpec {
                    name: "drive_end",
                    kind: ::rncf::mesh::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 1,
                    point: None,
                },
                ::rncf::mesh::JointSpec {
                    name: "far_end",
                    kind: ::rncf::mesh::JointKind::Pin,
                    body: 0,
                    at_end: true,
                    frame: 1,
                    point: None,
                },
            ])
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
                            joint_drive_end_referenced_position(
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
                (0, _) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            joint_drive_end_absolute_position(
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
                            joint_drive_end_absolute_velocity(
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
                            joint_drive_end_absolute_acceleration(
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
                            joint_drive_end_absolute_jerk(
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
                            joint_far_end_referenced_position(
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
                (1, _) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            joint_far_end_absolute_position(
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
                            joint_far_end_absolute_velocity(
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
                            joint_far_end_absolute_acceleration(
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
                            joint_far_end_absolute_jerk(
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
                    joint_drive_end_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (0, _) => {
                    joint_drive_end_absolute_jacobian(&self.model, t, data, jacobian);
                }
                (1, false) => {
                    joint_far_end_referenced_jacobian(&self.model, t, data, jacobian);
                }
                (1, _) => {
                    joint_far_end_absolute_jacobian(&self.model, t, data, jacobian);
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
                    joint_drive_end_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (0, _) => {
                    joint_drive_end_absolute_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (1, false) => {
                    joint_far_end_referenced_prescribed(
                        &self.model,
                        t,
                        data,
                        prescribed,
                    );
                }
                (1, _) => {
                    joint_far_end_absolute_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
        fn observed(&self) -> ::std::vec::Vec<::rncf::mesh::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.51),
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.51),
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::mesh::ObservedSpec::Section {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::SectionQuantity::MomentZ,
                },
                ::rncf::mesh::ObservedSpec::Section {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::SectionQuantity::Stress,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            4
        }
        fn frame_count(&self) -> usize {
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "rotor"][frame]
        }
        fn conservative(&self) -> bool {
            false
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 1];
            kinks(&self.model, &mut times);
            times.to_vec()
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
            frame_rotor(&self.model, t, &mut motions[1]);
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn fixtures(&self) -> ::std::vec::Vec<::rncf::mesh::FixtureSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::FixtureSpec {
                    name: "disc",
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.51),
                    constants: [
                        2.450442269800039,
                        0.0,
                        model.eccentricity * 2.450442269800039,
                        0.0,
                        2.0420352248333093e-5,
                        0.006126105674500098
                            + model.eccentricity
                                * (model.eccentricity * 2.450442269800039),
                        0.006126105674500098,
                        0.0,
                        0.0,
                        0.0,
                    ],
                },
            ])
        }
    }
}
