//! Spin-up manoeuvre of a flexible beam in space (Ren & Yang 2021, section 4.1.1).

rncf::model! {
    /// Spin-up manoeuvre of a flexible beam in space (Ren & Yang 2021, section 4.1.1).
    pub model SpinUpSpatial {
        /// Steady angular velocity.
        param omega_s = 4 rad/s;
        /// Time to reach it.
        param T_s = 15 s;
        /// Number of elements.
        param elements: count = 6;

        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; poisson = 0.3; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }

        /// Angle of the hub, Eq. (22).
        motion theta(t) =
            if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
            else { omega_s * (t - T_s/2) };
        frame hub = rotating(axis = z, angle = theta(t));

        body beam in hub {
            spatial;
            line from [0, 0, 0] m to [8, 0, 0] m;
            mesh elements * cable(tube, aluminium);
        }
        joint root = clamp(beam.start, hub);

        /// Elongation of the tip in the frame.
        output u = beam.end.x - 8 m;
        /// Deflection of the tip in the plane of rotation.
        output v = beam.end.y;
        /// Deflection of the tip along the axis of rotation; zero by symmetry.
        output w = beam.end.z;

        run { t_end = 20 s; every = 0.05 s; }
    }
}
