//! High-speed motor (Ren & Yang 2021, section 4.1.3): an unbalanced rotor disc on a flexible shaft.

rncf::model! {
    /// High-speed motor (Ren & Yang 2021, section 4.1.3): a shaft that is clamped in the motor and pinned at its far end
    /// carries an unbalanced disc in its middle.
    pub model Motor {
        /// Steady angular velocity.
        param speed = 10000 rpm;
        /// Time to reach it.
        param T_s = 1 s;
        /// Number of elements; an even one has a node under the disc.
        param elements: count = 4;
        /// Damping time of the shaft's strains.
        param damping = 0 s;
        /// Distance of the disc's centre from the axis, along y.
        param eccentricity = 50 mm;

        const length = 1.02 m;
        const disc_radius = 0.1 m;
        const disc_thickness = 10 mm;
        const disc_mass = 7800 [kg/m^3] * pi * disc_radius^2 * disc_thickness;

        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; damping = damping; yield = 355 MPa; }
        section round = circle(radius = 50 mm);

        /// Angle of the motor, Eq. (22).
        motion theta(t) =
            if t <= T_s { (speed/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { speed * (t - T_s/2) };
        frame rotor = rotating(axis = x, angle = theta(t));

        body shaft in rotor {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(round, steel);
        }
        joint drive_end = clamp(shaft.start, rotor);
        joint far_end = pin(shaft.end, rotor);
        // The section strains with the disc: the records of this example were made so, by chains of particles.
        fixture disc on shaft.at(length / 2) {
            section = elastic;
            mass = disc_mass;
            center = [0 m, eccentricity, 0 m];
            inertia = [
                disc_mass * disc_radius^2 / 2,
                disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
                disc_mass * (disc_radius^2 / 4 + disc_thickness^2 / 12),
            ];
        }

        /// Deflection of the shaft's middle towards the disc's centre, in the rotating frame.
        output v_mid = shaft.at(length / 2).y;
        /// Deflection of the shaft's middle across it.
        output w_mid = shaft.at(length / 2).z;
        /// Bending moment in the clamp.
        output clamp_moment = shaft.start.moment_z;
        /// Largest stress in the clamp.
        output clamp_stress = shaft.start.stress;

        run { t_end = 1.2 s; every = 1 ms; }
    }
}
