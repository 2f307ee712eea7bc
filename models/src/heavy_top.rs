//! Heavy top on a fixed point (Brüls, Cardona & Arnold 2012).

rncf::model! {
    /// Heavy top: a spinning disc on a weightless arm, whose end stays at the origin (Bruls, Cardona & Arnold 2012).
    pub model HeavyTop {
        /// The disc. Its frame has the axes of inertia and begins at the centre of mass; the arm lies along its y axis.
        rigid top {
            mass = 15 kg;
            inertia = [0.234375, 0.46875, 0.234375] kg*m^2;
            origin = [0, 1, 0] m;
            velocity = [4.61538, 0, 0] m/s;
            angular_velocity = [0, 150, -4.61538] rad/s;
        }
        joint pivot = spherical(top.at([0, -1, 0] m), inertial.at([0, 0, 0] m));
        load weight = gravity([0, 0, -9.81] m/s^2);

        /// Centre of mass in space, x.
        output x = top.center.x;
        /// Centre of mass in space, y.
        output y = top.center.y;
        /// Centre of mass in space, z.
        output z = top.center.z;
        /// Force of the pivot on the top, in space.
        output force = pivot.force;

        run { t_end = 1 s; every = 0.005 s; }
    }
}
