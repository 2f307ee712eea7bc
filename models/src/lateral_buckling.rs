//! Lateral buckling of a cantilever strip under a dead load at its tip.

rncf::model! {
    /// Lateral buckling: a cantilever strip on edge tilts and twists under a dead load at its tip
    /// (critical 4.013 sqrt(EI GJ)/L^2).
    pub model LateralBuckling {
        /// Load at the tip, along the strip's wide side.
        param load = 3 N;
        /// Load along its thin side that starts the deflection.
        param disturbance = 0 N;
        /// Number of elements.
        param elements: count = 8;

        const length = 1 m;

        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section strip = rectangle(y = 1 mm, z = 30 mm);

        body beam {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(strip, steel);
        }
        joint root = clamp(beam.start, inertial);
        load weight = force(beam.end, [0 N, disturbance, -load], in = inertial);

        /// Displacement of the tip along the strip's thin side.
        output y = beam.end.y;
        /// Displacement of the tip along its wide side.
        output z = beam.end.z;
        /// Twist of the tip.
        output twist = atan2(beam.end.ey.z, beam.end.ey.y);

        run { t_end = 1 s; every = 1 ms; }
    }
}
