//! Expansion of `models/src/curved_out_of_plane.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// Spin-up of a beam that is curved along the axis of rotation (Ren & Yang 2021, section 4.1.2).
#[derive(Clone, Debug, PartialEq)]
#[allow(non_snake_case)]
pub struct CurvedOutOfPlane {
    /// Steady angular velocity. (SI; declared in rad/s)
    pub omega_s: f64,
    /// Time to reach it. (SI; declared in s)
    pub T_s: f64,
    /// Number of elements. (count)
    pub elements: usize,
}
#[allow(clippy::all)]
impl Default for CurvedOutOfPlane {
    fn default() -> Self {
        Self {
            omega_s: 4.0,
            T_s: 15.0,
            elements: 8,
        }
    }
}
#[allow(unused_variables, clippy::all)]
impl ::rncf::Model for CurvedOutOfPlane {
    const NAME: &'static str = "CurvedOutOfPlane";
    const DOC: &'static str = "Spin-up of a beam that is curved along the axis of rotation (Ren & Yang 2021, section 4.1.2).";
    const SOURCE: &'static str = r#"pub model CurvedOutOfPlane {
    /// Steady angular velocity.
    param omega_s = 4 rad/s;
    /// Time to reach it.
    param T_s = 15 s;
    /// Number of elements.
    param elements: count = 8;

    const bend = 16 m;
    const turn = 0.5 rad;

    material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
    section tube {
        area = 0.7299 cm^2;
        second_moment = 0.8215 cm^4;
        torsion_constant = 1.643 cm^4;
        shear_factor = 0.53;
    }

    /// Angle of the hub, Eq. (22).
    motion theta(t) =
        if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
        else { omega_s * (t - T_s/2) };
    frame hub = rotating(axis = z, angle = theta(t));

    body beam in hub {
        spatial;
        arc from [0, 0, 0] m direction [1, 0, 0] normal [0, -1, 0] radius bend angle turn;
        mesh elements * beam(tube, aluminium);
    }
    joint root = clamp(beam.start, hub);

    /// Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.
    output u = beam.end.x - bend * sin(turn);
    /// The same along y, in the plane of rotation.
    output v = beam.end.y;
    /// The same along z, the axis of rotation.
    output w = beam.end.z - bend * (1 - cos(turn));

