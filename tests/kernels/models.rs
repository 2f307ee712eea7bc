//! Models that together make the generator write every kind of kernel.

rncf::model! {
    /// Damped, curved, planar, polynomial bending; a moment at the tip.
    pub model CurvedDamped {
        material rubber { density = 1100 kg/m^3; young = 10 MPa; damping = 2 ms; }
        section square { area = 4 cm^2; second_moment = 1.3 cm^4; }
        motion theta(t) = 3 [rad/s] * t + 0.2 [rad] * sin(2 [rad/s] * t);
        frame rotor = rotating(axis = z, angle = theta(t));
        body strip in rotor {
            planar xy;
            arc from [0.1, 0, 0] m direction [1, 0.2, 0] radius 2 m angle 40 deg;
            mesh 3 * cable(square, rubber);
        }
        joint root = clamp(strip.start, rotor);
        load twist = moment(strip.end, [0, 0, 3] N*m);
        output tip = strip.end;
    }
}

rncf::model! {
    /// Damped, curved, planar, exact bending.
    pub model CurvedExact {
        param damping = 1 ms;
        material rubber { density = 1100 kg/m^3; young = 10 MPa; damping = damping; }
        section square { area = 4 cm^2; second_moment = 1.3 cm^4; }
        body strip in inertial {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius 2 m angle -40 deg;
            mesh 3 * cable(square, rubber, bending = exact);
        }
        joint root = pin(strip.start, inertial);
        output tip = strip.end;
    }
}

rncf::model! {
    /// Damped, in space, exact bending in a loop over points; a moment that turns with a frame.
    pub model SpatialExact {
        material _rubber { density = 1100 kg/m^3; young = 10 MPa; damping = 1 ms; }
        section square { area = 4 cm^2; second_moment = 1.3 cm^4; }
        frame rotor = rotating(axis = [1, 2, 2], angle = 3 [rad/s] * t);
        body strip in rotor {
            spatial;
            line from [0, 0, 0] m to [1, 0.5, 0.2] m;
            mesh 4 * tether(square, _rubber, bending = exact, quadrature = gauss(3));
        }
        joint root = clamp(strip.start, inertial);
        load twist = moment(strip.end, [0, 2 [N*m] * sin(1 [rad/s] * t), 1 [N*m]], in = rotor);
        output m_root = root.moment;
    }
}

rncf::model! {
    /// Damped, in space, polynomial bending by a three-point tensor; gravity and a force.
    pub model SpatialTensor {
        material _rubber { density = 1100 kg/m^3; young = 10 MPa; damping = 1 ms; }
        section square { area = 4 cm^2; second_moment = 1.3 cm^4; }
        body strip in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0.5, 0.2] m;
            mesh 4 * tether(square, _rubber, quadrature = gauss(3), evaluation = tensor);
        }
        joint root = clamp_full(strip.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        load pull = force(strip.end, [0, 1, 2] N);
        output f_root = root.force;
    }
}
