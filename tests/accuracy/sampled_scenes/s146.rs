rncf::model! {
    pub model A {
        param p0 = -0.47725571802959427 m;
        param p1 = -0.4934151835308773 m;
        param p2 = 0.0 rad;
        param p3 = 0.0 rad/s;
        param p4 = 1.7155172151595248 kg;
        param p5 = 0.0063804546281955475 kg*m^2;
        param p6 = 2876.5867298095845 kg/m^3;
        param p7 = 2038163744.7813118 Pa;
        param p8 = 0.00025199250396837645 s;
        param p9 = 0.27834591870026193;
        param p10 = 0.023137383716870158 m;
        param p11 = 0.05806108654055395 m;
        param p12 = 0.5609518737092605 m;
        param p13 = 0.029708942052115495 m;
        param p14 = -0.25075259149237983 m;
        param p15 = 0.029708942052115495 m;
        param p16: count = 3;
        param p17 = 0.5609518737092605 m;
        param p18 = 0.029708942052115495 m;
        param p19 = -0.5338774178496648 m;
        param p20 = -0.2059799326944587 m;
        param p21 = -0.05662169982007054 m;
        param p22 = 0.28743525083641863 m;
        param p23 = -0.10627861284831636 m;
        param p24 = -0.23535402018024942 m;
        param p25 = -9.81 m/s^2;
        param p26 = 0.3003306521246069 m;
        param p27 = 0.5609518737092605 m;
        param p28 = 0.029708942052115495 m;
        param p29 = -0.5338774178496648 m;
        param p30 = -0.2059799326944587 m;
        param p31 = -9.81 m/s^2;
        rigid f0 { plane xy; origin = [p0, p1, 0]; velocity = [0, 0, 0]; angle = p2; speed = p3; mass = p4; center = [0, 0, 0]; inertia = p5; }
        material m0 { density = p6; young = p7; damping = p8; poisson = p9; }
        section s0 = rectangle(y = 2 * p10, z = p11);
        body b0 { planar xy; line from [p12, p13, 0] to [p14, p15, 0]; mesh p16 * beam(s0, m0); }
        joint j0 = weld(inertial.at([p17, p18, 0]), b0.start);
        joint j1 = revolute(inertial.at([p19, p20, 0]), f0.at([p21, p22, 0]));
        joint j2 = distance(f0.at([p23, p24, 0]), b0.end);
        load g0 = gravity([0, p25, 0]);
        output o0 = b0.end.in(inertial).velocity;
        output o1 = b0.end.in(inertial).position;
        output o2 = b0.end.in(f0).velocity;
        output o3 = b0.end.in(f0).position;
        output o4 = b0.at(p26).in(inertial).velocity;
        output o5 = b0.at(p26).in(inertial).position;
        output o6 = b0.at(p26).in(f0).velocity;
        output o7 = b0.at(p26).in(f0).position;
        output o8 = b0.at(p26).axial_force;
        output o9 = b0.at(p26).shear_y;
        output o10 = b0.at(p26).moment_z;
        output o11 = f0.in(inertial).velocity;
        output o12 = f0.in(inertial).position;
        output o13 = j0.force;
        output o14 = j0.moment;
        output o15 = j1.force;
        output o16 = j2.force;
        output o17 = (j0.force) + -(j1.force) + total.mass * [0, p31, 0];
        output o18 = total.momentum;
        output o19 = j0.moment.z + cross([p27, p28, 0], (j0.force)).z + cross([p29, p30, 0], -(j1.force)).z + cross(total.center_of_mass, total.mass * [0, p31, 0]).z;
        output o20 = total.angular_momentum.z;
    }
}
