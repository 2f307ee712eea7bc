//! Expansion of `models/src/motor.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end
/// carries an unbalanced disc in its middle.
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
        "Body `shaft` uses `beam_spatial_damped`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1929 and 25760).",
        "Body `shaft` moves in the prescribed frame `rotor`: no unknowns for the frame, its reactions are evaluated.",
        "Fixture `disc` adds constants to the inertia of `shaft` and no unknowns.",
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
    fn build(
        &self,
        formulation: ::rncf::Formulation,
        joints: ::rncf::Joints,
    ) -> ::std::result::Result<
        ::std::boxed::Box<dyn ::rncf::Scene>,
        ::rncf::ModelError,
    > {
        ::rncf::mesh::check_params(self)?;
        let equations = motor_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
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
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1929 and 25760).
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
        let t39 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t40 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t41 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t42 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t43 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t44 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t45 = length * EA;
        let t46 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t47 = 0.5 * (t45 * t46);
        let t48 = length * kyGA * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t40);
        let t49 = length * kzGA * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t41);
        let t50 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t42 + t42));
        let t51 = 0.5 * (t45 * t50);
        let t52 = length * GA * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t43);
        let t53 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t44 + t44));
        let t54 = 0.5 * (t45 * t53);
        forces[0][0] = t47 * (a_x * 2.0) + b_x * t48 + c_x * t49;
        forces[0][1] = t47 * (a_y * 2.0) + b_y * t48 + c_y * t49;
        forces[0][2] = t47 * (a_z * 2.0) + b_z * t48 + c_z * t49;
        forces[1][0] = a_x * t48 + t51 * (b_x * 2.0) + c_x * t52;
        forces[1][1] = a_y * t48 + t51 * (b_y * 2.0) + c_y * t52;
        forces[1][2] = a_z * t48 + t51 * (b_z * 2.0) + c_z * t52;
        forces[2][0] = a_x * t49 + b_x * t52 + t54 * (c_x * 2.0);
        forces[2][1] = a_y * t49 + b_y * t52 + t54 * (c_y * 2.0);
        forces[2][2] = a_z * t49 + b_z * t52 + t54 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 288 additions, 504 multiplications.
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
        let t39 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
        let t40 = b_x * v_a_x + b_y * v_a_y + b_z * v_a_z
            + (a_x * v_b_x + a_y * v_b_y + a_z * v_b_z);
        let t41 = c_x * v_a_x + c_y * v_a_y + c_z * v_a_z
            + (a_x * v_c_x + a_y * v_c_y + a_z * v_c_z);
        let t42 = b_x * v_b_x + b_y * v_b_y + b_z * v_b_z;
        let t43 = c_x * v_b_x + c_y * v_b_y + c_z * v_b_z
            + (b_x * v_c_x + b_y * v_c_y + b_z * v_c_z);
        let t44 = c_x * v_c_x + c_y * v_c_y + c_z * v_c_z;
        let t45 = length * EA;
        let t46 = length * kyGA;
        let t47 = length * kzGA;
        let t48 = length * GA;
        let t49 = 0.5 * (0.5 * t45);
        let t50 = 0.5 * (t45 * (damping * 0.5));
        let t51 = damping * t46;
        let t52 = damping * t47;
        let t53 = damping * t48;
        let t54 = 0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)
            + damping * (0.5 * (t39 + t39));
        let t55 = t46 * (a_x * b_x + a_y * b_y + a_z * b_z + damping * t40);
        let t56 = t47 * (a_x * c_x + a_y * c_y + a_z * c_z + damping * t41);
        let t57 = 0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)
            + damping * (0.5 * (t42 + t42));
        let t58 = t48 * (b_x * c_x + b_y * c_y + b_z * c_z + damping * t43);
        let t59 = 0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)
            + damping * (0.5 * (t44 + t44));
        let t60 = a_x * 2.0;
        let t61 = a_y * 2.0;
        let t62 = a_z * 2.0;
        let t63 = b_x * 2.0;
        let t64 = b_y * 2.0;
        let t65 = b_z * 2.0;
        let t66 = c_x * 2.0;
        let t67 = c_y * 2.0;
        let t68 = c_z * 2.0;
        let t69 = t49 * t61;
        let t70 = t49 * t62;
        let t71 = b_y * t46;
        let t72 = b_z * t46;
        let t73 = a_x * t46;
        let t74 = a_y * t46;
        let t75 = a_z * t46;
        let t76 = c_y * t47;
        let t77 = c_z * t47;
        let t78 = a_x * t47;
        let t79 = a_y * t47;
        let t80 = a_z * t47;
        let t81 = t49 * t64;
        let t82 = t49 * t65;
        let t83 = c_y * t48;
        let t84 = c_z * t48;
        let t85 = b_x * t48;
        let t86 = b_y * t48;
        let t87 = b_z * t48;
        let t88 = t49 * t67;
        let t89 = t49 * t68;
        let t90 = b_x * t74;
        let t91 = b_x * t75;
        let t92 = b_y * t73;
        let t93 = b_y * t75;
        let t94 = b_z * t73;
        let t95 = b_z * t74;
        let t96 = t60 * t69 + b_x * t71 + c_x * t76;
        let t97 = t60 * t70 + b_x * t72 + c_x * t77;
        let t98 = t61 * t70 + b_y * t72 + c_y * t77;
        let t99 = c_x * t79;
        let t100 = c_x * t80;
        let t101 = c_y * t78;
        let t102 = c_y * t80;
        let t103 = c_z * t78;
        let t104 = c_z * t79;
        let t105 = a_x * t74 + t63 * t81 + c_x * t83;
        let t106 = a_x * t75 + t63 * t82 + c_x * t84;
        let t107 = a_y * t75 + t64 * t82 + c_y * t84;
        let t108 = c_x * t86;
        let t109 = c_x * t87;
        let t110 = c_y * t85;
        let t111 = c_y * t87;
        let t112 = c_z * t85;
        let t113 = c_z * t86;
        let t114 = a_x * t79 + b_x * t86 + t66 * t88;
        let t115 = a_x * t80 + b_x * t87 + t66 * t89;
        let t116 = a_y * t80 + b_y * t87 + t67 * t89;
        let t117 = 0.5 * (t45 * t54) * 2.0;
        let t118 = t60 * (t49 * t60) + b_x * (b_x * t46) + c_x * (c_x * t47) + t117;
        let t119 = t55 + b_x * t73;
        let t120 = t55 + b_y * t74;
        let t121 = t55 + b_z * t75;
        let t122 = t56 + c_x * t78;
        let t123 = t56 + c_y * t79;
        let t124 = t56 + c_z * t80;
        let t125 = 0.5 * (t45 * t57) * 2.0;
        let t126 = t58 + c_x * t85;
        let t127 = t58 + c_y * t86;
        let t128 = t58 + c_z * t87;
        let t129 = 0.5 * (t45 * t59) * 2.0;
        let t130 = t50 * (v_a_x * 2.0);
        let t131 = t50 * (v_a_y * 2.0);
        let t132 = t50 * (v_a_z * 2.0);
        let t133 = v_b_x * t51;
        let t134 = v_b_y * t51;
        let t135 = v_b_z * t51;
        let t136 = v_a_x * t51;
        let t137 = v_a_y * t51;
        let t138 = v_a_z * t51;
        let t139 = v_c_x * t52;
        let t140 = v_c_y * t52;
        let t141 = v_c_z * t52;
        let t142 = v_a_x * t52;
        let t143 = v_a_y * t52;
        let t144 = v_a_z * t52;
        let t145 = t50 * (v_b_x * 2.0);
        let t146 = t50 * (v_b_y * 2.0);
        let t147 = t50 * (v_b_z * 2.0);
        let t148 = v_c_x * t53;
        let t149 = v_c_y * t53;
        let t150 = v_c_z * t53;
        let t151 = v_b_x * t53;
        let t152 = v_b_y * t53;
        let t153 = v_b_z * t53;
        let t154 = t50 * (v_c_x * 2.0);
        let t155 = t50 * (v_c_y * 2.0);
        let t156 = t50 * (v_c_z * 2.0);
        let t157 = t61 * t69 + b_y * t71 + c_y * t76 + t117
            + (t61 * t131 + b_y * t134 + c_y * t140);
        let t158 = t62 * t70 + b_z * t72 + c_z * t77 + t117
            + (t62 * t132 + b_z * t135 + c_z * t141);
        let t159 = a_x * t73 + t63 * (t49 * t63) + c_x * (c_x * t48) + t125
            + (a_x * t136 + t63 * t145 + c_x * t148);
        let t160 = a_y * t74 + t64 * t81 + c_y * t83 + t125
            + (a_y * t137 + t64 * t146 + c_y * t149);
        let t161 = a_z * t75 + t65 * t82 + c_z * t84 + t125
            + (a_z * t138 + t65 * t147 + c_z * t150);
        let t162 = a_x * t78 + b_x * t85 + t66 * (t49 * t66) + t129
            + (a_x * t142 + b_x * t151 + t66 * t154);
        let t163 = a_y * t79 + b_y * t86 + t67 * t88 + t129
            + (a_y * t143 + b_y * t152 + t67 * t155);
        let t164 = a_z * t80 + b_z * t87 + t68 * t89 + t129
            + (a_z * t144 + b_z * t153 + t68 * t156);
        let t165 = t50 * t60;
        let t166 = t50 * t61;
        let t167 = t50 * t62;
        let t168 = b_x * t51;
        let t169 = b_y * t51;
        let t170 = b_z * t51;
        let t171 = a_x * t51;
        let t172 = a_y * t51;
        let t173 = a_z * t51;
        let t174 = c_x * t52;
        let t175 = c_y * t52;
        let t176 = c_z * t52;
        let t177 = a_x * t52;
        let t178 = a_y * t52;
        let t179 = a_z * t52;
        let t180 = t50 * t63;
        let t181 = t50 * t64;
        let t182 = t50 * t65;
        let t183 = c_x * t53;
        let t184 = c_y * t53;
        let t185 = c_z * t53;
        let t186 = b_x * t53;
        let t187 = b_y * t53;
        let t188 = b_z * t53;
        let t189 = t50 * t66;
        let t190 = t50 * t67;
        let t191 = t50 * t68;
        stiffness[0][0] = t118 + (t60 * t130 + b_x * t133 + c_x * t139);
        stiffness[0][1] = t96 + (t60 * t131 + b_x * t134 + c_x * t140);
        stiffness[0][2] = t97 + (t60 * t132 + b_x * t135 + c_x * t141);
        stiffness[0][3] = t96 + (t61 * t130 + b_y * t133 + c_y * t139);
        stiffness[0][4] = t157;
        stiffness[0][5] = t98 + (t61 * t132 + b_y * t135 + c_y * t141);
        stiffness[0][6] = t97 + (t62 * t130 + b_z * t133 + c_z * t139);
        stiffness[0][7] = t98 + (t62 * t131 + b_z * t134 + c_z * t140);
        stiffness[0][8] = t158;
        stiffness[1][0] = t119 + b_x * t136;
        stiffness[1][1] = t90 + b_x * t137;
        stiffness[1][2] = t91 + b_x * t138;
        stiffness[1][3] = t92 + b_y * t136;
        stiffness[1][4] = t120 + b_y * t137;
        stiffness[1][5] = t93 + b_y * t138;
        stiffness[1][6] = t94 + b_z * t136;
        stiffness[1][7] = t95 + b_z * t137;
        stiffness[1][8] = t121 + b_z * t138;
        stiffness[2][0] = t122 + c_x * t142;
        stiffness[2][1] = t99 + c_x * t143;
        stiffness[2][2] = t100 + c_x * t144;
        stiffness[2][3] = t101 + c_y * t142;
        stiffness[2][4] = t123 + c_y * t143;
        stiffness[2][5] = t102 + c_y * t144;
        stiffness[2][6] = t103 + c_z * t142;
        stiffness[2][7] = t104 + c_z * t143;
        stiffness[2][8] = t124 + c_z * t144;
        stiffness[3][0] = t119 + a_x * t133;
        stiffness[3][1] = t92 + a_x * t134;
        stiffness[3][2] = t94 + a_x * t135;
        stiffness[3][3] = t90 + a_y * t133;
        stiffness[3][4] = t120 + a_y * t134;
        stiffness[3][5] = t95 + a_y * t135;
        stiffness[3][6] = t91 + a_z * t133;
        stiffness[3][7] = t93 + a_z * t134;
        stiffness[3][8] = t121 + a_z * t135;
        stiffness[4][0] = t159;
        stiffness[4][1] = t105 + (a_x * t137 + t63 * t146 + c_x * t149);
        stiffness[4][2] = t106 + (a_x * t138 + t63 * t147 + c_x * t150);
        stiffness[4][3] = t105 + (a_y * t136 + t64 * t145 + c_y * t148);
        stiffness[4][4] = t160;
        stiffness[4][5] = t107 + (a_y * t138 + t64 * t147 + c_y * t150);
        stiffness[4][6] = t106 + (a_z * t136 + t65 * t145 + c_z * t148);
        stiffness[4][7] = t107 + (a_z * t137 + t65 * t146 + c_z * t149);
        stiffness[4][8] = t161;
        stiffness[5][0] = t126 + c_x * t151;
        stiffness[5][1] = t108 + c_x * t152;
        stiffness[5][2] = t109 + c_x * t153;
        stiffness[5][3] = t110 + c_y * t151;
        stiffness[5][4] = t127 + c_y * t152;
        stiffness[5][5] = t111 + c_y * t153;
        stiffness[5][6] = t112 + c_z * t151;
        stiffness[5][7] = t113 + c_z * t152;
        stiffness[5][8] = t128 + c_z * t153;
        stiffness[6][0] = t122 + a_x * t139;
        stiffness[6][1] = t101 + a_x * t140;
        stiffness[6][2] = t103 + a_x * t141;
        stiffness[6][3] = t99 + a_y * t139;
        stiffness[6][4] = t123 + a_y * t140;
        stiffness[6][5] = t104 + a_y * t141;
        stiffness[6][6] = t100 + a_z * t139;
        stiffness[6][7] = t102 + a_z * t140;
        stiffness[6][8] = t124 + a_z * t141;
        stiffness[7][0] = t126 + b_x * t148;
        stiffness[7][1] = t110 + b_x * t149;
        stiffness[7][2] = t112 + b_x * t150;
        stiffness[7][3] = t108 + b_y * t148;
        stiffness[7][4] = t127 + b_y * t149;
        stiffness[7][5] = t113 + b_y * t150;
        stiffness[7][6] = t109 + b_z * t148;
        stiffness[7][7] = t111 + b_z * t149;
        stiffness[7][8] = t128 + b_z * t150;
        stiffness[8][0] = t162;
        stiffness[8][1] = t114 + (a_x * t143 + b_x * t152 + t66 * t155);
        stiffness[8][2] = t115 + (a_x * t144 + b_x * t153 + t66 * t156);
        stiffness[8][3] = t114 + (a_y * t142 + b_y * t151 + t67 * t154);
        stiffness[8][4] = t163;
        stiffness[8][5] = t116 + (a_y * t144 + b_y * t153 + t67 * t156);
        stiffness[8][6] = t115 + (a_z * t142 + b_z * t151 + t68 * t154);
        stiffness[8][7] = t116 + (a_z * t143 + b_z * t152 + t68 * t155);
        stiffness[8][8] = t164;
        damping_matrix[0][0] = t60 * t165 + b_x * t168 + c_x * t174;
        damping_matrix[0][1] = t60 * t166 + b_x * t169 + c_x * t175;
        damping_matrix[0][2] = t60 * t167 + b_x * t170 + c_x * t176;
        damping_matrix[0][3] = t61 * t165 + b_y * t168 + c_y * t174;
        damping_matrix[0][4] = t61 * t166 + b_y * t169 + c_y * t175;
        damping_matrix[0][5] = t61 * t167 + b_y * t170 + c_y * t176;
        damping_matrix[0][6] = t62 * t165 + b_z * t168 + c_z * t174;
        damping_matrix[0][7] = t62 * t166 + b_z * t169 + c_z * t175;
        damping_matrix[0][8] = t62 * t167 + b_z * t170 + c_z * t176;
        damping_matrix[1][0] = b_x * t171;
        damping_matrix[1][1] = b_x * t172;
        damping_matrix[1][2] = b_x * t173;
        damping_matrix[1][3] = b_y * t171;
        damping_matrix[1][4] = b_y * t172;
        damping_matrix[1][5] = b_y * t173;
        damping_matrix[1][6] = b_z * t171;
        damping_matrix[1][7] = b_z * t172;
        damping_matrix[1][8] = b_z * t173;
        damping_matrix[2][0] = c_x * t177;
        damping_matrix[2][1] = c_x * t178;
        damping_matrix[2][2] = c_x * t179;
        damping_matrix[2][3] = c_y * t177;
        damping_matrix[2][4] = c_y * t178;
        damping_matrix[2][5] = c_y * t179;
        damping_matrix[2][6] = c_z * t177;
        damping_matrix[2][7] = c_z * t178;
        damping_matrix[2][8] = c_z * t179;
        damping_matrix[3][0] = a_x * t171 + t63 * t180 + c_x * t183;
        damping_matrix[3][1] = a_x * t172 + t63 * t181 + c_x * t184;
        damping_matrix[3][2] = a_x * t173 + t63 * t182 + c_x * t185;
        damping_matrix[3][3] = a_y * t171 + t64 * t180 + c_y * t183;
        damping_matrix[3][4] = a_y * t172 + t64 * t181 + c_y * t184;
        damping_matrix[3][5] = a_y * t173 + t64 * t182 + c_y * t185;
        damping_matrix[3][6] = a_z * t171 + t65 * t180 + c_z * t183;
        damping_matrix[3][7] = a_z * t172 + t65 * t181 + c_z * t184;
        damping_matrix[3][8] = a_z * t173 + t65 * t182 + c_z * t185;
        damping_matrix[4][0] = c_x * t186;
        damping_matrix[4][1] = c_x * t187;
        damping_matrix[4][2] = c_x * t188;
        damping_matrix[4][3] = c_y * t186;
        damping_matrix[4][4] = c_y * t187;
        damping_matrix[4][5] = c_y * t188;
        damping_matrix[4][6] = c_z * t186;
        damping_matrix[4][7] = c_z * t187;
        damping_matrix[4][8] = c_z * t188;
        damping_matrix[5][0] = a_x * t177 + b_x * t186 + t66 * t189;
        damping_matrix[5][1] = a_x * t178 + b_x * t187 + t66 * t190;
        damping_matrix[5][2] = a_x * t179 + b_x * t188 + t66 * t191;
        damping_matrix[5][3] = a_y * t177 + b_y * t186 + t67 * t189;
        damping_matrix[5][4] = a_y * t178 + b_y * t187 + t67 * t190;
        damping_matrix[5][5] = a_y * t179 + b_y * t188 + t67 * t191;
        damping_matrix[5][6] = a_z * t177 + b_z * t186 + t68 * t189;
        damping_matrix[5][7] = a_z * t178 + b_z * t187 + t68 * t190;
        damping_matrix[5][8] = a_z * t179 + b_z * t188 + t68 * t191;
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
        let t29 = 0.5 * (length * EA);
        let t30 = t29 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)).powi(2);
        let t31 = t29 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)).powi(2);
        let t32 = t29 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)).powi(2);
        let t33 = 0.5 * (length * kyGA) * (a_x * b_x + a_y * b_y + a_z * b_z).powi(2);
        let t34 = 0.5 * (length * kzGA) * (a_x * c_x + a_y * c_y + a_z * c_z).powi(2);
        let t35 = 0.5 * (length * GA) * (b_x * c_x + b_y * c_y + b_z * c_z).powi(2);
        *energy = t30 + t31 + t32 + t33 + t34 + t35;
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
        let t65 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t66 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t67 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t68 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t69 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t70 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t71 = length * EIz * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t65);
        let t72 = length * EIy * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t66);
        let t73 = length * GIz * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t67);
        let t74 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t75 = length * GJ * (0.5 * t74 + damping * (0.5 * (t69 - t68)));
        let t76 = -0.5 * t75;
        let t77 = 0.5 * t75;
        let t78 = length * GIy * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t70);
        forces[0][0] = db_x * t71 + dc_x * t72;
        forces[0][1] = db_y * t71 + dc_y * t72;
        forces[0][2] = db_z * t71 + dc_z * t72;
        forces[1][0] = db_x * t73 + dc_x * t76;
        forces[1][1] = db_y * t73 + dc_y * t76;
        forces[1][2] = db_z * t73 + dc_z * t76;
        forces[2][0] = db_x * t77 + dc_x * t78;
        forces[2][1] = db_y * t77 + dc_y * t78;
        forces[2][2] = db_z * t77 + dc_z * t78;
        forces[3][0] = inverse_length * (a_x * t71 + b_x * t73 + c_x * t77);
        forces[3][1] = inverse_length * (a_y * t71 + b_y * t73 + c_y * t77);
        forces[3][2] = inverse_length * (a_z * t71 + b_z * t73 + c_z * t77);
        forces[4][0] = inverse_length * (a_x * t72 + b_x * t76 + c_x * t78);
        forces[4][1] = inverse_length * (a_y * t72 + b_y * t76 + c_y * t78);
        forces[4][2] = inverse_length * (a_z * t72 + b_z * t76 + c_z * t78);
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 571 additions, 1301 multiplications, 1 divisions.
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
        let t65 = db_x * v_a_x + db_y * v_a_y + db_z * v_a_z
            + (a_x * v_db_x + a_y * v_db_y + a_z * v_db_z);
        let t66 = dc_x * v_a_x + dc_y * v_a_y + dc_z * v_a_z
            + (a_x * v_dc_x + a_y * v_dc_y + a_z * v_dc_z);
        let t67 = db_x * v_b_x + db_y * v_b_y + db_z * v_b_z
            + (b_x * v_db_x + b_y * v_db_y + b_z * v_db_z);
        let t68 = dc_x * v_b_x + dc_y * v_b_y + dc_z * v_b_z
            + (b_x * v_dc_x + b_y * v_dc_y + b_z * v_dc_z);
        let t69 = db_x * v_c_x + db_y * v_c_y + db_z * v_c_z
            + (c_x * v_db_x + c_y * v_db_y + c_z * v_db_z);
        let t70 = dc_x * v_c_x + dc_y * v_c_y + dc_z * v_c_z
            + (c_x * v_dc_x + c_y * v_dc_y + c_z * v_dc_z);
        let t71 = length * EIz;
        let t72 = length * EIy;
        let t73 = length * GJ;
        let t74 = 0.5 * t73;
        let t75 = length * GIz;
        let t76 = length * GIy;
        let t77 = t73 * (-0.5);
        let t78 = -0.5 * t77;
        let t79 = -0.5 * t74;
        let t80 = 0.5 * t77;
        let t81 = 0.5 * t74;
        let t82 = damping * t71;
        let t83 = damping * t72;
        let t84 = damping * t75;
        let t85 = t73 * (damping * (-0.5));
        let t86 = -0.5 * t85;
        let t87 = t73 * (damping * 0.5);
        let t88 = -0.5 * t87;
        let t89 = 0.5 * t85;
        let t90 = 0.5 * t87;
        let t91 = damping * t76;
        let t92 = t71 * (a_x * db_x + a_y * db_y + a_z * db_z + damping * t65);
        let t93 = t72 * (a_x * dc_x + a_y * dc_y + a_z * dc_z + damping * t66);
        let t94 = t75 * (b_x * db_x + b_y * db_y + b_z * db_z + damping * t67);
        let t95 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t96 = t73 * (0.5 * t95 + damping * (0.5 * (t69 - t68)));
        let t97 = -0.5 * t96;
        let t98 = 0.5 * t96;
        let t99 = t76 * (c_x * dc_x + c_y * dc_y + c_z * dc_z + damping * t70);
        let t100 = db_x * t71;
        let t101 = db_y * t71;
        let t102 = db_z * t71;
        let t103 = a_x * t71;
        let t104 = a_y * t71;
        let t105 = a_z * t71;
        let t106 = dc_x * t72;
        let t107 = dc_y * t72;
        let t108 = dc_z * t72;
        let t109 = a_x * t72;
        let t110 = a_y * t72;
        let t111 = a_z * t72;
        let t112 = db_x * t75;
        let t113 = db_y * t75;
        let t114 = db_z * t75;
        let t115 = b_x * t75;
        let t116 = b_y * t75;
        let t117 = b_z * t75;
        let t118 = dc_x * t78;
        let t119 = dc_y * t78;
        let t120 = dc_z * t78;
        let t121 = db_x * t79;
        let t122 = db_y * t79;
        let t123 = db_z * t79;
        let t124 = c_x * t79;
        let t125 = c_y * t79;
        let t126 = c_z * t79;
        let t127 = b_x * t78;
        let t128 = b_y * t78;
        let t129 = b_z * t78;
        let t130 = dc_x * t80;
        let t131 = dc_y * t80;
        let t132 = dc_z * t80;
        let t133 = db_x * t81;
        let t134 = db_y * t81;
        let t135 = db_z * t81;
        let t136 = c_x * t81;
        let t137 = c_y * t81;
        let t138 = c_z * t81;
        let t139 = b_x * t80;
        let t140 = b_y * t80;
        let t141 = b_z * t80;
        let t142 = dc_x * t76;
        let t143 = dc_y * t76;
        let t144 = dc_z * t76;
        let t145 = c_x * t76;
        let t146 = c_y * t76;
        let t147 = c_z * t76;
        let t148 = v_db_x * t82;
        let t149 = v_db_y * t82;
        let t150 = v_db_z * t82;
        let t151 = v_a_x * t82;
        let t152 = v_a_y * t82;
        let t153 = v_a_z * t82;
        let t154 = v_dc_x * t83;
        let t155 = v_dc_y * t83;
        let t156 = v_dc_z * t83;
        let t157 = v_a_x * t83;
        let t158 = v_a_y * t83;
        let t159 = v_a_z * t83;
        let t160 = v_db_x * t84;
        let t161 = v_db_y * t84;
        let t162 = v_db_z * t84;
        let t163 = v_b_x * t84;
        let t164 = v_b_y * t84;
        let t165 = v_b_z * t84;
        let t166 = v_dc_x * t86;
        let t167 = v_dc_y * t86;
        let t168 = v_dc_z * t86;
        let t169 = v_db_x * t88;
        let t170 = v_db_y * t88;
        let t171 = v_db_z * t88;
        let t172 = v_c_x * t88;
        let t173 = v_c_y * t88;
        let t174 = v_c_z * t88;
        let t175 = v_b_x * t86;
        let t176 = v_b_y * t86;
        let t177 = v_b_z * t86;
        let t178 = v_dc_x * t89;
        let t179 = v_dc_y * t89;
        let t180 = v_dc_z * t89;
        let t181 = v_db_x * t90;
        let t182 = v_db_y * t90;
        let t183 = v_db_z * t90;
        let t184 = v_c_x * t90;
        let t185 = v_c_y * t90;
        let t186 = v_c_z * t90;
        let t187 = v_b_x * t89;
        let t188 = v_b_y * t89;
        let t189 = v_b_z * t89;
        let t190 = v_dc_x * t91;
        let t191 = v_dc_y * t91;
        let t192 = v_dc_z * t91;
        let t193 = v_c_x * t91;
        let t194 = v_c_y * t91;
        let t195 = v_c_z * t91;
        let t196 = a_x * t103 + b_x * t115 + c_x * t136
            + (a_x * t151 + b_x * t163 + c_x * t184);
        let t197 = a_x * t104 + b_x * t116 + c_x * t137
            + (a_x * t152 + b_x * t164 + c_x * t185);
        let t198 = a_x * t105 + b_x * t117 + c_x * t138
            + (a_x * t153 + b_x * t165 + c_x * t186);
        let t199 = a_y * t103 + b_y * t115 + c_y * t136
            + (a_y * t151 + b_y * t163 + c_y * t184);
        let t200 = a_y * t104 + b_y * t116 + c_y * t137
            + (a_y * t152 + b_y * t164 + c_y * t185);
        let t201 = a_y * t105 + b_y * t117 + c_y * t138
            + (a_y * t153 + b_y * t165 + c_y * t186);
        let t202 = a_z * t103 + b_z * t115 + c_z * t136
            + (a_z * t151 + b_z * t163 + c_z * t184);
        let t203 = a_z * t104 + b_z * t116 + c_z * t137
            + (a_z * t152 + b_z * t164 + c_z * t185);
        let t204 = a_z * t105 + b_z * t117 + c_z * t138
            + (a_z * t153 + b_z * t165 + c_z * t186);
        let t205 = a_x * t109 + b_x * t127 + c_x * t145
            + (a_x * t157 + b_x * t175 + c_x * t193);
        let t206 = a_x * t110 + b_x * t128 + c_x * t146
            + (a_x * t158 + b_x * t176 + c_x * t194);
        let t207 = a_x * t111 + b_x * t129 + c_x * t147
            + (a_x * t159 + b_x * t177 + c_x * t195);
        let t208 = a_y * t109 + b_y * t127 + c_y * t145
            + (a_y * t157 + b_y * t175 + c_y * t193);
        let t209 = a_y * t110 + b_y * t128 + c_y * t146
            + (a_y * t158 + b_y * t176 + c_y * t194);
        let t210 = a_y * t111 + b_y * t129 + c_y * t147
            + (a_y * t159 + b_y * t177 + c_y * t195);
        let t211 = a_z * t109 + b_z * t127 + c_z * t145
            + (a_z * t157 + b_z * t175 + c_z * t193);
        let t212 = a_z * t110 + b_z * t128 + c_z * t146
            + (a_z * t158 + b_z * t176 + c_z * t194);
        let t213 = a_z * t111 + b_z * t129 + c_z * t147
            + (a_z * t159 + b_z * t177 + c_z * t195);
        let t214 = db_x * t82;
        let t215 = db_y * t82;
        let t216 = db_z * t82;
        let t217 = a_x * t82;
        let t218 = a_y * t82;
        let t219 = a_z * t82;
        let t220 = dc_x * t83;
        let t221 = dc_y * t83;
        let t222 = dc_z * t83;
        let t223 = a_x * t83;
        let t224 = a_y * t83;
        let t225 = a_z * t83;
        let t226 = db_x * t84;
        let t227 = db_y * t84;
        let t228 = db_z * t84;
        let t229 = b_x * t84;
        let t230 = b_y * t84;
        let t231 = b_z * t84;
        let t232 = dc_x * t86;
        let t233 = dc_y * t86;
        let t234 = dc_z * t86;
        let t235 = db_x * t88;
        let t236 = db_y * t88;
        let t237 = db_z * t88;
        let t238 = c_x * t88;
        let t239 = c_y * t88;
        let t240 = c_z * t88;
        let t241 = b_x * t86;
        let t242 = b_y * t86;
        let t243 = b_z * t86;
        let t244 = dc_x * t89;
        let t245 = dc_y * t89;
        let t246 = dc_z * t89;
        let t247 = db_x * t90;
        let t248 = db_y * t90;
        let t249 = db_z * t90;
        let t250 = c_x * t90;
        let t251 = c_y * t90;
        let t252 = c_z * t90;
        let t253 = b_x * t89;
        let t254 = b_y * t89;
        let t255 = b_z * t89;
        let t256 = dc_x * t91;
        let t257 = dc_y * t91;
        let t258 = dc_z * t91;
        let t259 = c_x * t91;
        let t260 = c_y * t91;
        let t261 = c_z * t91;
        let t262 = inverse_length
            * (t94 + (db_x * t115 + dc_x * t124) + (db_x * t163 + dc_x * t172));
        let t263 = inverse_length
            * (t94 + (db_y * t116 + dc_y * t125) + (db_y * t164 + dc_y * t173));
        let t264 = inverse_length
            * (t94 + (db_z * t117 + dc_z * t126) + (db_z * t165 + dc_z * t174));
        let t265 = inverse_length
            * (t94 + (b_x * t112 + c_x * t130) + (b_x * t160 + c_x * t178));
        let t266 = inverse_length
            * (t94 + (b_y * t113 + c_y * t131) + (b_y * t161 + c_y * t179));
        let t267 = inverse_length
            * (t94 + (b_z * t114 + c_z * t132) + (b_z * t162 + c_z * t180));
        let t268 = inverse_length * inverse_length;
        let t269 = inverse_length
            * (t99 + (db_x * t139 + dc_x * t145) + (db_x * t187 + dc_x * t193));
        let t270 = inverse_length
            * (t99 + (db_y * t140 + dc_y * t146) + (db_y * t188 + dc_y * t194));
        let t271 = inverse_length
            * (t99 + (db_z * t141 + dc_z * t147) + (db_z * t189 + dc_z * t195));
        let t272 = inverse_length
            * (t99 + (b_x * t121 + c_x * t142) + (b_x * t169 + c_x * t190));
        let t273 = inverse_length
            * (t99 + (b_y * t122 + c_y * t143) + (b_y * t170 + c_y * t191));
        let t274 = inverse_length
            * (t99 + (b_z * t123 + c_z * t144) + (b_z * t171 + c_z * t192));
        stiffness[0][0] = db_x * t100 + dc_x * t106 + (db_x * t148 + dc_x * t154);
        stiffness[0][1] = db_x * t101 + dc_x * t107 + (db_x * t149 + dc_x * t155);
        stiffness[0][2] = db_x * t102 + dc_x * t108 + (db_x * t150 + dc_x * t156);
        stiffness[0][3] = db_y * t100 + dc_y * t106 + (db_y * t148 + dc_y * t154);
        stiffness[0][4] = db_y * t101 + dc_y * t107 + (db_y * t149 + dc_y * t155);
        stiffness[0][5] = db_y * t102 + dc_y * t108 + (db_y * t150 + dc_y * t156);
        stiffness[0][6] = db_z * t100 + dc_z * t106 + (db_z * t148 + dc_z * t154);
        stiffness[0][7] = db_z * t101 + dc_z * t107 + (db_z * t149 + dc_z * t155);
        stiffness[0][8] = db_z * t102 + dc_z * t108 + (db_z * t150 + dc_z * t156);
        stiffness[1][0] = inverse_length * (t92 + db_x * t103 + db_x * t151);
        stiffness[1][1] = inverse_length * (db_x * t104 + db_x * t152);
        stiffness[1][2] = inverse_length * (db_x * t105 + db_x * t153);
        stiffness[1][3] = inverse_length * (db_y * t103 + db_y * t151);
        stiffness[1][4] = inverse_length * (t92 + db_y * t104 + db_y * t152);
        stiffness[1][5] = inverse_length * (db_y * t105 + db_y * t153);
        stiffness[1][6] = inverse_length * (db_z * t103 + db_z * t151);
        stiffness[1][7] = inverse_length * (db_z * t104 + db_z * t152);
        stiffness[1][8] = inverse_length * (t92 + db_z * t105 + db_z * t153);
        stiffness[2][0] = inverse_length * (t93 + dc_x * t109 + dc_x * t157);
        stiffness[2][1] = inverse_length * (dc_x * t110 + dc_x * t158);
        stiffness[2][2] = inverse_length * (dc_x * t111 + dc_x * t159);
        stiffness[2][3] = inverse_length * (dc_y * t109 + dc_y * t157);
        stiffness[2][4] = inverse_length * (t93 + dc_y * t110 + dc_y * t158);
        stiffness[2][5] = inverse_length * (dc_y * t111 + dc_y * t159);
        stiffness[2][6] = inverse_length * (dc_z * t109 + dc_z * t157);
        stiffness[2][7] = inverse_length * (dc_z * t110 + dc_z * t158);
        stiffness[2][8] = inverse_length * (t93 + dc_z * t111 + dc_z * t159);
        stiffness[3][0] = inverse_length * (t92 + a_x * t100 + a_x * t148);
        stiffness[3][1] = inverse_length * (a_x * t101 + a_x * t149);
        stiffness[3][2] = inverse_length * (a_x * t102 + a_x * t150);
        stiffness[3][3] = inverse_length * (a_y * t100 + a_y * t148);
        stiffness[3][4] = inverse_length * (t92 + a_y * t101 + a_y * t149);
        stiffness[3][5] = inverse_length * (a_y * t102 + a_y * t150);
        stiffness[3][6] = inverse_length * (a_z * t100 + a_z * t148);
        stiffness[3][7] = inverse_length * (a_z * t101 + a_z * t149);
        stiffness[3][8] = inverse_length * (t92 + a_z * t102 + a_z * t150);
        stiffness[4][0] = db_x * t112 + dc_x * t118 + (db_x * t160 + dc_x * t166);
        stiffness[4][1] = db_x * t113 + dc_x * t119 + (db_x * t161 + dc_x * t167);
        stiffness[4][2] = db_x * t114 + dc_x * t120 + (db_x * t162 + dc_x * t168);
        stiffness[4][3] = db_y * t112 + dc_y * t118 + (db_y * t160 + dc_y * t166);
        stiffness[4][4] = db_y * t113 + dc_y * t119 + (db_y * t161 + dc_y * t167);
        stiffness[4][5] = db_y * t114 + dc_y * t120 + (db_y * t162 + dc_y * t168);
        stiffness[4][6] = db_z * t112 + dc_z * t118 + (db_z * t160 + dc_z * t166);
        stiffness[4][7] = db_z * t113 + dc_z * t119 + (db_z * t161 + dc_z * t167);
        stiffness[4][8] = db_z * t114 + dc_z * t120 + (db_z * t162 + dc_z * t168);
        stiffness[5][0] = t262;
        stiffness[5][1] = inverse_length
            * (db_x * t116 + dc_x * t125 + (db_x * t164 + dc_x * t173));
        stiffness[5][2] = inverse_length
            * (db_x * t117 + dc_x * t126 + (db_x * t165 + dc_x * t174));
        stiffness[5][3] = inverse_length
            * (db_y * t115 + dc_y * t124 + (db_y * t163 + dc_y * t172));
        stiffness[5][4] = t263;
        stiffness[5][5] = inverse_length
            * (db_y * t117 + dc_y * t126 + (db_y * t165 + dc_y * t174));
        stiffness[5][6] = inverse_length
            * (db_z * t115 + dc_z * t124 + (db_z * t163 + dc_z * t172));
        stiffness[5][7] = inverse_length
            * (db_z * t116 + dc_z * t125 + (db_z * t164 + dc_z * t173));
        stiffness[5][8] = t264;
        stiffness[6][0] = t265;
        stiffness[6][1] = inverse_length
            * (b_x * t113 + c_x * t131 + (b_x * t161 + c_x * t179));
        stiffness[6][2] = inverse_length
            * (b_x * t114 + c_x * t132 + (b_x * t162 + c_x * t180));
        stiffness[6][3] = inverse_length
            * (b_y * t112 + c_y * t130 + (b_y * t160 + c_y * t178));
        stiffness[6][4] = t266;
        stiffness[6][5] = inverse_length
            * (b_y * t114 + c_y * t132 + (b_y * t162 + c_y * t180));
        stiffness[6][6] = inverse_length
            * (b_z * t112 + c_z * t130 + (b_z * t160 + c_z * t178));
        stiffness[6][7] = inverse_length
            * (b_z * t113 + c_z * t131 + (b_z * t161 + c_z * t179));
        stiffness[6][8] = t267;
        stiffness[7][0] = t196 * t268;
        stiffness[7][1] = t197 * t268;
        stiffness[7][2] = t198 * t268;
        stiffness[7][3] = t199 * t268;
        stiffness[7][4] = t200 * t268;
        stiffness[7][5] = t201 * t268;
        stiffness[7][6] = t202 * t268;
        stiffness[7][7] = t203 * t268;
        stiffness[7][8] = t204 * t268;
        stiffness[8][0] = dc_x * t121 + dc_x * t169;
        stiffness[8][1] = dc_x * t122 + dc_x * t170;
        stiffness[8][2] = dc_x * t123 + dc_x * t171;
        stiffness[8][3] = dc_y * t121 + dc_y * t169;
        stiffness[8][4] = dc_y * t122 + dc_y * t170;
        stiffness[8][5] = dc_y * t123 + dc_y * t171;
        stiffness[8][6] = dc_z * t121 + dc_z * t169;
        stiffness[8][7] = dc_z * t122 + dc_z * t170;
        stiffness[8][8] = dc_z * t123 + dc_z * t171;
        stiffness[9][0] = inverse_length * (t97 + dc_x * t127 + dc_x * t175);
        stiffness[9][1] = inverse_length * (dc_x * t128 + dc_x * t176);
        stiffness[9][2] = inverse_length * (dc_x * t129 + dc_x * t177);
        stiffness[9][3] = inverse_length * (dc_y * t127 + dc_y * t175);
        stiffness[9][4] = inverse_length * (t97 + dc_y * t128 + dc_y * t176);
        stiffness[9][5] = inverse_length * (dc_y * t129 + dc_y * t177);
        stiffness[9][6] = inverse_length * (dc_z * t127 + dc_z * t175);
        stiffness[9][7] = inverse_length * (dc_z * t128 + dc_z * t176);
        stiffness[9][8] = inverse_length * (t97 + dc_z * t129 + dc_z * t177);
        stiffness[10][0] = inverse_length * (t98 + c_x * t133 + c_x * t181);
        stiffness[10][1] = inverse_length * (c_x * t134 + c_x * t182);
        stiffness[10][2] = inverse_length * (c_x * t135 + c_x * t183);
        stiffness[10][3] = inverse_length * (c_y * t133 + c_y * t181);
        stiffness[10][4] = inverse_length * (t98 + c_y * t134 + c_y * t182);
        stiffness[10][5] = inverse_length * (c_y * t135 + c_y * t183);
        stiffness[10][6] = inverse_length * (c_z * t133 + c_z * t181);
        stiffness[10][7] = inverse_length * (c_z * t134 + c_z * t182);
        stiffness[10][8] = inverse_length * (t98 + c_z * t135 + c_z * t183);
        stiffness[11][0] = (c_x * t139 + c_x * t187) * t268;
        stiffness[11][1] = (c_x * t140 + c_x * t188) * t268;
        stiffness[11][2] = (c_x * t141 + c_x * t189) * t268;
        stiffness[11][3] = (c_y * t139 + c_y * t187) * t268;
        stiffness[11][4] = (c_y * t140 + c_y * t188) * t268;
        stiffness[11][5] = (c_y * t141 + c_y * t189) * t268;
        stiffness[11][6] = (c_z * t139 + c_z * t187) * t268;
        stiffness[11][7] = (c_z * t140 + c_z * t188) * t268;
        stiffness[11][8] = (c_z * t141 + c_z * t189) * t268;
        stiffness[12][0] = inverse_length * (t93 + a_x * t106 + a_x * t154);
        stiffness[12][1] = inverse_length * (a_x * t107 + a_x * t155);
        stiffness[12][2] = inverse_length * (a_x * t108 + a_x * t156);
        stiffness[12][3] = inverse_length * (a_y * t106 + a_y * t154);
        stiffness[12][4] = inverse_length * (t93 + a_y * t107 + a_y * t155);
        stiffness[12][5] = inverse_length * (a_y * t108 + a_y * t156);
        stiffness[12][6] = inverse_length * (a_z * t106 + a_z * t154);
        stiffness[12][7] = inverse_length * (a_z * t107 + a_z * t155);
        stiffness[12][8] = inverse_length * (t93 + a_z * t108 + a_z * t156);
        stiffness[13][0] = db_x * t130 + db_x * t178;
        stiffness[13][1] = db_x * t131 + db_x * t179;
        stiffness[13][2] = db_x * t132 + db_x * t180;
        stiffness[13][3] = db_y * t130 + db_y * t178;
        stiffness[13][4] = db_y * t131 + db_y * t179;
        stiffness[13][5] = db_y * t132 + db_y * t180;
        stiffness[13][6] = db_z * t130 + db_z * t178;
        stiffness[13][7] = db_z * t131 + db_z * t179;
        stiffness[13][8] = db_z * t132 + db_z * t180;
        stiffness[14][0] = inverse_length * (t98 + db_x * t136 + db_x * t184);
        stiffness[14][1] = inverse_length * (db_x * t137 + db_x * t185);
        stiffness[14][2] = inverse_length * (db_x * t138 + db_x * t186);
        stiffness[14][3] = inverse_length * (db_y * t136 + db_y * t184);
        stiffness[14][4] = inverse_length * (t98 + db_y * t137 + db_y * t185);
        stiffness[14][5] = inverse_length * (db_y * t138 + db_y * t186);
        stiffness[14][6] = inverse_length * (db_z * t136 + db_z * t184);
        stiffness[14][7] = inverse_length * (db_z * t137 + db_z * t185);
        stiffness[14][8] = inverse_length * (t98 + db_z * t138 + db_z * t186);
        stiffness[15][0] = inverse_length * (t97 + b_x * t118 + b_x * t166);
        stiffness[15][1] = inverse_length * (b_x * t119 + b_x * t167);
        stiffness[15][2] = inverse_length * (b_x * t120 + b_x * t168);
        stiffness[15][3] = inverse_length * (b_y * t118 + b_y * t166);
        stiffness[15][4] = inverse_length * (t97 + b_y * t119 + b_y * t167);
        stiffness[15][5] = inverse_length * (b_y * t120 + b_y * t168);
        stiffness[15][6] = inverse_length * (b_z * t118 + b_z * t166);
        stiffness[15][7] = inverse_length * (b_z * t119 + b_z * t167);
        stiffness[15][8] = inverse_length * (t97 + b_z * t120 + b_z * t168);
        stiffness[16][0] = (b_x * t124 + b_x * t172) * t268;
        stiffness[16][1] = (b_x * t125 + b_x * t173) * t268;
        stiffness[16][2] = (b_x * t126 + b_x * t174) * t268;
        stiffness[16][3] = (b_y * t124 + b_y * t172) * t268;
        stiffness[16][4] = (b_y * t125 + b_y * t173) * t268;
        stiffness[16][5] = (b_y * t126 + b_y * t174) * t268;
        stiffness[16][6] = (b_z * t124 + b_z * t172) * t268;
        stiffness[16][7] = (b_z * t125 + b_z * t173) * t268;
        stiffness[16][8] = (b_z * t126 + b_z * t174) * t268;
        stiffness[17][0] = db_x * t133 + dc_x * t142 + (db_x * t181 + dc_x * t190);
        stiffness[17][1] = db_x * t134 + dc_x * t143 + (db_x * t182 + dc_x * t191);
        stiffness[17][2] = db_x * t135 + dc_x * t144 + (db_x * t183 + dc_x * t192);
        stiffness[17][3] = db_y * t133 + dc_y * t142 + (db_y * t181 + dc_y * t190);
        stiffness[17][4] = db_y * t134 + dc_y * t143 + (db_y * t182 + dc_y * t191);
        stiffness[17][5] = db_y * t135 + dc_y * t144 + (db_y * t183 + dc_y * t192);
        stiffness[17][6] = db_z * t133 + dc_z * t142 + (db_z * t181 + dc_z * t190);
        stiffness[17][7] = db_z * t134 + dc_z * t143 + (db_z * t182 + dc_z * t191);
        stiffness[17][8] = db_z * t135 + dc_z * t144 + (db_z * t183 + dc_z * t192);
        stiffness[18][0] = t269;
        stiffness[18][1] = inverse_length
            * (db_x * t140 + dc_x * t146 + (db_x * t188 + dc_x * t194));
        stiffness[18][2] = inverse_length
            * (db_x * t141 + dc_x * t147 + (db_x * t189 + dc_x * t195));
        stiffness[18][3] = inverse_length
            * (db_y * t139 + dc_y * t145 + (db_y * t187 + dc_y * t193));
        stiffness[18][4] = t270;
        stiffness[18][5] = inverse_length
            * (db_y * t141 + dc_y * t147 + (db_y * t189 + dc_y * t195));
        stiffness[18][6] = inverse_length
            * (db_z * t139 + dc_z * t145 + (db_z * t187 + dc_z * t193));
        stiffness[18][7] = inverse_length
            * (db_z * t140 + dc_z * t146 + (db_z * t188 + dc_z * t194));
        stiffness[18][8] = t271;
        stiffness[19][0] = t272;
        stiffness[19][1] = inverse_length
            * (b_x * t122 + c_x * t143 + (b_x * t170 + c_x * t191));
        stiffness[19][2] = inverse_length
            * (b_x * t123 + c_x * t144 + (b_x * t171 + c_x * t192));
        stiffness[19][3] = inverse_length
            * (b_y * t121 + c_y * t142 + (b_y * t169 + c_y * t190));
        stiffness[19][4] = t273;
        stiffness[19][5] = inverse_length
            * (b_y * t123 + c_y * t144 + (b_y * t171 + c_y * t192));
        stiffness[19][6] = inverse_length
            * (b_z * t121 + c_z * t142 + (b_z * t169 + c_z * t190));
        stiffness[19][7] = inverse_length
            * (b_z * t122 + c_z * t143 + (b_z * t170 + c_z * t191));
        stiffness[19][8] = t274;
        stiffness[20][0] = t205 * t268;
        stiffness[20][1] = t206 * t268;
        stiffness[20][2] = t207 * t268;
        stiffness[20][3] = t208 * t268;
        stiffness[20][4] = t209 * t268;
        stiffness[20][5] = t210 * t268;
        stiffness[20][6] = t211 * t268;
        stiffness[20][7] = t212 * t268;
        stiffness[20][8] = t213 * t268;
        damping_matrix[0][0] = db_x * t214 + dc_x * t220;
        damping_matrix[0][1] = db_x * t215 + dc_x * t221;
        damping_matrix[0][2] = db_x * t216 + dc_x * t222;
        damping_matrix[0][3] = db_y * t214 + dc_y * t220;
        damping_matrix[0][4] = db_y * t215 + dc_y * t221;
        damping_matrix[0][5] = db_y * t216 + dc_y * t222;
        damping_matrix[0][6] = db_z * t214 + dc_z * t220;
        damping_matrix[0][7] = db_z * t215 + dc_z * t221;
        damping_matrix[0][8] = db_z * t216 + dc_z * t222;
        damping_matrix[1][0] = inverse_length * (db_x * t217);
        damping_matrix[1][1] = inverse_length * (db_x * t218);
        damping_matrix[1][2] = inverse_length * (db_x * t219);
        damping_matrix[1][3] = inverse_length * (db_y * t217);
        damping_matrix[1][4] = inverse_length * (db_y * t218);
        damping_matrix[1][5] = inverse_length * (db_y * t219);
        damping_matrix[1][6] = inverse_length * (db_z * t217);
        damping_matrix[1][7] = inverse_length * (db_z * t218);
        damping_matrix[1][8] = inverse_length * (db_z * t219);
        damping_matrix[2][0] = inverse_length * (dc_x * t223);
        damping_matrix[2][1] = inverse_length * (dc_x * t224);
        damping_matrix[2][2] = inverse_length * (dc_x * t225);
        damping_matrix[2][3] = inverse_length * (dc_y * t223);
        damping_matrix[2][4] = inverse_length * (dc_y * t224);
        damping_matrix[2][5] = inverse_length * (dc_y * t225);
        damping_matrix[2][6] = inverse_length * (dc_z * t223);
        damping_matrix[2][7] = inverse_length * (dc_z * t224);
        damping_matrix[2][8] = inverse_length * (dc_z * t225);
        damping_matrix[3][0] = db_x * t226 + dc_x * t232;
        damping_matrix[3][1] = db_x * t227 + dc_x * t233;
        damping_matrix[3][2] = db_x * t228 + dc_x * t234;
        damping_matrix[3][3] = db_y * t226 + dc_y * t232;
        damping_matrix[3][4] = db_y * t227 + dc_y * t233;
        damping_matrix[3][5] = db_y * t228 + dc_y * t234;
        damping_matrix[3][6] = db_z * t226 + dc_z * t232;
        damping_matrix[3][7] = db_z * t227 + dc_z * t233;
        damping_matrix[3][8] = db_z * t228 + dc_z * t234;
        damping_matrix[4][0] = inverse_length * (db_x * t229 + dc_x * t238);
        damping_matrix[4][1] = inverse_length * (db_x * t230 + dc_x * t239);
        damping_matrix[4][2] = inverse_length * (db_x * t231 + dc_x * t240);
        damping_matrix[4][3] = inverse_length * (db_y * t229 + dc_y * t238);
        damping_matrix[4][4] = inverse_length * (db_y * t230 + dc_y * t239);
        damping_matrix[4][5] = inverse_length * (db_y * t231 + dc_y * t240);
        damping_matrix[4][6] = inverse_length * (db_z * t229 + dc_z * t238);
        damping_matrix[4][7] = inverse_length * (db_z * t230 + dc_z * t239);
        damping_matrix[4][8] = inverse_length * (db_z * t231 + dc_z * t240);
        damping_matrix[5][0] = inverse_length * (b_x * t226 + c_x * t244);
        damping_matrix[5][1] = inverse_length * (b_x * t227 + c_x * t245);
        damping_matrix[5][2] = inverse_length * (b_x * t228 + c_x * t246);
        damping_matrix[5][3] = inverse_length * (b_y * t226 + c_y * t244);
        damping_matrix[5][4] = inverse_length * (b_y * t227 + c_y * t245);
        damping_matrix[5][5] = inverse_length * (b_y * t228 + c_y * t246);
        damping_matrix[5][6] = inverse_length * (b_z * t226 + c_z * t244);
        damping_matrix[5][7] = inverse_length * (b_z * t227 + c_z * t245);
        damping_matrix[5][8] = inverse_length * (b_z * t228 + c_z * t246);
        damping_matrix[6][0] = (a_x * t217 + b_x * t229 + c_x * t250) * t268;
        damping_matrix[6][1] = (a_x * t218 + b_x * t230 + c_x * t251) * t268;
        damping_matrix[6][2] = (a_x * t219 + b_x * t231 + c_x * t252) * t268;
        damping_matrix[6][3] = (a_y * t217 + b_y * t229 + c_y * t250) * t268;
        damping_matrix[6][4] = (a_y * t218 + b_y * t230 + c_y * t251) * t268;
        damping_matrix[6][5] = (a_y * t219 + b_y * t231 + c_y * t252) * t268;
        damping_matrix[6][6] = (a_z * t217 + b_z * t229 + c_z * t250) * t268;
        damping_matrix[6][7] = (a_z * t218 + b_z * t230 + c_z * t251) * t268;
        damping_matrix[6][8] = (a_z * t219 + b_z * t231 + c_z * t252) * t268;
        damping_matrix[7][0] = dc_x * t235;
        damping_matrix[7][1] = dc_x * t236;
        damping_matrix[7][2] = dc_x * t237;
        damping_matrix[7][3] = dc_y * t235;
        damping_matrix[7][4] = dc_y * t236;
        damping_matrix[7][5] = dc_y * t237;
        damping_matrix[7][6] = dc_z * t235;
        damping_matrix[7][7] = dc_z * t236;
        damping_matrix[7][8] = dc_z * t237;
        damping_matrix[8][0] = inverse_length * (dc_x * t241);
        damping_matrix[8][1] = inverse_length * (dc_x * t242);
        damping_matrix[8][2] = inverse_length * (dc_x * t243);
        damping_matrix[8][3] = inverse_length * (dc_y * t241);
        damping_matrix[8][4] = inverse_length * (dc_y * t242);
        damping_matrix[8][5] = inverse_length * (dc_y * t243);
        damping_matrix[8][6] = inverse_length * (dc_z * t241);
        damping_matrix[8][7] = inverse_length * (dc_z * t242);
        damping_matrix[8][8] = inverse_length * (dc_z * t243);
        damping_matrix[9][0] = inverse_length * (c_x * t247);
        damping_matrix[9][1] = inverse_length * (c_x * t248);
        damping_matrix[9][2] = inverse_length * (c_x * t249);
        damping_matrix[9][3] = inverse_length * (c_y * t247);
        damping_matrix[9][4] = inverse_length * (c_y * t248);
        damping_matrix[9][5] = inverse_length * (c_y * t249);
        damping_matrix[9][6] = inverse_length * (c_z * t247);
        damping_matrix[9][7] = inverse_length * (c_z * t248);
        damping_matrix[9][8] = inverse_length * (c_z * t249);
        damping_matrix[10][0] = c_x * t253 * t268;
        damping_matrix[10][1] = c_x * t254 * t268;
        damping_matrix[10][2] = c_x * t255 * t268;
        damping_matrix[10][3] = c_y * t253 * t268;
        damping_matrix[10][4] = c_y * t254 * t268;
        damping_matrix[10][5] = c_y * t255 * t268;
        damping_matrix[10][6] = c_z * t253 * t268;
        damping_matrix[10][7] = c_z * t254 * t268;
        damping_matrix[10][8] = c_z * t255 * t268;
        damping_matrix[11][0] = db_x * t247 + dc_x * t256;
        damping_matrix[11][1] = db_x * t248 + dc_x * t257;
        damping_matrix[11][2] = db_x * t249 + dc_x * t258;
        damping_matrix[11][3] = db_y * t247 + dc_y * t256;
        damping_matrix[11][4] = db_y * t248 + dc_y * t257;
        damping_matrix[11][5] = db_y * t249 + dc_y * t258;
        damping_matrix[11][6] = db_z * t247 + dc_z * t256;
        damping_matrix[11][7] = db_z * t248 + dc_z * t257;
        damping_matrix[11][8] = db_z * t249 + dc_z * t258;
        damping_matrix[12][0] = inverse_length * (db_x * t253 + dc_x * t259);
        damping_matrix[12][1] = inverse_length * (db_x * t254 + dc_x * t260);
        damping_matrix[12][2] = inverse_length * (db_x * t255 + dc_x * t261);
        damping_matrix[12][3] = inverse_length * (db_y * t253 + dc_y * t259);
        damping_matrix[12][4] = inverse_length * (db_y * t254 + dc_y * t260);
        damping_matrix[12][5] = inverse_length * (db_y * t255 + dc_y * t261);
        damping_matrix[12][6] = inverse_length * (db_z * t253 + dc_z * t259);
        damping_matrix[12][7] = inverse_length * (db_z * t254 + dc_z * t260);
        damping_matrix[12][8] = inverse_length * (db_z * t255 + dc_z * t261);
        damping_matrix[13][0] = inverse_length * (b_x * t235 + c_x * t256);
        damping_matrix[13][1] = inverse_length * (b_x * t236 + c_x * t257);
        damping_matrix[13][2] = inverse_length * (b_x * t237 + c_x * t258);
        damping_matrix[13][3] = inverse_length * (b_y * t235 + c_y * t256);
        damping_matrix[13][4] = inverse_length * (b_y * t236 + c_y * t257);
        damping_matrix[13][5] = inverse_length * (b_y * t237 + c_y * t258);
        damping_matrix[13][6] = inverse_length * (b_z * t235 + c_z * t256);
        damping_matrix[13][7] = inverse_length * (b_z * t236 + c_z * t257);
        damping_matrix[13][8] = inverse_length * (b_z * t237 + c_z * t258);
        damping_matrix[14][0] = (a_x * t223 + b_x * t241 + c_x * t259) * t268;
        damping_matrix[14][1] = (a_x * t224 + b_x * t242 + c_x * t260) * t268;
        damping_matrix[14][2] = (a_x * t225 + b_x * t243 + c_x * t261) * t268;
        damping_matrix[14][3] = (a_y * t223 + b_y * t241 + c_y * t259) * t268;
        damping_matrix[14][4] = (a_y * t224 + b_y * t242 + c_y * t260) * t268;
        damping_matrix[14][5] = (a_y * t225 + b_y * t243 + c_y * t261) * t268;
        damping_matrix[14][6] = (a_z * t223 + b_z * t241 + c_z * t259) * t268;
        damping_matrix[14][7] = (a_z * t224 + b_z * t242 + c_z * t260) * t268;
        damping_matrix[14][8] = (a_z * t225 + b_z * t243 + c_z * t261) * t268;
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
        let t43 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t44 = 0.5 * (length * EIz) * (a_x * db_x + a_y * db_y + a_z * db_z).powi(2);
        let t45 = 0.5 * (length * EIy) * (a_x * dc_x + a_y * dc_y + a_z * dc_z).powi(2);
        let t46 = 0.5 * (length * GIz) * (b_x * db_x + b_y * db_y + b_z * db_z).powi(2);
        let t47 = 0.5 * (length * GIy) * (c_x * dc_x + c_y * dc_y + c_z * dc_z).powi(2);
        let t48 = t44 + t45 + 0.5 * (length * GJ) * (0.5 * t43).powi(2) + t46 + t47;
        *energy = t48;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
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
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 11825 additions, 13933 multiplications, 2 divisions.
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
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
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
        let t23 = length * element_mass;
        let mass_r0_r0x = t23 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_r1x = t23 * (-0.030952380952380953);
        let t27 = element_mass * (length * length);
        let mass_r0x_r0x = t27 * 0.009523809523809525;
        let mass_r0x_r1 = t23 * 0.030952380952380953;
        let mass_r0x_r1x = t27 * (-0.007142857142857143);
        let mass_r0y_r0y = section_y_mass * 0.13333333333333333;
        let mass_r0y_ry_half = section_y_mass * 0.06666666666666667;
        let mass_r0y_r1y = section_y_mass * (-0.03333333333333333);
        let mass_r0z_r0z = section_z_mass * 0.13333333333333333;
        let mass_r0z_rz_half = section_z_mass * 0.06666666666666667;
        let mass_r0z_r1z = section_z_mass * (-0.03333333333333333);
        let mass_ry_half_ry_half = section_y_mass * 0.5333333333333333;
        let mass_rz_half_rz_half = section_z_mass * 0.5333333333333333;
        let mass_r1_r1x = t23 * (-0.05238095238095238);
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
    /// Adds the inertia forces of one element in a moving frame (Eq. 13): relative, Coriolis, Euler and centrifugal acceleration, the frame's acceleration and gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 318 additions, 388 multiplications.
    pub fn beam_spatial_damped_inertia_force(
        row: &BeamSpatialDamped,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 30],
        v: &[f64; 30],
        a: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let BeamSpatialDamped { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r0_x, r0_y, r0_z, r0x_x, r0x_y, r0x_z, r0y_x, r0y_y, r0y_z, r0z_x, r0z_y,
        r0z_z, ry_half_x, ry_half_y, ry_half_z, rz_half_x, rz_half_y, rz_half_z, r1_x,
        r1_y, r1_z, r1x_x, r1x_y, r1x_z, r1y_x, r1y_y, r1y_z, r1z_x, r1z_y, r1z_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_r0x_x, v_r0x_y, v_r0x_z, v_r0y_x, v_r0y_y,
        v_r0y_z, v_r0z_x, v_r0z_y, v_r0z_z, v_ry_half_x, v_ry_half_y, v_ry_half_z,
        v_rz_half_x, v_rz_half_y, v_rz_half_z, v_r1_x, v_r1_y, v_r1_z, v_r1x_x, v_r1x_y,
        v_r1x_z, v_r1y_x, v_r1y_y, v_r1y_z, v_r1z_x, v_r1z_y, v_r1z_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_r0x_x, a_r0x_y, a_r0x_z, a_r0y_x, a_r0y_y,
        a_r0y_z, a_r0z_x, a_r0z_y, a_r0z_z, a_ry_half_x, a_ry_half_y, a_ry_half_z,
        a_rz_half_x, a_rz_half_y, a_rz_half_z, a_r1_x, a_r1_y, a_r1_z, a_r1x_x, a_r1x_y,
        a_r1x_z, a_r1y_x, a_r1y_y, a_r1y_z, a_r1z_x, a_r1z_y, a_r1z_z] = *a;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let t121 = r0_z * w_y - r0_y * w_z;
        let t122 = r0_x * w_z - r0_z * w_x;
        let t123 = r0_y * w_x - r0_x * w_y;
        let t124 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + (v_r0_z * w_y - v_r0_y * w_z) * 2.0);
        let t125 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + (v_r0_x * w_z - v_r0_z * w_x) * 2.0);
        let t126 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + (v_r0_y * w_x - v_r0_x * w_y) * 2.0);
        let total_r0_x = e_x + (w_y * t123 - w_z * t122 + t124);
        let total_r0_y = e_y + (w_z * t121 - w_x * t123 + t125);
        let total_r0_z = e_z + (w_x * t122 - w_y * t121 + t126);
        let t130 = r0x_z * w_y - r0x_y * w_z;
        let t131 = r0x_x * w_z - r0x_z * w_x;
        let t132 = r0x_y * w_x - r0x_x * w_y;
        let t133 = r0x_z * dw_y - r0x_y * dw_z
            + (a_r0x_x + 2.0 * (v_r0x_z * w_y - v_r0x_y * w_z));
        let t134 = r0x_x * dw_z - r0x_z * dw_x
            + (a_r0x_y + 2.0 * (v_r0x_x * w_z - v_r0x_z * w_x));
        let t135 = r0x_y * dw_x - r0x_x * dw_y
            + (a_r0x_z + 2.0 * (v_r0x_y * w_x - v_r0x_x * w_y));
        let total_r0x_x = w_y * t132 - w_z * t131 + t133;
        let total_r0x_y = w_z * t130 - w_x * t132 + t134;
        let total_r0x_z = w_x * t131 - w_y * t130 + t135;
        let t139 = r0y_z * w_y - r0y_y * w_z;
        let t140 = r0y_x * w_z - r0y_z * w_x;
        let t141 = r0y_y * w_x - r0y_x * w_y;
        let t142 = r0y_z * dw_y - r0y_y * dw_z
            + (a_r0y_x + 2.0 * (v_r0y_z * w_y - v_r0y_y * w_z));
        let t143 = r0y_x * dw_z - r0y_z * dw_x
            + (a_r0y_y + 2.0 * (v_r0y_x * w_z - v_r0y_z * w_x));
        let t144 = r0y_y * dw_x - r0y_x * dw_y
            + (a_r0y_z + 2.0 * (v_r0y_y * w_x - v_r0y_x * w_y));
        let total_r0y_x = w_y * t141 - w_z * t140 + t142;
        let total_r0y_y = w_z * t139 - w_x * t141 + t143;
        let total_r0y_z = w_x * t140 - w_y * t139 + t144;
        let t148 = r0z_z * w_y - r0z_y * w_z;
        let t149 = r0z_x * w_z - r0z_z * w_x;
        let t150 = r0z_y * w_x - r0z_x * w_y;
        let t151 = r0z_z * dw_y - r0z_y * dw_z
            + (a_r0z_x + 2.0 * (v_r0z_z * w_y - v_r0z_y * w_z));
        let t152 = r0z_x * dw_z - r0z_z * dw_x
            + (a_r0z_y + 2.0 * (v_r0z_x * w_z - v_r0z_z * w_x));
        let t153 = r0z_y * dw_x - r0z_x * dw_y
            + (a_r0z_z + 2.0 * (v_r0z_y * w_x - v_r0z_x * w_y));
        let total_r0z_x = w_y * t150 - w_z * t149 + t151;
        let total_r0z_y = w_z * t148 - w_x * t150 + t152;
        let total_r0z_z = w_x * t149 - w_y * t148 + t153;
        let t157 = ry_half_z * w_y - ry_half_y * w_z;
        let t158 = ry_half_x * w_z - ry_half_z * w_x;
        let t159 = ry_half_y * w_x - ry_half_x * w_y;
        let t160 = ry_half_z * dw_y - ry_half_y * dw_z
            + (a_ry_half_x + 2.0 * (v_ry_half_z * w_y - v_ry_half_y * w_z));
        let t161 = ry_half_x * dw_z - ry_half_z * dw_x
            + (a_ry_half_y + 2.0 * (v_ry_half_x * w_z - v_ry_half_z * w_x));
        let t162 = ry_half_y * dw_x - ry_half_x * dw_y
            + (a_ry_half_z + 2.0 * (v_ry_half_y * w_x - v_ry_half_x * w_y));
        let total_ry_half_x = w_y * t159 - w_z * t158 + t160;
        let total_ry_half_y = w_z * t157 - w_x * t159 + t161;
        let total_ry_half_z = w_x * t158 - w_y * t157 + t162;
        let t166 = rz_half_z * w_y - rz_half_y * w_z;
        let t167 = rz_half_x * w_z - rz_half_z * w_x;
        let t168 = rz_half_y * w_x - rz_half_x * w_y;
        let t169 = rz_half_z * dw_y - rz_half_y * dw_z
            + (a_rz_half_x + 2.0 * (v_rz_half_z * w_y - v_rz_half_y * w_z));
        let t170 = rz_half_x * dw_z - rz_half_z * dw_x
            + (a_rz_half_y + 2.0 * (v_rz_half_x * w_z - v_rz_half_z * w_x));
        let t171 = rz_half_y * dw_x - rz_half_x * dw_y
            + (a_rz_half_z + 2.0 * (v_rz_half_y * w_x - v_rz_half_x * w_y));
        let total_rz_half_x = w_y * t168 - w_z * t167 + t169;
        let total_rz_half_y = w_z * t166 - w_x * t168 + t170;
        let total_rz_half_z = w_x * t167 - w_y * t166 + t171;
        let t175 = r1_z * w_y - r1_y * w_z;
        let t176 = r1_x * w_z - r1_z * w_x;
        let t177 = r1_y * w_x - r1_x * w_y;
        let t178 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t179 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t180 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let total_r1_x = e_x + (w_y * t177 - w_z * t176 + t178);
        let total_r1_y = e_y + (w_z * t175 - w_x * t177 + t179);
        let total_r1_z = e_z + (w_x * t176 - w_y * t175 + t180);
        let t184 = r1x_z * w_y - r1x_y * w_z;
        let t185 = r1x_x * w_z - r1x_z * w_x;
        let t186 = r1x_y * w_x - r1x_x * w_y;
        let t187 = r1x_z * dw_y - r1x_y * dw_z
            + (a_r1x_x + 2.0 * (v_r1x_z * w_y - v_r1x_y * w_z));
        let t188 = r1x_x * dw_z - r1x_z * dw_x
            + (a_r1x_y + 2.0 * (v_r1x_x * w_z - v_r1x_z * w_x));
        let t189 = r1x_y * dw_x - r1x_x * dw_y
            + (a_r1x_z + 2.0 * (v_r1x_y * w_x - v_r1x_x * w_y));
        let total_r1x_x = w_y * t186 - w_z * t185 + t187;
        let total_r1x_y = w_z * t184 - w_x * t186 + t188;
        let total_r1x_z = w_x * t185 - w_y * t184 + t189;
        let t193 = r1y_z * w_y - r1y_y * w_z;
        let t194 = r1y_x * w_z - r1y_z * w_x;
        let t195 = r1y_y * w_x - r1y_x * w_y;
        let t196 = r1y_z * dw_y - r1y_y * dw_z
            + (a_r1y_x + 2.0 * (v_r1y_z * w_y - v_r1y_y * w_z));
        let t197 = r1y_x * dw_z - r1y_z * dw_x
            + (a_r1y_y + 2.0 * (v_r1y_x * w_z - v_r1y_z * w_x));
        let t198 = r1y_y * dw_x - r1y_x * dw_y
            + (a_r1y_z + 2.0 * (v_r1y_y * w_x - v_r1y_x * w_y));
        let total_r1y_x = w_y * t195 - w_z * t194 + t196;
        let total_r1y_y = w_z * t193 - w_x * t195 + t197;
        let total_r1y_z = w_x * t194 - w_y * t193 + t198;
        let t202 = r1z_z * w_y - r1z_y * w_z;
        let t203 = r1z_x * w_z - r1z_z * w_x;
        let t204 = r1z_y * w_x - r1z_x * w_y;
        let t205 = r1z_z * dw_y - r1z_y * dw_z
            + (a_r1z_x + 2.0 * (v_r1z_z * w_y - v_r1z_y * w_z));
        let t206 = r1z_x * dw_z - r1z_z * dw_x
            + (a_r1z_y + 2.0 * (v_r1z_x * w_z - v_r1z_z * w_x));
        let t207 = r1z_y * dw_x - r1z_x * dw_y
            + (a_r1z_z + 2.0 * (v_r1z_y * w_x - v_r1z_x * w_y));
        let total_r1z_x = w_y * t204 - w_z * t203 + t205;
        let total_r1z_y = w_z * t202 - w_x * t204 + t206;
        let total_r1z_z = w_x * t203 - w_y * t202 + t207;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t212 = length * element_mass;
        let mass_r0_r0x = t212 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_r1x = t212 * (-0.030952380952380953);
        let t216 = element_mass * (length * length);
        let mass_r0x_r0x = t216 * 0.009523809523809525;
        let mass_r0x_r1 = t212 * 0.030952380952380953;
        let mass_r0x_r1x = t216 * (-0.007142857142857143);
        let mass_r0y_r0y = section_y_mass * 0.13333333333333333;
        let mass_r0y_ry_half = section_y_mass * 0.06666666666666667;
        let mass_r0y_r1y = section_y_mass * (-0.03333333333333333);
        let t223 = total_ry_half_x * mass_r0y_ry_half;
        let t224 = total_ry_half_y * mass_r0y_ry_half;
        let t225 = total_ry_half_z * mass_r0y_ry_half;
        let mass_r0z_r0z = section_z_mass * 0.13333333333333333;
        let mass_r0z_rz_half = section_z_mass * 0.06666666666666667;
        let mass_r0z_r1z = section_z_mass * (-0.03333333333333333);
        let t229 = total_rz_half_x * mass_r0z_rz_half;
        let t230 = total_rz_half_y * mass_r0z_rz_half;
        let t231 = total_rz_half_z * mass_r0z_rz_half;
        let mass_ry_half_ry_half = section_y_mass * 0.5333333333333333;
        let mass_rz_half_rz_half = section_z_mass * 0.5333333333333333;
        let mass_r1_r1x = t212 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + total_r0x_x * mass_r0_r0x
                + total_r1_x * mass_r0_r1 + total_r1x_x * mass_r0_r1x;
        force[1]
            += total_r0_y * mass_r0_r0 + total_r0x_y * mass_r0_r0x
                + total_r1_y * mass_r0_r1 + total_r1x_y * mass_r0_r1x;
        force[2]
            += total_r0_z * mass_r0_r0 + total_r0x_z * mass_r0_r0x
                + total_r1_z * mass_r0_r1 + total_r1x_z * mass_r0_r1x;
        force[3]
            += total_r0_x * mass_r0_r0x + total_r0x_x * mass_r0x_r0x
                + total_r1_x * mass_r0x_r1 + total_r1x_x * mass_r0x_r1x;
        force[4]
            += total_r0_y * mass_r0_r0x + total_r0x_y * mass_r0x_r0x
                + total_r1_y * mass_r0x_r1 + total_r1x_y * mass_r0x_r1x;
        force[5]
            += total_r0_z * mass_r0_r0x + total_r0x_z * mass_r0x_r0x
                + total_r1_z * mass_r0x_r1 + total_r1x_z * mass_r0x_r1x;
        force[6] += total_r0y_x * mass_r0y_r0y + t223 + total_r1y_x * mass_r0y_r1y;
        force[7] += total_r0y_y * mass_r0y_r0y + t224 + total_r1y_y * mass_r0y_r1y;
        force[8] += total_r0y_z * mass_r0y_r0y + t225 + total_r1y_z * mass_r0y_r1y;
        force[9] += total_r0z_x * mass_r0z_r0z + t229 + total_r1z_x * mass_r0z_r1z;
        force[10] += total_r0z_y * mass_r0z_r0z + t230 + total_r1z_y * mass_r0z_r1z;
        force[11] += total_r0z_z * mass_r0z_r0z + t231 + total_r1z_z * mass_r0z_r1z;
        force[12]
            += total_r0y_x * mass_r0y_ry_half + total_ry_half_x * mass_ry_half_ry_half
                + total_r1y_x * mass_r0y_ry_half;
        force[13]
            += total_r0y_y * mass_r0y_ry_half + total_ry_half_y * mass_ry_half_ry_half
                + total_r1y_y * mass_r0y_ry_half;
        force[14]
            += total_r0y_z * mass_r0y_ry_half + total_ry_half_z * mass_ry_half_ry_half
                + total_r1y_z * mass_r0y_ry_half;
        force[15]
            += total_r0z_x * mass_r0z_rz_half + total_rz_half_x * mass_rz_half_rz_half
                + total_r1z_x * mass_r0z_rz_half;
        force[16]
            += total_r0z_y * mass_r0z_rz_half + total_rz_half_y * mass_rz_half_rz_half
                + total_r1z_y * mass_r0z_rz_half;
        force[17]
            += total_r0z_z * mass_r0z_rz_half + total_rz_half_z * mass_rz_half_rz_half
                + total_r1z_z * mass_r0z_rz_half;
        force[18]
            += total_r0_x * mass_r0_r1 + total_r0x_x * mass_r0x_r1
                + total_r1_x * mass_r0_r0 + total_r1x_x * mass_r1_r1x;
        force[19]
            += total_r0_y * mass_r0_r1 + total_r0x_y * mass_r0x_r1
                + total_r1_y * mass_r0_r0 + total_r1x_y * mass_r1_r1x;
        force[20]
            += total_r0_z * mass_r0_r1 + total_r0x_z * mass_r0x_r1
                + total_r1_z * mass_r0_r0 + total_r1x_z * mass_r1_r1x;
        force[21]
            += total_r0_x * mass_r0_r1x + total_r0x_x * mass_r0x_r1x
                + total_r1_x * mass_r1_r1x + total_r1x_x * mass_r0x_r0x;
        force[22]
            += total_r0_y * mass_r0_r1x + total_r0x_y * mass_r0x_r1x
                + total_r1_y * mass_r1_r1x + total_r1x_y * mass_r0x_r0x;
        force[23]
            += total_r0_z * mass_r0_r1x + total_r0x_z * mass_r0x_r1x
                + total_r1_z * mass_r1_r1x + total_r1x_z * mass_r0x_r0x;
        force[24] += t223 + total_r0y_x * mass_r0y_r1y + total_r1y_x * mass_r0y_r0y;
        force[25] += t224 + total_r0y_y * mass_r0y_r1y + total_r1y_y * mass_r0y_r0y;
        force[26] += t225 + total_r0y_z * mass_r0y_r1y + total_r1y_z * mass_r0y_r0y;
        force[27] += t229 + total_r0z_x * mass_r0z_r1z + total_r1z_x * mass_r0z_r0z;
        force[28] += t230 + total_r0z_y * mass_r0z_r1z + total_r1z_y * mass_r0z_r0z;
        force[29] += t231 + total_r0z_z * mass_r0z_r1z + total_r1z_z * mass_r0z_r0z;
    }
    /// Adds the derivatives of the inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 1809 additions, 223 multiplications.
    pub fn beam_spatial_damped_inertia_tangent(
        row: &BeamSpatialDamped,
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 900],
        damping_matrix: &mut [f64; 900],
    ) {
        let BeamSpatialDamped { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t29 = length * element_mass;
        let mass_r0_r0x = t29 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_r1x = t29 * (-0.030952380952380953);
        let t33 = element_mass * (length * length);
        let mass_r0x_r0x = t33 * 0.009523809523809525;
        let mass_r0x_r1 = t29 * 0.030952380952380953;
        let mass_r0x_r1x = t33 * (-0.007142857142857143);
        let mass_r0y_r0y = section_y_mass * 0.13333333333333333;
        let mass_r0y_ry_half = section_y_mass * 0.06666666666666667;
        let mass_r0y_r1y = section_y_mass * (-0.03333333333333333);
        let mass_r0z_r0z = section_z_mass * 0.13333333333333333;
        let mass_r0z_rz_half = section_z_mass * 0.06666666666666667;
        let mass_r0z_r1z = section_z_mass * (-0.03333333333333333);
        let mass_ry_half_ry_half = section_y_mass * 0.5333333333333333;
        let mass_rz_half_rz_half = section_z_mass * 0.5333333333333333;
        let mass_r1_r1x = t29 * (-0.05238095238095238);
        let t46 = w_y * w_y;
        let t47 = w_z * w_z;
        let t48 = t46 + t47;
        let t49 = -mass_r0_r0 * t48;
        let t50 = w_x * w_y;
        let t51 = t50 - dw_z;
        let t52 = mass_r0_r0 * t51;
        let t53 = w_x * w_z;
        let t54 = dw_y + t53;
        let t55 = mass_r0_r0 * t54;
        let t56 = -mass_r0_r0x * t48;
        let t57 = mass_r0_r0x * t51;
        let t58 = mass_r0_r0x * t54;
        let t59 = -mass_r0_r1 * t48;
        let t60 = mass_r0_r1 * t51;
        let t61 = mass_r0_r1 * t54;
        let t62 = -mass_r0_r1x * t48;
        let t63 = mass_r0_r1x * t51;
        let t64 = mass_r0_r1x * t54;
        let t65 = dw_z + t50;
        let t66 = mass_r0_r0 * t65;
        let t67 = w_x * w_x;
        let t68 = t47 + t67;
        let t69 = -mass_r0_r0 * t68;
        let t70 = w_y * w_z;
        let t71 = t70 - dw_x;
        let t72 = mass_r0_r0 * t71;
        let t73 = mass_r0_r0x * t65;
        let t74 = -mass_r0_r0x * t68;
        let t75 = mass_r0_r0x * t71;
        let t76 = mass_r0_r1 * t65;
        let t77 = -mass_r0_r1 * t68;
        let t78 = mass_r0_r1 * t71;
        let t79 = mass_r0_r1x * t65;
        let t80 = -mass_r0_r1x * t68;
        let t81 = mass_r0_r1x * t71;
        let t82 = t53 - dw_y;
        let t83 = mass_r0_r0 * t82;
        let t84 = dw_x + t70;
        let t85 = mass_r0_r0 * t84;
        let t86 = t46 + t67;
        let t87 = -mass_r0_r0 * t86;
        let t88 = mass_r0_r0x * t82;
        let t89 = mass_r0_r0x * t84;
        let t90 = -mass_r0_r0x * t86;
        let t91 = mass_r0_r1 * t82;
        let t92 = mass_r0_r1 * t84;
        let t93 = -mass_r0_r1 * t86;
        let t94 = mass_r0_r1x * t82;
        let t95 = mass_r0_r1x * t84;
        let t96 = -mass_r0_r1x * t86;
        let t97 = -mass_r0x_r0x * t48;
        let t98 = mass_r0x_r0x * t51;
        let t99 = mass_r0x_r0x * t54;
        let t100 = -mass_r0x_r1 * t48;
        let t101 = mass_r0x_r1 * t51;
        let t102 = mass_r0x_r1 * t54;
        let t103 = -mass_r0x_r1x * t48;
        let t104 = mass_r0x_r1x * t51;
        let t105 = mass_r0x_r1x * t54;
        let t106 = mass_r0x_r0x * t65;
        let t107 = -mass_r0x_r0x * t68;
        let t108 = mass_r0x_r0x * t71;
        let t109 = mass_r0x_r1 * t65;
        let t110 = -mass_r0x_r1 * t68;
        let t111 = mass_r0x_r1 * t71;
        let t112 = mass_r0x_r1x * t65;
        let t113 = -mass_r0x_r1x * t68;
        let t114 = mass_r0x_r1x * t71;
        let t115 = mass_r0x_r0x * t82;
        let t116 = mass_r0x_r0x * t84;
        let t117 = -mass_r0x_r0x * t86;
        let t118 = mass_r0x_r1 * t82;
        let t119 = mass_r0x_r1 * t84;
        let t120 = -mass_r0x_r1 * t86;
        let t121 = mass_r0x_r1x * t82;
        let t122 = mass_r0x_r1x * t84;
        let t123 = -mass_r0x_r1x * t86;
        let t124 = -mass_r0y_r0y * t48;
        let t125 = mass_r0y_r0y * t51;
        let t126 = mass_r0y_r0y * t54;
        let t127 = -mass_r0y_ry_half * t48;
        let t128 = mass_r0y_ry_half * t51;
        let t129 = mass_r0y_ry_half * t54;
        let t130 = -mass_r0y_r1y * t48;
        let t131 = mass_r0y_r1y * t51;
        let t132 = mass_r0y_r1y * t54;
        let t133 = mass_r0y_r0y * t65;
        let t134 = -mass_r0y_r0y * t68;
        let t135 = mass_r0y_r0y * t71;
        let t136 = mass_r0y_ry_half * t65;
        let t137 = -mass_r0y_ry_half * t68;
        let t138 = mass_r0y_ry_half * t71;
        let t139 = mass_r0y_r1y * t65;
        let t140 = -mass_r0y_r1y * t68;
        let t141 = mass_r0y_r1y * t71;
        let t142 = mass_r0y_r0y * t82;
        let t143 = mass_r0y_r0y * t84;
        let t144 = -mass_r0y_r0y * t86;
        let t145 = mass_r0y_ry_half * t82;
        let t146 = mass_r0y_ry_half * t84;
        let t147 = -mass_r0y_ry_half * t86;
        let t148 = mass_r0y_r1y * t82;
        let t149 = mass_r0y_r1y * t84;
        let t150 = -mass_r0y_r1y * t86;
        let t151 = -mass_r0z_r0z * t48;
        let t152 = mass_r0z_r0z * t51;
        let t153 = mass_r0z_r0z * t54;
        let t154 = -mass_r0z_rz_half * t48;
        let t155 = mass_r0z_rz_half * t51;
        let t156 = mass_r0z_rz_half * t54;
        let t157 = -mass_r0z_r1z * t48;
        let t158 = mass_r0z_r1z * t51;
        let t159 = mass_r0z_r1z * t54;
        let t160 = mass_r0z_r0z * t65;
        let t161 = -mass_r0z_r0z * t68;
        let t162 = mass_r0z_r0z * t71;
        let t163 = mass_r0z_rz_half * t65;
        let t164 = -mass_r0z_rz_half * t68;
        let t165 = mass_r0z_rz_half * t71;
        let t166 = mass_r0z_r1z * t65;
        let t167 = -mass_r0z_r1z * t68;
        let t168 = mass_r0z_r1z * t71;
        let t169 = mass_r0z_r0z * t82;
        let t170 = mass_r0z_r0z * t84;
        let t171 = -mass_r0z_r0z * t86;
        let t172 = mass_r0z_rz_half * t82;
        let t173 = mass_r0z_rz_half * t84;
        let t174 = -mass_r0z_rz_half * t86;
        let t175 = mass_r0z_r1z * t82;
        let t176 = mass_r0z_r1z * t84;
        let t177 = -mass_r0z_r1z * t86;
        let t178 = -mass_r1_r1x * t48;
        let t179 = mass_r1_r1x * t51;
        let t180 = mass_r1_r1x * t54;
        let t181 = mass_r1_r1x * t65;
        let t182 = -mass_r1_r1x * t68;
        let t183 = mass_r1_r1x * t71;
        let t184 = mass_r1_r1x * t82;
        let t185 = mass_r1_r1x * t84;
        let t186 = -mass_r1_r1x * t86;
        let t187 = w_z * 2.0;
        let t188 = mass_r0_r0 * t187;
        let t189 = w_y * 2.0;
        let t190 = mass_r0_r0 * t189;
        let t191 = mass_r0_r0x * t187;
        let t192 = mass_r0_r0x * t189;
        let t193 = mass_r0_r1 * t187;
        let t194 = mass_r0_r1 * t189;
        let t195 = mass_r0_r1x * t187;
        let t196 = mass_r0_r1x * t189;
        let t197 = w_x * 2.0;
        let t198 = mass_r0_r0 * t197;
        let t199 = mass_r0_r0x * t197;
        let t200 = mass_r0_r1 * t197;
        let t201 = mass_r0_r1x * t197;
        let t202 = mass_r0x_r0x * t187;
        let t203 = mass_r0x_r0x * t189;
        let t204 = mass_r0x_r1 * t187;
        let t205 = mass_r0x_r1 * t189;
        let t206 = mass_r0x_r1x * t187;
        let t207 = mass_r0x_r1x * t189;
        let t208 = mass_r0x_r0x * t197;
        let t209 = mass_r0x_r1 * t197;
        let t210 = mass_r0x_r1x * t197;
        let t211 = mass_r0y_r0y * t187;
        let t212 = mass_r0y_r0y * t189;
        let t213 = mass_r0y_ry_half * t187;
        let t214 = mass_r0y_ry_half * t189;
        let t215 = mass_r0y_r1y * t187;
        let t216 = mass_r0y_r1y * t189;
        let t217 = mass_r0y_r0y * t197;
        let t218 = mass_r0y_ry_half * t197;
        let t219 = mass_r0y_r1y * t197;
        let t220 = mass_r0z_r0z * t187;
        let t221 = mass_r0z_r0z * t189;
        let t222 = mass_r0z_rz_half * t187;
        let t223 = mass_r0z_rz_half * t189;
        let t224 = mass_r0z_r1z * t187;
        let t225 = mass_r0z_r1z * t189;
        let t226 = mass_r0z_r0z * t197;
        let t227 = mass_r0z_rz_half * t197;
        let t228 = mass_r0z_r1z * t197;
        let t229 = mass_ry_half_ry_half * t187;
        let t230 = mass_ry_half_ry_half * t189;
        let t231 = mass_ry_half_ry_half * t197;
        let t232 = mass_rz_half_rz_half * t187;
        let t233 = mass_rz_half_rz_half * t189;
        let t234 = mass_rz_half_rz_half * t197;
        let t235 = mass_r1_r1x * t187;
        let t236 = mass_r1_r1x * t189;
        let t237 = mass_r1_r1x * t197;
        stiffness[0] += t49;
        stiffness[1] += t52;
        stiffness[2] += t55;
        stiffness[3] += t56;
        stiffness[4] += t57;
        stiffness[5] += t58;
        stiffness[18] += t59;
        stiffness[19] += t60;
        stiffness[20] += t61;
        stiffness[21] += t62;
        stiffness[22] += t63;
        stiffness[23] += t64;
        stiffness[30] += t66;
        stiffness[31] += t69;
        stiffness[32] += t72;
        stiffness[33] += t73;
        stiffness[34] += t74;
        stiffness[35] += t75;
        stiffness[48] += t76;
        stiffness[49] += t77;
        stiffness[50] += t78;
        stiffness[51] += t79;
        stiffness[52] += t80;
        stiffness[53] += t81;
        stiffness[60] += t83;
        stiffness[61] += t85;
        stiffness[62] += t87;
        stiffness[63] += t88;
        stiffness[64] += t89;
        stiffness[65] += t90;
        stiffness[78] += t91;
        stiffness[79] += t92;
        stiffness[80] += t93;
        stiffness[81] += t94;
        stiffness[82] += t95;
        stiffness[83] += t96;
        stiffness[90] += t56;
        stiffness[91] += t57;
        stiffness[92] += t58;
        stiffness[93] += t97;
        stiffness[94] += t98;
        stiffness[95] += t99;
        stiffness[108] += t100;
        stiffness[109] += t101;
        stiffness[110] += t102;
        stiffness[111] += t103;
        stiffness[112] += t104;
        stiffness[113] += t105;
        stiffness[120] += t73;
        stiffness[121] += t74;
        stiffness[122] += t75;
        stiffness[123] += t106;
        stiffness[124] += t107;
        stiffness[125] += t108;
        stiffness[138] += t109;
        stiffness[139] += t110;
        stiffness[140] += t111;
        stiffness[141] += t112;
        stiffness[142] += t113;
        stiffness[143] += t114;
        stiffness[150] += t88;
        stiffness[151] += t89;
        stiffness[152] += t90;
        stiffness[153] += t115;
        stiffness[154] += t116;
        stiffness[155] += t117;
        stiffness[168] += t118;
        stiffness[169] += t119;
        stiffness[170] += t120;
        stiffness[171] += t121;
        stiffness[172] += t122;
        stiffness[173] += t123;
        stiffness[186] += t124;
        stiffness[187] += t125;
        stiffness[188] += t126;
        stiffness[192] += t127;
        stiffness[193] += t128;
        stiffness[194] += t129;
        stiffness[204] += t130;
        stiffness[205] += t131;
        stiffness[206] += t132;
        stiffness[216] += t133;
        stiffness[217] += t134;
        stiffness[218] += t135;
        stiffness[222] += t136;
        stiffness[223] += t137;
        stiffness[224] += t138;
        stiffness[234] += t139;
        stiffness[235] += t140;
        stiffness[236] += t141;
        stiffness[246] += t142;
        stiffness[247] += t143;
        stiffness[248] += t144;
        stiffness[252] += t145;
        stiffness[253] += t146;
        stiffness[254] += t147;
        stiffness[264] += t148;
        stiffness[265] += t149;
        stiffness[266] += t150;
        stiffness[279] += t151;
        stiffness[280] += t152;
        stiffness[281] += t153;
        stiffness[285] += t154;
        stiffness[286] += t155;
        stiffness[287] += t156;
        stiffness[297] += t157;
        stiffness[298] += t158;
        stiffness[299] += t159;
        stiffness[309] += t160;
        stiffness[310] += t161;
        stiffness[311] += t162;
        stiffness[315] += t163;
        stiffness[316] += t164;
        stiffness[317] += t165;
        stiffness[327] += t166;
        stiffness[328] += t167;
        stiffness[329] += t168;
        stiffness[339] += t169;
        stiffness[340] += t170;
        stiffness[341] += t171;
        stiffness[345] += t172;
        stiffness[346] += t173;
        stiffness[347] += t174;
        stiffness[357] += t175;
        stiffness[358] += t176;
        stiffness[359] += t177;
        stiffness[366] += t127;
        stiffness[367] += t128;
        stiffness[368] += t129;
        stiffness[372] += -mass_ry_half_ry_half * t48;
        stiffness[373] += mass_ry_half_ry_half * t51;
        stiffness[374] += mass_ry_half_ry_half * t54;
        stiffness[384] += t127;
        stiffness[385] += t128;
        stiffness[386] += t129;
        stiffness[396] += t136;
        stiffness[397] += t137;
        stiffness[398] += t138;
        stiffness[402] += mass_ry_half_ry_half * t65;
        stiffness[403] += -mass_ry_half_ry_half * t68;
        stiffness[404] += mass_ry_half_ry_half * t71;
        stiffness[414] += t136;
        stiffness[415] += t137;
        stiffness[416] += t138;
        stiffness[426] += t145;
        stiffness[427] += t146;
        stiffness[428] += t147;
        stiffness[432] += mass_ry_half_ry_half * t82;
        stiffness[433] += mass_ry_half_ry_half * t84;
        stiffness[434] += -mass_ry_half_ry_half * t86;
        stiffness[444] += t145;
        stiffness[445] += t146;
        stiffness[446] += t147;
        stiffness[459] += t154;
        stiffness[460] += t155;
        stiffness[461] += t156;
        stiffness[465] += -mass_rz_half_rz_half * t48;
        stiffness[466] += mass_rz_half_rz_half * t51;
        stiffness[467] += mass_rz_half_rz_half * t54;
        stiffness[477] += t154;
        stiffness[478] += t155;
        stiffness[479] += t156;
        stiffness[489] += t163;
        stiffness[490] += t164;
        stiffness[491] += t165;
        stiffness[495] += mass_rz_half_rz_half * t65;
        stiffness[496] += -mass_rz_half_rz_half * t68;
        stiffness[497] += mass_rz_half_rz_half * t71;
        stiffness[507] += t163;
        stiffness[508] += t164;
        stiffness[509] += t165;
        stiffness[519] += t172;
        stiffness[520] += t173;
        stiffness[521] += t174;
        stiffness[525] += mass_rz_half_rz_half * t82;
        stiffness[526] += mass_rz_half_rz_half * t84;
        stiffness[527] += -mass_rz_half_rz_half * t86;
        stiffness[537] += t172;
        stiffness[538] += t173;
        stiffness[539] += t174;
        stiffness[540] += t59;
        stiffness[541] += t60;
        stiffness[542] += t61;
        stiffness[543] += t100;
        stiffness[544] += t101;
        stiffness[545] += t102;
        stiffness[558] += t49;
        stiffness[559] += t52;
        stiffness[560] += t55;
        stiffness[561] += t178;
        stiffness[562] += t179;
        stiffness[563] += t180;
        stiffness[570] += t76;
        stiffness[571] += t77;
        stiffness[572] += t78;
        stiffness[573] += t109;
        stiffness[574] += t110;
        stiffness[575] += t111;
        stiffness[588] += t66;
        stiffness[589] += t69;
        stiffness[590] += t72;
        stiffness[591] += t181;
        stiffness[592] += t182;
        stiffness[593] += t183;
        stiffness[600] += t91;
        stiffness[601] += t92;
        stiffness[602] += t93;
        stiffness[603] += t118;
        stiffness[604] += t119;
        stiffness[605] += t120;
        stiffness[618] += t83;
        stiffness[619] += t85;
        stiffness[620] += t87;
        stiffness[621] += t184;
        stiffness[622] += t185;
        stiffness[623] += t186;
        stiffness[630] += t62;
        stiffness[631] += t63;
        stiffness[632] += t64;
        stiffness[633] += t103;
        stiffness[634] += t104;
        stiffness[635] += t105;
        stiffness[648] += t178;
        stiffness[649] += t179;
        stiffness[650] += t180;
        stiffness[651] += t97;
        stiffness[652] += t98;
        stiffness[653] += t99;
        stiffness[660] += t79;
        stiffness[661] += t80;
        stiffness[662] += t81;
        stiffness[663] += t112;
        stiffness[664] += t113;
        stiffness[665] += t114;
        stiffness[678] += t181;
        stiffness[679] += t182;
        stiffness[680] += t183;
        stiffness[681] += t106;
        stiffness[682] += t107;
        stiffness[683] += t108;
        stiffness[690] += t94;
        stiffness[691] += t95;
        stiffness[692] += t96;
        stiffness[693] += t121;
        stiffness[694] += t122;
        stiffness[695] += t123;
        stiffness[708] += t184;
        stiffness[709] += t185;
        stiffness[710] += t186;
        stiffness[711] += t115;
        stiffness[712] += t116;
        stiffness[713] += t117;
        stiffness[726] += t130;
        stiffness[727] += t131;
        stiffness[728] += t132;
        stiffness[732] += t127;
        stiffness[733] += t128;
        stiffness[734] += t129;
        stiffness[744] += t124;
        stiffness[745] += t125;
        stiffness[746] += t126;
        stiffness[756] += t139;
        stiffness[757] += t140;
        stiffness[758] += t141;
        stiffness[762] += t136;
        stiffness[763] += t137;
        stiffness[764] += t138;
        stiffness[774] += t133;
        stiffness[775] += t134;
        stiffness[776] += t135;
        stiffness[786] += t148;
        stiffness[787] += t149;
        stiffness[788] += t150;
        stiffness[792] += t145;
        stiffness[793] += t146;
        stiffness[794] += t147;
        stiffness[804] += t142;
        stiffness[805] += t143;
        stiffness[806] += t144;
        stiffness[819] += t157;
        stiffness[820] += t158;
        stiffness[821] += t159;
        stiffness[825] += t154;
        stiffness[826] += t155;
        stiffness[827] += t156;
        stiffness[837] += t151;
        stiffness[838] += t152;
        stiffness[839] += t153;
        stiffness[849] += t166;
        stiffness[850] += t167;
        stiffness[851] += t168;
        stiffness[855] += t163;
        stiffness[856] += t164;
        stiffness[857] += t165;
        stiffness[867] += t160;
        stiffness[868] += t161;
        stiffness[869] += t162;
        stiffness[879] += t175;
        stiffness[880] += t176;
        stiffness[881] += t177;
        stiffness[885] += t172;
        stiffness[886] += t173;
        stiffness[887] += t174;
        stiffness[897] += t169;
        stiffness[898] += t170;
        stiffness[899] += t171;
        damping_matrix[1] -= t188;
        damping_matrix[2] += t190;
        damping_matrix[4] -= t191;
        damping_matrix[5] += t192;
        damping_matrix[19] -= t193;
        damping_matrix[20] += t194;
        damping_matrix[22] -= t195;
        damping_matrix[23] += t196;
        damping_matrix[30] += t188;
        damping_matrix[32] -= t198;
        damping_matrix[33] += t191;
        damping_matrix[35] -= t199;
        damping_matrix[48] += t193;
        damping_matrix[50] -= t200;
        damping_matrix[51] += t195;
        damping_matrix[53] -= t201;
        damping_matrix[60] -= t190;
        damping_matrix[61] += t198;
        damping_matrix[63] -= t192;
        damping_matrix[64] += t199;
        damping_matrix[78] -= t194;
        damping_matrix[79] += t200;
        damping_matrix[81] -= t196;
        damping_matrix[82] += t201;
        damping_matrix[91] -= t191;
        damping_matrix[92] += t192;
        damping_matrix[94] -= t202;
        damping_matrix[95] += t203;
        damping_matrix[109] -= t204;
        damping_matrix[110] += t205;
        damping_matrix[112] -= t206;
        damping_matrix[113] += t207;
        damping_matrix[120] += t191;
        damping_matrix[122] -= t199;
        damping_matrix[123] += t202;
        damping_matrix[125] -= t208;
        damping_matrix[138] += t204;
        damping_matrix[140] -= t209;
        damping_matrix[141] += t206;
        damping_matrix[143] -= t210;
        damping_matrix[150] -= t192;
        damping_matrix[151] += t199;
        damping_matrix[153] -= t203;
        damping_matrix[154] += t208;
        damping_matrix[168] -= t205;
        damping_matrix[169] += t209;
        damping_matrix[171] -= t207;
        damping_matrix[172] += t210;
        damping_matrix[187] -= t211;
        damping_matrix[188] += t212;
        damping_matrix[193] -= t213;
        damping_matrix[194] += t214;
        damping_matrix[205] -= t215;
        damping_matrix[206] += t216;
        damping_matrix[216] += t211;
        damping_matrix[218] -= t217;
        damping_matrix[222] += t213;
        damping_matrix[224] -= t218;
        damping_matrix[234] += t215;
        damping_matrix[236] -= t219;
        damping_matrix[246] -= t212;
        damping_matrix[247] += t217;
        damping_matrix[252] -= t214;
        damping_matrix[253] += t218;
        damping_matrix[264] -= t216;
        damping_matrix[265] += t219;
        damping_matrix[280] -= t220;
        damping_matrix[281] += t221;
        damping_matrix[286] -= t222;
        damping_matrix[287] += t223;
        damping_matrix[298] -= t224;
        damping_matrix[299] += t225;
        damping_matrix[309] += t220;
        damping_matrix[311] -= t226;
        damping_matrix[315] += t222;
        damping_matrix[317] -= t227;
        damping_matrix[327] += t224;
        damping_matrix[329] -= t228;
        damping_matrix[339] -= t221;
        damping_matrix[340] += t226;
        damping_matrix[345] -= t223;
        damping_matrix[346] += t227;
        damping_matrix[357] -= t225;
        damping_matrix[358] += t228;
        damping_matrix[367] -= t213;
        damping_matrix[368] += t214;
        damping_matrix[373] -= t229;
        damping_matrix[374] += t230;
        damping_matrix[385] -= t213;
        damping_matrix[386] += t214;
        damping_matrix[396] += t213;
        damping_matrix[398] -= t218;
        damping_matrix[402] += t229;
        damping_matrix[404] -= t231;
        damping_matrix[414] += t213;
        damping_matrix[416] -= t218;
        damping_matrix[426] -= t214;
        damping_matrix[427] += t218;
        damping_matrix[432] -= t230;
        damping_matrix[433] += t231;
        damping_matrix[444] -= t214;
        damping_matrix[445] += t218;
        damping_matrix[460] -= t222;
        damping_matrix[461] += t223;
        damping_matrix[466] -= t232;
        damping_matrix[467] += t233;
        damping_matrix[478] -= t222;
        damping_matrix[479] += t223;
        damping_matrix[489] += t222;
        damping_matrix[491] -= t227;
        damping_matrix[495] += t232;
        damping_matrix[497] -= t234;
        damping_matrix[507] += t222;
        damping_matrix[509] -= t227;
        damping_matrix[519] -= t223;
        damping_matrix[520] += t227;
        damping_matrix[525] -= t233;
        damping_matrix[526] += t234;
        damping_matrix[537] -= t223;
        damping_matrix[538] += t227;
        damping_matrix[541] -= t193;
        damping_matrix[542] += t194;
        damping_matrix[544] -= t204;
        damping_matrix[545] += t205;
        damping_matrix[559] -= t188;
        damping_matrix[560] += t190;
        damping_matrix[562] -= t235;
        damping_matrix[563] += t236;
        damping_matrix[570] += t193;
        damping_matrix[572] -= t200;
        damping_matrix[573] += t204;
        damping_matrix[575] -= t209;
        damping_matrix[588] += t188;
        damping_matrix[590] -= t198;
        damping_matrix[591] += t235;
        damping_matrix[593] -= t237;
        damping_matrix[600] -= t194;
        damping_matrix[601] += t200;
        damping_matrix[603] -= t205;
        damping_matrix[604] += t209;
        damping_matrix[618] -= t190;
        damping_matrix[619] += t198;
        damping_matrix[621] -= t236;
        damping_matrix[622] += t237;
        damping_matrix[631] -= t195;
        damping_matrix[632] += t196;
        damping_matrix[634] -= t206;
        damping_matrix[635] += t207;
        damping_matrix[649] -= t235;
        damping_matrix[650] += t236;
        damping_matrix[652] -= t202;
        damping_matrix[653] += t203;
        damping_matrix[660] += t195;
        damping_matrix[662] -= t201;
        damping_matrix[663] += t206;
        damping_matrix[665] -= t210;
        damping_matrix[678] += t235;
        damping_matrix[680] -= t237;
        damping_matrix[681] += t202;
        damping_matrix[683] -= t208;
        damping_matrix[690] -= t196;
        damping_matrix[691] += t201;
        damping_matrix[693] -= t207;
        damping_matrix[694] += t210;
        damping_matrix[708] -= t236;
        damping_matrix[709] += t237;
        damping_matrix[711] -= t203;
        damping_matrix[712] += t208;
        damping_matrix[727] -= t215;
        damping_matrix[728] += t216;
        damping_matrix[733] -= t213;
        damping_matrix[734] += t214;
        damping_matrix[745] -= t211;
        damping_matrix[746] += t212;
        damping_matrix[756] += t215;
        damping_matrix[758] -= t219;
        damping_matrix[762] += t213;
        damping_matrix[764] -= t218;
        damping_matrix[774] += t211;
        damping_matrix[776] -= t217;
        damping_matrix[786] -= t216;
        damping_matrix[787] += t219;
        damping_matrix[792] -= t214;
        damping_matrix[793] += t218;
        damping_matrix[804] -= t212;
        damping_matrix[805] += t217;
        damping_matrix[820] -= t224;
        damping_matrix[821] += t225;
        damping_matrix[826] -= t222;
        damping_matrix[827] += t223;
        damping_matrix[838] -= t220;
        damping_matrix[839] += t221;
        damping_matrix[849] += t224;
        damping_matrix[851] -= t228;
        damping_matrix[855] += t222;
        damping_matrix[857] -= t227;
        damping_matrix[867] += t220;
        damping_matrix[869] -= t226;
        damping_matrix[879] -= t225;
        damping_matrix[880] += t228;
        damping_matrix[885] -= t223;
        damping_matrix[886] += t227;
        damping_matrix[897] -= t221;
        damping_matrix[898] += t226;
    }
    /// Adds the inertia forces of one element in the inertial frame; e is minus gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 108 additions, 118 multiplications.
    pub fn beam_spatial_damped_absolute_inertia_force(
        row: &BeamSpatialDamped,
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let BeamSpatialDamped { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r0_x, a_r0_y, a_r0_z, a_r0x_x, a_r0x_y, a_r0x_z, a_r0y_x, a_r0y_y,
        a_r0y_z, a_r0z_x, a_r0z_y, a_r0z_z, a_ry_half_x, a_ry_half_y, a_ry_half_z,
        a_rz_half_x, a_rz_half_y, a_rz_half_z, a_r1_x, a_r1_y, a_r1_z, a_r1x_x, a_r1x_y,
        a_r1x_z, a_r1y_x, a_r1y_y, a_r1y_z, a_r1z_x, a_r1z_y, a_r1z_z] = *a;
        let element_mass = length * rhoA;
        let section_y_mass = length * rhoIz;
        let section_z_mass = length * rhoIy;
        let total_r0_x = a_r0_x + e_x;
        let total_r0_y = a_r0_y + e_y;
        let total_r0_z = a_r0_z + e_z;
        let total_r1_x = a_r1_x + e_x;
        let total_r1_y = a_r1_y + e_y;
        let total_r1_z = a_r1_z + e_z;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t62 = length * element_mass;
        let mass_r0_r0x = t62 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_r1x = t62 * (-0.030952380952380953);
        let t66 = element_mass * (length * length);
        let mass_r0x_r0x = t66 * 0.009523809523809525;
        let mass_r0x_r1 = t62 * 0.030952380952380953;
        let mass_r0x_r1x = t66 * (-0.007142857142857143);
        let mass_r0y_r0y = section_y_mass * 0.13333333333333333;
        let mass_r0y_ry_half = section_y_mass * 0.06666666666666667;
        let mass_r0y_r1y = section_y_mass * (-0.03333333333333333);
        let t73 = a_ry_half_x * mass_r0y_ry_half;
        let t74 = a_ry_half_y * mass_r0y_ry_half;
        let t75 = a_ry_half_z * mass_r0y_ry_half;
        let mass_r0z_r0z = section_z_mass * 0.13333333333333333;
        let mass_r0z_rz_half = section_z_mass * 0.06666666666666667;
        let mass_r0z_r1z = section_z_mass * (-0.03333333333333333);
        let t79 = a_rz_half_x * mass_r0z_rz_half;
        let t80 = a_rz_half_y * mass_r0z_rz_half;
        let t81 = a_rz_half_z * mass_r0z_rz_half;
        let mass_ry_half_ry_half = section_y_mass * 0.5333333333333333;
        let mass_rz_half_rz_half = section_z_mass * 0.5333333333333333;
        let mass_r1_r1x = t62 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + a_r0x_x * mass_r0_r0x + total_r1_x * mass_r0_r1
                + a_r1x_x * mass_r0_r1x;
        force[1]
            += total_r0_y * mass_r0_r0 + a_r0x_y * mass_r0_r0x + total_r1_y * mass_r0_r1
                + a_r1x_y * mass_r0_r1x;
        force[2]
            += total_r0_z * mass_r0_r0 + a_r0x_z * mass_r0_r0x + total_r1_z * mass_r0_r1
                + a_r1x_z * mass_r0_r1x;
        force[3]
            += total_r0_x * mass_r0_r0x + a_r0x_x * mass_r0x_r0x
                + total_r1_x * mass_r0x_r1 + a_r1x_x * mass_r0x_r1x;
        force[4]
            += total_r0_y * mass_r0_r0x + a_r0x_y * mass_r0x_r0x
                + total_r1_y * mass_r0x_r1 + a_r1x_y * mass_r0x_r1x;
        force[5]
            += total_r0_z * mass_r0_r0x + a_r0x_z * mass_r0x_r0x
                + total_r1_z * mass_r0x_r1 + a_r1x_z * mass_r0x_r1x;
        force[6] += a_r0y_x * mass_r0y_r0y + t73 + a_r1y_x * mass_r0y_r1y;
        force[7] += a_r0y_y * mass_r0y_r0y + t74 + a_r1y_y * mass_r0y_r1y;
        force[8] += a_r0y_z * mass_r0y_r0y + t75 + a_r1y_z * mass_r0y_r1y;
        force[9] += a_r0z_x * mass_r0z_r0z + t79 + a_r1z_x * mass_r0z_r1z;
        force[10] += a_r0z_y * mass_r0z_r0z + t80 + a_r1z_y * mass_r0z_r1z;
        force[11] += a_r0z_z * mass_r0z_r0z + t81 + a_r1z_z * mass_r0z_r1z;
        force[12]
            += a_r0y_x * mass_r0y_ry_half + a_ry_half_x * mass_ry_half_ry_half
                + a_r1y_x * mass_r0y_ry_half;
        force[13]
            += a_r0y_y * mass_r0y_ry_half + a_ry_half_y * mass_ry_half_ry_half
                + a_r1y_y * mass_r0y_ry_half;
        force[14]
            += a_r0y_z * mass_r0y_ry_half + a_ry_half_z * mass_ry_half_ry_half
                + a_r1y_z * mass_r0y_ry_half;
        force[15]
            += a_r0z_x * mass_r0z_rz_half + a_rz_half_x * mass_rz_half_rz_half
                + a_r1z_x * mass_r0z_rz_half;
        force[16]
            += a_r0z_y * mass_r0z_rz_half + a_rz_half_y * mass_rz_half_rz_half
                + a_r1z_y * mass_r0z_rz_half;
        force[17]
            += a_r0z_z * mass_r0z_rz_half + a_rz_half_z * mass_rz_half_rz_half
                + a_r1z_z * mass_r0z_rz_half;
        force[18]
            += total_r0_x * mass_r0_r1 + a_r0x_x * mass_r0x_r1 + total_r1_x * mass_r0_r0
                + a_r1x_x * mass_r1_r1x;
        force[19]
            += total_r0_y * mass_r0_r1 + a_r0x_y * mass_r0x_r1 + total_r1_y * mass_r0_r0
                + a_r1x_y * mass_r1_r1x;
        force[20]
            += total_r0_z * mass_r0_r1 + a_r0x_z * mass_r0x_r1 + total_r1_z * mass_r0_r0
                + a_r1x_z * mass_r1_r1x;
        force[21]
            += total_r0_x * mass_r0_r1x + a_r0x_x * mass_r0x_r1x
                + total_r1_x * mass_r1_r1x + a_r1x_x * mass_r0x_r0x;
        force[22]
            += total_r0_y * mass_r0_r1x + a_r0x_y * mass_r0x_r1x
                + total_r1_y * mass_r1_r1x + a_r1x_y * mass_r0x_r0x;
        force[23]
            += total_r0_z * mass_r0_r1x + a_r0x_z * mass_r0x_r1x
                + total_r1_z * mass_r1_r1x + a_r1x_z * mass_r0x_r0x;
        force[24] += t73 + a_r0y_x * mass_r0y_r1y + a_r1y_x * mass_r0y_r0y;
        force[25] += t74 + a_r0y_y * mass_r0y_r1y + a_r1y_y * mass_r0y_r0y;
        force[26] += t75 + a_r0y_z * mass_r0y_r1y + a_r1y_z * mass_r0y_r0y;
        force[27] += t79 + a_r0z_x * mass_r0z_r1z + a_r1z_x * mass_r0z_r0z;
        force[28] += t80 + a_r0z_y * mass_r0z_r1z + a_r1z_y * mass_r0z_r0z;
        force[29] += t81 + a_r0z_z * mass_r0z_r1z + a_r1z_z * mass_r0z_r0z;
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
        let t17 = 1.0 / length;
        let t18 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t17;
        weights[1] = 1.0 + xi * (-4.0 + t18);
        weights[6] = t17 * (xi * (6.0 + xi * (-6.0)));
        weights[7] = xi * (t18 + (-2.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 8 multiplications, 2 divisions.
    pub fn beam_spatial_damped_shapes_position_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t17 = 1.0 / (length * length);
        let t18 = xi * 6.0;
        let t19 = 1.0 / length;
        weights[0] = (-6.0 + xi * 12.0) * t17;
        weights[1] = (-4.0 + t18) * t19;
        weights[6] = t17 * (6.0 + xi * (-12.0));
        weights[7] = t19 * (t18 + (-2.0));
    }
    /// Weights of the nodal vectors in the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_damped_shapes_section_y_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t16 = xi * 2.0;
        weights[2] = 1.0 + xi * (-3.0 + t16);
        weights[4] = xi * (4.0 + xi * (-4.0));
        weights[8] = xi * (t16 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_y_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t17 = xi * 4.0;
        let t18 = 1.0 / length;
        weights[2] = (-3.0 + t17) * t18;
        weights[4] = t18 * (4.0 + xi * (-8.0));
        weights[8] = t18 * (t17 + (-1.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the section's y axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 0 additions, 3 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_y_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t16 = 1.0 / (length * length);
        let t17 = 4.0 * t16;
        weights[2] = t17;
        weights[4] = t16 * (-8.0);
        weights[8] = t17;
    }
    /// Weights of the nodal vectors in the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 5 multiplications.
    pub fn beam_spatial_damped_shapes_section_z_0(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t16 = xi * 2.0;
        weights[3] = 1.0 + xi * (-3.0 + t16);
        weights[5] = xi * (4.0 + xi * (-4.0));
        weights[9] = xi * (t16 + (-1.0));
    }
    /// Weights of the nodal vectors in d/dx of the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_z_1(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t17 = xi * 4.0;
        let t18 = 1.0 / length;
        weights[3] = (-3.0 + t17) * t18;
        weights[5] = t18 * (4.0 + xi * (-8.0));
        weights[9] = t18 * (t17 + (-1.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the section's z axis at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 0 additions, 3 multiplications, 1 divisions.
    pub fn beam_spatial_damped_shapes_section_z_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 10],
    ) {
        let t16 = 1.0 / (length * length);
        let t17 = 4.0 * t16;
        weights[3] = t17;
        weights[5] = t16 * (-8.0);
        weights[9] = t17;
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
        let t70 = fields[6] * fields[9] + fields[7] * fields[10] + fields[8] * fields[11]
            - (fields[3] * fields[12] + fields[4] * fields[13] + fields[5] * fields[14]);
        let t71 = 0.5
            * (fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
                - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t72 = fields[0] * 2.0;
        let t73 = fields[1] * 2.0;
        let t74 = fields[2] * 2.0;
        let t75 = EA
            * (t71
                + damping * (0.5 * (rates[0] * t72 + rates[1] * t73 + rates[2] * t74)));
        let t76 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0)
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t77 = fields[3] * 2.0;
        let t78 = fields[4] * 2.0;
        let t79 = fields[5] * 2.0;
        let t80 = EA
            * (t76
                + damping * (0.5 * (rates[3] * t77 + rates[4] * t78 + rates[5] * t79)));
        let t81 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0)
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t82 = fields[6] * 2.0;
        let t83 = fields[7] * 2.0;
        let t84 = fields[8] * 2.0;
        let t85 = EA
            * (t81
                + damping * (0.5 * (rates[6] * t82 + rates[7] * t83 + rates[8] * t84)));
        let t86 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5]
            - (stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
                + stress_free[2] * stress_free[5]);
        let t87 = fields[3] * rates[0] + fields[0] * rates[3]
            + (fields[4] * rates[1] + fields[1] * rates[4])
            + (fields[5] * rates[2] + fields[2] * rates[5]);
        let t88 = kyGA * (t86 + damping * t87);
        let t89 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8]
            - (stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
                + stress_free[2] * stress_free[8]);
        let t90 = fields[6] * rates[0] + fields[0] * rates[6]
            + (fields[7] * rates[1] + fields[1] * rates[7])
            + (fields[8] * rates[2] + fields[2] * rates[8]);
        let t91 = kzGA * (t89 + damping * t90);
        let t92 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t93 = fields[6] * rates[3] + fields[3] * rates[6]
            + (fields[7] * rates[4] + fields[4] * rates[7])
            + (fields[8] * rates[5] + fields[5] * rates[8]);
        let t94 = GA * (t92 + damping * t93);
        let t95 = fields[0] * fields[9] + fields[1] * fields[10] + fields[2] * fields[11]
            - (stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11]);
        let t96 = fields[9] * rates[0] + fields[0] * rates[9]
            + (fields[10] * rates[1] + fields[1] * rates[10])
            + (fields[11] * rates[2] + fields[2] * rates[11]);
        let t97 = EIz * (t95 + damping * t96);
        let t98 = fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14]
            - (stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14]);
        let t99 = fields[12] * rates[0] + fields[0] * rates[12]
            + (fields[13] * rates[1] + fields[1] * rates[13])
            + (fields[14] * rates[2] + fields[2] * rates[14]);
        let t100 = EIy * (t98 + damping * t99);
        let t101 = t75 * (0.5 * t72) + fields[3] * t88 + fields[6] * t91
            + fields[9] * t97 + fields[12] * t100;
        let t102 = t75 * (0.5 * t73) + fields[4] * t88 + fields[7] * t91
            + fields[10] * t97 + fields[13] * t100;
        let t103 = t75 * (0.5 * t74) + fields[5] * t88 + fields[8] * t91
            + fields[11] * t97 + fields[14] * t100;
        let t104 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11]
            - (stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
                + stress_free[5] * stress_free[14]);
        let t105 = fields[12] * rates[3] + fields[3] * rates[12]
            + (fields[13] * rates[4] + fields[4] * rates[13])
            + (fields[14] * rates[5] + fields[5] * rates[14]);
        let t106 = fields[9] * rates[6] + fields[6] * rates[9]
            + (fields[10] * rates[7] + fields[7] * rates[10])
            + (fields[11] * rates[8] + fields[8] * rates[11]);
        let t107 = GJ * (0.5 * t70 - 0.5 * t104 + damping * (0.5 * (t106 - t105)));
        let t108 = t80 * (0.5 * t77) + fields[0] * t88 + fields[6] * t94
            - t107 * (fields[12] * 0.5);
        let t109 = t80 * (0.5 * t78) + fields[1] * t88 + fields[7] * t94
            - t107 * (fields[13] * 0.5);
        let t110 = t80 * (0.5 * t79) + fields[2] * t88 + fields[8] * t94
            - t107 * (fields[14] * 0.5);
        let t111 = t85 * (0.5 * t82) + fields[0] * t91 + fields[3] * t94
            + t107 * (fields[9] * 0.5);
        let t112 = t85 * (0.5 * t83) + fields[1] * t91 + fields[4] * t94
            + t107 * (fields[10] * 0.5);
        let t113 = t85 * (0.5 * t84) + fields[2] * t91 + fields[5] * t94
            + t107 * (fields[11] * 0.5);
        let t114 = fields[3] * fields[9] + fields[4] * fields[10]
            + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t115 = fields[9] * rates[3] + fields[3] * rates[9]
            + (fields[10] * rates[4] + fields[4] * rates[10])
            + (fields[11] * rates[5] + fields[5] * rates[11]);
        let t116 = GIz * (t114 + damping * t115);
        let t117 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t118 = fields[12] * rates[6] + fields[6] * rates[12]
            + (fields[13] * rates[7] + fields[7] * rates[13])
            + (fields[14] * rates[8] + fields[8] * rates[14]);
        let t119 = GIy * (t117 + damping * t118);
        forces[0] = t101;
        forces[1] = t102;
        forces[2] = t103;
        forces[3] = t108 + fields[9] * t116;
        forces[4] = t109 + fields[10] * t116;
        forces[5] = t110 + fields[11] * t116;
        forces[6] = t111 + fields[12] * t119;
        forces[7] = t112 + fields[13] * t119;
        forces[8] = t113 + fields[14] * t119;
        forces[9] = fields[0] * t97 + t107 * (fields[6] * 0.5) + fields[3] * t116;
        forces[10] = fields[1] * t97 + t107 * (fields[7] * 0.5) + fields[4] * t116;
        forces[11] = fields[2] * t97 + t107 * (fields[8] * 0.5) + fields[5] * t116;
        forces[12] = fields[0] * t100 - t107 * (fields[3] * 0.5) + fields[6] * t119;
        forces[13] = fields[1] * t100 - t107 * (fields[4] * 0.5) + fields[7] * t119;
        forces[14] = fields[2] * t100 - t107 * (fields[5] * 0.5) + fields[8] * t119;
    }
    /// Adds the inertia forces of a fixture on position r, slope s and section axes y, z of its place (THEORY 5.4) in the inertial frame; e is minus gravity: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 60 additions, 60 multiplications.
    pub fn fixture_spatial_section_absolute_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let [m, m_x, m_y, m_z, p_xx, p_yy, p_zz, p_xy, p_xz, p_yz] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z, a_y_x, a_y_y, a_y_z, a_z_x, a_z_y,
        a_z_z] = *a;
        let t40 = m * a_r_x + m_x * a_s_x + m_y * a_y_x + m_z * a_z_x + m * e_x;
        let t41 = m * a_r_y + m_x * a_s_y + m_y * a_y_y + m_z * a_z_y + m * e_y;
        let t42 = m * a_r_z + m_x * a_s_z + m_y * a_y_z + m_z * a_z_z + m * e_z;
        let t43 = m_x * a_r_x + p_xx * a_s_x + p_xy * a_y_x + p_xz * a_z_x + m_x * e_x;
        let t44 = m_x * a_r_y + p_xx * a_s_y + p_xy * a_y_y + p_xz * a_z_y + m_x * e_y;
        let t45 = m_x * a_r_z + p_xx * a_s_z + p_xy * a_y_z + p_xz * a_z_z + m_x * e_z;
        let t46 = m_y * a_r_x + p_xy * a_s_x + p_yy * a_y_x + p_yz * a_z_x + m_y * e_x;
        let t47 = m_y * a_r_y + p_xy * a_s_y + p_yy * a_y_y + p_yz * a_z_y + m_y * e_y;
        let t48 = m_y * a_r_z + p_xy * a_s_z + p_yy * a_y_z + p_yz * a_z_z + m_y * e_z;
        let t49 = m_z * a_r_x + p_xz * a_s_x + p_yz * a_y_x + p_zz * a_z_x + m_z * e_x;
        let t50 = m_z * a_r_y + p_xz * a_s_y + p_yz * a_y_y + p_zz * a_z_y + m_z * e_y;
        let t51 = m_z * a_r_z + p_xz * a_s_z + p_yz * a_y_z + p_zz * a_z_z + m_z * e_z;
        force[0] += t40;
        force[1] += t41;
        force[2] += t42;
        force[3] += t43;
        force[4] += t44;
        force[5] += t45;
        force[6] += t46;
        force[7] += t47;
        force[8] += t48;
        force[9] += t49;
        force[10] += t50;
        force[11] += t51;
    }
    /// Adds the inertia forces of a fixture on position r, slope s and section axes y, z of its place (THEORY 5.4) in a moving frame: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 144 additions, 168 multiplications.
    pub fn fixture_spatial_section_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let [m, m_x, m_y, m_z, p_xx, p_yy, p_zz, p_xy, p_xz, p_yz] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z, y_x, y_y, y_z, z_x, z_y, z_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z, v_y_x, v_y_y, v_y_z, v_z_x, v_z_y,
        v_z_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z, a_y_x, a_y_y, a_y_z, a_z_x, a_z_y,
        a_z_z] = *a;
        let t70 = r_z * w_y - r_y * w_z;
        let t71 = r_x * w_z - r_z * w_x;
        let t72 = r_y * w_x - r_x * w_y;
        let t73 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t74 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t75 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t76 = w_y * t72 - w_z * t71 + t73;
        let t77 = w_z * t70 - w_x * t72 + t74;
        let t78 = w_x * t71 - w_y * t70 + t75;
        let t79 = s_z * w_y - s_y * w_z;
        let t80 = s_x * w_z - s_z * w_x;
        let t81 = s_y * w_x - s_x * w_y;
        let t82 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t83 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t84 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t85 = w_y * t81 - w_z * t80 + t82;
        let t86 = w_z * t79 - w_x * t81 + t83;
        let t87 = w_x * t80 - w_y * t79 + t84;
        let t88 = y_z * w_y - y_y * w_z;
        let t89 = y_x * w_z - y_z * w_x;
        let t90 = y_y * w_x - y_x * w_y;
        let t91 = y_z * dw_y - y_y * dw_z + (a_y_x + 2.0 * (v_y_z * w_y - v_y_y * w_z));
        let t92 = y_x * dw_z - y_z * dw_x + (a_y_y + 2.0 * (v_y_x * w_z - v_y_z * w_x));
        let t93 = y_y * dw_x - y_x * dw_y + (a_y_z + 2.0 * (v_y_y * w_x - v_y_x * w_y));
        let t94 = w_y * t90 - w_z * t89 + t91;
        let t95 = w_z * t88 - w_x * t90 + t92;
        let t96 = w_x * t89 - w_y * t88 + t93;
        let t97 = z_z * w_y - z_y * w_z;
        let t98 = z_x * w_z - z_z * w_x;
        let t99 = z_y * w_x - z_x * w_y;
        let t100 = z_z * dw_y - z_y * dw_z + (a_z_x + 2.0 * (v_z_z * w_y - v_z_y * w_z));
        let t101 = z_x * dw_z - z_z * dw_x + (a_z_y + 2.0 * (v_z_x * w_z - v_z_z * w_x));
        let t102 = z_y * dw_x - z_x * dw_y + (a_z_z + 2.0 * (v_z_y * w_x - v_z_x * w_y));
        let t103 = w_y * t99 - w_z * t98 + t100;
        let t104 = w_z * t97 - w_x * t99 + t101;
        let t105 = w_x * t98 - w_y * t97 + t102;
        let t106 = m * t76 + m_x * t85 + m_y * t94 + m_z * t103 + m * e_x;
        let t107 = m * t77 + m_x * t86 + m_y * t95 + m_z * t104 + m * e_y;
        let t108 = m * t78 + m_x * t87 + m_y * t96 + m_z * t105 + m * e_z;
        let t109 = m_x * t76 + p_xx * t85 + p_xy * t94 + p_xz * t103 + m_x * e_x;
        let t110 = m_x * t77 + p_xx * t86 + p_xy * t95 + p_xz * t104 + m_x * e_y;
        let t111 = m_x * t78 + p_xx * t87 + p_xy * t96 + p_xz * t105 + m_x * e_z;
        let t112 = m_y * t76 + p_xy * t85 + p_yy * t94 + p_yz * t103 + m_y * e_x;
        let t113 = m_y * t77 + p_xy * t86 + p_yy * t95 + p_yz * t104 + m_y * e_y;
        let t114 = m_y * t78 + p_xy * t87 + p_yy * t96 + p_yz * t105 + m_y * e_z;
        let t115 = m_z * t76 + p_xz * t85 + p_yz * t94 + p_zz * t103 + m_z * e_x;
        let t116 = m_z * t77 + p_xz * t86 + p_yz * t95 + p_zz * t104 + m_z * e_y;
        let t117 = m_z * t78 + p_xz * t87 + p_yz * t96 + p_zz * t105 + m_z * e_z;
        force[0] += t106;
        force[1] += t107;
        force[2] += t108;
        force[3] += t109;
        force[4] += t110;
        force[5] += t111;
        force[6] += t112;
        force[7] += t113;
        force[8] += t114;
        force[9] += t115;
        force[10] += t116;
        force[11] += t117;
    }
    /// Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Operations: 249 additions, 201 multiplications.
    pub fn fixture_spatial_section_inertia_tangent(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 144],
        damping_matrix: &mut [f64; 144],
    ) {
        let [m, m_x, m_y, m_z, p_xx, p_yy, p_zz, p_xy, p_xz, p_yz] = constants;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let t31 = w_y * w_y;
        let t32 = w_z * w_z;
        let t33 = t31 + t32;
        let t34 = w_x * w_y;
        let t35 = t34 - dw_z;
        let t36 = w_x * w_z;
        let t37 = dw_y + t36;
        let t38 = dw_z + t34;
        let t39 = w_x * w_x;
        let t40 = t32 + t39;
        let t41 = w_y * w_z;
        let t42 = t41 - dw_x;
        let t43 = t36 - dw_y;
        let t44 = dw_x + t41;
        let t45 = t31 + t39;
        let t46 = w_z * 2.0;
        let t47 = m * t46;
        let t48 = w_y * 2.0;
        let t49 = m * t48;
        let t50 = m_x * t46;
        let t51 = m_x * t48;
        let t52 = m_y * t46;
        let t53 = m_y * t48;
        let t54 = m_z * t46;
        let t55 = m_z * t48;
        let t56 = w_x * 2.0;
        let t57 = m * t56;
        let t58 = m_x * t56;
        let t59 = m_y * t56;
        let t60 = m_z * t56;
        let t61 = m_x * t46;
        let t62 = m_x * t48;
        let t63 = p_xx * t46;
        let t64 = p_xx * t48;
        let t65 = p_xy * t46;
        let t66 = p_xy * t48;
        let t67 = p_xz * t46;
        let t68 = p_xz * t48;
        let t69 = m_x * t56;
        let t70 = p_xx * t56;
        let t71 = p_xy * t56;
        let t72 = p_xz * t56;
        let t73 = m_y * t46;
        let t74 = m_y * t48;
        let t75 = p_xy * t46;
        let t76 = p_xy * t48;
        let t77 = p_yy * t46;
        let t78 = p_yy * t48;
        let t79 = p_yz * t46;
        let t80 = p_yz * t48;
        let t81 = m_y * t56;
        let t82 = p_xy * t56;
        let t83 = p_yy * t56;
        let t84 = p_yz * t56;
        let t85 = m_z * t46;
        let t86 = m_z * t48;
        let t87 = p_xz * t46;
        let t88 = p_xz * t48;
        let t89 = p_yz * t46;
        let t90 = p_yz * t48;
        let t91 = p_zz * t46;
        let t92 = p_zz * t48;
        let t93 = m_z * t56;
        let t94 = p_xz * t56;
        let t95 = p_yz * t56;
        let t96 = p_zz * t56;
        stiffness[0] += -m * t33;
        stiffness[1] += m * t35;
        stiffness[2] += m * t37;
        stiffness[3] += -m_x * t33;
        stiffness[4] += m_x * t35;
        stiffness[5] += m_x * t37;
        stiffness[6] += -m_y * t33;
        stiffness[7] += m_y * t35;
        stiffness[8] += m_y * t37;
        stiffness[9] += -m_z * t33;
        stiffness[10] += m_z * t35;
        stiffness[11] += m_z * t37;
        stiffness[12] += m * t38;
        stiffness[13] += -m * t40;
        stiffness[14] += m * t42;
        stiffness[15] += m_x * t38;
        stiffness[16] += -m_x * t40;
        stiffness[17] += m_x * t42;
        stiffness[18] += m_y * t38;
        stiffness[19] += -m_y * t40;
        stiffness[20] += m_y * t42;
        stiffness[21] += m_z * t38;
        stiffness[22] += -m_z * t40;
        stiffness[23] += m_z * t42;
        stiffness[24] += m * t43;
        stiffness[25] += m * t44;
        stiffness[26] += -m * t45;
        stiffness[27] += m_x * t43;
        stiffness[28] += m_x * t44;
        stiffness[29] += -m_x * t45;
        stiffness[30] += m_y * t43;
        stiffness[31] += m_y * t44;
        stiffness[32] += -m_y * t45;
        stiffness[33] += m_z * t43;
        stiffness[34] += m_z * t44;
        stiffness[35] += -m_z * t45;
        stiffness[36] += -m_x * t33;
        stiffness[37] += m_x * t35;
        stiffness[38] += m_x * t37;
        stiffness[39] += -p_xx * t33;
        stiffness[40] += p_xx * t35;
        stiffness[41] += p_xx * t37;
        stiffness[42] += -p_xy * t33;
        stiffness[43] += p_xy * t35;
        stiffness[44] += p_xy * t37;
        stiffness[45] += -p_xz * t33;
        stiffness[46] += p_xz * t35;
        stiffness[47] += p_xz * t37;
        stiffness[48] += m_x * t38;
        stiffness[49] += -m_x * t40;
        stiffness[50] += m_x * t42;
        stiffness[51] += p_xx * t38;
        stiffness[52] += -p_xx * t40;
        stiffness[53] += p_xx * t42;
        stiffness[54] += p_xy * t38;
        stiffness[55] += -p_xy * t40;
        stiffness[56] += p_xy * t42;
        stiffness[57] += p_xz * t38;
        stiffness[58] += -p_xz * t40;
        stiffness[59] += p_xz * t42;
        stiffness[60] += m_x * t43;
        stiffness[61] += m_x * t44;
        stiffness[62] += -m_x * t45;
        stiffness[63] += p_xx * t43;
        stiffness[64] += p_xx * t44;
        stiffness[65] += -p_xx * t45;
        stiffness[66] += p_xy * t43;
        stiffness[67] += p_xy * t44;
        stiffness[68] += -p_xy * t45;
        stiffness[69] += p_xz * t43;
        stiffness[70] += p_xz * t44;
        stiffness[71] += -p_xz * t45;
        stiffness[72] += -m_y * t33;
        stiffness[73] += m_y * t35;
        stiffness[74] += m_y * t37;
        stiffness[75] += -p_xy * t33;
        stiffness[76] += p_xy * t35;
        stiffness[77] += p_xy * t37;
        stiffness[78] += -p_yy * t33;
        stiffness[79] += p_yy * t35;
        stiffness[80] += p_yy * t37;
        stiffness[81] += -p_yz * t33;
        stiffness[82] += p_yz * t35;
        stiffness[83] += p_yz * t37;
        stiffness[84] += m_y * t38;
        stiffness[85] += -m_y * t40;
        stiffness[86] += m_y * t42;
        stiffness[87] += p_xy * t38;
        stiffness[88] += -p_xy * t40;
        stiffness[89] += p_xy * t42;
        stiffness[90] += p_yy * t38;
        stiffness[91] += -p_yy * t40;
        stiffness[92] += p_yy * t42;
        stiffness[93] += p_yz * t38;
        stiffness[94] += -p_yz * t40;
        stiffness[95] += p_yz * t42;
        stiffness[96] += m_y * t43;
        stiffness[97] += m_y * t44;
        stiffness[98] += -m_y * t45;
        stiffness[99] += p_xy * t43;
        stiffness[100] += p_xy * t44;
        stiffness[101] += -p_xy * t45;
        stiffness[102] += p_yy * t43;
        stiffness[103] += p_yy * t44;
        stiffness[104] += -p_yy * t45;
        stiffness[105] += p_yz * t43;
        stiffness[106] += p_yz * t44;
        stiffness[107] += -p_yz * t45;
        stiffness[108] += -m_z * t33;
        stiffness[109] += m_z * t35;
        stiffness[110] += m_z * t37;
        stiffness[111] += -p_xz * t33;
        stiffness[112] += p_xz * t35;
        stiffness[113] += p_xz * t37;
        stiffness[114] += -p_yz * t33;
        stiffness[115] += p_yz * t35;
        stiffness[116] += p_yz * t37;
        stiffness[117] += -p_zz * t33;
        stiffness[118] += p_zz * t35;
        stiffness[119] += p_zz * t37;
        stiffness[120] += m_z * t38;
        stiffness[121] += -m_z * t40;
        stiffness[122] += m_z * t42;
        stiffness[123] += p_xz * t38;
        stiffness[124] += -p_xz * t40;
        stiffness[125] += p_xz * t42;
        stiffness[126] += p_yz * t38;
        stiffness[127] += -p_yz * t40;
        stiffness[128] += p_yz * t42;
        stiffness[129] += p_zz * t38;
        stiffness[130] += -p_zz * t40;
        stiffness[131] += p_zz * t42;
        stiffness[132] += m_z * t43;
        stiffness[133] += m_z * t44;
        stiffness[134] += -m_z * t45;
        stiffness[135] += p_xz * t43;
        stiffness[136] += p_xz * t44;
        stiffness[137] += -p_xz * t45;
        stiffness[138] += p_yz * t43;
        stiffness[139] += p_yz * t44;
        stiffness[140] += -p_yz * t45;
        stiffness[141] += p_zz * t43;
        stiffness[142] += p_zz * t44;
        stiffness[143] += -p_zz * t45;
        damping_matrix[1] -= t47;
        damping_matrix[2] += t49;
        damping_matrix[4] -= t50;
        damping_matrix[5] += t51;
        damping_matrix[7] -= t52;
        damping_matrix[8] += t53;
        damping_matrix[10] -= t54;
        damping_matrix[11] += t55;
        damping_matrix[12] += t47;
        damping_matrix[14] -= t57;
        damping_matrix[15] += t50;
        damping_matrix[17] -= t58;
        damping_matrix[18] += t52;
        damping_matrix[20] -= t59;
        damping_matrix[21] += t54;
        damping_matrix[23] -= t60;
        damping_matrix[24] -= t49;
        damping_matrix[25] += t57;
        damping_matrix[27] -= t51;
        damping_matrix[28] += t58;
        damping_matrix[30] -= t53;
        damping_matrix[31] += t59;
        damping_matrix[33] -= t55;
        damping_matrix[34] += t60;
        damping_matrix[37] -= t61;
        damping_matrix[38] += t62;
        damping_matrix[40] -= t63;
        damping_matrix[41] += t64;
        damping_matrix[43] -= t65;
        damping_matrix[44] += t66;
        damping_matrix[46] -= t67;
        damping_matrix[47] += t68;
        damping_matrix[48] += t61;
        damping_matrix[50] -= t69;
        damping_matrix[51] += t63;
        damping_matrix[53] -= t70;
        damping_matrix[54] += t65;
        damping_matrix[56] -= t71;
        damping_matrix[57] += t67;
        damping_matrix[59] -= t72;
        damping_matrix[60] -= t62;
        damping_matrix[61] += t69;
        damping_matrix[63] -= t64;
        damping_matrix[64] += t70;
        damping_matrix[66] -= t66;
        damping_matrix[67] += t71;
        damping_matrix[69] -= t68;
        damping_matrix[70] += t72;
        damping_matrix[73] -= t73;
        damping_matrix[74] += t74;
        damping_matrix[76] -= t75;
        damping_matrix[77] += t76;
        damping_matrix[79] -= t77;
        damping_matrix[80] += t78;
        damping_matrix[82] -= t79;
        damping_matrix[83] += t80;
        damping_matrix[84] += t73;
        damping_matrix[86] -= t81;
        damping_matrix[87] += t75;
        damping_matrix[89] -= t82;
        damping_matrix[90] += t77;
        damping_matrix[92] -= t83;
        damping_matrix[93] += t79;
        damping_matrix[95] -= t84;
        damping_matrix[96] -= t74;
        damping_matrix[97] += t81;
        damping_matrix[99] -= t76;
        damping_matrix[100] += t82;
        damping_matrix[102] -= t78;
        damping_matrix[103] += t83;
        damping_matrix[105] -= t80;
        damping_matrix[106] += t84;
        damping_matrix[109] -= t85;
        damping_matrix[110] += t86;
        damping_matrix[112] -= t87;
        damping_matrix[113] += t88;
        damping_matrix[115] -= t89;
        damping_matrix[116] += t90;
        damping_matrix[118] -= t91;
        damping_matrix[119] += t92;
        damping_matrix[120] += t85;
        damping_matrix[122] -= t93;
        damping_matrix[123] += t87;
        damping_matrix[125] -= t94;
        damping_matrix[126] += t89;
        damping_matrix[128] -= t95;
        damping_matrix[129] += t91;
        damping_matrix[131] -= t96;
        damping_matrix[132] -= t86;
        damping_matrix[133] += t93;
        damping_matrix[135] -= t88;
        damping_matrix[136] += t94;
        damping_matrix[138] -= t90;
        damping_matrix[139] += t95;
        damping_matrix[141] -= t92;
        damping_matrix[142] += t96;
    }
    /// Motion of frame `rotor` and its first three derivatives.
    ///
    /// Operations: 9 additions, 17 multiplications, 6 divisions, 4 function calls.
    pub fn frame_rotor(
        model: &super::Motor,
        t: f64,
        motion: &mut ::rncf::mesh::FrameMotion,
    ) {
        *motion = ::rncf::mesh::FrameMotion::INERTIAL;
        let t18 = model.speed / model.T_s;
        let t19 = (model.T_s / 6.283185307179586).powi(2);
        let t20 = t * 6.283185307179586 / model.T_s;
        let t21 = t20.cos();
        let theta = (if t <= model.T_s {
            t18 * (t * t / 2.0 + t19 * (t21 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = 6.283185307179586 / model.T_s;
        let t26 = t25 * t20.sin();
        let theta_t = (if t <= model.T_s { t18 * (t - t19 * t26) } else { model.speed });
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
        motion.spin[0] = theta_t;
        motion.spin_rate[0] = theta_t_t;
        motion.spin_jerk[0] = theta_t_t_t;
        motion.rotation[1][1] = t23;
        motion.rotation[1][2] = -t24;
        motion.rotation[2][1] = t24;
        motion.rotation[2][2] = t23;
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
    /// Joint `drive_end`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_velocity(
        model: &super::Motor,
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
        rows[5] = 0.0;
        rows[6] = 0.0;
    }
    /// Joint `drive_end`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_acceleration(
        model: &super::Motor,
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
        rows[5] = 0.0;
        rows[6] = 0.0;
    }
    /// Joint `drive_end`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_drive_end_referenced_jerk(
        model: &super::Motor,
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
        rows[5] = 0.0;
        rows[6] = 0.0;
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
        jacobian[1] = 0.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
        jacobian[6] = 0.0;
        jacobian[7] = 0.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 1.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 0.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
        jacobian[18] = 0.0;
        jacobian[19] = 0.0;
        jacobian[20] = 1.0;
        jacobian[21] = 0.0;
        jacobian[22] = 0.0;
        jacobian[23] = 0.0;
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
        jacobian[27] = 0.0;
        jacobian[28] = 0.0;
        jacobian[29] = 0.0;
        jacobian[30] = data.normals[0][0];
        jacobian[31] = data.normals[0][1];
        jacobian[32] = data.normals[0][2];
        jacobian[33] = 0.0;
        jacobian[34] = 0.0;
        jacobian[35] = 0.0;
        jacobian[36] = 0.0;
        jacobian[37] = 0.0;
        jacobian[38] = 0.0;
        jacobian[39] = data.normals[1][0];
        jacobian[40] = data.normals[1][1];
        jacobian[41] = data.normals[1][2];
        jacobian[42] = 0.0;
        jacobian[43] = 0.0;
        jacobian[44] = 0.0;
        jacobian[45] = 0.0;
        jacobian[46] = 0.0;
        jacobian[47] = 0.0;
        jacobian[48] = 0.0;
        jacobian[49] = 0.0;
        jacobian[50] = 0.0;
        jacobian[51] = data.second[1][0];
        jacobian[52] = data.second[1][1];
        jacobian[53] = data.second[1][2];
        jacobian[54] = 0.0;
        jacobian[55] = 0.0;
        jacobian[56] = 0.0;
        jacobian[57] = 0.0;
        jacobian[58] = 0.0;
        jacobian[59] = 0.0;
        jacobian[60] = data.second[2][0];
        jacobian[61] = data.second[2][1];
        jacobian[62] = data.second[2][2];
    }
    /// Joint `drive_end`: what it prescribes, with three derivatives.
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
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = data.second[0][1];
        prescribed.second[0][2] = data.second[0][2];
        prescribed.second[1][0] = 0.0;
        prescribed.second[1][1] = 0.0;
        prescribed.second[1][2] = 0.0;
        prescribed.second[2][0] = 0.0;
        prescribed.second[2][1] = 0.0;
        prescribed.second[2][2] = 0.0;
        prescribed.second[3][0] = 0.0;
        prescribed.second[3][1] = 0.0;
        prescribed.second[3][2] = 0.0;
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
        let t42 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t42
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t44 = theta.cos();
        let t45 = theta.sin();
        let t46 = data.normals[0][0] * q[3]
            + q[4] * (t44 * data.normals[0][1] - t45 * data.normals[0][2])
            + q[5] * (t45 * data.normals[0][1] + t44 * data.normals[0][2]);
        let t47 = data.normals[1][0] * q[3]
            + q[4] * (t44 * data.normals[1][1] - t45 * data.normals[1][2])
            + q[5] * (t45 * data.normals[1][1] + t44 * data.normals[1][2]);
        let t48 = data.second[1][0] * q[6]
            + q[7] * (t44 * data.second[1][1] - t45 * data.second[1][2])
            + q[8] * (t45 * data.second[1][1] + t44 * data.second[1][2]);
        let t49 = data.second[2][0] * q[6]
            + q[7] * (t44 * data.second[2][1] - t45 * data.second[2][2])
            + q[8] * (t45 * data.second[2][1] + t44 * data.second[2][2]);
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t44 * data.point[1] - t45 * data.point[2]);
        rows[2] = q[2] - (t45 * data.point[1] + t44 * data.point[2]);
        rows[3] = t46;
        rows[4] = t47;
        rows[5] = t48;
        rows[6] = t49;
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
        let t32 = model.speed / model.T_s;
        let t33 = (model.T_s / 6.283185307179586).powi(2);
        let t34 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t32 * (t * t / 2.0 + t33 * (t34.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t36 = (if t <= model.T_s {
            t32 * (t - t33 * (6.283185307179586 / model.T_s * t34.sin()))
        } else {
            model.speed
        });
        let t37 = theta.sin() * t36;
        let t38 = theta.cos() * t36;
        let t39 = q[5] * (data.normals[0][1] * t38 - data.normals[0][2] * t37)
            - q[4] * (data.normals[0][1] * t37 + data.normals[0][2] * t38);
        let t40 = q[5] * (data.normals[1][1] * t38 - data.normals[1][2] * t37)
            - q[4] * (data.normals[1][1] * t37 + data.normals[1][2] * t38);
        let t41 = q[8] * (data.second[1][1] * t38 - data.second[1][2] * t37)
            - q[7] * (data.second[1][1] * t37 + data.second[1][2] * t38);
        let t42 = q[8] * (data.second[2][1] * t38 - data.second[2][2] * t37)
            - q[7] * (data.second[2][1] * t37 + data.second[2][2] * t38);
        rows[0] = 0.0;
        rows[1] = data.point[1] * t37 + data.point[2] * t38;
        rows[2] = data.point[2] * t37 - data.point[1] * t38;
        rows[3] = t39;
        rows[4] = t40;
        rows[5] = t41;
        rows[6] = t42;
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
        let t36 = model.speed / model.T_s;
        let t37 = (model.T_s / 6.283185307179586).powi(2);
        let t38 = t * 6.283185307179586 / model.T_s;
        let t39 = t38.cos();
        let theta = (if t <= model.T_s {
            t36 * (t * t / 2.0 + t37 * (t39 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t41 = theta.cos();
        let t42 = theta.sin();
        let t43 = 6.283185307179586 / model.T_s;
        let t44 = (if t <= model.T_s {
            t36 * (t - t37 * (t43 * t38.sin()))
        } else {
            model.speed
        });
        let t45 = t42 * t44;
        let t46 = t41 * t44;
        let t47 = (if t <= model.T_s {
            t36 * (1.0 - t37 * (t43 * (t39 * t43)))
        } else {
            0.0
        });
        let t48 = t44 * t46 + t42 * t47;
        let t49 = t41 * t47 - t44 * t45;
        let t50 = v[4] * (data.normals[0][1] * t45 + data.normals[0][2] * t46);
        let t51 = v[5] * (data.normals[0][1] * t46 - data.normals[0][2] * t45);
        let t52 = v[4] * (data.normals[1][1] * t45 + data.normals[1][2] * t46);
        let t53 = v[5] * (data.normals[1][1] * t46 - data.normals[1][2] * t45);
        let t54 = v[7] * (data.second[1][1] * t45 + data.second[1][2] * t46);
        let t55 = v[8] * (data.second[1][1] * t46 - data.second[1][2] * t45);
        let t56 = v[7] * (data.second[2][1] * t45 + data.second[2][2] * t46);
        let t57 = v[8] * (data.second[2][1] * t46 - data.second[2][2] * t45);
        let t58 = t51
            + (t51 + q[5] * (data.normals[0][1] * t49 - data.normals[0][2] * t48))
            - (t50
                + (t50 + q[4] * (data.normals[0][1] * t48 + data.normals[0][2] * t49)));
        let t59 = t53
            + (t53 + q[5] * (data.normals[1][1] * t49 - data.normals[1][2] * t48))
            - (t52
                + (t52 + q[4] * (data.normals[1][1] * t48 + data.normals[1][2] * t49)));
        let t60 = t55
            + (t55 + q[8] * (data.second[1][1] * t49 - data.second[1][2] * t48))
            - (t54 + (t54 + q[7] * (data.second[1][1] * t48 + data.second[1][2] * t49)));
        let t61 = t57
            + (t57 + q[8] * (data.second[2][1] * t49 - data.second[2][2] * t48))
            - (t56 + (t56 + q[7] * (data.second[2][1] * t48 + data.second[2][2] * t49)));
        rows[0] = 0.0;
        rows[1] = data.point[1] * t48 + data.point[2] * t49;
        rows[2] = data.point[2] * t48 - data.point[1] * t49;
        rows[3] = t58;
        rows[4] = t59;
        rows[5] = t60;
        rows[6] = t61;
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
        let t40 = model.speed / model.T_s;
        let t41 = (model.T_s / 6.283185307179586).powi(2);
        let t42 = t * 6.283185307179586 / model.T_s;
        let t43 = t42.cos();
        let theta = (if t <= model.T_s {
            t40 * (t * t / 2.0 + t41 * (t43 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t45 = theta.cos();
        let t46 = theta.sin();
        let t47 = 6.283185307179586 / model.T_s;
        let t48 = t47 * t42.sin();
        let t49 = (if t <= model.T_s { t40 * (t - t41 * t48) } else { model.speed });
        let t50 = t46 * t49;
        let t51 = t45 * t49;
        let t52 = (if t <= model.T_s {
            t40 * (1.0 - t41 * (t47 * (t43 * t47)))
        } else {
            0.0
        });
        let t53 = t49 * t51 + t46 * t52;
        let t54 = t45 * t52 - t49 * t50;
        let t55 = (if t <= model.T_s { t40 * (t41 * (t47 * (t47 * t48))) } else { 0.0 });
        let t56 = t51 * t52;
        let t57 = t56 + t49 * t54 + (t56 + t46 * t55);
        let t58 = t50 * t52;
        let t59 = t45 * t55 - t58 - (t58 + t49 * t53);
        let t60 = a[4] * (data.normals[0][1] * t50 + data.normals[0][2] * t51);
        let t61 = v[4] * (data.normals[0][1] * t53 + data.normals[0][2] * t54);
        let t62 = t60 + t61;
        let t63 = a[5] * (data.normals[0][1] * t51 - data.normals[0][2] * t50);
        let t64 = v[5] * (data.normals[0][1] * t54 - data.normals[0][2] * t53);
        let t65 = t63 + t64;
        let t66 = t63 + t65
            + (t65
                + (t64 + q[5] * (data.normals[0][1] * t59 - data.normals[0][2] * t57)))
            - (t60 + t62
                + (t62
                    + (t61
                        + q[4]
                            * (data.normals[0][1] * t57 + data.normals[0][2] * t59))));
        let t67 = a[4] * (data.normals[1][1] * t50 + data.normals[1][2] * t51);
        let t68 = v[4] * (data.normals[1][1] * t53 + data.normals[1][2] * t54);
        let t69 = t67 + t68;
        let t70 = a[5] * (data.normals[1][1] * t51 - data.normals[1][2] * t50);
        let t71 = v[5] * (data.normals[1][1] * t54 - data.normals[1][2] * t53);
        let t72 = t70 + t71;
        let t73 = t70 + t72
            + (t72
                + (t71 + q[5] * (data.normals[1][1] * t59 - data.normals[1][2] * t57)))
            - (t67 + t69
                + (t69
                    + (t68
                        + q[4]
                            * (data.normals[1][1] * t57 + data.normals[1][2] * t59))));
        let t74 = a[7] * (data.second[1][1] * t50 + data.second[1][2] * t51);
        let t75 = v[7] * (data.second[1][1] * t53 + data.second[1][2] * t54);
        let t76 = t74 + t75;
        let t77 = a[8] * (data.second[1][1] * t51 - data.second[1][2] * t50);
        let t78 = v[8] * (data.second[1][1] * t54 - data.second[1][2] * t53);
        let t79 = t77 + t78;
        let t80 = t77 + t79
            + (t79 + (t78 + q[8] * (data.second[1][1] * t59 - data.second[1][2] * t57)))
            - (t74 + t76
                + (t76
                    + (t75
                        + q[7] * (data.second[1][1] * t57 + data.second[1][2] * t59))));
        let t81 = a[7] * (data.second[2][1] * t50 + data.second[2][2] * t51);
        let t82 = v[7] * (data.second[2][1] * t53 + data.second[2][2] * t54);
        let t83 = t81 + t82;
        let t84 = a[8] * (data.second[2][1] * t51 - data.second[2][2] * t50);
        let t85 = v[8] * (data.second[2][1] * t54 - data.second[2][2] * t53);
        let t86 = t84 + t85;
        let t87 = t84 + t86
            + (t86 + (t85 + q[8] * (data.second[2][1] * t59 - data.second[2][2] * t57)))
            - (t81 + t83
                + (t83
                    + (t82
                        + q[7] * (data.second[2][1] * t57 + data.second[2][2] * t59))));
        rows[0] = 0.0;
        rows[1] = data.point[1] * t57 + data.point[2] * t59;
        rows[2] = data.point[2] * t57 - data.point[1] * t59;
        rows[3] = t66;
        rows[4] = t73;
        rows[5] = t80;
        rows[6] = t87;
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
        let t30 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t30
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t32 = theta.cos();
        let t33 = theta.sin();
        jacobian[0] = 1.0;
        jacobian[1] = 0.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
        jacobian[6] = 0.0;
        jacobian[7] = 0.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 1.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 0.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
        jacobian[18] = 0.0;
        jacobian[19] = 0.0;
        jacobian[20] = 1.0;
        jacobian[21] = 0.0;
        jacobian[22] = 0.0;
        jacobian[23] = 0.0;
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
        jacobian[27] = 0.0;
        jacobian[28] = 0.0;
        jacobian[29] = 0.0;
        jacobian[30] = data.normals[0][0];
        jacobian[31] = t32 * data.normals[0][1] - t33 * data.normals[0][2];
        jacobian[32] = t33 * data.normals[0][1] + t32 * data.normals[0][2];
        jacobian[33] = 0.0;
        jacobian[34] = 0.0;
        jacobian[35] = 0.0;
        jacobian[36] = 0.0;
        jacobian[37] = 0.0;
        jacobian[38] = 0.0;
        jacobian[39] = data.normals[1][0];
        jacobian[40] = t32 * data.normals[1][1] - t33 * data.normals[1][2];
        jacobian[41] = t33 * data.normals[1][1] + t32 * data.normals[1][2];
        jacobian[42] = 0.0;
        jacobian[43] = 0.0;
        jacobian[44] = 0.0;
        jacobian[45] = 0.0;
        jacobian[46] = 0.0;
        jacobian[47] = 0.0;
        jacobian[48] = 0.0;
        jacobian[49] = 0.0;
        jacobian[50] = 0.0;
        jacobian[51] = data.second[1][0];
        jacobian[52] = t32 * data.second[1][1] - t33 * data.second[1][2];
        jacobian[53] = t33 * data.second[1][1] + t32 * data.second[1][2];
        jacobian[54] = 0.0;
        jacobian[55] = 0.0;
        jacobian[56] = 0.0;
        jacobian[57] = 0.0;
        jacobian[58] = 0.0;
        jacobian[59] = 0.0;
        jacobian[60] = data.second[2][0];
        jacobian[61] = t32 * data.second[2][1] - t33 * data.second[2][2];
        jacobian[62] = t33 * data.second[2][1] + t32 * data.second[2][2];
    }
    /// Joint `drive_end`: what it prescribes, with three derivatives.
    ///
    /// Operations: 41 additions, 77 multiplications, 6 divisions, 4 function calls.
    pub fn joint_drive_end_absolute_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t27 = model.speed / model.T_s;
        let t28 = (model.T_s / 6.283185307179586).powi(2);
        let t29 = t * 6.283185307179586 / model.T_s;
        let t30 = t29.cos();
        let theta = (if t <= model.T_s {
            t27 * (t * t / 2.0 + t28 * (t30 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t32 = theta.cos();
        let t33 = theta.sin();
        let t34 = 6.283185307179586 / model.T_s;
        let t35 = t34 * t29.sin();
        let t36 = (if t <= model.T_s { t27 * (t - t28 * t35) } else { model.speed });
        let t37 = t33 * t36;
        let t38 = t32 * t36;
        let t39 = (if t <= model.T_s {
            t27 * (1.0 - t28 * (t34 * (t30 * t34)))
        } else {
            0.0
        });
        let t40 = t36 * t38 + t33 * t39;
        let t41 = t32 * t39 - t36 * t37;
        let t42 = (if t <= model.T_s { t27 * (t28 * (t34 * (t34 * t35))) } else { 0.0 });
        let t43 = t38 * t39;
        let t44 = t43 + t36 * t41 + (t43 + t33 * t42);
        let t45 = t37 * t39;
        let t46 = t32 * t42 - t45 - (t45 + t36 * t40);
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t32 * data.point[1] - t33 * data.point[2];
        prescribed.position[0][2] = t33 * data.point[1] + t32 * data.point[2];
        prescribed.position[1][0] = 0.0;
        prescribed.position[1][1] = -(data.point[1] * t37 + data.point[2] * t38);
        prescribed.position[1][2] = data.point[1] * t38 - data.point[2] * t37;
        prescribed.position[2][0] = 0.0;
        prescribed.position[2][1] = -(data.point[1] * t40 + data.point[2] * t41);
        prescribed.position[2][2] = data.point[1] * t41 - data.point[2] * t40;
        prescribed.position[3][0] = 0.0;
        prescribed.position[3][1] = -(data.point[1] * t44 + data.point[2] * t46);
        prescribed.position[3][2] = data.point[1] * t46 - data.point[2] * t44;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t32 * data.tangent[1] - t33 * data.tangent[2];
        prescribed.slope[0][2] = t33 * data.tangent[1] + t32 * data.tangent[2];
        prescribed.slope[1][0] = 0.0;
        prescribed.slope[1][1] = -(data.tangent[1] * t37 + data.tangent[2] * t38);
        prescribed.slope[1][2] = data.tangent[1] * t38 - data.tangent[2] * t37;
        prescribed.slope[2][0] = 0.0;
        prescribed.slope[2][1] = -(data.tangent[1] * t40 + data.tangent[2] * t41);
        prescribed.slope[2][2] = data.tangent[1] * t41 - data.tangent[2] * t40;
        prescribed.slope[3][0] = 0.0;
        prescribed.slope[3][1] = -(data.tangent[1] * t44 + data.tangent[2] * t46);
        prescribed.slope[3][2] = data.tangent[1] * t46 - data.tangent[2] * t44;
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = t32 * data.second[0][1] - t33 * data.second[0][2];
        prescribed.second[0][2] = t33 * data.second[0][1] + t32 * data.second[0][2];
        prescribed.second[1][0] = 0.0;
        prescribed.second[1][1] = -(data.second[0][1] * t37 + data.second[0][2] * t38);
        prescribed.second[1][2] = data.second[0][1] * t38 - data.second[0][2] * t37;
        prescribed.second[2][0] = 0.0;
        prescribed.second[2][1] = -(data.second[0][1] * t40 + data.second[0][2] * t41);
        prescribed.second[2][2] = data.second[0][1] * t41 - data.second[0][2] * t40;
        prescribed.second[3][0] = 0.0;
        prescribed.second[3][1] = -(data.second[0][1] * t44 + data.second[0][2] * t46);
        prescribed.second[3][2] = data.second[0][1] * t46 - data.second[0][2] * t44;
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
    /// Joint `far_end`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_velocity(
        model: &super::Motor,
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
    }
    /// Joint `far_end`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_acceleration(
        model: &super::Motor,
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
    }
    /// Joint `far_end`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_far_end_referenced_jerk(
        model: &super::Motor,
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
        jacobian[1] = 0.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
        jacobian[6] = 0.0;
        jacobian[7] = 0.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 1.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 0.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
        jacobian[18] = 0.0;
        jacobian[19] = 0.0;
        jacobian[20] = 1.0;
        jacobian[21] = 0.0;
        jacobian[22] = 0.0;
        jacobian[23] = 0.0;
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
    }
    /// Joint `far_end`: what it prescribes, with three derivatives.
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
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = data.second[0][1];
        prescribed.second[0][2] = data.second[0][2];
        prescribed.second[1][0] = 0.0;
        prescribed.second[1][1] = 0.0;
        prescribed.second[1][2] = 0.0;
        prescribed.second[2][0] = 0.0;
        prescribed.second[2][1] = 0.0;
        prescribed.second[2][2] = 0.0;
        prescribed.second[3][0] = 0.0;
        prescribed.second[3][1] = 0.0;
        prescribed.second[3][2] = 0.0;
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
        let t24 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.speed / model.T_s * t24
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t26 = theta.cos();
        let t27 = theta.sin();
        rows[0] = q[0] - data.point[0];
        rows[1] = q[1] - (t26 * data.point[1] - t27 * data.point[2]);
        rows[2] = q[2] - (t27 * data.point[1] + t26 * data.point[2]);
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
        let t20 = model.speed / model.T_s;
        let t21 = (model.T_s / 6.283185307179586).powi(2);
        let t22 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t20 * (t * t / 2.0 + t21 * (t22.cos() - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t24 = (if t <= model.T_s {
            t20 * (t - t21 * (6.283185307179586 / model.T_s * t22.sin()))
        } else {
            model.speed
        });
        let t25 = theta.sin() * t24;
        let t26 = theta.cos() * t24;
        rows[0] = 0.0;
        rows[1] = data.point[1] * t25 + data.point[2] * t26;
        rows[2] = data.point[2] * t25 - data.point[1] * t26;
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
        let t20 = model.speed / model.T_s;
        let t21 = (model.T_s / 6.283185307179586).powi(2);
        let t22 = t * 6.283185307179586 / model.T_s;
        let t23 = t22.cos();
        let theta = (if t <= model.T_s {
            t20 * (t * t / 2.0 + t21 * (t23 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t25 = theta.cos();
        let t26 = theta.sin();
        let t27 = 6.283185307179586 / model.T_s;
        let t28 = (if t <= model.T_s {
            t20 * (t - t21 * (t27 * t22.sin()))
        } else {
            model.speed
        });
        let t29 = (if t <= model.T_s {
            t20 * (1.0 - t21 * (t27 * (t23 * t27)))
        } else {
            0.0
        });
        let t30 = t28 * (t25 * t28) + t26 * t29;
        let t31 = t25 * t29 - t28 * (t26 * t28);
        rows[0] = 0.0;
        rows[1] = data.point[1] * t30 + data.point[2] * t31;
        rows[2] = data.point[2] * t30 - data.point[1] * t31;
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
        let t20 = model.speed / model.T_s;
        let t21 = (model.T_s / 6.283185307179586).powi(2);
        let t22 = t * 6.283185307179586 / model.T_s;
        let t23 = t22.cos();
        let theta = (if t <= model.T_s {
            t20 * (t * t / 2.0 + t21 * (t23 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t25 = theta.cos();
        let t26 = theta.sin();
        let t27 = 6.283185307179586 / model.T_s;
        let t28 = t27 * t22.sin();
        let t29 = (if t <= model.T_s { t20 * (t - t21 * t28) } else { model.speed });
        let t30 = t26 * t29;
        let t31 = t25 * t29;
        let t32 = (if t <= model.T_s {
            t20 * (1.0 - t21 * (t27 * (t23 * t27)))
        } else {
            0.0
        });
        let t33 = (if t <= model.T_s { t20 * (t21 * (t27 * (t27 * t28))) } else { 0.0 });
        let t34 = t31 * t32;
        let t35 = t34 + t29 * (t25 * t32 - t29 * t30) + (t34 + t26 * t33);
        let t36 = t30 * t32;
        let t37 = t25 * t33 - t36 - (t36 + t29 * (t29 * t31 + t26 * t32));
        rows[0] = 0.0;
        rows[1] = data.point[1] * t35 + data.point[2] * t37;
        rows[2] = data.point[2] * t35 - data.point[1] * t37;
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
        jacobian[1] = 0.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
        jacobian[6] = 0.0;
        jacobian[7] = 0.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 1.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 0.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
        jacobian[18] = 0.0;
        jacobian[19] = 0.0;
        jacobian[20] = 1.0;
        jacobian[21] = 0.0;
        jacobian[22] = 0.0;
        jacobian[23] = 0.0;
        jacobian[24] = 0.0;
        jacobian[25] = 0.0;
        jacobian[26] = 0.0;
    }
    /// Joint `far_end`: what it prescribes, with three derivatives.
    ///
    /// Operations: 41 additions, 77 multiplications, 6 divisions, 4 function calls.
    pub fn joint_far_end_absolute_prescribed(
        model: &super::Motor,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t27 = model.speed / model.T_s;
        let t28 = (model.T_s / 6.283185307179586).powi(2);
        let t29 = t * 6.283185307179586 / model.T_s;
        let t30 = t29.cos();
        let theta = (if t <= model.T_s {
            t27 * (t * t / 2.0 + t28 * (t30 - 1.0))
        } else {
            model.speed * (t - model.T_s / 2.0)
        });
        let t32 = theta.cos();
        let t33 = theta.sin();
        let t34 = 6.283185307179586 / model.T_s;
        let t35 = t34 * t29.sin();
        let t36 = (if t <= model.T_s { t27 * (t - t28 * t35) } else { model.speed });
        let t37 = t33 * t36;
        let t38 = t32 * t36;
        let t39 = (if t <= model.T_s {
            t27 * (1.0 - t28 * (t34 * (t30 * t34)))
        } else {
            0.0
        });
        let t40 = t36 * t38 + t33 * t39;
        let t41 = t32 * t39 - t36 * t37;
        let t42 = (if t <= model.T_s { t27 * (t28 * (t34 * (t34 * t35))) } else { 0.0 });
        let t43 = t38 * t39;
        let t44 = t43 + t36 * t41 + (t43 + t33 * t42);
        let t45 = t37 * t39;
        let t46 = t32 * t42 - t45 - (t45 + t36 * t40);
        prescribed.position[0][0] = data.point[0];
        prescribed.position[0][1] = t32 * data.point[1] - t33 * data.point[2];
        prescribed.position[0][2] = t33 * data.point[1] + t32 * data.point[2];
        prescribed.position[1][0] = 0.0;
        prescribed.position[1][1] = -(data.point[1] * t37 + data.point[2] * t38);
        prescribed.position[1][2] = data.point[1] * t38 - data.point[2] * t37;
        prescribed.position[2][0] = 0.0;
        prescribed.position[2][1] = -(data.point[1] * t40 + data.point[2] * t41);
        prescribed.position[2][2] = data.point[1] * t41 - data.point[2] * t40;
        prescribed.position[3][0] = 0.0;
        prescribed.position[3][1] = -(data.point[1] * t44 + data.point[2] * t46);
        prescribed.position[3][2] = data.point[1] * t46 - data.point[2] * t44;
        prescribed.slope[0][0] = data.tangent[0];
        prescribed.slope[0][1] = t32 * data.tangent[1] - t33 * data.tangent[2];
        prescribed.slope[0][2] = t33 * data.tangent[1] + t32 * data.tangent[2];
        prescribed.slope[1][0] = 0.0;
        prescribed.slope[1][1] = -(data.tangent[1] * t37 + data.tangent[2] * t38);
        prescribed.slope[1][2] = data.tangent[1] * t38 - data.tangent[2] * t37;
        prescribed.slope[2][0] = 0.0;
        prescribed.slope[2][1] = -(data.tangent[1] * t40 + data.tangent[2] * t41);
        prescribed.slope[2][2] = data.tangent[1] * t41 - data.tangent[2] * t40;
        prescribed.slope[3][0] = 0.0;
        prescribed.slope[3][1] = -(data.tangent[1] * t44 + data.tangent[2] * t46);
        prescribed.slope[3][2] = data.tangent[1] * t46 - data.tangent[2] * t44;
        prescribed.second[0][0] = data.second[0][0];
        prescribed.second[0][1] = t32 * data.second[0][1] - t33 * data.second[0][2];
        prescribed.second[0][2] = t33 * data.second[0][1] + t32 * data.second[0][2];
        prescribed.second[1][0] = 0.0;
        prescribed.second[1][1] = -(data.second[0][1] * t37 + data.second[0][2] * t38);
        prescribed.second[1][2] = data.second[0][1] * t38 - data.second[0][2] * t37;
        prescribed.second[2][0] = 0.0;
        prescribed.second[2][1] = -(data.second[0][1] * t40 + data.second[0][2] * t41);
        prescribed.second[2][2] = data.second[0][1] * t41 - data.second[0][2] * t40;
        prescribed.second[3][0] = 0.0;
        prescribed.second[3][1] = -(data.second[0][1] * t44 + data.second[0][2] * t46);
        prescribed.second[3][2] = data.second[0][1] * t46 - data.second[0][2] * t44;
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
                    mean_axes: false,
                },
            ])
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
        fn loads(&self) -> ::std::vec::Vec<::rncf::mesh::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([])
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
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
            frame_rotor(&self.model, t, &mut motions[1]);
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
            beam_spatial_damped_mass(&self.row_shaft, ::rncf::mesh::array_mut(mass));
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
            let [q, v, a]: [&[f64; 30]; 3] = [q, v, a].map(::rncf::mesh::array);
            let force = ::rncf::mesh::array_mut(force);
            beam_spatial_damped_elastic_force(&self.row_shaft, q, v, force);
            if absolute {
                beam_spatial_damped_absolute_inertia_force(
                    &self.row_shaft,
                    frame,
                    a,
                    force,
                );
            } else {
                beam_spatial_damped_inertia_force(
                    &self.row_shaft,
                    frame,
                    q,
                    v,
                    a,
                    force,
                );
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
            let [q, v]: [&[f64; 30]; 2] = [q, v].map(::rncf::mesh::array);
            let stiffness = ::rncf::mesh::array_mut(stiffness);
            let damping_matrix = ::rncf::mesh::array_mut(damping);
            beam_spatial_damped_elastic_tangent(
                &self.row_shaft,
                q,
                v,
                stiffness,
                damping_matrix,
            );
            if !absolute {
                beam_spatial_damped_inertia_tangent(
                    &self.row_shaft,
                    frame,
                    stiffness,
                    damping_matrix,
                );
            }
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
                (::rncf::mesh::Interpolant::Position, 2) => {
                    beam_spatial_damped_shapes_position_2(
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
                (::rncf::mesh::Interpolant::SectionY, 2) => {
                    beam_spatial_damped_shapes_section_y_2(
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
                (::rncf::mesh::Interpolant::SectionZ, 2) => {
                    beam_spatial_damped_shapes_section_z_2(
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_drive_end_referenced_velocity(
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
                            joint_drive_end_referenced_acceleration(
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
                            joint_drive_end_referenced_jerk(
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_far_end_referenced_velocity(
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
                            joint_far_end_referenced_acceleration(
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
                            joint_far_end_referenced_jerk(
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
        fn fixture_force(
            &self,
            dimension: usize,
            vectors: usize,
            constants: [f64; 10],
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            force: &mut [f64],
        ) {
            match (dimension, vectors) {
                (3, 4) => {
                    if absolute {
                        fixture_spatial_section_absolute_inertia_force(
                            constants,
                            frame,
                            ::rncf::mesh::array(a),
                            ::rncf::mesh::array_mut(force),
                        );
                    } else {
                        fixture_spatial_section_inertia_force(
                            constants,
                            frame,
                            ::rncf::mesh::array(q),
                            ::rncf::mesh::array(v),
                            ::rncf::mesh::array(a),
                            ::rncf::mesh::array_mut(force),
                        );
                    }
                }
                _ => {}
            }
        }
        fn fixture_tangent(
            &self,
            dimension: usize,
            vectors: usize,
            constants: [f64; 10],
            absolute: bool,
            frame: &::rncf::mesh::FrameAction,
            stiffness: &mut [f64],
            damping: &mut [f64],
        ) {
            match (dimension, vectors) {
                (3, 4) => {
                    if !absolute {
                        fixture_spatial_section_inertia_tangent(
                            constants,
                            frame,
                            ::rncf::mesh::array_mut(stiffness),
                            ::rncf::mesh::array_mut(damping),
                        );
                    }
                }
                _ => {}
            }
        }
    }
}
