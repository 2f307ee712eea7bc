//! A cable with a mass at its end, tumbling freely in space (THEORY 9.6).

rncf::model! {
    /// A soft cable that flies and tumbles freely with a mass at its end: nothing acts on it, so that energy, momentum and
    /// angular momentum stay.
    pub model FreeFlight {
        /// Number of elements.
        param elements: count = 3;
        /// Mass at the end.
        param tip_mass = 0.7 kg;
        /// Radius of the arc that the cable starts in.
        param radius = 1.5 m;
        /// Initial angular velocity about the tangent at the cable's start: it keeps the cable bent.
        param roll = 4 rad/s;
        /// Initial angular velocity in the plane of the arc, across the tangent.
        param pitch = -1 rad/s;
        /// Initial angular velocity about the normal of the arc.
        param yaw = 1 rad/s;

        // EA = 400 N, EI = 2 N m^2 and 1.5 kg/m.
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }

        /// Frame of the cable: it follows the chord, which no quick bending turns.
        frame f = free(
            origin = [0.3, -0.2, 0.5] m, axis = [1, 2, -1], angle = 40 deg,
            velocity = [-3, 1, 2] m/s, angular_velocity = [roll, pitch, yaw]
        );
        body cable in f {
            spatial;
            line from [0, 0, 0] m to [2, 0, 0] m;
            mesh elements * cable(flat, soft);
            initial position [radius * sin(x / radius), radius * (1 - cos(x / radius)), 0];
            chord;
        }
        fixture tip on cable.end { mass = tip_mass; }

        /// Start of the cable in space.
        output start = cable.start.in(inertial);
        /// End of the cable in space.
        output end = cable.end.in(inertial);
        /// Distance between the ends.
        output span = norm(cable.end.position - cable.start.position);

        run { t_end = 2 s; every = 0.01 s; }
    }
}
