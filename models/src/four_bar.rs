//! Double four-bar linkage (IFToMM benchmark A02, N = 2), which passes through singular positions.

rncf::model! {
    /// N-four-bar linkage with N = 2: three upright links on the ground, two couplers, gravity. Where the links lie flat
    /// all rods are in line and the linkage could leave its parallelogram; it happens twice a turn.
    pub model FourBar {
        /// Angular velocity of the links at the start, which moves their ends at 1 m/s.
        param speed = -1 rad/s;

        const length = 1 m;
        const m = 1 kg;
        /// Slender rod about its centre.
        const j = m * length^2 / 12;

        rigid link_0 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; speed = speed; }
        rigid link_1 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; origin = [1, 0, 0] m; speed = speed; }
        rigid link_2 { plane xy; mass = m; inertia = j; center = [0, 0.5, 0] m; origin = [2, 0, 0] m; speed = speed; }
        rigid coupler_1 {
            plane xy;
            mass = m;
            inertia = j;
            center = [0.5, 0, 0] m;
            origin = [0, 1, 0] m;
            velocity = [-length * speed, 0, 0];
        }
        rigid coupler_2 {
            plane xy;
            mass = m;
            inertia = j;
            center = [0.5, 0, 0] m;
            origin = [1, 1, 0] m;
            velocity = [-length * speed, 0, 0];
        }

        joint a0 = revolute(link_0, inertial.at([0, 0, 0] m));
        joint a1 = revolute(link_1, inertial.at([1, 0, 0] m));
        joint a2 = revolute(link_2, inertial.at([2, 0, 0] m));
        joint b0 = revolute(link_0.at([0, 1, 0] m), coupler_1.at([0, 0, 0] m));
        joint b1 = revolute(link_1.at([0, 1, 0] m), coupler_1.at([1, 0, 0] m));
        joint b12 = revolute(link_1.at([0, 1, 0] m), coupler_2.at([0, 0, 0] m));
        joint b2 = revolute(link_2.at([0, 1, 0] m), coupler_2.at([1, 0, 0] m));
        load weight = gravity([0, -9.81, 0] m/s^2);

        /// Point B0, the upper end of the first link, x.
        output x = link_0.at([0, 1, 0] m).x;
        /// Point B0, y.
        output y = link_0.at([0, 1, 0] m).y;

        run { t_end = 10 s; every = 0.01 s; }
    }
}
