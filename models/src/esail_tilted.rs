//! E-sail at an angle to the solar wind, held there by the voltages of its tethers (Toivanen & Janhunen 2013, Janhunen & Toivanen
//! 2016): how its rate of spin changes, and how the ring prevents it.

rncf::model! {
    /// A tilted E-sail with free attitude. The voltage of each main tether varies with its place, so that the thrust turns the
    /// plane of the spin with the orbit (Toivanen & Janhunen 2013). The part of that thrust in the plane then changes the rate
    /// of spin by orbital_rate tan(tilt): slowly faster where the sail is driven along its orbit, slower where against it. The ring
    /// of auxiliary tethers has no such part, so that charging it takes the change away (TI tether rig, Janhunen & Toivanen 2016).
    pub model EsailTilted {
        /// Angle of the spin axis to the direction from the Sun, positive towards the motion on the orbit.
        param tilt = 35 deg;
        /// How strongly the voltages answer to the angle that the spin axis is off.
        param gain = 0.1;
        /// Part of the turning that the ring does: 0 none, 1 all of it, 2 reverses the change of the spin.
        param ring_share = 0;
        /// Amplitude of the voltages that turns the spin axis with the orbit: 4 (m + rho A L / 3) spin orbital_rate / (f cos(tilt)),
        /// with the thrust f per length.
        param turning = 0.00444;
        /// Mean potential of the ring, as a part of that of the main tethers, where it does something.
        param ring_bias = 0.1;
        /// Length of a main tether.
        param length = 10 km;
        /// Rate of spin.
        param spin = 0.5 deg/s;
        /// Potential of the main tethers.
        param voltage = 40 kV;
        /// Number of main tethers.
        param tethers: count = 20;
        /// Number of elements of a main tether.
        param elements: count = 4;
        /// Mass of a remote unit.
        param remote_mass = 0.45 kg;
        /// Mass of the core.
        param core_mass = 18 kg;

        const distance = 1.5e11 m;
        const solar_gravity = 5.93e-3 m/s^2;
        const orbital_rate = sqrt(solar_gravity / distance);
        const wind = 1 kV;
        const thrust_factor = 2.4e-5 N/(kV km);
        const hub_radius = 5 m;

        material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 4.571428571428571e-9 m^2; second_moment = 1.663e-18 m^4; }

        // Its x axis is that of the spin at the start.
        frame tilted = rotating(axis = z, angle = tilt);
        /// Spins about its z axis.
        frame sail in tilted = free(
            origin = [distance * cos(tilt), -distance * sin(tilt), 0], axis = y, angle = 90 deg,
            velocity = [orbital_rate * distance * sin(tilt), orbital_rate * distance * cos(tilt), 0],
            angular_velocity = [0, 0, spin]
        );
        fixture core on sail { mass = core_mass; }

        for a in 0..tethers {
            body main[a] in sail {
                spatial;
                line from [hub_radius * cos(2*pi*a/tethers), hub_radius * sin(2*pi*a/tethers), 0]
                    to [(hub_radius + length) * cos(2*pi*a/tethers), (hub_radius + length) * sin(2*pi*a/tethers), 0];
                mesh elements * tether(wire, aluminium);
            }
            joint hub[a] = clamp(main[a].start, sail);
            fixture remote[a] on main[a].end { mass = remote_mass; }
            load thrust[a] = density(main[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
                * (1 + (1 - ring_share) * dot(
                    sin(2*pi*a/tethers) * sail.ex - cos(2*pi*a/tethers) * sail.ey,
                    turning * cross([0, 0, 1], sail.ez)
                        + gain * (cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)) / norm(sail.position)))
                * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));

            body aux[a] in sail {
                spatial;
                line from [0, 0, 0] m to [2*pi*(hub_radius + length)/tethers, 0, 0];
                mesh 1 * tether(wire, aluminium);
                initial position [
                    (hub_radius + length) * cos(2*pi*a/tethers + x/(hub_radius + length)),
                    (hub_radius + length) * sin(2*pi*a/tethers + x/(hub_radius + length)),
                    0
                ];
            }
            // Moments about the core: a main tether's thrust acts half way out, the ring's at the tips.
            load ring_thrust[a] = density(aux[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
                * (if ring_share > 0 { 1 } else { 0 })
                * (ring_bias + ring_share * tethers / (4*pi) * dot(
                    sin(2*pi*(a + 0.5)/tethers) * sail.ex - cos(2*pi*(a + 0.5)/tethers) * sail.ey,
                    turning * cross([0, 0, 1], sail.ez)
                        + gain * (cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)) / norm(sail.position)))
                * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));
            joint near[a] = share(aux[a].start, main[a].end);
            joint far[a] = share(aux[a].end, main[(a + 1) % tethers].end);
            joint ring[a] = merge(aux[a].end, aux[(a + 1) % tethers].start);
        }
        start spun = spinning(sail, angular_velocity = [0, 0, spin]);
        load sun = gravity(-solar_gravity * distance^2 * sail.position / norm(sail.position)^3, on = sail);

        /// Rate of spin.
        output spin: deg/s = sail.angular_velocity.z;
        /// Angle between spin axis and direction from the Sun.
        output angle: deg = atan2(norm(cross(sail.position, sail.ez)), dot(sail.position, sail.ez));
        /// Angle between spin axis and the direction where it is to be.
        output off: deg = asin(norm(cross(sail.ez, cos(tilt) * sail.position + sin(tilt) * cross([0, 0, 1], sail.position)))
            / norm(sail.position));
        /// Highest and lowest tip across the plane of the spin.
        output z_tip_max = max(a in 0..tethers, main[a].end.z);
        output z_tip_min = min(a in 0..tethers, main[a].end.z);

        run { t_end = 1 day; every = 10 min; }
    }
}
