//! A bar that meets a wall.

rncf::model! {
    /// A bar that flies against a wall.
    pub model Struck {
        param stiff = 1e10 N/m;
        material soft { density = 1000 kg/m^3; young = 10 GPa; }
        section round = circle(radius = 5 mm);
        frame flying = free(plane = xy, velocity = [-1, 0, 0] m/s);
        body bar in flying { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 40 * cable(round, soft); chord; }
        load wall = force(bar.start, [stiff * max(-bar.start.in(inertial).x, 0 m), 0 N, 0 N]);
        output momentum = bar.momentum.x;
        run { t_end = 1 ms; every = 0.1 ms; }
    }
}
