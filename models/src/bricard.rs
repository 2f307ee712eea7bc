//! Bricard's mechanism (IFToMM benchmark A03): movable although a count of its freedoms gives none.

rncf::model! {
    /// Bricard's mechanism: five rods and the ground, joined by six revolute joints into a spatial loop. Six joints take
    /// 30 freedoms of five bodies, but one of them twice: the loop moves.
    pub model Bricard {
        const m = 1 kg;
        /// Square rod 1 x 0.1 x 0.1 m about its axis.
        const along = 1 kg * (0.02 [m^2]) / 12;
        /// And across, about its centre.
        const across = 1 kg * (1.01 [m^2]) / 12;

        // All frames begin with the axes of space; rod Pi Pj begins at Pi.
        rigid p01 { mass = m; inertia = [along, across, across]; center = [0.5, 0, 0] m; }
        rigid p12 { mass = m; inertia = [across, along, across]; center = [0, -0.5, 0] m; origin = [1, 0, 0] m; }
        rigid p23 { mass = m; inertia = [across, across, along]; center = [0, 0, 0.5] m; origin = [1, -1, 0] m; }
        rigid p34 { mass = m; inertia = [along, across, across]; center = [-0.5, 0, 0] m; origin = [1, -1, 1] m; }
        rigid p45 { mass = m; inertia = [across, along, across]; center = [0, 0.5, 0] m; origin = [0, -1, 1] m; }

        joint p0 = revolute(p01, inertial.at([0, 0, 0] m), axis = y);
        joint p1 = revolute(p01.at([1, 0, 0] m), p12.at([0, 0, 0] m), axis = z);
        joint p2 = revolute(p12.at([0, -1, 0] m), p23.at([0, 0, 0] m), axis = x);
        joint p3 = revolute(p23.at([0, 0, 1] m), p34.at([0, 0, 0] m), axis = y);
        joint p4 = revolute(p34.at([-1, 0, 0] m), p45.at([0, 0, 0] m), axis = z);
        // Six revolute joints are refused as redundant: forces and moments that stress the loop without moving it are
        // not determined by the motion of rigid bodies. The last joint gives up one of its five conditions, the one
        // that carries the moment about z: the stress of the loop has such a moment in every position, so that what is
        // given up here is what the others hold twice. Left are the point, and the rod's x axis normal to z.
        joint p5 = universal(p45.at([0, 1, 0] m), inertial.at([0, 0, 1] m), axis = x, cross = z);
        load weight = gravity([0, -9.81, 0] m/s^2);

        /// Point P3, x.
        output x = p34.x;
        /// Point P3, y.
        output y = p34.y;
        /// Point P3, z.
        output z = p34.z;

        run { t_end = 10 s; every = 0.01 s; }
    }
}
