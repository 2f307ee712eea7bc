//! Princeton beam experiment: a strip bent about both axes and twisted by a dead load at its tip.

rncf::model! {
    /// Princeton beam experiment: a cantilever strip under a dead load at its tip, at an angle to its principal axes.
    pub model PrincetonBeam {
        /// Load at the tip.
        param load = 8.896 N;
        /// Angle of the load from the strip's wide side.
        param angle = 30 deg;
        /// Number of elements.
        param elements: count = 16;

        const length = 0.508 m;

        material aluminium { density = 2700 kg/m^3; young = 71.7 GPa; poisson = 0.31; }
        section strip = rectangle(y = 12.3777 mm, z = 3.2024 mm);

        body beam {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(strip, aluminium);
        }
        joint root = clamp(beam.start, inertial);
        load weight = force(beam.end, [0 N, load * cos(angle), load * sin(angle)], in = inertial);

        /// Displacement of the tip along the strip.
        output tip_x = beam.end.x - length;
        /// Displacement of the tip along its wide side.
        output tip_y = beam.end.y;
        /// Displacement of the tip along its thin side.
        output tip_z = beam.end.z;

        run { t_end = 1 s; every = 1 ms; }
    }
}
