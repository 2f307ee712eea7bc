//! Expansion of `models/src/right_angle_frame.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// Right-angle frame under a dead load at its free end: it buckles out of its plane, with bending and torsion.
#[derive(Clone, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct RightAngleFrame {
    /// Load at the free end along the first leg; positive pulls. (SI; declared in N)
    pub load: f64,
    /// Load normal to the frame that starts the deflection. (SI; declared in N)
    pub disturbance: f64,
    /// Number of elements of a leg. (count)
    pub elements: usize,
}
#[allow(clippy::all)]
impl Default for RightAngleFrame {
    fn default() -> Self {
        Self {
            load: 1.0,
            disturbance: 0.0,
            elements: 8,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for RightAngleFrame {
    const NAME: &'static str = "RightAngleFrame";
    const DOC: &'static str = "Right-angle frame under a dead load at its free end: it buckles out of its plane, with bending and torsion.";
    const SOURCE: &'static str = r#"pub model RightAngleFrame {
    /// Load at the free end along the first leg; positive pulls.
    param load = 1 N;
    /// Load normal to the frame that starts the deflection.
    param disturbance = 0 N;
    /// Number of elements of a leg.
    param elements: count = 8;

    const leg = 0.24 m;

    material aluminium { density = 2700 kg/m^3; young = 71.24 GPa; poisson = 0.31; }
    section strip = rectangle(y = 30 mm, z = 0.6 mm);

    body first {
        spatial;
        line from [0, 0, 0] m to [leg, 0, 0];
        mesh elements * beam(strip, aluminium);
    }
    body second {
        spatial;
        line from [leg, 0 m, 0 m] to [leg, leg, 0 m];
        mesh elements * beam(strip, aluminium);
    }
    joint root = clamp(first.start, inertial);
    joint corner = weld(first.end, second.start);
    load push = force(second.end, [load, 0 N, disturbance], in = inertial);

    /// Displacement of the free end along the load.
    output x = second.end.x - leg;
    /// Displacement of the free end along the second leg.
    output y = second.end.y - leg;
    /// Displacement of the free end out of the plane.
    output z = second.end.z;

    run { t_end = 1 s; every = 1 ms; }
}"#;
    const NOTES: &'static [&'static str] = &[
        "Body `first` uses `beam_spatial`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1221 and 9917).",
        "Body `first` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.",
        "Body `second` uses `beam_spatial`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1221 and 9917).",
        "Body `second` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame.",
        "Constraint `corner` (weld): 6 multipliers; gradient and second derivatives are derived.",
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "load",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 1.0,
                doc: "Load at the free end along the first leg; positive pulls.",
            },
            ::rncf::Param {
                name: "disturbance",
                kind: ::rncf::ParamKind::Quantity,
                unit: "N",
                unit_si: 1.0,
                dimension: [1, 1, -2, 0, 0, 0],
                default: 0.0,
                doc: "Load normal to the frame that starts the deflection.",
            },
            ::rncf::Param {
                name: "elements",
                kind: ::rncf::ParamKind::Count,
                unit: "1",
                unit_si: 1.0,
                dimension: [0, 0, 0, 0, 0, 0],
                default: 8.0,
                doc: "Number of elements of a leg.",
            },
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "x",
                unit: "m",
                components: &[],
                doc: "Displacement of the free end along the load.",
            },
            ::rncf::Output {
                name: "y",
                unit: "m",
                components: &[],
                doc: "Displacement of the free end along the second leg.",
            },
            ::rncf::Output {
                name: "z",
                unit: "m",
                components: &[],
                doc: "Displacement of the free end out of the plane.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.load,
            1 => self.disturbance,
            2 => self.elements as f64,
            _ => panic!("RightAngleFrame has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.load = value,
            1 => self.disturbance = value,
            2 => self.elements = value as usize,
            _ => panic!("RightAngleFrame has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
        };
        right_angle_frame_equations::run_defaults(self, &mut run);
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
        let equations = right_angle_frame_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
    }
}
/// Equations of [`RightAngleFrame`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod right_angle_frame_equations {
    /// Constants of one element `beam_spatial`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1221 and 9917).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatial {
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
    static BEAM_SPATIAL_VECTORS: ::rncf::mesh::Vectors<10, 3, 3, 3> = ::rncf::mesh::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Gauss rule with 3 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_POINTS3: ::rncf::mesh::Rule<3, 3, 3> = ::rncf::mesh::Rule {
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
    static BEAM_SPATIAL_POINTS3_STIFFNESS: ::rncf::mesh::Blocks<3, 9, 6> = BEAM_SPATIAL_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Gauss rule with 2 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_POINTS2: ::rncf::mesh::Rule<2, 5, 3> = ::rncf::mesh::Rule {
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
    static BEAM_SPATIAL_POINTS2_STIFFNESS: ::rncf::mesh::Blocks<2, 9, 15> = BEAM_SPATIAL_POINTS2
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
    /// Operations: 33 additions, 70 multiplications.
    pub fn beam_spatial_points3_force(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t29 = length * EA;
        let t30 = 0.5 * (t29 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)));
        let t31 = (a_x * b_x + a_y * b_y + a_z * b_z) * (length * kyGA);
        let t32 = (a_x * c_x + a_y * c_y + a_z * c_z) * (length * kzGA);
        let t33 = 0.5 * (t29 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)));
        let t34 = (b_x * c_x + b_y * c_y + b_z * c_z) * (length * GA);
        let t35 = 0.5 * (t29 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)));
        forces[0][0] = t30 * (a_x * 2.0) + b_x * t31 + c_x * t32;
        forces[0][1] = t30 * (a_y * 2.0) + b_y * t31 + c_y * t32;
        forces[0][2] = t30 * (a_z * 2.0) + b_z * t31 + c_z * t32;
        forces[1][0] = a_x * t31 + t33 * (b_x * 2.0) + c_x * t34;
        forces[1][1] = a_y * t31 + t33 * (b_y * 2.0) + c_y * t34;
        forces[1][2] = a_z * t31 + t33 * (b_z * 2.0) + c_z * t34;
        forces[2][0] = a_x * t32 + b_x * t34 + t35 * (c_x * 2.0);
        forces[2][1] = a_y * t32 + b_y * t34 + t35 * (c_y * 2.0);
        forces[2][2] = a_z * t32 + b_z * t34 + t35 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 69 additions, 156 multiplications.
    pub fn beam_spatial_points3_tangent(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t29 = length * EA;
        let t30 = length * kyGA;
        let t31 = length * kzGA;
        let t32 = length * GA;
        let t33 = 0.5 * (0.5 * t29);
        let t34 = 0.5 * (t29 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0)));
        let t35 = (a_x * b_x + a_y * b_y + a_z * b_z) * t30;
        let t36 = (a_x * c_x + a_y * c_y + a_z * c_z) * t31;
        let t37 = 0.5 * (t29 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0)));
        let t38 = (b_x * c_x + b_y * c_y + b_z * c_z) * t32;
        let t39 = 0.5 * (t29 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0)));
        let t40 = a_x * 2.0;
        let t41 = a_y * 2.0;
        let t42 = a_z * 2.0;
        let t43 = b_x * 2.0;
        let t44 = b_y * 2.0;
        let t45 = b_z * 2.0;
        let t46 = c_x * 2.0;
        let t47 = c_y * 2.0;
        let t48 = c_z * 2.0;
        let t49 = t33 * t41;
        let t50 = t33 * t42;
        let t51 = b_y * t30;
        let t52 = b_z * t30;
        let t53 = a_x * t30;
        let t54 = a_y * t30;
        let t55 = a_z * t30;
        let t56 = c_y * t31;
        let t57 = c_z * t31;
        let t58 = a_x * t31;
        let t59 = a_y * t31;
        let t60 = a_z * t31;
        let t61 = t33 * t44;
        let t62 = t33 * t45;
        let t63 = c_y * t32;
        let t64 = c_z * t32;
        let t65 = b_x * t32;
        let t66 = b_y * t32;
        let t67 = b_z * t32;
        let t68 = t33 * t47;
        let t69 = t33 * t48;
        let t70 = t40 * t49 + b_x * t51 + c_x * t56;
        let t71 = t40 * t50 + b_x * t52 + c_x * t57;
        let t72 = t41 * t50 + b_y * t52 + c_y * t57;
        let t73 = a_x * t54 + t43 * t61 + c_x * t63;
        let t74 = a_x * t55 + t43 * t62 + c_x * t64;
        let t75 = a_y * t55 + t44 * t62 + c_y * t64;
        let t76 = a_x * t59 + b_x * t66 + t46 * t68;
        let t77 = a_x * t60 + b_x * t67 + t46 * t69;
        let t78 = a_y * t60 + b_y * t67 + t47 * t69;
        let t79 = t34 * 2.0;
        let t80 = t40 * (t33 * t40) + b_x * (b_x * t30) + c_x * (c_x * t31) + t79;
        let t81 = t37 * 2.0;
        let t82 = t39 * 2.0;
        stiffness[0][0] = t80;
        stiffness[0][1] = t70;
        stiffness[0][2] = t71;
        stiffness[0][3] = t70;
        stiffness[0][4] = t41 * t49 + b_y * t51 + c_y * t56 + t79;
        stiffness[0][5] = t72;
        stiffness[0][6] = t71;
        stiffness[0][7] = t72;
        stiffness[0][8] = t42 * t50 + b_z * t52 + c_z * t57 + t79;
        stiffness[1][0] = t35 + b_x * t53;
        stiffness[1][1] = b_x * t54;
        stiffness[1][2] = b_x * t55;
        stiffness[1][3] = b_y * t53;
        stiffness[1][4] = t35 + b_y * t54;
        stiffness[1][5] = b_y * t55;
        stiffness[1][6] = b_z * t53;
        stiffness[1][7] = b_z * t54;
        stiffness[1][8] = t35 + b_z * t55;
        stiffness[2][0] = t36 + c_x * t58;
        stiffness[2][1] = c_x * t59;
        stiffness[2][2] = c_x * t60;
        stiffness[2][3] = c_y * t58;
        stiffness[2][4] = t36 + c_y * t59;
        stiffness[2][5] = c_y * t60;
        stiffness[2][6] = c_z * t58;
        stiffness[2][7] = c_z * t59;
        stiffness[2][8] = t36 + c_z * t60;
        stiffness[3][0] = a_x * t53 + t43 * (t33 * t43) + c_x * (c_x * t32) + t81;
        stiffness[3][1] = t73;
        stiffness[3][2] = t74;
        stiffness[3][3] = t73;
        stiffness[3][4] = a_y * t54 + t44 * t61 + c_y * t63 + t81;
        stiffness[3][5] = t75;
        stiffness[3][6] = t74;
        stiffness[3][7] = t75;
        stiffness[3][8] = a_z * t55 + t45 * t62 + c_z * t64 + t81;
        stiffness[4][0] = t38 + c_x * t65;
        stiffness[4][1] = c_x * t66;
        stiffness[4][2] = c_x * t67;
        stiffness[4][3] = c_y * t65;
        stiffness[4][4] = t38 + c_y * t66;
        stiffness[4][5] = c_y * t67;
        stiffness[4][6] = c_z * t65;
        stiffness[4][7] = c_z * t66;
        stiffness[4][8] = t38 + c_z * t67;
        stiffness[5][0] = a_x * t58 + b_x * t65 + t46 * (t33 * t46) + t82;
        stiffness[5][1] = t76;
        stiffness[5][2] = t77;
        stiffness[5][3] = t76;
        stiffness[5][4] = a_y * t59 + b_y * t66 + t47 * t68 + t82;
        stiffness[5][5] = t78;
        stiffness[5][6] = t77;
        stiffness[5][7] = t78;
        stiffness[5][8] = a_z * t60 + b_z * t67 + t48 * t69 + t82;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 20 additions, 41 multiplications.
    pub fn beam_spatial_points3_energy(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
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
    /// Operations: 34 additions, 79 multiplications, 1 divisions.
    pub fn beam_spatial_points2_force(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t43 = (a_x * db_x + a_y * db_y + a_z * db_z) * (length * EIz);
        let t44 = (a_x * dc_x + a_y * dc_y + a_z * dc_z) * (length * EIy);
        let t45 = (b_x * db_x + b_y * db_y + b_z * db_z) * (length * GIz);
        let t46 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t47 = length * GJ * (0.5 * t46);
        let t48 = -0.5 * t47;
        let t49 = 0.5 * t47;
        let t50 = (c_x * dc_x + c_y * dc_y + c_z * dc_z) * (length * GIy);
        forces[0][0] = db_x * t43 + dc_x * t44;
        forces[0][1] = db_y * t43 + dc_y * t44;
        forces[0][2] = db_z * t43 + dc_z * t44;
        forces[1][0] = db_x * t45 + dc_x * t48;
        forces[1][1] = db_y * t45 + dc_y * t48;
        forces[1][2] = db_z * t45 + dc_z * t48;
        forces[2][0] = db_x * t49 + dc_x * t50;
        forces[2][1] = db_y * t49 + dc_y * t50;
        forces[2][2] = db_z * t49 + dc_z * t50;
        forces[3][0] = inverse_length * (a_x * t43 + b_x * t45 + c_x * t49);
        forces[3][1] = inverse_length * (a_y * t43 + b_y * t45 + c_y * t49);
        forces[3][2] = inverse_length * (a_z * t43 + b_z * t45 + c_z * t49);
        forces[4][0] = inverse_length * (a_x * t44 + b_x * t48 + c_x * t50);
        forces[4][1] = inverse_length * (a_y * t44 + b_y * t48 + c_y * t50);
        forces[4][2] = inverse_length * (a_z * t44 + b_z * t48 + c_z * t50);
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 136 additions, 425 multiplications, 1 divisions.
    pub fn beam_spatial_points2_tangent(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z], [unit_db_x, unit_db_y,
        unit_db_z], [unit_dc_x, unit_dc_y, unit_dc_z]] = *fields;
        let inverse_length = 1.0 / length;
        let db_x = inverse_length * unit_db_x;
        let db_y = inverse_length * unit_db_y;
        let db_z = inverse_length * unit_db_z;
        let dc_x = inverse_length * unit_dc_x;
        let dc_y = inverse_length * unit_dc_y;
        let dc_z = inverse_length * unit_dc_z;
        let t43 = length * EIz;
        let t44 = length * EIy;
        let t45 = length * GJ;
        let t46 = 0.5 * t45;
        let t47 = length * GIz;
        let t48 = length * GIy;
        let t49 = t45 * (-0.5);
        let t50 = -0.5 * t49;
        let t51 = -0.5 * t46;
        let t52 = 0.5 * t49;
        let t53 = 0.5 * t46;
        let t54 = (a_x * db_x + a_y * db_y + a_z * db_z) * t43;
        let t55 = (a_x * dc_x + a_y * dc_y + a_z * dc_z) * t44;
        let t56 = (b_x * db_x + b_y * db_y + b_z * db_z) * t47;
        let t57 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t58 = t45 * (0.5 * t57);
        let t59 = -0.5 * t58;
        let t60 = 0.5 * t58;
        let t61 = (c_x * dc_x + c_y * dc_y + c_z * dc_z) * t48;
        let t62 = db_x * t43;
        let t63 = db_y * t43;
        let t64 = db_z * t43;
        let t65 = a_x * t43;
        let t66 = a_y * t43;
        let t67 = a_z * t43;
        let t68 = dc_x * t44;
        let t69 = dc_y * t44;
        let t70 = dc_z * t44;
        let t71 = a_x * t44;
        let t72 = a_y * t44;
        let t73 = a_z * t44;
        let t74 = db_x * t47;
        let t75 = db_y * t47;
        let t76 = db_z * t47;
        let t77 = b_x * t47;
        let t78 = b_y * t47;
        let t79 = b_z * t47;
        let t80 = dc_x * t50;
        let t81 = dc_y * t50;
        let t82 = dc_z * t50;
        let t83 = db_x * t51;
        let t84 = db_y * t51;
        let t85 = db_z * t51;
        let t86 = c_x * t51;
        let t87 = c_y * t51;
        let t88 = c_z * t51;
        let t89 = b_x * t50;
        let t90 = b_y * t50;
        let t91 = b_z * t50;
        let t92 = dc_x * t52;
        let t93 = dc_y * t52;
        let t94 = dc_z * t52;
        let t95 = db_x * t53;
        let t96 = db_y * t53;
        let t97 = db_z * t53;
        let t98 = c_x * t53;
        let t99 = c_y * t53;
        let t100 = c_z * t53;
        let t101 = b_x * t52;
        let t102 = b_y * t52;
        let t103 = b_z * t52;
        let t104 = dc_x * t48;
        let t105 = dc_y * t48;
        let t106 = dc_z * t48;
        let t107 = c_x * t48;
        let t108 = c_y * t48;
        let t109 = c_z * t48;
        let t110 = inverse_length * inverse_length;
        stiffness[0][0] = db_x * t62 + dc_x * t68;
        stiffness[0][1] = db_x * t63 + dc_x * t69;
        stiffness[0][2] = db_x * t64 + dc_x * t70;
        stiffness[0][3] = db_y * t62 + dc_y * t68;
        stiffness[0][4] = db_y * t63 + dc_y * t69;
        stiffness[0][5] = db_y * t64 + dc_y * t70;
        stiffness[0][6] = db_z * t62 + dc_z * t68;
        stiffness[0][7] = db_z * t63 + dc_z * t69;
        stiffness[0][8] = db_z * t64 + dc_z * t70;
        stiffness[1][0] = inverse_length * (t54 + db_x * t65);
        stiffness[1][1] = inverse_length * (db_x * t66);
        stiffness[1][2] = inverse_length * (db_x * t67);
        stiffness[1][3] = inverse_length * (db_y * t65);
        stiffness[1][4] = inverse_length * (t54 + db_y * t66);
        stiffness[1][5] = inverse_length * (db_y * t67);
        stiffness[1][6] = inverse_length * (db_z * t65);
        stiffness[1][7] = inverse_length * (db_z * t66);
        stiffness[1][8] = inverse_length * (t54 + db_z * t67);
        stiffness[2][0] = inverse_length * (t55 + dc_x * t71);
        stiffness[2][1] = inverse_length * (dc_x * t72);
        stiffness[2][2] = inverse_length * (dc_x * t73);
        stiffness[2][3] = inverse_length * (dc_y * t71);
        stiffness[2][4] = inverse_length * (t55 + dc_y * t72);
        stiffness[2][5] = inverse_length * (dc_y * t73);
        stiffness[2][6] = inverse_length * (dc_z * t71);
        stiffness[2][7] = inverse_length * (dc_z * t72);
        stiffness[2][8] = inverse_length * (t55 + dc_z * t73);
        stiffness[3][0] = db_x * t74 + dc_x * t80;
        stiffness[3][1] = db_x * t75 + dc_x * t81;
        stiffness[3][2] = db_x * t76 + dc_x * t82;
        stiffness[3][3] = db_y * t74 + dc_y * t80;
        stiffness[3][4] = db_y * t75 + dc_y * t81;
        stiffness[3][5] = db_y * t76 + dc_y * t82;
        stiffness[3][6] = db_z * t74 + dc_z * t80;
        stiffness[3][7] = db_z * t75 + dc_z * t81;
        stiffness[3][8] = db_z * t76 + dc_z * t82;
        stiffness[4][0] = inverse_length * (t56 + (db_x * t77 + dc_x * t86));
        stiffness[4][1] = inverse_length * (db_x * t78 + dc_x * t87);
        stiffness[4][2] = inverse_length * (db_x * t79 + dc_x * t88);
        stiffness[4][3] = inverse_length * (db_y * t77 + dc_y * t86);
        stiffness[4][4] = inverse_length * (t56 + (db_y * t78 + dc_y * t87));
        stiffness[4][5] = inverse_length * (db_y * t79 + dc_y * t88);
        stiffness[4][6] = inverse_length * (db_z * t77 + dc_z * t86);
        stiffness[4][7] = inverse_length * (db_z * t78 + dc_z * t87);
        stiffness[4][8] = inverse_length * (t56 + (db_z * t79 + dc_z * t88));
        stiffness[5][0] = inverse_length * (t56 + (b_x * t74 + c_x * t92));
        stiffness[5][1] = inverse_length * (b_x * t75 + c_x * t93);
        stiffness[5][2] = inverse_length * (b_x * t76 + c_x * t94);
        stiffness[5][3] = inverse_length * (b_y * t74 + c_y * t92);
        stiffness[5][4] = inverse_length * (t56 + (b_y * t75 + c_y * t93));
        stiffness[5][5] = inverse_length * (b_y * t76 + c_y * t94);
        stiffness[5][6] = inverse_length * (b_z * t74 + c_z * t92);
        stiffness[5][7] = inverse_length * (b_z * t75 + c_z * t93);
        stiffness[5][8] = inverse_length * (t56 + (b_z * t76 + c_z * t94));
        stiffness[6][0] = (a_x * t65 + b_x * t77 + c_x * t98) * t110;
        stiffness[6][1] = (a_x * t66 + b_x * t78 + c_x * t99) * t110;
        stiffness[6][2] = (a_x * t67 + b_x * t79 + c_x * t100) * t110;
        stiffness[6][3] = (a_y * t65 + b_y * t77 + c_y * t98) * t110;
        stiffness[6][4] = (a_y * t66 + b_y * t78 + c_y * t99) * t110;
        stiffness[6][5] = (a_y * t67 + b_y * t79 + c_y * t100) * t110;
        stiffness[6][6] = (a_z * t65 + b_z * t77 + c_z * t98) * t110;
        stiffness[6][7] = (a_z * t66 + b_z * t78 + c_z * t99) * t110;
        stiffness[6][8] = (a_z * t67 + b_z * t79 + c_z * t100) * t110;
        stiffness[7][0] = dc_x * t83;
        stiffness[7][1] = dc_x * t84;
        stiffness[7][2] = dc_x * t85;
        stiffness[7][3] = dc_y * t83;
        stiffness[7][4] = dc_y * t84;
        stiffness[7][5] = dc_y * t85;
        stiffness[7][6] = dc_z * t83;
        stiffness[7][7] = dc_z * t84;
        stiffness[7][8] = dc_z * t85;
        stiffness[8][0] = inverse_length * (t59 + dc_x * t89);
        stiffness[8][1] = inverse_length * (dc_x * t90);
        stiffness[8][2] = inverse_length * (dc_x * t91);
        stiffness[8][3] = inverse_length * (dc_y * t89);
        stiffness[8][4] = inverse_length * (t59 + dc_y * t90);
        stiffness[8][5] = inverse_length * (dc_y * t91);
        stiffness[8][6] = inverse_length * (dc_z * t89);
        stiffness[8][7] = inverse_length * (dc_z * t90);
        stiffness[8][8] = inverse_length * (t59 + dc_z * t91);
        stiffness[9][0] = inverse_length * (t60 + c_x * t95);
        stiffness[9][1] = inverse_length * (c_x * t96);
        stiffness[9][2] = inverse_length * (c_x * t97);
        stiffness[9][3] = inverse_length * (c_y * t95);
        stiffness[9][4] = inverse_length * (t60 + c_y * t96);
        stiffness[9][5] = inverse_length * (c_y * t97);
        stiffness[9][6] = inverse_length * (c_z * t95);
        stiffness[9][7] = inverse_length * (c_z * t96);
        stiffness[9][8] = inverse_length * (t60 + c_z * t97);
        stiffness[10][0] = c_x * t101 * t110;
        stiffness[10][1] = c_x * t102 * t110;
        stiffness[10][2] = c_x * t103 * t110;
        stiffness[10][3] = c_y * t101 * t110;
        stiffness[10][4] = c_y * t102 * t110;
        stiffness[10][5] = c_y * t103 * t110;
        stiffness[10][6] = c_z * t101 * t110;
        stiffness[10][7] = c_z * t102 * t110;
        stiffness[10][8] = c_z * t103 * t110;
        stiffness[11][0] = db_x * t95 + dc_x * t104;
        stiffness[11][1] = db_x * t96 + dc_x * t105;
        stiffness[11][2] = db_x * t97 + dc_x * t106;
        stiffness[11][3] = db_y * t95 + dc_y * t104;
        stiffness[11][4] = db_y * t96 + dc_y * t105;
        stiffness[11][5] = db_y * t97 + dc_y * t106;
        stiffness[11][6] = db_z * t95 + dc_z * t104;
        stiffness[11][7] = db_z * t96 + dc_z * t105;
        stiffness[11][8] = db_z * t97 + dc_z * t106;
        stiffness[12][0] = inverse_length * (t61 + (db_x * t101 + dc_x * t107));
        stiffness[12][1] = inverse_length * (db_x * t102 + dc_x * t108);
        stiffness[12][2] = inverse_length * (db_x * t103 + dc_x * t109);
        stiffness[12][3] = inverse_length * (db_y * t101 + dc_y * t107);
        stiffness[12][4] = inverse_length * (t61 + (db_y * t102 + dc_y * t108));
        stiffness[12][5] = inverse_length * (db_y * t103 + dc_y * t109);
        stiffness[12][6] = inverse_length * (db_z * t101 + dc_z * t107);
        stiffness[12][7] = inverse_length * (db_z * t102 + dc_z * t108);
        stiffness[12][8] = inverse_length * (t61 + (db_z * t103 + dc_z * t109));
        stiffness[13][0] = inverse_length * (t61 + (b_x * t83 + c_x * t104));
        stiffness[13][1] = inverse_length * (b_x * t84 + c_x * t105);
        stiffness[13][2] = inverse_length * (b_x * t85 + c_x * t106);
        stiffness[13][3] = inverse_length * (b_y * t83 + c_y * t104);
        stiffness[13][4] = inverse_length * (t61 + (b_y * t84 + c_y * t105));
        stiffness[13][5] = inverse_length * (b_y * t85 + c_y * t106);
        stiffness[13][6] = inverse_length * (b_z * t83 + c_z * t104);
        stiffness[13][7] = inverse_length * (b_z * t84 + c_z * t105);
        stiffness[13][8] = inverse_length * (t61 + (b_z * t85 + c_z * t106));
        stiffness[14][0] = (a_x * t71 + b_x * t89 + c_x * t107) * t110;
        stiffness[14][1] = (a_x * t72 + b_x * t90 + c_x * t108) * t110;
        stiffness[14][2] = (a_x * t73 + b_x * t91 + c_x * t109) * t110;
        stiffness[14][3] = (a_y * t71 + b_y * t89 + c_y * t107) * t110;
        stiffness[14][4] = (a_y * t72 + b_y * t90 + c_y * t108) * t110;
        stiffness[14][5] = (a_y * t73 + b_y * t91 + c_y * t109) * t110;
        stiffness[14][6] = (a_z * t71 + b_z * t89 + c_z * t107) * t110;
        stiffness[14][7] = (a_z * t72 + b_z * t90 + c_z * t108) * t110;
        stiffness[14][8] = (a_z * t73 + b_z * t91 + c_z * t109) * t110;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 17 additions, 45 multiplications, 1 divisions.
    pub fn beam_spatial_points2_energy(
        row: &BeamSpatial,
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
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
    /// Operations: 509 additions, 710 multiplications, 2 divisions.
    pub fn beam_spatial_elastic_force(
        row: &BeamSpatial,
        q: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_SPATIAL_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_points3_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_points2_force(
                    row,
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 4538 additions, 5377 multiplications, 2 divisions.
    pub fn beam_spatial_elastic_tangent(
        row: &BeamSpatial,
        q: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_POINTS3
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_points3_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_POINTS2
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_points2_tangent(
                    row,
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 270 additions, 389 multiplications, 2 divisions.
    pub fn beam_spatial_strain_energy(
        row: &BeamSpatial,
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_points3_energy(row, fields, &mut density);
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_points2_energy(row, fields, &mut density);
                        density
                    },
                );
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_mass(row: &BeamSpatial, mass: &mut [f64; 100]) {
        let BeamSpatial { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    /// Adds the inertia forces of one element in the inertial frame; e is minus gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 108 additions, 118 multiplications.
    pub fn beam_spatial_absolute_inertia_force(
        row: &BeamSpatial,
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let BeamSpatial { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    pub fn beam_spatial_shapes_position_0(
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
    pub fn beam_spatial_shapes_position_1(
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
    pub fn beam_spatial_shapes_position_2(
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
    pub fn beam_spatial_shapes_section_y_0(
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
    pub fn beam_spatial_shapes_section_y_1(
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
    pub fn beam_spatial_shapes_section_y_2(
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
    pub fn beam_spatial_shapes_section_z_0(
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
    pub fn beam_spatial_shapes_section_z_1(
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
    pub fn beam_spatial_shapes_section_z_2(
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
    /// Operations: 115 additions, 184 multiplications.
    pub fn beam_spatial_field_forces(
        row: &BeamSpatial,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatial { length, EA, kyGA, kzGA, GA, EIz, EIy, GJ, GIz, GIy, .. } = *row;
        let t54 = fields[6] * fields[9] + fields[7] * fields[10] + fields[8] * fields[11]
            - (fields[3] * fields[12] + fields[4] * fields[13] + fields[5] * fields[14]);
        let t55 = 0.5
            * (fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2]
                - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t56 = EA * t55;
        let t57 = 0.5
            * (fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5]
                - 1.0)
            - 0.5
                * (stress_free[3] * stress_free[3] + stress_free[4] * stress_free[4]
                    + stress_free[5] * stress_free[5] - 1.0);
        let t58 = EA * t57;
        let t59 = 0.5
            * (fields[6] * fields[6] + fields[7] * fields[7] + fields[8] * fields[8]
                - 1.0)
            - 0.5
                * (stress_free[6] * stress_free[6] + stress_free[7] * stress_free[7]
                    + stress_free[8] * stress_free[8] - 1.0);
        let t60 = EA * t59;
        let t61 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5]
            - (stress_free[0] * stress_free[3] + stress_free[1] * stress_free[4]
                + stress_free[2] * stress_free[5]);
        let t62 = kyGA * t61;
        let t63 = fields[0] * fields[6] + fields[1] * fields[7] + fields[2] * fields[8]
            - (stress_free[0] * stress_free[6] + stress_free[1] * stress_free[7]
                + stress_free[2] * stress_free[8]);
        let t64 = kzGA * t63;
        let t65 = fields[3] * fields[6] + fields[4] * fields[7] + fields[5] * fields[8]
            - (stress_free[3] * stress_free[6] + stress_free[4] * stress_free[7]
                + stress_free[5] * stress_free[8]);
        let t66 = GA * t65;
        let t67 = fields[0] * fields[9] + fields[1] * fields[10] + fields[2] * fields[11]
            - (stress_free[0] * stress_free[9] + stress_free[1] * stress_free[10]
                + stress_free[2] * stress_free[11]);
        let t68 = EIz * t67;
        let t69 = t56 * (0.5 * (fields[0] * 2.0)) + fields[3] * t62 + fields[6] * t64
            + fields[9] * t68;
        let t70 = t56 * (0.5 * (fields[1] * 2.0)) + fields[4] * t62 + fields[7] * t64
            + fields[10] * t68;
        let t71 = t56 * (0.5 * (fields[2] * 2.0)) + fields[5] * t62 + fields[8] * t64
            + fields[11] * t68;
        let t72 = fields[0] * fields[12] + fields[1] * fields[13]
            + fields[2] * fields[14]
            - (stress_free[0] * stress_free[12] + stress_free[1] * stress_free[13]
                + stress_free[2] * stress_free[14]);
        let t73 = EIy * t72;
        let t74 = stress_free[6] * stress_free[9] + stress_free[7] * stress_free[10]
            + stress_free[8] * stress_free[11]
            - (stress_free[3] * stress_free[12] + stress_free[4] * stress_free[13]
                + stress_free[5] * stress_free[14]);
        let t75 = GJ * (0.5 * t54 - 0.5 * t74);
        let t76 = t58 * (0.5 * (fields[3] * 2.0)) + fields[0] * t62 + fields[6] * t66
            - t75 * (fields[12] * 0.5);
        let t77 = t58 * (0.5 * (fields[4] * 2.0)) + fields[1] * t62 + fields[7] * t66
            - t75 * (fields[13] * 0.5);
        let t78 = t58 * (0.5 * (fields[5] * 2.0)) + fields[2] * t62 + fields[8] * t66
            - t75 * (fields[14] * 0.5);
        let t79 = t60 * (0.5 * (fields[6] * 2.0)) + fields[0] * t64 + fields[3] * t66
            + t75 * (fields[9] * 0.5);
        let t80 = t60 * (0.5 * (fields[7] * 2.0)) + fields[1] * t64 + fields[4] * t66
            + t75 * (fields[10] * 0.5);
        let t81 = t60 * (0.5 * (fields[8] * 2.0)) + fields[2] * t64 + fields[5] * t66
            + t75 * (fields[11] * 0.5);
        let t82 = fields[3] * fields[9] + fields[4] * fields[10] + fields[5] * fields[11]
            - (stress_free[3] * stress_free[9] + stress_free[4] * stress_free[10]
                + stress_free[5] * stress_free[11]);
        let t83 = GIz * t82;
        let t84 = fields[6] * fields[12] + fields[7] * fields[13]
            + fields[8] * fields[14]
            - (stress_free[6] * stress_free[12] + stress_free[7] * stress_free[13]
                + stress_free[8] * stress_free[14]);
        let t85 = GIy * t84;
        forces[0] = t69 + fields[12] * t73;
        forces[1] = t70 + fields[13] * t73;
        forces[2] = t71 + fields[14] * t73;
        forces[3] = t76 + fields[9] * t83;
        forces[4] = t77 + fields[10] * t83;
        forces[5] = t78 + fields[11] * t83;
        forces[6] = t79 + fields[12] * t85;
        forces[7] = t80 + fields[13] * t85;
        forces[8] = t81 + fields[14] * t85;
        forces[9] = fields[0] * t68 + t75 * (fields[6] * 0.5) + fields[3] * t83;
        forces[10] = fields[1] * t68 + t75 * (fields[7] * 0.5) + fields[4] * t83;
        forces[11] = fields[2] * t68 + t75 * (fields[8] * 0.5) + fields[5] * t83;
        forces[12] = fields[0] * t73 - t75 * (fields[3] * 0.5) + fields[6] * t85;
        forces[13] = fields[1] * t73 - t75 * (fields[4] * 0.5) + fields[7] * t85;
        forces[14] = fields[2] * t73 - t75 * (fields[5] * 0.5) + fields[8] * t85;
    }
    /// Load `push` in its frame's axes.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn load_push(model: &super::RightAngleFrame, t: f64, value: &mut [f64; 3]) {
        value[0] = model.load;
        value[1] = 0.0;
        value[2] = model.disturbance;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 11 additions, 12 multiplications.
    pub fn joint_root_absolute_position(
        model: &super::RightAngleFrame,
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
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_velocity(
        model: &super::RightAngleFrame,
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
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_acceleration(
        model: &super::RightAngleFrame,
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
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_jerk(
        model: &super::RightAngleFrame,
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
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_jacobian(
        model: &super::RightAngleFrame,
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
    /// Joint `root`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_absolute_prescribed(
        model: &super::RightAngleFrame,
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
    /// Constraint `corner` (weld): rows C(z, t).
    ///
    /// Of `corner`: `z[0]` a place on `first`; `z[1]` the y axis of a section of `first`; `z[2]` the z axis of a section of `first`; `z[3]` a place on `second`; `z[4]` the y axis of a section of `second`; `z[5]` the z axis of a section of `second`; `z[6]` components of a direction in a section of `second` at the start; `z[7]` components of a direction in a section of `second` at the start (inertial axes).
    ///
    /// * position x: `z[0][0][0] - z[3][0][0]`
    /// * position y: `z[0][0][1] - z[3][0][1]`
    /// * position z: `z[0][0][2] - z[3][0][2]`
    /// * direction 1
    /// * direction 2
    /// * direction 3
    ///
    /// Operations: 27 additions, 39 multiplications.
    pub fn constraint_position_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..8];
        let t39 = z[1][0][1] * z[2][0][2] - z[1][0][2] * z[2][0][1];
        let t40 = z[4][0][1] * z[5][0][2] - z[4][0][2] * z[5][0][1];
        let t41 = z[1][0][2] * z[2][0][0] - z[1][0][0] * z[2][0][2];
        let t42 = z[4][0][2] * z[5][0][0] - z[4][0][0] * z[5][0][2];
        let t43 = t39
            * (z[6][0][0] * t40 + z[4][0][0] * z[6][0][1] + z[5][0][0] * z[6][0][2])
            + t41
                * (z[6][0][0] * t42 + z[4][0][1] * z[6][0][1] + z[5][0][1] * z[6][0][2]);
        let t44 = z[1][0][0] * z[2][0][1] - z[1][0][1] * z[2][0][0];
        let t45 = z[4][0][0] * z[5][0][1] - z[4][0][1] * z[5][0][0];
        let t46 = z[7][0][0] * t40 + z[4][0][0] * z[7][0][1] + z[5][0][0] * z[7][0][2];
        let t47 = z[7][0][0] * t42 + z[4][0][1] * z[7][0][1] + z[5][0][1] * z[7][0][2];
        let t48 = z[7][0][0] * t45 + z[4][0][2] * z[7][0][1] + z[5][0][2] * z[7][0][2];
        rows[0] = z[0][0][0] - z[3][0][0];
        rows[1] = z[0][0][1] - z[3][0][1];
        rows[2] = z[0][0][2] - z[3][0][2];
        rows[3] = t43
            + t44
                * (z[6][0][0] * t45 + z[4][0][2] * z[6][0][1] + z[5][0][2] * z[6][0][2]);
        rows[4] = t39 * t46 + t41 * t47 + t44 * t48;
        rows[5] = z[1][0][0] * t46 + z[1][0][1] * t47 + z[1][0][2] * t48;
    }
    /// Constraint `corner` (weld): their rate dC/dt.
    ///
    /// Operations: 84 additions, 108 multiplications.
    pub fn constraint_velocity_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..8];
        let t57 = z[1][0][1] * z[2][0][2] - z[1][0][2] * z[2][0][1];
        let t58 = z[4][0][1] * z[5][0][2] - z[4][0][2] * z[5][0][1];
        let t59 = z[1][0][2] * z[2][0][0] - z[1][0][0] * z[2][0][2];
        let t60 = z[4][0][2] * z[5][0][0] - z[4][0][0] * z[5][0][2];
        let t61 = z[1][0][0] * z[2][0][1] - z[1][0][1] * z[2][0][0];
        let t62 = z[4][0][0] * z[5][0][1] - z[4][0][1] * z[5][0][0];
        let t63 = z[7][0][0] * t58 + z[4][0][0] * z[7][0][1] + z[5][0][0] * z[7][0][2];
        let t64 = z[7][0][0] * t60 + z[4][0][1] * z[7][0][1] + z[5][0][1] * z[7][0][2];
        let t65 = z[7][0][0] * t62 + z[4][0][2] * z[7][0][1] + z[5][0][2] * z[7][0][2];
        let t66 = z[2][0][2] * z[1][1][1] + z[1][0][1] * z[2][1][2]
            - (z[2][0][1] * z[1][1][2] + z[1][0][2] * z[2][1][1]);
        let t67 = z[5][0][2] * z[4][1][1] + z[4][0][1] * z[5][1][2]
            - (z[5][0][1] * z[4][1][2] + z[4][0][2] * z[5][1][1]);
        let t68 = z[6][1][0] * t58 + z[6][0][0] * t67
            + (z[6][0][1] * z[4][1][0] + z[4][0][0] * z[6][1][1])
            + (z[6][0][2] * z[5][1][0] + z[5][0][0] * z[6][1][2]);
        let t69 = z[2][0][0] * z[1][1][2] + z[1][0][2] * z[2][1][0]
            - (z[2][0][2] * z[1][1][0] + z[1][0][0] * z[2][1][2]);
        let t70 = z[5][0][0] * z[4][1][2] + z[4][0][2] * z[5][1][0]
            - (z[5][0][2] * z[4][1][0] + z[4][0][0] * z[5][1][2]);
        let t71 = z[6][1][0] * t60 + z[6][0][0] * t70
            + (z[6][0][1] * z[4][1][1] + z[4][0][1] * z[6][1][1])
            + (z[6][0][2] * z[5][1][1] + z[5][0][1] * z[6][1][2]);
        let t72 = (z[6][0][0] * t58 + z[4][0][0] * z[6][0][1] + z[5][0][0] * z[6][0][2])
            * t66 + t57 * t68
            + ((z[6][0][0] * t60 + z[4][0][1] * z[6][0][1] + z[5][0][1] * z[6][0][2])
                * t69 + t59 * t71);
        let t73 = z[2][0][1] * z[1][1][0] + z[1][0][0] * z[2][1][1]
            - (z[2][0][0] * z[1][1][1] + z[1][0][1] * z[2][1][0]);
        let t74 = z[5][0][1] * z[4][1][0] + z[4][0][0] * z[5][1][1]
            - (z[5][0][0] * z[4][1][1] + z[4][0][1] * z[5][1][0]);
        let t75 = z[6][1][0] * t62 + z[6][0][0] * t74
            + (z[6][0][1] * z[4][1][2] + z[4][0][2] * z[6][1][1])
            + (z[6][0][2] * z[5][1][2] + z[5][0][2] * z[6][1][2]);
        let t76 = t72
            + ((z[6][0][0] * t62 + z[4][0][2] * z[6][0][1] + z[5][0][2] * z[6][0][2])
                * t73 + t61 * t75);
        let t77 = z[7][1][0] * t58 + z[7][0][0] * t67
            + (z[7][0][1] * z[4][1][0] + z[4][0][0] * z[7][1][1])
            + (z[7][0][2] * z[5][1][0] + z[5][0][0] * z[7][1][2]);
        let t78 = z[7][1][0] * t60 + z[7][0][0] * t70
            + (z[7][0][1] * z[4][1][1] + z[4][0][1] * z[7][1][1])
            + (z[7][0][2] * z[5][1][1] + z[5][0][1] * z[7][1][2]);
        let t79 = z[7][1][0] * t62 + z[7][0][0] * t74
            + (z[7][0][1] * z[4][1][2] + z[4][0][2] * z[7][1][1])
            + (z[7][0][2] * z[5][1][2] + z[5][0][2] * z[7][1][2]);
        let t80 = t63 * t66 + t57 * t77 + (t64 * t69 + t59 * t78)
            + (t65 * t73 + t61 * t79);
        let t81 = z[1][1][0] * t63 + z[1][0][0] * t77
            + (z[1][1][1] * t64 + z[1][0][1] * t78)
            + (z[1][1][2] * t65 + z[1][0][2] * t79);
        rows[0] = z[0][1][0] - z[3][1][0];
        rows[1] = z[0][1][1] - z[3][1][1];
        rows[2] = z[0][1][2] - z[3][1][2];
        rows[3] = t76;
        rows[4] = t80;
        rows[5] = t81;
    }
    /// Constraint `corner` (weld): their second time derivative.
    ///
    /// Operations: 210 additions, 207 multiplications.
    pub fn constraint_acceleration_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..8];
        let t75 = z[1][0][1] * z[2][0][2] - z[1][0][2] * z[2][0][1];
        let t76 = z[4][0][1] * z[5][0][2] - z[4][0][2] * z[5][0][1];
        let t77 = z[1][0][2] * z[2][0][0] - z[1][0][0] * z[2][0][2];
        let t78 = z[4][0][2] * z[5][0][0] - z[4][0][0] * z[5][0][2];
        let t79 = z[1][0][0] * z[2][0][1] - z[1][0][1] * z[2][0][0];
        let t80 = z[4][0][0] * z[5][0][1] - z[4][0][1] * z[5][0][0];
        let t81 = z[7][0][0] * t76 + z[4][0][0] * z[7][0][1] + z[5][0][0] * z[7][0][2];
        let t82 = z[7][0][0] * t78 + z[4][0][1] * z[7][0][1] + z[5][0][1] * z[7][0][2];
        let t83 = z[7][0][0] * t80 + z[4][0][2] * z[7][0][1] + z[5][0][2] * z[7][0][2];
        let t84 = z[2][0][2] * z[1][1][1] + z[1][0][1] * z[2][1][2]
            - (z[2][0][1] * z[1][1][2] + z[1][0][2] * z[2][1][1]);
        let t85 = z[5][0][2] * z[4][1][1] + z[4][0][1] * z[5][1][2]
            - (z[5][0][1] * z[4][1][2] + z[4][0][2] * z[5][1][1]);
        let t86 = z[6][1][0] * t76 + z[6][0][0] * t85
            + (z[6][0][1] * z[4][1][0] + z[4][0][0] * z[6][1][1])
            + (z[6][0][2] * z[5][1][0] + z[5][0][0] * z[6][1][2]);
        let t87 = z[2][0][0] * z[1][1][2] + z[1][0][2] * z[2][1][0]
            - (z[2][0][2] * z[1][1][0] + z[1][0][0] * z[2][1][2]);
        let t88 = z[5][0][0] * z[4][1][2] + z[4][0][2] * z[5][1][0]
            - (z[5][0][2] * z[4][1][0] + z[4][0][0] * z[5][1][2]);
        let t89 = z[6][1][0] * t78 + z[6][0][0] * t88
            + (z[6][0][1] * z[4][1][1] + z[4][0][1] * z[6][1][1])
            + (z[6][0][2] * z[5][1][1] + z[5][0][1] * z[6][1][2]);
        let t90 = z[2][0][1] * z[1][1][0] + z[1][0][0] * z[2][1][1]
            - (z[2][0][0] * z[1][1][1] + z[1][0][1] * z[2][1][0]);
        let t91 = z[5][0][1] * z[4][1][0] + z[4][0][0] * z[5][1][1]
            - (z[5][0][0] * z[4][1][1] + z[4][0][1] * z[5][1][0]);
        let t92 = z[6][1][0] * t80 + z[6][0][0] * t91
            + (z[6][0][1] * z[4][1][2] + z[4][0][2] * z[6][1][1])
            + (z[6][0][2] * z[5][1][2] + z[5][0][2] * z[6][1][2]);
        let t93 = z[7][1][0] * t76 + z[7][0][0] * t85
            + (z[7][0][1] * z[4][1][0] + z[4][0][0] * z[7][1][1])
            + (z[7][0][2] * z[5][1][0] + z[5][0][0] * z[7][1][2]);
        let t94 = z[7][1][0] * t78 + z[7][0][0] * t88
            + (z[7][0][1] * z[4][1][1] + z[4][0][1] * z[7][1][1])
            + (z[7][0][2] * z[5][1][1] + z[5][0][1] * z[7][1][2]);
        let t95 = z[7][1][0] * t80 + z[7][0][0] * t91
            + (z[7][0][1] * z[4][1][2] + z[4][0][2] * z[7][1][1])
            + (z[7][0][2] * z[5][1][2] + z[5][0][2] * z[7][1][2]);
        let t96 = z[1][1][1] * z[2][1][2];
        let t97 = z[1][1][2] * z[2][1][1];
        let t98 = t96 + z[2][0][2] * z[1][2][1] + (t96 + z[1][0][1] * z[2][2][2])
            - (t97 + z[2][0][1] * z[1][2][2] + (t97 + z[1][0][2] * z[2][2][1]));
        let t99 = z[4][1][1] * z[5][1][2];
        let t100 = z[4][1][2] * z[5][1][1];
        let t101 = t99 + z[5][0][2] * z[4][2][1] + (t99 + z[4][0][1] * z[5][2][2])
            - (t100 + z[5][0][1] * z[4][2][2] + (t100 + z[4][0][2] * z[5][2][1]));
        let t102 = z[6][1][0] * t85;
        let t103 = z[4][1][0] * z[6][1][1];
        let t104 = z[6][2][0] * t76 + t102 + (t102 + z[6][0][0] * t101)
            + (t103 + z[6][0][1] * z[4][2][0] + (t103 + z[4][0][0] * z[6][2][1]));
        let t105 = z[5][1][0] * z[6][1][2];
        let t106 = t84 * t86;
        let t107 = t106
            + (z[6][0][0] * t76 + z[4][0][0] * z[6][0][1] + z[5][0][0] * z[6][0][2])
                * t98
            + (t106
                + t75
                    * (t104
                        + (t105 + z[6][0][2] * z[5][2][0]
                            + (t105 + z[5][0][0] * z[6][2][2]))));
        let t108 = z[1][1][2] * z[2][1][0];
        let t109 = z[1][1][0] * z[2][1][2];
        let t110 = t108 + z[2][0][0] * z[1][2][2] + (t108 + z[1][0][2] * z[2][2][0])
            - (t109 + z[2][0][2] * z[1][2][0] + (t109 + z[1][0][0] * z[2][2][2]));
        let t111 = z[4][1][2] * z[5][1][0];
        let t112 = z[4][1][0] * z[5][1][2];
        let t113 = t111 + z[5][0][0] * z[4][2][2] + (t111 + z[4][0][2] * z[5][2][0])
            - (t112 + z[5][0][2] * z[4][2][0] + (t112 + z[4][0][0] * z[5][2][2]));
        let t114 = z[6][1][0] * t88;
        let t115 = z[4][1][1] * z[6][1][1];
        let t116 = z[6][2][0] * t78 + t114 + (t114 + z[6][0][0] * t113)
            + (t115 + z[6][0][1] * z[4][2][1] + (t115 + z[4][0][1] * z[6][2][1]));
        let t117 = z[5][1][1] * z[6][1][2];
        let t118 = t87 * t89;
        let t119 = t118
            + (z[6][0][0] * t78 + z[4][0][1] * z[6][0][1] + z[5][0][1] * z[6][0][2])
                * t110
            + (t118
                + t77
                    * (t116
                        + (t117 + z[6][0][2] * z[5][2][1]
                            + (t117 + z[5][0][1] * z[6][2][2]))));
        let t120 = z[1][1][0] * z[2][1][1];
        let t121 = z[1][1][1] * z[2][1][0];
        let t122 = t120 + z[2][0][1] * z[1][2][0] + (t120 + z[1][0][0] * z[2][2][1])
            - (t121 + z[2][0][0] * z[1][2][1] + (t121 + z[1][0][1] * z[2][2][0]));
        let t123 = z[4][1][0] * z[5][1][1];
        let t124 = z[4][1][1] * z[5][1][0];
        let t125 = t123 + z[5][0][1] * z[4][2][0] + (t123 + z[4][0][0] * z[5][2][1])
            - (t124 + z[5][0][0] * z[4][2][1] + (t124 + z[4][0][1] * z[5][2][0]));
        let t126 = z[6][1][0] * t91;
        let t127 = z[4][1][2] * z[6][1][1];
        let t128 = z[6][2][0] * t80 + t126 + (t126 + z[6][0][0] * t125)
            + (t127 + z[6][0][1] * z[4][2][2] + (t127 + z[4][0][2] * z[6][2][1]));
        let t129 = z[5][1][2] * z[6][1][2];
        let t130 = t90 * t92;
        let t131 = t130
            + (z[6][0][0] * t80 + z[4][0][2] * z[6][0][1] + z[5][0][2] * z[6][0][2])
                * t122
            + (t130
                + t79
                    * (t128
                        + (t129 + z[6][0][2] * z[5][2][2]
                            + (t129 + z[5][0][2] * z[6][2][2]))));
        let t132 = z[7][1][0] * t85;
        let t133 = z[4][1][0] * z[7][1][1];
        let t134 = z[7][2][0] * t76 + t132 + (t132 + z[7][0][0] * t101)
            + (t133 + z[7][0][1] * z[4][2][0] + (t133 + z[4][0][0] * z[7][2][1]));
        let t135 = z[5][1][0] * z[7][1][2];
        let t136 = t134
            + (t135 + z[7][0][2] * z[5][2][0] + (t135 + z[5][0][0] * z[7][2][2]));
        let t137 = t84 * t93;
        let t138 = z[7][1][0] * t88;
        let t139 = z[4][1][1] * z[7][1][1];
        let t140 = z[7][2][0] * t78 + t138 + (t138 + z[7][0][0] * t113)
            + (t139 + z[7][0][1] * z[4][2][1] + (t139 + z[4][0][1] * z[7][2][1]));
        let t141 = z[5][1][1] * z[7][1][2];
        let t142 = t140
            + (t141 + z[7][0][2] * z[5][2][1] + (t141 + z[5][0][1] * z[7][2][2]));
        let t143 = t87 * t94;
        let t144 = t137 + t81 * t98 + (t137 + t75 * t136)
            + (t143 + t82 * t110 + (t143 + t77 * t142));
        let t145 = z[7][1][0] * t91;
        let t146 = z[4][1][2] * z[7][1][1];
        let t147 = z[7][2][0] * t80 + t145 + (t145 + z[7][0][0] * t125)
            + (t146 + z[7][0][1] * z[4][2][2] + (t146 + z[4][0][2] * z[7][2][1]));
        let t148 = z[5][1][2] * z[7][1][2];
        let t149 = t147
            + (t148 + z[7][0][2] * z[5][2][2] + (t148 + z[5][0][2] * z[7][2][2]));
        let t150 = t90 * t95;
        let t151 = z[1][1][0] * t93;
        let t152 = z[1][1][1] * t94;
        let t153 = z[1][2][0] * t81 + t151 + (t151 + z[1][0][0] * t136)
            + (z[1][2][1] * t82 + t152 + (t152 + z[1][0][1] * t142));
        let t154 = z[1][1][2] * t95;
        rows[0] = z[0][2][0] - z[3][2][0];
        rows[1] = z[0][2][1] - z[3][2][1];
        rows[2] = z[0][2][2] - z[3][2][2];
        rows[3] = t107 + t119 + t131;
        rows[4] = t144 + (t150 + t83 * t122 + (t150 + t79 * t149));
        rows[5] = t153 + (z[1][2][2] * t83 + t154 + (t154 + z[1][0][2] * t149));
    }
    /// Constraint `corner` (weld): their third time derivative.
    ///
    /// Operations: 435 additions, 336 multiplications.
    pub fn constraint_jerk_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..8];
        let t93 = z[1][0][1] * z[2][0][2] - z[1][0][2] * z[2][0][1];
        let t94 = z[4][0][1] * z[5][0][2] - z[4][0][2] * z[5][0][1];
        let t95 = z[1][0][2] * z[2][0][0] - z[1][0][0] * z[2][0][2];
        let t96 = z[4][0][2] * z[5][0][0] - z[4][0][0] * z[5][0][2];
        let t97 = z[1][0][0] * z[2][0][1] - z[1][0][1] * z[2][0][0];
        let t98 = z[4][0][0] * z[5][0][1] - z[4][0][1] * z[5][0][0];
        let t99 = z[7][0][0] * t94 + z[4][0][0] * z[7][0][1] + z[5][0][0] * z[7][0][2];
        let t100 = z[7][0][0] * t96 + z[4][0][1] * z[7][0][1] + z[5][0][1] * z[7][0][2];
        let t101 = z[7][0][0] * t98 + z[4][0][2] * z[7][0][1] + z[5][0][2] * z[7][0][2];
        let t102 = z[2][0][2] * z[1][1][1] + z[1][0][1] * z[2][1][2]
            - (z[2][0][1] * z[1][1][2] + z[1][0][2] * z[2][1][1]);
        let t103 = z[5][0][2] * z[4][1][1] + z[4][0][1] * z[5][1][2]
            - (z[5][0][1] * z[4][1][2] + z[4][0][2] * z[5][1][1]);
        let t104 = z[6][1][0] * t94 + z[6][0][0] * t103
            + (z[6][0][1] * z[4][1][0] + z[4][0][0] * z[6][1][1])
            + (z[6][0][2] * z[5][1][0] + z[5][0][0] * z[6][1][2]);
        let t105 = z[2][0][0] * z[1][1][2] + z[1][0][2] * z[2][1][0]
            - (z[2][0][2] * z[1][1][0] + z[1][0][0] * z[2][1][2]);
        let t106 = z[5][0][0] * z[4][1][2] + z[4][0][2] * z[5][1][0]
            - (z[5][0][2] * z[4][1][0] + z[4][0][0] * z[5][1][2]);
        let t107 = z[6][1][0] * t96 + z[6][0][0] * t106
            + (z[6][0][1] * z[4][1][1] + z[4][0][1] * z[6][1][1])
            + (z[6][0][2] * z[5][1][1] + z[5][0][1] * z[6][1][2]);
        let t108 = z[2][0][1] * z[1][1][0] + z[1][0][0] * z[2][1][1]
            - (z[2][0][0] * z[1][1][1] + z[1][0][1] * z[2][1][0]);
        let t109 = z[5][0][1] * z[4][1][0] + z[4][0][0] * z[5][1][1]
            - (z[5][0][0] * z[4][1][1] + z[4][0][1] * z[5][1][0]);
        let t110 = z[6][1][0] * t98 + z[6][0][0] * t109
            + (z[6][0][1] * z[4][1][2] + z[4][0][2] * z[6][1][1])
            + (z[6][0][2] * z[5][1][2] + z[5][0][2] * z[6][1][2]);
        let t111 = z[7][1][0] * t94 + z[7][0][0] * t103
            + (z[7][0][1] * z[4][1][0] + z[4][0][0] * z[7][1][1])
            + (z[7][0][2] * z[5][1][0] + z[5][0][0] * z[7][1][2]);
        let t112 = z[7][1][0] * t96 + z[7][0][0] * t106
            + (z[7][0][1] * z[4][1][1] + z[4][0][1] * z[7][1][1])
            + (z[7][0][2] * z[5][1][1] + z[5][0][1] * z[7][1][2]);
        let t113 = z[7][1][0] * t98 + z[7][0][0] * t109
            + (z[7][0][1] * z[4][1][2] + z[4][0][2] * z[7][1][1])
            + (z[7][0][2] * z[5][1][2] + z[5][0][2] * z[7][1][2]);
        let t114 = z[1][1][1] * z[2][1][2];
        let t115 = z[1][1][2] * z[2][1][1];
        let t116 = t114 + z[2][0][2] * z[1][2][1] + (t114 + z[1][0][1] * z[2][2][2])
            - (t115 + z[2][0][1] * z[1][2][2] + (t115 + z[1][0][2] * z[2][2][1]));
        let t117 = z[4][1][1] * z[5][1][2];
        let t118 = z[4][1][2] * z[5][1][1];
        let t119 = t117 + z[5][0][2] * z[4][2][1] + (t117 + z[4][0][1] * z[5][2][2])
            - (t118 + z[5][0][1] * z[4][2][2] + (t118 + z[4][0][2] * z[5][2][1]));
        let t120 = z[6][1][0] * t103;
        let t121 = z[4][1][0] * z[6][1][1];
        let t122 = z[6][2][0] * t94 + t120 + (t120 + z[6][0][0] * t119)
            + (t121 + z[6][0][1] * z[4][2][0] + (t121 + z[4][0][0] * z[6][2][1]));
        let t123 = z[5][1][0] * z[6][1][2];
        let t124 = z[1][1][2] * z[2][1][0];
        let t125 = z[1][1][0] * z[2][1][2];
        let t126 = t124 + z[2][0][0] * z[1][2][2] + (t124 + z[1][0][2] * z[2][2][0])
            - (t125 + z[2][0][2] * z[1][2][0] + (t125 + z[1][0][0] * z[2][2][2]));
        let t127 = z[4][1][2] * z[5][1][0];
        let t128 = z[4][1][0] * z[5][1][2];
        let t129 = t127 + z[5][0][0] * z[4][2][2] + (t127 + z[4][0][2] * z[5][2][0])
            - (t128 + z[5][0][2] * z[4][2][0] + (t128 + z[4][0][0] * z[5][2][2]));
        let t130 = z[6][1][0] * t106;
        let t131 = z[4][1][1] * z[6][1][1];
        let t132 = z[6][2][0] * t96 + t130 + (t130 + z[6][0][0] * t129)
            + (t131 + z[6][0][1] * z[4][2][1] + (t131 + z[4][0][1] * z[6][2][1]));
        let t133 = z[5][1][1] * z[6][1][2];
        let t134 = z[1][1][0] * z[2][1][1];
        let t135 = z[1][1][1] * z[2][1][0];
        let t136 = t134 + z[2][0][1] * z[1][2][0] + (t134 + z[1][0][0] * z[2][2][1])
            - (t135 + z[2][0][0] * z[1][2][1] + (t135 + z[1][0][1] * z[2][2][0]));
        let t137 = z[4][1][0] * z[5][1][1];
        let t138 = z[4][1][1] * z[5][1][0];
        let t139 = t137 + z[5][0][1] * z[4][2][0] + (t137 + z[4][0][0] * z[5][2][1])
            - (t138 + z[5][0][0] * z[4][2][1] + (t138 + z[4][0][1] * z[5][2][0]));
        let t140 = z[6][1][0] * t109;
        let t141 = z[4][1][2] * z[6][1][1];
        let t142 = z[6][2][0] * t98 + t140 + (t140 + z[6][0][0] * t139)
            + (t141 + z[6][0][1] * z[4][2][2] + (t141 + z[4][0][2] * z[6][2][1]));
        let t143 = z[5][1][2] * z[6][1][2];
        let t144 = z[7][1][0] * t103;
        let t145 = z[4][1][0] * z[7][1][1];
        let t146 = z[7][2][0] * t94 + t144 + (t144 + z[7][0][0] * t119)
            + (t145 + z[7][0][1] * z[4][2][0] + (t145 + z[4][0][0] * z[7][2][1]));
        let t147 = z[5][1][0] * z[7][1][2];
        let t148 = t146
            + (t147 + z[7][0][2] * z[5][2][0] + (t147 + z[5][0][0] * z[7][2][2]));
        let t149 = z[7][1][0] * t106;
        let t150 = z[4][1][1] * z[7][1][1];
        let t151 = z[7][2][0] * t96 + t149 + (t149 + z[7][0][0] * t129)
            + (t150 + z[7][0][1] * z[4][2][1] + (t150 + z[4][0][1] * z[7][2][1]));
        let t152 = z[5][1][1] * z[7][1][2];
        let t153 = t151
            + (t152 + z[7][0][2] * z[5][2][1] + (t152 + z[5][0][1] * z[7][2][2]));
        let t154 = z[7][1][0] * t109;
        let t155 = z[4][1][2] * z[7][1][1];
        let t156 = z[7][2][0] * t98 + t154 + (t154 + z[7][0][0] * t139)
            + (t155 + z[7][0][1] * z[4][2][2] + (t155 + z[4][0][2] * z[7][2][1]));
        let t157 = z[5][1][2] * z[7][1][2];
        let t158 = t156
            + (t157 + z[7][0][2] * z[5][2][2] + (t157 + z[5][0][2] * z[7][2][2]));
        let t159 = z[2][1][2] * z[1][2][1];
        let t160 = z[1][1][1] * z[2][2][2];
        let t161 = t159 + t160;
        let t162 = z[2][1][1] * z[1][2][2];
        let t163 = z[1][1][2] * z[2][2][1];
        let t164 = t162 + t163;
        let t165 = t161 + (t159 + z[2][0][2] * z[1][3][1])
            + (t161 + (t160 + z[1][0][1] * z[2][3][2]))
            - (t164 + (t162 + z[2][0][1] * z[1][3][2])
                + (t164 + (t163 + z[1][0][2] * z[2][3][1])));
        let t166 = z[5][1][2] * z[4][2][1];
        let t167 = z[4][1][1] * z[5][2][2];
        let t168 = t166 + t167;
        let t169 = z[5][1][1] * z[4][2][2];
        let t170 = z[4][1][2] * z[5][2][1];
        let t171 = t169 + t170;
        let t172 = t168 + (t166 + z[5][0][2] * z[4][3][1])
            + (t168 + (t167 + z[4][0][1] * z[5][3][2]))
            - (t171 + (t169 + z[5][0][1] * z[4][3][2])
                + (t171 + (t170 + z[4][0][2] * z[5][3][1])));
        let t173 = z[6][2][0] * t103;
        let t174 = z[6][1][0] * t119;
        let t175 = t173 + t174;
        let t176 = z[6][1][1] * z[4][2][0];
        let t177 = z[4][1][0] * z[6][2][1];
        let t178 = t176 + t177;
        let t179 = z[6][3][0] * t94 + t173 + t175 + (t175 + (t174 + z[6][0][0] * t172))
            + (t178 + (t176 + z[6][0][1] * z[4][3][0])
                + (t178 + (t177 + z[4][0][0] * z[6][3][1])));
        let t180 = z[6][1][2] * z[5][2][0];
        let t181 = z[5][1][0] * z[6][2][2];
        let t182 = t180 + t181;
        let t183 = t104 * t116;
        let t184 = t102
            * (t122
                + (t123 + z[6][0][2] * z[5][2][0] + (t123 + z[5][0][0] * z[6][2][2])));
        let t185 = t183 + t184;
        let t186 = t93
            * (t179
                + (t182 + (t180 + z[6][0][2] * z[5][3][0])
                    + (t182 + (t181 + z[5][0][0] * z[6][3][2]))));
        let t187 = t185
            + (t183
                + (z[6][0][0] * t94 + z[4][0][0] * z[6][0][1] + z[5][0][0] * z[6][0][2])
                    * t165) + (t185 + (t184 + t186));
        let t188 = z[2][1][0] * z[1][2][2];
        let t189 = z[1][1][2] * z[2][2][0];
        let t190 = t188 + t189;
        let t191 = z[2][1][2] * z[1][2][0];
        let t192 = z[1][1][0] * z[2][2][2];
        let t193 = t191 + t192;
        let t194 = t190 + (t188 + z[2][0][0] * z[1][3][2])
            + (t190 + (t189 + z[1][0][2] * z[2][3][0]))
            - (t193 + (t191 + z[2][0][2] * z[1][3][0])
                + (t193 + (t192 + z[1][0][0] * z[2][3][2])));
        let t195 = z[5][1][0] * z[4][2][2];
        let t196 = z[4][1][2] * z[5][2][0];
        let t197 = t195 + t196;
        let t198 = z[5][1][2] * z[4][2][0];
        let t199 = z[4][1][0] * z[5][2][2];
        let t200 = t198 + t199;
        let t201 = t197 + (t195 + z[5][0][0] * z[4][3][2])
            + (t197 + (t196 + z[4][0][2] * z[5][3][0]))
            - (t200 + (t198 + z[5][0][2] * z[4][3][0])
                + (t200 + (t199 + z[4][0][0] * z[5][3][2])));
        let t202 = z[6][2][0] * t106;
        let t203 = z[6][1][0] * t129;
        let t204 = t202 + t203;
        let t205 = z[6][1][1] * z[4][2][1];
        let t206 = z[4][1][1] * z[6][2][1];
        let t207 = t205 + t206;
        let t208 = z[6][3][0] * t96 + t202 + t204 + (t204 + (t203 + z[6][0][0] * t201))
            + (t207 + (t205 + z[6][0][1] * z[4][3][1])
                + (t207 + (t206 + z[4][0][1] * z[6][3][1])));
        let t209 = z[6][1][2] * z[5][2][1];
        let t210 = z[5][1][1] * z[6][2][2];
        let t211 = t209 + t210;
        let t212 = t107 * t126;
        let t213 = t105
            * (t132
                + (t133 + z[6][0][2] * z[5][2][1] + (t133 + z[5][0][1] * z[6][2][2])));
        let t214 = t212 + t213;
        let t215 = t95
            * (t208
                + (t211 + (t209 + z[6][0][2] * z[5][3][1])
                    + (t211 + (t210 + z[5][0][1] * z[6][3][2]))));
        let t216 = t214
            + (t212
                + (z[6][0][0] * t96 + z[4][0][1] * z[6][0][1] + z[5][0][1] * z[6][0][2])
                    * t194) + (t214 + (t213 + t215));
        let t217 = z[2][1][1] * z[1][2][0];
        let t218 = z[1][1][0] * z[2][2][1];
        let t219 = t217 + t218;
        let t220 = z[2][1][0] * z[1][2][1];
        let t221 = z[1][1][1] * z[2][2][0];
        let t222 = t220 + t221;
        let t223 = t219 + (t217 + z[2][0][1] * z[1][3][0])
            + (t219 + (t218 + z[1][0][0] * z[2][3][1]))
            - (t222 + (t220 + z[2][0][0] * z[1][3][1])
                + (t222 + (t221 + z[1][0][1] * z[2][3][0])));
        let t224 = z[5][1][1] * z[4][2][0];
        let t225 = z[4][1][0] * z[5][2][1];
        let t226 = t224 + t225;
        let t227 = z[5][1][0] * z[4][2][1];
        let t228 = z[4][1][1] * z[5][2][0];
        let t229 = t227 + t228;
        let t230 = t226 + (t224 + z[5][0][1] * z[4][3][0])
            + (t226 + (t225 + z[4][0][0] * z[5][3][1]))
            - (t229 + (t227 + z[5][0][0] * z[4][3][1])
                + (t229 + (t228 + z[4][0][1] * z[5][3][0])));
        let t231 = z[6][2][0] * t109;
        let t232 = z[6][1][0] * t139;
        let t233 = t231 + t232;
        let t234 = z[6][1][1] * z[4][2][2];
        let t235 = z[4][1][2] * z[6][2][1];
        let t236 = t234 + t235;
        let t237 = z[6][3][0] * t98 + t231 + t233 + (t233 + (t232 + z[6][0][0] * t230))
            + (t236 + (t234 + z[6][0][1] * z[4][3][2])
                + (t236 + (t235 + z[4][0][2] * z[6][3][1])));
        let t238 = z[6][1][2] * z[5][2][2];
        let t239 = z[5][1][2] * z[6][2][2];
        let t240 = t238 + t239;
        let t241 = t110 * t136;
        let t242 = t108
            * (t142
                + (t143 + z[6][0][2] * z[5][2][2] + (t143 + z[5][0][2] * z[6][2][2])));
        let t243 = t241 + t242;
        let t244 = t97
            * (t237
                + (t240 + (t238 + z[6][0][2] * z[5][3][2])
                    + (t240 + (t239 + z[5][0][2] * z[6][3][2]))));
        let t245 = t243
            + (t241
                + (z[6][0][0] * t98 + z[4][0][2] * z[6][0][1] + z[5][0][2] * z[6][0][2])
                    * t223) + (t243 + (t242 + t244));
        let t246 = z[7][2][0] * t103;
        let t247 = z[7][1][0] * t119;
        let t248 = t246 + t247;
        let t249 = z[7][1][1] * z[4][2][0];
        let t250 = z[4][1][0] * z[7][2][1];
        let t251 = t249 + t250;
        let t252 = z[7][3][0] * t94 + t246 + t248 + (t248 + (t247 + z[7][0][0] * t172))
            + (t251 + (t249 + z[7][0][1] * z[4][3][0])
                + (t251 + (t250 + z[4][0][0] * z[7][3][1])));
        let t253 = z[7][1][2] * z[5][2][0];
        let t254 = z[5][1][0] * z[7][2][2];
        let t255 = t253 + t254;
        let t256 = t252
            + (t255 + (t253 + z[7][0][2] * z[5][3][0])
                + (t255 + (t254 + z[5][0][0] * z[7][3][2])));
        let t257 = t111 * t116;
        let t258 = t102 * t148;
        let t259 = t257 + t258;
        let t260 = z[7][2][0] * t106;
        let t261 = z[7][1][0] * t129;
        let t262 = t260 + t261;
        let t263 = z[7][1][1] * z[4][2][1];
        let t264 = z[4][1][1] * z[7][2][1];
        let t265 = t263 + t264;
        let t266 = z[7][3][0] * t96 + t260 + t262 + (t262 + (t261 + z[7][0][0] * t201))
            + (t265 + (t263 + z[7][0][1] * z[4][3][1])
                + (t265 + (t264 + z[4][0][1] * z[7][3][1])));
        let t267 = z[7][1][2] * z[5][2][1];
        let t268 = z[5][1][1] * z[7][2][2];
        let t269 = t267 + t268;
        let t270 = t266
            + (t269 + (t267 + z[7][0][2] * z[5][3][1])
                + (t269 + (t268 + z[5][0][1] * z[7][3][2])));
        let t271 = t112 * t126;
        let t272 = t105 * t153;
        let t273 = t271 + t272;
        let t274 = t259 + (t257 + t99 * t165) + (t259 + (t258 + t93 * t256))
            + (t273 + (t271 + t100 * t194) + (t273 + (t272 + t95 * t270)));
        let t275 = z[7][2][0] * t109;
        let t276 = z[7][1][0] * t139;
        let t277 = t275 + t276;
        let t278 = z[7][1][1] * z[4][2][2];
        let t279 = z[4][1][2] * z[7][2][1];
        let t280 = t278 + t279;
        let t281 = z[7][3][0] * t98 + t275 + t277 + (t277 + (t276 + z[7][0][0] * t230))
            + (t280 + (t278 + z[7][0][1] * z[4][3][2])
                + (t280 + (t279 + z[4][0][2] * z[7][3][1])));
        let t282 = z[7][1][2] * z[5][2][2];
        let t283 = z[5][1][2] * z[7][2][2];
        let t284 = t282 + t283;
        let t285 = t281
            + (t284 + (t282 + z[7][0][2] * z[5][3][2])
                + (t284 + (t283 + z[5][0][2] * z[7][3][2])));
        let t286 = t113 * t136;
        let t287 = t108 * t158;
        let t288 = t286 + t287;
        let t289 = z[1][2][0] * t111;
        let t290 = z[1][1][0] * t148;
        let t291 = t289 + t290;
        let t292 = z[1][2][1] * t112;
        let t293 = z[1][1][1] * t153;
        let t294 = t292 + t293;
        let t295 = z[1][3][0] * t99 + t289 + t291 + (t291 + (t290 + z[1][0][0] * t256))
            + (z[1][3][1] * t100 + t292 + t294 + (t294 + (t293 + z[1][0][1] * t270)));
        let t296 = z[1][2][2] * t113;
        let t297 = z[1][1][2] * t158;
        let t298 = t296 + t297;
        rows[0] = z[0][3][0] - z[3][3][0];
        rows[1] = z[0][3][1] - z[3][3][1];
        rows[2] = z[0][3][2] - z[3][3][2];
        rows[3] = t187 + t216 + t245;
        rows[4] = t274 + (t288 + (t286 + t101 * t223) + (t288 + (t287 + t97 * t285)));
        rows[5] = t295
            + (z[1][3][2] * t101 + t296 + t298 + (t298 + (t297 + z[1][0][2] * t285)));
    }
    /// Constraint `corner` (weld): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 78 additions, 138 multiplications.
    pub fn constraint_gradient_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..8];
        let t33 = z[1][1] * z[2][2] - z[1][2] * z[2][1];
        let t34 = z[4][1] * z[5][2] - z[4][2] * z[5][1];
        let t35 = z[6][0] * t34 + z[4][0] * z[6][1] + z[5][0] * z[6][2];
        let t36 = z[1][2] * z[2][0] - z[1][0] * z[2][2];
        let t37 = z[4][2] * z[5][0] - z[4][0] * z[5][2];
        let t38 = z[6][0] * t37 + z[4][1] * z[6][1] + z[5][1] * z[6][2];
        let t39 = z[1][0] * z[2][1] - z[1][1] * z[2][0];
        let t40 = z[4][0] * z[5][1] - z[4][1] * z[5][0];
        let t41 = z[6][0] * t40 + z[4][2] * z[6][1] + z[5][2] * z[6][2];
        let t42 = z[7][0] * t34 + z[4][0] * z[7][1] + z[5][0] * z[7][2];
        let t43 = z[7][0] * t37 + z[4][1] * z[7][1] + z[5][1] * z[7][2];
        let t44 = z[7][0] * t40 + z[4][2] * z[7][1] + z[5][2] * z[7][2];
        let t45 = z[5][2] * z[6][0];
        let t46 = z[5][1] * z[6][0];
        let t47 = z[5][0] * z[6][0];
        let t48 = z[4][2] * z[6][0];
        let t49 = z[4][1] * z[6][0];
        let t50 = z[4][0] * z[6][0];
        let t51 = t33 * t34 + t36 * t37 + t39 * t40;
        let t52 = z[4][0] * t33 + z[4][1] * t36 + z[4][2] * t39;
        let t53 = z[5][0] * t33 + z[5][1] * t36 + z[5][2] * t39;
        let t54 = z[5][2] * z[7][0];
        let t55 = z[5][1] * z[7][0];
        let t56 = z[5][0] * z[7][0];
        let t57 = z[4][2] * z[7][0];
        let t58 = z[4][1] * z[7][0];
        let t59 = z[4][0] * z[7][0];
        gradient[0] = 1.0;
        gradient[9] = -1.0;
        gradient[25] = 1.0;
        gradient[34] = -1.0;
        gradient[50] = 1.0;
        gradient[59] = -1.0;
        gradient[75] = z[2][1] * t41 - z[2][2] * t38;
        gradient[76] = z[2][2] * t35 - z[2][0] * t41;
        gradient[77] = z[2][0] * t38 - z[2][1] * t35;
        gradient[78] = z[1][2] * t38 - z[1][1] * t41;
        gradient[79] = z[1][0] * t41 - z[1][2] * t35;
        gradient[80] = z[1][1] * t35 - z[1][0] * t38;
        gradient[84] = z[6][1] * t33 - t36 * t45 + t39 * t46;
        gradient[85] = t33 * t45 + z[6][1] * t36 - t39 * t47;
        gradient[86] = t36 * t47 - t33 * t46 + z[6][1] * t39;
        gradient[87] = z[6][2] * t33 + t36 * t48 - t39 * t49;
        gradient[88] = z[6][2] * t36 - t33 * t48 + t39 * t50;
        gradient[89] = t33 * t49 - t36 * t50 + z[6][2] * t39;
        gradient[90] = t51;
        gradient[91] = t52;
        gradient[92] = t53;
        gradient[99] = z[2][1] * t44 - z[2][2] * t43;
        gradient[100] = z[2][2] * t42 - z[2][0] * t44;
        gradient[101] = z[2][0] * t43 - z[2][1] * t42;
        gradient[102] = z[1][2] * t43 - z[1][1] * t44;
        gradient[103] = z[1][0] * t44 - z[1][2] * t42;
        gradient[104] = z[1][1] * t42 - z[1][0] * t43;
        gradient[108] = z[7][1] * t33 - t36 * t54 + t39 * t55;
        gradient[109] = t33 * t54 + z[7][1] * t36 - t39 * t56;
        gradient[110] = t36 * t56 - t33 * t55 + z[7][1] * t39;
        gradient[111] = z[7][2] * t33 + t36 * t57 - t39 * t58;
        gradient[112] = z[7][2] * t36 - t33 * t57 + t39 * t59;
        gradient[113] = t33 * t58 - t36 * t59 + z[7][2] * t39;
        gradient[117] = t51;
        gradient[118] = t52;
        gradient[119] = t53;
        gradient[123] = t42;
        gradient[124] = t43;
        gradient[125] = t44;
        gradient[132] = z[1][0] * z[7][1] - z[1][1] * t54 + z[1][2] * t55;
        gradient[133] = z[1][0] * t54 + z[1][1] * z[7][1] - z[1][2] * t56;
        gradient[134] = z[1][1] * t56 - z[1][0] * t55 + z[1][2] * z[7][1];
        gradient[135] = z[1][0] * z[7][2] + z[1][1] * t57 - z[1][2] * t58;
        gradient[136] = z[1][1] * z[7][2] - z[1][0] * t57 + z[1][2] * t59;
        gradient[137] = z[1][0] * t58 - z[1][1] * t59 + z[1][2] * z[7][2];
        gradient[141] = z[1][0] * t34 + z[1][1] * t37 + z[1][2] * t40;
        gradient[142] = z[1][0] * z[4][0] + z[1][1] * z[4][1] + z[1][2] * z[4][2];
        gradient[143] = z[1][0] * z[5][0] + z[1][1] * z[5][1] + z[1][2] * z[5][2];
    }
    /// Constraint `corner` (weld): writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.
    ///
    /// Operations: 234 additions, 318 multiplications.
    pub fn constraint_rate_gradient_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[f64; 3]],
        velocity: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..8];
        let velocity = &velocity[..8];
        let t51 = z[1][1] * z[2][2] - z[1][2] * z[2][1];
        let t52 = z[4][1] * z[5][2] - z[4][2] * z[5][1];
        let t53 = z[6][0] * t52 + z[4][0] * z[6][1] + z[5][0] * z[6][2];
        let t54 = z[1][2] * z[2][0] - z[1][0] * z[2][2];
        let t55 = z[4][2] * z[5][0] - z[4][0] * z[5][2];
        let t56 = z[6][0] * t55 + z[4][1] * z[6][1] + z[5][1] * z[6][2];
        let t57 = z[1][0] * z[2][1] - z[1][1] * z[2][0];
        let t58 = z[4][0] * z[5][1] - z[4][1] * z[5][0];
        let t59 = z[6][0] * t58 + z[4][2] * z[6][1] + z[5][2] * z[6][2];
        let t60 = z[7][0] * t52 + z[4][0] * z[7][1] + z[5][0] * z[7][2];
        let t61 = z[7][0] * t55 + z[4][1] * z[7][1] + z[5][1] * z[7][2];
        let t62 = z[7][0] * t58 + z[4][2] * z[7][1] + z[5][2] * z[7][2];
        let t63 = z[2][2] * velocity[1][1] + z[1][1] * velocity[2][2]
            - (z[2][1] * velocity[1][2] + z[1][2] * velocity[2][1]);
        let t64 = z[5][2] * velocity[4][1] + z[4][1] * velocity[5][2]
            - (z[5][1] * velocity[4][2] + z[4][2] * velocity[5][1]);
        let t65 = velocity[6][0] * t52 + z[6][0] * t64
            + (z[6][1] * velocity[4][0] + z[4][0] * velocity[6][1])
            + (z[6][2] * velocity[5][0] + z[5][0] * velocity[6][2]);
        let t66 = z[2][0] * velocity[1][2] + z[1][2] * velocity[2][0]
            - (z[2][2] * velocity[1][0] + z[1][0] * velocity[2][2]);
        let t67 = z[5][0] * velocity[4][2] + z[4][2] * velocity[5][0]
            - (z[5][2] * velocity[4][0] + z[4][0] * velocity[5][2]);
        let t68 = velocity[6][0] * t55 + z[6][0] * t67
            + (z[6][1] * velocity[4][1] + z[4][1] * velocity[6][1])
            + (z[6][2] * velocity[5][1] + z[5][1] * velocity[6][2]);
        let t69 = z[2][1] * velocity[1][0] + z[1][0] * velocity[2][1]
            - (z[2][0] * velocity[1][1] + z[1][1] * velocity[2][0]);
        let t70 = z[5][1] * velocity[4][0] + z[4][0] * velocity[5][1]
            - (z[5][0] * velocity[4][1] + z[4][1] * velocity[5][0]);
        let t71 = velocity[6][0] * t58 + z[6][0] * t70
            + (z[6][1] * velocity[4][2] + z[4][2] * velocity[6][1])
            + (z[6][2] * velocity[5][2] + z[5][2] * velocity[6][2]);
        let t72 = velocity[7][0] * t52 + z[7][0] * t64
            + (z[7][1] * velocity[4][0] + z[4][0] * velocity[7][1])
            + (z[7][2] * velocity[5][0] + z[5][0] * velocity[7][2]);
        let t73 = velocity[7][0] * t55 + z[7][0] * t67
            + (z[7][1] * velocity[4][1] + z[4][1] * velocity[7][1])
            + (z[7][2] * velocity[5][1] + z[5][1] * velocity[7][2]);
        let t74 = velocity[7][0] * t58 + z[7][0] * t70
            + (z[7][1] * velocity[4][2] + z[4][2] * velocity[7][1])
            + (z[7][2] * velocity[5][2] + z[5][2] * velocity[7][2]);
        let t75 = z[5][2] * z[6][0];
        let t76 = z[5][1] * z[6][0];
        let t77 = z[5][2] * velocity[6][0] + z[6][0] * velocity[5][2];
        let t78 = z[5][1] * velocity[6][0] + z[6][0] * velocity[5][1];
        let t79 = z[6][1] * t63 + velocity[6][1] * t51 - (t66 * t75 + t54 * t77)
            + (t69 * t76 + t57 * t78);
        let t80 = z[5][0] * z[6][0];
        let t81 = z[5][0] * velocity[6][0] + z[6][0] * velocity[5][0];
        let t82 = t63 * t75 + t51 * t77 + (z[6][1] * t66 + velocity[6][1] * t54)
            - (t69 * t80 + t57 * t81);
        let t83 = t66 * t80 + t54 * t81 - (t63 * t76 + t51 * t78)
            + (z[6][1] * t69 + velocity[6][1] * t57);
        let t84 = z[4][2] * z[6][0];
        let t85 = z[4][1] * z[6][0];
        let t86 = z[4][2] * velocity[6][0] + z[6][0] * velocity[4][2];
        let t87 = z[4][1] * velocity[6][0] + z[6][0] * velocity[4][1];
        let t88 = z[6][2] * t63 + velocity[6][2] * t51 + (t66 * t84 + t54 * t86)
            - (t69 * t85 + t57 * t87);
        let t89 = z[4][0] * z[6][0];
        let t90 = z[4][0] * velocity[6][0] + z[6][0] * velocity[4][0];
        let t91 = z[6][2] * t66 + velocity[6][2] * t54 - (t63 * t84 + t51 * t86)
            + (t69 * t89 + t57 * t90);
        let t92 = t63 * t85 + t51 * t87 - (t66 * t89 + t54 * t90)
            + (z[6][2] * t69 + velocity[6][2] * t57);
        let t93 = t52 * t63 + t51 * t64 + (t55 * t66 + t54 * t67)
            + (t58 * t69 + t57 * t70);
        let t94 = z[4][0] * t63 + velocity[4][0] * t51
            + (z[4][1] * t66 + velocity[4][1] * t54)
            + (z[4][2] * t69 + velocity[4][2] * t57);
        let t95 = z[5][0] * t63 + velocity[5][0] * t51
            + (z[5][1] * t66 + velocity[5][1] * t54)
            + (z[5][2] * t69 + velocity[5][2] * t57);
        let t96 = z[5][2] * z[7][0];
        let t97 = z[5][1] * z[7][0];
        let t98 = z[5][2] * velocity[7][0] + z[7][0] * velocity[5][2];
        let t99 = z[5][1] * velocity[7][0] + z[7][0] * velocity[5][1];
        let t100 = z[7][1] * t63 + velocity[7][1] * t51 - (t66 * t96 + t54 * t98)
            + (t69 * t97 + t57 * t99);
        let t101 = z[5][0] * z[7][0];
        let t102 = z[5][0] * velocity[7][0] + z[7][0] * velocity[5][0];
        let t103 = t63 * t96 + t51 * t98 + (z[7][1] * t66 + velocity[7][1] * t54)
            - (t69 * t101 + t57 * t102);
        let t104 = t66 * t101 + t54 * t102 - (t63 * t97 + t51 * t99)
            + (z[7][1] * t69 + velocity[7][1] * t57);
        let t105 = z[4][2] * z[7][0];
        let t106 = z[4][1] * z[7][0];
        let t107 = z[4][2] * velocity[7][0] + z[7][0] * velocity[4][2];
        let t108 = z[4][1] * velocity[7][0] + z[7][0] * velocity[4][1];
        let t109 = z[7][2] * t63 + velocity[7][2] * t51 + (t66 * t105 + t54 * t107)
            - (t69 * t106 + t57 * t108);
        let t110 = z[4][0] * z[7][0];
        let t111 = z[4][0] * velocity[7][0] + z[7][0] * velocity[4][0];
        let t112 = z[7][2] * t66 + velocity[7][2] * t54 - (t63 * t105 + t51 * t107)
            + (t69 * t110 + t57 * t111);
        let t113 = t63 * t106 + t51 * t108 - (t66 * t110 + t54 * t111)
            + (z[7][2] * t69 + velocity[7][2] * t57);
        let t114 = z[7][1] * velocity[1][0] + z[1][0] * velocity[7][1]
            - (velocity[1][1] * t96 + z[1][1] * t98)
            + (velocity[1][2] * t97 + z[1][2] * t99);
        let t115 = velocity[1][0] * t96 + z[1][0] * t98
            + (z[7][1] * velocity[1][1] + z[1][1] * velocity[7][1])
            - (velocity[1][2] * t101 + z[1][2] * t102);
        let t116 = velocity[1][1] * t101 + z[1][1] * t102
            - (velocity[1][0] * t97 + z[1][0] * t99)
            + (z[7][1] * velocity[1][2] + z[1][2] * velocity[7][1]);
        let t117 = z[7][2] * velocity[1][0] + z[1][0] * velocity[7][2]
            + (velocity[1][1] * t105 + z[1][1] * t107)
            - (velocity[1][2] * t106 + z[1][2] * t108);
        let t118 = z[7][2] * velocity[1][1] + z[1][1] * velocity[7][2]
            - (velocity[1][0] * t105 + z[1][0] * t107)
            + (velocity[1][2] * t110 + z[1][2] * t111);
        let t119 = velocity[1][0] * t106 + z[1][0] * t108
            - (velocity[1][1] * t110 + z[1][1] * t111)
            + (z[7][2] * velocity[1][2] + z[1][2] * velocity[7][2]);
        let t120 = velocity[1][0] * t52 + z[1][0] * t64
            + (velocity[1][1] * t55 + z[1][1] * t67)
            + (velocity[1][2] * t58 + z[1][2] * t70);
        let t121 = z[4][0] * velocity[1][0] + z[1][0] * velocity[4][0]
            + (z[4][1] * velocity[1][1] + z[1][1] * velocity[4][1])
            + (z[4][2] * velocity[1][2] + z[1][2] * velocity[4][2]);
        let t122 = z[5][0] * velocity[1][0] + z[1][0] * velocity[5][0]
            + (z[5][1] * velocity[1][1] + z[1][1] * velocity[5][1])
            + (z[5][2] * velocity[1][2] + z[1][2] * velocity[5][2]);
        gradient[75] = velocity[2][1] * t59 + z[2][1] * t71
            - (velocity[2][2] * t56 + z[2][2] * t68);
        gradient[76] = velocity[2][2] * t53 + z[2][2] * t65
            - (velocity[2][0] * t59 + z[2][0] * t71);
        gradient[77] = velocity[2][0] * t56 + z[2][0] * t68
            - (velocity[2][1] * t53 + z[2][1] * t65);
        gradient[78] = velocity[1][2] * t56 + z[1][2] * t68
            - (velocity[1][1] * t59 + z[1][1] * t71);
        gradient[79] = velocity[1][0] * t59 + z[1][0] * t71
            - (velocity[1][2] * t53 + z[1][2] * t65);
        gradient[80] = velocity[1][1] * t53 + z[1][1] * t65
            - (velocity[1][0] * t56 + z[1][0] * t68);
        gradient[84] = t79;
        gradient[85] = t82;
        gradient[86] = t83;
        gradient[87] = t88;
        gradient[88] = t91;
        gradient[89] = t92;
        gradient[90] = t93;
        gradient[91] = t94;
        gradient[92] = t95;
        gradient[99] = velocity[2][1] * t62 + z[2][1] * t74
            - (velocity[2][2] * t61 + z[2][2] * t73);
        gradient[100] = velocity[2][2] * t60 + z[2][2] * t72
            - (velocity[2][0] * t62 + z[2][0] * t74);
        gradient[101] = velocity[2][0] * t61 + z[2][0] * t73
            - (velocity[2][1] * t60 + z[2][1] * t72);
        gradient[102] = velocity[1][2] * t61 + z[1][2] * t73
            - (velocity[1][1] * t62 + z[1][1] * t74);
        gradient[103] = velocity[1][0] * t62 + z[1][0] * t74
            - (velocity[1][2] * t60 + z[1][2] * t72);
        gradient[104] = velocity[1][1] * t60 + z[1][1] * t72
            - (velocity[1][0] * t61 + z[1][0] * t73);
        gradient[108] = t100;
        gradient[109] = t103;
        gradient[110] = t104;
        gradient[111] = t109;
        gradient[112] = t112;
        gradient[113] = t113;
        gradient[117] = t93;
        gradient[118] = t94;
        gradient[119] = t95;
        gradient[123] = t72;
        gradient[124] = t73;
        gradient[125] = t74;
        gradient[132] = t114;
        gradient[133] = t115;
        gradient[134] = t116;
        gradient[135] = t117;
        gradient[136] = t118;
        gradient[137] = t119;
        gradient[141] = t120;
        gradient[142] = t121;
        gradient[143] = t122;
    }
    /// Constraint `corner` (weld): writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 198 additions, 362 multiplications.
    pub fn constraint_hessian_corner(
        model: &super::RightAngleFrame,
        t: f64,
        z: &[[f64; 3]],
        lambda: &[f64],
        hessian: &mut [f64],
    ) {
        let z = &z[..8];
        let lambda = &lambda[..6];
        let t36 = z[1][1] * z[2][2] - z[1][2] * z[2][1];
        let t37 = z[4][1] * z[5][2] - z[4][2] * z[5][1];
        let t38 = z[1][2] * z[2][0] - z[1][0] * z[2][2];
        let t39 = z[4][2] * z[5][0] - z[4][0] * z[5][2];
        let t40 = z[1][0] * z[2][1] - z[1][1] * z[2][0];
        let t41 = z[4][0] * z[5][1] - z[4][1] * z[5][0];
        let t42 = (z[6][0] * t41 + z[4][2] * z[6][1] + z[5][2] * z[6][2]) * lambda[3]
            + (z[7][0] * t41 + z[4][2] * z[7][1] + z[5][2] * z[7][2]) * lambda[4];
        let t43 = (z[6][0] * t39 + z[4][1] * z[6][1] + z[5][1] * z[6][2]) * lambda[3]
            + (z[7][0] * t39 + z[4][1] * z[7][1] + z[5][1] * z[7][2]) * lambda[4];
        let t44 = (z[6][0] * t37 + z[4][0] * z[6][1] + z[5][0] * z[6][2]) * lambda[3]
            + (z[7][0] * t37 + z[4][0] * z[7][1] + z[5][0] * z[7][2]) * lambda[4];
        let t45 = z[5][2] * z[6][0];
        let t46 = z[5][1] * z[6][0];
        let t47 = z[5][2] * z[7][0];
        let t48 = z[5][1] * z[7][0];
        let t49 = z[1][0] * z[7][1];
        let t50 = z[2][2] * t45;
        let t51 = z[2][1] * t46;
        let t52 = z[2][2] * t47;
        let t53 = z[2][1] * t48;
        let t54 = z[7][1] * lambda[5];
        let t55 = lambda[3] * (t50 + t51) + lambda[4] * (t52 + t53) + t54;
        let t56 = z[2][2] * z[6][1];
        let t57 = z[2][2] * z[7][1];
        let t58 = lambda[5] * t47;
        let t59 = lambda[3] * (t56 - z[2][0] * t46) + lambda[4] * (t57 - z[2][0] * t48)
            - t58;
        let t60 = z[2][1] * z[6][1];
        let t61 = z[2][1] * z[7][1];
        let t62 = lambda[5] * t48;
        let t63 = t62
            - (lambda[3] * (t60 + z[2][0] * t45) + lambda[4] * (t61 + z[2][0] * t47));
        let t64 = z[1][2] * t45;
        let t65 = z[1][1] * t46;
        let t66 = z[1][2] * t47;
        let t67 = z[1][1] * t48;
        let t68 = -(lambda[3] * (t64 + t65) + lambda[4] * (t66 + t67));
        let t69 = z[1][2] * z[6][1];
        let t70 = z[1][2] * z[7][1];
        let t71 = lambda[3] * (z[1][0] * t46 - t69) + lambda[4] * (z[1][0] * t48 - t70);
        let t72 = z[1][1] * z[6][1];
        let t73 = z[1][1] * z[7][1];
        let t74 = lambda[3] * (t72 + z[1][0] * t45) + lambda[4] * (t73 + z[1][0] * t47);
        let t75 = z[5][0] * z[6][0];
        let t76 = z[5][0] * z[7][0];
        let t77 = t58
            - (lambda[3] * (t56 + z[2][1] * t75) + lambda[4] * (t57 + z[2][1] * t76));
        let t78 = z[2][0] * t75;
        let t79 = z[2][0] * t76;
        let t80 = t54 + (lambda[3] * (t50 + t78) + lambda[4] * (t52 + t79));
        let t81 = z[2][0] * z[6][1];
        let t82 = z[2][0] * z[7][1];
        let t83 = lambda[5] * t76;
        let t84 = lambda[3] * (t81 - z[2][1] * t45) + lambda[4] * (t82 - z[2][1] * t47)
            - t83;
        let t85 = lambda[3] * (t69 + z[1][1] * t75) + lambda[4] * (t70 + z[1][1] * t76);
        let t86 = z[1][0] * t75;
        let t87 = z[1][0] * t76;
        let t88 = -(lambda[3] * (t64 + t86) + lambda[4] * (t66 + t87));
        let t89 = z[1][0] * z[6][1];
        let t90 = lambda[3] * (z[1][1] * t45 - t89) + lambda[4] * (z[1][1] * t47 - t49);
        let t91 = lambda[3] * (t60 - z[2][2] * t75) + lambda[4] * (t61 - z[2][2] * t76)
            - t62;
        let t92 = t83
            - (lambda[3] * (t81 + z[2][2] * t46) + lambda[4] * (t82 + z[2][2] * t48));
        let t93 = t54 + (lambda[3] * (t51 + t78) + lambda[4] * (t53 + t79));
        let t94 = lambda[3] * (z[1][2] * t75 - t72) + lambda[4] * (z[1][2] * t76 - t73);
        let t95 = lambda[3] * (t89 + z[1][2] * t46) + lambda[4] * (t49 + z[1][2] * t48);
        let t96 = -(lambda[3] * (t65 + t86) + lambda[4] * (t67 + t87));
        let t97 = z[4][2] * z[6][0];
        let t98 = z[4][1] * z[6][0];
        let t99 = z[4][2] * z[7][0];
        let t100 = z[4][1] * z[7][0];
        let t101 = z[1][0] * z[7][2];
        let t102 = z[2][2] * t97;
        let t103 = z[2][1] * t98;
        let t104 = z[2][2] * t99;
        let t105 = z[2][1] * t100;
        let t106 = z[7][2] * lambda[5];
        let t107 = t106 - (lambda[3] * (t102 + t103) + lambda[4] * (t104 + t105));
        let t108 = z[2][2] * z[6][2];
        let t109 = z[2][2] * z[7][2];
        let t110 = lambda[5] * t99;
        let t111 = lambda[3] * (t108 + z[2][0] * t98)
            + lambda[4] * (t109 + z[2][0] * t100) + t110;
        let t112 = z[2][1] * z[6][2];
        let t113 = z[2][1] * z[7][2];
        let t114 = lambda[5] * t100;
        let t115 = lambda[3] * (z[2][0] * t97 - t112)
            + lambda[4] * (z[2][0] * t99 - t113) - t114;
        let t116 = z[1][2] * t97;
        let t117 = z[1][1] * t98;
        let t118 = z[1][2] * t99;
        let t119 = z[1][1] * t100;
        let t120 = lambda[3] * (t116 + t117) + lambda[4] * (t118 + t119);
        let t121 = z[1][2] * z[6][2];
        let t122 = z[1][2] * z[7][2];
        let t123 = -(lambda[3] * (t121 + z[1][0] * t98)
            + lambda[4] * (t122 + z[1][0] * t100));
        let t124 = z[1][1] * z[6][2];
        let t125 = z[1][1] * z[7][2];
        let t126 = lambda[3] * (t124 - z[1][0] * t97)
            + lambda[4] * (t125 - z[1][0] * t99);
        let t127 = lambda[3] * (z[6][0] * t40) + lambda[4] * (z[7][0] * t40)
            + lambda[5] * (z[1][2] * z[7][0]);
        let t128 = lambda[3] * (z[6][0] * t38) + lambda[4] * (z[7][0] * t38)
            + lambda[5] * (z[1][1] * z[7][0]);
        let t129 = z[4][0] * z[6][0];
        let t130 = z[4][0] * z[7][0];
        let t131 = lambda[3] * (z[2][1] * t129 - t108)
            + lambda[4] * (z[2][1] * t130 - t109) - t110;
        let t132 = z[2][0] * t129;
        let t133 = z[2][0] * t130;
        let t134 = t106 - (lambda[3] * (t102 + t132) + lambda[4] * (t104 + t133));
        let t135 = z[2][0] * z[6][2];
        let t136 = z[2][0] * z[7][2];
        let t137 = lambda[5] * t130;
        let t138 = lambda[3] * (z[2][1] * t97 + t135)
            + lambda[4] * (z[2][1] * t99 + t136) + t137;
        let t139 = lambda[3] * (t121 - z[1][1] * t129)
            + lambda[4] * (t122 - z[1][1] * t130);
        let t140 = z[1][0] * t129;
        let t141 = z[1][0] * t130;
        let t142 = lambda[3] * (t116 + t140) + lambda[4] * (t118 + t141);
        let t143 = z[1][0] * z[6][2];
        let t144 = -(lambda[3] * (z[1][1] * t97 + t143)
            + lambda[4] * (t101 + z[1][1] * t99));
        let t145 = lambda[3] * (z[6][0] * t36) + lambda[4] * (z[7][0] * t36)
            + lambda[5] * (z[1][0] * z[7][0]);
        let t146 = t114
            + (lambda[3] * (t112 + z[2][2] * t129)
                + lambda[4] * (t113 + z[2][2] * t130));
        let t147 = lambda[3] * (z[2][2] * t98 - t135)
            + lambda[4] * (z[2][2] * t100 - t136) - t137;
        let t148 = t106 - (lambda[3] * (t103 + t132) + lambda[4] * (t105 + t133));
        let t149 = -(lambda[3] * (t124 + z[1][2] * t129)
            + lambda[4] * (t125 + z[1][2] * t130));
        let t150 = lambda[3] * (t143 - z[1][2] * t98)
            + lambda[4] * (t101 - z[1][2] * t100);
        let t151 = lambda[3] * (t117 + t140) + lambda[4] * (t119 + t141);
        let t152 = z[2][1] * t41 - z[2][2] * t39;
        let t153 = lambda[3] * t152;
        let t154 = z[2][2] * t37 - z[2][0] * t41;
        let t155 = lambda[3] * t154;
        let t156 = z[2][0] * t39 - z[2][1] * t37;
        let t157 = lambda[3] * t156;
        let t158 = z[1][2] * t39 - z[1][1] * t41;
        let t159 = lambda[3] * t158;
        let t160 = z[1][0] * t41 - z[1][2] * t37;
        let t161 = lambda[3] * t160;
        let t162 = z[1][1] * t37 - z[1][0] * t39;
        let t163 = lambda[3] * t162;
        let t164 = z[5][1] * t40 - z[5][2] * t38;
        let t165 = lambda[3] * t164;
        let t166 = z[5][2] * t36 - z[5][0] * t40;
        let t167 = lambda[3] * t166;
        let t168 = z[5][0] * t38 - z[5][1] * t36;
        let t169 = lambda[3] * t168;
        let t170 = z[4][2] * t38 - z[4][1] * t40;
        let t171 = lambda[3] * t170;
        let t172 = z[4][0] * t40 - z[4][2] * t36;
        let t173 = lambda[3] * t172;
        let t174 = z[4][1] * t36 - z[4][0] * t38;
        let t175 = lambda[3] * t174;
        let t176 = z[2][1] * z[4][2] - z[2][2] * z[4][1];
        let t177 = lambda[3] * t176;
        let t178 = z[2][2] * z[4][0] - z[2][0] * z[4][2];
        let t179 = lambda[3] * t178;
        let t180 = z[2][0] * z[4][1] - z[2][1] * z[4][0];
        let t181 = lambda[3] * t180;
        let t182 = z[1][2] * z[4][1];
        let t183 = z[1][1] * z[4][2];
        let t184 = t182 - t183;
        let t185 = lambda[3] * t184;
        let t186 = z[1][2] * z[4][0];
        let t187 = z[1][0] * z[4][2];
        let t188 = t187 - t186;
        let t189 = lambda[3] * t188;
        let t190 = z[1][1] * z[4][0];
        let t191 = z[1][0] * z[4][1];
        let t192 = t190 - t191;
        let t193 = lambda[3] * t192;
        let t194 = t36 * lambda[3];
        let t195 = t38 * lambda[3];
        let t196 = t40 * lambda[3];
        let t197 = z[2][1] * z[5][2] - z[2][2] * z[5][1];
        let t198 = lambda[3] * t197;
        let t199 = z[2][2] * z[5][0] - z[2][0] * z[5][2];
        let t200 = lambda[3] * t199;
        let t201 = z[2][0] * z[5][1] - z[2][1] * z[5][0];
        let t202 = lambda[3] * t201;
        let t203 = z[1][2] * z[5][1] - z[1][1] * z[5][2];
        let t204 = lambda[3] * t203;
        let t205 = z[1][0] * z[5][2] - z[1][2] * z[5][0];
        let t206 = lambda[3] * t205;
        let t207 = z[1][1] * z[5][0] - z[1][0] * z[5][1];
        let t208 = lambda[3] * t207;
        let t209 = lambda[4] * t152 + t37 * lambda[5];
        let t210 = lambda[4] * t154 + t39 * lambda[5];
        let t211 = lambda[4] * t156 + t41 * lambda[5];
        let t212 = lambda[4] * t158;
        let t213 = lambda[4] * t160;
        let t214 = lambda[4] * t162;
        let t215 = lambda[4] * t164 + lambda[5] * t203;
        let t216 = lambda[4] * t166 + lambda[5] * t205;
        let t217 = lambda[4] * t168 + lambda[5] * t207;
        let t218 = lambda[4] * t170 + lambda[5] * (t183 - t182);
        let t219 = lambda[4] * t172 + lambda[5] * (t186 - t187);
        let t220 = lambda[4] * t174 + lambda[5] * (t191 - t190);
        let t221 = lambda[4] * t176 + z[4][0] * lambda[5];
        let t222 = lambda[4] * t178 + z[4][1] * lambda[5];
        let t223 = lambda[4] * t180 + z[4][2] * lambda[5];
        let t224 = lambda[4] * t184;
        let t225 = lambda[4] * t188;
        let t226 = lambda[4] * t192;
        let t227 = t36 * lambda[4] + z[1][0] * lambda[5];
        let t228 = t38 * lambda[4] + z[1][1] * lambda[5];
        let t229 = t40 * lambda[4] + z[1][2] * lambda[5];
        let t230 = lambda[4] * t197 + z[5][0] * lambda[5];
        let t231 = lambda[4] * t199 + z[5][1] * lambda[5];
        let t232 = lambda[4] * t201 + z[5][2] * lambda[5];
        let t233 = lambda[4] * t203;
        let t234 = lambda[4] * t205;
        let t235 = lambda[4] * t207;
        hessian[148] = -t42;
        hessian[102] = -t42;
        hessian[149] = t43;
        hessian[126] = t43;
        hessian[171] = t42;
        hessian[79] = t42;
        hessian[173] = -t44;
        hessian[127] = -t44;
        hessian[195] = -t43;
        hessian[80] = -t43;
        hessian[196] = t44;
        hessian[104] = t44;
        hessian[291] = t55;
        hessian[84] = t55;
        hessian[292] = t59;
        hessian[108] = t59;
        hessian[293] = t63;
        hessian[132] = t63;
        hessian[294] = t68;
        hessian[156] = t68;
        hessian[295] = t71;
        hessian[180] = t71;
        hessian[296] = t74;
        hessian[204] = t74;
        hessian[315] = t77;
        hessian[85] = t77;
        hessian[316] = t80;
        hessian[109] = t80;
        hessian[317] = t84;
        hessian[133] = t84;
        hessian[318] = t85;
        hessian[157] = t85;
        hessian[319] = t88;
        hessian[181] = t88;
        hessian[320] = t90;
        hessian[205] = t90;
        hessian[339] = t91;
        hessian[86] = t91;
        hessian[340] = t92;
        hessian[110] = t92;
        hessian[341] = t93;
        hessian[134] = t93;
        hessian[342] = t94;
        hessian[158] = t94;
        hessian[343] = t95;
        hessian[182] = t95;
        hessian[344] = t96;
        hessian[206] = t96;
        hessian[363] = t107;
        hessian[87] = t107;
        hessian[364] = t111;
        hessian[111] = t111;
        hessian[365] = t115;
        hessian[135] = t115;
        hessian[366] = t120;
        hessian[159] = t120;
        hessian[367] = t123;
        hessian[183] = t123;
        hessian[368] = t126;
        hessian[207] = t126;
        hessian[373] = -t127;
        hessian[327] = -t127;
        hessian[374] = t128;
        hessian[351] = t128;
        hessian[387] = t131;
        hessian[88] = t131;
        hessian[388] = t134;
        hessian[112] = t134;
        hessian[389] = t138;
        hessian[136] = t138;
        hessian[390] = t139;
        hessian[160] = t139;
        hessian[391] = t142;
        hessian[184] = t142;
        hessian[392] = t144;
        hessian[208] = t144;
        hessian[396] = t127;
        hessian[304] = t127;
        hessian[398] = -t145;
        hessian[352] = -t145;
        hessian[411] = t146;
        hessian[89] = t146;
        hessian[412] = t147;
        hessian[113] = t147;
        hessian[413] = t148;
        hessian[137] = t148;
        hessian[414] = t149;
        hessian[161] = t149;
        hessian[415] = t150;
        hessian[185] = t150;
        hessian[416] = t151;
        hessian[209] = t151;
        hessian[420] = -t128;
        hessian[305] = -t128;
        hessian[421] = t145;
        hessian[329] = t145;
        hessian[435] = t153;
        hessian[90] = t153;
        hessian[436] = t155;
        hessian[114] = t155;
        hessian[437] = t157;
        hessian[138] = t157;
        hessian[438] = t159;
        hessian[162] = t159;
        hessian[439] = t161;
        hessian[186] = t161;
        hessian[440] = t163;
        hessian[210] = t163;
        hessian[444] = t165;
        hessian[306] = t165;
        hessian[445] = t167;
        hessian[330] = t167;
        hessian[446] = t169;
        hessian[354] = t169;
        hessian[447] = t171;
        hessian[378] = t171;
        hessian[448] = t173;
        hessian[402] = t173;
        hessian[449] = t175;
        hessian[426] = t175;
        hessian[459] = t177;
        hessian[91] = t177;
        hessian[460] = t179;
        hessian[115] = t179;
        hessian[461] = t181;
        hessian[139] = t181;
        hessian[462] = t185;
        hessian[163] = t185;
        hessian[463] = t189;
        hessian[187] = t189;
        hessian[464] = t193;
        hessian[211] = t193;
        hessian[468] = t194;
        hessian[307] = t194;
        hessian[469] = t195;
        hessian[331] = t195;
        hessian[470] = t196;
        hessian[355] = t196;
        hessian[483] = t198;
        hessian[92] = t198;
        hessian[484] = t200;
        hessian[116] = t200;
        hessian[485] = t202;
        hessian[140] = t202;
        hessian[486] = t204;
        hessian[164] = t204;
        hessian[487] = t206;
        hessian[188] = t206;
        hessian[488] = t208;
        hessian[212] = t208;
        hessian[495] = t194;
        hessian[380] = t194;
        hessian[496] = t195;
        hessian[404] = t195;
        hessian[497] = t196;
        hessian[428] = t196;
        hessian[507] = t209;
        hessian[93] = t209;
        hessian[508] = t210;
        hessian[117] = t210;
        hessian[509] = t211;
        hessian[141] = t211;
        hessian[510] = t212;
        hessian[165] = t212;
        hessian[511] = t213;
        hessian[189] = t213;
        hessian[512] = t214;
        hessian[213] = t214;
        hessian[516] = t215;
        hessian[309] = t215;
        hessian[517] = t216;
        hessian[333] = t216;
        hessian[518] = t217;
        hessian[357] = t217;
        hessian[519] = t218;
        hessian[381] = t218;
        hessian[520] = t219;
        hessian[405] = t219;
        hessian[521] = t220;
        hessian[429] = t220;
        hessian[531] = t221;
        hessian[94] = t221;
        hessian[532] = t222;
        hessian[118] = t222;
        hessian[533] = t223;
        hessian[142] = t223;
        hessian[534] = t224;
        hessian[166] = t224;
        hessian[535] = t225;
        hessian[190] = t225;
        hessian[536] = t226;
        hessian[214] = t226;
        hessian[540] = t227;
        hessian[310] = t227;
        hessian[541] = t228;
        hessian[334] = t228;
        hessian[542] = t229;
        hessian[358] = t229;
        hessian[555] = t230;
        hessian[95] = t230;
        hessian[556] = t231;
        hessian[119] = t231;
        hessian[557] = t232;
        hessian[143] = t232;
        hessian[558] = t233;
        hessian[167] = t233;
        hessian[559] = t234;
        hessian[191] = t234;
        hessian[560] = t235;
        hessian[215] = t235;
        hessian[567] = t227;
        hessian[383] = t227;
        hessian[568] = t228;
        hessian[407] = t228;
        hessian[569] = t229;
        hessian[431] = t229;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    pub fn kinks(model: &super::RightAngleFrame, kinks: &mut [f64; 0]) {}
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn outputs(
        model: &super::RightAngleFrame,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
        out[0] = observed[0] - 0.24;
        out[1] = observed[1] - 0.24;
        out[2] = observed[2];
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &super::RightAngleFrame, run: &mut ::rncf::RunDefaults) {
        run.t_end = 1.0;
        run.every = 0.001;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::RightAngleFrame,
        pub row_first: BeamSpatial,
        pub row_second: BeamSpatial,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::RightAngleFrame) -> Self {
            Self {
                model: model.clone(),
                row_first: Default::default(),
                row_second: Default::default(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "first",
                    frame: 0,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [0.24, 0.0, 0.0],
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
                ::rncf::mesh::BodySpec {
                    name: "second",
                    frame: 0,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.24, 0.0, 0.0],
                        to: [0.24, 0.24, 0.0],
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
                    name: "root",
                    kind: ::rncf::mesh::JointKind::Clamp,
                    body: 0,
                    at_end: false,
                    frame: 0,
                    point: None,
                },
            ])
        }
        fn loads(&self) -> ::std::vec::Vec<::rncf::mesh::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::LoadSpec {
                    name: "push",
                    kind: ::rncf::mesh::LoadKind::Force {
                        body: 1,
                        at: ::rncf::mesh::Place::End,
                    },
                    frame: 0,
                },
            ])
        }
        fn observed(&self) -> ::std::vec::Vec<::rncf::mesh::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ObservedSpec::Point {
                    body: 1,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 1,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 1,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
                },
            ])
        }
        fn output_columns(&self) -> usize {
            3
        }
        fn frame_count(&self) -> usize {
            1
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial"][frame]
        }
        fn load_varies(&self, load: usize) -> bool {
            const VARIES: [bool; 1] = [false];
            VARIES[load]
        }
        fn conservative(&self) -> bool {
            true
        }
        fn kinks(&self) -> ::std::vec::Vec<f64> {
            let mut times = [0.0; 0];
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
            match body {
                0 => {
                    let density = ::rncf::mesh::positive(
                        "material `aluminium`",
                        "density",
                        2700.0,
                        "kg/m^3",
                    )?;
                    let young = ::rncf::mesh::positive(
                        "material `aluminium`",
                        "young",
                        71240000000.0,
                        "Pa",
                    )?;
                    let poisson = ::rncf::mesh::poisson(
                        "material `aluminium`",
                        "poisson",
                        0.31,
                        "1",
                    )?;
                    let damping = ::rncf::mesh::non_negative(
                        "material `aluminium`",
                        "damping",
                        0.0,
                        "s",
                    )?;
                    let area = ::rncf::mesh::positive(
                        "section `strip`",
                        "area",
                        1.7999999999999997e-5,
                        "m^2",
                    )?;
                    let second_moment_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "second_moment_y",
                        5.399999999999998e-13,
                        "m^4",
                    )?;
                    let second_moment_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "second_moment_z",
                        1.3499999999999999e-9,
                        "m^4",
                    )?;
                    let torsion_constant = ::rncf::mesh::positive(
                        "section `strip`",
                        "torsion_constant",
                        2.132773248544536e-12,
                        "m^4",
                    )?;
                    let shear_factor_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "shear_factor_y",
                        0.8333333333333334,
                        "1",
                    )?;
                    let shear_factor_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "shear_factor_z",
                        0.8333333333333334,
                        "1",
                    )?;
                    let size_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "size_y",
                        0.03,
                        "m",
                    )?;
                    let size_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "size_z",
                        0.0006,
                        "m",
                    )?;
                    let shear_modulus = young / (2.0 * (1.0 + poisson));
                    self.row_first = BeamSpatial {
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
                }
                _ => {
                    let density = ::rncf::mesh::positive(
                        "material `aluminium`",
                        "density",
                        2700.0,
                        "kg/m^3",
                    )?;
                    let young = ::rncf::mesh::positive(
                        "material `aluminium`",
                        "young",
                        71240000000.0,
                        "Pa",
                    )?;
                    let poisson = ::rncf::mesh::poisson(
                        "material `aluminium`",
                        "poisson",
                        0.31,
                        "1",
                    )?;
                    let damping = ::rncf::mesh::non_negative(
                        "material `aluminium`",
                        "damping",
                        0.0,
                        "s",
                    )?;
                    let area = ::rncf::mesh::positive(
                        "section `strip`",
                        "area",
                        1.7999999999999997e-5,
                        "m^2",
                    )?;
                    let second_moment_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "second_moment_y",
                        5.399999999999998e-13,
                        "m^4",
                    )?;
                    let second_moment_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "second_moment_z",
                        1.3499999999999999e-9,
                        "m^4",
                    )?;
                    let torsion_constant = ::rncf::mesh::positive(
                        "section `strip`",
                        "torsion_constant",
                        2.132773248544536e-12,
                        "m^4",
                    )?;
                    let shear_factor_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "shear_factor_y",
                        0.8333333333333334,
                        "1",
                    )?;
                    let shear_factor_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "shear_factor_z",
                        0.8333333333333334,
                        "1",
                    )?;
                    let size_y = ::rncf::mesh::positive(
                        "section `strip`",
                        "size_y",
                        0.03,
                        "m",
                    )?;
                    let size_z = ::rncf::mesh::positive(
                        "section `strip`",
                        "size_z",
                        0.0006,
                        "m",
                    )?;
                    let shear_modulus = young / (2.0 * (1.0 + poisson));
                    self.row_second = BeamSpatial {
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
                }
            }
            Ok(())
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
        }
        fn load(&self, load: usize, t: f64) -> [f64; 3] {
            let mut value = [0.0; 3];
            match load {
                0 => load_push(&self.model, t, &mut value),
                _ => {}
            }
            value
        }
        fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {
            outputs(&self.model, t, observed, out);
        }
        fn mass(&self, body: usize, mass: &mut [f64]) {
            match body {
                0 => {
                    beam_spatial_mass(&self.row_first, ::rncf::mesh::array_mut(mass));
                }
                _ => {
                    beam_spatial_mass(&self.row_second, ::rncf::mesh::array_mut(mass));
                }
            }
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
            match body {
                0 => {
                    let [q, v, a]: [&[f64; 30]; 3] = [q, v, a].map(::rncf::mesh::array);
                    let force = ::rncf::mesh::array_mut(force);
                    beam_spatial_elastic_force(&self.row_first, q, force);
                    beam_spatial_absolute_inertia_force(
                        &self.row_first,
                        frame,
                        a,
                        force,
                    );
                }
                _ => {
                    let [q, v, a]: [&[f64; 30]; 3] = [q, v, a].map(::rncf::mesh::array);
                    let force = ::rncf::mesh::array_mut(force);
                    beam_spatial_elastic_force(&self.row_second, q, force);
                    beam_spatial_absolute_inertia_force(
                        &self.row_second,
                        frame,
                        a,
                        force,
                    );
                }
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
            match body {
                0 => {
                    let [q, v]: [&[f64; 30]; 2] = [q, v].map(::rncf::mesh::array);
                    let stiffness = ::rncf::mesh::array_mut(stiffness);
                    beam_spatial_elastic_tangent(&self.row_first, q, stiffness);
                }
                _ => {
                    let [q, v]: [&[f64; 30]; 2] = [q, v].map(::rncf::mesh::array);
                    let stiffness = ::rncf::mesh::array_mut(stiffness);
                    beam_spatial_elastic_tangent(&self.row_second, q, stiffness);
                }
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            match body {
                0 => {
                    beam_spatial_strain_energy(
                        &self.row_first,
                        ::rncf::mesh::array(q),
                        &mut energy,
                    );
                }
                _ => {
                    beam_spatial_strain_energy(
                        &self.row_second,
                        ::rncf::mesh::array(q),
                        &mut energy,
                    );
                }
            }
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
            match body {
                0 => {
                    match (of, order) {
                        (::rncf::mesh::Interpolant::Position, 0) => {
                            beam_spatial_shapes_position_0(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::Position, 1) => {
                            beam_spatial_shapes_position_1(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::Position, 2) => {
                            beam_spatial_shapes_position_2(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 0) => {
                            beam_spatial_shapes_section_y_0(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 1) => {
                            beam_spatial_shapes_section_y_1(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 2) => {
                            beam_spatial_shapes_section_y_2(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 0) => {
                            beam_spatial_shapes_section_z_0(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 1) => {
                            beam_spatial_shapes_section_z_1(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 2) => {
                            beam_spatial_shapes_section_z_2(
                                self.row_first.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        _ => {}
                    }
                }
                _ => {
                    match (of, order) {
                        (::rncf::mesh::Interpolant::Position, 0) => {
                            beam_spatial_shapes_position_0(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::Position, 1) => {
                            beam_spatial_shapes_position_1(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::Position, 2) => {
                            beam_spatial_shapes_position_2(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 0) => {
                            beam_spatial_shapes_section_y_0(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 1) => {
                            beam_spatial_shapes_section_y_1(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionY, 2) => {
                            beam_spatial_shapes_section_y_2(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 0) => {
                            beam_spatial_shapes_section_z_0(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 1) => {
                            beam_spatial_shapes_section_z_1(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        (::rncf::mesh::Interpolant::SectionZ, 2) => {
                            beam_spatial_shapes_section_z_2(
                                self.row_second.length,
                                xi,
                                ::rncf::mesh::array_mut(weights),
                            )
                        }
                        _ => {}
                    }
                }
            }
        }
        fn section(&self, body: usize) -> ::rncf::mesh::SectionSpec {
            let model = &self.model;
            match body {
                0 => {
                    ::rncf::mesh::SectionSpec {
                        shape: ::rncf::mesh::SectionShape::Rectangle {
                            sizes: [0.03, 0.0006],
                        },
                        area: 1.7999999999999997e-5,
                        second_moments: [5.399999999999998e-13, 1.3499999999999999e-9],
                        torsion_constant: 2.132773248544536e-12,
                        yield_stress: None,
                        material: "aluminium",
                    }
                }
                _ => {
                    ::rncf::mesh::SectionSpec {
                        shape: ::rncf::mesh::SectionShape::Rectangle {
                            sizes: [0.03, 0.0006],
                        },
                        area: 1.7999999999999997e-5,
                        second_moments: [5.399999999999998e-13, 1.3499999999999999e-9],
                        torsion_constant: 2.132773248544536e-12,
                        yield_stress: None,
                        material: "aluminium",
                    }
                }
            }
        }
        fn fields(&self, body: usize) -> &'static [(::rncf::mesh::Interpolant, usize)] {
            match body {
                0 => {
                    &[
                        (::rncf::mesh::Interpolant::Position, 1),
                        (::rncf::mesh::Interpolant::SectionY, 0),
                        (::rncf::mesh::Interpolant::SectionZ, 0),
                        (::rncf::mesh::Interpolant::SectionY, 1),
                        (::rncf::mesh::Interpolant::SectionZ, 1),
                    ]
                }
                _ => {
                    &[
                        (::rncf::mesh::Interpolant::Position, 1),
                        (::rncf::mesh::Interpolant::SectionY, 0),
                        (::rncf::mesh::Interpolant::SectionZ, 0),
                        (::rncf::mesh::Interpolant::SectionY, 1),
                        (::rncf::mesh::Interpolant::SectionZ, 1),
                    ]
                }
            }
        }
        fn field_forces(
            &self,
            body: usize,
            stress_free: &[f64],
            fields: &[f64],
            rates: &[f64],
            forces: &mut [f64],
        ) {
            match body {
                0 => {
                    beam_spatial_field_forces(
                        &self.row_first,
                        ::rncf::mesh::array(stress_free),
                        ::rncf::mesh::array(fields),
                        ::rncf::mesh::array_mut(forces),
                    );
                }
                _ => {
                    beam_spatial_field_forces(
                        &self.row_second,
                        ::rncf::mesh::array(stress_free),
                        ::rncf::mesh::array(fields),
                        ::rncf::mesh::array_mut(forces),
                    );
                }
            }
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
                (0, _) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            joint_root_absolute_position(
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
                            joint_root_absolute_velocity(
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
                            joint_root_absolute_acceleration(
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
                            joint_root_absolute_jerk(&self.model, t, data, q, v, a, rows)
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
                (0, _) => {
                    joint_root_absolute_jacobian(&self.model, t, data, jacobian);
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
                (0, _) => {
                    joint_root_absolute_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::mesh::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                },
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 1,
                    at: ::rncf::mesh::Place::Start,
                },
                ::rncf::mesh::MarkerSpec::BodySection {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    axis: 1,
                },
                ::rncf::mesh::MarkerSpec::BodySection {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    axis: 2,
                },
                ::rncf::mesh::MarkerSpec::BodySection {
                    body: 1,
                    at: ::rncf::mesh::Place::Start,
                    axis: 1,
                },
                ::rncf::mesh::MarkerSpec::BodySection {
                    body: 1,
                    at: ::rncf::mesh::Place::Start,
                    axis: 2,
                },
                ::rncf::mesh::MarkerSpec::InSection {
                    body: 1,
                    at: ::rncf::mesh::Place::Start,
                    marker: 2,
                },
                ::rncf::mesh::MarkerSpec::InSection {
                    body: 1,
                    at: ::rncf::mesh::Place::Start,
                    marker: 3,
                },
            ])
        }
        fn constraints(&self) -> ::std::vec::Vec<::rncf::mesh::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ConstraintSpec {
                    name: "corner",
                    kind: "weld",
                    rows: &[
                        "position x",
                        "position y",
                        "position z",
                        "direction 1",
                        "direction 2",
                        "direction 3",
                    ],
                    markers: &[0, 2, 3, 1, 4, 5, 6, 7],
                    first_party: 3,
                    when: ::rncf::mesh::When::Always,
                },
            ])
        }
        fn marker_constraint(
            &self,
            constraint: usize,
            level: ::rncf::system::ConstraintLevel,
            t: f64,
            z: &[[[f64; 3]; 4]],
            rows: &mut [f64],
        ) {
            match constraint {
                0 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_corner(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_corner(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_corner(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_corner(&self.model, t, z, rows)
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
            z: &[[f64; 3]],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match constraint {
                0 => constraint_gradient_corner(&self.model, t, z, gradient),
                _ => {}
            }
        }
        fn marker_constraint_rate_gradient(
            &self,
            constraint: usize,
            t: f64,
            z: &[[f64; 3]],
            velocity: &[[f64; 3]],
            gradient: &mut [f64],
        ) {
            gradient.fill(0.0);
            match constraint {
                0 => {
                    constraint_rate_gradient_corner(
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
        fn marker_constraint_hessian(
            &self,
            constraint: usize,
            t: f64,
            z: &[[f64; 3]],
            lambda: &[f64],
            hessian: &mut [f64],
        ) {
            hessian.fill(0.0);
            match constraint {
                0 => constraint_hessian_corner(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
    }
}
