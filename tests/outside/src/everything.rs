//! Two models that between them use every word of the language: they build without a warning.

rncf::model! {
    /// Everything that a planar scene may have.
    pub model Planar {
        /// Steady angular velocity.
        param omega_s = 4 rad/s;
        /// Number of elements.
        param elements: count = 6;
        /// Time to reach the steady speed.
        param T_s = 15 s;
        param radius = 16 m;
        /// Acceleration of free fall.
        const g = 9.81 m/s^2;
        /// Aluminium, slightly damped.
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; damping = 1e-5 s; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        motion sway(t) = 3 mm * sin(2 Hz * 2*pi * t);
        frame cart = moving(origin = [sway(t), 0 m, 0]);
        frame hub in cart = rotating(axis = z, angle = theta(t), origin = [1, 2, 0] cm);
        body beam in hub {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius (radius) angle 30 deg;
            mesh elements * cable(tube, aluminium, evaluation = points);
        }
        body rope in inertial {
            planar xy;
            line from [0, -5, 0] m to [8, -5, 0] m;
            mesh 4 * tether(tube, aluminium, quadrature = gauss(4));
        }
        joint root = clamp(beam.start, hub);
        joint left = pin(rope.start, inertial);
        joint right = pin(rope.end, inertial, at = [8, -5, 0] m);
        load weight = gravity([0, -g, 0]);
        load pull = force(beam.end, [0, 10, 0] N, in = hub);
        load twist = moment(beam.end, [0, 0, 3] N*m);
        output u = beam.end.x - radius * sin(30 deg);
        output tip = beam.end;
        output vy = beam.at(4 m).velocity.y;
        output s = beam.end.slope.x;
        output m_root = root.moment.z;
        output f_root = root.force;
        output f_left = left.force.y;
        output turn = theta(t);
        output largest = max(abs(rope.at(4 m).y), 1 mm);
        run { t_end = 20 s; every = 0.05 s; }
    }
}

rncf::model! {
    /// What only a spatial scene may have.
    pub model Spatial {
        param amplitude = 3 mm;
        param f = 2 Hz;
        param L = 1 m;
        const half = 5 mm;
        material steel { density = 7.85 g/cm^3; young = 210 GPa; }
        section thin { area = pi * (1 mm)^2 / 4; second_moment = pi * (1 mm)^4 / 64; }
        motion x(t) = amplitude * sin(2*pi*f*t) + 0 m;
        frame stage = rotating(axis = [0, 3, 4], angle = pi/2, origin = [1, 2, 3] cm);
        frame cart in stage = moving(origin = [x(t), 0 m, 0]);
        body wire in cart {
            spatial;
            line from [0, 0, 0] m to [L, 0, 0 m];
            mesh (3) * tether(thin, steel, bending = exact, quadrature = gauss(3), evaluation = loop);
        }
        joint left = clamp_full(wire.start, cart);
        load weight = gravity([0, 0, -9.81] m/s^2);
        load pull = force(wire.at(L/2), [0 N, 3 N * sin(2*pi*f*t), 0], in = stage);
        output a = wire.end.z * 2 + half;
        output b = left.moment;
        output d = atan2(wire.end.y, wire.end.x);
    }
}
