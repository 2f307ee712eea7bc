//! Ropes and cords that swing down.

rncf::model! {
    /// The rope of the guide: it swings down.
    pub model Rope {
        param n: count = 8;
        material rubber { density = 1100 kg/m^3; young = 5 MPa; damping = 2 ms; }
        section round { area = pi * (10 mm)^2 / 4; second_moment = pi * (10 mm)^4 / 64; }
        body rope { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(round, rubber); }
        joint hook = pin(rope.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output tip = rope.end;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

rncf::model! {
    /// A rubber cord that lies straight and level, and is hooked at one end.
    pub model Level {
        param n: count = 4;
        material rubber { density = 1150 kg/m^3; young = 2 MPa; }
        section round = circle(radius = 5 mm);
        body cord { planar xy; line from [0, 0, 0] m to [3, 0, 0] m; mesh n * cable(round, rubber); }
        joint hook = pin(cord.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output tip = cord.end;
    }
}
