//! Roll-up: an end moment bends a straight beam to a full circle.

rncf::model! {
    /// Roll-up: an end moment of 2 pi EI/L bends a straight cantilever to a full circle.
    pub model RollUp {
        /// End moment over 2 pi EI/L: the number of turns of a slender beam.
        param turns = 1;
        /// Radius of the section over the length.
        param slenderness = 0.005;
        /// Number of elements.
        param elements: count = 8;

        const length = 1 m;
        const young = 210 [GPa];

        material steel { density = 7850 kg/m^3; young = young; poisson = 0.3; }
        section round = circle(radius = slenderness * length);

        body beam {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(round, steel);
        }
        // Whole: with both axes of the section held the convergence is that of THEORY 5.2.1.
        joint root = clamp_full(beam.start, inertial);
        load bend = moment(
            beam.end,
            [0 [N m], 0 [N m], turns * 2 * pi * young * pi / 4 * (slenderness * length)^4 / length],
            in = inertial
        );

        /// Position of the tip over the length.
        output x = beam.end.x / length;
        /// Position of the tip over the length.
        output y = beam.end.y / length;
        /// Distance of the tip from the root over the length.
        output gap = norm(beam.end.position - beam.start.position) / length;

        run { t_end = 1 s; every = 0.01 s; }
    }
}
