//! Expansion of `models/src/slider_crank.rs`; refreshed by `cargo run -p rncf-codegen --bin rncf-generate`.

/// Flexible slider-crank (Ren & Yang 2021, section 4.2): a soft connecting rod between a crank that is driven about x
/// and a slider on the x axis.
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

    // A thousand times softer than steel, so that deflections can be seen.
    material soft { density = 7870 kg/m^3; young = 0.2 GPa; poisson = 0.29; damping = damping; }
    section round { area = pi * radius^2; second_moment = pi * radius^4 / 4; }

    /// Angle of the crank, Eqs. (23), (24).
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
        mesh elements * cable(round, soft, bending = exact);
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
    const NOTES: &'static [&'static str] = &[
        "Body `beam` uses `cable_spatial_exact_damped`. Form: loop over points (the cheapest; operations of force and tangent: points unrolled: 795 and 4638; loop over points: 843 and 5093; a loop counts 1.3 times).",
        "Body `beam` moves in the free frame `rod`: force and moment of its inertia on the frame, and their derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        "Frame `rod` is free in three motions: a rotation vector that begins anew every step.",
        "Constraint `root` (pin in absolute coordinates): 3 multipliers; linear in its vectors, no second derivatives.",
        "Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): 1 multiplier; gradient and second derivatives are derived.",
        "Constraint `cross_axis` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Constraint `guide_y` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Constraint `guide_z` (constraint): 1 multiplier; linear in its vectors, no second derivatives.",
        "Fixture `slider` adds constants to the inertia of `beam` and no unknowns.",
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
                components: &[],
                doc: "Position of the slider.",
            },
            ::rncf::Output {
                name: "dx",
                unit: "m",
                components: &[],
                doc: "The same less that of a rigid rod.",
            },
            ::rncf::Output {
                name: "mid",
                unit: "m",
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
        };
        slider_crank_equations::run_defaults(self, &mut run);
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
        let equations = slider_crank_equations::Equations::new(self);
        ::rncf::mesh::build(equations, formulation, joints)
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
    /// Adds the generalised elastic force of one element, F_e = dU/dq (N on positions, N m on slopes).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact.
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
            let t66 = length * table[0];
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
            let t76 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t77 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
            let t78 = a_x * b_x + a_y * b_y + a_z * b_z;
            let t79 = b_x * b_x + b_y * b_y + b_z * b_z;
            let t80 = EI * t66;
            let t81 = t76 * t76;
            let t82 = 1.0 / t81;
            let t83 = 0.5
                * (EA * t66 * (0.5 * (t76 - 1.0) + damping * (0.5 * (t77 + t77))));
            let t84 = t79 * t82 - (t76 * t79 - t78 * t78) * (t82 * (t76 * 2.0) / t81);
            let t85 = t83 + t80 * (0.5 * t84);
            let t86 = t80 * (0.5 * (t82 * (t78 * 2.0)));
            let t87 = t80 * (0.5 * (t76 * t82));
            let t88 = t85 * (a_x * 2.0) - b_x * t86;
            let t89 = t85 * (a_y * 2.0) - b_y * t86;
            let t90 = t85 * (a_z * 2.0) - b_z * t86;
            let t91 = inverse_length * (t87 * (b_x * 2.0) - a_x * t86);
            let t92 = inverse_length * (t87 * (b_y * 2.0) - a_y * t86);
            let t93 = inverse_length * (t87 * (b_z * 2.0) - a_z * t86);
            force_0_0 += table[1] * t88 + table[4] * t91;
            force_0_1 += table[1] * t89 + table[4] * t92;
            force_0_2 += table[1] * t90 + table[4] * t93;
            force_1_0 += table[2] * t88 + table[5] * t91;
            force_1_1 += table[2] * t89 + table[5] * t92;
            force_1_2 += table[2] * t90 + table[5] * t93;
            force_2_0 += table[3] * t88 + table[6] * t91;
            force_2_1 += table[3] * t89 + table[6] * t92;
            force_2_2 += table[3] * t90 + table[6] * t93;
        }
        let t94 = inverse_length * force_1_0;
        let t95 = inverse_length * force_1_1;
        let t96 = inverse_length * force_1_2;
        force[0] -= t94;
        force[1] -= t95;
        force[2] -= t96;
        force[3] += force_0_0;
        force[4] += force_0_1;
        force[5] += force_0_2;
        force[6] += t94;
        force[7] += t95;
        force[8] += t96;
        force[9] += force_2_0;
        force[10] += force_2_1;
        force[11] += force_2_2;
    }
    /// Adds the exact tangent of one element, dF_e/dq (and dF_e/dq' where damped), rows first.
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact.
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
        let t219 = damping * 0.5;
        let t220 = inverse_length * inverse_length;
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
            let t221 = length * table[0];
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
            let t231 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t232 = a_x * v_a_x + a_y * v_a_y + a_z * v_a_z;
            let t233 = a_x * b_x + a_y * b_y + a_z * b_z;
            let t234 = b_x * b_x + b_y * b_y + b_z * b_z;
            let t235 = EA * t221;
            let t236 = EI * t221;
            let t237 = t231 * t234 - t233 * t233;
            let t238 = t231 * t231;
            let t239 = 1.0 / t238;
            let t240 = t231 * 2.0;
            let t241 = t239 * t240 / t238;
            let t242 = t240 * t241;
            let t243 = 2.0 * t239;
            let t244 = t234 * t241;
            let t245 = 0.5 * (0.5 * t235)
                - t236 * (0.5 * (t244 + (t244 + t237 * ((t243 - t242 - t242) / t238))));
            let t246 = t233 * 2.0;
            let t247 = t236 * (0.5 * (t241 * t246));
            let t248 = t236 * (0.5 * (t239 - t231 * t241));
            let t249 = t236 * (0.5 * t243);
            let t250 = 0.5 * (t235 * t219);
            let t251 = 0.5
                * (t235 * (0.5 * (t231 - 1.0) + damping * (0.5 * (t232 + t232))))
                + t236 * (0.5 * (t234 * t239 - t237 * t241));
            let t252 = t236 * (0.5 * (t239 * t246));
            let t253 = a_x * 2.0;
            let t254 = a_y * 2.0;
            let t255 = a_z * 2.0;
            let t256 = t245 * t254 + b_y * t247;
            let t257 = t245 * t255 + b_z * t247;
            let t258 = a_x * t247 + t248 * (b_x * 2.0);
            let t259 = a_y * t247 + t248 * (b_y * 2.0);
            let t260 = a_z * t247 + t248 * (b_z * 2.0);
            let t261 = t247 * t254 - b_y * t249;
            let t262 = t247 * t255 - b_z * t249;
            let t263 = a_x * t249;
            let t264 = a_y * t249;
            let t265 = a_z * t249;
            let t266 = t253 * (t245 * t253 + b_x * t247)
                + b_x * (t247 * t253 - b_x * t249);
            let t267 = t253 * t256 + b_x * t261;
            let t268 = t253 * t257 + b_x * t262;
            let t269 = t254 * t257 + b_y * t262;
            let t270 = 2.0 * t251;
            let t271 = 2.0 * (t236 * (0.5 * (t231 * t239)));
            let t272 = t250 * (v_a_x * 2.0);
            let t273 = t250 * (v_a_y * 2.0);
            let t274 = t250 * (v_a_z * 2.0);
            let t275 = t266 + t270 + t253 * t272;
            let t276 = t267 + t253 * t273;
            let t277 = t268 + t253 * t274;
            let t278 = t267 + t254 * t272;
            let t279 = t254 * t256 + b_y * t261 + t270 + t254 * t273;
            let t280 = t269 + t254 * t274;
            let t281 = t268 + t255 * t272;
            let t282 = t269 + t255 * t273;
            let t283 = t255 * t257 + b_z * t262 + t270 + t255 * t274;
            let t284 = t250 * t253;
            let t285 = t250 * t254;
            let t286 = t250 * t255;
            let t287 = t253 * t284;
            let t288 = t253 * t285;
            let t289 = t253 * t286;
            let t290 = t254 * t284;
            let t291 = t254 * t285;
            let t292 = t254 * t286;
            let t293 = t255 * t284;
            let t294 = t255 * t285;
            let t295 = t255 * t286;
            let t296 = inverse_length * (t253 * t258 - b_x * t263 - t252);
            let t297 = table[1] * t275 + table[4] * t296;
            let t298 = table[2] * t275 + table[5] * t296;
            let t299 = table[3] * t275 + table[6] * t296;
            let t300 = inverse_length * (t253 * t259 - b_x * t264);
            let t301 = table[1] * t276 + table[4] * t300;
            let t302 = table[2] * t276 + table[5] * t300;
            let t303 = table[3] * t276 + table[6] * t300;
            let t304 = inverse_length * (t253 * t260 - b_x * t265);
            let t305 = table[1] * t277 + table[4] * t304;
            let t306 = table[2] * t277 + table[5] * t304;
            let t307 = table[3] * t277 + table[6] * t304;
            let t308 = inverse_length * (t254 * t258 - b_y * t263);
            let t309 = table[1] * t278 + table[4] * t308;
            let t310 = table[2] * t278 + table[5] * t308;
            let t311 = table[3] * t278 + table[6] * t308;
            let t312 = inverse_length * (t254 * t259 - b_y * t264 - t252);
            let t313 = table[1] * t279 + table[4] * t312;
            let t314 = table[2] * t279 + table[5] * t312;
            let t315 = table[3] * t279 + table[6] * t312;
            let t316 = inverse_length * (t254 * t260 - b_y * t265);
            let t317 = table[1] * t280 + table[4] * t316;
            let t318 = table[2] * t280 + table[5] * t316;
            let t319 = table[3] * t280 + table[6] * t316;
            let t320 = inverse_length * (t255 * t258 - b_z * t263);
            let t321 = table[1] * t281 + table[4] * t320;
            let t322 = table[2] * t281 + table[5] * t320;
            let t323 = table[3] * t281 + table[6] * t320;
            let t324 = inverse_length * (t255 * t259 - b_z * t264);
            let t325 = table[1] * t282 + table[4] * t324;
            let t326 = table[2] * t282 + table[5] * t324;
            let t327 = table[3] * t282 + table[6] * t324;
            let t328 = inverse_length * (t255 * t260 - b_z * t265 - t252);
            let t329 = table[1] * t283 + table[4] * t328;
            let t330 = table[2] * t283 + table[5] * t328;
            let t331 = table[3] * t283 + table[6] * t328;
            let t332 = (t271 - a_x * t263) * t220;
            let t333 = table[1] * t296 + table[4] * t332;
            let t334 = table[2] * t296 + table[5] * t332;
            let t335 = table[3] * t296 + table[6] * t332;
            let t336 = a_x * t264 * t220;
            let t337 = table[4] * t336;
            let t338 = table[1] * t308 - t337;
            let t339 = table[5] * t336;
            let t340 = table[2] * t308 - t339;
            let t341 = table[6] * t336;
            let t342 = table[3] * t308 - t341;
            let t343 = a_x * t265 * t220;
            let t344 = table[4] * t343;
            let t345 = table[1] * t320 - t344;
            let t346 = table[5] * t343;
            let t347 = table[2] * t320 - t346;
            let t348 = table[6] * t343;
            let t349 = table[3] * t320 - t348;
            let t350 = table[1] * t300 - t337;
            let t351 = table[2] * t300 - t339;
            let t352 = table[3] * t300 - t341;
            let t353 = (t271 - a_y * t264) * t220;
            let t354 = table[1] * t312 + table[4] * t353;
            let t355 = table[2] * t312 + table[5] * t353;
            let t356 = table[3] * t312 + table[6] * t353;
            let t357 = a_y * t265 * t220;
            let t358 = table[4] * t357;
            let t359 = table[1] * t324 - t358;
            let t360 = table[5] * t357;
            let t361 = table[2] * t324 - t360;
            let t362 = table[6] * t357;
            let t363 = table[3] * t324 - t362;
            let t364 = table[1] * t304 - t344;
            let t365 = table[2] * t304 - t346;
            let t366 = table[3] * t304 - t348;
            let t367 = table[1] * t316 - t358;
            let t368 = table[2] * t316 - t360;
            let t369 = table[3] * t316 - t362;
            let t370 = (t271 - a_z * t265) * t220;
            let t371 = table[1] * t328 + table[4] * t370;
            let t372 = table[2] * t328 + table[5] * t370;
            let t373 = table[3] * t328 + table[6] * t370;
            let t374 = table[1] * t287;
            let t375 = table[2] * t287;
            let t376 = table[3] * t287;
            let t377 = table[1] * t288;
            let t378 = table[2] * t288;
            let t379 = table[3] * t288;
            let t380 = table[1] * t289;
            let t381 = table[2] * t289;
            let t382 = table[3] * t289;
            let t383 = table[1] * t290;
            let t384 = table[2] * t290;
            let t385 = table[3] * t290;
            let t386 = table[1] * t291;
            let t387 = table[2] * t291;
            let t388 = table[3] * t291;
            let t389 = table[1] * t292;
            let t390 = table[2] * t292;
            let t391 = table[3] * t292;
            let t392 = table[1] * t293;
            let t393 = table[2] * t293;
            let t394 = table[3] * t293;
            let t395 = table[1] * t294;
            let t396 = table[2] * t294;
            let t397 = table[3] * t294;
            let t398 = table[1] * t295;
            let t399 = table[2] * t295;
            let t400 = table[3] * t295;
            stiffness_00_00 += table[1] * t297 + table[4] * t333;
            stiffness_00_01 += table[1] * t301 + table[4] * t338;
            stiffness_00_02 += table[1] * t305 + table[4] * t345;
            stiffness_00_10 += table[1] * t309 + table[4] * t350;
            stiffness_00_11 += table[1] * t313 + table[4] * t354;
            stiffness_00_12 += table[1] * t317 + table[4] * t359;
            stiffness_00_20 += table[1] * t321 + table[4] * t364;
            stiffness_00_21 += table[1] * t325 + table[4] * t367;
            stiffness_00_22 += table[1] * t329 + table[4] * t371;
            stiffness_01_00 += table[1] * t298 + table[4] * t334;
            stiffness_01_01 += table[1] * t302 + table[4] * t340;
            stiffness_01_02 += table[1] * t306 + table[4] * t347;
            stiffness_01_10 += table[1] * t310 + table[4] * t351;
            stiffness_01_11 += table[1] * t314 + table[4] * t355;
            stiffness_01_12 += table[1] * t318 + table[4] * t361;
            stiffness_01_20 += table[1] * t322 + table[4] * t365;
            stiffness_01_21 += table[1] * t326 + table[4] * t368;
            stiffness_01_22 += table[1] * t330 + table[4] * t372;
            stiffness_02_00 += table[1] * t299 + table[4] * t335;
            stiffness_02_01 += table[1] * t303 + table[4] * t342;
            stiffness_02_02 += table[1] * t307 + table[4] * t349;
            stiffness_02_10 += table[1] * t311 + table[4] * t352;
            stiffness_02_11 += table[1] * t315 + table[4] * t356;
            stiffness_02_12 += table[1] * t319 + table[4] * t363;
            stiffness_02_20 += table[1] * t323 + table[4] * t366;
            stiffness_02_21 += table[1] * t327 + table[4] * t369;
            stiffness_02_22 += table[1] * t331 + table[4] * t373;
            stiffness_10_00 += table[2] * t297 + table[5] * t333;
            stiffness_10_01 += table[2] * t301 + table[5] * t338;
            stiffness_10_02 += table[2] * t305 + table[5] * t345;
            stiffness_10_10 += table[2] * t309 + table[5] * t350;
            stiffness_10_11 += table[2] * t313 + table[5] * t354;
            stiffness_10_12 += table[2] * t317 + table[5] * t359;
            stiffness_10_20 += table[2] * t321 + table[5] * t364;
            stiffness_10_21 += table[2] * t325 + table[5] * t367;
            stiffness_10_22 += table[2] * t329 + table[5] * t371;
            stiffness_11_00 += table[2] * t298 + table[5] * t334;
            stiffness_11_01 += table[2] * t302 + table[5] * t340;
            stiffness_11_02 += table[2] * t306 + table[5] * t347;
            stiffness_11_10 += table[2] * t310 + table[5] * t351;
            stiffness_11_11 += table[2] * t314 + table[5] * t355;
            stiffness_11_12 += table[2] * t318 + table[5] * t361;
            stiffness_11_20 += table[2] * t322 + table[5] * t365;
            stiffness_11_21 += table[2] * t326 + table[5] * t368;
            stiffness_11_22 += table[2] * t330 + table[5] * t372;
            stiffness_12_00 += table[2] * t299 + table[5] * t335;
            stiffness_12_01 += table[2] * t303 + table[5] * t342;
            stiffness_12_02 += table[2] * t307 + table[5] * t349;
            stiffness_12_10 += table[2] * t311 + table[5] * t352;
            stiffness_12_11 += table[2] * t315 + table[5] * t356;
            stiffness_12_12 += table[2] * t319 + table[5] * t363;
            stiffness_12_20 += table[2] * t323 + table[5] * t366;
            stiffness_12_21 += table[2] * t327 + table[5] * t369;
            stiffness_12_22 += table[2] * t331 + table[5] * t373;
            stiffness_20_00 += table[3] * t297 + table[6] * t333;
            stiffness_20_01 += table[3] * t301 + table[6] * t338;
            stiffness_20_02 += table[3] * t305 + table[6] * t345;
            stiffness_20_10 += table[3] * t309 + table[6] * t350;
            stiffness_20_11 += table[3] * t313 + table[6] * t354;
            stiffness_20_12 += table[3] * t317 + table[6] * t359;
            stiffness_20_20 += table[3] * t321 + table[6] * t364;
            stiffness_20_21 += table[3] * t325 + table[6] * t367;
            stiffness_20_22 += table[3] * t329 + table[6] * t371;
            stiffness_21_00 += table[3] * t298 + table[6] * t334;
            stiffness_21_01 += table[3] * t302 + table[6] * t340;
            stiffness_21_02 += table[3] * t306 + table[6] * t347;
            stiffness_21_10 += table[3] * t310 + table[6] * t351;
            stiffness_21_11 += table[3] * t314 + table[6] * t355;
            stiffness_21_12 += table[3] * t318 + table[6] * t361;
            stiffness_21_20 += table[3] * t322 + table[6] * t365;
            stiffness_21_21 += table[3] * t326 + table[6] * t368;
            stiffness_21_22 += table[3] * t330 + table[6] * t372;
            stiffness_22_00 += table[3] * t299 + table[6] * t335;
            stiffness_22_01 += table[3] * t303 + table[6] * t342;
            stiffness_22_02 += table[3] * t307 + table[6] * t349;
            stiffness_22_10 += table[3] * t311 + table[6] * t352;
            stiffness_22_11 += table[3] * t315 + table[6] * t356;
            stiffness_22_12 += table[3] * t319 + table[6] * t363;
            stiffness_22_20 += table[3] * t323 + table[6] * t366;
            stiffness_22_21 += table[3] * t327 + table[6] * t369;
            stiffness_22_22 += table[3] * t331 + table[6] * t373;
            damping_00_00 += table[1] * t374;
            damping_00_01 += table[1] * t377;
            damping_00_02 += table[1] * t380;
            damping_00_10 += table[1] * t383;
            damping_00_11 += table[1] * t386;
            damping_00_12 += table[1] * t389;
            damping_00_20 += table[1] * t392;
            damping_00_21 += table[1] * t395;
            damping_00_22 += table[1] * t398;
            damping_01_00 += table[1] * t375;
            damping_01_01 += table[1] * t378;
            damping_01_02 += table[1] * t381;
            damping_01_10 += table[1] * t384;
            damping_01_11 += table[1] * t387;
            damping_01_12 += table[1] * t390;
            damping_01_20 += table[1] * t393;
            damping_01_21 += table[1] * t396;
            damping_01_22 += table[1] * t399;
            damping_02_00 += table[1] * t376;
            damping_02_01 += table[1] * t379;
            damping_02_02 += table[1] * t382;
            damping_02_10 += table[1] * t385;
            damping_02_11 += table[1] * t388;
            damping_02_12 += table[1] * t391;
            damping_02_20 += table[1] * t394;
            damping_02_21 += table[1] * t397;
            damping_02_22 += table[1] * t400;
            damping_10_00 += table[2] * t374;
            damping_10_01 += table[2] * t377;
            damping_10_02 += table[2] * t380;
            damping_10_10 += table[2] * t383;
            damping_10_11 += table[2] * t386;
            damping_10_12 += table[2] * t389;
            damping_10_20 += table[2] * t392;
            damping_10_21 += table[2] * t395;
            damping_10_22 += table[2] * t398;
            damping_11_00 += table[2] * t375;
            damping_11_01 += table[2] * t378;
            damping_11_02 += table[2] * t381;
            damping_11_10 += table[2] * t384;
            damping_11_11 += table[2] * t387;
            damping_11_12 += table[2] * t390;
            damping_11_20 += table[2] * t393;
            damping_11_21 += table[2] * t396;
            damping_11_22 += table[2] * t399;
            damping_12_00 += table[2] * t376;
            damping_12_01 += table[2] * t379;
            damping_12_02 += table[2] * t382;
            damping_12_10 += table[2] * t385;
            damping_12_11 += table[2] * t388;
            damping_12_12 += table[2] * t391;
            damping_12_20 += table[2] * t394;
            damping_12_21 += table[2] * t397;
            damping_12_22 += table[2] * t400;
            damping_20_00 += table[3] * t374;
            damping_20_01 += table[3] * t377;
            damping_20_02 += table[3] * t380;
            damping_20_10 += table[3] * t383;
            damping_20_11 += table[3] * t386;
            damping_20_12 += table[3] * t389;
            damping_20_20 += table[3] * t392;
            damping_20_21 += table[3] * t395;
            damping_20_22 += table[3] * t398;
            damping_21_00 += table[3] * t375;
            damping_21_01 += table[3] * t378;
            damping_21_02 += table[3] * t381;
            damping_21_10 += table[3] * t384;
            damping_21_11 += table[3] * t387;
            damping_21_12 += table[3] * t390;
            damping_21_20 += table[3] * t393;
            damping_21_21 += table[3] * t396;
            damping_21_22 += table[3] * t399;
            damping_22_00 += table[3] * t376;
            damping_22_01 += table[3] * t379;
            damping_22_02 += table[3] * t382;
            damping_22_10 += table[3] * t385;
            damping_22_11 += table[3] * t388;
            damping_22_12 += table[3] * t391;
            damping_22_20 += table[3] * t394;
            damping_22_21 += table[3] * t397;
            damping_22_22 += table[3] * t400;
        }
        let t401 = t220 * stiffness_11_00;
        let t402 = t220 * stiffness_11_01;
        let t403 = t220 * stiffness_11_02;
        let t404 = inverse_length * stiffness_10_00;
        let t405 = inverse_length * stiffness_10_01;
        let t406 = inverse_length * stiffness_10_02;
        let t407 = inverse_length * stiffness_12_00;
        let t408 = inverse_length * stiffness_12_01;
        let t409 = inverse_length * stiffness_12_02;
        let t410 = t220 * stiffness_11_10;
        let t411 = t220 * stiffness_11_11;
        let t412 = t220 * stiffness_11_12;
        let t413 = inverse_length * stiffness_10_10;
        let t414 = inverse_length * stiffness_10_11;
        let t415 = inverse_length * stiffness_10_12;
        let t416 = inverse_length * stiffness_12_10;
        let t417 = inverse_length * stiffness_12_11;
        let t418 = inverse_length * stiffness_12_12;
        let t419 = t220 * stiffness_11_20;
        let t420 = t220 * stiffness_11_21;
        let t421 = t220 * stiffness_11_22;
        let t422 = inverse_length * stiffness_10_20;
        let t423 = inverse_length * stiffness_10_21;
        let t424 = inverse_length * stiffness_10_22;
        let t425 = inverse_length * stiffness_12_20;
        let t426 = inverse_length * stiffness_12_21;
        let t427 = inverse_length * stiffness_12_22;
        let t428 = inverse_length * stiffness_01_00;
        let t429 = inverse_length * stiffness_01_01;
        let t430 = inverse_length * stiffness_01_02;
        let t431 = inverse_length * stiffness_01_10;
        let t432 = inverse_length * stiffness_01_11;
        let t433 = inverse_length * stiffness_01_12;
        let t434 = inverse_length * stiffness_01_20;
        let t435 = inverse_length * stiffness_01_21;
        let t436 = inverse_length * stiffness_01_22;
        let t437 = inverse_length * stiffness_21_00;
        let t438 = inverse_length * stiffness_21_01;
        let t439 = inverse_length * stiffness_21_02;
        let t440 = inverse_length * stiffness_21_10;
        let t441 = inverse_length * stiffness_21_11;
        let t442 = inverse_length * stiffness_21_12;
        let t443 = inverse_length * stiffness_21_20;
        let t444 = inverse_length * stiffness_21_21;
        let t445 = inverse_length * stiffness_21_22;
        let t446 = t220 * damping_11_00;
        let t447 = t220 * damping_11_01;
        let t448 = t220 * damping_11_02;
        let t449 = inverse_length * damping_10_00;
        let t450 = inverse_length * damping_10_01;
        let t451 = inverse_length * damping_10_02;
        let t452 = inverse_length * damping_12_00;
        let t453 = inverse_length * damping_12_01;
        let t454 = inverse_length * damping_12_02;
        let t455 = t220 * damping_11_10;
        let t456 = t220 * damping_11_11;
        let t457 = t220 * damping_11_12;
        let t458 = inverse_length * damping_10_10;
        let t459 = inverse_length * damping_10_11;
        let t460 = inverse_length * damping_10_12;
        let t461 = inverse_length * damping_12_10;
        let t462 = inverse_length * damping_12_11;
        let t463 = inverse_length * damping_12_12;
        let t464 = t220 * damping_11_20;
        let t465 = t220 * damping_11_21;
        let t466 = t220 * damping_11_22;
        let t467 = inverse_length * damping_10_20;
        let t468 = inverse_length * damping_10_21;
        let t469 = inverse_length * damping_10_22;
        let t470 = inverse_length * damping_12_20;
        let t471 = inverse_length * damping_12_21;
        let t472 = inverse_length * damping_12_22;
        let t473 = inverse_length * damping_01_00;
        let t474 = inverse_length * damping_01_01;
        let t475 = inverse_length * damping_01_02;
        let t476 = inverse_length * damping_01_10;
        let t477 = inverse_length * damping_01_11;
        let t478 = inverse_length * damping_01_12;
        let t479 = inverse_length * damping_01_20;
        let t480 = inverse_length * damping_01_21;
        let t481 = inverse_length * damping_01_22;
        let t482 = inverse_length * damping_21_00;
        let t483 = inverse_length * damping_21_01;
        let t484 = inverse_length * damping_21_02;
        let t485 = inverse_length * damping_21_10;
        let t486 = inverse_length * damping_21_11;
        let t487 = inverse_length * damping_21_12;
        let t488 = inverse_length * damping_21_20;
        let t489 = inverse_length * damping_21_21;
        let t490 = inverse_length * damping_21_22;
        stiffness[0] += t401;
        stiffness[1] += t402;
        stiffness[2] += t403;
        stiffness[3] -= t404;
        stiffness[4] -= t405;
        stiffness[5] -= t406;
        stiffness[6] -= t401;
        stiffness[7] -= t402;
        stiffness[8] -= t403;
        stiffness[9] -= t407;
        stiffness[10] -= t408;
        stiffness[11] -= t409;
        stiffness[12] += t410;
        stiffness[13] += t411;
        stiffness[14] += t412;
        stiffness[15] -= t413;
        stiffness[16] -= t414;
        stiffness[17] -= t415;
        stiffness[18] -= t410;
        stiffness[19] -= t411;
        stiffness[20] -= t412;
        stiffness[21] -= t416;
        stiffness[22] -= t417;
        stiffness[23] -= t418;
        stiffness[24] += t419;
        stiffness[25] += t420;
        stiffness[26] += t421;
        stiffness[27] -= t422;
        stiffness[28] -= t423;
        stiffness[29] -= t424;
        stiffness[30] -= t419;
        stiffness[31] -= t420;
        stiffness[32] -= t421;
        stiffness[33] -= t425;
        stiffness[34] -= t426;
        stiffness[35] -= t427;
        stiffness[36] -= t428;
        stiffness[37] -= t429;
        stiffness[38] -= t430;
        stiffness[39] += stiffness_00_00;
        stiffness[40] += stiffness_00_01;
        stiffness[41] += stiffness_00_02;
        stiffness[42] += t428;
        stiffness[43] += t429;
        stiffness[44] += t430;
        stiffness[45] += stiffness_02_00;
        stiffness[46] += stiffness_02_01;
        stiffness[47] += stiffness_02_02;
        stiffness[48] -= t431;
        stiffness[49] -= t432;
        stiffness[50] -= t433;
        stiffness[51] += stiffness_00_10;
        stiffness[52] += stiffness_00_11;
        stiffness[53] += stiffness_00_12;
        stiffness[54] += t431;
        stiffness[55] += t432;
        stiffness[56] += t433;
        stiffness[57] += stiffness_02_10;
        stiffness[58] += stiffness_02_11;
        stiffness[59] += stiffness_02_12;
        stiffness[60] -= t434;
        stiffness[61] -= t435;
        stiffness[62] -= t436;
        stiffness[63] += stiffness_00_20;
        stiffness[64] += stiffness_00_21;
        stiffness[65] += stiffness_00_22;
        stiffness[66] += t434;
        stiffness[67] += t435;
        stiffness[68] += t436;
        stiffness[69] += stiffness_02_20;
        stiffness[70] += stiffness_02_21;
        stiffness[71] += stiffness_02_22;
        stiffness[72] -= t401;
        stiffness[73] -= t402;
        stiffness[74] -= t403;
        stiffness[75] += t404;
        stiffness[76] += t405;
        stiffness[77] += t406;
        stiffness[78] += t401;
        stiffness[79] += t402;
        stiffness[80] += t403;
        stiffness[81] += t407;
        stiffness[82] += t408;
        stiffness[83] += t409;
        stiffness[84] -= t410;
        stiffness[85] -= t411;
        stiffness[86] -= t412;
        stiffness[87] += t413;
        stiffness[88] += t414;
        stiffness[89] += t415;
        stiffness[90] += t410;
        stiffness[91] += t411;
        stiffness[92] += t412;
        stiffness[93] += t416;
        stiffness[94] += t417;
        stiffness[95] += t418;
        stiffness[96] -= t419;
        stiffness[97] -= t420;
        stiffness[98] -= t421;
        stiffness[99] += t422;
        stiffness[100] += t423;
        stiffness[101] += t424;
        stiffness[102] += t419;
        stiffness[103] += t420;
        stiffness[104] += t421;
        stiffness[105] += t425;
        stiffness[106] += t426;
        stiffness[107] += t427;
        stiffness[108] -= t437;
        stiffness[109] -= t438;
        stiffness[110] -= t439;
        stiffness[111] += stiffness_20_00;
        stiffness[112] += stiffness_20_01;
        stiffness[113] += stiffness_20_02;
        stiffness[114] += t437;
        stiffness[115] += t438;
        stiffness[116] += t439;
        stiffness[117] += stiffness_22_00;
        stiffness[118] += stiffness_22_01;
        stiffness[119] += stiffness_22_02;
        stiffness[120] -= t440;
        stiffness[121] -= t441;
        stiffness[122] -= t442;
        stiffness[123] += stiffness_20_10;
        stiffness[124] += stiffness_20_11;
        stiffness[125] += stiffness_20_12;
        stiffness[126] += t440;
        stiffness[127] += t441;
        stiffness[128] += t442;
        stiffness[129] += stiffness_22_10;
        stiffness[130] += stiffness_22_11;
        stiffness[131] += stiffness_22_12;
        stiffness[132] -= t443;
        stiffness[133] -= t444;
        stiffness[134] -= t445;
        stiffness[135] += stiffness_20_20;
        stiffness[136] += stiffness_20_21;
        stiffness[137] += stiffness_20_22;
        stiffness[138] += t443;
        stiffness[139] += t444;
        stiffness[140] += t445;
        stiffness[141] += stiffness_22_20;
        stiffness[142] += stiffness_22_21;
        stiffness[143] += stiffness_22_22;
        damping_matrix[0] += t446;
        damping_matrix[1] += t447;
        damping_matrix[2] += t448;
        damping_matrix[3] -= t449;
        damping_matrix[4] -= t450;
        damping_matrix[5] -= t451;
        damping_matrix[6] -= t446;
        damping_matrix[7] -= t447;
        damping_matrix[8] -= t448;
        damping_matrix[9] -= t452;
        damping_matrix[10] -= t453;
        damping_matrix[11] -= t454;
        damping_matrix[12] += t455;
        damping_matrix[13] += t456;
        damping_matrix[14] += t457;
        damping_matrix[15] -= t458;
        damping_matrix[16] -= t459;
        damping_matrix[17] -= t460;
        damping_matrix[18] -= t455;
        damping_matrix[19] -= t456;
        damping_matrix[20] -= t457;
        damping_matrix[21] -= t461;
        damping_matrix[22] -= t462;
        damping_matrix[23] -= t463;
        damping_matrix[24] += t464;
        damping_matrix[25] += t465;
        damping_matrix[26] += t466;
        damping_matrix[27] -= t467;
        damping_matrix[28] -= t468;
        damping_matrix[29] -= t469;
        damping_matrix[30] -= t464;
        damping_matrix[31] -= t465;
        damping_matrix[32] -= t466;
        damping_matrix[33] -= t470;
        damping_matrix[34] -= t471;
        damping_matrix[35] -= t472;
        damping_matrix[36] -= t473;
        damping_matrix[37] -= t474;
        damping_matrix[38] -= t475;
        damping_matrix[39] += damping_00_00;
        damping_matrix[40] += damping_00_01;
        damping_matrix[41] += damping_00_02;
        damping_matrix[42] += t473;
        damping_matrix[43] += t474;
        damping_matrix[44] += t475;
        damping_matrix[45] += damping_02_00;
        damping_matrix[46] += damping_02_01;
        damping_matrix[47] += damping_02_02;
        damping_matrix[48] -= t476;
        damping_matrix[49] -= t477;
        damping_matrix[50] -= t478;
        damping_matrix[51] += damping_00_10;
        damping_matrix[52] += damping_00_11;
        damping_matrix[53] += damping_00_12;
        damping_matrix[54] += t476;
        damping_matrix[55] += t477;
        damping_matrix[56] += t478;
        damping_matrix[57] += damping_02_10;
        damping_matrix[58] += damping_02_11;
        damping_matrix[59] += damping_02_12;
        damping_matrix[60] -= t479;
        damping_matrix[61] -= t480;
        damping_matrix[62] -= t481;
        damping_matrix[63] += damping_00_20;
        damping_matrix[64] += damping_00_21;
        damping_matrix[65] += damping_00_22;
        damping_matrix[66] += t479;
        damping_matrix[67] += t480;
        damping_matrix[68] += t481;
        damping_matrix[69] += damping_02_20;
        damping_matrix[70] += damping_02_21;
        damping_matrix[71] += damping_02_22;
        damping_matrix[72] -= t446;
        damping_matrix[73] -= t447;
        damping_matrix[74] -= t448;
        damping_matrix[75] += t449;
        damping_matrix[76] += t450;
        damping_matrix[77] += t451;
        damping_matrix[78] += t446;
        damping_matrix[79] += t447;
        damping_matrix[80] += t448;
        damping_matrix[81] += t452;
        damping_matrix[82] += t453;
        damping_matrix[83] += t454;
        damping_matrix[84] -= t455;
        damping_matrix[85] -= t456;
        damping_matrix[86] -= t457;
        damping_matrix[87] += t458;
        damping_matrix[88] += t459;
        damping_matrix[89] += t460;
        damping_matrix[90] += t455;
        damping_matrix[91] += t456;
        damping_matrix[92] += t457;
        damping_matrix[93] += t461;
        damping_matrix[94] += t462;
        damping_matrix[95] += t463;
        damping_matrix[96] -= t464;
        damping_matrix[97] -= t465;
        damping_matrix[98] -= t466;
        damping_matrix[99] += t467;
        damping_matrix[100] += t468;
        damping_matrix[101] += t469;
        damping_matrix[102] += t464;
        damping_matrix[103] += t465;
        damping_matrix[104] += t466;
        damping_matrix[105] += t470;
        damping_matrix[106] += t471;
        damping_matrix[107] += t472;
        damping_matrix[108] -= t482;
        damping_matrix[109] -= t483;
        damping_matrix[110] -= t484;
        damping_matrix[111] += damping_20_00;
        damping_matrix[112] += damping_20_01;
        damping_matrix[113] += damping_20_02;
        damping_matrix[114] += t482;
        damping_matrix[115] += t483;
        damping_matrix[116] += t484;
        damping_matrix[117] += damping_22_00;
        damping_matrix[118] += damping_22_01;
        damping_matrix[119] += damping_22_02;
        damping_matrix[120] -= t485;
        damping_matrix[121] -= t486;
        damping_matrix[122] -= t487;
        damping_matrix[123] += damping_20_10;
        damping_matrix[124] += damping_20_11;
        damping_matrix[125] += damping_20_12;
        damping_matrix[126] += t485;
        damping_matrix[127] += t486;
        damping_matrix[128] += t487;
        damping_matrix[129] += damping_22_10;
        damping_matrix[130] += damping_22_11;
        damping_matrix[131] += damping_22_12;
        damping_matrix[132] -= t488;
        damping_matrix[133] -= t489;
        damping_matrix[134] -= t490;
        damping_matrix[135] += damping_20_20;
        damping_matrix[136] += damping_20_21;
        damping_matrix[137] += damping_20_22;
        damping_matrix[138] += t488;
        damping_matrix[139] += t489;
        damping_matrix[140] += t490;
        damping_matrix[141] += damping_22_20;
        damping_matrix[142] += damping_22_21;
        damping_matrix[143] += damping_22_22;
    }
    /// Adds the strain energy U of one element (J).
    ///
    /// Hermite centre-line element: axial strain and bending, no shear, no torsion; bending = exact.
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
            let t42 = length * table[0];
            let a_x = s0_x * table[1] + d_x * table[2] + s1_x * table[3];
            let a_y = s0_y * table[1] + d_y * table[2] + s1_y * table[3];
            let a_z = s0_z * table[1] + d_z * table[2] + s1_z * table[3];
            let b_x = inverse_length
                * (s0_x * table[4] + d_x * table[5] + s1_x * table[6]);
            let b_y = inverse_length
                * (s0_y * table[4] + d_y * table[5] + s1_y * table[6]);
            let b_z = inverse_length
                * (s0_z * table[4] + d_z * table[5] + s1_z * table[6]);
            let t49 = a_x * a_x + a_y * a_y + a_z * a_z;
            let t50 = t49 * (b_x * b_x + b_y * b_y + b_z * b_z)
                - (a_x * b_x + a_y * b_y + a_z * b_z).powi(2);
            let t51 = 0.5 * (EA * t42) * (0.5 * (t49 - 1.0)).powi(2)
                + EI * t42 * (0.5 * (t50 * (1.0 / (t49 * t49))));
            energy_sum += t51;
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
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t19 = length * element_mass;
        let mass_r0_s0 = t19 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t19 * (-0.030952380952380953);
        let t23 = element_mass * (length * length);
        let mass_s0_s0 = t23 * 0.009523809523809525;
        let mass_s0_r1 = t19 * 0.030952380952380953;
        let mass_s0_s1 = t23 * (-0.007142857142857143);
        let mass_r1_s1 = t19 * (-0.05238095238095238);
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
    /// Adds the inertia forces of one element in a moving frame (Eq. 13): relative, Coriolis, Euler and centrifugal acceleration, the frame's acceleration and gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 138 additions, 168 multiplications.
    pub fn cable_spatial_exact_damped_inertia_force(
        row: &CableSpatialExactDamped,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let element_mass = length * rhoA;
        let t63 = r0_z * w_y - r0_y * w_z;
        let t64 = r0_x * w_z - r0_z * w_x;
        let t65 = r0_y * w_x - r0_x * w_y;
        let t66 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + (v_r0_z * w_y - v_r0_y * w_z) * 2.0);
        let t67 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + (v_r0_x * w_z - v_r0_z * w_x) * 2.0);
        let t68 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + (v_r0_y * w_x - v_r0_x * w_y) * 2.0);
        let total_r0_x = e_x + (w_y * t65 - w_z * t64 + t66);
        let total_r0_y = e_y + (w_z * t63 - w_x * t65 + t67);
        let total_r0_z = e_z + (w_x * t64 - w_y * t63 + t68);
        let t72 = s0_z * w_y - s0_y * w_z;
        let t73 = s0_x * w_z - s0_z * w_x;
        let t74 = s0_y * w_x - s0_x * w_y;
        let t75 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t76 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t77 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let total_s0_x = w_y * t74 - w_z * t73 + t75;
        let total_s0_y = w_z * t72 - w_x * t74 + t76;
        let total_s0_z = w_x * t73 - w_y * t72 + t77;
        let t81 = r1_z * w_y - r1_y * w_z;
        let t82 = r1_x * w_z - r1_z * w_x;
        let t83 = r1_y * w_x - r1_x * w_y;
        let t84 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t85 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t86 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let total_r1_x = e_x + (w_y * t83 - w_z * t82 + t84);
        let total_r1_y = e_y + (w_z * t81 - w_x * t83 + t85);
        let total_r1_z = e_z + (w_x * t82 - w_y * t81 + t86);
        let t90 = s1_z * w_y - s1_y * w_z;
        let t91 = s1_x * w_z - s1_z * w_x;
        let t92 = s1_y * w_x - s1_x * w_y;
        let t93 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t94 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t95 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let total_s1_x = w_y * t92 - w_z * t91 + t93;
        let total_s1_y = w_z * t90 - w_x * t92 + t94;
        let total_s1_z = w_x * t91 - w_y * t90 + t95;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t100 = length * element_mass;
        let mass_r0_s0 = t100 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t100 * (-0.030952380952380953);
        let t104 = element_mass * (length * length);
        let mass_s0_s0 = t104 * 0.009523809523809525;
        let mass_s0_r1 = t100 * 0.030952380952380953;
        let mass_s0_s1 = t104 * (-0.007142857142857143);
        let mass_r1_s1 = t100 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + total_s0_x * mass_r0_s0
                + total_r1_x * mass_r0_r1 + total_s1_x * mass_r0_s1;
        force[1]
            += total_r0_y * mass_r0_r0 + total_s0_y * mass_r0_s0
                + total_r1_y * mass_r0_r1 + total_s1_y * mass_r0_s1;
        force[2]
            += total_r0_z * mass_r0_r0 + total_s0_z * mass_r0_s0
                + total_r1_z * mass_r0_r1 + total_s1_z * mass_r0_s1;
        force[3]
            += total_r0_x * mass_r0_s0 + total_s0_x * mass_s0_s0
                + total_r1_x * mass_s0_r1 + total_s1_x * mass_s0_s1;
        force[4]
            += total_r0_y * mass_r0_s0 + total_s0_y * mass_s0_s0
                + total_r1_y * mass_s0_r1 + total_s1_y * mass_s0_s1;
        force[5]
            += total_r0_z * mass_r0_s0 + total_s0_z * mass_s0_s0
                + total_r1_z * mass_s0_r1 + total_s1_z * mass_s0_s1;
        force[6]
            += total_r0_x * mass_r0_r1 + total_s0_x * mass_s0_r1
                + total_r1_x * mass_r0_r0 + total_s1_x * mass_r1_s1;
        force[7]
            += total_r0_y * mass_r0_r1 + total_s0_y * mass_s0_r1
                + total_r1_y * mass_r0_r0 + total_s1_y * mass_r1_s1;
        force[8]
            += total_r0_z * mass_r0_r1 + total_s0_z * mass_s0_r1
                + total_r1_z * mass_r0_r0 + total_s1_z * mass_r1_s1;
        force[9]
            += total_r0_x * mass_r0_s1 + total_s0_x * mass_s0_s1
                + total_r1_x * mass_r1_s1 + total_s1_x * mass_s0_s0;
        force[10]
            += total_r0_y * mass_r0_s1 + total_s0_y * mass_s0_s1
                + total_r1_y * mass_r1_s1 + total_s1_y * mass_s0_s0;
        force[11]
            += total_r0_z * mass_r0_s1 + total_s0_z * mass_s0_s1
                + total_r1_z * mass_r1_s1 + total_s1_z * mass_s0_s0;
    }
    /// Adds the derivatives of the inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 297 additions, 117 multiplications.
    pub fn cable_spatial_exact_damped_inertia_tangent(
        row: &CableSpatialExactDamped,
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 144],
        damping_matrix: &mut [f64; 144],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t25 = length * element_mass;
        let mass_r0_s0 = t25 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t25 * (-0.030952380952380953);
        let t29 = element_mass * (length * length);
        let mass_s0_s0 = t29 * 0.009523809523809525;
        let mass_s0_r1 = t25 * 0.030952380952380953;
        let mass_s0_s1 = t29 * (-0.007142857142857143);
        let mass_r1_s1 = t25 * (-0.05238095238095238);
        let t34 = w_y * w_y;
        let t35 = w_z * w_z;
        let t36 = t34 + t35;
        let t37 = -mass_r0_r0 * t36;
        let t38 = w_x * w_y;
        let t39 = t38 - dw_z;
        let t40 = mass_r0_r0 * t39;
        let t41 = w_x * w_z;
        let t42 = dw_y + t41;
        let t43 = mass_r0_r0 * t42;
        let t44 = -mass_r0_s0 * t36;
        let t45 = mass_r0_s0 * t39;
        let t46 = mass_r0_s0 * t42;
        let t47 = -mass_r0_r1 * t36;
        let t48 = mass_r0_r1 * t39;
        let t49 = mass_r0_r1 * t42;
        let t50 = -mass_r0_s1 * t36;
        let t51 = mass_r0_s1 * t39;
        let t52 = mass_r0_s1 * t42;
        let t53 = dw_z + t38;
        let t54 = mass_r0_r0 * t53;
        let t55 = w_x * w_x;
        let t56 = t35 + t55;
        let t57 = -mass_r0_r0 * t56;
        let t58 = w_y * w_z;
        let t59 = t58 - dw_x;
        let t60 = mass_r0_r0 * t59;
        let t61 = mass_r0_s0 * t53;
        let t62 = -mass_r0_s0 * t56;
        let t63 = mass_r0_s0 * t59;
        let t64 = mass_r0_r1 * t53;
        let t65 = -mass_r0_r1 * t56;
        let t66 = mass_r0_r1 * t59;
        let t67 = mass_r0_s1 * t53;
        let t68 = -mass_r0_s1 * t56;
        let t69 = mass_r0_s1 * t59;
        let t70 = t41 - dw_y;
        let t71 = mass_r0_r0 * t70;
        let t72 = dw_x + t58;
        let t73 = mass_r0_r0 * t72;
        let t74 = t34 + t55;
        let t75 = -mass_r0_r0 * t74;
        let t76 = mass_r0_s0 * t70;
        let t77 = mass_r0_s0 * t72;
        let t78 = -mass_r0_s0 * t74;
        let t79 = mass_r0_r1 * t70;
        let t80 = mass_r0_r1 * t72;
        let t81 = -mass_r0_r1 * t74;
        let t82 = mass_r0_s1 * t70;
        let t83 = mass_r0_s1 * t72;
        let t84 = -mass_r0_s1 * t74;
        let t85 = -mass_s0_s0 * t36;
        let t86 = mass_s0_s0 * t39;
        let t87 = mass_s0_s0 * t42;
        let t88 = -mass_s0_r1 * t36;
        let t89 = mass_s0_r1 * t39;
        let t90 = mass_s0_r1 * t42;
        let t91 = -mass_s0_s1 * t36;
        let t92 = mass_s0_s1 * t39;
        let t93 = mass_s0_s1 * t42;
        let t94 = mass_s0_s0 * t53;
        let t95 = -mass_s0_s0 * t56;
        let t96 = mass_s0_s0 * t59;
        let t97 = mass_s0_r1 * t53;
        let t98 = -mass_s0_r1 * t56;
        let t99 = mass_s0_r1 * t59;
        let t100 = mass_s0_s1 * t53;
        let t101 = -mass_s0_s1 * t56;
        let t102 = mass_s0_s1 * t59;
        let t103 = mass_s0_s0 * t70;
        let t104 = mass_s0_s0 * t72;
        let t105 = -mass_s0_s0 * t74;
        let t106 = mass_s0_r1 * t70;
        let t107 = mass_s0_r1 * t72;
        let t108 = -mass_s0_r1 * t74;
        let t109 = mass_s0_s1 * t70;
        let t110 = mass_s0_s1 * t72;
        let t111 = -mass_s0_s1 * t74;
        let t112 = -mass_r1_s1 * t36;
        let t113 = mass_r1_s1 * t39;
        let t114 = mass_r1_s1 * t42;
        let t115 = mass_r1_s1 * t53;
        let t116 = -mass_r1_s1 * t56;
        let t117 = mass_r1_s1 * t59;
        let t118 = mass_r1_s1 * t70;
        let t119 = mass_r1_s1 * t72;
        let t120 = -mass_r1_s1 * t74;
        let t121 = w_z * 2.0;
        let t122 = mass_r0_r0 * t121;
        let t123 = w_y * 2.0;
        let t124 = mass_r0_r0 * t123;
        let t125 = mass_r0_s0 * t121;
        let t126 = mass_r0_s0 * t123;
        let t127 = mass_r0_r1 * t121;
        let t128 = mass_r0_r1 * t123;
        let t129 = mass_r0_s1 * t121;
        let t130 = mass_r0_s1 * t123;
        let t131 = w_x * 2.0;
        let t132 = mass_r0_r0 * t131;
        let t133 = mass_r0_s0 * t131;
        let t134 = mass_r0_r1 * t131;
        let t135 = mass_r0_s1 * t131;
        let t136 = mass_s0_s0 * t121;
        let t137 = mass_s0_s0 * t123;
        let t138 = mass_s0_r1 * t121;
        let t139 = mass_s0_r1 * t123;
        let t140 = mass_s0_s1 * t121;
        let t141 = mass_s0_s1 * t123;
        let t142 = mass_s0_s0 * t131;
        let t143 = mass_s0_r1 * t131;
        let t144 = mass_s0_s1 * t131;
        let t145 = mass_r1_s1 * t121;
        let t146 = mass_r1_s1 * t123;
        let t147 = mass_r1_s1 * t131;
        stiffness[0] += t37;
        stiffness[1] += t40;
        stiffness[2] += t43;
        stiffness[3] += t44;
        stiffness[4] += t45;
        stiffness[5] += t46;
        stiffness[6] += t47;
        stiffness[7] += t48;
        stiffness[8] += t49;
        stiffness[9] += t50;
        stiffness[10] += t51;
        stiffness[11] += t52;
        stiffness[12] += t54;
        stiffness[13] += t57;
        stiffness[14] += t60;
        stiffness[15] += t61;
        stiffness[16] += t62;
        stiffness[17] += t63;
        stiffness[18] += t64;
        stiffness[19] += t65;
        stiffness[20] += t66;
        stiffness[21] += t67;
        stiffness[22] += t68;
        stiffness[23] += t69;
        stiffness[24] += t71;
        stiffness[25] += t73;
        stiffness[26] += t75;
        stiffness[27] += t76;
        stiffness[28] += t77;
        stiffness[29] += t78;
        stiffness[30] += t79;
        stiffness[31] += t80;
        stiffness[32] += t81;
        stiffness[33] += t82;
        stiffness[34] += t83;
        stiffness[35] += t84;
        stiffness[36] += t44;
        stiffness[37] += t45;
        stiffness[38] += t46;
        stiffness[39] += t85;
        stiffness[40] += t86;
        stiffness[41] += t87;
        stiffness[42] += t88;
        stiffness[43] += t89;
        stiffness[44] += t90;
        stiffness[45] += t91;
        stiffness[46] += t92;
        stiffness[47] += t93;
        stiffness[48] += t61;
        stiffness[49] += t62;
        stiffness[50] += t63;
        stiffness[51] += t94;
        stiffness[52] += t95;
        stiffness[53] += t96;
        stiffness[54] += t97;
        stiffness[55] += t98;
        stiffness[56] += t99;
        stiffness[57] += t100;
        stiffness[58] += t101;
        stiffness[59] += t102;
        stiffness[60] += t76;
        stiffness[61] += t77;
        stiffness[62] += t78;
        stiffness[63] += t103;
        stiffness[64] += t104;
        stiffness[65] += t105;
        stiffness[66] += t106;
        stiffness[67] += t107;
        stiffness[68] += t108;
        stiffness[69] += t109;
        stiffness[70] += t110;
        stiffness[71] += t111;
        stiffness[72] += t47;
        stiffness[73] += t48;
        stiffness[74] += t49;
        stiffness[75] += t88;
        stiffness[76] += t89;
        stiffness[77] += t90;
        stiffness[78] += t37;
        stiffness[79] += t40;
        stiffness[80] += t43;
        stiffness[81] += t112;
        stiffness[82] += t113;
        stiffness[83] += t114;
        stiffness[84] += t64;
        stiffness[85] += t65;
        stiffness[86] += t66;
        stiffness[87] += t97;
        stiffness[88] += t98;
        stiffness[89] += t99;
        stiffness[90] += t54;
        stiffness[91] += t57;
        stiffness[92] += t60;
        stiffness[93] += t115;
        stiffness[94] += t116;
        stiffness[95] += t117;
        stiffness[96] += t79;
        stiffness[97] += t80;
        stiffness[98] += t81;
        stiffness[99] += t106;
        stiffness[100] += t107;
        stiffness[101] += t108;
        stiffness[102] += t71;
        stiffness[103] += t73;
        stiffness[104] += t75;
        stiffness[105] += t118;
        stiffness[106] += t119;
        stiffness[107] += t120;
        stiffness[108] += t50;
        stiffness[109] += t51;
        stiffness[110] += t52;
        stiffness[111] += t91;
        stiffness[112] += t92;
        stiffness[113] += t93;
        stiffness[114] += t112;
        stiffness[115] += t113;
        stiffness[116] += t114;
        stiffness[117] += t85;
        stiffness[118] += t86;
        stiffness[119] += t87;
        stiffness[120] += t67;
        stiffness[121] += t68;
        stiffness[122] += t69;
        stiffness[123] += t100;
        stiffness[124] += t101;
        stiffness[125] += t102;
        stiffness[126] += t115;
        stiffness[127] += t116;
        stiffness[128] += t117;
        stiffness[129] += t94;
        stiffness[130] += t95;
        stiffness[131] += t96;
        stiffness[132] += t82;
        stiffness[133] += t83;
        stiffness[134] += t84;
        stiffness[135] += t109;
        stiffness[136] += t110;
        stiffness[137] += t111;
        stiffness[138] += t118;
        stiffness[139] += t119;
        stiffness[140] += t120;
        stiffness[141] += t103;
        stiffness[142] += t104;
        stiffness[143] += t105;
        damping_matrix[1] -= t122;
        damping_matrix[2] += t124;
        damping_matrix[4] -= t125;
        damping_matrix[5] += t126;
        damping_matrix[7] -= t127;
        damping_matrix[8] += t128;
        damping_matrix[10] -= t129;
        damping_matrix[11] += t130;
        damping_matrix[12] += t122;
        damping_matrix[14] -= t132;
        damping_matrix[15] += t125;
        damping_matrix[17] -= t133;
        damping_matrix[18] += t127;
        damping_matrix[20] -= t134;
        damping_matrix[21] += t129;
        damping_matrix[23] -= t135;
        damping_matrix[24] -= t124;
        damping_matrix[25] += t132;
        damping_matrix[27] -= t126;
        damping_matrix[28] += t133;
        damping_matrix[30] -= t128;
        damping_matrix[31] += t134;
        damping_matrix[33] -= t130;
        damping_matrix[34] += t135;
        damping_matrix[37] -= t125;
        damping_matrix[38] += t126;
        damping_matrix[40] -= t136;
        damping_matrix[41] += t137;
        damping_matrix[43] -= t138;
        damping_matrix[44] += t139;
        damping_matrix[46] -= t140;
        damping_matrix[47] += t141;
        damping_matrix[48] += t125;
        damping_matrix[50] -= t133;
        damping_matrix[51] += t136;
        damping_matrix[53] -= t142;
        damping_matrix[54] += t138;
        damping_matrix[56] -= t143;
        damping_matrix[57] += t140;
        damping_matrix[59] -= t144;
        damping_matrix[60] -= t126;
        damping_matrix[61] += t133;
        damping_matrix[63] -= t137;
        damping_matrix[64] += t142;
        damping_matrix[66] -= t139;
        damping_matrix[67] += t143;
        damping_matrix[69] -= t141;
        damping_matrix[70] += t144;
        damping_matrix[73] -= t127;
        damping_matrix[74] += t128;
        damping_matrix[76] -= t138;
        damping_matrix[77] += t139;
        damping_matrix[79] -= t122;
        damping_matrix[80] += t124;
        damping_matrix[82] -= t145;
        damping_matrix[83] += t146;
        damping_matrix[84] += t127;
        damping_matrix[86] -= t134;
        damping_matrix[87] += t138;
        damping_matrix[89] -= t143;
        damping_matrix[90] += t122;
        damping_matrix[92] -= t132;
        damping_matrix[93] += t145;
        damping_matrix[95] -= t147;
        damping_matrix[96] -= t128;
        damping_matrix[97] += t134;
        damping_matrix[99] -= t139;
        damping_matrix[100] += t143;
        damping_matrix[102] -= t124;
        damping_matrix[103] += t132;
        damping_matrix[105] -= t146;
        damping_matrix[106] += t147;
        damping_matrix[109] -= t129;
        damping_matrix[110] += t130;
        damping_matrix[112] -= t140;
        damping_matrix[113] += t141;
        damping_matrix[115] -= t145;
        damping_matrix[116] += t146;
        damping_matrix[118] -= t136;
        damping_matrix[119] += t137;
        damping_matrix[120] += t129;
        damping_matrix[122] -= t135;
        damping_matrix[123] += t140;
        damping_matrix[125] -= t144;
        damping_matrix[126] += t145;
        damping_matrix[128] -= t147;
        damping_matrix[129] += t136;
        damping_matrix[131] -= t142;
        damping_matrix[132] -= t130;
        damping_matrix[133] += t135;
        damping_matrix[135] -= t141;
        damping_matrix[136] += t144;
        damping_matrix[138] -= t146;
        damping_matrix[139] += t147;
        damping_matrix[141] -= t137;
        damping_matrix[142] += t142;
    }
    /// Adds the inertia forces of one element in the inertial frame; e is minus gravity.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 54 additions, 60 multiplications.
    pub fn cable_spatial_exact_damped_absolute_inertia_force(
        row: &CableSpatialExactDamped,
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 12],
        force: &mut [f64; 12],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let element_mass = length * rhoA;
        let total_r0_x = a_r0_x + e_x;
        let total_r0_y = a_r0_y + e_y;
        let total_r0_z = a_r0_z + e_z;
        let total_r1_x = a_r1_x + e_x;
        let total_r1_y = a_r1_y + e_y;
        let total_r1_z = a_r1_z + e_z;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t40 = length * element_mass;
        let mass_r0_s0 = t40 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t40 * (-0.030952380952380953);
        let t44 = element_mass * (length * length);
        let mass_s0_s0 = t44 * 0.009523809523809525;
        let mass_s0_r1 = t40 * 0.030952380952380953;
        let mass_s0_s1 = t44 * (-0.007142857142857143);
        let mass_r1_s1 = t40 * (-0.05238095238095238);
        force[0]
            += total_r0_x * mass_r0_r0 + a_s0_x * mass_r0_s0 + total_r1_x * mass_r0_r1
                + a_s1_x * mass_r0_s1;
        force[1]
            += total_r0_y * mass_r0_r0 + a_s0_y * mass_r0_s0 + total_r1_y * mass_r0_r1
                + a_s1_y * mass_r0_s1;
        force[2]
            += total_r0_z * mass_r0_r0 + a_s0_z * mass_r0_s0 + total_r1_z * mass_r0_r1
                + a_s1_z * mass_r0_s1;
        force[3]
            += total_r0_x * mass_r0_s0 + a_s0_x * mass_s0_s0 + total_r1_x * mass_s0_r1
                + a_s1_x * mass_s0_s1;
        force[4]
            += total_r0_y * mass_r0_s0 + a_s0_y * mass_s0_s0 + total_r1_y * mass_s0_r1
                + a_s1_y * mass_s0_s1;
        force[5]
            += total_r0_z * mass_r0_s0 + a_s0_z * mass_s0_s0 + total_r1_z * mass_s0_r1
                + a_s1_z * mass_s0_s1;
        force[6]
            += total_r0_x * mass_r0_r1 + a_s0_x * mass_s0_r1 + total_r1_x * mass_r0_r0
                + a_s1_x * mass_r1_s1;
        force[7]
            += total_r0_y * mass_r0_r1 + a_s0_y * mass_s0_r1 + total_r1_y * mass_r0_r0
                + a_s1_y * mass_r1_s1;
        force[8]
            += total_r0_z * mass_r0_r1 + a_s0_z * mass_s0_r1 + total_r1_z * mass_r0_r0
                + a_s1_z * mass_r1_s1;
        force[9]
            += total_r0_x * mass_r0_s1 + a_s0_x * mass_s0_s1 + total_r1_x * mass_r1_s1
                + a_s1_x * mass_s0_s0;
        force[10]
            += total_r0_y * mass_r0_s1 + a_s0_y * mass_s0_s1 + total_r1_y * mass_r1_s1
                + a_s1_y * mass_s0_s0;
        force[11]
            += total_r0_z * mass_r0_s1 + a_s0_z * mass_s0_s1 + total_r1_z * mass_r1_s1
                + a_s1_z * mass_s0_s0;
    }
    /// Adds force and moment about the origin that the inertia of what the frame carries needs, in frame axes (Eqs. 11, 12): F = m e + d_b a_b, T = (d_a q_a) x e + M_ab q_a x a_b, with the accelerations a = q'' + 2 w x q' + w' x q + w x (w x q) and that of the origin minus gravity, e.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 174 additions, 228 multiplications.
    pub fn cable_spatial_exact_damped_carried(
        row: &CableSpatialExactDamped,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        out: &mut [f64; 6],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t64 = length * element_mass;
        let mass_r0_s0 = t64 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t64 * (-0.030952380952380953);
        let t68 = element_mass * (length * length);
        let mass_s0_s0 = t68 * 0.009523809523809525;
        let mass_s0_r1 = t64 * 0.030952380952380953;
        let mass_s0_s1 = t68 * (-0.007142857142857143);
        let mass_r1_s1 = t64 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t64 * 0.08333333333333333;
        let moment_s1 = t64 * (-0.08333333333333333);
        let t76 = r0_z * w_y - r0_y * w_z;
        let t77 = r0_x * w_z - r0_z * w_x;
        let t78 = r0_y * w_x - r0_x * w_y;
        let t79 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t80 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t81 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t82 = w_y * t78 - w_z * t77 + t79;
        let t83 = w_z * t76 - w_x * t78 + t80;
        let t84 = w_x * t77 - w_y * t76 + t81;
        let t85 = s0_z * w_y - s0_y * w_z;
        let t86 = s0_x * w_z - s0_z * w_x;
        let t87 = s0_y * w_x - s0_x * w_y;
        let t88 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t89 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t90 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t91 = w_y * t87 - w_z * t86 + t88;
        let t92 = w_z * t85 - w_x * t87 + t89;
        let t93 = w_x * t86 - w_y * t85 + t90;
        let t94 = r1_z * w_y - r1_y * w_z;
        let t95 = r1_x * w_z - r1_z * w_x;
        let t96 = r1_y * w_x - r1_x * w_y;
        let t97 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t98 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t99 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t100 = w_y * t96 - w_z * t95 + t97;
        let t101 = w_z * t94 - w_x * t96 + t98;
        let t102 = w_x * t95 - w_y * t94 + t99;
        let t103 = s1_z * w_y - s1_y * w_z;
        let t104 = s1_x * w_z - s1_z * w_x;
        let t105 = s1_y * w_x - s1_x * w_y;
        let t106 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t107 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t108 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t109 = w_y * t105 - w_z * t104 + t106;
        let t110 = w_z * t103 - w_x * t105 + t107;
        let t111 = w_x * t104 - w_y * t103 + t108;
        let t112 = moment_r0 * t82 + moment_s0 * t91 + moment_r0 * t100
            + moment_s1 * t109 + element_mass * e_x;
        let t113 = moment_r0 * t83 + moment_s0 * t92 + moment_r0 * t101
            + moment_s1 * t110 + element_mass * e_y;
        let t114 = moment_r0 * t84 + moment_s0 * t93 + moment_r0 * t102
            + moment_s1 * t111 + element_mass * e_z;
        let t115 = moment_r0 * r0_x + moment_s0 * s0_x + moment_r0 * r1_x
            + moment_s1 * s1_x;
        let t116 = moment_r0 * r0_y + moment_s0 * s0_y + moment_r0 * r1_y
            + moment_s1 * s1_y;
        let t117 = moment_r0 * r0_z + moment_s0 * s0_z + moment_r0 * r1_z
            + moment_s1 * s1_z;
        let t118 = mass_r0_r0 * r0_x + mass_r0_s0 * s0_x + mass_r0_r1 * r1_x
            + mass_r0_s1 * s1_x;
        let t119 = mass_r0_r0 * r0_y + mass_r0_s0 * s0_y + mass_r0_r1 * r1_y
            + mass_r0_s1 * s1_y;
        let t120 = mass_r0_r0 * r0_z + mass_r0_s0 * s0_z + mass_r0_r1 * r1_z
            + mass_r0_s1 * s1_z;
        let t121 = mass_r0_s0 * r0_x + mass_s0_s0 * s0_x + mass_s0_r1 * r1_x
            + mass_s0_s1 * s1_x;
        let t122 = mass_r0_s0 * r0_y + mass_s0_s0 * s0_y + mass_s0_r1 * r1_y
            + mass_s0_s1 * s1_y;
        let t123 = mass_r0_s0 * r0_z + mass_s0_s0 * s0_z + mass_s0_r1 * r1_z
            + mass_s0_s1 * s1_z;
        let t124 = e_z * t116 - e_y * t117 + (t84 * t119 - t83 * t120)
            + (t93 * t122 - t92 * t123);
        let t125 = e_x * t117 - e_z * t115 + (t82 * t120 - t84 * t118)
            + (t91 * t123 - t93 * t121);
        let t126 = e_y * t115 - e_x * t116 + (t83 * t118 - t82 * t119)
            + (t92 * t121 - t91 * t122);
        let t127 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t128 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t129 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t130 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t131 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t132 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        out[0] += t112;
        out[1] += t113;
        out[2] += t114;
        out[3] += t124 + (t102 * t128 - t101 * t129) + (t111 * t131 - t110 * t132);
        out[4] += t125 + (t100 * t129 - t102 * t127) + (t109 * t132 - t111 * t130);
        out[5] += t126 + (t101 * t127 - t100 * t128) + (t110 * t130 - t109 * t131);
    }
    /// Writes the derivatives of force F and moment T on the frame, rows first (THEORY 2.1): `mass` with respect to e, w', q''; `damping` to w, q'; `stiffness` to q; and of the nodal forces with respect to w, `spin`. Entries that are always zero are left alone.
    ///
    /// Mass tensors integrated exactly.
    ///
    /// Operations: 507 additions, 597 multiplications.
    pub fn cable_spatial_exact_damped_carried_tangent(
        row: &CableSpatialExactDamped,
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 12],
        v: &[f64; 12],
        a: &[f64; 12],
        mass: &mut [f64; 108],
        damping: &mut [f64; 90],
        spin: &mut [f64; 36],
        stiffness: &mut [f64; 72],
    ) {
        let CableSpatialExactDamped { length, rhoA, .. } = *row;
        let [r0_x, r0_y, r0_z, s0_x, s0_y, s0_z, r1_x, r1_y, r1_z, s1_x, s1_y, s1_z] = *q;
        let [v_r0_x, v_r0_y, v_r0_z, v_s0_x, v_s0_y, v_s0_z, v_r1_x, v_r1_y, v_r1_z,
        v_s1_x, v_s1_y, v_s1_z] = *v;
        let [a_r0_x, a_r0_y, a_r0_z, a_s0_x, a_s0_y, a_s0_z, a_r1_x, a_r1_y, a_r1_z,
        a_s1_x, a_s1_y, a_s1_z] = *a;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let element_mass = length * rhoA;
        let mass_r0_r0 = element_mass * 0.37142857142857144;
        let t64 = length * element_mass;
        let mass_r0_s0 = t64 * 0.05238095238095238;
        let mass_r0_r1 = element_mass * 0.12857142857142856;
        let mass_r0_s1 = t64 * (-0.030952380952380953);
        let t68 = element_mass * (length * length);
        let mass_s0_s0 = t68 * 0.009523809523809525;
        let mass_s0_r1 = t64 * 0.030952380952380953;
        let mass_s0_s1 = t68 * (-0.007142857142857143);
        let mass_r1_s1 = t64 * (-0.05238095238095238);
        let moment_r0 = element_mass * 0.5;
        let moment_s0 = t64 * 0.08333333333333333;
        let moment_s1 = t64 * (-0.08333333333333333);
        let t76 = r0_z * w_y - r0_y * w_z;
        let t77 = r0_x * w_z - r0_z * w_x;
        let t78 = r0_y * w_x - r0_x * w_y;
        let t79 = r0_z * dw_y - r0_y * dw_z
            + (a_r0_x + 2.0 * (v_r0_z * w_y - v_r0_y * w_z));
        let t80 = r0_x * dw_z - r0_z * dw_x
            + (a_r0_y + 2.0 * (v_r0_x * w_z - v_r0_z * w_x));
        let t81 = r0_y * dw_x - r0_x * dw_y
            + (a_r0_z + 2.0 * (v_r0_y * w_x - v_r0_x * w_y));
        let t82 = w_y * t78 - w_z * t77 + t79;
        let t83 = w_z * t76 - w_x * t78 + t80;
        let t84 = w_x * t77 - w_y * t76 + t81;
        let t85 = s0_z * w_y - s0_y * w_z;
        let t86 = s0_x * w_z - s0_z * w_x;
        let t87 = s0_y * w_x - s0_x * w_y;
        let t88 = s0_z * dw_y - s0_y * dw_z
            + (a_s0_x + 2.0 * (v_s0_z * w_y - v_s0_y * w_z));
        let t89 = s0_x * dw_z - s0_z * dw_x
            + (a_s0_y + 2.0 * (v_s0_x * w_z - v_s0_z * w_x));
        let t90 = s0_y * dw_x - s0_x * dw_y
            + (a_s0_z + 2.0 * (v_s0_y * w_x - v_s0_x * w_y));
        let t91 = w_y * t87 - w_z * t86 + t88;
        let t92 = w_z * t85 - w_x * t87 + t89;
        let t93 = w_x * t86 - w_y * t85 + t90;
        let t94 = r1_z * w_y - r1_y * w_z;
        let t95 = r1_x * w_z - r1_z * w_x;
        let t96 = r1_y * w_x - r1_x * w_y;
        let t97 = r1_z * dw_y - r1_y * dw_z
            + (a_r1_x + 2.0 * (v_r1_z * w_y - v_r1_y * w_z));
        let t98 = r1_x * dw_z - r1_z * dw_x
            + (a_r1_y + 2.0 * (v_r1_x * w_z - v_r1_z * w_x));
        let t99 = r1_y * dw_x - r1_x * dw_y
            + (a_r1_z + 2.0 * (v_r1_y * w_x - v_r1_x * w_y));
        let t100 = w_y * t96 - w_z * t95 + t97;
        let t101 = w_z * t94 - w_x * t96 + t98;
        let t102 = w_x * t95 - w_y * t94 + t99;
        let t103 = s1_z * w_y - s1_y * w_z;
        let t104 = s1_x * w_z - s1_z * w_x;
        let t105 = s1_y * w_x - s1_x * w_y;
        let t106 = s1_z * dw_y - s1_y * dw_z
            + (a_s1_x + 2.0 * (v_s1_z * w_y - v_s1_y * w_z));
        let t107 = s1_x * dw_z - s1_z * dw_x
            + (a_s1_y + 2.0 * (v_s1_x * w_z - v_s1_z * w_x));
        let t108 = s1_y * dw_x - s1_x * dw_y
            + (a_s1_z + 2.0 * (v_s1_y * w_x - v_s1_x * w_y));
        let t109 = w_y * t105 - w_z * t104 + t106;
        let t110 = w_z * t103 - w_x * t105 + t107;
        let t111 = w_x * t104 - w_y * t103 + t108;
        let t112 = moment_r0 * r0_x + moment_s0 * s0_x + moment_r0 * r1_x
            + moment_s1 * s1_x;
        let t113 = moment_r0 * r0_y + moment_s0 * s0_y + moment_r0 * r1_y
            + moment_s1 * s1_y;
        let t114 = moment_r0 * r0_z + moment_s0 * s0_z + moment_r0 * r1_z
            + moment_s1 * s1_z;
        let t115 = mass_r0_r0 * r0_x + mass_r0_s0 * s0_x + mass_r0_r1 * r1_x
            + mass_r0_s1 * s1_x;
        let t116 = mass_r0_r0 * r0_y + mass_r0_s0 * s0_y + mass_r0_r1 * r1_y
            + mass_r0_s1 * s1_y;
        let t117 = mass_r0_r0 * r0_z + mass_r0_s0 * s0_z + mass_r0_r1 * r1_z
            + mass_r0_s1 * s1_z;
        let t118 = mass_r0_s0 * r0_x + mass_s0_s0 * s0_x + mass_s0_r1 * r1_x
            + mass_s0_s1 * s1_x;
        let t119 = mass_r0_s0 * r0_y + mass_s0_s0 * s0_y + mass_s0_r1 * r1_y
            + mass_s0_s1 * s1_y;
        let t120 = mass_r0_s0 * r0_z + mass_s0_s0 * s0_z + mass_s0_r1 * r1_z
            + mass_s0_s1 * s1_z;
        let t121 = mass_r0_r1 * r0_x + mass_s0_r1 * s0_x + mass_r0_r0 * r1_x
            + mass_r1_s1 * s1_x;
        let t122 = mass_r0_r1 * r0_y + mass_s0_r1 * s0_y + mass_r0_r0 * r1_y
            + mass_r1_s1 * s1_y;
        let t123 = mass_r0_r1 * r0_z + mass_s0_r1 * s0_z + mass_r0_r0 * r1_z
            + mass_r1_s1 * s1_z;
        let t124 = mass_r0_s1 * r0_x + mass_s0_s1 * s0_x + mass_r1_s1 * r1_x
            + mass_s0_s0 * s1_x;
        let t125 = mass_r0_s1 * r0_y + mass_s0_s1 * s0_y + mass_r1_s1 * r1_y
            + mass_s0_s0 * s1_y;
        let t126 = mass_r0_s1 * r0_z + mass_s0_s1 * s0_z + mass_r1_s1 * r1_z
            + mass_s0_s0 * s1_z;
        let t127 = w_y * t117;
        let t128 = w_z * t116;
        let t129 = t127 - t128;
        let t130 = w_z * t115;
        let t131 = w_x * t117;
        let t132 = t130 - t131;
        let t133 = w_x * t116;
        let t134 = w_y * t115;
        let t135 = t133 - t134;
        let t136 = moment_r0 * e_x;
        let t137 = moment_r0 * e_y;
        let t138 = moment_r0 * e_z;
        let t139 = w_y * t120;
        let t140 = w_z * t119;
        let t141 = t139 - t140;
        let t142 = w_z * t118;
        let t143 = w_x * t120;
        let t144 = t142 - t143;
        let t145 = w_x * t119;
        let t146 = w_y * t118;
        let t147 = t145 - t146;
        let t148 = w_y * t123;
        let t149 = w_z * t122;
        let t150 = t148 - t149;
        let t151 = w_z * t121;
        let t152 = w_x * t123;
        let t153 = t151 - t152;
        let t154 = w_x * t122;
        let t155 = w_y * t121;
        let t156 = t154 - t155;
        let t157 = w_y * t126;
        let t158 = w_z * t125;
        let t159 = t157 - t158;
        let t160 = w_z * t124;
        let t161 = w_x * t126;
        let t162 = t160 - t161;
        let t163 = w_x * t125;
        let t164 = w_y * t124;
        let t165 = t163 - t164;
        let t166 = r0_y * t116;
        let t167 = r0_z * t117;
        let t168 = s0_y * t119;
        let t169 = s0_z * t120;
        let t170 = r1_y * t122;
        let t171 = r1_z * t123;
        let t172 = s1_y * t125;
        let t173 = s1_z * t126;
        let t174 = r0_x * t115;
        let t175 = s0_x * t118;
        let t176 = r1_x * t121;
        let t177 = s1_x * t124;
        let t178 = w_y * t116;
        let t179 = w_z * t117;
        let t180 = t178 + t179;
        let t181 = w_y * t122;
        let t182 = w_z * t123;
        let t183 = t181 + t182;
        let t184 = 2.0
            * (mass_r0_r0 * v_r0_z + mass_r0_s0 * v_s0_z + mass_r0_r1 * v_r1_z
                + mass_r0_s1 * v_s1_z);
        let t185 = t184 + (t135 - t134);
        let t186 = 2.0
            * (mass_r0_r1 * v_r0_z + mass_s0_r1 * v_s0_z + mass_r0_r0 * v_r1_z
                + mass_r1_s1 * v_s1_z);
        let t187 = t186 + (t156 - t155);
        let t188 = 2.0
            * (mass_r0_r0 * v_r0_y + mass_r0_s0 * v_s0_y + mass_r0_r1 * v_r1_y
                + mass_r0_s1 * v_s1_y);
        let t189 = t188 + (t130 + t132);
        let t190 = 2.0
            * (mass_r0_r1 * v_r0_y + mass_s0_r1 * v_s0_y + mass_r0_r0 * v_r1_y
                + mass_r1_s1 * v_s1_y);
        let t191 = t190 + (t151 + t153);
        let t192 = t184 + (t133 + t135);
        let t193 = t186 + (t154 + t156);
        let t194 = w_x * t115;
        let t195 = t179 + t194;
        let t196 = w_x * t121;
        let t197 = t182 + t196;
        let t198 = 2.0
            * (mass_r0_r0 * v_r0_x + mass_r0_s0 * v_s0_x + mass_r0_r1 * v_r1_x
                + mass_r0_s1 * v_s1_x);
        let t199 = t198 + (t129 - t128);
        let t200 = 2.0
            * (mass_r0_r1 * v_r0_x + mass_s0_r1 * v_s0_x + mass_r0_r0 * v_r1_x
                + mass_r1_s1 * v_s1_x);
        let t201 = t200 + (t150 - t149);
        let t202 = t188 + (t132 - t131);
        let t203 = t190 + (t153 - t152);
        let t204 = t198 + (t127 + t129);
        let t205 = t200 + (t148 + t150);
        let t206 = t178 + t194;
        let t207 = t181 + t196;
        let t208 = 2.0
            * (mass_r0_s0 * v_r0_z + mass_s0_s0 * v_s0_z + mass_s0_r1 * v_r1_z
                + mass_s0_s1 * v_s1_z);
        let t209 = 2.0
            * (mass_r0_s0 * v_r0_y + mass_s0_s0 * v_s0_y + mass_s0_r1 * v_r1_y
                + mass_s0_s1 * v_s1_y);
        let t210 = t208 + (t145 + t147);
        let t211 = t209 + (t144 - t143);
        let t212 = r0_y * t202 + r0_z * t192 + (s0_y * t211 + s0_z * t210)
            + (r1_y * t203 + r1_z * t193);
        let t213 = 2.0
            * (mass_r0_s1 * v_r0_z + mass_s0_s1 * v_s0_z + mass_r1_s1 * v_r1_z
                + mass_s0_s0 * v_s1_z);
        let t214 = 2.0
            * (mass_r0_s1 * v_r0_y + mass_s0_s1 * v_s0_y + mass_r1_s1 * v_r1_y
                + mass_s0_s0 * v_s1_y);
        let t215 = t213 + (t163 + t165);
        let t216 = t214 + (t162 - t161);
        let t217 = 2.0
            * (mass_r0_s0 * v_r0_x + mass_s0_s0 * v_s0_x + mass_s0_r1 * v_r1_x
                + mass_s0_s1 * v_s1_x);
        let t218 = w_z * t120;
        let t219 = w_x * t118;
        let t220 = t218 + t219;
        let t221 = t217 + (t139 + t141);
        let t222 = r0_y * t204 + r0_z * t195 + (s0_y * t221 + s0_z * t220)
            + (r1_y * t205 + r1_z * t197);
        let t223 = 2.0
            * (mass_r0_s1 * v_r0_x + mass_s0_s1 * v_s0_x + mass_r1_s1 * v_r1_x
                + mass_s0_s0 * v_s1_x);
        let t224 = w_z * t126;
        let t225 = w_x * t124;
        let t226 = t224 + t225;
        let t227 = t223 + (t157 + t159);
        let t228 = w_y * t119;
        let t229 = t219 + t228;
        let t230 = t217 + (t141 - t140);
        let t231 = r0_y * t206 - r0_z * t199 + (s0_y * t229 - s0_z * t230)
            + (r1_y * t207 - r1_z * t201);
        let t232 = w_y * t125;
        let t233 = t225 + t232;
        let t234 = t223 + (t159 - t158);
        let t235 = t218 + t228;
        let t236 = r0_z * t180 - r0_x * t202 + (s0_z * t235 - s0_x * t211)
            + (r1_z * t183 - r1_x * t203);
        let t237 = t224 + t232;
        let t238 = t208 + (t147 - t146);
        let t239 = r0_z * t185 + r0_x * t204 + (s0_z * t238 + s0_x * t221)
            + (r1_z * t187 + r1_x * t205);
        let t240 = t213 + (t165 - t164);
        let t241 = t209 + (t142 + t144);
        let t242 = r0_z * t189 + r0_x * t206 + (s0_z * t241 + s0_x * t229)
            + (r1_z * t191 + r1_x * t207);
        let t243 = t214 + (t160 + t162);
        let t244 = r0_x * t192 + r0_y * t180 + (s0_x * t210 + s0_y * t235)
            + (r1_x * t193 + r1_y * t183);
        let t245 = r0_x * t195 - r0_y * t185 + (s0_x * t220 - s0_y * t238)
            + (r1_x * t197 - r1_y * t187);
        let t246 = r0_x * t199 + r0_y * t189 + (s0_x * t230 + s0_y * t241)
            + (r1_x * t201 + r1_y * t191);
        let t247 = w_z * 2.0;
        let t248 = moment_r0 * t247;
        let t249 = w_y * 2.0;
        let t250 = moment_r0 * t249;
        let t251 = moment_s0 * t247;
        let t252 = moment_s0 * t249;
        let t253 = moment_s1 * t247;
        let t254 = moment_s1 * t249;
        let t255 = w_x * 2.0;
        let t256 = moment_r0 * t255;
        let t257 = moment_s0 * t255;
        let t258 = moment_s1 * t255;
        let t259 = t116 * t249;
        let t260 = t117 * t247;
        let t261 = t119 * t249;
        let t262 = t120 * t247;
        let t263 = t122 * t249;
        let t264 = t123 * t247;
        let t265 = t125 * t249;
        let t266 = t126 * t247;
        let t267 = t115 * t255;
        let t268 = t118 * t255;
        let t269 = t121 * t255;
        let t270 = t124 * t255;
        let t271 = w_y * w_y;
        let t272 = w_z * w_z;
        let t273 = t271 + t272;
        let t274 = -moment_r0 * t273;
        let t275 = w_x * w_y;
        let t276 = t275 - dw_z;
        let t277 = moment_r0 * t276;
        let t278 = w_x * w_z;
        let t279 = dw_y + t278;
        let t280 = moment_r0 * t279;
        let t281 = dw_z + t275;
        let t282 = moment_r0 * t281;
        let t283 = w_x * w_x;
        let t284 = t272 + t283;
        let t285 = -moment_r0 * t284;
        let t286 = w_y * w_z;
        let t287 = t286 - dw_x;
        let t288 = moment_r0 * t287;
        let t289 = t278 - dw_y;
        let t290 = moment_r0 * t289;
        let t291 = dw_x + t286;
        let t292 = moment_r0 * t291;
        let t293 = t271 + t283;
        let t294 = -moment_r0 * t293;
        let t295 = mass_r0_r0 * t84;
        let t296 = mass_r0_s0 * t93;
        let t297 = mass_r0_r1 * t102;
        let t298 = mass_r0_s1 * t111;
        let t299 = mass_r0_r0 * t83;
        let t300 = mass_r0_s0 * t92;
        let t301 = mass_r0_r1 * t101;
        let t302 = mass_r0_s1 * t110;
        let t303 = moment_s0 * e_z + mass_r0_s0 * t84;
        let t304 = mass_s0_s0 * t93;
        let t305 = mass_s0_r1 * t102;
        let t306 = mass_s0_s1 * t111;
        let t307 = moment_s0 * e_y + mass_r0_s0 * t83;
        let t308 = mass_s0_s0 * t92;
        let t309 = mass_s0_r1 * t101;
        let t310 = mass_s0_s1 * t110;
        let t311 = t138 + mass_r0_r1 * t84 + mass_s0_r1 * t93;
        let t312 = mass_r0_r0 * t102;
        let t313 = mass_r1_s1 * t111;
        let t314 = t137 + mass_r0_r1 * t83 + mass_s0_r1 * t92;
        let t315 = mass_r0_r0 * t101;
        let t316 = mass_r1_s1 * t110;
        let t317 = moment_s1 * e_z + mass_r0_s1 * t84 + mass_s0_s1 * t93
            + mass_r1_s1 * t102;
        let t318 = mass_s0_s0 * t111;
        let t319 = moment_s1 * e_y + mass_r0_s1 * t83 + mass_s0_s1 * t92
            + mass_r1_s1 * t101;
        let t320 = mass_s0_s0 * t110;
        let t321 = mass_r0_r0 * t82;
        let t322 = mass_r0_s0 * t91;
        let t323 = mass_r0_r1 * t100;
        let t324 = mass_r0_s1 * t109;
        let t325 = moment_s0 * e_x + mass_r0_s0 * t82;
        let t326 = mass_s0_s0 * t91;
        let t327 = mass_s0_r1 * t100;
        let t328 = mass_s0_s1 * t109;
        let t329 = t136 + mass_r0_r1 * t82 + mass_s0_r1 * t91;
        let t330 = mass_r0_r0 * t100;
        let t331 = mass_r1_s1 * t109;
        let t332 = moment_s1 * e_x + mass_r0_s1 * t82 + mass_s0_s1 * t91
            + mass_r1_s1 * t100;
        let t333 = mass_s0_s0 * t109;
        mass[0] = element_mass;
        mass[4] = t114;
        mass[5] = -t113;
        mass[6] = moment_r0;
        mass[9] = moment_s0;
        mass[12] = moment_r0;
        mass[15] = moment_s1;
        mass[19] = element_mass;
        mass[21] = -t114;
        mass[23] = t112;
        mass[25] = moment_r0;
        mass[28] = moment_s0;
        mass[31] = moment_r0;
        mass[34] = moment_s1;
        mass[38] = element_mass;
        mass[39] = t113;
        mass[40] = -t112;
        mass[44] = moment_r0;
        mass[47] = moment_s0;
        mass[50] = moment_r0;
        mass[53] = moment_s1;
        mass[55] = -t114;
        mass[56] = t113;
        mass[57] = t166 + t167 + (t168 + t169) + (t170 + t171) + (t172 + t173);
        mass[58] = -(r0_x * t116 + s0_x * t119 + r1_x * t122 + s1_x * t125);
        mass[59] = -(r0_x * t117 + s0_x * t120 + r1_x * t123 + s1_x * t126);
        mass[61] = -t117;
        mass[62] = t116;
        mass[64] = -t120;
        mass[65] = t119;
        mass[67] = -t123;
        mass[68] = t122;
        mass[70] = -t126;
        mass[71] = t125;
        mass[72] = t114;
        mass[74] = -t112;
        mass[75] = -(r0_y * t115 + s0_y * t118 + r1_y * t121 + s1_y * t124);
        mass[76] = t167 + t174 + (t169 + t175) + (t171 + t176) + (t173 + t177);
        mass[77] = -(r0_y * t117 + s0_y * t120 + r1_y * t123 + s1_y * t126);
        mass[78] = t117;
        mass[80] = -t115;
        mass[81] = t120;
        mass[83] = -t118;
        mass[84] = t123;
        mass[86] = -t121;
        mass[87] = t126;
        mass[89] = -t124;
        mass[90] = -t113;
        mass[91] = t112;
        mass[93] = -(r0_z * t115 + s0_z * t118 + r1_z * t121 + s1_z * t124);
        mass[94] = -(r0_z * t116 + s0_z * t119 + r1_z * t122 + s1_z * t125);
        mass[95] = t166 + t174 + (t168 + t175) + (t170 + t176) + (t172 + t177);
        mass[96] = -t116;
        mass[97] = t115;
        mass[99] = -t119;
        mass[100] = t118;
        mass[102] = -t122;
        mass[103] = t121;
        mass[105] = -t125;
        mass[106] = t124;
        damping[0] = t180 + t183;
        damping[1] = t185 + t187;
        damping[2] = -(t189 + t191);
        damping[15] = -(t192 + t193);
        damping[16] = t195 + t197;
        damping[17] = t199 + t201;
        damping[30] = t202 + t203;
        damping[31] = -(t204 + t205);
        damping[32] = t206 + t207;
        damping[45] = t212 + (s1_y * t216 + s1_z * t215);
        damping[46] = -(t222 + (s1_y * t227 + s1_z * t226));
        damping[47] = t231 + (s1_y * t233 - s1_z * t234);
        damping[60] = t236 + (s1_z * t237 - s1_x * t216);
        damping[61] = t239 + (s1_z * t240 + s1_x * t227);
        damping[62] = -(t242 + (s1_z * t243 + s1_x * t233));
        damping[75] = -(t244 + (s1_x * t215 + s1_y * t237));
        damping[76] = t245 + (s1_x * t226 - s1_y * t240);
        damping[77] = t246 + (s1_x * t234 + s1_y * t243);
        damping[4] = -t248;
        damping[5] = t250;
        damping[7] = -t251;
        damping[8] = t252;
        damping[10] = -t248;
        damping[11] = t250;
        damping[13] = -t253;
        damping[14] = t254;
        damping[18] = t248;
        damping[20] = -t256;
        damping[21] = t251;
        damping[23] = -t257;
        damping[24] = t248;
        damping[26] = -t256;
        damping[27] = t253;
        damping[29] = -t258;
        damping[33] = -t250;
        damping[34] = t256;
        damping[36] = -t252;
        damping[37] = t257;
        damping[39] = -t250;
        damping[40] = t256;
        damping[42] = -t254;
        damping[43] = t258;
        damping[48] = -(t259 + t260);
        damping[49] = t116 * t255;
        damping[50] = t117 * t255;
        damping[51] = -(t261 + t262);
        damping[52] = t119 * t255;
        damping[53] = t120 * t255;
        damping[54] = -(t263 + t264);
        damping[55] = t122 * t255;
        damping[56] = t123 * t255;
        damping[57] = -(t265 + t266);
        damping[58] = t125 * t255;
        damping[59] = t126 * t255;
        damping[63] = t115 * t249;
        damping[64] = -(t260 + t267);
        damping[65] = t117 * t249;
        damping[66] = t118 * t249;
        damping[67] = -(t262 + t268);
        damping[68] = t120 * t249;
        damping[69] = t121 * t249;
        damping[70] = -(t264 + t269);
        damping[71] = t123 * t249;
        damping[72] = t124 * t249;
        damping[73] = -(t266 + t270);
        damping[74] = t126 * t249;
        damping[78] = t115 * t247;
        damping[79] = t116 * t247;
        damping[80] = -(t259 + t267);
        damping[81] = t118 * t247;
        damping[82] = t119 * t247;
        damping[83] = -(t261 + t268);
        damping[84] = t121 * t247;
        damping[85] = t122 * t247;
        damping[86] = -(t263 + t269);
        damping[87] = t124 * t247;
        damping[88] = t125 * t247;
        damping[89] = -(t265 + t270);
        spin[0] = t180;
        spin[1] = t185;
        spin[2] = -t189;
        spin[3] = -t192;
        spin[4] = t195;
        spin[5] = t199;
        spin[6] = t202;
        spin[7] = -t204;
        spin[8] = t206;
        spin[9] = t235;
        spin[10] = t238;
        spin[11] = -t241;
        spin[12] = -t210;
        spin[13] = t220;
        spin[14] = t230;
        spin[15] = t211;
        spin[16] = -t221;
        spin[17] = t229;
        spin[18] = t183;
        spin[19] = t187;
        spin[20] = -t191;
        spin[21] = -t193;
        spin[22] = t197;
        spin[23] = t201;
        spin[24] = t203;
        spin[25] = -t205;
        spin[26] = t207;
        spin[27] = t237;
        spin[28] = t240;
        spin[29] = -t243;
        spin[30] = -t215;
        spin[31] = t226;
        spin[32] = t234;
        spin[33] = t216;
        spin[34] = -t227;
        spin[35] = t233;
        stiffness[0] = t274;
        stiffness[1] = t277;
        stiffness[2] = t280;
        stiffness[3] = -moment_s0 * t273;
        stiffness[4] = moment_s0 * t276;
        stiffness[5] = moment_s0 * t279;
        stiffness[6] = t274;
        stiffness[7] = t277;
        stiffness[8] = t280;
        stiffness[9] = -moment_s1 * t273;
        stiffness[10] = moment_s1 * t276;
        stiffness[11] = moment_s1 * t279;
        stiffness[12] = t282;
        stiffness[13] = t285;
        stiffness[14] = t288;
        stiffness[15] = moment_s0 * t281;
        stiffness[16] = -moment_s0 * t284;
        stiffness[17] = moment_s0 * t287;
        stiffness[18] = t282;
        stiffness[19] = t285;
        stiffness[20] = t288;
        stiffness[21] = moment_s1 * t281;
        stiffness[22] = -moment_s1 * t284;
        stiffness[23] = moment_s1 * t287;
        stiffness[24] = t290;
        stiffness[25] = t292;
        stiffness[26] = t294;
        stiffness[27] = moment_s0 * t289;
        stiffness[28] = moment_s0 * t291;
        stiffness[29] = -moment_s0 * t293;
        stiffness[30] = t290;
        stiffness[31] = t292;
        stiffness[32] = t294;
        stiffness[33] = moment_s1 * t289;
        stiffness[34] = moment_s1 * t291;
        stiffness[35] = -moment_s1 * t293;
        stiffness[36] = t116 * t289 - t117 * t281;
        stiffness[37] = t138 + (t116 * t291 + t295 + t117 * t284) + t296 + t297 + t298;
        stiffness[38] = -(t137 + (t116 * t293 + (t117 * t287 + t299)) + t300 + t301
            + t302);
        stiffness[39] = t119 * t289 - t120 * t281;
        stiffness[40] = t303 + (t119 * t291 + t304 + t120 * t284) + t305 + t306;
        stiffness[41] = -(t307 + (t119 * t293 + (t120 * t287 + t308)) + t309 + t310);
        stiffness[42] = t122 * t289 - t123 * t281;
        stiffness[43] = t311 + (t122 * t291 + t312 + t123 * t284) + t313;
        stiffness[44] = -(t314 + (t122 * t293 + (t123 * t287 + t315)) + t316);
        stiffness[45] = t125 * t289 - t126 * t281;
        stiffness[46] = t317 + (t125 * t291 + t318 + t126 * t284);
        stiffness[47] = -(t319 + (t125 * t293 + (t126 * t287 + t320)));
        stiffness[48] = -(t298
            + (t297 + (t296 + (t138 + (t117 * t273 + (t295 + t115 * t289))))));
        stiffness[49] = t117 * t276 - t115 * t291;
        stiffness[50] = t136 + (t117 * t279 + t321 + t115 * t293) + t322 + t323 + t324;
        stiffness[51] = -(t306 + (t305 + (t303 + (t120 * t273 + (t304 + t118 * t289)))));
        stiffness[52] = t120 * t276 - t118 * t291;
        stiffness[53] = t325 + (t120 * t279 + t326 + t118 * t293) + t327 + t328;
        stiffness[54] = -(t313 + (t311 + (t123 * t273 + (t312 + t121 * t289))));
        stiffness[55] = t123 * t276 - t121 * t291;
        stiffness[56] = t329 + (t123 * t279 + t330 + t121 * t293) + t331;
        stiffness[57] = -(t317 + (t126 * t273 + (t318 + t124 * t289)));
        stiffness[58] = t126 * t276 - t124 * t291;
        stiffness[59] = t332 + (t126 * t279 + t333 + t124 * t293);
        stiffness[60] = t302
            + (t301 + (t300 + (t137 + (t299 + t115 * t281 + t116 * t273))));
        stiffness[61] = -(t324
            + (t323 + (t322 + (t136 + (t115 * t284 + (t321 + t116 * t276))))));
        stiffness[62] = t115 * t287 - t116 * t279;
        stiffness[63] = t310 + (t309 + (t307 + (t308 + t118 * t281 + t119 * t273)));
        stiffness[64] = -(t328 + (t327 + (t325 + (t118 * t284 + (t326 + t119 * t276)))));
        stiffness[65] = t118 * t287 - t119 * t279;
        stiffness[66] = t316 + (t314 + (t315 + t121 * t281 + t122 * t273));
        stiffness[67] = -(t331 + (t329 + (t121 * t284 + (t330 + t122 * t276))));
        stiffness[68] = t121 * t287 - t122 * t279;
        stiffness[69] = t319 + (t320 + t124 * t281 + t125 * t273);
        stiffness[70] = -(t332 + (t124 * t284 + (t333 + t125 * t276)));
        stiffness[71] = t124 * t287 - t125 * t279;
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
        let t17 = 1.0 / length;
        let t18 = xi * 3.0;
        weights[0] = xi * (-6.0 + xi * 6.0) * t17;
        weights[1] = 1.0 + xi * (-4.0 + t18);
        weights[2] = t17 * (xi * (6.0 + xi * (-6.0)));
        weights[3] = xi * (t18 + (-2.0));
    }
    /// Weights of the nodal vectors in d2/dx2 of the position at xi in [0, 1]; the others are left alone.
    ///
    /// Operations: 4 additions, 8 multiplications, 2 divisions.
    pub fn cable_spatial_exact_damped_shapes_position_2(
        length: f64,
        xi: f64,
        weights: &mut [f64; 4],
    ) {
        let t17 = 1.0 / (length * length);
        let t18 = xi * 6.0;
        let t19 = 1.0 / length;
        weights[0] = (-6.0 + xi * 12.0) * t17;
        weights[1] = (-4.0 + t18) * t19;
        weights[2] = t17 * (6.0 + xi * (-12.0));
        weights[3] = t19 * (t18 + (-2.0));
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
        let t30 = fields[0] * fields[0] + fields[1] * fields[1] + fields[2] * fields[2];
        let t31 = fields[0] * fields[3] + fields[1] * fields[4] + fields[2] * fields[5];
        let t32 = fields[3] * fields[3] + fields[4] * fields[4] + fields[5] * fields[5];
        let t33 = t30 * t32 - t31 * t31;
        let t34 = t30 * t30;
        let t35 = 1.0 / t34;
        let t36 = 0.5 * (t30 - 1.0)
            - 0.5
                * (stress_free[0] * stress_free[0] + stress_free[1] * stress_free[1]
                    + stress_free[2] * stress_free[2] - 1.0);
        let t37 = fields[0] * 2.0;
        let t38 = fields[1] * 2.0;
        let t39 = fields[2] * 2.0;
        let t40 = EA
            * (t36
                + damping * (0.5 * (rates[0] * t37 + rates[1] * t38 + rates[2] * t39)));
        let t41 = t31 * 2.0;
        let t42 = t30 * 2.0;
        let t43 = t35 * (t32 * t37 - fields[3] * t41) - t33 * (t35 * (t37 * t42) / t34);
        let t44 = t35 * (t32 * t38 - fields[4] * t41) - t33 * (t35 * (t38 * t42) / t34);
        let t45 = t35 * (t32 * t39 - fields[5] * t41) - t33 * (t35 * (t39 * t42) / t34);
        forces[0] = t40 * (0.5 * t37) + EI * (0.5 * t43);
        forces[1] = t40 * (0.5 * t38) + EI * (0.5 * t44);
        forces[2] = t40 * (0.5 * t39) + EI * (0.5 * t45);
        forces[3] = EI * (0.5 * (t35 * (t30 * (fields[3] * 2.0) - fields[0] * t41)));
        forces[4] = EI * (0.5 * (t35 * (t30 * (fields[4] * 2.0) - fields[1] * t41)));
        forces[5] = EI * (0.5 * (t35 * (t30 * (fields[5] * 2.0) - fields[2] * t41)));
    }
    /// Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in the inertial frame; e is minus gravity: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 18 additions, 18 multiplications.
    pub fn fixture_spatial_absolute_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        a: &[f64; 6],
        force: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        force[0] += m * a_r_x + m_x * a_s_x + m * e_x;
        force[1] += m * a_r_y + m_x * a_s_y + m * e_y;
        force[2] += m * a_r_z + m_x * a_s_z + m * e_z;
        force[3] += m_x * a_r_x + p_xx * a_s_x + m_x * e_x;
        force[4] += m_x * a_r_y + p_xx * a_s_y + m_x * e_y;
        force[5] += m_x * a_r_z + p_xx * a_s_z + m_x * e_z;
    }
    /// Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in a moving frame: mass, first moments and second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e.
    ///
    /// Operations: 60 additions, 72 multiplications.
    pub fn fixture_spatial_inertia_force(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        force: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        force[0] += m * t51 + m_x * t60 + m * e_x;
        force[1] += m * t52 + m_x * t61 + m * e_y;
        force[2] += m * t53 + m_x * t62 + m * e_z;
        force[3] += m_x * t51 + p_xx * t60 + m_x * e_x;
        force[4] += m_x * t52 + p_xx * t61 + m_x * e_y;
        force[5] += m_x * t53 + p_xx * t62 + m_x * e_z;
    }
    /// Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).
    ///
    /// Operations: 69 additions, 57 multiplications.
    pub fn fixture_spatial_inertia_tangent(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        stiffness: &mut [f64; 36],
        damping_matrix: &mut [f64; 36],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let t24 = w_y * w_y;
        let t25 = w_z * w_z;
        let t26 = t24 + t25;
        let t27 = w_x * w_y;
        let t28 = t27 - dw_z;
        let t29 = w_x * w_z;
        let t30 = dw_y + t29;
        let t31 = dw_z + t27;
        let t32 = w_x * w_x;
        let t33 = t25 + t32;
        let t34 = w_y * w_z;
        let t35 = t34 - dw_x;
        let t36 = t29 - dw_y;
        let t37 = dw_x + t34;
        let t38 = t24 + t32;
        let t39 = w_z * 2.0;
        let t40 = m * t39;
        let t41 = w_y * 2.0;
        let t42 = m * t41;
        let t43 = m_x * t39;
        let t44 = m_x * t41;
        let t45 = w_x * 2.0;
        let t46 = m * t45;
        let t47 = m_x * t45;
        let t48 = m_x * t39;
        let t49 = m_x * t41;
        let t50 = p_xx * t39;
        let t51 = p_xx * t41;
        let t52 = m_x * t45;
        let t53 = p_xx * t45;
        stiffness[0] += -m * t26;
        stiffness[1] += m * t28;
        stiffness[2] += m * t30;
        stiffness[3] += -m_x * t26;
        stiffness[4] += m_x * t28;
        stiffness[5] += m_x * t30;
        stiffness[6] += m * t31;
        stiffness[7] += -m * t33;
        stiffness[8] += m * t35;
        stiffness[9] += m_x * t31;
        stiffness[10] += -m_x * t33;
        stiffness[11] += m_x * t35;
        stiffness[12] += m * t36;
        stiffness[13] += m * t37;
        stiffness[14] += -m * t38;
        stiffness[15] += m_x * t36;
        stiffness[16] += m_x * t37;
        stiffness[17] += -m_x * t38;
        stiffness[18] += -m_x * t26;
        stiffness[19] += m_x * t28;
        stiffness[20] += m_x * t30;
        stiffness[21] += -p_xx * t26;
        stiffness[22] += p_xx * t28;
        stiffness[23] += p_xx * t30;
        stiffness[24] += m_x * t31;
        stiffness[25] += -m_x * t33;
        stiffness[26] += m_x * t35;
        stiffness[27] += p_xx * t31;
        stiffness[28] += -p_xx * t33;
        stiffness[29] += p_xx * t35;
        stiffness[30] += m_x * t36;
        stiffness[31] += m_x * t37;
        stiffness[32] += -m_x * t38;
        stiffness[33] += p_xx * t36;
        stiffness[34] += p_xx * t37;
        stiffness[35] += -p_xx * t38;
        damping_matrix[1] -= t40;
        damping_matrix[2] += t42;
        damping_matrix[4] -= t43;
        damping_matrix[5] += t44;
        damping_matrix[6] += t40;
        damping_matrix[8] -= t46;
        damping_matrix[9] += t43;
        damping_matrix[11] -= t47;
        damping_matrix[12] -= t42;
        damping_matrix[13] += t46;
        damping_matrix[15] -= t44;
        damping_matrix[16] += t47;
        damping_matrix[19] -= t48;
        damping_matrix[20] += t49;
        damping_matrix[22] -= t50;
        damping_matrix[23] += t51;
        damping_matrix[24] += t48;
        damping_matrix[26] -= t52;
        damping_matrix[27] += t50;
        damping_matrix[29] -= t53;
        damping_matrix[30] -= t49;
        damping_matrix[31] += t52;
        damping_matrix[33] -= t51;
        damping_matrix[34] += t53;
    }
    /// Adds force and moment about the origin that the inertia of what the frame carries needs, in frame axes (Eqs. 11, 12): F = m e + d_b a_b, T = (d_a q_a) x e + M_ab q_a x a_b, with the accelerations a = q'' + 2 w x q' + w' x q + w x (w x q) and that of the origin minus gravity, e.
    ///
    /// Operations: 78 additions, 96 multiplications.
    pub fn fixture_spatial_carried(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        out: &mut [f64; 6],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        let t63 = m * r_x;
        let t64 = t63 + m_x * s_x;
        let t65 = m * r_y;
        let t66 = t65 + m_x * s_y;
        let t67 = m * r_z;
        let t68 = t67 + m_x * s_z;
        let t69 = t63 + m_x * s_x;
        let t70 = t65 + m_x * s_y;
        let t71 = t67 + m_x * s_z;
        let t72 = m_x * r_x + p_xx * s_x;
        let t73 = m_x * r_y + p_xx * s_y;
        let t74 = m_x * r_z + p_xx * s_z;
        let t75 = e_z * t66 - e_y * t68 + (t53 * t70 - t52 * t71)
            + (t62 * t73 - t61 * t74);
        let t76 = e_x * t68 - e_z * t64 + (t51 * t71 - t53 * t69)
            + (t60 * t74 - t62 * t72);
        let t77 = e_y * t64 - e_x * t66 + (t52 * t69 - t51 * t70)
            + (t61 * t72 - t60 * t73);
        out[0] += m * t51 + m_x * t60 + m * e_x;
        out[1] += m * t52 + m_x * t61 + m * e_y;
        out[2] += m * t53 + m_x * t62 + m * e_z;
        out[3] += t75;
        out[4] += t76;
        out[5] += t77;
    }
    /// Writes the derivatives of force F and moment T on the frame, rows first (THEORY 2.1): `mass` with respect to e, w', q''; `damping` to w, q'; `stiffness` to q; and of the nodal forces with respect to w, `spin`. Entries that are always zero are left alone.
    ///
    /// Operations: 204 additions, 267 multiplications.
    pub fn fixture_spatial_carried_tangent(
        constants: [f64; 10],
        frame: &::rncf::mesh::FrameAction,
        q: &[f64; 6],
        v: &[f64; 6],
        a: &[f64; 6],
        mass: &mut [f64; 72],
        damping: &mut [f64; 54],
        spin: &mut [f64; 18],
        stiffness: &mut [f64; 36],
    ) {
        let [m, m_x, _, _, p_xx, _, _, _, _, _] = constants;
        let [e_x, e_y, e_z] = frame.acceleration;
        let ([w_x, w_y, w_z], [dw_x, dw_y, dw_z]) = (frame.spin, frame.spin_rate);
        let [r_x, r_y, r_z, s_x, s_y, s_z] = *q;
        let [v_r_x, v_r_y, v_r_z, v_s_x, v_s_y, v_s_z] = *v;
        let [a_r_x, a_r_y, a_r_z, a_s_x, a_s_y, a_s_z] = *a;
        let t45 = r_z * w_y - r_y * w_z;
        let t46 = r_x * w_z - r_z * w_x;
        let t47 = r_y * w_x - r_x * w_y;
        let t48 = r_z * dw_y - r_y * dw_z + (a_r_x + 2.0 * (v_r_z * w_y - v_r_y * w_z));
        let t49 = r_x * dw_z - r_z * dw_x + (a_r_y + 2.0 * (v_r_x * w_z - v_r_z * w_x));
        let t50 = r_y * dw_x - r_x * dw_y + (a_r_z + 2.0 * (v_r_y * w_x - v_r_x * w_y));
        let t51 = w_y * t47 - w_z * t46 + t48;
        let t52 = w_z * t45 - w_x * t47 + t49;
        let t53 = w_x * t46 - w_y * t45 + t50;
        let t54 = s_z * w_y - s_y * w_z;
        let t55 = s_x * w_z - s_z * w_x;
        let t56 = s_y * w_x - s_x * w_y;
        let t57 = s_z * dw_y - s_y * dw_z + (a_s_x + 2.0 * (v_s_z * w_y - v_s_y * w_z));
        let t58 = s_x * dw_z - s_z * dw_x + (a_s_y + 2.0 * (v_s_x * w_z - v_s_z * w_x));
        let t59 = s_y * dw_x - s_x * dw_y + (a_s_z + 2.0 * (v_s_y * w_x - v_s_x * w_y));
        let t60 = w_y * t56 - w_z * t55 + t57;
        let t61 = w_z * t54 - w_x * t56 + t58;
        let t62 = w_x * t55 - w_y * t54 + t59;
        let t63 = m * t51;
        let t64 = m_x * t60;
        let t65 = m * t52;
        let t66 = m_x * t61;
        let t67 = m * t53;
        let t68 = m_x * t62;
        let t69 = m * e_x;
        let t70 = m * e_y;
        let t71 = m * e_z;
        let t72 = m * r_x;
        let t73 = t72 + m_x * s_x;
        let t74 = m * r_y;
        let t75 = t74 + m_x * s_y;
        let t76 = m * r_z;
        let t77 = t76 + m_x * s_z;
        let t78 = t72 + m_x * s_x;
        let t79 = t74 + m_x * s_y;
        let t80 = t76 + m_x * s_z;
        let t81 = p_xx * s_x;
        let t82 = m_x * r_x + t81;
        let t83 = p_xx * s_y;
        let t84 = m_x * r_y + t83;
        let t85 = p_xx * s_z;
        let t86 = m_x * r_z + t85;
        let t87 = w_y * t77;
        let t88 = w_z * t75;
        let t89 = t87 - t88;
        let t90 = w_z * t73;
        let t91 = w_x * t77;
        let t92 = t90 - t91;
        let t93 = w_x * t75;
        let t94 = w_y * t73;
        let t95 = t93 - t94;
        let t96 = t81 + m_x * r_x;
        let t97 = t83 + m_x * r_y;
        let t98 = t85 + m_x * r_z;
        let t99 = w_y * t98;
        let t100 = w_z * t97;
        let t101 = t99 - t100;
        let t102 = w_z * t96;
        let t103 = w_x * t98;
        let t104 = t102 - t103;
        let t105 = w_x * t97;
        let t106 = w_y * t96;
        let t107 = t105 - t106;
        let t108 = r_y * t79;
        let t109 = r_z * t80;
        let t110 = s_y * t84;
        let t111 = s_z * t86;
        let t112 = r_x * t78;
        let t113 = s_x * t82;
        let t114 = w_y * t75;
        let t115 = w_z * t77;
        let t116 = t114 + t115;
        let t117 = 2.0 * (m * v_r_z + m_x * v_s_z);
        let t118 = t117 + (t95 - t94);
        let t119 = 2.0 * (m * v_r_y + m_x * v_s_y);
        let t120 = t119 + (t90 + t92);
        let t121 = t117 + (t93 + t95);
        let t122 = w_x * t73;
        let t123 = t115 + t122;
        let t124 = 2.0 * (m * v_r_x + m_x * v_s_x);
        let t125 = t124 + (t89 - t88);
        let t126 = t119 + (t92 - t91);
        let t127 = t124 + (t87 + t89);
        let t128 = t114 + t122;
        let t129 = 2.0 * (m_x * v_r_z + p_xx * v_s_z);
        let t130 = 2.0 * (m_x * v_r_y + p_xx * v_s_y);
        let t131 = t129 + (t105 + t107);
        let t132 = t130 + (t104 - t103);
        let t133 = 2.0 * (m_x * v_r_x + p_xx * v_s_x);
        let t134 = w_z * t98;
        let t135 = w_x * t96;
        let t136 = t134 + t135;
        let t137 = t133 + (t99 + t101);
        let t138 = w_y * t97;
        let t139 = t135 + t138;
        let t140 = t133 + (t101 - t100);
        let t141 = t134 + t138;
        let t142 = t129 + (t107 - t106);
        let t143 = t130 + (t102 + t104);
        let t144 = w_z * 2.0;
        let t145 = m * t144;
        let t146 = w_y * 2.0;
        let t147 = m * t146;
        let t148 = m_x * t144;
        let t149 = m_x * t146;
        let t150 = w_x * 2.0;
        let t151 = m * t150;
        let t152 = m_x * t150;
        let t153 = t79 * t146;
        let t154 = t80 * t144;
        let t155 = t84 * t146;
        let t156 = t86 * t144;
        let t157 = t78 * t150;
        let t158 = t82 * t150;
        let t159 = w_y * w_y;
        let t160 = w_z * w_z;
        let t161 = t159 + t160;
        let t162 = w_x * w_y;
        let t163 = t162 - dw_z;
        let t164 = w_x * w_z;
        let t165 = dw_y + t164;
        let t166 = dw_z + t162;
        let t167 = w_x * w_x;
        let t168 = t160 + t167;
        let t169 = w_y * w_z;
        let t170 = t169 - dw_x;
        let t171 = t164 - dw_y;
        let t172 = dw_x + t169;
        let t173 = t159 + t167;
        let t174 = m_x * e_z + m_x * t53;
        let t175 = p_xx * t62;
        let t176 = m_x * e_y + m_x * t52;
        let t177 = p_xx * t61;
        let t178 = m_x * e_x + m_x * t51;
        let t179 = p_xx * t60;
        mass[0] = m;
        mass[4] = t77;
        mass[5] = -t75;
        mass[6] = m;
        mass[9] = m_x;
        mass[13] = m;
        mass[15] = -t77;
        mass[17] = t73;
        mass[19] = m;
        mass[22] = m_x;
        mass[26] = m;
        mass[27] = t75;
        mass[28] = -t73;
        mass[32] = m;
        mass[35] = m_x;
        mass[37] = -t77;
        mass[38] = t75;
        mass[39] = t108 + t109 + (t110 + t111);
        mass[40] = -(r_x * t79 + s_x * t84);
        mass[41] = -(r_x * t80 + s_x * t86);
        mass[43] = -t80;
        mass[44] = t79;
        mass[46] = -t86;
        mass[47] = t84;
        mass[48] = t77;
        mass[50] = -t73;
        mass[51] = -(r_y * t78 + s_y * t82);
        mass[52] = t109 + t112 + (t111 + t113);
        mass[53] = -(r_y * t80 + s_y * t86);
        mass[54] = t80;
        mass[56] = -t78;
        mass[57] = t86;
        mass[59] = -t82;
        mass[60] = -t75;
        mass[61] = t73;
        mass[63] = -(r_z * t78 + s_z * t82);
        mass[64] = -(r_z * t79 + s_z * t84);
        mass[65] = t108 + t112 + (t110 + t113);
        mass[66] = -t79;
        mass[67] = t78;
        mass[69] = -t84;
        mass[70] = t82;
        damping[0] = t116;
        damping[1] = t118;
        damping[2] = -t120;
        damping[9] = -t121;
        damping[10] = t123;
        damping[11] = t125;
        damping[18] = t126;
        damping[19] = -t127;
        damping[20] = t128;
        damping[27] = r_y * t126 + r_z * t121 + (s_y * t132 + s_z * t131);
        damping[28] = -(r_y * t127 + r_z * t123 + (s_y * t137 + s_z * t136));
        damping[29] = r_y * t128 - r_z * t125 + (s_y * t139 - s_z * t140);
        damping[36] = r_z * t116 - r_x * t126 + (s_z * t141 - s_x * t132);
        damping[37] = r_z * t118 + r_x * t127 + (s_z * t142 + s_x * t137);
        damping[38] = -(r_z * t120 + r_x * t128 + (s_z * t143 + s_x * t139));
        damping[45] = -(r_x * t121 + r_y * t116 + (s_x * t131 + s_y * t141));
        damping[46] = r_x * t123 - r_y * t118 + (s_x * t136 - s_y * t142);
        damping[47] = r_x * t125 + r_y * t120 + (s_x * t140 + s_y * t143);
        damping[4] = -t145;
        damping[5] = t147;
        damping[7] = -t148;
        damping[8] = t149;
        damping[12] = t145;
        damping[14] = -t151;
        damping[15] = t148;
        damping[17] = -t152;
        damping[21] = -t147;
        damping[22] = t151;
        damping[24] = -t149;
        damping[25] = t152;
        damping[30] = -(t153 + t154);
        damping[31] = t79 * t150;
        damping[32] = t80 * t150;
        damping[33] = -(t155 + t156);
        damping[34] = t84 * t150;
        damping[35] = t86 * t150;
        damping[39] = t78 * t146;
        damping[40] = -(t154 + t157);
        damping[41] = t80 * t146;
        damping[42] = t82 * t146;
        damping[43] = -(t156 + t158);
        damping[44] = t86 * t146;
        damping[48] = t78 * t144;
        damping[49] = t79 * t144;
        damping[50] = -(t153 + t157);
        damping[51] = t82 * t144;
        damping[52] = t84 * t144;
        damping[53] = -(t155 + t158);
        spin[0] = t116;
        spin[1] = t118;
        spin[2] = -t120;
        spin[3] = -t121;
        spin[4] = t123;
        spin[5] = t125;
        spin[6] = t126;
        spin[7] = -t127;
        spin[8] = t128;
        spin[9] = t141;
        spin[10] = t142;
        spin[11] = -t143;
        spin[12] = -t131;
        spin[13] = t136;
        spin[14] = t140;
        spin[15] = t132;
        spin[16] = -t137;
        spin[17] = t139;
        stiffness[0] = -m * t161;
        stiffness[1] = m * t163;
        stiffness[2] = m * t165;
        stiffness[3] = -m_x * t161;
        stiffness[4] = m_x * t163;
        stiffness[5] = m_x * t165;
        stiffness[6] = m * t166;
        stiffness[7] = -m * t168;
        stiffness[8] = m * t170;
        stiffness[9] = m_x * t166;
        stiffness[10] = -m_x * t168;
        stiffness[11] = m_x * t170;
        stiffness[12] = m * t171;
        stiffness[13] = m * t172;
        stiffness[14] = -m * t173;
        stiffness[15] = m_x * t171;
        stiffness[16] = m_x * t172;
        stiffness[17] = -m_x * t173;
        stiffness[18] = t79 * t171 - t80 * t166;
        stiffness[19] = t68 + (t71 + (t67 + t79 * t172 + t80 * t168));
        stiffness[20] = -(t66 + (t70 + (t79 * t173 + (t65 + t80 * t170))));
        stiffness[21] = t84 * t171 - t86 * t166;
        stiffness[22] = t174 + (t84 * t172 + t175 + t86 * t168);
        stiffness[23] = -(t176 + (t84 * t173 + (t86 * t170 + t177)));
        stiffness[24] = -(t68 + (t71 + (t80 * t161 + (t67 + t78 * t171))));
        stiffness[25] = t80 * t163 - t78 * t172;
        stiffness[26] = t64 + (t69 + (t63 + t80 * t165 + t78 * t173));
        stiffness[27] = -(t174 + (t86 * t161 + (t175 + t82 * t171)));
        stiffness[28] = t86 * t163 - t82 * t172;
        stiffness[29] = t178 + (t86 * t165 + t179 + t82 * t173);
        stiffness[30] = t66 + (t70 + (t65 + t78 * t166 + t79 * t161));
        stiffness[31] = -(t64 + (t69 + (t78 * t168 + (t63 + t79 * t163))));
        stiffness[32] = t78 * t170 - t79 * t165;
        stiffness[33] = t176 + (t177 + t82 * t166 + t84 * t161);
        stiffness[34] = -(t178 + (t82 * t168 + (t179 + t84 * t163)));
        stiffness[35] = t82 * t170 - t84 * t165;
    }
    /// Motion of frame `pin_frame` and its first three derivatives.
    ///
    /// Moves with the crank's pin, which begins at the origin; the crank's axis lies below it.
    ///
    /// Operations: 18 additions, 37 multiplications, 6 divisions, 4 function calls.
    pub fn frame_pin_frame(
        model: &super::SliderCrank,
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
        let t23 = theta.sin();
        let t24 = theta.cos();
        let t25 = 6.283185307179586 / model.T_s;
        let t26 = t25 * t20.sin();
        let t27 = (if t <= model.T_s { t18 * (t - t19 * t26) } else { model.omega_s });
        let t28 = t24 * t27;
        let t29 = t23 * t27;
        let t30 = (if t <= model.T_s {
            t18 * (1.0 - t19 * (t25 * (t21 * t25)))
        } else {
            0.0
        });
        let t31 = t24 * t30 - t27 * t29;
        let t32 = t27 * t28 + t23 * t30;
        let t33 = (if t <= model.T_s { t18 * (t19 * (t25 * (t25 * t26))) } else { 0.0 });
        let t34 = t29 * t30;
        let t35 = t28 * t30;
        motion.position[1] = -0.14 * t23;
        motion.position[2] = 0.14 * (t24 - 1.0);
        motion.velocity[1] = -0.14 * t28;
        motion.velocity[2] = -0.14 * t29;
        motion.acceleration[1] = -0.14 * t31;
        motion.acceleration[2] = -0.14 * t32;
        motion.jerk[1] = -0.14 * (t24 * t33 - t34 - (t34 + t27 * t32));
        motion.jerk[2] = -0.14 * (t35 + t27 * t31 + (t35 + t23 * t33));
    }
    /// Free frame `rod`: its start relative to its parent, and its rigid parts.
    ///
    /// Frame of the rod.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn free_rod(model: &super::SliderCrank, spec: &mut ::rncf::mesh::FreeSpec) {
        spec.axis[2] = 1.0;
    }
    /// Joint `root`: conditions, position level.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn joint_root_referenced_position(
        model: &super::SliderCrank,
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
    /// Joint `root`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_velocity(
        model: &super::SliderCrank,
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
    /// Joint `root`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_acceleration(
        model: &super::SliderCrank,
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
    /// Joint `root`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jerk(
        model: &super::SliderCrank,
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
    /// Joint `root`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_jacobian(
        model: &super::SliderCrank,
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
        jacobian[7] = 1.0;
        jacobian[8] = 0.0;
        jacobian[9] = 0.0;
        jacobian[10] = 0.0;
        jacobian[11] = 0.0;
        jacobian[12] = 0.0;
        jacobian[13] = 0.0;
        jacobian[14] = 1.0;
        jacobian[15] = 0.0;
        jacobian[16] = 0.0;
        jacobian[17] = 0.0;
    }
    /// Joint `root`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_root_referenced_prescribed(
        model: &super::SliderCrank,
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
    }
    /// Joint `chord_y`: conditions, position level.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_position(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[1] - data.point[1];
    }
    /// Joint `chord_y`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_velocity(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_y`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_acceleration(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_y`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_jerk(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_y`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_jacobian(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 0.0;
        jacobian[1] = 1.0;
        jacobian[2] = 0.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
    }
    /// Joint `chord_y`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_y_referenced_prescribed(
        model: &super::SliderCrank,
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
    }
    /// Joint `chord_z`: conditions, position level.
    ///
    /// Operations: 1 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_position(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = q[2] - data.point[2];
    }
    /// Joint `chord_z`: conditions, velocity level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_velocity(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_z`: conditions, acceleration level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_acceleration(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_z`: conditions, jerk level.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_jerk(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    ) {
        rows[0] = 0.0;
    }
    /// Joint `chord_z`: derivatives of the conditions.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_jacobian(
        model: &super::SliderCrank,
        t: f64,
        data: &::rncf::mesh::JointData,
        jacobian: &mut [f64],
    ) {
        jacobian[0] = 0.0;
        jacobian[1] = 0.0;
        jacobian[2] = 1.0;
        jacobian[3] = 0.0;
        jacobian[4] = 0.0;
        jacobian[5] = 0.0;
    }
    /// Joint `chord_z`: what it prescribes, with three derivatives.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn joint_chord_z_referenced_prescribed(
        model: &super::SliderCrank,
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t33 = z[2][1][0] * (z[0][0][0] - z[1][0][0])
            + z[2][0][0] * (z[0][1][0] - z[1][1][0])
            + (z[2][1][1] * (z[0][0][1] - z[1][0][1])
                + z[2][0][1] * (z[0][1][1] - z[1][1][1]));
        rows[0] = t33
            + (z[2][1][2] * (z[0][0][2] - z[1][0][2])
                + z[2][0][2] * (z[0][1][2] - z[1][1][2]));
    }
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): their second time derivative.
    ///
    /// Operations: 20 additions, 9 multiplications.
    pub fn constraint_acceleration_chord_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t42 = z[2][1][0] * (z[0][1][0] - z[1][1][0]);
        let t43 = z[2][1][1] * (z[0][1][1] - z[1][1][1]);
        let t44 = z[2][2][0] * (z[0][0][0] - z[1][0][0]) + t42
            + (t42 + z[2][0][0] * (z[0][2][0] - z[1][2][0]))
            + (z[2][2][1] * (z[0][0][1] - z[1][0][1]) + t43
                + (t43 + z[2][0][1] * (z[0][2][1] - z[1][2][1])));
        let t45 = z[2][1][2] * (z[0][1][2] - z[1][1][2]);
        rows[0] = t44
            + (z[2][2][2] * (z[0][0][2] - z[1][0][2]) + t45
                + (t45 + z[2][0][2] * (z[0][2][2] - z[1][2][2])));
    }
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): their third time derivative.
    ///
    /// Operations: 32 additions, 12 multiplications.
    pub fn constraint_jerk_chord_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..3];
        let t51 = z[2][2][0] * (z[0][1][0] - z[1][1][0]);
        let t52 = z[2][1][0] * (z[0][2][0] - z[1][2][0]);
        let t53 = t51 + t52;
        let t54 = z[2][3][0] * (z[0][0][0] - z[1][0][0]) + t51 + t53
            + (t53 + (t52 + z[2][0][0] * (z[0][3][0] - z[1][3][0])));
        let t55 = z[2][2][1] * (z[0][1][1] - z[1][1][1]);
        let t56 = z[2][1][1] * (z[0][2][1] - z[1][2][1]);
        let t57 = t55 + t56;
        let t58 = z[2][3][1] * (z[0][0][1] - z[1][0][1]) + t55 + t57
            + (t57 + (t56 + z[2][0][1] * (z[0][3][1] - z[1][3][1])));
        let t59 = z[2][2][2] * (z[0][1][2] - z[1][1][2]);
        let t60 = z[2][1][2] * (z[0][2][2] - z[1][2][2]);
        let t61 = t59 + t60;
        let t62 = z[2][3][2] * (z[0][0][2] - z[1][0][2]) + t59 + t61
            + (t61 + (t60 + z[2][0][2] * (z[0][3][2] - z[1][3][2])));
        rows[0] = t54 + t58 + t62;
    }
    /// Constraint `chord_y` (hold in absolute coordinates), `chord_z` (hold in absolute coordinates): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 3 additions, 0 multiplications.
    pub fn constraint_gradient_chord_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
        velocity: &[[f64; 3]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t20 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t20
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        rows[0] = z[0][0][1] * theta.cos() + z[0][0][2] * theta.sin();
    }
    /// Constraint `cross_axis` (constraint): their rate dC/dt.
    ///
    /// Operations: 9 additions, 15 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_velocity_cross_axis(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t22 = model.omega_s / model.T_s;
        let t23 = (model.T_s / 6.283185307179586).powi(2);
        let t24 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t22 * (t * t / 2.0 + t23 * (t24.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t26 = theta.cos();
        let t27 = theta.sin();
        let t28 = (if t <= model.T_s {
            t22 * (t - t23 * (6.283185307179586 / model.T_s * t24.sin()))
        } else {
            model.omega_s
        });
        let t29 = z[0][1][1] * t26 - z[0][0][1] * (t27 * t28)
            + (z[0][1][2] * t27 + z[0][0][2] * (t26 * t28));
        rows[0] = t29;
    }
    /// Constraint `cross_axis` (constraint): their second time derivative.
    ///
    /// Operations: 17 additions, 25 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_acceleration_cross_axis(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t24 = model.omega_s / model.T_s;
        let t25 = (model.T_s / 6.283185307179586).powi(2);
        let t26 = t * 6.283185307179586 / model.T_s;
        let t27 = t26.cos();
        let theta = (if t <= model.T_s {
            t24 * (t * t / 2.0 + t25 * (t27 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t29 = theta.cos();
        let t30 = theta.sin();
        let t31 = 6.283185307179586 / model.T_s;
        let t32 = (if t <= model.T_s {
            t24 * (t - t25 * (t31 * t26.sin()))
        } else {
            model.omega_s
        });
        let t33 = t30 * t32;
        let t34 = t29 * t32;
        let t35 = (if t <= model.T_s {
            t24 * (1.0 - t25 * (t31 * (t27 * t31)))
        } else {
            0.0
        });
        let t36 = z[0][1][1] * t33;
        let t37 = z[0][1][2] * t34;
        let t38 = z[0][2][1] * t29 - t36 - (t36 + z[0][0][1] * (t32 * t34 + t30 * t35))
            + (z[0][2][2] * t30 + t37 + (t37 + z[0][0][2] * (t29 * t35 - t32 * t33)));
        rows[0] = t38;
    }
    /// Constraint `cross_axis` (constraint): their third time derivative.
    ///
    /// Operations: 30 additions, 37 multiplications, 6 divisions, 4 function calls.
    pub fn constraint_jerk_cross_axis(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        let t26 = model.omega_s / model.T_s;
        let t27 = (model.T_s / 6.283185307179586).powi(2);
        let t28 = t * 6.283185307179586 / model.T_s;
        let t29 = t28.cos();
        let theta = (if t <= model.T_s {
            t26 * (t * t / 2.0 + t27 * (t29 - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t31 = theta.cos();
        let t32 = theta.sin();
        let t33 = 6.283185307179586 / model.T_s;
        let t34 = t33 * t28.sin();
        let t35 = (if t <= model.T_s { t26 * (t - t27 * t34) } else { model.omega_s });
        let t36 = t32 * t35;
        let t37 = t31 * t35;
        let t38 = (if t <= model.T_s {
            t26 * (1.0 - t27 * (t33 * (t29 * t33)))
        } else {
            0.0
        });
        let t39 = t35 * t37 + t32 * t38;
        let t40 = t31 * t38 - t35 * t36;
        let t41 = (if t <= model.T_s { t26 * (t27 * (t33 * (t33 * t34))) } else { 0.0 });
        let t42 = t37 * t38;
        let t43 = z[0][2][1] * t36;
        let t44 = z[0][1][1] * t39;
        let t45 = t43 + t44;
        let t46 = z[0][3][1] * t31 - t43 - t45
            - (t45 + (t44 + z[0][0][1] * (t42 + t35 * t40 + (t42 + t32 * t41))));
        let t47 = t36 * t38;
        let t48 = z[0][2][2] * t37;
        let t49 = z[0][1][2] * t40;
        let t50 = t48 + t49;
        let t51 = z[0][3][2] * t32 + t48 + t50
            + (t50 + (t49 + z[0][0][2] * (t31 * t41 - t47 - (t47 + t35 * t39))));
        rows[0] = t46 + t51;
    }
    /// Constraint `cross_axis` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 4 additions, 6 multiplications, 5 divisions, 3 function calls.
    pub fn constraint_gradient_cross_axis(
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        let t18 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t18
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
        velocity: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        let velocity = &velocity[..1];
        let t18 = model.omega_s / model.T_s;
        let t19 = (model.T_s / 6.283185307179586).powi(2);
        let t20 = t * 6.283185307179586 / model.T_s;
        let theta = (if t <= model.T_s {
            t18 * (t * t / 2.0 + t19 * (t20.cos() - 1.0))
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t22 = (if t <= model.T_s {
            t18 * (t - t19 * (6.283185307179586 / model.T_s * t20.sin()))
        } else {
            model.omega_s
        });
        gradient[1] = -theta.sin() * t22;
        gradient[2] = theta.cos() * t22;
    }
    /// Constraint `guide_y` (constraint): rows C(z, t).
    ///
    /// Of `guide_y`: `z[0]` a place on `beam` (inertial axes).
    ///
    /// * value: `z[0][0][1]`
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_position_guide_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][0][1];
    }
    /// Constraint `guide_y` (constraint): their rate dC/dt.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_velocity_guide_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][1][1];
    }
    /// Constraint `guide_y` (constraint): their second time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_acceleration_guide_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][2][1];
    }
    /// Constraint `guide_y` (constraint): their third time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_jerk_guide_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][3][1];
    }
    /// Constraint `guide_y` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_guide_y(
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
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
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][0][2];
    }
    /// Constraint `guide_z` (constraint): their rate dC/dt.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_velocity_guide_z(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][1][2];
    }
    /// Constraint `guide_z` (constraint): their second time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_acceleration_guide_z(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][2][2];
    }
    /// Constraint `guide_z` (constraint): their third time derivative.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_jerk_guide_z(
        model: &super::SliderCrank,
        t: f64,
        z: &[[[f64; 3]; 4]],
        rows: &mut [f64],
    ) {
        let z = &z[..1];
        rows[0] = z[0][3][2];
    }
    /// Constraint `guide_z` (constraint): writes dC/dz, rows first; entries that are always zero are left alone.
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn constraint_gradient_guide_z(
        model: &super::SliderCrank,
        t: f64,
        z: &[[f64; 3]],
        gradient: &mut [f64],
    ) {
        let z = &z[..1];
        gradient[2] = 1.0;
    }
    /// Times at which a derivative of a motion or load may jump (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn kinks(model: &super::SliderCrank, kinks: &mut [f64; 1]) {
        kinks[0] = model.T_s;
    }
    /// Output columns from what they observe.
    ///
    /// Operations: 15 additions, 14 multiplications, 5 divisions, 4 function calls.
    pub fn outputs(
        model: &super::SliderCrank,
        t: f64,
        observed: &[f64],
        out: &mut [f64],
    ) {
        let t28 = t * t / 2.0
            + (model.T_s / 6.283185307179586).powi(2)
                * ((t * 6.283185307179586 / model.T_s).cos() - 1.0);
        let theta = (if t <= model.T_s {
            model.omega_s / model.T_s * t28
        } else {
            model.omega_s * (t - model.T_s / 2.0)
        });
        let t30 = (observed[1] - 0.5 * (observed[2] + observed[3])).powi(2)
            + (observed[4] - 0.5 * (observed[5] + observed[6])).powi(2);
        out[0] = observed[0];
        out[1] = observed[0]
            - (0.09 - 0.019600000000000003 * (2.0 - 2.0 * theta.cos())).sqrt();
        out[2] = (t30 + (observed[7] - 0.5 * (observed[8] + observed[9])).powi(2))
            .sqrt();
    }
    /// Defaults of a run (s).
    ///
    /// Operations: 0 additions, 0 multiplications.
    pub fn run_defaults(model: &super::SliderCrank, run: &mut ::rncf::RunDefaults) {
        run.t_end = 2.5;
        run.every = 0.01;
    }
    /// Constants of all bodies.
    #[derive(Clone, Debug)]
    pub struct Equations {
        pub model: super::SliderCrank,
        pub row_beam: CableSpatialExactDamped,
    }
    impl Equations {
        /// Constants for the given parameters; filled in when the bodies are meshed.
        pub fn new(model: &super::SliderCrank) -> Self {
            Self {
                model: model.clone(),
                row_beam: Default::default(),
            }
        }
    }
    impl ::rncf::mesh::Parts for Equations {
        fn bodies(&self) -> ::std::vec::Vec<::rncf::mesh::BodySpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::BodySpec {
                    name: "beam",
                    frame: 2,
                    axes: &[0, 1, 2],
                    line: ::rncf::mesh::Line::Straight {
                        from: [0.0, 0.0, 0.0],
                        to: [0.3, 0.0, 0.0],
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
                    ],
                    connectivity: &[0, 1, 2, 3],
                    vectors_per_node: 2,
                    stride: 2,
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
                    kind: ::rncf::mesh::JointKind::Pin,
                    body: 0,
                    at_end: false,
                    frame: 2,
                    point: None,
                },
                ::rncf::mesh::JointSpec {
                    name: "chord_y",
                    kind: ::rncf::mesh::JointKind::Hold {
                        of: ::rncf::mesh::Interpolant::Position,
                        order: 0,
                        axis: 1,
                    },
                    body: 0,
                    at_end: true,
                    frame: 2,
                    point: None,
                },
                ::rncf::mesh::JointSpec {
                    name: "chord_z",
                    kind: ::rncf::mesh::JointKind::Hold {
                        of: ::rncf::mesh::Interpolant::Position,
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
        fn loads(&self) -> ::std::vec::Vec<::rncf::mesh::LoadSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([])
        }
        fn observed(&self) -> ::std::vec::Vec<::rncf::mesh::ObservedSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ObservedSpec::Marker {
                    marker: 2,
                    derivative: 0,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.15),
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 0,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.15),
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 1,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::At(0.15),
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
                },
                ::rncf::mesh::ObservedSpec::Point {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                    what: ::rncf::mesh::PointQuantity::Position,
                    component: 2,
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
            3
        }
        fn frame_name(&self, frame: usize) -> &'static str {
            ["inertial", "pin_frame", "rod"][frame]
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
                "material `soft`",
                "density",
                7870.0,
                "kg/m^3",
            )?;
            let young = ::rncf::mesh::positive(
                "material `soft`",
                "young",
                200000000.0,
                "Pa",
            )?;
            let poisson = ::rncf::mesh::poisson(
                "material `soft`",
                "poisson",
                0.29,
                "1",
            )?;
            let damping = ::rncf::mesh::non_negative(
                "material `soft`",
                "damping",
                model.damping,
                "s",
            )?;
            let area = ::rncf::mesh::positive(
                "section `round`",
                "area",
                0.00020106192982974675,
                "m^2",
            )?;
            let second_moment = ::rncf::mesh::positive(
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
        fn frames(&self, t: f64, motions: &mut [::rncf::mesh::FrameMotion]) {
            motions[0] = ::rncf::mesh::FrameMotion::INERTIAL;
            frame_pin_frame(&self.model, t, &mut motions[1]);
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
            cable_spatial_exact_damped_mass(
                &self.row_beam,
                ::rncf::mesh::array_mut(mass),
            );
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
            let [q, v, a]: [&[f64; 12]; 3] = [q, v, a].map(::rncf::mesh::array);
            let force = ::rncf::mesh::array_mut(force);
            cable_spatial_exact_damped_elastic_force(&self.row_beam, q, v, force);
            if absolute {
                cable_spatial_exact_damped_absolute_inertia_force(
                    &self.row_beam,
                    frame,
                    a,
                    force,
                );
            } else {
                cable_spatial_exact_damped_inertia_force(
                    &self.row_beam,
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
            let [q, v]: [&[f64; 12]; 2] = [q, v].map(::rncf::mesh::array);
            let stiffness = ::rncf::mesh::array_mut(stiffness);
            let damping_matrix = ::rncf::mesh::array_mut(damping);
            cable_spatial_exact_damped_elastic_tangent(
                &self.row_beam,
                q,
                v,
                stiffness,
                damping_matrix,
            );
            if !absolute {
                cable_spatial_exact_damped_inertia_tangent(
                    &self.row_beam,
                    frame,
                    stiffness,
                    damping_matrix,
                );
            }
        }
        fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {
            let mut energy = 0.0;
            cable_spatial_exact_damped_strain_energy(
                &self.row_beam,
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
                    cable_spatial_exact_damped_shapes_position_0(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 1) => {
                    cable_spatial_exact_damped_shapes_position_1(
                        self.row_beam.length,
                        xi,
                        ::rncf::mesh::array_mut(weights),
                    )
                }
                (::rncf::mesh::Interpolant::Position, 2) => {
                    cable_spatial_exact_damped_shapes_position_2(
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
                area: 0.00020106192982974675,
                second_moments: [3.216990877275948e-9, 3.216990877275948e-9],
                torsion_constant: 0.0,
                yield_stress: None,
                material: "soft",
            }
        }
        fn fields(&self, body: usize) -> &'static [(::rncf::mesh::Interpolant, usize)] {
            &[
                (::rncf::mesh::Interpolant::Position, 1),
                (::rncf::mesh::Interpolant::Position, 2),
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
            cable_spatial_exact_damped_field_forces(
                &self.row_beam,
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
                (1, false) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_chord_y_referenced_velocity(
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
                            joint_chord_y_referenced_acceleration(
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
                            joint_chord_y_referenced_jerk(
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
                (2, false) => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
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
                        ::rncf::system::ConstraintLevel::Velocity => {
                            joint_chord_z_referenced_velocity(
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
                            joint_chord_z_referenced_acceleration(
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
                            joint_chord_z_referenced_jerk(
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
            data: &::rncf::mesh::JointData,
            prescribed: &mut ::rncf::mesh::Prescribed,
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
        fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {
            let model = &self.model;
            ::rncf::mesh::non_negative(
                "fixture `slider`",
                "mass",
                model.slider_mass,
                "kg",
            )?;
            Ok(())
        }
        fn free(&self) -> ::std::vec::Vec<::rncf::mesh::FreeSpec> {
            let still = ::rncf::mesh::FreeSpec {
                frame: 0,
                parent: 0,
                is_body: false,
                motions: ::rncf::mesh::Motions::Spatial,
                position: [0.0; 3],
                axis: [0.0; 3],
                angle: 0.0,
                velocity: [0.0; 3],
                spin: [0.0; 3],
                rigid: ::rncf::mesh::RigidSpec::default(),
            };
            let mut specs = ::std::vec::Vec::from([
                ::rncf::mesh::FreeSpec {
                    frame: 2,
                    parent: 1,
                    is_body: false,
                    motions: ::rncf::mesh::Motions::Turning,
                    ..still.clone()
                },
            ]);
            free_rod(&self.model, &mut specs[0]);
            specs
        }
        fn markers(&self) -> ::std::vec::Vec<::rncf::mesh::MarkerSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::mesh::Place::Start,
                },
                ::rncf::mesh::MarkerSpec::Matching {
                    frame: 2,
                    marker: 0,
                },
                ::rncf::mesh::MarkerSpec::BodyPoint {
                    body: 0,
                    at: ::rncf::mesh::Place::End,
                },
                ::rncf::mesh::MarkerSpec::Matching {
                    frame: 2,
                    marker: 2,
                },
                ::rncf::mesh::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 1.0, 0.0],
                },
                ::rncf::mesh::MarkerSpec::Direction {
                    frame: 2,
                    along: [0.0, 0.0, 1.0],
                },
            ])
        }
        fn constraints(&self) -> ::std::vec::Vec<::rncf::mesh::ConstraintSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::ConstraintSpec {
                    name: "root",
                    kind: "pin",
                    rows: &["position x", "position y", "position z"],
                    markers: &[0, 1],
                    first_party: 1,
                    when: ::rncf::mesh::When::Absolute(0),
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "chord_y",
                    kind: "hold",
                    rows: &["position y"],
                    markers: &[2, 3, 4],
                    first_party: 1,
                    when: ::rncf::mesh::When::Absolute(0),
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "chord_z",
                    kind: "hold",
                    rows: &["position z"],
                    markers: &[2, 3, 5],
                    first_party: 1,
                    when: ::rncf::mesh::When::Absolute(0),
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "cross_axis",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[5],
                    first_party: 1,
                    when: ::rncf::mesh::When::Always,
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "guide_y",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[2],
                    first_party: 1,
                    when: ::rncf::mesh::When::Always,
                },
                ::rncf::mesh::ConstraintSpec {
                    name: "guide_z",
                    kind: "constraint",
                    rows: &["value"],
                    markers: &[2],
                    first_party: 1,
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
                            constraint_position_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_root(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_root(&self.model, t, z, rows)
                        }
                    }
                }
                1 | 2 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_chord_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_chord_y(&self.model, t, z, rows)
                        }
                    }
                }
                3 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_cross_axis(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_cross_axis(&self.model, t, z, rows)
                        }
                    }
                }
                4 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_guide_y(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
                            constraint_jerk_guide_y(&self.model, t, z, rows)
                        }
                    }
                }
                5 => {
                    match level {
                        ::rncf::system::ConstraintLevel::Position => {
                            constraint_position_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Velocity => {
                            constraint_velocity_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Acceleration => {
                            constraint_acceleration_guide_z(&self.model, t, z, rows)
                        }
                        ::rncf::system::ConstraintLevel::Jerk => {
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
            z: &[[f64; 3]],
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
            z: &[[f64; 3]],
            velocity: &[[f64; 3]],
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
                1 | 2 => constraint_hessian_chord_y(&self.model, t, z, lambda, hessian),
                _ => {}
            }
        }
        fn fixtures(&self) -> ::std::vec::Vec<::rncf::mesh::FixtureSpec> {
            let model = &self.model;
            ::std::vec::Vec::from([
                ::rncf::mesh::FixtureSpec {
                    name: "slider",
                    body: 0,
                    at: ::rncf::mesh::Place::End,
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
                (3, 2) => {
                    if absolute {
                        fixture_spatial_absolute_inertia_force(
                            constants,
                            frame,
                            ::rncf::mesh::array(a),
                            ::rncf::mesh::array_mut(force),
                        );
                    } else {
                        fixture_spatial_inertia_force(
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
                (3, 2) => {
                    if !absolute {
                        fixture_spatial_inertia_tangent(
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
        fn carried(
            &self,
            of: ::rncf::mesh::Carried,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            out: &mut [f64],
        ) {
            match of {
                ::rncf::mesh::Carried::Element { body: 0 } => {
                    cable_spatial_exact_damped_carried(
                        &self.row_beam,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(out),
                    )
                }
                ::rncf::mesh::Carried::Fixture {
                    dimension: 3,
                    vectors: 2,
                    constants,
                } => {
                    fixture_spatial_carried(
                        constants,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(out),
                    )
                }
                _ => {}
            }
        }
        fn carried_tangent(
            &self,
            of: ::rncf::mesh::Carried,
            frame: &::rncf::mesh::FrameAction,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            out: &mut ::rncf::mesh::CarriedTangent,
        ) {
            const DIMENSIONS: [usize; 1] = [3];
            let (d, n) = match of {
                ::rncf::mesh::Carried::Element { body } => (DIMENSIONS[body], q.len()),
                ::rncf::mesh::Carried::Fixture { dimension, .. } => (dimension, q.len()),
                ::rncf::mesh::Carried::Rigid(_) => (3, 0),
            };
            let s = if d == 2 { 1 } else { 3 };
            let b = d + s;
            for (block, size) in [
                (&mut out.mass, b * (b + n)),
                (&mut out.damping, b * (s + n)),
                (&mut out.spin, n * s),
                (&mut out.stiffness, b * n),
            ] {
                block.clear();
                block.resize(size, 0.0);
            }
            match of {
                ::rncf::mesh::Carried::Element { body: 0 } => {
                    cable_spatial_exact_damped_carried_tangent(
                        &self.row_beam,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(&mut out.mass),
                        ::rncf::mesh::array_mut(&mut out.damping),
                        ::rncf::mesh::array_mut(&mut out.spin),
                        ::rncf::mesh::array_mut(&mut out.stiffness),
                    )
                }
                ::rncf::mesh::Carried::Fixture {
                    dimension: 3,
                    vectors: 2,
                    constants,
                } => {
                    fixture_spatial_carried_tangent(
                        constants,
                        frame,
                        ::rncf::mesh::array(q),
                        ::rncf::mesh::array(v),
                        ::rncf::mesh::array(a),
                        ::rncf::mesh::array_mut(&mut out.mass),
                        ::rncf::mesh::array_mut(&mut out.damping),
                        ::rncf::mesh::array_mut(&mut out.spin),
                        ::rncf::mesh::array_mut(&mut out.stiffness),
                    )
                }
                _ => {}
            }
        }
    }
}
