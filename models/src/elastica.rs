//! The elastica: a slender cantilever under a transverse dead load at its tip.

rncf::model! {
    /// The elastica: a slender cantilever under a transverse dead load at its tip, compared with elliptic integrals.
    pub model Elastica {
        /// Load at the tip times L^2/(EI).
        param alpha = 1;
        /// Radius of the section over the length.
        param slenderness = 0.001;
        /// Number of elements.
        param elements: count = 32;

        const length = 1 m;
        const young = 210 [GPa];

        material steel { density = 7850 kg/m^3; young = young; poisson = 0.3; }
        section round = circle(radius = slenderness * length);

        body beam {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(round, steel);
        }
        joint root = clamp(beam.start, inertial);
        load pull = force(
            beam.end,
            [0 N, alpha * young * pi / 4 * (slenderness * length)^4 / length^2, 0 N],
            in = inertial
        );

        /// Shortening of the tip over the length.
        output u = (length - beam.end.x) / length;
        /// Deflection of the tip over the length.
        output w = beam.end.y / length;

        run { t_end = 1 s; every = 0.01 s; }
    }
}
