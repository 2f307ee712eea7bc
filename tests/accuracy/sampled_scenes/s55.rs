rncf::model! {
    pub model A {
        param p0 = 0.0 rad;
        param p1 = -0.009030670486463666 rad;
        param p2 = 1.0706493671558666 rad/s;
        param p3 = -0.31874148682799663 m;
        param p4 = -0.5901663590689221 m;
        param p5 = 0.0 rad;
        param p6 = -0.28885033665569126 rad;
        param p7 = 2.1408314824975307 rad/s;
        param p8 = 0.5524540153459613 m;
        param p9 = 0.41594979905012563 m;
        param p10 = 1989.8709175083825 kg/m^3;
        param p11 = 332087533.43204945 Pa;
        param p12 = 0.0 s;
        param p13 = 0.1594830968457465;
        param p14 = 0.016022120407010423 m;
        param p15 = 0.020792032237669858 m;
        param p16 = -0.766881376898741 m;
        param p17 = 0.3210594203434495 m;
        param p18 = -0.766881376898741 m;
        param p19 = -0.5521569294944141 m;
        param p20: count = 3;
        param p21 = -0.766881376898741 m;
        param p22 = 0.3210594203434495 m;
        param p23 = 9.172060941908235 rad/s;
        param p24 = 10.40344479387302 N;
        param p25 = 6.977478678427058 N/m;
        param p26 = -9.81 m/s^2;
        param p27 = 0.3230900494400095 m;
        param p28 = 9.172060941908235 rad/s;
        param p29 = 10.40344479387302 N;
        param p30 = 6.977478678427058 N/m;
        param p31 = 0.8732163498378636 m;
        param p32 = -9.81 m/s^2;
        frame f0 = rotating(axis = [0.0, 0.0, 1.0], angle = p0 + p1 * (1 - cos(p2 * t)), origin = [p3, p4, 0]);
        frame f1 in f0 = rotating(axis = [0.0, 0.0, 1.0], angle = p5 + p6 * (1 - cos(p7 * t)), origin = [p8, p9, 0]);
        material m0 { density = p10; young = p11; damping = p12; poisson = p13; }
        section s0 = rectangle(y = 2 * p14, z = p15);
        body b0 in f1 { planar xy; line from [p16, p17, 0] to [p18, p19, 0]; mesh p20 * beam(s0, m0); }
        joint j0 = clamp(b0.start, f1);
        load l0 = force(b0.start, [p24 * sin(p23 * t), 0, 0], in = inertial);
        load l1 = density(b0, [0, p25, 0]);
        load g0 = gravity([0, p26, 0]);
        output o0 = b0.end.in(inertial).velocity;
        output o1 = b0.end.in(inertial).position;
        output o2 = b0.end.in(f1).velocity;
        output o3 = b0.end.in(f1).position;
        output o4 = b0.at(p27).in(inertial).velocity;
        output o5 = b0.at(p27).in(inertial).position;
        output o6 = b0.at(p27).in(f0).velocity;
        output o7 = b0.at(p27).in(f0).position;
        output o8 = b0.at(p27).axial_force;
        output o9 = b0.at(p27).shear_y;
        output o10 = b0.at(p27).moment_z;
        output o11 = j0.force;
        output o12 = j0.moment;
        output o13 = (((j0.force).x * f1.ex + (j0.force).y * f1.ey)) + [p29 * sin(p28 * t), 0, 0] + p31 * (([0, p30, 0]).x * f1.ex + ([0, p30, 0]).y * f1.ey) + total.mass * [0, p32, 0];
        output o14 = total.momentum;
        output o15 = j0.moment.z + cross(b0.start.in(inertial).position, (((j0.force).x * f1.ex + (j0.force).y * f1.ey))).z + cross(b0.start.in(inertial).position, [p29 * sin(p28 * t), 0, 0]).z + cross(b0.center_of_mass, p31 * (([0, p30, 0]).x * f1.ex + ([0, p30, 0]).y * f1.ey)).z + cross(total.center_of_mass, total.mass * [0, p32, 0]).z;
        output o16 = total.angular_momentum.z;
    }
}
