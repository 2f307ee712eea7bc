//! Beams that rotate with a hub.

rncf::model! {
    /// Spin-up of THEORY 9.1 with the exact curvature.
    pub model SpinUpExact {
        /// Steady angular velocity.
        param omega_s = 10 rad/s;
        /// Time to reach it.
        param T_s = 15 s;
        /// Number of elements.
        param elements: count = 16;
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));
        body beam in hub {
            planar xy;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh elements * cable(tube, aluminium, bending = exact);
        }
        joint root = clamp(beam.start, hub);
        output u = beam.end.x - 8 m;
        output v = beam.end.y;
        run { t_end = 18 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// The beam of THEORY 9.1 in uniform rotation from the start.
    pub model Uniform {
        param spin = 40 rad/s;
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        frame hub = rotating(axis = z, angle = spin * t);
        body beam in hub {
            planar xy;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh 6 * cable(tube, aluminium);
        }
        joint root = clamp(beam.start, hub);
        output u = beam.end.x - 8 m;
        output v = beam.end.y;
    }
}

rncf::model! {
    /// A bar that a hub sets in rotation and its weight bends: forces in units of their own.
    pub model Flapping {
        param elements: count = 6;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; damping = 0.1 ms; }
        section flat { area = 4 cm^2; second_moment = 0.3 cm^4; }
        motion spin(t) = if t <= 1 s { 2 [rad/s^2] * t^2 } else { 2 rad + 4 [rad/s] * (t - 1 s) };
        frame hub = rotating(axis = z, angle = spin(t));
        body bar in hub {
            planar xy;
            line from [0.2, 0, 0] m to [2.2, 0, 0] m;
            mesh elements * cable(flat, aluminium);
        }
        joint root = clamp(bar.start, hub);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output tip: mm = bar.end.y;
        output force: kN = root.force;
        output moment: N*mm = root.moment;
        output acceleration = bar.end.in(inertial).acceleration;
        run { t_end = 3 s; every = 10 ms; }
    }
}
