//! Two blades on a hub, one a beam with cross-section and one a centre line, of the same steel tube.

rncf::model! {
    /// Two blades that turn with a hub and are loaded alike at their tips.
    pub model Blades {
        /// Angular velocity of the hub.
        param omega = 0 rad/s;
        /// Force on each tip along the blade.
        param pull_x = 0 N;
        /// Force on each tip across the blade.
        param pull_y = 0 N;
        /// Moment on each tip.
        param twist = 0 N*m;
        /// Gravity across the blades.
        param fall = 0 m/s^2;
        /// Load per length on the blade.
        param snow = 0 N/m;
        /// Force on the rope at a place of it, across it.
        param poke = 0 N;
        param poked_at = 0.5 m;
        /// Where sections are read.
        param place = 0.5 m;
        /// Number of elements of each blade.
        param elements: count = 8;

        const length = 2 m;

        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 250 MPa; }
        section pipe = tube(radius = 20 mm, thickness = 2 mm);

        motion theta(t) = omega * t;
        frame hub = rotating(axis = z, angle = theta(t));

        body blade in hub {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(pipe, steel);
        }
        body rope in hub {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(pipe, steel);
        }
        joint blade_root = clamp(blade.start, hub);
        joint rope_root = clamp(rope.start, hub);
        load blade_pull = force(blade.end, [pull_x, pull_y, 0 N], in = hub);
        load rope_pull = force(rope.end, [pull_x, pull_y, 0 N], in = hub);
        load blade_twist = moment(blade.end, [0 [N m], 0 [N m], twist], in = hub);
        load rope_twist = moment(rope.end, [0 [N m], 0 [N m], twist], in = hub);

        load weight = gravity([0, -fall, 0]);
        load cover = density(blade, [0, -snow, 0]);
        load rope_poke = force(rope.at(poked_at), [0 N, poke, 0 N], in = hub);

        /// Deflection of the tips.
        output v_blade = blade.end.y;
        output v_rope = rope.end.y;
        output root_force = blade.start.axial_force;
        output root_stress = blade.start.stress;
        output rope_force = rope.at(place).axial_force;
        output rope_moment = rope.at(place).moment;
        output rope_start = rope.start.axial_force;
        output rope_start_moment = rope.start.moment;
        output grip = rope_root.force;
        output grip_moment = rope_root.moment.z;

        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// Length of the blades, m.
pub const LENGTH: f64 = 2.0;
/// Young's modulus, Pa, and density, kg/m^3.
pub const YOUNG: f64 = 210e9;
pub const DENSITY: f64 = 7800.0;
/// Outer and inner radius of the tube, m.
pub const RADII: [f64; 2] = [0.02, 0.018];

/// Area of the tube, m^2.
pub fn area() -> f64 {
    let [outer, inner] = RADII;
    std::f64::consts::PI * (outer * outer - inner * inner)
}

/// Its second moment, m^4.
pub fn second_moment() -> f64 {
    let [outer, inner] = RADII;
    std::f64::consts::FRAC_PI_4 * (outer.powi(4) - inner.powi(4))
}
