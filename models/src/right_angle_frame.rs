//! Right-angle frame: a thin strip with a rigid corner buckles out of its plane.

rncf::model! {
    /// Right-angle frame under a dead load at its free end: it buckles out of its plane, with bending and torsion.
    pub model RightAngleFrame {
        /// Load at the free end along the first leg; positive pulls.
        param load = 1.2 N;
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
    }
}
