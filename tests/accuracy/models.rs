//! Models whose parameters the references share: there the same numbers are written by hand.

rncf::model! {
    /// Soft, damped beam with exact curvature in the plane, its root beside the axis of the hub that spins it up.
    pub model SoftPlanar {
        /// Steady angular velocity.
        param omega_s = 3 rad/s;
        /// Time to reach it.
        param T_s = 2 s;
        /// Number of elements.
        param elements: count = 1;
        material rubber { density = 1000 kg/m^3; young = 0.2 MPa; damping = 5 ms; }
        section strip { area = 2 cm^2; second_moment = 50 cm^4; }
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));
        body beam in hub {
            planar xy;
            line from [0.7, 0, 0] m to [2.7, 0, 0] m;
            mesh elements * cable(strip, rubber, bending = exact);
        }
        joint root = clamp(beam.start, hub);
        output f_root = root.force;
        output m_root = root.moment;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// Soft, undamped beam with polynomial bending in space, its root beside the axis of the hub that spins it up.
    pub model SoftSpatial {
        /// Steady angular velocity.
        param omega_s = 3 rad/s;
        /// Time to reach it.
        param T_s = 2 s;
        /// Number of elements.
        param elements: count = 1;
        material rubber { density = 1000 kg/m^3; young = 0.2 MPa; }
        section strip { area = 2 cm^2; second_moment = 50 cm^4; }
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));
        body beam in hub {
            spatial;
            line from [0.7, 0, 0] m to [2.7, 0, 0] m;
            mesh elements * cable(strip, rubber);
        }
        joint root = clamp(beam.start, hub);
        output f_root = root.force;
        output m_root = root.moment;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// The beam of the spin-up at its final speed, with what its root holds.
    pub model Held {
        /// Angular velocity.
        param omega = 4 rad/s;
        /// Number of elements.
        param elements: count = 6;
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        frame hub = rotating(axis = z, angle = omega * t);
        body beam in hub {
            planar xy;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh elements * cable(tube, aluminium);
        }
        joint root = clamp(beam.start, hub);
        output u = beam.end.x - 8 m;
        output v = beam.end.y;
        output f_root = root.force;
        output m_root = root.moment;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// The same in space.
    pub model HeldSpatial {
        /// Angular velocity.
        param omega = 4 rad/s;
        /// Number of elements.
        param elements: count = 6;
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        frame hub = rotating(axis = z, angle = omega * t);
        body beam in hub {
            spatial;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh elements * cable(tube, aluminium);
        }
        joint root = clamp(beam.start, hub);
        output u = beam.end.x - 8 m;
        output v = beam.end.y;
        output w = beam.end.z;
        output f_root = root.force;
        output m_root = root.moment;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// Cable that hangs from a pin and swings under gravity; nothing moves but itself.
    pub model Hanging {
        /// Damping of the cable.
        param damping = 0 s;
        /// Number of elements.
        param elements: count = 4;
        material rubber { density = 1000 kg/m^3; young = 1 MPa; damping = damping; }
        section round { area = 2 cm^2; second_moment = 1 cm^4; }
        body cable in inertial {
            planar xy;
            line from [0, 0, 0] m to [1.5, 0, 0] m;
            mesh elements * tether(round, rubber);
        }
        joint pivot = pin(cable.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output tip = cable.end;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// The same without damping, which conserves its energy.
    pub model Conservative {
        /// Number of elements.
        param elements: count = 4;
        material rubber { density = 1000 kg/m^3; young = 1 MPa; }
        section round { area = 2 cm^2; second_moment = 1 cm^4; }
        body cable in inertial {
            planar xy;
            line from [0, 0, 0] m to [1.5, 0, 0] m;
            mesh elements * tether(round, rubber);
        }
        joint pivot = pin(cable.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output tip = cable.end;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// Spin-up of THEORY 9.1 with the three-point rule.
    pub model SpinUpReduced {
        /// Number of elements.
        param elements: count = 6;
        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
        motion theta(t) =
            if t <= 15 s { (4 [rad/s] / 15 s) * (t^2/2 + (15 s/(2*pi))^2 * (cos(2*pi*t/15 s) - 1)) }
            else { 4 [rad/s] * (t - 7.5 s) };
        frame hub = rotating(axis = z, angle = theta(t));
        body beam in hub {
            planar xy;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh elements * cable(tube, aluminium, quadrature = gauss(3));
        }
        joint root = clamp(beam.start, hub);
        output u = beam.end.x - 8 m;
        output v = beam.end.y;
    }
}

rncf::model! {
    /// A body in a turning frame whose direction is held by the ground.
    pub model HeldByGround {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section rod { area = 1 cm^2; second_moment = 1 cm^4; }
        frame hub = rotating(axis = z, angle = 3 [rad/s] * t);
        body beam in hub {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 2 * cable(rod, steel);
        }
        joint root = clamp(beam.start, inertial);
        output u = beam.end.x;
    }
}

rncf::model! {
    /// The same held by a frame that turns with it.
    pub model HeldByArm {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section rod { area = 1 cm^2; second_moment = 1 cm^4; }
        frame hub = rotating(axis = z, angle = 3 [rad/s] * t);
        frame arm in hub = rotating(axis = y, angle = 20 deg);
        body beam in hub {
            spatial;
            line from [0.1, 0, 0] m to [1, 0, 0] m;
            mesh 2 * cable(rod, steel);
        }
        joint root = clamp(beam.start, arm);
        load pull = force(beam.end, [10, 0, 3] N, in = arm);
        output u = beam.end.x;
    }
}
