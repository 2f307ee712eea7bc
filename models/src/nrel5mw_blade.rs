//! The blade of the NREL 5-MW reference turbine from its table of sections.

rncf::model! {
    /// Blade of the NREL 5-MW turbine, 61.5 m, clamped at its root: 49 stations with full matrices of stiffness and mass.
    pub model Nrel5mwBlade {
        /// Gravity along -y, edgewise.
        param gravity = 9.8 [m/s^2];
        /// Speed of the rotor.
        param speed = 0 rpm;
        /// Elements from one station to the next.
        param each: count = 1;

        table sections = file("data/nrel5mw_section.csv");
        table points = file("data/nrel5mw_keypoints.csv");
        section layup = beamdyn(sections, damping = 2 ms);

        // The rotor turns about x, which points downwind.
        frame rotor = rotating(axis = x, angle = speed * t);
        body blade in rotor {
            spatial;
            line from [0, 0, 1.5] m to [0, 0, 63] m;
            section_y [1, 0, 0];
            twist -points.twist;
            mesh each at sections * beam(layup);
        }
        joint hub = clamp(blade.start, rotor);
        load weight = gravity([0 [m/s^2], -gravity, 0 [m/s^2]]);

        /// Displacement of the tip downwind.
        output tip_x = blade.end.x;
        /// Displacement of the tip edgewise.
        output tip_y = blade.end.y;
        /// Mass.
        output mass = blade.mass;

        run { t_end = 2 s; every = 0.05 s; }
    }
}
