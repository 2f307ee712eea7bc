rncf::model! {
    pub model A {
        param p0 = 0.46471112855823815 m;
        param p1 = 0.3280204404427952 m;
        param p2 = 0.0 rad;
        param p3 = 0.0 rad/s;
        param p4 = 0.32563554289944474 kg;
        param p5 = 0.0059676115418203935 kg*m^2;
        param p6 = 2178.229300240584 kg/m^3;
        param p7 = 523396103.3635189 Pa;
        param p8 = 0.0001823080912271354 s;
        param p9 = 0.018804539571688445 m;
        param p10 = -0.11028866419395483 m;
        param p11 = -0.23796809943991865 m;
        param p12 = -0.11028866419395483 m;
        param p13 = 0.5072074593280077 m;
        param p14: count = 2;
        param p15 = 0.5721152614955556 m;
        param p16 = 0.255004529231563 m;
        param p17 = 0.10740413293731743 m;
        param p18 = -0.07301591121123219 m;
        param p19 = -0.01879373047959132 rad;
        param p20 = 5.086906697133292 rad/s;
        param p21 = -0.11028866419395483 m;
        param p22 = -0.23796809943991865 m;
        param p23 = 8.723817148384631 N;
        param p24 = 0.2757149567441327 m;
        param p25 = 0.5721152614955556 m;
        param p26 = 0.255004529231563 m;
        param p27 = 8.723817148384631 N;
        rigid f0 { plane xy; origin = [p0, p1, 0]; velocity = [0, 0, 0]; angle = p2; speed = p3; mass = p4; center = [0, 0, 0]; inertia = p5; }
        material m0 { density = p6; young = p7; damping = p8; }
        section s0 = circle(radius = p9);
        body b0 in f0 { planar xy; line from [p10, p11, 0] to [p12, p13, 0]; mesh p14 * cable(s0, m0); }
        joint j0 = revolute(inertial.at([p15, p16, 0]), f0.at([p17, p18, 0]));
        joint j0_drive = drive(j0.angle, p19 * (1 - cos(p20 * t)));
        joint j1 = clamp(b0.start, f0);
        load l0 = follower(b0.end, p23);
        output o0 = b0.end.in(inertial).velocity;
        output o1 = b0.end.in(inertial).position;
        output o2 = b0.end.in(f0).velocity;
        output o3 = b0.end.in(f0).position;
        output o4 = b0.at(p24).in(inertial).velocity;
        output o5 = b0.at(p24).in(inertial).position;
        output o6 = b0.at(p24).in(f0).velocity;
        output o7 = b0.at(p24).in(f0).position;
        output o8 = b0.at(p24).axial_force;
        output o9 = b0.at(p24).moment;
        output o10 = f0.in(inertial).velocity;
        output o11 = f0.in(inertial).position;
        output o12 = j0.force;
        output o13 = j1.force;
        output o14 = j1.moment;
        output o15 = -(j0.force) + p27 * b0.end.in(inertial).slope / norm(b0.end.in(inertial).slope);
        output o16 = total.momentum;
        output o17 = -j0_drive.moment.z + cross([p25, p26, 0], -(j0.force)).z + cross(b0.end.in(inertial).position, p27 * b0.end.in(inertial).slope / norm(b0.end.in(inertial).slope)).z;
        output o18 = total.angular_momentum.z;
    }
}
rncf::model! {
    pub model B {
        param p0 = 0.16230451081648029 m;
        param p1 = -0.5451706963170156 m;
        param p2 = -0.0 rad;
        param p3 = -0.0 rad/s;
        param p4 = 0.32563554289944474 kg;
        param p5 = 0.0059676115418203935 kg*m^2;
        param p6 = 2178.229300240584 kg/m^3;
        param p7 = 523396103.3635189 Pa;
        param p8 = 0.0001823080912271354 s;
        param p9 = 0.018804539571688445 m;
        param p10 = 0.06050971556215107 m;
        param p11 = 0.2552077195605993 m;
        param p12 = -0.16992389701180632 m;
        param p13 = -0.037575482728036236 m;
        param p14: count = 1;
        param p15 = -0.16992389701180632 m;
        param p16 = -0.037575482728036236 m;
        param p17 = -0.4003575095857637 m;
        param p18 = -0.3303586850166718 m;
        param p19: count = 1;
        param p20 = 0.29186175570523565 m;
        param p21 = -0.554220080763406 m;
        param p22 = 0.12955724488875534 m;
        param p23 = -0.009049384446390411 m;
        param p24 = 0.01879373047959132 rad;
        param p25 = 5.086906697133292 rad/s;
        param p26 = 0.06050971556215107 m;
        param p27 = 0.2552077195605993 m;
        param p28 = 8.723817148384631 N;
        param p29 = 0.2757149567441327 m;
        param p30 = 0.29186175570523565 m;
        param p31 = -0.554220080763406 m;
        param p32 = 8.723817148384631 N;
        rigid f0 { plane yz; origin = [0, p0, p1]; velocity = [0, 0, 0]; angle = p2; speed = p3; mass = p4; center = [0, 0, 0]; inertia = p5; }
        material m0 { density = p6; young = p7; damping = p8; }
        section s0 = circle(radius = p9);
        body b0 in f0 { planar yz; line from [0, p10, p11] to [0, p12, p13]; mesh p14 * cable(s0, m0); }
        body b0_2 in f0 { planar yz; line from [0, p15, p16] to [0, p17, p18]; mesh p19 * cable(s0, m0); }
        joint b0_along = merge(b0.end, b0_2.start);
        joint j0 = revolute(inertial.at([0, p20, p21]), f0.at([0, p22, p23]));
        joint j0_drive = drive(j0.angle, p24 * (1 - cos(p25 * t)));
        joint j1 = clamp(b0.start, f0);
        load l0 = follower(b0_2.end, p28);
        output o0 = b0_2.end.in(inertial).velocity;
        output o1 = b0_2.end.in(inertial).position;
        output o2 = b0_2.end.in(f0).velocity;
        output o3 = b0_2.end.in(f0).position;
        output o4 = b0.at(p29).in(inertial).velocity;
        output o5 = b0.at(p29).in(inertial).position;
        output o6 = b0.at(p29).in(f0).velocity;
        output o7 = b0.at(p29).in(f0).position;
        output o8 = b0.at(p29).axial_force;
        output o9 = b0.at(p29).moment;
        output o10 = f0.in(inertial).velocity;
        output o11 = f0.in(inertial).position;
        output o12 = j0.force;
        output o13 = j1.force;
        output o14 = j1.moment;
        output o15 = -(j0.force) + p32 * b0_2.end.in(inertial).slope / norm(b0_2.end.in(inertial).slope);
        output o16 = total.momentum;
        output o17 = -j0_drive.moment.x + cross([0, p30, p31], -(j0.force)).x + cross(b0_2.end.in(inertial).position, p32 * b0_2.end.in(inertial).slope / norm(b0_2.end.in(inertial).slope)).x;
        output o18 = total.angular_momentum.x;
    }
}
