//! Three scenes of which it is known how much model they need.

rncf::model! {
    /// A slider-crank that runs free: a flywheel, a short rod of steel and a piston. The rod does not bend, but its rotary
    /// inertia takes part in the exchange of energy with the flywheel.
    pub model Engine {
        /// Spin of the flywheel at the start.
        param spin = 20 rad/s;
        /// Number of elements of the rod.
        param elements: count = 4;

        const crank = 0.1 m;
        const length = 0.3 m;
        const width = 2 cm;

        // The jolt of the start dies away.
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; damping = 1e-5 s; }
        section square { area = width^2; second_moment = width^4 / 12; }

        rigid flywheel { plane xy; mass = 4 kg; inertia = 0.02 kg*m^2; speed = spin; }
        joint bearing = revolute(flywheel, inertial.at([0, 0, 0] m));
        /// Frame of the rod, which begins at the crank's pin and lies along x at the start.
        frame link = free(
            plane = xy, origin = [crank, 0, 0], velocity = [0, crank * spin, 0], speed = -crank * spin / length
        );
        body rod in link {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(square, steel);
        }
        joint root = pin(rod.start, link);
        joint chord = hold(rod.end.y);
        joint crank_pin = revolute(flywheel.at([crank, 0, 0]), rod.start);
        fixture piston on rod.end { mass = 0.5 kg; }
        constraint guide = rod.end.in(inertial).y;

        /// Position of the piston.
        output piston = rod.end.in(inertial).x;
        /// Spin of the flywheel.
        output spin = flywheel.speed;

        run { t_end = 2 s; every = 0.005 s; }
    }
}

rncf::model! {
    /// A slender boom on a hub that turns slowly by half a turn a minute: it bends nearly as under a steady load.
    pub model Boom {
        /// Final spin of the hub.
        param omega_s = 0.05 rad/s;
        /// Time to reach it.
        param T_s = 30 s;
        /// Number of elements.
        param elements: count = 8;

        const length = 8 m;

        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
        // A thin tube, 5 cm in radius.
        section tube { area = 5 cm^2; second_moment = 62.5 cm^4; }
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));
        body boom in hub {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(tube, aluminium);
        }
        joint root = clamp(boom.start, hub);

        /// Deflection of the tip.
        output tip = boom.end.y;
        /// Deflection of the middle.
        output middle = boom.at(length / 2).y;

        run { t_end = 30 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// Two tethers with units at their tips spin about a core, one unit is pushed for a while: an electric sail with two
    /// tethers. Nothing of the core but its mass counts beside the tethers.
    pub model Spinner {
        /// Spin.
        param spin = 0.5 rad/s;
        /// Number of elements of a tether.
        param elements: count = 2;

        const length = 50 m;
        const radius = 0.25 m;
        const unit = 0.5 kg;
        const thrust = 0.2 N;
        const push_time = 8 s;
        const stiffness = 1e5 N;
        const tether_mass = 0.01 kg/m;
        /// Strain of the tethers by the square of the spin.
        const stretch = (unit * (length + radius) + tether_mass * length * (length/2 + radius)) / stiffness;

        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar { area = 40 cm^2; second_moment = 200 cm^4; }
        material fibre { density = 1000 kg/m^3; young = 10 GPa; damping = 0.02 s; }
        section cord { area = 10 mm^2; second_moment = 8 mm^4; }

        frame hub = free(plane = xy, speed = spin);
        body core in hub {
            planar xy;
            line from [-radius, 0, 0] to [radius, 0, 0];
            mesh 2 * cable(bar, steel);
        }
        joint mount = clamp(core.start, hub);
        /// Electronics in the middle of the core.
        fixture bus on hub { mass = 5 kg; }
        for a in 0..2 {
            body tether[a] in hub {
                planar xy;
                line from [radius * (1 - 2*a), 0, 0] to [(radius + length) * (1 - 2*a), 0, 0];
                mesh elements * tether(cord, fibre);
                initial position [(radius + x * (1 + stretch * spin^2)) * (1 - 2*a), 0, 0];
            }
            joint root[a] = pin(tether[a].start, hub);
            fixture tip[a] on tether[a].end { mass = unit; }
        }
        load push = force(tether[0].end, [0, thrust * (if t <= push_time { sin(pi*t/push_time)^2 } else { 0 }), 0]);

        /// Unit that is pushed.
        output unit_0 = tether[0].end.in(inertial);
        /// The other one.
        output unit_1 = tether[1].end.in(inertial);
        /// Core.
        output place = hub;

        run { t_end = 12 s; every = 0.1 s; }
    }
}
