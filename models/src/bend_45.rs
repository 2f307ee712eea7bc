//! 45-degree bend under a dead load out of its plane (Bathe & Bolourchi 1979).

rncf::model! {
    /// 45-degree bend (Bathe & Bolourchi 1979): a circular arc, clamped at one end, is loaded out of its plane at the other.
    pub model Bend45 {
        /// Load at the tip, normal to the plane of the arc.
        param load = 600 N;
        /// Number of elements.
        param elements: count = 16;

        material soft { density = 1 kg/m^3; young = 10 MPa; poisson = 0; }
        section square = rectangle(y = 1 m, z = 1 m);

        body bend {
            spatial;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius 100 m angle 45 deg;
            mesh elements * beam(square, soft);
        }
        joint root = clamp(bend.start, inertial);
        load pull = force(bend.end, [0 N, 0 N, load], in = inertial);

        /// Position of the tip along x.
        output x = bend.end.x;
        /// Position of the tip along y.
        output y = bend.end.y;
        /// Position of the tip along z.
        output z = bend.end.z;

        run { t_end = 100 s; every = 0.5 s; }
    }
}
