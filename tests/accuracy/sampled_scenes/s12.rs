rncf::model! {
    pub model A {
        param p0 = 0.46299723155651074 m;
        param p1 = 1.0208130006333995 m;
        param p2 = 0.1573175242612638 m;
        param p3 = 0.0 rad;
        param p4 = 0.7833432769489667 kg;
        param p5 = 0.006141709627044976 kg*m^2;
        param p6 = 0.004912507438037145 kg*m^2;
        param p7 = 0.005580179536135884 kg*m^2;
        param p8 = 0.0 kg*m^2;
        param p9 = 0.0 kg*m^2;
        param p10 = 0.0 kg*m^2;
        param p11 = 903.146057509934 kg/m^3;
        param p12 = 1351729836.4396307 Pa;
        param p13 = 0.0 s;
        param p14 = 0.01204860514339819 m;
        param p15 = 0.32113303027598716 m;
        param p16 = 0.747680240001648 m;
        param p17 = 0.3556207367379758 m;
        param p18 = -0.3887444489042675 m;
        param p19 = 0.747680240001648 m;
        param p20 = 0.3556207367379758 m;
        param p21: count = 2;
        param p22 = 0.32113303027598716 m;
        param p23 = 0.747680240001648 m;
        param p24 = 0.3556207367379758 m;
        param p25 = 0.15066750050554903 m;
        param p26 = -0.2925317017860726 m;
        param p27 = -0.2731327606317515 m;
        param p28 = 0.19830321247671198 m;
        param p29 = 0.1936990035096684 m;
        param p30 = 0.157908087617892 m;
        param p31 = -0.021785078236479294 m;
        param p32 = 17.10384959423586 rad/s;
        param p33 = 6.647158816949837 N;
        param p34 = -9.81 m/s^2;
        param p35 = 0.26265466729669423 m;
        param p36 = 17.10384959423586 rad/s;
        param p37 = 6.647158816949837 N;
        param p38 = 0.1936990035096684 m;
        param p39 = 0.157908087617892 m;
        param p40 = -0.021785078236479294 m;
        param p41 = -9.81 m/s^2;
        rigid f0 { origin = [p0, p1, p2]; velocity = [0, 0, 0]; axis = [0.0, 0.0, 1.0]; angle = p3; angular_velocity = [0, 0, 0]; mass = p4; center = [0, 0, 0]; inertia = [p5, p6, p7, p8, p9, p10]; }
        material m0 { density = p11; young = p12; damping = p13; }
        section s0 = circle(radius = p14);
        body b0 { spatial; line from [p15, p16, p17] to [p18, p19, p20]; mesh p21 * cable(s0, m0); }
        joint j0 = clamp(b0.start, inertial);
        joint j1 = spherical(b0.at(p25), f0.at([p26, p27, p28]));
        load l0 = force(f0.at([p29, p30, p31]), [p33 * sin(p32 * t), 0, 0], in = f0);
        load g0 = gravity([0, p34, 0]);
        output o0 = b0.end.in(inertial).velocity;
        output o1 = b0.end.in(inertial).position;
        output o2 = b0.end.in(f0).velocity;
        output o3 = b0.end.in(f0).position;
        output o4 = b0.at(p35).in(inertial).velocity;
        output o5 = b0.at(p35).in(inertial).position;
        output o6 = b0.at(p35).in(f0).velocity;
        output o7 = b0.at(p35).in(f0).position;
        output o8 = b0.at(p35).axial_force;
        output o9 = b0.at(p35).moment;
        output o10 = f0.in(inertial).velocity;
        output o11 = f0.in(inertial).position;
        output o12 = f0.angular_velocity;
        output o13 = j0.force;
        output o14 = j0.moment;
        output o15 = j1.force;
        output o16 = (j0.force) + (([p37 * sin(p36 * t), 0, 0]).x * f0.ex + ([p37 * sin(p36 * t), 0, 0]).y * f0.ey + ([p37 * sin(p36 * t), 0, 0]).z * f0.ez) + total.mass * [0, p41, 0];
        output o17 = total.momentum;
        output o18 = (j0.moment) + cross(b0.start.in(inertial).position, (j0.force)) + cross(f0.at([p38, p39, p40]).in(inertial).position, (([p37 * sin(p36 * t), 0, 0]).x * f0.ex + ([p37 * sin(p36 * t), 0, 0]).y * f0.ey + ([p37 * sin(p36 * t), 0, 0]).z * f0.ez)) + cross(total.center_of_mass, total.mass * [0, p41, 0]);
        output o19 = total.angular_momentum;
    }
}
