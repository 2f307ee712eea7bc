//! Flexible slider-crank (Ren & Yang 2021, section 4.2).

rncf::model! {
    /// Flexible slider-crank (Ren & Yang 2021, section 4.2): a soft connecting rod between a crank that is driven about x
    /// and a slider on the x axis.
    pub model SliderCrank {
        /// Steady angular velocity of the crank.
        param omega_s = 8 rad/s;
        /// Time to reach it.
        param T_s = 1 s;
        /// Number of elements.
        param elements: count = 8;
        /// Damping time of the rod's axial strain.
        param damping = 0 s;
        /// Mass of the slider.
        param slider_mass = 0.08 kg;

        const crank = 0.14 m;
        const length = 0.3 m;
        const radius = 8 mm;

        // A thousand times softer than steel, so that deflections can be seen; the underscore: axial strain alone is meant to be damped.
        material _soft { density = 7870 kg/m^3; young = 0.2 GPa; poisson = 0.29; damping = damping; }
        section round { area = pi * radius^2; second_moment = pi * radius^4 / 4; }

        /// Angle of the crank, THEORY (22).
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        /// Moves with the crank's pin, which begins at the origin; the crank's axis lies below it.
        frame pin_frame = moving(origin = [0, -crank * sin(theta(t)), crank * (cos(theta(t)) - 1)]);
        /// Frame of the rod.
        frame rod in pin_frame = turning();

        body beam in rod {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(round, _soft, bending = exact);
        }
        // The rod's own frame follows its chord: five ties. A centre line has no twist, so that the sixth is the universal
        // joint at the pin, whose cross axis on the crank is tangential: normal to the crank and to x. (Along x it would
        // be the rod's own axis once a turn.) The start's tangent instead of the chord, as in the paper, is the same
        // model: `joint root = clamp(beam.start, rod);`. But then all of the rod follows the quick bending of its first
        // element, and the integrators take up to three times as many steps (docs/measurements.md).
        joint root = pin(beam.start, rod);
        joint chord_y = hold(beam.end.y);
        joint chord_z = hold(beam.end.z);
        constraint cross_axis = dot([0, cos(theta(t)), sin(theta(t))], rod.ez);
        // Spherical joint on a slider that moves along x.
        fixture slider on beam.end { mass = slider_mass; }
        constraint guide_y = beam.end.in(inertial).y;
        constraint guide_z = beam.end.in(inertial).z;

        /// Position of the slider.
        output x_slider = beam.end.in(inertial).x;
        /// The same less that of a rigid rod.
        output dx = beam.end.in(inertial).x - sqrt(length^2 - crank^2 * (2 - 2 * cos(theta(t))));
        /// Distance of the rod's middle from its chord's.
        output mid = norm(beam.at(length / 2).position - 0.5 * (beam.start.position + beam.end.position));

        run { t_end = 2.5 s; every = 0.01 s; }
    }
}