    run { t_end = 20 s; every = 0.05 s; }
}"#;
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `beam_spatial_curved`. Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1249 and 9945).",
        "Body `beam` moves in the prescribed frame `hub`: no unknowns for the frame, its reactions are evaluated.",
    ];
    fn params() -> &'static [::rncf::Param] {
        &[
            ::rncf::Param {
                name: "omega_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "rad/s",
                unit_si: 1.0,
                dimension: [0, 0, -1, 0, 0, 1],
                default: 4.0,
                doc: "Steady angular velocity.",
            },
            ::rncf::Param {
                name: "T_s",
                kind: ::rncf::ParamKind::Quantity,
                unit: "s",
                unit_si: 1.0,
                dimension: [0, 0, 1, 0, 0, 0],
                default: 15.0,
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
        ]
    }
    fn outputs() -> &'static [::rncf::Output] {
        &[
            ::rncf::Output {
                name: "u",
                unit: "m",
                components: &[],
                doc: "Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.",
            },
            ::rncf::Output {
                name: "v",
                unit: "m",
                components: &[],
                doc: "The same along y, in the plane of rotation.",
            },
            ::rncf::Output {
                name: "w",
                unit: "m",
                components: &[],
                doc: "The same along z, the axis of rotation.",
            },
        ]
    }
    fn get(&self, index: usize) -> f64 {
        match index {
            0 => self.omega_s,
            1 => self.T_s,
            2 => self.elements as f64,
            _ => panic!("CurvedOutOfPlane has 3 parameters, not {index}"),
        }
    }
    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega_s = value,
            1 => self.T_s = value,
            2 => self.elements = value as usize,
            _ => panic!("CurvedOutOfPlane has 3 parameters, not {index}"),
        }
    }
    fn run(&self) -> ::rncf::RunDefaults {
        let mut run = ::rncf::RunDefaults {
            t_end: 0.0,
            every: 0.0,
        };
        curved_out_of_plane_equations::run_defaults(self, &mut run);
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
        let equations = curved_out_of_plane_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
    }
}
/// Equations of [`CurvedOutOfPlane`]: derived, checked and written by the generator.
#[allow(
    missing_docs,
    non_snake_case,
    unused_variables,
    unused_mut,
    unused_parens,
    clippy::all
)]
pub mod curved_out_of_plane_equations {
    /// Constants of one element `beam_spatial_curved`. Beam with a cross-section: axial strain, shear, bending, torsion.
    ///
    /// Nodal vectors: r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z, 3 components each.
    ///
    /// Form: fields at points (from 6 nodal vectors on; operations of force and tangent: 1249 and 9945).
    ///
    /// The energy is integrated with 3 Gauss points.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct BeamSpatialCurved {
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
    static BEAM_SPATIAL_CURVED_VECTORS: ::rncf::mesh::Vectors<10, 3, 3, 3> = ::rncf::mesh::Vectors {
        base: 0,
        nodal: [[1, 6, 7], [2, 4, 8], [3, 5, 9]],
        positions: [[false, true, false], [false, false, false], [false, false, false]],
    };
    /// Gauss rule with 3 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_CURVED_POINTS3: ::rncf::mesh::Rule<3, 3, 3> = ::rncf::mesh::Rule {
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
    static BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS: ::rncf::mesh::Blocks<3, 9, 6> = BEAM_SPATIAL_CURVED_POINTS3
        .blocks(
            &[(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)],
            &[(0, 0, 1), (1, 1, 2), (2, 2, 3), (3, 3, 4), (4, 4, 5), (5, 5, 6)],
        );
    /// Gauss rule with 2 points, and derivatives of the shape functions there.
    static BEAM_SPATIAL_CURVED_POINTS2: ::rncf::mesh::Rule<2, 5, 3> = ::rncf::mesh::Rule {
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
    static BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS: ::rncf::mesh::Blocks<2, 9, 15> = BEAM_SPATIAL_CURVED_POINTS2
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
    /// Operations: 39 additions, 70 multiplications.
    pub fn beam_spatial_curved_points3_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        forces: &mut [[f64; 3]; 3],
    ) {
        let BeamSpatialCurved {
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
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t35 = length * EA;
        let t36 = t35 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0]);
        let t37 = 0.5 * t36;
        let t38 = length * kyGA * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]);
        let t39 = length * kzGA * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]);
        let t40 = t35 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1]);
        let t41 = 0.5 * t40;
        let t42 = length * GA * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t43 = t35 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2]);
        let t44 = 0.5 * t43;
        forces[0][0] = t37 * (a_x * 2.0) + b_x * t38 + c_x * t39;
        forces[0][1] = t37 * (a_y * 2.0) + b_y * t38 + c_y * t39;
        forces[0][2] = t37 * (a_z * 2.0) + b_z * t38 + c_z * t39;
        forces[1][0] = a_x * t38 + t41 * (b_x * 2.0) + c_x * t42;
        forces[1][1] = a_y * t38 + t41 * (b_y * 2.0) + c_y * t42;
        forces[1][2] = a_z * t38 + t41 * (b_z * 2.0) + c_z * t42;
        forces[2][0] = a_x * t39 + b_x * t42 + t44 * (c_x * 2.0);
        forces[2][1] = a_y * t39 + b_y * t42 + t44 * (c_y * 2.0);
        forces[2][2] = a_z * t39 + b_z * t42 + t44 * (c_z * 2.0);
    }
    /// Writes the blocks of the tangent on the fields a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 75 additions, 156 multiplications.
    pub fn beam_spatial_curved_points3_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        stiffness: &mut [[f64; 9]; 6],
    ) {
        let BeamSpatialCurved {
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
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t35 = length * EA;
        let t36 = length * kyGA;
        let t37 = length * kzGA;
        let t38 = length * GA;
        let t39 = 0.5 * (0.5 * t35);
        let t40 = t35 * (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0]);
        let t41 = t36 * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]);
        let t42 = t37 * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]);
        let t43 = t35 * (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1]);
        let t44 = t38 * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]);
        let t45 = t35 * (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2]);
        let t46 = a_x * 2.0;
        let t47 = a_y * 2.0;
        let t48 = a_z * 2.0;
        let t49 = b_x * 2.0;
        let t50 = b_y * 2.0;
        let t51 = b_z * 2.0;
        let t52 = c_x * 2.0;
        let t53 = c_y * 2.0;
        let t54 = c_z * 2.0;
        let t55 = t39 * t47;
        let t56 = t39 * t48;
        let t57 = b_y * t36;
        let t58 = b_z * t36;
        let t59 = a_x * t36;
        let t60 = a_y * t36;
        let t61 = a_z * t36;
        let t62 = c_y * t37;
        let t63 = c_z * t37;
        let t64 = a_x * t37;
        let t65 = a_y * t37;
        let t66 = a_z * t37;
        let t67 = t39 * t50;
        let t68 = t39 * t51;
        let t69 = c_y * t38;
        let t70 = c_z * t38;
        let t71 = b_x * t38;
        let t72 = b_y * t38;
        let t73 = b_z * t38;
        let t74 = t39 * t53;
        let t75 = t39 * t54;
        let t76 = t46 * t55 + b_x * t57 + c_x * t62;
        let t77 = t46 * t56 + b_x * t58 + c_x * t63;
        let t78 = t47 * t56 + b_y * t58 + c_y * t63;
        let t79 = a_x * t60 + t49 * t67 + c_x * t69;
        let t80 = a_x * t61 + t49 * t68 + c_x * t70;
        let t81 = a_y * t61 + t50 * t68 + c_y * t70;
        let t82 = a_x * t65 + b_x * t72 + t52 * t74;
        let t83 = a_x * t66 + b_x * t73 + t52 * t75;
        let t84 = a_y * t66 + b_y * t73 + t53 * t75;
        let t85 = 0.5 * t40 * 2.0;
        let t86 = t46 * (t39 * t46) + b_x * (b_x * t36) + c_x * (c_x * t37) + t85;
        let t87 = 0.5 * t43 * 2.0;
        let t88 = 0.5 * t45 * 2.0;
        stiffness[0][0] = t86;
        stiffness[0][1] = t76;
        stiffness[0][2] = t77;
        stiffness[0][3] = t76;
        stiffness[0][4] = t47 * t55 + b_y * t57 + c_y * t62 + t85;
        stiffness[0][5] = t78;
        stiffness[0][6] = t77;
        stiffness[0][7] = t78;
        stiffness[0][8] = t48 * t56 + b_z * t58 + c_z * t63 + t85;
        stiffness[1][0] = t41 + b_x * t59;
        stiffness[1][1] = b_x * t60;
        stiffness[1][2] = b_x * t61;
        stiffness[1][3] = b_y * t59;
        stiffness[1][4] = t41 + b_y * t60;
        stiffness[1][5] = b_y * t61;
        stiffness[1][6] = b_z * t59;
        stiffness[1][7] = b_z * t60;
        stiffness[1][8] = t41 + b_z * t61;
        stiffness[2][0] = t42 + c_x * t64;
        stiffness[2][1] = c_x * t65;
        stiffness[2][2] = c_x * t66;
        stiffness[2][3] = c_y * t64;
        stiffness[2][4] = t42 + c_y * t65;
        stiffness[2][5] = c_y * t66;
        stiffness[2][6] = c_z * t64;
        stiffness[2][7] = c_z * t65;
        stiffness[2][8] = t42 + c_z * t66;
        stiffness[3][0] = a_x * t59 + t49 * (t39 * t49) + c_x * (c_x * t38) + t87;
        stiffness[3][1] = t79;
        stiffness[3][2] = t80;
        stiffness[3][3] = t79;
        stiffness[3][4] = a_y * t60 + t50 * t67 + c_y * t69 + t87;
        stiffness[3][5] = t81;
        stiffness[3][6] = t80;
        stiffness[3][7] = t81;
        stiffness[3][8] = a_z * t61 + t51 * t68 + c_z * t70 + t87;
        stiffness[4][0] = t44 + c_x * t71;
        stiffness[4][1] = c_x * t72;
        stiffness[4][2] = c_x * t73;
        stiffness[4][3] = c_y * t71;
        stiffness[4][4] = t44 + c_y * t72;
        stiffness[4][5] = c_y * t73;
        stiffness[4][6] = c_z * t71;
        stiffness[4][7] = c_z * t72;
        stiffness[4][8] = t44 + c_z * t73;
        stiffness[5][0] = a_x * t64 + b_x * t71 + t52 * (t39 * t52) + t88;
        stiffness[5][1] = t82;
        stiffness[5][2] = t83;
        stiffness[5][3] = t82;
        stiffness[5][4] = a_y * t65 + b_y * t72 + t53 * t74 + t88;
        stiffness[5][5] = t84;
        stiffness[5][6] = t83;
        stiffness[5][7] = t84;
        stiffness[5][8] = a_z * t66 + b_z * t73 + t54 * t75 + t88;
    }
    /// Writes the strain energy a, b, c at a point of weight one on the unit element, for the terms that are integrated with 3 points; fields are derivatives on the unit element.
    ///
    /// Operations: 26 additions, 41 multiplications.
    pub fn beam_spatial_curved_points3_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 6],
        fields: &[[f64; 3]; 3],
        energy: &mut f64,
    ) {
        let BeamSpatialCurved {
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
            ..
        } = *row;
        let [[a_x, a_y, a_z], [b_x, b_y, b_z], [c_x, c_y, c_z]] = *fields;
        let t35 = 0.5 * (length * EA);
        let t36 = (0.5 * (a_x * a_x + a_y * a_y + a_z * a_z - 1.0) - reference[0])
            .powi(2);
        let t37 = (0.5 * (b_x * b_x + b_y * b_y + b_z * b_z - 1.0) - reference[1])
            .powi(2);
        let t38 = (0.5 * (c_x * c_x + c_y * c_y + c_z * c_z - 1.0) - reference[2])
            .powi(2);
        let t39 = 0.5 * (length * kyGA)
            * (a_x * b_x + a_y * b_y + a_z * b_z - reference[3]).powi(2);
        let t40 = 0.5 * (length * kzGA)
            * (a_x * c_x + a_y * c_y + a_z * c_z - reference[4]).powi(2);
        let t41 = 0.5 * (length * GA)
            * (b_x * c_x + b_y * c_y + b_z * c_z - reference[5]).powi(2);
        *energy = t35 * t36 + t35 * t37 + t35 * t38 + t39 + t40 + t41;
    }
    /// Writes the forces on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 39 additions, 79 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 5],
        fields: &[[f64; 3]; 5],
        forces: &mut [[f64; 3]; 5],
    ) {
        let BeamSpatialCurved {
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
        let t48 = length * EIz * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]);
        let t49 = length * EIy * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]);
        let t50 = length * GIz * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]);
        let t51 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t52 = length * GJ * (0.5 * t51 - reference[2]);
        let t53 = -0.5 * t52;
        let t54 = 0.5 * t52;
        let t55 = length * GIy * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]);
        forces[0][0] = db_x * t48 + dc_x * t49;
        forces[0][1] = db_y * t48 + dc_y * t49;
        forces[0][2] = db_z * t48 + dc_z * t49;
        forces[1][0] = db_x * t50 + dc_x * t53;
        forces[1][1] = db_y * t50 + dc_y * t53;
        forces[1][2] = db_z * t50 + dc_z * t53;
        forces[2][0] = db_x * t54 + dc_x * t55;
        forces[2][1] = db_y * t54 + dc_y * t55;
        forces[2][2] = db_z * t54 + dc_z * t55;
        forces[3][0] = inverse_length * (a_x * t48 + b_x * t50 + c_x * t54);
        forces[3][1] = inverse_length * (a_y * t48 + b_y * t50 + c_y * t54);
        forces[3][2] = inverse_length * (a_z * t48 + b_z * t50 + c_z * t54);
        forces[4][0] = inverse_length * (a_x * t49 + b_x * t53 + c_x * t55);
        forces[4][1] = inverse_length * (a_y * t49 + b_y * t53 + c_y * t55);
        forces[4][2] = inverse_length * (a_z * t49 + b_z * t53 + c_z * t55);
    }
    /// Writes the blocks of the tangent on the fields a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 141 additions, 425 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 5],
        fields: &[[f64; 3]; 5],
        stiffness: &mut [[f64; 9]; 15],
    ) {
        let BeamSpatialCurved {
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
        let t48 = length * EIz;
        let t49 = length * EIy;
        let t50 = length * GJ;
        let t51 = 0.5 * t50;
        let t52 = length * GIz;
        let t53 = length * GIy;
        let t54 = t50 * (-0.5);
        let t55 = -0.5 * t54;
        let t56 = -0.5 * t51;
        let t57 = 0.5 * t54;
        let t58 = 0.5 * t51;
        let t59 = t48 * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]);
        let t60 = t49 * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]);
        let t61 = t52 * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]);
        let t62 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t63 = t50 * (0.5 * t62 - reference[2]);
        let t64 = -0.5 * t63;
        let t65 = 0.5 * t63;
        let t66 = t53 * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]);
        let t67 = db_x * t48;
        let t68 = db_y * t48;
        let t69 = db_z * t48;
        let t70 = a_x * t48;
        let t71 = a_y * t48;
        let t72 = a_z * t48;
        let t73 = dc_x * t49;
        let t74 = dc_y * t49;
        let t75 = dc_z * t49;
        let t76 = a_x * t49;
        let t77 = a_y * t49;
        let t78 = a_z * t49;
        let t79 = db_x * t52;
        let t80 = db_y * t52;
        let t81 = db_z * t52;
        let t82 = b_x * t52;
        let t83 = b_y * t52;
        let t84 = b_z * t52;
        let t85 = dc_x * t55;
        let t86 = dc_y * t55;
        let t87 = dc_z * t55;
        let t88 = db_x * t56;
        let t89 = db_y * t56;
        let t90 = db_z * t56;
        let t91 = c_x * t56;
        let t92 = c_y * t56;
        let t93 = c_z * t56;
        let t94 = b_x * t55;
        let t95 = b_y * t55;
        let t96 = b_z * t55;
        let t97 = dc_x * t57;
        let t98 = dc_y * t57;
        let t99 = dc_z * t57;
        let t100 = db_x * t58;
        let t101 = db_y * t58;
        let t102 = db_z * t58;
        let t103 = c_x * t58;
        let t104 = c_y * t58;
        let t105 = c_z * t58;
        let t106 = b_x * t57;
        let t107 = b_y * t57;
        let t108 = b_z * t57;
        let t109 = dc_x * t53;
        let t110 = dc_y * t53;
        let t111 = dc_z * t53;
        let t112 = c_x * t53;
        let t113 = c_y * t53;
        let t114 = c_z * t53;
        let t115 = inverse_length * inverse_length;
        stiffness[0][0] = db_x * t67 + dc_x * t73;
        stiffness[0][1] = db_x * t68 + dc_x * t74;
        stiffness[0][2] = db_x * t69 + dc_x * t75;
        stiffness[0][3] = db_y * t67 + dc_y * t73;
        stiffness[0][4] = db_y * t68 + dc_y * t74;
        stiffness[0][5] = db_y * t69 + dc_y * t75;
        stiffness[0][6] = db_z * t67 + dc_z * t73;
        stiffness[0][7] = db_z * t68 + dc_z * t74;
        stiffness[0][8] = db_z * t69 + dc_z * t75;
        stiffness[1][0] = inverse_length * (t59 + db_x * t70);
        stiffness[1][1] = inverse_length * (db_x * t71);
        stiffness[1][2] = inverse_length * (db_x * t72);
        stiffness[1][3] = inverse_length * (db_y * t70);
        stiffness[1][4] = inverse_length * (t59 + db_y * t71);
        stiffness[1][5] = inverse_length * (db_y * t72);
        stiffness[1][6] = inverse_length * (db_z * t70);
        stiffness[1][7] = inverse_length * (db_z * t71);
        stiffness[1][8] = inverse_length * (t59 + db_z * t72);
        stiffness[2][0] = inverse_length * (t60 + dc_x * t76);
        stiffness[2][1] = inverse_length * (dc_x * t77);
        stiffness[2][2] = inverse_length * (dc_x * t78);
        stiffness[2][3] = inverse_length * (dc_y * t76);
        stiffness[2][4] = inverse_length * (t60 + dc_y * t77);
        stiffness[2][5] = inverse_length * (dc_y * t78);
        stiffness[2][6] = inverse_length * (dc_z * t76);
        stiffness[2][7] = inverse_length * (dc_z * t77);
        stiffness[2][8] = inverse_length * (t60 + dc_z * t78);
        stiffness[3][0] = db_x * t79 + dc_x * t85;
        stiffness[3][1] = db_x * t80 + dc_x * t86;
        stiffness[3][2] = db_x * t81 + dc_x * t87;
        stiffness[3][3] = db_y * t79 + dc_y * t85;
        stiffness[3][4] = db_y * t80 + dc_y * t86;
        stiffness[3][5] = db_y * t81 + dc_y * t87;
        stiffness[3][6] = db_z * t79 + dc_z * t85;
        stiffness[3][7] = db_z * t80 + dc_z * t86;
        stiffness[3][8] = db_z * t81 + dc_z * t87;
        stiffness[4][0] = inverse_length * (t61 + (db_x * t82 + dc_x * t91));
        stiffness[4][1] = inverse_length * (db_x * t83 + dc_x * t92);
        stiffness[4][2] = inverse_length * (db_x * t84 + dc_x * t93);
        stiffness[4][3] = inverse_length * (db_y * t82 + dc_y * t91);
        stiffness[4][4] = inverse_length * (t61 + (db_y * t83 + dc_y * t92));
        stiffness[4][5] = inverse_length * (db_y * t84 + dc_y * t93);
        stiffness[4][6] = inverse_length * (db_z * t82 + dc_z * t91);
        stiffness[4][7] = inverse_length * (db_z * t83 + dc_z * t92);
        stiffness[4][8] = inverse_length * (t61 + (db_z * t84 + dc_z * t93));
        stiffness[5][0] = inverse_length * (t61 + (b_x * t79 + c_x * t97));
        stiffness[5][1] = inverse_length * (b_x * t80 + c_x * t98);
        stiffness[5][2] = inverse_length * (b_x * t81 + c_x * t99);
        stiffness[5][3] = inverse_length * (b_y * t79 + c_y * t97);
        stiffness[5][4] = inverse_length * (t61 + (b_y * t80 + c_y * t98));
        stiffness[5][5] = inverse_length * (b_y * t81 + c_y * t99);
        stiffness[5][6] = inverse_length * (b_z * t79 + c_z * t97);
        stiffness[5][7] = inverse_length * (b_z * t80 + c_z * t98);
        stiffness[5][8] = inverse_length * (t61 + (b_z * t81 + c_z * t99));
        stiffness[6][0] = (a_x * t70 + b_x * t82 + c_x * t103) * t115;
        stiffness[6][1] = (a_x * t71 + b_x * t83 + c_x * t104) * t115;
        stiffness[6][2] = (a_x * t72 + b_x * t84 + c_x * t105) * t115;
        stiffness[6][3] = (a_y * t70 + b_y * t82 + c_y * t103) * t115;
        stiffness[6][4] = (a_y * t71 + b_y * t83 + c_y * t104) * t115;
        stiffness[6][5] = (a_y * t72 + b_y * t84 + c_y * t105) * t115;
        stiffness[6][6] = (a_z * t70 + b_z * t82 + c_z * t103) * t115;
        stiffness[6][7] = (a_z * t71 + b_z * t83 + c_z * t104) * t115;
        stiffness[6][8] = (a_z * t72 + b_z * t84 + c_z * t105) * t115;
        stiffness[7][0] = dc_x * t88;
        stiffness[7][1] = dc_x * t89;
        stiffness[7][2] = dc_x * t90;
        stiffness[7][3] = dc_y * t88;
        stiffness[7][4] = dc_y * t89;
        stiffness[7][5] = dc_y * t90;
        stiffness[7][6] = dc_z * t88;
        stiffness[7][7] = dc_z * t89;
        stiffness[7][8] = dc_z * t90;
        stiffness[8][0] = inverse_length * (t64 + dc_x * t94);
        stiffness[8][1] = inverse_length * (dc_x * t95);
        stiffness[8][2] = inverse_length * (dc_x * t96);
        stiffness[8][3] = inverse_length * (dc_y * t94);
        stiffness[8][4] = inverse_length * (t64 + dc_y * t95);
        stiffness[8][5] = inverse_length * (dc_y * t96);
        stiffness[8][6] = inverse_length * (dc_z * t94);
        stiffness[8][7] = inverse_length * (dc_z * t95);
        stiffness[8][8] = inverse_length * (t64 + dc_z * t96);
        stiffness[9][0] = inverse_length * (t65 + c_x * t100);
        stiffness[9][1] = inverse_length * (c_x * t101);
        stiffness[9][2] = inverse_length * (c_x * t102);
        stiffness[9][3] = inverse_length * (c_y * t100);
        stiffness[9][4] = inverse_length * (t65 + c_y * t101);
        stiffness[9][5] = inverse_length * (c_y * t102);
        stiffness[9][6] = inverse_length * (c_z * t100);
        stiffness[9][7] = inverse_length * (c_z * t101);
        stiffness[9][8] = inverse_length * (t65 + c_z * t102);
        stiffness[10][0] = c_x * t106 * t115;
        stiffness[10][1] = c_x * t107 * t115;
        stiffness[10][2] = c_x * t108 * t115;
        stiffness[10][3] = c_y * t106 * t115;
        stiffness[10][4] = c_y * t107 * t115;
        stiffness[10][5] = c_y * t108 * t115;
        stiffness[10][6] = c_z * t106 * t115;
        stiffness[10][7] = c_z * t107 * t115;
        stiffness[10][8] = c_z * t108 * t115;
        stiffness[11][0] = db_x * t100 + dc_x * t109;
        stiffness[11][1] = db_x * t101 + dc_x * t110;
        stiffness[11][2] = db_x * t102 + dc_x * t111;
        stiffness[11][3] = db_y * t100 + dc_y * t109;
        stiffness[11][4] = db_y * t101 + dc_y * t110;
        stiffness[11][5] = db_y * t102 + dc_y * t111;
        stiffness[11][6] = db_z * t100 + dc_z * t109;
        stiffness[11][7] = db_z * t101 + dc_z * t110;
        stiffness[11][8] = db_z * t102 + dc_z * t111;
        stiffness[12][0] = inverse_length * (t66 + (db_x * t106 + dc_x * t112));
        stiffness[12][1] = inverse_length * (db_x * t107 + dc_x * t113);
        stiffness[12][2] = inverse_length * (db_x * t108 + dc_x * t114);
        stiffness[12][3] = inverse_length * (db_y * t106 + dc_y * t112);
        stiffness[12][4] = inverse_length * (t66 + (db_y * t107 + dc_y * t113));
        stiffness[12][5] = inverse_length * (db_y * t108 + dc_y * t114);
        stiffness[12][6] = inverse_length * (db_z * t106 + dc_z * t112);
        stiffness[12][7] = inverse_length * (db_z * t107 + dc_z * t113);
        stiffness[12][8] = inverse_length * (t66 + (db_z * t108 + dc_z * t114));
        stiffness[13][0] = inverse_length * (t66 + (b_x * t88 + c_x * t109));
        stiffness[13][1] = inverse_length * (b_x * t89 + c_x * t110);
        stiffness[13][2] = inverse_length * (b_x * t90 + c_x * t111);
        stiffness[13][3] = inverse_length * (b_y * t88 + c_y * t109);
        stiffness[13][4] = inverse_length * (t66 + (b_y * t89 + c_y * t110));
        stiffness[13][5] = inverse_length * (b_y * t90 + c_y * t111);
        stiffness[13][6] = inverse_length * (b_z * t88 + c_z * t109);
        stiffness[13][7] = inverse_length * (b_z * t89 + c_z * t110);
        stiffness[13][8] = inverse_length * (t66 + (b_z * t90 + c_z * t111));
        stiffness[14][0] = (a_x * t76 + b_x * t94 + c_x * t112) * t115;
        stiffness[14][1] = (a_x * t77 + b_x * t95 + c_x * t113) * t115;
        stiffness[14][2] = (a_x * t78 + b_x * t96 + c_x * t114) * t115;
        stiffness[14][3] = (a_y * t76 + b_y * t94 + c_y * t112) * t115;
        stiffness[14][4] = (a_y * t77 + b_y * t95 + c_y * t113) * t115;
        stiffness[14][5] = (a_y * t78 + b_y * t96 + c_y * t114) * t115;
        stiffness[14][6] = (a_z * t76 + b_z * t94 + c_z * t112) * t115;
        stiffness[14][7] = (a_z * t77 + b_z * t95 + c_z * t113) * t115;
        stiffness[14][8] = (a_z * t78 + b_z * t96 + c_z * t114) * t115;
    }
    /// Writes the strain energy a, b, c, db, dc at a point of weight one on the unit element, for the terms that are integrated with 2 points; fields are derivatives on the unit element.
    ///
    /// Operations: 22 additions, 45 multiplications, 1 divisions.
    pub fn beam_spatial_curved_points2_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 5],
        fields: &[[f64; 3]; 5],
        energy: &mut f64,
    ) {
        let BeamSpatialCurved {
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
        let t48 = c_x * db_x + c_y * db_y + c_z * db_z
            - (b_x * dc_x + b_y * dc_y + b_z * dc_z);
        let t49 = 0.5 * (length * EIz)
            * (a_x * db_x + a_y * db_y + a_z * db_z - reference[0]).powi(2);
        let t50 = 0.5 * (length * EIy)
            * (a_x * dc_x + a_y * dc_y + a_z * dc_z - reference[1]).powi(2);
        let t51 = 0.5 * (length * GIz)
            * (b_x * db_x + b_y * db_y + b_z * db_z - reference[3]).powi(2);
        let t52 = t49 + t50 + 0.5 * (length * GJ) * (0.5 * t48 - reference[2]).powi(2)
            + t51;
        let t53 = 0.5 * (length * GIy)
            * (c_x * dc_x + c_y * dc_y + c_z * dc_z - reference[4]).powi(2);
        *energy = t52 + t53;
    }
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 537 additions, 710 multiplications, 2 divisions.
    pub fn beam_spatial_curved_elastic_force(
        row: &BeamSpatialCurved,
        reference: &[f64; 28],
        q: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut sums = Default::default();
        BEAM_SPATIAL_CURVED_POINTS3
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_curved_points3_force(
                    row,
                    ::rncf::mesh::array(&reference[0 + 6 * point..][..6]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_CURVED_POINTS2
            .force(
                &vectors,
                &vectors,
                |point, fields, rates, forces| beam_spatial_curved_points2_force(
                    row,
                    ::rncf::mesh::array(&reference[18 + 5 * point..][..5]),
                    fields,
                    forces,
                ),
                &mut sums,
            );
        BEAM_SPATIAL_CURVED_VECTORS.add_force(row.length, &sums, force);
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 4566 additions, 5377 multiplications, 2 divisions.
    pub fn beam_spatial_curved_elastic_tangent(
        row: &BeamSpatialCurved,
        reference: &[f64; 28],
        q: &[f64; 30],
        stiffness: &mut [f64; 900],
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        let mut tiles = [[[0.0; 9]; 9]; 6];
        BEAM_SPATIAL_CURVED_POINTS3
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_CURVED_POINTS3_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_curved_points3_tangent(
                    row,
                    ::rncf::mesh::array(&reference[0 + 6 * point..][..6]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_CURVED_POINTS2
            .tangent(
                &vectors,
                (&BEAM_SPATIAL_CURVED_POINTS2_STIFFNESS, &mut tiles),
                |point, fields, stiffness| beam_spatial_curved_points2_tangent(
                    row,
                    ::rncf::mesh::array(&reference[18 + 5 * point..][..5]),
                    fields,
                    stiffness,
                ),
            );
        BEAM_SPATIAL_CURVED_VECTORS.add_symmetric(row.length, &tiles, stiffness);
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 and 2 Gauss points, one kernel of the fields at a point for each rule.
    ///
    /// Operations: 298 additions, 389 multiplications, 2 divisions.
    pub fn beam_spatial_curved_strain_energy(
        row: &BeamSpatialCurved,
        reference: &[f64; 28],
        q: &[f64; 30],
        energy: &mut f64,
    ) {
        let vectors = BEAM_SPATIAL_CURVED_VECTORS.relative(row.length, q);
        *energy
            += BEAM_SPATIAL_CURVED_POINTS3
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_curved_points3_energy(
                            row,
                            ::rncf::mesh::array(&reference[0 + 6 * point..][..6]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
        *energy
            += BEAM_SPATIAL_CURVED_POINTS2
                .integral(
                    &vectors,
                    |point, fields| {
                        let mut density = 0.0;
                        beam_spatial_curved_points2_energy(
                            row,
                            ::rncf::mesh::array(&reference[18 + 5 * point..][..5]),
                            fields,
                            &mut density,
                        );
                        density
                    },
                );
    }
    /// Values of one element in the stress-free shape, which the other kernels subtract.
    ///
    /// Beam with a cross-section: axial strain, shear, bending, torsion; coupling = none.
    ///
    /// U = sum over points of weight * length * density; stress S = d(density)/dI on the inner products I of the fields, force S dI/dq. 3 Gauss points, unrolled.
    ///
    /// Operations: 176 additions, 251 multiplications, 1 divisions.
    pub fn beam_spatial_curved_reference(
        row: &BeamSpatialCurved,
        q: &[f64; 30],
        reference: &mut [f64; 28],
    ) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
        let [r0_x, r0_y, r0_z, r0x_x, r0x_y, r0x_z, r0y_x, r0y_y, r0y_z, r0z_x, r0z_y,
        r0z_z, ry_half_x, ry_half_y, ry_half_z, rz_half_x, rz_half_y, rz_half_z, r1_x,
        r1_y, r1_z, r1x_x, r1x_y, r1x_z, r1y_x, r1y_y, r1y_z, r1z_x, r1z_y, r1z_z] = *q;
        let inverse_length = 1.0 / length;
        let d_x = inverse_length * (r1_x - r0_x);
        let d_y = inverse_length * (r1_y - r0_y);
        let d_z = inverse_length * (r1_z - r0_z);
        let t50 = d_x * 0.6;
        let t51 = d_y * 0.6;
        let t52 = d_z * 0.6;
        let t53 = r0x_x * 0.5872983346207417 + t50 + r1x_x * (-0.18729833462074166);
        let t54 = r0x_y * 0.5872983346207417 + t51 + r1x_y * (-0.18729833462074166);
        let t55 = r0x_z * 0.5872983346207417 + t52 + r1x_z * (-0.18729833462074166);
        let t56 = ry_half_x * 0.39999999999999997;
        let t57 = ry_half_y * 0.39999999999999997;
        let t58 = ry_half_z * 0.39999999999999997;
        let t59 = r0y_x * 0.6872983346207417 + t56 + r1y_x * (-0.08729833462074169);
        let t60 = r0y_y * 0.6872983346207417 + t57 + r1y_y * (-0.08729833462074169);
        let t61 = r0y_z * 0.6872983346207417 + t58 + r1y_z * (-0.08729833462074169);
        let t62 = rz_half_x * 0.39999999999999997;
        let t63 = rz_half_y * 0.39999999999999997;
        let t64 = rz_half_z * 0.39999999999999997;
        let t65 = r0z_x * 0.6872983346207417 + t62 + r1z_x * (-0.08729833462074169);
        let t66 = r0z_y * 0.6872983346207417 + t63 + r1z_y * (-0.08729833462074169);
        let t67 = r0z_z * 0.6872983346207417 + t64 + r1z_z * (-0.08729833462074169);
        let t68 = r0x_x * (-0.25) + d_x * 1.5 + r1x_x * (-0.25);
        let t69 = r0x_y * (-0.25) + d_y * 1.5 + r1x_y * (-0.25);
        let t70 = r0x_z * (-0.25) + d_z * 1.5 + r1x_z * (-0.25);
        let t71 = t50 + r0x_x * (-0.18729833462074175) + r1x_x * 0.5872983346207418;
        let t72 = t51 + r0x_y * (-0.18729833462074175) + r1x_y * 0.5872983346207418;
        let t73 = t52 + r0x_z * (-0.18729833462074175) + r1x_z * 0.5872983346207418;
        let t74 = t56 + r0y_x * (-0.08729833462074166) + r1y_x * 0.6872983346207417;
        let t75 = t57 + r0y_y * (-0.08729833462074166) + r1y_y * 0.6872983346207417;
        let t76 = t58 + r0y_z * (-0.08729833462074166) + r1y_z * 0.6872983346207417;
        let t77 = t62 + r0z_x * (-0.08729833462074166) + r1z_x * 0.6872983346207417;
        let t78 = t63 + r0z_y * (-0.08729833462074166) + r1z_y * 0.6872983346207417;
        let t79 = t64 + r0z_z * (-0.08729833462074166) + r1z_z * 0.6872983346207417;
        let t80 = d_x + r0x_x * 0.28867513459481287 + r1x_x * (-0.2886751345948129);
        let t81 = d_y + r0x_y * 0.28867513459481287 + r1x_y * (-0.2886751345948129);
        let t82 = d_z + r0x_z * 0.28867513459481287 + r1x_z * (-0.2886751345948129);
        let t83 = ry_half_x * 0.6666666666666667;
        let t84 = ry_half_y * 0.6666666666666667;
        let t85 = ry_half_z * 0.6666666666666667;
        let t86 = r0y_x * 0.4553418012614795 + t83 + r1y_x * (-0.12200846792814622);
        let t87 = r0y_y * 0.4553418012614795 + t84 + r1y_y * (-0.12200846792814622);
        let t88 = r0y_z * 0.4553418012614795 + t85 + r1y_z * (-0.12200846792814622);
        let t89 = rz_half_x * 0.6666666666666667;
        let t90 = rz_half_y * 0.6666666666666667;
        let t91 = rz_half_z * 0.6666666666666667;
        let t92 = r0z_x * 0.4553418012614795 + t89 + r1z_x * (-0.12200846792814622);
        let t93 = r0z_y * 0.4553418012614795 + t90 + r1z_y * (-0.12200846792814622);
        let t94 = r0z_z * 0.4553418012614795 + t91 + r1z_z * (-0.12200846792814622);
        let t95 = inverse_length
            * (r0y_x * (-2.1547005383792515) + ry_half_x * 2.309401076758503
                + r1y_x * (-0.15470053837925146));
        let t96 = inverse_length
            * (r0y_y * (-2.1547005383792515) + ry_half_y * 2.309401076758503
                + r1y_y * (-0.15470053837925146));
        let t97 = inverse_length
            * (r0y_z * (-2.1547005383792515) + ry_half_z * 2.309401076758503
                + r1y_z * (-0.15470053837925146));
        let t98 = inverse_length
            * (r0z_x * (-2.1547005383792515) + rz_half_x * 2.309401076758503
                + r1z_x * (-0.15470053837925146));
        let t99 = inverse_length
            * (r0z_y * (-2.1547005383792515) + rz_half_y * 2.309401076758503
                + r1z_y * (-0.15470053837925146));
        let t100 = inverse_length
            * (r0z_z * (-2.1547005383792515) + rz_half_z * 2.309401076758503
                + r1z_z * (-0.15470053837925146));
        let t101 = t92 * t95 + t93 * t96 + t94 * t97
            - (t86 * t98 + t87 * t99 + t88 * t100);
        let t102 = r0x_x * (-0.2886751345948131) + d_x * 1.0000000000000004
            + r1x_x * 0.28867513459481264;
        let t103 = r0x_y * (-0.2886751345948131) + d_y * 1.0000000000000004
            + r1x_y * 0.28867513459481264;
        let t104 = r0x_z * (-0.2886751345948131) + d_z * 1.0000000000000004
            + r1x_z * 0.28867513459481264;
        let t105 = t83 + r0y_x * (-0.12200846792814612) + r1y_x * 0.4553418012614795;
        let t106 = t84 + r0y_y * (-0.12200846792814612) + r1y_y * 0.4553418012614795;
        let t107 = t85 + r0y_z * (-0.12200846792814612) + r1y_z * 0.4553418012614795;
        let t108 = t89 + r0z_x * (-0.12200846792814612) + r1z_x * 0.4553418012614795;
        let t109 = t90 + r0z_y * (-0.12200846792814612) + r1z_y * 0.4553418012614795;
        let t110 = t91 + r0z_z * (-0.12200846792814612) + r1z_z * 0.4553418012614795;
        let t111 = inverse_length
            * (r0y_x * 0.15470053837925146 + ry_half_x * (-2.309401076758503)
                + r1y_x * 2.1547005383792515);
        let t112 = inverse_length
            * (r0y_y * 0.15470053837925146 + ry_half_y * (-2.309401076758503)
                + r1y_y * 2.1547005383792515);
        let t113 = inverse_length
            * (r0y_z * 0.15470053837925146 + ry_half_z * (-2.309401076758503)
                + r1y_z * 2.1547005383792515);
        let t114 = inverse_length
            * (r0z_x * 0.15470053837925146 + rz_half_x * (-2.309401076758503)
                + r1z_x * 2.1547005383792515);
        let t115 = inverse_length
            * (r0z_y * 0.15470053837925146 + rz_half_y * (-2.309401076758503)
                + r1z_y * 2.1547005383792515);
        let t116 = inverse_length
            * (r0z_z * 0.15470053837925146 + rz_half_z * (-2.309401076758503)
                + r1z_z * 2.1547005383792515);
        let t117 = t108 * t111 + t109 * t112 + t110 * t113
            - (t105 * t114 + t106 * t115 + t107 * t116);
        reference[0] = 0.5 * (t53 * t53 + t54 * t54 + t55 * t55 - 1.0);
        reference[1] = 0.5 * (t59 * t59 + t60 * t60 + t61 * t61 - 1.0);
        reference[2] = 0.5 * (t65 * t65 + t66 * t66 + t67 * t67 - 1.0);
        reference[3] = t53 * t59 + t54 * t60 + t55 * t61;
        reference[4] = t53 * t65 + t54 * t66 + t55 * t67;
        reference[5] = t59 * t65 + t60 * t66 + t61 * t67;
        reference[6] = 0.5 * (t68 * t68 + t69 * t69 + t70 * t70 - 1.0);
        reference[7] = 0.5
            * (ry_half_x * ry_half_x + ry_half_y * ry_half_y + ry_half_z * ry_half_z
                - 1.0);
        reference[8] = 0.5
            * (rz_half_x * rz_half_x + rz_half_y * rz_half_y + rz_half_z * rz_half_z
                - 1.0);
        reference[9] = ry_half_x * t68 + ry_half_y * t69 + ry_half_z * t70;
        reference[10] = rz_half_x * t68 + rz_half_y * t69 + rz_half_z * t70;
        reference[11] = ry_half_x * rz_half_x + ry_half_y * rz_half_y
            + ry_half_z * rz_half_z;
        reference[12] = 0.5 * (t71 * t71 + t72 * t72 + t73 * t73 - 1.0);
        reference[13] = 0.5 * (t74 * t74 + t75 * t75 + t76 * t76 - 1.0);
        reference[14] = 0.5 * (t77 * t77 + t78 * t78 + t79 * t79 - 1.0);
        reference[15] = t71 * t74 + t72 * t75 + t73 * t76;
        reference[16] = t71 * t77 + t72 * t78 + t73 * t79;
        reference[17] = t74 * t77 + t75 * t78 + t76 * t79;
        reference[18] = t80 * t95 + t81 * t96 + t82 * t97;
        reference[19] = t80 * t98 + t81 * t99 + t82 * t100;
        reference[20] = 0.5 * t101;
        reference[21] = t86 * t95 + t87 * t96 + t88 * t97;
        reference[22] = t92 * t98 + t93 * t99 + t94 * t100;
        reference[23] = t102 * t111 + t103 * t112 + t104 * t113;
        reference[24] = t102 * t114 + t103 * t115 + t104 * t116;
        reference[25] = 0.5 * t117;
        reference[26] = t105 * t111 + t106 * t112 + t107 * t113;
        reference[27] = t108 * t114 + t109 * t115 + t110 * t116;
    }
    /// Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 0 additions, 22 multiplications.
    pub fn beam_spatial_curved_mass(row: &BeamSpatialCurved, mass: &mut [f64; 100]) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    pub fn beam_spatial_curved_inertia_force(
        row: &BeamSpatialCurved,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 30],
        v: &[f64; 30],
        a: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    pub fn beam_spatial_curved_inertia_tangent(
        row: &BeamSpatialCurved,
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 900],
        damping_matrix: &mut [f64; 900],
    ) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    pub fn beam_spatial_curved_absolute_inertia_force(
        row: &BeamSpatialCurved,
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 30],
        force: &mut [f64; 30],
    ) {
        let BeamSpatialCurved { length, rhoA, rhoIz, rhoIy, .. } = *row;
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
    pub fn beam_spatial_curved_shapes_position_0(
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
    pub fn beam_spatial_curved_shapes_position_1(
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
    pub fn beam_spatial_curved_shapes_position_2(
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
    pub fn beam_spatial_curved_shapes_section_y_0(
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
    pub fn beam_spatial_curved_shapes_section_y_1(
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
    pub fn beam_spatial_curved_shapes_section_y_2(
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
    pub fn beam_spatial_curved_shapes_section_z_0(
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
    pub fn beam_spatial_curved_shapes_section_z_1(
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
    pub fn beam_spatial_curved_shapes_section_z_2(
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
    pub fn beam_spatial_curved_field_forces(
        row: &BeamSpatialCurved,
        stress_free: &[f64; 15],
        fields: &[f64; 15],
        forces: &mut [f64; 15],
    ) {
        let BeamSpatialCurved {
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
            ..
        } = *row;
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
    /// Motion of frame `hub` and its first three derivatives.
    ///
    /// Operations: 9 additions, 17 multiplications, 6 divisions, 4 function calls.
    pub fn frame_hub(
        model: &super::CurvedOutOfPlane,
        t: f64,
        motion: &mut ::rncf::mesh::FrameMotion,
    ) {
        *motion = ::rncf::mesh::FrameMotion::INERTIAL;
        let t18 = model.omega_s / model.T_s;
        let t19 = (model.T_s / 6.283185307179586).powi(2);
        let t20 = t * 6.283185307179586 / model.T_s;
        let t21 = t20.cos();
        let theta = (if t <= model.T_s {
            t18 * (t * t / 2.0 + t19 * (t21 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t23 = theta.cos();
        let t24 = theta.sin();
        let t25 = 6.283185307179586 / model.T_s;
        let t26 = t25 * t20.sin();
        let theta_t = (if t <= model.T_s {
            t18 * (t - t19 * t26)
        } else {
            model.omega_s
        });
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
        motion.spin[2] = theta_t;
        motion.spin_rate[2] = theta_t_t;
        motion.spin_jerk[2] = theta_t_t_t;
        motion.rotation[0][0] = t23;
        motion.rotation[0][1] = -t24;
        motion.rotation[1][0] = t24;
        motion.rotation[1][1] = t23;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 11 additions, 12 multiplications.
    pub fn joint_root_referenced_position(
        model: &super::CurvedOutOfPlane,
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
    pub fn joint_root_referenced_velocity(
        model: &super::CurvedOutOfPlane,
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
    pub fn joint_root_referenced_acceleration(
        model: &super::CurvedOutOfPlane,
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
    pub fn joint_root_referenced_jerk(
        model: &super::CurvedOutOfPlane,
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
    pub fn joint_root_referenced_jacobian(
        model: &super::CurvedOutOfPlane,
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
    pub fn joint_root_referenced_prescribed(
        model: &super::CurvedOutOfPlane,
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
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 25 additions, 38 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_position(
        model: &super::CurvedOutOfPlane,
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
            model.omega_s / model.T_s * t42
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t44 = theta.cos();
        let t45 = theta.sin();
        let t46 = q[3] * (t44 * data.normals[0][0] - t45 * data.normals[0][1])
            + q[4] * (t45 * data.normals[0][0] + t44 * data.normals[0][1]);
        let t47 = q[3] * (t44 * data.normals[1][0] - t45 * data.normals[1][1])
            + q[4] * (t45 * data.normals[1][0] + t44 * data.normals[1][1]);
        let t48 = q[6] * (t44 * data.second[1][0] - t45 * data.second[1][1])
            + q[7] * (t45 * data.second[1][0] + t44 * data.second[1][1]);
        let t49 = q[6] * (t44 * data.second[2][0] - t45 * data.second[2][1])
            + q[7] * (t45 * data.second[2][0] + t44 * data.second[2][1]);
        rows[0] = q[0] - (t44 * data.point[0] - t45 * data.point[1]);
        rows[1] = q[1] - (t45 * data.point[0] + t44 * data.point[1]);
        rows[2] = q[2] - data.point[2];
        rows[3] = t46 + data.normals[0][2] * q[5];
        rows[4] = t47 + data.normals[1][2] * q[5];
        rows[5] = t48 + data.second[1][2] * q[8];
        rows[6] = t49 + data.second[2][2] * q[8];
    }
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 20 additions, 39 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_velocity(
        model: &super::CurvedOutOfPlane,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t32 = model.omega_s / model.T_s;
        let t33 = (model.T_s / 6.283185307179586).powi(2);
        let t34 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t32 * (t * t / 2.0 + t33 * (t34.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t36 = (if t <= model.T_s {
            t32 * (t - t33 * (6.283185307179586 / model.T_s * t34.sin()))
        } else {
            model.omega_s
        });
        let t37 = theta.sin() * t36;
        let t38 = theta.cos() * t36;
        let t39 = q[4] * (data.normals[0][0] * t38 - data.normals[0][1] * t37)
            - q[3] * (data.normals[0][0] * t37 + data.normals[0][1] * t38);
        let t40 = q[4] * (data.normals[1][0] * t38 - data.normals[1][1] * t37)
            - q[3] * (data.normals[1][0] * t37 + data.normals[1][1] * t38);
        let t41 = q[7] * (data.second[1][0] * t38 - data.second[1][1] * t37)
            - q[6] * (data.second[1][0] * t37 + data.second[1][1] * t38);
        let t42 = q[7] * (data.second[2][0] * t38 - data.second[2][1] * t37)
            - q[6] * (data.second[2][0] * t37 + data.second[2][1] * t38);
        rows[0] = data.point[0] * t37 + data.point[1] * t38;
        rows[1] = data.point[1] * t37 - data.point[0] * t38;
        rows[2] = 0.0;
        rows[3] = t39;
        rows[4] = t40;
        rows[5] = t41;
        rows[6] = t42;
    }
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 48 additions, 71 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_acceleration(
        model: &super::CurvedOutOfPlane,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t36 = model.omega_s / model.T_s;
        let t37 = (model.T_s / 6.283185307179586).powi(2);
        let t38 = t * 6.283185307179586 / model.T_s;
        let t39 = t38.cos();
        let theta = (if t <= model.T_s {
            t36 * (t * t / 2.0 + t37 * (t39 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t41 = theta.cos();
        let t42 = theta.sin();
        let t43 = 6.283185307179586 / model.T_s;
        let t44 = (if t <= model.T_s {
            t36 * (t - t37 * (t43 * t38.sin()))
        } else {
            model.omega_s
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
        let t50 = v[3] * (data.normals[0][0] * t45 + data.normals[0][1] * t46);
        let t51 = v[4] * (data.normals[0][0] * t46 - data.normals[0][1] * t45);
        let t52 = v[3] * (data.normals[1][0] * t45 + data.normals[1][1] * t46);
        let t53 = v[4] * (data.normals[1][0] * t46 - data.normals[1][1] * t45);
        let t54 = v[6] * (data.second[1][0] * t45 + data.second[1][1] * t46);
        let t55 = v[7] * (data.second[1][0] * t46 - data.second[1][1] * t45);
        let t56 = v[6] * (data.second[2][0] * t45 + data.second[2][1] * t46);
        let t57 = v[7] * (data.second[2][0] * t46 - data.second[2][1] * t45);
        let t58 = t51
            + (t51 + q[4] * (data.normals[0][0] * t49 - data.normals[0][1] * t48))
            - (t50
                + (t50 + q[3] * (data.normals[0][0] * t48 + data.normals[0][1] * t49)));
        let t59 = t53
            + (t53 + q[4] * (data.normals[1][0] * t49 - data.normals[1][1] * t48))
            - (t52
                + (t52 + q[3] * (data.normals[1][0] * t48 + data.normals[1][1] * t49)));
        let t60 = t55
            + (t55 + q[7] * (data.second[1][0] * t49 - data.second[1][1] * t48))
            - (t54 + (t54 + q[6] * (data.second[1][0] * t48 + data.second[1][1] * t49)));
        let t61 = t57
            + (t57 + q[7] * (data.second[2][0] * t49 - data.second[2][1] * t48))
            - (t56 + (t56 + q[6] * (data.second[2][0] * t48 + data.second[2][1] * t49)));
        rows[0] = data.point[0] * t48 + data.point[1] * t49;
        rows[1] = data.point[1] * t48 - data.point[0] * t49;
        rows[2] = 0.0;
        rows[3] = t58;
        rows[4] = t59;
        rows[5] = t60;
        rows[6] = t61;
    }
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 87 additions, 105 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_jerk(
        model: &super::CurvedOutOfPlane,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        let t40 = model.omega_s / model.T_s;
        let t41 = (model.T_s / 6.283185307179586).powi(2);
        let t42 = t * 6.283185307179586 / model.T_s;
        let t43 = t42.cos();
        let theta = (if t <= model.T_s {
            t40 * (t * t / 2.0 + t41 * (t43 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t45 = theta.cos();
        let t46 = theta.sin();
        let t47 = 6.283185307179586 / model.T_s;
        let t48 = t47 * t42.sin();
        let t49 = (if t <= model.T_s { t40 * (t - t41 * t48) } else { model.omega_s });
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
        let t60 = a[3] * (data.normals[0][0] * t50 + data.normals[0][1] * t51);
        let t61 = v[3] * (data.normals[0][0] * t53 + data.normals[0][1] * t54);
        let t62 = t60 + t61;
        let t63 = a[4] * (data.normals[0][0] * t51 - data.normals[0][1] * t50);
        let t64 = v[4] * (data.normals[0][0] * t54 - data.normals[0][1] * t53);
        let t65 = t63 + t64;
        let t66 = t63 + t65
            + (t65
                + (t64 + q[4] * (data.normals[0][0] * t59 - data.normals[0][1] * t57)))
            - (t60 + t62
                + (t62
                    + (t61
                        + q[3]
                            * (data.normals[0][0] * t57 + data.normals[0][1] * t59))));
        let t67 = a[3] * (data.normals[1][0] * t50 + data.normals[1][1] * t51);
        let t68 = v[3] * (data.normals[1][0] * t53 + data.normals[1][1] * t54);
        let t69 = t67 + t68;
        let t70 = a[4] * (data.normals[1][0] * t51 - data.normals[1][1] * t50);
        let t71 = v[4] * (data.normals[1][0] * t54 - data.normals[1][1] * t53);
        let t72 = t70 + t71;
        let t73 = t70 + t72
            + (t72
                + (t71 + q[4] * (data.normals[1][0] * t59 - data.normals[1][1] * t57)))
            - (t67 + t69
                + (t69
                    + (t68
                        + q[3]
                            * (data.normals[1][0] * t57 + data.normals[1][1] * t59))));
        let t74 = a[6] * (data.second[1][0] * t50 + data.second[1][1] * t51);
        let t75 = v[6] * (data.second[1][0] * t53 + data.second[1][1] * t54);
        let t76 = t74 + t75;
        let t77 = a[7] * (data.second[1][0] * t51 - data.second[1][1] * t50);
        let t78 = v[7] * (data.second[1][0] * t54 - data.second[1][1] * t53);
        let t79 = t77 + t78;
        let t80 = t77 + t79
            + (t79 + (t78 + q[7] * (data.second[1][0] * t59 - data.second[1][1] * t57)))
            - (t74 + t76
                + (t76
                    + (t75
                        + q[6] * (data.second[1][0] * t57 + data.second[1][1] * t59))));
        let t81 = a[6] * (data.second[2][0] * t50 + data.second[2][1] * t51);
        let t82 = v[6] * (data.second[2][0] * t53 + data.second[2][1] * t54);
        let t83 = t81 + t82;
        let t84 = a[7] * (data.second[2][0] * t51 - data.second[2][1] * t50);
        let t85 = v[7] * (data.second[2][0] * t54 - data.second[2][1] * t53);
        let t86 = t84 + t85;
        let t87 = t84 + t86
            + (t86 + (t85 + q[7] * (data.second[2][0] * t59 - data.second[2][1] * t57)))
            - (t81 + t83
                + (t83
                    + (t82
                        + q[6] * (data.second[2][0] * t57 + data.second[2][1] * t59))));
        rows[0] = data.point[0] * t57 + data.point[1] * t59;
        rows[1] = data.point[1] * t57 - data.point[0] * t59;
        rows[2] = 0.0;
        rows[3] = t66;
        rows[4] = t73;
        rows[5] = t80;
        rows[6] = t87;
    }
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 12 additions, 22 multiplications, 5 divisions, 3 function calls.
    pub fn joint_root_absolute_jacobian(
        model: &super::CurvedOutOfPlane,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        let t30 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t30
        } else {
            model.omega_s * (t - model.T_s / 2.0)
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
        jacobian[30] = t32 * data.normals[0][0] - t33 * data.normals[0][1];
        jacobian[31] = t33 * data.normals[0][0] + t32 * data.normals[0][1];
        jacobian[32] = data.normals[0][2];
        jacobian[33] = 0.0;
        jacobian[34] = 0.0;
        jacobian[35] = 0.0;
        jacobian[36] = 0.0;
        jacobian[37] = 0.0;
        jacobian[38] = 0.0;
        jacobian[39] = t32 * data.normals[1][0] - t33 * data.normals[1][1];
        jacobian[40] = t33 * data.normals[1][0] + t32 * data.normals[1][1];
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
        jacobian[51] = t32 * data.second[1][0] - t33 * data.second[1][1];
        jacobian[52] = t33 * data.second[1][0] + t32 * data.second[1][1];
        jacobian[53] = data.second[1][2];
        jacobian[54] = 0.0;
        jacobian[55] = 0.0;
        jacobian[56] = 0.0;
        jacobian[57] = 0.0;
        jacobian[58] = 0.0;
        jacobian[59] = 0.0;
        jacobian[60] = t32 * data.second[2][0] - t33 * data.second[2][1];
        jacobian[61] = t33 * data.second[2][0] + t32 * data.second[2][1];
        jacobian[62] = data.second[2][2];
    }
    /// Joint `root`: what it prescribes, with three derivatives.
    ///
    /// Operations: 41 additions, 77 multiplications, 6 divisions, 4 function calls.
    pub fn joint_root_absolute_prescribed(
        model: &super::CurvedOutOfPlane,
        t: f64,
        data: &::rncf::mesh::JointData,
        prescribed: &mut ::rncf::mesh::Prescribed,
    ) {
        let t27 = model.omega_s / model.T_s;
        let t28 = (model.T_s / 6.283185307179586).powi(2);
        let t29 = t * 6.283185307179586 / model.T_s;
        let t30 = t29.cos();
        let theta = (if t <= model.T_s {
            t27 * (t * t / 2.0 + t28 * (t30 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t32 = theta.cos();
        let t33 = theta.sin();
        let t34 = 6.283185307179586 / model.T_s;
        let t35 = t34 * t29.sin();
        let t36 = (if t <= model.T_s { t27 * (t - t28 * t35) } else { model.omega_s });
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
        prescribed.position[0][0] = t32 * data.point[0] - t33 * data.point[1];
        prescribed.position[0][1] = t33 * data.point[0] + t32 * data.point[1];
        prescribed.position[0][2] = data.point[2];
        prescribed.position[1][0] = -(data.point[0] * t37 + data.point[1] * t38);
        prescribed.position[1][1] = data.point[0] * t38 - data.point[1] * t37;
        prescribed.position[1][2] = 0.0;
        prescribed.position[2][0] = -(data.point[0] * t40 + data.point[1] * t41);
        prescribed.position[2][1] = data.point[0] * t41 - data.point[1] * t40;
        prescribed.position[2][2] = 0.0;
        prescribed.position[3][0] = -(data.point[0] * t44 + data.point[1] * t46);
        prescribed.position[3][1] = data.point[0] * t46 - data.point[1] * t44;
        prescribed.position[3][2] = 0.0;
        prescribed.slope[0][0] = t32 * data.tangent[0] - t33 * data.tangent[1];
        prescribed.slope[0][1] = t33 * data.tangent[0] + t32 * data.tangent[1];
        prescribed.slope[0][2] = data.tangent[2];
        prescribed.slope[1][0] = -(data.tangent[0] * t37 + data.tangent[1] * t38);
        prescribed.slope[1][1] = data.tangent[0] * t38 - data.tangent[1] * t37;
        prescribed.slope[1][2] = 0.0;
        prescribed.slope[2][0] = -(data.tangent[0] * t40 + data.tangent[1] * t41);
        prescribed.slope[2][1] = data.tangent[0] * t41 - data.tangent[1] * t40;
        prescribed.slope[2][2] = 0.0;
        prescribed.slope[3][0] = -(data.tangent[0] * t44 + data.tangent[1] * t46);
        prescribed.slope[3][1] = data.tangent[0] * t46 - data.tangent[1] * t44;
        prescribed.slope[3][2] = 0.0;
        prescribed.second[0][0] = t32 * data.second[0][0] - t33 * data.second[0][1];
        prescribed.second[0][1] = t33 * data.second[0][0] + t32 * data.second[0][1];
        prescribed.second[0][2] = data.second[0][2];
        prescribed.second[1][0] = -(data.second[0][0] * t37 + data.second[0][1] * t38);
        prescribed.second[1][1] = data.second[0][0] * t38 - data.second[0][1] * t37;
        prescribed.second[1][2] = 0.0;
        prescribed.second[2][0] = -(data.second[0][0] * t40 + data.second[0][1] * t41);
        prescribed.second[2][1] = data.second[0][0] * t41 - data.second[0][1] * t40;
        prescribed.second[2][2] = 0.0;
        prescribed.second[3][0] = -(data.second[0][0] * t44 + data.second[0][1] * t46);
        prescribed.second[3][1] = data.second[0][0] * t46 - data.second[0][1] * t44;
        prescribed.second[3][2] = 0.0;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &super::CurvedOutOfPlane, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 2 additions, 0 multiplications.
    pub fn outputs(
        model: &super::CurvedOutOfPlane,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
        out[0] = observed[0] - 7.670808617667248;
        out[1] = observed[1];
        out[2] = observed[2] - 1.9586790097540359;
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &super::CurvedOutOfPlane, run: &mut ::rncf::RunDefaults) {
        run.t_end = 20.0;
        run.every = 0.05;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::CurvedOutOfPlane,
        pub row_beam: BeamSpatialCurved,
        pub reference_beam: ::std::vec::Vec<[f64; 28]>,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::CurvedOutOfPlane) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
                reference_beam: ::std::vec::Vec::new(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "beam",
                    frame: 1,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Arc {
                        from: [0.0, 0.0, 0.0],
                        direction: [1.0, 0.0, 0.0],
                        normal: [0.0, -1.0, 0.0],
                        radius: 16.0,
                        angle: 0.5,
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
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
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
            2
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "hub"][frame]
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
                "material `aluminium`",
                "density",
                2766.67,
                "kg/m^3",
            )?;
            let young = ::rncf::mesh::positive(
                "material `aluminium`",
                "young",
                68950000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::mesh::poisson(
                "material `aluminium`",
                "poisson",
                0.3,
                "1",
            )?;
            let damping = ::rncf::mesh::non_negative(
                "material `aluminium`",
                "damping",
                0.0,
                "s",
            )?;
            let area = ::rncf::mesh::positive(
                "section `tube`",
                "area",
                7.299e-5,
                "m^2",
            )?;
            let second_moment_y = ::rncf::mesh::positive(
                "section `tube`",
                "second_moment_y",
                8.215e-9,
                "m^4",
            )?;
            let second_moment_z = ::rncf::mesh::positive(
                "section `tube`",
                "second_moment_z",
                8.215e-9,
                "m^4",
            )?;
            let torsion_constant = ::rncf::mesh::positive(
                "section `tube`",
                "torsion_constant",
                1.643e-8,
                "m^4",
            )?;
            let shear_factor_y = ::rncf::mesh::positive(
                "section `tube`",
                "shear_factor_y",
                0.53,
                "1",
            )?;
            let shear_factor_z = ::rncf::mesh::positive(
                "section `tube`",
                "shear_factor_z",
                0.53,
                "1",
            )?;
            let shear_modulus = young / (2.0 * (1.0 + poisson));
            self.row_beam = BeamSpatialCurved {
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
            self.reference_beam = shape
                .chunks_exact(30)
                .map(|shape| {
                    let mut reference = [0.0; 28];
                    beam_spatial_curved_reference(
                        &self.row_beam,
                        ::rncf::mesh::array(shape),
                        &mut reference,
                    );
                    reference
                })
                .collect();
            Ok(())
        }
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
            frame_hub(&self.model, t, &mut motions[1]);
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
            beam_spatial_curved_mass(&self.row_beam, ::rncf::mesh::array_mut(mass));
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
            beam_spatial_curved_elastic_force(
                &self.row_beam,
                &self.reference_beam[element],
                q,
                force,
            );
            if absolute {
                beam_spatial_curved_absolute_inertia_force(
                    &self.row_beam,
                    frame,
                    a,
                    force,
                );
            } else {
                beam_spatial_curved_inertia_force(&self.row_beam, frame, q, v, a, force);
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
            beam_spatial_curved_elastic_tangent(
                &self.row_beam,
                &self.reference_beam[element],
                q,
                stiffness,
            );
            if !absolute {
                beam_spatial_curved_inertia_tangent(
                    &self.row_beam,
                    frame,
                    stiffness,
                    damping_matrix,
                );
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            beam_spatial_curved_strain_energy(
                &self.row_beam,
                &self.reference_beam[element],
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
                    beam_spatial_curved_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 1) => {
                    beam_spatial_curved_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 2) => {
                    beam_spatial_curved_shapes_position_2(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionY, 0) => {
                    beam_spatial_curved_shapes_section_y_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionY, 1) => {
                    beam_spatial_curved_shapes_section_y_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionY, 2) => {
                    beam_spatial_curved_shapes_section_y_2(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionZ, 0) => {
                    beam_spatial_curved_shapes_section_z_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionZ, 1) => {
                    beam_spatial_curved_shapes_section_z_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::SectionZ, 2) => {
                    beam_spatial_curved_shapes_section_z_2(
                        self.row_beam.length,
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
                shape: ::rncf::mesh::SectionShape::General {
                    extent: [None, None],
                },
                area: 7.299e-5,
                second_moments: [8.215e-9, 8.215e-9],
                torsion_constant: 1.643e-8,
                yield_stress: None,
                material: "aluminium",
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
            beam_spatial_curved_field_forces(
                &self.row_beam,
                ::rncf::mesh::array(stress_free),
                ::rncf::mesh::array(fields),
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_root_referenced_velocity(
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
                            joint_root_referenced_acceleration(
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
                            joint_root_referenced_jerk(
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
                (0, false) => {
                    joint_root_referenced_jacobian(&self.model, t, data, jacobian);
                }
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
                (0, false) => {
                    joint_root_referenced_prescribed(&self.model, t, data, prescribed);
                }
                (0, _) => {
                    joint_root_absolute_prescribed(&self.model, t, data, prescribed);
                }
                _ => {}
            }
        }
    }
}
