//! The electric solar wind sail with tethers that pull and never push (THEORY 10, T6). But for `slack` it is `Esail`.

rncf::model! {
    /// Electric solar wind sail at one astronomical unit whose tethers go slack instead of carrying compression: a wire of
    /// 628 m and 76 um buckles under 3e-12 N.
    pub model EsailSlack {
        /// Length of a main tether.
        param length = 10 km;
        /// Rate of spin.
        param spin = 0.25 deg/s;
        /// Potential of the main tethers.
        param voltage = 40 kV;
        /// Number of main tethers.
        param tethers: count = 100;
        /// Number of elements of a main tether.
        param elements: count = 16;
        /// Mass of a remote unit.
        param remote_mass = 0.45 kg;
        /// Mass of the core.
        param core_mass = 90 kg;
        /// Distance of the tethers' roots from the core.
        param hub_radius = 0 m;
        /// Relative differences of the remote units' masses, without a pattern: what a real sail buckles from.
        param asymmetry = 1e-6;

        const distance = 1.5e11 m;
        const solar_gravity = 5.93e-3 m/s^2;
        const orbital_rate = sqrt(solar_gravity / distance);
        /// Potential of the solar wind's protons.
        const wind = 1 kV;
        const thrust_factor = 2.4e-5 N/(kV km);

        // EA = 320 N, 1.23429e-5 kg/m, EI = 1.164e-7 N m^2
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 4.571428571428571e-9 m^2; second_moment = 1.663e-18 m^4; }

        /// Spins about its z axis, which points away from the Sun.
        frame sail = free(
            origin = [distance, 0, 0], axis = y, angle = 90 deg,
            velocity = [0, orbital_rate * distance, 0], angular_velocity = [-orbital_rate, 0, spin]
        );
        fixture core on sail { mass = core_mass; }

        for a in 0..tethers {
            body main[a] in sail {
                spatial;
                line from [hub_radius * cos(2*pi*a/tethers), hub_radius * sin(2*pi*a/tethers), 0]
                    to [(hub_radius + length) * cos(2*pi*a/tethers), (hub_radius + length) * sin(2*pi*a/tethers), 0];
                mesh elements * tether(wire, aluminium, slack = true);
            }
            joint hub[a] = clamp(main[a].start, sail);
            fixture remote[a] on main[a].end { mass = remote_mass * (1 + asymmetry * cos(a^2)); }
            /// Thrust of the solar wind, across the tether.
            load thrust[a] = density(main[a], thrust_factor * (if voltage > wind { voltage - wind } else { 0 kV }) * distance / dot(sail.position, sail.position)
                * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)));

            // One element between two tips, of the length of the arc.
            body aux[a] in sail {
                spatial;
                line from [0, 0, 0] m to [2*pi*(hub_radius + length)/tethers, 0, 0];
                mesh 1 * tether(wire, aluminium, slack = true);
                initial position [
                    (hub_radius + length) * cos(2*pi*a/tethers + x/(hub_radius + length)),
                    (hub_radius + length) * sin(2*pi*a/tethers + x/(hub_radius + length)),
                    0
                ];
            }
            joint near[a] = share(aux[a].start, main[a].end);
            joint far[a] = share(aux[a].end, main[(a + 1) % tethers].end);
            joint ring[a] = merge(aux[a].end, aux[(a + 1) % tethers].start);
        }
        start spun = spinning(sail, angular_velocity = [0, 0, spin]);

        load sun = gravity(-solar_gravity * distance^2 * sail.position / norm(sail.position)^3, on = sail);
        constraint sun_x = dot(sail.ex, sail.position) / distance;
        constraint sun_y = dot(sail.ey, sail.position) / distance;

        /// Distance of the core from the Sun beyond that at the start.
        output radial = norm(sail.position) - distance;
        /// How far the tips are out of the plane of the spin, away from the Sun: the least of all.
        output z_tip_min = min(a in 0..tethers, main[a].end.z);
        /// The same: the greatest of all.
        output z_tip_max = max(a in 0..tethers, main[a].end.z);
        /// Angular velocity about the axis of the spin.
        output spin: deg/s = sail.angular_velocity.z;
        /// Tension at the roots of the main tethers: the greatest of all.
        output tension_main = max(a in 0..tethers, main[a].start.axial_force);
        /// Tension of the ring in the middle of its pieces: the least of all.
        output tension_aux_min = min(a in 0..tethers, aux[a].at(pi*(hub_radius + length)/tethers).axial_force);
        /// The same: the greatest of all.
        output tension_aux_max = max(a in 0..tethers, aux[a].at(pi*(hub_radius + length)/tethers).axial_force);
        /// Torques that keep the axis of the spin pointing at the Sun, THEORY (26).
        output torque_x = sun_x.multiplier;
        output torque_y = sun_y.multiplier;

        caution point_hub = "with a hub smaller than an element the torques are made by the mesh: they halve with every refinement"
            on torque_x, torque_y if hub_radius < length / elements;
        caution long = "a hub smaller than an element carries the spin axis round the orbit, which a real sail does not: beyond a day give a hub_radius"
            if (if hub_radius < length / elements { t_end } else { 0 s }) > 1 day;

        run { t_end = 200 s; every = 1 s; }
    }
}
