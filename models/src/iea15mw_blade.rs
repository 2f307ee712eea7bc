//! The blade of the IEA 15-MW reference turbine: full matrices along a bent axis.

rncf::model! {
    /// Blade of the IEA 15-MW turbine (v1.1.6), 117 m along a bent axis, clamped at its root: 26 stations with full matrices of stiffness and mass.
    pub model Iea15mwBlade {
        /// Dead force at the tip, downwind.
        param downwind = 0 N;
        /// Dead force at the tip, edgewise.
        param edgewise = 0 N;
        /// Elements from one station to the next.
        param each: count = 1;

        table sections = file("data/iea15_section.csv");
        table points = file("data/iea15_keypoints.csv");
        section layup = beamdyn(sections);

        body blade {
            spatial;
            curve through points;
            section_y [1, 0, 0];
            twist -points.twist;
            mesh each at sections * beam(layup);
        }
        joint hub = clamp(blade.start, inertial);
        load pull = force(blade.end, [downwind, edgewise, 0 N], in = inertial);

        /// Position of the tip.
        output tip = blade.end.position;
        /// Mass.
        output mass = blade.mass;
        /// Moment that the blade exerts on its clamp.
        output root = -hub.moment;

        run { t_end = 1 s; every = 0.1 s; }
    }
}
