//! Spin-up of a curved beam (Ren & Yang 2021, section 4.1.2): upwind.

rncf::model! {
    /// Spin-up of a beam that is curved towards its motion (Ren & Yang 2021, section 4.1.2).
    pub model CurvedUpwind {
        /// Steady angular velocity.
        param omega_s = 4 rad/s;
        /// Time to reach it.
        param T_s = 15 s;
        /// Number of elements.
        param elements: count = 8;

        const bend = 16 m;
        const turn = 0.5 rad;

        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
        section tube {
            area = 0.7299 cm^2;
            second_moment = 0.8215 cm^4;
            shear_factor = 0.53;
        }

        /// Angle of the hub, Eq. (22).
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));

        body beam in hub {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius bend angle turn;
            mesh elements * beam(tube, aluminium);
        }
        joint root = clamp(beam.start, hub);

        /// Deflection of the tip from its stress-free place along x of the hub, which is the tangent at the root.
        output u = beam.end.x - bend * sin(turn);
        /// The same along y, in the plane of rotation.
        output v = beam.end.y - bend * (1 - cos(turn));
        /// The same along z, the axis of rotation.
        output w = 0 m;

        run { t_end = 20 s; every = 0.05 s; }
    }
}
